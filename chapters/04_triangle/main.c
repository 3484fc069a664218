/* 04_triangle: rays aimed exactly at edges of a mesh: who slips through, and what certainty costs.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 04_triangle chapters/04_triangle/main.c -lm -lpthread
 * The oracles: a closed mesh is hit by every ray from its inside; (4.8) in double-double. */
#include "../../common/lab/report.h"
#include "../../common/parallel.h"
#include "lab/dome.h"
#include "lab/needles.h"
#include "lab/soup.h"
#include "lab/triangle_naive.h"

static void draw(const options *o)
{
    image im = image_new(o->width, o->height);
    dome s = dome_new(&im, first_triangle_hit, triangle_hit_tolerant, triangle_hit);
    bool whole = parallel_pixels(im.width, im.height, o->threads, "dome", dome_pixel, &s);
    output_picture(o, &im, "04_triangle.png", true, whole);
    image_free(&im);
    dome_free(&s);
}

/* ---- the methods ---- */

SOUP_TIMED(run_plane_f32, (void)0, triangle_hit_plane_f32(*k, r, &h))
SOUP_TIMED(run_mt_f32, (void)0, triangle_hit_moller_trumbore_f32(*k, r, &h))
SOUP_TIMED(run_plane, (void)0, triangle_hit_plane(*k, r, &h))
SOUP_TIMED(run_first, (void)0, first_triangle_hit(*k, r, &h))
SOUP_TIMED(run_one_branch, (void)0, triangle_hit_one_branch(*k, r, &h))
SOUP_TIMED(run_tolerant, (void)0, triangle_hit_tolerant(*k, r, &h))
SOUP_TIMED(run_watertight, (void)0, triangle_hit(*k, r, &h))
SOUP_TIMED(run_sheared, ray_shear z = shear_of(r),
           triangle_hit_corners(&k->a, &k->b, &k->c, &z, r, &h))

/* For the columns that do not measure time. */
static bool hit_sheared(triangle tri, ray r, hit *out)
{
    ray_shear s = shear_of(r);
    return triangle_hit_sheared(tri, &s, r, out);
}

enum { methods = 8, f32_methods = 2 };
static const struct {
    const char *name;
    triangle_method *hit;
    double (*run)(void *);
} method[methods] = {{"plane + inside, float", triangle_hit_plane_f32, run_plane_f32},
                     {"Möller-Trumbore, float", triangle_hit_moller_trumbore_f32, run_mt_f32},
                     {"plane + inside", triangle_hit_plane, run_plane},
                     {"first: Möller-Trumbore", first_triangle_hit, run_first},
                     {"Möller-Trumbore, one branch", triangle_hit_one_branch, run_one_branch},
                     {"Möller-Trumbore, edges +1e-5", triangle_hit_tolerant, run_tolerant},
                     {"watertight", triangle_hit, run_watertight},
                     {"watertight, shear kept", hit_sheared, run_sheared}};

static icosphere sphere_at(int k, real translation)
{
    icosphere m = icosphere_new(4, (vec3){translation, 0, 0}, 1);
    if (k < f32_methods) icosphere_f32(&m);
    return m;
}

static void plot_slips(const options *o)
{
    plot p = plot_new("Rays aimed at vertices of a closed mesh", "translation [R]", "slips [%]",
                      PLOT_LOG_X);
    for (int k = 0; k < methods - 1; k++) {
        if (method[k].hit == triangle_hit_one_branch) continue;  /* the same hits as first */
        int series = plot_series(&p, method[k].name);
        for (real far = 1; far < (real)2e6; far *= 10) {
            icosphere m = sphere_at(k, far);
            slip_count n = slips(&m, method[k].hit, true, o->quick ? 50 : 4000, o->seed);
            plot_add(&p, series, (double)far, 100 * (double)n.slips / (double)n.rays);
            icosphere_free(&m);
        }
    }
    output_plot(o, &p, "04_triangle_slips.svg");
}

static void measure(const options *o)
{
    soup *s = soup_new(o->quick ? 20 : 400, o->seed);
    clock_variant v[methods];
    for (int k = 0; k < methods; k++) v[k] = (clock_variant){method[k].name, method[k].run, s, 0};
    clock_compare(v, methods, o->quick ? 3 : 9);
    table t =
        table_new("Rays aimed from inside at a sphere of 5120 triangles, at 0 and moved by 1e5 R:"
                  " slips; needles 1e-6 wide; a test's time",
                  "method|error vertex 0 [%]|error edge 0 [%]|error vertex 1e5 [%]|"
                  "error edge 1e5 [%]|error hits at edge|error needles missed [%]|"
                  "error needles t|time [ns]");
    plot p = plot_new("Needles 1e-6 wide: error against time", "time [ns]",
                      "largest relative error of t", PLOT_LOG_Y);
    plot q = plot_new("Needles: error against width", "width", "largest relative error of t",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < methods; k++) {
        double time = 1e9 * v[k].seconds / (soup_triangles * s->rays);
        size_t rays = o->quick ? 500 : k < methods - 2 ? 10000 : 1000000;
        table_text(&t, "%s", method[k].name);
        for (int at = 0; at < 2; at++) {
            icosphere m = sphere_at(k, at ? (real)1e5 : 0);
            for (int at_vertex = 1; at_vertex >= 0; at_vertex--) {
                slip_count n = slips(&m, method[k].hit, at_vertex, rays, o->seed);
                table_number(&t, 100 * (double)n.slips / (double)n.rays);
            }
            icosphere_free(&m);
        }
        icosphere m = sphere_at(k, 0);
        table_number(&t, slip_hits(&m, method[k].hit, false, o->quick ? 500 : 10000, o->seed));
        icosphere_free(&m);
        needle_count n = needles(method[k].hit, 1e-6, o->quick ? 500 : 20000, o->seed);
        table_number(&t, 100 * (double)n.missed / (double)n.due);
        table_number(&t, n.error);
        table_number(&t, time);
        plot_add(&p, plot_series(&p, method[k].name), time, n.error);
        int on_q = plot_series(&q, method[k].name);
        for (double width = 1; width > 5e-8; width /= 10) {
            n = needles(method[k].hit, width, o->quick ? 50 : 2000, o->seed);
            if (n.missed < n.due) plot_add(&q, on_q, width, n.error);
        }
    }
    plot_slips(o);
    output_plot(o, &q, "04_triangle_needles.svg");
    output_plot(o, &p, "04_triangle_time.svg");
    output_table(o, &t);
    free(s);
}

/* ---- two wrong tests ---- */

static void measure_wrong_tests(const options *o)
{
    size_t n = o->quick ? 1000 : 100000;
    table t =
        table_new("Small triangles, rays aimed at their middle: lost if |det| < 1e-8 counts as 0",
                  "size|lost [%]|lost, compared with 0 [%]");
    for (real size = 1; size > (real)5e-6; size /= 10) {
        random_stream g = random_start(o->seed, 10, 0);
        size_t lost = 0, missed = 0;
        for (size_t i = 0; i < n; i++) {
            vec3 a = random_vec3(&g, size), b = random_vec3(&g, size), c = random_vec3(&g, size);
            triangle tri = {a, b, c};
            vec3 from = vscale(vunit(random_vec3(&g, 1)), size);
            ray r = ray_from(from, vunit(vsub(triangle_at(tri, 0.3, 0.3), from)));
            hit h;
            lost += !triangle_hit_absolute(tri, r, &h), missed += !triangle_hit(tri, r, &h);
        }
        table_number(&t, (double)size);
        table_number(&t, 100 * (double)lost / (double)n);
        table_number(&t, 100 * (double)missed / (double)n);
    }
    output_extra_table(o, &t);
    random_stream g = random_start(o->seed, 11, 0);
    size_t sum_is_one = 0, inside = 0;
    for (size_t i = 0; i < n; i++) {
        triangle tri = {{0, 0, 0}, {1, 0, 0.5}, {0, 1, -0.5}};
        real u = slip_between(&g, -2, 2), v = slip_between(&g, -2, 2);
        barycentrics k = barycentrics_of(tri, triangle_at(tri, u, v));
        sum_is_one += fabs(barycentrics_sum(k) - 1) < 64 * real_epsilon;
        inside += barycentrics_inside(k);
    }
    t = table_new("Points with u and v in [-2, 2]; 1 of 32 lies in the triangle",
                  "test|passed [%]");
    table_text(&t, "weights sum to one"), table_number(&t, 100 * (double)sum_is_one / (double)n);
    table_text(&t, "no weight is negative"), table_number(&t, 100 * (double)inside / (double)n);
    output_extra_table(o, &t);
}

int main(int argc, char **argv)
{
    options defaults = {.width = 960, .height = 320, .seed = 1};
    options o =
        options_read(argc, argv, "04_triangle",
                     "Rays against triangles: who slips between two of them.", defaults, NULL);
    draw(&o);
    measure(&o);
    measure_wrong_tests(&o);
    return output_done(&o);
}
