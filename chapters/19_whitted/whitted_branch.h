/* whitted_branch.h: one branch of the tree of rays, and what springs from where it ends.
 *
 *   whitted_branch b                          a ray, what it is worth, which bodies it is in
 *   n = whitted_opaque(w, &b, &s, m, child)   0 or 1: the mirror's, if it counts
 *   n = whitted_glass(w, &b, &s, m, n1, n2, &after, more, child)      0 to 2: Fresnel's two
 *   vec3 c = whitted_nothing(w, &b)           what it brings from where nothing is
 *
 * A child counts if some colour of its weight is more than w->least. spend_all makes those of
 * weight exactly 0, too.
 */
#ifndef WHITTED_BRANCH_H
#define WHITTED_BRANCH_H

#include "absorb.h"
#include "fresnel.h"
#include "whitted_scene.h"

/* How rays are searched for. closest: of a ray of this kind, which began at shape `from` (no_shape:
 * at the eye). lit: part of light k that arrives along a shadow ray. */
typedef struct {
    bool (*closest)(tracer *t, ray_kind kind, ray r, uint32_t from, trace_hit *x);
    real (*lit)(tracer *t, ray r, uint32_t from, int k);
    void (*surface_of)(const tracer *t, const ray *r, const trace_hit *x, surface *s);
} whitted_search;

typedef struct {
    ray r;              /* d is unit */
    vec3 weight;
    media_set in;
    int depth;
    ray_kind kind;
    uint32_t from;      /* shape on which it began */
    int number;         /* of this ray, for the log */
} whitted_branch;

/* Is told of each ray: ray_tree.h. `t`: of its hit, infinity if none; a shadow ray: of its end, and
 * `lit` of the light arrives. `parent`: number of the ray before it. */
typedef struct whitted_log whitted_log;
struct whitted_log {
    int (*add)(whitted_log *log, ray_kind kind, int parent, int depth, ray r, real t, vec3 weight,
               real lit);
};

/* ---------------------------------------------------------------------------------------------- */

static inline bool whitted_counts(const whitted *w, vec3 weight)
{
    return weight.x > w->least || weight.y > w->least || weight.z > w->least;
}

/* What is seen where nothing is hit. Through an endless medium: what it does not absorb. */
static inline vec3 whitted_nothing(const whitted *w, const whitted_branch *b)
{
    vec3 sky = w->sky ? w->sky(w->context, b->r.d) : w->background;
    if (b->in.n == 0 && vzero(w->media[0].absorb)) return vmul(b->weight, sky);
    vec3 left = absorbed(w->media[media_fills(w->media, &b->in)].absorb, real_infinity);
    return vmul(b->weight, vmul(left, sky));
}

/* A ray that goes on from s, on the side of `side`, whatever rounding makes of n.d. Field by field:
 * a copy of the whole struct would wait for what was just written to it. */
__attribute__((always_inline))
static inline void whitted_child(const whitted_branch *b, const surface *s, ray_kind kind,
                                 vec3 side, vec3 d, vec3 weight, real more, whitted_branch *c)
{
    c->r.o = leave_point(*s, side, more), c->r.tmin = 0, c->r.d = d, c->r.tmax = real_infinity;
    c->weight = weight, c->in = b->in;
    c->depth = b->depth + 1, c->kind = kind, c->from = s->shape, c->number = b->number;
}

static inline bool whitted_follows(const whitted *w, vec3 weight)
{
    return whitted_counts(w, weight) || (w->spend_all && vzero(weight));
}

/* Children of an opaque surface: a reflection, if it counts. spend_all: a refraction, too, straight
 * on, of weight 0. */
__attribute__((always_inline))
static inline int whitted_opaque(const whitted *w, const whitted_branch *b, const surface *s,
                                 const whitted_material *m, whitted_branch child[2])
{
    int n = 0;
    vec3 weight = vmul(b->weight, m->mirror);
    if (w->spend_all)
        whitted_child(b, s, RAY_REFRACTION, vneg(s->n), b->r.d, (vec3){0, 0, 0}, 0, &child[n++]);
    if (whitted_follows(w, weight))
        whitted_child(b, s, RAY_REFLECTION, s->n, reflect(b->r.d, s->ns), weight, 0, &child[n++]);
    return n;
}

/* Children at an interface from medium n1 to n2. The normals of s face the ray; `after`: where
 * what is refracted will be. more: contact.h. */
__attribute__((always_inline))
static inline int whitted_glass(const whitted *w, const whitted_branch *b, const surface *s,
                                const whitted_material *m, real n1, real n2, const media_set *after,
                                real more, whitted_branch child[2])
{
    snell x;
    int n = 0;
    bool bends = snell_of(b->r.d, s->ns, n1, n2, &x);
    real R = w->fresnel == WHITTED_EXACT ? fresnel(&x) : schlick(&x);
    vec3 back = vmul(b->weight, vscale(m->mirror, R));
    vec3 on = vmul(b->weight, vscale(m->through, 1 - R));
    if (whitted_follows(w, back))
        whitted_child(b, s, RAY_REFLECTION, s->n, reflect(b->r.d, s->ns), back, more, &child[n++]);
    if (bends && whitted_follows(w, on)) {
        vec3 d = snell_refract(&x, b->r.d, s->ns);
        whitted_child(b, s, RAY_REFRACTION, vneg(s->n), d, on, more, &child[n]);
        child[n++].in = *after;
    }
    return n;
}

#endif
