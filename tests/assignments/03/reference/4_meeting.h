/* Two balls move: at time t their centres are a.c + t v and b.c + t w. The first time in [0, 1] at
 * which they touch or overlap; 0 if they do at the beginning. v and w may be equal. False, and t
 * untouched, if they never do. */
static inline bool spheres_meet(sphere a, vec3 v, sphere b, vec3 w, real *t)
{
    /* Seen from b: a point that moves, and a ball with both radii. */
    ray r = {a.c, 0, vsub(v, w), 1};
    sphere both = {b.c, a.r + b.r};
    vec3 f = vsub(a.c, b.c);
    real t0, t1;
    if (vdot(f, f) <= both.r * both.r) return *t = 0, true;
    if (vzero(r.d) || !first_sphere_roots(both, r, &t0, &t1) || !ray_covers(r, t0)) return false;
    *t = t0;
    return true;
}
