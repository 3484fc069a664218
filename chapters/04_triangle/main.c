/* 04_triangle: rays aimed exactly at edges of a mesh: who slips through, and what certainty costs.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 04_triangle chapters/04_triangle/main.c -lm -lpthread
 * The oracles: a closed mesh is hit by every ray from its inside; (4.8) in double-double. */
#include "lab/dome.h"
#include "lab/triangle_figures.h"
#include "lab/triangle_measure.h"

int main(int argc, char **argv)
{
    options defaults = {.width = 966 + 324 * triangle_mine, .height = 318, .seed = 1};
    const char *about = "Rays against triangles: who slips between two of them.";
    options o = options_read(argc, argv, "04_triangle", about, defaults, NULL);
    bool right = !triangle_mine || triangle_prove(mine_triangle_hit, "mine", 30000, stdout);
    dome_draw(&o);
    triangle_draw_areas(&o);
    triangle_draw_edges(&o);
    triangle_main_table(&o);
    if (o.full) triangle_plot_slips(&o), triangle_effort_table(&o);
    return output_done(&o) || !right;
}
