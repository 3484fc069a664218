/* showcase.h: scenes for the path tracer, each with a camera and its light.
 *
 *   showcase c;
 *   if (!showcase_of("cornell", aspect, &c, &f)) fail(f);    aspect: width / height
 *   if (!showcase_of_obj(path, aspect, &c, &f)) fail(f);     any OBJ, y up, framed automatically
 *   showcase_free(&c)
 *
 *   cornell   the box of 21, matte, one light                       38 triangles
 *   spheres   the box without blocks: a mirror and a ball of glass, faintly green
 *   teapot    of rough copper, in the open: sky, sun, a floor       9 x 9 cells a patch
 *   rough     five balls of glass, each rougher than the one before, and stripes behind them
 *   furnace   balls of all BRDFs of 23, and of glass, in a white world: they show what they lose
 *   OBJ       matte grey, on a floor, under the same sky
 */
#ifndef PATH_SHOWCASE_H
#define PATH_SHOWCASE_H

#include "../../07_mesh/files/obj.h"
#include "../../07_mesh/scenes/teapot.h"
#include "../../24_direct_light/scenes/lit_cornell.h"
#include "../path.h"

typedef struct { lit_scene s; environment sky; bool has_sky; camera eye; } showcase;
static const char *const showcase_names[] = {"cornell", "spheres", "teapot", "rough", "furnace",
                                             NULL};
enum { showcase_rough_balls = 5 };
static const double showcase_alpha[showcase_rough_balls] = {0, 0.04, 0.08, 0.16, 0.32};

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

static inline void showcase_ball(lit_scene *s, vec3 c, real r, lit_material m)
{
    lit_add_shape(s, shape_of_sphere((sphere){c, r}), lit_add_material(s, m));
}

/* Flat ground, facing up. */
static inline void showcase_floor(lit_scene *s, vec3 middle, real half, vec3 albedo)
{
    uint16_t m = lit_add_material(s, (lit_material){.f = brdf_lambert(albedo)});
    vec3 o = {middle.x - half, middle.y, middle.z - half};
    lit_add_rectangle(s, (rectangle){o, {0, 0, 2 * half}, {2 * half, 0, 0}}, m);
}

static inline void showcase_spheres(lit_scene *s)
{
    mesh m = cornell_mesh();
    enum { room = 18 };  /* triangles that are no blocks */
    lit_begin(s);
    for (int k = 0; k < cornell_parts; k++) {
        lit_material x = {.f = brdf_lambert(cornell_reflectance[k])};
        if (k == CORNELL_LIGHT) x.Le = cornell_radiance;
        lit_add_material(s, x);
    }
    rectangle lamp = {cornell_corner, cornell_side_s, cornell_side_t};
    for (size_t i = 0; i < room; i++)
        if (cornell_of(i) != CORNELL_LIGHT)
            lit_add_triangle(s, mesh_triangle(&m, i), (uint16_t)cornell_of(i));
    lit_add_rectangle(s, lamp, CORNELL_LIGHT);
    mesh_free(&m);
    real r = 100;
    showcase_ball(s, (vec3){390, r, 350}, r,
                  (lit_material){.f = brdf_mirror(vec(0.95, 0.93, 0.88))});
    showcase_ball(s, (vec3){170, r, 200}, r,
                  (lit_material){.ior = 1.5,
                                 .sigma = {0.0016, 0.0004, 0.0012}});
}

static inline void showcase_outdoors(showcase *c)
{
    environment_sky(512, 256, vec(-0.5, 0.75, 0.6), &c->sky);
    c->has_sky = true;
}

static inline void showcase_teapot(showcase *c, real aspect)
{
    mesh m = teapot_mesh(9);
    for (size_t i = 0; i < m.vertices; i++) m.v[i] = (vec3){m.v[i].x, m.v[i].z, -m.v[i].y};
    for (size_t i = 0; i < m.normals; i++) m.n[i] = (vec3){m.n[i].x, m.n[i].z, -m.n[i].y};
    lit_begin(&c->s);
    vec3 copper = {0.95, 0.64, 0.54};
    uint16_t pot = lit_add_material(&c->s, (lit_material){.f = brdf_ggx(copper, 0.35)});
    lit_add_mesh(&c->s, &m, pot);
    mesh_free(&m);
    showcase_floor(&c->s, (vec3){0, 0, 0}, 60, vec(0.48, 0.42, 0.36));
    showcase_outdoors(c);
    c->eye = showcase_eye(vec(2.5, 6.5, 13), vec(0.25, 1.3, 0), 24,
                          aspect);
}

/* A wall of stripes, of two colours each; a large lamp above, and even light from all around. */
static inline void showcase_rough(lit_scene *s)
{
    lit_begin(s);
    uint16_t stripe[2] = {lit_add_material(s, (lit_material){.f = brdf_lambert(vec(.7, .66, .6))}),
                          lit_add_material(s, (lit_material){.f = brdf_lambert(vec(.1, .22, .3))})};
    uint16_t lamp = lit_add_material(s, (lit_material){.Le = vec(1.3, 1.2, 1)});
    for (int k = 0; k < 40; k++) {
        vec3 o = {(real)(k - 20) * (real)0.8, 0, -3};
        lit_add_rectangle(s, (rectangle){o, vec(0.8, 0, 0), vec(0, 9, 0)}, stripe[k % 2]);
    }
    showcase_floor(s, (vec3){0, 0, 0}, 30, vec(0.62, 0.5, 0.4));
    lit_add_rectangle(s, (rectangle){vec(-7, 8, -2), vec(14, 0, 0), vec(0, 0, 8)}, lamp);
    for (int k = 0; k < showcase_rough_balls; k++)
        showcase_ball(s, vec(2.2 * (k - 2), 1, 0.1 * (k - 2) * (k - 2)), 1,
                      (lit_material){.ior = 1.5, .alpha = (real)showcase_alpha[k]});
    s->background = vec(0.66, 0.7, 0.78);
}

static inline void showcase_furnace(lit_scene *s)
{
    vec3 grey = {0.8, 0.8, 0.8},
         half = {0.5, 0.5, 0.5}, white = {1, 1, 1};
    const brdf b[] = {brdf_lambert(grey), brdf_blinn_phong(half, half, 50),
                      brdf_ggx(white, 0.7), brdf_ggx(white, 0.2), brdf_mirror(white)};
    lit_begin(s);
    for (int i = 0; i < 6; i++) {
        vec3 at = {(real)(i % 3) * (real)2.3, (real)(1 - i / 3) * (real)2.3, 0};
        lit_material m = {.ior = 1.5};
        if (i < 5) m = (lit_material){.f = b[i]};
        showcase_ball(s, at, 1, m);
    }
    s->background = white;
}

static inline bool showcase_of(const char *name, real aspect, showcase *c, failure *f)
{
    *c = (showcase){.has_sky = false};
    if (strcmp(name, "cornell") == 0 || strcmp(name, "spheres") == 0) {
        if (*name == 'c') lit_cornell_begin(&c->s);
        else showcase_spheres(&c->s);
        c->eye = cornell_camera(aspect);
    } else if (strcmp(name, "teapot") == 0) {
        showcase_teapot(c, aspect);
    } else if (strcmp(name, "rough") == 0) {
        showcase_rough(&c->s);
        c->eye = showcase_eye(vec(0, 2.4, 15), vec(0, 1.15, 0), 15, aspect);
    } else if (strcmp(name, "furnace") == 0) {
        showcase_furnace(&c->s);
        c->eye = showcase_eye(vec(2.3, 1.15, 14), vec(2.3, 1.15, 0),
                              22, aspect);
    } else {
        return failed(f, 2, "--scene %.200s: allowed are cornell, spheres, teapot, rough, furnace",
                      name);
    }
    lit_end(&c->s);
    return true;
}

/* The nearest eye along `from` that sees all corners of the box, with a margin: by halving. */
static inline camera showcase_framed(vec3 lo, vec3 hi, vec3 from, real fov, real aspect)
{
    vec3 half = vscale(vsub(hi, lo), 0.5), middle = vadd(lo, half);
    real near = vlength(half), far = near * 100 / real_min(aspect, 1);
    for (int k = 0; k < 40; k++) {
        real away = (near + far) / 2, x, y;
        camera c = showcase_eye(vmadd(middle, from, away), middle, fov, aspect);
        bool fits = true;
        for (int i = 0; i < 8; i++) {
            vec3 p = {i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z};
            fits = fits && camera_project(c, p, 100, 100, &x, &y) && x > 6 && x < 94 && y > 6
                && y < 94;
        }
        if (fits) far = away;
        else near = away;
    }
    return showcase_eye(vmadd(middle, from, far), middle, fov, aspect);
}

/* From the front, a little from above. */
static inline bool showcase_of_obj(const char *path, real aspect, showcase *c, failure *f)
{
    mesh m;
    vec3 lo, hi;
    *c = (showcase){.has_sky = false};
    if (!obj_read(path, &m, f)) return false;
    bool some = mesh_bounds(&m, &lo, &hi);
    vec3 half = vscale(vsub(hi, lo), 0.5), middle = vadd(lo, half);
    real r = vlength(half), fov = 30;
    if (!some || !(r > 0) || !isfinite(r)) {
        mesh_free(&m);
        return failed(f, 2, "%.300s: no triangles of any size to draw", path);
    }
    if (!isfinite(1000 * r) || !vfinite(vscale(middle, 1000))) {
        mesh_free(&m);
        return failed(f, 2, "%.300s: too large to be seen from anywhere", path);
    }
    lit_begin(&c->s);
    vec3 grey = {0.72, 0.7, 0.66};
    uint16_t clay = lit_add_material(&c->s, (lit_material){.f = brdf_lambert(grey)});
    lit_add_mesh(&c->s, &m, clay);
    mesh_free(&m);
    showcase_floor(&c->s, (vec3){middle.x, lo.y, middle.z}, 30 * r, vscale(grey, 0.6));
    showcase_outdoors(c);
    c->eye = showcase_framed(lo, hi, vunit(vec(0.45, 0.4, 1)), fov, aspect);
    lit_end(&c->s);
    return true;
}

#endif
