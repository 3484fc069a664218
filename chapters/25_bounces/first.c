/* 25 The terms of L = E + K E + K^2 E + ...: light reflected once, twice, three times.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 25_bounces_first chapters/25_bounces/first.c -lm
   Below, the sums so far, with E, the lamp. Shown twice as bright. */
#include "../../common/image.h"
#include "first.h"

enum { side = 214, n = 4, terms = 3, N = 1 };

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "25_bounces_first");
    image im = image_new(terms * side, 2 * side);
    first_scene s = first_cornell();
    first_camera c = first_cornell_inside(side, side);
    for (int y = 0; y < side; y++)
        for (int x = 0; x < side; x++) {
            vec3 all = vec(0, 0, 0);
            for (int k = 0; k <= terms; k++) {
                vec3 sum = vec(0, 0, 0);
                for (int i = 0; i < n * n; i++) {
                    random_stream random = random_start(k + 1, y * side + x, i);
                    sum = vadd(sum, first_term(&s, first_pixel_ray(c, x, y, i, n), k, N, &random));
                }
                vec3 term = vscale(sum, 1.0 / (n * n));
                all = vadd(all, term);
                if (k == 0) continue;
                image_set(&im, (k - 1) * side + x, y, vscale(term, 2));
                image_set(&im, (k - 1) * side + x, side + y, vscale(all, 2));
            }
        }
    printf("rays for one eye ray, up to K^5 E, if each hit sends N:\n");
    for (int each = 1; each <= 16; each *= 4)
        printf("    N = %2d: %7.0f\n", each, first_rays_of_branching(each, 5));
    printf("in a furnace that emits 1 and reflects half of it, after n bounces (for ever: 2):\n");
    for (int k = 0; k <= 8; k += 2) printf("    n = %d: %.4f\n", k, first_furnace(1, 0.5, k));
    printf("here, one path a term, shadow rays included: %ld rays\n", first_bounce_rays);
    return picture_end(path, &im);
}
