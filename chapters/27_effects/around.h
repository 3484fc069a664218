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

#include "stage.h"

/* ---------------------------------------------------------------------------------------------- */

static inline bool around_has(const media_set *in, uint32_t body)
{
    for (uint32_t k = 0; k < in->n; k++)
        if (in->body[k] == body) return true;
    return false;
}

/* One face on the way: of those entered the last is taken off, of others left all are noted. */
static inline void around_crosses(media_set *entered, media_set *around, uint32_t body,
                                  bool inwards)
{
    uint32_t k = entered->n;
    if (inwards) {
        if (k < media_most) entered->body[entered->n++] = body;
        return;
    }
    while (k > 0 && entered->body[k - 1] != body) k--;
    if (k > 0) {
        for (entered->n--; k <= entered->n; k++) entered->body[k - 1] = entered->body[k];
    } else if (around->n < media_most) {
        for (k = around->n++; k > 0; k--) around->body[k] = around->body[k - 1];
        around->body[0] = body;
    }
}

static inline media_set around_along(const effects_stage *e, ray r)
{
    media_set entered = {0}, around = {0};
    studio_hit x = {hit_none, 0};
    for (int k = 0; k < stage_most_depth && studio_tree_hit(&e->t, r, &x); k++) {
        uint32_t m = studio_hit_material(&e->t, x);
        surface s = studio_surface(&e->t, r, x);
        if (e->look[m].solid && !vzero(e->look[m].through))
            around_crosses(&entered, &around, m + 1, vdot(s.n, r.d) < 0);
        r.o = leave_point(s, r.d, 0);
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
            if (around_has(&one, body)) in.body[in.n++] = body;
        }
        all = in;
    }
    return all;
}

#endif
