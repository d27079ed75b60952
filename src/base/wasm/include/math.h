/* What the core needs of <math.h> where there is no C library. All of it becomes instructions. */
#ifndef SKV_WASM_MATH_H
#define SKV_WASM_MATH_H

double sqrt(double x);
float sqrtf(float x);
double fabs(double x);
float fabsf(float x);
double ceil(double x);
double floor(double x);
float floorf(float x);

#define isfinite(x) __builtin_isfinite(x)
#define isnan(x)    __builtin_isnan(x)

#define NAN      __builtin_nanf("")
#define HUGE_VAL __builtin_huge_val()
#define INFINITY __builtin_inff()

#endif
