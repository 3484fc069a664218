/* survey.h: counting what rays take in this tree, and which of their hits are wrong.
 *
 *   ray_set d = rays_on(&b, &m, &s, seed);       diffuse rays from the hits of the rays s
 *   ray_set u = rays_lines(&b, n, seed);         lines as the heuristic assumes them: stats.h
 *   bvh_work w = rays_count(&b, &s);             what they take
 *   rays_wrong(&b, &s, brute, naive)             how many hits differ from those of brute force
 */
#ifndef BVH_SURVEY_H
#define BVH_SURVEY_H

#include "../../09_aabb/trials/survey.h"
#include "../bvh.h"

/* ---------------------------------------------------------------------------------------------- */

static inline ray_set rays_on(const bvh *b, const mesh *m, const ray_set *eye, uint64_t seed)
{
    hit *h = allocate(eye->n, sizeof *h);
    for (size_t i = 0; i < eye->n; i++)
        if (!bvh_hit(b, eye->r[i], &h[i])) h[i] = hit_none;
    ray_set s = rays_diffuse(m, eye, h, seed);
    free(h);
    return s;
}

static inline ray_set rays_lines(const bvh *b, size_t n, uint64_t seed)
{
    const float *s = b->tree.node[0].box.side;
    aabb box = {{(real)s[0], (real)s[1], (real)s[2]}, {(real)s[3], (real)s[4], (real)s[5]}};
    return rays_uniform(box, n, seed);
}

static inline bvh_work rays_count(const bvh *b, const ray_set *s)
{
    bvh_work w = {0, 0, 0, 0, 0};
    hit h;
    for (size_t i = 0; i < s->n; i++) bvh_hit_counted(b, s->r[i], &h, &w);
    return w;
}

/* Rays whose hit differs from the given ones, which brute force found. */
static inline size_t rays_wrong(const bvh *b, const ray_set *s, const hit *brute, bool naive)
{
    size_t wrong = 0;
    for (size_t i = 0; i < s->n; i++) {
        hit h = hit_none;
        if (naive) bvh_hit_naive(b, s->r[i], &h);
        else bvh_hit(b, s->r[i], &h);
        wrong += h.t != brute[i].t || h.shape != brute[i].shape || h.u != brute[i].u
                 || h.v != brute[i].v;
    }
    return wrong;
}

#endif
