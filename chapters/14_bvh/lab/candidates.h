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

typedef struct { const char *name; const trial_verbs *verbs; bvh_options how; bool sah; }
    bvh_candidate;

/* ---------------------------------------------------------------------------------------------- */

static inline bool bvh_hit_naive(const bvh *b, ray r, hit *out)
{
    return bvh_mesh_hit_naive(&b->mesh, r, out);
}

TRIAL_VERBS(bvh, bvh, bvh_hit, bvh_hit_counted)
TRIAL_OTHER(bvh_naive, bvh, bvh, bvh_hit_naive)
TRIAL_FIRST(first_bvh, b->s = first_bvh_build(&b->m, *(const bool *)how))

/* The first seven are the short table. */
enum { bvh_short = 7, bvh_candidates = 13 };
static const bvh_candidate bvh_candidate_list[bvh_candidates] = {
    {"first, SAH", &first_bvh_trial, {"sah", 0, 0, SIZE_MAX}, true},
    {"cycling axis", &bvh_trial, {"cycle", 4, 1, SIZE_MAX}, false},
    {"median", &bvh_trial, {"median", 4, 1, SIZE_MAX}, false},
    {"SAH, bins", &bvh_trial, {"sah", 8, 0.3, SIZE_MAX}, false},
    {"SAH, boxes naive", &bvh_naive_trial, {"sah", 8, 0.3, SIZE_MAX}, false},
    {"SAH, spatial", &bvh_trial, {"spatial", 8, 0.3, SIZE_MAX}, false},
    {"Morton", &bvh_trial, {"morton", 8, 0.3, SIZE_MAX}, false},
    {"longest axis", &bvh_trial, {"longest", 4, 1, SIZE_MAX}, false},
    {"SAH, sweep", &bvh_trial, {"sweep", 8, 0.3, SIZE_MAX}, false},
    {"bins, leaf 1", &bvh_trial, {"sah", 1, 1, SIZE_MAX}, false},
    {"bins, leaf 4", &bvh_trial, {"sah", 4, 0.3, SIZE_MAX}, false},
    {"bins, leaf 16", &bvh_trial, {"sah", 16, 0.1, SIZE_MAX}, false},
    {"first, middle", &first_bvh_trial, {"sah", 0, 0, SIZE_MAX}, false}};

static inline void bvh_rows(const bvh_candidate *list, int n, trial_row *row)
{
    for (int i = 0; i < n; i++)
        row[i] = (trial_row){.name = list[i].name, .verbs = list[i].verbs,
                             .how = list[i].verbs->first ? (const void *)&list[i].sah
                                                         : (const void *)&list[i].how};
}

#endif
