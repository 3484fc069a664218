/* 23_brdf: rough glass: reciprocity between two media, energy, samples against the pdf, and the
 * limit of smooth glass (19). Fixed seeds; each random test alarms falsely once in 1e8 seeds. */
#include "../common/lab/t_test.h"
#include "../chapters/23_brdf/rough_glass.h"
#include "../common/lab/chi_square.h"
#include "check.h"

#define alarm 1e-8
#define eps ((double)real_epsilon)

static vec3 at_angle(double cosine, double turn)
{
    double s = sqrt((1 - cosine) * (1 + cosine));
    return vec((s * cos(turn)), (s * sin(turn)), cosine);
}

static vec3 random_direction(uint64_t i, uint64_t which, bool below)
{
    vec3 w = sample_hemisphere(random_real(5, i, which, 0), random_real(5, i, which, 1));
    if (below) w.z = -w.z;
    return w;
}

/* The same surface from the other side. */
static rough_glass turned(rough_glass g) { return (rough_glass){g.alpha, g.n2, g.n1}; }

enum { glasses = 8 };
static rough_glass specimen(int i)
{
    static const double alpha[glasses] = {1, 0.5, 0.3, 0.1, 1, 0.5, 0.3, 0.1};
    rough_glass g = {(real)alpha[i], 1, (real)1.5};
    return i < 4 ? g : turned(g);
}

static bool draw(const rough_glass *g, vec3 wo, uint64_t i, vec3 *wi, real *weight)
{
    return rough_glass_sample(g, wo, random_real(6, i, 0, 0), random_real(6, i, 0, 1),
                              random_real(6, i, 0, 2), wi, weight);
}

/* f(wi, wo) / n1^2 = f(wo, wi) / n2^2 through the surface, f = f above it. Towards the critical
 * angle 1 - F goes to 0 with the smaller cosine c, and its digits with c^2. */
static void test_reciprocity(void)
{
    double worst = 0;
    size_t some = 0;
    for (int i = 0; i < glasses; i++)
        for (uint64_t k = 0; k < check_count(4000); k++) {
            rough_glass g = specimen(i), back = turned(g);
            bool through = k % 2;
            vec3 wo = random_direction(k, 0, false), wi = random_direction(k, 1, through), m;
            double f = (double)rough_glass_value(&g, wi, wo) / (double)(g.n1 * g.n1), other, c = 1;
            if (through) {  /* seen from below: turned over */
                vec3 a = {wo.x, wo.y, -wo.z}, b = {wi.x, wi.y, -wi.z};
                other = (double)rough_glass_value(&back, a, b) / (double)(g.n2 * g.n2);
            } else other = (double)rough_glass_value(&g, wo, wi) / (double)(g.n1 * g.n1);
            some += f > 0 && through;
            real J;
            snell s;
            if (rough_glass_facet(&g, wi, wo, &m, &J) && rough_glass_fresnel(&g, wo, m, &s) < 1)
                c = (double)real_min(s.ci, s.ct);
            worst = check_worse(worst, fabs(f - other) / (f + other + 1e-3) * c * c);
        }
    check_at_most(worst, 16 * eps, "reciprocity");
    check(some > 100, "some of them are seen through");
}

/* ---- samples ---- */

typedef struct { rough_glass g; vec3 wo; bool wrong; } asked;

/* The third number: what is left of u, once 2^10 of it are used. */
static vec3 sample_of(real u, real v, const void *context)
{
    const asked *a = context;
    vec3 wi = {0, 0, 0};
    real weight, part = u * 1024, whole = floor(part);
    u = (whole + (real)0.5) / 1024;
    if (!rough_glass_sample(&a->g, a->wo, u, v, part - whole, &wi, &weight))
        return (vec3){0, 0, 0};
    return wi;
}

/* And a millionth everywhere: at the edge of total reflection a cell may be cut so that no point of
 * the quadrature meets what is left of it, but one sample in a million does. */
static real pdf_of(vec3 w, const void *context)
{
    const asked *a = context;
    real p = rough_glass_pdf(&a->g, w, a->wo) + (real)1e-6;
    if (a->wrong && w.z < 0) {  /* the half vector's, as reflection has it */
        vec3 m;
        real J;
        if (rough_glass_facet(&a->g, w, a->wo, &m, &J)) p *= 1 / (4 * vdot(a->wo, m) * J);
    }
    return p;
}

/* Wide lobes only: the cells must see them. The pdf integrates to 1 less what goes to the wrong
 * side, which the test counts. Without J it is refuted. */
static void test_sampling(void)
{
    static const double cosine[3] = {1, 0.7, 0.2};
    static const int smooth[4] = {0, 1, 4, 5};
    size_t n = check_count(400000);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++) {
            asked a = {specimen(smooth[i]), at_angle(cosine[k], 0.7), false};
            chi_square_result r = chi_square_directions(sample_of, pdf_of, &a, 1, 3, n);
            check_at_least(r.p, alarm, "specimen %d, cos %g: samples follow the pdf", smooth[i],
                           cosine[k]);
            check_at_most(r.integral, 1.01, "the pdf's integral, less what is rejected");
            check_at_least(r.integral, 0.4, "and most are not");
        }
    asked a = {specimen(1), at_angle(0.7, 0.7), true};
    check_at_most(chi_square_directions(sample_of, pdf_of, &a, 1, 4, n).p, alarm, "no J: refuted");
}

/* weight = f |zi| / pdf; and of the power no more leaves than came. */
static void test_weights(void)
{
    double off = 0, most = 0;
    size_t through = 0, n = check_count(4000);
    for (int i = 0; i < glasses; i++) {
        rough_glass g = specimen(i);
        double power = (double)(g.n2 / g.n1 * (g.n2 / g.n1));
        for (uint64_t k = 0; k < n; k++) {
            vec3 wo = random_direction(k, 7, false), wi;
            real weight;
            if (!draw(&g, wo, k, &wi, &weight)) continue;
            double f = (double)rough_glass_value(&g, wi, wo);
            double p = (double)rough_glass_pdf(&g, wi, wo);
            double again = f * fabs((double)wi.z) / p;
            if (fabs((double)wi.z) > 1e-3)  /* or z itself is rounding */
                off = check_worse(off, fabs(again / (double)weight - 1));
            most = check_worse(most, (double)weight * (wi.z < 0 ? power : 1));
            through += wi.z < 0;
        }
    }
    check_at_most(off, 100 * eps, "weight = f cos / pdf");
    check_at_most(most, 1 + 8 * eps, "no sample brings more power than 1");
    check(through > n, "many go through");
}

/* Power that leaves, of 1: by midpoints over the whole sphere, which share nothing with the
 * samples; and by the samples. Smooth: nothing is lost. */
static double power_by_grid(const rough_glass *g, vec3 wo, int k)
{
    double sum = 0, squeeze = (double)(g->n2 / g->n1 * (g->n2 / g->n1));
    for (int i = 0; i < k; i++)
        for (int j = 0; j < k; j++) {
            double theta = (double)pi * (i + 0.5) / k, turn = 2 * (double)pi * (j + 0.5) / k;
            vec3 wi = at_angle(cos(theta), turn);
            double f = (double)rough_glass_value(g, wi, wo) * fabs((double)wi.z) * sin(theta);
            sum += f * (wi.z < 0 ? squeeze : 1);
        }
    return sum * 2 * (double)pi * (double)pi / k / k;
}

static void test_energy(void)
{
    static const double cosine[3] = {1, 0.6, 0.25};
    for (int i = 0; i < glasses; i++)
        for (int k = 0; k < 3; k++) {
            rough_glass g = specimen(i);
            vec3 wo = at_angle(cosine[k], 0.3), wi;
            double squeeze = (double)(g.n2 / g.n1 * (g.n2 / g.n1));
            estimate e = {0};
            for (uint64_t j = 0; j < check_count(40000); j++) {
                real weight;
                bool some = draw(&g, wo, j, &wi, &weight);
                e = estimate_add(e, !some ? 0 : (double)weight * (wi.z < 0 ? squeeze : 1));
            }
            check_at_most(e.mean, 1, "no more power than there was");
            check_at_least(e.mean, i % 4 == 3 ? 0.9 : 0.35, "and not much less: 0.40 at alpha 1");
            /* midpoints see lobes of alpha .3 and more to 1e-3 */
            if (i % 4 < 3)
                check_at_least(t_test(e, power_by_grid(&g, wo, 200), 2e-3), alarm,
                               "specimen %d, cos %g: value and samples agree", i, cosine[k]);
        }
}

/* alpha -> 0: Snell's direction, Fresnel's share, nothing lost. */
static void test_smooth(void)
{
    static const double alphas[2] = {1e-3, 1e-2};
    for (int i = 0; i < 2; i++)
        for (int side = 0; side < 2; side++)
            for (int k = 1; k < 10; k += 2) {
                rough_glass g = {(real)alphas[i], 1, (real)1.5};
                if (side) g = turned(g);
                vec3 wo = at_angle(k / 10.0, 1), up = {0, 0, 1}, wt = {0, 0, 0}, wi;
                snell s;
                bool can = snell_of(vneg(wo), up, g.n1, g.n2, &s);
                if (can) wt = snell_refract(&s, vneg(wo), up);
                if (can && s.ct < 0.3) continue;  /* near the critical angle all is steep */
                estimate reflected = {0}, off = {0}, kept = {0};
                for (uint64_t j = 0; j < check_count(40000); j++) {
                    real weight;
                    if (!draw(&g, wo, j, &wi, &weight)) { kept = estimate_add(kept, 0); continue; }
                    vec3 want = wi.z > 0 ? (vec3){-wo.x, -wo.y, wo.z} : wt;
                    double power = (double)(g.n2 / g.n1 * (g.n2 / g.n1));
                    reflected = estimate_add(reflected, wi.z > 0);
                    kept = estimate_add(kept, (double)weight * (wi.z < 0 ? power : 1));
                    double d = (double)vlength(vsub(wi, want));
                    off = estimate_add(off, d < 50 * alphas[i] ? d : 50 * alphas[i]);
                }
                check_at_least(t_test(reflected, (double)fresnel(&s), 20 * alphas[i] * alphas[i]
                                      + 14.0 / (double)reflected.n), alarm,
                               "share reflected, cos %g, alpha %g", k / 10.0, alphas[i]);
                check_at_most(off.mean, 8 * alphas[i], "near Snell's and the mirror's directions");
                check_at_least(kept.mean, 1 - alphas[i], "little is lost");
            }
}

/* Behind the surface, no boundary, beyond the critical angle. */
static void test_ends(void)
{
    rough_glass g = specimen(2), none = {(real)0.3, (real)1.3, (real)1.3};
    rough_glass inside = {(real)1e-3, 1.5, 1};
    vec3 wo = at_angle(0.4, 0), wi = {0, 0, 0};
    real weight = 0;
    check_equal((double)rough_glass_value(&g, wo, vneg(wo)), 0, "seen from behind");
    check_equal((double)rough_glass_pdf(&g, wo, vneg(wo)), 0, "seen from behind");
    check(!rough_glass_sample(&g, vneg(wo), 0.5, 0.5, 0.5, &wi, &weight), "nothing is drawn");
    check(!rough_glass_sample(&g, vec(1, 0, 0), 0.5, 0.5, 0.5, &wi, &weight), "nor from its edge");
    check(rough_glass_sample(&none, wo, 0.5, 0.5, 0, &wi, &weight), "no boundary");
    check(vzero(vadd(wi, wo)) && weight == 1, "straight on, all of it");
    check_equal((double)rough_glass_pdf(&none, vneg(wo), wo), 0, "a delta has no density");
    for (uint64_t j = 0; j < 100; j++)
        check(draw(&inside, wo, j, &wi, &weight) && wi.z > 0, "total reflection");
    rough_glass zero = {0, 1, 1.5};
    check(draw(&zero, wo, 1, &wi, &weight) && vfinite(wi) && isfinite(weight), "alpha 0");
    vec3 mirror = {-wo.x, -wo.y, wo.z};
    check(isfinite(rough_glass_value(&zero, mirror, wo))
              && isfinite(rough_glass_pdf(&zero, mirror, wo)),
          "and it has numbers for its very peak");
}

int main(void)
{
    return check_all("23_rough_glass", test_reciprocity, test_sampling, test_weights, test_energy,
                     test_smooth, test_ends);
}
