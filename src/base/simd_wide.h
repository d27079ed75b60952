/* What one register holds: two eights of floats side by side (AVX-512), one, or a half of one.
 *
 * A `wide` is that register, an `eight_part` as much of an eight as it holds: PARTS parts of
 * PART_LEN floats make an eight, and a wide has WIDE_PARTS of them, each of another eight.
 * Invariant: what is done to them is done to each lane as base/simd.h does it, so how many there
 * are makes no difference to the bits.
 */
#ifndef SKV_BASE_SIMD_WIDE_H
#define SKV_BASE_SIMD_WIDE_H

#include "base/simd.h"

#if defined(V8_HAS_SIXTEEN)

#define WIDE_PARTS 2
#define PARTS      1
typedef __m512 wide;
typedef v8 eight_part;

V8_INLINE wide wide_of(v8 first, v8 second)
{
    return _mm512_insertf32x8(_mm512_castps256_ps512(first), second, 1);
}

/* The same part, as often as there is room. */
V8_INLINE wide wide_each(eight_part a)
{
    return _mm512_broadcast_f32x8(a);
}

V8_INLINE eight_part wide_part(wide a, int which)
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

#define WIDE_PARTS 1

#if defined(V8_IS_PAIR)

#define PARTS      2
typedef v4 wide;
typedef v4 eight_part;
#define wide_load  V4_LOAD
#define wide_store V4_STORE
#define wide_set   V4_SET
#define wide_add   V4_ADD
#define wide_sub   V4_SUB
#define wide_mul   V4_MUL
#define wide_div   V4_DIV
#define wide_sqrt  V4_SQRT
#define wide_max   V4_MAX
#define wide_min   V4_MIN
#define wide_and   V4_AND

#else

#define PARTS      1
typedef v8 wide;
typedef v8 eight_part;
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

V8_INLINE wide wide_each(eight_part a)
{
    return a;
}

V8_INLINE eight_part wide_part(wide a, int which)
{
    (void)which;
    return a;
}

#endif

#define PART_LEN (8 / PARTS)

#if PARTS == 2
#define part_load  wide_load
#define part_store wide_store
#define part_add   wide_add
#define part_sub   wide_sub
#else
#define part_load  v8_load
#define part_store v8_store
#define part_add   v8_add
#define part_sub   v8_sub
#endif

/* The eight of its first and its last part, which may be one. */
V8_INLINE v8 eight_of(eight_part first, eight_part last)
{
#if PARTS == 2
    return (v8){first, last};
#else
    (void)last;
    return first;
#endif
}

/* Every part filled with one number: p[0], and p[apart] in the second. */
V8_INLINE wide wide_spread(const float *p, int apart)
{
#if WIDE_PARTS == 2
    return wide_of(v8_set(p[0]), v8_set(p[apart]));
#else
    (void)apart;
    return wide_set(p[0]);
#endif
}

/* v8_mask_from of an eight's first part: `first` in the first one, `first + apart` in the second.
 */
V8_INLINE wide wide_mask_from(int first, int apart)
{
#if WIDE_PARTS == 2
    return wide_of(v8_mask_from(first), v8_mask_from(first + apart));
#elif PARTS == 2
    (void)apart;
    return v8_mask_from(first).lo;
#else
    (void)apart;
    return v8_mask_from(first);
#endif
}

#endif
