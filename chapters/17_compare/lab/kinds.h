/* kinds.h: the four kinds of rays with which structures are compared; those to prove answers with
 * are in 09_aabb/trials/borders.h.
 *
 *   ray_set p = rays_view(&w, edge)               primary (主光线): edge x edge from the eye
 *   ray_set s = rays_on(&w, KIND_SHADOW, &p, hits, seed)     from each hit on:
 *                                                 shadow (阴影光线): to each light that its surface
 *                                                 faces; is anything between?
 *                                                 diffuse (漫反射): one a hit, by the cosine law
 *                                                 mirror (镜面反射): one a hit
 *   rays_free(&s)
 *
 * hits[i] belongs to p.r[i]. Rays that leave a surface begin off it, by 1e-4 of their distance from
 * the eye, on the side that the eye sees.
 */
#ifndef COMPARE_KINDS_H
#define COMPARE_KINDS_H

#include "../../09_aabb/trials/borders.h"

typedef enum { KIND_PRIMARY, KIND_SHADOW, KIND_DIFFUSE, KIND_MIRROR, compare_kinds } compare_kind;
static const char *const kind_name[compare_kinds] = {"primary", "shadow", "diffuse", "mirror"};

/* ---------------------------------------------------------------------------------------------- */

static inline ray_set rays_view(const world *w, int edge)
{
    ray_set s = {allocate((size_t)edge * (size_t)edge, sizeof(ray)), 0};
    for (int j = 0; j < edge; j++)
        for (int i = 0; i < edge; i++) {
            real x = ((real)i + (real)0.5) / (real)edge, y = ((real)j + (real)0.5) / (real)edge;
            s.r[s.n++] = world_ray(w, 2 * x - 1, 1 - 2 * y);
        }
    return s;
}

static inline ray_set rays_on(const world *w, compare_kind kind, const ray_set *eye,
                              const hit *hits, uint64_t seed)
{
    size_t each = kind == KIND_SHADOW ? (size_t)w->lights : 1;
    ray_set s = {allocate(eye->n * each, sizeof(ray)), 0};
    for (size_t i = 0; i < eye->n; i++) {
        random_stream g = random_start(seed, i, 0);
        if (hits[i].shape == no_shape) continue;
        vec3 d = eye->r[i].d, n = world_normal(w, hits[i], ray_at(eye->r[i], hits[i].t));
        vec3 p = leave_surface(eye->r[i], hits[i].t, &n);
        for (int k = 0; k < w->lights && kind == KIND_SHADOW; k++)
            if (vdot(n, vsub(w->light[k], p)) > 0) s.r[s.n++] = ray_between(p, w->light[k]);
        if (kind == KIND_DIFFUSE) s.r[s.n++] = ray_from(p, diffuse_direction(n, &g));
        if (kind == KIND_MIRROR) s.r[s.n++] = ray_from(p, vmadd(d, n, -2 * vdot(d, n)));
    }
    return s;
}

#endif
