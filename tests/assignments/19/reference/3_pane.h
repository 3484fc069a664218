/* A window pane in air: light that arrives under the cosine ci goes to and fro between its two
 * faces, and part of it leaves on either side each time. Returns the share of the light that
 * comes back in all, and writes the share that gets through. n > 1 is the refractive index of
 * the glass; T in [0, 1] is what one way through the glass leaves of light (1: clear). ci in [0,
 * 1]; at ci = 0 all comes back. */
static inline real glass_pane(real ci, real n, real T, real *through)
{
    real ct = sqrt(1 - (1 - ci * ci) / (n * n)), R = first_fresnel(ci, ct, 1, n);
    if (R >= 1) return *through = 0, 1;

    /* In: 1 - R. Each round trip leaves R^2 T^2 of it: a geometric series. R is the same both
     * ways. */
    real round = R * R * T * T;
    *through = (1 - R) * (1 - R) * T / (1 - round);
    return R + (1 - R) * (1 - R) * R * T * T / (1 - round);
}
