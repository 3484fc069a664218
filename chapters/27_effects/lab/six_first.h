/* six_first.h: the short book's plan, first.h, on a scene that was drawn by the full one.
 *
 *   table t = first_table(title);
 *   first_row(&t, "1_sun", &s, &view, &j, &im)    j: the drawing that gave the picture im
 *
 * first.h draws a fifth as wide and high, with as many samples a pixel as im has: a grid of them,
 * each somewhere in its cell. (In the middle of each cell, all pixels of a row would be wrong alike
 * where the horizon passes through them.) A pixel of its picture is 5 x 5 of im, which has 25 times
 * its samples. Off by: the mean of all differences of pixels, over the mean of im; +-: its standard
 * error. Noise: what a pixel differs by, RMS, about that mean; of the full version's own picture of
 * that size, too. The two times are the processor's, of such pictures, by one thread; where a pixel
 * has few samples, medians. Its rays: of the eye, and what first_rays counts: the points of the
 * lamp that it draws, also those behind a surface, to which it sends no ray.
 */
#ifndef EFFECTS_SIX_FIRST_H
#define EFFECTS_SIX_FIRST_H

#include "../../../common/clock.h"
#include "../../../common/lab/table.h"
#include "../../../common/numbers/estimate.h"
#include "draw.h"
#include "first_studio.h"

enum { first_row_part = 5, first_row_depth = 40, first_row_rounds = 5 };

static const char *const first_row_name[first_effects] = {
    "shadows", "mirrors", "glass", "lamp", "bounces"};

typedef struct {
    const drawing *j;      /* as the full version has it; here of the small picture, one thread */
    const first_scene *f;
    const first_plan *p;
    first_camera c;
    image im, full;        /* of w x h, by first.h and by the full version */
} first_run;

/* ---------------------------------------------------------------------------------------------- */

static inline table first_table(const char *title)
{
    return table_new(title, "scene|first calls for|its rays|full: rays|its [us/pixel]|"
                            "full: [us/pixel]|off by [%]|+- [%]|its noise [%]|full: noise [%]");
}

static inline double first_row_grey(const image *im, int x, int y)
{
    vec3 c = image_get(im, x, y);
    return (double)(c.x + c.y + c.z) / 3;
}

/* Its samples. The counts of first_rays are those of the last picture. */
static inline void first_row_draw(first_run *k)
{
    int n = (int)sqrt((double)k->j->samples);
    memset(first_rays, 0, sizeof first_rays);
    for (int y = 0; y < k->im.height; y++)
        for (int x = 0; x < k->im.width; x++) {
            uint64_t pixel = (uint64_t)(y * k->im.width + x);
            vec3 sum = {0, 0, 0};
            for (int i = 0; i < n * n; i++) {
                random_stream random = random_start(k->j->seed, pixel, (uint64_t)i);
                real u = random_next(&random), v = random_next(&random);
                ray r = first_camera_ray(k->c, (real)x + ((real)(i % n) + u) / (real)n,
                                         (real)y + ((real)(i / n) + v) / (real)n);
                r = first_ray_unit(r);
                sum = vadd(sum, first_planned(k->f, k->p, r, true, first_row_depth, &random));
            }
            image_set(&k->im, x, y, vscale(sum, 1 / (real)(n * n)));
        }
}

static inline void first_row_full(first_run *k)
{
    drawing again = {.e = k->j->e, .samples = k->j->samples, .seed = k->j->seed,
                     .width = k->im.width, .height = k->im.height};
    image_free(&k->full);
    draw_image(&again, &k->full, 1);
}

/* Microseconds a pixel, in turn: [0] first.h, [1] the full version. */
static inline void first_row_time(first_run *k, double us[2])
{
    void (*const work[2])(first_run *) = {first_row_draw, first_row_full};
    double all[2][first_row_rounds];
    int rounds = k->j->e->chance ? 1 : first_row_rounds;
    for (int i = 0; i < rounds; i++)
        for (int b = 0; b < 2; b++) {
            double start = clock_of(CLOCK_PROCESS_CPUTIME_ID);
            work[b](k);
            all[b][i] = clock_of(CLOCK_PROCESS_CPUTIME_ID) - start;
        }
    for (int b = 0; b < 2; b++)
        us[b] = clock_median(all[b], rounds) / ((double)k->im.width * k->im.height) * 1e6;
}

/* The difference, pixel by pixel; *mean: of the full picture's part that has these pixels. */
static inline estimate first_row_off(const image *small, const image *im, double *mean)
{
    const int part = first_row_part;
    estimate d = {0}, whole = {0};
    for (int y = 0; y < small->height; y++)
        for (int x = 0; x < small->width; x++) {
            double sum = 0;
            for (int k = 0; k < part * part; k++)
                sum += first_row_grey(im, part * x + k % part, part * y + k / part);
            whole = estimate_add(whole, sum / (part * part));
            d = estimate_add(d, first_row_grey(small, x, y) - sum / (part * part));
        }
    *mean = whole.mean;
    return d;
}

static inline void first_row(table *t, const char *name, const studio *s, const studio_view *view,
                             const drawing *j, const image *im)
{
    first_scene f;
    const char *lacks = first_of_studio(s, view, &f);
    table_text(t, "%s", name);
    if (lacks) {
        table_text(t, "it has %s", lacks);
        for (int k = 0; k < 8; k++) table_text(t, "-");
        return;
    }
    int w = j->width / first_row_part, h = j->height / first_row_part;
    first_plan p = first_plan_of(&f);
    first_run k = {j, &f, &p, first_studio_camera(view, w, h), image_new(w, h), {0, 0, NULL}};
    double us[2], mean, rays = (double)j->samples;
    char called[120] = "";
    first_row_time(&k, us);
    for (int e = 0; e < first_effects; e++) {
        rays += (double)first_rays[e] / ((double)w * h);
        if (p.on[e])
            snprintf(called + strlen(called), sizeof called - strlen(called), "%s%s",
                     *called ? ", " : "", first_row_name[e]);
    }
    estimate d = first_row_off(&k.im, im, &mean), own = first_row_off(&k.full, im, &mean);
    table_text(t, "%s", called);
    table_number(t, rays), table_number(t, (double)draw_rays(&j->counts) / draw_pixels(j));
    table_number(t, us[0]), table_number(t, us[1]);
    table_number(t, 100 * d.mean / mean), table_number(t, 100 * estimate_error(d) / mean);
    table_number(t, 100 * sqrt(estimate_variance(d)) / mean);
    table_number(t, 100 * sqrt(estimate_variance(own)) / mean);
    image_free(&k.im), image_free(&k.full);
}

#endif
