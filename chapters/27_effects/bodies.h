/* bodies.h: which bodies of glass a ray is in: outermost first; none: air.
 *
 *   uint32_t to = bodies_cross(e, &faces, &in, &after, counts)     through all faces at one place
 *   media_set in = bodies_around(e, o, counts)    of the point o; asked once, before the first ray
 *   in = bodies_from(e, o, in, p, counts)         of p, where rays of the eye at o begin
 *
 *        ___________                 Along a ray to infinity, a body that is left without having
 *       /  a   __   \                been entered was around its origin: here a, but not b.
 *      |  o---(b_)---|-->
 *       \___________/
 *
 * Files also have single sheets of glass, which are around nobody: a body is around o only if rays
 * in five directions agree. Of more than media_most bodies the innermost are kept, and the others
 * counted: the light is not right then, and nobody should show it (lab/draw.h).
 */
#ifndef EFFECTS_BODIES_H
#define EFFECTS_BODIES_H

#include "stage.h"

/* ---------------------------------------------------------------------------------------------- */

/* False: it was not in there. */
static inline bool bodies_leave(media_set *in, uint32_t body)
{
    uint32_t k = in->n;
    while (k > 0 && in->body[k - 1] != body) k--;
    if (k == 0) return false;
    for (in->n--; k <= in->n; k++) in->body[k - 1] = in->body[k];
    return true;
}

/* Sets what the ray is in before the faces at one place and after them; returns whose medium fills
 * the place behind. A body is listed as often as it was entered: of two balls of one glass that
 * overlap, leaving the first is no leaving of the glass. One that is left without having been
 * entered was around the ray's origin: it becomes the outermost. More than media_most: not noted,
 * but counted.
 *
 * A call, since it is for few hits, and each copy of radiance.h would have one of its own. */
__attribute__((noinline))
static uint32_t bodies_cross(const effects_stage *e, const media_crossing *x, media_set *in,
                             media_set *after, effects_counts *c)
{
    *after = *in = media_before(*in, x);
    for (const media_face *f = x->face; f < x->face + x->n; f++)
        if (f->out && !f->in && !bodies_leave(after, f->body)) c->lost++;
    for (const media_face *f = x->face; f < x->face + x->n; f++) {
        if (!f->in || f->out) continue;
        if (after->n < media_most) after->body[after->n++] = f->body;
        else c->lost++;
    }
    return media_fills(e->media, after);
}

/* Through what the ray meets first, which then begins behind it; false: it meets nothing. */
static inline bool bodies_step(const effects_stage *e, ray *r, media_set *in, media_set *after,
                               effects_counts *c)
{
    studio_hit x;
    touch at;
    if (!e->near || !studio_tree_hit(&e->t, *r, &x)) return false;
    surface s = studio_surface(&e->t, *r, x);
    touch_at(&e->t, e->look, e->near, true, *r, x, &s, &at);
    r->o = leave_point(s, r->d, at.more), c->lost += at.full;
    bodies_cross(e, &at.faces, in, after, c);
    return true;
}

static inline media_set bodies_along(const effects_stage *e, ray r, effects_counts *c)
{
    media_set in = {0}, after = {0}, around = {0};
    uint32_t n = 0;
    for (int k = 0; k < stage_most_faces && bodies_step(e, &r, &in, &after, c); k++) {
        /* left, but never entered: outside all before */
        for (uint32_t left = in.n - n; left-- > 0; around.n++) {
            if (around.n == media_most) { c->lost++; break; }
            memmove(around.body + 1, around.body, around.n * sizeof *around.body);
            around.body[0] = in.body[left];
        }
        in = after, n = in.n;
    }
    return around;
}

/* c may be NULL. Sheets in one direction are no bodies, so all five must find too many. */
static inline media_set bodies_around(const effects_stage *e, vec3 o, effects_counts *c)
{
    const vec3 way[5] = {vec(0.36, 0.48, 0.8), vec(-0.8, 0.36, 0.48), vec(0.48, -0.8, -0.36),
                         vec(-0.48, 0.64, -0.6), vec(0.28, -0.6, 0.75)};
    effects_counts found = {.lost = 0};
    media_set all = bodies_along(e, ray_from(o, way[0]), &found);
    bool lost = found.lost > 0;
    for (int k = 1; k < 5; k++) {
        found.lost = 0;
        media_set one = bodies_along(e, ray_from(o, way[k]), &found);
        uint32_t n = 0;
        lost &= found.lost > 0;
        for (uint32_t i = 0; i < all.n; i++)
            if (media_has(&one, all.body[i])) all.body[n++] = all.body[i];
        all.n = n;
    }
    if (c) c->lost += lost;
    return all;
}

/* What p is in, if q is in `in`: all between them is crossed, but not a wall at p itself. */
static inline media_set bodies_from(const effects_stage *e, vec3 q, media_set in, vec3 p,
                                    effects_counts *c)
{
    const vec3 d = vsub(p, q);
    media_set after = in;
    ray r = {q, 0, d, 1 - 64 * real_epsilon};
    for (int k = 0; k < stage_most_faces && bodies_step(e, &r, &in, &after, c); k++, in = after) {
        r.d = vsub(p, r.o);
        if (!(vdot(r.d, d) > 0)) return after;
    }
    return in;
}

#endif
