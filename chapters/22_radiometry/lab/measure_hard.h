/* measure_hard.h: tiny, far, grazing, touching: how far off each variant is, and how long it takes.
 *
 *   measure_hard(o)   a table: the largest relative error in 256 inputs, ns of one
 *
 * Solid angle and irradiance as they are published; what each loses:
 *
 *   triangle_solid_angle_girard(t, p)          sum of angles - pi: all digits of a small triangle
 *   sphere_irradiance_naive(s, p, n)           (22.13): those of a small sphere near the horizon
 *
 * hard_fill makes random inputs of a case of hard_list; hard_error is the largest error in them,
 * against 32 digits (oracle.h), of the naive form (first.h's of a sphere's solid angle, otherwise
 * the one that is called so) or of the default.
 *
 * Sources: A. Girard, "Invention nouvelle en l'algebre", 1629; Lagarde, de Rousiers 2014, as in
 * sphere_irradiance.h.
 */
#ifndef RADIOMETRY_MEASURE_HARD_H
#define RADIOMETRY_MEASURE_HARD_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "oracle.h"
#include "relations.h"
#include "sphere_irradiance.h"

enum { hard_inputs = 256 };
typedef enum { HARD_SPHERE_ANGLE, HARD_TRIANGLE_ANGLE, HARD_SPHERE_E } radiometry_hard;
typedef enum { SHAPE_ANY, SHAPE_GRAZING, SHAPE_TOUCHING } radiometry_shape;
typedef struct { radiometry_hard kind; const char *input; double size; radiometry_shape shape; }
    radiometry_hard_case;
typedef struct { radiometry_hard kind; sphere s; triangle t; } radiometry_hard_input;
typedef struct { radiometry_hard_input in[hard_inputs]; bool naive; } radiometry_hard_run;

/* ---------------------------------------------------------------------------------------------- */

/* The angle between the planes n, a and n, b, at the corner n of a spherical triangle. */
static inline real corner_angle_naive(vec3 n, vec3 a, vec3 b)
{
    return acos(real_clamp(vdot(vunit(vcross(n, a)), vunit(vcross(n, b))), -1, 1));
}

/* A triangle of 1e-8 r: each angle is known to some epsilon, their sum less pi to some epsilon, and
 * the answer is 1e-16. */
static inline real triangle_solid_angle_girard(triangle t, vec3 p)
{
    vec3 a = vsub(t.a, p), b = vsub(t.b, p), c = vsub(t.c, p);
    real sum = corner_angle_naive(a, b, c) + corner_angle_naive(b, c, a)
             + corner_angle_naive(c, a, b);
    return vdot(a, vcross(b, c)) < 0 ? pi - sum : sum - pi;
}

static inline real sphere_irradiance_naive(sphere s, vec3 p, vec3 n)
{
    vec3 f = vsub(s.c, p);
    real d2 = vdot(f, f), h2 = d2 / (s.r * s.r);
    if (h2 <= 1) return pi;
    real cosb = real_clamp(vdot(n, f) / sqrt(d2), -1, 1), h = sqrt(h2);
    if (h * cosb > 1) return pi * cosb / h2;
    if (h * cosb < -1) return 0;
    real sinb = sqrt(1 - cosb * cosb), x = sqrt(h2 - 1), y = -x * (cosb / sinb);
    real sy = sinb * sqrt(real_max(1 - y * y, 0));
    return (cosb * acos(real_clamp(y, -1, 1)) - x * sy) / h2 + atan(sy / x);
}

/* ---- inputs ---- */

static const char *const hard_name[] = {"solid angle, sphere", "solid angle, triangle",
                                        "irradiance, sphere"};
static const radiometry_hard_case hard_list[] = {
    {HARD_SPHERE_ANGLE, "R/d = 1e-2", 1e-2, SHAPE_ANY},
    {HARD_SPHERE_ANGLE, "R/d = 1e-6", 1e-6, SHAPE_ANY},
    {HARD_SPHERE_ANGLE, "gap 1e-6 R", 1e-6, SHAPE_TOUCHING},
    {HARD_TRIANGLE_ANGLE, "size 1", 1, SHAPE_ANY},
    {HARD_TRIANGLE_ANGLE, "size 1e-3", 1e-3, SHAPE_ANY},
    {HARD_TRIANGLE_ANGLE, "size 1e-7", 1e-7, SHAPE_ANY},
    {HARD_TRIANGLE_ANGLE, "1e-6 off its plane", 1e-6, SHAPE_GRAZING},
    {HARD_SPHERE_E, "half sunk, R/d = 0.1", 1e-1, SHAPE_ANY},
    {HARD_SPHERE_E, "half sunk, R/d = 1e-3", 1e-3, SHAPE_ANY},
    {HARD_SPHERE_E, "half sunk, R/d = 1e-6", 1e-6, SHAPE_ANY},
    {HARD_SPHERE_E, "1e-4 R above the horizon", 1e-4, SHAPE_GRAZING},
    {HARD_SPHERE_E, "gap 1e-6 R", 1e-6, SHAPE_TOUCHING},
};
enum { hard_cases = sizeof hard_list / sizeof *hard_list };

/* Seen from the origin, the surface being the plane z = 0. */
static inline radiometry_hard_input hard_make(const radiometry_hard_case *c, random_stream *s)
{
    radiometry_hard_input h = {.kind = c->kind, .s.r = 1};
    bool any = c->shape == SHAPE_ANY, grazing = c->shape == SHAPE_GRAZING;
    bool touching = c->shape == SHAPE_TOUCHING;
    real d = (real)(1 / c->size), gap = (real)c->size, size = any ? gap : 1;
    real turn = random_between(s, 0, 6), spread = random_between(s, 0.5, 1);
    if (!any) d = touching ? 1 + gap * spread : 10 * spread;
    if (c->kind == HARD_SPHERE_ANGLE)
        h.s.c = touching ? (vec3){0, d, 0} : vscale((vec3){cos(turn), sin(turn), 0}, d * spread);
    if (c->kind == HARD_SPHERE_E)
        h.s.c = (vec3){d, 0, grazing ? -1 + gap : random_between(s, -0.9, 0)};
    if (c->kind == HARD_TRIANGLE_ANGLE) {
        vec3 a = {random_between(s, 1, 2), random_between(s, -1, 1), random_between(s, -1, 1)};
        vec3 b = vadd(a, random_in_cube(s, size)), e = vadd(a, random_in_cube(s, size));
        if (grazing) a.z = b.z = e.z = gap;
        h.t = (triangle){a, b, e};
    }
    return h;
}

static inline double hard_exact(const radiometry_hard_input *h)
{
    sphere s = h->s;
    switch (h->kind) {
    case HARD_SPHERE_ANGLE: return sphere_solid_angle_exact(s, seen_from);
    case HARD_TRIANGLE_ANGLE: return triangle_solid_angle_exact(h->t, seen_from);
    case HARD_SPHERE_E:
        return sphere_irradiance_exact((double)s.r, (double)s.c.x, (double)s.c.z);
    }
    return 0;
}

static inline real hard_value(const radiometry_hard_input *h, bool naive)
{
    switch (h->kind) {
    case HARD_SPHERE_ANGLE:
        return (naive ? first_sphere_solid_angle : sphere_solid_angle)(h->s, seen_from);
    case HARD_TRIANGLE_ANGLE:
        return (naive ? triangle_solid_angle_girard : triangle_solid_angle)(h->t, seen_from);
    case HARD_SPHERE_E:
        return (naive ? sphere_irradiance_naive : sphere_irradiance)(h->s, seen_from, seen_up);
    }
    return 0;
}

static inline double run_hard(void *context)
{
    const radiometry_hard_run *r = context;
    real sum = 0;
    for (int i = 0; i < hard_inputs; i++) sum += hard_value(&r->in[i], r->naive);
    return (double)sum;
}

/* The largest relative error over the inputs; a NaN stays. */
static inline double hard_error(const radiometry_hard_run *r)
{
    double worst = 0;
    for (int i = 0; i < hard_inputs; i++) {
        double exact = hard_exact(&r->in[i]);
        double off = fabs(((double)hard_value(&r->in[i], r->naive) - exact) / exact);
        if (!(off <= worst)) worst = off;
    }
    return worst;
}

static inline void hard_fill(radiometry_hard_run *r, const radiometry_hard_case *c, uint64_t seed)
{
    for (int i = 0; i < hard_inputs; i++) {
        random_stream s = random_start(seed, (uint64_t)(c - hard_list), (uint64_t)i);
        r->in[i] = hard_make(c, &s);
    }
}

static inline void measure_hard(const options *o)
{
    table t = table_new("Hard cases: largest relative error in 256 inputs, and time of one",
                        "quantity|case|error naive|error default|time naive [ns]|"
                        "time default [ns]");
    radiometry_hard_run *r = allocate(2, sizeof *r);
    for (const radiometry_hard_case *c = hard_list; c < hard_list + hard_cases; c++) {
        double ns[2];
        for (int i = 0; i < 2; i++) hard_fill(&r[i], c, o->seed), r[i].naive = i == 0;
        bench_each(run_hard, r, sizeof *r, 2, 21, 1e9 / hard_inputs, ns);
        table_text(&t, "%s", hard_name[c->kind]), table_text(&t, "%s", c->input);
        for (int i = 0; i < 2; i++) table_number(&t, hard_error(&r[i]));
        for (int i = 0; i < 2; i++) table_number(&t, ns[i]);
    }
    output_extra_table(o, &t);
    free(r);
}

#endif
