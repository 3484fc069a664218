/* specks.h: tiny triangles a hair beside the edges of cells: where a walk that drifts goes wrong.
 * (Beside one wall would not do: the cells on both sides are passed, sooner or later.)
 *
 *   mesh m = specks_mesh(n, how, seed)     n triangles; a grid built with `how` has an edge, two
 *                                          walls, between 1e-7 and 1e-3 cells beside each of them
 *   ray r = specks_ray(&m, seed, i)        aimed at one of them
 */
#ifndef GRID_SPECKS_H
#define GRID_SPECKS_H

#include "../../../common/random.h"
#include "../grid.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void specks_set(mesh *m, size_t i, vec3 c, vec3 size)
{
    m->v[3 * i] = c;
    m->v[3 * i + 1] = vadd(c, (vec3){size.x, -size.y, 0});
    m->v[3 * i + 2] = vadd(c, (vec3){0, size.y, -size.z});
}

/* Two corners of the unit cube fix the box, and so the walls: built once to see where they are. */
static inline mesh specks_mesh(size_t n, grid_options how, uint64_t seed)
{
    mesh m = {.vertices = 3 * n, .triangles = n};
    failure f;
    grid g;
    m.v = allocate(3 * n, sizeof *m.v), m.index = allocate(3 * n, sizeof *m.index);
    for (size_t i = 0; i < 3 * n; i++) m.index[i] = (uint32_t)i;
    m.v[1] = m.v[2] = (vec3){1, 1, 1};
    items x = items_of_mesh(&m);
    if (!grid_build(&x, how, &g, &f)) fail(f);
    for (size_t i = 1; i < n; i++) {
        random_stream s = random_start(seed, i, 0);
        vec3 c = {random_next(&s), random_next(&s), random_next(&s)};
        int free_axis = (int)(random_next_bits(&s) % 3);
        real beside = pow((real)10, -3 - 4 * random_next(&s));
        for (int k = 0; k < 3; k++) {
            int wall = 1 + (int)(random_next_bits(&s) % 1024);
            real off = random_next_bits(&s) & 1 ? beside : -beside;
            if (k == free_axis) continue;
            ((real *)&c)[k] = vaxis(g.cells.lo, k)
                              + ((real)(wall % g.cells.n[k]) + off) * vaxis(g.cells.size, k);
        }
        c = vmax(vmin(c, (vec3){1, 1, 1}), (vec3){0, 0, 0});
        specks_set(&m, i, c, vscale(g.cells.size, beside / 4));
    }
    grid_free(&g);
    return m;
}

/* From beyond a corner of the cube, at the middle of a triangle. */
static inline ray specks_ray(const mesh *m, uint64_t seed, uint64_t i)
{
    random_stream s = random_start(seed, i, 1);
    triangle t = mesh_triangle(m, 1 + random_next_bits(&s) % (m->triangles - 1));
    vec3 o = {-random_next(&s), -random_next(&s), -random_next(&s)};
    vec3 p = vscale(vadd(vadd(t.a, t.b), t.c), 1 / (real)3);
    return ray_from(o, vsub(p, o));
}

#endif
