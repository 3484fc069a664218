/* bodies.h: which bodies of glass a ray is in: outermost first; none: air.
 *
 *   uint32_t to = bodies_cross(e, body, inwards, &in, &after, counts)     through a face of a body
 *   media_set in = bodies_around(e, o)       of the point o; asked once, before the first ray
 *
 *        ___________                 Along a ray to infinity, a body that is left without having
 *       /  a   __   \                been entered was around its origin: here a, but not b.
 *      |  o---(b_)---|-->
 *       \___________/
 *
 * Files also have single sheets of glass, which are around nobody: a body is around o only if rays
 * in five directions agree. Of more than media_most bodies the innermost are kept.
 */
#ifndef EFFECTS_BODIES_H
#define EFFECTS_BODIES_H

#include "stage.h"

/* ---------------------------------------------------------------------------------------------- */

/* Sets what the ray is in before the face and after it; returns whose medium fills the place
 * behind. A body is listed as often as it was entered: of two balls of one glass that overlap,
 * leaving the first is no leaving of the glass. One that is left without having been entered was
 * around the ray's origin: it becomes the outermost. More than media_most: not noted, but counted.
 *
 * A call, since it is for few hits, and each copy of radiance.h would have one of its own. */
__attribute__((noinline))
static uint32_t bodies_cross(const effects_stage *e, uint32_t body, bool inwards, media_set *in,
                             media_set *after, effects_counts *c)
{
    uint32_t k = in->n;
    while (!inwards && k > 0 && in->body[k - 1] != body) k--;
    *after = *in;
    if (inwards) {
        if (k < media_most) after->body[after->n++] = body;
        else c->lost++;
    } else if (k > 0) {
        for (after->n--; k < in->n; k++) after->body[k - 1] = in->body[k];
    } else if (in->n < media_most) {
        for (k = in->n++; k > 0; k--) in->body[k] = in->body[k - 1];
        in->body[0] = body;
    }
    return media_fills(e->media, after);
}

static inline media_set bodies_along(const effects_stage *e, ray r)
{
    media_set in = {0}, after = {0}, around = {0};
    effects_counts c = {.lost = 0};
    studio_hit x = {hit_none, 0};
    for (int k = 0; k < stage_most_depth && studio_tree_hit(&e->t, r, &x); k++) {
        uint32_t m = studio_hit_material(&e->t, x), n = in.n;
        surface s = studio_surface(&e->t, r, x);
        r.o = leave_point(s, r.d, 0);
        if (!e->look[m].solid || vzero(e->look[m].through)) continue;
        bodies_cross(e, m + 1, vdot(s.n, r.d) < 0, &in, &after, &c);
        if (in.n > n && around.n < media_most) {  /* left, but never entered: outside all before */
            for (n = around.n++; n > 0; n--) around.body[n] = around.body[n - 1];
            around.body[0] = m + 1;
        }
        in = after;
    }
    return around;
}

static inline media_set bodies_around(const effects_stage *e, vec3 o)
{
    const vec3 way[5] = {vec(0.36, 0.48, 0.8), vec(-0.8, 0.36, 0.48), vec(0.48, -0.8, -0.36),
                         vec(-0.48, 0.64, -0.6), vec(0.28, -0.6, 0.75)};
    media_set all = {0}, in = {0};
    for (int k = 0; k < 5; k++) {
        media_set one = bodies_along(e, ray_from(o, way[k]));
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
