/* 11 A knot in an octree: each leaf has its colour, small leaves where there are many triangles.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 11_octree_first chapters/11_octree/first.c -lm
   Nodes that a ray misses cost one test of a box, whatever is in them. */
#include "../../common/image.h"
#include "../02_camera/first.h"
#include "first.h"

enum { width = 640, height = 360, n = 2 };

/* The leaf where p is: leaves take their turn in the rainbow. */
static vec3 tint(const first_octree *t, vec3 p)
{
    const first_octree_node *node = &t->root;
    while (node->child) {
        vec3 middle = vscale(vadd(node->box.lo, node->box.hi), 0.5);
        int c = (p.x > middle.x ? 1 : 0) + (p.y > middle.y ? 2 : 0) + (p.z > middle.z ? 4 : 0);
        node = &node->child[c];
    }
    return vscale(first_tint(1.0 * node->number / t->leaves), node->number % 2 ? 0.55 : 1);
}

static vec3 colour(const first_octree *t, ray r)
{
    hit h;
    if (!first_octree_hit(t, r, &h)) return vec(0.9, 0.92, 0.95);
    real facing = -vdot(first_mesh_normal(t->m, h.shape, r.d), vunit(r.d));
    return vscale(tint(t, ray_at(r, h.t)), 0.15 + 0.85 * facing);
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "11_octree_first");
    first_mesh m = first_knot(120, 12);
    first_octree t;
    first_octree_build(&m, &t);
    first_camera c = first_camera_at(vec(1, -6.4, 8.6), vec(0.15, -0.33, 0), vec(0, 1, 0), 31.5,
                                     width, height);
    image im = image_new(width, height);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            vec3 sum = vec(0, 0, 0);
            for (int s = 0; s < n * n; s++)
                sum = vadd(sum, colour(&t, first_pixel_ray(c, x, y, s, n)));
            image_set(&im, x, y, vscale(sum, 1.0 / (n * n)));
        }
    printf("%d triangles, %d leaves, %.1f tests a ray\n", m.n, t.leaves,
           (double)first_tests / (width * height * n * n));
    first_octree_free(&t);
    first_mesh_free(&m);
    return picture_end(path, &im);
}
