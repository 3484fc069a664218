/* packet.h: rays side by side (光线包, a ray packet), where triangles are few: a lane a ray. Compiled
 * once in each dialect, by dialects.h: no guard.
 *
 *   void EIGHT(bvh8_row)(w, q, n, any)        n queries; the answers of EIGHT(bvh8_find)
 *   void EIGHT(bvh8_packet)(w, q, n, any)     n [1..LANES_N] of them at once, of a w with patches
 *
 * One ray against eight triangles waits: for its own beginning, for the end of each step, for a
 * branch that nobody could foresee. Eight or sixteen rays against one patch (patch.h) after another
 * wait for nothing: there is no branch. That is linear in the triangles, so it is for few.
 *
 * In float, with bounds. Of each half of a patch a row is kept: from where on each ray may meet it;
 * infinite: surely never. The nearest is asked in `real`, by the test of 04, and then what may
 * still come before it. u = 2^-24; S is |o.x| + |o.y| + |o.z| in the frame, but at least 1; L is
 * that of d. MEASURED.md has the sums:
 *
 *   edges    e1, e2, D are within b = (20 u size + 256 eps S) S L of what 04 decides by. A half is
 *            surely missed where its least number is below -B, B = 12 b                     (15.12)
 *   t        within 2 B / (3 L |D|): of a patch seen edge-on it may be anywhere             (15.13)
 *
 * Source: I. Wald, P. Slusallek, C. Benthin, M. Wagner, "Interactive Rendering with Coherent Ray
 * Tracing", Computer Graphics Forum 20(3), 2001 (packets).
 */

/* The rays, a lane each, in the frame of the tree. alone: float can't follow them. */
typedef struct {
    LANES o[3], d[3], m[3], tmin, tmax, owed, least, owed_t;
    LANES_WHOLE from, first, others, alone;
} EIGHT(packet);

/* Each ray's nearest half. */
typedef struct { LANES at; LANES_WHOLE half; } EIGHT(packet_near);

EIGHT_INLINE void EIGHT(packet_take)(const bvh8 *w, const bvh8_query *q, int k, EIGHT(packet) *p)
{
    const ray *r = q->r;
    floats4 o = floats4_of(frame_into(&w->frame, r->o)), d = floats4_of(r->d);
    EIGHT_UNROLL
    for (int i = 0; i < 3; i++) p->o[i][k] = o[i], p->d[i][k] = d[i];
    p->tmin[k] = (float)(r->tmin * w->frame.scale), p->tmax[k] = (float)(r->tmax * w->frame.scale);
    p->from[k] = (int32_t)q->skip.from, p->first[k] = (int32_t)q->skip.first;
    p->others[k] = (int32_t)(q->skip.last - q->skip.first);
}

/* What follows from that, for all lanes together. */
EIGHT_INLINE void EIGHT(packet_bounds)(EIGHT(packet) *p)
{
    const LANES *o = p->o, *d = p->d;
    const float eps = (float)real_epsilon;
    LANES S = LANES_MAX(LANES_ALL(1), LANES_ABS(o[0]) + LANES_ABS(o[1]) + LANES_ABS(o[2]));
    LANES L = LANES_ABS(d[0]) + LANES_ABS(d[1]) + LANES_ABS(d[2]);
    p->m[0] = o[1] * d[2] - o[2] * d[1];
    p->m[1] = o[2] * d[0] - o[0] * d[2];
    p->m[2] = o[0] * d[1] - o[1] * d[0];
    p->alone = ~((LANES_WHOLE)(S <= 8) & (LANES_WHOLE)(L >= 0x1p-20f)
                 & (LANES_WHOLE)(L <= 0x1p20f));
    p->owed = S * L * (12 * 0x1.4p-20f), p->least = S * S * L * (12 * 256 * eps);
    p->owed_t = (2 / 3.0f) / L;
}

/* d . v + add. (A pointer: eight.h says why.) */
EIGHT_INLINE LANES EIGHT(packet_dot)(const LANES *d, const float *v, const LANES *add)
{
    LANES sum = LANES_FMA(d[0], LANES_ALL(v[0]), *add);
    sum = LANES_FMA(d[1], LANES_ALL(v[1]), sum);
    return LANES_FMA(d[2], LANES_ALL(v[2]), sum);
}

/* Keeps what a half says. */
EIGHT_INLINE LANES EIGHT(packet_half)(const EIGHT(packet) *p, uint32_t index, int half,
                                      const LANES_WHOLE *maybe, const LANES *begin,
                                      EIGHT(packet_near) *near)
{
    typedef EIGHT(lanes_count) count;
    LANES_WHOLE out = (LANES_WHOLE)((count)p->from == index)
        | (LANES_WHOLE)(index - (count)p->first <= (count)p->others);
    LANES_WHOLE in = *maybe & ~out, never = (LANES_WHOLE)LANES_ALL(INFINITY);
    LANES at = (LANES)(((LANES_WHOLE)*begin & in) | (never & ~in));
    LANES_WHOLE nearer = (LANES_WHOLE)(at < near->at);
    near->half = (near->half & ~nearer) | (nearer & half);
    near->at = LANES_MIN(at, near->at);
    return at;
}

/* (15.10) to (15.13). `at`: a row for each half. */
EIGHT_INLINE void EIGHT(packet_patch)(const bvh8_patch *b, int k, const EIGHT(packet) *p,
                                      LANES *at, EIGHT(packet_near) *near)
{
    const LANES zero = LANES_ALL(0.0f);
    LANES det = EIGHT(packet_dot)(p->d, b->n, &zero);
    LANES e1 = EIGHT(packet_dot)(p->d, b->edge[0], &zero);
    LANES e2 = EIGHT(packet_dot)(p->d, b->edge[1], &zero);
    e1 = EIGHT(packet_dot)(p->m, b->edge[0] + 3, &e1);
    e2 = EIGHT(packet_dot)(p->m, b->edge[1] + 3, &e2);
    LANES to = LANES_ALL(b->to) - EIGHT(packet_dot)(p->o, b->n, &zero);
    LANES B = LANES_FMA(p->owed, LANES_ALL(b->size), p->least);
    LANES_WHOLE turned = (LANES_WHOLE)det & INT32_MIN;
    LANES size = LANES_ABS(det), per = 1 / (size + 0x1p-100f);  /* never infinite */
    e1 = (LANES)((LANES_WHOLE)e1 ^ turned), e2 = (LANES)((LANES_WHOLE)e2 ^ turned);
    LANES t = (LANES)((LANES_WHOLE)to ^ turned) * per, error = B * p->owed_t * per;
    LANES rest = size - e1 - e2, begin = t - error;
    LANES_WHOLE timely = (LANES_WHOLE)(begin <= p->tmax) & (LANES_WHOLE)(t + error >= p->tmin);
    LANES in = LANES_MIN(LANES_MIN(e1, e2), rest);
    LANES_WHOLE maybe = timely & (LANES_WHOLE)(in >= -B);
    at[0] = EIGHT(packet_half)(p, b->index[0], 2 * k, &maybe, &begin, near);
    if (b->items == 1) return;
    in = LANES_MIN(size - LANES_MAX(e1, e2), -rest), maybe = timely & (LANES_WHOLE)(in >= -B);
    at[1] = EIGHT(packet_half)(p, b->index[1], 2 * k + 1, &maybe, &begin, near);
}

/* q->h, if triangle i of w is nearer; any: whether it is met at all. */
EIGHT_TARGET __attribute__((noinline, flatten))
static void EIGHT(packet_settle)(const bvh8 *w, uint32_t i, bool any, bvh8_query *q)
{
    const uint32_t *corner = w->x.m->index + 3 * (size_t)i;
    const ray *r = q->r;
    ray_shear s = shear_along(r, vlongest(r->d));
    vec3 p[3];
    hit h;
    EIGHT_UNROLL
    for (int k = 0; k < 3; k++) p[k] = shear_corner(&w->x.m->v[corner[k]], &s);
    if (!shear_passes(p[0], p[1], p[2], &s, *r, &h)) return;
    h.shape = i;
    if (any || !q->met || hit_before(h, q->h))
        q->h.t = h.t, q->h.u = h.u, q->h.v = h.v, q->h.shape = i, q->met = true;
}

EIGHT_TARGET __attribute__((noinline))
static void EIGHT(bvh8_packet)(const bvh8 *w, bvh8_query *q, int n, bool any)
{
    EIGHT(packet) p;
    EIGHT(packet_near) near = {LANES_ALL(INFINITY), LANES_ALL_WHOLE(-1)};
    LANES at[2 * bvh8_few], limit = LANES_ALL(-INFINITY);
    for (int k = 0; k < LANES_N; k++) EIGHT(packet_take)(w, &q[k < n ? k : 0], k, &p);
    EIGHT(packet_bounds)(&p);
    for (int k = 0; k < (int)w->patches; k++)
        EIGHT(packet_patch)(&w->patch[k], k, &p, &at[2 * k], &near);
    for (int k = 0; k < n; k++) {
        int half = near.half[k];
        q[k].met = false;
        hit *h = any ? NULL : &q[k].h;
        if (p.alone[k]) q[k].met = EIGHT(bvh8_find)(w, q[k].r, &q[k].skip, h, NULL);
        if (p.alone[k] || half < 0) continue;
        EIGHT(packet_settle)(w, w->patch[half / 2].index[half % 2], any, &q[k]);
        limit[k] = !q[k].met ? FLT_MAX : any ? -INFINITY : (float)(q[k].h.t * w->frame.scale);
    }
    LANES_WHOLE may = LANES_ALL_WHOLE(0);  /* how many halves may come before that */
    for (int k = 0; k < (int)w->patches; k++)
        for (int h = 0; h < (int)w->patch[k].items; h++)
            may -= (LANES_WHOLE)(at[2 * k + h] <= limit);
    for (int k = 0; k < n; k++)
        for (int i = 0; may[k] > 1 && i < 2 * (int)w->patches; i++) {
            const bvh8_patch *b = &w->patch[i / 2];
            if (i % 2 < (int)b->items && i != near.half[k] && at[i][k] <= limit[k])
                EIGHT(packet_settle)(w, b->index[i % 2], any, &q[k]);
        }
}

/* One by one where going together doesn't pay: fewer than three rays, or more patches than measured
 * (MEASURED.md, Rays together): 48 with AVX-512, 32 with AVX2. Plain C may have no registers for
 * eight floats. */
EIGHT_TARGET
static void EIGHT(bvh8_row)(const bvh8 *w, bvh8_query *q, int n, bool any)
{
    const bool few = w->patch && w->patches <= (EIGHT_DIALECT == 0 ? 8 : 16 + 2 * LANES_N);
    int k = 0;
    for (; few && n - k > 2; k += LANES_N)
        EIGHT(bvh8_packet)(w, q + k, n - k < LANES_N ? n - k : LANES_N, any);
    for (; k < n; k++)
        q[k].met = EIGHT(bvh8_find)(w, q[k].r, &q[k].skip, any ? NULL : &q[k].h, NULL);
}
