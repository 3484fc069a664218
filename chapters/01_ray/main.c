/* 01_ray: a point on a ray, in two forms and two precisions: what each costs and how far it is off.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 01_ray chapters/01_ray/main.c -lm -lpthread
 * The oracle is wide.h. The picture shows one ray in float, ever farther from the origin. */
#include "lab/pictures.h"
#include "lab/points.h"

int main(int argc, char **argv)
{
    options o = {.width = 1218, .height = 300, .seed = 1};
    o = options_read(argc, argv, "01_ray", "A point on a ray: error and time.", o, NULL);
    ray_draw_steps(&o);
    ray_draw_interval(&o);
    ray_measure(&o);
    return output_done(&o);
}
