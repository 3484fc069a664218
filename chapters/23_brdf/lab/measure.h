/* measure.h: the reflection equation, error against samples against time.
 *
 *   measure_methods(&o)  main table of a glossy surface, five ways to integrate; with --full of
 *                        four surfaces, six ways, and plots
 *   measure_furnace(&o)  what GGX keeps of a white sky: roughness against angle
 *   measure_glass(&o)    what rough glass keeps of it, from outside and from inside
 *   measure_naive(&o)    the formulas of brdf_naive.h beside the right ones
 */
#ifndef BRDF_MEASURE_H
#define BRDF_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../../common/parallel.h"
#include "brdf_naive.h"
#include "../first.h"
#include "../reflection.h"
#include "../rough_glass.h"

enum { GLOSSY = 2, WINDOW, surfaces };  /* the last reflects the window of first.h, not the sky */
enum { FIRST = 5, methods, levels = 5, brief_level = 2 };  /* without --full that one */
static const char *const surface_name[surfaces] = {"Lambert", "GGX .7", "GGX .25", "window"};
static const char *const method_name[methods] = {"grid", "uniform", "cosine", "BRDF",
                                                 "BRDF, Sobol'", "first"};

/* ---------------------------------------------------------------------------------------------- */

static inline first_brdf window_brdf(void)
{
    return (first_brdf){vec(0.12, 0.04, 0.02), vec(0.75, 0.6, 0.4), 64};
}

static inline brdf surface_brdf(int surface)
{
    vec3 white = {1, 1, 1};
    first_brdf f = window_brdf();
    if (surface == WINDOW) return brdf_blinn_phong(f.kd, f.ks, f.e);
    if (surface == 0) return brdf_lambert(white);
    return brdf_ggx(white, surface == 1 ? (real)0.7 : (real)0.25);
}

/* Of the surfaces only what is asked for; and first.h knows no light but its own. */
static inline bool method_suits(const options *o, int method, int surface)
{
    return (o->full || surface == GLOSSY) && (method != FIRST || surface == WINDOW);
}

static inline uint32_t level_samples(int level) { return (uint32_t)16 << 2 * level; }

/* A sky without edges: brighter overhead, with a glow 40 degrees wide. */
static inline vec3 glowing_sky(vec3 w)
{
    real c = vdot(w, vunit(vec(0.5, 0.5, 1)));
    real l = (1 + w.z) / 2 + 4 * exp(20 * (c - 1));
    return (vec3){l, l, l};
}

static const vec3 upright = {0, 0, 1};
static inline incident_light *surface_light(int surface)
{
    return surface == WINDOW ? first_room_light : glowing_sky;
}

/* At 45 degrees; at WINDOW from where the window is seen mirrored. */
static inline vec3 surface_view(int surface)
{
    return vunit(surface == WINDOW ? vec(-0.2, -0.5, 0.85) : vec(-1, 0, 1));
}

/* Within 1e-6, that of the window within 1e-5. */
static inline double surface_exact(int surface)
{
    brdf b = surface_brdf(surface);
    reflection r = {DIRECTIONS_UNIFORM, false, 0};
    int k = surface == WINDOW ? 4000 : 1000;
    vec3 wo = surface_view(surface);
    incident_light *light = surface_light(surface);
    return (double)(b.kind == BRDF_GGX ? reflection_reference(&b, upright, wo, light)
                                       : reflection_grid(&r, &b, upright, wo, light, k)).x;
}

static inline double method_run(reflection *r, int surface, int method, int level, uint64_t seed,
                                uint64_t run)
{
    brdf b = surface_brdf(surface);
    uint32_t n = level_samples(level);
    vec3 wo = surface_view(surface);
    incident_light *light = surface_light(surface);
    r->choice = method <= 1 ? DIRECTIONS_UNIFORM
              : method == 2 ? DIRECTIONS_COSINE : DIRECTIONS_BRDF;
    if (method == 0) return (double)reflection_grid(r, &b, upright, wo, light, 4 << level).x;
    if (method == FIRST) {
        random_stream random = random_start(seed, run, n);
        r->asked += n;
        return (double)first_reflection(window_brdf(), upright, wo, (int)n, &random).x;
    }
    return (double)reflection_estimate(r, &b, upright, wo, light,
                                       method == 4 ? SEQUENCE_SOBOL : SEQUENCE_RANDOM, seed, run,
                                       n).x;
}

typedef struct {
    const options *o;
    int runs;
    double exact[surfaces], error[surfaces][methods][levels], asked[surfaces][methods][levels];
} brdf_survey;

/* Long ones first. The grid is not random: one run is all. */
static inline void survey_job(size_t i, void *context)
{
    brdf_survey *s = context;
    int level = levels - 1 - (int)(i / (surfaces * methods));
    int surface = (int)(i % surfaces), method = (int)(i / surfaces) % methods;
    int runs = method == 0 ? 1 : s->runs;
    if (!method_suits(s->o, method, surface) || (level != brief_level && !s->o->full)) return;
    double square = 0, exact = s->exact[surface];
    reflection r = {DIRECTIONS_UNIFORM, false, 0};
    for (int k = 0; k < runs; k++) {
        double e = method_run(&r, surface, method, level, s->o->seed, (uint64_t)k) / exact - 1;
        square += e * e / runs;
    }
    s->error[surface][method][level] = sqrt(square);
    s->asked[surface][method][level] = (double)r.asked / runs;
}

typedef struct { int surface, method; } brdf_timed;

static inline double timed_run(void *context)
{
    const brdf_timed *m = context;
    reflection r = {DIRECTIONS_UNIFORM, false, 0};
    return method_run(&r, m->surface, m->method, 3, 1, 1);
}

/* The methods of one surface in turn. */
static inline void measure_times(const options *o, int surface, double ns[methods])
{
    brdf_timed m[methods];
    int n = surface == WINDOW ? methods : FIRST;
    if (!method_suits(o, 0, surface)) return;
    for (int k = 0; k < n; k++) m[k] = (brdf_timed){surface, k};
    bench_each(timed_run, m, sizeof *m, n, o->quick ? 3 : 31, 1e9 / level_samples(3), ns);
}

static inline void plot_survey(const options *o, const brdf_survey *s, double ns[surfaces][methods],
                               int f, bool time, const char *title, const char *name)
{
    plot p = plot_new(title, time ? "time of an estimate [us]" : "N", "relative error",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int m = 0; m < methods && method_suits(o, m, f); m++) {
        plot_series(&p, method_name[m]);
        for (int l = 0; l < levels; l++)
            plot_add(&p, m, level_samples(l) * (time ? ns[f][m] / 1000 : 1), s->error[f][m][l]);
    }
    plot_slope(&p, -0.5, "slope -1/2"), plot_slope(&p, -1, "slope -1");
    output_plot(o, &p, name);
}

/* Rows of the levels from .. to - 1; `surface` < 0: of all. */
static inline table methods_table(const char *title, const brdf_survey *s,
                                  double ns[surfaces][methods], int surface, int from, int to)
{
    table t = table_new(title, "surface|method|N|asked|error [1]|time [us]");
    for (int f = 0; f < surfaces; f++)
        for (int m = 0; m < methods && (surface < 0 || f == surface); m++)
            for (int l = from; l < to && method_suits(s->o, m, f); l += 2) {
                table_text(&t, "%s", surface_name[f]), table_text(&t, "%s", method_name[m]);
                table_count(&t, level_samples(l)), table_number(&t, s->asked[f][m][l]);
                table_number(&t, s->error[f][m][l]);
                table_number(&t, level_samples(l) * ns[f][m] / 1000);
            }
    return t;
}

static inline void measure_methods(const options *o)
{
    brdf_survey s = {.o = o, .runs = o->quick ? 10 : 200};
    double ns[surfaces][methods];
    for (int f = 0; f < surfaces; f++)
        if (method_suits(o, 0, f)) s.exact[f] = surface_exact(f);
    parallel_whole(surfaces * methods * levels, o->threads, "estimates", survey_job, &s);
    for (int f = 0; f < surfaces; f++) measure_times(o, f, ns[f]);
    table t = methods_table("A glossy surface by 256 directions: relative error (rms), light asked "
                            "for, time", &s, ns, GLOSSY, brief_level, brief_level + 1);
    output_table(o, &t);
    if (!o->full) return;
    t = methods_table("The reflection equation: relative error (rms), light asked for, time", &s,
                      ns, -1, 0, levels);
    output_extra_table(o, &t);
    const char *glossy = "A glossy surface, roughness .25";
    plot_survey(o, &s, ns, GLOSSY, false, glossy, "23_brdf_error.svg");
    plot_survey(o, &s, ns, GLOSSY, true, glossy, "23_brdf_time.svg");
    plot_survey(o, &s, ns, 0, false, "A matte surface", "23_brdf_matte.svg");
}

/* ---- white furnace ---- */

static inline void measure_furnace(const options *o)
{
    static const double cosine[5] = {1, 0.7, 0.4, 0.1, 0.01};
    table t = table_new("White furnace: what single scattering keeps, GGX, F = 1",
                        "roughness|alpha|cos 1|cos .7|cos .4|cos .1|cos .01|lost in all [%]");
    plot p = plot_new("White furnace: albedo of GGX with F = 1", "cos of the angle to n", "albedo",
                      0);
    for (int r = 0; r <= 10; r++) {
        brdf b = brdf_ggx((vec3){1, 1, 1}, (real)r / 10);
        double all = 0;
        table_number(&t, r / 10.0), table_number(&t, r * r / 100.0);
        for (int k = 0; k < 5; k++)  /* no more digits than brdf_albedo has */
            table_text(&t, "%.3f", (double)brdf_albedo(&b, (real)cosine[k]).x);
        for (int k = 0; k < 20; k++) {  /* mean over white light from all sides: 2 a c dc */
            double c = (k + 0.5) / 20;
            all += 2 * c * (double)brdf_albedo(&b, (real)c).x / 20;
        }
        table_text(&t, "%.1f", 100 * fabs(1 - all));
        if (r < 3 || r % 2) continue;
        char name[32];
        snprintf(name, sizeof name, "roughness %.1f", r / 10.0);
        int s = plot_series(&p, name);
        for (int k = 0; k <= 25; k++) {
            double c = k ? k / 25.0 : 0.002;
            plot_add(&p, s, c, (double)brdf_albedo(&b, (real)c).x);
        }
    }
    output_extra_table(o, &t);
    output_plot(o, &p, "23_brdf_albedo.svg");
}

/* Power that leaves rough glass, of 1: a lattice of facets, and 32 coins for each. */
static inline double glass_keeps(const rough_glass *g, double cosine)
{
    enum { coins = 32 };
    vec3 wo = vec(sqrt((1 - cosine) * (1 + cosine)), 0, cosine), wi;
    double sum = 0, whole = 0, squeeze = (double)(g->n2 / g->n1 * (g->n2 / g->n1));
    for (int i = 0; i < fibonacci_small.n; i++) {
        square_point p = fibonacci_point(fibonacci_small, i);
        whole += (double)p.area;
        for (int k = 0; k < coins; k++) {
            real weight, coin = ((real)k + (real)0.5) / coins;
            if (rough_glass_sample(g, wo, p.u, p.v, coin, &wi, &weight))
                sum += (double)(p.area * weight) * (wi.z < 0 ? squeeze : 1) / coins;
        }
    }
    return sum / whole;
}

static inline void measure_glass(const options *o)
{
    static const double alpha[6] = {0.01, 0.04, 0.09, 0.25, 0.49, 1}, cosine[3] = {1, 0.7, 0.2};
    table t = table_new("White furnace: what rough glass keeps, n = 1.5",
                        "alpha|from outside, cos 1|cos .7|cos .2|from inside, cos 1|cos .7|cos .2");
    for (int r = 0; r < 6; r++) {
        rough_glass g = {(real)alpha[r], 1, 1.5};
        table_number(&t, alpha[r]);
        for (int side = 0; side < 2; side++, g = rough_glass_turned(g))
            for (int k = 0; k < 3; k++) table_text(&t, "%.3f", glass_keeps(&g, cosine[k]));
    }
    output_extra_table(o, &t);
}

/* ---- naive beside right ---- */

typedef real one_value(real parameter, vec3 wi, vec3 wo);

/* What an estimate with the wrong pdf p' tends to: the integral of f cos p / p'. */
static inline real value_by_wrong_pdf(real e, vec3 wi, vec3 wo)
{
    return blinn_phong_value(e, wi, wo) * blinn_phong_pdf(e, wi, wo)
         / blinn_phong_pdf_naive(e, wi, wo);
}

static inline real ggx_value(real a, vec3 wi, vec3 wo)
{
    brdf b = brdf_ggx((vec3){1, 1, 1}, sqrt(a));
    return brdf_value_local(&b, wi, wo).x;
}

static inline double albedo_by_grid(one_value *f, real parameter, real cosine)
{
    enum { k = 400 };
    vec3 wo = {-sqrt((1 - cosine) * (1 + cosine)), 0, cosine};
    double sum = 0;
    for (int i = 0; i < k * k; i++) {
        real u = ((real)(i / k) + (real)0.5) / k, v = ((real)(i % k) + (real)0.5) / k;
        vec3 wi = sample_hemisphere(u, v);
        sum += (double)(f(parameter, wi, wo) * wi.z);
    }
    return sum * 2 * (double)pi / (k * k);
}

static inline void naive_row(table *t, const char *what, const char *input, double naive,
                             double right)
{
    table_text(t, "%s", what), table_text(t, "%s", input);
    if (isnan(naive)) table_text(t, "NaN");  /* its sign says nothing */
    else table_number(t, naive);
    table_number(t, right);
}

static inline void measure_naive(const options *o)
{
    table t = table_new("Formulas that look right", "naive|input|error it gives|instead of");
    static const struct {
        const char *what, *input;
        one_value *naive, *right;
        double parameter, cosine;
    } row[] = {
        {"Phong as it is: albedo", "e = 1, head-on", phong_naive, blinn_phong_value, 1, 1},
        {"Phong as it is: albedo", "e = 100, head-on", phong_naive, blinn_phong_value, 100, 1},
        {"pdf of h for pdf of wi: albedo", "e = 10, cos .6", value_by_wrong_pdf,
         blinn_phong_value, 10, 0.6},
        {"GGX without G: albedo", "alpha .5, cos .1", ggx_value_naive, ggx_value, 0.5, 0.1},
        {"GGX without G: albedo", "alpha .5, cos .001", ggx_value_naive, ggx_value, 0.5, 0.001}};
    for (int k = 0; k < 5; k++) {
        real p = (real)row[k].parameter, c = (real)row[k].cosine;
        naive_row(&t, row[k].what, row[k].input, albedo_by_grid(row[k].naive, p, c),
                  albedo_by_grid(row[k].right, p, c));
    }
    for (int k = 2; k <= 4; k++) {
        float a = (float)pow(10, -k);
        char input[48];
        snprintf(input, sizeof input, "float, alpha 1e-%d, m = n", k);
        naive_row(&t, "z^2 (a^2 - 1) + 1: D", input, (double)ggx_d_naive_f32(a, 1),
                  1 / ((double)pi * (double)a * (double)a));
    }
    vec3 flat = {1, 0, real_is_float ? (real)1e-12 : (real)1e-90};
    naive_row(&t, "Beckmann as it is: D", real_is_float ? "m.z = 1e-12" : "m.z = 1e-90",
              (double)beckmann_d_naive(0.5, flat), (double)beckmann_d(0.5, flat));
    output_extra_table(o, &t);
}

#endif
