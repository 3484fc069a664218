/* light.h: hard cases of 18 to 27: leaving a surface, optics, chance, lamps, bounces, the plan.
 *
 * Where chance has a part, a trial is an estimate of so many samples, and it is wrong if the truth,
 * a closed form, lies farther away than eight of the errors that the estimate itself reports. */
#ifndef HARD_LIGHT_H
#define HARD_LIGHT_H

/* 23 to 26 before 18, and 27 before 21 and 22: no type comes before parameters of its name. */
#include "../../chapters/20_monte_carlo/lab/integrands.h"
#include "../../chapters/20_monte_carlo/lab/sampling_naive.h"
#include "../../chapters/23_brdf/first.h"
#include "../../chapters/23_brdf/lab/brdf_naive.h"
#include "../../chapters/24_direct_light/direct.h"
#include "../../chapters/24_direct_light/scenes/lit_first.h"
#include "../../chapters/25_bounces/branching.h"
#include "../../chapters/25_bounces/lab/furnace.h"
#include "../../chapters/26_path_tracer/path.h"
#include "../../chapters/18_shade/lab/departures.h"
#include "../19_first_world.h"
#include "../19_optics_naive.h"
#include "../../chapters/21_distributed/distributed.h"
#include "../../chapters/27_effects/files/studio_read.h"
#include "../../chapters/27_effects/lab/draw.h"
#include "../../chapters/27_effects/first.h"
#include "../../chapters/27_effects/plan.h"
#include "../21_known.h"
#include "../../chapters/22_radiometry/lab/measure_hard.h"
#include "hard.h"

/* ---------------------------------------------------------------------------------------------- */

static inline bool hard_off(estimate e, double truth)
{
    return fabs(e.mean - truth) > 8 * estimate_error(e) + 64 * hard_eps * fabs(truth);
}

enum { way_first = 0, way_now = leavings - 1 };

/* k: a departure_kind; x: how far from the origin. Hits of one's own surface. */
static inline hard_count acne(int k, real x)
{
    hard_count c = {2000, 0, 0};
    for (size_t i = 0; i < c.tried; i++) {
        departure d;
        departure_make(&d, (departure_kind)k, 1, x, hard_seed, i);
        c.first += departure_self(&d, ways[way_first]), c.now += departure_self(&d, ways[way_now]);
    }
    return c;
}

/* The same rays: plates just above the surface that are missed. */
static inline hard_count leaks(int k, real x)
{
    hard_count c = {2000, 0, 0};
    for (size_t i = 0; i < c.tried; i++) {
        departure d;
        departure_make(&d, (departure_kind)k, 1, x, hard_seed, i);
        real gap = departure_gap(&d);
        c.first += departure_leak(&d, ways[way_first], gap);
        c.now += departure_leak(&d, ways[way_now], gap);
    }
    return c;
}

/* ---- 19: optics ---- */

/* Head-on, where rounding makes the cosine larger than 1. Wrong: no number, or not straight on. */
static inline hard_count head_on(int k, real x)
{
    hard_count c = {20000, 0, 0};
    (void)k;
    for (size_t i = 0; i < c.tried; i++) {
        random_stream s = random_start(hard_seed, i, 0);
        vec3 n = hard_unit(&s), d = vneg(n);
        snell a, b;
        bool first = snell_of_naive(d, n, 1, x, &a), now = snell_of(d, n, 1, x, &b);
        c.first += !(first && fabs(a.ct - 1) < 8 * hard_eps);
        c.now += !(now && fabs(b.ct - 1) < 8 * hard_eps);
    }
    return c;
}

/* What a pane lets through whose faces reflect a, b and c, all ways to and fro added up. */
static inline double panes_through(double a, double b, double c)
{
    double two = (1 - a) * (1 - b) / (1 - a * b);             /* through the first two faces */
    double back = b + (1 - b) * (1 - b) * a / (1 - a * b);    /* what they reflect from behind */
    return two * (1 - c) / (1 - back * c);
}

static inline double fresnel_at(double sine, double n1, double n2)
{
    double s1 = sine / n1, s2 = sine / n2, c1 = sqrt(1 - s1 * s1), c2 = sqrt(1 - s2 * s2);
    double s = (n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2);
    double p = (n2 * c1 - n1 * c2) / (n2 * c1 + n1 * c2);
    return (s * s + p * p) / 2;
}

/* Glass on water, with nothing between, under a sky that grows darker upwards, 1 to 0: what comes
 * through and what is reflected, by the formulas of three faces. Wrong: by a thousandth. */
static inline hard_count touching(int k, real x)
{
    static const real y[4] = {0, -1, -1, -2};
    first_scene s = {.below = {1, 1, 1}, .eps = x};
    hard_count c = {1000, 0, 0};
    (void)k;
    for (int i = 0; i < 4; i++)
        first_add_flat(&s, (vec3){-20, y[i], i % 2 ? -20 : 20}, (vec3){40, 0, 0},
                       (vec3){0, 0, i % 2 ? 40 : -40},
                       (first_material){.ior = i < 2 ? (real)1.5 : (real)1.33});
    first_world *w = first_world_new(&s, 12);
    for (int i = 0; i < 4; i++) w->on.look[i].body = i < 2 ? 1 : 3;
    for (uint64_t i = 0; i < c.tried; i++) {
        vec3 d = vunit((vec3){random_real(3, i, 0, 0), -1, random_real(3, i, 1, 0)});
        ray r = ray_from((vec3){0, 3, 0}, d);
        double sine = (double)sqrt(d.x * d.x + d.z * d.z), down = (1 - (double)d.y) / 2;
        double through = panes_through(fresnel_at(sine, 1, 1.5), fresnel_at(sine, 1.5, 1.33),
                                       fresnel_at(sine, 1.33, 1));
        double due = through * down + (1 - through) * (1 - down);
        c.first += fabs((double)first_whitted(&s, r, 12).x - due) > 1e-3;
        c.now += fabs((double)first_world_ray(w, r).x - due) > 1e-3;
    }
    first_world_free(w);
    return c;
}

/* Smoothed, at grazing angles: (19.1) about the shading normal, and lifted. Wrong: below the
 * surface. */
static inline hard_count rims(int k, real x)
{
    hard_count c = {20000, 0, 0};
    (void)k;
    for (size_t i = 0; i < c.tried; i++) {
        random_stream s = random_start(hard_seed, i, 0);
        vec3 n = hard_unit(&s), ns = vunit(vmadd(n, hard_unit(&s), x)), a, b;
        vbasis(n, &a, &b);
        vec3 d = vunit(vmadd(a, n, -x * random_next(&s)));
        if (vdot(d, ns) > 0) continue;
        vec3 w = reflect(d, ns);
        c.first += !(vdot(w, n) > 0), c.now += !(vdot(lifted(w, n), n) > 0);
    }
    return c;
}

/* ---- 20 ---- */

/* The variance of 1000 numbers about x (in float; in double as far out). Wrong: a tenth off. */
static inline hard_count far_means(int k, real x)
{
    hard_count c = {200, 0, 0};
    real mean = x * sqrt((real)FLT_EPSILON / real_epsilon);
    (void)k;
    for (uint64_t i = 0; i < c.tried; i++) {
        random_stream s = random_start(hard_seed, i, 0);
        first_samples first = {0, 0, 0};
        estimate now = {0, 0, 0}, due = now;
        for (int j = 0; j < 1000; j++) {
            real y = mean + random_next(&s) - (real)0.5;
            first_sample(&first, y);
            now = estimate_add(now, (double)y), due = estimate_add(due, (double)(y - mean));
        }
        double v = estimate_variance(due);
        c.first += !(fabs((double)first_variance(first) / v - 1) < 0.1);
        c.now += !(fabs(estimate_variance(now) / v - 1) < 0.1);
    }
    return c;
}

/* pi by directions of the lobe cos^x, and with a fifth of the cosine's among them. */
static inline hard_count fireflies(int k, real x)
{
    hard_count c = {200, 0, 0};
    (void)k;
    for (uint64_t i = 0; i < c.tried; i++) {
        c.first += hard_off(importance_run(x, 0, hard_seed, i, 4096), (double)pi);
        c.now += hard_off(importance_run(x, (real)0.2, hard_seed, i, 4096), (double)pi);
    }
    return c;
}

#define HARD_WAY(f) static inline vec3 hard_##f(real u, real v, const void *c) \
    { return (void)c, f(u, v); }
HARD_WAY(sample_disk) HARD_WAY(sample_disk_naive) HARD_WAY(sample_triangle)
HARD_WAY(sample_triangle_naive) HARD_WAY(sample_sphere) HARD_WAY(sample_sphere_naive)
HARD_WAY(sample_hemisphere) HARD_WAY(sample_hemisphere_naive)
static inline real hard_disk(vec3 w, const void *c) { return (void)c, pdf_disk(w); }
static inline real hard_sphere(vec3 w, const void *c) { return (void)c, pdf_sphere(w); }
static inline real hard_hemisphere(vec3 w, const void *c) { return (void)c, pdf_hemisphere(w); }
static inline real hard_half(vec3 w, const void *c)
{
    const triangle half = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    return (void)w, (void)c, pdf_triangle(half);
}

/* k: what is drawn, 20000 points; chi-square. Wrong: p < 1e-8. */
static inline hard_count densities(int k, real x)
{
    static const struct { chi_square_sampler *way[2]; chi_square_pdf *pdf; } list[4] = {
        {{hard_sample_disk_naive, hard_sample_disk}, hard_disk},
        {{hard_sample_triangle_naive, hard_sample_triangle}, hard_half},
        {{hard_sample_sphere_naive, hard_sample_sphere}, hard_sphere},
        {{hard_sample_hemisphere_naive, hard_sample_hemisphere}, hard_hemisphere}};
    enum { drawn_points = 20000 };
    hard_count c = {10, 0, 0};
    (void)x;
    for (uint64_t i = 0; i < c.tried; i++)
        for (int j = 0; j < 2; j++) {
            chi_square_sampler *way = list[k].way[j];
            chi_square_result r =
                k < 2 ? chi_square_points(way, list[k].pdf, NULL,
                                          k ? DOMAIN_TRIANGLE : DOMAIN_DISK, i, drawn_points)
                      : chi_square_directions(way, list[k].pdf, NULL, 1, i, drawn_points);
            *(j ? &c.now : &c.first) += r.p < 1e-8;
        }
    return c;
}

/* ---- 21 ---- */

/* Rays of a lobe over a floor, seen at a slant: those that lead into the floor. */
static inline hard_count sunk_lobes(int k, real x)
{
    hard_count c = {20000, 0, 0};
    surface floor = {{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, 0, 0, no_shape};
    vec3 d = {sqrt((1 - x) * (1 + x)), 0, -x};
    (void)k;
    for (size_t i = 0; i < c.tried; i++) {
        random_stream s = random_start(hard_seed, i, 0);
        real u = random_next(&s), v = random_next(&s);
        ray r;
        c.first += glossy_ray_naive(floor, d, 20, (point2){u, v}, &r) && !(r.d.z > 0);
        c.now += glossy_ray(floor, d, 20, (point2){u, v}, &r) && !(r.d.z > 0);
    }
    return c;
}

/* A penumbra in x pixels of 16 samples each: the same 16 in all of them, and each its own. Wrong:
 * the mean of the pixels is off by more than eight of the errors that x pixels of their own have,
 * and have it from their own samples. */
static inline hard_count alike(int k, real x)
{
    hard_count c = {100, 0, 0};
    known q;
    known_make((known_kind)k, &q);
    for (uint64_t i = 0; i < c.tried; i++) {
        estimate first = {0, 0, 0}, now = first;
        for (uint64_t p = 0; p < (uint64_t)x; p++)
            for (uint64_t j = 0; j < 16; j++) {
                random_stream a = random_start(hard_seed, i, j), b = random_start(i, p, j);
                real u = random_next(&a), v = random_next(&a), s = random_next(&b);
                first = estimate_add(first, known_sample(&q, (point2){u, v}));
                now = estimate_add(now, known_sample(&q, (point2){s, random_next(&b)}));
            }
        c.first += hard_off(first, q.truth), c.now += hard_off(now, q.truth);
    }
    known_free(&q);
    return c;
}

/* ---- 22: k is a row of its laboratory's table; wrong: more than 64 roundings off ---- */

static inline hard_count solid_angles(int k, real x)
{
    hard_count c = {hard_inputs, 0, 0};
    radiometry_hard_run *r = allocate(1, sizeof *r);
    (void)x;
    hard_fill(r, &hard_list[k], hard_seed);
    for (int i = 0; i < hard_inputs; i++) {
        double due = hard_exact(&r->in[i]), most = 64 * hard_eps * fabs(due);
        c.first += !(fabs((double)hard_value(&r->in[i], true) - due) <= most);
        c.now += !(fabs((double)hard_value(&r->in[i], false) - due) <= most);
    }
    free(r);
    return c;
}

/* ---- 23 ---- */

/* (n.h)^e; x: e in float, in double as far out. Wrong: off by a thousandth. */
static inline hard_count powers(int k, real x)
{
    hard_count c = {5000, 0, 0};
    real e = (real)((double)x * (double)FLT_EPSILON / hard_eps);
    first_brdf f = {{0, 0, 0}, {1, 1, 1}, e};
    (void)k;
    for (size_t i = 0; i < c.tried; i++) {
        real s = sqrt(8 / e) * (real)(i + 1) / (real)c.tried;
        vec3 h = {s, 0, sqrt((1 - s) * (1 + s))};
        double due = exp((double)e / 2 * log1p(-(double)s * (double)s));
        double first = (double)(first_brdf_value(f, h, h).x / first_brdf_scale(e));
        c.first += !(fabs(first / due - 1) < 1e-3);
        c.now += !(fabs((double)blinn_phong_power(e, h) / due - 1) < 1e-3);
    }
    return c;
}

/* GGX's D near the normal; x: alpha in roots of epsilon. In the plane of m: tan^2 from the angle,
 * not from m.z. Wrong: off by a thousandth. */
static inline hard_count facets(int k, real x)
{
    hard_count c = {5000, 0, 0};
    real a = x * sqrt(real_epsilon);
    (void)k;
    for (size_t i = 0; i < c.tried; i++) {
        real s = 4 * a * (real)i / (real)c.tried;
        vec3 m = {s, 0, sqrt((1 - s) * (1 + s))};
        double t = (double)s * (double)s / ((1 - (double)s) * (1 + (double)s)), aa = (double)a;
        double cc = (1 - (double)s) * (1 + (double)s), q = aa * aa + t;
        double due = aa * aa / (3.14159265358979324 * cc * cc * q * q);
        c.first += !(fabs((double)ggx_d_naive(a, m) / due - 1) < 1e-3);
        c.now += !(fabs((double)ggx_d(a, m) / due - 1) < 1e-3);
    }
    return c;
}

/* Reflects more than it gets? Head-on, exponents below x: Phong's highlight as a BRDF, and
 * Blinn's, normalised. The midpoint rule. */
static inline hard_count albedos(int k, real x)
{
    enum { steps = 40 };
    hard_count c = {20, 0, 0};
    vec3 up = {0, 0, 1};
    (void)k;
    for (size_t i = 0; i < c.tried; i++) {
        real e = x * (real)i / (real)c.tried;
        brdf now = brdf_blinn_phong((vec3){0, 0, 0}, (vec3){1, 1, 1}, e);
        double sum[2] = {0, 0};
        for (int j = 0; j < steps * steps; j++) {
            real z = ((real)(j / steps) + (real)0.5) / steps, r = sqrt((1 - z) * (1 + z));
            real turn = 2 * pi * ((real)(j % steps) + (real)0.5) / steps;
            vec3 wi = {r * cos(turn), r * sin(turn), z};
            double cell = 2 * (double)pi / (steps * steps) * (double)z;
            sum[0] += (double)phong_naive(e, wi, up) * cell;
            sum[1] += (double)brdf_value_local(&now, wi, up).x * cell;
        }
        c.first += sum[0] > 1.001, c.now += sum[1] > 1.001;
    }
    return c;
}

/* ---- 24 ---- */

/* A wall that shines, at x from a white point of the floor: points of the lamp, and both ways. */
static inline hard_count beside_lamps(int k, real x)
{
    static const first_material white = {.kd = {1, 1, 1}}, lamp = {.ke = {1, 1, 1}};
    hard_count c = {100, 0, 0};
    rectangle wall = {{x, -1, 0}, {0, 0, 2}, {0, 2, 0}};
    vec3 up = {0, 0, 1};
    first_scene f = {.eps = (real)1e-3 * x};
    lit_scene s;
    lit_lights l;
    direct_work work = {0, 0, 0};
    (void)k;
    first_add_flat(&f, wall.o, wall.s, wall.t, lamp);
    lit_first(&f, &s), lit_lights_of(&s, NULL, LIGHTS_ALL, &l);
    direct d = {&s, DIRECT_POWER, &l, &work, false};
    const brdf paper = brdf_lambert((vec3){1, 1, 1});
    lit_hit h = {{{0, 0, 0}, up, up, 0, 0, no_shape}, NULL, &paper, lit_dark, 1, true, false};
    first_point p = {.n = up, .v = up, .m = &white, .kd = {1, 1, 1}};
    double truth = rectangle_irradiance_exact(wall, p.p, up) / (double)pi;
    for (uint64_t i = 0; i < c.tried; i++) {
        estimate first = {0, 0, 0}, now = first;
        for (uint32_t j = 0; j < 4096; j++) {
            random_stream r = random_start(hard_seed, i, j);
            sampler q = sampler_start(SEQUENCE_RANDOM, hard_seed, i, j, 4096);
            first = estimate_add(first, (double)first_direct_by_lamp(&f, 0, p, &r).y);
            now = estimate_add(now, (double)direct_light(&d, &h, up, &q).y);
        }
        c.first += hard_off(first, truth), c.now += hard_off(now, truth);
    }
    lit_lights_free(&l), lit_free(&s);
    return c;
}

/* ---- 25: a furnace of the albedo x ---- */

/* Ten bounces, and the series without end. Wrong: a hundredth of the light is left out. */
static inline hard_count ten_bounces(int k, real x)
{
    hard_count c = {100, 0, 0};
    (void)k;
    for (size_t i = 0; i < c.tried; i++) {
        real rho = x * (real)(i + 1) / (real)c.tried;
        double due = 1 / (1 - (double)rho);
        c.first += (double)series_sum(1, rho, 10) < 0.99 * due;
        c.now += fabs((double)series_whole(1, rho) / due - 1) > 8 * hard_eps / (1 - (double)rho);
    }
    return c;
}

/* 500 paths of 100 bounces: directions drawn evenly, and by the cosine. */
static inline hard_count furnaces(int k, real x)
{
    static const direction_choice way[2] = {DIRECTIONS_UNIFORM, DIRECTIONS_COSINE};
    hard_count c = {20, 0, 0};
    lit_scene s;
    (void)k;
    furnace_sphere(&s, (vec3){1, 1, 1}, (vec3){x, x, x});
    for (uint64_t i = 0; i < c.tried; i++)
        for (int j = 0; j < 2; j++) {
            naive_path p = {&s, way[j], 100, false};
            naive_counts n = {{0}, 0, 0};
            estimate e = {0, 0, 0};
            for (uint32_t path = 0; path < 500; path++) {
                random_stream g = random_start(hard_seed, i, path);
                sampler q = sampler_start(SEQUENCE_RANDOM, i, path, 0, 1);
                (void)sampler_pair(&q);
                ray r = ray_from((vec3){0, 0, 0}, hard_unit(&g));
                e = estimate_add(e, (double)naive_radiance(&p, r, &q, &n).x);
            }
            *(j ? &c.now : &c.first) += hard_off(e, (double)series_sum(1, x, 100));
        }
    lit_free(&s);
    return c;
}

/* ---- 26 ---- */

/* A lamp of side 1/8 and radiance x found by luck, one path in a thousand: with samples cut at 2,
 * and as they come. 4096 is too few paths for so rare a light to show its error, so 65536. */
static inline hard_count clamped(int k, real x)
{
    hard_count c = {10, 0, 0};
    first_scene f = {.eps = (real)1e-5};
    rectangle pane = {{(real)-0.125, (real)-0.125, 1}, {0, (real)0.25, 0}, {(real)0.25, 0, 0}};
    lit_scene s;
    (void)k;
    first_add_flat(&f, pane.o, pane.s, pane.t, (first_material){.ke = {x, x, x}});
    first_add_flat(&f, (vec3){-4, -4, 0}, (vec3){8, 0, 0}, (vec3){0, 8, 0},
                   (first_material){.kd = {(real)0.5, (real)0.5, (real)0.5}});
    lit_first(&f, &s);
    double truth = 0.5 * (double)x / (double)pi
                 * rectangle_irradiance_exact(pane, (vec3){0, 0, 0}, (vec3){0, 0, 1});
    for (int j = 0; j < 2; j++) {
        path_tracer t;
        path_counts n = {0};
        path_options how = path_defaults;
        how.sequence = SEQUENCE_RANDOM, how.light_sampling = false, how.clamp = j ? 0 : 2;
        path_tracer_of(&s, NULL, how, &t);
        ray r = ray_from((vec3){3, 0, 3}, (vec3){-1, 0, -1});
        for (uint64_t i = 0; i < c.tried; i++) {
            estimate e = {0, 0, 0};
            for (uint64_t path = 0; path < 65536; path++) {
                path_random q = path_start(&t.how, hard_seed + i, path, 0, 1);
                e = estimate_add(e, (double)path_radiance(&t, r, &q, &n).y);
            }
            *(j ? &c.now : &c.first) += hard_off(e, truth);
        }
        path_tracer_free(&t);
    }
    lit_free(&s);
    return c;
}

/* ---- 27 ---- */

/* Is the picture of 27's plan that of everything, byte for byte? */
static inline bool room_is_whole(double kd, double y, int mirror)
{
    enum { across = 12, down = 8, room = 600 };
    char text[room];
    failure f;
    effects_ready q;
    snprintf(text, room, "camera from 0 1 3 at 0 0.8 0 angle 45\nmaterial wall\nKd %.4f\n"
             "material other\n%s\nuse wall\npolygon -3 0 3 3 0 3 3 0 -3 -3 0 -3\nuse other\n"
             "polygon -3 0 -3 3 0 -3 3 6 -3 -3 6 -3\nlight at 0 %.4f -2 colour 20\n", kd,
             mirror ? "illum 3\nKd 0\nKs 1" : "Kd 0.5", y);
    if (!studio_read_text(text, "room", NULL, &q.s, &f)) fail(f);
    if (!effects_get_ready(&q, 4 / (real)3, &f)) fail(f);
    image im[2];
    for (int j = 0; j < 2; j++) {
        drawing d = {.e = &q.e, .samples = 2, .seed = 5, .width = across, .height = down};
        effects_stage_effects(&q.e, j ? EFFECTS_EVERYTHING : q.p.effects | EFFECTS_DICED);
        draw_image(&d, &im[j], 1);
    }
    bool same = memcmp(im[0].rgb, im[1].rgb, 3 * across * down * sizeof *im[0].rgb) == 0;
    for (int j = 0; j < 2; j++) image_free(&im[j]);
    effects_ready_free(&q);
    return same;
}

/* k plates of clear glass, x thick, in an even sky of 1: they are not to be seen. Weak branches cut
 * at 1/512, as 19 does, beside the dice of 27. */
static inline hard_count plates(int k, real x)
{
    enum { room = 900 };
    hard_count c = {20, 0, 0};
    for (uint64_t i = 0; i < c.tried; i++) {
        random_stream g = random_start(hard_seed, i, (uint64_t)k);
        char text[room];
        failure f;
        studio s;
        effects_stage e;
        int n = snprintf(text, room, "camera from 0 0 9 at 0 0 0\nbackground 1\nindirect off\n"
                         "material glass\nKd 0\nNi %.3f\nillum 7\n",
                         1.3 + 0.4 * (double)random_next(&g));
        for (int j = 0; j < k; j++)
            n += snprintf(text + n, (size_t)(room - n), "box -99 -99 %g  99 99 %g\n", -j / 2.0,
                          (double)x - j / 2.0);
        if (!studio_read_text(text, "plates", NULL, &s, &f)) fail(f);
        if (!effects_stage_build(&s, &e, &f)) fail(f);
        ray r = ray_from((vec3){0, 0, 3}, vunit((vec3){random_next(&g) / 2, 0, -1}));
        for (int j = 0; j < 2; j++) {
            estimate seen = {0, 0, 0};
            plan p = plan_of(&s);
            effects_stage_effects(&e, p.effects);
            if (j == 0) effects_stage_cut(&e, (real)1 / 512);
            for (uint32_t t = 0; t < 400; t++) {
                dice_pixel of;
                effects_counts count = {.lost = 0};
                dice_pixel_of(hard_seed, i, true, &of);
                dice d = dice_sample(&of, t);
                vec3 L = effects_alone(effects_made_for(e.mask), &e, r, (media_set){0}, &d, &count);
                seen = estimate_add(seen, (double)L.y);
            }
            *(j ? &c.now : &c.first) += hard_off(seen, 1);
            plan_free(&p);
        }
        effects_stage_free(&e), studio_free(&s);
    }
    return c;
}

/* Two walls, with k = 1 a mirror one of them, and a point light. The plan's picture against that of
 * everything, which knows no plan: byte for byte; for first.h, a hundredth of the light. */
static inline hard_count rooms(int k, real x)
{
    hard_count c = {20, 0, 0};
    for (uint64_t i = 0; i < c.tried; i++) {
        random_stream s = random_start(hard_seed, i, (uint64_t)k);
        first_scene f = {.eps = (real)1e-4};
        first_plan lean = first_plan_of(&f), all;
        double kd = (double)x + 0.2 * (double)random_next(&s), sum[2] = {0, 0};
        double y = 1 + (double)random_next(&s);
        first_material m = {.kd = vec(kd, kd, kd)};
        first_add_flat(&f, vec(-3, 0, 3), vec(6, 0, 0), vec(0, 0, -6), m);
        first_add_flat(&f, vec(-3, 0, -3), vec(6, 0, 0), vec(0, 6, 0),
                       k ? (first_material){.mirror = {1, 1, 1}} : m);
        f.light[f.lights++] = (first_light){vec(0, y, -2), vec(20, 20, 20)};
        all = lean = first_plan_of(&f), all.on[first_bounces] = true;
        for (uint64_t j = 0; j < 2000; j++) {
            random_stream a = random_start(i, j, 1), b = a;
            ray r = ray_from(vec(0, 1, 3), vec((double)random_next(&s) - 0.5,
                                               (double)random_next(&s) - 0.7, -1));
            sum[0] += (double)first_planned(&f, &lean, r, true, 8, &a).y;
            sum[1] += (double)first_planned(&f, &all, r, true, 8, &b).y;
        }
        c.first += fabs(sum[0] / sum[1] - 1) > 0.01;
        c.now += !room_is_whole(kd, y, k);
    }
    return c;
}

static const hard_case hard_light[] = {
    {"18", "acne, sphere", "leaving a shape of size 1", "convex", acne, DEPART_SPHERE, 0, PROMISED},
    {"18", "acne, triangle", "the same", "convex", acne, DEPART_TRIANGLE, 0, PROMISED},
    {"18", "acne, needle", "the same", "convex", acne, DEPART_NEEDLE, 0, PROMISED},
    {"18", "acne, cone", "the same", "convex", acne, DEPART_CONE, 0, PROMISED},
    {"18", "acne, polygon", "the same", "convex", acne, DEPART_POLYGON, 0, PROMISED},
    {"18", "acne, sphere far", "1e6 away", "convex", acne, DEPART_SPHERE, (real)1e6, PROMISED},
    {"18", "acne, triangle far", "1e6 away", "convex", acne, DEPART_TRIANGLE, (real)1e6, PROMISED},
    {"18", "acne, polygon far", "1e6 away", "convex", acne, DEPART_POLYGON, (real)1e6, PROMISED},
    {"18", "leak, sphere", "a plate 1e-6 above", "plate", leaks, DEPART_SPHERE, 0, PROMISED},
    {"18", "leak, triangle", "the same", "plate", leaks, DEPART_TRIANGLE, 0, PROMISED},
    {"18", "leak, triangle far", "1e6 away", "plate", leaks, DEPART_TRIANGLE, (real)1e6, PROMISED},
    {"19", "head-on", "the cosine rounds to more than 1", "straight on", head_on, 0, (real)1.5,
     PROMISED},
    {"19", "glass on water", "two faces at one place", "formula", touching, 0, (real)1e-4,
     PROMISED},
    {"19", "black rims", "shading normals, grazing", "the plane", rims, 0, (real)0.2, PROMISED},
    {"20", "mean 1000", "deviation 0.3, float", "offsets", far_means, 0, 1000, PROMISED},
    {"20", "fireflies", "weights without bound, cos^20", "pi", fireflies, 0, 20, PROMISED},
    {"20", "disk", "r = u", "chi-square", densities, 0, 0, PROMISED},
    {"20", "triangle", "v (1 - u)", "chi-square", densities, 1, 0, PROMISED},
    {"20", "sphere", "a cube, normalised", "chi-square", densities, 2, 0, PROMISED},
    {"20", "hemisphere", "theta = pi/2 u", "chi-square", densities, 3, 0, PROMISED},
    {"21", "lobe, 45 degrees", "part of it leads into the floor", "the plane", sunk_lobes, 0,
     (real)0.7, PROMISED},
    {"21", "lobe, grazing", "half of it does", "the plane", sunk_lobes, 0, (real)0.05, PROMISED},
    {"21", "samples alike", "the same 16 in 64 pixels", "formula", alike, KNOWN_PENUMBRA, 64,
     PROMISED},
    {"22", "sphere, 1e-2", "solid angle, R/d = 1e-2", WIDE, solid_angles, 0, 0, PROMISED},
    {"22", "sphere, 1e-6", "R/d = 1e-6", WIDE, solid_angles, 1, 0, PROMISED},
    {"22", "sphere, touching", "a gap of 1e-6 R", WIDE, solid_angles, 2, 0, PROMISED},
    {"22", "triangle, 1e-3", "solid angle, size 1e-3", WIDE, solid_angles, 4, 0, PROMISED},
    {"22", "triangle, 1e-7", "size 1e-7", WIDE, solid_angles, 5, 0, PROMISED},
    {"22", "triangle, flat", "1e-6 off its plane", WIDE, solid_angles, 6, 0, PROMISED},
    {"22", "lamp sunk, 1e-1", "irradiance, half below, R/d 1e-1", WIDE, solid_angles, 7, 0,
     PROMISED},
    {"22", "lamp sunk, 1e-6", "R/d = 1e-6", WIDE, solid_angles, 9, 0, PROMISED},
    {"22", "lamp, grazing", "1e-4 R above the horizon", WIDE, solid_angles, 10, 0, PROMISED},
    {"23", "sharp, 1e4", "(n.h)^e, e = 1e4 in float", "log1p", powers, 0, 10000, PROMISED},
    {"23", "sharp, 1e6", "e = 1e6", "log1p", powers, 0, 1000000, PROMISED},
    {"23", "smooth GGX, 1", "alpha = root of epsilon", "tangent", facets, 0, 1, PROMISED},
    {"23", "smooth GGX, 100", "100 times that", "tangent", facets, 0, 100, PROMISED},
    {"23", "more than it gets", "Phong's highlight, e < 4", "midpoints", albedos, 0, 4, PROMISED},
    {"24", "lamp at 1e-2", "points of a wall of light", "formula", beside_lamps, 0, (real)1e-2,
     PROMISED},
    {"24", "lamp at 1e-4", "the same, nearer", "formula", beside_lamps, 0, (real)1e-4, PROMISED},
    {"25", "ten bounces", "furnaces of up to .99", "series", ten_bounces, 0, (real)0.99, PROMISED},
    {"25", "even directions", "500 paths, albedo .99", "series", furnaces, 0, (real)0.99, PROMISED},
    {"26", "clamp", "rare light, cut at 2", "formula", clamped, 0, 100, PROMISED},
    {"27", "plates of glass", "light to and fro, cut at 1/512", "sky of 1", plates, 6, (real)0.2,
     PROMISED},
    {"27", "walls, a point light", "light between walls, forgotten", "everything", rooms, 0,
     (real)0.5, PROMISED},
    {"27", "and a mirror", "one of the walls is one", "everything", rooms, 1, (real)0.5, PROMISED},
};

#endif
