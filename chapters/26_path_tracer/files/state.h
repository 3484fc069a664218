/* state.h: a film in a file, to go on later, elsewhere, or to put together from parts.
 *
 *   state_write(path, &f, settings, &why)
 *   state_read(path, &f, settings, &why)       settings: text[state_settings]; "" on entry: takes
 *                                              those of the file; else they must be the same
 *   film_join(&f, &other, &why)                adds the samples of other: exact, so parts = whole
 *
 *   26_path_tracer state 1             text: what it is
 *   scene cornell                      settings: lines `name value`, all that a sample's value
 *   seed 1 ...                         depends on, but for its number
 *   size 600x600
 *   samples 0:64 128:192
 *   (empty line)
 *   low, high, low, ...                64-bit integers, the lowest byte first: the sums of tally.h,
 *                                      for each pixel, half, channel
 *   checksum                           FNV-1a, 64 bits, of all that is before
 *
 * A file that is cut off, damaged or not one of ours: exit 2 and the reason, what was read is
 * dropped. One that can't be opened: exit 1. Written whole or not at all (file.h).
 *
 * Source of FNV-1a: G. Fowler, L. Noll, P. Vo, 1991. It finds accidents, not forgers.
 */
#ifndef PATH_STATE_H
#define PATH_STATE_H

#include "../../20_monte_carlo/film.h"

enum { state_settings = 1024 };
#define state_magic "26_path_tracer state 1\n"

/* ---------------------------------------------------------------------------------------------- */

static inline uint64_t state_hash(uint64_t h, const void *data, size_t n)
{
    const uint8_t *p = data;
    for (size_t i = 0; i < n; i++) h = (h ^ p[i]) * 0x100000001b3u;
    return h;
}
#define state_hash_start 0xcbf29ce484222325u

typedef struct { FILE *to; uint64_t hash; } state_out;

static inline void state_put(state_out *o, const void *data, size_t n)
{
    o->hash = state_hash(o->hash, data, n);
    fwrite(data, 1, n, o->to);
}

static inline void state_word(uint8_t to[8], uint64_t x)
{
    for (int i = 0; i < 8; i++) to[i] = (uint8_t)(x >> 8 * i);
}

static inline uint64_t state_word_of(const uint8_t *from)
{
    uint64_t x = 0;
    for (int i = 0; i < 8; i++) x |= (uint64_t)from[i] << 8 * i;
    return x;
}

static inline bool state_write(const char *path, const film *f, const char *settings, failure *why)
{
    file_writer w;
    char line[64];
    if (!file_begin(&w, path, why)) return false;
    state_out o = {w.stream, state_hash_start};
    state_put(&o, state_magic, strlen(state_magic));
    state_put(&o, settings, strlen(settings));
    int n = snprintf(line, sizeof line, "size %dx%d\nsamples", f->width, f->height);
    state_put(&o, line, (size_t)n);
    for (int i = 0; i < f->ranges; i++) {
        n = snprintf(line, sizeof line, " %lu:%lu", (unsigned long)f->range[i].begin,
                     (unsigned long)f->range[i].end);
        state_put(&o, line, (size_t)n);
    }
    state_put(&o, "\n\n", 2);
    for (size_t i = 0; i < (size_t)f->width * (size_t)f->height; i++) {
        uint8_t bytes[96];
        for (int k = 0; k < 6; k++) {
            const tally *t = &f->half[k / 3][i].of[k % 3];
            state_word(bytes + 16 * k, t->low);
            state_word(bytes + 16 * k + 8, (uint64_t)t->high);
        }
        state_put(&o, bytes, sizeof bytes);
    }
    uint8_t sum[8];
    state_word(sum, o.hash);
    fwrite(sum, 1, sizeof sum, w.stream);
    return file_commit(&w, why);
}

/* Number, then the character `after`; false: something else. */
static inline bool state_number(const char **at, unsigned long most, char after, unsigned long *out)
{
    char *end;
    if (!isdigit((unsigned char)**at)) return false;
    errno = 0;
    *out = strtoul(*at, &end, 10);
    bool ok = errno == 0 && *out <= most && (*end == after || (after == 0 && strchr(" \n", *end)));
    *at = end + (after != 0);
    return ok && *end;
}

/* The lines `size` and `samples`; what follows is at *at. A size that asks for more than n bytes,
 * those of the file, is refused before there is a film of it. */
static inline bool state_header(const char **at, size_t n, film *out)
{
    unsigned long w, h, a, b;
    if (strncmp(*at, "size ", 5) != 0) return false;
    *at += 5;
    if (!state_number(at, 16384, 'x', &w) || !state_number(at, 16384, '\n', &h)) return false;
    if (w == 0 || h == 0 || w > n / 96 / h || strncmp(*at, "samples", 7) != 0) return false;
    *at += 7;
    *out = film_new((int)w, (int)h);
    while (**at == ' ') {
        ++*at;
        if (!state_number(at, UINT32_MAX, ':', &a) || !state_number(at, UINT32_MAX, 0, &b)
            || a >= b || !film_cover(out, (uint32_t)a, (uint32_t)b, NULL))
            return false;
    }
    bool ok = strncmp(*at, "\n\n", 2) == 0;
    *at += 2;
    return ok;
}

/* The first line in which the two differ, for the message. */
static inline bool state_same(const char *path, const char *have, size_t n, const char *want,
                              failure *why)
{
    size_t i = 0, line = 0;
    if (strlen(want) == n && memcmp(have, want, n) == 0) return true;
    for (; i < n && want[i] && have[i] == want[i]; i++)
        if (have[i] == '\n') line = i + 1;
    return failed(why, 2, "%.200s: of another picture: it has '%.*s', not '%.*s'", path,
                  (int)strcspn(have + line, "\n"), have + line,
                  (int)strcspn(want + line, "\n"), want + line);
}

static inline bool state_parse(const char *path, const char *text, size_t n, film *out,
                               char *settings, failure *why)
{
    size_t magic = strlen(state_magic);
    if (n < magic + 8 || memcmp(text, state_magic, magic) != 0)
        return failed(why, 2, "%.300s: not a state of this program (version 1)", path);
    const char *body = text + magic, *size = strstr(body - 1, "\nsize ");
    if (state_word_of((const uint8_t *)text + n - 8) != state_hash(state_hash_start, text, n - 8))
        return failed(why, 2, "%.300s: damaged or cut off: its checksum is wrong", path);
    if (!size || size - body + 2 > state_settings)
        return failed(why, 2, "%.300s: its header is damaged", path);
    size_t length = (size_t)(size + 1 - body);
    const char *at = size + 1;
    if (*settings && !state_same(path, body, length, settings, why)) return false;
    if (!state_header(&at, n, out)) return failed(why, 2, "%.300s: its header is damaged", path);
    size_t pixels = (size_t)out->width * (size_t)out->height;
    if ((size_t)(text + n - at) != 96 * pixels + 8)
        return failed(why, 2, "%.300s: %zu bytes of sums, but %zu belong to its size", path,
                      (size_t)(text + n - at) - 8, 96 * pixels);
    for (size_t i = 0; i < 6 * pixels; i++) {
        const uint8_t *p = (const uint8_t *)at + 16 * i;
        out->half[i % 6 / 3][i / 6].of[i % 3] = (tally){state_word_of(p),
                                                        (int64_t)state_word_of(p + 8)};
    }
    memcpy(settings, body, length), settings[length] = 0;
    return true;
}

static inline bool state_read(const char *path, film *out, char settings[state_settings],
                              failure *why)
{
    size_t n;
    char *text = file_read(path, &n, why);
    *out = (film){.width = 0};
    if (!text) return false;
    bool ok = state_parse(path, text, n, out, settings, why);
    if (!ok) film_free(out);
    free(text);
    return ok;
}

static inline bool film_join(film *to, const film *f, failure *why)
{
    if (to->width != f->width || to->height != f->height)
        return failed(why, 2, "%dx%d pixels do not fit on %dx%d", f->width, f->height, to->width,
                      to->height);
    for (int i = 0; i < f->ranges; i++)
        if (!film_cover(to, f->range[i].begin, f->range[i].end, why)) return false;
    for (size_t i = 0; i < (size_t)f->width * (size_t)f->height; i++)
        for (int k = 0; k < 6; k++)
            tally_join(&to->half[k / 3][i].of[k % 3], &f->half[k / 3][i].of[k % 3]);
    return true;
}

#endif
