/* classic.h: a stage as chapters 18 and 19 would have it, to compare with: same rays, their code.
 *
 *   classic c;
 *   classic_build(&e, &c)           shapes and meshes that stand; e outlives it
 *   vec3 L = classic_shade(&c, r)   18: shade_ray
 *   vec3 L = classic_whitted(&c, r) 19: whitted_ray
 *   bool classic_can(&e)            19 knows all that the stage calls for: hard shadows, mirror,
 *                                   refraction, absorption, no thin glass, no Fresnel but glass's,
 *                                   one background, no instances
 *   classic_free(&c)
 *
 *   table_of_tax(&o)                prints 27 against 18 and 19, in turn, one thread: medians;
 *                                   false: stopped by Ctrl-C, nothing is printed
 */
#ifndef EFFECTS_CLASSIC_H
#define EFFECTS_CLASSIC_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"  /* before shape.h, whose name it uses for its own */
#include "draw.h"
#include "../../19_whitted/scenes/forty.h"
#include "../files/studio_read.h"
#include "../plan.h"

typedef struct {
    const effects_stage *e;
    scene all;
    world_part *part;       /* [world.parts] */
    uint32_t *place;        /* of the part; no_shape: the shapes */
    trace_world world;
    whitted_material *look; /* [materials] */
    whitted how;
    shading plain;
} classic;

/* ---------------------------------------------------------------------------------------------- */

static inline uint32_t classic_number(const classic *c, trace_hit x)
{
    return studio_hit_material(&c->e->t, (studio_hit){x.h, c->place[x.part]});
}

static inline const whitted_material *classic_look(const void *context, trace_hit x,
                                                   const surface *s, whitted_material *room)
{
    const classic *c = context;
    (void)s, (void)room;
    return &c->look[classic_number(c, x)];
}

static inline material classic_material(const void *context, trace_hit x, const surface *s)
{
    const classic *c = context;
    (void)s;
    return c->look[classic_number(c, x)].base;
}

static inline bool classic_can(const effects_stage *e)
{
    bool can = !(e->mask & EFFECTS_OF_CHANCE) && !e->t.moved.n && !e->t.solids && !e->clear
        && !e->headlight
        && e->sky.s->kind == SKY_NONE;
    for (size_t m = 0; m < e->s->materials; m++) {
        const appearance *a = &e->look[m];
        bool glass = !vzero(a->through);
        can = can && (!e->s->material[m].used || (vzero(a->flat) && a->fresnel == glass));
    }
    return can;
}

static inline void classic_build(const effects_stage *e, classic *c)
{
    const studio *s = e->s;
    const studio_tree *t = &e->t;
    *c = (classic){.e = e, .all = studio_shapes(s)};
    c->part = allocate(t->standing + 1, sizeof *c->part);
    c->place = allocate(t->standing + 1, sizeof *c->place);
    size_t n = 0;
    if (s->shapes) {
        world_part_of_scene(&c->all, MASK_ALL, &c->part[n]);
        c->place[n++] = no_shape;
    }
    for (size_t k = 0; k < t->standing; k++) {
        world_part_of_mesh(&s->mesh[s->placed[t->mesh_place[k]].mesh], MASK_ALL, &c->part[n]);
        c->place[n++] = t->mesh_place[k];
    }
    c->world = (trace_world){c->part, n};
    c->look = allocate(s->materials, sizeof *c->look);
    for (size_t m = 0; m < s->materials; m++) {
        const appearance *a = &e->look[m];
        bool glass = !vzero(a->through);
        c->look[m] = (whitted_material){{a->matte, a->highlight, a->exponent, a->emits}, a->mirror,
                                        a->through, glass ? (uint32_t)m + 1 : 0, 0};
    }
    c->how = (whitted){.lights = e->light, .n = e->lights, .material_of = classic_look,
                       .context = c, .media = e->media, .background = s->sky.background,
                       .depth = e->depth, .least = e->least, .apart = true};
    c->plain = (shading){.lights = e->light, .n = e->lights, .material_of = classic_material,
                         .context = c, .background = s->sky.background};
}

static inline void classic_free(classic *c)
{
    for (size_t k = 0; k < c->world.parts; k++) world_part_free(&c->part[k]);
    free(c->part), free(c->place), free(c->look);
    *c = (classic){.e = NULL};
}

static inline vec3 classic_whitted(const classic *c, ray r)
{
    tracer t = {.w = &c->world, .program = whitted_programs, .user = &c->how};
    return whitted_ray(&t, r, (media_set){0});
}

static inline vec3 classic_shade(const classic *c, ray r)
{
    tracer t = {.w = &c->world, .program = shade_programs, .user = &c->plain};
    return shade_ray(&t, r);
}

/* ---- how fast ---- */

typedef struct {
    const effects_stage *e;
    classic c;
    bool whitted;
    image im;
    effects_counts counts;
    bool stopped;
} tax_run;

static inline void tax_pixel(int x, int y, void *context)
{
    tax_run *k = context;
    ray r = camera_ray(k->e->eye, (real)x + (real)0.5, (real)y + (real)0.5, k->im.width,
                       k->im.height);
    r.tmin = k->e->hither;
    image_set(&k->im, x, y, k->whitted ? classic_whitted(&k->c, r) : classic_shade(&k->c, r));
}

static inline double tax_before(void *context)
{
    tax_run *k = context;
    k->stopped |= !parallel_pixels(k->im.width, k->im.height, 1, "chapter", tax_pixel, k);
    return (double)k->im.rgb[0];
}

static inline double tax_now(void *context)
{
    tax_run *k = context;
    drawing j = {.e = k->e, .samples = 1, .seed = 1, .width = k->im.width, .height = k->im.height};
    k->stopped |= !draw_region(&j, &k->im, 0, 0, 1);
    k->counts = j.counts;
    return (double)k->im.rgb[0];
}

/* The balls of 19's forty.h, on one colour of ground; plain: all of them painted. */
static inline char *forty_text(bool plain)
{
    enum { room = 1 << 14 };
    char *text = allocate(room, 1);
    size_t n = (size_t)snprintf(text, room,
        "camera from 0 -11 4.5 at 0 0.4 0.9 up 0 0 1 angle 31\nindirect off\n"
        "background 0.35 0.55 0.85\n"
        "sun to 5 -6 9 colour 2\nsun to -6 -4 5 colour 0.7\nsun to 1 8 6 colour 0.4\n"
        "material mirror\nKd 0\nKs 0.9\nillum 3\nmaterial glass\nKd 0\nNi 1.5\nTf 1\nillum 7\n");
    for (int k = 0; k < forty_balls; k++) {
        const int *b = forty_ball[k];
        int kind = plain ? 0 : k % 3;
        if (kind) n += (size_t)snprintf(text + n, room - n, "use %s\n",
                                        kind == 1 ? "mirror" : "glass");
        else n += (size_t)snprintf(text + n, room - n,
                                   "material paint%d\nKd %g %g %g\nillum 1\n", k,
                                   0.3 + 0.15 * (k * 7 % 5), 0.3 + 0.15 * (k * 3 % 5),
                                   0.3 + 0.1 * (k * 11 % 7));
        n += (size_t)snprintf(text + n, room - n, "sphere %g %g %g %g\n", b[0] / 1e3, b[1] / 1e3,
                              b[2] / 1e3, b[3] / 1e3);
    }
    return text;
}

static inline bool tax_row(const options *o, table *t, bool glass)
{
    studio s;
    effects_stage e;
    failure f;
    studio_view v;
    camera c;
    int w = o->quick ? 48 : 240, h = w * 3 / 4;
    char *text = forty_text(!glass);
    if (!studio_read_text(text, "forty.scene", NULL, &s, &f)) fail(f);
    plan p = plan_of(&s);
    if (!effects_stage_build(&s, &e, &f) || !studio_camera(&s, 4 / (real)3, &v, &c, &f))
        fail(f);
    effects_stage_view(&e, &v, c);
    effects_stage_effects(&e, p.effects);
    tax_run run[2] = {{.e = &e, .whitted = glass, .im = image_new(w, h)},
                      {.e = &e, .im = image_new(w, h)}};
    classic_build(&e, &run[0].c);
    bench_candidate k[2] = {{.run = tax_before, .context = &run[0]},
                            {.run = tax_now, .context = &run[1]}};
    bench_time(k, 2, o->quick ? 3 : 7);
    size_t rays = draw_rays(&run[1].counts);
    table_text(t, "%s", glass ? "forty balls: mirrors and glass" : "forty balls: painted");
    table_text(t, "%s", glass ? "19 whitted" : "18 shade");
    table_number(t, (double)rays / ((double)w * h));
    table_number(t, image_compare(&run[1].im, &run[0].im).maximum);
    table_number(t, k[0].seconds / (double)rays * 1e9);
    table_number(t, k[1].seconds / (double)rays * 1e9);
    table_number(t, k[0].seconds / k[1].seconds);
    classic_free(&run[0].c);
    image_free(&run[0].im), image_free(&run[1].im);
    effects_stage_free(&e), plan_free(&p), studio_free(&s), free(text);
    return !run[0].stopped && !run[1].stopped;
}

static inline bool table_of_tax(const options *o)
{
    table t = table_new("The general program against the chapters' own, in turn, one thread",
                        "scene|chapter|rays a pixel|difference: most|its own [ns/ray]|"
                        "here [ns/ray]|ratio of speeds");
    bool whole = tax_row(o, &t, false) && tax_row(o, &t, true);
    if (whole) output_extra_table(o, &t);
    else table_free(&t);
    return whole;
}

#endif
