/* csg_scenes.h: the solids of this chapter, and what is needed to look at them.
 *
 *   csg_scene s = csg_scene_of(text)            an expression; exit 2 where it says nothing
 *   csg_scene_built(e)                          one that was read, or made; takes it
 *   csg_scene_pocket(mesh, shift)               a turned block, or a mesh of one, with pockets that
 *                                               are flush with its faces; beside it three foils
 *   csg_scene_free(&s)
 *   csg_scene_colour(&s, h)                     of the solid that was hit
 */
#ifndef CSG_SCENES_H
#define CSG_SCENES_H

#include "../../../common/options.h"
#include "../../02_camera/first.h"
#include "../csg.h"
#include "../files/expression.h"

typedef struct { csg_expression e; csg c; } csg_scene;

#define CSG_CLASSIC "difference(intersection(sphere 0 0 0 1.32, box -1 -1 -1 1 1 1), union(" \
    "cylinder 0 0 0 1 0 0 0.62, cylinder 0 0 0 0 1 0 0.62, cylinder 0 0 0 0 0 1 0.62))"

/* ---------------------------------------------------------------------------------------------- */

static inline csg_scene csg_scene_built(csg_expression e)
{
    csg_scene s = {.e = e};
    failure f;
    if (!csg_build(csg_expression_model(&e), (csg_options){0}, &s.c, &f)) fail(f);
    return s;
}

static inline csg_scene csg_scene_of(const char *text)
{
    csg_expression e;
    failure f;
    if (!csg_read(text, &e, &f)) die(2, "--expression %.100s%s: %.300s", text,
                                     strlen(text) > 100 ? ".." : "", f.text);
    return csg_scene_built(e);
}

static inline void csg_scene_free(csg_scene *s) { csg_free(&s->c), csg_expression_free(&s->e); }

/* Corners in the frame of the turned axes. */
static inline csg_solid csg_scene_block(const vec3 n[3], double x0, double y0, double z0, double x1,
                                        double y1, double z1)
{
    const real lo[3] = {(real)x0, (real)y0, (real)z0}, hi[3] = {(real)x1, (real)y1, (real)z1};
    return csg_box_turned(n, lo, hi);
}

/* Of the turned block: at right angles, of length 1, right-handed. */
static inline void csg_scene_axes(vec3 n[3])
{
    n[0] = vunit(vec(0.9, 0.1, -0.42)), n[1] = vunit(vcross(vec(-0.1, 0.2, 1), n[0]));
    n[2] = vcross(n[0], n[1]);
}

/* From lo to hi along axis k, turned round the place (u, v); w and h are half its sides. */
static inline csg_solid csg_scene_cut(const vec3 n[3], int k, double lo, double hi, double u,
                                      double v, double w, double h, double degrees)
{
    int i = (k + 1) % 3, j = (k + 2) % 3;
    double c = cos(degrees * 3.14159265358979 / 180), s = sin(degrees * 3.14159265358979 / 180);
    double x = u * c + v * s, y = v * c - u * s;
    vec3 axis[3] = {n[k], vadd(vscale(n[i], (real)c), vscale(n[j], (real)s)),
                    vsub(vscale(n[j], (real)c), vscale(n[i], (real)s))};
    return csg_scene_block(axis, lo, x - w, y - h, hi, x + w, y + h);
}

/* The cube of side 2 round `at` with these axes, as a mesh. Corner i is computed once: a mesh is
 * closed if its corners are shared to the last bit. */
static inline csg_solid csg_scene_cube(const vec3 n[3], vec3 at)
{
    static const int face[6][4] = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4},
                                   {4, 5, 7, 6}, {0, 2, 3, 1}};
    vec3 c[8];
    for (int i = 0; i < 8; i++) {
        vec3 p = vadd(vscale(n[0], i & 1 ? 1 : -1), vscale(n[1], i & 2 ? 1 : -1));
        c[i] = vadd(vadd(p, vscale(n[2], i & 4 ? 1 : -1)), at);
    }
    triangle *t = allocate(12, sizeof *t);
    for (int f = 0; f < 6; f++) {
        const int *q = face[f];
        t[2 * f] = (triangle){c[q[0]], c[q[1]], c[q[2]]};
        t[2 * f + 1] = (triangle){c[q[0]], c[q[2]], c[q[3]]};
    }
    return csg_mesh(t, 12);
}

static inline csg_scene csg_scene_pocket(bool mesh, vec3 shift)
{
    vec3 n[3];
    csg_scene_axes(n);
    enum { solids = 8, steps = 2 * solids - 1 };
    csg_expression e = {.solids = solids, .steps = steps};
    e.solid = allocate(solids, sizeof *e.solid), e.step = allocate(steps, sizeof *e.step);
    const csg_solid all[solids] = {
        csg_scene_block(n, -1, -1, -1, 1, 1, 1),
        csg_scene_cut(n, 1, 0.3, 1, 0.2, -0.45, 0.55, 0.22, 25),  /* two in the upper face */
        csg_scene_cut(n, 1, 0.5, 1, -0.1, 0.45, 0.4, 0.3, -20),
        csg_scene_cut(n, 2, 0.4, 1, -0.3, 0.15, 0.45, 0.45, 35),  /* in the front */
        csg_scene_block(n, 0.4, -1, 0.3, 1, -0.2, 1),           /* at an edge: flush with three */
        csg_scene_block(n, 1.3, 0.4, 0, 2.1, 1, 0.0002),        /* foils, 2e-4 to 2e-2 thick */
        csg_scene_block(n, 1.3, -0.3, 0, 2.1, 0.3, 0.002),
        csg_scene_block(n, 1.3, -1, 0, 2.1, -0.4, 0.02)};
    for (uint32_t i = 0; i < solids; i++) {
        e.solid[i] = all[i];
        for (int k = 0; k < 3; k++) {  /* one plane stays one: the same sum of the same numbers */
            e.solid[i].box.lo[k] += vdot(all[i].box.n[k], shift);
            e.solid[i].box.hi[k] += vdot(all[i].box.n[k], shift);
        }
        e.step[i ? 2 * i - 1 : 0] = (csg_step){CSG_SOLID, i};
        if (i) e.step[2 * i] = (csg_step){i < 5 ? CSG_DIFFERENCE : CSG_UNION, 0};
    }
    if (mesh) e.solid[0] = csg_scene_cube(n, shift);
    return csg_scene_built(e);
}

static const vec3 csg_paint[] = {{0.72, 0.10, 0.06}, {0.05, 0.20, 0.62}, {0.10, 0.50, 0.22},
                                 {0.85, 0.50, 0.04}, {0.05, 0.48, 0.50}, {0.50, 0.14, 0.42}};

static inline vec3 csg_scene_colour(const csg_scene *s, hit h)
{
    return csg_paint[csg_solid_of(&s->c, h) % (sizeof csg_paint / sizeof *csg_paint)];
}

#endif
