/* pictures.h: the two spheres; the tank, naively and well; depths.
 *
 *   draw_two_spheres(&o, all) the main picture, and what rays it took
 *   draw_tank(&o)             left: faces that touch taken one by one; right: as one
 *   draw_depths(&o)           forty balls: depth 1, 2, 3, 8
 */
#ifndef WHITTED_LAB_PICTURES_H
#define WHITTED_LAB_PICTURES_H

#include "../../../common/lab/panels.h"
#include "../scenes/forty.h"
#include "tank.h"
#include "two_spheres.h"

typedef struct {
    tracer t;              /* as it begins: copied for each ray */
    camera c;
    int across;            /* across^2 rays a pixel */
    image *im;
    pthread_mutex_t lock;
    trace_counts counts;
} whitted_view;

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 whitted_colour(const void *context, real x, real y)
{
    whitted_view *v = *(whitted_view *const *)context;
    tracer t = v->t;
    ray r = camera_ray(v->c, x, y, v->im->width, v->im->height);
    vec3 c = whitted_ray(&t, r, (media_set){0});
    pthread_mutex_lock(&v->lock);
    trace_counts_add(&v->counts, &t.counts);
    pthread_mutex_unlock(&v->lock);
    return vmin(c, (vec3){4, 4, 4});  /* a highlight must not outshout its pixel */
}

/* Sets v->counts. False: stopped by Ctrl-C. */
static inline bool whitted_draw(whitted_view *v, int threads)
{
    v->counts = (trace_counts){0};
    pthread_mutex_init(&v->lock, NULL);
    bool whole = pixels_draw(v->im, v->across, threads, "drawing", whitted_colour, &v);
    pthread_mutex_destroy(&v->lock);
    return whole;
}

cold_inline void draw_two_spheres(const options *o, bool spend_all)
{
    whitted_stage *s = two_spheres_new();
    image im = image_new(o->width, o->height);
    whitted_view v = {.t = stage_tracer(s), .im = &im, .across = 1,
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
    image_free(&im), stage_end(s), free(s);
}

/* A panel for each `how`, side by side, two in a row. Frees s. */
static inline void draw_variants(const options *o, const char *name, whitted_stage *s, camera c,
                                 int w, const whitted *how, const char *const *title, int n)
{
    int h = w * 3 / 4, rows = n / 2;
    bool whole = true;
    image sheet = {0}, im = image_new(w, h);
    for (int i = 0; i < n && whole; i++) {
        whitted_view v = {.t = stage_tracer(s), .c = c, .im = &im, .across = o->quick ? 1 : 2};
        v.t.user = &how[i];
        whole = whitted_draw(&v, o->threads);
        label_panel(&sheet, 2, rows, 6, i, &im);
    }
    panels_save(o, &sheet, 2, rows, 6, title, name, whole);
    image_free(&im), stage_end(s), free(s);
}

cold_inline void draw_tank(const options *o)
{
    static const char *const title[] = {"each face by itself", "faces at one place as one"};
    whitted_stage *k = tank_new();
    whitted how[2] = {k->w, k->w};
    how[0].apart = true;
    draw_variants(o, "19_whitted_tank.png", k, tank_camera((real)4 / 3), o->quick ? 96 : 320, how,
                  title, 2);
}

cold_inline void draw_depths(const options *o)
{
    static const char *const title[] = {"depth 1", "depth 2: mirrors", "depth 3: glass", "depth 8"};
    whitted_stage *f = forty_new();
    whitted how[4] = {f->w, f->w, f->w, f->w};
    for (int i = 0; i < 3; i++) how[i].depth = i + 1;
    draw_variants(o, "19_whitted_depth.png", f, forty_camera((real)4 / 3), o->quick ? 64 : 360, how,
                  title, 4);
}

#endif
