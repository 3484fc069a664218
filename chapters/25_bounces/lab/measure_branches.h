/* measure_branches.h: why one direction is enough.
 *
 *   measure_branches(o)   main table: N directions a hit, error in equal time; plot
 *
 * Two rooms. The Cornell box, directions as the surface reflects, pixels that do not see the light
 * itself; and first.h's box, by the terms of first.h, each by rays of its own, and by terms.h
 * (N = 0), which has all of them from one path. The truth is estimated by (25.10), some 100
 * times closer than what is measured.
 */
#ifndef BOUNCES_MEASURE_BRANCHES_H
#define BOUNCES_MEASURE_BRANCHES_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../../common/parallel.h"
#include "../../20_monte_carlo/estimate.h"
#include "../../24_direct_light/scenes/lit_cornell.h"
#include "../../24_direct_light/scenes/lit_first.h"
#include "../branching.h"
#include "../first.h"
#include "../terms.h"
#include "furnace.h"

typedef enum { ROOM_BOX, ROOM_FIRST, rooms } branch_room;
enum { branch_kinds = 4, trial_depths = 4, trial_side = 8, trial_pixels = trial_side * trial_side };
enum { most_trials = rooms * trial_depths * branch_kinds };
static const int trial_depth[trial_depths] = {1, 2, 3, 5};
static const char *const branch_name[branch_kinds] = {"N = 1", "N = 2", "N = 4", "N = 8"};

typedef struct {
    int room, d, N;
    double error, sure, rays, us;      /* of one sample; sure: standard error of `error` */
} branch_trial;
typedef struct { estimate square; bounce_counts c; } trial_part;
typedef struct {
    lit_scene scene[rooms];
    first_scene first;
    uint64_t seed;
    double budget;                     /* rays a pixel and trial, at least a sample */
    uint32_t many;                     /* samples a pixel of the reference */
    size_t pixels, stride;             /* used: 0, stride, 2 stride, ..; odd */
    double exact[rooms][trial_depths][trial_pixels];
    branch_trial trial[most_trials];   /* those of one room and depth together, N = 1 first */
    int trials;
    trial_part part[most_trials][trial_pixels];
} branch_survey;

/* ---------------------------------------------------------------------------------------------- */

/* Through the lower 5/8 of the box. */
static inline ray trial_ray(int room, size_t pixel, point2 u)
{
    real x = (real)(pixel % trial_side) + u.u, y = 3 + ((real)(pixel / trial_side) + u.v) * 5 / 8;
    if (room == ROOM_FIRST)
        return first_camera_ray(first_cornell_camera(trial_side, trial_side), x, y);
    return camera_ray(cornell_camera(1), x, y, trial_side, trial_side);
}

static inline double trial_all_rays(const bounce_counts *c)
{
    return (double)(naive_rays(&c->walk) + c->sight);
}

/* E + KE + .. + K^depth E by (25.10): sum[k], all of them by the same path. */
static inline void trial_lit(const branch_survey *b, int room, int depth, size_t pixel, sampler s,
                             double *sum, bounce_counts *c)
{
    naive_path p = {&b->scene[room], DIRECTIONS_BRDF, depth, false};
    vec3 term[8];
    ray eye = trial_ray(room, pixel, sampler_pair(&s));
    bounce_terms_lit(&p, eye, &s, term, c);
    sum[0] = (double)term[0].y;
    for (int k = 1; k <= depth; k++) sum[k] = sum[k - 1] + (double)term[k].y;
}

static inline void trial_reference(size_t job, void *context)
{
    branch_survey *b = context;
    size_t pixel = job % trial_pixels;
    int room = (int)(job / trial_pixels);
    bounce_counts c = {{{0}, 0, 0}, 0};
    double sum[8];
    for (uint32_t i = 0; i < b->many; i++) {
        sampler s = sampler_start(SEQUENCE_SOBOL, b->seed + 1, pixel, i, b->many);
        trial_lit(b, room, trial_depth[trial_depths - 1], pixel, s, sum, &c);
        for (int d = 0; d < trial_depths; d++)
            b->exact[room][d][pixel] += sum[trial_depth[d]] / b->many;
    }
}

/* Each term of first.h by rays of its own. It counts them in a variable that all threads share. */
static inline double trial_first(const branch_survey *b, const branch_trial *t, size_t pixel,
                                 uint64_t i, bounce_counts *c)
{
    random_stream random = random_start(b->seed, pixel, i);
    real u = random_next(&random), v = random_next(&random);
    ray eye = trial_ray(ROOM_FIRST, pixel, (point2){u, v});
    long before = first_bounce_rays;
    double sum = 0;
    for (int k = 0; k <= trial_depth[t->d]; k++)
        sum += (double)first_term(&b->first, eye, k, t->N, &random).y;
    c->sight += (size_t)(first_bounce_rays - before);
    return sum;
}

static inline double trial_sample(const branch_survey *b, const branch_trial *t, size_t pixel,
                                  uint64_t i, bounce_counts *c)
{
    double sum[8];
    int depth = trial_depth[t->d];
    if (t->N == 0) {
        sampler s = sampler_start(SEQUENCE_RANDOM, b->seed, pixel, (uint32_t)i, 1);
        trial_lit(b, t->room, depth, pixel, s, sum, c);
        return sum[depth];
    }
    if (t->room == ROOM_FIRST) return trial_first(b, t, pixel, i, c);
    naive_path p = {&b->scene[t->room], DIRECTIONS_BRDF, depth, false};
    ray eye = trial_ray(t->room, pixel, branching_pair(b->seed, pixel, i, 0));
    return (double)branching_radiance(&p, t->N, eye, b->seed, pixel, i, &c->walk).y;
}

/* If nothing escapes: (25.9); of first.h for each term; by (25.10) d on the way, d to the lamp. */
static inline double trial_rays_if_closed(const branch_trial *t)
{
    double rays = 0;
    int d = trial_depth[t->d];
    if (t->N == 0) return 2.0 * d;
    for (int k = t->room == ROOM_FIRST ? 0 : d; k <= d; k++)
        rays += first_rays_of_branching(t->N, k);
    return rays;
}

static inline void trial_run(branch_survey *b, int trial, size_t pixel)
{
    const branch_trial *t = &b->trial[trial];
    trial_part *part = &b->part[trial][pixel];
    double exact = b->exact[t->room][t->d][pixel], n = b->budget / trial_rays_if_closed(t);
    for (uint64_t i = 0; i == 0 || (double)i < n; i++) {
        double e = trial_sample(b, t, pixel, i, &part->c) - exact;
        part->square = estimate_add(part->square, e * e);
    }
}

/* The long ones (N = 8) first, so that the threads end together. */
static inline void trial_job(size_t job, void *context)
{
    branch_survey *b = context;
    int trial = b->trials - 1 - (int)(job / b->pixels);
    if (b->trial[trial].room != ROOM_FIRST) trial_run(b, trial, job % b->pixels * b->stride);
}

/* Over all pixels used. */
static inline void trial_result(const branch_survey *b, int trial, branch_trial *t)
{
    double rays = 0, exact = 0;
    estimate square = {0, 0, 0};
    for (size_t k = 0; k < b->pixels; k++) {
        const trial_part *p = &b->part[trial][k * b->stride];
        rays += trial_all_rays(&p->c), square = estimate_merge(square, p->square);
        exact += b->exact[t->room][t->d][k * b->stride];
    }
    t->rays = rays / (double)square.n;
    t->error = sqrt(square.mean) / exact * (double)b->pixels;
    t->sure = t->error * estimate_error(square) / (2 * square.mean);
}

typedef struct { const branch_survey *b; const branch_trial *t; double least, rays; } timed_trial;

/* Rays enough for the clock to see something. */
static inline double timed_run(void *context)
{
    timed_trial *t = context;
    bounce_counts c = {{{0}, 0, 0}, 0};
    double sum = 0;
    for (uint64_t i = 0; trial_all_rays(&c) < t->least; i++)
        sum += trial_sample(t->b, t->t, i % trial_pixels, i, &c);
    t->rays = trial_all_rays(&c);
    return sum;
}

/* Those of one room and depth in turn, from `first` on; the place of the next ones. */
static inline int trial_times(branch_survey *b, const options *o, int first)
{
    timed_trial t[branch_kinds];
    double seconds[branch_kinds];
    int n = 0;
    branch_trial *of = &b->trial[first];
    for (; first + n < b->trials && of[n].room == of->room && of[n].d == of->d; n++)
        t[n] = (timed_trial){b, &of[n], o->quick ? 500 : 3000, 0};
    bench_each(timed_run, t, sizeof *t, n, o->quick ? 1 : 15, 1e6, seconds);
    for (int i = 0; i < n; i++) of[i].us = seconds[i] / t[i].rays * of[i].rays;
    return first + n;
}

/* Without --full: the Cornell box with the fewest and the most bounces. */
static inline bool trial_wanted(const options *o, int room, int d)
{
    return o->full || (room == ROOM_BOX && (d == 0 || d == trial_depths - 1));
}

static inline void trial_list(branch_survey *b, const options *o)
{
    static const int of_room[] = {1, 2, 4, 8}, of_first[] = {1, 4, 0};
    for (int room = 0; room < rooms; room++)
        for (int d = 0; d < trial_depths; d++) {
            bool first = room == ROOM_FIRST;
            if (!trial_wanted(o, room, d) || (first && trial_depth[d] == 2)) continue;
            for (int k = 0; k < (first ? 3 : branch_kinds); k++)
                b->trial[b->trials++] = (branch_trial){room, d, first ? of_first[k] : of_room[k],
                                                       0, 0, 0, 0};
        }
}

static inline void branches_run(branch_survey *b, const options *o)
{
    lit_cornell(&b->scene[ROOM_BOX]);
    b->first = first_cornell(), lit_first(&b->first, &b->scene[ROOM_FIRST]);
    b->seed = o->seed, b->budget = o->quick ? 100 : 5000, b->many = o->quick ? 64 : 4096;
    b->pixels = o->quick ? 8 : trial_pixels, b->stride = o->quick ? 7 : 1;
    trial_list(b, o);
    parallel_whole((o->full ? rooms : 1) * trial_pixels, o->threads, "reference", trial_reference,
                   b);
    parallel_whole((size_t)b->trials * b->pixels, o->threads, "N directions", trial_job, b);
    for (int i = 0; i < b->trials; i++) {
        for (size_t k = 0; k < b->pixels && b->trial[i].room == ROOM_FIRST; k++)
            trial_run(b, i, k * b->stride);
        trial_result(b, i, &b->trial[i]);
    }
    for (int i = 0; i < b->trials;) i = trial_times(b, o, i);
    for (int room = 0; room < rooms; room++) lit_free(&b->scene[room]);
}

/* The box at the largest depth: from one sample on, k independent ones divide the error by sqrt k.
 */
static inline void plot_time(const options *o, const branch_survey *b)
{
    plot p = plot_new("Cornell box, 5 bounces: relative error against time", "time of a pixel [ms]",
                      "relative error", PLOT_LOG_X | PLOT_LOG_Y);
    const branch_trial *last = b->trial;
    while (last->room != ROOM_BOX || last->d != trial_depths - 1) last++;
    for (int n = 0; n < branch_kinds; n++) {
        plot_series(&p, branch_name[n]);
        for (double k = 1; k == 1 || k * last[n].us < 4e5; k *= 4)
            plot_add(&p, n, k * last[n].us / 1000, last[n].error / sqrt(k));
    }
    plot_slope(&p, -0.5, "slope -1/2");
    output_plot(o, &p, "25_bounces_time.svg");
}

/* Room, bounces, N, rays, error and time of a sample, error in 1 ms over that of N = 1 (`one`). */
static inline void trial_row(const branch_trial *a, const branch_trial *one, bool full, table *t)
{
    static const char *const name[rooms] = {"Cornell box", "first"};
    double in_time = a->error * sqrt(a->us / 1000);
    if (full) table_text(t, "%s", a->N ? name[a->room] : "first's box, terms.h");
    table_count(t, (size_t)trial_depth[a->d]), table_count(t, a->N ? (size_t)a->N : 1);
    if (full) table_count(t, (size_t)trial_rays_if_closed(a));
    table_number(t, a->rays), table_text(t, "%.3g -+ %.1g", a->error, a->sure);
    table_number(t, a->us);
    if (full) table_number(t, in_time);
    table_number(t, in_time / (one->error * sqrt(one->us / 1000)));
}

static inline void measure_branches(const options *o)
{
    branch_survey *b = allocate(1, sizeof *b);
    table t = table_new("Cornell box, N directions a hit: relative error (rms) of a sample, and in "
                        "the same time", "bounces|N|rays|error of a sample, -+ [1]|"
                        "time of a sample [us]|time: error over that of N = 1");
    table all = table_new("N directions a hit: relative error (rms) of a sample, and in 1 ms",
                          "room|bounces|N|rays if closed|rays|error of a sample, -+ [1]|"
                          "time of a sample [us]|time: error in 1 ms [1]|"
                          "time: error over that of N = 1");
    options brief = *o;
    brief.full = false;
    branches_run(b, o);
    const branch_trial *one = b->trial;
    for (const branch_trial *a = b->trial; a < b->trial + b->trials; a++) {
        if (a->room != one->room || a->d != one->d) one = a;
        if (trial_wanted(&brief, a->room, a->d)) trial_row(a, one, false, &t);
        if (o->full) trial_row(a, one, true, &all);
    }
    output_table(o, &t);
    if (o->full) output_extra_table(o, &all), plot_time(o, b);
    else table_free(&all);
    free(b);
}

#endif
