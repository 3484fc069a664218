/* candidates.h: the strategies, as rows of the bench (09_aabb/trials/bench.h).
 *
 *   bvh_trial, bvh_naive_trial, first_bvh_trial       verbs; options: bvh_options; for the first
 *                                                     bool: true is its heuristic, false the middle
 *   bvh_rows(list, n, row)                            empty rows of so many candidates
 */
#ifndef BVH_CANDIDATES_H
#define BVH_CANDIDATES_H

#include "../../09_aabb/trials/bench.h"
#include "../bvh.h"
#include "../first.h"
#include "../stats.h"

typedef struct { const char *name; const trial_verbs *verbs; bvh_options how; bool sah; }
    bvh_candidate;

/* ---------------------------------------------------------------------------------------------- */

static inline bool bvh_trial_build(const trial_scene *s, const void *how, void *out, failure *f)
{
    (void)f;
    bvh_build(&s->m, *(const bvh_options *)how, out);
    return true;
}

static inline bool bvh_trial_counted(const void *b, ray r, hit *out, search_work *w)
{
    bvh_work k = {0, 0, 0, 0, 0};
    bool found = bvh_hit_counted(b, r, out, &k);
    w->nodes += k.nodes, w->leaves += k.leaves, w->tests += k.tests;
    return found;
}

static inline structure_stats bvh_trial_stats(const void *built)
{
    const bvh *b = built;
    bvh_stats s = bvh_stats_of(&b->tree);
    uint32_t most = 0;
    size_t distinct = 0;  /* spatial splits name some triangles twice */
    for (size_t i = 0; i < s.items; i++)
        if (b->triangle[i].index > most) most = b->triangle[i].index;
    bool *seen = allocate((size_t)most + 1, sizeof *seen);
    for (size_t i = 0; i < s.items; i++)
        distinct += !seen[b->triangle[i].index], seen[b->triangle[i].index] = true;
    free(seen);
    return (structure_stats){.inner = s.inner, .leaves = s.leaves, .references = s.items,
                             .items = distinct, .depth = s.depth, .bytes = s.bytes,
                             .peak = s.peak};
}

static inline void bvh_trial_free(void *b) { bvh_free(b); }

TRIAL_SEARCH(bvh, bvh, bvh_hit)
static const trial_verbs bvh_trial = {sizeof(bvh), bvh_trial_build, bvh_trial_hit,
                                      bvh_trial_counted, bvh_trial_search, bvh_trial_stats,
                                      bvh_trial_free, false};
TRIAL_OTHER(bvh_naive, bvh, bvh, bvh_hit_naive)
TRIAL_FIRST(first_bvh, b->s = first_bvh_build(&b->m, *(const bool *)how))

/* The first seven are the short table. */
enum { bvh_short = 7, bvh_candidates = 13 };
static const bvh_candidate bvh_candidate_list[bvh_candidates] = {
    {"first, SAH", &first_bvh_trial, {BVH_SAH, 0, 0}, true},
    {"cycling axis", &bvh_trial, {BVH_CYCLE, 4, 1}, false},
    {"median", &bvh_trial, {BVH_MEDIAN, 4, 1}, false},
    {"SAH, bins", &bvh_trial, {BVH_SAH, 8, 0.3}, false},
    {"SAH, boxes naive", &bvh_naive_trial, {BVH_SAH, 8, 0.3}, false},
    {"SAH, spatial", &bvh_trial, {BVH_SPATIAL, 8, 0.3}, false},
    {"Morton", &bvh_trial, {BVH_MORTON, 8, 0.3}, false},
    {"longest axis", &bvh_trial, {BVH_LONGEST, 4, 1}, false},
    {"SAH, sweep", &bvh_trial, {BVH_SAH_SWEEP, 8, 0.3}, false},
    {"bins, leaf 1", &bvh_trial, {BVH_SAH, 1, 1}, false},
    {"bins, leaf 4", &bvh_trial, {BVH_SAH, 4, 0.3}, false},
    {"bins, leaf 16", &bvh_trial, {BVH_SAH, 16, 0.1}, false},
    {"first, middle", &first_bvh_trial, {BVH_SAH, 0, 0}, false}};

static inline void bvh_rows(const bvh_candidate *list, int n, trial_row *row)
{
    for (int i = 0; i < n; i++)
        row[i] = (trial_row){.name = list[i].name, .verbs = list[i].verbs,
                             .how = list[i].verbs->first ? (const void *)&list[i].sah
                                                         : (const void *)&list[i].how};
}

#endif
