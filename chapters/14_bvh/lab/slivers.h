/* slivers.h: long thin triangles (狭长三角形) at an odd angle: each fills next to nothing of its box.
 *
 *   mesh m = slivers_mesh(n, move)    n triangles, 4 long and 2 pi / n wide, round the axis
 *                                     (1, 0.8, 0.6) at distance 1, moved by `move`; mesh_free
 */
#ifndef BVH_SLIVERS_H
#define BVH_SLIVERS_H

#include "../../07_mesh/scenes/soup.h"

/* ---------------------------------------------------------------------------------------------- */

static inline mesh slivers_mesh(size_t n, vec3 move)
{
    mesh m = mesh_room(n);
    vec3 w = vunit(vec(1, 0.8, 0.6)), u, v;
    vbasis(w, &u, &v);
    for (size_t i = 0; i < n; i++) {
        real a = 2 * pi * (real)i / (real)n, b = 2 * pi * (real)(i + 1) / (real)n;
        m.v[3 * i] = vadd(move, vadd(vscale(u, cos(a)), vscale(v, sin(a))));
        m.v[3 * i + 1] = vadd(move, vadd(vscale(u, cos(b)), vscale(v, sin(b))));
        m.v[3 * i + 2] = vmadd(m.v[3 * i], w, 4);
    }
    return m;
}

#endif
