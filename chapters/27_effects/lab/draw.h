/* draw.h: the picture of a stage on the film of 20, and what it took.
 *
 *   drawing j = {.e = &e, .samples = 16, .seed = 1, .width = w, .height = h};
 *   bool whole = draw_image(&j, &im, threads)          a new picture; false: stopped by Ctrl-C
 *   j.counts, j.pass.seconds          rays by effect; time
 *   j.error                           RMSE by halves (20.22); infinity with one sample
 *   passes_until(draw_begin(&j, threads), &f, goal)    the same on a film f, by passes
 *   draw_rays(&j.counts)              all rays
 *
 *   effects_ready q;                  q.s has been read; then all that j.e asks for, by its plan:
 *   if (!effects_get_ready(&q, aspect, &f)) fail(f);                      effects_ready_free(&q)
 *
 * With j.strict more bodies around one another than media.h (19) holds end the program: exit 2.
 *
 * Samples lie in the pixel by Sobol'; with j.middle in its middle: for one alone, without chance.
 */
#ifndef EFFECTS_DRAW_H
#define EFFECTS_DRAW_H

#include "../../20_monte_carlo/passes.h"
#include "../plan.h"
#include "../special.h"

typedef struct {
    const effects_stage *e;
    int samples;              /* of a pixel: of draw_image */
    uint64_t seed;
    int width, height;
    bool middle, strict;
    media_set around;         /* bodies that the eye is in */
    film_passes pass;
    effects_counts counts;
    double error;
} drawing;
typedef struct { studio s; studio_view view; plan p; effects_stage e; } effects_ready;

/* ---------------------------------------------------------------------------------------------- */

/* q stays where it is: the stage knows its place. */
cold_inline bool effects_get_ready(effects_ready *q, real aspect, failure *f)
{
    camera c;
    if (!studio_camera(&q->s, aspect, &q->view, &c, f)) return false;
    if (!effects_stage_build(&q->s, &q->e, f)) return false;
    q->p = plan_of(&q->s);
    effects_stage_view(&q->e, &q->view, c);
    effects_stage_effects(&q->e, q->p.effects);
    return true;
}

static inline void effects_ready_free(effects_ready *q)
{
    effects_stage_free(&q->e), plan_free(&q->p), studio_free(&q->s);
}

/* The ray of a sample of a pixel. */
fast_inline ray draw_ray(const drawing *j, int x, int y, const dice *d)
{
    const effects_stage *e = j->e;
    point2 at = {0.5, 0.5}, on = {0, 0};
    bool lens = (e->mask & EFFECT_DEPTH_OF_FIELD) != 0;
    if (!j->middle) at = sampler_sobol(&d->pairs, DICE_PIXEL);
    if (lens) on = sampler_sobol(&d->pairs, DICE_LENS);
    thin_lens l = {lens ? e->lens.radius : 0, e->lens.focus};
    ray r = lens_ray(e->eye, l, (real)x + at.u, (real)y + at.v, j->width, j->height, on);
    r.tmin = e->hither;
    return r;
}

/* The bodies that the ray begins in, at the lens or `hither`: the eye's, if no glass is near. */
static inline media_set draw_in(const drawing *j, ray r, effects_counts *c)
{
    const effects_stage *e = j->e;
    vec3 begin = ray_at(r, r.tmin), eye = e->eye.e;
    const aabb between = {vmin(eye, begin), vmax(eye, begin)};
    if (vzero(vsub(begin, eye)) || aabb_is_empty(aabb_overlap(between, e->glass)))
        return j->around;
    return bodies_from(e, eye, j->around, begin, c);
}

/* The light would not be right. */
static inline void draw_refuse(const drawing *j)
{
    if (j->strict && j->counts.lost)
        die(2, "more than %d bodies of glass lie around one another, or more than %d at one place "
            "(single sheets are for illum 4 or 9)", media_most, media_most_faces);
}

/* Sample k of a row of n pixels from (x, y) on. */
static inline void draw_sample(const drawing *j, effects_function *f, const dice_pixel *of, int x,
                               int y, int n, uint32_t k, film_pixel *sum, effects_counts *c)
{
    effects_path path[film_side];
    for (int i = 0; i < n; i++) {
        effects_path *p = &path[i];
        p->d = dice_sample(&of[i], k);
        p->r = draw_ray(j, x + i, y, &p->d);
        p->in = draw_in(j, p->r, c);
        if (j->e->mask & EFFECT_DEPTH_OF_FIELD) c->rays[RAY_OF_LENS]++;
    }
    for (int i = 0; i < n; i++) effects_see(j->e, &path[i]);
    for (int i = 0; i < n; i++) film_pixel_add(&sum[i], k, f(j->e, &path[i], c));
}

/* The samples of a pass, of a row of a tile; how many pixels: none if it was stopped. */
static inline int draw_row(const drawing *j, effects_function *f, film_window w, int y,
                           effects_counts *c)
{
    film_pixel sum[film_side];
    dice_pixel of[film_side];
    const int n = w.x1 - w.x0;
    size_t at = (size_t)y * (size_t)j->width + (size_t)w.x0;
    for (int i = 0; i < n; i++) dice_pixel_of(j->seed, at + (size_t)i, !j->middle, &of[i]);
    memset(sum, 0, sizeof sum);
    for (uint32_t k = j->pass.now.begin; k < j->pass.now.end; k++) {
        if (parallel_is_stopped()) return 0;
        draw_sample(j, f, of, w.x0, y, n, k, sum, c);
    }
    for (int i = 0; i < n; i++) film_gather(j->pass.to, at + (size_t)i, &sum[i]);
    return n;
}

static inline void draw_tile(size_t tile, void *context)
{
    drawing *j = context;
    effects_function *f = effects_made_for(j->e->mask);
    effects_counts c = {.lost = 0};
    film *to = j->pass.to;
    film_window w = film_window_of(to, tile);
    for (int y = w.y0; y < w.y1; y++)
        to->done[tile] = (uint16_t)(to->done[tile] + draw_row(j, f, w, y, &c));
    pthread_mutex_lock(&j->pass.lock);
    effects_counts_add(&j->counts, &c), draw_refuse(j);
    pthread_mutex_unlock(&j->pass.lock);
}

static inline film_passes *draw_begin(drawing *j, int threads)
{
    j->counts = (effects_counts){.lost = 0};
    j->around = bodies_around(j->e, j->e->eye.e, &j->counts), draw_refuse(j);
    j->pass = (film_passes){.tile = draw_tile, .job = j, .threads = threads};
    return &j->pass;
}

static inline bool draw_image(drawing *j, image *im, int threads)
{
    film f = film_new(j->width, j->height);
    j->middle = j->samples == 1 && !j->e->chance;
    bool whole = passes_range(draw_begin(j, threads), &f, 0, (uint32_t)j->samples);
    *im = film_picture(&f), j->error = film_error(&f);
    film_free(&f);
    return whole;
}

static inline double draw_pixels(const drawing *j) { return (double)j->width * j->height; }

/* All rays that were traced. */
static inline size_t draw_rays(const effects_counts *c)
{
    size_t n = c->rays[RAY_OF_EYE];
    for (int k = 0; k < effect_kinds; k++)
        n += k == RAY_ABSORBED || k == RAY_OF_LENS ? 0 : c->rays[k];
    return n;
}

#endif
