/* naive_path.h: one path (路径), one direction at each hit: the notes' shade() with N = 1.
 *
 *   eye ---> x0 ---> x1 ---> x2 ...    w_i = f cos / pdf of the direction drawn at x_i      (25.7)
 *        E     w0 E    w0 w1 E         throughput (路径吞吐量) of k bounces: w_0 w_1 ... w_(k-1)
 *
 *   naive_path p = {&scene, DIRECTIONS_BRDF, depth, false};
 *   vec3 L = naive_radiance(&p, eye, &s, &counts);   s: sampler (20), a pair a bounce; counts: {0}
 *
 *   mean of L = E + K E + K^2 E + ... + K^depth E  of what the eye ray meets, exactly       (25.8)
 *
 * Light is counted where a path meets it, never searched for: for each hit k <= depth, its emission
 * times the throughput; for a ray that leaves the scene, the background, and the path ends. All of
 * that holds for any scene that the choice of directions can find its way in: uniform and cosine
 * never find a mirror's direction. Dielectrics (ior > 0) reflect nothing here. Radiance seen at
 * once (k = 0) is counted as any other: it isn't forgotten, and isn't a special case.
 *
 * The variance is what makes it naive: a light that fills the share q of the directions is met by
 * one path in 1/q. It is finite as long as w and E are bounded.
 *
 * Never ends? Not with a depth. naive_endless stops where the path escapes or the throughput is 0.
 * What is below the smallest normal number (下溢, underflow) counts as 0: with albedo 1/2 after
 * 1023 hits in double, 127 in float. To wait for 0 itself would not do: the smallest number of all,
 * times .6, rounds to itself. With albedo 1 in a closed room it never stops.
 *
 * Only what is called for: a ray is traced only if it can bring something. None goes on from a
 * black surface (a light with black reflection, for one), in a direction that reflects nothing,
 * with throughput 0 (red light on a green wall), from the last hit. None at all is traced in a
 * scene without light. With spend_all all are traced, but for those beyond depth, and the result is
 * the same bit by bit. [needs a finite depth]
 *
 * To see every hit:  for (naive_walk w = naive_start(&p, eye); naive_next(&p, &w, &s, &counts);)
 *                        w.brought is the sample of K^(w.bounces) E
 *
 * Source: J. Kajiya, "The Rendering Equation", SIGGRAPH 1986, section 4.
 */
#ifndef BOUNCES_NAIVE_PATH_H
#define BOUNCES_NAIVE_PATH_H

#include "../18_shade/leave.h"
#include "../23_brdf/reflection.h"
#include "../24_direct_light/lit_scene.h"

enum { naive_endless = INT_MAX, naive_depths = 16 };
typedef struct {
    const lit_scene *scene;
    direction_choice choice;   /* uniform, cosine, or as the surface reflects (23) */
    int depth;                 /* bounces at most [>= 0], or naive_endless */
    bool spend_all;
} naive_path;

/* rays[k]: rays that k bounces came before; the last one: so many, or more. */
typedef struct { size_t rays[naive_depths], escaped, black; } naive_counts;

typedef struct {
    ray r;                     /* the next one; of unit length but for the first */
    vec3 throughput;           /* of what it will bring */
    vec3 brought;              /* of the last hit: throughput times emission */
    int bounces;               /* before the last hit */
    bool ended;
} naive_walk;

/* ---------------------------------------------------------------------------------------------- */

static inline bool naive_dark(const lit_scene *s) { return !s->emitters && vzero(s->background); }

static inline bool naive_black(const lit_material *m) { return m->ior > 0 || brdf_is_black(&m->f); }

static inline size_t naive_rays(const naive_counts *c)
{
    size_t n = 0;
    for (int k = 0; k < naive_depths; k++) n += c->rays[k];
    return n;
}

/* Throughput after a hit of this weight, without what is too small to go on. */
static inline vec3 naive_through(vec3 a, vec3 weight)
{
    a = vmul(a, weight);
    if (a.x < real_smallest) a.x = 0;
    if (a.y < real_smallest) a.y = 0;
    if (a.z < real_smallest) a.z = 0;
    return a;
}

/* Emission that a ray finds; *met: is there a surface? */
fast_inline vec3 naive_find(const naive_path *p, ray r, int bounces, lit_hit *x, bool *met,
                            naive_counts *c)
{
    c->rays[bounces < naive_depths ? bounces : naive_depths - 1]++;
    *met = lit_trace(p->scene, r, x);
    if (*met) return lit_emitted(x);
    c->escaped++;
    return p->scene->background;
}

/* From x one direction on, wo the unit direction back; *weight = f cos / pdf. False: it brings
 * nothing. A direction that a shading normal sends through the surface does not either. */
fast_inline bool naive_direction(const naive_path *p, const lit_hit *x, vec3 wo, point2 u,
                                 ray *next, vec3 *weight)
{
    vec3 wi;
    shading_frame f = shading_frame_of(x->s.ns);
    bool some = !naive_black(x->m)
             && reflection_direction(p->choice, &x->m->f, f, to_local(f, wo), u, &wi, weight)
             && vdot(x->s.n, wi) > 0;
    if (!some) {
        if (!p->spend_all) return false;
        *weight = (vec3){0, 0, 0};
        wi = to_world(f, sample_cosine(u.u, u.v));
    }
    *next = leave(x->s, wi);
    return true;
}

static inline naive_walk naive_start(const naive_path *p, ray eye)
{
    return (naive_walk){eye, {1, 1, 1}, {0, 0, 0}, -1, naive_dark(p->scene) && !p->spend_all};
}

fast_inline bool naive_next(const naive_path *p, naive_walk *w, sampler *s, naive_counts *c)
{
    if (w->ended) return false;
    lit_hit x = {.m = NULL};
    vec3 weight;
    bool met;
    vec3 Le = naive_find(p, w->r, ++w->bounces, &x, &met, c);
    w->brought = vmul(w->throughput, Le);
    w->ended = true;
    if (!met || w->bounces == p->depth) return true;
    if (naive_black(x.m)) {
        c->black++;
        if (!p->spend_all) return true;
    }
    vec3 wo = vneg(w->bounces ? w->r.d : vunit(w->r.d));
    if (!naive_direction(p, &x, wo, sampler_pair(s), &w->r, &weight)) return true;
    w->throughput = naive_through(w->throughput, weight);
    w->ended = vzero(w->throughput) && !p->spend_all;
    return true;
}

static inline vec3 naive_radiance(const naive_path *p, ray eye, sampler *s, naive_counts *c)
{
    vec3 L = {0, 0, 0};
    for (naive_walk w = naive_start(p, eye); naive_next(p, &w, s, c);) L = vadd(L, w.brought);
    return L;
}

#endif
