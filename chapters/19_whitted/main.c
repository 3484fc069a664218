/* 19_whitted: recursion: mirrors, glass, total reflection, Fresnel, absorption, nested bodies.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 19_whitted chapters/19_whitted/main.c -lm -lpthread
 *
 * Without options: the two spheres of 1980, drawings, the tree of one pixel, a table of error
 * against time. --full: a tank, too. --protocol spd: rays counted as in published results.
 * --samples N is rounded down to a square. */
#include "lab/figures.h"
#include "lab/measure.h"
#include "lab/pictures.h"
#include "lab/povray.h"
#include "lab/ray_tree.h"
#include "lab/spd_protocol.h"

int main(int argc, char **argv)
{
    const char *how = NULL, *name = NULL, *pov = NULL, *pixel = NULL;
    int scale = -1;
    bool all = false;
    const option own[] = {
        {"protocol", OPTION_TEXT, &how, 0, 0, "spd: count rays as the published results do"},
        {"scene", OPTION_TEXT, &name, 0, 0,
         "with --protocol: balls gears mount rings teapot tetra or tree"},
        {"scale", OPTION_INT, &scale, 0, 100, "with --protocol: its size"},
        {"pixel", OPTION_TEXT, &pixel, 0, 0, "X,Y: its tree of rays, in words and drawn"},
        {"povray", OPTION_TEXT, &pov, 0, 0,
         "writes the forty balls for POV-Ray, and times them here, one thread"},
        {"spend-all", OPTION_FLAG, &all, 0, 0, "trace what cannot contribute, too"}, {0}};
    options o = {.width = 640, .height = 480, .seed = 1, .samples = 4,
                 .quick_width = 160, .quick_height = 120, .quick_samples = 1};
    o = options_read(argc, argv, "19_whitted", "Whitted's ray tracing.", o, own);
    const struct { bool wrong; const char *text; } misuse[] = {
        {how && strcmp(how, "spd") != 0, "--protocol: allowed is spd"},
        {!how && (name || scale >= 0), "--scene, --scale: allowed with --protocol spd"},
        {pixel && (how || pov || all || o.out || o.csv), "--pixel goes with --size alone"},
        {pov && (how || all || o.out || o.csv), "--povray: allowed alone"},
        {how && (o.csv || o.out || all),
         "--csv, --out, --spend-all: not allowed with --protocol"},
        {o.out && o.csv, "--out draws, --csv measures: one of them"}};
    for (size_t i = 0; i < sizeof misuse / sizeof *misuse; i++)
        if (misuse[i].wrong) die(2, "%s", misuse[i].text);
    o.own = how || pixel || pov;
    if (how) spd_protocol(&o, name, scale);
    if (pov) povray_race(pov);
    if (pixel) whitted_explain(&o, pixel);
    if (o.own) return output_done(&o);
    draw_two_spheres(&o, all);
    if (o.out) return output_done(&o);
    if (o.full || o.quick) draw_tank(&o);
    whitted_explain(&o, NULL);
    draw_wavefronts(&o);
    draw_critical(&o);
    table_of_depths(&o);
    return output_done(&o);
}
