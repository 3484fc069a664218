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
#include "summary.h"
#include "sweep.h"
#include "torture_run.h"
#include <sys/resource.h>

typedef struct {
    table csv;
    compare_summary summary;
    compare_chart bars;
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
    else cost_kind(s, KIND_DIFFUSE, turns);
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
    int place = chart_panel(&r->bars, w->name);
    for (int k = 0; k < s.entries && place >= 0; k++) {
        const compare_entry *e = &s.entry[k];
        if (e->c == &brute_contender || e->c == &first_mesh_contender) continue;
        chart_bar(&r->bars, place, e->choice->label, e->s ? cost_mean(&s, e) * 1e9 : 0,
                  cost_spread(e), per(e->build * 1e9, s.x.n));
    }
    compare_end(&s);
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
    im = visits_draw(o, &w, &c->chosen, c->most_bytes, &whole);
    html_picture(r->html, &im, "Steps and tests of each pixel's ray: black none, white a hundred");
    output_picture(o, &im, "17_compare_visits.png", false, whole);
    image_free(&im);
    world_free(&w);
    closed_draw(o);
}

/* The picture of one's own scene, for the report. */
static inline void report_scene(const compare_settings *c, const world *w, compare_results *r)
{
    bool whole;
    if (!r->html) return;
    image im = visits_draw(c->o, w, &c->chosen, c->most_bytes, &whole);
    html_picture(r->html, &im, "Steps and tests of each pixel's ray: black none, white a hundred");
    image_free(&im);
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
    if (own->scene ? strcmp(own->scene, s->name) != 0 : few && !s->shown) return false;
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
    bool several = own->mesh[1];
    html_heading(r->html, "Verdict");
    html_text(r->html, "%zu rays were proved to have the same hits in all structures, %zu of them "
              "by brute force, before anything was timed. Each time is the median of several turns "
              "on one thread, each structure warmed before its turn.", r->proved, r->by_brute);
    if (!o->full && !own->mesh[0] && !own->scene) {
        summary_few(o, &r->summary, r->html);
    } else if (r->html || several || (!own->mesh[0] && !own->scene)) {
        summary_print(o, &r->summary, r->html);
    }
    if (r->html) {
        html_heading(r->html, "What a ray costs, and what building costs");
        chart_write(&r->bars, html_file(r->html));
    }
    if (own->mesh[0] || own->scene || (!o->full)) return;
    torture_run(c, NULL, NULL);
    html_heading(r->html, "Growth");
    end_if_wrong(growth_run(o, &c->chosen, c->most_bytes, r->html));
    output_chart(o, &r->bars, "17_compare_time.svg");
    end_if_wrong(regimes_run(o, &c->chosen, c->most_bytes, r->html));
    orders_run(o);
    struct rusage u;
    if (!o->quick && getrusage(RUSAGE_SELF, &u) == 0)
        printf("# most memory held by the program: %.0f MB\n", (double)u.ru_maxrss / 1024);
}

static inline void compare_run(const compare_settings *c, const compare_options *own)
{
    const options *o = c->o;
    bool all = !own->scene && !own->mesh[0], rays = own->files.rays;
    bool measured = !rays && !own->verify && !own->sweep;
    bool alone = !all || o->full;
    world w;
    compare_results r = {.csv = table_new("17_compare", cost_columns),
                         .summary = {.chosen = &c->chosen},
                         .bars = chart_new("What a ray costs, and what building costs")};
    r.html = html_begin(own->report, "17 compare: acceleration structures, side by side");
    if (own->regimes) {
        end_if_wrong(regimes_run(o, &c->chosen, c->most_bytes, r.html));
        table_free(&r.csv), html_end(r.html);
        return;
    }
    if (all && measured) draw_pictures(c, &r);
    for (int k = 0; k < scenes + most_meshes && !(all && o->out); k++) {
        if (!world_wanted(c, own, k, &w)) continue;
        if (rays) file_run(c, &w, &own->files);
        else if (own->verify) verify_world(c, &w);
        else if (own->sweep) {
            comparison s;
            compare_measure(c, &s, &w, false);
            sweep_run(o, &s, r.html);
            compare_end(&s);
        } else {
            compare_world(c, &w, alone, &r);
            if (!all) report_scene(c, &w, &r);
        }
        world_free(&w);
    }
    measured = measured && !(all && o->out);
    if (measured) compare_all(c, own, &r);
    if (measured) cost_write_csv(o, &r.csv);
    else table_free(&r.csv);
    html_end(r.html);
    free(r.bars.value);
}

#endif
