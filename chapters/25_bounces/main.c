/* 25_bounces: light sorted by its bounces, rooms where its sum is known, N rays a hit exploding.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 25_bounces chapters/25_bounces/main.c -lm -lpthread
 * Without options: the main picture and table; --full: three tables, a plot.
 * Errors are measured against closed forms, linear systems, and an estimate that shares nothing
 * with the paths but their walk. */
#include "lab/measure.h"
#include "lab/pictures.h"
#include "lab/tree_figure.h"

int main(int argc, char **argv)
{
    int pixel[2] = {0, 0};
    option own[] = {
        {"tree", OPTION_SIZE, pixel, 1, tree_side - 1,
         "XxY: the tree of rays of this pixel of 480x480, into build/quick/"}, {0}};
    options defaults = {.width = 1000, .height = 400, .samples = 32, .quick_samples = 4, .seed = 1};
    options o = options_read(argc, argv, "25_bounces", "L = E + KE + K^2 E + ...", defaults, own);
    o.own = pixel[0];
    if (o.own && (o.out || o.csv)) die(2, "--out, --csv: not allowed with --tree");
    if (o.own) { draw_tree(&o, pixel[0], pixel[1]); return output_done(&o); }
    draw_terms(&o);
    if (!o.out) draw_tree(&o, 205, 190);
    measure_branches(&o);
    if (o.full) measure_series(&o), measure_cornell(&o);
    return output_done(&o);
}
