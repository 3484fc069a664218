/* build.h: the binary tree below the wide one, made on all cores.
 *
 *   bvh8_grow_all(&b)      from b.item[b.n] the nodes b.node[2 n]; items are put in order
 *
 * From the root down, by surface area in bins, as in 14, with one difference: a leaf costs as many
 * tests as it has blocks, so a cut into L and R costs                                        (15.4)
 *
 *      area(L) ceil(n(L) / 8) + area(R) ceil(n(R) / 8)
 *
 * which leaves blocks fuller than counting triangles does.
 *
 * A bound is eight floats, too: low x, y, z, and high x, y, z with the sign turned. Then what is
 * around two of them is one minimum, and the middle on axis k is lo[k] - minus_hi[k], twice.
 *
 * The children of a cut between items p - 1 and p are nodes 2 p and 2 p + 1: a place that depends
 * on the items alone, so the tree is the same for any number of threads. Large sets are cut first,
 * by one thread; what is small is a job for whoever comes.
 *
 * Source: I. Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", IRT 2007.
 */
#ifndef WIDE_BUILD_H
#define WIDE_BUILD_H

#include "../../common/parallel.h"
#include "tree8.h"

enum { bvh8_most_bins = 32, bvh8_chunk = 4096 };

typedef union {
    eight all;
    struct { float lo[3]; uint32_t first; float minus_hi[3]; uint32_t count; };
} bvh8_bound;  /* an item: its number is `first`. A node: of `count` items; child or item `first` */

typedef struct { uint32_t at, begin, n; int depth; } bvh8_job;

typedef struct {
    bvh8 *w;
    bvh8_options how;
    bvh8_bound *item;     /* [n] */
    bvh8_bound *node;     /* [2 n] */
    uint8_t (*pick)[8];   /* [2 n] collapse.h */
    uint32_t *leaf;       /* [blocks] the binary node that becomes that block */
    bvh8_job *job;
    size_t n, jobs, job_size;
    atomic_bool inexact;  /* a corner that is no float */
} bvh8_builder;

typedef struct { eight box[3][bvh8_most_bins]; uint32_t n[3][bvh8_most_bins]; } bvh8_binned;
typedef struct { bvh8_bound box, middles; float scale[3]; } bvh8_extent;
typedef struct { double cost; int axis, bin; } bvh8_cut;

/* ---------------------------------------------------------------------------------------------- */

#define bvh8_around(a, b) eight_min((const eight[]){a, b})

static inline eight bvh8_nothing(void)
{
    const float x = INFINITY;
    return (eight){x, x, x, x, x, x, x, x};
}

/* Half of its surface; in double, so that no float box overflows it. 0 if empty. */
static inline double bvh8_area(const eight *box)
{
    double x = -(double)(*box)[4] - (double)(*box)[0], y = -(double)(*box)[5] - (double)(*box)[1];
    double z = -(double)(*box)[6] - (double)(*box)[2];
    return x >= 0 ? x * y + y * z + z * x : 0;
}

/* Around the items, and around their middles. scale: bins a unit; 0: there is nothing to cut. */
static inline bvh8_extent bvh8_measure(const bvh8_bound *item, size_t n, int bins)
{
    bvh8_extent e = {.box = {bvh8_nothing()}, .middles = {bvh8_nothing()}};
    for (size_t i = 0; i < n; i++) {
        eight box = item[i].all, middle;
        for (int k = 0; k < 8; k++) middle[k] = box[k] - box[k ^ 4];
        e.box.all = bvh8_around(e.box.all, box);
        e.middles.all = bvh8_around(e.middles.all, middle);
    }
    for (int k = 0; k < 3; k++) {
        e.scale[k] = (float)bins * 0.9999f / (-e.middles.minus_hi[k] - e.middles.lo[k]);
        if (!(e.scale[k] > 0 && e.scale[k] < FLT_MAX)) e.scale[k] = 0;  /* -0: -infinity */
    }
    return e;
}

__attribute__((always_inline))
static inline int bvh8_bin_of(const bvh8_bound *item, const bvh8_extent *e, int k)
{
    return (int)((item->lo[k] - item->minus_hi[k] - e->middles.lo[k]) * e->scale[k]);
}

__attribute__((always_inline))
static inline void bvh8_bin(bvh8_binned *b, const bvh8_bound *item, const bvh8_extent *e, int k)
{
    int bin = bvh8_bin_of(item, e, k);
    b->box[k][bin] = bvh8_around(b->box[k][bin], item->all);
    b->n[k][bin]++;
}

static inline double bvh8_blocks_of(const eight *box, uint32_t n)
{
    return n ? bvh8_area(box) * (double)((n + 7) / 8) : HUGE_VAL;
}

/* (15.4) for all planes between bins of an axis. */
static inline void bvh8_sweep(const bvh8_binned *b, int bins, int axis, bvh8_cut *best)
{
    double right[bvh8_most_bins];
    eight box = bvh8_nothing();
    uint32_t n = 0;
    for (int i = bins - 1; i > 0; i--) {
        box = bvh8_around(box, b->box[axis][i]), n += b->n[axis][i];
        right[i] = bvh8_blocks_of(&box, n);
    }
    box = bvh8_nothing(), n = 0;
    for (int i = 0; i + 1 < bins; i++) {
        box = bvh8_around(box, b->box[axis][i]), n += b->n[axis][i];
        double cost = bvh8_blocks_of(&box, n) + right[i + 1];
        if (cost < best->cost) *best = (bvh8_cut){cost, axis, i};
    }
}

/* The cheapest cut; cost HUGE_VAL: none separates anything. Of many items a sample tells: 14. */
static inline bvh8_cut bvh8_choose(const bvh8_bound *item, size_t n, const bvh8_extent *e, int bins)
{
    bvh8_binned b;
    bvh8_cut best = {HUGE_VAL, 0, 0};
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < bins; i++) b.box[k][i] = bvh8_nothing(), b.n[k][i] = 0;
    size_t step = n < 32768 ? 1 : n / 16384 | 1;
    for (size_t i = 0; i < n; i += step)
        bvh8_bin(&b, &item[i], e, 0), bvh8_bin(&b, &item[i], e, 1), bvh8_bin(&b, &item[i], e, 2);
    for (int k = 0; k < 3; k++)
        if (e->scale[k] > 0) bvh8_sweep(&b, bins, k, &best);
    return best;
}

/* How many of the n > 1 items go left: [1, n - 1]. */
static inline size_t bvh8_split(bvh8_bound *item, size_t n, const bvh8_extent *e, int bins)
{
    bvh8_cut best = bvh8_choose(item, n, e, bins);
    size_t left = 0, right = n;
    if (best.cost == HUGE_VAL) return n / 2;
    while (left < right) {
        if (bvh8_bin_of(&item[left], e, best.axis) <= best.bin) left++;
        else {
            bvh8_bound swapped = item[--right];
            item[right] = item[left], item[left] = swapped;
        }
    }
    return left;
}

/* Below node `at`. Of the top, what is not larger than b->job_size becomes a job. Far down a set is
 * cut in halves, so that no leaf is deeper than bvh_most_depth: 14 says why. */
static inline void bvh8_grow(bvh8_builder *b, bvh8_job j, bool top)
{
    if (top && j.n <= b->job_size) {
        b->job[b->jobs++] = j;
        return;
    }
    int bins = j.n < 16 ? (b->how.bins + 1) / 2 : b->how.bins;
    bvh8_bound *item = b->item + j.begin, *node = &b->node[j.at];
    bvh8_extent e = bvh8_measure(item, j.n, bins);
    *node = e.box, node->first = j.begin, node->count = j.n;
    if (j.n <= (uint32_t)b->how.leaf) return;
    bool deep = j.depth + log2_above(j.n) >= bvh_most_depth;
    uint32_t left = deep ? j.n / 2 : (uint32_t)bvh8_split(item, j.n, &e, bins);
    uint32_t begin = j.begin + left, child = 2 * begin;
    node->first = child;
    bvh8_grow(b, (bvh8_job){child, j.begin, left, j.depth + 1}, top);
    bvh8_grow(b, (bvh8_job){child + 1, begin, j.n - left, j.depth + 1}, top);
}

static inline void bvh8_grow_job(size_t i, void *context)
{
    bvh8_builder *b = context;
    bvh8_grow(b, b->job[i], false);
}

static inline void bvh8_grow_all(bvh8_builder *b)
{
    b->job_size = b->n / 32 > 1024 ? b->n / 32 : 1024;
    b->job = allocate(b->n, sizeof *b->job);
    bvh8_grow(b, (bvh8_job){0, 0, (uint32_t)b->n, 0}, true);
    parallel_for(b->jobs, b->how.threads, "tree", bvh8_grow_job, b);
    free(b->job);
}

#endif
