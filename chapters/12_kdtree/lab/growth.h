/* growth.h: time and work against the number of triangles, against the cost of a test, against the
 * bonus for empty space; and what a step and a test really cost, by least squares. */
#ifndef KDTREE_GROWTH_H
#define KDTREE_GROWTH_H

#include "measure.h"

static inline void plots_of_cost(const options *o, const subject *s);
static inline void plot_of_bonus(const options *o, const subject *s);
static inline void growth(const options *o);

/* ---------------------------------------------------------------------------------------------- */

/* b and c of ns = b nodes + c tests, by least squares: two normal equations. */
static inline void fit_costs(const double (*row)[3], int n, double *b, double *c)
{
    double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
    for (int i = 0; i < n; i++) {
        double x = row[i][0], y = row[i][1], z = row[i][2];
        xx += x * x, xy += x * y, yy += y * y, xz += x * z, yz += y * z;
    }
    *b = (xz * yy - yz * xy) / (xx * yy - xy * xy);
    *c = (yz * xx - xz * xy) / (xx * yy - xy * xy);
}

/* c_i from 1/16 to 2: the trees go from coarse to fine; c_t is 1 throughout. */
static inline void plots_of_cost(const options *o, const subject *s)
{
    enum { most = 6 };
    plot p = plot_new("Cost of a test: work", "c_i / c_t", "a diffuse ray", PLOT_LOG_X);
    plot q = plot_new("Cost of a test: time", "c_i / c_t", "[ns], [B/tri]", PLOT_LOG_X);
    int nodes = plot_series(&p, "nodes"), tests = plot_series(&p, "tests");
    int leaves = plot_series(&p, "leaves"), primary = plot_series(&q, "primary ray [ns]");
    int diffuse = plot_series(&q, "diffuse ray [ns]"), bytes = plot_series(&q, "memory [B/tri]");
    double row[most][3], seconds[2][most], node, test;
    candidate c[most];
    trial t[2][most];
    for (int i = 0; i < most; i++) {
        c[i] = candidate_list[4];
        c[i].options.item_cost = ldexp(1.0, i - 4);
        t[0][i] = t[1][i] = (trial){s, &c[i], &s->primary, {0}};
        run_build(&t[0][i]);
        t[1][i].t = t[0][i].t, t[1][i].rays = &s->diffuse;
    }
    for (int k = 0; k < 2; k++) time_trials(t[k], most, run_search, 5, seconds[k]);
    for (int i = 0; i < most; i++) {
        double at = c[i].options.item_cost, rays = (double)s->diffuse.n;
        search_work w = rays_count(&t[1][i].t, &s->diffuse);
        row[i][0] = (double)w.nodes / rays, row[i][1] = (double)w.tests / rays;
        row[i][2] = seconds[1][i] * 1e9 / rays;
        plot_add(&p, nodes, at, row[i][0]), plot_add(&p, tests, at, row[i][1]);
        plot_add(&p, leaves, at, (double)w.leaves / rays);
        plot_add(&q, primary, at, per(seconds[0][i] * 1e9, s->primary.n));
        plot_add(&q, diffuse, at, row[i][2]);
        plot_add(&q, bytes, at, per((double)t[0][i].t.bytes, t[0][i].t.items));
        kdtree_free(&t[0][i].t);
    }
    fit_costs((const double (*)[3])row, most, &node, &test);
    printf("# fitted: a diffuse ray takes %.1f ns a node and %.1f ns a test\n", node, test);
    output_plot(o, &p, "12_kdtree_cost.svg");
    output_plot(o, &q, "12_kdtree_cost_time.svg");
}

static inline void plot_of_bonus(const options *o, const subject *s)
{
    plot p = plot_new("Bonus for cutting off empty space", "bonus", "a diffuse ray", 0);
    int nodes = plot_series(&p, "nodes"), leaves = plot_series(&p, "leaves");
    int tests = plot_series(&p, "tests");
    static const double bonus[6] = {0, 0.1, 0.2, 0.3, 0.5, 0.8};
    for (int i = 0; i < 6; i++) {
        kdtree t;
        kdtree_options how = kdtree_defaults;
        how.empty_bonus = bonus[i];
        build_or_fail(&s->x, how, &t);
        search_work w = rays_count(&t, &s->diffuse);
        plot_add(&p, nodes, how.empty_bonus, per((double)w.nodes, s->diffuse.n));
        plot_add(&p, leaves, how.empty_bonus, per((double)w.leaves, s->diffuse.n));
        plot_add(&p, tests, how.empty_bonus, per((double)w.tests, s->diffuse.n));
        kdtree_free(&t);
    }
    output_plot(o, &p, "12_kdtree_bonus.svg");
}

/* Time against n: teapots of 64 n^2 - 8 n triangles, ever finer. */
static inline void growth(const options *o)
{
    static const int fine[] = {1, 2, 4, 8, 16, 32, 50};
    int n = o->quick ? 4 : 7;
    double x[7], build[7], search[7], nodes[7], least = HUGE_VAL, greatest = 0;
    table out = table_new("Growth with n, SAH, one thread",
                          "triangles|build [ms]|build / (n log2 n) [ns]|references/tri|nodes/ray|"
                          "leaves/ray|tests/ray|ray [ns]|brute force [ns]|peak [B/tri]");
    plot p = plot_new("Time against n", "triangles", "time [ns]", PLOT_LOG_X | PLOT_LOG_Y);
    plot q = plot_new("Diffuse rays: work against n", "triangles", "a ray", PLOT_LOG_X);
    int by_build = plot_series(&p, "build, a triangle");
    int by_ray = plot_series(&p, "k-d tree, a ray");
    int by_brute = plot_series(&p, "brute force, a ray"), by_nodes = plot_series(&q, "nodes");
    int by_leaves = plot_series(&q, "leaves"), by_tests = plot_series(&q, "tests");
    for (int i = 0; i < n; i++) {
        subject s;
        mesh m = teapot_mesh(fine[i]);
        subject_init(&s, m, view_of_mesh(&m, 1.6), 160, fine[i] < 32 ? 40 : 10, o->seed);
        trial t = {&s, &candidate_list[4], &s.diffuse, {0}};
        double triangles = (double)s.m.triangles, seconds;
        if (fine[i] < 16) time_trials(&t, 1, run_build, 5, &build[i]);
        else build[i] = -clock_seconds(), run_build(&t), build[i] += clock_seconds();
        time_trials(&t, 1, run_search, 3, &seconds);
        search_work w = rays_count(&t.t, &s.diffuse);
        x[i] = log2(triangles), search[i] = log2(seconds / (double)s.diffuse.n);
        nodes[i] = per((double)w.nodes, s.diffuse.n);
        double unit = build[i] / (triangles * x[i]);
        if (triangles > 900 && unit < least) least = unit;
        if (triangles > 900 && unit > greatest) greatest = unit;
        table_count(&out, s.m.triangles), table_number(&out, build[i] * 1e3);
        table_number(&out, unit * 1e9);
        table_number(&out, per((double)t.t.references, t.t.items)), table_number(&out, nodes[i]);
        table_number(&out, per((double)w.leaves, s.diffuse.n));
        table_number(&out, per((double)w.tests, s.diffuse.n));
        table_number(&out, per(seconds * 1e9, s.diffuse.n));
        table_number(&out, s.brute_seconds * 1e9);
        table_number(&out, per((double)t.t.peak, s.m.triangles));
        plot_add(&p, by_build, triangles, build[i] * 1e9 / triangles);
        plot_add(&p, by_ray, triangles, per(seconds * 1e9, s.diffuse.n));
        plot_add(&p, by_brute, triangles, s.brute_seconds * 1e9);
        plot_add(&q, by_nodes, triangles, nodes[i]);
        plot_add(&q, by_leaves, triangles, per((double)w.leaves, s.diffuse.n));
        plot_add(&q, by_tests, triangles, per((double)w.tests, s.diffuse.n));
        build[i] = log2(build[i]);
        kdtree_free(&t.t);
        subject_free(&s);
    }
    output_extra_table(o, &out);
    printf("# fitted: build ~ n^%.2f; build / (n log2 n) within a factor %.2f from 1e3 on\n",
           slope_of(x, build, n), greatest / least);
    printf("# fitted: a diffuse ray passes %.2f more nodes for each doubling of n; time ~ n^%.2f\n",
           slope_of(x, nodes, n), slope_of(x, search, n));
    plot_slope(&p, 1, "slope 1");
    output_plot(o, &p, "12_kdtree_n_time.svg");
    output_plot(o, &q, "12_kdtree_n.svg");
}

#endif
