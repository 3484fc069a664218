/* command.h: what the command line asks for: a scene, an experiment.
 *
 *   request q = {.path = NULL};       options fill it in; o.own = request_own(&q)
 *   if (request_is_short(&o)) ..      the six scenes, draw_six, are all that is asked for
 *   request_read(&q, &o, &s)          the scene; if none is named the last of the six, and for the
 *                                     tables of the page demo.scene
 *   request_show(&o, &q, &p, &e)      the picture of a stage, and the tables that go with it
 */
#ifndef EFFECTS_COMMAND_H
#define EFFECTS_COMMAND_H

#include "../../../common/numbers/estimate.h"
#include "../../26_path_tracer/files/long_run.h"
#include "../files/effects_read.h"
#include "price.h"
#include "six.h"

typedef struct {
    const char *path, *effects;
    bool told, priced;
    studio_words words;
    long_run run;
} request;

/* ---------------------------------------------------------------------------------------------- */

static inline bool request_own(const request *q)
{
    const studio_words *w = &q->words;
    return q->path || q->effects || q->told || q->priced || w->camera || w->lens || w->light
        || long_run_given(&q->run) || w->sun || w->indirect || w->environment || w->background
        || w->up;
}

/* Without a file and --full: the six scenes, and that is all. */
static inline bool request_is_short(const options *o) { return !o->out && !o->own && !o->full; }

cold_inline void request_read(const request *q, const options *o, studio *s)
{
    const char *demo = six_scenes "demo.scene", *path = q->path;
    char text[six_room];
    failure f;
    if (!o->out && !o->own && access(demo, R_OK) == 0) path = demo;
    six_text(six_count - 1, text);
    if (path ? !studio_read(path, &q->words, s, &f)
             : !studio_read_text(text, "6_lens.scene", &q->words, s, &f)) fail(f);
}

/* All that a sample depends on, but for its number and the size: what is in the files, and what the
 * command line says of the scene. */
static inline void request_settings(request *q, const options *o, const studio *s, unsigned mask)
{
    const studio_words *x = &q->words;
    const char *word[] = {x->camera, x->lens, x->light, x->sun, x->environment, x->background,
                          x->up, x->indirect};
    uint64_t h = state_hash_start;
    for (uint32_t k = 1; k < s->files.n && long_run_given(&q->run); k++) {
        const char *path = name_text(&s->files, k);
        struct stat what;
        if (stat(path, &what) == 0) h = long_run_hash(h, path);
    }
    for (size_t k = 0; k < sizeof word / sizeof *word; k++)
        if (word[k]) h = state_hash(h, word[k], strlen(word[k])), h = state_hash(h, &k, 1);
    snprintf(q->run.settings, state_settings, "scene %016llx\neffects %x\nreal %s\nseed %llu\n",
             (unsigned long long)h, mask, real_is_float ? "float" : "double",
             (unsigned long long)o->seed);
}

/* Everything at every hit was drawn, by who knows no plan: is it what the plan draws, once it is
 * told to do what it declines, too, and leaves branches to the same dice? False: stopped. */
static inline bool request_compare(const drawing *j, const image *all, const plan *p,
                                   effects_stage *e)
{
    image im;
    drawing lean = *j;
    size_t n = (size_t)all->width * (size_t)all->height;
    estimate d = {0};  /* a pixel's channels are alike: one sample each */
    effects_stage_effects(e, p->effects | p->declined | EFFECTS_DICED);
    bool whole = draw_image(&lean, &im, j->pass.threads);
    for (size_t i = 0; i < n; i++) {
        double by = 0;
        for (size_t k = 3 * i; k < 3 * i + 3; k++) by += (double)im.rgb[k] - (double)all->rgb[k];
        d = estimate_add(d, by);
    }
    if (whole) {
        /* Of a picture that was resumed, only the rest was drawn now, which may be nothing. */
        double seconds = j->pass.seconds / j->pass.samples * j->samples;
        if (j->pass.samples > 0)
            printf("everything %.3g s, without the plan; what %s %.3g s: %.0f %% saved\n",
                   seconds, p->declined ? "is called for or declined" : "is called for",
                   lean.pass.seconds, (1 - lean.pass.seconds / seconds) * 100);
        if (memcmp(im.rgb, all->rgb, 3 * n * sizeof *im.rgb) == 0)
            printf("           the same picture byte for byte\n");
        else printf("           the same light by other random numbers? rmse %.3g, means differ by "
                    "%.2g standard errors\n", image_compare(&im, all).rmse,
                    fabs(d.mean) / estimate_error(d));
    }
    effects_stage_effects(e, EFFECTS_EVERYTHING);
    image_free(&im);
    return whole;
}

/* The tables that go with a picture; without a scene of its own, all of the page. The price list is
 * of a picture a quarter as wide and high. */
static inline bool request_tables(const options *o, const request *q, const plan *p,
                                  effects_stage *e, const drawing *j)
{
    bool page = !o->out && !o->own;
    int w = o->width / 4, h = o->height / 4;
    if (page || q->priced)
        return table_of_price(o, p, e, w > 0 ? w : 1, h > 0 ? h : 1,
                              j->samples > 16 ? 16 : j->samples)
            && (!page || draw_two(o));
    table_of_effects(o, p, j);
    printf("# %d samples a pixel, %.3g s", j->samples, j->pass.seconds);
    if (j->samples > 1) printf(", error rmse %.3g by halves", j->error);
    printf("\n");
    return true;
}

/* The picture is saved before all else: Ctrl-C later on loses none of it. */
cold_inline void request_show(const options *o, request *q, const plan *p, effects_stage *e)
{
    long_run *l = &q->run;
    char room[512];
    bool page = !o->out && !o->own, goal = l->error > 0 || l->seconds > 0;
    int samples = o->samples > 0 ? o->samples : goal ? 0 : !e->chance ? 4 : o->quick ? 2
                : page ? 64 : 16;
    drawing j = {.e = e, .seed = o->seed, .width = o->width, .height = o->height,
                 .middle = samples == 1 && !e->chance && !long_run_given(l), .strict = true};
    request_settings(q, o, e->s, e->mask);
    film f = long_run_begin(l, o, o->width, o->height);
    film_passes *pass = draw_begin(&j, o->threads);
    bool whole = long_run_given(l) ? passes_until(pass, &f, long_run_goal(l, (uint32_t)samples))
                                   : passes_range(pass, &f, 0, (uint32_t)samples);
    options to = *o;
    to.own = true;  /* also the demo goes to build/: `make images` has one with more samples */
    long_run_end(l, &to, &f, page ? "27_effects_demo.png"
                                  : picture_name("27_effects.png", q->path, room), whole);
    j.samples = (int)film_samples(&f), j.error = film_error(&f);
    if (e->mask & EFFECTS_SPEND) {
        image im = film_picture(&f);
        whole = request_compare(&j, &im, p, e);
        image_free(&im);
    }
    film_free(&f);
    if (!whole || !request_tables(o, q, p, e, &j))
        die(parallel_stopped(), "stopped; the picture was whole before");
}

#endif
