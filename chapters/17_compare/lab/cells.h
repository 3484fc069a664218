/* cells.h: where a structure keeps an item: the box of its leaf (叶节点), or its cell (格子). For
 * proof.h, which explains hits that are lost.
 *
 *   item_cell c = bvh_cell_of(&b, item, p)   of all leaves that list the item, the nearest to p;
 *                                            O(references), and a page of code at most
 *   c.outside    [scene units] how far p lies outside of it, along an axis; below 0: how deep
 *                within; infinity: no leaf lists the item
 *   c.box        as it is stored, without what a search adds for rounding (10.1)
 *   item_cell_at(box, p), item_cell_none     what such a function returns
 *
 * A bsp's cell has slanted walls: c.box knows only those across the axes, c.outside knows all.
 * Brute force, which is the oracle, and first versions, whose faults are counted, not explained,
 * have none.
 */
#ifndef COMPARE_LAB_CELLS_H
#define COMPARE_LAB_CELLS_H

#include "../../10_grid/trials/nested.h"
#include "../../11_octree/octree.h"
#include "../../12_kdtree/kdtree.h"
#include "../../13_bsp/bsp.h"
#include "../../14_bvh/bvh.h"
#include "../../15_wide_bvh/bvh8.h"
#include "../example.h"

typedef struct { aabb box; real outside; } item_cell;

#define item_cell_none ((item_cell){aabb_empty(), real_infinity})

/* ---------------------------------------------------------------------------------------------- */

static inline item_cell item_cell_at(aabb box, vec3 p)
{
    vec3 off = vmax(vsub(box.lo, p), vsub(p, box.hi));
    return (item_cell){box, real_max(off.x, real_max(off.y, off.z))};
}

static inline item_cell item_cell_nearer(item_cell a, item_cell b)
{
    return b.outside < a.outside ? b : a;
}

static inline bool list_holds(const uint32_t *list, size_t n, uint32_t item)
{
    for (size_t i = 0; i < n; i++)
        if (list[i] == item) return true;
    return false;
}

/* 10: a lattice whose cells are those from `base` on. */
static inline item_cell lattice_cell_of(const lattice *l, const cell_lists *lists, size_t base,
                                        uint32_t item, vec3 p)
{
    size_t row = (size_t)l->n[0], layer = row * (size_t)l->n[1];
    item_cell best = item_cell_none;
    for (size_t c = 0; c < lattice_cells(l); c++) {
        const uint32_t *first = lists->first + base + c;
        int at[3] = {(int)(c % row), (int)(c % layer / row), (int)(c / layer)};
        if (list_holds(lists->item + first[0], first[1] - first[0], item))
            best = item_cell_nearer(best, item_cell_at(lattice_box(l, at, at, 0), p));
    }
    return best;
}

static inline item_cell grid_cell_of(const grid *g, uint32_t item, vec3 p)
{
    return lattice_cell_of(&g->cells, &g->lists, 0, item, p);
}

static inline item_cell nested_cell_of(const nested *x, uint32_t item, vec3 p)
{
    item_cell best = item_cell_none;
    for (const nested_part *part = x->part + 1; part <= x->part + x->parts; part++) {
        lattice l = nested_lattice(part);
        best = item_cell_nearer(best, lattice_cell_of(&l, &x->g.lists, part->base, item, p));
    }
    return best;
}

/* 11. */
static inline item_cell octree_cell_below(const octree *t, octree_node n, octree_cell c,
                                          uint32_t item, vec3 p)
{
    item_cell best = item_cell_none;
    if (n.kind & octree_is_leaf)
        return list_holds(t->reference + n.first, n.kind & ~octree_is_leaf, item)
               ? item_cell_at(octree_cell_box(t, c), p) : best;
    for (unsigned k = 0; k < 8; k++) {
        if (!(n.kind >> k & 1)) continue;
        octree_cell child = octree_child_cell(c, k);
        best = item_cell_nearer(best, octree_cell_below(t, t->node[n.first + k], child, item, p));
    }
    return best;
}

static inline item_cell octree_cell_of(const octree *t, uint32_t item, vec3 p)
{
    return octree_cell_below(t, t->node[0], (octree_cell){0, 0, 0, 0}, item, p);
}

/* 12. */
static inline item_cell kdtree_cell_below(const kdtree *t, uint32_t at, kd_box box, uint32_t item,
                                          vec3 p)
{
    const kd_node n = t->node[at];
    if (kd_is_leaf(n)) {
        for (size_t i = n.first; i < n.first + kd_count(n); i++)
            if ((t->x.m ? t->triangle[i].index : t->index[i]) == item)
                return item_cell_at(kd_in_scene(&t->frame, &box), p);
        return item_cell_none;
    }
    kd_box lower = box, upper = box;
    lower.hi[kd_axis(n)] = upper.lo[kd_axis(n)] = n.plane;
    return item_cell_nearer(kdtree_cell_below(t, kd_lower(n), lower, item, p),
                            kdtree_cell_below(t, kd_lower(n) + 1, upper, item, p));
}

static inline item_cell kdtree_cell_of(const kdtree *t, uint32_t item, vec3 p)
{
    return kdtree_cell_below(t, 0, t->box, item, p);
}

/* 13. cell: what the planes so far have left of the whole box; s: (13.1). */
static inline item_cell bsp_cell_below(const bsp *b, uint32_t at, item_cell cell, uint32_t item,
                                       vec3 p)
{
    const bsp_node *n = &b->node[at];
    if (n->kind & bsp_leaf_bit)
        return list_holds(b->reference + n->first, n->kind & ~bsp_leaf_bit, item)
               ? cell : item_cell_none;
    item_cell back = cell, front = cell;
    vec3 q = vsub(p, b->middle);
    bool across = n->kind < 3;
    real s = (across ? vaxis(q, (int)n->kind)
                     : vdot(b->normal[n->kind & ~bsp_slanted_bit], q)) - n->at;
    back.outside = real_max(s, cell.outside), front.outside = real_max(-s, cell.outside);
    if (across) {
        real wall = vaxis(b->middle, (int)n->kind) + n->at;
        ((real *)&back.box.hi)[n->kind] = ((real *)&front.box.lo)[n->kind] = wall;
    }
    return item_cell_nearer(bsp_cell_below(b, n->first, back, item, p),
                            bsp_cell_below(b, n->first + 1, front, item, p));
}

static inline item_cell bsp_cell_of(const bsp *b, uint32_t item, vec3 p)
{
    return bsp_cell_below(b, 0, item_cell_at(b->all, p), item, p);
}

/* 14: of inner nodes count is 0. */
static inline item_cell bvh_cell_of(const bvh *b, uint32_t item, vec3 p)
{
    const bvh_tree *t = bvh_tree_of(b);
    item_cell best = item_cell_none;
    for (const bvh_node *n = t->node; n < t->node + t->nodes; n++)
        for (uint32_t k = n->first; k < n->first + n->count; k++) {
            if ((b->x.m ? b->mesh.triangle[k].index : b->index[k]) != item) continue;
            aabb box = {vec(n->low[0], n->low[1], n->low[2]),
                        vec(box_high(n, 0), box_high(n, 1), box_high(n, 2))};
            best = item_cell_nearer(best, item_cell_at(box, p));
        }
    return best;
}

/* 15: a child that is a node lists nothing; places of a block that are not in use hold no_shape. */
static inline bool bvh8_child_holds(const bvh8 *w, uint32_t child, uint32_t item)
{
    uint32_t at = child & ~bvh8_leaf;
    if (at == child) return false;
    if (!w->x.m) return at == item;
    for (int k = 0; k < 8; k++)
        if (w->block[at].index[k] == item) return true;
    return false;
}

static inline item_cell bvh8_cell_of(const bvh8 *w, uint32_t item, vec3 p)
{
    item_cell best = item_cell_none;
    for (const bvh8_node *n = w->node; n < w->node + w->nodes; n++)
        for (int k = 0; k < 8; k++) {
            kd_box b = {{n->side[0][k], n->side[1][k], n->side[2][k]},
                        {n->side[3][k], n->side[4][k], n->side[5][k]}};
            if (bvh8_child_holds(w, n->child[k], item))
                best = item_cell_nearer(best, item_cell_at(kd_in_scene(&w->frame, &b), p));
        }
    return best;
}

/* Down to the leaf of the item, which is in one, as example_walk goes. It is here, and not in
 * example.h, as no ray needs it. */
static inline item_cell example_cell_of(const example *e, uint32_t item, vec3 p)
{
    size_t at = 0, k = 0, n = e->n;
    while (at < n && e->item[at].index != item) at++;
    if (at == n) return item_cell_none;
    while (n > 1) {
        size_t half = n / 2;
        if (at < half) k++, n = half;
        else k += 2 * half, at -= half, n -= half;
    }
    return item_cell_at(e->box[k], p);
}

#endif
