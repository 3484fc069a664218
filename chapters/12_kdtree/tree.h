/* tree.h: what a k-d tree consists of, and how it is to be built.
 *
 *   kdtree_options         the builder's orders
 *   kdtree                 nodes, and the records of the leaves one after another
 *
 * Every byte is counted (09: memory), so that t.held.peak is the most ever held and most_bytes is
 * kept.
 */
#ifndef KDTREE_TREE_H
#define KDTREE_TREE_H

#include "split.h"

enum { kdtree_most_depth = 64, kd_most_doubled = 3 };

/* How an item that lies in a plane is kept. KD_THICK: its box gets one float more on each side, so
 * that it lies in no plane of its own; where another plane cuts it, it goes to both children. The
 * others keep boxes as they are: exact where coordinates are floats. */
typedef enum { KD_THICK, KD_BOTH, KD_ONE } kdtree_planar;

typedef struct {
    kdtree_strategy strategy; /* KD_MIDDLE, KD_MEDIAN, KD_SAH: split.h */
    int leaf;                 /* most items in one; 0: where no cut pays (KD_SAH only; else 4) */
    int depth;                /* of the deepest leaf [1..64]; 0: 8 + 1.3 log2 n            (12.2) */
    double traversal_cost, item_cost, empty_bonus;  /* (12.1) */
    bool clip;                /* boxes of parts are those of the part (12.3), not cut boxes */
    kdtree_planar planar;
    size_t most_bytes;        /* while it is built; more: kdtree_build returns false */
} kdtree_options;

/* 16 bytes for a triangle in a leaf: its corners and its number. */
typedef struct { uint32_t corner[3], index; } kd_triangle;

typedef struct {
    kd_node *node;            /* [nodes] 0 is the root, 1 not used: pairs begin at even numbers */
    kd_triangle *triangle;    /* [references] of a mesh, else NULL */
    uint32_t *index;          /* [references] of a scene, else NULL */
    size_t nodes;
    structure_stats stats;    /* but for the bytes: those of `held` */
    items x;
    const vec3 *v;            /* corners of the mesh */
    aabb_frame frame;
    kd_box box;               /* in the frame; lo > hi if there is nothing */
    memory held;
} kdtree;

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    kdtree *t;
    kdtree_options how;
    kd_splitter split;
    kd_item *item;            /* see above */
    uint32_t *index;          /* of the leaves, one after another */
    size_t item_room, node_room, index_room;
    bool large;               /* more references or nodes than can be numbered */
} kd_builder;

static inline void kdtree_free(kdtree *t)
{
    free(t->node), free(t->triangle), free(t->index);
    *t = (kdtree){0};
}

#endif
