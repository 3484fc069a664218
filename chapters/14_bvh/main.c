/* 14_bvh: a tree of boxes over the triangles of a mesh: built in eight ways, searched, compared.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 14_bvh chapters/14_bvh/main.c -lm -lpthread
 *
 * Without options: the teapot of 102080 triangles, what each pixel took, a short table. --full: all
 * tables and plots. --mesh FILE.obj: that mesh, a picture only. --pixel X,Y: its ray. */
#include "../07_mesh/files/obj.h"
#include "lab/greed_figure.h"
#include "lab/measure.h"
#include "lab/pixel.h"

/* The book's own scenes. */
static void measure(const options *o)
{
    const bvh_options how = bvh_defaults;
    trial_scene s;
    int width = o->quick ? 40 : o->full ? 240 : 80;
    trial_scene_of(teapot_mesh(o->quick ? 6 : o->full ? 40 : 12), &s);
    trial_rays(&s, trial_camera(&s.m, 1.6), width, width * 5 / 8, o->quick ? 50 : 1000, o->seed,
               &bvh_trial, &how);
    table_of_rules(o, &s);
    if (o->full) table_of_orders(o, &s), plot_of_pareto(o, &s);
    trial_scene_free(&s);
}

int main(int argc, char **argv)
{
    const char *path = NULL, *pixel = NULL, *up = "y";
    const option list[] = {
        {"mesh", OPTION_INPUT, &path, 0, 0, "FILE.obj: draw this mesh"},
        {"up", OPTION_TEXT, &up, 0, 0, "of that mesh: y (default) or z points up"},
        {"pixel", OPTION_TEXT, &pixel, 0, 0, "X,Y: its ray, box by box, in words and drawn"},
        {0}};
    options o = options_read(argc, argv, "14_bvh", "Bounding volume hierarchies of meshes.",
                             (options){.width = 640, .height = 400, .seed = 1}, list);
    const bvh_options how = bvh_defaults;
    failure f;
    trial_scene s = {.due = NULL};
    if (o.csv && (path || o.out)) die(2, "--csv: no table with --mesh, --out");
    if (pixel && (o.out || o.csv)) die(2, "--pixel: not with --out, --csv");
    bool z_up = !path || strcmp(up, "z") == 0;
    if (!z_up && strcmp(up, "y") != 0) die(2, "bad value --up %s: allowed are y, z", up);
    if (path && !obj_read(path, &s.m, &f)) fail(f);
    if (!path) s.m = teapot_mesh(o.quick ? 8 : 40);
    s.x = items_of_mesh(&s.m);
    o.own = path || pixel;
    if (pixel) bvh_explain(&o, &s.m, how, z_up, pixel);
    else trial_draw_mesh(&o, &s, &bvh_trial, &how, z_up, "14_bvh.png", path);
    if (!o.own && !o.out) draw_nested(&o), draw_greed(&o), draw_rules(&o, &s), measure(&o);
    trial_scene_free(&s);
    return output_done(&o);
}
