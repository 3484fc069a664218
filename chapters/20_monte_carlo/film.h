/* film.h: what the samples of every pixel add up to, and how far off the picture still is.
 *
 *   sample k of a pixel belongs to half k mod 2; the halves share no random numbers: within each,
 *   sample k / 2 of a sequence of its own
 *
 *   A, B: means of the two halves of N samples; both are right on average and independent, so
 *   E (A - B)^2 = V[A] + V[B],   V[(A + B)/2] = E (A - B)^2 / 4                             (20.21)
 *   RMSE^2 = mean over pixels and channels of (A - B)^2 nA nB / N^2                         (20.22)
 *
 *   film f = film_new(w, h);
 *   film_pixel p = {0};                   the sums of one pixel, while its samples are taken
 *   film_pixel_add(&p, k, L)              sample k; false: not a number, nothing is added
 *   film_gather(&f, i, &p)                to pixel i = y w + x; each sample once
 *   film_cover(&f, a, b, &why)            says that all pixels have samples a .. b-1; false: twice
 *   double e = film_error(&f)             the RMSE (20.22) of film_picture, of linear radiance, all
 *                                         pixels and channels; infinity with fewer than 2 samples
 *   image im = film_picture(&f)
 *   film_free(&f)
 *
 * (20.22) needs no assumption on how samples are spread within a half: it holds for Sobol's points,
 * where s^2 / n would be far too large. It is unbiased for the mean square, whatever the number of
 * pixels; over p pixels it is itself off by some sqrt(2 / p), more where a few pixels hold most of
 * the noise. What no sample has found yet (a caustic) it can't know.
 * Price: two halves of N/2 points, not one set of N: what stratification gains beyond 1/N grows a
 * little later.
 */
#ifndef MONTE_CARLO_FILM_H
#define MONTE_CARLO_FILM_H

#include "../../common/image.h"
#include "tally.h"

enum { film_most_ranges = 256, film_side = 16 };
typedef struct { tally of[3]; } film_sum;              /* of R, G, B */
typedef struct { film_sum half[2]; } film_pixel;
typedef struct { uint32_t begin, end; } film_range;   /* samples begin .. end - 1 */
typedef struct { int x0, y0, x1, y1; } film_window;
typedef struct {
    int width, height;
    film_sum *half[2];                    /* [width height] each: a first sample fills one only */
    film_range range[film_most_ranges + 1];  /* rising, with gaps between them; room for one */
    int ranges;
    film_range pending;                   /* a pass that was stopped: */
    uint16_t *done;                       /* [tiles] of 16 x 16: by rows, so many pixels have it */
} film;

/* ---------------------------------------------------------------------------------------------- */

static inline size_t film_across(const film *f)
{
    return ((size_t)f->width + film_side - 1) / film_side;
}

static inline size_t film_tiles(const film *f)
{
    return film_across(f) * (((size_t)f->height + film_side - 1) / film_side);
}

/* The pixels of a tile: from (x0, y0) to before (x1, y1). */
static inline film_window film_window_of(const film *f, size_t tile)
{
    int x = (int)(tile % film_across(f)) * film_side, y = (int)(tile / film_across(f)) * film_side;
    int right = x + film_side, below = y + film_side;
    return (film_window){x, y, right < f->width ? right : f->width,
                         below < f->height ? below : f->height};
}

static inline film film_new(int width, int height)
{
    film f = {.width = width, .height = height};
    size_t n = (size_t)width * (size_t)height;
    f.half[0] = allocate(2 * n, sizeof *f.half[0]);
    f.half[1] = f.half[0] + n;
    f.done = allocate(film_tiles(&f), sizeof *f.done);
    return f;
}

static inline void film_free(film *f)
{
    free(f->half[0]), free(f->done);
    *f = (film){.width = 0};
}

static inline bool film_pixel_add(film_pixel *p, uint32_t k, vec3 L)
{
    tally *t = p->half[k % 2].of;
    bool x = tally_add(&t[0], (double)L.x), y = tally_add(&t[1], (double)L.y);
    return tally_add(&t[2], (double)L.z) && x && y;
}

/* A half without samples stays untouched: that of a first sample is memory nobody has asked for. */
static inline void film_gather(film *f, size_t i, const film_pixel *p)
{
    for (int k = 0; k < 6; k++) {
        const tally *t = &p->half[k / 3].of[k % 3];
        if (t->low || t->high) tally_join(&f->half[k / 3][i].of[k % 3], t);
    }
}

/* How many of a range are in the half. */
static inline double film_share(film_range r, int half)
{
    return half ? r.end / 2 - r.begin / 2 : (r.end + 1) / 2 - (r.begin + 1) / 2;
}

/* Whether pixel (x, y) has the samples of the pass that is pending. */
static inline bool film_has_pending(const film *f, int x, int y)
{
    size_t tile = (size_t)(y / film_side) * film_across(f) + (size_t)(x / film_side);
    film_window w = film_window_of(f, tile);
    return (y - w.y0) * (w.x1 - w.x0) + x - w.x0 < f->done[tile];
}

static inline void film_count(const film *f, int x, int y, double n[2])
{
    bool pending = film_has_pending(f, x, y);
    for (int h = 0; h < 2; h++) {
        n[h] = pending ? film_share(f->pending, h) : 0;
        for (int i = 0; i < f->ranges; i++) n[h] += film_share(f->range[i], h);
    }
}

static inline uint64_t film_samples(const film *f)
{
    uint64_t n = 0;
    for (int i = 0; i < f->ranges; i++) n += f->range[i].end - f->range[i].begin;
    return n;
}

static inline bool film_cover(film *f, uint32_t begin, uint32_t end, failure *why)
{
    int at = 0, n = f->ranges, last = 0;
    if (begin >= end) return true;
    while (at < n && f->range[at].end <= begin) at++;
    if (at < n && f->range[at].begin < end)
        return failed(why, 2, "samples %u:%u are there already, in %u:%u: nothing counts twice",
                      (unsigned)begin, (unsigned)end, (unsigned)f->range[at].begin,
                      (unsigned)f->range[at].end);
    bool touches = (at > 0 && f->range[at - 1].end == begin)
                || (at < n && f->range[at].begin == end);
    if (n == film_most_ranges && !touches)
        return failed(why, 2, "more than %d separate ranges of samples", film_most_ranges);
    memmove(f->range + at + 1, f->range + at, (size_t)(n - at) * sizeof *f->range);
    f->range[at] = (film_range){begin, end};
    for (int i = 1; i <= n; i++)  /* those that touch become one */
        if (f->range[last].end == f->range[i].begin) f->range[last].end = f->range[i].end;
        else f->range[++last] = f->range[i];
    f->ranges = last + 1;
    return true;
}

/* A pixel without samples is black. */
static inline image film_picture(const film *f)
{
    image im = image_new(f->width, f->height);
    size_t w = (size_t)f->width;
    for (size_t i = 0; i < w * (size_t)f->height; i++) {
        double n[2];
        film_count(f, (int)(i % w), (int)(i / w), n);
        for (int k = 0; k < 3 && n[0] + n[1] > 0; k++) {
            tally sum = f->half[0][i].of[k];
            tally_join(&sum, &f->half[1][i].of[k]);
            im.rgb[3 * i + (size_t)k] = (float)(tally_sum(&sum) / (n[0] + n[1]));
        }
    }
    return im;
}

static inline double film_error(const film *f)
{
    double n[2] = {0, 0}, sum = 0, pixels = (double)f->width * f->height;
    for (int i = 0; i < f->ranges; i++)
        for (int h = 0; h < 2; h++) n[h] += film_share(f->range[i], h);
    if (n[0] < 1 || n[1] < 1) return (double)INFINITY;
    for (size_t i = 0; i < (size_t)f->width * (size_t)f->height; i++)
        for (int k = 0; k < 3; k++) {
            double d = tally_sum(&f->half[0][i].of[k]) / n[0]
                     - tally_sum(&f->half[1][i].of[k]) / n[1];
            sum += d * d;
        }
    double N = n[0] + n[1];
    return sqrt(sum / (3 * pixels) * (n[0] * n[1] / (N * N)));
}

#endif
