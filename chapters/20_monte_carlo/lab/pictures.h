/* pictures.h: the pictures of this chapter.
 *
 *   draw_points(&o)  four ways to place points, a column each: 256 points in their first two
 *                    dimensions, and in the 15th and 16th
 *   draw_wrong(&o)   where the samples of sampling_naive.h fall, and below those of sampling.h:
 *                    white as many as there should be, orange too many, blue too few
 */
#ifndef MONTE_CARLO_LAB_PICTURES_H
#define MONTE_CARLO_LAB_PICTURES_H

#include "../../../common/lab/heat.h"
#include "../../../common/lab/label.h"
#include "../../../common/output.h"
#include "../../../common/parallel.h"
#include "../sampler.h"
#include "sampling_naive.h"

/* ---------------------------------------------------------------------------------------------- */

enum { panel_gap = 6 };
typedef struct { image *im; int across, down; uint64_t seed; size_t samples; } monte_carlo_panels;
typedef struct { int x, y, side; } monte_carlo_place;

/* Panel i of across x down, square, in the upper left of its share; side 0 if there is no room. */
static inline monte_carlo_place panel_of(const monte_carlo_panels *p, int i)
{
    int w = (p->im->width + panel_gap) / p->across, h = (p->im->height + panel_gap) / p->down;
    int side = (w < h ? w : h) - panel_gap;
    return (monte_carlo_place){i % p->across * w, i / p->across * h, side > 0 ? side : 0};
}

/* ---- points ---- */

enum { points_columns = 4, points_rows = 2 };
static const sequence_kind points_kind[points_columns] = {SEQUENCE_RANDOM, SEQUENCE_JITTERED,
                                                          SEQUENCE_HALTON, SEQUENCE_SOBOL};
/* A dot at (x, y) of the panel, y upwards, darkening what is there. */
static inline void panel_dot(const monte_carlo_panels *p, monte_carlo_place at, real x, real y)
{
    real cx = x * (real)at.side, cy = (1 - y) * (real)at.side, r = (real)at.side / 80;
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

static inline void points_panel(size_t i, void *context)
{
    const monte_carlo_panels *p = context;
    monte_carlo_place at = panel_of(p, (int)i);
    label_fill(p->im, at.x, at.y, at.side, at.side, vec(0.92, 0.92, 0.92));
    for (uint32_t k = 0; k < p->samples && at.side; k++) {
        sampler s = sampler_start(points_kind[i % points_columns], p->seed, 0, k,
                                  (uint32_t)p->samples);
        s.pair = i < points_columns ? 0 : 7;
        point2 q = sampler_pair(&s);
        panel_dot(p, at, q.u, q.v);
    }
}

/* Small pictures have no room for words. */
static inline void draw_points(const options *o)
{
    bool words = o->width >= 800 && o->height >= 400;
    image im = label_sheet(o->width, o->height - (words ? 26 * points_rows : 0));
    const char *title[points_columns * points_rows];
    monte_carlo_panels p = {&im, points_columns, points_rows, o->seed, 256};
    bool whole = parallel_for(points_columns * points_rows, o->threads, "points", points_panel, &p);
    for (int k = 0; k < points_columns; k++)
        title[k] = sequence_name[points_kind[k]], title[points_columns + k] = "dimensions 15, 16";
    if (words) label_titles(&im, points_columns, points_rows, panel_gap, title);
    output_picture(o, &im, "20_monte_carlo.png", true, whole);
    image_free(&im);
}

/* ---- wrong densities ---- */

enum { wrong_columns = 6, heat_cells = 48 };

/* Each onto the square, areas kept in proportion; u and v random. */
static inline point2 wrong_place(int column, bool right, real u, real v)
{
    vec3 w = {0, 0, 0};
    switch (column) {
    case 0: w = right ? sample_disk(u, v) : sample_disk_naive(u, v); break;
    case 1: w = right ? sample_triangle(u, v) : sample_triangle_naive(u, v); break;
    case 2: w = right ? sample_triangle_root(u, v) : sample_triangle_sums(u, v); break;
    case 3: w = right ? sample_triangle(u, v) : sample_triangle_fold(u, v); break;
    case 4: w = right ? sample_sphere(u, v) : sample_sphere_naive(u, v); break;
    case 5: w = right ? sample_hemisphere(u, v) : sample_hemisphere_naive(u, v); break;
    }
    real s = 1;
    if (column >= 1 && column <= 3) return (point2){w.y + w.z / 2, w.z};
    if (column == 4) return (point2){atan2(w.y, w.x) / (2 * pi) + (real)0.5, (w.z + 1) / 2};
    if (column == 5) s = 1 / sqrt(1 + w.z);  /* Lambert's map of the hemisphere onto the disk */
    return (point2){(s * w.x + 1) / 2, (s * w.y + 1) / 2};
}

/* The part of cell (i, j) that belongs to the domain: 16 x 16 points of it. */
static inline double heat_area(int column, int i, int j)
{
    int inside = 0;
    if (column == 4) return 1;
    for (int k = 0; k < 256; k++) {
        double x = (i + (k % 16 + 0.5) / 16) / heat_cells;
        double y = (j + (k / 16 + 0.5) / 16) / heat_cells;
        if (column >= 1 && column <= 3) inside += y <= 2 * x && y <= 2 * (1 - x);
        else inside += (2 * x - 1) * (2 * x - 1) + (2 * y - 1) * (2 * y - 1) <= 1;
    }
    return inside / 256.0;
}

/* A quarter: full blue; as many as expected: white; four times as many: full orange. */
static inline vec3 heat_colour(double ratio)
{
    return balance_colour(ratio > 0 ? log2(ratio) / 2 : -1);
}

static inline void wrong_panel(size_t index, void *context)
{
    const monte_carlo_panels *p = context;
    monte_carlo_place at = panel_of(p, (int)index);
    int column = (int)index % wrong_columns;
    bool right = index >= wrong_columns;
    double count[heat_cells * heat_cells] = {0};
    vec3 colour[heat_cells * heat_cells];
    double whole = column == 4 ? 1 : column >= 1 && column <= 3 ? 0.5 : (double)pi / 4;
    for (size_t k = 0; k < p->samples; k++) {
        random_stream s = random_start(p->seed, index, k);
        real u = random_next(&s), v = random_next(&s);
        point2 q = wrong_place(column, right, u, v);
        int i = (int)(q.u * heat_cells), j = (int)(q.v * heat_cells);
        if (i >= 0 && j >= 0 && i < heat_cells && j < heat_cells) count[j * heat_cells + i]++;
    }
    for (int c = 0; c < heat_cells * heat_cells; c++) {
        double area = heat_area(column, c % heat_cells, c / heat_cells);
        double expected = area / whole * (double)p->samples / (heat_cells * heat_cells);
        colour[c] = area >= 0.25 ? heat_colour(count[c] / expected) : vec(0.85, 0.85, 0.85);
        if (area == 0 && count[c] > 0) colour[c] = heat_colour(4);
    }
    for (int j = 0; j < at.side; j++)
        for (int i = 0; i < at.side; i++) {
            int cell = (at.side - 1 - j) * heat_cells / at.side * heat_cells;
            image_set(p->im, at.x + i, at.y + j, colour[cell + i * heat_cells / at.side]);
        }
}

/* The colours from a quarter, 0, to four times as many, 1. */
static inline vec3 heat_of(real t) { return heat_colour(exp2(4 * (double)t - 2)); }

static inline void draw_wrong(const options *o)
{
    enum { side = 170, strip = 60 };  /* of a panel; below them for the colours' bar */
    static const char *const title[2 * wrong_columns] = {
        "disk: r = u", "triangle: v (1 - u)", "three over sum", "fold of one", "cube, normalised",
        "theta = pi/2 u", "sample_disk", "sample_triangle", "by a root", "sample_triangle",
        "sample_sphere", "sample_hemisphere"};
    if (o->out) return;
    image im = image_new(wrong_columns * side - panel_gap, 2 * side - panel_gap);
    label_fill(&im, 0, 0, im.width, im.height, vec(0.8f, 0.8f, 0.8f));
    monte_carlo_panels p = {&im, wrong_columns, 2, o->seed, o->quick ? 10000 : 1000000};
    bool whole = parallel_for(2 * wrong_columns, o->threads, "densities", wrong_panel, &p);
    label_titles(&im, wrong_columns, 2, panel_gap, title), label_below(&im, strip);
    label_bar(&im, im.width / 2 - 200, im.height - strip + 12, 400, 10, heat_of, 0.25, 4,
              "found / expected: white 1, a doubling each quarter");
    output_picture(o, &im, "20_monte_carlo_wrong.png", false, whole);
    image_free(&im);
}

#endif
