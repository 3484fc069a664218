/* 10_grid: a box cut into equal cells: built, walked through, and where it fails.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 10_grid chapters/10_grid/main.c -lm -lpthread
 *
 * Without options: the teapot in its cells, a walk in the plane, a stadium's work, a short table.
 * --full: all tables and plots. --mesh FILE.obj: that mesh instead, one picture. */
#include "../07_mesh/files/obj.h"
#include "lab/measure.h"
#include "lab/pictures.h"
#include "lab/walk_figure.h"

int main(int argc, char **argv)
{
    const char *path = NULL;
    grid_options how = grid_defaults;
    const option own[] = {
        {"density", OPTION_REAL, &how.density, 1e-3, 1e4, "cells a shape"},
        {"mesh", OPTION_INPUT, &path, 0, 0, "FILE.obj: draw this mesh, y up, and no table"}, {0}};
    options o = options_read(argc, argv, "10_grid", "A uniform grid: cells, walks, errors, time.",
                             (options){.width = 960, .height = 330, .seed = 1}, own);
    failure f;
    mesh m = {0};
    trial_scene s;
    if (path && o.csv) die(2, "--csv: no table with --mesh");
    if (path && !obj_read(path, &m, &f)) fail(f);
    trial_scene_of(path ? m : teapot_mesh(o.quick ? 4 : 16), &s);
    o.own = path != NULL;
    draw_grid(&o, &s, how, path);
    trial_scene_free(&s);
    if (path) return output_done(&o);
    bool only_tables = getenv("BENCH_ONCE") != NULL;  /* bench.h */
    if (!o.out && !only_tables) draw_walk(&o), draw_early(&o), draw_stadium(&o);
    measure_variants(&o);
    if (o.full && !only_tables) measure_density(&o);
    if (o.full) measure_drift(&o);
    return output_done(&o);
}
