/* 01 One ray a pixel, and where it meets the floor. Left d ends on a window, right its length is 1.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 01_ray_first chapters/01_ray/first.c -lm
 */
#include "../../common/image.h"
#include "first.h"

enum { panel = 360, gap = 6 };

/* The floor y = 0: o.y + t d.y = 0. Striped by t, and a little by squares of the floor. */
static vec3 floor_colour(ray r)
{
    real t = -r.o.y / r.d.y;
    if (!ray_covers(r, t)) return vec(0.78, 0.86, 0.95);  /* above the horizon, or not called for */
    vec3 p = ray_at(r, t);
    int stripe = (int)floor(t), square = (int)floor(p.x) + (int)floor(p.z);
    vec3 paint = stripe % 2 ? vec(0, 0.25, 0.48) : vec(0.9, 0.55, 0);
    return vscale(paint, square % 2 ? 0.75 : 1);
}

static image look(bool unit)
{
    image im = image_new(panel, panel);
    for (int y = 0; y < panel; y++)
        for (int x = 0; x < panel; x++) {
            /* From the eye through the middle of this pixel of a window, 1 in front and 2 wide. */
            vec3 eye = vec(0, 2, 0);
            vec3 pixel = vec(2 * (x + 0.5) / panel - 1, 2.4 - 2 * (y + 0.5) / panel, -1);
            ray r = ray_between(eye, pixel);
            if (unit) r = first_ray_unit(r);
            r.tmin = 2, r.tmax = 9;
            image_set(&im, x, y, floor_colour(r));
        }
    return im;
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "01_ray_first");
    image im = image_new(2 * panel + gap, panel), left = look(false), right = look(true);
    for (int y = 0; y < panel; y++)
        for (int x = panel; x < panel + gap; x++) image_set(&im, x, y, vec(1, 1, 1));
    image_place(&im, 0, 0, &left);
    image_place(&im, panel + gap, 0, &right);
    image_free(&left), image_free(&right);
    return picture_end(path, &im);
}
