/* 21's first.h: the answers of area_light.h, glossy.h, of closed forms and of 19's first.h; what
 * its lobes lose, and what it makes of a near lamp. Fixed seeds; each random test alarms falsely
 * once in 1e8 seeds. */
#include "../chapters/21_distributed/first.h"
#include "21_known.h"
#include "../common/lab/t_test.h"
#include "../chapters/22_radiometry/spherical_sampling.h"
#include "check.h"

#define alarm 1e-8
static const double ulp = (double)real_epsilon;
static const vec3 up = {0, 0, 1}, zero = {0, 0, 0};

/* ---- three questions of 21_known.h, asked of first.h ---- */

typedef struct { known_kind kind; first_scene s; first_lamp lamp; first_point at; } known_first;

/* A rectangle of 21_known.h, centre and sides, from above: it shines where b x a points. */
static first_lamp known_first_lamp(const area_light *L)
{
    vec3 corner = vsub(L->at, vscale(vadd(L->a, L->b), (real)0.5));
    return (first_lamp){corner, L->b, L->a, area_light_radiance(L)};
}

static known_first known_first_of(known_kind kind)
{
    known_first k = {.kind = kind, .s.eps = (real)1e-4, .at.n = {0, 0, 1}};
    known full;
    known_make(kind, &full);
    k.lamp = known_first_lamp(&full.light);
    if (full.s.n > 0) {  /* the sheet: three of its corners */
        const vec3 *v = full.corner;
        first_add_flat(&k.s, v[0], vsub(v[1], v[0]), vsub(v[3], v[0]), (first_material){.ior = 0});
    }
    known_free(&full);
    return k;
}

static double known_first_sample(const known_first *k, random_stream *random)
{
    vec3 r = {sqrt((real)0.75), 0, (real)0.5};
    if (k->kind == KNOWN_HORIZON) return first_lobe(r, 1, random).z > 0;
    vec3 E = first_lamp_sample(&k->s, &k->lamp, k->at, random);
    return k->kind == KNOWN_PENUMBRA ? E.x > 0 : (double)E.x;
}

/* ---- the lamp ---- */

/* The same point of the same lamp, with nothing in between: random parallelograms from 2 to 9 away,
 * as large as 1, some of them behind, some turned away. */
static void test_lamp(void)
{
    static const first_scene empty = {.eps = (real)1e-4};
    size_t n = check_count(100000), lit = 0, differ = 0;
    double worst = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(1, i, 0), copy;
        real far = random_between(&s, 2, 9);
        area_light full = {AREA_RECTANGLE, vscale(random_unit(&s), far),
                           random_unit(&s), random_unit(&s), {0, 0, 0}, 0, {1, 2, 3}};
        full.n = vunit(vcross(full.b, full.a));
        first_lamp lamp = known_first_lamp(&full);
        far = random_next(&s);
        first_point x = {.p = vscale(random_unit(&s), far), .n = random_unit(&s)};
        copy = s;
        real u = random_next(&copy), v = random_next(&copy);
        area_sample due;
        /* first.h's u goes along its a, which is b of the other */
        bool reached = area_light_reaches(&full, x.p, x.n, x.n, (point2){v, u}, &due);
        vec3 E = first_lamp_sample(&empty, &lamp, x, &s);
        real cosine = vdot(x.n, due.l), there = vdot(full.n, due.l);
        if (fabs(cosine) < 100 * real_epsilon || fabs(there) < 100 * real_epsilon) continue;
        /* an epsilon of the way turns l by as much; and |a x b| is known to an epsilon or two */
        double off = (double)vlength(vsub(E, due.E)) / (double)vlength(due.E);
        double near = 1 + 1 / fabs((double)cosine) + 1 / fabs((double)there);
        double flat = 1 / (double)area_light_area(&full);
        lit += reached, differ += reached != !vzero(E);
        if (reached) worst = check_worse(worst, off / (near * flat * flat));
    }
    check_at_least((double)lit, 0.2 * (double)n, "lamps that shine on the point");
    check_equal(differ, 0, "lit or not, against area_light_reaches, of %zu", n);
    check_at_most(worst, 32 * ulp, "E against area_light_reaches");
}

static void test_known(void)
{
    static const known_kind kinds[3] = {KNOWN_SQUARE, KNOWN_PENUMBRA, KNOWN_HORIZON};
    for (int i = 0; i < 3; i++) {
        known full;
        known_make(kinds[i], &full);
        known_first first = known_first_of(kinds[i]);
        estimate e = {0};
        random_stream random = random_start(2, 0, 0);
        for (size_t j = 0; j < check_count(200000); j++)
            e = estimate_add(e, known_first_sample(&first, &random));
        double p = t_test(e, full.truth, 2.0 / known_far + 16 * ulp);
        check_at_least(p, alarm, "%s", full.name);
        known_free(&full);
    }
}

/* ---- the lobe ---- */

/* Sample by sample what glossy.h draws, and 20 has tested; at r itself 1 - z^2 has no digit left:
 * the error goes with epsilon / sine. */
static void test_lobe(void)
{
    static const double shines[4] = {0, 1, 12, 90};
    double worst = 0, length = 0;
    for (int i = 0; i < 4; i++)
        for (size_t k = 0; k < check_count(100000); k++) {
            random_stream random = random_start(3, k, (uint64_t)i), copy = random;
            real u = random_next(&copy), v = random_next(&copy), s = (real)shines[i];
            vec3 r = vunit(vec(0.2 * i, -0.5, i - 1.5));
            vec3 w = first_lobe(r, s, &random), due = directed(r, sample_lobe(s, u, v));
            double sine = (double)vlength(vcross(r, due));
            worst = check_worse(worst, (double)vlength(vsub(w, due)) * (sine < 1 ? sine : 1));
            length = check_worse(length, fabs((double)vlength(w) - 1));
        }
    check_at_most(worst, 64 * ulp, "against glossy.h's directions, times the sine");
    check_at_most(length, 8 * ulp, "unit length");
}

/* ---- the path ---- */

/* The two balls under a lamp so small and so far that it is a point; a lobe so sharp that it is a
 * mirror: Whitted's tree, on average over the coins of the glass. Highlights it has none. */
static first_scene sharp_balls(first_lamp *lamp)
{
    first_scene s = first_two_balls();
    vec3 down = vunit(vneg(s.light[0].p)), a, b;
    for (int i = 0; i < s.things; i++)
        s.thing[i].m.ks = zero, s.thing[i].m.shine = real_is_float ? (real)1e13 : (real)1e25;
    s.light[0].p = vscale(s.light[0].p, 100);
    s.light[0].intensity = vscale(s.light[0].intensity, 10000);
    vbasis(down, &a, &b);
    *lamp = (first_lamp){s.light[0].p, vscale(a, (real)0.1), vscale(b, (real)0.1),
                         vscale(s.light[0].intensity, 100)};
    return s;
}

/* cos' is 1 within (20/950)^2 / 2, and the way to one corner that to another within 0.1 / 950. */
static void test_path(void)
{
    enum { width = 24, height = 15, deepest = 6 };
    first_lamp lamp;
    first_scene s = sharp_balls(&lamp);
    first_camera c = first_two_balls_camera(width, height);
    size_t n = check_count(2000), lit = 0;
    double least = 1;
    for (int i = 0; i < width * height; i++) {
        int depth = 1 + i % deepest;
        ray r = first_ray_unit(first_camera_ray(c, (real)(i % width) + (real)0.5,
                                                  (real)(i / width) + (real)0.5));
        double due = (double)first_whitted(&s, r, depth).y;
        estimate e = {0};
        for (size_t k = 0; k < n; k++) {
            random_stream random = random_start(4, (uint64_t)i, k);
            e = estimate_add(e, (double)first_distributed(&s, &lamp, r, depth, &random).y);
        }
        double p = t_test(e, due, 1e-3 * due);
        least = p < least || isnan(p) ? p : least, lit += due > 0.3;
    }
    check_at_least(least, alarm / (width * height), "pixels of Whitted's picture, least p");
    check_at_least((double)lit, width * height / 3.0, "of which many are bright");
}

/* A white floor that mirrors a white sky: what the lobe keeps is the share above (21.6). */
static void test_lost(void)
{
    static const double shines[3] = {2, 30, 400}, cosine[4] = {1, 0.5, 0.1, 0.01};
    first_scene s = {.above = {1, 1, 1}, .below = {1, 1, 1}, .eps = (real)1e-4};
    first_lamp dark = {{0, 0, 50}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
    surface floor = {zero, up, up, 0, 0, no_shape};
    first_add_flat(&s, vec(-9, -9, 0), vec(18, 0, 0), vec(0, 18, 0),
                   (first_material){.mirror = {1, 1, 1}});
    size_t n = check_count(100000);
    for (int i = 0; i < 12; i++) {
        double c = cosine[i % 4], sine = sqrt((1 - c) * (1 + c)), shine = shines[i / 4];
        s.thing[0].m.shine = (real)shine;
        ray r = ray_from(vec(-3 * sine, 0, 3 * c), vec(sine, 0, -c)), sent;
        estimate e = {0}, full = {0};
        for (size_t k = 0; k < n; k++) {
            random_stream random = random_start(5, (uint64_t)i, k), copy = random;
            e = estimate_add(e, (double)first_distributed(&s, &dark, r, 3, &random).x);
            copy.dimension = 2;  /* behind the two of the lamp */
            real u = random_next(&copy), v = random_next(&copy);
            full = estimate_add(full, glossy_ray(floor, r.d, (real)shine, (point2){u, v}, &sent));
        }
        double due = glossy_above(c, shine), rare = 1e-6 + 20 / (double)n + 64 * ulp;
        check_at_least(t_test(e, due, rare), alarm, "share above, cos %g, s = %g", c, shine);
        check_close(e.mean, full.mean, rare, "as glossy.h has it");
        if (c < 0.05) check_at_most(e.mean, 0.6, "half of it is lost");
        if (c == 1) check_at_least(e.mean, 1 - rare, "nothing head-on");
    }
}

/* A square lamp of side 2 at the height h over the point: a sample (21.2) is up to L A / h^2, that
 * is 4 L / h^2, and by solid angle no more than 2 pi L. */
static void test_near(void)
{
    static const first_scene empty = {.eps = (real)1e-4};
    static const double height[3] = {0.3, 0.1, 0.03};
    size_t n = check_count(200000);
    for (int i = 0; i < 3; i++) {
        double h = height[i], most = 0, best = 0;
        first_lamp lamp = {vec(-1, -1, h), {0, 2, 0}, {2, 0, 0}, {1, 1, 1}};
        rectangle pane = {vec(-1, -1, h), {0, 2, 0}, {2, 0, 0}};
        spherical_rectangle k = spherical_rectangle_of(pane, zero);
        for (size_t j = 0; j < n; j++) {
            random_stream random = random_start(6, (uint64_t)i, j);
            first_point x = {.p = zero, .n = up};
            most = fmax(most, (double)first_lamp_sample(&empty, &lamp, x, &random).x);
            real u = random_next(&random), v = random_next(&random);
            vec3 y = rectangle_at(pane, spherical_rectangle_sample(&k, u, v));
            best = fmax(best, (double)(vunit(y).z * k.omega));
        }
        check_at_least(most, 2 / (h * h), "the largest sample, h = %g", h);
        check_at_most(most, 4 / (h * h) * (1 + 16 * ulp), "and its bound");
        check_at_most(best, 2 * (double)pi, "by solid angle");
    }
}

/* Lamps and rays of nothing. */
static void test_nonsense(void)
{
    first_scene s = first_two_balls(), empty = {.above = {1, 2, 3}, .below = {1, 2, 3}};
    first_lamp lamp = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}}, line = lamp;
    first_point x = {.p = zero, .n = up}, on = {.p = {0, 0, 1}, .n = up};
    random_stream random = random_start(7, 0, 0);
    vec3 nan = {(real)NAN, 0, 0}, ahead = {0, 0, -1}, here = {0, 1, 8};
    line.b = line.a;
    check(vzero(first_lamp_sample(&empty, &line, x, &random)), "a lamp without area");
    check(vzero(first_lamp_sample(&empty, &lamp, on, &random)), "a point in its plane");
    check_equal(first_distributed(&empty, &lamp, ray_from(zero, up), 5, &random).y, 2, "sky alone");
    check(vzero(first_distributed(&s, &lamp, ray_from(here, ahead), 0, &random)), "no depth");
    check(vzero(first_distributed(&s, &lamp, ray_from(here, ahead), -1, &random)), "nor less");
    (void)first_distributed(&s, &lamp, ray_from(here, nan), 9, &random);
    (void)first_distributed(&s, &lamp, ray_from(nan, ahead), 9, &random);
    (void)first_distributed(&s, &lamp, ray_from(here, zero), 9, &random);
    for (int i = s.things; i < first_most_things; i++) first_add_ball(&s, here, 1, s.thing[1].m);
    uint64_t asked = random.dimension;
    (void)first_distributed(&s, &lamp, ray_from(here, ahead), 50, &random);
    check_at_most(random.dimension - asked, 50 * 4, "a full scene: 50 hits, 4 numbers each");
}

int main(void)
{
    return check_all("21_first", test_lamp, test_known, test_lobe, test_path, test_lost, test_near,
                     test_nonsense);
}
