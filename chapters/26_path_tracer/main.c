/* 26_path_tracer: the whole: light sampling, BRDF sampling, roulette, glass; states that add up.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 26_path_tracer chapters/26_path_tracer/main.c -lm -lpthread
 * Without options: the box, a drawing, error and time of every strategy; --full: all pictures, the
 * ideas one by one among them, and tables. With a model, --scene, --samples, --error, --time: one
 * picture. Errors are measured against a reference of many samples, which a test compares with the
 * naive path of 25. */
#include "lab/command.h"
#include "lab/measure.h"
#include "lab/pictures.h"
#include "lab/pixel.h"

int main(int argc, char **argv)
{
    command c = {.scene = NULL};
    const char *pixel = NULL;
    options defaults = {.width = 640, .height = 640, .samples = -1, .seed = 1,
                        .quick_width = 160, .quick_height = 160};
    option own[] = {
        {"scene", OPTION_TEXT, &c.scene, 0, 0, showcase_names},
        {"mesh", OPTION_INPUT, &c.obj, 0, 0, "OBJ, by Kd, Ke of its MTL, on a floor, under a sky"},
        {"up", OPTION_TEXT, &c.up, 0, 0, "of it: y (default) or z points up"},
        {"environment", OPTION_INPUT, &c.sky, 0, 0, "PFM or PPM: light all round"},
        {"error", OPTION_REAL, &c.run.error, 1e-9, 1e9, "until the RMSE is no larger, in radiance"},
        {"time", OPTION_REAL, &c.run.seconds, 1e-3, 1e7, "the best picture in so many seconds"},
        {"save", OPTION_OUTPUT, &c.run.save, 0, 0, "keep the state here, after every pass"},
        {"resume", OPTION_TEXT, &c.run.resume, 0, 0, "FILE: go on from this state"},
        {"range", OPTION_TEXT, &c.range, 0, 0, "A:B, samples A to B - 1 only, for --merge"},
        {"merge", OPTION_TEXT, &c.merge, 0, 0, "FILE FILE ...: the picture of all these states"},
        {"clamp", OPTION_REAL, &c.clamp, 0, 1e9, "cut brighter samples: darkens; default not"},
        {"pixel", OPTION_TEXT, &pixel, 0, 0, "X,Y: its first path, hit by hit, in words and drawn"},
        {0}};
    argc = command_merge(argc, argv, &c);
    options o = options_read(argc, argv, "26_path_tracer", "A path tracer.", defaults, own);
    if (pixel) {
        const char *name = c.scene ? c.scene : "cornell";
        c.scene = NULL, o.own = true;
        if (command_given(&c, &o) || o.out || o.csv)
            die(2, "--pixel goes with --scene, --size and --seed alone");
        path_explain(&o, name, pixel);
        return output_done(&o);
    }
    if (command_given(&c, &o)) {
        o.own = true;
        command_run(&c, &o);
        return output_done(&o);
    }
    draw_scene(&o, "cornell", o.width, o.height, 16, 2, "26_path_tracer.png", true);
    if (!o.out) draw_vertices(&o);
    if (!o.out && o.full) {
        if (!getenv("BENCH_ONCE"))  /* bench.h: the tables are all that is asked for */
            draw_scene(&o, "rough", 720, 250, 128, 1, "26_path_tracer_rough.png", false);
        draw_strategies(&o), draw_light(&o), draw_ladder(&o);
    }
    measure_strategies(&o);
    return output_done(&o);
}
