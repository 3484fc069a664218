/* pictures.h: all scenes on one sheet; what each pixel took, structure by structure; why the proof
 * asks a ray three times.
 *
 *   image s = sheet_draw(&o, &whole)            6 x 2 panels, colours under the headlight of 02
 *   image v = visits_draw(&c, &w, &whole)       4 panels a row: the scene; nodes and
 *                                               tests of each primary ray, black none, white
 *                                               visits_most or more; one for each structure
 *   closed_draw(&o)      17_compare_closed.svg: boxes of example.h along a real ray, from the root
 *                        to the leaf that is hit; below, the three intervals (proof.h)
 *
 * Not whole: Ctrl-C stopped it, and the picture is what there is.
 */
#ifndef COMPARE_LAB_PICTURES_H
#define COMPARE_LAB_PICTURES_H

#include "../../../common/headlight.h"
#include "../../../common/lab/figure.h"
#include "../../../common/lab/heat.h"
#include "../../../common/lab/label.h"
#include "../../../common/lab/pixels.h"
#include "../../../common/output.h"
#include "../../07_mesh/scenes/named.h"
#include "compare.h"

enum { sheet_columns = 6, sheet_rows = 2, visits_columns = 4, visits_most = 100 };
enum { closed_items = 16, closed_rows = 5 };  /* halved four times */
typedef struct {
    const world *w;
    const contender *c;
    const void *s;
    int width, height;
    const char *label;
} sheet_panel;

/* ---------------------------------------------------------------------------------------------- */

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

static inline image sheet_draw(const options *o, bool *whole)
{
    image im = label_sheet(o->width, o->height);
    const contender *c = &wide_contender;
    *whole = true;
    for (int k = 0; *whole && k < scenes; k++) {
        world w;
        failure f;
        const generator *g = scene_find(scene_list[k].name);
        bool fine = strcmp(g->name, "soup") == 0 || strcmp(g->name, "solids") == 0;  /* grey */
        int scale = o->quick || fine ? scene_list[k].quick : g->scale;
        if (!scene_world(g, scale, &w, &f)) fail(f);
        scene all = world_scene(&w);
        items x = w.n ? items_of_scene(&all) : items_of_mesh(&w.mesh);
        void *s = contender_build(c, &(contender_settings){.n = 0}, &x, SIZE_MAX, &f);
        if (!s) fail(f);
        *whole = sheet_place((sheet_panel){&w, c, s, 0, 0, w.name}, sheet_colour, o->quick ? 1 : 2,
                             k, sheet_columns, sheet_rows, o->threads, &im);
        contender_free(c, s);
        world_free(&w);
    }
    return im;
}

/* Brute force would be white, and first versions don't count steps: these are left out. */
static inline image visits_draw(const compare_settings *c, const world *w, bool *whole)
{
    comparison s;
    const options *o = c->o;
    line_up shown = choose_counting(&c->chosen);
    compare_begin(&s, w, &shown, c->most_bytes, 1);
    int rows = (s.entries + 1) / visits_columns + 1, across = o->width / visits_columns;
    image im = label_sheet(o->width, rows * (across > 0 ? across : 1));
    const compare_entry *e = compare_any(&s);
    *whole = !e || sheet_place((sheet_panel){w, e->c, e->s, 0, 0, w->name}, sheet_colour,
                               o->quick ? 1 : 2, 0, visits_columns, rows, o->threads, &im);
    for (int k = 0; *whole && k < s.entries; k++) {
        e = &s.entry[k];
        if (e->s)
            *whole = sheet_place((sheet_panel){w, e->c, e->s, 0, 0, e->choice->label},
                                 sheet_visits, 1, k + 1, visits_columns, rows, o->threads, &im);
    }
    int left = (s.entries + 1) % visits_columns, x = left * across + 16;
    if (across >= 120)  /* in the last place: what the colours say */
        label_bar(&im, x, (rows - 1) * across + across / 2, across - 32, 9, work_colour, 0,
                  visits_most, "steps and tests");
    compare_end(&s);
    return im;
}

/* Where the ray is in the box. */
static inline void closed_row(figure *g, aabb b, ray r, double y, double unit, const char *name)
{
    ray back = {ray_at(r, 20), 0, vneg(r.d), 20};
    real enter = 0, leave = 0;
    if (aabb_hit(b, r, &enter) && aabb_hit(b, back, &leave)) leave = 20 - leave;
    double from = unit * (double)enter, to = unit * (double)leave + 2;
    double xy[8] = {from, y - 7, to, y - 7, to, y + 7, from, y + 7};
    figure_text(g, 0, y, -14, 5, FIGURE_RIGHT, FIGURE_BLUE, name);
    figure_polygon(g, 4, xy, FIGURE_BLUE, 0.35, FIGURE_BLUE);
}

/* Sixteen triangles across the ray, all but the last beside it. */
static inline mesh closed_mesh(void)
{
    mesh m = mesh_room(closed_items);
    for (int i = 0; i < closed_items; i++) {
        real z = 1 + (real)i / 5, x = i == 12 ? (real)0.2 : (real)0.8 - (real)(i % 4);
        m.v[3 * i] = (vec3){x, 0, z};
        m.v[3 * i + 1] = (vec3){x + (real)0.6, 0, z};
        m.v[3 * i + 2] = (vec3){x, (real)0.6, z};
    }
    return m;
}

cold_inline void closed_draw(const options *o)
{
    static const char *const asked[aimed_ways] = {"as it came", "ends at its hit",
                                                    "begins there, too"};
    mesh m = closed_mesh();
    items x = items_of_mesh(&m);
    example e;
    failure f;
    hit h = hit_none;
    ray r = {vec(0.35, 0.1, 0), 0, vec(0, 0.01, 1), real_infinity};
    size_t at = 0, node = 0, first = 0;
    if (!example_build(&x, (example_options){SIZE_MAX}, &e, &f)) fail(f);
    if (!example_hit(&e, r, &h)) abort();
    while (e.item[at].index != h.shape) at++;
    double unit = 120, t = unit * (double)h.t, y = -26.0 * closed_rows - 26;
    figure g = figure_begin(o, "17_compare_closed.svg", 800,
                            120 + 26 * (closed_rows + aimed_ways));
    figure_origin(&g, 190, 60, 1);
    figure_text(&g, 0, 0, -175, -32, FIGURE_LEFT, FIGURE_BLACK,
                "From where to where the ray is in the boxes on its way to the hit");
    for (size_t k = 0, half = closed_items / 2; k < closed_rows; k++, half /= 2) {
        char name[32];
        bool second = at >= first + half;
        snprintf(name, sizeof name, k ? k + 1 < closed_rows ? "node %zu" : "node %zu, a leaf"
                 : "root", node);
        closed_row(&g, e.box[node], r, -26.0 * (double)k, unit, name);
        node += second ? 2 * half : 1, first += second ? half : 0;
    }
    figure_line(&g, t, 18, t, y - 26 * 3 + 8, FIGURE_RED, 1.5, FIGURE_DASHED);
    figure_text(&g, t, y - 26 * 3, 0, 14, FIGURE_MIDDLE, FIGURE_RED, "_t_ of the hit");
    for (int k = 0; k < aimed_ways; k++, y -= 26) {
        figure_text(&g, 0, y, -14, 5, FIGURE_RIGHT, FIGURE_BLACK, asked[k]);
        if (k == 0) figure_arrow(&g, 0, y, 560, y, FIGURE_BLACK, 2);
        else if (k == 1) figure_line(&g, 0, y, t, y, FIGURE_BLACK, 2, FIGURE_WHOLE);
        if (k < 2) figure_dot(&g, 0, y, 4, FIGURE_BLACK);
        if (k > 0) figure_dot(&g, t, y, 4, FIGURE_BLACK);
    }
    figure_end(&g);
    example_free(&e), mesh_free(&m);
}

#endif
