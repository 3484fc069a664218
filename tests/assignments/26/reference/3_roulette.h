/* What the eye sees along r, by one direction a hit (first_bounce), without light samples: each
 * hit adds its emission (first_emitted), multiplied by the throughput beta so far. beta is
 * (1,1,1) at the first hit, and each bounce multiplies it by kd.
 *
 * After hit number k = 1, 2, ... beta is multiplied by kd of that hit. Then, if k > rule.sure,
 * the path goes on with the probability
 *     q = the largest component of beta, at least rule.lo, at most rule.hi      (0 < lo <= hi <= 1)
 * and beta is divided by it, so that on average nothing changes; else it ends. It also ends
 * where it leaves the scene. Writes the number of hits. No recursion is needed. */
static inline vec3 path_roulette(const first_scene *s, ray r, roulette_rule rule,
                                 random_stream *random, int *hits)
{
    vec3 L = vec(0, 0, 0), beta = vec(1, 1, 1);
    hit h;
    for (*hits = 0; first_scene_hit(s, r, &h); ) {
        first_point x = first_point_at(s, r, h);
        ++*hits;
        L = vadd(L, vmul(beta, first_emitted(x)));
        beta = vmul(beta, x.kd);
        if (*hits > rule.sure) {
            real q = real_max(beta.x, real_max(beta.y, beta.z));
            q = real_clamp(q, rule.lo, rule.hi);
            if (random_next(random) >= q) break;
            beta = vscale(beta, 1 / q);
        }
        r = first_bounce(s, x, random);
    }
    return L;
}
