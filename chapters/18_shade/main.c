/* 18_shade: trace and shade, kinds of ray, lights and hard shadows; how a ray leaves a surface.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 18_shade chapters/18_shade/main.c -lm -lpthread
 *
 * Without options: the gallery and its rays, what goes wrong with its shadows far out, the edge of
 * light on a mesh, a drawing, the table of ways to leave a sphere. --full: that of triangles, its
 * plot, and needles. --samples N: down to a square. */
#include "../../common/lab/report.h"
#include "lab/measure.h"
#include "lab/pictures.h"

int main(int argc, char **argv)
{
    bool all = false;
    const option own[] = {
        {"spend-all", OPTION_FLAG, &all, 0, 0, "send the shadow rays that cannot contribute, too"},
        {0}};
    options o = {.width = 800, .height = 450, .seed = 1, .samples = 4,
                 .quick_width = 240, .quick_height = 135, .quick_samples = 1};
    o = options_read(argc, argv, "18_shade", "Trace and shade; leaving a surface.", o, own);
    if (o.out && o.csv) die(2, "--out draws, --csv measures: one of them");
    draw_gallery(&o, all);
    if (o.out) return output_done(&o);
    draw_acne(&o);
    draw_terminator(&o);
    draw_tilt(&o);
    table_of_spheres(&o);
    if (o.full) table_of_triangles(&o), table_of_needles(&o);
    return output_done(&o);
}
