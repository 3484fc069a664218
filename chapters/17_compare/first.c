/* 17 How many triangles does a ray ask? A bar for each structure; each line stands for ten times
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 17_compare_first chapters/17_compare/first.c -lm
   what the one before it does. Prints whether the hits are those of brute force, and the time. */
#include "../../common/image.h"
#include "../../common/random.h"
#include "first.h"
#include <time.h>

enum { width = 640, height = 370, rays = 12000, left = 150, decade = 120 };

static void fill(image *im, int x, int y, int w, int h, vec3 c)
{
    for (int j = y; j < y + h; j++)
        for (int i = x; i < x + w; i++)
            if (i >= 0 && j >= 0 && i < im->width && j < im->height) image_set(im, i, j, c);
}

/* Letters of 3 x 5 squares, a digit of eight for each row, the uppermost first. */
static const char letter[] = "ABCDEGHIKORSTUVWPY01";
static const int rows[] = {025755, 065656, 034443, 065556, 074647, 034553, 055755, 072227, 055655,
    025552, 065655, 034216, 072222, 055557, 055552, 055775, 065644, 055222, 075557, 026227};
static void print(image *im, int x, int y, const char *text, int size)
{
    for (; *text; text++, x += 4 * size) {
        const char *at = strchr(letter, *text);
        for (int bit = 0; at && bit < 15; bit++)
            if (rows[at - letter] >> (14 - bit) & 1)
                fill(im, x + bit % 3 * size, y + bit / 3 * size, size, size, vec(0.02, 0.02, 0.02));
    }
}

/* Through the ball round the knot, from everywhere to everywhere. */
static ray random_ray(int i)
{
    vec3 p[2];
    for (int k = 0; k < 2; k++) {
        real z = 2 * random_real(1, i, k, 0) - 1, a = 2 * pi * random_real(1, i, k, 1);
        p[k] = vscale(vec(sqrt(1 - z * z) * cos(a), sqrt(1 - z * z) * sin(a), z), 3.7);
    }
    return ray_from(p[0], vsub(p[1], p[0]));
}

int main(int argc, char **argv)
{
    static hit truth[rays];
    static first_contest c;
    const char *path = picture_path(argc, argv, "17_compare_first");
    const char *tick[] = {"1", "10", "100", "1000"};
    const vec3 colour[first_structures] = {{0.45, 0.45, 0.45}, {0.9, 0.35, 0}, {0.1, 0.45, 0.8},
        {0, 0.35, 0.2}, {0.6, 0.2, 0.4}, {0.8, 0.1, 0.02}, {0.87, 0.77, 0.05}};
    image im = image_new(width, height);
    first_mesh m = first_knot(80, 10);
    first_contest_build(&m, &c);
    fill(&im, 0, 0, width, height, vec(1, 1, 1));
    print(&im, left, 12, "TESTS A RAY", 3);
    for (int k = 0; k < 4; k++) {
        fill(&im, left + k * decade, 45, 1, 290, vec(0.6, 0.6, 0.6));
        print(&im, left + k * decade, 345, tick[k], 3);
    }
    printf("structure  tests a ray  ns a ray  hits unlike brute force\n");
    for (int s = 0, wrong; s < first_structures; s++) {
        clock_t start = clock();
        first_tests = wrong = 0;
        for (int i = 0; i < rays; i++) {
            hit h = {real_infinity, 0, 0, 0};
            if (!first_contest_hit(&c, s, random_ray(i), &h)) h.t = real_infinity;
            if (s == first_use_brute) truth[i] = h;
            else if (h.t != truth[i].t) wrong++;
        }
        double ns = 1e9 * (double)(clock() - start) / CLOCKS_PER_SEC / rays;
        double tests = (double)first_tests / rays;
        printf("%-9s  %11.1f  %8.0f  %d of %d\n", first_structure_name[s], tests, ns, wrong, rays);
        print(&im, 20, 52 + 40 * s, first_structure_name[s], 4);
        fill(&im, left, 50 + 40 * s, (int)(decade * log10(tests)), 26, colour[s]);
    }
    first_contest_free(&c);
    first_mesh_free(&m);
    return picture_end(path, &im);
}
