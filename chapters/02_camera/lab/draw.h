/* draw.h: a picture, pixel by pixel: rays out, what they see back, their weighted mean.
 *
 *   for each pixel, for each position (dx, dy) around its centre
 *       r = aim(view, x + dx, y + dy)         camera_ray, or a variant of it
 *       c = see(view, r)                      the colour that this ray meets
 *   pixel = sum w(dx, dy) c / sum w(dx, dy)   (2.10)
 *
 *   camera_view v = {.c = c, .scene = &scene, .f = filter_box, .n = 4, .how = SAMPLES_JITTERED};
 *   pixels_draw(&im, 1, threads, "drawing", camera_colour, &v);
 *   camera_draw_panels(&o, v, g, name, is_main);   views, one a panel of shape g, as a file
 *
 * The random numbers of a pixel depend on (seed, pixel) alone.
 */
#ifndef CAMERA_LAB_DRAW_H
#define CAMERA_LAB_DRAW_H

#include "../../../common/lab/panels.h"
#include "../camera.h"
#include "../filter.h"
#include "room.h"

typedef struct camera_view camera_view;
struct camera_view {
    camera c;
    const camera_room *scene;
    filter f;
    int n;                                         /* n x n rays a pixel */
    sample_placement how;
    uint64_t seed;
    ray (*aim)(const camera_view *v, real x, real y);     /* NULL: camera_ray */
    vec3 (*see)(const camera_view *v, ray r);             /* NULL: room_colour */
    const void *own;                               /* for aim and see */
    const char *tag;                               /* a name, drawn into a panel */
    int nx, ny;                                    /* pixels */
};

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 camera_view_pixel(const camera_view *v, int x, int y)
{
    random_stream s = random_start(v->seed, (uint64_t)y * (uint64_t)v->nx + (uint64_t)x, 0);
    filter_sum sum = {{0, 0, 0}, 0};
    for (int k = 0; k < v->n * v->n; k++) {
        real dx, dy;
        samples_place(v->how, k, v->n, v->f.radius, &s, &dx, &dy);
        real px = (real)x + (real)0.5 + dx, py = (real)y + (real)0.5 + dy;
        ray r = v->aim ? v->aim(v, px, py) : camera_ray(v->c, px, py, v->nx, v->ny);
        vec3 seen = v->see ? v->see(v, r) : room_colour(v->scene, r);
        sum = filter_add(sum, filter_weight(v->f, dx, dy), seen);
    }
    return filter_mean(sum);
}

static vec3 camera_colour(const void *view, real x, real y)
{
    return camera_view_pixel(view, (int)x, (int)y);
}

static inline void camera_draw_panels(const options *o, camera_view *v, panels_shape g,
                                      const char *name, bool is_main)
{
    panel p[panels_most];
    for (int k = 0; k < g.columns * g.rows; k++) {
        v[k].nx = panels_wide(g), v[k].ny = panels_high(g);
        p[k] = (panel){v[k].tag, &v[k]};
    }
    panels_draw(o, name, is_main, g, camera_colour, p);
}

#endif
