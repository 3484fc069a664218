/* mine.h: a reader's own triangle test: `make mine-04 MINE=my.h` compiles with MINE, the file's
 * name. Without it the test of ../mine.h is compiled, and appears in no table.
 *
 *   triangle_mine                         1 with MINE, else 0: so many rows more
 *   triangle_prove(hit, "mine", n, out)   n easy rays: well inside or well outside of triangle and
 *                                         interval; expected is (4.8) in 30 digits. The first that
 *                                         is wrong goes to `out`; false if there is one
 *
 * Whether a test slips at edges, and what it does with needles, is no matter of right or wrong: the
 * tables count that.
 */
#ifndef TRIANGLE_LAB_MINE_H
#define TRIANGLE_LAB_MINE_H

#include "../../01_ray/trials/wrong.h"
#include "triangle_trials.h"

#ifdef MINE
#include MINE
enum { triangle_mine = 1 };
#else
#include "../mine.h"
enum { triangle_mine = 0 };
#endif

/* ---------------------------------------------------------------------------------------------- */

/* Ray i: of three two meet the triangle's plane inside of it; then the interval takes turns: all in
 * front, ending or beginning on this side of the hit or beyond it, or the hit lies behind o. */
static inline ray triangle_easy_ray(triangle tri, size_t i, random_stream *g)
{
    vec3 o = random_in_cube(g, 3);
    real u = random_between(g, 0.1, 0.4), v = random_between(g, 0.1, 0.4);
    if (i % 3 == 0) u = random_between(g, -1, 2), v = random_between(g, -1, 2);
    vec3 d = vscale(vsub(triangle_at(tri, u, v), o), 1 / random_between(g, 1, 9));
    static const real end[7][2] = {{0, (real)0.5}, {0, 10}, {10, HUGE_VAL}, {(real)0.5, HUGE_VAL},
                                   {0, HUGE_VAL}, {0, HUGE_VAL}, {0, HUGE_VAL}};
    return (ray){o, end[i % 7][0], i % 7 == 4 ? vneg(d) : d, end[i % 7][1]};
}

static inline bool triangle_is_wrong(hit due, hit got)
{
    real most = real_is_float ? (real)1e-2 : (real)1e-9;
    if (due.shape == no_shape || got.shape == no_shape) return due.shape != got.shape;
    return !(fabs(got.t - due.t) <= most * due.t && fabs(got.u - due.u) <= most
             && fabs(got.v - due.v) <= most);
}

static inline bool triangle_prove(triangle_method *method, const char *name, size_t n, FILE *out)
{
    random_stream g = random_start(1, 41, 0);
    size_t asked = 0, hits = 0;
    for (size_t i = 0; i < n; i++) {
        triangle tri = {random_in_cube(&g, 1), random_in_cube(&g, 1), random_in_cube(&g, 1)};
        ray r = triangle_easy_ray(tri, i, &g);
        triangle_exact_hit x = triangle_exactly(tri, r);
        double least = fmin(x.w, fmin(x.u, x.v));
        if (!(fabs(least) > 1e-2) || x.cosine < 0.1) continue;
        bool met = least > 0 && ray_covers(r, (real)x.t);
        hit due = met ? (hit){(real)x.t, (real)x.u, (real)x.v, 0} : hit_none, got = hit_none;
        if (!method(tri, r, &got)) got = hit_none;
        asked++, hits += met;
        if (!triangle_is_wrong(due, got)) continue;
        const vec3 corner[3] = {tri.a, tri.b, tri.c};
        for (int k = 0; k < 3; k++)
            fprintf(out, "%s: corner %c = (%.17g, %.17g, %.17g)\n", name, "abc"[k],
                    (double)corner[k].x, (double)corner[k].y, (double)corner[k].z);
        wrong_report(out, name, r, due, got);
        return false;
    }
    fprintf(out, "%s: right for %zu easy rays, %zu of them hits\n", name, asked, hits);
    return true;
}

#endif
