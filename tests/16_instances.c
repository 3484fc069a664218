/* Two levels against what they stand for, every instance asked in turn, bit for bit. */
#include "../chapters/16_instances/lab/flattened.h"
#include "../chapters/16_instances/lab/naive.h"
#include "../chapters/07_mesh/scenes/teapot.h"
#include "aimed.h"
#include "check.h"

static const char *const boxes_name[] = {"corners", "points", "naive"};

static instances_options by(instances_boxes boxes)
{
    instances_options how = instances_defaults;
    how.boxes = boxes;
    return how;
}

static instances built(const crowd *c, instances_boxes boxes)
{
    instances x;
    failure f;
    if (!instances_build(c, by(boxes), &x, &f)) fail(f);
    return x;
}

static size_t never_hit(const instances *x) { return x->n - x->tree.items; }

/* Turned, scaled along three axes by up to `unlike` apart, mirrored every third time, moved. */
static affine any_place(random_stream *g, real unlike, vec3 move, real spread)
{
    real size = random_between(g, 0.2, 1), angle = random_between(g, 0, 2 * pi);
    vec3 axis = vunit(random_in_cube(g, 1));
    vec3 scale = {size, size * random_between(g, 1 / unlike, 1), size};
    if (random_below(g, 3) == 0) scale.x = -scale.x;
    affine a = affine_then(affine_scaling(scale), affine_rotation(axis, angle));
    a = affine_then(affine_rotation(vunit(random_in_cube(g, 1)), angle / 3), a);
    return affine_then(a, affine_translation(vadd(move, random_in_cube(g, spread))));
}

typedef struct { mesh mesh[3]; instance list[64]; crowd c; } scene_of_three;

/* Needles, faces on dyadic planes, and a teapot of 56 triangles; n instances of them. */
static void scene_make(scene_of_three *s, size_t n, real unlike, vec3 move, uint64_t seed)
{
    s->mesh[0] = needles(12, 0.05), s->mesh[1] = floors_mesh(1), s->mesh[2] = teapot_mesh(1);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 1);
        s->list[i] = (instance){any_place(&g, unlike, move, 2), (uint32_t)(i % 3)};
    }
    s->c = (crowd){s->mesh, 3, s->list, n};
}

static void scene_free(scene_of_three *s)
{
    for (int k = 0; k < 3; k++) mesh_free(&s->mesh[k]);
}

typedef struct { size_t rays, hits, wrong, wrong_any; } verdict;

static bool compare(const crowd *c, const affine *inverse, const instances *x, ray r, verdict *v,
                    real *t)
{
    hit brute = hit_none;
    instance_hit h = {{7, 7, 7, 7}, 7};
    uint32_t i = 0;
    bool expected = crowd_hit(c, inverse, r, &brute, &i), got = instances_hit(x, r, &h);
    v->rays++, v->hits += expected;
    v->wrong += !same(got, h.h, expected, brute) || h.instance != (got ? i : 7);
    v->wrong_any += instances_occluded(x, r) != expected;
    *t = brute.t;
    return expected;
}

/* Aimed at corners and edges of the instances where they are in the world. */
static verdict compare_aimed(const crowd *c, const instances *x, size_t n, vec3 centre, real size,
                             uint64_t seed)
{
    verdict v = {0, 0, 0, 0};
    affine *inverse = crowd_inverses(c);
    mesh flat = crowd_flattened(c);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 0);
        real t;
        ray r = aimed(&flat, &g, (int)(i % aimed_kinds), centre, size);
        if (!compare(c, inverse, x, r, &v, &t)) continue;
        r.tmax = t;  /* the interval is closed: the hit stays */
        compare(c, inverse, x, r, &v, &t);
        r.tmin = t;
        compare(c, inverse, x, r, &v, &t);
    }
    mesh_free(&flat);
    free(inverse);
    return v;
}

/* The right answer, wherever the scene lies, however unlike the scales. Boxes that are not padded
 * lose hits far from the origin, where floats are far apart. */
static void test_equals_every_instance_asked(void)
{
    const real far[3] = {0, 300, real_is_float ? (real)1e4 : (real)1e7};
    const real unlike[2] = {4, real_is_float ? 100 : (real)1e5};
    size_t naive = 0;
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 2; j++) {
            scene_of_three s;
            vec3 move = vscale(vec(1, -0.7, 0.4), far[k]);
            scene_make(&s, 40, unlike[j], move, (uint64_t)(10 + k));
            for (instances_boxes b = INSTANCES_CORNERS; b <= INSTANCES_NAIVE; b++) {
                instances x = built(&s.c, b);
                /* What is lost is rare: in float 100 rays of each scene lose no hit, 200 do. */
                size_t n = check_count(2000), least = b == INSTANCES_NAIVE ? 200 : 0;
                verdict v = compare_aimed(&s.c, &x, n > least ? n : least, move, 2,
                                          (uint64_t)(3 * k + j));
                check_at_least(v.hits, v.rays / 4, "enough rays hit something");
                if (b == INSTANCES_NAIVE) naive += v.wrong;
                else {
                    check_equal(v.wrong, 0, "boxes by %s, scene at %g, scales %g unlike: hits that "
                                "differ of %zu", boxes_name[b], (double)far[k], (double)unlike[j],
                                v.hits);
                    check_equal(v.wrong_any, 0, "boxes by %s: occluded, yet no hit, or the reverse",
                                boxes_name[b]);
                }
                instances_free(&x);
            }
            scene_free(&s);
        }
    check_at_least(naive, 1, "boxes rounded to nearest lose hits");
}

/* Closed form: a square of side 2 at z = 0 below, moved, turned, mirrored, scaled exactly. And a
 * small cube before a large one: a unit D' takes eight times the t to the small one. */
static void test_known_hit(void)
{
    mesh m = floors_mesh(1);  /* planes x, y, z = -1 and 1 */
    instance list[2] = {
        {affine_then(affine_scaling((vec3){2, 2, 2}), affine_translation((vec3){0, 0, 10})), 0},
        {affine_then(affine_scaling((vec3){-1, 4, 8}), affine_translation((vec3){16, 0, 32})), 0}};
    crowd c = {&m, 1, list, 2};
    instances x = built(&c, INSTANCES_POINTS);
    instance_hit h;
    ray r = ray_from(vec(0.25, -0.5, 0), (vec3){0, 0, 4});
    check(instances_hit(&x, r, &h) && h.instance == 0, "the nearer instance is hit");
    check_equal(h.h.t, 2, "z = 10 - 2 with D four long: t = 8 / 4, of the world's ray");
    r.o.x = 16, r.o.z = 100, r.d.z = -1;
    check(instances_hit(&x, r, &h) && h.instance == 1, "the other one from behind");
    check_equal(h.h.t, 60, "z = 32 + 8, from 100: t = 60, whatever its scale");
    vec3 n = instances_normal(&x, h);
    check(n.x == 0 && n.y == 0 && fabs(n.z) == 1, "its normal is along z");
    mesh flat = crowd_flattened(&c);
    hit in_one = hit_none;
    check(mesh_hit(&flat, r, &in_one) && in_one.t == 60 && in_one.shape >= m.triangles,
          "the same of one mesh of both");
    mesh_free(&flat), instances_free(&x);
    list[0].to_world = affine_scaling((vec3){0.125, 0.125, 0.125}), list[0].to_world.o.z = 10;
    list[1].to_world = affine_translation((vec3){0, 0, 40});
    x = built(&c, INSTANCES_CORNERS);
    r = ray_from(vec(0.0625, 0.03125, 0), (vec3){0, 0, 1});
    check(instances_hit(&x, r, &h) && h.instance == 0 && h.h.t == (real)9.875, "the small one");
    check(instances_hit_naive(&x, r, &h) && h.instance == 1 && h.h.t == 39,
          "normalised: the large one behind it, as the small one is said to be at t = 79");
    instances_free(&x), mesh_free(&m);
}

/* ---- the ray ---- */

/* Rays that are not rays, and those that become none on the way to object space. */
static void test_sick_rays(void)
{
    mesh m = floors_mesh(1);
    real tiny = real_is_float ? (real)1e-29 : (real)1e-280;
    instance list[2] = {{affine_scaling((vec3){1, 1, 1}), 0},
                        {affine_scaling(vscale((vec3){1, 1, 1}, real_is_float ? (real)1e6
                                                                              : (real)1e30)), 0}};
    crowd c = {&m, 1, list, 2};
    instances x = built(&c, INSTANCES_POINTS);
    affine *inverse = crowd_inverses(&c);
    instance_hit h = {{7, 7, 7, 7}, 7};
    hit brute;
    uint32_t i;
    for (size_t k = 0; k < sick_count; k++)
        check(!instances_hit(&x, sick_ray[k], &h) && !instances_occluded(&x, sick_ray[k])
                  && h.h.t == 7 && h.instance == 7
                  && !crowd_hit(&c, inverse, sick_ray[k], &brute, &i),
              "sick ray %zu hits nothing and touches nothing", k);
    ray r = ray_from((vec3){0, 0, 0}, (vec3){0, 0, tiny});
    check(instances_hit(&x, r, &h) && h.instance == 0, "a short D is a ray");
    r.o.z = 9;
    check(instances_hit(&x, r, &h) == crowd_hit(&c, inverse, r, &brute, &i) && h.h.t >= 0,
          "where D' is too short to have digits, the instance is not hit");
    ray inside;
    check(!instance_ray(&inverse[1], r, &inside), "as it is here");
    instances_free(&x), mesh_free(&m);
    free(inverse);
}

/* ---- ties, sick transforms, empty ones ---- */

static void test_ties(void)
{
    enum { n = 30 };
    mesh m = floors_mesh(1);
    instance list[n];
    ray r = ray_from(vec(0.25, 0.5, -9), (vec3){0, 0, 1});
    for (uint32_t first = 0; first < n; first += 7) {
        for (uint32_t i = 0; i < n; i++)  /* from `first` on, all on one place */
            list[i] = (instance){affine_translation((vec3){i < first ? 50 : 0, 0, 0}), 0};
        crowd c = {&m, 1, list, n};
        for (int k = 0; k < 4; k++) {
            instances_options how = by(k % 2 ? INSTANCES_POINTS : INSTANCES_CORNERS);
            instances x;
            failure f;
            instance_hit h;
            hit due = hit_none;
            how.upper.leaf = k / 2 ? 8 : 1;
            if (!instances_build(&c, how, &x, &f)) fail(f);
            mesh_hit(&m, r, &due);
            check(instances_hit(&x, r, &h), "coincident instances are hit");
            check_equal(h.instance, first, "the lowest instance wins");
            check_equal(h.h.shape, due.shape, "and of it the triangle that its mesh says");
            ray end = {r.o, h.h.t, r.d, h.h.t};
            check(instances_hit(&x, end, &h) && h.instance == first, "in [t, t] too");
            instances_free(&x);
        }
    }
    mesh_free(&m);
}

/* Every second transform is sick; the others are found as if they were alone. */
static void test_sick_transforms(void)
{
    scene_of_three s;
    real nan = (real)NAN, inf = real_infinity;
    scene_make(&s, 48, 4, (vec3){0, 0, 0}, 51);
    size_t hidden = 0;
    for (size_t i = 0; i < s.c.n; i++) {
        affine *a = &s.list[i].to_world;
        if (i % 2 == 0) continue;
        hidden++;
        switch (i / 2 % 8) {
        case 0: a->y = (vec3){0, 0, 0}; break;                     /* rank 2 */
        case 1: a->y = a->x; break;
        case 2: a->z = vscale(a->x, 3), a->y = vscale(a->x, -2); break;  /* rank 1 */
        case 3: a->x = a->y = a->z = (vec3){0, 0, 0}; break;
        case 4: a->x.y = nan; break;
        case 5: a->o.z = inf; break;
        case 6: a->z.z = -inf; break;
        default: a->o.x = nan; break;
        }
    }
    instances x = built(&s.c, INSTANCES_POINTS);
    check_equal(never_hit(&x), hidden, "sick transforms are left out");
    size_t n = check_count(4000);
    verdict v = compare_aimed(&s.c, &x, n, (vec3){0, 0, 0}, 2, 52);
    check_at_least(v.hits, n / 8, "enough rays hit");
    check_equal(v.wrong + v.wrong_any, 0, "as every instance asked in turn");
    instances_free(&x), scene_free(&s);
}

/* Turned, flattened to 2^-e, turned again: neither columns nor rows tell that it is flat. A wire is
 * flattened along two axes. */
static affine plate(int e, bool wire)
{
    affine a = affine_rotation(vunit((vec3){3, 1, -2}), 1.1);
    real s = ldexp((real)1, -e);
    a = affine_then(a, affine_scaling((vec3){1, wire ? s : 1, s}));
    return affine_then(a, affine_rotation(vunit((vec3){1, 2, 3}), 0.7));
}

/* Ever thinner: at last the inverse has no right digit. Till then all is as it should be, after
 * that it is never hit. */
static void test_nearly_singular(bool wire)
{
    mesh m = floors_mesh(1);
    int last_seen = 0, first_hidden = 0, digits = real_is_float ? 24 : 53;
    for (int e = 0; e < digits + 10; e++) {
        instance list[1] = {{plate(e, wire), 0}};
        crowd c = {&m, 1, list, 1};
        affine a;
        check(!instance_inverse(list[0].to_world, &a)
                  || inverse_doubt(list[0].to_world, a) <= (real)0.25,
              "2^-%d thick: seen only where (16.3) holds, g <= 1/4", e);
        for (instances_boxes b = INSTANCES_CORNERS; b <= INSTANCES_POINTS; b++) {
            instances x = built(&c, b);
            if (never_hit(&x)) {
                if (!first_hidden) first_hidden = e;
                instances_free(&x);
                continue;
            }
            last_seen = e;
            verdict v = compare_aimed(&c, &x, check_count(120), (vec3){0, 0, 0}, 1, (uint64_t)e);
            check_equal(v.wrong + v.wrong_any, 0, "2^-%d thick, boxes by %s", e, boxes_name[b]);
            instances_free(&x);
        }
    }
    check_at_least(last_seen, wire ? digits / 2 - 3 : digits - 8,
                   "seen as long as the inverse has some digits");
    check_at_most(first_hidden, digits + 2, "hidden when it has none");
    mesh_free(&m);
}

/* Cramer's rule is off by some eps / s^2 for a wire of thickness s; refined, by eps / s. */
static void test_refined(void)
{
    int e = real_is_float ? 10 : 24;  /* so thin that one step of (16.6) is not enough */
    real before = 0, after = 0, s = ldexp((real)1, -e);
    for (size_t i = 0; i < 200; i++) {
        random_stream g = random_start(54, i, 0);
        affine raw = {.o = {0, 0, 0}}, a = raw, m;
        real turn = random_between(&g, 0, 6);
        m = affine_rotation(vunit(random_in_cube(&g, 1)), turn);
        m = affine_then(m, affine_scaling((vec3){1, s, s}));
        turn = random_between(&g, 0, 6);
        m = affine_then(m, affine_rotation(vunit(random_in_cube(&g, 1)), turn));
        check(affine_inverse(m, &raw) && instance_inverse(m, &a), "a wire has an inverse");
        before = real_max(affine_norm(inverse_residual(m, raw)), before);
        after = real_max(affine_norm(inverse_residual(m, a)), after);
    }
    check_at_least(before, real_epsilon / (s * s) / 64, "before");
    check_at_most(after, 4 * real_epsilon / s, "after");
}

/* A mesh so large that its points in the world overflow, though t does not: inside of it. */
static void test_beyond_all_numbers(void)
{
    mesh m = floors_mesh(1);
    real huge = ldexp((real)1, real_is_float ? 123 : 1019), step = ldexp(huge, -25);
    for (size_t i = 0; i < m.vertices; i++) m.v[i] = vscale(m.v[i], 64);
    affine t = affine_then(affine_rotation(vunit((vec3){1, 2, 3}), 0.7),
                         affine_scaling((vec3){huge, huge, huge}));
    instance list[2] = {{t, 0}, {affine_translation((vec3){1000, 0, 0}), 0}};
    crowd c = {&m, 1, list, 2};
    affine *inverse = crowd_inverses(&c);
    for (instances_boxes b = INSTANCES_CORNERS; b <= INSTANCES_POINTS; b++) {
        instances x = built(&c, b);
        verdict v = {0, 0, 0, 0};
        check_equal(never_hit(&x), 0, "it has an inverse");
        for (size_t i = 0; i < 200; i++) {
            random_stream g = random_start(63, i, 0);
            real at;
            vec3 d = i % 2 ? random_in_cube(&g, step)
                           : vadd(random_in_cube(&g, 1), (vec3){9, 0, 0});
            compare(&c, inverse, &x, ray_from(random_in_cube(&g, 1), d), &v, &at);
        }
        check_equal(v.wrong + v.wrong_any, 0, "points beyond all numbers, boxes by %s",
                    boxes_name[b]);
        check_at_least(v.hits, 100, "it is hit from inside");
        instances_free(&x);
    }
    mesh_free(&m);
    free(inverse);
    /* All corners become infinity - infinity, along x: no box at all; along all axes: nothing of
     * its box is left to make another one infinite. It is hit all the same. */
    const triangle corners[2] = {{{60, 64, -64}, {64, 60, 64}, {64, 64, 30}},
                                 {{60, 64, 64}, {64, 60, 64}, {66, 66, 64}}};
    const affine place[2] = {affine_then(affine_rotation((vec3){0, 0, 1}, pi / 4),
                                         affine_scaling((vec3){huge, huge, huge})),
                             {{2 * huge, -huge, 0}, {-huge, 2 * huge, -huge}, {0, 0, 2 * huge},
                              {0, 0, 0}}};
    m = mesh_room(1);
    for (int k = 0; k < 2; k++) {
        vec3 to = vscale(affine_vector(place[k], (vec3){1, 1, 1}), (real)0x1p-20);
        list[0].to_world = place[k];
        set_triangle(&m, 0, corners[k].a, corners[k].b, corners[k].c);
        vec3 at = affine_point(place[k], m.v[0]);
        check(isnan(at.x) && (!k || (isnan(at.y) && isnan(at.z))), "infinity - infinity");
        instances x = built(&c, INSTANCES_POINTS);
        instance_hit h;
        ray r = ray_from((vec3){0, 0, 0}, k ? to : (vec3){0, step, step / 8});
        check(instances_hit(&x, r, &h) && h.instance == 0, "a triangle that has no box");
        instances_free(&x);
    }
    mesh_free(&m);
}

/* From 1e-150 to 1e150 in one scene (float: 1e-15 to 1e15), and alone. */
static void test_scales(void)
{
    scene_of_three s;
    for (int e = -500; e <= 500; e += 50) {
        real size = ldexp((real)1, real_is_float ? e / 10 : e);
        scene_make(&s, 30, 4, (vec3){0, 0, 0}, 61);
        for (size_t i = 0; i < s.c.n; i++) {
            affine *a = &s.list[i].to_world;
            *a = affine_then(*a, affine_scaling((vec3){size, size, size}));
        }
        instances x = built(&s.c, INSTANCES_POINTS);
        check_equal(never_hit(&x), 0, "nothing is lost by its size");
        verdict v = compare_aimed(&s.c, &x, check_count(240), (vec3){0, 0, 0}, 2 * size, 62);
        check_equal(v.wrong + v.wrong_any, 0, "scene of size %g", (double)size);
        check_at_least(v.hits, v.rays / 4, "scene of size %g: rays hit", (double)size);
        instances_free(&x), scene_free(&s);
    }
}

static void test_none(void)
{
    mesh m = floors_mesh(1), empty = {0}, both[2] = {empty, m};
    instance list[2] = {{affine_translation((vec3){0, 0, 0}), 0},
                        {affine_translation((vec3){0, 0, 0}), 1}};
    ray r = ray_from(vec(0.25, 0.5, -9), (vec3){0, 0, 1});
    instance_hit h = {{7, 7, 7, 7}, 7};
    instances x, zero = {0};
    failure f;
    const crowd none[3] = {{NULL, 0, NULL, 0}, {both, 2, NULL, 0}, {both, 1, list, 1}};
    for (int k = 0; k < 3; k++) {
        x = built(&none[k], INSTANCES_POINTS);
        check(!instances_hit(&x, r, &h) && !instances_occluded(&x, r) && h.instance == 7,
              "nothing to hit: case %d", k);
        mesh flat = crowd_flattened(&none[k]);
        check_equal(flat.triangles, 0, "and nothing to flatten");
        mesh_free(&flat);
        instances_free(&x);
    }
    crowd c = {both, 2, list, 2};
    x = built(&c, INSTANCES_POINTS);
    check(instances_hit(&x, r, &h) && h.instance == 1 && h.h.t == 8, "beside an empty mesh");
    check_equal(never_hit(&x), 1, "one is never hit");
    instances_free(&x), instances_free(&x), instances_free(&zero);
    const struct { size_t meshes, n; real size; const char *text; } refused[] = {
        {1, 2, 1, "instance 1: mesh 1; there are 1 meshes, counted from 0"},
        {2, (size_t)1 << 31, 1, "2147483648 instances: fewer than 2^31 fit"},
        {2, 2, 2 * items_most, "item 0 reaches to 2e+75: coordinates up to 1e+75 are allowed"}};
    for (int k = 0; k < 3; k++) {
        for (size_t i = 0; i < m.vertices; i++) m.v[i] = vscale(m.v[i], refused[k].size);
        c.meshes = refused[k].meshes, c.n = refused[k].n;
        check(!instances_build(&c, instances_defaults, &x, &f) && f.exit_code == 2 && !x.lower,
              "refused: case %d", k);
        check(k == 2 && real_is_float ? !!strstr(f.text, "reaches to")
                                      : !strcmp(f.text, refused[k].text), "it says: %s", f.text);
    }
    mesh_free(&m);
}

/* Triangles that are not finite spoil no box. */
static void test_sick_mesh(void)
{
    mesh m = floors_mesh(2);
    m.v[0].x = (real)NAN, m.v[5].y = real_infinity;
    instance list[9];
    for (size_t i = 0; i < 9; i++) {
        random_stream g = random_start(71, i, 0);
        list[i] = (instance){any_place(&g, 4, (vec3){0, 0, 0}, 2), 0};
    }
    crowd c = {&m, 1, list, 9};
    for (instances_boxes b = INSTANCES_CORNERS; b <= INSTANCES_POINTS; b++) {
        instances x = built(&c, b);
        const bvh_box *root = x.tree.node;
        check(isfinite(root->low[0]) && isfinite(root->minus_high[1]), "boxes stay finite");
        verdict v = compare_aimed(&c, &x, check_count(1000), (vec3){0, 0, 0}, 2, 72);
        check_equal(v.wrong + v.wrong_any, 0, "a mesh with NaN, boxes by %s", boxes_name[b]);
        check_at_least(v.hits, v.rays / 8, "rays hit");
        instances_free(&x);
    }
    mesh_free(&m);
}

/* ---- boxes and padding ---- */

/* The corners of triangle k of an instance, exactly. */
static void exact_corners(const crowd *c, uint32_t i, uint32_t k, wide3 corner[3])
{
    affine m = c->list[i].to_world;
    const mesh *part = &c->mesh[c->list[i].mesh];
    for (int j = 0; j < 3; j++) {
        vec3 p = part->v[part->index[3 * k + (uint32_t)j]];
        corner[j] = wide3_madd(wide3_of(m.o), wide3_of(m.x), wide_of((double)p.x));
        corner[j] = wide3_madd(corner[j], wide3_of(m.y), wide_of((double)p.y));
        corner[j] = wide3_madd(corner[j], wide3_of(m.z), wide_of((double)p.z));
    }
}

/* Both boxes hold every corner of the exact instance; the loose one holds the tight one. */
static void test_boxes(void)
{
    mesh m = teapot_mesh(2);
    double outside = 0;
    size_t larger = 0;
    const items all = items_of_mesh(&m);
    aabb root;
    check(items_all_bounds(&all, &root, NULL), "bounded");
    for (size_t i = 0; i < check_count(300); i++) {
        random_stream g = random_start(81, i, 0);
        vec3 move = vscale((vec3){1, 2, 3}, (real)(i % 3) * 50);
        affine a, t = any_place(&g, i % 2 ? 4 : 100, move, 2);
        check(instance_inverse(t, &a), "there is an inverse");
        placing p = placing_of(t, a, aabb_reach(root));
        size_t n;
        vec3 *points = mesh_points(&m, &n);
        aabb loose = box_of_corners(t, &root), tight = box_of_points(t, points, n);
        check_equal(n, m.vertices, "all points of a teapot are in use");
        free(points);
        bvh_box lb = box_padded(&loose, p.fixed), tb = box_padded(&tight, p.fixed);
        instance one = {t, 0};
        crowd c = {&m, 1, &one, 1};
        for (uint32_t k = 0; k < m.triangles; k++) {
            wide3 corner[3];
            exact_corners(&c, 0, k, corner);
            for (int j = 0; j < 9; j++) {
                const wide *at = &corner[j / 3].x + j % 3;
                double q = wide_value(*at), lo = (double)float_max(tb.low[j % 3], lb.low[j % 3]);
                outside = check_worse(outside, lo - q);
                lo = (double)float_max(tb.minus_high[j % 3], lb.minus_high[j % 3]);
                outside = check_worse(outside, lo + q);
            }
        }
        larger += box_area(&lb) > 1.2 * box_area(&tb);
        aabb corners = aabb_empty();
        for (int k = 0; k < 8; k++) {  /* (16.2) against going through the corners */
            vec3 corner = {k & 1 ? root.hi.x : root.lo.x, k & 2 ? root.hi.y : root.lo.y,
                           k & 4 ? root.hi.z : root.lo.z};
            corners = aabb_grow_point(corners, affine_point(t, corner));
        }
        real bound = 8 * real_epsilon * (affine_norm(t) * 4 + vlargest(t.o));
        check_at_most(vlargest(vsub(corners.lo, loose.lo)), bound, "(16.2): lo");
        check_at_most(vlargest(vsub(corners.hi, loose.hi)), bound, "(16.2): hi");
    }
    check_equal(outside, 0, "no exact corner is outside of a box");
    check_at_least(larger, check_count(300) / 4, "the loose box is larger by a fifth, often");
    mesh_free(&m);
}

/* Rounded outwards, rays and triangles paid as in 14, but without a part of (16.3): an inverse that
 * has lost digits, of a plate, makes it larger than the box in the world is. Rays aimed near its
 * corners. The part that grows with |O| is needed for rays from afar, the fixed part near the
 * origin of the world, with the plate far from it. */
static void test_pad_is_needed(bool fixed)
{
    size_t lost = 0, lost_padded = 0, hits = 0;
    size_t rays = real_is_float ? 8000 : 2000;  /* some 15 are lost; float has two plates */
    mesh m = floors_mesh(1);
    int digits = real_is_float ? 24 : 53;
    vec3 move = {fixed ? 1000 : 0, 0, 0};
    for (int e = digits / 2; e < digits - 10; e++) {
        instance one = {affine_then(plate(e, false), affine_translation(move)), 0};
        crowd c = {&m, 1, &one, 1};
        affine *a = crowd_inverses(&c);
        mesh flat = crowd_flattened(&c);
        instances x = built(&c, INSTANCES_POINTS), bare = built(&c, INSTANCES_POINTS);
        if (fixed) {
            aabb w = box_of_points(one.to_world, m.v, m.vertices);
            bvh_box tight = box_padded(&w, 0), *root = bare.tree.node;
            *root = box_numbered(&tight, root->first, root->count);
        } else bare.by_origin = 0;
        for (size_t i = 0; i < rays; i++) {
            random_stream g = random_start(93, i, (uint64_t)e);
            real far = fixed ? (real)0.001 : 3000;
            vec3 at = flat.v[random_below(&g, flat.vertices)], o = random_in_cube(&g, far);
            real off = real_epsilon * ldexp(real_max(far, move.x), e);
            at = vadd(at, random_in_cube(&g, real_min(off, 1)));
            ray r = ray_from(o, vsub(at, o));
            hit h;
            uint32_t k;
            if (!crowd_hit(&c, a, r, &h, &k)) continue;
            hits++, lost += !instances_occluded(&bare, r);
            lost_padded += !instances_occluded(&x, r);
        }
        instances_free(&x), instances_free(&bare), mesh_free(&flat);
        free(a);
    }
    check_at_least(hits, 1000, "rays hit");
    check_at_least(lost, 1, "without the %s part of the pad, hits are lost: of %zu",
                   fixed ? "fixed" : "growing", hits);
    check_equal(lost_padded, 0, "with it, none");
    mesh_free(&m);
}

/* (16.3) term by term, where each can be told exactly. M = 2, A = 1/2: |M| = 2, |A| = 1/2 and
 * K = k = 1, so R counts 256 + 4. A off by 2^-10, a by 2^-9: E = 2^-9, f = 2^-8. */
static void test_pad_formula(void)
{
    real eps = real_epsilon, V = 3, off = (real)0x1p-10;
    affine m = affine_then(affine_scaling((vec3){2, 2, 2}), affine_translation((vec3){4, -8, 1}));
    affine a = {.o = {0, 0, 0}};
    check(instance_inverse(m, &a), "there is an inverse");
    placing p = placing_of(m, a, V);
    real world = 2 * V + 8, far = 2 * 4 + world, third = (real)4 / 3;
    check_close(p.by_origin, third * eps * 260, 8 * eps * eps * 260, "what the ray pays");
    check_close(p.fixed, third * (260 * eps * far + 2 * eps * world), 8 * eps * eps * 260 * far,
                "what the box pays, with an exact inverse");
    affine turn, lean = {{1, 0, 0}, {3, 1, 0}, {0, 0, 1}, {0, 0, 0}};  /* |M| = |A| = 4, k = 7 */
    check(instance_inverse(lean, &turn), "so has this");
    p = placing_of(lean, turn, V);
    check_close(p.by_origin, third * eps * (256 * 16 + 4 * 7), 8 * eps * eps * 4124, "of a shear");
    p = (placing){.by_origin = 2, .fixed = 3};
    check_equal(placing_pad(&p, (vec3){1, -5, 4}), 2 * 5 + 3, "and a ray from 5 off");
    const struct { real shear; bool sure; } shears[] = {{1 / (8 * eps), false},
                                                        {1 / (32 * eps), true}};
    for (int i = 0; i < 2; i++) {  /* E = 0, k = 1 + 2 shear: g = 4 eps shear, 1/2 and 1/8 */
        affine back, s = {{1, 0, 0}, {shears[i].shear, 1, 0}, {0, 0, 1}, {0, 0, 0}};
        check(instance_inverse(s, &back) == shears[i].sure, "2 eps k of %g: within 1/4 or not",
              (double)(2 * eps * affine_growth(s, (affine){s.x, vsub(s.y, vscale(s.x, 2 * s.y.x)),
                                                           s.z, s.o})));
    }
    ray in = {.o = {0, 0, 0}}, r = ray_from((vec3){0, 0, 0}, (vec3){real_smallest / eps, 0, 0});
    affine half = affine_scaling((vec3){0.5, 0.5, 0.5}), same = affine_scaling((vec3){1, 1, 1});
    check(instance_ray(&same, r, &in) && !instance_ray(&half, r, &in), "D' as short as may be");
    a.y.y += off, a.o.x += 2 * off;
    p = placing_of(m, a, V);
    check_close(p.fixed, third * (4 * off + 2 * off * world), 400 * eps * far,
                "an inverse that is off: |f| + |E| (|M| V + |m|)");
}

/* Each instance that can be hit is in one leaf; `where` and `place` are inverse to each other. */
static void test_invariants(void)
{
    scene_of_three s;
    scene_make(&s, 50, 4, (vec3){0, 0, 0}, 95);
    s.list[7].to_world.x = (vec3){0, 0, 0};
    instances x = built(&s.c, INSTANCES_CORNERS);
    size_t seen = 0;
    for (size_t i = 0; i < x.tree.nodes; i++)
        if (i != 1) seen += x.tree.node[i].count == 1;
    check_equal(seen, 49, "every instance in a leaf of its own, but for the flat one");
    check_equal(x.where[7], no_shape, "which has no place");
    for (uint32_t i = 0; i < 50; i++) {
        if (i == 7) continue;
        const placed *q = &x.place[x.where[i]];
        real reach = aabb_reach(x.box[q->mesh]);
        check((real)x.tree.node[1].low[0]
                  >= placing_of(s.list[i].to_world, q->to_object, reach).by_origin,
              "a ray pays for every instance, for the worst one, too");
        check(q->index == i && q->mesh == i % 3, "where and place");
    }
    double triangles = 17 * (double)s.mesh[0].triangles + 16 * (double)s.mesh[1].triangles
        + 16 * (double)s.mesh[2].triangles;  /* (7 is of floors) */
    check_equal(flattened_triangles(&x), triangles, "triangles of all instances");
    check_equal(never_hit(&x), 1, "hidden");
    size_t upper = (2 * 49 + 2) * sizeof(bvh_node) + 49 * sizeof(placed) + 50 * 4;
    check_equal(x.tree.held.bytes, upper, "nodes, places, and a number an instance");
    for (int k = 0; k < 3; k++) upper += x.lower[k].room.bytes;
    check_equal(x.bytes, upper, "bytes add up");
    instances_free(&x), scene_free(&s);
}

/* ---- normals ---- */

/* Scaled by 1 and s along two axes, n = (cos a, sin a) becomes (cos a, sin a / s), but M n is
 * (cos a, s sin a). The tangent of the angle between them is (s - 1/s) tan a / (1 + tan^2 a), which
 * is largest at 45 degrees: (s - 1/s) / 2.                                                (16.5) */
static real normal_worst_angle(real s) { return atan(fabs(s - 1 / s) / 2); }

/* The ellipsoid (x/a)^2 + (y/b)^2 + (z/c)^2 = 1 is a sphere scaled; its normal is the gradient. */
static void test_normals(void)
{
    double worst = 0, worst_naive = 0, highest = 0;
    vec3 s = {1, 1, 4};
    affine t = affine_scaling(s), a;
    check(instance_inverse(t, &a), "inverse");
    for (size_t i = 0; i < check_count(20000); i++) {
        random_stream g = random_start(96, i, 0);
        vec3 n = vunit(random_in_cube(&g, 1)), p = affine_point(t, n);
        if (vzero(n)) continue;
        vec3 due = vunit((vec3){p.x / (s.x * s.x), p.y / (s.y * s.y), p.z / (s.z * s.z)});
        vec3 naive = normal_naive(&t, n);
        worst = check_worse(worst, (double)vlength(vsub(normal_to_world(&a, n), due)));
        double angle = (double)mesh_angle(naive, due);
        worst_naive = check_worse(worst_naive, angle);
    }
    highest = (double)normal_worst_angle(4);
    check_at_most(worst, 8 * (double)real_epsilon, "inverse transpose: the gradient");
    check_at_most(worst_naive, highest + 8 * (double)real_epsilon, "(16.5) is a bound");
    check_at_least(worst_naive, highest - 0.01, "M n is off by up to 62 degrees at 1 : 4");
    check_close(highest, atan(15.0 / 8), 2 * (double)real_epsilon, "atan((4 - 1/4) / 2)");
    affine turn = affine_then(affine_rotation(vunit((vec3){1, 2, 3}), 1),
                            affine_scaling((vec3){3, 3, 3}));
    check(instance_inverse(turn, &a), "inverse");
    vec3 n = vunit((vec3){3, -1, 2});
    check_at_most(vlength(vsub(normal_naive(&turn, n), normal_to_world(&a, n))), 16 * real_epsilon,
                  "turned and scaled alike, M n is right");
    check(vzero(normal_to_world(&a, (vec3){0, 0, 0})), "no normal stays none");
}

/* At right angles to edges, wherever they go; outside stays outside, mirrored or not. */
static void test_normals_anywhere(void)
{
    double worst = 0;
    size_t mirrored = 0, inward = 0;
    for (size_t i = 0; i < check_count(20000); i++) {
        random_stream g = random_start(97, i, 0);
        affine a, t = any_place(&g, 10, (vec3){0, 0, 0}, 2);
        vec3 e = vunit(random_in_cube(&g, 1)), f = vunit(vcross(e, random_in_cube(&g, 1)));
        if (!instance_inverse(t, &a) || vzero(f)) continue;
        vec3 n = normal_to_world(&a, vcross(e, f)), me = affine_vector(t, e);
        vec3 mf = affine_vector(t, f);
        bool mirror = vdot(t.x, vcross(t.y, t.z)) < 0;
        worst = check_worse(worst, fabs((double)(vdot(n, me) / vlength(me))));
        worst = check_worse(worst, fabs((double)(vdot(n, mf) / vlength(mf))));
        mirrored += mirror, inward += (vdot(n, vcross(me, mf)) < 0) != mirror;
    }
    check_at_least(mirrored, check_count(20000) / 10, "some are mirrored");
    check_at_most(worst, 32 * (double)real_epsilon, "normals at right angles to edges");
    check_equal(inward, 0, "(M e) x (M f) turns round in a mirror, the normal does not");
}

/* One instance that stands where its mesh does costs what 15's own tree of it costs, and one test
 * of an instance, where its box, a thousandth larger, is met. */
static void test_cost_of_one(void)
{
    mesh m = teapot_mesh(4);
    instance one = {affine_scaling((vec3){1, 1, 1}), 0};
    instances x = built(&(crowd){&m, 1, &one, 1}, INSTANCES_POINTS);
    instances_work w = {{0, 0, 0, 0}, {0, 0, 0, 0}}, any = w;
    search_work due = {0, 0, 0, 0};
    size_t met = 0, hits = 0;
    for (size_t i = 0; i < check_count(2000); i++) {
        random_stream g = random_start(97, i, 0);
        vec3 o = random_in_cube(&g, 3);
        ray r = ray_from(o, vsub(random_in_cube(&g, 1), o));
        hit h;
        instance_hit k;
        real t;
        met += aabb_hit(first_aabb_pad(x.box[0], (real)0.001), r, &t);
        hits += bvh8_hit_counted(&x.lower[0], r, &h, &due);
        hits -= instances_hit_counted(&x, r, &k, &w);
        instances_occluded_counted(&x, r, &any);
    }
    check_equal(hits, 0, "the same hits");
    check_at_most((double)w.lower.nodes, (double)due.nodes, "nodes of the mesh");
    check_equal(w.lower.tests, due.tests, "tests of its triangles");
    check_at_most((double)w.upper.tests, (double)met, "asked, and its box met");
    check_equal(any.upper.tests, w.upper.tests, "as often for any hit");
    check_at_most((double)any.lower.tests, (double)due.tests, "which is found sooner");
    check(any.lower.tests > 0 && w.upper.tests > 0, "it is asked");
    instances_free(&x), mesh_free(&m);
}

int main(void)
{
    test_nearly_singular(false), test_nearly_singular(true);
    test_pad_is_needed(true), test_pad_is_needed(false);
    return check_all("16_instances", test_cost_of_one, test_known_hit,
                     test_equals_every_instance_asked, test_sick_rays, test_ties,
                     test_sick_transforms, test_refined, test_beyond_all_numbers, test_scales,
                     test_none, test_sick_mesh, test_boxes, test_pad_formula, test_invariants,
                     test_normals, test_normals_anywhere);
}
