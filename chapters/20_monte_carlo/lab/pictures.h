/* pictures.h: the pictures of this chapter: eight panels of points each.
 *
 *   draw_points(&o)  four ways to place points, a column each: 256 points in their first two
 *                    dimensions, and in the 15th and 16th
 *   draw_wrong(&o)   where the samples of sampling_naive.h fall, and below those of sampling.h
 */
#ifndef MONTE_CARLO_LAB_PICTURES_H
#define MONTE_CARLO_LAB_PICTURES_H

#include "../../../common/lab/label.h"
#include "../../../common/output.h"
#include "../../../common/parallel.h"
#include "../sampler.h"
#include "sampling_naive.h"

/* ---------------------------------------------------------------------------------------------- */

enum { panel_gap = 6, panel_columns = 4, panels = 2 * panel_columns };
typedef struct monte_carlo_panels monte_carlo_panels;
struct monte_carlo_panels {
    image *im;
    uint64_t seed;
    uint32_t samples;
    point2 (*place)(const monte_carlo_panels *, int panel, uint32_t sample);
};
typedef struct { int x, y, side; } monte_carlo_place;

/* Panel i, square, in the upper left of its share; side 0 if there is no room. */
static inline monte_carlo_place panel_of(const image *im, int i)
{
    int w = (im->width + panel_gap) / panel_columns, h = (im->height + panel_gap) / 2;
    int side = (w < h ? w : h) - panel_gap;
    return (monte_carlo_place){i % panel_columns * w, i / panel_columns * h, side > 0 ? side : 0};
}

/* A dot at (x, y) of the panel, y upwards, darkening what is there. */
static inline void panel_dot(const monte_carlo_panels *p, monte_carlo_place at, real x, real y)
{
    real cx = x * (real)at.side, cy = (1 - y) * (real)at.side;
    real r = (real)at.side / 5 / sqrt((real)p->samples);
    vec3 ink = vec(0, 0.09, 0.3);
    if (r < (real)0.7) r = (real)0.7;
    for (int j = (int)(cy - r - 1); j <= (int)(cy + r + 1); j++)
        for (int i = (int)(cx - r - 1); i <= (int)(cx + r + 1); i++) {
            if (i < 0 || j < 0 || i >= at.side || j >= at.side) continue;
            real dx = (real)i + (real)0.5 - cx, dy = (real)j + (real)0.5 - cy;
            real cover = real_clamp(r + (real)0.5 - sqrt(dx * dx + dy * dy), 0, 1);
            vec3 c = image_get(p->im, at.x + i, at.y + j);
            image_set(p->im, at.x + i, at.y + j, vmadd(vscale(c, 1 - cover), ink, cover));
        }
}

static inline void panel_draw(size_t i, void *context)
{
    const monte_carlo_panels *p = context;
    monte_carlo_place at = panel_of(p->im, (int)i);
    label_fill(p->im, at.x, at.y, at.side, at.side, vec(0.92, 0.92, 0.92));
    for (uint32_t k = 0; k < p->samples && at.side; k++) {
        point2 q = p->place(p, (int)i, k);
        panel_dot(p, at, q.u, q.v);
    }
}

/* Small pictures have no room for words. */
static inline void draw_panels(const options *o, monte_carlo_panels p, const char *name, bool main,
                               const char *const title[panels])
{
    bool words = o->width >= 800 && o->height >= 400;
    image im = label_sheet(o->width, o->height - (words ? 26 * 2 : 0));
    p.im = &im, p.seed = o->seed;
    bool whole = parallel_for(panels, o->threads, "points", panel_draw, &p);
    if (words) label_titles(&im, panel_columns, 2, panel_gap, title);
    output_picture(o, &im, name, main, whole);
    image_free(&im);
}

static inline point2 points_place(const monte_carlo_panels *p, int panel, uint32_t k)
{
    sampler s = sampler_start((sequence_kind)(panel % panel_columns), p->seed, 0, k, p->samples);
    s.pair = panel < panel_columns ? 0 : 7;
    return sampler_pair(&s);
}

cold_inline void draw_points(const options *o)
{
    const char *title[panels];
    for (int k = 0; k < panels; k++)
        title[k] = k < panel_columns ? sequence_name[k] : "dimensions 15, 16";
    draw_panels(o, (monte_carlo_panels){.samples = 256, .place = points_place},
                "20_monte_carlo.png", true, title);
}

/* Each onto the square, areas kept in proportion; u and v random. */
static inline point2 wrong_place(const monte_carlo_panels *p, int panel, uint32_t k)
{
    static vec3 (*const sample[panels])(real, real) = {
        sample_disk_naive, sample_triangle_naive, sample_sphere_naive, sample_hemisphere_naive,
        sample_disk, sample_triangle, sample_sphere, sample_hemisphere};
    random_stream r = random_start(p->seed, (uint64_t)panel, k);
    real u = random_next(&r), v = random_next(&r), s = 1;
    vec3 w = sample[panel](u, v);
    int column = panel % panel_columns;
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
    if (o->out) return;
    draw_panels(o, (monte_carlo_panels){.samples = 2048, .place = wrong_place},
                "20_monte_carlo_wrong.png", false, title);
}

#endif
