/* corner.h: rays through a corner of a box, all numbers chosen so that float may be as far off as
 * it can be: what a search in float adds to its boxes must be enough here.
 *
 *   vec3 corner;
 *   ray r = corner_ray(&g, far, &corner);   corner: three floats, D from r.o between 1 and 2
 *   corner_test(lost)                       many of them, against a search
 *
 * far: how far both are from 0. Where far is 0, o is, too: then o + delta is delta, and not rounded
 * up to the next float. t is a little more than 1/2: corner - o, 1 / d and the product lie just
 * above a power of two, where half a last digit is the most that it can be.
 */
#ifndef TESTS_CORNER_H
#define TESTS_CORNER_H

#include "../chapters/01_ray/ray.h"
#include "../common/random.h"
#include "check.h"

/* ---------------------------------------------------------------------------------------------- */

/* 1 to 1.03 or its negative. */
static inline real corner_side(random_stream *g)
{
    real x = 1 + random_next(g) * (real)0.03;
    return random_next_bits(g) & 1 ? x : -x;
}

static inline ray corner_ray(random_stream *g, real far, vec3 *corner)
{
    vec3 o = random_in_cube(g, far), side = {corner_side(g), corner_side(g), corner_side(g)};
    vec3 c = vadd(o, side);
    real t = (1 + random_next(g) * (real)0.03) / 2;
    *corner = (vec3){(real)(float)c.x, (real)(float)c.y, (real)(float)c.z};
    return ray_from(o, vscale(vsub(*corner, o), 1 / t));
}

/* A box that is a point, which the ray meets: near and far planes may be rounded away from each
 * other, and what is added must be more than that. lost(r, c, bare): without what is added? */
static inline void corner_test(bool (*lost)(ray r, vec3 c, bool bare))
{
    static const real far[] = {0, 0.0625, 1000, 1e6};
    for (int k = 0; k < 4; k++) {
        size_t missed[2] = {0, 0}, rays = check_count(400000);
        for (size_t i = 0; i < rays; i++) {
            random_stream g = random_start(82, i, 0);
            vec3 c;
            ray r = corner_ray(&g, far[k], &c);
            for (int bare = 0; bare < 2; bare++) missed[bare] += lost(r, c, bare);
        }
        check_equal(missed[0], 0, "corners, %g from 0: %zu rays, lost", (double)far[k], rays);
        check_at_least(missed[1], rays / 10, "lost without what is added");
    }
}

#endif
