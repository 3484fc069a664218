/* A mean with a control variate (控制变量): f[i] and g[i], n >= 3 of each, are two functions at the
 * same random places; G is the true mean of g. Where f and g rise together, the mean of g, which
 * is known to be off by so much, says how far that of f is off:
 *     result = mean f - c (mean g - G),   c = cov(f, g) / var(g)
 * with the c that makes the variance smallest, estimated from these very samples; c = 0 if all
 * g[i] are equal. Writes the standard error of the result: sqrt(s^2 / n), where s^2 is the sum
 * of the squares of f[i] - mean f - c (g[i] - mean g), divided by n - 2, since two numbers were
 * estimated. The samples may be 1e6 large and differ by 1. */
static inline real control_mean(const real *f, const real *g, int n, real G, real *error)
{
    real mf = 0, mg = 0, fg = 0, gg = 0, left = 0;
    for (int i = 0; i < n; i++) mf += f[i] / (real)n, mg += g[i] / (real)n;
    for (int i = 0; i < n; i++) {
        fg += (f[i] - mf) * (g[i] - mg);
        gg += (g[i] - mg) * (g[i] - mg);
    }
    bool equal = true;
    for (int i = 1; i < n; i++) equal = equal && g[i] == g[0];
    real c = equal ? 0 : fg / gg;
    for (int i = 0; i < n; i++) {
        real e = f[i] - mf - c * (g[i] - mg);
        left += e * e;
    }
    *error = sqrt(left / (real)(n - 2) / (real)n);
    return mf - c * (mg - G);
}
