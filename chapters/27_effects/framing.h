/* framing.h: the camera of a scene; one that shows all of it, if the scene gives none.
 *
 *   studio_view v;
 *   camera c;
 *   if (!studio_camera(&s, aspect, &v, &c, &f)) fail(f);    c for camera_ray (02); aspect = w / h
 *   real focus = studio_focus(&s, &v)      distance from the eye to the plane in focus, along -w
 *
 * Rays of c reach the plane at distance 1 at t = 1, so t counts along the axis of the view: with
 * r.tmin = v.hither nothing nearer is seen.
 *
 * Found: three-quarter view (四分之三视角) from the front right and a little above, 40 degrees, at the
 * least distance from which every corner of every shape's box and every point of every mesh shows:
 *
 *              D                    a point q from the middle, q = (qu, qv, qw):
 *     e <-----------+-- w           |qv| <= (D - qw) tan(phi/2)
 *      \ phi/2    . | q             |qu| <= (D - qw) tan(phi/2) aspect
 *        \    .     |               D = max (qw + max(|qv|, |qu| / aspect) / tan(phi/2))    (27.5)
 *          \        |
 *
 * and 4 % more, for air around it. Then the middle is moved to the middle of what shows, and D
 * taken again. `up` says which way is up: s.up. Up by y: the front is +z, up by z: -y, as Blender
 * has it. False, exit code 2: the scene is so large or small that no camera has numbers for it.
 */
#ifndef EFFECTS_FRAMING_H
#define EFFECTS_FRAMING_H

#include "../02_camera/camera.h"
#include "studio.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct { vec3 middle, u, v, w; real tangent, aspect, D, l, r, b, t; } framing;

/* (27.5), and how far it all reaches in the picture seen from the distance before. */
static inline void framing_add(framing *g, vec3 p, real far)
{
    vec3 q = vsub(p, g->middle);
    real u = vdot(q, g->u), v = vdot(q, g->v), w = vdot(q, g->w), depth = far - w;
    g->D = real_max(g->D, w + real_max(fabs(v), fabs(u) / g->aspect) / g->tangent);
    if (!(depth > 0)) return;
    g->l = real_min(g->l, u / depth), g->r = real_max(g->r, u / depth);
    g->b = real_min(g->b, v / depth), g->t = real_max(g->t, v / depth);
}

static inline void framing_add_box(framing *g, vec3 lo, vec3 hi, real far)
{
    for (int k = 0; k < 8; k++)
        framing_add(g, (vec3){k & 1 ? lo.x : hi.x, k & 2 ? lo.y : hi.y, k & 4 ? lo.z : hi.z}, far);
}

/* All shapes and all placed points; if these are too many, the box of everything. */
static inline void framing_measure(framing *g, const studio *s, real far)
{
    const size_t most_points = 50000000;  /* a second or so */
    size_t points = 0;
    g->D = 0, g->l = g->b = real_infinity, g->r = g->t = -real_infinity;
    for (size_t i = 0; i < s->shapes; i++) {
        vec3 lo, hi;
        shape_bounds(s->shape[i], &lo, &hi);
        if (vfinite(lo) && vfinite(hi)) framing_add_box(g, lo, hi, far);
    }
    for (size_t k = 0; k < s->solids; k++) {
        vec3 lo, hi;
        if (solid_bounds(&s->solid[k], &lo, &hi)) framing_add_box(g, lo, hi, far);
    }
    for (size_t i = 0; i < s->places; i++) points += 3 * s->mesh[s->placed[i].mesh].triangles;
    for (size_t i = 0; i < s->places && points <= most_points; i++) {
        const mesh *m = &s->mesh[s->placed[i].mesh];
        for (size_t k = 0; k < 3 * m->triangles; k++)  /* a stray vertex is not seen */
            framing_add(g, affine_point(s->placed[i].to_world, m->v[m->index[k]]), far);
    }
    if (points > most_points) {
        vec3 lo, hi;
        if (studio_bounds(s, &lo, &hi)) framing_add_box(g, lo, hi, far);
    }
}

static inline bool framing_find(const studio *s, real aspect, studio_view *out, failure *f)
{
    vec3 lo, hi, ups[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    vec3 fronts[3] = {{0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
    vec3 up = ups[s->up], front = fronts[s->up], right = vcross(up, front);
    vec3 towards = vmadd(vmadd(vscale(front, 0.8), right, 0.55), up, 0.4);
    camera_frame c;
    framing g = {.aspect = aspect, .tangent = half_tangent(40)};
    *out = (studio_view){.from = towards, .up = up, .angle = 40};
    if (!studio_bounds(s, &lo, &hi)) return true;  /* nothing there: look at the origin */
    g.middle = vmadd(vscale(lo, 0.5), hi, 0.5);
    if (!frame_look_at(towards, (vec3){0, 0, 0}, up, &c, f)) return false;
    g.u = c.u, g.v = c.v, g.w = c.w;
    framing_measure(&g, s, real_infinity);
    if (!(g.D > 0)) g.D = real_max(1, vlength(g.middle)) / 16;  /* one point */
    for (int k = 0; k < 2; k++) {  /* moved to the middle of the picture, measured again */
        real far = g.D;
        framing_measure(&g, s, far);
        if (!(g.l <= g.r && g.b <= g.t)) break;
        g.middle = vadd(g.middle, vscale(vadd(vscale(g.u, g.l + g.r), vscale(g.v, g.b + g.t)),
                                         far / 2));
        framing_measure(&g, s, far);
    }
    if (!(g.D > 0)) g.D = real_max(1, vlength(g.middle)) / 16;
    out->at = g.middle;
    out->from = vmadd(g.middle, g.w, g.D * (real)1.04);
    if (vfinite(out->from) && vfinite(out->at)) return true;
    return failed(f, 2, "no camera finds room for a scene from %g %g %g to %g %g %g", (double)lo.x,
                  (double)lo.y, (double)lo.z, (double)hi.x, (double)hi.y, (double)hi.z);
}

static inline bool studio_camera(const studio *s, real aspect, studio_view *view, camera *out,
                                 failure *f)
{
    char said[300];
    camera_frame c;
    failure why;
    *view = s->view, *out = (camera){.kind = CAMERA_PERSPECTIVE};
    if (!view->given && !framing_find(s, aspect, view, &why))
        return failed(f, 2, "%.300s: %.150s", name_text(&s->files, s->files.n > 1), why.text);
    if (frame_look_at(view->from, view->at, view->up, &c, &why)
        && camera_perspective(c, view->angle, aspect, out, &why)) return true;
    return failed(f, 2, "%.300s: camera: %.150s", studio_said(s, view->said, said, sizeof said),
                  why.text);
}

static inline real studio_focus(const studio *s, const studio_view *v)
{
    return s->lens.focus > 0 ? s->lens.focus : vlength(vsub(v->at, v->from));
}

#endif
