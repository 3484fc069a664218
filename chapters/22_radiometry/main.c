/* 22_radiometry: flux, intensity, irradiance, radiance, solid angle: computed, and measured.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 22_radiometry chapters/22_radiometry/main.c -lm -lpthread
 * Every number has a closed form and an experiment; both are tested against each other. */
#include "lab/angles_figure.h"
#include "lab/measure.h"
#include "lab/measure_hard.h"
#include "lab/pictures.h"

int main(int argc, char **argv)
{
    options defaults = {.width = 900, .height = 600, .seed = 1};
    options o = options_read(argc, argv, "22_radiometry",
                             "Light as something measured: irradiance of three lights.", defaults,
                             NULL);
    draw_floor(&o), draw_view(&o), draw_angles(&o);
    measure_estimators(&o);
    if (o.full) {
        measure_relations(&o);
        measure_hard(&o);
    }
    return output_done(&o);
}
