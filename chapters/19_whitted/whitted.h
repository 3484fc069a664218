/* whitted.h: Whitted's ray tracing: trace and shade of 18, and shade traces on.
 *
 *   depth 1            eye ray                     What a ray brings back:
 *            \                                       L = shade (18.8) + M L(reflected)
 *   depth 2   o--- shadow rays                                 opaque: M, at every angle
 *            / \                                     L = e^(-sigma s) (shade + R M L(reflected)
 *   depth 3 o   o   reflected, refracted                 + (1 - R) kt (n1/n2)^2 L(refracted))
 *          / \   \                               glass  (19.10); R: refract.h; sigma, s: media.h
 *
 * Ray depth (光线深度) as the notes count it: the eye ray has depth 1, what it gives rise to 2, ...
 * Shadow rays have none. The recursion ends at a depth, or where a branch can no longer contribute:
 * each carries its weight, the product of the factors of (19.10) above it.
 *
 *   whitted w = {.lights = L, .n = 2, .material_of = f, .context = c, .media = m, .depth = 8};
 *   tracer t = {.w = &world, .program = whitted_programs, .user = &w};
 *   vec3 colour = whitted_ray(&t, r, in)      in: the bodies that the ray's origin is in
 *   t.counts.rays[RAY_REFLECTION] ..          what it took, by kind; RAY_SIGHT: contact.h
 *
 *   depth     at most so many rays behind one another [1..256]; what lies deeper is black
 *   least     a branch whose weight is nowhere more than this is cut [>= 0]: 0 cuts only those that
 *             are exactly 0
 *   apart     true: no glass touches or overlaps anything: then no contact rays are needed
 *   spend_all traces what cannot contribute, too: the same picture, to the last bit
 *
 * Only what is called for: no reflection ray from a black mirror or below least, no refraction ray
 * into what is opaque or in total reflection, no shadow ray to a light behind the surface (18).
 *
 * Sources: T. Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980; R.
 * Hall, D. Greenberg, "A Testbed for Realistic Image Synthesis", IEEE CG&A 3(8), 1983 (adaptive
 * depth); T. Akenine-Möller et al., "Real-Time Rendering", 4th ed., 2018, section 26.1.
 */
#ifndef WHITTED_H
#define WHITTED_H

#include "refract.h"
#include "whitted_place.h"

/* ---------------------------------------------------------------------------------------------- */

/* A branch counts if some colour of its weight is more than w->least; its share is known. */
static inline bool whitted_counts(const whitted *w, const whitted_branch *b,
                                  const whitted_place *p, whitted_branch *child)
{
    child->weight = vmul(vmul(b->weight, p->left), child->share);
    vec3 weight = child->weight;
    if (weight.x > w->least || weight.y > w->least || weight.z > w->least) return true;
    return w->spend_all && vzero(weight);
}

/* It goes on along d, on the side of `side`, whatever rounding makes of n.d. */
static inline void whitted_go_on(const whitted_branch *b, const whitted_place *p, ray_kind kind,
                                 vec3 d, vec3 side, whitted_branch *child)
{
    child->r.o = leave_side(&p->s, side, p->more), child->r.d = lifted(d, side);
    child->r.tmin = 0, child->r.tmax = real_infinity;
    child->in = b->in, child->depth = b->depth + 1, child->kind = kind, child->number = b->number;
    child->left = kind == RAY_REFLECTION ? p->face : world_no_face;
}

/* What is traced on: 0 to 2 branches, the reflected one last. */
static inline int whitted_children(const whitted *w, const whitted_branch *b,
                                   const whitted_place *p, whitted_branch child[2])
{
    const material *m = &p->m->base;
    vec3 d = b->r.d, up = p->s.n, down = vneg(up), M = m->mirror;
    int n = 0;
    if (b->depth >= w->depth || b->depth >= whitted_most_depth) return 0;
    if (p->m->body) {                                            /* glass: Fresnel shares it out */
        snell x;
        bool bends = snell_of(d, p->s.ns, w->media[p->inside].ior, w->media[p->beyond].ior, &x);
        real R = fresnel(&x);
        M = vscale(M, R), child->share = vscale(m->through, 1 - R);
        if (bends && whitted_counts(w, b, p, child)) {
            whitted_go_on(b, p, RAY_REFRACTION, snell_refract(&x, d, p->s.ns), down, child);
            child[n++].in = p->after;
        }
    } else if (w->spend_all) {
        child->share = (vec3){0, 0, 0};
        if (whitted_counts(w, b, p, child))
            whitted_go_on(b, p, RAY_REFRACTION, d, down, &child[n++]);
    }
    child[n].share = M;
    if (whitted_counts(w, b, p, &child[n]))
        whitted_go_on(b, p, RAY_REFLECTION, reflect(d, p->s.ns), up, &child[n++]);
    return n;
}

/* What comes back along b, as L / n^2 (19.11). */
static inline vec3 whitted_trace(tracer *t, whitted_branch *b)
{
    whitted_branch child[2];
    whitted_place p;
    if (!whitted_find(t, b, &p)) return vmul(p.left, whitted_sky(t->user, b));
    vec3 L = whitted_shade(t, b, &p);
    int n = whitted_children(t->user, b, &p, child);
    for (int k = 0; k < n; k++) L = vadd(L, vmul(child[k].share, whitted_trace(t, &child[k])));
    return vmul(p.left, L);                                                            /* (19.10) */
}

static inline whitted_branch whitted_eye(ray r, media_set in)
{
    return (whitted_branch){ray_unit(r), {1, 1, 1}, {1, 1, 1}, in, 1, RAY_CAMERA, world_no_face,
                            -1};
}

static inline vec3 whitted_ray(tracer *t, ray r, media_set in)
{
    whitted_branch eye = whitted_eye(r, in);
    vec3 L = whitted_trace(t, &eye);
    return vscale(L, whitted_square(t->user, &eye.in));
}

#endif
