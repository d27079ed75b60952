/* Refuses to be compiled in ways that give other bits: see docs/determinism.md. */
#ifndef SKV_BASE_IEEE_H
#define SKV_BASE_IEEE_H

#include <float.h>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||     \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "-ffast-math and its parts change the results; compile the library without them"
#endif

/* Not so on 32-bit x86 without -mfpmath=sse: its registers are wider than float and double. 16 is
 * 0 with half precision besides. */
_Static_assert(FLT_EVAL_METHOD == 0 || FLT_EVAL_METHOD == 16,
               "operations must be rounded to their own type");
_Static_assert(FLT_RADIX == 2 && FLT_MANT_DIG == 24 && DBL_MANT_DIG == 53,
               "float and double must be those of IEEE 754");

#endif
