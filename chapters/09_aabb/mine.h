/* mine.h: a box test to begin your own with. Copy it, change it, and put it beside the others:
 *     make mine-09 MINE=my.h
 * It must be called mine_aabb_hit; the types of first.h (01 and 09) are there without #include.
 * True if box and ray have a point in common at a t in [tmin, tmax]; *t_enter: the first such t. */
/* The slabs of the axes one after another: what is left of the interval? */
static inline bool mine_aabb_hit(aabb b, ray r, real *t_enter)
{
    for (int k = 0; k < 3; k++) {
        real lo, hi;
        first_slab(vaxis(b.lo, k), vaxis(b.hi, k), vaxis(r.o, k), vaxis(r.d, k), &lo, &hi);
        r.tmin = lo > r.tmin ? lo : r.tmin;
        r.tmax = hi < r.tmax ? hi : r.tmax;
    }
    *t_enter = r.tmin;
    return r.tmin <= r.tmax;
}
