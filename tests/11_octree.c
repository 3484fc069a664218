/* Every hit of the octree equals brute force, whatever its options, and so does the walk by slab
 * tests; the textbook's walk and the one without delta do not. The tree itself: 11_tree.c. */
#include "../chapters/11_octree/lab/variants.h"
#include "../chapters/11_octree/octree.h"
#include "structure.h"

static octree_options how;

STRUCTURE_TESTED(octree, how)
static bool find_slabs(const void *s, ray r, hit *out) { return octree_hit_slabs(s, r, out); }

static void test_options(void)
{
    const octree_options list[] = {{1, 6, true, true, (size_t)1 << 30},
                                   {4, 20, false, true, (size_t)1 << 30},
                                   {16, 10, true, false, (size_t)1 << 30},
                                   {3, 1, false, false, (size_t)1 << 30},
                                   {100000, 16, true, true, (size_t)1 << 30}};  /* root is a leaf */
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        structure s = {"octree of other options", STRUCTURE_OF(octree)};
        how = list[i];
        structure_tests(&s, check_count(150));
    }
    structure s = {"octree, slab tests", octree_built, find_slabs, octree_any, octree_gone};
    how = octree_defaults;
    how.leaf = 4;
    structure_tests(&s, check_count(200));
}

/* The naive walks fail on dyadic meshes, by kind of ray. `least`: per cent of the rays. */
typedef bool search(const octree *t, ray r, hit *out);

static size_t wrong_of(search *walk, const octree *t, const items *x, const mesh *m, int kind,
                       size_t n)
{
    size_t wrong = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(17, i, 0);
        ray r = aimed(m, &g, kind, (vec3){0, 0, 0}, 1);
        hit a = hit_none, b = hit_none;
        bool ga = items_hit(x, r, &a), gb = walk(t, r, &b);
        wrong += !same(ga, a, gb, b);
    }
    return wrong;
}

static void test_naive(void)
{
    mesh list[2] = {floors_mesh(4), octahedron_mesh(8)};
    size_t n = check_count(1000), textbook[3] = {0}, unpadded = 0, ours = 0;
    for (int i = 0; i < 2; i++) {
        items x = items_of_mesh(&list[i]);
        octree t;
        failure f;
        how = (octree_options){4, 6, true, true, (size_t)1 << 26};
        check(octree_build(&x, how, &t, &f), "built");
        textbook[0] += wrong_of(octree_hit_textbook, &t, &x, &list[i], 4, n);
        textbook[1] += wrong_of(octree_hit_textbook, &t, &x, &list[i], 1, n);
        textbook[2] += wrong_of(octree_hit_textbook, &t, &x, &list[i], 5, n);
        for (int kind = 0; kind < aimed_kinds; kind++) {
            unpadded += wrong_of(octree_hit_unpadded, &t, &x, &list[i], kind, n / 4);
            ours += wrong_of(octree_hit, &t, &x, &list[i], kind, n / 4);
        }
        octree_free(&t);
        mesh_free(&list[i]);
    }
    check_at_least(textbook[0], n / 2, "textbook: (-inf + inf) / 2: rays along axes are lost");
    check_at_least(textbook[1], n / 50, "textbook: rays at corners");
    check_at_least(textbook[2], n / 50, "textbook: rays from corner to corner");
    check_at_least(unpadded, n / 100, "no delta: a ray in a wall is put into one of two cells");
    check_equal(ours, 0, "octree_hit, the same rays");
}

/* A hit that lies beyond the cell is not final. The cube is [0, 8]^3, cut once. The ray comes along
 * +x at y = z = 1; triangle 0 reaches into the first cell and is hit at x = 7, in the second, where
 * triangle 1 is before it, at x = 5, so t = 6. */
static void test_beyond_the_cell(void)
{
    mesh m = mesh_room(3);
    items x = items_of_mesh(&m);
    octree t;
    failure f;
    ray r = ray_from((vec3){-1, 1, 1}, (vec3){1, 0x1p-10, 0x1p-9});
    hit h = hit_none, naive = hit_none;
    set_triangle(&m, 0, (vec3){0, 3, 0}, (vec3){8, (real)5 / 7, 0}, (vec3){8, (real)5 / 7, 8});
    set_triangle(&m, 1, (vec3){5, 0, 0}, (vec3){5, 3, 0}, (vec3){5, 0, 3});
    set_triangle(&m, 2, (vec3){8, 8, 8}, (vec3){8, 8, 7}, (vec3){8, 7, 8});
    how = (octree_options){1, 1, true, true, (size_t)1 << 26};
    check(octree_build(&x, how, &t, &f) && t.size == 8 && t.depth == 1, "one cut");
    octree_hit(&t, r, &h), octree_hit_textbook(&t, r, &naive);
    check(h.shape == 1 && h.t == 6, "the nearer one is found, in the second cell");
    check(naive.shape == 0 && naive.t > 7, "textbook: ends at a hit beyond the first cell");
    octree_free(&t);
    mesh_free(&m);
}

/* Directions of any length, origins of any distance: t |d| overflows nothing that it should not. In
 * the small mesh and with long d, t is below real_smallest and has few digits. */
static void test_scales(real scale, size_t n)
{
    mesh m = torus_mesh(16);
    items x = items_of_mesh(&m);
    octree t;
    failure f;
    structure_verdict v = {0, 0, 0, 0};
    structure s = {"octree", STRUCTURE_OF(octree)};
    int most = real_is_float ? 125 : 1021, few = 0;
    how = octree_defaults;
    for (size_t i = 0; i < m.vertices; i++) m.v[i] = vscale(m.v[i], scale);
    check(octree_build(&x, how, &t, &f), "built");
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(23, i, 0);
        ray r = aimed(&m, &g, (int)(i % 8), (vec3){0, 0, 0}, scale);
        int e = (int)random_below(&g, (size_t)(2 * most)) - most;
        r.d = vscale(r.d, 1 / scale);
        r.d = (vec3){ldexp(r.d.x, e), ldexp(r.d.y, e), ldexp(r.d.z, e)};
        few += ldexp(scale, -e) < real_smallest;
        structure_ray(&s, &t, &x, r, &v);
        r.o = vscale(r.d, -1), r.tmin = -real_infinity;  /* from as far as it points */
        structure_compare(&s, &t, &x, r, &v);
    }
    check_equal(v.wrong + v.wrong_any, 0, "size %g, directions of 2^-%d to 2^%d", (double)scale,
                most, most);
    check_at_least(v.hits, v.rays / 4, "they hit");
    check(few > 0 || scale == 1 || n < 1000, "some t have few digits");
    octree_free(&t);
    mesh_free(&m);
}

/* Faces a little beyond the walls of cells, hit at a t of few digits: t |d_a|, taken back, may say
 * a place before the wall, by more than delta. All the same the cell behind it must be asked. */
static void test_few_digits(size_t n)
{
    mesh planes = floors_mesh(4), m = mesh_room(planes.triangles + 2);
    real beyond = 1 + (real_is_float ? (real)0x1p-10 : (real)0x1p-36), small = (real)0x1p-20;
    structure_verdict v = {0, 0, 0, 0};
    structure s = {"octree", STRUCTURE_OF(octree)};
    octree t;
    failure f;
    for (size_t i = 0; i < planes.triangles; i++) {
        triangle p = mesh_triangle(&planes, i);
        set_triangle(&m, i, p.a, p.b, p.c);
    }
    for (int k = 0; k < 2; k++) {  /* two dots that make the cube a little larger */
        vec3 dot = {k ? beyond : -beyond, k ? beyond : -beyond, k ? beyond : -beyond};
        set_triangle(&m, planes.triangles + (size_t)k, dot, dot, dot);
    }
    for (size_t i = 0; i < m.vertices; i++) m.v[i] = vscale(m.v[i], small);
    items x = items_of_mesh(&m);
    how = (octree_options){1, 6, true, true, (size_t)1 << 26};
    check(octree_build(&x, how, &t, &f), "built");
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(31, i, 0);
        vec3 o = random_in_cube(&g, 2), d = {0, 0, 0};
        ((real *)&d)[i % 3] = ldexp(1 + random_next(&g), real_is_float ? 125 : 1021);
        structure_ray(&s, &t, &x, ray_from(vscale(o, small), d), &v);
    }
    check_equal(v.wrong + v.wrong_any, 0, "t of few digits, faces just beyond a wall");
    check_at_least(v.hits, v.rays / 4, "they hit");
    octree_free(&t);
    mesh_free(&planes), mesh_free(&m);
}

/* 17 planes, one behind the other: the search ends at the first. */
static void test_ends_at_the_hit(void)
{
    mesh m = floors_mesh(16);
    items x = items_of_mesh(&m);
    octree t;
    failure f;
    search_work w = {0, 0, 0, 0};
    hit h;
    how = (octree_options){16, 6, true, true, (size_t)1 << 26};
    check(octree_build(&x, how, &t, &f), "built");
    check(octree_hit_counted(&t, ray_from(vec(-3, 0.03, 0.07), (vec3){1, 0, 0}), &h,
                             &w) && h.t == 2, "the first plane");
    check_at_most(w.leaves, 4, "leaves asked: those at the first plane alone");
    octree_free(&t);
    mesh_free(&m);
}

/* The same answers with and without counting; the mailbox saves tests, and no hit. */
static void test_counted(size_t n)
{
    mesh m = needles(2000, 0.05);
    items x = items_of_mesh(&m);
    octree with, without;
    failure f;
    search_work a = {0, 0, 0, 0}, b = {0, 0, 0, 0};
    size_t other = 0, hits = 0;
    how = octree_defaults;
    check(octree_build(&x, how, &with, &f), "built");
    how.mailbox = false;
    check(octree_build(&x, how, &without, &f), "built");
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(29, i, 0);
        ray r = aimed(&m, &g, 0, (vec3){0, 0, 0}, 1);
        hit h[4] = {hit_none, hit_none, hit_none, hit_none};
        bool got = octree_hit(&with, r, &h[0]);
        bool same_all = octree_hit_counted(&with, r, &h[1], &a) == got
                        && octree_hit_counted(&without, r, &h[2], &b) == got;
        search_work any = {0, 0, 0, 0};
        other += !same_all || !same(got, h[0], got, h[1]) || !same(got, h[0], got, h[2])
                 || octree_occluded_counted(&with, r, &any) != got
                 || octree_occluded(&without, r) != got;
        hits += got;
    }
    check_equal(other, 0, "counted or not, mailbox or not: the same hits");
    check_at_least(hits, n / 4, "rays hit needles");
    check(a.nodes == b.nodes && a.leaves == b.leaves, "the mailbox changes no walk");
    check_at_most((double)a.tests, 0.9 * (double)b.tests, "needles in many cells: tests saved");
    check(a.empty == 0 && a.leaves > 0, "no empty leaf is asked");
    octree_free(&with), octree_free(&without);
    mesh_free(&m);
}

int main(void)
{
    structure s = {"octree", STRUCTURE_OF(octree)};
    how = octree_defaults;
    structure_tests(&s, check_count(600));
    test_options();
    test_naive();
    test_beyond_the_cell();
    test_scales(1, check_count(4000));
    test_scales(0x1p-20, check_count(4000));
    test_few_digits(check_count(3000));
    test_ends_at_the_hit();
    test_counted(check_count(4000));
    structure_piled(octree, octree_defaults, 1.5 * structure_room(10000));
    return check_report("11_octree");
}
