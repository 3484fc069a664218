/* 17_compare: every structure on the same scenes and the same rays: first the same hits, then time.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 17_compare chapters/17_compare/main.c -lm -lpthread
 *
 * Without options: three pictures, four small scenes in one table. --full: all scenes, four kinds
 * of rays, a table each; growth with n; a chart, plots. --scene, --mesh: these scenes. --sweep: one
 * option from end to end. --verify: all rays by brute force, too. --report: in one HTML file.
 * --rays: those of a file. --protocol spd: the published counts. */
#include "lab/run.h"

int main(int argc, char **argv)
{
    compare_options own = {.scale = -1, .megabytes = 2048};
    const option list[] = {
        {"mesh", OPTION_INPUT, own.mesh, most_meshes, most_meshes,
         "FILE.obj or .nff, several: these, and not the scenes of the book"},
        {"up", OPTION_TEXT, &own.up, 0, 0, "y (default) or z points up in an OBJ file"},
        {"from", OPTION_TEXT, &own.from, 0, 0, "X,Y,Z: the eye, for --mesh"},
        {"at", OPTION_TEXT, &own.at, 0, 0, "X,Y,Z: where it looks"},
        {"angle", OPTION_REAL, &own.angle, 1e-3, 179, "of the view, degrees"},
        {"scene", OPTION_TEXT, &own.scene, 0, 0,
         "balls gears mount rings teapot tetra tree stadium soup needles or solids, alone"},
        {"scale", OPTION_INT, &own.scale, 0, 10000, "its size: what each allows is in MEASURED.md"},
        {"only", OPTION_TEXT, &own.only, 0, 0,
         "these structures, with options: bvh:leaf=8,kdtree:rule=median"},
        {"sweep", OPTION_TEXT, &own.sweep, 0, 0,
         "bvh:leaf=1..32: building against searching, among all structures"},
        {"report", OPTION_OUTPUT, &own.report, 0, 0, "all of it in one HTML file"},
        {"verify", OPTION_FLAG, &own.verify, 0, 0,
         "all rays by brute force, too; explain what differs"},
        {"rays", OPTION_INPUT, &own.files.rays, 0, 0,
         "FILE of rays: ox oy oz tmin dx dy dz tmax, float32"},
        {"any-hit", OPTION_FLAG, &own.files.any, 0, 0, "with --rays: is there any hit at all?"},
        {"hits", OPTION_OUTPUT, &own.files.hits, 0, 0, "with --rays: their t and shape go here"},
        {"costs", OPTION_OUTPUT, &own.files.costs, 0, 0,
         "with --rays: a CSV of each ray's hit, steps and tests"},
        {"torture", OPTION_TEXT, &own.torture, 0, 0,
         "FOLDER: rays with exact answers go there, and all structures answer"},
        {"score", OPTION_TEXT, &own.score, 0, 0,
         "NAME: with --torture: judges FOLDER/CLASS.NAME.hits of another renderer"},
        {"protocol", OPTION_TEXT, &own.protocol, 0, 0, "spd: counts as they were published"},
        {"regimes", OPTION_FLAG, &own.regimes, 0, 0,
         "order of rays, all cores, meshes that move: frames against rays"},
        {"orders", OPTION_FLAG, &own.orders, 0, 0, "pictures by a rasteriser (08) or by rays"},
        {"memory", OPTION_INT, &own.megabytes, 1, 1 << 20,
         "MB that all structures may hold together"},
        {0}};
    options o = options_read(argc, argv, "17_compare",
                             "Every structure on the same scenes and the same rays.",
                             (options){.width = 1000, .height = 332, .seed = 1}, list);
    compare_settings c = {&o, own.sweep ? swept_of(own.sweep) : chosen_of(own.only),
                          (size_t)own.megabytes << 20, NULL};
    const generator *g = own.scene ? scene_find(own.scene) : NULL;
    check_options(&o, &own);
    o.own = own.mesh[0] != NULL;
    c.to = html_begin(&o, own.report, "17 compare: acceleration structures, side by side");
    if (own.torture) torture_run(&c, own.torture, own.score);
    else if (own.protocol) protocol_run(c, own.only, g, own.scale);
    else if (own.orders) orders_run(&c);
    else compare_run(&c, &own);
    html_end(c.to);
    return output_done(&o);
}
