/* pictures.h: the pictures of this chapter.
 *
 *   draw_points(o)   256 points by each method of sampler.h (a column each), from the top: pair 0
 *                    of the square; pair 7; sample_disk, which is also sample_cosine from above;
 *                    sample_hemisphere from above; sample_triangle
 *   draw_wrong(o)    where the samples of sampling_naive.h fall, and below those of sampling.h:
 *                    white as many as there should be, orange too many, blue too few
 */
#ifndef PICTURES_H
#define PICTURES_H

#include "../../../common/output.h"
#include "../../../common/parallel.h"
#include "../sampler.h"
#include "sampling_naive.h"

/* ---------------------------------------------------------------------------------------------- */

enum { panel_gap = 6 };
typedef struct { image *im; int across, down; uint64_t seed; size_t samples; } panels;
typedef struct { int x, y, side; } panel_place;

/* Panel i of across x down, square, centred in its share of the picture. Side 0 if there is no
 * room. */
static inline panel_place panel_of(const panels *p, int i)
{
    int w = (p->im->width + panel_gap) / p->across, h = (p->im->height + panel_gap) / p->down;
    int side = (w < h ? w : h) - panel_gap;
    if (side < 1) return (panel_place){0, 0, 0};
    return (panel_place){i % p->across * w + (w - panel_gap - side) / 2,
                         i / p->across * h + (h - panel_gap - side) / 2, side};
}

static inline void panel_fill(const panels *p, panel_place at, vec3 (*colour)(real x, real y))
{
    for (int j = 0; j < at.side; j++)
        for (int i = 0; i < at.side; i++)
            image_set(p->im, at.x + i, at.y + j,
                      colour(((real)i + (real)0.5) / (real)at.side,
                             1 - ((real)j + (real)0.5) / (real)at.side));
}

/* A dot at (x, y) of the panel, y upwards, darkening what is there. */
static inline void panel_dot(const panels *p, panel_place at, real x, real y)
{
    real cx = x * (real)at.side, cy = (1 - y) * (real)at.side, r = (real)at.side / 80;
    vec3 ink = {0.0, 0.09, 0.3};
    if (r < (real)0.7) r = 0.7;
    for (int j = (int)(cy - r - 1); j <= (int)(cy + r + 1); j++)
        for (int i = (int)(cx - r - 1); i <= (int)(cx + r + 1); i++) {
            if (i < 0 || j < 0 || i >= at.side || j >= at.side) continue;
            real dx = (real)i + (real)0.5 - cx, dy = (real)j + (real)0.5 - cy;
            real cover = real_clamp(r + (real)0.5 - sqrt(dx * dx + dy * dy), 0, 1);
            vec3 c = image_get(p->im, at.x + i, at.y + j);
            image_set(p->im, at.x + i, at.y + j, vmadd(vscale(c, 1 - cover), ink, cover));
        }
}

/* ---- point sets ---- */

enum { square_0, square_7, disk_row, hemisphere_row, triangle_row, point_rows };

static inline vec3 point_ground(real x, real y)
{
    (void)x, (void)y;
    return vec(0.92, 0.92, 0.92);
}

static inline vec3 point_ground_disk(real x, real y)
{
    real a = 2 * x - 1, b = 2 * y - 1;
    return a * a + b * b <= 1 ? point_ground(x, y) : (vec3){1, 1, 1};
}

/* The triangle (0,0), (1,0), (1/2, sqrt(3)/2), drawn in the lower part of the panel. */
static inline vec3 point_ground_triangle(real x, real y)
{
    real s = sqrt((real)3);
    return y <= s * x && y <= s * (1 - x) ? point_ground(x, y) : (vec3){1, 1, 1};
}

static inline void points_panel(size_t i, void *context)
{
    const panels *p = context;
    panel_place at = panel_of(p, (int)i);
    int row = (int)i / sequence_kinds;
    panel_fill(p, at, row <= square_7 ? point_ground
                    : row == triangle_row ? point_ground_triangle : point_ground_disk);
    for (uint32_t k = 0; k < p->samples && at.side; k++) {
        sampler s = sampler_start((sequence_kind)(i % sequence_kinds), p->seed, 0, k,
                                  (uint32_t)p->samples);
        if (row == square_7) s.pair = 7;
        point2 q = sampler_pair(&s);
        vec3 w = row == disk_row ? sample_disk(q.u, q.v) : sample_hemisphere(q.u, q.v);
        vec3 b = sample_triangle(q.u, q.v);
        if (row == disk_row || row == hemisphere_row) q = (point2){(w.x + 1) / 2, (w.y + 1) / 2};
        if (row == triangle_row) q = (point2){b.y + b.z / 2, b.z * sqrt((real)3) / 2};
        panel_dot(p, at, q.u, q.v);
    }
}

static inline image white_image(int width, int height)
{
    image im = image_new(width, height);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) image_set(&im, x, y, (vec3){1, 1, 1});
    return im;
}

static inline void draw_points(const options *o)
{
    image im = white_image(o->width, o->height);
    panels p = {&im, sequence_kinds, point_rows, o->seed, 256};
    bool whole = parallel_for(sequence_kinds * point_rows, o->threads, "points", points_panel, &p);
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
    double t = ratio > 0 ? log2(ratio) / 2 : -1;
    t = t < -1 ? -1 : t > 1 ? 1 : t;
    vec3 full = t < 0 ? vec(0, 0.17, 0.45) : vec(0.67, 0.11, 0);
    real part = (real)fabs(t);
    return vmadd((vec3){1 - part, 1 - part, 1 - part}, full, part);
}

static inline void wrong_panel(size_t index, void *context)
{
    const panels *p = context;
    panel_place at = panel_of(p, (int)index);
    int column = (int)index % wrong_columns;
    bool right = index >= wrong_columns;
    double count[heat_cells * heat_cells] = {0};
    double whole = column == 4 ? 1 : column >= 1 && column <= 3 ? 0.5 : (double)pi / 4;
    for (size_t k = 0; k < p->samples; k++) {
        random_stream s = random_start(p->seed, index, k);
        real u = random_next(&s), v = random_next(&s);
        point2 q = wrong_place(column, right, u, v);
        int i = (int)(q.u * heat_cells), j = (int)(q.v * heat_cells);
        if (i >= 0 && j >= 0 && i < heat_cells && j < heat_cells) count[j * heat_cells + i]++;
    }
    for (int j = 0; j < at.side; j++)
        for (int i = 0; i < at.side; i++) {
            int ci = i * heat_cells / at.side, cj = (at.side - 1 - j) * heat_cells / at.side;
            double area = heat_area(column, ci, cj);
            double expected = area / whole * (double)p->samples / (heat_cells * heat_cells);
            double found = count[cj * heat_cells + ci];
            vec3 c = {1, 1, 1};
            if (area >= 0.25) c = heat_colour(found / expected);
            if (area == 0 && found > 0) c = heat_colour(4);
            image_set(p->im, at.x + i, at.y + j, c);
        }
}

static inline void draw_wrong(const options *o)
{
    if (o->out) return;
    image im = white_image(wrong_columns * 150 - panel_gap, 2 * 150 - panel_gap);
    for (int i = 0; i < im.width * im.height * 3; i++) im.rgb[i] = 0.8f;
    panels p = {&im, wrong_columns, 2, o->seed, o->quick ? 100000 : 1000000};
    bool whole = parallel_for(2 * wrong_columns, o->threads, "densities", wrong_panel, &p);
    output_picture(o, &im, "20_monte_carlo_wrong.png", false, whole);
    image_free(&im);
}

#endif
