/* pictures.h: all scenes on one sheet, and what each pixel took, structure by structure.
 *
 *   sheet_draw(&o, &im)                         6 x 2 panels, colours under the headlight of 02
 *   image v = visits_draw(&c, &w, &whole)       4 panels a row: the scene; nodes and
 *                                               tests of each primary ray, black none, white
 *                                               visits_most or more; one for each structure
 * Not whole: Ctrl-C stopped it, and the picture is what there is.
 */
#ifndef COMPARE_LAB_PICTURES_H
#define COMPARE_LAB_PICTURES_H

#include "../../../common/headlight.h"
#include "../../../common/lab/heat.h"
#include "../../../common/lab/label.h"
#include "../../../common/lab/pixels.h"
#include "../../../common/output.h"
#include "compare.h"
#include "../../07_mesh/scenes/named.h"

enum { sheet_columns = 6, sheet_rows = 2, visits_columns = 4, visits_most = 100 };

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    const world *w;
    const contender *c;
    const void *s;
    int width, height;
    const char *label;
} sheet_panel;

/* Square pixels; the shorter side of the panel sees the whole view. */
static inline ray sheet_ray(const sheet_panel *p, real x, real y)
{
    real across = (real)p->width, down = (real)p->height, side = real_min(across, down);
    return world_ray(p->w, (2 * x - across) / side, (down - 2 * y) / side);
}

static inline vec3 sheet_colour(const void *context, real x, real y)
{
    const sheet_panel *p = context;
    ray r = sheet_ray(p, x, y);
    hit h;
    if (!p->c->hit(p->s, r, &h)) return p->w->background;
    vec3 n = world_normal(p->w, h, ray_at(r, h.t));
    return vmul(world_finish(p->w, h.shape).colour, headlight(n, r.d));
}

static inline vec3 sheet_visits(const void *context, real x, real y)
{
    const sheet_panel *p = context;
    search_work w = {0, 0, 0, 0};
    hit h;
    p->c->counted(p->s, sheet_ray(p, x, y), false, &h, &w);
    return work_colour((real)(w.nodes + w.tests) / visits_most);
}

/* Draws a panel as number k of columns x rows of the picture; panels are at least a pixel large. */
static inline bool sheet_place(sheet_panel p, pixels_colour *colour, int samples, int k,
                               int columns, int rows, int threads, image *all)
{
    int across = all->width / columns, down = all->height / rows;
    image im = image_new(across > 0 ? across : 1, down > 0 ? down : 1);
    p.width = im.width, p.height = im.height;
    bool whole = pixels_draw(&im, samples, threads, p.w->name, colour, &p);
    if (im.width >= 120) label_tag(&im, 4, 4, 10, p.label);
    image_place(all, k % columns * across, k / columns * down, &im);
    image_free(&im);
    return whole;
}

static inline bool sheet_draw(const options *o, image *im)
{
    bool whole = true;
    label_fill(im, 0, 0, im->width, im->height, vec(1, 1, 1));
    for (int k = 0; whole && k < scenes; k++) {
        world w;
        comparison s;
        failure f;
        const generator *g = scene_find(scene_list[k].name);
        bool fine = strcmp(g->name, "soup") == 0 || strcmp(g->name, "solids") == 0;  /* grey */
        int scale = o->quick || fine ? scene_list[k].quick : g->scale;
        if (!scene_world(g, scale, &w, &f)) fail(f);
        line_up one = {.n = 0};
        choose(&one, &wide_contender);
        compare_begin(&s, &w, &one, SIZE_MAX, 1);
        const compare_entry *e = compare_any(&s);
        if (!e) fail(s.entry[0].why);
        sheet_panel p = {&w, e->c, e->s, 0, 0, w.name};
        whole = sheet_place(p, sheet_colour, o->quick ? 1 : 2, k, sheet_columns, sheet_rows,
                            o->threads, im);
        compare_end(&s);
        world_free(&w);
    }
    return whole;
}

/* Brute force would be white, and first versions don't count steps: these are left out. */
static inline image visits_draw(const compare_settings *c, const world *w, bool *whole)
{
    comparison s;
    const options *o = c->o;
    line_up shown = choose_counting(&c->chosen);
    compare_begin(&s, w, &shown, c->most_bytes, 1);
    int rows = (s.entries + 1) / visits_columns + 1, across = o->width / visits_columns;
    image im = image_new(o->width, rows * (across > 0 ? across : 1));
    label_fill(&im, 0, 0, im.width, im.height, vec(1, 1, 1));
    const compare_entry *e = compare_any(&s);
    sheet_panel p = {w, e ? e->c : NULL, e ? e->s : NULL, 0, 0, w->name};
    *whole = !e || sheet_place(p, sheet_colour, o->quick ? 1 : 2, 0, visits_columns, rows,
                               o->threads, &im);
    for (int k = 0; *whole && k < s.entries; k++) {
        if (!s.entry[k].s) continue;
        p = (sheet_panel){w, s.entry[k].c, s.entry[k].s, 0, 0, s.entry[k].choice->label};
        *whole = sheet_place(p, sheet_visits, 1, k + 1, visits_columns, rows, o->threads, &im);
    }
    int left = (s.entries + 1) % visits_columns, x = left * across + 16;
    if (across >= 120)  /* in the last place: what the colours say */
        label_bar(&im, x, (rows - 1) * across + across / 2, across - 32, 9, work_colour, 0,
                  visits_most, "steps and tests");
    compare_end(&s);
    return im;
}

#endif
