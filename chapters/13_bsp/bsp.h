/* bsp.h: the BSP tree (二叉空间划分, binary space partitioning) of items, for rays: planes of any
 * direction cut space into convex cells.
 *
 *   bsp b;
 *   bool bsp_build(&x, bsp_defaults, &b, &f)     its mesh or scene must outlive the tree
 *   bool bsp_hit(&b, r, &h), ..                  the verbs of structure.h (09)
 *
 * `how` and the naive ways to build: tree.h.
 *
 * The search goes front to back. The ray's t at a plane decides how long it stays on this side;
 * `pad` makes both sides last longer:
 *
 *      a = at - n.o,  c = n.d      this side while  t <= (a + pad) / c       (c > 0; if c < 0,
 *                                  the other from   t >= (a - pad) / c       -a and -c)     (13.3)
 *
 * A ray in the plane or along it, c = 0, is no case of its own: these t are +-infinity or NaN, and
 * the comparisons let a NaN through.
 *
 * Why nothing is lost, in units of eps D, with D of (10.1), so that size <= D:
 *   443   a hit lies within 256 of its item along each axis, so within sqrt 3 times that along n
 *   358   points of the item that belong to a leaf lie up to e + r = 192 + 166 beyond its planes
 *    25   o - middle, a, c and t are rounded; c is off by 2.6 eps |d|, and t c by that times t |d|
 * Together less than 2 delta = 1024: the pad. Items are not cut: fragments only tell which leaves
 * name them. So a hit is brute force's to the last bit.
 */
#ifndef BSP_H
#define BSP_H

#include "tree.h"

/* ---------------------------------------------------------------------------------------------- */

/* o relative to the middle; d scaled so that its longest component is within 2^+-20. */
typedef struct {
    vec3 o, d, inverse;  /* 1 / |d_k| */
    int down[3];         /* d_k < 0 */
    real pad, scale, slack, t0, t1;
} bsp_ray;

typedef struct { uint32_t at; real t0, t1; } bsp_waiting;

static inline real bsp_limit(const bsp_ray *b, real t) { return t * b->scale + b->slack; }

/* False if the ray passes by the box of all. t of hits below real_smallest has fewer digits than
 * eps says: hence the slack. */
static inline bool bsp_ray_of(const bsp *b, ray r, real pads, bsp_ray *out)
{
    real longest = vlargest(r.d), delta = query_delta(r, b->all);
    out->scale = direction_scale(longest), out->slack = real_smallest * out->scale;
    if (out->scale != 1) r.d = vscale(r.d, 1 / out->scale);
    out->o = vsub(r.o, b->middle), out->d = r.d;
    out->pad = pads * delta;
    out->t0 = r.tmin * out->scale - out->slack, out->t1 = bsp_limit(out, r.tmax);
    for (int k = 0; k < 3; k++) {
        real o = vaxis(out->o, k), d = vaxis(out->d, k), h = vaxis(b->half, k) + 2 * delta;
        real i = 1 / fabs(d), a = d < 0 ? o : -o;
        ((real *)&out->inverse)[k] = i, out->down[k] = d < 0;
        out->t0 = real_max((a - h) * i, out->t0);
        out->t1 = real_min((a + h) * i, out->t1);
    }
    return !(out->t0 > out->t1);  /* a NaN in tmin or tmax: no item is hit, see 01 */
}

/* pads: 2, of delta; 0 is the naive one. first: ends at the first leaf with a hit. */
fast_inline bool bsp_walk(const bsp *b, ray r, real pads, bool any, bool first_leaf, hit *out,
                          search_work *work)
{
    bsp_waiting stack[bsp_most_depth + 1];
    int top = 0;
    bsp_ray s;
    if (b->stats.items == 0 || !ray_is_usable(r) || !bsp_ray_of(b, r, pads, &s)) return false;
    query q = query_of(r);
    real t0 = s.t0, t1 = s.t1, limit = t1;
    uint32_t at = 0;
    for (;;) {
        const bsp_node *n = &b->node[at];
        if (!(n->kind & bsp_leaf_bit)) {
            real a, i;
            uint32_t down;
            if (n->kind < 3) {
                down = (uint32_t)s.down[n->kind];
                a = n->at - vaxis(s.o, (int)n->kind), i = vaxis(s.inverse, (int)n->kind);
            } else {
                const vec3 *m = &b->normal[n->kind & ~bsp_slanted_bit];
                real c = vdot(*m, s.d);
                down = c < 0;
                a = n->at - vdot(*m, s.o), i = 1 / fabs(c);
            }
            a = down ? -a : a;
            real leave = (a + s.pad) * i, enter = (a - s.pad) * i;  /* (13.3) */
            bool here = !(leave < t0), there = !(enter > t1);
            if (work) work->nodes++;
            stack[top].at = n->first + !down;
            stack[top].t0 = real_max(enter, t0), stack[top].t1 = t1;
            top += here & there;
            at = n->first + (here ? down : !down);
            t1 = real_min(here ? leave : t1, t1);  /* if only one side is left, t0 and t1 stay */
            continue;
        }
        uint32_t count = n->kind & ~bsp_leaf_bit;
        const uint32_t *item = b->reference + n->first, *end = item + count;
        if (work) work->leaves++, work->empty += count == 0, work->tests += count;
        for (; item < end; item++)
            if (query_ask(&q, &b->x, *item, any) && any) return true;
        if (q.best.shape != no_shape) {
            if (first_leaf) break;
            limit = bsp_limit(&s, q.r.tmax);
        }
        do {
            if (top == 0) return query_answer(&q, out);
            top--;
        } while (stack[top].t0 > limit);
        at = stack[top].at, t0 = stack[top].t0, t1 = real_min(stack[top].t1, limit);
    }
    return query_answer(&q, out);
}

fast_inline bool bsp_search(const bsp *b, ray r, bool any, hit *out, search_work *work)
{
    return bsp_walk(b, r, 2, any, false, out, work);
}

STRUCTURE_VERBS(bsp)

#endif
