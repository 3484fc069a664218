/* world.h: what rays may meet: parts, each a mesh, or a scene of shapes (07), in its tree (15).
 *
 *   world_part_of_mesh(&m, mask, &part); world_part_of_scene(&s, mask, &part)
 *   world_part_build(items, mask, &part, &f)     either of them; false: f says why
 *   world_part_free(&part)                       a zeroed one may be freed
 *   trace_world w = {part, n};
 *
 *   world_find(&w, mask, world_but_none, &r, &x)   the closest hit, x, and r ends there; x NULL: is
 *                                     there any? Of parts that share a bit with mask
 *   world_but                         what the caller knows r not to meet, for a sooner answer: the
 *                                     face that it left (18.10), `from`, and the lamp at its end,
 *                                     faces `first` to `last`, each of the part of that id;
 *                                     no_shape: none
 *   world_left(world_face_of(&w, &x))   only the face of hit x; of a part without an id: none. Who
 *                                     gives two parts one id says that they number alike
 *
 *   world_find_row(&w, mask, q, n, any)   the same of n rays [0..world_row], each with its `but`:
 *                                     q[k].met, and unless any is enough q[k].x; a few triangles
 *                                     are asked by many rays side by side (15)
 *
 * Equal t: the lower part, then the lower shape wins (hit.h). No part, a NaN: false. x.h.t in units
 * of r.d. Each part is a search of its tree, O(log n) for most scenes.
 */
#ifndef SHADE_WORLD_H
#define SHADE_WORLD_H

#include "../15_wide_bvh/bvh8.h"

typedef struct {
    bvh8 tree;           /* of tree.x.m or tree.x.s; the other is NULL */
    uint8_t mask;        /* seen by kinds whose mask shares a bit */
    bool opaque;         /* trace.h: no any_hit is asked about it */
    uint32_t id;         /* what world_but calls it; world_unnamed, unless its user says so */
} world_part;

typedef struct { const world_part *part; size_t parts; } trace_world;
typedef struct { hit h; uint32_t part; } trace_hit;  /* h.shape: within the part */

typedef struct { uint32_t from_part, from, to_part, first, last; } world_but;
#define world_but_none ((world_but){no_shape, no_shape, no_shape, no_shape, no_shape})
typedef struct { uint32_t part, item; } world_face;  /* part: its id */
#define world_no_face ((world_face){no_shape, no_shape})
#define world_unnamed (no_shape - 1)

enum { world_row = 64 };
typedef struct { ray *r; world_but but; trace_hit x; bool met; } world_query;

enum { MASK_SEEN = 1, MASK_SHADOW = 2, MASK_SIGHT = 4, MASK_ALL = 7 };

/* ---------------------------------------------------------------------------------------------- */

/* What the items are of must outlive the part. O(n log n). */
static inline bool world_part_build(items x, uint8_t mask, world_part *out, failure *f)
{
    *out = (world_part){.mask = mask, .id = world_unnamed};
    return bvh8_build(&x, bvh8_defaults, &out->tree, f);
}

/* No memory: the program ends. */
static inline void world_part_of_mesh(const mesh *m, uint8_t mask, world_part *out)
{
    failure f;
    if (!world_part_build(items_of_mesh(m), mask, out, &f)) fail(f);
}

static inline void world_part_of_scene(const scene *s, uint8_t mask, world_part *out)
{
    failure f;
    if (!world_part_build(items_of_scene(s), mask, out, &f)) fail(f);
}

static inline void world_part_free(world_part *p)
{
    bvh8_free(&p->tree);
    *p = (world_part){.mask = 0};
}

/* What `but` says of one part. */
fast_inline bvh8_skip world_skip(world_but but, uint32_t id)
{
    bool to = but.to_part == id;
    return (bvh8_skip){but.from_part == id ? but.from : no_shape, to ? but.first : no_shape,
                       to ? but.last : no_shape};
}

fast_inline world_face world_face_of(const trace_world *w, const trace_hit *x)
{
    uint32_t id = w->part[x->part].id;
    return (world_face){id, id == world_unnamed ? no_shape : x->h.shape};
}

fast_inline world_but world_left(world_face from)
{
    return (world_but){from.part, from.item, no_shape, no_shape, no_shape};
}

/* The hit is written where it shall lie: a struct handed over as a whole right after its fields
 * were written would wait for all that is under way. */
fast_inline bool world_find(const trace_world *w, uint8_t mask, world_but but, ray *r,
                            trace_hit *x)
{
    bool met = false;
    for (uint32_t k = 0; k < w->parts; k++) {
        const world_part *p = &w->part[k];
        hit later, *h = !x ? NULL : met ? &later : &x->h;
        if (!(p->mask & mask)) continue;
        if (!bvh8_ask_at(&p->tree, r, world_skip(but, p->id), h, NULL)) continue;
        if (!x) return true;
        if (met && h->t == r->tmax) continue;  /* the first keeps it */
        if (met) x->h = later;
        met = true, x->part = k, r->tmax = h->t;
    }
    return met;
}

/* What part k has met, if it is nearer. */
fast_inline void world_keep(world_query *q, const bvh8_query *b, uint32_t k, bool any)
{
    if (!b->met || (q->met && b->h.t == q->r->tmax)) return;  /* the first keeps it */
    q->met = true;
    if (any) return;
    q->x.h.t = b->h.t, q->x.h.u = b->h.u, q->x.h.v = b->h.v, q->x.h.shape = b->h.shape;
    q->x.part = k, q->r->tmax = b->h.t;
}

static inline void world_find_row(const trace_world *w, uint8_t mask, world_query *q, int n,
                                  bool any)
{
    bvh8_query b[world_row];
    int of[world_row];
    for (int i = 0; i < n; i++) q[i].met = false;
    for (uint32_t k = 0; k < w->parts; k++) {
        const world_part *p = &w->part[k];
        int asked = 0;
        if (!(p->mask & mask)) continue;
        for (int i = 0; i < n; i++) {
            if (any && q[i].met) continue;  /* one hit is enough */
            of[asked] = i, b[asked].r = q[i].r;
            b[asked++].skip = world_skip(q[i].but, p->id);
        }
        bvh8_ask_row(&p->tree, b, asked, any);
        for (int i = 0; i < asked; i++) world_keep(&q[of[i]], &b[i], k, any);
    }
}

#endif
