/* mesh.h: a triangle mesh (三角网格): points, and which three of them make each triangle.
 *
 *        c = v[index[3i+2]]
 *       / \             triangle i, counter-clockwise seen from outside, so that
 *      /   \            (b - a) x (c - a) points out of a closed mesh
 *     a --- b
 *   v[index[3i]]   v[index[3i+1]]
 *
 *   triangle mesh_triangle(&m, i)           its three corners
 *   vec3     mesh_normal(&m, i, u, v)       unit shading normal at barycentrics u of b, v of c
 *   bool     mesh_texture(&m, i, u, v, &t)  texture coordinates there; false: a corner has none
 *   bool     mesh_bounds(&m, &lo, &hi)      box around all triangles; false if there is none
 *   void     mesh_smooth_normals(&m)        one normal a vertex, triangles weighted by angle
 *   size_t   mesh_run_of(&m, i)             the last run that begins at or before triangle i,
 *                                           counted from 1; 0: none. By halving
 *   void     mesh_free(&m)                  a zeroed mesh may be freed, and so may a freed one
 *
 * Who fills a mesh (obj.h, teapot.h) allocates its arrays; mesh_free releases them.
 *
 * Why by angle: a square cut into two triangles may come to a corner with one of them or with both,
 * but with 90 degrees either way. By area a corner of a cube would lean towards the square that
 * counts twice: (2, 1, 1) is 19 degrees from (1, 1, 1). Source: Thürmer, Wüthrich, "Computing
 * vertex normals from polygonal facets", J. Graphics Tools 3(1), 1998.
 */
#ifndef MESH_H
#define MESH_H

#include "../04_triangle/triangle.h"
#include "../../common/file.h"
#include <stdint.h>

#define mesh_none UINT32_MAX  /* a corner without a normal; so at most 2^32 - 1 of anything */

typedef struct { uint32_t first; size_t name; } mesh_run;  /* a material, from this triangle on */

typedef struct {
    vec3 *v;                 /* [vertices] finite points */
    size_t vertices;
    uint32_t *index;         /* [3 triangles] each < vertices; counted from 0 */
    size_t triangles;
    vec3 *n;                 /* [normals] not always unit, zero: none; NULL: the mesh is faceted */
    size_t normals;
    uint32_t *normal_index;  /* [3 triangles] < normals, or mesh_none; NULL: the same as index */
    vec3 *t;                 /* [textures] texture coordinates (纹理坐标) u, v and sometimes w */
    size_t textures;
    uint32_t *texture_index; /* [3 triangles] < textures, or mesh_none; NULL: there are none */
    mesh_run *run;           /* [runs] by rising `first`; run[k].name is an offset into names */
    size_t runs;
    char *names;             /* material names, each ended by a 0 */
    char *libraries;         /* what mtllib named, one a line; NULL: nothing */
} mesh;

/* ---------------------------------------------------------------------------------------------- */

static inline void mesh_free(mesh *m)
{
    void *held[] = {m->v, m->index, m->n, m->normal_index, m->t, m->texture_index, m->run, m->names,
                    m->libraries};
    for (size_t i = 0; i < sizeof held / sizeof *held; i++) free(held[i]);
    *m = (mesh){0};
}

static inline triangle mesh_triangle(const mesh *m, size_t i)
{
    const uint32_t *k = m->index + 3 * i;
    return (triangle){m->v[k[0]], m->v[k[1]], m->v[k[2]]};
}

/* Only points that a triangle uses count: files often hold stray ones. A NaN is passed over, as
 * vmin and vmax keep their second argument then. O(triangles). */
static inline bool mesh_bounds(const mesh *m, vec3 *lo, vec3 *hi)
{
    *lo = (vec3){real_infinity, real_infinity, real_infinity};
    *hi = vneg(*lo);
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        *lo = vmin(m->v[m->index[i]], *lo);
        *hi = vmax(m->v[m->index[i]], *hi);
    }
    return m->triangles > 0;
}

static inline size_t mesh_run_of(const mesh *m, size_t i)
{
    size_t lo = 0, hi = m->runs;
    while (lo < hi) {
        size_t middle = lo + (hi - lo) / 2;
        if (m->run[middle].first <= i) lo = middle + 1;
        else hi = middle;
    }
    return lo;
}

/* The normal of corner k [0,3) of triangle i, as stored; zero if it has none. */
static inline vec3 mesh_corner_normal(const mesh *m, size_t i, int k)
{
    uint32_t j = (m->normal_index ? m->normal_index : m->index)[3 * i + (size_t)k];
    return m->n && j != mesh_none ? m->n[j] : (vec3){0, 0, 0};
}

/* Phong's interpolation: n = (1-u-v) na + u nb + v nc, made unit. Where a corner has no normal, or
 * they cancel, the answer is the triangle's own; that is zero only for a triangle of no area. */
static inline vec3 mesh_normal(const mesh *m, size_t i, real u, real v)
{
    vec3 a = vunit(mesh_corner_normal(m, i, 0)), b = vunit(mesh_corner_normal(m, i, 1)),
         c = vunit(mesh_corner_normal(m, i, 2)), n = {0, 0, 0};
    if (!vzero(a) && !vzero(b) && !vzero(c))
        n = vunit(vmadd(vmadd(vscale(a, 1 - u - v), b, u), c, v));
    return vzero(n) ? triangle_normal(mesh_triangle(m, i)) : n;
}

/* (1-u-v) ta + u tb + v tc: where to look in a picture that is wrapped round the mesh. *out stays
 * as it is if a corner has none. */
static inline bool mesh_texture(const mesh *m, size_t i, real u, real v, vec3 *out)
{
    const uint32_t *k = m->texture_index + 3 * i;
    if (!m->texture_index || k[0] == mesh_none || k[1] == mesh_none || k[2] == mesh_none)
        return false;
    *out = barycentric_mix(m->t[k[0]], m->t[k[1]], m->t[k[2]], u, v);
    return true;
}

/* Angle between two unit vectors, or 0 if one is zero. atan2 keeps its digits at all angles; acos
 * loses half of them near 0 and 180 degrees. */
static inline real mesh_angle(vec3 a, vec3 b) { return atan2(vlength(vcross(a, b)), vdot(a, b)); }

/* Replaces the normals by the sum, at each vertex, of its triangles' normals times their angles
 * there, made unit. A vertex that no triangle of any area touches gets a zero normal, and
 * mesh_normal then answers with the triangle's own. Vertices are smoothed by index: where a file
 * repeats a point, the crease stays sharp. O(triangles). */
static inline void mesh_smooth_normals(mesh *m)
{
    free(m->n);
    free(m->normal_index);
    m->normal_index = NULL;
    m->normals = m->vertices;
    m->n = allocate(m->vertices, sizeof *m->n);
    for (size_t i = 0; i < m->triangles; i++) {
        const uint32_t *k = m->index + 3 * i;
        triangle t = mesh_triangle(m, i);
        vec3 n = triangle_normal(t);  /* no area: zero, which adds nothing */
        vec3 e = vunit(vsub(t.b, t.a)), f = vunit(vsub(t.c, t.b)), g = vunit(vsub(t.a, t.c));
        real angle[3] = {mesh_angle(e, vneg(g)), mesh_angle(f, vneg(e)), mesh_angle(g, vneg(f))};
        for (int j = 0; j < 3; j++) m->n[k[j]] = vmadd(m->n[k[j]], n, angle[j]);
    }
    for (size_t j = 0; j < m->vertices; j++) m->n[j] = vunit(m->n[j]);
}

#endif
