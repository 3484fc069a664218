/* dialect.h: what the operators do not say, in the dialect EIGHT_DIALECT. Included once in each, by
 * walk.h: no guard. See eight.h.
 */
#if EIGHT_DIALECT == 0

#define EIGHT_ALL(x) ((eight){x, x, x, x, x, x, x, x})
#ifdef FP_FAST_FMAF
#define EIGHT_FMA(a, b, c) eight_fma((const eight[]){a, b, c})
#else
#define EIGHT_FMA(a, b, c) ((a) * (b) + (c))
#endif
#define EIGHT_MIN(a, b) eight_min((const eight[]){a, b})
#define EIGHT_MAX(a, b) eight_max((const eight[]){a, b})
#define EIGHT_FAR(a, b) eight_far((const eight[]){a, b})
#define EIGHT_LE(a, b) eight_le((const eight[]){a, b})

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
