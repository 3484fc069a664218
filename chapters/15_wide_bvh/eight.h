/* eight.h: eight floats at a time (单指令多数据, SIMD), in three dialects.
 *
 *   eight           eight floats; + - * / work lane by lane, as on one number (GNU vectors)
 *   eight_best()    the best dialect of this machine
 *
 *   what the operators do not say           plain C        AVX2         AVX-512
 *   EIGHT_ALL: x in all lanes               one            one          one
 *   EIGHT_MIN, EIGHT_MAX                    four           one          one
 *   EIGHT_FMA: a b + c                      two roundings  one          one
 *   EIGHT_FAR: the larger of |a|, |b|       six            three        one
 *   EIGHT_LE: eight bits, where a <= b      a loop         two          one
 *
 * Nothing else differs, so the search is written once: search.h includes walk.h under each dialect,
 * and dialect.h defines these six. Plain C is for every processor: on NEON a compiler makes two
 * instructions of four lanes of each. Where a lane is NaN, MIN and MAX give b, and a <= b is false,
 * in every dialect.
 */
#ifndef WIDE_EIGHT_H
#define WIDE_EIGHT_H

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

/* ---------------------------------------------------------------------------------------------- */

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
