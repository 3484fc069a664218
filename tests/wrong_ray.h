/* wrong_ray.h: the first ray whose answer is wrong, with all its digits: enough to ask it again. */
#ifndef TESTS_WRONG_RAY_H
#define TESTS_WRONG_RAY_H

#include "../chapters/01_ray/hit.h"
#include <stdio.h>

static inline void print_wrong(const char *who, ray r, hit due, hit found)
{
    static size_t printed;
    if (printed++) return;
    printf("%s: first wrong ray: o %.17g %.17g %.17g,\n    d %.17g %.17g %.17g, [%.17g, %.17g]\n",
           who, (double)r.o.x, (double)r.o.y, (double)r.o.z, (double)r.d.x, (double)r.d.y,
           (double)r.d.z, (double)r.tmin, (double)r.tmax);
    printf("    due: t %.17g, item %u; found: t %.17g, item %u\n", (double)due.t, due.shape,
           (double)found.t, found.shape);
}

#endif
