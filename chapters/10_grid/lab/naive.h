/* naive.h: searching a grid the way it is first written, to see what goes wrong.
 *
 *                            loses
 *   grid_hit_early           what is nearer than a hit that lies beyond its cell: an item is in
 *                            several cells, and is hit in the first of them that the ray passes,
 *                            though the point lies in a later one, behind other items
 *   grid_hit_added           nothing: t += step drifts, but by less than the margin of the lists
 *                            allows for, in as many cells as grid.h makes (drift.h)
 *
 *        +-------+-------+   A ray from the left enters cell 1, which lists a (its end reaches into
 *    o---|-------|-b---a-|   it, above) and finds it hit: in cell 2. It stops: b, in front of a,
 *        | a- - -|- - /  |   but listed in cell 2 alone, is lost.
 *        +-------+-------+
 *
 *   bool items_overlap_bounds(&x, i, cell)    the cheap answer of overlap.h
 *   int i = walk_index(&l, &w, k)             which cell on axis k
 */
#ifndef GRID_NAIVE_H
#define GRID_NAIVE_H

#include "../grid.h"

typedef void grid_step(grid_walk *w, real t);

/* ---------------------------------------------------------------------------------------------- */

/* As published: t += step. */
fast_inline void walk_step_naive(grid_walk *w, real t)
{
    if (w->t.x == t)
        walk_step_axis(w, w->stride[0], &w->t.x, &w->j.x, w->last.x, t + w->step.x, 0);
    else if (w->t.y == t)
        walk_step_axis(w, w->stride[1], &w->t.y, &w->j.y, w->last.y, t + w->step.y, 0);
    else walk_step_axis(w, w->stride[2], &w->t.z, &w->j.z, w->last.z, t + w->step.z, 0);
}

/* grid_search for rays that begin near. early: the first cell with a hit ends the search. */
fast_inline bool grid_search_plain(const grid *g, ray r, grid_step *step, bool early, hit *out)
{
    if (g->entered == 0 || !ray_is_usable(r)) return false;
    grid_line a;
    real from, end, t;
    if (!grid_begin(g, r, &a, &from, &end)) return false;
    query q = query_of(r);
    mailbox seen = mailbox_new();
    grid_walk w = walk_from(&g->cells, &a, from);
    do {
        size_t cell = (size_t)w.cell;
        t = walk_next_t(&w);
        step(&w, t);
        if (!grid_ask(g, cell, &q, &seen, false, NULL)) continue;
        if (early) break;
        end = line_end(&a, q.r.tmax, end);
    } while (t <= end);
    return query_answer(&q, out);
}

static inline bool grid_hit_early(const grid *g, ray r, hit *out)
{
    return grid_search_plain(g, r, walk_step, true, out);
}

static inline bool grid_hit_added(const grid *g, ray r, hit *out)
{
    return grid_search_plain(g, r, walk_step_naive, false, out);
}

static inline bool items_overlap_bounds(const items *x, size_t i, aabb cell)
{
    aabb b;
    return items_bounds(x, i, &b) && !aabb_is_empty(aabb_overlap(b, cell));
}

static inline int walk_index(const lattice *l, const grid_walk *w, int k)
{
    ptrdiff_t row = l->n[0], layer = row * l->n[1];
    return (int)(k == 0 ? w->cell % row : k == 1 ? w->cell % layer / row : w->cell / layer);
}

#endif
