/* Eight floats at a time, the same bits on every machine.
 *
 * The logical width is always 8: one 8-wide vector with AVX2 and AVX-512, a pair of 4-wide ones
 * with SSE2, NEON and WebAssembly, an array in scalar code. Every operation is a lane's own IEEE
 * operation (square root and division exact, nothing contracted), and sums over lanes have one
 * fixed order, so all of them give the same results. Which one is compiled follows from the
 * compiler's flags; the scalar one is asked for with SKV_SIMD_SCALAR.
 */
#ifndef SKV_BASE_SIMD_H
#define SKV_BASE_SIMD_H

#include "base/ieee.h"

#include <stdint.h>

#define V8_INLINE static inline __attribute__((always_inline))

#if !defined(SKV_SIMD_SCALAR) && defined(__AVX2__)

#include <immintrin.h>
typedef __m256 v8;
/* AVX-512 computes eights as AVX2 does, and two of them at once: base/simd_wide.h. */
#if defined(__AVX512DQ__)
#define V8_HAS_SIXTEEN
#define V8_NAME "avx512"
#else
#define V8_NAME "avx2"
#endif

V8_INLINE v8 v8_load(const float *p)
{
    return _mm256_loadu_ps(p);
}

V8_INLINE void v8_store(float *p, v8 a)
{
    _mm256_storeu_ps(p, a);
}

V8_INLINE v8 v8_set(float a)
{
    return _mm256_set1_ps(a);
}

V8_INLINE v8 v8_add(v8 a, v8 b)
{
    return _mm256_add_ps(a, b);
}

V8_INLINE v8 v8_sub(v8 a, v8 b)
{
    return _mm256_sub_ps(a, b);
}

V8_INLINE v8 v8_mul(v8 a, v8 b)
{
    return _mm256_mul_ps(a, b);
}

V8_INLINE v8 v8_div(v8 a, v8 b)
{
    return _mm256_div_ps(a, b);
}

V8_INLINE v8 v8_sqrt(v8 a)
{
    return _mm256_sqrt_ps(a);
}

/* a > b ? a : b; so b where a lane of a is NaN. */
V8_INLINE v8 v8_max(v8 a, v8 b)
{
    return _mm256_max_ps(a, b);
}

V8_INLINE v8 v8_min(v8 a, v8 b)
{
    return _mm256_min_ps(a, b);
}

V8_INLINE v8 v8_and(v8 a, v8 b)
{
    return _mm256_and_ps(a, b);
}

#elif !defined(SKV_SIMD_SCALAR) &&                                                                 \
    (defined(__SSE2__) || defined(__aarch64__) || defined(__wasm_simd128__))

/* Besides each lane's own operations: ANY_BELOW, whether a lane of a is below b's or one of c below
 * d's; MIX, the lower or higher two lanes of both, in turn; JOIN, the same, a's before b's. */
#if defined(__SSE2__)
#include <emmintrin.h>
#define V8_NAME  "sse2"
typedef __m128 v4;
#define V4_LOAD  _mm_loadu_ps
#define V4_STORE _mm_storeu_ps
#define V4_SET   _mm_set1_ps
#define V4_SQRT  _mm_sqrt_ps
#define V4_MAX   _mm_max_ps
#define V4_MIN   _mm_min_ps
#define V4_AND   _mm_and_ps
#define V4_ANY_BELOW(a, b, c, d)                                                                   \
    (_mm_movemask_ps(_mm_cmplt_ps(a, b)) | _mm_movemask_ps(_mm_cmplt_ps(c, d)))
#define V4_MIX_LOW         _mm_unpacklo_ps
#define V4_MIX_HIGH        _mm_unpackhi_ps
#define V4_JOIN_LOW        _mm_movelh_ps
#define V4_JOIN_HIGH(a, b) _mm_movehl_ps(b, a)
#elif defined(__aarch64__)
#include <arm_neon.h>
#define V8_NAME      "neon"
typedef float32x4_t v4;
#define V4_LOAD      vld1q_f32
#define V4_STORE     vst1q_f32
#define V4_SET       vdupq_n_f32
#define V4_SQRT      vsqrtq_f32
#define V4_MAX(a, b) vbslq_f32(vcgtq_f32(a, b), a, b)
#define V4_MIN(a, b) vbslq_f32(vcltq_f32(a, b), a, b)
#define V4_AND(a, b)                                                                               \
    vreinterpretq_f32_u32(vandq_u32(vreinterpretq_u32_f32(a), vreinterpretq_u32_f32(b)))
#define V4_ANY_BELOW(a, b, c, d) (vmaxvq_u32(vorrq_u32(vcltq_f32(a, b), vcltq_f32(c, d))) != 0)
#define V4_MIX_LOW               vzip1q_f32
#define V4_MIX_HIGH              vzip2q_f32
#define V4_JOIN_LOW(a, b)        vcombine_f32(vget_low_f32(a), vget_low_f32(b))
#define V4_JOIN_HIGH(a, b)       vcombine_f32(vget_high_f32(a), vget_high_f32(b))
#else
#include <wasm_simd128.h>
#define V8_NAME      "wasm"
typedef v128_t v4;
#define V4_LOAD      wasm_v128_load
#define V4_STORE     wasm_v128_store
#define V4_SET       wasm_f32x4_splat
#define V4_SQRT      wasm_f32x4_sqrt
#define V4_MAX(a, b) wasm_f32x4_pmax(b, a)
#define V4_MIN(a, b) wasm_f32x4_pmin(b, a)
#define V4_AND       wasm_v128_and
#define V4_ANY_BELOW(a, b, c, d)                                                                   \
    wasm_v128_any_true(wasm_v128_or(wasm_f32x4_lt(a, b), wasm_f32x4_lt(c, d)))
#define V4_MIX_LOW(a, b)   wasm_i32x4_shuffle(a, b, 0, 4, 1, 5)
#define V4_MIX_HIGH(a, b)  wasm_i32x4_shuffle(a, b, 2, 6, 3, 7)
#define V4_JOIN_LOW(a, b)  wasm_i32x4_shuffle(a, b, 0, 1, 4, 5)
#define V4_JOIN_HIGH(a, b) wasm_i32x4_shuffle(a, b, 2, 3, 6, 7)
#endif

#if defined(__wasm_simd128__)
#define V4_ADD wasm_f32x4_add
#define V4_SUB wasm_f32x4_sub
#define V4_MUL wasm_f32x4_mul
#define V4_DIV wasm_f32x4_div
#else
#define V4_ADD(a, b) ((a) + (b))
#define V4_SUB(a, b) ((a) - (b))
#define V4_MUL(a, b) ((a) * (b))
#define V4_DIV(a, b) ((a) / (b))
#endif

/* An explicit pair: compilers split an 8-wide vector type badly. */
#define V8_IS_PAIR
typedef struct v8 {
    v4 lo, hi;
} v8;

V8_INLINE v8 v8_load(const float *p)
{
    return (v8){V4_LOAD(p), V4_LOAD(p + 4)};
}

V8_INLINE void v8_store(float *p, v8 a)
{
    V4_STORE(p, a.lo);
    V4_STORE(p + 4, a.hi);
}

V8_INLINE v8 v8_set(float a)
{
    return (v8){V4_SET(a), V4_SET(a)};
}

V8_INLINE v8 v8_add(v8 a, v8 b)
{
    return (v8){V4_ADD(a.lo, b.lo), V4_ADD(a.hi, b.hi)};
}

V8_INLINE v8 v8_sub(v8 a, v8 b)
{
    return (v8){V4_SUB(a.lo, b.lo), V4_SUB(a.hi, b.hi)};
}

V8_INLINE v8 v8_mul(v8 a, v8 b)
{
    return (v8){V4_MUL(a.lo, b.lo), V4_MUL(a.hi, b.hi)};
}

V8_INLINE v8 v8_div(v8 a, v8 b)
{
    return (v8){V4_DIV(a.lo, b.lo), V4_DIV(a.hi, b.hi)};
}

V8_INLINE v8 v8_sqrt(v8 a)
{
    return (v8){V4_SQRT(a.lo), V4_SQRT(a.hi)};
}

V8_INLINE v8 v8_max(v8 a, v8 b)
{
    return (v8){V4_MAX(a.lo, b.lo), V4_MAX(a.hi, b.hi)};
}

V8_INLINE v8 v8_min(v8 a, v8 b)
{
    return (v8){V4_MIN(a.lo, b.lo), V4_MIN(a.hi, b.hi)};
}

V8_INLINE v8 v8_and(v8 a, v8 b)
{
    return (v8){V4_AND(a.lo, b.lo), V4_AND(a.hi, b.hi)};
}

#else

#include <string.h>

typedef struct v8 {
    float lane[8];
} v8;
#define V8_NAME "scalar"
#define V8_LANES(result, expression)                                                               \
    v8 result;                                                                                     \
    for (int l = 0; l < 8; l++)                                                                    \
        result.lane[l] = (expression);                                                             \
    return result

V8_INLINE v8 v8_load(const float *p)
{
    V8_LANES(r, p[l]);
}

V8_INLINE void v8_store(float *p, v8 a)
{
    for (int l = 0; l < 8; l++)
        p[l] = a.lane[l];
}

V8_INLINE v8 v8_set(float a)
{
    V8_LANES(r, a);
}

V8_INLINE v8 v8_add(v8 a, v8 b)
{
    V8_LANES(r, a.lane[l] + b.lane[l]);
}

V8_INLINE v8 v8_sub(v8 a, v8 b)
{
    V8_LANES(r, a.lane[l] - b.lane[l]);
}

V8_INLINE v8 v8_mul(v8 a, v8 b)
{
    V8_LANES(r, a.lane[l] * b.lane[l]);
}

V8_INLINE v8 v8_div(v8 a, v8 b)
{
    V8_LANES(r, a.lane[l] / b.lane[l]);
}

V8_INLINE v8 v8_sqrt(v8 a)
{
    V8_LANES(r, __builtin_sqrtf(a.lane[l]));
}

V8_INLINE v8 v8_max(v8 a, v8 b)
{
    V8_LANES(r, a.lane[l] > b.lane[l] ? a.lane[l] : b.lane[l]);
}

V8_INLINE v8 v8_min(v8 a, v8 b)
{
    V8_LANES(r, a.lane[l] < b.lane[l] ? a.lane[l] : b.lane[l]);
}

V8_INLINE v8 v8_and(v8 a, v8 b)
{
    v8 r;
    for (int l = 0; l < 8; l++) {
        uint32_t x, y;
        memcpy(&x, &a.lane[l], 4);
        memcpy(&y, &b.lane[l], 4);
        x &= y;
        memcpy(&r.lane[l], &x, 4);
    }
    return r;
}

#endif

/* True if a lane of a is below that of b. */
V8_INLINE int v8_any_below(v8 a, v8 b)
{
#if !defined(SKV_SIMD_SCALAR) && defined(__AVX2__)
    return _mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ));
#elif defined(V4_ANY_BELOW)
    return V4_ANY_BELOW(a.lo, b.lo, a.hi, b.hi);
#else
    float x[8], y[8];
    int below = 0;
    v8_store(x, a);
    v8_store(y, b);
    for (int l = 0; l < 8; l++)
        below |= x[l] < y[l];
    return below;
#endif
}

/* All bits set in lanes first..7, none below: for v8_and. 0 <= first <= 8. */
V8_INLINE v8 v8_mask_from(int first)
{
    static const uint32_t ramp[16] = {0,   0,   0,   0,   0,   0,   0,   0,
                                      ~0u, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u};
    return v8_load((const float *)(const void *)(ramp + 8 - first));
}

/* Sum of the lanes as ((0+4)+(2+6)) + ((1+5)+(3+7)): the order every instruction set shares. */
V8_INLINE float v8_sum(v8 a)
{
    float lane[8];
    v8_store(lane, a);
    return ((lane[0] + lane[4]) + (lane[2] + lane[6])) +
           ((lane[1] + lane[5]) + (lane[3] + lane[7]));
}

/* Four sums at once into out[0..3], each in the order of v8_sum. */
V8_INLINE void v8_sum4(v8 a, v8 b, v8 c, v8 d, float out[4])
{
#if !defined(SKV_SIMD_SCALAR) && defined(__AVX2__)
    /* Fold 4..7 onto 0..3, then transpose while adding. */
    __m256 ac =
        _mm256_add_ps(_mm256_permute2f128_ps(a, c, 0x20), _mm256_permute2f128_ps(a, c, 0x31));
    __m256 bd =
        _mm256_add_ps(_mm256_permute2f128_ps(b, d, 0x20), _mm256_permute2f128_ps(b, d, 0x31));
    __m256 low = _mm256_unpacklo_ps(ac, bd), high = _mm256_unpackhi_ps(ac, bd);
    __m256 sum = _mm256_add_ps(low, high); /* a0+a2 b0+b2 a1+a3 b1+b3 | the same of c, d */
    __m256 other = _mm256_permute_ps(sum, 0x4e);
    sum = _mm256_add_ps(sum, other);
    _mm_storel_pi((__m64 *)(void *)out, _mm256_castps256_ps128(sum));
    _mm_storel_pi((__m64 *)(void *)(out + 2), _mm256_extractf128_ps(sum, 1));
#elif defined(V4_MIX_LOW)
    v4 a4 = V4_ADD(a.lo, a.hi), b4 = V4_ADD(b.lo, b.hi);
    v4 c4 = V4_ADD(c.lo, c.hi), d4 = V4_ADD(d.lo, d.hi);
    v4 ab = V4_ADD(V4_MIX_LOW(a4, b4), V4_MIX_HIGH(a4, b4));
    v4 cd = V4_ADD(V4_MIX_LOW(c4, d4), V4_MIX_HIGH(c4, d4));
    V4_STORE(out, V4_ADD(V4_JOIN_LOW(ab, cd), V4_JOIN_HIGH(ab, cd)));
#else
    out[0] = v8_sum(a);
    out[1] = v8_sum(b);
    out[2] = v8_sum(c);
    out[3] = v8_sum(d);
#endif
}

#endif
