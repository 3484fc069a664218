/* 16's first.h: rays, hits and normals of instances.h for instances turned, stretched and sheared;
 * what a transform that flattens, and what a great distance, make of it. */
#include "aimed.h"
#include "check.h"
#include "../common/random.h"
#include "../chapters/16_instances/first.h"
#include "../chapters/16_instances/instances.h"

static const double eps = (double)real_epsilon;
enum { most = 40 };

/* The same knots for both. */
typedef struct {
    first_mesh knot;
    first_bvh tree;
    first_instance one[most];
    first_crowd first;
    mesh mesh;
    instance list[most];
    crowd c;
    instances x;
} both;

/* Turned, stretched by up to 3, sheared, moved. */
static affine any_place(random_stream *g)
{
    real a = random_between(g, (real)0.3, 1), b = random_between(g, (real)0.3, 1);
    real c = random_between(g, (real)0.3, 1);
    vec3 axis = vunit(random_in_cube(g, 1));
    real p = random_between(g, -1, 1) / 2, q = random_between(g, -1, 1) / 2;
    affine shear = {{1, p, 0}, {0, 1, q}, {0, 0, 1}, {0, 0, 0}};
    affine m = affine_then(affine_scaling((vec3){a, b, c}), shear);
    m = affine_then(m, affine_rotation(axis, random_between(g, 0, 2 * pi)));
    return affine_then(m, affine_translation(random_in_cube(g, 8)));
}

static mesh mesh_of_knot(const first_mesh *f)
{
    mesh m = mesh_room((size_t)f->n);
    for (size_t i = 0; i < m.triangles; i++)
        set_triangle(&m, i, f->tri[i].a, f->tri[i].b, f->tri[i].c);
    return m;
}

static first_instance first_of(affine m) { return first_instance_at(m.x, m.y, m.z, m.o); }

static void both_build(both *b, int n)
{
    failure f;
    b->knot = first_knot(40, 7), b->tree = first_bvh_build(&b->knot, true);
    b->mesh = mesh_of_knot(&b->knot);
    for (int i = 0; i < n; i++) {
        random_stream g = random_start(1, (uint64_t)i, 0);
        affine m = any_place(&g);
        b->one[i] = first_of(m), b->list[i] = (instance){m, 0};
    }
    b->first = (first_crowd){&b->tree, b->one, n};
    b->c = (crowd){&b->mesh, 1, b->list, (size_t)n};
    if (!instances_build(&b->c, instances_defaults, &b->x, &f)) fail(f);
}

static void both_free(both *b)
{
    instances_free(&b->x), mesh_free(&b->mesh), first_bvh_free(&b->tree), first_mesh_free(&b->knot);
}

static double apart(vec3 a, vec3 b) { return (double)vlength(vsub(a, b)); }

typedef struct { size_t rays, hits, lost, extra, other; double t, normal; } verdict;

/* Rays through the crowd, from a place D away from its middle. */
static verdict compare(const both *b, size_t n, real D)
{
    verdict v = {.rays = n};
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(2, i, 0);
        vec3 from = vscale(vunit(random_in_cube(&g, 1)), D), to = random_in_cube(&g, 8);
        ray r = ray_from(from, vunit(vsub(to, from)));
        hit h = hit_none;
        int which = -1;
        instance_hit due = {hit_none, 0};
        bool got = first_crowd_hit(&b->first, r, &h, &which), is = instances_hit(&b->x, r, &due);
        v.hits += is, v.lost += is && !got, v.extra += got && !is;
        if (!got || !is) continue;
        v.t = check_worse(v.t, fabs((double)(h.t - due.h.t)));
        if ((uint32_t)which != due.instance || h.shape != due.h.shape) v.other++;
        if ((uint32_t)which != due.instance || h.shape != due.h.shape) continue;
        vec3 normal = first_triangle_normal(b->knot.tri[h.shape]);
        normal = first_instance_normal(&b->one[which], normal);
        v.normal = check_worse(v.normal, apart(normal, instances_normal(&b->x, due)));
    }
    return v;
}

/* "far away, as 14 is": the knots are of size 4. */
static void test_hits(const both *b)
{
    size_t n = check_count(20000);
    verdict v = compare(b, n, 15);
    check_at_least(v.hits, n / 2, "meet a knot");
    check_equal(v.lost + v.extra, 0, "hits lost, or too many, of %zu", v.hits);
    check_at_most(v.other, 1, "another triangle: at an edge");
    check_at_most(v.t, 4000 * eps, "t");
    check_at_most(v.normal, 32 * eps, "first_instance_normal against normal_to_world");
    /* Lost are 3 of 100 in double, 1 of 800 in float. */
    v = compare(b, check_sample(20000, real_is_float ? 8000 : 1000),
                real_is_float ? (real)1.5e5 : (real)1.5e15);
    check_at_least(v.lost, 10, "lost from afar, of %zu", v.hits);
    check_at_least(v.other, v.hits / 20, "another triangle, from afar");
}

typedef struct { size_t first, full; } hit_count;

/* One knot under m, 1000 rays at it of the size k. */
static hit_count hits_of(both *b, affine m, real k)
{
    failure f;
    hit_count c = {0, 0};
    instances x;
    instance one = {m, 0};
    first_instance mine = first_of(m);
    first_crowd crowd_of_one = {&b->tree, &mine, 1};
    if (!instances_build(&(crowd){&b->mesh, 1, &one, 1}, instances_defaults, &x, &f)) fail(f);
    for (uint64_t i = 0; i < 1000; i++) {
        random_stream g = random_start(4, i, 0);
        vec3 from = vscale(random_in_cube(&g, 4), k), to = vscale(random_in_cube(&g, 2), k);
        ray r = ray_between(from, to);
        hit h;
        instance_hit due;
        int which;
        c.first += first_crowd_hit(&crowd_of_one, r, &h, &which);
        c.full += instances_hit(&x, r, &due);
    }
    instances_free(&x);
    return c;
}

/* "Wrong where det M is 0, as it is, rounded, at a scale of 1e-110 (1e-15 in float)". */
static void test_det(both *b)
{
    real small = real_is_float ? (real)1e-12 : (real)1e-100;
    hit_count c = hits_of(b, affine_scaling((vec3){small, small, small}), small);
    check(c.first == c.full && c.full > 300, "small: %zu of %zu hits", c.first, c.full);
    small = real_is_float ? (real)1e-15 : (real)1e-110;
    c = hits_of(b, affine_scaling((vec3){small, small, small}), small);
    check(c.first == 0 && c.full > 300, "smaller: %zu of %zu hits", c.first, c.full);
    c = hits_of(b, affine_scaling((vec3){1, 1, 0}), 1);
    check(c.first == 0 && c.full == 0, "flat: both say never");
}

static void test_degenerate(const both *b)
{
    first_crowd none = b->first;
    real bad = (real)NAN;
    hit h;
    int which;
    none.n = 0;
    check(!first_crowd_hit(&none, ray_from(vec(0, 0, 9), vec(0, 0, -1)), &h, &which), "none");
    vec3 d[] = {{0, 0, 0}, {bad, 0, 0}, {bad, bad, bad}};
    for (int k = 0; k < 3; k++)
        check(!first_crowd_hit(&b->first, ray_from(vec(0, 0, 9), d[k]), &h, &which), "%d", k);
    check(!first_crowd_hit(&b->first, ray_from((vec3){bad, 0, 0}, vec(0, 0, 1)), &h, &which),
          "no origin");
}

int main(void)
{
    static both b;
    both_build(&b, most);
    test_hits(&b);
    test_det(&b);
    test_degenerate(&b);
    both_free(&b);
    return check_report("16_first");
}
