/* bars.h: what each effect brings and takes, as bars: light above, time below.
 *
 *   price_bars b = {.n = 0};
 *   price_bars_add(&b, "mirror", declined, light, time)     per cent of the picture's
 *   price_bars_draw(&o, &b, "27_effects_price_time.svg")
 */
#ifndef EFFECTS_BARS_H
#define EFFECTS_BARS_H

#include "../../../common/lab/figure.h"
#include "../effect.h"

typedef struct {
    struct { const char *name; bool declined; double light, time; } bar[effect_kinds];
    int n;
} price_bars;

enum { bars_left = 190, bars_width = 460, bars_row = 44 };

/* ---------------------------------------------------------------------------------------------- */

static inline void price_bars_add(price_bars *b, const char *name, bool declined, double brings,
                                  double time)
{
    if (b->n == effect_kinds) return;
    b->bar[b->n].name = name, b->bar[b->n].declined = declined;
    b->bar[b->n].light = brings, b->bar[b->n++].time = time;
}

static inline void bars_one(figure *g, double y, double percent, double most, const char *colour,
                            bool filled)
{
    char text[32];
    double length = (percent > 0 ? percent : 0) / most * bars_width;
    double xy[8] = {bars_left, y, bars_left + length, y, bars_left + length, y + 14, bars_left,
                    y + 14};
    figure_polygon(g, 4, xy, colour, filled ? 1 : 0.25, colour);
    snprintf(text, sizeof text, "%.1f %%", percent);
    figure_text(g, bars_left + length, y, 6, -2, FIGURE_LEFT, FIGURE_BLACK, text);
}

/* Declined ones are hollow: their light is what the picture does without. */
static inline void price_bars_draw(const options *o, const price_bars *b, const char *name)
{
    double most = 1;
    int height = bars_row * b->n + 70;
    for (int i = 0; i < b->n; i++) {
        most = b->bar[i].light > most ? b->bar[i].light : most;
        most = b->bar[i].time > most ? b->bar[i].time : most;
    }
    figure g = figure_begin(o, name, 760, height);
    figure_origin(&g, 0, height, 1);
    figure_text(&g, bars_left, height - 24, 0, 0, FIGURE_LEFT, FIGURE_ORANGE,
                "light it brings [% of the picture]");
    figure_text(&g, bars_left + 280, height - 24, 0, 0, FIGURE_LEFT, FIGURE_BLUE,
                "time it takes [% of the plan's]");
    for (int i = 0; i < b->n; i++) {
        double y = height - 50 - bars_row * i - 24;
        char text[80];
        snprintf(text, sizeof text, "%s%s", b->bar[i].name,
                 b->bar[i].declined ? " (declined)" : "");
        figure_text(&g, bars_left, y, -12, -9, FIGURE_RIGHT, FIGURE_BLACK, text);
        bars_one(&g, y + 15, b->bar[i].light, most, FIGURE_ORANGE, !b->bar[i].declined);
        bars_one(&g, y - 1, b->bar[i].time, most, FIGURE_BLUE, !b->bar[i].declined);
    }
    figure_end(&g);
}

#endif
