/* 05 A tangle: all points where a polynomial of the fourth degree is 0, in the light of two lamps.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 05_implicit_first chapters/05_implicit/first.c -lm
 */
#include "../../common/image.h"
#include "../02_camera/first.h"
#include "../03_sphere/first.h"
#include "first.h"

enum { width = 640, height = 400, n = 2, steps = 48 };

/* x^4 - 5 x^2 and the same of y and z, and a number: the larger, the thinner the bridges. */
static real tangle(vec3 p)
{
    vec3 q = vmul(p, p);
    return vdot(q, q) - 5 * (q.x + q.y + q.z) + 11.4;
}

/* One lamp is above, on the left, and warm; the other is on the right, and blue. */
static vec3 colour(ray r)
{
    sphere all = {{0, 0, 0}, 3.6};  /* the surface is in there: a finite interval */
    hit h;
    vec3 wall = vscale(vec(0.8, 0.84, 0.88), 0.75 + vunit(r.d).y / 2);
    if (!first_sphere_roots(all, r, &r.tmin, &r.tmax)) return wall;
    if (!first_implicit_hit(tangle, r, steps, &h)) return wall;
    vec3 normal = first_implicit_normal(tangle, ray_at(r, h.t), 1e-3);
    real key = vdot(normal, vunit(vec(-2, 4, 3))), fill = vdot(normal, vunit(vec(5, -1, 2)));
    vec3 seen = vscale(vec(1, 0.3, 0.05), 0.06 + 0.9 * (key > 0 ? key : 0));
    seen = vadd(seen, vscale(vec(0.02, 0.12, 0.4), fill > 0 ? fill : 0));
    return vscale(seen, 0.3 + 0.7 * fabs(vdot(normal, vunit(r.d))));
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "05_implicit_first");
    image im = image_new(width, height);
    first_camera c = first_camera_at(vec(5, 4.4, 9.8), vec(0, -0.05, 0), vec(0, 1, 0), 33,
                                     width, height);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            vec3 sum = vec(0, 0, 0);
            for (int s = 0; s < n * n; s++)
                sum = vadd(sum, colour(first_pixel_ray(c, x, y, s, n)));
            image_set(&im, x, y, vscale(sum, 1.0 / (n * n)));
        }
    return picture_end(path, &im);
}
