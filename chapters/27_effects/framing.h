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
 * least distance from which the box of everything shows, and 4 % more, for air around it:
 *
 *              D                    a corner q from the middle, q = (qu, qv, qw):
 *     e <-----------+-- w           |qv| <= (D - qw) tan(phi/2)
 *      \ phi/2    . | q             |qu| <= (D - qw) tan(phi/2) aspect
 *        \    .     |               D = max (qw + max(|qv|, |qu| / aspect) / tan(phi/2))    (27.5)
 *          \        |
 *
 * `up` says which way is up: s.up. Up by y: the front is +z, up by z: -y, as Blender has it. False,
 * exit code 2: the scene is so large or small that no camera has numbers for it.
 */
#ifndef EFFECTS_FRAMING_H
#define EFFECTS_FRAMING_H

#include "../02_camera/camera.h"
#include "studio.h"

/* ---------------------------------------------------------------------------------------------- */

static inline bool framing_find(const studio *s, real aspect, studio_view *out, failure *f)
{
    static const vec3 ups[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const vec3 fronts[3] = {{0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
    vec3 lo, hi, up = ups[s->up], front = fronts[s->up], right = vcross(up, front);
    vec3 towards = vmadd(vmadd(vscale(front, 0.8), right, 0.55), up, 0.4);
    camera_frame c;
    *out = (studio_view){.from = towards, .up = up, .angle = 40};
    if (!studio_bounds(s, &lo, &hi)) return true;  /* nothing there: look at the origin */
    if (!frame_look_at(towards, (vec3){0, 0, 0}, up, &c, f)) return false;
    vec3 half = vsub(vscale(hi, 0.5), vscale(lo, 0.5));
    out->at = vmadd(vscale(lo, 0.5), hi, 0.5);
    real D = camera_distance(&c, half, aspect, half_tangent(40));
    if (!(D > 0)) D = real_max(1, vlength(out->at)) / 16;  /* one point */
    out->from = vmadd(out->at, c.w, D * (real)1.04);
    if (vfinite(out->from) && vfinite(out->at)) return true;
    return failed(f, 2, "no camera finds room for a scene from %g %g %g to %g %g %g", (double)lo.x,
                  (double)lo.y, (double)lo.z, (double)hi.x, (double)hi.y, (double)hi.z);
}

static inline bool studio_camera(const studio *s, real aspect, studio_view *view, camera *out,
                                 failure *f)
{
    camera_frame c;
    failure why;
    *view = s->view, *out = (camera){.kind = CAMERA_PERSPECTIVE};
    if (!view->given && !framing_find(s, aspect, view, &why))
        return failed(f, 2, "%.300s: %.150s", name_text(&s->files, s->files.n > 1), why.text);
    if (frame_look_at(view->from, view->at, view->up, &c, &why)
        && camera_perspective(c, view->angle, aspect, out, &why)) return true;
    return failed(f, 2, "%.300s: camera: %.150s", studio_said(s, view->said).text, why.text);
}

static inline real studio_focus(const studio *s, const studio_view *v)
{
    return s->lens.focus > 0 ? s->lens.focus : vlength(vsub(v->at, v->from));
}

#endif
