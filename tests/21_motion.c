/* 21_distributed: motion: the share of the time against its closed form; a ray that is moved back
 * against shapes that are moved; nothing drawn where nothing moves. */
#include "check.h"
#include "../chapters/21_distributed/lab/known.h"
#include "../chapters/21_distributed/lab/pool.h"

static tracer asking(const trace_world *w)
{
    return (tracer){.w = w, .program = distributed_programs};
}

static material plain(const void *context, trace_hit x, const surface *s)
{
    (void)context, (void)x, (void)s;
    return (material){vec(0.5, 0.4, 0.3), vec(0.3, 0.3, 0.3), real_infinity, {0, 0, 0}};
}

static const trace_world nothing = {.part = NULL};

typedef struct { shape shapes[1]; scene s; world_part part; moving m; } flying;

static void flying_ball(flying *f, sphere b, vec3 v)
{
    f->shapes[0] = shape_of_sphere(b), f->s = (scene){f->shapes, 1};
    world_part_of_scene(&f->s, MASK_ALL, &f->part);
    f->m = (moving){{&f->part, 1}, v};
}

/* (21.18): at n times, in the middles of n equal parts, the ray meets the ball or not. It does from
 * one time to another: n shares are off by one at most; two, for ends that are rounded. */
static void test_passing(void)
{
    enum { n = 64 };
    random_stream s = random_start(5, 0, 0);
    double off = 0;
    size_t cut = 0;
    for (size_t i = 0; i < check_count(2000); i++) {
        sphere b = {vscale(random_unit(&s), 3), random_between(&s, 0.2, 1)};
        vec3 o = vscale(random_unit(&s), 9), v = vscale(random_unit(&s), random_between(&s, 0, 4));
        vec3 d = vsub(vmadd(b.c, random_unit(&s), (real)1.5), o);
        flying f;
        flying_ball(&f, b, v);
        tracer t = asking(&nothing);
        int met = 0;
        for (int k = 0; k < n; k++)
            met += motion_any(&t, &f.m, 1, ((real)k + (real)0.5) / n, RAY_SIGHT, ray_from(o, d));
        off = check_worse(off, fabs((double)met / n - known_passing(o, d, b, v)));
        cut += met > 0 && met < n;
        world_part_free(&f.part);
    }
    check_at_most(off, 2.0 / n, "share of the time");
    check(cut > 10, "many come or go in between");
    check_equal(known_passing(vec(0, 0, 5), vec(0, 0, -1), (sphere){{0, 0, 0}, 1}, vec(0, 0, 3)), 1,
                "towards the eye: always");
    check_close(known_passing(vec(0, 0, 5), vec(0, 0, -1), (sphere){{-2, 0, 0}, 1}, vec(4, 0, 0)),
                0.5, 8 * (double)real_epsilon, "a diameter of 2 in a way of 4");
}

/* The same hit as of the ball moved: t, point and normal. Near the limb roundings decide. */
static void test_moved(void)
{
    random_stream s = random_start(6, 0, 0);
    double off = 0, eps = (double)real_epsilon;
    size_t other = 0, met = 0;
    for (size_t i = 0; i < check_count(20000); i++) {
        sphere b = {vscale(random_unit(&s), 3), random_between(&s, 0.2, 1)}, there = b;
        vec3 v = vscale(random_unit(&s), random_between(&s, 0, 4)), by;
        real time = random_next(&s);
        flying f;
        flying_ball(&f, b, v);
        there.c = vmadd(b.c, v, time);
        shape moved = shape_of_sphere(there);
        vec3 o = vscale(random_unit(&s), 9), at = vmadd(there.c, random_unit(&s), b.r);
        vec3 d = vunit(vsub(at, o));
        tracer t = asking(&nothing);
        distributed how = {.material_of = plain};
        t.user = &how;
        distributed_met x = {.met = false};
        hit h = hit_none;
        bool one = motion_closest(&t, &f.m, 1, time, RAY_CAMERA, ray_from(o, d), &x, &x.t, &by);
        bool two = sphere_hit(there, ray_from(o, d), &h);
        real passes = vlength(vcross(vsub(there.c, o), d)) / b.r;
        if (fabs((double)passes - 1) > 1e3 * eps) other += one != two;
        if (one && two && passes < (real)0.9) {
            surface a = motion_surface(x.s, by), c = surface_of_shape(&moved, ray_from(o, d), h);
            off = check_worse(off, fabs((double)(x.t - h.t)) + (double)vlength(vsub(a.n, c.n))
                                   + (double)vlength(vsub(a.p, c.p)));
            met++;
        }
        world_part_free(&f.part);
    }
    check_equal(other, 0, "met by one and missed by the other");
    check(met > 100, "many are met");
    /* some 20 roundings of numbers up to 16, a point's error over the cosine at .9 and over r */
    check_at_most(off, 20 * 16 * 2.3 * 5 * eps, "time, point and normal");
}

/* Convex: no ray that leaves it, moved along, meets it again, however far away and however fast.
 * And what nearly touches it does hide. */
static void test_leaves(void)
{
    random_stream s = random_start(7, 0, 0);
    size_t again = 0, leaks = 0, n = check_count(40000);
    for (size_t i = 0; i < n; i++) {
        double far = pow(10, (double)random_between(&s, -2, 6));
        sphere b = {vscale(random_unit(&s), (real)far), pow((real)10, random_between(&s, -2, 2))};
        b.r = real_max(b.r, (real)1e3 * real_epsilon * (real)far);  /* it has points */
        vec3 v = vscale(random_unit(&s), (real)pow(10, (double)random_between(&s, -2, 6))), by;
        vec3 w = random_unit(&s);
        real time = random_next(&s);
        flying f;
        flying_ball(&f, b, v);
        vec3 n0 = random_unit(&s);
        surface a = surface_on_sphere(b, 0, vmadd(b.c, n0, b.r));
        by = vscale(v, time), a = motion_surface(a, by);
        if (vdot(w, a.n) < 0) w = vneg(w);
        tracer t = asking(&nothing);
        if (vdot(w, a.n) > (real)1e-3)
            again += motion_any(&t, &f.m, 1, time, RAY_SHADOW, leave(a, w));
        /* a small ball above it, a gap of 64 roundings away */
        real gap = 64 * real_epsilon * (surface_reach(a.p) + vlength(b.c) + b.r);
        shape near[1] = {shape_of_sphere((sphere){vmadd(a.p, a.n, 33 * gap), 32 * gap})};
        scene others = {near, 1};
        world_part part;
        world_part_of_scene(&others, MASK_ALL, &part);
        trace_world world = {&part, 1};
        tracer over = asking(&world);
        leaks += !motion_any(&over, &f.m, 1, time, RAY_SHADOW, leave(a, a.n));
        world_part_free(&part), world_part_free(&f.part);
    }
    check_equal(again, 0, "a ball that goes by hides itself");
    check_equal(leaks, 0, "rays that miss what nearly touches the ball");
}

/* ---- pictures ---- */

enum { w = 32, h = 18 };

/* Balls that could move and do not: the same as in the world that rests, to the last bit; and a
 * world where nothing moves asks for no time. */
static void test_at_rest(void)
{
    pool *still = pool_new(0);
    image a = image_new(w, h), b = image_new(w, h);
    distributed_view v = pool_view(still, (real)w / h);
    v.samples = 4;
    distributed_draw(&v, &a, 2);
    check_equal(v.spent.drawn[DRAWN_TIME], 4 * w * h, "a time a sample, not a ray");
    size_t shadow = v.spent.rays.rays[RAY_SHADOW];
    scene all = {still->ball, pool_balls};
    world_part_free(&still->part[1]), world_part_of_scene(&all, MASK_ALL, &still->part[1]);
    still->how.movers = 0;
    distributed_draw(&v, &b, 1);
    check_equal(v.spent.drawn[DRAWN_TIME], 0, "nothing moves, no number");
    check_equal(v.spent.rays.rays[RAY_SHADOW], shadow, "and no ray more or less");
    check_equal(memcmp(a.rgb, b.rgb, 3 * sizeof *a.rgb * w * h), 0, "the same picture");
    image_free(&a), image_free(&b), pool_free(still);
}

/* Each sample sees what it would see of a world that stands still where everything is at its time:
 * eye, shadow and reflected rays alike. Rays at the very edge of something may differ. */
static void test_one_time(void)
{
    size_t other = 0, n = check_count(800), moved = 0;
    pool *g = pool_new(1);
    g->how.material_of = plain;
    distributed_view v = pool_view(g, (real)w / h);
    distributor d = distributor_of(&g->w, &g->how);
    for (size_t i = 0; i < n; i++) {
        distributed_sample q = {SEQUENCE_RANDOM, 9, i, 0, 1};
        real time = distributed_pair(&d, q, DRAWN_TIME, PAIR_TIME).u;
        pool *still = pool_new(0);
        for (int k = 0; k < pool_moving; k++) {
            sphere *b = &still->ball[pool_rest + k].sphere;
            b->c = vadd(b->c, vscale(g->moving[k].v, time));
            world_part_free(&still->fast_part[k]);
            world_part_of_scene(&still->fast[k], MASK_ALL, &still->fast_part[k]);
        }
        still->how.material_of = plain;
        distributor e = distributor_of(&still->w, &still->how);
        size_t before = d.t.counts.rays[RAY_REFLECTION];
        ray r = camera_ray(v.c, (real)(i * 7 % w) + (real)0.3, (real)(i * 5 % h) + (real)0.3, w, h);
        vec3 x = distributed_ray(&d, r, q), y = distributed_ray(&e, r, q);
        other += !((double)vlength(vsub(x, y)) <= 1e3 * (double)real_epsilon * (1 + (double)x.x));
        moved += d.t.counts.rays[RAY_REFLECTION] > before;
        pool_free(still);
    }
    check_at_most(other, n / 50, "samples that see something else than at rest");
    check(moved > n / 2, "most of them have reflections");
    pool_free(g);
}

int main(void)
{
    test_passing();
    test_moved();
    test_leaves();
    test_at_rest();
    test_one_time();
    return check_report("21_motion");
}
