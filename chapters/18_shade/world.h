/* world.h: what rays may meet: parts, each a mesh, or a scene of shapes (07), in its tree (15).
 *
 *   trace_world w = {part, n};
 *   world_part_of_mesh(&m, mask, &part); world_part_of_scene(&s, mask, &part); world_part_free(..)
 */
#ifndef SHADE_WORLD_H
#define SHADE_WORLD_H

#include "../15_wide_bvh/bvh8.h"

typedef struct {
    const mesh *m;       /* this, */
    const scene *s;      /* or this; the other is NULL */
    bvh8 tree;
    uint8_t mask;        /* seen by kinds whose mask shares a bit */
    bool opaque;
} world_part;

typedef struct { const world_part *part; size_t parts; } trace_world;
typedef struct { hit h; uint32_t part; } trace_hit;  /* h.shape: within the part */

/* ---------------------------------------------------------------------------------------------- */

/* Mesh and scene must outlive the part. No memory: the program ends. O(n log n). */
static inline void world_part_of_mesh(const mesh *m, uint8_t mask, world_part *out)
{
    failure f;
    items x = items_of_mesh(m);
    *out = (world_part){.m = m, .mask = mask};
    if (!bvh8_build(&x, bvh8_defaults, &out->tree, &f)) fail(f);
}

static inline void world_part_of_scene(const scene *s, uint8_t mask, world_part *out)
{
    failure f;
    items x = items_of_scene(s);
    *out = (world_part){.s = s, .mask = mask};
    if (!bvh8_build(&x, bvh8_defaults, &out->tree, &f)) fail(f);
}

static inline void world_part_free(world_part *p)
{
    bvh8_free(&p->tree);
    *p = (world_part){.mask = 0};
}

#endif
