/* 20_monte_carlo: integrals by chance: how fast the error falls, for four ways of placing samples.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 20_monte_carlo chapters/20_monte_carlo/main.c -lm -lpthread
 * Errors are measured against closed forms, and their size against its own exact value. */
#include "lab/chance_figure.h"
#include "lab/measure.h"
#include "lab/pictures.h"

int main(int argc, char **argv)
{
    options defaults = {.width = 994, .height = 542, .seed = 1,
                        .quick_width = 240, .quick_height = 120};
    options o = options_read(argc, argv, "20_monte_carlo",
                             "Integrals by chance: error against time.", defaults, NULL);
    draw_points(&o);
    if (!o.out) draw_chance(&o), draw_dome(&o), draw_wrong(&o);
    measure_methods(&o);
    measure_importance(&o);
    return output_done(&o);
}
