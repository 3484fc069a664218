/* cell.h: the cells (单元) of a BSP tree: convex polyhedra, cut by one plane after another.
 *
 *       +-------+            A line that meets a convex cell, of all lines alike, meets the part
 *      /   /   /|            behind a plane with the probability
 *     +---/---+ |
 *     |  /|   | +                area of the part / area of the cell                       (13.2)
 *     | / |front|/
 *     |/back   |/            areas of whole surfaces, the cut included (chapter 09: Cauchy): what
 *     +-------+              the surface area heuristic needs, exactly, of slanted cells, too.
 *
 *   convex c = cell_box(&store, half)         the box |q_k| <= half_k; -half and half differ
 *   cell_areas(&store, c, p, &back, &front) of the parts: nothing is made
 *   convex d = cell_cut(&store, c, p, sign)   the part with sign * s <= 0, on top of the store
 *   real a = cell_area(&store, c)
 *   cell_box_of(&store, c, &lo, &hi)        the axis-aligned box around it
 *
 * The store is a stack: a builder that goes down the tree keeps the cells of one path, no more. Who
 * sets `corners` and `faces` back to what they were gives up what was made since.
 * Nothing here must be exact: areas choose planes, they do not decide who is in a cell.
 *
 * Source: T. Ize, I. Wald, S. G. Parker, "Ray Tracing with the BSP Tree", IEEE Symposium on
 * Interactive Ray Tracing 2008, section 4.
 */
#ifndef BSP_CELL_H
#define BSP_CELL_H

#include "../../common/file.h"
#include "side.h"

enum { cell_most_corners = 160 };  /* of a face; what has more is not cut any further */

typedef struct { uint32_t corner, corners; real area; } cell_face;
typedef struct { uint32_t face, faces; } convex;
typedef struct {
    vec3 *corner;
    cell_face *face;
    size_t corners, faces, corner_room, face_room;
} cell_store;

/* ---------------------------------------------------------------------------------------------- */

static inline void cells_free(cell_store *s)
{
    free(s->corner), free(s->face);
    *s = (cell_store){0};
}

static inline void cell_reserve(cell_store *s, size_t corners)
{
    s->corner = grown_by(s->corner, s->corners, corners, &s->corner_room, sizeof *s->corner);
}

/* Area times normal of a flat polygon. */
static inline vec3 polygon_area(const vec3 *q, size_t n)
{
    vec3 sum = {0, 0, 0};
    for (size_t i = 2; i < n; i++)
        sum = vadd(sum, vcross(vsub(q[i - 1], q[0]), vsub(q[i], q[0])));
    return vscale(sum, 0.5);
}

static inline real length_of(vec3 a) { return sqrt(vdot(a, a)); }

/* A face of the corners that were put on top of the store. */
static inline void cell_add_face(cell_store *s, convex *c, size_t corners)
{
    if (corners < 3) return;
    s->face = grown(s->face, s->faces, &s->face_room, sizeof *s->face);
    const vec3 *q = s->corner + s->corners;
    s->face[s->faces++] = (cell_face){(uint32_t)s->corners, (uint32_t)corners,
                                      length_of(polygon_area(q, corners))};
    s->corners += corners;
    c->faces++;
}

static inline convex cell_box(cell_store *s, vec3 half)
{
    convex c = {(uint32_t)s->faces, 0};
    for (int i = 0; i < 6; i++) {
        int k = i % 3;
        cell_reserve(s, 4);
        for (int j = 0; j < 4; j++) {
            real *q = (real *)&s->corner[s->corners + (size_t)(i < 3 ? 3 - j : j)];
            q[k] = i < 3 ? -1 : 1;
            q[(k + 1) % 3] = j == 1 || j == 2 ? 1 : -1;
            q[(k + 2) % 3] = j >= 2 ? 1 : -1;
        }
        for (size_t j = 0; j < 4; j++)
            s->corner[s->corners + j] = vmul(s->corner[s->corners + j], half);
        cell_add_face(s, &c, 4);
    }
    return c;
}

static inline real cell_area(const cell_store *s, convex c)
{
    real sum = 0;
    for (uint32_t i = 0; i < c.faces; i++) sum += s->face[c.face + i].area;
    return sum;
}

static inline void cell_box_of(const cell_store *s, convex c, vec3 *lo, vec3 *hi)
{
    *lo = (vec3){real_infinity, real_infinity, real_infinity}, *hi = vneg(*lo);
    for (uint32_t i = 0; i < c.faces; i++) {
        const cell_face *f = &s->face[c.face + i];
        for (uint32_t j = 0; j < f->corners; j++) {
            vec3 q = s->corner[f->corner + j];
            *lo = vmin(q, *lo), *hi = vmax(q, *hi);
        }
    }
}

/* One face: the area behind the plane, and where the border of that part runs along the plane, from
 * *from to *to; `crosses` if it does. All faces turn the same way, so these pieces make one round:
 * their cross products add up to twice the area of the cut. */
static inline real face_back(const split_plane *p, const vec3 *q, size_t n, real area,
                             vec3 *from, vec3 *to, bool *crosses)
{
    real sa = side_of(p, q[n - 1]), s0 = 0;
    vec3 a = q[n - 1], first = {0, 0, 0}, last = {0, 0, 0}, sum = {0, 0, 0};
    size_t m = 0;
    bool any_front = false;
    *crosses = false;
    for (size_t i = 0; i < n; i++) {
        vec3 b = q[i], c = b;
        real sb = side_of(p, b);
        s0 = sb;
        for (int part = 0; part < 2; part++) {  /* the crossing of a b, if there is one; then b */
            if (part == 0) {
                if ((sa <= 0) == (sb <= 0)) continue;
                c = clip_point(a, b, sa, sb);
                *(sb > 0 ? from : to) = c;
                *crosses = true;
            } else if (s0 <= 0) c = b;
            else { any_front = true; continue; }
            if (m == 0) first = c;
            else sum = vadd(sum, vcross(vsub(last, first), vsub(c, first)));
            last = c, m++;
        }
        a = b, sa = sb;
    }
    return any_front ? length_of(sum) / 2 : area;
}

static inline void cell_areas(const cell_store *s, convex c, const split_plane *p, real *back,
                              real *front)
{
    vec3 sum = {0, 0, 0}, o = {0, 0, 0}, from, to;
    real all = 0, behind = 0;
    bool crosses, any = false;
    for (uint32_t i = 0; i < c.faces; i++) {
        const cell_face *f = &s->face[c.face + i];
        behind += face_back(p, s->corner + f->corner, f->corners, f->area, &from, &to, &crosses);
        all += f->area;
        if (!crosses) continue;
        if (!any) o = from, any = true;
        sum = vadd(sum, vcross(vsub(from, o), vsub(to, o)));
    }
    real cut = length_of(sum) / 2;
    *back = behind + cut;
    *front = real_max(all - behind, 0) + cut;
}

/* Corners of the cut in order about their middle: by the angle, without trigonometry. */
static inline real turn_of(vec3 q, vec3 o, vec3 u, vec3 v)
{
    real x = vdot(vsub(q, o), u), y = vdot(vsub(q, o), v), sum = fabs(x) + fabs(y);
    real r = sum > 0 ? x / sum : 0;
    return y < 0 ? r - 1 : 1 - r;
}

static inline void cell_add_cut(cell_store *s, convex *c, const split_plane *p, real sign,
                                const vec3 *cut, size_t n)
{
    real turn[cell_most_corners];
    vec3 o = {0, 0, 0}, u, v;
    vbasis(vscale(p->n, sign), &u, &v);
    for (size_t i = 0; i < n; i++) o = vmadd(o, cut[i], 1 / (real)n);
    cell_reserve(s, n);
    vec3 *q = s->corner + s->corners;
    for (size_t i = 0; i < n; i++) {
        real w = turn_of(cut[i], o, u, v);
        size_t j = i;
        for (; j > 0 && turn[j - 1] > w; j--) turn[j] = turn[j - 1], q[j] = q[j - 1];
        turn[j] = w, q[j] = cut[i];
    }
    cell_add_face(s, c, n);
}

static inline convex cell_cut(cell_store *s, convex whole, const split_plane *p, real sign)
{
    convex c = {(uint32_t)s->faces, 0};
    vec3 cut[cell_most_corners], from, to;
    size_t n = 0;
    bool crosses;
    for (uint32_t i = 0; i < whole.faces; i++) {
        cell_face f = s->face[whole.face + i];
        if (f.corners >= cell_most_corners) continue;
        cell_reserve(s, 2 * f.corners);
        const vec3 *q = s->corner + f.corner;
        (void)face_back(p, q, f.corners, f.area, &from, &to, &crosses);
        if (crosses && n < cell_most_corners) cut[n++] = sign > 0 ? from : to;
        cell_add_face(s, &c, clip(p, sign, 0, q, f.corners, s->corner + s->corners));
    }
    cell_add_cut(s, &c, p, sign, cut, n);
    return c;
}

#endif
