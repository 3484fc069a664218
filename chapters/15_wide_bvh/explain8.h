/* explain8.h: why did a search not find a hit? For those who change this tree.
 *
 *   bvh8_explain(&w, r, due, out)     due: the hit that is missing; a few lines to `out`
 *
 * It goes from the root to the leaf that lists the shape, and names the first box on the way that
 * does not hold the point of the hit, or that the box test lets the ray miss. If there is none, the
 * order of the search, its limit or the test in the leaf is wrong.
 */
#ifndef WIDE_EXPLAIN8_H
#define WIDE_EXPLAIN8_H

#include "bvh8.h"
#include <stdio.h>

typedef struct { uint32_t node; int lane; } bvh8_step;
enum { bvh8_most_steps = 65 };

/* ---------------------------------------------------------------------------------------------- */

static inline bool bvh8_lists(const bvh8 *w, uint32_t leaf, uint32_t wanted)
{
    const uint32_t *index = w->block ? w->block[leaf].index : w->list[leaf].index;
    for (int k = 0; k < 8; k++)
        if (index[k] == wanted) return true;
    return false;
}

/* Fills path[0 .. depth - 1] with the way from node `at` to the leaf that lists the shape; returns
 * its length, 0: there is none. */
static inline int bvh8_path(const bvh8 *w, uint32_t wanted, uint32_t at, int depth, bvh8_step *path)
{
    const bvh8_node *n = &w->node[at];
    for (int k = 0; k < 8 && depth < bvh8_most_steps; k++) {
        uint32_t child = n->child[k];
        if (n->side[0][k] > n->side[3][k]) continue;
        path[depth] = (bvh8_step){at, k};
        int length = child & bvh8_leaf
            ? bvh8_lists(w, child & ~bvh8_leaf, wanted) ? depth + 1 : 0
            : bvh8_path(w, wanted, child, depth + 1, path);
        if (length) return length;
    }
    return 0;
}

/* By how much p, in the frame, sticks out of the box; negative inside. */
static inline real bvh8_outside(const bvh8_node *n, int k, vec3 p)
{
    real out = -real_infinity;
    for (int a = 0; a < 3; a++) {
        out = real_max(out, (real)n->side[a][k] - vaxis(p, a));
        out = real_max(out, vaxis(p, a) - (real)n->side[3 + a][k]);
    }
    return out;
}

static inline void bvh8_explain_box(const bvh8 *w, bvh8_step at, real outside, bool holds,
                                    FILE *out)
{
    const eight *side = w->node[at.node].side;
    int k = at.lane;
    vec3 lo = bvh8_back(w, side[0][k], side[1][k], side[2][k]);
    vec3 hi = bvh8_back(w, side[3][k], side[4][k], side[5][k]);
    fprintf(out, "  child %d of node %u is skipped: its box, x %g..%g, y %g..%g, z %g..%g, ", k,
            at.node, (double)lo.x, (double)hi.x, (double)lo.y, (double)hi.y, (double)lo.z,
            (double)hi.z);
    if (holds)
        fprintf(out, "holds the point of the hit, but the box test says the ray misses it\n");
    else fprintf(out, "does not hold the point of the hit, which is %g outside\n",
                 (double)(outside / w->scale));
}

static inline void bvh8_explain(const bvh8 *w, ray r, hit due, FILE *out)
{
    bvh8_step path[bvh8_most_steps];
    if (w->nodes == 0 || due.shape == no_shape) return;
    int length = bvh8_path(w, due.shape, 0, 0, path);
    if (length == 0) {
        fprintf(out, "  shape %u is in no leaf of the tree\n", due.shape);
        return;
    }
    bvh8_ray q;
    bvh8_ray_of(w, &r, false, &q);
    vec3 p = bvh8_into(w, ray_at(r, due.t)), o = bvh8_into(w, r.o);
    real delta = (real_max(fabs(vaxis(o, vlongest(o))), 1)) * ((real)0x1p-20 + 512 * real_epsilon);
    fprintf(out, "  shape %u is in a leaf; children on the way, as node.child:", due.shape);
    for (int i = 0; i < length; i++) fprintf(out, " %u.%d", path[i].node, path[i].lane);
    fprintf(out, "\n");
    for (int i = 0; i < length; i++) {
        eight enter;
        const bvh8_node *n = &w->node[path[i].node];
        unsigned met = bvh8_boxes_0(n, &q, bvh8_limit(&q, due.t), &enter);
        real outside = bvh8_outside(n, path[i].lane, p);
        if (outside > delta || !(met >> path[i].lane & 1)) {
            bvh8_explain_box(w, path[i], outside, outside <= delta, out);
            return;
        }
    }
    fprintf(out, "  all these boxes hold the point and are met by the ray: the order of the "
                 "search, its limit or its stack drops one, or the leaf's test is wrong\n");
}

#endif
