/* tax.h: what being general costs: the general program against chapters 18, 19, 21, 24 and 26, each
 * on a scene that it can draw, by its own code.
 *
 *   bool whole = table_of_tax(&o)   prints both in turn, one thread: medians; false: Ctrl-C
 *
 *   classic_build(&e, &c)           a stage as 18 and 19 have it; e outlives it; classic_free
 *   vec3 L = classic_shade(&c, r)   18: shade_ray;  classic_whitted(&c, r)   19: whitted_ray
 *   tax_lit(&s, &lit)               a studio of polygons with four corners and shapes as 26 has it:
 *                                   matte, white mirror or glass, and lamps; lit_free
 *
 * 26 ends paths and splits at glass by other dice than 27, so that it sends another number of rays;
 * tests/27_radiance.c compares their light.
 */
#ifndef EFFECTS_TAX_H
#define EFFECTS_TAX_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"  /* before shape.h, whose name it uses for its own */
#include "../../21_distributed/distributed.h"
#include "../../24_direct_light/direct.h"
#include "../../26_path_tracer/render.h"
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

static inline void tax_lit(const studio *s, lit_scene *lit)
{
    lit_begin(lit);
    for (size_t i = 0; i < s->shapes; i++) {
        appearance a = appearance_of(&s->material[s->shape_material[i]]);
        bool glass = !vzero(a.through);
        lit_material l = {.f = vzero(a.mirror) && !glass ? brdf_lambert(a.matte)
                                                         : brdf_mirror((vec3){1, 1, 1}),
                          .Le = a.emits, .ior = glass ? a.ior : 0, .sigma = a.absorb};
        const polygon *g = &s->shape[i].polygon;
        uint16_t k = lit_add_material(lit, l);
        if (s->shape[i].kind != SHAPE_POLYGON) lit_add_shape(lit, s->shape[i], k);
        else lit_add_rectangle(lit, (rectangle){g->v[0], vsub(g->v[1], g->v[0]),
                                                vsub(g->v[3], g->v[0])}, k);
    }
    lit_end(lit);
}

/* ---- the scenes ---- */

/* The balls of 19's forty.h, on one colour of ground; plain: all of them painted. lit: by what. */
static inline char *forty_text(bool plain, const char *lit)
{
    enum { room = 1 << 14 };
    char *text = allocate(room, 1);
    size_t n = (size_t)snprintf(text, room,
        "camera from 0 -11 4.5 at 0 0.4 0.9 up 0 0 1 angle 31\nindirect off\n"
        "background 0.35 0.55 0.85\n%s"
        "material mirror\nKd 0\nKs 0.9\nillum 3\nmaterial glass\nKd 0\nNi 1.5\nTf 1\nillum 7\n",
        lit);
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

#define TAX_SUNS \
    "sun to 5 -6 9 colour 2\nsun to -6 -4 5 colour 0.7\nsun to 1 8 6 colour 0.4\n"
/* Out of sight. */
#define TAX_LAMP "material lamp\nKe 6\npolygon -2 -1 8  -2 3 8  2 3 8  2 -1 8\n"

static const char tax_room[] =
    "camera from 0 1 3.9 at 0 1 0 angle 50\nmaterial white\nKd 0.7\nillum 1\n"
    "polygon -1 0 4  1 0 4  1 0 -1  -1 0 -1\npolygon -1 0 -1  1 0 -1  1 2 -1  -1 2 -1\n"
    "polygon 1 0 4  -1 0 4  -1 2 4  1 2 4\n"
    "material red\nKd 0.6 0.1 0.1\nillum 1\npolygon -1 0 4  -1 0 -1  -1 2 -1  -1 2 4\n"
    "material green\nKd 0.1 0.5 0.1\nillum 1\npolygon 1 0 -1  1 0 4  1 2 4  1 2 -1\n"
    "material lamp\nKe 3 2.5 2\npolygon -1 2 4  -1 2 -1  1 2 -1  1 2 4\n"
    "material mirror\nKd 0\nKs 1\nillum 3\nsphere -0.5 0.4 -0.3 0.4\n"
    "material glass\nKd 0\nNi 1.5\nTf 1\nabsorb 0.3 1 1.5\nillum 7\nsphere 0.45 0.45 0.5 0.4\n";

/* ---- how fast ---- */

typedef enum {
    TAX_SHADE, TAX_WHITTED, TAX_DISTRIBUTED, TAX_DIRECT, TAX_PATHS, tax_rows
} tax_row;
typedef struct {
    tax_row row;
    const effects_stage *e;
    classic c;
    lit_scene lit;
    lit_lights lights;      /* of lit: one lamp, so nothing is to be freed */
    image im;
    int samples;
    size_t rays;
    bool stopped;
} tax_run;

/* 24: of what the eye sees, the light of one point of the lamp. */
static inline vec3 tax_direct(tax_run *k, int x, int y)
{
    direct_work w = {0, 0, 0};
    direct d = {&k->lit, DIRECT_AREA, &k->lights, &w, false};
    vec3 sum = {0, 0, 0};
    uint64_t pixel = (uint64_t)y * (uint64_t)k->im.width + (uint64_t)x;
    sampler_keys keys;
    sampler_keys_of(SEQUENCE_SOBOL, 1, pixel, &keys);
    for (uint32_t i = 0; i < (uint32_t)k->samples; i++) {
        sampler s = sampler_of_keys(&keys, i, (uint32_t)k->samples);
        point2 u = sampler_pair(&s);
        ray r = ray_unit(camera_ray(k->e->eye, (real)x + u.u, (real)y + u.v, k->im.width,
                                    k->im.height));
        lit_hit h;
        if (!lit_trace(&k->lit, r, &h)) sum = vadd(sum, k->e->s->sky.background);
        else sum = vadd(sum, vadd(lit_emitted(&h), direct_light(&d, &h, vneg(r.d), &s)));
    }
    k->rays += (size_t)k->samples + w.shadow;
    return vscale(sum, 1 / (real)k->samples);
}

static inline void tax_pixel(int x, int y, void *context)
{
    tax_run *k = context;
    ray r = camera_ray(k->e->eye, (real)x + (real)0.5, (real)y + (real)0.5, k->im.width,
                       k->im.height);
    r.tmin = k->e->hither;
    image_set(&k->im, x, y, k->row == TAX_DIRECT ? tax_direct(k, x, y)
              : k->row == TAX_WHITTED ? classic_whitted(&k->c, r) : classic_shade(&k->c, r));
}

static inline void tax_distributed(tax_run *k)
{
    area_light lamp = {AREA_RECTANGLE, {0, 1, 8}, {4, 0, 0}, {0, 4, 0}, {0, 0, -1}, 0,
                       {6 * 16, 6 * 16, 6 * 16}};
    distributed how = {.light = &lamp, .n = 1, .material_of = classic_material, .context = &k->c,
                       .background = k->e->s->sky.background, .depth = 1};
    distributed_view v = {.w = &k->c.world, .how = &how, .c = k->e->eye, .lens = k->e->lens,
                          .kind = SEQUENCE_SOBOL, .seed = 1, .samples = (uint32_t)k->samples};
    k->stopped |= !distributed_draw(&v, &k->im, 1);
    for (int i = 0; i < ray_kinds; i++) k->rays += v.spent.rays.rays[i];
}

static inline void tax_paths(tax_run *k)
{
    path_tracer t;
    path_tracer_of(&k->lit, NULL, path_defaults, &t);
    render_job j = {.tracer = &t, .eye = k->e->eye, .seed = 1, .threads = 1};
    film f = film_new(k->im.width, k->im.height);
    k->stopped |= !render_range(&j, &f, 0, (uint32_t)k->samples);
    k->rays = path_rays(&j.counts);
    film_free(&f), path_tracer_free(&t);
}

/* Its own way. 18 and 19 send the rays that 27 sends: nobody counts them. */
static inline double tax_own(void *context)
{
    tax_run *k = context;
    k->rays = 0;
    if (k->row == TAX_PATHS) tax_paths(k);
    else if (k->row == TAX_DISTRIBUTED) tax_distributed(k);
    else k->stopped |= !parallel_pixels(k->im.width, k->im.height, 1, "chapter", tax_pixel, k);
    return (double)k->im.rgb[0] + (double)k->rays;
}

static inline double tax_here(void *context)
{
    tax_run *k = context;
    drawing j = {.e = k->e, .samples = k->samples, .seed = 1, .width = k->im.width,
                 .height = k->im.height};
    k->stopped |= !draw_region(&j, &k->im, 0, 0, 1);
    k->rays = draw_rays(&j.counts);
    return (double)k->im.rgb[0];
}

static const struct { const char *scene, *chapter, *lit; } tax_of[tax_rows] = {
    {"forty balls: painted", "18 shade", TAX_SUNS},
    {"forty balls: mirrors and glass", "19 whitted", TAX_SUNS},
    {"forty balls: a lamp, a lens", "21 distributed", TAX_LAMP "lens radius 0.05\n"},
    {"forty balls: a lamp", "24 direct light", TAX_LAMP},
    {"room: mirror, glass, paths", "26 path tracer", ""}};

static inline bool tax_add(const options *o, table *t, tax_row row)
{
    bool lit = row >= TAX_DIRECT, chance = row >= TAX_DISTRIBUTED;
    int w = o->quick ? 48 : chance ? 160 : 240, h = w * 3 / 4, samples = chance ? 16 : 1;
    studio s;
    effects_stage e;
    failure f;
    studio_view v;
    camera c;
    char *balls = forty_text(row != TAX_WHITTED, tax_of[row].lit);
    if (!studio_read_text(row == TAX_PATHS ? tax_room : balls, "tax.scene", NULL, &s, &f)) fail(f);
    plan p = plan_of(&s);
    if (!effects_stage_build(&s, &e, &f) || !studio_camera(&s, 4 / (real)3, &v, &c, &f)) fail(f);
    effects_stage_view(&e, &v, c);
    effects_stage_effects(&e, p.effects);
    tax_run run[2];
    for (int i = 0; i < 2; i++)
        run[i] = (tax_run){.row = row, .e = &e, .im = image_new(w, h), .samples = samples};
    if (lit) {
        tax_lit(&s, &run[0].lit);
        lit_lights_of(&run[0].lit, NULL, LIGHTS_FLUX, &run[0].lights);
    } else classic_build(&e, &run[0].c);
    bench_candidate k[2] = {{.run = tax_own, .context = &run[0]},
                            {.run = tax_here, .context = &run[1]}};
    bench_time(k, 2, o->quick ? 3 : 7);
    if (!chance) run[0].rays = run[1].rays;
    table_text(t, "%s", tax_of[row].scene), table_text(t, "%s", tax_of[row].chapter);
    for (int i = 0; i < 2; i++) table_number(t, (double)run[i].rays / ((double)w * h * samples));
    double ns[2];
    for (int i = 0; i < 2; i++)
        table_number(t, ns[i] = k[i].seconds / (double)run[i].rays * 1e9), image_free(&run[i].im);
    table_number(t, ns[0] / ns[1]);
    if (lit) lit_free(&run[0].lit);
    else classic_free(&run[0].c);
    effects_stage_free(&e), plan_free(&p), studio_free(&s), free(balls);
    return !run[0].stopped && !run[1].stopped;
}

static inline bool table_of_tax(const options *o)
{
    table t = table_new("The general program against the chapters' own, in turn, one thread",
                        "scene|chapter|rays a sample: its own|here|its own [ns/ray]|here [ns/ray]|"
                        "ratio of speeds");
    bool whole = true;
    for (int k = 0; k < tax_rows && whole; k++) whole = tax_add(o, &t, (tax_row)k);
    if (whole) output_extra_table(o, &t);
    else table_free(&t);
    return whole;
}

#endif
