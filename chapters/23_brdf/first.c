/* 23 Eight balls before a window: Lambert, then Blinn-Phong with ever larger exponents.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 23_brdf_first chapters/23_brdf/first.c -lm
 */
#include "../../common/image.h"
#include "../02_camera/first.h"
#include "../03_sphere/first.h"
#include "first.h"

enum { width = 640, height = 300, balls = 8, N = 25, n = 2 };

/* The first ball is matte. */
static first_brdf coat(int i)
{
    const first_brdf matte = {{0.7, 0.3, 0.15}, {0, 0, 0}, 1};
    const first_brdf shiny = {{0.12, 0.04, 0.02}, {0.75, 0.6, 0.4}, i < 1 ? 1 : 1 << i};
    return i == 0 ? matte : shiny;
}

static vec3 colour(ray r, random_stream *random)
{
    hit h;
    for (int i = 0; i < balls; i++) {
        sphere s = {vec((i % 4 - 1.5) * 2.5, i < 4 ? 1.14 : -1.14, 0), 1};
        if (!first_sphere_hit(s, r, &h)) continue;
        vec3 normal = first_sphere_normal(s, ray_at(r, h.t));
        return first_reflection(coat(i), normal, vneg(vunit(r.d)), N, random);
    }
    return vscale(vec(0.17, 0.19, 0.22), 1 - 0.5 * hypot(r.d.x, r.d.y));
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "23_brdf_first");
    image im = image_new(width, height);
    first_camera c = first_camera_at(vec(0, 0, 14), vec(0, 0, 0), vec(0, 1, 0), 20,
                                     width, height);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            random_stream random = random_start(1, y * width + x, 0);
            vec3 sum = vec(0, 0, 0);
            for (int s = 0; s < n * n; s++)
                sum = vadd(sum, colour(first_pixel_ray(c, x, y, s, n), &random));
            image_set(&im, x, y, vscale(sum, 1.0 / (n * n)));
        }
    printf("of red light from all around leaves, seen head-on and at 60 degrees:\n");
    for (int i = 0; i < balls; i++) {
        random_stream random = random_start(2, i, 0);
        vec3 up = first_albedo(coat(i), vec(0, 0, 1), 20000, &random);
        vec3 slant = first_albedo(coat(i), vec(sqrt(0.75), 0, 0.5), 20000, &random);
        printf("    exponent %3.0f: %.2f %.2f\n", i == 0 ? 0.0 : coat(i).e, up.x, slant.x);
    }
    return picture_end(path, &im);
}
