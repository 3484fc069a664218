/* tree.h: building a BSP tree: a plane for the cell, its items to both sides, and so on.
 *
 *             slanted plane              node[0] is the root; its children, back and front of the
 *             /           \              plane, are node[first] and node[first + 1]
 *          x = 3        leaf [4, 7]
 *         /     \                        a leaf names its items; one that is in several cells is
 *     leaf []   leaf [4, 2, 9]           named by several leaves
 *
 *   bool bsp_build(&x, how, &b, &f)    false: it does not fit, or `how` is out of its ranges.
 *                                      O(k n log n) for k candidates, if few are cut
 *   structure_stats bsp_stats(&b);  bsp_free(&b)
 *
 *   how.rule         which plane cuts a cell: choose.h
 *   how.candidates   planes of triangles and edges that are tried for each cell [1..10000]
 *   how.leaf         RANDOM, FEWEST: so many items make a leaf [>= 1]; by cost: where no cut pays
 *   how.depth        of the deepest leaf at most [0..64]
 *   how.axis_cost, how.slanted_cost     of a step, where testing an item costs 1 [>= 0]
 *   how.most_bytes   more, while it is built or after, and bsp_build fails (exit code 2). Arrays
 *                    grow by doubling, and it is asked after that: for a moment it may be twice
 *   how.sides        SAFE; or naive, to see what gets lost: fragment.h
 *   how.seed         the same tree again
 *
 * Items are not cut: fragments are, and they only tell which leaves name an item. What the halves
 * of a cell are made of lies on stacks, the back below the front, so the front is built first and
 * given up; the most that is held is what one path of the tree holds.
 *
 * A node takes 16 bytes (12 in float), as in a k-d tree; slanted normals have a list of their own.
 */
#ifndef BSP_TREE_H
#define BSP_TREE_H

#include "choose.h"

enum { bsp_most_depth = 64 };
#define bsp_leaf_bit 0x80000000u
#define bsp_slanted_bit 0x40000000u

typedef struct {
    real at;         /* n . q = at, q relative to the middle; in scene units */
    uint32_t first;  /* children; of a leaf: references */
    uint32_t kind;   /* 0, 1, 2: across this axis; slanted_bit + number of its normal; leaf_bit +
                        number of references */
} bsp_node;

typedef struct {
    items x;
    aabb all;
    vec3 middle, half;
    bsp_node *node;
    vec3 *normal;
    uint32_t *reference;
    size_t nodes, normals;
    size_t cuts;           /* fragments that planes cut in two while it was built */
    structure_stats stats;
} bsp;

/* By measurement: see the table of the README. */
#define bsp_defaults ((bsp_options){.rule = BSP_COST, .candidates = 16, .leaf = 4, \
    .depth = bsp_most_depth, .axis_cost = 4, .slanted_cost = 4.5, .seed = 1, \
    .most_bytes = (size_t)1 << 31})

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    bsp *tree;
    chooser c;
    size_t node_room, normal_room, reference_room;
    bool full;
} bsp_builder;

static inline void bsp_free(bsp *b)
{
    free(b->node), free(b->normal), free(b->reference);
    *b = (bsp){0};
}

/* False, from then on, when more is held than is allowed. */
static inline bool bsp_fits(bsp_builder *b)
{
    const workshop *w = &b->c.w;
    const cell_store *c = &b->c.cells;
    size_t now = b->node_room * sizeof(bsp_node) + b->reference_room * sizeof(uint32_t)
                 + (b->normal_room + w->corner_room + c->corner_room) * sizeof(vec3)
                 + w->fragment_room * sizeof(fragment) + c->face_room * sizeof(cell_face);
    if (now > b->tree->stats.peak) b->tree->stats.peak = now;
    b->full |= now > b->c.how.most_bytes || b->tree->nodes >= bsp_slanted_bit
               || b->tree->stats.references >= bsp_leaf_bit || w->corners >= bsp_leaf_bit;
    return !b->full;
}

static inline void bsp_make_leaf(bsp_builder *b, size_t at, fragment_range_of all, int depth)
{
    bsp *t = b->tree;
    uint32_t n = (uint32_t)(all.end - all.begin);
    t->node[at] = (bsp_node){0, (uint32_t)t->stats.references, bsp_leaf_bit | n};
    for (size_t i = all.begin; i < all.end; i++) {
        size_t k = t->stats.references++;
        t->reference = grown(t->reference, k, &b->reference_room, sizeof(uint32_t));
        t->reference[k] = b->c.w.f[i].item;
    }
    t->stats.leaves++, t->stats.empty += n == 0;
    if (depth > t->stats.depth) t->stats.depth = depth;
}

/* Fragments of one side, on top of the workshop. */
static inline fragment_range_of bsp_collect(bsp_builder *b, fragment_range_of all,
                                            const plane_choice *c, plane_side wanted)
{
    workshop *w = &b->c.w;
    fragment_range_of out = {w->fragments, 0};
    for (size_t i = all.begin; i < all.end && !b->full; i++) {
        if (i % 1024 == 0) bsp_fits(b);
        fragment f = w->f[i];
        plane_side s = fragment_side(w, &c->p, &f);
        f.used |= s == SIDE_ON || i == c->chosen;
        if (s == SIDE_ON && w->sides != BSP_SIDES_STRICT)
            s = c->on_front ? SIDE_FRONT : SIDE_BACK;
        if (!(s & wanted)) continue;
        if (s != SIDE_BOTH) workshop_push(w, f);
        else fragment_half(w, &c->p, wanted == SIDE_FRONT ? -1 : 1, f);
    }
    out.end = w->fragments;
    return out;
}

static inline void bsp_set_plane(bsp_builder *b, size_t at, const split_plane *p)
{
    bsp *t = b->tree;
    bsp_node *n = &t->node[at];
    *n = (bsp_node){p->at * b->c.w.scale, (uint32_t)t->nodes - 2, (uint32_t)p->axis};
    if (p->axis < 3) return;
    n->kind = bsp_slanted_bit | (uint32_t)t->normals;
    t->normal = grown(t->normal, t->normals, &b->normal_room, sizeof(vec3));
    t->normal[t->normals++] = p->n;
}

/* room: how often leaves below may name what is here (structure_room). */
static inline void bsp_make_node(bsp_builder *b, size_t at, fragment_range_of all, convex c,
                                 int depth, double room)
{
    workshop *w = &b->c.w;
    double n = (double)(all.end - all.begin);
    plane_choice x;
    if (!bsp_fits(b)) return;
    if (depth >= b->c.how.depth || structure_is_full(&b->tree->stats, 2 * n, room)
        || !choose_plane(&b->c, all, c, &x)) {
        bsp_make_leaf(b, at, all, depth);
        return;
    }
    for (int k = 0; k < 2; k++)
        b->tree->node = grown(b->tree->node, b->tree->nodes++, &b->node_room, sizeof(bsp_node));
    cell_store *cells = &b->c.cells;
    size_t first = b->tree->nodes - 2, corners[2], fragments[2], cell_corners[2], faces[2];
    convex part[2];
    fragment_range_of of[2];
    bool areas = rule_by_cost(b->c.how.rule);
    bsp_set_plane(b, at, &x.p);
    b->tree->cuts += x.cut, b->tree->stats.inner++;
    for (int k = 0; k < 2; k++) {
        corners[k] = w->corners, fragments[k] = w->fragments;
        cell_corners[k] = cells->corners, faces[k] = cells->faces;
        part[k] = areas ? cell_cut(cells, c, &x.p, k ? -1 : 1) : c;
        of[k] = bsp_collect(b, all, &x, k ? SIDE_FRONT : SIDE_BACK);
    }
    double named = (double)(of[0].end - of[0].begin + of[1].end - of[1].begin);
    for (int k = 1; k >= 0; k--) {
        double share = named > 0 ? room / named * (double)(of[k].end - of[k].begin) : 0;
        if (!b->full) bsp_make_node(b, first + (size_t)k, of[k], part[k], depth + 1, share);
        w->corners = corners[k], w->fragments = fragments[k];
        cells->corners = cell_corners[k], cells->faces = faces[k];
    }
}

/* An array of just the size needed. */
static inline void *bsp_trim(void *p, size_t n, size_t size)
{
    void *less = realloc(p, (n ? n : 1) * size);
    return less ? less : p;
}

/* Around the middle; half a little larger than rounding can make it. */
static inline void bsp_frame(bsp *t, workshop *w)
{
    bool none = aabb_is_empty(t->all);
    t->middle = none ? (vec3){0, 0, 0} : aabb_centre(t->all);
    t->half = none ? (vec3){-1, -1, -1}
                   : vmax(vsub(t->all.hi, t->middle), vsub(t->middle, t->all.lo));
    t->half = vscale(t->half, 1 + 2 * real_epsilon);
    real most = vaxis(t->half, vlongest(t->half));
    w->middle = t->middle, w->scale = none ? 1 : power_above(most);
    w->size = none ? 0 : most / w->scale;
    w->e = w->sides == BSP_SIDES_SAFE ? side_width * w->size
         : w->sides == BSP_SIDES_FIXED ? (real)1e-4 / w->scale : 0;
}

static inline bool bsp_options_valid(bsp_options how, failure *f)
{
    if (how.depth >= 0 && how.depth <= bsp_most_depth && how.candidates >= 1
        && how.candidates <= 10000 && how.leaf >= 1 && how.axis_cost >= 0 && how.slanted_cost >= 0)
        return true;
    return failed(f, 2, "BSP tree: depth %d, %d candidates, leaves of %d, costs %g and %g; allowed "
                  "are depth 0 to %d, candidates 1 to 10000, leaves of 1 or more, costs from 0",
                  how.depth, how.candidates, how.leaf, how.axis_cost, how.slanted_cost,
                  (int)bsp_most_depth);
}

static inline bool bsp_build(const items *x, bsp_options how, bsp *out, failure *f)
{
    *out = (bsp){.x = *x};
    bsp_builder b = {.tree = out, .c = {.w = {.x = x, .sides = how.sides}, .how = how}};
    if (!bsp_options_valid(how, f)) return false;
    if (!items_all_bounds(x, &out->all, f)) return false;
    bsp_frame(out, &b.c.w);
    b.c.g = random_start(how.seed, 0, 0);
    fragment g;
    for (size_t i = 0; i < x->n && (i % 1024 || bsp_fits(&b)); i++)
        if (fragment_of(&b.c.w, (uint32_t)i, &g)) workshop_push(&b.c.w, g);
    out->stats.items = b.c.w.fragments;
    out->node = grown(NULL, 0, &b.node_room, sizeof(bsp_node));
    out->nodes = 1;
    convex c = cell_box(&b.c.cells, vscale(out->half, 1 / b.c.w.scale));
    bsp_make_node(&b, 0, (fragment_range_of){0, out->stats.items}, c, 0,
                  structure_room(out->stats.items));
    free(b.c.w.corner), free(b.c.w.f), cells_free(&b.c.cells);
    if (b.full) {
        size_t references = out->stats.references;
        bsp_free(out);
        return failed(f, 2, "%zu items, named %zu times so far: more than %zu bytes", x->n,
                      references, how.most_bytes);
    }
    out->node = bsp_trim(out->node, out->nodes, sizeof(bsp_node));
    out->normal = bsp_trim(out->normal, out->normals, sizeof(vec3));
    out->reference = bsp_trim(out->reference, out->stats.references, sizeof(uint32_t));
    out->stats.bytes = out->nodes * sizeof(bsp_node) + out->normals * sizeof(vec3)
                 + out->stats.references * sizeof(uint32_t);
    return true;
}

static inline structure_stats bsp_stats(const bsp *b) { return b->stats; }

#endif
