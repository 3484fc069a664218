/* showroom.h: the scene of this chapter, each effect on or off: a copper teapot among balls.
 *
 *   showroom *g = showroom_new(n);                 teapot of n x n cells a patch; showroom_free
 *   showroom_look k;
 *   showroom_set(&k, g, LOOK_SOFT | LOOK_SKY);       what is off is as Whitted has it:
 *       LOOK_SOFT       softbox and lamp have a size    else all their light comes from the middle
 *       LOOK_GLOSSY     lobes                           else perfect mirrors
 *       LOOK_SKY        ambient light can be hidden     else a constant
 *       LOOK_LENS       a lens of radius .22            else a pinhole
 *   distributed_view v = showroom_view(&k, SHOWROOM_ALL, aspect);   or a close-up for gloss
 *
 * Ambient light and background are the same even sky, so what LOOK_SKY makes of it is right but
 * for the light that shapes reflect on each other.
 */
#ifndef DISTRIBUTED_SHOWROOM_H
#define DISTRIBUTED_SHOWROOM_H

#include "../../07_mesh/scenes/teapot.h"
#include "view.h"

enum { LOOK_SOFT = 1, LOOK_GLOSSY = 2, LOOK_SKY = 4, LOOK_LENS = 8, LOOK_ALL = 15 };
typedef enum { SHOWROOM_ALL, SHOWROOM_GLOSSY, showroom_shots } showroom_shot;
enum { showroom_row = 9, showroom_shapes = 4 + showroom_row, showroom_parts = 3 };

typedef struct {
    shape shapes[showroom_shapes], lamps[2];
    vec3 corner[8];
    scene s, lit;
    mesh pot;
    world_part part[showroom_parts];  /* shapes, teapot, lamps */
    area_light light[2];
} showroom;

typedef struct {
    const showroom *g;
    int effects;
    real pot_shine;      /* of the teapot, if not 0 */
    trace_world w;
    area_light light[2];
    distributed how;
} showroom_look;

/* ---------------------------------------------------------------------------------------------- */

static inline shape showroom_ball(double x, double y, double r)
{
    return shape_of_sphere((sphere){vec(x, y, r), (real)r});
}

/* A square softbox of this side, turned towards `to`; its corners go to v[4]. */
static inline area_light showroom_softbox(vec3 at, vec3 to, real side, vec3 colour, vec3 *v)
{
    vec3 n = vunit(vsub(to, at)), a = vunit(vcross(n, (vec3){0, 0, 1})), b = vcross(a, n);
    a = vscale(a, side), b = vscale(b, side);
    for (int k = 0; k < 4; k++) {
        real x = k == 0 || k == 3 ? (real)-0.5 : (real)0.5, y = k < 2 ? (real)-0.5 : (real)0.5;
        v[k] = vmadd(vmadd(at, a, x), b, y);
    }
    return (area_light){AREA_RECTANGLE, at, a, b, n, 0, colour};
}

static inline showroom *showroom_new(int n)
{
    showroom *g = allocate(1, sizeof *g);
    const double f = 60;
    g->corner[0] = vec(-f, -f, 0), g->corner[1] = vec(f, -f, 0);
    g->corner[2] = vec(f, f, 0), g->corner[3] = vec(-f, f, 0);
    g->shapes[0] = shape_of_polygon(polygon_of(g->corner, 4));
    g->shapes[1] = showroom_ball(4.7, 2.6, 1.5);
    g->shapes[2] = showroom_ball(4.2, -3.2, 0.8);
    g->shapes[3] = showroom_ball(1.7, -4.4, 0.5);
    for (int i = 0; i < showroom_row; i++)  /* a row that leads away from the camera */
        g->shapes[4 + i] = showroom_ball(-1.0 - 1.15 * i, -5.6 + 2.3 * i, 0.42);
    g->light[0] = showroom_softbox(vec(-6, -5, 9), vec(0, 0, 1), 11,
                                   vec(430, 400, 350), g->corner + 4);
    vec3 lamp = vec(8.5, 0.6, 6.5);
    g->light[1] = (area_light){AREA_BALL, lamp, .r = 1.4, .colour = vec(24, 31, 44)};
    g->lamps[0] = shape_of_polygon(polygon_of(g->corner + 4, 4));
    g->lamps[1] = shape_of_sphere((sphere){lamp, g->light[1].r});
    g->pot = teapot_mesh(n);
    g->s = (scene){g->shapes, showroom_shapes}, g->lit = (scene){g->lamps, 2};
    world_part_of_scene(&g->s, MASK_ALL, &g->part[0]);
    world_part_of_mesh(&g->pot, MASK_ALL, &g->part[1]);
    world_part_of_scene(&g->lit, MASK_SEEN, &g->part[2]);
    return g;
}

static inline void showroom_free(showroom *g)
{
    for (int k = 0; k < showroom_parts; k++) world_part_free(&g->part[k]);
    mesh_free(&g->pot);
    free(g);
}

/* A softbox is black from behind. */
static inline material showroom_lamp(const showroom_look *k, trace_hit x, const surface *s)
{
    const area_light *L = &k->light[x.h.shape];
    vec3 ke = area_light_radiance(L);
    if (L->kind != AREA_BALL && vdot(s->n, L->n) < (real)0.5) ke = (vec3){0, 0, 0};
    return (material){.ke = ke};
}

static inline material showroom_material(const void *context, trace_hit x, const surface *s)
{
    enum { coloured = 4, copper = 7 };  /* the balls of the row, by turns; the teapot */
    static const double look[][7] = {   /* kd, ks, shine */
        {0.62, 0.58, 0.5, 0, 0, 0, 1}, {0.02, 0.02, 0.02, 0.8, 0.8, 0.82, 1500},
        {0.04, 0.025, 0.01, 0.75, 0.62, 0.38, 40}, {0.1, 0.3, 0.12, 0.06, 0.06, 0.06, 4000},
        {0.62, 0.06, 0.04, 0.05, 0.05, 0.05, 2000}, {0.8, 0.5, 0.05, 0.05, 0.05, 0.05, 2000},
        {0.06, 0.2, 0.5, 0.05, 0.05, 0.05, 2000}, {0.1, 0.045, 0.025, 0.66, 0.4, 0.28, 70}};
    const showroom_look *k = context;
    uint32_t i = x.h.shape;
    if (x.part == 2) return showroom_lamp(k, x, s);
    const double *a = look[x.part == 1 ? copper : i < coloured ? i : coloured + i % 3];
    bool odd = ((int)floor((double)s->p.x / 1.5) + (int)floor((double)s->p.y / 1.5)) & 1;
    vec3 kd = vec(a[0], a[1], a[2]);
    if (x.part == 0 && i == 0 && odd) kd = vscale(kd, (real)0.35);
    real shine = k->effects & LOOK_GLOSSY ? (real)a[6] : real_infinity;
    if (x.part == 1 && k->pot_shine != 0) shine = k->pot_shine;
    return (material){.kd = kd, .ks = vec(a[3], a[4], a[5]), .shine = shine};
}

static inline void showroom_set(showroom_look *k, const showroom *g, int effects)
{
    vec3 sky = {0.27, 0.34, 0.46};
    k->g = g, k->effects = effects, k->pot_shine = 0;
    k->w = (trace_world){g->part, effects & LOOK_SOFT ? 3 : 2};  /* no size: not to be seen */
    for (int i = 0; i < 2; i++) k->light[i] = g->light[i];
    for (int i = 0; i < 2 && !(effects & LOOK_SOFT); i++)
        k->light[i].a = k->light[i].b = (vec3){0, 0, 0}, k->light[i].r = 0;
    k->how = (distributed){.light = k->light, .n = 2, .material_of = showroom_material,
                           .context = k, .background = sky, .ambient = sky, .depth = 4,
                           .reach = effects & LOOK_SKY ? real_infinity : 0};
}

static inline distributed_view showroom_view(const showroom_look *k, showroom_shot shot,
                                             real aspect)
{
    static const double look[showroom_shots][8] = {  /* from, to, degrees, focus */
        {1.6, -15, 4.6, -0.4, 0, 1.15, 30, 14.4}, {1.6, -15, 4.6, 0.2, 0, 1.6, 16, 14.4}};
    const double *l = look[shot];
    distributed_view v = {.w = &k->w, .how = &k->how, .kind = SEQUENCE_SOBOL, .seed = 1};
    v.c = camera_at(vec(l[0], l[1], l[2]), vec(l[3], l[4], l[5]), vec(0, 0, 1), (real)l[6], aspect);
    v.lens = (thin_lens){k->effects & LOOK_LENS ? (real)0.22 : 0, (real)l[7]};
    return v;
}

#endif
