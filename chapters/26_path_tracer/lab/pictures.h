/* pictures.h: the committed pictures of the chapter.
 *
 *   draw_scene(o, "rough", w, h, samples, exposure, file, is_main)      a scene of showcase.h
 *   draw_strategies(o)  directions, roulette, light samples, MIS: one by one, as many rays each
 *   draw_ladder(o)      the box by 1, 4, 16 .. 4096 samples a pixel, and how far off each is
 *
 * The numbers of samples are fixed, so that the bytes are. Powers of two: two halves (film.h) of
 * 2^k Sobol' points each are spread best (20).
 */
#ifndef PATH_PICTURES_H
#define PATH_PICTURES_H

#include "../../../common/lab/label.h"
#include "measure.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void pictures_expose(image *im, real exposure)
{
    for (size_t i = 0; i < 3 * (size_t)im->width * (size_t)im->height; i++)
        im->rgb[i] *= (float)exposure;
}

static inline void draw_scene(const options *o, const char *scene_name, int w, int h,
                              uint32_t samples, real exposure, const char *file, bool is_main)
{
    showcase c;
    failure why;
    path_tracer t;
    int q = o->quick && !is_main ? 6 : 1;
    if (!showcase_of(scene_name, (real)(w / q) / (real)(h / q), &c, &why)) fail(why);
    path_tracer_of(&c.s, showcase_sky(&c), path_defaults, &t);
    render_job j = {.tracer = &t, .eye = c.eye, .seed = o->seed, .threads = o->threads};
    film f = film_new(w / q, h / q);
    bool whole = render_range(&j, &f, 0, o->quick ? 4 : samples);
    image im = film_picture(&f);
    pictures_expose(&im, exposure);
    output_picture(o, &im, file, is_main, whole);
    image_free(&im), film_free(&f), path_tracer_free(&t), showcase_free(&c);
}

/* One film: each rung adds samples to the one before, and says itself how far off it is (26.7). */
static inline void draw_ladder(const options *o)
{
    enum { rungs = 7, side = 64, larger = 2, size = side * larger };
    const char *title[rungs];
    char said[rungs][32];
    int n = o->quick ? 3 : rungs;
    for (int k = 0; k < rungs; k++) title[k] = said[k], *said[k] = 0;
    showcase c;
    failure why;
    path_tracer t;
    double before = 0;
    bool whole = true;
    if (!showcase_of("cornell", 1, &c, &why)) fail(why);
    path_tracer_of(&c.s, NULL, path_defaults, &t);
    render_job j = {.tracer = &t, .eye = c.eye, .seed = o->seed, .threads = o->threads};
    film f = film_new(side, side);
    image all = image_new(n * size, size);
    table rows = table_new("The ladder: the box by ever more samples, one film", "samples a pixel|"
                           "error RMSE, estimated|of the rung before|rays a path|time [s]");
    for (int k = 0; k < n && whole; k++) {
        uint32_t samples = 1u << 2 * k;
        whole = render_range(&j, &f, k ? samples / 4 : 0, samples);
        double error = film_error(&f);
        image im = film_picture(&f);
        pictures_expose(&im, 2);
        for (int i = 0; i < size * size; i++) {
            int x = i % size, y = i / size;
            image_set(&all, k * size + x, y, image_get(&im, x / larger, y / larger));
        }
        image_free(&im);
        table_count(&rows, samples);
        table_text(&rows, k ? "%.3g" : "-", error);
        table_text(&rows, k > 1 ? "1 / %.2f" : "-", before / error);
        table_number(&rows, (double)path_rays(&j.counts) / (double)j.counts.paths);
        table_number(&rows, j.pass.seconds);
        snprintf(said[k], sizeof said[k], k ? "%u: %.2g" : "1 sample", (unsigned)samples, error);
        before = error;
    }
    output_extra_table(o, &rows);
    label_titles(&all, n, 1, 0, title);
    output_picture(o, &all, "26_path_tracer_ladder.png", false, whole);
    image_free(&all);
    film_free(&f), path_tracer_free(&t), showcase_free(&c);
}

/* The ideas of the chapter, one by one, in the box with a ball of metal and a matte one. Each panel
 * has as many samples as make step_budget rays a pixel: equal rays, not equal seconds, so that
 * the bytes are the same everywhere. */
enum { step_panels = 4, step_budget = 64 };
static inline path_options step_options(int step)
{
    path_options how = path_defaults;
    how.sequence = SEQUENCE_RANDOM;
    how.roulette = step < 1 ? ROULETTE_NONE : ROULETTE_THROUGHPUT;
    how.light_sampling = step >= 2, how.mis = step >= 3;
    return how;
}

static inline void step_scene(showcase *c)
{
    failure f;
    if (!showcase_of("spheres", 1, c, &f)) fail(f);
    lit_material *ball = c->s.material + cornell_parts;  /* mirror, glass */
    ball[0] = (lit_material){.f = brdf_ggx(vec(0.95, 0.93, 0.88), (real)0.12)};
    ball[1] = (lit_material){.f = brdf_lambert(vec(0.7, 0.7, 0.7))};
}

static inline image step_picture(const options *o, const showcase *c, int step, int side,
                                 char said[64], bool *whole)
{
    path_tracer t;
    double pixels = (double)side * side, budget = o->quick ? 12 : step_budget;
    path_tracer_of(&c->s, NULL, step_options(step), &t);
    render_job j = {.tracer = &t, .eye = c->eye, .seed = o->seed, .threads = o->threads};
    film f = film_new(side, side);
    uint32_t n = 0;
    for (*whole = true; *whole && (double)path_rays(&j.counts) < budget * pixels; n++)
        *whole = render_range(&j, &f, n, n + 1);
    snprintf(said, 64, "%u samples, error %.2f", (unsigned)n, film_error(&f));
    image im = film_picture(&f);
    film_free(&f), path_tracer_free(&t);
    return im;
}

static inline void draw_strategies(const options *o)
{
    static const char *const title[step_panels] = {"1 directions alone", "2 and roulette",
                                                   "3 and light samples", "4 and MIS"};
    enum { size = 10 };
    int side = o->quick ? 24 : 232;
    bool whole = true;
    showcase c;
    step_scene(&c);
    image all = image_new(step_panels * side, side);
    for (int k = 0; k < step_panels && whole; k++) {
        char said[64];
        image im = step_picture(o, &c, k, side, said, &whole);
        pictures_expose(&im, 2);
        label_tag(&im, 0, side - 2 * size, size, said);
        image_place(&all, k * side, 0, &im);
        image_free(&im);
    }
    label_titles(&all, step_panels, 1, 0, title);
    output_picture(o, &all, "26_path_tracer_strategies.png", false, whole);
    image_free(&all), showcase_free(&c);
}

#endif
