/* first.h: a uniform grid (均匀网格): 27 cells a triangle, each with the list of triangles in it.
 * Wrong far away: from 1e4 sizes in float, 1e13 in double, rounding puts rays into wrong cells.
 * grid.h mends it. At most 256 cells a side; fewer where triangles are long. */
#ifndef FIRST_GRID_H
#define FIRST_GRID_H
#include "../07_mesh/first.h"
#include "../09_aabb/first.h"

typedef struct { int triangle, next; } first_grid_item;  /* next: the following one, or -1 */

typedef struct {
    const first_mesh *m;
    aabb box;               /* of all triangles */
    int n[3];               /* cells along x, y, z */
    real size[3];           /* of a cell */
    int *head;              /* [n0 n1 n2] where each cell's list begins, or -1 */
    first_grid_item *item;
    size_t items;
} first_grid;

static inline int first_grid_index(const first_grid *g, const int cell[3])
{
    return (cell[2] * g->n[1] + cell[1]) * g->n[0] + cell[0];
}

/* The number of the cell, along axis k, that p is in. */
static inline int first_grid_cell(const first_grid *g, vec3 p, int k)
{
    return (int)real_clamp((vaxis(p, k) - vaxis(g->box.lo, k)) / g->size[k], 0, g->n[k] - 1);
}

/* The cells, from lo to hi along each axis, that a box touches; returns how many. */
static inline size_t first_grid_range(const first_grid *g, aabb b, int lo[3], int hi[3])
{
    size_t cells = 1;
    for (int k = 0; k < 3; k++) {
        lo[k] = first_grid_cell(g, b.lo, k);
        hi[k] = first_grid_cell(g, b.hi, k);
        cells *= (size_t)(hi[k] - lo[k] + 1);
    }
    return cells;
}

/* The size of the cells, and how many items will be in all lists together. */
static inline size_t first_grid_measure(first_grid *g, real hair)
{
    int lo[3], hi[3];
    size_t sum = 0;
    for (int k = 0; k < 3; k++)
        g->size[k] = (vaxis(g->box.hi, k) - vaxis(g->box.lo, k)) / g->n[k];
    for (int i = 0; i < g->m->n; i++) {
        aabb b = first_aabb_pad(first_triangle_box(g->m->tri[i]), hair);
        sum += first_grid_range(g, b, lo, hi);
    }
    return sum;
}

/* 1. The box. 2. The grid. 3. Each triangle goes into the list of each cell its box touches. */
static inline first_grid first_grid_build(const first_mesh *m)
{
    real hair;
    first_grid g = {.m = m, .box = first_triangles_box(m->tri, m->n, &hair)};
    if (m->n == 0) return g;

    /* Cubes, 27 for each triangle: n_k = s_k (27 n / (sx sy sz))^(1/3)                   (10.3) */
    vec3 s = vsub(g.box.hi, g.box.lo);
    real per_unit = cbrt(27.0 * m->n / (s.x * s.y * s.z));
    for (int k = 0; k < 3; k++) g.n[k] = (int)real_clamp(vaxis(s, k) * per_unit, 1, 256);

    /* Long triangles are in many cells: then half as many a side, and again, or memory ends. */
    while (first_grid_measure(&g, hair) > 100 * (size_t)m->n)
        for (int k = 0; k < 3; k++) g.n[k] = (g.n[k] + 1) / 2;
    size_t cells = (size_t)g.n[0] * (size_t)g.n[1] * (size_t)g.n[2], room = 0;
    g.head = allocate(cells, sizeof *g.head);
    for (size_t i = 0; i < cells; i++) g.head[i] = -1;

    for (int i = 0; i < m->n; i++) {
        int lo[3], hi[3], c[3];
        first_grid_range(&g, first_aabb_pad(first_triangle_box(m->tri[i]), hair), lo, hi);
        for (c[2] = lo[2]; c[2] <= hi[2]; c[2]++)
            for (c[1] = lo[1]; c[1] <= hi[1]; c[1]++)
                for (c[0] = lo[0]; c[0] <= hi[0]; c[0]++) {
                    int *head = &g.head[first_grid_index(&g, c)];
                    g.item = grown(g.item, g.items, &room, sizeof *g.item);
                    g.item[g.items] = (first_grid_item){i, *head};
                    *head = (int)g.items++;
                }
    }
    return g;
}

/* From cell to cell along the ray, as a line is drawn in pixels: the next wall decides where to. */
static inline bool first_grid_hit(const first_grid *g, ray r, hit *out)
{
    real t, t_exit, next[3], delta[3];
    int cell[3], step[3];
    if (g->m->n == 0) return false;
    r.d = vadd(r.d, vec(0, 0, 0));  /* -0.0 + 0 is 0, which (9.1) can take */
    first_slabs(g->box, r, &t, &t_exit);
    t = real_max(t, r.tmin);
    if (!(t <= real_min(t_exit, r.tmax))) return false;

    /* The cell where the ray enters, and t at the walls: next + j delta for the j-th.    (10.4) */
    vec3 p = ray_at(r, t);
    for (int k = 0; k < 3; k++) {
        real d = vaxis(r.d, k);
        cell[k] = first_grid_cell(g, p, k);
        step[k] = d < 0 ? -1 : 1;
        real wall = vaxis(g->box.lo, k) + (cell[k] + (d < 0 ? 0 : 1)) * g->size[k];
        next[k] = d == 0 ? real_infinity : (wall - vaxis(r.o, k)) / d;
        delta[k] = d == 0 ? real_infinity : g->size[k] / fabs(d);
    }
    for (bool found = false; ; ) {
        for (int i = g->head[first_grid_index(g, cell)]; i >= 0; i = g->item[i].next)
            if (first_mesh_test(g->m, g->item[i].triangle, &r, out)) found = true;

        /* A hit may lie beyond this cell, behind something in the next one: it is not final until
         * the walk has come to it. (A hit has shortened the ray.) */
        int k = next[0] <= next[1] ? (next[0] <= next[2] ? 0 : 2) : (next[1] <= next[2] ? 1 : 2);
        if (next[k] > r.tmax) return found;
        cell[k] += step[k];
        next[k] += delta[k];
        if (cell[k] < 0 || cell[k] >= g->n[k]) return found;
    }
}

static inline void first_grid_free(first_grid *g)
{
    free(g->head), free(g->item);
    *g = (first_grid){.m = NULL};
}
#endif
