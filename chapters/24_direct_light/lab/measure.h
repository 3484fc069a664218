/* measure.h: error against time for every way of drawing.
 *
 *   measure_ways(o)     main table: all ways and first.h's, box and plates; --full: a plot
 *   measure_near(o)     a light closer and closer: second moment by area, and what one sees of it
 */
#ifndef DIRECT_MEASURE_H
#define DIRECT_MEASURE_H

#include "../../../common/numbers/estimate.h"
#include "survey.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void plot_plates(const direct_survey *s, const options *o)
{
    plot p = plot_new("Four plates, four spheres", "time a point [us]", "error RMSE [1]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < direct_ways; k++) {
        int a = plot_series(&p, direct_name[k]);
        for (int level = 0; level < survey_levels; level++)
            plot_add(&p, a, 1e6 * s->seconds[k] * survey_samples(level), s->error[k][level]);
    }
    plot_slope(&p, -0.5, "slope -1/2");
    output_plot(o, &p, "24_direct_light_plates_time.svg");
}

static inline void measure_ways(const options *o)
{
    table t = table_new("Eight ways and the short book's, 64 samples a point",
                        "way|rays|error in the box [1]|time [us]|error at the plates [1]|"
                        "time [us]");
    direct_survey s[2];
    survey_open(&s[0], o, STAGE_FIRST, survey_points, 2048);
    survey_open(&s[1], o, STAGE_PLATES, survey_points, 1024);
    for (int i = 0; i < 2; i++) survey_measure(&s[i], o);
    for (int k = 0; k < survey_ways; k++) {
        table_text(&t, "%s", k == survey_first ? "first" : direct_name[k]);
        table_text(&t, k == survey_first ? "-" : "%.3g", survey_rays(&s[0], k));
        for (int i = 0; i < 2; i++) {
            if (k >= s[i].ways) {
                table_text(&t, "-"), table_text(&t, "-");
                continue;
            }
            table_number(&t, s[i].error[k][survey_brief]);
            table_number(&t, 1e6 * s[i].seconds[k]);
        }
    }
    output_table(o, &t);
    if (o->full) plot_plates(&s[1], o);
    survey_close(&s[0]), survey_close(&s[1]);
}

/* ---- a light closer and closer ---- */

/* The variance that n samples show: one light, a matte white point at the origin, facing +z. */
static inline double variance_seen(const emitter *e, direct_way way, uint32_t n, uint64_t seed)
{
    lit_scene s;
    lit_begin(&s);
    lit_material matte = {.f = brdf_lambert((vec3){1, 1, 1})};
    lit_add_rectangle(&s, e->rectangle, lit_add_material(&s, (lit_material){.Le = e->Le}));
    lit_end(&s);
    lit_lights l;
    lit_lights_of(&s, NULL, LIGHTS_ALL, &l);
    direct_work work = {0, 0, 0};
    direct d = {&s, way, &l, &work, false};
    vec3 up = {0, 0, 1};
    lit_hit h = {{{0, 0, 0}, up, up, 0, 0, no_shape}, &matte, lit_dark, 1, true, false};
    estimate x = {0};
    for (uint32_t k = 0; k < n; k++) {
        sampler q = sampler_start(SEQUENCE_RANDOM, seed, 0, k, n);
        x = estimate_add(x, grey(direct_light(&d, &h, up, &q)));
    }
    lit_lights_free(&l), lit_free(&s);
    return estimate_variance(x);
}

/* A wall that shines, on the floor at the distance h. E[X^2] of samples by area = integral of
 * (f cos)^2 / pdf_area dw: by points drawn by angle, where what is summed stays small. */
static inline void measure_near(const options *o)
{
    const vec3 white = {1, 1, 1}, p = {0, 0, 0};
    table t = table_new("A shining wall on the floor: variance of a sample by area and by angle",
                        "distance|mean|by area|by area as seen in 20000|by angle");
    for (int i = 0; i < 5; i++) {
        double h = pow(10, -i);
        rectangle r = {vec(h, -1, 0), {0, 0, 2}, {0, 2, 0}};
        emitter e = emitter_of_rectangle(r, white);
        double second = 0, mean = (double)(whole_irradiance(r, p, (vec3){0, 0, 1}) / pi);
        uint32_t n = o->quick ? 1000 : 100000, seen = o->quick ? 1000 : 20000;
        for (uint32_t k = 0; k < n; k++) {
            sampler s = sampler_start(SEQUENCE_SOBOL, o->seed, 0, k, n);
            emitter_point x;
            if (!emitter_by_angle(&e, p, sampler_pair(&s), &x)) continue;
            double c = (double)(x.wi.z / pi);
            second += c * c / (double)(emitter_pdf_area(&e, p, x.s.p) * x.pdf) / n;
        }
        table_number(&t, h), table_number(&t, mean), table_number(&t, second - mean * mean);
        table_number(&t, variance_seen(&e, DIRECT_AREA, seen, o->seed));
        table_number(&t, variance_seen(&e, DIRECT_ANGLE, seen, o->seed));
    }
    output_extra_table(o, &t);
}

#endif
