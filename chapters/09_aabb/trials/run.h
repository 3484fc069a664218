/* run.h: builds the structures of contender.h, finds their wrong hits, and times them in turn: the
 * work behind bench.h.
 *
 *   trial_scene_of(mesh, &s)                                   takes it
 *   trial_rays(&s, camera, width, height, corners, seed, &v, &how)   rays, as v finds hits
 *   trial_due(&s, timed)                                       brute force at the corners
 *   trials_run(row, n, &s, rounds), trial_end(row, n)
 */
#ifndef TRIALS_RUN_H
#define TRIALS_RUN_H

#include "../../../common/lab/bench.h"
#include "../../../common/parallel.h"
#include "../../07_mesh/scenes/camera_of.h"
#include "contender.h"

/* ---------------------------------------------------------------------------------------------- */

static inline double trial_per(double x, size_t n) { return n ? x / (double)n : 0; }

static inline void trial_scene_of(mesh m, trial_scene *out)
{
    *out = (trial_scene){.m = m};
    out->x = items_of_mesh(&out->m);
}

static inline void trial_scene_free(trial_scene *s)
{
    for (int k = 0; k < trial_kinds; k++) rays_free(&s->rays[k]);
    mesh_free(&s->m), free(s->due);
    *s = (trial_scene){.due = NULL};
}

static inline void trial_build(trial_row *r, const trial_scene *s)
{
    failure f;
    r->built = allocate(1, r->verbs->size);
    if (!r->verbs->build(s, r->how, r->built, &f)) model_fails(f);
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
    else parallel_whole(n, 0, "brute force", trial_due_one, s);
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

/* All of it, untimed: of two rows that search one tree the second would find it in the cache. */
static inline void trial_pass_warm(void *pass) { clock_kept = trial_pass_run(pass); }

static inline void trial_search(trial_row *row, int n, const trial_scene *s, trial_rays_kind kind,
                                int rounds)
{
    const ray_set *rays = &s->rays[kind];
    trial_pass *pass = allocate((size_t)n, sizeof *pass);
    bench_candidate *c = allocate((size_t)n, sizeof *c);
    for (int i = 0; i < n; i++) {
        size_t step = row[i].step ? row[i].step : 1;
        pass[i] = (trial_pass){&row[i], rays};
        c[i] = (bench_candidate){.name = row[i].name, .run = trial_pass_run, .context = &pass[i],
                                 .warm = trial_pass_warm};
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

#endif
