/* 02 Two cameras in a checkered room. Left the rays are parallel, right they come from an eye.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 02_camera_first chapters/02_camera/first.c -lm
   Above one ray a pixel, below the mean of sixteen. */
#include "../../common/image.h"
#include "first.h"

enum { width = 360, height = 300 };

/* The room: [-2,2] x [0,3] x [-2,2]. Only walls where a ray goes out are painted, so that from
 * outside one looks into it. A ray goes out through the first of three walls that it reaches. */
static vec3 room(ray r)
{
    const vec3 lo = vec(-2, 0, -2), hi = vec(2, 3, 2);
    const vec3 paint[3] = {vec(0.85, 0.45, 0.2), vec(0.75, 0.75, 0.7), vec(0.25, 0.5, 0.75)};
    real t = real_infinity;
    int wall = 0;
    for (int k = 0; k < 3; k++) {
        real d = vaxis(r.d, k), far = ((d < 0 ? vaxis(lo, k) : vaxis(hi, k)) - vaxis(r.o, k)) / d;
        if (d != 0 && far < t) t = far, wall = k;
    }
    vec3 p = ray_at(r, t);
    for (int k = 0; k < 3; k++)
        if (k != wall && (vaxis(p, k) < vaxis(lo, k) || vaxis(p, k) > vaxis(hi, k)))
            return vec(1, 1, 1);
    int a = (int)floor(6 * vaxis(p, (wall + 1) % 3)), b = (int)floor(6 * vaxis(p, (wall + 2) % 3));
    return vscale(paint[wall], (a + b) % 2 == 0 ? 1 : 0.15);
}

/* The colour of a pixel is the mean of n x n rays through it, evenly spread.             (2.10) */
static image look(first_camera c, bool parallel, int n)
{
    image im = image_new(c.nx, c.ny);
    for (int y = 0; y < c.ny; y++)
        for (int x = 0; x < c.nx; x++) {
            vec3 sum = vec(0, 0, 0);
            for (int s = 0; s < n * n; s++) {
                real px = x + (s % n + 0.5) / n, py = y + (s / n + 0.5) / n;
                sum = vadd(sum, room(parallel ? first_orthographic_ray(c, px, py)
                                              : first_camera_ray(c, px, py)));
            }
            image_set(&im, x, y, vscale(sum, 1.0 / (n * n)));
        }
    return im;
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "02_camera_first");
    image im = image_new(2 * width, 2 * height);
    first_camera eye = first_camera_at(vec(1.8, 2.2, 1.9), vec(-0.6, 0.9, -0.9), vec(0, 1, 0), 62,
                                       width, height);
    first_camera far = first_camera_at(vec(6, 6, 7), vec(0, 1.1, 0), vec(0, 1, 0), 90,
                                       width, height);
    far.top = 3, far.bottom = -3;
    far.right = 3.6, far.left = -3.6;  /* a window as large as the room */
    for (int row = 0; row < 2; row++) {
        image left = look(far, true, row ? 4 : 1), right = look(eye, false, row ? 4 : 1);
        image_place(&im, 0, row * height, &left);
        image_place(&im, width, row * height, &right);
        image_free(&left), image_free(&right);
    }
    return picture_end(path, &im);
}
