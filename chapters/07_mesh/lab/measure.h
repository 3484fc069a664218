/* measure.h: the tables and plots of this chapter. Errors are those of trials.h, times medians of
 * interleaved rounds.
 *
 *   inside_report(&o);                 answers to "inside?": errors and times; the main table
 *   cost_report(&o, &m, is_main);      the closest hit in parts of a mesh: O(n)
 *   shapes_report(&o);                 cones and polygons, the textbook's and ours
 *   files_report(&o);                  reading OBJ files: megabytes a second
 */
#ifndef MESH_LAB_MEASURE_H
#define MESH_LAB_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../files/obj.h"
#include "../files/obj_write.h"
#include "../scenes/teapot.h"
#include "trials.h"

/* ---------------------------------------------------------------------------------------------- */

enum { cones_at_once = 1024, mesh_rounds = 7, inside_questions = 32 };

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

static inline void inside_report(const options *o)
{
    static inside_batch b[inside_methods];
    double seconds[inside_methods];
    size_t points = o->quick ? 50 : 1000;
    mesh m = torus_mesh(24);
    first_mesh soup = mesh_soup(&m);
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

typedef struct {
    const mesh *m;
    const first_mesh *soup;  /* not NULL: ask this, by first.h */
    uint64_t seed;
    size_t rays;
    bool any;
    vec3 centre;
    real radius;
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

/* The first n/4^k triangles of m as meshes of their own, k = 0..5; and all of them by first.h. The
 * last line: the exponent of n, from the smallest and the largest. */
static inline void cost_report(const options *o, const mesh *m, bool is_main)
{
    size_t tests = o->quick ? 200000 : 1000000;
    table t = table_new("Closest hit by brute force",
                        "method|triangles|rays|time a ray [us]|time a test [ns]|time any hit [us]");
    double least = 0, least_us = 1, us = 1;
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
            b[i] = (cost_batch){&part, i == 2 ? &soup : NULL, o->seed, rays, i == 1, centre,
                                vlength(size) / 2};
        bench_candidate v[3] = {{"closest", cost_run, &b[0], 0, 0}, {"any", cost_run, &b[1], 0, 0},
                                {"first", cost_run, &b[2], 0, 0}};
        bench_time(v, k == 0 ? 3 : 2, 3);
        us = 1e6 * v[0].seconds / (double)rays;
        if (least == 0) least = (double)part.triangles, least_us = us;
        double any_us = 1e6 * v[1].seconds / (double)rays;
        cost_row(&t, "mesh_hit", &b[0], us), table_number(&t, any_us);
        if (k > 0) continue;
        cost_row(&t, "first", &b[2], 1e6 * v[2].seconds / (double)rays), table_text(&t, "-");
    }
    first_mesh_free(&soup);
    (is_main ? output_table : output_extra_table)(o, &t);
    if ((double)m->triangles > least)
        printf("# time ~ n^%.3f\n", log(us / least_us) / log((double)m->triangles / least));
}

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    cone c[cones_at_once];
    ray r[cones_at_once];
    bool (*hit)(cone, ray, hit *);
} cone_batch;

static inline double cone_run(void *context)
{
    const cone_batch *b = context;
    double sum = 0;
    hit h = hit_none;
    for (int i = 0; i < cones_at_once; i++)
        sum += b->hit(b->c[i], b->r[i], &h) ? (double)h.t : 1;
    return sum;
}

/* One row for each method: wrong answers where rays graze, distance from the side where they do
 * not. */
static inline void cone_rows(uint64_t seed, size_t rays, table *t)
{
    static cone_batch b[2];
    const char *name[2] = {"cone_hit_naive", "cone_hit"};
    for (int power = 0; power <= 6; power += 2) {
        real distance = pow((real)10, power);
        cone_score sum = {0, 0, {0, 0}, {0, 0}, {0, 0}};
        double ns[2];
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
        for (int i = 0; i < cones_at_once; i++) {
            b[0].c[i] = b[1].c[i] = some_cone(&s, i % 5);
            b[0].r[i] = b[1].r[i] = ray_at_cone(&s, b[0].c[i], AIM_RANDOM, distance);
        }
        b[0].hit = cone_hit_naive, b[1].hit = cone_hit;
        bench_each(cone_run, b, sizeof *b, 2, mesh_rounds, 1e9 / cones_at_once, ns);
        for (int k = 0; k < 2; k++) {
            table_text(t, "%s", name[k]), table_text(t, "from 1e%d", power);
            table_number(t, 100 * (double)sum.wrong[k] / (double)sum.decided);
            table_number(t, sum.off_side[k]), table_number(t, ns[k]);
        }
    }
}

typedef struct { polygon p; ray r[cones_at_once]; bool naive; } polygon_batch;

static inline double polygon_run(void *context)
{
    const polygon_batch *b = context;
    double sum = 0;
    hit h = hit_none;
    for (int i = 0; i < cones_at_once; i++)
        sum += (b->naive ? polygon_hit_naive : polygon_hit)(b->p, b->r[i], &h) ? (double)h.t : 1;
    return sum;
}

/* A quad of the gear wheel. */
static inline void polygon_rows(uint64_t seed, size_t rays, table *t)
{
    static gear_box box;
    static polygon_batch b[2];
    for (int j = 0; j < 2; j++) {
        double ns[2];
        size_t slips[2];
        random_stream s = random_start(seed, (uint64_t)j, 72), again;
        gear_box_fill(&box, &s, j ? 100000 : 0, false);
        again = s;
        for (int k = 0; k < 2; k++) {
            s = again;
            slips[k] = gear_box_slips(&box, &s, rays, k == 0);
            b[k].p = box.shapes[2].polygon, b[k].naive = k == 0;
            for (int i = 0; i < cones_at_once; i++) b[k].r[i] = gear_box_ray(&box, &s, (size_t)i);
        }
        bench_each(polygon_run, b, sizeof *b, 2, mesh_rounds, 1e9 / cones_at_once, ns);
        for (int k = 0; k < 2; k++) {
            table_text(t, k ? "polygon_hit" : "polygon_hit_naive");
            table_text(t, "quad, %s", j ? "1e5 away" : "at the origin");
            table_number(t, 100 * (double)slips[k] / (double)rays);
            table_text(t, "-"), table_number(t, ns[k]);
        }
    }
}

/* `wrong` of cones: grazing rays with another answer than the oracle's; of polygons: rays from
 * inside a gear wheel, aimed at its corners and edges, that leave it unseen. */
static inline void shapes_report(const options *o)
{
    size_t rays = o->quick ? 500 : 20000;
    table t = table_new("Cones and polygons: error against time",
                        "method|rays|error: wrong [%]|error: off the side|time [ns]");
    cone_rows(o->seed, rays, &t);
    polygon_rows(o->seed, rays, &t);
    output_extra_table(o, &t);
}

/* ---------------------------------------------------------------------------------------------- */

typedef struct { const char *path; bool first; } files_batch;

static inline double files_run(void *context)
{
    const files_batch *b = context;
    double n;
    failure f;
    if (b->first) {
        first_mesh s = first_obj_read(b->path);
        n = s.n, first_mesh_free(&s);
    } else {
        mesh m;
        if (!obj_read(b->path, &m, &f)) fail(f);
        n = (double)m.triangles, mesh_free(&m);
    }
    return n;
}

/* The teapot as a file of points, normals and faces i//n. */
static inline void files_report(const options *o)
{
    const char *const path = "build/07_mesh_teapot.obj";
    failure f;
    struct stat file;
    mesh m = teapot_mesh(50);
    mkdir("build", 0777);  /* if that fails, writing the file says why */
    if (!obj_write(path, &m, &f)) fail(f);
    stat(path, &file);
    files_batch b[2] = {{path, true}, {path, false}};
    double seconds[2];
    bench_each(files_run, b, sizeof *b, 2, mesh_rounds, 1, seconds);
    table t = table_new("Reading an OBJ file", "method|triangles|bytes|time [MB/s]");
    for (int k = 0; k < 2; k++) {
        table_text(&t, k ? "obj_read" : "first_obj_read"), table_count(&t, m.triangles);
        table_count(&t, (size_t)file.st_size);
        table_number(&t, (double)file.st_size / seconds[k] / 1e6);
    }
    output_extra_table(o, &t);
    unlink(path), mesh_free(&m);
}

#endif
