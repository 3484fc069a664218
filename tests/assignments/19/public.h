/* Checks of assignment 19 that the student has. Refraction by angles, in the plane of d and n;
 * Fresnel's equations by sines and tangents; series by adding up. */
#ifndef PUBLIC_19_H
#define PUBLIC_19_H
#include "exam.h"

/* d at an angle to n, in a plane of its own. */
static question ask_directions(random_stream *g, int i)
{
    question q;
    (void)i;
    memset(&q, 0, sizeof q);
    vec3 s, t;
    q.n = vunit(exam_vector(g, 1));
    if (vzero(q.n)) q.n = vec(0, 0, 1);
    vbasis(q.n, &s, &t);
    real angle = exam_between(g, 0.05, 1.5), turn = exam_between(g, 0, 6);
    vec3 side = vadd(vscale(s, cos(turn)), vscale(t, sin(turn)));
    q.d = vadd(vscale(q.n, -cos(angle)), vscale(side, sin(angle)));
    q.n1 = exam_between(g, 1, 2.5), q.n2 = exam_between(g, 1, 2.5);
    return q;
}

static bool same(vec3 a, vec3 b) { return vlength(vsub(a, b)) <= 1e-9; }

static bool mark_refract(const question *q, const answer *a, char why[exam_why])
{
    vec3 along = vsub(q->d, vscale(q->n, vdot(q->d, q->n)));
    real flat = vlength(along), sine = q->n1 * flat / q->n2, ci = -vdot(q->d, q->n);
    vec3 r = vadd(along, vscale(q->n, ci));
    if (!same(a->v, r))
        return exam_say(why, "angle %.4g degrees: reflected (%g, %g, %g), yours (%g, %g, %g)",
                        (double)(acos(ci) * 180 / pi), r.x, r.y, r.z, a->v.x, a->v.y, a->v.z);
    if (fabs(sine - 1) < 1e-9) return true;
    if (a->is != (sine < 1))
        return exam_say(why, "n1 = %g, n2 = %g, sin i = %g: sin t = %g: %s, yours %s", q->n1, q->n2,
                        flat, sine, sine < 1 ? "goes through" : "total reflection",
                        a->is ? "through" : "total");
    if (!a->is) return a->w.x == -77 || exam_say(why, "in total reflection *w stays as it was");
    real angle = asin(sine);
    vec3 w = vsub(flat > 0 ? vscale(along, sin(angle) / flat) : along, vscale(q->n, cos(angle)));
    return same(a->w, w)
           || exam_say(
               why,
               "n1 = %g, n2 = %g, angle %.4g to %.4g degrees: (%g, %g, %g), yours (%g, %g, %g)",
               q->n1, q->n2, (double)(asin(flat) * 180 / pi), (double)(angle * 180 / pi), w.x, w.y,
               w.z, a->w.x, a->w.y, a->w.z);
}

/* R by angles: rs = sin (t - i) / sin (t + i), rp = tan (i - t) / tan (i + t). */
static real due_fresnel(real ci, real n1, real n2)
{
    real i = acos(ci), t = asin(real_min(n1 * sin(i) / n2, 1));
    if (n1 * sin(i) >= n2) return 1;
    if (i < 1e-4) return (n1 - n2) * (n1 - n2) / ((n1 + n2) * (n1 + n2));
    real rs = sin(t - i) / sin(t + i), rp = tan(i - t) / tan(i + t);
    return (rs * rs + rp * rp) / 2;
}

static question ask_fresnel(random_stream *g, int i)
{
    question q;
    memset(&q, 0, sizeof q);
    q.n1 = i % 2 ? 1 : exam_between(g, 1.1, 2.4), q.n2 = i % 2 ? exam_between(g, 1.1, 2.4) : 1;
    do {
        q.ci = exam_between(g, 0.1, 0.99);
        q.ct = 1 - q.n1 * q.n1 / (q.n2 * q.n2) * (1 - q.ci * q.ci);
    } while (q.ct < 0.01);
    q.ct = sqrt(q.ct);
    return q;
}

static bool mark_fresnel(const question *q, const answer *a, char why[exam_why])
{
    real due = due_fresnel(q->ci, q->n1, q->n2);
    return exam_near(a->x, due, 1e-9)
           || exam_say(why, "n1 = %g, n2 = %g, cos i = %g: R = %.9g, yours %.9g", q->n1, q->n2,
                       q->ci, due, a->x);
}

static question ask_pane(random_stream *g, int i)
{
    question q;
    (void)i;
    memset(&q, 0, sizeof q);
    q.n2 = exam_between(g, 1.1, 2.4), q.ci = exam_between(g, 0.1, 0.99), q.T = 1;
    return q;
}

/* The light is followed from face to face until nothing is left. */
static bool mark_pane(const question *q, const answer *a, char why[exam_why])
{
    double R = (double)due_fresnel(q->ci, 1, q->n2), T = (double)q->T, back = R, out = 0;
    double inside = 1 - R;
    for (int i = 0; i < 100000 && inside > 1e-14; i++) {
        inside *= T;
        if (i % 2) back += inside * (1 - R);
        else out += inside * (1 - R);
        inside *= R;
    }
    return (exam_near(a->x, back, 1e-8) && exam_near(a->y, out, 1e-8))
           || exam_say(why,
                       "n = %g, cos i = %g, T = %g: %.9g comes back, %.9g gets through; yours %.9g "
                       "and %.9g",
                       q->n2, q->ci, q->T, back, out, a->x, a->y);
}

/* A ball of glass, and a ray that meets it two times in three. */
static question ask_ball(random_stream *g, int i)
{
    question q;
    memset(&q, 0, sizeof q);
    q.ball = (sphere){exam_vector(g, 3), exam_between(g, 0.5, 2)};
    vec3 w = vunit(exam_vector(g, 1)), s, t;
    if (vzero(w)) w = vec(0, 0, 1);
    vbasis(w, &s, &t);
    real beside = i % 3 == 2 ? exam_between(g, 1.02, 2) : exam_between(g, 0.01, 0.95);
    real turn = exam_between(g, 0, 6), stretch = exam_between(g, 0.2, 3);
    vec3 off = vadd(vscale(s, cos(turn)), vscale(t, sin(turn)));
    vec3 aim = vmadd(q.ball.c, off, q.ball.r * beside);
    q.r = ray_from(vmadd(aim, w, -exam_between(g, 3, 6)), vscale(w, stretch));
    q.n1 = 1, q.n2 = exam_between(g, 1.1, 2.4);
    return q;
}

/* In the plane of the ray and the centre, by angles only: it turns by 2 (i - t) towards the
 * middle, and leaves where it has gone round the ball by pi - 2 t. */
static bool mark_through(const question *q, const answer *a, char why[exam_why])
{
    vec3 d = vunit(q->r.d), to = vsub(q->r.o, q->ball.c), off = vmadd(to, d, -vdot(to, d));
    real sine = vlength(off) / q->ball.r, other = q->n1 * sine / q->n2;
    real in = -vdot(to, d) - sqrt(real_max(1 - sine * sine, 0)) * q->ball.r;
    bool due = sine < 1 && other < 1 && in <= q->r.tmax * vlength(q->r.d) && in >= 0;
    if (fabs(sine - 1) < 1e-9 || fabs(other - 1) < 1e-9) return true;
    if (due != a->is) return exam_say(why, "sin i = %g, sin t = %g: %s, yours %s", sine, other,
                                      due ? "a ray is due" : "none is", a->is ? "is one" : "none");
    if (!due) return a->w.x == -77 || exam_say(why, "out has to stay as it was");
    real i = asin(sine), t = asin(other), turn = 2 * (i - t), round = 2 * t - i;
    vec3 e = sine > 0 ? vscale(off, 1 / vlength(off)) : vec(0, 0, 0);
    vec3 w = vsub(vscale(d, cos(turn)), vscale(e, sin(turn)));
    vec3 p = vadd(q->ball.c, vscale(vadd(vscale(d, cos(round)), vscale(e, sin(round))), q->ball.r));
    if (!same(a->v, p))
        return exam_say(
            why, "n2 / n1 = %g, sin i = %g: it leaves at (%g, %g, %g), yours at (%g, %g, %g)",
            q->n2 / q->n1, sine, p.x, p.y, p.z, a->v.x, a->v.y, a->v.z);
    return same(a->w, w)
           || exam_say(why, "n2 / n1 = %g, sin i = %g: d is (%g, %g, %g), yours (%g, %g, %g)",
                       q->n2 / q->n1, sine, w.x, w.y, w.z, a->w.x, a->w.y, a->w.z);
}

/* The two balls of 19, seen from anywhere before them. */
static question ask_scene(random_stream *g, int i)
{
    question q;
    (void)i;
    memset(&q, 0, sizeof q);
    q.s = first_two_balls();
    vec3 from = vec(exam_between(g, -3, 3), exam_between(g, 0.5, 4), exam_between(g, 5, 8));
    vec3 to = vec(exam_between(g, -2.5, 2.5), exam_between(g, 0.1, 2), exam_between(g, -1, 1.5));
    q.r = first_ray_unit(ray_from(from, vsub(to, from)));
    q.least = exam_between(g, 0.01, 0.3);
    return q;
}

typedef struct { ray r; vec3 weight; } weighted_ray;

/* The tree of rays with a list of those that are still to be sent. What a surface shows itself
 * counts by its weight at once. Returns the light; *sent: how many rays. */
static vec3 due_weight(const question *q, int *sent)
{
    weighted_ray list[256] = {{q->r, {1, 1, 1}}};
    int n = 1;
    vec3 L = vec(0, 0, 0);
    for (*sent = 0; n > 0; ) {
        weighted_ray now = list[--n];
        hit h;
        ++*sent;
        if (!first_scene_hit(&q->s, now.r, &h)) {
            L = vadd(L, vmul(now.weight, first_background(&q->s, now.r.d)));
            continue;
        }
        first_point x = first_point_at(&q->s, now.r, h);
        real n1 = x.inside ? x.m->ior : 1, n2 = x.inside ? 1 : x.m->ior, R = x.m->ior != 0;
        L = vadd(L, vmul(now.weight, first_shade(&q->s, x)));
        ray next = {x.p, q->s.eps, first_reflect(now.r.d, x.n), real_infinity}, in = next;
        if (x.m->ior != 0 && first_refract(now.r.d, x.n, n1, n2, &in.d))
            R = first_fresnel(-vdot(now.r.d, x.n), -vdot(in.d, x.n), n1, n2);
        weighted_ray child[3] = {{next, vmul(now.weight, x.m->mirror)},
                                 {next, vscale(now.weight, R)},
                                 {in, vscale(now.weight, x.m->ior != 0 ? 1 - R : 0)}};
        for (int k = 0; k < 3 && n < 250; k++) {
            vec3 w = child[k].weight;
            if (real_max(w.x, real_max(w.y, w.z)) >= q->least) list[n++] = child[k];
        }
    }
    return L;
}

static bool mark_weight(const question *q, const answer *a, char why[exam_why])
{
    int rays;
    vec3 L = due_weight(q, &rays);
    if (rays != a->rays)
        return exam_say(why, "least %.4g: %d rays are due, yours %d", q->least, rays, a->rays);
    return vlength(vsub(a->v, L)) <= 1e-9 * (1 + vlength(L))
           || exam_say(why, "least %.4g, %d rays: (%g, %g, %g), yours (%g, %g, %g)", q->least, rays,
                       L.x, L.y, L.z, a->v.x, a->v.y, a->v.z);
}

static const exam_check public_checks[] = {
    {1, "reflected and refracted", 8, false, 400, ask_directions, mark_refract},
    {2, "into glass and out of it", 8, false, 400, ask_fresnel, mark_fresnel},
    {3, "clear glass", 8, false, 400, ask_pane, mark_pane},
    {4, "glass in air", 7, false, 400, ask_ball, mark_through},
    {5, "two balls", 8, false, 600, ask_scene, mark_weight},
};
#endif
