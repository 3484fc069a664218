/* draw.h: a picture, pixel by pixel: rays out, what they see back, their weighted mean.
 *
 *   for each pixel, for each position (dx, dy) around its centre
 *       r = aim(view, x + dx, y + dy)         camera_ray, or a variant of it
 *       c = see(view, r)                      the colour that this ray meets
 *   pixel = sum w(dx, dy) c / sum w(dx, dy)   (2.10)
 *
 *   camera_view v = {.c = c, .scene = &scene, .f = filter_box, .n = 4, .how = SAMPLES_JITTERED};
 *   bool whole = camera_draw(&v, &im, threads);            false: stopped by Ctrl-C
 *   camera_draw_panels(&o, v, 4, 2, w, h, name, is_main);  four views, two in a row, as a file
 *
 * The random numbers of a pixel depend on (seed, pixel) alone.
 */
#ifndef CAMERA_LAB_DRAW_H
#define CAMERA_LAB_DRAW_H

#include "../../../common/lab/label.h"
#include "../../../common/output.h"
#include "../../../common/parallel.h"
#include "../camera.h"
#include "../filter.h"
#include "../samples.h"
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
    image *out;                                    /* set by draw */
};

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 camera_view_pixel(const camera_view *v, int x, int y)
{
    int nx = v->out->width, ny = v->out->height;
    random_stream s = random_start(v->seed, (uint64_t)y * (uint64_t)nx + (uint64_t)x, 0);
    filter_sum sum = {{0, 0, 0}, 0};
    for (int k = 0; k < v->n * v->n; k++) {
        real dx, dy;
        samples_place(v->how, k, v->n, v->f.radius, &s, &dx, &dy);
        real px = (real)x + (real)0.5 + dx, py = (real)y + (real)0.5 + dy;
        ray r = v->aim ? v->aim(v, px, py) : camera_ray(v->c, px, py, nx, ny);
        vec3 seen = v->see ? v->see(v, r) : room_colour(v->scene, r);
        sum = filter_add(sum, filter_weight(v->f, dx, dy), seen);
    }
    return filter_mean(sum);
}

static inline void camera_draw_pixel(int x, int y, void *context)
{
    const camera_view *v = context;
    image_set(v->out, x, y, camera_view_pixel(v, x, y));
}

static inline bool camera_draw(camera_view *v, image *out, int threads)
{
    v->out = out;
    return parallel_pixels(out->width, out->height, threads, "drawing", camera_draw_pixel, v);
}

/* n views, `columns` in a row, with a thin white gap, as one picture of w x h pixels. */
static inline void camera_draw_panels(const options *o, camera_view *v, int n, int columns, int w,
                                      int h, const char *name, bool is_main)
{
    int gap = w >= 64 && h >= 64 ? 6 : 0, rows = n / columns;
    bool whole = true;
    image all = label_sheet(w, h);
    for (int i = 0; i < n && whole; i++) {
        int column = i % columns, row = i / columns;
        int x = column * (w + gap) / columns, x1 = (column + 1) * (w + gap) / columns - gap;
        int y = row * (h + gap) / rows, y1 = (row + 1) * (h + gap) / rows - gap;
        if (x1 <= x || y1 <= y) continue;  /* a picture of one pixel has no room for four */
        image one = image_new(x1 - x, y1 - y);
        whole = camera_draw(&v[i], &one, o->threads);
        image_place(&all, x, y, &one);
        image_free(&one);
        if (v[i].tag && x1 - x > 200) label_tag(&all, x + 6, y + 6, 11, v[i].tag);
    }
    output_picture(o, &all, name, is_main, whole);
    image_free(&all);
}

#endif
