static inline real kd_cut_cost(aabb cell, int axis, real plane, int below, int above, kd_costs c)
{
    aabb L = {cell.lo, first_kd_moved(cell.hi, axis, plane)};
    aabb R = {first_kd_moved(cell.lo, axis, plane), cell.hi};
    real C = c.step + c.test * (aabb_area(L) * (real)below + aabb_area(R) * (real)above)
                      / aabb_area(cell);
    return below == 0 || above == 0 ? (1 - c.bonus) * C : C;
}

/* The cheapest plane for a cell with n boxes of triangles in it (1 to 1000, all within the cell).
 * Candidates are the two sides of each box along each axis, if they lie within the cell and not on
 * its own side. A box is in the lower part if it begins below the plane, in the upper one if it
 * ends above it; so one that is cut is in both. Those that lie in the plane itself (flat, lo = hi =
 * plane) all go to the one part that makes the cut cheaper. With A the surfaces, the cost is
 *     C = c.step + c.test (A_L n_L + A_R n_R) / A                                        (12.1)
 * and (1 - c.bonus) C where one part holds nothing. True, and the cheapest plane in *axis and
 * *plane, and *left, do boxes in the plane go to the lower part (of no meaning if there are none),
 * if it is cheaper than the leaf, c.test n; else false, and all three are left as they were. Of
 * equal costs any will do. False if A is 0. */
static inline bool kd_cut(aabb cell, const aabb *box, int n, kd_costs c, int *axis, real *plane,
                          bool *left)
{
    real best = c.test * (real)n;
    bool found = false;
    if (!(aabb_area(cell) > 0)) return false;
    for (int i = 0; i < 6 * n; i++) {
        int k = i % 3, below = 0, above = 0, flat = 0;
        real p = vaxis(i / 3 % 2 ? box[i / 6].hi : box[i / 6].lo, k);
        if (!(p > vaxis(cell.lo, k) && p < vaxis(cell.hi, k))) continue;
        for (int j = 0; j < n; j++) {
            real lo = vaxis(box[j].lo, k), hi = vaxis(box[j].hi, k);
            if (lo == p && hi == p) flat++;
            else below += lo < p, above += hi > p;
        }
        for (int side = 0; side < 2; side++) {
            real C = kd_cut_cost(cell, k, p, below + (side ? flat : 0), above + (side ? 0 : flat),
                                 c);
            if (C < best) best = C, *axis = k, *plane = p, *left = side, found = true;
        }
    }
    return found;
}
