/* nff_world.h: an NFF file (nff.h) as a world: its view, lights, finishes and shapes. (27 makes of
 * the same file all that a picture takes: patches with normals, scenes of many files.)
 *
 *   if (!nff_world("balls.nff", NULL, &w, &f)) fail(f);     world_free(&w)
 *
 * Polygons of three corners are triangles; colours of lights and normals of patches are dropped. Of
 * more than world_most_lights lights the first are kept; without any there is one beside the eye.
 * A file without a view has `otherwise`; where that is NULL it is refused.
 * "FILE:LINE: ..", exit code 2: broken, nothing in it, no view; cannot be read: 1.
 */
#ifndef MESH_NFF_WORLD_H
#define MESH_NFF_WORLD_H

#include "../scenes/world.h"
#include "nff.h"

typedef struct {
    world *w;
    size_t shape_room, corner_room, group_room;
    bool viewed;
} nff_world_rooms;

/* ---------------------------------------------------------------------------------------------- */

static inline void nff_world_shape(nff_world_rooms *r, shape s)
{
    world *w = r->w;
    w->shape = grown_for(w->name, w->shape, w->n, 1, &r->shape_room, sizeof *w->shape);
    w->shape[w->n++] = s;
}

/* Corners move as their array grows: until the file is read, `n` is known and `v` is not. */
static inline void nff_world_polygon(nff_world_rooms *r, const vec3 *p, size_t n)
{
    world *w = r->w;
    if (n == 3) nff_world_shape(r, shape_of_triangle((triangle){p[0], p[1], p[2]}));
    else nff_world_shape(r, (shape){.kind = SHAPE_POLYGON, .polygon = {.n = (uint32_t)n}});
    for (size_t k = 0; n > 3 && k < n; k++) {
        w->corner = grown_for(w->name, w->corner, w->corners, 1, &r->corner_room, sizeof *p);
        w->corner[w->corners++] = p[k];
    }
}

static inline bool nff_world_item(nff_world_rooms *r, const nff_item *x, failure *f)
{
    world *w = r->w;
    const nff_fill *m = &x->fill;
    const nff_view *v = &x->view;
    failure why;
    switch (x->kind) {
    case NFF_VIEW: return r->viewed = true, world_look(w, v->from, v->at, v->up, v->angle, &why)
            || failed(f, 2, "%.300s:%zu: v: %s", w->name, x->line, why.text);
    case NFF_BACKGROUND: return w->background = x->background, true;
    case NFF_LIGHT: return w->lights == world_most_lights || (world_light(w, x->light.at), true);
    case NFF_FILL:
        w->group = grown_for(w->name, w->group, w->groups, 1, &r->group_room, sizeof *w->group);
        world_paint(w, (finish){m->colour, m->kd, m->ks, m->shine, m->transmit, m->ior});
        return true;
    case NFF_SPHERE: return nff_world_shape(r, shape_of_sphere(x->sphere)), true;
    case NFF_CONE: return nff_world_shape(r, shape_of_cone(x->cone)), true;
    default: return nff_world_polygon(r, x->corner, x->corners), true;
    }
}

/* The first group must begin at 0. */
static inline void nff_world_finish(nff_world_rooms *r)
{
    world *w = r->w;
    size_t at = 0;
    for (size_t i = 0; i < w->n; i++)
        if (w->shape[i].kind == SHAPE_POLYGON) {
            size_t n = w->shape[i].polygon.n;
            w->shape[i] = shape_of_polygon(polygon_of(w->corner + at, n));
            at += n;
        }
    w->group = grown(w->group, w->groups, &r->group_room, sizeof *w->group);
    if (w->groups == 0)
        w->group[w->groups++].finish = (finish){{(real)0.8, (real)0.8, (real)0.8}, 1, 0, 0, 0, 0};
    w->group[0].first = 0;
    if (w->lights == 0) world_light(w, vadd(w->from, vec(1, 1, 1)));
    w->light_each = nff_plain_light((size_t)w->lights);
}

static inline bool nff_world_look(world *w, const nff_view *v, failure *f)
{
    failure why;
    if (!v) return failed(f, 2, "%.300s: no view (v) in it; --from and --at make one", w->name);
    return world_look(w, v->from, v->at, v->up, v->angle, &why)
        || failed(f, 2, "%.300s: %s", w->name, why.text);
}

static inline bool nff_world(const char *path, const nff_view *otherwise, world *w, failure *f)
{
    *w = (world){.name = path, .background = {(real)0.078, (real)0.361, (real)0.753}};
    nff_world_rooms r = {.w = w};
    nff_reader n;
    FILE *in = file_open(path, f);
    if (!in) return false;
    bool ok = nff_begin(&n, in, path, f);
    if (ok) {
        while (ok && nff_next(&n)) ok = nff_world_item(&r, &n.item, f);
        ok = nff_end(&n) && ok;
    }
    fclose(in);
    if (ok && w->n == 0) ok = failed(f, 2, "%.300s: no shape in it", path);
    if (ok && !r.viewed) ok = nff_world_look(w, otherwise, f);
    if (ok) nff_world_finish(&r);
    else world_free(w);
    return ok;
}

#endif
