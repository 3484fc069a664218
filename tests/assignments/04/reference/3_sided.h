/* The triangle as first_triangle_hit meets it, but only from some sides: side_front, side_back,
 * or side_both, the sum of the two. The front is the side from which a, b, c go round
 * counter-clockwise (a ray that arrives there goes against first_triangle_normal). Borders count
 * on every side that is asked for. t, u, v are the same whichever side is met; out is untouched
 * on a miss. */
static inline bool triangle_hit_sided(triangle tri, ray r, int side, hit *out)
{
    hit h;
    if (!first_triangle_hit(tri, r, &h)) return false;
    vec3 n = vcross(vsub(tri.b, tri.a), vsub(tri.c, tri.a));
    int met = vdot(n, r.d) < 0 ? side_front : side_back;
    if (!(met & side)) return false;
    *out = h;
    return true;
}
