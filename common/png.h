/* png.h: writes 8-bit RGB as PNG (ISO/IEC 15948).
 *
 * Deflate (RFC 1951) replaces what occurred before, within 32768 bytes, by (length, distance): LZ77.
 * The rest goes out in the fixed Huffman code: no table to compute, some 10 % larger than the best.
 * Before that, the Paeth filter replaces each byte by its difference from the best of three
 * neighbours (PNG section 9.4), so that smooth rows become small numbers and repeat.
 */
#ifndef PNG_H
#define PNG_H

#include "file.h"
#include <stdint.h>

/* ---------------------------------------------------------------------------------------------- */

typedef struct { uint8_t *bytes; size_t n, room; uint64_t bits; int count; } bit_writer;

static inline void put_byte(bit_writer *w, uint8_t byte)
{
    w->bytes = grown(w->bytes, w->n, &w->room, 1);
    w->bytes[w->n++] = byte;
}

/* Lowest bit first, as deflate has it. */
static inline void put_bits(bit_writer *w, uint32_t value, int count)
{
    w->bits |= (uint64_t)value << w->count;
    w->count += count;
    for (; w->count >= 8; w->count -= 8, w->bits >>= 8) put_byte(w, (uint8_t)w->bits);
}

/* Huffman codes alone go highest bit first. */
static inline void put_code(bit_writer *w, uint32_t code, int count)
{
    for (int k = count - 1; k >= 0; k--) put_bits(w, code >> k & 1, 1);
}

/* Literal, end or length symbol [0, 287] in the fixed code, RFC 1951 section 3.2.6. */
static inline void put_symbol(bit_writer *w, uint32_t s)
{
    if (s < 144) put_code(w, 0x30 + s, 8);
    else if (s < 256) put_code(w, 0x190 + s - 144, 9);
    else if (s < 280) put_code(w, s - 256, 7);
    else put_code(w, 0xc0 + s - 280, 8);
}

/* A match: length [3, 258], distance [1, 32768]. Codes come in groups of 4 (lengths) or 2
 * (distances) that share a number of extra bits. */
static inline void put_match(bit_writer *w, uint32_t length, uint32_t distance)
{
    uint32_t l = length - 3, d = distance - 1;
    int e = 0;
    while (l >> (e + 3)) e++;  /* extra bits */
    if (length == 258) put_symbol(w, 285);
    else put_symbol(w, 257 + 4 * (uint32_t)e + (l >> e)), put_bits(w, l & ((1u << e) - 1), e);
    for (e = 0; d >> (e + 2);) e++;
    put_code(w, 2 * (uint32_t)e + (d >> e), 5), put_bits(w, d & ((1u << e) - 1), e);
}

enum { window = 32768, hash_size = 1 << 15, tries = 48 };

static inline uint32_t hash3(const uint8_t *p)
{
    return (((uint32_t)p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16) * 2654435761u) >> 17;
}

/* Longest earlier occurrence of what begins at i: its length (0: none) and distance. */
static inline uint32_t find_match(const uint8_t *in, size_t n, size_t i, const size_t *head,
                                  const size_t *previous, uint32_t *distance)
{
    uint32_t best = 2, most = n - i < 258 ? (uint32_t)(n - i) : 258;
    if (most < 3) return 0;
    size_t at = head[hash3(in + i)];  /* positions are kept + 1, so that 0 means none */
    for (int k = 0; k < tries && at && i - (at - 1) <= window && best < most; k++) {
        const uint8_t *p = in + at - 1, *q = in + i;
        uint32_t l = 0;
        if (p[best] == q[best]) while (l < most && p[l] == q[l]) l++;
        if (l > best) best = l, *distance = (uint32_t)(i - (at - 1));
        at = previous[(at - 1) % window];
    }
    return best > 2 ? best : 0;
}

/* One final block of fixed codes. A match waits one byte: a longer one may begin there. */
static inline void deflate(bit_writer *w, const uint8_t *in, size_t n)
{
    size_t *head = allocate(hash_size, sizeof *head), *previous = allocate(window, sizeof *head);
    uint32_t held = 0, held_distance = 0, distance = 0;
    size_t skip = 0;  /* bytes of a match already written */
    put_bits(w, 3, 3);
    for (size_t i = 0; i < n; i++) {
        uint32_t length = skip ? 0 : find_match(in, n, i, head, previous, &distance);
        if (n - i >= 3) previous[i % window] = head[hash3(in + i)], head[hash3(in + i)] = i + 1;
        if (skip) { skip--; continue; }
        if (held && length <= held) {  /* the match that began one byte ago is the better one */
            put_match(w, held, held_distance);
            skip = held - 2, held = 0;
        } else {
            if (held) put_symbol(w, in[i - 1]);
            if ((held = length) != 0) held_distance = distance;
            else put_symbol(w, in[i]);
        }
    }
    put_symbol(w, 256);
    put_bits(w, 0, 7);  /* fill the last byte */
    free(head), free(previous);
}

/* The differences of one row from Paeth's guess: of the bytes to the left a, above b, and above left
 * c, the one closest to a + b - c. Outside the picture all are 0. */
static inline void filter_row(uint8_t *out, const uint8_t *row, const uint8_t *above, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        int a = i < 3 ? 0 : row[i - 3], b = above ? above[i] : 0;
        int c = i < 3 || !above ? 0 : above[i - 3];
        int pa = abs(b - c), pb = abs(a - c), pc = abs(a + b - 2 * c);
        out[i] = (uint8_t)(row[i] - (pa <= pb && pa <= pc ? a : pb <= pc ? b : c));
    }
}

static inline void put_word(bit_writer *w, uint32_t x)
{
    for (int k = 24; k >= 0; k -= 8) put_byte(w, (uint8_t)(x >> k));
}

/* Writes length, type and data, and the CRC-32 of the last two; w holds type and data; frees it. */
static inline void end_chunk(FILE *out, bit_writer *w)
{
    bit_writer length = {0};
    uint32_t crc = ~0u;
    for (size_t i = 0; i < w->n; i++) {
        crc ^= w->bytes[i];
        for (int k = 0; k < 8; k++) crc = crc >> 1 ^ (0xedb88320u & -(crc & 1));
    }
    put_word(&length, (uint32_t)w->n - 4);
    put_word(w, ~crc);
    fwrite(length.bytes, 1, length.n, out);
    fwrite(w->bytes, 1, w->n, out);
    free(length.bytes), free(w->bytes);
}

static inline bit_writer begin_chunk(const char *type_and_data, size_t n)
{
    bit_writer w = {0};
    for (size_t k = 0; k < n; k++) put_byte(&w, (uint8_t)type_and_data[k]);
    return w;
}

/* Writes to an open stream; rgb holds width * height * 3 bytes, rows from the top. Write errors stay
 * in the stream, for file_commit. Memory: about twice the size of rgb. */
static inline void png_write(FILE *out, const uint8_t *rgb, int width, int height)
{
    size_t stride = 3 * (size_t)width, n = (stride + 1) * (size_t)height;
    uint8_t *raw = allocate(n, 1);
    uint32_t a = 1, b = 0;  /* Adler-32 */
    for (size_t y = 0; y < (size_t)height; y++) {
        uint8_t *to = raw + (stride + 1) * y;
        *to = 4;  /* Paeth */
        filter_row(to + 1, rgb + stride * y, y ? rgb + stride * (y - 1) : NULL, stride);
    }
    for (size_t i = 0; i < n; i++) a = (a + raw[i]) % 65521, b = (b + a) % 65521;
    bit_writer head = begin_chunk("IHDR", 4), colour = begin_chunk("sRGB\0", 5);
    bit_writer data = begin_chunk("IDAT\x78\x01", 6);  /* zlib: deflate, window 32768 */
    bit_writer end = begin_chunk("IEND", 4);
    put_word(&head, (uint32_t)width), put_word(&head, (uint32_t)height);
    put_byte(&head, 8), put_byte(&head, 2);            /* 8 bits, RGB */
    for (int k = 0; k < 3; k++) put_byte(&head, 0);    /* deflate, five filters, not interlaced */
    deflate(&data, raw, n);
    put_word(&data, b << 16 | a);
    fwrite("\x89PNG\r\n\x1a\n", 1, 8, out);
    end_chunk(out, &head), end_chunk(out, &colour), end_chunk(out, &data), end_chunk(out, &end);
    free(raw);
}

#endif
