/* coplanar.h: which faces of meshes lie in the plane of another solid's face: asked once, before
 * any ray, so that rays find one t for both (closed_mesh.h).
 *
 *        mesh                          The box is flush with the mesh. Each finds t in its own
 *     .---------+------+               way; which is less, rounding decides, ray by ray: a skin
 *     |         | box  |               with speckles. So the triangle takes the box's way.
 *
 *   csg_solid *own = coplanar_solids(s, n)      copies of n solids; meshes know their planes, which
 *                                               go with csg_free; triangles stay the caller's
 *
 * A triangle lies in a plane n . p = h of a box or half space if its three corners do:
 *
 *      n along an axis     n . p = h as computed: the coordinate is the plane's, to the last bit
 *      else                |n . p - h| <= 8 eps (|n| R + |h|), R: farthest corner's |p|    (6.7)
 *
 * Corners of a turned face cannot be on its plane: the three coordinates were rounded, and so was
 * what they were computed from. (6.7) allows some five roundings of what is as large as R, and no
 * length in scene units: what is nearer than that has no numbers to tell it apart. A triangle that
 * lies in several planes takes the first. One that lies in none, with corners at the same x (y, z),
 * has the plane x = that: so coplanar faces of two meshes agree, if they stand across an axis.
 *
 *   what stays                                                answer
 *   two meshes, other triangles in one turned plane           speckle, unless a half space among
 *                                                             the solids names the plane
 *   a ray within rounding of an edge where such faces end     perhaps a span as long as rounding
 *
 * Cost: O(triangles times planes), once.
 */
#ifndef CSG_COPLANAR_H
#define CSG_COPLANAR_H

#include "../../common/file.h"
#include "solid.h"

/* ---------------------------------------------------------------------------------------------- */

static inline bool coplanar_triangle(csg_plane g, triangle t)
{
    real a = vdot(g.n, t.a) - g.h, b = vdot(g.n, t.b) - g.h, c = vdot(g.n, t.c) - g.h;
    if ((g.n.x != 0) + (g.n.y != 0) + (g.n.z != 0) == 1) return a == 0 && b == 0 && c == 0;
    real far = real_max(real_max(vlength(t.a), vlength(t.b)), vlength(t.c));
    real room = 8 * real_epsilon * (vlength(g.n) * far + fabs(g.h));                 /* (6.7) */
    return isfinite(g.h) && fabs(a) <= room && fabs(b) <= room && fabs(c) <= room;
}

static inline csg_plane coplanar_face(const csg_solid *s, size_t face)
{
    return (csg_plane){s->box.n[face / 2], (face % 2 ? s->box.hi : s->box.lo)[face / 2]};
}

/* n = 0: none. */
static inline csg_plane coplanar_plane(const csg_solid *s, size_t solids, triangle t)
{
    for (size_t i = 0; i < solids; i++) {
        if (s[i].kind != CSG_BOX && s[i].kind != CSG_HALF) continue;
        for (size_t k = 0; k < csg_solid_surfaces(&s[i]); k++)
            if (coplanar_triangle(coplanar_face(&s[i], k), t)) return coplanar_face(&s[i], k);
    }
    for (int k = 0; k < 3; k++)
        if (vaxis(t.a, k) == vaxis(t.b, k) && vaxis(t.a, k) == vaxis(t.c, k))
            return (csg_plane){vwith((vec3){0, 0, 0}, k, 1), vaxis(t.a, k)};
    return (csg_plane){{0, 0, 0}, 0};
}

static inline csg_solid *coplanar_solids(const csg_solid *s, size_t solids)
{
    csg_solid *own = allocate(solids, sizeof *own);
    for (size_t i = 0; i < solids; i++) {
        own[i] = s[i];
        if (s[i].kind != CSG_MESH) continue;
        csg_plane *of = allocate(s[i].mesh.n, sizeof *of);
        for (size_t k = 0; k < s[i].mesh.n; k++)
            of[k] = coplanar_plane(s, solids, s[i].mesh.tri[k]);
        own[i].mesh.plane = of;
    }
    return own;
}

#endif
