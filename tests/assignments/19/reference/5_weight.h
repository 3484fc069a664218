/* Like first_whitted, but what ends the tree is not its depth: each ray has a weight, the share
 * of its light that reaches the eye; the eye ray's is given, (1,1,1). A mirrored ray has
 * m.mirror of the weight of the ray that it continues; of glass the reflected one has R of it,
 * the other 1 - R. A ray of whose weight no component reaches `least` is not sent, and brings
 * (0,0,0); the eye ray is always sent. Returns what comes back along r (not multiplied by
 * weight), and adds the number of rays that were sent to *rays, without shadow rays. d is unit.
 * Where R is 1 there is no ray into the glass. */
static inline vec3 whitted_by_weight(const first_scene *s, ray r, vec3 weight, real least,
                                     int *rays)
{
    hit h;
    ++*rays;
    if (!first_scene_hit(s, r, &h)) return first_background(s, r.d);
    first_point x = first_point_at(s, r, h);
    vec3 L = first_shade(s, x), w = vmul(weight, x.m->mirror);
    ray mirrored = {x.p, s->eps, first_reflect(r.d, x.n), real_infinity};
    if (real_max(w.x, real_max(w.y, w.z)) >= least)
        L = vadd(L, vmul(x.m->mirror, whitted_by_weight(s, mirrored, w, least, rays)));
    if (x.m->ior == 0) return L;

    real n1 = x.inside ? x.m->ior : 1, n2 = x.inside ? 1 : x.m->ior, R = 1;
    ray through = {x.p, s->eps, vec(0, 0, 0), real_infinity};
    real most = real_max(weight.x, real_max(weight.y, weight.z));
    if (first_refract(r.d, x.n, n1, n2, &through.d)) {
        R = first_fresnel(-vdot(r.d, x.n), -vdot(through.d, x.n), n1, n2);
        if ((1 - R) * most >= least) {
            vec3 Li = whitted_by_weight(s, through, vscale(weight, 1 - R), least, rays);
            L = vadd(L, vscale(Li, 1 - R));
        }
    }
    if (R * most >= least)
        L = vadd(L, vscale(whitted_by_weight(s, mirrored, vscale(weight, R), least, rays), R));
    return L;
}
