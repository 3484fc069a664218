static inline void bvh_two_below(const first_bvh *b, int i, ray r, hit best[2], int *n)
{
    const first_bvh_node *node = &b->node[i];
    real t_enter, far = *n == 2 ? best[1].t : r.tmax;
    if (!first_aabb_hit(node->box, r, &t_enter) || t_enter > far) return;
    if (node->left != 0) {
        bool down = vaxis(r.d, node->axis) < 0;
        bvh_two_below(b, down ? node->right : node->left, r, best, n);
        bvh_two_below(b, down ? node->left : node->right, r, best, n);
        return;
    }
    for (int k = node->first; k < node->first + node->n; k++) {
        hit h;
        if (!first_triangle_hit(b->m->tri[b->order[k]], r, &h)) continue;
        h.shape = (uint32_t)b->order[k];
        int at = *n;
        while (at > 0 && (h.t < best[at - 1].t
                          || (h.t == best[at - 1].t && h.shape < best[at - 1].shape))) at--;
        if (at == 2) continue;
        if (at == 0) best[1] = best[0];
        best[at] = h;
        if (*n < 2) ++*n;
    }
}

/* The two closest hits in [r.tmin, r.tmax], the closer one first; each with t, u, v and the
 * number of its triangle (`shape`). Returns how many there are, 0, 1 or 2, and leaves the rest
 * of `out` as it was. Triangles that are hit at the same t all count, those of lower number
 * first. A node is left out if the ray misses its box (first_aabb_hit), or enters it beyond
 * tmax, or beyond the second of two hits that are known; of two children the one that (14.1)
 * calls nearer comes first. */
static inline int bvh_two(const first_bvh *b, ray r, hit out[2])
{
    hit best[2] = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    int n = 0;
    r.d = vadd(r.d, vec(0, 0, 0));
    bvh_two_below(b, 0, r, best, &n);
    for (int i = 0; i < n; i++) out[i] = best[i];
    return n;
}
