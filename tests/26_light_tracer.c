/* Tests of 26_path_tracer: light against eye. Paths from the lamp and paths from the eye must find
 * the same radiance in every block of pixels. Fixed seeds; false alarms: once in 1e7 seeds. */
#include "../common/lab/t_test.h"
#include "../chapters/26_path_tracer/lab/pictures.h"
#include "../chapters/26_path_tracer/lab/showcase.h"
#include "check.h"

enum { side = 24, block = 4, in_row = side / block, blocks = in_row * in_row, sets = 24 };

/* Means of blocks of a picture, each set one sample of each block; the sum of all. It is freed. */
static void gather(image *im, estimate *e, estimate *whole)
{
    double sum[3 * blocks] = {0}, all = 0;
    for (int i = 0; i < 3 * side * side; i++) {
        int x = i / 3 % side, y = i / 3 / side;
        sum[3 * (y / block * in_row + x / block) + i % 3] += (double)im->rgb[i];
        all += (double)im->rgb[i];
    }
    for (int k = 0; k < 3 * blocks; k++) e[k] = estimate_add(e[k], sum[k] / (block * block));
    *whole = estimate_add(*whole, all);
    image_free(im);
}

static void from_eye(const showcase *c, estimate *e, estimate *whole)
{
    for (uint64_t set = 0; set < sets; set++) {
        const options o = {.seed = 100 + set};
        shot s = {.c = *c};
        shot_begin(&s, &o, path_defaults, film_new(side, side));
        passes_range(render_passes(&s.j), &s.film, 0, (uint32_t)check_sample(64, 8));
        image im = film_picture(&s.film);
        gather(&im, e, whole);
        film_free(&s.film), path_tracer_free(&s.t);
    }
}

static void from_lamp(const showcase *c, estimate *e, estimate *whole)
{
    light_tracer t;
    path_counts work = {0};
    light_tracer_of(&c->s, c->eye, side, side, &t);
    size_t n = check_sample(20000, 2000) / light_jobs * light_jobs;
    for (uint64_t set = 0; set < sets; set++) {
        image im;
        check(light_picture(&t, 200 + set, n, 0, &im, &work), "not stopped");
        gather(&im, e, whole);
    }
    image one, three;
    path_counts again = {0};
    light_picture(&t, 200, n / 8 / light_jobs * light_jobs, 1, &one, &again);
    light_picture(&t, 200, n / 8 / light_jobs * light_jobs, 3, &three, &again);
    check(memcmp(one.rgb, three.rgb, 3 * side * side * sizeof *one.rgb) == 0,
          "the same bytes for any number of threads");
    t.eye.d *= 2, t.eye.left *= 2, t.eye.right *= 2, t.eye.bottom *= 2, t.eye.top *= 2;
    image_free(&three);
    light_picture(&t, 200, n / 8 / light_jobs * light_jobs, 1, &three, &again);
    check(memcmp(one.rgb, three.rgb, 3 * side * side * sizeof *one.rgb) == 0,
          "the same bytes with the image plane twice as far away, and as large");
    image_free(&one), image_free(&three);
    check_equal(work.paths, sets * n, "paths");
    check(work.shadow <= work.camera + work.bounce + work.paths,
          "one ray to the eye a hit, and one of the lamp");
    path_tracer_free(&t.paths);
}

static void compare(const char *name, const showcase *c)
{
    estimate eye[3 * blocks] = {{0}}, lamp[3 * blocks] = {{0}};
    estimate a = {0}, b = {0};
    from_eye(c, eye, &a), from_lamp(c, lamp, &b);
    for (int k = 0; k < 3 * blocks; k++)
        check_at_least(welch_test(eye[k], lamp[k]), 1e-7 / (3 * blocks),
                       "%s, block %d, channel %d: eye %g, lamp %g", name, k / 3, k % 3,
                       eye[k].mean, lamp[k].mean);
    check_at_least(welch_test(a, b), 1e-7, "%s: the whole picture, eye %g, lamp %g", name, a.mean,
                   b.mean);
    check_at_most(estimate_error(b) / b.mean, 0.05, "%s: known to some percent", name);
}

/* Over a floor, under a lamp; with a table in the ball. */
static void glass_ball(showcase *c, material glass, bool with_table)
{
    *c = (showcase){.has_sky = false};
    lit_begin(&c->s);
    showcase_floor(&c->s, (vec3){0, 0, 0}, 4, vec(.5, .6, .7));
    uint16_t lamp = lit_add_material(&c->s, (material){.ke = vec(3, 2, 1)});
    uint16_t matte = lit_add_material(&c->s, (material){.kd = vec(.8, .8, .8)});
    lit_add_rectangle(&c->s, (rectangle){vec(-1, 4, -1), vec(2, 0, 0), vec(0, 0, 2)}, lamp);
    showcase_ball(&c->s, (vec3){0, 2, 0}, (real)0.7, glass);
    if (with_table)
        lit_add_rectangle(&c->s, (rectangle){vec(-.45, 2, -.45), vec(0, 0, .9), vec(.9, 0, 0)},
                          matte);
    lit_end(&c->s);
    c->eye = showcase_eye(vec(0, 1.1, 2), vec(0, 0, 0), 40, 1);
}

/* The Cornell box; a floor and a rough ball under a triangle that shines from both sides, and under
 * a ball; the caustic of a ball of dark glass that is itself out of sight: what is seen through
 * glass no path from the lamp can show; a table in the ball, seen from there. */
static void test_scenes(void)
{
    showcase c;
    failure f;
    check(showcase_of("cornell", 1, &c, &f), "the box");
    compare("cornell", &c);
    showcase_free(&c);
    c = (showcase){.has_sky = false};
    lit_begin(&c.s);
    showcase_floor(&c.s, (vec3){0, 0, 0}, 4, vec(.5, .6, .7));
    uint16_t lamp = lit_add_material(&c.s, (material){.ke = vec(3, 2, 1), .both = true});
    uint16_t dim = lit_add_material(&c.s, (material){.ke = vec(1, 1, 2)});
    lit_add_triangle(&c.s, (triangle){vec(-3, 2, -2), vec(-1, 2, -2), vec(-2, 3, 0)}, lamp);
    uint16_t rough = lit_add_material(&c.s, (material){.mirror = vec(.9, .9, .9), .alpha = 1});
    lit_add_shape(&c.s, shape_of_sphere((sphere){{2, 1, 0}, (real)0.5}), dim);
    lit_add_shape(&c.s, shape_of_sphere((sphere){{-2, 1, -1}, (real)0.9}), rough);
    lit_end(&c.s);
    c.eye = showcase_eye(vec(0, 4, 9), vec(0, 1, 0), 45, 1);
    compare("two lamps", &c);
    showcase_free(&c);
    material glass = material_glass((medium){1.5, vec(.8, .4, .1), 0}, 0);
    glass_ball(&c, glass, false);
    compare("a caustic", &c);
    for (size_t i = 0; i < c.s.materials; i++) c.s.material[i].alpha = (real)0.2;
    compare("a rough caustic", &c);
    showcase_free(&c);
    glass_ball(&c, material_glass((medium){.ior = 1.5}, 0), true);
    c.eye = showcase_eye(vec(0, 2.4, .1), vec(0, 2, 0), 70, 1);
    compare("in glass: radiance is squeezed, power is not", &c);
    showcase_free(&c);
}

/* A wall that shines, before an eye with a field of 120 degrees: every pixel sees Le, those in the
 * corners, too, where the cosine at the eye (26.8) is .38. */
static void test_wide(void)
{
    const double Le[3] = {3, 2, 1};
    showcase c = {.has_sky = false};
    estimate e[3 * blocks] = {{0}}, mean = {0};
    lit_begin(&c.s);
    uint16_t wall = lit_add_material(&c.s, (material){.ke = vec(3, 2, 1)});
    lit_add_rectangle(&c.s, (rectangle){{-2, -2, -1}, {4, 0, 0}, {0, 4, 0}}, wall);
    lit_end(&c.s);
    c.eye = showcase_eye((vec3){0, 0, 0}, (vec3){0, 0, -1}, 120, 1);
    from_lamp(&c, e, &mean);
    for (int k = 0; k < 3 * blocks; k++) {
        check_at_least(t_test(e[k], Le[k % 3], 0), 1e-7 / (3 * blocks),
                       "a wall of %g, block %d: %g", Le[k % 3], k / 3, e[k].mean);
        check_at_most(estimate_error(e[k]), 0.05 * Le[k % 3], "known to some percent");
    }
    showcase_free(&c);
}

int main(void)
{
    test_scenes();
    test_wide();
    return check_report("26_light_tracer");
}
