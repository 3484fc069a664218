/* 03_sphere: a ray meets a sphere, in eight ways: which rays each gets wrong, and what it costs.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 03_sphere chapters/03_sphere/main.c -lm -lpthread
 * The oracle is sphere_oracle.h. The picture shows a sphere from far away through a long lens. */
#include "../../common/lab/report.h"
#include "../../common/parallel.h"
#include "lab/sphere_draw.h"
#include "lab/sphere_survey.h"

enum { timed = 1024, repeats = 20 };

/* Each method in a loop of its own, so that it can be inlined. */
#define TIMED(name, X_hit)                                                                         \
    static double name(void *context)                                                              \
    {                                                                                              \
        const shot *s = context;                                                                   \
        size_t hits = 0;                                                                           \
        hit h;                                                                                     \
        for (int k = 0; k < repeats * timed; k++)                                                  \
            hits += X_hit(s[k % timed].ball, s[k % timed].r, &h);                                  \
        return (double)hits;                                                                       \
    }
TIMED(run_first_f32, sphere_hit_first_f32)
TIMED(run_first, first_sphere_hit)
TIMED(run_in_double, sphere_hit_in_double)
TIMED(run_stable_root, sphere_hit_stable_root)
TIMED(run_haines, sphere_hit_haines)
TIMED(run_lagrange, sphere_hit_lagrange)
TIMED(run_kahan, sphere_hit_kahan)
TIMED(run_hit, sphere_hit)
static double (*const run_method[methods])(void *) = {
    run_first_f32, run_first, run_in_double, run_stable_root,
    run_haines, run_lagrange, run_kahan, run_hit};

static void time_methods(const options *o, aim how, real far, double ns[methods])
{
    static shot s[timed];
    clock_variant v[methods];
    for (size_t i = 0; i < timed; i++) s[i] = shot_at(o->seed, how, far, i);
    for (int m = 0; m < methods; m++) v[m] = (clock_variant){method_name[m], run_method[m], s, 0};
    clock_compare(v, methods, o->quick ? 3 : 25);
    for (int m = 0; m < methods; m++) ns[m] = v[m].seconds / (repeats * timed) * 1e9;
}

int main(int argc, char **argv)
{
    options defaults = {.width = 960, .height = 480, .seed = 1};
    const char *about = "A ray meets a sphere: error and time.";
    options o = options_read(argc, argv, "03_sphere", about, defaults, NULL);
    sphere_draw(&o);
    sphere_draw_map(&o);

    surveys *all = allocate(1, sizeof *all);
    all->n = o.quick ? 2000 : 100000, all->seed = o.seed;
    for (int k = 0; k < distances; k++) all->at[k].far = pow((real)10, (real)k / 2);
    if (!parallel_for(distances, o.threads, "rays", survey_at, all)) exit(130);

    table t = table_new("Ray and sphere, from 1e2 to 1e6 radii: wrong answers, worst errors, time",
        "method|distance [R]|error missed [%]|error grazing missed [%]|error grazing false [%]"
        "|error edge [R]|error residual [R]|time [ns]|time grazing [ns]");
    const int logs = PLOT_LOG_X | PLOT_LOG_Y;
    plot p = plot_new("How near the limb a ray is told wrong", "distance [R]", "edge [R]", logs);
    plot q = plot_new("How far a hit is off the surface", "distance [R]", "residual [R]", logs);
    plot w = plot_new("Error against time, from 1e4 R", "time [ns]", "edge [R]", PLOT_LOG_Y);
    for (int m = 0; m < methods; m++) {
        int series = plot_series(&p, method_name[m]), same = plot_series(&q, method_name[m]);
        for (int k = 0; k < distances; k++) {
            plot_add(&p, series, (double)all->at[k].far, all->at[k].of[m].edge);
            if (k == 0) continue;  /* o is on the surface: the residual is that of o */
            plot_add(&q, same, (double)all->at[k].far, all->at[k].of[m].residual);
        }
    }
    for (int k = 4; k < distances; k += k == 8 ? 4 : 2) {
        double ns[methods], grazing_ns[methods];
        time_methods(&o, anywhere, all->at[k].far, ns);
        time_methods(&o, grazing, all->at[k].far, grazing_ns);
        for (int m = 0; m < methods; m++) {
            const errors *e = &all->at[k].of[m];
            const double x[] = {e->missed, e->grazing_missed, e->grazing_untrue, e->edge,
                                e->residual, ns[m], grazing_ns[m]};
            table_text(&t, "%s", method_name[m]), table_text(&t, "%.0e", (double)all->at[k].far);
            for (size_t i = 0; i < sizeof x / sizeof *x; i++) table_number(&t, x[i]);
            if (k == 8) plot_add(&w, plot_series(&w, method_name[m]), ns[m], e->edge);
        }
    }
    output_table(&o, &t);
    plot_slope(&p, 2, "slope 2"), plot_slope(&q, 2, "slope 2");
    output_plot(&o, &p, "03_sphere_edge.svg");
    output_plot(&o, &q, "03_sphere_residual.svg");
    output_plot(&o, &w, "03_sphere_time.svg");
    free(all);

    const struct { const char *name; aim how; real far; } kind[] = {
        {"anywhere, from 1e2 R", anywhere, 100}, {"from the surface", surface, 2},
        {"at the last bit of the limb", limb, 100}};
    table u = table_new("Rays that sphere_hit looks at twice",
                        "rays|Haines et al. [ns]|sphere_hit [ns]");
    for (int k = 0; k < 3; k++) {
        double ns[methods];
        time_methods(&o, kind[k].how, kind[k].far, ns);
        table_text(&u, "%s", kind[k].name), table_number(&u, ns[4]), table_number(&u, ns[7]);
    }
    output_extra_table(&o, &u);
    return output_done(&o);
}
