/* plane.h: trees in the plane, drawn: their cells, and those that a ray passes, numbered in order.
 *
 *   mesh m = plane_walls(height)         twenty walls that stand on the square [0, 10]^2, two
 *                                        triangles each, from z = 0 to z = height; mesh_free
 *   ray r = plane_ray(height)            level, at half their height; it ends at a wall
 *   plane_tree p = {.r = r, .h = h};     what a search has found
 *   plane_add(&p, q, n, full)            a cell: n corners [3, 12]; full: something is in it
 *   plane_order(&p)                      numbers those that the ray passes up to its hit, from 1
 *   plane_draw(&g, &p, &m)               cells, numbers, walls, ray, where figure_origin says
 *
 * White cells are empty, grey ones are not; blue ones are asked, light blue ones passed unasked.
 */
#ifndef TRIALS_PLANE_H
#define TRIALS_PLANE_H

#include "../../../common/lab/figure.h"
#include "../../07_mesh/mesh.h"

enum { plane_most = 256, plane_corners = 12, plane_house = 12, plane_pillars = 6,
       plane_all = plane_house + plane_pillars + 2 };

typedef struct {
    double xy[2 * plane_corners];  /* corners */
    int n, rank;
    bool full;
    real enter;
} plane_cell;
typedef struct { plane_cell cell[plane_most]; int cells, passed; ray r; hit h; } plane_tree;

/* ---------------------------------------------------------------------------------------------- */

/* Ends of wall i: a round house, a room full of pillars, two long walls. */
static inline void plane_ends(int i, vec3 end[2])
{
    static const real wall[2][4] = {{0.4, 9.3, 4.9, 7.4}, {3.4, 0.5, 9.5, 1.7}};
    static const real pillar[plane_pillars][2] = {{0.9, 1.8}, {1.7, 2.3}, {1.5, 0.5},
                                                  {1.2, 2.8}, {2.1, 3.0}, {0.6, 3.2}};
    for (int k = 0; k < 2; k++) {
        real a = (real)i;
        if (i < plane_house) {
            a = 2 * pi * (real)(i + k) / plane_house;
            end[k] = vmadd(vec(7, 6.7, 0), (vec3){cos(a), sin(a), 0}, (real)1.9);
        } else if (i < plane_house + plane_pillars) {
            const real *p = pillar[i - plane_house];
            end[k] = vmadd((vec3){p[0], p[1], 0}, (vec3){cos(a), sin(a), 0}, (real)0.32 * (real)k);
        } else {
            const real *w = wall[i - plane_house - plane_pillars];
            end[k] = (vec3){w[2 * k], w[2 * k + 1], 0};
        }
    }
}

static inline mesh plane_walls(real height)
{
    mesh m = {.vertices = 4 * plane_all, .triangles = 2 * plane_all};
    m.v = allocate(m.vertices, sizeof *m.v);
    m.index = allocate(3 * m.triangles, sizeof *m.index);
    for (uint32_t i = 0; i < plane_all; i++) {
        vec3 *v = m.v + 4 * i;
        const uint32_t a = 4 * i, corner[6] = {a, a + 1, a + 3, a, a + 3, a + 2};
        plane_ends((int)i, v);
        for (int k = 0; k < 2; k++) v[2 + k] = vadd(v[k], (vec3){0, 0, height});
        memcpy(m.index + 6 * i, corner, sizeof corner);
    }
    return m;
}

static inline ray plane_ray(real height)
{
    return ray_from((vec3){(real)0.45, (real)0.6, height / 2}, vunit(vec(1, 0.775, 0)));
}

/* Where the ray enters the cell, if it is there before its hit or just behind it (a hit may lie in
 * the side of a cell): the line against each side. */
static inline void plane_add(plane_tree *p, const vec3 *q, int n, bool full)
{
    if (p->cells == plane_most || n > plane_corners) return;
    plane_cell *c = &p->cell[p->cells++];
    real enter = 0, exit = p->h.t + (real)1e-3, turn = 0;
    *c = (plane_cell){.n = n, .full = full};
    for (int i = 0; i < n; i++) {
        vec3 a = q[i], b = q[(i + 1) % n];
        c->xy[2 * i] = (double)a.x, c->xy[2 * i + 1] = (double)a.y;
        turn += a.x * b.y - a.y * b.x;
    }
    for (int i = 0; i < n; i++) {  /* inside is where (q - a) . inwards >= 0 */
        vec3 a = q[i], e = vsub(q[(i + 1) % n], a), inwards = {-e.y, e.x, 0};
        if (turn < 0) inwards = vneg(inwards);
        real s = vdot(vsub(p->r.o, a), inwards), c1 = vdot(p->r.d, inwards), t = -s / c1;
        if (c1 > 0) enter = real_max(enter, t);
        else if (c1 < 0) exit = real_min(exit, t);
        else if (s < 0) exit = -1;
    }
    c->enter = enter, c->rank = exit - enter > (real)1e-5 ? 1 : 0;
}

static inline void plane_order(plane_tree *p)
{
    p->passed = 0;
    for (int i = 0; i < p->cells; i++) {
        int before = 0;
        if (!p->cell[i].rank) continue;
        for (int k = 0; k < p->cells; k++)
            before += p->cell[k].rank && p->cell[k].enter < p->cell[i].enter;
        p->cell[i].rank = before + 1, p->passed++;
    }
}

static inline const char *plane_colour(const plane_cell *c)
{
    return c->rank ? FIGURE_SKY : c->full ? FIGURE_GREY : "#ffffff";
}

/* In the middle of the cell. */
static inline void plane_number(figure *g, const plane_cell *c)
{
    double x = 0, y = 0;
    for (int i = 0; i < c->n; i++) x += c->xy[2 * i] / c->n, y += c->xy[2 * i + 1] / c->n;
    figure_dot(g, x, y, 8, "#ffffff");
    figure_print(g, x, y, 0, 5, FIGURE_MIDDLE, FIGURE_BLACK, "%d", c->rank);
}

static inline void plane_draw(figure *g, plane_tree *p, const mesh *m)
{
    vec3 end = ray_at(p->r, p->h.t);
    for (int i = 0; i < p->cells; i++) {
        const plane_cell *c = &p->cell[i];
        double opacity = c->rank ? c->full ? 0.75 : 0.25 : c->full ? 0.18 : 1;
        figure_polygon(g, c->n, c->xy, plane_colour(c), opacity, FIGURE_GREY);
    }
    for (size_t i = 0; i < m->vertices; i += 4)
        figure_line(g, (double)m->v[i].x, (double)m->v[i].y, (double)m->v[i + 1].x,
                    (double)m->v[i + 1].y, FIGURE_BLACK, 2.5, FIGURE_WHOLE);
    figure_line(g, (double)p->r.o.x, (double)p->r.o.y, (double)end.x, (double)end.y, FIGURE_RED, 2,
                FIGURE_WHOLE);
    figure_dot(g, (double)p->r.o.x, (double)p->r.o.y, 4, FIGURE_RED);
    figure_dot(g, (double)end.x, (double)end.y, 4, FIGURE_BLACK);
    for (int i = 0; i < p->cells; i++)
        if (p->cell[i].rank) plane_number(g, &p->cell[i]);
}

#endif
