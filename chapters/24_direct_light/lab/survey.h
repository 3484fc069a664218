/* survey.h: several ways of drawing at many points: error, rays, time.
 *
 *   direct_survey s;
 *   survey_open(&s, o, STAGE_FIRST, across, reference);  points, and the truth at each
 *   survey_measure(&s, o);            s.error[way][level] at 1, 4, 16, 64, 256 samples, all of them
 *                                     with --full, else at 64; s.seconds[way] of one sample
 *   survey_close(&s);
 *
 * A way is a direct_way, or survey_first: first.h's, by points of the lamp; s.ways of them, so that
 * only STAGE_FIRST has the last. It is asked at the same points, about the same light.
 *
 * Errors: root of the mean square of (estimate - truth) / (truth + mean truth), over a grid of
 * points that the camera sees; so neither the brightest nor the darkest points decide alone. A
 * sample chooses one of several lights, each as likely. Reference: by lights or both, on all
 * lights, with many well-spread samples. Times are those of one thread, ways in turn (bench.h).
 */
#ifndef DIRECT_SURVEY_H
#define DIRECT_SURVEY_H

#include "../../../common/lab/bench.h"
#include "pictures.h"

enum { survey_levels = 5, survey_points = 20, survey_brief = 3 };  /* 64 samples */
static inline uint32_t survey_samples(int level) { return (uint32_t)1 << 2 * level; }

enum { survey_first = direct_ways, survey_ways };

typedef struct { lit_hit h; vec3 wo; first_point x; double truth; } seen_point;

typedef struct {
    direct_stage g;
    first_scene first, open;     /* of STAGE_FIRST; open: nothing hides its lamp */
    int ways;
    seen_point *point;
    size_t points;
    double mean;
    uint64_t seed;
    uint32_t reference;
    direct_way best;
    bool full;                   /* else 64 samples alone */
    lit_lights all, one;
    double error[survey_ways][survey_levels], seconds[survey_ways];  /* of one sample */
    direct_work work[survey_ways][survey_levels];
} direct_survey;

/* ---------------------------------------------------------------------------------------------- */

static inline double grey(vec3 c) { return (double)(c.x + c.y + c.z) / 3; }

/* Irradiance over radiance of a rectangle whose front p sees whole, above the horizon: Lambert's
 * sum over its edges (22.15). */
static inline real whole_irradiance(rectangle r, vec3 p, vec3 n)
{
    vec3 a = vsub(r.o, p), b = vadd(a, r.s), v[4] = {a, b, vadd(b, r.t), vadd(a, r.t)};
    real sum = 0;
    for (int i = 0; i < 4; i++) {
        vec3 edge = vcross(v[i], v[(i + 1) % 4]);
        sum -= atan2(vlength(edge), vdot(v[i], v[(i + 1) % 4])) * vdot(n, vunit(edge));
    }
    return sum / 2;
}

/* The mean of n samples at point i; of random numbers those of number `pixel`. first.h chooses its
 * points by the numbers of pair 1 (direct.h), as DIRECT_AREA does. */
static inline double survey_estimate(const direct_survey *s, int way, const lit_lights *l,
                                     sequence_kind sequence, size_t i, uint64_t pixel, uint32_t n,
                                     uint64_t seed, direct_work *work)
{
    const seen_point *p = &s->point[i];
    direct d = {&s->g.s, (direct_way)way, l, work, false};
    double sum = 0;
    for (uint32_t k = 0; k < n; k++) {
        if (way == survey_first) {
            random_stream random = random_start(seed, pixel, k);
            random.dimension = 2;
            sum += grey(first_direct_by_lamp(&s->first, 0, p->x, &random));
        } else {
            sampler q = sampler_start(sequence, seed, pixel, k, n);
            sum += grey(direct_light(&d, &p->h, p->wo, &q));
        }
    }
    return sum / n;
}

/* The rays of survey_first, which has the points of DIRECT_AREA: where nothing hides the lamp a
 * point of it brings light if, and only if, a shadow ray is sent to it. */
static inline void survey_first_rays(const direct_survey *s, size_t i, uint64_t pixel, uint32_t n,
                                     direct_work *work)
{
    for (uint32_t k = 0; k < n; k++) {
        random_stream random = random_start(s->seed, pixel, k);
        random.dimension = 2;
        work->samples++;
        work->shadow += !vzero(first_direct_by_lamp(&s->open, 0, s->point[i].x, &random));
    }
}

static inline void survey_reference(size_t i, void *context)
{
    direct_survey *s = context;
    direct_work work = {0, 0, 0};
    s->point[i].truth = survey_estimate(s, (int)s->best, &s->all, SEQUENCE_SOBOL, i, i,
                                        s->reference, s->seed + 1, &work);
}

static inline void survey_job(size_t job, void *context)
{
    direct_survey *s = context;
    int level = survey_levels - 1 - (int)job / s->ways, way = (int)job % s->ways;
    double square = 0;
    size_t runs = level < survey_brief ? 8 : level == survey_brief ? 2 : 1;
    if (!s->full && level != survey_brief) return;
    for (size_t i = 0; i < runs * s->points; i++) {
        size_t k = i % s->points;
        double truth = s->point[k].truth;
        direct_work *work = &s->work[way][level];
        double x = survey_estimate(s, way, &s->one, SEQUENCE_RANDOM, k, i, survey_samples(level),
                                   s->seed, work);
        if (way == survey_first) survey_first_rays(s, k, i, survey_samples(level), work);
        double off = (x - truth) / (truth + s->mean);
        square += off * off;
    }
    s->error[way][level] = sqrt(square / (double)(runs * s->points));
}

typedef struct { const direct_survey *s; int way; } survey_run;
enum { survey_timed_samples = 16 };
static inline double survey_timed(void *context)
{
    const survey_run *r = context;
    double sum = 0;
    direct_work work = {0, 0, 0};
    for (size_t i = 0; i < r->s->points; i++)
        sum += survey_estimate(r->s, r->way, &r->s->one, SEQUENCE_RANDOM, i, i,
                               survey_timed_samples, r->s->seed, &work);
    return sum;
}

/* What the camera sees at the middle of across x down pixels, but for lights; and the truth. */
static inline void survey_open(direct_survey *s, const options *o, direct_stage_name name,
                               int across, uint32_t reference)
{
    *s = (direct_survey){.seed = o->seed, .reference = o->quick ? 64 : reference, .full = o->full,
                         .best = name == STAGE_PLATES ? DIRECT_POWER : DIRECT_ANGLE,
                         .first = first_cornell(),
                         .ways = name == STAGE_FIRST ? survey_ways : direct_ways};
    s->open = s->first, s->open.eps = 1;  /* a shadow ray from 1 to 0 of the way */
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
        hit h;
        if (name == STAGE_FIRST && first_scene_hit(&s->first, r, &h))
            p->x = first_point_at(&s->first, r, h);
        s->points++;
    }
    lit_lights_of(&s->g.s, NULL, LIGHTS_ALL, &s->all);
    lit_lights_of(&s->g.s, NULL, LIGHTS_UNIFORM, &s->one);
    parallel_whole(s->points, o->threads, "reference", survey_reference, s);
    for (size_t i = 0; i < s->points; i++) s->mean += s->point[i].truth / (double)s->points;
}

static inline void survey_measure(direct_survey *s, const options *o)
{
    survey_run run[survey_ways];
    parallel_whole((size_t)(s->ways * survey_levels), o->threads, "samples", survey_job, s);
    for (int k = 0; k < s->ways; k++) run[k] = (survey_run){s, k};
    double samples = (double)s->points * survey_timed_samples;
    bench_each(survey_timed, run, sizeof *run, s->ways, o->full ? 5 : 1, 1 / samples, s->seconds);
}

static inline void survey_close(direct_survey *s)
{
    lit_lights_free(&s->all), lit_lights_free(&s->one);
    free(s->point);
    lit_free(&s->g.s);
}

#endif
