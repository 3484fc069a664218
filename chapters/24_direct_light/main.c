/* 24_direct_light: light straight from the lights, drawn by directions, by lights, and by both.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 24_direct_light chapters/24_direct_light/main.c -lm -lpthread
 * Errors are measured against closed forms, and where there are none against a long run with
 * well-spread points. */
#include "measure.h"

int main(int argc, char **argv)
{
    options defaults = {.width = 480, .height = 480, .samples = 16, .seed = 1};
    options o = options_read(argc, argv, "24_direct_light",
                             "Direct light by directions, by lights and by both.", defaults, NULL);
    draw_box(&o);
    draw_equal(&o);
    draw_plates(&o), draw_strip(&o), draw_hall(&o);
    measure_ways(&o);
    measure_lights(&o);
    measure_closed(&o);
    measure_near(&o);
    measure_called(&o);
    return 0;
}
