/* 20_monte_carlo: integrals by chance: how fast the error falls, for six ways of placing samples.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 20_monte_carlo chapters/20_monte_carlo/main.c -lm -lpthread
 * Errors are measured against closed forms, and their size against its own exact value. */
#include "lab/measure.h"
#include "lab/measure_floats.h"
#include "lab/measure_importance.h"
#include "lab/pictures.h"

/* ---- time of one estimate, points and both integrands ---- */

typedef struct { int method; uint64_t seed; uint32_t n; } timed_estimate;

static double run_estimate(void *context)
{
    const timed_estimate *e = context;
    double error[integrands];
    convergence_errors(e->method, e->seed, 0, e->n, error);
    return error[SMOOTH] + error[EDGE];
}

static void number_or_dash(table *t, double x)
{
    if (isnan(x)) table_text(t, "-");
    else table_number(t, x);
}

/* ns a sample, at 1024 samples: it hardly depends on their number. */
static void measure_time(const options *o, double ns[convergence_methods])
{
    timed_estimate e[convergence_methods];
    clock_variant v[convergence_methods];
    for (int k = 0; k < convergence_methods; k++) {
        e[k] = (timed_estimate){k, o->seed, 1024};
        v[k] = (clock_variant){convergence_name(k), run_estimate, &e[k], 0};
    }
    clock_compare(v, convergence_methods, o->quick ? 5 : 99);
    for (int k = 0; k < convergence_methods; k++) ns[k] = v[k].seconds / 1024 * 1e9;
}

static void measure_methods(const options *o)
{
    double ns[convergence_methods];
    int levels = o->quick ? 4 : 6, runs = o->quick ? 48 : 480;
    convergence *c = convergence_measure(levels, runs, o->seed, o->threads);
    table t = table_new("Root mean square error of two integrals, its exact value, and time",
                        "method|N|exact smooth|error smooth|exact edge|error edge|time [us]");
    plot smooth = plot_new("Error of a smooth integral", "N", "error", PLOT_LOG_X | PLOT_LOG_Y);
    plot edge = plot_new("Error of a pixel with an edge", "N", "error", PLOT_LOG_X | PLOT_LOG_Y);
    plot time = plot_new("Error of a smooth integral, and time", "time of an estimate [us]",
                         "error", PLOT_LOG_X | PLOT_LOG_Y);
    measure_time(o, ns);
    for (int k = 0; k < convergence_methods; k++) {
        bool apart = k != CONVERGENCE_FIRST;  /* its errors lie on those of random */
        const char *name = convergence_name(k);
        if (apart) plot_series(&smooth, name), plot_series(&edge, name);
        plot_series(&time, name);
        for (int l = 0; l < c->levels; l++) {
            double n = convergence_n(l), us = n * ns[k] / 1000;
            table_text(&t, "%s", name), table_count(&t, convergence_n(l));
            for (int f = 0; f < integrands; f++) {
                double rms = convergence_rms(c, k, (integrand)f, l);
                number_or_dash(&t, convergence_exact(k, (integrand)f, l));
                table_number(&t, rms);
                if (apart) plot_add(f == SMOOTH ? &smooth : &edge, k, n, rms);
                if (f == SMOOTH) plot_add(&time, k, us, rms);
            }
            table_number(&t, us);
        }
    }
    plot_slope(&smooth, -0.5, "slope -1/2"), plot_slope(&smooth, -1.5, "slope -3/2");
    plot_slope(&edge, -0.5, "slope -1/2"), plot_slope(&edge, -0.75, "slope -3/4");
    plot_slope(&time, -0.5, "slope -1/2");
    output_table(o, &t);
    output_plot(o, &smooth, "20_monte_carlo_error.svg");
    output_plot(o, &edge, "20_monte_carlo_edge.svg");
    output_plot(o, &time, "20_monte_carlo_time.svg");
    measure_slopes(o, c);
    free(c);
}

int main(int argc, char **argv)
{
    options defaults = {.width = 1002, .height = 834, .seed = 1};
    options o = options_read(argc, argv, "20_monte_carlo",
                             "Integrals by chance: error against time.", defaults, NULL);
    draw_points(&o), draw_wrong(&o);
    measure_methods(&o);
    measure_rays(&o);
    measure_importance(&o);
    measure_maps(&o), measure_scrambles(&o);
    measure_sums(&o), measure_variances(&o);
    return output_done(&o);
}
