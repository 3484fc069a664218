/* mine.h: a reader's own box test: `make mine-09 MINE=my.h` compiles with MINE, the file's
 * name. Without it the test of ../mine.h is compiled, and appears in no table.
 *
 *   aabb_mine                         1 with MINE, else 0: so many rows more
 *   aabb_prove(hit, "mine", n, out)   n easy boxes: hit by 1 unit of hundreds at least, or missed
 *                                     by as much, along no axis; whole numbers know. The first that
 *                                     is wrong goes to `out`; false if there is one
 *
 * What is lost in planes, along axes, at corners and of flat boxes is no matter of right or wrong
 * here: the tables count that.
 */
#ifndef AABB_LAB_MINE_H
#define AABB_LAB_MINE_H

#include "../../01_ray/trials/wrong.h"
#include "exact.h"

#ifdef MINE
#include MINE
enum { aabb_mine = 1 };
#else
#include "../mine.h"
enum { aabb_mine = 0 };
#endif

/* ---------------------------------------------------------------------------------------------- */

static inline bool aabb_prove(bool (*X_hit)(aabb b, ray r, real *t_enter), const char *name,
                              size_t n, FILE *out)
{
    const real most = real_is_float ? (real)1e-3 : (real)1e-9;
    size_t asked = 0, hits = 0;
    for (size_t i = 0; i < n; i++) {
        aabb_trial c = aabb_trial_of(TRIAL_ANY, 41, i);
        aabb inner = first_aabb_pad(c.b, -1);
        bool met = !aabb_is_empty(inner) && exact_aabb(inner, c.r).hit;
        if (!met && exact_aabb(first_aabb_pad(c.b, 1), c.r).hit) continue;
        if (c.r.d.x == 0 || c.r.d.y == 0 || c.r.d.z == 0) continue;  /* 0 / 0, -0.0 */
        aabb_fraction exact = exact_aabb(c.b, c.r).enter;
        real t = 0, enter = (real)((double)exact.n / (double)exact.d);
        bool said = X_hit(c.b, c.r, &t);
        asked++, hits += met;
        bool same_t = t == enter || fabs(t - enter) <= most * (1 + fabs(enter));
        if (met == said && (!met || same_t)) continue;
        fprintf(out, "%s: of lo = (%g, %g, %g), hi = (%g, %g, %g); t is t_enter\n", name,
                (double)c.b.lo.x, (double)c.b.lo.y, (double)c.b.lo.z, (double)c.b.hi.x,
                (double)c.b.hi.y, (double)c.b.hi.z);
        wrong_report(out, name, c.r, met ? (hit){enter, 0, 0, 0} : hit_none,
                     said ? (hit){t, 0, 0, 0} : hit_none);
        return false;
    }
    fprintf(out, "%s: right for %zu easy boxes, %zu of them hit\n", name, asked, hits);
    return true;
}

#endif
