/* 21 The scene of 19 under a lamp of four by four, its chrome brushed: soft shadows, a dull mirror.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 21_distributed_first chapters/21_distributed/first.c -lm
 */
#include "../../common/image.h"
#include "first.h"

enum { width = 400, height = 250, n = 6, depth = 6 };

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "21_distributed_first");
    image im = image_new(width, height);
    first_scene s = first_two_balls();
    first_camera c = first_two_balls_camera(width, height);
    first_lamp lamp = first_two_balls_lamp(&s);
    first_add_flat(&s, lamp.corner, lamp.a, lamp.b, (first_material){.ke = lamp.L});
    s.thing[2].m.shine = 90;

    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            vec3 sum = vec(0, 0, 0);
            for (int k = 0; k < n * n; k++) {
                random_stream random = random_start(1, y * width + x, k);
                ray r = first_ray_unit(first_pixel_ray(c, x, y, k, n));
                sum = vadd(sum, first_distributed(&s, &lamp, r, depth, &random));
            }
            image_set(&im, x, y, vscale(sum, 1.0 / (n * n)));
        }
    return picture_end(path, &im);
}
