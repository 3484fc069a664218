/* measure.h: one forest, all ways to search it: time, memory, other answers.
 *
 *   table_of_methods(&o)       the main table, and its plot
 *   table_of_growth(&o)        memory and time from 1 to 1e5 instances
 */
#ifndef INSTANCES_LAB_MEASURE_H
#define INSTANCES_LAB_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../09_aabb/trials/survey.h"
#include "first_forest.h"
#include "flattened.h"
#include "forest.h"

typedef struct {
    const char *name;
    instances_boxes boxes;
    bool flat, unit, first;
    instances x;                 /* or, flattened: */
    mesh m;
    bvh8 b;
    first_forest f;              /* or, by first.h, this */
    double bytes;                /* without normals */
    ray_set eye;                 /* to be timed with */
    double entered;              /* of these: instances looked into a ray */
} instances_method;

/* ---------------------------------------------------------------------------------------------- */

static inline void method_build(instances_method *m, const crowd *c)
{
    failure f;
    if (m->first) {
        m->f = first_forest_of(c), m->bytes = (double)first_forest_bytes(&m->f);
        return;
    }
    instances_options how = instances_defaults;
    how.boxes = m->boxes;
    if (m->flat) m->m = crowd_flattened(c);
    const items flat = items_of_mesh(&m->m);
    if (m->flat ? !bvh8_build(&flat, bvh8_defaults, &m->b, &f)
                : !instances_build(c, how, &m->x, &f)) fail(f);
    size_t bytes = mesh_bytes(&m->m) + m->b.room.bytes + m->x.bytes;
    for (size_t k = 0; k < m->x.meshes; k++) bytes += mesh_bytes(&c->mesh[k]);
    m->bytes = (double)bytes;
}

static inline void method_free(instances_method *m)
{
    instances_free(&m->x), bvh8_free(&m->b), mesh_free(&m->m), first_forest_free(&m->f);
}

/* The hit as an instance and its triangle; flattened: h.shape counts all triangles. */
fast_inline bool method_hit(const instances_method *m, ray r, instance_hit *out,
                            instances_work *work)
{
    if (m->first && work) work->upper.tests += m->f.n;
    if (m->first) return first_forest_hit(&m->f, r, &out->h);
    if (m->flat) return bvh8_ask(&m->b, r, bvh8_skip_none, &out->h, work ? &work->lower : NULL);
    return instances_walk(&m->x, r, false, m->unit, out, work);
}

static inline double method_search(void *context)
{
    const instances_method *m = context;
    size_t hits = 0;
    instance_hit h;
    for (size_t i = 0; i < m->eye.n; i++) hits += method_hit(m, m->eye.r[i], &h, NULL);
    return (double)hits;
}

/* A small forest moved by `to`, n rays from the eye at corners of its plants: of each method, how
 * many have another answer than every instance asked in turn. Flattened, and by first.h, t
 * alone is compared, within 64 epsilon of the largest coordinate: at a corner it may be another
 * triangle. */
static inline void methods_wrong(instances_method *m, int methods, vec3 to, size_t n,
                                 uint64_t seed, size_t *wrong)
{
    forest w;
    forest_plant(&w, 60, seed);
    for (size_t i = 0; i < w.n; i++) w.list[i].to_world.o = vadd(w.list[i].to_world.o, to);
    crowd c = forest_crowd(&w);
    affine *inverse = crowd_inverses(&c);
    vec3 eye = vadd(forest_camera(1).e, to);
    real bound = 64 * real_epsilon * (vlargest(to) + 100);
    for (int k = 0; k < methods; k++) wrong[k] = 0, method_build(&m[k], &c);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 9);
        const instance *p = &w.list[1 + random_next_bits(&g) % (w.n - 1)];
        const mesh *part = &w.mesh[p->mesh];
        vec3 at = affine_point(p->to_world, part->v[random_next_bits(&g) % part->vertices]);
        ray r = ray_from(eye, vsub(at, eye));
        hit due = hit_none;
        uint32_t which = 0;
        bool is = crowd_hit(&c, inverse, r, &due, &which);
        for (int k = 0; k < methods; k++) {
            instance_hit h = {hit_none, 0};
            bool got = method_hit(&m[k], r, &h, NULL), same;
            if (m[k].flat || m[k].first) same = fabs(h.h.t - due.t) * vlength(r.d) <= bound;
            else same = h.h.t == due.t && h.h.shape == due.shape && h.instance == which;
            wrong[k] += is != got || (is && !same);
        }
    }
    for (int k = 0; k < methods; k++) method_free(&m[k]);
    free(inverse), forest_free(&w);
}

static inline void method_warm(void *m) { method_search(m); }

/* All warm before their turns: a flattened tree is ten times as large as the others. */
static inline void methods_time(instances_method *m, int n, ray_set eye, const options *o,
                                double *ns)
{
    double rays = (double)eye.n;
    instance_hit h;
    bench_candidate c[8];
    for (int k = 0; k < n; k++) {
        instances_work w = {{0, 0, 0, 0}, {0, 0, 0, 0}};
        for (size_t i = 0; i < eye.n; i++) method_hit(&m[k], eye.r[i], &h, &w);
        m[k].entered = (double)w.upper.tests / rays;
        m[k].eye = eye;
        c[k] = (bench_candidate){.run = method_search, .warm = method_warm, .context = &m[k]};
    }
    bench_time(c, n, o->full ? 5 : 1);
    for (int k = 0; k < n; k++) ns[k] = c[k].seconds * 1e9 / rays;
}

static inline ray_set eye_rays(const options *o)
{
    int width = o->quick ? 40 : 160, height = o->quick ? 25 : 100;
    return rays_primary(forest_camera((real)width / (real)height), width, height);
}

static inline void table_of_methods(const options *o)
{
    enum { n = 6 };
    instances_method m[n] = {
        {"first.h", .first = true}, {"flattened, one tree", .flat = true},
        {"boxes of points", .boxes = INSTANCES_POINTS},
        {"boxes of corners", .boxes = INSTANCES_CORNERS}, {"boxes naive", .boxes = INSTANCES_NAIVE},
        {"rays normalised", .boxes = INSTANCES_POINTS, .unit = true}};
    double ns[n];
    size_t near[n], far[n], corners = o->quick ? 20 : 100;
    ray_set eye = eye_rays(o);
    forest w;
    forest_plant(&w, o->quick ? 20 : 100, o->seed);
    crowd c = forest_crowd(&w);
    methods_wrong(m, n, (vec3){0, 0, 0}, corners, o->seed, near);
    methods_wrong(m, n, (vec3){4e7, 4e7, 0}, corners, o->seed, far);  /* once round the earth [m] */
    for (int i = 0; i < n; i++) method_build(&m[i], &c);
    methods_time(m, n, eye, o, ns);
    double triangles = flattened_triangles(&m[2].x);
    char title[160];
    snprintf(title, sizeof title, "%zu instances, %.3g triangles: %zu rays from the eye; wrong "
             "answers of %zu at corners", c.n, triangles, eye.n, corners);
    table out = table_new(title, "method|bytes a shape|instances a ray|error near|error far|"
                                 "time eye [ns]");
    plot p = plot_new("Far from the origin: other answers than every instance asked", "eye [ns]",
                      "wrong answers of 100", PLOT_LOG_X | PLOT_LOG_Y);
    for (int i = 0; i < n; i++) {
        table_text(&out, "%s", m[i].name), table_number(&out, m[i].bytes / triangles);
        table_number(&out, m[i].entered), table_count(&out, near[i]);
        table_count(&out, far[i]), table_number(&out, ns[i]);
        plot_add(&p, plot_series(&p, m[i].name), ns[i], (double)far[i]);
        method_free(&m[i]);
    }
    output_table(o, &out);
    output_plot(o, &p, "16_instances_wrong_time.svg");
    rays_free(&eye), forest_free(&w);
}

/* Flattened it is built up to a hundred; from there on its memory is that of as many triangles. */
static inline void table_of_growth(const options *o)
{
    double a_triangle = 0, mb = 0x1p-20;
    ray_set eye = eye_rays(o);
    table out = table_new("Growth with the number of instances; flattened: built up to 100",
                          "instances|triangles|memory [MB]|flattened [MB]|build [ms]|"
                          "instances a ray|eye [ns]");
    for (size_t n = 1; n <= (o->quick ? 10 : 100000); n *= 10) {
        instances_method two = {.boxes = INSTANCES_POINTS}, flat = {.flat = true};
        double ns;
        forest w;
        forest_plant(&w, n, o->seed);
        crowd c = forest_crowd(&w);
        double start = clock_seconds();
        method_build(&two, &c);
        double built = clock_seconds() - start, triangles = flattened_triangles(&two.x);
        methods_time(&two, 1, eye, o, &ns);
        if (n <= 100) method_build(&flat, &c), a_triangle = flat.bytes / triangles;
        const double cell[] = {triangles, two.bytes * mb, a_triangle * triangles * mb, built * 1e3,
                               two.entered, ns};
        table_count(&out, n);
        for (size_t k = 0; k < sizeof cell / sizeof *cell; k++) table_number(&out, cell[k]);
        method_free(&two), method_free(&flat), forest_free(&w);
    }
    output_extra_table(o, &out);
    rays_free(&eye);
}

#endif
