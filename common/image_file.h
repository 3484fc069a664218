/* image_file.h: pictures in files.
 *
 *   ending     written                                          read
 *   .ppm       P6, sRGB, 8 bits, rounded to nearest             P3 and P6, sRGB, maxval 1 to 65535
 *   .p3.ppm    P3, the same as text                             (whatever the ending)
 *   .png       sRGB, 8 bits                                     not read
 *   .pfm       PF, linear float32, little endian, exact         PF, either byte order
 *
 * Reading tells the format by its first two bytes. Numbers that are not finite go into .pfm as they
 * are; in the other formats a NaN becomes magenta, infinity the largest code, and stderr says how
 * many.
 */
#ifndef IMAGE_FILE_H
#define IMAGE_FILE_H

#include "image.h"
#include "png.h"
#include <ctype.h>

/* ---------------------------------------------------------------------------------------------- */

static inline bool ends_with(const char *text, const char *ending)
{
    size_t n = strlen(text), m = strlen(ending);
    return n > m && strcmp(text + n - m, ending) == 0;
}

static inline bool image_can_write(const char *path, failure *f)
{
    if (ends_with(path, ".ppm") || ends_with(path, ".png") || ends_with(path, ".pfm")) return true;
    return failed(f, 2, "%s: a picture's name ends in .png, .ppm, .p3.ppm or .pfm", path);
}

static inline void write_pfm(FILE *out, const image *im)
{
    const uint16_t one = 1;
    bool little = *(const uint8_t *)&one == 1;
    fprintf(out, "PF\n%d %d\n%s\n", im->width, im->height, little ? "-1.0" : "1.0");
    for (int y = im->height - 1; y >= 0; y--)
        fwrite(image_pixel(im, 0, y), sizeof(float), 3 * (size_t)im->width, out);
}

/* Whole or not at all; see file.h. Unknown ending: exit code 2; cannot write: 1. */
static inline bool image_write(const char *path, const image *im, failure *f)
{
    file_writer w;
    size_t stride = 3 * (size_t)im->width, n = stride * (size_t)im->height, bad = 0;
    if (!image_can_write(path, f) || !file_begin(&w, path, f)) return false;
    if (ends_with(path, ".pfm")) {
        write_pfm(w.stream, im);
        return file_commit(&w, f);
    }
    uint8_t *rgb = allocate(n, 1);
    for (int y = 0; y < im->height; y++) bad += image_row_bytes(im, y, rgb + stride * (size_t)y);
    if (bad) fprintf(stderr, "%s: %s: %zu pixels not finite\n", program_name, path, bad);
    if (ends_with(path, ".png")) png_write(w.stream, rgb, im->width, im->height);
    else {
        bool text = ends_with(path, ".p3.ppm");
        fprintf(w.stream, "P%d\n%d %d\n255\n", text ? 3 : 6, im->width, im->height);
        if (!text) fwrite(rgb, 1, n, w.stream);
        for (size_t i = 0; text && i < n; i++)
            fprintf(w.stream, "%d%c", rgb[i], i % 12 == 11 ? '\n' : ' ');
    }
    free(rgb);
    return file_commit(&w, f);
}

typedef struct { const char *at, *end; } scanner;

/* The next whole number in 0..most after white space and # comments; -1 if there is none. */
static inline long scan_number(scanner *s, long most)
{
    while (s->at < s->end && (isspace((unsigned char)*s->at) || *s->at == '#'))
        if (*s->at++ == '#') while (s->at < s->end && *s->at != '\n') s->at++;
    long n = 0;
    const char *first = s->at;
    for (; s->at < s->end && isdigit((unsigned char)*s->at); s->at++)
        if ((n = 10 * n + (*s->at - '0')) > most) return -1;
    return s->at > first ? n : -1;
}

static inline bool read_ppm(scanner s, bool text, long most, image *im)
{
    size_t n = 3 * (size_t)im->width * (size_t)im->height, bytes = most > 255 ? 2 : 1;
    if (!text && (size_t)(s.end - s.at) < n * bytes) return false;
    for (size_t i = 0; i < n; i++) {
        const uint8_t *p = (const uint8_t *)s.at + i * bytes;
        long v = text ? scan_number(&s, most) : bytes == 1 ? p[0] : p[0] << 8 | p[1];
        if (v < 0 || v > most) return false;
        im->rgb[i] = (float)srgb_decode((double)v / (double)most);
    }
    return true;
}

static inline bool read_pfm(scanner s, bool little, image *im)
{
    size_t stride = 3 * (size_t)im->width;
    if ((size_t)(s.end - s.at) < 4 * stride * (size_t)im->height) return false;
    for (int y = im->height - 1; y >= 0; y--)
        for (size_t i = 0; i < stride; i++, s.at += 4) {
            uint32_t word = 0;
            for (int k = 0; k < 4; k++) word = word << 8 | (uint8_t)s.at[little ? 3 - k : k];
            memcpy(im->rgb + stride * (size_t)y + i, &word, 4);
        }
    return true;
}

/* A new image in *out, for image_free. Unreadable: exit code 1; broken or not a known format: 2. */
static inline bool image_read(const char *path, image *out, failure *f)
{
    enum { side = 65535 };
    size_t n;
    char *text = file_read(path, &n, f);
    if (!text) return false;
    scanner s = {text + (n < 2 ? n : 2), text + n};
    char kind = n > 2 && text[0] == 'P' ? text[1] : 0;
    long w = scan_number(&s, side), h = scan_number(&s, side), most = 255;
    double scale = 0;
    bool ok = (kind == '3' || kind == '6' || kind == 'F') && w > 0 && h > 0;
    if (ok && kind == 'F') {
        char *end;
        scale = strtod(s.at, &end);
        ok = end > s.at && scale != 0 && isfinite(scale) && s.end > end;
        s.at = end;
    } else if (ok) ok = (most = scan_number(&s, 65535)) > 0 && s.end > s.at;
    ok = ok && isspace((unsigned char)*s.at++);
    /* A file cannot promise more pixels than it has bytes: no memory is taken on its word. */
    ok = ok && (size_t)(s.end - s.at) / 3 >= (size_t)w * (size_t)h;
    if (ok) {
        image im = image_new((int)w, (int)h);
        ok = kind == 'F' ? read_pfm(s, scale < 0, &im) : read_ppm(s, kind == '3', most, &im);
        if (ok) *out = im;
        else image_free(&im);
    }
    free(text);
    return ok || failed(f, 2, "%s: no whole P3, P6 or PF picture with sides up to %d", path, side);
}

#endif
