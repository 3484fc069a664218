/* measure_branches.h: why one direction is enough, and what asking the lamp is worth.
 *
 *   measure_branches(o)   main table: samples by N directions a hit, by terms.h and by first.h, of
 *                         the same light; error in equal time
 *
 *   branch_survey *b = allocate(1, sizeof *b);
 *   trials_begin(b, &o);
 *   double x = trial_sample(b, k, pixel, i, &counts);   sample i of trial k, green; counts: {0}
 *   trial_truth(b, pixel, &sampler, sum);               one of the reference
 *   trials_end(b);
 *
 * The box is first.h's, without leaning walls, so that all are asked about the same light, along
 * the same eye rays; directions as the surface reflects, pixels that do not see the light itself.
 * Of terms.h and first.h the sum is taken, as their programs do; first.h's terms have each a path
 * of its own. The reference: paths that at each hit ask the lamp by its angle (24.5), many and well
 * spread: more than 30 times closer than what is measured. With branching.h and terms.h it shares
 * the walk alone, with first.h nothing.
 */
#ifndef BOUNCES_MEASURE_BRANCHES_H
#define BOUNCES_MEASURE_BRANCHES_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../../common/numbers/estimate.h"
#include "../../../common/parallel.h"
#include "../../24_direct_light/scenes/lit_first.h"
#include "../branching.h"
#include "../terms.h"

enum { trial_terms = 6, trial_first, trials };  /* the last two: by terms.h and by first.h */
enum { trial_side = 8, trial_pixels = trial_side * trial_side, trial_depths = 2 };
static const int trial_depth[trial_depths] = {1, 5};
static const struct { int depth, N; } trial_row[trials] = {  /* which depth; directions a hit */
    {0, 1}, {0, 8}, {1, 1}, {1, 2}, {1, 4}, {1, 8}, {1, 1}, {1, 1}};

/* first: the rays that first.h counts, some of which it does not send, as the lamp is behind. */
typedef struct { bounce_counts c; size_t first; } trial_counts;
typedef struct { estimate square; trial_counts work; } trial_part;
typedef struct {
    first_scene first;
    lit_scene scene;                   /* the same */
    lit_lights lamps;
    camera view;
    uint64_t seed;
    double budget;                     /* rays a pixel and trial, at least a sample */
    uint32_t many;                     /* samples a pixel of the reference */
    size_t pixels;                     /* of trial_pixels the first */
    double exact[trial_depths][trial_pixels];
    trial_part part[trials][trial_pixels];
} branch_survey;

/* ---------------------------------------------------------------------------------------------- */

static inline int trial_bounces(int k) { return trial_depth[trial_row[k].depth]; }

/* Of a sample, where nothing escapes: (25.9); first.h's term k has a path of k + 1 rays. */
static inline double trial_most_rays(int k)
{
    int d = trial_bounces(k);
    return k == trial_first ? (d + 1) * (d + 2) / 2 : first_rays_of_branching(trial_row[k].N, d);
}

static inline size_t trial_rays_asked(const trial_counts *w)
{
    return naive_rays(&w->c.walk) + w->c.direct.shadow + w->first;
}

static inline void trials_begin(branch_survey *b, const options *o)
{
    *b = (branch_survey){.first = first_cornell(), .view = lit_first_camera(), .seed = o->seed};
    b->budget = o->quick ? 100 : 5000, b->many = o->quick ? 64 : 2048;
    b->pixels = o->quick ? 4 : trial_pixels;
    lit_first(&b->first, &b->scene);
    lit_lights_of(&b->scene, NULL, LIGHTS_ALL, &b->lamps);
}

static inline void trials_end(branch_survey *b) { lit_lights_free(&b->lamps), lit_free(&b->scene); }

/* Through the lower 5/8 of the box. */
static inline ray trial_ray(const branch_survey *b, size_t pixel, point2 u)
{
    real x = (real)(pixel % trial_side) + u.u, y = 3 + ((real)(pixel / trial_side) + u.v) * 5 / 8;
    return camera_ray(b->view, x, y, trial_side, trial_side);
}

/* sum[j]: a sample of E + KE + .. + K^trial_depth[j] E. */
static inline void trial_truth(const branch_survey *b, size_t pixel, sampler *s, double *sum)
{
    const int most = trial_depth[trial_depths - 1];
    trial_counts w = {.first = 0};
    naive_path p = {&b->scene, DIRECTIONS_BRDF, most, false};
    direct d = {&b->scene, DIRECT_ANGLE, &b->lamps, &w.c.direct, false};
    vec3 through = {1, 1, 1}, weight;
    ray r = trial_ray(b, pixel, sampler_pair(s));
    bool met;
    lit_hit x;
    for (int j = 0; j < trial_depths; j++) sum[j] = 0;
    for (int k = 0; k < most; k++) {
        vec3 Le = naive_find(&p, r, k, &x, &met, &w.c.walk), wo = vneg(vunit(r.d));
        if (!met) return;
        vec3 L = vmul(through, direct_light(&d, &x, wo, s));
        if (k == 0) L = vadd(L, Le);
        for (int j = 0; j < trial_depths; j++) sum[j] += k < trial_depth[j] ? (double)L.y : 0;
        if (!naive_direction(&p, &x, wo, sampler_pair(s), &r, &weight)) return;
        through = vmul(through, weight);
    }
}

static inline void trial_reference(size_t pixel, void *context)
{
    branch_survey *b = context;
    double sum[trial_depths];
    for (uint32_t i = 0; i < b->many; i++) {
        sampler s = sampler_start(SEQUENCE_SOBOL, b->seed + 1, pixel, i, b->many);
        trial_truth(b, pixel, &s, sum);
        for (int j = 0; j < trial_depths; j++) b->exact[j][pixel] += sum[j] / b->many;
    }
}

/* The terms of first.h, as first.c adds them, each with 16 numbers behind the two of the eye ray.
 * One thread at a time: it counts its rays itself. */
static inline double trial_by_first(const branch_survey *b, ray eye, size_t pixel, uint64_t i,
                                    trial_counts *w)
{
    vec3 L = {0, 0, 0};
    long before = first_bounce_rays;
    for (int k = 0; k <= trial_bounces(trial_first); k++) {
        random_stream random = random_start(b->seed, pixel, i);
        random.dimension = 16 * (uint64_t)k + 2;
        L = vadd(L, first_term(&b->first, eye, k, 1, &random));
    }
    w->first += (size_t)(first_bounce_rays - before);
    return (double)L.y;
}

static inline double trial_by_terms(const branch_survey *b, size_t pixel, uint64_t i,
                                    trial_counts *w)
{
    naive_path p = {&b->scene, DIRECTIONS_BRDF, trial_bounces(trial_terms), false};
    vec3 term[naive_depths], L = {0, 0, 0};
    sampler s = sampler_start(SEQUENCE_RANDOM, b->seed, pixel, (uint32_t)i, 1);
    ray eye = trial_ray(b, pixel, sampler_pair(&s));
    bounce_terms_lit(&p, eye, &s, term, &w->c);
    for (int k = 0; k <= p.depth; k++) L = vadd(L, term[k]);
    return (double)L.y;
}

static inline double trial_sample(const branch_survey *b, int trial, size_t pixel, uint64_t i,
                                  trial_counts *w)
{
    naive_path p = {&b->scene, DIRECTIONS_BRDF, trial_bounces(trial), false};
    if (trial == trial_terms) return trial_by_terms(b, pixel, i, w);
    ray eye = trial_ray(b, pixel, branching_pair(b->seed, pixel, i, 0));
    if (trial == trial_first) return trial_by_first(b, eye, pixel, i, w);
    return (double)branching_radiance(&p, trial_row[trial].N, eye, b->seed, pixel, i,
                                      &w->c.walk).y;
}

static inline void trial_run(branch_survey *b, int trial, size_t pixel)
{
    trial_part *part = &b->part[trial][pixel];
    double exact = b->exact[trial_row[trial].depth][pixel];
    double n = b->budget / trial_most_rays(trial);
    for (uint64_t i = 0; i == 0 || (double)i < n; i++) {
        double e = trial_sample(b, trial, pixel, i, &part->work) - exact;
        part->square = estimate_add(part->square, e * e);
    }
}

/* ---- the table ---- */

/* The first job is all of first.h's; then the long ones (N = 8) first, so that the threads end
 * together. */
static inline void trial_job(size_t job, void *context)
{
    branch_survey *b = context;
    if (job) trial_run(b, trial_first - 1 - (int)((job - 1) / b->pixels), (job - 1) % b->pixels);
    for (size_t pixel = 0; job == 0 && pixel < b->pixels; pixel++) trial_run(b, trial_first, pixel);
}

typedef struct { const branch_survey *b; int trial; double least, rays; } timed_trial;

/* Rays enough for the clock to see something. */
static inline double timed_run(void *context)
{
    timed_trial *t = context;
    trial_counts w = {.first = 0};
    double sum = 0;
    for (uint64_t i = 0; (double)trial_rays_asked(&w) < t->least; i++)
        sum += trial_sample(t->b, t->trial, i % t->b->pixels, i, &w);
    t->rays = (double)trial_rays_asked(&w);
    return sum;
}

/* Squared errors of all samples, relative to the mean truth squared; *rays of one. */
static inline estimate trial_square(const branch_survey *b, int trial, double *rays)
{
    size_t asked = 0;
    double exact = 0;
    estimate square = {0, 0, 0};
    for (size_t k = 0; k < b->pixels; k++) {
        asked += trial_rays_asked(&b->part[trial][k].work);
        square = estimate_merge(square, b->part[trial][k].square);
        exact += b->exact[trial_row[trial].depth][k] / (double)b->pixels;
    }
    *rays = (double)asked / (double)square.n;
    return (estimate){square.n, square.mean / exact / exact, square.squares / pow(exact, 4)};
}

typedef struct { double rays, error, off, time; } trial_result;  /* of a sample; off: -+ error */

/* Error in the same time, in some unit. */
static inline double trial_dear(const trial_result *r) { return r->error * sqrt(r->time); }

/* Beside N = 1 of as many bounces. */
static inline void branches_table(const options *o, const trial_result *r)
{
    table t = table_new("Cornell box, N directions a hit: relative error (rms) of a sample, and in "
                        "the same time",
                        "bounces|N|rays|error of a sample, -+ [1]|time of a sample [us]|"
                        "time: error over that of N = 1");
    for (int k = 0, one = 0; k < trials; k++) {
        if (trial_row[k].N == 1 && k < trial_terms) one = k;
        table_count(&t, (size_t)trial_bounces(k));
        if (k < trial_terms) table_count(&t, (size_t)trial_row[k].N);
        else table_text(&t, k == trial_first ? "first" : "terms");
        table_number(&t, r[k].rays);
        table_text(&t, "%.3g -+ %.1g", r[k].error, r[k].off), table_number(&t, r[k].time);
        table_number(&t, trial_dear(&r[k]) / trial_dear(&r[one]));
    }
    output_table(o, &t);
}

static inline void measure_branches(const options *o)
{
    branch_survey *b = allocate(1, sizeof *b);
    timed_trial timed[trials];
    trial_result r[trials];
    double us[trials];
    trials_begin(b, o);
    parallel_whole(b->pixels, o->threads, "reference", trial_reference, b);
    parallel_whole(trial_first * b->pixels + 1, o->threads, "N directions", trial_job, b);
    for (int k = 0; k < trials; k++) timed[k] = (timed_trial){b, k, o->quick ? 500 : 3000, 0};
    bench_each(timed_run, timed, sizeof *timed, trials, o->quick ? 1 : o->full ? 15 : 5, 1e6, us);
    for (int k = 0; k < trials; k++) {
        estimate square = trial_square(b, k, &r[k].rays);
        r[k].error = sqrt(square.mean), r[k].off = estimate_error(square) / (2 * r[k].error);
        r[k].time = us[k] / timed[k].rays * r[k].rays;
    }
    branches_table(o, r);
    trials_end(b), free(b);
}

#endif
