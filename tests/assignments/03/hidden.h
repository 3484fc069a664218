/* Checks of assignment 03 that the student does not have: hard cases. Included after public.h. */
#ifndef HIDDEN_03_H
#define HIDDEN_03_H

/* All lengths times a power of two: t stays. Against a fixed epsilon; and d of other lengths. */
static question ask_scaled(random_stream *g, int i)
{
    question q = ask_sphere(g, i);
    real by = ldexp((real)1, (int)(random_next_bits(g) % 61) - 30);
    q.s = (sphere){vscale(q.s.c, by), q.s.r * by};
    q.r.o = vscale(q.r.o, by), q.r.d = vscale(q.r.d, by);
    if (i % 4 == 1) q.r.d = vneg(q.r.d);  /* both roots below 0 */
    return q;
}

/* From inside; the ball behind; an interval that holds entry and exit, one of them, or neither. */
static question interval_of(question q, random_stream *g, int i, exam_depth *f)
{
    crossing x = find_crossing(&q, f, -1000, 1000, 0);
    real in = x.in, out = x.out, wide = out - in;
    if (!x.met) return q;
    switch (i % 6) {
    case 0: q.r.o = ray_at(q.r, in + wide * exam_between(g, 0.05, 0.95)); break;
    case 1: q.r.d = vneg(q.r.d); break;
    case 2: q.r.tmin = in + wide * exam_between(g, 0.1, 0.9); break;
    case 3: q.r.tmin = in + wide / 4, q.r.tmax = out - wide / 4; break;
    case 4: q.r.tmax = in - wide * exam_between(g, 0.01, 0.2); break;
    case 5: q.r.tmin = in - wide / 8, q.r.tmax = in + wide * exam_between(g, 0.1, 2); break;
    }
    return q;
}

static question ask_interval(random_stream *g, int i)
{
    return interval_of(ask_sphere(g, i / 6), g, i, sphere_depth);
}

static question ask_ellipsoid_odd(random_stream *g, int i)
{
    question q = ask_ellipsoid(g, i / 6);
    q.radii = vwith(q.radii, i % 3, exam_between(g, 0.05, 0.2));  /* as flat as a coin */
    q.r.d = vsub(vmadd(q.s.c, vmul(exam_vector(g, 0.5), q.radii), 1), q.r.o);
    return interval_of(q, g, i, ellipsoid_depth);
}

/* Overlapping at the start; side by side with the same speed; going apart; too late. */
static question ask_meeting_odd(random_stream *g, int i)
{
    question q = ask_meeting(g, 3 * i + 1);
    vec3 between = vsub(q.other.c, q.s.c);
    switch (i % 5) {
    case 0:
        q.other.c = vmadd(q.s.c, vunit(between), exam_between(g, 0, 0.99) * (q.s.r + q.other.r));
        break;
    case 1: q.v = q.w; break;
    case 2: q.v = vmadd(q.w, between, -exam_between(g, 0.1, 2)); break;
    case 3: q.v = vmadd(q.w, between, exam_between(g, 0.01, 0.2)); break;
    case 4: q.v = q.w, q.other.c = vmadd(q.s.c, vunit(between), (q.s.r + q.other.r) / 2); break;
    }
    return q;
}

/* Round ends; along the segment; no length; from inside and intervals. */
static question ask_capsule_ends(random_stream *g, int i)
{
    question q = ask_capsule(g, i);
    vec3 w = vunit(vsub(q.b, q.a)), end = i % 2 ? q.a : q.b;
    real far = q.s.r * exam_between(g, 0, 1.3);
    vec3 s, t;
    vbasis(w, &s, &t);
    if (i % 2) w = vneg(w);
    vec3 aim = vadd(vmadd(end, s, far), vscale(w, exam_between(g, 0, 0.3) * q.s.r));
    q.r.d = vsub(aim, q.r.o);
    switch (i % 4) {
    case 0: q.r.o = vmadd(vmadd(end, w, 5), s, far), q.r.d = vscale(w, -2); break;
    case 1: q.b = q.a, q.r.d = vsub(vmadd(q.a, s, far), q.r.o); break;
    case 2:
        q.r.o = vmadd(aim, w, exam_between(g, 1, 5)), q.r.d = vsub(vmadd(end, t, far), q.r.o);
        break;
    }
    return q;
}

static question ask_capsule_interval(random_stream *g, int i)
{
    return interval_of(ask_capsule(g, i / 6), g, i, capsule_depth);
}

static const exam_check hidden_checks[] = {
    {1, "tiny, huge, behind", 7, true, 400, ask_scaled, mark_roots},
    {2, "from inside, behind, intervals", 8, true, 600, ask_interval, mark_hit},
    {3, "flat, from inside, intervals", 10, true, 600, ask_ellipsoid_odd, mark_ellipsoid},
    {4, "overlapping, side by side, apart", 8, true, 500, ask_meeting_odd, mark_meeting},
    {5, "ends, along, no length", 6, true, 400, ask_capsule_ends, mark_capsule},
    {5, "from inside, intervals", 6, true, 600, ask_capsule_interval, mark_capsule},
};
#endif
