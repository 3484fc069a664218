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
    int columns, rows;       /* of cells */
    triangle *tri;           /* two a cell, row by row */
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
    /* from one cell beyond the picture */
    vec3 d = dome_direction(s, dome_cell * (i - 1), dome_cell * (j - 1));
    real rest = (real)0.25 - (vdot(d, d) - 1);  /* > 0 where the wall bulges towards the eye */
    return vmadd(dome_eye, d, 4 - 2 * sqrt(real_max(rest, 0)));
}

/* For panels of so many pixels. */
static inline triangle_dome dome_new(int width, int height)
{
    triangle_dome s = {.back = vunit((vec3){1, 2, 5})};
    vbasis(s.back, &s.right, &s.up);
    s.width = (width + dome_zoom - 1) / dome_zoom, s.height = (height + dome_zoom - 1) / dome_zoom;
    s.columns = s.width / dome_cell + 3, s.rows = s.height / dome_cell + 3;
    triangle *next = s.tri = allocate(2 * (size_t)s.columns * (size_t)s.rows, sizeof *s.tri);
    for (int j = 0; j < s.rows; j++)
        for (int i = 0; i < s.columns; i++) {
            vec3 c[4];
            for (int k = 0; k < 4; k++) c[k] = dome_corner(&s, i + k % 2, j + k / 2);
            *next++ = (triangle){c[0], c[2], c[1]};
            *next++ = (triangle){c[1], c[2], c[3]};
        }
    return s;
}

static vec3 dome_colour(const void *context, real x, real y)
{
    const triangle_dome *s = context;
    int px = (int)x / dome_zoom, py = (int)y / dome_zoom;
    ray r = ray_from(dome_eye, dome_direction(s, px, py));
    hit h, best = hit_none;
    int hits = 0;
    int i0 = px / dome_cell, j0 = py / dome_cell;
    for (int j = j0; j < j0 + 3; j++)  /* the cells round the pixel: the others are far off */
        for (int i = i0; i < i0 + 3; i++)
            for (int k = 0; k < 2; k++) {
                int index = 2 * (j * s->columns + i) + k;
                if (!s->method(s->tri[index], r, &h)) continue;
                hits++, h.shape = (uint32_t)index;
                if (hit_before(h, best)) best = h;
            }
    if (hits > 1) return vec(0, 0.2, 0.8);
    if (!hits) return vec(1, 0.2, 0);
    return vscale(headlight(triangle_normal(s->tri[best.shape]), r.d), 0.6);
}

cold_inline void dome_draw(const options *o)
{
    int gap = o->width >= 400 ? 6 : 0;  /* white, between two panels [pixels] */
    panels_shape g = {o->width, o->height, dome_panels, 1, gap, 1, true};
    triangle_dome s = dome_new(panels_wide(g), o->height), of[4] = {s, s, s, s};
    of[0].method = first_triangle_hit, of[1].method = triangle_hit_tolerant;
    of[2].method = triangle_hit, of[3].method = mine_triangle_hit;
    const panel p[4] = {{"first: Moller-Trumbore", &of[0]}, {"with a tolerance", &of[1]},
                        {"triangle_hit, watertight", &of[2]}, {"mine", &of[3]}};
    panels_draw(o, "04_triangle.png", true, g, dome_colour, p);
    free(s.tri);
}

#endif
