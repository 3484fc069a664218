/* pictures.h: the pictures of this chapter.
 *
 *   draw_floor(o)    three lights (columns, floors.h): above the closed form, with contours
 *                    (等照度线) at factors of 2; below photons, counted
 *   draw_view(o)     what a point sees above it; view_direction(VIEW_PROJECTED, x, y, &w) is the
 *                    direction of a place in it, view_met(w) what is met there, or -1
 *
 *   VIEW_EQUAL_AREA   r = 2 sin(theta/2) (Lambert's map): area in the picture = solid angle
 *   VIEW_PROJECTED    r = sin theta: area = cos theta d omega: Nusselt's analog, E for L = 1
 *
 * Source: W. Nusselt, "Graphische Bestimmung des Winkelverhaeltnisses bei der Waermestrahlung",
 * Zeitschrift des VDI 72, 1928.
 */
#ifndef RADIOMETRY_LAB_PICTURES_H
#define RADIOMETRY_LAB_PICTURES_H

#include "../../../common/lab/heat.h"
#include "../../../common/lab/panels.h"
#include "directions.h"
#include "floors.h"

typedef enum { VIEW_EQUAL_AREA, VIEW_PROJECTED, view_maps } radiometry_map;

/* ---------------------------------------------------------------------------------------------- */

enum { floor_gap = 6, floor_rows = 2, floor_parts = 8, floor_panels = floor_rows * floor_lights };
typedef struct {
    uint64_t seed;
    size_t photons;       /* of each light; each part of them counts for itself */
    uint32_t count[floor_lights][floor_parts][floor_cells * floor_cells];
} radiometry_floors;
typedef struct { const radiometry_floors *all; floor_light light; bool counted; int width, height; }
    floor_panel;

/* By the logarithm: black at this and below, white at pi, 10 doublings above. */
#define floor_black ((double)pi / 1024)
static inline vec3 floor_heat(double e)
{
    return work_colour((real)(e > 0 ? log2(e / (double)pi) / 10 + 1 : 0));
}

static inline void photon_job(size_t i, void *context)
{
    radiometry_floors *f = context;
    size_t light = i / floor_parts, part = i % floor_parts, n = f->photons / floor_parts;
    floor_photons((floor_light)light, f->seed, part * n, n, f->count[light][part]);
}

/* Under the ball there is no floor, and on black there are no lines. */
static inline vec3 floor_colour(floor_light light, real x, real y, real px)
{
    vec3 p = {x, y, 0};
    if (light == FLOOR_SPHERE && vlength(vsub(p, buried.c)) < buried.r) return floor_heat(0);
    double e = (double)floor_exact(light, x, y), level = floor(log2(e));
    bool line = e > floor_black && (floor(log2((double)floor_exact(light, x + px, y))) != level
                                   || floor(log2((double)floor_exact(light, x, y + px))) != level);
    return line ? vec(0.9, 0.9, 0.9) : floor_heat(e);
}

static inline vec3 floor_place(const void *context, real x, real y)
{
    const floor_panel *f = context;
    int side = f->width < f->height ? f->width : f->height;  /* square, in the middle */
    real i = x - (real)((f->width - side) / 2), j = y - (real)((f->height - side) / 2);
    if (i < 0 || j < 0 || i >= (real)side || j >= (real)side) return (vec3){1, 1, 1};
    real px = 2 * floor_half / (real)side, u = i * px - floor_half, v = floor_half - j * px;
    if (!f->counted) return floor_colour(f->light, u, v, px);
    double counted = 0;
    for (int k = 0; k < floor_parts; k++)
        counted += f->all->count[f->light][k][floor_cell(v) * floor_cells + floor_cell(u)];
    return floor_heat(counted / floor_expected(f->light, 1, (double)f->all->photons));
}

cold_inline void draw_floor(const options *o)
{
    static const char *const title[floor_panels] = {
        "ball: closed form", "square: closed form", "spotlight: closed form",
        "photons counted", "photons counted", "photons counted"};
    bool words = o->width >= 600 && o->height >= 300, drawn;  /* narrower, titles run together */
    int gap = words ? floor_gap : 0, bar = 46;                /* rows of the bar of the colours */
    panels_shape g = {o->width, o->height, floor_lights, floor_rows, gap, 1, !words};
    radiometry_floors *f = allocate(1, sizeof *f);
    floor_panel one[floor_panels];
    panel p[floor_panels];
    for (int k = 0; k < floor_panels; k++) {
        one[k] = (floor_panel){f, (floor_light)(k % floor_lights), k >= floor_lights,
                               panels_wide(g), panels_high(g)};
        p[k] = (panel){title[k], &one[k]};
    }
    f->seed = o->seed, f->photons = o->quick ? 100000 : 3000000;
    bool whole = parallel_for(floor_lights * floor_parts, o->threads, "photons", photon_job, f);
    image im = panels_new(o, g, floor_place, p, &drawn);
    if (words) label_below(&im, bar);
    if (words)
        label_bar(&im, im.width / 4, im.height - bar + 8, im.width / 2, 9, work_colour, floor_black,
                  (double)pi, "irradiance [W/m^2], twice as much at each white line");
    output_picture(o, &im, "22_radiometry.png", true, whole && drawn);
    image_free(&im), free(f);
}

/* ---- what a point sees ---- */

/* In the order of view_met. */
enum { view_things = 4 };
static const sphere view_sphere[2] = {{{1, 1.2, 2}, 0.9}, {{-0.3, 2, -0.25}, 1}};
static const rectangle view_square = {{-1.5, -1, 0.3}, {0, 1.6, 0}, {0, 0, 1.6}};
static const triangle view_triangle = {{0.4, -1.6, 0.3}, {2, -0.6, 0.3}, {1, -1.2, 3}};

static inline int view_met(vec3 w)
{
    ray r = ray_from(seen_from, w);
    hit h;
    for (int k = 0; k < 2; k++)
        if (sphere_hit(view_sphere[k], r, &h)) return k;
    if (rectangle_met(view_square, w)) return 2;
    return triangle_hit(view_triangle, r, &h) ? 3 : -1;
}

static inline real view_scale(radiometry_map m) { return m == VIEW_EQUAL_AREA ? sqrt((real)2) : 1; }

/* (x, y) in [-1,1]^2; false outside of the hemisphere. */
static inline bool view_direction(radiometry_map m, real x, real y, vec3 *w)
{
    real k = view_scale(m), rr = k * k * (x * x + y * y);
    if (x * x + y * y >= 1) return false;
    if (m == VIEW_PROJECTED) *w = (vec3){x, y, sqrt(1 - rr)};
    else {
        real s = k * sqrt(1 - rr / 4);  /* k cos(theta/2), with rr = 4 sin^2(theta/2) */
        *w = (vec3){s * x, s * y, 1 - rr / 2};
    }
    return true;
}

/* The field of the net of lines, every 10 degrees of elevation and of turn, that w lies in. */
static inline int view_field(vec3 w)
{
    const real step = pi / 18;
    return 100 * (int)floor(acos(w.z) / step) + (int)floor(atan2(w.y, w.x) / step);
}

typedef struct { radiometry_map map; int side; } radiometry_view;

static inline vec3 view_place(const void *context, real column, real row)
{
    static const vec3 colour[view_things] = {
        {0.9, 0.35, 0.02}, {0.65, 0.1, 0.05}, {0.05, 0.25, 0.6}, {0.02, 0.4, 0.2}};
    const radiometry_view *v = context;
    real px = 2 / (real)v->side, x = column * px - 1, y = 1 - row * px;
    vec3 w, right, above;
    if (!view_direction(v->map, x, y, &w)) return (vec3){1, 1, 1};
    int k = view_met(w), field = view_field(w);
    vec3 c = k < 0 ? vec(0.85, 0.88, 0.92) : colour[k];
    bool line = view_direction(v->map, x + px, y, &right)
             && view_direction(v->map, x, y + px, &above)
             && (field != view_field(right) || field != view_field(above));
    return line ? vscale(c, 0.72) : c;
}

cold_inline void draw_view(const options *o)
{
    int side = o->quick ? 150 : 450;
    radiometry_view v[view_maps] = {{VIEW_EQUAL_AREA, side}, {VIEW_PROJECTED, side}};
    panel p[] = {{"area: solid angle", &v[0]}, {"area: solid angle times cosine", &v[1]}};
    panels_shape g = {2 * side + floor_gap, side, view_maps, 1, floor_gap, 3, false};
    if (!o->out) panels_draw(o, "22_radiometry_view.png", false, g, view_place, p);
}

#endif
