/* Checks of assignment 20 that the student does not have: hard cases. Included after public.h. */
#ifndef HIDDEN_20_H
#define HIDDEN_20_H

/* The last number below 1, 0, and the smallest: lengths and heights stay what they are. */
static question ask_direction_ends(random_stream *g, int i)
{
    question q = ask_direction(g, i);
    const real end[4] = {0, 1 - real_epsilon / 2, (real)1e-300, (real)0.5};
    q.u = end[i / 2 % 4], q.v = i % 3 ? random_next(g) : end[i / 6 % 4];
    return q;
}

/* One or two samples more than none are not asked; two samples, and samples that are all equal. */
static question ask_samples_few(random_stream *g, int i)
{
    question q = ask_samples(g, i);
    if (i % 2) q.n = 2;
    return q;
}

static question ask_linear_ends(random_stream *g, int i)
{
    question q = ask_linear(g, i);
    real off = exam_between(g, -1, 1);
    switch (i % 5) {
    case 0: q.b = q.a; break;
    case 1: q.b = q.a * (1 + ldexp(off, -(int)(random_next_bits(g) % 50))); break;
    case 2: q.a = 0; break;
    case 3: q.b = 0; break;
    case 4: q.u = i % 2 ? 0 : 1 - real_epsilon / 2; q.a = i % 3 ? q.a : 0; break;
    }
    return q;
}

/* u next to 1, weights 0 at both ends, weights of all sizes. */
static question ask_choice_ends(random_stream *g, int i)
{
    question q = ask_choice(g, i);
    for (int k = 0; k < q.n; k++) q.f[k] *= ldexp((real)1, (int)(random_next_bits(g) % 40) - 20);
    if (q.n > 3) q.f[0] = q.f[q.n - 1] = 0, q.f[1] = 1;
    if (i % 3 == 0) q.u = 1 - real_epsilon / 2;
    if (i % 3 == 1) q.u = 0;
    return q;
}

/* Numbers near 1e6 that differ by 1; a g that does not change; f that is a straight line of g. */
static question ask_control_odd(random_stream *g, int i)
{
    question q = ask_control(g, i);
    real G = q.G;
    for (int k = 0; k < q.n; k++) {
        if (i % 3 == 0) q.f[k] += (real)1e6, q.g[k] += (real)1e6, q.G = G + (real)1e6;
        if (i % 3 == 1) q.g[k] = (real)0.1;
        if (i % 3 == 2) q.f[k] = 2 + q.g[k];
    }
    return q;
}

static const exam_check hidden_checks[] = {
    {1, "two samples", 5, true, 60, ask_samples_few, mark_error},
    {2, "u near 0 and 1", 5, true, 48, ask_direction_ends, mark_direction},
    {3, "level, nearly level, 0 at an end", 11, true, 500, ask_linear_ends, mark_linear},
    {4, "weight 0, all sizes, ends", 10, true, 600, ask_choice_ends, mark_choice},
    {5, "large, constant, exact", 10, true, 90, ask_control_odd, mark_control},
};
#endif
