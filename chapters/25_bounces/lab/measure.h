/* measure.h: the series, where its sum is known and where it is not.
 *
 *   measure_series(o)    partial sums by paths against (25.5), their variance against (25.12); plot
 *   measure_cornell(o)   how much light each bounce brings to the picture
 *
 * E is known: the part of the picture that the lamp fills. The other terms ask the lamp (25.10).
 */
#ifndef BOUNCES_MEASURE_H
#define BOUNCES_MEASURE_H

#include "../../24_direct_light/scenes/lit_cornell.h"
#include "furnace.h"
#include "measure_branches.h"

/* ---------------------------------------------------------------------------------------------- */

/* One estimate of n samples, in the box whose three channels are rho. */
static inline estimate furnace_estimate(const options *o, const lit_scene *s, direction_choice how,
                                        int depth, int channel, uint32_t n)
{
    naive_path path = {s, how, depth, false};
    naive_counts c = {{0}, 0, 0};
    estimate e = {0, 0, 0};
    ray eye = {{0, 0, 0}, 0, {1, 0.2, 0.3}, real_infinity};
    for (uint32_t i = 0; i < n; i++) {
        sampler r = sampler_start(SEQUENCE_RANDOM, o->seed, (uint64_t)depth, i, 1);
        e = estimate_add(e, (double)vaxis(naive_radiance(&path, eye, &r, &c), channel));
    }
    return e;
}

static inline void measure_series(const options *o)
{
    static const int depth[] = {0, 1, 3, 10, 30, 100};
    static const char *const name[] = {"rho = .5", "rho = .9", "rho = .99", "rho = 1"};
    vec3 rho[2] = {{0.5, 0.9, 0.99}, {1, 1, 1}};
    table t = table_new("Closed box, all walls shining with 1: E + KE + ... + K^n E by paths",
                        "rho|n|exact|cosine|error cosine [1]|uniform|its -+|-+ by (25.12)");
    plot p = plot_new("Furnace: bounces 0 to n, by uniform directions", "n + 1",
                      "found, of the exact radiance", PLOT_LOG_X);
    for (int j = 0; j < 4; j++) {
        lit_scene s;
        double albedo = (double)vaxis(rho[j / 3], j % 3);
        furnace_box(&s, (vec3){1, 1, 1}, rho[j / 3]);
        plot_series(&p, name[j]);
        for (int k = 0; k < 6; k++) {
            uint32_t n = (o->quick ? 50u : 2000u) / (k > 4 ? 4 : 1);
            estimate e = furnace_estimate(o, &s, DIRECTIONS_UNIFORM, depth[k], j % 3, n);
            double exact = (double)series_sum(1, (real)albedo, (real)depth[k]);
            plot_add(&p, j, depth[k] + 1, e.mean / exact);
            if (j % 2) continue;
            estimate f = furnace_estimate(o, &s, DIRECTIONS_COSINE, depth[k], j % 3, 10);
            double due = sqrt(furnace_variance(1, albedo, depth[k]) / n);
            const double cell[] = {exact, f.mean, fabs(f.mean / exact - 1), e.mean,
                                   estimate_error(e), due};
            table_text(&t, "%s", name[j] + 6), table_count(&t, (size_t)depth[k]);
            for (int i = 0; i < 6; i++) table_number(&t, cell[i]);
        }
        lit_free(&s);
    }
    output_extra_table(o, &t);
    output_plot(o, &p, "25_bounces_furnace.svg");
}

/* ---- Cornell box, mean over the whole picture ---- */

enum { cornell_terms = 11, cornell_jobs = 32 };
typedef struct {
    lit_scene s;
    uint64_t seed;
    uint32_t n;
    estimate e[cornell_jobs][cornell_terms];
} cornell_survey;

static inline void cornell_job(size_t job, void *context)
{
    cornell_survey *t = context;
    naive_path p = {&t->s, DIRECTIONS_BRDF, cornell_terms - 1, false};
    bounce_counts c = {.direct = {0, 0, 0}};
    vec3 term[cornell_terms];
    for (uint32_t i = 0; i < t->n; i++) {
        sampler s = sampler_start(SEQUENCE_RANDOM, t->seed, job, 2 * i + 1, 1);
        point2 u = sampler_pair(&s);
        bounce_terms_lit(&p, camera_ray(cornell_camera(1), u.u, u.v, 1, 1), &s, term, &c);
        for (int k = 0; k < cornell_terms; k++)
            t->e[job][k] = estimate_add(t->e[job][k], (double)term[k].y);
    }
}

/* E: all of the lamp shows, as four corners whose diagonals tell the area. */
static inline double cornell_emitted(void)
{
    vec3 o = cornell_corner, s = cornell_side_s, t = cornell_side_t, far = vadd(vadd(o, s), t);
    const vec3 corner[4] = {o, vadd(o, s), far, vadd(o, t)};
    real x[4], y[4];
    for (int i = 0; i < 4; i++) camera_project(cornell_camera(1), corner[i], 1, 1, &x[i], &y[i]);
    real twice = (x[2] - x[0]) * (y[3] - y[1]) - (x[3] - x[1]) * (y[2] - y[0]);
    return (double)(fabs(twice) / 2 * cornell_radiance.y);
}

static inline void measure_cornell(const options *o)
{
    cornell_survey *c = allocate(1, sizeof *c);
    table t = table_new("Cornell box: mean radiance of the picture (green) after n bounces",
                        "n|radiance|-+|part of the whole [%]|over the one before");
    double whole = 0, before = 0;
    estimate *e = c->e[0];
    lit_cornell(&c->s);
    c->seed = o->seed, c->n = o->quick ? 200 : 5000;
    parallel_whole(cornell_jobs, o->threads, "terms", cornell_job, c);
    for (int k = 0; k < cornell_terms; k++) {
        for (int i = 1; i < cornell_jobs; i++) e[k] = estimate_merge(e[k], c->e[i][k]);
        if (k == 0) e[k] = (estimate){e[k].n, cornell_emitted(), 0};
        whole += e[k].mean;
    }
    for (int k = 0; k < cornell_terms; before = e[k++].mean) {
        table_count(&t, (size_t)k), table_number(&t, e[k].mean);
        table_number(&t, estimate_error(e[k])), table_number(&t, 100 * e[k].mean / whole);
        if (k) table_number(&t, e[k].mean / before);
        else table_text(&t, "-");
    }
    output_extra_table(o, &t);
    lit_free(&c->s), free(c);
}

#endif
