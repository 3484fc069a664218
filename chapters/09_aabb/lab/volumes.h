/* volumes.h: two other volumes round the same points, to compare with the box: the bounding sphere
 * (包围球) and the oriented box (有向包围盒, OBB), a box that may be turned; and how often a ray that
 * hits the volume hits nothing in it (误报).
 *
 *   sphere b = ball_round(p, n);           its radius within 0.2 % of the smallest
 *   aabb_turned u = turned_round(p, n);    a turned box, of less surface than the aabb has: by 3000
 *                                          small turns; a search, not the optimum
 *   bounding_ball_hit(&b, 1 / d.d, r, &t_enter)   as aabb_hit: no false negative, t_enter not late;
 *   turned_hit(&u, r, &t_enter)            what passes within 32 epsilon of the distance is a hit
 *   ray r = line_through(b, seed, i)       the i-th of lines that come from everywhere alike,
 *                                          through the sphere round the box b
 *   aabb_content c = content_of(k);        shape k [0..2]: needle, ball, teapot, and the volumes
 *                                          round it; the caller frees c.t
 *   content_hit(&c, kind, r, &t)           is the volume hit? 0: sphere, 1: box, 2: turned box
 *   content_in_vain(&c, seed, n, vain)     of n lines that hit a volume: those that hit nothing
 *                                          inside [%]; returns how many hit something, and not
 *                                          its volume
 *
 * Sources: M. Bădoiu, K. Clarkson, "Smaller core-sets for balls", SODA 2003 (the sphere: go 1/i of
 * the way to the farthest point, in step i); S. Gottschalk, M. Lin, D. Manocha, "OBBTree", SIGGRAPH
 * 1996 (turned boxes).
 */
#ifndef AABB_VOLUMES_H
#define AABB_VOLUMES_H

#include "../../03_sphere/first.h"
#include "../../04_triangle/scenes/icosphere.h"
#include "../../07_mesh/scenes/teapot.h"
#include "../aabb.h"

enum { content_shapes = 3, content_kinds = 3 };
typedef struct { vec3 axis[3]; aabb b; } aabb_turned;  /* axes: unit, at right angles; b: in them */
typedef struct {
    triangle *t;
    size_t n;
    sphere ball;
    aabb box, room;  /* room: round all three; lines are those through the sphere round it */
    aabb_turned turned;
} aabb_content;

/* ---------------------------------------------------------------------------------------------- */

/* A direction from all alike, and a point from all alike in the disc across it that covers the
 * sphere round the box: each line through that sphere is as likely as any other. */
static inline ray line_through(aabb b, uint64_t seed, uint64_t i)
{
    random_stream s = random_start(seed, i, 0);
    vec3 d = random_unit(&s), u, v;
    real reach = vlength(vsub(b.hi, b.lo)) / 2, r = reach * sqrt(random_next(&s));
    real a = 2 * pi * random_next(&s);
    vbasis(d, &u, &v);
    vec3 o = vmadd(vmadd(aabb_centre(b), u, r * cos(a)), v, r * sin(a));
    return ray_from(vmadd(o, d, -2 * reach), d);
}

static inline vec3 farthest_from(vec3 c, const vec3 *p, size_t n)
{
    vec3 best = c;
    for (size_t i = 0; i < n; i++) {
        vec3 w = vsub(p[i], c), most = vsub(best, c);
        if (vdot(w, w) > vdot(most, most)) best = p[i];
    }
    return best;
}

static inline sphere ball_round(const vec3 *p, size_t n)
{
    sphere b = {p[0], 0};
    for (int i = 1; i <= 1000; i++)
        b.c = vmadd(b.c, vsub(farthest_from(b.c, p, n), b.c), 1 / (real)(i + 1));
    b.r = vlength(vsub(farthest_from(b.c, p, n), b.c)) * (1 + 4 * real_epsilon);
    return b;
}

/* l is the way from the ray, where it is nearest, to the centre: a hit if |l| <= R. */
static inline bool bounding_ball_hit(const sphere *b, real inverse_dd, ray r, real *t_enter)
{
    vec3 f = vsub(b->c, r.o);
    real middle = vdot(f, r.d) * inverse_dd, rr = b->r * b->r;
    vec3 l = vmadd(f, r.d, -middle);
    real in = rr - vdot(l, l) + 32 * real_epsilon * (rr + vdot(f, f));
    if (!(in >= 0)) return false;
    real half = sqrt(in * inverse_dd);
    if (!(middle + half >= r.tmin && middle - half <= r.tmax)) return false;
    *t_enter = real_max(middle - half, r.tmin);
    return true;
}

static inline vec3 turned_into(const aabb_turned *u, vec3 v)
{
    return (vec3){vdot(u->axis[0], v), vdot(u->axis[1], v), vdot(u->axis[2], v)};
}

static inline bool turned_hit(const aabb_turned *u, ray r, real *t_enter)
{
    r.o = turned_into(u, r.o), r.d = turned_into(u, r.d);
    real room = 3 * (vlargest(vabs(r.o)) + aabb_reach(u->b));
    return aabb_hit(first_aabb_pad(u->b, room * 32 * real_epsilon), r, t_enter);
}

static inline aabb turned_fit(const aabb_turned *u, const vec3 *p, size_t n)
{
    aabb b = aabb_empty();
    for (size_t i = 0; i < n; i++) b = aabb_grow_point(b, turned_into(u, p[i]));
    return b;
}

static inline aabb_turned turned_round(const vec3 *p, size_t n)
{
    aabb_turned best = {.axis = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    best.b = turned_fit(&best, p, n);
    for (uint64_t i = 0; i < 3000; i++) {  /* turns of up to 90 degrees, then ever smaller ones */
        random_stream s = random_start(1, i, 7);
        aabb_turned u = best;
        real step = pow((real)0.997, (real)i);
        u.axis[0] = vunit(vmadd(u.axis[0], random_in_cube(&s, 1), step));
        u.axis[1] = vmadd(u.axis[1], random_in_cube(&s, 1), step);
        u.axis[2] = vunit(vcross(u.axis[0], u.axis[1]));
        u.axis[1] = vcross(u.axis[2], u.axis[0]);
        u.b = turned_fit(&u, p, n);
        if (!vzero(u.axis[2]) && aabb_area(u.b) < aabb_area(best.b)) best = u;
    }
    return best;
}

/* ---- a shape in its three volumes ---- */

static inline aabb_content content_of(int k)
{
    const triangle needle = {{0, 0, 0}, {1, 1, 1}, {0.51, 0.49, 0.5}};
    icosphere ball = icosphere_new(3, (vec3){0, 0, 0}, 1);
    mesh pot = teapot_mesh(5);
    aabb_content c = {.n = k == 0 ? 1 : k == 1 ? ball.triangles : pot.triangles};
    c.t = allocate(c.n, sizeof *c.t), c.box = aabb_empty();
    for (size_t i = 0; i < c.n; i++) {
        c.t[i] = k == 0 ? needle : k == 1 ? icosphere_triangle(&ball, (uint32_t)i)
                                          : mesh_triangle(&pot, i);
        c.box = aabb_union(c.box, first_triangle_box(c.t[i]));
    }
    c.ball = ball_round(&c.t->a, 3 * c.n), c.turned = turned_round(&c.t->a, 3 * c.n);
    c.room = aabb_union(c.box, first_aabb_pad((aabb){c.ball.c, c.ball.c}, c.ball.r));
    vec3 middle = {0, 0, 0};  /* of the turned box */
    for (int a = 0; a < 3; a++)
        middle = vmadd(middle, c.turned.axis[a], vaxis(aabb_centre(c.turned.b), a));
    real half = vlength(vsub(c.turned.b.hi, c.turned.b.lo)) / 2;
    c.room = aabb_union(c.room, first_aabb_pad((aabb){middle, middle}, half));
    icosphere_free(&ball), mesh_free(&pot);
    return c;
}

static inline bool content_hit(const aabb_content *c, int kind, ray r, real *t)
{
    if (kind == 0) return bounding_ball_hit(&c->ball, 1 / vdot(r.d, r.d), r, t);
    return kind == 1 ? aabb_hit(c->box, r, t) : turned_hit(&c->turned, r, t);
}

static inline size_t content_in_vain(const aabb_content *c, uint64_t seed, size_t n,
                                     double vain[content_kinds])
{
    size_t hits[content_kinds] = {0}, good = 0, lost = 0;
    for (size_t i = 0; i < n; i++) {
        ray line = line_through(c->room, seed, i);
        bool in[content_kinds], inside = false;
        real t;
        hit h;
        for (int k = 0; k < content_kinds; k++) hits[k] += in[k] = content_hit(c, k, line, &t);
        if (!in[0] && !in[1] && !in[2]) continue;
        for (size_t j = 0; j < c->n && !inside; j++) inside = triangle_hit(c->t[j], line, &h);
        good += inside;
        for (int k = 0; k < content_kinds; k++) lost += inside && !in[k];
    }
    for (int k = 0; k < content_kinds; k++)
        vain[k] = hits[k] ? 100 * (double)(hits[k] - good) / (double)hits[k] : 0;
    return lost;
}

#endif
