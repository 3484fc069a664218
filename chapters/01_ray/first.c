/* 01 Dots at equal steps of t. Left D leads from the middle to a square, right its length is 1.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 01_ray_first chapters/01_ray/first.c -lm
 */
#include "../../common/image.h"
#include "first.h"

enum { panel = 360, rays = 48 };

/* A round dot at p, one unit being 100 pixels; its edge is blended over one pixel. */
static void dot(image *im, vec3 p, double radius, vec3 colour)
{
    double px = panel / 2 + 100 * p.x, py = panel / 2 - 100 * p.y;
    int n = (int)radius + 2;
    for (int y = (int)py - n; y <= (int)py + n; y++)
        for (int x = (int)px - n; x <= (int)px + n; x++) {
            if (x < 0 || y < 0 || x >= im->width || y >= im->height) continue;
            double far = hypot(x + 0.5 - px, y + 0.5 - py);
            double cover = real_clamp(radius + 0.5 - far, 0, 1);
            vec3 old = image_get(im, x, y);
            image_set(im, x, y, vadd(vscale(old, 1 - cover), vscale(colour, cover)));
        }
}

static image fan(bool unit)
{
    image im = image_new(panel, panel);
    for (int i = 0; i < panel * panel; i++) image_set(&im, i % panel, i / panel, vec(1, 1, 1));
    for (int i = 0; i < rays; i++) {
        /* B walks round a square whose middle is A. */
        double s = 8.0 * i / rays, side = fmod(s, 2) - 1;
        vec3 b = s < 2 ? vec(side, 1, 0) : s < 4 ? vec(1, -side, 0)
               : s < 6 ? vec(-side, -1, 0) : vec(-1, side, 0);
        ray r = ray_between(vec(0, 0, 0), b);
        if (unit) r = first_ray_unit(r), r.tmax = 1;  /* the same numbers t, other points */
        for (real t = 0; t <= 1.75; t += 0.125) {
            vec3 colour = vec(0.8 * t, 0.1, 0.6 * (1 - t)), pale = vec(0.75, 0.75, 0.75);
            bool inside = ray_covers(r, t);
            dot(&im, ray_at(r, t), inside ? 3.2 : 1.7, inside ? colour : pale);
        }
    }
    return im;
}

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "01_ray_first");
    image im = image_new(2 * panel, panel), left = fan(false), right = fan(true);
    image_place(&im, 0, 0, &left);
    image_place(&im, panel, 0, &right);
    image_free(&left), image_free(&right);
    return picture_end(path, &im);
}
