/* 13 A knot in a BSP tree: each leaf has its colour, cut out by planes of the triangles themselves.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 13_bsp_first chapters/13_bsp/first.c -lm
   A ray looks on its own side of each plane first, and beyond it if it has hit nothing so far. */
#include "../../common/image.h"
#include "../02_camera/first.h"
#include "first.h"

enum { width = 640, height = 360, n = 2 };

/* The leaf where p is: leaves take their turn in the rainbow. */
static vec3 tint(const first_bsp *b, vec3 p)
{
    const first_bsp_node *node = &b->root;
    while (node->child) node = &node->child[first_bsp_side(node, p) > 0];
    return vscale(first_tint(1.0 * node->number / b->leaves), node->number % 2 ? 0.55 : 1);
}

static vec3 colour(const first_bsp *b, ray r)
{
    hit h;
    if (!first_bsp_hit(b, r, &h)) return vec(0.9, 0.92, 0.95);
    real facing = -vdot(first_mesh_normal(b->m, h.shape, r.d), vunit(r.d));
    vec3 below = ray_at(r, h.t + 0.001);  /* a hit lies in a plane: look a little behind it */
    return vscale(tint(b, below), 0.15 + 0.85 * facing);
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "13_bsp_first");
    first_mesh m = first_knot(50, 6);
    first_bsp b;
    first_bsp_build(&m, &b);
    first_camera c = first_camera_at(vec(1, -6.4, 8.6), vec(0.15, -0.33, 0), vec(0, 1, 0), 31.5,
                                     width, height);
    image im = image_new(width, height);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            vec3 sum = vec(0, 0, 0);
            for (int s = 0; s < n * n; s++)
                sum = vadd(sum, colour(&b, first_pixel_ray(c, x, y, s, n)));
            image_set(&im, x, y, vscale(sum, 1.0 / (n * n)));
        }
    printf("%d triangles, %d leaves, %.1f tests a ray\n", m.n, b.leaves,
           (double)first_tests / (width * height * n * n));
    first_bsp_free(&b);
    first_mesh_free(&m);
    return picture_end(path, &im);
}
