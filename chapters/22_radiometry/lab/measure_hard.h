/* measure_hard.h: tiny, far, grazing, touching: how far off each variant is, and how long it takes.
 *
 *   measure_hard(o)   a table: the largest relative error in 256 inputs, ns of one
 *
 * A case of hard_list fills a radiometry_hard_run with random inputs of its kind; hard_error is the
 * largest error of a variant in them, against 32 digits (oracle.h). Variants: first.h (spheres
 * only), naive, the formula of chapter 07 as it stands (triangles only), the default.
 */
#ifndef RADIOMETRY_MEASURE_HARD_H
#define RADIOMETRY_MEASURE_HARD_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../07_mesh/inside.h"
#include "oracle.h"
#include "../relations.h"

/* ---------------------------------------------------------------------------------------------- */

enum { HARD_FIRST, HARD_NAIVE, HARD_AS_IN_07, HARD_DEFAULT, most_variants, hard_inputs = 256 };
typedef enum {
    HARD_SPHERE_ANGLE, HARD_TRIANGLE_ANGLE, HARD_SPHERE_E, HARD_SQUARE_E
} radiometry_hard;
typedef struct { radiometry_hard kind; sphere s; triangle t; vec3 v[4]; } radiometry_hard_input;
typedef struct {
    const char *name, *input;
    radiometry_hard kind;
    double size;
    int shape;
} radiometry_hard_case;
enum { SHAPE_ANY, SHAPE_GRAZING, SHAPE_TOUCHING };

static const radiometry_hard_case hard_list[] = {
    {"solid angle, sphere", "R/d = 1e-2", HARD_SPHERE_ANGLE, 1e-2, SHAPE_ANY},
    {"solid angle, sphere", "R/d = 1e-6", HARD_SPHERE_ANGLE, 1e-6, SHAPE_ANY},
    {"solid angle, sphere", "gap 1e-6 R", HARD_SPHERE_ANGLE, 1e-6, SHAPE_TOUCHING},
    {"solid angle, triangle", "size 1", HARD_TRIANGLE_ANGLE, 1, SHAPE_ANY},
    {"solid angle, triangle", "size 1e-3", HARD_TRIANGLE_ANGLE, 1e-3, SHAPE_ANY},
    {"solid angle, triangle", "size 1e-7", HARD_TRIANGLE_ANGLE, 1e-7, SHAPE_ANY},
    {"solid angle, triangle", "1e-6 off its plane", HARD_TRIANGLE_ANGLE, 1e-6, SHAPE_GRAZING},
    {"irradiance, sphere", "half sunk, R/d = 0.1", HARD_SPHERE_E, 1e-1, SHAPE_ANY},
    {"irradiance, sphere", "half sunk, R/d = 1e-3", HARD_SPHERE_E, 1e-3, SHAPE_ANY},
    {"irradiance, sphere", "half sunk, R/d = 1e-6", HARD_SPHERE_E, 1e-6, SHAPE_ANY},
    {"irradiance, sphere", "1e-4 R above the horizon", HARD_SPHERE_E, 1e-4, SHAPE_GRAZING},
    {"irradiance, sphere", "gap 1e-6 R", HARD_SPHERE_E, 1e-6, SHAPE_TOUCHING},
    {"irradiance, square", "size 1", HARD_SQUARE_E, 1, SHAPE_ANY},
    {"irradiance, square", "size 1e-3", HARD_SQUARE_E, 1e-3, SHAPE_ANY},
    {"irradiance, square", "size 1e-6", HARD_SQUARE_E, 1e-6, SHAPE_ANY},
    {"irradiance, square", "1e-5 above the horizon", HARD_SQUARE_E, 1e-5, SHAPE_GRAZING},
    {"irradiance, square", "gap 1e-6 to the floor", HARD_SQUARE_E, 1e-6, SHAPE_TOUCHING},
};
enum { hard_cases = sizeof hard_list / sizeof *hard_list };

static inline vec3 hard_point(random_stream *s, double size)
{
    real x = random_between(s, -size, size), y = random_between(s, -size, size);
    return (vec3){x, y, random_between(s, -size, size)};
}

/* Seen from the origin, the surface being the plane z = 0. */
static inline radiometry_hard_input hard_make(const radiometry_hard_case *c, random_stream *s)
{
    radiometry_hard_input h = {.kind = c->kind, .s.r = 1};
    real d = (real)(1 / c->size), gap = (real)c->size;
    real turn = random_between(s, 0, 6), spread = random_between(s, 0.5, 1);
    if (c->shape != SHAPE_ANY) d = c->shape == SHAPE_TOUCHING ? 1 + gap * spread : 10 * spread;
    if (c->kind == HARD_SPHERE_ANGLE) h.s.c = vscale((vec3){cos(turn), sin(turn), 0}, d * spread);
    if (c->kind == HARD_SPHERE_ANGLE && c->shape == SHAPE_TOUCHING) h.s.c = (vec3){0, d, 0};
    if (c->kind == HARD_SPHERE_E) h.s.c = (vec3){d, 0, random_between(s, -0.9, 0)};
    if (c->kind == HARD_SPHERE_E && c->shape == SHAPE_GRAZING) h.s.c.z = -1 + gap;
    if (c->kind == HARD_TRIANGLE_ANGLE) {
        real size = c->shape == SHAPE_GRAZING ? 1 : (real)c->size;
        vec3 a = {random_between(s, 1, 2), random_between(s, -1, 1), random_between(s, -1, 1)};
        h.t = (triangle){a, vadd(a, hard_point(s, (double)size)),
                         vadd(a, hard_point(s, (double)size))};
        if (c->shape == SHAPE_GRAZING) h.t.a.z = h.t.b.z = h.t.c.z = gap;
    }
    if (c->kind != HARD_SQUARE_E) return h;
    real size = c->shape == SHAPE_ANY ? (real)c->size : 1, x = random_between(s, 1, 2), z = gap;
    if (c->shape == SHAPE_ANY) z = random_between(s, 0.2, 1);
    if (c->shape == SHAPE_GRAZING) z = gap - size;  /* upright: nearly all of it below */
    vec3 o = {x, random_between(s, -0.9, -0.1) * size, z};
    rectangle r = {o, {0, 0, size}, {0, size, 0}};
    if (c->shape == SHAPE_TOUCHING) r = (rectangle){{-spread, o.y, z}, {0, 1, 0}, {1, 0, 0}};
    h.v[0] = r.o, h.v[1] = vadd(r.o, r.s), h.v[2] = vadd(h.v[1], r.t), h.v[3] = vadd(r.o, r.t);
    return h;
}

static inline double hard_exact(const radiometry_hard_input *h)
{
    switch (h->kind) {
    case HARD_SPHERE_ANGLE: {  /* 2 pi sin^2 / (1 + cos) */
        wide dd = wide3_dot(wide3_of(h->s.c), wide3_of(h->s.c)), one_wide = wide_of(1);
        wide cosine = wide_sqrt(wide_div(wide_sub(dd, one_wide), dd));
        wide q = wide_div(wide_div(one_wide, dd), wide_add(one_wide, cosine));
        return 2 * 3.14159265358979324 * wide_value(q);
    }
    case HARD_TRIANGLE_ANGLE: return triangle_solid_angle_exact(h->t, seen_from);
    case HARD_SPHERE_E:
        return sphere_irradiance_exact((double)h->s.r, (double)h->s.c.x, (double)h->s.c.z);
    case HARD_SQUARE_E: return polygon_irradiance_exact(h->v, 4, seen_from);
    }
    return 0;
}

static inline real hard_value(const radiometry_hard_input *h, int variant)
{
    const triangle *t = &h->t;
    bool good = variant == HARD_DEFAULT;
    switch (h->kind) {
    case HARD_SPHERE_ANGLE:
        return good ? sphere_solid_angle(h->s, seen_from)
                    : first_sphere_solid_angle(h->s, seen_from);
    case HARD_TRIANGLE_ANGLE:
        return good                     ? triangle_solid_angle(*t, seen_from)
               : variant == HARD_AS_IN_07 ? (real)solid_angle(t->a, t->b, t->c)
                                          : triangle_solid_angle_girard(*t, seen_from);
    case HARD_SPHERE_E:
        return good                    ? sphere_irradiance(h->s, seen_from, seen_up)
               : variant == HARD_FIRST ? first_sphere_irradiance(h->s, 1, seen_from, seen_up)
                                       : sphere_irradiance_naive(h->s, seen_from, seen_up);
    case HARD_SQUARE_E:
        return good ? polygon_irradiance(h->v, 4, seen_from, seen_up)
                    : polygon_irradiance_naive(h->v, 4, seen_from, seen_up);
    }
    return 0;
}

static inline bool hard_has(radiometry_hard k, int variant)
{
    if (variant == HARD_FIRST) return k == HARD_SPHERE_ANGLE || k == HARD_SPHERE_E;
    if (variant == HARD_NAIVE) return k != HARD_SPHERE_ANGLE;
    return variant != HARD_AS_IN_07 || k == HARD_TRIANGLE_ANGLE;
}

typedef struct { radiometry_hard_input in[hard_inputs]; int variant; } radiometry_hard_run;

static inline double run_hard(void *context)
{
    const radiometry_hard_run *r = context;
    real sum = 0;
    for (int i = 0; i < hard_inputs; i++) sum += hard_value(&r->in[i], r->variant);
    return (double)sum;
}

/* The largest relative error of a variant over the inputs; a NaN stays. */
static inline double hard_error(const radiometry_hard_run *r, int variant)
{
    double worst = 0;
    for (int i = 0; i < hard_inputs; i++) {
        double exact = hard_exact(&r->in[i]);
        double off = fabs(((double)hard_value(&r->in[i], variant) - exact) / exact);
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
                        "quantity|case|error first|error naive|error as in 07|error default|"
                        "time first [ns]|time naive [ns]|time as in 07 [ns]|time default [ns]");
    radiometry_hard_run *r = allocate(most_variants, sizeof *r);
    for (int k = 0; k < hard_cases; k++) {
        const radiometry_hard_case *c = &hard_list[k];
        double ns[most_variants];
        for (int i = 0; i < most_variants; i++) hard_fill(&r[i], c, o->seed), r[i].variant = i;
        bench_each(run_hard, r, sizeof *r, most_variants, 21, 1e9 / hard_inputs, ns);
        table_text(&t, "%s", c->name), table_text(&t, "%s", c->input);
        for (int i = 0; i < 2 * most_variants; i++) {
            if (!hard_has(c->kind, i % most_variants)) table_text(&t, "-");
            else if (i < most_variants) table_number(&t, hard_error(&r[0], i));
            else table_number(&t, ns[i - most_variants]);
        }
    }
    output_extra_table(o, &t);
    free(r);
}

#endif
