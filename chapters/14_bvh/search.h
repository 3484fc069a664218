/* search.h: searching the tree for the closest hit, or for any.
 *
 *   bool tree_search(&t, r, box_ray_of, leaf, context, any, &h, &work)
 *       leaf      tests the items of a leaf: see below
 *       context   handed to box_ray_of, which has no use for it, and to leaf
 *       any       true: ends at the first hit (遮挡); h is not touched
 *       work      counts what was done, a pair of boxes as a node; NULL: does not count
 *
 * Both children of a node are tested at once. If the ray meets both, the one that it enters first
 * is next, and the other waits on the stack with its t of entry: by the time it comes up a hit may
 * have been found before it, and it is dropped unseen.
 *
 *   the rule of hit.h, and what it asks of a search:
 *   equal t, the lower index wins      a box that begins at t_enter = tmax is still looked into:
 *                                      it may hold the lower index; dropped only if t_enter > tmax
 *   the same hit as brute force        boxes err to the large side only: node.h
 *
 * An empty tree, and a ray with a NaN, an infinite origin or no direction, hit nothing.
 */
#ifndef BVH_SEARCH_H
#define BVH_SEARCH_H

#include "../07_mesh/closest.h"
#include "tree.h"

/* box_ray_of; box_ray_naive, which loses hits; or what pays for more errors than node.h counts. */
typedef box_ray tree_prepare(ray r, const bvh_box *all, const void *context);

/* Tests items first .. first + count - 1; true if one was closer than q->best (any: was hit at
 * all). */
typedef bool tree_leaf(const void *context, uint32_t first, uint32_t count, query *q,
                       bool any);

/* ---------------------------------------------------------------------------------------------- */

typedef struct { uint32_t first, count; float enter; } tree_waiting;

/* nearest: the child that is entered first is next; false: always the first, for comparison.
 * `leaf`, `any`, `nearest` are known where this is called: each call becomes a loop of its own.
 * Which child is nearer is chosen by branches: half of the guesses are wrong, but with the others
 * the processor is already in the next node. Without them (an index from the comparison) it has to
 * wait at every node, and a ray takes a third longer. */
fast_inline bool tree_search_by(const bvh_tree *t, ray r, tree_prepare *prepare, tree_leaf *leaf,
                                const void *context, bool any, bool nearest, hit *out,
                                search_work *work)
{
    tree_waiting stack[bvh_most_depth];
    int top = 0;
    float exit0, exit1;
    const bvh_node *node = t->node;
    if (t->items == 0 || !ray_is_usable(r)) return false;
    query q = query_of(r);
    box_ray b = prepare(r, node, context);
    float limit = box_ray_limit(&b, r.tmax);
    if (box_enter(node, &b, limit, &exit0) > exit0) return false;
    uint32_t first = node[0].first, count = node[0].count;
    for (;;) {
        if (count == 0) {
            const bvh_node *c = node + first;
            float enter0 = box_enter(&c[0], &b, limit, &exit0);
            float enter1 = box_enter(&c[1], &b, limit, &exit1);
            bool in0 = !(enter0 > exit0), in1 = !(enter1 > exit1);
            if (work) work->nodes++;
            if (in0) {
                if (in1 && nearest && enter1 < enter0) {
                    stack[top++] = (tree_waiting){c[0].first, c[0].count, enter0};
                    first = c[1].first, count = c[1].count;
                    continue;
                }
                if (in1) stack[top++] = (tree_waiting){c[1].first, c[1].count, enter1};
                first = c[0].first, count = c[0].count;
                continue;
            }
            if (in1) {
                first = c[1].first, count = c[1].count;
                continue;
            }
        } else {
            bool found = leaf(context, first, count, &q, any);
            if (work) work->leaves++, work->tests += count;
            if (found && any) return true;
            if (found) limit = box_ray_limit(&b, q.r.tmax);
        }
        do {
            if (top == 0) return query_answer(&q, out);
            top--;
        } while (stack[top].enter > limit);
        first = stack[top].first, count = stack[top].count;
    }
}

fast_inline bool tree_search(const bvh_tree *t, ray r, tree_prepare *prepare, tree_leaf *leaf,
                             const void *context, bool any, hit *out, search_work *work)
{
    return tree_search_by(t, r, prepare, leaf, context, any, true, out, work);
}

#endif
