/* sky.h: an environment to look at.
 *
 *   environment_sky(256, 128, to_sun, &e)      a blue sky, a sun and what is around it
 */
#ifndef DIRECT_SKY_H
#define DIRECT_SKY_H

#include "../environment.h"

/* ---------------------------------------------------------------------------------------------- */

/* A sky to look at: paler towards the horizon, grey below it; the sun is a disk 3 degrees wide,
 * some thirty times the real one's area and about as many times less bright: maps may be small. */
static inline void environment_sky(int width, int height, vec3 to_sun, environment *out)
{
    image im = image_new(width, height);
    failure f;
    vec3 zenith = {0.18, 0.32, 0.65}, pale = {0.75, 0.82, 0.9};
    vec3 ground = {0.22, 0.2, 0.18}, gold = {1, 0.86, 0.65};
    to_sun = vunit(to_sun);
    for (int j = 0; j < height; j++)
        for (int i = 0; i < width; i++) {
            real theta = pi * ((real)j + (real)0.5) / (real)height;
            real phi = 2 * pi * ((real)i + (real)0.5) / (real)width;
            vec3 d = {sin(theta) * cos(phi), cos(theta), sin(theta) * sin(phi)};
            real up = real_max(d.y, 0), mix = 1 - (1 - up) * (1 - up) * (1 - up);
            vec3 c = d.y < 0 ? ground : vmadd(vscale(pale, 1 - mix), zenith, mix);
            vec3 off = vsub(d, to_sun);
            real near = vdot(off, off);  /* (2 sin(angle/2))^2: 0.000686 at 1.5 degrees */
            if (d.y >= 0) c = vmadd(c, gold, exp(-near * 12) * (real)0.6);
            if (near < (real)0.000686) c = vmadd(c, gold, 1400);
            image_set(&im, i, j, c);
        }
    if (!environment_of_image(&im, out, &f)) fail(f);
    image_free(&im);
}

#endif
