/* orders_draw.h: the pictures of this chapter.
 *
 *   orders_draw(&o)         08_object_order.png: a third, two thirds, all, in both orders
 *   orders_draw_flat(&o)    .._flat.png: tiles by first.h, by raster.h, and the pixels that differ
 *   orders_draw_shadow(&o)  .._shadow.png: shadow rays and three shadow maps; orange: wrong
 *   orders_draw_mirror(&o)  .._mirror.png: a wall that shows what the eye's image sees
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

/* ---------------------------------------------------------------------------------------------- */

/* The hits of s as a picture at (x0, y0) of im; where `wrong` [may be NULL] is set, orange. */
static inline void orders_panel(image *im, int x0, int y0, const raster *s, const mesh *m,
                                camera c, const bool *dark, const bool *wrong)
{
    for (int k = 0; k < s->nx * s->ny; k++) {
        int x = k % s->nx, y = k / s->nx;
        vec3 d = camera_ray(c, (real)x + (real)0.5, (real)y + (real)0.5, s->nx, s->ny).d;
        vec3 seen = orders_colour(m, m->triangles - orders_floor, s->h[k], d, !dark || !dark[k]);
        image_set(im, x0 + x, y0 + y, wrong && wrong[k] ? vec(1, 0.25, 0) : seen);
    }
}

/* Upper row: after a third of the triangles, two thirds, all. Lower: after so many pixels. */
cold_inline void orders_draw(const options *o)
{
    static const char *const title[6] = {
        "for each triangle: a third done", "two thirds", "all",
        "for each pixel: a third done", "two thirds", "all"};
    int w = (o->width - 2 * orders_gap) / 3, h = (o->height - orders_gap) / 2;
    if (w < 1 || h < 1) w = o->width, h = o->height;
    bool small = w == o->width, whole;
    image im = image_new(small ? w : 3 * w + 2 * orders_gap, small ? h : 2 * h + orders_gap);
    mesh m = orders_scene(o->quick ? 2 : 4, false);
    camera c = orders_camera((real)w / (real)h);
    raster drawn = raster_new(w, h), seen = raster_new(w, h), part = raster_new(w, h);
    whole = orders_rays(&seen, &m, c, o->threads);
    raster_job job = raster_begin(&drawn, c, raster_default);
    for (size_t k = 0; k < 3; k++) {
        int column = (int)k * (w + orders_gap);
        for (size_t i = k * m.triangles / 3; i < (k + 1) * m.triangles / 3; i++)
            raster_triangle(&job, mesh_triangle(&m, i), (uint32_t)i);
        for (size_t i = 0; i < (k + 1) * (size_t)(w * h) / 3; i++) part.h[i] = seen.h[i];
        if (small && k < 2) continue;
        orders_panel(&im, small ? 0 : column, 0, &drawn, &m, c, NULL, NULL);
        if (!small) orders_panel(&im, column, h + orders_gap, &part, &m, c, NULL, NULL);
    }
    if (!small && w >= 200) label_titles(&im, 3, 2, orders_gap, title);
    output_picture(o, &im, "08_object_order.png", true, whole);
    image_free(&im), raster_free(&drawn), raster_free(&seen), raster_free(&part), mesh_free(&m);
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
    static const char *const title[3] = {"first.h", "raster.h", "other triangle or tile: orange"};
    const int w = o->quick ? 79 : 316, h = o->quick ? 75 : 300;
    image im = image_new(3 * w + 2 * orders_gap, h);
    mesh m = orders_scene(6, false);
    for (size_t i = m.vertices - 4; i < m.vertices; i++) m.v[i].y = real_max(m.v[i].y, -5);
    camera c = orders_camera((real)w / (real)h);
    raster s = orders_first(&m, c, w, h), t = raster_new(w, h);
    raster_mesh(&t, &m, c, raster_default);
    bool *wrong = allocate((size_t)(w * h), sizeof *wrong);
    orders_panel(&im, 0, 0, &s, &m, c, NULL, NULL);
    orders_panel(&im, w + orders_gap, 0, &t, &m, c, NULL, NULL);
    for (int k = 0; k < w * h; k++)
        wrong[k] = vlength(vsub(image_get(&im, k % w, k / w),  /* more than other shades */
                                image_get(&im, w + orders_gap + k % w, k / w))) > (real)0.2;
    orders_panel(&im, 2 * (w + orders_gap), 0, &t, &m, c, NULL, wrong);
    panels_save(o, &im, 3, 1, orders_gap, title, "08_object_order_flat.png", true);
    free(wrong), raster_free(&s), raster_free(&t), mesh_free(&m);
}

/* ---------------------------------------------------------------------------------------------- */

typedef struct { const raster *s; const mesh *m; const shadow_map *map; real bias; bool *dark; }
    orders_shade;

static inline void orders_dark(int x, int y, void *context)
{
    const orders_shade *j = context;
    size_t k = (size_t)y * (size_t)j->s->nx + (size_t)x;
    hit h = j->s->h[k];
    vec3 p = h.shape == no_shape ? orders_lamp_place : orders_point(j->m, h);
    j->dark[k] = h.shape != no_shape
        && (j->map ? shadow_map_dark(j->map, p, j->bias)
                   : mesh_occluded(j->m, ray_shadow(p, orders_lamp_place, (real)1e-4)));
}

/* dark[k]: is the lamp hidden from what pixel k of s shows? By a map, or (NULL) by the ray of
 * (1.5), its ends left out. */
static inline bool orders_darken(orders_shade j, int threads)
{
    return parallel_pixels(j.s->nx, j.s->ny, threads, "shadows", orders_dark, &j);
}

cold_inline void orders_draw_shadow(const options *o)
{
    static const char *const title[4] = {"shadow rays", "map of 128 x 128, no bias: acne",
                                         "bias 0.04: loose from the foot",
                                         "map of 1024 x 1024, 0.004"};
    static const struct { int side; real bias; } map[4] = {{1, 0}, {128, 0}, {128, 0.04},
                                                           {1024, 0.004}};
    const int w = o->quick ? 60 : 400, h = o->quick ? 45 : 300;
    const size_t n = (size_t)(w * h);
    image im = image_new(2 * w + orders_gap, 2 * h + orders_gap);
    mesh m = orders_scene(4, false);
    camera c = orders_camera((real)w / (real)h);
    raster s = raster_new(w, h);
    bool *dark = allocate(n, 1), *wrong = allocate(n, 1), *due = allocate(n, 1);
    raster_mesh(&s, &m, c, raster_default);
    bool whole = true;
    for (int i = 0; i < 4; i++) {
        shadow_map t = shadow_map_new(&m, orders_lamp(), map[i].side, raster_default);
        orders_shade j = {&s, &m, i ? &t : NULL, map[i].bias, i ? dark : due};
        whole &= orders_darken(j, o->threads);
        for (size_t k = 0; k < n; k++) wrong[k] = j.dark[k] != due[k];
        orders_panel(&im, i % 2 * (w + orders_gap), i / 2 * (h + orders_gap), &s, &m, c, j.dark,
                     wrong);
        shadow_map_free(&t);
    }
    panels_save(o, &im, 2, 2, orders_gap, title, "08_object_order_shadow.png", whole);
    free(dark), free(wrong), free(due), raster_free(&s), mesh_free(&m);
}

/* Pixels that show the mirror take what the mirrored camera sees there. */
static inline raster orders_reflected(const mesh *m, camera c, const raster *s)
{
    raster t = raster_new(s->nx, s->ny);
    raster_how how = raster_default;
    mesh seen = *m;
    seen.triangles -= 2;  /* not the mirror itself */
    how.also = orders_mirror;
    raster_mesh(&t, &seen, mirror_camera(c, orders_mirror), how);
    return t;
}

cold_inline void orders_draw_mirror(const options *o)
{
    const int w = o->quick ? 144 : 720, h = o->quick ? 80 : 400;
    image im = image_new(w, h);
    mesh m = orders_scene(8, true);
    camera c = orders_look(vec(8.3, -7.4, 4.6), vec(-1.2, 0.1, 1.3), 33, (real)w / (real)h);
    raster s = raster_new(w, h);
    raster_mesh(&s, &m, c, raster_default);
    raster t = orders_reflected(&m, c, &s);
    size_t pot = m.triangles - orders_floor - 2;
    camera c2 = mirror_camera(c, orders_mirror);
    for (int k = 0; k < w * h; k++) {
        bool glass = s.h[k].shape != no_shape && s.h[k].shape >= pot + orders_floor;
        hit seen = glass ? t.h[k] : s.h[k];
        vec3 d = camera_ray(glass ? c2 : c, (real)(k % w) + (real)0.5, (real)(k / w) + (real)0.5,
                            w, h).d;
        vec3 colour = orders_colour(&m, pot, seen, d, true);
        image_set(&im, k % w, k / w, glass ? vmul(colour, vec(0.7, 0.78, 0.75)) : colour);
    }
    output_picture(o, &im, "08_object_order_mirror.png", false, true);
    image_free(&im), raster_free(&s), raster_free(&t), mesh_free(&m);
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
