/* gallery.h: the scene of this chapter: a teapot, balls, a cone and a leaning card on a floor,
 * under a sun and a lamp; anywhere in space.
 *
 *   gallery *g = gallery_new(n, T);          teapot of n x n cells a patch; all moved by T along
 *                                            each axis; gallery_free
 *   camera c = gallery_camera(T, aspect);    of all; gallery_close_up: of the card's lower edge
 *   shading how = gallery_shading(g);
 *   gallery_view v = {.g = g, .how = how, .c = c, .samples = n, .im = &im};      n^2 rays a pixel
 *   bool whole = gallery_draw(&v, threads)   v.counts: the rays; .printed = depth: by printed.h
 *
 * The lamp's bulb has a mask of its own: seen by camera rays, passed by shadow rays; so the lamp,
 * in its middle, shines.
 */
#ifndef SHADE_LAB_GALLERY_H
#define SHADE_LAB_GALLERY_H

#include "../../../common/image.h"
#include "../../../common/parallel.h"
#include "../../02_camera/camera.h"
#include "../../07_mesh/scenes/teapot.h"
#include "printed.h"

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

static inline shape gallery_ball(const gallery *g, double x, double y, double r)
{
    return shape_of_sphere((sphere){gallery_at(g, x, y, r), (real)r});
}

static inline void gallery_fill(gallery *g)
{
    const double floor[4][2] = {{-40, -40}, {40, -40}, {40, 40}, {-40, 40}};
    for (int k = 0; k < 4; k++) g->corner[k] = gallery_at(g, floor[k][0], floor[k][1], 0);
    g->corner[4] = gallery_at(g, 2.0, -4.1, 0), g->corner[5] = gallery_at(g, 4.2, -3.3, 0);
    g->corner[6] = gallery_at(g, 3.9, -2.5, 1.5), g->corner[7] = gallery_at(g, 1.7, -3.3, 1.5);
    g->shapes[0] = shape_of_polygon(polygon_of(g->corner, 4));
    g->shapes[1] = shape_of_polygon(polygon_of(g->corner + 4, 4));  /* the card */
    g->shapes[2] = gallery_ball(g, -2.6, -3.2, 0.9);
    g->shapes[3] = gallery_ball(g, 4.9, 0.6, 1.3);
    g->shapes[4] = gallery_ball(g, -0.4, -3.9, 0.45);
    g->shapes[5] = gallery_ball(g, 1.0, -4.6, 0.25);
    g->shapes[6] = shape_of_cone((cone){gallery_at(g, -5, 0.4, 0), 1,
                                        gallery_at(g, -5, 0.4, 2.6), 0});
    g->shapes[7] = gallery_ball(g, 1.88, -4.14, 0.02);              /* beside the card's corner */
    g->shapes[8] = gallery_ball(g, -4.6, -2.3, 0.35);
    g->bulb = shape_of_sphere((sphere){gallery_at(g, -4.4, -1.6, 4.1), 0.16});
    g->lights[0] = (light){LIGHT_DIRECTIONAL, vunit(vec(0.55, -0.5, 0.62)),
                           {2.1, 1.95, 1.7}};
    g->lights[1] = (light){LIGHT_POINT, g->bulb.sphere.c, {13, 15, 19}};
}

static inline gallery *gallery_new(int n, real T)
{
    gallery *g = allocate(1, sizeof *g);
    g->T = (vec3){T, T, T};
    gallery_fill(g);
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
    static const double look[gallery_shapes][5] = {  /* kd, ks, shine */
        {0.62, 0.6, 0.56, 0, 1},      {0.7, 0.62, 0.3, 0, 1},       {0.62, 0.07, 0.05, 0.5, 120},
        {0.1, 0.28, 0.5, 0.4, 60},    {0.1, 0.42, 0.12, 0.4, 40},   {0.75, 0.45, 0.06, 0.6, 200},
        {0.5, 0.2, 0.42, 0.12, 12},   {0.9, 0.9, 0.9, 0, 1},        {0.03, 0.03, 0.03, 0.9, 400}};
    const gallery *g = context;
    if (x.part == 2) return (material){.shine = 1, .ke = {1.6, 1.7, 2}};
    if (x.part == 1)
        return (material){{0.58, 0.52, 0.45}, {0.5, 0.5, 0.5},
                          90, {0, 0, 0}};
    const double *l = look[x.h.shape];
    vec3 p = vsub(s->p, g->T), kd = {(real)l[0], (real)l[1], (real)l[2]};
    bool odd = ((int)floor((double)p.x / 1.5) + (int)floor((double)p.y / 1.5)) & 1;
    if (x.h.shape == 0 && odd) kd = vscale(kd, 0.45);
    return (material){kd, {(real)l[3], (real)l[3], (real)l[3]}, (real)l[4], {0, 0, 0}};
}

static inline shading gallery_shading(const gallery *g)
{
    return (shading){.lights = g->lights, .n = 2, .material_of = gallery_material, .context = g,
                     .background = {0.09, 0.13, 0.2},
                     .ambient = {0.1, 0.12, 0.15}};
}

static inline camera gallery_look(real T, vec3 from, vec3 to, real degrees, real aspect)
{
    vec3 t = {T, T, T};
    return camera_at(vadd(from, t), vadd(to, t), (vec3){0, 0, 1}, degrees, aspect);
}

static inline camera gallery_camera(real T, real aspect)
{
    return gallery_look(T, vec(-1.5, -15, 5.2), vec(0, -0.9, 1.25),
                        27, aspect);
}

static inline camera gallery_close_up(real T, real aspect)
{
    return gallery_look(T, vec(1.25, -4.85, 0.26),
                        vec(1.955, -4.1, 0.022), 7, aspect);
}

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    const gallery *g;
    shading how;
    camera c;
    int samples, printed;
    image *im;
    pthread_mutex_t lock;
    trace_counts counts;
} gallery_view;

static inline void gallery_pixel(int x, int y, void *context)
{
    gallery_view *v = context;
    tracer t = {.w = &v->g->w, .program = shade_programs, .user = &v->how};
    if (v->printed) t.program = printed_programs;
    vec3 sum = {0, 0, 0};
    int n = v->samples;
    for (int k = 0; k < n * n; k++) {
        real px = (real)x + ((real)(k % n) + (real)0.5) / (real)n;
        real py = (real)y + ((real)(k / n) + (real)0.5) / (real)n;
        ray r = camera_ray(v->c, px, py, v->im->width, v->im->height);
        vec3 c = v->printed ? printed_ray(&t, r, v->printed) : shade_ray(&t, r);
        sum = vadd(sum, vmin(c, (vec3){4, 4, 4}));  /* a highlight must not outshout its pixel */
    }
    image_set(v->im, x, y, vscale(sum, 1 / (real)(n * n)));
    pthread_mutex_lock(&v->lock);
    trace_counts_add(&v->counts, &t.counts);
    pthread_mutex_unlock(&v->lock);
}

/* Sets v->counts; its other members are the caller's. */
static inline bool gallery_draw(gallery_view *v, int threads)
{
    image *im = v->im;
    pthread_mutex_init(&v->lock, NULL);
    bool whole = parallel_pixels(im->width, im->height, threads, "drawing", gallery_pixel, v);
    pthread_mutex_destroy(&v->lock);
    return whole;
}

#endif
