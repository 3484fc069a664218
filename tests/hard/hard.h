/* hard.h: what a row of the catalogue of hard cases is. shapes.h, structures.h and light.h have
 * them, by parts of the book; cases.c prints all. */
#ifndef HARD_H
#define HARD_H

#include "../../common/lab/chi_square.h"  /* before the shapes of 07, whose name it uses */
#include "../../common/random.h"
#include "../../common/vec3.h"

typedef struct { size_t tried, first, now; } hard_count;
typedef struct {
    const char *chapter, *name, *how, *oracle;
    hard_count (*count)(int k, real x);  /* k and x: what the function makes of them */
    int k;
    real x;
    enum { IN_DOUBLE, PROMISED } zero;   /* that the default has none wrong */
} hard_case;

#define WIDE "30 digits"
#define WHOLE "whole numbers"
static const uint64_t hard_seed = 18;
static const double hard_eps = (double)real_epsilon;

/* ---------------------------------------------------------------------------------------------- */

static inline bool hard_promised(const hard_case *c)
{
    return c->zero >= (real_is_float ? PROMISED : IN_DOUBLE);
}

/* A unit vector; not uniform, but in all digits. */
static inline vec3 hard_unit(random_stream *s) { return vunit(random_in_cube(s, 1)); }

#endif
