/* 19_whitted: the clear cases of ball_hit.h, the lanes and the suns' discs, each
 * against 03. All must be the same to the last bit. */
#include "check.h"
#include "child.h"
#include "../common/random.h"
#include "../chapters/19_whitted/scenes/forty.h"

static real spread(random_stream *s, real size) { return size * (2 * random_next(s) - 1); }

static vec3 anywhere(random_stream *s, real size)
{
    real x = spread(s, size), y = spread(s, size);
    return (vec3){x, y, spread(s, size)};
}

static vec3 any_direction(random_stream *s)
{
    return vunit(vadd(anywhere(s, 1), vec(0, 0, 1e-3)));
}

/* A ray that matters: from anywhere, from the ball's own surface in and out, from inside; past its
 * outline by some epsilons of its size. */
static ray hard_ray(random_stream *s, sphere b, size_t i)
{
    vec3 n = any_direction(s), d = any_direction(s), u, v;
    surface on = surface_on_sphere(b, 0, vmadd(b.c, n, b.r));
    if (i % 5 == 0) return ray_from(anywhere(s, 2 * b.r + vlength(b.c)), d);
    if (i % 5 == 1) return leave(on, d);
    if (i % 5 == 2) return ray_from(vmadd(b.c, n, b.r * random_next(s)), d);
    if (i % 5 == 3) return ray_from(on.p, d);  /* on it but for rounding, to either side */
    vbasis(n, &u, &v);
    vec3 rim = vmadd(b.c, u, b.r * (1 + spread(s, 64 * real_epsilon)));
    return ray_from(vmadd(rim, n, -b.r * (real)4 * random_next(s) * (i % 2 ? 100 : 1)), n);
}

static bool same(bool a, hit x, bool b, hit y)
{
    return a == b && (!a || (x.t == y.t && x.shape == y.shape));
}

static void test_ball_hit(void)
{
    size_t n = check_count(400000), wrong = 0, hits = 0, exits = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(1, i, 0);
        real size = pow((real)10, (real)((int)(i / 5 % 7) - 3));
        sphere b = {anywhere(&s, i % 3 ? 1 : 1000), size};
        ray r = hard_ray(&s, b, i);
        if (i % 11 == 0) r.tmax = size * random_next(&s);
        if (i % 13 == 0) r.tmin = size * random_next(&s);
        hit x = hit_none, y = hit_none;
        bool a = sphere_hit(b, r, &x), c = ball_hit(&b, &r, &y);
        wrong += !same(a, x, c, y), hits += a;
        /* inside by more than rounding, as after leave */
        if (i % 5 == 1 && !ball_outwards(&b, &r) && r.tmin == 0)
            y = hit_none, c = ball_exit(&b, &r, &y), wrong += !same(a, x, c, y), exits++;
    }
    check_equal(wrong, 0, "of %zu rays answered in another way than by 03", n);
    check_at_least(hits, n / 3, "hits among them");
    check_at_least(exits, n / 20, "exits among them");
}

/* Against the loop of hit.h. Small and large, near the origin and far from it, in each other, twice
 * the same; rays that pass an outline, that begin on a ball and in one. */
static void test_lanes(void)
{
    size_t n = check_count(4000), wrong = 0, hits = 0, first = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(2, i, 0);
        sphere b[ball_lanes_most];
        size_t count = 1 + i % ball_lanes_most;
        vec3 middle = anywhere(&s, i % 4 ? 1 : (real)1e4);
        for (size_t k = 0; k < count; k++) {
            real size = pow((real)10, spread(&s, i % 3 ? 1 : 3));
            b[k] = (sphere){vadd(middle, anywhere(&s, 8)), size};
            if (k % 8 == 7) b[k] = b[k - 1];
        }
        if (i % 5 == 0) b[0] = (sphere){{0, 0, -(real)1e5}, 1e5};
        ball_lanes lanes;
        check(ball_lanes_fill(b, count, &lanes), "fits");
        for (size_t k = 0; k < 40; k++) {
            uint32_t at = (uint32_t)(k % count), from = no_shape;
            ray r = hard_ray(&s, b[at], k);
            if (k % 5 == 1 && ball_outwards(&b[at], &r)) from = at;
            hit x, y = hit_none, h;
            ray rest = r;
            bool a = ball_lanes_hit(&lanes, b, r, from, &x);
            for (uint32_t j = 0; j < count; j++)
                if (sphere_hit(b[j], rest, &h) && (h.shape = j, j != from && hit_before(h, y)))
                    y = h, rest.tmax = h.t;
            wrong += !same(a, x, y.shape != no_shape, y), hits += a, first += a && y.t == 0;
        }
    }
    check_equal(wrong, 0, "of %zu rays", 40 * n);
    check_at_least(hits, 10 * n, "hits among them");
    sphere many[ball_lanes_most + 1] = {{{0, 0, 0}, 1}};
    ball_lanes lanes;
    check(!ball_lanes_fill(many, ball_lanes_most + 1, &lanes) && lanes.n == 0, "65 do not fit");
    check(!ball_lanes_fill(many, 0, &lanes), "none");
}

/* Shadow rays that pass the outline of a ball within some epsilons, or begin within some epsilons
 * of its surface, from a small ball placed there; a ground, that shades none. */
static void test_suns(void)
{
    size_t n = check_count(1500), wrong = 0, shaded = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(3, i, 0);
        vec3 l = any_direction(&s), u, v;
        l.z = fabs(l.z);
        light sun = {LIGHT_DIRECTIONAL, l, {1, 1, 1}};
        real part[4] = {0.5, 0, 0.25, 0}, size = pow((real)10, spread(&s, 2));
        sphere b[4] = {{anywhere(&s, 3), size}, {{0, 0, -1010}, 1000}};
        vbasis(l, &u, &v);
        real off = 1 + spread(&s, (i % 3 ? 64 : 4096) * real_epsilon), r = size / 64;
        vec3 at = i % 4 ? vmadd(vmadd(b[0].c, u, size * off), l, size * spread(&s, 2))
                        : vmadd(b[0].c, any_direction(&s), size * off);
        b[2] = (sphere){vmadd(at, l, -r), r};        /* begins at `at`, straight up */
        b[3] = (sphere){vadd(b[0].c, anywhere(&s, 2 * size)), size * random_next(&s)};
        balls all;
        balls_build(b, 4, part, &sun, 1, &all);
        for (uint32_t from = 0; from < 4; from++)
            for (int k = 0; k < 4; k++) {
                vec3 normal = k ? any_direction(&s) : l;
                surface on = surface_on_sphere(b[from], from, vmadd(b[from].c, normal, b[from].r));
                if (!(vdot(on.n, l) > 0)) on.n = vneg(on.n);  /* seen from inside */
                ray q = leave(on, l);
                real lit = balls_light(&all, q, 0, from, part), expected = 1;
                hit h;
                for (int j = 0; j < 4; j++)
                    if (sphere_hit(b[j], q, &h)) expected *= part[j];
                wrong += lit != expected, shaded += expected < 1;
            }
        balls_free(&all);
    }
    check_equal(wrong, 0, "of %zu shadow rays", 16 * n);
    check_at_least(shaded, 2 * n, "in shade among them");
}

static void build_lit(void *lights)
{
    const sphere s = {{0, 0, 0}, 1};
    const real shadow = 0;
    balls all;
    int n = 0;
    while (n < 9 && ((const light *)lights)[n].colour.x > 0) n++;
    balls_build(&s, 1, &shadow, lights, n, &all);
    balls_free(&all);
}

/* A beam is made for parallel light, and there is room for eight. */
static void test_lights_refused(void)
{
    light L[10] = {{LIGHT_POINT, {0, 0, 1}, {0, 0, 0}}};
    for (int k = 0; k < 8; k++) L[k] = (light){LIGHT_DIRECTIONAL, {0, 0, 1}, {1, 1, 1}};
    check_equal(child_run(build_lit, L).status, 0, "eight suns");
    L[8] = L[0];
    child_result r = child_run(build_lit, L);
    check(r.status == 2 && strstr(r.err, "up to 8 lights"), "nine suns: %d, %s", r.status, r.err);
    L[1].kind = LIGHT_POINT, L[8].colour.x = 0;
    r = child_run(build_lit, L);
    check(r.status == 2 && strstr(r.err, "all directional"), "a lamp: %d, %s", r.status, r.err);
}

int main(void)
{
    test_lights_refused();
    test_ball_hit();
    test_lanes();
    test_suns();
    return check_report("19_balls");
}
