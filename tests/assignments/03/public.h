/* Checks of assignment 03 that the student has. All bodies are convex: along a ray the depth in
 * them has one lowest place. That is found first, by thirds; entry and exit lie on both sides of
 * it, and are found by bisection. No quadratic is solved. */
#ifndef PUBLIC_03_H
#define PUBLIC_03_H
#include "exam.h"

/* Below 0 inside, 0 on the surface, above 0 outside; convex in t. */
typedef real exam_depth(const question *q, real t);
typedef struct { bool met, clear; real in, out; } crossing;

static real bisect(const question *q, exam_depth *f, real inside, real outside)
{
    for (int i = 0; i < 200; i++) {
        real middle = (inside + outside) / 2;
        if (f(q, middle) <= 0) inside = middle;
        else outside = middle;
    }
    return inside;
}

/* Where the line is in the body, t from lo to hi, at whose ends it is not. clear: the lowest
 * depth is `hair` from 0 at least, so that rounding does not decide. */
static crossing find_crossing(const question *q, exam_depth *f, real lo, real hi, double hair)
{
    real a = lo, b = hi;
    for (int i = 0; i < 300; i++) {
        real c = a + (b - a) / 3, d = b - (b - a) / 3;
        if (f(q, c) < f(q, d)) b = d;
        else a = c;
    }
    real t = (a + b) / 2, low = f(q, t);
    crossing x = {low <= 0, fabs(low) > hair, t, t};
    if (x.met) x.in = bisect(q, f, t, lo), x.out = bisect(q, f, t, hi);
    return x;
}

static real sphere_depth(const question *q, real t)
{
    return vlength(vsub(ray_at(q->r, t), q->s.c)) / q->s.r - 1;
}

static real ellipsoid_depth(const question *q, real t)
{
    vec3 p = vsub(ray_at(q->r, t), q->s.c);
    return vlength(vec(p.x / q->radii.x, p.y / q->radii.y, p.z / q->radii.z)) - 1;
}

static real capsule_depth(const question *q, real t)
{
    vec3 e = vsub(q->b, q->a), p = vsub(ray_at(q->r, t), q->a);
    real ee = vdot(e, e), at = ee > 0 ? real_clamp(vdot(p, e) / ee, 0, 1) : 0;
    return vlength(vmadd(p, e, -at)) / q->s.r - 1;
}

static real meeting_depth(const question *q, real t)
{
    vec3 p = vadd(vsub(q->s.c, q->other.c), vscale(vsub(q->v, q->w), t));
    return vlength(p) / (q->s.r + q->other.r) - 1;
}

/* Compares t with the entry, or with the exit if that is the first in the interval. Where rounding
 * decides whether the body or the interval is met, either answer is right. */
static bool mark_crossing(const question *q, const answer *a, exam_depth *f, const char *what,
                          char why[exam_why])
{
    crossing x = find_crossing(q, f, -1000, 1000, 1e-7);
    vec3 o = q->r.o, d = q->r.d;
    real due = ray_covers(q->r, x.in) ? x.in : x.out;
    bool is_due = x.met && ray_covers(q->r, due);
    if (!x.clear || fabs(x.in - q->r.tmin) < 1e-7 || fabs(x.out - q->r.tmax) < 1e-7
        || fabs(x.in - q->r.tmax) < 1e-7 || fabs(x.out - q->r.tmin) < 1e-7) return true;
    if (is_due != a->is)
        return exam_say(why, "%s, o = (%g, %g, %g), d = (%g, %g, %g), t in [%g, %g]: %s, yours %s",
                        what, o.x, o.y, o.z, d.x, d.y, d.z, q->r.tmin, q->r.tmax,
                        is_due ? "a hit" : "none", a->is ? "a hit" : "none");
    if (!is_due) return a->t0 == -77 || exam_say(why, "a miss has to leave t as it was");
    return exam_near(a->t0, due, 1e-7 * (1 + fabs(due)))
           || exam_say(
               why, "%s: in it from t = %.9g to %.9g, interval [%g, %g]: %.9g is due, yours %.9g",
               what, x.in, x.out, q->r.tmin, q->r.tmax, due, a->t0);
}

/* A ball of 0.5 to 2, and a ray from outside that meets it two times in three. */
static question ask_sphere(random_stream *g, int i)
{
    question q;
    memset(&q, 0, sizeof q);
    q.s = (sphere){exam_vector(g, 5), exam_between(g, 0.5, 2)};
    vec3 from, aim = vunit(exam_vector(g, 1));
    do from = exam_vector(g, 10); while (vlength(vsub(from, q.s.c)) < 2.1);
    aim = vmadd(q.s.c, aim, q.s.r * exam_between(g, 0, i % 3 == 2 ? 3 : 0.9));
    q.r = ray_from(from, vscale(vsub(aim, from), exam_between(g, 0.1, 3)));
    return q;
}

static bool mark_roots(const question *q, const answer *a, char why[exam_why])
{
    crossing x = find_crossing(q, sphere_depth, -1000, 1000, 1e-7);
    if (!x.clear) return true;
    if (x.met != a->is)
        return exam_say(why, "the line %s the ball, yours is %s", x.met ? "meets" : "passes beside",
                        a->is ? "true" : "false");
    return !x.met || (exam_near(a->t0, x.in, 1e-7) && exam_near(a->t1, x.out, 1e-7))
           || exam_say(why, "in the ball from t = %.9g to %.9g, yours %.9g and %.9g", x.in, x.out,
                       a->t0, a->t1);
}

static bool mark_hit(const question *q, const answer *a, char why[exam_why])
{
    if (!mark_crossing(q, a, sphere_depth, "a ball", why)) return false;
    if (!a->is) return true;
    vec3 n = vunit(vsub(ray_at(q->r, a->t0), q->s.c));
    return vlength(vsub(n, a->n)) < 1e-9
           || exam_say(why, "the normal is (%g, %g, %g), yours (%g, %g, %g)", n.x, n.y, n.z, a->n.x,
                       a->n.y, a->n.z);
}

static question ask_ellipsoid(random_stream *g, int i)
{
    question q = ask_sphere(g, i);
    q.radii = vec(exam_between(g, 0.5, 2), exam_between(g, 0.5, 2), exam_between(g, 0.5, 2));
    return q;
}

/* The normal: how the depth grows a little beside the point, along each axis. */
static bool mark_ellipsoid(const question *q, const answer *a, char why[exam_why])
{
    if (!mark_crossing(q, a, ellipsoid_depth, "an ellipsoid", why)) return false;
    if (!a->is) return true;
    vec3 n = vec(0, 0, 0);
    for (int k = 0; k < 3; k++) {
        question beside = *q;
        real step = (real)1e-6 * vaxis(q->radii, k), o = vaxis(q->r.o, k);
        beside.r.o = vwith(q->r.o, k, o + step);
        real up = ellipsoid_depth(&beside, a->t0);
        beside.r.o = vwith(q->r.o, k, o - step);
        n = vwith(n, k, (up - ellipsoid_depth(&beside, a->t0)) / step);
    }
    n = vunit(n);
    return vlength(vsub(n, a->n)) < 1e-6
           || exam_say(why, "the normal is (%.6f, %.6f, %.6f), yours (%.6f, %.6f, %.6f)", n.x, n.y,
                       n.z, a->n.x, a->n.y, a->n.z);
}

static question ask_meeting(random_stream *g, int i)
{
    question q;
    memset(&q, 0, sizeof q);
    q.s = (sphere){exam_vector(g, 4), exam_between(g, 0.3, 1)};
    do q.other = (sphere){exam_vector(g, 4), exam_between(g, 0.3, 1)};
    while (vlength(vsub(q.s.c, q.other.c)) < 2.1);
    q.w = exam_vector(g, 3);
    q.v = i % 3 ? vadd(q.w, vscale(vsub(q.other.c, q.s.c), exam_between(g, 0.3, 2)))
                : exam_vector(g, 3);
    q.v = vadd(q.v, exam_vector(g, 0.3));
    return q;
}

static bool mark_meeting(const question *q, const answer *a, char why[exam_why])
{
    crossing x = find_crossing(q, meeting_depth, -1000, 1000, 1e-7);
    bool now = meeting_depth(q, 0) <= 0, due = now || (x.met && x.in >= 0 && x.in <= 1);
    real t = now ? 0 : x.in;
    if (!now && (!x.clear || fabs(x.in) < 1e-7 || fabs(x.in - 1) < 1e-7)) return true;
    if (due != a->is)
        return exam_say(why, "%s (they are in contact from %g to %g), yours %s", due ? "they meet"
                        : "they do not meet in [0, 1]", x.in, x.out, a->is ? "meet" : "do not");
    if (!due) return a->t0 == -77 || exam_say(why, "t has to stay as it was");
    return exam_near(a->t0, t, 1e-7)
        || exam_say(why, "they meet at %.9g, yours at %.9g", t, a->t0);
}

/* Rays to the middle part of a long capsule, from the side; one in three passes beside it. */
static question ask_capsule(random_stream *g, int i)
{
    question q;
    vec3 w = vunit(exam_vector(g, 1)), s, t;
    memset(&q, 0, sizeof q);
    if (vzero(w)) w = vec(0, 0, 1);
    vbasis(w, &s, &t);
    real half = exam_between(g, 2, 4), far = exam_between(g, 0, i % 3 == 2 ? 2.5 : 0.9);
    vec3 c = exam_vector(g, 3);
    q.a = vmadd(c, w, -half), q.b = vmadd(c, w, half), q.s.r = exam_between(g, 0.3, 1);
    vec3 from = vmadd(c, s, exam_between(g, 3, 6));
    from = vmadd(from, w, exam_between(g, -1, 1));
    vec3 aim = vmadd(vmadd(c, t, far * q.s.r), w, exam_between(g, -1, 1) * half / 3);
    q.r = ray_from(from, vscale(vsub(aim, from), exam_between(g, 0.1, 3)));
    return q;
}

static bool mark_capsule(const question *q, const answer *a, char why[exam_why])
{
    return mark_crossing(q, a, capsule_depth, "a capsule", why);
}

static const exam_check public_checks[] = {
    {1, "both roots, or none", 8, false, 400, ask_sphere, mark_roots},
    {2, "entry and normal", 7, false, 400, ask_sphere, mark_hit},
    {3, "entry and normal", 10, false, 400, ask_ellipsoid, mark_ellipsoid},
    {4, "on their way", 7, false, 400, ask_meeting, mark_meeting},
    {5, "from the side", 8, false, 400, ask_capsule, mark_capsule},
};
#endif
