/* first_structure.h: what the first programs' structures, first.h of 10 to 14, have to do: find
 * brute force's hits on easy input and at edges and corners, come to an end on any input, within
 * bounds of memory and depth, and be wrong where their tops say so: far away.
 *
 *   FIRST_STRUCTURE(first_grid, *s = first_grid_build(m))      its verbs: s from the mesh m
 *   FIRST_TREE(X, X_node, 8, n->n)     X_items_of (n->n in node n) and X_depth_of of a tree X
 *   first_structure s = {"grid", FIRST_VERBS(first_grid), items_of, depth_of, 100, most_depth};
 *   first_structure_tests(&s, &full);     full: the chapter's own structure, see structure.h
 *
 * Brute force is first_mesh_hit: the same triangle test, so the same bits of t.
 */
#ifndef FIRST_STRUCTURE_H
#define FIRST_STRUCTURE_H

#include "../chapters/07_mesh/scenes/as_first.h"
#include "structure.h"

typedef struct {
    const char *name;
    void *(*build)(const first_mesh *m);
    bool (*hit)(const void *s, ray r, hit *out);
    void (*destroy)(void *s);
    size_t (*items)(const void *s);  /* in all lists together, or nodes */
    int (*depth)(const void *s);
    double most_items;               /* for each triangle */
    double (*most_depth)(double n);  /* of n triangles, log2 n given */
} first_structure;

typedef struct { size_t rays, hits, wrong, lost, full_wrong; } first_verdict;

#define FIRST_VERBS(X) X##_built, X##_finds, X##_gone
#define FIRST_STRUCTURE(X, make)                                                                 \
    static void *X##_built(const first_mesh *m)                                                  \
    {                                                                                            \
        X *s = allocate(1, sizeof *s); /* NOLINT(bugprone-macro-parentheses): a type */          \
        make;                                                                                    \
        return s;                                                                                \
    }                                                                                            \
    static bool X##_finds(const void *s, ray r, hit *out) { return X##_hit(s, r, out); }         \
    static void X##_gone(void *s) { X##_free(s), free(s); }

#define FIRST_TREE(X, X_node, ways, own)                                                         \
    static size_t X##_items_below(const X_node *n)                                               \
    {                                                                                            \
        size_t sum = (size_t)(own);                                                              \
        for (int c = 0; n->child && c < (ways); c++) sum += X##_items_below(&n->child[c]);       \
        return sum;                                                                              \
    }                                                                                            \
    static int X##_depth_below(const X_node *n)                                                  \
    {                                                                                            \
        int most = 0;                                                                            \
        for (int c = 0; n->child && c < (ways); c++) {                                           \
            int d = 1 + X##_depth_below(&n->child[c]);                                           \
            if (d > most) most = d;                                                              \
        }                                                                                        \
        return most;                                                                             \
    }                                                                                            \
    static size_t X##_items_of(const void *s) { return X##_items_below(&((const X *)s)->root); } \
    static int X##_depth_of(const void *s) { return X##_depth_below(&((const X *)s)->root); }

/* ---------------------------------------------------------------------------------------------- */

/* At the same t either of two triangles may be named. */
static inline hit first_compare(const first_structure *s, const void *built, const first_mesh *m,
                                ray r, first_verdict *v)
{
    hit a = hit_none, b = hit_none;
    bool due = first_mesh_hit(m, r, &a), got = s->hit(built, r, &b);
    v->rays++, v->hits += due;
    v->lost += due && !got;
    v->wrong += due != got || (due && a.t != b.t) || (!got && b.shape != no_shape);
    return b;
}

static inline mesh first_knot_mesh(int around, int sides)
{
    first_mesh k = first_knot(around, sides);
    mesh m = mesh_room((size_t)k.n);
    for (int i = 0; i < k.n; i++)
        set_triangle(&m, (size_t)i, k.tri[i].a, k.tri[i].b, k.tri[i].c);
    first_mesh_free(&k);
    return m;
}

/* An n x n chessboard in the plane z = 0.3. */
static inline mesh first_board(int n)
{
    mesh m = mesh_room((size_t)(2 * n * n));
    for (int i = 0; i < n * n; i++) {
        real x = 2 * (real)(i % n) / (real)n - 1, y = 2 * (real)(i / n) / (real)n - 1;
        real e = 2 / (real)n, z = 0.3;
        vec3 a = {x, y, z}, b = {x + e, y, z}, c = {x + e, y + e, z}, d = {x, y + e, z};
        set_triangle(&m, 2 * (size_t)i, a, b, c);
        set_triangle(&m, 2 * (size_t)i + 1, a, c, d);
    }
    return m;
}

/* Kinds of aimed.h: 0, 3 and 4 meet triangles anywhere, the others at edges and corners, where one
 * that is seen edge-on may have a t that is noise; in 6, along an edge, there always is one. Left
 * out are 8, which counts behind its origin, as (9.3) does not, and in float 10, whose t have lost
 * their digits to underflow. Two more, anywhere: from a point of the mesh on; down an axis with
 * d = -0.0. */
enum { first_kinds = aimed_kinds + 2 };
typedef enum { FIRST_ANYWHERE, FIRST_CORNER, FIRST_ALONG, first_places } first_place;

static inline first_place first_place_of(int kind)
{
    if (kind == 6) return FIRST_ALONG;
    return kind == 0 || kind == 3 || kind == 4 || kind == 8 || kind >= aimed_kinds
               ? FIRST_ANYWHERE : FIRST_CORNER;
}

static inline ray first_aimed(const mesh *m, random_stream *g, int kind, vec3 centre, real size)
{
    if (kind == 8 || (kind == 10 && real_is_float)) kind = 0;
    if (kind < aimed_kinds) return aimed(m, g, kind, centre, size);
    triangle t = mesh_triangle(m, random_below(g, m->triangles));
    vec3 p = vscale(vadd(t.a, vadd(t.b, t.c)), 1 / (real)3), axis = vneg((vec3){0, 0, 0});
    if (kind == aimed_kinds) return ray_from(p, random_in_cube(g, 1));
    ((real *)&axis)[random_below(g, 3)] = -1;
    return ray_from(vmadd(p, axis, -4 * size), axis);
}

/* Kind 0 is anywhere: there the full version has the same hits. */
static inline void first_structure_mesh(const first_structure *s, const structure *full,
                                        const char *what, mesh m, vec3 move, real scale)
{
    size_t n = check_count(400);
    first_verdict v[first_places] = {{0, 0, 0, 0, 0}}, *easy = &v[FIRST_ANYWHERE];
    for (size_t i = 0; i < m.vertices; i++) m.v[i] = vadd(vscale(m.v[i], scale), move);
    first_mesh f = first_mesh_of(&m);
    items x = items_of_mesh(&m);
    void *built = s->build(&f), *other = structure_build(full, &x, what);
    for (int kind = 0; kind < first_kinds; kind++)
        for (size_t i = 0; i < n; i++) {
            random_stream g = random_start(7, i, (uint64_t)kind);
            ray r = first_aimed(&m, &g, kind, move, scale);
            hit h = first_compare(s, built, &f, r, &v[first_place_of(kind)]), b = hit_none;
            if (kind != 0) continue;
            full->hit(other, r, &b);
            easy->full_wrong += first_is_wrong(h, b);
        }
    check_equal(easy->wrong, 0, "%s, %s: %zu of %zu rays hit; not as brute force", s->name, what,
                easy->hits, easy->rays);
    check_at_least(easy->hits, easy->rays / 5, "%s, %s: they hit", s->name, what);
    check_equal(v[FIRST_CORNER].lost, 0, "%s, %s: lost at edges and corners", s->name, what);
    check_at_most(v[FIRST_ALONG].lost, real_is_float ? n / 100 : 0, "%s, %s: lost along edges",
                  s->name, what);
    check_at_most(v[FIRST_CORNER].wrong, real_is_float ? v[FIRST_CORNER].rays / 200 : 0,
                  "%s, %s: another t at edges and corners", s->name, what);
    check_at_most(easy->full_wrong, real_is_float ? n / 200 : 0,
                  "%s, %s: not as the full version, of %zu anywhere", s->name, what, n);
    s->destroy(built), full->destroy(other);
    first_mesh_free(&f), mesh_free(&m);
}

static inline void first_structure_meshes(const first_structure *s, const structure *full)
{
    const vec3 home = {0, 0, 0}, off = {30, -20, 10}, beside = {0.1, 0.2, 0.3};
    first_structure_mesh(s, full, "knot", first_knot_mesh(60, 10), home, 1);
    first_structure_mesh(s, full, "knot, moved", first_knot_mesh(60, 10), off, 1);
    first_structure_mesh(s, full, "knot, tiny", first_knot_mesh(30, 6), home, 1e-6);
    first_structure_mesh(s, full, "knot, huge", first_knot_mesh(30, 6), home, 1e6);
    first_structure_mesh(s, full, "soup", soup_mesh(1000, 1, 0.2, 3), home, 1);
    first_structure_mesh(s, full, "board", first_board(20), home, 1);
    first_structure_mesh(s, full, "box", floors_mesh(1), home, 1);
    first_structure_mesh(s, full, "corners on walls", floors_mesh(4), home, 1);
    first_structure_mesh(s, full, "octahedron", octahedron_mesh(8), home, 1);
    first_structure_mesh(s, full, "corners an ulp beside", octahedron_mesh(8), beside, 1 / (real)3);
    first_structure_mesh(s, full, "needles", needles(1000, 1e-2), home, 1);
}

/* Memory and depth, and answers, on what is hard to cut. Frees m. */
static inline void first_structure_bounds(const first_structure *s, const char *what, mesh m,
                                          vec3 move)
{
    first_verdict v = {0, 0, 0, 0, 0};
    for (size_t i = 0; i < m.vertices; i++) m.v[i] = vadd(m.v[i], move);
    first_mesh f = first_mesh_of(&m);
    void *built = s->build(&f);
    double n = (double)m.triangles;
    for (size_t i = 0; n > 0 && i < check_count(60); i++) {
        random_stream g = random_start(11, i, 0);
        first_compare(s, built, &f, aimed(&m, &g, (int)(i % 4), move, 1), &v);
    }
    check_equal(v.wrong, 0, "%s, %s: not as brute force", s->name, what);
    check_at_most((double)s->items(built), s->most_items * n + 1, "%s, %s: items of %g triangles",
                  s->name, what, n);
    check_at_most(s->depth(built), s->most_depth(log2(n + 1)), "%s, %s: depth", s->name, what);
    s->destroy(built);
    first_mesh_free(&f), mesh_free(&m);
}

static inline void first_structure_hard(const first_structure *s)
{
    const vec3 home = {0, 0, 0}, far = {1e4, 1e4, 1e4};
    size_t n = check_count(10000);
    first_structure_bounds(s, "long triangles", soup_mesh(n, 1, 1, 3), home);
    first_structure_bounds(s, "longer ones", soup_mesh(n, 1, 2, 3), home);
    first_structure_bounds(s, "middling ones", soup_mesh(n, 1, 0.3, 3), home);
    first_structure_bounds(s, "long needles", needles(n, 1e-3), home);
    first_structure_bounds(s, "far from the origin", soup_mesh(n, 1, 0.1, 3), far);
    first_structure_bounds(s, "one needle, often", structure_copies(n, (vec3){-1, 0, 0},
                           (vec3){1, 0, 0}, vec(1, 1e-4, 1e-4), 1), home);
    first_structure_bounds(s, "one across, often", structure_copies(n, (vec3){-1, -1, -1},
                           (vec3){1, 1, 1}, vec(1, 1, 0.9), 1), home);
    first_structure_bounds(s, "2^-60 to 1", structure_copies(n, (vec3){-1, 0, 0}, (vec3){-1, 1, 0},
                           (vec3){-1, 0, 1}, exp(-60 * log(2) / (double)n)), home);
    first_structure_bounds(s, "nothing", mesh_room(0), home);
}

/* Sick triangles and rays. Where one reaches to infinity any answer will do, but one it must be. */
static inline void first_structure_sick(const first_structure *s)
{
    for (int ends = 0; ends < 2; ends++) {
        first_verdict v = {0, 0, 0, 0, 0};
        mesh m = structure_sick_mesh(2000, ends);
        first_mesh f = first_mesh_of(&m);
        void *built = s->build(&f);
        for (size_t i = 0; i < check_count(1000); i++) {
            random_stream g = random_start(5, i, 0);
            vec3 o = random_in_cube(&g, 3);
            first_compare(s, built, &f, ray_from(o, vsub(random_in_cube(&g, 1), o)), &v);
        }
        for (size_t i = 0; i < sick_count; i++) first_compare(s, built, &f, sick_ray[i], &v);
        check(ends || v.wrong == 0, "%s: sick triangles and rays: %zu wrong", s->name, v.wrong);
        s->destroy(built);
        first_mesh_free(&f), mesh_free(&m);
    }
}

static inline void first_structure_few(const first_structure *s)
{
    mesh m = mesh_room(2000);
    ray r = ray_from(vec(0.25, 0.25, -1), (vec3){0, 0, 1});
    for (size_t i = 0; i < 2000; i++)
        set_triangle(&m, i, (vec3){0, 0, 1}, (vec3){1, 0, 1}, (vec3){0, 1, 1});
    for (size_t n = 0; n <= 2000; n = n ? n * 2000 : 1) {
        hit h = {7, 7, 7, 7};
        m.triangles = n;
        first_mesh f = first_mesh_of(&m);
        void *built = s->build(&f);
        bool got = s->hit(built, r, &h);
        if (n == 0) check(!got && h.t == 7, "%s: nothing is never hit", s->name);
        else check(got && h.t == 2 && h.shape < n, "%s: %zu triangles: hit at 2", s->name, n);
        check_at_most((double)s->items(built), s->most_items * (double)n + 1, "%s: one place",
                      s->name);
        s->destroy(built);
        first_mesh_free(&f);
    }
    mesh_free(&m);
}

/* At points in the triangles of a knot of size 7, from `away` such sizes. */
static inline first_verdict first_structure_from(const first_structure *s, const structure *full,
                                                 real away, size_t n)
{
    first_verdict v = {0, 0, 0, 0, 0};
    structure_verdict w = {0, 0, 0, 0};
    mesh m = first_knot_mesh(60, 10);
    first_mesh f = first_mesh_of(&m);
    items x = items_of_mesh(&m);
    void *built = s->build(&f), *other = structure_build(full, &x, "knot");
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(17, i, 0);
        triangle t = f.tri[random_below(&g, (size_t)f.n)];
        real a = random_next(&g), b = (1 - a) * random_next(&g);
        vec3 o = vscale(vunit(random_in_cube(&g, 1)), 7 * away);
        ray r = ray_from(o, vsub(barycentric_mix(t.a, t.b, t.c, a, b), o));
        first_compare(s, built, &f, r, &v);
        if (i % 10 == 0) structure_compare(full, other, &x, r, &w);
    }
    v.full_wrong = w.wrong;
    s->destroy(built), full->destroy(other);
    first_mesh_free(&f), mesh_free(&m);
    return v;
}

/* What the top of first.h says. Brute force has the same triangle test: the structure errs. */
static inline void first_structure_far(const first_structure *s, const structure *full)
{
    size_t n = check_count(5000) < 2000 ? 2000 : check_count(5000);  /* fewer show no share */
    real most = real_is_float ? (real)1e4 : (real)1e13;
    first_verdict near = first_structure_from(s, full, most / 100, n);
    first_verdict at = first_structure_from(s, full, most, n);
    first_verdict far = first_structure_from(s, full, 10 * most, n);
    first_verdict out = first_structure_from(s, full, 100 * most, n);
    check_equal(near.wrong, 0, "%s: wrong from %g sizes", s->name, (double)most / 100);
    check_at_most((double)at.wrong, (double)n / 200 + 1, "%s: wrong from %g", s->name,
                  (double)most);
    check_at_least((double)far.wrong, (double)n / 250, "%s: wrong from 10 times that", s->name);
    check_at_least((double)out.wrong, (double)n / 4, "%s: wrong from 100 times that", s->name);
    check_at_least((double)out.lost, (double)n / 250, "%s: lost there", s->name);
    check_equal(near.full_wrong + at.full_wrong + far.full_wrong + out.full_wrong, 0,
                "%s: the full version is right at all distances", s->name);
}

static inline void first_structure_tests(const first_structure *s, const structure *full)
{
    first_structure_meshes(s, full);
    first_structure_hard(s);
    first_structure_sick(s);
    first_structure_few(s);
    first_structure_far(s, full);
}

#endif
