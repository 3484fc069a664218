/* kdtree.h: the k-d tree (KD 树): a plane across an axis cuts space in two, and each part again
 *
 *     +-----+-------------+       kdtree t;
 *     |     |       o     |       if (!kdtree_build(&x, kdtree_defaults, &t, &f)) fail(f);
 *     |  o  +------+------+
 *     |     |      |  o   |       bool kdtree_hit(&t, r, &h), ..    the verbs of structure.h (09)
 *     +-----+  o   |      |
 *     |  o  |      |  o   |
 *     +-----+------+------+
 *
 * Cells do not overlap, so a ray passes them in order, and its search can end at the first hit. The
 * price: an item that a plane cuts is in both parts.
 *
 * How: kdtree_options in split.h.
 *
 * The items must outlive the tree. Total: 8 bytes a node, 16 a reference to a triangle (its corners
 * and number, in the order of the leaves), 4 a reference to a shape. A search needs no memory but
 * 64 places of a stack: no tree is deeper.
 *
 *   input                                      answer
 *   no items                                   never hit
 *   a corner with NaN or infinity              never hit; not in the tree
 *   a million triangles on one place           few cuts, since they do not pay; lowest index wins
 *   coordinates beyond 1e75 (float: 1e9)       refused with a message
 *
 * The search, front to back:
 *
 *   bool kd_search(&t, r, pads, of_mesh, any, &h, &work)   pads: 1; 0: no delta, loses hits. These
 *                                 three are known where it is called: each call becomes a loop of
 *                                 its own
 *
 *          |  near  :  far            At a cut the ray has the part [enter, exit] in the cell, and
 *      ----+--------:--------+---     passes the plane within [t0, t1] (12.6):
 *        enter   t0 : t1    exit
 *                                      exit < t0     near child only                       (12.4)
 *                                      enter > t1    far child only
 *                                      else          near with [enter, t1], far with [t0, exit]
 *                                                                                          (12.5)
 *
 * Both, also where the plane is passed just at enter or just at exit: a ray in a plane, or through
 * a corner of cells, looks into all cells that it touches. But not into an empty child: kd_full.
 *
 * What is found in a leaf may lie beyond its cell, and something nearer in a cell to come: the hit
 * is kept as the best so far, and is final when the next part begins beyond it: enter > tmax. Not
 * when enter = tmax: there the lower index may wait.
 *
 * No mailbox: an item is in many cells, but a ray meets it in few of them. One test in ten or so is
 * the second of the same triangle, and to notice costs as much.
 *
 * Sources: J. L. Bentley, "Multidimensional Binary Search Trees Used for Associative Searching",
 * CACM 18(9), 1975; M. Kaplan, "Space-Tracing: a Constant Time Ray-Tracer", SIGGRAPH 1985 notes;
 * F. Jansen, "Data Structures for Ray Tracing", 1986; V. Havran, PhD thesis, Prague 2000; I. Wald,
 * "Realtime Ray Tracing and Interactive Global Illumination", PhD thesis, Saarbrücken 2004, ch. 7.
 */
#ifndef KDTREE_H
#define KDTREE_H

#include "build.h"

/* By measurement: of 22 pairs of item cost and bonus these took the least time, on four scenes with
 * primary, diffuse and shadow rays. See the README. */
#define kdtree_item_cost 0.25
#define kdtree_empty_bonus 0.1
#define kdtree_defaults \
    ((kdtree_options){KD_SAH, 0, 0, kdtree_item_cost, kdtree_empty_bonus, true, KD_THICK, \
                      SIZE_MAX / 4})

/* ---------------------------------------------------------------------------------------------- */

typedef struct { const kd_node *node; float enter, exit; } kd_waiting;

fast_inline bool kd_ask_triangle(const kdtree *t, const kd_triangle *tri, query *q, bool any)
{
    const vec3 *a = t->v + tri->corner[0], *b = t->v + tri->corner[1], *c = t->v + tri->corner[2];
    hit h;
    if (!triangle_hit_corners(a, b, c, &q->shear, q->r, &h)) return false;
    h.shape = tri->index;
    return any || query_improves(q, h);
}

/* Tests the items of a leaf; true if one was closer than the best so far (any: was hit at all). */
fast_inline bool kd_ask(const kdtree *t, kd_node n, query *q, bool of_mesh, bool any)
{
    bool found = false;
    for (size_t i = n.first, end = i + kd_count(n); i < end; i++) {
        if (of_mesh ? !kd_ask_triangle(t, t->triangle + i, q, any)
                    : !query_ask(q, &t->x, t->index[i], any)) continue;
        if (any) return true;
        found = true;
    }
    return found;
}

/* Branches, although each is a coin toss: without them every step waits for the one before. The far
 * child is asked for first, since it is the rarer: one branch less for most steps. */
fast_inline bool kd_search(const kdtree *t, ray r, int pads, bool of_mesh, bool any, hit *out,
                           search_work *w)
{
    kd_waiting stack[kdtree_most_depth];
    int top = 0;
    if (t->stats.items == 0 || !ray_is_usable(r)) return false;
    query q = query_of(r);
    kd_ray k;
    kd_ray_of(r, &t->frame, &t->box, pads, &k);
    float enter = k.enter, exit = k.exit, limit = kd_ray_limit(&k, r.tmax);
    if (enter > exit) return false;
    kd_node n = t->node[0];
    for (;;) {
        if (!kd_is_leaf(n)) {  /* (12.4); a NaN leads to both */
            size_t x = n.bits & 3, near = k.second[x], far = 1 - near;
            float t0 = (n.plane - k.o_near[x]) * k.inverse[x];
            float t1 = pads ? (n.plane - k.o_far[x]) * k.inverse[x] : t0;
            const kd_node *child = t->node + kd_lower(n);
            if (w) w->nodes++;
            if (kd_full(n, far) && !(t0 > exit)) {
                if (kd_full(n, near) && !(t1 < enter)) {
                    stack[top++] = (kd_waiting){child + far, float_max(t0, enter), exit};
                    exit = float_min(t1, exit), n = child[near];
                } else enter = float_max(t0, enter), n = child[far];
                continue;
            }
            if (kd_full(n, near) && !(t1 < enter)) {
                exit = float_min(t1, exit), n = child[near];
                continue;
            }
        } else {
            if (w) w->leaves++, w->tests += kd_count(n);
            if (kd_ask(t, n, &q, of_mesh, any)) {
                if (any) return true;
                limit = kd_ray_limit(&k, q.r.tmax);
            }
        }
        do {
            if (top == 0) return query_answer(&q, out);
            top--;
        } while (stack[top].enter > limit);
        n = *stack[top].node;
        enter = stack[top].enter, exit = float_min(stack[top].exit, limit);
    }
}

fast_inline bool kdtree_search(const kdtree *t, ray r, bool any, hit *out, search_work *work)
{
    return t->x.m ? kd_search(t, r, 1, true, any, out, work)
                  : kd_search(t, r, 1, false, any, out, work);
}

STRUCTURE_VERBS(kdtree)

static inline structure_stats kdtree_stats(const kdtree *t) { return t->stats; }

#endif
