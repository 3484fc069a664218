/* tree.h: building the tree of boxes (层次包围盒, bounding volume hierarchy) over items of any kind.
 *
 *   bool tree_build(item, n, how, &t, &f)    reorders item[n], of boxes alone; false: f says why
 *   bool tree_build_input(&in, how, &t, &f)  the same of items that can be cut, too
 *   tree_stats(&t)                           items: references, too; a tree knows no triangles
 *   tree_free(&t)                            a zeroed tree may be freed: build/store.h
 *
 *   how.rule            one of bvh_rules, below, by its name
 *   how.leaf, how.item_cost, how.most_bytes: build/store.h
 *
 * O(n log n). Depth: cuts by planes may peel off one item each: n items 1, 2, 4, 8 ... apart make a
 * tree n deep. So a set of n items at depth d is halved by number as soon as d + log2(n) reaches
 * 64. Halving keeps that sum, so no leaf is deeper than 64, and a search needs to remember 64
 * siblings at most: a stack of fixed size that no input overflows.
 *
 * Memory. 32 bytes an item while it is built, 64 for nodes: 2 n + 2 of them are the most there can
 * be. The sweep takes 20 more, Morton codes 16. What is not used is given back. t.held.peak is
 * the most held at any time.
 */
#ifndef BVH_TREE_H
#define BVH_TREE_H

#include "../09_aabb/structure.h"
#include "build/morton.h"
#include "build/spatial.h"

/* A leaf of most items, a test that costs so much of a pair of boxes. */
#define bvh_leaves(most, cost) ((bvh_options){"sah", most, cost, SIZE_MAX})

/* By measurement: eight in a leaf, and a test that costs 0.3 of a pair of boxes. Most tests end at
 * the first comparison of signs. */
#define bvh_defaults bvh_leaves(8, 0.3)

typedef struct {
    const char *name;
    size_t (*split)(splitter *s, bvh_item *item, size_t n);  /* NULL: it does not cut downwards */
    bool by_cost;  /* knows s.cost, which may prefer a leaf */
    bool sorts;    /* needs s.pairs, s.spare, s.areas */
    void (*build)(const bvh_input *in, bvh_options how, bvh_tree *t);  /* NULL: by its cuts */
    bool through;  /* cuts through items */
} bvh_rule;

static const bvh_rule bvh_rules[] = {
    {.name = "cycle", .split = split_cycle},
    {.name = "longest", .split = split_longest},
    {.name = "cycle-median", .split = split_cycle_median},
    {.name = "median", .split = split_median},
    {.name = "sah", .split = split_binned, .by_cost = true},
    {.name = "sweep", .split = split_sweep, .by_cost = true, .sorts = true},
    {.name = "morton", .build = tree_morton},
    {.name = "spatial", .build = tree_spatial, .through = true},
};
enum { bvh_rule_count = sizeof bvh_rules / sizeof *bvh_rules };

/* ---------------------------------------------------------------------------------------------- */

/* NULL: no such name. */
static inline const bvh_rule *bvh_rule_find(const char *name)
{
    for (int k = 0; k < bvh_rule_count; k++)
        if (strcmp(bvh_rules[k].name, name) == 0) return &bvh_rules[k];
    return NULL;
}

typedef struct { size_t at, begin, n; int depth; } tree_job;  /* node `at`, of so many items */

typedef struct {
    bvh_tree *tree;
    const bvh_rule *rule;
    bvh_item *item;
    bvh_options options;
    splitter split;
    /* For builders of several threads (15): */
    size_t aside;    /* sets of so many items or fewer are not built, but become jobs; and children
                      * of a cut before item p are nodes 2 p and 2 p + 1. 0: the next ones */
    tree_job *job;
    size_t jobs;
} tree_builder;

/* How many of the n items go left, or 0: they make a leaf. */
static inline size_t tree_split(tree_builder *b, bvh_item *item, size_t n, int depth)
{
    splitter *s = &b->split;
    bool fits = n <= (size_t)b->options.leaf;
    bool deep = depth + log2_above(n) >= bvh_most_depth;
    if (n == 1 || (fits && (deep || !b->rule->by_cost))) return 0;
    if (deep) return split_by_number(item, n, box_longest(&s->centres));
    s->cost = HUGE_VAL;
    size_t left = b->rule->split(s, item, n);
    return fits && s->cost >= (double)n * s->item_cost ? 0 : left;
}

/* Node j.at and all below it. */
static inline void tree_node(tree_builder *b, tree_job j)
{
    bvh_tree *t = b->tree;
    if (j.n <= b->aside) {
        b->job[b->jobs++] = j;
        return;
    }
    if (j.depth > t->depth) t->depth = j.depth;
    b->split.depth = j.depth;
    split_measure(&b->split, b->item + j.begin, j.n);
    t->node[j.at] = box_numbered(&b->split.box, j.begin, j.n);
    size_t left = tree_split(b, b->item + j.begin, j.n, j.depth), middle = j.begin + left;
    size_t first = b->aside ? 2 * middle : t->nodes;
    if (left == 0) return;
    t->node[j.at] = box_numbered(&b->split.box, first, 0);
    t->nodes += 2;
    tree_node(b, (tree_job){first, j.begin, left, j.depth + 1});
    tree_node(b, (tree_job){first + 1, middle, j.n - left, j.depth + 1});
}

/* From the root down, by the cuts of split.h. */
static inline void tree_by_cuts(const bvh_input *in, const bvh_rule *rule, bvh_options how,
                                bvh_tree *t)
{
    size_t n = in->n, sorted = rule->sorts ? n : 0, pair = sizeof(radix_pair);
    memory *m = &t->held;
    splitter s = {.item_cost = how.item_cost};
    s.pairs = tree_array(t, sorted, pair), s.spare = tree_array(t, sorted, pair);
    s.areas = tree_array(t, sorted, sizeof *s.areas);
    tree_builder b = {.tree = t, .rule = rule, .item = in->item, .options = how, .split = s};
    if (!m->full && tree_begin(t, 2 * n + 2) && n) tree_node(&b, (tree_job){0, 0, n, 0});
    memory_drop(m, s.pairs, sorted, pair), memory_drop(m, s.spare, sorted, pair);
    memory_drop(m, s.areas, sorted, sizeof *s.areas);
}

/* Where items cannot be cut, a rule that cuts them becomes the heuristic. */
static inline bool tree_build_input(const bvh_input *in, bvh_options how, bvh_tree *t, failure *f)
{
    const bvh_rule *rule = bvh_rule_find(how.rule);
    *t = (bvh_tree){.items = in->n, .held = {.most = how.most_bytes}};
    if (!rule) return failed(f, 2, "%s: no rule for cutting a BVH", how.rule);
    if (in->room >> 31) return failed(f, 2, "%zu items: fewer than 2^31 fit", in->room);
    if (rule->through && !in->clip) rule = bvh_rule_find("sah");
    if (memory_takes(&t->held, in->room, sizeof *in->item)) {
        if (rule->build) rule->build(in, how, t);
        else tree_by_cuts(in, rule, how, t);
    }
    if (t->held.full) {
        tree_free(t);
        return memory_failed(f, "BVH", in->n, how.most_bytes);
    }
    tree_trim(t);
    return true;
}

static inline bool tree_build(bvh_item *item, size_t n, bvh_options how, bvh_tree *t, failure *f)
{
    return tree_build_input(&(bvh_input){item, n, n, NULL, NULL}, how, t, f);
}

static inline structure_stats tree_stats(const bvh_tree *t)
{
    structure_stats s = {.references = t->items, .items = t->items, .depth = t->depth,
                         .bytes = t->held.bytes, .peak = t->held.peak};
    for (size_t i = 0; t->items && i < t->nodes; i++) s.leaves += i != 1 && t->node[i].count > 0;
    s.inner = s.leaves ? s.leaves - 1 : 0;
    return s;
}

#endif
