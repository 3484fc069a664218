/* dome_picture.h: a ball on a floor under a white sky, by 16 directions a pixel, three times.
 *
 *   draw_dome(&o);     20_monte_carlo_sky.png: uniform directions, directions by the cosine, and
 *                      the same from Sobol's points; above each its error
 *
 * A place receives (1/pi) integral of cos theta over the sky that it sees. The truth is known: the
 * floor loses R^2 cos / d^2 to a ball at distance d, here 1 / d^3, and a place of the ball whose
 * normal is n sees (1 + n.z) / 2.
 */
#ifndef MONTE_CARLO_DOME_PICTURE_H
#define MONTE_CARLO_DOME_PICTURE_H

#include "../../03_sphere/first.h"
#include "../../../common/lab/label.h"
#include "../../../common/output.h"
#include "../../../common/parallel.h"
#include "../sampler.h"
#include "../first.h"

enum { dome_wide = 400, dome_high = 300, dome_gap = 6, dome_panels = 3, dome_samples = 16 };
enum { dome_share = dome_wide + dome_gap };
typedef struct {
    image *im;
    uint64_t seed;
    double squares[dome_panels][dome_high], seen[dome_panels][dome_high];  /* of errors, a row */
} dome_job;
typedef struct { vec3 p, n; bool ball, sky; } dome_place;
static const sphere dome_ball = {{0, 0, 1}, 1};

/* ---------------------------------------------------------------------------------------------- */

/* What pixel (x, y) of a panel sees, from (0, -6, 2.4), looking down a little. */
static inline dome_place dome_seen(int x, int y)
{
    vec3 right = {1, 0, 0}, ahead = vunit((vec3){0, 6, -1.5}), up = vcross(right, ahead);
    real a = ((real)x + (real)0.5 - dome_wide / 2) / dome_high;
    real b = (dome_high / 2 - (real)y - (real)0.5) / dome_high;
    vec3 aside = vadd(vscale(right, a * (real)0.55), vscale(up, b * (real)0.55));
    ray r = ray_from(vec(0, -6, 2.4), vadd(ahead, aside));
    hit h;
    bool ball = first_sphere_hit(dome_ball, r, &h);
    vec3 p = ray_at(r, ball ? h.t : -r.o.z / r.d.z);
    return (dome_place){p, ball ? first_sphere_normal(dome_ball, p) : (vec3){0, 0, 1}, ball,
                        !ball && r.d.z >= 0};
}

static inline double dome_truth(dome_place at)
{
    vec3 to = vsub(dome_ball.c, at.p);
    double d = (double)vlength(to);
    return at.ball ? (1 + (double)at.n.z) / 2 : 1 - 1 / (d * d * d);
}

/* One direction: f / p = cos theta / p over pi, if it meets the sky. */
static inline double dome_sample(int panel, dome_place at, point2 q)
{
    vec3 w = panel == 0 ? first_uniform_direction(q.u, q.v) : first_cosine_direction(q.u, q.v);
    vec3 d = directed(at.n, w);
    hit h;
    if (at.ball ? d.z < 0 : first_sphere_hit(dome_ball, ray_from(at.p, d), &h)) return 0;
    return panel == 0 ? 2 * (double)w.z : 1;
}

static inline void dome_row(size_t y, void *context)
{
    dome_job *job = context;
    for (int x = 0; x < job->im->width; x++) {
        int panel = x / dome_share, i = x % dome_share;
        if (i >= dome_wide) continue;
        dome_place at = dome_seen(i, (int)y);
        double sum = 0;
        if (at.sky) image_set(job->im, x, (int)y, vec(0.75, 0.87, 1));
        if (at.sky) continue;
        for (uint32_t k = 0; k < dome_samples; k++) {
            sampler s = sampler_start(panel == 2 ? SEQUENCE_SOBOL : SEQUENCE_RANDOM, job->seed,
                                      y * dome_wide + (uint64_t)i, k, dome_samples);
            sum += dome_sample(panel, at, sampler_pair(&s)) / dome_samples;
        }
        job->squares[panel][y] += pow(sum - dome_truth(at), 2), job->seen[panel][y]++;
        vec3 colour = at.ball ? vec(0.85, 0.3, 0.02) : vec(0.8, 0.76, 0.68);
        image_set(job->im, x, (int)y, vscale(colour, (real)fmin(sum, 1.25)));
    }
}

static inline void draw_dome(const options *o)
{
    static const char *const name[dome_panels] = {"uniform", "cosine", "cosine, Sobol'"};
    char text[dome_panels][64];
    const char *title[dome_panels];
    if (o->out) return;
    image im = image_new(dome_panels * dome_share - dome_gap, dome_high);
    dome_job job = {.im = &im, .seed = o->seed};
    bool whole = parallel_for(dome_high, o->threads, "sky", dome_row, &job);
    for (int k = 0; k < dome_panels; k++) {
        double squares = 0, n = 0;
        for (int y = 0; y < dome_high; y++) squares += job.squares[k][y], n += job.seen[k][y];
        snprintf(text[k], sizeof text[k], "16 directions, %s: error %.3f", name[k],
                 sqrt(squares / n));
        title[k] = text[k];
    }
    label_titles(&im, dome_panels, 1, dome_gap, title);
    output_picture(o, &im, "20_monte_carlo_sky.png", false, whole);
    image_free(&im);
}

#endif
