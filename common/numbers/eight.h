/* eight.h: eight floats at a time (单指令多数据, SIMD), in three dialects.
 *
 *   eight           eight floats; + - * / work lane by lane, as on one number (GNU vectors)
 *   eight_at        the same, wherever floats may lie in memory
 *   floats4         four of them, of three axes: floats4_of(v), _within(a, most), _abs(a)
 *   doubles4        four doubles
 *   eight_best()    the best dialect of this machine
 *
 *   what the operators do not say                plain C    AVX2, AVX-512    instructions
 *   EIGHT_MIN(a, b), EIGHT_MAX(a, b)             one           one
 *   EIGHT_FMA(a, b, c): a b + c                  one or two    one
 *   EIGHT_LE(a, b): lanes of ones where a <= b   one           one
 *   EIGHT_BITS(lanes): a set, of their signs     six           one
 *   EIGHT_LE_BITS(a, b): both                    seven         two; one
 *
 * An eight_set has a bit a lane, EIGHT_STEP apart: in plain C one in each byte. EIGHT_FIRST(set):
 * its lowest lane; EIGHT_COUNT(set): how many. EIGHT_ROW(p, n): the eight floats n bytes on.
 * LANES: eight floats, or with AVX-512 sixteen: LANES_N of them, for rows of any length. LANES_MIN,
 * _MAX, _FMA, _ABS, _ALL likewise; LANES_WHOLE, LANES_ALL_WHOLE of whole numbers.
 * What is written with these is compiled in each dialect by dialects.h: there EIGHT(name) is name_0
 * in plain C, name_1 for AVX2, name_2 for AVX-512, to be called only where the machine has its
 * instructions; EIGHT_CALL(dialect, name, ..) calls one of the three. Plain C compiles for every
 * processor, and is quick where registers hold eight floats (x86-64-v3 and up). A lane that is NaN:
 * MIN and MAX give b, LE none.
 */
#ifndef EIGHT_H
#define EIGHT_H

#include "../vec3.h"
#include <stdint.h>
#include <string.h>

typedef float eight __attribute__((vector_size(32), may_alias));
typedef float eight_at __attribute__((vector_size(32), may_alias, aligned(4)));
typedef int32_t eight_whole __attribute__((vector_size(32)));
typedef uint32_t eight_count __attribute__((vector_size(32)));
typedef uint64_t eight_set;
typedef float sixteen __attribute__((vector_size(64), may_alias));
typedef int32_t sixteen_whole __attribute__((vector_size(64)));
typedef uint32_t sixteen_count __attribute__((vector_size(64)));
typedef eight lanes_0, lanes_1;
typedef eight_whole lanes_whole_0, lanes_whole_1;
typedef eight_count lanes_count_0, lanes_count_1;
typedef sixteen lanes_2;
typedef sixteen_whole lanes_whole_2;
typedef sixteen_count lanes_count_2;
typedef float floats4 __attribute__((vector_size(16)));
typedef double doubles4 __attribute__((vector_size(32)));
typedef int32_t whole4 __attribute__((vector_size(16)));
typedef int8_t bytes16 __attribute__((vector_size(16)));
typedef enum { EIGHT_PLAIN, EIGHT_AVX2, EIGHT_AVX512, eight_dialects } eight_dialect;

#if defined __x86_64__ && defined __GNUC__
#define EIGHT_X86 1
#define EIGHT_CALL(dialect, name, ...)                         \
    ((dialect) == EIGHT_AVX512 ? name##_2(__VA_ARGS__)         \
     : (dialect) == EIGHT_AVX2 ? name##_1(__VA_ARGS__) : name##_0(__VA_ARGS__))
/* gcc's own names: to read the header of all instructions takes it half a second. clang's names
 * come and go, and it reads faster. */
#ifdef __clang__
#include <immintrin.h>
#define EIGHT_ONE(gcc, header) header
#define LANES_ONE(gcc, header, with, plain) ((sixteen)header plain)
#define EIGHT_LE_MASK(a, b) _mm256_cmp_ps_mask(a, b, _CMP_LE_OQ)
#else
#define EIGHT_ONE(gcc, header) __builtin_ia32_##gcc
#define LANES_ONE(gcc, header, with, plain) ((sixteen)__builtin_ia32_##gcc with)
#define EIGHT_LE_MASK(a, b) __builtin_ia32_cmpps256_mask(a, b, 18, 255)
#endif
#else
#define EIGHT_X86 0
#define EIGHT_CALL(dialect, name, ...) name##_0(__VA_ARGS__)
#endif
#define EIGHT_SAY(fast, plain) EIGHT(EIGHT_SAY)(fast, plain)  /* no dialect sees another's */
#define EIGHT_SAY_0(fast, plain) (plain)
#define EIGHT_SAY_1(fast, plain) (fast)
#define EIGHT_SAY_2(fast, plain) (fast)
#define EIGHT_MIN(a, b) \
    EIGHT_SAY(EIGHT_ONE(minps256, _mm256_min_ps)(a, b), EIGHT_LOOP(eight_min, a, b))
#define EIGHT_MAX(a, b) \
    EIGHT_SAY(EIGHT_ONE(maxps256, _mm256_max_ps)(a, b), EIGHT_LOOP(eight_max, a, b))
#define EIGHT_FMA(a, b, c) \
    EIGHT_SAY(EIGHT_ONE(vfmaddps256, _mm256_fmadd_ps)(a, b, c), EIGHT_LOOP(eight_fma, a, b, c))
#define EIGHT_LE(a, b) /* 18: false for a NaN */ \
    EIGHT_SAY((eight_whole)EIGHT_ONE(cmpps256, _mm256_cmp_ps)(a, b, 18), (eight_whole)((a) <= (b)))
#define EIGHT_BITS(lanes) \
    EIGHT_SAY((eight_set)EIGHT_ONE(movmskps256, _mm256_movemask_ps)((eight)(lanes)), \
              eight_bits((const eight_whole[]){lanes}))
#define EIGHT_LE_BITS(a, b) EIGHT(EIGHT_LE_BITS)(a, b)
#define EIGHT_LE_BITS_0(a, b) EIGHT_BITS(EIGHT_LE(a, b))
#define EIGHT_LE_BITS_1(a, b) EIGHT_BITS(EIGHT_LE(a, b))
#define EIGHT_LE_BITS_2(a, b) ((eight_set)(uint8_t)EIGHT_LE_MASK(a, b))
#define EIGHT_FAR(a, b) EIGHT_MAX(EIGHT_ABS(a), EIGHT_ABS(b))
#define EIGHT_ABS(a)                                                             \
    EIGHT_SAY(EIGHT_ONE(andnps256, _mm256_andnot_ps)(EIGHT_ALL(-0.0f), a),       \
              (eight)((eight_whole)(a) & INT32_MAX))
#define EIGHT_STEP (EIGHT_DIALECT ? 1 : 8)
#define EIGHT_FIRST(set) (__builtin_ctzll(set) / EIGHT_STEP)
#define EIGHT_COUNT(set) ((size_t)__builtin_popcountll(set))
#define EIGHT_ROW(rows, bytes) (*(const eight *)((const char *)(rows) + (bytes)))
#define EIGHT_ALL(x) ((eight){x, x, x, x, x, x, x, x})
#define LANES EIGHT(lanes)
#define LANES_WHOLE EIGHT(lanes_whole)
#define LANES_N (EIGHT_DIALECT == 2 ? 16 : 8)
#define LANES_ALL(x) EIGHT(LANES_ALL)(x)
#define LANES_ALL_0(x) EIGHT_ALL(x)
#define LANES_ALL_1(x) EIGHT_ALL(x)
#define LANES_ALL_2(x) ((sixteen){x, x, x, x, x, x, x, x, x, x, x, x, x, x, x, x})
#define LANES_ALL_WHOLE(x) ((LANES_WHOLE)LANES_ALL(0.0f) + (x))
#define LANES_ABS(a) ((LANES)((LANES_WHOLE)(a) & INT32_MAX))
#define LANES_MIN(a, b) EIGHT(LANES_MIN)(a, b)
#define LANES_MIN_0(a, b) EIGHT_MIN(a, b)
#define LANES_MIN_1(a, b) EIGHT_MIN(a, b)
#define LANES_MIN_2(a, b) LANES_ONE(minps512_mask, _mm512_min_ps, (a, b, a, -1, 4), (a, b))
#define LANES_MAX(a, b) EIGHT(LANES_MAX)(a, b)
#define LANES_MAX_0(a, b) EIGHT_MAX(a, b)
#define LANES_MAX_1(a, b) EIGHT_MAX(a, b)
#define LANES_MAX_2(a, b) LANES_ONE(maxps512_mask, _mm512_max_ps, (a, b, a, -1, 4), (a, b))
#define LANES_FMA(a, b, c) EIGHT(LANES_FMA)(a, b, c)
#define LANES_FMA_0(a, b, c) EIGHT_FMA(a, b, c)
#define LANES_FMA_1(a, b, c) EIGHT_FMA(a, b, c)
#define LANES_FMA_2(a, b, c) \
    LANES_ONE(vfmaddps512_mask, _mm512_fmadd_ps, (a, b, c, -1, 4), (a, b, c))
#define EIGHT_LOOP(name, ...) name((const eight[]){__VA_ARGS__})
#define EIGHT_UNROLL _Pragma("GCC unroll 3")
#define EIGHT_PASTE(name, number) name##_##number
#define EIGHT_NAME(name, number) EIGHT_PASTE(name, number)
#define EIGHT(name) EIGHT_NAME(name, EIGHT_DIALECT)

/* The same for a dialect. */
#define EIGHT_INLINE EIGHT_TARGET fast_inline

/* Warns that other compilers would hand over eight floats otherwise; nobody else is called. */
#pragma GCC diagnostic ignored "-Wpsabi"

/* ---------------------------------------------------------------------------------------------- */

/* Loops of one operation: gcc and clang make one instruction of each, with -O2. (A pointer: handed
 * over by value, eight floats take other ways on other processors, and compilers say so.) */
#define EIGHT_LANES(name, result)                                                   \
    fast_inline eight name(const eight *x)                                          \
    {                                                                               \
        eight out = {0};                                                            \
        for (int k = 0; k < 8; k++) { float a = x[0][k], b = x[1][k]; out[k] = result; } \
        return out;                                                                 \
    }
EIGHT_LANES(eight_min, a < b ? a : b)
EIGHT_LANES(eight_max, a > b ? a : b)
#ifdef FP_FAST_FMAF
EIGHT_LANES(eight_fma, fmaf(a, b, x[2][k]))
#else
EIGHT_LANES(eight_fma, a * b + x[2][k])
#endif

#ifdef __clang__
#define BYTES16(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#define EIGHT_SHUFFLED(a, ...) __builtin_shufflevector(a, a, __VA_ARGS__)
#else
#define BYTES16(a, b, ...) __builtin_shuffle(a, b, (bytes16){__VA_ARGS__})
#define EIGHT_SHUFFLED(a, ...) __builtin_shuffle(a, (eight_whole){__VA_ARGS__})
#endif

/* Lane k is lane k + 4 of x, and the other way round. (Of a loop gcc makes a gather: the whole of
 * building a tree took a quarter longer.) */
fast_inline eight eight_halves_swapped(const eight *x)
{
    return EIGHT_SHUFFLED(*x, 4, 5, 6, 7, 0, 1, 2, 3);
}

/* The low bytes of the lanes, side by side: no operator makes one bit of a lane, and eight lanes to
 * eight bytes are one shuffle a half. */
fast_inline eight_set eight_bits(const eight_whole *x)
{
    bytes16 half[2];
    eight_set m;
    memcpy(half, x, sizeof half);
    half[0] = BYTES16(half[0], half[1], 0, 4, 8, 12, 16, 20, 24, 28, 0, 4, 8, 12, 16, 20, 24, 28);
    memcpy(&m, half, sizeof m);
    m = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__ ? __builtin_bswap64(m) : m;
    return m & 0x0101010101010101u;
}

/* All four at once: one by one takes five instructions more. */
fast_inline floats4 floats4_of(vec3 a)
{
    typedef real reals4 __attribute__((vector_size(4 * sizeof(real))));
    return __builtin_convertvector(((reals4){a.x, a.y, a.z, 1}), floats4);
}

fast_inline floats4 floats4_abs(floats4 a) { return (floats4)((whole4)a & INT32_MAX); }

/* From -most to most; NaN stays NaN. (For AVX-512 gcc 12 makes two instructions of each loop.) */
fast_inline floats4 floats4_within(floats4 a, float most)
{
#if EIGHT_X86
    const floats4 high = {most, most, most, most};
    return EIGHT_ONE(maxps, _mm_max_ps)(-high, EIGHT_ONE(minps, _mm_min_ps)(high, a));
#else
    for (int k = 0; k < 4; k++) a[k] = most < a[k] ? most : a[k];
    for (int k = 0; k < 4; k++) a[k] = -most > a[k] ? -most : a[k];
    return a;
#endif
}

static inline eight_dialect eight_best(void)
{
#if EIGHT_X86
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
        return EIGHT_AVX512;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return EIGHT_AVX2;
#endif
    return EIGHT_PLAIN;
}

#endif
