/* 12_kdtree: space cut in two by planes across the axes, again and again: built, compared.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 12_kdtree chapters/12_kdtree/main.c -lm -lpthread
 *
 * Without options: what each pixel of the teapot took, by four strategies; the tree in the plane;
 * four tables, six plots. --mesh FILE.obj: the first picture of that mesh. --strategy NAME: that
 * tree alone, beside the mesh. */
#include "../07_mesh/files/obj.h"
#include "lab/flat.h"
#include "lab/growth.h"
#include "lab/pictures.h"
#include "lab/scenes.h"

typedef struct {
    const char *mesh, *strategy;
    int leaf, depth;
    double item_cost, bonus;
    bool boxes;
} own_options;

static kdtree_options build_options(const own_options *own)
{
    static const char *const name[kdtree_strategies] = {"middle", "median", "sah"};
    kdtree_options how = kdtree_defaults;
    how.leaf = own->leaf, how.depth = own->depth, how.clip = !own->boxes;
    how.item_cost = own->item_cost, how.empty_bonus = own->bonus;
    for (int k = 0; own->strategy; k++) {
        if (k == kdtree_strategies)
            die(2, "--strategy %s: allowed are middle, median, sah", own->strategy);
        how.strategy = (kdtree_strategy)k;
        if (strcmp(own->strategy, name[k]) == 0) break;
    }
    return how;
}

/* The mesh, and what its pixels take, side by side. */
static bool draw_one(const options *o, const mesh *m, kdtree_options how, bool z_up, image *all)
{
    items x = items_of_mesh(m);
    vec3 lo, hi;
    kdtree t;
    double start = clock_seconds();
    build_or_fail(&x, how, &t);
    double built = clock_seconds() - start;
    structure_stats s = kdtree_stats(&t);
    image im = image_new(o->width > 1 ? o->width / 2 : 1, o->height);
    mesh_bounds(m, &lo, &hi);
    picture p = {&t, m, camera_of(lo, hi, z_up, (real)im.width / (real)im.height), &im, 120};
    printf("# %zu triangles: built in %.3f s; %zu inner nodes, %zu leaves, %zu of them empty, "
           "%zu references, depth %d, %zu bytes\n", m->triangles, built, s.inner, s.leaves,
           s.empty, s.references, s.depth, s.bytes);
    bool whole = draw_mesh(p, o->threads);
    image_place(all, 0, 0, &im);
    whole = draw_visits(p, o->threads) && whole;
    image_place(all, im.width, 0, &im);
    image_free(&im);
    kdtree_free(&t);
    return whole;
}

static void draw(options *o, const own_options *own, kdtree_options how, const mesh *m)
{
    char name[512];
    image all = image_new(o->width, o->height);
    bool whole = own->strategy ? draw_one(o, m, how, !own->mesh, &all)
                               : draw_strategies(m, !own->mesh, o->threads, &all);
    output_picture(o, &all, picture_name("12_kdtree.png", own->mesh ? own->mesh : own->strategy, name),
                   true, whole);
    image_free(&all);
}

int main(int argc, char **argv)
{
    own_options own = {.leaf = kdtree_defaults.leaf, .item_cost = kdtree_defaults.item_cost,
                       .bonus = kdtree_defaults.empty_bonus};
    const option list[] = {
        {"mesh", OPTION_INPUT, &own.mesh, 0, 0, "FILE.obj: draw this mesh, y up"},
        {"strategy", OPTION_TEXT, &own.strategy, 0, 0,
         "middle, median or sah: that tree alone, beside the mesh"},
        {"leaf", OPTION_INT, &own.leaf, 1, 255, "with middle, median: most triangles in a leaf"},
        {"depth", OPTION_INT, &own.depth, 0, kdtree_most_depth, "of leaves; 0: 8 + 1.3 log2 n"},
        {"item-cost", OPTION_REAL, &own.item_cost, 1e-3, 1e3, "of a test; a step costs 1"},
        {"bonus", OPTION_REAL, &own.bonus, 0, 0.99, "for cutting off empty space"},
        {"boxes", OPTION_FLAG, &own.boxes, 0, 0, "cut the boxes of triangles, not triangles"}, {0}};
    options o = options_read(argc, argv, "12_kdtree", "k-d trees of triangle meshes.",
                             (options){.width = 640, .height = 400, .seed = 1}, list);
    kdtree_options how = build_options(&own);
    failure f;
    mesh m = {0};
    subject s;
    if ((own.mesh || own.strategy) && o.csv)
        die(2, "--csv: no table with --mesh, --strategy");
    if (o.out && o.csv) die(2, "--out draws, --csv measures: one of them");
    if (own.mesh && !obj_read(own.mesh, &m, &f)) fail(f);
    if (!own.mesh) m = teapot_mesh(o.quick ? 6 : 32);
    o.own = own.mesh || own.strategy;
    draw(&o, &own, how, &m);
    if (own.mesh || own.strategy || o.out) {
        mesh_free(&m);
        return output_done(&o);
    }
    draw_flat(&o);
    subject_init(&s, m, view_of_mesh(&m, 1.6), o.quick ? 40 : 160, o.quick ? 50 : 1000,
                 o.seed);
    table_of_strategies(&o, &s);
    table_of_planes(&o);
    table_of_stadium(&o);
    if (!o.quick) plots_of_cost(&o, &s), plot_of_bonus(&o, &s);
    growth(&o);
    subject_free(&s);
    return output_done(&o);
}
