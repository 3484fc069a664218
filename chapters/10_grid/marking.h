/* marking.h: which items are in which cell (标记格子), in flat arrays, by a counting sort.
 *
 *       pass 1: first[c] = how many items touch cell c
 *               sum up:    first[c] = where the list of cell c ends
 *       pass 2: item[--first[c]] = i, from the last item to the first: each list is ascending
 *
 *   cell_lists l;
 *   if (!lists_begin(cells, most_bytes, &l, &f)) ..        no memory, no lists
 *   for (i = 0; i < n; i++) lists_enter(&l, &mark, i, 0);  counts; then
 *   if (!lists_fit(&l, &f)) ..                             more than most_bytes
 *   lists_sum(&l);
 *   for (i = n; i-- > 0;) lists_enter(&l, &mark, i, 0);    enters
 *   lists_finish(&l);
 *   bool cell_marked(&l, cell)                             anything in it?
 *   lists_free(&l);
 *
 * An item that spans many cells is not tested against each of them: the block of cells that its
 * bounds overlap is halved until a block is not touched, or is one cell. So the cost is about that
 * of the cells that are touched, not of the block.                                       (10.6)
 */
#ifndef GRID_MARKING_H
#define GRID_MARKING_H

#include "../09_aabb/overlap.h"
#include "walk.h"

typedef struct {
    const items *x;
    lattice cells;
    real margin;        /* items are entered in the cells within it */
    bool exact;         /* false: all cells that the bounds overlap */
} marking;

typedef struct {
    uint32_t *first;    /* [cells + 1] */
    uint32_t *item;     /* [references]; NULL in the first pass */
    uint64_t *marked;   /* one bit a cell */
    size_t cells, references, marked_cells, most_bytes;
    bool counting;      /* references only, into no list */
} cell_lists;

/* ---------------------------------------------------------------------------------------------- */

static inline void lists_free(cell_lists *l)
{
    free(l->first), free(l->item), free(l->marked);
    *l = (cell_lists){.first = NULL};
}

static inline size_t lists_bytes(const cell_lists *l)
{
    return (l->cells + 1) * sizeof *l->first + l->references * sizeof *l->item
           + (l->cells / 64 + 1) * sizeof *l->marked;
}

static inline bool lists_fit(const cell_lists *l, failure *f)
{
    if (l->references < UINT32_MAX && lists_bytes(l) <= l->most_bytes) return true;
    return failed(f, 1, "grid: %zu cells and %zu references or more do not fit into %zu bytes",
                  l->cells, l->references, l->most_bytes);
}

static inline bool lists_begin(size_t cells, size_t most_bytes, cell_lists *l, failure *f)
{
    *l = (cell_lists){.cells = cells, .most_bytes = most_bytes};
    if (!lists_fit(l, f)) return false;
    l->first = allocate(cells + 1, sizeof *l->first);
    l->marked = allocate(cells / 64 + 1, sizeof *l->marked);
    return true;
}

fast_inline void lists_take(cell_lists *l, size_t cell, uint32_t i)
{
    if (l->counting) l->references++;
    else if (l->item) l->item[--l->first[cell]] = i;
    else l->first[cell]++, l->references++;
}

/* Cells i to j on each axis, (10.6). Not called for more cells than there are: depth < 64. */
static inline void lists_take_block(cell_lists *l, const marking *m, const overlap_plan *p,
                                    const int i[3], const int j[3], size_t base, uint32_t item)
{
    int size[3] = {j[0] - i[0], j[1] - i[1], j[2] - i[2]};
    if (m->exact && !overlap_box(p, lattice_box(&m->cells, i, j, m->margin))) return;
    int k = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
    if (size[k] == 0) {
        size_t row = (size_t)m->cells.n[0], layer = row * (size_t)m->cells.n[1];
        lists_take(l, base + (size_t)i[0] + row * (size_t)i[1] + layer * (size_t)i[2], item);
        return;
    }
    int middle[3] = {i[0], i[1], i[2]}, before[3] = {j[0], j[1], j[2]};
    before[k] = i[k] + size[k] / 2, middle[k] = before[k] + 1;
    lists_take_block(l, m, p, i, before, base, item);
    lists_take_block(l, m, p, middle, j, base, item);
}

/* The lattice may be one of many: its cells are those from `base` on. */
static inline void lists_enter(cell_lists *l, const marking *m, size_t item, size_t base)
{
    overlap_plan p;
    int i[3], j[3];
    if (!(m->exact ? overlap_plan_of(m->x, item, &p) : items_bounds(m->x, item, &p.box))) return;
    for (int k = 0; k < 3; k++) {
        real lo = vaxis(m->cells.lo, k), per = vaxis(m->cells.per, k);
        i[k] = lattice_index(vaxis(p.box.lo, k) - m->margin, lo, per, m->cells.n[k]);
        j[k] = lattice_index(vaxis(p.box.hi, k) + m->margin, lo, per, m->cells.n[k]);
    }
    lists_take_block(l, m, &p, i, j, base, (uint32_t)item);
}

static inline void lists_sum(cell_lists *l)
{
    uint32_t sum = 0;
    for (size_t c = 0; c < l->cells; c++) sum += l->first[c], l->first[c] = sum;
    l->first[l->cells] = sum;
    l->item = allocate(l->references, sizeof *l->item);
}

static inline void lists_finish(cell_lists *l)
{
    for (size_t c = 0; c < l->cells; c++)
        if (l->first[c] < l->first[c + 1])
            l->marked[c / 64] |= (uint64_t)1 << c % 64, l->marked_cells++;
}

fast_inline bool cell_marked(const cell_lists *l, size_t cell)
{
    return l->marked[cell / 64] >> cell % 64 & 1;
}

#endif
