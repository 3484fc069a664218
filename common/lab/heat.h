/* heat.h: the colours of a picture of work (热力图, heat map).
 *
 *   vec3 c = work_colour(x)     x in [0, 1]: black, blue, violet, orange, white; below 0 and a NaN
 *                               as 0, above 1 as 1
 *
 *      0        1/4        1/2        3/4        1
 *      +---------+----------+----------+---------+     linear between; each is brighter than the
 *      black     blue       violet     orange    white     one before, so it also reads in grey
 */
#ifndef HEAT_H
#define HEAT_H

#include "../vec3.h"

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 work_colour(real x)
{
    static const vec3 scale[5] = {{0, 0, 0},
                                  {0.05, 0.06, 0.45},
                                  {0.5, 0.07, 0.4},
                                  {0.95, 0.45, 0.05},
                                  {1, 1, 1}};
    x = real_clamp(x, 0, 1) * 4;
    int i = x < 3 ? (int)x : 3;
    real f = x - (real)i;
    return vmadd(vscale(scale[i], 1 - f), scale[i + 1], f);
}

#endif
