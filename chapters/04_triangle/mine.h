/* mine.h: a triangle test to begin your own with. Copy it, change it, and put it beside the others:
 *     make mine-04 MINE=my.h
 * It must be called mine_triangle_hit; the types of first.h (01 and 04) are there without #include.
 * True if the ray meets the triangle at a t in [tmin, tmax]; then *out = {t, u, v, 0}. */
/* The plane, and then three cross products: on which side of each edge is p? */
static inline bool mine_triangle_hit(triangle tri, ray r, hit *out)
{
    vec3 n = vcross(vsub(tri.b, tri.a), vsub(tri.c, tri.a));
    real t = vdot(vsub(tri.a, r.o), n) / vdot(r.d, n);
    if (!(t >= r.tmin && t <= r.tmax)) return false;
    vec3 p = ray_at(r, t);
    real w = vdot(n, vcross(vsub(tri.c, tri.b), vsub(p, tri.b)));
    real u = vdot(n, vcross(vsub(tri.a, tri.c), vsub(p, tri.c)));
    real v = vdot(n, vcross(vsub(tri.b, tri.a), vsub(p, tri.a)));
    if (!(w >= 0 && u >= 0 && v >= 0)) return false;
    *out = (hit){t, u / vdot(n, n), v / vdot(n, n), 0};
    return true;
}
