/* first.h: trace() finds what a ray sees, shade() its colour; a shadow ray asks for the light.
 * Wrong at other scales: what lies within eps, 1e-4 of the way, casts no shadow, and from 1e12 on
 * (in float from 1000) surfaces shade themselves. leave.h has none. At most 32 things, 4 lights. */
#ifndef FIRST_SHADE_H
#define FIRST_SHADE_H
#include "../03_sphere/first.h"

typedef struct {
    vec3 kd;      /* diffuse reflectance: the share of light that comes back, in all directions */
    vec3 ks;      /* of the highlight */
    real shine;   /* its exponent s (18.4): the larger, the smaller the highlight */
    vec3 mirror;  /* of the mirror image (19) */
    real ior;     /* refractive index of glass (19); 0: opaque */
    vec3 ke;      /* emitted light (24) */
    int checks;   /* squares along each side of a flat thing, every other one darker */
} first_material;

/* A ball, or, if its radius is 0, the parallelogram corner + u a + v b, u and v in [0,1]. */
typedef struct {
    sphere ball;
    vec3 corner, a, b;
    vec3 n, ua, vb;  /* n = a x b; ua . a = 1, ua . b = 0, so that ua . (p - corner) = u; vb: v */
    first_material m;
} first_thing;

typedef struct { vec3 p, intensity; } first_light;  /* a point, and its I (辐射强度) */

enum { first_most_things = 32, first_most_lights = 4 };
typedef struct {
    first_thing thing[first_most_things];
    first_light light[first_most_lights];
    int things, lights;
    vec3 ambient, above, below;  /* light from everywhere; the sky overhead, and underfoot */
    real eps;   /* of shadow rays a part of the way to the light (1.5); of others a distance */
} first_scene;

static inline void first_add(first_scene *s, first_thing t)
{
    if (s->things < first_most_things) s->thing[s->things++] = t;
}

static inline void first_add_ball(first_scene *s, vec3 c, real R, first_material m)
{
    first_add(s, (first_thing){.ball = {c, R}, .m = m});
}

static inline void first_add_flat(first_scene *s, vec3 corner, vec3 a, vec3 b, first_material m)
{
    vec3 n = vcross(a, b);
    real nn = vdot(n, n);
    vec3 ua = vscale(vcross(b, n), 1 / nn), vb = vscale(vcross(n, a), 1 / nn);
    first_add(s, (first_thing){{{0, 0, 0}, 0}, corner, a, b, n, ua, vb, m});
}

static inline bool first_thing_hit(const first_thing *x, ray r, hit *out)
{
    if (x->ball.r != 0) return first_sphere_hit(x->ball, r, out);

    /* The plane through corner, at right angles to n: t = (corner - o) . n / (d . n)      (4.4) */
    real t = vdot(vsub(x->corner, r.o), x->n) / vdot(r.d, x->n);
    if (!(t >= r.tmin && t <= r.tmax)) return false;
    vec3 q = vsub(ray_at(r, t), x->corner);
    real u = vdot(x->ua, q), v = vdot(x->vb, q);
    if (!(u >= 0 && u <= 1 && v >= 0 && v <= 1)) return false;
    *out = (hit){t, u, v, 0};
    return true;
}

/* trace(), first half: the closest of all hits.                                           (7.1) */
static inline bool first_scene_hit(const first_scene *s, ray r, hit *out)
{
    hit h, best = {0, 0, 0, first_most_things};
    for (int i = 0; i < s->things; i++)
        if (first_thing_hit(&s->thing[i], r, &h)) {
            best = h;
            best.shape = (uint32_t)i;
            r.tmax = h.t;
        }
    if (best.shape == first_most_things) return false;
    *out = best;
    return true;
}

/* Of a shadow ray (阴影光线) nobody wants to know what it hits first. */
static inline bool first_occluded(const first_scene *s, ray r)
{
    hit h;
    for (int i = 0; i < s->things; i++)
        if (first_thing_hit(&s->thing[i], r, &h)) return true;
    return false;
}

typedef struct {
    vec3 p, n, v;             /* point; unit normal, on the viewer's side; unit, to the viewer */
    bool inside;              /* the viewer is in the ball, or on the back of the flat thing */
    const first_material *m;
    vec3 kd;                  /* of this point */
} first_point;

static inline first_point first_point_at(const first_scene *s, ray r, hit h)
{
    const first_thing *x = &s->thing[h.shape];
    first_point at = {.p = ray_at(r, h.t), .v = vneg(vunit(r.d)), .m = &x->m, .kd = x->m.kd};
    at.n = x->ball.r != 0 ? first_sphere_normal(x->ball, at.p) : vunit(x->n);
    at.inside = vdot(at.n, at.v) < 0;
    if (at.inside) at.n = vneg(at.n);
    if (((int)(h.u * x->m.checks) + (int)(h.v * x->m.checks)) % 2) at.kd = vscale(at.kd, 0.15);
    return at;
}

/* What leaves the point for the viewer, if E arrives from the unit direction l. (22 and 23 say what
 * the two measure, and where pi comes from.) */
static inline vec3 first_reflected(first_point x, vec3 l, vec3 E)
{
    vec3 h = vunit(vadd(l, x.v));
    vec3 diffuse = vscale(x.kd, 1 / pi);                              /* kd / pi E         (18.3) */
    real lobe = pow(real_max(vdot(x.n, h), 0), x.m->shine);
    vec3 gloss = vscale(x.m->ks, lobe);                               /* ks (n.h)^s E      (18.4) */
    return vmul(vadd(diffuse, gloss), E);
}

/* shade(): emission, ambient light, and what each light adds that is not in shadow.      (18.8) */
static inline vec3 first_shade(const first_scene *s, first_point x)
{
    vec3 L = vadd(x.m->ke, vmul(x.kd, s->ambient));
    for (int i = 0; i < s->lights; i++) {
        /* d = q - p, so that t = 1 is the light; [eps, 1 - eps] leaves out both ends.      (1.5) */
        vec3 d = vsub(s->light[i].p, x.p), l = vunit(d);
        real cosine = vdot(x.n, l);
        if (cosine <= 0 || first_occluded(s, (ray){x.p, s->eps, d, 1 - s->eps})) continue;
        vec3 E = vscale(s->light[i].intensity, cosine / vdot(d, d));      /* I cos / r^2   (18.1) */
        L = vadd(L, first_reflected(x, l, E));
    }
    return L;
}

static inline vec3 first_background(const first_scene *s, vec3 d)
{
    real up = (1 + vunit(d).y) / 2;
    return vadd(vscale(s->above, up), vscale(s->below, 1 - up));
}

/* trace() */
static inline vec3 first_trace(const first_scene *s, ray r)
{
    hit h;
    if (!first_scene_hit(s, r, &h)) return first_background(s, r.d);
    return first_shade(s, first_point_at(s, r, h));
}
#endif
