/* One sample of the direct light of a lamp that is a ball, number `lamp` of the scene, which
 * shines with m.ke on all sides: like first_direct_by_lamp, but by a direction, drawn evenly
 * from the cone in which the ball is seen from x, of half angle m with sin m = R / |c - x|:
 *     p = 1 / (2 pi (1 - cos m))
 * Only what a shadow ray from x reaches counts, to the first point of the ball in this
 * direction; [eps, 1 - eps] of the way. x is outside of the ball. It has to hold for balls of
 * any size that are seen from any distance: 1 - cos m of a star is no difference of two numbers
 * near 1. */
static inline vec3 direct_by_ball(const first_scene *s, int lamp, first_point x,
                                  random_stream *random)
{
    const first_thing *y = &s->thing[lamp];
    real u = random_next(random), v = random_next(random);
    vec3 to = vsub(y->ball.c, x.p);
    real d = vlength(to), sine = y->ball.r / d, sine2 = sine * sine;
    real cosine = sqrt(real_max(1 - sine2, 0)), versine = sine2 / (1 + cosine);

    /* 1 - cos a is even in [0, 1 - cos m]; sin a follows without a difference near 1. */
    real one_minus = u * versine, a = 1 - one_minus, sin_a = sqrt(one_minus * (2 - one_minus));
    vec3 wi = directed(vunit(to), vec(sin_a * cos(2 * pi * v), sin_a * sin(2 * pi * v), a));
    real cos_x = vdot(x.n, wi);
    if (cos_x <= 0) return vec(0, 0, 0);

    /* The nearer point of the ball: d cos a - sqrt(R^2 - d^2 sin^2 a). */
    real across = d * sin_a, half = sqrt(real_max(y->ball.r * y->ball.r - across * across, 0));
    real t = d * a - half;
    if (first_occluded(s, (ray){x.p, s->eps * t, wi, t * (1 - s->eps)})) return vec(0, 0, 0);
    return vscale(vmul(x.kd, y->m.ke), cos_x * 2 * versine);
}
