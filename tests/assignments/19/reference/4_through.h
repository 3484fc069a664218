/* The ray that leaves a ball of refractive index n2, in a medium of index n1, after it has come
 * in and gone out once (what is reflected at either place is left out). Writes its origin, on
 * the ball, and its direction, of length 1; tmin 0, tmax infinity. r begins outside; d has any
 * length. False, and out untouched, if r misses the ball (in its interval), or nothing gets in
 * (n1 > n2). */
static inline bool through_glass_ball(sphere ball, real n1, real n2, ray r, ray *out)
{
    hit h;
    vec3 d = vunit(r.d), in, w;
    if (!first_sphere_hit(ball, r, &h)) return false;
    vec3 p = ray_at(r, h.t), n = first_sphere_normal(ball, p);
    if (!first_refract(d, n, n1, n2, &in)) return false;

    /* The chord: from p, -2 n . in times the radius long. */
    vec3 q = vmadd(p, in, -2 * ball.r * vdot(n, in)), m = first_sphere_normal(ball, q);
    if (!first_refract(in, vneg(m), n2, n1, &w)) return false;
    *out = ray_from(q, w);
    return true;
}
