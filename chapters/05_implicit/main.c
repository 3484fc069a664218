/* 05_implicit: surfaces f(p) = 0 by steps, Newton, sphere tracing, intervals: what each misses.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 05_implicit chapters/05_implicit/main.c -lm -lpthread
 *
 * Without options: Barth's sextic, three ways along one ray, a table; --full: what steps miss
 * of it, other surfaces, more tables. */
#include "lab/implicit_figure.h"
#include "lab/implicit_measure.h"
#include "lab/implicit_pictures.h"

int main(int argc, char **argv)
{
    options o = {.width = 960, .height = 640, .samples = 4, .seed = 1,
                 .quick_width = 240, .quick_height = 160, .quick_samples = 1};
    o = options_read(argc, argv, "05_implicit", "Surfaces f(p) = 0, and who misses what.", o, NULL);
    implicit_draw(&o);
    if (!o.out) implicit_draw_roots(&o);
    if (!o.out && (o.full || o.quick)) implicit_draw_missed(&o);
    implicit_measure(&o);
    return output_done(&o);
}
