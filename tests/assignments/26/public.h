/* Checks of assignment 26 that the student has. Means of samples against closed forms: Lambert's
 * for a polygon, the ball's, the furnace's; or against another way of sampling. A mean may be
 * off by six standard deviations: of a right answer one in 5e8 is. */
#ifndef PUBLIC_26_H
#define PUBLIC_26_H
#include "exam.h"

static vec3 some_colour(random_stream *g, double lo, double hi)
{
    real x = exam_between(g, lo, hi), y = exam_between(g, lo, hi);
    return (vec3){x, y, exam_between(g, lo, hi)};
}

/* |a - due| <= 6 sigma in each colour. */
static bool mark_mean(const question *q, vec3 a, vec3 due, vec3 sigma, const char *what,
                      char why[exam_why])
{
    static const char *colour[3] = {"red", "green", "blue"};
    for (int k = 0; k < 3; k++) {
        real is = vaxis(a, k), should = vaxis(due, k), may = 6 * vaxis(sigma, k);
        if (!(fabs(is - should) <= may + 1e-12 * fabs(should)))
            return exam_say(
                why,
                "%s, %s, mean of %d samples: %.6g within %.2g is due, yours is %.6g (%.4g "
                "times that)",
                what, colour[k], q->samples, should, may, is, is / should);
    }
    return true;
}

/* Lambert's formula for the irradiance from a polygon that shines with 1, seen from p with
 * normal n: half the sum, over its sides, of the angle that a side fills times the cosine at
 * which the plane of side and p stands. What lies below the horizon is cut off before. */
static real lambert(const vec3 *corner, int corners, vec3 p, vec3 n)
{
    vec3 above[9];
    int m = 0;
    real sum = 0;
    for (int i = 0; i < corners; i++) {
        vec3 a = vsub(corner[i], p), b = vsub(corner[(i + 1) % corners], p);
        real ha = vdot(a, n), hb = vdot(b, n);
        if (ha > 0) above[m++] = a;
        if ((ha > 0) != (hb > 0)) above[m++] = vmadd(a, vsub(b, a), ha / (ha - hb));
    }
    for (int i = 0; i < m; i++) {
        vec3 a = vunit(above[i]), b = vunit(above[(i + 1) % m]), c = vcross(a, b);
        sum += atan2(vlength(c), vdot(a, b)) * vdot(vunit(c), n);
    }
    return fabs(sum) / 2;
}

/* A lamp over a point, from 1 to 3 above it, facing it within 40 degrees; no wall between. */
static question ask_lamp(random_stream *g, int i)
{
    question q;
    (void)i;
    memset(&q, 0, sizeof q);
    q.s.eps = (real)1e-5;
    vec3 a = vec(exam_between(g, 0.4, 1.5), exam_between(g, -0.3, 0.3), exam_between(g, -0.3, 0.3));
    vec3 b = vec(exam_between(g, -0.3, 0.3), exam_between(g, -0.3, 0.3), exam_between(g, 0.4, 1.5));
    vec3 corner = vec(exam_between(g, -2, 1), exam_between(g, 1.7, 3), exam_between(g, -2, 1));
    first_material m = {.kd = {(real)0.5, (real)0.5, (real)0.5}, .ke = some_colour(g, 1, 20)};
    first_add_flat(&q.s, corner, a, b, m);  /* a x b points down */
    q.x = (first_point){.n = {0, 1, 0}, .v = {0, 1, 0}, .kd = some_colour(g, 0.1, 0.9)};
    q.seed = random_next_bits(g), q.samples = 4000;
    return q;
}

/* Of the lamp, the part from u = u0 on. */
static vec3 due_lamp(const question *q, real u0)
{
    const first_thing *y = &q->s.thing[0];
    vec3 c = vmadd(y->corner, y->a, u0), a = vscale(y->a, 1 - u0);
    vec3 corner[4] = {c, vadd(c, a), vadd(vadd(c, a), y->b), vadd(c, y->b)};
    real E = vdot(vsub(q->x.p, c), y->n) > 0 ? lambert(corner, 4, q->x.p, q->x.n) : 0;
    return vscale(vmul(q->x.kd, y->m.ke), E / pi);
}

/* Samples of the lamp lie in [0, largest]; so their deviation is at most half of that, or, with the
 * mean known, sqrt(mean (largest - mean)). The largest: f cos cos' A Le / r^2 on a fine raster. */
static vec3 lamp_sigma(const question *q, vec3 mean)
{
    const first_thing *y = &q->s.thing[0];
    real most = 0;
    for (int i = 0; i < 21 * 21; i++) {
        vec3 p = vadd(y->corner,
                      vadd(vscale(y->a, (real)(i % 21) / 20), vscale(y->b, (real)(i / 21) / 20)));
        vec3 d = vsub(p, q->x.p);
        most = real_max(most, vdot(d, q->x.n) * -vdot(d, y->n) / (pi * vdot(d, d) * vdot(d, d)));
    }
    vec3 sigma = vec(0, 0, 0);
    for (int k = 0; k < 3; k++) {
        real m = vaxis(mean, k),
             largest = (real)1.05 * most * vaxis(q->x.kd, k) * vaxis(y->m.ke, k);
        sigma = vwith(sigma, k, sqrt(real_max(m * (largest - m), 0) / (real)q->samples));
    }
    return sigma;
}

static bool mark_lamp(const question *q, const answer *a, char why[exam_why])
{
    vec3 due = due_lamp(q, 0);
    return mark_mean(q, a->mean, due, lamp_sigma(q, due), "direct light of a lamp", why);
}

/* The walls of a room of 2 x 2 x 2, all facing inward; `open` leaves out the one at z = -1. */
static void add_room(first_scene *s, const first_material m[6], bool open)
{
    first_add_flat(s, vec(-1, 1, -1), vec(2, 0, 0), vec(0, 0, 2), m[0]);
    first_add_flat(s, vec(-1, -1, -1), vec(0, 0, 2), vec(2, 0, 0), m[1]);
    first_add_flat(s, vec(-1, -1, -1), vec(0, 2, 0), vec(0, 0, 2), m[2]);
    first_add_flat(s, vec(1, -1, -1), vec(0, 0, 2), vec(0, 2, 0), m[3]);
    first_add_flat(s, vec(-1, -1, 1), vec(0, 2, 0), vec(2, 0, 0), m[4]);
    if (!open) first_add_flat(s, vec(-1, -1, -1), vec(2, 0, 0), vec(0, 2, 0), m[5]);
}

/* The lamp, thing 0, hangs 0.1 below the ceiling, 0.4 from the walls: what it lights is not near
 * it, so that samples of it are bounded. */
static question ask_room_of(random_stream *g, bool open, double most)
{
    question q;
    memset(&q, 0, sizeof q);
    first_material m[6], lamp = {.kd = some_colour(g, 0.1, most), .ke = some_colour(g, 2, 10)};
    memset(m, 0, sizeof m);
    for (int k = 0; k < 6; k++) m[k].kd = some_colour(g, 0.1, most);
    q.s.eps = (real)1e-6;
    first_add_flat(&q.s, vec(-0.6, 0.9, -0.6), vec(1.2, 0, 0), vec(0, 0, 1.2), lamp);
    add_room(&q.s, m, open);
    vec3 o = exam_vector(g, 0.8);
    q.r = ray_from(o, exam_vector(g, 1));
    q.seed = random_next_bits(g), q.samples = 10000;
    return q;
}

static question ask_open_room(random_stream *g, int i)
{
    (void)i;
    return ask_room_of(g, true, 0.6);
}

/* Another way to the same mean: paths by luck, with our own random numbers, twice as many. Their
 * deviation is measured; that of paths with light samples, which are to be marked, is smaller
 * here. */
static bool mark_room(const question *q, const answer *a, char why[exam_why])
{
    vec3 sum = vec(0, 0, 0), squares = sum;
    int n = 2 * q->samples;
    for (int i = 0; i < n; i++) {
        random_stream g = random_start(~q->seed, (uint64_t)i, 1);
        vec3 L = first_path_by_luck(&q->s, q->r, 100, &g);
        sum = vadd(sum, L), squares = vadd(squares, vmul(L, L));
    }
    vec3 mean = vscale(sum, 1 / (real)n), sigma = mean;
    for (int k = 0; k < 3; k++) {
        real v = vaxis(squares, k) / (real)n - vaxis(mean, k) * vaxis(mean, k);
        sigma = vwith(sigma, k, sqrt(real_max(v, 0) * (1 / (real)n + 1 / (real)q->samples)));
    }
    return mark_mean(q, a->mean, mean, sigma, "what a ray sees in a room", why);
}

/* A furnace: all walls shine with the same ke and reflect the same kd. */
static question ask_furnace_of(random_stream *g, vec3 kd, roulette_rule rule)
{
    question q;
    memset(&q, 0, sizeof q);
    first_material m[6];
    memset(m, 0, sizeof m);
    for (int k = 0; k < 6; k++) m[k].kd = kd, m[k].ke = vec(1, 2, 3);
    q.s.eps = (real)1e-6;
    add_room(&q.s, m, false);
    vec3 o = exam_vector(g, 0.8);
    q.r = ray_from(o, exam_vector(g, 1));
    q.rule = rule;
    q.seed = random_next_bits(g), q.samples = 10000;
    return q;
}

static question ask_furnace(random_stream *g, int i)
{
    real kd = exam_between(g, 0.2, 0.7);
    roulette_rule rule = {i % 4, (real)0.05, exam_between(g, 0.7, 1)};
    return ask_furnace_of(g, (vec3){kd, kd, kd}, rule);
}

/* In a furnace paths differ in nothing but where they end. The chance to reach each hit, and
 * from it mean and variance of their sums; the mean is ke / (1 - kd). */
static vec3 furnace_sigma(const question *q, double alive[answer_lengths])
{
    const first_material *m = &q->s.thing[0].m;
    vec3 beta = vec(1, 1, 1), sum = vec(0, 0, 0), mean = sum, square = sum, sigma = sum;
    double reach = 1;
    for (int k = 1; k < 400 && reach > 0; k++) {
        if (k < answer_lengths) alive[k] = reach;
        sum = vadd(sum, vmul(beta, m->ke)), beta = vmul(beta, m->kd);
        double next = reach;
        if (k > q->rule.sure) {
            real most = real_max(real_max(beta.x, beta.y), beta.z);
            real p = most < q->rule.lo ? q->rule.lo : most > q->rule.hi ? q->rule.hi : most;
            beta = vscale(beta, 1 / p), next = reach * (double)p;
        }
        mean = vmadd(mean, sum, (real)(reach - next));
        square = vmadd(square, vmul(sum, sum), (real)(reach - next));
        reach = next;
    }
    for (int k = 0; k < 3; k++) {
        real v = vaxis(square, k) - vaxis(mean, k) * vaxis(mean, k);
        sigma = vwith(sigma, k, sqrt(real_max(v, 0) / (real)q->samples));
    }
    return sigma;
}

static bool mark_furnace(const question *q, const answer *a, char why[exam_why])
{
    double alive[answer_lengths];
    vec3 ke = q->s.thing[0].m.ke, kd = q->s.thing[0].m.kd;
    vec3 due = vec(ke.x / (1 - kd.x), ke.y / (1 - kd.y), ke.z / (1 - kd.z));
    vec3 sigma = furnace_sigma(q, alive);
    char what[120];
    (void)snprintf(what, sizeof what,
                   "furnace, kd (%.3g, %.3g, %.3g), sure %d, q from %.3g to %.3g", kd.x, kd.y, kd.z,
                   q->rule.sure, q->rule.lo, q->rule.hi);
    return mark_mean(q, a->mean, due, sigma, what, why);
}

/* A ball that shines, wholly above the horizon of a point; nothing between. */
static question ask_ball(random_stream *g, int i)
{
    question q;
    (void)i;
    memset(&q, 0, sizeof q);
    q.s.eps = (real)1e-5;
    first_material m = {.kd = {(real)0.5, (real)0.5, (real)0.5}, .ke = some_colour(g, 1, 20)};
    real R = exam_between(g, 0.2, 1);
    vec3 c = vec(exam_between(g, -2, 2), exam_between(g, 1.1, 3), exam_between(g, -2, 2));
    vec3 p = exam_vector(g, 3);
    first_add_ball(&q.s, vadd(c, p), R, m);
    q.x = (first_point){.p = p, .n = {0, 1, 0}, .v = {0, 1, 0}, .kd = some_colour(g, 0.1, 0.9)};
    q.seed = random_next_bits(g), q.samples = 4000;
    return q;
}

/* The irradiance of a ball above the horizon is pi Le (R / d)^2 cos: kd Le (R / d)^2 cos is due.
 * Drawn from the cone, samples lie between its smallest and its largest cosine, times 2 (1 - cos
 * m). */
static bool mark_ball(const question *q, const answer *a, char why[exam_why])
{
    sphere ball = q->s.thing[0].ball;
    vec3 to = vsub(ball.c, q->x.p), full = vmul(q->x.kd, q->s.thing[0].m.ke);
    real d = vlength(to), sine = ball.r / d, m = asin(sine), up = vdot(to, q->x.n) / d;
    real angle = acos(real_clamp(up, -1, 1));
    real low = cos(real_min(angle + m, pi)), high = cos(real_max(angle - m, 0));
    real wide = 4 * sin(m / 2) * sin(m / 2);
    vec3 due = vscale(full, sine * sine * up);
    vec3 most = vscale(full, wide * (high - low) / 2);
    vec3 sigma = vscale(most, 1 / sqrt((real)q->samples));
    sigma = vmadd(sigma, due, (real)1e-8);
    if (!mark_mean(q, a->mean, due, sigma, "direct light of a ball", why)) return false;
    for (int k = 0; k < 3; k++) {
        real mean = vaxis(a->mean, k), v = vaxis(a->square, k) - mean * mean;
        /* 1e-8: what is left of a difference of two squares */
        if (v > (real)1.1 * vaxis(most, k) * vaxis(most, k) + (real)1e-8 * mean * mean)
            return exam_say(why,
                            "the mean is right, the deviation of a sample is not: at most %.4g is "
                            "due if directions are drawn from the cone, yours is %.4g",
                            vaxis(most, k), sqrt(v));
    }
    return true;
}

static const exam_check public_checks[] = {
    {1, "a lamp above", 5, false, 40, ask_lamp, mark_lamp},
    {2, "a room open to one side", 10, false, 6, ask_open_room, mark_room},
    {3, "grey furnace", 10, false, 24, ask_furnace, mark_furnace},
    {4, "a ball above", 10, false, 40, ask_ball, mark_ball},
};
#endif
