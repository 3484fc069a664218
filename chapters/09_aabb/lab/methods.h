/* methods.h: what each slab test of slabs.h loses, case by case, and what it takes: the main table.
 *
 *   measure_methods(&o)   the table of the page, and the plot of loss against time
 *   measure_lanes(&o)     one ray against 1, 4 and 8 boxes at once
 */
#ifndef AABB_METHODS_H
#define AABB_METHODS_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "slabs.h"
#include "volumes.h"

/* The kinds of exact.h, and the corner with all digits of mantissa.h. */
enum { aabb_cases = trial_kinds + 1, aabb_digits = trial_kinds };
typedef struct { double missed[aabb_cases], late; } aabb_losses;  /* per cent */

/* ---------------------------------------------------------------------------------------------- */

static inline double per_cent(size_t part, size_t whole)
{
    return whole ? 100 * (double)part / (double)whole : 0;
}

/* n trials of a case. One oracle serves all methods. */
static inline void losses_of_case(int kind, uint64_t seed, size_t n, aabb_losses out[aabb_methods])
{
    size_t hits = 0, missed[aabb_methods] = {0}, late[aabb_methods] = {0};
    for (size_t i = 0; i < n; i++) {
        bool full = kind == aabb_digits;
        aabb_trial c = full ? aabb_full_trial_of(TRIAL_CORNER, seed, i)
                            : aabb_trial_of((aabb_trial_kind)kind, seed, i);
        aabb_wide w = {.hit = false};
        if (full) w = wide_aabb(c.b, c.r);
        bool exact = full ? w.hit : exact_aabb(c.b, c.r).hit;
        hits += exact;
        for (int m = 0; m < aabb_methods; m++) {
            real t;
            bool answer = aabb_method[m].hit(c.b, c.r, &t);
            missed[m] += exact && !answer;
            if (full && exact && answer)
                late[m] += wide_sign(wide_sub(wide_of((double)t), w.enter)) > 0;
        }
    }
    for (int m = 0; m < aabb_methods; m++) {
        out[m].missed[kind] = per_cent(missed[m], hits);
        if (kind == aabb_digits) out[m].late = per_cent(late[m], hits - missed[m]);
    }
}

/* ---- time: each ray against each box, in no order, as in a tree ---- */

enum { work_boxes = 256, work_rays = 256 };
enum { aabb_most_rows = 16 };
typedef struct {
    aabb b[work_boxes];
    aabb4 b4[work_boxes / 4];
    aabb8 b8[work_boxes / 8];
    aabb_ball ball[work_boxes];      /* round the same boxes, and boxes of the same sides, turned */
    aabb_turned turned[work_boxes];
    ray r[work_rays];
    int order[work_boxes];  /* order[i] % n for i < n, too, is an order of n, if n is 2^k */
} aabb_work;

static inline aabb_work *work_new(uint64_t seed)
{
    aabb_work *w = allocate(1, sizeof *w);
    for (int i = 0; i < work_boxes; i++) {
        random_stream s = random_start(seed, (uint64_t)i, 99);
        vec3 c = random_in_cube(&s, 1), e = vadd(random_in_cube(&s, 1), vec(1, 1, 1));
        e = vscale(e, (real)0.3);
        w->b[i] = (aabb){vsub(c, e), vadd(c, e)};
        aabb4_put(&w->b4[i / 4], i % 4, w->b[i]), aabb8_put(&w->b8[i / 8], i % 8, w->b[i]);
        w->ball[i] = (aabb_ball){c, vlength(e)};
        w->turned[i] = (aabb_turned){.c = c, .half = e, .axis = {vunit(random_in_cube(&s, 1))}};
        vbasis(w->turned[i].axis[0], &w->turned[i].axis[1], &w->turned[i].axis[2]);
        w->r[i] = line_through((aabb){{-1, -1, -1}, {1, 1, 1}}, seed, (uint64_t)i);
        w->order[i] = i * 37 % work_boxes;
    }
    return w;
}

/* A pass over all rays r and boxes k, `lanes` at a time; `test` adds to sum. */
#define AABB_PASS(name, prepare, lanes, test)                                                  \
    static double name(void *context)                                                          \
    {                                                                                          \
        const aabb_work *w = context;                                                          \
        double sum = 0;                                                                        \
        for (int i = 0; i < work_rays; i++) {                                                  \
            ray r = w->r[i];                                                                   \
            prepare;                                                                           \
            for (int j = 0; j < work_boxes / (lanes); j++) {                                   \
                int k = w->order[j] % (work_boxes / (lanes));                                  \
                test                                                                           \
            }                                                                                  \
        }                                                                                      \
        return sum;                                                                            \
    }
#define AABB_ONE(hit) { real t; if (hit) sum += (double)t; }
/* All boxes of a group that are hit, lowest bit first. */
#define AABB_LANES(n, hit)                                                                     \
    {                                                                                          \
        float t[n];                                                                            \
        unsigned m = hit;                                                                      \
        for (int c = 0; c < (n) && m; c++, m >>= 1) if (m & 1) sum += (double)t[c];            \
    }
#define AABB_PREPARE aabb_inverse v = aabb_plain_inverse(r)
AABB_PASS(pass_first, , 1, AABB_ONE(first_aabb_hit(w->b[k], r, &t)))
AABB_PASS(pass_closed, , 1, AABB_ONE(aabb_hit_closed(w->b[k], r, &t)))
AABB_PASS(pass_kept, AABB_PREPARE, 1, AABB_ONE(aabb_hit_kept_with(&w->b[k], &v, r, &t)))
AABB_PASS(pass_ize, AABB_PREPARE, 1, AABB_ONE(aabb_hit_ize_with(&w->b[k], &v, r, &t)))
AABB_PASS(pass_default, aabb_inverse v = aabb_inverse_of(r), 1,
          AABB_ONE(aabb_hit_inverse(&w->b[k], &v, r, &t)))
AABB_PASS(pass_unprepared, , 1, AABB_ONE(aabb_hit(w->b[k], r, &t)))
AABB_PASS(pass_mine, , 1, AABB_ONE(mine_aabb_hit(w->b[k], r, &t)))
AABB_PASS(pass_ball, real dd = 1 / vdot(r.d, r.d), 1,
          AABB_ONE(bounding_ball_hit(&w->ball[k], dd, r, &t)))
AABB_PASS(pass_turned, , 1, AABB_ONE(turned_hit(&w->turned[k], r, &t)))
AABB_PASS(pass_lanes4, aabb_lanes v = aabb_lanes_of(r), 4,
          AABB_LANES(4, aabb4_hit(&w->b4[k], &v, t)))
AABB_PASS(pass_lanes8, aabb_lanes v = aabb_lanes_of(r), 8,
          AABB_LANES(8, aabb8_hit(&w->b8[k], &v, t)))

/* Nanoseconds a box of n passes. */
static inline void time_passes(const options *o, int n, double (*const pass[])(void *), double *ns)
{
    bench_candidate v[aabb_most_rows];
    aabb_work *w = work_new(o->seed);
    for (int m = 0; m < n; m++) v[m] = (bench_candidate){"", pass[m], w, 0, 0};
    bench_time(v, n, o->quick ? 3 : o->full ? 61 : 15);
    for (int m = 0; m < n; m++) ns[m] = v[m].seconds / ((double)work_boxes * work_rays) * 1e9;
    free(w);
}

/* ---- tables ---- */

/* Like is timed with like: a test either computes 1/d, or divides, for each box, or it gets 1/d
 * once a ray; the name says so. Only the first two know no kept 1/d. */
static const struct { const char *name; int method; double (*pass)(void *); } aabb_rows[] = {
    {"first, divides", aabb_of_first, pass_first},
    {"closed, <=, divides", aabb_of_closed, pass_closed},
    {"aabb_hit, divides", aabb_of_default, pass_unprepared},
    {"first, 1/d kept", aabb_of_kept, pass_kept},
    {"Ize, 2 ulp, 1/d kept", aabb_of_ize, pass_ize},
    {"aabb_hit, 1/d kept", aabb_of_default, pass_default},
    {"aabb8_hit, 1/d kept, float", aabb_of_lanes, pass_lanes8},
    {"mine", aabb_of_mine, pass_mine}};
enum { aabb_row_count = sizeof aabb_rows / sizeof *aabb_rows - 1 + aabb_mine };

static inline void measure_methods(const options *o)
{
    double (*pass[aabb_row_count])(void *), ns[aabb_row_count];
    aabb_losses loss[aabb_methods];
    for (int k = 0; k < aabb_cases; k++) losses_of_case(k, o->seed, o->quick ? 4000 : 50000, loss);
    for (int m = 0; m < aabb_row_count; m++) pass[m] = aabb_rows[m].pass;
    time_passes(o, aabb_row_count, pass, ns);
    table t = table_new("Boxes that are hit and reported as missed; the time of one test",
                        "method|error plane [%]|error flat [%]|error digits [%]|error late [%]|"
                        "time [ns]");
    plot q = plot_new("Hits that are lost, mean of seven kinds of rays; hollow: none",
                      "time of one test [ns]", "lost [%]", PLOT_LOG_Y);
    for (int m = 0; m < aabb_row_count; m++) {
        const aabb_losses *lost = &loss[aabb_rows[m].method];
        double sum = 0;
        for (int k = 0; k < aabb_cases; k++) sum += lost->missed[k] / aabb_cases;
        table_text(&t, "%s", aabb_rows[m].name);
        table_number(&t, lost->missed[TRIAL_PARALLEL]), table_number(&t, lost->missed[TRIAL_FLAT]);
        table_number(&t, lost->missed[aabb_digits]);
        table_number(&t, lost->late), table_number(&t, ns[m]);
        plot_add(&q, plot_series(&q, aabb_rows[m].name), ns[m], sum);
    }
    output_table(o, &t);
    output_plot(o, &q, "09_aabb_time.svg");
}

static inline void measure_lanes(const options *o)
{
    static double (*const pass[])(void *) = {pass_unprepared, pass_default, pass_lanes4,
                                             pass_lanes8};
    static const char *const name[] = {"aabb_hit", "aabb_hit_inverse", "aabb4_hit", "aabb8_hit"};
    const size_t bytes[] = {sizeof(aabb), sizeof(aabb), sizeof(aabb4) / 4, sizeof(aabb8) / 8};
    double ns[4];
    table t = table_new("One ray against several boxes at once",
                        "test|boxes at once|bytes a box|time of a box [ns]");
    time_passes(o, 4, pass, ns);
    for (size_t k = 0; k < 4; k++) {
        table_text(&t, "%s", name[k]), table_count(&t, k < 2 ? 1 : 4 * (k - 1));
        table_count(&t, bytes[k]), table_number(&t, ns[k]);
    }
    output_extra_table(o, &t);
}

#endif
