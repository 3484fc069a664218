/* first_forest.h: a crowd of several meshes by first.h, a first_crowd of each: all instances asked.
 *
 *   first_forest f = first_forest_of(&crowd)        first_forest_free(&f)
 *   bool first_forest_hit(&f, r, &h)                h.shape: a triangle of its mesh
 *   first_forest_bytes(&f)                          memory, as reals and ints are
 */
#ifndef INSTANCES_LAB_FIRST_FOREST_H
#define INSTANCES_LAB_FIRST_FOREST_H

#include "../../07_mesh/scenes/as_first.h"
#include "../first.h"
#include "../instances.h"

typedef struct { first_mesh mesh; first_bvh tree; first_crowd crowd; } first_kind;
typedef struct { first_kind *kind; size_t kinds, n; } first_forest;  /* n: instances */

/* ---------------------------------------------------------------------------------------------- */

static inline void first_kind_of(const crowd *c, uint32_t k, first_kind *out)
{
    first_instance *one = allocate(c->n, sizeof *one);
    int n = 0;
    out->mesh = first_mesh_of(&c->mesh[k]), out->tree = first_bvh_build(&out->mesh, true);
    for (const instance *i = c->list; i < c->list + c->n; i++) {
        affine a = i->to_world;
        if (i->mesh == k) one[n++] = first_instance_at(a.x, a.y, a.z, a.o);
    }
    out->crowd = (first_crowd){&out->tree, one, n};
}

static inline first_forest first_forest_of(const crowd *c)
{
    first_forest f = {allocate(c->meshes, sizeof *f.kind), c->meshes, c->n};
    for (uint32_t k = 0; k < f.kinds; k++) first_kind_of(c, k, &f.kind[k]);
    return f;
}

static inline void first_forest_free(first_forest *f)
{
    for (first_kind *k = f->kind; k < f->kind + f->kinds; k++)
        free(k->crowd.one), first_bvh_free(&k->tree), first_mesh_free(&k->mesh);
    free(f->kind), *f = (first_forest){NULL, 0, 0};
}

static inline bool first_forest_hit(const first_forest *f, ray r, hit *out)
{
    bool found = false;
    int which;
    for (const first_kind *k = f->kind; k < f->kind + f->kinds; k++)
        if (first_crowd_hit(&k->crowd, r, out, &which)) found = true, r.tmax = out->t;
    return found;
}

static inline size_t first_forest_bytes(const first_forest *f)
{
    size_t bytes = 0;
    for (const first_kind *k = f->kind; k < f->kind + f->kinds; k++)
        bytes += (size_t)k->mesh.n * (sizeof *k->mesh.tri + sizeof *k->tree.order)
                 + (size_t)k->tree.nodes * sizeof *k->tree.node
                 + (size_t)k->crowd.n * sizeof *k->crowd.one;
    return bytes;
}

#endif
