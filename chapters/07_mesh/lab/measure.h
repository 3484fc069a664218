/* measure.h: the tables and plots of this chapter. Errors are those of trials.h, times medians of
 * interleaved rounds.
 *
 *   inside_report(&o);                 answers to "inside?": errors and times; the main table
 *   mesh m = mesh_measured(path);      an OBJ file, and how fast it was read
 *   cost_report(&o, &m, is_main);      the closest hit in parts of a mesh: O(n)
 */
#ifndef MESH_LAB_MEASURE_H
#define MESH_LAB_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../files/obj.h"
#include "../scenes/teapot.h"
#include "trials.h"

/* ---------------------------------------------------------------------------------------------- */

enum { mesh_rounds = 7, inside_questions = 32 };

typedef struct {
    const mesh *m;
    const first_mesh *soup;
    int method;
    vec3 p[inside_questions], d[inside_questions];
} inside_batch;

static inline double inside_run(void *context)
{
    const inside_batch *b = context;
    int sum = 0;
    for (int i = 0; i < inside_questions; i++)
        sum += inside_ask(b->method, b->m, b->soup, b->p[i], b->d[i]);
    return sum;
}

cold_inline void inside_report(const options *o)
{
    static inside_batch b[inside_methods];
    double seconds[inside_methods];
    size_t points = o->quick ? 50 : 1000;
    mesh m = torus_mesh(24);
    first_mesh soup = first_mesh_of(&m);
    plot against_time = plot_new("Point in mesh, rays through vertices", "time [ns a triangle]",
                                 "wrong [%]", PLOT_LOG_X);
    table t = table_new(
        "Point in a closed mesh of 1152 triangles, rays aimed at",
        "method|error: random [% wrong]|error: an edge|error: a vertex|time [ns a triangle]");
    inside_score score[3];
    for (inside_aim at = AT_RANDOM; at <= AT_VERTEX; at++) {
        random_stream s = random_start(o->seed, (uint64_t)at, 73);
        score[at] = inside_play(&m, &s, at, points);
    }
    for (int k = 0; k < inside_methods; k++) {
        random_stream s = random_start(o->seed, 0, 74);
        b[k].m = &m, b[k].soup = &soup, b[k].method = k;
        for (int i = 0; i < inside_questions; i++)
            (void)inside_question(&m, &s, AT_VERTEX, 0, &b[k].p[i], &b[k].d[i]);
    }
    bench_each(inside_run, b, sizeof *b, inside_methods, mesh_rounds, 1, seconds);
    for (int k = 0; k < inside_methods; k++) {
        double ns = 1e9 * seconds[k] / inside_questions / (double)m.triangles;
        bool casts = k + 1 < inside_methods;
        table_text(&t, "%s", inside_names[k]);
        for (int at = 0; at < 3; at++)
            if (casts || at == AT_RANDOM)
                table_number(&t, 100 * (double)score[at].wrong[k] / (double)points);
            else table_text(&t, "-");
        table_number(&t, ns);
        plot_add(&against_time, plot_series(&against_time, inside_names[k]), ns,
                 100 * (double)score[casts ? AT_VERTEX : AT_RANDOM].wrong[k] / (double)points);
    }
    mesh_free(&m), first_mesh_free(&soup);
    output_table(o, &t);
    output_plot(o, &against_time, "07_mesh_inside_time.svg");
}

/* ---------------------------------------------------------------------------------------------- */

/* Ends the program if the file is none. Once only: what is read first may come from the disk. */
static inline mesh mesh_measured(const char *path)
{
    failure f;
    mesh m;
    struct stat file;
    double begin = clock_seconds();
    if (!obj_read(path, &m, &f)) fail(f);
    double seconds = clock_seconds() - begin;
    printf("# %s: %zu points, %zu triangles", path, m.vertices, m.triangles);
    if (stat(path, &file) == 0 && file.st_size > 0)  /* of a pipe nobody knows */
        printf("; read at %.0f MB/s", (double)file.st_size / seconds / 1e6);
    puts("");
    (void)obj_libraries_missing(&m, path);
    return m;
}

/* ---------------------------------------------------------------------------------------------- */

enum { ASK_CLOSEST, ASK_ANY, ASK_FIRST };

typedef struct {
    const mesh *m;
    const first_mesh *soup;
    uint64_t seed;
    size_t rays;
    vec3 centre;
    real radius;
    int what;  /* ASK_CLOSEST .. */
} cost_batch;

static inline double cost_run(void *context)
{
    const cost_batch *b = context;
    double sum = 0;
    random_stream s = random_start(b->seed, 0, 75);
    for (size_t i = 0; i < b->rays; i++) {
        vec3 aim = vmadd(b->centre, random_in_cube(&s, 1), b->radius / 2);
        vec3 o = vmadd(b->centre, direction(&s), 3 * b->radius);
        ray r = ray_from(o, vsub(aim, o));
        hit h = hit_none;
        bool is = b->what == ASK_ANY ? mesh_occluded(b->m, r)
                : b->what == ASK_FIRST ? first_mesh_hit(b->soup, r, &h) : mesh_hit(b->m, r, &h);
        sum += !is ? 0 : b->what == ASK_ANY ? 1 : (double)h.t;
    }
    return sum;
}

/* The first n/4^k triangles of m as meshes of their own, k = 0..5; and all of them by first.h. The
 * last line: the exponent of n, from the smallest and the largest. */
cold_inline void cost_report(const options *o, const mesh *m, bool is_main)
{
    table t = table_new("Closest hit by brute force",
                        "method|triangles|rays|time a ray [us]|time a test [ns]|time any hit [us]");
    double least = 0, least_us = 1, us[3] = {1, 0, 0};
    vec3 lo, hi;
    if (!mesh_bounds(m, &lo, &hi)) lo = hi = (vec3){0, 0, 0};
    first_mesh soup = first_mesh_of(m);
    for (int k = 5; k >= 0; k--) {
        mesh part = *m;
        part.triangles = m->triangles >> (2 * k);
        if (part.triangles < 50 && k > 0) continue;  /* there the call costs more than the tests */
        size_t rays = (o->quick ? 50000 : 1000000) / part.triangles;
        rays = rays < 8 ? 8 : rays > 20000 ? 20000 : rays;
        cost_batch b[3];
        for (int i = 0; i < 3; i++)
            b[i] = (cost_batch){&part, &soup, o->seed, rays, vmadd(lo, vsub(hi, lo), 0.5),
                                vlength(vsub(hi, lo)) / 2, i};
        bench_each(cost_run, b, sizeof *b, k == 0 ? 3 : 2, 3, 1e6 / (double)rays, us);
        if (least == 0) least = (double)part.triangles, least_us = us[0];
        for (int i = 0; i < (k == 0 ? 3 : 1); i += 2) {
            table_text(&t, i ? "first" : "mesh_hit"), table_count(&t, part.triangles);
            table_count(&t, rays), table_number(&t, us[i]);
            table_number(&t, 1e3 * us[i] / (double)part.triangles);
            if (i) table_text(&t, "-");
            else table_number(&t, us[1]);
        }
    }
    first_mesh_free(&soup);
    (is_main ? output_table : output_extra_table)(o, &t);
    if ((double)m->triangles > least)
        printf("# time ~ n^%.3f\n", log(us[0] / least_us) / log((double)m->triangles / least));
}

#endif
