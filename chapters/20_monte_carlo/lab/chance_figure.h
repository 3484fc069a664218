/* chance_figure.h: the drawing of this chapter: means of a die's throws closing in on 3.5; numbers
 * u in equal steps turned into x by a density's inversion; and f beside that density.
 *
 *   draw_chance(&o);      20_monte_carlo_chance.svg
 */
#ifndef MONTE_CARLO_CHANCE_FIGURE_H
#define MONTE_CARLO_CHANCE_FIGURE_H

#include "../../../common/lab/figure.h"
#include "../first.h"

/* ---------------------------------------------------------------------------------------------- */

enum { chance_steps = 80, chance_most = 1024 };  /* of a curve; throws of a run */

/* A frame from (0, 0) to (1, 1), and what is said below it. */
static inline void chance_frame(figure *g, const char *below, const char *title)
{
    figure_arrow(g, 0, 0, 1.08, 0, FIGURE_BLACK, 1.2);
    figure_arrow(g, 0, 0, 0, 1.12, FIGURE_BLACK, 1.2);
    figure_text(g, 1.08, 0, 6, 5, FIGURE_LEFT, FIGURE_BLACK, below);
    figure_text(g, 0.5, 0, 0, 62, FIGURE_MIDDLE, FIGURE_BLACK, title);
}

/* N of step k: from 1 to the most, evenly in its logarithm. */
static inline double chance_n(int k) { return pow(chance_most, (double)k / chance_steps); }
static inline double chance_face(double mean) { return (mean - 1) / 5; }

/* The mean of a run of throws after N of them; face 1 + floor(6 u). */
static inline void chance_run(figure *g, int run)
{
    double sum = 0, x = 0, y = 0;
    int done = 0;
    for (int k = 0; k <= chance_steps; k++) {
        int n = (int)(chance_n(k) + 0.5);
        if (n == done) continue;
        for (; done < n; done++)
            sum += 1 + floor(6 * (double)random_real(7, (uint64_t)run, (uint64_t)done, 0));
        double tx = log(n) / log(chance_most), ty = chance_face(sum / n);
        if (n > 1) figure_line(g, x, y, tx, ty, FIGURE_ORANGE, 1.5, FIGURE_WHOLE);
        x = tx, y = ty;
    }
}

/* Throws have the variance 35/12: the band is 3.5 -+ sqrt(35/12 / N), the standard error. */
static inline void chance_die(figure *g)
{
    double band[4 * (chance_steps + 1)];
    for (int k = 0; k <= chance_steps; k++) {
        double x = (double)k / chance_steps, e = sqrt(35.0 / 12 / chance_n(k)) / 5;
        double *high = band + 2 * k, *low = band + 2 * (2 * chance_steps + 1 - k);
        high[0] = low[0] = x, high[1] = 0.5 + e, low[1] = 0.5 - e;
    }
    figure_polygon(g, 2 * (chance_steps + 1), band, FIGURE_SKY, 0.35, NULL);
    figure_line(g, 0, 0.5, 1.03, 0.5, FIGURE_GREY, 1.2, FIGURE_DASHED);
    for (int run = 0; run < 5; run++) chance_run(g, run);
    chance_frame(g, "_N_", "means of _N_ throws of a die, five runs");
    for (int face = 1; face <= 6; face++)
        figure_print(g, 0, chance_face(face), -8, 5, FIGURE_RIGHT, FIGURE_BLACK, "%d", face);
    for (int n = 1; n <= chance_most; n *= 4)
        figure_print(g, log(n) / log(chance_most), 0, 0, 20, FIGURE_MIDDLE, FIGURE_BLACK, "%d", n);
    figure_text(g, 0.99, 0.5, 0, -32, FIGURE_RIGHT, FIGURE_BLACK, "_E_[_X_] = 3.5");
    figure_text(g, 0.22, 0.96, 0, 0, FIGURE_LEFT, FIGURE_BLUE, "3.5 ± _s_ / √_N_");
}

static inline double chance_below(double x) { return (4 * x - x * x) / 3; }  /* P(x) */

static inline void chance_inversion(figure *g)
{
    enum { arrows = 10 };
    for (int k = 0; k < arrows; k++) {
        double u = (k + 0.5) / arrows, x = (double)first_pi_inversion((real)u);
        figure_line(g, 0, u, x, u, FIGURE_BLUE, 1, FIGURE_WHOLE);
        figure_arrow(g, x, u, x, 0.01, FIGURE_GREEN, 1);
        figure_dot(g, 0, u, 3, FIGURE_BLUE);
    }
    for (int k = 0; k < chance_steps; k++) {
        double x = (double)k / chance_steps, to = (k + 1.0) / chance_steps;
        figure_line(g, x, chance_below(x), to, chance_below(to), FIGURE_BLACK, 2, FIGURE_WHOLE);
    }
    chance_frame(g, "_x_", "inversion: _x_ are dense where _p_ is large");
    figure_text(g, 0, 1, -8, 5, FIGURE_RIGHT, FIGURE_BLACK, "1");
    figure_text(g, 1, 0, 0, 20, FIGURE_MIDDLE, FIGURE_BLACK, "1");
    figure_text(g, 0, 0.5, -10, 5, FIGURE_RIGHT, FIGURE_BLUE, "_u_");
    figure_text(g, 0.76, 0.87, 0, 0, FIGURE_RIGHT, FIGURE_BLACK, "_P_(_x_)");
}

/* f, the density times pi, and the uniform one times pi: a density that is f / pi has no error. */
static inline void chance_densities(figure *g)
{
    const double high = 4.3, true_pi = 3.14159265358979324;
    double x = 0;
    for (int k = 1; k <= chance_steps; k++) {
        double to = sin(true_pi / 2 * k / chance_steps), y[2][2];  /* closer where f falls fast */
        for (int end = 0; end < 2; end++) {
            double at = end ? to : x;
            y[0][end] = (double)first_pi_uniform((real)at) / high;
            y[1][end] = true_pi * (double)first_pi_density((real)at) / high;
        }
        figure_line(g, x, y[0][0], to, y[0][1], FIGURE_BLACK, 2, FIGURE_WHOLE);
        figure_line(g, x, y[1][0], to, y[1][1], FIGURE_GREEN, 2, FIGURE_WHOLE);
        x = to;
    }
    figure_line(g, 0, true_pi / high, 1, true_pi / high, FIGURE_BLUE, 2, FIGURE_WHOLE);
    chance_frame(g, "_x_", "_f_ / _p_ varies less for the green _p_");
    figure_text(g, 0, 4 / high, -8, 5, FIGURE_RIGHT, FIGURE_BLACK, "4");
    figure_text(g, 0, true_pi / high, -8, 5, FIGURE_RIGHT, FIGURE_BLACK, "π");
    figure_text(g, 1, 0, 0, 20, FIGURE_MIDDLE, FIGURE_BLACK, "1");
    figure_text(g, 0.36, 4 / high, 8, 2, FIGURE_LEFT, FIGURE_BLACK, "_f_ = 4 √(1 − _x_²)");
    figure_text(g, 0.1, 0.62, 0, 14, FIGURE_LEFT, FIGURE_BLUE, "π times _p_ = 1");
    figure_text(g, 0.1, 0.4, 0, 14, FIGURE_LEFT, FIGURE_GREEN, "π times _p_ = (4 − 2_x_) / 3");
}

cold_inline void draw_chance(const options *o)
{
    figure g = figure_begin(o, "20_monte_carlo_chance.svg", 1080, 350);
    figure_origin(&g, 40, 275, 235);
    chance_die(&g);
    figure_origin(&g, 420, 275, 235);
    chance_inversion(&g);
    figure_origin(&g, 785, 275, 235);
    chance_densities(&g);
    figure_end(&g);
}

#endif
