/* 27's first.h: each effect's rule on scenes built for it; that what the plan leaves out brings
 * nothing, byte for byte, and takes no ray; what is left is what 18, 19 and 26 see. Fixed seeds;
 * each comparison by chance alarms falsely once in 1e8 seeds. */
#include "../common/lab/t_test.h"
#include "../chapters/26_path_tracer/first.h"
#include "../chapters/27_effects/first.h"
#include "check.h"

static const double sigmas = 5.8;
enum { most_depth = 40 };

/* ---- scenes ---- */

static const first_material matte = {.kd = {(real)0.5, (real)0.6, (real)0.7}};
static const first_material silver = {.mirror = {(real)0.9, (real)0.9, (real)0.9}};
static const first_material glass = {.ior = (real)1.5};
static const first_material lamp = {.ke = {3, 2, 1}}, shines = {.ke = {1, 1, 1}};

static first_scene sky(void)
{
    return (first_scene){.ambient = vec(0.1, 0.1, 0.1), .above = vec(0.2, 0.3, 0.6),
                         .below = vec(0.9, 0.8, 0.7),
                         .eps = real_is_float ? (real)1e-3 : (real)1e-5};  /* see 18 */
}

static void add_lamp(first_scene *s)
{
    first_add_flat(s, vec(-1, 3, -1), vec(2, 0, 0), vec(0, 0, 2), lamp);
}

static void add_floor(first_scene *s, first_material m)
{
    first_add_flat(s, vec(-3, 0, 3), vec(6, 0, 0), vec(0, 0, -6), m);
}

enum { EMPTY, BALL, FLOOR_BALL, MIRROR, GLASS, ONLY_LAMP, LAMP_FLOOR, LAMP_WALLS, LAMP_MIRROR,
       LAMP_FLOOR_MIRROR, BALL_SHINES, BOX, scenes };
static const struct {
    const char *name;
    bool panel, light, floor;
    const first_material *ball;
    bool called[first_effects];  /* shadow rays, mirror rays, glass, points of a lamp, bounces */
} list[scenes] = {
    [EMPTY] = {.name = "nothing"},
    [BALL] = {"a ball, a point light", false, true, false, &matte, {0}},
    [FLOOR_BALL] = {"floor, ball, point light", false, true, true, &matte, {1, 0, 0, 0, 0}},
    [MIRROR] = {"a mirror ball", false, false, false, &silver, {0, 1, 0, 0, 0}},
    [GLASS] = {"a glass ball", false, false, false, &glass, {0, 0, 1, 0, 0}},
    [ONLY_LAMP] = {"a lamp alone", true, false, false, NULL, {0, 0, 0, 1, 0}},
    [LAMP_FLOOR] = {"a lamp and a floor", true, false, true, NULL, {0, 0, 0, 1, 0}},
    [LAMP_WALLS] = {"a lamp, floor and ball", true, false, true, &matte, {0, 0, 0, 1, 1}},
    [LAMP_MIRROR] = {"a lamp and a mirror", true, false, false, &silver, {0, 1, 0, 1, 0}},
    [LAMP_FLOOR_MIRROR] = {"a lamp, a floor, a mirror", true, false, true, &silver,
                           {0, 1, 0, 1, 1}},
    [BALL_SHINES] = {"a ball that shines", false, false, false, &shines, {0}},
    [BOX] = {.name = "the Cornell box", .called = {0, 0, 0, 1, 1}}};

static first_scene scene_of(int which)
{
    first_scene s = sky();
    if (which == BOX) return first_cornell();
    if (list[which].panel) add_lamp(&s);
    if (list[which].light) s.light[s.lights++] = (first_light){vec(2, 4, 3), vec(20, 20, 20)};
    if (list[which].floor) add_floor(&s, matte);
    if (list[which].ball) first_add_ball(&s, vec(0, 1, 0), 1, *list[which].ball);
    return s;
}

static ray eye_ray(int which, uint64_t i)
{
    first_camera c = which == BOX ? first_cornell_camera(1, 1)
                                  : first_camera_at(vec(0, 2, 8), vec(0, 1, 0),
                                                    vec(0, 1, 0), 40, 1, 1);
    return first_ray_unit(first_camera_ray(c, random_real(1, i, 0, 0), random_real(1, i, 0, 1)));
}

static vec3 planned(const first_scene *s, const first_plan *p, ray r, uint64_t i)
{
    random_stream random = random_start(2, i, 0);
    return first_planned(s, p, r, true, most_depth, &random);
}

/* ---- the plan ---- */

/* And rays are shot for what is in the plan, and for nothing else. */
static void test_rules(void)
{
    for (int k = 0; k < scenes; k++) {
        first_scene s = scene_of(k);
        first_plan p = first_plan_of(&s);
        memset(first_rays, 0, sizeof first_rays);
        for (uint64_t i = 0; i < 2000; i++) planned(&s, &p, eye_ray(k, i), i);
        for (int e = 0; e < first_effects; e++) {
            check(p.on[e] == list[k].called[e], "%s: %s", list[k].name, first_effect_name[e]);
            check(p.because[e] && p.because[e][0], "%s: a reason", first_effect_name[e]);
            check((first_rays[e] > 0) == list[k].called[e], "%s: %s, %ld rays", list[k].name,
                  first_effect_name[e], first_rays[e]);
        }
    }
}

/* "Cannot occur": switched on by hand, all together, what is not in the plan changes no bit. Glass
 * throws a coin, and bounces do, so that in their scenes a point of a lamp drawn before it, or a
 * die, would change what follows: there only what draws nothing is switched on. And bounces between
 * floor and ball that a point light lights are left out by choice (test_what_it_gets_wrong). */
static void test_nothing_is_lost(void)
{
    for (int k = 0; k < scenes; k++) {
        first_scene s = scene_of(k);
        first_plan p = first_plan_of(&s), all = p;
        size_t differ = 0, n = check_count(20000);
        for (int e = 0; e < first_effects; e++)
            if (e < first_lamps || (!p.on[first_glass] && k != FLOOR_BALL)) all.on[e] = true;
        for (uint64_t i = 0; i < n; i++) {
            ray r = eye_ray(k, i);
            vec3 a = planned(&s, &p, r, i), b = planned(&s, &all, r, i);
            differ += memcmp(&a, &b, sizeof a) != 0;
        }
        check_equal(differ, 0, "%s: rays of %zu that see another colour", list[k].name, n);
    }
}

/* "With point lights only, light between walls is not traced, and `ambient` stands for it": two
 * white walls beside a light would be a quarter brighter, and more. And an eye inside of the one
 * ball, with the light outside, would see a shadow. */
static void test_what_it_gets_wrong(void)
{
    first_scene s = {.eps = (real)1e-5};
    first_material white = {.kd = vec(0.9, 0.9, 0.9)};
    double sum[2] = {0, 0};
    add_floor(&s, white);
    first_add_flat(&s, vec(-3, 0, -3), vec(6, 0, 0), vec(0, 6, 0), white);
    s.light[s.lights++] = (first_light){vec(0, 1, -2), vec(20, 20, 20)};
    for (int on = 0; on < 2; on++) {
        first_plan p = first_plan_of(&s);
        check(!p.on[first_bounces], "point lights call for no bounces");
        p.on[first_bounces] = on;
        for (uint64_t i = 0; i < check_count(20000); i++)
            sum[on] += (double)planned(&s, &p, eye_ray(FLOOR_BALL, i), i).y;
    }
    check_at_least(sum[1] / sum[0], 1.1, "light between the walls");
    first_scene ball = scene_of(BALL);
    first_plan p = first_plan_of(&ball);
    ray inside = ray_from(vec(0, 1, 0), vunit(vec(-2, -3, -3)));
    double lit = (double)planned(&ball, &p, inside, 0).y;
    p.on[first_shadows] = true;
    check_at_least(lit, (double)planned(&ball, &p, inside, 0).y + 0.1, "no shadow inside the ball");
}

/* ---- the picture is that of the chapters before ---- */

typedef enum { BY_SHADE, BY_WHITTED, BY_PATH } program;

static void same_light(const first_scene *s, int view, program which, const char *what)
{
    first_plan p = first_plan_of(s);
    estimate d[3] = {{0, 0, 0}};
    size_t n = check_count(which == BY_PATH ? 200000 : 50000);
    for (uint64_t i = 0; i < n; i++) {
        ray r = eye_ray(view, i);
        random_stream random = random_start(3, i, 0);
        vec3 a = planned(s, &p, r, i);
        vec3 b = which == BY_SHADE ? first_trace(s, r) : which == BY_WHITTED
               ? first_whitted(s, r, 12) : first_path(s, r, &random);
        vec3 off = vsub(a, b);
        for (int k = 0; k < 3; k++) d[k] = estimate_add(d[k], (double)vaxis(off, k));
    }
    for (int k = 0; k < 3; k++) {
        double rounding = 64 * (double)real_epsilon + (which == BY_WHITTED ? 2e-4 : 0);
        check_at_most(fabs(d[k].mean), sigmas * estimate_error(d[k]) + rounding, "%s, channel %d",
                      what, k);
        check_at_most(estimate_error(d[k]), 0.02, "%s: the noise", what);
    }
}

/* A flat mirror shows the lamp itself, its front and its back. */
static void test_lamp_in_a_mirror(void)
{
    for (int back = 0; back < 2; back++) {
        first_scene s = sky();
        vec3 a = vec(2, 0, 0), b = vec(0, 0, 2);
        first_add_flat(&s, vec(-1, 3, -1), back ? b : a, back ? a : b, lamp);
        add_floor(&s, silver);
        first_plan p = first_plan_of(&s);
        vec3 L = planned(&s, &p, ray_from(vec(-2, 2, 0), vunit(vec(1, -2, 0))), 0);
        check_close(L.x, back ? 0 : 3 * 0.9, 64 * (double)real_epsilon, "the lamp in a mirror, %s",
                    back ? "dark from behind" : "from before");
    }
}

static void test_odd_input(void)
{
    first_scene s = {.eps = (real)1e-5};
    first_material white = {.kd = vec(1, 1, 1), .ke = vec(1, 1, 1)};
    add_floor(&s, white);
    first_add_ball(&s, vec(0, 0, 0), -100, white);
    first_add_ball(&s, vec(0, 1, 0), 1, glass);
    first_plan p = first_plan_of(&s);
    bool finite = true;
    for (uint64_t i = 0; i < 20000; i++)
        finite = finite && vfinite(planned(&s, &p, eye_ray(FLOOR_BALL, i), i));
    check(finite, "a closed room that loses nothing: at most %d hits a path", most_depth);
    ray r = ray_from(vec(0, 1, 5), vec((double)NAN, 0, 0));
    planned(&s, &p, r, 0);
    check(vfinite(planned(&s, &p, ray_from(vec(0, 1, 5), vec(0, 0, 0)), 0)), "no direction");
}

int main(void)
{
    first_scene ball = scene_of(BALL), shadow = scene_of(FLOOR_BALL), two = first_two_balls();
    first_scene box = scene_of(BOX), room = scene_of(LAMP_WALLS);
    room.ambient = room.above = room.below = vec(0, 0, 0);
    same_light(&ball, BALL, BY_SHADE, "a ball, against 18");
    same_light(&shadow, FLOOR_BALL, BY_SHADE, "floor and ball, against 18");
    same_light(&two, FLOOR_BALL, BY_WHITTED, "two balls, against 19");
    same_light(&box, BOX, BY_PATH, "the Cornell box, against 26");
    same_light(&room, LAMP_WALLS, BY_PATH, "a lamp, floor and ball, against 26");
    return check_all("27_first", test_rules, test_nothing_is_lost, test_what_it_gets_wrong,
                     test_lamp_in_a_mirror, test_odd_input);
}
