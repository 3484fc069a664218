/* orders_draw.h: the pictures of this chapter.
 *
 *   orders_draw(&o)         08_object_order.png: a third, two thirds, all, in both orders
 *   orders_draw_flat(&o)    .._flat.png: tiles by first.h, by raster.h, and the pixels that differ
 *   orders_draw_shadow(&o)  .._shadow.png: shadow rays and three shadow maps; orange: wrong
 *   orders_draw_edges(&o)   .._edges.svg: two triangles that share an edge, on a grid of pixels
 */
#ifndef ORDERS_DRAW_H
#define ORDERS_DRAW_H

#include "../../../common/lab/figure.h"
#include "../../../common/lab/panels.h"
#include "../../07_mesh/scenes/as_first.h"
#include "../shadow_map.h"
#include "orders.h"

enum { orders_gap = 8 };

/* A panel: the first `shown` pixels of s, orange where the colours of `other` are not theirs. In
 * the light of the lamp, if due[] says which pixels are dark: by the map, orange if that errs. */
typedef struct {
    const raster *s, *other;
    const mesh *m;
    camera c;
    int shown;
    const bool *due;
    const shadow_map *map;
    real bias;
} orders_view;

/* ---------------------------------------------------------------------------------------------- */

/* Is the lamp hidden from what pixel k of s shows? By a map, or (NULL) by the ray of (1.5), its
 * ends left out. */
static inline bool orders_dark(const raster *s, const mesh *m, const shadow_map *map, real bias,
                               int k)
{
    if (s->h[k].shape == no_shape) return false;
    vec3 p = orders_point(m, s->h[k]);
    return map ? shadow_map_dark(map, p, bias)
               : mesh_occluded(m, ray_shadow(p, orders_lamp_place, (real)1e-4));
}

static vec3 orders_pixel(const void *context, real x, real y)
{
    const orders_view *v = context;
    const raster *s = v->s;
    const vec3 orange = {1, 0.25, 0}, d = camera_ray(v->c, x, y, s->nx, s->ny).d;
    int k = (int)y * s->nx + (int)x;
    bool due = v->due && v->due[k], dark = v->map ? orders_dark(s, v->m, v->map, v->bias, k) : due;
    vec3 seen = orders_colour(v->m, k < v->shown ? s->h[k] : hit_none, d, !dark);
    if (dark != due) return orange;
    if (!v->other) return seen;
    vec3 by = vsub(orders_colour(v->m, v->other->h[k], d, true), seen);
    return vlength(by) > (real)0.2 ? orange : seen;  /* more than other shades */
}

/* Upper row: after a third of the triangles, two thirds, all. Lower: after so many pixels. */
cold_inline void orders_draw(const options *o)
{
    static const char *const name[6] = {
        "for each triangle: a third done", "two thirds", "all",
        "for each pixel: a third done", "two thirds", "all"};
    int gap = o->width >= 400 ? orders_gap : 0;
    panels_shape g = {o->width, o->height, 3, 2, gap, 1, o->width < 400};
    int w = panels_wide(g), h = panels_high(g);
    mesh m = orders_scene(o->quick ? 2 : 4);
    camera c = orders_camera((real)w / (real)h);
    raster drawn[3], seen = raster_new(w, h);
    orders_view v[6];
    panel p[6];
    bool whole = orders_rays(&seen, &m, c, o->threads), all;
    for (size_t k = 0; k < 3; k++) {
        drawn[k] = raster_new(w, h);
        raster_job job = raster_begin(&drawn[k], c, raster_default);
        for (size_t i = 0; i < (k + 1) * m.triangles / 3; i++)
            raster_triangle(&job, mesh_triangle(&m, i), (uint32_t)i);
        v[k] = (orders_view){.s = &drawn[k], .m = &m, .c = c, .shown = w * h};
        v[3 + k] = (orders_view){.s = &seen, .m = &m, .c = c, .shown = (int)(k + 1) * w * h / 3};
    }
    for (int k = 0; k < 6; k++) p[k] = (panel){name[k], &v[k]};
    image sheet = panels_new(o, g, orders_pixel, p, &all);
    output_picture(o, &sheet, "08_object_order.png", true, whole && all);
    for (int k = 0; k < 3; k++) raster_free(&drawn[k]);
    image_free(&sheet), raster_free(&seen), mesh_free(&m);
}

/* first.h in the types of raster.h. */
static inline raster orders_first(const mesh *m, camera c, int nx, int ny)
{
    raster out = raster_new(nx, ny);
    first_mesh soup = first_mesh_of(m);
    first_camera f = {c.e, c.u, c.v, c.w, c.left, c.right, c.bottom, c.top, c.d, nx, ny};
    first_raster s = first_raster_new(nx, ny);
    first_raster_mesh(&s, &soup, f);
    for (int k = 0; k < nx * ny; k++) out.h[k] = s.h[k], out.h[k].t /= c.d;
    first_raster_free(&s), first_mesh_free(&soup);
    return out;
}

/* The floor in front of the eye alone: with its corners behind, first.h would leave it out. */
cold_inline void orders_draw_flat(const options *o)
{
    const int w = o->quick ? 79 : 316, h = o->quick ? 75 : 300;
    mesh m = orders_scene(6);
    for (size_t i = m.vertices - 4; i < m.vertices; i++) m.v[i].y = real_max(m.v[i].y, -5);
    camera c = orders_camera((real)w / (real)h);
    raster s = orders_first(&m, c, w, h), t = raster_new(w, h);
    raster_mesh(&t, &m, c, raster_default);
    const orders_view v[3] = {{.s = &s, .m = &m, .c = c, .shown = w * h},
                              {.s = &t, .m = &m, .c = c, .shown = w * h},
                              {.s = &t, .m = &m, .c = c, .shown = w * h, .other = &s}};
    const panel p[3] = {{"first.h", &v[0]}, {"raster.h", &v[1]},
                        {"other triangle or tile: orange", &v[2]}};
    panels_draw(o, "08_object_order_flat.png", false,
                (panels_shape){3 * w + 2 * orders_gap, h, 3, 1, orders_gap, 1, false},
                orders_pixel, p);
    raster_free(&s), raster_free(&t), mesh_free(&m);
}

cold_inline void orders_draw_shadow(const options *o)
{
    static const struct { int side; real bias; const char *name; } of[4] = {
        {1, 0, "shadow rays"}, {128, 0, "map of 128 x 128, no bias: acne"},
        {128, (real)0.04, "bias 0.04: loose from the foot"},
        {1024, (real)0.004, "map of 1024 x 1024, 0.004"}};
    const int w = o->quick ? 60 : 400, h = o->quick ? 45 : 300;
    mesh m = orders_scene(4);
    camera c = orders_camera((real)w / (real)h);
    raster s = raster_new(w, h);
    shadow_map map[4];
    orders_view v[4];
    panel p[4];
    bool *due = allocate((size_t)(w * h), 1);
    raster_mesh(&s, &m, c, raster_default);
    for (int k = 0; k < w * h; k++) due[k] = orders_dark(&s, &m, NULL, 0, k);
    for (int i = 0; i < 4; i++) {
        map[i] = shadow_map_new(&m, orders_lamp(), of[i].side, raster_default);
        v[i] = (orders_view){&s, NULL, &m, c, w * h, due, i ? &map[i] : NULL, of[i].bias};
        p[i] = (panel){of[i].name, &v[i]};
    }
    panels_draw(o, "08_object_order_shadow.png", false,
                (panels_shape){2 * w + orders_gap, 2 * h + orders_gap, 2, 2, orders_gap, 1, false},
                orders_pixel, p);
    for (int i = 0; i < 4; i++) shadow_map_free(&map[i]);
    free(due), raster_free(&s), mesh_free(&m);
}

/* Drawn by raster_mesh itself: a dot a pixel in the colour of the triangle that got it. The window
 * is the picture: one pixel is one unit, y downwards. */
cold_inline void orders_draw_edges(const options *o)
{
    enum { nx = 16, ny = 9 };
    const double at[4][2] = {{1.2, 1.7}, {12.5, 0.5}, {15.6, 6.9}, {4.5, 8.5}};
    const char *colour[2] = {FIGURE_BLUE, FIGURE_ORANGE};
    vec3 v[4];
    uint32_t index[6] = {0, 3, 1, 1, 3, 2};
    camera c = {CAMERA_PERSPECTIVE, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0, nx, 0, ny, 1,
                {0, 0, 0}};
    for (int k = 0; k < 4; k++) v[k] = vec((real)at[k][0], (real)(ny - at[k][1]), -1);
    mesh m = {.v = v, .vertices = 4, .index = index, .triangles = 2};
    raster s = raster_new(nx, ny);
    raster_mesh(&s, &m, c, raster_default);
    figure g = figure_begin(o, "08_object_order_edges.svg", 800, 500);
    figure_origin(&g, 40, 430, 45);
    for (int x = 0; x <= nx; x++) figure_line(&g, x, 0, x, ny, "#cccccc", 1, FIGURE_WHOLE);
    for (int y = 0; y <= ny; y++) figure_line(&g, 0, y, nx, y, "#cccccc", 1, FIGURE_WHOLE);
    for (int k = 0; k < 2; k++) {
        double xy[6];
        for (int i = 0; i < 3; i++) {
            const double *p = at[index[3 * k + i]];
            xy[2 * i] = p[0], xy[2 * i + 1] = ny - p[1];
        }
        figure_polygon(&g, 3, xy, colour[k], 0.18, FIGURE_BLACK);
    }
    for (int k = 0; k < nx * ny; k++) {
        uint32_t owner = s.h[k].shape;
        figure_dot(&g, k % nx + 0.5, ny - k / nx - 0.5, owner == no_shape ? 2 : 6,
                   owner == no_shape ? FIGURE_GREY : colour[owner]);
    }
    figure_text(&g, at[0][0], ny - at[0][1], -18, 8, FIGURE_LEFT, FIGURE_BLACK, "*a*");
    figure_text(&g, at[1][0], ny - at[1][1], 8, 8, FIGURE_LEFT, FIGURE_BLACK, "*b*");
    figure_text(&g, at[3][0], ny - at[3][1], -18, -14, FIGURE_LEFT, FIGURE_BLACK, "*c*");
    figure_text(&g, 0, 0, 0, 24, FIGURE_LEFT, FIGURE_BLACK,
                "dots: middles of pixels, in the colour of the triangle that got them; "
                "the rest grey");
    figure_text(&g, 0, 0, 0, 44, FIGURE_LEFT, FIGURE_BLACK,
                "seven lie on the edge *b* *c*, _e_ = 0: a left edge of the orange triangle, which "
                "has them all");
    figure_end(&g);
    raster_free(&s);
}

#endif
