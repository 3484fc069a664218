/* words.h: values in text files, with their ranges: over text.h.
 *
 *   word_number(t, &x, lowest, highest)   one number; else "..., allowed: 0 to 1"
 *   word_colour(t, &c)                    one number, grey, or three; none negative
 *   word_point(t, &p)                     three numbers
 *   word_is_number(t)                     does the next token of this line begin as a number does?
 *   word_take(t, "from")                  true, and past it, if that is the next token of this line
 *   word_more(t)                          text_more, but goes on to the next lines: NFF
 *   word_path(base, name, path)           `name` as seen from the directory of the file `base`
 *   word_open(path, any, f)               a file to read from; a directory or none: NULL, exit 1.
 *                                         Not `any`: no pipes and devices, which may have no end
 *
 * What fails sets the failure of the reader, with file, line and keyword.
 */
#ifndef MESH_WORDS_H
#define MESH_WORDS_H

#include "../../../common/numbers/text.h"

enum { word_longest_path = 4096 };

/* ---------------------------------------------------------------------------------------------- */

static inline bool word_is_number(text_reader *t)
{
    double x;
    return text_more(t) && decimal_read(t->p, &x);
}

static inline bool word_take(text_reader *t, const char *word)
{
    if (!text_more(t) || !text_is(t, word)) return false;
    t->p += strlen(word);
    return true;
}

static inline bool word_more(text_reader *t)
{
    while (!text_more(t)) {
        if (*t->p == '#') text_skip(t);
        if (text_finished(t)) return false;
        text_next_line(t);
    }
    return true;
}

/* The comparison is written so that a NaN would fail. */
static inline bool word_number(text_reader *t, real *out, double lowest, double highest)
{
    real x = 0;
    if (!text_more(t)) return text_bad(t, t->p, "no number before", "a number");
    const char *start = t->p;
    double exact;
    const char *stop = decimal_read(start, &exact);
    /* Asked of the double: a number just outside may round to the border in float. */
    if (stop && text_ends_token(*stop) && !(exact >= lowest && exact <= highest)) {
        char allowed[64];
        snprintf(allowed, sizeof allowed, "%g to %g", lowest, highest);
        return text_bad(t, start, "out of range:", allowed);
    }
    if (!text_number(t, &x)) return false;
    *out = x;
    return true;
}

#define word_largest (real_is_float ? (double)FLT_MAX : DBL_MAX)

static inline bool word_point(text_reader *t, vec3 *out)
{
    const double most = word_largest;
    return word_number(t, &out->x, -most, most) && word_number(t, &out->y, -most, most)
        && word_number(t, &out->z, -most, most);
}

/* Up to 1e30, so that products of a few stay finite in float, too. */
static inline bool word_colour(text_reader *t, vec3 *out)
{
    if (!word_number(t, &out->x, 0, 1e30)) return false;
    out->y = out->z = out->x;
    if (!word_is_number(t)) return true;
    return word_number(t, &out->y, 0, 1e30) && word_number(t, &out->z, 0, 1e30);
}

static inline bool word_path(const char *base, const char *name, char path[word_longest_path])
{
    const char *slash = strrchr(base, '/');
    size_t n = slash && name[0] != '/' ? (size_t)(slash + 1 - base) : 0;
    if (n + strlen(name) >= word_longest_path) return false;
    memcpy(path, base, n);
    strcpy(path + n, name);
    return true;
}

static inline FILE *word_open(const char *path, bool any, failure *f)
{
    struct stat what;
    if (any || stat(path, &what) != 0 || !S_ISFIFO(what.st_mode)) return file_open(path, f);
    failed(f, 1, "%.300s: cannot read: not a file on a disk", path);
    return NULL;
}

#endif
