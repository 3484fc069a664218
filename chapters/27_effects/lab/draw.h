/* draw.h: the picture of a stage, or a part of it, on the film of 26; what it took.
 *
 *   drawing j = {.e = &e, .samples = 16, .seed = 1, .width = w, .height = h};
 *   bool whole = draw_region(&j, &im, x0, y0, threads)    im's pixels are those from (x0, y0) on of
 *                                     a picture of width x height; false: stopped by Ctrl-C
 *   j.counts, j.pass.seconds          rays by effect; time
 *   j.error                           RMSE by halves (26.7); infinity with one sample
 *   passes_until(draw_begin(&j, x0, y0, threads), &f, goal)    the same on a film f, by passes
 *   draw_rays(&j.counts)              all rays
 *   draw_z(&a, &b)                    two pictures of the same light? in standard errors
 *
 * Samples lie in the pixel by Sobol'; with j.middle in its middle: for one alone, without chance.
 */
#ifndef EFFECTS_DRAW_H
#define EFFECTS_DRAW_H

#include "../../26_path_tracer/passes.h"
#include "../special.h"

typedef struct {
    const effects_stage *e;
    int samples;              /* of a pixel: of draw_region */
    uint64_t seed;
    int width, height;        /* of the whole picture */
    bool middle;
    int x0, y0;               /* of the film's first pixel */
    media_set around;         /* bodies that the eye is in */
    film_passes pass;
    effects_counts counts;
    double error;
    size_t pixels;            /* of the film */
} drawing;

/* ---------------------------------------------------------------------------------------------- */

/* The ray of a sample of a pixel. */
effects_inline ray draw_ray(const drawing *j, int x, int y, const dice *d)
{
    const effects_stage *e = j->e;
    point2 at = {0.5, 0.5}, on = {0, 0};
    bool lens = (e->mask & EFFECT_DEPTH_OF_FIELD) != 0;
    if (!j->middle) at = dice_eye(d, DICE_PIXEL);
    if (lens) on = dice_eye(d, DICE_LENS);
    thin_lens l = {lens ? e->lens.radius : 0, e->lens.focus};
    ray r = lens_ray(e->eye, l, (real)x + at.u, (real)y + at.v, j->width, j->height, on);
    r.tmin = e->hither;
    return r;
}

/* The samples of a pass, of one pixel. */
static inline film_pixel draw_pixel(const drawing *j, effects_function *f, int x, int y,
                                    effects_counts *c)
{
    film_pixel sum = {{{{{0, 0}}}}};
    uint64_t i = (uint64_t)y * (uint64_t)j->width + (uint64_t)x;
    dice_pixel of;
    if (!j->middle) dice_pixel_of(j->seed, i, &of);
    for (uint32_t k = j->pass.now.begin; k < j->pass.now.end; k++) {
        dice d = {.own = 0};
        if (!j->middle) d = dice_sample(&of, k);
        ray r = draw_ray(j, x, y, &d);
        if (j->e->mask & EFFECT_DEPTH_OF_FIELD) c->rays[RAY_OF_LENS]++;
        film_pixel_add(&sum, k, f(j->e, r, j->around, &d, c));
    }
    return sum;
}

static inline void draw_tile(size_t tile, void *context)
{
    drawing *j = context;
    effects_function *f = effects_made_for(j->e->mask);
    effects_counts c = {.lost = 0};
    film *to = j->pass.to;
    film_window w = film_window_of(to, tile);
    for (int y = w.y0; y < w.y1; y++)
        for (int x = w.x0; x < w.x1; x++) {
            film_pixel sum = draw_pixel(j, f, x + j->x0, y + j->y0, &c);
            film_gather(to, (size_t)y * (size_t)to->width + (size_t)x, &sum);
        }
    to->tile[tile] = true;
    pthread_mutex_lock(&j->pass.lock);
    effects_counts_add(&j->counts, &c);
    pthread_mutex_unlock(&j->pass.lock);
}

static inline film_passes *draw_begin(drawing *j, int x0, int y0, int threads)
{
    j->around = bodies_around(j->e, j->e->eye.e);
    j->x0 = x0, j->y0 = y0, j->counts = (effects_counts){.lost = 0};
    j->pass = (film_passes){.tile = draw_tile, .job = j, .threads = threads};
    return &j->pass;
}

static inline bool draw_region(drawing *j, image *im, int x0, int y0, int threads)
{
    film f = film_new(im->width, im->height);
    j->pixels = (size_t)im->width * (size_t)im->height;
    j->middle = j->samples == 1 && !j->e->chance;
    bool whole = passes_range(draw_begin(j, x0, y0, threads), &f, 0, (uint32_t)j->samples);
    image done = film_picture(&f);
    memcpy(im->rgb, done.rgb, 3 * j->pixels * sizeof *im->rgb);
    j->error = film_error(&f);
    image_free(&done), film_free(&f);
    return whole;
}

/* All rays that were traced. */
static inline size_t draw_rays(const effects_counts *c)
{
    size_t n = c->rays[RAY_OF_EYE];
    for (int k = 0; k < effect_kinds; k++)
        n += k == RAY_ABSORBED || k == RAY_OF_LENS ? 0 : c->rays[k];
    return n;
}

/* How sure one is that two pictures are of different light: their mean difference, in units of its
 * standard error. Pixels are independent of one another. */
static inline double draw_z(const image *a, const image *b)
{
    size_t n = (size_t)a->width * (size_t)a->height;
    double sum = 0, squares = 0;
    for (size_t i = 0; i < n; i++) {
        double d = 0;
        for (size_t k = 3 * i; k < 3 * i + 3; k++) d += (double)a->rgb[k] - (double)b->rgb[k];
        sum += d, squares += d * d;
    }
    double mean = sum / (double)n, variance = squares / (double)n - mean * mean;
    return variance > 0 ? fabs(mean) / sqrt(variance / (double)n) : 0;
}

#endif
