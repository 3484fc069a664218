/* pictures.h: the pictures of this chapter: points in eight panels, and a ball under a white sky.
 *
 *   draw_points(&o)  four ways to place points, a column each: 256 points in their first two
 *                    dimensions, and in the 15th and 16th
 *   draw_wrong(&o)   where the samples of sampling_naive.h fall, and below those of sampling.h
 *   draw_dome(&o)    a ball on a floor, by 16 directions a pixel: uniform, by the cosine, and the
 *                    same from Sobol's points; above each its error
 *
 * A place under the sky receives (1/pi) integral of cos theta over what it sees of it. The truth is
 * known: the floor loses R^2 cos / d^2 to a ball at distance d, here 1 / d^3, and a place of the
 * ball whose normal is n sees (1 + n.z) / 2.
 */
#ifndef MONTE_CARLO_LAB_PICTURES_H
#define MONTE_CARLO_LAB_PICTURES_H

#include "../../../common/lab/panels.h"
#include "../../../common/output.h"
#include "../../03_sphere/first.h"
#include "../first.h"
#include "../sampler.h"
#include "sampling_naive.h"

enum { panel_gap = 6, panel_columns = 4, panels = 2 * panel_columns };

enum { dome_wide = 400, dome_high = 300, dome_gap = 6, dome_ways = 3, dome_samples = 16 };
typedef struct { uint64_t seed; int way; double *square; } dome_job;  /* errors'; -1: sky */
typedef struct { vec3 p, n; bool ball, sky; } dome_place;
static const sphere dome_ball = {{0, 0, 1}, 1};

/* Where point k of n lies in the square of panel i. */
typedef point2 panel_place(int i, uint64_t seed, uint32_t k, uint32_t n);

/* ---------------------------------------------------------------------------------------------- */

/* A dot of radius r [pixels] at p, v upwards, darkening what is there. */
static inline void panel_dot(image *im, point2 p, real r)
{
    real side = (real)im->width, cx = p.u * side, cy = (1 - p.v) * side;
    vec3 ink = vec(0, 0.09, 0.3);
    for (int j = (int)(cy - r - 1); j <= (int)(cy + r + 1); j++)
        for (int i = (int)(cx - r - 1); i <= (int)(cx + r + 1); i++) {
            if (i < 0 || j < 0 || i >= im->width || j >= im->width) continue;
            real dx = (real)i + (real)0.5 - cx, dy = (real)j + (real)0.5 - cy;
            real cover = real_clamp(r + (real)0.5 - sqrt(dx * dx + dy * dy), 0, 1);
            vec3 c = image_get(im, i, j);
            image_set(im, i, j, vmadd(vscale(c, 1 - cover), ink, cover));
        }
}

/* n points in each. Small pictures have no room for words. */
static inline void draw_panels(const options *o, const char *name, bool is_main, panel_place *place,
                               uint32_t n, const char *const title[panels])
{
    bool words = o->width >= 800 && o->height >= 400;
    image sheet = label_sheet(o->width, o->height - (words ? 26 * 2 : 0));
    int w = (sheet.width + panel_gap) / panel_columns, h = (sheet.height + panel_gap) / 2;
    int side = (w < h ? w : h) - panel_gap;
    for (int i = 0; i < panels && side > 0; i++) {
        image one = image_new(side, side);
        label_fill(&one, 0, 0, side, side, vec(0.92, 0.92, 0.92));
        for (uint32_t k = 0; k < n; k++)
            panel_dot(&one, place(i, o->seed, k, n),
                      real_max((real)side / 5 / sqrt((real)n), (real)0.7));
        image_place(&sheet, i % panel_columns * w, i / panel_columns * h, &one);
        image_free(&one);
    }
    if (words) label_titles(&sheet, panel_columns, 2, panel_gap, title);
    output_picture(o, &sheet, name, is_main, true);
    image_free(&sheet);
}

static point2 points_place(int i, uint64_t seed, uint32_t k, uint32_t n)
{
    sampler s = sampler_start((sequence_kind)(i % panel_columns), seed, 0, k, n);
    s.pair = i < panel_columns ? 0 : 7;
    return sampler_pair(&s);
}

cold_inline void draw_points(const options *o)
{
    const char *title[panels];
    for (int k = 0; k < panels; k++)
        title[k] = k < panel_columns ? sequence_name[k] : "dimensions 15, 16";
    draw_panels(o, "20_monte_carlo.png", true, points_place, 256, title);
}

/* Each onto the square, areas kept in proportion; u and v random. */
static point2 wrong_place(int i, uint64_t seed, uint32_t k, uint32_t n)
{
    static vec3 (*const sample[panels])(real, real) = {
        sample_disk_naive, sample_triangle_naive, sample_sphere_naive, sample_hemisphere_naive,
        sample_disk, sample_triangle, sample_sphere, sample_hemisphere};
    random_stream r = random_start(seed, (uint64_t)i, k);
    real u = random_next(&r), v = random_next(&r), s = 1;
    vec3 w = sample[i](u, v);
    int column = i % panel_columns;
    (void)n;
    if (column == 1) return (point2){w.y + w.z / 2, w.z};
    if (column == 2) return (point2){atan2(w.y, w.x) / (2 * pi) + (real)0.5, (w.z + 1) / 2};
    if (column == 3) s = 1 / sqrt(1 + w.z);  /* Lambert's map of the hemisphere onto the disk */
    return (point2){(s * w.x + 1) / 2, (s * w.y + 1) / 2};
}

cold_inline void draw_wrong(const options *o)
{
    static const char *const title[panels] = {
        "disk: r = u", "triangle: v (1 - u)", "cube, normalised", "theta = pi/2 u",
        "sample_disk", "sample_triangle", "sample_sphere", "sample_hemisphere"};
    draw_panels(o, "20_monte_carlo_wrong.png", false, wrong_place, 2048, title);
}

/* ---- under a white sky ---- */

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
