/* Checks of assignment 26 that the student does not have: hard cases. Included after public.h. */
#ifndef HIDDEN_26_H
#define HIDDEN_26_H

/* The lamp shines the other way; or the horizon cuts it; or a wall hides it up to some u,
 * halfway. */
static question ask_lamp_odd(random_stream *g, int i)
{
    question q = ask_lamp(g, i);
    first_thing *y = &q.s.thing[0];
    first_material dark = {.kd = {(real)0.5, (real)0.5, (real)0.5}};
    if (i % 3 == 0) {
        vec3 corner = y->corner, a = y->a, b = y->b;
        first_material m = y->m;
        q.s.things = 0;
        first_add_flat(&q.s, corner, b, a, m);
    } else if (i % 3 == 1) {
        q.x.n = vunit(vec(exam_between(g, 0.5, 1), exam_between(g, -0.2, 0.4), 0));
        q.x.v = q.x.n;
    } else {
        /* From the corner, halfway: u from -20 to 0.4, v from -20 to 20 of the lamp's own sides. */
        vec3 at = vscale(y->corner, (real)0.5), a = vscale(y->a, (real)0.5),
             b = vscale(y->b, (real)0.5);
        first_add_flat(&q.s, vmadd(vmadd(at, a, -20), b, -20), vscale(a, (real)20.4), vscale(b, 40),
                       dark);
    }
    return q;
}

static bool mark_lamp_odd(const question *q, const answer *a, char why[exam_why])
{
    bool hidden = q->s.things == 2;
    vec3 due = due_lamp(q, hidden ? (real)0.4 : 0);
    return mark_mean(q, a->mean, due, lamp_sigma(q, due), hidden
                     ? "a lamp of which a wall hides 0.4" : "a lamp that is not wholly above", why);
}

/* A closed room, brighter. With kd up to 0.75 the squares of the weights, kd^2 / 0.8 a bounce,
 * add up. */
static question ask_closed_room(random_stream *g, int i)
{
    (void)i;
    return ask_room_of(g, false, 0.75);
}

/* hi is not below kd: weights do not grow, and six standard deviations mean what they say. */
static question ask_furnace_colours(random_stream *g, int i)
{
    real hi = exam_between(g, 0.7, 1), lo = exam_between(g, 0.05, 0.5);
    roulette_rule rule = {i % 5, lo, i % 4 ? hi : lo};
    return ask_furnace_of(g, some_colour(g, 0.1, 0.7), rule);
}

/* How many paths reach each hit: a binomial count, whose mean is known. */
static bool mark_lengths(const question *q, const answer *a, char why[exam_why])
{
    double alive[answer_lengths];
    int reached = q->samples - a->length[0];
    (void)furnace_sigma(q, alive);
    for (int k = 1; k < answer_lengths; k++) {
        double n = q->samples, p = alive[k], due = n * p, may = 6 * sqrt(n * p * (1 - p)) + 3;
        if (fabs(reached - due) > may)
            return exam_say(
                why,
                "sure %d, q from %.3g to %.3g, kd (%.3g, %.3g, %.3g): of %d paths %.0f within "
                "%.0f have %d hits or more, yours %d",
                q->rule.sure, q->rule.lo, q->rule.hi, q->s.thing[0].m.kd.x, q->s.thing[0].m.kd.y,
                q->s.thing[0].m.kd.z, q->samples, due, may, k, reached);
        reached -= a->length[k];
    }
    return mark_furnace(q, a, why);
}

/* As small as a star and as near as touching. */
static question ask_ball_far(random_stream *g, int i)
{
    question q = ask_ball(g, i);
    vec3 to = vunit(vsub(q.s.thing[0].ball.c, q.x.p));
    real d = i % 2 ? pow(10, exam_between(g, 2, 8)) : exam_between(g, 1.001, 1.05);
    real R = q.s.thing[0].ball.r;
    q.s.thing[0].ball.c = vmadd(q.x.p, to, d * R);
    if (i % 2 == 0) q.x.n = to;
    return q;
}

/* Partly below the horizon, or behind the edge of a wall. */
static question ask_ball_cut(random_stream *g, int i)
{
    question q = ask_ball(g, i);
    first_material dark = {.kd = {(real)0.5, (real)0.5, (real)0.5}};
    vec3 to = vsub(q.s.thing[0].ball.c, q.x.p), s, t, w = vunit(to);
    real R = q.s.thing[0].ball.r, d = vlength(to);
    vbasis(w, &s, &t);
    if (i % 2) q.x.n = vunit(vmadd(t, w, exam_between(g, -0.5, 0.8) * R / d));
    else /* begins, seen from x, a little beside the middle of the ball, and goes on to one side */
        first_add_flat(&q.s,
                       vadd(vmadd(q.x.p, w, d / 4),
                            vadd(vscale(s, exam_between(g, -0.2, 0.2) * R / 4), vscale(t, -20))),
                       vscale(s, 20), vscale(t, 40), dark);
    return q;
}

/* The same integral on a raster of directions, 400 x 400: what the border of the shadow, or the
 * horizon, leaves out is less than 1/100 of a ball that is wholly seen. */
static bool mark_ball_cut(const question *q, const answer *a, char why[exam_why])
{
    enum { n = 400 };
    sphere ball = q->s.thing[0].ball;
    vec3 to = vsub(ball.c, q->x.p), s, t, w = vunit(to);
    real d = vlength(to), wide = 1 - cos(asin(ball.r / d)), sum = 0,
         whole = ball.r * ball.r / (d * d);
    vbasis(w, &s, &t);
    for (int i = 0; i < n * n; i++) {
        real high = 1 - wide * ((real)(i % n) + (real)0.5) / n, phi = 2 * pi * (real)(i / n) / n;
        real flat = sqrt(1 - high * high);
        vec3 wi = vadd(vscale(w, high),
                       vadd(vscale(s, flat * cos(phi)), vscale(t, flat * sin(phi))));
        hit h;
        bool hidden = q->s.things > 1 && first_thing_hit(&q->s.thing[1], ray_from(q->x.p, wi), &h);
        if (!hidden) sum += real_max(vdot(wi, q->x.n), 0);
    }
    vec3 full = vmul(q->x.kd, q->s.thing[0].m.ke), due = vscale(full, sum * 2 * wide / (n * n));
    /* samples lie in [0, 2 (1 - cos m)] */
    vec3 sigma = vscale(full, wide / sqrt((real)q->samples) + whole / 600);
    return mark_mean(q, a->mean, due, sigma, q->s.things > 1 ? "a ball behind the edge of a wall"
                                                             : "a ball that the horizon cuts", why);
}

static const exam_check hidden_checks[] = {
    {1, "turned away, cut, half hidden", 5, true, 45, ask_lamp_odd, mark_lamp_odd},
    {2, "a closed room", 10, true, 6, ask_closed_room, mark_room},
    {3, "coloured furnace", 8, true, 24, ask_furnace_colours, mark_furnace},
    {3, "how long paths are", 12, true, 24, ask_furnace_colours, mark_lengths},
    {4, "stars, and close by", 8, true, 40, ask_ball_far, mark_ball},
    {4, "half hidden, half below", 7, true, 40, ask_ball_cut, mark_ball_cut},
};
#endif
