/* 19_pixel: what `19_whitted --pixel` says, read as numbers: the pixel is the picture's, all its
 * rays are told, and what comes of a ray weighs no more than that does. */
#include "check.h"
#include "program.h"
#include "../common/image.h"

enum { width = 64, height = 48, deepest = 9 };
typedef struct { double pixel[3], gained; int rays, shadows, total; } told;

static told read_told(void)
{
    told x = {.pixel = {-1, -1, -1}};
    char line[400];
    double weight[deepest + 1] = {1}, children[deepest + 1] = {0}, w;
    int depth = 0;
    FILE *in = fopen(in_directory("out"), "r");
    while (in && fgets(line, sizeof line, in)) {
        const char *at = strstr(line, "L =");
        const char *ray = strstr(line, " ray, depth ");
        x.shadows += strstr(line, "shadow ray: ") != NULL;
        if (ray) x.rays++, depth = (int)strtol(ray + 12, NULL, 10);
        if (depth < 0 || depth > deepest) depth = 0, check(false, "%s", line);
        /* NOLINTBEGIN(cert-err34-c): the program printed it */
        if (sscanf(line, " in the pixel it weighs %lf", &w) == 1) {
            weight[depth] = w, children[depth] = 0, children[depth - (depth > 0)] += w;
            x.gained = fmax(x.gained, children[depth - (depth > 0)] / weight[depth - (depth > 0)]);
        }
        if (at) sscanf(at, "L = (%lf, %lf, %lf)", &x.pixel[0], &x.pixel[1], &x.pixel[2]);
        sscanf(line, "%d rays;", &x.total);
        /* NOLINTEND(cert-err34-c) */
    }
    if (in) fclose(in);
    return x;
}

/* All numbers are printed with six digits: off by half of the last, 5e-6 of themselves. */
static void test_pixels(void)
{
    const double digits = 5e-6;
    char arguments[160];
    image im = {0, 0, NULL};
    failure f;
    snprintf(arguments, sizeof arguments, "--size %dx%d --samples 1 --out @x.pfm", width, height);
    check_equal(run("19_whitted", arguments), 0, "the picture");
    if (!image_read(in_directory("x.pfm"), &im, &f)) {
        check(false, "%s", f.text);
        return;
    }
    int most = 0, shadows = 0;
    for (int y = 1; y < height; y += 5)
        for (int x = 20; x < 54; x += 5) {  /* both balls, floor and sky */
            snprintf(arguments, sizeof arguments, "--size %dx%d --pixel %d,%d", width, height, x,
                     y);
            check_equal(run("19_whitted", arguments), 0, "%s", arguments);
            told t = read_told();
            vec3 due = image_get(&im, x, y);
            for (int k = 0; k < 3; k++) {
                double c = (double)vaxis(due, k);
                check_at_most(fabs(t.pixel[k] - c), (digits + 1e-7) * c,
                              "%d, %d: the picture, in float32", x, y);
            }
            check_at_most(t.gained, 1 + 4 * digits, "%d, %d: children outweigh a ray", x, y);
            check_equal(t.rays + t.shadows, t.total, "%d, %d: a line or two a ray", x, y);
            if (t.rays > most) most = t.rays;
            shadows += t.shadows;
        }
    check_at_least(most, 12, "a tree");
    check_at_least(shadows, 50, "shadow rays");
    image_free(&im);
}

static void test_misuse(void)
{
    static const char *const wrong[] = {"3,2 --csv x", "3,2 --out x.png", "3,2 --spend-all",
                                        "3,2 --protocol spd", "0,48 --size 64x48", "3", "3,2,1",
                                        "3x2", "-1,2"};
    char arguments[80];
    check_equal(run("19_whitted", "--pixel 640,0"), 2, "beside the picture");
    check(printed("err", "--pixel 640,0: allowed are X,Y with X from 0 to 639, Y from 0 to 479"),
          "says so");
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        snprintf(arguments, sizeof arguments, "--pixel %s", wrong[i]);
        check_equal(run("19_whitted", arguments), 2, "%s", arguments);
        if (i < 4) check(printed("err", "--pixel goes with --size alone"), "%s", arguments);
    }
}

int main(void)
{
    if (!mkdtemp(directory)) return 1;
    test_pixels();
    test_misuse();
    remove_directory();
    return check_report("19_pixel");
}
