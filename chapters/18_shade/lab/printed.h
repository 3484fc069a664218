/* printed.h: shade() as the notes print it, to see what it does: the answer of the shadow ray is
 * not used, and what it hits is shaded, too, by shadow rays of its own.
 *
 *   tracer t = {&world, printed_programs, &shading};
 *   vec3 c = printed_ray(&t, r, depth)       at most `depth` rays behind one another [>= 1], the
 *                                            camera ray being the first (光线深度); without that
 *                                            limit it may never end
 *
 * The notes' reflection and refraction rays are left out: nothing here is a mirror.
 * Source: T. Akenine-Möller et al., "Real-Time Rendering", 4th ed., 2018, section 26.1.
 */
#ifndef SHADE_LAB_PRINTED_H
#define SHADE_LAB_PRINTED_H

#include "../shade.h"

typedef struct { vec3 colour; int left; } printed_payload;

/* ---------------------------------------------------------------------------------------------- */

static inline void printed_closest_hit(tracer *t, ray r, trace_hit x, void *payload)
{
    const shading *how = t->user;
    printed_payload *p = payload;
    surface s = surface_facing(surface_of_trace(t, r, x), r.d);
    material m = how->material_of(how->context, x, &s);
    p->colour = vadd(m.ke, vmul(how->ambient, m.kd));
    for (int i = 0; i < how->n; i++) {
        light_sample at;
        printed_payload unused = {{0, 0, 0}, p->left - 1};
        light_reaches(&how->lights[i], s.p, s.n, s.ns, &at);
        if (unused.left > 0)  /* trace(shadow ray to L); */
            trace(t, RAY_SHADOW, shade_shadow_ray(how, s, &how->lights[i]), &unused);
        p->colour = vadd(p->colour, blinn_phong(&m, s.ns, at.l, vneg(vunit(r.d)), at.E));
    }
}

static inline void printed_miss(tracer *t, ray r, void *payload)
{
    (void)r;
    ((printed_payload *)payload)->colour = ((const shading *)t->user)->background;
}

static const ray_program printed_programs[ray_kinds] = {
    [RAY_CAMERA] = {MASK_SEEN, false, NULL, printed_closest_hit, printed_miss},
    [RAY_SHADOW] = {MASK_SHADOW, false, NULL, printed_closest_hit, printed_miss},
};

static inline vec3 printed_ray(tracer *t, ray r, int depth)
{
    printed_payload p = {{0, 0, 0}, depth};
    trace(t, RAY_CAMERA, r, &p);
    return p.colour;
}

#endif
