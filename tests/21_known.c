/* 21_distributed: area lights, lobes, skies, lenses, motion against closed forms. Each t-test has a
 * false-alarm rate of 1e-6; there are fewer than 200 of them: 2e-4 in all, with fixed seeds. */
#include "check.h"
#include "21_known.h"
#include "../chapters/21_distributed/lab/pool.h"

static const double alarm_rate = 1e-6;
static const sequence_kind kinds[3] = {SEQUENCE_RANDOM, SEQUENCE_JITTERED, SEQUENCE_SOBOL};

/* Sheets that end (known_far), glossy_above (1e-7); E in float is right to some 10 epsilon. */
static double rounding(void) { return 2.0 / known_far + 16 * (double)real_epsilon; }

/* Random samples are independent; well-spread ones are not, so their runs are the samples. No fewer
 * than 40 of them: with two or three, all may be alike by chance, as shares of 64 are. */
static void test_answers(void)
{
    size_t runs_due = check_sample(400, 40);
    for (int i = 0; i < known_kinds; i++) {
        known k;
        known_make((known_kind)i, &k);
        uint32_t n = (uint32_t)check_count(40000);
        double p = t_test(known_mean(&k, SEQUENCE_RANDOM, 7, 0, n), k.truth, rounding());
        check_at_least(p, alarm_rate, "%s, %u random samples", k.name, n);
        for (int m = 1; m < 3; m++) {
            estimate runs = {0};
            for (uint64_t run = 0; run < runs_due; run++)
                runs = estimate_add(runs, known_mean(&k, kinds[m], 8, run, 64).mean);
            p = t_test(runs, k.truth, rounding());
            check_at_least(p, alarm_rate, "%s, runs of 64 %s", k.name, sequence_name[kinds[m]]);
        }
        known_free(&k);
    }
}

/* Standard deviation of a slope over four levels of N, a factor of 4 apart, from runs whose rms is
 * known to 1/sqrt(2 runs): 1 / sqrt(2 runs) / (log 4 sqrt 5) = .228 / sqrt(runs). Five of them, and
 * .02 for N that are not yet large: less than the 1/4 between random and the others. */
static void test_slopes(void)
{
    static const known_kind asked[5] = {KNOWN_PENUMBRA, KNOWN_LOBE, KNOWN_SKY_DISK, KNOWN_LENS,
                                        KNOWN_SQUARE};
    size_t runs = check_sample(400, 50);
    double bound = 0.02 + 5 * 0.228 / sqrt((double)runs);
    for (int i = 0; i < 5; i++)
        for (int m = 0; m < 3; m++) {
            double x[4], y[4];
            known k;
            known_make(asked[i], &k);
            for (int l = 0; l < 4; l++) {
                estimate square = {0};
                uint32_t n = (uint32_t)16 << 2 * l;
                for (uint64_t run = 0; run < runs; run++) {
                    double off = known_mean(&k, kinds[m], 20 + (uint64_t)l, run, n).mean - k.truth;
                    square = estimate_add(square, off * off);
                }
                x[l] = log((double)n), y[l] = log(square.mean) / 2;
            }
            double slope = fit_line(x, y, 4).slope;
            if (m == 0) check_close(slope, -0.5, bound, "%s: random is N^-1/2", k.name);
            else if (asked[i] == KNOWN_SQUARE)
                check_at_most(slope, -0.9 + bound, "no edge: better than N^-0.9");
            else check_at_most(slope, -0.75 + bound, "%s: %s is N^-3/4 at an edge, or better",
                               k.name, sequence_name[kinds[m]]);
            known_free(&k);
        }
}

static void test_segment(void)
{
    double eps = (double)real_epsilon;
    check_close(known_segment(0), 0.5, eps, "half a disk");
    check_close(known_segment(0.5), 1 / 3.0 - sqrt(3.0) / (4 * (double)pi), eps, "beyond half");
    check_close(known_segment(-1), 1, eps, "all of it");
}

/* ---- area lights ---- */

/* A ball of radius 0 is the point light of 18, to the last bit, whatever u is. */
static void test_point(void)
{
    random_stream s = random_start(31, 0, 0);
    size_t n = check_count(20000), differ = 0, lit = 0;
    for (size_t i = 0; i < n; i++) {
        vec3 p = random_unit(&s), at = random_unit(&s);
        p = vscale(p, random_between(&s, 0, 5)), at = vscale(at, random_between(&s, 0, 5));
        vec3 ng = random_unit(&s), ns = vunit(vmadd(ng, random_unit(&s), 0.3));
        vec3 colour = {random_between(&s, 0, 9), random_between(&s, 0, 9), i % 7 ? 1 : 0};
        if (i % 11 == 0) colour = (vec3){0, 0, 0};
        if (i % 13 == 0) p = at;
        area_light L = {AREA_BALL, at, .colour = colour};
        light point = {LIGHT_POINT, at, colour};
        area_sample x;
        light_sample y;
        bool a = area_light_reaches(&L, p, ng, ns, (point2){(real)NAN, (real)NAN}, &x);
        bool b = light_reaches(&point, p, ng, ns, &y);
        differ += a != b || memcmp(&x.E, &y.E, sizeof x.E) != 0
                  || memcmp(&x.l, &y.l, sizeof x.l) != 0;
        differ += memcmp(&x.to, &at, sizeof at) != 0;
        lit += a;
    }
    check_equal(differ, 0, "a ball of no size and a point light");
    check(lit > 0, "some are lit");
    area_light L = {AREA_DISK, {0, 0, 2}, .n = {0, 0, -1}, .colour = {3, 3, 3}};
    area_sample x;
    vec3 up = {0, 0, 1}, p = {0, 0, 0};
    check(!area_light_has_size(&L), "no size");
    check(area_light_reaches(&L, p, up, up, (point2){(real)NAN, 0}, &x), "it shines");
    check_equal((double)x.E.x, 0.75, "I / d^2");
    L.a = (vec3){0, 0, 0}, L.b = (vec3){0, 1, 0};
    check(area_light_has_size(&L), "a line has a size");
    check(!vfinite(area_light_radiance(&L)) || vzero(area_light_radiance(&L)), "but no area");
}

/* On the ball, on its near side: to - p leads against the ball's normal there. */
static void test_ball(void)
{
    random_stream s = random_start(32, 0, 0);
    double off = 0, far = -1;
    for (size_t i = 0; i < check_count(20000); i++) {
        real away = random_between(&s, 1.0001, 4);
        vec3 at = vscale(random_unit(&s), away), p = {0, 0, 0};
        area_light L = {AREA_BALL, at, .r = 1, .colour = {1, 1, 1}};
        area_sample x;
        real u = random_next(&s), v = random_next(&s);
        if (i % 2) u = 1 - real_epsilon * (real)(i % 64);  /* the rim: rays that graze */
        area_light_reaches(&L, p, vunit(at), vunit(at), (point2){u, v}, &x);
        vec3 n = vsub(x.to, at);
        off = check_worse(off, fabs((double)vlength(n) - 1));
        far = check_worse(far, (double)vdot(n, x.l));
    }
    check_at_most(off, 16 * (double)real_epsilon, "off the ball");
    check_at_most(far, 16 * (double)real_epsilon, "on its far side");
    area_light L = {AREA_BALL, {0, 0, 0}, .r = 1, .colour = {1, 1, 1}};
    area_sample x;
    vec3 p = {0, 0, 0.5}, up = {0, 0, 1};
    check(!area_light_reaches(&L, p, vneg(up), vneg(up), (point2){0, 0}, &x), "from inside");
    check(vzero(x.E), "nothing");
}

/* Half sunk below the horizon: the cosine law is cut, and E is that of the visible part only:
 * a ball of sin beta = s, its middle in the horizon: L times the integral of
 * sin(phi) sin(alpha)^2 over half a turn and alpha < beta: L (beta - s cos beta). */
static void test_sunk_ball(void)
{
    double s = 0.5, beta = asin(s), L = 1 / ((double)pi * s * s);  /* I = 1, R = .5, d = 1 */
    double truth = L * (beta - s * cos(beta));
    area_light ball = {AREA_BALL, {1, 0, 0}, .r = 0.5, .colour = {1, 1, 1}};
    vec3 up = {0, 0, 1}, p = {0, 0, 0};
    estimate e = {0};
    size_t below = 0;
    for (uint32_t i = 0; i < check_count(40000); i++) {
        sampler q = sampler_start(SEQUENCE_RANDOM, 33, 0, i, 1);
        area_sample x;
        below += !area_light_reaches(&ball, p, up, up, sampler_pair(&q), &x);
        e = estimate_add(e, (double)x.E.x);
    }
    check_at_least(t_test(e, truth, 1e-12 + (double)real_epsilon), alarm_rate, "half a ball");
    check(below > 0, "half of its samples are below the horizon and call for no ray");
}

/* The light of the middle, below a square of side 2 at height 1: 4 L instead of 1.741 L. */
static void test_centre(void)
{
    area_light L = {AREA_RECTANGLE, {0, 0, 1}, {2, 0, 0}, {0, 2, 0}, {0, 0, -1}, 0, {4, 4, 4}};
    vec3 up = {0, 0, 1}, p = {0, 0, 0};
    estimate good = {0}, naive = {0};
    double truth = (double)pi * known_rectangle(-1, 1, -1, 1);
    for (uint32_t i = 0; i < check_count(10000); i++) {
        sampler q = sampler_start(SEQUENCE_RANDOM, 34, 0, i, 1);
        point2 u = sampler_pair(&q);
        area_sample x;
        area_light_reaches(&L, p, up, up, u, &x), good = estimate_add(good, (double)x.E.x);
        area_light_naive(&L, p, up, up, u, &x), naive = estimate_add(naive, (double)x.E.x);
    }
    check_at_least(t_test(good, truth, rounding()), alarm_rate, "every sample its own cosines");
    check_close(naive.mean / truth, 4 / 1.7408, 1e-3, "the middle's, for all of them");
    check_close((double)area_light_radiance(&L).x, 1, 4 * (double)real_epsilon, "L = I / A");
    /* far away all lights are points: (1 + 1/3 (a/d)^2) at most */
    L.at.z = 1000;
    area_sample x, y;
    area_light_reaches(&L, p, up, up, (point2){0.9, 0.1}, &x);
    area_light_naive(&L, p, up, up, (point2){0.9, 0.1}, &y);
    check_close((double)x.E.x / (double)y.E.x, 1, 3e-6, "at 1000 times its size");
}

/* Behind the light, behind the surface, by either normal; NaN; black: no ray. */
static void test_no_light(void)
{
    area_light L = {AREA_DISK, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, 0, {1, 1, 1}};
    vec3 up = {0, 0, 1}, down = {0, 0, -1}, p = {0, 0, 0}, nan = {(real)NAN, 0, 0};
    point2 u = {0.3, 0.6};
    area_sample x;
    check(area_light_reaches(&L, p, up, up, u, &x), "lit");
    check(!area_light_reaches(&L, p, down, up, u, &x) && vzero(x.E), "behind the surface");
    check(!area_light_reaches(&L, p, up, down, u, &x) && vzero(x.E), "by the shading normal");
    check(!area_light_reaches(&L, (vec3){0, 0, 2}, down, down, u, &x) && vzero(x.E), "behind it");
    check(!area_light_reaches(&L, (vec3){0, 0, 1}, up, up, u, &x) && vzero(x.E), "in its plane");
    check(!area_light_reaches(&L, nan, up, up, u, &x) && vzero(x.E), "a NaN reaches nothing");
    L.colour = (vec3){0, 0, 0};
    check(!area_light_reaches(&L, p, up, up, u, &x), "black");
}

/* ---- lobes ---- */

static surface at_origin(vec3 n) { return (surface){{0, 0, 0}, n, n, 0, 0, no_shape}; }

/* s = 0: the part of a hemisphere that another one, at the angle, has in common with it; s = 1: its
 * projection. Midpoints: 1e-7. */
static void test_above(void)
{
    for (int i = 0; i <= 20; i++) {
        double c = 1 - i / 10.0;
        check_close(glossy_above(c, 0), 1 - acos(c) / (double)pi, 1e-6, "s = 0, c = %g", c);
        check_close(glossy_above(c, 1), (1 + c) / 2, 1e-6, "s = 1, c = %g", c);
        check_close(glossy_above(c, 7) + glossy_above(-c, 7), 1, 1e-6, "the rest is below");
    }
    check_equal(glossy_above(0.01, (double)INFINITY), 1, "a mirror");
    check_close(glossy_above(0, 300), 0.5, 1e-6, "half of it, at the horizon");
}

/* Share above, and the mean of r.w = (s+1)/(s+2) of all, counted where nothing is cut. */
static void test_lobe(void)
{
    static const double shines[4] = {0, 5, 50, 3000}, degrees[3] = {10, 60, 88};
    vec3 up = {0, 0, 1};
    surface s = at_origin(up);
    for (int i = 0; i < 12; i++) {
        double a = degrees[i % 3] * (double)pi / 180, shine = shines[i / 3];
        vec3 d = {(real)sin(a), 0, (real)-cos(a)}, r = {(real)sin(a), 0, (real)cos(a)};
        estimate above = {0}, z = {0};
        double below = 0, length = 0;
        for (uint32_t j = 0; j < check_count(20000); j++) {
            sampler q = sampler_start(SEQUENCE_RANDOM, 41, (uint64_t)i, j, 1);
            point2 u = sampler_pair(&q);
            ray w = {{0, 0, 0}, 0, {0, 0, 0}, 0};
            bool sent = glossy_ray(s, vscale(d, 3), (real)shine, u, &w);
            above = estimate_add(above, sent);
            if (sent) below = check_worse(below, -(double)w.d.z);
            glossy_ray_naive(s, d, (real)shine, u, &w);
            z = estimate_add(z, (double)vdot(w.d, r));
            length = check_worse(length, fabs((double)vlength(w.d) - 1));
        }
        /* something as rare as 14/n happens to none of n with a chance of e^-14 = 1e-6 */
        double rare = 1e-6 + 14 / (double)above.n;
        check_at_least(t_test(above, glossy_above(cos(a), shine), rare), alarm_rate,
                       "share above, %g degrees, s = %g", degrees[i % 3], shine);
        check_at_least(t_test(z, (shine + 1) / (shine + 2), 16 * (double)real_epsilon), alarm_rate,
                       "mean cosine, s = %g", shine);
        check(below <= 0, "nothing is sent below");
        check_at_most(length, 8 * (double)real_epsilon, "unit length: the sample's and the basis'");
    }
}

/* s = infinity: r itself, u unread. Large s tend to it. */
static void test_mirror(void)
{
    random_stream q = random_start(42, 0, 0);
    double off = 0, lobe = 0;
    bool sent = true;
    for (size_t i = 0; i < check_count(5000); i++) {
        vec3 n = random_unit(&q), d = random_unit(&q);
        surface s = surface_facing(at_origin(n), d);
        ray w = {{0, 0, 0}, 0, {0, 0, 0}, 0}, v = w;
        vec3 r = vmadd(d, n, -2 * vdot(n, d));
        sent = glossy_ray(s, d, real_infinity, (point2){(real)NAN, 0}, &w) && sent;
        off = check_worse(off, (double)vlength(vsub(w.d, r)));
        glossy_ray_naive(s, d, 1e12, (point2){0.5, random_next(&q)}, &v);
        lobe = check_worse(lobe, (double)vlength(vsub(v.d, r)));
    }
    check(sent, "always");
    check_at_most(off, 8 * (double)real_epsilon, "the mirror direction");
    /* sin = sqrt(2 log 2 / 1e12) */
    check_at_most(lobe, 1.2e-6 + 8 * (double)real_epsilon, "s = 1e12");
}

/* The naive ray leads into the body: a thin floor it passes, to what is below. */
static void test_leak(void)
{
    vec3 corner[4] = {{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0}};
    shape floor = shape_of_polygon(polygon_of(corner, 4));
    surface s = surface_on_polygon(floor.polygon, 0, (vec3){0, 0, 0});
    size_t n = check_count(4000), leaks[2] = {0, 0};
    for (uint32_t i = 0; i < n; i++)
        for (int k = 0; k < 2; k++) {
            sampler q = sampler_start(SEQUENCE_RANDOM, 43, 0, i, 1);
            hit h;
            ray r;
            if ((k ? glossy_ray : glossy_ray_naive)(s, vec(0.8, 0, -0.6), 1, sampler_pair(&q), &r))
                leaks[k] += r.d.z < 0 && !shape_hit(floor, r, &h);
        }
    check(leaks[0] > n / 10, "a fifth of a cosine lobe at 53 degrees, into the floor");
    check_equal(leaks[1], 0, "no ray into the floor");
}

/* Two normals: the lobe's axis is never below the geometric one. */
static void test_silhouette(void)
{
    random_stream q = random_start(44, 0, 0);
    size_t below = 0, lifted = 0, into = 0;
    for (size_t i = 0; i < check_count(50000); i++) {
        vec3 n = random_unit(&q), d = random_unit(&q);
        surface s = {{0, 0, 0}, n, vunit(vmadd(n, random_unit(&q), 0.7)), 0, 0, no_shape};
        s = surface_facing(s, d);
        vec3 r = vmadd(d, s.ns, -2 * vdot(d, s.ns));
        lifted += vdot(r, s.n) < 0;
        below += !(vdot(glossy_direction(s, d, real_infinity, (point2){0, 0}), s.n) > 0);
        ray w;
        real u0 = random_next(&q);
        point2 u = {u0, random_next(&q)};
        if (glossy_ray(s, d, 3, u, &w)) into += !(vdot(w.d, s.n) > 0 && vdot(w.d, s.ns) > 0);
    }
    check(lifted > 0, "some lead below");
    check_equal(below, 0, "and are lifted");
    check_equal(into, 0, "no ray below either of the normals");
}

/* ---- lens ---- */

static camera some_camera(int kind, random_stream *s)
{
    camera_frame f;
    camera c;
    failure why;
    vec3 e = vscale(random_unit(s), 10), to = vadd(e, random_unit(s));
    camera_window win = {-1, 1.5, -0.7, 0.4};
    bool ok = frame_look_at(e, to, random_unit(s), &f, &why);
    if (kind == 0) ok = ok && camera_perspective(f, 50, 1.5, &c, &why);
    else if (kind == 1) ok = ok && camera_off_axis(f, win, 0.7, &c, &why);
    else if (kind == 2) ok = ok && camera_orthographic(f, win, &c, &why);
    else ok = ok && camera_oblique(f, win, vmadd(vneg(f.w), f.u, 0.4), &c, &why);
    if (!ok) fail(why);
    return c;
}

/* Radius 0: camera_ray, to the last bit, u unread. Else all rays of a point meet in one. */
static void test_focus(void)
{
    random_stream s = random_start(51, 0, 0);
    size_t differ = 0;
    double apart = 0, depth = 0, outside = 0, widest = 0;
    for (size_t i = 0; i < check_count(4000); i++) {
        camera c = some_camera((int)(i % 4), &s);
        thin_lens l = {random_between(&s, 0.01, 1), random_between(&s, 0.5, 50)};
        real x = 64 * random_next(&s), y = 48 * random_next(&s), z = random_between(&s, 0.3, 90);
        real u0 = random_next(&s);
        point2 u = {u0, random_next(&s)};
        ray a = lens_ray(c, (thin_lens){0, l.focus}, x, y, 64, 48, (point2){(real)NAN, 0});
        ray b = camera_ray(c, x, y, 64, 48), r = lens_ray(c, l, x, y, 64, 48, u);
        differ += memcmp(&a, &b, sizeof a) != 0;
        real t = l.focus / -vdot(b.d, c.w), tz = z / -vdot(b.d, c.w);
        vec3 P = ray_at(b, t), off = vsub(ray_at(r, t), P);
        real size = l.focus + vlength(c.e) + fabs(t) * vlength(b.d);
        apart = check_worse(apart, (double)(vlength(off) / size));
        real F = -vdot(vsub(ray_at(r, t), c.e), c.w);
        depth = check_worse(depth, fabs((double)(F / l.focus - 1)));
        /* at depth z: within the circle; and all of it is used */
        real blur = lens_blur(l, z), at = vlength(vsub(ray_at(r, tz), ray_at(b, tz)));
        outside = check_worse(outside, (double)((at - blur) / (size + z)));
        if (blur > (real)0.01) widest = check_worse(widest, (double)(at / blur));
        ray far = lens_ray(c, (thin_lens){l.radius, real_infinity}, x, y, 64, 48, u);
        differ += memcmp(&far.d, &b.d, sizeof b.d) != 0;
    }
    check_equal(differ, 0, "a pinhole; and parallel beams, for a focus at infinity");
    /* some 10 roundings of numbers up to the size */
    check_at_most(apart, 16 * (double)real_epsilon, "rays of one point in the plane of focus");
    check_at_most(depth, 64 * (double)real_epsilon, "that plane, |e| = 10, F >= 1/2");
    check_at_most(outside, 2 * (double)real_epsilon, "outside of the circle of confusion");
    check_at_least(widest, 0.9, "its rim");
    thin_lens l = {(real)0.0125, 3};
    check_equal((double)lens_blur(l, 3), 0, "no circle in focus");
    check_close((double)lens_blur(l, 6), 0.0125, (double)real_epsilon / 16,
                "as wide as the lens at 2 F");
    check_equal((double)lens_blur((thin_lens){1, real_infinity}, 5), 1, "focus at infinity");
}

/* ---- motion: a ray that is moved back against shapes that
 * are moved; nothing drawn where nothing moves ---- */

static tracer asking(const trace_world *w)
{
    return (tracer){.w = w, .program = distributed_programs};
}

static material plain(const void *context, trace_hit x, const surface *s)
{
    (void)context, (void)x, (void)s;
    return (material){.kd = vec(0.5, 0.4, 0.3), .ks = vec(0.3, 0.3, 0.3), .shine = real_infinity};
}

static const trace_world nothing = {.part = NULL};

typedef struct { shape shapes[1]; scene s; world_part part; moving m; } flying;

static void flying_ball(flying *f, sphere b, vec3 v)
{
    f->shapes[0] = shape_of_sphere(b), f->s = (scene){f->shapes, 1};
    world_part_of_scene(&f->s, MASK_ALL, &f->part);
    f->m = (moving){{&f->part, 1}, v};
}

/* The same hit as of the ball moved: t, point and normal. Near the limb roundings decide. */
static void test_moved(void)
{
    random_stream s = random_start(6, 0, 0);
    double off = 0, eps = (double)real_epsilon;
    size_t other = 0, met = 0, still = 0;
    for (size_t i = 0; i < check_count(20000); i++) {
        sphere b = {vscale(random_unit(&s), 3), random_between(&s, 0.2, 1)}, there = b;
        real fast = random_between(&s, 0, 4);
        vec3 v = vscale(random_unit(&s), fast), by;
        real time = random_next(&s);
        flying f;
        flying_ball(&f, b, v);
        there.c = vmadd(b.c, v, time);
        shape moved = shape_of_sphere(there);
        vec3 o = vscale(random_unit(&s), 9), at = vmadd(there.c, random_unit(&s), b.r);
        vec3 d = vunit(vsub(at, o));
        tracer t = asking(&nothing);
        distributed how = {.material_of = plain};
        t.user = &how;
        distributed_met x = {.met = false};
        hit h = hit_none;
        bool one = motion_closest(&t, &f.m, 1, time, RAY_CAMERA, ray_from(o, d), &x, &x.t, &by);
        bool two = sphere_hit(there, ray_from(o, d), &h);
        real passes = vlength(vcross(vsub(there.c, o), d)) / b.r;
        if (fabs((double)passes - 1) > 1e3 * eps) other += one != two;
        if (one && two && passes < (real)0.9) {
            surface a = motion_surface(x.s, by), c = surface_of_shape(&moved, ray_from(o, d), h);
            off = check_worse(off, fabs((double)(x.t - h.t)) + (double)vlength(vsub(a.n, c.n))
                                   + (double)vlength(vsub(a.p, c.p)));
            still += motion_surface(x.s, vec(0, 0, 0)).error == x.s.error, met++;
        }
        world_part_free(&f.part);
    }
    check_equal(other, 0, "met by one and missed by the other");
    check(met > 100, "many are met");
    check_equal(still, met, "nothing is added, and rounded, where nothing moves");
    /* some 20 roundings of numbers up to 16, a point's error over the cosine at .9 and over r */
    check_at_most(off, 20 * 16 * 2.3 * 5 * eps, "time, point and normal");
}

/* Convex: no ray that leaves it, moved along, meets it again, however far away and however fast.
 * And what nearly touches it does hide. */
static void test_leaves(void)
{
    random_stream s = random_start(7, 0, 0);
    size_t again = 0, leaks = 0, n = check_count(40000);
    for (size_t i = 0; i < n; i++) {
        double far = pow(10, (double)random_between(&s, -2, 6));
        sphere b = {vscale(random_unit(&s), (real)far), pow((real)10, random_between(&s, -2, 2))};
        b.r = real_max(b.r, (real)1e3 * real_epsilon * (real)far);  /* it has points */
        real fast = pow((real)10, random_between(&s, -2, 6));
        vec3 v = vscale(random_unit(&s), fast), by;
        vec3 w = random_unit(&s);
        real time = random_next(&s);
        flying f;
        flying_ball(&f, b, v);
        vec3 n0 = random_unit(&s);
        surface a = surface_on_sphere(b, 0, vmadd(b.c, n0, b.r));
        by = vscale(v, time), a = motion_surface(a, by);
        if (vdot(w, a.n) < 0) w = vneg(w);
        tracer t = asking(&nothing);
        if (vdot(w, a.n) > (real)1e-3)
            again += motion_any(&t, &f.m, 1, time, RAY_SHADOW, leave(a, w));
        /* a small ball above it, a gap of 64 roundings away */
        real gap = 64 * real_epsilon * (surface_reach(a.p) + vlength(b.c) + b.r);
        shape near[1] = {shape_of_sphere((sphere){vmadd(a.p, a.n, 33 * gap), 32 * gap})};
        scene others = {near, 1};
        world_part part;
        world_part_of_scene(&others, MASK_ALL, &part);
        trace_world world = {&part, 1};
        tracer over = asking(&world);
        leaks += !motion_any(&over, &f.m, 1, time, RAY_SHADOW, leave(a, a.n));
        world_part_free(&part), world_part_free(&f.part);
    }
    check_equal(again, 0, "a ball that goes by hides itself");
    check_equal(leaks, 0, "rays that miss what nearly touches the ball");
}

enum { columns = 32, rows = 18 };

/* Balls that could move and do not: the same as in the world that rests, to the last bit; and a
 * world where nothing moves asks for no time. */
static void test_at_rest(void)
{
    pool *still = pool_new(0);
    image a = image_new(columns, rows), b = image_new(columns, rows);
    distributed_view v = pool_view(still, (real)columns / rows);
    v.samples = 4;
    distributed_draw(&v, &a, 2);
    check_equal(v.spent.drawn[DRAWN_TIME], 4 * columns * rows, "a time a sample, not a ray");
    size_t shadow = v.spent.rays.rays[RAY_SHADOW];
    scene all = {still->shapes, 1 + pool_balls};
    world_part_free(&still->part[0]), world_part_of_scene(&all, MASK_ALL, &still->part[0]);
    still->how.movers = 0;
    distributed_draw(&v, &b, 1);
    check_equal(v.spent.drawn[DRAWN_TIME], 0, "nothing moves, no number");
    check_equal(v.spent.rays.rays[RAY_SHADOW], shadow, "and no ray more or less");
    check_equal(memcmp(a.rgb, b.rgb, 3 * sizeof *a.rgb * columns * rows), 0, "the same picture");
    image_free(&a), image_free(&b), pool_free(still);
}

/* Each sample sees what it would see of a world that stands still where everything is at its time:
 * eye, shadow and reflected rays alike. Rays at the very edge of something may differ. */
static void test_one_time(void)
{
    size_t other = 0, n = check_count(800), moved = 0;
    pool *g = pool_new(1);
    g->how.material_of = plain;
    distributed_view v = pool_view(g, (real)columns / rows);
    distributor d = distributor_of(&g->w, &g->how);
    for (size_t i = 0; i < n; i++) {
        distributed_sample q = {SEQUENCE_RANDOM, 9, i, 0, 1};
        real time = distributed_pair(&d, q, DRAWN_TIME, PAIR_TIME).u;
        pool *still = pool_new(0);
        for (int k = 0; k < pool_moving; k++) {
            sphere *b = &still->ball[pool_rest + k].sphere;
            b->c = vadd(b->c, vscale(g->moving[k].v, time));
            world_part_free(&still->fast_part[k]);
            world_part_of_scene(&still->fast[k], MASK_ALL, &still->fast_part[k]);
        }
        still->how.material_of = plain;
        distributor e = distributor_of(&still->w, &still->how);
        size_t before = d.t.counts.rays[RAY_REFLECTION];
        ray r = camera_ray(v.c, (real)(i * 7 % columns) + (real)0.3,
                           (real)(i * 5 % rows) + (real)0.3, columns, rows);
        vec3 x = distributed_ray(&d, r, q), y = distributed_ray(&e, r, q);
        other += !((double)vlength(vsub(x, y)) <= 1e3 * (double)real_epsilon * (1 + (double)x.x));
        moved += d.t.counts.rays[RAY_REFLECTION] > before;
        pool_free(still);
    }
    check_at_most(other, n / 50, "samples that see something else than at rest");
    check(moved > n / 2, "most of them have reflections");
    pool_free(g);
}

int main(void)
{
    return check_all("21_known", test_answers, test_slopes, test_segment, test_point,
                     test_ball, test_sunk_ball, test_centre, test_no_light, test_above, test_lobe,
                     test_mirror, test_leak, test_silhouette, test_focus, test_moved,
                     test_leaves, test_at_rest, test_one_time);
}
