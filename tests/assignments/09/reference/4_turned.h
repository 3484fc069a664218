/* Where a ray first is in a turned box, closed, as aabb_entry has it: the smallest t of [tmin,
 * tmax], and the unit normal of the face that it comes in through, outward; (0,0,0) if it is in
 * the box at tmin. Half lengths may be 0, d may run along faces and has any length. False, and t
 * and n untouched, on a miss. */
static inline bool turned_box_hit(turned_box b, ray r, real *t, vec3 *n)
{
    const vec3 axis[3] = {b.u, b.v, b.w};
    vec3 s = vsub(r.o, b.c), in = vec(0, 0, 0);
    real enter = r.tmin, leave = r.tmax;
    for (int k = 0; k < 3; k++) {
        real o = vdot(s, axis[k]), d = vdot(r.d, axis[k]), h = vaxis(b.half, k);
        if (d == 0) {
            if (fabs(o) > h) return false;
            continue;
        }
        real side = d > 0 ? 1 : -1, near = (-side * h - o) / d, far = (side * h - o) / d;
        if (near > enter) enter = near, in = vscale(axis[k], -side);
        if (far < leave) leave = far;
    }
    if (!(enter <= leave)) return false;
    *t = enter, *n = in;
    return true;
}
