/* 05_implicit: the interval search against closed forms, Sturm chains, integers; what each method
 * misses; strange functions, strange rays. The oracles: implicit_oracle.h, wide numbers. */
#include "../chapters/05_implicit/lab/implicit_trials.h"
#include "check.h"

static const double eps = (double)real_epsilon;
static const hit untouched = {7, 7, 7, 7};

static real random_signed(random_stream *s) { return 2 * random_next(s) - 1; }

static const implicit_how methods[4] = {{IMPLICIT_FIRST, 64, 0}, {IMPLICIT_NEWTON, 16, 0},
                                        {IMPLICIT_TRACE, 4096, (real)1e-5},
                                        {IMPLICIT_INTERVAL, 0, 0}};

/* Of each of four surfaces: 1e6 in all with CHECK_SOAK, few enough for a second or two else. */
static size_t many(size_t n) { return getenv("CHECK_SOAK") ? 250000 : check_count(n); }

/* Closed intervals, a ball of radius 1 at (0, 0, 0) seen from z = 3: roots at 2 and 4. */
static void test_closed_form(void)
{
    const implicit_subject u = implicit_subject_of(IMPLICIT_SPHERE);
    const struct { real tmin, tmax, t; const char *why; } in[] = {
        {0, real_infinity, 2, "all in front"}, {2, 4, 2, "both ends belong to the interval"},
        {2, 2, 2, "an interval of one point"}, {3, 4, 4, "entry before tmin, exit at tmax"},
        {4, 4, 4, "exit alone"}, {-real_infinity, real_infinity, 2, "no ends"}};
    for (size_t i = 0; i < sizeof in / sizeof *in; i++) {
        hit h = hit_none;
        ray r = {{0, 0, 3}, in[i].tmin, {0, 0, -1}, in[i].tmax};
        check(implicit_hit(&u.s, r, &h), "%s", in[i].why);
        check_close(h.t, in[i].t, 4 * eps, "%s", in[i].why);
        check(h.u == 0 && h.v == 0 && h.shape == 0, "no u, v, shape of its own");
        check(h.t >= in[i].tmin && h.t <= in[i].tmax, "t lies in the interval: %s", in[i].why);
    }
    const real near = 1 - 3 * real_epsilon / 2, beyond = 1 - 4 * real_epsilon;
    check(implicit_hit(&u.s, (ray){{0, 0, 3}, 3, {0, 0, -1}, 4 * near}, &(hit){0}),
          "beyond tmax by 3/2 epsilon: t may be rounded");
    check(!implicit_hit(&u.s, (ray){{0, 0, 3}, 3, {0, 0, -1}, 4 * beyond}, &(hit){0}),
          "beyond tmax by 4 epsilon: a miss");
    const struct { real tmin, tmax; } out[] = {
        {0, (real)1.99}, {(real)2.01, (real)3.99}, {5, 9}, {3, 1}, {(real)NAN, 9}, {0, (real)NAN}};
    for (size_t k = 0; k < 4; k++)
        for (size_t i = 0; i < sizeof out / sizeof *out; i++) {
            hit h = untouched;
            ray r = {{0, 0, 3}, out[i].tmin, {0, 0, -1}, out[i].tmax};
            check(!implicit_method_hit(methods[k], &u.s, r, &h) && h.t == 7 && h.shape == 7,
                  "outside %zu, method %zu: a miss, and *out untouched", i, k);
        }
    for (size_t k = 0; k < 4; k++) {
        hit h = untouched;
        ray r = ray_from(vec(0, (real)0.3, 3), vec(0, 0, -2));
        check(implicit_method_hit(methods[k], &u.s, r, &h), "method %zu hits", k);
        check_close(h.t, (3 - sqrt(1 - 0.09)) / 2, k == 2 ? 1e-4 : 40 * eps, "method %zu", k);
    }
}

/* A random pair of intervals and a point of each: the result of the points, in 32 digits, lies in
 * the result of the intervals. Rounded to the nearest it does not. */
static void test_intervals(void)
{
    size_t out[6] = {0}, naive = 0, n = check_count(200000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(1, i, 0);
        double e[6];
        for (int k = 0; k < 6; k++)
            e[k] = (double)random_signed(&s) * exp2(floor(20 * (double)random_signed(&s)));
        for (int k = 4; k < 6; k++) e[k] = random_double_of(random_next_bits(&s));
        interval a = {fmin(e[0], e[1]), fmax(e[0], e[1])}, b = {fmin(e[2], e[3]), fmax(e[2], e[3])};
        if (i % 3 == 0) a.hi = a.lo, b.hi = b.lo;
        double x = i % 2 ? a.lo : fmin(a.lo + e[4] * (a.hi - a.lo), a.hi);
        double y = i % 5 ? b.hi : fmin(b.lo + e[5] * (b.hi - b.lo), b.hi);
        const wide due[6] = {wide_sum(x, y), wide_sum(x, -y), wide_product(x, y),
                             wide_product(x, x), wide_div(wide_of(x), wide_of(y)),
                             wide_sqrt(wide_of(fabs(x)))};
        const interval is[6] = {interval_add(a, b), interval_sub(a, b), interval_mul(a, b),
                                interval_square(a), interval_div(a, b),
                                interval_sqrt(interval_abs(a))};
        for (int k = 0; k < 6; k++)
            out[k] += wide_sign(wide_sub(due[k], wide_of(is[k].lo))) < 0
                   || wide_sign(wide_sub(wide_of(is[k].hi), due[k])) < 0;
        naive += i % 3 == 0 && wide_sign(wide_sub(due[0], wide_of(a.lo + b.lo))) != 0;
    }
    const char *name[6] = {"+", "-", "*", "square", "/", "sqrt"};
    for (int k = 0; k < 6; k++) check_equal(out[k], 0, "%s leaves nothing out, of %zu", name[k], n);
    check_at_least(naive, n / 100, "x + y, rounded to the nearest, is not x + y");
    size_t waves = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(2, i, 0);
        double lo = 40 * (double)random_signed(&s), w = exp2(6 * (double)random_signed(&s) - 3);
        double x = fmin(lo + w * (double)random_next(&s), lo + w);
        interval a = {lo, lo + w};
        waves += !interval_has(interval_sin(a), sin(x)) || !interval_has(interval_cos(a), cos(x));
    }
    check_equal(waves, 0, "sine and cosine leave nothing out, of %zu", n);
    interval crest = interval_sin(interval_of(1, 2)), fall = interval_cos(interval_of(1, 2));
    check(crest.hi == 1 && crest.lo < 0.8415 && crest.lo > 0.8414, "sin [1, 2]: from sin 1 to 1");
    check(fall.lo > -0.4162 && fall.hi < 0.5404, "cos [1, 2] is as narrow as it can be");
}

static void test_strange_intervals(void)
{
    const double inf = HUGE_VAL;
    interval e = interval_empty, all = interval_all, one = interval_at(1), z = {0, inf};
    check(interval_is_empty(interval_sqrt(interval_of(-2, -1))), "sqrt of negatives is empty");
    interval part = interval_sqrt(interval_of(-1, 4));
    check(part.lo == 0 && part.hi >= 2 && part.hi < 2.0000001, "sqrt of [-1, 4] is [0, 2]");
    const interval nothing[] = {
        interval_add(e, one), interval_mul(one, e), interval_div(e, one), interval_min(one, e),
        interval_min(e, one), interval_abs(e), interval_square(e), interval_sin(e),
        interval_meet(e, one), interval_div(one, interval_at(0))};
    for (size_t k = 0; k < sizeof nothing / sizeof *nothing; k++)
        check(interval_is_empty(nothing[k]), "what is computed from nothing is nothing, %zu", k);
    check(interval_has(interval_mul(interval_at(0), all), 5), "0 times anything may be anything");
    check(interval_has(interval_div(one, interval_of(-1, 1)), 1e300), "1 / [-1, 1]: anything");
    interval big = interval_mul(interval_at(1e300), interval_at(1e300));
    check(big.lo > 1.79e308 && big.hi == inf, "1e600 lies between 1.79e308 and infinity");
    check(interval_has(interval_mul(z, interval_of(-1, 1)), -1e308), "[0, inf] [-1, 1]");
    check(interval_has(interval_sub(z, z), -1e308), "inf - inf");
    interval tiny = interval_mul(interval_at(1e-300), interval_at(1e-300));
    check(tiny.lo <= 0 && tiny.hi > 0 && tiny.hi < 1e-320, "1e-600 is not 0");
    check(interval_hull(e, one).lo == 1 && interval_hull(one, e).hi == 1, "a hull with nothing");
}

/* f over a piece of the ray: at points of it f lies in f(T), chords have slopes that lie in f'(T),
 * by as much as f itself rounds. And f, as a real, keeps its Lipschitz bound; gradients agree. */
static void test_surfaces(void)
{
    for (int q = 0; q < implicit_names; q++) {
        implicit_subject u = implicit_subject_of((implicit_name)q);
        size_t outside = 0, steep = 0, faster = 0, crooked = 0, n = check_count(10000);
        double B = (double)u.s.ball.r, noise = 0;
        for (size_t i = 0; i < n; i++) {
            random_stream s = random_start(3, i, (uint64_t)q);
            ray r = implicit_ray_anywhere(&u, &s);
            if (!implicit_clip(&u.s, &r)) continue;
            real w = r.tmax - r.tmin, t0 = r.tmin + w * random_next(&s);
            real t1 = real_min(r.tmax, t0 + w * pow((real)10, -4 * random_next(&s)));
            real t = real_min(t0 + (t1 - t0) * random_next(&s), t1);
            jet J = implicit_range(&u.s, r, interval_of((double)t0, (double)t1));
            double f0 = (double)implicit_value(&u.s, ray_at(r, t0));
            double f = (double)implicit_value(&u.s, ray_at(r, t));
            double L = (double)u.s.lipschitz;
            double slack = 400 * eps * (1 + interval_size(J.v) + B * L);
            outside += !(f >= J.v.lo - slack && f <= J.v.hi + slack);
            interval chord = {f - f0 - 2 * slack, f - f0 + 2 * slack};
            interval may = interval_mul(J.d, interval_at((double)(t - t0)));
            steep += interval_is_empty(interval_meet(chord, may));
            real along = u.s.ball.r * random_next(&s);
            vec3 a = ray_at(r, t0), b = vmadd(u.s.ball.c, implicit_random_direction(&s), along);
            double apart = (double)vlength(vsub(a, b));
            double rise = fabs(f0 - (double)implicit_value(&u.s, b));
            faster += rise > L * apart + slack;
            if (u.s.gradient) {
                vec3 g = implicit_gradient(&u.s, b), d = implicit_differences(&u.s, b);
                double off = (double)vlength(vsub(g, d));
                noise = check_worse(noise, off / L);
                crooked += !(off <= 100 * pow(eps, 2.0 / 3) * L);
            }
        }
        const char *name = implicit_name_of[q];
        check_equal(outside, 0, "%s: f lies in f(T), of %zu", name, n);
        check_equal(steep, 0, "%s: slopes lie in f'(T)", name);
        check_equal(faster, 0, "%s: the Lipschitz bound holds", name);
        check_equal(crooked, 0, "%s: gradients as by differences: %g", name, noise);
    }
}

/* The quartic of a torus and its distance have one sign, and its gradient is that of differences; R
 * is not 1, as it is elsewhere. */
static void test_two_tori(void)
{
    const implicit_ring ring = {(real)1.25, (real)0.5};
    const implicit_surface quartic = implicit_torus(&ring), tube = implicit_torus_distance(&ring);
    size_t differ = 0, n = check_count(20000);
    double off = 0, bound = 100 * pow(eps, 2.0 / 3) * (double)quartic.lipschitz;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(23, i, 0);
        vec3 p = random_in_cube(&s, 2), g = implicit_gradient(&quartic, p);
        off = check_worse(off, (double)vlength(vsub(g, implicit_differences(&quartic, p))));
        real f = implicit_value(&quartic, p), d = implicit_value(&tube, p);
        differ += fabs(d) > (real)1e-3 && (f < 0) != (d < 0);
    }
    check_equal(differ, 0, "inside for one and outside for the other, of %zu points", n);
    check_at_most(off, bound, "the gradient");
}

/* 50 of the 65 double points of Barth's sextic: on the axes of 15 turns at distance 1, at the 20
 * corners of a dodecahedron at sqrt(3). f and its gradient are 0 there; the normal is defined. */
static void test_double_points(void)
{
    implicit_subject u = implicit_subject_of(IMPLICIT_BARTH);
    const double g = implicit_golden;
    const double at[4][3] = {{0, 0, 1}, {0.5, g / 2, (g - 1) / 2}, {1, 1, 1}, {0, g - 1, g}};
    double f = 0, gradient = 0;
    for (int k = 0; k < 4; k++)
        for (int turn = 0; turn < 3; turn++)
            for (int sign = 0; sign < 8; sign++) {
                double p[3];
                for (int i = 0; i < 3; i++)
                    p[(i + turn) % 3] = at[k][i] * (sign >> i & 1 ? -1 : 1);
                double v = (double)implicit_value(&u.s, vec(p[0], p[1], p[2]));
                double slope = (double)vlength(implicit_gradient(&u.s, vec(p[0], p[1], p[2])));
                f = check_worse(f, fabs(v)), gradient = check_worse(gradient, slope);
            }
    /* 96, some more than once: each must be one, whichever way the pattern is turned */
    check_at_most(f, 100 * eps, "f in a double point: terms of size 30");
    check_at_most(gradient, 1000 * eps, "and its gradient: some ten times as much");
    implicit_subject ball = implicit_subject_of(IMPLICIT_SPHERE);
    check(vzero(implicit_normal(&ball.s, vec(0, 0, 0))), "no gradient, no normal");
    vec3 n = implicit_normal(&ball.s, vec(0, 0, 3));
    check(n.x == 0 && n.y == 0 && n.z == 1, "the normal points outwards");
    implicit_subject tube = implicit_subject_of(IMPLICIT_TUBE);
    vec3 up = implicit_normal(&tube.s, vec(1, 0, (real)0.3));
    check_close(up.z, 1, 1000 * pow(eps, 2.0 / 3), "a normal by differences");
}

/* 2 x^3 + x - 1 from 0 to 1: by (5.7) the first step from 0 ends at 1, where it may not go; and a
 * plane, which one step meets: nothing else is asked. */
static real cubic(const void *data, vec3 p) { return (void)data, (2 * p.x * p.x + 1) * p.x - 1; }
static vec3 cubic_gradient(const void *data, vec3 p)
{
    return (void)data, (vec3){6 * p.x * p.x + 1, 0, 0};
}
static real flat_counted(const void *data, vec3 p)
{
    ++**(size_t *const *)data;
    return p.x - (real)0.25;
}
static vec3 flat_gradient(const void *data, vec3 p) { return (void)data, (void)p, (vec3){1, 0, 0}; }

static void test_newton(void)
{
    size_t asked = 0, *counter = &asked;
    implicit_surface s = {.f = cubic, .gradient = cubic_gradient};
    implicit_surface flat = {.f = flat_counted, .gradient = flat_gradient, .data = &counter};
    ray r = ray_from(vec(0, 0, 0), vec(1, 0, 0));
    real t = implicit_polish(&s, r, implicit_end_at(&s, r, 0), implicit_end_at(&s, r, 1));
    double a = 0.25, b = sqrt(1 / 16.0 + 1 / 216.0);
    check_close((double)t, cbrt(a + b) + cbrt(a - b), 2 * eps, "a cubic's root, by Cardano");
    implicit_end from = implicit_end_at(&flat, r, 0), to = implicit_end_at(&flat, r, 1);
    asked = 0;
    check_equal((double)implicit_polish(&flat, r, from, to), 0.25, "a plane's");
    check_equal(asked, 1, "by one step");
}

/* Nothing missed, nothing made up, of rays anywhere and of grazing rays; and what the naive method
 * makes of the same. */
static void test_nothing_missed(void)
{
    const implicit_how sure = {IMPLICIT_INTERVAL, 0, 0}, naive = {IMPLICIT_FIRST, 128, 0};
    const implicit_how newton = {IMPLICIT_NEWTON, 32, 0};
    for (int q = IMPLICIT_SPHERE; q <= IMPLICIT_BARTH; q++)
        for (int aim = IMPLICIT_ANYWHERE; aim <= IMPLICIT_GRAZING; aim++) {
            implicit_subject u = implicit_subject_of((implicit_name)q);
            size_t n = aim == IMPLICIT_GRAZING ? many(20000) : check_count(10000);
            implicit_survey y = implicit_survey_of(&u, sure, 5, (implicit_aim)aim, n, 1);
            const char *name = implicit_name_of[q];
            check_at_least(y.due, n / 3, "%s: many are due a hit, of %zu", name, n);
            check_at_most(y.due, n - n / 10, "%s: and many none", name);
            check_at_most(y.unsure, n / 1000, "%s: the oracle can tell", name);
            check_equal(y.missed, 0, "%s, %s: missed of %zu [%%]", name,
                        aim ? "grazing" : "anywhere", n);
            /* Rounding of f, some 1e-15, hides a miss by as much; none is aimed so near */
            check_equal(y.made_up, 0, "%s: made up [%%]", name);
            /* At worst a piece as wide as the root of f's rounding: 1e-15 gives 3e-8 (a cone of
             * Barth's sextic came to 1e-8 in 1e6 rays); float rounds t itself. */
            check_at_most(y.off, real_is_float ? 8 * eps : 3e-8, "%s: t", name);
            if (q == IMPLICIT_SPHERE || aim == IMPLICIT_ANYWHERE) continue;
            y = implicit_survey_of(&u, naive, 5, IMPLICIT_GRAZING, check_count(8000), 1);
            check_at_least(y.missed, 10, "%s: 128 steps miss grazing rays [%%]", name);
            y = implicit_survey_of(&u, newton, 5, IMPLICIT_GRAZING, check_count(8000), 1);
            check_at_most(y.missed, real_is_float ? 5 : 1, "%s: Newton misses few [%%]", name);
        }
}

/* A ray along a double root, exactly: p on the sphere of integer radius, d at a right angle, o some
 * steps of d before p. f is (d.d)(t - k)^2, and never changes its sign. */
static void test_tangents(void)
{
    size_t missed = 0, naive = 0, n = check_count(4000), judged = 0;
    double worst = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(7, i, 0);
        int v[7];
        for (int k = 0; k < 7; k++) v[k] = (int)(random_next_bits(&s) % 15) - 7;
        int m = v[0], l = v[1], a = v[2], b = v[3];
        vec3 p = vec(m * m + l * l - a * a - b * b, 2 * (m * b + l * a), 2 * (l * b - m * a));
        real R = (real)(m * m + l * l + a * a + b * b), k = (real)(2 + i % 5);
        vec3 d = vcross(p, vec(v[4], v[5], v[6]));
        if (vzero(d) || !(R > 0)) continue;
        implicit_surface ball = implicit_sphere(&R);
        ball.ball.r *= 2;  /* not around the middle of the chord */
        ball.ball.c.x = R / 3;
        ray r = ray_from(vmadd(p, d, -k), d);
        hit h = untouched;
        judged++;
        if (implicit_hit(&ball, r, &h)) worst = check_worse(worst, fabs((double)(h.t - k)));
        else missed++;
        naive += !implicit_first_hit(&ball, r, 128, &h);
    }
    check_at_least(judged, n / 2, "the test sees tangents");
    check_equal(missed, 0, "exact tangents missed by the intervals, of %zu", judged);
    check_at_least(naive, judged / 2, "and by 128 steps");
    /* f, in double, rounds by some 30 eps of its terms, up to 30 R^2: t by the root of it over |d|,
     * and |d| >= R / 10 for most; t itself, up to 6, rounds */
    check_at_most(worst, 300 * sqrt(DBL_EPSILON) + 4 * eps, "t of a double root");
}

/* All roots of a line, against Sturm: how many, and each proven. */
static void test_all_roots(void)
{
    for (int q = IMPLICIT_SPHERE; q <= IMPLICIT_BARTH; q++) {
        implicit_subject u = implicit_subject_of((implicit_name)q);
        size_t wrong = 0, unproven = 0, most = 0, disorder = 0, first = 0;
        const size_t n = 300 + check_count(8000);
        for (size_t i = 0; i < n; i++) {
            random_stream s = random_start(8, i, (uint64_t)q);
            ray r = implicit_ray_anywhere(&u, &s);
            implicit_root root[8];
            implicit_truth truth;
            if (!implicit_truth_of(&u, r, &truth)) continue;
            int roots = implicit_roots(&u.s, r, root, 8);
            wrong += roots != truth.roots;
            for (int k = 0; k < roots; k++) unproven += !root[k].single;
            for (int k = 1; k < roots; k++) disorder += !(root[k].lo > root[k - 1].hi);
            first += roots > 0 && !(root[0].lo <= truth.first + 1e-15 * fabs(truth.first)
                                    && root[0].hi >= truth.first - 1e-15 * fabs(truth.first));
            if ((size_t)roots > most) most = (size_t)roots;
        }
        const char *name = implicit_name_of[q];
        check_equal(wrong, 0, "%s: as many roots as Sturm's chain has, of %zu rays", name, n);
        check_equal(first, 0, "%s: the first one lies in its interval", name);
        check_equal(unproven, 0, "%s: each proven to be single", name);
        check_equal(disorder, 0, "%s: in order, and apart", name);
        check_at_least(most, q == IMPLICIT_SPHERE ? 2 : 4, "%s: the most roots of a ray", name);
    }
    implicit_subject ball = implicit_subject_of(IMPLICIT_SPHERE), free = ball;
    implicit_root one[1], cut[8];
    free.s.ball.r = real_infinity;
    for (int k = 2; k <= 64; k++) {  /* a root just where [0, k] is cut, or where its halves are */
        ray from = {{0, 0, 1 + (real)k / 2}, 0, {0, 0, -1}, (real)k};
        int due = 2 + k / 2.0 <= k ? 2 : 1;  /* roots at k / 2 and k / 2 + 2 */
        int is = implicit_roots(&free.s, from, cut, 8);
        check(is == due && cut[0].single && cut[is - 1].single, "cut at a root, k = %d: %d", k, is);
    }
    ray r = ray_from(vec(0, 0, 3), vec(0, 0, -1));
    check(implicit_roots(&ball.s, r, one, 1) == 1 && one[0].lo <= 2 && one[0].hi >= 2,
          "an array of one gets the first");
}

/* Sphere tracing on distances never goes past the surface; the naive bound makes holes. */
static void test_tracing(void)
{
    size_t past = 0, unmet = 0, holes = 0, n = check_count(20000);
    real e = real_is_float ? (real)1e-4 : (real)1e-7;
    double off = 0;
    for (size_t i = 0; i < n; i++) {
        implicit_subject u = implicit_subject_of((implicit_name[]){
            IMPLICIT_TUBE, IMPLICIT_BOX, IMPLICIT_BLEND}[i % 3]);
        random_stream s = random_start(10, i, 0);
        ray r = ray_unit(implicit_ray_anywhere(&u, &s));
        hit a = untouched, b = untouched;
        if (!implicit_hit(&u.s, r, &a)) continue;
        bool is = implicit_trace_hit(&u.s, r, e, 100000, &b);
        unmet += !is;
        past += is && b.t > a.t + 100 * real_epsilon;
        double f = fabs((double)implicit_value(&u.s, ray_at(r, b.t)));
        if (is) off = check_worse(off, f);
        u.s.lipschitz = (real)0.1;
        holes += !implicit_trace_hit(&u.s, r, e, 100000, &b) || b.t > a.t + (real)0.01;
    }
    check_equal(past, 0, "traced past the first root, of %zu", n);
    check_equal(unmet, 0, "hits that sphere tracing does not meet");
    check_at_most(off, (double)e * 1.001, "a hit is within eps");
    check_at_least(holes, n / 20, "a bound that is none makes holes");
    implicit_subject tube = implicit_subject_of(IMPLICIT_TUBE);
    hit h = untouched;
    ray r = ray_from(vec(-3, 0, (real)0.3001), vec(1, 0, 0));  /* passes 1e-4 above the tube */
    check(!implicit_hit(&tube.s, r, &h) && h.t == 7, "passes above: a miss");
    check(implicit_trace_hit(&tube.s, r, (real)1e-3, 4096, &h), "but within eps: made up");
    check(!implicit_trace_hit(&tube.s, r, (real)1e-5, 10, &h), "too few steps: a miss");
}

/* Functions that are no polynomials of good behaviour, along x. */
static real step_f(const void *data, vec3 p) { return (void)data, 1 / p.x; }
static jet step_range(const void *data, jet x, jet y, jet z)
{
    (void)data, (void)y, (void)z;
    interval one = interval_at(1);
    return (jet){interval_div(one, x.v),
                 interval_neg(interval_div(x.d, interval_square(x.v)))};
}
static real nan_f(const void *data, vec3 p) { return (void)data, (void)p, (real)NAN; }
static jet nan_range(const void *data, jet x, jet y, jet z)
{
    (void)data, (void)x, (void)y, (void)z;
    return (jet){interval_empty, interval_empty};
}
static jet all_range(const void *data, jet x, jet y, jet z)
{
    (void)data, (void)x, (void)y, (void)z;
    return (jet){interval_all, interval_all};
}
/* max(|x - 1| - 1/2, 0): 0 from 1/2 to 3/2. */
static real flat_f(const void *data, vec3 p)
{
    return (void)data, real_max(fabs(p.x - 1) - (real)0.5, 0);
}
static jet flat_range(const void *data, jet x, jet y, jet z)
{
    (void)data, (void)y, (void)z;
    const jet none = {interval_at(0), interval_at(0)};
    return jet_max(jet_shift(jet_abs(jet_shift(x, -1)), -0.5), none);
}
/* sqrt(x) - 1: defined for x >= 0 alone. */
static real half_f(const void *data, vec3 p) { return (void)data, sqrt(p.x) - 1; }
static jet half_range(const void *data, jet x, jet y, jet z)
{
    (void)data, (void)y, (void)z;
    interval v = interval_sqrt(x.v);
    interval d = interval_div(x.d, interval_add(v, v));
    return (jet){interval_sub(v, interval_at(1)), d};
}

/* Behind the ray's origin an interval is cut as in front: the mirror image. */
static void test_middle(void)
{
    const double ends[] = {0, 1e-3, 1, 63, 65, 1e4, 1e30};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++)
        for (size_t j = i + 1; j < sizeof ends / sizeof *ends; j++) {
            double a = ends[i], b = ends[j], middle = implicit_middle(interval_of(a, b));
            check(a < middle && middle < b, "a cut of [%g, %g] lies inside", a, b);
            check_equal(implicit_middle(interval_of(-b, -a)), -middle, "[%g, %g]", -b, -a);
        }
    check_close(implicit_middle(interval_of(1, 1e30)), 1e15, 1, "at half of the digits");
}

/* Each by implicit_hit, which takes the search, sphere tracing or Newton: t < 0 for a miss. */
static void test_strange_functions(void)
{
    const sphere everywhere = {{0, 0, 0}, real_infinity}, near = {{0, 0, 0}, 9};
    const ray along = {{-3, 0, 0}, 0, {1, 0, 0}, 7}, away = ray_from(vec(0, 0, 3), vec(0, 0, 1));
    const ray r = {{0, 0, 3}, 0, {0, 0, -1}, real_infinity};
    const ray line = {r.o, -real_infinity, r.d, real_infinity};
    const ray slow = ray_from(r.o, vec(0, 0, -1e-12));
    implicit_surface ball = implicit_subject_of(IMPLICIT_SPHERE).s, free = ball, only = ball;
    implicit_surface traced = ball, pole = {step_f, NULL, step_range, 0, near, NULL};
    implicit_surface dark = {nan_f, NULL, all_range, 0, near, NULL};
    free.ball = everywhere;
    traced.range = only.range = NULL, only.lipschitz = 0;
    const struct { implicit_surface s; ray r; double t, bound; const char *why; } in[] = {
        {pole, along, -1, 0, "1 / x changes its sign, and is never 0"},
        {{nan_f, NULL, nan_range, 1, near, NULL}, along, -1, 0, "NaN: no surface, by intervals"},
        {{nan_f, NULL, NULL, 1, near, NULL}, along, -1, 0, "nor by sphere tracing"},
        {{nan_f, NULL, NULL, 0, near, NULL}, along, -1, 0, "nor by Newton"},
        {{flat_f, NULL, flat_range, 1, near, NULL}, along, 3.5, 1e-9,
         "f is 0 in a piece of the ray: a hit at its beginning"},
        {{half_f, NULL, half_range, 0, near, NULL}, along, 4, 8 * eps,
         "defined in part: sqrt x = 1"},
        {free, r, 2, 4 * eps, "no ball, no end of the interval: the same root"},
        {free, line, 2, 4 * eps, "nor a beginning"},
        {free, slow, 2e12, 8e12 * eps, "nor a d of any length: in float t0 and t1 are infinite"},
        {free, away, -1, 0, "away from it, without end: a miss"},
        {only, r, 2, 40 * eps, "no range, no bound: Newton"},
        {traced, r, 2, 2e-4, "with a bound: sphere tracing, within its eps"}};
    hit h;
    for (size_t k = 0; k < sizeof in / sizeof *in; k++) {
        h = untouched;
        bool is = implicit_hit(&in[k].s, in[k].r, &h);
        check(is == (in[k].t >= 0) && (is || h.t == 7), "%s", in[k].why);
        if (is) check_close(h.t, in[k].t, in[k].bound, "%s", in[k].why);
    }
    check(implicit_first_hit(&pole, along, 100, &h), "steps and halving take a pole for a root");
    check(vzero(implicit_normal(&dark, along.o)), "a normal of NaN is 0");
    implicit_search z = implicit_search_begin(&dark, along);
    implicit_root root;
    check(!implicit_next(&z, &root) || !root.single, "a range that says nothing proves nothing");
    check_at_most(z.pieces, implicit_most_pieces + 1, "and is given up");
    check(!implicit_trace_hit(&only, r, (real)1e-4, 1000, &h), "no bound: no sphere tracing");
    check(!implicit_search_hit(&only, r, &h), "no range: no search");
}

static void test_strange_rays(void)
{
    implicit_surface ball = implicit_subject_of(IMPLICIT_SPHERE).s;
    hit h = untouched;
    for (size_t m = 0; m < 4; m++) {
        for (int k = 0; k < 6; k++)
            for (int what = 0; what < 3; what++) {
                real v[6] = {0, 0, 3, 0, 0, -1};
                v[k] = what == 0 ? (real)NAN : what == 1 ? real_infinity : -real_infinity;
                h = untouched;
                check(!implicit_method_hit(methods[m], &ball, ray_from(vec(v[0], v[1], v[2]),
                                           vec(v[3], v[4], v[5])), &h) && h.t == 7,
                      "input %d not finite (%d), method %zu: a miss", k, what, m);
            }
        h = untouched;
        check(!implicit_method_hit(methods[m], &ball, ray_from(vec(0, 0, 1), vec(0, 0, 0)), &h)
              && h.t == 7, "no direction, method %zu: a miss", m);
        check(implicit_method_hit(methods[m], &ball, ray_from(vec(0, 0, 0), vec(0, 2, 0)), &h),
              "from inside, method %zu", m);
        check_close(h.t, 0.5, m == 2 ? 1e-4 : 8 * eps, "the exit");
    }
    const real off = 64 * real_epsilon;
    const struct { real z, tmin, d; double t, bound; const char *why; } from[] = {
        {1, 0, -1, 0, 0, "from the surface, inwards: a hit at 0"},
        {1, 0, 1, 0, 4 * eps, "and outwards, too: closed"},
        {1 + off, 0, 1, -1, 0, "64 epsilon above it, outwards: a miss"},
        {1 - off, 0, 1, 64 * eps, 8 * eps, "64 epsilon below, outwards: a hit"},
        {1, (real)0.001, -1, 2, 8 * eps, "from the surface, its own t left out: the far side"}};
    for (size_t k = 0; k < sizeof from / sizeof *from; k++) {
        ray r = {{0, 0, from[k].z}, from[k].tmin, {0, 0, from[k].d}, real_infinity};
        h = untouched;
        bool is = implicit_hit(&ball, r, &h);
        check(is == (from[k].t >= 0) && (is || h.t == 7), "%s", from[k].why);
        if (is) check_close(h.t, from[k].t, from[k].bound, "%s", from[k].why);
    }
}

/* An interval cut at the hit: it is still there, and nothing comes before. */
static void test_invariants(void)
{
    size_t cut = 0, rest = 0, n = check_count(8000), hits = 0;
    for (size_t i = 0; i < n; i++) {
        implicit_subject u = implicit_subject_of((implicit_name)(i % implicit_names));
        ray r;
        hit a = untouched, b = untouched;
        implicit_shot(&u, 11, IMPLICIT_ANYWHERE, i, &r);
        if (!implicit_hit(&u.s, r, &a)) continue;
        double t = (double)a.t;
        hits++;
        r.tmax = a.t;
        /* t is known to the rounding of f over its slope; some rays graze by chance: slope 1e-5 */
        cut += !implicit_hit(&u.s, r, &b) || fabs((double)b.t - t) > fmax(64 * eps, 1e-10) * t;
        r.tmax = a.t * (1 - 64 * real_epsilon);
        rest += implicit_hit(&u.s, r, &b) && (double)b.t < t * (1 - 1e-6);
    }
    check_at_least(hits, n / 4, "the test sees hits");
    check_equal(cut, 0, "an interval that ends at the hit has it still");
    check_equal(rest, 0, "and nothing comes before");
}

/* One or two numbers beside each other with a crest or a trough between them, as the signs of the
 * derivative say, which the library reduces to all digits: 1, or -1, is a value there. So far from
 * 0 that it is more than 2^-50 away at both; where a crest lies is off by up to 2^-53 of the way
 * (5.4 are owed; 1e-14 is 90, and costs nothing). */
static void test_crests_far_away(void)
{
    size_t n = check_sample(800000, 100000), lost = 0, tried = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(19, i, 0);
        double sign = i % 4 < 2 ? 1 : -1, first = i % 2 ? 1.5707963267948966 : 0;
        double turn = 6.283185307179586;
        double at = sign * exp2((double)random_between(&s, 20, 36));
        at = first + turn * (rint(at / turn) + (i % 8 < 4 ? 0 : 0.5));
        double slope = i % 2 ? cos(at) : -sin(at), bend = i % 2 ? -sin(at) : -cos(at);
        at -= slope / bend;
        slope = i % 2 ? cos(at) : -sin(at);
        interval a = slope * bend < 0 ? interval_of(at, nextafter(at, HUGE_VAL))
                                      : interval_of(nextafter(at, -HUGE_VAL), at);
        double before = i % 2 ? cos(a.lo) : -sin(a.lo), after = i % 2 ? cos(a.hi) : -sin(a.hi);
        if (!(before * after < 0)) continue;
        interval w = i % 2 ? interval_sin(a) : interval_cos(a);
        tried++, lost += !interval_has(w, before > 0 ? 1 : -1);
    }
    check_equal(lost, 0, "of %zu crests and troughs far away", tried);
    check_at_least(tried, n / 2, "that many lie between two numbers");
}

/* The series, to 30 digits. */
static wide wide_sine(double x)
{
    wide term = wide_of(x), sum = term, square = wide_product(-x, x);
    for (int k = 2; k < 60; k += 2) {
        term = wide_div(wide_mul(term, square), wide_of(k * (k + 1)));
        sum = wide_add(sum, term);
    }
    return sum;
}

/* sin(x) of the library is rounded: without 2^-50 the sine itself is not in [sin x, sin x]. */
static void test_sine_of_a_number(void)
{
    size_t lost = 0, n = 1000;
    for (size_t i = 0; i < n; i++) {
        double x = -3 + 6 * (double)i / (double)n;
        interval w = interval_sin(interval_at(x));
        lost += wide_sign(wide_sub(wide_sine(x), wide_of(w.lo))) < 0
                || wide_sign(wide_sub(wide_of(w.hi), wide_sine(x))) < 0;
    }
    check_equal(lost, 0, "sines outside of their interval, of %zu", n);
}

int main(void)
{
    return check_all("05_implicit", test_closed_form, test_intervals, test_crests_far_away,
                     test_sine_of_a_number, test_strange_intervals, test_surfaces,
                     test_two_tori, test_double_points, test_newton, test_nothing_missed,
                     test_tangents, test_all_roots, test_tracing, test_middle,
                     test_strange_functions, test_strange_rays, test_invariants);
}
