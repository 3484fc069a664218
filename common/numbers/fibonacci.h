/* fibonacci.h: points for an integral over the unit square, where no chance is wanted.
 *
 *   1/whole * sum of area * f(u, v),  whole = sum of area                                  (23.21)
 *
 *   square_point p = fibonacci_point(fibonacci_small, i);    0 <= i < fibonacci_small.n;
 *                                                        p.u, p.v in (0,1); p.area: its share
 *
 * A Fibonacci lattice (斐波那契格点): point i is ((i + 1/2) / n, i g / n), n and g neighbours in
 * Fibonacci's sequence. Every strip of it is evenly filled, whatever its direction; a grid's are
 * not. s -> u = s^2 (3 - 2 s), du = 6 s (1 - s) ds, makes it denser at the edges of the square,
 * where the tails of lobes and the horizon are.
 *
 * Sources: S. Zaremba, "Good lattice points, discrepancy, and numerical integration", Annali di
 * Matematica 73, 1966; L. Hua, Y. Wang, "Applications of Number Theory to Numerical Analysis",
 * 1981.
 */
#ifndef FIBONACCI_H
#define FIBONACCI_H

#include "../vec3.h"

typedef struct { int n, g; } fibonacci_lattice;  /* n g < 2^31 */
typedef struct { real u, v, area; } square_point;
static const fibonacci_lattice fibonacci_small = {4181, 2584}, fibonacci_large = {28657, 17711};

/* ---------------------------------------------------------------------------------------------- */

static inline square_point fibonacci_point(fibonacci_lattice l, int i)
{
    real s = ((real)i + (real)0.5) / (real)l.n, t = ((real)(i * l.g % l.n) + (real)0.5) / (real)l.n;
    return (square_point){s * s * (3 - 2 * s), t * t * (3 - 2 * t), s * (1 - s) * t * (1 - t)};
}

#endif
