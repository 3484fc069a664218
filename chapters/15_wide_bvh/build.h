/* build.h: the wide tree, from a binary one (合并, collapse).
 *
 *   bool bvh8_build(&x, bvh8_defaults, &w, &f)      false: f says why: coordinates too large, too
 *                                                   many items, options out of range, Ctrl-C
 *
 *   1. Items: their boxes in the tree's frame. What can't be hit is left out.
 *   2. A binary tree, from the root down, by surface area in bins, as in 14, except that a leaf
 *      costs as many tests as it has blocks: a cut into L and R,
 *          area(L) ceil(n(L) / 8) + area(R) ceil(n(R) / 8)                                  (15.4)
 *      Bins along x, y and z; near the root of size, too: walls and what stands between them have
 *      middles side by side, and together would make every box as large as the room.
 *      The children of a cut between items p - 1 and p are nodes 2 p and 2 p + 1: a place that
 *      depends on the items alone, so the tree is the same for any number of threads. Large sets
 *      are cut first, by one; what is small is a job for whoever comes.
 *   3. Collapse. Which of its nodes remain? Those with the least sum of areas, (15.5) of
 *      MEASURED.md: C(s, j) if s takes up to j places in the node above.
 *   4. Nodes and blocks, in the order of the search: depth first.
 *
 * Sources: I. Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", IRT 2007;
 * H. Ylitie, T. Karras, S. Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed
 * Wide BVHs", HPG 2017, section 3.1 (collapse).
 */
#ifndef WIDE_BUILD_H
#define WIDE_BUILD_H

#include "../../common/parallel.h"
#include "tree8.h"

/* Eight floats: what is around two bounds is one minimum. The middle on axis k, twice: lo[k] -
 * minus_hi[k]. Of an item `first` is its number; of a node, that of the first of `count` items, or
 * of two nodes. */
typedef union {
    eight all;
    struct { float lo[3]; uint32_t first; float minus_hi[3]; uint32_t count; };
} bvh8_bound;

typedef struct { uint32_t at, begin, n; int depth; } bvh8_job;
typedef struct { float cost[bvh8_places]; int leaves; } bvh8_costs;
typedef struct { bvh8_bound box; eight ends; float scale[4]; int bins, ways; } bvh8_extent;
typedef struct { eight box[most_bins]; uint32_t n[most_bins]; } bvh8_bins;

typedef struct {
    bvh8 *w;
    int leaf, width;
    bvh8_bound *item;     /* [n] */
    bvh8_bound *node;     /* [2 n] as in 14; of leaves `count` is not 0 */
    uint8_t (*pick)[bvh8_places];  /* [2 n] (15.5): best k for j places at j - 1; 0: C(s, j - 1) */
    uint32_t *leaves;     /* [blocks] which becomes that block */
    bvh8_job *job;
    size_t n, jobs, job_size;
} bvh8_builder;

#define bvh8_around(a, b) EIGHT_LOOP(eight_min, a, b)
enum { bvh8_near_root = 3 };  /* levels */

/* ---------------------------------------------------------------------------------------------- */

/* 4096 items; `first` of what can't be hit is no_shape. */
static inline void bvh8_items_job(size_t piece, void *context)
{
    const bvh8_builder *b = context;
    const bvh8 *w = b->w;
    for (size_t i = 4096 * piece; i < w->x.n && i < 4096 * (piece + 1); i++) {
        aabb box;
        bvh8_bound *out = &b->item[i];
        out->first = no_shape;
        if (!items_bounds(&w->x, i, &box)) continue;
        triangle t = w->x.m ? mesh_triangle(w->x.m, i) : (triangle){.a = box.lo};
        if (w->x.m && vzero(triangle_cross(t.a, t.b, t.c))) continue;
        vec3 lo = bvh8_into(w, box.lo), hi = bvh8_into(w, box.hi);
        for (int k = 0; k < 3; k++)
            out->lo[k] = float_below(vaxis(lo, k)), out->minus_hi[k] = float_below(-vaxis(hi, k));
        out->first = (uint32_t)i, out->count = 0;
    }
}

/* Half of its surface, in double, so that no float box overflows it; 0 if empty. */
static inline double bvh8_area(const eight *b)
{
    double x = -(double)(*b)[4] - (double)(*b)[0], y = -(double)(*b)[5] - (double)(*b)[1];
    double z = -(double)(*b)[6] - (double)(*b)[2];
    return x >= 0 ? x * y + y * z + z * x : 0;
}

/* Where an item is, of which the bins are: twice the middle of its box on axis k; 3: its size. */
__attribute__((always_inline))
static inline float bvh8_where(const eight *box, int k)
{
    const float *lo = (const float *)box, *minus_hi = lo + 4;
    return k < 3 ? lo[k] - minus_hi[k]
                 : -(lo[0] + minus_hi[0]) - (lo[1] + minus_hi[1]) - (lo[2] + minus_hi[2]);
}

/* Around the items, and where they are, from ends[k] to -ends[4 + k]; ways to cut, bins, and bins a
 * unit: 0 where nothing is to cut. */
static inline bvh8_extent bvh8_measure(const bvh8_bound *item, size_t n, int depth)
{
    eight all = EIGHT_ALL(INFINITY), ends = all;
    bvh8_extent e = {.bins = bins_for(n), .ways = depth < bvh8_near_root ? 4 : 3};
    for (size_t i = 0; i < n; i++) {
        eight box = item[i].all, at;
        for (int k = 0; k < 8; k++) at[k] = box[k] - box[k ^ 4];
        all = bvh8_around(all, box), ends = bvh8_around(ends, at);
    }
    ends[3] = INFINITY, ends[7] = INFINITY;
    for (size_t i = 0; e.ways > 3 && i < n; i++) {
        float size = bvh8_where(&item[i].all, 3);
        ends[3] = size < ends[3] ? size : ends[3], ends[7] = -size < ends[7] ? -size : ends[7];
    }
    e.ends = ends;
    e.box.all = all;
    for (int k = 0; k < e.ways; k++) {
        float scale = (float)e.bins * 0.9999f / (-e.ends[4 + k] - e.ends[k]);
        e.scale[k] = scale > 0 && scale < FLT_MAX ? scale : 0;
    }
    return e;
}

__attribute__((always_inline))
static inline int bvh8_bin_of(const bvh8_bound *item, const bvh8_extent *e, int k)
{
    return (int)((bvh8_where(&item->all, k) - e->ends[k]) * e->scale[k]);
}

__attribute__((always_inline))
static inline void bvh8_bin(bvh8_bins *b, const bvh8_bound *item, const bvh8_extent *e, int k)
{
    int at = bvh8_bin_of(item, e, k);
    b[k].box[at] = bvh8_around(b[k].box[at], item->all), b[k].n[at]++;
}

/* (15.4) for all planes between the bins of an axis: from the right, then from the left. */
static inline void bvh8_sweep(const bvh8_bins *b, int bins, int axis, split_choice *best)
{
    double right[most_bins];
    eight box = EIGHT_ALL(INFINITY);
    uint32_t n = 0;
    for (int i = bins - 1; i > 0; i--) {
        box = bvh8_around(box, b->box[i]), n += b->n[i];
        right[i] = n ? bvh8_area(&box) * (double)((n + 7) / 8) : HUGE_VAL;
    }
    box = EIGHT_ALL(INFINITY), n = 0;
    for (int i = 0; i + 1 < bins; i++) {
        box = bvh8_around(box, b->box[i]), n += b->n[i];
        double cost = n ? bvh8_area(&box) * (double)((n + 7) / 8) + right[i + 1] : HUGE_VAL;
        if (cost < best->cost) *best = (split_choice){cost, axis, i};
    }
}

/* How many of the n > 1 items go left; what no plane cuts, in halves. As split_binned of 14. */
static inline size_t bvh8_split(bvh8_bound *item, size_t n, const bvh8_extent *e)
{
    bvh8_bins b[4];
    split_choice best = {HUGE_VAL, 0, 0};
    for (int k = 0; k < e->ways; k++)
        for (int i = 0; i < e->bins; i++) b[k].box[i] = EIGHT_ALL(INFINITY), b[k].n[i] = 0;
    for (size_t i = 0; i < n; i += sample_step(n)) {
        EIGHT_UNROLL
        for (int k = 0; k < 3; k++) bvh8_bin(b, &item[i], e, k);
        if (e->ways > 3) bvh8_bin(b, &item[i], e, 3);
    }
    for (int k = 0; k < e->ways; k++)
        if (e->scale[k] > 0) bvh8_sweep(&b[k], e->bins, k, &best);
    size_t left = 0, right = n;
    if (best.cost == HUGE_VAL) return n / 2;
    while (left < right) {
        bvh8_bound here = item[left];
        if (bvh8_bin_of(&here, e, best.axis) <= best.bin) left++;
        else item[left] = item[--right], item[right] = here;
    }
    return left;
}

/* Below node j.at. Of the top, what is not larger than b->job_size becomes a job. Far down a set is
 * cut in halves, so that no leaf is deeper than bvh_most_depth: 14 says why. */
static inline void bvh8_grow(bvh8_builder *b, bvh8_job j, bool top)
{
    if (top && j.n <= b->job_size) {
        b->job[b->jobs++] = j;
        return;
    }
    bvh8_bound *item = b->item + j.begin, *node = &b->node[j.at];
    bvh8_extent e = bvh8_measure(item, j.n, j.depth);
    *node = e.box, node->first = j.begin, node->count = j.n;
    if (j.n <= (uint32_t)b->leaf) return;
    bool deep = j.depth + log2_above(j.n) >= bvh_most_depth;
    uint32_t left = deep ? j.n / 2 : (uint32_t)bvh8_split(item, j.n, &e), begin = j.begin + left;
    node->first = 2 * begin, node->count = 0;
    bvh8_grow(b, (bvh8_job){2 * begin, j.begin, left, j.depth + 1}, top);
    bvh8_grow(b, (bvh8_job){2 * begin + 1, begin, j.n - left, j.depth + 1}, top);
}

static inline void bvh8_grow_job(size_t i, void *b)
{
    bvh8_grow(b, ((bvh8_builder *)b)->job[i], false);
}

/* ---------------------------------------------------------------------------------------------- */

/* (15.5) at `at`, for no more places than it has leaves. pick[0] is that of the places in the node
 * which it may become; 0: a leaf. */
static inline bvh8_costs bvh8_price(const bvh8_builder *b, uint32_t at)
{
    const bvh8_bound *s = &b->node[at];
    uint8_t *pick = b->pick[at];
    bvh8_costs out = {.leaves = 1};
    if (s->count) return out;
    bvh8_costs l = bvh8_price(b, s->first), r = bvh8_price(b, s->first + 1);
    out.leaves = l.leaves + r.leaves < b->width ? l.leaves + r.leaves : b->width;
    for (int j = 2; j <= out.leaves; j++) {
        float *best = &out.cost[j - 1];
        *best = INFINITY;
        for (int k = j > r.leaves ? j - r.leaves : 1; k < j && k <= l.leaves; k++) {
            float c = l.cost[k - 1] + r.cost[j - k - 1];
            if (c < *best) *best = c, pick[j - 1] = (uint8_t)k;
        }
    }
    pick[0] = pick[out.leaves - 1];
    out.cost[0] = out.cost[out.leaves - 1] + (float)bvh8_area(&s->all);
    for (int j = 1; j < b->width; j++)
        if (out.cost[j - 1] <= out.cost[j]) out.cost[j] = out.cost[j - 1], pick[j] = 0;
    return out;
}

/* The nodes that take the `places` places given to `at`: into list[], and how many. */
static inline int bvh8_spread(const bvh8_builder *b, uint32_t at, int places, uint32_t *list)
{
    const uint8_t *pick = b->pick[at];
    while (places > 1 && !pick[places - 1]) places--;
    if (places == 1) return list[0] = at, 1;
    int left = pick[places - 1], n = bvh8_spread(b, b->node[at].first, left, list);
    return n + bvh8_spread(b, b->node[at].first + 1, places - left, list + n);
}

/* Step 4 below `at`; returns its number. Without arrays it only counts what they must hold. */
static inline uint32_t bvh8_emit(bvh8_builder *b, uint32_t at, int depth)
{
    bvh8 *w = b->w;
    uint32_t first = b->node[at].first, list[bvh8_places] = {at};
    int left = b->pick[at][0], n = 1;
    if (!left && depth > 1 && !w->x.m) return bvh8_leaf | b->item[first].first;
    if (!left && depth > 1) {
        if (b->leaves) b->leaves[w->blocks] = at;
        return bvh8_leaf | (uint32_t)w->blocks++;
    }
    uint32_t me = (uint32_t)w->nodes++;
    if (left) n = bvh8_spread(b, first, left, list);
    if (left) n += bvh8_spread(b, first + 1, b->width - left, list + n);
    if (depth > w->depth) w->depth = depth;
    for (int k = 0; k < bvh8_places; k++) {
        uint32_t child = k < n ? bvh8_emit(b, list[k], depth + 1) : 0;
        if (!w->node) continue;
        eight box = k < n ? b->node[list[k]].all : EIGHT_ALL(INFINITY);
        for (int s = 0; s < 3; s++)
            w->node[me].side[s][k] = box[s], w->node[me].side[3 + s][k] = -box[4 + s];
        w->node[me].child[k] = child;
    }
    return me;
}

/* 256 blocks. */
static inline void bvh8_fill_job(size_t piece, void *context)
{
    const bvh8_builder *b = context;
    const bvh8 *w = b->w;
    for (size_t i = 256 * piece; i < w->blocks && i < 256 * (piece + 1); i++) {
        const bvh8_bound *leaf = &b->node[b->leaves[i]];
        const bvh8_bound *item = b->item + leaf->first;
        for (uint32_t k = 0; k < 8; k++) {
            triangle t = mesh_triangle(w->x.m, item[k < leaf->count ? k : 0].first);
            const vec3 p[3] = {bvh8_into(w, t.a), bvh8_into(w, t.b), bvh8_into(w, t.c)};
            EIGHT_UNROLL
            for (int c = 0; c < 3; c++) {
                eight *row = w->block[i].corner + 3 * c;
                row[0][k] = (float)p[c].x, row[1][k] = (float)p[c].y, row[2][k] = (float)p[c].z;
            }
            w->block[i].index[k] = k < leaf->count ? item[k].first : no_shape;
        }
    }
}

/* ---------------------------------------------------------------------------------------------- */

/* Its centre is 0 unless the items lie far from there: then floats stay what they are. Are all
 * corners floats in it? */
static inline void bvh8_frame(bvh8 *w, aabb all)
{
    vec3 centre = aabb_centre(all), half = vsub(all.hi, centre);
    real size = vaxis(half, vlongest(half)), far = fabs(vaxis(centre, vlongest(centre)));
    int e, most = real_is_float ? 100 : 1000;
    if (far <= 8 * size) centre = (vec3){0, 0, 0}, size += far;
    (void)frexp(size, &e);
    e = e > most ? most : e < -most ? -most : e;
    w->centre = centre, w->scale = size > 0 ? ldexp((real)1, -e) : 1;
    w->exact = w->x.m;
    for (size_t i = 0; w->exact && i < w->x.m->vertices; i++) {
        vec3 p = w->x.m->v[i], q = bvh8_into(w, p);
        q = bvh8_back(w, (float)q.x, (float)q.y, (float)q.z);
        w->exact = p.x == q.x && p.y == q.y && p.z == q.z;
    }
}

static inline void *bvh8_room(size_t n, size_t size)
{
    void *p = aligned_alloc(64, (n * size / 64 + 1) * 64);
    if (!p) die(1, "no memory for %zu times %zu bytes", n, size);
    return p;
}

static inline void bvh8_free(bvh8 *w)
{
    free(w->node), free(w->block);
    *w = (bvh8){.nodes = 0};
}

static inline bool bvh8_build(const items *x, bvh8_options how, bvh8 *w, failure *f)
{
    aabb all;
    *w = (bvh8){.x = *x, .scale = 1, .dialect = how.dialect};
    if (how.leaf < 1 || how.leaf > 8 || how.width < 2 || how.width > bvh8_places)
        return failed(f, 2, "bvh8: leaf %d of 1..8, width %d of 2..%d", how.leaf, how.width,
                      bvh8_places);
    if (!items_all_bounds(x, &all, f)) return false;
    if (x->n >> 30) return failed(f, 2, "%zu items: fewer than 2^30 fit", x->n);
    bvh8_builder b = {.w = w, .leaf = x->m ? how.leaf : 1, .width = how.width};
    size_t each = sizeof *b.item + 2 * sizeof *b.node + 2 * sizeof *b.pick;
    if (x->n * (each + 64) > how.most_bytes)
        return failed(f, 1, "%zu items: more than the %zu bytes allowed", x->n, how.most_bytes);
    bvh8_frame(w, all);
    b.item = bvh8_room(x->n, sizeof *b.item);
    bool whole = parallel_for((x->n + 4095) / 4096, how.threads, "boxes", bvh8_items_job, &b);
    for (size_t i = 0; whole && i < x->n; i++)
        if (b.item[i].first != no_shape) b.item[b.n++] = b.item[i];
    w->held = b.n, b.job_size = b.n / 32 > 1024 ? b.n / 32 : 1024;
    b.node = bvh8_room(2 * b.n, sizeof *b.node), b.pick = allocate(2 * b.n, sizeof *b.pick);
    b.job = allocate(b.n, sizeof *b.job);
    if (b.n && whole) {
        bvh8_grow(&b, (bvh8_job){0, 0, (uint32_t)b.n, 0}, true);
        whole = parallel_for(b.jobs, how.threads, "tree", bvh8_grow_job, &b);
    }
    if (b.n && whole) {
        bvh8_price(&b, 0);
        bvh8_emit(&b, 0, 1);
        w->node = bvh8_room(w->nodes, sizeof *w->node);
        if (x->m) w->block = bvh8_room(w->blocks, sizeof *w->block);
        w->bytes = w->nodes * sizeof *w->node + (x->m ? w->blocks * sizeof *w->block : 0);
        b.leaves = allocate(w->blocks, sizeof *b.leaves);
        w->nodes = w->blocks = 0;
        bvh8_emit(&b, 0, 1);
        whole = parallel_for((w->blocks + 255) / 256, how.threads, "blocks", bvh8_fill_job, &b);
    }
    w->peak = w->bytes + b.n * each;
    free(b.item), free(b.node), free(b.pick), free(b.job), free(b.leaves);
    if (whole) return true;
    bvh8_free(w);
    return failed(f, parallel_stopped(), "stopped");
}

#endif
