/* pictures.h: the gallery; its shadows far from the origin; the floor as seen from the spout.
 *
 *   draw_gallery(&o, n, spend_all)     the main picture, and what rays it took
 *   draw_acne(&o)                      two views at T = 1e4: naive, mended
 *   draw_sight(&o)                     a plan of the gallery: which points see each other
 */
#ifndef SHADE_LAB_PICTURES_H
#define SHADE_LAB_PICTURES_H

#include "../../../common/lab/label.h"
#include "../../../common/lab/stroke.h"
#include "../../../common/output.h"
#include "gallery.h"
#include "leave_variants.h"
#include "../sight.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void draw_gallery(const options *o, int n, bool spend_all)
{
    gallery *g = gallery_new(n, 0);
    image im = image_new(o->width, o->height);
    gallery_view v = {.g = g, .how = gallery_shading(g), .samples = 1, .im = &im,
                      .c = gallery_camera(0, (real)o->width / (real)o->height)};
    while ((v.samples + 1) * (v.samples + 1) <= o->samples) v.samples++;
    v.how.spend_all = spend_all;
    double start = clock_seconds();
    bool whole = gallery_draw(&v, o->threads);
    printf("# %zu camera rays, %zu hits; %zu shadow rays, %zu of them stopped; %.2f s\n",
           v.counts.rays[RAY_CAMERA], v.counts.hits[RAY_CAMERA], v.counts.rays[RAY_SHADOW],
           v.counts.hits[RAY_SHADOW], clock_seconds() - start);
    output_picture(o, &im, "18_shade.png", true, whole);
    image_free(&im), gallery_free(g);
}

/* The hit point as a program in float keeps it: t and p rounded, and no bound. */
static inline surface surface_f32(const tracer *t, ray r, trace_hit x)
{
    surface s = surface_of_trace(t, r, x);
    float at = (float)x.h.t;
    float px = (float)r.o.x + at * (float)r.d.x, py = (float)r.o.y + at * (float)r.d.y;
    float pz = (float)r.o.z + at * (float)r.d.z;
    s.p = vec(px, py, pz), s.error = s.noise = 0;
    return s;
}

static inline ray leave_fixed_3e2(surface s, vec3 w)
{
    return (ray){s.p, (real)0.03 / vlength(w), w, real_infinity};
}

/* Above: all of it; below: where the card meets the floor. Left: float and a fixed eps; right:
 * bounds. */
static inline void draw_acne(const options *o)
{
    const real T = 10000;
    int w = o->quick ? 96 : 400, h = w * 9 / 16;
    gallery *g = gallery_new(o->quick ? 6 : 24, T);
    image all = image_new(2 * w + 6, 2 * h + 6), im = image_new(w, h);
    bool whole = true;
    for (size_t i = 0; i < 3 * (size_t)all.width * (size_t)all.height; i++) all.rgb[i] = 1;
    for (int k = 0; k < 4 && whole; k++) {
        gallery_view v = {.g = g, .how = gallery_shading(g), .samples = o->quick ? 1 : 2,
                          .im = &im};
        if (k % 2 == 0) v.how.surface_of = surface_f32;
        if (k % 2 == 0) v.how.leave = k ? leave_fixed_3e2 : leave_first;
        v.c = (k < 2 ? gallery_camera : gallery_close_up)(T, (real)w / (real)h);
        whole = gallery_draw(&v, o->threads);
        image_place(&all, k % 2 * (w + 6), k / 2 * (h + 6), &im);
    }
    static const char *const title[] = {"float, tmin = 1e-4: acne", "leave", "tmin = 0.03: leaks",
                                        "leave"};
    image sheet = label_panels(&all, 2, 2, 6, title);
    output_picture(o, &sheet, "18_shade_acne.png", false, whole);
    image_free(&all), image_free(&im), image_free(&sheet), gallery_free(g);
}

/* ---------------------------------------------------------------------------------------------- */

enum { sight_posts = 9 };

/* A point in the air, at knee height over (x, y). */
static inline surface sight_post(double x, double y)
{
    return (surface){{(real)x, (real)y, 0.5}, {0, 0, 0}, {0, 0, 0}, 0, 0, no_shape};
}

typedef struct { const gallery *g; image *im; } sight_map;

/* What two of the posts see: 14 x 10 units of the floor's plan, y upwards. */
static inline void sight_pixel(int x, int y, void *context)
{
    const sight_map *m = context;
    real s = 14 / (real)m->im->width;
    surface at = sight_post((double)(((real)x + (real)0.5) * s - 7),
                            (double)(4 - ((real)y + (real)0.5) * s));
    tracer t = {.w = &m->g->w, .program = shade_programs};
    surface from[2] = {sight_post(-0.6, -5.8), sight_post(6.4, -2.6)};
    bool a = sight_free(&t, from[0], at), b = sight_free(&t, from[1], at);
    vec3 dark = {0.035, 0.04, 0.06};
    vec3 c = vadd(dark, vadd(a ? vec(0.55, 0.28, 0) : (vec3){0, 0, 0},
                             b ? vec(0, 0.2, 0.6) : (vec3){0, 0, 0}));
    image_set(m->im, x, y, c);
}

static inline void draw_sight(const options *o)
{
    static const double at[sight_posts][2] = {
        {-0.6, -5.8}, {6.4, -2.6}, {-6.2, -4}, {-3.6, 2.8}, {0.3, 3.2},
        {6.2, 3}, {-1.5, -2.3}, {3.4, -1.2}, {0.5, -3.2}};
    gallery *g = gallery_new(o->quick ? 6 : 24, 0);
    image im = image_new(o->quick ? 168 : 700, o->quick ? 120 : 500);
    sight_map m = {g, &im};
    bool whole = parallel_pixels(im.width, im.height, o->threads, "sight", sight_pixel, &m);
    real s = (real)im.width / 14;
    tracer t = {.w = &g->w, .program = shade_programs};
    for (int i = 0; i < sight_posts; i++)
        for (int j = i; j < sight_posts; j++) {
            surface a = sight_post(at[i][0], at[i][1]), b = sight_post(at[j][0], at[j][1]);
            real x0 = (a.p.x + 7) * s, y0 = (4 - a.p.y) * s;
            real x1 = (b.p.x + 7) * s, y1 = (4 - b.p.y) * s;
            vec3 white = {1, 1, 1}, grey = vscale(white, 0.8);
            if (i == j) draw_stroke(&im, x0, y0, x0, y0, s / 5, white);
            else if (sight_free(&t, a, b)) draw_stroke(&im, x0, y0, x1, y1, 0.3, grey);
        }
    output_picture(o, &im, "18_shade_sight.png", false, whole);
    image_free(&im), gallery_free(g);
}

#endif
