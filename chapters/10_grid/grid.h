/* grid.h: the uniform grid (均匀网格): a box cut into equal cells, each with a list of its items.
 *
 *   grid_bounds       1. a box around all items        (构造包围盒)
 *   grid_resolution   2. cut into density n cells      (建立网格)
 *   grid_mark         3. enter each item in the cells that it touches (标记格子)
 *   grid_search       4. the ray passes from cell to cell, asks the items of those that are marked,
 *                        and ends when the next cell begins beyond the best hit
 *
 *   grid g;
 *   bool grid_build(&x, grid_defaults, &g, &f)   false: too many cells or references for most_bytes
 *   bool grid_hit(&g, r, &h), ..                 the verbs of structure.h (09)
 *
 *       cells, references          item c is in the lists of two cells:
 *     first  0  0  1  3  3  4      first[i] .. first[i + 1] - 1 are the references of cell i;
 *     item   c  a  c  b            bit i of `marked` says whether there are any: the walk through
 *                                  empty cells reads one bit each, and these bits stay in the cache
 *
 * Cells: n_k = s_k (density n / (sx sy sz))^(1/3), so that they are cubes; an axis on which the box
 * is thinner than a cell is not cut, and the others share the cells.                     (10.3)
 *
 * A hit may lie beyond the cell that is asked: the item reaches into several. It is kept, but the
 * walk ends only when the next cell begins beyond it (grid_hit_early of naive.h does not wait).
 *
 * Rounding is paid for while building: items are entered in all cells within `margin` of them, so
 * rays of which query_delta (10.1) is not more than `near` need no further care. That is so for
 * rays from within 1023 sizes of the scene (float: 3). Rays from farther off ask all the cells
 * within delta of them, or all the items if that is less: see far.h.
 *
 * Cost: building O(cells + references), both O(n) for small items; a ray through n^(1/3) cells.
 *
 * Sources: A. Fujimoto, T. Tanaka, K. Iwata, "ARTS: Accelerated Ray-Tracing System", IEEE CG&A
 * 6(4), 1986; Cleary, Wyvill, 1988 (walk.h); A. Lagae, P. Dutré, "Compact, Fast and Robust Grids
 * for Ray Tracing", EGSR 2008 (the two arrays).
 */
#ifndef GRID_H
#define GRID_H

#include "far.h"

/* ---------------------------------------------------------------------------------------------- */

/* The part of the line within the box, by (9.2); where it is parallel, within the box or not. No
 * care for rounding: the box is wider than what it holds by the margin. */
fast_inline bool grid_span(aabb box, const grid_line *a, real *from, real *to)
{
    vec3 u = vmul(vsub(box.lo, a->o), a->inverse), v = vmul(vsub(box.hi, a->o), a->inverse);
    vec3 lo = vmin(u, v), hi = vmax(u, v);
    if (a->inverse.x != 0) *from = real_max(lo.x, *from), *to = real_min(hi.x, *to);
    else if (!(a->o.x >= box.lo.x && a->o.x <= box.hi.x)) return false;
    if (a->inverse.y != 0) *from = real_max(lo.y, *from), *to = real_min(hi.y, *to);
    else if (!(a->o.y >= box.lo.y && a->o.y <= box.hi.y)) return false;
    if (a->inverse.z != 0) *from = real_max(lo.z, *from), *to = real_min(hi.z, *to);
    else if (!(a->o.z >= box.lo.z && a->o.z <= box.hi.z)) return false;
    return *from <= *to;
}

/* The ray, and from where to where in the t of the walk; false: it passes by the box. */
fast_inline bool grid_begin(const grid *g, ray r, grid_line *a, real *from, real *end)
{
    real to = real_largest;
    *a = line_of(r), *from = line_begin(a, r.tmin, -real_largest);
    if (!grid_span(g->box, a, from, &to)) return false;
    *end = line_end(a, r.tmax, to);
    return !(*from > *end);
}

/* 4. The next cell is entered if it begins at or before `end`, which comes nearer with each hit.
 * True if something was closer than the best so far (any: was hit). */
fast_inline bool grid_pass(const grid *g, grid_walk w, const grid_line *a, real end, query *q,
                           mailbox *seen, bool any, search_work *work)
{
    bool found = false;
    real t;
    do {
        size_t cell = (size_t)w.cell;
        t = walk_next_t(&w);
        walk_step(&w, t);
        if (work) work->nodes++;
        if (!grid_ask(g, cell, q, seen, any, work)) continue;
        if (any) return true;
        found = true, end = line_end(a, q->r.tmax, end);
    } while (t <= end);
    return found;
}

fast_inline bool grid_search(const grid *g, ray r, bool any, hit *out, search_work *work)
{
    grid_line a;
    real from, end;
    if (g->entered == 0 || !ray_is_usable(r)) return false;
    if (!(query_delta(r, g->box) <= g->near))
        return grid_search_far(g, grid_ask, r, any, out, work);
    if (!grid_begin(g, r, &a, &from, &end)) return false;
    query q = query_of(r);
    mailbox seen = mailbox_new();
    grid_walk w = walk_from(&g->cells, &a, from);
    bool found = grid_pass(g, w, &a, end, &q, &seen, any, work);
    return any ? found : query_answer(&q, out);
}

STRUCTURE_VERBS(grid)

static inline structure_stats grid_stats(const grid *g)
{
    structure_stats s = {.leaves = lattice_cells(&g->cells), .items = g->entered};
    s.empty = s.leaves - g->lists.marked_cells;
    s.references = g->lists.references;
    s.bytes = s.peak = lists_bytes(&g->lists);
    return s;
}

#endif
