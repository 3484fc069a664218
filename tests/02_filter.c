/* Tests of 02_camera: filters, sample positions, and the patterns whose filtered value is known. */
#include "check.h"
#include "../chapters/02_camera/lab/measure.h"

#define eps ((double)real_epsilon)
static filter filters[3];
static const char *const names[] = {"box", "tent", "Gaussian"};
static random_stream s;

static double uniform(double a, double b) { return a + (b - a) * (double)random_next(&s); }

/* The midpoint rule with 20001 points on [-R, R] in double: another way to the same integral. A
 * jump of height 2 costs at most half a step; where nothing jumps it is far better. */
static double by_midpoints(double (*f)(double x, double a), double x, double a, filter g, double R)
{
    enum { n = 20001 };
    double sum = 0, weight = 0;
    for (int i = 0; i < n; i++) {
        double d = R * ((2 * i + 1) / (double)n - 1);
        double w = g.kind == FILTER_BOX ? 1
                 : g.kind == FILTER_TENT ? 1 - fabs(d) / R
                 : exp(-2 * d * d);
        sum += w * f(x + d, a);
        weight += w;
    }
    return sum / weight;
}

/* The integral of filter_weight over the plane: 1, radius^2, or about 2 pi sigma^2; test_white_wall
 * would see another. */
static real filter_volume(filter f)
{
    real side = f.kind == FILTER_BOX ? 2 * f.radius
              : f.kind == FILTER_TENT ? f.radius
              : f.sigma * sqrt(2 * pi) * erf(f.radius / (f.sigma * sqrt((real)2)));
    return side * side;
}

/* Divides by what n weights sum to on average, n volume / (2 radius)^2, and not by their sum. */
static vec3 filter_mean_naive(filter_sum sum, filter f, int n)
{
    return vscale(sum.colour, 4 * f.radius * f.radius / (filter_volume(f) * (real)n));
}

static double cosine_wave(double x, double a) { return cos(a * x * x); }
static double sine_wave(double x, double a) { return sin(a * x * x); }

static void test_patterns(void)
{
    check_equal(square_wave(0.5, 1), 1, "first stretch");
    check_equal(square_wave(1.5, 1), -1, "second stretch");
    check_equal(square_wave(-0.5, 1), -1, "to the left of 0");
    check_equal(checkerboard(0.5, 0.5, 1), 1, "white square");
    check_equal(checkerboard(0.5, -0.5, 1), 0, "black square");
    for (size_t k = 0; k < check_count(300); k++)
        for (int i = 0; i < 2; i++) {  /* box and tent */
            double x = uniform(-20, 20), cell = uniform(0.3, 3), R = (double)filters[i].radius;
            /* each jump, of height 2, costs at most half a step of 2 R / 20001 */
            double jumps = 2 + 2 * R / cell;
            double seen = by_midpoints(square_wave, x, cell, filters[i], R);
            check_close(square_wave_filtered(x, cell, filters[i]), seen, jumps * 4 / 20001,
                        "%s over a square wave", names[i]);
        }
    for (size_t k = 0; k < check_count(300); k++) {
        double x = uniform(-30, 30), y = uniform(-30, 30), a = uniform(0.01, 0.1);
        /* cos(p + q) = cos p cos q - sin p sin q; 9 sigma leave 2e-19 of a Gaussian outside. The
         * phase a x^2, up to 120, is rounded by 1e-14, the phases of four integrals by chance */
        double cx = by_midpoints(cosine_wave, x, a, filter_gaussian, 4.5);
        double cy = by_midpoints(cosine_wave, y, a, filter_gaussian, 4.5);
        double sx = by_midpoints(sine_wave, x, a, filter_gaussian, 4.5);
        double sy = by_midpoints(sine_wave, y, a, filter_gaussian, 4.5);
        check_close(zone_plate_filtered(x, y, a, 0.5), 0.5 + 0.5 * (cx * cy - sx * sy), 1e-13,
                    "zone plate");
    }
    check_close(zone_plate_filtered(3, 4, 0.1, 0), zone_plate(3, 4, 0.1), 1e-15,
                "no filter: the plate itself");
    check_equal(zone_plate(0, 0, 0.1), 1, "white in the middle");
}

static void test_weights(void)
{
    for (int i = 0; i < 3; i++) {
        filter f = filters[i];
        double R = (double)f.radius;
        check_equal(filter_weight(f, 0, 0), 1, "%s: 1 in the centre", names[i]);
        check_equal(filter_weight(f, f.radius * (real)1.001, 0), 0, "%s: 0 outside", names[i]);
        check_equal(filter_weight(f, 0, -f.radius * (real)1.001), 0, "%s: 0 above", names[i]);
        check_equal(filter_weight(f, (real)NAN, 0), 0, "%s: a NaN has no weight", names[i]);
        for (int k = 0; k < 100; k++) {
            real x = (real)uniform(-R, R), y = (real)uniform(-R, R);
            check(filter_weight(f, x, y) == filter_weight(f, -y, x),
                  "%s: the same in all four directions", names[i]);
        }
    }
    check_equal(filter_weight(filter_box, 0.5, -0.5), 1, "box: its edge belongs to it");
    check_close(filter_weight(filter_tent, 0.25, 0.5), 0.375, 2 * eps,
                "tent: 3/4 times 1/2");
    check_close(filter_weight(filter_gaussian, 0.5, 0.5), exp(-1.0), 4 * eps,
                "Gaussian: one sigma each way");
}

/* Every position lies in the square; jittered: one in each cell; regular: no stream is needed. */
static void test_positions(void)
{
    for (int n = 1; n <= 8; n++)
        for (int k = 0; k < n * n; k++) {
            real x, y, R = 2;
            samples_place(SAMPLES_JITTERED, k, n, R, &s, &x, &y);
            double i = ((double)x / (double)R + 1) * n / 2, j = ((double)y / (double)R + 1) * n / 2;
            check(i >= k % n - 4 * n * eps && i <= k % n + 1 + 4 * n * eps,
                  "jittered: in its own column");
            check(j >= k / n - 4 * n * eps && j <= k / n + 1 + 4 * n * eps,
                  "jittered: in its own row");
            samples_place(SAMPLES_RANDOM, k, n, R, &s, &x, &y);
            check(x >= -R && x <= R && y >= -R && y <= R, "random: in the square");
            samples_place(SAMPLES_REGULAR, k, n, R, NULL, &x, &y);
            check_close(x, R * (real)(2 * (k % n) + 1 - n) / (real)n, 4 * eps,
                        "regular: the middle of its column");
            check_close(y, R * (real)(2 * (k / n) + 1 - n) / (real)n, 4 * eps,
                        "regular: the middle of its row");
        }
    real x, y;
    samples_place(SAMPLES_REGULAR, 0, 1, 1, NULL, &x, &y);
    check(x == 0 && y == 0, "one regular sample: the pixel's centre");
}

/* A wall of one colour must keep it. filter_mean: n products and sums, 1.5 epsilon each at most in
 * either sum, all terms positive: the relative error stays below 2 n epsilon, n being the rays. */
static void test_white_wall(void)
{
    for (int i = 0; i < 3; i++)
        for (int how = 0; how < 3; how++)
            for (int n = 2; n <= 8; n *= 2) {
                double worst = 0, naive = 0, mean = 0;
                size_t pixels = check_count(2000);
                for (size_t p = 0; p < pixels; p++) {
                    filter_sum sum = {{0, 0, 0}, 0};
                    for (int k = 0; k < n * n; k++) {
                        real x, y;
                        samples_place((sample_placement)how, k, n, filters[i].radius, &s, &x, &y);
                        sum = filter_add(sum, filter_weight(filters[i], x, y),
                                         vec(1, 0.5, 0));
                    }
                    vec3 c = filter_mean(sum);
                    double off = fabs((double)c.x - 1), aside = fabs((double)c.y - 0.5);
                    worst = check_worse(worst, check_worse(off, aside));
                    check_equal(c.z, 0, "black stays black");
                    double v = (double)filter_mean_naive(sum, filters[i], n * n).x;
                    naive = check_worse(naive, fabs(v - 1));
                    mean += v / (double)pixels;
                }
                check_at_most(worst, 2 * n * n * eps,
                              "%s, placement %d, %d rays: a wall keeps its colour", names[i], how,
                              n * n);
                if (filters[i].kind != FILTER_BOX && how != SAMPLES_REGULAR) {
                    check_at_least(naive, 0.1 / n, "%s: filter_mean_naive must be seen to fail",
                                   names[i]);
                    /* five standard errors of the mean; one weight's spread is below 3 */
                    check_close(mean, 1, 5 * 3 / (n * sqrt((double)pixels)),
                                "%s: but right on average", names[i]);
                }
            }
    filter_sum none = {{0, 0, 0}, 0};
    check(vzero(filter_mean(none)), "no weight at all: black");
    filter_sum nan_ = {{1, 1, 1}, (real)NAN};
    check(vzero(filter_mean(nan_)), "a NaN weight: black");
}

/* The trials of the page's table: the checkerboard under box and tent. Random: the spread of one
 * ray is at most 1/2, times sqrt(sum w^2) / sum w, which tends to sqrt(area * integral of w^2) /
 * (integral of w) / sqrt N, for the tent 4/3. Jittered: only the cells that an edge crosses count,
 * some n of n^2, so the error falls as N^-3/4: four times the rays bring 2.8 times less. */
static void test_convergence(void)
{
    enum { box, tent, regular, at_random };
    double error[2][camera_way_count];
    camera_trial m[camera_way_count];
    for (int k = 0; k < 2; k++) {
        camera_trials(m, 8 << k);
        for (int j = box; j <= at_random; j++) error[k][j] = camera_run_pixels(&m[j]);
    }
    check_at_most(error[1][at_random], 0.5 * 4 / 3 / 16 * 1.1, "256 random rays");
    check_at_least(error[1][at_random], 0.5 * 4 / 3 / 16 * 0.3, "and they do have an error");
    check_close(error[0][at_random] / error[1][at_random], 2, 0.3, "which falls as N^-1/2");
    for (int j = box; j <= tent; j++) {
        check_close(log(error[0][j] / error[1][j]) / log(4.0), 0.75, 0.1,
                    "%s: jittered falls as N^-3/4", names[j]);
        check_at_most(error[1][j], error[1][at_random] / 1.5, "%s: jittered beats random",
                      names[j]);
    }
    check_at_most(error[1][regular], 0.03, "regular samples tend to the filtered value, too");
}

/* A white stripe, 1 where |x| < 1/2, under a tent: 3/4. Dividing by the weights that came is
 * biased: with one ray the mean is the colour of that ray, its weight drops out, and the tent
 * becomes a box of its size: 1/2. The bias falls as 1/N, the spread as 1/sqrt(N). Dividing by the
 * expected weight has no bias, and spreads more. [0]: by the weights that came. */
static void stripe_means(int n, int trials, double bias[2], double spread[2])
{
    double sum[2] = {0, 0}, square[2] = {0, 0};
    for (int i = 0; i < trials; i++) {
        filter_sum f = {{0, 0, 0}, 0};
        for (int k = 0; k < n; k++) {
            real x, y;
            samples_place(SAMPLES_RANDOM, k, 1, 1, &s, &x, &y);
            f = filter_add(f, filter_weight(filter_tent, x, y), vec((double)fabs(x) < 0.5, 0, 0));
        }
        double e[] = {(double)filter_mean(f).x - 0.75,
                      (double)filter_mean_naive(f, filter_tent, n).x - 0.75};
        for (int k = 0; k < 2; k++) sum[k] += e[k], square[k] += e[k] * e[k];
    }
    for (int k = 0; k < 2; k++) {
        bias[k] = sum[k] / trials;
        spread[k] = sqrt(square[k] / trials - bias[k] * bias[k]);
    }
}

static void test_bias(void)
{
    const int n = (int)check_sample(400000, 100000);  /* fewer don't give ten sigma */
    double bias[4][2], spread[4][2];
    for (int k = 0; k < 4; k++) stripe_means(1 << 2 * k, k ? n / 4 : n, bias[k], spread[k]);
    check_close(bias[0][0], -0.25, 4 * 0.5 / sqrt((double)n), "one ray: 1/2 - 3/4");
    for (int k = 1; k < 4; k++) {
        double sigma = spread[k][1] / sqrt(n / 4), own = spread[k][0] / sqrt(n / 4);
        check_at_most(fabs(bias[k][1]), 4 * sigma, "by the expected weight: no bias");
        check_at_least(spread[k][1], 1.5 * spread[k][0], "but more spread");
        if (k < 3) check_at_least(-bias[k][0], 10 * own, "by their own weights: too dark");
        if (k > 1) check_close(spread[k - 1][0] / spread[k][0], 2, 0.3, "spread as 1 / sqrt(N)");
    }
    check_close(bias[1][0] / bias[2][0], 4.5, 1, "bias as 1 / N, or a little faster at first");
}

int main(void)
{
    s = random_start(2, 1, 0);
    filters[0] = filter_box, filters[1] = filter_tent, filters[2] = filter_gaussian;
    return check_all("02_filter", test_patterns, test_weights, test_positions, test_white_wall,
                     test_convergence, test_bias);
}
