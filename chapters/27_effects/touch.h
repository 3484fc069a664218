/* touch.h: what else lies where a ray has met glass: contact.h of 19, for all that a studio holds.
 *
 *   touch_near *near = touch_near_of(&s, look, &all)   where things of glass have neighbours; free
 *                                                   all: the box of all glass
 *   touch_at(&t, look, near, always, r, x, &s, &c)  x, s: the face that r has met, s not turned to
 *                                                   the ray; unless `always` it is one of glass
 *     c.faces     all faces of glass at that place, to be crossed as one (19: media.h)
 *     c.opaque    what else is there, on surface c.on
 *     c.more      how much farther away than by leave.h (18) rays must begin
 *     c.asked     it was looked for
 *     c.full      more bodies are there than a crossing holds
 *
 *      air    |  glass  | water     Where glass and water touch, both walls are one place: taken
 *     --->----|---->----|---->      one by one, the first hides the second. [p - reach n,
 *     ________|_________|_____      p + reach n] is searched for others: a contact ray. Glass on a
 *              table                table shows the table.
 *
 * Only what is called for: a hit asks where the box of its thing (a shape, a placed mesh) meets
 * that of another: a ball on a floor at its foot, a ball for itself nowhere. `always` asks at each
 * hit, and must find nothing else. A face of the same body counts only if it lies in the same plane
 * and leads the other way (two cubes of one glass, side by side); else it is beyond an edge. Sheets
 * (illum 4, 9) are passed over. Cost: about half of a reflection ray; at first O(glass x things).
 */
#ifndef EFFECTS_TOUCH_H
#define EFFECTS_TOUCH_H

#include "../19_whitted/media.h"
#include "appearance.h"
#include "studio_tree.h"

typedef struct { aabb box; real reach; } touch_near;  /* of shapes, places, solids, in a row */
typedef struct {
    media_crossing faces;
    studio_hit opaque;        /* h.shape no_shape: none */
    surface on;
    real more;                /* 0: nothing else is there */
    bool asked, full;
} touch;

typedef struct {
    const studio_tree *t;
    const appearance *look;
    studio_hit of;            /* the face that we know of, */
    uint32_t material;
    vec3 n, d;                /* and the ray that met it */
    ray across;
    real reach;
    touch *out;
} touch_asking;

typedef struct {
    const shape *shape;       /* NULL: a mesh, or a solid, which is opaque */
    uint32_t material;        /* of the shape */
    aabb box;
    real pad;                 /* by which the box was grown */
    bool glass, mixed;        /* a part of it is glass; it is of several materials */
} touch_thing;

/* Boxes are grown by more than any two faces are off, those of moved meshes included (16.3). */
enum { touch_pad = 4096, touch_reach = 32, touch_most_pairs = 1 << 27 };  /* the first two: eps */

/* ---------------------------------------------------------------------------------------------- */

static inline real touch_size(aabb b)
{
    real size = vlargest(vmax(vabs(b.lo), vabs(b.hi)));
    return size < real_infinity ? size : 0;
}

/* A part of a placed mesh is of glass, if its own material is or one that a run of it has. */
static inline void touch_mesh(const studio *s, const appearance *look, uint32_t place,
                              touch_thing *x)
{
    const mesh *m = &s->mesh[s->placed[place].mesh];
    x->mixed = m->runs > 1 || (m->runs && m->run[0].first);
    x->glass = appearance_body(&look[s->placing[place].material]);
    for (size_t k = 0; k < m->runs; k++)
        x->glass |= appearance_body(&look[studio_material_of(s, place, m->run[k].first)]);
}

static inline touch_thing *touch_things(const studio *s, const appearance *look)
{
    touch_thing *list = allocate(studio_things(s), sizeof *list);
    aabb *box = studio_boxes(s);
    for (uint32_t i = 0; i < studio_things(s); i++) {
        touch_thing *x = &list[i];
        x->pad = touch_pad * real_epsilon * touch_size(box[i]);
        vec3 by = {x->pad, x->pad, x->pad};
        x->box = (aabb){vsub(box[i].lo, by), vadd(box[i].hi, by)};
        if (i < s->shapes) {
            x->shape = &s->shape[i], x->material = s->shape_material[i];
            x->glass = appearance_body(&look[x->material]);
        } else if (i - s->shapes < s->places) touch_mesh(s, look, i - (uint32_t)s->shapes, x);
    }
    free(box);
    return list;
}

/* Two faces of one body in one plane, or at an edge? |n.m| of planes is 1 or, here, far from it. */
static inline bool touch_parallel(vec3 n, vec3 m) { return fabs(vdot(n, m)) > (real)0.99; }

/* Boxes meet, but surfaces do not: of two balls, or of a ball and a plane that it does not reach.
 * Or only at an edge: planes of one body. */
static inline bool touch_apart(const touch_thing *x, const touch_thing *y)
{
    const shape *a = x->shape, *b = y->shape;
    if (!a || !b) return false;
    if (a->kind == SHAPE_POLYGON && b->kind == SHAPE_SPHERE) return touch_apart(y, x);
    real pad = x->pad + y->pad, r = fabs(a->sphere.r), R = fabs(b->sphere.r);
    if (a->kind == SHAPE_SPHERE && b->kind == SHAPE_POLYGON) {
        const polygon *g = &b->polygon;
        return polygon_is_flat(g) && fabs(vdot(g->normal, vsub(a->sphere.c, g->centre))) > r + pad;
    }
    if (a->kind != b->kind) return false;
    if (a->kind == SHAPE_POLYGON)
        return x->material == y->material && !touch_parallel(a->polygon.normal, b->polygon.normal);
    if (a->kind != SHAPE_SPHERE) return false;
    real far = vlength(vsub(a->sphere.c, b->sphere.c));
    return far > r + R + pad || far + pad < fabs(r - R);
}

/* NULL: there is no glass. */
static inline touch_near *touch_near_of(const studio *s, const appearance *look, aabb *box)
{
    size_t n = studio_things(s), glass = 0;
    touch_thing *x = touch_things(s, look);
    *box = aabb_empty();
    for (size_t i = 0; i < n; i++)
        if (x[i].glass) glass++, *box = aabb_union(*box, x[i].box);
    touch_near *near = glass ? allocate(n, sizeof *near) : NULL;
    bool all = n && glass > touch_most_pairs / n;  /* too many: as if all had neighbours */
    for (size_t i = 0; i < n && near; i++) {
        near[i].box = x[i].glass && (all || x[i].mixed) ? x[i].box : aabb_empty();
        for (size_t j = 0; j < n && x[i].glass && !all; j++) {
            aabb both = aabb_overlap(x[i].box, x[j].box);
            if (j == i || aabb_is_empty(both) || touch_apart(&x[i], &x[j])) continue;
            near[i].box = aabb_union(near[i].box, both);
            near[i].reach = real_max(near[i].reach,
                                     touch_reach * real_epsilon * touch_size(x[j].box));
        }
    }
    free(x);
    return near;
}

/* ---- the contact ray ---- */

static inline void touch_note(const touch_asking *q, studio_hit x)
{
    touch *out = q->out;
    if (x.place == q->of.place && x.h.shape == q->of.h.shape) return;
    uint32_t m = studio_hit_material(q->t, x);
    const appearance *a = &q->look[m];
    surface s = studio_surface(q->t, q->across, x);
    if (appearance_body(a)) {
        bool inwards = vdot(s.n, q->d) < 0;
        if (m == q->material && (inwards == (vdot(q->n, q->d) < 0)
                                 || !touch_parallel(s.n, q->n))) return;
        out->full |= !media_crossing_add(&out->faces, m + 1, inwards ? 1 : -1);
    } else if (!vzero(a->m.through)) return;
    else if (out->opaque.h.shape == no_shape || hit_before(x.h, out->opaque.h))
        out->opaque = x, out->on = s;
    out->more = q->reach;
}

static inline any_hit_answer touch_any(const tracer *t, ray r, trace_hit x, void *payload)
{
    const touch_asking *q = payload;
    (void)t, (void)r;
    touch_note(q, x.part == q->t->s->places ? studio_tree_carved(q->t, q->across, x.h)
                                            : (studio_hit){x.h, x.part});
    return ANY_HIT_IGNORE;
}

typedef struct { instances_context moved; const touch_asking *q; } touch_moved;

static inline bool touch_leaf(const void *context, uint32_t first, uint32_t count, query *q,
                              bool any)
{
    const touch_moved *c = context;
    const studio_tree *t = c->q->t;
    (void)any;
    for (const placed *p = t->moved.place + first, *end = p + count; p < end; p++) {
        ray r;
        hit h;
        if (p->index != c->q->of.place && instance_ray(&p->to_object, q->r, &r)
            && bvh8_hit(&t->moved.lower[p->mesh], r, &h))
            touch_note(c->q, (studio_hit){h, p->index});
    }
    return false;
}

static inline void touch_search(touch_asking *q)
{
    const studio_tree *t = q->t;
    const ray_program program = {.any_hit = touch_any};
    trace_asking a = {.program = &program, .r = q->across, .payload = q,
                      .q = query_of(q->across)};
    hit h;
    for (const world_part *p = t->world.part, *end = p + t->world.parts; p < end; p++)
        a.part = p->id, trace_ask(&a, &p->tree);
    for (size_t k = t->s->boxed; k < t->s->solids; k++)
        if (csg_hit(&t->s->solid[k].c, q->across, &h))
            touch_note(q, (studio_hit){h, no_shape - 1 - (uint32_t)k});
    const touch_moved c = {{.x = &t->moved}, q};
    if (t->moved.n)
        tree_search(&t->moved.tree, q->across, instances_box_ray, touch_leaf, &c, false, &h, NULL);
}

/* A call, as bodies_cross: it is for few hits. */
__attribute__((noinline))
static void touch_at(const studio_tree *t, const appearance *look, const touch_near *near,
                     bool always, ray r, studio_hit x, const surface *s, touch *out)
{
    const studio *of = t->s;
    const touch_near *at = x.place == no_shape ? &near[x.h.shape]
        : &near[of->shapes + (studio_hit_solid(t, x) ? of->places + no_shape - 1 - x.place
                                                     : x.place)];
    uint32_t m = studio_hit_material(t, x);
    out->faces.n = 0, out->opaque.h.shape = no_shape, out->more = 0, out->full = false;
    out->asked = always || aabb_contains(at->box, s->p);
    if (appearance_body(&look[m]))
        media_crossing_add(&out->faces, m + 1, vdot(s->n, r.d) < 0 ? 1 : -1);
    if (!out->asked) return;
    touch_asking q = {t, look, x, m, s->n, r.d, {.tmin = 0},
                      2 * (s->error + s->noise) + at->reach, out};
    vec3 n = vdot(s->n, r.d) < 0 ? vneg(s->n) : s->n;  /* onwards */
    q.across = (ray){vmadd(s->p, n, -q.reach), 0, n, 2 * q.reach};
    touch_search(&q);
}

#endif
