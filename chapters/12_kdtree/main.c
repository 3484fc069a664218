/* 12_kdtree: space cut in two by planes across the axes, again and again: built, compared.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 12_kdtree chapters/12_kdtree/main.c -lm -lpthread
 *
 * Without options: what each pixel of the teapot took, by four rules; the tree in the plane; a
 * short table. --full: all tables and plots. --mesh FILE.obj: the first picture of that mesh.
 * --strategy NAME: that tree alone, beside the mesh. */
#include "../07_mesh/files/obj.h"
#include "lab/figure.h"
#include "lab/measure.h"
#include "lab/pictures.h"

typedef struct { const char *mesh, *strategy; kdtree_options how; } own_options;

static void choose_strategy(own_options *own)
{
    static const char *const name[kdtree_strategies] = {"middle", "median", "sah"};
    int k = 0;
    if (!own->strategy) return;
    while (k < kdtree_strategies && strcmp(own->strategy, name[k]) != 0) k++;
    if (k == kdtree_strategies)
        die(2, "--strategy %s: allowed are middle, median, sah", own->strategy);
    own->how.strategy = (kdtree_strategy)k;
}

static void draw(const options *o, const own_options *own, const trial_scene *s)
{
    char name[512];
    image all = image_new(o->width, o->height);
    bool whole = own->strategy ? draw_one(o, &s->m, own->how, !own->mesh, &all)
                               : draw_strategies(o, s, !own->mesh, &all);
    const char *model = own->mesh ? own->mesh : own->strategy;
    output_picture(o, &all, picture_name("12_kdtree.png", model, name), true, whole);
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
    if (o->full)
        table_of_planes(o), kdtree_grow(o);
    trial_scene_free(&s);
}

int main(int argc, char **argv)
{
    own_options own = {.how = kdtree_defaults};
    const option list[] = {
        {"mesh", OPTION_INPUT, &own.mesh, 0, 0, "FILE.obj: draw this mesh, y up"},
        {"strategy", OPTION_TEXT, &own.strategy, 0, 0,
         "middle, median or sah: that tree alone, beside the mesh"},
        {"leaf", OPTION_INT, &own.how.leaf, 0, 255, "most items in a leaf; 0: by cost (sah)"},
        {"depth", OPTION_INT, &own.how.depth, 0, kdtree_most_depth,
         "of leaves; 0: 8 + 1.3 log2 n"},
        {0}};
    options o = options_read(argc, argv, "12_kdtree", "k-d trees of triangle meshes.",
                             (options){.width = 640, .height = 400, .seed = 1}, list);
    failure f;
    trial_scene s;
    mesh m = {0};
    choose_strategy(&own);
    if ((own.mesh || own.strategy) && o.csv) die(2, "--csv: no table with --mesh, --strategy");
    if (o.out && o.csv) die(2, "--out draws, --csv measures: one of them");
    if (own.mesh && !obj_read(own.mesh, &m, &f)) fail(f);
    trial_scene_of(own.mesh ? m : teapot_mesh(o.quick ? 6 : 32), &s);
    o.own = own.mesh || own.strategy;
    draw(&o, &own, &s);
    trial_scene_free(&s);
    if (!o.own && !o.out) draw_figure(&o), draw_final(&o), measure(&o);
    return output_done(&o);
}
