/* studio_tree.h: what a ray hits first in a studio, and the surface there.
 *
 *   studio_tree t;
 *   if (!studio_tree_build(&s, &t, &f)) fail(f);    s must outlive t; only one that is finished
 *   bool studio_tree_hit(&t, r, &x)           closest; interval closed; at equal t shapes before
 *                                             solids before meshes that stand before instances
 *   bool studio_tree_occluded_but(&t, &r, but), studio_tree_hit_but(&t, &r, but, &x)    any; the
 *                                             closest, sooner, and r ends there: but = studio_but(
 *                                             the face that it left, that of the lamp at its end)
 *   studio_face k = studio_flat_face(&t, x)   x's, for `but`, if it is flat: what leaves a plane by
 *                                             18 towards the same side does not come back
 *   surface a = studio_surface(&t, r, x)      with the error bounds of 18, for leave.h
 *   uint32_t m = studio_hit_material(&t, x)
 *   studio_tree_free(&t)                      a zeroed one may be freed
 *
 * Trees only where they have something to hold: a world of 18, one part of all shapes, one of all
 * solids that have an end (the others are asked one by one: scene files may have few), one for
 * each mesh that stands as it is in its file; one of two levels (16) for those that were moved, or
 * stand a second time. There what rounding moves on the way and back, the pad of (16.3), is added
 * to `error` and `noise` of a surface.
 */
#ifndef EFFECTS_STUDIO_TREE_H
#define EFFECTS_STUDIO_TREE_H

#include "../16_instances/instances.h"
#include "../18_shade/shade.h"
#include "studio.h"
#include "effect.h"

/* place no_shape: h.shape is a shape; no_shape - 1 - k: h.shape is a surface of solid k */
typedef struct { hit h; uint32_t place; } studio_hit;

#define studio_no_face ((studio_face){no_shape, no_shape})

typedef struct {
    const studio *s;
    scene *all;               /* the shapes; the solids, as shapes made of: */
    shape_other *carved;      /* [boxed] */
    world_part *part;         /* [world.parts] id: its place; no_shape: shapes; s.places: solids */
    trace_world world;        /* these */
    instances moved;          /* numbered as the places are; .n 0: none was */
    mesh *moved_mesh;         /* [meshes + 1] theirs: those of s, or empty */
    placing *pad;             /* [places] of those that were moved */
} studio_tree;

/* ---------------------------------------------------------------------------------------------- */

static inline void studio_tree_free(studio_tree *t)
{
    for (size_t k = 0; k < t->world.parts; k++) world_part_free(&t->part[k]);
    instances_free(&t->moved);
    if (t->all) free((shape *)(uintptr_t)t->all[1].shapes);
    free(t->all), free(t->carved), free(t->part), free(t->pad), free(t->moved_mesh);
    *t = (studio_tree){.s = NULL};
}

static inline bool studio_tree_add(studio_tree *t, items x, uint32_t place, failure *f)
{
    world_part *p = &t->part[t->world.parts];
    if (!world_part_build(x, MASK_ALL, p, f)) return false;
    p->id = place, t->world.parts++;
    return true;
}

static inline bool studio_tree_meets(const void *c, ray r, hit *out) { return csg_hit(c, r, out); }

/* Which of a solid's surfaces is hit the tree does not keep: studio_tree_found asks again. */
static inline bool studio_tree_solids(studio_tree *t, failure *f)
{
    const studio *s = t->s;
    shape *as = allocate(s->boxed, sizeof *as);
    t->carved = allocate(s->boxed, sizeof *t->carved), t->all[1] = (scene){as, s->boxed};
    for (size_t k = 0; k < s->boxed; k++) {
        const csg *c = &s->solid[k].c;
        csg_bound b = c->node[0].bound;
        t->carved[k] = (shape_other){studio_tree_meets, NULL, c, b.lo, b.hi};
        as[k] = shape_of_other(&t->carved[k]);
    }
    return !s->boxed
        || studio_tree_add(t, items_of_scene(&t->all[1]), (uint32_t)s->places, f);
}

/* Trees only for meshes that are moved: the others get an empty one, from an empty mesh. points: of
 * all instances: what tight boxes would cost. */
static inline bool studio_tree_moved(studio_tree *t, const crowd *c, size_t points, failure *f)
{
    instances_options how = instances_defaults;
    how.boxes = points > 20000000 ? INSTANCES_CORNERS : INSTANCES_POINTS;
    if (!instances_build(c, how, &t->moved, f)) return false;
    t->pad = allocate(c->n, sizeof *t->pad);
    for (size_t i = 0; i < c->n; i++) {
        uint32_t where = t->moved.where[i];
        if (where == no_shape) continue;
        const placed *p = &t->moved.place[where];
        t->pad[i] = placing_of(c->list[i].to_world, p->to_object,
                               aabb_reach(t->moved.box[p->mesh]));
    }
    return true;
}

/* The first place of each mesh that is not moved stands. To 16 it is one of an empty mesh, behind
 * all others, so that an instance has the number of its place. */
static inline bool studio_tree_places(studio_tree *t, failure *f)
{
    const studio *s = t->s;
    bool *has = allocate(s->meshes, sizeof *has), ok = true;
    mesh *used = t->moved_mesh = allocate(s->meshes + 1, sizeof *used);
    instance *list = allocate(s->places, sizeof *list);
    size_t moved = 0, points = 0;
    for (uint32_t i = 0; ok && i < s->places; i++) {
        uint32_t m = s->placed[i].mesh;
        list[i] = s->placed[i];
        if (!has[m] && studio_stands(s, i)) {
            has[m] = true, list[i].mesh = (uint32_t)s->meshes;
            ok = studio_tree_add(t, items_of_mesh(&s->mesh[m]), i, f);
        } else used[m] = s->mesh[m], moved++, points += used[m].vertices;
    }
    const crowd c = {used, s->meshes + 1, list, s->places};
    if (ok && moved) ok = studio_tree_moved(t, &c, points, f);
    free(has), free(list);
    return ok;
}

/* O(n log n). False: more than 2^31 of something. */
static inline bool studio_tree_build(const studio *s, studio_tree *out, failure *f)
{
    *out = (studio_tree){.s = s, .all = allocate(2, sizeof *out->all)};
    out->all[0] = studio_shapes(s);
    out->world.part = out->part = allocate(s->meshes + 2, sizeof *out->part);
    bool ok = !s->shapes || studio_tree_add(out, items_of_scene(out->all), no_shape, f);
    if (ok && studio_tree_solids(out, f) && studio_tree_places(out, f)) return true;
    studio_tree_free(out);
    return false;
}

/* Nearer, not as near: the first keeps it, and ends the ray. Field by field: a copy of the whole
 * would wait for what the search has just written. */
fast_inline void studio_tree_keep(hit h, uint32_t place, ray *r, bool *found, studio_hit *out)
{
    if (*found && h.t == r->tmax) return;
    *out = (studio_hit){{h.t, h.u, h.v, h.shape}, place};
    *found = true, r->tmax = h.t;
}

/* A solid that the tree has found along r, at h.t: which of its surfaces is hit there is asked
 * again, as the tree knows it as one thing. The interval is closed: there is one. A call, since
 * solids are few. */
cold_inline studio_hit studio_tree_carved(const studio_tree *t, ray r, hit h)
{
    studio_hit x = {h, no_shape - 1 - h.shape};
    r.tmax = h.t;
    if (!csg_hit(&t->s->solid[h.shape].c, r, &x.h)) x.h.shape = 0;
    return x;
}

/* Neither is met. */
fast_inline world_but studio_but(studio_face from, studio_face to)
{
    return (world_but){from.place, from.index, to.place, to.index, to.index};
}

fast_inline bool studio_tree_hit_but(const studio_tree *t, ray *r, world_but but, studio_hit *out)
{
    bool found = false;
    trace_hit stands;
    hit h;
    instance_hit x;
    if (world_find(&t->world, MASK_ALL, but, r, &stands)) {
        uint32_t id = t->part[stands.part].id;
        studio_tree_keep(stands.h, id, r, &found, out);
        if (id == t->s->places) *out = studio_tree_carved(t, *r, stands.h);
    }
    if (t->moved.n && instances_hit(&t->moved, *r, &x))
        studio_tree_keep(x.h, x.instance, r, &found, out);
    for (size_t k = t->s->boxed; k < t->s->solids; k++)
        if (csg_hit(&t->s->solid[k].c, *r, &h))
            studio_tree_keep(h, no_shape - 1 - (uint32_t)k, r, &found, out);
    return found;
}

fast_inline bool studio_tree_occluded_but(const studio_tree *t, ray *r, world_but but)
{
    if (world_find(&t->world, MASK_ALL, but, r, NULL)) return true;
    for (size_t k = t->s->boxed; k < t->s->solids; k++)
        if (csg_occluded(&t->s->solid[k].c, *r)) return true;
    return t->moved.n && instances_occluded(&t->moved, *r);
}

static inline bool studio_tree_hit(const studio_tree *t, ray r, studio_hit *out)
{
    return studio_tree_hit_but(t, &r, world_but_none, out);
}

/* Of moved meshes and solids none is left out: their places have no tree that asks. */
fast_inline studio_face studio_flat_face(const studio_tree *t, studio_hit x)
{
    const shape *s = x.place == no_shape ? &t->s->shape[x.h.shape] : NULL;
    bool flat = !s || s->kind == SHAPE_TRIANGLE
        || (s->kind == SHAPE_POLYGON && polygon_is_flat(&s->polygon));
    return (studio_face){x.place, flat ? x.h.shape : no_shape};
}

/* NULL: it is none. */
static inline const studio_solid *studio_hit_solid(const studio_tree *t, studio_hit x)
{
    bool is = x.place != no_shape && x.place >= no_shape - t->s->solids;
    return is ? &t->s->solid[no_shape - 1 - x.place] : NULL;
}

static inline uint32_t studio_hit_material(const studio_tree *t, studio_hit x)
{
    const studio_solid *of = studio_hit_solid(t, x);
    return of ? of->material : studio_material_of(t->s, x.place, x.h.shape);
}

/* It does not stand as it is in its file. (What can't be hit counts as if it did.) */
static inline bool studio_moved(const studio_tree *t, uint32_t place)
{
    return t->moved.n && t->moved.where[place] != no_shape;
}

/* In the world. */
static inline triangle studio_triangle(const studio *s, uint32_t place, uint32_t index)
{
    const affine *w = &s->placed[place].to_world;
    triangle c = mesh_triangle(&s->mesh[s->placed[place].mesh], index);
    return (triangle){affine_point(*w, c.a), affine_point(*w, c.b), affine_point(*w, c.c)};
}

static inline surface studio_surface_placed(const studio_tree *t, ray r, studio_hit x)
{
    const studio *s = t->s;
    const studio_solid *of = studio_hit_solid(t, x);
    if (of) return solid_surface(of, r, x.h);
    const mesh *m = &s->mesh[s->placed[x.place].mesh];
    if (!studio_moved(t, x.place)) return surface_of_mesh(m, x.h);
    triangle c = studio_triangle(s, x.place, x.h.shape);
    surface a = surface_on_triangle(c, x.h.shape, x.h.u, x.h.v);
    const affine *back = &t->moved.place[t->moved.where[x.place]].to_object;
    a.n = normal_to_world(back, triangle_normal(mesh_triangle(m, x.h.shape)));
    a.ns = m->n ? normal_to_world(back, mesh_normal(m, x.h.shape, x.h.u, x.h.v)) : a.n;
    real pad = placing_pad(&t->pad[x.place], a.p);
    a.error += pad, a.noise += pad;
    return a;
}

/* Shapes without a call, which would copy ray and hit. */
fast_inline surface studio_surface(const studio_tree *t, ray r, studio_hit x)
{
    return x.place == no_shape ? surface_of_shape(&t->s->shape[x.h.shape], r, x.h)
                               : studio_surface_placed(t, r, x);
}

#endif
