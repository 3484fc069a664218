/* solids.h: solids cut from solids (06) as things of a scene: what a ray hits there.
 *
 *   csg_hit(&x.c, r, &h)                        h.shape is a surface of the solid
 *   surface s = solid_surface(&x, r, h)         n points out of what is left, also in a cut; with
 *                                               the error bounds of 18, for leave.h
 *   solid_free(&x)
 *
 * p is put back on the surface of the operand that was hit, as surface.h does with shapes. A plane
 * n.p = h, |n| = 1: p - n (n.p - h) is off by 4 eps (|p| + |h|), and (6.4) sees its plane as far
 * off; a cylinder: of |p - axis point| and R. Balls are seen exactly (03).
 */
#ifndef EFFECTS_SOLIDS_H
#define EFFECTS_SOLIDS_H

#include "../06_csg/csg.h"
#include "../06_csg/files/expression.h"
#include "../18_shade/surface.h"

typedef struct { uint32_t file, line; } cite;  /* file 0: nobody said it; line 0: the whole file */
typedef struct { csg_expression e; csg c; uint32_t material; cite at; } studio_solid;

/* ---------------------------------------------------------------------------------------------- */

static inline void solid_free(studio_solid *x)
{
    csg_free(&x->c), csg_expression_free(&x->e);
}

/* The plane of a face of a solid with plane faces: n.p = h, n unit, outwards. */
static inline vec3 solid_plane(const csg_solid *s, size_t face, real *h)
{
    vec3 n = csg_solid_normal(s, face, (vec3){0, 0, 0});
    if (s->kind == CSG_MESH) *h = vdot(n, s->mesh.tri[face].a);
    else if (s->kind == CSG_HALF) *h = s->box.hi[0] / vlength(s->box.n[0]);
    else *h = face % 2 ? s->box.hi[face / 2] : -s->box.lo[face / 2];
    return n;
}

static inline surface solid_surface(const studio_solid *x, ray r, hit h)
{
    const real eps = real_epsilon;
    size_t i = csg_solid_of(&x->c, h), face = h.shape / 2 - x->c.first[i];
    const csg_solid *s = &x->c.solid[i];
    vec3 p = ray_at(r, h.t), n;
    surface a;
    if (s->kind == CSG_SPHERE)
        a = surface_on_sphere((sphere){s->ball.c, fabs(s->ball.r)}, h.shape, p);
    else if (s->kind == CSG_CYLINDER) {
        vec3 from = vsub(p, s->cylinder.p), axis = vunit(s->cylinder.a);
        real R = fabs(s->cylinder.r), size = vlength(from) + R;
        n = csg_solid_normal(s, face, p);
        p = vmadd(vmadd(s->cylinder.p, axis, vdot(from, axis)), n, R);
        a = (surface){p, n, n, eps * (4 * size + 2 * surface_reach(p)), 16 * eps * size, h.shape};
    } else {
        real at, size;
        n = solid_plane(s, face, &at);
        for (int k = 0; k < 2; k++) p = vmadd(p, n, at - vdot(n, p));  /* the first may be long */
        size = vlength(p) + fabs(at);
        a = (surface){p, n, n, eps * (4 * size + 2 * surface_reach(p)), 8 * eps * size, h.shape};
    }
    if (h.shape % 2) a.n = vneg(a.n), a.ns = a.n;
    return a;
}

#endif
