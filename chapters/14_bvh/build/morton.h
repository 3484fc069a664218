/* morton.h: the tree in linear time, from numbers: no area is compared, nothing is searched for.
 *
 *   tree_morton(&in, how, &t)         in.item[in.n] is reordered; O(n)
 *   morton_code(x, y, z)              the 63 bits  x20 y20 z20 x19 y19 z19 ... x0 y0 z0      (14.9)
 *
 * A Morton code (莫顿码) interleaves the digits of three coordinates. Read from the front, its bits
 * say: right or left half in x, then in y, in z, in x again ... So the codes, once sorted, run
 * through space along a curve that fills each half before it enters the other, and the tree is
 * there already: the items of a node are those with the same first bits, and it is cut where the
 * next bit changes from 0 to 1.
 *
 *       sorted:  0000 | 0001 | 0110 || 1001 | 1010 | 1011       || the first bit that differs,
 *                                                                | then the next ones
 *
 *   1. codes         of the centres of the boxes, 21 bits an axis, cubes of the longest side / 2^21
 *   2. sorting       by digits (radix.h): O(n); the items follow
 *   3. topology      a range of the sorted codes; the highest bit in which its first and last
 *                    differ says where it is cut, by bisection                              (14.10)
 *   4. boxes         from the leaves up, on the way back
 *
 * On that way back the heuristic has its only word: where a leaf costs no more than what has been
 * built below, that is thrown away. Equal codes are halved by number; so is everything that would
 * become deeper than 64, as in tree.h.
 *
 * Sources: G. M. Morton, "A computer oriented geodetic data base", IBM, 1966; C. Lauterbach,
 * M. Garland, S. Sengupta, D. Luebke, D. Manocha, "Fast BVH Construction on GPUs", Eurographics
 * 2009; T. Karras, "Maximizing Parallelism in the Construction of BVHs, Octrees, and k-d Trees",
 * HPG 2012 (a node as a range of codes).
 */
#ifndef BVH_MORTON_H
#define BVH_MORTON_H

#include "../../../common/numbers/radix.h"
#include "store.h"

enum { morton_bits = 21 };

/* ---------------------------------------------------------------------------------------------- */

/* Two zeros between all bits of x < 2^21: the upper half moves away by twice as far as it is wide,
 * then the halves of the halves ... */
static inline uint64_t morton_spread(uint64_t x)
{
    x = (x | x << 32) & 0x001f00000000ffff;
    x = (x | x << 16) & 0x001f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
}

static inline uint64_t morton_code(uint32_t x, uint32_t y, uint32_t z)
{
    return morton_spread(x) << 2 | morton_spread(y) << 1 | morton_spread(z);
}

/* Codes of n items. All axes have the same scale, so that cells are cubes; a set without extent, or
 * nearly, has the code 0 throughout. */
static inline void morton_codes(const bvh_item *item, size_t n, radix_code *pair)
{
    float lo[3] = {INFINITY, INFINITY, INFINITY}, extent = 0;
    float hi[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (size_t i = 0; i < n; i++)
        for (int k = 0; k < 3; k++) {
            float c = item_centre(&item[i], k);
            lo[k] = float_min(c, lo[k]), hi[k] = float_max(c, hi[k]);
        }
    for (int k = 0; k < 3; k++) extent = float_max(hi[k] - lo[k], extent);
    float most = (float)((1 << morton_bits) - 1), scale = most / extent;
    if (!(scale < FLT_MAX)) scale = 0;
    for (size_t i = 0; i < n; i++) {
        uint32_t x[3];
        for (int k = 0; k < 3; k++)
            x[k] = (uint32_t)float_min((item_centre(&item[i], k) - lo[k]) * scale, most);
        pair[i] = (radix_code){morton_code(x[0], x[1], x[2]), (uint32_t)i};
    }
}

/* item[i] becomes what item[pair[i].place] was; room[n]: for the time between. */
static inline void morton_reorder(bvh_item *item, const radix_code *pair, size_t n, bvh_item *room)
{
    for (size_t i = 0; i < n; i++) room[i] = item[pair[i].place];
    memcpy(item, room, n * sizeof *item);
}

/* The first of the sorted codes [begin, end) that has the highest bit in which the first and the
 * last differ (14.10); the middle, if they are the same. Before it that bit is 0, behind it 1. */
static inline size_t morton_cut(const radix_code *pair, size_t begin, size_t end)
{
    uint64_t below = (pair[begin].key ^ pair[end - 1].key) >> 1;
    if (pair[begin].key == pair[end - 1].key) return begin + (end - begin) / 2;
    for (int shift = 1; shift < 64; shift *= 2) below |= below >> shift;  /* all bits behind it */
    uint64_t least = pair[end - 1].key & ~below;
    while (begin < end) {
        size_t middle = begin + (end - begin) / 2;
        if (pair[middle].key < least) begin = middle + 1;
        else end = middle;
    }
    return begin;
}

typedef struct {
    bvh_tree *tree;
    const bvh_item *item;
    const radix_code *pair;
    bvh_options options;
} morton_builder;

/* Node `at` over the items [begin, end). Returns its cost by the heuristic, times its area. */
static inline double morton_node(morton_builder *b, size_t at, size_t begin, size_t end, int depth)
{
    bvh_tree *t = b->tree;
    size_t n = end - begin, first = t->nodes;
    int deepest = t->depth > depth ? t->depth : depth;
    bool fits = n <= (size_t)b->options.leaf, deep = depth + log2_above(n) >= bvh_most_depth;
    double built = HUGE_VAL;
    bvh_box box = box_empty();
    if (n > 1 && !(fits && deep)) {
        size_t cut = deep ? begin + n / 2 : morton_cut(b->pair, begin, end);
        t->nodes += 2;
        built = morton_node(b, first, begin, cut, depth + 1)
              + morton_node(b, first + 1, cut, end, depth + 1);
        box_add(&box, &t->node[first]), box_add(&box, &t->node[first + 1]);
        built += box_area(&box);
    } else for (size_t i = begin; i < end; i++) box_add(&box, &b->item[i]);
    double leaf = box_area(&box) * (double)n * b->options.item_cost;
    if (n == 1 || (fits && !(leaf > built))) {  /* what hangs below, if anything, is not needed */
        t->nodes = first, t->depth = deepest;
        built = leaf;
        t->node[at] = box_numbered(&box, begin, n);
    } else t->node[at] = box_numbered(&box, first, 0);
    return built;
}

static inline void tree_morton(const bvh_input *in, bvh_options how, bvh_tree *t)
{
    size_t n = in->n, size = sizeof(radix_code);
    radix_code *pair = tree_array(t, n, size), *spare = tree_array(t, n, size);
    if (!t->held.full) {
        morton_codes(in->item, n, pair);
        radix_sort_codes(pair, spare, n);
    }
    memory_drop(&t->held, spare, n, size);
    bvh_item *room = memory_array(&t->held, n, sizeof *room);
    if (!t->held.full) morton_reorder(in->item, pair, n, room);
    memory_drop(&t->held, room, n, sizeof *room);
    if (!t->held.full && tree_begin(t, 2 * n + 2)) {
        morton_builder b = {t, in->item, pair, how};
        if (n) morton_node(&b, 0, 0, n, 0);
    }
    memory_drop(&t->held, pair, n, size);
}

#endif
