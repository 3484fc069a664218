/* measure.h: error against time for every way of drawing.
 *
 *   measure_ways(o)     main table: ways, box and plates; --full: a plot of all at the plates
 *   measure_points(o)   the lamp as k point lights (面光源视为无数个点光源), k = 1, 4, 16 ..: error,
 *                       where all of it is seen and where a part is; beside it k random points.
 *                       Truth: the closed form of 22, or survey.h's reference
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

/* s: box, plates; the plates do not have first.h's way. */
static inline void ways_row(table *t, const direct_survey s[2], int way)
{
    direct_work w = s[0].work[way][survey_brief];
    table_text(t, "%s", way == survey_first ? "first" : direct_name[way]);
    table_number(t, (double)(w.shadow + w.direction) / (double)w.samples);
    for (int i = 0; i < 2; i++) {
        if (way >= s[i].ways) {
            table_text(t, "-"), table_text(t, "-");
            continue;
        }
        table_number(t, s[i].error[way][survey_brief]);
        table_number(t, 1e6 * s[i].seconds[way]);
    }
}

/* Errors and times of the two heuristics are alike: the table has one, the plot both. */
static inline void measure_ways(const options *o)
{
    direct_survey s[2];
    table t = table_new("Seven ways and the short book's, 64 samples a point",
                        "way|rays|error in the box [1]|time [us]|error at the plates [1]|"
                        "time [us]");
    survey_open(&s[0], o, STAGE_FIRST, survey_points, 2048);
    survey_open(&s[1], o, STAGE_PLATES, survey_points, 1024);
    for (int i = 0; i < 2; i++) survey_measure(&s[i], o);
    for (int k = 0; k < survey_ways; k++)
        if (k != DIRECT_BALANCE) ways_row(&t, s, k);
    output_table(o, &t);
    if (o->full) plot_plates(&s[1], o);
    survey_close(&s[0]), survey_close(&s[1]);
}

/* ---- a lamp as k point lights ---- */

enum { points_levels = 6, points_ways = 4 };  /* 1, 4 .. 1024; wholly and partly seen, two ways */
typedef struct {
    double square[points_levels][2];          /* errors squared, by the grid and at random */
    int part;                                 /* 0: sees the whole lamp, 1: a part, 2: nothing */
} points_errors;
typedef struct { const direct_survey *s; points_errors *at; } points_survey;

static inline void points_job(size_t i, void *context)
{
    const points_survey *v = context;
    const direct_survey *s = v->s;
    const seen_point *p = &s->point[i];
    direct_work work = {0, 0, 0};
    direct d = {&s->g.s, DIRECT_AREA, &s->all, &work, false};
    double truth = p->truth;
    uint32_t seen;
    (void)point_lights(&d, &p->h, p->wo, 64, &seen);
    v->at[i].part = seen == 64 * 64 ? 0 : seen ? 1 : 2;
    if (v->at[i].part == 0) {
        rectangle lamp = {cornell_corner, cornell_side_s, cornell_side_t};
        real E = whole_irradiance(lamp, p->h.s.p, p->h.s.n) / pi;
        truth = grey(vscale(vmul(p->h.m->kd, cornell_radiance), E));
    }
    for (int k = 0; k < points_levels && v->at[i].part < 2; k++) {
        double L[2] = {grey(point_lights(&d, &p->h, p->wo, 1u << k, &seen)),
                       survey_estimate(s, DIRECT_AREA, &s->all, SEQUENCE_RANDOM, i, i, 1u << 2 * k,
                                       s->seed, &work)};
        for (int way = 0; way < 2; way++)
            v->at[i].square[k][way] = pow((L[way] - truth) / (truth + s->mean), 2);
    }
}

static inline void measure_points(const options *o)
{
    direct_survey s;
    table t = table_new("A lamp as k point lights: relative error, Cornell box",
                        "k|whole lamp seen: a grid [1]|random points [1]|a part seen: a grid [1]|"
                        "random points [1]");
    survey_open(&s, o, STAGE_BOX, 48, 4096);
    points_survey v = {&s, allocate(s.points, sizeof *v.at)};
    parallel_whole(s.points, o->threads, "point lights", points_job, &v);
    for (int k = 0; k < points_levels; k++) {
        table_count(&t, (size_t)1 << 2 * k);
        for (int way = 0; way < points_ways; way++) {
            double sum = 0, n = 0;
            for (size_t i = 0; i < s.points; i++)
                if (v.at[i].part == way / 2) sum += v.at[i].square[k][way % 2], n++;
            table_number(&t, sqrt(sum / (n > 0 ? n : 1)));
        }
    }
    output_extra_table(o, &t);
    free(v.at), survey_close(&s);
}

/* ---- a light closer and closer ---- */

/* The variance that n samples show, of a matte white point at the origin that faces +z. */
static inline double variance_seen(const emitter *e, bool by_angle, uint32_t n, uint64_t seed)
{
    const vec3 p = {0, 0, 0};
    estimate sum = {0};
    for (uint32_t k = 0; k < n; k++) {
        sampler s = sampler_start(SEQUENCE_RANDOM, seed, 0, k, n);
        (void)sampler_pair(&s);  /* of a direction, which no way here draws */
        point2 u = sampler_pair(&s);
        emitter_point x;
        bool some = by_angle ? emitter_by_angle(e, p, u, &x) : emitter_by_area(e, p, u, &x);
        sum = estimate_add(sum, some ? (double)(real_max(x.wi.z, 0) / pi / x.pdf) : 0);
    }
    return estimate_variance(sum);
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
        table_number(&t, variance_seen(&e, false, seen, o->seed));
        table_number(&t, variance_seen(&e, true, seen, o->seed));
    }
    output_extra_table(o, &t);
}

#endif
