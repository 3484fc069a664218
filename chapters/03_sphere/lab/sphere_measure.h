/* sphere_measure.h: which rays each of six ways gets wrong, and what they cost.
 *
 *   sphere_main_table(&o)    who is wrong, and the time
 *   sphere_plot_edge(&o)     the same at all distances
 *   sphere_doubt_table(&o)   rays that are looked at twice
 *   sphere_shot_at(seed, how, far, i)   ray i from about far R away, and its sphere, aimed
 *       SPHERE_ANYWHERE       uniformly over a disc of 1.2 R around the centre
 *       SPHERE_GRAZING        to pass within 0.1 % of R
 *       SPHERE_EDGE           at a sphere cut to the ray, from far too large or small to the last
 *                             bit
 *       SPHERE_LIMB           the same, to the last bit: the nearest to a tangent that R can be
 */
#ifndef SPHERE_MEASURE_H
#define SPHERE_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../../common/parallel.h"
#include "mine.h"
#include "sphere_variants.h"

enum { sphere_default = 5, sphere_methods = 6 + sphere_mine, sphere_distances = 13 };
typedef struct { sphere ball; ray r; } sphere_shot;
typedef enum { SPHERE_ANYWHERE, SPHERE_GRAZING, SPHERE_EDGE, SPHERE_LIMB } sphere_how;
/* Of all grazing rays those that are misclassified [%], and the largest | pass / R - 1 | of one
 * that is. */
typedef struct { double grazing_wrong, edge; } sphere_errors;
typedef struct { real far; sphere_errors of[sphere_methods]; } sphere_survey;
typedef struct { sphere_survey at[sphere_distances]; size_t n; uint64_t seed; } sphere_surveys;

/* ---------------------------------------------------------------------------------------------- */

enum { sphere_timed = 1024, sphere_repeats = 20 };

/* Each method in a loop of its own, and inlined there. */
#define SPHERE_TIMED(name, X_hit)                                                                  \
    __attribute__((flatten))                                                                       \
    static double name(void *context)                                                              \
    {                                                                                              \
        const sphere_shot *s = context;                                                            \
        size_t hits = 0;                                                                           \
        hit h;                                                                                     \
        for (int k = 0; k < sphere_repeats * sphere_timed; k++)                                    \
            hits += X_hit(s[k % sphere_timed].ball, s[k % sphere_timed].r, &h);                    \
        return (double)hits;                                                                       \
    }
SPHERE_TIMED(sphere_run_first, first_sphere_hit)
SPHERE_TIMED(sphere_run_stable_root, sphere_hit_stable_root)
SPHERE_TIMED(sphere_run_haines, sphere_hit_haines)
SPHERE_TIMED(sphere_run_lagrange, sphere_hit_lagrange)
SPHERE_TIMED(sphere_run_kahan, sphere_hit_kahan)
SPHERE_TIMED(sphere_run_hit, sphere_hit)
SPHERE_TIMED(sphere_run_mine, mine_sphere_hit)
static const struct { const char *name; sphere_hit_function *hit; double (*run)(void *); }
    sphere_method[] = {{"first", first_sphere_hit, sphere_run_first},
                       {"stable root", sphere_hit_stable_root, sphere_run_stable_root},
                       {"Haines et al.", sphere_hit_haines, sphere_run_haines},
                       {"Lagrange", sphere_hit_lagrange, sphere_run_lagrange},
                       {"Lagrange, Kahan", sphere_hit_kahan, sphere_run_kahan},
                       {"sphere_hit", sphere_hit, sphere_run_hit},
                       {"mine", mine_sphere_hit, sphere_run_mine}};

/* R from 1e-3 to 1e5, every other centre not 0. */
static inline sphere_shot sphere_shot_at(uint64_t seed, sphere_how how, real far, size_t i)
{
    random_stream s = random_start(seed, i, (uint64_t)how);
    real R = pow((real)10, 8 * random_next(&s) - 3);
    real u = random_next(&s), v = 2 * random_next(&s) - 1;
    real pass = how == SPHERE_GRAZING ? 1 + v / 1000 : (real)1.2 * sqrt(u);
    bool cut = how == SPHERE_EDGE || how == SPHERE_LIMB;
    sphere_shot t;
    t.r = sphere_aim(&s, R, far, cut ? 1 : pass, i % 2, &t.ball);
    double apart = how == SPHERE_EDGE ? (double)copysign(pow((real)10, -17 * u), v) : 0;
    if (cut) t.ball.r = (real)(sphere_pass(t.ball, t.r) / (1 + apart));
    return t;
}

static inline void sphere_time(const options *o, sphere_how how, real far,
                               double ns[sphere_methods])
{
    static sphere_shot s[sphere_timed];
    bench_candidate v[sphere_methods];
    for (size_t i = 0; i < sphere_timed; i++) s[i] = sphere_shot_at(o->seed, how, far, i);
    for (int m = 0; m < sphere_methods; m++)
        v[m] = (bench_candidate){.run = sphere_method[m].run, .context = s};
    bench_time(v, sphere_methods, o->quick ? 3 : 25);
    for (int m = 0; m < sphere_methods; m++)
        ns[m] = v[m].seconds / (sphere_repeats * sphere_timed) * 1e9;
}

/* Fills surveys.at[k], whose .far is given. */
static inline void sphere_survey_at(size_t k, void *context)
{
    sphere_surveys *all = context;
    sphere_survey *y = &all->at[k];
    for (int how = SPHERE_GRAZING; how <= SPHERE_EDGE; how++)
        for (size_t i = 0; i < all->n; i++) {
            sphere_shot shot = sphere_shot_at(all->seed, (sphere_how)how, y->far, i);
            shot.r.tmin = -real_infinity;
            double apart = sphere_clearance(shot.ball, shot.r);
            for (int m = 0; m < sphere_methods; m++) {
                hit h;
                if (sphere_method[m].hit(shot.ball, shot.r, &h) == (apart <= 0)) continue;
                if (how == SPHERE_GRAZING) y->of[m].grazing_wrong += 100 / (double)all->n;
                else y->of[m].edge = fmax(y->of[m].edge, fabs(apart));
            }
        }
}

/* `count` distances from 1e0, 1e1/2, .. (step 1) or every step-th of them. */
static inline sphere_surveys sphere_survey_all(const options *o, int from, int step, int count,
                                               size_t n)
{
    sphere_surveys all = {.n = o->quick ? 2000 : n, .seed = o->seed};
    for (int k = 0; k < count; k++) all.at[k].far = pow((real)10, (real)(from + step * k) / 2);
    parallel_whole((size_t)count, o->threads, "rays", sphere_survey_at, &all);
    return all;
}

static inline void sphere_main_table(const options *o)
{
    sphere_surveys all = sphere_survey_all(o, 4, 4, 3, 20000);  /* 1e2, 1e4, 1e6 R */
    double ns[sphere_methods];
    table t = table_new("Ray and sphere: how near the limb rays are misclassified, seen from 1e2 to"
                        " 1e6 R; time of a test",
                        "method|error edge 1e2 R|error edge 1e4 R|error edge 1e6 R|"
                        "error grazing wrong 1e6 R [%]|time [ns]");
    sphere_time(o, SPHERE_ANYWHERE, 100, ns);
    for (int m = 0; m < sphere_methods; m++) {
        table_text(&t, "%s", sphere_method[m].name);
        for (int k = 0; k < 3; k++) table_number(&t, all.at[k].of[m].edge);
        table_number(&t, all.at[2].of[m].grazing_wrong);
        table_number(&t, ns[m]);
    }
    output_table(o, &t);
}

cold_inline void sphere_plot_edge(const options *o)
{
    sphere_surveys all = sphere_survey_all(o, 0, 1, sphere_distances, 100000);
    plot p = plot_new("How near the limb a ray is misclassified", "distance [R]", "edge [R]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int m = 0; m < sphere_methods; m++) {
        int series = plot_series(&p, sphere_method[m].name);
        for (int k = 0; k < sphere_distances; k++)
            plot_add(&p, series, (double)all.at[k].far, all.at[k].of[m].edge);
    }
    plot_slope(&p, 2, "slope 2");
    output_plot(o, &p, "03_sphere_edge.svg");
}

/* Of n rays, those whose D sphere_roots computes a second time. */
static inline size_t sphere_twice(const options *o, sphere_how how, real far, size_t n)
{
    real t0, t1;
    size_t before = sphere_doubts;
    for (size_t i = 0; i < n; i++) {
        sphere_shot s = sphere_shot_at(o->seed, how, far, i);
        (void)sphere_roots(s.ball, s.r, &t0, &t1);
    }
    return sphere_doubts - before;
}

static inline void sphere_doubt_table(const options *o)
{
    const struct { const char *name; sphere_how how; real far; } kind[] = {
        {"anywhere, from 1e6 R", SPHERE_ANYWHERE, 1000000},
        {"within 0.1 % of the limb, from 1e6 R", SPHERE_GRAZING, 1000000},
        {"at the last bit of the limb", SPHERE_LIMB, 100}};
    table t = table_new("Rays that sphere_hit looks at twice",
                        "rays|D twice, of 1e6|time [ns]");
    for (size_t k = 0; k < sizeof kind / sizeof *kind; k++) {
        double ns[sphere_methods];
        sphere_time(o, kind[k].how, kind[k].far, ns);
        table_text(&t, "%s", kind[k].name);
        table_count(&t, sphere_twice(o, kind[k].how, kind[k].far, 1000000));
        table_number(&t, ns[sphere_default]);
    }
    output_extra_table(o, &t);
}

#endif
