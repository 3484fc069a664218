/* pictures.h: the committed pictures of the chapter.
 *
 *   draw_cornell(o)     the box: the main picture
 *   draw_others(o)      mirror and glass in the box; rough copper under a sky; furnace
 *   draw_strategies(o)  the box, 16 samples a pixel: naive, lights, both, Sobol' points
 *
 * Each with so many samples as a few seconds make; fixed, so that the bytes are. Powers of two: two
 * halves (film.h) of 2^k Sobol' points each are spread best (20).
 */
#ifndef PATH_PICTURES_H
#define PATH_PICTURES_H

#include "measure.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void draw_scene(const options *o, const char *scene_name, int w, int h,
                              uint32_t samples, real exposure, const char *file, bool is_main)
{
    showcase c;
    failure why;
    path_tracer t;
    if (!showcase_of(scene_name, (real)w / (real)h, &c, &why)) fail(why);
    path_tracer_of(&c.s, showcase_sky(&c), path_defaults, &t);
    render_job j = {.tracer = &t, .eye = c.eye, .seed = o->seed, .threads = o->threads};
    film f = film_new(w, h);
    bool whole = render_range(&j, &f, 0, samples);
    image im = film_picture(&f);
    for (size_t i = 0; i < 3 * (size_t)w * (size_t)h; i++) im.rgb[i] *= (float)exposure;
    output_picture(o, &im, file, is_main, whole);
    image_free(&im), film_free(&f), path_tracer_free(&t), showcase_free(&c);
}

static inline void draw_cornell(const options *o)
{
    draw_scene(o, "cornell", o->width, o->height, o->quick ? 4 : 64, 2, "26_path_tracer.png", true);
}

static inline void draw_others(const options *o)
{
    int q = o->quick ? 4 : 1;
    if (o->out) return;
    draw_scene(o, "spheres", 288 / q, 288 / q, o->quick ? 4 : 32, 2, "26_path_tracer_spheres.png",
               false);
    draw_scene(o, "teapot", 360 / q, 240 / q, o->quick ? 4 : 16, 1, "26_path_tracer_teapot.png",
               false);
    draw_scene(o, "furnace", 360 / q, 240 / q, o->quick ? 4 : 16, 0.8,
               "26_path_tracer_furnace.png", false);
}

/* Panels side by side, the same number of samples. */
static inline void draw_strategies(const options *o)
{
    strategy s[strategies];
    const int shown[4] = {0, 2, 5, 6};
    int side = o->quick ? 24 : 160;
    measure_place m = {.side = side};
    failure f;
    if (o->out) return;
    if (!showcase_of("cornell", 1, &m.c, &f)) fail(f);
    strategy_list(s);
    image all = image_new(4 * side, side);
    for (int k = 0; k < 4; k++) {
        double seconds;
        size_t rays;
        image im = measure_render(&m, &s[shown[k]], o->seed, o->quick ? 2 : 16, &seconds, &rays);
        for (int i = 0; i < 3 * side * side; i++) im.rgb[i] *= 2;
        image_place(&all, k * side, 0, &im);
        image_free(&im);
    }
    output_picture(o, &all, "26_path_tracer_strategies.png", false, true);
    image_free(&all), showcase_free(&m.c);
}

#endif
