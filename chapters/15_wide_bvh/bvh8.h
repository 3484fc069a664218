/* bvh8.h: the bounding volume hierarchy, eight wide (八叉 BVH): eight boxes, or triangles, at once.
 *
 *        node                block               bvh8 w;
 *   low  x x x x x x x x   ax a a a a a a a a    bvh8_build(&x, bvh8_defaults, &w, &f)
 *        y y y y y y y y   ay . . . . . . . .                            false: f says why
 *        z z z z z z z z   az . . . . . . . .    bvh8_hit(&w, r, &h)     the very hit of items_hit
 *   high x x x x x x x x   bx . . . . . . . .    bvh8_occluded(&w, r)    is there any?
 *        y ..              ..                    bvh8_stats(&w)
 *   child 8 numbers        8 numbers             bvh8_free(&w)           a zeroed one may be freed
 *
 *   bvh8_hit_counted(&w, r, &h, &work), bvh8_occluded_counted(&w, r, &work)
 *   bvh8_ask(&w, r, skip, &h, &work)     the four in one (h NULL: any hit; work NULL: not counted),
 *                                        sooner where the caller knows what r can't hit: tree8.h
 *   bvh8_ask_at(&w, &r, skip, &h, &work) of a ray in memory, not written just now: ray8.h says why
 *   bvh8_ask_row(&w, q, n, any)          of n rays: q[k].met, and unless any is enough q[k].h; of
 *                                        few triangles eight or sixteen rays at a time: packet.h
 *
 * An answer is that of brute force bit for bit, in all three dialects of eight.h, though boxes and
 * triangles are looked at in float: float says "surely not", "surely", or "in doubt". Only the hit
 * that is handed out, and what was in doubt, is computed in `real`: ray8.h says how sure is sure.
 * (But for the sign of a zero; and not where 1 / d, or the items' size in lengths of d, is no
 * normal number: d of 1e-310, or of 1e303 for items of 1e-8. There t overflows or vanishes.)
 *
 *   how.leaf, how.width   most triangles in a block [1..8], children of a node [2..8]
 *   how.threads           0: one a core; the tree is the same for any number
 *   how.dialect           EIGHT_PLAIN .. EIGHT_AVX512, at most what the machine has
 *   how.most_bytes        while it is built, about; more: false
 *
 * The items must outlive the tree. Some 50 bytes a triangle. What cannot be hit (a corner that is
 * NaN or infinite, no area) is not in it; coordinates beyond items_most are refused.
 *
 * Source: H. Dammertz, J. Hanika, A. Keller, "Shallow Bounding Volume Hierarchies for Fast SIMD Ray
 * Tracing of Incoherent Rays", EGSR 2008; more on MEASURED.md.
 */
#ifndef WIDE_BVH8_H
#define WIDE_BVH8_H

#include "build.h"
#include "ray8.h"

#define EIGHT_FILE "../../chapters/15_wide_bvh/walk.h"
#include "../../common/numbers/dialects.h"
#define EIGHT_FILE "../../chapters/15_wide_bvh/packet.h"
#include "../../common/numbers/dialects.h"

/* ---------------------------------------------------------------------------------------------- */

fast_inline bool bvh8_ask_at(const bvh8 *w, const ray *r, bvh8_skip skip, hit *out,
                             search_work *work)
{
    return EIGHT_CALL(w->dialect, bvh8_find, w, r, &skip, out, work);
}

fast_inline bool bvh8_ask(const bvh8 *w, ray r, bvh8_skip skip, hit *out, search_work *work)
{
    ray own = {{r.o.x, r.o.y, r.o.z}, r.tmin, {r.d.x, r.d.y, r.d.z}, r.tmax};
    return bvh8_ask_at(w, &own, skip, out, work);
}

fast_inline bool bvh8_search(const bvh8 *w, ray r, bool any, hit *out, search_work *work)
{
    return bvh8_ask(w, r, bvh8_skip_none, any ? NULL : out, work);
}

STRUCTURE_VERBS(bvh8)

static inline void bvh8_ask_row(const bvh8 *w, bvh8_query *q, int n, bool any)
{
    EIGHT_CALL(w->dialect, bvh8_row, w, q, n, any);
}

static inline structure_stats bvh8_stats(const bvh8 *w)
{
    return (structure_stats){.inner = w->nodes, .leaves = w->block ? w->blocks : w->held,
                             .references = w->held, .items = w->held, .depth = w->depth,
                             .bytes = w->room.bytes, .peak = w->room.peak};
}

#endif
