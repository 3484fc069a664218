static inline int kd_leaves_below(const first_kd_node *node, ray r, real t0, real t1, int most,
                                  int n, int *leaf, real *exit)
{
    if (n == most || !(t0 < t1)) return n;
    if (node->axis < 0) {
        leaf[n] = node->number, exit[n] = t1;
        return n + 1;
    }
    real o = vaxis(r.o, node->axis), d = vaxis(r.d, node->axis);
    if (d == 0)
        return kd_leaves_below(&node->child[o > node->plane], r, t0, t1, most, n, leaf, exit);
    int near = d > 0 ? 0 : 1;
    real cross = (node->plane - o) / d;
    n = kd_leaves_below(&node->child[near], r, t0, real_min(cross, t1), most, n, leaf, exit);
    return kd_leaves_below(&node->child[1 - near], r, real_max(cross, t0), t1, most, n, leaf, exit);
}

/* The leaves that the ray passes, in the order in which it does: their numbers (`number`) to
 * leaf[0], leaf[1], .., and the t at which it leaves each to exit[0], exit[1], .. Returns how many;
 * after `most` of them (>= 1) it does not go on. The ray is in the tree from t_enter to t_exit of
 * its box (9.2), as far as that lies in [r.tmin, r.tmax]; where it is in a leaf is (12.5). A leaf
 * counts where that is an interval of positive length: an edge or a corner of its cell is no part
 * of the way. A ray along the plane of a node (d = 0, or -0) is below it if it does not run above.
 * Triangles are not asked. */
static inline int kd_leaves(const first_kdtree *t, ray r, int most, int *leaf, real *exit)
{
    real t0, t1;
    r.d = vadd(r.d, vec(0, 0, 0));
    first_slabs(t->box, r, &t0, &t1);
    return kd_leaves_below(&t->root, r, real_max(t0, r.tmin), real_min(t1, r.tmax), most, 0, leaf,
                           exit);
}
