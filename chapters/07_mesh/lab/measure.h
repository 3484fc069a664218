/* measure.h: the tables and plots of this chapter: error against time, and O(n).
 *
 *   table t = measure_shapes(seed, rays, &wrong, &residual);   cones and polygons, both forms
 *   table t = measure_inside(seed, points, &against_time);     five answers to "inside?"
 *   table t = measure_cost(&m, seed, tests, &time, &exponent); closest hit of parts of a mesh
 *
 * Errors are those of trials.h, times medians of interleaved rounds.
 */
#ifndef MESH_LAB_MEASURE_H
#define MESH_LAB_MEASURE_H

#include "../../../common/clock.h"
#include "../../../common/lab/plot.h"
#include "../../../common/lab/table.h"
#include "trials.h"

/* ---------------------------------------------------------------------------------------------- */

enum { batch = 1024, most_rounds = 7 };

typedef struct { cone c[batch]; ray r[batch]; bool (*hit)(cone, ray, hit *); } cone_batch;

static inline double run_cones(void *context)
{
    const cone_batch *b = context;
    double sum = 0;
    hit h = hit_none;
    for (int i = 0; i < batch; i++) sum += b->hit(b->c[i], b->r[i], &h) ? (double)h.t : 1;
    return sum;
}

/* One row for each method: wrong answers where rays graze, distance from the side where they do
 * not. */
static inline void measure_cones(uint64_t seed, size_t rays, table *t, plot *wrong, plot *residual)
{
    static cone_batch b[2];
    const char *name[2] = {"cone_hit_naive", "cone_hit"};
    int in_wrong[2], in_residual[2];
    for (int k = 0; k < 2; k++) {
        in_wrong[k] = plot_series(wrong, name[k]);
        in_residual[k] = plot_series(residual, name[k]);
    }
    for (real distance = 1; distance <= (real)1e6; distance *= 10) {
        cone_score sum = {0, 0, {0, 0}, {0, 0}, {0, 0}};
        clock_variant v[2] = {{name[0], run_cones, &b[0], 0}, {name[1], run_cones, &b[1], 0}};
        random_stream s = random_start(seed, (uint64_t)distance, 71);
        for (int kind = 0; kind < 5; kind++) {
            cone_score grazing = cone_play(&s, kind, AIM_GRAZING, distance, rays / 5, 64);
            cone_score anywhere = cone_play(&s, kind, AIM_RANDOM, distance, rays / 5, 64);
            sum.decided += grazing.decided;
            for (int k = 0; k < 2; k++) {
                sum.wrong[k] += grazing.wrong[k];
                sum.off_side[k] = fmax(sum.off_side[k], anywhere.off_side[k]);
            }
        }
        for (int i = 0; i < batch; i++) {
            b[0].c[i] = b[1].c[i] = some_cone(&s, i % 5);
            b[0].r[i] = b[1].r[i] = ray_at_cone(&s, b[0].c[i], AIM_RANDOM, distance);
        }
        b[0].hit = cone_hit_naive, b[1].hit = cone_hit;
        clock_compare(v, 2, most_rounds);
        for (int k = 0; k < 2; k++) {
            double percent = 100 * (double)sum.wrong[k] / (double)sum.decided;
            plot_add(wrong, in_wrong[k], (double)distance, percent);
            plot_add(residual, in_residual[k], (double)distance, sum.off_side[k]);
            int power = (int)round(log10((double)distance));
            if (power % 2) continue;
            table_text(t, "%s", name[k]), table_text(t, "from 1e%d", power);
            table_number(t, percent);
            table_number(t, sum.off_side[k]), table_number(t, 1e9 * v[k].seconds / batch);
        }
    }
}

typedef struct { polygon p; const gear_box *b; ray r[batch]; bool naive; } polygon_batch;

static inline double run_polygons(void *context)
{
    const polygon_batch *b = context;
    double sum = 0;
    hit h = hit_none;
    for (int i = 0; i < batch; i++)
        sum += (b->naive ? polygon_hit_naive : polygon_hit)(b->p, b->r[i], &h) ? (double)h.t : 1;
    return sum;
}

static inline void measure_polygons(uint64_t seed, size_t rays, table *t)
{
    static gear_box box;
    static polygon_batch b[2][2];
    for (int j = 0; j < 2; j++) {
        clock_variant v[2][2];
        size_t slips[2];
        random_stream s = random_start(seed, (uint64_t)j, 72), again;
        gear_box_fill(&box, &s, j ? 100000 : 0, false);
        again = s;
        for (int k = 0; k < 2; k++) {
            s = again;
            slips[k] = gear_box_slips(&box, &s, rays, k == 0);
            for (int c = 0; c < 2; c++) {
                b[c][k].p = box.shapes[c ? 0 : 2].polygon, b[c][k].naive = k == 0;
                v[c][k] = (clock_variant){"", run_polygons, &b[c][k], 0};
                for (int i = 0; i < batch; i++) b[c][k].r[i] = gear_box_ray(&box, &s, (size_t)i);
            }
        }
        for (int c = 0; c < 2; c++) clock_compare(v[c], 2, most_rounds);
        for (int c = 0; c < 2; c++)
            for (int k = 0; k < 2; k++) {
                table_text(t, k ? "polygon_hit" : "polygon_hit_naive");
                table_text(t, "%s, %s", c ? "144-gon" : "quad", j ? "1e5 away" : "at the origin");
                if (c) table_text(t, "-");
                else table_number(t, 100 * (double)slips[k] / (double)rays);
                table_text(t, "-"), table_number(t, 1e9 * v[c][k].seconds / batch);
            }
    }
}

/* `wrong` of cones: grazing rays with another answer than the oracle's; of polygons: rays from
 * inside a gear wheel, aimed at its corners and edges, that leave it unseen. */
static inline table measure_shapes(uint64_t seed, size_t rays, plot *wrong, plot *residual)
{
    table t = table_new("Cones and polygons: error against time",
                        "method|rays|error: wrong [%]|error: off the side|time [ns]");
    measure_cones(seed, rays, &t, wrong, residual);
    measure_polygons(seed, rays, &t);
    return t;
}

/* ---------------------------------------------------------------------------------------------- */

enum { questions = 32 };
typedef struct {
    const mesh *m;
    const first_mesh *soup;
    int method;
    vec3 p[questions], d[questions];
} inside_batch;

static inline double run_inside(void *context)
{
    const inside_batch *b = context;
    int sum = 0;
    for (int i = 0; i < questions; i++)
        sum += inside_ask(b->method, b->m, b->soup, b->p[i], b->d[i]);
    return sum;
}

static inline table measure_inside(uint64_t seed, size_t points, plot *against_time)
{
    static inside_batch b[inside_methods];
    clock_variant v[inside_methods];
    mesh m = torus_mesh(24);
    first_mesh soup = mesh_soup(&m);
    table t = table_new(
        "Point in a closed mesh of 1152 triangles, rays aimed at",
        "method|error: random [% wrong]|error: an edge|error: a vertex|time [ns a triangle]");
    inside_score score[3];
    for (inside_aim at = AT_RANDOM; at <= AT_VERTEX; at++) {
        random_stream s = random_start(seed, (uint64_t)at, 73);
        score[at] = inside_play(&m, &s, at, points);
    }
    random_stream s = random_start(seed, 0, 74);
    for (int k = 0; k < inside_methods; k++) {
        b[k].m = &m, b[k].soup = &soup, b[k].method = k;
        v[k] = (clock_variant){inside_names[k], run_inside, &b[k], 0};
        for (int i = 0; i < questions; i++)
            (void)inside_question(&m, &s, AT_VERTEX, &b[k].p[i], &b[k].d[i]);
    }
    clock_compare(v, inside_methods, most_rounds);
    for (int k = 0; k < inside_methods; k++) {
        double ns = 1e9 * v[k].seconds / questions / (double)m.triangles;
        table_text(&t, "%s", inside_names[k]);
        for (int at = 0; at < 3; at++)
            table_number(&t, 100 * (double)score[at].wrong[k] / (double)points);
        table_number(&t, ns);
        plot_add(against_time, plot_series(against_time, inside_names[k]), ns,
                 100 * (double)score[2].wrong[k] / (double)points);
    }
    mesh_free(&m), first_mesh_free(&soup);
    return t;
}

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    const mesh *m;
    const first_mesh *soup;  /* not NULL: ask this, by first.h */
    uint64_t seed;
    size_t rays;
    bool any;
    vec3 centre;
    real radius;
} cost_batch;

static inline double run_cost(void *context)
{
    const cost_batch *b = context;
    double sum = 0;
    random_stream s = random_start(b->seed, 0, 75);
    for (size_t i = 0; i < b->rays; i++) {
        vec3 aim = vmadd(b->centre, in_cube(&s, 1), b->radius / 2);
        vec3 o = vmadd(b->centre, direction(&s), 3 * b->radius);
        ray r = ray_from(o, vsub(aim, o));
        hit h = hit_none;
        if (b->any) sum += mesh_occluded(b->m, r);
        else if (b->soup ? first_mesh_hit(b->soup, r, &h) : mesh_hit(b->m, r, &h))
            sum += (double)h.t;
    }
    return sum;
}

static inline void cost_row(table *t, const char *method, const cost_batch *b, double us)
{
    table_text(t, "%s", method), table_count(t, b->m->triangles), table_count(t, b->rays);
    table_number(t, us), table_number(t, 1e3 * us / (double)b->m->triangles);
}

/* The first n/4^k triangles of m as meshes of their own, k = 0..5, some `tests` triangle tests
 * each time; and all of them once more by first.h. *exponent: slope of log time against log n, by
 * least squares; 1 for O(n). */
static inline table measure_cost(const mesh *m, uint64_t seed, size_t tests, plot *time,
                                 double *exponent)
{
    table t = table_new("Closest hit by brute force",
                        "method|triangles|rays|time a ray [us]|time a test [ns]|time any hit [us]");
    int closest = plot_series(time, "closest hit"), any = plot_series(time, "any hit");
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    vec3 lo, hi;
    if (!mesh_bounds(m, &lo, &hi)) lo = hi = (vec3){0, 0, 0};
    vec3 size = vsub(hi, lo), centre = vmadd(lo, size, 0.5);
    first_mesh soup = mesh_soup(m);
    for (int k = 5; k >= 0; k--) {
        mesh part = *m;
        part.triangles = m->triangles >> (2 * k);
        if (part.triangles < 50 && k > 0) continue;  /* there the call costs more than the tests */
        size_t rays = tests / part.triangles;
        rays = rays < 8 ? 8 : rays > 20000 ? 20000 : rays;
        cost_batch b[3];
        for (int i = 0; i < 3; i++)
            b[i] = (cost_batch){&part, i == 2 ? &soup : NULL, seed, rays, i == 1, centre,
                                vlength(size) / 2};
        clock_variant v[3] = {{"closest", run_cost, &b[0], 0}, {"any", run_cost, &b[1], 0},
                              {"first", run_cost, &b[2], 0}};
        clock_compare(v, k == 0 ? 3 : 2, 3);
        double us = 1e6 * v[0].seconds / (double)rays, any_us = 1e6 * v[1].seconds / (double)rays;
        cost_row(&t, "mesh_hit", &b[0], us), table_number(&t, any_us);
        plot_add(time, closest, (double)part.triangles, us);
        plot_add(time, any, (double)part.triangles, any_us);
        double a = log((double)part.triangles), c = log(us);
        n++, x += a, y += c, xx += a * a, xy += a * c;
        if (k > 0) continue;
        cost_row(&t, "first", &b[2], 1e6 * v[2].seconds / (double)rays), table_text(&t, "-");
    }
    first_mesh_free(&soup);
    *exponent = n > 1 ? (n * xy - x * y) / (n * xx - x * x) : 0;
    plot_slope(time, 1, "O(n)");
    return t;
}

#endif
