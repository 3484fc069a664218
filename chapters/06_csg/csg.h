/* csg.h: what a ray meets of solids made from solids: constructive solid geometry (构造实体几何).
 *
 *        +        the ray asks A for its spans, then B, and makes A - B of them; then C, and the
 *      /   \      union of both. Lists lie one behind the other; two that are joined give way to
 *     -     C     what they make:
 *   /   \
 *  A     B           [A]   [A][B]   [A - B]   [A - B][C]   [(A - B) + C]
 *
 *   csg_hit(&c, r, &h)           the first crossing with t in [tmin, tmax]; c by csg_build, tree.h
 *   csg_solid_of(&c, h)          number of the solid whose surface was hit
 *   csg_normal(&c, r, h)         unit, out of the whole: turned where something was cut away
 *   csg_occluded(&c, r)          whether there is a crossing in [tmin, tmax]
 *   n = csg_spans(&c, r, list)   all spans of the line, as in spans.h; list: room for 2 c.room
 *
 * h.shape is the crossing's surface: see spans.h. Two things spare a ray work:
 *   - it skips a node whose bound it misses within [tmin, tmax], but for csg_options.no_bounds;
 *   - what is cut from nothing, or shared with nothing, is nothing: the right operand is skipped.
 * Within [tmin, tmax] the spans are the same with and without, bit for bit.
 *
 * A ray of a tree with n crossings at most takes room for 2 n of them, and a frame for each level:
 * on the stack, if the tree is not large. Cost: O(nodes + depth times crossings).
 *
 *   input                                       answer
 *   d = 0; a NaN or an infinity in o or d       no spans, no hit
 *   a NaN in tmin or tmax; tmin > tmax          no hit
 *   a segment that lies wholly inside           no hit: it crosses nothing
 *   a whole without end                         its spans reach to inf; there is no hit there
 *   any interval                                closed, and cut last: what lies before tmin still
 *                                               tells whether tmin is inside
 */
#ifndef CSG_H
#define CSG_H

#include "tree.h"

enum { csg_few = 64, csg_some = 4096 };  /* levels, crossings: what the stack holds of a ray */
typedef struct { uint32_t node; bool right; size_t start, middle; } csg_frame;

/* What rays of this thread did: for whoever wants to count. */
static _Thread_local struct { size_t bounds, solids; } csg_asked;

/* ---------------------------------------------------------------------------------------------- */

typedef size_t csg_leaf_function(const csg_solid *, ray, uint32_t first, csg_crossing *out);
typedef size_t csg_merge_function(csg_operation, const csg_crossing *a, size_t na,
                                  const csg_crossing *b, size_t nb, csg_crossing *out);

/* a at `start`, b behind it up to n: what they make takes the place of both; how far it reaches. */
fast_inline size_t csg_join(const csg_node *x, csg_frame f, size_t n, csg_crossing *list,
                            csg_merge_function *merge)
{
    size_t na = f.middle - f.start, nb = n - f.middle;
    if (nb == 0) return x->what == CSG_INTERSECTION ? f.start : n;
    if (na == 0) return n;  /* only a union comes so far: csg_walk */
    size_t m = merge(x->what, list + f.start, na, list + f.middle, nb, list + n);
    memmove(list + f.start, list + n, m * sizeof *list);
    return f.start + m;
}

/* The spans of the whole, right where r.tmin <= t <= r.tmax. frame: room for c->depth + 1. */
fast_inline size_t csg_walk(const csg *c, ray r, csg_frame *frame, csg_crossing *list,
                            csg_leaf_function *leaf, csg_merge_function *merge)
{
    if (!vfinite(r.o) || !vfinite(r.d) || vzero(r.d) || c->nodes == 0) return 0;
    csg_line line = csg_line_of(r);
    size_t n = 0, f = 0;
    for (uint32_t i = 0; i < c->nodes;) {
        const csg_node *x = &c->node[i];
        /* 1. The node's own part: nothing, a solid's spans, or first those of its left operand */
        csg_asked.bounds += !c->no_bounds;
        if (x->empty || (!c->no_bounds && !csg_bound_meets(&x->bound, &line))) i = x->end;
        else if (x->what != CSG_SOLID) {
            frame[f++] = (csg_frame){i++, false, n, n};
            continue;
        } else {
            csg_asked.solids++;
            n += leaf(&c->solid[x->solid], r, c->first[x->solid], list + n);
            i++;
        }
        /* 2. An operand is done: with the left one begins the right one, if it still matters; with
         *    the right one the parent is done, too */
        while (f > 0) {
            csg_frame *top = &frame[f - 1];
            const csg_node *parent = &c->node[top->node];
            bool was_right = top->right;
            top->right = true;
            if (was_right) n = csg_join(parent, *top, n, list, merge), f--;
            else if (n == top->start && parent->what != CSG_UNION) i = parent->end, f--;
            else {
                top->middle = n;
                break;
            }
        }
    }
    return n;
}

static inline size_t csg_spans(const csg *c, ray r, csg_crossing *list)
{
    csg_frame *frame = allocate(c->depth + 1, sizeof *frame);
    r.tmin = -real_infinity, r.tmax = real_infinity;
    size_t n = csg_walk(c, r, frame, list, csg_solid_crossings, spans_merge);
    free(frame);
    return n;
}

/* The interval cuts only here, when all is merged. */
static inline bool csg_first(const csg_crossing *list, size_t n, ray r, hit *out)
{
    for (size_t i = 0; i < n; i++) {
        if (!ray_covers(r, list[i].t) || !isfinite(list[i].t)) continue;
        *out = (hit){list[i].t, 0, 0, list[i].surface};
        return true;
    }
    return false;
}

/* Of a ray of any tree. No calloc: a ray meets little of a large one. */
__attribute__((noinline))
static void *csg_memory(size_t n, size_t size)
{
    void *p = n < SIZE_MAX / size ? malloc(n * size) : NULL;
    if (!p) die(1, "no memory for %zu times %zu bytes of a ray", n, size);
    return p;
}

/* csg_hit, if `leaf` says what a solid's crossings are, and `merge` how two lists become one: for
 * those who want to try others. */
fast_inline bool csg_hit_by(const csg *c, ray r, csg_leaf_function *leaf,
                            csg_merge_function *merge, hit *out)
{
    csg_frame few[csg_few], *frame = few;
    csg_crossing some[csg_some], *list = some;
    if (c->depth >= csg_few) frame = csg_memory(c->depth + 1, sizeof *frame);
    if (2 * c->room > csg_some) list = csg_memory(2 * c->room, sizeof *list);
    bool is = csg_first(list, csg_walk(c, r, frame, list, leaf, merge), r, out);
    if (frame != few) free(frame);
    if (list != some) free(list);
    return is;
}

static inline bool csg_hit(const csg *c, ray r, hit *out)
{
    return csg_hit_by(c, r, csg_solid_crossings, spans_merge, out);
}

static inline bool csg_occluded(const csg *c, ray r) { return csg_hit(c, r, &(hit){0}); }

/* The last solid whose first surface is not behind this one. */
static inline size_t csg_solid_of(const csg *c, hit h)
{
    size_t lo = 0, hi = c->solids;
    while (hi - lo > 1) {
        size_t middle = lo + (hi - lo) / 2;
        if (c->first[middle] <= h.shape / 2) lo = middle;
        else hi = middle;
    }
    return lo;
}

static inline vec3 csg_normal(const csg *c, ray r, hit h)
{
    size_t i = csg_solid_of(c, h), face = h.shape / 2 - c->first[i];
    vec3 n = csg_solid_normal(&c->solid[i], face, ray_at(r, h.t));
    return h.shape % 2 ? vneg(n) : n;
}

#endif
