/* branching.h: N directions at each hit, as the notes first write shade(): the rays explode.
 *
 *                 N = 3                   bounces   rays
 *   eye --- x0 --< ---< .. ---< ..        0         1
 *                  ---< .. ---< ..        1         N
 *                  ---< .. ---< ..        2         N^2 ...
 *
 *   rays = 1 + N + ... + N^d = (N^(d+1) - 1) / (N - 1), d + 1 if N = 1: where nothing ends  (25.9)
 *
 *   vec3 L = branching_radiance(&p, N, eye, seed, pixel, sample, &counts);
 *   double n = first_rays_of_branching(N, d);     (25.9), from first.h
 *
 * To see every ray:  branching w = {&p, N, seed, pixel, sample, &counts, see, user};
 *                    vec3 L = branching_trace(&w, eye);     calls see for each
 *
 * Its expectation is that of naive_path.h, (25.8), for every N. Each of the N gets 1/N of the
 * weight, so that all rays of a generation together weigh as much as one ray of a path: the farther
 * from the eye, the more rays, and the less each of them brings.
 *
 * Random numbers: node c of a node i of the tree of rays is N i + c + 1, the eye ray is node 0, and
 * node i takes pair i of (seed, pixel, sample). So the numbers do not depend on which branches were
 * cut, and N = 1 draws the same path as naive_radiance with a SEQUENCE_RANDOM sampler whose pair 0
 * has been taken (for the place in the pixel). Beyond 2^64 nodes numbers repeat.
 *
 * Depth first, at most branching_most bounces (else it is cut there). The memory is that of one
 * path; only time explodes.
 */
#ifndef BOUNCES_BRANCHING_H
#define BOUNCES_BRANCHING_H

#include "first.h"
#include "naive_path.h"

enum { branching_most = 64 };

typedef struct {
    const naive_path *path;
    int N;
    uint64_t seed, pixel, sample;
    naive_counts *counts;
    /* Is told of each ray, what it brought and what it met (x->m NULL: nothing) after k bounces. */
    void (*see)(void *user, ray r, int k, const lit_hit *x, vec3 brought);  /* NULL: nobody looks */
    void *user;
} branching;

/* ---------------------------------------------------------------------------------------------- */

static inline point2 branching_pair(uint64_t seed, uint64_t pixel, uint64_t sample, uint64_t node)
{
    random_stream s = random_start(seed, pixel, sample);
    s.dimension = 2 * node;
    real u = random_next(&s), v = random_next(&s);
    return (point2){u, v};
}

/* Adds to *L what the ray of a node brings, and then what all rays do that follow from it. */
static inline void branching_node(const branching *w, ray r, vec3 through, int k, uint64_t node,
                                  vec3 *L)
{
    const naive_path *p = w->path;
    lit_hit x = {.m = NULL};
    vec3 weight;
    bool met;
    vec3 brought = vmul(through, naive_find(p, r, k, &x, &met, w->counts));
    *L = vadd(*L, brought);
    if (w->see) w->see(w->user, r, k, &x, brought);
    if (!met || k == p->depth || k == branching_most) return;
    w->counts->black += naive_black(&x);
    vec3 wo = vneg(k ? r.d : vunit(r.d));
    for (uint64_t c = 1; c <= (uint64_t)w->N; c++) {
        uint64_t i = node * (uint64_t)w->N + c;
        point2 u = branching_pair(w->seed, w->pixel, w->sample, i);
        if (!naive_direction(p, &x, wo, u, &r, &weight)) continue;
        vec3 on = naive_through(through, vscale(weight, 1 / (real)w->N));
        if (!vzero(on) || p->spend_all) branching_node(w, r, on, k + 1, i, L);
    }
}

static inline vec3 branching_trace(const branching *w, ray eye)
{
    vec3 L = {0, 0, 0}, one = {1, 1, 1};
    if (!naive_dark(w->path->scene) || w->path->spend_all) branching_node(w, eye, one, 0, 0, &L);
    return L;
}

static inline vec3 branching_radiance(const naive_path *p, int N, ray eye, uint64_t seed,
                                      uint64_t pixel, uint64_t sample, naive_counts *c)
{
    branching w = {p, N, seed, pixel, sample, c, NULL, NULL};
    return branching_trace(&w, eye);
}

#endif
