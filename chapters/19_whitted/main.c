/* 19_whitted: recursion: mirrors, glass, total reflection, Fresnel, absorption, nested bodies.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 19_whitted chapters/19_whitted/main.c -lm -lpthread
 *
 * Without options: the two spheres of 1980, a tank, four depths, the tree of one pixel, tables of
 * error against time, of Fresnel's forms, of speed. --protocol spd: rays counted as in published
 * results. --samples N is rounded down to a square. */
#include "../../common/output.h"
#include "lab/spd_protocol.h"
#include "lab/measure.h"
#include "lab/pictures.h"

static void usage(const char *text)
{
    die(2, "%s", text);
}

/* --scene, or all of them with published results; --scale, or the usual. */
static void protocol(const options *o, const char *name, int scale)
{
    if (name && !generator_find(spd_list, spd_scenes, name))
        usage("--scene: allowed are balls, gears, mount, rings, teapot, tetra, tree");
    for (int k = 0; k < spd_scenes; k++) {
        const generator *g = &spd_list[k];
        int edge = o->quick ? 32 : spd_edge, size = scale >= 0 ? scale : g->scale;
        world w;
        failure f;
        spd_count c;
        if (name ? strcmp(name, g->name) != 0 : !g->hits) continue;
        if (!spd_world(g->name, size, &w, &f) || !spd_print_digits(&w, &f)) fail(f);
        image im = image_new(edge + 1, edge + 1);
        double start = clock_seconds();
        bool whole = spd_count_scene(&w, edge, o->threads, im.rgb, &c);
        spd_print(&w, size, &c, clock_seconds() - start);
        if (g->hits && size == g->scale && edge == spd_edge)
            printf("# published primary hits for %s %d: %zu\n", g->name, size, g->hits);
        fflush(stdout);
        if (o->out) output_picture(o, &im, "19_whitted_spd.png", true, whole);
        image_free(&im);
        world_free(&w);
        if (!whole) die(130, "stopped");
    }
}

int main(int argc, char **argv)
{
    const char *how = NULL, *name = NULL;
    int scale = -1, pixel[2] = {0, 0};
    bool all = false;
    const option own[] = {
        {"protocol", OPTION_TEXT, &how, 0, 0, "spd: count rays as the published results do"},
        {"scene", OPTION_TEXT, &name, 0, 0,
         "with --protocol: balls gears mount rings teapot tetra or tree"},
        {"scale", OPTION_INT, &scale, 0, 100, "with --protocol: its size"},
        {"tree", OPTION_SIZE, pixel, 1, 639, "XxY: the tree of rays of this pixel of 640x480"},
        {"spend-all", OPTION_FLAG, &all, 0, 0, "trace what cannot contribute, too"}, {0}};
    options o = options_read(argc, argv, "19_whitted", "Whitted's ray tracing.",
                             (options){.width = 640, .height = 480, .seed = 1, .samples = 9}, own);
    if (how && strcmp(how, "spd") != 0) usage("--protocol: allowed is spd");
    if (!how && (name || scale >= 0)) usage("--scene, --scale: allowed with --protocol spd");
    if (how && pixel[0]) usage("--tree: not allowed with --protocol");
    if (pixel[1] > 479) usage("--tree: allowed are columns from 1 to 639, rows from 1 to 479");
    if (pixel[0] && o.out) usage("--out: not allowed with --tree");
    if ((how || pixel[0]) && o.csv) usage("--csv: not allowed with --protocol, --tree");
    if ((how || pixel[0]) && all) usage("--spend-all: not allowed with --protocol, --tree");
    if (o.out && o.csv) usage("--out draws, --csv measures: one of them");
    if (how) {
        protocol(&o, name, scale);
        return 0;
    }
    if (pixel[0]) {
        draw_ray_tree(&o, (real)pixel[0] + (real)0.5, (real)pixel[1] + (real)0.5);
        return 0;
    }
    if (o.quick && o.samples == 9) o.samples = 1;
    if (o.quick && o.width == 640 && o.height == 480) o.width = 160, o.height = 120;
    draw_two_spheres(&o, all);
    if (o.out) return 0;
    draw_tank(&o);
    draw_depths(&o);
    draw_ray_tree(&o, 345.5, 140.5);
    table_of_knobs(&o);
    table_of_fresnel(&o);
    table_of_speed(&o);
    table_of_first(&o);
    return output_done(&o);
}
