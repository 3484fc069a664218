/* draw.h: the picture of a stage, or a part of it; what it took; how far off it still is.
 *
 *   drawing j = {.e = &e, .samples = 16, .seed = 1, .width = w, .height = h};
 *   bool whole = draw_region(&j, &im, x0, y0, threads)    im's pixels are those from (x0, y0) on of
 *                                     a picture of width x height; false: stopped by Ctrl-C
 *   j.counts                          rays by effect
 *   j.seconds                         that it took
 *   draw_error(&j)                    RMSE by halves (26.6): of linear radiance, all channels;
 *                                     infinity with one sample, 0 if nothing is left to chance
 *   draw_timed(&j, threads, &counts)  some pixels again, with a clock at each ray: shares of time
 *
 * Samples lie in the pixel by Sobol'; one alone, of a scene without chance, in its middle.
 */
#ifndef EFFECTS_DRAW_H
#define EFFECTS_DRAW_H

#include "../around.h"
#include "../special.h"
#include "../../../common/parallel.h"

typedef struct {
    const effects_stage *e;
    int samples;              /* of a pixel */
    uint64_t seed;
    int width, height;        /* of the whole picture */
    effects_counts counts;
    double seconds;
    image *im;
    int x0, y0;
    media_set around;         /* bodies that the eye is in */
    double squares;           /* sum of squared differences of the halves' means */
    size_t pixels;            /* that went into it */
    pthread_mutex_t lock;
} drawing;

enum { draw_side = 16, draw_timed_every = 37 };

/* ---------------------------------------------------------------------------------------------- */

/* The ray of sample k of a pixel. */
__attribute__((always_inline))
static inline ray draw_ray(const drawing *j, int x, int y, const dice *d)
{
    const effects_stage *e = j->e;
    point2 at = {0.5, 0.5}, on = {0, 0};
    bool lens = (e->mask & EFFECT_DEPTH_OF_FIELD) != 0;
    if (j->samples > 1 || e->chance) at = dice_eye(d, DICE_PIXEL);
    if (lens) on = dice_eye(d, DICE_LENS);
    thin_lens l = {lens ? e->lens.radius : 0, e->lens.focus};
    ray r = lens_ray(e->eye, l, (real)x + at.u, (real)y + at.v, j->width, j->height, on);
    r.tmin = e->hither;
    return r;
}

/* The samples of a pixel; *square: the squared difference of its halves, of all channels. */
static inline vec3 draw_pixel(const drawing *j, effects_function *f, int x, int y,
                              effects_counts *c, double *square)
{
    vec3 half[2] = {{0, 0, 0}, {0, 0, 0}};
    uint64_t i = (uint64_t)y * (uint64_t)j->width + (uint64_t)x;
    int n = j->samples;
    bool rolled = n > 1 || j->e->chance, timed = j->e->mask & EFFECTS_TIMED;
    for (int k = 0; k < n; k++) {
        dice d = {.own = 0};
        if (rolled) d = dice_start(j->seed, i, (uint32_t)k);
        ray r = draw_ray(j, x, y, &d);
        if (j->e->mask & EFFECT_DEPTH_OF_FIELD) c->rays[RAY_OF_LENS]++;
        c->now = RAY_OF_EYE;
        if (timed) c->since = clock_seconds();
        half[k % 2] = vadd(half[k % 2], f(j->e, r, j->around, &d, c));
        if (timed) c->seconds[c->now] += clock_seconds() - c->since;
    }
    vec3 off = vsub(vscale(half[0], 1 / (real)((n + 1) / 2)),
                    vscale(half[1], 1 / (real)(n > 1 ? n / 2 : 1)));
    *square = (double)vdot(off, off);
    return vscale(vadd(half[0], half[1]), 1 / (real)n);
}

static inline void draw_tile(size_t tile, void *context)
{
    drawing *j = context;
    effects_function *f = effects_made_for(j->e->mask);
    effects_counts c = {.now = 0};
    double squares = 0, one;
    size_t pixels = 0;
    bool timed = j->e->mask & EFFECTS_TIMED;
    int across = (j->im->width + draw_side - 1) / draw_side;
    int x0 = (int)(tile % (size_t)across) * draw_side;
    int y0 = (int)(tile / (size_t)across) * draw_side;
    for (int y = y0; y < y0 + draw_side && y < j->im->height; y++)
        for (int x = x0; x < x0 + draw_side && x < j->im->width; x++) {
            if (timed && (x + 7 * y) % draw_timed_every) continue;
            vec3 L = draw_pixel(j, f, x + j->x0, y + j->y0, &c, &one);
            if (!timed) image_set(j->im, x, y, L);
            squares += one, pixels++;
        }
    pthread_mutex_lock(&j->lock);
    effects_counts_add(&j->counts, &c);
    j->squares += squares, j->pixels += pixels;
    pthread_mutex_unlock(&j->lock);
}

static inline bool draw_region(drawing *j, image *im, int x0, int y0, int threads)
{
    size_t across = ((size_t)im->width + draw_side - 1) / draw_side;
    double start = clock_seconds();
    j->around = effects_around(j->e, j->e->eye.e);
    j->im = im, j->x0 = x0, j->y0 = y0, j->squares = 0, j->pixels = 0;
    j->counts = (effects_counts){.now = 0};
    pthread_mutex_init(&j->lock, NULL);
    bool whole = parallel_for(across * (((size_t)im->height + draw_side - 1) / draw_side), threads,
                              "drawing", draw_tile, j);
    pthread_mutex_destroy(&j->lock);
    j->seconds = clock_seconds() - start;
    return whole;
}

static inline double draw_error(const drawing *j)
{
    double a = (j->samples + 1) / 2, b = j->samples / 2, N = j->samples;
    if (!j->e->chance) return 0;
    if (b < 1 || !j->pixels) return (double)INFINITY;
    return sqrt(j->squares / (3 * (double)j->pixels) * (a * b / (N * N)));
}

/* Every 37th pixel: what kinds of ray take how much of the time. The clock itself takes some 30 ns
 * a ray, of each kind alike. */
static inline bool draw_timed(const drawing *of, int threads, effects_counts *counts)
{
    effects_stage clocked = *of->e;
    drawing j = *of;
    clocked.mask |= EFFECTS_TIMED;
    j.e = &clocked;
    if (j.samples > 8) j.samples = 8;
    bool whole = draw_region(&j, of->im, of->x0, of->y0, threads);
    *counts = j.counts;
    return whole;
}

#endif
