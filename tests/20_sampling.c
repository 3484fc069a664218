/* Tests of 20_monte_carlo: each sampler against its pdf, and against known expectations; wrong ones
 * are found out. Chi-square and t-tests have fixed seeds and the false-alarm rate 1e-8 each: there
 * are fewer than 100. What is wrong must fail at 1e-8, too. */
#include "../common/lab/chi_square.h"
#include "../chapters/20_monte_carlo/discrete.h"
#include "../chapters/20_monte_carlo/first.h"
#include "../chapters/20_monte_carlo/lab/sampling_naive.h"
#include "../common/lab/t_test.h"
#include "../common/numbers/wide.h"
#include "check.h"

#define alarm 1e-8
#define eps ((double)real_epsilon)

/* ---- one signature for all; the context is the lobe's exponent, the cone, ... ---- */

#define PLAIN(f) static vec3 s_##f(real u, real v, const void *c) { return (void)c, f(u, v); }
#define DENSITY(f) static real d_##f(vec3 w, const void *c) { return (void)c, f(w); }
PLAIN(sample_disk) PLAIN(sample_disk_naive)
PLAIN(sample_triangle) PLAIN(sample_triangle_naive)
PLAIN(sample_sphere) PLAIN(sample_sphere_naive) PLAIN(sample_hemisphere)
PLAIN(sample_hemisphere_naive) PLAIN(sample_cosine)
PLAIN(first_uniform_direction) PLAIN(first_cosine_direction)
DENSITY(pdf_disk) DENSITY(pdf_sphere) DENSITY(pdf_hemisphere) DENSITY(pdf_cosine)
static vec3 s_lobe(real u, real v, const void *c) { return sample_lobe(*(const real *)c, u, v); }
static real d_lobe(vec3 w, const void *c) { return pdf_lobe(*(const real *)c, w); }
static real d_cone(vec3 w, const void *c) { return pdf_cone(*(const direction_cone *)c, w); }
static vec3 s_cone(real u, real v, const void *c)
{
    return sample_cone(*(const direction_cone *)c, u, v);
}
static const triangle half = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};  /* barycentrics: area 1/2 */
static real d_triangle(vec3 b, const void *c) { return (void)b, (void)c, pdf_triangle(half); }

static const real n_zero = 0, n_one = 1, n_eight = 8, n_thousand = 1000, n_root = 0.5;
static direction_cone c_wide, c_half, c_all, c_sun;

enum { none = -1 };
typedef struct {
    const char *name;
    chi_square_sampler *sample;
    chi_square_pdf *pdf;
    const void *context;
    int shape;        /* none: directions */
    double focus;
} trial;

static const trial right[] = {
    {"disk", s_sample_disk, d_pdf_disk, NULL, DOMAIN_DISK, 1},
    {"triangle", s_sample_triangle, d_triangle, NULL, DOMAIN_TRIANGLE, 1},
    {"sphere", s_sample_sphere, d_pdf_sphere, NULL, none, 1},
    {"hemisphere", s_sample_hemisphere, d_pdf_hemisphere, NULL, none, 1},
    {"cosine", s_sample_cosine, d_pdf_cosine, NULL, none, 1},
    {"lobe, n = 0", s_lobe, d_lobe, &n_zero, none, 1},
    {"lobe, n = 1/2", s_lobe, d_lobe, &n_root, none, 1},
    {"lobe, n = 1", s_lobe, d_lobe, &n_one, none, 1},
    {"lobe, n = 8", s_lobe, d_lobe, &n_eight, none, 2},
    {"lobe, n = 1000", s_lobe, d_lobe, &n_thousand, none, 4},
    /* sides on borders of cells */
    {"cone, z > 1/2", s_cone, d_cone, &c_wide, none, 1},
    {"cone, z > 0", s_cone, d_cone, &c_half, none, 1},
    {"cone, all", s_cone, d_cone, &c_all, none, 1},
    {"cone, 2^-15", s_cone, d_cone, &c_sun, none, 15},
    /* the short book's: they reach the horizon, where the pdf is 0 */
    {"first hemisphere", s_first_uniform_direction, d_pdf_hemisphere, NULL, none, 1},
    {"first cosine", s_first_cosine_direction, d_pdf_cosine, NULL, none, 1},
};
enum { rights = sizeof right / sizeof *right, firsts = 2 };

static const trial wrong[] = {
    {"disk, r = u", s_sample_disk_naive, d_pdf_disk, NULL, DOMAIN_DISK, 1},
    {"triangle, v (1 - u)", s_sample_triangle_naive, d_triangle, NULL, DOMAIN_TRIANGLE, 1},
    {"sphere from a cube", s_sample_sphere_naive, d_pdf_sphere, NULL, none, 1},
    {"hemisphere, angle", s_sample_hemisphere_naive, d_pdf_hemisphere, NULL, none, 1},
    {"hemisphere for cosine", s_sample_hemisphere, d_pdf_cosine, NULL, none, 1},
    {"lobe n = 8 for cosine", s_lobe, d_pdf_cosine, &n_eight, none, 1},
};

static chi_square_result chi_square_of(const trial *t, size_t n)
{
    return t->shape == none
        ? chi_square_directions(t->sample, t->pdf, t->context, t->focus, 1, n)
        : chi_square_points(t->sample, t->pdf, t->context, (chi_square_domain)t->shape, 1, n);
}

static void test_chi_square(void)
{
    size_t n = check_sample(200000, 20000);  /* so many it takes to find the cube out */
    for (size_t k = 0; k < rights; k++) {
        chi_square_result r = chi_square_of(&right[k], n);
        check_at_least(r.p, alarm, "%s: samples follow the pdf", right[k].name);
        check_at_least(r.degrees, 50, "%s: enough bins", right[k].name);
        /* midpoint rule, 512 steps of z from -1 to 1: exact for constant pdfs, whose jumps lie on
         * borders of cells; the root z^1/2 is off by less than h^1.5 / 3 = 8e-5, the others by h^2
         * */
        check_close(r.integral, 1, 8e-5 + 100 * eps, "%s: pdf integrates to 1", right[k].name);
    }
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++)
        check_at_most(chi_square_of(&wrong[k], n).p, alarm, "%s: found out", wrong[k].name);
}

/* The normalised cube has the right second moment, 1/3, by its symmetry: a t-test passes it. */
static void test_cube(void)
{
    estimate square = {0};
    for (uint64_t i = 0; i < check_count(50000); i++) {
        random_stream s = random_start(3, 4, i);
        real u = random_next(&s), z = sample_sphere_naive(u, random_next(&s)).z;
        square = estimate_add(square, (double)(z * z));
    }
    check_at_least(t_test(square, 1.0 / 3, eps), alarm, "a cube's second moment");
}

/* The corners of the square and their neighbours: every sample usable, in its domain. */
static void test_corners(void)
{
    const real last = 1 - real_epsilon / 2, tiny = real_epsilon / 2;
    const real at[] = {0, tiny, real_epsilon, 0.25, (real)0.5 - real_epsilon, 0.5,
                       (real)0.5 + real_epsilon, 0.75, 1 - real_epsilon, last};
    enum { points = sizeof at / sizeof *at };
    for (size_t k = 0; k < rights; k++) {
        const trial *t = &right[k];
        double length = 0, smallest = 1;
        size_t bad = 0;
        for (int i = 0; i < points * points; i++) {
            vec3 w = t->sample(at[i % points], at[i / points], t->context);
            double pdf = (double)t->pdf(w, t->context), rr = (double)vdot(w, w);
            if (!vfinite(w) || !isfinite(pdf)) bad++;
            if (t->shape == none) length = check_worse(length, fabs(sqrt(rr) - 1));
            else if (t->shape == DOMAIN_DISK) length = check_worse(length, rr > 1 ? rr - 1 : 0);
            else {
                length = check_worse(length, fabs((double)(w.x + w.y + w.z) - 1));
                bad += w.x < 0 || w.y < 0 || w.z < 0;
            }
            smallest = pdf < smallest ? pdf : smallest;
        }
        check_equal(bad, 0, "%s: not finite, or outside", t->name);
        check_at_most(length, 4 * eps, "%s: length 1, in the disk, or sum 1", t->name);
        if (k < rights - firsts) check(smallest > 0, "%s: a sample of pdf %g", t->name, smallest);
    }
    /* the weight cos / pdf is pi even where both nearly vanish */
    for (int i = 0; i < points * points; i++) {
        vec3 w = sample_cosine(at[i % points], at[i / points]);
        check_close(w.z / pdf_cosine(w), pi, 8 * eps, "weight of a grazing direction");
    }
    check_equal(pdf_cosine((vec3){1, 0, 0}), 0, "nothing at the horizon");
    check_equal(pdf_lobe(3, (vec3){0, 0, -1}), 0, "nothing below it");
    check_equal(pdf_hemisphere((vec3){0, 0, -1}), 0, "nothing below it");
    check_equal(pdf_disk(vec(1, 0.1, 0)), 0, "nothing outside the disk");
    check_equal(pdf_cone(c_wide, vec(0.8, 0, 0.6)) > 0, 1, "53 degrees in 60");
    check_equal(pdf_cone(c_wide, (vec3){1, 0, 0}), 0, "90 degrees outside 60");
    check(pdf_cone(c_sun, (vec3){0, 0, 1}) > 1000, "a density may exceed 1");
}

/* On the rim of cones of any angle roundings go outwards, too: the pdf forgives them, and not more.
 * On that of the disk they hardly do. */
static void test_rims(void)
{
    size_t lost = 0, disk = 0, beyond = 0;
    for (uint64_t i = 0; i < check_count(200000); i++) {
        random_stream s = random_start(9, 0, i);
        real u = 1 - real_epsilon / 2 * (1 + floor(3 * random_next(&s))), v = random_next(&s);
        direction_cone c = {pow((real)10, -9 * random_next(&s))};
        lost += !(pdf_cone(c, sample_cone(c, u, v)) > 0);
        direction_cone wider = {c.half_sine2 * (1 + 64 * real_epsilon)};
        beyond += pdf_cone(c, sample_cone(wider, u, v)) > 0;
        vec3 rim[2] = {sample_disk(u, v), sample_disk(v, u)};
        for (int k = 0; k < 2; k++) disk += !(pdf_disk(rim[k]) > 0);
    }
    check_equal(lost, 0, "samples of a cone outside of it");
    check_equal(disk, 0, "samples of the disk outside of it");
    check_equal(beyond, 0, "a cone wider by 64 epsilon is another cone");
}

/* Against libm's, in a type of more digits. */
static void test_angle(void)
{
    long double worst = 0;
    for (uint64_t i = 0; i < check_count(100000); i++) {
        real x = i ? pi / 4 * (2 * random_real(10, 0, i, 0) - 1) : pi / 4, c, s;
        sample_angle(x, &c, &s);
        long double w = (long double)x, off = fabs((long double)c - cos(w));
        long double more = fabs(((long double)s - sin(w)) / w);
        worst = off > worst ? off : worst, worst = more > worst ? more : worst;
    }
    check_at_most((double)worst, (double)real_epsilon, "cosine and sine / x");
}

static double sine_of(real z) { return (double)sqrt(real_max(1 - z * z, 0)); }

/* sin of the angle of sample u: of a cone 2 sqrt(q (1-q)), q = u sin^2(angle/2), in double from the
 * angle itself; of a lobe by its first two terms, a = -log(1-u) / (n+1) being small. Naive: by z,
 * which loses the digits of 1 - z. */
static void test_narrow(void)
{
    double worst = 0, naive = 0, lobe = 0, lobe_naive = 0;
    for (uint64_t i = 0; i < check_count(20000); i++) {
        double angle = pow(10, -1 - 4 * random_double_of(random_bits(5, i, 0, 0)));
        real u = random_real(5, i, 1, 0), a = (real)angle, n = 1e6;
        double s = sin((double)a / 2), q = (double)u * s * s, sine = 2 * sqrt(q * (1 - q));
        worst = check_worse(worst,
                            fabs((double)sample_cone(cone_of_angle(a), u, 0).x / sine - 1));
        naive = check_worse(naive, fabs(sine_of(1 - u * (1 - cos(a))) / sine - 1));
        double l = -log1p(-(double)u) / ((double)n + 1);
        sine = sqrt(2 * l * (1 - l + 2 * l * l / 3));  /* of 1 - e^-2l; the next term: l^3 */
        lobe = check_worse(lobe, fabs((double)sample_lobe(n, u, 0).x / sine - 1));
        lobe_naive = check_worse(lobe_naive, fabs(sine_of(pow(1 - u, 1 / (n + 1))) / sine - 1));
    }
    check_at_most(worst, 8 * eps, "sine in a narrow cone");
    check_at_least(naive, 1e4 * eps, "sine in a narrow cone, naive");
    check_at_most(lobe, 8 * eps + 1e-14, "sine in a narrow lobe");
    check_at_least(lobe_naive, 1e4 * eps, "sine in a narrow lobe, naive");
    check(isinf(1 / (double)(1 - cosf(1e-4f))), "1 - cos of 1e-4 is 0 in float");
    /* a sphere of radius 1 at the distance d is seen under sin = 1/d */
    for (real d = 1; d < (real)1e6; d *= 3) {
        double s = asin(1 / (double)d) / 2, q = sin(s) * sin(s);
        check_close((double)cone_of_sphere(1, d).half_sine2 / q, 1, 8 * eps, "sphere at %g",
                    (double)d);
    }
    check_equal(cone_of_sphere(2, 2).half_sine2, (real)0.5, "on the sphere: half of all");
}

/* Neighbours in the square stay neighbours: the maps stretch by at most a factor. Disk: radius 2,
 * and the angle pi/2 each along and across, 2.97 together. Triangle: |d(u, v, 1-u-v)| <= 1.5 |(du,
 * dv)|. The root has an infinite slope at u = 0. */
static void test_stretch(void)
{
    double most[2] = {0};
    chi_square_sampler *map[2] = {s_sample_disk, s_sample_triangle};
    for (uint64_t i = 0; i < check_count(50000); i++) {
        random_stream s = random_start(6, 0, i);
        real h = 1e-3, u = random_next(&s), v = random_next(&s);
        real du = h * (2 * random_next(&s) - 1), dv = h * (2 * random_next(&s) - 1);
        real u1 = real_clamp(u + du, 0, 1 - real_epsilon);
        real v1 = real_clamp(v + dv, 0, 1 - real_epsilon);
        double step = (double)vlength((vec3){u1 - u, v1 - v, 0});
        for (int k = 0; k < 2 && step > 1e-4; k++) {
            vec3 d = vsub(map[k](u1, v1, NULL), map[k](u, v, NULL));
            most[k] = check_worse(most[k], (double)vlength(d) / step);
        }
    }
    double rounding = 8 * eps / 1e-4;
    check_at_most(most[0], 2.98 + rounding, "stretch of sample_disk");
    check_at_most(most[1], 1.5 + rounding, "stretch of sample_triangle");
}

static void test_triangles_and_frames(void)
{
    triangle t = {{1, 0, 0}, {0, 2, 0}, {0, 0, 3}};  /* area: |(6, 3, 2)| / 2 = 3.5 */
    check_close((double)pdf_triangle(t), 1 / 3.5, eps, "pdf of a triangle");
    check(isinf(pdf_triangle((triangle){{1, 1, 1}, {2, 2, 2}, {3, 3, 3}})), "no area: 1 / pdf = 0");
    vec3 p = triangle_at(t, 0.25, 0.25);
    check(p.x == (real)0.5 && p.y == (real)0.5 && p.z == (real)0.75, "barycentrics in a triangle");
    for (uint64_t i = 0; i < check_count(2000); i++) {
        random_stream s = random_start(7, 0, i);
        real u = random_next(&s), v = random_next(&s), x = random_next(&s), y = random_next(&s);
        vec3 n = sample_sphere(u, v), w = sample_sphere(x, y);
        vec3 d = directed(n, w);
        check_close(vdot(d, n), w.z, 8 * eps, "a turned direction keeps its angle with the normal");
        check_close(vlength(d), 1, 8 * eps, "and its length");
    }
}

/* ---- discrete.h ---- */

static void test_choose(void)
{
    enum { n = 7 };
    const real weight[n] = {0, 3, 0, 1, 0.5, 0, 0};
    const double share[n] = {0, 3 / 4.5, 0, 1 / 4.5, 0.5 / 4.5, 0, 0};
    double seen[n] = {0}, due[n], parts[3][20] = {{0}}, even[20];
    choice c;
    real p, rest;
    size_t samples = check_count(100000);
    check(choice_build(weight, n, &c), "weights can be chosen by");
    for (uint64_t i = 0; i < samples; i++) {
        size_t k = choice_sample(&c, random_real(8, i, 0, 0), &p, &rest);
        seen[k]++;
        check_close((double)p, share[k], eps, "probability returned");
        check_equal(p, choice_probability(&c, k), "probability asked for");
        if (k == 1) parts[0][(int)(20 * rest)]++;
    }
    for (int k = 0; k < n; k++) due[k] = share[k] * (double)samples;
    for (int k = 0; k < 20; k++) even[k] = seen[1] / 20;
    check_at_least(chi_square_test(seen, due, n).p, alarm, "things in proportion to their weights");
    check_at_least(chi_square_test(parts[0], even, 20).p, alarm, "the rest is uniform");
    check_equal(choice_sample(&c, 0, &p, &rest), 1, "u = 0 skips weight 0");
    check_equal(choice_sample(&c, 1 - real_epsilon / 2, &p, &rest), 4, "the largest u, too");
    check(rest < 1, "rest below 1");
    choice_free(&c), choice_free(&c);

    static const real bad[4][3] = {{0, 0, 0}, {1, -1, 2}, {1, (real)NAN, 2}, {1, real_infinity, 2}};
    for (int k = 0; k < 4; k++) {
        check(!choice_build(bad[k], 3, &c), "weights %d can't be chosen by", k);
        check(c.before == NULL, "and nothing is left to free");
    }
    check(!choice_build(bad[0], 0, &c), "nothing to choose from");

    /* extremes: weights that a plain sum forgets; one that is met by u = 0 alone; the least there
     * are, whose multiples round up to the whole */
    real lost[1001] = {1}, far[2] = {real_is_float ? (real)1e-37 : (real)1e-300,
                                     real_is_float ? (real)1e37 : (real)1e300};
    for (int k = 1; k <= 1000; k++) lost[k] = (real)0x1p-54;
    check(choice_build(lost, 1001, &c), "1 and a thousand times 2^-54");
    check_close(c.before[1001] - 1, 1000 * 0x1p-54, 0x1p-52, "none of them is lost");
    choice_free(&c);
    check(choice_build(far, 2, &c), "far apart");
    check_equal(choice_sample(&c, 0, &p, &rest), 0, "u = 0");
    check(p > 0, "p of the least probable one");
    choice_free(&c);
    real least[3] = {(real)ldexp(1.0, real_is_float ? -149 : -1074), 0, 0};
    check(choice_build(least, 3, &c), "the least weight there is");
    check_equal(choice_sample(&c, 0.75, &p, &rest), 0, "nothing of weight 0 is met");
    check(p == 1 && rest >= 0 && rest < 1, "and its p is 1");
    choice_free(&c);

    /* many equal weights: rounded sums end below the largest u */
    for (size_t m = 2; m <= 100; m++) {
        real equal[100];
        for (size_t k = 0; k < m; k++) equal[k] = 1 / (real)m;
        check(choice_build(equal, m, &c), "equal weights");
        check_equal(choice_sample(&c, 1 - real_epsilon / 2, &p, &rest), m - 1, "last of %zu", m);
        choice_free(&c);
    }
}

int main(void)
{
    c_wide = cone_of_angle(pi / 3), c_half = cone_of_angle(pi / 2), c_all = cone_of_angle(pi);
    c_wide.half_sine2 = 0.25, c_half.half_sine2 = 0.5, c_all.half_sine2 = 1;
    c_sun.half_sine2 = (real)0x1p-15;  /* 0.6 degrees; with focus 15 its side is at s = 1/2 */
    check_close((double)cone_of_angle(pi / 3).half_sine2, 0.25, 2 * eps, "60 degrees");
    return check_all("20_sampling", test_chi_square, test_cube, test_corners, test_rims,
                     test_angle, test_narrow, test_stretch, test_triangles_and_frames, test_choose);
}
