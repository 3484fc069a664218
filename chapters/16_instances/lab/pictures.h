/* pictures.h: the forest, right and with normalised rays, and teapots whose normals are wrong.
 *
 *   draw_forest(&o, naive)             the main picture; naive: by rays normalised in object space
 *   draw_normals(&o)                   teapots scaled: A^T n, M n, and the angle between them
 */
#ifndef INSTANCES_LAB_PICTURES_H
#define INSTANCES_LAB_PICTURES_H

#include "../../../common/lab/panels.h"
#include "../../07_mesh/scenes/teapot.h"
#include "flattened.h"
#include "forest.h"

/* ---------------------------------------------------------------------------------------------- */

cold_inline void draw_forest(const options *o, bool naive)
{
    forest w;
    instances x;
    failure f;
    forest_plant(&w, o->quick ? 300 : 9000, o->seed);
    crowd c = forest_crowd(&w);
    if (!instances_build(&c, instances_defaults, &x, &f)) fail(f);
    image im = image_new(o->width, o->height);
    camera eye = forest_camera((real)o->width / (real)o->height);
    int samples = o->quick || naive ? 1 : 2;
    forest_view v = {&w, &x, eye, o->width, o->height, naive};
    bool whole = pixels_draw(&im, samples, o->threads, "forest", forest_colour, &v);
    size_t bytes = x.bytes;
    for (size_t k = 0; k < c.meshes; k++) bytes += mesh_bytes(&c.mesh[k]);
    if (!naive) printf("# %zu instances, %.4g triangles, in %.3g MB\n", x.n,
                       flattened_triangles(&x), (double)bytes * 0x1p-20);
    output_picture(o, &im, naive ? "16_instances_unit.png" : "16_instances.png", !naive, whole);
    instances_free(&x), forest_free(&w), image_free(&im);
}

/* ---- normals ---- */

enum { pots = 4, pot_rows = 3 };
typedef struct {
    const instances *x;
    const instance *list;
    camera c;
    int width, height, row;  /* of a panel; 0: by A^T n; 1: by M n; 2: the angle between */
} pot_view;

static inline vec3 pot_colour(const void *context, real px, real py)
{
    const pot_view *p = context;
    ray r = camera_ray(p->c, px, py, p->width, p->height);
    instance_hit h;
    if (!instances_hit(p->x, r, &h)) return p->row < 2 ? vec(0.93, 0.93, 0.93) : vec(0, 0, 0);
    const placed *at = &p->x->place[p->x->where[h.instance]];
    vec3 object = mesh_normal(&p->x->mesh[at->mesh], h.h.shape, h.h.u, h.h.v);
    vec3 n = normal_to_world(&at->to_object, object);
    vec3 naive = normal_naive(&p->list[h.instance].to_world, object);
    if (p->row < 2) return headlight(p->row ? naive : n, r.d);
    real off = mesh_angle(n, naive) / (pi / 3);  /* white at 60 degrees */
    return (vec3){real_min(2 * off, 1), off, real_max(2 * off - 1, 0)};
}

cold_inline void draw_normals(const options *o)
{
    static const vec3 scale[pots] = {{1, 1, 1}, {1, 1, 0.3}, {0.3, 1, 1}, {0.75, 0.75, 1.45}};
    static const char *const name[pot_rows] = {"A^T n", "M n",
                                               "angle: orange 30, white 60 degrees"};
    static const double along[pots] = {-10.2, -3.3, 3.6, 9.1};
    panels_shape g = {.width = o->width, .height = o->height, .columns = 1, .rows = pot_rows,
                      .side = o->quick ? 1 : 3, .tags = true};
    mesh m = teapot_mesh(o->quick ? 4 : 12);
    instance list[pots];
    instances x;
    camera_frame frame;
    camera c;
    failure f;
    panel p[pot_rows];
    pot_view v[pot_rows];
    for (int i = 0; i < pots; i++) {
        affine a = affine_then(affine_scaling(scale[i]), affine_rotation((vec3){0, 0, 1}, -0.5));
        list[i] = (instance){affine_then(a, affine_translation(vec(along[i], 0, 0))), 0};
    }
    real half = 14.2, up = half * (real)panels_high(g) / (real)g.width;
    if (!instances_build(&(crowd){&m, 1, list, pots}, instances_defaults, &x, &f)
        || !frame_look_at((vec3){0, -30, 12}, vec(0, 0, 1.9), (vec3){0, 0, 1}, &frame, &f)
        || !camera_orthographic(frame, (camera_window){-half, half, -up, up}, &c, &f)) fail(f);
    for (int k = 0; k < pot_rows; k++) {
        v[k] = (pot_view){&x, list, c, g.width, panels_high(g), k};
        p[k] = (panel){name[k], &v[k]};
    }
    panels_draw(o, "16_instances_normals.png", false, g, pot_colour, p);
    instances_free(&x), mesh_free(&m);
}

#endif
