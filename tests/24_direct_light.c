/* Tests of 24_direct_light: every way of drawing against closed forms (22), hard cases, rays that
 * are not traced, and the naive ways failing. Fixed seeds; each t-test alarms falsely once in 1e8
 * seeds, all of them together once in 1e6. */
#include "../common/lab/t_test.h"
#include "../chapters/22_radiometry/lab/oracle.h"
#include "../chapters/22_radiometry/lab/sphere_irradiance.h"
#include "../chapters/23_brdf/lab/reference.h"
#include "../chapters/24_direct_light/direct.h"
#include "../chapters/24_direct_light/lab/pictures.h"
#include "../chapters/24_direct_light/scenes/lit_cornell.h"
#include "check.h"

#define alarm 1e-8
#define eps ((double)real_epsilon)

static const vec3 white = {1, 1, 1}, black = {0, 0, 0}, up = {0, 0, 1};

/* ---- scenes: lights alone, seen from the origin, whose surface faces up ---- */

typedef struct { lit_scene s; double truth, hits; const char *what; bool near; } setting;

static uint16_t lamp_of(lit_scene *s, double L)
{
    return lit_add_material(s, (material){.ke = vec(L, L, L)});
}

/* A sphere of radius r at o; with r = 0 a rectangle. near: samples by area have so long a tail that
 * their mean is not normal (test_fireflies). hidden: the other half of it is behind an obstacle. */
typedef struct { real r; vec3 o, s, t; const char *what; bool near, hidden; } light_row;
static const light_row light_list[] = {
    {0, {-1, -1, 2}, {0, 2, 0}, {2, 0, 0}, .what = "overhead"},
    {0, {3, 4, 10}, {0, .01, 0}, {.01, 0, 0}, .what = "small"},
    {0, {-40, -40, 1}, {0, 80, 0}, {80, 0, 0}, .what = "large", .near = true},
    {0, {1, -1, -1}, {0, 0, 2}, {0, 2, 0}, .what = "across the horizon"},
    {0, {.2, -1, 0}, {0, 0, 2}, {0, 2, 0}, .what = "stands on it, near", .near = true},
    {0, {5, -1, .001}, {0, 0, .1}, {0, 2, 0}, .what = "low"},
    {0, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, .what = "in its plane"},
    {0, {-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, .what = "below"},
    {0, {-1, -1, 2}, {2, 0, 0}, {0, 2, 0}, .what = "turned away"},
    {0, {-1, -1, 1}, {0, 2, 1}, {2, 0, 0}, .what = "leaning"},
    {1, {1, 0, 3}, .what = "sphere"},
    {1, {2, 0, 0}, .what = "sphere, half below"},
    {1, {0, 0, 1.001}, .what = "sphere, all but touching", .near = true},
    {.01, {30, 20, 100}, .what = "small sphere"},
    {-1, {.3, .2, .1}, .what = "inside a sphere that shines inwards"},
    {1, {.3, .2, .1}, .what = "inside a sphere that shines outwards"},
    {0, {0, -1, 2}, {0, 2, 0}, {1, 0, 0}, .what = "half of it behind an obstacle", .hidden = true}};
enum { settings = sizeof light_list / sizeof *light_list };

/* truth: E for L = 1. hits: the part of cosine-distributed directions that meet the light. */
static setting light_of(light_row l)
{
    setting x = {.what = l.what, .near = l.near};
    rectangle r = {l.o, l.s, l.t};
    sphere b = {l.o, l.r};
    lit_begin(&x.s);
    uint16_t lamp = lamp_of(&x.s, 1);
    if (l.r != 0) {
        bool inside = vlength(l.o) < fabs(l.r);
        lit_add_shape(&x.s, shape_of_sphere(b), lamp);
        x.truth = inside == (l.r < 0) ? (double)sphere_irradiance(b, black, up) : 0;
    } else {
        x.truth = rectangle_irradiance_exact(r, black, up);
        if (l.hidden) r = (rectangle){vsub(l.o, l.t), l.s, vscale(l.t, 2)};
        lit_add_rectangle(&x.s, r, lamp);
    }
    if (l.hidden)
        lit_add_rectangle(&x.s, (rectangle){vec(-.5, -.5, 1), vec(.5, 0, 0), vec(0, 1, 0)},
                          lit_add_material(&x.s, (material){.kd = white}));
    lit_end(&x.s);
    x.hits = x.truth / (double)pi;
    return x;
}

static setting setting_of(int i) { return light_of(light_list[i]); }

/* A point of some surface of which nothing else is known, at p. */
static lit_hit place(vec3 p, const brdf *f)
{
    surface s = {p, up, up, 2 * real_epsilon * surface_reach(p), 0, no_shape};
    return (lit_hit){s, NULL, f, lit_dark, 1, true, false};
}

typedef struct { estimate e; direct_work w; double most; } outcome;
static outcome measure(const lit_scene *s, direct_way way, lit_lights_rule kind, brdf f, vec3 wo,
                       size_t n, bool spend_all)
{
    lit_hit h = place(black, &f);
    outcome o = {{0}, {0, 0, 0}, 0};
    lit_lights l;
    lit_lights_of(s, NULL, kind, &l);
    direct d = {s, way, &l, &o.w, spend_all};
    for (size_t k = 0; k < n; k++) {
        sampler q = sampler_start(SEQUENCE_RANDOM, 24, (uint64_t)way, (uint32_t)k, (uint32_t)n);
        double x = (double)direct_light(&d, &h, wo, &q).x;
        o.most = check_worse(o.most, x);
        o.e = estimate_add(o.e, x);
    }
    lit_lights_free(&l);
    return o;
}

static outcome of_matte(const lit_scene *s, direct_way way, lit_lights_rule kind, size_t n)
{
    return measure(s, way, kind, brdf_lambert(white), up, n, false);
}

/* Matte and white: L = E / pi. A way that meets or misses the light only a few times has no normal
 * mean yet; where the truth is 0, each way must say 0. */
static void test_closed_forms(void)
{
    size_t n = check_count(20000), tests = 0;
    for (int i = 0; i < settings; i++) {
        setting x = setting_of(i);
        for (int way = 0; way < direct_ways; way++) {
            bool directions = way <= DIRECT_BRDF || way == DIRECT_HALF;
            double rare = x.hits < 1 - x.hits ? x.hits : 1 - x.hits;
            if (directions && rare > 0 && rare * (double)n < 400) continue;
            if (way == DIRECT_AREA && x.near) continue;
            outcome o = of_matte(&x.s, (direct_way)way, LIGHTS_ALL, n);
            double truth = x.truth / (double)pi;
            /* the obstacle's edge is where the reals of its corners are: some epsilons */
            check_at_least(t_test(o.e, truth, 256 * eps * truth), alarm, "%s, %s: %g, is %g",
                           x.what, direct_name[way], o.e.mean, truth);
            tests += x.truth > 0;
        }
        lit_free(&x.s);
    }
    check_at_least(tests, 30, "settings and ways with something to test");
}

/* ---- glossy: in a closed furnace of radiance 1 each way gives the albedo ---- */

static void test_glossy(void)
{
    vec3 wo = vunit(vec(-.6, 0, .8)), f0 = vec(.9, .9, .9);
    const brdf list[3] = {brdf_ggx(f0, .4), brdf_ggx(f0, .7),
                          brdf_blinn_phong(vec(.2, .2, .2), vec(.6, .6, .6), 50)};
    size_t n = check_count(20000);
    setting all = setting_of(14);
    for (int i = 0; i < 3; i++) {
        double albedo = (double)brdf_albedo(&list[i], wo.z).x;
        for (int way = DIRECT_BRDF; way < direct_ways; way++) {
            /* by all directions alike a narrow lobe is met too seldom for a normal mean */
            if (way == DIRECT_AREA && i == 0) continue;
            outcome o = measure(&all.s, (direct_way)way, LIGHTS_ALL, list[i], wo, n, false);
            check_at_least(t_test(o.e, albedo, 3e-3), alarm, "furnace, brdf %d, %s", i,
                           direct_name[way]);
        }
    }
    lit_free(&all.s);
}

/* Veach's theorem 9.2 for one sample of each: V(balance) <= V(any other weights) + mu^2 / 2, hence
 * than each way alone. Variances are known to some sqrt(2 kurtosis / n): a tenth is added. */
static void test_never_worse(void)
{
    vec3 wo = vunit(vec(-.6, 0, .8)), f0 = vec(1, 1, 1);
    size_t n = check_count(40000);
    for (int i = 0; i < 6; i++) {
        brdf f = brdf_ggx(f0, (real)(i % 3 == 0 ? .15 : i % 3 == 1 ? .4 : 1));
        setting x = light_of((light_row){.r = i < 3 ? (real).2 : 3, .o = {3, 0, 4}});
        double v[direct_ways], mean = 0;
        for (int way = DIRECT_BRDF; way < direct_ways; way++) {
            if (way == DIRECT_AREA) continue;
            outcome o = measure(&x.s, (direct_way)way, LIGHTS_ALL, f, wo, n, false);
            v[way] = estimate_variance(o.e);
            if (way == DIRECT_BALANCE) mean = o.e.mean;
        }
        double least = v[DIRECT_BRDF] < v[DIRECT_ANGLE] ? v[DIRECT_BRDF] : v[DIRECT_ANGLE];
        double most = v[DIRECT_BRDF] + v[DIRECT_ANGLE] - least;
        double slack = 1.1 + 20 / sqrt((double)n);
        check_at_most(v[DIRECT_BALANCE], slack * (least + mean * mean / 2), "balance, case %d", i);
        /* The worse half stays: (V1 + V2) / 4, whatever the better one does. In the cases between
         * too few directions meet the lamp, or miss it, for their variance to be known. */
        if (i == 0 || i > 3)
            check_at_least(v[DIRECT_HALF] * slack, most / 4, "half and half, case %d", i);
        lit_free(&x.s);
    }
}

/* ---- area: a wall that shines stands on the floor, p at the distance h before it ---- */

/* That its variance grows as 1/h^2 is tested in 24_first. */
static void test_fireflies(void)
{
    setting x = light_of((light_row){.o = vec(1e-3, -1, 0), .s = {0, 0, 2}, .t = {0, 2, 0}});
    size_t n = 20000;  /* one sample by area in 770 is above 4: none of them in one seed of 10^11 */
    outcome area = of_matte(&x.s, DIRECT_AREA, LIGHTS_ALL, n);
    outcome angle = of_matte(&x.s, DIRECT_ANGLE, LIGHTS_ALL, n);
    outcome power = of_matte(&x.s, DIRECT_POWER, LIGHTS_ALL, n);
    /* cos omega / pi <= 1 here: omega is a quarter of all directions, pi */
    check_at_most(angle.most, 1 + 64 * eps, "by angle: no sample above f omega");
    check_at_most(power.most, 2, "power: f cos / p is at most 1 of either");
    check_at_least(area.most, 4, "by area: a sample far above the mean, 1/2");
    check_at_most(estimate_variance(angle.e), 0.25, "by angle: samples in [0, 1]");
    lit_free(&x.s);
}

/* ---- several lights ---- */

static void test_several(void)
{
    setting x = {.what = "several"};
    double truth = 0;
    lit_begin(&x.s);
    for (int k = 0; k < 5; k++) {
        double L = k == 0 ? 60 : 1 + k;
        rectangle r = {vec(2 * k - 5, -1, 2), vec(0, 1, 0), vec(.6, 0, 0)};
        sphere b = {vec(2 * k - 5, 2, 1), .3};
        lit_add_rectangle(&x.s, r, lamp_of(&x.s, L));
        lit_add_shape(&x.s, shape_of_sphere(b), lamp_of(&x.s, L));
        truth += L * (rectangle_irradiance_exact(r, black, up)
                 + (double)sphere_irradiance(b, black, up));
    }
    lit_end(&x.s);
    check_equal(x.s.emitters, 10, "lights");
    size_t n = check_count(8000);
    double v[3];
    truth /= (double)pi;
    for (int kind = LIGHTS_ALL; kind <= LIGHTS_FLUX; kind++)
        for (int way = DIRECT_AREA; way < direct_ways; way++) {
            if (way == DIRECT_HALF) continue;  /* its directions meet these lamps too seldom */
            outcome o = of_matte(&x.s, (direct_way)way, (lit_lights_rule)kind, n);
            check_at_least(t_test(o.e, truth, 256 * eps * truth), alarm, "choice %d, %s: %g, is %g",
                           kind, direct_name[way], o.e.mean, truth);
            if (way == DIRECT_ANGLE) v[kind] = estimate_variance(o.e);
            if (way == DIRECT_ANGLE)
                check_equal(o.w.shadow, kind == LIGHTS_ALL ? 10 * n : n, "shadow rays a sample");
        }
    /* All: the sum of the lights' own variances; one: their means differ, too, times 1/P. */
    check_at_least(v[LIGHTS_UNIFORM], 2 * v[LIGHTS_ALL], "one of ten is noisier than all");
    lit_free(&x.s);
}

/* Flux is the sum of all colours, times area, 4 pi R^2 of a ball: of 3, 3, 6 and 12 here. And a
 * sample leaves the sampler behind all that it has asked for. */
static void test_choice(void)
{
    lit_scene s;
    lit_begin(&s);
    for (int k = 0; k < 3; k++) {
        vec3 Le = {k == 0 ? 3 : 0, k == 1 ? 3 : 0, k == 2 ? 4 : 0};
        uint16_t lamp = lit_add_material(&s, (material){.ke = Le});
        rectangle r = {vec(2 * k - 3, 0, 1), vec(0, k < 2 ? 1 : 1.5, 0), vec(1, 0, 0)};
        lit_add_rectangle(&s, r, lamp);
    }
    uint16_t round = lit_add_material(&s, (material){.ke = vec(0, 0, 12 / (double)pi)});
    lit_add_shape(&s, shape_of_sphere((sphere){{7, 8, 9}, (real).5}), round);
    lit_end(&s);
    for (int kind = LIGHTS_ALL; kind <= LIGHTS_FLUX; kind++) {
        lit_lights l;
        direct_work w = {0, 0, 0};
        brdf matte = brdf_lambert(white);
        lit_hit h = place(black, &matte);
        lit_lights_of(&s, NULL, (lit_lights_rule)kind, &l);
        direct d = {&s, DIRECT_POWER, &l, &w, false};
        const double flux[4] = {.125, .125, .25, .5};
        for (size_t k = 0; k < 4; k++)
            check_close(lit_lights_chance(&l, k),
                        kind == LIGHTS_ALL ? 1 : kind == LIGHTS_UNIFORM ? .25 : flux[k], 16 * eps,
                        "chance of light %zu, choice %d", k, kind);
        sampler q = sampler_start(SEQUENCE_SOBOL, 1, 2, 3, 4), next = q;
        direct_light(&d, &h, up, &q);
        /* a direction; then four points, or which one and its point */
        for (int k = 0; k < (kind == LIGHTS_ALL ? 5 : 3); k++) sampler_pair(&next);
        point2 a = sampler_pair(&q), b = sampler_pair(&next);
        check(a.u == b.u && a.v == b.v, "choice %d: the sampler stands behind it", kind);
        lit_lights_free(&l);
    }
    lit_free(&s);
}

/* ---- only what is called for ---- */

static void test_called_for(void)
{
    setting overhead = setting_of(0), below = setting_of(7), away = setting_of(8);
    setting inside = setting_of(15), ball = setting_of(11), hidden = setting_of(16);
    lit_scene none;
    lit_begin(&none), lit_end(&none);
    size_t n = 1000;
    brdf matte = brdf_lambert(white), dark = brdf_lambert(black), mirror = brdf_mirror(white);
    const struct { const lit_scene *s; const brdf *f; const char *what; } spared[] = {
        {&below.s, &matte, "light below"}, {&away.s, &matte, "light turned away"},
        {&inside.s, &matte, "inside a light"}, {&overhead.s, &dark, "black"},
        {&none, &matte, "no lights"}};
    for (int i = 0; i < direct_ways; i++) {
        direct_way w = (direct_way)i;
        size_t one = w <= DIRECT_BRDF || direct_both(w) ? n : 0;
        for (int k = 0; k < 5; k++) {
            outcome o = measure(spared[k].s, w, LIGHTS_UNIFORM, *spared[k].f, up, n, false);
            check_equal(o.w.shadow + (k > 2 ? o.w.direction : 0), 0, "%s, %s", spared[k].what,
                        direct_name[i]);
            if (k > 2) check_equal(o.e.mean, 0, "%s, %s", spared[k].what, direct_name[i]);
        }
        outcome o = measure(&overhead.s, w, LIGHTS_ALL, matte, up, n, false);
        check_equal(o.w.shadow, w >= DIRECT_AREA ? n : 0, "overhead, %s: shadow", direct_name[i]);
        check_equal(o.w.direction, one, "overhead, %s: directions", direct_name[i]);
        o = measure(&overhead.s, w, LIGHTS_ALL, mirror, up, n, false);
        bool finds = w == DIRECT_BRDF || direct_both(w);
        check_equal(o.w.shadow, 0, "mirror, %s: shadow", direct_name[i]);
        check_equal(o.w.direction, finds ? n : 0, "mirror, %s", direct_name[i]);
        /* straight up is the light: all of it, but for those who cannot name the direction */
        double whole = !finds ? 0 : w == DIRECT_HALF ? .5 : 1;
        check_close(o.e.mean, whole, 4 * eps, "mirror, %s", direct_name[i]);
        check_equal(o.e.squares, 0, "mirror, %s: no noise", direct_name[i]);
    }
    /* spent all the same: more rays, the same bits */
    const setting *list[] = {&overhead, &below, &ball, &hidden, &away};
    const brdf kinds[] = {matte, dark, mirror, brdf_ggx(white, .3)};
    for (int i = 0; i < direct_ways; i++)
        for (int j = 0; j < 5; j++)
            for (int k = 0; k < 4; k++) {
                vec3 wo = vunit(vec(.5, .2, .6));
                outcome a = measure(&list[j]->s, (direct_way)i, LIGHTS_ALL, kinds[k], wo, n / 5,
                                    false);
                outcome b = measure(&list[j]->s, (direct_way)i, LIGHTS_ALL, kinds[k], wo, n / 5,
                                    true);
                check(a.e.mean == b.e.mean && a.e.squares == b.e.squares, "%s, %s: spent, and the "
                      "result is another", list[j]->what, direct_name[i]);
                check(a.w.shadow <= b.w.shadow && a.w.direction <= b.w.direction, "more rays");
            }
    outcome o = measure(&ball.s, DIRECT_ANGLE, LIGHTS_ALL, matte, up, n, false);
    outcome all = measure(&ball.s, DIRECT_ANGLE, LIGHTS_ALL, matte, up, n, true);
    check_equal(all.w.shadow, n, "spend_all: each sample its shadow ray");
    /* half of the sphere is below the horizon: so is half of what is drawn */
    check_close((double)o.w.shadow / (double)n, .5, .1, "light half below: half of the rays");
    lit_free(&overhead.s), lit_free(&below.s), lit_free(&away.s), lit_free(&inside.s);
    lit_free(&ball.s), lit_free(&hidden.s), lit_free(&none);
}

/* A shading normal that leans away: the light is above its horizon, but below the surface. */
static void test_leaning(void)
{
    setting x = light_of((light_row){.o = {1, -1, -1}, .s = vec(0, 0, .9), .t = {0, 2, 0}});
    brdf matte = brdf_lambert(white);
    lit_hit h = place(black, &matte);
    h.s.ns = vunit(vec(1, 0, .5));
    lit_lights l;
    lit_lights_of(&x.s, NULL, LIGHTS_ALL, &l);
    for (int way = 0; way < direct_ways; way++) {
        direct_work w = {0, 0, 0};
        direct d = {&x.s, (direct_way)way, &l, &w, false};
        double sum = 0;
        for (uint32_t k = 0; k < 1000; k++) {
            sampler q = sampler_start(SEQUENCE_RANDOM, 6, 0, k, 1000);
            sum += (double)direct_light(&d, &h, up, &q).x;
        }
        check_equal(sum, 0, "light below a leaning normal's surface, %s", direct_name[way]);
        check_equal(w.shadow, 0, "no shadow ray to it, %s", direct_name[way]);
        if (way == DIRECT_COSINE)
            check(w.direction > 600 && w.direction < 800, "directions below are not traced");
        direct_work behind = {0, 0, 0};
        d.work = &behind;
        sampler q = sampler_start(SEQUENCE_RANDOM, 6, 0, 0, 1);
        vec3 L = direct_light(&d, &h, vunit(vec(-1, 0, .25)), &q);  /* above n, below ns */
        check(vzero(L) && behind.direction + behind.shadow == 0, "wo behind ns: black, no ray");
    }
    lit_lights_free(&l), lit_free(&x.s);
}

/* Nothing but a background of 1: a white surface is as bright, in every direction. A lamp in front
 * of it changes nothing if it is as bright, for those who see both. */
static void test_background(void)
{
    setting lamp = setting_of(9);
    size_t n = check_count(20000);
    for (int k = 0; k < 2; k++) {
        lit_scene none, *s = k ? &lamp.s : &none;
        lit_begin(&none), lit_end(&none);
        s->background = white;
        for (int way = 0; way < direct_ways; way++) {
            outcome o = of_matte(s, (direct_way)way, LIGHTS_ALL, n);
            bool along = way <= DIRECT_BRDF || direct_both((direct_way)way);
            double truth = along ? 1 : k ? lamp.truth / (double)pi : 0;
            check_at_least(t_test(o.e, truth, 256 * eps), alarm, "background, lamp %d, %s", k,
                           direct_name[way]);
        }
        lit_free(&none);
    }
    lit_free(&lamp.s);
}

/* Receivers on real surfaces, far out and far off: no light on itself, no shadow from itself. A
 * sphere and a mesh, light of every kind; compare with the closed form of a matte point. */
static void test_far(void)
{
    for (int i = 0; i < 4; i++) {
        double far = i % 2 ? (real_is_float ? 1e3 : 1e6) : 0, n = (double)check_count(20000);
        lit_scene s;
        vec3 at = vec(far, -far, far / 2);
        lit_begin(&s);
        uint16_t grey = lit_add_material(&s, (material){.kd = white});
        rectangle floor = {vadd(at, vec(-4, -4, 0)), vec(8, 0, 0), vec(0, 8, 0)};
        rectangle wall = {vadd(at, vec(.25, -1, 0)), vec(0, 0, 2), vec(0, 2, 0)};
        lit_add_rectangle(&s, floor, grey);
        if (i < 2) lit_add_rectangle(&s, wall, lamp_of(&s, 1));
        sphere b = {vadd(at, vec(0, 0, 1)), .875};
        if (i >= 2) lit_add_shape(&s, shape_of_sphere(b), lamp_of(&s, 1));
        lit_end(&s);
        lit_lights l;
        direct_work w = {0, 0, 0};
        lit_lights_of(&s, NULL, LIGHTS_ALL, &l);
        lit_hit h;
        ray down = ray_between(vadd(at, vec(0, 0, .0625)), vsub(at, vec(0, 0, 1)));
        check(lit_trace(&s, down, &h) && h.s.shape < 2, "the floor is met, at %g", far);
        double truth = i < 2 ? rectangle_irradiance_exact(wall, h.s.p, up)
                             : (double)sphere_irradiance(b, h.s.p, up);
        for (int way = 0; way < direct_ways; way++) {
            direct d = {&s, (direct_way)way, &l, &w, false};
            estimate e = {0};
            if (way == DIRECT_AREA && i >= 2) continue;  /* the sphere is near */
            for (uint32_t k = 0; (double)k < n; k++) {
                sampler q = sampler_start(SEQUENCE_RANDOM, 5, (uint64_t)way, k, (uint32_t)n);
                e = estimate_add(e, (double)direct_light(&d, &h, up, &q).x);
            }
            /* far out the reals of the corners round: 1e6 eps of a light at a distance of 1/8 */
            double round = (256 + 64 * far) * eps;
            check_at_least(t_test(e, truth / (double)pi, round), alarm, "at %g, light %d, %s", far,
                           i / 2, direct_name[way]);
        }
        lit_lights_free(&l), lit_free(&s);
    }
}

/* An area light as k point lights: where all of it is seen, the midpoint rule, whose error falls as
 * the square of a cell's side, that is as 1/k (for 4 and 16 the next term, in 1/k^2, still counts,
 * so from 64 on). Truth: the closed form. Behind an obstacle it sees
 * some of them only, and half of the lamp is hidden from the origin. */
static void test_point_lights(void)
{
    const brdf matte = brdf_lambert(white);
    setting open = setting_of(9), hidden = setting_of(16);
    lit_hit h = place(black, &matte);
    for (int half = 0; half < 2; half++) {
        lit_lights l;
        direct_work work = {0, 0, 0};
        lit_lights_of(half ? &hidden.s : &open.s, NULL, LIGHTS_ALL, &l);
        direct d = {half ? &hidden.s : &open.s, DIRECT_AREA, &l, &work, false};
        double truth = (half ? hidden.truth : open.truth) / (double)pi, before = 0;
        for (int k = 0; k < 5; k++) {
            uint32_t seen, side = 1u << k;
            double off = fabs((double)point_lights(&d, &h, up, side, &seen).x / truth - 1);
            if (!half) check_equal(seen, side * side, "all %u point lights are seen", side * side);
            else if (k) check_equal(seen, side * side / 2, "half of %u are seen", side * side);
            if (k > 2) check_close(before / off, 4, 0.5, "error %g of %u, a fourth of that of a "
                                   "fourth of them", off, side * side);
            before = off;
        }
        lit_lights_free(&l);
    }
    lit_free(&open.s), lit_free(&hidden.s);
}

int main(void)
{
    return check_all("24_direct_light", test_closed_forms, test_glossy, test_never_worse,
                     test_fireflies, test_several, test_choice, test_called_for,
                     test_leaning, test_background, test_far, test_point_lights);
}
