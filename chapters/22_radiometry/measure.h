/* measure.h: the tables of this chapter.
 *
 *   measure_relations(o)    every relation: closed form, estimate, standard error, z
 *   measure_view(o)         areas of the picture of view.h, counted in pixels
 *   measure_ways(o)         error of four estimators against samples and time; plots
 *   measure_hard(o)         tiny, far, grazing, touching: error of the variants and their time
 *   measure_photometry(o)   lights in watts and in lumens
 */
#ifndef MEASURE_22_H
#define MEASURE_22_H

#include "../../common/output.h"
#include "../07_mesh/inside.h"
#include "directions.h"
#include "oracle.h"
#include "photometry.h"
#include "view.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void measure_relations(const options *o)
{
    size_t n = o->quick ? 20000 : 400000;
    table t = table_new("Relations, measured; those with - are wrong, and z shows it",
                        "quantity|unit|closed form|error estimate|error standard|error z");
    for (size_t k = 0; k < relations; k++) {
        const relation *r = &relation_list[k];
        estimate e = relation_measure(k, o->seed, n);
        double c = r->closed(), z = (e.mean - c) / estimate_error(e);
        table_text(&t, "%s", r->name), table_text(&t, "%s", r->unit);
        table_text(&t, "%.5f", c), table_text(&t, "%.5f", e.mean);
        table_number(&t, estimate_error(e)), table_text(&t, "%.1f", z);
    }
    output_extra_table(o, &t);
}

static inline void measure_view(const options *o)
{
    int n = o->quick ? 200 : 1000;
    double area[view_maps][view_things];
    for (int m = 0; m < view_maps; m++) view_count((view_map)m, n, area[m]);
    table t = table_new("What a point sees: pixels counted, of 1000 x 1000", "thing|solid angle [sr]|"
                        "error counted [sr]|irradiance [W/m^2]|error counted [W/m^2]");
    for (int k = 0; k < view_things; k++) {
        table_text(&t, "%s", view_name[k]);
        for (int m = 0; m < view_maps; m++) {
            double closed = view_closed((view_map)m, k);
            table_text(&t, isnan(closed) ? "-" : "%.5f", closed);
            table_text(&t, "%.5f", area[m][k]);
        }
    }
    output_extra_table(o, &t);
}

/* ---- error against samples and time ---- */

enum { levels = 6 };
typedef struct { light_kind light; way by; sequence_kind kind; uint64_t seed; } timed_way;
typedef struct { timed_way what; int runs; double rms[levels]; } way_errors;

static inline uint32_t level_n(int l) { return (uint32_t)16 << (2 * l); }  /* 16 ... 16384 */

static inline void way_job(size_t i, void *context)
{
    way_errors *e = (way_errors *)context + i;
    double exact = direction_exact(e->what.light);
    for (int l = 0; l < levels; l++) {
        double square = 0;
        for (int run = 0; run < e->runs; run++) {
            double off = direction_estimate(e->what.light, e->what.by, e->what.kind, e->what.seed,
                                            (uint64_t)run, level_n(l)) - exact;
            square += off * off;
        }
        e->rms[l] = sqrt(square / e->runs) / exact;
    }
}

static inline double run_way(void *context)
{
    const timed_way *w = context;
    return direction_estimate(w->light, w->by, w->kind, w->seed, 0, 1024);
}

/* Order: light, way, random or Sobol'. */
static inline void measure_ways(const options *o)
{
    enum { all = 2 * lights * ways };
    way_errors e[all];
    clock_variant clock[all];
    for (int i = 0; i < all; i++) {
        timed_way w = {(light_kind)(i / 2 / ways), (way)(i / 2 % ways),
                       i % 2 ? SEQUENCE_SOBOL : SEQUENCE_RANDOM, o->seed};
        e[i] = (way_errors){w, o->quick ? 2 : 64, {0}};
        clock[i] = (clock_variant){way_name[w.by], run_way, &e[i].what, 0};
    }
    parallel_for(all, o->threads, "estimates", way_job, e);
    clock_compare(clock, all, o->quick ? 3 : 51);
    table t = table_new("Irradiance of two lights: error (root mean square over 64 runs, relative) "
                        "and time", "light|samples by|N|error random|time random [us]|error Sobol'|"
                        "time Sobol' [us]");
    for (int i = 0; i < all; i += 2)
        for (int l = 0; l < levels; l += 2) {
            table_text(&t, "%s", light_name[e[i].what.light]);
            table_text(&t, "%s", way_name[e[i].what.by]), table_count(&t, level_n(l));
            for (int k = 0; k < 2; k++) {
                table_number(&t, e[i + k].rms[l]);
                table_number(&t, clock[i + k].seconds / 1024 * level_n(l) * 1e6);
            }
        }
    output_table(o, &t);
    plot n = plot_new("Irradiance of the square: error against samples", "N", "relative error",
                      PLOT_LOG_X | PLOT_LOG_Y);
    plot time = plot_new("Irradiance of the square: error against time", "time [us]",
                         "relative error", PLOT_LOG_X | PLOT_LOG_Y);
    for (int i = all / 2; i < all; i++) {
        char name[64];
        snprintf(name, sizeof name, "%s%s", way_name[e[i].what.by], i % 2 ? ", Sobol'" : "");
        int a = plot_series(&n, name), b = plot_series(&time, name);
        for (int l = 0; l < levels; l++) {
            plot_add(&n, a, level_n(l), e[i].rms[l]);
            plot_add(&time, b, clock[i].seconds / 1024 * level_n(l) * 1e6, e[i].rms[l]);
        }
    }
    plot_slope(&n, -0.5, "slope -1/2"), plot_slope(&time, -0.5, "slope -1/2");
    output_plot(o, &n, "22_radiometry_error.svg");
    output_plot(o, &time, "22_radiometry_time.svg");
}

/* ---- hard cases: as many variants as there are of one number, on the same inputs ---- */

enum { most_variants = 3, hard_inputs = 256 };
typedef enum { HARD_SPHERE_ANGLE, HARD_TRIANGLE_ANGLE, HARD_SPHERE_E, HARD_SQUARE_E } hard_kind;
typedef struct { hard_kind kind; sphere s; triangle t; vec3 p; vec3 v[4]; } hard_input;
typedef struct { const char *name, *input; hard_kind kind; double size; int shape; } hard_case;
enum { SHAPE_ANY, SHAPE_GRAZING, SHAPE_TOUCHING };

static const hard_case hard_list[] = {
    {"solid angle, sphere", "R/d = 1e-2", HARD_SPHERE_ANGLE, 1e-2, SHAPE_ANY},
    {"solid angle, sphere", "R/d = 1e-6", HARD_SPHERE_ANGLE, 1e-6, SHAPE_ANY},
    {"solid angle, sphere", "gap 1e-6 R", HARD_SPHERE_ANGLE, 1e-6, SHAPE_TOUCHING},
    {"solid angle, triangle", "size 1", HARD_TRIANGLE_ANGLE, 1, SHAPE_ANY},
    {"solid angle, triangle", "size 1e-3", HARD_TRIANGLE_ANGLE, 1e-3, SHAPE_ANY},
    {"solid angle, triangle", "size 1e-7", HARD_TRIANGLE_ANGLE, 1e-7, SHAPE_ANY},
    {"solid angle, triangle", "1e-6 off its plane", HARD_TRIANGLE_ANGLE, 1e-6, SHAPE_GRAZING},
    {"irradiance, sphere", "half sunk, R/d = 0.1", HARD_SPHERE_E, 1e-1, SHAPE_ANY},
    {"irradiance, sphere", "half sunk, R/d = 1e-3", HARD_SPHERE_E, 1e-3, SHAPE_ANY},
    {"irradiance, sphere", "half sunk, R/d = 1e-6", HARD_SPHERE_E, 1e-6, SHAPE_ANY},
    {"irradiance, sphere", "1e-4 R above the horizon", HARD_SPHERE_E, 1e-4, SHAPE_GRAZING},
    {"irradiance, sphere", "gap 1e-6 R", HARD_SPHERE_E, 1e-6, SHAPE_TOUCHING},
    {"irradiance, square", "size 1", HARD_SQUARE_E, 1, SHAPE_ANY},
    {"irradiance, square", "size 1e-3", HARD_SQUARE_E, 1e-3, SHAPE_ANY},
    {"irradiance, square", "size 1e-6", HARD_SQUARE_E, 1e-6, SHAPE_ANY},
    {"irradiance, square", "1e-5 above the horizon", HARD_SQUARE_E, 1e-5, SHAPE_GRAZING},
    {"irradiance, square", "gap 1e-6 to the floor", HARD_SQUARE_E, 1e-6, SHAPE_TOUCHING},
};
enum { hard_cases = sizeof hard_list / sizeof *hard_list };

static inline real hard_between(random_stream *s, double lo, double hi)
{
    return (real)(lo + (hi - lo) * (double)random_next(s));
}

static inline vec3 hard_point(random_stream *s, double size)
{
    real x = hard_between(s, -size, size), y = hard_between(s, -size, size);
    return (vec3){x, y, hard_between(s, -size, size)};
}

/* Seen from the origin, the surface being the plane z = 0. */
static inline hard_input hard_make(const hard_case *c, random_stream *s)
{
    hard_input h = {.kind = c->kind, .s.r = 1};
    real d = (real)(1 / c->size), gap = (real)c->size;
    real turn = hard_between(s, 0, 6), spread = hard_between(s, 0.5, 1);
    if (c->shape != SHAPE_ANY) d = c->shape == SHAPE_TOUCHING ? 1 + gap * spread : 10 * spread;
    if (c->kind == HARD_SPHERE_ANGLE) h.s.c = vscale((vec3){cos(turn), sin(turn), 0}, d * spread);
    if (c->kind == HARD_SPHERE_ANGLE && c->shape == SHAPE_TOUCHING) h.s.c = (vec3){0, d, 0};
    if (c->kind == HARD_SPHERE_E) h.s.c = (vec3){d, 0, hard_between(s, -0.9, 0)};
    if (c->kind == HARD_SPHERE_E && c->shape == SHAPE_GRAZING) h.s.c.z = -1 + gap;
    if (c->kind == HARD_TRIANGLE_ANGLE) {
        real size = c->shape == SHAPE_GRAZING ? 1 : (real)c->size;
        vec3 a = {hard_between(s, 1, 2), hard_between(s, -1, 1), hard_between(s, -1, 1)};
        h.t = (triangle){a, vadd(a, hard_point(s, (double)size)), vadd(a, hard_point(s, (double)size))};
        if (c->shape == SHAPE_GRAZING) h.t.a.z = h.t.b.z = h.t.c.z = gap;
    }
    if (c->kind != HARD_SQUARE_E) return h;
    real size = c->shape == SHAPE_ANY ? (real)c->size : 1, x = hard_between(s, 1, 2), z = gap;
    if (c->shape == SHAPE_ANY) z = hard_between(s, 0.2, 1);
    if (c->shape == SHAPE_GRAZING) z = gap - size;  /* upright: nearly all of it below */
    vec3 o = {x, hard_between(s, -0.9, -0.1) * size, z};
    rectangle r = {o, {0, 0, size}, {0, size, 0}};
    if (c->shape == SHAPE_TOUCHING) r = (rectangle){{-spread, o.y, z}, {0, 1, 0}, {1, 0, 0}};
    h.v[0] = r.o, h.v[1] = vadd(r.o, r.s), h.v[2] = vadd(h.v[1], r.t), h.v[3] = vadd(r.o, r.t);
    return h;
}

static inline double hard_exact(const hard_input *h)
{
    switch (h->kind) {
    case HARD_SPHERE_ANGLE: {  /* 2 pi sin^2 / (1 + cos) */
        wide dd = wide3_dot(wide3_of(h->s.c), wide3_of(h->s.c)), one_wide = wide_of(1);
        wide cosine = wide_sqrt(wide_div(wide_sub(dd, one_wide), dd));
        wide q = wide_div(wide_div(one_wide, dd), wide_add(one_wide, cosine));
        return 2 * 3.14159265358979324 * wide_value(q);
    }
    case HARD_TRIANGLE_ANGLE: return triangle_solid_angle_exact(h->t, here);
    case HARD_SPHERE_E:
        return sphere_irradiance_exact((double)h->s.r, (double)h->s.c.x, (double)h->s.c.z);
    case HARD_SQUARE_E: return polygon_irradiance_exact(h->v, 4, here);
    }
    return 0;
}

/* Variant 0: naive; 1: the formula of chapter 07; 2: the default. */
static inline real hard_value(const hard_input *h, int variant)
{
    const triangle *t = &h->t;
    switch (h->kind) {
    case HARD_SPHERE_ANGLE:
        return variant ? sphere_solid_angle(h->s, here) : sphere_solid_angle_naive(h->s, here);
    case HARD_TRIANGLE_ANGLE:
        return variant == 0 ? triangle_solid_angle_girard(*t, here)
             : variant == 1 ? (real)solid_angle(t->a, t->b, t->c) : triangle_solid_angle(*t, here);
    case HARD_SPHERE_E:
        return variant ? sphere_irradiance(h->s, here, up) : sphere_irradiance_naive(h->s, here, up);
    case HARD_SQUARE_E:
        return variant ? polygon_irradiance(h->v, 4, here, up)
                       : polygon_irradiance_naive(h->v, 4, here, up);
    }
    return 0;
}

static inline bool hard_has(hard_kind k, int variant) { return variant != 1 || k == HARD_TRIANGLE_ANGLE; }

typedef struct { hard_input in[hard_inputs]; int variant; } hard_run;

static inline double run_hard(void *context)
{
    const hard_run *r = context;
    real sum = 0;
    for (int i = 0; i < hard_inputs; i++) sum += hard_value(&r->in[i], r->variant);
    return (double)sum;
}

/* The largest relative error of a variant over the inputs; a NaN stays. */
static inline double hard_error(const hard_run *r, int variant)
{
    double worst = 0;
    for (int i = 0; i < hard_inputs; i++) {
        double exact = hard_exact(&r->in[i]);
        double off = fabs(((double)hard_value(&r->in[i], variant) - exact) / exact);
        if (!(off <= worst)) worst = off;
    }
    return worst;
}

static inline void hard_fill(hard_run *r, const hard_case *c, uint64_t seed)
{
    for (int i = 0; i < hard_inputs; i++) {
        random_stream s = random_start(seed, (uint64_t)(c - hard_list), (uint64_t)i);
        r->in[i] = hard_make(c, &s);
    }
}

static inline void measure_hard(const options *o)
{
    table t = table_new("Hard cases: largest relative error in 256 inputs, and time of one",
                        "quantity|case|error naive|error as in 07|error default|time naive [ns]|"
                        "time as in 07 [ns]|time default [ns]");
    hard_run *r = allocate(most_variants, sizeof *r);
    for (int k = 0; k < hard_cases; k++) {
        const hard_case *c = &hard_list[k];
        clock_variant v[most_variants];
        for (int i = 0; i < most_variants; i++) {
            hard_fill(&r[i], c, o->seed), r[i].variant = i;
            v[i] = (clock_variant){"", run_hard, &r[i], 0};
        }
        clock_compare(v, most_variants, o->quick ? 3 : 21);
        table_text(&t, "%s", c->name), table_text(&t, "%s", c->input);
        for (int i = 0; i < 2 * most_variants; i++) {
            if (!hard_has(c->kind, i % most_variants)) table_text(&t, "-");
            else if (i < most_variants) table_number(&t, hard_error(&r[0], i));
            else table_number(&t, v[i - most_variants].seconds / hard_inputs * 1e9);
        }
    }
    output_extra_table(o, &t);
    free(r);
}

/* Error against size, for the naive forms and the defaults. */
static inline void plot_hard(const options *o)
{
    static const struct { const char *name; hard_kind kind; int variant; } lines[] = {
        {"triangle, Girard", HARD_TRIANGLE_ANGLE, 0}, {"triangle, as in 07", HARD_TRIANGLE_ANGLE, 1},
        {"triangle, default", HARD_TRIANGLE_ANGLE, 2}, {"sunk sphere, naive", HARD_SPHERE_E, 0},
        {"sunk sphere, default", HARD_SPHERE_E, 2}, {"square, naive", HARD_SQUARE_E, 0},
        {"square, default", HARD_SQUARE_E, 2}};
    plot p = plot_new("Solid angle of a triangle, irradiance of a sphere and a square", "size/distance",
                      "largest relative error", PLOT_LOG_X | PLOT_LOG_Y);
    hard_run *r = allocate(1, sizeof *r);
    for (size_t k = 0; k < sizeof lines / sizeof *lines; k++) {
        int series = plot_series(&p, lines[k].name);
        for (int e = 0; e <= (real_is_float ? 12 : 24); e++) {
            hard_case c = {"", "", lines[k].kind, pow(10, -0.25 * e), SHAPE_ANY};
            for (int i = 0; i < hard_inputs; i++) {
                random_stream s = random_start(o->seed, 99, (uint64_t)i);
                r->in[i] = hard_make(&c, &s);
            }
            if (lines[k].kind == HARD_SPHERE_E && e < 1) continue;  /* d = R: touching */
            plot_add(&p, series, c.size, hard_error(r, lines[k].variant));
        }
    }
    output_plot(o, &p, "22_radiometry_hard.svg");
    free(r);
}

/* ---- watts and lumens ---- */

static inline void photometry_row(table *t, const char *what, double efficacy, double watts,
                                  const char *unit, const char *photometric)
{
    table_text(t, "%s", what), table_number(t, efficacy), table_number(t, watts);
    table_text(t, "%s", unit), table_number(t, watts * efficacy), table_text(t, "%s", photometric);
}

static inline void measure_photometry(const options *o)
{
    double worst = 0;
    for (int i = 0; i < efficiencies; i++) {
        double nm = efficiency_first + efficiency_step * i;
        double off = fabs(luminous_efficiency_fit(nm) - efficiency_table[i]);
        if (off > worst) worst = off;
    }
    black_body_light lamp_2800 = black_body(2800), sun = black_body(5772);
    black_body_light platinum = black_body(2041.4);
    double disk = (double)pi / 4 * 0.00930 * 0.00930;  /* the sun's disk: 0.00930 rad wide */
    char title[160];
    snprintf(title, sizeof title, "The same light in watts and in lumens (the fit of V is off by at "
             "most %.4f)", worst);
    table t = table_new(title, "light|efficacy [lm/W]|radiometric|unit|photometric|unit ");
    double k555 = lumens_per_watt * luminous_efficiency(555);
    photometry_row(&t, "1 W at 555 nm", k555, 1, "W", "lm");
    photometry_row(&t, "1 W at 650 nm", lumens_per_watt * luminous_efficiency(650), 1, "W", "lm");
    photometry_row(&t, "glowing wire, 2800 K: flux", lamp_2800.efficacy, 60, "W", "lm");
    photometry_row(&t, "- intensity, the same all round", lamp_2800.efficacy, 60 / four_pi(), "W/sr",
                   "cd");
    photometry_row(&t, "- irradiance at 2 m", lamp_2800.efficacy, 60 / four_pi() / 4, "W/m^2", "lx");
    photometry_row(&t, "- radiance of the wire", lamp_2800.efficacy, lamp_2800.radiance,
                   "W/(m^2 sr)", "nit");
    photometry_row(&t, "platinum freezing, 2041.4 K", platinum.efficacy, platinum.radiance,
                   "W/(m^2 sr)", "nit");
    photometry_row(&t, "sun, 5772 K: radiance", sun.efficacy, sun.radiance, "W/(m^2 sr)", "nit");
    photometry_row(&t, "- irradiance above the air", sun.efficacy, sun.radiance * disk, "W/m^2",
                   "lx");
    output_extra_table(o, &t);
}

#endif
