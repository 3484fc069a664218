/* sphere_survey.h: which rays each of eight ways gets wrong, at thirteen distances.
 *
 *   shot_at(seed, how, far, i)   ray i from about far R away, and its sphere, aimed
 *       anywhere                 uniformly over a disc of 1.2 R around the centre
 *       grazing                  to pass within 0.1 % of R
 *       edge                     at a sphere cut to the ray, from far too large or small to the
 *                                last bit
 *       limb                     the same, to the last bit: the nearest to a tangent that R can be
 *       surface                  anywhere, but from the surface of the sphere itself
 *   survey_at(k, &surveys)       fills surveys.at[k], whose .far is given: for parallel_for
 *
 *   missed, grazing_missed       of the rays that should hit, how many miss, percent
 *   grazing_untrue               of the rays that should miss, how many hit, percent
 *   edge                         the largest | pass / R - 1 | of a ray that was told wrong
 *   residual                     how far a hit is off the surface at most, over R
 */
#ifndef SPHERE_SURVEY_H
#define SPHERE_SURVEY_H

#include "sphere_oracle.h"
#include "sphere_variants.h"

enum { methods = 8, distances = 13 };
static const char *const method_name[methods] = {
    "first, in float", "first", "first, in double", "stable root",
    "Haines et al.", "Lagrange", "Lagrange, Kahan", "sphere_hit"};
static sphere_hit_function *const method_hit[methods] = {
    sphere_hit_first_f32, first_sphere_hit, sphere_hit_in_double, sphere_hit_stable_root,
    sphere_hit_haines, sphere_hit_lagrange, sphere_hit_kahan, sphere_hit};

typedef struct { sphere ball; ray r; } shot;
typedef enum { anywhere, grazing, edge, limb, surface } aim;
typedef struct { double missed, grazing_missed, grazing_untrue, edge, residual; } errors;
typedef struct { real far; errors of[methods]; } survey;
typedef struct { survey at[distances]; size_t n; uint64_t seed; } surveys;

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 narrow(vec3 a)
{
    return (vec3){(real)(float)a.x, (real)(float)a.y, (real)(float)a.z};
}

/* What the float exhibit is given: its errors then are its own, not those of its input. */
static inline shot narrowed(shot s)
{
    return (shot){{narrow(s.ball.c), (real)(float)s.ball.r},
                  ray_from(narrow(s.r.o), narrow(s.r.d))};
}

/* R from 1e-3 to 1e5, every other centre not 0. */
static inline shot shot_at(uint64_t seed, aim how, real far, size_t i)
{
    random_stream s = random_start(seed, i, (uint64_t)how);
    real R = pow((real)10, 8 * random_next(&s) - 3);
    real u = random_next(&s), v = 2 * random_next(&s) - 1;
    real pass = how == grazing ? 1 + v / 1000 : (real)1.2 * sqrt(u);
    if (how == edge || how == limb) pass = 1;
    shot t;
    t.r = sphere_aim(&s, R, far, pass, i % 2, &t.ball);
    double apart = how == edge ? (double)copysign(pow((real)10, -17 * u), v) : 0;
    if (how == edge || how == limb) t.ball.r = (real)(sphere_pass(t.ball, t.r) / (1 + apart));
    if (how == surface) t.r.o = sphere_point(t.ball, t.r.o);
    return t;
}

static inline void survey_at(size_t k, void *context)
{
    surveys *all = context;
    survey *y = &all->at[k];
    for (int how = anywhere; how <= edge; how++) {
        double due[2] = {0, 0}, wrong[methods][2] = {{0}};
        for (size_t i = 0; i < all->n; i++) {
            shot own = shot_at(all->seed, (aim)how, y->far, i), own_f32 = narrowed(own);
            double clear = sphere_clearance(own.ball, own.r);
            double clear_f32 = sphere_clearance(own_f32.ball, own_f32.r);
            due[clear <= 0]++;
            for (int m = 0; m < methods; m++) {
                shot s = m ? own : own_f32;
                double c = m ? clear : clear_f32;
                hit h;
                s.r.tmin = -real_infinity;
                bool is = method_hit[m](s.ball, s.r, &h), right = is == (c <= 0);
                if (!right) wrong[m][c <= 0]++;
                if (!right && how == edge) y->of[m].edge = fmax(y->of[m].edge, fabs(c));
                if (!(is && right && how == anywhere && i % 8 == 0)) continue;
                double residual = sphere_residual(s.ball, s.r, h.t);
                if (!(residual <= y->of[m].residual)) y->of[m].residual = residual;
            }
        }
        for (int m = 0; m < methods; m++) {
            double missed = 100 * wrong[m][1] / due[1], untrue = 100 * wrong[m][0] / due[0];
            if (how == anywhere) y->of[m].missed = missed;
            if (how == grazing) y->of[m].grazing_missed = missed, y->of[m].grazing_untrue = untrue;
        }
    }
}

#endif
