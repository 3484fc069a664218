/* dialects.h: compiles the file EIGHT_FILE, its path as seen from here, once in each dialect of
 * eight.h. No guard. */
#define EIGHT_DIALECT 0
#define EIGHT_TARGET
#include EIGHT_FILE
#undef EIGHT_DIALECT
#undef EIGHT_TARGET
#if EIGHT_X86
#define EIGHT_DIALECT 1
#define EIGHT_TARGET __attribute__((target("avx2,fma")))
#include EIGHT_FILE
#undef EIGHT_DIALECT
#undef EIGHT_TARGET
#define EIGHT_DIALECT 2
#define EIGHT_TARGET __attribute__((target("avx2,fma,avx512f,avx512vl,avx512dq")))
#include EIGHT_FILE
#undef EIGHT_DIALECT
#undef EIGHT_TARGET
#endif
#undef EIGHT_FILE
