/* 10 A knot in a uniform grid of 27 cells a triangle: neighbouring cells have different colours.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 10_grid_first chapters/10_grid/first.c -lm
   Each ray asks only the triangles of the cells that it passes. */
#include "../../common/image.h"
#include "../02_camera/first.h"
#include "first.h"

enum { width = 640, height = 360, n = 2 };

/* The cell where p is: red along x, green along y, blue along z, and every other cell darker. */
static vec3 tint(const first_grid *g, vec3 p)
{
    int i = first_grid_cell(g, p, 0), j = first_grid_cell(g, p, 1), k = first_grid_cell(g, p, 2);
    vec3 c = vec(0.15 + 0.8 * i / g->n[0], 0.2 + 0.7 * j / g->n[1], 0.25 + 0.7 * k / g->n[2]);
    return vscale(c, (i + j + k) % 2 ? 0.4 : 1);
}

static vec3 colour(const first_grid *g, ray r)
{
    hit h;
    if (!first_grid_hit(g, r, &h)) return vec(0.9, 0.92, 0.95);
    real facing = -vdot(first_mesh_normal(g->m, h.shape, r.d), vunit(r.d));
    return vscale(tint(g, ray_at(r, h.t)), 0.15 + 0.85 * facing);
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "10_grid_first");
    first_mesh m = first_knot(120, 12);
    first_grid g = first_grid_build(&m);
    first_camera c = first_camera_at(vec(1, -6.4, 8.6), vec(0.15, -0.33, 0), vec(0, 1, 0), 31.5,
                                     width, height);
    image im = image_new(width, height);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            vec3 sum = vec(0, 0, 0);
            for (int s = 0; s < n * n; s++)
                sum = vadd(sum, colour(&g, first_pixel_ray(c, x, y, s, n)));
            image_set(&im, x, y, vscale(sum, 1.0 / (n * n)));
        }
    printf("%d triangles, %d x %d x %d cells, %zu items, %.1f tests a ray\n", m.n, g.n[0], g.n[1],
           g.n[2], g.items, (double)first_tests / (width * height * n * n));
    first_grid_free(&g);
    first_mesh_free(&m);
    return picture_end(path, &im);
}
