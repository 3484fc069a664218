/* command.h: what the command line asks for: a scene, a part of its picture, an experiment.
 *
 *   request q = {.path = NULL};       options fill it in; o.own = request_own(&q)
 *   request_show(&o, &q, &e)          the picture of a stage, and the tables that go with it
 */
#ifndef EFFECTS_COMMAND_H
#define EFFECTS_COMMAND_H

#include "../files/studio_read.h"
#include "classic.h"
#include "price.h"

typedef struct {
    const char *path, *effects, *region;
    bool told, priced;
    studio_words words;
} request;

/* ---------------------------------------------------------------------------------------------- */

static inline bool request_own(const request *q)
{
    const studio_words *w = &q->words;
    return q->path || q->effects || q->region || q->told || q->priced || w->camera || w->lens
        || w->light || w->sun || w->environment || w->background || w->up;
}

static inline draw_window request_window(const options *o, const char *said)
{
    draw_window w = {0, 0, o->width, o->height, o->width, o->height};
    int end = 0;
    if (!said) return w;
    if (sscanf(said, "%5dx%5d+%5d+%5d%n", &w.width, &w.height, &w.x, &w.y, &end) == 4
        && !said[end] && w.width > 0 && w.height > 0 && w.x >= 0 && w.y >= 0
        && w.width <= w.across - w.x && w.height <= w.down - w.y) return w;
    die(2, "--region %.60s: WxH+X+Y, within the %dx%d pixels of --size", said, o->width, o->height);
}

/* All at every hit was drawn: what the plan draws, and whether that is the same picture. False:
 * stopped. */
static inline bool request_compare(drawing *j, effects_stage *e, int threads)
{
    image im = image_new(j->im->width, j->im->height);
    drawing plain = *j;
    size_t n = 3 * (size_t)im.width * (size_t)im.height;
    effects_stage_effects(e, e->p->effects, false);
    bool whole = draw_region(&plain, &im, j->x0, j->y0, threads);
    if (whole) {
        bool same = memcmp(im.rgb, j->im->rgb, n * sizeof *im.rgb) == 0;
        printf("plan       %s; everything at every hit took %.3g s, the plan %.3g s: "
               "%.0f %% saved\n",
               same ? "the same picture byte for byte" : "ANOTHER PICTURE", j->seconds,
               plain.seconds, (1 - plain.seconds / j->seconds) * 100);
    }
    effects_stage_effects(e, EFFECTS_ALL, true);
    image_free(&im);
    return whole;
}

/* What the picture took, by effect. */
static inline bool request_count(const options *o, const drawing *j)
{
    effects_counts timed;
    image none = image_new(j->im->width, j->im->height);  /* draw_timed fills nothing in */
    double error = draw_error(j);
    drawing again = *j;
    again.im = &none;
    bool whole = draw_timed(&again, o->threads, &timed);
    if (whole) {
        table_of_effects(o, j, &timed);
        printf("# %d samples a pixel, %.3g s", j->samples, j->seconds);
        if (error > 0 && j->samples > 1) printf(", error rmse %.3g by halves", error);
        printf("\n");
    }
    image_free(&none);
    return whole;
}

/* The demo as --effects all --samples 8 --size 320x240 has it. */
static inline bool request_all(const options *o, effects_stage *e)
{
    options with = *o;
    image im = image_new(320, 240);
    drawing j = {.e = e, .samples = 8, .seed = o->seed, .width = 320, .height = 240};
    unsigned before = e->mask;
    with.csv = NULL;
    effects_stage_effects(e, EFFECTS_ALL, true);
    bool whole = draw_region(&j, &im, 0, 0, o->threads) && request_compare(&j, e, o->threads)
              && request_count(&with, &j);
    effects_stage_effects(e, before & EFFECTS_ALL, before & EFFECTS_SPEND);
    image_free(&im);
    return whole;
}

/* The picture is saved before all else: Ctrl-C later on loses none of it. Of the whole picture the
 * price list takes a quarter in width and height. */
static inline void request_show(const options *o, const request *q, effects_stage *e)
{
    draw_window w = request_window(o, q->region), small = w;
    char room[512];
    image im = image_new(w.width, w.height);
    bool demo = !o->out && !o->own;
    int samples = o->samples > 0 ? o->samples : !e->chance ? 4 : o->quick ? 2 : 16;
    drawing j = {.e = e, .samples = samples, .seed = o->seed, .width = o->width,
                 .height = o->height};
    bool whole = draw_region(&j, &im, w.x, w.y, o->threads);
    output_picture(o, &im, picture_name("27_effects.png", q->path, room), true, whole);
    if (e->mask & EFFECTS_SPEND) whole = request_compare(&j, e, o->threads);
    if (!q->region) {
        small.width = small.across = w.across / 4 > 0 ? w.across / 4 : 1;
        small.height = small.down = w.down / 4 > 0 ? w.down / 4 : 1;
    }
    if (whole && ((demo && o->full) || q->priced))
        whole = table_of_price(o, e, small, samples > 16 ? 16 : samples);
    else if (whole) whole = request_count(o, &j);
    if (whole && demo && o->full)
        whole = draw_strip(o, e, o->width * 2 / 5 + 1, o->height * 2 / 5 + 1, 2 * samples)
             && table_of_tax(o) && request_all(o, e);
    image_free(&im);
    if (!whole) die(130, "stopped; the picture was whole before");
}

#endif
