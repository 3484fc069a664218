/* stadium.h: the teapot in a stadium (体育场里的茶壶): the scene that cells of one size cannot serve.
 *
 *   mesh m = stadium_mesh(n)     a fine teapot of 64 n^2 - 8 n triangles in the middle of one of
 *                                4032, 100 times as large; mesh_free releases it
 *
 * Cells small enough for the teapot are too many for the stadium; cells fit for the stadium hold
 * the whole teapot in one. Source of the name: E. Haines, "Spline Surface Rendering, and What's
 * Wrong with Octrees", Ray Tracing News 1(2), 1988.
 */
#ifndef MESH_STADIUM_H
#define MESH_STADIUM_H

#include "teapot.h"

/* ---------------------------------------------------------------------------------------------- */

static inline mesh stadium_mesh(int n)
{
    mesh a = teapot_mesh(n), b = teapot_mesh(8), m = {0};
    m.vertices = a.vertices + b.vertices, m.triangles = a.triangles + b.triangles;
    m.v = allocate(m.vertices, sizeof *m.v);
    m.index = allocate(3 * m.triangles, sizeof *m.index);
    memcpy(m.v, a.v, a.vertices * sizeof *m.v);
    memcpy(m.index, a.index, 3 * a.triangles * sizeof *m.index);
    for (size_t i = 0; i < b.vertices; i++)
        m.v[a.vertices + i] = vadd(vscale(b.v[i], 100), (vec3){20, 30, -150});
    for (size_t i = 0; i < 3 * b.triangles; i++)
        m.index[3 * a.triangles + i] = b.index[i] + (uint32_t)a.vertices;
    mesh_free(&a), mesh_free(&b);
    return m;
}

#endif
