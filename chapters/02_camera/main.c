/* 02_camera: the ray through each point of a picture, by four kinds of camera; several a pixel.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 02_camera chapters/02_camera/main.c -lm -lpthread
 *
 * Draws one room through four cameras, eye and window, three vanishing points; prints what several
 * rays a pixel cost and bring. --full: also the slip in RTR's equation, a camera far from the
 * origin, a zone plate. */
#include "lab/geometry.h"
#include "lab/measure.h"
#include "lab/pictures.h"

/* n x n rays a pixel: the largest square that is not more than was asked for. */
static int side_of(const options *o)
{
    int n = pixels_side(o->samples);
    if (n * n != o->samples)
        fprintf(stderr, "%s: --samples %d: %d, the next square below, are taken\n", program_name,
                o->samples, n * n);
    return n;
}

int main(int argc, char **argv)
{
    options o = {.width = 806, .height = 806, .samples = 16, .quick_samples = 1, .seed = 1};
    o = options_read(argc, argv, "02_camera", "camera rays of four kinds, several a pixel", o,
                     NULL);
    camera_room scene = room_corner();
    camera_view v = {.scene = &scene, .f = filter_tent, .how = SAMPLES_JITTERED, .seed = o.seed};
    v.n = side_of(&o);
    camera_draw_four(&o, v);
    if (!o.out) {
        camera_draw_geometry(&o), camera_draw_vanishing(&o);
        if (o.full || o.quick) camera_draw_slips(&o, v), camera_draw_zone_plate(&o, v);
    }
    camera_measure_filters(&o);
    return output_done(&o);
}
