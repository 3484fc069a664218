/* Tests of chapters/27_effects: a room drawn by 26's path tracer and by the general program has the
 * same light: the difference of two independent means, pixel by pixel, by a t-test. The room is
 * that of the last row of chance.h.
 *
 * The ceiling is the lamp, from wall to wall: its back, which shines here and not in 26, sees
 * nothing. In the room: a glass ball that absorbs, and a mirror: a white one, since brdf_mirror
 * follows Schlick's Fresnel, and 27's illum 3 reflects the same at every angle.
 */
#include "../chapters/27_effects/lab/chance.h"
#include "../chapters/20_monte_carlo/t_test.h"
#include "check.h"

int main(void)
{
    failure f;
    studio s;
    studio_view v;
    camera c;
    effects_stage e;
    lit_scene lit;
    path_tracer t;
    if (!studio_read_text(chance_row[chance_rows - 1].text, "room", NULL, &s, &f)) fail(f);
    plan p = plan_of(&s);
    if (!studio_camera(&s, 4 / (real)3, &v, &c, &f)) fail(f);
    if (!effects_stage_build(&s, &e, &f)) fail(f);
    effects_stage_view(&e, &v, c);
    effects_stage_effects(&e, p.effects);
    chance_lit(&s, &lit);
    path_tracer_of(&lit, NULL, path_defaults, &t);
    check(p.effects == (EFFECT_SOFT_SHADOWS | EFFECT_INDIRECT | EFFECTS_WHITTED),
          "the room calls for %x", p.effects);
    size_t n = check_count(12000);
    double worst = 1;
    for (int i = 0; i < 8 * 6; i++) {  /* a ray each, some through glass and mirror */
        ray r = camera_ray(c, (real)(i % 8) + (real)0.4, (real)(i / 8) + (real)0.3, 8, 6);
        estimate off[3] = {{0}, {0}, {0}};
        for (size_t k = 0; k < n; k++) {
            dice d = dice_start(3, (uint64_t)i * n + k, 0);
            effects_counts counts = {.now = 0};
            path_counts spent = {0};
            path_random own = path_start(&t.how, 4, (uint64_t)i * n + k, 0, 1);
            vec3 a = effects_general(&e, r, (media_set){0}, &d, &counts);
            vec3 b = path_radiance(&t, r, &own, &spent);
            for (int j = 0; j < 3; j++)
                off[j] = estimate_add(off[j], (double)(vaxis(a, j) - vaxis(b, j)));
        }
        for (int j = 0; j < 3; j++) {
            double likely = t_test(off[j], 0, 300 * (double)real_epsilon);
            worst = likely < worst ? likely : worst;
        }
    }
    /* false alarms: 144 tests, 1e-7 each */
    check_at_least(worst, 1e-7, "the room's light is not 26's: least p of 144 t-tests");
    path_tracer_free(&t), lit_free(&lit);
    effects_stage_free(&e), plan_free(&p), studio_free(&s);
    return check_report("27_paths");
}
