/* variants.h: the textbook's walk, and ours without delta, with the signature of octree_hit.
 *
 *   octree_hit_textbook(&t, r, &h)  by Revelles et al., as often copied: loses hits
 *   octree_hit_unpadded(&t, r, &h)  loses them, too
 *
 * The textbook carries the six t at which the ray crosses the planes of a cell, halves them
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

#include "../octree.h"

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
    if (t->stats.items == 0) return false;
    for (int k = 0; k < 3; k++) {  /* mirrored, so that all d are positive */
        real *l = (real *)&lo + k, *h = (real *)&hi + k, *a = (real *)&d + k, swap = *l;
        if (*a < 0) *l = -*h, *h = -swap, *a = -*a, s.flip |= 1u << k;
    }
    vec3 t0 = {lo.x / d.x, lo.y / d.y, lo.z / d.z}, t1 = {hi.x / d.x, hi.y / d.y, hi.z / d.z};
    if (real_max(t0.x, real_max(t0.y, t0.z)) < real_min(t1.x, real_min(t1.y, t1.z)))
        textbook_cell(&s, t->node[0], t0, t1);
    return query_answer(&s.q, out);
}

/* Naive: nothing in advance for rounding. A ray in a wall between two cells is told to be in one of
 * them, and the item that it hits may have been found to be in the other. */
static inline bool octree_hit_unpadded(const octree *t, ray r, hit *out)
{
    return octree_walk(t, r, false, 0, out, NULL, NULL);
}

#endif
