/* naive.h: searches of the BVH without the care of node.h: boxes are tested as they come.
 *
 *   bvh_mesh_hit_naive(&b, r, &h)        of a mesh: loses hits
 *   bvh_hit_naive(&b, r, &h)             with the signature of bvh_hit; of a mesh alone
 */
#ifndef BVH_LAB_NAIVE_H
#define BVH_LAB_NAIVE_H

#include "../bvh.h"

/* ---------------------------------------------------------------------------------------------- */

/* What a box loses by that: box_ray_naive. */
static inline bool bvh_mesh_hit_naive(const bvh_mesh *b, ray r, hit *out)
{
    return tree_search(&b->tree, r, box_ray_naive, bvh_mesh_leaf, b, false, out, NULL);
}

static inline bool bvh_hit_naive(const bvh *b, ray r, hit *out)
{
    return bvh_mesh_hit_naive(&b->mesh, r, out);
}

#endif
