/* 01_ray: a point on a ray, in two forms and two precisions: what each costs and how far it is off.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 01_ray chapters/01_ray/main.c -lm -lpthread
 * The oracle is wide.h. The picture shows one ray in float, ever farther from the origin. */
#include "../../common/lab/report.h"
#include "../../common/parallel.h"
#include "../../common/random.h"
#include "hit.h"
#include "ray_f32.h"
#include "../../common/numbers/wide.h"

enum { forms = 5, lines = 256, repeats = 800 };  /* few lines: the fastest cache holds them */
static const char *const form_name[forms] = {"float O + tD", "float (1-t)A + tB", "first O + tD",
                                             "O + tD fused", "first (1-t)A + tB"};
enum { plain_f32, between_form_f32, plain, fused, between_form };

/* The same line for both forms, O + t D and through A = O and B = O + D, and all of it in float. */
typedef struct { vec3 o, d, b; vec3_f32 o_f32, d_f32, b_f32; } line;
typedef struct { const line *l; vec3 *out; vec3_f32 *out_f32; bool normalise; } task;

static vec3_f32 narrow(vec3 a) { return (vec3_f32){(float)a.x, (float)a.y, (float)a.z}; }
static vec3 widened(vec3_f32 a) { return (vec3){(real)a.x, (real)a.y, (real)a.z}; }

/* O at about the distance `far` from the origin, |D| about 1. */
static line line_at(uint64_t seed, uint64_t i, real far)
{
    random_stream s = random_start(seed, i, 0);
    real v[6];
    for (int k = 0; k < 6; k++) v[k] = 2 * random_next(&s) - 1;
    vec3 o = vscale((vec3){v[0], v[1], v[2]}, far), d = {v[3], v[4], v[5]}, b = vadd(o, d);
    return (line){o, d, b, narrow(o), narrow(d), narrow(b)};
}

static inline vec3 point_at(int form, const line *l, real t)
{
    switch (form) {
    case plain_f32: return widened(ray_at_f32(l->o_f32, l->d_f32, (float)t));
    case between_form_f32: return widened(ray_at_between_f32(l->o_f32, l->b_f32, (float)t));
    case plain: return ray_at(ray_from(l->o, l->d), t);
    case fused: return ray_at_fused(ray_from(l->o, l->d), t);
    default: return ray_at_between(l->o, l->b, t);
    }
}

/* |P(t) - exact|; exact is the point of the very numbers that the form was given. */
static double error_of(int form, const line *l, real t)
{
    bool narrowed = form == plain_f32 || form == between_form_f32;
    wide3 o = wide3_of(narrowed ? widened(l->o_f32) : l->o);
    wide3 d = wide3_of(narrowed ? widened(l->d_f32) : l->d);
    if (form == between_form_f32) d = wide3_sub(wide3_of(widened(l->b_f32)), o);
    if (form == between_form) d = wide3_sub(wide3_of(l->b), o);
    wide3 exact = wide3_madd(o, d, wide_of((double)t));
    return wide_value(wide3_length(wide3_sub(wide3_of(point_at(form, l, t)), exact)));
}

/* Root mean square of the error over the lines; t differs from line to line by up to a factor 2. */
static double error_rms(const line *l, uint64_t seed, int form, real t)
{
    double sum = 0;
    for (uint64_t i = 0; i < lines; i++) {
        real ti = t == 1 ? 1 : (real)(float)(t * (1 + random_real(seed, i, 1, 0)) / 2);
        double e = error_of(form, &l[i], ti);
        sum += e * e / lines;
    }
    return sqrt(sum);
}

/* Each form in a loop of its own, points into an array: nothing but the form differs, and no sum
 * makes one point wait for the one before. */
#define TIMED(name, array, point)                                                              \
    static double name(void *context)                                                          \
    {                                                                                          \
        const task *k = context;                                                               \
        const line *l = k->l;                                                                  \
        for (int repeat = 0; repeat < repeats; repeat++) {                                     \
            real t = (real)(repeat + 1);                                                       \
            for (int i = 0; i < lines; i++) array[i] = point;                                  \
        }                                                                                      \
        return (double)array[lines - 1].x;                                                     \
    }
TIMED(run_plain_f32, k->out_f32, ray_at_f32(l[i].o_f32, l[i].d_f32, (float)t))
TIMED(run_between_f32, k->out_f32, ray_at_between_f32(l[i].o_f32, l[i].b_f32, (float)t))
TIMED(run_plain, k->out, ray_at(ray_from(l[i].o, l[i].d), t))
TIMED(run_fused, k->out, ray_at_fused(ray_from(l[i].o, l[i].d), t))
TIMED(run_between, k->out, ray_at_between(l[i].o, l[i].b, t))
static double (*const run_form[forms])(void *) = {
    run_plain_f32, run_between_f32, run_plain, run_fused, run_between};

static double run_direction(void *context)
{
    const task *k = context;
    for (int repeat = 0; repeat < repeats; repeat++)
        for (int i = 0; i < lines; i++) {
            ray r = ray_between(k->l[(i + repeat) % lines].o, k->l[i].b);
            k->out[i] = k->normalise ? ray_unit(r).d : r.d;
        }
    return (double)k->out[lines - 1].x;
}

/* ---- the picture: P(t) for t in [0, 64], every 1/64, in float, seen from close by ---- */

enum { panels = 4, gap = 6, points = 64 * 64 };
typedef struct { image *im; int panel; vec3_f32 o[panels]; vec3_f32 (*p)[points]; } staircase;

static void staircase_pixel(int x, int y, void *context)
{
    staircase *s = context;
    int k = x / (s->panel + gap);
    real scale = (real)s->panel / 64, half = 0.5;  /* pixels a unit */
    real u = ((real)(x - k * (s->panel + gap)) + half) / scale;
    real v = ((real)(s->im->height - y) - half) / scale;
    if (u > 64 || k >= panels) { image_set(s->im, x, y, (vec3){1, 1, 1}); return; }
    real nearest = real_infinity;
    /* Floats here are 8 apart at most: a dot less than 1 away from u has a t within 5 of u. */
    int first = (int)real_max(64 * (u - 5), 0), end = (int)real_min(64 * (u + 5), points);
    for (int i = first; i < end; i++) {
        real dx = (real)(s->p[k][i].x - s->o[k].x) - u, dy = (real)(s->p[k][i].y - s->o[k].y) - v;
        nearest = real_min(nearest, dx * dx + dy * dy);
    }
    real off = fabs(v - u * (real)0.625) * scale / (real)1.18;  /* from the true line, pixels */
    real dot = real_clamp(3 - sqrt(nearest) * scale, 0, 1);
    real thin = real_clamp((real)1.2 - off, 0, 1);
    vec3 c = vscale((vec3){1, 1, 1}, (real)0.93 - (real)0.75 * thin);
    c = vadd(vscale(c, 1 - dot), vscale(vec(0.67, 0.11, 0), dot));
    image_set(s->im, x, y, c);
}

static void draw(const options *o)
{
    image im = image_new(o->width, o->height);
    int panel = (o->width - (panels - 1) * gap) / panels;
    staircase s = {&im, panel > 0 ? panel : 1, .p = allocate(panels, sizeof *s.p)};
    for (int k = 0; k < panels; k++) {
        float far = ldexp(1.0f, 20 + 2 * k);  /* floats are 1/8, 1/2, 2 and 8 apart from here on */
        s.o[k] = (vec3_f32){far, far, 0};
        for (int i = 0; i < points; i++)
            s.p[k][i] = ray_at_f32(s.o[k], (vec3_f32){1, 0.625f, 0}, (float)i / 64);
    }
    bool whole = parallel_pixels(im.width, im.height, o->threads, "staircase", staircase_pixel, &s);
    output_picture(o, &im, "01_ray.png", true, whole);
    image_free(&im);
    free(s.p);
}

int main(int argc, char **argv)
{
    options defaults = {.width = 1218, .height = 300, .seed = 1};
    options o = options_read(argc, argv, "01_ray", "A point on a ray: error and time.",
                             defaults, NULL);
    draw(&o);
    const real distance[3] = {1, 10000, 100000000}, at[3] = {1, 10000, 100000000};
    table t = table_new("P(t): error (root mean square over 256 rays, |D| about 1) and time",
                        "form|distance of O|error t=1|error t=1e4|error t=1e8|time [ns]");
    plot p = plot_new("Error of P(t), O at 1e4", "t", "error", PLOT_LOG_X | PLOT_LOG_Y);
    plot q = plot_new("O at 1e4, t about 1e4", "time [ns]", "error", PLOT_LOG_Y);
    line *l = allocate(lines, sizeof *l);
    task job = {l, allocate(lines, sizeof(vec3)), allocate(lines, sizeof(vec3_f32)), false};
    clock_variant v[forms];
    for (int d = 0; d < 3; d++) {
        for (uint64_t i = 0; i < lines; i++) l[i] = line_at(o.seed, i, distance[d]);
        for (int f = 0; f < forms; f++) v[f] = (clock_variant){form_name[f], run_form[f], &job, 0};
        clock_compare(v, forms, o.quick ? 3 : 15);
        for (int f = 0; f < forms; f++) {
            double time = v[f].seconds / ((double)repeats * lines) * 1e9;
            table_text(&t, "%s", form_name[f]), table_text(&t, "%.0e", (double)distance[d]);
            for (int k = 0; k < 3; k++) table_number(&t, error_rms(l, o.seed, f, at[k]));
            table_number(&t, time);
            if (d != 1) continue;
            int series = plot_series(&p, form_name[f]);
            for (real x = 1; x < 200000000; x *= 10)
                plot_add(&p, series, (double)x, error_rms(l, o.seed, f, x));
            plot_add(&q, plot_series(&q, form_name[f]), time, error_rms(l, o.seed, f, at[1]));
        }
    }
    output_table(&o, &t);
    plot_slope(&p, 1, "slope 1");
    output_plot(&o, &p, "01_ray_error.svg");
    output_plot(&o, &q, "01_ray_time.svg");

    task unit = job;
    unit.normalise = true;
    clock_variant w[2] = {{"D = B - A", run_direction, &job, 0},
                          {"D normalised", run_direction, &unit, 0}};
    clock_compare(w, 2, o.quick ? 3 : 15);
    table u = table_new("Making a ray from A to B", "direction|time [ns]|relative");
    for (int k = 0; k < 2; k++) {
        table_text(&u, "%s", w[k].name);
        table_number(&u, w[k].seconds / ((double)repeats * lines) * 1e9);
        table_number(&u, w[k].seconds / w[0].seconds);
    }
    output_extra_table(&o, &u);
    free(l), free(job.out), free(job.out_f32);
    return output_done(&o);
}
