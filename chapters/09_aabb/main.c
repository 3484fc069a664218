/* 09_aabb: a ray and a box: what each slab test loses, what it costs, and what a box hit is worth.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 09_aabb chapters/09_aabb/main.c -lm -lpthread
 */
#include "lab/drawing.h"
#include "lab/methods.h"
#include "lab/pictures.h"

int main(int argc, char **argv)
{
    options defaults = {.width = 846 + 426 * aabb_mine, .height = 360, .seed = 1};
    options o = options_read(argc, argv, "09_aabb", "A ray and a box: errors, time, false alarms.",
                             defaults, NULL);
    bool right = !aabb_mine || aabb_prove(mine_aabb_hit, "mine", 30000, stdout);
    draw_room(&o), draw_slabs(&o), draw_aligned(&o);
    measure_slabs(&o);
    if (o.full) measure_volumes(&o);
    return output_done(&o) || !right;
}
