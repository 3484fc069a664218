/* roulette.h: ending a path by chance without changing what it brings on average.
 *                                                                 Russian roulette (俄罗斯轮盘赌)
 *   X' = X / q with probability q, else 0:   E[X'] = q E[X] / q + (1 - q) 0 = E[X]          (26.3)
 *   q = min(1, 2 x largest component of the throughput beta)                                (26.4)
 *
 * For any q in (0,1] the mean stays; the variance grows by E[X^2] (1 - q) / q, and the work shrinks
 * by what would have followed. (26.4) keeps beta's largest component at 1/2 or above it: paths that
 * go on count alike, dark ones are rare instead of faint. A path that still has half of its light
 * throws no die; black surfaces have ended before. Why 2: with 1, paths of a room end at the first
 * hits, which stratification (20) does most for; with 4 they go on for longer than it pays. The
 * README has the table.
 *
 *   real q = roulette_survival(beta);          in (0,1]; beta >= 0, not all 0
 *   if (q < 1 && u >= q) end; else beta /= q;
 *
 *   call                      cannot do
 *   roulette_fixed(beta)      q = 0.8, whatever the path carries: the notes' P_RR
 *
 * Source: J. Arvo, D. Kirk, "Particle Transport and Image Synthesis", SIGGRAPH 1990.
 */
#ifndef PATH_ROULETTE_H
#define PATH_ROULETTE_H

#include "../../common/vec3.h"

typedef enum { ROULETTE_NONE, ROULETTE_FIXED, ROULETTE_THROUGHPUT } roulette_rule;

/* ---------------------------------------------------------------------------------------------- */

static inline real roulette_fixed(vec3 beta) { return (void)beta, 0.8; }

static inline real roulette_within(vec3 beta, real keep)
{
    return real_min(keep * real_max(real_max(beta.x, beta.y), beta.z), 1);
}

enum { roulette_keep = 2 };  /* of (26.4) */
static inline real roulette_survival(vec3 beta) { return roulette_within(beta, roulette_keep); }

#endif
