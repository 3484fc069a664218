/* wrong.h: what is said of a function that is wrong: the ray with all its digits, enough to ask it
 * again, the hit that is due, and the one that was given.
 *
 *   wrong_report(out, "mine", r, due, got)     due, got: hit_none for no hit
 */
#ifndef RAY_WRONG_H
#define RAY_WRONG_H

#include "../hit.h"
#include <stdio.h>

/* ---------------------------------------------------------------------------------------------- */

static inline void wrong_print_hit(FILE *out, const char *who, hit h)
{
    if (h.shape == no_shape) fprintf(out, "  %s: no hit\n", who);
    else fprintf(out, "  %s: t = %.17g, u = %.17g, v = %.17g\n", who, (double)h.t, (double)h.u,
                 (double)h.v);
}

static inline void wrong_report(FILE *out, const char *name, ray r, hit due, hit got)
{
    fprintf(out, "%s: wrong ray: o = (%.17g, %.17g, %.17g), d = (%.17g, %.17g, %.17g), "
            "interval [%.17g, %.17g]\n", name, (double)r.o.x, (double)r.o.y, (double)r.o.z,
            (double)r.d.x, (double)r.d.y, (double)r.d.z, (double)r.tmin, (double)r.tmax);
    wrong_print_hit(out, "expected", due);
    wrong_print_hit(out, name, got);
}

#endif
