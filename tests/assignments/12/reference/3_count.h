static inline void kd_count_below(const first_kdtree *t, const first_kd_node *node, ray r, real t0,
                                  real t1, bool *seen, int *n, real *last)
{
    if (node->axis < 0) {
        for (int i = 0; i < node->n; i++) {
            hit h;
            if (seen[node->item[i]]) continue;
            seen[node->item[i]] = true;
            if (!first_triangle_hit(t->m->tri[node->item[i]], r, &h)) continue;
            *last = *n == 0 ? h.t : real_max(*last, h.t);
            ++*n;
        }
        return;
    }
    real o = vaxis(r.o, node->axis), d = vaxis(r.d, node->axis), cross = (node->plane - o) / d;
    int near = d > 0 ? 0 : 1;
    if (d == 0) {
        kd_count_below(t, &node->child[o > node->plane], r, t0, t1, seen, n, last);
        return;
    }
    if (t0 <= cross)
        kd_count_below(t, &node->child[near], r, t0, real_min(cross, t1), seen, n, last);
    if (cross <= t1)
        kd_count_below(t, &node->child[1 - near], r, real_max(cross, t0), t1, seen, n, last);
}

/* How many triangles does the ray hit in [r.tmin, r.tmax]? (So parity can tell inside from
 * outside, 7.2, by a tree.) *last: t of the farthest of these hits; if there is none it is left as
 * it was. A triangle may be in several leaves, and counts once. It counts if it is in a leaf that
 * the ray passes, be it only at an edge (t0 <= t1: that is the rule of first_kd_visit, where no
 * hit shortens the ray), wherever its hit lies, in that cell or not. */
static inline int kd_count(const first_kdtree *t, ray r, real *last)
{
    int n = 0;
    real t0, t1;
    r.d = vadd(r.d, vec(0, 0, 0));
    first_slabs(t->box, r, &t0, &t1);
    t0 = real_max(t0, r.tmin), t1 = real_min(t1, r.tmax);
    bool *seen = allocate((size_t)t->m->n, sizeof(bool));
    if (t0 <= t1) kd_count_below(t, &t->root, r, t0, t1, seen, &n, last);
    free(seen);
    return n;
}
