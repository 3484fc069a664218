/* 24_direct_light: light straight from the lights, drawn by directions, by lights, and by both.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 24_direct_light chapters/24_direct_light/main.c -lm -lpthread
 * Without options: a picture, a drawing, the main table. --full: four pictures, three tables, a
 * plot. Errors are measured against a long run with well-spread points, which a test compares with
 * closed forms. */
#include "lab/measure.h"
#include "lab/ways_figure.h"

int main(int argc, char **argv)
{
    options o = options_read(argc, argv, "24_direct_light",
                             "Direct light by directions, by lights and by both.",
                             (options){.width = 640, .height = 640, .samples = 8, .seed = 1,
                                       .quick_samples = 1},
                             NULL);
    draw_box(&o);
    if (!o.out) draw_ways(&o);
    measure_ways(&o);
    if (!o.full) return output_done(&o);
    if (!o.out) {
        draw_exhibit(&o, &exhibit_points);
        draw_exhibit(&o, &exhibit_plates), draw_exhibit(&o, &exhibit_strip);
    }
    measure_points(&o);
    measure_near(&o);
    return output_done(&o);
}
