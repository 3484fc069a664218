/* csg_measure.h: what each way to the first hit gets wrong, the rays that show it, and its time.
 *
 *   csg_main_table(&o)       what each way gets wrong, and its time
 *   csg_tolerance_plot(&o)   tolerances from 1e-12 to 1
 *
 *   csg_truth(m, &c, r, least, &t, &n)    the first place in [tmin, tmax] where the Boolean of the
 *                                    parts changes, and the normal there; false: nowhere. The
 *                                    crossings of single solids tell where to look; between each
 *                                    two of them oracle_contains is asked. What is shorter than
 *                                    `least` is rounding, and nothing
 *   csg_sight s = csg_sight_of(kind, seed)   a scene, and rays that try it; free s.scene
 *   csg_sight_ray(&s, i)             ray i of them
 *   csg_due d = csg_due_of(&s, i)    the same, and its first hit as it ought to be
 *   csg_errs(&s, &d, &way)           is the hit, t or normal another?
 *   csg_wrong(&s, way, ways, n, wrong)   by each of the ways: percent of n rays
 */
#ifndef CSG_MEASURE_H
#define CSG_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "csg_oracle.h"
#include "csg_scenes.h"
#include "csg_variants.h"

typedef enum { CSG_OUTSIDE, CSG_EYE_INSIDE, CSG_COINCIDENT, CSG_FAR_AWAY, CSG_MESH_FACES,
               CSG_FOILS, csg_sights }
    csg_sight_kind;
typedef struct {
    csg_sight_kind kind;
    csg_scene scene;
    vec3 shift;
    uint64_t seed;
} csg_sight;
typedef struct { ray r; bool is; double t; vec3 n; } csg_due;

/* ---------------------------------------------------------------------------------------------- */

static inline bool csg_truth(csg_model m, const csg *c, ray r, double least, double *t, vec3 *n)
{
    csg_crossing at[64];
    size_t k = 0;
    for (size_t i = 0; i < m.solids && k < 56; i++)
        k += csg_solid_crossings(&m.solid[i], r, c->first[i], at + k);
    csg_sort(at, k);
    double last = (double)r.tmin, margin, scale = (double)vlength(r.d);
    bool before = false, known = false;
    for (size_t i = 0; i <= k; i++) {
        double next = i < k ? (double)at[i].t : last + 2;
        if (!((next - last) * scale > least)) continue;
        double middle = isfinite(next) ? (last + next) / 2 : last + 1;
        bool in = oracle_contains(m, oracle_on(r, middle), &margin);
        if (known && in != before) {
            *t = last;
            hit h = {(real)last, 0, 0, 0};
            for (size_t j = 0; j < k; j++)  /* the solid whose crossing is there */
                if (fabs((double)at[j].t - last) * scale <= least) h.shape = at[j].surface;
            vec3 out = csg_normal(c, r, h);
            *n = (vdot(out, r.d) > 0) == in ? vneg(out) : out;  /* into it: against the ray */
            return true;
        }
        before = in, known = true, last = next;
    }
    return false;
}

static inline csg_sight csg_sight_of(csg_sight_kind kind, uint64_t seed)
{
    double far = kind != CSG_FAR_AWAY ? 0 : real_is_float ? 1e2 : 1e7;
    csg_sight s = {.kind = kind, .seed = seed, .shift = vec(far, 0.7 * far, -0.4 * far)};
    s.scene = kind >= CSG_COINCIDENT ? csg_scene_pocket(kind == CSG_MESH_FACES, s.shift)
        : csg_scene_of(CSG_CLASSIC);
    return s;
}

static inline ray csg_sight_ray(const csg_sight *s, size_t i)
{
    random_stream x = random_start(s->seed, i, (uint64_t)s->kind);
    vec3 to = random_in_cube(&x, 1), jitter = random_in_cube(&x, (real)0.3), n[3];
    if (s->kind == CSG_OUTSIDE) return ray_from(vadd(vec(2.9, 2.6, 4.4), jitter),
                                                vsub(to, vec(2.9, 2.6, 4.4)));
    if (s->kind == CSG_EYE_INSIDE)
        return ray_from(vadd(i % 2 ? vec(0, 0, 0) : vec(0.7, 0.7, 0.7), vscale(jitter, (real)0.2)),
                        random_direction_of(&x));
    vec3 eye = vadd(s->shift, vadd(vec(2.0, 3.6, 4.4), jitter));
    csg_scene_axes(n);
    real u = to.x, v = to.y, w = to.z;  /* in the block's own frame: on two faces, or on a foil */
    if (s->kind == CSG_FOILS)
        w = 0, u = (real)1.7 + u * (real)0.39, v = (real)(i % 3) * (real)0.7 - (real)0.7 + v / 4;
    else if (i % 2) v = 1;
    else w = 1;
    vec3 p = vadd(vadd(vscale(n[0], u), vscale(n[1], v)), vscale(n[2], w));
    return ray_from(eye, vsub(vadd(p, s->shift), eye));
}

/* Above the rounding of the scene, below the thinnest foil. */
static inline double csg_sight_least(const csg_sight *s)
{
    return s->kind == CSG_FAR_AWAY ? (real_is_float ? 1e-4 : 1e-6) : real_is_float ? 2e-5 : 1e-9;
}

static inline csg_due csg_due_of(const csg_sight *s, size_t i)
{
    csg_due d = {csg_sight_ray(s, i), false, 0, {0, 0, 0}};
    d.is = csg_truth(csg_expression_model(&s->scene.e), &s->scene.c, d.r, csg_sight_least(s), &d.t,
                     &d.n);
    return d;
}

static inline bool csg_errs(const csg_sight *s, const csg_due *d, const csg_way *way)
{
    const csg *c = &s->scene.c;
    hit h;
    bool is = csg_way_hit(way, c, d->r, &h);
    if (!is || !d->is) return is != d->is;
    return !(fabs((double)h.t - d->t) * (double)vlength(d->r.d) <= csg_sight_least(s)
             && vdot(csg_normal(c, d->r, h), d->n) > (real)0.99);
}

/* What is due is asked once for all ways: it takes longer than they do. */
static inline void csg_wrong(const csg_sight *s, const csg_way *way, int ways, size_t n,
                             double *wrong)
{
    for (int m = 0; m < ways; m++) wrong[m] = 0;
    for (size_t i = 0; i < n; i++) {
        csg_due d = csg_due_of(s, i);
        for (int m = 0; m < ways; m++) wrong[m] += csg_errs(s, &d, &way[m]);
    }
    for (int m = 0; m < ways; m++) wrong[m] *= 100 / (double)n;
}

/* ---- the table, the plot ---- */

enum { csg_methods = 6, csg_timed = 1024 };

static const char *const csg_method[csg_methods] = {
    "t > 0, as first.h", "planes by points, one by one", "the same, tolerance 1e-9",
    "the same, tolerance 0.003", "spans", "spans, bounds: csg_hit"};
static const csg_way csg_method_way[csg_methods] = {
    {csg_hit_front, 0, true}, {csg_hit_tolerant, -1, true}, {csg_hit_tolerant, 1e-9, true},
    {csg_hit_tolerant, 0.003, true}, {csg_hit, 0, true}, {csg_hit, 0, false}};

typedef struct { const csg *c; csg_way way; const ray *r; } csg_timing;

static double csg_time_run(void *context)
{
    const csg_timing *x = context;
    double sum = 0;
    hit h;
    csg_tolerance = (real)x->way.tolerance;
    for (size_t i = 0; i < csg_timed; i++)
        sum += x->way.X_hit(x->c, x->r[i], &h) ? (double)h.t : 0;
    return sum;
}

typedef struct { csg_sight sight[csg_sights]; size_t n; double wrong[csg_sights][csg_methods]; }
    csg_survey;

static inline void csg_survey_sight(size_t k, void *context)
{
    csg_survey *y = context;
    csg_wrong(&y->sight[k], csg_method_way, csg_methods, y->n, y->wrong[k]);
}

static inline void csg_main_table(const options *o)
{
    static const csg_sight_kind shown[] = {CSG_OUTSIDE, CSG_EYE_INSIDE, CSG_COINCIDENT,
                                           CSG_FAR_AWAY, CSG_FOILS};
    csg_survey y = {.n = o->quick ? 100 : 2000};
    static ray r[csg_timed];
    csg_timing x[csg_methods];
    double ns[csg_methods];
    for (int k = 0; k < 5; k++) y.sight[k] = csg_sight_of(shown[k], o->seed);
    csg c = y.sight[0].scene.c, bare = c;
    bare.no_bounds = true;
    for (size_t i = 0; i < csg_timed; i++) r[i] = csg_sight_ray(&y.sight[0], i);
    for (int m = 0; m < csg_methods; m++)
        x[m] = (csg_timing){csg_method_way[m].bare ? &bare : &c, csg_method_way[m], r};
    bench_each(csg_time_run, x, sizeof *x, csg_methods, o->quick ? 3 : o->full ? 31 : 9,
               1e9 / csg_timed, ns);
    table t = table_new("First hit of a tree: rays that get it wrong, and time",
                        "method|error eye outside [%]|error eye inside [%]|error coincident [%]|"
                        "error foils [%]|time [ns]");
    parallel_whole(5, o->threads, "rays", csg_survey_sight, &y);
    for (int m = 0; m < csg_methods; m++) {
        table_text(&t, "%s", csg_method[m]);
        table_number(&t, y.wrong[0][m]), table_number(&t, y.wrong[1][m]);
        table_number(&t, (y.wrong[2][m] + y.wrong[3][m]) / 2);
        table_number(&t, y.wrong[4][m]), table_number(&t, ns[m]);
    }
    output_table(o, &t);
    for (int k = 0; k < 5; k++) csg_scene_free(&y.sight[k].scene);
}

static inline void csg_tolerance_plot(const options *o)
{
    static const csg_sight_kind kind[3] = {CSG_COINCIDENT, CSG_FAR_AWAY, CSG_FOILS};
    static const char *const name[3] = {"coincident faces", "the same, far away", "foils"};
    plot p = plot_new("What a tolerance gets wrong", "tolerance", "wrong rays [%]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < 3; k++) {
        csg_sight s = csg_sight_of(kind[k], o->seed);
        csg_way way[25];
        double wrong[25];
        plot_series(&p, name[k]);
        for (int e = 0; e < 25; e++)
            way[e] = (csg_way){csg_hit_tolerant, (double)pow((real)10, (real)e / 2 - 12), true};
        csg_wrong(&s, way, 25, 1000, wrong);
        for (int e = 0; e < 25; e++) plot_add(&p, k, way[e].tolerance, wrong[e]);
        csg_scene_free(&s.scene);
    }
    output_plot(o, &p, "06_csg_tolerance.svg");
}

#endif
