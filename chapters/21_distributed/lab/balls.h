/* balls.h: the balls of first.c, as a world for distributed.h as well: both versions are asked for
 * the same picture.
 *
 *   distributed_balls *b = balls_new(chrome);   chrome: first.c's brushed ball; else all is matte
 *   distributed_view v = balls_view(b, aspect);              balls_free(b)
 *   vec3 L = balls_first(b, x, y, nx, ny, k, n, &random);    first.h: ray k of n x n of the pixel
 *   balls_draw_first(b, seed, samples, &im);                 its picture, as first.c draws it;
 *                                                            samples: a square number
 *
 * Of clay where first.c has glass, which distributed.h has not; the floor without checks, which are
 * edges too; one sky in all directions. The lamp is not seen: the few rays of a lobe that met it
 * would make all of the noise. Thing i is shape i.
 */
#ifndef DISTRIBUTED_BALLS_H
#define DISTRIBUTED_BALLS_H

#include "../first.h"
#include "view.h"

enum { balls_depth = 6 };

typedef struct {
    first_scene first;
    first_lamp lamp;
    shape shapes[first_most_things];
    vec3 floor[4];
    scene s;
    world_part part;
    trace_world w;
    area_light light;
    distributed how;
} distributed_balls;

/* ---------------------------------------------------------------------------------------------- */

static inline material balls_material(const void *context, trace_hit x, const surface *s)
{
    const distributed_balls *b = context;
    const first_material *m = &b->first.thing[x.h.shape].m;
    (void)s;
    return (material){.kd = m->kd, .ks = m->mirror, .shine = m->shine, .ke = m->ke};
}

static inline first_scene balls_scene(bool chrome)
{
    enum { board, glass, ball, clay, moss };
    first_scene s = first_two_balls();
    s.thing[board].m.checks = 0, s.above = s.below;
    s.thing[glass].m = s.thing[clay].m;
    if (chrome) s.thing[ball].m.shine = 90;
    else s.thing[ball].m = s.thing[moss].m;
    return s;
}

static inline distributed_balls *balls_new(bool chrome)
{
    distributed_balls *b = allocate(1, sizeof *b);
    b->first = balls_scene(chrome), b->lamp = first_two_balls_lamp(&b->first);
    for (int i = 0; i < b->first.things; i++) {
        const first_thing *x = &b->first.thing[i];
        vec3 *v = b->floor;  /* the only flat thing */
        if (x->ball.r != 0) { b->shapes[i] = shape_of_sphere(x->ball); continue; }
        v[0] = x->corner, v[1] = vadd(v[0], x->a), v[2] = vadd(v[1], x->b), v[3] = vadd(v[0], x->b);
        b->shapes[i] = shape_of_polygon(polygon_of(v, 4));
    }
    b->s = (scene){b->shapes, (size_t)b->first.things};
    world_part_of_scene(&b->s, MASK_ALL, &b->part);
    b->w = (trace_world){&b->part, 1};
    const first_lamp *l = &b->lamp;
    vec3 normal = vcross(l->a, l->b), middle = vmadd(vmadd(l->corner, l->a, 0.5), l->b, 0.5);
    b->light = (area_light){AREA_RECTANGLE, middle, l->a, l->b, vunit(normal), 0,
                            vscale(l->L, vlength(normal))};
    b->how = (distributed){.light = &b->light, .n = 1, .material_of = balls_material, .context = b,
                           .background = b->first.below, .ambient = b->first.ambient,
                           .depth = balls_depth};
    return b;
}

static inline void balls_free(distributed_balls *b)
{
    world_part_free(&b->part);
    free(b);
}

static inline distributed_view balls_view(const distributed_balls *b, real aspect)
{
    first_camera c = first_two_balls_camera(1, 1);
    return (distributed_view){.w = &b->w, .how = &b->how, .kind = SEQUENCE_SOBOL, .seed = 1,
                              .c = camera_at(c.e, vsub(c.e, c.w), c.v, 2 * atan(c.top) * 180 / pi,
                                             aspect)};
}

/* ---- first.h ---- */

static inline vec3 balls_first(const distributed_balls *b, int x, int y, int nx, int ny, int k,
                               int n, random_stream *random)
{
    ray r = first_ray_unit(first_pixel_ray(first_two_balls_camera(nx, ny), x, y, k, n));
    return first_distributed(&b->first, &b->lamp, r, balls_depth, random);
}

static inline void balls_draw_first(const distributed_balls *b, uint64_t seed, uint32_t samples,
                                    image *im)
{
    int w = im->width, h = im->height, n = (int)lround(sqrt((double)samples));
    for (int i = 0; i < w * h; i++) {
        vec3 sum = {0, 0, 0};
        for (int k = 0; k < n * n; k++) {
            random_stream random = random_start(seed, (uint64_t)i, (uint64_t)k);
            sum = vadd(sum, balls_first(b, i % w, i / w, w, h, k, n, &random));
        }
        image_set(im, i % w, i / w, vscale(sum, 1 / (real)(n * n)));
    }
}

#endif
