/* octree.h: a cube cut into eight, each part again, while too many items are in it (八叉树, octree).
 *
 *   +----+----+     child c of a cell: bit 0 of c is 1 in its upper half along x, bit 1 along y,
 *   | 2  | 3  |     bit 2 along z. The eight stand in a row, which is one line of the cache.
 *   +----+-+--+
 *   | 0  +-+--+     A cell is a leaf (叶节点) if it holds at most how.leaf items, if it is how.depth
 *   +----+-+--+     cuts deep, or if cutting does not help: see build.h.
 *
 *   octree t;
 *   bool octree_build(&x, octree_defaults, &t, &f)   false: more than most_bytes, or too large
 *   bool octree_hit(&t, r, &h), ..                   the verbs of structure.h (09)
 *
 * The mesh or the scene of x must outlive the tree. How the search goes: walk.h.
 * In the plane it is a quadtree (四叉树): quadtree.h draws one.
 *
 * Sources: A. Glassner, "Space Subdivision for Fast Ray Tracing", IEEE CG&A 4(10), 1984;
 * J. Revelles, C. Ureña, M. Lastra, "An Efficient Parametric Algorithm for Octree Traversal", WSCG
 * 2000.
 */
#ifndef OCTREE_H
#define OCTREE_H

#include "walk.h"

/* ---------------------------------------------------------------------------------------------- */

fast_inline bool octree_search(const octree *t, ray r, bool any, hit *out, search_work *work)
{
    return octree_walk(t, r, any, 1, out, work, NULL);
}

STRUCTURE_VERBS(octree)

#endif
