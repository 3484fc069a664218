/* dialects.h: compiles the file EIGHT_FILE once in each dialect of eight.h. No guard. */
#define EIGHT_DIALECT 0
#include EIGHT_FILE
#undef EIGHT_DIALECT
#if EIGHT_X86
#define EIGHT_DIALECT 1
EIGHT_TARGET("avx2,fma")
#include EIGHT_FILE
EIGHT_TARGET_END
#undef EIGHT_DIALECT
#define EIGHT_DIALECT 2
EIGHT_TARGET("avx2,fma,avx512f,avx512vl,avx512dq")
#include EIGHT_FILE
EIGHT_TARGET_END
#undef EIGHT_DIALECT
#endif
#undef EIGHT_FILE
