/* bench.h: acceleration structures on the same items and the same equal rays: what each costs.
 *
 *   trial_scene s;                                        must stay where it is: s.x points into it
 *   trial_scene_of(teapot_mesh(8), &s);                   takes the mesh; no rays yet
 *   s.rays[TRIAL_PRIMARY] = rays_primary(camera, 160, 100);                rays of your own, or:
 *   trial_rays(&s, camera, 160, 100, 1000, seed, &v, &how);   primary ones; diffuse ones from where
 *                                     they hit, as v finds it; 1000 at corners, and what is due
 *   trial_row row[] = {{.name = "middle", .verbs = &v, .how = &how}, ..};
 *   trials_run(row, n, &s, 5);        builds, counts, compares with brute force; then all in
 *                                     turn, 5 rounds and one to warm up, for each kind of rays
 *   table t = trial_table("..", row, n, &s, o.full, NULL);     a row each, and one of brute force
 *   trial_end(row, n), trial_scene_free(&s);
 *
 *   TRIAL_VERBS(kdtree, kdtree, kdtree_hit, kdtree_hit_counted)   makes kdtree_trial, trial_verbs
 *                                     of a structure that has the verbs of structure.h
 *   TRIAL_OTHER(naive, kdtree, kdtree, kdtree_hit_naive)           makes naive_trial, of another
 *                                     search of the same structure; its work is not counted
 *   TRIAL_FIRST(first_bvh, build)     makes first_bvh_trial, of a first.h; its hits count as wrong
 *                                     where first_is_wrong (07) says so
 *
 * Kinds of rays (survey.h): primary, diffuse, uniform; corners only judge, and are not timed.
 */
#ifndef TRIALS_BENCH_H
#define TRIALS_BENCH_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/table.h"
#include "../../../common/parallel.h"
#include "../../07_mesh/scenes/as_first.h"
#include "../../07_mesh/scenes/camera_of.h"
#include "../items.h"
#include "survey.h"

typedef enum { TRIAL_PRIMARY, TRIAL_DIFFUSE, TRIAL_UNIFORM, TRIAL_CORNERS, trial_kinds }
    trial_rays_kind;
static const char *const trial_kind_name[trial_kinds] = {"primary", "diffuse", "uniform",
                                                         "corners"};

typedef struct {
    mesh m;                      /* or */
    shape *shapes;               /* from malloc */
    scene s;
    items x;
    ray_set rays[trial_kinds];
    hit *due;                    /* of the corners, by brute force; NULL: not asked yet */
    double brute;                /* seconds a ray */
} trial_scene;

typedef struct {
    size_t size;                 /* of what is built [bytes] */
    bool (*build)(const trial_scene *s, const void *how, void *out, failure *f);
    bool (*hit)(const void *b, ray r, hit *out);
    bool (*hit_counted)(const void *b, ray r, hit *out, search_work *w);  /* NULL: nobody counts */
    size_t (*search)(const void *b, const ray_set *rays, size_t step);  /* hits; inlined */
    structure_stats (*stats)(const void *b);                              /* NULL: likewise */
    void (*free)(void *b);
    bool first;                  /* of a first.h: counts tests only, and rounds otherwise */
} trial_verbs;

typedef struct {
    const char *name;
    const trial_verbs *verbs;
    const void *how;             /* its options */
    bool again;                  /* searches what the row before has built */
    size_t step;                 /* is slow: asks every step-th ray only; 0 is 1 */
    void *built;                 /* from here on: out */
    double build;                /* seconds */
    structure_stats stats;
    size_t wrong;                /* hits at corners that are not due */
    struct { search_work work; size_t n; double seconds, spread; } ray[trial_kinds];  /* n rays */
} trial_row;

/* Columns of a chapter's own, behind those of size: names with | before each, and their cells. */
typedef struct { const char *names; void (*cells)(table *t, const trial_row *r); } trial_columns;

#define TRIAL_SEARCH(id, X, search)                                                              \
    static bool id##_trial_hit(const void *b, ray r, hit *out)                                   \
    {                                                                                            \
        return search((const X *)b, r, out);                                                     \
    }                                                                                            \
    static size_t id##_trial_search(const void *b, const ray_set *rays, size_t step)             \
    {                                                                                            \
        size_t hits = 0;                                                                         \
        hit h;                                                                                   \
        for (size_t i = 0; i < rays->n; i += step)                                               \
            hits += search((const X *)b, rays->r[i], &h);                                        \
        return hits;                                                                             \
    }

#define TRIAL_COMMON(id, X, counted)                                                             \
    static bool id##_trial_build(const trial_scene *s, const void *how, void *out, failure *f)   \
    {                                                                                            \
        return X##_build(&s->x, *(const X##_options *)how, (X *)out, f);                         \
    }                                                                                            \
    static bool id##_trial_counted(const void *b, ray r, hit *out, search_work *w)               \
    {                                                                                            \
        return counted((const X *)b, r, out, w);                                                 \
    }                                                                                            \
    static structure_stats id##_trial_stats(const void *b) { return X##_stats((const X *)b); }   \
    static void id##_trial_free(void *b) { X##_free((X *)b); }

#define TRIAL_VERBS(id, X, search, counted)                                                      \
    TRIAL_SEARCH(id, X, search)                                                                  \
    TRIAL_COMMON(id, X, counted)                                                                 \
    static const trial_verbs id##_trial = {sizeof(X), id##_trial_build, id##_trial_hit,          \
                                           id##_trial_counted, id##_trial_search,                \
                                           id##_trial_stats, id##_trial_free, false};

/* The structure of `base`, searched in another way. */
#define TRIAL_OTHER(id, base, X, search)                                                         \
    TRIAL_SEARCH(id, X, search)                                                                  \
    static const trial_verbs id##_trial = {sizeof(X), base##_trial_build, id##_trial_hit, NULL,  \
                                           id##_trial_search, base##_trial_stats,                \
                                           base##_trial_free, false};

/* build: statements that build b->s from b->m, in the way that *(const bool *)how may choose. */
#define TRIAL_FIRST(X, building)                                                                 \
    typedef struct { first_mesh m; X s; } X##_trial_of;                                          \
    static bool X##_trial_build(const trial_scene *s, const void *how, void *out, failure *f)    \
    {                                                                                            \
        X##_trial_of *b = out;                                                                   \
        (void)f, (void)how;                                                                      \
        b->m = first_mesh_of(&s->m);                                                             \
        building;                                                                                \
        return true;                                                                             \
    }                                                                                            \
    static bool X##_trial_one(const X##_trial_of *b, ray r, hit *out)                            \
    {                                                                                            \
        return X##_hit(&b->s, r, out);                                                           \
    }                                                                                            \
    TRIAL_SEARCH(X, X##_trial_of, X##_trial_one)                                                 \
    static bool X##_trial_counted(const void *b, ray r, hit *out, search_work *w)                \
    {                                                                                            \
        long before = first_tests;                                                               \
        bool found = X##_trial_hit(b, r, out);                                                   \
        w->tests += (size_t)(first_tests - before);                                              \
        return found;                                                                            \
    }                                                                                            \
    static void X##_trial_free(void *built)                                                      \
    {                                                                                            \
        X##_trial_of *b = built;                                                                 \
        X##_free(&b->s), first_mesh_free(&b->m);                                                 \
    }                                                                                            \
    static const trial_verbs X##_trial = {sizeof(X##_trial_of), X##_trial_build, X##_trial_hit,  \
                                          X##_trial_counted, X##_trial_search, NULL,             \
                                          X##_trial_free, true};

/* ---------------------------------------------------------------------------------------------- */

static inline double trial_per(double x, size_t n) { return n ? x / (double)n : 0; }

static inline void trial_scene_of(mesh m, trial_scene *out)
{
    *out = (trial_scene){.m = m};
    out->x = items_of_mesh(&out->m);
}

static inline void trial_scene_of_shapes(shape *shapes, size_t n, trial_scene *out)
{
    *out = (trial_scene){.shapes = shapes, .s = {shapes, n}};
    out->x = items_of_scene(&out->s);
}

static inline void trial_scene_free(trial_scene *s)
{
    for (int k = 0; k < trial_kinds; k++) rays_free(&s->rays[k]);
    mesh_free(&s->m), free(s->shapes), free(s->due);
    *s = (trial_scene){.shapes = NULL};
}

static inline void trial_build(trial_row *r, const trial_scene *s)
{
    failure f;
    r->built = allocate(1, r->verbs->size);
    if (!r->verbs->build(s, r->how, r->built, &f)) fail(f);
}

static inline void trial_unbuild(trial_row *r)
{
    if (r->built && !r->again) r->verbs->free(r->built), free(r->built);
    r->built = NULL;
}

/* Diffuse rays from where the primary ones hit, as this structure finds it. */
static inline void trial_diffuse(trial_scene *s, uint64_t seed, const trial_verbs *v,
                                 const void *how)
{
    trial_row r = {.verbs = v, .how = how};
    const ray_set *eye = &s->rays[TRIAL_PRIMARY];
    hit *h = allocate(eye->n, sizeof *h);
    trial_build(&r, s);
    for (size_t i = 0; i < eye->n; i++)
        if (!v->hit(r.built, eye->r[i], &h[i])) h[i] = hit_none;
    s->rays[TRIAL_DIFFUSE] = rays_diffuse(&s->m, eye, h, seed);
    trial_unbuild(&r);
    free(h);
}

static inline void trial_due_one(size_t i, void *context)
{
    trial_scene *s = context;
    s->due[i] = hit_none;
    items_hit(&s->x, s->rays[TRIAL_CORNERS].r[i], &s->due[i]);
}

/* The hits at corners by brute force: by all threads, or by one, which gives the time of a ray. */
static inline void trial_due(trial_scene *s, bool timed)
{
    size_t n = s->rays[TRIAL_CORNERS].n;
    free(s->due);
    s->due = allocate(n, sizeof *s->due);
    double start = clock_seconds();
    if (timed) for (size_t i = 0; i < n; i++) trial_due_one(i, s);
    else parallel_for(n, 0, "brute force", trial_due_one, s);
    s->brute = timed ? trial_per(clock_seconds() - start, n) : 0;
}

static inline void trial_rays(trial_scene *s, camera c, int width, int height, size_t corners,
                              uint64_t seed, const trial_verbs *v, const void *how)
{
    s->rays[TRIAL_PRIMARY] = rays_primary(c, width, height);
    trial_diffuse(s, seed, v, how);
    s->rays[TRIAL_CORNERS] = rays_corners(&s->m, c.e, corners, seed);
    trial_due(s, true);
}

/* The box of a mesh as a camera sees it; z is up. */
static inline camera trial_camera(const mesh *m, real aspect)
{
    vec3 lo, hi;
    mesh_bounds(m, &lo, &hi);
    return camera_of(lo, hi, true, aspect);
}

static inline size_t trial_wrong(const trial_row *r, const trial_scene *s)
{
    const ray_set *rays = &s->rays[TRIAL_CORNERS];
    size_t wrong = 0;
    for (size_t i = 0; i < rays->n; i++) {
        hit h = hit_none, d = s->due[i];
        r->verbs->hit(r->built, rays->r[i], &h);
        wrong += r->verbs->first ? first_is_wrong(h, d)
                 : h.t != d.t || h.shape != d.shape || h.u != d.u || h.v != d.v;
    }
    return wrong;
}

static inline search_work trial_work(const trial_row *r, const ray_set *rays, size_t step)
{
    search_work w = {0, 0, 0, 0};
    hit h;
    for (size_t i = 0; r->verbs->hit_counted && i < rays->n; i += step)
        r->verbs->hit_counted(r->built, rays->r[i], &h, &w);
    return w;
}

/* A kind of rays, searched by one structure. */
typedef struct { const trial_row *r; const ray_set *rays; } trial_pass;

static inline double trial_pass_run(void *pass)
{
    const trial_pass *p = pass;
    return (double)p->r->verbs->search(p->r->built, p->rays, p->r->step ? p->r->step : 1);
}

static inline void trial_search(trial_row *row, int n, const trial_scene *s, trial_rays_kind kind,
                                int rounds)
{
    const ray_set *rays = &s->rays[kind];
    trial_pass *pass = allocate((size_t)n, sizeof *pass);
    bench_candidate *c = allocate((size_t)n, sizeof *c);
    for (int i = 0; i < n; i++) {
        size_t step = row[i].step ? row[i].step : 1;
        pass[i] = (trial_pass){&row[i], rays};
        c[i] = (bench_candidate){row[i].name, trial_pass_run, &pass[i], 0, 0};
        row[i].ray[kind].work = trial_work(&row[i], rays, step);
        row[i].ray[kind].n = (rays->n + step - 1) / step;
    }
    bench_time(c, n, rounds);
    for (int i = 0; i < n; i++)
        row[i].ray[kind].seconds = c[i].seconds, row[i].ray[kind].spread = c[i].spread;
    free(pass), free(c);
}

/* Builds up to `most` times, while a quarter of a second lasts; the median. */
static inline void trial_time_build(trial_row *r, const trial_scene *s, int most)
{
    double seconds[9], begin = clock_seconds();
    int done = 0;
    do {
        trial_unbuild(r);
        double start = clock_seconds();
        trial_build(r, s);
        seconds[done++] = clock_seconds() - start;
    } while (done < most && done < 9 && clock_seconds() - begin < 0.25);
    r->build = clock_median(seconds, done);
}

/* rounds [at least 1; from 5 on they build again, too]. What is built stays until trial_end. */
static inline void trials_run(trial_row *row, int n, const trial_scene *s, int rounds)
{
    for (int i = 0; i < n; i++) {
        if (i > 0 && row[i].again) row[i].built = row[i - 1].built, row[i].build = row[i - 1].build;
        else trial_time_build(&row[i], s, rounds < 5 ? 1 : rounds);
        if (row[i].verbs->stats) row[i].stats = row[i].verbs->stats(row[i].built);
        if (s->due) row[i].wrong = trial_wrong(&row[i], s);
    }
    for (int k = 0; k < TRIAL_CORNERS; k++)
        if (s->rays[k].n) trial_search(row, n, s, (trial_rays_kind)k, rounds);
}

static inline void trial_end(trial_row *row, int n)
{
    for (int i = n; i-- > 0;) trial_unbuild(&row[i]);
}

/* Work of all kinds that were timed, and how many rays these were. */
static inline search_work trial_sum(const trial_row *r, size_t *rays)
{
    search_work w = {0, 0, 0, 0};
    *rays = 0;
    for (int k = 0; k < TRIAL_CORNERS; k++) {
        w.nodes += r->ray[k].work.nodes, w.leaves += r->ray[k].work.leaves;
        w.tests += r->ray[k].work.tests, *rays += r->ray[k].n;
    }
    return w;
}

static inline double trial_ns(const trial_row *r, trial_rays_kind k)
{
    return trial_per(r->ray[k].seconds * 1e9, r->ray[k].n);
}

/* A number, or "-" where nobody knows. */
static inline void trial_cell(table *t, bool known, double x)
{
    if (known) table_number(t, x);
    else table_text(t, "-");
}

/* In six columns of two kinds of rays only the second has room. */
static inline bool trial_shown(const trial_scene *s, int kind, bool full)
{
    return s->rays[kind].n && (full || kind != TRIAL_PRIMARY || !s->rays[TRIAL_DIFFUSE].n);
}

static inline void trial_cells(table *t, const trial_row *r, const trial_scene *s, bool full,
                               const trial_columns *own)
{
    const structure_stats *st = &r->stats;
    bool known = r->verbs->stats != NULL, counted = r->verbs->hit_counted && !r->verbs->first;
    double spread = 0;
    size_t rays;
    search_work w = trial_sum(r, &rays);
    table_text(t, "%s", r->name), table_number(t, r->build * 1e3);
    trial_cell(t, known, trial_per((double)st->bytes, st->items));
    if (full) {
        trial_cell(t, known, trial_per((double)st->peak, st->items));
        trial_cell(t, known, st->depth);
        trial_cell(t, known, trial_per((double)st->references, st->items));
        if (own && r->verbs->first)
            for (const char *c = own->names; *c; c++) *c == '|' ? table_text(t, "-") : (void)0;
        else if (own) own->cells(t, r);
        trial_cell(t, counted, trial_per((double)w.nodes, rays));
        trial_cell(t, counted, trial_per((double)w.leaves, rays));
    }
    trial_cell(t, r->verbs->hit_counted != NULL, trial_per((double)w.tests, rays));
    table_count(t, r->wrong);
    for (int k = 0; k < TRIAL_CORNERS; k++) {
        if (!trial_shown(s, k, full)) continue;
        table_number(t, trial_ns(r, (trial_rays_kind)k));
        spread = fmax(spread, r->ray[k].spread);
    }
    if (full) table_number(t, 100 * spread);
}

/* Not full: six columns. The title is not copied. */
static inline table trial_table(const char *title, const trial_row *row, int n,
                                const trial_scene *s, bool full, const trial_columns *own)
{
    char names[600];
    int at = snprintf(names, sizeof names, "structure|time build [ms]|memory [B/item]%s%s%s"
                      "|tests/ray|error [wrong]", full ? "|peak [B/item]|depth|refs/item" : "",
                      full && own ? own->names : "", full ? "|nodes/ray|leaves/ray" : "");
    for (int k = 0; k < TRIAL_CORNERS; k++)
        if (trial_shown(s, k, full))
            at += snprintf(names + at, sizeof names - (size_t)at, "|time %s [ns]",
                           trial_kind_name[k]);
    snprintf(names + at, sizeof names - (size_t)at, "%s", full ? "|time spread [%]" : "");
    table t = table_new(title, names);
    for (int i = 0; i < n; i++) trial_cells(&t, &row[i], s, full, own);
    if (s->brute <= 0) return t;
    size_t before = 0;  /* columns between the name and the tests */
    while (strncmp(t.cell[before], "tests", 5) != 0) before++;
    table_text(&t, "brute force");
    for (size_t k = 1; k < before; k++) table_text(&t, "-");
    table_number(&t, (double)s->x.n), table_count(&t, 0);
    for (int k = 0; k < TRIAL_CORNERS; k++)
        if (trial_shown(s, k, full)) table_number(&t, s->brute * 1e9);
    if (full) table_text(&t, "-");
    return t;
}

/* "65280 triangles: 16000 primary and 3881 diffuse rays, one thread; wrong of 1000 at corners" */
static inline const char *trial_title(const trial_scene *s, char room[160])
{
    snprintf(room, 160, "%zu triangles: %zu primary and %zu diffuse rays, one thread; wrong of %zu "
             "at corners", s->m.triangles, s->rays[TRIAL_PRIMARY].n, s->rays[TRIAL_DIFFUSE].n,
             s->rays[TRIAL_CORNERS].n);
    return room;
}

#endif
