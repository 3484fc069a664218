/* six.h: scenes and their plans: pictures side by side, and what each took.
 *
 *   bool whole = draw_six(&o, false)   27_effects.png, of scenes/1_sun.scene .. 6_lens.scene, each a
 *                                    line longer than the one before, and the table that goes below
 *   bool whole = draw_six(&o, true)  27_effects_six.png: the same with eight times the samples
 *   bool whole = draw_two(&o)        27_effects_two.png: glass.scene and teapot.scene, their plans
 *
 * The table's two times are of the plan and of everything. In the directory of the book only.
 */
#ifndef EFFECTS_SIX_H
#define EFFECTS_SIX_H

#include "../files/studio_read.h"
#include "../../../common/lab/label.h"
#include "../../../common/lab/report.h"
#include "../plan.h"
#include "draw.h"

enum { six_count = 6, six_width = 240, six_height = 180 };
#define six_scenes "chapters/27_effects/scenes/"

typedef struct { const char *name, *title; } six_scene;
static const six_scene six_list[six_count] = {
    {"1_sun", "floor, ball, wall and sun"}, {"2_chrome", "+ sphere .. chrome"},
    {"3_glass", "+ sphere .. glass"}, {"4_lamp", "+ polygon .. panel"}, {"5_wall", "+ indirect on"},
    {"6_lens", "+ lens radius 0.2"}};
static const six_scene two_list[2] = {{"glass", "glass.scene: Whitted's tree"},
                                      {"teapot", "teapot.scene: paths"}};

/* ---------------------------------------------------------------------------------------------- */

/* All rays but the eye's, of a pixel, and how long a pixel takes. */
static inline void six_cells(table *t, const drawing *j)
{
    table_number(t, (double)draw_rays(&j->counts) / (double)j->pixels);
    table_number(t, j->pass.seconds / (double)j->pixels * 1e6);
}

/* Every effect that is called for, in short. */
static inline void six_effects(table *t, unsigned mask)
{
    char text[120] = "";
    for (int k = 0; k < effect_kinds; k++)
        if (mask >> k & 1)
            snprintf(text + strlen(text), sizeof text - strlen(text), "%s%s", *text ? ", " : "",
                     effect_names[k].option);
    table_text(t, "%s", text);
}

/* One panel and its row; samples: of scenes of chance, of others. */
static inline bool six_panel(const options *o, const char *name, const int samples[2], table *t,
                             image *im)
{
    int w = im->width, h = im->height;
    char path[100];
    studio s;
    studio_view v;
    camera c;
    effects_stage e;
    failure f;
    snprintf(path, sizeof path, six_scenes "%s.scene", name);
    if (!studio_read(path, NULL, &s, &f) || !studio_camera(&s, (real)w / (real)h, &v, &c, &f)
        || !effects_stage_build(&s, &e, &f)) fail(f);
    plan p = plan_of(&s);
    effects_stage_view(&e, &v, c);
    effects_stage_effects(&e, p.effects);
    drawing j = {.e = &e, .samples = samples[!e.chance], .seed = o->seed, .width = w, .height = h};
    drawing all = j;
    image small = image_new(all.width = w / 6, all.height = h / 6);
    bool whole = draw_region(&j, im, 0, 0, o->threads);
    effects_stage_effects(&e, EFFECTS_EVERYTHING);
    whole = whole && draw_region(&all, &small, 0, 0, o->threads);
    table_text(t, "%s", name), table_text(t, "%s", integrator_names[p.integrator]);
    six_effects(t, p.effects), six_cells(t, &j), six_cells(t, &all);
    image_free(&small), effects_stage_free(&e), plan_free(&p), studio_free(&s);
    return whole;
}

/* Panels of w pixels, so many across; the table is left to the caller. False: stopped. */
static inline bool six_draw(const options *o, const six_scene *list, int n, int across, int w,
                            const int samples[2], const char *file, bool is_main, table *t)
{
    int h = w * six_height / six_width;
    const char *title[six_count];
    bool whole = true;
    image sheet = image_new(across * w, n / across * h);
    for (int k = 0; k < n; k++) {
        image im = image_new(w, h);
        title[k] = list[k].title;
        whole = whole && six_panel(o, list[k].name, samples, t, &im);
        image_place(&sheet, k % across * w, k / across * h, &im);
        image_free(&im);
    }
    image titled = label_panels(&sheet, across, n / across, 0, title);
    output_picture(o, &titled, file, is_main, whole);
    image_free(&sheet), image_free(&titled);
    return whole;
}

static inline table six_table(const char *title)
{
    return table_new(title, "scene|plan|called for|rays a pixel|[us/pixel]|everything: rays|"
                            "everything [us/pixel]");
}

static inline bool draw_two(const options *o)
{
    table t = six_table("Two scenes, two plans");
    bool whole = six_draw(o, two_list, 2, 2, o->quick ? 80 : 360, (const int[2]){64, 4},
                          "27_effects_two.png", false, &t);
    if (whole) output_extra_table(o, &t);
    else table_free(&t);
    return whole;
}

static inline bool draw_six(const options *o, bool fine)
{
    table t = six_table("Six scenes, each a line longer: what is called for, and everything");
    bool whole = six_draw(o, six_list, six_count, 3, o->quick ? six_width / 4 : six_width,
                          fine ? (const int[2]){128, 32} : (const int[2]){16, 4},
                          fine ? "27_effects_six.png" : "27_effects.png", !fine, &t);
    if (whole && !fine) output_table(o, &t);
    else table_free(&t);
    return whole;
}

#endif
