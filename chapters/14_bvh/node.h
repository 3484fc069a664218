/* node.h: the node of the tree, 32 bytes, and the test of a ray against its box (包围盒).
 *
 *   bvh_box { low[3], -, minus_high[3], - }     eight floats (eight.h), of which two are spare: in
 *   bvh_node { .., first, .., count }           a node and an item, two whole numbers lie there
 *       count = 0    inner node (中间节点): its children (子节点) are nodes first and first + 1
 *       count > 0    leaf (叶节点): its items are number first .. first + count - 1
 *   bvh_item { .., index, .. }                  what a tree is built of
 *
 * The high sides have their sign turned, so what is around two boxes is one minimum, of all eight
 * at once; and that is most of what building does.
 *
 *   box_add(&a, &b)             a grows to hold b. Of both only the boxes count: a's two numbers
 *                               are lost
 *   box_numbered(&a, i, n)      the box with these two
 *   box_high(&a, axis)          its high side, with its own sign
 *
 * The box is in float whatever `real` is, rounded outwards, so that it holds what it should hold.
 * Two siblings stand side by side: 64 bytes, one line of the cache, one step of the search.
 *
 *   box_ray q = box_ray_of(r, &root, NULL)    prepares the ray once: origin and 1 / D, in float
 *   box_ray_owing(r, &root, more)             the same; its items owe so much more (16)
 *   box_ray_naive(r, &root, NULL)             the same without what follows: loses hits
 *   limit = box_ray_limit(&q, t)              t as a float, for comparing with t_enter
 *   enter = box_enter(&box, &q, limit, &exit) the part [enter, exit] of [tmin, limit]       (14.2)
 *   !(enter > exit)                           the ray meets the box; NaN throws no box away
 *
 * Why nothing is lost though all is rounded to float: all errors are paid for in advance, once a
 * ray. The near planes are seen from an origin moved towards them by delta, the far planes from
 * one moved away (14.3):
 *
 *        o      near                far        near: t = (b - (o + delta)) / d   too small
 *        +--->---|-------------------|-->      far:  t = (b - (o - delta)) / d   too large
 *      o-delta o+delta   (d > 0; if d < 0 the signs change)
 *
 *   1. b - o and 1 / d are two roundings: t is off as if the plane were moved by 2 u |b - o|, u =
 *      2^-24; that of the product keeps the order of two t. D, the largest |b - o| of the whole
 *      tree, bounds it: 2 u D is enough, u D is not. 2^-21 D = 8 u D is taken.
 *   2. What is in the box is tested in `real`, with errors of its own: the watertight test of 04
 *      moves corners by up to 3 eps D, and t by up to 140 eps D / |d|, since its weights are right
 *      to 65 eps. 256 eps D covers both.
 *   3. o + delta is rounded up, o - delta down, by one float more than the sum needs. Far out,
 *      where floats are farther apart than delta, this is what keeps the two apart.
 *   4. Products that underflow are off by 2^-150. d is scaled so that 1 / d >= 2^-21, and then
 *      delta >= 2^-100 moves t by 2^-121 or more. Where 1 / d overflows, the ray moves less than
 *      delta along that axis within the whole tree, so +-infinity is right, as it is for d = 0.
 *      0 * infinity is a NaN, which the comparisons drop: the plane itself belongs to the box.
 *
 * Sources: A. Williams, S. Barrus, R. K. Morley, P. Shirley, "An Efficient and Robust Ray-Box
 * Intersection Algorithm", JGT 10(1), 2005 (the sign chooses the plane); T. Ize, "Robust BVH Ray
 * Traversal", JCGT 2(2), 2013 (rounding makes a search miss; ours pays per ray, not per box).
 */
#ifndef BVH_NODE_H
#define BVH_NODE_H

#include "../09_aabb/structure.h"
#include "../../common/numbers/eight.h"
#include "../../common/numbers/float_round.h"
#include <stddef.h>
#include <stdint.h>
#include <string.h>

typedef union {
    eight_at all;
    float side[8];
    struct {
        float low[3];
        union { uint32_t first, index; };
        float minus_high[3];
        uint32_t count;
    };
} bvh_box;
typedef bvh_box bvh_node;
typedef bvh_box bvh_item;

/* near[k], far[k]: which of the eight sides a ray that moves along axis k meets first, and last. An
 * axis along which it goes down is seen in a mirror: there it goes up, and low is minus_high. */
typedef struct {
    float o_near[3], o_far[3];  /* o + delta and delta - o, of (14.3) */
    float inverse[3];           /* 1 / |d| */
    size_t near[3], far[3];
    real scale;   /* t of box_ray = scale * t of the ray, a power of two */
    real slack;   /* t is compared with so much to spare */
    float tmin;   /* rounded down */
} box_ray;

_Static_assert(sizeof(bvh_node) == 32, "two nodes fill one line of the cache");

/* ---------------------------------------------------------------------------------------------- */

static inline bvh_box box_empty(void) { return (bvh_box){.all = EIGHT_ALL(INFINITY)}; }
static inline float box_high(const bvh_box *b, int axis) { return -b->minus_high[axis]; }

static inline void box_add(bvh_box *a, const bvh_box *b)
{
    a->all = EIGHT_LOOP(eight_min, b->all, a->all);
}

/* Lane by lane: what is read as a whole right after a part was written waits for that. */
static inline bvh_box box_numbered(const bvh_box *b, size_t first, size_t count)
{
    eight_count lanes = (eight_count)b->all;
    lanes[3] = (uint32_t)first, lanes[7] = (uint32_t)count;
    return (bvh_box){.all = (eight)lanes};
}

static inline bvh_box box_between(vec3 lo, vec3 hi)
{
    return (bvh_box){.low = {float_below(lo.x), float_below(lo.y), float_below(lo.z)},
                     .minus_high = {float_below(-hi.x), float_below(-hi.y), float_below(-hi.z)}};
}

/* Half of its surface: in double, so that no float box overflows it. 0 if empty. */
static inline double box_area(const bvh_box *b)
{
    double x = -(double)b->minus_high[0] - (double)b->low[0];
    double y = -(double)b->minus_high[1] - (double)b->low[1];
    double z = -(double)b->minus_high[2] - (double)b->low[2];
    return x >= 0 ? x * y + y * z + z * x : 0;
}

/* What two boxes share; false if nothing. */
static inline bool box_shared(const bvh_box *a, const bvh_box *b, bvh_box *out)
{
    out->all = EIGHT_LOOP(eight_max, a->all, b->all);
    for (int k = 0; k < 3; k++)
        if (!(out->low[k] <= box_high(out, k))) return false;
    return true;
}

/* Half the surface of that. */
static inline double box_shared_area(const bvh_box *a, const bvh_box *b)
{
    bvh_box c;
    return box_shared(a, b, &c) ? box_area(&c) : 0;
}

/* Largest distance along an axis between o and a plane of the box. */
static inline real box_reach(const bvh_box *b, vec3 o)
{
    real reach = 0;
    for (int k = 0; k < 3; k++) {
        reach = real_max(reach, fabs((real)b->low[k] - vaxis(o, k)));
        reach = real_max(reach, fabs((real)box_high(b, k) - vaxis(o, k)));
    }
    return reach;
}

/* low, high: from where the low planes of axis k are seen, and the high ones in the mirror. */
static inline void box_ray_axis(box_ray *q, int k, float low, float high, float inverse)
{
    bool down = inverse < 0;
    q->inverse[k] = fabsf(inverse);
    q->near[k] = (size_t)(down ? 4 + k : k), q->o_near[k] = down ? high : low;
    q->far[k] = (size_t)(down ? k : 4 + k), q->o_far[k] = down ? low : high;
}

__attribute__((always_inline))  /* a call writes 80 bytes and reads them again: 10 % of a ray */
static inline box_ray box_ray_owing(ray r, const bvh_box *all, real more)
{
    box_ray q;
    real longest = fabs(vaxis(r.d, vlongest(r.d)));
    real reach = box_reach(all, r.o);
    real delta = reach * ((real)0x1p-21 + 256 * real_epsilon) + (real)0x1p-100 + more;  /* (14.3) */
    q.scale = direction_scale(longest);
    /* t of hits below real_smallest has fewer digits than eps says. 2^-100 keeps a tmin of 0 away
     * from the numbers below FLT_MIN, with which processors are slow: 10 ns a ray. */
    q.slack = real_smallest * q.scale + (real)0x1p-100;
    q.tmin = float_below(r.tmin * q.scale - q.slack);
    for (int k = 0; k < 3; k++) {
        real d = vaxis(r.d, k), o = vaxis(r.o, k);
        float i = (float)(q.scale / d);
        box_ray_axis(&q, k, float_beyond(o + delta), float_beyond(delta - o), i);
    }
    return q;
}

fast_inline box_ray box_ray_of(ray r, const bvh_box *all, const void *context)
{
    (void)context;
    return box_ray_owing(r, all, 0);
}

/* o = (0, 0, 2/3), a flat box in the plane z = 1/3 of which the float bounds are 1/3 rounded down
 * and up, and a ray along the box's edge or corner: everything is rounded to the nearest float, so
 * t of the near plane may come out larger than t of the far one, and the box is lost with all that
 * is in it. */
fast_inline box_ray box_ray_naive(ray r, const bvh_box *all, const void *context)
{
    box_ray q = {.scale = 1, .tmin = (float)r.tmin};
    (void)all, (void)context;
    for (int k = 0; k < 3; k++) {
        float o = (float)vaxis(r.o, k);
        box_ray_axis(&q, k, o, -o, (float)(1 / vaxis(r.d, k)));
    }
    return q;
}

/* The float that t_enter is compared with: not less than t, in the units of q. */
static inline float box_ray_limit(const box_ray *q, real t)
{
    return float_above(t * q->scale + q->slack);
}

/* (14.2). Each comparison keeps its second argument against a NaN. Inlined: twice in the
 * loop of each search, of which a call costs a fifth. */
fast_inline float box_enter(const bvh_box *b, const box_ray *q, float limit, float *exit)
{
    float x0 = (b->side[q->near[0]] - q->o_near[0]) * q->inverse[0];
    float y0 = (b->side[q->near[1]] - q->o_near[1]) * q->inverse[1];
    float z0 = (b->side[q->near[2]] - q->o_near[2]) * q->inverse[2];
    float x1 = (q->o_far[0] - b->side[q->far[0]]) * q->inverse[0];
    float y1 = (q->o_far[1] - b->side[q->far[1]]) * q->inverse[1];
    float z1 = (q->o_far[2] - b->side[q->far[2]]) * q->inverse[2];
    *exit = float_min(x1, float_min(y1, float_min(z1, limit)));
    return float_max(x0, float_max(y0, float_max(z0, q->tmin)));
}

#endif
