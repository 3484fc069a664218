/* classic.h: a studio as chapters 18, 19 and 26 have it, to be drawn by their own code.
 *
 *   classic_build(&e, &c)           a stage as 18 and 19 have it; e outlives it; classic_free
 *   vec3 L = classic_shade(&c, r)   18: shade_ray;  classic_whitted(&c, r)   19: whitted_ray
 *   classic_lit(&s, &lit)           a studio of polygons with four corners and shapes as 26 has
 *                                   it: matte, white mirror or glass, and lamps of which the front
 *                                   shines; lit_free
 */
#ifndef EFFECTS_CLASSIC_H
#define EFFECTS_CLASSIC_H

#include "../../24_direct_light/lit_scene.h"
#include "../stage.h"

typedef struct {
    const effects_stage *e;
    whitted_look *look;     /* [materials] */
    light *light;
    whitted how;
    shading plain;
} classic;

/* ---------------------------------------------------------------------------------------------- */

static inline uint32_t classic_number(const classic *c, trace_hit x)
{
    return studio_hit_material(&c->e->t, (studio_hit){x.h, c->e->t.world.part[x.part].id});
}

static inline const whitted_look *classic_look(const void *context, const trace_hit *x,
                                               const surface *s, whitted_look *room)
{
    const classic *c = context;
    (void)s, (void)room;
    return &c->look[classic_number(c, *x)];
}

static inline material classic_material(const void *context, trace_hit x, const surface *s)
{
    const classic *c = context;
    (void)s;
    return c->look[classic_number(c, x)].base;
}

/* e cuts from now on, as 19 does: the same rays. */
static inline void classic_build(effects_stage *e, classic *c)
{
    const studio *s = e->s;
    effects_stage_cut(e, (real)1 / 512);
    *c = (classic){.e = e};
    c->look = allocate(s->materials, sizeof *c->look);
    for (size_t m = 0; m < s->materials; m++) {
        const material *of = &e->look[m].m;
        c->look[m] = (whitted_look){*of, of->inside.ior > 0 ? (uint32_t)m + 1 : 0, 0};
    }
    c->light = allocate(s->lights, sizeof *c->light);
    for (size_t i = 0; i < s->lights; i++) c->light[i] = s->light[i].light;
    c->how = (whitted){.lights = c->light, .n = (int)s->lights, .material_of = classic_look,
                       .context = c, .media = e->media, .background = s->sky.background,
                       .depth = e->depth, .least = 1 / e->keep, .apart = true};
    c->plain = (shading){.lights = c->light, .n = (int)s->lights, .material_of = classic_material,
                         .context = c, .background = s->sky.background};
}

static inline void classic_free(classic *c)
{
    free(c->look), free(c->light);
    *c = (classic){.e = NULL};
}

static inline vec3 classic_whitted(const classic *c, ray r)
{
    tracer t = {.w = &c->e->t.world, .program = whitted_programs, .user = &c->how};
    return whitted_ray(&t, r, (media_set){0});
}

static inline vec3 classic_shade(const classic *c, ray r)
{
    tracer t = {.w = &c->e->t.world, .program = shade_programs, .user = &c->plain};
    return shade_ray(&t, r);
}

static inline void classic_lit(const studio *s, lit_scene *lit)
{
    lit_begin(lit);
    for (size_t i = 0; i < s->shapes; i++) {
        const polygon *g = &s->shape[i].polygon;
        material m = appearance_of(&s->material[s->shape_material[i]]).m;
        m.both = false;
        uint16_t k = lit_add_material(lit, m);
        if (s->shape[i].kind != SHAPE_POLYGON) lit_add_shape(lit, s->shape[i], k);
        else lit_add_rectangle(lit, (rectangle){g->v[0], vsub(g->v[1], g->v[0]),
                                                vsub(g->v[3], g->v[0])}, k);
    }
    lit_end(lit);
}

#endif
