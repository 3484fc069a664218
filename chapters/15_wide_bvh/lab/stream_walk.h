/* stream_walk.h: the search of stream.h. Compiled once in each dialect, by dialects.h: no guard. */
EIGHT_TARGET __attribute__((noinline))
static void EIGHT(bvh8_stream)(const bvh8 *w, const ray *r, int n, hit *out, stream_work *work)
{
    const bvh8_skip none = bvh8_skip_none;
    stream_waiting stack[bvh8_stack];
    bvh8_ray q[stream_rays];
    unsigned usable = 0;
    int top = 0;
    for (int i = 0; w->nodes > 0 && i < n; i++)
        usable |= (unsigned)bvh8_ray_of(w, &r[i], &none, &q[i]) << i;
    stack[top++] = (stream_waiting){0, usable, 0};
    while (top > 0) {
        stream_waiting now = stack[--top];
        bool leaf = now.child & bvh8_leaf;
        uint32_t at = now.child & ~bvh8_leaf, rays[8] = {0};
        eight near = EIGHT_ALL(INFINITY), enter;
        work->fetched += !leaf && now.rays;
        for (unsigned left = now.rays; left; left &= left - 1) {
            int i = __builtin_ctz(left);
            if (float_max(q[i].limit, 0) < now.enter) continue;  /* enter: not before 0 */
            if (leaf) {
                EIGHT(bvh8_triangles)(w, &w->block[at], &q[i], false);
                continue;
            }
            eight_set mask = EIGHT(bvh8_boxes)(&w->node[at], &q[i], &enter);
            near = EIGHT_MIN(near, enter);
            work->asked++;
            for (; mask; mask &= mask - 1) rays[EIGHT_FIRST(mask)] |= 1u << i;
        }
        for (int k = 0, base = top; k < 8; k++) {
            if (!rays[k]) continue;
            int j = top++;
            const float t = near[k];
            for (; j > base && stack[j - 1].enter < t; j--) stack[j] = stack[j - 1];
            stack[j] = (stream_waiting){w->node[at].child[k], rays[k], t};
        }
    }
    for (int i = 0; i < n; i++)
        out[i] = usable >> i & 1 && bvh8_settle(w, &q[i]) ? q[i].best : hit_none;
}
