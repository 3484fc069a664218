/* 20 Left: 4000 darts; the share inside the circle is pi / 4. Right: errors of three ways to pi.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 20_monte_carlo_first chapters/20_monte_carlo/first.c -lm
   Orange darts, blue uniform, green importance. Dots: measured; lines: sqrt(variance / N). */
#include "../../common/image.h"
#include "first.h"

enum { side = 360, left = side + 24, darts = 4000, repeats = 48, steps = 8 };

static void dot(image *im, double px, double py, double radius, vec3 c)
{
    for (int y = (int)(py - radius - 1); y <= (int)(py + radius + 1); y++)
        for (int x = (int)(px - radius - 1); x <= (int)(px + radius + 1); x++) {
            if (x < 0 || y < 0 || x >= im->width || y >= im->height) continue;
            double cover = real_clamp(radius + 0.5 - hypot(x + 0.5 - px, y + 0.5 - py), 0, 1);
            image_set(im, x, y, vadd(vscale(image_get(im, x, y), 1 - cover), vscale(c, cover)));
        }
}

/* Letters of 5 rows of squares: two digits of eight a row, the uppermost first; centred at x. */
static void print(image *im, int x, int y, const char *text, vec3 c)
{
    static const char letters[] = "01.NERODATSUIFMPC";
    static const int rows[] = {07050505070, 02060202070, 020, 04464544444, 07040604070, 06050605050,
        02050505020, 06050505060, 02050705050, 07020202020, 03040201060, 05050505070, 07020202070,
        07040604040, 04266524242, 06050604040, 03040404030};
    for (x -= 6 * (int)strlen(text); *text; x += *text == 'M' ? 18 : *text == 'N' ? 15 : 12, text++)
        for (int k = 0; k < 30 * 9; k++)
            if (rows[strchr(letters, *text) - letters] >> (29 - k / 9) & 1)
                image_set(im, x + k / 9 % 6 * 3 + k % 3, y + k / 54 * 3 + k / 3 % 3, c);
}

/* Places of N (a power of 4) and of an error from 10^0.5 down to 10^-3.5. */
static double across(double k) { return left + 50 + (side - 70) * k / (steps - 1); }
static double down(double error) { return (0.5 - log10(error)) / 4 * side; }

int main(int argc, char **argv)
{
    const char *path = picture_path(argc, argv, "20_monte_carlo_first");
    static const char *const name[3] = {"DARTS", "UNIFORM", "IMPORTANCE"};
    const vec3 colour[3] = {{0.85, 0.3, 0.02}, {0.05, 0.4, 0.75}, {0, 0.45, 0.25}};
    const vec3 black = vec(0.02, 0.02, 0.02), grey = vec(0.7, 0.7, 0.7), white = vec(1, 1, 1);
    const double variance[3] = {pi * (4 - pi), 32 / 3.0 - pi * pi, 60 - 72 * log(2) - pi * pi};
    image im = image_new(left + side, side);
    for (int i = 0; i < im.width * side; i++) image_set(&im, i % im.width, i / im.width, white);
    for (int i = 0; i < darts; i++) {
        real u = random_real(1, 0, i, 0), v = random_real(1, 0, i, 1);
        dot(&im, u * (side - 3), side - v * (side - 3), 1.6, colour[first_pi_darts(u, v) == 0]);
    }
    for (double a = 0; a < pi / 2; a += pi / 8 / side)
        dot(&im, (side - 3) * cos(a), side - (side - 3) * sin(a), 0.7, black);
    static const char *const up[] = {"1", ".1", ".01", ".001", ""};
    static const char *const along[] = {"1", "10", "100", "1000", "10000"};
    for (int e = 0; e < 5; e++) {
        int at = (int)across(e / log10(4)), high = (int)down(pow(10, -e));
        for (int x = (int)across(0); e < 4 && x < im.width; x++) image_set(&im, x, high, grey);
        for (int y = 0; y < side - 24; y++) image_set(&im, at, y, grey);
        print(&im, left + 24, high - 7, up[e], black), print(&im, at, side - 19, along[e], black);
    }
    print(&im, left + 30, 4, "ERROR", black), print(&im, left + 14, side - 19, "N", black);
    for (int way = 0; way < 3; way++) {
        print(&im, left + 226 + 6 * (int)strlen(name[way]), 8 + 22 * way, name[way], colour[way]);
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
