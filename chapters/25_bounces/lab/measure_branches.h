/* measure_branches.h: why one direction is enough.
 *
 *   measure_branches(o)   main table: N directions a hit, error in equal time; plots
 *   measure_rays(o)       rays against depth in a closed and in an open room; plot
 *
 * Two rooms. Two spheres, one in the other (furnace.h), uniform directions: the truth is a linear
 * system's. The Cornell box, directions as the surface reflects, pixels that do not see the light
 * itself: the truth is estimated by (25.10), some 100 times closer than what is measured.
 */
#ifndef BOUNCES_MEASURE_BRANCHES_H
#define BOUNCES_MEASURE_BRANCHES_H

#include "../../../common/clock.h"
#include "../../../common/lab/report.h"
#include "../../../common/parallel.h"
#include "../../20_monte_carlo/estimate.h"
#include "../../24_direct_light/scenes/lit_cornell.h"
#include "../branching.h"
#include "furnace.h"
#include "measure_first.h"
#include "../terms.h"

enum { branch_kinds = 4, rooms = 2, trial_depths = 4, trial_side = 8 };
enum { trial_pixels = trial_side * trial_side, trials = rooms * trial_depths * branch_kinds };
static const int trial_depth[trial_depths] = {1, 2, 3, 5};
static const char *const room_name[rooms] = {"two spheres", "Cornell box"};
static const char *const branch_name[branch_kinds] = {"N = 1", "N = 2", "N = 4", "N = 8"};

typedef struct { estimate square; naive_counts c; } trial_part;
typedef struct {
    lit_scene scene[rooms];
    uint64_t seed;
    double budget;                                   /* rays a pixel and trial, at least a sample */
    uint32_t many;                                   /* samples a pixel of the reference */
    size_t pixels, stride;                           /* used: 0, stride, 2 stride, ..; odd */
    double exact[rooms][trial_pixels][trial_depths];
    trial_part part[trials][trial_pixels];
    int wanted[trials], wants;                       /* which are measured */
    double error[trials], rays[trials], us[trials];  /* of one sample */
} branch_trial;

/* ---------------------------------------------------------------------------------------------- */

static const vec3 pair_light[2] = {{2, 2, 2}, {0.25, 0.25, 0.25}};
static const vec3 pair_albedo[2] = {{0.5, 0.5, 0.5},
                                    {0.8, 0.8, 0.8}};
static const double pair_radius = 0.4;

/* trial = (room * trial_depths + d) * branch_kinds + n, N = 2^n */
static inline int trial_room(int trial) { return trial / (trial_depths * branch_kinds); }
static inline int trial_d(int trial) { return trial / branch_kinds % trial_depths; }
static inline int trial_N(int trial) { return 1 << trial % branch_kinds; }

/* Spheres: straight up or down, to the outer one or the ball. Box: the lower 5/8 of its picture. */
static inline ray trial_ray(int room, size_t pixel, point2 u)
{
    if (room == 0)
        return (ray){{0, 0.7, 0}, 0, {0, pixel % 2 ? 1 : -1, 0}, real_infinity};
    real x = (real)(pixel % trial_side) + u.u, y = (real)(pixel / trial_side) + u.v;
    return camera_ray(cornell_camera(1), x, 3 + y * 5 / trial_side, trial_side, trial_side);
}

static inline void trial_reference(size_t pixel, void *context)
{
    branch_trial *b = context;
    naive_path p = {&b->scene[1], DIRECTIONS_BRDF, trial_depth[trial_depths - 1], false};
    bounce_counts c = {{{0}, 0, 0}, 0};
    vec3 term[8];
    for (uint32_t i = 0; i < b->many; i++) {
        sampler s = sampler_start(SEQUENCE_SOBOL, b->seed + 1, pixel, i, b->many);
        ray eye = trial_ray(1, pixel, sampler_pair(&s));
        bounce_terms_lit(&p, eye, &s, term, &c);
        for (int d = 0; d < trial_depths; d++)
            for (int k = 0; k <= trial_depth[d]; k++)
                b->exact[1][pixel][d] += (double)term[k].y / b->many;
    }
}

static inline void trial_exact(branch_trial *b)
{
    transport t = furnace_transport(pair_radius, pair_light, pair_albedo, 1);
    for (int d = 0; d < trial_depths; d++) {
        double S[2];
        transport_sum(&t, trial_depth[d], S);
        for (int i = 0; i < trial_pixels; i++) b->exact[0][i][d] = S[i % 2];
    }
    transport_free(&t);
}

static inline double trial_sample(const branch_trial *b, int trial, size_t pixel, uint64_t i,
                                  naive_counts *c)
{
    int room = trial_room(trial);
    direction_choice choice = room ? DIRECTIONS_BRDF : DIRECTIONS_UNIFORM;
    naive_path p = {&b->scene[room], choice, trial_depth[trial_d(trial)], false};
    ray eye = trial_ray(room, pixel, branching_pair(b->seed, pixel, i, 0));
    return (double)branching_radiance(&p, trial_N(trial), eye, b->seed, pixel, i, c).y;
}

/* The long ones (N = 8) first, so that the threads end together. */
static inline void trial_job(size_t job, void *context)
{
    branch_trial *b = context;
    int trial = b->wanted[b->wants - 1 - (int)(job / b->pixels)];
    size_t pixel = job % b->pixels * b->stride;
    trial_part *part = &b->part[trial][pixel];
    double exact = b->exact[trial_room(trial)][pixel][trial_d(trial)];
    double n = b->budget / first_rays_of_branching(trial_N(trial), trial_depth[trial_d(trial)]);
    for (uint64_t i = 0; i == 0 || (double)i < n; i++) {
        double e = trial_sample(b, trial, pixel, i, &part->c) - exact;
        part->square = estimate_add(part->square, e * e);
    }
}

typedef struct { const branch_trial *b; int trial; size_t least, rays; } timed_trial;

/* Rays enough for the clock to see something. */
static inline double timed_run(void *context)
{
    timed_trial *t = context;
    naive_counts c = {{0}, 0, 0};
    double sum = 0;
    for (uint64_t i = 0; naive_rays(&c) < t->least; i++)
        sum += trial_sample(t->b, t->trial, i % trial_pixels, i, &c);
    t->rays = naive_rays(&c);
    return sum;
}

/* Those of the table without --full: the Cornell box with the fewest and the most bounces. */
static inline bool trial_wanted(const options *o, int trial)
{
    int d = trial_d(trial);
    return o->full || (trial_room(trial) == 1 && (d == 0 || d == trial_depths - 1));
}

static inline void trial_times(branch_trial *b, const options *o)
{
    timed_trial t[trials];
    clock_variant v[trials];
    int n = 0;
    for (int i = 0; i < trials; i++) {
        if (!trial_wanted(o, i)) continue;
        t[n] = (timed_trial){b, i, o->quick ? 500 : 3000, 0};
        v[n] = (clock_variant){branch_name[i % branch_kinds], timed_run, &t[n], 0};
        n++;
    }
    for (int i = 0; i < n; i += 8) clock_compare(v + i, 8, o->quick ? 1 : 15);
    for (int i = 0; i < n; i++)
        b->us[t[i].trial] = v[i].seconds / (double)t[i].rays * b->rays[t[i].trial] * 1e6;
}

static inline void branches_run(branch_trial *b, const options *o)
{
    furnace_pair(&b->scene[0], (real)pair_radius, pair_light, pair_albedo);
    lit_cornell(&b->scene[1]);
    b->seed = o->seed, b->budget = o->quick ? 100 : 5000, b->many = o->quick ? 64 : 4096;
    b->pixels = o->quick ? 8 : trial_pixels, b->stride = o->quick ? 7 : 1;
    trial_exact(b);
    parallel_for(trial_pixels, o->threads, "reference", trial_reference, b);
    for (int i = 0; i < trials; i++)
        if (trial_wanted(o, i)) b->wanted[b->wants++] = i;
    parallel_for((size_t)b->wants * b->pixels, o->threads, "N directions", trial_job, b);
    for (int k = 0; k < b->wants; k++) {
        int i = b->wanted[k];
        double rays = 0, samples = 0, exact = 0, used = 0;
        estimate square = {0, 0, 0};
        for (size_t at = 0; at < trial_pixels; at += b->stride) {
            const trial_part *p = &b->part[i][at];
            if (p->square.n == 0) continue;
            used++, rays += (double)naive_rays(&p->c), samples += (double)p->square.n;
            square = estimate_merge(square, p->square);
            exact += b->exact[trial_room(i)][at][trial_d(i)];
        }
        b->rays[i] = rays / samples, b->error[i] = sqrt(square.mean) / exact * used;
    }
    trial_times(b, o);
    lit_free(&b->scene[0]), lit_free(&b->scene[1]);
}

/* What an error costs in rays, a count that is the same everywhere. */
static inline void plot_branches(const options *o, const branch_trial *b)
{
    plot p = plot_new("Cornell box: error with the same number of rays, over that of N = 1",
                      "bounces", "error over that of N = 1", PLOT_LOG_Y);
    for (int n = 0; n < branch_kinds; n++) {
        plot_series(&p, branch_name[n]);
        for (int d = 0; d < trial_depths; d++) {
            int one = (trial_depths + d) * branch_kinds, i = one + n;
            plot_add(&p, n, trial_depth[d],
                     b->error[i] / b->error[one] * sqrt(b->rays[i] / b->rays[one]));
        }
    }
    output_plot(o, &p, "25_bounces_error.svg");
}

/* At the largest depth: from one sample on, k independent ones divide the error by sqrt k. */
static inline void plot_time(const options *o, const branch_trial *b)
{
    plot p = plot_new("Cornell box, 5 bounces: relative error against time", "time of a pixel [ms]",
                      "relative error", PLOT_LOG_X | PLOT_LOG_Y);
    int last = trials - branch_kinds;
    for (int n = 0; n < branch_kinds; n++) {
        plot_series(&p, branch_name[n]);
        for (double k = 1; k == 1 || k * b->us[last + n] < 4e5; k *= 4)
            plot_add(&p, n, k * b->us[last + n] / 1000, b->error[last + n] / sqrt(k));
    }
    plot_slope(&p, -0.5, "slope -1/2");
    output_plot(o, &p, "25_bounces_time.svg");
}

/* Room, bounces, N, rays, error and time of a sample, error in 1 ms over that of N = 1. */
static inline void trial_row(const branch_trial *b, int i, bool full, table *t)
{
    double in_time = b->error[i] * sqrt(b->us[i] / 1000);
    int one = i - i % branch_kinds, d = trial_depth[trial_d(i)];
    if (full) table_text(t, "%s", room_name[trial_room(i)]);
    table_count(t, (size_t)d), table_count(t, (size_t)trial_N(i));
    if (full) table_count(t, (size_t)first_rays_of_branching(trial_N(i), d));
    table_number(t, b->rays[i]), table_number(t, b->error[i]), table_number(t, b->us[i]);
    if (full) table_number(t, in_time);
    table_number(t, in_time / (b->error[one] * sqrt(b->us[one] / 1000)));
}

static inline void measure_branches(const options *o)
{
    branch_trial *b = allocate(1, sizeof *b);
    table t = table_new("Cornell box, N directions a hit: relative error (rms) of a sample, and in "
                        "the same time", "bounces|N|rays|error of a sample [1]|"
                        "time of a sample [us]|time: error over that of N = 1");
    table all = table_new("N directions a hit: relative error (rms) of a sample, and in 1 ms",
                          "room|bounces|N|rays if closed|rays|error of a sample [1]|"
                          "time of a sample [us]|time: error in 1 ms [1]|"
                          "time: error over that of N = 1");
    options short_run = *o;
    short_run.full = false;
    branches_run(b, o);
    for (int i = 0; i < trials; i++)
        if (trial_wanted(&short_run, i)) trial_row(b, i, false, &t);
    output_table(o, &t);
    if (o->full) {
        for (int i = 0; i < trials; i++) trial_row(b, i, true, &all);
        first_rows(o, &all);
        output_extra_table(o, &all);
        plot_branches(o, b), plot_time(o, b);
    } else table_free(&all);
    free(b);
}

/* ---- rays against depth ---- */

/* Mean rays of a sample; room 0 is closed, and all of its samples take the same. */
static inline double rays_of_sample(const options *o, const lit_scene *s, int room, int N, int d)
{
    naive_counts c = {{0}, 0, 0};
    naive_path path = {s, DIRECTIONS_BRDF, d, false};
    uint64_t i = 0;
    for (; i == 0 || (room && (double)naive_rays(&c) < (o->quick ? 1e3 : 2e4)); i++) {
        ray eye = trial_ray(room, i % trial_pixels, branching_pair(o->seed, 0, i, 0));
        branching_radiance(&path, N, eye, o->seed, 0, i, &c);
    }
    return (double)naive_rays(&c) / (double)i;
}

static inline void measure_rays(const options *o)
{
    static const int deepest[branch_kinds] = {15, 15, 8, 5};
    lit_scene s[2];
    table t = table_new("Rays of one sample, by depth: a closed room, and the Cornell box",
                        "N|bounces|(N^(d+1)-1)/(N-1)|closed|Cornell box");
    plot p = plot_new("Rays of one sample", "bounces", "rays", PLOT_LOG_Y);
    furnace_sphere(&s[0], (vec3){1, 1, 1}, vec(0.5, 0.5, 0.5));
    lit_cornell(&s[1]);
    for (int n = 0; n < branch_kinds; n++) {
        char name[64];
        plot_series(&p, branch_name[n]);
        snprintf(name, sizeof name, "%s, Cornell box", branch_name[n]);
        plot_series(&p, name);
        for (int d = 0; d <= deepest[n] - (o->quick ? 2 * n : 0); d++) {
            double rays[2];
            for (int k = 0; k < 2; k++) {
                rays[k] = rays_of_sample(o, &s[k], k, 1 << n, d);
                plot_add(&p, 2 * n + k, d, rays[k]);
            }
            if (d % 5 && d != 3) continue;
            table_count(&t, (size_t)1 << n), table_count(&t, (size_t)d);
            table_number(&t, first_rays_of_branching(1 << n, d));
            table_number(&t, rays[0]), table_number(&t, rays[1]);
        }
    }
    output_extra_table(o, &t);
    output_plot(o, &p, "25_bounces_rays.svg");
    lit_free(&s[0]), lit_free(&s[1]);
}

#endif
