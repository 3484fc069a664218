/* pictures.h: the forest, right and with normalised rays, and teapots whose normals are wrong.
 *
 *   draw_forest(&o, naive)             the main picture; naive: by rays normalised in object space
 *   draw_normals(&o)                   teapots scaled: A^T n, M n, and the angle between them
 */
#ifndef INSTANCES_LAB_PICTURES_H
#define INSTANCES_LAB_PICTURES_H

#include "../../../common/lab/label.h"
#include "../../../common/output.h"
#include "../../07_mesh/scenes/teapot.h"
#include "forest.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void draw_forest(const options *o, bool naive)
{
    forest w;
    instances x;
    failure f;
    double start = clock_seconds();
    forest_plant(&w, o->quick ? 300 : 9000, o->seed);
    crowd c = {w.mesh, w.kinds, w.list, w.n};
    if (!instances_build(&c, instances_defaults, &x, &f)) fail(f);
    double built = clock_seconds();
    image im = image_new(o->width, o->height);
    camera eye = forest_camera((real)o->width / (real)o->height);
    int samples = o->quick || naive ? 1 : 2;
    forest_view v = {&w, &x, eye, o->width, o->height, naive};
    bool whole = pixels_draw(&im, samples, o->threads, "forest", forest_colour, &v);
    instance_stats s = instances_stats(&x);
    if (!naive)
        printf("# %zu instances of %zu meshes, %.4g triangles, in %.3g MB: grown and built in "
               "%.3f s, %d x %d pixels of %d rays in %.3f s\n", s.instances, s.meshes, s.triangles,
               (double)(x.bytes + s.mesh_bytes) * 0x1p-20, built - start, o->width, o->height,
               samples * samples, clock_seconds() - built);
    output_picture(o, &im, naive ? "16_instances_unit.png" : "16_instances.png", !naive, whole);
    instances_free(&x), forest_free(&w), image_free(&im);
}

/* ---- normals ---- */

enum { pots = 4 };
typedef struct {
    const instances *x;
    const instance *list;
    camera c;
    int width, height, row;
} pot_row;

static inline vec3 pot_colour(const void *context, real px, real py)
{
    const pot_row *p = context;
    ray r = camera_ray(p->c, px, py, p->width, p->height);
    instance_hit h;
    vec3 background = {0.93, 0.93, 0.93};
    if (!instances_hit(p->x, r, &h)) return p->row < 2 ? background : (vec3){0, 0, 0};
    const placed *at = &p->x->place[p->x->where[h.instance]];
    vec3 object = mesh_normal(&p->x->mesh[at->mesh], h.h.shape, h.h.u, h.h.v);
    vec3 n = normal_to_world(&at->to_object, object);
    vec3 naive = normal_naive(&p->list[h.instance].to_world, object);
    if (p->row < 2) return headlight(p->row ? naive : n, r.d);
    real off = mesh_angle(n, naive) / (pi / 3);  /* white at 60 degrees */
    return (vec3){real_min(2 * off, 1), off, real_max(2 * off - 1, 0)};
}

static inline camera pot_camera(real aspect)
{
    camera_frame frame;
    camera c;
    failure f;
    real half = 14.2;
    camera_window win = {-half, half, -half / aspect, half / aspect};
    if (!frame_look_at((vec3){0, -30, 12}, vec(0, 0, 1.9), (vec3){0, 0, 1}, &frame, &f)
        || !camera_orthographic(frame, win, &c, &f)) fail(f);
    return c;
}

/* Three rows: right, M n, the angle between. */
static inline void draw_normals(const options *o)
{
    static const vec3 scale[pots] = {{1, 1, 1}, {1, 1, 0.3}, {0.3, 1, 1},
                                     {0.75, 0.75, 1.45}};
    mesh m = teapot_mesh(o->quick ? 4 : 12);
    instance list[pots];
    instances x;
    failure f;
    bool whole = true;
    for (int i = 0; i < pots; i++) {
        vec3 to = {(real)-10.2 + (real)i * (real)6.9 + (i > 2 ? (real)-1.4 : 0), 0, 0};
        affine turn = affine_rotation((vec3){0, 0, 1}, -0.5);
        affine a = affine_then(affine_scaling(scale[i]), turn);
        list[i] = (instance){affine_then(a, affine_translation(to)), 0};
    }
    crowd c = {&m, 1, list, pots};
    if (!instances_build(&c, instances_defaults, &x, &f)) fail(f);
    image all = image_new(o->width, o->height);
    for (int row = 0; row < 3; row++) {
        int top = row * o->height / 3, bottom = (row + 1) * o->height / 3;
        if (bottom == top) continue;
        image im = image_new(o->width, bottom - top);
        camera eye = pot_camera((real)im.width / (real)im.height);
        pot_row p = {&x, list, eye, im.width, im.height, row};
        whole &= pixels_draw(&im, o->quick ? 1 : 3, o->threads, "normals", pot_colour, &p);
        image_place(&all, 0, top, &im);
        label_tag(&all, 0, top, 11, row == 0 ? "A^T n" : row == 1 ? "M n"
                                    : "angle: orange 30, white 60 degrees");
        image_free(&im);
    }
    output_picture(o, &all, "16_instances_normals.png", false, whole);
    image_free(&all), instances_free(&x), mesh_free(&m);
}

#endif
