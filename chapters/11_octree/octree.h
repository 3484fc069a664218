/* octree.h: a cube cut into eight, each part again, while too many items are in it (八叉树, octree).
 *
 *   +----+----+     child c of a cell: bit 0 of c is 1 in its upper half along x, bit 1 along y,
 *   | 2  | 3  |     bit 2 along z. The eight stand in a row, which is one line of the cache.
 *   +----+-+--+
 *   | 0  +-+--+     A cell is a leaf (叶节点) if it holds at most how.leaf items, if it is how.depth
 *   +----+-+--+     cuts deep, or if cutting does not help: see build.h.
 *
 *   octree t;
 *   bool octree_build(&x, octree_defaults, &t, &f)   false: more than most_bytes, or too large
 *   bool octree_hit(&t, r, &h), ..                   the verbs of structure.h (09)
 *
 * The mesh or the scene of x must outlive the tree. In the plane it is a quadtree (四叉树):
 * quadtree.h draws one. The search: the cells along a ray, nearest first, without recursion (遍历).
 *
 *   bool octree_walk(&t, r, any, pad, &h, &work, &trail)
 *       any     ends at the first hit, h is not touched
 *       pad     1: as it must be; 0: naive, loses hits
 *       work    counts what was done; NULL: does not count
 *       trail   notes down the leaves asked, by node number, in order; NULL: does not
 *
 *        m_x   m_y       The three walls through the middle of a cell cut the ray's way in it into
 *    in   |     |  out   at most four pieces. With s the way along the longest axis a of d:
 *    --*--+-----+---*->
 *       00|  01 |  11        s = t |d_a|     wall at w: s = (w - o_k) i_k, i_k = |d_a| / d_k (11.3)
 *
 * Bit k of a child, seen from where the ray comes, is 1 beyond wall k: so children come in rising
 * order, and the real number of child c is c xor (bits of the axes with d_k < 0)         (11.4)
 *
 * The walls of a child are those of its parent -+ size |i_k| / 4: none is computed anew  (11.5)
 *
 * Rounding: wall k may be met anywhere from l_k = m_k - delta |i_k| to h_k = m_k + delta |i_k|
 * (10.1), and the ray may be in all cells to which that leaves a way: child c is passed unless
 *
 *   h_k < in   and c is before wall k,  or
 *   l_k > out  and c is beyond wall k,  or
 *   l_j > h_k  and c is beyond wall j and before wall k                                  (11.6)
 *
 * Twelve comparisons and no branch: one bit a child is left.
 *
 * Boundaries need no care of their own. A ray in a wall, or through a corner where eight cells
 * meet, has walls that cannot be told apart: more bits are left. A ray along an axis has d_k = 0;
 * |i_k| is then 1/eps, no more: that turns the ray by eps, moves it by eps D within the bounds, and
 * delta is 512 of these. So nothing is infinite, and there is no 0 * inf. (From origins beyond
 * 1e290 a product may overflow; comparisons with NaN are false, and the cell is passed.)
 *
 * Sources: A. Glassner, "Space Subdivision for Fast Ray Tracing", IEEE CG&A 4(10), 1984;
 * J. Revelles, C. Ureña, M. Lastra, "An Efficient Parametric Algorithm for Octree Traversal", WSCG
 * 2000.
 */
#ifndef OCTREE_H
#define OCTREE_H

#include "build.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    vec3 inverse;   /* |i_k| of (11.3) */
    vec3 pad;       /* delta |i_k| */
    real way;       /* |d_a| */
    unsigned flip;  /* (11.4) */
} octree_ray;

/* An inner cell: its middle walls and its part of the ray. */
typedef struct {
    vec3 m;
    real in, out, half;  /* half: size of a child / 2 */
    uint32_t first;      /* child 0 */
    unsigned left;       /* children yet to be visited, in the ray's order */
} octree_level;

enum { octree_trail_room = 64 };
typedef struct { uint32_t node[octree_trail_room]; int n; } octree_trail;

/* i_k is 1/eps where d_k is 0 or so small that it does not matter; no NaN, as d is finite. */
static inline octree_ray octree_ray_of(const octree *t, ray r, real pad)
{
    real way = vlargest(r.d), delta = pad * query_delta(r, t->bounds);
    vec3 d = vabs(r.d), i = {way / d.x, way / d.y, way / d.z}, most = {1, 1, 1};
    i = vmin(i, vscale(most, 1 / real_epsilon));
    unsigned flip = (r.d.x < 0 ? 1u : 0) | (r.d.y < 0 ? 2u : 0) | (r.d.z < 0 ? 4u : 0);
    return (octree_ray){i, vscale(i, delta), way, flip};
}

/* s of (11.3), a little before (side -1) or behind (+1): a t below real_smallest has fewer digits,
 * and d may be so large that this shows. The product should not be denormal, which is slow. */
static inline real octree_way(const octree_ray *o, real t, int side)
{
    return (t + (real)side * (real_smallest / real_epsilon)) * o->way;
}

/* Bits of a mask of children from real numbers to the ray's order, and back: c xor flip. Without a
 * branch: where an axis is not flipped, the shift is 0 and all bits stay. */
static inline unsigned octree_flipped(unsigned mask, unsigned flip)
{
    unsigned x = flip & 1, y = flip & 2, z = flip & 4;
    unsigned low_x = x ? 0x55 : 0xff, low_y = y ? 0x33 : 0xff, low_z = z ? 0x0f : 0xff;
    mask = (mask >> x & low_x) | (mask & low_x) << x;
    mask = (mask >> y & low_y) | (mask & low_y) << y;
    return (mask >> z & low_z) | (mask & low_z) << z;
}

/* (11.6). fx: the children far in x, beyond the wall; nx: the near ones. */
fast_inline unsigned octree_passed(const octree_ray *o, vec3 m, real in, real out)
{
    enum { fx = 0xaa, fy = 0xcc, fz = 0xf0, nx = 0x55, ny = 0x33, nz = 0x0f, all = 0xff };
    vec3 l = vsub(m, o->pad), h = vadd(m, o->pad);
    unsigned a = (h.x < in ? fx : all) & (h.y < in ? fy : all) & (h.z < in ? fz : all);
    unsigned b = (l.x > out ? nx : all) & (l.y > out ? ny : all) & (l.z > out ? nz : all);
    unsigned c = (l.x > h.y ? nx | fy : all) & (l.y > h.x ? ny | fx : all)
                 & (l.x > h.z ? nx | fz : all);
    unsigned d = (l.z > h.x ? nz | fx : all) & (l.y > h.z ? ny | fz : all)
                 & (l.z > h.y ? nz | fy : all);
    return a & b & c & d;
}

/* The items of a leaf; true if one of them improved the answer (any: was hit). */
fast_inline bool octree_leaf(const octree *t, octree_node n, query *q, mailbox *seen, bool any,
                             search_work *work)
{
    const uint32_t *i = t->reference + n.first, *end = i + (n.kind & ~octree_is_leaf);
    return mailbox_ask(seen, t->how.mailbox, q, &t->x, i, end, any, work);
}

/* The root, an inner cell; false: the ray misses it. limit: s of the ray's end. */
fast_inline bool octree_root(const octree *t, const octree_ray *o, ray r, real limit,
                             octree_level *out)
{
    real half = t->size / 2;
    vec3 to = vadd(vsub(t->lo, r.o), (vec3){half, half, half});
    vec3 m = {r.d.x < 0 ? -to.x : to.x, r.d.y < 0 ? -to.y : to.y, r.d.z < 0 ? -to.z : to.z};
    m = vmul(m, o->inverse);
    vec3 reach = vadd(vscale(o->inverse, half), o->pad);
    vec3 enter = vsub(m, reach), leave = vadd(m, reach);
    real s0 = real_max(enter.x, real_max(enter.y, real_max(enter.z, octree_way(o, r.tmin, -1))));
    real s1 = real_min(leave.x, real_min(leave.y, real_min(leave.z, limit)));
    if (s0 > s1) return false;
    const octree_node n = t->node[0];
    *out = (octree_level){m, s0, s1, half / 2, n.first, 0};
    out->left = octree_flipped(n.kind, o->flip) & octree_passed(o, m, s0, s1);
    return true;
}

fast_inline bool octree_walk(const octree *t, ray r, bool any, real pad, hit *out,
                             search_work *work, octree_trail *trail)
{
    octree_level stack[octree_most_depth];
    int top = 0;
    if (t->stats.items == 0 || !ray_is_usable(r)) return false;
    query q = query_of(r);
    mailbox seen = mailbox_new();
    const octree_ray o = octree_ray_of(t, r, pad);
    octree_node n = t->node[0];
    if (n.kind & octree_is_leaf) {
        bool found = octree_leaf(t, n, &q, &seen, any, work);
        return any ? found : query_answer(&q, out);
    }

    octree_level c;
    real limit = octree_way(&o, r.tmax, +1);
    if (!octree_root(t, &o, r, limit, &c)) return false;
    if (work) work->nodes++;

    for (;;) {
        /* The next child of the present cell, or of the last one that has any left */
        while (c.left == 0) {
            if (top == 0) return query_answer(&q, out);
            c = stack[--top];
        }
        unsigned k = (unsigned)__builtin_ctz(c.left);
        c.left &= c.left - 1;
        real in = c.in;
        in = real_max(k & 1 ? c.m.x - o.pad.x : in, in);
        in = real_max(k & 2 ? c.m.y - o.pad.y : in, in);
        in = real_max(k & 4 ? c.m.z - o.pad.z : in, in);
        if (in > limit) continue;
        uint32_t at = c.first + (k ^ o.flip);
        n = t->node[at];
        if (n.kind & octree_is_leaf) {
            if (trail && trail->n < octree_trail_room) trail->node[trail->n++] = at;
            if (!octree_leaf(t, n, &q, &seen, any, work)) continue;
            if (any) return true;
            limit = octree_way(&o, q.r.tmax, +1);
            continue;
        }

        /* One level down */
        if (c.left) stack[top++] = c;
        real end = real_min(c.out, limit);
        end = real_min(k & 1 ? end : c.m.x + o.pad.x, end);
        end = real_min(k & 2 ? end : c.m.y + o.pad.y, end);
        end = real_min(k & 4 ? end : c.m.z + o.pad.z, end);
        c.m.x += k & 1 ? c.half * o.inverse.x : -c.half * o.inverse.x;  /* (11.5) */
        c.m.y += k & 2 ? c.half * o.inverse.y : -c.half * o.inverse.y;
        c.m.z += k & 4 ? c.half * o.inverse.z : -c.half * o.inverse.z;
        c.half /= 2, c.in = in, c.out = end, c.first = n.first;
        c.left = octree_flipped(n.kind, o.flip) & octree_passed(&o, c.m, in, end);
        if (work) work->nodes++;
    }
}

fast_inline bool octree_search(const octree *t, ray r, bool any, hit *out, search_work *work)
{
    return octree_walk(t, r, any, 1, out, work, NULL);
}

STRUCTURE_VERBS(octree)

#endif
