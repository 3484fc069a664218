/* build.h: building a uniform grid; see grid.h.
 *
 *   grid_bounds, grid_resolution, grid_mark     the three steps of the notes
 *   bool grid_build(&x, how, &g, &f)            all of them
 */
#ifndef GRID_BUILD_H
#define GRID_BUILD_H

#include "mailbox.h"
#include "marking.h"

typedef struct {
    double density;    /* cells an item: 1e-6 to 1e6 */
    bool exact;        /* cells that the item touches; false: that its bounds overlap */
    bool mailbox;
    size_t most_bytes; /* false from grid_build, rather than more */
} grid_options;

#define grid_defaults ((grid_options){27, true, true, (size_t)1 << 30})

typedef struct {
    lattice cells;
    aabb box;          /* of the lattice: bounds of the items, and `margin` around */
    real margin, near; /* [scene units] */
    cell_lists lists;
    items x;
    size_t entered;    /* items that can be hit */
    bool mailbox;
} grid;

/* ---------------------------------------------------------------------------------------------- */

/* In float, 1e-7 of a distance is 1e-4 of a cell: what is paid in advance is less. */
#define grid_reach (real_is_float ? 4 : 1024)

/* 2. (10.3). Axes thinner than a cell are left out, one after the other. Sides are measured by the
 * longest: the volume of a box of 1e-110 is 0 in double. No cell is below 8 of the margin. */
static inline void grid_resolution(aabb box, double cells, real margin, int n[3])
{
    bool cut[3] = {true, true, true};
    vec3 side = vsub(box.hi, box.lo);
    real longest = vaxis(side, vlongest(side));
    for (int round = 0; round < 3; round++) {
        double volume = 1, per = 0;
        int axes = 0, thin = -1;
        for (int k = 0; k < 3; k++)
            if (cut[k]) volume *= (double)(vaxis(side, k) / longest), axes++;
        if (axes > 0) per = pow(cells / volume, 1.0 / axes);  /* cells along the longest side */
        for (int k = 0; k < 3; k++) {
            int most = (int)real_clamp(vaxis(side, k) / (8 * margin), 1, 1 << 20);
            double want = cut[k] ? (double)(vaxis(side, k) / longest) * per : 1;
            n[k] = want < most ? (int)(want + 0.5) : most;
            n[k] = n[k] > 1 ? n[k] : 1;
            if (cut[k] && want < 1 && (thin < 0 || vaxis(side, k) < vaxis(side, thin))) thin = k;
        }
        if (thin < 0) break;
        cut[thin] = false;
    }
}

/* 1. Widened by the margin: for query_delta of the rays that begin near, and 8 epsilon of the
 * largest coordinate for walls and bounds: 2 are owed, a half each for the box, an item's bounds
 * and margin, a wall, and a wall's margin. What is near may be chosen freely: of rays from farther
 * off query_delta is more, and they go another way. */
static inline bool grid_bounds(const items *x, grid *g, failure *f)
{
    aabb all;
    if (!items_all_bounds(x, &all, f)) return false;
    if (aabb_is_empty(all)) all = (aabb){{0, 0, 0}, {0, 0, 0}};
    vec3 side = vsub(all.hi, all.lo);
    real longest = vaxis(side, vlongest(side)), tiny = real_smallest / real_epsilon;
    g->near = 512 * real_epsilon * (grid_reach * longest) + tiny;
    g->margin = g->near + 8 * real_epsilon * aabb_reach(all) + tiny;
    g->box = first_aabb_pad(all, g->margin);
    return true;
}

static inline void grid_free(grid *g)
{
    lists_free(&g->lists);
    *g = (grid){.entered = 0};
}

/* 3. Last to first: each list ascends, so at equal t the first one asked wins at once. */
static inline bool grid_mark(grid *g, grid_options how, failure *f)
{
    marking mark = {&g->x, g->cells, g->margin, how.exact};
    cell_lists *l = &g->lists;
    if (!lists_begin(lattice_cells(&g->cells), how.most_bytes, l, f)) return false;
    for (size_t i = 0; i < g->x.n; i++) {
        lists_enter(l, &mark, i, 0);
        if (!lists_fit(l, f)) return false;
    }
    lists_sum(l);
    for (size_t i = g->x.n; i-- > 0;) lists_enter(l, &mark, i, 0);
    lists_finish(l);
    return true;
}

/* Cells an item touches, on average, of a sample of at most 64 items. */
static inline double grid_sample(const grid *g, grid_options how)
{
    marking mark = {&g->x, g->cells, g->margin, how.exact};
    size_t step = g->x.n / 64 + 1, asked = 0;
    cell_lists l = {.counting = true};
    for (size_t i = 0; i < g->x.n; i += step) lists_enter(&l, &mark, i, 0), asked++;
    return asked ? (double)l.references / (double)asked : 0;
}

static inline void grid_cut(grid *g, double density)
{
    int n[3];
    grid_resolution(g->box, density * (double)g->entered, g->margin, n);
    g->cells = lattice_of(g->box, n);
}

/* Items that lie on top of each other touch many cells each, a thousand and more: then cells are
 * taken larger, so that lists hold some 64 an item (references grow with the area of the items, as
 * cells^(2/3)). A few cells are tried first, then more: to count those of a pile in all would take
 * longer than to build. */
static inline void grid_fit(grid *g, grid_options how)
{
    double each, n = (double)g->entered, most = 1024 * n < 0x1p24 ? 1024 * n : 0x1p24;
    double room = structure_room(g->entered) + most;
    for (double part = 0x1p-12; part <= 1; part *= 16) {
        grid_cut(g, how.density * part);
        each = grid_sample(g, how);
        if (each * n <= room) continue;
        grid_cut(g, how.density * part * pow(64 / each, 1.5));
        break;
    }
}

static inline bool grid_build(const items *x, grid_options how, grid *out, failure *f)
{
    aabb b;
    *out = (grid){.x = *x, .mailbox = how.mailbox};
    if (!(how.density >= 1e-6 && how.density <= 1e6))
        return failed(f, 2, "density %g: allowed are 1e-6 to 1e6 cells an item", how.density);
    if (!grid_bounds(x, out, f)) return false;
    for (size_t i = 0; i < x->n; i++) out->entered += items_bounds(x, i, &b);
    grid_fit(out, how);
    if (grid_mark(out, how, f)) return true;
    grid_free(out);
    return false;
}

/* Asks the items of a cell; true if one was closer than the best so far (any: was hit). */
fast_inline bool grid_ask(const grid *g, size_t cell, query *q, mailbox *seen, bool any,
                          search_work *work)
{
    const cell_lists *l = &g->lists;
    return cell_marked(l, cell)
           && mailbox_ask(seen, g->mailbox, q, &g->x, l->item + l->first[cell],
                          l->item + l->first[cell + 1], any, work);
}

#endif
