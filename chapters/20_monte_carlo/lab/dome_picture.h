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
#include "../../../common/lab/panels.h"
#include "../sampler.h"
#include "../first.h"

enum { dome_wide = 400, dome_high = 300, dome_gap = 6, dome_ways = 3, dome_samples = 16 };
typedef struct { uint64_t seed; int way; double *square; } dome_job;  /* errors'; -1: sky */
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
static inline double dome_sample(int way, dome_place at, point2 q)
{
    vec3 w = way == 0 ? first_uniform_direction(q.u, q.v) : first_cosine_direction(q.u, q.v);
    vec3 d = directed(at.n, w);
    hit h;
    if (at.ball ? d.z < 0 : first_sphere_hit(dome_ball, ray_from(at.p, d), &h)) return 0;
    return way == 0 ? 2 * (double)w.z : 1;
}

static inline vec3 dome_pixel(const void *context, real px, real py)
{
    const dome_job *job = context;
    int x = (int)px, y = (int)py;
    dome_place at = dome_seen(x, y);
    double sum = 0, *square = &job->square[y * dome_wide + x];
    *square = -1;
    if (at.sky) return vec(0.75, 0.87, 1);
    for (uint32_t k = 0; k < dome_samples; k++) {
        sampler s = sampler_start(job->way == 2 ? SEQUENCE_SOBOL : SEQUENCE_RANDOM, job->seed,
                                  (uint64_t)(y * dome_wide + x), k, dome_samples);
        sum += dome_sample(job->way, at, sampler_pair(&s)) / dome_samples;
    }
    *square = pow(sum - dome_truth(at), 2);
    vec3 colour = at.ball ? vec(0.85, 0.3, 0.02) : vec(0.8, 0.76, 0.68);
    return vscale(colour, (real)fmin(sum, 1.25));
}

static inline void draw_dome(const options *o)
{
    static const char *const name[dome_ways] = {"uniform", "cosine", "cosine, Sobol'"};
    char text[dome_ways][64] = {""};
    const char *title[dome_ways] = {text[0], text[1], text[2]};
    image sheet = {0}, one = image_new(dome_wide, dome_high);
    dome_job job = {o->seed, 0, allocate(dome_wide * dome_high, sizeof *job.square)};
    bool whole = true;
    for (int k = 0; k < dome_ways && whole; k++) {
        double sum = 0, n = 0;
        job.way = k;
        whole = pixels_draw(&one, 1, o->threads, "sky", dome_pixel, &job);
        for (int i = 0; i < dome_wide * dome_high; i++)
            if (job.square[i] >= 0) sum += job.square[i], n++;
        snprintf(text[k], sizeof text[k], "16 directions, %s: error %.3f", name[k], sqrt(sum / n));
        label_panel(&sheet, dome_ways, 1, dome_gap, k, &one);
    }
    panels_save(o, &sheet, dome_ways, 1, dome_gap, title, "20_monte_carlo_sky.png", whole);
    image_free(&one), free(job.square);
}

#endif
