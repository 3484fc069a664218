/* 18 Five balls in the light of two lamps, and their shadows.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 18_shade_first chapters/18_shade/first.c -lm
   In the lower left corner eps is 0: there points shade themselves (acne). */
#include "../../common/image.h"
#include "../02_camera/first.h"
#include "first.h"

enum { width = 640, height = 360, n = 3 };

static first_scene build(void)
{
    first_scene s = {.ambient = vec(0.06, 0.07, 0.09), .above = vec(0.25, 0.4, 0.7),
                     .below = vec(0.85, 0.85, 0.8), .eps = 1e-4};
    first_material tiles = {.kd = vec(0.75, 0.7, 0.62), .checks = 24};
    first_add_flat(&s, vec(-12, -0.1, 12), vec(24, 0, 0), vec(0, 0, -24), tiles);
    const vec3 kd[5] = {{0.8, 0.13, 0.06}, {0.85, 0.5, 0.04}, {0.1, 0.5, 0.2}, {0.05, 0.25, 0.65},
                        {0.4, 0.1, 0.45}};
    for (int i = 0; i < 5; i++) {
        real a = 2 * pi * i / 5 + 0.3;
        first_material m = {.kd = kd[i], .ks = vec(0.5, 0.5, 0.5), .shine = 10 << i};
        first_add_ball(&s, vec(2.1 * cos(a), 0.65 + 0.12 * i, 2.1 * sin(a)), 0.75 + 0.12 * i, m);
    }
    s.light[s.lights++] = (first_light){vec(-5, 9, 6), vec(260, 240, 200)};
    s.light[s.lights++] = (first_light){vec(8, 5, 4), vec(30, 50, 90)};
    return s;
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "18_shade_first");
    image im = image_new(width, height);
    first_scene s = build(), without = s;
    first_camera c = first_camera_at(vec(1.5, 4.2, 9), vec(0, 0.55, 0), vec(0, 1, 0), 31,
                                     width, height);
    without.eps = 0;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            bool corner = x < width * 2 / 5 && y > height / 2;
            vec3 sum = vec(0, 0, 0);
            for (int k = 0; k < n * n; k++) {
                ray r = first_pixel_ray(c, x, y, k, n);
                sum = vadd(sum, first_trace(corner ? &without : &s, r));
            }
            image_set(&im, x, y, vscale(sum, 1.0 / (n * n)));
        }
    return picture_end(path, &im);
}
