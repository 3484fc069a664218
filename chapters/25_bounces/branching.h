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
 * To see every ray:  branching_walk w;
 *                    branching_start(&w, &p, N, eye, seed, pixel, sample);
 *                    while (branching_next(&w, &counts)) w.r, w.stack[w.k].x, w.brought
 *   once it has returned false, it is over: start again.
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
 * No recursion: a stack of one node a generation, depth at most branching_most (else it is cut
 * there). The memory is that of one path; only time explodes.
 */
#ifndef BOUNCES_BRANCHING_H
#define BOUNCES_BRANCHING_H

#include "first.h"
#include "naive_path.h"

enum { branching_most = 64 };
typedef struct { lit_hit x; vec3 wo, throughput; uint64_t node; int done; } branching_node;

typedef struct {
    const naive_path *path;
    int N, k;                  /* k: bounces before the last hit, -1 before the eye ray */
    uint64_t seed, pixel, sample;
    ray r;                     /* the last one */
    vec3 brought;              /* of the last hit: throughput times emission */
    branching_node stack[branching_most + 1];  /* stack[k].x: the last hit; m NULL if none */
} branching_walk;

/* ---------------------------------------------------------------------------------------------- */

static inline point2 branching_pair(uint64_t seed, uint64_t pixel, uint64_t sample, uint64_t node)
{
    random_stream s = random_start(seed, pixel, sample);
    s.dimension = 2 * node;
    real u = random_next(&s), v = random_next(&s);
    return (point2){u, v};
}

/* What the ray finds; the node that begins there, done if nothing follows. */
static inline vec3 branching_visit(const naive_path *p, int N, ray r, vec3 throughput, uint64_t i,
                                   int bounces, branching_node *node, naive_counts *c)
{
    bool met;
    node->x.m = NULL;
    vec3 Le = naive_find(p, r, bounces, &node->x, &met, c);
    bool last = !met || bounces == p->depth || bounces == branching_most;
    bool black = met && !last && naive_black(node->x.m);
    c->black += black;
    node->done = last || (black && !p->spend_all) ? N : 0;
    node->wo = vneg(bounces ? r.d : vunit(r.d)), node->throughput = throughput, node->node = i;
    return vmul(throughput, Le);
}

static inline void branching_start(branching_walk *w, const naive_path *p, int N, ray eye,
                                   uint64_t seed, uint64_t pixel, uint64_t sample)
{
    w->path = p, w->N = N, w->k = -1, w->r = eye;
    w->seed = seed, w->pixel = pixel, w->sample = sample;
}

/* The next ray of the tree, depth first; false: there is none. */
static inline bool branching_next(branching_walk *w, naive_counts *c)
{
    const naive_path *p = w->path;
    vec3 one = {1, 1, 1}, weight;
    if (w->k < 0) {
        if (naive_dark(p->scene) && !p->spend_all) return false;
        w->k = 0;
        w->brought = branching_visit(p, w->N, w->r, one, 0, 0, &w->stack[0], c);
        return true;
    }
    while (w->k >= 0) {
        branching_node *top = &w->stack[w->k];
        if (top->done == w->N) { w->k--; continue; }
        uint64_t i = top->node * (uint64_t)w->N + (uint64_t)++top->done;
        point2 u = branching_pair(w->seed, w->pixel, w->sample, i);
        if (!naive_direction(p, &top->x, top->wo, u, &w->r, &weight)) continue;
        vec3 through = naive_through(top->throughput, vscale(weight, 1 / (real)w->N));
        if (vzero(through) && !p->spend_all) continue;
        w->k++;
        w->brought = branching_visit(p, w->N, w->r, through, i, w->k, &w->stack[w->k], c);
        return true;
    }
    return false;
}

static inline vec3 branching_radiance(const naive_path *p, int N, ray eye, uint64_t seed,
                                      uint64_t pixel, uint64_t sample, naive_counts *c)
{
    branching_walk w;
    vec3 L = {0, 0, 0};
    branching_start(&w, p, N, eye, seed, pixel, sample);
    while (branching_next(&w, c)) L = vadd(L, w.brought);
    return L;
}

#endif
