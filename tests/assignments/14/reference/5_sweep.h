static inline real sweep_ask(sah_costs c, int n)
{
    return c.group * (real)((n + c.lanes - 1) / c.lanes);
}

static inline void sweep_sort(const aabb *box, int n, int axis, int *order)
{
    for (int i = 0; i < n; i++) {
        int at = i;
        real centre = vaxis(box[i].lo, axis) + vaxis(box[i].hi, axis);
        for (; at > 0; at--) {
            aabb before = box[order[at - 1]];
            if (!(centre < vaxis(before.lo, axis) + vaxis(before.hi, axis))) break;
            order[at] = order[at - 1];
        }
        order[at] = i;
    }
}

/* The surface area heuristic without planes: all n - 1 cuts of each axis are tried. Along an
 * axis the boxes are sorted by their centres (those at the same place by number), and the first
 * k of them go left. With S the surface and f(n) = c.group * ceil(n / c.lanes) the cost to ask n
 * triangles, it is
 *     cost = c.box + (S(L) f(k) + S(R) f(n - k)) / S(N),   N the box of all
 * Returns the k of the cheapest cut, its axis in *axis, and in order[0 .. n) the numbers of the
 * boxes as they are sorted along it. Of equal cuts any will do. Returns 0, and leaves order and
 * axis as they were, if no cut is cheaper than a leaf, f(n), and where S(N) is 0. n >= 1, at
 * most 1000. */
static inline int sah_sweep(const aabb *box, int n, sah_costs c, int *order, int *axis)
{
    real right[1001], best = sweep_ask(c, n);
    int sorted[1000], left = 0, best_axis = 0;
    aabb all = aabb_empty();
    for (int i = 0; i < n; i++) all = aabb_union(all, box[i]);
    real S = aabb_area(all);
    if (S == 0) return 0;
    for (int k = 0; k < 3; k++) {
        aabb sum = aabb_empty();
        sweep_sort(box, n, k, sorted);
        for (int i = n - 1; i > 0; i--) {
            sum = aabb_union(sum, box[sorted[i]]);
            right[i] = aabb_area(sum) * sweep_ask(c, n - i);
        }
        sum = aabb_empty();
        for (int i = 1; i < n; i++) {
            sum = aabb_union(sum, box[sorted[i - 1]]);
            real cost = c.box + (aabb_area(sum) * sweep_ask(c, i) + right[i]) / S;
            if (cost < best) best = cost, left = i, best_axis = k;
        }
    }
    if (left == 0) return 0;
    *axis = best_axis;
    sweep_sort(box, n, best_axis, order);
    return left;
}
