/* Checks of assignment 20 that the student has. Inversion is undone: the probability below the
 * answer has to be u again. Sums are taken anew, in another order and with more digits. */
#ifndef PUBLIC_20_H
#define PUBLIC_20_H
#include "exam.h"

static question ask_samples(random_stream *g, int i)
{
    question q;
    (void)i;
    memset(&q, 0, sizeof q);
    q.n = 3 + (int)(random_next_bits(g) % 60);
    real middle = exam_between(g, -3, 3), wide = exam_between(g, 0.1, 5);
    for (int k = 0; k < q.n; k++) q.f[k] = middle + wide * exam_between(g, -1, 1);
    return q;
}

/* Mean, variance and standard error by sums of all pairs: the sum of (a - b)^2 over all pairs is
 * n (n - 1) times the variance. No mean is subtracted. */
static bool mark_error(const question *q, const answer *a, char why[exam_why])
{
    long double sum = 0, pairs = 0, n = q->n;
    for (int i = q->n - 1; i >= 0; i--) {
        sum += q->f[i];
        for (int k = 0; k < i; k++) pairs += ((long double)q->f[i] - q->f[k]) * (q->f[i] - q->f[k]);
    }
    double mean = (double)(sum / n), variance = (double)(pairs / (n * (n - 1)));
    double error = sqrt(variance / (double)n);
    return (exam_near(a->x, mean, 1e-10) && exam_near(a->p, variance, 1e-10 * (1 + variance))
            && exam_near(a->error, error, 1e-10 * (1 + error)))
           || exam_say(
               why,
               "of %d samples: mean %.9g, variance %.9g, standard error %.9g are due, yours "
               "%.9g, %.9g, %.9g",
               q->n, mean, variance, error, a->x, a->p, a->error);
}

static question ask_direction(random_stream *g, int i)
{
    question q;
    memset(&q, 0, sizeof q);
    q.cosine = i % 2;
    q.u = random_next(g), q.v = random_next(g);
    if (i % 10 == 9) q.u = 0;
    return q;
}

/* Unit; the azimuth turns once as v goes from 0 to 1; the height z: uniform, P(z) = z, or with the
 * cosine, P(z) = z^2, is u or 1 - u. */
static bool mark_direction(const question *q, const answer *a, char why[exam_why])
{
    const char *which = q->cosine ? "first_cosine_direction" : "first_uniform_direction";
    double z = (double)a->d.z, P = q->cosine ? z * z : z, turn = atan2(a->d.y, a->d.x) / (2 * pi);
    if (!exam_near(vlength(a->d), 1, 1e-12))
        return exam_say(why, "%s(%g, %g) has the length %.9g", which, q->u, q->v, vlength(a->d));
    if (!(z >= 0 && (exam_near(P, q->u, 1e-12) || exam_near(P, 1 - q->u, 1e-12))))
        return exam_say(why,
                        "%s(%g, %g): the probability of a height below z = %.6g is %.6g, which has "
                        "to be u or 1 - u",
                        which, q->u, q->v, z, P);
    double off = turn - q->v - floor(turn - q->v + 0.5);
    return exam_near(off, 0, 1e-9) || hypot(a->d.x, a->d.y) < 1e-6
           || exam_say(why, "%s(%g, %g) has turned by %.6g of a circle, v is due", which, q->u,
                       q->v, turn);
}

static question ask_linear(random_stream *g, int i)
{
    question q;
    (void)i;
    memset(&q, 0, sizeof q);
    q.a = exam_between(g, 0.1, 3), q.b = exam_between(g, 0.1, 3), q.u = random_next(g);
    return q;
}

static bool mark_linear(const question *q, const answer *a, char why[exam_why])
{
    long double A = q->a, B = q->b, x = a->x;
    double P = (double)((A * x + (B - A) * x * x / 2) * 2 / (A + B));
    double p = (double)((A + (B - A) * x) * 2 / (A + B));
    if (!(a->x >= 0 && a->x <= 1))
        return exam_say(why, "a = %g, b = %g, u = %g: x = %g is not in [0, 1]", q->a, q->b, q->u,
                        a->x);
    if (!exam_near(P, q->u, 1e-13))
        return exam_say(why, "a = %g, b = %g, u = %.9g: x = %.9g has %.9g below it, u is due", q->a,
                        q->b, q->u, a->x, P);
    return exam_near(a->p, p, 1e-12 * (1 + p))
           || exam_say(why, "a = %g, b = %g: the density at %.9g is %.9g, yours %.9g", q->a, q->b,
                       a->x, p, a->p);
}

static question ask_choice(random_stream *g, int i)
{
    question q;
    memset(&q, 0, sizeof q);
    q.n = 1 + (int)(random_next_bits(g) % 20);
    for (int k = 0; k < q.n; k++) q.f[k] = exam_between(g, 0.1, 1) * (k % 4 == i % 4 && k ? 0 : 1);
    q.u = random_next(g);
    return q;
}

/* The share of those before it, plus `rest` of its own, is u. */
static bool mark_choice(const question *q, const answer *a, char why[exam_why])
{
    long double sum = 0, before = 0;
    if (a->i < 0 || a->i >= q->n || q->f[a->i] == 0)
        return exam_say(why, "u = %g: number %d is not there, or has the weight 0", q->u, a->i);
    for (int k = q->n - 1; k >= 0; k--) sum += q->f[k], before += k < a->i ? q->f[k] : 0;
    double p = (double)(q->f[a->i] / sum), low = (double)(before / sum);
    if (!(low <= q->u + 1e-12 && q->u <= low + p + 1e-12))
        return exam_say(why, "u = %.9g: number %d stands for %.9g to %.9g", q->u, a->i, low,
                        low + p);
    if (!exam_near(a->p, p, 1e-12))
        return exam_say(why, "number %d has the probability %.9g, yours %.9g", a->i, p, a->p);
    return (a->x >= 0 && a->x < 1 && exam_near(low + p * a->x, q->u, 1e-12))
        || exam_say(why, "u = %.9g in %.9g to %.9g: rest is %.9g, yours %.9g", q->u, low, low + p,
                    (q->u - low) / p, a->x);
}

static question ask_control(random_stream *g, int i)
{
    question q = ask_samples(g, i);
    real slope = exam_between(g, -3, 3), noise = exam_between(g, 0.01, 1);
    q.G = exam_between(g, -1, 1);
    for (int k = 0; k < q.n; k++) {
        q.g[k] = q.G + exam_between(g, -1, 1);
        q.f[k] = 2 + slope * q.g[k] + noise * exam_between(g, -1, 1);
    }
    return q;
}

/* The result is where the straight line that fits best, f = m + c (g - G), is at g = G: solved
 * from its normal equations, in g - g[0] and f - f[0], with more digits. */
static bool mark_control(const question *q, const answer *a, char why[exam_why])
{
    long double n = q->n, sf = 0, sg = 0, ff = 0, fg = 0, gg = 0, c = 0;
    bool equal = true;
    for (int k = 0; k < q->n; k++) {
        long double f = (long double)q->f[k] - q->f[0], g = (long double)q->g[k] - q->g[0];
        sf += f, sg += g, ff += f * f, fg += f * g, gg += g * g;
        equal = equal && g == 0;
    }
    if (!equal) c = (n * fg - sf * sg) / (n * gg - sg * sg);
    long double mean = q->f[0] + sf / n - c * (q->g[0] + sg / n - q->G);
    long double left = ff - sf * sf / n - (equal ? 0 : c * (fg - sf * sg / n));
    double due = (double)mean, error = (double)sqrtl(left > 0 ? left / (n - 2) / n : 0);
    double large = fmax(1, fabs((double)q->f[0]));
    if (!exam_near(a->x, due, 1e-9 * large))
        return exam_say(why, "%d samples, c = %.6g: the mean is %.12g, yours %.12g", q->n,
                        (double)c, due, a->x);
    return exam_near(a->error, error, 1e-6 * (error + 1e-3))
           || exam_say(why, "%d samples: the standard error is %.9g, yours %.9g", q->n, error,
                       a->error);
}

static const exam_check public_checks[] = {
    {1, "mean, variance, standard error", 10, false, 100, ask_samples, mark_error},
    {2, "heights and turns", 10, false, 400, ask_direction, mark_direction},
    {3, "any slope", 8, false, 400, ask_linear, mark_linear},
    {4, "number, probability, rest", 8, false, 400, ask_choice, mark_choice},
    {5, "mean and its error", 8, false, 200, ask_control, mark_control},
};
#endif
