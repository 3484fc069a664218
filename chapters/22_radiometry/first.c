/* 22 The floor under a lamp. Left by 150 directions a point, right by the formula.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 22_radiometry_first chapters/22_radiometry/first.c -lm
   Dark rings: there the irradiance E is a multiple of 0.2 W/m^2. */
#include "../../common/image.h"
#include "../02_camera/first.h"
#include "first.h"

enum { width = 640, height = 320, N = 150 };

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "22_radiometry_first");
    const sphere lamp = {vec(0, 2, 0), 0.6};
    const real L = 4;
    const vec3 up = vec(0, 1, 0);
    image im = image_new(width, height);
    first_camera c = first_camera_at(vec(0, 5, 7), vec(0, 0.6, 0), up, 34, width, height);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            ray r = first_camera_ray(c, x + 0.5, y + 0.5);
            vec3 seen = vec(0.02, 0.02, 0.03);
            hit h;
            if (first_sphere_hit(lamp, r, &h)) seen = vec(1, 0.95, 0.8);
            else if (r.d.y < 0) {
                vec3 p = ray_at(r, -r.o.y / r.d.y);
                real E = first_sphere_irradiance(lamp, L, p, up);
                real ring = fabs(E / 0.2 - floor(E / 0.2 + 0.5)) / (0.2 + E);
                bool left = x < width / 2;
                if (left) {
                    random_stream random = random_start(1, y * width + x, 0);
                    E = first_mean(first_irradiance_by_directions(lamp, L, p, up, N, &random));
                }
                seen = vscale(vec(1, 0.85, 0.6), 0.9 * E * (!left && ring < 0.03 ? 0.6 : 1));
            }
            if (x == width / 2) seen = vec(0.1, 0.1, 0.1);
            image_set(&im, x, y, seen);
        }
    random_stream random = random_start(2, 0, 0);
    first_samples E = first_irradiance_by_directions(lamp, L, vec(0, 0, 0), up, 100000, &random);
    printf("right below: %.4f sr, E = %.4f; by 100000 directions %.4f +- %.4f W/m^2\n",
           first_sphere_solid_angle(lamp, vec(0, 0, 0)),
           first_sphere_irradiance(lamp, L, vec(0, 0, 0), up), first_mean(E), first_error(E));
    return picture_end(path, &im);
}
