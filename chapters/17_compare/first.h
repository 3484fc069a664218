/* first.h: brute force and six structures behind one signature: the same mesh, the same rays.
 * Wrong where they are (see each): what they cost here is what the notes' own algorithms cost.
 * lab/contenders.h compares the full versions. */
#ifndef FIRST_COMPARE_H
#define FIRST_COMPARE_H
#include "../10_grid/first.h"
#include "../11_octree/first.h"
#include "../12_kdtree/first.h"
#include "../13_bsp/first.h"
#include "../15_wide_bvh/first.h"

enum { first_use_brute, first_use_grid, first_use_octree, first_use_kdtree, first_use_bsp,
       first_use_bvh, first_use_wide, first_structures };
static const char *const first_structure_name[first_structures] = {
    "BRUTE", "GRID", "OCTREE", "KD", "BSP", "BVH", "WIDE"};

typedef struct {
    const first_mesh *m;
    first_grid grid;
    first_octree octree;
    first_kdtree kdtree;
    first_bsp bsp;
    first_bvh bvh;
    first_wide wide;
} first_contest;

/* In place, since trees must not move. */
static inline void first_contest_build(const first_mesh *m, first_contest *c)
{
    c->m = m;
    c->grid = first_grid_build(m);
    first_octree_build(m, &c->octree);
    first_kdtree_build(m, &c->kdtree);
    first_bsp_build(m, &c->bsp);
    c->bvh = first_bvh_build(m, true);
    c->wide = first_wide_build(m);
}

static inline bool first_contest_hit(const first_contest *c, int structure, ray r, hit *out)
{
    switch (structure) {
    case first_use_grid: return first_grid_hit(&c->grid, r, out);
    case first_use_octree: return first_octree_hit(&c->octree, r, out);
    case first_use_kdtree: return first_kdtree_hit(&c->kdtree, r, out);
    case first_use_bsp: return first_bsp_hit(&c->bsp, r, out);
    case first_use_bvh: return first_bvh_hit(&c->bvh, r, out);
    case first_use_wide: return first_wide_hit(&c->wide, r, out);
    default: return first_mesh_hit(c->m, r, out);
    }
}

static inline void first_contest_free(first_contest *c)
{
    first_grid_free(&c->grid);
    first_octree_free(&c->octree);
    first_kdtree_free(&c->kdtree);
    first_bsp_free(&c->bsp);
    first_bvh_free(&c->bvh);
    first_wide_free(&c->wide);
}
#endif
