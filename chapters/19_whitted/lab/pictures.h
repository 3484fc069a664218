/* pictures.h: the two spheres; the tank, naively and well; depths.
 *
 *   draw_two_spheres(&o, all) the main picture, and what rays it took
 *   draw_tank(&o)             left: faces that touch taken one by one; right: as one
 *   draw_depths(&o)           forty balls: depth 1, 2, 3, 8
 */
#ifndef WHITTED_LAB_PICTURES_H
#define WHITTED_LAB_PICTURES_H

#include "../../../common/lab/label.h"
#include "../../../common/output.h"
#include "../scenes/forty.h"
#include "../whitted_loop.h"
#include "tank.h"
#include "two_spheres.h"

typedef struct {
    tracer t;              /* as it begins: copied for each pixel */
    camera c;
    int across;            /* across^2 rays a pixel */
    bool loop;             /* by whitted_loop.h */
    image *im;
    pthread_mutex_t lock;
    trace_counts counts;
} whitted_view;

/* ---------------------------------------------------------------------------------------------- */

static inline void whitted_pixel(int x, int y, void *context)
{
    whitted_view *v = context;
    tracer t = v->t;
    vec3 sum = {0, 0, 0};
    int n = v->across;
    for (int k = 0; k < n * n; k++) {
        real px = (real)x + ((real)(k % n) + (real)0.5) / (real)n;
        real py = (real)y + ((real)(k / n) + (real)0.5) / (real)n;
        ray r = camera_ray(v->c, px, py, v->im->width, v->im->height);
        vec3 c = (v->loop ? whitted_ray_loop : whitted_ray)(&t, r, (media_set){0});
        sum = vadd(sum, vmin(c, (vec3){4, 4, 4}));  /* a highlight must not outshout its pixel */
    }
    image_set(v->im, x, y, vscale(sum, 1 / (real)(n * n)));
    pthread_mutex_lock(&v->lock);
    trace_counts_add(&v->counts, &t.counts);
    pthread_mutex_unlock(&v->lock);
}

/* Sets v->counts. False: stopped by Ctrl-C. */
static inline bool whitted_draw(whitted_view *v, int threads)
{
    v->counts = (trace_counts){0};
    pthread_mutex_init(&v->lock, NULL);
    bool whole = parallel_pixels(v->im->width, v->im->height, threads, "drawing", whitted_pixel, v);
    pthread_mutex_destroy(&v->lock);
    return whole;
}

static inline void draw_two_spheres(const options *o, bool spend_all)
{
    two_spheres *s = two_spheres_new();
    image im = image_new(o->width, o->height);
    whitted_view v = {.t = two_spheres_tracer(s), .im = &im, .across = 1,
                      .c = two_spheres_camera((real)o->width / (real)o->height)};
    while ((v.across + 1) * (v.across + 1) <= o->samples) v.across++;
    s->w.spend_all = spend_all;
    double start = clock_seconds();
    bool whole = whitted_draw(&v, o->threads);
    printf("# two spheres:");
    for (int k = 0; k < RAY_SIGHT; k++)
        printf(" %zu %s rays%s", v.counts.rays[k], ray_kind_names[k],
               k + 1 < RAY_SIGHT ? "," : ";");
    printf(" %.2f s\n", clock_seconds() - start);
    output_picture(o, &im, "19_whitted.png", true, whole);
    image_free(&im), two_spheres_free(s);
}

static inline void draw_tank(const options *o)
{
    tank *k = tank_new();
    int w = o->quick ? 96 : 360, h = w * 3 / 4;
    bool whole = true;
    image all = image_new(2 * w + 6, h), im = image_new(w, h);
    for (size_t i = 0; i < 3 * (size_t)all.width * (size_t)all.height; i++) all.rgb[i] = 1;
    for (int i = 0; i < 2 && whole; i++) {
        k->w.apart = i == 0;
        whitted_view v = {.t = tank_tracer(k), .c = tank_camera((real)w / (real)h), .im = &im,
                          .across = o->quick ? 1 : 2};
        whole = whitted_draw(&v, o->threads);
        image_place(&all, i * (w + 6), 0, &im);
    }
    static const char *const title[] = {"each face by itself", "faces at one place as one"};
    image sheet = label_panels(&all, 2, 1, 6, title);
    output_picture(o, &sheet, "19_whitted_tank.png", false, whole);
    image_free(&im), image_free(&all), image_free(&sheet), tank_free(k);
}

static inline void draw_depths(const options *o)
{
    static const int depth[4] = {1, 2, 3, 8};
    forty *f = allocate(1, sizeof *f);
    forty_fill(f);
    int w = o->quick ? 64 : 360, h = w * 3 / 4;
    bool whole = true;
    image all = image_new(2 * w + 6, 2 * h + 6), im = image_new(w, h);
    for (size_t i = 0; i < 3 * (size_t)all.width * (size_t)all.height; i++) all.rgb[i] = 1;
    for (int i = 0; i < 4 && whole; i++) {
        f->w.depth = depth[i];
        whitted_view v = {.t = forty_tracer(f), .c = forty_camera((real)w / (real)h), .im = &im,
                          .across = o->quick ? 1 : 2};
        whole = whitted_draw(&v, o->threads);
        image_place(&all, i % 2 * (w + 6), i / 2 * (h + 6), &im);
    }
    static const char *const title[] = {"depth 1", "depth 2: mirrors", "depth 3: glass", "depth 8"};
    image sheet = label_panels(&all, 2, 2, 6, title);
    output_picture(o, &sheet, "19_whitted_depth.png", false, whole);
    image_free(&im), image_free(&all), image_free(&sheet), forty_free(f), free(f);
}

#endif
