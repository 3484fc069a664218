/* 19_first_world.h: a scene of 19's first.h as whitted.h has it: what the first version is held
 * against.
 *
 *   first_world *x = first_world_new(&s, depth);      s must outlive it; first_world_free(x)
 *   vec3 L = first_world_ray(x, r)                    what first_whitted(&s, r, depth) should say
 *
 * Each glass ball is a body of its own, around everything is air; shadow rays end at glass, too.
 */
#ifndef FIRST_WORLD_19_H
#define FIRST_WORLD_19_H

#include "../chapters/19_whitted/first.h"
#include "../chapters/19_whitted/scenes/whitted_stage.h"

typedef struct { whitted_stage on; const first_scene *s; } first_world;

/* ---------------------------------------------------------------------------------------------- */

/* Of a board, the square that s->p lies in. */
static inline const whitted_look *first_world_look(const void *context, const trace_hit *x,
                                                   const surface *s, whitted_look *room)
{
    const first_world *w = context;
    const first_thing *t = &w->s->thing[x->h.shape];
    vec3 q = vsub(s->p, t->corner);
    real n = (real)t->m.checks;
    int odd = (int)(vdot(t->ua, q) * n) + (int)(vdot(t->vb, q) * n);
    *room = w->on.look[x->h.shape];
    if (odd % 2) room->base.kd = vscale(room->base.kd, 0.15);
    return room;
}

static inline vec3 first_world_sky(const void *context, vec3 d)
{
    return first_background(((const first_world *)context)->s, d);
}

static inline void first_world_add(whitted_stage *on, const first_thing *t)
{
    const first_material *m = &t->m;
    whitted_look look = {.base = {.kd = m->kd, .ks = m->ks, .shine = m->shine, .ke = m->ke,
                                  .mirror = m->mirror}};
    vec3 *q = on->corner + 4 * on->n, far = vadd(vadd(t->corner, t->a), t->b);
    if (m->ior != 0) {
        look.body = (uint32_t)on->n + 1;
        look.base.mirror = look.base.through = (vec3){1, 1, 1};
        on->media[look.body].ior = m->ior;
    }
    q[0] = t->corner, q[1] = vadd(t->corner, t->a), q[2] = far, q[3] = vadd(t->corner, t->b);
    stage_add(on, t->ball.r != 0 ? shape_of_sphere(t->ball) : shape_of_polygon(polygon_of(q, 4)),
              look);
}

static inline first_world *first_world_new(const first_scene *s, int depth)
{
    first_world *x = allocate(1, sizeof *x);
    x->s = s;
    for (int i = 0; i < s->things; i++) first_world_add(&x->on, &s->thing[i]);
    for (int i = 0; i < s->lights; i++)
        x->on.light[i] = (light){LIGHT_POINT, s->light[i].p, s->light[i].intensity};
    x->on.w = (whitted){.n = s->lights, .material_of = first_world_look, .context = x,
                        .sky = first_world_sky, .ambient = s->ambient};
    stage_begin(&x->on, depth);
    return x;
}

static inline vec3 first_world_ray(const first_world *x, ray r)
{
    tracer t = stage_tracer(&x->on);
    return whitted_ray(&t, r, (media_set){0});
}

static inline void first_world_free(first_world *x)
{
    stage_end(&x->on);
    free(x);
}

#endif
