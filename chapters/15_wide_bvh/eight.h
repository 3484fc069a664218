/* eight.h: eight floats at a time (单指令多数据, SIMD), in three dialects.
 *
 *   eight           eight floats; + - * / work lane by lane, as on one number (GNU vectors)
 *   eight_best()    the best dialect of this machine
 *
 *   what the operators do not say           plain C        AVX2         AVX-512
 *   EIGHT_ALL: x in all lanes               one            one          one
 *   EIGHT_MIN, EIGHT_MAX                    one            one          one
 *   EIGHT_FMA: a b + c                      one or two     one          one
 *   EIGHT_FAR: the larger of |a|, |b|       three          three        one
 *   EIGHT_LE: eight bits, where a <= b      twelve         two          one
 *
 * Nothing else differs, so the search is written once: search.h includes walk.h under each dialect,
 * and dialect.h defines these six. Plain C compiles for every
 * processor; it is quick where registers hold eight floats (x86-64-v3 and up). With four, gcc 12
 * keeps them in memory. Where a lane is NaN, MIN and MAX give b, and a <= b is false, in every
 * dialect.
 */
#ifndef WIDE_EIGHT_H
#define WIDE_EIGHT_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#if defined __x86_64__ && defined __GNUC__
#define EIGHT_X86 1
#include <immintrin.h>
#else
#define EIGHT_X86 0
#endif

#define EIGHT_LANES __attribute__((vector_size(32)))
typedef EIGHT_LANES float eight;
typedef EIGHT_LANES int32_t eight_whole;
typedef enum { EIGHT_PLAIN, EIGHT_AVX2, EIGHT_AVX512, eight_dialects } eight_dialect;

/* Warns that other compilers would hand over eight floats otherwise; nobody else is called. */
#pragma GCC diagnostic ignored "-Wpsabi"

/* ---------------------------------------------------------------------------------------------- */

/* Loops of one operation: gcc and clang make one instruction of each, with -O2. (A pointer: handed
 * over by value, eight floats take other ways on other processors, and compilers say so.) */
#define EIGHT_LOOP(name, result)                        \
    __attribute__((always_inline))                      \
    static inline eight name(const eight *x)            \
    {                                                   \
        eight out;                                      \
        for (int k = 0; k < 8; k++) {                   \
            float a = x[0][k], b = x[1][k];             \
            out[k] = result;                            \
        }                                               \
        return out;                                     \
    }
EIGHT_LOOP(eight_min, a < b ? a : b)
EIGHT_LOOP(eight_max, a > b ? a : b)
#ifdef FP_FAST_FMAF
EIGHT_LOOP(eight_fma, fmaf(a, b, x[2][k]))
#endif
EIGHT_LOOP(eight_far, fabsf(a) > fabsf(b) ? fabsf(a) : fabsf(b))

/* A bit a lane, and then all ORed. */
__attribute__((always_inline))
static inline unsigned eight_le(const eight *x)
{
    eight_whole lane;
    uint64_t m[4];
    for (int k = 0; k < 8; k++) {
        float a = x[0][k], b = x[1][k];
        lane[k] = a <= b ? -1 : 0;
    }
    lane &= (eight_whole){1, 2, 4, 8, 16, 32, 64, 128};
    memcpy(m, &lane, sizeof m);
    m[0] |= m[1] | m[2] | m[3];
    return (unsigned)(m[0] | m[0] >> 32);
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
