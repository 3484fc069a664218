/* naive_path.h: one path (路径), one direction at each hit: the notes' shade() with N = 1.
 *
 *   eye ---> x0 ---> x1 ---> x2 ...    w_j = f cos / pdf of the direction drawn at x_j      (25.7)
 *        E     w0 E    w0 w1 E         throughput (路径吞吐量) of k bounces: w_0 w_1 ... w_(k-1)
 *
 *   naive_path p = {&scene, DIRECTIONS_BRDF, depth, false};
 *   vec3 L = naive_radiance(&p, eye, &s, &counts);   s: sampler (20), a pair a bounce; counts: {0}
 *   vec3 L = naive_terms(&p, eye, &s, term, &counts);   and a sample of each K^k E: term[k], all 0
 *                                                       at first; NULL: nobody asks
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

/* ---------------------------------------------------------------------------------------------- */

static inline bool naive_dark(const lit_scene *s) { return !s->emitters && vzero(s->background); }

static inline bool naive_black(const lit_hit *x) { return brdf_is_black(x->f); }

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
    bool some = !naive_black(x)
             && reflection_direction(p->choice, x->f, f, to_local(f, wo), u, &wi, weight)
             && vdot(x->s.n, wi) > 0;
    if (!some) {
        if (!p->spend_all) return false;
        *weight = (vec3){0, 0, 0};
        wi = to_world(f, sample_cosine(u.u, u.v));
    }
    *next = leave(x->s, wi);
    return true;
}

static inline vec3 naive_terms(const naive_path *p, ray r, sampler *s, vec3 *term,
                               naive_counts *c)
{
    vec3 L = {0, 0, 0}, through = {1, 1, 1}, weight;
    if (naive_dark(p->scene) && !p->spend_all) return L;
    for (int k = 0;; k++) {
        lit_hit x = {.m = NULL};
        bool met;
        vec3 brought = vmul(through, naive_find(p, r, k, &x, &met, c));
        L = vadd(L, brought);
        if (term) term[k] = brought;
        if (!met || k == p->depth) return L;
        bool black = naive_black(&x);
        c->black += black;
        if (black && !p->spend_all) return L;
        vec3 wo = vneg(k ? r.d : vunit(r.d));
        if (!naive_direction(p, &x, wo, sampler_pair(s), &r, &weight)) return L;
        through = naive_through(through, weight);
        if (vzero(through) && !p->spend_all) return L;
    }
}

static inline vec3 naive_radiance(const naive_path *p, ray eye, sampler *s, naive_counts *c)
{
    return naive_terms(p, eye, s, NULL, c);
}

#endif
