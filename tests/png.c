/* Tests of common/png.h with the decoder of inflate.h, which shares no code with it. */
#include "check.h"
#include "child.h"
#include "inflate.h"
#include "../common/png.h"
#include "../common/random.h"

static uint8_t *file;
static size_t file_size;

/* Encodes, decodes, compares every byte. The file stays in `file`. */
static void round_trip(const uint8_t *rgb, int width, int height, const char *what)
{
    FILE *out = tmpfile();
    uint32_t w = 0, h = 0;
    uint8_t *decoded;
    png_write(out, rgb, width, height);
    file_size = (size_t)ftell(out);
    free(file), file = malloc(file_size);
    rewind(out);
    if (fread(file, 1, file_size, out) != file_size) abort();
    fclose(out);
    const char *error = png_decode(file, file_size, &w, &h, &decoded);
    check(!error, "%s of %d x %d: %s", what, width, height, error ? error : "");
    check(w == (uint32_t)width && h == (uint32_t)height, "%s: its size", what);
    check(decoded && memcmp(decoded, rgb, 3 * (size_t)width * (size_t)height) == 0,
          "%s of %d x %d: every byte", what, width, height);
    free(decoded);
}

static void test_checksums(void)
{
    const uint8_t *digits = (const uint8_t *)"123456789", *wiki = (const uint8_t *)"Wikipedia";
    check_equal(png_crc(digits, 9), 0xcbf43926, "the check value of CRC-32");
    check_equal(png_crc((const uint8_t *)"IEND", 4), 0xae426082, "CRC-32 of every PNG's end");
    check_equal(png_crc(digits, 0), 0, "CRC-32 of nothing");
    check_equal(png_adler(wiki, 9), 0x11e60398, "Adler-32 of a published example");
    check_equal(png_adler(wiki, 0), 1, "Adler-32 of nothing");
    uint8_t *ones = malloc(1000000);
    memset(ones, 255, 1000000);  /* sums far beyond the modulus: 1 + 255 n, n + 255 n(n+1)/2 */
    uint64_t n = 1000000, a = (1 + 255 * n) % 65521, b = (n + 255 * (n * (n + 1) / 2)) % 65521;
    check_equal(png_adler(ones, 1000000), (uint32_t)(b << 16 | a), "Adler-32 in closed form");
    free(ones);
}

/* Every length and the borders of every distance group, through the decoder. */
static void test_matches(void)
{
    uint32_t wrong = 0;
    uint8_t *out = malloc(70000);
    for (uint32_t l = 3; l <= 258; l++)
        for (uint32_t d = 1; d <= 32768; d = l == 100 ? d + 1 : d * 2 - (d > 2 && l % 2)) {
            png_bytes b = {0};
            png_match(&b, l, d), png_symbol(&b, 256), png_bits(&b, 0, 7);
            inflater z = {b.at, b.n, 0, out, 70000, 32768};
            for (uint32_t i = 0; i < 8; i++) out[32768 - d + i % d] = (uint8_t)(i % d * 31 + 7);
            const char *error = inflate_block(&z);
            wrong += error || z.made != 32768 + l || out[32768] != 7
                     || (d > 1 && out[32769] != 38);
            free(b.at);
            if (d == 1 && l % 2) d = 2;
        }
    check_equal(wrong, 0, "pairs of length and distance that came out as others");
    for (uint32_t s = 0; s < 286; s++) {
        png_bytes b = {0};
        png_symbol(&b, s), png_bits(&b, 0, 7);
        inflater z = {b.at, b.n, 0, NULL, 0, 0};
        wrong += inflate_symbol(&z) != (int)s;
        free(b.at);
    }
    check_equal(wrong, 0, "symbols that came out as others");
    free(out);
}

/* Of eight occurrences of three bytes the first one has the longest match: the chain goes that far
 * back. And of two equally long ones the nearer is named. */
static void test_chain(void)
{
    static const char text[] = "abcdefghij abc1 abc2 abc3 abc4 abc5 abc6 abcdefghij abcde";
    png_history *h = calloc(1, sizeof *h);
    h->in = (const uint8_t *)text, h->n = sizeof text - 1;
    size_t i = 0;
    png_found found = {0, 0};
    for (; i <= 41; i++) found = png_find(h, i, true);
    check(found.length == 14 && found.distance == 41, "length %u, %u back", found.length,
          found.distance);
    for (; i <= 52; i++) found = png_find(h, i, true);
    check(found.length == 5 && found.distance == 11, "length %u, %u back", found.length,
          found.distance);
    free(h);
}

static void test_pictures(void)
{
    random_stream s = random_start(1, 2, 3);
    int w = 200, h = 150;
    size_t n = 3 * (size_t)w * (size_t)h;
    uint8_t *rgb = malloc(n);
    for (size_t i = 0; i < n; i++) rgb[i] = (uint8_t)random_next_bits(&s);
    for (int x = 1; x < 12; x++) round_trip(rgb, x, 12 - x, "noise");
    round_trip(rgb, w, h, "noise");
    check_at_most((double)file_size, 1.125 * (double)n + 1000, "noise: at most 9 bits a byte");
    memset(rgb, 0, n);
    round_trip(rgb, w, h, "black");
    check_at_most((double)file_size, (double)n / 79, "black: at most 26 bits for 258 bytes");
    memset(rgb, 255, n);
    round_trip(rgb, w, h, "white");
    for (size_t i = 0; i < n; i++) rgb[i] = (uint8_t)(i / 3 % (size_t)w + i / 3 / (size_t)w);
    round_trip(rgb, w, h, "a ramp");
    check_at_most((double)file_size, (double)n / 20, "a ramp: its differences are constant");
    for (size_t i = 0; i < n; i++) rgb[i] = (uint8_t)(random_next_bits(&s) % 64 ? 200 : i % 256);
    round_trip(rgb, w, h, "specks");
    for (size_t i = 0; i < n; i++) rgb[i] = (uint8_t)(i * i >> 7);
    round_trip(rgb, w, h, "a pattern");
    free(rgb);
}

/* Repeats at just the largest distance, and just beyond; long runs of long matches. */
static void test_window(void)
{
    int w = 10923, h = 3;  /* one row and its filter byte: 32770 */
    size_t n = 3 * (size_t)w * (size_t)h;
    uint8_t *rgb = malloc(n);
    random_stream s = random_start(4, 5, 6);
    for (int period = 32764; period <= 32774; period++) {
        for (size_t i = 0; i < n; i++)
            rgb[i] = i < (size_t)period ? (uint8_t)random_next_bits(&s) : rgb[i - (size_t)period];
        round_trip(rgb, w, h, "a period about the window");
    }
    free(rgb);
}

int main(void)
{
    test_checksums();
    test_matches();
    test_chain();
    test_pictures();
    test_window();
    free(file);
    return check_report("png");
}
