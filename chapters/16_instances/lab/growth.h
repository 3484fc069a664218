/* growth.h: memory and time against the number of instances; what the way into object space costs;
 * normals against scales.
 *
 *   table_of_growth(&o)      from 1 to 1e5 instances; two plots
 *   table_of_way(&o)         ns from a ray in the world to one ready for the tree of a mesh
 *   table_of_normals(&o)     angle by which M n is off
 */
#ifndef INSTANCES_LAB_GROWTH_H
#define INSTANCES_LAB_GROWTH_H

#include "measure.h"

/* ---------------------------------------------------------------------------------------------- */

/* Where it is not built, flattened memory is computed from the bytes a triangle of what was. */
static inline void table_of_growth(const options *o)
{
    static const size_t number[] = {1, 10, 100, 300, 1000, 10000, 100000};
    int n = o->quick ? 2 : 7, built = o->quick ? 2 : 4;  /* flattened: while it fits */
    double mb_a_triangle = 0;
    table out = table_new(
        "Growth with the number of instances; flattened: memory from its bytes a triangle where "
        "it was not built",
        "instances|triangles|memory [MB]|flattened [MB]|build [ms]|flattened [ms]|instances a ray|"
        "eye [ns]|flattened [ns]|ratio");
    plot p = plot_new("Memory of a forest", "instances", "memory [MB]", PLOT_LOG_X | PLOT_LOG_Y);
    plot q = plot_new("A ray from the eye", "instances", "time [ns]", PLOT_LOG_X);
    int two = plot_series(&p, "two levels"), flat = plot_series(&p, "flattened, built");
    int guess = plot_series(&p, "flattened, computed");
    int two_time = plot_series(&q, "two levels"), flat_time = plot_series(&q, "flattened");
    for (int i = 0; i < n; i++) {
        instances_survey s;
        bool with = i < built;
        double x = (double)number[i], eye[2] = {0, 0};
        survey_make(&s, number[i], o->quick ? 40 : 120, o->quick ? 25 : 75, o->seed);
        instances_method m[2] = {{.name = "two", .x = s.x, .s = &s},
                                 {.name = "flat", .flat = true, .s = &s}};
        double flat_build = with ? method_build(&m[1], &s.c) : 0;
        methods_time(m, 1 + with, false, o->quick ? 1 : 7, eye);
        instances_work w = {{0, 0, 0, 0}, {0, 0, 0, 0}};
        instance_hit h;
        for (size_t k = 0; k < s.eye.n; k++) instances_hit_counted(&s.x, s.eye.r[k], &h, &w);
        double triangles = instances_stats(&s.x).triangles, mb = method_megabytes(&m[0]);
        if (with) mb_a_triangle = method_megabytes(&m[1]) / triangles;
        double flat_mb = mb_a_triangle * triangles;
        const double cell[] = {mb, flat_mb, s.build * 1e3, with ? flat_build * 1e3 : -1,
                               per((double)w.upper.tests, s.eye.n), eye[0], with ? eye[1] : -1,
                               with ? eye[0] / eye[1] : -1};
        table_count(&out, number[i]), table_number(&out, triangles);
        for (size_t k = 0; k < sizeof cell / sizeof *cell; k++)
            if (cell[k] < 0) table_text(&out, "-");
            else table_number(&out, cell[k]);
        plot_add(&p, two, x, mb), plot_add(&q, two_time, x, eye[0]);
        if (with) plot_add(&p, flat, x, flat_mb), plot_add(&q, flat_time, x, eye[1]);
        if (i + 1 >= built) plot_add(&p, guess, x, flat_mb);  /* from the last on */
        bvh_mesh_free(&m[1].b), mesh_free(&m[1].m);
        survey_free(&s);
    }
    output_extra_table(o, &out);
    output_plot(o, &p, "16_instances_memory.svg");
    output_plot(o, &q, "16_instances_time.svg");
}

enum { way_transforms = 1024 };
typedef struct {
    affine to_object[way_transforms];
    ray r;
    bvh_box box;
    int step;
} instances_way;

static inline double instances_way_run(void *context)
{
    const instances_way *w = context;
    double sum = 0;
    for (size_t i = 0; i < way_transforms; i++) {
        ray in = w->r;
        in.o.x += (real)sum * real_smallest;  /* one after the other, as a search has to */
        if (w->step > 0) in = affine_ray(w->to_object[i], in);
        if (w->step > 1) in = ray_unit(in);
        sum += (double)in.d.x;
        sum += (double)shear_of(in).sx + (double)box_ray_of(in, &w->box, NULL).o_near[0];
    }
    return sum;
}

static inline void table_of_way(const options *o)
{
    static const char *const name[3] = {"tree made ready for the ray, as without instances",
                                        "and the ray transformed, (16.1)",
                                        "and normalised, which is wrong"};
    instances_way *w = allocate(3, sizeof *w);
    bench_candidate v[3];
    table out = table_new("The way into an instance", "step|a ray and instance [ns]");
    for (int k = 0; k < 3; k++) {
        for (uint64_t i = 0; i < way_transforms; i++) {
            random_stream g = random_start(o->seed, i, 13);
            affine a = forest_stand(&g, plant_direction(&g), 1, 2);
            affine_inverse(a, &w[k].to_object[i]);
        }
        w[k].r = ray_from((vec3){1, 2, 3}, (vec3){3, 2, 1}), w[k].step = k;
        w[k].box = (bvh_box){{-1, -1, -1, 1, 1, 1}};
        v[k] = (bench_candidate){name[k], instances_way_run, &w[k], 0, 0};
    }
    bench_time(v, 3, o->quick ? 9 : 99);
    for (int k = 0; k < 3; k++)
        table_text(&out, "%s", name[k]), table_number(&out, v[k].seconds * 1e9 / way_transforms);
    output_extra_table(o, &out);
    free(w);
}

static inline void table_of_normals(const options *o)
{
    static const double ratio[] = {1, 1.01, 1.1, 1.5, 2, 4, 10, 100};
    enum { n = 8 };
    size_t count = o->quick ? 500 : 20000;
    table out = table_new("Normals of a ball scaled by 1, 1, s: off the gradient of the ellipsoid",
                          "s|M n, mean [deg]|M n, most [deg]|most, (16.5) [deg]|A^T n, most [eps]");
    for (int i = 0; i < n; i++) {
        vec3 s = {1, 1, (real)ratio[i]};
        affine t = affine_scaling(s), a;
        double sum = 0, most = 0, right = 0, degrees = 180 / (double)pi;
        if (!instance_inverse(t, &a)) continue;
        for (size_t k = 0; k < count; k++) {
            random_stream g = random_start(o->seed, k, 11);
            vec3 p = plant_direction(&g);
            vec3 due = vunit((vec3){p.x, p.y, p.z / s.z}), naive = normal_naive(&t, p);
            double angle = (double)mesh_angle(naive, due) * degrees;
            double off = (double)(vlength(vsub(normal_to_world(&a, p), due)) / real_epsilon);
            sum += angle, most = angle > most ? angle : most, right = off > right ? off : right;
        }
        table_number(&out, ratio[i]), table_number(&out, sum / (double)count);
        table_number(&out, most);
        table_number(&out, (double)normal_worst_angle(s.z) * degrees), table_number(&out, right);
    }
    output_extra_table(o, &out);
}

#endif
