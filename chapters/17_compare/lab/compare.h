/* compare.h: the structures on one scene: built, asked, and proved to give the same answers.
 *
 *   compare_begin(&s, &w, &chosen, most_bytes, rounds)   builds all that are chosen, each up to
 *                          `rounds` times, until a quarter of a second has passed; all together
 *                          hold at most most_bytes
 *   compare_rays(&s, n, seed)                            the four kinds of rays, n of each if there
 *                          are so many; or s.share of n
 *   if (!compare_prove(&s, most, brute_rays, seed, stdout)) exit(1);
 *   compare_end(&s)        the world stays the caller's; numbers stay, for tables and plots
 *
 * Kinds: primary (主光线), from the eye; from their hits on shadow (阴影光线), to each light that the
 * surface faces: is anything between? diffuse (漫反射), by the cosine law; mirror (镜面反射). These
 * begin off the surface, by 1e-4 of their distance from the eye, on the side that it sees.
 *
 * A proof (证明) by trial: every structure gives the same hit and the same "occluded" for up to
 * `most` rays of every kind; brute force gives it, too, for `brute_rays` or a few more of them,
 * half of which are aimed where shapes end; those are asked again, ending exactly at their hits
 * (proof.h); and so for an eighth as many whose directions are very long or short. The first ray
 * that differs is explained, and the answer is false.
 *
 * share: no structure parts triangles that lie in one place, and each ray asks them all. So a few
 * aimed rays tell how many steps and tests a ray takes, the mean of all but the slowest; where it
 * is more than compare_usual_work all have fewer rays, share times as many, but compare_least.
 *
 * Times are those that this thread had a processor for: other work of the machine counts little.
 */
#ifndef COMPARE_LAB_COMPARE_H
#define COMPARE_LAB_COMPARE_H

#include "../../09_aabb/trials/borders.h"
#include "html.h"
#include "knobs.h"
#include "proof.h"

typedef enum { KIND_PRIMARY, KIND_SHADOW, KIND_DIFFUSE, KIND_MIRROR, compare_kinds } compare_kind;
static const char *const kind_name[compare_kinds] = {"primary", "shadow", "diffuse", "mirror"};
/* Needles take 1200 steps and tests in the mean of all; no other scene a tenth of it. */
enum { compare_usual_rays = 20000, compare_sample = 64, compare_least = 64,
       compare_usual_work = 2000 };

/* What is common to all that a run does. */
typedef struct {
    const options *o;
    line_up chosen;
    size_t most_bytes;     /* that all structures may hold together, while they are built, too */
    html_report *to;
} compare_settings;

typedef struct {
    const compare_choice *choice;
    const contender *c;
    void *s;                      /* NULL: it does not fit, or compare_end was */
    bool fits;
    failure why;                  /* it does not */
    double build;                 /* seconds, the median */
    structure_stats stats;
    search_work work[compare_kinds];
    size_t counted[compare_kinds];    /* rays that this work is of */
    size_t rays[compare_kinds], hits[compare_kinds];
    double seconds[compare_kinds];    /* of so many rays: the median */
    double spread[compare_kinds];     /* half the way between its quartiles, over the median */
    size_t wrong[2], held[2];     /* of a first version: hits unlike brute force's, of so many: */
                                  /* of rays aimed at borders, or begun there; of all others */
} compare_entry;

/* All that was measured on a scene. compare_end leaves the numbers: tables, chart and plots are
 * made of them. Entry k is choice k of the line-up. */
typedef struct {
    char name[80];
    const world *w;
    scene scene;
    items x;
    compare_entry entry[compare_most];
    int entries;
    double work, share;           /* of an aimed ray; (0, 1], of the rays that are wanted */
    ray_set rays[compare_kinds];
    size_t proved, by_brute;      /* rays */
} comparison;

/* ---------------------------------------------------------------------------------------------- */

static inline ray_set rays_view(const world *w, int edge)
{
    ray_set s = {allocate((size_t)edge * (size_t)edge, sizeof(ray)), 0};
    for (int k = 0; k < edge * edge; k++) {
        real x = ((real)(k % edge) + (real)0.5) / (real)edge;
        real y = ((real)(k / edge) + (real)0.5) / (real)edge;
        s.r[s.n++] = world_ray(w, 2 * x - 1, 1 - 2 * y);
    }
    return s;
}

static inline ray_set rays_on(const world *w, compare_kind kind, const ray_set *eye,
                              const hit *hits, uint64_t seed)
{
    size_t each = kind == KIND_SHADOW ? (size_t)w->lights : 1;
    ray_set s = {allocate(eye->n * each, sizeof(ray)), 0};
    for (size_t i = 0; i < eye->n; i++) {
        random_stream g = random_start(seed, i, 0);
        if (hits[i].shape == no_shape) continue;
        vec3 d = eye->r[i].d, n = world_normal(w, hits[i], ray_at(eye->r[i], hits[i].t));
        vec3 p = leave_surface(eye->r[i], hits[i].t, &n);
        for (int k = 0; k < w->lights && kind == KIND_SHADOW; k++)
            if (vdot(n, vsub(w->light[k], p)) > 0) s.r[s.n++] = ray_between(p, w->light[k]);
        if (kind == KIND_DIFFUSE) s.r[s.n++] = ray_from(p, diffuse_direction(n, &g));
        if (kind == KIND_MIRROR) s.r[s.n++] = ray_from(p, vmadd(d, n, -2 * vdot(d, n)));
    }
    return s;
}

static inline bool entry_counts(const compare_entry *e)
{
    return e->fits && contender_counts(e->c);
}

/* Steps and tests of some rays, added to w; how many hit. */
static inline size_t entry_work(const compare_entry *e, const ray_set *rays, bool any,
                                search_work *w)
{
    size_t hits = 0;
    hit h;
    for (size_t i = 0; i < rays->n; i++) hits += e->c->counted(e->s, rays->r[i], any, &h, w);
    return hits;
}

/* Of this thread, on a processor. */
static inline double work_seconds(void) { return clock_of(CLOCK_THREAD_CPUTIME_ID); }

static inline void entry_build(compare_entry *e, const items *x, size_t most_bytes, int rounds)
{
    double seconds[9], begin = work_seconds();
    int done = 0;
    do {
        contender_free(e->c, e->s);
        double start = work_seconds();
        e->s = contender_build(e->c, &e->choice->how, x, most_bytes, &e->why);
        seconds[done++] = work_seconds() - start;
    } while (e->s && done < rounds && !getenv("BENCH_ONCE") && work_seconds() - begin < 0.25);
    e->build = clock_median(seconds, done);
    e->fits = e->s != NULL;
    if (e->fits) e->stats = e->c->stats(e->s);
}

/* On a terminal: who is at work, and on what. A later line takes its place; what NULL: erases. */
static inline void compare_progress(const char *where, const char *what, const char *who)
{
    if (!isatty(STDERR_FILENO)) return;
    if (what) fprintf(stderr, "\r%s: %s: %s %s \033[K", program_name, where, what, who);
    else fprintf(stderr, "\r\033[K");
}

/* One after the other: each may take what those before it have left. rounds [1, 9]. */
static inline void compare_begin(comparison *s, const world *w, const line_up *chosen,
                                 size_t most_bytes, int rounds)
{
    *s = (comparison){.w = w, .scene = world_scene(w), .share = 1};
    snprintf(s->name, sizeof s->name, "%.79s", w->name);
    s->x = w->n ? items_of_scene(&s->scene) : items_of_mesh(&w->mesh);
    for (; s->entries < chosen->n; s->entries++) {
        compare_entry *e = &s->entry[s->entries];
        e->choice = &chosen->of[s->entries], e->c = e->choice->c;
        if (e->choice->out) continue;
        compare_progress(w->name, "building", e->c->name);
        entry_build(e, &s->x, most_bytes, rounds);
        most_bytes -= e->stats.bytes < most_bytes ? e->stats.bytes : most_bytes;
    }
    compare_progress(w->name, NULL, NULL);
}

static inline void compare_end(comparison *s)
{
    for (compare_entry *e = s->entry; e < s->entry + s->entries; e++)
        contender_free(e->c, e->s), e->s = NULL;
    for (int k = 0; k < compare_kinds; k++) free(s->rays[k].r), s->rays[k].r = NULL;  /* n stays */
}

/* For things on the way: the eight wide tree, which is quick everywhere, or the BVH; or the first
 * that fits, brute force and the first versions last. NULL: none does. */
static inline const compare_entry *compare_any(const comparison *s)
{
    const compare_entry *best = NULL;
    int least = 5;
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++) {
        int rank = e->c == &wide_contender ? 0 : e->c == &bvh_contender ? 1
                   : contender_counts(e->c) ? 2 : e->c == &brute_contender ? 3 : 4;
        if (e->s && rank < least) best = e, least = rank;
    }
    return best;
}

/* Every so manieth ray of a set. */
static inline ray_set rays_some(const ray_set *all, size_t most)
{
    size_t n = all->n < most ? all->n : most;
    ray_set s = {allocate(n, sizeof(ray)), n};
    for (size_t i = 0; i < n; i++) s.r[i] = all->r[i * all->n / n];
    return s;
}

/* The sets of rays that begin where primary ones end; the least of their numbers. */
static inline size_t compare_rays_on(comparison *s, ray_set *eye, uint64_t seed)
{
    const compare_entry *e = compare_any(s);
    hit *h = allocate(eye->n, sizeof *h);
    for (size_t i = 0; i < eye->n; i++) h[i] = hit_none;
    if (e) e->c->search(e->s, eye->r, eye->n, false, h);
    for (compare_kind k = KIND_SHADOW; k < compare_kinds; k++) {
        rays_free(&s->rays[k]);
        s->rays[k] = rays_on(s->w, k, eye, h, seed);
    }
    free(h);
    size_t shadow = s->rays[KIND_SHADOW].n, diffuse = s->rays[KIND_DIFFUSE].n;
    return shadow < diffuse ? shadow : diffuse;
}

/* Brute force and first versions are not asked: they would take as many anywhere. */
static inline void compare_weigh(comparison *s, uint64_t seed)
{
    double sum = 0, most = 0;
    int n = 0;
    ray_set some = rays_aimed(s->w, compare_sample, seed);
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++) {
        if (!entry_counts(e)) continue;
        search_work w = {0, 0, 0, 0};
        compare_progress(s->w->name, "weighing", e->choice->label);
        entry_work(e, &some, false, &w);
        double each = some.n ? (double)(w.nodes + w.tests) / (double)some.n : 0;
        sum += each, most = fmax(most, each), n++;
    }
    s->work = n > 1 ? (sum - most) / (n - 1) : sum;
    s->share = s->work > compare_usual_work ? compare_usual_work / s->work : 1;
    compare_progress(s->w->name, NULL, NULL);
    rays_free(&some);
}

/* Of n rays, how many this scene has: fewer where each is dear. */
static inline size_t compare_affords(const comparison *s, size_t n)
{
    if (s->share >= 1 || n <= compare_least) return n;
    size_t some = (size_t)(s->share * (double)n);
    return some > compare_least ? some : compare_least;
}

/* If there are fewer rays: how many, and why. */
static inline void compare_say_share(const comparison *s, html_report *to)
{
    if (s->share < 1)
        html_note(to, "%s: a ray at its corners takes %.2g steps and tests, the mean of "
                  "all but the slowest: %.2g times as many rays as usual, the same for all",
                  s->name, s->work, s->share);
}

/* The picture grows, up to four times each way, until enough of its rays hit. */
static inline void compare_rays(comparison *s, size_t n, uint64_t seed)
{
    compare_weigh(s, seed);
    n = compare_affords(s, n);
    int edge = (int)ceil(sqrt((double)n)), across = edge;
    for (;;) {
        ray_set eye = rays_view(s->w, across);
        size_t least = compare_rays_on(s, &eye, seed);
        rays_free(&eye);
        if (least == 0 || least >= n || across >= 4 * edge) break;
        int wider = (int)((double)across * sqrt((double)n / (double)least)) + 1;
        across = wider < 4 * edge ? wider : 4 * edge;
    }
    s->rays[KIND_PRIMARY] = rays_view(s->w, edge);
    for (int k = 0; k < compare_kinds; k++) {
        ray_set some = rays_some(&s->rays[k], n);
        rays_free(&s->rays[k]);
        s->rays[k] = some;
    }
}

/* The proof. ----------------------------------------------------------------------------------- */

/* One entry against given hits of n rays. closed: rays that end at their hits, too. */
static inline bool prove_entry(const compare_entry *e, const items *x, const ray *r,
                               const hit *due, size_t n, bool closed, const char *oracle,
                               FILE *out)
{
    wrong_answer w;
    for (size_t i = 0; i < n; i++) {
        if (prove_closed(e->c, e->s, r[i], due[i], closed ? aimed_ways : 1, &w)) continue;
        explain_wrong(&w, x, oracle, out);
        return false;
    }
    return true;
}

/* The first versions are allowed to be wrong: counted, not explained. In large scenes, where one of
 * them is slow as brute force, of fewer rays. aimed: at borders, or begun there. */
static inline void compare_count_wrong(comparison *s, const ray_set *rays, const hit *due,
                                       bool aimed)
{
    size_t most = 4000000 / s->x.n + 64;
    for (compare_entry *e = s->entry; e < s->entry + s->entries; e++)
        for (size_t i = 0; e->s && contender_is_first(e->c) && i < rays->n && i < most; i++) {
            hit h = hit_none;
            e->c->hit(e->s, rays->r[i], &h);
            e->wrong[!aimed] += first_is_wrong(h, due[i]), e->held[!aimed]++;
        }
}

/* By the first that fits, against which the others are held; or by brute force, and first versions
 * are counted: at borders, elsewhere, or not. */
typedef enum { PROVE_ALIKE, PROVE_BORDERS, PROVE_OTHERS, PROVE_STRETCHED } prove_how;

/* All entries on some rays. */
static inline bool prove_rays(comparison *s, const ray_set *rays, prove_how how, FILE *out)
{
    bool by_brute = how != PROVE_ALIKE;
    const char *oracle = by_brute ? "brute force" : NULL;
    bool ok = true;
    hit *due = allocate(rays->n, sizeof *due);
    for (size_t i = 0; i < rays->n; i++) {
        due[i] = hit_none;
        if (by_brute) items_hit(&s->x, rays->r[i], &due[i]);
    }
    for (const compare_entry *e = s->entry; ok && e < s->entry + s->entries; e++) {
        if (!entry_counts(e)) continue;
        if (oracle == NULL)
            oracle = e->c->name, e->c->search(e->s, rays->r, rays->n, false, due);
        compare_progress(s->w->name, "proving", e->c->name);
        ok = prove_entry(e, &s->x, rays->r, due, rays->n, by_brute, oracle, out);
    }
    if (how == PROVE_BORDERS || how == PROVE_OTHERS)
        compare_count_wrong(s, rays, due, how == PROVE_BORDERS);
    compare_progress(s->w->name, NULL, NULL);
    free(due);
    return ok;
}

/* n rays with long and short directions, re-aimed at what they hit: so that t is a power of two in
 * many, and no rounding of t to float hides a comparison that is strict. */
static inline bool prove_stretched(comparison *s, size_t n, uint64_t seed, FILE *out)
{
    ray_set rays = rays_aimed(s->w, n, seed + 1);
    for (size_t i = 0; i < n; i++) {
        ray *r = &rays.r[i];
        hit h = hit_none;
        if (items_hit(&s->x, *r, &h)) r->d = vsub(ray_at(*r, h.t), r->o);
    }
    rays_stretch(&rays);
    bool ok = prove_rays(s, &rays, PROVE_STRETCHED, out);
    s->proved += n, s->by_brute += n;
    rays_free(&rays);
    return ok;
}

static inline bool compare_prove(comparison *s, size_t most, size_t brute_rays, uint64_t seed,
                                 FILE *out)
{
    most = compare_affords(s, most), brute_rays = compare_affords(s, brute_rays);
    ray_set extra[2] = {rays_aimed(s->w, brute_rays / 2, seed),
                        rays_everywhere(s->w, brute_rays / 4, seed)};
    bool ok = prove_stretched(s, brute_rays / 8, seed, out);
    for (int k = 0; k < 2; k++) {
        ok = ok && prove_rays(s, &extra[k], PROVE_BORDERS, out);
        s->proved += extra[k].n, s->by_brute += extra[k].n;
        rays_free(&extra[k]);
    }
    int fit = 0;  /* one alone has only brute force to agree with */
    for (int k = 0; k < s->entries; k++) fit += entry_counts(&s->entry[k]);
    for (int k = 0; ok && k < compare_kinds; k++) {
        ray_set some = rays_some(&s->rays[k], brute_rays / 4 / compare_kinds + 1);
        ray_set more = rays_some(&s->rays[k], most);
        ok = prove_rays(s, &some, PROVE_OTHERS, out)
             && (some.n == s->rays[k].n || prove_rays(s, &more, PROVE_ALIKE, out));
        s->proved += fit > 1 && more.n > some.n ? more.n : some.n, s->by_brute += some.n;
        rays_free(&some), rays_free(&more);
    }
    if (fit == 0) s->proved = s->by_brute = 0;
    return ok;
}

#endif
