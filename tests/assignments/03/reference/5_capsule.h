/* A capsule: all points that are at most R from the segment a b (a may be b: then it is a ball).
 * Where a ray meets its surface: the entry, or, if that is not in [tmin, tmax], the exit. False,
 * and t untouched, on a miss. The ray may run along the segment. */
static inline bool capsule_hit(vec3 a, vec3 b, real R, ray r, real *t)
{
    vec3 e = vsub(b, a), s = vsub(r.o, a);
    real ee = vdot(e, e), t0, t1, in = real_infinity, out = -real_infinity;

    /* It is the union of two balls and a cylinder's part between: from the first entry of them
     * to the last exit, since it is convex. */
    const vec3 end[2] = {a, b};
    for (int k = 0; k < 2; k++)
        if (first_sphere_roots((sphere){end[k], R}, r, &t0, &t1))
            in = real_min(in, t0), out = real_max(out, t1);
    if (ee > 0) {
        /* Without their parts along e, s and d meet a circle of radius R. */
        vec3 f = vmadd(s, e, -vdot(s, e) / ee), d = vmadd(r.d, e, -vdot(r.d, e) / ee);
        if (first_sphere_roots((sphere){{0, 0, 0}, R}, ray_from(f, d), &t0, &t1)) {
            real at0 = vdot(vmadd(s, r.d, t0), e), at1 = vdot(vmadd(s, r.d, t1), e);
            if (at0 >= 0 && at0 <= ee) in = real_min(in, t0);
            if (at1 >= 0 && at1 <= ee) out = real_max(out, t1);
        }
    }
    if (!(in <= out)) return false;
    real hit_at = ray_covers(r, in) ? in : out;
    if (!ray_covers(r, hit_at)) return false;
    *t = hit_at;
    return true;
}
