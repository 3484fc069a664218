/* pictures.h: the pictures of this chapter.
 *
 *   draw_terms(o)   the Cornell box, upper row E, K E, K^2 E, K^3 E, the rest up to K^10 E; lower
 *                   row the running sums, the last is the whole. Of the upper row the last three
 *                   are shown 2, 4, 4 times as bright.
 */
#ifndef BOUNCES_PICTURES_H
#define BOUNCES_PICTURES_H

#include "../../../common/lab/label.h"
#include "../../../common/output.h"
#include "../../../common/parallel.h"
#include "../../24_direct_light/scenes/lit_cornell.h"
#include "../terms.h"

/* ---------------------------------------------------------------------------------------------- */

enum { term_columns = 5, term_most = 10 };
static const real term_gain[term_columns] = {1, 1, 2, 4, 4};
static const char *const term_tag[2 * term_columns] = {
    "E", "K E", "K^2 E, x 2", "K^3 E, x 4", "the rest, x 4",
    "E", "E + K E", ".. + K^2 E", ".. + K^3 E", "all of it"};
typedef struct {
    naive_path path;
    camera view;
    uint32_t samples;
    uint64_t seed;
    image sheet;
    int w, h;  /* of a panel */
} term_sheet;

static inline void term_pixel(int x, int y, void *context)
{
    term_sheet *t = context;
    vec3 mean[term_columns] = {{0, 0, 0}}, term[term_most + 1], sum = {0, 0, 0};
    bounce_counts c = {.direct = {0, 0, 0}};
    for (uint32_t i = 0; i < t->samples; i++) {
        if (parallel_is_stopped()) return;
        uint64_t pixel = (uint64_t)y * (uint64_t)t->w + (uint64_t)x;
        sampler s = sampler_start(SEQUENCE_SOBOL, t->seed, pixel, i, t->samples);
        point2 u = sampler_pair(&s);
        ray eye = camera_ray(t->view, (real)x + u.u, (real)y + u.v, t->w, t->h);
        bounce_terms_lit(&t->path, eye, &s, term, &c);
        for (int k = 0; k <= t->path.depth; k++) {
            int column = k < term_columns ? k : term_columns - 1;
            mean[column] = vmadd(mean[column], term[k], 1 / (real)t->samples);
        }
    }
    for (int k = 0; k < term_columns; k++) {
        sum = vadd(sum, mean[k]);
        image_set(&t->sheet, k * t->w + x, y, vscale(mean[k], term_gain[k]));
        image_set(&t->sheet, k * t->w + x, t->h + y, sum);
    }
}

cold_inline void draw_terms(const options *o)
{
    lit_scene s;
    lit_cornell(&s);
    int w = o->width / term_columns, h = o->height / 2;
    term_sheet t = {{&s, DIRECTIONS_BRDF, term_most, false}, cornell_camera(1),
                    (uint32_t)o->samples, o->seed, image_new(o->width, o->height), w, h};
    if (w && h) t.view = cornell_camera((real)w / (real)h);
    bool whole = parallel_pixels(w, h, o->threads, "terms", term_pixel, &t);
    for (int k = 0; k < 2 * term_columns && w >= 150; k++)
        label_tag(&t.sheet, k % term_columns * w + 6, k / term_columns * h + 6, 11, term_tag[k]);
    output_picture(o, &t.sheet, "25_bounces.png", true, whole);
    image_free(&t.sheet);
    lit_free(&s);
}

#endif
