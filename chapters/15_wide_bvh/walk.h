/* walk.h: the search of the tree. Compiled once in each dialect, by dialects.h: no guard.
 *
 *   bool EIGHT(bvh8_find)(w, &r, &skip, &h, work)    the closest hit; h NULL: is there any? work:
 *                                                      counts what it took; NULL: does not
 *
 * A node's eight boxes are tested at once. Of those that the ray meets the nearest is next; the
 * others wait on the stack, farthest first. A block's eight triangles are tested at once, in float
 * with its bounds (ray8.h). What is in doubt is asked in `real` at once; what is surely hit at the
 * end, when most of it lies behind something else. A search for any hit ends there.
 */

/* (15.2): the children that are met, and where, not before 0. */
EIGHT_INLINE eight_set EIGHT(bvh8_boxes)(const bvh8_node *n, const bvh8_ray *q, eight *enter)
{
    eight near[3], far[3];
    EIGHT_UNROLL
    for (int k = 0; k < 3; k++) {
        eight i = EIGHT_ALL(q->inverse[k]);
        near[k] = EIGHT_FMA(EIGHT_ROW(n->side, q->near[k]), i, EIGHT_ALL(q->near_o[k]));
        far[k] = EIGHT_FMA(EIGHT_ROW(n->side, q->far[k]), i, EIGHT_ALL(q->far_o[k]));
    }
    eight begin = EIGHT_MAX(near[2], EIGHT_ALL(q->tmin));
    eight end = EIGHT_MIN(far[2], EIGHT_ALL(q->limit));
    begin = EIGHT_MAX(EIGHT_MAX(near[0], near[1]), begin);
    *enter = EIGHT_MAX(begin, EIGHT_ALL(0));
    return EIGHT_LE_BITS(begin, EIGHT_MIN(EIGHT_MIN(far[0], far[1]), end));
}

/* The corners as the ray sees them (4.9), edge functions (4.10), the least and largest of them. */
typedef struct { eight x[3], y[3], z[3], e[3], lo, hi; } EIGHT(bvh8_view);

EIGHT_INLINE void EIGHT(bvh8_look)(const bvh8_block *b, const bvh8_ray *q, EIGHT(bvh8_view) *v)
{
    EIGHT_UNROLL
    for (int i = 0; i < 3; i++) {
        const eight *c = b->corner + 3 * i;
        v->z[i] = EIGHT_ROW(c, q->kz);
        v->x[i] = EIGHT_FMA(v->z[i], EIGHT_ALL(q->sx), EIGHT_ROW(c, q->kx)) - q->cx;
        v->y[i] = EIGHT_FMA(v->z[i], EIGHT_ALL(q->sy), EIGHT_ROW(c, q->ky)) - q->cy;
    }
    EIGHT_UNROLL
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        v->e[i] = EIGHT_FMA(v->x[k], v->y[j], -(v->y[k] * v->x[j]));
    }
    v->lo = EIGHT_MIN(EIGHT_MIN(v->e[0], v->e[1]), v->e[2]);
    v->hi = EIGHT_MAX(EIGHT_MAX(v->e[0], v->e[1]), v->e[2]);
}

EIGHT_INLINE bool EIGHT(bvh8_triangles)(const bvh8 *w, const bvh8_block *b, bvh8_ray *q, bool any)
{
    EIGHT(bvh8_view) v;
    EIGHT(bvh8_look)(b, q, &v);
    /* Empty places, and what the caller leaves out. */
    eight_whole out = (eight_whole)b->index >> 31 | bvh8_left_out(b->index, q);
    eight_whole maybe = ~out & ~EIGHT_LE(EIGHT_ALL(q->most), EIGHT_MIN(-v.lo, v.hi));
    if (EIGHT_BITS(maybe) == 0) return false;
    eight m = EIGHT_FAR(v.x[0], v.y[0]), m1 = EIGHT_FAR(v.x[1], v.y[1]), zero = EIGHT_ALL(0);
    m = EIGHT_MAX(EIGHT_MAX(m, m1), EIGHT_FAR(v.x[2], v.y[2]));
    eight bound = EIGHT_FMA(m, EIGHT_ALL(0x1p-20f), EIGHT_ALL(4 * q->around));       /* (15.8) */
    bound = EIGHT_FMA(m, bound, EIGHT_ALL(2 * q->around * q->around));
    maybe &= ~EIGHT_LE(bound, EIGHT_MIN(-v.lo, v.hi));
    if (EIGHT_BITS(maybe) == 0) return false;
    eight det = v.e[0] + v.e[1] + v.e[2], scaled = 1 / det;
    eight sum = EIGHT_FMA(v.e[0], v.z[0], EIGHT_FMA(v.e[1], v.z[1], v.e[2] * v.z[2]));
    eight t = EIGHT_FMA(sum, scaled, -EIGHT_ALL(q->oz)) * q->sz;
    eight spread = EIGHT_MAX(EIGHT_MAX(v.z[0], v.z[1]), v.z[2])
        - EIGHT_MIN(EIGHT_MIN(v.z[0], v.z[1]), v.z[2]);
    eight error = EIGHT_FMA(EIGHT_FAR(scaled * q->sz, zero), 4 * bound * spread,     /* (15.9) */
                            EIGHT_ALL(q->tail));
    eight first = t - error, last = t + error;
    eight_whole sure = EIGHT_LE(bound * 2.02f, EIGHT_MAX(v.lo, -v.hi));
    maybe &= ~sure | (EIGHT_LE(first, EIGHT_ALL(q->limit)) & EIGHT_LE(EIGHT_ALL(q->tmin), last));
    eight_set left = EIGHT_BITS(maybe);
    if (left == 0) return false;
    eight_set safe = EIGHT_BITS(maybe & sure & EIGHT_LE(EIGHT_ALL(q->sure_min), first)
                                & EIGHT_LE(last, EIGHT_ALL(q->sure_max)));
    if (any && safe) return true;
    bool doubt = left != safe || q->doubts > bvh8_most_doubts - 16;
    for (; left; left &= left - 1) {
        int k = EIGHT_FIRST(left);
        q->doubt[q->doubts++] = (bvh8_doubt){b, k, sure[k] ? first[k] : -INFINITY};
        if (safe >> EIGHT_STEP * k & 1 && last[k] < q->limit) q->limit = last[k];
    }
    return doubt && bvh8_settle(w, q) && any;
}

/* `mask` of the children, entered at `enter`, not before 0: the nearest is returned, the others go
 * onto the stack, farthest first. There a child is one whole number: the bits of t, which rise with
 * t, and then its own. */
EIGHT_INLINE uint32_t EIGHT(bvh8_push)(const bvh8_node *n, eight_set mask, const eight *enter,
                                       uint64_t **top)
{
    const uint32_t *bits = (const uint32_t *)enter;  /* a copy would wait for them */
    uint64_t *const base = *top, *end = base;
    int k = EIGHT_FIRST(mask);
    uint64_t near = (uint64_t)bits[k] << 32 | n->child[k];
    while (mask &= mask - 1) {
        k = EIGHT_FIRST(mask);
        uint64_t next = (uint64_t)bits[k] << 32 | n->child[k];
        uint64_t far = next < near ? near : next;  /* without a branch, and mostly that is all */
        near = next < near ? next : near;
        uint64_t *j = end++;
        for (; j > base && j[-1] < far; j--) *j = j[-1];
        *j = far;
    }
    *top = end;
    return (uint32_t)near;
}

/* True: any hit is enough, and there is one. */
EIGHT_INLINE bool EIGHT(bvh8_walk)(const bvh8 *w, bvh8_ray *q, bool any, search_work *work)
{
    uint64_t stack[bvh8_stack], *top = stack;
    for (uint32_t at = 0;;) {
        while (!(at & bvh8_leaf)) {
            const bvh8_node *n = &w->node[at];
            eight enter;
            eight_set mask = EIGHT(bvh8_boxes)(n, q, &enter);
            eight_count as_leaf = (eight_count)EIGHT_ROW(n->child, 0) ^ bvh8_leaf;
            if (!w->block) mask &= ~EIGHT_BITS(bvh8_left_out(as_leaf, q));  /* shapes, one a leaf */
            if (work) work->nodes++;
            if (mask == 0) goto next;
            at = n->child[EIGHT_FIRST(mask)];
            if (mask & (mask - 1)) at = EIGHT(bvh8_push)(n, mask, &enter, &top);
        }
        at &= ~bvh8_leaf;
        if (work) {
            eight_set held = w->block ? EIGHT_BITS(w->block[at].index != no_shape) : 1;
            work->leaves++, work->tests += EIGHT_COUNT(held);
        }
        if (w->block ? EIGHT(bvh8_triangles)(w, &w->block[at], q, any)
                     : bvh8_shape(w, at, q) && any) return true;
    next:
        do if (top == stack) return false;
        while (*--top >> 32 > q->bits[1] && !any);  /* of the limit */
        at = (uint32_t)*top;
    }
}

EIGHT_TARGET __attribute__((noinline))
static bool EIGHT(bvh8_find)(const bvh8 *w, const ray *r, const bvh8_skip *skip, hit *out,
                             search_work *work)
{
    bvh8_ray q;
    if (!bvh8_ray_of(w, r, skip, &q) || w->nodes == 0) return false;
    if (work ? EIGHT(bvh8_walk)(w, &q, !out, work) : out ? EIGHT(bvh8_walk)(w, &q, false, NULL)
        : EIGHT(bvh8_walk)(w, &q, true, NULL)) return true;
    if (q.doubts) bvh8_settle(w, &q);
    if (q.best.shape == no_shape) return false;
    if (out) *out = (hit){q.best.t, q.best.u, q.best.v, q.best.shape};
    return true;
}
