/* brute.h: no structure at all (暴力求交), with the verbs of all structures. It is the oracle. */
#ifndef COMPARE_BRUTE_H
#define COMPARE_BRUTE_H

#include "../../09_aabb/items.h"

typedef struct { size_t most_bytes; } brute_options;
typedef struct { items x; } brute;

/* ---------------------------------------------------------------------------------------------- */

static inline bool brute_build(const items *x, brute_options how, brute *out, failure *f)
{
    (void)how, (void)f;
    *out = (brute){*x};
    return true;
}

static inline void brute_free(brute *b) { *b = (brute){{NULL, NULL, 0}}; }

/* Any hit: ends at the first item that is hit; that many tests. */
static inline bool brute_search(const brute *b, ray r, bool any, hit *out, search_work *work)
{
    if (!any && work) work->tests += b->x.n;
    if (!any) return items_hit(&b->x, r, out);
    if (!work) return items_occluded(&b->x, r);
    query q = query_of(r);
    for (size_t i = 0; i < b->x.n; i++) {
        work->tests++;
        if (query_ask(&q, &b->x, (uint32_t)i, true)) return true;
    }
    return false;
}

STRUCTURE_VERBS(brute)

static inline structure_stats brute_stats(const brute *b)
{
    return (structure_stats){.leaves = 1, .references = b->x.n, .items = b->x.n};
}

#endif
