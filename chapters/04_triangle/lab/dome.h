/* dome.h: the picture of this chapter. A dome of triangles on a wall, seen by three methods.
 *
 *    . . . . . . .      Each dot is a ray. Every tenth ray of every tenth row passes through a
 *    . .o-----o. .      corner of the mesh, computed from that very ray; so the rays between two
 *    . .|. . /|. .      corners run along an edge, but for rounding. A camera above a floor of
 *    . .|. /. |. .      tiles sees the same, or any picture of something built on its grid.
 *    . .o-----o. .
 *
 *   dome_draw(&o);       three panels, 3 x 3 pixels a ray: first.h, with a tolerance, watertight;
 *                        a fourth with a reader's own test (mine.h)
 *
 * Grey: hit once. Blue: twice or more. Orange: not at all, the light behind the wall glares
 * through.
 */
#ifndef TRIANGLE_DOME_H
#define TRIANGLE_DOME_H

#include "../../../common/headlight.h"
#include "../../../common/lab/panels.h"
#include "mine.h"
#include "triangle_variants.h"

enum { dome_cell = 10, dome_zoom = 3, dome_panels = 3 + triangle_mine };
typedef struct {
    triangle_method *method;
    int width, height;       /* of one panel, rays */
    vec3 right, up, back;    /* camera frame, turned so that no axis is along an axis */
} triangle_dome;

/* ---------------------------------------------------------------------------------------------- */

/* No round numbers: nothing is exact by chance. */
static const vec3 dome_eye = {0.1, 0.2, 0.3};

static inline vec3 dome_direction(const triangle_dome *s, int x, int y)  /* of one panel */
{
    real scale = (real)1.2 / (real)s->height, right = ((real)x - (real)s->width / 2) * scale;
    return vsub(vmadd(vscale(s->right, right), s->up, ((real)s->height / 2 - (real)y) * scale),
                s->back);
}

static inline vec3 dome_corner(const triangle_dome *s, int i, int j)
{
    vec3 d = dome_direction(s, dome_cell * i, dome_cell * j);
    real rest = (real)0.25 - (vdot(d, d) - 1);  /* > 0 where the wall bulges towards the eye */
    return vmadd(dome_eye, d, 4 - 2 * sqrt(real_max(rest, 0)));
}

/* One of the two of a cell. A corner is the same numbers for all that share it. */
static inline triangle dome_triangle(const triangle_dome *s, int i, int j, bool second)
{
    vec3 right = dome_corner(s, i + 1, j), below = dome_corner(s, i, j + 1);
    if (second) return (triangle){right, below, dome_corner(s, i + 1, j + 1)};
    return (triangle){dome_corner(s, i, j), below, right};
}

static vec3 dome_colour(const void *context, real x, real y)
{
    const triangle_dome *s = context;
    int px = (int)x / dome_zoom, py = (int)y / dome_zoom, hits = 0;
    ray r = ray_from(dome_eye, dome_direction(s, px, py));
    vec3 normal = {0, 0, 0};
    hit h;
    for (int k = 0; k < 18; k++) {  /* of the cells round the pixel: the others are far off */
        int i = px / dome_cell - 1 + k / 2 % 3, j = py / dome_cell - 1 + k / 6;
        triangle t = dome_triangle(s, i, j, k % 2);
        if (s->method(t, r, &h)) hits++, normal = triangle_normal(t);
    }
    if (hits > 1) return vec(0, 0.2, 0.8);
    if (!hits) return vec(1, 0.2, 0);
    return vscale(headlight(normal, r.d), 0.6);
}

cold_inline void dome_draw(const options *o)
{
    int gap = o->width >= 400 ? 6 : 0;  /* white, between two panels [pixels] */
    panels_shape g = {o->width, o->height, dome_panels, 1, gap, 1, true};
    triangle_dome s = {.width = (panels_wide(g) + dome_zoom - 1) / dome_zoom,
                       .height = (o->height + dome_zoom - 1) / dome_zoom,
                       .back = vunit((vec3){1, 2, 5})};
    vbasis(s.back, &s.right, &s.up);
    triangle_dome of[4] = {s, s, s, s};
    of[0].method = first_triangle_hit, of[1].method = triangle_hit_tolerant;
    of[2].method = triangle_hit, of[3].method = mine_triangle_hit;
    const panel p[4] = {{"first: Moller-Trumbore", &of[0]}, {"with a tolerance", &of[1]},
                        {"triangle_hit, watertight", &of[2]}, {"mine", &of[3]}};
    panels_draw(o, "04_triangle.png", true, g, dome_colour, p);
}

#endif
