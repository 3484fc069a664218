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
#include "../sampler.h"
#include "sampling_naive.h"

enum { panel_gap = 6, panel_columns = 4, panels = 2 * panel_columns };

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

#endif
