/* first.h: light that has been reflected 0, 1, 2, .. times: L = E + K E + K^2 E + ...    (25.3)
 * Wrong where it stops: what comes after the last term is missing; N rays a hit are N^k rays for
 * the k-th term. terms.h has all terms from one ray a hit; 26 stops without being wrong. */
#ifndef FIRST_BOUNCES_H
#define FIRST_BOUNCES_H
#include "../24_direct_light/first.h"

static long first_bounce_rays;  /* since the program began; to the lamp, too, faces it x or not */

/* K^k E as seen along r: light that was reflected k times on its way from the lamp (thing 0) to the
 * eye. K takes the light that leaves all surfaces to what they reflect of it: each hit sends N rays
 * and asks what they bring of K^(k-1) E; each counts kd / N (24.2). The last reflection asks the
 * lamp (24.4), which directions would seldom find.                                      (25.10) */
static inline vec3 first_term(const first_scene *s, ray r, int k, int N, random_stream *random)
{
    hit h;
    vec3 sum = vec(0, 0, 0);
    first_bounce_rays++;
    if (!first_scene_hit(s, r, &h)) return sum;
    first_point x = first_point_at(s, r, h);
    if (k <= 0) return first_emitted(x);                                                  /* E */
    if (k == 1) first_bounce_rays += N;
    for (int i = 0; i < N; i++)
        sum = vadd(sum, k == 1 ? first_direct_by_lamp(s, 0, x, random)                   /* K E */
                               : vmul(x.kd, first_term(s, first_bounce(s, x, random), k - 1, N,
                                                       random)));
    return vscale(sum, 1.0 / N);
}

/* 1 + N + ... + N^d rays for the d-th term, if none leaves the scene. (One such tree would do for
 * all terms up to it.)                                                                   (25.9) */
static inline double first_rays_of_branching(int N, int d)
{
    double rays = 1, level = 1;
    for (int k = 1; k <= d; k++) rays += level *= N;
    return rays;
}

/* In a furnace (白炉), a closed room whose walls all emit E and reflect rho of what they get, all of
 * this has a closed form: n bounces bring E (1 - rho^(n+1)) / (1 - rho)                  (25.5) */
static inline double first_furnace(double E, double rho, int n)
{
    double sum = 0, term = E;
    for (int k = 0; k <= n; k++, term *= rho) sum += term;
    return sum;
}
#endif
