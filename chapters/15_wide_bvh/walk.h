/* walk.h: the search of the tree, in the dialect EIGHT_DIALECT. Included once in each, by search.h:
 * no guard, and every name gets the dialect's number.
 *
 *   bool bvh8_closest(w, &r, &skip, &h), bvh8_any(w, &r, &skip)   the answers of brute force
 *   bool bvh8_closest_leaky(w, &r, &h), bvh8_any_leaky(w, &r)   in float, come what may
 *   bool bvh8_counted(w, &r, &h, any, &work)                    the answers, and what they took
 *
 * A node's eight boxes are tested at once. Of those that the ray meets the nearest is next; the
 * others wait on the stack, farthest first. A block's eight triangles are tested at once, in float
 * with its bounds (ray8.h); what is in doubt is asked again (state8.h). The ray is the caller's to
 * lose: its tmax shrinks.
 */
#include "dialect.h"

#define bvh8_boxes EIGHT_NAME(bvh8_boxes, EIGHT_DIALECT)
#define bvh8_triangles EIGHT_NAME(bvh8_triangles, EIGHT_DIALECT)
#define bvh8_walk EIGHT_NAME(bvh8_walk, EIGHT_DIALECT)
#define bvh8_closest EIGHT_NAME(bvh8_closest, EIGHT_DIALECT)
#define bvh8_any EIGHT_NAME(bvh8_any, EIGHT_DIALECT)
#define bvh8_closest_leaky EIGHT_NAME(bvh8_closest_leaky, EIGHT_DIALECT)
#define bvh8_any_leaky EIGHT_NAME(bvh8_any_leaky, EIGHT_DIALECT)
#define bvh8_counted EIGHT_NAME(bvh8_counted, EIGHT_DIALECT)

/* ---------------------------------------------------------------------------------------------- */

/* (14.2), eight times. Each box's entry, not before tmin; a bit for each box that is met. */
__attribute__((always_inline))
static inline unsigned bvh8_boxes(const bvh8_node *n, const bvh8_ray *q, float limit, eight *enter)
{
    eight ix = EIGHT_ALL(q->inverse[0]), iy = EIGHT_ALL(q->inverse[1]);
    eight iz = EIGHT_ALL(q->inverse[2]);
    eight x0 = EIGHT_FMA(bvh8_row(n, q->near[0]), ix, EIGHT_ALL(q->near_o[0]));
    eight y0 = EIGHT_FMA(bvh8_row(n, q->near[1]), iy, EIGHT_ALL(q->near_o[1]));
    eight z0 = EIGHT_FMA(bvh8_row(n, q->near[2]), iz, EIGHT_ALL(q->near_o[2]));
    eight x1 = EIGHT_FMA(bvh8_row(n, q->far[0]), ix, EIGHT_ALL(q->far_o[0]));
    eight y1 = EIGHT_FMA(bvh8_row(n, q->far[1]), iy, EIGHT_ALL(q->far_o[1]));
    eight z1 = EIGHT_FMA(bvh8_row(n, q->far[2]), iz, EIGHT_ALL(q->far_o[2]));
    eight end = EIGHT_MIN(z1, EIGHT_ALL(limit)), begin = EIGHT_MAX(z0, EIGHT_ALL(q->tmin));
    eight side = EIGHT_MIN(x1, y1), front = EIGHT_MAX(x0, y0);
    *enter = EIGHT_MAX(front, begin);
    side = EIGHT_MIN(side, end);
    return EIGHT_LE(*enter, side);
}

__attribute__((always_inline))
static inline bool bvh8_triangles(const bvh8 *w, const bvh8_block *b, const bvh8_ray *q,
                                  bvh8_state *s, bool any, bool leaky)
{
    const eight *A = b->corner, *B = A + 3, *C = A + 6, zero = EIGHT_ALL(0);
    eight sx = EIGHT_ALL(q->sx), sy = EIGHT_ALL(q->sy);
    eight ox = EIGHT_ALL(q->cx), oy = EIGHT_ALL(q->cy);
    eight az = bvh8_row(A, q->kz), bz = bvh8_row(B, q->kz), cz = bvh8_row(C, q->kz), bound = zero;
    eight ax = EIGHT_FMA(az, sx, bvh8_row(A, q->kx)), ay = EIGHT_FMA(az, sy, bvh8_row(A, q->ky));
    eight bx = EIGHT_FMA(bz, sx, bvh8_row(B, q->kx)), by = EIGHT_FMA(bz, sy, bvh8_row(B, q->ky));
    eight cx = EIGHT_FMA(cz, sx, bvh8_row(C, q->kx)), cy = EIGHT_FMA(cz, sy, bvh8_row(C, q->ky));
    ax -= ox, ay -= oy, bx -= ox, by -= oy, cx -= ox, cy -= oy;
    eight e0 = EIGHT_FMA(cx, by, -(cy * bx));                                     /* (4.10) */
    eight e1 = EIGHT_FMA(ax, cy, -(ay * cx));
    eight e2 = EIGHT_FMA(bx, ay, -(by * ax));
    eight lo = EIGHT_MIN(e0, e1), hi = EIGHT_MAX(e0, e1);
    lo = EIGHT_MIN(lo, e2), hi = EIGHT_MAX(hi, e2);
    unsigned left;
    if (leaky) left = EIGHT_LE(zero, lo) | EIGHT_LE(hi, zero);
    else {
        eight m = EIGHT_FAR(ax, bx), m1 = EIGHT_FAR(cx, ay), m2 = EIGHT_FAR(by, cy);
        m = EIGHT_MAX(m, m1), m = EIGHT_MAX(m, m2);
        bound = EIGHT_FMA(m, EIGHT_ALL(0x1p-20f), EIGHT_ALL(4 * q->around));      /* (15.8) */
        bound = EIGHT_FMA(m, bound, EIGHT_ALL(2 * q->around * q->around));
        left = EIGHT_LE(bound, EIGHT_MIN(-lo, hi)) ^ 255;
    }
    if (left == 0) return false;
    eight det = e0 + e1 + e2, scaled = EIGHT_ALL(1) / det, sz = EIGHT_ALL(q->sz);
    eight sum = EIGHT_FMA(e1, bz, e2 * cz);
    sum = EIGHT_FMA(e0, az, sum);
    eight t = EIGHT_FMA(sum, scaled, -EIGHT_ALL(q->oz)) * sz;
    unsigned sure = 255;
    eight span[2] = {t, t};
    if (!leaky) {
        eight deep = EIGHT_MAX(az, bz), flat = EIGHT_MIN(az, bz), size = EIGHT_FAR(det, det);
        deep = EIGHT_MAX(deep, cz), flat = EIGHT_MIN(flat, cz);
        eight steep = EIGHT_FAR(scaled * sz, zero);
        eight error = EIGHT_FMA(steep, bound * 4 * (deep - flat), EIGHT_ALL(q->tail)); /* (15.9) */
        eight over = bound * EIGHT_ALL(1.01f), many = bound * EIGHT_ALL(16);
        sure = EIGHT_LE(over, EIGHT_MAX(lo, -hi)) & EIGHT_LE(many, size);
        span[0] = t - error, span[1] = t + error;
    }
    left &= ~sure | (EIGHT_LE(span[0], EIGHT_ALL(s->limit))
                     & EIGHT_LE(EIGHT_ALL(q->tmin), span[1]));
    if (left == 0 || (leaky && any)) return left != 0;
    if (leaky) {
        bvh8_keep(b, left, (eight[]){t, e1 * scaled, e2 * scaled}, s);
        return false;
    }
    unsigned safe = sure & left & EIGHT_LE(EIGHT_ALL(q->sure_min), span[0])
        & EIGHT_LE(span[1], EIGHT_ALL(q->sure_max));
    if (any && safe) return true;
    for (unsigned doubt = left & ~safe; doubt; doubt &= doubt - 1) {
        uint32_t k = (uint32_t)__builtin_ctz(doubt), i = b->index[k];
        if (i == s->skip->from || i - s->skip->first <= s->skip->last - s->skip->first)
            left &= ~(1u << k);
    }
    if (left == 0) return false;
    int k = __builtin_ctz(left);
    if (!any && safe == left && (left & (left - 1)) == 0 && span[1][k] < s->first) {
        bvh8_wait(b, k, span[0][k], span[1][k], s);
        return false;
    }
    return bvh8_ask_all(w, b, q, s, any, left, safe, span);
}

__attribute__((always_inline))
static inline bool bvh8_walk(const bvh8 *w, ray *r, const bvh8_skip *skip, hit *out, bool any,
                             bool leaky, search_work *work)
{
    uint64_t stack[512];
    int top = 0;
    if (w->nodes == 0 || !ray_is_usable(*r)) return false;
    bvh8_state s;
    s.r = r, s.sheared = false, s.skip = skip, s.best = hit_none;
    s.waiting = NULL, s.first = INFINITY;
    bvh8_ray q;
    bvh8_ray_of(w, r, leaky, &q);
    s.limit = q.limit;
    for (uint32_t at = 0;;) {
        while (!(at & bvh8_leaf)) {
            const bvh8_node *n = &w->node[at];
            eight enter;
            unsigned mask = bvh8_boxes(n, &q, s.limit, &enter);
            if (work) work->nodes++;
            if (mask == 0) goto pop;
            at = n->child[__builtin_ctz(mask)];
            if ((mask & (mask - 1)) == 0) continue;
            top = bvh8_push(n, mask, &enter, stack, top);
            at = (uint32_t)stack[--top];
        }
        at &= ~bvh8_leaf;
        if (work) bvh8_count(w, at, work);
        if (w->block ? bvh8_triangles(w, &w->block[at], &q, &s, any, leaky)
                     : bvh8_shapes(w, &w->list[at], &q, &s, any)) return true;
    pop:
        do {
            if (top == 0) return !any && (leaky && w->block ? bvh8_answer_leaky(&q, &s, out)
                                                            : bvh8_answer(w, &s, out));
        } while (bvh8_is_behind(stack[--top], s.limit));
        at = (uint32_t)stack[top];
    }
}

/* ---------------------------------------------------------------------------------------------- */

/* Calls: as long as they are, a copy in each caller would only be more code to fetch. */
__attribute__((noinline))
static bool bvh8_closest(const bvh8 *w, ray *r, const bvh8_skip *skip, hit *out)
{
    return bvh8_walk(w, r, skip, out, false, false, NULL);
}

__attribute__((noinline))
static bool bvh8_any(const bvh8 *w, ray *r, const bvh8_skip *skip)
{
    return bvh8_walk(w, r, skip, NULL, true, false, NULL);
}

static bool bvh8_closest_leaky(const bvh8 *w, ray *r, hit *out)
{
    return bvh8_walk(w, r, &bvh8_skip_none, out, false, true, NULL);
}

static bool bvh8_any_leaky(const bvh8 *w, ray *r)
{
    return bvh8_walk(w, r, &bvh8_skip_none, NULL, true, true, NULL);
}

static bool bvh8_counted(const bvh8 *w, ray *r, hit *out, bool any, search_work *work)
{
    return any ? bvh8_walk(w, r, &bvh8_skip_none, NULL, true, false, work)
               : bvh8_walk(w, r, &bvh8_skip_none, out, false, false, work);
}

#undef bvh8_boxes
#undef bvh8_triangles
#undef bvh8_walk
#undef bvh8_closest
#undef bvh8_any
#undef bvh8_closest_leaky
#undef bvh8_any_leaky
#undef bvh8_counted
#undef EIGHT_ALL
#undef EIGHT_FMA
#undef EIGHT_MIN
#undef EIGHT_MAX
#undef EIGHT_ABS
#undef EIGHT_FAR
#undef EIGHT_LE
#undef EIGHT_DIALECT
