/* lamps.h: the faces of a studio that emit light (Ke), as something to draw points from.
 *
 *   lamp_list l;
 *   lamps_build(&t, &l)                       of t.s; O(n)
 *   lamps_sample(&l, p, n, u, &x)             for a surface at p, normal n; false: this sample
 *                                             counts, and is 0; x.emitter: which of them
 *   real q = lamps_pdf(&l, Ke, shape, p, d, t, cosine)    of drawing the point that a ray from p
 *                                             along d meets at t, where it emits Ke; shape or NULL
 *   lamps_free(&l)
 *
 *   P(face) ~ area x radiance (24.10). Flat faces are drawn by area (24.4), spheres by angle
 *   (24.5). Then the density of a point by area, P(face) / area = (Ke.x + Ke.y + Ke.z) / sum,
 *   does not depend on which face it lies: no table from shapes to faces is needed.        (27.6)
 *
 * Polygons that emit are parallelograms: others have become triangles (finish.h).
 * MTL says nothing of a front: faces emit to both sides, and p draws from the side that it is on.
 * Spheres, too: from within by the directions of all the sphere, else by the cone they are seen in.
 */
#ifndef EFFECTS_LAMPS_H
#define EFFECTS_LAMPS_H

#include "../24_direct_light/lights.h"
#include "studio_tree.h"

typedef struct {
    emitter *face;
    studio_face *lies_in;   /* [n] what of the studio it is; no face: not flat */
    size_t n;
    lit_lights of;
    real sum;
} lamp_list;

/* ---------------------------------------------------------------------------------------------- */

static inline void lamps_free(lamp_list *l)
{
    free(l->face), free(l->lies_in);
    lit_lights_free(&l->of);
    *l = (lamp_list){.face = NULL};
}

/* Lamp x is in face `of`. */
static inline void lamps_add(lamp_list *l, emitter x, studio_face of)
{
    if (x.area > 0 && isfinite(x.area)) l->lies_in[l->n] = of, l->face[l->n++] = x;
}

/* In a studio nothing else shines: finish.h. */
static inline emitter lamps_of_shape(const shape *s, vec3 Ke)
{
    if (s->kind == SHAPE_SPHERE) return emitter_of_sphere(s->sphere, Ke);
    if (s->kind == SHAPE_TRIANGLE) return emitter_of_triangle(s->triangle, Ke);
    const vec3 *v = s->polygon.v;
    return emitter_of_rectangle((rectangle){v[0], vsub(v[1], v[0]), vsub(v[3], v[0])}, Ke);
}

/* In the world; where it was moved to, the pad of (16.3) is what rounding adds, once to the corners
 * and once to the ray that meets it. Climbing has met a fifth of a pad (12's node.h): so less would
 * be enough, and is not proven to be. */
static inline emitter lamps_of_triangle(const studio_tree *t, studio_face x, vec3 Ke)
{
    triangle c = studio_triangle(t->s, x.place, x.index);
    emitter one = emitter_of_triangle(c, Ke);
    vec3 most = vmax(vmax(vmax(c.a, vneg(c.a)), vmax(c.b, vneg(c.b))), vmax(c.c, vneg(c.c)));
    if (studio_moved(t, x.place)) one.noise += 2 * placing_pad(&t->pad[x.place], most);
    return one;
}

static inline void lamps_build(const studio_tree *t, lamp_list *out)
{
    const studio *s = t->s;
    *out = (lamp_list){.face = allocate(s->emitters, sizeof *out->face),
                       .lies_in = allocate(s->emitters, sizeof *out->lies_in)};
    for (size_t i = 0; i < s->emitters; i++) {
        studio_face x = s->emitter[i];
        studio_hit h = {{0, 0, 0, x.index}, x.place};
        vec3 Ke = s->material[studio_emitter_material(s, i)].mtl.ke;
        lamps_add(out, x.place == no_shape ? lamps_of_shape(&s->shape[x.index], Ke)
                                           : lamps_of_triangle(t, x, Ke), studio_flat_face(t, h));
    }
    double sum = 0;
    for (size_t i = 0; i < out->n; i++) sum += (double)emitter_power(&out->face[i]);
    out->sum = (real)sum;
    lit_lights_list(out->face, out->n, NULL, LIGHTS_FLUX, &out->of);
    if (!lit_lights_some(&out->of)) lamps_free(out);
}

/* Does the surface at p, of normal n, see the sphere from within? On the very sphere, where
 * rounding may have p on either side, its normal says so. */
static inline bool lamps_within(sphere s, vec3 p, vec3 n)
{
    vec3 in = vsub(s.c, p);
    real sure = (1 - 16 * real_epsilon) * fabs(s.r) - 4 * real_epsilon * surface_reach(p);
    return vlength(in) < sure || (emitter_sphere_around(s, p) && vdot(n, in) > 0);
}

/* The side of a lamp that p is on shines there, whichever way the file had it turned. */
fast_inline bool lamps_sample(const lamp_list *l, vec3 p, vec3 n, point2 u, lit_draw *out)
{
    real chance;
    out->emitter = (uint32_t)lit_lights_choose(&l->of, u.u, &chance, &u.u);
    const emitter *e = &l->face[out->emitter];
    if (e->kind != EMITTER_SPHERE) {
        emitter_point seen;
        vec3 x = emitter_at(e, u, &n), side = emitter_height(e, p) < 0 ? vneg(n) : n;
        return emitter_seen(e, x, side, p, &seen) && lit_drawn(e, &seen, chance, out);
    }
    emitter ball = *e;
    ball.sphere.r = lamps_within(e->sphere, p, n) ? -fabs(e->sphere.r) : fabs(e->sphere.r);
    return lit_draw_of(&ball, POINTS_CHEAP, chance, p, u, out);
}

static inline real lamps_pdf(const lamp_list *l, vec3 Ke, const shape *s, vec3 p, vec3 d, real t,
                             real cosine)
{
    if (!l->n) return 0;
    real bright = (Ke.x + Ke.y + Ke.z) / l->sum;                                      /* (27.6) */
    if (!s || s->kind != SHAPE_SPHERE) return bright * (t * t / cosine);
    emitter e = emitter_of_sphere(s->sphere, Ke);
    bool within = vdot(vsub(vmadd(p, d, t), s->sphere.c), d) > 0;  /* it was met from there */
    e.sphere.r = within ? -fabs(e.sphere.r) : fabs(e.sphere.r);
    return bright * e.area * emitter_pdf_angle(&e, p);
}

#endif
