/* structures.h: hard cases of 09 to 17: boxes, and trees that must find what brute force finds. */
#ifndef HARD_STRUCTURES_H
#define HARD_STRUCTURES_H

#include "../../chapters/07_mesh/scenes/specimens.h"
#include "../../chapters/09_aabb/lab/slabs.h"
#include "../../chapters/10_grid/lab/drift.h"
#include "../../chapters/11_octree/lab/variants.h"
#include "../../chapters/12_kdtree/lab/textbook.h"
#include "../../chapters/13_bsp/lab/naive.h"
#include "../../chapters/14_bvh/lab/naive.h"
#include "../../chapters/15_wide_bvh/lab/leaky.h"
#include "../../chapters/16_instances/first.h"
#include "../../chapters/16_instances/lab/flattened.h"
#include "../../chapters/16_instances/lab/naive.h"
#include "../../chapters/17_compare/lab/contenders.h"
#include "../../chapters/09_aabb/trials/torture.h"
#include "../aimed.h"
#include "hard.h"

/* ---------------------------------------------------------------------------------------------- */

/* k: an aabb_trial_kind, or all digits. Boxes that are hit, and lost. */
static inline hard_count boxes(int k, real x)
{
    hard_count c = {0, 0, 0};
    (void)x;
    for (size_t i = 0; i < 50000; i++) {
        bool full = k == aabb_trial_kinds;
        aabb_trial t = full ? aabb_full_trial_of(TRIAL_CORNER, hard_seed, i)
                            : aabb_trial_of((aabb_trial_kind)k, hard_seed, i);
        real enter;
        if (!(full ? wide_aabb(t.b, t.r).hit : exact_aabb(t.b, t.r).hit)) continue;
        c.tried++;
        c.first += !first_aabb_hit(t.b, t.r, &enter), c.now += !aabb_hit(t.b, t.r, &enter);
    }
    return c;
}

/* Wrong answers of a contender to one class, by exact arithmetic. */
static inline size_t tortured(const contender *c, const torture *t)
{
    failure f;
    contender_settings usual = {.n = 0};
    items x = items_of_mesh(&t->m);
    size_t wrong = 0;
    void *s = contender_build(c, &usual, &x, SIZE_MAX, &f);
    if (!s) fail(f);
    for (size_t i = 0; i < t->n; i++) {
        hit h = hit_none;
        double error;
        c->hit(s, t->r[i], &h);
        wrong += torture_judge(t, i, h, &error) != TORTURE_RIGHT;
    }
    contender_free(c, s);
    return wrong;
}

/* One class, in the BVH. */
static inline hard_count torture_of_class(int k, real x)
{
    torture t = torture_make(k, 2000, hard_seed);
    hard_count c = {t.n, tortured(&first_bvh_contender, &t), tortured(&bvh_contender, &t)};
    (void)x;
    torture_free(&t);
    return c;
}

/* First version and default of 10 to 14. */
static const contender *const hard_by[][2] = {
    {&first_grid_contender, &grid_contender}, {&first_octree_contender, &octree_contender},
    {&first_kdtree_contender, &kdtree_contender}, {&first_bsp_contender, &bsp_contender},
    {&first_bvh_contender, &wide_contender}};

/* All classes, in structure k. */
static inline hard_count torture_of_structure(int k, real x)
{
    hard_count c = {0, 0, 0};
    (void)x;
    for (int i = 0; i < torture_classes; i++) {
        torture t = torture_make(i, 500, hard_seed);
        c.tried += t.n, c.first += tortured(hard_by[k][0], &t);
        c.now += tortured(hard_by[k][1], &t);
        torture_free(&t);
    }
    return c;
}

/* ---- each structure beside the search that its page warns of: both against brute force ---- */

typedef bool hard_search(const void *s, ray r, hit *out);

/* As far as a first version can say it: the same triangle, t within a thousandth. */
static inline bool hard_alike(bool ga, hit a, bool gb, hit b)
{
    return ga == gb && (!ga || (a.shape == b.shape && fabs(a.t / b.t - 1) < (real)1e-3));
}

/* Rays aimed at m, of one of the aimed_kinds or of all (kind < 0); away > 0: so many sizes off. The
 * default must be brute force's bit for bit. */
static inline hard_count against_brute(const mesh *m, const void *s, hard_search *first,
                                       hard_search *now, int kind, real away)
{
    hard_count n = {3000, 0, 0};
    for (size_t i = 0; i < n.tried; i++) {
        random_stream g = random_start(hard_seed, i, 0);
        ray r = aimed(m, &g, kind < 0 ? (int)(i % aimed_kinds) : kind, (vec3){0, 0, 0}, 1);
        if (away > 0) {
            vec3 at = m->v[m->index[random_below(&g, 3 * m->triangles)]];
            r.o = vscale(hard_unit(&g), away), r.d = vsub(at, r.o);
        }
        if (r.tmin < 0) r.tmin = 0;  /* textbooks have no other rays */
        hit a = hit_none, b = hit_none, c = hit_none;
        bool due = mesh_hit(m, r, &a);
        n.first += !hard_alike(due, a, first(s, r, &b), b);
        n.now += !same(due, a, now(s, r, &c), c);
    }
    return n;
}

#define HARD_SEARCH(X, hit_of)                                  \
    static inline bool hard_##hit_of(const void *s, ray r, hit *out) \
    {                                                            \
        return hit_of((const X *)s, r, out);                     \
    }
HARD_SEARCH(grid, grid_hit) HARD_SEARCH(grid, grid_hit_early)
HARD_SEARCH(octree, octree_hit) HARD_SEARCH(octree, octree_hit_textbook)
HARD_SEARCH(kdtree, kdtree_hit) HARD_SEARCH(kdtree, kdtree_hit_textbook)
HARD_SEARCH(kdtree, kdtree_hit_naive_final)
HARD_SEARCH(bvh_mesh, bvh_mesh_hit) HARD_SEARCH(bvh_mesh, bvh_mesh_hit_naive)
HARD_SEARCH(bvh8, bvh8_hit) HARD_SEARCH(bvh8, bvh8_hit_leaky)

/* Of large triangles: the first cell with a hit ends the search. */
static inline hard_count grids(int k, real x)
{
    mesh m = needles(300, (real)0.1);
    items all = items_of_mesh(&m);
    failure f;
    grid g;
    (void)x;
    if (!grid_build(&all, grid_defaults, &g, &f)) fail(f);
    hard_count n = against_brute(&m, &g, hard_grid_hit_early, hard_grid_hit, k, 0);
    grid_free(&g), mesh_free(&m);
    return n;
}

/* Walks through x cells: t added up, and counted. Wrong: a cell that is passed and not asked. */
static inline hard_count walks(int k, real x)
{
    enum { many = 400 };
    (void)k;
    drift added = drift_after(walk_step_naive, (size_t)x, many, hard_seed);
    drift counted = drift_after(walk_step, (size_t)x, many, hard_seed);
    return (hard_count){many, (size_t)lround(added.missed * many),
                        (size_t)lround(counted.missed * many)};
}

static inline hard_count octrees(int k, real x)
{
    mesh m = floors_mesh(4);
    items all = items_of_mesh(&m);
    failure f;
    octree t;
    (void)x;
    if (!octree_build(&all, (octree_options){4, 6, true, true, (size_t)1 << 26}, &t, &f)) fail(f);
    hard_count n = against_brute(&m, &t, hard_octree_hit_textbook, hard_octree_hit, k, 0);
    octree_free(&t), mesh_free(&m);
    return n;
}

/* k: 0 the textbook's comparisons, 1 the first hit of any leaf taken as final. */
static inline hard_count kdtrees(int k, real x)
{
    mesh m = floors_mesh(4);
    items all = items_of_mesh(&m);
    failure f;
    kdtree t;
    kdtree_options how = kdtree_defaults;
    how.strategy = KD_MIDDLE, how.leaf = 1, how.planar = KD_BOTH;
    (void)x;
    if (!kdtree_build(&all, how, &t, &f)) fail(f);
    hard_count n = against_brute(&m, &t, k ? hard_kdtree_hit_naive_final : hard_kdtree_hit_textbook,
                                 hard_kdtree_hit, -1, 0);
    kdtree_free(&t), mesh_free(&m);
    return n;
}

/* k: how sides are told in the first version: by the bare sign, by a width of 1e-4, or as always,
 * then without room round the planes. x: the size of the scene. */
static inline hard_count bsps(int k, real x)
{
    mesh m = k == BSP_SIDES_FIXED ? torus_mesh(16) : floors_mesh(4);
    for (size_t i = 0; i < m.vertices; i++) m.v[i] = vscale(m.v[i], x);
    items all = items_of_mesh(&m);
    hard_count n = {3000, 0, 0};
    for (int now = 0; now < 2; now++) {
        failure f;
        bsp b;
        bsp_options how = bsp_defaults;
        how.axis_cost = how.slanted_cost = 0.5;  /* many planes */
        if (!now) how.sides = (bsp_sides)k;
        if (!bsp_build(&all, how, &b, &f)) fail(f);
        for (size_t i = 0; i < n.tried; i++) {
            random_stream g = random_start(hard_seed, i, 0);
            ray r = aimed(&m, &g, (int)(i % aimed_kinds), (vec3){0, 0, 0}, x);
            hit a = hit_none, h = hit_none;
            bool due = mesh_hit(&m, r, &a), bare = !now && k == BSP_SIDES_SAFE;
            bool wrong = !same(due, a, bare ? bsp_hit_naive(&b, r, &h) : bsp_hit(&b, r, &h), h);
            *(now ? &n.now : &n.first) += wrong;
        }
        bsp_free(&b);
    }
    mesh_free(&m);
    return n;
}

/* Boxes in float, the ray rounded to nearest; x: from how far away. */
static inline hard_count bvhs(int k, real x)
{
    mesh m = torus_mesh(24);
    bvh_mesh b;
    failure f;
    (void)k;
    if (!bvh_mesh_build(&m, bvh_defaults, &b, &f)) fail(f);
    hard_count n = against_brute(&m, &b, hard_bvh_mesh_hit_naive, hard_bvh_mesh_hit, 1, x);
    bvh_mesh_free(&b), mesh_free(&m);
    return n;
}

/* The search all in float; k: 1 at corners, 2 at edges. */
static inline hard_count wides(int k, real x)
{
    mesh m = octahedron_mesh(16);
    items all = items_of_mesh(&m);
    bvh8 w;
    failure f;
    if (!bvh8_build(&all, bvh8_defaults, &w, &f)) fail(f);
    hard_count n = against_brute(&m, &w, hard_bvh8_hit_leaky, hard_bvh8_hit, k, x);
    bvh8_free(&w), mesh_free(&m);
    return n;
}

/* ---- 16 ---- */

static inline affine hard_place(random_stream *g, vec3 move, real unlike)
{
    real size = (real)0.2 + (real)0.8 * random_next(g), flat = 1 + (unlike - 1) * random_next(g);
    affine a = affine_scaling((vec3){size, size / flat, size});
    real turn = 6 * random_next(g);
    a = affine_then(a, affine_rotation(hard_unit(g), turn));
    return affine_then(a, affine_translation(vadd(move, random_in_cube(g, 2))));
}

/* k: 0: with a unit d; 1: boxes rounded to nearest, x from the origin. Forty instances of squares;
 * every instance asked in turn is right. */
static inline hard_count crowds(int k, real x)
{
    mesh m = floors_mesh(1);
    instance list[40];
    crowd c = {&m, 1, list, 40};
    vec3 move = vscale((vec3){1, (real)-0.7, (real)0.4}, x);
    instances_options bare = instances_defaults;
    hard_count n = {4000, 0, 0};
    instances full, first;
    failure f;
    for (uint64_t i = 0; i < c.n; i++) {
        random_stream g = random_start(hard_seed, i, 1);
        list[i] = (instance){hard_place(&g, move, 4), 0};
    }
    if (k) bare.boxes = INSTANCES_NAIVE;
    if (!instances_build(&c, instances_defaults, &full, &f)) fail(f);
    if (!instances_build(&c, bare, &first, &f)) fail(f);
    affine *inverse = crowd_inverses(&c);
    mesh flat = crowd_flattened(&c);
    for (size_t i = 0; i < n.tried; i++) {
        random_stream g = random_start(hard_seed, i, 0);
        ray r = aimed(&flat, &g, (int)(i % aimed_kinds), move, 2);
        hit due = hit_none;
        instance_hit a = {hit_none, 0}, b = a;
        uint32_t which = 0;
        bool is = crowd_hit(&c, inverse, r, &due, &which), now = instances_hit(&full, r, &a);
        bool got = k ? instances_hit(&first, r, &b) : instances_hit_naive(&first, r, &b);
        n.now += !same(is, due, now, a.h) || (is && a.instance != which);
        n.first += is != got || (is && (b.instance != which || b.h.shape != due.shape));
    }
    free(inverse), mesh_free(&flat), instances_free(&full), instances_free(&first), mesh_free(&m);
    return n;
}

/* Normals of squeezed triangles, by M n and by A^T n. Wrong: not at right angles to an edge within
 * 64 roundings. */
static inline hard_count squeezed(int k, real x)
{
    hard_count n = {5000, 0, 0};
    (void)k;
    for (size_t i = 0; i < n.tried; i++) {
        random_stream g = random_start(hard_seed, i, 0);
        affine to = hard_place(&g, (vec3){0, 0, 0}, x), back;
        if (!instance_inverse(to, &back)) fail((failure){1, "a place without an inverse"});
        vec3 e = hard_unit(&g), nn = vunit(vcross(e, hard_unit(&g)));
        vec3 edge = vunit(affine_vector(to, e));
        double most = 64 * hard_eps * (double)x;
        n.first += fabs((double)vdot(normal_naive(&to, nn), edge)) > most;
        n.now += fabs((double)vdot(normal_to_world(&back, nn), edge)) > most;
    }
    return n;
}

/* One instance so small that det M rounds to 0, x of it in double; the same at scale 1 is right. */
static inline hard_count tiny_places(int k, real x)
{
    real small = real_is_float ? (real)1e-15 : x;
    triangle t = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    hard_count n = {1000, 0, 0};
    mesh m = mesh_room(1);
    first_mesh soup = {&t, 1};
    first_bvh tree = first_bvh_build(&soup, true);
    instance one = {affine_scaling((vec3){small, small, small}), 0};
    first_instance mine = first_instance_at(one.to_world.x, one.to_world.y, one.to_world.z,
                                            one.to_world.o);
    instances full;
    failure f;
    (void)k;
    set_triangle(&m, 0, t.a, t.b, t.c);
    if (!instances_build(&(crowd){&m, 1, &one, 1}, instances_defaults, &full, &f)) fail(f);
    for (size_t i = 0; i < n.tried; i++) {
        random_stream g = random_start(hard_seed, i, 0);
        vec3 o = random_in_cube(&g, 4), to = vscale(t.b, random_next(&g) / 4);
        o.z = 2;
        hit h;
        instance_hit a;
        int which;
        ray r = ray_from(vscale(o, small), vscale(vsub(to, o), small));
        bool due = triangle_hit(t, ray_from(o, vsub(to, o)), &h);
        n.first += first_crowd_hit(&(first_crowd){&tree, &mine, 1}, r, &h, &which) != due;
        n.now += instances_hit(&full, r, &a) != due;
    }
    instances_free(&full), first_bvh_free(&tree), mesh_free(&m);
    return n;
}

/* ---- the first version of structure k from x sizes away: hit or miss ---- */

static inline hard_count afar(int k, real x)
{
    contender_settings usual = {.n = 0};
    mesh m = torus_mesh(24);
    items all = items_of_mesh(&m);
    hard_count n = {1000, 0, 0};
    real far = x * (real)(real_is_float ? 1 : 1e6);
    for (int now = 0; now < 2; now++) {
        failure f;
        void *s = contender_build(hard_by[k][now], &usual, &all, SIZE_MAX, &f);
        if (!s) fail(f);
        for (size_t i = 0; i < n.tried; i++) {
            random_stream g = random_start(hard_seed, i, 0);
            vec3 at = m.v[m.index[random_below(&g, 3 * m.triangles)]];
            vec3 o = vscale(hard_unit(&g), far);
            hit a = hit_none, h = hit_none;
            bool due = mesh_hit(&m, ray_from(o, vsub(at, o)), &a);
            bool got = hard_by[k][now]->hit(s, ray_from(o, vsub(at, o)), &h);
            *(now ? &n.now : &n.first) += got != due;
        }
        contender_free(hard_by[k][now], s);
    }
    mesh_free(&m);
    return n;
}

static const hard_case hard_structures[] = {
    {"09", "in a plane", "o on a face, along it", WHOLE, boxes, TRIAL_PARALLEL, 0, PROMISED},
    {"09", "flat box", "a side of length 0", WHOLE, boxes, TRIAL_FLAT, 0, PROMISED},
    {"09", "edge", "one point of an edge", WHOLE, boxes, TRIAL_EDGE, 0, PROMISED},
    {"09", "corner", "three planes at one t", WHOLE, boxes, TRIAL_CORNER, 0, PROMISED},
    {"09", "contact", "interval ends where it enters", WHOLE, boxes, TRIAL_CONTACT, 0, PROMISED},
    {"09", "any", "any box, any ray", WHOLE, boxes, TRIAL_ANY, 0, PROMISED},
    {"09", "all digits", "corners, all digits in use", WIDE, boxes, aabb_trial_kinds, 0, PROMISED},
    {"10", "large triangles", "the first cell with a hit ends it", "brute", grids, -1, 0, PROMISED},
    {"10", "t added up", "edges of cells, 1e5 in a row", WHOLE, walks, 0, 100000, IN_DOUBLE},
    {"10", "grid, from afar", "1e7 sizes in float, 1e13", "brute", afar, 0, (real)1e7, PROMISED},
    {"10", "grid", "all classes of 17", WHOLE, torture_of_structure, 0, 0, PROMISED},
    {"11", "along axes", "NaN for the middle wall", "brute", octrees, 4, 0, PROMISED},
    {"11", "at corners", "where eight cells meet", "brute", octrees, 1, 0, PROMISED},
    {"11", "octree, from afar", "1e7 sizes in float, 1e13", "brute", afar, 1, (real)1e7, PROMISED},
    {"11", "octree", "all classes of 17", WHOLE, torture_of_structure, 1, 0, PROMISED},
    {"12", "planes", "squares in the planes; one t a plane", "brute", kdtrees, 0, 0, PROMISED},
    {"12", "final", "a leaf's hit beyond its cell", "brute", kdtrees, 1, 0, PROMISED},
    {"12", "k-d tree, from afar", "1e7 sizes in float, 1e13", "brute", afar, 2, (real)1e7,
     PROMISED},
    {"12", "k-d tree", "all classes of 17", WHOLE, torture_of_structure, 2, 0, PROMISED},
    {"13", "bare sign", "coplanar triangles", "brute", bsps, BSP_SIDES_STRICT, 1, PROMISED},
    {"13", "width 1e-4", "a torus of 1e-3", "brute", bsps, BSP_SIDES_FIXED, (real)1e-3, PROMISED},
    {"13", "no room", "planes without delta", "brute", bsps, BSP_SIDES_SAFE, 1, PROMISED},
    {"13", "BSP tree", "all classes of 17", WHOLE, torture_of_structure, 3, 0, PROMISED},
    {"14", "boxes, near", "rounded to nearest, at corners", "brute", bvhs, 0, 0, PROMISED},
    {"14", "boxes, 1e4 off", "the same, from 1e4 sizes", "brute", bvhs, 0, 10000, PROMISED},
    {"14", "BVH, from afar", "1e7 sizes in float, 1e13", "brute", afar, 4, (real)1e7, PROMISED},
    {"15", "float, corners", "closed mesh, all in float", "brute", wides, 1, 0, PROMISED},
    {"15", "float, edges", "the same, at edges", "brute", wides, 2, 0, PROMISED},
    {"15", "float, 1e3 off", "corners, from 1e3 sizes", "brute", wides, 1, 1000, PROMISED},
    {"15", "wide tree", "all classes of 17", WHOLE, torture_of_structure, 4, 0, PROMISED},
    {"16", "unit d", "rays normalised", "brute", crowds, 0, 0, PROMISED},
    {"16", "boxes too small", "far off: 1e4 in float, 1e7", "brute", crowds, 1,
     real_is_float ? 10000 : 10000000, PROMISED},
    {"16", "normals, 1 : 4", "M n", "right angles", squeezed, 0, 4, PROMISED},
    {"16", "tiny", "det M rounds to 0", "scale 1", tiny_places, 0, (real)1e-110, PROMISED},
};

#endif
