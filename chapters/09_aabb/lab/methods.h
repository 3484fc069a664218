/* methods.h: what each slab test loses, case by case, and what it takes: the main table.
 *
 *   measure_slabs(&o)     the table of the page, and the plot of loss against time
 *   measure_volumes(&o)   bounding sphere, box and turned box: false alarms, and the time of a test
 */
#ifndef AABB_METHODS_H
#define AABB_METHODS_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "slabs.h"
#include "volumes.h"

/* ---- time: each ray against each box, in no order, as in a tree ---- */

enum { work_boxes = 256, work_rays = 256 };
typedef struct {
    aabb b[work_boxes];
    aabb4 b4[work_boxes / 4];
    aabb8 b8[work_boxes / 8];
    sphere ball[work_boxes];         /* round the same boxes, and boxes of the same sides, turned */
    aabb_turned turned[work_boxes];
    ray r[work_rays];
    int order[work_boxes];  /* order[i] % n for i < n, too, is an order of n, if n is 2^k */
} aabb_work;

/* ---------------------------------------------------------------------------------------------- */

static inline aabb_work *work_new(uint64_t seed)
{
    aabb_work *w = allocate(1, sizeof *w);
    for (int i = 0; i < work_boxes; i++) {
        random_stream s = random_start(seed, (uint64_t)i, 99);
        vec3 c = random_in_cube(&s, 1), e = vadd(random_in_cube(&s, 1), vec(1, 1, 1));
        e = vscale(e, (real)0.3);
        w->b[i] = (aabb){vsub(c, e), vadd(c, e)};
        lanes_put(w->b4[i / 4].side[0], 4, i % 4, w->b[i]);
        lanes_put(w->b8[i / 8].side[0], 8, i % 8, w->b[i]);
        w->ball[i] = (sphere){c, vlength(e)};
        aabb_turned *u = &w->turned[i];
        u->axis[0] = vunit(random_in_cube(&s, 1));
        vbasis(u->axis[0], &u->axis[1], &u->axis[2]);
        c = turned_into(u, c), u->b = (aabb){vsub(c, e), vadd(c, e)};
        w->r[i] = line_through((aabb){{-1, -1, -1}, {1, 1, 1}}, seed, (uint64_t)i);
        w->order[i] = i * 37 % work_boxes;
    }
    return w;
}

/* A pass over all rays r and boxes k, `lanes` at a time; `test` is true, or a bit for each box, and
 * gives the t that are added up. */
#define AABB_PASS(name, prepare, lanes, type, test)                                            \
    static double name(void *context)                                                          \
    {                                                                                          \
        const aabb_work *w = context;                                                          \
        double sum = 0;                                                                        \
        for (int i = 0; i < work_rays; i++) {                                                  \
            ray r = w->r[i];                                                                   \
            prepare;                                                                           \
            for (int j = 0; j < work_boxes / (lanes); j++) {                                   \
                int k = w->order[j] % (work_boxes / (lanes));                                  \
                type t[lanes];                                                                 \
                unsigned m = test;                                                             \
                for (int c = 0; c < (lanes) && m; c++, m >>= 1) if (m & 1) sum += (double)t[c];\
            }                                                                                  \
        }                                                                                      \
        return sum;                                                                            \
    }
#define AABB_PREPARE aabb_inverse v = aabb_plain_inverse(r)
AABB_PASS(pass_first, , 1, real, first_aabb_hit(w->b[k], r, t))
AABB_PASS(pass_closed, , 1, real, aabb_hit_closed(w->b[k], r, t))
AABB_PASS(pass_unprepared, , 1, real, aabb_hit(w->b[k], r, t))
AABB_PASS(pass_kept, AABB_PREPARE, 1, real, aabb_hit_kept_with(&w->b[k], &v, r, t))
AABB_PASS(pass_ize, AABB_PREPARE, 1, real, aabb_hit_ize_with(&w->b[k], &v, r, t))
AABB_PASS(pass_default, aabb_inverse v = aabb_inverse_of(r), 1, real,
          aabb_hit_inverse(&w->b[k], &v, r, t))
AABB_PASS(pass_lanes4, aabb_lanes v = aabb_lanes_of(r), 4, float, aabb4_hit(&w->b4[k], &v, t))
AABB_PASS(pass_lanes8, aabb_lanes v = aabb_lanes_of(r), 8, float, aabb8_hit(&w->b8[k], &v, t))
AABB_PASS(pass_mine, , 1, real, mine_aabb_hit(w->b[k], r, t))
AABB_PASS(pass_ball, real dd = 1 / vdot(r.d, r.d), 1, real,
          bounding_ball_hit(&w->ball[k], dd, r, t))
AABB_PASS(pass_turned, , 1, real, turned_hit(&w->turned[k], r, t))

/* Like is timed with like: a test either computes 1/d, or divides, for each box, or it gets 1/d
 * once a ray; the name says so. */
typedef struct { const char *name; aabb_test *hit; double (*pass)(void *); } aabb_row;
static const aabb_row aabb_rows[] = {{"first, divides", first_aabb_hit, pass_first},
                                     {"closed, <=, divides", aabb_hit_closed, pass_closed},
                                     {"aabb_hit, divides", aabb_hit, pass_unprepared},
                                     {"first, 1/d kept", aabb_hit_kept, pass_kept},
                                     {"Ize, 2 ulp, 1/d kept", aabb_hit_ize, pass_ize},
                                     {"aabb_hit, 1/d kept", aabb_hit, pass_default},
                                     {"aabb4_hit, 1/d kept, float", aabb_hit_lanes, pass_lanes4},
                                     {"aabb8_hit, 1/d kept, float", aabb_hit_lanes, pass_lanes8},
                                     {"mine", mine_aabb_hit, pass_mine}};
static const aabb_row volume_rows[] = {{"sphere, d.d kept", NULL, pass_ball},
                                       {"box, 1/d kept", NULL, pass_default},
                                       {"turned box, divides", NULL, pass_turned}};
enum { aabb_row_count = sizeof aabb_rows / sizeof *aabb_rows - 1 + aabb_mine };

/* Nanoseconds a box of n passes. */
static inline void time_passes(const options *o, int n, const aabb_row *row, double *ns)
{
    bench_candidate v[aabb_row_count];
    aabb_work *w = work_new(o->seed);
    for (int m = 0; m < n; m++) v[m] = (bench_candidate){.run = row[m].pass, .context = w};
    bench_time(v, n, o->quick ? 3 : o->full ? 61 : 15);
    for (int m = 0; m < n; m++) ns[m] = v[m].seconds / ((double)work_boxes * work_rays) * 1e9;
    free(w);
}

/* ---- tables ---- */

/* The kinds of exact.h, and the corner with all digits. */
enum { aabb_cases = aabb_trial_kinds + 1, aabb_digits = aabb_trial_kinds, aabb_late };
typedef struct {  /* per cent; late: of the corners found */
    const options *o;
    double of[aabb_row_count][aabb_late + 1];
} aabb_losses;

/* The trials of a case: for parallel_whole. One oracle serves all methods. */
static inline void losses_of_case(size_t kind, void *context)
{
    aabb_losses *loss = context;
    const uint64_t seed = loss->o->seed;
    const bool full = kind == aabb_digits;
    size_t hits = 0, missed[aabb_row_count] = {0}, late[aabb_row_count] = {0};
    for (size_t i = 0; i < (loss->o->quick ? 4000 : 50000); i++) {
        aabb_trial c = full ? aabb_full_trial_of(TRIAL_CORNER, seed, i)
                            : aabb_trial_of((aabb_trial_kind)kind, seed, i);
        aabb_wide w = full ? wide_aabb(c.b, c.r) : (aabb_wide){.hit = exact_aabb(c.b, c.r).hit};
        hits += w.hit;
        for (int m = 0; w.hit && m < aabb_row_count; m++) {
            real t;
            if (!aabb_rows[m].hit(c.b, c.r, &t)) missed[m]++;
            else if (full) late[m] += wide_sign(wide_sub(wide_of((double)t), w.enter)) > 0;
        }
    }
    for (int m = 0; m < aabb_row_count; m++) {
        loss->of[m][kind] = 100 * (double)missed[m] / (double)hits;
        if (full) loss->of[m][aabb_late] = 100 * (double)late[m] / (double)(hits - missed[m]);
    }
}

static inline void measure_slabs(const options *o)
{
    static const int shown[] = {TRIAL_PARALLEL, TRIAL_FLAT, aabb_digits, aabb_late};
    double ns[aabb_row_count];
    aabb_losses loss = {.o = o};
    parallel_whole(aabb_cases, o->threads, "rays", losses_of_case, &loss);
    time_passes(o, aabb_row_count, aabb_rows, ns);
    table t = table_new("Boxes that are hit and reported as missed; the time of one test",
                        "method|error plane [%]|error flat [%]|error digits [%]|error late [%]|"
                        "time [ns]");
    plot q = plot_new("Hits that are lost, mean of seven kinds of rays; hollow: none",
                      "time of one test [ns]", "lost [%]", PLOT_LOG_Y);
    for (int m = 0; m < aabb_row_count; m++) {
        double sum = 0;
        for (int k = 0; k < aabb_cases; k++) sum += loss.of[m][k] / aabb_cases;
        table_text(&t, "%s", aabb_rows[m].name);
        for (int k = 0; k < 4; k++) table_number(&t, loss.of[m][shown[k]]);
        table_number(&t, ns[m]);
        plot_add(&q, plot_series(&q, aabb_rows[m].name), ns[m], sum);
    }
    output_table(o, &t);
    output_plot(o, &q, "09_aabb_time.svg");
}

static inline void measure_volumes(const options *o)
{
    double vain[content_shapes][content_kinds], ns[content_kinds];
    for (int s = 0; s < content_shapes; s++) {
        aabb_content c = content_of(s);
        content_in_vain(&c, o->seed, 20000, vain[s]);
        free(c.t);
    }
    time_passes(o, content_kinds, volume_rows, ns);
    table t = table_new("Of the lines that hit a volume, how many hit nothing in it",
                        "volume|needle [%]|ball [%]|teapot [%]|time [ns]");
    for (int k = 0; k < content_kinds; k++) {
        table_text(&t, "%s", volume_rows[k].name);
        for (int s = 0; s < content_shapes; s++) table_number(&t, vain[s][k]);
        table_number(&t, ns[k]);
    }
    output_extra_table(o, &t);
}

#endif
