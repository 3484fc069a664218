/* 03 Balls, each point in the colour of its normal n: red is n.x, green n.y, blue n.z.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 03_sphere_first chapters/03_sphere/first.c -lm
 */
#include "../../common/image.h"
#include "../02_camera/first.h"
#include "first.h"

enum { width = 640, height = 360, balls = 90, n = 2 };

/* Balls on a spiral whose turns are the golden angle apart, as seeds stand in a sunflower. */
static sphere ball[balls];

static void sow(void)
{
    for (int i = 0; i < balls; i++) {
        double angle = i * pi * (3 - sqrt(5.0)), far = 0.42 * sqrt(i + 0.5);
        vec3 c = vec(far * cos(angle), far * sin(angle), 1.4 - 0.14 * far * far);
        ball[i] = (sphere){c, 0.31 + 0.02 * far};
    }
}

static vec3 colour(ray r)
{
    vec3 seen = vec(0.82, 0.86, 0.92);
    hit h;
    for (int i = 0; i < balls; i++)
        if (first_sphere_hit(ball[i], r, &h)) {
            r.tmax = h.t;  /* whatever lies beyond this hit is hidden by it */
            vec3 normal = first_sphere_normal(ball[i], ray_at(r, h.t));
            seen = vscale(vadd(normal, vec(1, 1, 1)), 0.5);
        }
    return vmul(seen, seen);  /* about what a screen makes of it: so the colours stay even */
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "03_sphere_first");
    image im = image_new(width, height);
    first_camera c = first_camera_at(vec(0, -7, 10.5), vec(0, -0.75, 0), vec(0, 1, 0), 33,
                                     width, height);
    sow();
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            vec3 sum = vec(0, 0, 0);
            for (int s = 0; s < n * n; s++)
                sum = vadd(sum, colour(first_pixel_ray(c, x, y, s, n)));
            image_set(&im, x, y, vscale(sum, 1.0 / (n * n)));
        }
    return picture_end(path, &im);
}
