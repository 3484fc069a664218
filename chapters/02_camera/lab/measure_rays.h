/* measure_rays.h: error and time of rays, frames and tangents, the naive and the robust ones.
 *
 *   question                  naive            robust                 error against
 *   ray far from the origin   s - e            -d w + u u + v v       wide arithmetic (oracle.h)
 *   frame, up near the view   up x (unit w)    products kept whole    wide arithmetic
 *   tan(phi / 2) near 90      tan              1 / tan(rest)          wide arithmetic
 *
 *   measure_rays(&t, &p, rounds);    measure_frames(&t, rounds);    measure_tangents(&t, rounds);
 *   add rows to the table, and points to the plot. Errors are the largest of 256 to 2000 cases.
 */
#ifndef MEASURE_RAYS_H
#define MEASURE_RAYS_H

#include "../../../common/clock.h"
#include "../../../common/lab/plot.h"
#include "../../../common/random.h"
#include "../../../common/lab/table.h"
#include "oracle.h"

enum { measure_calls = 1 << 14 };
typedef struct { camera c; vec3 target[256], up[256]; real phi[256]; } measure_input;

/* ---------------------------------------------------------------------------------------------- */

static inline void measure_row(table *t, const char *question, const char *variant,
                               const char *setting, double value, double error, double ns)
{
    char text[32];
    snprintf(text, sizeof text, setting, value);
    table_text(t, "%s", question);
    table_text(t, "%s", variant);
    table_text(t, "%s", text);
    table_number(t, error);
    table_number(t, ns);
}

/* A function for clock_compare: sums what the body adds for i = 0 ... measure_calls - 1. */
#define measure_loop(name, body) \
    static inline double name(void *context) \
    { \
        const measure_input *m = context; \
        double sum = 0; \
        for (int i = 0; i < measure_calls; i++) { \
            body; \
        } \
        return sum; \
    }
#define measure_at ((real)(i % 512)), ((real)(i / 32)), 512, 512
measure_loop(run_ray, vec3 d = camera_ray(m->c, measure_at).d; sum += (double)(d.x + d.y + d.z))
measure_loop(run_ray_naive, vec3 d = camera_ray_naive(m->c, measure_at).d;
             sum += (double)(d.x + d.y + d.z))
measure_loop(run_frame, camera_frame f; int k = i % 256;
             if (frame_look_at(m->c.e, m->target[k], m->up[k], &f, NULL)) sum += (double)f.v.x)
measure_loop(run_frame_first, int k = i % 256;
             sum += (double)frame_first(m->c.e, m->target[k], m->up[k]).v.x)
measure_loop(run_tangent, sum += (double)half_tangent(m->phi[i % 256]))
measure_loop(run_tangent_naive, sum += (double)half_tangent_naive(m->phi[i % 256]))

/* Times two variants in turn, and adds their rows. */
static inline void measure_pair(table *t, measure_input *m, int rounds, const char *question,
                                const char *setting, double value, clock_variant naive,
                                double naive_error, clock_variant robust, double robust_error)
{
    clock_variant v[2] = {naive, robust};
    v[0].context = v[1].context = m;
    clock_compare(v, 2, rounds);
    measure_row(t, question, naive.name, setting, value, naive_error,
                1e9 * v[0].seconds / measure_calls);
    measure_row(t, question, robust.name, setting, value, robust_error,
                1e9 * v[1].seconds / measure_calls);
}

static inline double measure_worst(double a, double b) { return isnan(a) || b <= a ? a : b; }

static inline vec3 measure_direction(random_stream *s)
{
    vec3 d = {random_next(s) - (real)0.5, random_next(s) - (real)0.5, random_next(s) - (real)0.5};
    return vdot(d, d) > (real)0.01 && vdot(d, d) < (real)0.25 ? vunit(d) : measure_direction(s);
}

static inline vec3 measure_float(vec3 a)
{
    return (vec3){(real)(float)a.x, (real)(float)a.y, (real)(float)a.z};
}

/* The camera of the Cornell box (d = 0.035, window 0.025 wide, in metres) far from the origin. */
static inline void measure_rays(table *t, plot *p, int rounds)
{
    random_stream s = random_start(1, 0, 0);
    real h = 0.0125;
    const char *precision = real_is_float ? "float" : "double";
    int series[4];
    for (int i = 0; i < (real_is_float ? 2 : 4); i++) {
        char name[64];
        snprintf(name, sizeof name, "%s, %s", i % 2 ? "-d w + u u + v v" : "s - e",
                 i < 2 ? precision : "float");
        series[i] = plot_series(p, name);
    }
    for (int k = 0; k <= 8; k++) {
        double error[4] = {0, 0, 0, 0}, far = pow(10.0, k);
        measure_input m;
        for (int i = 0; i < 2000; i++) {
            camera_frame f;
            camera c;
            vec3 e = vscale(measure_direction(&s), (real)far);
            vec3 target = vadd(e, vscale(measure_direction(&s), real_max(1, (real)far)));
            if (!frame_look_at(e, target, measure_direction(&s), &f, NULL)) continue;
            if (!camera_off_axis(f, (camera_window){-h, h, -h, h}, 0.035, &c, NULL)) continue;
            real x = 512 * random_next(&s), y = 512 * random_next(&s);
            vec3 d = camera_ray(c, x, y, 512, 512).d;
            vec3 way[] = {camera_ray_naive(c, x, y, 512, 512).d, d,
                          camera_direction_naive_f32(e, d), measure_float(d)};
            for (int j = 0; j < 4; j++)
                error[j] = measure_worst(error[j], ray_error(c, way[j], x, y, 512, 512));
            m.c = c;
        }
        for (int j = 0; j < (real_is_float ? 2 : 4); j++) plot_add(p, series[j], far, error[j]);
        if (k % 4 == 0)
            measure_pair(t, &m, rounds, "ray [pixel]", "e at %g m", far,
                         (clock_variant){"s - e", run_ray_naive, NULL, 0}, error[0],
                         (clock_variant){"-d w + u u + v v", run_ray, NULL, 0}, error[1]);
    }
}

/* 256 views with up turned away from the view by a small angle. */
static inline void measure_frames(table *t, int rounds)
{
    random_stream s = random_start(2, 0, 0);
    for (int k = 1; k <= 5; k += 2) {
        double first = 0, robust = 0, small = pow(10.0, -k);
        measure_input m;
        m.c.e = (vec3){0, 0, 0};
        for (int i = 0; i < 256; i++) {
            vec3 n = measure_direction(&s), a, b;
            camera_frame f;
            vbasis(n, &a, &b);
            m.target[i] = vscale(n, 1 + random_next(&s));
            m.up[i] = vmadd(n, a, (real)small);
            f = frame_first(m.c.e, m.target[i], m.up[i]);
            first = measure_worst(first, frame_error(f, m.target[i], m.up[i]));
            if (frame_look_at(m.c.e, m.target[i], m.up[i], &f, NULL))
                robust = measure_worst(robust, frame_error(f, m.target[i], m.up[i]));
        }
        measure_pair(t, &m, rounds, "frame's u [rad]", "angle %g", small,
                     (clock_variant){"first: up x unit w", run_frame_first, NULL, 0}, first,
                     (clock_variant){"products kept whole", run_frame, NULL, 0}, robust);
    }
}

static inline void measure_tangents(table *t, int rounds)
{
    for (int k = 0; k <= 4; k += 2) {
        double naive = 0, robust = 0, missing = pow(10.0, -k);
        measure_input m;
        for (int i = 0; i < 256; i++) {
            m.phi[i] = (real)(180 - missing * (1 + i / 256.0));
            double exact = half_tangent_exact(m.phi[i]);
            naive = measure_worst(naive, fabs((double)half_tangent_naive(m.phi[i]) / exact - 1));
            robust = measure_worst(robust, fabs((double)half_tangent(m.phi[i]) / exact - 1));
        }
        measure_pair(t, &m, rounds, "tan(phi/2) [relative]", "180 - phi = %g", missing,
                     (clock_variant){"tan", run_tangent_naive, NULL, 0}, naive,
                     (clock_variant){"1 / tan(rest)", run_tangent, NULL, 0}, robust);
    }
}

#endif
