/* bvh8.h: the bounding volume hierarchy, eight wide (八叉 BVH): eight boxes, or eight triangles, at
 * once.
 *
 *        node                block               bvh8 w;
 *   low  x x x x x x x x   ax a a a a a a a a    bvh8_build(&x, bvh8_defaults, &w, &f)
 *        y y y y y y y y   ay . . . . . . . .                            false: f says why
 *        z z z z z z z z   az . . . . . . . .    bvh8_hit(&w, r, &h)     the very hit of items_hit
 *   high x x x x x x x x   bx . . . . . . . .    bvh8_occluded(&w, r)    is there any?
 *        y ..              ..                    bvh8_stats(&w)
 *   child 8 numbers        8 numbers             bvh8_free(&w)           a zeroed one may be freed
 *
 *   bvh8_hit_but(&w, r, skip, &h), bvh8_occluded_but(&w, r, skip)    the same answers, sooner,
 *                                    where the caller knows triangles that r can't hit: tree8.h
 *   bvh8_hit_counted(&w, r, &h, &work), bvh8_occluded_counted(&w, r, &work)
 *   bvh8_hit_leaky(&w, r, &h), bvh8_occluded_leaky(&w, r)     all in float, nothing paid for: the
 *                                    speed of cracks. Triangles only; u, v, t have six digits
 *
 * An answer is that of brute force bit for bit, in all three dialects of eight.h, though boxes and
 * triangles are looked at in float: float says "surely not", "surely", or "in doubt". Only the hit
 * that is handed out, and what was in doubt, is computed in `real`: ray8.h says how sure is sure.
 *
 *   how.leaf_cost     of a block, where a node costs 1          how.shape_cost   of one shape
 *                     [0.001..1000] both
 *   how.leaf          the binary tree below: down to so many items [1..8]
 *   how.bins          where it may be cut [4..32]
 *   how.width         children a node [2..8]
 *   how.most_bytes    while it is built, about; more: false
 *   how.threads       0: one a core; the tree is the same for any number
 *   how.dialect       EIGHT_PLAIN .. EIGHT_AVX512, at most what the machine has
 *
 * The items must outlive the tree. Some 50 bytes a triangle. What cannot be hit (a corner that is
 * NaN or infinite, no area) is not in it; coordinates beyond items_most are refused. A search needs
 * 512 places of a stack: 7 a level, and no tree is deeper than 64.
 *
 * Sources: H. Dammertz, J. Hanika, A. Keller, "Shallow Bounding Volume Hierarchies for Fast SIMD
 * Ray Tracing of Incoherent Rays", EGSR 2008; I. Wald, C. Benthin, S. Boulos, "Getting Rid of
 * Packets", IRT 2008; I. Wald et al., "Embree: A Kernel Framework for Efficient CPU Ray Tracing",
 * SIGGRAPH 2014.
 */
#ifndef WIDE_BVH8_H
#define WIDE_BVH8_H

#include "collapse.h"
#include "search.h"

/* ---------------------------------------------------------------------------------------------- */

#if EIGHT_X86
#define BVH8_CALL(verb, ...)                                                                     \
    switch (w->dialect) {                                                                        \
    case EIGHT_AVX512: return verb##_2(__VA_ARGS__);                                             \
    case EIGHT_AVX2: return verb##_1(__VA_ARGS__);                                               \
    default: return verb##_0(__VA_ARGS__);                                                       \
    }
#else
#define BVH8_CALL(verb, ...) return verb##_0(__VA_ARGS__);
#endif

/* Field by field: what is copied as a whole right after it was written waits for all of it. */
static inline ray bvh8_own(const ray *r)
{
    return (ray){{r->o.x, r->o.y, r->o.z}, r->tmin, {r->d.x, r->d.y, r->d.z}, r->tmax};
}

__attribute__((always_inline))
static inline bool bvh8_hit_but(const bvh8 *w, ray r, bvh8_skip skip, hit *out)
{
    ray own = bvh8_own(&r);
    BVH8_CALL(bvh8_closest, w, &own, &skip, out)
}

__attribute__((always_inline))
static inline bool bvh8_occluded_but(const bvh8 *w, ray r, bvh8_skip skip)
{
    ray own = bvh8_own(&r);
    BVH8_CALL(bvh8_any, w, &own, &skip)
}

static inline bool bvh8_hit(const bvh8 *w, ray r, hit *out)
{
    return bvh8_hit_but(w, r, bvh8_skip_none, out);
}

static inline bool bvh8_occluded(const bvh8 *w, ray r)
{
    return bvh8_occluded_but(w, r, bvh8_skip_none);
}

static inline bool bvh8_hit_leaky(const bvh8 *w, ray r, hit *out)
{
    BVH8_CALL(bvh8_closest_leaky, w, &r, out)
}

static inline bool bvh8_occluded_leaky(const bvh8 *w, ray r) { BVH8_CALL(bvh8_any_leaky, w, &r) }

static inline bool bvh8_hit_counted(const bvh8 *w, ray r, hit *out, search_work *work)
{
    BVH8_CALL(bvh8_counted, w, &r, out, false, work)
}

static inline bool bvh8_occluded_counted(const bvh8 *w, ray r, search_work *work)
{
    BVH8_CALL(bvh8_counted, w, &r, NULL, true, work)
}

static inline structure_stats bvh8_stats(const bvh8 *w)
{
    return (structure_stats){.inner = w->nodes, .leaves = w->blocks, .references = w->held,
                             .items = w->held, .depth = w->depth, .bytes = w->bytes,
                             .peak = w->peak};
}

#endif
