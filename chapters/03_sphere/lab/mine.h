/* mine.h: a reader's own sphere test: `make mine-03 MINE=my.h` compiles with MINE, the file's
 * name. Without it the test of ../mine.h is compiled, and appears in no table.
 *
 *   sphere_mine                         1 with MINE, else 0: so many rows more
 *   sphere_prove(hit, "mine", n, out)   n easy rays, from inside and from 2 to 10 R away, well
 *                                       inside or outside of the limb and of the interval: expected
 *                                       is sphere_hit's. The first that is wrong goes to `out`;
 *                                       false if there is one
 */
#ifndef SPHERE_LAB_MINE_H
#define SPHERE_LAB_MINE_H

#include "../../01_ray/trials/wrong.h"
#include "sphere_oracle.h"

#ifdef MINE
#include MINE
enum { sphere_mine = 1 };
#else
#include "../mine.h"
enum { sphere_mine = 0 };
#endif

/* ---------------------------------------------------------------------------------------------- */

/* Ray i: every third begins inside. The interval takes turns; it never ends or begins at a root. */
static inline ray sphere_easy_ray(size_t i, random_stream *g, sphere *ball)
{
    real far = i % 3 == 0 ? (real)0.5 * random_next(g) : 2 + 8 * random_next(g), t0, t1;
    real pass = (real)1.2 * random_next(g), R = pow((real)10, 4 * random_next(g) - 2);
    ray r = sphere_aim(g, R, far, pass, i % 2, ball);
    if (i % 5 == 0) r.d = vneg(r.d);
    if (!sphere_roots(*ball, r, &t0, &t1)) return r;
    real middle = (t0 + t1) / 2;
    const real end[5][2] = {
        {middle, real_infinity}, {0, middle},  /* the entry is out, the exit is in; the reverse */
        {t1 + (t1 - t0), real_infinity}, {-real_infinity, real_infinity}, {0, 2 * fabs(t0)}};
    if (i % 7 < 5) r.tmin = end[i % 7][0], r.tmax = end[i % 7][1];
    return r;
}

static inline bool sphere_prove(bool (*X_hit)(sphere s, ray r, hit *out), const char *name,
                                size_t n, FILE *out)
{
    const real most = real_is_float ? (real)1e-2 : (real)1e-9;
    random_stream g = random_start(1, 31, 0);
    size_t asked = 0, hits = 0;
    for (size_t i = 0; i < n; i++) {
        sphere ball;
        hit due = hit_none, got = hit_none;
        ray r = sphere_easy_ray(i, &g, &ball);
        if (fabs(sphere_clearance(ball, r)) < 1e-2) continue;
        bool met = sphere_hit(ball, r, &due), said = X_hit(ball, r, &got);
        asked++, hits += met;
        if (met == said && (!met || fabs(got.t - due.t) * vlength(r.d) <= most * ball.r)) continue;
        fprintf(out, "%s: of c = (%.17g, %.17g, %.17g), r = %.17g\n", name, (double)ball.c.x,
                (double)ball.c.y, (double)ball.c.z, (double)ball.r);
        wrong_report(out, name, r, due, said ? got : hit_none);
        return false;
    }
    fprintf(out, "%s: right for %zu easy rays, %zu of them hits\n", name, asked, hits);
    return true;
}

#endif
