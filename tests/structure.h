/* structure.h: the tests that every acceleration structure must pass: its answers are those of
 * brute force, bit for bit, on rays and meshes that are made to break it.
 *
 *   STRUCTURE_TESTED(octree, how)     its verbs, built with the options `how`: constant or variable
 *   structure s = {"octree", STRUCTURE_OF(octree)};     or {name, build, hit, occluded, destroy}
 *   structure_tests(&s, rays);      some 75 checks; `rays` of them a mesh; 600 take half a second
 *   structure_brief(&s, rays);      of other options: what is hardest of it, some 20 checks
 *   structure_attack(&s, what, &x, rays, seed, next, context);      next makes the i-th ray
 *
 *   octree t = octree_made(&x, how);                     built, or the program ends
 *   structure_piled(octree, octree_defaults, 400, most);      triangles upon triangles: see below
 *   structure_ends(octree, octree_defaults, rays);            a search ends with its hit
 *   structure_limited(octree, octree_defaults, mesh, code);   no byte less than the peak suffices
 *
 * build returns what hit and occluded take, or NULL with the failure filled in. Where there are
 * counting searches, one ray of four asks them, too.
 */
#ifndef TESTS_STRUCTURE_H
#define TESTS_STRUCTURE_H

#include "../chapters/07_mesh/scenes/specimens.h"
#include "../chapters/09_aabb/items.h"
#include "../chapters/07_mesh/scenes/stadium.h"
#include "aimed.h"
#include "check.h"
#include "wrong_ray.h"

typedef struct {
    const char *name;
    void *(*build)(const items *x, failure *f);
    bool (*hit)(const void *s, ray r, hit *out);
    bool (*occluded)(const void *s, ray r);
    void (*destroy)(void *s);
    bool (*counted)(const void *s, ray r, hit *out, search_work *w);  /* out NULL: any hit */
} structure;

typedef struct { size_t rays, hits, wrong, wrong_any; } structure_verdict;
typedef ray structure_ray_of(const items *x, random_stream *g, size_t i, const void *context);

#define STRUCTURE_OF(X) X##_built, X##_finds, X##_any, X##_gone, X##_counts
#define STRUCTURE_TESTED(X, how)                                                                 \
    static void *X##_built(const items *x, failure *f)                                           \
    {                                                                                            \
        void *s = allocate(1, sizeof(X));                                                        \
        if (X##_build(x, how, s, f)) return s;                                                   \
        free(s);                                                                                 \
        return NULL;                                                                             \
    }                                                                                            \
    static inline X X##_made(const items *x, X##_options rules)                                  \
    {                                                                                            \
        X s;                                                                                     \
        failure f;                                                                               \
        if (!X##_build(x, rules, &s, &f)) fail(f);                                               \
        return s;                                                                                \
    }                                                                                            \
    static bool X##_finds(const void *s, ray r, hit *out) { return X##_hit(s, r, out); }         \
    static bool X##_any(const void *s, ray r) { return X##_occluded(s, r); }                     \
    static void X##_gone(void *s) { X##_free(s), free(s); }                                      \
    static bool X##_counts(const void *s, ray r, hit *out, search_work *w)                       \
    {                                                                                            \
        return out ? X##_hit_counted(s, r, out, w) : X##_occluded_counted(s, r, w);              \
    }

/* ---------------------------------------------------------------------------------------------- */

/* The hit of brute force; t is infinite on a miss. */
static inline hit structure_compare(const structure *s, const void *built, const items *x, ray r,
                                    structure_verdict *v)
{
    hit a = hit_none, b = hit_none, c = hit_none;
    search_work w = {0, 0, 0, 0};
    bool ga = items_hit(x, r, &a), gb = s->hit(built, r, &b), wrong = !same(ga, a, gb, b);
    if (s->counted && v->rays % 4 == 0) {
        wrong |= !same(ga, a, s->counted(built, r, &c, &w), c) || w.tests < ga;
        wrong |= w.empty > w.leaves;
        v->wrong_any += s->counted(built, r, NULL, &w) != ga;
    }
    if (wrong && s->name) print_wrong(s->name, r, a, b);  /* no name: it is meant to be wrong */
    v->rays++, v->hits += ga, v->wrong += wrong;
    v->wrong_any += s->occluded(built, r) != ga;
    return a;
}

static inline void *structure_build(const structure *s, const items *x, const char *what)
{
    failure f;
    items gone = *x;
    void *built = s->build(&gone, &f);
    gone = (items){.n = 0};  /* what it needs of x it has copied */
    check(built && gone.n == 0, "%s, %s: built; says: %s", s->name, what, built ? "" : f.text);
    return built;
}

/* The ray, and then the same ending exactly at its hit, and [t, t]: the interval is closed. */
static inline void structure_ray(const structure *s, const void *built, const items *x, ray r,
                                 structure_verdict *v)
{
    hit h = structure_compare(s, built, x, r, v);
    for (int way = 1; way < aimed_ways && h.shape != no_shape; way++)
        structure_compare(s, built, x, aimed_way(r, h.t, way), v);
}

static inline void structure_attack(const structure *s, const char *what, const items *x,
                                    size_t rays, uint64_t seed, structure_ray_of *next,
                                    const void *context)
{
    structure_verdict v = {0, 0, 0, 0};
    void *built = structure_build(s, x, what);
    if (!built) return;
    for (size_t i = 0; i < rays; i++) {
        random_stream g = random_start(seed, i, 0);
        structure_ray(s, built, x, next(x, &g, i, context), &v);
    }
    check_equal(v.wrong, 0, "%s, %s: %zu of %zu rays hit; wrong", s->name, what, v.hits, v.rays);
    check_equal(v.wrong_any, 0, "%s, %s: occluded, yet no hit, or the reverse", s->name, what);
    check_at_least(v.hits, v.rays / 5, "%s, %s: rays aimed at it hit it", s->name, what);
    s->destroy(built);
}

typedef struct { vec3 move; real scale, away; } structure_place;

static inline ray structure_aimed(const items *x, random_stream *g, size_t i, const void *context)
{
    const structure_place *p = context;
    ray r = aimed(x->m, g, (int)(i % aimed_kinds), p->move, p->scale);
    if (p->away > 0) {
        vec3 at = x->m->v[x->m->index[random_below(g, 3 * x->m->triangles)]];
        r.o = vadd(p->move, random_in_cube(g, p->away * p->scale)), r.d = vsub(at, r.o);
    }
    return r;
}

/* `away` > 0: the rays begin that many times farther away. Frees m. */
static inline void structure_mesh(const structure *s, const char *what, mesh m, size_t rays,
                                  vec3 move, real scale, real away)
{
    const structure_place place = {move, scale, away};
    for (size_t i = 0; i < m.vertices; i++) m.v[i] = vadd(vscale(m.v[i], scale), move);
    items x = items_of_mesh(&m);
    structure_attack(s, what, &x, rays, 31, structure_aimed, &place);
    mesh_free(&m);
}

/* From anywhere in a cube, or from far away, at anything in it. */
static inline ray structure_any_ray(const items *x, random_stream *g, size_t i, const void *sick)
{
    if (sick && i < sick_count) return sick_ray[i];
    vec3 o = random_in_cube(g, sick ? 3 : i % 2 ? 2 : 100);
    return (void)x, ray_from(o, vsub(random_in_cube(g, 1), o));
}

static inline void structure_meshes(const structure *s, size_t rays)
{
    const vec3 home = {0, 0, 0}, off = {1000, -2000, 3000};
    structure_mesh(s, "octahedron, dyadic size", octahedron_mesh(4), rays, home, 0x1p-10, 0);
    structure_mesh(s, "torus", torus_mesh(16), rays, home, 1, 0);
    structure_mesh(s, "torus, tiny", torus_mesh(16), rays, home, 1e-12, 0);
    structure_mesh(s, "torus, of subnormal numbers", torus_mesh(16), rays, home,
                   8 * real_smallest * real_epsilon * 1000, 0);
    structure_mesh(s, "torus, huge", torus_mesh(16), rays, home, 1e6, 0);
    structure_mesh(s, "torus, flat", torus_mesh(12), rays, home, 0x1p-70, 0);
    structure_mesh(s, "torus, from 100 away", torus_mesh(16), rays, home, 1, 100);
    structure_mesh(s, "torus, from 1e6 away", torus_mesh(16), rays, home, 1, 1e6);
    structure_mesh(s, "torus, from afar", torus_mesh(16), rays, home, 1,
                   real_is_float ? (real)1e7 : (real)1e13);
    structure_mesh(s, "planes", floors_mesh(4), rays, home, 1, 0);
    structure_mesh(s, "planes, moved", floors_mesh(4), rays, off, 0.1, 0);
    structure_mesh(s, "torus, of a few hundred floats", torus_mesh(16), rays, off,
                   (real)1e6 * real_epsilon, 0);
    structure_mesh(s, "planes, likewise", floors_mesh(4), rays, off, (real)1e6 * real_epsilon, 0);
    structure_mesh(s, "needles", needles(300, 1e-3), rays, home, 1, 0);
    structure_mesh(s, "teapot", teapot_mesh(3), rays, home, 3, 0);
    structure_mesh(s, "stadium", stadium_mesh(3), rays, home, 3, 0);
}

/* All in one plane: a box of no thickness. */
static inline void structure_flat(const structure *s, size_t rays)
{
    for (int k = 0; k < 3; k++) {
        mesh m = torus_mesh(12);
        for (size_t i = 0; i < m.vertices; i++) ((real *)&m.v[i])[k] = 0.3;
        structure_mesh(s, "flat", m, rays, (vec3){0, 0, 0}, 1, 0);
    }
}

static inline void structure_none(const structure *s)
{
    mesh m = mesh_room(1);
    ray r = ray_from(vec(0.25, 0.25, -1), (vec3){0, 0, 1});
    hit h = {7, 7, 7, 7};
    set_triangle(&m, 0, (vec3){0, 0, 1}, (vec3){1, 0, 1}, (vec3){0, 1, 1});
    for (size_t n = 0; n < 2; n++) {
        m.triangles = n;
        items x = items_of_mesh(&m);
        void *built = structure_build(s, &x, n ? "one triangle" : "nothing");
        if (!built) continue;
        if (n == 0)
            check(!s->hit(built, r, &h) && h.t == 7 && !s->occluded(built, r),
                  "%s: no triangles are never hit, and `out` stays", s->name);
        else
            check(s->hit(built, r, &h) && h.t == 2 && h.u == (real)0.25 && h.v == (real)0.25
                      && h.shape == 0 && s->occluded(built, r),
                  "%s: one triangle: hit at t = 2", s->name);
        s->destroy(built);
    }
    mesh_free(&m);
}

/* n times the triangle a b c; each a little larger than the one before, by the factor of grow. */
static inline mesh structure_copies(size_t n, vec3 a, vec3 b, vec3 c, double grow)
{
    mesh m = mesh_room(n);
    for (size_t i = 0; i < n; i++) {
        real x = (real)exp(log(grow) * (double)i);
        set_triangle(&m, i, vscale(a, x), vscale(b, x), vscale(c, x));
    }
    return m;
}

/* n plates one behind another along z, and a ray through all of them from either end: whoever looks
 * at the nearer part first, and ends the ray at each hit, asks those of one leaf and no others. */
static inline mesh structure_plates(size_t n)
{
    mesh m = mesh_room(n);
    for (size_t i = 0; i < n; i++) {
        real z = (real)i;
        set_triangle(&m, i, vec(-0.3, -0.3, z), vec(0.3, -0.3, z), vec(0, 0.3, z));
    }
    return m;
}

static inline ray structure_through(size_t n, bool from_end)
{
    return ray_from(vec(0.01, 0.02, from_end ? (double)n : -1), (vec3){0, 0, from_end ? -1 : 1});
}

/* n triangles on one place: the lowest index wins; every third one a copy in front. */
static inline void structure_ties(const structure *s, size_t n)
{
    mesh m = mesh_room(n);
    ray r = ray_from(vec(0.25, 0.25, -1), (vec3){0, 0, 1});
    for (int front = 0; front < 2; front++) {
        for (size_t i = 0; i < n; i++) {
            real z = front && i % 3 == 2 ? 1 : 2;
            set_triangle(&m, i, (vec3){0, 0, z}, (vec3){1, 0, z}, (vec3){0, 1, z});
        }
        items x = items_of_mesh(&m);
        hit h = hit_none;
        void *built = structure_build(s, &x, "coincident triangles");
        if (!built) continue;
        check(s->hit(built, r, &h), "%s: %zu coincident triangles are hit", s->name, n);
        check_equal(h.shape, front ? 2 : 0, "%s: the lowest index of the nearest", s->name);
        s->destroy(built);
    }
    mesh_free(&m);
}

/* Needles, of which one of eight is NaN, a point, a line, or (ends) infinite. */
static inline mesh structure_sick_mesh(size_t n, bool ends)
{
    mesh m = needles(n, 0.1);
    real nan = (real)NAN, inf = real_infinity;
    for (size_t i = 0; i < n; i += 8) {
        vec3 *v = m.v + 3 * i;
        switch (i / 8 % (ends ? 6 : 4)) {
        case 0: v[i / 32 % 3].x = nan; break;
        case 1: v[1] = v[2] = v[0]; break;
        case 2: v[2] = v[1]; break;
        case 3: v[0] = v[1] = v[2] = (vec3){nan, nan, nan}; break;
        case 4: v[1].y = inf; break;
        default: v[2].z = -inf; break;
        }
    }
    return m;
}

static inline void structure_sick(const structure *s, size_t rays)
{
    mesh m = structure_sick_mesh(600, true);
    items x = items_of_mesh(&m);
    structure_attack(s, "sick triangles", &x, rays, 5, structure_any_ray, &x);
    mesh_free(&m);
}

/* |d| from the least to the largest real: 1 / d overflows, or t has lost digits. */
static inline ray structure_long_ray(const items *x, random_stream *g, size_t i,
                                     const void *context)
{
    int most = real_is_float ? FLT_MAX_EXP - 3 : DBL_MAX_EXP - 3, range = i % 3 ? 12 : 2 * most;
    ray r = aimed(x->m, g, (int)(i % 8), (vec3){0, 0, 0}, 1);
    int e = most - (int)random_below(g, (size_t)range);
    if (i % 2) e = -e;
    r.d = (vec3){ldexp(r.d.x, e), ldexp(r.d.y, e), ldexp(r.d.z, e)};
    return (void)context, r;
}

static inline void structure_lengths(const structure *s, size_t rays)
{
    mesh m = torus_mesh(16);
    items x = items_of_mesh(&m);
    structure_attack(s, "long and short directions", &x, rays, 21, structure_long_ray, NULL);
    mesh_free(&m);
}

/* Triangles 2^k apart and 2^k large: cells of one size hold one or all. */
static inline ray structure_exponential_ray(const items *x, random_stream *g, size_t i,
                                            const void *context)
{
    triangle t = mesh_triangle(x->m, random_below(g, x->m->triangles));
    vec3 o = {-t.a.x * random_next(g), t.b.y * random_next(g), t.b.y * random_next(g)};
    vec3 at = vadd(t.a, vscale((vec3){0, random_next(g), random_next(g)}, t.b.y / 2));
    return (void)i, (void)context, ray_from(o, vsub(at, o));
}

static inline void structure_exponential(const structure *s, size_t rays)
{
    int most = real_is_float ? 50 : 400;
    mesh m = mesh_room((size_t)most);
    for (int i = 0; i < most; i++) {
        real x = ldexp((real)1, i - most / 2);
        set_triangle(&m, (size_t)i, (vec3){x, 0, 0}, (vec3){x, x / 8, 0}, (vec3){x, 0, x / 8});
    }
    items x = items_of_mesh(&m);
    structure_attack(s, "exponentially spaced", &x, rays, 6, structure_exponential_ray, NULL);
    mesh_free(&m);
}

static bool structure_ball_hit(const void *self, ray r, hit *out)
{
    return sphere_hit(*(const sphere *)self, r, out);
}

static vec3 structure_ball_normal(const void *self, hit h, vec3 p)
{
    return (void)h, sphere_normal(*(const sphere *)self, p);
}

/* Spheres, cones, polygons, triangles and what brings its own functions together; ties; one in a
 * hundred is no number. */
static inline void structure_shapes(const structure *s, size_t rays)
{
    enum { n = 400 };
    shape *all = allocate(n, sizeof *all);
    vec3 *corner = allocate(4 * n, sizeof *corner);
    sphere *ball = allocate(n, sizeof *ball);
    shape_other *other = allocate(n, sizeof *other);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(8, i, 0);
        vec3 a = random_in_cube(&g, 1), e = random_in_cube(&g, 0.2), b = vadd(a, e);
        vec3 f = random_in_cube(&g, 0.2), *q = corner + 4 * i;
        real r = (real)0.1 * random_next(&g);
        q[0] = a, q[1] = b, q[2] = vadd(b, f), q[3] = vadd(a, f);
        ball[i] = (sphere){a, r};
        other[i] = (shape_other){structure_ball_hit, structure_ball_normal, &ball[i], a, a};
        shape_bounds(shape_of_sphere(ball[i]), &other[i].lo, &other[i].hi);
        switch (i % 5) {
        case 0: all[i] = shape_of_sphere(ball[i]); break;
        case 1: all[i] = shape_of_cone((cone){a, r, b, r / 2}); break;
        case 2: all[i] = shape_of_polygon(polygon_of(q, 4)); break;
        case 3: all[i] = shape_of_other(&other[i]); break;
        default: all[i] = shape_of_triangle((triangle){a, b, vadd(a, f)}); break;
        }
        if (i % 100 == 99) all[i] = shape_of_sphere((sphere){{(real)NAN, 0, 0}, 1});
        if (i % 100 == 98) all[i] = all[i - 1];  /* a tie: the lower index wins */
        if (i == 50) all[i] = shape_of_sphere((sphere){{0, 0, -30}, 29});  /* much larger */
    }
    scene shapes = {all, n};
    items x = items_of_scene(&shapes);
    structure_attack(s, "shapes of all kinds", &x, rays, 9, structure_any_ray, NULL);
    free(all), free(corner), free(ball), free(other);
}

/* What is too large is refused with a message, not cut wrongly. */
static inline void structure_too_large(const structure *s)
{
    mesh m = mesh_room(1);
    failure f;
    set_triangle(&m, 0, (vec3){0, 0, 0}, (vec3){3 * items_most, 0, 0}, (vec3){0, 1, 0});
    items x = items_of_mesh(&m);
    void *built = s->build(&x, &f);
    check(!built && f.exit_code == 2 && strstr(f.text, "coordinates up to"),
          "%s: a coordinate of %g is refused", s->name, 3 * (double)items_most);
    mesh_free(&m);
}

/* The fan of a star with n corners (an OBJ file's, if the star is one face): each triangle lies on
 * hundreds of others, and no cut parts them. */
static inline mesh structure_fan(size_t n)
{
    mesh m = mesh_room(n - 2);
    for (size_t i = 0; i + 2 < n; i++) {
        vec3 p[2];
        for (size_t k = 0; k < 2; k++) {
            real a = 2 * pi * (real)(i + k + 1) / (real)n, far = (i + k) % 2 ? 1 : (real)0.5;
            p[k] = (vec3){far * cos(a), far * sin(a), 0};
        }
        set_triangle(&m, i, (vec3){1, 0, 0}, p[0], p[1]);
    }
    return m;
}

/* Builds X of a fan: it names items no more often than `most`, and finds what brute force does. So
 * many corners that without a limit there would be more: 9.1 million of 400 in 11, 30 million of
 * 3000 in 12, 5.9 million of 3000 in 13. The grid makes larger cells from some 10000 on. These are
 * seconds, so `make test` takes a tenth of the corners, which no limit cuts short; all are there in
 * `make soak`, and in float (.ci/run) with the counts of `make test`. */
static inline size_t structure_corners(size_t all)
{
    return check_count(80) == 80 || (real_is_float && check_count(80) == 10) ? all : all / 10;
}

#define structure_piled(X, options, corners, most)                                               \
    do {                                                                                         \
        mesh fan = structure_fan(structure_corners(corners));                                    \
        items in = items_of_mesh(&fan);                                                          \
        failure why = {0, ""};                                                                   \
        X built;                                                                                 \
        size_t wrong = 0;                                                                        \
        check(X##_build(&in, options, &built, &why), #X " of a fan: %s", why.text);              \
        if (structure_corners(corners) == (corners))  /* of fewer the limit says nothing */      \
            check_at_most((double)X##_stats(&built).references, most, #X " of a fan: references"); \
        for (int i = 0; i < 100; i++) {                                                          \
            vec3 at = vec(0.17 * (i % 10) - 0.8, 0.17 * (i / 10) - 0.8, 3);                      \
            vec3 to = vec(0.01, 0.02, -1);                                                       \
            hit a = hit_none, b = hit_none;                                                      \
            bool ga = items_hit(&in, ray_from(at, to), &a);                                      \
            wrong += !same(ga, a, X##_hit(&built, ray_from(at, to), &b), b);                     \
        }                                                                                        \
        check_equal(wrong, 0, #X " of a fan");                                                   \
        X##_free(&built), mesh_free(&fan);                                                       \
    } while (0)

/* From anywhere within the cube of half a side `far` through the one of `near`. */
static inline ray structure_across(uint64_t seed, size_t i, real far, real near)
{
    random_stream g = random_start(seed, i, 0);
    vec3 o = random_in_cube(&g, far);
    return ray_from(o, vsub(random_in_cube(&g, near), o));
}

/* As many steps as for the same ray that ends at its hit from the start. */
#define structure_ends(X, options, rays)                                                         \
    do {                                                                                         \
        mesh torus = torus_mesh(24);                                                             \
        items x = items_of_mesh(&torus);                                                         \
        X built = X##_made(&x, options);                                                         \
        search_work whole = {0, 0, 0, 0}, ended = whole;                                         \
        for (size_t i = 0; i < (rays); i++) {                                                    \
            ray r = structure_across(15, i, 3, 1);                                               \
            hit h;                                                                               \
            if (X##_hit_counted(&built, r, &h, &whole)) r.tmax = h.t;                            \
            X##_hit_counted(&built, r, &h, &ended);                                              \
        }                                                                                        \
        check_equal(whole.nodes, ended.nodes, #X ": steps, and of rays that end at their hits"); \
        X##_free(&built), mesh_free(&torus);                                                     \
    } while (0)

/* With fewer bytes than the peak that it tells there is no structure, but a reason. Takes m. */
#define structure_limited(X, options, m, code)                                                   \
    do {                                                                                         \
        mesh all = m;                                                                            \
        items x = items_of_mesh(&all);                                                           \
        X##_options rules = options;                                                             \
        X built = X##_made(&x, rules);                                                           \
        const size_t peak = X##_stats(&built).peak;                                              \
        size_t taken = 0, odd = 0;                                                               \
        X##_free(&built);                                                                        \
        const size_t none = X##_stats(&built).bytes;                                             \
        for (size_t k = 0; k <= 50; k++) {                                                       \
            failure f = {0, ""};                                                                 \
            rules.most_bytes = k < 50 ? peak / 50 * k : peak - 1;                                \
            taken += X##_build(&x, rules, &built, &f);                                           \
            odd += f.exit_code != (code) || X##_stats(&built).bytes != none;                     \
            X##_free(&built);                                                                    \
        }                                                                                        \
        check_equal(taken + odd, 0, #X ": with less than its peak refused, and nothing left");   \
        rules.most_bytes = peak;                                                                 \
        check(X##_build(&x, rules, &built, NULL), #X ": fits into its peak of %zu", peak);       \
        X##_free(&built), mesh_free(&all);                                                       \
    } while (0)

/* Corners in dyadic planes and beside them; far out; edge-on; ties; no numbers; round shapes. */
static inline void structure_brief(const structure *s, size_t rays)
{
    const vec3 home = {0, 0, 0}, off = {1000, -2000, 3000};
    structure_mesh(s, "octahedron", octahedron_mesh(8), rays, home, 1, 0);
    structure_mesh(s, "torus, moved", torus_mesh(16), rays, off, 1, 0);
    structure_mesh(s, "planes, thirds", floors_mesh(3), rays, home, 1, 0);
    structure_mesh(s, "thin needles", needles(300, 1e-7), rays, home, 1, 0);
    structure_ties(s, 100);
    structure_sick(s, 2 * rays);
    structure_shapes(s, 2 * rays);
}

static inline void structure_tests(const structure *s, size_t rays)
{
    structure_brief(s, rays);
    structure_meshes(s, rays);
    structure_flat(s, rays);
    structure_none(s);
    structure_exponential(s, 2 * rays), structure_lengths(s, 2 * rays);
    structure_too_large(s);
}

#endif
