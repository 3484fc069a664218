/* whitted_stage.h: a scene for Whitted's ray tracing, set up shape by shape; what they are made of.
 *
 *   whitted_paint(r, g, b)      reflects evenly, casts shadows
 *   whitted_mirror(m)           M = m, nothing else
 *   whitted_clear(body, keep)   clear glass that bounds `body`; shadow rays keep this part of light
 *
 *   whitted_stage *s = allocate(1, sizeof *s);     or one set to 0. It must not move: it points
 *                                                  into itself
 *   stage_add(s, shape, look)                      at most stage_most
 *   stage_floor(s, lo, hi, up, look)               a rectangle at height lo.z, normal up or down
 *   stage_box(s, lo, hi, in, look)                 six of them; normals outwards, or inwards
 *   s->media[1].ior = 1.5; s->w.least = ..         what whitted_scene.h asks for; media[0] is air
 *   tracer t = stage_begin(s, depth);              builds the trees: for whitted_ray
 *   stage_end(s)                                   frees them
 */
#ifndef WHITTED_SCENES_STAGE_H
#define WHITTED_SCENES_STAGE_H

#include "../../02_camera/camera.h"
#include "../whitted.h"

enum { stage_most = 40 };

typedef struct {
    whitted w;
    shape shape[stage_most], caster[stage_most];
    whitted_look look[stage_most], odd;
    vec3 corner[4 * stage_most];
    medium media[stage_most + 1];
    light light[4];
    real checks;           /* squares a unit length on shape 0, by turns look[0] and odd; 0: none */
    bool clear;            /* no glass casts a shadow: shadow rays get a tree of what does */
    size_t n;
    scene scene[2];
    world_part part[2];
    trace_world world;
} whitted_stage;

/* ---------------------------------------------------------------------------------------------- */

static inline whitted_look whitted_paint(double r, double g, double b)
{
    return (whitted_look){.base = {.kd = {(real)r, (real)g, (real)b}, .shine = 1}};
}

static inline whitted_look whitted_mirror(double m)
{
    whitted_look x = whitted_paint(0, 0, 0);
    x.base.mirror = vec(m, m, m);
    return x;
}

static inline whitted_look whitted_clear(uint32_t body, real keep)
{
    whitted_look x = whitted_mirror(1);
    x.base.through = x.base.mirror, x.body = body, x.shadow = keep;
    return x;
}

static inline const whitted_look *stage_look(const void *context, const trace_hit *x,
                                             const surface *s, whitted_look *room)
{
    const whitted_stage *w = context;
    (void)room;
    bool odd = ((int)floor(w->checks * s->p.x) + (int)floor(w->checks * s->p.y)) & 1;
    return x->h.shape == 0 && odd ? &w->odd : &w->look[x->h.shape];
}

static inline void stage_add(whitted_stage *s, shape x, whitted_look look)
{
    s->shape[s->n] = x, s->look[s->n++] = look;
}

static inline void stage_ball(whitted_stage *s, vec3 c, real R, whitted_look look)
{
    stage_add(s, shape_of_sphere((sphere){c, R}), look);
}

static inline void stage_floor(whitted_stage *s, vec3 lo, vec3 hi, bool up, whitted_look look)
{
    vec3 *q = s->corner + 4 * s->n;
    for (int i = 0; i < 4; i++) {
        int j = up ? i : 3 - i;
        q[i] = (vec3){j == 1 || j == 2 ? hi.x : lo.x, j > 1 ? hi.y : lo.y, lo.z};
    }
    stage_add(s, shape_of_polygon(polygon_of(q, 4)), look);
}

static inline void stage_box(whitted_stage *s, vec3 lo, vec3 hi, bool in, whitted_look look)
{
    for (int k = 0; k < 6; k++) {
        int axis = k / 2, next = (axis + 1) % 3, last = (axis + 2) % 3;
        vec3 *q = s->corner + 4 * s->n;
        for (int i = 0; i < 4; i++) {
            int j = (k % 2 == 0) == in ? i : 3 - i;  /* counter-clockwise, seen from the normal */
            real c[3];
            c[axis] = vaxis(k % 2 ? hi : lo, axis);
            c[next] = vaxis(j == 1 || j == 2 ? hi : lo, next);
            c[last] = vaxis(j > 1 ? hi : lo, last);
            q[i] = (vec3){c[0], c[1], c[2]};
        }
        stage_add(s, shape_of_polygon(polygon_of(q, 4)), look);
    }
}

static inline tracer stage_tracer(const whitted_stage *s)
{
    return (tracer){.w = &s->world, .program = whitted_programs, .user = &s->w};
}

static inline tracer stage_begin(whitted_stage *s, int depth)
{
    s->scene[0] = (scene){s->shape, s->n}, s->scene[1] = (scene){s->caster, 0};
    const shape nothing = shape_of_sphere((sphere){.r = (real)NAN});  /* no tree holds it */
    world_part_of_scene(&s->scene[0], s->clear ? MASK_SEEN : MASK_ALL, &s->part[0]);
    if (s->clear) {
        for (size_t k = 0; k < s->n; k++)
            s->caster[k] = s->look[k].shadow == 0 ? s->shape[k] : nothing;
        s->scene[1].n = s->n;
        world_part_of_scene(&s->scene[1], MASK_SHADOW, &s->part[1]);
        s->part[1].opaque = true;
    }
    s->part[0].id = s->part[1].id = 0;  /* of both shape k is the same */
    s->world = (trace_world){s->part, s->clear ? 2 : 1};
    s->media[0].ior = 1;
    s->w.media = s->media, s->w.lights = s->light, s->w.depth = depth;
    if (!s->w.material_of) s->w.material_of = stage_look;
    if (!s->w.context) s->w.context = s;
    return stage_tracer(s);
}

static inline void stage_end(whitted_stage *s)
{
    world_part_free(&s->part[0]), world_part_free(&s->part[1]);
}

#endif
