/* 16_instances: a forest of two firs, an oak, two birches, many times; normals that stay right.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 16_instances chapters/16_instances/main.c -lm -lpthread
 *
 * Without options: the forest, a drawing of both levels, a table of methods. --full: what goes
 * wrong with normals and with normalised rays; growth. --instances N: so many plants, no table.
 * --mesh FILE.obj: a crowd of that mesh, y up, the picture only. */
#include "../07_mesh/files/obj.h"
#include "lab/measure.h"
#include "lab/pictures.h"
#include "lab/two_levels.h"

int main(int argc, char **argv)
{
    int plants = 0;
    const char *path = NULL;
    const option list[] = {
        {"instances", OPTION_INT, &plants, 1, 1000000, "plants in the picture; 9000 if not given"},
        {"mesh", OPTION_INPUT, &path, 0, 0,
         "FILE.obj: a crowd of this mesh, y up, instead of plants"},
        {0}};
    options o = options_read(argc, argv, "16_instances",
                             "Instances: one mesh in many places, a tree of two levels.",
                             (options){.width = 640, .height = 400, .seed = 1}, list);
    failure f;
    plant own = {.wood = 0};
    mesh m = {0};
    bool own_picture = plants || path, picture_only = own_picture || o.out;
    if (own_picture && o.csv)
        die(2, "--csv: no table with --instances, --mesh");
    if (o.out && o.csv) die(2, "--out draws, --csv measures: one of them");
    if (path && !obj_read(path, &m, &f)) fail(f);
    if (path) own = plant_of_mesh(m);
    o.own = own_picture;
    if (!plants) plants = o.quick ? 300 : 9000;
    draw_forest(&o, (size_t)plants, path ? &own : NULL);
    if (picture_only) return output_done(&o);
    draw_two_levels(&o);
    table_of_methods(&o);
    if (o.full) draw_unit(&o), draw_normals(&o), table_of_growth(&o);
    return output_done(&o);
}
