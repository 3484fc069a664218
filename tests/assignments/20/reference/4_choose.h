/* One of n things, number i with a probability proportional to weight[i] >= 0 (not all are 0).
 * By inversion: i is the number for which u, in [0, 1), lies between the shares of those before
 * it and theirs with its own. Writes the probability p of i, and in `rest` where between the two
 * u lies, in [0, 1): so one random number can be used once more. A thing of weight 0 is never
 * chosen, whatever rounding does. */
static inline int sample_choice(const real *weight, int n, real u, real *p, real *rest)
{
    real sum = 0, before = 0;
    int i = 0;
    for (int k = 0; k < n; k++) sum += weight[k];
    real target = u * sum;
    for (int k = 0; k < n; k++) {
        if (weight[k] == 0) continue;
        if (target < before + weight[k]) {
            i = k;
            break;
        }
        before += weight[k], i = k;  /* if rounding lets none hold it, it is the last */
    }
    *p = weight[i] / sum;
    real where = (target - before) / weight[i];
    *rest = real_clamp(where, 0, 1 - real_epsilon / 2);
    return i;
}
