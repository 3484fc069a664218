/* 24 The Cornell box in direct light, with 4 eye rays a pixel and 6 rays more for each.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 24_direct_light_first chapters/24_direct_light/first.c -lm
   Left these have random directions, right they go to points of the lamp. Twice as bright. */
#include "../../common/image.h"
#include "first.h"

enum { side = 320, n = 2, rays = 6 };

static vec3 colour(const first_scene *s, bool by_lamp, ray r, random_stream *random)
{
    hit h;
    if (!first_scene_hit(s, r, &h)) return vec(0, 0, 0);
    first_point x = first_point_at(s, r, h);
    vec3 sum = vec(0, 0, 0);
    for (int i = 0; i < rays; i++)
        sum = vadd(sum, by_lamp ? first_direct_by_lamp(s, 0, x, random)
                                : first_direct_by_direction(s, x, random));
    return vadd(first_emitted(x), vscale(sum, 1.0 / rays));
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "24_direct_light_first");
    image im = image_new(2 * side, side);
    first_scene s = first_cornell();
    first_camera c = first_cornell_inside(side, side);
    for (int y = 0; y < side; y++)
        for (int x = 0; x < 2 * side; x++) {
            vec3 sum = vec(0, 0, 0);
            for (int k = 0; k < n * n; k++) {
                random_stream random = random_start(1, y * 2 * side + x, k);
                ray r = first_pixel_ray(c, x % side, y, k, n);
                sum = vadd(sum, colour(&s, x >= side, r, &random));
            }
            image_set(&im, x, y, vscale(sum, 2.0 / (n * n)));
        }
    return picture_end(path, &im);
}
