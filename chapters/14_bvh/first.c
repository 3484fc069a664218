/* 14 A knot, its triangles coloured in the order of the tree: what is near in it has a like colour.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 14_bvh_first chapters/14_bvh/first.c -lm
   Left it is cut at the middle triangle, right by the surface area heuristic. */
#include "../../common/image.h"
#include "../02_camera/first.h"
#include "first.h"

enum { side = 360, n = 2 };

/* tint[i] is the colour of triangle i: leaves take their turn in the rainbow. */
static void paint(const first_bvh *b, vec3 *tint)
{
    for (int i = 0, leaf = 0; i < b->nodes; i++) {
        first_bvh_node node = b->node[i];
        if (node.left != 0) continue;
        vec3 c = vscale(first_tint(1.0 * node.first / b->m->n), leaf++ % 2 ? 0.55 : 1);
        for (int k = node.first; k < node.first + node.n; k++) tint[b->order[k]] = c;
    }
}

static vec3 colour(const first_bvh *b, const vec3 *tint, ray r)
{
    hit h;
    if (!first_bvh_hit(b, r, &h)) return vec(0.9, 0.92, 0.95);
    real facing = -vdot(first_mesh_normal(b->m, h.shape, r.d), vunit(r.d));
    return vscale(tint[h.shape], 0.15 + 0.85 * facing);
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "14_bvh_first");
    first_mesh m = first_knot(120, 12);
    first_camera c = first_camera_at(vec(1, -3, 9), vec(0.2, -0.12, 0), vec(0, 1, 0), 42,
                                     side, side);
    image im = image_new(2 * side, side);
    vec3 *tint = allocate((size_t)m.n, sizeof *tint);
    for (int sah = 0; sah < 2; sah++) {
        first_bvh b = first_bvh_build(&m, sah);
        paint(&b, tint);
        first_tests = 0;
        for (int y = 0; y < side; y++)
            for (int x = 0; x < side; x++) {
                vec3 sum = vec(0, 0, 0);
                for (int s = 0; s < n * n; s++)
                    sum = vadd(sum, colour(&b, tint, first_pixel_ray(c, x, y, s, n)));
                image_set(&im, x + sah * side, y, vscale(sum, 1.0 / (n * n)));
            }
        printf("%s: %d triangles, %d nodes, %.1f tests a ray\n", sah ? "area" : "middle", m.n,
               b.nodes, (double)first_tests / (side * side * n * n));
        first_bvh_free(&b);
    }
    free(tint);
    first_mesh_free(&m);
    return picture_end(path, &im);
}
