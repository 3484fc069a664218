/* measure_floats.h: what float forgets.
 *
 *   measure_sums(o)        the sum of many equal numbers
 *   measure_variances(o)   E[x^2] - E[x]^2 of first.h against estimate.h
 */
#ifndef MEASURE_FLOATS_H
#define MEASURE_FLOATS_H

#include "../../../common/lab/report.h"
#include "../../../common/random.h"
#include "../estimate.h"
#include "../first.h"
#include "../../../common/numbers/sum.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void measure_sums(const options *o)
{
    table t = table_new("The sum of n ones, and of n tenths: relative error", "n|ones, float|"
                        "ones, float, sum_add|ones, double|tenths, float|tenths, float, sum_add|"
                        "tenths, double");
    for (int m = 12; m <= (o->quick ? 20 : 26); m += o->quick ? 4 : 2) {
        table_count(&t, (size_t)1 << m);
        for (int k = 0; k < 2; k++) {
            float x = k ? 0.1f : 1.0f, naive = 0;
            running_sum_f32 kept = {0, 0};
            double sum = 0, right = ldexp((double)x, m);
            for (int i = 0; i < 1 << m; i++)
                naive = sum_add_naive_f32(naive, x), kept = sum_add_f32(kept, x), sum += (double)x;
            table_number(&t, fabs((double)naive / right - 1));
            table_number(&t, fabs((double)kept.sum / right - 1));
            table_number(&t, fabs(sum / right - 1));
        }
    }
    output_extra_table(o, &t);
}

/* 1000 numbers, uniform about `mean`, deviation 1; steps of 1/1024, which floats of 1e4 have.
 * `out`: the variance three ways, in parts of the true one; first.h's as real has digits. */
static inline void variances_of(double mean, uint64_t seed, uint64_t set, double out[3])
{
    enum { n = 1000 };
    moments_f32 m = {0, 0};
    first_samples s = {0, 0, 0};
    estimate e = {0}, centred = {0};
    for (uint64_t i = 0; i < n; i++) {
        double u = random_double_of(random_bits(seed, set, i, 0));
        double off = floor((2 * u - 1) * sqrt(3.0) * 1024) / 1024, x = mean + off;
        m = moments_add_f32(m, (float)x), first_sample(&s, (real)x);
        e = estimate_add(e, x), centred = estimate_add(centred, off);
    }
    double v = estimate_variance(centred);
    out[0] = (double)moments_variance_f32(m, n) / v;
    out[1] = (double)first_variance(s) / v;
    out[2] = estimate_variance(e) / v;
}

static inline void measure_variances(const options *o)
{
    static const double means[5] = {1, 100, 1000, 1e4, 1e8};
    int sets = o->quick ? 40 : 1000;
    table t = table_new("Variance of 1000 numbers of deviation 1 by E[x^2] - E[x]^2, and by "
                        "estimate.h: worst relative error", "mean|error float|negative [%]|"
                        "error first|negative [%]|error estimate|negative [%]");
    for (int k = 0; k < 5; k++) {
        double negative[3] = {0}, worst[3] = {0}, v[3];
        for (int set = 0; set < sets; set++) {
            variances_of(means[k], o->seed, (uint64_t)set, v);
            for (int way = 0; way < 3; way++) {
                double off = fabs(v[way] - 1);
                negative[way] += 100.0 * (v[way] < 0) / sets;
                worst[way] = off > worst[way] ? off : worst[way];
            }
        }
        table_number(&t, means[k]);
        for (int way = 0; way < 3; way++) {
            /* Beyond 1e5 floats lie 8 apart. */
            bool known = means[k] < 1e5 || way == 2 || (way == 1 && !real_is_float);
            if (known) table_number(&t, worst[way]), table_number(&t, negative[way]);
            else table_text(&t, "-"), table_text(&t, "-");
        }
    }
    output_extra_table(o, &t);
}

#endif
