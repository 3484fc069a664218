/* point_lights.h: an area light as k point lights (面光源视为无数个点光源), k = 1, 4, 16 ..
 *
 *   measure_points(&o);   a table: error against k, where the whole lamp is seen and where a part
 *                         of it is; beside it k random points
 *
 * Truth: where the whole lamp is seen, the closed form of 22; else survey.h's reference.
 */
#ifndef DIRECT_POINT_LIGHTS_H
#define DIRECT_POINT_LIGHTS_H

#include "survey.h"

/* ---------------------------------------------------------------------------------------------- */

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
        truth = grey(vscale(vmul(p->h.m->f.diffuse, cornell_radiance), E));
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

#endif
