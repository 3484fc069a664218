/* motion.h: meshes that move (动画), frame by frame: the same triangles, their corners elsewhere.
 *
 *   mesh m = motion_mesh(MOTION_TWIST, fine)   the mesh at rest: MOTION_TWIST the teapot of that
 *                                  fineness; MOTION_SCATTER a soup of 1000 fine triangles
 *   motion_frame(kind, &rest, x, &m)     sets the corners of m, a motion_mesh itself, to those of
 *                                  the moment x [0, 1]; 0: at rest
 *
 * Twisting (x and what was long and straight becomes a spiral. Scattering sends each triangle its
 * own way: those that were side by side end far apart, in a cloud half as large again.
 */
#ifndef SCENES_MOTION_H
#define SCENES_MOTION_H

#include "soup.h"
#include "teapot.h"

typedef enum { MOTION_TWIST, MOTION_SCATTER, motions } motion;
static const char *const motion_name[motions] = {"twist", "scatter"};

/* ---------------------------------------------------------------------------------------------- */

static inline mesh motion_mesh(motion kind, int fine)
{
    size_t n = 1000 * (size_t)fine;
    return kind == MOTION_TWIST ? teapot_mesh(fine) : soup_mesh(n, 1, 1 / cbrt((real)n), 1703);
}

/* Two whole turns between the bottom and the top of the teapot, 3.15 high, when x = 1. */
static inline vec3 motion_twisted(vec3 p, real x)
{
    real a = 4 * pi * x * p.z / (real)3.15, c = cos(a), s = sin(a);
    return (vec3){c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

static inline void motion_frame(motion kind, const mesh *rest, real x, mesh *m)
{
    for (size_t i = 0; kind == MOTION_TWIST && i < rest->vertices; i++)
        m->v[i] = motion_twisted(rest->v[i], x);
    for (size_t i = 0; kind == MOTION_SCATTER && i < rest->triangles; i++) {
        random_stream g = random_start(1704, i, 0);
        vec3 way = vscale(random_in_cube(&g, (real)0.5), x);
        for (size_t k = 3 * i; k < 3 * i + 3; k++) m->v[k] = vadd(rest->v[k], way);
    }
}

#endif
