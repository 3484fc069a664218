/* 24_direct_light: light straight from the lights, drawn by directions, by lights, and by both.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 24_direct_light chapters/24_direct_light/main.c -lm -lpthread
 * Without options: five pictures, six tables, four plots. --scene or --way: that picture only.
 * Errors are measured against closed forms, and where there are none against a long run with
 * well-spread points. */
#include "lab/measure.h"

static const char *const way_names[direct_ways] = {"uniform", "cosine", "brdf", "area", "angle",
                                                   "balance", "power", "half"};

/* The place of `text` in a list of n names; what is not there ends the program. */
static int place_of(const char *text, const char *const *name, int n, const char *of)
{
    failure f;
    char all[128] = "";
    for (int k = 0; k < n; k++) {
        if (strcmp(text, name[k]) == 0) return k;
        size_t end = strlen(all);
        snprintf(all + end, sizeof all - end, "%s%s", k ? ", " : "", name[k]);
    }
    failed(&f, 2, "--%s %.100s: allowed are %s", of, text, all);
    fail(f);
}

int main(int argc, char **argv)
{
    const char *scene_name = NULL, *way_name = NULL;
    char path[64];
    const option own[] = {
        {"scene", OPTION_TEXT, &scene_name, 0, 0, "draw only: box, plates, strip or hall"},
        {"way", OPTION_TEXT, &way_name, 0, 0,
         "by uniform, cosine, brdf, area, angle, balance, power or half"}, {0}};
    options o = options_read(argc, argv, "24_direct_light",
                             "Direct light by directions, by lights and by both.",
                             (options){.width = 420, .height = 420, .samples = 16, .seed = 1}, own);
    bool only = scene_name || way_name;
    if (o.quick && o.samples == 16) o.samples = 1;  /* what was asked for stays */
    if (only && o.csv) die(2, "--csv: no table with --scene, --way");
    direct_stage_name which = scene_name ? (direct_stage_name)place_of(scene_name, stage_names, stages, "scene")
                                  : STAGE_BOX;
    direct_way way = way_name ? (direct_way)place_of(way_name, way_names, direct_ways, "way")
                   : only ? DIRECT_POWER : DIRECT_ANGLE;
    if (only && !o.out) {
        snprintf(path, sizeof path, "build/24_direct_light_%s.png", stage_names[which]);
        mkdir("build", 0777);
        o.out = path;
    }
    draw_stage(&o, which, way);
    if (only) return 0;
    if (!o.out) draw_equal(&o), draw_plates(&o), draw_strip(&o), draw_hall(&o);
    measure_ways(&o);
    measure_lights(&o);
    measure_closed(&o);
    measure_near(&o);
    measure_called(&o);
    return output_done(&o);
}
