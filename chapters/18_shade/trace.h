/* trace.h: trace() finds what a ray meets; what happens then is the user's.
 *
 *   trace(&t, kind, r, &payload)
 *      |  r: origin, tmin, direction, tmax: a RayDesc (01)         program[kind]:
 *      |                                                            mask       which parts it sees
 *      +-- each candidate closer than the best so far -> any_hit    accept, ignore, or end
 *      +-- the closest one                            -> closest_hit
 *      +-- nothing                                    -> miss
 *
 * A kind of ray (光线类型) is a row of such programs, as in DXR, OptiX and Vulkan: a camera ray wants
 * the closest hit and its colour, a shadow ray (`first`) only whether there is one, and ends at the
 * first. The payload (有效载荷) is the user's struct: trace hands its address from program to program
 * and never looks into it. closest_hit and miss may trace further rays: that is all recursion there
 * is, and it ends where they end it; depth is for their payload to count.
 *
 *   kind              usual interval                          what it asks
 *   RAY_CAMERA        [0, inf]                                closest
 *   RAY_SHADOW        [0, 1], D = light - O; [0, inf]: sun    any
 *   RAY_REFLECTION    [0, inf] from leave(s, w)               closest
 *   RAY_REFRACTION    [0, inf] from leave(s, w)               closest
 *   RAY_SIGHT         [0, 1] from leave_between(a, b)         any: can the two see each other?
 *
 *   tracer t = {&world, programs, user}; world.h; one a thread: it counts the rays of each kind
 *   part.opaque = true;                  of the world: no any_hit is asked, all that is met counts
 *   bool met = trace(&t, RAY_SHADOW, r, &payload);      is anything met that was not ignored?
 *   bool met = trace_find(&t, kind, but, &r, &payload, &x);   the same, and its hit in x, where r
 *                                 ends then (neither if the kind asks for the first); closest_hit
 *                                 and miss aren't called. But: world.h; any_hit may be asked of it
 *   bool back = trace_may_return(&t, &x, &s);   may what leaves (18.10) hit x, to the side of s.n,
 *                                 meet it again? Not what is flat, nor a ball, from outside
 *
 * Equal t, a NaN: as world.h has it. any_hit is called in no particular order, perhaps twice for
 * one hit, only for candidates that would be the best; NULL accepts all, which is faster. NULL for
 * closest_hit and miss: nothing is done.
 *
 * Sources: T. Akenine-Möller et al., "Real-Time Rendering", 4th ed., 2018, section 26.1; Microsoft,
 * DirectX Raytracing functional specification (TraceRay, ray flags, instance masks); S. Parker et
 * al., "OptiX: A General Purpose Ray Tracing Engine", SIGGRAPH 2010.
 */
#ifndef SHADE_TRACE_H
#define SHADE_TRACE_H

#include "surface.h"
#include "world.h"

typedef enum {
    RAY_CAMERA, RAY_SHADOW, RAY_REFLECTION, RAY_REFRACTION, RAY_SIGHT, ray_kinds
} ray_kind;
typedef enum { ANY_HIT_ACCEPT, ANY_HIT_IGNORE, ANY_HIT_END } any_hit_answer;

typedef struct tracer tracer;
typedef struct {
    uint8_t mask;
    bool first;          /* any hit will do: no closest_hit is called */
    any_hit_answer (*any_hit)(const tracer *t, ray r, trace_hit x, void *payload);
    void (*closest_hit)(tracer *t, ray r, trace_hit x, void *payload);
    void (*miss)(tracer *t, ray r, void *payload);
} ray_program;

typedef struct { size_t rays[ray_kinds], hits[ray_kinds]; } trace_counts;

struct tracer {
    const trace_world *w;
    const ray_program *program;  /* [ray_kinds] */
    const void *user;            /* for the programs */
    trace_counts counts;
};

static const char *const ray_kind_names[ray_kinds] = {"camera", "shadow", "reflection",
                                                      "refraction", "sight"};

static inline bool trace(tracer *t, ray_kind kind, ray r, void *payload);
static inline bool trace_find(tracer *t, ray_kind kind, world_but but, ray *r, void *payload,
                              trace_hit *x);

/* ---------------------------------------------------------------------------------------------- */

/* What was hit, put back on its shape. Never called: ray and hit, handed over as a whole right
 * after they were written, would wait for all that is under way. */
fast_inline surface surface_of_trace(const tracer *t, ray r, trace_hit x)
{
    const world_part *p = &t->w->part[x.part];
    const items *of = &p->tree.x;
    return of->m ? surface_of_mesh(of->m, x.h)
                 : surface_of_shape(&of->s->shapes[x.h.shape], r, x.h);
}

/* All of a flat thing lies in the plane through s.p, all of a ball behind it. */
fast_inline bool trace_may_return(const tracer *t, const trace_hit *x, const surface *s)
{
    const items *of = &t->w->part[x->part].tree.x;
    const shape *on = of->m ? NULL : &of->s->shapes[x->h.shape];
    if (on && on->kind == SHAPE_SPHERE) return !(vdot(s->n, vsub(s->p, on->sphere.c)) > 0);
    return on && on->kind != SHAPE_TRIANGLE
        && !(on->kind == SHAPE_POLYGON && polygon_is_flat(&on->polygon));
}

/* For kinds with an any_hit: a walk of its own, box by box, with a question at each candidate. */
typedef struct {
    const tracer *t;
    const ray_program *program;
    uint32_t part;
    ray r;               /* as it began: what any_hit is told */
    void *payload;
    query q;             /* the rest of it, and the best hit so far */
    bool met, end;
} trace_asking;

/* `one` is the search as it would be with this item: kept if the answer says so. */
static inline void trace_ask_item(trace_asking *a, const items *x, uint32_t i)
{
    query one = a->q;
    if (i == no_shape || !query_ask(&one, x, i, false)) return;
    trace_hit candidate = {one.best, a->part};
    any_hit_answer answer = a->program->any_hit(a->t, a->r, candidate, a->payload);
    if (answer == ANY_HIT_IGNORE) return;
    a->q = one, a->met = true;
    a->end = answer == ANY_HIT_END || a->program->first;
}

/* (15.2) of one child; in float, as ray8.h pays for. */
static inline bool trace_meets_box(const bvh8_node *n, int k, const bvh8_ray *q, float limit)
{
    const float *from = &n->side[0][k];
    float enter = q->tmin, leave_at = limit;
    for (int axis = 0; axis < 3; axis++) {
        float near = from[q->near[axis] / (int)sizeof *from] * q->inverse[axis] + q->near_o[axis];
        float far = from[q->far[axis] / (int)sizeof *from] * q->inverse[axis] + q->far_o[axis];
        enter = near > enter ? near : enter, leave_at = far < leave_at ? far : leave_at;
    }
    return enter <= leave_at;
}

static inline void trace_ask(trace_asking *a, const bvh8 *w)
{
    uint32_t stack[bvh8_stack];
    int top = 0;
    bvh8_ray q;
    if (w->nodes == 0 || !bvh8_ray_of(w, &a->q.r, &bvh8_skip_none, &q)) return;
    for (stack[top++] = 0; top > 0 && !a->end; ) {
        uint32_t at = stack[--top], leaf = at & ~bvh8_leaf;
        float limit = bvh8_limit(&q, a->q.r.tmax);
        if (at & bvh8_leaf && !w->block) trace_ask_item(a, &w->x, leaf);
        else if (at & bvh8_leaf)
            for (int k = 0; k < 8 && !a->end; k++)
                trace_ask_item(a, &w->x, w->block[leaf].index[k]);
        else for (int k = 0; k < 8; k++)
            if (trace_meets_box(&w->node[at], k, &q, limit))
                stack[top++] = w->node[at].child[k];
    }
}

/* world_find for kinds with an any_hit. */
__attribute__((noinline))
static bool trace_find_asking(const tracer *t, const ray_program *g, const world_but *but, ray *r,
                              void *payload, trace_hit *x)
{
    bool met = false;
    for (uint32_t k = 0; k < t->w->parts; k++) {
        const world_part *p = &t->w->part[k];
        hit best;
        bool end = false, found;
        if (!(p->mask & g->mask)) continue;
        if (p->opaque) {
            bvh8_skip skip = world_skip(*but, p->id);
            found = bvh8_ask_at(&p->tree, r, skip, g->first ? NULL : &best, NULL);
        } else {
            trace_asking a = {t, g, k, *r, payload, query_of(*r), false, false};
            trace_ask(&a, &p->tree);
            found = a.met, end = a.end, best = a.q.best;
        }
        if (found && g->first) return true;
        if (found && !(met && best.t == r->tmax))
            met = true, *x = (trace_hit){best, k}, r->tmax = best.t;
        if (end) break;
    }
    return met;
}

fast_inline bool trace_find(tracer *t, ray_kind kind, world_but but, ray *r, void *payload,
                            trace_hit *x)
{
    const ray_program *g = &t->program[kind];
    bool met = g->any_hit ? trace_find_asking(t, g, &but, r, payload, x)
                          : world_find(t->w, g->mask, but, r, g->first ? NULL : x);
    t->counts.rays[kind]++, t->counts.hits[kind] += met;
    return met;
}

/* Its own ray is copied field by field. */
static inline bool trace(tracer *t, ray_kind kind, ray r, void *payload)
{
    ray own = {{r.o.x, r.o.y, r.o.z}, r.tmin, {r.d.x, r.d.y, r.d.z}, r.tmax};
    const ray_program *g = &t->program[kind];
    trace_hit x;
    bool met = trace_find(t, kind, world_but_none, &own, payload, &x);
    if (!met && g->miss) g->miss(t, r, payload);
    if (met && !g->first && g->closest_hit) g->closest_hit(t, r, x, payload);
    return met;
}

static inline void trace_counts_add(trace_counts *to, const trace_counts *more)
{
    for (int k = 0; k < ray_kinds; k++)
        to->rays[k] += more->rays[k], to->hits[k] += more->hits[k];
}

#endif
