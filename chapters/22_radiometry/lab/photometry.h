/* photometry.h: the same light as a meter counts it, and as the eye does.
 *
 *   radiometric (辐射)    symbol  unit           photometric (光度)         unit
 *   flux (辐射通量)         Phi     W              luminous flux (光通量)     lumen   lm
 *   intensity (辐射强度)    I       W/sr           luminous intensity         candela cd = lm/sr
 *   irradiance (辐射照度)   E       W/m^2          illuminance (照度)         lux     lx = lm/m^2
 *   radiance (辐射亮度)     L       W/(m^2 sr)     luminance (亮度)           nit     cd/m^2
 *
 * They differ by a weight for each wavelength, V(lambda) (光视效率), and by a factor:
 *
 *   photometric = 683 lm/W  integral of V(lambda) radiometric(lambda) d lambda            (22.19)
 *
 *   luminous_efficiency(nm)       V: CIE's table, every 10 nm, in between a parabola through its
 *                                 logarithms: off by at most 0.003
 *
 * 683 lm/W defines the candela: at 540e12 Hz, about 555 nm, where V = 1. 0 outside 380 .. 780 nm.
 * All in double: these are numbers of a table, not of a ray.
 *
 * Sources: CIE 18.2, "The Basis of Physical Photometry", 1983, table 1; BIPM, "The International
 * System of Units", 9th ed., 2019, section 2.3.1.
 */
#ifndef RADIOMETRY_PHOTOMETRY_H
#define RADIOMETRY_PHOTOMETRY_H

#include "../../../common/vec3.h"

enum { efficiency_first = 380, efficiency_last = 780, efficiency_step = 10, efficiencies = 41 };
#define lumens_per_watt 683.0

/* ---------------------------------------------------------------------------------------------- */

static const double efficiency_table[efficiencies] = {
    0.000039, 0.000120, 0.000396, 0.001210, 0.004000, 0.011600, 0.023000, 0.038000, 0.060000,
    0.090980, 0.139020, 0.208020, 0.323000, 0.503000, 0.710000, 0.862000, 0.954000, 0.994950,
    0.995000, 0.952000, 0.870000, 0.757000, 0.631000, 0.503000, 0.381000, 0.265000, 0.175000,
    0.107000, 0.061000, 0.032000, 0.017000, 0.008210, 0.004102, 0.002091, 0.001047, 0.000520,
    0.000249, 0.000120, 0.000060, 0.000030, 0.000015};

/* V is nearly a bell curve, and the logarithm of one is a parabola. */
static inline double luminous_efficiency(double nm)
{
    if (!(nm >= efficiency_first && nm <= efficiency_last)) return 0;
    double x = (nm - efficiency_first) / efficiency_step;
    int i = (int)(x + 0.5);
    i = i < 1 ? 1 : i > efficiencies - 2 ? efficiencies - 2 : i;
    double a = log(efficiency_table[i - 1]), b = log(efficiency_table[i]);
    double c = log(efficiency_table[i + 1]), t = x - i;
    return exp(b + t * (c - a) / 2 + t * t * (a - 2 * b + c) / 2);
}

#endif
