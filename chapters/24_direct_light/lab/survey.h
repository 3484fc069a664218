/* survey.h: several ways of drawing at many points: error, rays, time, efficiency.
 *
 *   direct_survey s;
 *   survey_open(&s, o, STAGE_BOX, across, reference);    points, and the truth at each
 *   s.entries = 2, s.entry[0] = ...;                     the ways; those of first.h: STAGE_FIRST
 *   survey_measure(&s, o, least);     error at 1, 4, 16, 64, 256 samples, from level `least` on to
 *                                     64, of least 0 to 256; time of one sample
 *   survey_row(&s, k, &table), s.error[k][level], s.seconds[k]
 *   survey_close(&s);
 *
 *   efficiency = 1 / (variance of one sample * its time)                                  (24.11)
 *
 * Errors: root of the mean square of (estimate - truth) / (truth + mean truth), over a grid of
 * points that the camera sees; so neither the brightest nor the darkest points decide alone.
 * Variance: the same. Reference: by lights or both, on all lights, with many well-spread samples.
 * Times are those of one thread, ways in turn (bench.h).
 */
#ifndef DIRECT_SURVEY_H
#define DIRECT_SURVEY_H

#include "../../../common/lab/bench.h"
#include "pictures.h"

enum { WAY_FIRST_DIRECTION = direct_ways, WAY_FIRST_LAMP };
enum { survey_levels = 5, survey_most = 9, survey_points = 20, survey_time_level = 3 };
static inline uint32_t survey_samples(int level) { return (uint32_t)1 << 2 * level; }

typedef struct { lit_hit h; vec3 wo; double truth; } seen_point;
typedef struct { int way; lit_lights_rule kind; sequence_kind sequence; } survey_entry;

typedef struct {
    direct_stage g;
    seen_point *point;
    size_t points;
    double mean;
    uint64_t seed;
    uint32_t reference;
    survey_entry best, entry[survey_most];
    int entries, levels;
    lit_lights choice[LIGHTS_FLUX + 1];
    double error[survey_most][survey_levels], seconds[survey_most];  /* of one sample */
    direct_work work[survey_most][survey_levels];
} direct_survey;

/* ---------------------------------------------------------------------------------------------- */

static inline double grey(vec3 c) { return (double)(c.x + c.y + c.z) / 3; }

/* By first.h. It has no counters: a shadow ray is one that brings something from a lamp alone. */
static inline double survey_first(const first_scene *f, int way, const seen_point *p,
                                  uint64_t pixel, uint32_t n, uint64_t seed, direct_work *work)
{
    static const first_material none;
    first_point x = {p->h.s.p, p->h.s.n, p->wo, false, &none, brdf_albedo(&p->h.m->f, 1)};
    first_scene alone = {.thing = {f->thing[0]}, .things = 1, .eps = f->eps};
    double sum = 0;
    for (uint32_t k = 0; k < n; k++) {
        random_stream a = random_start(seed, pixel, k), b = a;
        if (way == WAY_FIRST_LAMP) sum += grey(first_direct_by_lamp(f, 0, x, &a));
        else sum += grey(first_direct_by_direction(f, x, &a));
        if (!work) continue;
        work->samples++;
        if (way != WAY_FIRST_LAMP) work->direction++;
        else work->shadow += !vzero(first_direct_by_lamp(&alone, 0, x, &b));
    }
    return sum / n;
}

/* work may be NULL in the ways of first.h. */
static inline double survey_estimate(const direct_survey *s, survey_entry e, const seen_point *p,
                                     uint64_t pixel, uint32_t n, uint64_t seed, direct_work *work)
{
    if (e.way >= (int)direct_ways)
        return survey_first(&s->g.first, e.way, p, pixel, n, seed, work);
    direct d = {&s->g.s, (direct_way)e.way, &s->choice[e.kind], work, false};
    double sum = 0;
    for (uint32_t k = 0; k < n; k++) {
        sampler q = sampler_start(e.sequence, seed, pixel, k, n);
        sum += grey(direct_light(&d, &p->h, p->wo, &q));
    }
    return sum / n;
}

static inline void survey_reference(size_t i, void *context)
{
    direct_survey *s = context;
    direct_work work = {0, 0, 0};
    seen_point *p = &s->point[i];
    p->truth = survey_estimate(s, s->best, p, i, s->reference, s->seed + 1, &work);
}

static inline void survey_job(size_t job, void *context)
{
    direct_survey *s = context;
    int level = s->levels - 1 - (int)job / s->entries, k = (int)job % s->entries;
    double square = 0;
    size_t runs = level < survey_time_level ? 8 : level == survey_time_level ? 2 : 1;
    for (size_t i = 0; i < runs * s->points; i++) {
        const seen_point *p = &s->point[i % s->points];
        double x = survey_estimate(s, s->entry[k], p, i, survey_samples(level), s->seed,
                                   &s->work[k][level]);
        double off = (x - p->truth) / (p->truth + s->mean);
        square += off * off;
    }
    s->error[k][level] = sqrt(square / (double)(runs * s->points));
}

typedef struct { direct_survey *s; int k; } survey_run;
static inline double survey_timed(void *context)
{
    survey_run *r = context;
    double sum = 0;
    direct_work work = {0, 0, 0};
    survey_entry e = r->s->entry[r->k];
    for (size_t i = 0; i < r->s->points; i++)
        sum += survey_estimate(r->s, e, &r->s->point[i], i, survey_samples(survey_time_level),
                               r->s->seed, e.way >= (int)direct_ways ? NULL : &work);
    return sum;
}

/* What the camera sees at the middle of across x down pixels, but for lights; and the truth. */
static inline void survey_open(direct_survey *s, const options *o, direct_stage_name name,
                               int across, uint32_t reference)
{
    *s = (direct_survey){.seed = o->seed, .reference = o->quick ? 64 : reference};
    s->best = (survey_entry){DIRECT_ANGLE, LIGHTS_ALL, SEQUENCE_SOBOL};
    if (name == STAGE_PLATES) s->best.way = DIRECT_POWER;
    stage_open(name, &s->g);
    if (o->quick) across = 6;
    int down = (int)((real)across / s->g.aspect);
    s->point = allocate((size_t)across * (size_t)down, sizeof *s->point);
    for (int i = 0; i < across * down; i++) {
        seen_point *p = &s->point[s->points];
        ray r = camera_ray(s->g.c, (real)(i % across) + (real)0.5, (real)(i / across) + (real)0.5,
                           across, down);
        if (!lit_trace(&s->g.s, r, &p->h) || p->h.emitter != lit_dark) continue;
        p->wo = vneg(vunit(r.d));
        s->points++;
    }
    for (int k = 0; k <= LIGHTS_FLUX; k++)
        lit_lights_of(&s->g.s, NULL, (lit_lights_rule)k, &s->choice[k]);
    parallel_whole(s->points, o->threads, "reference", survey_reference, s);
    for (size_t i = 0; i < s->points; i++) s->mean += s->point[i].truth / (double)s->points;
}

static inline void survey_measure(direct_survey *s, const options *o, int least)
{
    survey_run run[survey_most];
    s->levels = least ? survey_time_level + 1 : survey_levels;
    parallel_whole((size_t)s->entries * (size_t)(s->levels - least), o->threads, "samples",
                   survey_job, s);
    for (int k = 0; k < s->entries; k++) run[k] = (survey_run){s, k};
    double samples = (double)s->points * survey_samples(survey_time_level);
    bench_each(survey_timed, run, sizeof *run, s->entries, o->quick ? 1 : 3, 1 / samples,
               s->seconds);
}

static inline void survey_close(direct_survey *s)
{
    for (int k = 0; k <= LIGHTS_FLUX; k++) lit_lights_free(&s->choice[k]);
    free(s->point);
    stage_close(&s->g);
}

/* Rays of one sample. */
static inline double survey_rays(const direct_survey *s, int k)
{
    direct_work w = s->work[k][survey_time_level];
    return (double)(w.shadow + w.direction) / (double)w.samples;
}

/* Rays, errors of 16 and of 64 samples, time of one; efficiency (24.11). */
static inline void survey_row(const direct_survey *s, int k, table *t)
{
    double n = survey_samples(survey_time_level), error = s->error[k][survey_time_level];
    table_number(t, survey_rays(s, k)), table_number(t, s->error[k][2]), table_number(t, error);
    table_number(t, 1e6 * s->seconds[k]);
    table_number(t, 1 / (error * error * n * 1e6 * s->seconds[k]));
}

#endif
