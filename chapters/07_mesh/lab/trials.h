/* trials.h: who is inside? Random questions aimed where a method may fail, and how often it does.
 *
 *   random_stream s = random_start(seed, ..);
 *   inside_score y = inside_play(&torus, &s, aim, points);          against the ring's own distance
 *
 *   bool inside_parity_naive(&m, p, d)  parity by the watertight test: at a vertex several are hit
 *   bool inside_vote(&m, p, k)          majority of k naive parities [odd, 1..15], k directions; it
 *                                       needs a nearly closed mesh, of any orientation; k n tests
 *
 * The tests demand 0 wrong answers of the default methods; main.c prints what all of them reach.
 */
#ifndef MESH_LAB_TRIALS_H
#define MESH_LAB_TRIALS_H

#include "../../../common/random.h"
#include "../closest.h"
#include "../inside.h"
#include "../scenes/as_first.h"
#include "../scenes/specimens.h"

static inline vec3 direction(random_stream *s)
{
    real z = random_between(s, -1, 1), a = random_between(s, -pi, pi), r = sqrt(1 - z * z);
    return (vec3){r * cos(a), r * sin(a), z};
}

/* ---------------------------------------------------------------------------------------------- */

enum { inside_methods = 6, inside_of_hits = 2 };  /* the first two count hits, not crossings */
static const char *const inside_names[inside_methods] = {
    "first", "parity of hits", "parity of crossings", "vote of 3", "vote of 5", "winding number"};

/* Wrong: an octahedron and a ray from its middle to a vertex. Four triangles meet there, the
 * watertight test rightly reports all four, and four is even. */
static inline bool inside_parity_naive(const mesh *m, vec3 p, vec3 d)
{
    ray r = ray_from(p, d);
    ray_shear k = shear_of(r);
    hit h;
    size_t hits = 0;
    for (size_t i = 0; i < m->triangles; i++) hits += mesh_triangle_hit(m, i, &k, r, &h);
    return hits % 2 == 1;
}

/* Direction i of k, spread over the sphere along a spiral, turned so that none lies along an
 * axis, where the edges of made-up meshes like to lie. */
static inline vec3 inside_direction(int i, int k)
{
    real z = 1 - (2 * (real)i + (real)0.8124) / (real)k, a = (real)i * (real)2.39996 + (real)0.6180;
    real r = sqrt(real_max(1 - z * z, 0));
    return (vec3){r * cos(a), r * sin(a), z};
}

static inline bool inside_vote(const mesh *m, vec3 p, int k)
{
    int inside = 0;
    for (int i = 0; i < k; i++) inside += inside_parity_naive(m, p, inside_direction(i, k));
    return 2 * inside > k;
}

/* Of a triangle seen from the origin, between -2 pi and 2 pi: (7.3) as it stands. */
static inline double solid_angle(vec3 a, vec3 b, vec3 c)
{
    double x, y;
    solid_angle_half(a, b, c, &x, &y);
    return 2 * atan2(y, x);
}

/* How many rays method k casts in directions of its own; 0: in the one it is given, or none. */
static inline int inside_votes(int method) { return method == 3 ? 3 : method == 4 ? 5 : 0; }

/* `soup` has the triangles of m. */
static inline bool inside_ask(int method, const mesh *m, const first_mesh *soup, vec3 p, vec3 d)
{
    switch (method) {
    case 0: return first_mesh_inside(soup, p, d);
    case 1: return inside_parity_naive(m, p, d);
    case 2: return inside_parity(m, p, d);
    case 3: case 4: return inside_vote(m, p, inside_votes(method));
    default: return inside_winding(m, p);
    }
}

typedef enum { AT_RANDOM, AT_EDGE, AT_VERTEX } inside_aim;

/* A point of torus_mesh(24) that is surely inside or surely outside, and a direction, so that the
 * ray is aimed: the flat triangles lie up to 0.011 within and 0.005 without the round ring. A vote
 * of `votes` looks along directions of its own: there the point is put so that one of them is d. */
static inline bool inside_question(const mesh *torus, random_stream *s, inside_aim at, int votes,
                                   vec3 *p, vec3 *d)
{
    real ring;
    do {
        triangle t = mesh_triangle(torus, (size_t)random_between(s, 0, (real)torus->triangles - 1));
        vec3 aim = at == AT_EDGE ? vmadd(t.a, vsub(t.b, t.a), random_between(s, 0, 1)) : t.a;
        *p = vmul(random_in_cube(s, 1), vec(1, 1, 0.3));
        *d = at == AT_RANDOM ? direction(s) : vsub(aim, *p);
        if (votes && at != AT_RANDOM) {
            *d = inside_direction((int)random_between(s, 0, (real)votes), votes);
            *p = vmadd(aim, *d, -random_between(s, 0, 1));
        }
        ring = hypot(hypot(p->x, p->y) - (real)0.75, p->z);
    } while (ring > (real)0.235 && ring < (real)0.255);
    return ring < (real)0.25;
}

typedef struct { size_t asked, wrong[inside_methods]; } inside_score;

/* The winding number casts no ray that could be aimed: it is asked at random points alone. */
static inline inside_score inside_play(const mesh *torus, random_stream *s, inside_aim at,
                                       size_t points)
{
    inside_score score = {points, {0}};
    first_mesh soup = first_mesh_of(torus);
    random_stream before = *s;
    for (int k = 0; k < inside_methods - (at != AT_RANDOM); k++) {
        *s = before;
        for (size_t i = 0; i < points; i++) {
            vec3 p, d;
            bool inside = inside_question(torus, s, at, inside_votes(k), &p, &d);
            score.wrong[k] += inside_ask(k, torus, &soup, p, d) != inside;
        }
    }
    first_mesh_free(&soup);
    return score;
}

#endif
