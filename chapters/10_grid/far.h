/* far.h: rays from so far away that rounding places a hit in a cell beside the right one.
 *
 *        |     |:   /:|     |     delta (10.1) is more than what was paid while building. All the
 *     ---+-----:+--/-:+-----+     cells within delta of the ray are asked: the block of all cells is
 *        |    :| /  :| |    |     halved, as in (10.6), until the ray passes by a block, or it is
 *     ---+---:-+/--:-+------+     one cell.                                                (10.7)
 *        |  :  |  :  |      |
 *          <-delta->              Where delta is a quarter of the box or more, all the items are
 *                                 asked: an origin of 1e12 sizes away, in double.
 *
 *   bool grid_search_far(&g, ask, r, any, &h, &work)      ask: grid_ask, or nested_ask
 */
#ifndef FAR_H
#define FAR_H

#include "build.h"

typedef bool grid_ask_cell(const grid *g, size_t cell, query *q, mailbox *seen, bool any,
                           search_work *work);

typedef struct {
    const grid *g;
    grid_ask_cell *ask;
    grid_line a;
    real delta;
    query q;
    mailbox seen;
    bool any;
    search_work *work;
} far_search;

/* ---------------------------------------------------------------------------------------------- */

/* Cells i to j, both included: asked if the ray comes within delta of them; the nearer half first,
 * so that what begins beyond the best hit is left out. True if something was hit. */
static inline bool far_block(far_search *s, const int i[3], const int j[3])
{
    int before[3], middle[3];
    real from = line_begin(&s->a, s->q.r.tmin, -real_largest);
    real to = line_end(&s->a, s->q.r.tmax, real_largest);
    aabb box = lattice_box(&s->g->cells, i, j, s->delta);
    if (!grid_span(box, &s->a, &from, &to)) return false;
    int k = lattice_halve(i, j, before, middle);
    if (k < 0) {
        if (s->work) s->work->nodes++;
        return s->ask(s->g, lattice_cell(&s->g->cells, i), &s->q, &s->seen, s->any, s->work);
    }
    bool down = vaxis(s->a.inverse, k) < 0;
    bool found = down ? far_block(s, middle, j) : far_block(s, i, before);
    if (found && s->any) return true;
    return (down ? far_block(s, i, before) : far_block(s, middle, j)) || found;
}

__attribute__((noinline, cold))
static bool grid_search_far(const grid *g, grid_ask_cell *ask, ray r, bool any, hit *out,
                            search_work *work)
{
    const int *n = g->cells.n, first[3] = {0, 0, 0}, last[3] = {n[0] - 1, n[1] - 1, n[2] - 1};
    vec3 side = vsub(g->box.hi, g->box.lo);
    far_search s = {g, ask, line_of(r), 2 * query_delta(r, g->box) + g->margin, query_of(r),
                    mailbox_new(), any, work};
    if (!(4 * s.delta < vaxis(side, vlongest(side)))) {
        if (work) work->tests += g->x.n, work->leaves++;
        return any ? items_occluded(&g->x, r) : items_hit(&g->x, r, out);
    }
    bool found = far_block(&s, first, last);
    return any ? found : query_answer(&s.q, out);
}

#endif
