/* 18's first.h: the radiance that shade.h finds on a scene of a sane size; where its eps leaks,
 * where it makes acne, and that leave.h does neither. */
#include "check.h"
#include "../common/random.h"
#include "19_first_world.h"

static const double ulp = (double)real_epsilon;
static const vec3 sky = {(real)0.25, (real)0.4, (real)0.7}, ambient = {(real)0.1, (real)0.2, 1};
enum { balls = 5 };

/* The same things for both: five balls over a floor, as first.h has them and as 19's stage has. */
typedef struct {
    first_scene s;
    first_world *world;
    shading how;
} both;

static material both_look(const void *world, trace_hit x, const surface *s)
{
    whitted_look room;
    return first_world_look(world, &x, s, &room)->base;
}

/* All of it moved by `far` along each axis. */
static void both_build(both *x, real far)
{
    vec3 by = {far, far, far}, a = {24, 0, 0}, b = {0, 0, -24};
    *x = (both){.s = {.ambient = ambient, .above = sky, .below = sky, .eps = (real)1e-4}};
    first_add_flat(&x->s, vadd(by, vec(-12, -0.1, 12)), a, b,
                   (first_material){.kd = vec(0.75, 0.7, 0.62), .ke = vec(0, 0.1, 0)});
    for (int i = 0; i < balls; i++) {
        real angle = 2 * pi * (real)i / balls, R = (real)(6 + i) / 8;
        vec3 c = vadd(by, (vec3){2 * cos(angle), R + (real)0.125, 2 * sin(angle)});
        first_add_ball(&x->s, c, R, (first_material){.kd = vec(0.5, 0.1 * i, 0.3),
                                                     .ks = vec(0.5, 0.4, 0.3),
                                                     .shine = (real)(10 << i)});
    }
    x->s.light[x->s.lights++] = (first_light){vadd(by, vec(-5, 9, 6)), vec(330, 300, 250)};
    x->s.light[x->s.lights++] = (first_light){vadd(by, vec(8, 5, 4)), vec(30, 50, 90)};
    x->world = first_world_new(&x->s, 1);
    x->how = (shading){.lights = x->world->on.light, .n = 2, .material_of = both_look,
                       .context = x->world, .background = sky, .ambient = ambient};
}

static vec3 full_trace(const both *x, ray r)
{
    tracer t = {.w = &x->world->on.world, .program = shade_programs, .user = &x->how};
    return shade_ray(&t, r);
}

static double apart(vec3 a, vec3 b) { return (double)vlength(vsub(a, b)); }

/* From an eye that circles the balls, now and then below the floor, to a point near them. */
static ray eye_ray(uint64_t i, real far)
{
    random_stream s = random_start(1, i, 0);
    real turn = 2 * pi * random_next(&s), up = (i % 8 ? 2 : -6) + 4 * random_next(&s);
    vec3 by = {far, far, far}, from = {9 * cos(turn), up, 9 * sin(turn)}, to;
    to = vec(6.0 * (double)random_next(&s) - 3, 2.0 * (double)random_next(&s),
             6.0 * (double)random_next(&s) - 3);
    return ray_between(vadd(by, from), vadd(by, to));
}

/* An edge of a thing or of a shadow lies within 2e-3 of where the ray ends: there shade.h itself
 * says this colour here and another one beside it. */
static bool near_edge(const both *x, ray r, vec3 c)
{
    vec3 a, b;
    vbasis(vunit(r.d), &a, &b);
    for (int k = 0; k < 4; k++) {
        ray beside = r;
        beside.d = vmadd(r.d, k < 2 ? a : b, k % 2 ? (real)2e-3 : (real)-2e-3);
        if (apart(full_trace(x, beside), c) > 0.02 * (0.1 + (double)vlength(c))) return true;
    }
    return false;
}

/* A ball's radius is a tenth of its distance: the textbook's root is off by some 100 eps, near the
 * outline by five times that, and a highlight's exponent, up to 160, multiplies it. */
static void test_easy(void)
{
    both x;
    both_build(&x, 0);
    size_t n = check_count(40000), asked = 0, lit[3] = {0};
    double worst = 0;
    for (size_t i = 0; i < n; i++) {
        ray r = eye_ray(i, 0);
        r.tmax = real_infinity;
        vec3 c = full_trace(&x, r);
        if (near_edge(&x, r, c)) continue;
        vec3 d = first_trace(&x.s, r);
        worst = check_worse(worst, apart(c, d) / (1 + (double)vlength(c)));
        hit h;
        bool met = first_scene_hit(&x.s, r, &h);
        asked++, lit[!met ? 0 : x.s.thing[h.shape].ball.r != 0 ? 1 : 2]++;
    }
    check_at_least(asked, n / 2, "rays away from edges, of %zu", n);
    for (int k = 0; k < 3; k++)
        check_at_least(lit[k], asked / 100, "see sky, balls, floor: %d", k);
    check_at_most(worst, 5e4 * ulp, "radiance of first_trace against shade.h's");
    first_world_free(x.world);
}

/* What shade.h has no word for: the sky's two colours, dark squares, the side that is seen. */
static void test_closed_forms(void)
{
    first_scene s = {.above = vec(1, 2, 3), .below = vec(3, 2, 1), .eps = (real)1e-4};
    check(apart(first_background(&s, vec(0, 7, 0)), s.above) <= 4 * ulp, "overhead");
    check(apart(first_background(&s, vec(0, -7, 0)), s.below) <= 4 * ulp, "underfoot");
    check(apart(first_background(&s, vec(7, 0, 0)), vec(2, 2, 2)) <= 4 * ulp, "half of both");
    first_add_flat(&s, vec(0, 0, 0), vec(0, 0, 8), vec(8, 0, 0),
                   (first_material){.kd = vec(1, 1, 1), .checks = 8});
    first_add_ball(&s, vec(0, 99, 0), 2, (first_material){.kd = vec(1, 1, 1)});
    size_t wrong = 0;
    for (int i = 0; i < 64; i++)
        for (int k = -1; k <= 1; k += 2) {
            ray r = ray_from(vec(i % 8 + 0.5, k, i / 8 + 0.5), vec(0, -3 * k, 0));
            hit h = {0, 0, 0, 7};
            bool met = first_scene_hit(&s, r, &h);
            first_point at = first_point_at(&s, r, h);
            double kd = (i + i / 8) % 2 ? 0.15 : 1;
            wrong += !met || h.shape != 0 || fabs((double)at.kd.x - kd) > ulp || at.n.y != (real)k
                     || at.v.y != (real)k || at.inside != (k < 0);
        }
    check_equal(wrong, 0, "64 squares from both sides: colour, and which side is seen");
    ray r = ray_from(vec(0, 99, 0), vec(1, 0, 0));
    hit h;
    check(first_scene_hit(&s, r, &h) && h.t == 2 && first_point_at(&s, r, h).inside, "in a ball");
}

typedef struct { size_t asked, first, full; } wrong_count;

/* The scene moved by `far` along each axis: at how many points, away from edges, is the colour off
 * by a fiftieth? */
static wrong_count acne(real far, real e)
{
    both x, home;
    wrong_count c = {0, 0, 0};
    both_build(&x, far), both_build(&home, 0);
    x.s.eps = e;
    for (size_t i = 0; i < 20000; i++) {
        ray r = eye_ray(i, far), due = eye_ray(i, 0);
        r.tmax = due.tmax = real_infinity;
        vec3 expected = full_trace(&home, due);
        if (near_edge(&home, due, expected)) continue;
        double most = 0.02 * (double)vlength(expected);
        c.asked++;
        c.first += !(apart(first_trace(&x.s, r), expected) < most);
        c.full += !(apart(full_trace(&x, r), expected) < most);
    }
    first_world_free(x.world), first_world_free(home.world);
    return c;
}

/* "from 1e12 on (in float from 1000) surfaces shade themselves": by chance where light grazes them,
 * ten times farther off at one point in fifteen. */
static void test_acne(void)
{
    real far = real_is_float ? (real)1e3 : (real)1e12, usual = (real)1e-4;
    wrong_count near = acne(far / 10, usual), at = acne(far, usual), beyond = acne(10 * far, usual);
    wrong_count none = acne(0, 0);
    check_equal(near.first, 0, "a tenth as far: of %zu", near.asked);
    check_at_least(at.first, 2, "acne of the first version, of %zu", at.asked);
    check_equal(at.full, 0, "none of leave.h");
    check_at_least(beyond.first, beyond.asked / 20, "ten times as far, of %zu", beyond.asked);
    check_at_most(beyond.full, beyond.asked / 1000, "leave.h there");
    check_at_least(none.first, none.asked / 5, "eps = 0: acne at home, of %zu", none.asked);
}

/* "eps leaves out what is nearer than that", as part of the way to the light. A plate hovers over a
 * floor, a lamp stands 4 above it: is the point below the plate in its shadow? */
static wrong_count lit_below(real gap)
{
    wrong_count c = {0, 0, 0};
    for (uint64_t i = 0; i < 2000; i++) {
        vec3 p = {random_real(2, i, 0, 0), random_real(2, i, 1, 0), 0}, up = {0, 0, 1};
        vec3 lamp = vmadd(p, up, 4), n = {0, 0, 1}, x = {2, 0, 0}, y = {0, 2, 0};
        vec3 low = vec(-0.5, -0.5, 0), high = vmadd(low, up, gap);
        first_scene s = {.eps = (real)1e-4};
        first_add_flat(&s, low, x, y, (first_material){.kd = vec(1, 1, 1)});
        first_add_flat(&s, high, x, y, (first_material){.kd = vec(1, 1, 1)});
        s.light[s.lights++] = (first_light){lamp, vec(1, 1, 1)};
        first_point at = {.p = p, .n = n, .v = n, .m = &s.thing[0].m, .kd = s.thing[0].m.kd};
        triangle plate = {high, vmadd(high, x, 2), vmadd(high, y, 2)};
        surface on = surface_on_triangle((triangle){low, vmadd(low, x, 2), vmadd(low, y, 2)}, 0,
                                         (p.x - low.x) / 4, (p.y - low.y) / 4);
        hit h;
        c.asked++;
        c.first += !vzero(first_shade(&s, at));
        c.full += !triangle_hit(plate, leave_to(on, lamp), &h);
    }
    return c;
}

static void test_leak(void)
{
    wrong_count closer = lit_below((real)3.6e-4), farther = lit_below((real)4.4e-4);
    wrong_count touching = lit_below(64 * real_epsilon);
    check_equal(closer.first, closer.asked, "0.9 eps of the way: light comes in under the plate");
    check_equal(farther.first, 0, "1.1 eps of the way: it doesn't");
    check_equal(closer.full + farther.full, 0, "nor by leave.h");
    check_equal(touching.first, touching.asked, "a plate 64 roundings above casts no shadow");
    check_equal(touching.full, 0, "by leave.h it does");
}

/* Nothing at all, things without area or size, more than fit, rays that are none: an answer. */
static void test_degenerate(void)
{
    first_scene s = {.above = sky, .below = sky, .eps = (real)1e-4};
    first_material grey = {.kd = vec(1, 1, 1), .checks = 8};
    ray r = ray_from((vec3){0, 0, 5}, (vec3){0, 0, -1});
    real bad = (real)NAN;
    hit h;
    check(apart(first_trace(&s, r), sky) <= ulp && !first_occluded(&s, r), "an empty scene: sky");
    first_add_flat(&s, vec(0, 0, 0), vec(1, 1, 0), vec(2, 2, 0), grey);
    first_add_flat(&s, vec(0, 0, 0), vec(0, 0, 0), vec(0, 0, 0), grey);
    first_add_ball(&s, (vec3){bad, 0, 0}, 1, grey), first_add_ball(&s, vec(0, 0, 0), bad, grey);
    check(!first_scene_hit(&s, r, &h), "no area, no number: never hit");
    for (int i = 0; i < 40; i++) first_add_ball(&s, vec(0, 0, 0), 1, grey);
    check_equal(s.things, first_most_things, "what does not fit is left out");
    s.light[s.lights++] = (first_light){vec(0, 0, 0), vec(1, 1, 1)};
    check(first_scene_hit(&s, r, &h) && h.t == 4, "the ball is there");
    check(vfinite(first_trace(&s, r)), "a lamp inside it");
    s.light[0].p = vec(0, 0, 1);
    check(vfinite(first_trace(&s, r)), "a lamp at the very point");
    vec3 d[] = {{0, 0, 0}, {bad, 0, 0}, {0, 0, -real_infinity}};
    for (int k = 0; k < 3; k++)
        check(!first_scene_hit(&s, ray_from(r.o, d[k]), &h), "no direction: a miss, %d", k);
    r.o.x = bad;
    check(!first_scene_hit(&s, r, &h), "no origin");
}

int main(void)
{
    return check_all("18_first", test_easy, test_closed_forms, test_acne, test_leak,
                     test_degenerate);
}
