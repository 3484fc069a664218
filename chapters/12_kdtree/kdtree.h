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
 * Sources: J. L. Bentley, "Multidimensional Binary Search Trees Used for Associative Searching",
 * CACM 18(9), 1975; M. Kaplan, "Space-Tracing: a Constant Time Ray-Tracer", SIGGRAPH 1985 notes;
 * F. Jansen, "Data Structures for Ray Tracing", 1986; V. Havran, PhD thesis, Prague 2000; I. Wald,
 * "Realtime Ray Tracing and Interactive Global Illumination", PhD thesis, Saarbrücken 2004, ch. 7.
 */
#ifndef KDTREE_H
#define KDTREE_H

#include "search.h"

/* By measurement: of 22 pairs of item cost and bonus these took the least time, on four scenes with
 * primary, diffuse and shadow rays. See the README. */
#define kdtree_item_cost 0.25
#define kdtree_empty_bonus 0.1
#define kdtree_defaults \
    ((kdtree_options){KD_SAH, 0, 0, kdtree_item_cost, kdtree_empty_bonus, true, KD_THICK, \
                      SIZE_MAX / 4})

/* ---------------------------------------------------------------------------------------------- */

fast_inline bool kdtree_search(const kdtree *t, ray r, bool any, hit *out, search_work *work)
{
    return t->x.m ? kd_search(t, r, 1, true, any, out, work)
                  : kd_search(t, r, 1, false, any, out, work);
}

STRUCTURE_VERBS(kdtree)

static inline structure_stats kdtree_stats(const kdtree *t)
{
    structure_stats s = t->stats;
    s.bytes = t->held.bytes, s.peak = t->held.peak;
    return s;
}

#endif
