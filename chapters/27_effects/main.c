/* 27_effects: a renderer for scene files that simulates only what the scene calls for.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 27_effects chapters/27_effects/main.c -lm -lpthread
 *
 *   27_effects room.scene --explain       a scene file, an OBJ or an NFF file: what it calls for
 *   27_effects --scene room.scene --out room.png --camera "from 0 1 5 at 0 1 0"
 *   27_effects room.scene --effects all   everything at every hit: the same picture, more time
 *   27_effects room.scene --price         what each effect costs, and what leaving it out
 *   27_effects room.scene --price --region 80x60+160+120     for these pixels, at (160, 120)
 *
 * Without options: the scene of demo.h. With some the picture goes to build/27_effects_render.png,
 * if --out names no other. What the command line says of camera, lens, lights and surroundings
 * replaces what the files say; the words are those of scene files. */
#include "../../common/output.h"
#include "lab/classic.h"
#include "lab/demo.h"
#include "lab/explain.h"
#include "lab/price.h"
#include "files/studio_read.h"

typedef struct {
    const char *path, *effects, *region;
    bool told, priced;
    studio_words words;
} request;

static bool request_own(const request *q)
{
    const studio_words *w = &q->words;
    return q->path || q->effects || q->region || q->told || q->priced || w->camera || w->lens
        || w->light || w->sun || w->environment || w->background || w->up;
}

static draw_window window_of(const options *o, const char *said)
{
    draw_window w = {0, 0, o->width, o->height, o->width, o->height};
    int end = 0;
    failure f;
    if (!said) return w;
    if (sscanf(said, "%5dx%5d+%5d+%5d%n", &w.width, &w.height, &w.x, &w.y, &end) == 4
        && !said[end] && w.width > 0 && w.height > 0 && w.x >= 0 && w.y >= 0
        && w.width <= w.across - w.x && w.height <= w.down - w.y) return w;
    failed(&f, 2, "--region %.60s: WxH+X+Y, within the %dx%d pixels of --size", said, o->width,
           o->height);
    fail(f);
}

/* Of the whole picture the price list takes a quarter in width and height. */
static draw_window window_to_price(draw_window w, const request *q)
{
    int across = w.across / 4 > 0 ? w.across / 4 : 1, down = w.down / 4 > 0 ? w.down / 4 : 1;
    return q->region ? w : (draw_window){0, 0, across, down, across, down};
}

/* All at every hit was drawn: what the plan draws, and whether that is the same picture. False:
 * stopped. */
static bool compare_with_plan(drawing *j, effects_stage *e, int threads)
{
    image im = image_new(j->im->width, j->im->height);
    drawing plain = *j;
    size_t n = 3 * (size_t)im.width * (size_t)im.height;
    effects_stage_effects(e, e->p->effects, false);
    bool whole = draw_region(&plain, &im, j->x0, j->y0, threads);
    if (whole) {
        bool same = memcmp(im.rgb, j->im->rgb, n * sizeof *im.rgb) == 0;
        printf("plan       %s; everything at every hit took %.3g s, the plan %.3g s: "
               "%.0f %% saved\n",
               same ? "the same picture byte for byte" : "ANOTHER PICTURE", j->seconds,
               plain.seconds, (1 - plain.seconds / j->seconds) * 100);
    }
    effects_stage_effects(e, EFFECTS_ALL, true);
    image_free(&im);
    return whole;
}

/* The default run: the picture, its strip, the price list, and what being general costs. The
 * picture is saved before all else: Ctrl-C later on loses none of it. */
static void show(const options *o, const request *q, effects_stage *e)
{
    draw_window w = window_of(o, q->region);
    image im = image_new(w.width, w.height);
    bool demo = !o->out && !o->own;
    int samples = o->samples > 0 ? o->samples : !e->chance ? 4 : o->quick ? 2 : demo ? 32 : 16;
    drawing j = {.e = e, .samples = samples, .seed = o->seed, .width = o->width,
                 .height = o->height};
    bool whole = draw_region(&j, &im, w.x, w.y, o->threads);
    output_picture(o, &im, "27_effects.png", true, whole);
    if (e->mask & EFFECTS_SPEND) whole = compare_with_plan(&j, e, o->threads);
    if (whole && (demo || q->priced)) {
        whole = table_of_price(o, e, window_to_price(w, q), samples > 16 ? 16 : samples);
        if (whole && demo) whole = draw_strip(o, e, o->width * 2 / 5 + 1, o->height * 2 / 5 + 1,
                                              samples);
        if (whole && demo) whole = table_of_tax(o);
    } else if (whole) {
        effects_counts timed;
        image none = image_new(w.width, w.height);  /* draw_timed fills nothing in */
        double error = draw_error(&j);
        drawing again = j;
        again.im = &none;
        whole = draw_timed(&again, o->threads, &timed);
        if (whole) {
            table_of_effects(o, &j, &timed);
            printf("# %d samples a pixel, %.3g s", samples, j.seconds);
            if (error > 0 && samples > 1) printf(", error rmse %.3g by halves", error);
            printf("\n");
        }
        image_free(&none);
    }
    image_free(&im);
    if (!whole) die(130, "stopped; the picture was whole before");
}

int main(int argc, char **argv)
{
    request q = {.path = NULL};
    const option own[] = {
        {"scene", OPTION_INPUT, &q.path, 0, 0, "FILE to draw: .obj, .nff, else a scene file"},
        {"effects", OPTION_TEXT, &q.effects, 0, 0, "LIST simulate: all, none, called, -soft .."},
        {"explain", OPTION_FLAG, &q.told, 0, 0, "say what the scene calls for, and why"},
        {"price", OPTION_FLAG, &q.priced, 0, 0, "leave out each effect in turn: time and error"},
        {"region", OPTION_TEXT, &q.region, 0, 0, "WxH+X+Y: of the picture these pixels only"},
        {"camera", OPTION_TEXT, &q.words.camera, 0, 0, "from X Y Z at X Y Z [up X Y Z] [angle A]"},
        {"lens", OPTION_TEXT, &q.words.lens, 0, 0, "radius X [focus X]"},
        {"light", OPTION_TEXT, &q.words.light, 0, 0, "at X Y Z colour C [; at ...]"},
        {"sun", OPTION_TEXT, &q.words.sun, 0, 0, "to X Y Z colour C [; to ...]"},
        {"environment", OPTION_TEXT, &q.words.environment, 0, 0, "C, C C, or a picture"},
        {"background", OPTION_TEXT, &q.words.background, 0, 0, "C"},
        {"up", OPTION_TEXT, &q.words.up, 0, 0, "x, y or z: where no camera says it"},
        {0}};
    options o = options_read(argc, argv, "27_effects", "Draws scene files.",
                             (options){.width = 400, .height = 300, .samples = -1}, own);
    if (o.quick && o.width == 400 && o.height == 300) o.width = 120, o.height = 90;
    studio s;
    studio_view view;
    camera c;
    effects_stage e;
    failure f;
    if (q.path ? !studio_read(q.path, &q.words, &s, &f)
               : !studio_read_text(demo_scene, "demo.scene", &q.words, &s, &f)) fail(f);
    plan p = plan_of(&s);
    unsigned mask = p.effects;
    if (q.effects && !effects_read(q.effects, &mask, &f)) fail(f);
    if (!studio_camera(&s, (real)o.width / (real)o.height, &view, &c, &f)) fail(f);
    if (q.told) explain(stdout, &s, &p, &view);
    if (!effects_stage_build(&s, &p, &e, &f)) fail(f);
    effects_stage_view(&e, &view, c);
    effects_stage_effects(&e, mask, q.effects && mask == EFFECTS_ALL);
    o.own = request_own(&q);
    show(&o, &q, &e);
    effects_stage_free(&e), plan_free(&p), studio_free(&s);
    return output_done(&o);
}
