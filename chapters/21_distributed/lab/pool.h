/* pool.h: five balls on a table, two of them moving: Cook's picture of 1984, with other numbers.
 *
 *   pool *g = pool_new(moves);                 moves: 1, or less for a shorter exposure; pool_free
 *   distributed_view v = pool_view(g, aspect);
 *
 * Each ball's number is on a white disk at a pole of its own; 9 to 15 are white with a stripe.
 */
#ifndef DISTRIBUTED_POOL_H
#define DISTRIBUTED_POOL_H

#include "../../../common/lab/label.h"
#include "showroom.h"

enum { pool_balls = 5, pool_moving = 2, pool_rest = pool_balls - pool_moving };

typedef struct {
    shape shapes[1 + pool_balls], *ball, lamps[2];  /* the cloth, and the balls */
    vec3 corner[12];
    scene rest, fast[pool_moving], lit;
    world_part part[2], fast_part[pool_moving];  /* cloth and balls at rest; lamps */
    trace_world w;
    moving moving[pool_moving];
    area_light light[2];
    distributed how;
} pool;

/* ---------------------------------------------------------------------------------------------- */

/* x, y; where its number is; the way; the last two of them move. */
static const struct { double x, y, face[3], way[2]; int number; vec3 colour; }
    pool_ball[pool_balls] = {
        {-2.35, 1.0, {0.1, -0.75, 0.7}, {0, 0}, 1, {0.85, 0.55, 0.04}},
        {0.3, 1.35, {0.25, -0.7, 0.68}, {0, 0}, 8, {0.02, 0.02, 0.025}},
        {-0.95, -0.75, {-0.2, -0.66, 0.75}, {0, 0}, 9, {0.85, 0.55, 0.04}},
        {2.6, 0.35, {-0.05, -0.7, 0.72}, {0.75, 0.4}, 4, {0.28, 0.06, 0.4}},
        {1.3, -1.75, {0, 0, 1}, {0.75, 0.95}, 0, {0.8, 0.76, 0.66}}};

/* Paint at the point n [unit] of ball i: its number, the disk around it, a stripe or its colour. */
static inline vec3 pool_paint(int i, vec3 n)
{
    vec3 white = {(real)0.8, (real)0.76, (real)0.66}, black = {(real)0.02, (real)0.02, (real)0.02};
    const double *f = pool_ball[i].face;
    vec3 w = vunit(vec(f[0], f[1], f[2])), a = vunit(vcross((vec3){0, 0, 1}, w)), b = vcross(w, a);
    double x = (double)vdot(n, a), y = (double)vdot(n, b), z = (double)vdot(n, w);
    if (pool_ball[i].number == 0) return white;
    if (z > 0 && x * x + y * y < 0.15) {
        const double unit = 0.068;  /* a digit is 4 units wide (half letters) and 6 high */
        const char *strokes = label_strokes((char)('0' + pool_ball[i].number));
        double u = x / unit + (label_advance((char)('0' + pool_ball[i].number)) - 1.75) / 2;
        return label_distance(strokes, u, y / unit + 3) < 0.75 ? black : white;
    }
    return pool_ball[i].number > 8 && fabs(y) > 0.6 ? white : pool_ball[i].colour;
}

/* By the place in the frame of time 0, so that the paint goes along. The cloth first: a ball that
 * moves leaves the point where it lay. */
static inline material pool_material(const void *context, trace_hit x, const surface *s)
{
    const pool *g = context;
    (void)x;
    if ((double)s->p.z < 1e-3)
        return (material){.kd = vec(0.02, 0.2, 0.1), .shine = 1};
    for (int i = 0; i < pool_balls; i++) {
        vec3 n = vsub(s->p, g->ball[i].sphere.c);
        if (fabs((double)vlength(n) - 1) < 1e-3)
            return (material){.kd = pool_paint(i, vunit(n)), .ks = vec(0.06, 0.06, 0.06),
                              .shine = 3000};
    }
    int lamp = s->p.x < 0 ? 0 : 1;
    return (material){.ke = vdot(s->n, g->light[lamp].n) > (real)0.5
                                ? area_light_radiance(&g->light[lamp]) : (vec3){0, 0, 0}};
}

static inline pool *pool_new(double moves)
{
    pool *g = allocate(1, sizeof *g);
    const double f = 40;
    for (int k = 0; k < 4; k++)
        g->corner[k] = vec(k == 0 || k == 3 ? -f : f, k < 2 ? -f : f, 0);
    g->shapes[0] = shape_of_polygon(polygon_of(g->corner, 4)), g->ball = g->shapes + 1;
    for (int i = 0; i < pool_balls; i++)
        g->ball[i] = shape_of_sphere((sphere){vec(pool_ball[i].x, pool_ball[i].y, 1), 1});
    vec3 middle = {0, 0, 1};
    g->light[0] = showroom_softbox(vec(-7, 3, 10), middle, 4.5, vec(330, 310, 270), g->corner + 4);
    g->light[1] = showroom_softbox(vec(6, 6, 9), middle, 2.5, vec(70, 80, 105), g->corner + 8);
    for (int k = 0; k < 2; k++)
        g->lamps[k] = shape_of_polygon(polygon_of(g->corner + 4 + 4 * k, 4));
    vec3 dusk = {(real)0.16, (real)0.13, (real)0.12};
    g->rest = (scene){g->shapes, 1 + pool_rest}, g->lit = (scene){g->lamps, 2};
    world_part_of_scene(&g->rest, MASK_ALL, &g->part[0]);
    world_part_of_scene(&g->lit, MASK_SEEN, &g->part[1]);
    g->w = (trace_world){g->part, 2};
    for (int k = 0; k < pool_moving; k++) {
        const double *way = pool_ball[pool_rest + k].way;
        g->fast[k] = (scene){g->ball + pool_rest + k, 1};
        world_part_of_scene(&g->fast[k], MASK_ALL, &g->fast_part[k]);
        g->moving[k] = (moving){{&g->fast_part[k], 1}, vec(moves * way[0], moves * way[1], 0)};
    }
    g->how = (distributed){.light = g->light, .n = 2, .moving = g->moving, .movers = pool_moving,
                           .material_of = pool_material, .context = g, .background = dusk,
                           .ambient = dusk, .reach = real_infinity, .depth = 3};
    return g;
}

static inline void pool_free(pool *g)
{
    for (int k = 0; k < 2; k++) world_part_free(&g->part[k]);
    for (int k = 0; k < pool_moving; k++) world_part_free(&g->fast_part[k]);
    free(g);
}

static inline distributed_view pool_view(const pool *g, real aspect)
{
    camera c = camera_at(vec(-0.4, -11, 8.2), vec(0.45, 0.1, 0.55), vec(0, 0, 1), 26, aspect);
    return (distributed_view){.w = &g->w, .how = &g->how, .c = c, .kind = SEQUENCE_SOBOL,
                              .seed = 1};
}

#endif
