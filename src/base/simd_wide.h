/* Eights of floats side by side in one register: two where it holds sixteen floats (AVX-512), else
 * one.
 *
 * Invariant: what is done to them is done to each eight as base/simd.h does it, so how many there
 * are makes no difference to the bits.
 */
#ifndef SKV_BASE_SIMD_WIDE_H
#define SKV_BASE_SIMD_WIDE_H

#include "base/simd.h"

#if defined(V8_HAS_SIXTEEN)

#define WIDE_EIGHTS 2
typedef __m512 wide;

V8_INLINE wide wide_of(v8 first, v8 second)
{
    return _mm512_insertf32x8(_mm512_castps256_ps512(first), second, 1);
}

/* The same eight, as often as there is room. */
V8_INLINE wide wide_each(v8 a)
{
    return _mm512_broadcast_f32x8(a);
}

V8_INLINE v8 wide_eight(wide a, int which)
{
    return which ? _mm512_extractf32x8_ps(a, 1) : _mm512_castps512_ps256(a);
}

V8_INLINE wide wide_load(const float *p)
{
    return _mm512_loadu_ps(p);
}

V8_INLINE void wide_store(float *p, wide a)
{
    _mm512_storeu_ps(p, a);
}

V8_INLINE wide wide_set(float a)
{
    return _mm512_set1_ps(a);
}

V8_INLINE wide wide_add(wide a, wide b)
{
    return _mm512_add_ps(a, b);
}

V8_INLINE wide wide_sub(wide a, wide b)
{
    return _mm512_sub_ps(a, b);
}

V8_INLINE wide wide_mul(wide a, wide b)
{
    return _mm512_mul_ps(a, b);
}

V8_INLINE wide wide_div(wide a, wide b)
{
    return _mm512_div_ps(a, b);
}

V8_INLINE wide wide_sqrt(wide a)
{
    return _mm512_sqrt_ps(a);
}

V8_INLINE wide wide_max(wide a, wide b)
{
    return _mm512_max_ps(a, b);
}

V8_INLINE wide wide_min(wide a, wide b)
{
    return _mm512_min_ps(a, b);
}

V8_INLINE wide wide_and(wide a, wide b)
{
    return _mm512_and_ps(a, b);
}

#else

#define WIDE_EIGHTS 1
typedef v8 wide;

V8_INLINE wide wide_each(v8 a)
{
    return a;
}

V8_INLINE v8 wide_eight(wide a, int which)
{
    (void)which;
    return a;
}

#define wide_load  v8_load
#define wide_store v8_store
#define wide_set   v8_set
#define wide_add   v8_add
#define wide_sub   v8_sub
#define wide_mul   v8_mul
#define wide_div   v8_div
#define wide_sqrt  v8_sqrt
#define wide_max   v8_max
#define wide_min   v8_min
#define wide_and   v8_and

#endif

/* Every eight filled with one number: p[0], and p[apart] in the second. */
V8_INLINE wide wide_spread(const float *p, int apart)
{
#if WIDE_EIGHTS == 2
    return wide_of(v8_set(p[0]), v8_set(p[apart]));
#else
    (void)apart;
    return v8_set(p[0]);
#endif
}

/* v8_mask_from, of `first` in the first eight and of `first + apart` in the second. */
V8_INLINE wide wide_mask_from(int first, int apart)
{
#if WIDE_EIGHTS == 2
    return wide_of(v8_mask_from(first), v8_mask_from(first + apart));
#else
    (void)apart;
    return v8_mask_from(first);
#endif
}

#endif
