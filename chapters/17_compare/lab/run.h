/* run.h: what one run of the program does: scene after scene proved, measured, told.
 *
 *   compare_run(settings, &own)
 *
 * Without --full: both pictures, and one table of four small scenes. With it: a table a scene, all
 * of them in four tables, the first versions, growth with n, chart and plots. --scene, --mesh: the
 * table of that one. --large: scenes of 1e4 to 1e6 shapes.
 */
#ifndef COMPARE_LAB_RUN_H
#define COMPARE_LAB_RUN_H

#include "chart.h"
#include "growth.h"
#include "pictures.h"
#include "settings.h"
#include "summary.h"
#include <sys/resource.h>

typedef struct { table csv; compare_summary summary; compare_chart bars; } compare_results;

/* ---------------------------------------------------------------------------------------------- */

/* Proves and measures, with so many rays by brute force and primary rays along an edge. */
static inline void compare_measure(const compare_settings *c, comparison *s, const world *w,
                                   unsigned chosen, int rounds, int edge, size_t by_brute)
{
    bool quick = c->o->quick;
    compare_begin(s, w, chosen, c->most_bytes, quick || world_size(w) > 30000 ? 1 : rounds);
    compare_rays(s, whole_view, quick ? 12 : edge, c->o->seed);
    end_if_wrong(compare_prove(s, quick ? 200 : by_brute, c->o->seed, stdout));
    cost_measure(s, quick ? 1 : rounds);
}

/* A table of its own, and its part of all others. */
static inline void compare_world(const compare_settings *c, const world *w, bool alone,
                                 compare_results *r)
{
    comparison s;
    char title[160];
    if (alone) compare_measure(c, &s, w, c->chosen, 5, c->large ? 256 : 96, 2400);
    else compare_measure(c, &s, w, c->chosen, 1, 32, 400);
    snprintf(title, sizeof title, "%.60s: %zu shapes; %zu rays proved equal, %zu by brute force",
             w->name, world_size(w), s.proved, s.by_brute);
    if (alone) cost_table(c->o, &s, title), printf("\n");
    fflush(stdout);
    cost_csv(&r->csv, &s);
    summary_add(&r->summary, &s);
    int place = chart_panel(&r->bars, w->name);
    for (int k = 0; k < s.entries; k++) {
        const compare_entry *e = &s.entry[k];
        if (e->c != &brute_contender)
            chart_bar(&r->bars, place, e->c->name, e->s ? cost_mean(&s, e) * 1e9 : 0,
                      per(e->build * 1e9, s.x.n));
    }
    compare_end(&s);
}

static inline void draw_pictures(const compare_settings *c)
{
    const options *o = c->o;
    world w;
    failure f;
    image im = image_new(o->width, o->height);
    bool whole = sheet_draw(o, &im);
    output_picture(o, &im, "17_compare.png", true, whole);
    image_free(&im);
    if (o->out) return;
    if (!scene_world(scene_find("teapot"), o->quick ? 3 : 12, &w, &f)) fail(f);
    im = image_new(o->width, o->width / 2 + 1);
    whole = visits_draw(o, &w, c->chosen & ~1u, c->most_bytes, &im);
    output_picture(o, &im, "17_compare_visits.png", false, whole);
    image_free(&im);
    world_free(&w);
}

/* The world of --mesh or of scene k; false: not wanted. */
static inline bool world_wanted(const compare_settings *c, const compare_options *own, int k,
                                world *w)
{
    failure f;
    mesh m;
    const compare_sizes *s = &scene_list[k];
    const generator *g = scene_find(s->name);
    if (own->mesh) {
        if (k > 0) return false;
        if (!obj_read(own->mesh, &m, &f) || !mesh_world(w, own->mesh, m, false, &f)) fail(f);
        return true;
    }
    bool few = !c->o->full && !own->verify && !own->files.rays && !own->scene && !c->large;
    if (own->scene ? strcmp(own->scene, s->name) != 0 : few && !s->shown) return false;
    if (!own->scene && own->files.rays && strcmp(s->name, "teapot") != 0) return false;
    int scale = own->scale >= 0 ? own->scale : c->o->quick ? s->quick : c->large ? s->large
                : few ? s->shown : g->scale;
    if (!scene_world(g, scale, w, &f)) fail(f);
    return true;
}

/* The notes' own algorithms beside the fastest full tree, on a small soup. */
static inline void compare_first(const compare_settings *c)
{
    const options *o = c->o;
    unsigned firsts = ((1u << contenders) - 1) & ~((1u << full_contenders) - 1);
    world w;
    comparison s;
    failure f;
    char title[160];
    if (!scene_world(scene_find("soup"), o->quick ? 1 : 4, &w, &f)) fail(f);
    compare_measure(c, &s, &w, firsts | 1u << contender_number(&bvh_contender), 3, 64, 2400);
    snprintf(title, sizeof title, "The first versions: soup of %zu triangles", world_size(&w));
    cost_table(o, &s, title);
    printf("\n");
    compare_end(&s), world_free(&w);
}

/* What only all scenes together tell. */
static inline void compare_all(const compare_settings *c, const compare_options *own,
                               compare_results *r)
{
    struct rusage u;
    const options *o = c->o;
    if (!o->full && !c->large) {
        summary_few(o, &r->summary);
        return;
    }
    summary_print(o, &r->summary);
    if (!own->only) compare_first(c);
    end_if_wrong(growth_run(o, c->chosen, c->most_bytes, c->large));
    output_chart(o, &r->bars, "17_compare_time.svg");
    if (!o->quick && getrusage(RUSAGE_SELF, &u) == 0)
        printf("# most memory held by the program: %.0f MB\n", (double)u.ru_maxrss / 1024);
}

static inline void compare_run(compare_settings settings, const compare_options *own)
{
    const compare_settings *c = &settings;
    const options *o = c->o;
    bool all = !own->scene && !own->mesh, rays = own->files.rays;
    bool measured = !rays && !own->verify, alone = !all || o->full || c->large;
    world w;
    if (all && measured) draw_pictures(c);
    if (measured && !alone && !own->only)  /* eight rows; least missed is bvh-morton */
        settings.chosen &= ~(1u << contender_number(&bvh_morton_contender));
    compare_results r = {table_new("17_compare", cost_columns), {.chosen = c->chosen},
                         chart_new("What a ray costs, and what building costs")};
    for (int k = 0; k < scenes && !(all && o->out); k++) {
        if (!world_wanted(c, own, k, &w)) continue;
        if (rays) file_run(c, &w, &own->files);
        else if (own->verify) verify_world(c, &w);
        else compare_world(c, &w, alone, &r);
        world_free(&w);
    }
    measured = measured && !(all && o->out);
    if (measured && all) compare_all(c, own, &r);
    if (measured) cost_write_csv(o, &r.csv);
    else table_free(&r.csv);
    free(r.bars.value);
}

#endif
