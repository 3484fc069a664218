/* compare.h: the structures on one scene: built, and proved to give the same answers.
 *
 *   comparison s;
 *   compare_begin(&s, &w, chosen, most_bytes, rounds)  builds all that are chosen (bit k: number k
 *                                                     of contender_list), each up to `rounds`
 *                                                     times, until a quarter of a second has
 *                                                     passed; all together hold at most most_bytes
 *   compare_rays(&s, whole_view, edge, seed)          the four kinds of rays: kinds.h
 *   if (!compare_prove(&s, brute_rays, seed, stdout)) exit(1);
 *   compare_end(&s)                                   the world stays the caller's
 *
 * A proof (证明) by trial: every structure gives the same hit, t, u, v and shape, for every ray of
 * every kind, and the same "occluded"; brute force gives it, too, for `brute_rays` or a few more of
 * them, half of which are aimed where shapes end. The first ray that differs is explained
 * (explain.h), and the answer is false.
 *
 * Times here are those that this thread had a processor for (work_seconds), so that other work of
 * the machine counts little.
 */
#ifndef COMPARE_H
#define COMPARE_H

#include "contenders.h"
#include "kinds.h"

typedef struct {
    const contender *c;
    void *s;                      /* NULL: it does not fit; */
    failure why;                  /* and why */
    double build;                 /* seconds, the median */
    structure_stats stats;
    search_work work[compare_kinds];
    size_t rays[compare_kinds], hits[compare_kinds];
    double seconds[compare_kinds];    /* of so many rays */
    size_t wrong[2], held[2];     /* of a first version: hits unlike brute force's, of so many: */
                                  /* of rays aimed at borders, or begun there; of all others */
} compare_entry;

typedef struct {
    const world *w;
    scene scene;
    items x;
    compare_entry entry[contenders];
    int entries;
    ray_set rays[compare_kinds];
    size_t proved, by_brute;      /* rays */
} comparison;

/* ---------------------------------------------------------------------------------------------- */

/* Of this thread, on a processor. */
static inline double work_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static inline void entry_build(compare_entry *e, const items *x, size_t most_bytes, int rounds)
{
    double seconds[9], begin = work_seconds();
    int done = 0;
    do {
        contender_free(e->c, e->s);
        double start = work_seconds();
        e->s = contender_build(e->c, x, most_bytes, &e->why);
        seconds[done++] = work_seconds() - start;
    } while (e->s && done < rounds && work_seconds() - begin < 0.25);
    e->build = clock_median(seconds, done);
    if (e->s) e->stats = e->c->stats(e->s);
}

/* On a terminal: who is at work, and on what. A later line takes its place; what NULL: erases. */
static inline void compare_progress(const char *where, const char *what, const char *who)
{
    if (!isatty(STDERR_FILENO)) return;
    if (what) fprintf(stderr, "\r%s: %s: %s %s \033[K", program_name, where, what, who);
    else fprintf(stderr, "\r\033[K");
}

/* One after the other: each may take what those before it have left. */
static inline void compare_build(comparison *s, size_t most_bytes, int rounds)
{
    for (int k = 0; k < s->entries; k++) {
        compare_progress(s->w->name, "building", s->entry[k].c->name);
        entry_build(&s->entry[k], &s->x, most_bytes, rounds);
        size_t bytes = s->entry[k].stats.bytes;
        most_bytes -= bytes < most_bytes ? bytes : most_bytes;
    }
    compare_progress(s->w->name, NULL, NULL);
}

/* rounds [1, 9]. */
static inline void compare_begin(comparison *s, const world *w, unsigned chosen, size_t most_bytes,
                               int rounds)
{
    *s = (comparison){.w = w, .scene = world_scene(w)};
    s->x = w->n ? items_of_scene(&s->scene) : items_of_mesh(&w->mesh);
    for (int k = 0; k < contenders; k++)
        if (chosen >> k & 1) s->entry[s->entries++].c = contender_list[k];
    compare_build(s, most_bytes, rounds);
}

static inline void compare_end(comparison *s)
{
    for (int k = 0; k < s->entries; k++) contender_free(s->entry[k].c, s->entry[k].s);
    for (int k = 0; k < compare_kinds; k++) rays_free(&s->rays[k]);
    s->entries = 0;
}

/* The fastest there is for things on the way: the last that fits. NULL: none does. */
static inline const compare_entry *compare_any(const comparison *s)
{
    const compare_entry *first = NULL;
    for (int k = s->entries - 1; k >= 0; k--) {
        const compare_entry *e = &s->entry[k];
        if (e->s && !contender_is_first(e->c)) return e;
        if (e->s && !first) first = e;
    }
    return first;
}

static inline void compare_rays(comparison *s, const double part[4], int edge, uint64_t seed)
{
    const compare_entry *e = compare_any(s);
    ray_set eye = rays_view(s->w, part, edge);
    hit *h = allocate(eye.n, sizeof *h);
    if (e) e->c->search(e->s, eye.r, eye.n, false, h);
    s->rays[KIND_PRIMARY] = eye;
    s->rays[KIND_SHADOW] = rays_to_lights(s->w, &eye, h);
    s->rays[KIND_DIFFUSE] = rays_scattered(s->w, &eye, h, seed);
    s->rays[KIND_MIRROR] = rays_mirrored(s->w, &eye, h);
    free(h);
}

/* The proof. ----------------------------------------------------------------------------------- */

static inline void print_hit(FILE *out, const char *who, hit h)
{
    if (h.shape == no_shape) fprintf(out, "  %s: no hit\n", who);
    else fprintf(out, "  %s: t = %.17g, u = %.17g, v = %.17g, shape %u\n", who, (double)h.t,
                 (double)h.u, (double)h.v, h.shape);
}

/* due: of `oracle`. */
static inline void explain_ray(const compare_entry *e, const char *oracle, const wrong_ray *w,
                               FILE *out)
{
    const ray *r = &w->r;
    fprintf(out, "%s: wrong ray: o = (%.17g, %.17g, %.17g), d = (%.17g, %.17g, %.17g), "
                 "interval [%.17g, %.17g]\n", e->c->name, (double)r->o.x, (double)r->o.y,
            (double)r->o.z, (double)r->d.x, (double)r->d.y, (double)r->d.z, (double)r->tmin,
            (double)r->tmax);
    print_hit(out, oracle, w->due);
    if (w->occluded) fprintf(out, "  %s: occluded: %s\n", e->c->name,
                             w->got.shape == no_shape ? "no" : "yes");
    else print_hit(out, e->c->name, w->got);
    explain_window(e->s, w, out);
    if (e->c->explain && w->due.shape != no_shape) e->c->explain(e->s, w, out);
}

/* One entry against given hits of n rays: closest, and occluded. False: explained to `out`. */
static inline bool prove_entry(const compare_entry *e, const ray *r, const hit *due, size_t n,
                               const char *oracle, FILE *out)
{
    for (size_t i = 0; i < n; i++) {
        hit h = hit_none;
        e->c->hit(e->s, r[i], &h);
        wrong_ray w = {r[i], due[i], h, e->c->hit, NULL};
        if (!hits_same(h, due[i])) return explain_ray(e, oracle, &w, out), false;
        if (e->c->occluded(e->s, r[i]) == (due[i].shape != no_shape)) continue;
        w.got = due[i].shape == no_shape ? (hit){0, 0, 0, 0} : hit_none;
        w.hit = NULL, w.occluded = e->c->occluded;
        return explain_ray(e, oracle, &w, out), false;
    }
    return true;
}

/* All entries on n rays. The first that fits gives the hits that the others are held against; brute
 * force gives them if it is to. */
static inline bool prove_rays(const comparison *s, const ray *r, size_t n, bool by_brute, FILE *out)
{
    const compare_entry *first = NULL;
    const char *oracle = "brute force";
    bool ok = true;
    hit *due = allocate(n, sizeof *due);
    for (size_t i = 0; i < n; i++) {
        due[i] = hit_none;
        if (by_brute) items_hit(&s->x, r[i], &due[i]);
    }
    for (int k = 0; ok && k < s->entries; k++) {
        const compare_entry *e = &s->entry[k];
        if (!e->s || e->c == &brute_contender || contender_is_first(e->c)) continue;
        if (!first && !by_brute) {
            oracle = e->c->name;
            e->c->search(e->s, r, n, false, due);
        }
        first = first ? first : e;
        compare_progress(s->w->name, "proving", e->c->name);
        ok = prove_entry(e, r, due, n, oracle, out);
    }
    compare_progress(s->w->name, NULL, NULL);
    free(due);
    return ok;
}

/* The first versions are allowed to be wrong: counted, not explained. */
static inline void compare_count_wrong(comparison *s, const ray *r, size_t n, bool aimed)
{
    for (int k = 0; k < s->entries; k++) {
        compare_entry *e = &s->entry[k];
        for (size_t i = 0; e->s && contender_is_first(e->c) && i < n; i++) {
            hit due = hit_none, h = hit_none;
            items_hit(&s->x, r[i], &due);
            e->c->hit(e->s, r[i], &h);
            e->wrong[!aimed] += first_is_wrong(h, due), e->held[!aimed]++;
        }
    }
}

/* Those that fit, beside brute force: one alone has only that to agree with. */
static inline int compare_fit(const comparison *s)
{
    int n = 0;
    for (int k = 0; k < s->entries; k++) 
        n += s->entry[k].s && s->entry[k].c != &brute_contender
             && !contender_is_first(s->entry[k].c);
    return n;
}

/* Every so manieth ray of a set. */
static inline ray_set rays_some(const ray_set *all, size_t most)
{
    size_t n = all->n < most ? all->n : most;
    ray_set s = {allocate(n, sizeof(ray)), n};
    for (size_t i = 0; i < n; i++) s.r[i] = all->r[i * all->n / n];
    return s;
}

static inline bool compare_prove(comparison *s, size_t brute_rays, uint64_t seed, FILE *out)
{
    ray_set extra[2] = {rays_aimed(s->w, brute_rays / 2, seed),
                        rays_everywhere(s->w, brute_rays / 4, seed)};
    bool ok = true;
    for (int k = 0; k < 2; k++) {
        ok = ok && prove_rays(s, extra[k].r, extra[k].n, true, out);
        compare_count_wrong(s, extra[k].r, extra[k].n, true);
        s->proved += extra[k].n, s->by_brute += extra[k].n;
        rays_free(&extra[k]);
    }
    int fit = compare_fit(s);
    for (int k = 0; ok && k < compare_kinds; k++) {
        ray_set some = rays_some(&s->rays[k], brute_rays / 4 / compare_kinds + 1);
        ok = prove_rays(s, some.r, some.n, true, out)
             && (some.n == s->rays[k].n
                 || prove_rays(s, s->rays[k].r, s->rays[k].n, false, out));
        compare_count_wrong(s, some.r, some.n, false);
        s->proved += fit > 1 ? s->rays[k].n : some.n, s->by_brute += some.n;
        rays_free(&some);
    }
    if (fit == 0) s->proved = s->by_brute = 0;
    return ok;
}

#endif
