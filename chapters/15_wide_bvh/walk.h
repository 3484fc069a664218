/* walk.h: the search of the tree, in the dialect EIGHT_DIALECT. Included once in each, by search.h:
 * no guard, and every name gets the dialect's number.
 *
 *   bool bvh8_closest(w, r, skip, &h), bvh8_any(w, r, skip) the answers of brute force
 *   bool bvh8_closest_leaky(w, r, &h), bvh8_any_leaky(w, r) in float, come what may
 *   bool bvh8_counted(w, r, &h, any, &work)                 the answers, and what they took
 *
 * A node's eight boxes are tested at once. Of those that the ray meets the nearest is next; the
 * others wait on the stack, farthest first, as one whole number: the bits of t, which rise with a
 * positive t, and then the child. Sorting is comparing numbers.
 *
 * A block's eight triangles are tested at once, in float with its bounds: ray8.h. The closest hit
 * that is sure waits, uncomputed: `first` .. `limit` is where its t lies. A triangle that surely
 * lies before takes its place; one that surely lies behind is forgotten; only if neither is sure
 * both are asked in `real`. So most rays pay for one test in `real`, and shadow rays for none.
 */
#include "dialect.h"

#define bvh8_boxes EIGHT_NAME(bvh8_boxes, EIGHT_DIALECT)
#define bvh8_state EIGHT_NAME(bvh8_state, EIGHT_DIALECT)
#define bvh8_ask EIGHT_NAME(bvh8_ask, EIGHT_DIALECT)
#define bvh8_ask_all EIGHT_NAME(bvh8_ask_all, EIGHT_DIALECT)
#define bvh8_shapes EIGHT_NAME(bvh8_shapes, EIGHT_DIALECT)
#define bvh8_keep EIGHT_NAME(bvh8_keep, EIGHT_DIALECT)
#define bvh8_triangles EIGHT_NAME(bvh8_triangles, EIGHT_DIALECT)
#define bvh8_push EIGHT_NAME(bvh8_push, EIGHT_DIALECT)
#define bvh8_walk EIGHT_NAME(bvh8_walk, EIGHT_DIALECT)
#define bvh8_closest EIGHT_NAME(bvh8_closest, EIGHT_DIALECT)
#define bvh8_any EIGHT_NAME(bvh8_any, EIGHT_DIALECT)
#define bvh8_closest_leaky EIGHT_NAME(bvh8_closest_leaky, EIGHT_DIALECT)
#define bvh8_any_leaky EIGHT_NAME(bvh8_any_leaky, EIGHT_DIALECT)
#define bvh8_counted EIGHT_NAME(bvh8_counted, EIGHT_DIALECT)

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    ray r;
    bvh8_skip skip;
    hit best;                   /* computed in `real`; r.tmax is its t */
    const bvh8_block *waiting;  /* nearer than that, and not computed yet: triangle `lane` */
    int lane;
    float first, limit;         /* t of the closest hit, in the frame: not before, not behind */
    float u, v;                 /* of the leaky search */
} bvh8_state;

/* (14.2), eight times. Each box's entry, not before tmin; a bit for each box that is met. */
__attribute__((always_inline))
static inline unsigned bvh8_boxes(const bvh8_node *n, const bvh8_ray *q, float limit, eight *enter)
{
    eight ix = EIGHT_ALL(q->inverse[0]), iy = EIGHT_ALL(q->inverse[1]);
    eight iz = EIGHT_ALL(q->inverse[2]);
    eight x0 = EIGHT_FMA(n->side[q->near[0]], ix, EIGHT_ALL(q->near_o[0]));
    eight y0 = EIGHT_FMA(n->side[q->near[1]], iy, EIGHT_ALL(q->near_o[1]));
    eight z0 = EIGHT_FMA(n->side[q->near[2]], iz, EIGHT_ALL(q->near_o[2]));
    eight x1 = EIGHT_FMA(n->side[q->far[0]], ix, EIGHT_ALL(q->far_o[0]));
    eight y1 = EIGHT_FMA(n->side[q->far[1]], iy, EIGHT_ALL(q->far_o[1]));
    eight z1 = EIGHT_FMA(n->side[q->far[2]], iz, EIGHT_ALL(q->far_o[2]));
    eight end = EIGHT_MIN(z1, EIGHT_ALL(limit)), begin = EIGHT_MAX(z0, EIGHT_ALL(q->tmin));
    eight side = EIGHT_MIN(x1, y1), front = EIGHT_MAX(x0, y0);
    *enter = EIGHT_MAX(front, begin);
    side = EIGHT_MIN(side, end);
    return EIGHT_LE(*enter, side);
}

static inline void bvh8_ask(const bvh8 *w, const bvh8_block *b, int k, bvh8_state *s)
{
    hit h;
    if (bvh8_exactly(w, b, k, s->r, &h) && hit_before(h, s->best)) s->best = h, s->r.tmax = h.t;
}

/* Triangles of a block of which `safe` are surely hit between first and last, the others perhaps.
 * True: any hit is enough, and there is one. */
__attribute__((noinline))
static bool bvh8_ask_all(const bvh8 *w, const bvh8_block *b, const bvh8_ray *q, bvh8_state *s,
                         bool any, unsigned left, unsigned safe, const eight *span)
{
    for (; left; left &= left - 1) {
        int k = __builtin_ctz(left);
        bool sure = safe >> k & 1;
        float first = span[0][k], last = span[1][k];
        hit h;
        if (b->index[k] == no_shape || (sure && first > s->limit)) continue;
        if (any) {
            if (bvh8_exactly(w, b, k, s->r, &h)) return true;
            continue;
        }
        if (sure && last < s->first) {
            s->first = first, s->limit = last, s->waiting = b, s->lane = k;
            continue;
        }
        if (s->waiting) bvh8_ask(w, s->waiting, s->lane, s), s->waiting = NULL;
        bvh8_ask(w, b, k, s);
        if (s->best.shape == no_shape) continue;
        s->limit = bvh8_limit(q, s->r.tmax);
        s->first = bvh8_before(q, s->r.tmax);
    }
    return false;
}

/* Shapes of a list, each by its own test. */
static inline bool bvh8_shapes(const bvh8 *w, const bvh8_list *l, const bvh8_ray *q, bvh8_state *s,
                               bool any)
{
    query ask = {s->r, shear_of(s->r), s->best};
    for (int k = 0; k < 8 && l->index[k] != no_shape; k++)
        if (query_ask(&ask, &w->x, l->index[k], any) && any) return true;
    s->r = ask.r, s->best = ask.best;
    s->limit = bvh8_limit(q, s->r.tmax);
    return false;
}

/* The leaky search believes what it has computed. */
__attribute__((always_inline))
static inline void bvh8_keep(const bvh8_block *b, unsigned left, const eight tuv[3], bvh8_state *s)
{
    for (; left; left &= left - 1) {
        int k = __builtin_ctz(left);
        if (b->index[k] == no_shape || tuv[0][k] > s->limit) continue;
        s->limit = tuv[0][k], s->u = tuv[1][k], s->v = tuv[2][k];
        s->waiting = b, s->lane = k;
    }
}

__attribute__((always_inline))
static inline bool bvh8_triangles(const bvh8 *w, const bvh8_block *b, const bvh8_ray *q,
                                  bvh8_state *s, bool any, bool leaky)
{
    const eight *row = b->corner, zero = EIGHT_ALL(0);
    eight sx = EIGHT_ALL(q->sx), sy = EIGHT_ALL(q->sy);
    eight ox = EIGHT_ALL(q->cx), oy = EIGHT_ALL(q->cy);
    eight az = row[q->kz], bz = row[3 + q->kz], cz = row[6 + q->kz], bound = zero;
    eight ax = EIGHT_FMA(az, sx, row[q->kx]) - ox, ay = EIGHT_FMA(az, sy, row[q->ky]) - oy;
    eight bx = EIGHT_FMA(bz, sx, row[3 + q->kx]) - ox, by = EIGHT_FMA(bz, sy, row[3 + q->ky]) - oy;
    eight cx = EIGHT_FMA(cz, sx, row[6 + q->kx]) - ox, cy = EIGHT_FMA(cz, sy, row[6 + q->ky]) - oy;
    eight e0 = EIGHT_FMA(cx, by, -(cy * bx));                                     /* (4.10) */
    eight e1 = EIGHT_FMA(ax, cy, -(ay * cx));
    eight e2 = EIGHT_FMA(bx, ay, -(by * ax));
    eight lo = EIGHT_MIN(e0, e1), hi = EIGHT_MAX(e0, e1);
    lo = EIGHT_MIN(lo, e2), hi = EIGHT_MAX(hi, e2);
    unsigned left;
    if (leaky) left = EIGHT_LE(zero, lo) | EIGHT_LE(hi, zero);
    else {
        eight m = EIGHT_FAR(ax, bx), m1 = EIGHT_FAR(cx, ay), m2 = EIGHT_FAR(by, cy);
        m = EIGHT_FAR(m, m1), m = EIGHT_FAR(m, m2);
        bound = EIGHT_FMA(m, EIGHT_ALL(0x1p-20f), EIGHT_ALL(4 * q->around));      /* (15.8) */
        bound = EIGHT_FMA(m, bound, EIGHT_ALL(2 * q->around * q->around));
        left = ~(EIGHT_LE(lo, -bound) & EIGHT_LE(bound, hi)) & 255;
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
        sure = (EIGHT_LE(over, lo) | EIGHT_LE(hi, -over)) & EIGHT_LE(many, size);
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
        if (i == s->skip.from || i - s->skip.first <= s->skip.last - s->skip.first)
            left &= ~(1u << k);
    }
    if (left == 0) return false;
    int k = __builtin_ctz(left);
    if (!any && safe == left && (left & (left - 1)) == 0 && span[1][k] < s->first) {
        s->first = span[0][k], s->limit = span[1][k], s->waiting = b, s->lane = k;
        return false;
    }
    return bvh8_ask_all(w, b, q, s, any, left, safe, span);
}

/* The children of `mask` onto the stack, the nearest on top. Returns how many there are now. */
__attribute__((always_inline))
static inline int bvh8_push(const bvh8_node *n, unsigned mask, const eight *enter,
                            uint64_t *stack, int top)
{
    uint32_t bits[8];
    eight from = EIGHT_MAX(*enter, EIGHT_ALL(0));
    memcpy(bits, &from, sizeof bits);
    for (int base = top; mask; mask &= mask - 1) {
        int k = __builtin_ctz(mask), j = top++;
        uint64_t key = (uint64_t)bits[k] << 32 | n->child[k];
        for (; j > base && stack[j - 1] < key; j--) stack[j] = stack[j - 1];
        stack[j] = key;
    }
    return top;
}

__attribute__((always_inline))
static inline bool bvh8_walk(const bvh8 *w, ray r, bvh8_skip skip, hit *out, bool any,
                             bool leaky, search_work *work)
{
    uint64_t stack[512];
    int top = 0;
    if (w->nodes == 0 || !ray_is_usable(r)) return false;
    bvh8_state s = {.r = r, .best = hit_none, .first = INFINITY, .skip = skip};
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
        if (work) {
            const uint32_t *index = w->block ? w->block[at].index : w->list[at].index;
            work->leaves++;
            for (int k = 0; k < 8; k++) work->tests += index[k] != no_shape;
        }
        if (w->block ? bvh8_triangles(w, &w->block[at], &q, &s, any, leaky)
                     : bvh8_shapes(w, &w->list[at], &q, &s, any)) return true;
    pop:
        for (;;) {
            if (top == 0) goto end;
            uint32_t bits = (uint32_t)(stack[--top] >> 32);
            float enter;
            memcpy(&enter, &bits, sizeof enter);
            if (!(enter > s.limit && enter > 0)) break;
        }
        at = (uint32_t)stack[top];
    }
end:
    if (leaky && s.waiting && !any) {
        real t = (real)(((double)s.limit + q.shift) / q.scale);
        *out = (hit){t, (real)s.u, (real)s.v, s.waiting->index[s.lane]};
        return true;
    }
    if (!any && s.waiting) bvh8_ask(w, s.waiting, s.lane, &s);
    if (any || s.best.shape == no_shape) return false;
    *out = s.best;
    return true;
}

/* ---------------------------------------------------------------------------------------------- */

static bool bvh8_closest(const bvh8 *w, ray r, bvh8_skip skip, hit *out)
{
    return bvh8_walk(w, r, skip, out, false, false, NULL);
}

static bool bvh8_any(const bvh8 *w, ray r, bvh8_skip skip)
{
    return bvh8_walk(w, r, skip, NULL, true, false, NULL);
}

static bool bvh8_closest_leaky(const bvh8 *w, ray r, hit *out)
{
    return bvh8_walk(w, r, bvh8_skip_none, out, false, true, NULL);
}

static bool bvh8_any_leaky(const bvh8 *w, ray r)
{
    return bvh8_walk(w, r, bvh8_skip_none, NULL, true, true, NULL);
}

static bool bvh8_counted(const bvh8 *w, ray r, hit *out, bool any, search_work *work)
{
    return any ? bvh8_walk(w, r, bvh8_skip_none, NULL, true, false, work)
               : bvh8_walk(w, r, bvh8_skip_none, out, false, false, work);
}

#undef bvh8_boxes
#undef bvh8_state
#undef bvh8_ask
#undef bvh8_ask_all
#undef bvh8_shapes
#undef bvh8_keep
#undef bvh8_triangles
#undef bvh8_push
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
