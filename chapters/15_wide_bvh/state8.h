/* state8.h: what a search knows so far, and what few rays come to: the tests in `real`.
 *
 *   bvh8_push(n, mask, &enter, stack, top)     children onto the stack, the nearest on top
 *   bvh8_shear(&s)                             the ray as 04 and 07 see it: once, if anybody asks
 *   bvh8_ask(w, block, k, &s)                  one triangle in `real`: is it the closest so far?
 *   bvh8_ask_all(w, block, &q, &s, any, left, safe, span)      those of a block that are in doubt
 *   bvh8_shapes(w, list, &q, &s, any)          shapes of a list, each by its own test
 *   bvh8_answer(w, &s, out)                    at the end: the hit, with all its digits
 *
 * The closest hit that is sure waits, uncomputed: `first` .. `limit` is where its t lies. A
 * triangle that surely lies before takes its place; one that surely lies behind is forgotten; only
 * if neither is sure both are asked. So most rays pay for one test in `real`, shadow rays for none.
 *
 * On the stack a child is one whole number: the bits of t, which rise with a positive t, and then
 * the child. Sorting is comparing numbers.
 */
#ifndef WIDE_STATE8_H
#define WIDE_STATE8_H

#include "ray8.h"

typedef struct {
    ray *r;
    ray_shear shear;            /* of r, once it is asked for: bvh8_shear */
    bool sheared;
    const bvh8_skip *skip;      /* known not to be hit: tree8.h */
    hit best;                   /* computed in `real`; r->tmax is its t */
    const bvh8_block *waiting;  /* nearer than that, and not computed yet: triangle `lane` */
    int lane;
    float first, limit;         /* t of the closest hit, in the frame: not before, not behind */
    float u, v;                 /* of the leaky search */
} bvh8_state;

/* ---------------------------------------------------------------------------------------------- */

static inline uint64_t bvh8_key(const uint32_t *enter, const bvh8_node *n, int k)
{
    return (uint64_t)enter[k] << 32 | n->child[k];
}

/* At least two. Returns how many there are now. */
__attribute__((always_inline))
static inline int bvh8_push(const bvh8_node *n, unsigned mask, const eight *enter,
                            uint64_t *stack, int top)
{
    uint32_t bits[8];
    int base = top, k = __builtin_ctz(mask);
    eight from = eight_max((const eight[]){*enter, {0}});
    memcpy(bits, &from, sizeof bits);
    uint64_t one = bvh8_key(bits, n, k);
    mask &= mask - 1, k = __builtin_ctz(mask);
    uint64_t two = bvh8_key(bits, n, k);
    stack[top++] = one < two ? two : one;  /* without a branch, and mostly that is all */
    stack[top++] = one < two ? one : two;
    for (mask &= mask - 1; mask; mask &= mask - 1) {
        int j = top++;
        uint64_t key = bvh8_key(bits, n, __builtin_ctz(mask));
        for (; j > base && stack[j - 1] < key; j--) stack[j] = stack[j - 1];
        stack[j] = key;
    }
    return top;
}

/* Where a hit has been found since, before the child's box begins. */
static inline bool bvh8_is_behind(uint64_t key, float limit)
{
    uint32_t bits = (uint32_t)(key >> 32);
    float enter;
    memcpy(&enter, &bits, sizeof enter);
    return enter > limit && enter > 0;
}

/* What a leaf takes, for bvh8_counted. */
static inline void bvh8_count(const bvh8 *w, uint32_t leaf, search_work *work)
{
    const uint32_t *index = w->block ? w->block[leaf].index : w->list[leaf].index;
    work->leaves++;
    for (int k = 0; k < 8; k++) work->tests += index[k] != no_shape;
}

/* Once a ray, and only for those that need it: balls don't. */
static inline const ray_shear *bvh8_shear(bvh8_state *s)
{
    if (!s->sheared) s->shear = shear_of(*s->r), s->sheared = true;
    return &s->shear;
}

static inline void bvh8_ask(const bvh8 *w, const bvh8_block *b, int k, bvh8_state *s)
{
    hit h;
    if (!bvh8_exactly(w, b, k, s->r, bvh8_shear(s), &h) || !hit_before(h, s->best)) return;
    s->best = h, s->r->tmax = h.t;
}

static inline void bvh8_wait(const bvh8_block *b, int k, float first, float last, bvh8_state *s)
{
    s->first = first, s->limit = last, s->waiting = b, s->lane = k;
}

/* Of these `safe` are surely hit between first and last, span[0] and [1], the others perhaps. True:
 * any hit is enough, and there is one. */
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
            if (bvh8_exactly(w, b, k, s->r, bvh8_shear(s), &h)) return true;
            continue;
        }
        if (sure && last < s->first) {
            bvh8_wait(b, k, first, last, s);
            continue;
        }
        if (s->waiting) bvh8_ask(w, s->waiting, s->lane, s), s->waiting = NULL;
        bvh8_ask(w, b, k, s);
        if (s->best.shape == no_shape) continue;
        s->limit = bvh8_limit(q, s->r->tmax);
        s->first = bvh8_before(q, s->r->tmax);
    }
    return false;
}

__attribute__((always_inline))
static inline bool bvh8_shapes(const bvh8 *w, const bvh8_list *l, const bvh8_ray *q, bvh8_state *s,
                               bool any)
{
    for (int k = 0; k < 8 && l->index[k] != no_shape; k++) {
        const shape *x = &w->x.s->shapes[l->index[k]];
        hit h;
        if (!(x->kind == SHAPE_SPHERE ? sphere_hit(x->sphere, *s->r, &h)
                                      : shape_hit_sheared(x, bvh8_shear(s), *s->r, &h))) continue;
        if (any) return true;
        h.shape = l->index[k];
        if (hit_before(h, s->best)) s->best = h, s->r->tmax = h.t, s->limit = bvh8_limit(q, h.t);
    }
    return false;
}

/* The leaky search believes what it has computed. */
__attribute__((always_inline))
static inline void bvh8_keep(const bvh8_block *b, unsigned left, const eight tuv[3], bvh8_state *s)
{
    for (; left; left &= left - 1) {
        int k = __builtin_ctz(left);
        if (b->index[k] == no_shape || tuv[0][k] > s->limit) continue;
        bvh8_wait(b, k, tuv[0][k], tuv[0][k], s);
        s->u = tuv[1][k], s->v = tuv[2][k];
    }
}

static inline bool bvh8_answer(const bvh8 *w, bvh8_state *s, hit *out)
{
    if (s->waiting && s->best.shape == no_shape)
        return bvh8_exactly(w, s->waiting, s->lane, s->r, bvh8_shear(s), out);
    if (s->waiting) bvh8_ask(w, s->waiting, s->lane, s);
    if (s->best.shape == no_shape) return false;
    *out = s->best;
    return true;
}

static inline bool bvh8_answer_leaky(const bvh8_ray *q, const bvh8_state *s, hit *out)
{
    if (!s->waiting) return false;
    real t = (real)(((double)s->limit + q->shift) / q->scale);
    *out = (hit){t, (real)s->u, (real)s->v, s->waiting->index[s->lane]};
    return true;
}

#endif
