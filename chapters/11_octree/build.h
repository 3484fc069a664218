/* build.h: cutting space into eight, and which items are in which part.
 *
 * The root is a cube, from the low corner of the bounds, as large as their longest side. Not the
 * box of the bounds: cells of a flat scene would be flat. Not centred: models are symmetric, and
 * what lies across the first wall is in both halves.
 *
 * An item is in every cell that it touches: an item may be in many. Walls stand at
 *
 *   lo + i size / 2^depth                   i = 0 .. 2^depth, along each axis                (11.1)
 *
 * which the computer rounds by less than 2 eps M, M the largest |coordinate| of the cube: so cells
 * are taken larger by that on each side when they are asked for their items.
 *
 * When to stop. n items are to be cut into cells that hold n_0 .. n_7. Each of them has a quarter
 * of the surface of their parent, so a line that meets the parent meets it with chance 1/4: of
 * convex bodies, one in the other, by areas (9.6). It tests
 *
 *   uncut: n items       cut: (n_0 + ... + n_7) / 4, and the cut itself, as 4 tests       (11.2)
 *
 * A cut that does not help is made, but a second one below it is not. (The first is: around a
 * corner where many triangles meet, all eight hold all, and yet their parts do not.) Without this,
 * n triangles on one place would be in 4^depth n leaves; and the six that meet at a corner of a
 * mesh would be cut, with leaves of 4, until the depth ends it. What this lets
 * pass ends with structure_room.
 */
#ifndef OCTREE_BUILD_H
#define OCTREE_BUILD_H

#include "../09_aabb/items.h"
#include "../09_aabb/overlap.h"
#include "../10_grid/mailbox.h"

enum { octree_most_depth = 20, octree_cut_cost = 4 };

typedef struct {
    int leaf;           /* items that need no further cut [1 ..] */
    int depth;          /* most cuts from the root to a leaf [0 .. octree_most_depth] */
    bool mailbox;       /* do not test an item twice for one ray */
    bool exact;         /* triangles themselves against cells; false: their boxes */
    size_t most_bytes;  /* allowed while building */
} octree_options;

#define octree_defaults ((octree_options){16, 16, true, true, (size_t)1 << 30})

/* A leaf: `kind` is octree_is_leaf + how many references, `first` the first of them. An inner node:
 * `kind` has bit c set if child c is not empty, `first` is the number of child 0. */
typedef struct { uint32_t first, kind; } octree_node;
#define octree_is_leaf 0x80000000u

typedef struct {
    items x;
    octree_options how;
    octree_node *node;     /* node 0 is the root; then blocks of eight, from number 8 on */
    uint32_t *reference;   /* numbers of items, leaf by leaf */
    size_t nodes;
    structure_stats stats;
    aabb bounds;           /* of what can be hit */
    vec3 lo;               /* the cube */
    real size;
    memory held;
} octree;

/* ---------------------------------------------------------------------------------------------- */

/* Corner of a cell in units of its own side: (11.1). */
typedef struct { uint32_t x, y, z; int depth; } octree_cell;

static inline octree_cell octree_child_cell(octree_cell c, unsigned k)
{
    return (octree_cell){2 * c.x + (k & 1), 2 * c.y + (k >> 1 & 1), 2 * c.z + (k >> 2),
                         c.depth + 1};
}

/* (11.1); depth <= 20, so the numbers i are exact in float, too. */
static inline aabb octree_cell_box(const octree *t, octree_cell c)
{
    real side = ldexp(t->size, -c.depth);
    vec3 low = {(real)c.x * side, (real)c.y * side, (real)c.z * side};
    vec3 high = {(real)(c.x + 1) * side, (real)(c.y + 1) * side, (real)(c.z + 1) * side};
    return (aabb){vadd(t->lo, low), vadd(t->lo, high)};
}

/* What is being cut: lists of items, one above the other, from the root's to the present cell's. */
typedef struct {
    octree *t;
    uint32_t *list;   /* items */
    uint8_t *within;  /* of the same places: the children that the item is in */
    size_t room, node_room, reference_room;
    real margin;
} octree_builder;

static inline bool octree_list_room(octree_builder *b, size_t n)
{
    size_t room = b->room, used = room;
    return memory_room(&b->t->held, &b->within, used, n, &room, 1)
           && memory_room(&b->t->held, &b->list, used, n, &b->room, sizeof *b->list);
}

/* The children that item i, which is in their parent, is in: bit c for child c. By its box, and, if
 * that is in several, by itself. */
static inline unsigned octree_children_of(const octree_builder *b, uint32_t i, const aabb child[8])
{
    aabb box;
    vec3 low = child[0].hi, high = child[7].lo;  /* the walls between, a little beyond and before */
    if (!items_bounds(&b->t->x, i, &box)) return 0;
    unsigned in = (box.lo.x <= low.x ? 0x55u : 0) | (box.hi.x >= high.x ? 0xaau : 0);
    in &= (box.lo.y <= low.y ? 0x33u : 0) | (box.hi.y >= high.y ? 0xccu : 0);
    in &= (box.lo.z <= low.z ? 0x0fu : 0) | (box.hi.z >= high.z ? 0xf0u : 0);
    if (!b->t->how.exact || (in & (in - 1)) == 0) return in;
    overlap_plan p;
    overlap_plan_of(&b->t->x, i, &p);
    for (unsigned c = 0; c < 8; c++)
        if (in >> c & 1 && !overlap_box(&p, child[c])) in &= ~(1u << c);
    return in;
}

static inline bool octree_make_leaf(octree_builder *b, size_t node, size_t begin, size_t n,
                                    int depth)
{
    octree *t = b->t;
    size_t first = t->stats.references, end = first + n;
    if (end >= octree_is_leaf || !memory_room(&t->held, &t->reference, first, end,
                                              &b->reference_room, sizeof *t->reference))
        return false;
    if (n) memcpy(t->reference + first, b->list + begin, n * sizeof *t->reference);
    t->node[node] = (octree_node){(uint32_t)first, octree_is_leaf | (uint32_t)n};
    t->stats.references = end, t->stats.leaves++, t->stats.empty += n == 0;
    if (depth > t->stats.depth) t->stats.depth = depth;
    return true;
}

/* Cuts the cell of `node`; its n items begin at list[begin]. `vain`: the cut above did not help.
 * room: how often leaves below may name them. */
static inline bool octree_cut(octree_builder *b, size_t node, octree_cell cell, size_t begin,
                              size_t n, bool vain, double room)
{
    octree *t = b->t;
    aabb child[8];
    size_t count[8] = {0}, sum = 0, first = t->nodes, end = begin + n;
    unsigned filled = 0;
    if (n <= (size_t)t->how.leaf || cell.depth == t->how.depth)
        return octree_make_leaf(b, node, begin, n, cell.depth);

    /* Which child holds which items */
    for (unsigned c = 0; c < 8; c++)
        child[c] = first_aabb_pad(octree_cell_box(t, octree_child_cell(cell, c)), b->margin);
    for (size_t i = begin; i < end; i++) {
        unsigned in = octree_children_of(b, b->list[i], child);
        b->within[i] = (uint8_t)in;
        for (unsigned c = 0; c < 8; c++) count[c] += in >> c & 1;
    }
    for (unsigned c = 0; c < 8; c++) sum += count[c], filled |= (unsigned)(count[c] > 0) << c;
    bool helps = sum + 4 * octree_cut_cost < 4 * n;  /* (11.2) */
    if ((!helps && vain) || structure_is_full(&t->stats, (double)sum, room))
        return octree_make_leaf(b, node, begin, n, cell.depth);

    /* A block of eight nodes, and each child in turn */
    if (first + 8 >= octree_is_leaf
        || !memory_room(&t->held, &t->node, first, first + 8, &b->node_room, sizeof *t->node))
        return false;
    memset(t->node + first, 0, 8 * sizeof *t->node);
    t->nodes = first + 8, t->stats.inner++;
    t->node[node] = (octree_node){(uint32_t)first, filled};
    for (unsigned c = 0; c < 8; c++) {
        size_t at = end;
        if (count[c] == 0) {
            t->stats.leaves++, t->stats.empty++;
            continue;
        }
        if (!octree_list_room(b, end + count[c] + 1)) return false;
        for (size_t i = begin; i < end; i++) {  /* without a branch: one place more is written to */
            b->list[at] = b->list[i];
            at += b->within[i] >> c & 1;
        }
        double part = room * (double)count[c] / (double)sum;
        if (!octree_cut(b, first + c, octree_child_cell(cell, c), end, count[c], !helps, part))
            return false;
    }
    return true;
}

static inline void octree_free(octree *t)
{
    free(t->node), free(t->reference);
    *t = (octree){0};
}

static inline bool octree_build(const items *x, octree_options how, octree *out, failure *f)
{
    octree t = {.x = *x, .how = how, .held = {.most = how.most_bytes}};
    octree_builder b = {.t = &t};
    t.how.depth = how.depth < 0 ? 0 : how.depth > octree_most_depth ? octree_most_depth : how.depth;
    *out = (octree){0};
    if (!items_all_bounds(x, &t.bounds, f)) return false;
    vec3 size = vsub(t.bounds.hi, t.bounds.lo);
    bool any = !aabb_is_empty(t.bounds);
    t.lo = any ? t.bounds.lo : (vec3){0, 0, 0};
    t.size = any ? vaxis(size, vlongest(size)) + real_smallest : 1;
    vec3 high = vadd(t.lo, (vec3){t.size, t.size, t.size});
    b.margin = 2 * real_epsilon * aabb_reach((aabb){t.lo, high}) + real_smallest;
    bool ok = octree_list_room(&b, x->n + 1)
              && memory_room(&t.held, &t.node, 0, 8, &b.node_room, sizeof *t.node);
    if (ok) {
        memset(t.node, 0, 8 * sizeof *t.node);  /* 1 to 7 are not used: blocks begin at lines */
        t.nodes = 8;
        for (size_t i = 0; i < x->n; i++) {
            aabb box;
            b.list[t.stats.items] = (uint32_t)i;
            t.stats.items += items_bounds(x, i, &box);
        }
        ok = octree_cut(&b, 0, (octree_cell){0, 0, 0, 0}, 0, t.stats.items, false,
                        structure_room(t.stats.items));
    }
    memory_drop(&t.held, b.list, b.room, sizeof *b.list), memory_drop(&t.held, b.within, b.room, 1);
    ok = ok && memory_fit(&t.held, &t.node, t.nodes, t.nodes, &b.node_room, sizeof *t.node)
         && memory_fit(&t.held, &t.reference, t.stats.references, t.stats.references,
                       &b.reference_room, sizeof *t.reference);
    if (!ok) {
        octree_free(&t);
        return memory_failed(f, "octree", x->n, how.most_bytes);
    }
    t.stats.bytes = t.held.bytes, t.stats.peak = t.held.peak;
    *out = t;
    return true;
}

static inline structure_stats octree_stats(const octree *t) { return t->stats; }

#endif
