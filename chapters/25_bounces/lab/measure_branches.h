/* measure_branches.h: why one direction is enough, and what asking the lamp is worth.
 *
 *   measure_branches(o)   main table: N directions a hit, error in equal time; with five bounces
 *                         also terms.h, and first.h's terms, each from a path of its own
 *
 * The truth is many samples of the reference (branch_trials.h), well spread: more than 30 times
 * closer than what is measured.
 */
#ifndef BOUNCES_MEASURE_BRANCHES_H
#define BOUNCES_MEASURE_BRANCHES_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../../common/parallel.h"
#include "branch_trials.h"
#include "furnace.h"

/* ---------------------------------------------------------------------------------------------- */

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
        exact += b->exact[trial_depth_index(trial)][k] / (double)b->pixels;
    }
    *rays = (double)asked / (double)square.n;
    return (estimate){square.n, square.mean / exact / exact, square.squares / pow(exact, 4)};
}

static inline void measure_branches(const options *o)
{
    branch_survey *b = allocate(1, sizeof *b);
    timed_trial timed[trials];
    double us[trials], one = 0;
    table t = table_new("Cornell box, N directions a hit: relative error (rms) of a sample, and in "
                        "the same time", "bounces|N|rays|error of a sample, -+ [1]|"
                        "time of a sample [us]|time: error over that of N = 1");
    trials_begin(b, o);
    parallel_whole(b->pixels, o->threads, "reference", trial_reference, b);
    parallel_whole(trial_first * b->pixels + 1, o->threads, "N directions", trial_job, b);
    for (int k = 0; k < trials; k++) timed[k] = (timed_trial){b, k, o->quick ? 500 : 3000, 0};
    bench_each(timed_run, timed, sizeof *timed, trials, o->quick ? 1 : o->full ? 15 : 5, 1e6, us);
    for (int k = 0; k < trials; k++) {
        double rays;
        estimate square = trial_square(b, k, &rays);
        double error = sqrt(square.mean), time = us[k] / timed[k].rays * rays;
        if (k < trial_terms && k % branch_kinds == 0) one = error * sqrt(time);
        table_count(&t, (size_t)trial_bounces(k));
        if (k < trial_terms) table_count(&t, (size_t)trial_branches(k));
        else table_text(&t, k == trial_first ? "first" : "terms");
        table_number(&t, rays);
        table_text(&t, "%.3g -+ %.1g", error, estimate_error(square) / (2 * error));
        table_number(&t, time), table_number(&t, error * sqrt(time) / one);
    }
    output_table(o, &t);
    trials_end(b), free(b);
}

#endif
