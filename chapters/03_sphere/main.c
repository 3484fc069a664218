/* 03_sphere: a ray meets a sphere, in six ways: which rays each gets wrong, and what it costs.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 03_sphere chapters/03_sphere/main.c -lm -lpthread
 * The oracle is sphere_oracle.h. The picture shows a sphere from far away through a long lens. */
#include "lab/sphere_draw.h"
#include "lab/sphere_measure.h"

int main(int argc, char **argv)
{
    options defaults = {.width = 954, .height = 486 + 246 * sphere_mine, .seed = 1};
    const char *about = "A ray meets a sphere: error and time.";
    options o = options_read(argc, argv, "03_sphere", about, defaults, NULL);
    bool right = !sphere_mine || sphere_prove(mine_sphere_hit, "mine", 30000, stdout);
    sphere_draw(&o);
    sphere_draw_geometry(&o);
    sphere_main_table(&o);
    if (o.full) sphere_plot_edge(&o), sphere_doubt_table(&o);
    return output_done(&o) || !right;
}
