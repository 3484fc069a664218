/* growth.h: memory and time against the number of instances, from 1 to 1e5: one table, two plots.
 *
 *   table_of_growth(&o)
 */
#ifndef INSTANCES_GROWTH_H
#define INSTANCES_GROWTH_H

#include "measure.h"

static inline void table_of_growth(const options *o);

/* ---------------------------------------------------------------------------------------------- */

/* Where it is not built, flattened memory is computed from the bytes a triangle of what was. */
static inline void table_of_growth(const options *o)
{
    static const size_t number[] = {1, 10, 100, 300, 1000, 10000, 100000};
    int n = o->quick ? 3 : 7, built = o->quick ? 2 : 4;
    double bytes_a_triangle = 0;
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
        survey s;
        survey_make(&s, number[i], o->quick ? 40 : 120, o->quick ? 25 : 75, o->seed);
        method m[2] = {{.name = "two", .x = s.x, .s = &s}, {.name = "flat", .flat = true, .s = &s}};
        int with = i < built ? 2 : 1;
        double flat_build = with == 2 ? method_build(&m[1], &s.c) : 0, eye[2] = {0, 0};
        time_methods(m, with, run_method_eye, o->quick ? 1 : 3, eye);
        instances_work w = {{0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}};
        instance_hit h;
        for (size_t k = 0; k < s.eyes; k++) instances_hit_counted(&s.x, s.eye[k], &h, &w);
        instance_stats st = instances_stats(&s.x);
        double mb = (double)(s.x.bytes + st.mesh_bytes) * 0x1p-20;
        if (with == 2)
            bytes_a_triangle = (double)(mesh_bytes(&m[1].m) + m[1].b.tree.bytes) / st.triangles;
        double flat_mb = bytes_a_triangle * st.triangles * 0x1p-20;
        table_count(&out, number[i]), table_number(&out, st.triangles);
        table_number(&out, mb), table_number(&out, flat_mb);
        table_number(&out, s.build * 1e3);
        if (with == 2) table_number(&out, flat_build * 1e3);
        else table_text(&out, "-");
        table_number(&out, per((double)w.upper.tests, s.eyes));
        table_number(&out, per(eye[0] * 1e9, s.eyes));
        if (with == 2) table_number(&out, per(eye[1] * 1e9, s.eyes));
        if (with == 2) table_number(&out, eye[0] / eye[1]);
        else table_text(&out, "-"), table_text(&out, "-");
        plot_add(&p, two, (double)number[i], mb);
        plot_add(&p, with == 2 ? flat : guess, (double)number[i], flat_mb);
        plot_add(&q, two_time, (double)number[i], per(eye[0] * 1e9, s.eyes));
        if (with == 2) plot_add(&q, flat_time, (double)number[i], per(eye[1] * 1e9, s.eyes));
        bvh_free(&m[1].b), mesh_free(&m[1].m);
        survey_free(&s);
    }
    output_extra_table(o, &out);
    output_plot(o, &p, "16_instances_memory.svg");
    output_plot(o, &q, "16_instances_time.svg");
}

#endif
