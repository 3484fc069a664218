/* implicit_trials.h: rays at a surface, near its rim if wanted, and what each method makes of them.
 *
 *   implicit_subject u = implicit_subject_of(IMPLICIT_TORUS);    a surface; those up to
 *                                  IMPLICIT_BARTH have a polynomial
 *   implicit_method_hit(how, &s, r, &h)        implicit_hit by one method, for comparing
 *   implicit_first_hit(&s, r, steps, &h)       first.h's, on a surface
 *   implicit_shot(&u, seed, how, i, &r)                   ray i; from outside the ball
 *       IMPLICIT_ANYWHERE   at a point of the ball
 *       IMPLICIT_GRAZING    past a point of the surface, at a right angle to the normal there, from
 *                           1e-1 to 1e-10 of the ball's radius above or below it
 *   implicit_truth_of(&u, r, &truth)      the oracle: how many roots, the first; false: there is no
 *                                  polynomial, or 32 digits cannot tell
 *   implicit_survey_of(&u, how, seed, kind, n, threads)   n rays by one method, against the oracle
 *
 *   missed    rays that have a root and miss it, or hit a later one: 10 sqrt(epsilon) B later or
 *             more, B the radius of the ball [% of all]
 *   made_up   rays that hit where there is no root within the next B / 20 [% of all]
 *   off       how far the other hits are from the first root at most [B]
 *   calls     evaluations of f, of its gradient, or of both over an interval, per ray
 */
#ifndef IMPLICIT_TRIALS_H
#define IMPLICIT_TRIALS_H

#include "../../../common/parallel.h"
#include "../../../common/random.h"
#include "../first.h"
#include "../implicit.h"
#include "../scenes/models.h"
#include "implicit_oracle.h"

typedef enum { IMPLICIT_FIRST, IMPLICIT_NEWTON, IMPLICIT_TRACE, IMPLICIT_INTERVAL } implicit_kind;
typedef struct {
    implicit_kind kind;
    int steps;   /* first, newton: in the interval; trace: at most; interval: not used */
    real eps;    /* trace alone: how near is a hit [scene units] */
} implicit_how;
typedef enum {
    IMPLICIT_SPHERE, IMPLICIT_TORUS, IMPLICIT_TUBE, IMPLICIT_BARTH, IMPLICIT_GYROID, IMPLICIT_BOX,
    IMPLICIT_BLEND, implicit_names
} implicit_name;
static const char *const implicit_name_of[implicit_names] = {"sphere", "torus", "tube", "barth",
                                                             "gyroid", "box", "blend"};
typedef struct { implicit_name name; implicit_surface s; } implicit_subject;
typedef enum { IMPLICIT_ANYWHERE, IMPLICIT_GRAZING } implicit_aim;
typedef struct { double missed, made_up, off, calls; size_t due, unsure; } implicit_survey;

/* ---------------------------------------------------------------------------------------------- */

/* first.h takes an f without data: this thread's surface is handed to it aside. */
static _Thread_local const implicit_surface *implicit_asked;
static inline real implicit_asked_value(vec3 p) { return implicit_value(implicit_asked, p); }

static inline bool implicit_first_hit(const implicit_surface *s, ray r, int steps, hit *out)
{
    implicit_asked = s;
    return implicit_clip(s, &r) && first_implicit_hit(implicit_asked_value, r, steps, out);
}

static inline bool implicit_method_hit(implicit_how how, const implicit_surface *s, ray r, hit *out)
{
    switch (how.kind) {
    case IMPLICIT_FIRST: return implicit_first_hit(s, r, how.steps, out);
    case IMPLICIT_NEWTON: return implicit_newton_hit(s, r, how.steps, out);
    case IMPLICIT_TRACE: return implicit_trace_hit(s, r, how.eps, how.steps, out);
    case IMPLICIT_INTERVAL: return implicit_search_hit(s, r, out);
    }
    return false;
}

/* What the surfaces point to. */
static const real implicit_radius = 1, implicit_barth_radius = 2;
static const implicit_ring implicit_tube = {1, (real)0.3};
static const sphere implicit_cut = {{0, 0, 0}, 6};
static const implicit_box_shape implicit_brick = {{(real)-0.5, 0, 0},
                                                  {(real)0.45, (real)0.5, (real)0.3}, (real)0.1};
static const sphere implicit_knob = {{(real)0.55, (real)0.1, 0}, (real)0.55};
static implicit_pair implicit_melted;

static inline implicit_subject implicit_subject_of(implicit_name name)
{
    implicit_melted = (implicit_pair){implicit_box(&implicit_brick), implicit_ball(&implicit_knob),
                                      (real)0.3};
    const implicit_surface all[implicit_names] = {
        implicit_sphere(&implicit_radius), implicit_torus(&implicit_tube),
        implicit_torus_distance(&implicit_tube), implicit_barth(&implicit_barth_radius),
        implicit_gyroid(&implicit_cut), implicit_box(&implicit_brick),
        implicit_blend(&implicit_melted)};
    return (implicit_subject){name, all[name]};
}

static inline vec3 implicit_random_direction(random_stream *s)
{
    vec3 v;
    do v = random_in_cube(s, 1);
    while (!(vdot(v, v) <= 1 && vdot(v, v) > (real)0.01));
    return vunit(v);
}

static inline ray implicit_ray_anywhere(const implicit_subject *u, random_stream *s)
{
    real B = u->s.ball.r;
    vec3 o = vmadd(u->s.ball.c, implicit_random_direction(s), 2 * B);
    real off = B * cbrt(random_next(s));
    vec3 to = vmadd(u->s.ball.c, implicit_random_direction(s), off);
    return ray_from(o, vscale(vsub(to, o), (real)0.5 + random_next(s)));
}

/* Points of the surface by steps and halving; the normal as it comes. */
static inline void implicit_shot(const implicit_subject *u, uint64_t seed, implicit_aim how,
                                 size_t i, ray *out)
{
    random_stream s = random_start(seed, i, (uint64_t)how);
    hit h;
    for (;;) {
        *out = implicit_ray_anywhere(u, &s);
        if (how == IMPLICIT_ANYWHERE) return;
        if (!implicit_first_hit(&u->s, *out, 100, &h)) continue;
        vec3 p = ray_at(*out, h.t), n = implicit_normal(&u->s, p);
        if (vzero(n)) continue;
        vec3 d = vunit(vcross(n, implicit_random_direction(&s)));
        real above = u->s.ball.r * pow((real)10, -1 - 9 * random_next(&s));
        p = vmadd(p, n, random_next(&s) < (real)0.5 ? above : -above);
        *out = ray_from(vmadd(p, d, -2 * u->s.ball.r), vscale(d, (real)0.5 + random_next(&s)));
        return;
    }
}

static inline bool implicit_truth_of(const implicit_subject *u, ray r, implicit_truth *out)
{
    *out = (implicit_truth){0, 0};
    if (u->name > IMPLICIT_BARTH) return false;
    if (!implicit_clip(&u->s, &r)) return true;
    double a = (double)r.tmin, b = (double)r.tmax, at = a / 2 + b / 2;
    if (!(b > a)) return false;
    implicit_poly p = u->name == IMPLICIT_SPHERE ? implicit_poly_sphere(implicit_radius, r, at)
                    : u->name == IMPLICIT_BARTH ? implicit_poly_barth(r, at)
                    : implicit_poly_torus(implicit_tube, r, at);
    return implicit_oracle(&p, a, b, at, out);
}

/* A surface that counts its calls, this thread's. */
static _Thread_local size_t implicit_calls;
static real implicit_counted_f(const void *data, vec3 p)
{
    const implicit_surface *s = data;
    return implicit_calls++, s->f(s->data, p);
}
static vec3 implicit_counted_gradient(const void *data, vec3 p)
{
    const implicit_surface *s = data;
    return implicit_calls++, s->gradient(s->data, p);
}
static jet implicit_counted_range(const void *data, jet x, jet y, jet z)
{
    const implicit_surface *s = data;
    return implicit_calls++, s->range(s->data, x, y, z);
}
static inline implicit_surface implicit_counted(const implicit_surface *s)
{
    return (implicit_surface){implicit_counted_f, s->gradient ? implicit_counted_gradient : NULL,
                              s->range ? implicit_counted_range : NULL, s->lipschitz, s->ball, s};
}

enum { implicit_batches = 64 };
typedef struct {
    const implicit_subject *u;
    implicit_how how;
    implicit_aim aim;
    uint64_t seed;
    size_t n;
    implicit_survey part[implicit_batches];
} implicit_surveying;

static inline void implicit_judge(const implicit_surveying *y, size_t i, implicit_survey *out)
{
    ray r;
    hit h = hit_none;
    implicit_truth due;
    implicit_surface counted = implicit_counted(&y->u->s);
    implicit_shot(y->u, y->seed, y->aim, i, &r);
    bool known = implicit_truth_of(y->u, r, &due), is_due = due.roots > 0;
    implicit_calls = 0;
    bool is = implicit_method_hit(y->how, &counted, r, &h);
    out->calls += (double)implicit_calls;
    if (!known) { out->unsure++; return; }
    double later = ((double)h.t - due.first) * (double)vlength(r.d) / (double)y->u->s.ball.r;
    bool lost = is_due && !(is && later < 10 * sqrt((double)real_epsilon));
    bool made_up = is && (!is_due || later < -0.05);
    out->due += is_due, out->missed += lost, out->made_up += made_up;
    if (is_due && !lost && !made_up) out->off = fmax(out->off, fabs(later));
}

static inline void implicit_batch(size_t k, void *context)
{
    implicit_surveying *y = context;
    for (size_t i = k; i < y->n; i += implicit_batches) implicit_judge(y, i, &y->part[k]);
}

static inline implicit_survey implicit_survey_of(const implicit_subject *u, implicit_how how,
                                                 uint64_t seed, implicit_aim aim, size_t n,
                                                 int threads)
{
    implicit_surveying y = {.u = u, .how = how, .aim = aim, .seed = seed, .n = n};
    implicit_survey sum = {.off = 0};
    parallel_whole(implicit_batches, threads, "rays", implicit_batch, &y);
    for (int k = 0; k < implicit_batches; k++) {
        const implicit_survey *p = &y.part[k];
        sum.missed += p->missed, sum.made_up += p->made_up, sum.calls += p->calls;
        sum.due += p->due, sum.unsure += p->unsure, sum.off = fmax(sum.off, p->off);
    }
    sum.missed *= 100 / (double)n, sum.made_up *= 100 / (double)n, sum.calls /= (double)n;
    return sum;
}

#endif
