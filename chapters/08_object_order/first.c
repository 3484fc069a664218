/* 08 A knot over tiles, drawn triangle by triangle; on the left when a third was done, right all.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 08_object_order_first chapters/08_object_order/first.c -lm
   08_object_order_first [PICTURE.png] */
#include "../../common/image.h"
#include "first.h"

enum { side = 480, tiles = 8 };

/* The floor: tiles x tiles squares, two triangles each, before the knot's own triangles. */
static void add_floor(first_mesh *m, const first_mesh *knot)
{
    m->tri = allocate(2 * tiles * tiles + (size_t)knot->n, sizeof *m->tri);
    m->n = 0;
    for (int k = 0; k < tiles * tiles; k++) {
        real x = 2 * (k % tiles) - tiles, z = 2 * (k / tiles) - tiles, y = -4;
        vec3 a = vec(x, y, z), b = vec(x + 2, y, z), c = vec(x + 2, y, z + 2), d = vec(x, y, z + 2);
        m->tri[m->n++] = (triangle){a, c, b};
        m->tri[m->n++] = (triangle){a, d, c};
    }
    memcpy(m->tri + m->n, knot->tri, (size_t)knot->n * sizeof *knot->tri);
    m->n += knot->n;
}

/* Lit by a lamp at the eye; two tones of tiles. */
static vec3 colour(const first_mesh *m, hit h, ray r)
{
    if (h.shape == UINT32_MAX) return vec(0.75, 0.82, 0.9);
    real facing = -vdot(first_mesh_normal(m, h.shape, r.d), vunit(r.d));
    int k = (int)h.shape / 2;
    if (k >= tiles * tiles) return vscale(vec(0.95, 0.6, 0.1), 0.1 + 0.9 * facing * facing);
    return (k % tiles + k / tiles) % 2 ? vec(0.08, 0.2, 0.32) : vec(0.6, 0.62, 0.65);
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "08_object_order_first");
    first_mesh knot = first_knot(90, 12), m;
    add_floor(&m, &knot);
    first_camera c = first_camera_at(vec(4, 8, 19), vec(0, -1, 0), vec(0, 1, 0), 27, side, side);
    image im = image_new(2 * side, side);
    for (int k = 0; k < 2; k++) {
        first_mesh part = {m.tri, k ? m.n : m.n / 3};
        first_raster s = first_raster_new(side, side);
        first_raster_mesh(&s, &part, c);
        for (int y = 0; y < side; y++)
            for (int x = 0; x < side; x++)
                image_set(&im, k * side + x, y, colour(&m, s.h[y * side + x],
                                                       first_camera_ray(c, x + 0.5, y + 0.5)));
        first_raster_free(&s);
    }
    printf("%d triangles, %ld pixels asked, %ld covered\n", m.n, first_asked, first_covered);
    first_mesh_free(&knot), first_mesh_free(&m);
    return picture_end(path, &im);
}
