/* csg_meshes.h: faces of meshes in the planes of others: how many rays find what is not there.
 *
 *   csg_solid s = csg_scene_cube(n, at)       lab/csg_scenes.h
 *   double p = csg_left_over(kind, apart, seed, n)    of n rays, percent for which a difference
 *                                             that holds nothing holds a span. apart: meshes
 *                                             know no planes
 *   csg_mesh_table(&o)                        all kinds, both ways
 */
#ifndef CSG_MESHES_H
#define CSG_MESHES_H

#include "../../../common/lab/report.h"
#include "csg_oracle.h"
#include "csg_scenes.h"
#include "csg_variants.h"

typedef enum { CSG_AT_FACES, CSG_AT_EDGES, CSG_TWO_STRAIGHT, CSG_TWO_TURNED, csg_mesh_kinds }
    csg_mesh_kind;
static const char *const csg_mesh_name[] = {
    "mesh less box of its size, turned, rays at faces", "the same, rays at edges",
    "mesh less larger mesh, flush, across the axes", "the same, turned"};

/* ---------------------------------------------------------------------------------------------- */

/* Half as wide across n[1] and n[2] as the cube of side 2, and flush with its face n[0]. */
static inline csg_solid csg_flush_mesh(const vec3 n[3])
{
    const vec3 half[3] = {vscale(n[0], (real)0.25), vscale(n[1], (real)0.5),
                          vscale(n[2], (real)0.5)};
    return csg_scene_cube(half, vscale(n[0], (real)0.75));
}

/* From 4 away to a point of a face of the cube, or of one of its edges. */
static inline ray csg_mesh_ray(const vec3 n[3], csg_mesh_kind kind, random_stream *s)
{
    real p[3] = {1, 2 * random_next(s) - 1, 2 * random_next(s) - 1};
    if (kind == CSG_AT_EDGES) p[1] = 1;
    if (kind >= CSG_TWO_STRAIGHT) p[1] /= 2, p[2] /= 2;
    vec3 to = vadd(vadd(vscale(n[0], p[0]), vscale(n[1], p[1])), vscale(n[2], p[2]));
    vec3 from = vscale(random_direction_of(s), 4);
    return ray_from(from, vsub(to, from));
}

static inline double csg_left_over(csg_mesh_kind kind, bool apart, uint64_t seed, size_t n)
{
    static const csg_step step[3] = {{CSG_SOLID, 0}, {CSG_SOLID, 1}, {CSG_DIFFERENCE, 0}};
    size_t wrong = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(seed, i, (uint64_t)kind);
        vec3 axis[3] = {random_direction_of(&s)};
        vbasis(axis[0], &axis[1], &axis[2]);
        for (int k = 0; kind == CSG_TWO_STRAIGHT && k < 3; k++)
            axis[k] = vwith((vec3){0, 0, 0}, k, 1);
        bool two = kind >= CSG_TWO_STRAIGHT;
        csg_solid x[2] = {csg_flush_mesh(axis), csg_scene_cube(axis, (vec3){0, 0, 0})};
        csg_solid both[2] = {two ? x[0] : x[1],
                             two ? x[1] : csg_scene_block(axis, -1, -1, -1, 1, 1, 1)};
        csg c = {.nodes = 0};
        csg_crossing *list = NULL;
        failure f;
        if (!csg_build((csg_model){both, 2, step, 3}, (csg_options){0}, &c, &f)) fail(f);
        wrong += csg_walk(&c, csg_mesh_ray(axis, kind, &s), &list,
                          apart ? csg_apart_crossings : csg_solid_crossings, spans_merge) > 0;
        csg_free(&c);
        for (int k = 0; k < 2; k++) free((void *)(uintptr_t)x[k].mesh.tri);
    }
    return 100 * (double)wrong / (double)n;
}

static inline void csg_mesh_table(const options *o)
{
    size_t n = o->quick ? 200 : 20000;
    table t = table_new("Faces of meshes in common planes: rays that find what is not there",
                        "difference|error by themselves [%]|error csg_hit [%]");
    for (int k = 0; k < csg_mesh_kinds; k++) {
        table_text(&t, "%s", csg_mesh_name[k]);
        table_number(&t, csg_left_over((csg_mesh_kind)k, true, o->seed, n));
        table_number(&t, csg_left_over((csg_mesh_kind)k, false, o->seed, n));
    }
    output_extra_table(o, &t);
}

#endif
