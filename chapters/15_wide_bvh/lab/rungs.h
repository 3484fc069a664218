/* rungs.h: what each step from 14's search to walk.h gains: searches of the same tree that do less
 * at once. All are right: boxes are conservative, and triangles asked in `real`.
 *
 *   bool bvh8_hit_one(&w, r, &h)        box after box, triangle after triangle
 *   bool bvh8_hit_any_order(&w, r, &h)  eight boxes at once; children in the order of the node
 *   bool bvh8_hit_boxes(&w, r, &h)      the nearest child first
 */
#ifndef WIDE_RUNGS_H
#define WIDE_RUNGS_H

#include "../bvh8.h"

/* ---------------------------------------------------------------------------------------------- */

/* One box: what bvh8_boxes does in a lane. */
static inline bool rung_box(const bvh8_node *n, int k, const bvh8_ray *q, float *enter)
{
    const float *from = &n->side[0][k];
    float begin = q->tmin, end = q->limit;
    for (int a = 0; a < 3; a++) {
        float t0 = from[q->near[a] / (int)sizeof *from] * q->inverse[a] + q->near_o[a];
        float t1 = from[q->far[a] / (int)sizeof *from] * q->inverse[a] + q->far_o[a];
        begin = float_max(t0, begin), end = float_min(t1, end);
    }
    *enter = begin;
    return begin <= end;
}

static inline eight_set rung_boxes(const bvh8_node *n, const bvh8_ray *q, bool at_once,
                                   eight *enter)
{
    eight_set mask = 0;
    if (at_once) return bvh8_boxes_0(n, q, enter);
    for (int k = 0; k < 8; k++)
        mask |= (eight_set)rung_box(n, k, q, (float *)enter + k) << 8 * k;
    return mask;
}

typedef struct { uint32_t child; float enter; } rung_waiting;

fast_inline bool rung_walk(const bvh8 *w, ray r, hit *out, bool at_once, bool nearest)
{
    rung_waiting stack[bvh8_stack];
    int top = 1;
    query ask = query_of(r);
    bvh8_ray q;
    if (w->nodes == 0 || !bvh8_ray_of(w, &r, &bvh8_skip_none, &q)) return false;
    eight from;
    const float *enter = (const float *)&from;
    stack[0] = (rung_waiting){0, -INFINITY};
    while (top > 0) {
        rung_waiting now = stack[--top];
        if (now.enter > q.limit) continue;
        if (now.child & bvh8_leaf) {
            const bvh8_block *b = &w->block[now.child & ~bvh8_leaf];
            for (int k = 0; k < 8 && b->index[k] != no_shape; k++)  /* one by one, in `real` */
                query_ask(&ask, &w->x, b->index[k], false);
            q.limit = bvh8_limit(&q, ask.r.tmax);
            continue;
        }
        const bvh8_node *n = &w->node[now.child];
        eight_set mask = rung_boxes(n, &q, at_once, &from);
        for (int base = top; mask; mask &= mask - 1) {
            int k = __builtin_ctzll(mask) / 8, j = top++;
            for (; nearest && j > base && stack[j - 1].enter < enter[k]; j--)
                stack[j] = stack[j - 1];
            stack[j] = (rung_waiting){n->child[k], enter[k]};
        }
    }
    return query_answer(&ask, out);
}

static inline bool bvh8_hit_one(const bvh8 *w, ray r, hit *out)
{
    return rung_walk(w, r, out, false, true);
}

static inline bool bvh8_hit_any_order(const bvh8 *w, ray r, hit *out)
{
    return rung_walk(w, r, out, true, false);
}

static inline bool bvh8_hit_boxes(const bvh8 *w, ray r, hit *out)
{
    return rung_walk(w, r, out, true, true);
}

#endif
