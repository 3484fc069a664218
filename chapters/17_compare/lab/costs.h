/* costs.h: what each structure costs on a scene: build, memory, work and time a ray.
 *
 *   cost_measure(&s, turns)         each kind of rays, all structures in turn, medians, one thread
 *   cost_kind(&s, kind, turns, most_work)   one kind; most_work: cost_full, cost_few
 *   cost_table(&s, to)              a table of the scene, and who is cheapest for how many rays
 *   cost_csv(&csv, &s)              a row a structure and kind of rays: cost_columns (Havran 2000)
 *   sweep_run(&s, to)               a table and a plot: who is on the Pareto front of building and
 *                                   searching? A point with another below and to its left is not
 *
 * A turn: all its rays, untimed, so that what they need is in the cache again, then timed. (Where
 * they take more than cost_warm steps and tests, a quarter will do: after that a grid of 100,000
 * triangles took a quarter longer.) Steps and tests are counted with that quarter. All are asked,
 * or as many as most_work steps and tests allow (of the quarter: cost_few; of who asks every shape:
 * cost_brute), which 64 of them tell. (First versions count no steps.) Who has taken a second has
 * no further turn, after three.
 * BENCH_ONCE: no turns, the times are those of counting.
 */
#ifndef COMPARE_LAB_COSTS_H
#define COMPARE_LAB_COSTS_H

#include "../../../common/lab/bench.h"
#include "compare.h"

#define cost_columns                                                                            \
    "scene|structure|kind|rays|hits|build_s|bytes|peak_bytes|inner|leaves|empty|references|depth|" \
    "nodes_per_ray|tests_per_ray|ns_per_ray"

/* ---------------------------------------------------------------------------------------------- */

static inline double per(double x, size_t n) { return n ? x / (double)n : 0; }

/* A number, or a dash where there is none. */
static inline void cost_cell(table *t, bool known, double x)
{
    if (known) table_number(t, x);
    else table_text(t, "-");
}

enum { cost_most_turns = 9, cost_sample = 64 };
/* Steps and tests: all rays of a kind; of who asks every shape; of a quick look; to warm up. */
static const double cost_full = 4e8, cost_brute = 4e7, cost_few = 2e6, cost_warm = 1e7;

/* Of one structure: its rays, the quarter, what warms it, and the seconds of its turns. */
typedef struct {
    ray_set all, quarter;
    bool warm_by_all;
    double seconds[cost_most_turns];
    int done;
} cost_turns;

/* Steps, tests and hits of some rays; seconds. */
static inline double cost_count(compare_entry *e, compare_kind kind, const ray_set *some)
{
    double start = work_seconds();
    e->work[kind] = (search_work){0, 0, 0, 0};
    e->hits[kind] = entry_work(e, some, kind == KIND_SHADOW, &e->work[kind]);
    e->counted[kind] = e->rays[kind] = some->n;
    return work_seconds() - start;
}

/* Every so manieth of n, or as many as that work allows, a ray taking `each`. */
static inline ray_set cost_rays(const ray_set *all, size_t n, double work, double each)
{
    return rays_some(all, work < each * (double)n ? (size_t)(work / each) + 1 : n);
}

/* Who asks every shape reads them in order, and is as quick after few rays. */
static inline double cost_most(const compare_entry *e, double most_work)
{
    bool every = e->c == &brute_contender || e->c == &first_mesh_contender;
    return every && most_work > cost_brute ? cost_brute : most_work;
}

static inline cost_turns cost_begin(compare_entry *e, compare_kind kind, const ray_set *rays,
                                    double most_work)
{
    cost_turns t = {.done = 0};
    ray_set some = rays_some(rays, cost_sample);
    cost_count(e, kind, &some);
    double each = per((double)(e->work[kind].nodes + e->work[kind].tests), some.n);
    t.all = cost_rays(rays, rays->n, cost_most(e, most_work), each);
    t.quarter = cost_rays(&t.all, t.all.n / 4 + 1, cost_few, each);
    t.warm_by_all = each * (double)t.all.n <= cost_warm;
    t.seconds[0] = cost_count(e, kind, &t.quarter);
    if (getenv("BENCH_ONCE")) t.seconds[t.done++] *= per((double)t.all.n, t.quarter.n);
    e->rays[kind] = t.all.n;
    rays_free(&some);
    return t;
}

static inline void cost_turn(compare_entry *e, compare_kind kind, cost_turns *t, hit *out)
{
    bool any = kind == KIND_SHADOW;
    const ray_set *warm = t->warm_by_all ? &t->all : &t->quarter;
    e->c->search(e->s, warm->r, warm->n, any, out);
    double start = work_seconds();
    e->hits[kind] = e->c->search(e->s, t->all.r, t->all.n, any, out);
    t->seconds[t->done++] = work_seconds() - start;
}

/* turns [1, 9] */
static inline void cost_kind(comparison *s, compare_kind kind, int turns, double most_work)
{
    cost_turns of[compare_most];
    hit *out = allocate(s->rays[kind].n, sizeof *out);
    compare_entry *e = s->entry;
    for (int k = 0; k < s->entries; k++) {
        compare_progress(s->w->name, "counting", e[k].choice->label);
        if (e[k].s) of[k] = cost_begin(&e[k], kind, &s->rays[kind], most_work);
    }
    for (int turn = 0; turn < turns && !getenv("BENCH_ONCE"); turn++)
        for (int k = 0; k < s->entries; k++) {
            compare_progress(s->w->name, "timing", e[k].choice->label);
            if (e[k].s && (turn < 3 || turn * of[k].seconds[0] <= 1))
                cost_turn(&e[k], kind, &of[k], out);
        }
    for (int k = 0; k < s->entries; k++) {
        cost_turns *t = &of[k];
        if (!e[k].s) continue;
        if (t->done) e[k].seconds[kind] = bench_median(t->seconds, t->done, &e[k].spread[kind]);
        rays_free(&t->all), rays_free(&t->quarter);
    }
    compare_progress(s->w->name, NULL, NULL);
    free(out);
}

static inline void cost_measure(comparison *s, int turns)
{
    for (compare_kind k = 0; k < compare_kinds; k++) cost_kind(s, k, turns, cost_full);
}

static inline double cost_ns(const compare_entry *e, int kind)
{
    return per(e->seconds[kind] * 1e9, e->rays[kind]);
}

/* Seconds a ray, every kind that was timed counting by how many of it the scene has. */
static inline double cost_mean(const comparison *s, const compare_entry *e)
{
    double sum = 0;
    size_t n = 0;
    for (int k = 0; k < compare_kinds; k++) {
        if (e->rays[k] == 0) continue;
        sum += cost_ns(e, k) * 1e-9 * (double)s->rays[k].n;
        n += s->rays[k].n;
    }
    return per(sum, n);
}

/* Steps and tests a ray, of all kinds. */
static inline void cost_work(const compare_entry *e, double *nodes, double *tests)
{
    size_t sum[2] = {0, 0}, n = 0;
    for (int k = 0; k < compare_kinds; k++)
        sum[0] += e->work[k].nodes, sum[1] += e->work[k].tests, n += e->counted[k];
    *nodes = per((double)sum[0], n), *tests = per((double)sum[1], n);
}

/* The lines build + k * ns (17.8): which is lower than that of `now`, soonest after *from rays, and
 * where? NULL: none. Three percent faster is no faster, ten percent sooner no sooner: the earlier
 * in the list is named. */
static inline const compare_entry *cost_next(const comparison *s, const compare_entry *now,
                                             double *from)
{
    const compare_entry *next = NULL;
    double since = *from, slow = cost_mean(s, now);
    *from = HUGE_VAL;
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++) {
        if (!e->fits || contender_is_first(e->c)) continue;
        double gain = slow - cost_mean(s, e), at = fmax(since, (e->build - now->build) / gain);
        if (gain > 0.03 * slow && at < 0.9 * *from) *from = at, next = e;
    }
    return next;
}

static inline void cost_cheapest(const comparison *s, html_report *to)
{
    const compare_entry *now = NULL;
    char text[4096];  /* of 48 at most: there is room */
    double from = 0;
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++) {
        if (!e->fits || contender_is_first(e->c)) continue;
        if (!now || e->build + cost_mean(s, e) < now->build + cost_mean(s, now)) now = e;
    }
    if (!now) return;
    snprintf(text, sizeof text, "cheapest in all: %s", now->choice->label);
    while ((now = cost_next(s, now, &from)) != NULL)
        text_add(text, sizeof text, ", from %.2g rays on %s", from, now->choice->label);
    html_note(to, "%s", text);
}

/* A row of cost_table. */
static inline void cost_row(table *t, const comparison *s, const compare_entry *e)
{
    structure_stats st = e->stats;
    double nodes, tests;
    cost_work(e, &nodes, &tests);
    const double cell[] = {
        per((double)st.bytes, s->x.n), (double)st.inner, (double)st.leaves, (double)st.empty,
        per((double)st.references, st.items), nodes, tests, cost_ns(e, KIND_PRIMARY),
        cost_ns(e, KIND_SHADOW), cost_ns(e, KIND_DIFFUSE), cost_ns(e, KIND_MIRROR)};
    enum { cells = sizeof cell / sizeof *cell, counted = 1, counted_end = 4, searched = 6 };
    bool known = e->fits && !contender_is_first(e->c);
    table_text(t, e->wrong[0] + e->wrong[1] ? "%s: wrong" : "%s", e->choice->label);
    if (e->fits) table_number(t, e->build * 1e3);
    else table_text(t, "does not fit");
    for (int k = 0; k < cells; k++)
        if (known && k >= counted && k < counted_end) table_count(t, (size_t)cell[k]);
        else cost_cell(t, known || (e->fits && k >= searched), cell[k]);
}

/* They go on where they are wrong: at edges their triangles slip (04). */
static inline void cost_print_wrong(const compare_entry *e, html_report *to)
{
    html_note(to, "%s: wrong at %zu of %zu rays from or to borders, at %zu of %zu others",
              e->choice->label, e->wrong[0], e->held[0], e->wrong[1], e->held[1]);
}

/* Who was asked fewer rays than the scene has of a kind, and the fewest of theirs. */
static inline void cost_say_fewer(const comparison *s, html_report *to)
{
    char text[4096] = "";
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++) {
        size_t least = SIZE_MAX;
        for (int k = 0; k < compare_kinds; k++)
            if (e->fits && e->rays[k] < s->rays[k].n && e->rays[k] < least) least = e->rays[k];
        if (least < SIZE_MAX)
            text_add(text, sizeof text, "%s %s %zu", *text ? "," : "", e->choice->label, least);
    }
    if (*text) html_note(to, "fewer rays of a kind:%s", text);
}

static inline void cost_table(const comparison *s, html_report *to)
{
    char title[160];
    snprintf(title, sizeof title, "%.60s: %zu shapes; %zu rays proved equal, %zu by brute force",
             s->name, s->x.n, s->proved, s->by_brute);
    table t = table_new(title, "structure|build [ms]|B/shape|inner|leaves|empty|refs/shape|"
                               "nodes/ray|tests/ray|primary [ns]|shadow [ns]|diffuse [ns]|"
                               "mirror [ns]");
    const compare_entry *end = s->entry + s->entries;
    for (const compare_entry *e = s->entry; e < end; e++)
        if (e->fits || !contender_is_first(e->c)) cost_row(&t, s, e);
    html_table(to, &t);
    for (const compare_entry *e = s->entry; e < end; e++) {
        bool first = contender_is_first(e->c);
        if (e->fits && first) cost_print_wrong(e, to);
        if (!e->fits && !first) html_note(to, "%s does not fit: %s", e->choice->label, e->why.text);
    }
    cost_say_fewer(s, to);
    cost_cheapest(s, to);
}

static inline void cost_csv_row(table *t, const comparison *s, const compare_entry *e,
                                const char *name, compare_kind kind)
{
    structure_stats st = e->stats;
    size_t counted = e->counted[kind];
    bool known = !contender_is_first(e->c);  /* what first versions hold nobody counts */
    const size_t count[] = {st.bytes, st.peak, st.inner, st.leaves, st.empty, st.references,
                            (size_t)st.depth};
    table_text(t, "%s", s->name), table_text(t, "%s", e->choice->label), table_text(t, "%s", name);
    table_count(t, e->fits ? e->rays[kind] : 0), table_count(t, e->hits[kind]);
    table_text(t, "%.9f", e->build);
    for (size_t k = 0; k < sizeof count / sizeof *count; k++)
        known ? table_count(t, count[k]) : table_text(t, "-");
    known ? table_text(t, "%.6g", per((double)e->work[kind].nodes, counted)) : table_text(t, "-");
    table_text(t, "%.6g", per((double)e->work[kind].tests, counted));
    table_text(t, "%.6g", cost_ns(e, (int)kind));
}

/* A structure that does not fit has a row, too: no rays, no numbers. */
static inline void cost_csv(table *t, const comparison *s)
{
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++)
        for (compare_kind k = 0; k < compare_kinds; k++)
            if (e->rays[k] || !e->fits) cost_csv_row(t, s, e, kind_name[k], k);
}

/* Nobody is as quick at both, and quicker at one. A twentieth is noise. */
static inline bool sweep_on_front(const comparison *s, const compare_entry *e)
{
    double build = e->build, mean = cost_mean(s, e);
    for (const compare_entry *b = s->entry; b < s->entry + s->entries; b++) {
        double its = cost_mean(s, b);
        if (entry_counts(b) && b->build <= 1.05 * build && its <= 1.05 * mean
            && (b->build < 0.95 * build || its < 0.95 * mean)) return false;
    }
    return true;
}

static inline void sweep_run(const comparison *s, html_report *to)
{
    char title[120];
    double front[compare_most][2];
    int n = 0;
    snprintf(title, sizeof title, "Building against searching: %.40s of %zu", s->name, s->x.n);
    table t = table_new(title, "structure|B/shape|nodes/ray|tests/ray|build [ms]|a ray [ns]|"
                               "on the front");
    plot p = plot_new("Building against searching", "building [ms]", "a ray, time [ns]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    int swept = plot_series(&p, "swept"), fronts = plot_series(&p, "Pareto front");
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++) {
        double nodes, tests, build = e->build * 1e3, ns = cost_mean(s, e) * 1e9;
        bool on = sweep_on_front(s, e);
        if (!entry_counts(e)) continue;
        cost_work(e, &nodes, &tests);
        const double cell[] = {per((double)e->stats.bytes, s->x.n), nodes, tests, build, ns};
        table_text(&t, "%s", e->choice->label);
        for (int k = 0; k < 5; k++) table_number(&t, cell[k]);
        table_text(&t, "%s", on ? "yes" : "");
        if (on) front[n][0] = build, front[n++][1] = ns;
        if (e->choice->how.n) plot_add(&p, swept, build, ns);
        else if (p.series < plot_most_series)
            plot_add(&p, plot_series(&p, e->choice->label), build, ns);
    }
    qsort(front, (size_t)n, sizeof *front, clock_order);  /* by the first: building */
    for (int k = 0; k < n; k++) plot_add(&p, fronts, front[k][0], front[k][1]);
    html_table(to, &t);
    html_plot(to, &p, "17_compare_sweep_time.svg");
}

#endif
