/* 15_wide_bvh: the tree of boxes, eight wide: rung by rung, and what watertight costs.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 15_wide_bvh chapters/15_wide_bvh/main.c -lm -lpthread
 *
 * Without options: two pictures, the ladder on a teapot, rays at cracks. --full: all tables.
 * --mesh FILE.obj: that mesh, a picture only. */
#include "../07_mesh/files/obj.h"
#include "../09_aabb/trials/pictures.h"
#include "lab/measure.h"
#include "lab/pictures.h"
#include "lab/stream.h"

static void measure(const options *o, bool large)
{
    trial_scene s;
    bvh8_options how = bvh8_defaults;
    int width = o->quick ? 40 : large ? 320 : 160;
    trial_scene_of(teapot_mesh(o->quick ? 6 : large ? 40 : 12), &s);
    trial_rays(&s, trial_camera(&s.m, 1.6), width, width * 5 / 8, o->quick ? 50 : 1000, o->seed,
               &bvh8_trial, &how);
    table_of_rungs(o, &s, large);
    if (large) table_of_shadows(o, &s), table_of_streams(o, &s), table_of_few(o);
    if (large) table_of_doubts(o, &s);
    else table_of_cracks(o);
    trial_scene_free(&s);
}

int main(int argc, char **argv)
{
    const char *path = NULL;
    const option list[] = {
        {"mesh", OPTION_INPUT, &path, 0, 0, "FILE.obj: draw this mesh, y up"}, {0}};
    options o = options_read(argc, argv, "15_wide_bvh", "Boxes and triangles, eight at once.",
                             (options){.width = 640, .height = 400, .seed = 1}, list);
    failure f;
    mesh m;
    if (o.csv && (path || o.out)) die(2, "--csv: no table with --mesh, --out");
    if (path && !obj_read(path, &m, &f)) fail(f);
    if (!path) m = teapot_mesh(o.quick ? 8 : 40);
    o.own = path != NULL;
    bvh8_options how = bvh8_defaults;
    trial_scene s;
    trial_scene_of(m, &s);
    how.threads = o.threads;
    if (path) trial_draw_mesh(&o, &s, &bvh8_trial, &how, false, "15_wide_bvh.png", path);
    else draw_steps(&o, &s);
    if (!o.own && !o.out) draw_lanes(&o), measure(&o, false);
    if (!o.own && !o.out && o.full) measure(&o, true);
    trial_scene_free(&s);
    return output_done(&o);
}
