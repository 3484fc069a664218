/* command.h: what the command line asks for: a scene, a part of its picture, an experiment.
 *
 *   request q = {.path = NULL};       options fill it in; o.own = request_own(&q)
 *   if (request_is_short(&o)) ..      the six scenes, draw_six, are all that is asked for
 *   request_show(&o, &q, &p, &e)      the picture of a stage, and the tables that go with it
 */
#ifndef EFFECTS_COMMAND_H
#define EFFECTS_COMMAND_H

#include "tax.h"
#include "../../26_path_tracer/long_run.h"
#include "../files/studio_read.h"
#include "../plan.h"
#include "price.h"
#include "six.h"

typedef struct {
    const char *path, *effects, *region;
    bool told, priced;
    studio_words words;
    long_run run;
} request;

/* ---------------------------------------------------------------------------------------------- */

static inline bool request_own(const request *q)
{
    const studio_words *w = &q->words;
    return q->path || q->effects || q->region || q->told || q->priced || w->camera || w->lens
        || long_run_given(&q->run)
        || w->light || w->sun || w->indirect || w->environment || w->background || w->up;
}

static inline draw_window request_window(const options *o, const char *said)
{
    draw_window w = {0, 0, o->width, o->height, o->width, o->height};
    int end = 0;
    if (!said) return w;
    /* NOLINTNEXTLINE(cert-err34-c): five digits fit, a sixth is left over */
    if (sscanf(said, "%5dx%5d+%5d+%5d%n", &w.width, &w.height, &w.x, &w.y, &end) == 4
        && !said[end] && w.width > 0 && w.height > 0 && w.x >= 0 && w.y >= 0
        && w.width <= w.across - w.x && w.height <= w.down - w.y) return w;
    die(2, "--region %.60s: WxH+X+Y, within the %dx%d pixels of --size", said, o->width, o->height);
}

/* All that a sample depends on, but for its number: what is in the files, what the command line
 * says of the scene, and which pixels these are. A pipe can't be read again. */
static inline void request_settings(request *q, const options *o, const studio *s, unsigned mask,
                                    draw_window w)
{
    const studio_words *x = &q->words;
    const char *word[] = {x->camera, x->lens, x->light, x->sun, x->environment, x->background,
                          x->up, x->indirect};
    uint64_t h = state_hash_start;
    for (uint32_t k = 1; k < s->files.n && long_run_given(&q->run); k++) {
        const char *path = name_text(&s->files, k);
        struct stat what;
        size_t n;
        failure f;
        if (stat(path, &what) != 0) continue;
        if (!S_ISREG(what.st_mode))
            die(2, "%.200s: --save and the like want a file, no pipe", path);
        char *text = file_read(path, &n, &f);
        if (!text) fail(f);
        h = state_hash(h, text, n), free(text);
    }
    for (size_t k = 0; k < sizeof word / sizeof *word; k++)
        if (word[k]) h = state_hash(h, word[k], strlen(word[k])), h = state_hash(h, &k, 1);
    snprintf(q->run.settings, state_settings, "scene %016llx\neffects %x\nreal %s\nseed %llu\n"
             "pixels from %d %d of %dx%d\n", (unsigned long long)h, mask,
             real_is_float ? "float" : "double", (unsigned long long)o->seed, w.x, w.y, w.across,
             w.down);
}

/* Everything at every hit was drawn, by who knows no plan: is it what the plan draws, once it is
 * told to do what it declines, too, and leaves branches to the same dice? False: stopped. */
static inline bool request_compare(const drawing *j, const image *all, const plan *p,
                                   effects_stage *e)
{
    image im = image_new(all->width, all->height);
    drawing lean = *j;
    size_t n = 3 * (size_t)im.width * (size_t)im.height;
    effects_stage_effects(e, p->effects | p->declined | EFFECTS_DICED);
    bool whole = draw_region(&lean, &im, j->x0, j->y0, j->pass.threads);
    if (whole) {
        bool same = memcmp(im.rgb, all->rgb, n * sizeof *im.rgb) == 0;
        printf("everything %.3g s, without the plan; what %s %.3g s: %.0f %% saved\n",
               j->pass.seconds, p->declined ? "is called for or declined" : "is called for",
               lean.pass.seconds, (1 - lean.pass.seconds / j->pass.seconds) * 100);
        if (same) printf("           the same picture byte for byte\n");
        else printf("           the same light by other random numbers? rmse %.3g, means differ by "
                    "%.2g standard errors\n", image_compare(&im, all).rmse, draw_z(&im, all));
    }
    effects_stage_effects(e, EFFECTS_EVERYTHING);
    image_free(&im);
    return whole;
}

/* What the picture took, by effect. */
static inline void request_count(const options *o, const plan *p, const drawing *j)
{
    table_of_effects(o, p, j);
    printf("# %d samples a pixel, %.3g s", j->samples, j->pass.seconds);
    if (j->samples > 1) printf(", error rmse %.3g by halves", j->error);
    printf("\n");
}

/* Of the whole picture the price list takes a quarter in width and height. */
static inline draw_window request_small(const request *q, draw_window w)
{
    if (q->region) return w;
    w.width = w.across = w.across / 4 > 0 ? w.across / 4 : 1;
    w.height = w.down = w.down / 4 > 0 ? w.down / 4 : 1;
    return w;
}

/* The tables that go with a picture; without a scene of its own, all of the page. */
static inline bool request_tables(const options *o, const request *q, const plan *p,
                                  effects_stage *e, draw_window w, const drawing *j)
{
    int samples = j->samples;
    bool demo = !o->out && !o->own;
    if (!demo && !q->priced) return request_count(o, p, j), true;
    return table_of_price(o, p, e, request_small(q, w), samples > 16 ? 16 : samples)
        && (!demo || (draw_two(o) && table_of_tax(o)));
}

/* The picture is saved before all else: Ctrl-C later on loses none of it. */
static inline void request_show(const options *o, request *q, const plan *p, effects_stage *e)
{
    draw_window w = request_window(o, q->region);
    long_run *l = &q->run;
    char room[512];
    bool demo = !o->out && !o->own, goal = l->error > 0 || l->seconds > 0;
    int samples = o->samples > 0 ? o->samples : goal ? 0 : !e->chance ? 4 : o->quick ? 2
                : demo ? 64 : 16;
    drawing j = {.e = e, .seed = o->seed, .width = o->width, .height = o->height,
                 .middle = samples == 1 && !e->chance && !long_run_given(l)};
    request_settings(q, o, e->s, e->mask, w);
    film f = long_run_begin(l, o, w.width, w.height);
    film_passes *pass = draw_begin(&j, w.x, w.y, o->threads);
    bool whole = long_run_given(l) ? passes_until(pass, &f, long_run_goal(l, (uint32_t)samples))
                                   : passes_range(pass, &f, 0, (uint32_t)samples);
    options to = *o;
    to.own = true;  /* also the demo goes to build/: `make images` has one with more samples */
    long_run_end(l, &to, &f, demo ? "27_effects_demo.png"
                                  : picture_name("27_effects.png", q->path, room), whole);
    j.samples = (int)film_samples(&f), j.error = film_error(&f);
    j.pixels = (size_t)w.width * (size_t)w.height;
    if (j.counts.lost)
        fprintf(stderr, "%s: warning: more than %d bodies lie around one another: %zu times one "
                "was taken for air\n", program_name, media_most, j.counts.lost);
    if (e->mask & EFFECTS_SPEND) {
        image im = film_picture(&f);
        whole = request_compare(&j, &im, p, e);
        image_free(&im);
    }
    film_free(&f);
    if (!whole || !request_tables(o, q, p, e, w, &j))
        die(parallel_stopped(), "stopped; the picture was whole before");
}

/* Without a file and --full: the six scenes, and that is all. */
static inline bool request_is_short(const options *o) { return !o->out && !o->own && !o->full; }

#endif
