/* Checks of assignment 09 that the student has. Either a point of the box is chosen first and
 * the ray aimed at it; or what is due is the smallest of all times that could be an answer. */
#ifndef PUBLIC_09_H
#define PUBLIC_09_H
#include "exam.h"

static aabb some_box(random_stream *g, double half)
{
    vec3 p = exam_vector(g, half), q = exam_vector(g, half);
    return (aabb){vmin(p, q), vmax(p, q)};
}

static bool in_box(aabb b, vec3 p)
{
    return b.lo.x <= p.x && p.x <= b.hi.x && b.lo.y <= p.y && p.y <= b.hi.y && b.lo.z <= p.z
        && p.z <= b.hi.z;
}

/* From outside, to a point of the box or to one near it. */
static question ask_box(random_stream *g, int i)
{
    question q = {.b = some_box(g, 2)};
    vec3 aim = exam_vector(g, i % 3 == 0 ? 3 : 1), size = vsub(q.b.hi, q.b.lo);
    if (i % 3 == 0) aim = vadd(aim, q.b.lo);
    else aim = vadd(vscale(vadd(q.b.lo, q.b.hi), (real)0.5), vscale(vmul(aim, size), (real)0.45));
    vec3 from;
    do from = exam_vector(g, 6);
    while (in_box(q.b, from));
    q.r = ray_from(from, vscale(vsub(aim, from), exam_between(g, 0.1, 2)));
    vec3 middle = vscale(vadd(q.b.lo, q.b.hi), (real)0.5);
    if (vdot(vsub(middle, from), q.r.d) < 0) q.r.d = vneg(q.r.d);  /* nothing lies behind */
    return q;
}

/* Entry and exit of all three slabs: of each axis the smaller and the larger of two times. */
static void due_slabs(const question *q, real *enter, real *leave)
{
    *enter = -real_infinity, *leave = real_infinity;
    for (int k = 0; k < 3; k++) {
        real a = (vaxis(q->b.lo, k) - vaxis(q->r.o, k)) / vaxis(q->r.d, k);
        real b = (vaxis(q->b.hi, k) - vaxis(q->r.o, k)) / vaxis(q->r.d, k);
        if ((a < b ? a : b) > *enter) *enter = a < b ? a : b;
        if ((a < b ? b : a) < *leave) *leave = a < b ? b : a;
    }
}

static bool near_time(real a, real b)
{
    return a == b || exam_near(a, b, 1e-13 * (1 + fabs(b)));
}

static bool mark_slabs(const question *q, const answer *a, char why[exam_why])
{
    real enter, leave;
    vec3 d = q->r.d;
    due_slabs(q, &enter, &leave);
    return (near_time(a->t0, enter) && near_time(a->t1, leave))
           || exam_say(why, "d = (%g, %g, %g): enters at %.9g, leaves at %.9g, yours %.9g and %.9g",
                       d.x, d.y, d.z, enter, leave, a->t0, a->t1);
}

static bool mark_box(const question *q, const answer *a, char why[exam_why])
{
    real enter, leave;
    vec3 o = q->r.o, d = q->r.d;
    due_slabs(q, &enter, &leave);
    bool due = enter < leave && leave > 0;
    if (fabs(enter - leave) < 1e-9 || fabs(leave) < 1e-9) return true;  /* may be rounding */
    if (due != a->is)
        return exam_say(why,
                        "o = (%g, %g, %g), d = (%g, %g, %g): the ray is in all slabs from %g to "
                        "%g, that is %s, yours %s",
                        o.x, o.y, o.z, d.x, d.y, d.z, enter, leave, due ? "a hit" : "none",
                        a->is ? "a hit" : "none");
    return !due || near_time(a->t0, enter)
        || exam_say(why, "t_enter is %.9g, yours %.9g", enter, a->t0);
}

/* t at which the ray meets the plane of face k, if that is in its interval and in the box. */
static bool at_face(const question *q, int k, real *t)
{
    real d = vaxis(q->r.d, k / 2), plane = vaxis(k % 2 ? q->b.hi : q->b.lo, k / 2);
    if (d == 0) return false;
    *t = (plane - vaxis(q->r.o, k / 2)) / d;
    return ray_covers(q->r, *t) && in_box(q->b, vwith(ray_at(q->r, *t), k / 2, plane));
}

/* The first time in the box: of tmin and the times of all faces the smallest that is in the box.
 * The face: the first one that the ray crosses inward at this time. */
static bool due_entry(const question *q, real *t, int *face)
{
    bool found = in_box(q->b, ray_at(q->r, q->r.tmin));
    real s;
    *t = q->r.tmin, *face = -1;
    if (found) return true;
    for (int k = 0; k < 6; k++)
        if (at_face(q, k, &s) && (!found || s < *t)) *t = s, found = true;
    for (int k = 5; found && k >= 0; k--) {
        real d = vaxis(q->r.d, k / 2);
        if (at_face(q, k, &s) && s == *t && (k % 2 ? d < 0 : d > 0)) *face = k;
    }
    return found;
}

static bool mark_entry(const question *q, const answer *a, char why[exam_why])
{
    real t = 0;
    int face = -1;
    vec3 o = q->r.o, d = q->r.d;
    bool due = due_entry(q, &t, &face);
    if (due != a->is)
        return exam_say(
            why,
            "box (%g, %g, %g) to (%g, %g, %g), o = (%g, %g, %g), d = (%g, %g, %g), t in "
            "[%g, %g]: %s, yours %s",
            q->b.lo.x, q->b.lo.y, q->b.lo.z, q->b.hi.x, q->b.hi.y, q->b.hi.z, o.x, o.y, o.z, d.x,
            d.y, d.z, q->r.tmin, q->r.tmax, due ? "a hit" : "none", a->is ? "a hit" : "none");
    if (!due) return a->t0 == -77 || exam_say(why, "a miss has to leave *t as it was");
    return (near_time(a->t0, t) && a->face == face)
        || exam_say(why, "t is %.9g by face %d, yours %.9g by face %d", t, face, a->t0, a->face);
}

/* A box at any angle; a point inside one of its faces, and from outside a ray to it. For a miss the
 * ray runs at right angles to a direction m in which the whole box lies below it. */
static question ask_turned(random_stream *g, int i)
{
    question q;
    memset(&q, 0, sizeof q);
    vec3 w = vunit(exam_vector(g, 1)), s, t, m;
    if (vzero(w)) w = vec(0, 0, 1);
    vbasis(w, &s, &t);
    q.box = (turned_box){exam_vector(g, 4), s, t, w,
                         vadd(exam_vector(g, 0.8), vec(1, 1, 1))};
    const vec3 axis[3] = {s, t, w};
    int k = i % 3;
    real side = i % 2 ? 1 : -1, stretch = exam_between(g, 0.1, 3);
    vec3 at = vscale(axis[k], side * vaxis(q.box.half, k));
    for (int j = 1; j < 3; j++)
        at = vmadd(at, axis[(k + j) % 3],
                   vaxis(q.box.half, (k + j) % 3) * exam_between(g, -0.95, 0.95));
    vec3 off = vscale(axis[k], side * exam_between(g, 0.8, 3));
    off = vadd(off, exam_vector(g, 0.4));
    q.t = 1 / stretch, q.n = vscale(axis[k], side), q.is_due = i % 4 != 3;
    if (!q.is_due) {
        do m = vunit(exam_vector(g, 1)); while (vzero(m));
        real reach = fabs(vdot(m, s)) * q.box.half.x + fabs(vdot(m, t)) * q.box.half.y
                   + fabs(vdot(m, w)) * q.box.half.z;
        vbasis(m, &off, &s);
        off = vadd(off, s);
        at = vscale(off, exam_between(g, -1, 1));
        at = vmadd(at, m, reach + exam_between(g, 1e-6, 0.5));
    }
    at = vadd(at, q.box.c);
    q.r = ray_from(vadd(at, off), vscale(off, -stretch));
    return q;
}

static bool mark_turned(const question *q, const answer *a, char why[exam_why])
{
    if (q->is_due != a->is) {
        vec3 o = vsub(q->r.o, q->box.c), d = q->r.d;
        return exam_say(
            why,
            "o - c = (%g, %g, %g), d = (%g, %g, %g) along the box's axes, half = (%g, %g, "
            "%g), t in [%g, %g]: %s, yours %s",
            vdot(o, q->box.u), vdot(o, q->box.v), vdot(o, q->box.w), vdot(d, q->box.u),
            vdot(d, q->box.v), vdot(d, q->box.w), q->box.half.x, q->box.half.y, q->box.half.z,
            q->r.tmin, q->r.tmax, q->is_due ? "a hit" : "none", a->is ? "a hit" : "none");
    }
    if (!a->is) return a->t0 == -77 || exam_say(why, "a miss has to leave *t as it was");
    if (!exam_near(a->t0, q->t, 1e-10 * (1 + q->t)))
        return exam_say(why, "t is %.9g, yours %.9g", q->t, a->t0);
    return vlength(vsub(a->n, q->n)) <= 1e-12
        || exam_say(why, "the normal is (%g, %g, %g), yours (%g, %g, %g)", q->n.x, q->n.y, q->n.z,
                    a->n.x, a->n.y, a->n.z);
}

static question ask_sweep(random_stream *g, int i)
{
    question q;
    memset(&q, 0, sizeof q);
    q.a = some_box(g, 1), q.b = some_box(g, 2);
    vec3 from = exam_vector(g, 3);
    q.move = vsub(exam_vector(g, i % 2 ? 1 : 4), from);
    q.a = (aabb){vadd(q.a.lo, from), vadd(q.a.hi, from)};
    return q;
}

static bool touch(const question *q, real t, double by)
{
    vec3 s = vscale(q->move, t), e = vec(by, by, by);
    aabb a = {vsub(vadd(q->a.lo, s), e), vadd(vadd(q->a.hi, s), e)};
    return first_aabb_overlap(a, q->b);
}

/* All times at which contact could begin or end: 0, 1, and those at which two planes meet. The
 * boxes touch there, or not: the first and the last of them is due. `by`: what rounding may do. */
static bool due_sweep(const question *q, double by, real *t0, real *t1)
{
    bool found = false;
    for (int k = -2; k < 6; k++) {
        real t = k == -2 ? 0 : 1;
        if (k >= 0) {
            vec3 from = k % 2 ? q->a.lo : q->a.hi, to = k % 2 ? q->b.hi : q->b.lo;
            if (vaxis(q->move, k / 2) == 0) continue;
            t = (vaxis(to, k / 2) - vaxis(from, k / 2)) / vaxis(q->move, k / 2);
        }
        if (!(t >= 0 && t <= 1) || !touch(q, t, by)) continue;
        if (!found || t < *t0) *t0 = t;
        if (!found || t > *t1) *t1 = t;
        found = true;
    }
    return found;
}

static bool mark_sweep_by(const question *q, const answer *a, double by, char why[exam_why])
{
    real t0 = 0, t1 = 0, s0, s1;
    bool due = due_sweep(q, by, &t0, &t1);
    if (due && !due_sweep(q, -by, &s0, &s1) && by > 0) return true;  /* contact by rounding only */
    if (due != a->is)
        return exam_say(why, "v = (%g, %g, %g): %s from %g to %g, yours %s", q->move.x, q->move.y,
                        q->move.z, due ? "they touch" : "they never touch", t0, t1,
                        a->is ? "touch" : "do not");
    if (!due) return a->t0 == -77 || exam_say(why, "*t0 has to stay as it was");
    return (exam_near(a->t0, t0, 10 * by) && exam_near(a->t1, t1, 10 * by))
           || exam_say(why, "they touch from %.9g to %.9g, yours from %.9g to %.9g", t0, t1, a->t0,
                       a->t1);
}

static bool mark_sweep(const question *q, const answer *a, char why[exam_why])
{
    return mark_sweep_by(q, a, 1e-12, why);
}

static const exam_check public_checks[] = {
    {1, "any direction", 8, false, 600, ask_box, mark_slabs},
    {2, "hit or miss; t_enter", 5, false, 600, ask_box, mark_box},
    {3, "from outside", 8, false, 600, ask_box, mark_entry},
    {4, "from outside", 8, false, 600, ask_turned, mark_turned},
    {5, "any way", 8, false, 600, ask_sweep, mark_sweep},
};
#endif
