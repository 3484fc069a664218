/* Tests of 26: the estimator against closed forms and the naive path of 25. (Turned round:
 * 26_light_tracer.) */
#include "check.h"
#include "../common/lab/t_test.h"
#include "../chapters/23_brdf/lab/reference.h"
#include "../chapters/25_bounces/naive_path.h"
#include "../chapters/22_radiometry/lab/oracle.h"
#include "../chapters/26_path_tracer/render.h"
#include "../chapters/26_path_tracer/lab/showcase.h"

static const double false_alarm = 1e-7;  /* of each test of chance; some 300 */

/* Means of n samples each along one ray, by so many independent pixels: what the t-test takes. */
static void along_of(uint64_t seed, const path_tracer *t, ray r, size_t pixels, uint32_t n,
                     estimate e[3], path_counts *c)
{
    for (int k = 0; k < 3; k++) e[k] = (estimate){0};
    for (size_t p = 0; p < pixels; p++) {
        vec3 sum = {0, 0, 0};
        for (uint32_t k = 0; k < n; k++) {
            path_random s = path_start(&t->how, seed, p, k, n);
            (void)path_pair(&s);
            sum = vadd(sum, path_radiance(t, r, &s, c));
        }
        for (int k = 0; k < 3; k++) e[k] = estimate_add(e[k], (double)vaxis(sum, k) / n);
    }
}

static void along(const path_tracer *t, ray r, size_t pixels, uint32_t n, estimate e[3],
                  path_counts *c)
{
    along_of(3, t, r, pixels, n, e, c);
}

/* A ball of that around the origin, in white light from all sides. */
static lit_scene ball_of(material m)
{
    lit_scene s;
    lit_begin(&s);
    lit_add_shape(&s, shape_of_sphere((sphere){{0, 0, 0}, 1}), lit_add_material(&s, m));
    s.background = (vec3){1, 1, 1};
    lit_end(&s);
    return s;
}

/* ---- a closed sphere that shines: L = Le / (1 - albedo), everywhere, in all directions ---- */

static void test_closed_sphere(void)
{
    const sequence_kind kinds[] = {SEQUENCE_RANDOM, SEQUENCE_JITTERED, SEQUENCE_SOBOL};
    lit_scene s;
    lit_begin(&s);
    material m = {.kd = vec(0.5, 0.25, 0), .ke = {1, 2, 3}};
    lit_add_shape(&s, shape_of_sphere((sphere){{1, 2, 3}, -2}), lit_add_material(&s, m));
    lit_end(&s);
    const double exact[3] = {2, 2 / 0.75, 3};
    for (int o = 0; o < 3 * 3 * 3; o++) {
        path_options how = path_defaults;
        how.sequence = kinds[o / 9], how.roulette = (roulette_rule)(o % 3);
        how.light_sampling = o / 3 % 3 > 0, how.mis = o / 3 % 3 > 1;
        if (how.roulette == ROULETTE_NONE) how.bounces = 60;  /* 2^-60 is left out */
        path_tracer t;
        estimate e[3];
        path_counts c = {0};
        path_tracer_of(&s, NULL, how, &t);
        along(&t, ray_from(vec(1, 2, 3.5), (vec3){1, 2, 3}), check_count(200), 16, e, &c);
        for (int k = 0; k < 3; k++)
            check_at_least(t_test(e[k], exact[k], 200 * (double)real_epsilon), false_alarm,
                           "closed sphere, %s, option %d, channel %d: mean %.9g, exactly %.9g",
                           sequence_name[how.sequence], o, k, e[k].mean, exact[k]);
        path_tracer_free(&t);
    }
    lit_free(&s);
}

/* ---- furnace: one ball, white light from all sides, L = albedo(cos) ---- */

typedef enum { FURNACE_DIRECTIONS, FURNACE_LIGHTS, FURNACE_BOTH } furnace_way;

static void furnace_ball(const material *m, const environment *sky, real cosine, furnace_way way)
{
    const brdf b = brdf_of(m);
    lit_scene s = ball_of(*m);
    path_tracer t;
    estimate e[3];
    path_counts c = {0};
    path_options how = path_defaults;
    how.light_sampling = way != FURNACE_DIRECTIONS, how.mis = way == FURNACE_BOTH;
    how.roulette = ROULETTE_NONE, how.bounces = 3;
    path_tracer_of(&s, sky, how, &t);
    real y = sqrt(1 - cosine * cosine);
    along(&t, ray_from((vec3){0, y, 5}, (vec3){0, 0, -1}), check_count(400), 16, e, &c);
    vec3 a = brdf_albedo(&b, cosine);
    for (int k = 0; k < 3; k++)  /* brdf_albedo is right to 3e-3; 2e-6: maps are in float */
        check_at_least(t_test(e[k], (double)vaxis(a, k), 3e-3 + 2e-6), false_alarm,
                       "furnace, kind %d, cos %g, way %d, channel %d: mean %.6g, albedo %.6g",
                       (int)b.kind, (double)cosine, (int)way, k, e[k].mean, (double)vaxis(a, k));
    if (!sky) check_equal(c.light_draws + c.shadow, 0, "no light, no light samples");
    check_equal(c.dice + c.refractions, 0, "no dice without roulette, no glass");
    path_tracer_free(&t), lit_free(&s);
}

static void test_furnace(void)
{
    vec3 c = {0.9, 0.5, 0.1}, d = {0.3, 0.4, 0.5};
    const material m[] = {{.kd = c}, {.kd = d, .ks = d, .shine = 30},
                          {.mirror = c, .alpha = ggx_alpha(0.8)},
                          {.mirror = c, .alpha = ggx_alpha(0.3)}, {.mirror = c}};
    image white = image_new(16, 8);
    environment sky;
    failure f;
    for (size_t i = 0; i < 3 * 16 * 8; i++) white.rgb[i] = 1;
    check(environment_of_image(&white, &sky, &f), "a white map");
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 2; k++) {
            real cosine = k ? (real)0.9 : (real)0.4;
            furnace_ball(&m[i], NULL, cosine, FURNACE_BOTH);
            for (furnace_way way = FURNACE_DIRECTIONS; way <= FURNACE_BOTH; way++)
                furnace_ball(&m[i], &sky, cosine, way);
        }
    image_free(&white), environment_free(&sky);
}

/* A floor whose shading normals lean over, a lamp below it that shines up, an eye above: what a
 * direction on the wrong side of the floor would bring is light from below. Not one sample may. */
static void test_leaning_normals(void)
{
    vec3 corner[] = {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}, leans = vunit(vec(0.9, 0, 0.3));
    vec3 normal[] = {leans, leans, leans};
    uint32_t index[] = {0, 1, 2};
    mesh floor = {.v = corner, .vertices = 3, .n = normal, .normals = 3, .index = index,
                  .triangles = 1};
    const material m[] = {{.kd = vec(0.9, 0.9, 0.9)},
                          {.mirror = vec(0.9, 0.9, 0.9), .alpha = ggx_alpha(0.7)}};
    for (int o = 0; o < 6; o++) {
        lit_scene s;
        path_tracer t;
        estimate e[3];
        path_counts c = {0};
        path_options how = path_defaults;
        how.light_sampling = o / 2 > 0, how.mis = o / 2 > 1;
        lit_begin(&s);
        lit_add_mesh(&s, &floor, lit_add_material(&s, m[o % 2]));
        lit_add_rectangle(&s, (rectangle){{-99, -99, -1}, {198, 0, 0}, {0, 198, 0}},
                          lit_add_material(&s, (material){.ke = {1, 1, 1}}));
        lit_end(&s);
        path_tracer_of(&s, NULL, how, &t);
        along(&t, ray_from((vec3){3, 0, 2}, vunit((vec3){-3, 0, -2})), check_count(400), 4, e, &c);
        check_equal(e[0].mean, 0, "way %d: light through the floor", o);
        check_at_least(c.bounce, c.paths / 4, "way %d: some directions stay above", o);
        check_at_most(c.bounce, c.paths - c.paths / 20, "way %d: others would have gone below", o);
        path_tracer_free(&t), lit_free(&s);
    }
}

/* Glass keeps nothing back: L = 1 behind any ball of it; with absorption less. */
static void test_glass(void)
{
    for (int k = 0; k < 3; k++) {
        path_tracer t;
        estimate e[3];
        path_counts c = {0};
        material m = material_glass((medium){.ior = k == 1 ? (real)0.7 : (real)1.5}, 0);
        if (k == 2) m.inside.absorb = (vec3){1, 2, 0};
        if (k == 2) m.mirror = vec(1, 0.5, 1), m.through = vec(0.9, 1, 1);
        lit_scene s = ball_of(m);
        path_tracer_of(&s, NULL, path_defaults, &t);
        along(&t, ray_from(vec(0, 0.6, 5), (vec3){0, 0, -1}), check_count(500), 16, e, &c);
        check_at_least(t_test(e[2], 1, 1e-6), false_alarm, "a clear ball %d in white light: %.9g",
                       k, e[2].mean);
        check_at_least(c.refractions, c.paths, "each path meets the ball");
        check_equal(c.light_draws, 0, "no light sample on glass");
        if (k < 2) {  /* from its middle no ray is reflected totally: L is squeezed into n^2 */
            along(&t, ray_from((vec3){0, 0, 0}, (vec3){0, 0, 1}), check_count(500), 16, e, &c);
            check_at_least(t_test(e[0], (double)(m.inside.ior * m.inside.ior), 1e-6), false_alarm,
                           "from within, n = %g: %.9g", (double)m.inside.ior, e[0].mean);
        }
        if (k == 2) {  /* head on: 1 - F goes in, 2 long, F inside back ...: a geometric series */
            along(&t, ray_from((vec3){0, 0, 5}, (vec3){0, 0, -1}), check_count(2000), 16, e, &c);
            for (int ch = 0; ch < 3; ch++) {
                double a = exp(-2 * (double)vaxis(m.inside.absorb, ch));
                double R = 0.04 * (double)vaxis(m.mirror, ch);
                double T = 0.96 * (double)vaxis(m.through, ch), exact = R + T * T * a / (1 - R * a);
                check_at_least(t_test(e[ch], exact, 1e-6), false_alarm, "absorbed: %.6g, not %.6g",
                               e[ch].mean, exact);
            }
        }
        path_tracer_free(&t), lit_free(&s);
    }
}

/* Rough glass in white light: nothing is won, and what facets hide is lost, the less the smoother:
 * of each (23.26) at most some alpha. */
static void test_rough_glass(void)
{
    static const double alphas[4] = {0.5, 0.2, 0.05, 1e-3};
    double before = 0;
    for (int k = 0; k < 4; k++) {
        lit_scene s = ball_of(material_glass((medium){.ior = 1.5}, (real)alphas[k]));
        path_tracer t;
        estimate e[3];
        path_counts c = {0};
        path_tracer_of(&s, NULL, path_defaults, &t);
        along(&t, ray_from(vec(0, 0.6, 5), (vec3){0, 0, -1}), check_count(2000), 16, e, &c);
        check_at_most(e[0].mean, 1 + 5 * estimate_error(e[0]), "no light is won, alpha %g",
                      alphas[k]);
        check_at_least(e[0].mean, 1 - alphas[k], "little is lost, alpha %g", alphas[k]);
        check_at_least(e[0].mean, before - 5 * estimate_error(e[0]), "the less the smoother");
        check_equal(c.light_draws, 0, "no light sample on glass");
        before = e[0].mean;
        path_tracer_free(&t), lit_free(&s);
    }
}

/* ---- against the naive path of 25 ---- */

/* All pixels of the box, on average; region by region 26_first has it. */
static void test_naive(void)
{
    enum { side = 6 };
    showcase c;
    path_tracer t;
    failure f;
    estimate all[2] = {{0}, {0}};
    check(showcase_of("cornell", 1, &c, &f), "the box");
    path_tracer_of(&c.s, NULL, path_defaults, &t);
    naive_path p = {&c.s, DIRECTIONS_BRDF, naive_endless, false};
    naive_counts counts = {{0}, 0, 0};
    path_counts mine = {0};
    path_options how = path_defaults;
    how.sequence = SEQUENCE_RANDOM;
    size_t n = check_count(12000);
    for (int i = 0; i < side * side; i++) {
        vec3 mean[2] = {{0, 0, 0}, {0, 0, 0}};
        for (size_t k = 0; k < n + n / 8; k++) {
            bool own = k >= n;
            path_random s = path_start(&how, 5 + own, (uint64_t)i, (uint32_t)k, 1u << 31);
            sampler naive_own = sampler_start(how.sequence, 5, (uint64_t)i, (uint32_t)k, 1u << 31);
            point2 u = path_pair(&s);
            naive_own.pair = 1;
            ray r = camera_ray(c.eye, (real)(i % side) + u.u, (real)(i / side) + u.v, side, side);
            vec3 L = own ? path_radiance(&t, r, &s, &mine)
                         : naive_radiance(&p, r, &naive_own, &counts);
            mean[own] = vmadd(mean[own], L, 1 / (real)(own ? n / 8 : n));
        }
        for (int ch = 0; ch < 2; ch++)
            all[ch] = estimate_add(all[ch], (double)vaxis(vsub(mean[0], mean[1]), ch));
    }
    for (int ch = 0; ch < 2; ch++)
        check_at_least(t_test(all[ch], 0, 1e-9), false_alarm, "all pixels: off by %g on average",
                       all[ch].mean);
    path_tracer_free(&t), showcase_free(&c);
}

/* Paths that go on together bring what each brings alone, bit for bit, by the same numbers and
 * rays: in a room of few triangles, among balls and glass, in a large mesh under a sky. Every
 * length that leaves lanes of a packet, or pixels of a block of random numbers, empty. */
static void test_rows(void)
{
    static const char *const room[] = {"cornell", "spheres", "rough", "teapot"};
    static const int lengths[] = {1, 2, 3, 7, 8, 9, 16, 17, 33, path_row_most};
    enum { side = 64 };
    for (int k = 0; k < 4; k++) {
        showcase c;
        failure f;
        path_tracer t;
        path_counts row = {0}, alone = {0};
        size_t differ = 0, all = 0;
        check(showcase_of(room[k], 1, &c, &f), "%s", room[k]);
        path_options how = path_defaults;
        how.sequence = (sequence_kind)(SEQUENCE_SOBOL - k);
        path_tracer_of(&c.s, showcase_sky(&c), how, &t);
        for (size_t y = 0; y < side; y += check_count(side) < side ? 4 : 1) {
            path_pixel pixel[path_row_most];
            path_random s[path_row_most];
            path_walk walk[path_row_most];
            ray eye[path_row_most];
            int n = lengths[y % (sizeof lengths / sizeof *lengths)];
            for (int x = 0; x < n; x++)
                path_pixel_of(&how, 3, side * y + (size_t)x, &pixel[x]);
            path_samples(pixel, n, 5, 16, s);
            for (int x = 0; x < n; x++) {
                point2 u = path_pair(&s[x]);
                eye[x] = camera_ray(c.eye, (real)x + u.u, (real)y + u.v, side, side);
                path_begin(&walk[x], eye[x]);
            }
            path_row(&t, walk, s, n, &row);
            for (int x = 0; x < n; x++, all++) {
                path_random own = path_start(&how, 3, side * y + (size_t)x, 5, 16);
                path_pair(&own);
                vec3 L = path_radiance(&t, eye[x], &own, &alone), M = walk[x].L;
                differ += L.x != M.x || L.y != M.y || L.z != M.z
                    || random_next_bits(&own.own) != random_next_bits(&s[x].own);
            }
        }
        check_equal(differ, 0, "%s: of %zu paths, other alone than in a row", room[k], all);
        check(memcmp(&row, &alone, sizeof row) == 0, "%s: the same rays, dice, draws", room[k]);
        path_tracer_free(&t), showcase_free(&c);
    }
}

/* ---- roulette: X / q with probability q has the mean of X ---- */

static void test_roulette(void)
{
    check_equal(roulette_survival(vec(0.125, 0.25, 0)), (real)0.5, "q of (26.4)");
    check_equal(roulette_survival((vec3){2, 0, 0}), 1, "never above 1");
    vec3 cut = path_cut((vec3){4, 2, 1}, 2), whole = path_cut((vec3){4, 2, 1}, 0);
    check(cut.x == 2 && cut.y == 1 && cut.z == (real)0.5 && whole.x == 4, "--clamp keeps the hue");
    for (int k = 1; k < 10; k++) {
        path_walk w = {.beta = {1, 1, 1}, .squeezed = 1};
        path_tracer t = {.how = path_defaults};
        path_counts c = {0};
        estimate e = {0};
        real b = (real)k / 20;
        for (uint32_t i = 0; i < check_count(20000); i++) {
            path_random s = path_start(&t.how, 7, i, 0, 1);
            w.beta = (vec3){b, b / 2, 0};
            bool lives = path_dice(&t, &w, &s, &c);
            e = estimate_add(e, lives ? (double)w.beta.y : 0);
        }
        check_at_least(t_test(e, (double)b / 2, 1e-7), false_alarm, "beta %g: mean %g", (double)b,
                       e.mean);
        check_equal(c.dice, check_count(20000), "a die each");
    }
}

/* ---- light through glass that absorbs, and scenes without light ---- */

/* Light samples with MIS, light samples alone, directions alone: the same mean along r, of e. */
static void test_strategies(const lit_scene *s, const environment *sky, ray r, uint64_t seed,
                            const char *where, estimate e[3][3])
{
    path_options how[3] = {path_defaults, path_defaults, path_defaults};
    how[1].mis = false, how[2].light_sampling = how[2].mis = false;
    for (int k = 0; k < 3; k++) {
        path_tracer t;
        path_counts c = {0};
        path_tracer_of(s, sky, how[k], &t);
        along_of(seed + (uint64_t)k, &t, r, check_count(20000), 1, e[k], &c);
        path_tracer_free(&t);
    }
    for (int ch = 0; ch < 3; ch++)
        for (int k = 0; k < 3; k++)
            check_at_least(welch_test(e[k][ch], e[(k + 1) % 3][ch]), false_alarm,
                           "%s, channel %d: strategy %d %.6g, strategy %d %.6g", where, ch, k,
                           e[k][ch].mean, (k + 1) % 3, e[(k + 1) % 3][ch].mean);
    check_at_least(e[2][0].mean, 0.001, "light to compare");
}

/* A floor and a lamp over it in a ball of ior 1 that takes away .2 a unit: each strategy must find
 * the same mean. Without absorption along the shadow ray, lights and MIS find 1.7 times as much. */
static void test_in_glass(void)
{
    lit_scene s;
    estimate e[3][3];
    lit_begin(&s);
    vec3 take = {(real)0.2, (real)0.4, 0}, to = {(real)0.5, -1, (real)(-0.5)};
    uint16_t grey = lit_add_material(&s, (material){.kd = vec(.5, .5, .5)});
    uint16_t lamp = lit_add_material(&s, (material){.ke = vec(1, 1, 1)});
    uint16_t ball = lit_add_material(&s, material_glass((medium){1, take, 0}, 0));
    lit_add_rectangle(&s, (rectangle){vec(-1, -1, 1), vec(2, 0, 0), vec(0, 0, -2)}, grey);
    lit_add_rectangle(&s, (rectangle){vec(-1, 1, -1), vec(2, 0, 0), vec(0, 0, 2)}, lamp);
    lit_add_shape(&s, shape_of_sphere((sphere){{0, 0, 0}, 3}), ball);
    lit_end(&s);
    test_strategies(&s, NULL, ray_between((vec3){0, 0, 5}, to), 12, "in glass", e);
    lit_free(&s);
}

/* A room with glass, gloss, two lights and a sky. */
static void test_crowded(void)
{
    lit_scene s;
    environment sky;
    estimate e[3][3];
    environment_sky(32, 16, vec(0, 0.3, -1), &sky);
    lit_cornell_begin(&s);
    material gloss = {.mirror = vec(0.9, 0.7, 0.4), .alpha = ggx_alpha(0.4)};
    material lamp = {.kd = vec(0.5, 0.5, 0.5), .ke = {3, 4, 5}};
    lit_add_shape(&s, shape_of_sphere((sphere){{420, 80, 150}, 80}), lit_add_material(&s, gloss));
    lit_add_shape(&s, shape_of_sphere((sphere){{100, 400, 300}, 60}), lit_add_material(&s, lamp));
    material ball = material_glass((medium){1.5, vec(0.001, 0, 0.002), 0}, 0);
    lit_add_shape(&s, shape_of_sphere((sphere){{180, 235, 160}, 70}), lit_add_material(&s, ball));
    s.background = vec(0.2, 0.3, 0.4);
    lit_end(&s);
    ray r = ray_between((vec3){278, 273, -800}, (vec3){330, 20, 60});
    test_strategies(&s, &sky, r, 31, "crowded", e);
    lit_free(&s), environment_free(&sky);
}

/* A lamp over a floor to which it has its front, its back, or, shining from both, either of them:
 * dark, or the closed form of 22; and what the eye sees of it itself. */
static void test_sides(void)
{
    for (int k = 0; k < 4; k++) {
        bool front = k & 1, both = k & 2, shines = front || both;
        lit_scene s;
        estimate e[3][3];
        vec3 a = {2, 0, 0}, b = {0, 0, 2}, p = vec(.2, -1, .1);
        rectangle down = {vec(-1, 1, -1), a, b}, up = {down.o, b, a};
        lit_begin(&s);
        uint16_t grey = lit_add_material(&s, (material){.kd = vec(.5, .5, .5)});
        uint16_t lamp = lit_add_material(&s, (material){.ke = vec(1, 2, 3), .both = both});
        lit_add_rectangle(&s, (rectangle){vec(-4, -1, 4), vec(8, 0, 0), vec(0, 0, -8)}, grey);
        lit_add_rectangle(&s, front ? down : up, lamp);
        lit_end(&s);
        double E = rectangle_irradiance_exact(down, p, (vec3){0, 1, 0});
        ray r = ray_from(vec(4, 0, 3), vsub(p, vec(4, 0, 3)));
        if (shines) test_strategies(&s, NULL, r, 52, "one or two sides", e);
        for (int way = 0; shines && way < 3; way++)
            check_at_least(t_test(e[way][1], 2 * 0.5 * E / (double)pi, 1e-5), false_alarm,
                           "case %d, strategy %d: %g", k, way, e[way][1].mean);
        path_tracer t;
        path_counts c = {0};
        path_random q = path_start(&path_defaults, 1, 0, 0, 1);
        path_tracer_of(&s, NULL, path_defaults, &t);
        vec3 below = path_radiance(&t, ray_from(vec(0, -.5, 3), vec(0, 1.5, -3)), &q, &c);
        vec3 above = path_radiance(&t, ray_from(vec(0, 3, 3), vec(0, -2, -3)), &q, &c);
        check_equal((double)below.z, shines ? 3 : 0, "case %d: seen from below", k);
        check_equal((double)above.z, both || !front ? 3 : 0, "case %d: seen from above", k);
        path_tracer_free(&t), lit_free(&s);
    }
}

/* ---- rough glass that is lit ---- */

/* A ball of rough glass that absorbs, in it a small lamp; a lamp above, one beside it, a sky: what
 * each strategy finds of them, off facets, through them, and from within. */
static void test_rough_lit(void)
{
    lit_scene s;
    environment sky;
    estimate e[3][3];
    environment_sky(16, 8, (vec3){0, 1, 0}, &sky);
    lit_begin(&s);
    material rough = material_glass((medium){1.5, vec(0.1, 0.5, 1), 0}, (real)0.3);
    uint16_t glass = lit_add_material(&s, rough);
    uint16_t lamp = lit_add_material(&s, (material){.ke = vec(30, 20, 10)});
    uint16_t bulb = lit_add_material(&s, (material){.ke = vec(9, 9, 9)});
    lit_add_shape(&s, shape_of_sphere((sphere){{0, 0, 0}, 1}), glass);
    lit_add_shape(&s, shape_of_sphere((sphere){{(real)0.4, (real)0.2, 0}, (real)0.1}), bulb);
    lit_add_shape(&s, shape_of_sphere((sphere){{3, 0, 1}, (real)0.5}), lamp);
    lit_add_rectangle(&s, (rectangle){vec(-1, 3, -1), vec(0.5, 0, 0), vec(0, 0, 0.5)}, lamp);
    lit_end(&s);
    test_strategies(&s, &sky, ray_between((vec3){0, 0, 5}, vec(0.2, 0.5, 0)), 20, "facets", e);
    test_strategies(&s, &sky, ray_between((vec3){-5, 0, 1}, vec(-0.3, -0.2, 0)), 23, "through", e);
    lit_free(&s), environment_free(&sky);
}

/* A ball of rough glass under a lamp, 100 rays: light samples leave less than half of the error
 * that directions alone have, root mean square. (It is a fifth.) */
static void test_rough_noise(void)
{
    double square[2] = {0, 0};
    lit_scene s;
    lit_begin(&s);
    uint16_t glass = lit_add_material(&s, material_glass((medium){.ior = 1.5}, (real)0.3));
    uint16_t lamp = lit_add_material(&s, (material){.ke = vec(30, 20, 10)});
    lit_add_shape(&s, shape_of_sphere((sphere){{0, 0, 0}, 1}), glass);
    lit_add_rectangle(&s, (rectangle){vec(-1, 3, -1), vec(0.5, 0, 0), vec(0, 0, 0.5)}, lamp);
    lit_end(&s);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 100; i++) {
            path_options how = path_defaults;
            path_tracer t;
            path_counts c = {0};
            estimate e[3];
            how.light_sampling = how.mis = k == 0;
            path_tracer_of(&s, NULL, how, &t);
            vec3 to = {(real)(0.18 * (i % 10) - 0.9), (real)(0.18 * (i / 10) - 0.9), 0};
            along(&t, ray_between((vec3){0, 0, 5}, to), check_count(100), 16, e, &c);
            square[k] += estimate_error(e[0]) * estimate_error(e[0]);
            path_tracer_free(&t);
        }
    check_at_most(sqrt(square[0] / square[1]), 0.5, "noise with light samples: %g without",
                  sqrt(square[1] / 100));
    lit_free(&s);
}

/* One rough face under a lamp of side d, as good as a point of 10 W/sr: what is d / 2 aside is off
 * by some d. From above and from below: f cos I / r^2, (23.24). */
static void test_rough_point(void)
{
    lit_scene s;
    path_tracer t;
    path_counts c = {0};
    rough_glass g = {(real)0.4, 1, (real)1.5};
    real d = real_is_float ? 0x1p-12 : 0x1p-26, Le = 10 / (d * d * 2 / sqrt((real)5));
    lit_begin(&s);
    lit_add_rectangle(&s, (rectangle){{-9, -9, 0}, {18, 0, 0}, {0, 18, 0}},
                      lit_add_material(&s, material_glass((medium){.ior = g.n2}, g.alpha)));
    lit_add_rectangle(&s, (rectangle){{1 - d / 2, -d / 2, 2}, {0, d, 0}, {d, 0, 0}},
                      lit_add_material(&s, (material){.ke = vec(Le, Le, Le)}));
    lit_end(&s);
    path_tracer_of(&s, NULL, path_defaults, &t);
    for (int below = 0; below < 2; below++) {
        vec3 wo = vunit(vec(-1, 0.5, 3)), wi = vunit((vec3){1, 0, 2});
        rough_glass from = below ? (rough_glass){g.alpha, g.n2, g.n1} : g;
        double cosine = (double)wi.z;
        if (below) wi.z = -wi.z;  /* z is where wo is */
        double exact = (double)rough_glass_value(&from, wi, wo) * cosine * 10 / 5;
        if (below) wo.z = -wo.z;
        path_random q = path_start(&t.how, 13, 1, 0, 1);
        vec3 L = path_radiance(&t, ray_from(wo, vneg(wo)), &q, &c);
        check_at_least(exact, 0.01, "light to compare");
        check_close((double)L.x, exact, 4 * (double)d * exact, "below: %d", below);
    }
    path_tracer_free(&t), lit_free(&s);
}

/* A closed white room in which nothing shines: if a path were traced, it would have 50 bounces. */
static void test_no_light(void)
{
    lit_scene s;
    path_tracer t;
    path_counts c = {0};
    lit_begin(&s);
    uint16_t white = lit_add_material(&s, (material){.kd = vec(1, 1, 1)});
    lit_add_shape(&s, shape_of_sphere((sphere){{0, 0, 0}, -3}), white);
    lit_end(&s);
    path_options how = path_defaults;
    how.bounces = 50;
    path_tracer_of(&s, NULL, how, &t);
    for (uint64_t i = 0; i < 100; i++) {
        path_random q = path_start(&t.how, 13, i, 0, 1);
        vec3 L = path_radiance(&t, ray_from((vec3){0, 0, 0}, (vec3){0, 0, 1}), &q, &c);
        check(vzero(L), "no light");
    }
    check_equal(path_rays(&c), 0, "rays in a scene without light");
    check_equal(c.paths, 100, "paths asked for");
    t.dark = false;
    path_random q = path_start(&t.how, 13, 0, 0, 1);
    vec3 L = path_radiance(&t, ray_from((vec3){0, 0, 0}, (vec3){0, 0, 1}), &q, &c);
    check(vzero(L), "nor along a path that is traced");
    check_equal(path_rays(&c), 51, "rays that are spared, of one path");
    path_tracer_free(&t), lit_free(&s);
}

/* ---- which light: as often as lit_lights_chance says, and as its pdf says ---- */

/* Counts of all threads are sums, each of its own. */
static void test_counts(void)
{
    path_counts all = {1, 2, 3, 4, 5, 6, 7, 8}, one = {10, 20, 30, 40, 50, 60, 70, 80};
    const path_counts due = {11, 22, 33, 44, 55, 66, 77, 88};
    path_counts_add(&all, &one);
    check(memcmp(&all, &due, sizeof due) == 0, "counts are added");
    check_equal(path_rays(&due), 22 + 33 + 44, "rays: of the camera, on, and to lights");
}

static void test_choice_of_light(void)
{
    lit_scene s;
    environment sky;
    lit_lights l;
    estimate often[3] = {{0}, {0}, {0}};
    random_stream from = random_start(26, 8, 1);
    size_t wrong = 0, skies = 0, rim = 0;
    environment_sky(16, 8, (vec3){0, 1, 0}, &sky);
    lit_begin(&s);
    for (int i = 0; i < 3; i++) {
        material m = {.ke = {1, 1, (real)(1 + 2 * i)}};
        lit_add_shape(&s, shape_of_sphere((sphere){{(real)(3 * i), 0, 0}, 1}),
                      lit_add_material(&s, m));
    }
    lit_end(&s), lit_lights_of(&s, &sky, LIGHTS_FLUX, &l);
    for (size_t k = 0; k < check_count(20000); k++) {
        lit_draw x = {.pdf = 0};
        vec3 p = {2, 5, 1};
        point2 u = {random_next(&from), random_next(&from)};
        bool some = lit_lights_sample(&l, POINTS_CHEAP, p, u, &x);
        for (uint32_t i = 0; i < 3; i++) often[i] = estimate_add(often[i], some && x.emitter == i);
        if (!some) continue;
        bool dark = x.emitter == lit_dark;
        skies += dark;
        if (dark && !vzero(vsub(environment_radiance(&sky, x.wi), x.Le))) {
            rim++;  /* drawn so near to a texel's edge that x.wi is in the next one */
            continue;
        }
        real q = dark ? lit_lights_pdf_sky(&l, x.wi)
                      : lit_lights_pdf(&l, POINTS_CHEAP, x.emitter, p, vlength(vsub(x.s.p, p)), 1);
        wrong += !(fabs(q / x.pdf - 1) < 64 * real_epsilon);
    }
    check_equal(wrong, 0, "pdfs that are not what lit_lights_pdf says");
    check_at_most(rim, 2 + skies / 1000, "draws at the edge of a texel, of %zu", skies);
    for (int i = 0; i < 3; i++)  /* radiances 3, 5, 7 of 15, and half of all to the sky */
        check_at_least(t_test(often[i], (3 + 2 * i) / 30.0, 1e-6), false_alarm,
                       "light %d: drawn %g of the times", i, often[i].mean);
    lit_lights_free(&l), lit_free(&s), environment_free(&sky);
}

/* ---- only what is called for ---- */

static path_counts count(const char *name, path_options how, image *out)
{
    const options o = {.seed = 2, .threads = 1};
    shot s;
    shot_of(&s, &o, name, how, 20, 20);
    passes_range(render_passes(&s.j), &s.film, 0, 8);
    check_equal(s.j.refused, 0, "samples that are not numbers, %s", name);
    image im = film_picture(&s.film);
    for (int i = 0; i < 3 * 400; i++) check(isfinite(im.rgb[i]) && im.rgb[i] >= 0, "a radiance");
    if (out) *out = im;
    else image_free(&im);
    shot_free(&s);
    return s.j.counts;
}

static void test_called_for(void)
{
    path_options how = path_defaults, all = how;
    all.spend_all = true;
    static const char *const names[] = {"cornell", "spheres", "metal", "teapot", "rough"};
    for (int i = 0; i < 5; i++) {
        const char *name = names[i];
        image plain, spent;
        path_counts a = count(name, how, &plain), b = count(name, all, &spent);
        check(memcmp(plain.rgb, spent.rgb, 3 * 400 * sizeof *plain.rgb) == 0,
              "%s: the same picture, byte for byte, when all is spent", name);
        check_at_least(b.shadow, a.shadow, "%s: shadow rays", name);
        check_equal(a.spent, 0, "%s: nothing is spent in vain", name);
        bool glass = strcmp(name, "spheres") == 0 || strcmp(name, "rough") == 0;
        check((a.refractions > 0) == glass, "%s: refraction code runs where there is glass", name);
        check(a.light_draws > 0, "%s: light samples where there are lights", name);
        if (i == 0) check_at_least(b.spent, 100, "the box: there was something to spend");
        image_free(&plain), image_free(&spent);
    }
    how.bounces = 0;
    path_counts none = count("cornell", how, NULL);
    check_equal(none.bounce + none.shadow + none.dice + none.light_draws, 0, "no bounce: no dice");
    how = path_defaults, how.light_sampling = how.mis = false;
    check_equal(count("cornell", how, NULL).shadow, 0, "directions only: no shadow rays");
}

int main(void)
{
    return check_all("26_path_tracer", test_roulette, test_closed_sphere, test_furnace,
                     test_leaning_normals, test_glass, test_rough_glass, test_called_for,
                     test_choice_of_light, test_counts, test_in_glass, test_sides, test_rough_lit,
                     test_rough_noise, test_rough_point, test_no_light, test_crowded,
                     test_naive, test_rows);
}
