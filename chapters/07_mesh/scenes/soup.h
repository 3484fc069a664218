/* soup.h: triangles without order: each anywhere, none joined to another.
 *
 *   mesh m = mesh_room(n)                    room for n triangles that share no corner: v to be set
 *   mesh m = soup_mesh(n, half, size, seed)  n triangles anywhere in the cube [-half, half]^3,
 *                                            their corners within `size` of a point, by each axis
 *   mesh m = needle_mesh(n, width, seed)     n needles (狭长三角形) as long as the cube [-1, 1]^3 and
 *                                            `width` wide, at odd angles: their boxes are empty but
 *                                            for a line, and overlap all over
 *
 * The same seed gives the same mesh. mesh_free when done.
 */
#ifndef SCENES_SOUP_H
#define SCENES_SOUP_H

#include "../../../common/random.h"
#include "../mesh.h"

/* ---------------------------------------------------------------------------------------------- */

static inline mesh mesh_room(size_t n)
{
    mesh m = {.vertices = 3 * n, .triangles = n};
    m.v = allocate(m.vertices, sizeof *m.v);
    m.index = allocate(m.vertices, sizeof *m.index);
    for (size_t i = 0; i < m.vertices; i++) m.index[i] = (uint32_t)i;
    return m;
}

static inline mesh soup_mesh(size_t n, real half, real size, uint64_t seed)
{
    mesh m = mesh_room(n);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 0);
        vec3 c = random_in_cube(&g, half);
        for (size_t k = 0; k < 3; k++) m.v[3 * i + k] = vadd(c, random_in_cube(&g, size));
    }
    return m;
}

static inline mesh needle_mesh(size_t n, real width, uint64_t seed)
{
    mesh m = mesh_room(n);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 0);
        vec3 *v = m.v + 3 * i;
        v[0] = random_in_cube(&g, 1), v[1] = random_in_cube(&g, 1);
        v[2] = vadd(v[0], random_in_cube(&g, width));
    }
    return m;
}

#endif
