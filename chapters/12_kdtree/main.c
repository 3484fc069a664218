/* 12_kdtree: space cut in two by planes across the axes, again and again: built, compared.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 12_kdtree chapters/12_kdtree/main.c -lm -lpthread
 *
 * Without options: what each pixel of the teapot took, by four rules; the tree in the plane; a
 * short table. --full: all tables and plots. --mesh FILE.obj: the first picture of that mesh. */
#include "../07_mesh/files/obj.h"
#include "lab/figure.h"
#include "lab/measure.h"
#include "lab/pictures.h"

static void draw(const options *o, const trial_scene *s, const char *path)
{
    char name[512];
    image all = image_new(o->width, o->height);
    bool whole = draw_splits(o, s, !path, &all);
    output_picture(o, &all, picture_name("12_kdtree.png", path, name), true, whole);
    image_free(&all);
}

/* The book's own scenes. */
static void measure(const options *o)
{
    trial_scene s;
    int width = o->quick ? 40 : o->full ? 160 : 80;
    trial_scene_of(teapot_mesh(o->quick ? 6 : o->full ? 32 : 8), &s);
    trial_rays(&s, trial_camera(&s.m, 1.6), width, width * 5 / 8, o->quick ? 50 : 1000, o->seed,
               &kdtree_trial, &kdtree_defaults);
    table_of_strategies(o, &s);
    if (o->full) table_of_planes(o), table_of_sizes(o);
    trial_scene_free(&s);
}

int main(int argc, char **argv)
{
    const char *path = NULL;
    const option own[] = {{"mesh", OPTION_INPUT, &path, 0, 0, "FILE.obj: draw this mesh, y up"},
                          {0}};
    options o = options_read(argc, argv, "12_kdtree", "k-d trees of triangle meshes.",
                             (options){.width = 640, .height = 400, .seed = 1}, own);
    failure f;
    trial_scene s;
    mesh m = {0};
    if (path && o.csv) die(2, "--csv: no table with --mesh");
    if (o.out && o.csv) die(2, "--out draws, --csv measures: one of them");
    if (path && !obj_read(path, &m, &f)) fail(f);
    trial_scene_of(path ? m : teapot_mesh(o.quick ? 6 : 32), &s);
    o.own = path != NULL;
    draw(&o, &s, path);
    trial_scene_free(&s);
    if (!o.own && !o.out) draw_figure(&o), draw_final(&o), measure(&o);
    return output_done(&o);
}
