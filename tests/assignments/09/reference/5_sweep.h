/* Box a moves: at time t it is a + t v. Between which times of [0, 1] does it touch or overlap
 * the box b, which stands still? Both are closed: contact counts, of faces, edges and corners. v
 * may have components 0, or be (0,0,0); boxes may be flat. False, and t0 and t1 untouched, if
 * never. */
static inline bool aabb_sweep(aabb a, vec3 v, aabb b, real *t0, real *t1)
{
    /* Seen from a: b grown by a's size, and a point that moves. It has to be in all three slabs. */
    real first = 0, last = 1;
    for (int k = 0; k < 3; k++) {
        real d = vaxis(v, k), lo = vaxis(b.lo, k) - vaxis(a.hi, k);
        real hi = vaxis(b.hi, k) - vaxis(a.lo, k);
        if (d == 0) {
            if (lo > 0 || hi < 0) return false;
            continue;
        }
        first = real_max(first, (d > 0 ? lo : hi) / d);
        last = real_min(last, (d > 0 ? hi : lo) / d);
    }
    if (!(first <= last)) return false;
    *t0 = first, *t1 = last;
    return true;
}
