/* measure.h: one forest, all ways to search it: time, memory, other answers.
 *
 *   table_of_methods(&o)       the main table
 */
#ifndef INSTANCES_LAB_MEASURE_H
#define INSTANCES_LAB_MEASURE_H

#include "../../../common/lab/report.h"
#include "forest.h"

static inline void table_of_methods(const options *o);

/* ---------------------------------------------------------------------------------------------- */

/* A forest, its crowd, its instances with tight boxes, the rays to measure with. */
typedef struct {
    forest w;
    crowd c;
    instances x;
    double build;                /* seconds */
    ray *eye, *shadow;
    size_t eyes, shadows;
} survey;

typedef struct {
    const char *name;
    instances_boxes boxes;
    bool flat, unit;
    instances x;                 /* or, flattened: */
    mesh m;
    bvh b;
    const survey *s;
} method;

static inline void survey_make(survey *s, size_t n, int width, int height, uint64_t seed)
{
    failure f;
    instance_hit h;
    *s = (survey){.eyes = 0};
    forest_plant(&s->w, n, NULL, seed);
    s->c = (crowd){s->w.mesh, s->w.kinds, s->w.list, s->w.n};
    double start = clock_seconds();
    if (!instances_build(&s->c, instances_defaults, &s->x, &f)) fail(f);
    s->build = clock_seconds() - start;
    size_t most = (size_t)width * (size_t)height;
    s->eye = allocate(most, sizeof *s->eye), s->shadow = allocate(most, sizeof *s->shadow);
    camera c = forest_camera((real)width / (real)height);
    for (size_t i = 0; i < most; i++) {
        real px = (real)(i % (size_t)width) + (real)0.5, py = (real)(i / (size_t)width) + (real)0.5;
        s->eye[s->eyes++] = camera_ray(c, px, py, width, height);
        if (!instances_hit(&s->x, s->eye[i], &h)) continue;
        s->shadow[s->shadows] = ray_from(ray_at(s->eye[i], h.h.t), sun_direction());
        s->shadow[s->shadows++].tmin = 0.05;
    }
}

static inline void survey_free(survey *s)
{
    free(s->eye), free(s->shadow);
    instances_free(&s->x);
    forest_free(&s->w);
}

/* Seconds. */
static inline double method_build(method *m, const crowd *c)
{
    failure f;
    instances_options how = instances_defaults;
    how.boxes = m->boxes;
    double start = clock_seconds();
    if (m->flat) {
        m->m = crowd_flattened(c);
        bvh_build(&m->m, bvh_defaults, &m->b);
    } else if (!instances_build(c, how, &m->x, &f)) fail(f);
    return clock_seconds() - start;
}

static inline void method_free(method *m)
{
    instances_free(&m->x), bvh_free(&m->b), mesh_free(&m->m);
}

/* The hit as an instance and its triangle; flattened: h.shape counts all triangles. */
static inline bool method_hit(const method *m, ray r, instance_hit *h)
{
    if (m->flat) return bvh_hit(&m->b, r, &h->h);
    return m->unit ? instances_hit_naive(&m->x, r, h) : instances_hit(&m->x, r, h);
}

static inline double run_method_eye(void *context)
{
    const method *m = context;
    size_t hits = 0;
    instance_hit h;
    for (size_t i = 0; i < m->s->eyes; i++) hits += method_hit(m, m->s->eye[i], &h);
    return (double)hits;
}

static inline double run_method_shadow(void *context)
{
    const method *m = context;
    size_t hits = 0;
    for (size_t i = 0; i < m->s->shadows; i++)
        hits += m->flat ? bvh_occluded(&m->b, m->s->shadow[i])
                        : instances_occluded(&m->x, m->s->shadow[i]);
    return (double)hits;
}

static inline void time_methods(method *m, int n, double (*run)(void *), int rounds,
                                double *seconds)
{
    clock_variant v[8];
    for (int i = 0; i < n; i++) v[i] = (clock_variant){m[i].name, run, &m[i], 0};
    clock_compare(v, n, rounds);
    for (int i = 0; i < n; i++) seconds[i] = v[i].seconds;
}

static inline double per(double x, size_t n) { return n ? x / (double)n : 0; }

/* A small forest moved by `to`, n rays from the eye at corners of its plants: of each method, how
 * many have another answer than every instance asked in turn. Flattened, t alone is compared,
 * within 64 epsilon of the largest coordinate: at a corner it may well be another triangle. */
static inline void methods_wrong(method *m, int methods, vec3 to, size_t n, const options *o,
                                 size_t *wrong)
{
    forest w;
    forest_plant(&w, 60, NULL, o->seed);
    for (size_t i = 0; i < w.n; i++) w.list[i].to_world.o = vadd(w.list[i].to_world.o, to);
    crowd c = {w.mesh, w.kinds, w.list, w.n};
    affine *inverse = crowd_inverses(&c);
    vec3 eye = vadd(forest_camera(1).e, to);
    real bound = 64 * real_epsilon * (vlargest(to) + 100);
    for (int k = 0; k < methods; k++) {
        m[k].x = (instances){0}, m[k].b = (bvh){.triangle = NULL}, m[k].m = (mesh){0}, wrong[k] = 0;
        method_build(&m[k], &c);
    }
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(o->seed, i, 9);
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

static inline void method_row(table *out, const method *m, const size_t *wrong,
                              const double *seconds, double flat)
{
    instances_work w = {{0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}};
    instance_hit h;
    const survey *s = m->s;
    for (size_t i = 0; i < s->eyes; i++) {
        if (m->flat) bvh_hit_counted(&m->b, s->eye[i], &h.h, &w.lower);
        else instances_hit_counted(&m->x, s->eye[i], &h, &w);
    }
    size_t bytes = m->flat ? mesh_bytes(&m->m) + m->b.tree.bytes : m->x.bytes;
    for (size_t k = 0; !m->flat && k < s->c.meshes; k++) bytes += mesh_bytes(&s->c.mesh[k]);
    table_text(out, "%s", m->name);
    table_number(out, seconds[0] * 1e3), table_number(out, (double)bytes * 0x1p-20);
    table_number(out, per((double)w.upper.nodes, s->eyes));
    table_number(out, per((double)w.upper.tests, s->eyes));
    table_number(out, per((double)w.lower.nodes, s->eyes));
    table_number(out, per((double)w.lower.tests, s->eyes));
    table_count(out, wrong[0]), table_count(out, wrong[1]);
    table_number(out, per(seconds[1] * 1e9, s->eyes));
    table_number(out, per(seconds[2] * 1e9, s->shadows));
    table_number(out, seconds[1] / flat);
}

static inline void table_of_methods(const options *o)
{
    static const struct { const char *name; instances_boxes boxes; bool flat, unit; } list[5] = {
        {"flattened, one tree", INSTANCES_POINTS, true, false},
        {"boxes of points", INSTANCES_POINTS, false, false},
        {"boxes of corners", INSTANCES_CORNERS, false, false},
        {"boxes naive", INSTANCES_NAIVE, false, false},
        {"rays normalised", INSTANCES_POINTS, false, true}};
    method m[5];
    double build[5], eye[5], shadow[5];
    size_t wrong[2][5], corners = o->quick ? 20 : 500;
    survey s;
    vec3 far = {4e7, 4e7, 0};  /* once round the earth, in metres */
    survey_make(&s, o->quick ? 20 : 500, o->quick ? 40 : 160, o->quick ? 25 : 100, o->seed);
    for (int i = 0; i < 5; i++)
        m[i] = (method){.name = list[i].name, .boxes = list[i].boxes, .flat = list[i].flat,
                        .unit = list[i].unit, .s = &s};
    methods_wrong(m, 5, (vec3){0, 0, 0}, corners, o, wrong[0]);
    methods_wrong(m, 5, far, corners, o, wrong[1]);
    for (int i = 0; i < 5; i++) build[i] = method_build(&m[i], &s.c);
    time_methods(m, 5, run_method_eye, o->quick ? 1 : 5, eye);
    time_methods(m, 5, run_method_shadow, o->quick ? 1 : 5, shadow);
    char title[200];
    snprintf(title, sizeof title, "%zu instances, %.3g triangles: %zu rays from the eye, %zu to "
             "the sun, one thread; other answers of %zu at corners", s.c.n,
             instances_stats(&s.x).triangles, s.eyes, s.shadows, corners);
    table out = table_new(
        title, "method|time build [ms]|memory [MB]|upper nodes|instances|lower nodes|tests|"
               "error near|error far|time eye [ns]|time sun [ns]|time [flattened]");
    for (int i = 0; i < 5; i++) {
        const double seconds[3] = {build[i], eye[i], shadow[i]};
        const size_t both[2] = {wrong[0][i], wrong[1][i]};
        method_row(&out, &m[i], both, seconds, eye[0]);
    }
    output_table(o, &out);
    char label[40];
    snprintf(label, sizeof label, "other answers [of %zu]", corners);
    plot p = plot_new("Far from the origin: other answers than every instance asked", "eye [ns]",
                      label, PLOT_LOG_Y);
    for (int i = 0; i < 5; i++)
        plot_add(&p, plot_series(&p, m[i].name), per(eye[i] * 1e9, s.eyes), (double)wrong[1][i]);
    output_plot(o, &p, "16_instances_wrong_time.svg");
    for (int i = 0; i < 5; i++) method_free(&m[i]);
    survey_free(&s);
}

#endif
