/* image.h: a picture of linear light, how far two pictures are apart, and pictures in files.
 *
 * 1 is the white of a screen, more is allowed. Files and screens want the sRGB curve instead, which
 * gives dark tones more codes: IEC 61966-2-1:1999, section 5.
 *
 *   ending     written                                          read
 *   .ppm       P6, sRGB, 8 bits, rounded to nearest             P3 and P6, sRGB, maxval 1 to 65535
 *   .p3.ppm    P3, the same as text                             (whatever the ending)
 *   .png       sRGB, 8 bits                                     not read
 *   .pfm       PF, linear float32, exact                        PF, either byte order
 *
 * Reading tells the format by its first two bytes. Pixels that are not finite are counted on
 * stderr; .pfm keeps them, elsewhere NaN becomes magenta and infinity the largest code.
 */
#ifndef IMAGE_H
#define IMAGE_H
#include "file.h"
#include "png.h"
#include "vec3.h"

/* width * height * 3 floats, rows from the top, pixels from the left, red first. */
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

static inline void image_free(image *im) { free(im->rgb), *im = (image){0, 0, NULL}; }

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
    return vec(p[0], p[1], p[2]);
}

/* Copies a panel with its upper left corner to (x, y) [+-2^30]; what sticks out is left out. */
static inline void image_place(image *to, int x, int y, const image *panel)
{
    for (int j = 0; j < panel->height; j++)
        for (int i = 0; i < panel->width; i++)
            if (x + i >= 0 && x + i < to->width && y + j >= 0 && y + j < to->height)
                memcpy(image_pixel(to, x + i, y + j), image_pixel(panel, i, j), 3 * sizeof(float));
}

/* Linear [0, 1] to sRGB [0, 1], and back. */
static inline double srgb_encode(double c)
{
    return c <= 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - 0.055;
}

static inline double srgb_decode(double s)
{
    return s <= 0.04045 ? s / 12.92 : pow((s + 0.055) / 1.055, 2.4);
}

/* The nearest of the 256 codes; below 0 is 0, above 1 is 255, NaN is 0. The comparisons come
 * before the conversion to an integer, which is undefined for what does not fit. */
static inline uint8_t srgb_byte(double c)
{
    double s = srgb_encode(c);
    return !(s > 0) ? 0 : s >= 1 ? 255 : (uint8_t)lround(s * 255);
}

/* The difference of a from the reference b; all infinite if their sizes differ. */
static inline image_difference image_compare(const image *a, const image *b)
{
    image_difference d = {HUGE_VAL, HUGE_VAL, HUGE_VAL, 0};
    size_t n = 3 * (size_t)a->width * (size_t)a->height, counted = 0;
    if (a->width != b->width || a->height != b->height) return d;
    d.rmse = d.relative_mse = d.maximum = 0;
    for (size_t i = 0; i < n; i++) {
        double r = (double)b->rgb[i], e = (double)a->rgb[i] - r;
        if (!isfinite(e)) continue;
        d.rmse += e * e, d.relative_mse += e * e / (r * r + 0.01);
        d.maximum = fabs(e) > d.maximum ? fabs(e) : d.maximum;
        counted++;
    }
    if (counted) d.rmse = sqrt(d.rmse / (double)counted), d.relative_mse /= (double)counted;
    d.not_finite = n - counted;
    return d;
}

static inline bool ends_with(const char *text, const char *ending)
{
    size_t n = strlen(text), m = strlen(ending);
    return n > m && strcmp(text + n - m, ending) == 0;
}

static inline bool image_can_write(const char *path, failure *f)
{
    if (ends_with(path, ".ppm") || ends_with(path, ".png") || ends_with(path, ".pfm")) return true;
    return failed(f, 2, "%.300s: a picture's name ends in .png, .ppm, .p3.ppm or .pfm", path);
}

/* sRGB, three bytes a pixel, for free(); *bad counts the pixels that are not finite. */
static inline uint8_t *image_bytes(const image *im, size_t *bad)
{
    size_t n = (size_t)im->width * (size_t)im->height;
    uint8_t *rgb = allocate(n, 3);
    *bad = 0;
    for (size_t i = 0; i < 3 * n; i += 3) {
        const float *p = im->rgb + i;
        bool nan = isnan(p[0]) || isnan(p[1]) || isnan(p[2]);
        *bad += !(isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]));
        if (i && memcmp(p, p - 3, 3 * sizeof *p) == 0) {
            memcpy(rgb + i, rgb + i - 3, 3);  /* as its neighbour: spares three powers */
            continue;
        }
        for (size_t k = 0; k < 3; k++)
            rgb[i + k] = nan ? (k == 1 ? 0 : 255) : srgb_byte((double)p[k]);
    }
    return rgb;
}

static inline void write_pfm(FILE *out, const image *im)
{
    const uint16_t one = 1;
    fprintf(out, "PF\n%d %d\n%d.0\n", im->width, im->height, *(const uint8_t *)&one ? -1 : 1);
    for (int y = im->height - 1; y >= 0; y--)
        fwrite(image_pixel(im, 0, y), sizeof(float), 3 * (size_t)im->width, out);
}

static inline void write_ppm(FILE *out, const uint8_t *rgb, int width, int height, bool text)
{
    size_t n = 3 * (size_t)width * (size_t)height;
    fprintf(out, "P%d\n%d %d\n255\n", text ? 3 : 6, width, height);
    if (!text) fwrite(rgb, 1, n, out);
    for (size_t i = 0; text && i < n; i++)
        fprintf(out, "%d%c", rgb[i], i % 12 == 11 || i + 1 == n ? '\n' : ' ');
}

/* Whole or not at all; see file.h. Unknown ending: exit code 2; cannot write: 1. */
static inline bool image_write(const char *path, const image *im, failure *f)
{
    file_writer w;
    size_t bad;
    if (!image_can_write(path, f) || !file_begin(&w, path, f)) return false;
    uint8_t *rgb = image_bytes(im, &bad);
    if (bad) fprintf(stderr, "%s: %s: %zu pixels not finite\n", program_name, path, bad);
    if (ends_with(path, ".pfm")) write_pfm(w.stream, im);
    else if (ends_with(path, ".png")) png_write(w.stream, rgb, im->width, im->height);
    else write_ppm(w.stream, rgb, im->width, im->height, ends_with(path, ".p3.ppm"));
    free(rgb);
    return file_commit(&w, f);
}

/* A program whose last word is a picture's name; else it is images/NAME.png, or in build/ after
 * `own` words that make it another picture, and in float. picture_end writes it, says where it is
 * and frees it; both end the program on failure. */
static inline const char *picture_path_after(int own, int argc, char **argv, const char *name)
{
    static char path[200];
    const char *folder = real_is_float || own ? "build" : "images";
    failure f = {2, "it takes one word at most: the name of the picture"};
    program_name = name, argc -= own, argv += own;
    if (argc > 2 || (argc == 2 && !image_can_write(argv[1], &f))) fail(f);
    mkdir(folder, 0777);  /* if that fails, writing the file says why */
    snprintf(path, sizeof path, "%s/%s.png", folder, name);
    return argc == 2 ? argv[1] : path;
}

static inline const char *picture_path(int argc, char **argv, const char *name)
{
    return picture_path_after(0, argc, argv, name);
}

static inline int picture_end(const char *path, image *im)
{
    failure f;
    if (!image_write(path, im, &f)) fail(f);
    return image_free(im), printf("-> %s\n", path) < 0;
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

/* The numbers behind the header: text, or `bytes` bytes each, the lowest first if `little`. A PFM
 * (4 bytes) holds floats, rows from the bottom. False: a number is missing or too large. */
static inline bool read_pixels(scanner s, bool text, int bytes, bool little, long most, image *im)
{
    for (int y = 0; y < im->height; y++) {
        float *row = image_pixel(im, 0, bytes == 4 ? im->height - 1 - y : y);
        for (int i = 0; i < 3 * im->width; i++) {
            uint32_t v = text ? (uint32_t)scan_number(&s, most) : 0;
            for (int k = 0; !text && k < bytes; k++)
                v = v << 8 | (uint8_t)s.at[little ? bytes - 1 - k : k];
            if (!text) s.at += bytes;
            if (bytes == 4) memcpy(&row[i], &v, 4);
            else if (v > (uint32_t)most) return false;
            else row[i] = (float)srgb_decode((double)v / (double)most);
        }
    }
    return true;
}

/* A new image in *out, for image_free. Unreadable: exit code 1; broken or not a known format: 2. */
static inline bool image_read(const char *path, image *out, failure *f)
{
    const long side = INT32_MAX / 3;  /* an int counts the floats of a row; any picture fits */
    size_t n;
    char *text = file_read(path, &n, f), *end;
    if (!text) return false;
    scanner s = {text + (n < 2 ? n : 2), text + n};
    int kind = n > 2 && text[0] == 'P' ? text[1] : 0;
    long w = scan_number(&s, side), h = scan_number(&s, side), most = 65535;
    double scale = 1;
    if (kind == 'F') scale = strtod(s.at, &end), s.at = end > s.at ? end : s.end;
    else most = scan_number(&s, 65535);
    int bytes = kind == 'F' ? 4 : kind == '6' && most > 255 ? 2 : 1;  /* a number has at least */
    bool ok = (kind == '3' || kind == '6' || kind == 'F') && w > 0 && h > 0 && most > 0;
    ok = ok && scale != 0 && isfinite(scale) && s.at < s.end && isspace((unsigned char)*s.at++);
    /* A file cannot promise more than it holds: no memory is taken on its word. */
    if (ok && (size_t)(s.end - s.at) / 3 / (size_t)bytes >= (size_t)w * (size_t)h) {
        image im = image_new((int)w, (int)h);
        ok = read_pixels(s, kind == '3', bytes, scale < 0, most, &im);
        if (ok) *out = im;
        else image_free(&im);
    } else ok = false;
    free(text);
    return ok || failed(f, 2, "%.300s: no whole P3, P6 or PF picture", path);
}
#endif
