/* csg_variants.h: other ways to find the first hit of a tree, with the signature of csg_hit.
 *
 *   csg_hit_front(&c, r, &h)      first.h's way for any tree: hits with t > 0 alone, begins outside
 *   csg_hit_tolerant(&c, r, &h)   planes through a corner of their box, along two of its edges, t
 *                                 by (4.4); crossings within csg_tolerance [length] of each other
 *                                 happen at once. Below 0: one crossing at a time, those of a
 *                                 first: spans of length 0 stay, and those that are rounding errors
 *   csg_way_hit(&way, &c, r, &h)  a function, with its tolerance; bare: without bounds
 */
#ifndef CSG_VARIANTS_H
#define CSG_VARIANTS_H

#include "../csg.h"

typedef bool csg_hit_function(const csg *, ray, hit *);

typedef struct { csg_hit_function *X_hit; double tolerance; bool bare; } csg_way;

static _Thread_local real csg_tolerance, csg_tolerance_t;  /* [length], and in lengths of d */

/* ---------------------------------------------------------------------------------------------- */

/* What first.h keeps of a list. An odd rest never ends: the walk counts on from its beginning. */
static inline size_t csg_front_crossings(const csg_solid *s, ray r, uint32_t first,
                                         csg_crossing *out)
{
    size_t n = csg_solid_crossings(s, r, first, out), kept = 0;
    for (size_t i = 0; i < n; i++)
        if (out[i].t > 0 && isfinite(out[i].t)) out[kept++] = out[i];
    return kept;
}

static inline bool csg_hit_front(const csg *c, ray r, hit *out)
{
    return csg_hit_by(c, r, csg_front_crossings, spans_merge, out);
}

/* Boxes by the planes through their own least or greatest corner; triangles of a mesh know of no
 * planes, each finds t in its own way. */
static inline size_t csg_point_crossings(const csg_solid *s, ray r, uint32_t first,
                                         csg_crossing *out)
{
    real enter = -real_infinity, leave = real_infinity;
    uint32_t in = first, from = first;
    vec3 lo = {0, 0, 0}, hi = {0, 0, 0};
    csg_solid own = *s;
    if (s->kind == CSG_MESH) own.mesh.plane = NULL;
    if (s->kind != CSG_BOX) return csg_solid_crossings(&own, r, first, out);
    for (int k = 0; k < 3; k++)  /* axes at right angles, of length 1, right-handed */
        lo = vmadd(lo, s->box.n[k], s->box.lo[k]), hi = vmadd(hi, s->box.n[k], s->box.hi[k]);
    for (uint32_t k = 0; k < 3; k++) {
        vec3 n = vcross(s->box.n[(k + 1) % 3], s->box.n[(k + 2) % 3]);
        real along = vdot(n, r.d);
        bool back = along < 0;
        real t0 = vdot(vsub(back ? hi : lo, r.o), n) / along;                        /* (4.4) */
        real t1 = vdot(vsub(back ? lo : hi, r.o), n) / along;
        if (t0 > enter) enter = t0, in = first + 2 * k + back;
        if (t1 < leave) leave = t1, from = first + 2 * k + !back;
    }
    return csg_span(enter, in, leave, from, out);
}

static inline size_t csg_merge_tolerant(csg_operation what, const csg_crossing *a, size_t na,
                                        const csg_crossing *b, size_t nb, csg_crossing *out)
{
    size_t i = 0, j = 0, n = 0;
    bool before = false;
    while (i < na || j < nb) {
        bool of_a = j == nb || (i < na && a[i].t <= b[j].t);
        csg_crossing here = of_a ? a[i++] : b[j++];
        real last = here.t + csg_tolerance_t;
        if (!of_a && what == CSG_DIFFERENCE) here.surface ^= 1;
        while (i < na && a[i].t <= last) i++;
        while (j < nb && b[j].t <= last) j++;
        bool after = csg_inside(what, i % 2, j % 2);
        if (after != before) out[n++] = here;
        before = after;
    }
    return n;
}

/* The tolerance holds for single solids, too: who drops short spans drops all of them. */
static inline size_t csg_tolerant_crossings(const csg_solid *s, ray r, uint32_t first,
                                            csg_crossing *out)
{
    size_t n = csg_point_crossings(s, r, first, out), kept = 0;
    for (size_t i = 0; i + 1 < n; i += 2)
        if (out[i + 1].t - out[i].t > csg_tolerance_t)
            out[kept] = out[i], out[kept + 1] = out[i + 1], kept += 2;
    return kept;
}

static inline bool csg_hit_tolerant(const csg *c, ray r, hit *out)
{
    csg_tolerance_t = csg_tolerance / vlength(r.d);
    return csg_hit_by(c, r, csg_tolerant_crossings, csg_merge_tolerant, out);
}

static inline bool csg_way_hit(const csg_way *w, const csg *c, ray r, hit *out)
{
    csg own = *c;
    own.no_bounds = w->bare, csg_tolerance = (real)w->tolerance;
    return w->X_hit(&own, r, out);
}

#endif
