/* 27 Three scenes, and what each calls for: a ball in the sun, glass and chrome, a room and a lamp.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 27_effects_first chapters/27_effects/first.c -lm
   Prints the plans, and the rays that each effect took. */
#include "../../common/image.h"
#include "first.h"

enum { width = 214, height = 214, scenes = 3 };

static first_scene one_ball(void)
{
    first_scene s = {.ambient = vec(0.15, 0.17, 0.2), .above = vec(0.12, 0.28, 0.6),
                     .below = vec(0.95, 0.85, 0.7), .eps = 1e-4};
    first_material clay = {.kd = vec(0.75, 0.25, 0.1), .ks = vec(0.5, 0.5, 0.5), .shine = 60};
    first_add_ball(&s, vec(0, 1, 0), 1.7, clay);
    s.light[s.lights++] = (first_light){vec(-4, 7, 5), vec(260, 250, 230)};
    return s;
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "27_effects_first");
    const char *title[scenes] = {"one ball", "glass and chrome", "the Cornell box"};
    const first_scene scene[scenes] = {one_ball(), first_two_balls(), first_cornell()};
    const first_camera camera[scenes] = {
        first_camera_at(vec(0, 2, 8), vec(0, 1, 0), vec(0, 1, 0), 36, width, height),
        first_camera_at(vec(0.6, 2.1, 7.2), vec(0.1, 0.85, 0), vec(0, 1, 0), 43, width, height),
        first_cornell_inside(width, height)};
    image im = image_new(scenes * width, height);
    for (int i = 0; i < scenes; i++) {
        first_plan p = first_plan_of(&scene[i]);
        int n = p.on[first_bounces] ? 5 : p.on[first_glass] ? 4 : 3;
        memset(first_rays, 0, sizeof first_rays);
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++) {
                vec3 sum = vec(0, 0, 0);
                for (int k = 0; k < n * n; k++) {
                    random_stream random = random_start(1, y * width + x, k);
                    ray r = first_ray_unit(first_pixel_ray(camera[i], x, y, k, n));
                    sum = vadd(sum, first_planned(&scene[i], &p, r, true, 40, &random));
                }
                image_set(&im, i * width + x, y, vscale(sum, (i == 2 ? 2.0 : 1.0) / (n * n)));
            }
        printf("%s: %d eye rays a pixel\n", title[i], n * n);
        for (int e = 0; e < first_effects; e++)
            printf("    %-17s %-4s %s; %.2f an eye ray\n", first_effect_name[e],
                   p.on[e] ? "yes:" : "no:", p.because[e],
                   (double)first_rays[e] / (width * height * n * n));
    }
    return picture_end(path, &im);
}
