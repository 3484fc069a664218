/* structure.h: what all acceleration structures (加速结构) share: verbs, and care.
 *
 * Every structure X of the next chapters has the same verbs, in the same order:
 *
 *   bool X_build(&x, how, &s, &f)       false: it does not fit into how.most_bytes, and f says so
 *   bool X_hit(&s, r, &h)               the very hit (t, u, v, shape) that brute force (07) finds
 *   bool X_occluded(&s, r)              is there any?
 *   bool X_hit_counted(&s, r, &h, &w)   the same, and adds what it took to the search_work w
 *   bool X_occluded_counted(&s, r, &w)
 *   structure_stats X_stats(&s)
 *   void X_free(&s)                     a zeroed one may be freed
 *
 *   STRUCTURE_VERBS(X)                  makes the four that search from one:
 *                                       bool X_search(&s, r, any, &h, &w)
 *                                       any: h is not touched; w: NULL if nobody counts. Where it
 *                                       is always_inline, each of the four is a search of its own
 *   double structure_room(n)            where cuts part nothing: see there
 *   memory_room(&m, &p, used, n, &room, size), memory_fit(..), memory_array(&m, n, size)
 *                                       for arrays of those who build
 *
 * x: what it holds; items.h.
 *
 * A search cuts space into cells, asks the items of each cell that the ray passes, and ends when
 * the next cell begins beyond the best hit. Two things must not go wrong:
 *
 *   1. At equal t the lower index wins (hit.h), so a cell that begins at t = tmax is still asked.
 *   2. Rounding. The ray's t at a cell's side is rounded, the test of an item is rounded: each of
 *      them may place a hit on the other side of a wall. So cells are entered a little early and
 *      left a little late: by query_delta, a length, along every axis                      (10.1)
 *
 *          delta = 512 eps D,    D = the largest |side of the bounds - o| along an axis
 *
 *      A hit that an item reports lies within 256 eps D of the item and of the true ray (14 and 04
 *      say why, and (7.14) and (7.15) for cones and polygons); the planes' own t are right within
 *      4 eps D. The rest is for the building of cells.
 *      (One kind is left out: a polygon whose corners are farther off their plane than 32 eps of
 *      its size, seen edge-on. Its picture may cross itself, and the hit is only within its hull.)
 */
#ifndef AABB_STRUCTURE_H
#define AABB_STRUCTURE_H

#include "../../common/file.h"
#include "../01_ray/hit.h"
#include "aabb.h"

typedef struct {
    size_t nodes;   /* steps: inner nodes, or cells of a grid, passed */
    size_t leaves;  /* leaves, or cells, that were asked */
    size_t empty;   /* of these: with nothing in them */
    size_t tests;   /* items tested */
} search_work;

typedef struct {
    size_t inner, leaves, empty;  /* inner nodes; leaves or cells; of these with nothing in them */
    size_t references;            /* sum over the leaves of the items in them */
    size_t items;                 /* that can be hit at all; references / items: how often cut */
    int depth;                    /* of the deepest leaf; 0: the root is one */
    size_t bytes, peak;           /* held now; the most held while it was built */
} structure_stats;

/* Bytes: allowed, held now, the most held so far. full: something did not fit. */
typedef struct { size_t most, bytes, peak; bool full; } memory;

/* ---------------------------------------------------------------------------------------------- */

/* How often n items may be named in all leaves. Items that lie on top of each other (10^5 copies
 * of a triangle, the fan of a star with 10^4 corners) can be cut for ever, and each cut names most
 * of them once more. Trees share this room out: a cell that is cut gives its parts what it has, in
 * proportion to what they name; one that has no room for that becomes a leaf, once half of all room
 * is gone. Models don't get there. */
static inline double structure_room(size_t n) { return 64 * (double)n + 0x1p22; }

/* wanted: what a cut would name, of its cell's room. */
static inline bool structure_is_full(const structure_stats *s, double wanted, double room)
{
    return wanted > room && 2 * (double)s->references > structure_room(s->items);
}

/* Counts n things of `size` bytes; false: no room for them. */
static inline bool memory_takes(memory *m, size_t n, size_t size)
{
    size_t most = m->most < SIZE_MAX / 2 ? m->most : SIZE_MAX / 2;
    m->full |= n > (most - m->bytes) / size;
    if (m->full) return false;
    m->bytes += n * size;
    if (m->bytes > m->peak) m->peak = m->bytes;
    return true;
}

static inline void memory_gives(memory *m, size_t n, size_t size) { m->bytes -= n * size; }

/* p: the address of a pointer to an array with room for *room things of `size` bytes. It moves to
 * one for n, at a line of the cache; the first `used` stay; for a moment both are held. False:
 * nothing changes. (As bytes: C forbids to write a pointer to one type through that to another.) */
static inline bool memory_fit(memory *m, void *p, size_t used, size_t n, size_t *room, size_t size)
{
    void *old;
    memcpy(&old, p, sizeof old);
    if (!memory_takes(m, n, size)) return false;
    void *now = aligned_alloc(64, (n * size / 64 + 1) * 64);
    m->full |= !now;
    if (now && used) memcpy(now, old, used * size);
    memory_gives(m, now ? *room : n, size);
    if (now) free(old), memcpy(p, &now, sizeof now), *room = n;
    return now;
}

/* Room for n at least, and for half as much again as there was; false if that is not to be had. */
static inline bool memory_room(memory *m, void *p, size_t used, size_t n, size_t *room,
                               size_t size)
{
    size_t more = *room + *room / 2;
    return n <= *room || memory_fit(m, p, used, n > more ? n : more, room, size);
}

/* A new array; NULL: no room. */
static inline void *memory_array(memory *m, size_t n, size_t size)
{
    void *p = NULL;
    return memory_fit(m, &p, 0, n, &(size_t){0}, size) ? p : NULL;
}

/* Says what did not fit, into how many bytes if they are fewer than any machine has; false. */
static inline bool memory_failed(failure *f, const char *what, size_t n, size_t most)
{
    char within[64] = "";
    if (most < SIZE_MAX / 4) snprintf(within, sizeof within, ", %zu bytes allowed", most);
    return failed(f, 1, "%s: no memory for %zu items%s", what, n, within);
}

static inline void memory_drop(memory *m, void *p, size_t room, size_t size)
{
    free(p), memory_gives(m, room, size);
}

/* A NaN, an infinite origin or no direction: such a ray hits nothing, and no search begins. */
static inline bool ray_is_usable(ray r) { return vfinite(r.o) && vfinite(r.d) && !vzero(r.d); }

/* The power of two by which a D outside of 2^+-20 must be divided to get there; else 1. D: the
 * longest component of a direction. */
static inline real direction_scale(real longest)
{
    int e = 0;
    if (longest >= (real)0x1p-20 && longest <= (real)0x1p20) return 1;
    (void)frexp(longest, &e);
    int most = real_is_float ? 100 : 1000;
    return ldexp((real)1, e > most ? most : e < -most ? -most : e);
}

/* (10.1) [scene units]; a little even where everything is 0. */
static inline real query_delta(ray r, aabb all)
{
    vec3 a = vmax(vabs(vsub(r.o, all.lo)), vabs(vsub(all.hi, r.o)));
    return vlargest(a) * (512 * real_epsilon) + real_smallest;
}

#define STRUCTURE_VERBS(X) STRUCTURE_VERBS_OF(X, hit, search_work)
/* NOLINTBEGIN(bugprone-macro-parentheses): a type takes none. */
#define STRUCTURE_VERBS_OF(X, hit_type, work_type)                                               \
    static inline bool X##_hit(const X *s, ray r, hit_type *out)                                 \
    {                                                                                            \
        return X##_search(s, r, false, out, NULL);                                               \
    }                                                                                            \
    static inline bool X##_occluded(const X *s, ray r)                                           \
    {                                                                                            \
        return X##_search(s, r, true, NULL, NULL);                                               \
    }                                                                                            \
    static inline bool X##_hit_counted(const X *s, ray r, hit_type *out, work_type *w)           \
    {                                                                                            \
        return X##_search(s, r, false, out, w);                                                  \
    }                                                                                            \
    static inline bool X##_occluded_counted(const X *s, ray r, work_type *w)                     \
    {                                                                                            \
        return X##_search(s, r, true, NULL, w);                                                  \
    }
/* NOLINTEND(bugprone-macro-parentheses) */

#endif
