/* 09 A city of boxes, coloured by t_enter, the way a ray goes before it enters one.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 09_aabb_first chapters/09_aabb/first.c -lm
 */
#include "../../common/image.h"
#include "../../common/random.h"
#include "../02_camera/first.h"
#include "first.h"

enum { width = 640, height = 320, blocks = 11, n = 2 };
static aabb house[blocks * blocks];

/* The nearer the middle of the town, the higher the houses. */
static void build(void)
{
    for (int i = 0; i < blocks * blocks; i++) {
        real x = i % blocks - blocks / 2, z = i / blocks - blocks / 2;
        real high = 0.3 + 5 * random_real(1, i, 0, 0) * exp(-(x * x + z * z) / 20);
        real wide = 0.25 + 0.17 * random_real(1, i, 0, 1);
        real deep = 0.25 + 0.17 * random_real(1, i, 0, 2);
        house[i] = (aabb){vec(x - wide, 0, z - deep), vec(x + wide, high, z + deep)};
    }
}

/* Near is light yellow, then orange, violet, and far is dark blue. */
static vec3 ramp(real t)
{
    const vec3 stop[5] = {{1, 0.95, 0.6}, {0.95, 0.45, 0.1}, {0.6, 0.08, 0.2}, {0.2, 0.03, 0.28},
                          {0.02, 0.02, 0.1}};
    real s = real_clamp(t, 0, 0.999) * 4;
    int i = (int)s;
    return vadd(vscale(stop[i], 1 - (s - i)), vscale(stop[i + 1], s - i));
}

static vec3 colour(ray r)
{
    vec3 seen = vec(0.9, 0.92, 0.95);
    real t, closest = real_infinity;
    for (int i = 0; i < blocks * blocks; i++)
        if (first_aabb_hit(house[i], r, &t) && t < closest) {
            closest = t;
            vec3 p = ray_at(r, t), top = house[i].hi;
            bool roof = fabs(p.y - top.y) < 0.001, side = fabs(p.x - top.x) < 0.001;
            bool window = !roof && fmod(p.y + 9, 0.24) > 0.12 && fmod(p.x + p.z + 9, 0.16) > 0.07;
            real near = t * vlength(r.d) - 7.5;  /* the town is some 14 deep */
            seen = vscale(ramp(near / 14), (roof ? 1 : side ? 0.55 : 0.8) * (window ? 0.55 : 1));
        }
    return seen;
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "09_aabb_first");
    image im = image_new(width, height);
    first_camera c = first_camera_at(vec(7.5, 7, 9.5), vec(0, -0.75, 0), vec(0, 1, 0), 44,
                                     width, height);
    build();
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            vec3 sum = vec(0, 0, 0);
            for (int s = 0; s < n * n; s++)
                sum = vadd(sum, colour(first_pixel_ray(c, x, y, s, n)));
            image_set(&im, x, y, vscale(sum, 1.0 / (n * n)));
        }
    return picture_end(path, &im);
}
