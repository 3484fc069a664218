/* measure_first.h: what the terms of first.h cost, in its own box.
 *
 *   first_rows(o, &t)        rows of the main table: the sum of first.h's terms up to K^d E, and
 *                            beside it terms.h, which has all of them from one path
 *
 * The box of first.h has walls of parallelograms: the truth is that of terms.h in the same box. The
 * same pixels, errors and times as in measure_branches.h.
 */
#ifndef BOUNCES_MEASURE_FIRST_H
#define BOUNCES_MEASURE_FIRST_H

#include "../../../common/clock.h"
#include "../../../common/lab/report.h"
#include "../../../common/parallel.h"
#include "../../24_direct_light/scenes/lit_first.h"
#include "../first.h"
#include "../terms.h"

enum { first_side = 8, first_pixels = first_side * first_side };
enum { first_depths = 3, first_kinds = 3, first_trials = first_depths * first_kinds };
typedef struct {
    first_scene s;
    lit_scene full;
    uint64_t seed;
    double exact[first_pixels][first_depths];
} first_room;
typedef struct { const first_room *room; int d, N; size_t samples; double rays; } first_trial;

/* ---------------------------------------------------------------------------------------------- */

static const int first_depth[first_depths] = {1, 3, 5};
static const int first_N[first_kinds] = {1, 4, 0};  /* 0: by terms.h */

/* As trial_ray: the lower 5/8 of the picture. */
static inline ray first_trial_ray(size_t pixel, point2 u)
{
    real x = (real)(pixel % first_side) + u.u, y = (real)(pixel / first_side) + u.v;
    return first_camera_ray(first_cornell_camera(first_side, first_side), x,
                            3 + y * 5 / first_side);
}

static inline double first_all_terms(const first_trial *t, size_t pixel, uint64_t i)
{
    double sum = 0;
    random_stream random = random_start(t->room->seed, pixel, i);
    real u = random_next(&random), v = random_next(&random);
    for (int k = 0; k <= t->d; k++)
        sum += (double)first_term(&t->room->s, first_trial_ray(pixel, (point2){u, v}), k, t->N,
                                  &random).y;
    return sum;
}

static inline double first_lit_terms(const first_trial *t, size_t pixel, sampler q, double *rays)
{
    naive_path p = {&t->room->full, DIRECTIONS_BRDF, t->d, false};
    bounce_counts c = {{{0}, 0, 0}, 0};
    vec3 term[8];
    double sum = 0;
    ray eye = first_trial_ray(pixel, sampler_pair(&q));
    bounce_terms_lit(&p, eye, &q, term, &c);
    for (int k = 0; k <= t->d; k++) sum += (double)term[k].y;
    *rays += (double)(naive_rays(&c.walk) + c.sight);
    return sum;
}

static inline double first_trial_sample(first_trial *t, size_t pixel, uint64_t i)
{
    if (t->N == 0)
        return first_lit_terms(t, pixel, sampler_start(SEQUENCE_RANDOM, t->room->seed, pixel,
                                                       (uint32_t)i, 1), &t->rays);
    long before = first_bounce_rays;
    double sum = first_all_terms(t, pixel, i);
    t->rays += (double)(first_bounce_rays - before);
    return sum;
}

static inline void first_reference(size_t pixel, void *context)
{
    first_room *r = context;
    uint32_t many = 4096;
    for (int j = 0; j < first_depths; j++) {
        first_trial t = {r, first_depth[j], 0, 0, 0};
        for (uint32_t i = 0; i < many; i++) {
            sampler q = sampler_start(SEQUENCE_SOBOL, r->seed + 1, pixel, i, many);
            r->exact[pixel][j] += first_lit_terms(&t, pixel, q, &t.rays) / many;
        }
    }
}

static inline double first_timed(void *context)
{
    first_trial *t = context;
    double sum = 0;
    for (uint64_t i = 0; i < t->samples; i++) sum += first_trial_sample(t, i % first_pixels, i);
    return sum;
}

/* rms over pixels and samples, over the mean of the picture. */
static inline double first_trial_error(first_trial *t, int j, uint64_t samples)
{
    double square = 0, mean = 0;
    for (size_t pixel = 0; pixel < first_pixels; pixel++) {
        double exact = t->room->exact[pixel][j];
        mean += exact / first_pixels;
        for (uint64_t i = 0; i < samples; i++) {
            double e = first_trial_sample(t, pixel, i) - exact;
            square += e * e / (double)(samples * first_pixels);
        }
    }
    t->rays /= (double)(samples * first_pixels);
    return sqrt(square) / mean;
}

/* In a closed room: of first.h (25.9) for each term; of terms.h d on the way, and d to the lamp. */
static inline double first_rays_if_closed(int N, int d)
{
    double rays = 0;
    for (int k = 0; k <= d; k++) rays += N ? first_rays_of_branching(N, k) : 0;
    return N ? rays : 2.0 * d;
}

static inline void first_row(table *t, const first_trial *a, double error, double us, double one)
{
    table_text(t, a->N ? "first" : "first's box, terms.h"), table_count(t, (size_t)a->d);
    table_count(t, a->N ? (size_t)a->N : 1);
    table_count(t, (size_t)first_rays_if_closed(a->N, a->d)), table_number(t, a->rays);
    table_number(t, error), table_number(t, us);
    table_number(t, error * sqrt(us / 1000)), table_number(t, error * sqrt(us / 1000) / one);
}

static inline void first_rows(const options *o, table *t)
{
    static first_room room;
    first_trial trial[first_trials], timed[first_trials];
    clock_variant v[first_trials];
    double error[first_trials], one = 1;
    room = (first_room){.s = first_cornell(), .seed = o->seed};
    lit_first(&room.s, &room.full);
    parallel_for(first_pixels, o->threads, "reference", first_reference, &room);
    for (int i = 0; i < first_trials; i++) {
        int j = i / first_kinds, N = first_N[i % first_kinds], d = first_depth[j];
        trial[i] = (first_trial){&room, d, N, 0, 0};
        double rays = first_rays_if_closed(N, d), samples = (o->quick ? 50 : 5000) / rays;
        error[i] = first_trial_error(&trial[i], j, samples < 1 ? 1 : (uint64_t)samples);
        timed[i] = trial[i];
        timed[i].samples = 1 + (size_t)((o->quick ? 500 : 6000) / trial[i].rays);
        v[i] = (clock_variant){"", first_timed, &timed[i], 0};
    }
    clock_compare(v, first_trials, o->quick ? 1 : 15);
    for (int i = 0; i < first_trials; i++) {
        double us = v[i].seconds / (double)timed[i].samples * 1e6;
        if (i % first_kinds == 0) one = error[i] * sqrt(us / 1000);
        first_row(t, &trial[i], error[i], us, one);
    }
    lit_free(&room.full);
}

#endif
