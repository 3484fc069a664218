/* inflate.h: the other way round from common/png.h, written after RFC 1950, RFC 1951 and ISO/IEC
 * 15948 alone: reads a PNG of 8-bit RGB, all checksums and all filters, stored and fixed blocks.
 *
 *   const char *error = png_decode(file, size, &width, &height, &rgb);      NULL: sound
 */
#ifndef INFLATE_H
#define INFLATE_H

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct { const uint8_t *in; size_t n, bit; uint8_t *out; size_t room, made; } inflater;

static inline uint32_t inflate_bits(inflater *z, int count)  /* lowest first */
{
    uint32_t v = 0;
    for (int k = 0; k < count; k++, z->bit++)
        if (z->bit / 8 < z->n) v |= (uint32_t)(z->in[z->bit / 8] >> z->bit % 8 & 1) << k;
    return v;
}

static inline uint32_t inflate_code(inflater *z, int count)  /* highest first */
{
    uint32_t v = 0;
    for (int k = 0; k < count; k++) v = v << 1 | inflate_bits(z, 1);
    return v;
}

/* The table of RFC 1951, 3.2.6, by lengths: 7 bits up to 0010111, 8 up to 11000111, then 9. */
static inline int inflate_symbol(inflater *z)
{
    uint32_t v = inflate_code(z, 7);
    if (v <= 0x17) return 256 + (int)v;
    v = v << 1 | inflate_code(z, 1);
    if (v >= 0x30 && v <= 0xbf) return (int)v - 0x30;
    if (v >= 0xc0 && v <= 0xc7) return 280 + (int)v - 0xc0;
    v = v << 1 | inflate_code(z, 1);
    return 144 + (int)v - 0x190;
}

static inline const char *inflate_block(inflater *z)
{
    static const int length[] = {3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 15, 17, 19, 23, 27, 31, 35, 43,
                                 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
    static const int length_bits[] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4,
                                      4, 4, 4, 5, 5, 5, 5, 0};
    static const int distance[] = {1, 2, 3, 4, 5, 7, 9, 13, 17, 25, 33, 49, 65, 97, 129, 193, 257,
                                   385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289,
                                   16385, 24577};
    for (;;) {
        int s = inflate_symbol(z);
        if (z->bit / 8 > z->n) return "data end early";
        if (s == 256) return NULL;
        if (s > 285) return "no such length symbol";
        size_t l = 1, d = 0;
        if (s > 256) {
            l = (size_t)length[s - 257] + inflate_bits(z, length_bits[s - 257]);
            int c = (int)inflate_code(z, 5);
            if (c > 29) return "no such distance symbol";
            d = (size_t)distance[c] + inflate_bits(z, c < 4 ? 0 : c / 2 - 1);
            if (d > z->made) return "distance before the beginning";
        }
        if (z->made + l > z->room) return "more data than the picture needs";
        for (; l > 0; l--, z->made++)
            z->out[z->made] = d ? z->out[z->made - d] : (uint8_t)s;
    }
}

static inline const char *inflate_all(inflater *z)
{
    for (uint32_t last = 0; !last;) {
        last = inflate_bits(z, 1);
        if (inflate_bits(z, 2) != 1) return "a block that is not of fixed codes";
        const char *error = inflate_block(z);
        if (error) return error;
    }
    return z->made == z->room ? NULL : "too few data";
}

static inline uint32_t inflate_word(const uint8_t *p)
{
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | p[3];
}

/* CRC-32 as the polynomial division that it is: bits come lowest first. */
static inline uint32_t inflate_crc(const uint8_t *p, size_t n)
{
    uint32_t r = 0xffffffff;
    for (size_t i = 0; i < n; i++)
        for (int k = 0; k < 8; k++) {
            uint32_t carry = (r ^ (uint32_t)(p[i] >> k)) & 1;
            r = r >> 1 ^ (carry ? 0xedb88320u : 0);
        }
    return r ^ 0xffffffff;
}

static inline void inflate_unfilter(uint8_t *out, const uint8_t *raw, size_t stride, size_t rows)
{
    for (size_t y = 0; y < rows; y++) {
        const uint8_t *row = raw + y * (stride + 1);
        for (size_t i = 0; i < stride; i++) {
            const uint8_t *to = out + y * stride + i;
            int a = i < 3 ? 0 : to[-3], b = y == 0 ? 0 : *(to - stride);
            int c = i < 3 || y == 0 ? 0 : *(to - stride - 3), p = a + b - c, guess = c;
            int pa = abs(p - a), pb = abs(p - b), pc = abs(p - c);
            if (pa <= pb && pa <= pc) guess = a; else if (pb <= pc) guess = b;
            int add[] = {0, a, b, (a + b) / 2, guess};
            out[y * stride + i] = (uint8_t)(row[1 + i] + add[row[0]]);
        }
    }
}

static inline const char *png_decode(const uint8_t *file, size_t n, uint32_t *width,
                                     uint32_t *height, uint8_t **rgb)
{
    uint8_t *data = calloc(n + 1, 1), *raw = NULL;
    const char *error = NULL, *order = "IHDRIDATIEND";
    size_t at = 8, got = 0, stride = 0;
    *rgb = NULL;
    if (n < 8 || memcmp(file, "\x89PNG\r\n\x1a\n", 8) != 0) error = "no signature";
    for (int chunk = 0; !error && chunk < 3; chunk++) {
        uint32_t length = at + 12 <= n ? inflate_word(file + at) : UINT32_MAX;
        if (length > n - at - 12) { error = "a chunk ends early"; break; }
        const uint8_t *type = file + at + 4;
        if (memcmp(type, order + 4 * chunk, 4) != 0) error = "chunks are not IHDR, IDAT, IEND";
        uint32_t crc = inflate_word(type + 4 + length);
        if (inflate_crc(type, length + 4) != crc) error = "wrong CRC-32";
        if (chunk == 0) *width = inflate_word(type + 4), *height = inflate_word(type + 8);
        if (chunk == 0 && memcmp(type + 12, "\x08\x02\0\0\0", 5) != 0) error = "not 8-bit RGB";
        if (chunk == 1) memcpy(data, type + 4, length), got = length;
        at += 12 + length;
    }
    if (!error && at != n) error = "something behind the end";
    if (!error && (got < 6 || data[0] != 0x78 || (data[0] * 256 + data[1]) % 31)) error = "no zlib";
    if (!error) {
        stride = 3 * (size_t)*width;
        inflater z = {data + 2, got - 6, 0, NULL, (stride + 1) * *height, 0};
        z.out = raw = malloc(z.room);
        error = inflate_all(&z);
        uint64_t a = 1, b = 0;
        for (size_t i = 0; i < z.made; i++) a = (a + raw[i]) % 65521, b = (b + a) % 65521;
        if (!error && (b << 16 | a) != inflate_word(data + got - 4)) error = "wrong Adler-32";
        if (!error && (z.bit + 7) / 8 != z.n) error = "bytes between data and checksum";
    }
    if (!error) inflate_unfilter(*rgb = malloc(stride * *height), raw, stride, *height);
    free(data), free(raw);
    return error;
}

#endif
