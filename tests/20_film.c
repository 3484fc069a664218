/* Tests of 20_monte_carlo: exact sums, and films: tiles, ranges of samples, a picture's error. */
#include "check.h"
#include "../chapters/20_monte_carlo/lab/integrands.h"
#include "../chapters/20_monte_carlo/passes.h"

/* ---- tally ---- */

static void test_tally(void)
{
    random_stream s = random_start(26, 1, 1);
    for (int round = 0; round < (int)check_count(500); round++) {
        tally forth = {0, 0}, back = {0, 0}, split[3] = {{0, 0}, {0, 0}, {0, 0}};
        double x[60], exact = 0;
        for (int i = 0; i < 60; i++) {  /* multiples of 2^-20 below 2^25: their sum is exact */
            x[i] = floor((double)random_next(&s) * 0x1p45) * 0x1p-20;
            if (i % 3 == 0) x[i] = -x[i];
            if (i % 7 == 0) x[i] *= 0x1p-20, x[i] = floor(x[i] * 0x1p20) * 0x1p-20;
            exact += x[i];
        }
        for (int i = 0; i < 60; i++) {
            tally_add(&forth, x[i]), tally_add(&back, x[59 - i]);
            tally_add(&split[(int)(random_next(&s) * 3)], x[i]);
        }
        tally_join(&split[0], &split[2]), tally_join(&split[0], &split[1]);
        check_equal(tally_sum(&forth), exact, "sum of dyadic numbers");
        check(memcmp(&forth, &back, sizeof forth) == 0, "backwards: the same bits");
        check(memcmp(&forth, &split[0], sizeof forth) == 0, "in three parts: the same bits");
    }
    tally t = {0, 0};
    check(!tally_add(&t, (double)NAN) && t.low == 0 && t.high == 0, "a NaN is refused");
    check(tally_add(&t, (double)INFINITY), "infinity is cut");
    check_equal(tally_sum(&t), 0x1p44, "to 2^44");
    tally most = t, least = {0, INT64_MIN};
    for (int k = 0; k < 20; k++) tally_join(&most, &most);
    check_equal(tally_sum(&most), 0x1p64, "as many as --samples allows");
    check_equal(tally_sum(&least), -0x1p65, "the least that a file can say");
    check(tally_add(&t, -0x1p44) && t.low == 0 && t.high == 0, "and taken away again");
    tally_add(&t, -1e-30), tally_add(&t, 1e-30), tally_add(&t, -0.0);
    check(t.low == 0 && t.high == 0, "less than 2^-62 is nothing, on both sides");
    tally_add(&t, -0x1p-62);
    check_equal(tally_sum(&t), -0x1p-62, "the least step, downwards");
    tally_add(&t, 0x1p-61);
    check_equal(tally_sum(&t), 0x1p-62, "and up again, across 0");
}

/* ---- film ---- */

/* Each pixel is in the window of one tile. */
static void test_windows(void)
{
    film m = film_new(33, 17);
    size_t pixels = 0;
    for (size_t k = 0; k < film_tiles(&m); k++) {
        film_window w = film_window_of(&m, k);
        check(w.x0 < w.x1 && w.x1 <= 33 && w.y0 < w.y1 && w.y1 <= 17, "tile %zu: no pixels", k);
        pixels += (size_t)((w.x1 - w.x0) * (w.y1 - w.y0));
    }
    check_equal(pixels, 33 * 17, "pixels of all tiles");
    check_equal(film_tiles(&m), 3 * 2, "tiles");
    film_free(&m);
}

/* A pass that was stopped: of 3 x 2 tiles sample 0 is in two rows and 5 pixels of tile 0, in all of
 * tile 1, in the first 3 pixels of tile 4, and in the only one of tile 5: there the picture is
 * white, and black elsewhere. */
static bool half_has(size_t x, size_t y)
{
    if (x < 16) return y < 2 || (y == 2 && x < 5);
    return y < 16 ? x < 32 : x < 16 + 3 || x == 32;
}

static void test_half_a_pass(void)
{
    film m = film_new(33, 17);
    size_t wrong = 0;
    m.pending = (film_range){0, 1}, m.done[0] = 37, m.done[1] = 256, m.done[4] = 3, m.done[5] = 1;
    for (size_t i = 0; i < 33 * 17; i++) {
        film_pixel p = {0};
        bool there = half_has(i % 33, i / 33);
        film_pixel_add(&p, 0, there ? (vec3){1, 1, 1} : (vec3){0, 0, 0});
        film_gather(&m, i, &p);
    }
    image im = film_picture(&m);
    for (size_t i = 0; i < 33 * 17; i++) {
        bool there = half_has(i % 33, i / 33);
        wrong += im.rgb[3 * i] != (there ? 1.0f : 0.0f);
    }
    check_equal(wrong, 0, "pixels with another number of samples than they have had");
    image_free(&im), film_free(&m);
}

static void test_ranges(void)
{
    film m = film_new(1, 1);
    failure f;
    check(film_cover(&m, 4, 8, &f) && film_cover(&m, 0, 2, &f) && film_cover(&m, 9, 11, &f),
          "three");
    check_equal(m.ranges, 3, "with gaps");
    check(!film_cover(&m, 7, 9, &f) && !film_cover(&m, 1, 3, &f) && !film_cover(&m, 0, 20, &f),
          "what overlaps is refused");
    check_equal(f.exit_code, 2, "as misuse");
    check(film_cover(&m, 2, 4, &f) && m.ranges == 2 && m.range[0].end == 8, "a gap is closed");
    check(film_cover(&m, 8, 9, &f) && m.ranges == 1 && m.range[0].end == 11, "all of them");
    double n[2];
    film_count(&m, 0, 0, n);
    check(n[0] == 6 && n[1] == 5, "samples 0 .. 10: six are even");
    m.ranges = 0;
    check(film_cover(&m, 3, 6, &f), "an odd range");
    film_count(&m, 0, 0, n);
    check(n[0] == 1 && n[1] == 2, "samples 3, 4, 5: one is even");
    film_free(&m);
}

/* ---- passes, and the error of a picture ---- */

/* Each pixel and channel has e^(x+y) over the unit square: one truth, errors of chance. */
enum { smooth_across = 157, smooth_down = 135 };
typedef struct { film_passes pass; sequence_kind kind; uint32_t most; } smooth_sheet;

static void smooth_tile(size_t tile, void *job)
{
    smooth_sheet *s = job;
    film *f = s->pass.to;
    film_window w = film_window_of(f, tile);
    for (int i = 0; i < (w.x1 - w.x0) * (w.y1 - w.y0); i++) {
        int x = w.x0 + i % (w.x1 - w.x0), y = w.y0 + i / (w.x1 - w.x0);
        uint64_t at = (uint64_t)y * (uint64_t)f->width + (uint64_t)x;
        film_pixel p = {0};
        for (uint32_t k = s->pass.now.begin; k < s->pass.now.end; k++) {
            sampler u = sampler_start(s->kind, 20, 2 * at + k % 2, k / 2, s->most);
            real r = (real)integrand_value(SMOOTH, sampler_pair(&u));
            real g = (real)integrand_value(SMOOTH, sampler_pair(&u));
            film_pixel_add(&p, k, (vec3){r, g, (real)integrand_value(SMOOTH, sampler_pair(&u))});
        }
        film_gather(f, at, &p);
        f->done[tile]++;
    }
}

static film smooth_film(sequence_kind kind, int threads, uint32_t cut, uint32_t n)
{
    smooth_sheet s = {{.tile = smooth_tile, .job = &s, .threads = threads}, kind, (n + 1) / 2};
    film f = film_new(smooth_across, smooth_down);
    check(passes_range(&s.pass, &f, cut, n), "not stopped");
    check(cut == 0 || passes_range(&s.pass, &f, 0, cut), "nor here");
    check(s.pass.samples == n && film_samples(&f) == n && f.ranges == 1, "%u samples", (unsigned)n);
    return f;
}

/* 157 x 135 pixels of 3 channels: either square is off by sqrt(2 / 63585) = 0.6 %, their ratio by
 * 0.8 %; times 5. */
static void test_error_of_a_picture(void)
{
    static const struct { sequence_kind kind; uint32_t n; } list[] = {
        {SEQUENCE_RANDOM, 16}, {SEQUENCE_RANDOM, 3}, {SEQUENCE_SOBOL, 16}};
    double truth = integrand_integral(SMOOTH), e2 = exp(2), power = (e2 - 1) * (e2 - 1) / 4;
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        film f = smooth_film(list[k].kind, 0, 0, list[k].n);
        image im = film_picture(&f);
        double square = 0, said = film_error(&f);
        size_t n = 3 * smooth_across * smooth_down;
        for (size_t i = 0; i < n; i++) square += pow((double)im.rgb[i] - truth, 2) / (double)n;
        check_close(said * said / square, 1, 0.04, "%s, %u: estimated by true square",
                    sequence_name[list[k].kind], (unsigned)list[k].n);
        /* s^2 / N, as if all samples were independent: far too much for Sobol's. */
        double usual = (power - truth * truth) / list[k].n;
        if (list[k].kind == SEQUENCE_SOBOL) check_close(usual / square, 36, 4, "too large");
        else check_close(usual / square, 1, 0.04, "independent: s^2 / N by true square");
        image_free(&im), film_free(&f);
    }
    film one = smooth_film(SEQUENCE_SOBOL, 1, 0, 1);
    check(isinf(film_error(&one)), "one sample: the error is not known");
    film_free(&one);
}

static void test_passes(void)
{
    film one = smooth_film(SEQUENCE_SOBOL, 1, 0, 13), two = smooth_film(SEQUENCE_SOBOL, 3, 6, 13);
    size_t bytes = 2 * smooth_across * smooth_down * sizeof *one.half[0];
    check(memcmp(one.half[0], two.half[0], bytes) == 0,
          "two passes, the later samples first, of three threads: the same bits");
    film_free(&one), film_free(&two);
}

int main(void)
{
    return check_all("20_film", test_tally, test_windows, test_half_a_pass, test_ranges,
                     test_error_of_a_picture, test_passes);
}
