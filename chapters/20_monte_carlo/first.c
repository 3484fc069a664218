/* 20 Left: 4000 darts; the share inside the circle is pi / 4. Right: errors of three ways to pi.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 20_monte_carlo_first chapters/20_monte_carlo/first.c -lm
   Orange darts, blue uniform, green importance. Dots: measured; lines: sqrt(variance / N). */
#include "../../common/image.h"
#include "first.h"

static const vec3 black = {0.02, 0.02, 0.02};
enum { side = 360, gap = 24, darts = 4000, repeats = 48, steps = 8 };

static void dot(image *im, double px, double py, double radius, vec3 c)
{
    for (int y = (int)(py - radius - 1); y <= (int)(py + radius + 1); y++)
        for (int x = (int)(px - radius - 1); x <= (int)(px + radius + 1); x++) {
            if (x < 0 || y < 0 || x >= im->width || y >= im->height) continue;
            double cover = real_clamp(radius + 0.5 - hypot(x + 0.5 - px, y + 0.5 - py), 0, 1);
            image_set(im, x, y, vadd(vscale(image_get(im, x, y), 1 - cover), vscale(c, cover)));
        }
}

/* Letters of 3 x 5 squares, a digit of eight for each row, the uppermost first; centred at x. */
static void print(image *im, int x, int y, const char *text)
{
    static const int rows[] = {075557, 026227, 000002, 057755, 074647, 065655, 025552};
    for (x -= 6 * (int)strlen(text); *text; text++, x += 12)
        for (int k = 0; k < 15 * 9; k++)
            if (rows[strchr("01.NERO", *text) - "01.NERO"] >> (14 - k / 9) & 1)
                image_set(im, x + k / 9 % 3 * 3 + k % 3, y + k / 27 * 3 + k / 3 % 3, black);
}

/* Places of N (a power of 4) and of an error from 10^0.5 down to 10^-3.5. */
static double across(double k) { return side + gap + 50 + (side - 70) * k / (steps - 1); }
static double down(double error) { return (0.5 - log10(error)) / 4 * side; }

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "20_monte_carlo_first");
    const vec3 colour[3] = {{0.85, 0.3, 0.02}, {0.05, 0.4, 0.75}, {0, 0.45, 0.25}};
    const vec3 grey = vec(0.7, 0.7, 0.7), white = vec(1, 1, 1);
    const double variance[3] = {pi * (4 - pi), 32 / 3.0 - pi * pi, 60 - 72 * log(2) - pi * pi};
    image im = image_new(2 * side + gap, side);
    for (int y = 0; y < side; y++)
        for (int x = 0; x < im.width; x++) image_set(&im, x, y, white);
    for (int i = 0; i < darts; i++) {
        real u = random_real(1, 0, i, 0), v = random_real(1, 0, i, 1);
        dot(&im, u * (side - 3), side - v * (side - 3), 1.6, colour[first_pi_darts(u, v) == 0]);
    }
    for (int i = 0; i < 4 * side; i++) {
        double a = pi / 2 * i / (4 * side);
        dot(&im, (side - 3) * cos(a), side - (side - 3) * sin(a), 0.7, black);
    }

    static const char *const up[] = {"1", ".1", ".01", ".001", ""};
    static const char *const along[] = {"1", "10", "100", "1000", "10000"};
    for (int e = 0; e < 5; e++) {
        int at = (int)across(e / log10(4)), high = (int)down(pow(10, -e));
        for (int x = (int)across(0); e < 4 && x < im.width; x++) image_set(&im, x, high, grey);
        for (int y = 0; y < side - 24; y++) image_set(&im, at, y, grey);
        print(&im, side + gap + 24, high - 7, up[e]), print(&im, at, side - 19, along[e]);
    }
    print(&im, side + gap + 30, 4, "ERROR"), print(&im, side + gap + 10, side - 19, "N");
    for (int way = 0; way < 3; way++) {
        for (double k = 0; k < steps - 1; k += 0.01)
            dot(&im, across(k), down(sqrt(variance[way] / pow(4, k))), 0.4, colour[way]);
        for (int k = 0; k < steps; k++) {
            double square = 0;
            for (int j = 0; j < repeats; j++) {
                random_stream r = random_start(2, j, k);
                first_samples s = {0, 0, 0};
                for (int i = 0; i < 1 << 2 * k; i++) {
                    real u = random_next(&r), v = random_next(&r);
                    first_sample(&s, way == 0 ? first_pi_darts(u, v)
                                   : way == 1 ? first_pi_uniform(u) : first_pi_importance(u));
                }
                square += pow(first_mean(s) - pi, 2) / repeats;
            }
            dot(&im, across(k), down(sqrt(square)), 4, colour[way]);
        }
    }
    return picture_end(path, &im);
}
