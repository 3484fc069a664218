/* 13_bsp: space cut by planes of any direction: rays front to back, the painter back to front.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 13_bsp chapters/13_bsp/main.c -lm -lpthread
 *
 * Without options: three pictures, a short table. --full: all tables and plots. FILE.obj: that
 * mesh instead, its cells and the work of each pixel. */
#include "../07_mesh/files/obj.h"
#include "lab/strip.h"
#include "lab/measure.h"
#include "lab/painting.h"
#include "lab/pictures.h"

int main(int argc, char **argv)
{
    const char *path = NULL;
    char name[512];
    const option list[] = {
        {"mesh", OPTION_INPUT, &path, 0, 0, "FILE.obj: the cells of this mesh instead, y up"}, {0}};
    options o = options_read(argc, argv, "13_bsp", "BSP trees: for rays, and for the painter.",
                             (options){.width = 960, .height = 600, .seed = 1}, list);
    failure f;
    trial_scene s;
    mesh m = {0};
    if (path && o.csv) die(2, "--csv: no table with --mesh");
    if (o.out && o.csv) die(2, "--out draws, --csv measures: one of them");
    if (path && !obj_read(path, &m, &f)) fail(f);
    trial_scene_of(path ? m : teapot_mesh(o.quick ? 4 : 12), &s);
    o.own = path != NULL;
    image im = image_new(o.width, o.height);
    bool whole = draw_trees(&s, !path, o.threads, &im);
    output_picture(&o, &im, picture_name("13_bsp.png", path, name), true, whole);
    image_free(&im), trial_scene_free(&s);
    if (o.own || o.out) return output_done(&o);
    draw_strip(&o), draw_cyclic(&o);
    table_of_choices(&o);
    if (o.full) table_of_scenes(&o), table_of_losses(&o);
    return output_done(&o);
}
