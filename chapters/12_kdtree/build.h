/* build.h: building the tree.
 *
 *   bool kdtree_build(&x, how, &t, &f)    false: f says why, and t is empty; how: split.h
 *   kdtree                                nodes, and the records of the leaves one after another;
 *                                         every byte counts: t.held.peak (09: memory)
 *
 *            cell                  Items wait in one array. The items of the cell at hand are its
 *    +---------+--------+          last n. Those of the lower child stay where they are, those of
 *    |   L     |   R    |          the upper child are put behind, and done first:
 *    |         |        |               [ .... | L L L L (gap) | R R R ]
 *    +---------+--------+          An item that the plane cuts is in both, each time with the box
 *                                  of its part.
 *
 * When to stop. By number: at how.leaf items, or after kd_most_doubled cuts of one path that left
 * more than half of the items on both sides. By cost (KD_SAH, how.leaf = 0): when the best cut
 * costs more than the leaf. Either way: at depth 8 + 1.3 log2 n (12.2), and where there is
 * no room (structure_room) to name the items once more.
 *
 * Sources: V. Havran, J. Bittner, "On Improving KD-Trees for Ray Shooting", WSCG 2002 (cuts that
 * fail, depth); M. Pharr, W. Jakob, G. Humphreys, "Physically Based Rendering", 3rd ed., 2016, 4.4.
 */
#ifndef KDTREE_BUILD_H
#define KDTREE_BUILD_H

#include "../09_aabb/overlap.h"
#include "split.h"

enum { kd_most_doubled = 3 };

/* 16 bytes for a triangle in a leaf: its corners and its number. */
typedef struct { uint32_t corner[3], index; } kd_triangle;

typedef struct {
    kd_node *node;            /* [nodes] 0 is the root, 1 not used: pairs begin at even numbers */
    kd_triangle *triangle;    /* [references] of a mesh, else NULL */
    uint32_t *index;          /* [references] of a scene, else NULL */
    size_t nodes;
    structure_stats stats;
    items x;
    const vec3 *v;            /* corners of the mesh */
    aabb_frame frame;
    kd_box box;               /* in the frame; lo > hi if there is nothing */
    memory held;
} kdtree;

typedef struct {
    kdtree *t;
    kd_splitter split;
    kd_item *item;            /* see above */
    uint32_t *index;          /* of the leaves, one after another */
    size_t item_room, node_room, index_room;
    bool large;               /* more references or nodes than can be numbered */
} kd_builder;

/* ---------------------------------------------------------------------------------------------- */

static inline void kdtree_free(kdtree *t)
{
    free(t->node), free(t->triangle), free(t->index);
    *t = (kdtree){0};
}

static inline void kd_corner(const kd_builder *b, vec3 p, double out[3])
{
    vec3 q = frame_into(&b->t->frame, p);
    out[0] = (double)q.x, out[1] = (double)q.y, out[2] = (double)q.z;
}

/* A box of the tree as one of the scene, a little larger where coordinates were moved. */
static inline aabb kd_in_scene(const aabb_frame *f, const kd_box *b)
{
    vec3 lo = vec(b->lo[0], b->lo[1], b->lo[2]), hi = vec(b->hi[0], b->hi[1], b->hi[2]);
    vec3 c = f->centre;
    real spare = vzero(c) ? 0 : 4 * real_epsilon * vlargest(c);
    return first_aabb_pad((aabb){frame_back(f, lo), frame_back(f, hi)}, spare);
}

/* A round shape keeps of its two half boxes those that it touches (10.2). */
static inline void kd_cut_round(const kd_builder *b, uint32_t i, kd_box *below, kd_box *above)
{
    overlap_plan p;
    if (!overlap_plan_of(&b->t->x, i, &p)) return;
    if (!overlap_box(&p, kd_in_scene(&b->t->frame, below))) *below = kd_nothing;
    if (!overlap_box(&p, kd_in_scene(&b->t->frame, above))) *above = kd_nothing;
}

/* The boxes of an item's two parts (12.3). A polygon is cut by the plane alone; a triangle that is
 * thinner in its box than its own rounding keeps the cut boxes. */
static inline void kd_cut_item(const kd_builder *b, const kd_item *i, int axis, float at,
                               kd_box *below, kd_box *above)
{
    const items *x = &b->t->x;
    kd_cut c = kd_cut_begin(axis, at);
    double p[3][3];
    triangle t;
    *below = *above = i->box;
    below->hi[axis] = above->lo[axis] = at;
    if (!b->split.how.clip) return;
    if (items_triangle(x, i->index, &t)) {
        kd_corner(b, t.a, p[0]), kd_corner(b, t.b, p[1]), kd_corner(b, t.c, p[2]);
        kd_polygon g = kd_polygon_in(p, &i->box);
        if (g.n == 0) return;
        for (int k = 0; k < g.n; k++) kd_cut_edge(&c, g.p[k], g.p[k + 1 < g.n ? k + 1 : 0]);
    } else if (x->s->shapes[i->index].kind == SHAPE_POLYGON) {
        const polygon *g = &x->s->shapes[i->index].polygon;
        for (uint32_t k = 0; k < g->n; k++) {
            kd_corner(b, g->v[k], p[0]), kd_corner(b, g->v[k + 1 < g->n ? k + 1 : 0], p[1]);
            kd_cut_edge(&c, p[0], p[1]);
        }
    } else {
        kd_cut_round(b, i->index, below, above);
        return;
    }
    kd_cut_end(&c, b->split.how.planar == KD_THICK, below, above);
}

static inline bool kd_is_empty(const kd_box *b)
{
    return !(b->lo[0] <= b->hi[0] && b->lo[1] <= b->hi[1] && b->lo[2] <= b->hi[2]);
}

/* The n items from `begin` on to their sides of the plane: the first *below of them stay, *above
 * follow behind all n. */
static inline bool kd_partition(kd_builder *b, size_t begin, size_t n, kd_choice c, size_t *below,
                                size_t *above)
{
    kdtree_planar planar = b->split.how.planar;
    size_t l = begin, r = begin + n;
    if (!memory_room(&b->t->held, &b->item, r, r + n, &b->item_room, sizeof *b->item)) return false;
    for (size_t i = begin; i < begin + n; i++) {
        kd_item it = b->item[i], up = it;
        float lo = it.box.lo[c.axis], hi = it.box.hi[c.axis];
        bool flat = lo == c.plane && hi == c.plane;
        bool left = lo < c.plane || flat, right = hi > c.plane || (flat && planar != KD_ONE);
        if (left && right && !flat) {
            kd_cut_item(b, &b->item[i], c.axis, c.plane, &it.box, &up.box);
            left = !kd_is_empty(&it.box), right = !kd_is_empty(&up.box);
        }
        if (left) b->item[l++] = it;
        if (right) b->item[r++] = up;
    }
    *below = l - begin, *above = r - begin - n;
    return true;
}

static inline bool kd_leaf(kd_builder *b, size_t at, size_t begin, size_t n)
{
    kdtree *t = b->t;
    size_t first = t->stats.references;
    b->large |= first + n > UINT32_MAX || n >= (size_t)1 << 30;
    if (b->large || !memory_room(&t->held, &b->index, first, first + n, &b->index_room,
                                 sizeof *b->index)) return false;
    for (size_t i = 0; i < n; i++) b->index[first + i] = b->item[begin + i].index;
    t->node[at] = kd_leaf_node(first, n);
    t->stats.references += n, t->stats.leaves++, t->stats.empty += n == 0;
    return true;
}

/* The cut of this cell; false: it becomes a leaf. */
static inline bool kd_wants(kd_builder *b, size_t begin, size_t n, const kd_box *cell, int depth,
                            int doubled, double room, kd_choice *c)
{
    const kdtree_options *how = &b->split.how;
    bool by_cost = how->leaf == 0;
    if (depth >= how->depth || n == 0) return false;
    if (structure_is_full(&b->t->stats, 2 * (double)n, room)) return false;
    if (!by_cost && (n <= (size_t)how->leaf || doubled > kd_most_doubled)) return false;
    *c = kd_choose(&b->split, b->item + begin, n, cell);
    return c->cost < (by_cost ? how->item_cost * (double)n : HUGE_VAL);
}

static inline bool kd_cell(kd_builder *b, size_t at, size_t begin, size_t n, const kd_box *cell,
                           int depth, int doubled, double room)
{
    kdtree *t = b->t;
    kd_choice c;
    size_t below, above, first = t->nodes;
    if (depth > t->stats.depth) t->stats.depth = depth;
    if (!kd_wants(b, begin, n, cell, depth, doubled, room, &c)) return kd_leaf(b, at, begin, n);
    if (!kd_partition(b, begin, n, c, &below, &above)) return false;
    if (below + above > n + n / 2) doubled++;
    b->large |= first + 2 > (size_t)1 << 29;
    if (b->large || !memory_room(&t->held, &t->node, first, first + 2, &b->node_room,
                                 sizeof *t->node)) return false;
    t->nodes += 2, t->stats.inner++;
    t->node[at] = kd_inner(c.plane, c.axis, first, below > 0, above > 0);
    kd_box lower = *cell, upper = *cell;
    lower.hi[c.axis] = upper.lo[c.axis] = c.plane;
    double share = below + above ? room / (double)(below + above) : 0;
    return kd_cell(b, first + 1, begin + n, above, &upper, depth + 1, doubled,
                   share * (double)above)
           && kd_cell(b, first, begin, below, &lower, depth + 1, doubled, share * (double)below);
}

/* ---------------------------------------------------------------------------------------------- */

/* Items in the frame of the tree, and its box. A shape's box has been rounded outwards already. */
static inline bool kd_gather(kd_builder *b, const aabb *all)
{
    kdtree *t = b->t;
    bool thick = b->split.how.planar == KD_THICK;
    size_t n = 0;
    if (all->lo.x <= all->hi.x) t->frame = frame_of(*all, 2, 40);
    if (!memory_room(&t->held, &b->item, 0, t->x.n, &b->item_room, sizeof *b->item)) return false;
    t->box = kd_nothing;
    for (size_t i = 0; i < t->x.n; i++) {
        aabb box;
        double lo[3], hi[3];
        if (!items_bounds(&t->x, i, &box)) continue;
        kd_corner(b, box.lo, lo), kd_corner(b, box.hi, hi);
        b->item[n] = (kd_item){kd_bounds(lo, hi, thick), (uint32_t)i};
        for (int k = 0; k < 3; k++) {
            t->box.lo[k] = float_min(b->item[n].box.lo[k], t->box.lo[k]);
            t->box.hi[k] = float_max(b->item[n].box.hi[k], t->box.hi[k]);
        }
        n++;
    }
    t->stats.items = n;
    return true;
}

/* The records of the leaves, and no room to spare. */
static inline bool kd_finish(kd_builder *b)
{
    kdtree *t = b->t;
    size_t room = 0, n = t->stats.references;
    if (!memory_fit(&t->held, &t->node, t->nodes, t->nodes, &b->node_room, sizeof *t->node))
        return false;
    if (t->x.s) {
        if (!memory_fit(&t->held, &t->index, 0, n + 1, &room, sizeof *t->index)) return false;
        if (n) memcpy(t->index, b->index, n * sizeof *t->index);
        return true;
    }
    if (!memory_fit(&t->held, &t->triangle, 0, n + 1, &room, sizeof *t->triangle)) return false;
    for (size_t i = 0; i < n; i++) {
        const uint32_t *c = t->x.m->index + 3 * (size_t)b->index[i];
        t->triangle[i] = (kd_triangle){{c[0], c[1], c[2]}, b->index[i]};
    }
    return true;
}

static inline int kd_default_depth(size_t n)
{
    int d = (int)(8 + 1.3 * log2((double)n + 1));
    return d < kdtree_most_depth ? d : kdtree_most_depth;
}

static inline bool kd_grow(kd_builder *b, const aabb *all)
{
    kdtree *t = b->t;
    memory *m = &t->held;
    kdtree_options *how = &b->split.how;
    size_t room = 0;
    if (!kd_gather(b, all)) return false;
    size_t n = t->stats.items;
    if (how->strategy != KD_SAH && how->leaf == 0) how->leaf = 4;
    if (how->depth <= 0 || how->depth > kdtree_most_depth) how->depth = kd_default_depth(n);
    bool done = memory_fit(m, &b->split.begin, 0, 3 * n + 3, &room, sizeof(uint32_t))
                && memory_fit(m, &t->node, 0, 2, &b->node_room, sizeof *t->node);
    if (done) {
        b->split.end = b->split.begin + n + 1, b->split.spare = b->split.end + n + 1;
        t->nodes = 2;
        t->node[0] = t->node[1] = kd_leaf_node(0, 0);
        done = kd_cell(b, 0, 0, n, &t->box, 0, 0, structure_room(n));
    }
    memory_drop(m, b->item, b->item_room, sizeof *b->item);
    memory_drop(m, b->split.begin, room, 4);
    done = done && kd_finish(b);
    memory_drop(m, b->index, b->index_room, 4);
    t->stats.bytes = m->bytes, t->stats.peak = m->peak;
    return done;
}

/* False: f says why, and *out is empty. */
static inline bool kdtree_build(const items *x, kdtree_options how, kdtree *out, failure *f)
{
    aabb all;
    *out = (kdtree){.x = *x, .v = x->m ? x->m->v : NULL, .frame = {{0, 0, 0}, 1}};
    if (!items_all_bounds(x, &all, f)) return false;
    kd_builder b = {.t = out, .split = {.how = how}};
    out->held.most = how.most_bytes;
    if (kd_grow(&b, &all)) return true;
    kdtree_free(out);
    return b.large ? failed(f, 2, "k-d tree: more than 2^29 nodes or 2^32 references")
                   : memory_failed(f, "k-d tree", x->n, how.most_bytes);
}

#endif
