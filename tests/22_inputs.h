/* Random inputs of 22's tests, and how far off an answer is. */
#ifndef RADIOMETRY_INPUTS_H
#define RADIOMETRY_INPUTS_H

#include "../common/random.h"
#include "../common/vec3.h"
#include <math.h>

static const double eps = (double)real_epsilon, PI = 3.14159265358979324;

/* 10^x, x uniform */
static inline real size_between(random_stream *s, real lo, real hi)
{
    return (real)pow(10, (double)random_between(s, lo, hi));
}

static inline double relative(double value, double exact)
{
    return exact == 0 ? fabs(value) : fabs(value / exact - 1);
}

#endif
