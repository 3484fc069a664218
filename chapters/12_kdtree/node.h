/* node.h: the node of a k-d tree, 8 bytes, and when a ray passes its plane.
 *
 *   kd_node { plane | first, bits }
 *       bits & 3 = 0, 1, 2   inner node (中间节点): cut at `plane` across axis x, y, z
 *       bits & 3 = 3         leaf (叶节点): items first .. first + kd_count(n) - 1
 *
 *   kd_lower(n)              number of the child (子节点) below the plane; the one above is the next
 *   kd_full(n, child)        child 0 (below) or 1 (above): is there anything in it? So a search
 *                            need not look into empty cells, and they are most of those it passes
 *
 *   kd_ray_of(r, &frame, &box, pads, &q)       prepares the ray once; pads: 1, or 0: no delta
 *   limit = kd_ray_limit(&q, t)                t as a float that is not less, in units of q
 *
 * Planes are floats whatever `real` is: each plane is chosen among floats, so it is the very plane
 * that the items were sorted by, not a rounded one. Far from 0 floats are too coarse, and beyond
 * 1e38 there are none; so the tree has coordinates of its own, in which its box is about 1 large
 * and not far from 0 (frame.h). Where it already is, they are those of the scene.
 *
 * The t of a plane, and why no rounding loses a hit. The plane is passed not at one t but within
 * [t0, t1]: t0 as seen from an origin moved forwards by delta, t1 from one moved back (12.6):
 *
 *         o - delta   o   o + delta             plane      t0 = (plane - (o + delta)) / d
 *        -----+-------+-------+-------- ... -----|---      t1 = (plane - (o - delta)) / d
 *
 * So cells are larger by delta on each side, and a hit that rounding has carried over a wall is
 * still found on the side where its item is. delta = 2^-21 D + query_delta (10.1); D: from o to the
 * farthest side of the tree. The first term pays for float: plane - o and 1 / d move the plane by
 * 2^-24 D each, at most; rounding the product keeps the order of two t. (2^-24 D is too little.)
 *
 *   d = 0    1 / d is infinite: t0 = t1 = +-infinity, the side where o is; within delta of the
 *            plane t0 = -infinity, t1 = infinity, or a NaN that the comparisons drop: both sides
 *   far      o beyond all floats: one of the two is a NaN, and nothing is left out on that side
 */
#ifndef KDTREE_NODE_H
#define KDTREE_NODE_H

#include "../../common/numbers/float_round.h"
#include "../09_aabb/frame.h"
#include "../09_aabb/items.h"

typedef struct { union { float plane; uint32_t first; }; uint32_t bits; } kd_node;
typedef struct { float lo[3], hi[3]; } kd_box;

/* By axis. second[k]: 1 if the ray meets the upper child first, else 0. */
typedef struct {
    float o_near[3], o_far[3], inverse[3];
    size_t second[3];
    real unit, scale;  /* t of kd_ray = t * unit * scale: both powers of two */
    real slack;        /* t is compared with so much to spare */
    float enter, exit; /* the part of the ray in the box of the tree; none if enter > exit */
} kd_ray;

_Static_assert(sizeof(kd_node) == 8, "eight nodes fill a line of the cache");

/* ---------------------------------------------------------------------------------------------- */

/* An inner node: two bits for the axis, two for what is full, the rest numbers the pair of
 * children. A leaf: two bits, and how many items. */
static inline kd_node kd_inner(float at, int axis, size_t lower, bool below, bool above)
{
    return (kd_node){.plane = at, .bits = (uint32_t)(lower / 2) << 4 | (uint32_t)above << 3
                                             | (uint32_t)below << 2 | (uint32_t)axis};
}

static inline kd_node kd_leaf_node(size_t first, size_t n)
{
    return (kd_node){.first = (uint32_t)first, .bits = (uint32_t)n << 2 | 3};
}

static inline bool kd_is_leaf(kd_node n) { return (n.bits & 3) == 3; }
static inline int kd_axis(kd_node n) { return (int)(n.bits & 3); }
static inline uint32_t kd_lower(kd_node n) { return n.bits >> 4 << 1; }
static inline bool kd_full(kd_node n, size_t child) { return n.bits >> (2 + child) & 1; }
static inline uint32_t kd_count(kd_node n) { return n.bits >> 2; }

/* Half the surface. 0 if the box is empty. */
static inline double kd_area(const kd_box *b)
{
    double x = (double)b->hi[0] - (double)b->lo[0], y = (double)b->hi[1] - (double)b->lo[1];
    double z = (double)b->hi[2] - (double)b->lo[2];
    return x >= 0 ? x * y + y * z + z * x : 0;
}

/* ---------------------------------------------------------------------------------------------- */

static inline float kd_ray_limit(const kd_ray *q, real t)
{
    real x = t * q->unit * q->scale + q->slack;
    float f = (float)x;
    return (real)f >= x ? f : float_beyond(x);
}

/* Also the part of the ray in the box, as in 09, with near and far planes seen from two origins.
 * Each comparison keeps its second argument against a NaN. Written where it is used: a copy of what
 * has just been stored number by number would wait for it, 15 ns a ray. */
fast_inline void kd_ray_of(ray r, const aabb_frame *frame, const kd_box *box, int pads, kd_ray *q)
{
    vec3 o = frame_into(frame, r.o);
    real reach = 0;
    for (int k = 0; k < 3; k++) {
        reach = real_max(fabs((real)box->lo[k] - vaxis(o, k)), reach);
        reach = real_max(fabs((real)box->hi[k] - vaxis(o, k)), reach);
    }
    real delta = reach * ((real)0x1p-21 + 512 * real_epsilon) + (real)0x1p-100;  /* (12.6) */
    q->unit = direction_scale(vlargest(r.d)), q->scale = frame->scale;
    /* t of hits below real_smallest has fewer digits than eps says. 2^-100 keeps a tmin of 0 away
     * from the numbers below FLT_MIN, with which processors are slow. */
    q->slack = real_smallest * q->unit * q->scale + (real)0x1p-100;
    float enter = -kd_ray_limit(q, -r.tmin), exit = kd_ray_limit(q, r.tmax);
    for (int k = 0; k < 3; k++) {
        float i = (float)(q->unit / vaxis(r.d, k));
        float up = pads ? float_beyond(vaxis(o, k) + delta) : (float)vaxis(o, k);
        float down = pads ? -float_beyond(delta - vaxis(o, k)) : up;
        float o_near = i < 0 ? down : up, o_far = i < 0 ? up : down;
        enter = float_max(((i < 0 ? box->hi[k] : box->lo[k]) - o_near) * i, enter);
        exit = float_min(((i < 0 ? box->lo[k] : box->hi[k]) - o_far) * i, exit);
        q->o_near[k] = o_near, q->o_far[k] = o_far, q->inverse[k] = i, q->second[k] = i < 0;
    }
    q->enter = enter, q->exit = exit;
}

#endif
