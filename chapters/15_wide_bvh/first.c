/* 15 A knot in a tree four wide: the leaves of a node share a colour.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 15_wide_bvh_first chapters/15_wide_bvh/first.c -lm
   14 asks one box at a time; here a loop of four asks the boxes of all children. */
#include "../../common/image.h"
#include "../02_camera/first.h"
#include "first.h"

enum { side = 640, n = 2 };

/* Each node of the wide tree takes its turn in the rainbow; its leaves differ in brightness. */
static void paint(const first_wide *w, vec3 *tint)
{
    for (int i = 0; i < w->nodes; i++)
        for (int c = 0; c < first_width; c++) {
            int child = w->node[i].child[c];
            if (child >= 0) continue;
            const first_bvh_node *leaf = &w->binary.node[~child];
            for (int k = leaf->first; k < leaf->first + leaf->n; k++)
                tint[w->binary.order[k]] = vscale(first_tint(0.381966 * i - floor(0.381966 * i)),
                                                  1 - 0.15 * c);
        }
}

static vec3 colour(const first_wide *w, const vec3 *tint, ray r)
{
    hit h;
    if (!first_wide_hit(w, r, &h)) return vec(0.9, 0.92, 0.95);
    real facing = -vdot(first_mesh_normal(w->binary.m, h.shape, r.d), vunit(r.d));
    return vscale(tint[h.shape], 0.15 + 0.85 * facing);
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "15_wide_bvh_first");
    first_mesh m = first_knot(120, 12);
    first_wide w = first_wide_build(&m);
    vec3 *tint = allocate((size_t)m.n, sizeof *tint);
    paint(&w, tint);
    first_camera c = first_camera_at(vec(1, -3, 9), vec(0.2, -0.12, 0), vec(0, 1, 0), 42,
                                     side, side);
    image im = image_new(side, side);
    first_tests = 0;
    for (int y = 0; y < side; y++)
        for (int x = 0; x < side; x++) {
            vec3 sum = vec(0, 0, 0);
            for (int s = 0; s < n * n; s++)
                sum = vadd(sum, colour(&w, tint, first_pixel_ray(c, x, y, s, n)));
            image_set(&im, x, y, vscale(sum, 1.0 / (n * n)));
        }
    int inner = (w.binary.nodes - 1) / 2;  /* the others are leaves */
    printf("%d triangles, %d nodes of 2, %d nodes of %d, %.1f tests a ray\n", m.n, inner, w.nodes,
           first_width, (double)first_tests / (side * side * n * n));
    first_wide_free(&w);
    first_mesh_free(&m);
    free(tint);
    return picture_end(path, &im);
}
