/* dialect.h: what the operators do not say, in the dialect EIGHT_DIALECT. Included once in each, by
 * walk.h: no guard. See eight.h.
 */
#if EIGHT_DIALECT == 0

#define EIGHT_ALL(x) ((eight){x, x, x, x, x, x, x, x})
#define EIGHT_FMA(a, b, c) ((a) * (b) + (c))
#define EIGHT_MIN(a, b) eight_choice((a) < (b), a, b)
#define EIGHT_MAX(a, b) eight_choice((a) > (b), a, b)
#define EIGHT_ABS(a) eight_choice((a) > -(a), a, -(a))
#define EIGHT_FAR(a, b) EIGHT_MAX(EIGHT_ABS(a), EIGHT_ABS(b))
#define EIGHT_LE(a, b) eight_mask((eight_whole[]){(a) <= (b)})

#define eight_choice(mask, a, b) \
    ((eight)(((mask) & (eight_whole)(a)) | (~(mask) & (eight_whole)(b))))

/* Lanes are 0 or -1: each gives its bit to the sum. (A pointer: handed over by value, eight floats
 * take other ways on other processors, and compilers say so.) */
__attribute__((always_inline))
static inline unsigned eight_mask(const eight_whole *lanes)
{
    eight_whole m = *lanes & (eight_whole){1, 2, 4, 8, 16, 32, 64, 128};
    return (unsigned)(m[0] | m[1] | m[2] | m[3] | m[4] | m[5] | m[6] | m[7]);
}

#else

#define EIGHT_ALL(x) _mm256_set1_ps(x)
#define EIGHT_FMA(a, b, c) _mm256_fmadd_ps(a, b, c)
#define EIGHT_MIN(a, b) _mm256_min_ps(a, b)
#define EIGHT_MAX(a, b) _mm256_max_ps(a, b)
#if EIGHT_DIALECT == 1
#define EIGHT_ABS(a) _mm256_andnot_ps(_mm256_set1_ps(-0.0f), a)
#define EIGHT_FAR(a, b) _mm256_max_ps(EIGHT_ABS(a), EIGHT_ABS(b))
#define EIGHT_LE(a, b) ((unsigned)_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LE_OQ)))
#else
#define EIGHT_FAR(a, b) _mm256_range_ps(a, b, 11)  /* the larger of both, without its sign */
#define EIGHT_LE(a, b) ((unsigned)_mm256_cmp_ps_mask(a, b, _CMP_LE_OQ))
#endif

#endif
