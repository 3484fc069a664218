/* around.h: which bodies the eye is in, asked once, before the first ray.
 *
 *   media_set in = effects_around(e, o)      of the point o; outermost first; empty: air
 *
 *        ___________                 Along a ray to infinity, a body that is left without having
 *       /  a   __   \                been entered was around its origin: here a, but not b.
 *      |  o---(b_)---|-->
 *       \___________/
 *
 * Files also have single sheets of glass, which are around nobody: a body counts only if rays in
 * five directions agree. Of more than media_most bodies the innermost are kept.
 */
#ifndef EFFECTS_AROUND_H
#define EFFECTS_AROUND_H

#include "radiance.h"

/* ---------------------------------------------------------------------------------------------- */

static inline media_set around_along(const effects_stage *e, ray r)
{
    media_set in = {0}, after = {0}, around = {0};
    effects_counts c = {.now = 0};
    studio_hit x = {hit_none, 0};
    for (int k = 0; k < stage_most_depth && studio_tree_hit(&e->t, r, &x); k++) {
        uint32_t m = studio_hit_material(&e->t, x), n = in.n;
        surface s = studio_surface(&e->t, r, x);
        r.o = leave_point(s, r.d, 0);
        if (!e->look[m].solid || vzero(e->look[m].through)) continue;
        effects_crosses(e, m + 1, vdot(s.n, r.d) < 0, &in, &after, &c);
        if (in.n > n && around.n < media_most) {  /* left, but never entered: outside all before */
            for (n = around.n++; n > 0; n--) around.body[n] = around.body[n - 1];
            around.body[0] = m + 1;
        }
        in = after;
    }
    return around;
}

static inline media_set effects_around(const effects_stage *e, vec3 o)
{
    const vec3 way[5] = {vec(0.36, 0.48, 0.8), vec(-0.8, 0.36, 0.48), vec(0.48, -0.8, -0.36),
                         vec(-0.48, 0.64, -0.6), vec(0.28, -0.6, 0.75)};
    media_set all = {0}, in = {0};
    for (int k = 0; k < 5; k++) {
        media_set one = around_along(e, ray_from(o, way[k]));
        in = (media_set){0};
        for (uint32_t i = 0; i < (k ? all.n : one.n); i++) {
            uint32_t body = k ? all.body[i] : one.body[i];
            if (media_has(&one, body)) in.body[in.n++] = body;
        }
        all = in;
    }
    return all;
}

#endif
