/* six.h: six scenes, each a line longer than the one before, and what that line calls for.
 *
 *   six_text(k, text)                scene k of 0 .. 5: scenes/1_sun.scene .. 6_lens.scene
 *   bool whole = draw_six(&o, false)   27_effects.png, and the table that goes below it
 *   bool whole = draw_six(&o, true)  27_effects_six.png: the same with more samples
 *   bool whole = draw_two(&o)        27_effects_two.png: glass.scene and teapot.scene, their plans
 *
 * The table's two times are of the plan and of everything, both on the same pixels.
 */
#ifndef EFFECTS_SIX_H
#define EFFECTS_SIX_H

#include "../files/studio_read.h"
#include "../../../common/lab/label.h"
#include "../../../common/lab/report.h"
#include "../plan.h"
#include "draw.h"
#include <unistd.h>

enum { six_count = 6, six_room = 2048, six_width = 240, six_height = 180 };

static const char six_base[] =
    "camera from 0 2.3 7.5 at 0 1 0 angle 34\n"
    "background 0.5 0.65 0.85\n"
    "indirect off\n"
    "sun to 3 2.2 4 colour 3\n"
    "polygon -20 0 20  20 0 20  20 0 -20  -20 0 -20  white\n"
    "polygon -2.6 0 -4  -2.6 0 3  -2.6 3.2 3  -2.6 3.2 -4  red\n"
    "sphere -0.2 0.9 -1.6  0.9  yellow\n";

static const struct { const char *name, *line, *title; } six_scene[six_count] = {
    {"1_sun", "", "floor, ball, wall and sun"},
    {"2_chrome", "sphere -1.4 0.9 0.4  0.9  chrome\n", "+ sphere .. chrome"},
    {"3_glass", "sphere 1.1 0.8 0.9  0.8  glass\n", "+ sphere .. glass"},
    {"4_lamp", "polygon -2 6 4  4 6 4  4 6 -1  -2 6 -1  panel\n", "+ polygon .. panel"},
    {"5_wall", "indirect on\n", "+ indirect on"},
    {"6_lens", "lens radius 0.2 focus 7.8\n", "+ lens radius 0.2"}};

/* ---------------------------------------------------------------------------------------------- */

static inline void six_text(int k, char text[six_room])
{
    size_t n = (size_t)snprintf(text, six_room, "%s", six_base);
    for (int i = 1; i <= k; i++)
        n += (size_t)snprintf(text + n, six_room - n, "%s", six_scene[i].line);
}

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

/* One panel and its row; takes the studio over. samples: of scenes of chance, of others. */
static inline bool six_panel(const options *o, studio *s, const char *name, int k,
                             const int samples[2],
                             table *t, image *sheet)
{
    int w = sheet->width / (k < 0 ? 2 : 3), h = w * six_height / six_width;
    studio_view v;
    camera c;
    effects_stage e;
    failure f;
    if (!studio_camera(s, (real)w / (real)h, &v, &c, &f) || !effects_stage_build(s, &e, &f))
        fail(f);
    plan p = plan_of(s);
    effects_stage_view(&e, &v, c);
    effects_stage_effects(&e, p.effects);
    image im = image_new(w, h), small = image_new(w / 6, h / 6);
    drawing j = {.e = &e, .samples = samples[!e.chance], .seed = o->seed,
                 .width = w, .height = h};
    drawing all = j;
    bool whole = draw_region(&j, &im, 0, 0, o->threads);
    all.width = w / 6, all.height = h / 6;
    effects_stage_effects(&e, EFFECTS_EVERYTHING);
    whole = whole && draw_region(&all, &small, 0, 0, o->threads);
    image_place(sheet, (k < 0 ? k + 2 : k % 3) * w, k < 0 ? 0 : k / 3 * h, &im);
    table_text(t, "%s", name), table_text(t, "%s", integrator_names[p.integrator]);
    six_effects(t, p.effects), six_cells(t, &j), six_cells(t, &all);
    image_free(&im), image_free(&small);
    effects_stage_free(&e), plan_free(&p), studio_free(s);
    return whole;
}

static inline table six_table(const char *title)
{
    return table_new(title, "scene|plan|called for|rays a pixel|[us/pixel]|everything: rays|"
                            "everything [us/pixel]");
}

/* From their files: in the directory of the book only. */
static inline bool draw_two(const options *o)
{
    static const char *const name[2] = {"glass", "teapot"};
    const char *const title[2] = {"glass.scene: Whitted's tree", "teapot.scene: paths"};
    int w = o->quick ? 80 : 360, h = w * six_height / six_width;
    bool whole = true;
    studio s;
    failure f;
    if (access("chapters/27_effects/scenes", R_OK) != 0) return true;
    image sheet = image_new(2 * w, h);
    table t = six_table("Two scenes, two plans");
    for (int k = 0; k < 2 && whole; k++) {
        char path[100];
        snprintf(path, sizeof path, "chapters/27_effects/scenes/%s.scene", name[k]);
        if (!studio_read(path, NULL, &s, &f)) fail(f);
        whole = six_panel(o, &s, name[k], k - 2, (const int[2]){64, 4}, &t,
                          &sheet);
    }
    image titled = label_panels(&sheet, 2, 1, 0, title);
    output_picture(o, &titled, "27_effects_two.png", false, whole);
    if (whole) output_extra_table(o, &t);
    else table_free(&t);
    image_free(&sheet), image_free(&titled);
    return whole;
}

/* The default run's, with a table; `fine`: the page's, with eight times the samples. */
static inline bool draw_six(const options *o, bool fine)
{
    const char *title[six_count];
    const int samples[2] = {fine ? 128 : 16, fine ? 32 : 4};
    int w = o->quick ? six_width / 4 : six_width, h = o->quick ? six_height / 4 : six_height;
    image sheet = image_new(3 * w, 2 * h);
    table t = six_table("Six scenes, each a line longer: what is called for, and everything");
    bool whole = true;
    for (int k = 0; k < six_count; k++) {
        char text[six_room];
        studio s;
        failure f;
        title[k] = six_scene[k].title;
        if (!whole) continue;
        six_text(k, text);
        if (!studio_read_text(text, six_scene[k].name, NULL, &s, &f)) fail(f);
        whole = six_panel(o, &s, six_scene[k].name, k, samples, &t, &sheet);
    }
    image titled = label_panels(&sheet, 3, 2, 0, title);
    output_picture(o, &titled, fine ? "27_effects_six.png" : "27_effects.png", !fine, whole);
    if (whole && !fine) output_table(o, &t);
    else table_free(&t);
    image_free(&sheet), image_free(&titled);
    return whole;
}

#endif
