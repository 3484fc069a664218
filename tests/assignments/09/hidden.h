/* Checks of assignment 09 that the student does not have: hard cases. Included after public.h. */
#ifndef HIDDEN_09_H
#define HIDDEN_09_H

static real whole(random_stream *g, int half)
{
    return (real)((int)(random_next_bits(g) % (uint64_t)(2 * half + 1)) - half);
}

static vec3 whole_vector(random_stream *g, int half)
{
    real x = whole(g, half), y = whole(g, half);
    return (vec3){x, y, whole(g, half)};
}

/* Down, up, or not at all along each axis: one component or two are 0, and 0 is +0. */
static question ask_along(random_stream *g, int i)
{
    question q = ask_box(g, i);
    int k = i % 3;
    q.r.d = vwith(q.r.d, k, 0);
    if (i % 2) q.r.d = vwith(q.r.d, (k + 1) % 3, 0);
    return q;
}

/* The ray begins in the box, or has it behind it. */
static question ask_inside(random_stream *g, int i)
{
    question q = ask_box(g, 3 * i + 1);
    vec3 to_box = q.r.d;
    if (i % 2) q.r.d = vneg(to_box);
    else {
        vec3 share = vadd(exam_vector(g, 0.45), vec(0.5, 0.5, 0.5));
        q.r.o = vadd(q.b.lo, vmul(share, vsub(q.b.hi, q.b.lo)));
    }
    return q;
}

/* All in small whole numbers, d of powers of two, so everything that counts is exact: faces, edges
 * and corners are met, rays run in faces, boxes are flat. Half of the zeros of d are -0. */
static question ask_lattice(random_stream *g, int i)
{
    static const real power[7] = {0, 1, -1, 2, -2, 4, -4};
    question q;
    memset(&q, 0, sizeof q);
    vec3 p = whole_vector(g, 3), s = whole_vector(g, 3), d;
    q.b = (aabb){vmin(p, s), vmax(p, s)};
    do
        d = (vec3){power[random_next_bits(g) % 7], power[random_next_bits(g) % 7],
                   power[random_next_bits(g) % 7]};
    while (vzero(d));
    for (int k = 0; k < 3; k++)
        if (vaxis(d, k) == 0 && random_next_bits(g) & 1) d = vwith(d, k, (real)-0.0);
    /* Back from a point of the box, so that two thirds of the rays meet it. */
    vec3 at = i % 3 ? vec(random_next_bits(g) & 1 ? q.b.lo.x : q.b.hi.x,
                          random_next_bits(g) & 1 ? q.b.lo.y : q.b.hi.y,
                          random_next_bits(g) & 1 ? q.b.lo.z : q.b.hi.z) : whole_vector(g, 3);
    q.r = ray_from(vmadd(at, d, -(real)(random_next_bits(g) % 4)), d);
    return q;
}

/* The same, with an interval that begins and ends anywhere, at the box too. */
static question ask_lattice_interval(random_stream *g, int i)
{
    question q = ask_lattice(g, i);
    q.r.tmin = whole(g, 4) / 2, q.r.tmax = q.r.tmin + (real)(random_next_bits(g) % 9) / 2;
    return q;
}

/* Along its own faces, flat ones, from inside, and with an interval that ends before the box. */
static question ask_turned_odd(random_stream *g, int i)
{
    question q = ask_turned(g, 4 * i + i % 3);
    real reach = q.t;
    switch (i % 5) {
    case 0: q.r.tmax = reach / 2, q.is_due = false; break;
    case 1: q.r.tmin = reach * (real)0.999, q.r.tmax = reach * (real)1.001; break;
    case 2: q.r.o = vmadd(q.box.c, q.box.u, q.box.half.x / 2), q.t = 0, q.n = vec(0, 0, 0); break;
    case 3: /* axes that are those of the world: d has components that are exactly 0 */
    case 4: /* and flat: a plate at z = 2 */
        q.box = (turned_box){vec(1, -1, 2), vec(0, 1, 0), vec(-1, 0, 0), vec(0, 0, 1),
                             vec(2, 1, i % 5 == 4 ? 0 : 1)};
        q.r = ray_from(vec(i % 2 ? 2 : 2.5, -3, 8), vec(0, 0, -2));
        q.is_due = i % 2, q.n = vec(0, 0, 1), q.t = i % 5 == 4 ? 3 : 2.5;
        break;
    }
    return q;
}

/* Small whole numbers: contact of faces, edges, corners, at 0 and at 1; v along faces, or none. */
static question ask_contact(random_stream *g, int i)
{
    static const real power[7] = {0, 1, -1, 2, -2, 4, -4};
    question q;
    memset(&q, 0, sizeof q);
    vec3 p = whole_vector(g, 2), s = whole_vector(g, 2);
    q.a = (aabb){vmin(p, s), vmax(p, s)};
    p = whole_vector(g, 3), s = whole_vector(g, 3);
    q.b = (aabb){vmin(p, s), vmax(p, s)};
    q.move = (vec3){power[random_next_bits(g) % 7], power[random_next_bits(g) % 7],
                    power[random_next_bits(g) % 7]};
    if (i % 8 == 0) q.move = vec(0, 0, 0);
    return q;
}

static bool mark_contact(const question *q, const answer *a, char why[exam_why])
{
    return mark_sweep_by(q, a, 0, why);
}

static const exam_check hidden_checks[] = {
    {1, "along axes and planes", 7, true, 600, ask_along, mark_slabs},
    {2, "from inside, and behind", 5, true, 600, ask_inside, mark_box},
    {3, "faces, edges, corners, flat, -0", 7, true, 2000, ask_lattice, mark_entry},
    {3, "intervals", 5, true, 2000, ask_lattice_interval, mark_entry},
    {4, "inside, flat, along, intervals", 12, true, 600, ask_turned_odd, mark_turned},
    {5, "contact, standing still, flat", 12, true, 2000, ask_contact, mark_contact},
};
#endif
