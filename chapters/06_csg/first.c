/* 06 Nine balls, each less another ball: what was cut away is seen by its own colour.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 06_csg_first chapters/06_csg/first.c -lm
 */
#include "../../common/image.h"
#include "../02_camera/first.h"
#include "first.h"

enum { width = 640, height = 280, n = 3, pairs = 9 };

static sphere pair[pairs][2];  /* A and B of each */
static vec3 paint[pairs];

/* Five and four, in a zigzag; B goes round A, and comes nearer to the eye from ball to ball. */
static void place(void)
{
    for (int i = 0; i < pairs; i++) {
        double turn = 2 * pi * i / pairs + 0.6, out = 0.85 - 0.055 * i;
        vec3 c = vec(1.2 * (i - 4), i % 2 ? -1.05 : 1.05, 0);
        vec3 b = vec(out * cos(turn), out * sin(turn), 0.62);
        pair[i][0] = (sphere){c, 1};
        pair[i][1] = (sphere){vadd(c, b), 0.72};
        for (int k = 0; k < 3; k++)
            paint[i] = vwith(paint[i], k, 0.36 + 0.3 * cos(2 * pi * (i / 9.0 + k / 3.0)));
    }
}

static vec3 colour(ray r)
{
    const vec3 cut = vec(0.98, 0.85, 0.6);
    vec3 seen = vec(0.86, 0.89, 0.93), lamp = vunit(vec(-0.5, 0.8, 1));
    hit h;
    for (int i = 0; i < pairs; i++)
        if (first_difference_hit(pair[i], r, &h)) {
            r.tmax = h.t;
            vec3 normal = first_difference_normal(pair[i], ray_at(r, h.t), h);
            real light = 0.25 + 0.75 * real_max(vdot(normal, lamp), 0);
            seen = vscale(h.shape == 0 ? paint[i] : cut, light);
        }
    return seen;
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "06_csg_first");
    image im = image_new(width, height);
    first_camera c = first_camera_at(vec(0, 0, 14), vec(0, 0, 0), vec(0, 1, 0), 21.5,
                                     width, height);
    place();
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            vec3 sum = vec(0, 0, 0);
            for (int s = 0; s < n * n; s++)
                sum = vadd(sum, colour(first_pixel_ray(c, x, y, s, n)));
            image_set(&im, x, y, vscale(sum, 1.0 / (n * n)));
        }
    return picture_end(path, &im);
}
