/* price.h: what each effect takes and gives: rays, time, and the error of leaving it out.
 *
 *   table_of_effects(&o, &p, &j)             what a picture took: rays by effect
 *   table_of_price(&o, &p, &e, w, h, n)      each called effect left out in turn, each declined
 *                                            one added; w x h pixels of n samples; and as bars,
 *                                            light above, time below: 27_effects_price_time.svg
 *
 * Prices are medians of rounds in which all variants take their turn. Random numbers have names
 * (dice.h), so that what an effect does not touch is the same in both pictures, noise included: the
 * error is what it adds, not what chance does.
 */
#ifndef EFFECTS_PRICE_H
#define EFFECTS_PRICE_H

#include "../../../common/lab/figure.h"
#include "../../../common/lab/report.h"
#include "../plan.h"
#include "draw.h"

enum { price_most_rounds = 5 };
typedef struct {
    int effect;               /* left out of what the plan draws, or added to it; -1: neither */
    unsigned mask;
    drawing j;
    image im;
    double seconds[price_most_rounds];
    bool declined;
    double light, time;       /* per cent of the picture's */
} price_run;

/* ---------------------------------------------------------------------------------------------- */

static inline void table_of_effects(const options *o, const plan *p, const drawing *j)
{
    const effects_stage *e = j->e;
    table t = table_new(e->mask & EFFECTS_SPEND
                            ? "What everything took, called for or not: rays"
                            : "What the picture took, by effect: rays",
                        "effect|verdict|simulated|rays|rays a sample");
    double samples = draw_pixels(j) * j->pass.samples;
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

/* The mean of all channels of all pixels. */
static inline double price_mean(const image *im)
{
    size_t n = 3 * (size_t)im->width * (size_t)im->height;
    double sum = 0;
    for (size_t i = 0; i < n; i++) sum += (double)im->rgb[i];
    return sum / (double)n;
}

/* One of the two pictures is with the effect, the other without it. */
static inline void price_row(table *t, price_run *k, price_run *all, int rounds)
{
    price_run *with = k->declined ? k : all, *without = k->declined ? all : k;
    double a = clock_median(with->seconds, rounds), b = clock_median(without->seconds, rounds);
    double mean = price_mean(&with->im), its = mean - price_mean(&without->im);
    bool one = k->effect >= 0;
    k->light = mean > 0 ? its / mean * 100 : 0, k->time = (a - b) / (k->declined ? b : a) * 100;
    table_text(t, "%s%s", one ? effect_names[k->effect].name : "the plan",
               k->declined ? ", declined" : "");
    table_count(t, with->j.counts.rays[one ? k->effect : RAY_OF_EYE]);
    if (one && mean > 0) table_number(t, k->light);
    else table_text(t, "-");  /* nothing of a black picture is a share */
    if (one) table_number(t, image_compare(&k->im, &all->im).rmse), table_number(t, k->time);
    else table_text(t, "-"), table_text(t, "-");
    table_number(t, (k->declined ? a : b) / draw_pixels(&k->j) * 1e6);
}

/* Declined ones are hollow: their light is what the picture does without. */
static inline void price_bars(const options *o, const price_run *run, int n)
{
    enum { left = 190, across = 460, row = 44, thick = 14 };
    double most = 1;
    int height = row * (n - 1) + 70;
    for (int i = 1; i < n; i++) most = fmax(most, fmax(run[i].light, run[i].time));
    figure g = figure_begin(o, "27_effects_price_time.svg", 760, height);
    figure_origin(&g, 0, height, 1);
    figure_text(&g, left, height - 24, 0, 0, FIGURE_LEFT, FIGURE_ORANGE,
                "light it brings [% of the picture]");
    figure_text(&g, left + 280, height - 24, 0, 0, FIGURE_LEFT, FIGURE_BLUE,
                "time it takes [% of the plan's]");
    for (int i = 1; i < n; i++) {
        double y = height - 50 - row * (i - 1) - 24;
        figure_print(&g, left, y, -12, -9, FIGURE_RIGHT, FIGURE_BLACK, "%s%s",
                     effect_names[run[i].effect].name, run[i].declined ? " (declined)" : "");
        for (int k = 0; k < 2; k++) {
            const char *colour = k ? FIGURE_BLUE : FIGURE_ORANGE;
            double percent = k ? run[i].time : run[i].light, foot = k ? y - 1 : y + 15;
            double end = left + fmax(percent, 0) / most * across, top = foot + thick;
            figure_polygon(&g, 4, (double[8]){left, foot, end, foot, end, top, left, top}, colour,
                           run[i].declined ? 0.25 : 1, colour);
            figure_print(&g, end, foot, 6, -2, FIGURE_LEFT, FIGURE_BLACK, "%.1f %%", percent);
        }
    }
    figure_end(&g);
}

static inline bool table_of_price(const options *o, const plan *p, effects_stage *e, int w, int h,
                                  int samples)
{
    int rounds = o->full || (o->own && !o->quick) ? 3 : 1, n = 1;
    unsigned before = e->mask, called = p->effects & before;  /* --effects may leave some out */
    price_run run[effect_kinds + 1] = {{.effect = -1, .mask = called}};
    bool whole = true;
    for (int k = 0; k < effect_kinds; k++)
        if ((called | p->declined) >> k & 1)
            run[n++] = (price_run){.effect = k, .mask = called ^ 1u << k,
                                   .declined = p->declined >> k & 1};
    for (int i = 0; i < n * rounds && whole; i++) {
        price_run *k = &run[i % n];
        k->j = (drawing){.e = e, .samples = samples, .seed = o->seed, .width = w, .height = h};
        /* General: else some sets would have a copy made for them, others not. */
        effects_stage_effects(e, k->mask | EFFECTS_GENERAL);
        image_free(&k->im);
        whole = draw_image(&k->j, &k->im, o->threads);
        k->seconds[i / n] = k->j.pass.seconds;
    }
    table t = table_new("The price of each effect: the light it brings, the time it takes",
                        "effect|its rays|its light [%]|without it: rmse|its time [%]|"
                        "time [us/pixel]");
    for (int i = 0; i < n && whole; i++) price_row(&t, &run[i], &run[0], rounds);
    options beside = *o;  /* the drawing goes to build/, wherever the picture goes */
    beside.out = NULL, beside.own = false;
    if (whole) output_table(o, &t), price_bars(&beside, run, n);
    else table_free(&t);
    for (int i = 0; i < n; i++) image_free(&run[i].im);
    effects_stage_effects(e, before);
    return whole;
}

#endif
