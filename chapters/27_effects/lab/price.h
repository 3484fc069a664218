/* price.h: what each effect takes and gives: rays, time, and the error of leaving it out.
 *
 *   table_of_effects(&o, &p, &j)             what a picture took: rays by effect
 *   table_of_price(&o, &p, &e, window, n)    each called effect left out in turn, each declined one
 *                                            added; n samples a pixel; 27_effects_price_time.svg
 *
 * Prices are medians of rounds in which all variants take their turn. Random numbers have names
 * (dice.h), so that what an effect does not touch is the same in both pictures, noise included: the
 * error is what it adds, not what chance does.
 */
#ifndef EFFECTS_PRICE_H
#define EFFECTS_PRICE_H

#include "../../../common/lab/report.h"
#include "bars.h"
#include "../plan.h"
#include "draw.h"

enum { price_most_rounds = 5 };

/* The pixels from (x, y) on of a picture of across x down. */
typedef struct { int x, y, width, height, across, down; } draw_window;

/* ---------------------------------------------------------------------------------------------- */

static inline void table_of_effects(const options *o, const plan *p, const drawing *j)
{
    const effects_stage *e = j->e;
    table t = table_new(e->mask & EFFECTS_SPEND
                            ? "What everything took, called for or not: rays"
                            : "What the picture took, by effect: rays",
                        "effect|verdict|simulated|rays|rays a sample");
    double samples = (double)j->pixels * j->pass.samples;
    for (int k = -1; k < effect_kinds; k++) {
        int at = k < 0 ? RAY_OF_EYE : k;
        table_text(&t, "%s", k < 0 ? "rays of the eye" : effect_names[k].name);
        table_text(&t, "%s", k < 0 ? "-" : verdict_names[p->verdict[k]]);
        table_text(&t, "%s", k < 0 || e->mask >> k & 1 ? "yes" : "no");
        table_count(&t, j->counts.rays[at]);
        table_number(&t, samples > 0 ? (double)j->counts.rays[at] / samples : 0);
    }
    output_table(o, &t);
}

typedef struct {
    drawing j;
    image im;
    int x, y;
    double seconds[price_most_rounds];
    unsigned mask;
} price_run;

static inline bool price_draw(price_run *k, effects_stage *e, int rounds, int round, int threads)
{
    /* General: else some sets would have a copy made for them, others not. */
    effects_stage_effects(e, k->mask | EFFECTS_GENERAL);
    if (round >= rounds) return true;
    bool whole = draw_region(&k->j, &k->im, k->x, k->y, threads);
    k->seconds[round] = k->j.pass.seconds;
    return whole;
}

/* The mean of all channels of all pixels. */
static inline double price_mean(const image *im)
{
    size_t n = 3 * (size_t)im->width * (size_t)im->height;
    double sum = 0;
    for (size_t i = 0; i < n; i++) sum += (double)im->rgb[i];
    return sum / (double)n;
}

/* `effect` is in one of the two pictures: left out of what the plan draws, or added to it. */
static inline void price_row(table *t, price_bars *bars, const plan *p, const price_run *k,
                             int effect, const price_run *all, int rounds)
{
    double now[price_most_rounds], full[price_most_rounds];
    memcpy(now, k->seconds, sizeof now), memcpy(full, all->seconds, sizeof full);
    double pixels = (double)k->im.width * k->im.height, a = clock_median(full, rounds);
    double b = clock_median(now, rounds), error = image_compare(&k->im, &all->im).rmse;
    bool declined = effect >= 0 && p->declined >> effect & 1;
    double its = declined ? price_mean(&k->im) - price_mean(&all->im)
                          : price_mean(&all->im) - price_mean(&k->im);
    const effects_counts *c = declined ? &k->j.counts : &all->j.counts;
    table_text(t, "%s", effect < 0 ? "the plan" : effect_names[effect].name);
    table_text(t, "%s", effect < 0 ? "-" : verdict_names[p->verdict[effect]]);
    table_count(t, c->rays[effect < 0 ? RAY_OF_EYE : effect]);
    if (effect < 0) table_text(t, "-"), table_text(t, "-"), table_text(t, "-");
    else {
        double brings = its / price_mean(declined ? &k->im : &all->im) * 100;
        double time = (declined ? b - a : a - b) / a * 100;
        table_number(t, brings), table_number(t, error), table_number(t, time);
        price_bars_add(bars, effect_names[effect].name, declined, brings, time);
    }
    table_number(t, b / pixels * 1e6);
}

static inline bool table_of_price(const options *o, const plan *p, effects_stage *e, draw_window w,
                                  int samples)
{
    int rounds = o->full || (o->own && !o->quick) ? 3 : 1, n = 1;
    unsigned before = e->mask, called = p->effects & before;  /* --effects may leave some out */
    price_run run[effect_kinds + 1] = {{.mask = called}};
    int effect[effect_kinds + 1] = {-1};
    bool whole = true;
    for (int k = 0; k < effect_kinds; k++)
        if ((called | p->declined) >> k & 1) effect[n] = k, run[n++].mask = called ^ 1u << k;
    for (int i = 0; i < n; i++) {
        run[i].im = image_new(w.width, w.height);
        run[i].x = w.x, run[i].y = w.y;
        run[i].j = (drawing){.e = e, .samples = samples, .seed = o->seed, .width = w.across,
                             .height = w.down};
    }
    for (int round = 0; round < rounds && whole; round++)
        for (int i = 0; i < n && whole; i++)
            whole = price_draw(&run[i], e, rounds, round, o->threads);
    table t = table_new("The price of each effect: the light it brings, the time it takes",
                        "effect|verdict|its rays|its light [%]|without it: rmse|its time [%]|"
                        "time [us/pixel]");
    price_bars bars = {.n = 0};
    for (int i = 0; i < n && whole; i++)
        price_row(&t, &bars, p, &run[i], effect[i], &run[0], rounds);
    options beside = *o;  /* the drawing goes to build/, wherever the picture goes */
    beside.out = NULL, beside.own = false;
    if (whole) output_table(o, &t), price_bars_draw(&beside, &bars, "27_effects_price_time.svg");
    else table_free(&t);
    for (int i = 0; i < n; i++) image_free(&run[i].im);
    effects_stage_effects(e, before);
    return whole;
}

#endif
