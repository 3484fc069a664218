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
#include "../../14_bvh/bvh_mesh.h"
#include "flattened.h"
#include "forest.h"

/* A forest, its crowd, its instances with tight boxes, the rays from the eye to measure with. */
typedef struct {
    forest w;
    crowd c;
    instances x;
    double build;                /* seconds */
    ray_set eye;
} instances_survey;

typedef struct {
    const char *name;
    instances_boxes boxes;
    bool flat, unit, binary;     /* binary: the meshes in trees of 14 */
    const instances_survey *s;
    const crowd *c;              /* that it is built of */
    instances x;                 /* or, flattened: */
    mesh m;
    bvh8 b;
    bvh_mesh two[forest_kinds];
} instances_method;

/* ---------------------------------------------------------------------------------------------- */

static inline void survey_make(instances_survey *s, size_t n, const options *o)
{
    failure f;
    int width = o->quick ? 40 : 160, height = o->quick ? 25 : 100;
    forest_plant(&s->w, n, o->seed);
    s->c = (crowd){s->w.mesh, forest_kinds, s->w.list, s->w.n};
    double start = clock_seconds();
    if (!instances_build(&s->c, instances_defaults, &s->x, &f)) fail(f);
    s->build = clock_seconds() - start;
    s->eye = rays_primary(forest_camera((real)width / (real)height), width, height);
}

static inline void survey_free(instances_survey *s)
{
    rays_free(&s->eye), instances_free(&s->x), forest_free(&s->w);
}

/* Of the crowd m->c. */
static inline void method_build(size_t i, void *methods)
{
    failure f;
    instances_method *m = (instances_method *)methods + i;
    const crowd *c = m->c;
    instances_options how = instances_defaults;
    how.boxes = m->boxes;
    if (m->flat) m->m = crowd_flattened(c);
    const items flat = items_of_mesh(&m->m);
    if (m->flat ? !bvh8_build(&flat, bvh8_defaults, &m->b, &f)
                : !instances_build(c, how, &m->x, &f)) fail(f);
    for (size_t k = 0; m->binary && k < c->meshes; k++)
        if (!bvh_mesh_build(&c->mesh[k], bvh_defaults, &m->two[k], &f)) fail(f);
}

static inline void methods_build(instances_method *m, int n, const crowd *c)
{
    for (int k = 0; k < n; k++) m[k].c = c;
    parallel_whole((size_t)n, 0, "building", method_build, m);
}

static inline void method_free(instances_method *m)
{
    instances_free(&m->x), bvh8_free(&m->b), mesh_free(&m->m);
    for (size_t k = 0; k < forest_kinds; k++) bvh_mesh_free(&m->two[k]);
}

/* Without the caller's meshes, if it is flattened. */
static inline double method_megabytes(const instances_method *m)
{
    size_t bytes = m->flat ? mesh_bytes(&m->m) + m->b.room.bytes : m->x.bytes;
    for (size_t k = 0; !m->flat && k < m->s->c.meshes; k++) {
        bytes += mesh_bytes(&m->s->c.mesh[k]);
        if (m->binary) bytes += m->two[k].tree.held.bytes - m->x.lower[k].room.bytes;
    }
    return (double)bytes * 0x1p-20;
}

/* instances_leaf, but for the trees of the meshes. */
typedef struct { instances_context c; const bvh_mesh *lower; } binary_context;

fast_inline bool binary_leaf(const void *context, uint32_t first, uint32_t count, query *q,
                             bool any)
{
    const binary_context *b = context;
    bool found = false;
    (void)any;
    for (const placed *p = b->c.x->place + first, *end = p + count; p < end; p++) {
        const bvh_mesh *m = &b->lower[p->mesh];
        ray r;
        hit h;
        if (!instance_ray(&p->to_object, q->r, &r)) continue;
        if (!(b->c.lower ? bvh_mesh_hit_counted(m, r, &h, b->c.lower) : bvh_mesh_hit(m, r, &h)))
            continue;
        uint32_t k = h.shape;
        h.shape = p->index;
        if (query_improves(q, h)) *b->c.triangle = k, found = true;
    }
    return found;
}

static inline bool binary_hit(const instances_method *m, ray r, instance_hit *out,
                              instances_work *work)
{
    const binary_context b = {{&m->x, &out->h.shape, work ? &work->lower : NULL, false}, m->two};
    hit h;
    if (!tree_search(&m->x.tree, r, instances_box_ray, binary_leaf, &b, false, &h,
                     work ? &work->upper : NULL)) return false;
    *out = (instance_hit){{h.t, h.u, h.v, out->h.shape}, h.shape};
    return true;
}

/* The hit as an instance and its triangle; flattened: h.shape counts all triangles. */
static inline bool method_hit(const instances_method *m, ray r, instance_hit *h)
{
    if (m->flat) return bvh8_hit(&m->b, r, &h->h);
    if (m->binary) return binary_hit(m, r, h, NULL);
    return m->unit ? instances_hit_naive(&m->x, r, h) : instances_hit(&m->x, r, h);
}

static inline double method_search(void *context)
{
    const instances_method *m = context;
    size_t hits = 0;
    instance_hit h;
    for (size_t i = 0; i < m->s->eye.n; i++) hits += method_hit(m, m->s->eye.r[i], &h);
    return (double)hits;
}

/* A small forest moved by `to`, n rays from the eye at corners of its plants: of each method, how
 * many have another answer than every instance asked in turn. Flattened, t alone is compared,
 * within 64 epsilon of the largest coordinate: at a corner it may well be another triangle. */
static inline void methods_wrong(instances_method *m, int methods, vec3 to, size_t n,
                                 uint64_t seed, size_t *wrong)
{
    forest w;
    forest_plant(&w, 60, seed);
    for (size_t i = 0; i < w.n; i++) w.list[i].to_world.o = vadd(w.list[i].to_world.o, to);
    crowd c = {w.mesh, forest_kinds, w.list, w.n};
    affine *inverse = crowd_inverses(&c);
    vec3 eye = vadd(forest_camera(1).e, to);
    real bound = 64 * real_epsilon * (vlargest(to) + 100);
    methods_build(m, methods, &c);
    for (int k = 0; k < methods; k++) wrong[k] = 0;
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
            bool got = method_hit(&m[k], r, &h), same;
            if (m[k].flat) same = fabs(h.h.t - due.t) * vlength(r.d) <= bound;
            else same = h.h.t == due.t && h.h.shape == due.shape && h.instance == which;
            wrong[k] += is != got || (is && !same);
        }
    }
    for (int k = 0; k < methods; k++) method_free(&m[k]);
    free(inverse);
    forest_free(&w);
}

/* How far both levels are searched for a ray from the eye: instances looked into, triangles. */
static inline void method_work(const instances_method *m, double *entered, double *tests)
{
    instances_work w = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    instance_hit h;
    const ray_set *s = &m->s->eye;
    for (size_t i = 0; i < s->n; i++) {
        if (m->flat) bvh8_hit_counted(&m->b, s->r[i], &h.h, &w.lower);
        else if (m->binary) binary_hit(m, s->r[i], &h, &w);
        else instances_hit_counted(&m->x, s->r[i], &h, &w);
    }
    *entered = (double)w.upper.tests / (double)s->n, *tests = (double)w.lower.tests / (double)s->n;
}

static inline void table_of_methods(const options *o)
{
    enum { n = 6 };
    instances_survey s;
    instances_method m[n] = {
        {"flattened, one tree", .boxes = INSTANCES_POINTS, .flat = true},
        {"boxes of points", .boxes = INSTANCES_POINTS},
        {"meshes as in 14", .boxes = INSTANCES_POINTS, .binary = true},
        {"boxes of corners", .boxes = INSTANCES_CORNERS}, {"boxes naive", .boxes = INSTANCES_NAIVE},
        {"rays normalised", .boxes = INSTANCES_POINTS, .unit = true}};
    double eye[n];
    size_t near[n], far[n], corners = o->quick ? 20 : 100;
    vec3 earth = {4e7, 4e7, 0};  /* once round the earth, in metres */
    survey_make(&s, o->quick ? 20 : 100, o);
    methods_wrong(m, n, (vec3){0, 0, 0}, corners, o->seed, near);
    methods_wrong(m, n, earth, corners, o->seed, far);
    methods_build(m, n, &s.c);
    for (int i = 0; i < n; i++) m[i].s = &s;
    bench_each(method_search, m, sizeof *m, n, o->full ? 5 : 1,
               1e9 / (double)s.eye.n, eye);
    char title[160];
    snprintf(title, sizeof title, "%zu instances, %.3g triangles: %zu rays from the eye; wrong "
             "answers of %zu at corners", s.c.n, flattened_triangles(&s.x), s.eye.n, corners);
    table out = table_new(title, "method|memory [MB]|instances a ray|triangles a ray|error near|"
                                 "error far|time eye [ns]");
    plot p = plot_new("Far from the origin: other answers than every instance asked", "eye [ns]",
                      "wrong answers of 100", PLOT_LOG_Y);
    for (int i = 0; i < n; i++) {
        double entered, tests;
        method_work(&m[i], &entered, &tests);
        table_text(&out, "%s", m[i].name), table_number(&out, method_megabytes(&m[i]));
        table_number(&out, entered), table_number(&out, tests);
        table_count(&out, near[i]), table_count(&out, far[i]), table_number(&out, eye[i]);
        plot_add(&p, plot_series(&p, m[i].name), eye[i], (double)far[i]);
        method_free(&m[i]);
    }
    output_table(o, &out);
    output_plot(o, &p, "16_instances_wrong_time.svg");
    survey_free(&s);
}

/* Flattened it is built up to a hundred; from there on its memory is that of as many triangles. */
static inline void table_of_growth(const options *o)
{
    double mb_a_triangle = 0;
    table out = table_new("Growth with the number of instances; flattened: built up to 100",
                          "instances|triangles|memory [MB]|flattened [MB]|build [ms]|"
                          "instances a ray|eye [ns]");
    for (size_t n = 1; n <= (o->quick ? 10 : 100000); n *= 10) {
        instances_survey s;
        double ns, entered, tests;
        survey_make(&s, n, o);
        instances_method two = {.x = s.x, .s = &s}, flat = {.flat = true, .s = &s};
        bench_each(method_search, &two, sizeof two, 1, o->quick ? 1 : 5, 1e9 / (double)s.eye.n,
                   &ns);
        method_work(&two, &entered, &tests);
        double triangles = flattened_triangles(&s.x);
        if (n <= 100) {
            methods_build(&flat, 1, &s.c);
            mb_a_triangle = method_megabytes(&flat) / triangles;
            method_free(&flat);
        }
        const double cell[] = {triangles, method_megabytes(&two), mb_a_triangle * triangles,
                               s.build * 1e3, entered, ns};
        table_count(&out, n);
        for (size_t k = 0; k < sizeof cell / sizeof *cell; k++) table_number(&out, cell[k]);
        survey_free(&s);
    }
    output_extra_table(o, &out);
}

#endif
