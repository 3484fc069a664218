/* mine.h: a sphere test to begin your own with. Copy it, change it, and put it beside the others:
 *     make mine-03 MINE=my.h
 * It must be called mine_sphere_hit; the types of first.h (01 and 03) are there without #include.
 * True if the ray meets the sphere at a t in [tmin, tmax]; *out = {t, 0, 0, 0} of the first. */
/* By a drawing: along the unit direction to the middle of the chord, then half of it back. */
static inline bool mine_sphere_hit(sphere s, ray r, hit *out)
{
    real length = vlength(r.d);
    vec3 d = vscale(r.d, 1 / length), to_centre = vsub(s.c, r.o);
    real middle = vdot(to_centre, d);
    real half2 = s.r * s.r - (vdot(to_centre, to_centre) - middle * middle);
    if (!(half2 >= 0)) return false;
    real t = (middle - sqrt(half2)) / length;
    if (!ray_covers(r, t)) t = (middle + sqrt(half2)) / length;
    if (!ray_covers(r, t)) return false;
    *out = (hit){t, 0, 0, 0};
    return true;
}
