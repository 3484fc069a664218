/* 16_instances: a forest of two firs, an oak, two birches, many times; normals that stay right.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 16_instances chapters/16_instances/main.c -lm -lpthread
 *
 * Without options: the forest, a drawing of both levels, a table of methods. --full: what goes
 * wrong with normals and with normalised rays; growth. */
#include "lab/measure.h"
#include "lab/pictures.h"
#include "lab/two_levels.h"

int main(int argc, char **argv)
{
    const option none[] = {{0}};
    options o = options_read(argc, argv, "16_instances",
                             "Instances: one mesh in many places, a tree of two levels.",
                             (options){.width = 640, .height = 400, .seed = 1}, none);
    if (o.out && o.csv) die(2, "--out draws, --csv measures: one of them");
    draw_forest(&o, false);
    if (o.out) return output_done(&o);
    draw_two_levels(&o);
    table_of_methods(&o);
    if (o.full) draw_forest(&o, true), draw_normals(&o), table_of_growth(&o);
    return output_done(&o);
}
