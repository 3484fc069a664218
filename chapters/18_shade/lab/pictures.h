/* pictures.h: the gallery; its shadows far from the origin.
 *
 *   draw_gallery(&o, n, spend_all)     the main picture, and what rays it took
 *   draw_acne(&o)                      two views at T = 1e4: naive, mended
 */
#ifndef SHADE_LAB_PICTURES_H
#define SHADE_LAB_PICTURES_H

#include "../../../common/lab/label.h"
#include "../../../common/output.h"
#include "gallery.h"
#include "leave_variants.h"

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
    image all = label_sheet(2 * w + 6, 2 * h + 6), im = image_new(w, h);
    bool whole = true;
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
    label_titles(&all, 2, 2, 6, title);
    output_picture(o, &all, "18_shade_acne.png", false, whole);
    image_free(&all), image_free(&im), gallery_free(g);
}

#endif
