/* search.h: walk.h in each dialect of eight.h: bvh8_closest_0 in plain C, _1 for AVX2, _2 for
 * AVX-512. A function that is compiled for a target may use its instructions, and may be called
 * only where the machine has them: bvh8.h chooses.
 */
#ifndef WIDE_SEARCH_H
#define WIDE_SEARCH_H

#include "state8.h"

#define EIGHT_PASTE(name, number) name##_##number
#define EIGHT_NAME(name, number) EIGHT_PASTE(name, number)

#ifdef __clang__
#define EIGHT_TARGET_2(list) _Pragma(#list)
#define EIGHT_TARGET_1(names) \
    EIGHT_TARGET_2(clang attribute push(__attribute__((target(names))), apply_to = function))
#define EIGHT_TARGET_END _Pragma("clang attribute pop")
#else
#define EIGHT_TARGET_2(list) _Pragma(#list)
#define EIGHT_TARGET_1(names) _Pragma("GCC push_options") EIGHT_TARGET_2(GCC target(names))
#define EIGHT_TARGET_END _Pragma("GCC pop_options")
#endif

#define EIGHT_DIALECT 0
#include "walk.h"

#if EIGHT_X86
EIGHT_TARGET_1("avx2,fma")
#define EIGHT_DIALECT 1
#include "walk.h"
EIGHT_TARGET_END

EIGHT_TARGET_1("avx2,fma,avx512f,avx512vl,avx512dq")
#define EIGHT_DIALECT 2
#include "walk.h"
EIGHT_TARGET_END
#endif
#endif
