/* nested.h: a grid in the cells of a grid (两层网格): for scenes that are dense in one place.
 *
 *     +-----------+-----------+     Few large cells; each that holds anything is cut again, finely
 *     |           |  +-+-+-+  |     if it holds much: not all of it, but the box around what is in
 *     |           |  +-+-+-+  |     it. A ray passes empty space in large steps, and the teapot in
 *     |           |  +-+-+-+  |     the stadium has cells of its own size.
 *     |           |  |  |  |  |
 *     +-----------+-----------+     nested_build, nested_hit, ..: the verbs of structure.h
 *
 * Cells of the outer grid: outer n; of a cell with k items: inner k, at most 255 on an axis; both
 * by (10.3). Items that span more than half of the outer cell cannot be cut apart: for them alone
 * it is cut into 27 at most, and no longer once they have named structure_room cells (a pile of
 * triangles in one place). All inner cells of all outer ones share the two arrays of marking.h.
 *
 * The inner walk takes over at the t at which the outer cell begins, and ends where it ends. Every
 * t belongs to some outer cell whose turn it is, and in it to an inner one, or to the space beside
 * the inner box, where nothing can be hit: what grid.h says of rounding holds here word for word.
 *
 * Sources: D. Jevans, B. Wyvill, "Adaptive Voxel Subdivision for Ray Tracing", Graphics Interface
 * 1989; J. Kalojanov, M. Billeter, P. Slusallek, "Two-Level Grids for Ray Tracing on GPUs",
 * Computer Graphics Forum 30(2), 2011 (two levels, flat arrays).
 */
#ifndef GRID_NESTED_H
#define GRID_NESTED_H

#include "../grid.h"

typedef struct {
    double outer, inner;  /* cells an item: outer grid; cell of the outer grid. 1e-6 to 1e6 */
    bool exact, mailbox;
    size_t most_bytes;    /* at any time while it is built */
} nested_options;

#define nested_defaults ((nested_options){0.1, 4, true, true, (size_t)1 << 30})

typedef struct {
    aabb box;             /* around what its items have in the outer cell, and the margin */
    uint32_t base;        /* its cells are base, base + 1, .. of the lists */
    uint8_t n[3];
} nested_part;

typedef struct {
    grid g;               /* g.cells: the outer lattice; g.lists: of all inner cells */
    uint32_t *part_of;    /* [outer cells] number of its part; 0: empty */
    nested_part *part;    /* [parts], from 1 on */
    size_t parts, peak;
    double named;         /* cells by items that cannot be cut apart, at most */
} nested;

/* ---------------------------------------------------------------------------------------------- */

static inline void nested_free(nested *x)
{
    grid_free(&x->g);
    free(x->part_of), free(x->part);
    *x = (nested){.parts = 0};
}

fast_inline lattice nested_lattice(const nested_part *p)
{
    return lattice_of(p->box, (int[3]){p->n[0], p->n[1], p->n[2]});
}

/* Around the parts of the items in the cell; the cell, and that box, are widened by the margin:
 * what grid.h says of rounding needs the first to hold items beside the cell, the second to hold
 * hits beside the items. *small: items that span at most half of the cell on every axis. */
static inline aabb nested_box(const nested *x, const uint32_t *item, size_t k, aabb cell,
                              size_t *small)
{
    vec3 half = vscale(vsub(cell.hi, cell.lo), 0.5);
    aabb wide_cell = first_aabb_pad(cell, x->g.margin), all = aabb_empty();
    *small = 0;
    for (size_t i = 0; i < k; i++) {
        aabb b = cell;
        (void)items_bounds(&x->g.x, item[i], &b);
        b = (aabb){vmax(b.lo, wide_cell.lo), vmin(b.hi, wide_cell.hi)};
        vec3 e = vsub(b.hi, b.lo);
        *small += e.x <= half.x && e.y <= half.y && e.z <= half.z;
        all = aabb_union(b, all);
    }
    return first_aabb_pad(all, x->g.margin);
}

/* Cuts outer cell c, with k items. False: more cells than a reference can count. */
static inline bool nested_cut(nested *x, size_t c, const uint32_t *item, size_t k, double inner,
                              size_t *cells)
{
    const lattice *l = &x->g.cells;
    size_t row = (size_t)l->n[0], layer = row * (size_t)l->n[1], small;
    int at[3] = {(int)(c % row), (int)(c % layer / row), (int)(c / layer)}, n[3];
    nested_part *p = &x->part[++x->parts];
    p->box = nested_box(x, item, k, lattice_box(l, at, at, 0), &small);
    double want = inner * (double)k, apart = inner * (double)small;
    if (want > 27) want = apart > 27 ? apart : 27;
    grid_resolution(p->box, want, x->g.margin, n);
    double names = (double)(k - small) * n[0] * n[1] * n[2];
    if (x->named + names > structure_room(x->g.entered)) n[0] = n[1] = n[2] = 1;
    else x->named += names;
    p->base = (uint32_t)*cells;
    for (int a = 0; a < 3; a++) p->n[a] = (uint8_t)(n[a] < 255 ? n[a] : 255);
    x->part_of[c] = (uint32_t)x->parts;
    *cells += (size_t)p->n[0] * p->n[1] * p->n[2];
    return *cells < UINT32_MAX;
}

/* Enters the items of all outer cells into the inner ones: pass 1 or pass 2 of marking.h. */
static inline bool nested_mark(nested *x, const cell_lists *outer, bool exact, failure *f)
{
    cell_lists *l = &x->g.lists;
    marking mark = {&x->g.x, x->g.cells, x->g.margin, exact};
    for (size_t c = outer->cells; c-- > 0;) {
        if (!x->part_of[c]) continue;
        const nested_part *p = &x->part[x->part_of[c]];
        mark.cells = nested_lattice(p);
        for (uint32_t i = outer->first[c + 1]; i-- > outer->first[c];) {
            lists_enter(l, &mark, outer->item[i], p->base);
            if (!l->item && !lists_fit(l, f)) return false;
        }
    }
    return true;
}

static inline bool nested_fill(nested *x, const cell_lists *outer, nested_options how, failure *f)
{
    size_t cells = 0, held = lists_bytes(outer) + outer->cells * sizeof *x->part_of
                             + (outer->marked_cells + 1) * sizeof *x->part;
    if (held > how.most_bytes)
        return failed(f, 1, "two-level grid: %zu outer cells do not fit into %zu bytes",
                      outer->cells, how.most_bytes);
    x->part_of = allocate(outer->cells, sizeof *x->part_of);
    x->part = allocate(outer->marked_cells + 1, sizeof *x->part);
    for (size_t c = 0; c < outer->cells; c++) {
        size_t k = outer->first[c + 1] - outer->first[c];
        if (k && !nested_cut(x, c, outer->item + outer->first[c], k, how.inner, &cells))
            return failed(f, 1, "two-level grid: more than %u cells", (unsigned)UINT32_MAX);
    }
    if (!lists_begin(cells, how.most_bytes - held, &x->g.lists, f)) return false;
    if (!nested_mark(x, outer, how.exact, f)) return false;
    lists_sum(&x->g.lists);
    nested_mark(x, outer, how.exact, f);
    lists_finish(&x->g.lists);
    return true;
}

static inline size_t nested_bytes(const nested *x)
{
    return lists_bytes(&x->g.lists) + (x->parts + 1) * sizeof *x->part
           + lattice_cells(&x->g.cells) * sizeof *x->part_of;
}

static inline bool nested_build(const items *x, nested_options how, nested *out, failure *f)
{
    *out = (nested){.parts = 0};
    if (!(how.inner >= 1e-6 && how.inner <= 1e6))
        return failed(f, 2, "inner density %g: allowed are 1e-6 to 1e6 cells an item", how.inner);
    grid_options outer = {how.outer, how.exact, how.mailbox, how.most_bytes};
    if (!grid_build(x, outer, &out->g, f)) return false;
    cell_lists lists = out->g.lists;
    out->g.lists = (cell_lists){.cells = 0};
    bool built = nested_fill(out, &lists, how, f);
    out->peak = nested_bytes(out) + lists_bytes(&lists);
    lists_free(&lists);
    if (!built) nested_free(out);
    return built;
}

/* All inner cells of an outer one. */
fast_inline bool nested_ask(const grid *g, size_t cell, query *q, mailbox *seen, bool any,
                            search_work *work)
{
    const nested *x = (const nested *)g;  /* its first member */
    const nested_part *p = &x->part[x->part_of[cell]];
    bool found = false;
    for (size_t i = 0, n = (size_t)p->n[0] * p->n[1] * p->n[2]; i < n && !(found && any); i++)
        found |= grid_ask(g, p->base + i, q, seen, any, work);
    return found;
}

/* The walk through one outer cell, from t to `end`. */
fast_inline bool nested_pass(const nested *x, const nested_part *p, const grid_line *a, real t,
                             real end, query *q, mailbox *seen, bool any, search_work *work)
{
    if (!grid_span(p->box, a, &t, &end)) return false;
    lattice inner = nested_lattice(p);
    grid_walk w = walk_from(&inner, a, t);
    w.cell += p->base;
    return grid_pass(&x->g, w, a, end, q, seen, any, work);
}

fast_inline bool nested_search(const nested *x, ray r, bool any, hit *out, search_work *work)
{
    const grid *g = &x->g;
    grid_line a;
    real from, end, t;
    if (g->entered == 0 || !ray_is_usable(r)) return false;
    if (!(query_delta(r, g->box) <= g->near))
        return grid_search_far(g, nested_ask, r, any, out, work);
    if (!grid_begin(g, r, &a, &from, &end)) return false;
    query q = query_of(r);
    mailbox seen = mailbox_new();
    grid_walk w = walk_from(&g->cells, &a, from);
    for (;; from = t) {
        const nested_part *p = &x->part[x->part_of[w.cell]];
        t = walk_next_t(&w);
        if (work) work->nodes++;
        if (p > x->part && nested_pass(x, p, &a, from, real_min(t, end), &q, &seen, any, work)) {
            if (any) return true;
            end = line_end(&a, q.r.tmax, end);
        }
        if (!(t <= end)) return query_answer(&q, out);
        walk_step(&w, t);
    }
}

STRUCTURE_VERBS(nested)

static inline structure_stats nested_stats(const nested *x)
{
    structure_stats s = grid_stats(&x->g);
    s.inner = lattice_cells(&x->g.cells), s.depth = 1;
    s.leaves = x->g.lists.cells, s.empty = s.leaves - x->g.lists.marked_cells;
    s.bytes = nested_bytes(x), s.peak = x->peak;
    return s;
}

#endif
