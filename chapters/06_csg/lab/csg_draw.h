/* csg_draw.h: the pictures of this chapter.
 *
 *   csg_draw(&o, &scene)         the solid, or the whole of an expression, on a floor
 *   csg_draw_inside(&o)          the same solid from outside, from where it was cut away, and from
 *                                within: above with the hits in front alone, below with all hits
 *   csg_draw_pocket(&o)          faces that coincide, and thin foils: without a rule, with a
 *                                tolerance, by csg.h
 */
#ifndef CSG_DRAW_H
#define CSG_DRAW_H

#include "../../../common/headlight.h"
#include "../../../common/lab/panels.h"
#include "../../../common/random.h"
#include "csg_scenes.h"
#include "csg_variants.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct { const csg_scene *scene; first_camera camera; real floor; } csg_stage;

/* A direction to a wide lamp: to the place in it that the place in the pixel says, moved by what
 * chance says of the pixel, so that each pixel spreads its directions over all of the lamp. */
static inline vec3 csg_lamp(real x, real y)
{
    uint64_t pixel = (uint64_t)x + ((uint64_t)y << 32);
    real u = x + random_real(1, pixel, 0, 0), v = y + random_real(1, pixel, 0, 1);
    u -= floor(u), v -= floor(v);
    return vunit(vec(-0.7 + 0.28 * (double)u, 1, 0.4 + 0.28 * (double)v));
}

/* How much of the lamp is seen from p. The way up begins off the surface (18 says how far). */
static inline real csg_lit(const csg *c, vec3 p, vec3 n, vec3 lamp)
{
    real facing = vdot(n, lamp);
    if (!(facing > 0)) return 0;
    ray up = ray_from(vmadd(p, n, (real)1e-4), lamp);
    return csg_occluded(c, up) ? 0 : facing;
}

static inline vec3 csg_floor_colour(const csg_stage *s, ray r, vec3 lamp)
{
    vec3 sky = vec(0.80, 0.86, 0.93);
    real t = (s->floor - r.o.y) / r.d.y;
    if (!(t > 0 && isfinite(t))) return sky;
    vec3 p = ray_at(r, t);
    bool odd = fmod(floor(p.x) + floor(p.z), 2) != 0;  /* far away they fit no whole number of C */
    vec3 paint = odd ? vec(0.50, 0.52, 0.56) : vec(0.64, 0.66, 0.70);
    real light = (real)0.35 + (real)0.75 * csg_lit(&s->scene->c, p, vec(0, 1, 0), lamp);
    real haze = exp(-real_max(hypot(p.x, p.z) - 3, 0) / 6);
    return vadd(vscale(paint, light * haze), vscale(sky, 1 - haze));
}

static vec3 csg_stage_colour(const void *context, real x, real y)
{
    const csg_stage *s = context;
    ray r = first_camera_ray(s->camera, x, y);
    vec3 lamp = csg_lamp(x, y);
    hit h;
    if (!csg_hit(&s->scene->c, r, &h)) return csg_floor_colour(s, r, lamp);
    vec3 n = csg_normal(&s->scene->c, r, h);
    real light = (real)0.18 + (real)0.42 * headlight(n, r.d).x
        + (real)0.75 * csg_lit(&s->scene->c, ray_at(r, h.t), n, lamp);
    return vscale(csg_scene_colour(s->scene, h), light);
}

static inline void csg_draw(const options *o, const csg_scene *scene)
{
    image im = image_new(o->width, o->height);
    first_camera c = first_camera_at(vec(2.9, 2.6, 4.4), vec(0, -0.12, 0), vec(0, 1, 0), 34,
                                     o->width, o->height);
    real low = scene->c.nodes > 0 ? scene->c.node[0].bound.lo.y : 0;
    csg_stage s = {scene, c, isfinite(low) ? low : -real_infinity};
    bool whole = pixels_draw(&im, o->quick ? 1 : 3, o->threads, "picture", csg_stage_colour, &s);
    output_picture(o, &im, "06_csg.png", true, whole);
    image_free(&im);
}

/* ---- panels: one way, one eye ---- */

typedef struct { const csg_scene *scene; csg_way way; first_camera camera; } csg_panel;

static const vec3 csg_inner = {0.45, 0.42, 0.45}, csg_nothing = {0.86, 0.89, 0.93};

/* Lit by the eye; grey where the surface turns its inner side to us, as from within a solid. */
static vec3 csg_panel_colour(const void *context, real x, real y)
{
    const csg_panel *p = context;
    ray r = first_camera_ray(p->camera, x, y);
    hit h;
    if (!csg_way_hit(&p->way, &p->scene->c, r, &h)) return csg_nothing;
    vec3 n = csg_normal(&p->scene->c, r, h);
    vec3 paint = vdot(n, r.d) > 0 ? csg_inner : csg_scene_colour(p->scene, h);
    return vscale(paint, (real)0.22 + (real)0.78 * headlight(n, r.d).x);
}

cold_inline void csg_draw_inside(const options *o)
{
    static const char *const title[6] = {
        "t > 0: the eye outside", "t > 0: the eye in a hole", "t > 0: the eye in the solid",
        "all hits: outside", "all hits: in a hole", "all hits: in the solid"};
    static const char *const key[7] = {"ball", "cube", "hole", "hole", "hole",
                                       "seen from within the solid", "nothing"};
    enum { w = 312, h = 250 };
    const vec3 up = vec(0, 1, 0);
    const first_camera eye[3] = {
        first_camera_at(vec(2.9, 2.3, 4.4), vec(0, 0, 0), up, 38, w, h),
        first_camera_at(vec(0.1, -0.1, -0.2), vec(0.7, 0.25, 1), up, 110, w, h),
        first_camera_at(vec(0.74, 0.68, 0.7), vec(0, -0.15, 0.1), up, 110, w, h)};
    csg_panel of[6];
    panel p[6];
    bool whole;
    csg_scene s = csg_scene_of(CSG_CLASSIC);
    for (int k = 0; k < 6; k++) {
        of[k] = (csg_panel){&s, {k < 3 ? csg_hit_front : csg_hit, 0, false}, eye[k % 3]};
        p[k] = (panel){title[k], &of[k]};
    }
    image sheet = panels_new(o, (panels_shape){960, 2 * h + 12, 3, 2, 12, o->quick ? 1 : 2, false},
                             csg_panel_colour, p, &whole);
    label_below(&sheet, 34);
    for (int k = 0; k < 7; k++) {
        int x = 20 + 104 * k + 214 * (k == 6), y = sheet.height - 26;
        label_fill(&sheet, x, y, 18, 18, k < 5 ? csg_paint[k] : k < 6 ? csg_inner : csg_nothing);
        label_text(&sheet, x + 26, y + 14, 10, 0, vec(0, 0, 0), key[k]);
    }
    output_picture(o, &sheet, "06_csg_inside.png", false, whole);
    image_free(&sheet), csg_scene_free(&s);
}

cold_inline void csg_draw_pocket(const options *o)
{
    enum { w = 312, h = 300 };
    csg_scene s = csg_scene_pocket(false, vec(0, 0, 0));
    const first_camera c = first_camera_at(vec(2.0, 3.6, 4.4), vec(0.36, -0.05, 0), vec(0, 1, 0),
                                           42, w, h);
    const csg_panel of[3] = {{&s, {csg_hit_tolerant, -1, false}, c},
                             {&s, {csg_hit_tolerant, 0.003, false}, c},
                             {&s, {csg_hit, 0, false}, c}};
    const panel p[3] = {{"no rule for equal t", &of[0]},
                        {"crossings within 0.003 are one", &of[1]},
                        {"csg.h: one plane, one t", &of[2]}};
    panels_draw(o, "06_csg_coincident.png", false,
                (panels_shape){960, h, 3, 1, 12, o->quick ? 1 : 2, false}, csg_panel_colour, p);
    csg_scene_free(&s);
}

#endif
