/* 19_pixel: what `19_whitted --pixel` says, read as numbers: weights times what is found add up to
 * the pixel that the picture has, and shares to 1. */
#include "check.h"
#include "program.h"
#include "../common/image.h"

enum { width = 64, height = 48 };
typedef struct {
    double adds[3], pixel[3];      /* sum of all that is added; the program's own */
    double sky, shares;            /* worst: weight times sky against what it adds; R + (1 - R) */
    int rays, shadows, total, numbered, lines;
} told;

/* "words (a, b, c)" after these words. */
static bool three(const char *line, const char *words, double v[3])
{
    const char *at = strstr(line, words);
    /* NOLINTNEXTLINE(cert-err34-c): the program printed it */
    return at && sscanf(at + strlen(words), " (%lf, %lf, %lf)", &v[0], &v[1], &v[2]) == 3;
}

static told read_told(void)
{
    told x = {.pixel = {-1, -1, -1}};
    char line[400];
    double weight[3] = {0}, sky[3], v[3], R, T;
    bool in_sky = false;
    FILE *in = fopen(in_directory("out"), "r");
    while (in && fgets(line, sizeof line, in)) {
        const char *last = strrchr(line, '(');
        int a, b;
        char end;
        x.lines += *line != '#' && *line != '-';
        /* NOLINTNEXTLINE(cert-err34-c): the program printed it */
        x.numbered += last && sscanf(last, "(%2d.%2d%c", &a, &b, &end) == 3 && end == ')';
        x.rays += strstr(line, " ray, depth ") != NULL;
        x.shadows += strstr(line, " shadow ray: ") && !strstr(line, "no shadow");
        x.total += strstr(line, "all is reflected") != NULL;
        three(line, "  weight", weight);
        if (three(line, "in the sky, where L =", sky)) in_sky = true;
        if (three(line, "it adds", v)) {
            for (int k = 0; k < 3; k++) {
                x.adds[k] += v[k];
                if (in_sky) x.sky = check_worse(x.sky, fabs(v[k] / (weight[k] * sky[k]) - 1));
            }
            in_sky = false;
        }
        /* NOLINTNEXTLINE(cert-err34-c): the program printed it */
        if (sscanf(line, " R = %lf is reflected, 1 - R = %lf", &R, &T) == 2)
            x.shares = check_worse(x.shares, fabs(R + T - 1));
        three(line, "all that is added: L =", x.pixel);
    }
    if (in) fclose(in);
    return x;
}

/* All numbers are printed with six digits: off by half of the last, 5e-6 of themselves. */
static void test_adds_up(void)
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
    int most = 0, total = 0, shadows = 0;
    for (int y = 1; y < height; y += 5)
        for (int x = 20; x < 54; x += 5) {  /* both balls, floor and sky */
            snprintf(arguments, sizeof arguments, "--size %dx%d --pixel %d,%d", width, height, x,
                     y);
            check_equal(run("19_whitted", arguments), 0, "%s", arguments);
            told t = read_told();
            vec3 due = image_get(&im, x, y);
            double c[3] = {(double)due.x, (double)due.y, (double)due.z};
            for (int k = 0; k < 3; k++) {
                check_at_most(fabs(t.adds[k] - t.pixel[k]), 2 * digits * t.pixel[k],
                              "%d, %d: a sum of positive terms", x, y);
                check_at_most(fabs(t.adds[k] - c[k]), (digits + 1e-7) * c[k],
                              "%d, %d: the picture, in float32", x, y);
            }
            check_at_most(t.sky, 4 * digits, "weight times sky: three roundings");
            check_at_most(t.shares, 2 * digits, "R and 1 - R");
            check_at_most(t.lines - t.numbered, t.rays + 1,
                          "lines without equation: the sky, or a cut; the last");
            if (t.rays > most) most = t.rays;
            total += t.total, shadows += t.shadows;
        }
    check_at_least(most, 12, "a tree");
    check_at_least(total, 1, "total reflection");
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
    test_adds_up();
    test_misuse();
    remove_directory();
    return check_report("19_pixel");
}
