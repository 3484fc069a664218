/* Tests of chapter 27: the short book's first.h beside the full version: that on the six
 * scenes both see the same light where they must, and that they do not where the page says so.
 */
#include "../chapters/27_effects/lab/six.h"
#include "../common/lab/t_test.h"
#include "check.h"

typedef struct { effects_ready full; first_scene f; } pair;

/* NEAR: lit by a point light in place of the sun, about as bright: first.h has no sun, and in float
 * what stands for it is a hundredth off. BLACK: nothing behind it. */
enum { AS_IT_IS, NEAR, BLACK };

/* `line` in place of the line of text that begins with `word`. */
static void put_line(char text[six_room], const char *word, const char *line)
{
    char from[six_room];
    snprintf(from, sizeof from, "%s", text);
    const char *at = strstr(from, word), *end = strchr(at, '\n') + 1;
    snprintf(text, six_room, "%.*s%s%s", (int)(at - from), from, line, end);
}

/* Scene k of the six. */
static void pair_open(pair *q, int k, int how)
{
    char text[six_room];
    failure f;
    six_text(k, text);
    check(six_as_first(k, &q->f), "%s: first.h has it", six_list[k].name);
    if (how & NEAR) {
        put_line(text, "sun", "light at 6 4.4 8 colour 350\n");
        q->f.light[0] = (first_light){vec(6, 4.4, 8), vec(350, 350, 350)};
    }
    if (how & BLACK)
        put_line(text, "background", "background 0\n"), q->f.above = q->f.below = vec(0, 0, 0);
    if (!studio_read_text(text, "test.scene", NULL, &q->full.s, &f)) fail(f);
    if (!effects_get_ready(&q->full, 4 / (real)3, &f)) fail(f);
}

/* ---- the same light ---- */

/* Of rays of the eye, the difference first - full, and the light that the full version sees. */
static estimate light_apart(const pair *q, size_t n, double *mean)
{
    enum { w = 64, h = 48 };
    estimate d = {0}, all = {0};
    const studio_view *v = &q->full.view;
    first_plan p = first_plan_of(&q->f);
    effects_function *full = effects_made_for(q->full.e.mask);
    for (size_t i = 0; i < n; i++) {
        random_stream at = random_start(5, i, 0), random = random_start(6, i, 0);
        dice_pixel of;
        dice_pixel_of(7, i, true, &of);
        dice throws = dice_sample(&of, 0);
        effects_counts c = {.lost = 0};
        real x = random_between(&at, 0, w), y = random_between(&at, 0, h);
        ray r = camera_ray(q->full.e.eye, x, y, w, h);
        vec3 L = effects_alone(full, &q->full.e, r, (media_set){0}, &throws, &c);
        first_camera eye = first_camera_at(v->from, v->at, v->up, v->angle, w, h);
        vec3 F = first_planned(&q->f, &p, first_ray_unit(first_camera_ray(eye, x, y)), true,
                               first_row_depth, &random);
        all = estimate_add(all, (double)(L.x + L.y + L.z) / 3);
        d = estimate_add(d, (double)((F.x + F.y + F.z) - (L.x + L.y + L.z)) / 3);
    }
    *mean = all.mean;
    return d;
}

/* least, most: of what first.h sees more, as a part of all, by six standard errors; 0, 0: nothing,
 * by a t-test that alarms falsely once in 1e7 seeds. Forgiven is what the sun's distance and the
 * eps of shadow rays bring, in double each 5e-7 of the whole, and the pixels' own contrast. */
static void test_light(int k, int how, double least, double most)
{
    const char *name = six_list[k].name;
    pair q;
    double mean;
    if (real_is_float && !(how & NEAR)) return;
    pair_open(&q, k, how);
    estimate d = light_apart(&q, check_sample(200000, 10000), &mean);  /* fewer see nothing */
    double rounding = (how & NEAR ? 256 * (double)real_epsilon : 1e-5) * mean;
    check_at_most(estimate_error(d), 0.01 * mean, "%s: noise, too much to see anything", name);
    if (most > 0) {
        check_at_least(d.mean - 6 * estimate_error(d), least * mean, "%s: brighter by first.h",
                       name);
        check_at_most(d.mean + 6 * estimate_error(d), most * mean, "%s: by so much", name);
    } else check_at_least(t_test(d, 0, rounding), 1e-7, "%s (%d): first.h sees %g of %g more", name,
                          how, d.mean, mean);
    effects_ready_free(&q.full);
}

int main(void)
{
    first_scene f;
    check(!six_as_first(six_count - 1, &f), "first.h has no lens");
    /* Point lights: no chance but the coin of first.h in glass. */
    for (int k = 0; k < 3; k++) test_light(k, AS_IT_IS, 0, 0), test_light(k, NEAR, 0, 0);
    /* Lamp and walls: the same as long as nothing is behind them. */
    test_light(4, NEAR | BLACK, 0, 0), test_light(4, BLACK, 0, 0);
    /* What MEASURED.md says: a background lights nobody; first.h passes it on by mirrors and glass.
     * And first.h cannot leave out what the scene declines. */
    test_light(4, NEAR, 0, 0.1), test_light(3, NEAR, 0.03, 0.2);
    return check_report("27_beside");
}
