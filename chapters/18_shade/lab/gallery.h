/* gallery.h: the scene of this chapter: a teapot, balls, a cone and a leaning card on a floor,
 * under a sun and a lamp; anywhere in space.
 *
 *   gallery *g = gallery_new(n, T);          teapot of n x n cells a patch; all moved by T along
 *                                            each axis; gallery_free
 *   camera c = gallery_camera(T, aspect, close);   of all, or of the card's lower edge
 *   shading how = gallery_shading(g);
 *   traced_view v = gallery_view(g, &how, w, h, close);    w x h pixels
 *
 * The lamp's bulb has a mask of its own: seen by camera rays, passed by shadow rays; so the lamp,
 * in its middle, shines.
 */
#ifndef SHADE_LAB_GALLERY_H
#define SHADE_LAB_GALLERY_H

#include "../../07_mesh/scenes/teapot.h"
#include "../shade.h"
#include "../trials/traced_view.h"

enum { gallery_shapes = 9, gallery_parts = 3 };

typedef struct {
    vec3 T;
    shape shapes[gallery_shapes], bulb;
    vec3 corner[8];
    scene s, lamp;
    mesh pot;
    world_part part[gallery_parts];  /* shapes, teapot, bulb */
    trace_world w;
    light lights[2];
} gallery;

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 gallery_at(const gallery *g, double x, double y, double z)
{
    return vadd(g->T, vec(x, y, z));
}

/* Floor, card, cone; the others are balls: centre and radius; kd, ks, shine. */
typedef struct { double x, y, z, r, kd[3], ks, shine; } gallery_item;
static const gallery_item gallery_items[gallery_shapes] = {
    {.kd = {0.62, 0.6, 0.56}, .shine = 1},
    {.kd = {0.7, 0.62, 0.3}, .shine = 1},
    {-2.6, -3.2, 0.9, 0.9, {0.62, 0.07, 0.05}, 0.5, 120},
    {4.9, 0.6, 1.3, 1.3, {0.1, 0.28, 0.5}, 0.4, 60},
    {-0.4, -3.9, 0.45, 0.45, {0.1, 0.42, 0.12}, 0.4, 40},
    {1.0, -4.6, 0.25, 0.25, {0.75, 0.45, 0.06}, 0.6, 200},
    {.kd = {0.5, 0.2, 0.42}, .ks = 0.12, .shine = 12},
    {1.88, -4.14, 0.02, 0.02, {0.9, 0.9, 0.9}, 0, 1},  /* beside the card's corner */
    {-4.6, -2.3, 0.35, 0.35, {0.03, 0.03, 0.03}, 0.9, 400}};
static const double gallery_corners[8][3] = {
    {-40, -40, 0}, {40, -40, 0}, {40, 40, 0}, {-40, 40, 0},
    {2.0, -4.1, 0}, {4.2, -3.3, 0}, {3.9, -2.5, 1.5}, {1.7, -3.3, 1.5}};

static inline gallery *gallery_new(int n, real T)
{
    gallery *g = allocate(1, sizeof *g);
    g->T = (vec3){T, T, T};
    for (int k = 0; k < 8; k++) {
        const double *c = gallery_corners[k];
        g->corner[k] = gallery_at(g, c[0], c[1], c[2]);
    }
    for (int k = 0; k < gallery_shapes; k++) {
        const gallery_item *i = &gallery_items[k];
        g->shapes[k] = shape_of_sphere((sphere){gallery_at(g, i->x, i->y, i->z), (real)i->r});
    }
    g->shapes[0] = shape_of_polygon(polygon_of(g->corner, 4));
    g->shapes[1] = shape_of_polygon(polygon_of(g->corner + 4, 4));
    g->shapes[6] = shape_of_cone((cone){gallery_at(g, -5, 0.4, 0), 1,
                                        gallery_at(g, -5, 0.4, 2.6), 0});
    g->bulb = shape_of_sphere((sphere){gallery_at(g, -4.4, -1.6, 4.1), 0.16});
    g->lights[0] = (light){LIGHT_DIRECTIONAL, vunit(vec(0.55, -0.5, 0.62)), {2.1, 1.95, 1.7}};
    g->lights[1] = (light){LIGHT_POINT, g->bulb.sphere.c, {13, 15, 19}};
    g->pot = teapot_mesh(n);
    for (size_t i = 0; i < g->pot.vertices; i++) g->pot.v[i] = vadd(g->T, g->pot.v[i]);
    g->s = (scene){g->shapes, gallery_shapes}, g->lamp = (scene){&g->bulb, 1};
    world_part_of_scene(&g->s, MASK_ALL, &g->part[0]);
    world_part_of_mesh(&g->pot, MASK_ALL, &g->part[1]);
    world_part_of_scene(&g->lamp, MASK_SEEN, &g->part[2]);
    g->w = (trace_world){g->part, gallery_parts};
    return g;
}

static inline void gallery_free(gallery *g)
{
    for (int k = 0; k < gallery_parts; k++) world_part_free(&g->part[k]);
    mesh_free(&g->pot);
    free(g);
}

static inline material gallery_material(const void *context, trace_hit x, const surface *s)
{
    const gallery *g = context;
    if (x.part == 2) return (material){.shine = 1, .ke = {1.6, 1.7, 2}};
    if (x.part == 1) {
        return (material){.kd = {0.58, 0.52, 0.45}, .ks = {0.5, 0.5, 0.5}, .shine = 90};
    }
    const gallery_item *i = &gallery_items[x.h.shape];
    vec3 p = vsub(s->p, g->T), kd = vec(i->kd[0], i->kd[1], i->kd[2]);
    bool odd = ((int)floor((double)p.x / 1.5) + (int)floor((double)p.y / 1.5)) & 1;
    if (x.h.shape == 0 && odd) kd = vscale(kd, 0.45);
    return (material){.kd = kd, .ks = vec(i->ks, i->ks, i->ks), .shine = (real)i->shine};
}

static inline shading gallery_shading(const gallery *g)
{
    return (shading){.lights = g->lights, .n = 2, .material_of = gallery_material, .context = g,
                     .background = {0.09, 0.13, 0.2}, .ambient = {0.1, 0.12, 0.15}};
}

static inline camera gallery_camera(real T, real aspect, bool close)
{
    vec3 from = close ? vec(1.25, -4.85, 0.26) : vec(-1.5, -15, 5.2), t = {T, T, T};
    vec3 to = close ? vec(1.955, -4.1, 0.022) : vec(0, -0.9, 1.25);
    return camera_at(vadd(from, t), vadd(to, t), (vec3){0, 0, 1}, close ? 7 : 27, aspect);
}

static vec3 gallery_along(tracer *t, const ray *r) { return shade_ray(t, *r); }

static inline traced_view gallery_view(const gallery *g, const shading *how, int w, int h,
                                       bool close)
{
    return (traced_view){
        .t = {.w = &g->w, .program = shade_programs, .user = how}, .along = gallery_along,
        .width = w, .height = h, .c = gallery_camera(g->T.x, (real)w / (real)h, close)};
}

#endif
