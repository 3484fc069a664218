/* as_first.h: a mesh as the first programs have it, so that their structures stand in the tables
 * beside those of 10 to 14.
 *
 *   first_mesh f = first_mesh_of(&m);     triangle i is triangle i; first_mesh_free
 *                                         [< 2^31 triangles]
 *   first_is_wrong(h, brute)              is h another answer than brute force's?
 *
 * The first structures ask first_triangle_hit, which rounds otherwise than triangle_hit: t and u, v
 * are not the same bits, and of two neighbours at an edge either may be hit. Wrong is a hit where
 * there is none, none where there is one, or another t: by more than 1e-3 of it in float, 1e-8 in
 * double. A slip through a seam (04) is wrong, too: who calls them gets both faults.
 */
#ifndef MESH_AS_FIRST_H
#define MESH_AS_FIRST_H

#include "../../01_ray/hit.h"
#include "../first.h"
#include "../mesh.h"

/* ---------------------------------------------------------------------------------------------- */

static inline first_mesh first_mesh_of(const mesh *m)
{
    first_mesh s = {allocate(m->triangles, sizeof *s.tri), (int)m->triangles};
    for (size_t i = 0; i < m->triangles; i++) s.tri[i] = mesh_triangle(m, i);
    return s;
}

/* Both are hit_none where there is no hit; infinity - infinity is no number, and not wrong. */
static inline bool first_is_wrong(hit h, hit due)
{
    real most = (real_is_float ? (real)1e-3 : (real)1e-8) * due.t;
    return (h.shape == no_shape) != (due.shape == no_shape) || fabs(h.t - due.t) > most;
}

#endif
