/* chance.h: the general program against chapters that throw dice: 21, 24, 26, on one scene each.
 *
 *   table_of_chance(&o)             prints both in turn, one thread: medians; false: Ctrl-C
 *   chance_lit(&s, &lit)            a studio of polygons with four corners and shapes, as 24 to 26
 *                                   have it: matte, mirror (white) or glass, and lamps; lit_free
 *
 * The two share no random numbers: their means are compared by their difference over its standard
 * error, and how far off each is by two pictures of different seeds: RMSE = rms(A - B) / sqrt 2.
 * 26 ends paths and splits at glass by other dice than 27, so that it sends another number of rays.
 */
#ifndef EFFECTS_CHANCE_H
#define EFFECTS_CHANCE_H

#include "../../24_direct_light/direct.h"  /* these two have names that 18 and 26 give to types */
#include "../../21_distributed/distributed.h"
#include "../../26_path_tracer/render.h"
#include "classic.h"

typedef struct chance_run chance_run;
struct chance_run {
    const effects_stage *e;
    lit_scene lit;
    size_t (*draw)(chance_run *c, uint64_t seed, image *im);   /* rays that it took */
    uint32_t samples;
    image im[2];
    size_t rays;
    bool stopped;
};

/* ---------------------------------------------------------------------------------------------- */

static inline void chance_lit(const studio *s, lit_scene *lit)
{
    lit_begin(lit);
    for (size_t i = 0; i < s->shapes; i++) {
        const studio_material *m = &s->material[s->shape_material[i]];
        appearance a = appearance_of(m);
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

/* ---- one picture ---- */

static inline size_t chance_27(chance_run *c, uint64_t seed, image *im)
{
    drawing j = {.e = c->e, .samples = (int)c->samples, .seed = seed, .width = im->width,
                 .height = im->height};
    c->stopped |= !draw_region(&j, im, 0, 0, 1);
    return draw_rays(&j.counts);
}

static inline size_t chance_26(chance_run *c, uint64_t seed, image *im)
{
    path_tracer t;
    path_tracer_of(&c->lit, NULL, path_defaults, &t);
    render_job j = {.tracer = &t, .eye = c->e->eye, .seed = seed, .threads = 1};
    film f = film_new(im->width, im->height);
    c->stopped |= !render_range(&j, &f, 0, c->samples);
    image_free(im);
    *im = film_picture(&f);
    film_free(&f), path_tracer_free(&t);
    return path_rays(&j.counts);
}

typedef struct { chance_run *c; lit_lights lights; direct_work work; uint64_t seed; image *im; }
    chance_direct;

static inline void chance_direct_pixel(int x, int y, void *context)
{
    chance_direct *k = context;
    const lit_scene *s = &k->c->lit;
    direct d = {s, DIRECT_AREA, &k->lights, &k->work, false};
    uint64_t pixel = (uint64_t)y * (uint64_t)k->im->width + (uint64_t)x;
    vec3 sum = {0, 0, 0};
    for (uint32_t i = 0; i < k->c->samples; i++) {
        sampler q = sampler_start(SEQUENCE_SOBOL, k->seed, pixel, i, k->c->samples);
        point2 p = sampler_pair(&q);
        ray r = ray_unit(camera_ray(k->c->e->eye, (real)x + p.u, (real)y + p.v, k->im->width,
                                    k->im->height));
        lit_hit h;
        if (!lit_trace(s, r, &h)) continue;
        sum = vadd(sum, vadd(lit_emitted(&h), direct_light(&d, &h, vneg(r.d), &q)));
    }
    image_set(k->im, x, y, vscale(sum, 1 / (real)k->c->samples));
}

static inline size_t chance_24(chance_run *c, uint64_t seed, image *im)
{
    chance_direct k = {.c = c, .seed = seed, .im = im};
    lit_lights_of(&c->lit, NULL, LIGHTS_FLUX, &k.lights);
    c->stopped |= !parallel_pixels(im->width, im->height, 1, "24", chance_direct_pixel, &k);
    lit_lights_free(&k.lights);
    size_t eye = (size_t)im->width * (size_t)im->height * c->samples;
    return eye + k.work.shadow + k.work.direction;
}

static inline material chance_material(const void *context, trace_hit x, const surface *s)
{
    const effects_stage *e = context;
    (void)s;
    return (material){.kd = e->look[e->s->shape_material[x.h.shape]].matte};
}

/* The lamp, which comes last, is no part of 21's world: it is where shadow rays end. */
static inline size_t chance_21(chance_run *c, uint64_t seed, image *im)
{
    const studio *s = c->e->s;
    scene things = {s->shape, s->shapes - 1};
    const polygon *g = &s->shape[s->shapes - 1].polygon;
    vec3 a = vsub(g->v[1], g->v[0]), b = vsub(g->v[3], g->v[0]), n = vcross(a, b);
    vec3 Le = c->e->look[s->shape_material[s->shapes - 1]].emits;
    area_light lamp = {AREA_RECTANGLE, vmadd(g->v[0], vadd(a, b), (real)0.5), a, b, vunit(n), 0,
                       vscale(Le, vlength(n))};
    world_part part;
    world_part_of_scene(&things, MASK_ALL, &part);
    trace_world world = {&part, 1};
    distributed how = {.light = &lamp, .n = 1, .material_of = chance_material, .context = c->e,
                       .background = s->sky.background, .depth = 1};
    distributed_view v = {.w = &world, .how = &how, .c = c->e->eye, .lens = c->e->lens,
                          .kind = SEQUENCE_SOBOL, .seed = seed, .samples = c->samples};
    c->stopped |= !distributed_draw(&v, im, 1);
    world_part_free(&part);
    size_t rays = 0;
    for (int k = 0; k < ray_kinds; k++) rays += v.spent.rays.rays[k];
    return rays;
}

/* ---- the table ---- */

static const struct {
    const char *name, *chapter;
    size_t (*draw)(chance_run *c, uint64_t seed, image *im);
    const char *text;
} chance_row[] = {
    {"balls, a lamp, a lens", "21 distributed", chance_21,
     "camera from 0 2.5 7 at 0 0.6 0 angle 32\nbackground 0.3 0.4 0.6\nindirect off\n"
     "lens radius 0.1 focus 7\nmaterial white\nKd 0.7\nillum 1\n"
     "polygon -9 0 9  9 0 9  9 0 -9  -9 0 -9\nmaterial clay\nKd 0.7 0.4 0.2\nillum 1\n"
     "sphere -1.8 0.6 -1 0.6\nsphere -0.6 0.6 0 0.6\nsphere 0.6 0.6 1 0.6\nsphere 1.8 0.6 2 0.6\n"
     "material lamp\nKe 5\npolygon -1 5 -1  1 5 -1  1 5 1  -1 5 1\n"},
    {"room: direct light", "24 direct light", chance_24,
     "camera from 0 1 3.9 at 0 1 0 angle 50\nindirect off\nmaterial white\nKd 0.7\nillum 1\n"
     "polygon -1 0 4  1 0 4  1 0 -1  -1 0 -1\npolygon -1 0 -1  1 0 -1  1 2 -1  -1 2 -1\n"
     "material red\nKd 0.6 0.1 0.1\nillum 1\npolygon -1 0 4  -1 0 -1  -1 2 -1  -1 2 4\n"
     "material green\nKd 0.1 0.5 0.1\nillum 1\npolygon 1 0 -1  1 0 4  1 2 4  1 2 -1\n"
     "sphere -0.3 0.5 0.2 0.5\n"
     "material lamp\nKe 9 7 6\npolygon -0.4 2 0.9  -0.4 2 0.1  0.4 2 0.1  0.4 2 0.9\n"},
    {"room: mirror, glass, paths", "26 path tracer", chance_26,
     "camera from 0 1 3.9 at 0 1 0 angle 50\nmaterial white\nKd 0.7\nillum 1\n"
     "polygon -1 0 4  1 0 4  1 0 -1  -1 0 -1\npolygon -1 0 -1  1 0 -1  1 2 -1  -1 2 -1\n"
     "polygon 1 0 4  -1 0 4  -1 2 4  1 2 4\n"
     "material red\nKd 0.6 0.1 0.1\nillum 1\npolygon -1 0 4  -1 0 -1  -1 2 -1  -1 2 4\n"
     "material green\nKd 0.1 0.5 0.1\nillum 1\npolygon 1 0 -1  1 0 4  1 2 4  1 2 -1\n"
     "material lamp\nKe 3 2.5 2\npolygon -1 2 4  -1 2 -1  1 2 -1  1 2 4\n"
     "material mirror\nKd 0\nKs 1\nillum 3\nsphere -0.5 0.4 -0.3 0.4\n"
     "material glass\nKd 0\nNi 1.5\nTf 1\nabsorb 0.3 1 1.5\nillum 7\nsphere 0.45 0.45 0.5 0.4\n"}};
enum { chance_rows = sizeof chance_row / sizeof *chance_row };

static inline double chance_time(void *context)
{
    chance_run *c = context;
    c->rays = c->draw(c, 1, &c->im[0]);
    return (double)c->im[0].rgb[0];
}

static inline void chance_cells(table *t, chance_run run[2], const bench_candidate k[2],
                                double samples)
{
    double error[2], ns[2];
    for (int i = 0; i < 2; i++) {
        run[i].draw(&run[i], 2, &run[i].im[1]);
        error[i] = image_compare(&run[i].im[0], &run[i].im[1]).rmse / sqrt(2);
        ns[i] = k[i].seconds / (double)run[i].rays * 1e9;
    }
    double a = k[0].seconds * error[0] * error[0], b = k[1].seconds * error[1] * error[1];
    for (int i = 0; i < 2; i++) table_number(t, (double)run[i].rays / samples);
    for (int i = 0; i < 2; i++) table_number(t, error[i]);
    table_number(t, draw_z(&run[0].im[0], &run[1].im[0]));
    for (int i = 0; i < 2; i++) table_number(t, ns[i]);
    table_number(t, ns[0] / ns[1]), table_number(t, a / b);
}

static inline bool chance_add(const options *o, table *t, int row)
{
    int w = o->quick ? 32 : 160, h = w * 3 / 4;
    uint32_t samples = o->quick ? 4 : 16;
    studio s;
    effects_stage e;
    failure f;
    studio_view v;
    camera c;
    if (!studio_read_text(chance_row[row].text, "row.scene", NULL, &s, &f)) fail(f);
    plan p = plan_of(&s);
    if (!effects_stage_build(&s, &e, &f) || !studio_camera(&s, 4 / (real)3, &v, &c, &f)) fail(f);
    effects_stage_view(&e, &v, c);
    effects_stage_effects(&e, p.effects);
    chance_run run[2] = {{.draw = chance_row[row].draw}, {.draw = chance_27}};
    for (int i = 0; i < 4; i++) run[i / 2].im[i % 2] = image_new(w, h);
    for (int i = 0; i < 2; i++) run[i].e = &e, run[i].samples = samples;
    chance_lit(&s, &run[0].lit);
    bench_candidate k[2] = {{.run = chance_time, .context = &run[0]},
                            {.run = chance_time, .context = &run[1]}};
    bench_time(k, 2, o->quick ? 3 : 7);
    table_text(t, "%s", chance_row[row].name), table_text(t, "%s", chance_row[row].chapter);
    chance_cells(t, run, k, (double)w * h * samples);
    for (int i = 0; i < 4; i++) image_free(&run[i / 2].im[i % 2]);
    lit_free(&run[0].lit);
    effects_stage_free(&e), plan_free(&p), studio_free(&s);
    return !run[0].stopped && !run[1].stopped;
}

static inline bool table_of_chance(const options *o)
{
    table t = table_new("The general program against the chapters that throw dice, one thread",
                        "scene|chapter|rays a sample: its own|here|rmse: its own|rmse: here|"
                        "means differ by [standard errors]|its own [ns/ray]|here [ns/ray]|"
                        "ratio of speeds|ratio of speeds, equal error");
    bool whole = true;
    for (int k = 0; k < chance_rows && whole; k++) whole = chance_add(o, &t, k);
    if (whole) output_extra_table(o, &t);
    else table_free(&t);
    return whole;
}

#endif
