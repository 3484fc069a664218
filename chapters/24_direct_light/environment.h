/* environment.h: light from infinitely far away, a picture of the whole sphere of directions.
 *                                                            environment light (环境光)
 *   0 ___________ u ______________ 1      u = phi / 2 pi, v = theta / pi                   (24.12)
 *    |  +y: above                  |      theta: from +y, phi = atan2(z, x); w columns, h rows
 *  v |. . . . horizon . . . . . . .|      Omega_j = 2 pi/w (cos(pi j/h) - cos(pi (j+1)/h)) (24.14)
 *    |__-y: below__________________|      p(wi) = P(texel) / Omega, P ~ luminance x Omega  (24.15)
 *
 *   in row j: cos theta = cos(pi j/h) - u' (cos(pi j/h) - cos(pi (j+1)/h)), phi evenly      (24.13)
 *
 *   environment e;
 *   if (!environment_of_image(&im, &e, &f)) fail(f);     im is copied; f: negative, NaN, all black
 *   vec3 L = environment_radiance(&e, d)                 d: unit
 *   environment_sample(&e, u, &wi, &pdf, &L)             pdf [1/sr] in proportion to luminance
 *   real p = environment_pdf(&e, d)                      the same for any direction; 0: black there
 *   environment_free(&e)
 *
 * A texel has one colour all over, so L / pdf of a grey one is the same for every sample: against a
 * surface that reflects evenly, the only noise is that of its cosine and of shadows.
 */
#ifndef DIRECT_ENVIRONMENT_H
#define DIRECT_ENVIRONMENT_H

#include "../../common/image.h"
#include "../20_monte_carlo/discrete.h"
#include "../20_monte_carlo/sampler.h"

typedef struct { image im; choice texel; } environment;

/* ---------------------------------------------------------------------------------------------- */

/* (24.14), from half angles: near the poles a difference of cosines would lose its digits. */
static inline real environment_omega(const environment *e, int row)
{
    real h = (real)e->im.height, middle = pi * ((real)row + (real)0.5) / h;
    return 2 * pi / (real)e->im.width * 2 * sin(middle) * sin(pi / (2 * h));
}

static inline void environment_free(environment *e)
{
    image_free(&e->im), choice_free(&e->texel);
}

static inline bool environment_of_image(const image *im, environment *out, failure *f)
{
    size_t n = (size_t)im->width * (size_t)im->height;
    *out = (environment){.im = image_new(im->width, im->height)};
    memcpy(out->im.rgb, im->rgb, 3 * n * sizeof *im->rgb);
    real *weight = allocate(n, sizeof *weight);
    bool ok = true;
    for (size_t i = 0; i < n; i++) {
        int x = (int)(i % (size_t)im->width), y = (int)(i / (size_t)im->width);
        vec3 c = image_get(im, x, y);
        ok = ok && vfinite(c) && c.x >= 0 && c.y >= 0 && c.z >= 0;
        real luminance = (real)0.2126 * c.x + (real)0.7152 * c.y + (real)0.0722 * c.z;
        weight[i] = luminance * environment_omega(out, y);
    }
    ok = ok && choice_build(weight, n, &out->texel);
    free(weight);
    if (ok) return true;
    environment_free(out);
    return failed(f, 2, "the environment has a negative or infinite radiance, or none at all");
}

/* Row and column of d; the last one where rounding goes beyond. */
static inline size_t environment_texel(const environment *e, vec3 d)
{
    int w = e->im.width, h = e->im.height;
    real theta = atan2(sqrt(d.x * d.x + d.z * d.z), d.y), phi = atan2(d.z, d.x);
    if (phi < 0) phi += 2 * pi;
    int x = (int)(phi / (2 * pi) * (real)w), y = (int)(theta / pi * (real)h);
    return (size_t)(y < h ? y : h - 1) * (size_t)w + (size_t)(x < w ? x : w - 1);
}

static inline vec3 environment_radiance(const environment *e, vec3 d)
{
    const float *c = e->im.rgb + 3 * environment_texel(e, d);
    return vec(c[0], c[1], c[2]);
}

static inline real environment_density(const environment *e, size_t k)
{
    return choice_probability(&e->texel, k) / environment_omega(e, (int)(k / (size_t)e->im.width));
}

static inline real environment_pdf(const environment *e, vec3 d)
{
    return environment_density(e, environment_texel(e, d));
}

/* (24.13), by half angles. *L is what environment_radiance gives there. */
static inline void environment_sample(const environment *e, point2 u, vec3 *wi, real *pdf, vec3 *L)
{
    real p, rest, w = (real)e->im.width, h = (real)e->im.height;
    size_t k = choice_sample(&e->texel, u.u, &p, &rest);
    real y = (real)(k / (size_t)e->im.width), x = (real)(k % (size_t)e->im.width);
    real top = pi * y / h, half = pi / (2 * h);
    real drop = u.v * 2 * sin(top + half) * sin(half);  /* cos(top) - cos(theta) */
    real s = sin(top / 2), q = s * s + drop / 2;        /* sin^2(theta / 2) */
    real phi = 2 * pi * (x + rest) / w, r = 2 * sqrt(real_max(q * (1 - q), 0));
    *wi = (vec3){r * cos(phi), 1 - 2 * q, r * sin(phi)};
    *pdf = environment_density(e, k);
    const float *c = e->im.rgb + 3 * k;
    *L = vec(c[0], c[1], c[2]);
}

#endif
