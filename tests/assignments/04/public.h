/* Checks of assignment 04 that the student has. What is due is known by construction: a point is
 * chosen first, by its weights, and then a ray aimed at it from somewhere. */
#ifndef PUBLIC_04_H
#define PUBLIC_04_H
#include "exam.h"

/* d of a camera ray from its parts along u, v, w, in another order than first.h computes them. */
static vec3 due_direction(const question *q)
{
    const first_camera *c = &q->camera;
    real across = q->x / c->nx, down = q->y / c->ny;
    real u = (1 - across) * c->left + across * c->right, v = (1 - down) * c->top + down * c->bottom;
    return vec(u * c->u.x + v * c->v.x - c->d * c->w.x, u * c->u.y + v * c->v.y - c->d * c->w.y,
               u * c->u.z + v * c->v.z - c->d * c->w.z);
}

static question ask_camera(random_stream *g, int i)
{
    question q = {.side = side_both};
    (void)i;
    vec3 e = exam_vector(g, 5), target = exam_vector(g, 5);
    int nx = 100 + (int)(random_next_bits(g) % 900), ny = 100 + (int)(random_next_bits(g) % 900);
    q.camera = first_camera_at(e, target, vec(0.1, 1, 0.2), exam_between(g, 20, 120), nx, ny);
    q.x = (real)(random_next_bits(g) % (uint64_t)nx) + (real)0.5;
    q.y = (real)(random_next_bits(g) % (uint64_t)ny) + (real)0.5;
    return q;
}

static bool mark_ray(const question *q, const answer *a, vec3 due, char why[exam_why])
{
    vec3 off = vsub(a->r.d, due);
    if (!(vlength(vsub(a->r.o, q->camera.e)) <= 1e-12))
        return exam_say(why, "the ray has to begin in e = (%g, %g, %g), yours in (%g, %g, %g)",
                        q->camera.e.x, q->camera.e.y, q->camera.e.z, a->r.o.x, a->r.o.y, a->r.o.z);
    if (!(vlength(off) <= 1e-12 * (1 + vlength(due))))
        return exam_say(why, "point (%g, %g) of a picture of %d x %d: d is (%.6g, %.6g, %.6g), "
                        "yours (%.6g, %.6g, %.6g)", q->x, q->y, q->camera.nx, q->camera.ny,
                        due.x, due.y, due.z, a->r.d.x, a->r.d.y, a->r.d.z);
    if (!(a->r.tmin == 0 && a->r.tmax == real_infinity))
        return exam_say(why, "the interval is [0, infinity], yours [%g, %g]", a->r.tmin, a->r.tmax);
    return true;
}

static bool mark_camera(const question *q, const answer *a, char why[exam_why])
{
    return mark_ray(q, a, due_direction(q), why);
}

/* A ray from somewhere to the point of weights u, v; d of any length, so t is due at 1 / stretch.
 * More than half of the points lie inside; all are 2 % or more away from the border. */
static question ask_triangle(random_stream *g, int i)
{
    question q = {.side = side_both};
    real u, v, o = (real)0.02;
    do u = exam_between(g, -0.5, 1.5), v = exam_between(g, -0.5, 1.5);
    while (fabs(u) < o || fabs(v) < o || fabs(1 - u - v) < o
           || (i % 2 && (u < 0 || v < 0 || u + v > 1)));
    vec3 n, from, d;
    do {
        q.tri = (triangle){exam_vector(g, 2), exam_vector(g, 2), exam_vector(g, 2)};
        from = exam_vector(g, 6), d = vsub(barycentric_mix(q.tri.a, q.tri.b, q.tri.c, u, v), from);
        n = vcross(vsub(q.tri.b, q.tri.a), vsub(q.tri.c, q.tri.a));
    } while (vlength(n) < 1 || fabs(vdot(vunit(n), vunit(d))) < 0.1 || vlength(d) < 0.5);
    real stretch = exam_between(g, 0.1, 3);
    q.r = ray_from(from, vscale(d, stretch));
    q.is_due = u > 0 && v > 0 && u + v < 1;
    q.due = (hit){1 / stretch, u, v, 0};
    return q;
}

/* Compares a hit with the one that is due, within `bound`; `what` says what was aimed at. */
static bool mark_hit(const question *q, const answer *a, double bound, const char *what,
                     char why[exam_why])
{
    hit h = a->h, due = q->due;
    if (q->is_due && !a->is)
        return exam_say(why, "ray to %s at u = %.6g, v = %.6g: a hit at t = %.6g, yours none", what,
                        due.u, due.v, due.t);
    if (!q->is_due && a->is)
        return exam_say(why, "ray to %s at u = %.6g, v = %.6g: no hit, yours is one at t = %.6g, "
                        "u = %.6g, v = %.6g", what, due.u, due.v, h.t, h.u, h.v);
    if (!a->is) return h.t == -77 || exam_say(why, "a miss has to leave *out as it was");
    if (exam_near(h.t, due.t, bound * (1 + due.t)) && exam_near(h.u, due.u, bound)
        && exam_near(h.v, due.v, bound)) return true;
    return exam_say(why, "ray to %s: due t = %.9g, u = %.9g, v = %.9g, yours %.9g, %.9g, %.9g",
                    what, due.t, due.u, due.v, h.t, h.u, h.v);
}

/* 1e-9: area and cosine are at least 0.5 and 0.1, numbers below 20: some 1e4 roundings. */
static bool mark_triangle(const question *q, const answer *a, char why[exam_why])
{
    return mark_hit(q, a, 1e-9, q->is_due ? "a point of the triangle"
                                          : "a point of the triangle's plane", why);
}

static question ask_sided(random_stream *g, int i)
{
    question q = ask_triangle(g, 2 * i + 1);  /* hits only */
    bool front = vdot(vcross(vsub(q.tri.b, q.tri.a), vsub(q.tri.c, q.tri.a)), q.r.d) < 0;
    q.side = 1 + i % 3;
    q.is_due = (q.side & (front ? side_front : side_back)) != 0;
    return q;
}

static bool mark_sided(const question *q, const answer *a, char why[exam_why])
{
    char what[80];
    const char *sides[4] = {"", "front", "back", "front or back"};
    (void)snprintf(what, sizeof what, "a triangle of which the %s counts,", sides[q->side & 3]);
    return mark_hit(q, a, 1e-9, what, why);
}

/* The angle from the middle is a share of phi / 2, the direction round it is the window's. */
static vec3 due_fisheye(const question *q)
{
    const first_camera *c = &q->camera;
    real x = (2 * q->x - c->nx) / c->ny, y = (c->ny - 2 * q->y) / c->ny;
    real round = atan2(y, x), theta = hypot(x, y) * atan2(c->top, c->d);
    return vec(sin(theta) * (cos(round) * c->u.x + sin(round) * c->v.x) - cos(theta) * c->w.x,
               sin(theta) * (cos(round) * c->u.y + sin(round) * c->v.y) - cos(theta) * c->w.y,
               sin(theta) * (cos(round) * c->u.z + sin(round) * c->v.z) - cos(theta) * c->w.z);
}

/* A picture as wide as high: theta is 85 degrees at most, in a corner. */
static question ask_fisheye(random_stream *g, int i)
{
    question q = ask_camera(g, i);
    q.camera.nx = q.camera.ny;
    q.x = exam_between(g, 0, q.camera.nx);
    return q;
}

/* Beyond theta = pi there is no ray; within rounding of it either answer is right. */
static bool mark_fisheye(const question *q, const answer *a, char why[exam_why])
{
    const first_camera *c = &q->camera;
    real theta = hypot(2 * q->x - c->nx, c->ny - 2 * q->y) / c->ny * atan2(c->top, c->d);
    if (fabs(theta - pi) < 1e-9) return true;
    if (theta > pi)
        return !a->is || exam_say(why, "theta is %g, more than pi: no ray is due", theta);
    if (!a->is) return exam_say(why, "point (%g, %g) of %d x %d: a ray is due, yours is false",
                                q->x, q->y, q->camera.nx, q->camera.ny);
    return mark_ray(q, a, due_fisheye(q), why);
}

/* a, b, c, d = centre -p, +s, +p', -s' with p, s about at right angles: no angle near 180
 * degrees. u and v are drawn; half of them lie outside, by 0.05 to 0.4, where the map is still
 * one to one. */
static question ask_quad(random_stream *g, int i)
{
    question q = {.side = side_both};
    vec3 n = vunit(exam_vector(g, 1)), s, t, at = exam_vector(g, 3), p;
    if (vzero(n)) n = vec(0, 0, 1);
    vbasis(n, &s, &t);
    real k[4];
    for (int m = 0; m < 4; m++) k[m] = exam_between(g, 0.8, 1.6);
    q.a = vmadd(at, s, -k[0]), q.b = vmadd(at, t, -k[1]);
    q.c = vmadd(at, s, k[2]), q.d = vmadd(at, t, k[3]);
    real u = exam_between(g, 0.02, 0.98), v = exam_between(g, 0.02, 0.98);
    bool in = i % 2;
    if (!in && i % 4) u = u < 0.5 ? -u / 4 - (real)0.01 : 1 + u / 4;
    else if (!in) v = v < 0.5 ? -v / 4 - (real)0.01 : 1 + v / 4;
    p = vadd(vadd(vscale(q.a, (1 - u) * (1 - v)), vscale(q.b, u * (1 - v))),
             vadd(vscale(q.c, u * v), vscale(q.d, (1 - u) * v)));
    vec3 from = vadd(p, vscale(n, exam_between(g, 1, 4) * (i % 3 ? 1 : -1)));
    from = vadd(from, vscale(s, exam_between(g, -2, 2)));
    real stretch = exam_between(g, 0.1, 3);
    q.r = ray_from(from, vscale(vsub(p, from), stretch));
    q.is_due = in, q.due = (hit){1 / stretch, u, v, 0};
    return q;
}

static bool mark_quad(const question *q, const answer *a, char why[exam_why])
{
    return mark_hit(q, a, 1e-9, "the quadrangle's plane", why);
}

static const exam_check public_checks[] = {
    {1, "middles of pixels", 5, false, 200, ask_camera, mark_camera},
    {2, "hit or miss; t, u, v", 8, false, 1000, ask_triangle, mark_triangle},
    {3, "front, back, both", 8, false, 600, ask_sided, mark_sided},
    {4, "anywhere in the picture", 8, false, 200, ask_fisheye, mark_fisheye},
    {5, "four different sides", 8, false, 600, ask_quad, mark_quad},
};
#endif
