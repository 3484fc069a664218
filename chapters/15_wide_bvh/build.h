/* build.h: the wide tree, made in four steps from a binary one.
 *
 *   bool bvh8_build(&x, bvh8_defaults, &w, &f)      false: coordinates too large; says why
 *
 *   1. Items: their boxes in the tree's frame. What can't be hit is left out.
 *   2. A binary tree (14), from the root down, by surface area, with one difference: a leaf costs
 *      as many tests as it has blocks, so a cut into L and R costs                        (15.4)
 *
 *          area(L) ceil(n(L) / 8) + area(R) ceil(n(R) / 8)
 *
 *      which leaves blocks fuller than counting triangles does.
 *   3. Collapse (合并). Which of the binary tree's nodes remain? Of a subtree s that may take up to
 *      j places in the node above, the cheapest way costs                                 (15.5)
 *
 *          C(s, 1) = min(area(s) + C(s, 8), area(s) leaf_cost)      one place: a node, or a leaf
 *          C(s, j) = min over k of C(left, k) + C(right, j - k), or C(s, j - 1)
 *
 *      from the leaves up: eight numbers a node, and no better collapse of this tree exists.
 *   4. Nodes and blocks, in the order of the search: depth first.
 *
 * Steps 1, 2 and the filling of blocks use all threads. Where a piece goes depends on the items
 * alone (the children of a cut between items p - 1 and p are nodes 2 p and 2 p + 1), so the tree is
 * the same for any number of threads.
 *
 * Source: H. Ylitie, T. Karras, S. Laine, "Efficient Incoherent Ray Traversal on GPUs Through
 * Compressed Wide BVHs", HPG 2017, section 3.1; I. Wald, C. Benthin, S. Boulos, "Getting Rid of
 * Packets", IRT 2008.
 */
#ifndef WIDE_BUILD_H
#define WIDE_BUILD_H

#include "../../common/parallel.h"
#include "tree8.h"

enum { bvh8_jobs = 64, bvh8_bins = 16, bvh8_chunk = 4096 };

typedef struct { float cost[8]; } bvh8_costs;
typedef struct { uint32_t at, begin, n; int depth; bvh8_costs costs; } bvh8_job;

typedef struct {
    bvh8 *w;
    bvh8_options how;
    bvh_item *item;
    size_t n;
    bvh_node *node;       /* [2 n] the binary tree; count: items below, of inner nodes, too */
    uint8_t (*pick)[8];   /* [2 n] [s][j - 1]: the best k of (15.5); 0: C(s, j - 1), or a leaf */
    uint32_t *leaf;       /* [blocks] the binary node that becomes that block */
    bvh8_job *job;
    size_t jobs, job_size;
    atomic_bool inexact;
} bvh8_builder;

/* ---------------------------------------------------------------------------------------------- */

/* Is the corner, as a float in the frame, the very corner? Then a block holds what `real` needs. */
static inline bool bvh8_is_exact(const bvh8 *w, vec3 p)
{
    vec3 q = bvh8_into(w, p);
    float x = (float)q.x, y = (float)q.y, z = (float)q.z;
    vec3 back = bvh8_back(w, x, y, z);
    return back.x == p.x && back.y == p.y && back.z == p.z;
}

/* Step 1, a piece of it. */
static inline void bvh8_item_job(size_t piece, void *context)
{
    bvh8_builder *b = context;
    const bvh8 *w = b->w;
    size_t end = (piece + 1) * bvh8_chunk < w->x.n ? (piece + 1) * bvh8_chunk : w->x.n;
    bool exact = true;
    for (size_t i = piece * bvh8_chunk; i < end; i++) {
        aabb box;
        bool held = items_bounds(&w->x, i, &box);
        b->item[i].index = no_shape;
        if (!held) continue;
        if (w->x.m) {
            triangle t = mesh_triangle(w->x.m, i);
            if (vzero(triangle_cross(t.a, t.b, t.c))) continue;
            exact = exact && bvh8_is_exact(w, t.a) && bvh8_is_exact(w, t.b)
                && bvh8_is_exact(w, t.c);
        }
        b->item[i].box = box_between(bvh8_into(w, box.lo), bvh8_into(w, box.hi));
        b->item[i].index = (uint32_t)i;
    }
    if (!exact) atomic_store(&b->inexact, true);
}

/* ---------------------------------------------------------------------------------------------- */

typedef struct { bvh_box box, centres; } bvh8_extent;
typedef struct { bvh_box box; uint32_t n; } bvh8_bin;
typedef struct { double cost; int axis, bin; } bvh8_cut;

static inline bvh8_extent bvh8_measure(const bvh_item *item, size_t n)
{
    bvh8_extent e = {box_empty(), box_empty()};
    for (size_t i = 0; i < n; i++) {
        box_add(&e.box, &item[i].box);
        for (int k = 0; k < 3; k++) {
            float c = item_centre(&item[i], k);
            e.centres.side[k] = float_min(c, e.centres.side[k]);
            e.centres.side[3 + k] = float_max(c, e.centres.side[3 + k]);
        }
    }
    return e;
}

static inline double bvh8_blocks_of(const bvh_box *box, uint32_t n)
{
    return n ? box_area(box) * (double)((n + 7) / 8) : HUGE_VAL;
}

/* (15.4) for all planes between bins of an axis. */
static inline void bvh8_sweep(const bvh8_bin *bin, int bins, int axis, bvh8_cut *best)
{
    double right[bvh8_bins];
    bvh_box box = box_empty();
    uint32_t n = 0;
    for (int i = bins - 1; i > 0; i--) {
        box_add(&box, &bin[i].box), n += bin[i].n;
        right[i] = bvh8_blocks_of(&box, n);
    }
    box = box_empty(), n = 0;
    for (int i = 0; i + 1 < bins; i++) {
        box_add(&box, &bin[i].box), n += bin[i].n;
        double cost = bvh8_blocks_of(&box, n) + right[i + 1];
        if (cost < best->cost) *best = (bvh8_cut){cost, axis, i};
    }
}

static inline int bvh8_bin_of(const bvh_item *item, int axis, float lo, float scale)
{
    return (int)((item_centre(item, axis) - lo) * scale);
}

/* How many of the n > 1 items go left: [1, n - 1]. */
static inline size_t bvh8_split(bvh_item *item, size_t n, const bvh_box *centres, bool by_number)
{
    bvh8_bin bin[3][bvh8_bins];
    bvh8_cut best = {HUGE_VAL, 0, 0};
    float scale[3];
    int bins = n < 16 ? bvh8_bins / 2 : bvh8_bins;
    if (by_number) return split_by_number(item, n, box_longest(centres));
    for (int k = 0; k < 3; k++) {
        scale[k] = (float)bins * 0.9999f / (centres->side[3 + k] - centres->side[k]);
        if (!(scale[k] < FLT_MAX)) scale[k] = 0;
        for (int i = 0; i < bins; i++) bin[k][i] = (bvh8_bin){box_empty(), 0};
    }
    size_t step = n < 32768 ? 1 : n / 16384 | 1;  /* of many items a sample tells: 14 */
    for (size_t i = 0; i < n; i += step)
        for (int k = 0; k < 3; k++) {
            bvh8_bin *b = &bin[k][bvh8_bin_of(&item[i], k, centres->side[k], scale[k])];
            box_add(&b->box, &item[i].box), b->n++;
        }
    for (int k = 0; k < 3; k++)
        if (scale[k] > 0) bvh8_sweep(bin[k], bins, k, &best);
    if (best.cost == HUGE_VAL) return split_by_number(item, n, box_longest(centres));
    float lo = centres->side[best.axis], by = scale[best.axis];
    size_t left = 0, right = n;
    while (left < right) {
        if (bvh8_bin_of(&item[left], best.axis, lo, by) <= best.bin) left++;
        else item_swap(&item[left], &item[--right]);
    }
    return left;
}

/* ---------------------------------------------------------------------------------------------- */

static inline float bvh8_leaf_price(const bvh8_builder *b, const bvh_node *n)
{
    if (n->count > 8) return INFINITY;
    float tests = b->w->x.m ? b->how.leaf_cost : b->how.shape_cost * (float)n->count;
    return (float)box_area(&n->box) * tests;
}

/* (15.5) at an inner node, from its children's. */
static inline void bvh8_price(const bvh8_builder *b, uint32_t at, const bvh8_costs *l,
                              const bvh8_costs *r, bvh8_costs *out)
{
    const bvh_node *n = &b->node[at];
    float area = (float)box_area(&n->box), *cost = out->cost;
    uint8_t *pick = b->pick[at];
    for (int j = 2; j <= 8; j++) {
        cost[j - 1] = INFINITY;
        for (int k = 1; k < j; k++) {
            float c = l->cost[k - 1] + r->cost[j - k - 1];
            if (c < cost[j - 1]) cost[j - 1] = c, pick[j - 1] = (uint8_t)k;
        }
        if (pick[j - 1] == 0) pick[j - 1] = 1;  /* areas that overflowed */
    }
    cost[0] = cost[b->how.width - 1] + area, pick[0] = 1;
    float leaf = bvh8_leaf_price(b, n);
    if (leaf <= cost[0]) cost[0] = leaf, pick[0] = 0;
    for (int j = 2; j <= 8; j++)
        if (cost[j - 2] <= cost[j - 1]) cost[j - 1] = cost[j - 2], pick[j - 1] = 0;
}

static inline void bvh8_as_leaf(const bvh8_builder *b, uint32_t at, bvh8_costs *out)
{
    const bvh_node *n = &b->node[at];
    float leaf = bvh8_leaf_price(b, n);
    for (int j = 0; j < 8; j++) out->cost[j] = leaf, b->pick[at][j] = 0;
}

/* Steps 2 and 3 below node `at`. With b->job_size > 0 the top of the tree: what is not larger
 * becomes a job. */
static inline void bvh8_grow(bvh8_builder *b, uint32_t at, size_t begin, size_t n, int depth,
                             bool top, bvh8_costs *out)
{
    if (top && n <= b->job_size) {
        b->job[b->jobs++] = (bvh8_job){at, (uint32_t)begin, (uint32_t)n, depth, {{0}}};
        return;
    }
    bvh8_extent e = bvh8_measure(b->item + begin, n);
    b->node[at] = (bvh_node){e.box, (uint32_t)begin, (uint32_t)n};
    if (n <= (size_t)b->how.cut) {
        bvh8_as_leaf(b, at, out);
        return;
    }
    bool deep = depth + log2_above(n) >= bvh_most_depth;  /* 14 says why */
    size_t left = bvh8_split(b->item + begin, n, &e.centres, deep);
    uint32_t child = (uint32_t)(2 * (begin + left));
    bvh8_costs l, r;
    b->node[at].first = child;
    bvh8_grow(b, child, begin, left, depth + 1, top, &l);
    bvh8_grow(b, child + 1, begin + left, n - left, depth + 1, top, &r);
    if (!top) bvh8_price(b, at, &l, &r, out);
}

static inline void bvh8_grow_job(size_t i, void *context)
{
    bvh8_builder *b = context;
    bvh8_job *j = &b->job[i];
    bvh8_grow(b, j->at, j->begin, j->n, j->depth, false, &j->costs);
}

/* (15.5) for the top of the tree, when all jobs are done: they come up again in the same order. */
static inline void bvh8_price_top(bvh8_builder *b, uint32_t at, size_t n, size_t *job,
                                  bvh8_costs *out)
{
    if (n <= b->job_size) {
        *out = b->job[(*job)++].costs;
        return;
    }
    uint32_t first = b->node[at].first;
    size_t left = b->node[first].count;
    bvh8_costs l, r;
    bvh8_price_top(b, first, left, job, &l);
    bvh8_price_top(b, first + 1, n - left, job, &r);
    bvh8_price(b, at, &l, &r, out);
}

/* ---------------------------------------------------------------------------------------------- */

/* Adds to list[] the nodes that take the `places` places that (15.5) gave to `at`. */
static inline int bvh8_places(const bvh8_builder *b, uint32_t at, int places, uint32_t *list, int n)
{
    const uint8_t *pick = b->pick[at];
    while (places > 1 && pick[places - 1] == 0) places--;
    if (places == 1) {
        list[n] = at;
        return n + 1;
    }
    uint32_t first = b->node[at].first;
    n = bvh8_places(b, first, pick[places - 1], list, n);
    return bvh8_places(b, first + 1, places - pick[places - 1], list, n);
}

static inline void bvh8_put(bvh8_node *node, int k, const bvh_box *box, uint32_t child)
{
    for (int s = 0; s < 6; s++) ((float *)&node->side[s])[k] = box->side[s];
    node->child[k] = child;
}

/* Step 4 below `at`; returns its number. Without arrays it only counts what they must hold. */
static inline uint32_t bvh8_emit(bvh8_builder *b, uint32_t at, int depth, bool root)
{
    bvh8 *w = b->w;
    if (!root && b->pick[at][0] == 0) {
        if (b->leaf) b->leaf[w->blocks] = at;
        return bvh8_leaf | (uint32_t)w->blocks++;
    }
    uint32_t me = (uint32_t)w->nodes++, list[8], first = b->node[at].first;
    int n = 1, places = b->how.width;
    const uint8_t *pick = b->pick[at];
    list[0] = at;  /* the root is a leaf: a node with one child */
    if (pick[0]) {
        while (places > 1 && pick[places - 1] == 0) places--;
        if (places == 1) places = 2;
        int left = pick[places - 1] ? pick[places - 1] : 1;
        n = bvh8_places(b, first, left, list, 0);
        n = bvh8_places(b, first + 1, places - left, list, n);
    }
    if (depth > w->depth) w->depth = depth;
    bvh_box none = box_empty();
    for (int k = 0; k < 8; k++) {
        uint32_t child = k < n ? bvh8_emit(b, list[k], depth + 1, false) : 0;
        if (w->node) bvh8_put(&w->node[me], k, k < n ? &b->node[list[k]].box : &none, child);
    }
    return me;
}

/* Blocks of triangles, or lists of shapes, a piece of them. */
static inline void bvh8_fill_job(size_t piece, void *context)
{
    bvh8_builder *b = context;
    bvh8 *w = b->w;
    for (size_t i = 256 * piece; i < w->blocks && i < 256 * (piece + 1); i++) {
        const bvh_node *n = &b->node[b->leaf[i]];
        uint32_t count = n->count, *index = w->block ? w->block[i].index : w->list[i].index;
        while (n->count > (uint32_t)b->how.cut) n = &b->node[n->first];
        const bvh_item *item = &b->item[n->first];
        for (uint32_t k = 0; k < 8; k++) {
            index[k] = k < count ? item[k].index : no_shape;
            if (!w->block) continue;
            triangle t = mesh_triangle(w->x.m, item[k < count ? k : 0].index);
            const vec3 p[3] = {bvh8_into(w, t.a), bvh8_into(w, t.b), bvh8_into(w, t.c)};
            for (int j = 0; j < 9; j++)
                ((float *)&w->block[i].corner[j])[k] = (float)vaxis(p[j / 3], j % 3);
        }
    }
}

/* Its centre is 0 unless the items lie far from there: then floats stay what they are. */
static inline void bvh8_frame(bvh8 *w, aabb all)
{
    vec3 centre = aabb_centre(all), half = vsub(all.hi, centre);
    real size = vaxis(half, vlongest(half)), far = fabs(vaxis(centre, vlongest(centre)));
    int e, most = real_is_float ? 100 : 1000;
    w->centre = far <= 8 * size ? (vec3){0, 0, 0} : centre;
    if (far <= 8 * size) size += far;
    (void)frexp(size, &e);
    e = e > most ? most : e < -most ? -most : e;
    w->scale = size > 0 ? ldexp((real)1, -e) : 1;
}

static inline void *bvh8_room(bvh8 *w, size_t n, size_t size)
{
    void *p = aligned_alloc(64, (n * size + 63) / 64 * 64);
    if (!p) die(1, "no memory for %zu times %zu bytes", n, size);
    w->bytes += n * size;
    return p;
}

static inline void bvh8_layout(bvh8_builder *b)
{
    bvh8 *w = b->w;
    bvh8_emit(b, 0, 1, true);
    w->node = bvh8_room(w, w->nodes, sizeof *w->node);
    if (w->x.m) w->block = bvh8_room(w, w->blocks, sizeof *w->block);
    else w->list = bvh8_room(w, w->blocks, sizeof *w->list);
    b->leaf = allocate(w->blocks, sizeof *b->leaf);
    w->nodes = w->blocks = 0;
    bvh8_emit(b, 0, 1, true);
    parallel_for((w->blocks + 255) / 256, b->how.threads, "blocks", bvh8_fill_job, b);
    w->peak += w->bytes;
    free(b->leaf);
}

static inline bool bvh8_build(const items *x, bvh8_options how, bvh8 *w, failure *f)
{
    aabb all;
    *w = (bvh8){.x = *x, .scale = 1, .dialect = how.dialect};
    if (!items_all_bounds(x, &all, f)) return false;
    if (x->n >> 30) return failed(f, 2, "%zu items: fewer than 2^30 fit", x->n);
    if (aabb_is_empty(all)) return true;
    bvh8_frame(w, all);
    size_t need = x->n * (sizeof(bvh_item) + 2 * (sizeof(bvh_node) + 8) + 64);
    if (need > how.most_bytes)
        return failed(f, 1, "%zu items: more than the %zu bytes allowed", x->n, how.most_bytes);
    bvh8_builder b = {.w = w, .how = how, .item = allocate(x->n, sizeof(bvh_item))};
    parallel_for((x->n + bvh8_chunk - 1) / bvh8_chunk, how.threads, "items", bvh8_item_job, &b);
    for (size_t i = 0; i < x->n; i++)
        if (b.item[i].index != no_shape) b.item[b.n++] = b.item[i];
    w->exact = !atomic_load(&b.inexact), w->held = b.n;
    if (b.n) {
        b.node = allocate(2 * b.n, sizeof *b.node), b.pick = allocate(2 * b.n, sizeof *b.pick);
        b.job_size = b.n / (bvh8_jobs / 2) > 1024 ? b.n / (bvh8_jobs / 2) : 1024;
        b.job = allocate(b.n, sizeof *b.job);
        size_t job = 0;
        bvh8_costs costs;
        bvh8_grow(&b, 0, 0, b.n, 0, true, &costs);
        parallel_for(b.jobs, how.threads, "tree", bvh8_grow_job, &b);
        bvh8_price_top(&b, 0, b.n, &job, &costs);
        w->peak = x->n * sizeof *b.item + 2 * b.n * (sizeof *b.node + sizeof *b.pick);
        w->cost = (double)costs.cost[0] / box_area(&b.node[0].box);
        bvh8_layout(&b);
    }
    free(b.item), free(b.node), free(b.pick), free(b.job);
    return true;
}

#endif
