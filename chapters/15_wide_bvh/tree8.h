/* tree8.h: nodes and blocks as they lie in memory: rows of eight (structure of arrays), as bvh8.h
 * draws them.
 *
 * Coordinates are those of w.frame (09), at most 1. Where all corners are floats in it,
 * w.exact, nobody needs the mesh any more.
 *
 * A child is the number of a node, or with bvh8_leaf that of a block, or of a shape that is no
 * triangle: these are leaves one by one. An empty place has a box that no ray meets; in a block it
 * repeats the first triangle, under no_shape.
 */
#ifndef WIDE_TREE8_H
#define WIDE_TREE8_H

#include "../../common/numbers/eight.h"
#include "../09_aabb/frame.h"
#include "../09_aabb/items.h"
#include "../14_bvh/tree.h"

#define bvh8_leaf 0x80000000u
enum { bvh8_stack = 64 * 8 };  /* all but one a level wait, and no tree is deeper */

typedef struct { float side[6][8]; uint32_t child[8]; } __attribute__((aligned(64))) bvh8_node;
typedef struct { eight corner[9]; eight_count index; } __attribute__((aligned(64))) bvh8_block;

typedef struct {
    int leaf, width, threads;
    eight_dialect dialect;
    size_t most_bytes;
} bvh8_options;

#define bvh8_defaults ((bvh8_options){8, 8, 0, eight_best(), SIZE_MAX})

typedef struct {
    items x;
    aabb_frame frame;
    bool exact;           /* blocks hold the very corners */
    eight_dialect dialect;
    bvh8_node *node;      /* [nodes] */
    bvh8_block *block;    /* [blocks], NULL for shapes */
    struct bvh8_patch *patch;  /* [patches] of patch.h, of a few triangles; else NULL */
    size_t nodes, blocks, patches;
    size_t held;          /* items in them */
    int depth;            /* of the deepest node; the root: 1 */
    memory room;          /* of both, and while it was built */
} bvh8;

/* Items that the caller knows this ray can't hit: the one it starts on (18.10), and first to last,
 * the lamp at its end. Float would be in doubt about such triangles, and ask each in `real`. */
typedef struct { uint32_t from, first, last; } bvh8_skip;
#define bvh8_skip_none ((bvh8_skip){no_shape, no_shape, no_shape})

#endif
