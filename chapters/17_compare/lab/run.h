/* run.h: what one run of the program does: scene after scene proved, measured, told.
 *
 *   compare_run(&settings, &own)
 *
 * Without --full: the pictures, and one table of four small scenes, diffuse rays. With it: a table
 * a scene, all of them in four tables, growth with n, chart and plots. --scene, --mesh: the tables
 * of those.
 */
#ifndef COMPARE_LAB_RUN_H
#define COMPARE_LAB_RUN_H

#include "chart.h"
#include "drawing.h"
#include "growth.h"
#include "orders.h"
#include "pictures.h"
#include "regimes.h"
#include "settings.h"
#include "sweep.h"
#include "torture_run.h"

typedef struct {
    table csv;
    compare_summary summary;
    html_report *html;
    size_t proved, by_brute;
} compare_results;

/* ---------------------------------------------------------------------------------------------- */

/* Proves, and measures: all kinds of rays, or diffuse ones alone. */
static inline void compare_measure(const compare_settings *c, comparison *s, const world *w,
                                   bool all)
{
    bool quick = c->o->quick;
    int turns = quick ? 1 : all ? 5 : 3;
    compare_begin(s, w, &c->chosen, c->most_bytes, all && !quick ? 3 : 1);
    compare_rays(s, quick ? 144 : compare_usual_rays, c->o->seed);
    end_if_wrong(compare_prove(s, all && !quick ? 4000 : 1000,
                               quick ? 200 : all ? 2400 : 400, c->o->seed, stdout));
    if (all) cost_measure(s, turns);
    else cost_kind(s, KIND_DIFFUSE, turns, cost_few / 2);
}

/* A table of its own, and its part of all others. */
static inline void compare_world(const compare_settings *c, const world *w, bool alone,
                                 compare_results *r)
{
    comparison s;
    char title[160];
    compare_measure(c, &s, w, alone);
    snprintf(title, sizeof title, "%.60s: %zu shapes; %zu rays proved equal, %zu by brute force",
             w->name, world_size(w), s.proved, s.by_brute);
    if (alone) cost_table(c->o, &s, title, r->html), printf("\n");
    fflush(stdout);
    cost_csv(&r->csv, &s);
    summary_add(&r->summary, &s);
    r->proved += s.proved, r->by_brute += s.by_brute;
    compare_end(&s);
}

/* The visits of each pixel's ray; save: into the chapter's picture, too. */
static inline void draw_visits(const compare_settings *c, const world *w, bool save,
                               compare_results *r)
{
    bool whole;
    image im = visits_draw(c->o, w, &c->chosen, c->most_bytes, &whole);
    html_picture(r->html, &im, "Steps and tests of each pixel's ray: black none, white a hundred");
    if (save) output_picture(c->o, &im, "17_compare_visits.png", false, whole);
    image_free(&im);
}

static inline void draw_pictures(const compare_settings *c, compare_results *r)
{
    const options *o = c->o;
    world w;
    failure f;
    image im = image_new(o->width, o->height);
    bool whole = sheet_draw(o, &im);
    html_picture(r->html, &im, "The scenes");
    output_picture(o, &im, "17_compare.png", true, whole);
    image_free(&im);
    if (o->out) return;
    if (!scene_world(scene_find("teapot"), o->quick ? 3 : 12, &w, &f)) fail(f);
    draw_visits(c, &w, true, r);
    world_free(&w);
    closed_draw(o);
}

/* Scene k of --mesh, or of the list; false: not wanted. */
static inline bool world_wanted(const compare_settings *c, const compare_options *own, int k,
                                world *w)
{
    failure f;
    if (own->mesh[0]) {
        if (k >= most_meshes || !own->mesh[k]) return false;
        own_world(own, own->mesh[k], w);
        own_view(own, w);
        return true;
    }
    if (k >= scenes) return false;
    const compare_sizes *s = &scene_list[k];
    const generator *g = scene_find(s->name);
    bool one = own->files.rays || own->sweep;
    bool few = !c->o->full && !own->verify && !one && !own->scene;
    bool late = c->o->quick && k > 4;  /* --quick: of the few, two */
    if (own->scene ? strcmp(own->scene, s->name) != 0 : few && (!s->shown || late)) return false;
    if (!own->scene && one && strcmp(s->name, "teapot") != 0) return false;
    int scale = own->scale >= 0 ? own->scale : c->o->quick ? s->quick : few ? s->shown : g->scale;
    if (!scene_world(g, scale, w, &f)) fail(f);
    return true;
}

/* What only all scenes together tell. */
static inline void compare_all(const compare_settings *c, const compare_options *own,
                               compare_results *r)
{
    const options *o = c->o;
    bool book = !own->scene && !own->mesh[0];
    char verdict[300];
    snprintf(verdict, sizeof verdict, "%zu rays were proved to have the same hits in all "
             "structures, %zu of them by brute force, before anything was timed. Each time is the "
             "median of several turns on one thread, each structure warmed before its turn.",
             r->proved, r->by_brute);
    html_heading(r->html, "Verdict");
    html_element(r->html, "p", verdict);
    if (book && !o->full) summary_few(o, &r->summary, r->html);
    else if (book || r->html || own->mesh[1]) summary_print(o, &r->summary, r->html);
    html_heading(r->html, "What a ray costs, and what building costs");
    if (r->html) chart_write(&r->summary, html_file(r->html));
    if (!book || !o->full) return;
    torture_run(c, NULL, NULL);
    html_heading(r->html, "Growth");
    end_if_wrong(growth_run(o, &c->chosen, c->most_bytes, r->html));
    output_chart(o, &r->summary, "17_compare_time.svg");
    end_if_wrong(regimes_run(o, &c->chosen, c->most_bytes, r->html));
    orders_run(o);
}

/* One scene, and what is wanted of it. */
static inline void compare_scene(const compare_settings *c, const compare_options *own,
                                 const world *w, bool book, compare_results *r)
{
    if (own->files.rays) file_run(c, w, &own->files);
    else if (own->verify) verify_world(c, w);
    else if (own->sweep) {
        comparison s;
        compare_measure(c, &s, w, false);
        sweep_run(c->o, &s, r->html);
        compare_end(&s);
    } else {
        compare_world(c, w, !book || c->o->full, r);
        if (!book && r->html) draw_visits(c, w, false, r);
    }
}

static inline void compare_run(const compare_settings *c, const compare_options *own)
{
    const options *o = c->o;
    bool book = !own->scene && !own->mesh[0], only_picture = book && o->out;
    bool measured = !own->files.rays && !own->verify && !own->sweep && !own->regimes;
    world w;
    compare_results r = {.csv = table_new("17_compare", cost_columns),
                         .summary = {.chosen = &c->chosen}};
    r.html = html_begin(own->report, "17 compare: acceleration structures, side by side");
    if (own->regimes) end_if_wrong(regimes_run(o, &c->chosen, c->most_bytes, r.html));
    if (book && measured) draw_pictures(c, &r);
    for (int k = 0; k < scenes + most_meshes && !only_picture && !own->regimes; k++) {
        if (!world_wanted(c, own, k, &w)) continue;
        compare_scene(c, own, &w, book, &r);
        world_free(&w);
    }
    if (measured && !only_picture) {
        failure f;
        compare_all(c, own, &r);
        if (!output_csv(o, &r.csv, &f)) fail(f);  /* tables on the screen have other columns */
    }
    table_free(&r.csv);
    html_end(r.html);
}

#endif
