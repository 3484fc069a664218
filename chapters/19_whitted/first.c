/* 19 A ball of glass and one of chrome over a checkerboard: up to eight levels of rays.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 19_whitted_first chapters/19_whitted/first.c -lm
 */
#include "../../common/image.h"
#include "first.h"

enum { width = 640, height = 320, n = 3, depth = 8 };

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "19_whitted_first");
    image im = image_new(width, height);
    first_scene s = first_two_balls();
    first_camera c = first_two_balls_camera(width, height);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            vec3 sum = vec(0, 0, 0);
            for (int k = 0; k < n * n; k++) {
                ray r = first_pixel_ray(c, x, y, k, n);
                sum = vadd(sum, first_whitted(&s, first_ray_unit(r), depth));
            }
            image_set(&im, x, y, vscale(sum, 1.0 / (n * n)));
        }
    return picture_end(path, &im);
}
