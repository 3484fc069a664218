/* measure_branches.h: why one direction is enough.
 *
 *   measure_branches(o)   main table: N directions a hit, error in equal time
 *
 * The Cornell box, directions as the surface reflects, pixels that do not see the light itself. The
 * truth is estimated by (25.10), some 100 times closer than what is measured.
 */
#ifndef BOUNCES_MEASURE_BRANCHES_H
#define BOUNCES_MEASURE_BRANCHES_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../../common/parallel.h"
#include "../../../common/numbers/estimate.h"
#include "../../24_direct_light/scenes/lit_cornell.h"
#include "../branching.h"
#include "../terms.h"
#include "furnace.h"

enum { branch_kinds = 4, trial_depths = 2, trials = trial_depths * branch_kinds };
enum { trial_side = 8, trial_pixels = trial_side * trial_side };
static const int trial_depth[trial_depths] = {1, 5};

typedef struct { estimate square; naive_counts c; } trial_part;
typedef struct {
    lit_scene scene;
    uint64_t seed;
    double budget;                     /* rays a pixel and trial, at least a sample */
    uint32_t many;                     /* samples a pixel of the reference */
    size_t pixels;                     /* of trial_pixels the first */
    double exact[trial_depths][trial_pixels];
    trial_part part[trials][trial_pixels];
} branch_survey;

/* ---------------------------------------------------------------------------------------------- */

/* Trial k: */
static inline int trial_bounces(int k) { return trial_depth[k / branch_kinds]; }
static inline int trial_branches(int k) { return 1 << k % branch_kinds; }

/* Through the lower 5/8 of the box. */
static inline ray trial_ray(size_t pixel, point2 u)
{
    real x = (real)(pixel % trial_side) + u.u, y = 3 + ((real)(pixel / trial_side) + u.v) * 5 / 8;
    return camera_ray(cornell_camera(1), x, y, trial_side, trial_side);
}

/* E + KE + .. + K^depth E by (25.10). */
static inline void trial_reference(size_t pixel, void *context)
{
    branch_survey *b = context;
    bounce_counts c = {.direct = {0, 0, 0}};
    naive_path p = {&b->scene, DIRECTIONS_BRDF, trial_depth[trial_depths - 1], false};
    vec3 term[8];
    for (uint32_t i = 0; i < b->many; i++) {
        sampler s = sampler_start(SEQUENCE_SOBOL, b->seed + 1, pixel, i, b->many);
        ray eye = trial_ray(pixel, sampler_pair(&s));
        bounce_terms_lit(&p, eye, &s, term, &c);
        double sum = 0;
        for (int d = 0, k = 0; d < trial_depths; d++) {
            for (; k <= trial_depth[d]; k++) sum += (double)term[k].y;
            b->exact[d][pixel] += sum / b->many;
        }
    }
}

static inline double trial_sample(const branch_survey *b, int trial, size_t pixel, uint64_t i,
                                  naive_counts *c)
{
    naive_path p = {&b->scene, DIRECTIONS_BRDF, trial_bounces(trial), false};
    ray eye = trial_ray(pixel, branching_pair(b->seed, pixel, i, 0));
    return (double)branching_radiance(&p, trial_branches(trial), eye, b->seed, pixel, i, c).y;
}

/* The long ones (N = 8) first, so that the threads end together. */
static inline void trial_job(size_t job, void *context)
{
    branch_survey *b = context;
    int trial = trials - 1 - (int)(job / b->pixels);
    size_t pixel = job % b->pixels;
    trial_part *part = &b->part[trial][pixel];
    double exact = b->exact[trial / branch_kinds][pixel];
    double n = b->budget / first_rays_of_branching(trial_branches(trial), trial_bounces(trial));
    for (uint64_t i = 0; i == 0 || (double)i < n; i++) {
        double e = trial_sample(b, trial, pixel, i, &part->c) - exact;
        part->square = estimate_add(part->square, e * e);
    }
}

typedef struct { const branch_survey *b; int trial; double least, rays; } timed_trial;

/* Rays enough for the clock to see something. */
static inline double timed_run(void *context)
{
    timed_trial *t = context;
    naive_counts c = {{0}, 0, 0};
    double sum = 0;
    for (uint64_t i = 0; (double)naive_rays(&c) < t->least; i++)
        sum += trial_sample(t->b, t->trial, i % t->b->pixels, i, &c);
    t->rays = (double)naive_rays(&c);
    return sum;
}

/* Of one sample; sure: standard error of `error`. */
typedef struct { double error, sure, rays, us; } branch_result;

/* All but the time. */
static inline branch_result trial_result(const branch_survey *b, int trial)
{
    double rays = 0, exact = 0;
    estimate square = {0, 0, 0};
    for (size_t k = 0; k < b->pixels; k++) {
        const trial_part *p = &b->part[trial][k];
        rays += (double)naive_rays(&p->c), square = estimate_merge(square, p->square);
        exact += b->exact[trial / branch_kinds][k];
    }
    double error = sqrt(square.mean) / exact * (double)b->pixels;
    return (branch_result){error, error * estimate_error(square) / (2 * square.mean),
                           rays / (double)square.n, 0};
}

static inline void measure_branches(const options *o)
{
    branch_survey *b = allocate(1, sizeof *b);
    timed_trial timed[trials];
    branch_result r[trials];
    double us[trials];
    table t = table_new("Cornell box, N directions a hit: relative error (rms) of a sample, and in "
                        "the same time", "bounces|N|rays|error of a sample, -+ [1]|"
                        "time of a sample [us]|time: error over that of N = 1");
    lit_cornell(&b->scene);
    b->seed = o->seed, b->budget = o->quick ? 100 : 5000, b->many = o->quick ? 64 : 4096;
    b->pixels = o->quick ? 4 : trial_pixels;
    parallel_whole(b->pixels, o->threads, "reference", trial_reference, b);
    parallel_whole(trials * b->pixels, o->threads, "N directions", trial_job, b);
    for (int k = 0; k < trials; k++) timed[k] = (timed_trial){b, k, o->quick ? 500 : 3000, 0};
    bench_each(timed_run, timed, sizeof *timed, trials, o->quick ? 1 : o->full ? 15 : 5, 1e6, us);
    for (int k = 0; k < trials; k++) {
        r[k] = trial_result(b, k);
        r[k].us = us[k] / timed[k].rays * r[k].rays;
        const branch_result *one = &r[k - k % branch_kinds];
        table_count(&t, (size_t)trial_bounces(k)), table_count(&t, (size_t)trial_branches(k));
        table_number(&t, r[k].rays), table_text(&t, "%.3g -+ %.1g", r[k].error, r[k].sure);
        table_number(&t, r[k].us);
        table_number(&t, r[k].error * sqrt(r[k].us) / (one->error * sqrt(one->us)));
    }
    output_table(o, &t);
    lit_free(&b->scene), free(b);
}

#endif
