/* gauss.h: integrals of smooth functions by a few points.                Gauss quadrature (高斯求积)
 *
 *   for (int i = 0; i < gauss_n; i++)                integral of f over [0, 1]
 *       sum += gauss_weight(i) * f(gauss_point(i));
 *
 * n points are exact for polynomials up to degree 2n - 1. The error of a function that is analytic
 * falls as rho^-2n, rho being larger the farther away its nearest singularity is. No difference is
 * formed: an f >= 0 is integrated without cancellation, and that is what it is used for here.
 *
 * Source: C. F. Gauss, "Methodus nova integralium valores per approximationem inveniendi", 1815.
 */
#ifndef GAUSS_H
#define GAUSS_H

#include "../vec3.h"

enum { gauss_n = 16 };

/* ---------------------------------------------------------------------------------------------- */

/* Half of the points of [-1, 1]. */
static const double gauss_x[] = {0.98940093499164993259, 0.94457502307323257607,
                                 0.86563120238783174388, 0.75540440835500303389,
                                 0.61787624440264374844, 0.45801677765722738634,
                                 0.28160355077925891323, 0.09501250983763744018};
static const double gauss_w[] = {0.02715245941175409485, 0.06225352393864789286,
                                 0.09515851168249278480, 0.12462897125553387205,
                                 0.14959598881657673208, 0.16915651939500253818,
                                 0.18260341504492358886, 0.18945061045506849628};

static inline real gauss_point(int i)  /* in (0, 1) */
{
    bool left = i < gauss_n / 2;
    double x = gauss_x[left ? i : gauss_n - 1 - i];
    return (real)((1 + (left ? -x : x)) / 2);
}

static inline real gauss_weight(int i)
{
    return (real)(gauss_w[i < gauss_n / 2 ? i : gauss_n - 1 - i] / 2);
}

#endif
