/* Tests of 23_brdf: reciprocity, energy, samples against pdfs, extreme parameters, closed forms,
 * and the naive formulas failing. Fixed seeds; each random test alarms falsely once in 1e8
 * seeds. */
#include "../chapters/23_brdf/lab/brdf_naive.h"
#include "../chapters/23_brdf/lab/reference.h"
#include "../common/lab/chi_square.h"
#include "../common/lab/t_test.h"
#include "check.h"

#define alarm 1e-8
#define eps ((double)real_epsilon)
static const vec3 white = {1, 1, 1}, black = {0, 0, 0}, up = {0, 0, 1};

static vec3 at_angle(double cosine, double turn)
{
    double s = sqrt((1 - cosine) * (1 + cosine));
    return vec((s * cos(turn)), (s * sin(turn)), cosine);
}

static vec3 some_unit(uint64_t i, uint64_t which)
{
    return sample_hemisphere(random_real(5, i, which, 0), random_real(5, i, which, 1));
}

enum { specimens = 12 };
static brdf specimen(int i)
{
    vec3 half = {0.5, 0.5, 0.5}, f0 = {1.0, 0.7, 0.3};
    static const double roughness[6] = {1, 0.7, 0.5, 0.3, 0.2, 0.1};
    static const double exponent[5] = {0, 1, 10, 100, 1000};
    if (i == 0) return brdf_lambert(half);
    if (i <= 6) return brdf_ggx(f0, (real)roughness[i - 1]);
    return brdf_blinn_phong(i % 2 ? black : half, half, (real)exponent[i - 7]);
}

/* ---- (23.3) reciprocity: f(wi, wo) = f(wo, wi) but for the order of a few operations ---- */

static void test_reciprocity(void)
{
    double worst = 0;
    for (int i = 0; i < specimens; i++)
        for (uint64_t k = 0; k < check_count(2000); k++) {
            brdf b = specimen(i);
            vec3 wi = some_unit(k, 0), wo = some_unit(k, 1);
            double f = (double)brdf_value_local(&b, wi, wo).x;
            double g = (double)brdf_value_local(&b, wo, wi).x;
            worst = check_worse(worst, fabs(f - g) / (f + 1e-30));
        }
    check_at_most(worst, 16 * eps, "reciprocity");
    /* in the world, about any normal: the frame's rounding, times how steep the lobe is */
    brdf b = specimen(2);
    vec3 n = vunit(vec(0.3, -0.7, -0.6));
    vec3 wi = directed(n, some_unit(1, 0)), wo = directed(n, some_unit(1, 1));
    double local = (double)brdf_value_local(&b, some_unit(1, 0), some_unit(1, 1)).x;
    check_close(brdf_value(&b, n, wi, wo).x / (real)local, 1, 200 * eps, "any normal");
    check_close(brdf_value(&b, n, wo, wi).x / (real)local, 1, 200 * eps, "any normal, reversed");
    check_close((double)brdf_pdf(&b, n, wi, wo)
                    / (double)brdf_pdf_local(&b, some_unit(1, 0), some_unit(1, 1)),
                1, 200 * eps, "pdf, any normal");
}

/* ---- albedo by the midpoint rule over z and turn: shares nothing with the samplers ---- */

typedef double value_function(const void *context, vec3 wi, vec3 wo);

static double quadrature(value_function *f, const void *context, vec3 wo, int k)
{
    double sum = 0;
    for (int i = 0; i < k; i++)
        for (int j = 0; j < k; j++) {
            vec3 wi = at_angle((i + 0.5) / k, 2 * (double)pi * (j + 0.5) / k);
            sum += f(context, wi, wo) * (double)wi.z;
        }
    return sum * 2 * (double)pi / k / k;
}

static double value_of(const void *b, vec3 wi, vec3 wo)
{
    return (double)brdf_value_local(b, wi, wo).x;
}
static double phong_of(const void *e, vec3 wi, vec3 wo)
{
    return (double)phong_naive(*(const real *)e, wi, wo);
}
static double ggx_naive_of(const void *a, vec3 wi, vec3 wo)
{
    return (double)ggx_value_naive(*(const real *)a, wi, wo);
}

static void test_closed_forms(void)
{
    brdf lambert = brdf_lambert(vec(0.25, 0.5, 1));
    vec3 wo = at_angle(0.4, 1);
    check_close(brdf_value_local(&lambert, up, wo).x, 0.25 / 3.14159265358979324, eps, "rho / pi");
    /* the midpoint rule is exact for f cos, which is linear in z */
    check_close(quadrature(value_of, &lambert, wo, 16), 0.25, 64 * eps, "albedo = rho");
    check_equal(brdf_albedo(&lambert, 0.4).x, (real)0.25, "brdf_albedo, Lambert");

    /* Blinn-Phong head-on: albedo 1 by (23.14). Midpoint error: O(e / k)^2 */
    static const double exponent[] = {0, 0.5, 1, 5, 20, 60};
    for (int i = 0; i < 6; i++) {
        brdf b = brdf_blinn_phong(black, white, (real)exponent[i]);
        check_close(quadrature(value_of, &b, up, 250), 1, 2e-4, "Blinn-Phong, e = %g", exponent[i]);
    }
    brdf zero = brdf_blinn_phong(black, white, 0);
    check_close(brdf_value_local(&zero, wo, up).x, 1 / (double)pi, 2 * eps, "e = 0 is Lambert's");

    /* GGX: the facets' projected area is 1, D z = 1 / pi at alpha 1; from all sides */
    vec3 m = at_angle(0.3, 2);
    check_close(ggx_d(1, m), 1 / (double)pi, 4 * eps, "alpha = 1: D is constant");
    check_close(ggx_d(0.1, up), 100 / (double)pi, 1000 * eps, "D(n) = 1 / (pi a^2)");
    /* wi = wo = n: F0 D(n) / 4, nothing hidden */
    brdf gold = brdf_ggx(vec(1, 0.5, 0.25), sqrt((real)0.5));
    check_close(brdf_value_local(&gold, up, up).y, 0.5 * 4 / (double)pi / 4, 16 * eps, "f(n, n)");
    check_at_least(brdf_value_local(&gold, up, up).x * pi * 2, 1, "a density, no fraction");
    brdf sharp = brdf_ggx(white, 0.3);
    check_at_least(brdf_value_local(&sharp, up, up).x, 5, "f = 9.8 / sr: no fraction");
    check_close(fresnel_schlick(vec(0.04, 0, 1), 0).x, 1, eps, "Schlick, grazing");
    check_close(fresnel_schlick(vec(0.04, 0, 1), 1).x, 0.04, eps, "Schlick, head-on");
    check_close(fresnel_schlick(vec(0.04, 0, 1), 0.5).x, 0.07, eps, "f0 + .96 / 32");
    check(vzero(fresnel_schlick(black, 0)), "no boundary, no reflection");
    check_equal(fresnel_schlick((vec3){1, 1, 1}, -0.5).x, 1, "a cosine out of range");

    /* back to where it came from: m = wi = wo, so F = F0 at all angles. alpha 1/2, z = .6: the
     * bracket of D is .64 / .25 + .36 = 2.92, S^2 = .36 + .64 / 4 = .52, f = F0 D / (4 z S) */
    vec3 back = at_angle(0.6, 1);
    double d = 1 / ((double)pi * 0.25 * 2.92 * 2.92);
    double due = 0.5 * d / (4 * 0.6 * sqrt(0.52));
    check_close((double)brdf_value_local(&gold, back, back).y / due, 1, 8 * eps, "back: F0");
    brdf glass = brdf_mirror(vec(0.04, 0.04, 0.04));
    vec3 out, weight;
    real pdf;
    check(brdf_sample_local(&glass, at_angle(0.5, 1), 0, 0, &out, &pdf, &weight), "a mirror");
    check_close(weight.x, 0.07, 2 * eps, "Fresnel of a mirror at 60 degrees: .04 + .96 / 32");
    check_close(brdf_albedo(&glass, 0.5).x, 0.07, 2 * eps, "and its albedo");
    check_equal(brdf_albedo(&lambert, 0).x, 0, "seen from the horizon: nothing");

    /* tan = 2 at alpha 1/2: S = z sqrt(1 + 1) */
    vec3 w = at_angle(1 / sqrt(5.0), 0.5);
    check_close(ggx_g1(0.5, w), 2 / (1 + sqrt(2.0)), 8 * eps, "G1, closed form");
    check_close(ggx_g2(0.5, w, w), 1 / sqrt(2.0), 8 * eps, "G2 = 1 / (1 + 2 Lambda)");
}

/* ---- (23.4) energy ---- */

static vec3 white_light(vec3 wi) { (void)wi; return white; }

static void test_energy(void)
{
    for (int r = 0; r <= 10; r++) {
        brdf b = brdf_ggx(white, (real)r / 10);
        for (int i = 0; i <= 10; i += 2) {
            double cosine = i == 0 ? 1e-3 : i / 10.0, a = (double)brdf_albedo(&b, (real)cosine).x;
            check_at_most(a, 1 + 100 * eps, "GGX, roughness %g, cos %g: energy", r / 10.0, cosine);
            check_at_least(a, 0.3, "and 1 - ln 2 of it at the least");
            if (r == 0) check_close(a, 1, 4 * eps, "a mirror keeps all");
        }
    }
    for (int e = 0; e <= 12; e++) {
        brdf b = brdf_blinn_phong(black, white, e ? (real)pow(4, e - 3) : 0);
        for (int i = 2; i <= 10; i += 4)
            check_at_most((double)brdf_albedo(&b, (real)i / 10).x, 1.0002,
                          "Blinn-Phong %d: energy", e);
    }
    /* brdf_albedo is within 2e-4. By quadrature that knows no sampler, cells of 1/300 against lobes
     * of some 0.1; GGX below */
    for (int i = 0; i < specimens; i++) {
        brdf b = specimen(i);
        if (b.kind == BRDF_GGX || b.exponent > 20) continue;
        for (int k = 1; k <= 5; k++) {
            double cosine = k / 5.0, a = quadrature(value_of, &b, at_angle(cosine, 0.3), 300);
            check_close(brdf_albedo(&b, (real)cosine).x, a, 2e-4, "albedo %d, cos %g", i, cosine);
        }
    }
    /* GGX over half vectors, sharp lobes, too: reflection.h, which test_reference judges */
    static const double roughness[] = {0.05, 0.2, 0.3, 0.5, 1}, cosine[] = {1, 0.7, 0.4, 0.1};
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 4; k++) {
            brdf b = brdf_ggx(white, (real)roughness[i]);
            double a = (double)reflection_reference(&b, up, at_angle(cosine[k], 0), white_light).x;
            check_close(brdf_albedo(&b, (real)cosine[k]).x, a, 2e-4, "albedo, roughness %g, cos %g",
                        roughness[i], cosine[k]);
        }
    /* alpha = 1 head-on: D = 1/pi, S = 1, f zi = zi / (2 pi (1 + zi)), so the albedo is
     * integral from 0 to 1 of z / (1 + z) dz = 1 - ln 2: more than two thirds are lost */
    brdf rough = brdf_ggx(white, 1);
    check_close(brdf_albedo(&rough, 1).x, 1 - log(2.0), 1e-6, "alpha = 1, head-on: 1 - ln 2");
}

/* ---- samples against pdf ---- */

typedef struct { brdf b; vec3 n, wo; int naive; } sampled;

static vec3 sample_of(real u, real v, const void *context)
{
    const sampled *s = context;
    vec3 wi = {0, 0, 0}, weight;
    real pdf;
    if (!brdf_sample(&s->b, s->n, s->wo, u, v, &wi, &pdf, &weight)) return (vec3){0, 0, 0};
    return wi;
}

static real pdf_of(vec3 w, const void *context)
{
    const sampled *s = context;
    if (s->naive) return w.z > 0 ? blinn_phong_pdf_naive(s->b.exponent, w, s->wo) : 0;
    return brdf_pdf(&s->b, s->n, w, s->wo);
}

static void test_sampling(void)
{
    size_t n = check_count(40000);
    for (int i = 0; i < specimens; i++) {
        brdf b = specimen(i);
        if ((b.kind == BRDF_GGX && b.alpha < (real)0.08) || b.exponent > 20) continue;
        for (int k = 0; k < 3; k++) {
            static const double cosine[] = {1, 0.6, 0.2};
            sampled s = {b, up, at_angle(cosine[k], 0.7), 0};
            chi_square_result r = chi_square_directions(sample_of, pdf_of, &s, 1, 3, n);
            check_at_least(r.p, alarm, "specimen %d, cos %g: samples follow the pdf", i, cosine[k]);
            check_at_most(r.integral, 1.003, "pdf integrates to 1, less what is rejected");
        }
    }
    /* sharp lobes: seen by cells that grow finer towards +z, which is where wo = n reflects to */
    brdf sharp[] = {specimen(5), specimen(6), specimen(10), specimen(11),
                    brdf_ggx(white, 0.05)};
    static const double focus[] = {3, 6, 3, 3, 8};
    for (int i = 0; i < 5; i++) {
        sampled s = {sharp[i], up, up, 0};
        chi_square_result r = chi_square_directions(sample_of, pdf_of, &s, focus[i], 4, n);
        check_at_least(r.p, alarm, "sharp lobe %d: samples follow the pdf", i);
        check_close(r.integral, 1, 0.003, "sharp lobe %d: integral", i);
    }
    /* about another normal: the same lobe, turned */
    vec3 side = vunit(vec(1, -0.5, -0.3));
    sampled turned = {specimen(2), side, directed(side, at_angle(0.5, 1)), 0};
    check_at_least(chi_square_directions(sample_of, pdf_of, &turned, 1, 5, n).p, alarm, "turned");
    /* without the 1 / (4 wo.h): found out at once, and its integral is not 1 */
    sampled naive = {brdf_blinn_phong(black, white, 10), up, at_angle(0.6, 0.7), 1};
    chi_square_result r = chi_square_directions(sample_of, pdf_of, &naive, 1, 6, n);
    check_at_most(r.p, alarm, "half-vector pdf: refuted");
    check_at_least(r.integral, 1.5, "half-vector pdf: integral");
}

/* weight = f cos / pdf, and what bounds it. */
static void test_weights(void)
{
    double worst = 0, off = 0;
    for (int i = 0; i < specimens; i++) {
        brdf b = specimen(i);
        double e = (double)b.exponent;
        double bound = (e + 2) * (e + 4) / ((e + exp2(-e / 2)) * (e + 1));             /* (23.16) */
        for (uint64_t k = 0; k < check_count(3000); k++) {
            vec3 wo = some_unit(k, 7), wi, weight;
            real u = random_real(6, k, 0, 0), v = random_real(6, k, 0, 1), pdf;
            if (!brdf_sample_local(&b, wo, u, v, &wi, &pdf, &weight)) continue;
            vec3 f = brdf_value_local(&b, wi, wo);
            double again = (double)f.x * (double)wi.z / (double)pdf, w = (double)weight.x;
            off = check_worse(off, fabs(again - w) / w);
            off = check_worse(off, fabs((double)(f.z * wi.z / (pdf * weight.z)) - 1));
            off = check_worse(off, fabs((double)brdf_pdf_local(&b, wi, wo) / (double)pdf - 1));
            if (b.kind == BRDF_LAMBERT) bound = 0.5;
            if (b.kind == BRDF_GGX) bound = 1;
            /* both lobes: (fd + fs) / (p pd + (1-p) ps), at most the larger of fd / (p pd) and
             * fs / ((1-p) ps) */
            if (b.kind == BRDF_BLINN_PHONG) worst = check_worse(worst, w - bound - 1e-3);
            else worst = check_worse(worst, w - bound * (1 + 16 * eps));
        }
    }
    check_at_most(worst, 0, "weights are bounded");
    /* the lobe's steepness times rounding; alpha = .01, and grazing half vectors */
    check_at_most(off, 2e4 * eps, "weight = f cos / pdf, and pdf is brdf_pdf");
}

/* ---- t-tests: estimates with a known answer ---- */

static vec3 overhead(vec3 wi) { return vscale(white, wi.z > 0 ? wi.z : 0); }
static vec3 bright_side(vec3 wi) { return wi.x > 0 ? white : black; }

static void test_estimates(void)
{
    /* (1/pi) integral cos^2 = 2/3; the others: albedos in closed form, or half of one */
    const struct { brdf b; vec3 wo; incident_light *light; double due; const char *what; } of[] = {
        {brdf_lambert(white), at_angle(0.5, 0), overhead, 2.0 / 3, "Lambert"},
        {brdf_ggx(white, 1), up, white_light, 1 - log(2.0), "GGX"},
        {brdf_blinn_phong(black, white, 20), up, white_light, 1, "Blinn-Phong"},
        {brdf_ggx(white, 1), up, bright_side, (1 - log(2.0)) / 2, "half"},
        {specimen(8), up, white_light, 1, "1/2 matte, 1/2 gloss"}};
    for (int i = 0; i < 15; i++) {
        int j = i % 5, c = i / 5;
        estimate e = {0};
        for (uint64_t k = 0; k < check_count(2000); k++) {
            reflection r = {(direction_choice)c, false, 0};
            vec3 x = reflection_estimate(&r, &of[j].b, up, of[j].wo, of[j].light,
                                         SEQUENCE_RANDOM, (uint64_t)j + 1, k, 16);
            e = estimate_add(e, (double)x.x);
        }
        check_at_least(t_test(e, of[j].due, 64 * eps), alarm, "choice %d: %s", c, of[j].what);
    }
}

/* The reference of the tables, by the half vectors, against the plain midpoint rule. */
static void test_reference(void)
{
    vec3 wo = at_angle(0.7, 0);
    for (int i = 1; i <= 3; i++) {
        brdf b = brdf_ggx(white, 1 - (real)i / 8);
        reflection r = {DIRECTIONS_UNIFORM, false, 0};
        double grid = (double)reflection_grid(&r, &b, up, wo, overhead, 500).x;
        check_equal(r.asked, 500 * 500, "the grid asks for each of its directions");
        double half = (double)reflection_reference(&b, up, wo, overhead).x;
        check_close(half, grid, 1e-5 + 1000 * eps, "reference, roughness %g", 1 - i / 8.0);
    }
}

/* ---- extremes ---- */

static void test_extremes(void)
{
    static const double roughness[] = {0, 1e-30, 1e-9, 1e-5, 2e-4, 1e-3, 0.02, 0.1, 1, 7, -1};
    double cosines[] = {1, 0.5, 1e-3, 1e-8, eps, 2 * eps * eps, 1e-30, 0};
    double numbers[] = {0, 1e-12, 0.5, 1 - eps / 2};
    bool finite = true, unit = true, above = true;
    for (int i = 0; i < 11 + 8; i++)
        for (int a = 0; a < 8; a++) {
            brdf b = i < 11 ? brdf_ggx(white, (real)roughness[i])
                            : brdf_blinn_phong(i % 2 ? white : black, white, (real)pow(10, i - 11));
            vec3 wo = at_angle(cosines[a], 0), wi, weight;
            for (int c = 0; c < 16; c++) {
                real pdf, x = brdf_value_local(&b, at_angle(cosines[c / 2], 3), wo).x;
                finite &= isfinite(x) && x >= 0;
                x = brdf_pdf_local(&b, at_angle(cosines[c / 2], 3), wo);
                finite &= isfinite(x) && x >= 0;
                if (!brdf_sample_local(&b, wo, (real)numbers[c / 4], (real)numbers[c % 4], &wi,
                                       &pdf, &weight)) continue;
                finite &= vfinite(weight) && pdf > 0 && (isfinite(pdf) || brdf_is_delta(&b));
                unit &= fabs(vlength(wi) - 1) < 8 * real_epsilon;
                above &= !brdf_behind(wi);
            }
        }
    check(finite, "values, pdfs and weights are finite");
    check(unit, "samples have unit length");
    check(above, "samples are above the surface");

    /* a sharp highlight seen at a grazing angle: wo.h as a product rounds to below 0, and so would
     * the pdf and the weight */
    brdf needle = brdf_blinn_phong(black, white, 1 / real_epsilon);
    bool positive = true;
    int kept = 0;
    for (uint64_t k = 0; k < check_count(20000); k++) {
        vec3 w, weight;
        vec3 low = at_angle(pow(10, -4 - 8 * (double)random_real(11, k, 0, 2)), (double)k);
        real pdf, u = random_real(11, k, 0, 0), v = random_real(11, k, 0, 1);
        if (!brdf_sample_local(&needle, low, u, v, &w, &pdf, &weight)) continue;
        positive &= pdf > 0 && weight.x >= 0 && isfinite(pdf) && vfinite(weight);
        positive &= brdf_pdf_local(&needle, w, low) >= 0;
        kept++;
    }
    check(positive, "grazing, sharp: pdf > 0, weight >= 0");
    check_at_least(kept, (double)check_count(20000) / 10, "and there were such samples");

    brdf smooth = brdf_ggx(white, 0);
    check(brdf_is_delta(&smooth), "roughness 0 is a mirror");
    brdf hair = brdf_ggx(white, sqrt(sqrt(real_epsilon) / 2));
    check(brdf_is_delta(&hair), "alpha below the root of epsilon, too");
    brdf below = brdf_ggx(white, -1), beyond = brdf_ggx(white, 7);
    check(brdf_is_delta(&below) && beyond.alpha == 1, "roughness is clamped to [0,1]");
    brdf blunt = brdf_blinn_phong(black, white, -3);
    brdf sharpest = brdf_blinn_phong(black, white, 1e30);
    check(blunt.exponent == 0 && sharpest.exponent == 1 / real_epsilon, "and exponents");
    brdf nan = brdf_ggx(white, (real)NAN);
    check(brdf_is_delta(&nan), "roughness NaN is taken for 0");
    /* just above the mirror: each sample is next to the mirror's, and weighs the same */
    brdf almost = brdf_ggx(white, (real)1.01 * sqrt(ggx_least_alpha));
    check(!brdf_is_delta(&almost), "still a lobe");
    vec3 wo = at_angle(0.6, 1), wi, weight;
    real pdf;
    double far = 0, light = 0;
    for (uint64_t k = 0; k < 1000; k++) {
        real u = random_real(8, k, 0, 0) * (real)0.99, v = random_real(8, k, 0, 1) * (real)0.99;
        if (!brdf_sample_local(&almost, wo, u, v, &wi, &pdf, &weight)) far = 1;
        far = check_worse(far, (double)vlength(vsub(wi, mirrored(wo, up))));
        light = check_worse(light, fabs((double)weight.x - 1));
    }
    check_at_most(far, 100 * sqrt(eps), "the lobe closes around the mirror's direction");
    check_at_most(light, 16 * eps, "and loses nothing");

    /* the mirror itself: exact direction, weight F0 head-on, no value anywhere */
    brdf silver = brdf_mirror(vec(0.9, 0.5, 0.25));
    check(brdf_sample_local(&silver, up, 0, 0, &wi, &pdf, &weight) && vzero(vsub(wi, up)), "back");
    check_equal(weight.x, (real)0.9, "F0 head-on");
    check(isinf(pdf), "a delta");
    check(vzero(brdf_value_local(&silver, up, up)), "no value, even in the mirror's direction");
    check_equal(brdf_pdf_local(&silver, up, up), 0, "no pdf");
}

/* Behind the surface, on the horizon, NaN, and black: 0, and no sample. */
static void test_nothing(void)
{
    vec3 below = at_angle(-0.5, 1), side = {1, 0, 0}, above = at_angle(0.5, 2);
    vec3 nan = {(real)NAN, (real)NAN, (real)NAN};
    vec3 bad[] = {below, side, nan, vneg(up)};
    for (int i = 0; i <= specimens; i++) {
        brdf b = i < specimens ? specimen(i) : brdf_mirror(white);
        for (int k = 0; k < 4; k++) {
            vec3 wi = {7, 7, 7}, weight = wi;
            real pdf = 7;
            check(vzero(brdf_value_local(&b, bad[k], above)), "light from behind");
            check(vzero(brdf_value_local(&b, above, bad[k])), "seen from behind");
            check(vzero(brdf_value(&b, vneg(up), above, vneg(bad[k]))), "the other side");
            check_equal(brdf_pdf_local(&b, bad[k], above), 0, "pdf behind");
            check_equal(brdf_pdf_local(&b, above, bad[k]), 0, "pdf from behind");
            check(!brdf_sample_local(&b, bad[k], 0.5, 0.5, &wi, &pdf, &weight),
                  "no sample from behind");
            check(wi.x == 7 && pdf == 7 && weight.x == 7, "and nothing is written");
        }
    }
    check(brdf_behind((vec3){1, 0, real_epsilon * real_epsilon / 2}), "epsilon^2 / 2 is rounding");
    check(!brdf_behind((vec3){1, 0, real_epsilon * real_epsilon * 2}), "2 epsilon^2 is not");
    brdf matte = brdf_lambert(white);
    vec3 w = {7, 7, 7}, unused;
    real none;
    check(!brdf_sample_local(&matte, above, 0, 0.5, &w, &none, &unused) && w.x == 7,
          "the rim of the square is the horizon: no sample");
    brdf dark[] = {brdf_lambert(black), brdf_ggx(black, 0.5), brdf_mirror(black),
                   brdf_blinn_phong(black, black, 10)};
    for (int i = 0; i < 4; i++) {
        vec3 wi, weight;
        real pdf;
        check(!brdf_sample_local(&dark[i], above, 0.5, 0.5, &wi, &pdf, &weight),
              "black: no sample");
        check(vzero(brdf_value_local(&dark[i], up, up)), "black: no value");
        check_equal(brdf_pdf_local(&dark[i], up, up), 0, "black: no pdf");
        check_equal(brdf_albedo(&dark[i], 1).x, 0, "black: albedo");
    }
}

/* Only what is called for. */
static vec3 light_above(vec3 wi) { return wi.z > 0 ? white : black; }

static void test_only_what_is_called_for(void)
{
    /* highlight black: the samples are the matte ones, bit for bit, and none goes to the lobe */
    brdf matte = brdf_lambert(vec(0.5, 0.5, 0.5));
    brdf dull = brdf_blinn_phong(matte.diffuse, black, 50), glow = specimen(7);
    vec3 wo = at_angle(0.5, 0), a, b, weight;
    real pdf, q;
    for (uint64_t k = 0; k < 1000; k++) {
        real u = random_real(9, k, 0, 0), v = random_real(9, k, 0, 1);
        bool one = brdf_sample_local(&matte, wo, u, v, &a, &pdf, &weight);
        bool two = brdf_sample_local(&dull, wo, u, v, &b, &q, &weight);
        if (one != two || a.x != b.x || a.y != b.y || a.z != b.z || pdf != q) {
            check(false, "black highlight: %d", (int)k);
            break;
        }
    }
    check_equal(dull.kind, BRDF_LAMBERT, "black highlight: matte, no highlight is computed");
    check_equal(glow.chance, 1, "black ground: always the highlight");
    /* directions that cannot contribute are not asked for, and asking changes nothing */
    brdf kinds[] = {specimen(1), specimen(7), brdf_mirror(white), brdf_lambert(black)};
    for (int i = 0; i < 4; i++)
        for (int c = 0; c < 3; c++) {
            reflection thrifty = {(direction_choice)c, false, 0}, lavish = thrifty;
            lavish.ask_all = true;
            vec3 grazing = at_angle(0.1, 0);
            vec3 x = reflection_estimate(&thrifty, &kinds[i], up, grazing, light_above,
                                         SEQUENCE_RANDOM, 1, 2, 1000);
            vec3 y = reflection_estimate(&lavish, &kinds[i], up, grazing, light_above,
                                         SEQUENCE_RANDOM, 1, 2, 1000);
            check(x.x == y.x && x.y == y.y && x.z == y.z, "kind %d, choice %d: the same", i, c);
            check_equal(lavish.asked, 1000, "all asked");
            if (i >= 2 && c < DIRECTIONS_BRDF) check_equal(thrifty.asked, 0, "mirror, black: none");
            if (i == 3) check_equal(thrifty.asked, 0, "black: none");
            if (i == 1 && c == DIRECTIONS_BRDF) check_at_most(thrifty.asked, 900, "below: none");
            /* roughness 1: wi is uniform above z = -wo.z, so 1 / (1 + wo.z) of it is above z = 0;
             * 6 sigma */
            if (i == 0 && c == DIRECTIONS_BRDF)
                check_close(thrifty.asked, 1000 / 1.1, 6 * sqrt(1000 * 0.1) / 1.1, "below: none");
        }
}

/* ---- the naive ones ---- */

static void test_naive(void)
{
    static const double exponent[] = {1, 2, 4, 10};
    for (int i = 0; i < 4; i++) {
        real e = (real)exponent[i];
        double albedo = quadrature(phong_of, &e, up, 300);
        double exact = 2 * (double)pi / (exponent[i] + 2);
        check_close(albedo, exact, 2e-4, "Phong, e = %g: 2 pi / (e + 2)", exponent[i]);
        check(exponent[i] > 4.28 || albedo > 1, "Phong: makes light of nothing");
    }
    real a = 0.5;
    brdf b = brdf_ggx(white, sqrt(a));
    check_at_least(quadrature(ggx_naive_of, &a, at_angle(0.1, 0), 300), 1.5, "no Smith, grazing");
    check_at_least(quadrature(ggx_naive_of, &a, at_angle(0.001, 0), 300), 50, "no Smith: no limit");
    check_at_most(quadrature(value_of, &b, at_angle(0.1, 0), 300), 1, "Smith: energy");
    /* it is D / (4 zi zo) times G2, nothing else */
    vec3 wi = at_angle(0.3, 2), wo = at_angle(0.8, 0);
    double g = (double)(ggx_value_naive(a, wi, wo) * ggx_g2(a, wi, wo));
    check_close(value_of(&b, wi, wo) / g, 1, 32 * eps, "f = D G2 / (4 zi zo)");

    real tiny = sqrt(real_epsilon) / 4;
    check(isinf(ggx_d_naive(tiny, up)), "textbook D, a^2 < epsilon: infinite");
    check_close(ggx_d(tiny, up) * pi * tiny * tiny, 1, 4 * eps, "D(n) = 1 / (pi a^2)");
    check(isinf(ggx_d_naive_f32(1e-4f, 1)), "textbook D in float, alpha = 1e-4: infinite");
    check_close((double)ggx_d_naive_f32(1e-3f, 1) * (double)pi * 1e-6, 0.974, 1e-3,
                "textbook D in float, alpha = 1e-3: off by 2.6 %%");
    /* halfway down its own lobe: tan = a, k = 2 z^2, D = 1 / (4 pi a^2 z^4) */
    real s = (real)13.7 * sqrt(real_epsilon), z = 1 / sqrt(1 + s * s);
    vec3 m = {s * z, 0, z};
    double due = 1 / (4 * (double)(pi * s * s * z * z * z * z));
    check_close((double)ggx_d(s, m) / due, 1, 32 * eps, "D at tan = alpha");
    check_at_least(fabs((double)ggx_d_naive(s, m) / due - 1), 1e-4, "textbook D: off");

    /* both branches of blinn_phong_power where they meet */
    vec3 h1 = at_angle(0.5 + 4 * eps, 0), h0 = at_angle(0.5, 0);
    check_close(blinn_phong_power(3, h1), blinn_phong_power(3, h0), 32 * eps, "branches meet");
}

int main(void)
{
    return check_all("23_brdf", test_reciprocity, test_closed_forms, test_energy, test_sampling,
                     test_weights, test_estimates, test_reference, test_extremes, test_nothing,
                     test_only_what_is_called_for, test_naive);
}
