/* 13_bsp: space cut by planes of any direction: rays front to back, the painter back to front.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 13_bsp chapters/13_bsp/main.c -lm -lpthread
 *
 * Without options: three pictures, a short table. --full: all tables and plots. FILE.obj: that
 * mesh instead, its cells and the work of each pixel, and one line about the tree of --rule. */
#include "../07_mesh/files/obj.h"
#include "lab/strip.h"
#include "lab/measure.h"
#include "lab/painting.h"
#include "lab/pictures.h"

static bsp_options build_options(const char *rule, int candidates)
{
    static const char *const name[bsp_rules] = {"random", "fewest", "axis", "own", "cost"};
    bsp_options how = bsp_defaults;
    int k = 0;
    while (k < bsp_rules && strcmp(rule, name[k]) != 0) k++;
    if (k == bsp_rules) die(2, "--rule %s: allowed are random, fewest, axis, own, cost", rule);
    how.rule = (bsp_rule)k, how.candidates = candidates;
    return how;
}

/* One line about the tree of a reader's mesh. */
static void tell(const trial_scene *s, bsp_options how)
{
    trial_row r = {.verbs = &bsp_trial, .how = &how};
    trial_time_build(&r, s, 1);
    structure_stats st = bsp_stats(r.built);
    printf("# %zu triangles: built in %.3f s; %zu planes, %zu of them slanted; depth %d; "
           "%.2f references a triangle; %zu bytes\n", s->m.triangles, r.build, st.inner,
           ((bsp *)r.built)->normals, st.depth, trial_per((double)st.references, st.items),
           st.bytes);
    trial_unbuild(&r);
}

int main(int argc, char **argv)
{
    const char *path = NULL, *rule = "cost";
    int candidates = bsp_defaults.candidates;
    char name[512];
    const option list[] = {
        {"mesh", OPTION_INPUT, &path, 0, 0, "FILE.obj: the cells of this mesh instead, y up"},
        {"rule", OPTION_TEXT, &rule, 0, 0, "random, fewest, axis, own or cost: right panels"},
        {"candidates", OPTION_INT, &candidates, 1, 10000, "slanted planes tried for a cell"}, {0}};
    options o = options_read(argc, argv, "13_bsp", "BSP trees: for rays, and for the painter.",
                             (options){.width = 960, .height = 600, .seed = 1}, list);
    bsp_options how = build_options(rule, candidates);
    failure f;
    trial_scene s;
    mesh m = {0};
    if (path && o.csv) die(2, "--csv: no table with --mesh");
    if (o.out && o.csv) die(2, "--out draws, --csv measures: one of them");
    if (path && !obj_read(path, &m, &f)) fail(f);
    trial_scene_of(path ? m : teapot_mesh(o.quick ? 4 : 12), &s);
    o.own = path != NULL;
    image im = image_new(o.width, o.height);
    bool whole = draw_trees(&s, !path, how, o.threads, &im);
    output_picture(&o, &im, picture_name("13_bsp.png", path, name), true, whole);
    if (path) tell(&s, how);
    image_free(&im), trial_scene_free(&s);
    if (o.own || o.out) return output_done(&o);
    draw_strip(&o), draw_cyclic(&o);
    table_of_rules(&o);
    if (o.full) table_of_scenes(&o), table_of_losses(&o), table_of_pieces(&o);
    return output_done(&o);
}
