/* spans.h: what a solid holds of a line, as a list of spans (区间), and how two lists make a third.
 *
 *      A    ----[=========]-----------[====]---->  t      in A where an odd number of crossings
 *      B    --------[==========]----------------->        lies behind us                  (6.2)
 *    A + B  ----[==============]------[====]---->         union (并集)         a or b      (6.3)
 *    A * B  --------[=====]---------------------->        intersection (交集)  a and b
 *    A - B  ----[===)-----------------[====]---->         difference (差集)    a and not b (6.1)
 *
 * A list has an even number n of crossings with strictly rising t: number 0, 2, 4 .. lead in, 1, 3,
 * 5 .. lead out. t reaches from -inf to +inf, and both may stand in a list: a half space begins or
 * ends there. The ray's interval plays no part here.
 *
 *   n = spans_merge(CSG_DIFFERENCE, a, na, b, nb, out);    out: room for na + nb, not a nor b
 *
 * What happens at one t happens at once: both lists move on, and then it is asked whether the
 * answer has changed. So no span has length 0: two cubes that share a face make one span in their
 * union, no span in their intersection, and A - A is empty. These are the regularised operations
 * (正则集合运算) of the source, which leave no dangling face. "One t" means the same bits: no eps.
 *
 * A crossing knows its surface: twice a number, plus 1 if the surface is turned over, as all are
 * that come from the right side of a difference. Where both lists cross, the lower number wins.
 *
 * Cost: O(na + nb). Source: A. Requicha, R. Tilove, "Mathematical Foundations of Constructive Solid
 * Geometry: General Topology of Closed Regular Sets", University of Rochester, 1978; S. Roth, "Ray
 * Casting for Modeling Solids", Computer Graphics and Image Processing 18, 1982.
 */
#ifndef CSG_SPANS_H
#define CSG_SPANS_H

#include "../01_ray/hit.h"
#include <stddef.h>

typedef struct { real t; uint32_t surface; } csg_crossing;
typedef enum { CSG_SOLID, CSG_UNION, CSG_INTERSECTION, CSG_DIFFERENCE } csg_operation;

/* ---------------------------------------------------------------------------------------------- */

/* Whether a point is in the whole, if it is in A (a) or not, and in B (b) or not.  (6.1), (6.3) */
static inline bool csg_inside(csg_operation what, bool a, bool b)
{
    return what == CSG_UNION ? a || b : what == CSG_INTERSECTION ? a && b : a && !b;
}

static inline size_t spans_merge(csg_operation what, const csg_crossing *a, size_t na,
                                 const csg_crossing *b, size_t nb, csg_crossing *out)
{
    size_t i = 0, j = 0, n = 0;
    uint32_t turn = what == CSG_DIFFERENCE;
    bool before = false;
    while (i < na || j < nb) {
        bool of_a = j == nb || (i < na && a[i].t <= b[j].t);
        bool of_b = i == na || (j < nb && b[j].t <= a[i].t);
        csg_crossing here = of_a ? a[i] : b[j];
        if (of_b && (!of_a || b[j].surface / 2 < here.surface / 2))
            here.surface = b[j].surface ^ turn;
        i += of_a, j += of_b;
        bool after = csg_inside(what, i % 2, j % 2);  /* (6.2) */
        if (after != before) out[n++] = here;
        before = after;
    }
    return n;
}

#endif
