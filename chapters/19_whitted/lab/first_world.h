/* first_world.h: a scene of first.h as whitted.h has it: what the first version is held against.
 *
 *   first_world *x = first_world_new(&s, depth);      s must outlive it; first_world_free(x)
 *   vec3 L = first_world_ray(x, r)                    what first_whitted(&s, r, depth) should say
 *
 * Each glass ball is a body of its own, around everything is air; shadow rays end at glass, too.
 */
#ifndef WHITTED_LAB_FIRST_WORLD_H
#define WHITTED_LAB_FIRST_WORLD_H

#include "../first.h"
#include "../whitted.h"

typedef struct {
    whitted w;
    const first_scene *s;
    shape shape[first_most_things];
    whitted_material look[first_most_things];
    vec3 corner[4 * first_most_things];
    medium media[first_most_things + 1];
    light light[first_most_lights];
    scene scene;
    world_part part;
    trace_world world;
} first_world;

/* ---------------------------------------------------------------------------------------------- */

/* Of a board, the square that s->p lies in. */
static inline const whitted_material *first_world_look(const void *context, trace_hit x,
                                                       const surface *s, whitted_material *room)
{
    const first_world *w = context;
    const first_thing *t = &w->s->thing[x.h.shape];
    vec3 q = vsub(s->p, t->corner);
    real n = (real)t->m.checks;
    int odd = (int)(vdot(t->ua, q) * n) + (int)(vdot(t->vb, q) * n);
    if (odd % 2 == 0) return &w->look[x.h.shape];
    *room = w->look[x.h.shape];
    room->base.kd = vscale(room->base.kd, 0.15);
    return room;
}

static inline vec3 first_world_sky(const void *context, vec3 d)
{
    return first_background(((const first_world *)context)->s, d);
}

static inline void first_world_add(first_world *x, int i)
{
    const first_thing *t = &x->s->thing[i];
    const first_material *m = &t->m;
    vec3 *q = x->corner + 4 * i, far = vadd(vadd(t->corner, t->a), t->b);
    q[0] = t->corner, q[1] = vadd(t->corner, t->a), q[2] = far, q[3] = vadd(t->corner, t->b);
    x->shape[i] = t->ball.r != 0 ? shape_of_sphere(t->ball) : shape_of_polygon(polygon_of(q, 4));
    x->look[i] = (whitted_material){{m->kd, m->ks, m->shine, m->ke}, m->mirror, {0, 0, 0}, 0, 0};
    x->media[i + 1] = (medium){m->ior, {0, 0, 0}, 0};
    if (m->ior == 0) return;
    x->look[i].body = (uint32_t)i + 1;
    x->look[i].mirror = x->look[i].through = (vec3){1, 1, 1};
}

static inline first_world *first_world_new(const first_scene *s, int depth)
{
    first_world *x = allocate(1, sizeof *x);
    *x = (first_world){.s = s};
    x->media[0].ior = 1;
    for (int i = 0; i < s->things; i++) first_world_add(x, i);
    for (int i = 0; i < s->lights; i++)
        x->light[i] = (light){LIGHT_POINT, s->light[i].p, s->light[i].I};
    x->scene = (scene){x->shape, (size_t)s->things};
    world_part_of_scene(&x->scene, MASK_ALL, &x->part);
    x->world = (trace_world){&x->part, 1};
    x->w = (whitted){.lights = x->light, .n = s->lights, .material_of = first_world_look,
                     .context = x, .media = x->media, .sky = first_world_sky, .depth = depth,
                     .ambient = s->ambient};
    return x;
}

static inline vec3 first_world_ray(const first_world *x, ray r)
{
    tracer t = {.w = &x->world, .program = whitted_programs, .user = &x->w};
    return whitted_ray(&t, r, (media_set){0});
}

static inline void first_world_free(first_world *x)
{
    world_part_free(&x->part);
    free(x);
}

#endif
