/* tally.h: sums that do not depend on the order of adding.
 *
 *   floating point: (1e16 + 1) - 1e16 = 0,  (1e16 - 1e16) + 1 = 1: who adds first matters, so a
 *   picture put together from parts would differ from the same picture made in one go.
 *   Integers: a + b + c is one number, whoever adds what to what.
 *
 *        |<-- high, 64 bits -->|<-- low, 64 bits -->|      value = (high 2^64 + low) 2^-62, two's
 *                            2^2.                          complement
 *   tally t = {0, 0};
 *   tally_add(&t, x);           rounds x towards 0, to a multiple of 2^-62; then exact
 *   tally_join(&t, &other);     exact: any split, any order, the same bits
 *   double s = tally_sum(&t);   the nearest double, nearly (two roundings)
 *
 * x in (-2^44, 2^44) [about 2e13]; beyond, it is cut to that. NaN: false, and nothing is added.
 * 2^20 samples of 2^44, the most that --samples takes, are a sum of 2^64; 2^21 overflow. What
 * rounding takes from a mean is below 2^-62, 2e-19.
 */
#ifndef MONTE_CARLO_TALLY_H
#define MONTE_CARLO_TALLY_H

#include "../../common/vec3.h"
#include <stdint.h>

typedef struct { uint64_t low; int64_t high; } tally;  /* (high 2^64 + low) 2^-62 */

/* ---------------------------------------------------------------------------------------------- */

static inline void tally_join(tally *to, const tally *t)
{
    uint64_t low = to->low + t->low;
    /* through uint64_t: wraps where int64_t would be undefined */
    to->high = (int64_t)((uint64_t)to->high + (uint64_t)t->high + (low < t->low));
    to->low = low;
}

/* |x| = 4 high + low 2^-62, 0 <= low 2^-62 < 4: floor, difference and product are exact; what the
 * cast to an integer cuts off is the rounding. */
static inline bool tally_add(tally *to, double x)
{
    const double most = 0x1p44;
    if (isnan(x)) return false;
    double size = fabs(x) > most ? most : fabs(x), high = floor(size * 0.25);
    tally t = {(uint64_t)((size - 4 * high) * 0x1p62), (int64_t)high};
    if (x < 0) t = (tally){~t.low + 1, ~t.high + (t.low == 0)};
    tally_join(to, &t);
    return true;
}

static inline double tally_sum(const tally *t)
{
    uint64_t low = t->low, high = (uint64_t)t->high;
    if (t->high < 0) low = ~low + 1, high = ~high + (low == 0);  /* |t|: high and low agree */
    double size = (double)high * 4 + (double)low * 0x1p-62;
    return t->high < 0 ? -size : size;
}

#endif
