/* 27_effects: a renderer for scene files that simulates only what the scene calls for.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 27_effects chapters/27_effects/main.c -lm -lpthread
 *
 *   27_effects room.scene --explain       a scene file, an OBJ or an NFF file: what it calls for
 *   27_effects room.scene --out room.png --camera "from 0 1 5 at 0 1 0"
 *   27_effects room.scene --effects all   everything at every hit: is it the same?
 *   27_effects room.scene --price         what each effect costs, and what leaving it out
 *
 * Without options: six scenes, each a line longer, and what they took; --full: scenes/demo.scene as
 * well, and the price list. With some the picture goes to build/, if --out names no other, and the
 * scene is the last of the six, if none is named. What the command line says of camera, lens,
 * lights and surroundings replaces what the files say; the words are those of scene files. What
 * being general costs: lab/tax.c. */
#include "lab/command.h"
#include "lab/explain.h"

int main(int argc, char **argv)
{
    request q = {.path = NULL};
    const option own[] = {
        {"mesh", OPTION_INPUT, &q.path, 0, 0, "to draw: .obj, .nff, else a scene file"},
        {"scene", OPTION_INPUT, &q.path, 0, 0, "the same"},
        {"effects", OPTION_TEXT, &q.effects, 0, 0, "LIST simulate: all, none, called, -soft .."},
        {"explain", OPTION_FLAG, &q.told, 0, 0, "say what the scene calls for, and why"},
        {"price", OPTION_FLAG, &q.priced, 0, 0, "leave out each effect in turn: time and error"},
        {"error", OPTION_REAL, &q.run.error, 1e-9, 1e9, "until the RMSE is no larger, in radiance"},
        {"time", OPTION_REAL, &q.run.seconds, 1e-3, 1e7, "the best picture in so many seconds"},
        {"save", OPTION_OUTPUT, &q.run.save, 0, 0, "keep the state here, after every pass"},
        {"resume", OPTION_TEXT, &q.run.resume, 0, 0, "FILE: go on from this state"},
        {"camera", OPTION_TEXT, &q.words.camera, 0, 0, "from X Y Z at X Y Z [up X Y Z] [angle A]"},
        {"lens", OPTION_TEXT, &q.words.lens, 0, 0, "radius X [focus X]"},
        {"light", OPTION_TEXT, &q.words.light, 0, 0, "at X Y Z colour C [; at ...]"},
        {"sun", OPTION_TEXT, &q.words.sun, 0, 0, "to X Y Z colour C [; to ...]"},
        {"environment", OPTION_TEXT, &q.words.environment, 0, 0, "C, C C, or a picture"},
        {"background", OPTION_TEXT, &q.words.background, 0, 0, "C"},
        {"indirect", OPTION_TEXT, &q.words.indirect, 0, 0, "on or off: light that walls pass on"},
        {"up", OPTION_TEXT, &q.words.up, 0, 0, "x, y or z: where no camera says it"},
        {0}};
    options o = options_read(argc, argv, "27_effects", "Draws scene files.",
                             (options){.width = 400, .height = 300, .samples = -1,
                                       .quick_width = 120, .quick_height = 90}, own);
    o.own = request_own(&q) || o.samples > 0;
    if (!o.out && !o.own && !(draw_six(&o, false) && (!o.full || draw_six(&o, true))))
        die(parallel_stopped(), "stopped");
    if (request_is_short(&o)) return output_done(&o);
    effects_ready r;
    failure f;
    request_read(&q, &o, &r.s);
    explain_warnings(stderr, &r.s);
    if (!effects_get_ready(&r, (real)o.width / (real)o.height, &f)) fail(f);
    unsigned mask = r.p.effects;
    if (q.effects && !effects_read(q.effects, &mask, &f)) fail(f);
    if (q.told) explain(stdout, &r.s, &r.p, &r.view);
    /* All of them: the estimator that knows no plan. */
    effects_stage_effects(&r.e, mask == EFFECTS_ALL ? (unsigned)EFFECTS_EVERYTHING : mask);
    request_show(&o, &q, &r.p, &r.e);
    effects_ready_free(&r);
    return output_done(&o);
}
