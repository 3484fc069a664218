/* variants.h: two other ways to walk, with the signature of octree_hit.
 *
 *   octree_hit_slabs(&t, r, &h)     the slab test (09) for every child that is not empty; those met
 *                                   go on a stack, the farthest first: simple, and the same answers
 *   octree_hit_textbook(&t, r, &h)  by Revelles et al., as often copied: loses hits
 *
 * The textbook's walk carries the six t at which the ray crosses the planes of a cell, halves them
 * for the children, and goes from child to child by the smallest t of exit. It breaks on
 *
 *   rays along an axis      (lo - o) / d is +-inf, or NaN for 0/0 if o is in the plane; and halving
 *                           (-inf + inf) / 2 is NaN: comparisons fail, and the walk goes astray
 *                           (the paper treats d_k = 0 apart; copies tend to leave that out)
 *   rays in a wall, rays    "first child" and "next child" are chosen by comparisons of equal or
 *   through corners         nearly equal t: it takes one of the cells that share the place, and the
 *                           item may be in another
 *   hits beyond the cell    the first leaf in which anything is hit ends the search; but an item
 *                           that reaches out of its cell may be hit far behind, with others before
 *
 * Source: J. Revelles, C. Urena, M. Lastra, "An Efficient Parametric Algorithm for Octree
 * Traversal", WSCG 2000, with its tables of the first and of the next child.
 */
#ifndef OCTREE_VARIANTS_H
#define OCTREE_VARIANTS_H

#include "../walk.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct { uint32_t node; vec3 lo; real size, in; } octree_waiting;

static inline bool octree_hit_slabs(const octree *t, ray r, hit *out)
{
    octree_waiting stack[7 * octree_most_depth + 1];
    int top = 0;
    if (t->items == 0 || !ray_is_usable(r)) return false;
    query q = query_of(r);
    mailbox seen = mailbox_new();
    const octree_ray o = octree_ray_of(t, r, 1);
    real first = octree_way(&o, r.tmin, -1), limit = octree_way(&o, r.tmax, +1);
    stack[top++] = (octree_waiting){0, vsub(t->lo, r.o), t->size, first};
    while (top > 0) {
        octree_waiting c = stack[--top];
        octree_node n = t->node[c.node];
        if (c.in > limit) continue;
        if (n.kind & octree_is_leaf) {
            octree_leaf(t, n, &q, &seen, false, NULL);
            limit = octree_way(&o, q.r.tmax, +1);
            continue;
        }
        real half = c.size / 2;
        for (unsigned k = 8; k-- > 0;) {  /* the farthest first: it comes up last */
            unsigned i = k ^ o.flip;
            if (!(n.kind >> i & 1)) continue;
            vec3 lo = {c.lo.x + (i & 1 ? half : 0), c.lo.y + (i & 2 ? half : 0),
                       c.lo.z + (i & 4 ? half : 0)};
            vec3 near = {o.flip & 1 ? -lo.x - half : lo.x, o.flip & 2 ? -lo.y - half : lo.y,
                         o.flip & 4 ? -lo.z - half : lo.z};
            vec3 far = vadd(near, (vec3){half, half, half});
            vec3 s0 = vsub(vmul(near, o.inverse), o.pad);
            vec3 s1 = vadd(vmul(far, o.inverse), o.pad);
            real in = real_max(s0.x, real_max(s0.y, real_max(s0.z, first)));
            real leave = real_min(s1.x, real_min(s1.y, real_min(s1.z, limit)));
            if (!(in > leave)) stack[top++] = (octree_waiting){n.first + i, lo, half, in};
        }
    }
    return query_answer(&q, out);
}

/* ---------------------------------------------------------------------------------------------- */

/* Where the recursion of the textbook stands: t of the cell's six planes. */
typedef struct { const octree *t; query q; mailbox seen; unsigned flip; } textbook_walk;

/* The first child, by the plane through which the ray enters, that of the largest t0. */
static inline unsigned textbook_first(vec3 t0, vec3 tm)
{
    if (t0.x > t0.y && t0.x > t0.z) return (tm.y < t0.x ? 2u : 0) | (tm.z < t0.x ? 4u : 0);
    if (t0.y > t0.z) return (tm.x < t0.y ? 1u : 0) | (tm.z < t0.y ? 4u : 0);
    return (tm.x < t0.z ? 1u : 0) | (tm.y < t0.z ? 2u : 0);
}

/* The next: the child behind the plane of the smallest t1; 8: the ray leaves the parent. */
static inline unsigned textbook_next(unsigned c, vec3 t1)
{
    unsigned k = t1.x < t1.y ? (t1.x < t1.z ? 1 : 4) : t1.y < t1.z ? 2 : 4;
    return c & k ? 8 : c | k;
}

static inline bool textbook_cell(textbook_walk *s, octree_node n, vec3 t0, vec3 t1)
{
    if (t1.x < 0 || t1.y < 0 || t1.z < 0 || n.kind == 0) return false;
    if (n.kind & octree_is_leaf) return octree_leaf(s->t, n, &s->q, &s->seen, false, NULL);
    vec3 tm = vscale(vadd(t0, t1), 0.5);
    for (unsigned c = textbook_first(t0, tm); c < 8;) {
        vec3 c0 = {c & 1 ? tm.x : t0.x, c & 2 ? tm.y : t0.y, c & 4 ? tm.z : t0.z};
        vec3 c1 = {c & 1 ? t1.x : tm.x, c & 2 ? t1.y : tm.y, c & 4 ? t1.z : tm.z};
        if (textbook_cell(s, s->t->node[n.first + (c ^ s->flip)], c0, c1)) return true;
        c = textbook_next(c, c1);
    }
    return false;
}

/* Naive: see above. Octahedron of corners at multiples of 1/8: along axes all hits are wrong, of
 * rays at corners one in five. */
static inline bool octree_hit_textbook(const octree *t, ray r, hit *out)
{
    textbook_walk s = {t, query_of(r), mailbox_new(), 0};
    vec3 lo = vsub(t->lo, r.o), hi = vadd(lo, (vec3){t->size, t->size, t->size}), d = r.d;
    if (t->items == 0) return false;
    for (int k = 0; k < 3; k++) {  /* mirrored, so that all d are positive */
        real *l = (real *)&lo + k, *h = (real *)&hi + k, *a = (real *)&d + k, swap = *l;
        if (*a < 0) *l = -*h, *h = -swap, *a = -*a, s.flip |= 1u << k;
    }
    vec3 t0 = {lo.x / d.x, lo.y / d.y, lo.z / d.z}, t1 = {hi.x / d.x, hi.y / d.y, hi.z / d.z};
    if (real_max(t0.x, real_max(t0.y, t0.z)) < real_min(t1.x, real_min(t1.y, t1.z)))
        textbook_cell(&s, t->node[0], t0, t1);
    return query_answer(&s.q, out);
}

#endif
