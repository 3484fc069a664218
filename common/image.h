/* image.h: a picture of linear light, and how far two pictures are apart.
 *
 * rgb holds width * height * 3 floats, rows from the top, pixels from the left; 1 is white of a
 * screen, more is allowed. Files and screens want the sRGB curve instead, which gives dark tones
 * more codes:
 *
 *   srgb = 12.92 c                       c <= 0.0031308
 *   srgb = 1.055 c^(1/2.4) - 0.055       else
 *
 * Source: IEC 61966-2-1:1999, section 5. Files: see image_file.h.
 */
#ifndef IMAGE_H
#define IMAGE_H

#include "file.h"
#include "vec3.h"
#include <stdint.h>

typedef struct { int width, height; float *rgb; } image;

typedef struct {
    double rmse;          /* root of the mean square difference, over all channels */
    double relative_mse;  /* mean of (a - b)^2 / (b^2 + 0.01), b the reference */
    double maximum;       /* largest |a - b| */
    size_t not_finite;    /* channels where either is NaN or infinite: counted only here */
} image_difference;

/* ---------------------------------------------------------------------------------------------- */

/* Black. Sides at least 1. The program ends if there is no memory; image_free gives it back. */
static inline image image_new(int width, int height)
{
    return (image){width, height, allocate((size_t)width * (size_t)height, 3 * sizeof(float))};
}

static inline void image_free(image *im)
{
    free(im->rgb);
    *im = (image){0, 0, NULL};
}

static inline float *image_pixel(const image *im, int x, int y)
{
    return im->rgb + 3 * ((size_t)y * (size_t)im->width + (size_t)x);
}

static inline void image_set(image *im, int x, int y, vec3 c)
{
    float *p = image_pixel(im, x, y);
    p[0] = (float)c.x, p[1] = (float)c.y, p[2] = (float)c.z;
}

static inline vec3 image_get(const image *im, int x, int y)
{
    const float *p = image_pixel(im, x, y);
    return (vec3){(real)p[0], (real)p[1], (real)p[2]};
}

/* Copies a panel with its upper left corner to (x, y); what sticks out is left out. */
static inline void image_place(image *to, int x, int y, const image *panel)
{
    for (int j = 0; j < panel->height; j++)
        for (int i = 0; i < panel->width; i++)
            if (x + i >= 0 && x + i < to->width && y + j >= 0 && y + j < to->height)
                memcpy(image_pixel(to, x + i, y + j), image_pixel(panel, i, j), 3 * sizeof(float));
}

static inline double srgb_encode(double c)
{
    return c <= 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - 0.055;
}

static inline double srgb_decode(double s)
{
    return s <= 0.04045 ? s / 12.92 : pow((s + 0.055) / 1.055, 2.4);
}

/* The nearest of the 256 codes; below 0 and above 1 clamped, NaN 0. The comparisons come before the
 * conversion to an integer, which is undefined for what does not fit. */
static inline uint8_t srgb_byte(double c)
{
    double s = srgb_encode(c);
    return !(s > 0) ? 0 : s >= 1 ? 255 : (uint8_t)(s * 255 + 0.5);
}

/* Three bytes a pixel into row[3 width]. A pixel with a NaN becomes pure magenta, to be seen.
 * Returns the number of pixels that are not finite. */
static inline size_t image_row_bytes(const image *im, int y, uint8_t *row)
{
    size_t bad = 0;
    for (int x = 0; x < im->width; x++, row += 3) {
        const float *p = image_pixel(im, x, y);
        bool nan = isnan(p[0]) || isnan(p[1]) || isnan(p[2]);
        for (int k = 0; k < 3; k++) row[k] = nan ? (k == 1 ? 0 : 255) : srgb_byte((double)p[k]);
        bad += !(isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]));
    }
    return bad;
}

/* How far a is from b; both of the same size. */
static inline image_difference image_compare(const image *a, const image *b)
{
    image_difference d = {0, 0, 0, 0};
    size_t n = 3 * (size_t)a->width * (size_t)a->height, counted = 0;
    for (size_t i = 0; i < n; i++) {
        double e = (double)a->rgb[i] - (double)b->rgb[i], r = (double)b->rgb[i];
        if (!isfinite(e)) { d.not_finite++; continue; }
        d.rmse += e * e;
        d.relative_mse += e * e / (r * r + 0.01);
        if (fabs(e) > d.maximum) d.maximum = fabs(e);
        counted++;
    }
    if (counted) d.rmse = sqrt(d.rmse / (double)counted), d.relative_mse /= (double)counted;
    return d;
}

#endif
