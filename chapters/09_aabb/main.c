/* 09_aabb: a ray and a box: what each slab test loses, what it costs, and what a box hit is worth.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 09_aabb chapters/09_aabb/main.c -lm -lpthread
 * The oracles are whole numbers (exact.h) and twice the precision (mantissa.h). */
#include "lab/draw.h"
#include "lab/measure_alarms.h"
#include "lab/slab_figure.h"

/* ---- what is lost ---- */

/* The kinds of exact.h, and the corner with all digits of mantissa.h. */
enum { columns = trial_kinds + 1, full_corner = trial_kinds };
typedef struct { double missed[columns], false_alarms, late; } rates;  /* per cent */

static rates rates_of(box_method *test, uint64_t seed, size_t n)
{
    rates e = {.late = 0};
    for (int kind = 0; kind < columns; kind++) {
        size_t hits = 0, missed = 0, alarms = 0, late = 0;
        for (size_t i = 0; i < n; i++) {
            bool full = kind == full_corner, exact;
            trial c = full ? full_trial_of(TRIAL_CORNER, seed, i)
                           : trial_of((trial_kind)kind, seed, i);
            exact_answer a = {false, {0, 1}};
            wide_answer w = {.hit = false};
            if (full) w = wide_aabb(c.b, c.r), exact = w.hit;
            else a = exact_aabb(c.b, c.r), exact = a.hit;
            real t;
            bool answer = test(c.b, c.r, &t);
            hits += exact, missed += exact && !answer, alarms += answer && !exact;
            if (full && exact && answer)
                late += wide_sign(wide_sub(wide_of((double)t), w.enter)) > 0;
        }
        e.missed[kind] = per_cent(missed, hits);
        if (kind == TRIAL_ANY) e.false_alarms = per_cent(alarms, n - hits);
        if (kind == full_corner) e.late = per_cent(late, hits - missed);
    }
    return e;
}

/* ---- what it costs: each ray against each box, in no order, as in a tree ---- */

enum { boxes = 256, rays = 256, rounds = 15 };
typedef struct { aabb b[boxes]; ray r[rays]; int order[boxes]; } workload;

#define TIMED(name, prepare, test)                                                             \
    static double name(void *context)                                                          \
    {                                                                                          \
        const workload *w = context;                                                           \
        double sum = 0;                                                                        \
        for (int i = 0; i < rays; i++) {                                                       \
            ray r = w->r[i];                                                                   \
            prepare;                                                                           \
            for (int k = 0; k < boxes; k++) {                                                  \
                real t;                                                                        \
                const aabb *b = &w->b[w->order[k]];                                            \
                if (test) sum += (double)t;                                                    \
            }                                                                                  \
        }                                                                                      \
        return sum;                                                                            \
    }
TIMED(run_first, , first_aabb_hit(*b, r, &t))
TIMED(run_closed_f32, , aabb_hit_closed_f32(*b, r, &t))
TIMED(run_closed, , aabb_hit_closed(*b, r, &t))
TIMED(run_fmin, , aabb_hit_fmin(*b, r, &t))
TIMED(run_pbrt, , aabb_hit_pbrt(*b, r, &t))
TIMED(run_inclusive, , aabb_hit_inclusive(*b, r, &t))
TIMED(run_default, , aabb_hit(*b, r, &t))
TIMED(run_inverse, ray_inverse i1 = inverse_of(r), aabb_hit_inverse(b, &i1, r, &t))
static double (*const run_method[methods + 1])(void *) = {
    run_first, run_closed_f32, run_closed, run_fmin, run_pbrt, run_inclusive, run_default,
    run_inverse};

static workload *workload_new(uint64_t seed)
{
    workload *w = allocate(1, sizeof *w);
    for (uint64_t i = 0; i < boxes; i++) {
        random_stream s = random_start(seed, i, 99);
        vec3 c = random_in_cube(&s), e = random_in_cube(&s), half = {1, 1, 1};
        e = vscale(vadd(e, half), 0.3);
        w->b[i] = (aabb){vsub(c, e), vadd(c, e)};
        w->r[i] = line_through((aabb){{-1, -1, -1}, {1, 1, 1}}, seed, i);
        w->order[i] = (int)(i * 37 % boxes);
    }
    return w;
}

static void measure_methods(const options *o)
{
    table t = table_new("Boxes that are hit and reported as missed, by case, and time of one test",
                        "method|error plane [%]|error flat [%]|error edge [%]|error corner [%]|"
                        "error interval [%]|error any [%]|error digits [%]|error late [%]|"
                        "error alarms [%]|time [ns]");
    plot p = plot_new("Hits that are lost", "1 in a plane  2 flat  3 edge  4 corner  5 interval "
                      "ends there  6 any  7 corner, all digits", "lost [%]", PLOT_LOG_Y);
    plot q = plot_new("Hits that are lost, mean of the cases, and time", "time of one test [ns]",
                      "lost [%]", PLOT_LOG_Y);
    workload *w = workload_new(o->seed);
    clock_variant v[methods + 1];
    for (int m = 0; m <= methods; m++) {
        const char *name = m < methods ? method_name[m] : "aabb_hit_inverse";
        v[m] = (clock_variant){name, run_method[m], w, 0};
    }
    clock_compare(v, methods + 1, o->quick ? 3 : rounds);
    for (int m = 0; m <= methods; m++) {  /* the prepared form gives the answers of aabb_hit */
        double sum = 0, time = v[m].seconds / ((double)boxes * rays) * 1e9;
        rates e = rates_of(method[m < methods ? m : method_default], o->seed,
                           o->quick ? 4000 : 100000);
        int series = plot_series(&q, v[m].name);
        if (m < methods) plot_series(&p, v[m].name);
        table_text(&t, "%s", v[m].name);
        for (int k = 0; k < columns; k++) {
            table_number(&t, e.missed[k]);
            if (m < methods) plot_add(&p, m, k + 1, e.missed[k]);
            sum += e.missed[k] / columns;
        }
        table_number(&t, e.late), table_number(&t, e.false_alarms), table_number(&t, time);
        plot_add(&q, series, time, sum);
    }
    output_table(o, &t);
    output_plot(o, &p, "09_aabb_lost.svg");
    output_plot(o, &q, "09_aabb_time.svg");
    free(w);
}

int main(int argc, char **argv)
{
    options defaults = {.width = 846, .height = 360, .seed = 1};
    options o = options_read(argc, argv, "09_aabb", "A ray and a box: errors, time, false alarms.",
                             defaults, NULL);
    draw_room(&o), draw_slabs(&o), draw_aligned(&o), draw_silhouette(&o);
    measure_methods(&o);
    count_alarms(&o);
    measure_teapot(&o);
    count_own_boxes(&o);
    return output_done(&o);
}
