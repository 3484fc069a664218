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

#include "growth.h"
#include "orders.h"
#include "pictures.h"
#include "regimes.h"
#include "settings.h"
#include "torture_run.h"

/* ---------------------------------------------------------------------------------------------- */

/* Proves, and measures: all kinds of rays, or diffuse ones alone. sweep: building counts, too. */
static inline void compare_measure(const compare_settings *c, comparison *s, const world *w,
                                   bool all, bool sweep)
{
    bool quick = c->o->quick;
    compare_begin(s, w, &c->chosen, c->most_bytes, (all || sweep) && !quick ? 3 : 1);
    compare_rays(s, quick ? 144 : compare_usual_rays, c->o->seed);
    compare_say_share(s, c->to);
    end_if_wrong(compare_prove(s, all && !quick ? 4000 : 1000,
                               quick ? 200 : all ? 2400 : 400, c->o->seed, stdout), w->name);
    int turns = quick ? 1 : all && s->share == 1 ? 5 : 3;
    if (all) cost_measure(s, turns);
    else cost_kind(s, KIND_DIFFUSE, turns, cost_few / 4);
}

/* The visits of each pixel's ray; save: into the chapter's picture, too. */
cold_inline void draw_visits(const compare_settings *c, const world *w, bool save)
{
    bool whole;
    image im = visits_draw(c, w, &whole);
    html_picture(c->to, &im, "Steps and tests of each pixel's ray: black none, white a hundred");
    if (save) output_picture(c->o, &im, "17_compare_visits.png", false, whole);
    image_free(&im);
}

static inline void draw_pictures(const compare_settings *c)
{
    const options *o = c->o;
    world w;
    failure f;
    bool whole;
    image im = sheet_draw(o, &whole);
    html_picture(c->to, &im, "The scenes");
    output_picture(o, &im, "17_compare.png", true, whole);
    image_free(&im);
    if (o->out) return;
    closed_draw(o);
    if (!scene_world(scene_find("teapot"), o->quick ? 3 : 12, &w, &f)) fail(f);
    draw_visits(c, &w, true);
    world_free(&w);
}

/* Scene k of --mesh, or of the list; false: not wanted. */
static inline bool world_wanted(const compare_settings *c, const compare_options *own, int k,
                                world *w)
{
    failure f;
    if (own->mesh[0]) {
        if (k < most_meshes && own->mesh[k]) return own_world(own, own->mesh[k], w), true;
        return false;
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

/* One scene, and what is wanted of it: a table of its own, unless it is one of the few. */
static inline void compare_scene(const compare_settings *c, const compare_options *own,
                                 const world *w, measured_scenes *m)
{
    comparison s;
    bool given = own->scene || own->mesh[0], alone = c->o->full || given;
    if (own->files.rays) file_run(c, w, &own->files);
    else if (own->verify) verify_world(c, w);
    else {
        compare_measure(c, &s, w, alone && !own->sweep, own->sweep);
        if (own->sweep) sweep_run(&s, c->to);
        else if (alone) cost_table(&s, c->to), printf("\n");
        fflush(stdout);
        measured_add(m, &s);
        if (own->report && !own->sweep && given) draw_visits(c, w, false);
    }
}

/* What only all scenes together tell. */
static inline void compare_all(const compare_settings *c, const compare_options *own,
                               const measured_scenes *m)
{
    bool book = !own->scene && !own->mesh[0];
    size_t proved = 0, by_brute = 0;
    char verdict[300];
    for (const comparison *s = m->of; s < m->of + m->n; s++)
        proved += s->proved, by_brute += s->by_brute;
    snprintf(verdict, sizeof verdict, "%zu rays were proved to have the same hits in all "
             "structures, %zu of them by brute force, before anything was timed. A time of a ray "
             "is %s on one thread, each structure warmed before its turn.",
             proved, by_brute, c->o->quick ? "of one turn" : "the median of several turns");
    summary_verdict(m, c->to);
    html_first(c->to, "p", verdict);
    if (book && !c->o->full) summary_few(m, c->to);
    if (own->report || own->mesh[1] || (book && c->o->full)) summary_print(m, c->to);
    html_element(c->to, "p class=\"note\"",
                 "A dash: not built there. The first versions hold triangles only.");
    summary_chart(m, c->to);
    if (!book || !c->o->full) return;
    torture_run(c, NULL, NULL);
    end_if_wrong(growth_run(c), "growth");
    end_if_wrong(regimes_run(c), "motion");
    orders_run(c);
}

static inline void compare_run(const compare_settings *c, const compare_options *own)
{
    bool book = !own->scene && !own->mesh[0], only_picture = book && c->o->out;
    bool tables = !own->files.rays && !own->verify && !own->sweep && !own->regimes;
    world w;
    failure f;
    measured_scenes m = {.chosen = &c->chosen};
    if (own->regimes) end_if_wrong(regimes_run(c), "motion");
    if (book && tables) draw_pictures(c);
    if (only_picture || own->regimes) return;
    if (tables && (c->o->full || !book))
        html_element(c->to, "p", "B/shape: bytes a shape. inner: inner nodes; leaves: leaves or "
                     "cells; empty: those with nothing in them. refs/shape: how often a shape is "
                     "listed. nodes/ray, tests/ray: steps, and shapes tested. Times are of one "
                     "ray: from the eye (primary), from a hit to a light (shadow), anywhere "
                     "(diffuse), mirrored (mirror). wrong: a first version that loses hits.");
    for (int k = 0; k < scenes + most_meshes; k++) {
        if (!world_wanted(c, own, k, &w)) continue;
        compare_scene(c, own, &w, &m);
        world_free(&w);
    }
    if (tables) {
        table csv = table_new("17_compare", cost_columns);
        compare_all(c, own, &m);
        for (const comparison *s = m.of; s < m.of + m.n; s++) cost_csv(&csv, s);
        if (!output_csv(c->o, &csv, &f)) fail(f);  /* tables on the screen have other columns */
        table_free(&csv);
    }
    measured_free(&m);
}

#endif
