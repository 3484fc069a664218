/* proof.h: is what a structure answers what brute force answers: the very hit, t, u, v and shape,
 * and the same "occluded"? If not, why? Of a structure nothing is known here but its verbs, and in
 * which of its boxes or cells a shape is listed (cells.h).
 *
 *   bool prove_ray(c, s, r, due, &w)      due: brute force's hit, or hit_none. False: w says where
 *   bool prove_closed(c, s, r, due, aimed_ways, &w)   the same, and again on [tmin, t] and [t, t],
 *                                         t that of the hit: the interval is closed, so both find
 *                                         it (17.10); one way: as it came
 *   explain_wrong(&w, &x, oracle, out)          the ray, what it should hit, and what it did; then:
 *        is it found on [t, t]? If not, how much longer must that be? And is the point of the hit
 *        in the shape's own box, and in the nearest of those that list the shape? A little outside:
 *        rounding, for which boxes must be wider. Farther off: the shape is not listed where it is
 *        hit. Inside, and yet not found: the search does not come there.
 *
 * Rays that end exactly at their hit find out what others do not: a search that drops a box that is
 * entered at t = tmax, or whose tmax was rounded down on the way, passes all other rays. And one
 * that forgets to scale t passes all whose direction is about as long as 1 (prove_stretched).
 */
#ifndef COMPARE_LAB_PROOF_H
#define COMPARE_LAB_PROOF_H

#include "../../09_aabb/trials/aimed.h"
#include "contenders.h"

typedef struct {
    const contender *c;
    const void *s;
    ray r;
    hit due, got;
    bool any;  /* asked was occluded(); got.shape is no_shape for "no" */
} wrong_answer;

/* ---------------------------------------------------------------------------------------------- */

static inline bool hits_same(hit a, hit b)
{
    return same(a.shape != no_shape, a, b.shape != no_shape, b);
}

static inline bool prove_ray(const contender *c, const void *s, ray r, hit due, wrong_answer *w)
{
    *w = (wrong_answer){c, s, r, due, hit_none, false};
    bool met = c->hit(s, r, &w->got);
    if (!met) w->got = hit_none;
    if (!hits_same(w->got, due)) return false;
    w->any = c->occluded(s, r) != met;
    if (w->any) w->got = met ? hit_none : (hit){0, 0, 0, 0};
    return !w->any;
}

static inline bool prove_closed(const contender *c, const void *s, ray r, hit due, int ways,
                                wrong_answer *w)
{
    if (due.shape == no_shape) ways = 1;
    for (int k = 0; k < ways; k++)
        if (!prove_ray(c, s, aimed_way(r, due.t, k), due, w)) return false;
    return true;
}

/* On the interval between a and b. */
static inline bool window_finds(const wrong_answer *w, real a, real b)
{
    ray r = w->r;
    hit h = hit_none;
    r.tmin = real_min(a, b), r.tmax = real_max(a, b);
    return w->any ? w->c->occluded(w->s, r) : w->c->hit(w->s, r, &h) && hits_same(h, w->due);
}

/* How much longer, both ways, the interval [t, t] must be for the hit to be found: between this and
 * half of it. 0: no length helps. */
static inline real window_wider(const wrong_answer *w)
{
    real t = w->due.t, most = fabs(t) + 1;
    for (real x = real_max(real_epsilon / 2 * fabs(t), real_smallest); x <= most; x *= 2)
        if (window_finds(w, t - x, t + x)) return x;
    return 0;
}

/* How much longer than [t, t] the interval must be: 0 if it is found there; infinity if no length
 * helps. */
static inline real explain_window(const wrong_answer *w, FILE *out)
{
    real t = w->due.t;
    if (!w->any && w->got.shape != no_shape && w->got.t <= t)
        fprintf(out, w->got.t < t ? "  nearer than any shape is: its test or its number is wrong\n"
                                  : "  at the same t: there the lower index must win\n");
    if (!window_finds(w, t, t)) {
        real wider = window_wider(w);
        if (wider > 0)
            fprintf(out, "  not found on the interval [t, t], but on one that reaches %.2g farther "
                    "both ways: a comparison with its end is strict, or something is rounded\n",
                    (double)wider);
        else fprintf(out, "  not found on the interval [t, t] either\n");
        return wider > 0 ? wider : real_infinity;
    }
    fprintf(out, "  found on the interval [t, t] alone: the way there is lost\n");
    if (window_finds(w, w->r.tmin, t))
        fprintf(out, "  found on [tmin, t]: it is lost to what lies beyond it\n");
    return 0;
}

static inline void print_place(FILE *out, item_cell c, const char *verdict)
{
    fprintf(out, "x %.9g..%.9g, y %.9g..%.9g, z %.9g..%.9g; the hit is ", (double)c.box.lo.x,
            (double)c.box.hi.x, (double)c.box.lo.y, (double)c.box.hi.y, (double)c.box.lo.z,
            (double)c.box.hi.z);
    if (c.outside > 0) fprintf(out, "%.3g outside%s\n", (double)c.outside, verdict);
    else fprintf(out, "%s%s\n", c.outside < 0 ? "inside" : "on its border", verdict);
}

/* What the nearest box or cell that lists the shape tells; known: there is one. p: the point of the
 * hit; wider: see explain_window. A search pays for twice query_delta at most (13.3). */
static inline const char *verdict_of(const wrong_answer *w, const items *x, item_cell c, bool known,
                                     vec3 p, real wider)
{
    aabb all;
    failure f;
    if (!items_all_bounds(x, &all, &f) || c.outside > 2 * query_delta(w->r, all))
        return aabb_contains(c.box, p) ? ", beyond a slanted wall: it is not listed where it is hit"
                                       : ": it is not listed where it is hit";
    if (wider == 0) return "";
    if (c.outside > 0) return ": the box must be wider than that";
    if (wider == real_infinity)
        return known ? ": listed there, but the search does not come there"
                     : ": not listed there, or the search does not come there";
    return c.outside < 0 ? "" : ": there a rounding loses it, if the box is no wider than that";
}

/* The shape's own box, and what lists it: once if they are the same. */
static inline void explain_shape(const items *x, const wrong_answer *w, real wider, FILE *out)
{
    aabb b;
    item_cell c = item_cell_none;
    uint32_t k = w->due.shape;
    vec3 p = ray_at(w->r, w->due.t);
    if (!items_bounds(x, k, &b)) return;
    item_cell own = item_cell_at(b, p);
    bool known = contender_cell(w->c, w->s, k, p, &c), listed = c.outside < real_infinity;
    bool alike = vzero(vsub(c.box.lo, b.lo)) && vzero(vsub(c.box.hi, b.hi));
    fprintf(out, "  shape %u itself%s: ", k, alike ? ", and the box that lists it" : "");
    if (alike || !known) {
        item_cell only = known ? c : own;
        print_place(out, only, verdict_of(w, x, only, known, p, wider));
        return;
    }
    print_place(out, own, "");
    fprintf(out, listed ? "  nearest box that lists it: " : "  it is listed nowhere\n");
    if (listed) print_place(out, c, verdict_of(w, x, c, known, p, wider));
}

static inline void print_hit(FILE *out, const char *who, hit h)
{
    if (h.shape == no_shape) fprintf(out, "  %s: no hit\n", who);
    else fprintf(out, "  %s: t = %.17g, u = %.17g, v = %.17g, shape %u\n", who, (double)h.t,
                 (double)h.u, (double)h.v, h.shape);
}

static inline void explain_wrong(const wrong_answer *w, const items *x, const char *oracle,
                                 FILE *out)
{
    const ray *r = &w->r;
    fprintf(out, "%s: wrong ray: o = (%.17g, %.17g, %.17g), d = (%.17g, %.17g, %.17g), "
                 "interval [%.17g, %.17g]\n", w->c->name, (double)r->o.x, (double)r->o.y,
            (double)r->o.z, (double)r->d.x, (double)r->d.y, (double)r->d.z, (double)r->tmin,
            (double)r->tmax);
    print_hit(out, oracle, w->due);
    if (!w->any) print_hit(out, w->c->name, w->got);
    else fprintf(out, "  %s: occluded: %s\n", w->c->name, w->got.shape == no_shape ? "no" : "yes");
    fflush(out);  /* what follows may take seconds */
    if (w->due.shape == no_shape) {
        fprintf(out, "  it reports a hit that does not exist: a test or its interval is wrong\n");
        return;
    }
    real wider = explain_window(w, out);
    explain_shape(x, w, wider, out);
}

#endif
