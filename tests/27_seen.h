/* 27_seen.h: scenes of chapter 27 from texts, and what is seen along rays.
 *
 *   main as in 27_files.h
 *   set q; set_up(&q, text); .. tear_down(&q);         a scene, its plan, its stage
 *   dice d = dice_start(seed, pixel, k)                dice_sample of one alone: the same numbers
 *   vec3 L = seen_along(&q, r)                         one throw of the dice, from where r begins;
 *                                                      without integrals none: cut at 1/512
 *   test_same(what, one, other)                        two scenes without chance are one picture
 *   test_way(text, z, exponent)                        the light left along -z
 *   along(&e, n, estimates)                            n throws, through the middle of the picture
 *   estimate m = mean_along(&q, r, seed, n)            of a colour's channels together, along r
 *   estimate m = mean_of_26(&q, background, r, n)      the same by 26
 *   double p = likely_alike(m, other)                  the probability that both are one light
 *   expect(what, text, exact, rounding, mask)          their mean is exact; mask 0: of the plan
 *   expect_of(n, what, ..)                             of n throws
 */
#ifndef SEEN_27_H
#define SEEN_27_H

#include "27_files.h"
#include "../chapters/27_effects/lab/tax.h"
#include "../common/lab/t_test.h"

/* ---------------------------------------------------------------------------------------------- */

typedef effects_ready set;

static inline void set_up(set *q, const char *text)
{
    failure f;
    if (!studio_read_text(text, "test.scene", NULL, &q->s, &f)) fail(f);
    if (!effects_get_ready(q, 4 / (real)3, &f)) fail(f);
}

static inline void tear_down(set *q) { effects_ready_free(q); }

static inline double some(random_stream *r, double lowest, double highest)
{
    return lowest + (highest - lowest) * (double)random_next(r);
}

static inline dice dice_start(uint64_t seed, uint64_t pixel, uint32_t k)
{
    const uint64_t half = 2 * pixel + k % 2;
    return (dice){sampler_start(SEQUENCE_SOBOL, seed, half, k / 2, 1u << 31),
                  random_start(seed, half, k / 2).key};
}

static inline vec3 seen_along(set *q, ray r)
{
    if (!q->e.chance) effects_stage_cut(&q->e, (real)1 / 512);
    dice d = dice_start(1, 1, 0);
    effects_counts c = {.lost = 0};
    return effects_alone(effects_made_for(q->e.mask), &q->e, r, bodies_around(&q->e, r.o, NULL), &d,
                         &c);
}

/* A wall in the sun, looked at past what follows; glass and water. */
#define ABOVE "camera from 1.5 1.7 5 at 0 0.6 0 angle 32\nindirect off\n"                        \
    "background 0.3 0.5 0.8\nsun to 1 2 3 colour 2\nmaterial wall\nKd 0.8 0.4 0.1\nillum 1\n"   \
    "polygon -4 0 -3  4 0 -3  4 0.9 -3  -4 0.9 -3\n"
#define GLASS "material glass\nKd 0\nNi 1.5\nabsorb 0.3 0.1 0.2\nillum 7\n"
#define WATER "material water\nKd 0\nNi 1.33\nabsorb 0.1 0.4 0.1\nillum 7\n"

/* Two scenes are one picture: to rounding, which moves the edge of what lies behind by less than a
 * pixel in ten thousand. */
static inline void test_same(const char *what, const char *one, const char *other)
{
    enum { w = 40, h = 30 };
    set a, b;
    size_t off = 0;
    set_up(&a, one), set_up(&b, other);
    for (int i = 0; i < w * h; i++) {
        ray r = camera_ray(a.e.eye, (real)(i % w) + (real)0.37, (real)(i / w) + (real)0.41, w, h);
        real far = vlength(vsub(seen_along(&a, r), seen_along(&b, r)));
        off += !(far <= 4096 * real_epsilon);
    }
    check_at_most((double)off, sizeof(real) == 4 ? 4 : 0, "%s: rays that differ", what);
    tear_down(&a), tear_down(&b);
}

/* Along an axis, with Ni 1, light is weakened by exp(-sum of absorb x length), and nothing else. */
static inline void test_way(const char *text, real z, double exponent)
{
    set q;
    set_up(&q, text);
    ray r = {.o = {0, 0, z}, .d = {0, 0, -1}, .tmin = 0, .tmax = real_infinity};
    check_close((double)seen_along(&q, r).x, exp(-exponent), 64 * (double)real_epsilon, "%s", text);
    tear_down(&q);
}

/* The mean along the ray through the middle of the picture, of n independent estimates. */
static inline void along(const effects_stage *e, size_t n, estimate out[3])
{
    effects_function *f = effects_made_for(e->mask);
    for (int k = 0; k < 3; k++) out[k] = (estimate){0};
    for (size_t i = 0; i < n; i++) {
        dice d = dice_start(9, i, 0);
        effects_counts c = {.lost = 0};
        ray r = camera_ray(e->eye, 8, 6, 16, 12);
        vec3 L = effects_alone(f, e, r, bodies_around(e, r.o, NULL), &d, &c);
        for (int k = 0; k < 3; k++) out[k] = estimate_add(out[k], (double)vaxis(L, k));
    }
}

static inline void expect_of(size_t n, const char *what, const char *text, const double exact[3],
                             double rounding, unsigned mask)
{
    set q;
    estimate e[3];
    set_up(&q, text);
    if (mask) effects_stage_effects(&q.e, mask);
    along(&q.e, n, e);
    for (int k = 0; k < 3; k++)  /* false alarms: 1e-7 each, 12 of them */
        check_at_least(t_test(e[k], exact[k], rounding * (double)real_epsilon), 1e-7,
                       "%s, channel %d: mean %.9g, exactly %.9g", what, k, e[k].mean, exact[k]);
    tear_down(&q);
}

static inline void expect(const char *what, const char *text, const double exact[3],
                          double rounding, unsigned mask)
{
    expect_of(check_count(20000), what, text, exact, rounding, mask);
}

/* The mean along a ray, by the dice of that seed. */
static inline estimate mean_along(const set *q, ray r, uint64_t seed, size_t n)
{
    effects_function *f = effects_made_for(q->e.mask);
    media_set in = bodies_around(&q->e, r.o, NULL);
    effects_counts c = {.lost = 0};
    estimate m = {0};
    size_t bad = 0;
    for (size_t i = 0; i < n; i++) {
        dice d = dice_start(seed, i, 0);
        vec3 L = effects_alone(f, &q->e, r, in, &d, &c);
        bad += !(vfinite(L) && L.x >= 0 && L.y >= 0 && L.z >= 0);
        m = estimate_add(m, (double)(L.x + 2 * L.y + 4 * L.z) / 7);
    }
    check_equal(bad, 0, "of %zu, those that are no light", n);
    return m;
}

/* The probability that two means of the same light are so far apart. */
static inline double likely_alike(estimate x, estimate y)
{
    double a = estimate_error(x), b = estimate_error(y), error = sqrt(a * a + b * b);
    double off = fabs(x.mean - y.mean) - 4096 * (double)real_epsilon;
    return off <= 0 ? 1 : error > 0 ? erfc(off / error / sqrt(2.)) : 0;
}

/* 26's, of all that shines of a scene behind which is that. */
static inline estimate mean_of_26(const set *q, real background, ray r, size_t n)
{
    lit_scene lit;
    path_tracer t;
    path_counts c = {0};
    estimate m = {0};
    classic_lit(&q->s, &lit);
    lit.background = (vec3){background, background, background};
    path_tracer_of(&lit, NULL, path_defaults, &t);
    for (size_t i = 0; i < n; i++) {
        path_random own = path_start(&t.how, 8, i, 0, 1);
        vec3 L = path_radiance(&t, r, &own, &c);
        m = estimate_add(m, (double)(L.x + 2 * L.y + 4 * L.z) / 7);
    }
    path_tracer_free(&t), lit_free(&lit);
    return m;
}

#endif
