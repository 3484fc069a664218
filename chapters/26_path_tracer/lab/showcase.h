/* showcase.h: scenes for the path tracer, each with a camera and its light; and what renders them.
 *
 *   showcase c;
 *   if (!showcase_of("cornell", aspect, &c, &f)) fail(f);    aspect: width / height
 *   if (!showcase_of_obj(path, z_up, aspect, &c, &f)) fail(f);     any OBJ, framed automatically
 *   showcase_free(&c)
 *
 *   cornell   the box of 21, matte, one light                       38 triangles
 *   spheres   the box without blocks: a mirror and a ball of glass, faintly green
 *   metal     the same with a ball of metal and a matte one: the page's four panels
 *   teapot    of rough copper, in the open: sky, sun, a floor       9 x 9 cells a patch
 *   rough     five balls of glass, each rougher than the one before, and stripes behind them
 *   OBJ       grey, or of its materials' Kd and Ke, on a floor, under the same sky
 *
 *   shot s;
 *   shot_of(&s, &o, "metal", how, w, h);     a scene, its tracer, a job (render.h), an empty film
 *   image im = shot_picture(&s, exposure);   what s.film holds
 *   shot_free(&s)
 */
#ifndef PATH_SHOWCASE_H
#define PATH_SHOWCASE_H

#include "../../../common/options.h"
#include "../../07_mesh/scenes/teapot.h"
#include "../../24_direct_light/scenes/lit_cornell.h"
#include "../../24_direct_light/scenes/sky.h"
#include "../files/obj_materials.h"
#include "../render.h"

typedef struct {
    lit_scene s;
    environment sky;
    bool has_sky;
    camera eye;
    uint64_t libraries;  /* of a model's materials, their hash; 0: none */
} showcase;
typedef struct { showcase c; path_tracer t; render_job j; film film; } shot;
static const char showcase_names[] = "cornell, spheres, metal, teapot, rough";

/* ---------------------------------------------------------------------------------------------- */

static inline void showcase_free(showcase *c)
{
    lit_free(&c->s);
    if (c->has_sky) environment_free(&c->sky);
    c->has_sky = false;
}

static inline const environment *showcase_sky(const showcase *c)
{
    return c->has_sky ? &c->sky : NULL;
}

static inline camera showcase_eye(vec3 from, vec3 at, real degrees, real aspect)
{
    return camera_at(from, at, (vec3){0, 1, 0}, degrees, aspect);
}

static inline void showcase_ball(lit_scene *s, vec3 c, real r, material m)
{
    lit_add_shape(s, shape_of_sphere((sphere){c, r}), lit_add_material(s, m));
}

/* Flat ground, facing up. */
static inline void showcase_floor(lit_scene *s, vec3 middle, real half, vec3 albedo)
{
    uint16_t m = lit_add_material(s, (material){.kd = albedo});
    vec3 o = {middle.x - half, middle.y, middle.z - half};
    lit_add_rectangle(s, (rectangle){o, {0, 0, 2 * half}, {2 * half, 0, 0}}, m);
}

/* Their materials are the last two: cornell_parts and the next. */
static inline void showcase_balls(lit_scene *s, material left, material right)
{
    real r = 100;
    lit_cornell_room(s, cornell_room);
    showcase_ball(s, (vec3){390, r, 350}, r, left);
    showcase_ball(s, (vec3){170, r, 200}, r, right);
}

static inline void showcase_outdoors(showcase *c)
{
    environment_sky(512, 256, vec(-0.5, 0.75, 0.6), &c->sky);
    c->has_sky = true;
}

/* So that y points up where z did. */
static inline void showcase_upright(mesh *m)
{
    for (size_t i = 0; i < m->vertices; i++) m->v[i] = (vec3){m->v[i].x, m->v[i].z, -m->v[i].y};
    for (size_t i = 0; i < m->normals; i++) m->n[i] = (vec3){m->n[i].x, m->n[i].z, -m->n[i].y};
}

static inline void showcase_teapot(showcase *c, real aspect)
{
    mesh m = teapot_mesh(9);
    showcase_upright(&m);
    lit_begin(&c->s);
    vec3 copper = {0.95, 0.64, 0.54};
    uint16_t pot = lit_add_material(&c->s, (material){.mirror = copper, .alpha = ggx_alpha(0.45)});
    lit_add_mesh(&c->s, &m, pot);
    mesh_free(&m);
    showcase_floor(&c->s, (vec3){0, 0, 0}, 60, vec(0.48, 0.42, 0.36));
    showcase_outdoors(c);
    c->eye = showcase_eye(vec(2.5, 6.5, 13), vec(0.25, 1.3, 0), 24, aspect);
}

/* A wall of stripes, of two colours each; a large lamp above, and even light from all around. */
static inline void showcase_rough(showcase *c, real aspect)
{
    static const double alpha[5] = {0, 0.04, 0.08, 0.16, 0.32};
    lit_scene *s = &c->s;
    lit_begin(s);
    uint16_t stripe[2] = {lit_add_material(s, (material){.kd = vec(.7, .66, .6)}),
                          lit_add_material(s, (material){.kd = vec(.1, .22, .3)})};
    uint16_t lamp = lit_add_material(s, (material){.ke = vec(1.3, 1.2, 1)});
    for (int k = 0; k < 40; k++) {
        vec3 o = {(real)(k - 20) * (real)0.8, 0, -3};
        lit_add_rectangle(s, (rectangle){o, vec(0.8, 0, 0), vec(0, 9, 0)}, stripe[k % 2]);
    }
    showcase_floor(s, (vec3){0, 0, 0}, 30, vec(0.62, 0.5, 0.4));
    lit_add_rectangle(s, (rectangle){vec(-7, 8, -2), vec(14, 0, 0), vec(0, 0, 8)}, lamp);
    for (int k = 0; k < 5; k++)
        showcase_ball(s, vec(2.2 * (k - 2), 1, 0.1 * (k - 2) * (k - 2)), 1,
                      material_glass((medium){.ior = 1.5}, (real)alpha[k]));
    s->background = vec(0.66, 0.7, 0.78);
    c->eye = showcase_eye(vec(0, 2.4, 15), vec(0, 1.15, 0), 15, aspect);
}

cold_inline bool showcase_of(const char *name, real aspect, showcase *c, failure *f)
{
    vec3 silver = vec(0.95, 0.93, 0.88);
    material glass = material_glass((medium){1.5, {0.0016, 0.0004, 0.0012}, 0}, 0);
    *c = (showcase){.eye = cornell_camera(aspect)};
    if (strcmp(name, "cornell") == 0) lit_cornell_begin(&c->s);
    else if (strcmp(name, "spheres") == 0)
        showcase_balls(&c->s, (material){.mirror = silver}, glass);
    else if (strcmp(name, "metal") == 0)
        showcase_balls(&c->s, (material){.mirror = silver, .alpha = ggx_alpha((real)0.12)},
                       (material){.kd = vec(0.7, 0.7, 0.7)});
    else if (strcmp(name, "teapot") == 0) showcase_teapot(c, aspect);
    else if (strcmp(name, "rough") == 0) showcase_rough(c, aspect);
    else return failed(f, 2, "--scene %.200s: allowed are %s", name, showcase_names);
    lit_end(&c->s);
    return true;
}

/* From the front, a little from above: the nearest eye that sees all of it, with a margin. */
static inline bool showcase_of_obj(const char *path, bool z_up, real aspect, showcase *c,
                                   failure *f)
{
    mesh m;
    vec3 lo, hi, grey = {0.72, 0.7, 0.66}, from = vunit(vec(0.45, 0.4, 1));
    camera_frame frame;
    *c = (showcase){.has_sky = false};
    if (!obj_read(path, &m, f)) return false;
    if (z_up) showcase_upright(&m);
    bool some = mesh_bounds(&m, &lo, &hi);
    vec3 half = vscale(vsub(hi, lo), 0.5), middle = vadd(lo, half);
    real r = vlength(half), fov = 30, margin = (real)0.88;
    bool seen = some && r > 0 && isfinite(1000 * r) && vfinite(vscale(middle, 1000)), ok = true;
    if (seen) {
        lit_begin(&c->s);
        uint16_t look = lit_add_material(&c->s, (material){.kd = grey});
        lit_add_mesh(&c->s, &m, look);
        ok = obj_materials(&m, path, look, &c->s, &c->libraries, f);
    }
    mesh_free(&m);
    if (!ok) return false;
    if (!seen) return failed(f, 2, some && r > 0 ? "%.300s: too large to be seen from anywhere"
                             : "%.300s: no triangles of any size to draw", path);
    showcase_floor(&c->s, (vec3){middle.x, lo.y, middle.z}, 30 * r, vscale(grey, 0.6));
    showcase_outdoors(c);
    if (!frame_look_at(from, (vec3){0, 0, 0}, (vec3){0, 1, 0}, &frame, f)) return false;
    real away = camera_distance(&frame, half, aspect, half_tangent(fov) * margin);
    c->eye = showcase_eye(vmadd(middle, from, away), middle, fov, aspect);
    lit_end(&c->s);
    return true;
}

/* ---- one of them, and what renders it ---- */

static inline void shot_begin(shot *s, const options *o, path_options how, film f)
{
    path_tracer_of(&s->c.s, showcase_sky(&s->c), how, &s->t);
    s->j = (render_job){.tracer = &s->t, .eye = s->c.eye, .seed = o->seed, .threads = o->threads};
    s->film = f;
}

static inline void shot_of(shot *s, const options *o, const char *name, path_options how, int w,
                           int h)
{
    failure f;
    if (!showcase_of(name, (real)w / (real)h, &s->c, &f)) fail(f);
    shot_begin(s, o, how, film_new(w, h));
}

static inline image exposed(image im, float exposure)
{
    for (size_t i = 0; i < 3 * (size_t)im.width * (size_t)im.height; i++) im.rgb[i] *= exposure;
    return im;
}

static inline image shot_picture(const shot *s, float exposure)
{
    return exposed(film_picture(&s->film), exposure);
}

static inline void shot_free(shot *s)
{
    film_free(&s->film), path_tracer_free(&s->t), showcase_free(&s->c);
}

#endif
