/* 16 A crowd of knots: 800 triangles in memory, 57,600 in the scene.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 16_instances_first chapters/16_instances/first.c -lm
 */
#include "../../common/image.h"
#include "../../common/random.h"
#include "../02_camera/first.h"
#include "first.h"

enum { width = 640, height = 270, rows = 9, columns = 8, n = 2 };
static first_instance one[rows * columns];

/* Each is turned about two axes, and stretched. */
static void place(void)
{
    for (int i = 0; i < rows * columns; i++) {
        real u[5];
        for (int k = 0; k < 5; k++) u[k] = random_real(7, i, 0, k);
        real a = 2 * pi * u[0], b = 0.6 * (u[1] - 0.5), wide = 0.2 + 0.12 * u[2];
        real high = 0.2 + 0.12 * u[3], deep = 0.2 + 0.12 * u[4];
        vec3 x = vec(cos(a), 0, -sin(a)), z = vec(sin(a) * cos(b), sin(b), cos(a) * cos(b));
        int row = i / columns;
        vec3 m = vec((i % columns - columns / 2 + (row % 2 ? 0.75 : 0.25)) * 2, 1, row * -1.8);
        one[i] = first_instance_at(vscale(x, wide), vscale(vcross(z, x), high), vscale(z, deep), m);
    }
}

static vec3 colour(const first_crowd *x, ray r)
{
    hit h;
    int i;
    real haze = 0.5 + 0.5 * vunit(r.d).y;
    if (!first_crowd_hit(x, r, &h, &i)) return vec(0.75 + 0.2 * haze, 0.8 + 0.15 * haze, 0.95);
    vec3 normal = first_triangle_normal(x->mesh->m->tri[h.shape]);
    normal = first_instance_normal(&x->one[i], normal);
    real facing = fabs(vdot(normal, vunit(r.d)));
    return vscale(first_tint(i * 0.618 - floor(i * 0.618)), 0.1 + 0.9 * facing * facing);
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "16_instances_first");
    first_mesh m = first_knot(50, 8);
    first_bvh b = first_bvh_build(&m, true);
    first_crowd crowd = {&b, one, rows * columns};
    first_camera c = first_camera_at(vec(0, 7.5, 7), vec(0, 0.6, -4.6), vec(0, 1, 0), 35,
                                     width, height);
    image im = image_new(width, height);
    place();
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            vec3 sum = vec(0, 0, 0);
            for (int s = 0; s < n * n; s++)
                sum = vadd(sum, colour(&crowd, first_pixel_ray(c, x, y, s, n)));
            image_set(&im, x, y, vscale(sum, 1.0 / (n * n)));
        }
    printf("%d instances of %d triangles, %.1f tests a ray\n", crowd.n, m.n,
           (double)first_tests / (width * height * n * n));
    first_bvh_free(&b);
    first_mesh_free(&m);
    return picture_end(path, &im);
}
