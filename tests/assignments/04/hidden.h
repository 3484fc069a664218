/* Checks of assignment 04 that the student does not have: hard cases. Included after public.h. */
#ifndef HIDDEN_04_H
#define HIDDEN_04_H

/* A window that is not in the middle, its distance not 1, and any point of the picture. */
static question ask_shifted(random_stream *g, int i)
{
    question q = ask_camera(g, i);
    first_camera *c = &q.camera;
    c->left += exam_between(g, -1, 1), c->right += exam_between(g, 1, 2);
    c->top += exam_between(g, -1, 1), c->bottom += exam_between(g, -1, 0);
    c->d = exam_between(g, 0.3, 4);
    q.x = exam_between(g, 0, c->nx), q.y = exam_between(g, 0, c->ny);
    return q;
}

/* The hit lies at t; the interval ends before it, begins behind it, or holds it by a little; or it
 * lies behind the origin, where a line would meet the triangle but the ray does not. */
static question ask_interval(random_stream *g, int i)
{
    question q = ask_triangle(g, 2 * i + 1);
    real t = q.due.t, near = exam_between(g, 1e-3, 0.5) * t;
    switch (i % 5) {
    case 0: q.r.tmax = t + near; break;
    case 1: q.r.tmin = t - near, q.r.tmax = t + near; break;
    case 2: q.r.tmax = t - near, q.is_due = false; break;
    case 3: q.r.tmin = t + near, q.is_due = false; break;
    case 4: q.r.d = vneg(q.r.d), q.is_due = false; break;
    }
    return q;
}

/* The same triangle and ray, everything smaller or larger by a power of two: nothing may change but
 * u, v stay and t stays. A test against a fixed epsilon sees it. Every fifth has no area. */
static question ask_sizes(random_stream *g, int i)
{
    question q = ask_triangle(g, i);
    real by = ldexp((real)1, (int)(random_next_bits(g) % 81) - 40);
    if (i % 5 == 4) {
        q.tri.a = vec(1, 2, 3), q.tri.b = vec(2, 4, 6), q.tri.c = vec(5, 10, 15), q.is_due = false;
        q.r = ray_from(vec(2, 4, 9), vec(0, 0, -1 - i % 2)), q.due.u = q.due.v = 0;
        return q;
    }
    q.tri = (triangle){vscale(q.tri.a, by), vscale(q.tri.b, by), vscale(q.tri.c, by)};
    q.r.o = vscale(q.r.o, by), q.r.d = vscale(q.r.d, by);
    return q;
}

/* Corners and edges in whole numbers: all that Möller and Trumbore compute is exact, so a border
 * counts, on each side that is asked for. One in four is a miss by one whole step. */
static question ask_border(random_stream *g, int i)
{
    question q = {.side = 1 + i % 3};
    int step = 4 << random_next_bits(g) % 3, along = (int)(random_next_bits(g) % 5);
    q.tri = (triangle){{0, 0, 0}, {(real)step, 0, 0}, {0, (real)step, 0}};
    int x = step * along / 4, y = 0;
    if (i / 3 % 3 == 1) x = 0, y = step * along / 4;
    if (i / 3 % 3 == 2) y = step - x;
    bool out = i % 4 == 3;
    if (out && i / 3 % 3 == 0) y = -1;
    else if (out && i / 3 % 3 == 1) x = -1;
    else if (out) x++;
    bool from_front = random_next_bits(g) & 1;
    real high = from_front ? 8 : -8;
    q.r = ray_from((vec3){(real)(x + 8), (real)(y - 8), high}, (vec3){-8, 8, -high});
    vec3 move = vec(random_next_bits(g) % 64, random_next_bits(g) % 64, random_next_bits(g) % 64);
    q.tri = (triangle){vadd(q.tri.a, move), vadd(q.tri.b, move), vadd(q.tri.c, move)};
    q.r.o = vadd(q.r.o, move);
    q.is_due = !out && (q.side & (from_front ? side_front : side_back));
    q.due = (hit){1, (real)x / (real)step, (real)y / (real)step, 0};
    return q;
}

/* The very middle; a window as wide as three times its height, where theta passes pi. */
static question ask_fisheye_far(random_stream *g, int i)
{
    question q = ask_camera(g, i);
    first_camera *c = &q.camera;
    c->nx = 900, c->ny = 200;
    q.x = exam_between(g, 0, c->nx), q.y = exam_between(g, 0, c->ny);
    if (i % 4 == 0) q.x = 450, q.y = 100;
    c->d = c->top / tan(exam_between(g, 1.2, 1.5));  /* phi / 2 up to 86 degrees */
    return q;
}

/* One of a, b, c, d follows from the others; the hit is found as before. */
static question ask_parallelogram(random_stream *g, int i)
{
    question q = {.side = side_both};
    vec3 a = exam_vector(g, 3), e, f, n;
    do e = exam_vector(g, 2), f = exam_vector(g, 2), n = vcross(e, f); while (vlength(n) < 1);
    if (i % 3 == 0) e = vec(2, 0, 0), f = vec(0, 4, 0), n = vec(0, 0, 8), a = vec(1, 2, 3);
    real u = exam_between(g, -0.5, 1.5), v = exam_between(g, -0.5, 1.5);
    if (fabs(u) < 0.02 || fabs(v) < 0.02 || fabs(u - 1) < 0.02 || fabs(v - 1) < 0.02) u = v = 0.5;
    vec3 p = vadd(a, vadd(vscale(e, u), vscale(f, v)));
    vec3 from = vadd(p, vadd(vscale(vunit(n), i % 2 ? 2 : -2), vscale(e, exam_between(g, -1, 1))));
    q.a = a, q.b = vadd(a, e), q.d = vadd(a, f), q.c = vadd(q.b, f);
    q.r = ray_from(from, vsub(p, from));
    q.is_due = u > 0 && u < 1 && v > 0 && v < 1, q.due = (hit){1, u, v, 0};
    return q;
}

/* Interval, corners in the other order, no area, and rays that run along the plane. */
static question ask_quad_odd(random_stream *g, int i)
{
    question q = ask_quad(g, 2 * i + 1);
    vec3 b = q.b;
    real u = q.due.u;
    switch (i % 6) {
    case 0: q.r.tmax = q.due.t / 2, q.is_due = false; break;
    case 1: q.r.tmin = q.due.t * 2, q.is_due = false; break;
    case 2: q.b = q.d, q.d = b, q.due.u = q.due.v, q.due.v = u; break;
    case 3: q.c = q.a, q.d = q.b, q.is_due = false; break;
    case 4: q.a = vec(0, 0, 0), q.b = vec(2, 0, 0), q.c = vec(2, 2, 0), q.d = vec(0, 2, 0);
            q.r = ray_from(vec(-1, 1, 0), vec(1, 0, 0)), q.is_due = false; break;
    case 5: q.r.tmax = q.due.t * 2, q.r.tmin = q.due.t / 2; break;
    }
    return q;
}

static const exam_check hidden_checks[] = {
    {1, "windows that are not in the middle", 5, true, 200, ask_shifted, mark_camera},
    {2, "intervals", 6, true, 500, ask_interval, mark_triangle},
    {2, "tiny, huge, no area", 6, true, 500, ask_sizes, mark_triangle},
    {3, "borders, seen from all sides", 7, true, 360, ask_border, mark_sided},
    {4, "the middle, and beyond pi", 7, true, 400, ask_fisheye_far, mark_fisheye},
    {5, "parallelograms", 9, true, 600, ask_parallelogram, mark_quad},
    {5, "interval, order, no area, edge-on", 8, true, 600, ask_quad_odd, mark_quad},
};
#endif
