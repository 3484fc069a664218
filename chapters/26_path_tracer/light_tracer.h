/* light_tracer.h: the path tracer turned round: paths begin on a lamp and are shown to the eye.
 *                                                                       light tracing (光源追踪)
 *   lamp --> x0 --> x1 --> x2 ...     phi: the power [W] that the path still carries
 *             \      \                at each xk: what it reflects towards the eye lands in the
 *             eye    eye              pixel where xk shows, if nothing is between
 *
 *   phi_0 = Le A pi / P(lamp)         x0 uniform on the lamp's area A, its direction as the cosine;
 *                                     where both sides shine: twice that, and one of them by chance
 *   pixel += phi f cos_x / (r^2 cos_e^3 a)                                                  (26.8)
 *   phi   *= f cos / pdf / q          as beta in path.h and by its code, but for (26.10): glass
 *                                     squeezes radiance, no power
 *   light_tracer t; light_tracer_of(&scene, eye, w, h, &t);   eye: perspective; no sky, background
 *                                             or light without size: those show nothing
 *   light_path(&t, &random, &sum);            one path; sum.rgb: [3 w h], all 0 at first
 *   pixel k of the picture = sum.rgb[k] / sum.work.paths
 *   path_tracer_free(&t.paths)
 *
 * A point dA of a surface covers cos_x dA / (r^2 cos_e^3) of a plane at distance 1 of the eye:
 * cosines at xk and at the eye, r the way between; a: area of a pixel in that plane.
 *
 * The same integral as path.h's, so the same mean in each pixel. What differs is who finds what:
 * light through glass or off a mirror onto a matte floor (a caustic, 焦散) is met by chance only
 * from the eye, and drawn at once from the lamp. What the eye sees in a mirror or through glass no
 * path from the lamp can show: the eye is a point, and the last direction has no choice: black.
 *
 * Source: J. Arvo, "Backward Ray Tracing", SIGGRAPH course notes 1986; P. Dutre, E. Lafortune, Y.
 * Willems, "Monte Carlo Light Tracing with Direct Computation of Pixel Intensities", 1993.
 */
#ifndef PATH_LIGHT_TRACER_H
#define PATH_LIGHT_TRACER_H

#include "../02_camera/camera.h"
#include "path.h"

typedef struct { path_tracer paths; camera eye; int width, height; } light_tracer;
typedef struct { double *rgb; path_counts work; } light_sum;  /* work.shadow: rays to the eye */

/* ---------------------------------------------------------------------------------------------- */

static inline void light_tracer_of(const lit_scene *s, camera eye, int w, int h, light_tracer *out)
{
    path_options how = path_defaults;
    how.light_sampling = false;
    *out = (light_tracer){.eye = eye, .width = w, .height = h};
    path_tracer_of(s, NULL, how, &out->paths);
}

/* (26.8), phi_f = phi f: what s sends to the eye. */
static inline void light_show(const light_tracer *t, const surface *s, vec3 phi_f, light_sum *to)
{
    const camera *c = &t->eye;
    real x, y, w = (real)t->width, h = (real)t->height;
    vec3 way = vsub(c->e, s->p), wi = vunit(way);
    real cosine = vdot(s->n, wi), middle = vdot(wi, c->w);
    if (!(cosine > 0) || vzero(phi_f)) return;
    if (!camera_project(*c, s->p, t->width, t->height, &x, &y)) return;
    if (!(x >= 0 && x < w && y >= 0 && y < h)) return;
    to->work.shadow++;
    if (lit_occluded_from(t->paths.scene, leave_to(*s, c->e), s->shape, lit_dark)) return;
    real a = (c->right - c->left) * (c->top - c->bottom) / (c->d * c->d * w * h);
    vec3 L = vscale(phi_f, cosine / (vdot(way, way) * middle * middle * middle * a));
    double *at = to->rgb + 3 * ((size_t)y * (size_t)t->width + (size_t)x);
    at[0] += (double)L.x, at[1] += (double)L.y, at[2] += (double)L.z;
}

/* From a lamp, which the eye may see itself. Dice look at beta = phi / *power, at most 1. */
static inline path_walk light_begin(const light_tracer *t, path_random *s, real *power,
                                    light_sum *to)
{
    real chance;
    vec3 n;
    point2 u = path_pair(s), v = path_pair(s);
    size_t k = lit_lights_choose(&t->paths.light, u.u, &chance, &u.u);
    const emitter *e = &t->paths.light.emitter[k];
    vec3 x = emitter_at(e, u, &n);
    if (e->both && random_next(&s->own) < (real)0.5) n = vneg(n);
    surface from = emitter_surface(e, x, n);
    path_walk w;
    path_begin(&w, leave(from, directed(n, sample_cosine(v.u, v.v))));
    real most = real_max(real_max(e->Le.x, e->Le.y), e->Le.z);
    w.beta = vscale(e->Le, 1 / most), *power = most * e->area * pi / chance;
    if (e->both) *power *= 2;
    light_show(t, &from, vscale(w.beta, *power / pi), to);
    return w;
}

static inline void light_path(const light_tracer *t, path_random *s, light_sum *to)
{
    lit_hit x;
    real power;
    to->work.paths++;
    if (!lit_lights_some(&t->paths.light)) return;
    path_walk w = light_begin(t, s, &power, to);
    to->work.camera++;  /* not from one, but the first */
    while (path_meets(&t->paths, &w, &x)) {
        shading_frame f = shading_frame_of(x.s.ns);
        vec3 eye = to_local(f, vunit(vsub(t->eye.e, x.s.p))), wi = to_local(f, vneg(w.r.d));
        vec3 phi_f = vscale(vmul(w.beta, brdf_value_local(x.f, wi, eye)), power / w.squeezed);
        if (!(x.m->inside.ior > 0)) light_show(t, &x.s, phi_f, to);
        if (!path_on(&t->paths, &w, &x, s, &to->work)) return;
    }
}

#endif
