/* png.h: writes 8-bit RGB as PNG (ISO/IEC 15948).
 *
 *   filter     each byte becomes its difference from a guess made of its neighbours (section 9):
 *              smooth rows turn into small numbers, even ones into zeros
 *   deflate    what occurred before, within 32768 bytes, becomes (length, distance): LZ77. All goes
 *              out in the fixed Huffman code (RFC 1951, 3.2.6), which needs no table in the file
 *   chunks     length, type, data, CRC-32
 *
 * Rendered pictures take 1.1 to 1.3 times what libpng takes, plain ones more: 258 equal bytes cost
 * 13 bits at least.
 */
#ifndef PNG_H
#define PNG_H
#include "file.h"
#include <stdint.h>

/* ---------------------------------------------------------------------------------------------- */
/* Bytes that grow at the end; bits fill each byte from its lowest. */
typedef struct { uint8_t *at; size_t n, room; uint64_t bits; int held; } png_bytes;

static inline void png_byte(png_bytes *b, uint32_t value)
{
    b->at = grown(b->at, b->n, &b->room, 1);
    b->at[b->n++] = (uint8_t)value;
}

static inline void png_word(png_bytes *b, uint32_t value)  /* highest byte first */
{
    for (int shift = 24; shift >= 0; shift -= 8) png_byte(b, value >> shift);
}

static inline void png_bits(png_bytes *b, uint32_t value, int count)
{
    b->bits |= (uint64_t)value << b->held, b->held += count;
    for (; b->held >= 8; b->held -= 8, b->bits >>= 8) png_byte(b, (uint32_t)b->bits);
}

/* A Huffman code goes highest bit first. */
static inline void png_code(png_bytes *b, uint32_t code, int count)
{
    uint32_t reversed = 0;
    for (int k = 0; k < count; k++) reversed |= (code >> k & 1) << (count - 1 - k);
    png_bits(b, reversed, count);
}

/* A literal byte 0..255, the end 256, or a length symbol 257..285. */
static inline void png_symbol(png_bytes *b, uint32_t s)
{
    if (s < 144) png_code(b, s + 0x30, 8);
    else if (s < 256) png_code(b, s - 144 + 0x190, 9);
    else if (s < 280) png_code(b, s - 256, 7);
    else png_code(b, s - 280 + 0xc0, 8);
}

/* Repeats `length` bytes [3, 258] from `distance` bytes [1, 32768] ago. Codes come in groups of 4
 * lengths or 2 distances that share a number of extra bits, which follow as they are. */
static inline void png_match(png_bytes *b, uint32_t length, uint32_t distance)
{
    uint32_t l = length - 3, d = distance - 1, extra = 0;
    while (l >> (extra + 3)) extra++;
    png_symbol(b, length == 258 ? 285 : 257 + 4 * extra + (l >> extra));
    if (length < 258) png_bits(b, l & ((1u << extra) - 1), (int)extra);
    for (extra = 0; d >> (extra + 2);) extra++;
    png_code(b, 2 * extra + (d >> extra), 5);
    png_bits(b, d & ((1u << extra) - 1), (int)extra);
}

/* Where three bytes occurred last, by their hash, and for each place in the window the one before
 * with that hash. Places count from 1; 0 is none. */
enum { png_window = 32768, png_hashes = 1 << 15, png_tries = 48 };
typedef struct { const uint8_t *in; size_t n, last[png_hashes], before[png_window]; } png_history;
typedef struct { uint32_t length, distance; } png_found;

/* The longest earlier occurrence of what begins at i, the nearest of equal ones; length 0: none.
 * Then i itself joins the history. `search` false: it only joins. */
static inline png_found png_find(png_history *h, size_t i, bool search)
{
    png_found best = {0, 0};
    if (h->n - i < 3) return best;
    uint32_t most = h->n - i < 258 ? (uint32_t)(h->n - i) : 258;
    const uint8_t *q = h->in + i;
    uint32_t three = (uint32_t)q[0] | (uint32_t)q[1] << 8 | (uint32_t)q[2] << 16;
    size_t *last = &h->last[three * 2654435761u >> 17], at = *last;
    for (int k = 0; search && k < png_tries && at && i + 1 - at <= png_window; k++) {
        const uint8_t *p = h->in + at - 1;
        uint32_t l = 0;
        if (p[best.length] == q[best.length]) while (l < most && p[l] == q[l]) l++;
        if (l > best.length) best = (png_found){l, (uint32_t)(i + 1 - at)};
        if (best.length == most) break;
        at = h->before[(at - 1) % png_window];
    }
    h->before[i % png_window] = *last;
    *last = i + 1;
    return best.length < 3 ? (png_found){0, 0} : best;
}

/* One block. */
static inline void png_deflate(png_bytes *out, const uint8_t *in, size_t n)
{
    png_history *h = allocate(1, sizeof *h);
    h->in = in, h->n = n;
    png_bits(out, 3, 3);  /* the last block, in the fixed code */
    for (size_t i = 0, next = 0; i < n; i++) {
        png_found found = png_find(h, i, i == next);
        if (i < next) continue;
        if (found.length) png_match(out, found.length, found.distance);
        else png_symbol(out, in[i]);
        next = i + (found.length ? found.length : 1);
    }
    png_symbol(out, 256);
    png_bits(out, 0, 7);  /* fills the last byte */
    free(h);
}

/* The differences of a row from Paeth's guess: of the bytes to the left a, above b and above left c
 * the one nearest to a + b - c. Outside the picture all are 0. */
static inline void png_filter(uint8_t *out, const uint8_t *row, const uint8_t *above, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        int a = i < 3 ? 0 : row[i - 3], b = above ? above[i] : 0;
        int c = i < 3 || !above ? 0 : above[i - 3];
        int pa = abs(b - c), pb = abs(a - c), pc = abs(a + b - 2 * c);
        out[i] = (uint8_t)(row[i] - (pa <= pb && pa <= pc ? a : pb <= pc ? b : c));
    }
}

static inline uint32_t png_crc(const uint8_t *p, size_t n)
{
    uint32_t crc = ~0u;
    for (size_t i = 0; i < 8 * n; i++)  /* a factor, not a branch, which would be a toss */
        crc = crc >> 1 ^ ((crc ^ (uint32_t)p[i / 8] >> i % 8) & 1) * 0xedb88320u;
    return ~crc;
}

static inline uint32_t png_adler(const uint8_t *p, size_t n)
{
    uint32_t a = 1, b = 0;
    while (n--) a = (a + *p++) % 65521, b = (b + a) % 65521;
    return b << 16 | a;
}

/* Writes and frees a chunk; b holds its type and data. */
static inline void png_chunk(FILE *out, png_bytes *b)
{
    png_bytes length = {0};
    png_word(&length, (uint32_t)b->n - 4), png_word(b, png_crc(b->at, b->n));
    fwrite(length.at, 1, length.n, out), fwrite(b->at, 1, b->n, out);
    free(length.at), free(b->at);
}

/* Writes to an open stream; rgb holds width * height * 3 bytes, rows from the top. Write errors
 * stay in the stream, for file_commit. Memory: some three times the size of rgb. */
static inline void png_write(FILE *out, const uint8_t *rgb, int width, int height)
{
    size_t stride = 3 * (size_t)width, n = (stride + 1) * (size_t)height;
    uint8_t *raw = allocate(n, 1);
    for (size_t y = 0; y < (size_t)height; y++) {
        const uint8_t *row = rgb + stride * y;
        raw[(stride + 1) * y] = 4;  /* Paeth */
        png_filter(raw + (stride + 1) * y + 1, row, y ? row - stride : NULL, stride);
    }
    png_bytes head = {0}, data = {0}, end = {0};
    png_word(&head, 0x49484452);               /* IHDR */
    png_word(&head, (uint32_t)width), png_word(&head, (uint32_t)height);
    png_word(&head, 0x08020000), png_byte(&head, 0);          /* 8 bits, RGB, no interlace */
    png_word(&data, 0x49444154);               /* IDAT */
    png_byte(&data, 0x78), png_byte(&data, 1);                /* zlib, window 32768 */
    png_deflate(&data, raw, n);
    png_word(&data, png_adler(raw, n));
    png_word(&end, 0x49454e44);                /* IEND */
    fwrite("\x89PNG\r\n\x1a\n", 1, 8, out);
    png_chunk(out, &head), png_chunk(out, &data), png_chunk(out, &end);
    free(raw);
}
#endif
