/* 21 The scene of 19, and the same under a lamp of four by four, its chrome brushed.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 21_distributed_first chapters/21_distributed/first.c -lm
   Left Whitted's way, right by chance: soft shadows, a dull mirror. */
#include "../../common/image.h"
#include "first.h"

enum { width = 320, height = 250, n = 7, depth = 6 };

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "21_distributed_first");
    image im = image_new(2 * width, height);
    first_scene sharp = first_two_balls(), s = sharp;
    first_camera c = first_two_balls_camera(width, height);
    first_lamp lamp = first_two_balls_lamp(&s);
    first_add_flat(&s, lamp.corner, lamp.a, lamp.b, (first_material){.ke = lamp.L});
    s.thing[2].m.shine = 90;

    for (int y = 0; y < height; y++)
        for (int x = 0; x < 2 * width; x++) {
            vec3 sum = vec(0, 0, 0);
            int m = x < width ? 3 : n;
            for (int k = 0; k < m * m; k++) {
                random_stream random = random_start(1, y * 2 * width + x, k);
                ray r = first_ray_unit(first_pixel_ray(c, x % width, y, k, m));
                sum = vadd(sum, x < width ? first_whitted(&sharp, r, depth)
                                          : first_distributed(&s, &lamp, r, depth, &random));
            }
            image_set(&im, x, y, vscale(sum, 1.0 / (m * m)));
        }
    return picture_end(path, &im);
}
