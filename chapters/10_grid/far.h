/* far.h: rays from so far away that rounding places a hit in a cell beside the right one.
 *
 *        |     |:   /:|     |     delta (10.1) is more than what was paid while building. All the
 *     ---+-----:+--/-:+-----+     cells within delta of the ray are asked, layer by layer along its
 *        |    :| /  :| |    |     longest direction: in each layer a block of cells.       (10.7)
 *     ---+---:-+/--:-+------+
 *        |  :  |  :  |      |     Where those are more cells than there are items, all the items
 *          <-delta->              are asked: an origin of 1e13 sizes away, in double.
 *
 *   bool grid_search_far(&g, ask, r, any, &h, &work)      ask: grid_ask, or nested_ask
 */
#ifndef GRID_FAR_H
#define GRID_FAR_H

#include "build.h"

typedef bool grid_ask_cell(const grid *g, size_t cell, query *q, mailbox *seen, bool any,
                           search_work *work);

/* ---------------------------------------------------------------------------------------------- */

/* Asks all cells from lo to hi, both corners included; true if something was hit. */
fast_inline bool grid_ask_block(const grid *g, grid_ask_cell *ask, vec3 lo, vec3 hi, query *q,
                                mailbox *seen, bool any, search_work *work)
{
    const lattice *l = &g->cells;
    int i[3], j[3];
    bool found = false;
    for (int k = 0; k < 3; k++) {
        i[k] = lattice_index(vaxis(lo, k), vaxis(l->lo, k), vaxis(l->per, k), l->n[k]);
        j[k] = lattice_index(vaxis(hi, k), vaxis(l->lo, k), vaxis(l->per, k), l->n[k]);
    }
    for (int z = i[2]; z <= j[2]; z++)
        for (int y = i[1]; y <= j[1]; y++)
            for (int x = i[0]; x <= j[0]; x++) {
                size_t cell = (size_t)x + (size_t)l->n[0]
                              * ((size_t)y + (size_t)l->n[1] * (size_t)z);
                if (work) work->nodes++;
                found |= ask(g, cell, q, seen, any, work);
                if (found && any) return true;
            }
    return found;
}

/* On axis k the ray moves fastest, so where it passes the sides of a layer is as exact as any of
 * its points: within 16 epsilon D. Layers are delta thicker on either side, and a hit in one
 * has its t between those of its sides: a layer that begins beyond the best hit ends the search. */
__attribute__((noinline, cold))
static bool grid_search_far(const grid *g, grid_ask_cell *ask, ray r, bool any, hit *out,
                            search_work *work)
{
    const lattice *l = &g->cells;
    real delta = 2 * query_delta(r, g->box) + g->margin, cells = 1;
    vec3 reach = {delta, delta, delta};
    grid_line a = line_of(r);
    int k = vlongest(r.d);
    for (int i = 0; i < 3; i++)
        cells *= i == k ? (real)l->n[k] : 2 + 3 * delta * vaxis(l->per, i);
    if (!(cells < (real)g->x.n)) {
        if (work) work->tests += g->x.n, work->leaves++;
        return any ? items_occluded(&g->x, r) : items_hit(&g->x, r, out);
    }
    query q = query_of(r);
    mailbox seen = mailbox_new();
    real o = vaxis(r.o, k), inverse = vaxis(a.inverse, k), size = vaxis(l->size, k);
    for (int step = 0; step < l->n[k]; step++) {
        int i = inverse > 0 ? step : l->n[k] - 1 - step;
        real wall = vaxis(l->lo, k) + (real)i * size;
        real t0 = (wall - delta - o) * inverse, t1 = (wall + size + delta - o) * inverse;
        real near = line_begin(&a, r.tmin, real_min(t0, t1));
        real far = real_max(t0, t1), end = line_end(&a, q.r.tmax, real_largest);
        if (near > end) break;
        if (near > far) continue;
        far = real_min(far, end);
        vec3 p = vmadd(a.o, a.d, near), e = vmadd(a.o, a.d, far);
        vec3 lo = vsub(vmin(p, e), reach), hi = vadd(vmax(p, e), reach);
        if (aabb_is_empty(aabb_overlap(g->box, (aabb){lo, hi}))) continue;
        ((real *)&lo)[k] = ((real *)&hi)[k] = wall + size / 2;
        if (grid_ask_block(g, ask, lo, hi, &q, &seen, any, work) && any) return true;
    }
    return query_answer(&q, out);
}

#endif
