/* six.h: scenes and their plans: pictures side by side, and what each took.
 *
 *   bool whole = draw_six(&o, false)   27_effects.png, of scenes/1_sun.scene .. 6_lens.scene, each
 *                                    a line longer than the one before, and the table below it
 *   bool whole = draw_six(&o, true)  27_effects_six.png: the same with eight times the samples
 *   bool whole = draw_two(&o)        27_effects_two.png: glass.scene and teapot.scene, their plans
 *   six_text(5, text)                the last of the six: what is drawn if no file is named
 *
 * The table's two times are of the plan and of everything. The six need no files; draw_two is for
 * the directory of the book only.
 */
#ifndef EFFECTS_SIX_H
#define EFFECTS_SIX_H

#include "../files/studio_read.h"
#include "../../../common/lab/label.h"
#include "../../../common/lab/report.h"
#include "../plan.h"
#include "draw.h"
#include "six_first.h"
#include <unistd.h>

enum { six_count = 6, six_room = 2048, six_width = 240, six_height = 180 };
#define six_scenes "chapters/27_effects/scenes/"

static const char six_base[] =
    "camera from 0 2.3 7.5 at 0 1 0 angle 34\n"
    "background 0.5 0.65 0.85\n"
    "indirect off\n"
    "sun to 3 2.2 4 colour 3\n"
    "polygon -20 0 20  20 0 20  20 0 -20  -20 0 -20  white\n"
    "polygon -2.6 0 -4  -2.6 0 3  -2.6 3.2 3  -2.6 3.2 -4  red\n"
    "sphere -0.2 0.9 -1.6  0.9  yellow\n";

/* line: what it has more than the scenes before it; NULL: it is read from its file. */
typedef struct { const char *name, *line, *title; } six_scene;
static const six_scene six_list[six_count] = {
    {"1_sun", "", "floor, ball, wall and sun"},
    {"2_chrome", "sphere -1.4 0.9 0.4  0.9  chrome\n", "+ sphere .. chrome"},
    {"3_glass", "sphere 1.1 0.8 0.9  0.8  glass\n", "+ sphere .. glass"},
    {"4_lamp", "polygon -2 6 4  4 6 4  4 6 -1  -2 6 -1  panel\n", "+ polygon .. panel"},
    {"5_wall", "indirect on\n", "+ indirect on"},
    {"6_lens", "lens radius 0.2 focus 7.8\n", "+ lens radius 0.2"}};
static const six_scene two_list[2] = {{"glass", NULL, "glass.scene: Whitted's tree"},
                                      {"teapot", NULL, "teapot.scene: paths"}};

/* ---------------------------------------------------------------------------------------------- */

static inline void six_text(int k, char text[six_room])
{
    size_t n = (size_t)snprintf(text, six_room, "%s", six_base);
    for (int i = 1; i <= k; i++)
        n += (size_t)snprintf(text + n, six_room - n, "%s", six_list[i].line);
}

static inline bool six_read(const six_scene *list, int k, studio *s, failure *f)
{
    char text[six_room];
    if (list[k].line) return six_text(k, text), studio_read_text(text, list[k].name, NULL, s, f);
    snprintf(text, sizeof text, six_scenes "%s.scene", list[k].name);
    return studio_read(text, NULL, s, f);
}

/* One panel of w x h and its rows; samples: of scenes of chance, of others; first: or NULL. What it
 * took is of so many samples; the picture has `finer` times as many. */
static inline bool six_panel(const options *o, const six_scene *list, int k, int w, int h,
                             const int samples[2], int finer, table *t, table *first, image *im)
{
    effects_ready q;
    failure f;
    char called[120] = "";
    image small = {0, 0, NULL};
    if (!six_read(list, k, &q.s, &f) || !effects_get_ready(&q, (real)w / (real)h, &f)) fail(f);
    drawing j = {.e = &q.e, .samples = samples[!q.e.chance], .seed = o->seed, .width = w,
                 .height = h};
    drawing all = j, fine = j;
    all.width = w / 6, all.height = h / 6, fine.samples *= finer;
    bool whole = draw_image(&j, im, o->threads);
    if (whole && finer > 1) image_free(im), whole = draw_image(&fine, im, o->threads);
    if (whole && first) first_row(first, k, list[k].name, &q.view, &j, im);
    effects_stage_effects(&q.e, EFFECTS_EVERYTHING);
    whole = whole && draw_image(&all, &small, o->threads);
    for (int i = 0; i < effect_kinds; i++)
        if (q.p.effects >> i & 1)
            snprintf(called + strlen(called), sizeof called - strlen(called), "%s%s",
                     *called ? ", " : "", effect_names[i].option);
    table_text(t, "%s", list[k].name);
    table_text(t, "%s", called);
    double lean = (double)draw_rays(&j.counts) / draw_pixels(&j);
    double rays = (double)draw_rays(&all.counts) / draw_pixels(&all);
    table_number(t, lean), table_number(t, j.pass.seconds / draw_pixels(&j) * 1e6);
    table_number(t, rays), table_number(t, all.pass.seconds / draw_pixels(&all) * 1e6);
    snprintf(called, sizeof called, "%.3g of %.3g rays a pixel", lean, rays);
    if (w >= six_width) {
        label_tag(im, 4, h - 36, 9, integrator_of(q.p.effects));
        label_tag(im, 4, h - 19, 9, called);
    }
    image_free(&small), effects_ready_free(&q);
    return whole;
}

/* Panels of w pixels, so many across, and the table of that name; NULL: none. False: stopped. */
static inline bool six_draw(const options *o, const six_scene *list, int n, int across, int w,
                            const int samples[2], int finer, const char *file, const char *name,
                            table *first)
{
    const char *title[six_count];
    bool whole = true, is_main = first != NULL;
    image sheet = {0, 0, NULL};
    table t = table_new(name, "scene|called for|rays a pixel|[us/pixel]|everything: rays|"
                              "everything [us/pixel]");
    for (int k = 0; k < n; k++) title[k] = list[k].title;
    for (int k = 0; k < n && whole; k++) {
        image im;
        whole = six_panel(o, list, k, w, w * six_height / six_width, samples, finer, &t, first,
                          &im);
        label_panel(&sheet, across, n / across, 0, k, &im);
        image_free(&im);
    }
    label_titles(&sheet, across, n / across, 0, title);
    output_picture(o, &sheet, file, is_main, whole);
    image_free(&sheet);
    if (whole && is_main) output_table(o, &t);
    else if (whole && name) output_extra_table(o, &t);
    else table_free(&t);
    return whole;
}

static inline bool draw_two(const options *o)
{
    if (access(six_scenes, R_OK) != 0) return true;
    return six_draw(o, two_list, 2, 2, o->quick ? 80 : 360, (const int[2]){64, 4}, 1,
                    "27_effects_two.png", "Two scenes, two plans", NULL);
}

cold_inline bool draw_six(const options *o, bool fine)
{
    const int w = o->quick ? six_width / 4 : six_width, samples[2] = {16, 4};
    if (fine)
        return six_draw(o, six_list, six_count, 3, w, samples, 8, "27_effects_six.png", NULL, NULL);
    table first = first_table("The same scenes by the short book's plan, first.h");
    bool whole = six_draw(o, six_list, six_count, 3, w, samples, 1, "27_effects.png", "Six scenes, "
                          "each a line longer: what is called for, and everything", &first);
    if (whole) output_extra_table(o, &first);
    else table_free(&first);
    return whole;
}

#endif
