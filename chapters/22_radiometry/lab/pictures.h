/* pictures.h: the pictures of this chapter.
 *
 *   draw_floor(o)    three lights (columns, floors.h); rows: closed form, contours (等照度线) at
 *                    factors of 2; photons counted; their difference in standard errors, orange
 *                    too many, blue too few
 *   draw_view(o)     what a point sees (view.h): areas are solid angles, and irradiances
 */
#ifndef RADIOMETRY_LAB_PICTURES_H
#define RADIOMETRY_LAB_PICTURES_H

#include "../../../common/lab/label.h"
#include "../../../common/lab/pixels.h"
#include "../../../common/output.h"
#include "floors.h"
#include "view.h"

/* ---------------------------------------------------------------------------------------------- */

enum { floor_gap = 6, floor_rows = 3, floor_chunks = 16 };
typedef struct {
    image *im;
    uint64_t seed;
    size_t photons;
    int parts;            /* floor_cell's */
    uint32_t *count;      /* of each light, of each chunk, of each cell */
    double *expected, *e; /* of each light, of each cell */
} radiometry_floors;

/* By the logarithm: black at pi / 1024 and below, then blue, red, yellow; pi is nearly white. */
static inline vec3 heat(double e)
{
    static const double stop[6][3] = {{0, 0, 0.02}, {0.02, 0.03, 0.25}, {0.25, 0.02, 0.3},
                                      {0.75, 0.08, 0.08}, {1, 0.5, 0.03}, {1, 1, 0.75}};
    double t = e > 0 ? (log2(e / (double)pi) + 10) / 2 : 0;
    t = t < 0 ? 0 : t > 4.999 ? 4.999 : t;
    int i = (int)t;
    const double *a = stop[i], *b = stop[i + 1];
    t -= i;
    return vec((a[0] + t * (b[0] - a[0])), (a[1] + t * (b[1] - a[1])),
                  (a[2] + t * (b[2] - a[2])));
}

/* z = -4 full blue, 0 white, 4 full orange. */
static inline vec3 z_colour(double z)
{
    double t = z / 4;
    t = t < -1 ? -1 : t > 1 ? 1 : t;
    vec3 full = t < 0 ? vec(0, 0.17, 0.45) : vec(0.67, 0.11, 0);
    real part = (real)fabs(t);
    return vmadd((vec3){1 - part, 1 - part, 1 - part}, full, part);
}

static inline size_t floor_index(int light, int chunk, int cell)
{
    return ((size_t)light * floor_chunks + (size_t)chunk) * floor_cells * floor_cells +
           (size_t)cell;
}

static inline void photon_job(size_t i, void *context)
{
    radiometry_floors *f = context;
    size_t chunk = i % floor_chunks, n = f->photons / floor_chunks;
    int light = (int)(i / floor_chunks);
    floor_photons((floor_light)light, f->seed, chunk * n, n,
                  f->count + floor_index(light, (int)chunk, 0));
}

static inline void cells_job(size_t i, void *context)
{
    radiometry_floors *f = context;
    int light = (int)i / floor_cells, j = (int)i % floor_cells;
    double n = (double)(f->photons / floor_chunks * floor_chunks);
    for (int k = 0; k < floor_cells; k++) {
        size_t at = ((size_t)light * floor_cells + (size_t)j) * floor_cells + (size_t)k;
        f->e[at] = floor_cell((floor_light)light, k, j, f->parts);
        f->expected[at] = floor_expected((floor_light)light, f->e[at], n);
    }
}

/* All chunks of a cell, over what one W/m^2 would bring. */
static inline double floor_counted(const radiometry_floors *f, int light, int cell)
{
    double sum = 0;
    for (int c = 0; c < floor_chunks; c++) sum += f->count[floor_index(light, c, cell)];
    return sum;
}

static inline vec3 floor_colour(const radiometry_floors *f, int light, int row, real x, real y,
                                real px)
{
    int i = (int)((x + floor_half) / (2 * floor_half) * floor_cells);
    int j = (int)((y + floor_half) / (2 * floor_half) * floor_cells), cell = j * floor_cells + i;
    double n = (double)(f->photons / floor_chunks * floor_chunks);
    double counted = row ? floor_counted(f, light, cell) : 0;
    double expected = f->expected[light * floor_cells * floor_cells + cell];
    if (row == 1) return heat(counted / floor_expected((floor_light)light, 1, n));
    if (row == 2)
        return expected < 5 ? vec(0.6, 0.6, 0.6)
                            : z_colour((counted - expected) / sqrt(expected));
    double e = (double)floor_exact((floor_light)light, x, y), last = e, below = e;
    last = (double)floor_exact((floor_light)light, x + px, y);
    below = (double)floor_exact((floor_light)light, x, y + px);
    double level = floor(log2(e));
    bool line = e > 1.0 / 1024 && (floor(log2(last)) != level || floor(log2(below)) != level);
    return line ? vec(0.9, 0.9, 0.9) : heat(e);
}

static inline vec3 floor_place(const void *context, real x, real y)
{
    const radiometry_floors *f = context;
    int w = (f->im->width + floor_gap) / floor_lights, h = (f->im->height + floor_gap) / floor_rows;
    int light = (int)x / w, row = (int)y / h, sw = w - floor_gap, sh = h - floor_gap;
    int side = sw < sh ? sw : sh;  /* square, in the middle */
    real i = x - (real)(light * w + (sw - side) / 2), j = y - (real)(row * h + (sh - side) / 2);
    if (light >= floor_lights || row >= floor_rows || i < 0 || j < 0 || i >= (real)side
        || j >= (real)side) return (vec3){1, 1, 1};
    real px = 2 * floor_half / (real)side;
    return floor_colour(f, light, row, i * px - floor_half, floor_half - j * px, px);
}

static inline vec3 floor_bar(real part) { return heat((double)pi * exp2(10 * ((double)part - 1))); }

/* A title above each panel, and a bar of the colours below. */
static inline image floor_labelled(const image *im, const char *const *title)
{
    enum { strip = 46 };
    image panels = label_panels(im, floor_lights, floor_rows, floor_gap, title);
    image sheet = image_new(panels.width, panels.height + strip);
    label_fill(&sheet, 0, 0, sheet.width, sheet.height, vec(1, 1, 1));
    image_place(&sheet, 0, 0, &panels);
    label_bar(&sheet, sheet.width / 4, panels.height + 8, sheet.width / 2, 9, floor_bar,
              (double)pi / 1024, (double)pi,
              "irradiance [W/m^2], twice as much at each white line");
    image_free(&panels);
    return sheet;
}

static inline void draw_floor(const options *o)
{
    enum { cells = floor_cells * floor_cells };
    image im = image_new(o->width, o->height);
    radiometry_floors f = {&im, o->seed, o->quick ? 100000 : 3000000,
                       o->quick ? 2 : 8, NULL, NULL, NULL};
    f.count = allocate((size_t)floor_lights * floor_chunks * cells, sizeof *f.count);
    f.expected = allocate((size_t)floor_lights * cells, sizeof *f.expected);
    f.e = allocate((size_t)floor_lights * cells, sizeof *f.e);
    bool whole = parallel_for(floor_lights * floor_chunks, o->threads, "photons", photon_job, &f)
              && parallel_for(floor_lights * floor_cells, o->threads, "cells", cells_job, &f)
              && pixels_draw(&im, 1, o->threads, "floor", floor_place, &f);
    static const char *const title[9] = {
        "ball: closed form", "square: closed form", "spotlight: closed form",
        "photons counted", "photons counted", "photons counted",
        "difference, in standard errors", "orange: too many", "blue: too few"};
    bool labels = o->width >= 600 && o->height >= 300;  /* narrower, titles would run together */
    image sheet = labels ? floor_labelled(&im, title) : im;
    output_picture(o, &sheet, "22_radiometry.png", true, whole);
    if (labels) image_free(&sheet);
    free(f.count), free(f.expected), free(f.e);
    image_free(&im);
}

/* ---- what a point sees ---- */

static inline vec3 view_colour(radiometry_map m, real x, real y, real px)
{
    static const vec3 colour[view_things] = {
        {0.9, 0.35, 0.02}, {0.65, 0.1, 0.05},
        {0.05, 0.25, 0.6}, {0.02, 0.4, 0.2}};
    vec3 w, right, down, none = {1, 1, 1}, sky = {0.85, 0.88, 0.92};
    if (!view_direction(m, x, y, &w)) return none;
    int k = view_met(w);
    vec3 c = k < 0 ? sky : colour[k];
    if (!view_direction(m, x + px, y, &right) || !view_direction(m, x, y + px, &down)) return c;
    const real step = pi / 18;  /* lines every 10 degrees of elevation, and of turn */
    bool ring = floor(acos(w.z) / step) != floor(acos(right.z) / step)
             || floor(acos(w.z) / step) != floor(acos(down.z) / step);
    bool spoke = floor(atan2(w.y, w.x) / step) != floor(atan2(right.y, right.x) / step)
              || floor(atan2(w.y, w.x) / step) != floor(atan2(down.y, down.x) / step);
    return ring || spoke ? vscale(c, 0.72) : c;
}

static inline vec3 view_place(const void *context, real x, real y)
{
    int side = *(const int *)context, left = (int)x < side + floor_gap ? 0 : side + floor_gap;
    real px = 2 / (real)side, u = (x - (real)left) * px - 1;
    if (u >= 1) return (vec3){1, 1, 1};
    return view_colour(left ? VIEW_PROJECTED : VIEW_EQUAL_AREA, u, 1 - y * px, px);
}

static inline void draw_view(const options *o)
{
    if (o->out) return;
    image im = o->quick ? image_new(306, 150) : image_new(906, 450);
    int side = (im.width - floor_gap) / 2;
    bool whole = pixels_draw(&im, 3, o->threads, "view", view_place, &side);
    static const char *const title[2] = {"area: solid angle", "area: solid angle times cosine"};
    image sheet = label_panels(&im, 2, 1, floor_gap, title);
    output_picture(o, &sheet, "22_radiometry_view.png", false, whole);
    image_free(&im), image_free(&sheet);
}

#endif
