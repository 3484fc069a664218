/* light_tracer.h: the path tracer turned round: paths begin on a lamp and are shown to the eye.
 *                                                                       light tracing (光源追踪)
 *   lamp --> x0 --> x1 --> x2 ...     phi: the power [W] that the path still carries
 *             \      \                at each xk: what it reflects towards the eye lands in the
 *             eye    eye              pixel where xk shows, if nothing is between
 *
 *   phi_0 = Le A pi / P(lamp)         x0 uniform on the lamp's area A, its direction as the cosine
 *   pixel += phi f cos_x / (r^2 cos_e^3 a)                                                  (26.8)
 *   phi   *= f cos / pdf / q          as beta in path.h, and the same roulette
 *
 *   light_tracer t;
 *   light_tracer_of(&scene, eye, w, h, &t);       eye: perspective; no sky, no background,
 *                                               no light without size: those show nothing
 *   light_path(&t, &random, &sum);              one path; sum.rgb: [3 w h], all 0 at first
 *   pixel k of the picture = sum.rgb[k] / number of paths
 *   light_tracer_free(&t)
 *
 * a: area of a pixel in a plane at distance 1 of the eye; cos_e: cosine there, cos_x: at xk; r: the
 * way between. A point dA of a surface covers cos_x dA / (r^2 cos_e^3) of that plane.
 *
 * The same integral as path.h's, so the same mean in each pixel. What differs is who finds what:
 * light through glass or off a mirror onto a matte floor (a caustic, 焦散) is met by chance only
 * from the eye, and drawn at once from the lamp. What the eye sees in a mirror or through glass no
 * path from the lamp can show: the eye is a point, and the last direction has no choice. There the
 * picture is black. In glass phi stays: power is not squeezed as radiance is (26.10).
 *
 * Source: J. Arvo, "Backward Ray Tracing", SIGGRAPH course notes 1986; P. Dutre, E. Lafortune, Y.
 * Willems, "Monte Carlo Light Tracing with Direct Computation of Pixel Intensities", 1993.
 */
#ifndef PATH_LIGHT_TRACER_H
#define PATH_LIGHT_TRACER_H

#include "../02_camera/camera.h"
#include "../24_direct_light/lights.h"
#include "dielectric.h"
#include "roulette.h"

typedef struct {
    const lit_scene *scene;
    lit_lights light;
    camera eye;
    int width, height;
    real pixel;              /* a */
} light_tracer;
typedef struct { double *rgb; size_t paths, rays, shadow; } light_sum;

/* ---------------------------------------------------------------------------------------------- */

static inline void light_tracer_free(light_tracer *t) { lit_lights_free(&t->light); }

static inline void light_tracer_of(const lit_scene *s, camera eye, int w, int h, light_tracer *out)
{
    real a = (eye.right - eye.left) * (eye.top - eye.bottom) / (eye.d * eye.d);
    *out = (light_tracer){.scene = s, .eye = eye, .width = w, .height = h};
    out->pixel = a / ((real)w * (real)h);
    lit_lights_of(s, NULL, LIGHTS_FLUX, &out->light);
}

/* (26.8): `sends`: radiance times area that x sends to the eye. */
static inline void light_show(const light_tracer *t, surface s, vec3 sends, light_sum *to)
{
    real x, y;
    vec3 way = vsub(t->eye.e, s.p), wi = vunit(way);
    real cosine = vdot(s.n, wi), middle = vdot(wi, t->eye.w), rr = vdot(way, way);
    if (!(cosine > 0) || vzero(sends)) return;
    if (!camera_project(t->eye, s.p, t->width, t->height, &x, &y)) return;
    if (!(x >= 0 && x < (real)t->width && y >= 0 && y < (real)t->height)) return;
    to->shadow++;
    if (lit_occluded_from(t->scene, leave_to(s, t->eye.e), s.shape, lit_dark)) return;
    real k = cosine / (rr * middle * middle * middle * t->pixel);
    double *at = to->rgb + 3 * ((size_t)y * (size_t)t->width + (size_t)x);
    at[0] += (double)(sends.x * k), at[1] += (double)(sends.y * k), at[2] += (double)(sends.z * k);
}

/* Where the path is. */
typedef struct {
    vec3 phi;
    real most;                   /* largest component of phi_0 */
    ray r;
    const lit_material *medium;  /* glass that r is in, or NULL */
} light_walk;

/* From a lamp, which the eye may see itself; false: there is none. */
static inline bool light_begin(const light_tracer *t, random_stream *s, light_walk *w,
                               light_sum *to)
{
    if (!lit_lights_some(&t->light)) return false;
    real chance, rest, which = random_next(s);
    const emitter *e = &t->scene->emitter[lit_lights_choose(&t->light, which, &chance, &rest)];
    real u = random_next(s), v = random_next(s);
    vec3 n, x = emitter_at(e, (point2){u, v}, &n);
    surface from = emitter_surface(e, x, n);
    light_show(t, from, vscale(e->Le, e->area / chance), to);
    u = random_next(s), v = random_next(s);
    w->phi = vscale(e->Le, e->area * pi / chance);
    w->most = real_max(real_max(w->phi.x, w->phi.y), w->phi.z);
    w->r = leave(from, directed(n, sample_cosine(u, v))), w->medium = NULL;
    return true;
}

/* Both: on from the hit x; false: the path ends. */
static inline bool light_through_glass(light_walk *w, const lit_hit *x, random_stream *s)
{
    bool through;
    vec3 back = vneg(w->r.d), wo;
    real n1 = x->front ? 1 : x->m->ior, n2 = x->front ? x->m->ior : 1, power = 1;
    if (x->m->alpha > 0) {
        rough_glass g = {x->m->alpha, n1, n2};
        if (!dielectric_rough(g, x->s.n, vunit(back), s, &wo, &through, &power)) return false;
    } else wo = dielectric_scatter(x->s.n, back, n1, n2, random_next(s), &through);
    if (through) w->medium = x->front ? x->m : NULL;
    w->phi = vscale(w->phi, power), w->r = leave(x->s, wo);
    return true;
}

static inline bool light_reflect(const light_tracer *t, light_walk *w, const lit_hit *x,
                                 random_stream *s, light_sum *to)
{
    const brdf *b = &x->m->f;
    if (brdf_is_black(b)) return false;
    vec3 wo, weight;
    real pdf;
    shading_frame f = shading_frame_of(x->s.ns);
    vec3 wi = to_local(f, vneg(w->r.d)), eye = to_local(f, vunit(vsub(t->eye.e, x->s.p)));
    if (!brdf_is_delta(b) && !brdf_behind(eye))
        light_show(t, x->s, vmul(w->phi, brdf_value_local(b, wi, eye)), to);
    real u = random_next(s), v = random_next(s);
    if (!brdf_sample_local(b, wi, u, v, &wo, &pdf, &weight)) return false;
    wo = to_world(f, wo), w->phi = vmul(w->phi, weight);
    if (!(vdot(x->s.n, wo) > 0) || vzero(w->phi)) return false;
    real q = roulette_survival(vscale(w->phi, 1 / w->most));
    if (q < 1 && random_next(s) >= q) return false;
    w->phi = vscale(w->phi, 1 / q), w->r = leave(x->s, wo);
    return true;
}

static inline void light_path(const light_tracer *t, random_stream *s, light_sum *to)
{
    light_walk w;
    lit_hit x = {.s = {.shape = no_shape}};
    to->paths++;
    if (!light_begin(t, s, &w, to)) return;
    while (to->rays++, lit_trace_from(t->scene, w.r, x.s.shape, &x)) {
        if (w.medium) w.phi = vmul(w.phi, absorbed(w.medium->sigma, x.t * vlength(w.r.d)));
        if (x.m->ior > 0 ? !light_through_glass(&w, &x, s) : !light_reflect(t, &w, &x, s, to))
            return;
    }
}

#endif
