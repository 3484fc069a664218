/* 24_direct_light: light straight from the lights, drawn by directions, by lights, and by both.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 24_direct_light chapters/24_direct_light/main.c -lm -lpthread
 * Without options: a picture, a drawing, the main table. --full: four pictures, six tables, three
 * plots.
 * --scene or --way: that picture only. Errors are measured against a long run with well-spread
 * points, which a test compares with closed forms. */
#include "lab/measure.h"
#include "lab/point_lights.h"
#include "lab/ways_figure.h"

static const char *const way_names[direct_ways] = {"uniform", "cosine", "brdf", "area", "angle",
                                                   "balance", "power", "half"};

/* The place of `text` in a list of n names; what is not there ends the program. */
static int place_of(const char *text, const char *const *name, int n, const char *of)
{
    char all[128] = "";
    for (int k = 0; k < n; k++) {
        if (strcmp(text, name[k]) == 0) return k;
        size_t end = strlen(all);
        snprintf(all + end, sizeof all - end, "%s%s", k ? ", " : "", name[k]);
    }
    die(2, "--%s %.100s: allowed are %s", of, text, all);
}

int main(int argc, char **argv)
{
    const char *scene_name = NULL, *way_name = NULL;
    char file[64] = "24_direct_light.png";
    const option own[] = {
        {"scene", OPTION_TEXT, &scene_name, 0, 0, "draw only: box, plates, strip or first"},
        {"way", OPTION_TEXT, &way_name, 0, 0,
         "by uniform, cosine, brdf, area, angle, balance, power or half"}, {0}};
    options o = options_read(argc, argv, "24_direct_light",
                             "Direct light by directions, by lights and by both.",
                             (options){.width = 640, .height = 640, .samples = 16, .seed = 1}, own);
    o.own = scene_name || way_name;
    if (o.quick && o.samples == 16) o.samples = 1;  /* what was asked for stays */
    if (o.own && o.csv) die(2, "--csv: no table with --scene, --way");
    direct_stage_name which = STAGE_BOX;
    if (scene_name)
        which = (direct_stage_name)place_of(scene_name, stage_names, stages, "scene");
    direct_way way = way_name ? (direct_way)place_of(way_name, way_names, direct_ways, "way")
                   : o.own ? DIRECT_POWER : DIRECT_ANGLE;
    if (o.own) snprintf(file, sizeof file, "24_direct_light_%s.png", stage_names[which]);
    draw_stage(&o, which, way, file);
    if (o.own) return output_done(&o);
    if (!o.out) draw_ways(&o);
    measure_ways(&o);
    if (o.full) {
        if (!o.out) draw_points(&o);
        measure_points(&o);
        if (!o.out) draw_exhibit(&o, &exhibit_plates), draw_exhibit(&o, &exhibit_strip);
        measure_near(&o);
        measure_called(&o);
    }
    return output_done(&o);
}
