/* run.h: what one run of the program does: scene after scene proved, measured, told.
 *
 *   compare_run(&settings, &own)          without --full: the pictures, and one table of four small
 *                                         scenes, diffuse rays. With it: a table a scene, all of
 *                                         them in four tables, growth with n, chart and plots
 *   protocol_run(c, only, scene, scale)   --protocol spd: lines that begin with `primary` and end
 *                                         with the number of hits
 *
 * A difference between two structures ends the program with exit 1.
 */
#ifndef COMPARE_LAB_RUN_H
#define COMPARE_LAB_RUN_H

#include "../../07_mesh/files/ray_file.h"
#include "growth.h"
#include "pictures.h"
#include "regimes.h"
#include "settings.h"
#include "torture_run.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void end_if_wrong(bool ok, const char *where)
{
    if (!ok) die(1, "%.80s: a structure differs from brute force: see above", where);
}

static inline void protocol_scene(const compare_settings *c, const generator *g, int scale)
{
    world w;
    comparison s;
    failure f;
    if (!world_make(g, scale, &w, &f) || !spd_print_digits(&w, &f)) fail(f);
    world_to_mesh(&w);
    compare_begin(&s, &w, &c->chosen, c->most_bytes, 1);
    ray_set rays = {allocate(spd_rays, sizeof(ray)), 0};
    for (int j = 0; j <= spd_edge; j++)
        for (int i = 0; i <= spd_edge; i++) rays.r[rays.n++] = spd_ray(&w, i, j);
    for (const compare_entry *e = s.entry; e < s.entry + s.entries; e++) {
        search_work work = {0, 0, 0, 0};
        if (!e->s) printf("# %s %s does not fit: %s\n", w.name, e->choice->label, e->why.text);
        if (!e->s) continue;
        compare_progress(w.name, "asking", e->c->name);
        size_t hits = entry_work(e, &rays, false, &work);
        compare_progress(w.name, NULL, NULL);
        printf("primary %s %d %s: build %.4f s, nodes/ray %.3g, tests/ray %.3g, rays %d, "
               "hits %zu\n", w.name, scale, e->choice->label, e->build,
               (double)work.nodes / spd_rays, (double)work.tests / spd_rays, spd_rays, hits);
        fflush(stdout);
    }
    if (g->hits && scale == g->scale)
        printf("# published for %s %d: %zu\n", g->name, scale, g->hits);
    rays_free(&rays);
    compare_end(&s);
    world_free(&w);
}

/* Without --only all that count: 263169 rays take brute force most of an hour. */
static inline void protocol_run(compare_settings c, bool only, const generator *g, int scale)
{
    if (!only) c.chosen = choose_counting(&c.chosen);
    for (int k = 0; k < spd_scenes; k++)
        if (g ? g == &spd_list[k] : spd_list[k].hits > 0)
            protocol_scene(&c, &spd_list[k], g && scale >= 0 ? scale : spd_list[k].scale);
}

/* --verify: all rays by brute force, too. */
static inline void verify_world(const compare_settings *c, const world *w)
{
    comparison s;
    double n = 1e8 / (double)(world_size(w) + 1);
    compare_begin(&s, w, &c->chosen, c->most_bytes, 1);
    compare_rays(&s, n < 64 ? 64 : n > 4096 ? 4096 : (size_t)n, c->o->seed);
    compare_say_share(&s, c->to);
    ray_set aimed = rays_aimed(w, compare_affords(&s, 2000), c->o->seed);
    size_t stretched = aimed.n / 4;
    bool ok = prove_rays(&s, &aimed, PROVE_BORDERS, stdout)
              && prove_stretched(&s, stretched, c->o->seed, stdout);
    for (int k = 0; ok && k < compare_kinds; k++) {
        compare_progress(w->name, "by brute force, rays", kind_name[k]);
        ok = prove_rays(&s, &s.rays[k], PROVE_OTHERS, stdout);
    }
    compare_progress(w->name, NULL, NULL);
    end_if_wrong(ok, w->name);
    for (const compare_entry *e = s.entry; e < s.entry + s.entries; e++) {
        const char *label = e->choice->label;
        if (!e->s) printf("%s %s: does not fit: %s\n", w->name, label, e->why.text);
        else if (contender_is_first(e->c)) cost_print_wrong(e, c->to);
        else if (e->c != &brute_contender)
            printf("%s %s: %zu primary, %zu shadow, %zu diffuse, %zu mirror, %zu aimed and %zu "
                   "stretched rays, and those that end at their hits: as brute force\n", w->name,
                   label, s.rays[KIND_PRIMARY].n, s.rays[KIND_SHADOW].n, s.rays[KIND_DIFFUSE].n,
                   s.rays[KIND_MIRROR].n, aimed.n, stretched);
    }
    fflush(stdout);
    rays_free(&aimed);
    compare_end(&s);
}

/* A line a ray: its number, its hit, and steps and tests of every structure. */
static inline void file_costs(const comparison *s, const compare_files *f, const ray_set *rays,
                              const hit *h)
{
    failure why;
    file_writer to;
    if (!file_begin(&to, f->costs, &why)) fail(why);
    fprintf(to.stream, "ray,t,shape");
    const compare_entry *end = s->entry + s->entries;
    for (const compare_entry *e = s->entry; e < end; e++)
        if (entry_counts(e))
            fprintf(to.stream, ",%s nodes,%s tests", e->choice->label, e->choice->label);
    for (size_t i = 0; i < rays->n; i++) {
        ray_set one = {&rays->r[i], 1};
        fprintf(to.stream, "\n%zu,%.9g,%.0f", i, (double)h[i].t,
                h[i].shape == no_shape ? -1.0 : (double)h[i].shape);
        for (const compare_entry *e = s->entry; e < end; e++) {
            search_work w = {0, 0, 0, 0};
            if (!entry_counts(e)) continue;
            entry_work(e, &one, f->any, &w);
            fprintf(to.stream, ",%zu,%zu", w.nodes, w.tests);
        }
    }
    fprintf(to.stream, "\n");
    if (!file_commit(&to, &why)) fail(why);
}

/* --rays: hits are those of the first structure that fits: the others were proved to agree. */
static inline void file_run(const compare_settings *c, const world *w, const compare_files *file)
{
    failure f;
    comparison s;
    compare_kind kind = file->any ? KIND_SHADOW : KIND_PRIMARY;
    ray_set all = {NULL, 0};
    all.r = rays_read(file->rays, &all.n, &f);
    if (!all.r) fail(f);
    compare_begin(&s, w, &c->chosen, c->most_bytes, 3);
    if (!compare_any(&s)) f = s.entry[0].why, fail(f);
    ray_set some = rays_some(&all, 2000);
    end_if_wrong(prove_rays(&s, &some, PROVE_OTHERS, stdout)
                 && prove_rays(&s, &all, PROVE_ALIKE, stdout), w->name);
    s.rays[kind] = all;
    cost_kind(&s, kind, 7, cost_full);
    for (int k = 0; k < s.entries; k++)  /* of all of them, as --costs has it, not of a sample */
        if (s.entry[k].s) cost_count(&s.entry[k], kind, &all);
    table t = table_new("Rays from a file, one thread", cost_columns);
    for (int k = 0; k < s.entries; k++)
        cost_csv_row(&t, &s, &s.entry[k], file->any ? "any" : "closest", kind);
    output_table(c->o, &t);
    for (compare_entry *e = s.entry; e < s.entry + s.entries; e++)  /* a first version */
        if (e->wrong[1])
            html_note(c->to, "%s: wrong at %zu of %zu of these rays", e->choice->label, e->wrong[1],
                      e->held[1]);
    const compare_entry *e = compare_any(&s);
    hit *h = allocate(all.n, sizeof *h);
    e->c->search(e->s, all.r, all.n, file->any, h);
    if (file->hits && !hits_write(file->hits, h, all.n, file->any, &f)) fail(f);
    if (file->costs) file_costs(&s, file, &all, h);
    free(h), rays_free(&some);
    compare_end(&s);
}

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
