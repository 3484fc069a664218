/* places.h: which leaf, or cell, has a shape in its list? For explain.h: a search that loses a hit
 * has not asked that leaf, or it is not where the hit is.
 *
 *   shape_place p = place_of(c, s, shape, at)   of all that list the shape, the one nearest to the
 *                                               point; it reads the whole structure
 *   p.what     "node", "block" or "cell"; NULL: not known, it is a structure of a reader's own
 *   p.lists    leaves, or cells, that list the shape
 *   p.number   its number in the structure's array
 *   p.box      its box [scene units]; of a node of bsp, a box around its cell
 *   p.far      how far the point lies outside, along an axis or a plane's normal; 0: it does not
 */
#ifndef COMPARE_LAB_PLACES_H
#define COMPARE_LAB_PLACES_H

#include "../contenders.h"

typedef struct {
    const char *what;
    uint32_t shape;
    vec3 at;
    size_t lists, number;
    aabb box;
    real far;
} shape_place;

/* ---------------------------------------------------------------------------------------------- */

/* How far p lies outside, along the axis on which that is most; 0: within. */
static inline real place_outside(aabb b, vec3 p)
{
    vec3 out = vmax(vmax(vsub(b.lo, p), vsub(p, b.hi)), (vec3){0, 0, 0});
    return vaxis(out, vlongest(out));
}

/* Leaf `number` lists item i. */
static inline void place_note(shape_place *p, uint32_t i, size_t number, aabb box, real far)
{
    if (i != p->shape) return;
    far = real_max(far, place_outside(box, p->at));
    if (p->lists++ && !(far < p->far)) return;
    p->number = number, p->box = box, p->far = far;
}

static inline void place_lattice(shape_place *p, const cell_lists *all, const lattice *l,
                                 size_t base)
{
    size_t row = (size_t)l->n[0], layer = row * (size_t)l->n[1];
    for (size_t c = 0; c < lattice_cells(l); c++) {
        int at[3] = {(int)(c % row), (int)(c % layer / row), (int)(c / layer)};
        for (size_t i = all->first[base + c]; i < all->first[base + c + 1]; i++)
            place_note(p, all->item[i], base + c, lattice_box(l, at, at, 0), 0);
    }
}

static inline void place_nested(shape_place *p, const nested *x)
{
    for (size_t k = 1; k <= x->parts; k++) {
        lattice l = nested_lattice(&x->part[k]);
        place_lattice(p, &x->g.lists, &l, x->part[k].base);
    }
}

static inline void place_octree_node(shape_place *p, const octree *t, uint32_t at, octree_cell c)
{
    octree_node n = t->node[at];
    bool leaf = n.kind & octree_is_leaf;
    for (uint32_t i = 0; leaf && i < (n.kind & ~octree_is_leaf); i++)
        place_note(p, t->reference[n.first + i], at, octree_cell_box(t, c), 0);
    for (unsigned k = 0; !leaf && k < 8; k++)
        if (n.kind >> k & 1) place_octree_node(p, t, n.first + k, octree_child_cell(c, k));
}

static inline void place_kdtree_node(shape_place *p, const kdtree *t, uint32_t at, kd_box b)
{
    kd_node n = t->node[at];
    if (kd_is_leaf(n)) {
        for (uint32_t i = n.first; i < n.first + kd_count(n); i++)
            place_note(p, t->triangle ? t->triangle[i].index : t->index[i], at,
                       kd_in_scene(&t->frame, &b), 0);
        return;
    }
    kd_box below = b, above = b;
    below.hi[kd_axis(n)] = above.lo[kd_axis(n)] = n.plane;
    place_kdtree_node(p, t, kd_lower(n), below), place_kdtree_node(p, t, kd_lower(n) + 1, above);
}

/* b: cut by what planes there are across an axis; far: how far beyond the slanted ones. */
static inline void place_bsp_node(shape_place *p, const bsp *t, uint32_t at, aabb b, real far)
{
    bsp_node n = t->node[at];
    if (n.kind & bsp_leaf_bit) {
        for (uint32_t i = n.first; i < n.first + (n.kind & ~bsp_leaf_bit); i++)
            place_note(p, t->reference[i], at, b, far);
        return;
    }
    aabb back = b, front = b;
    real beyond = 0, wall = n.at;
    if (n.kind < 3) {
        wall += vaxis(t->middle, (int)n.kind);
        back.hi = vwith(b.hi, (int)n.kind, wall), front.lo = vwith(b.lo, (int)n.kind, wall);
    } else beyond = vdot(t->normal[n.kind & ~bsp_slanted_bit], vsub(p->at, t->middle)) - n.at;
    place_bsp_node(p, t, n.first, back, real_max(far, beyond));
    place_bsp_node(p, t, n.first + 1, front, real_max(far, -beyond));
}

static inline void place_bvh(shape_place *p, const bvh *b)
{
    const bvh_tree *t = bvh_tree_of(b);
    for (size_t at = 0; at < t->nodes; at++) {
        bvh_node n = t->node[at];
        if (at == 1) continue;  /* no node */
        const float *x = n.box.side;
        for (uint32_t i = n.first; i < n.first + n.count; i++)
            place_note(p, bvh_item_at(b, i), at, (aabb){vec(x[0], x[1], x[2]),
                                                        vec(x[3], x[4], x[5])}, 0);
    }
}

static inline void place_bvh8(shape_place *p, const bvh8 *w)
{
    for (size_t at = 0; at < bvh8_places * w->nodes; at++) {
        const bvh8_node *n = &w->node[at / bvh8_places];
        size_t k = at % bvh8_places;
        uint32_t leaf = n->child[k], number = leaf & ~bvh8_leaf;
        const float (*x)[bvh8_places] = n->side;
        aabb b = {bvh8_back(w, x[0][k], x[1][k], x[2][k]), bvh8_back(w, x[3][k], x[4][k], x[5][k])};
        if (!(leaf & bvh8_leaf)) continue;
        for (int i = 0; i < 8 && (w->block || i == 0); i++)
            place_note(p, w->block ? w->block[number].index[i] : number, number, b, 0);
    }
}

/* The nodes from the root to the leaf of item `wanted`; how many. 0: it is in none. */
static inline int example_path(const example *e, uint32_t wanted, size_t path[64])
{
    size_t k = 0, first = 0, n = e->n, at = 0;
    int depth = 0;
    while (at < e->n && e->item[at].index != wanted) at++;
    while (at < e->n) {
        path[depth++] = k;
        if (n == 1) break;
        if (at < first + n / 2) k++, n /= 2;
        else k += 2 * (n / 2), first += n / 2, n -= n / 2;
    }
    return depth;
}

static inline void place_example(shape_place *p, const example *e)
{
    size_t path[64];
    int n = example_path(e, p->shape, path);
    if (n > 0) place_note(p, p->shape, path[n - 1], e->box[path[n - 1]], 0);
}

#define PLACE_OF(X, its_leaves, look)                                   \
    if (strcmp(c->type, #X) == 0) {                                     \
        const X *t = s;                                                 \
        p.what = (its_leaves);                                          \
        if (c->stats(s).items > 0) (look);                              \
    }

static inline shape_place place_of(const contender *c, const void *s, uint32_t wanted, vec3 at)
{
    shape_place p = {.shape = wanted, .at = at};
    PLACE_OF(grid, "cell", place_lattice(&p, &t->lists, &t->cells, 0))
    PLACE_OF(nested, "cell", place_nested(&p, t))
    PLACE_OF(octree, "node", place_octree_node(&p, t, 0, (octree_cell){0, 0, 0, 0}))
    PLACE_OF(kdtree, "node", place_kdtree_node(&p, t, 0, t->box))
    PLACE_OF(bsp, "node", place_bsp_node(&p, t, 0, (aabb){vsub(t->middle, t->half),
                                                          vadd(t->middle, t->half)}, 0))
    PLACE_OF(bvh, "node", place_bvh(&p, t))
    PLACE_OF(bvh8, "block", place_bvh8(&p, t))
    PLACE_OF(example, "node", place_example(&p, t))
    return p;
}

#endif
