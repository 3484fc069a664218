/* box.h: the Cornell box (cornell.h) as a world for distributed.h.
 *
 *   distributed_box *b = box_new(sized, ambient, reach);    sized: the light is the square that it
 *                                      is; else all of its intensity comes from the middle
 *   distributed_view v = box_view(b, aspect);       box_free(b)
 *
 * The light is a part of its own, seen by camera rays and by no others: it hides nothing that it
 * lights.
 */
#ifndef DISTRIBUTED_BOX_H
#define DISTRIBUTED_BOX_H

#include "../scenes/cornell.h"
#include "view.h"

typedef struct {
    mesh m[2];           /* walls and blocks; the light: with the same vertices */
    uint8_t part_of[2][cornell_triangles];
    world_part part[2];
    trace_world w;
    area_light light;
    distributed how;
} distributed_box;

/* ---------------------------------------------------------------------------------------------- */

static inline material box_material(const void *context, trace_hit x, const surface *s)
{
    const distributed_box *b = context;
    vec3 black = {0, 0, 0}, ke = s->n.y < 0 ? area_light_radiance(&b->light) : black;
    return (material){.kd = cornell_reflectance[b->part_of[x.part][x.h.shape]],
                      .ke = x.part == 1 ? ke : black};
}

/* The triangles of the box that are not, or are, its light. */
static inline void box_part(distributed_box *b, int shining)
{
    mesh *m = &b->m[shining];
    size_t n = 0;
    *m = cornell_mesh();
    for (size_t i = 0; i < m->triangles; i++) {
        if ((cornell_of(i) == CORNELL_LIGHT) != shining) continue;
        memmove(m->index + 3 * n, m->index + 3 * i, 3 * sizeof *m->index);
        b->part_of[shining][n++] = (uint8_t)cornell_of(i);
    }
    m->triangles = n;
    world_part_of_mesh(m, shining ? MASK_SEEN : MASK_ALL, &b->part[shining]);
}

static inline distributed_box *box_new(bool sized, vec3 ambient, real reach)
{
    distributed_box *b = allocate(1, sizeof *b);
    vec3 s = cornell_side_s, t = cornell_side_t, normal = vcross(s, t);
    box_part(b, 0), box_part(b, 1);
    b->w = (trace_world){b->part, 2};
    vec3 middle = vmadd(vmadd(cornell_corner, s, 0.5), t, 0.5);
    b->light = (area_light){AREA_RECTANGLE, middle, s, t, vunit(normal), 0,
                            vscale(cornell_radiance, vlength(normal))};
    if (!sized) b->light.a = b->light.b = (vec3){0, 0, 0};
    b->how = (distributed){.light = &b->light, .n = 1, .material_of = box_material, .context = b,
                           .ambient = ambient, .reach = reach, .depth = 1};
    return b;
}

static inline void box_free(distributed_box *b)
{
    for (int k = 0; k < 2; k++) world_part_free(&b->part[k]), mesh_free(&b->m[k]);
    free(b);
}

static inline distributed_view box_view(const distributed_box *b, real aspect)
{
    return (distributed_view){.w = &b->w, .how = &b->how, .c = cornell_camera(aspect),
                              .kind = SEQUENCE_SOBOL, .seed = 1};
}

#endif
