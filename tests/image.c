/* Tests of common/image.h: comparison, the sRGB curve, files; hostile ones, too. */
#include "check.h"
#include "child.h"
#include "../common/numbers/wide.h"
#include "../common/image.h"
#include "../common/random.h"
#include <sys/resource.h>

static char path[64];

static void put(const void *bytes, size_t n)
{
    FILE *out = fopen(path, "wb");
    if (!out || fwrite(bytes, 1, n, out) != n || fclose(out)) abort();
}

static bool read_bytes(const char *bytes, size_t n, image *im, failure *f)
{
    put(bytes, n);
    return image_read(path, im, f);
}

static bool same(const image *a, const image *b)
{
    size_t n = 3 * (size_t)a->width * (size_t)a->height;
    return a->width == b->width && a->height == b->height
           && memcmp(a->rgb, b->rgb, n * sizeof(float)) == 0;
}

static wide ratio(double a, double b) { return wide_div(wide_of(a), wide_of(b)); }

/* The 2.4th power is the fifth root of the 12th: Newton's method, without libm's pow. */
static wide power_2_4(wide x)
{
    wide p = wide_of(1), r = wide_of(1);
    for (int k = 0; k < 12; k++) p = wide_mul(p, x);
    for (int k = 0; k < 60; k++) {
        wide r2 = wide_mul(r, r), next = wide_div(p, wide_mul(r2, r2));
        r = wide_div(wide_add(wide_mul(wide_of(4), r), next), wide_of(5));
    }
    return r;
}

/* The curve of IEC 61966-2-1, code / 255 to light. */
static wide exact_decode(double code)
{
    wide s = ratio(code, 255), a = ratio(55, 1000);
    if (wide_value(s) <= 0.04045) return wide_div(s, ratio(1292, 100));
    return power_2_4(wide_div(wide_add(s, a), wide_add(a, wide_of(1))));
}

static void test_curve(void)
{
    int survived = 0, exact = 0, monotone = 1;
    for (int k = 0; k < 256; k++) {
        double c = srgb_decode(k / 255.0);
        survived += srgb_byte(c) == k && srgb_byte((double)(float)c) == k;
        exact += fabs(wide_value(wide_sub(wide_of(c), exact_decode(k)))) <= 7e-16;
    }
    check_equal(survived, 256, "codes that survive decoding and encoding, through float too");
    check_equal(exact, 256, "codes decoded within 7e-16: two roundings, times 2.4, and one of pow");
    /* The border between codes k and k + 1 is where s = (k + 1/2)/255: rounding to nearest. */
    int below = 0, above = 0;
    for (int k = 0; k < 255; k++) {
        double border = wide_value(exact_decode(k + 0.5));
        below += srgb_byte(border * (1 - 1e-14)) == k;
        above += srgb_byte(border * (1 + 1e-14)) == k + 1;
    }
    check_equal(below, 255, "just below a border: the lower code");
    check_equal(above, 255, "just above a border: the upper code");
    for (int i = 0; i < 100000; i++) monotone &= srgb_byte(i / 1e5) <= srgb_byte((i + 1) / 1e5);
    check(monotone, "a brighter light never has a lower code");
    check_close(srgb_encode(0.0031308), srgb_encode(0.0031309), 2e-6, "no jump between the parts");
    double inf = HUGE_VAL, nan = (double)NAN;
    check(srgb_byte(nan) == 0 && srgb_byte(inf) == 255 && srgb_byte(-inf) == 0
          && srgb_byte(-1) == 0 && srgb_byte(-0.0) == 0 && srgb_byte(1) == 255
          && srgb_byte(1e300) == 255 && srgb_byte(5e-324) == 0, "what is no code gets one");
}

static void test_compare(void)
{
    image a = image_new(2, 2), b = image_new(2, 2), c = image_new(2, 1);
    image_set(&a, 1, 1, (vec3){1, 2, 3});
    image_difference d = image_compare(&a, &b);
    check_close(d.rmse, sqrt(14.0 / 12), 1e-15, "root of the mean square");
    check_close(d.maximum, 3, 0, "maximum");
    check_close(d.relative_mse, 14 / 0.01 / 12, 1e-10, "relative to the reference b");
    d = image_compare(&b, &a);
    check_close(d.relative_mse, (1 / 1.01 + 4 / 4.01 + 9 / 9.01) / 12, 1e-15, "the other way");
    a.rgb[0] = NAN, b.rgb[1] = INFINITY, a.rgb[2] = b.rgb[2] = INFINITY;
    d = image_compare(&a, &b);
    check_equal(d.not_finite, 3, "channels that are not finite are counted");
    check_close(d.rmse, sqrt(14.0 / 9), 1e-15, "and left out");
    for (int i = 0; i < 12; i++) a.rgb[i] = NAN;
    d = image_compare(&a, &b);
    check(d.not_finite == 12 && d.rmse == 0 && d.relative_mse == 0, "nothing left to compare");
    check(isinf(image_compare(&a, &c).rmse), "sizes differ");
    check(isinf(image_compare(&c, &a).maximum), "sizes differ the other way");
    vec3 v = image_get(&b, 1, 1);
    check(vzero(v), "b is black there");
    image_place(&c, 1, 0, &b), image_place(&c, -1, -1, &b), image_place(&c, 9, 9, &b);
    check(c.rgb[4] == INFINITY && c.rgb[0] == 0, "a panel in its place, the rest left out");
    image_free(&a), image_free(&b), image_free(&c), image_free(&c);
    check(c.rgb == NULL, "freed, twice");
}

/* A picture of every code, and of what is no colour. */
static image odd_picture(int width, int height)
{
    image im = image_new(width, height);
    random_stream s = random_start(3, (uint64_t)width, 0);
    size_t n = 3 * (size_t)width * (size_t)height;
    for (size_t i = 0; i < n; i++) im.rgb[i] = (float)srgb_decode((double)(i % 256) / 255);
    for (size_t i = 0; i < n; i += 7) im.rgb[i] = random_float_of(random_next_bits(&s));
    return im;
}

static void test_round_trips(void)
{
    failure f = {0, ""};
    char name[80];
    const char *const endings[] = {".ppm", ".p3.ppm", ".pfm"};
    for (int w = 1; w < 40; w += 6)
        for (int e = 0; e < 3; e++) {
            image im = odd_picture(w, 40 - w), once, twice;
            snprintf(name, sizeof name, "%s%s", path, endings[e]);
            bool ok = image_write(name, &im, &f) && image_read(name, &once, &f);
            check(ok, "%s written and read", endings[e]);
            if (!ok) { image_free(&im); continue; }
            file_forget(name);  /* else no run replaces what it has read */
            ok = image_write(name, &once, &f) && image_read(name, &twice, &f);
            check(ok && same(&once, &twice), "%s: a file read and written again is the same",
                  endings[e]);
            if (e == 2) check(same(&im, &once), "PFM is exact");
            else {
                image_difference d = image_compare(&once, &im);
                check_at_most(d.maximum, 0.5 / 255 * 2.4 / 1.055 + 1e-7,
                              "half a code times the steepest slope of the curve");
            }
            image_free(&im), image_free(&once), image_free(&twice);
            unlink(name);
        }
}

/* What is written can be read, however wide. */
static void test_long_rows(void)
{
    static const char *const endings[] = {".pfm", ".ppm", ".p3.ppm"};
    for (int i = 0; i < 6; i++) {
        char name[80];
        failure f = {0, ""};
        int w = i % 2 ? 1 : 70000, h = 70001 - w;
        image im = image_new(w, h), got = {0, 0, NULL};
        image_set(&im, w - 1, h - 1, vec(1, 0, 1));
        snprintf(name, sizeof name, "%s%s", path, endings[i / 2]);
        check(image_write(name, &im, &f) && image_read(name, &got, &f), "%d x %d, %s: %s", w, h,
              endings[i / 2], f.text);
        check_equal(image_compare(&got, &im).maximum, 0, "%d x %d, %s", w, h, endings[i / 2]);
        image_free(&im), image_free(&got), unlink(name);
    }
}

static void write_odd(void *context)
{
    failure f;
    image im = image_new(3, 1);
    image_set(&im, 0, 0, vec(NAN, 1, 1));
    image_set(&im, 1, 0, (vec3){real_infinity, 0, 0});
    if (!image_write(context, &im, &f)) fail(f);
    image_free(&im);
}

static void test_not_finite(void)
{
    char name[80];
    image im = {0, 0, NULL};
    failure f;
    snprintf(name, sizeof name, "%s.ppm", path);
    child_result r = child_run(write_odd, name);
    check(r.status == 0 && strstr(r.err, "2 pixels not finite"), "counted on stderr: %s", r.err);
    check(image_read(name, &im, &f), "read");
    check(im.rgb && im.rgb[0] == 1 && im.rgb[1] == 0 && im.rgb[2] == 1, "a NaN is magenta");
    check(im.rgb && im.rgb[3] == 1 && im.rgb[4] == 0, "infinity is the largest code");
    image_free(&im), unlink(name);
}

static void test_formats(void)
{
    failure f;
    image im;
#define READ(text) read_bytes(text, sizeof(text) - 1, &im, &f)
    check(READ("P3 # c\n#\n1 # 5 5\n 1\n255\n255 0 128") && im.rgb[0] == 1 && im.rgb[1] == 0,
          "P3 with comments"), image_free(&im);
    check(READ("P3\n1 1\n1000\n1000 0 500\n") && im.rgb[0] == 1
          && im.rgb[2] == (float)srgb_decode(0.5), "P3 up to 1000"), image_free(&im);
    check(READ("P6 1 1 255 \xff\0\n") && im.rgb[0] == 1
          && im.rgb[2] == (float)srgb_decode(10 / 255.0), "P6; data may look like space"),
          image_free(&im);
    check(READ("P6\n1 1\n65535\n\xff\xff\0\0\x80\0") && im.rgb[0] == 1
          && im.rgb[2] == (float)srgb_decode(32768 / 65535.0), "P6 of 16 bits, high byte first"),
          image_free(&im);
    check(READ("P6\n1 1\n256\n\1\0\0\0\0\0") && im.rgb[0] == 1, "maxval 256 has 2 bytes"),
          image_free(&im);
    check(READ("P6\n1 1\n1\n\1\0\1") && im.rgb[0] == 1 && im.rgb[2] == 1, "maxval 1"),
          image_free(&im);
    check(READ("PF\n1 1\n1.0\n\x3f\x80\0\0\0\0\0\0\xc0\0\0\0") && im.rgb[0] == 1
          && im.rgb[2] == -2, "PFM, high byte first"), image_free(&im);
    check(READ("PF\n1 2\n-0.5\n\0\0\x80\x3f\0\0\0\0\0\0\0\0" "\0\0\0\x40\0\0\0\0\0\0\0\0")
          && im.rgb[0] == 2 && im.rgb[3] == 1, "PFM, low byte first, rows from the bottom"),
          image_free(&im);
    check(READ("P6 1 1 255 \1\2\3more") && im.height == 1, "bytes behind the picture"),
          image_free(&im);
}

static void test_broken(void)
{
    static const char *const texts[] = {
        "", "P", "P6", "P7 1 1 255 aaa", "P5 1 1 255 aaa", "X6 1 1 255 aaa", "\x89PNG\r\n\x1a\n",
        "P6 1 1 255", "P6 1 1 255 aa", "P6 1 1 255aaaa", "P6 0 1 255 aaa", "P6 1 0 255 aaa",
        "P6 -1 1 255 aaa", "P6 1 -1 255 aaa", "P6 1 1 0 aaa", "P6 1 1 65536 aaaaaaaa",
        "P6 1 1 -5 aaa",
        "P6 1.5 1 255 aaaaaa", "P6 1 1 100 aaz", "P6 1 1 300 \1\1\1\1\1", "P6 1 1 300 \1\1\1\1\2\1",
        "P6 65535 65535 255 aaa", "P6 700000000 1 255 aaa", "P6 99999999999999999999 1 255 aaa",
        "P3 1 1 255 1 2", "P3 1 1 255 1 2 256", "P3 1 1 255 1 2 -3", "P3 1 1 255 1 2 x",
        "P3 1 1 255 1 2 3.5e", "P3 60000 60000 255 1 2 3", "P3 1 1 255 # 1 2 3", "P3 1 1", "P3 # ",
        "PF 1 1 0 aaaaaaaaaaaa", "PF 1 1 nan aaaaaaaaaaaa", "PF 1 1 inf aaaaaaaaaaaa",
        "PF 1 1 x aaa",
        "PF 1 1 -1 aaaaaaaaaaa", "PF 1 1 -1", "PF 1 1 -1aaaaaaaaaaaa",
        "PF 65535 65535 -1 aaaaaaaaaaa",
        "Pf 1 1 -1 aaaaaaaaaaaa"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        image im = {7, 7, NULL};
        failure f = {0, ""};
        bool ok = read_bytes(texts[i], strlen(texts[i]), &im, &f);
        if (strcmp(texts[i], "P3 1 1 255 1 2 3.5e") == 0) {
            check(ok, "what follows the last number does not matter");
            image_free(&im);
            continue;
        }
        check(!ok && f.exit_code == 2, "refused: %.40s", texts[i]);
        check(strstr(f.text, path) && im.width == 7 && !im.rgb, "named, no picture: %s", f.text);
    }
    image im;
    failure f;
    check(!image_read("/no/such/file", &im, &f) && f.exit_code == 1, "unreadable is exit 1");
    check(!image_write("x.jpg", &im, &f) && f.exit_code == 2 && strstr(f.text, ".png"), "x.jpg");
    check(!image_can_write(".png", &f) && !image_can_write("png", &f) && !image_can_write("", &f)
          && !image_can_write("a.PNG", &f) && image_can_write("a.png", &f), "endings");
}

/* A header that promises 43 GB of pixels must not take memory on its word: with 1 GB to have, that
 * would end the program. */
static void read_huge(void *context)
{
    image im;
    failure f;
    struct rlimit limit = {1 << 30, 1 << 30};
    if (!getenv("CHECK_DIVISOR")) setrlimit(RLIMIT_AS, &limit);  /* a sanitizer needs more */
    (void)context;
    printf(read_bytes("P6 60000 60000 255 aaa", 22, &im, &f) ? "read" : "refused");
}

static void test_memory(void)
{
    child_result r = child_run(read_huge, NULL);
    check(r.status == 0, "no memory taken for a promise: %s", r.err);
    check_text(r.out, "refused", "a broken promise");
}

/* Files that were whole once, with bytes changed, cut off and put in. */
static void test_mutations(void)
{
    static const char *const seeds[] = {"P6\n3 2\n255\nabcdefghijklmnopqr", "P3 2 1 15 1 2 3 4 5 6",
                                        "PF\n1 1\n-1.0\nabcdefghijkl", "P6 1 1 999 \1\1\1\1\1\1"};
    random_stream s = random_start(7, 7, 7);
    size_t whole = 0, n = check_count(4000);
    for (size_t i = 0; i < n; i++) {
        char text[64];
        failure f;
        image im;
        size_t length = strlen(seeds[i % 4]);
        memcpy(text, seeds[i % 4], length);
        for (int k = 0; k < 3; k++) {
            uint64_t r = random_next_bits(&s);
            if (r % 8 == 0) length = r / 8 % (length + 1);
            else if (r % 8 < 3) text[r / 8 % 12] = (char)(r >> 40);
            else text[r / 8 % 12] = "0123456789 #\n-x."[r >> 40 & 15];
        }
        if (!read_bytes(text, length, &im, &f)) continue;
        whole++;
        double sum = 0;  /* every pixel is there: a sanitizer would see if not */
        for (int k = 0; k < 3 * im.width * im.height; k++) sum += (double)im.rgb[k];
        check(im.width > 0 && im.height > 0 && !(sum < -1e300 && sum > 0), "a picture");
        image_free(&im);
    }
    check(whole < n && (whole > 0 || n < 1000), "some survive, some do not");
}

int main(void)
{
    snprintf(path, sizeof path, "/tmp/image_test_%ld", (long)getpid());
    test_curve();
    test_compare();
    test_round_trips();
    test_long_rows();
    test_not_finite();
    test_formats();
    test_broken();
    test_memory();
    test_mutations();
    unlink(path);
    return check_report("image");
}
