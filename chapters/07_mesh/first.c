/* 07 A mesh, its own or the OBJ file that is named. Left by brute force, right a cut through it.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 07_mesh_first chapters/07_mesh/first.c -lm
   What is inside by parity is orange. 07_mesh_first [FILE.obj] [PICTURE.png] */
#include "../../common/image.h"
#include "../02_camera/first.h"
#include "first.h"

enum { side = 320 };

static void bounds(const first_mesh *m, vec3 *lo, vec3 *hi)
{
    *lo = vec(INFINITY, INFINITY, INFINITY), *hi = vneg(*lo);
    for (int i = 0; i < m->n; i++) {
        triangle t = m->tri[i];
        *lo = vmin(*lo, vmin(t.a, vmin(t.b, t.c)));
        *hi = vmax(*hi, vmax(t.a, vmax(t.b, t.c)));
    }
}

int main(int argc, char **argv)
{
    bool file = argc > 1 && ends_with(argv[1], ".obj");
    const char *path = picture_path_after(file, argc, argv, "07_mesh_first");
    first_mesh m = file ? first_obj_read(argv[1]) : first_knot(36, 6);
    vec3 lo, hi;
    bounds(&m, &lo, &hi);
    vec3 middle = m.n ? vscale(vadd(lo, hi), 0.5) : vec(0, 0, 0);
    real size = m.n ? vlength(vsub(hi, lo)) : 1;
    first_camera c = first_camera_at(vadd(middle, vscale(vec(0.1, 0.35, 1.2), size)), middle,
                                     vec(0, 1, 0), 40, side, side);
    image im = image_new(2 * side, side);
    for (int y = 0; y < side; y++)
        for (int x = 0; x < side; x++) {
            /* The brighter, the more the triangle faces the eye. */
            ray r = first_camera_ray(c, x + 0.5, y + 0.5);
            hit h;
            vec3 seen = vec(0.85, 0.88, 0.92);
            if (first_mesh_hit(&m, r, &h)) {
                real facing = -vdot(first_mesh_normal(&m, h.shape, r.d), vunit(r.d));
                seen = vscale(vec(0.35, 0.6, 0.9), 0.1 + 0.9 * facing * facing);
            }
            image_set(&im, x, y, seen);

            /* The cut: the plane z = middle. A way out in any direction will do. */
            real u = (x + 0.5) / side - 0.5, v = 0.5 - (y + 0.5) / side;
            vec3 p = vadd(middle, vscale(vec(u, v, 0), 0.9 * size));
            bool inside = first_mesh_inside(&m, p, vec(0.36, 0.48, 0.8));
            image_set(&im, side + x, y, inside ? vec(0.85, 0.4, 0.02) : vec(1, 1, 1));
        }
    printf("%d triangles, %ld tests\n", m.n, first_tests);
    first_mesh_free(&m);
    return picture_end(path, &im);
}
