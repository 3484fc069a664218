/* explain.h: why did a search not find a hit? For those who change a structure.
 *
 *   explain_wrong(c, s, &x, &w, oracle, out)    the ray, what it should hit and what it did; and:
 *
 *   explain_window(c, s, &w, out)      any structure, knowing nothing of it but its verbs:
 *
 *        tmin                due.t           shortens the ray's interval (光线间隔) round the hit
 *          |---------[---------x-]-----|     until it is found, and finds by halving where the
 *                    a           b           interval must begin and end to lose it: there, on
 *                                            the ray, the search takes the wrong turn
 *
 *   explain_shape(&x, &w, out)         how far the point of the hit lies out of the shape's own
 *                                      box: boxes that are not widened by that lose it
 *   an explainer                       of structures that explain_cells.h knows: which box or cell
 *                                      holds the point, and whether the shape is listed there
 *
 * All write a few lines to `out`. explain_bvh walks from the root to the leaf that has the shape,
 * and names the first node that keeps the ray out; explain_bvh8 asks 15 for the same.
 */
#ifndef COMPARE_EXPLAIN_H
#define COMPARE_EXPLAIN_H

#include "../../15_wide_bvh/explain8.h"
#include "../proof.h"
#include <stdio.h>

typedef void explainer(const void *s, const wrong_answer *w, FILE *out);

/* ---------------------------------------------------------------------------------------------- */

/* On the interval [a, b]. */
static inline bool window_finds(const contender *c, const void *s, const wrong_answer *w, real a,
                                real b)
{
    ray r = w->r;
    hit h = hit_none;
    r.tmin = a, r.tmax = b;
    return w->any ? c->occluded(s, r) : c->hit(s, r, &h) && hits_same(h, w->due);
}

/* Halves between `found`, an end with which the hit is found, and `lost`. The other end stays at
 * the hit. */
static inline void window_halve(const contender *c, const void *s,
                                const wrong_answer *w, real *found, real *lost)
{
    real t = w->due.t;
    for (int k = 0; k < 200; k++) {
        real middle = *found + (*lost - *found) / 2;
        if (middle == *found || middle == *lost) return;
        bool ok = middle < t ? window_finds(c, s, w, middle, t) : window_finds(c, s, w, t, middle);
        *(ok ? found : lost) = middle;
    }
}

static inline void explain_end(const contender *c, const void *s, const wrong_answer *w, real end,
                               const char *which, FILE *out)
{
    real found = w->due.t, lost = end;
    if (!(fabs(lost) <= real_largest)) lost = lost < 0 ? -4 * fabs(found) - 1 : 4 * fabs(found) + 1;
    bool whole = end < w->due.t ? window_finds(c, s, w, lost, w->due.t)
                                : window_finds(c, s, w, w->due.t, lost);
    if (whole) return;
    window_halve(c, s, w, &found, &lost);
    vec3 p = ray_at(w->r, lost);
    fprintf(out, "  found if the interval %s at t = %.17g, lost if at t = %.17g, which is at "
                 "(%.9g, %.9g, %.9g)\n", which, (double)found, (double)lost, (double)p.x,
            (double)p.y, (double)p.z);
}

static inline void explain_window(const contender *c, const void *s, const wrong_answer *w,
                                  FILE *out)
{
    real t = w->due.t;
    if (w->due.shape == no_shape) {
        fprintf(out, "  it reports a hit that does not exist: a test or its interval is wrong\n");
        return;
    }
    if (!w->any && w->got.shape != no_shape && w->got.t <= t)
        fprintf(out, w->got.t < t ? "  nearer than any shape is: its test or its number is wrong\n"
                                  : "  at the same t: there the lower index must win\n");
    if (!window_finds(c, s, w, t, t)) {
        fprintf(out, "  not found on the interval [t, t] either: the place of the hit is not "
                     "searched, or the shape is not listed there\n");
        return;
    }
    fprintf(out, "  found on the interval [t, t] alone: the shape is listed where it is hit, and "
                 "the way there is lost\n");
    explain_end(c, s, w, w->r.tmin, "begins", out);
    explain_end(c, s, w, w->r.tmax, "ends", out);
    if (window_finds(c, s, w, w->r.tmin, t))
        fprintf(out, "  found on [tmin, t]: it is lost to what lies beyond it\n");
}

/* The shape's own box holds the point, but for rounding. */
static inline void explain_shape(const items *x, const wrong_answer *w, FILE *out)
{
    aabb b;
    if (w->due.shape == no_shape || !items_bounds(x, w->due.shape, &b)) return;
    vec3 p = ray_at(w->r, w->due.t), under = vsub(b.lo, p), over = vsub(p, b.hi);
    vec3 outside = vmax(vmax(under, over), (vec3){0, 0, 0});
    real far = vaxis(outside, vlongest(outside));
    fprintf(out, "  shape %u itself: x %.9g..%.9g, y %.9g..%.9g, z %.9g..%.9g; the point of the "
                 "hit is ", w->due.shape, (double)b.lo.x, (double)b.hi.x, (double)b.lo.y,
            (double)b.hi.y, (double)b.lo.z, (double)b.hi.z);
    if (far > 0) fprintf(out, "%.3g outside: a box must be wider than that\n", (double)far);
    else fprintf(out, "inside\n");
}

/* The tree of boxes. --------------------------------------------------------------------------- */

/* Fills path[0..depth] with the nodes from the root to the leaf that holds place k of the items;
 * returns the depth, or -1. */
static inline int bvh_path(const bvh_tree *t, uint32_t at, size_t k, int depth, uint32_t *path)
{
    const bvh_node *n = &t->node[at];
    path[depth] = at;
    if (n->count) return k >= n->first && k - n->first < n->count ? depth : -1;
    for (uint32_t child = n->first; depth < bvh_most_depth && child < n->first + 2; child++) {
        int found = bvh_path(t, child, k, depth + 1, path);
        if (found >= 0) return found;
    }
    return -1;
}

/* By how much p sticks out of the box [scene units]; negative inside. */
static inline real bvh_outside(const bvh_box *b, vec3 p)
{
    real out = -real_infinity;
    for (int k = 0; k < 3; k++) {
        out = real_max(out, (real)b->side[k] - vaxis(p, k));
        out = real_max(out, vaxis(p, k) - (real)b->side[3 + k]);
    }
    return out;
}

/* The way to the leaf that lists the shape, of several the first whose box holds p; -1: none. */
static inline int bvh_leaf_of(const bvh *b, uint32_t wanted, vec3 p, real delta,
                              uint32_t *path)
{
    const bvh_tree *t = bvh_tree_of(b);
    int depth = -1;
    for (size_t k = 0; k < t->items; k++) {
        if (bvh_item_at(b, k) != wanted) continue;
        depth = bvh_path(t, 0, k, 0, path);
        if (depth >= 0 && bvh_outside(&t->node[path[depth]].box, p) <= delta) return depth;
    }
    return depth;
}

static inline void explain_box(uint32_t node, const bvh_box *box, vec3 p, bool holds, FILE *out)
{
    fprintf(out, "  node %u is skipped: its box, x %g..%g, y %g..%g, z %g..%g, ", node,
            (double)box->side[0], (double)box->side[3], (double)box->side[1], (double)box->side[4],
            (double)box->side[2], (double)box->side[5]);
    if (holds)
        fprintf(out, "holds the point of the hit, but the box test says the ray misses it\n");
    else fprintf(out, "does not hold the point of the hit, which is %g outside\n",
                 (double)bvh_outside(box, p));
}

static inline void explain_bvh(const void *s, const wrong_answer *w, FILE *out)
{
    const bvh *b = s;
    const bvh_tree *t = bvh_tree_of(b);
    uint32_t path[bvh_most_depth + 1];
    if (t->items == 0) return;
    box_ray q = box_ray_of(w->r, &t->node[0].box, NULL);
    real delta = box_reach(&t->node[0].box, w->r.o) * 512 * real_epsilon;
    vec3 p = ray_at(w->r, w->due.t);
    int depth = bvh_leaf_of(b, w->due.shape, p, delta, path);
    if (depth < 0) {
        fprintf(out, "  shape %u is in no leaf of the tree\n", w->due.shape);
        return;
    }
    fprintf(out, "  shape %u is in node %u, a leaf at depth %d; nodes on the way:", w->due.shape,
            path[depth], depth);
    for (int i = 0; i <= depth; i++) fprintf(out, " %u", path[i]);
    fprintf(out, "\n");
    for (int i = 0; i <= depth; i++) {
        const bvh_box *box = &t->node[path[i]].box;
        float exit, enter = box_enter(box, &q, box_ray_limit(&q, w->due.t), &exit);
        bool holds = bvh_outside(box, p) <= delta, met = !(enter > exit);
        if (!holds || !met) {
            explain_box(path[i], box, p, holds, out);
            return;
        }
    }
    fprintf(out, "  all these boxes hold the point and are met by the ray: the order of the "
                 "search, its limit or its stack drops one, or the leaf's test is wrong\n");
}

/* Eight wide. ---------------------------------------------------------------------------------- */

static inline void explain_bvh8(const void *s, const wrong_answer *x, FILE *out)
{
    bvh8_explain(s, x->r, x->due, out);
}

#endif
