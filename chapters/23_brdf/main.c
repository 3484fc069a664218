/* 23_brdf: how surfaces reflect, and the reflection equation integrated five ways.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 23_brdf chapters/23_brdf/main.c -lm -lpthread
 * Errors are measured against a quadrature over half vectors that shares nothing with the
 * samplers. */
#include "lab/measure.h"
#include "lab/pictures.h"
#include "lab/vectors_figure.h"

int main(int argc, char **argv)
{
    options defaults = {.width = 980, .height = 560, .samples = 32, .quick_samples = 4, .seed = 1};
    options o = options_read(argc, argv, "23_brdf",
                             "BRDFs, and the reflection equation: error against time.", defaults,
                             NULL);
    draw_spheres(&o), plot_lobes(&o), draw_vectors(&o);
    measure_glossy(&o);
    if (o.full) measure_furnace(&o);
    return output_done(&o);
}
