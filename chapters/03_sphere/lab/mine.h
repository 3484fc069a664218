/* mine.h: a reader's own sphere test: `make mine-03 MINE=my.h` compiles with MINE, the file's
 * name. Without it the test of ../mine.h is compiled, and appears in no table.
 *
 *   sphere_mine                         1 with MINE, else 0: so many rows more
 *   sphere_prove(hit, "mine", n, out)   n easy rays, from inside and from 2 to 10 R away, well
 *                                       inside or outside of the limb and of the interval: expected
 *                                       are the roots in 30 digits. The first that is wrong goes to
 *                                       `out`; false if there is one
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
static inline ray sphere_easy_ray(size_t i, random_stream *g, sphere *ball, hit *due)
{
    real far = i % 3 == 0 ? (real)0.5 * random_next(g) : 2 + 8 * random_next(g), t[2];
    real pass = (real)1.2 * random_next(g), R = pow((real)10, 4 * random_next(g) - 2);
    ray r = sphere_aim(g, R, far, pass, i % 2, ball);
    *due = hit_none;
    if (i % 5 == 0) r.d = vneg(r.d);
    sphere_quadratic q = sphere_exactly(*ball, r);
    if (wide_sign(q.D) < 0) return r;
    wide root = wide_sqrt(q.D), less = wide_neg(q.b);
    t[0] = (real)wide_value(wide_div(wide_sub(less, root), q.a));
    t[1] = (real)wide_value(wide_div(wide_add(less, root), q.a));
    real middle = (t[0] + t[1]) / 2;
    if (i % 7 == 0) r.tmin = middle;                   /* the entry is out, the exit is in */
    if (i % 7 == 1) r.tmax = middle;
    if (i % 7 == 2) r.tmin = t[1] + (t[1] - t[0]);     /* behind the sphere */
    if (i % 7 == 3) r.tmin = -real_infinity;
    if (i % 7 == 4) r.tmin = 0, r.tmax = 2 * fabs(t[0]);
    for (int k = 1; k >= 0; k--)
        if (ray_covers(r, t[k])) *due = (hit){t[k], 0, 0, 0};
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
        hit due, got = hit_none;
        ray r = sphere_easy_ray(i, &g, &ball, &due);
        if (fabs(sphere_clearance(ball, r)) < 1e-2) continue;
        if (!X_hit(ball, r, &got)) got = hit_none;
        bool met = due.shape != no_shape, said = got.shape != no_shape;
        asked++, hits += met;
        if (met == said && (!met || fabs(got.t - due.t) * vlength(r.d) <= most * ball.r)) continue;
        fprintf(out, "%s: of c = (%.17g, %.17g, %.17g), r = %.17g\n", name, (double)ball.c.x,
                (double)ball.c.y, (double)ball.c.z, (double)ball.r);
        wrong_report(out, name, r, due, got);
        return false;
    }
    fprintf(out, "%s: right for %zu easy rays, %zu of them hits\n", name, asked, hits);
    return true;
}

#endif
