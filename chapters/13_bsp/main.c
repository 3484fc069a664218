/* 13_bsp: space cut by planes of any direction: rays front to back, the painter back to front.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 13_bsp chapters/13_bsp/main.c -lm -lpthread
 *
 * Without options: three pictures, four tables, two plots. --mesh FILE.obj: that mesh instead, its
 * cells and the work of each pixel, and one line about the tree that --rule built. */
#include "../07_mesh/files/obj.h"
#include "lab/flat_figure.h"
#include "lab/measure_scenes.h"
#include "lab/painting.h"
#include "lab/pictures.h"

typedef struct { const char *mesh, *rule; int candidates; } own_options;

static const char *const rule_names[bsp_rules] = {"random", "fewest", "axis", "own", "cost"};

static bsp_options build_options(const own_options *own)
{
    bsp_options how = bsp_defaults;
    int k = 0;
    while (k < bsp_rules && strcmp(own->rule, rule_names[k]) != 0) k++;
    if (k == bsp_rules)
        die(2, "--rule %s: allowed are random, fewest, axis, own, cost", own->rule);
    how.rule = (bsp_rule)k, how.candidates = own->candidates;
    return how;
}

/* Left: planes across the axes, right: `how`. The default mesh is finer in the tables. */
static void draw_cells(options *o, const own_options *own, const mesh *m, bsp_options how)
{
    vec3 lo, hi;
    char name[512];
    image im = image_new(o->width, o->height);
    if (!mesh_bounds(m, &lo, &hi)) lo = hi = (vec3){0, 0, 0};
    if (vzero(vsub(hi, lo)))  /* a point: something to look at all the same */
        lo = vsub(lo, (vec3){1, 1, 1}), hi = vadd(hi, (vec3){1, 1, 1});
    bool whole = draw_trees(m, lo, hi, !own->mesh, how, o->threads, &im);
    output_picture(o, &im, picture_name("13_bsp.png", own->mesh, name), true, whole);
    image_free(&im);
}

static void tell(const mesh *m, bsp_options how)
{
    items x = items_of_mesh(m);
    failure f;
    bsp b;
    double start = clock_seconds();
    if (!bsp_build(&x, how, &b, &f)) fail(f);
    structure_stats s = bsp_stats(&b);
    printf("# %zu triangles: built in %.3f s; %zu planes, %zu of them slanted; depth %d; "
           "%.2f names a triangle; %zu bytes\n", m->triangles, clock_seconds() - start, s.inner,
           b.normals, s.depth, per((double)s.references, s.items), s.bytes);
    bsp_free(&b);
}

static void draw_painter(const options *o)
{
    int k = o->quick ? 4 : 1;
    image flat = image_new(836 / k, 414 / k), cyclic = image_new(848 / k, 280 / k);
    bool whole = draw_flat(o->threads, &flat);
    output_picture(o, &flat, "13_bsp_flat.png", false, whole);
    draw_cyclic(&cyclic);
    output_picture(o, &cyclic, "13_bsp_painter.png", false, true);
    image_free(&flat), image_free(&cyclic);
}

int main(int argc, char **argv)
{
    own_options own = {.rule = "cost", .candidates = bsp_defaults.candidates};
    const option list[] = {
        {"mesh", OPTION_INPUT, &own.mesh, 0, 0, "FILE.obj: the cells of this mesh instead, y up"},
        {"rule", OPTION_TEXT, &own.rule, 0, 0, "random, fewest, axis, own or cost: right panels"},
        {"candidates", OPTION_INT, &own.candidates, 1, 10000, "slanted planes tried for a cell"},
        {0}};
    options o = options_read(argc, argv, "13_bsp", "BSP trees: for rays, and for the painter.",
                             (options){.width = 960, .height = 600, .seed = 1}, list);
    bsp_options how = build_options(&own);
    failure f;
    mesh m = {0};
    if (own.mesh && o.csv) die(2, "--csv: no table with --mesh");
    if (o.out && o.csv) die(2, "--out draws, --csv measures: one of them");
    if (own.mesh && !obj_read(own.mesh, &m, &f)) fail(f);
    if (!own.mesh) m = teapot_mesh(o.quick ? 4 : 12);
    o.own = own.mesh != NULL;
    draw_cells(&o, &own, &m, how);
    if (own.mesh) tell(&m, how);
    mesh_free(&m);
    if (own.mesh || o.out) return output_done(&o);
    draw_painter(&o);
    m = teapot_mesh(o.quick ? 3 : 14);
    table_of_rules(&o, &m);
    table_of_scenes(&o);
    table_of_losses(&o);
    table_of_pieces(&o);
    mesh_free(&m);
    return output_done(&o);
}
