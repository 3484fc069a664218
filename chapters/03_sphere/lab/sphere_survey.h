/* sphere_survey.h: which rays each of six ways gets wrong, at some distances.
 *
 *   sphere_shot_at(seed, how, far, i)   ray i from about far R away, and its sphere, aimed
 *       SPHERE_ANYWHERE       uniformly over a disc of 1.2 R around the centre
 *       SPHERE_GRAZING        to pass within 0.1 % of R
 *       SPHERE_EDGE           at a sphere cut to the ray, from far too large or small to the last
 *                             bit
 *       SPHERE_LIMB           the same, to the last bit: the nearest to a tangent that R can be
 *   sphere_survey_at(k, &surveys)       fills surveys.at[k], whose .far is given: for parallel_for
 *
 *   grazing_wrong    of all grazing rays, how many are misclassified, percent
 *   edge             the largest | pass / R - 1 | of a ray that was misclassified
 */
#ifndef SPHERE_SURVEY_H
#define SPHERE_SURVEY_H

#include "mine.h"
#include "sphere_variants.h"

enum { sphere_default = 5, sphere_methods = 6 + sphere_mine, sphere_distances = 13 };
static const char *const sphere_method_name[] = {
    "first", "stable root", "Haines et al.", "Lagrange", "Lagrange, Kahan", "sphere_hit", "mine"};
static sphere_hit_function *const sphere_method[] = {
    first_sphere_hit, sphere_hit_stable_root, sphere_hit_haines, sphere_hit_lagrange,
    sphere_hit_kahan, sphere_hit, mine_sphere_hit};

typedef struct { sphere ball; ray r; } sphere_shot;
typedef enum { SPHERE_ANYWHERE, SPHERE_GRAZING, SPHERE_EDGE, SPHERE_LIMB } sphere_how;
typedef struct { double grazing_wrong, edge; } sphere_errors;
typedef struct { real far; sphere_errors of[sphere_methods]; } sphere_survey;
typedef struct { sphere_survey at[sphere_distances]; size_t n; uint64_t seed; } sphere_surveys;

/* ---------------------------------------------------------------------------------------------- */

/* R from 1e-3 to 1e5, every other centre not 0. */
static inline sphere_shot sphere_shot_at(uint64_t seed, sphere_how how, real far, size_t i)
{
    random_stream s = random_start(seed, i, (uint64_t)how);
    real R = pow((real)10, 8 * random_next(&s) - 3);
    real u = random_next(&s), v = 2 * random_next(&s) - 1;
    real pass = how == SPHERE_GRAZING ? 1 + v / 1000 : (real)1.2 * sqrt(u);
    bool cut = how == SPHERE_EDGE || how == SPHERE_LIMB;
    sphere_shot t;
    t.r = sphere_aim(&s, R, far, cut ? 1 : pass, i % 2, &t.ball);
    double apart = how == SPHERE_EDGE ? (double)copysign(pow((real)10, -17 * u), v) : 0;
    if (cut) t.ball.r = (real)(sphere_pass(t.ball, t.r) / (1 + apart));
    return t;
}

static inline void sphere_survey_at(size_t k, void *context)
{
    sphere_surveys *all = context;
    sphere_survey *y = &all->at[k];
    for (int how = SPHERE_GRAZING; how <= SPHERE_EDGE; how++)
        for (size_t i = 0; i < all->n; i++) {
            sphere_shot shot = sphere_shot_at(all->seed, (sphere_how)how, y->far, i);
            shot.r.tmin = -real_infinity;
            double apart = sphere_clearance(shot.ball, shot.r);
            for (int m = 0; m < sphere_methods; m++) {
                hit h;
                if (sphere_method[m](shot.ball, shot.r, &h) == (apart <= 0)) continue;
                if (how == SPHERE_GRAZING) y->of[m].grazing_wrong += 100 / (double)all->n;
                else y->of[m].edge = fmax(y->of[m].edge, fabs(apart));
            }
        }
}

#endif
