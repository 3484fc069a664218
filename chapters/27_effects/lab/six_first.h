/* six_first.h: the six scenes of six.h as first.h has them, and the short book's plan of them.
 *
 *   first_scene f;
 *   if (six_as_first(4, &f)) ..           5_wall; false: 6_lens, for first.h has no lens
 *   table t = first_table(title);
 *   first_row(&t, 4, "5_wall", &view, &j, &im)     j: the drawing that gave the picture im
 *
 * A sun is a point light at the distance D. first.h has one eps, of rays that go on a distance, of
 * shadow rays a part of the way. It is no smaller than rounding allows; then the light falls off by
 * size / D, and shadow rays begin eps D away. D = size / sqrt eps makes both alike: in double 4e-7
 * of the whole, in float a hundredth.
 *
 * first.h draws a fifth as wide and high, with as many samples a pixel as im has: a grid of them,
 * each somewhere in its cell. (In the middle of each cell, all pixels of a row would be wrong alike
 * where the horizon passes through them.) A pixel of its picture is 5 x 5 of im, which has 25 times
 * its samples. Off by: the mean of all differences of pixels, over the mean of im; +-: its standard
 * error. Noise: what a pixel differs by, RMS, about that mean; of the full version's own picture of
 * that size, too. The two times are the processor's, of such pictures, by one thread. Its rays: of
 * the eye, and what first_rays counts: the points of the lamp that it draws, also those behind a
 * surface, to which it sends no ray.
 */
#ifndef EFFECTS_SIX_FIRST_H
#define EFFECTS_SIX_FIRST_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/table.h"
#include "../../../common/numbers/estimate.h"
#include "../first.h"
#include "draw.h"

enum { first_row_part = 5, first_row_depth = 40 };

static const char *const first_row_name[first_effects] = {
    "shadows", "mirrors", "glass", "lamp", "bounces"};

typedef struct {
    bool full;             /* by the full version */
    const drawing *j;
    const first_scene *f;
    const first_plan *p;
    first_camera c;
    image im;
} first_run;

/* ---------------------------------------------------------------------------------------------- */

/* The lamp, which faces down, is thing 0. */
static inline bool six_as_first(int k, first_scene *f)
{
    const first_material white = {.kd = vec(0.73, 0.73, 0.73)}, red = {.kd = vec(0.65, 0.05, 0.05)};
    const first_material yellow = {.kd = vec(0.7, 0.55, 0.1)}, panel = {.ke = vec(1, 1, 1)};
    const first_material chrome = {.mirror = vec(0.55, 0.56, 0.55)}, glass = {.ior = 1.5};
    const real size = 57, eps = 16 * real_epsilon * size, far = size / sqrt(eps);
    *f = (first_scene){.above = vec(0.5, 0.65, 0.85), .eps = eps};
    f->below = f->above;
    f->light[f->lights++] = (first_light){vscale(vunit(vec(3, 2.2, 4)), far),
                                          vscale((vec3){3, 3, 3}, far * far)};
    if (k >= 3) first_add_flat(f, vec(-2, 6, 4), vec(0, 0, -5), vec(6, 0, 0), panel);
    first_add_flat(f, vec(-20, 0, 20), vec(40, 0, 0), vec(0, 0, -40), white);
    first_add_flat(f, vec(-2.6, 0, -4), vec(0, 0, 7), vec(0, 3.2, 0), red);
    first_add_ball(f, vec(-0.2, 0.9, -1.6), (real)0.9, yellow);
    if (k >= 1) first_add_ball(f, vec(-1.4, 0.9, 0.4), (real)0.9, chrome);
    if (k >= 2) first_add_ball(f, vec(1.1, 0.8, 0.9), (real)0.8, glass);
    return k < 5;
}

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

/* The counts of first_rays are those of the last picture. */
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

static inline double first_row_clock(void) { return clock_of(CLOCK_PROCESS_CPUTIME_ID); }

static inline double first_row_run(void *context)
{
    first_run *k = context;
    drawing again = {.e = k->j->e, .samples = k->j->samples, .seed = k->j->seed,
                     .width = k->im.width, .height = k->im.height};
    if (k->full) image_free(&k->im), draw_image(&again, &k->im, 1);
    else first_row_draw(k);
    return (double)k->im.rgb[0];
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

static inline void first_row(table *t, int six, const char *name, const studio_view *view,
                             const drawing *j, const image *im)
{
    first_scene f;
    table_text(t, "%s", name);
    if (!six_as_first(six, &f)) {
        table_text(t, "it has no lens");
        for (int k = 0; k < 8; k++) table_text(t, "-");
        return;
    }
    int w = j->width / first_row_part, h = j->height / first_row_part;
    double pixels = (double)w * h, us = 1e6 / pixels, mean, rays = (double)j->samples;
    char called[120] = "";
    first_plan p = first_plan_of(&f);
    first_camera c = first_camera_at(view->from, view->at, view->up, view->angle, w, h);
    first_run run[2] = {{false, j, &f, &p, c, image_new(w, h)},
                        {true, j, &f, &p, c, image_new(w, h)}};
    bench_candidate b[2] = {{.run = first_row_run, .context = &run[0]},
                            {.run = first_row_run, .context = &run[1]}};
    bench_time_by(first_row_clock, b, 2, j->e->chance ? 1 : 5);
    for (int e = 0; e < first_effects; e++) {
        rays += (double)first_rays[e] / pixels;
        if (p.on[e])
            snprintf(called + strlen(called), sizeof called - strlen(called), "%s%s",
                     *called ? ", " : "", first_row_name[e]);
    }
    estimate d = first_row_off(&run[0].im, im, &mean), own = first_row_off(&run[1].im, im, &mean);
    const double cell[] = {rays, (double)draw_rays(&j->counts) / draw_pixels(j),
                           b[0].seconds * us, b[1].seconds * us,
                           100 * d.mean / mean, 100 * estimate_error(d) / mean,
                           100 * sqrt(estimate_variance(d)) / mean,
                           100 * sqrt(estimate_variance(own)) / mean};
    table_text(t, "%s", called);
    for (int k = 0; k < 8; k++) table_number(t, cell[k]);
    for (int k = 0; k < 2; k++) image_free(&run[k].im);
}

#endif
