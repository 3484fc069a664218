/* 07_trials.h: random questions aimed where cones and polygons may fail, and how often they do.
 *
 *   random_stream s = random_start(seed, ..);
 *   cone_score x = cone_play(&s, kind, aim, distance, rays, close);      against 07_oracle.h
 *   gear_box b;  gear_box_fill(&b, &s, translation, triangles);          a closed gear wheel
 *   size_t slips = gear_box_slips(&b, &s, rays, naive);           rays from inside that hit nothing
 *
 * The tests demand 0 wrong answers of the default functions; hard-cases counts those of the naive.
 */
#ifndef TESTS_07_TRIALS_H
#define TESTS_07_TRIALS_H

#include "../chapters/07_mesh/lab/naive.h"
#include "../chapters/07_mesh/lab/trials.h"
#include "../chapters/07_mesh/scene.h"
#include "07_oracle.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct { const char *name; real ra, rb; } cone_kind;
enum { cone_kind_count = 7 };
typedef enum { AIM_RANDOM, AIM_GRAZING, AIM_ALONG_AXIS, AIM_ALONG_SIDE, aim_count } cone_aim;

static const cone_kind cone_kinds[cone_kind_count] = {
    {"cylinder", 0.5, 0.5}, {"cone", 0.5, 0}, {"cone, tip first", 0, 0.75},
    {"truncated cone", 0.5, 0.2}, {"tip to tip", 0.5, -0.3},
    {"needle", 1e-3, 1e-3}, {"thin needle", 1e-6, 1e-6}};

/* Ends on a lattice of 2^-8, so that b - a is exact, and the tested cone is the oracle's. */
static inline cone some_cone(random_stream *s, int kind)
{
    const real k = 256;
    vec3 a = random_in_cube(s, 1), d = direction(s), b = vmadd(a, d, random_between(s, 0.5, 1.5));
    a = (vec3){round(k * a.x) / k, round(k * a.y) / k, round(k * a.z) / k};
    b = (vec3){round(k * b.x) / k, round(k * b.y) / k, round(k * b.z) / k};
    return (cone){a, cone_kinds[kind].ra, b, cone_kinds[kind].rb};
}

/* A point of the side, the direction of its generator (母线), and its normal, from (7.5). */
static inline vec3 point_of_side(cone c, real u, real angle, vec3 *generator, vec3 *normal)
{
    vec3 w = vsub(c.b, c.a), s, t;
    vbasis(vunit(w), &s, &t);
    vec3 out = vadd(vscale(s, cos(angle)), vscale(t, sin(angle)));
    real radius = c.ra + (c.rb - c.ra) * u;
    *generator = vunit(vmadd(w, out, c.rb - c.ra));
    *normal = vunit(vcross(vcross(*generator, out), *generator));
    if (radius < 0) *normal = vneg(*normal);
    return vmadd(vmadd(c.a, w, u), out, radius);
}

/* |D| from 1 to 8, from once to twice the distance, aimed at or near a point of the side. */
static inline ray ray_at_cone(random_stream *x, cone c, cone_aim aim, real distance)
{
    real radius = real_max(fabs(c.ra), fabs(c.rb)), off = random_between(x, -1, 1) * radius,
         a = random_between(x, -pi, pi);
    real u = random_between(x, 0, 1), round_axis = random_between(x, -pi, pi),
         tiny = pow((real)10, random_between(x, -9, -3));
    real far = distance * random_between(x, 1, 2), length = random_between(x, 1, 8);
    vec3 g, n, s, t, d = direction(x), p = point_of_side(c, u, round_axis, &g, &n);
    vbasis(n, &s, &t);
    if (aim == AIM_GRAZING) d = vadd(vscale(s, cos(a)), vscale(t, sin(a)));
    if (aim == AIM_ALONG_AXIS) d = vunit(vmadd(vunit(vsub(c.b, c.a)), d, tiny));
    if (aim == AIM_ALONG_SIDE) d = vunit(vmadd(g, d, tiny));
    if (aim == AIM_GRAZING) p = vmadd(p, n, off / 1000);  /* within 0.1 % of the radius */
    if (aim >= AIM_ALONG_AXIS) p = vmadd(p, n, off / 2);
    return ray_from(vmadd(p, d, -far), vscale(d, length));
}

/* wrong: hit instead of miss or the reverse, or the other one of the two hits. residual: distance
 * of the point at t from the side, in units of epsilon (1 + distance); worst of all. [0] naive,
 * [1] default. */
typedef struct { size_t decided, hits, wrong[2]; double residual[2]; } cone_score;

/* Rays whose margin is below `close` epsilon are left out: the call may go either way. */
static inline cone_score cone_play(random_stream *s, int kind, cone_aim aim, real distance,
                                   size_t rays, double close)
{
    bool (*const method[2])(cone, ray, hit *) = {cone_hit_naive, cone_hit};
    cone_score score = {0, 0, {0, 0}, {0, 0}};
    for (size_t i = 0; i < rays; i++) {
        cone c = some_cone(s, kind);
        ray r = ray_at_cone(s, c, aim, distance);
        cone_truth truth = cone_exact(c, r);
        if (truth.margin < close * (double)real_epsilon) continue;
        score.decided++;
        score.hits += truth.hit;
        for (int k = 0; k < 2; k++) {
            hit h;
            bool is = method[k](c, r, &h);
            score.wrong[k] += is != truth.hit;
            if (!is || !truth.hit) continue;
            score.wrong[k] +=
                fabs((double)h.t - truth.t) > truth.apart / 2 + (double)(8 * real_epsilon * h.t);
            double off = cone_residual(c, r, h.t);
            double unit = (double)(real_epsilon * (1 + h.t * vlength(r.d)));
            score.residual[k] = fmax(score.residual[k], off / unit);
        }
    }
    return score;
}

/* ---------------------------------------------------------------------------------------------- */

enum { box_corners = 144 };
typedef struct {
    vec3 top[box_corners], bottom[box_corners], side[box_corners][4], inner;
    shape shapes[2 + 2 * box_corners];
    size_t n;
} gear_box;

static inline void gear_box_turn(vec3 *v, real z, vec3 axis, vec3 offset)
{
    vec3 s, t;
    vbasis(axis, &s, &t);
    for (int i = 0; i < box_corners; i++)
        v[i] = vadd(vmadd(vadd(vscale(s, v[i].x), vscale(t, v[i].y)), axis, z), offset);
}

/* A gear wheel of SPD's proportions, radius 1: two 144-gons and 144 quads, or 288 triangles
 * instead. */
static inline void gear_box_fill(gear_box *b, random_stream *s, real translation, bool triangles)
{
    vec3 offset = vscale(vec(1, 0.7, -0.3), translation), axis = direction(s);
    gear(b->top, box_corners / 4, 1, 0.9);
    gear(b->bottom, box_corners / 4, 1, 0.9);
    gear_box_turn(b->top, 0.25, axis, offset);
    gear_box_turn(b->bottom, -0.25, axis, offset);
    b->n = 0, b->inner = vscale(vadd(b->top[0], b->bottom[box_corners / 2]), 0.5);
    b->shapes[b->n++] = shape_of_polygon(polygon_of(b->top, box_corners));
    b->shapes[b->n++] = shape_of_polygon(polygon_of(b->bottom, box_corners));
    for (int i = 0; i < box_corners; i++) {
        int j = (i + 1) % box_corners;
        vec3 *q = b->side[i];
        q[0] = b->bottom[i], q[1] = b->bottom[j], q[2] = b->top[j], q[3] = b->top[i];
        if (triangles) {
            b->shapes[b->n++] = shape_of_triangle((triangle){q[0], q[1], q[2]});
            b->shapes[b->n++] = shape_of_triangle((triangle){q[0], q[2], q[3]});
        } else b->shapes[b->n++] = shape_of_polygon(polygon_of(q, 4));
    }
}

/* From inside to a corner, or to a point of an edge, of the top or between two sides. */
static inline ray gear_box_ray(const gear_box *b, random_stream *s, size_t i)
{
    const vec3 *q = b->side[(size_t)random_between(s, 0, box_corners - 1)];
    vec3 aim = i % 4 < 2 ? q[2] : vmadd(q[2], vsub(i % 2 ? q[1] : q[3], q[2]),
                                        random_between(s, 0, 1));
    vec3 o = vmadd(b->inner, direction(s), 0.1);
    return ray_from(o, vsub(aim, o));
}

static inline size_t gear_box_slips(const gear_box *b, random_stream *s, size_t rays, bool naive)
{
    size_t slips = 0;
    for (size_t i = 0; i < rays; i++) {
        ray r = gear_box_ray(b, s, i);
        ray_shear k = shear_of(r);
        bool is = false;
        hit h;
        for (size_t j = 0; j < b->n && !is; j++)
            is = naive && b->shapes[j].kind == SHAPE_POLYGON
                     ? polygon_hit_naive(b->shapes[j].polygon, r, &h)
                     : shape_hit_sheared(&b->shapes[j], &k, r, &h);
        slips += !is;
    }
    return slips;
}

#endif
