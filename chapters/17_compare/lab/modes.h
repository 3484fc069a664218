/* modes.h: what the program does beside its tables: the protocol of the SPD, verifying, files.
 *
 *   protocol_run(c, only, scene, scale)   --protocol spd: lines that begin with `primary` and end
 *                                         with the number of hits
 *   verify_world(c, w)                    --verify: all rays by brute force, too
 *   file_run(c, w, files)                 --rays: rays of a file, and their hits to another; what
 *                                         each of them took to a third, --costs
 * c: what is common to all runs. A difference between two structures ends the program with exit 1.
 */
#ifndef COMPARE_LAB_MODES_H
#define COMPARE_LAB_MODES_H

#include "../../07_mesh/files/ray_file.h"
#include "costs.h"
#include "../../07_mesh/scenes/named.h"

typedef struct { const char *rays, *hits, *costs; bool any; } compare_files;

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

/* Hits of the first structure that fits: the others have been proved to agree. */
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
    const compare_entry *e = compare_any(&s);
    hit *h = allocate(all.n, sizeof *h);
    e->c->search(e->s, all.r, all.n, file->any, h);
    if (file->hits && !hits_write(file->hits, h, all.n, file->any, &f)) fail(f);
    if (file->costs) file_costs(&s, file, &all, h);
    free(h), rays_free(&some);
    compare_end(&s);
}

#endif
