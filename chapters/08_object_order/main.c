/* 08_object_order: for each triangle its pixels, or for each pixel its triangles.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 08_object_order chapters/08_object_order/main.c -lm -lpthread
 * The oracle: the ray through the middle of each pixel against every triangle (07). */
#include "lab/orders_draw.h"
#include "lab/orders_measure.h"

int main(int argc, char **argv)
{
    options o = options_read(argc, argv, "08_object_order", "The two orders of rendering.",
                             (options){.width = 964, .height = 488}, NULL);
    orders_draw(&o);
    orders_measure(&o);
    if (o.out || o.own) return output_done(&o);
    orders_draw_flat(&o);
    orders_draw_edges(&o);
    orders_draw_shadow(&o);
    if (o.full) orders_times(&o), orders_shadows(&o);
    return output_done(&o);
}
