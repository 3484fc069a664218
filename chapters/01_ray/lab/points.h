/* points.h: a point on a ray, in two forms and two precisions: how far it is off, and its time.
 *
 *   ray_line l = ray_line_at(seed, i, 10000);       a random line, |o| = 10000, |d| = 1
 *   double e = ray_error(form, &l, t);              |p(t) - exact|, by wide.h
 *   double e = ray_error_rms(l, n, seed, form, t);  of n lines, each at a t between t/2 and t
 *   ray_measure(&o);                                prints the table, draws the plot
 *
 * Exact is the point of the very numbers that a form was given: o and d, or a and b.
 */
#ifndef RAY_LAB_POINTS_H
#define RAY_LAB_POINTS_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../../common/numbers/wide.h"
#include "../../../common/random.h"
#include "ray_f32.h"

typedef enum { RAY_F32, RAY_BETWEEN_F32, RAY_FIRST, RAY_FUSED, RAY_BETWEEN, RAY_FORMS } ray_form;
static const char *const ray_form_name[RAY_FORMS] = {
    "float o + t d", "float (1-t) a + t b", "first o + t d", "o + t d fused",
    "first (1-t) a + t b"};

/* One line for all forms: from o along d, through a = o and b = o + d, and all of it in float. */
typedef struct { vec3 o, d, b; vec3_f32 o_f32, d_f32, b_f32; } ray_line;

enum { ray_lines = 256, ray_repeats = 800 };  /* few lines: the fastest cache holds them */

/* ---------------------------------------------------------------------------------------------- */

static inline vec3_f32 ray_narrow(vec3 a)
{
    return (vec3_f32){(float)a.x, (float)a.y, (float)a.z};
}
static inline vec3 ray_widened(vec3_f32 a) { return (vec3){(real)a.x, (real)a.y, (real)a.z}; }

/* Unit vectors, whose components use all digits. Were they multiples of one small step, as random
 * numbers are, o + d would be one, too, and (1.2) exact at t = 1, by accident. */
static inline ray_line ray_line_at(uint64_t seed, uint64_t i, real far)
{
    random_stream s = random_start(seed, i, 0);
    real v[6];
    for (int k = 0; k < 6; k++) v[k] = 2 * random_next(&s) - 1;
    vec3 o = vscale(vunit((vec3){v[0], v[1], v[2]}), far), d = vunit((vec3){v[3], v[4], v[5]});
    vec3 b = vadd(o, d);
    return (ray_line){o, d, b, ray_narrow(o), ray_narrow(d), ray_narrow(b)};
}

/* p(t) = o + t d with one rounding instead of two: off by half an epsilon |p|. One instruction a
 * component on a machine with a fused multiply-add; a call of libm, and slow, on others. */
static inline vec3 ray_at_fused(ray r, real t)
{
    return (vec3){fma(t, r.d.x, r.o.x), fma(t, r.d.y, r.o.y), fma(t, r.d.z, r.o.z)};
}

static inline vec3 ray_form_at(ray_form form, const ray_line *l, real t)
{
    switch (form) {
    case RAY_F32: return ray_widened(ray_at_f32(l->o_f32, l->d_f32, (float)t));
    case RAY_BETWEEN_F32: return ray_widened(ray_at_between_f32(l->o_f32, l->b_f32, (float)t));
    case RAY_FIRST: return ray_at(ray_from(l->o, l->d), t);
    case RAY_FUSED: return ray_at_fused(ray_from(l->o, l->d), t);
    default: return ray_at_between(l->o, l->b, t);
    }
}

static inline double ray_error(ray_form form, const ray_line *l, real t)
{
    bool narrow = form == RAY_F32 || form == RAY_BETWEEN_F32;
    wide3 o = wide3_of(narrow ? ray_widened(l->o_f32) : l->o);
    wide3 d = wide3_of(narrow ? ray_widened(l->d_f32) : l->d);
    if (form == RAY_BETWEEN_F32) d = wide3_sub(wide3_of(ray_widened(l->b_f32)), o);
    if (form == RAY_BETWEEN) d = wide3_sub(wide3_of(l->b), o);
    wide3 exact = wide3_madd(o, d, wide_of((double)t));
    return wide_value(wide3_length(wide3_sub(wide3_of(ray_form_at(form, l, t)), exact)));
}

/* At t = 1 itself, or at a t of its own for each line, from t / 2 to t. */
static inline double ray_error_rms(const ray_line *l, int n, uint64_t seed, ray_form form, real t)
{
    double sum = 0;
    for (int i = 0; i < n; i++) {
        real own = (real)(float)(t * (1 + random_real(seed, (uint64_t)i, 1, 0)) / 2);
        double e = ray_error(form, &l[i], t == 1 ? 1 : own);
        sum += e * e / n;
    }
    return sqrt(sum);
}

/* Each form in a loop of its own, points into an array: nothing but the form differs, and no sum
 * makes one point wait for the one before. */
typedef struct { const ray_line *l; vec3 *out; vec3_f32 *out_f32; } ray_task;
#define RAY_TIMED(name, array, point)                                                          \
    static double name(void *context)                                                          \
    {                                                                                          \
        const ray_task *k = context;                                                           \
        const ray_line *l = k->l;                                                              \
        for (int repeat = 0; repeat < ray_repeats; repeat++) {                                 \
            real t = (real)(repeat + 1);                                                       \
            for (int i = 0; i < ray_lines; i++) (array)[i] = (point);                          \
        }                                                                                      \
        return (double)(array)[ray_lines - 1].x;                                               \
    }
RAY_TIMED(ray_run_f32, k->out_f32, ray_at_f32(l[i].o_f32, l[i].d_f32, (float)t))
RAY_TIMED(ray_run_between_f32, k->out_f32, ray_at_between_f32(l[i].o_f32, l[i].b_f32, (float)t))
RAY_TIMED(ray_run_first, k->out, ray_at(ray_from(l[i].o, l[i].d), t))
RAY_TIMED(ray_run_fused, k->out, ray_at_fused(ray_from(l[i].o, l[i].d), t))
RAY_TIMED(ray_run_between, k->out, ray_at_between(l[i].o, l[i].b, t))
static double (*const ray_run[RAY_FORMS])(void *) = {
    ray_run_f32, ray_run_between_f32, ray_run_first, ray_run_fused, ray_run_between};

static inline void ray_main_table(const options *o, ray_task *job)
{
    bench_candidate v[RAY_FORMS];
    table t = table_new("p(t), |o| = 1e4, |d| = 1: error (rms of 256 rays), time",
                        "form|error t=1|error t=1e4|error t=1e8|time [ns]");
    plot p = plot_new("Error of p(t), |o| = 1e4", "t", "error", PLOT_LOG_X | PLOT_LOG_Y);
    for (int f = 0; f < RAY_FORMS; f++) v[f] = (bench_candidate){.run = ray_run[f], .context = job};
    bench_time(v, RAY_FORMS, o->quick ? 3 : 15);
    for (int f = 0; f < RAY_FORMS; f++) {
        int series = plot_series(&p, ray_form_name[f]);
        table_text(&t, "%s", ray_form_name[f]);
        for (int power = 0; power <= 8; power++) {
            real x = pow((real)10, (real)power);
            double e = ray_error_rms(job->l, ray_lines, o->seed, (ray_form)f, x);
            if (power % 4 == 0) table_number(&t, e);
            plot_add(&p, series, (double)x, e);
        }
        table_number(&t, v[f].seconds * 1e9 / (ray_repeats * ray_lines));
    }
    output_table(o, &t);
    plot_slope(&p, 1, "slope 1");
    output_plot(o, &p, "01_ray_error.svg");
}

static inline void ray_measure(const options *o)
{
    ray_line *l = allocate(ray_lines, sizeof *l);
    ray_task job = {l, allocate(ray_lines, sizeof(vec3)), allocate(ray_lines, sizeof(vec3_f32))};
    for (uint64_t i = 0; i < ray_lines; i++) l[i] = ray_line_at(o->seed, i, 10000);
    ray_main_table(o, &job);
    free(l), free(job.out), free(job.out_f32);
}
#endif
