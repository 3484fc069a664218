/* 04 A star of sixty triangles over a plane; every point mixes the colours of its three corners.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 04_triangle_first chapters/04_triangle/first.c -lm
 */
#include "../../common/image.h"
#include "../02_camera/first.h"
#include "first.h"

enum { width = 640, height = 360, n = 2, most = 60 };
static triangle star[most];
static int triangles;

/* An icosahedron has its corners at (0, +-1, +-g) and their turns, g the golden ratio; three that
 * are 2 apart make a face. On each face stands a spike of three triangles, some of them the other
 * way round: colour() asks only how much they face the ray. */
static void build(void)
{
    const double g = (1 + sqrt(5.0)) / 2;
    vec3 p[12];
    for (int i = 0; i < 12; i++) {
        double a = i & 1 ? 1 : -1, b = i & 2 ? g : -g;
        p[i] = i < 4 ? vec(0, a, b) : i < 8 ? vec(a, b, 0) : vec(b, 0, a);
    }
    for (int i = 0; i < 12; i++)
        for (int j = i + 1; j < 12; j++)
            for (int k = j + 1; k < 12; k++) {
                vec3 a = vsub(p[i], p[j]), b = vsub(p[j], p[k]), c = vsub(p[k], p[i]);
                if (vlength(a) + vlength(b) + vlength(c) > 6.01) continue;
                vec3 tip = vscale(vadd(vadd(p[i], p[j]), p[k]), 0.58);
                star[triangles++] = (triangle){p[i], p[j], tip};
                star[triangles++] = (triangle){p[j], p[k], tip};
                star[triangles++] = (triangle){p[k], p[i], tip};
            }
}

static vec3 colour(ray r)
{
    const vec3 red = vec(0.75, 0.12, 0.03), gold = vec(0.95, 0.6, 0.05), tip = vec(1, 0.97, 0.85);
    vec3 seen = vec(0.75, 0.82, 0.9);
    plane floor_below = {vec(0, -2.6, 0), vec(0, 1, 0)};
    hit h;
    if (first_plane_hit(floor_below, r, &h)) {
        vec3 p = ray_at(r, h.t);
        /* No shadow is cast yet: this one is painted. */
        real shadow = 0.35 + 0.65 * real_clamp(hypot(p.x, p.z) / 3.4, 0, 1), haze = exp(-h.t / 40);
        bool white = ((int)floor(p.x) + (int)floor(p.z)) % 2 == 0;
        seen = vadd(vscale(white ? vec(0.6, 0.62, 0.65) : vec(0.1, 0.2, 0.3), shadow * haze),
                    vscale(seen, 1 - haze));
        r.tmax = h.t;
    }
    for (int i = 0; i < triangles; i++)
        if (first_triangle_hit(star[i], r, &h)) {
            r.tmax = h.t;
            real facing = fabs(vdot(first_triangle_normal(star[i]), vunit(r.d)));
            seen = vscale(barycentric_mix(red, gold, tip, h.u, h.v), 0.25 + 0.75 * facing);
        }
    return seen;
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "04_triangle_first");
    image im = image_new(width, height);
    first_camera c = first_camera_at(vec(4, 3.2, 9), vec(0, -0.1, 0), vec(0, 1, 0), 36,
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
