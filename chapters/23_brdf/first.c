/* 23 Eight balls before a window: Lambert, then Blinn-Phong with ever larger exponents.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 23_brdf_first chapters/23_brdf/first.c -lm
 */
#include "../../common/image.h"
#include "../02_camera/first.h"
#include "../03_sphere/first.h"
#include "first.h"

enum { width = 560, height = 290, balls = 8, N = 100 };

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "23_brdf_first");
    const real exponent[balls] = {0, 2, 4, 8, 16, 32, 64, 128};
    image im = image_new(width, height);
    first_camera c = first_camera_at(vec(0, 0, 14), vec(0, 0, 0), vec(0, 1, 0), 19.5,
                                     width, height);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            ray r = first_camera_ray(c, x + 0.5, y + 0.5);
            real edge = 1 - hypot(x - width / 2, y - height / 2) / width;
            vec3 seen = vscale(vec(0.2, 0.22, 0.25), edge);
            for (int i = 0; i < balls; i++) {
                sphere s = {vec((i % 4 - 1.5) * 2.25, i < 4 ? 1.14 : -1.14, 0), 1};
                hit h;
                if (!first_sphere_hit(s, r, &h)) continue;
                vec3 n = first_sphere_normal(s, ray_at(r, h.t)), wo = vneg(vunit(r.d));
                first_brdf matte = {vec(0.7, 0.3, 0.15), vec(0, 0, 0), 1};
                first_brdf shiny = {vec(0.12, 0.04, 0.02), vec(0.75, 0.6, 0.4), exponent[i]};
                random_stream random = random_start(1, y * width + x, 0);
                seen = first_reflection(i == 0 ? matte : shiny, n, wo, N, &random);
            }
            image_set(&im, x, y, seen);
        }
    return picture_end(path, &im);
}
