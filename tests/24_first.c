/* 24's first.h: both ways against the full version's on the same walls, and against closed forms;
 * the noise of each where the other is better; the box. Fixed seeds; a t-test alarms falsely once
 * in 1e8 seeds. */
#include "../common/lab/t_test.h"
#include "../chapters/22_radiometry/lab/oracle.h"
#include "../chapters/24_direct_light/direct.h"
#include "../chapters/24_direct_light/lab/survey.h"
#include "../chapters/24_direct_light/scenes/lit_cornell.h"
#include "../chapters/24_direct_light/scenes/lit_first.h"
#include "check.h"

static const double false_alarm = 1e-8;
static const vec3 up = {0, 0, 1};

static double green(vec3 c) { return (double)c.y; }

/* ---- closed forms: a lamp and a white point that faces up, at the origin ---- */

typedef struct { first_scene s; first_point x; double truth; } setting;

static setting setting_of(rectangle r)
{
    static const first_material white = {.kd = {1, 1, 1}};
    first_material lamp = {.ke = {1, 1, 1}};
    setting t = {.s = {.eps = (real)1e-5}};
    first_add_flat(&t.s, r.o, r.s, r.t, lamp);
    t.x = (first_point){.n = up, .v = up, .m = &white, .kd = {1, 1, 1}};
    t.truth = rectangle_irradiance_exact(r, t.x.p, up) / (double)pi;
    return t;
}

static estimate sampled(const setting *t, bool by_lamp, size_t n, uint64_t seed)
{
    estimate e = {0, 0, 0};
    for (size_t i = 0; i < n; i++) {
        random_stream random = random_start(seed, i, by_lamp);
        vec3 L = by_lamp ? first_direct_by_lamp(&t->s, 0, t->x, &random)
                         : first_direct_by_direction(&t->s, t->x, &random);
        e = estimate_add(e, green(L));
    }
    return e;
}

/* Lamps of all sizes and slants, at 1 to 4 from the point, some partly below its horizon; as many
 * turn their dark side to it. A direction meets the lamp or not: one in 100 must, for a mean that
 * is nearly normal after so many samples. */
static void test_closed_forms(void)
{
    size_t lamps = check_count(400), n = 4000, tests = 0;
    double least[2] = {1, 1}, dark = 0;
    for (size_t i = 0; i < lamps; i++) {
        random_stream q = random_start(2, i, 0);
        real x[9];
        for (int k = 0; k < 9; k++) x[k] = 2 * random_next(&q) - 1;
        vec3 at = vscale((vec3){x[0], x[1], fabs(x[2])}, 2), a = {x[3], x[4], x[5]};
        at.z += 1;
        vec3 b = vcross(a, (vec3){x[6], x[7], x[8]});
        setting t = setting_of((rectangle){at, a, b});
        if (t.truth == 0)
            for (int k = 0; k < 2; k++) dark = check_worse(dark, sampled(&t, k, 100, i).mean);
        if (t.truth < 0.01) continue;
        tests++;
        for (int k = 0; k < 2; k++) {
            double p = t_test(sampled(&t, k, n, i), t.truth, 64 * (double)real_epsilon);
            least[k] = p < least[k] ? p : least[k];
        }
    }
    check_at_least((double)tests, (double)lamps / 8, "lamps to be seen, of %zu", lamps);
    check_at_least(least[0], false_alarm, "by directions: the least p of %zu lamps", tests);
    check_at_least(least[1], false_alarm, "by the lamp: the least p of %zu lamps", tests);
    check_equal(dark, 0, "lamps that show their backs, or are below the horizon");
}

/* ---- noise: "the first is noisy for a small lamp, the second close to a lamp" ---- */

static estimate by_both(const setting *t, size_t n)
{
    lit_scene s;
    lit_lights l;
    lit_first(&t->s, &s);
    lit_lights_of(&s, NULL, LIGHTS_ALL, &l);
    direct_work work = {0, 0, 0};
    direct d = {&s, DIRECT_POWER, &l, &work, false};
    brdf white = brdf_lambert((vec3){1, 1, 1});
    lit_hit h = {{{0, 0, 0}, up, up, 0, 0, no_shape}, NULL, &white, lit_dark, 1, true, false};
    estimate e = {0, 0, 0};
    for (size_t i = 0; i < n; i++) {
        sampler q = sampler_start(SEQUENCE_RANDOM, 3, 0, (uint32_t)i, (uint32_t)n);
        e = estimate_add(e, green(direct_light(&d, &h, up, &q)));
    }
    lit_lights_free(&l), lit_free(&s);
    return e;
}

/* A square lamp of side a at 2 above: a direction meets it with the probability q = E / pi, so that
 * its variance is q (1 - q), and its error over the mean sqrt((1 - q) / q) = 2 sqrt pi / a. */
static void test_small_lamp(void)
{
    size_t n = check_count(1600000);
    for (int k = 0; k < 3; k++) {
        real a = k == 0 ? 1 : k == 1 ? (real)0.25 : (real)0.125;
        setting t = setting_of((rectangle){{-a / 2, -a / 2, 2}, {0, a, 0}, {a, 0, 0}});
        double q = t.truth, expected = sqrt((1 - q) / q);
        estimate d = sampled(&t, false, n, 4), l = sampled(&t, true, n, 4);
        estimate both = by_both(&t, n / 40);
        check_close(expected * (double)a, 2 * sqrt((double)pi), 0.2 * (double)a + 1e-3, "a = %g",
                    (double)a);
        check_close(sqrt(estimate_variance(d)) / q, expected, expected * 6 / sqrt(q * (double)n),
                    "by directions: error of one over the mean, lamp of side %g", (double)a);
        check_at_most(sqrt(estimate_variance(l)) / q, 0.15, "by the lamp, of side %g", (double)a);
        check_at_most(estimate_variance(both), 1.5 * estimate_variance(l), "mis.h, side %g",
                      (double)a);
    }
}

/* A wall that shines stands at the distance h on the floor. By the lamp the mean square is, over
 * the half plane, 1 / (6 pi h^2); q is nearly 1/2, and by directions the variance is q (1 - q),
 * below 1/4; mis.h keeps to the better of the two. At 0.05 some 100 points of 50000 lie as near
 * as h, so few that half of it is missing once in 1e7 seeds (at 0.01 they would be 4). */
static void test_close_to_a_lamp(void)
{
    size_t n = check_count(400000);
    for (int k = 0; k < 3; k++) {
        real h = k == 0 ? 1 : k == 1 ? (real)0.1 : (real)0.05;
        setting t = setting_of((rectangle){{h, -1, 0}, {0, 0, 2}, {0, 2, 0}});
        double both = estimate_variance(by_both(&t, n / 10));
        double d = estimate_variance(sampled(&t, false, n, 5));
        double l = estimate_variance(sampled(&t, true, n, 5));
        check_at_most(d, 0.26, "by directions, at %g", (double)h);
        check_at_most(both, 1.5 * (d < l ? d : l), "mis.h, at %g", (double)h);
        if (k) check_at_least(l, 1 / (double)(12 * pi * h * h), "by the lamp, at %g", (double)h);
    }
}

/* ---- the box ---- */

/* Mean over the picture of what the lamp brings, and of what is seen of it: the measured box of 21
 * leans here and there by some millimetres of 5 m. */
static double cornell_mean(bool full, size_t n)
{
    first_scene s = first_cornell();
    lit_scene g;
    lit_lights l;
    direct_work work = {0, 0, 0};
    double sum = 0;
    lit_cornell(&g), lit_lights_of(&g, NULL, LIGHTS_ALL, &l);
    direct d = {&g, DIRECT_AREA, &l, &work, false};
    for (size_t i = 0; i < n; i++) {
        sampler q = sampler_start(SEQUENCE_SOBOL, 6, 0, (uint32_t)i, (uint32_t)n);
        point2 u = sampler_pair(&q);
        if (full) {
            lit_hit x;
            ray r = camera_ray(cornell_camera(1), u.u, u.v, 1, 1);
            if (!lit_trace(&g, r, &x)) continue;
            vec3 L = direct_light(&d, &x, vneg(vunit(r.d)), &q);
            sum += green(vadd(lit_emitted(&x), L));
        } else {
            hit h;
            ray r = first_camera_ray(first_cornell_camera(1, 1), u.u, u.v);
            random_stream random = random_start(6, i, 0);
            if (!first_scene_hit(&s, r, &h)) continue;
            first_point x = first_point_at(&s, r, h);
            sum += green(vadd(first_emitted(x), first_direct_by_lamp(&s, 0, x, &random)));
        }
    }
    lit_lights_free(&l), lit_free(&g);
    return sum / (double)n;
}

static void test_measured_box(void)
{
    size_t n = check_count(1u << 17);
    double full = cornell_mean(true, n), first = cornell_mean(false, n);
    check_close(first / full, 1, 2 / sqrt((double)n),
                "mean of the picture, %g, over that of the measured box, %g",
                first, full);
}

static void test_camera(void)
{
    for (size_t i = 0; i < check_count(4000); i++) {
        random_stream random = random_start(8, i, 0);
        real u = random_next(&random), v = random_next(&random);
        ray r = first_camera_ray(first_cornell_camera(1, 1), u, v);
        ray q = camera_ray(lit_first_camera(), u, v, 1, 1);
        check_at_most((double)vlength(vsub(vunit(r.d), vunit(q.d))), 8 * (double)real_epsilon,
                      "a ray of the two cameras");
    }
}

/* Its rays, as the page's table counts them, are those of light by area, which has its points. */
static void test_rays_counted(void)
{
    direct_survey s;
    const options o = {.quick = true, .seed = 1, .threads = 1};
    survey_open(&s, &o, STAGE_FIRST, 6, 64);
    survey_measure(&s, &o);
    const direct_work *first = &s.work[survey_first][survey_brief];
    const direct_work *area = &s.work[DIRECT_AREA][survey_brief];
    check_equal(first->samples, area->samples, "samples");
    check_equal(first->shadow, area->shadow, "shadow rays");
    check_at_most(first->shadow, first->samples - first->samples / 10, "some need none");
    survey_close(&s);
}

/* ---- no hang, no crash ---- */

static void test_odd_input(void)
{
    first_scene empty = {.eps = (real)1e-5}, s = first_cornell();
    random_stream random = random_start(7, 0, 0);
    first_material m = {.kd = {1, 1, 1}};
    first_point x = {.n = up, .v = up, .m = &m, .kd = {1, 1, 1}};
    check(vzero(first_direct_by_direction(&empty, x, &random)), "an empty scene is black");
    first_add_flat(&empty, (vec3){0, 0, 1}, (vec3){1, 0, 0}, (vec3){1, 0, 0}, m);
    check(vzero(first_direct_by_lamp(&empty, 0, x, &random)), "a lamp without an area is dark");
    x.p = s.thing[0].corner;
    s.thing[0].a = s.thing[0].b = (vec3){0, 0, 0};
    check(vzero(first_direct_by_lamp(&s, 0, x, &random)), "a point of the lamp itself");
    x.n = (vec3){(real)NAN, 0, 0};
    (void)first_direct_by_direction(&s, x, &random);
    for (int i = 0; i < 2000; i++) first_add_block(&s, x.p, up, up, m);
    check_equal(s.things, first_most_things, "what does not fit is left out");
}

int main(void)
{
    return check_all("24_first", test_closed_forms, test_small_lamp, test_close_to_a_lamp,
                     test_measured_box, test_camera, test_rays_counted, test_odd_input);
}
