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
 *   light_path(&t, &random, sum, &counts);        one path; sum: [3 w h], {0} at first
 *   pixel k of the picture = sum[k] / number of paths
 *   bool whole = light_picture(&t, seed, paths, threads, &im, &counts);     of so many, a multiple
 *                                               of light_jobs; false: Ctrl-C. Each job has a sum
 *                                               of its own, and they are added up in order:
 *                                               the same bytes for any number of threads
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

#include "../../common/parallel.h"
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
typedef struct { size_t paths, rays, shadow; } light_counts;
enum { light_jobs = 16 };
typedef struct {
    const light_tracer *t;
    uint64_t seed;
    size_t paths;                  /* of each job */
    double *sum[light_jobs];
    light_counts work[light_jobs];
} light_share;

/* ---------------------------------------------------------------------------------------------- */

static inline void light_tracer_free(light_tracer *t) { lit_lights_free(&t->light); }

static inline void light_tracer_of(const lit_scene *s, camera eye, int w, int h, light_tracer *out)
{
    real a = (eye.right - eye.left) * (eye.top - eye.bottom) / (eye.d * eye.d);
    *out = (light_tracer){.scene = s, .eye = eye, .width = w, .height = h};
    out->pixel = a / ((real)w * (real)h);
    lit_lights_of(s, NULL, LIGHTS_FLUX, &out->light);
}

/* A point of the emitter, each part of its area as likely; its n is where it shines. */
static inline surface light_start(const emitter *e, real u, real v)
{
    vec3 x, n = e->n;
    if (e->kind == EMITTER_RECTANGLE) {
        x = vmadd(vmadd(e->rectangle.o, e->rectangle.s, u), e->rectangle.t, v);
    } else if (e->kind == EMITTER_TRIANGLE) {
        vec3 b = sample_triangle(u, v);
        x = triangle_at(e->triangle, b.y, b.z);
    } else {
        n = sample_sphere(u, v);
        x = vmadd(e->sphere.c, n, fabs(e->sphere.r));
        if (e->sphere.r < 0) n = vneg(n);
    }
    return emitter_surface(e, x, n);
}

/* (26.8): `sends`: radiance times area that x sends to the eye. */
static inline void light_show(const light_tracer *t, surface s, vec3 sends, double *sum,
                              light_counts *c)
{
    real x, y;
    vec3 way = vsub(t->eye.e, s.p), to = vunit(way);
    real cosine = vdot(s.n, to), middle = vdot(to, t->eye.w), rr = vdot(way, way);
    if (!(cosine > 0) || vzero(sends)) return;
    if (!camera_project(t->eye, s.p, t->width, t->height, &x, &y)) return;
    if (!(x >= 0 && x < (real)t->width && y >= 0 && y < (real)t->height)) return;
    c->shadow++;
    if (lit_occluded_from(t->scene, leave_to(s, t->eye.e), s.shape, lit_dark)) return;
    real k = cosine / (rr * middle * middle * middle * t->pixel);
    double *at = sum + 3 * ((size_t)y * (size_t)t->width + (size_t)x);
    at[0] += (double)(sends.x * k), at[1] += (double)(sends.y * k), at[2] += (double)(sends.z * k);
}

/* On through the hit x: the next ray; false: the path ends. */
static inline bool light_scatter(const light_tracer *t, const lit_hit *x, random_stream *s,
                                 real most, vec3 *phi, ray *r, const lit_material **medium,
                                 double *sum, light_counts *c)
{
    vec3 back = vneg(r->d), wo, weight;
    real pdf;
    if (x->m->ior > 0) {
        bool through;
        real n1 = x->front ? 1 : x->m->ior, n2 = x->front ? x->m->ior : 1, power = 1;
        if (x->m->alpha > 0) {
            rough_glass g = {x->m->alpha, n1, n2};
            if (!dielectric_rough(g, x->s.n, vunit(back), s, &wo, &through, &power)) return false;
            *phi = vscale(*phi, power);
        } else wo = dielectric_scatter(x->s.n, back, n1, n2, random_next(s), &through);
        *r = leave(x->s, wo);
        if (through) *medium = x->front ? x->m : NULL;
        return true;
    }
    if (brdf_is_black(&x->m->f)) return false;
    shading_frame f = shading_frame_of(x->s.ns);
    vec3 wi = to_local(f, back), to = to_local(f, vunit(vsub(t->eye.e, x->s.p)));
    if (!brdf_is_delta(&x->m->f) && !brdf_behind(to))
        light_show(t, x->s, vmul(*phi, brdf_value_local(&x->m->f, wi, to)), sum, c);
    real u = random_next(s), v = random_next(s);
    if (!brdf_sample_local(&x->m->f, wi, u, v, &wo, &pdf, &weight)) return false;
    wo = to_world(f, wo), *phi = vmul(*phi, weight);
    if (!(vdot(x->s.n, wo) > 0) || vzero(*phi)) return false;
    real q = roulette_survival(vscale(*phi, 1 / most));
    if (q < 1 && random_next(s) >= q) return false;
    *phi = vscale(*phi, 1 / real_min(q, 1)), *r = leave(x->s, wo);
    return true;
}

static inline void light_path(const light_tracer *t, random_stream *s, double *sum,
                              light_counts *c)
{
    real chance, rest;
    lit_hit x = {.m = NULL};
    const lit_material *medium = NULL;
    c->paths++;
    if (!lit_lights_some(&t->light)) return;
    const emitter *e = &t->scene->emitter[lit_lights_choose(&t->light, random_next(s), &chance,
                                                            &rest)];
    if (e->kind == EMITTER_LIGHT) return;
    real u = random_next(s), v = random_next(s);
    surface from = light_start(e, u, v);
    light_show(t, from, vscale(e->Le, e->area / chance), sum, c);  /* the lamp itself */
    vec3 phi = vscale(e->Le, e->area * pi / chance);
    real most = real_max(real_max(phi.x, phi.y), phi.z);
    u = random_next(s), v = random_next(s);
    ray r = leave(from, directed(from.n, sample_cosine(u, v)));
    for (uint32_t left = no_shape; c->rays++, lit_trace_from(t->scene, r, left, &x);
         left = x.s.shape) {
        if (medium) phi = vmul(phi, absorbed(medium->sigma, x.t * vlength(r.d)));
        if (!light_scatter(t, &x, s, most, &phi, &r, &medium, sum, c)) return;
    }
}

static inline void light_job(size_t job, void *context)
{
    light_share *l = context;
    for (size_t k = 0; k < l->paths; k++) {
        random_stream s = random_start(l->seed, job, k);
        light_path(l->t, &s, l->sum[job], &l->work[job]);
    }
}

static inline bool light_picture(const light_tracer *t, uint64_t seed, size_t paths, int threads,
                                 image *im, light_counts *c)
{
    light_share l = {.t = t, .seed = seed, .paths = paths / light_jobs};
    size_t n = 3 * (size_t)t->width * (size_t)t->height;
    *im = image_new(t->width, t->height);
    for (int k = 0; k < light_jobs; k++) l.sum[k] = allocate(n, sizeof(double));
    bool whole = parallel_for(light_jobs, threads, "paths from the lamp", light_job, &l);
    for (size_t i = 0; i < n; i++) {
        double sum = 0;
        for (int k = 0; k < light_jobs; k++) sum += l.sum[k][i];
        im->rgb[i] = (float)(sum / (double)paths);
    }
    for (int k = 0; k < light_jobs; k++) {
        c->paths += l.work[k].paths, c->rays += l.work[k].rays, c->shadow += l.work[k].shadow;
        free(l.sum[k]);
    }
    return whole;
}

#endif
