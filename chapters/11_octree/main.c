/* 11_octree: a cube cut into eight, and again: its cells, their order along a ray, their cost.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 11_octree chapters/11_octree/main.c -lm -lpthread
 *
 * Without options: the teapot with its cells, the work a pixel, a quadtree with a ray, what the
 * textbook's walk gets wrong, a short table. --full: all tables and plots. --mesh FILE.obj: that
 * mesh, its cells. */
#include "../07_mesh/files/obj.h"
#include "lab/measure.h"
#include "lab/pictures.h"
#include "lab/quadtree.h"

int main(int argc, char **argv)
{
    const char *path = NULL;
    const option list[] = {
        {"mesh", OPTION_INPUT, &path, 0, 0, "FILE.obj: draw this mesh, y up, and its cells"}, {0}};
    options o = options_read(argc, argv, "11_octree", "Octrees: space cut into eight.",
                             (options){.width = 640, .height = 400, .seed = 1}, list);
    failure f;
    mesh m = {0};
    trial_scene s;
    if (path && o.csv) die(2, "--csv: no table with --mesh");
    if (o.out && o.csv) die(2, "--out draws, --csv measures: one of them");
    if (path && !obj_read(path, &m, &f)) fail(f);
    trial_scene_of(path ? m : teapot_mesh(o.quick ? 8 : 12), &s);
    o.own = path != NULL;
    draw_octree(&o, &s, path);
    trial_scene_free(&s);
    if (o.own || o.out) return output_done(&o);
    draw_quadtree(&o);
    draw_faults(&o);
    table_of_knobs(&o);
    if (o.full) table_of_stadium(&o), plot_of_depth(&o);
    return output_done(&o);
}
