/* text.h: reads text files token by token, in little memory, with the line number at hand.
 *
 * A statement is a line: a keyword, then tokens with blanks between them. A \ at the end of a line
 * joins it to the next, # begins a comment. Lines end by LF, CR LF or CR, the last one also by the
 * end of the file, and may be of any length: the file passes through a buffer of 64 KB, once, front
 * to back, so a pipe will do: of 256 MB, as it may never end. Tokens: up to 4095 characters.
 *
 *      buffer            p             end
 *        | already read  | still unread | 0      text_ready keeps a whole token between p and end
 *
 *   text_reader r;
 *   if (!text_begin(&r, stream, "a.obj", &f)) return false;
 *   while (text_statement(&r)) {                     p is at the keyword of the next line
 *       ...                                          r.p += length of the keyword
 *       while (text_more(&r))                        p is at the next token; the line is to be read
 *           if (!text_number(&r, &x)) break;         to its end, or left by text_skip
 *   }
 *   return text_end(&r);                             false and *f if anything went wrong
 *
 *   text_is(&r, "vn")          the token at p is vn
 *   text_rest(&r, &name, &n)   the rest of the line without blanks around it, from name on, n bytes
 *   text_skip(&r)              goes to the end of the line
 *   text_bad(&r, token, what, allowed)   "FILE:LINE: KEYWORD: what 'TOKEN', allowed: ..."
 *   text_grow(...)             makes an array longer
 *   text_in_memory(text)       a stream of it, for text_begin; NULL: no memory; fclose it
 *
 * A number is rounded to the nearest double (decimal.h); in float builds that double is rounded
 * once more, which leaves it within 1/2 + 2^-29 ulp of the text.
 */
#ifndef TEXT_H
#define TEXT_H

#include "decimal.h"
#include "../file.h"
#include <stdint.h>

#define text_longest "up to 4095 characters"
enum {
    text_chunk = 1 << 16,  /* bytes in the buffer: fits the nearest caches */
    text_token = 4096      /* more than any token has: a double written out in full takes 1079 */
};

typedef struct {
    FILE *in;
    const char *name, *keyword;  /* of the file and of the statement, for messages */
    failure *f;
    bool bad;                    /* *f is set */
    size_t line;                 /* from 1 */
    char *buffer, *p, *end;      /* unread: [p, end); *end is 0 */
    bool last;                   /* nothing comes after `end` */
    size_t left;                 /* bytes that may still come; 0: it has no end */
} text_reader;

/* ---------------------------------------------------------------------------------------------- */

static inline bool text_ends_line(char c) { return c == '\n' || c == '\r'; }
static inline bool text_ends_token(char c) { return (unsigned char)c <= ' ' || c == '\\'; }

/* ---- the buffer ---- */

/* Moves what is unread to the front and fills up behind it. */
static inline void text_refill(text_reader *r)
{
    size_t rest = (size_t)(r->end - r->p), wanted = text_chunk - rest;
    memmove(r->buffer, r->p, rest);
    size_t got = fread(r->buffer + rest, 1, wanted, r->in);
    r->p = r->buffer;
    r->end = r->buffer + rest + got;
    *r->end = 0;
    r->left -= got < r->left ? got : r->left;
    r->last = got < wanted || r->left == 0;
}

/* From here on a whole token can be read without asking for the end of the buffer. */
static inline void text_ready(text_reader *r)
{
    if (r->end - r->p < text_token && !r->last) text_refill(r);
}

static inline bool text_finished(const text_reader *r) { return r->p == r->end && r->last; }

/* ---- messages ---- */

static inline const char *text_name(const text_reader *r)  /* the end of a very long path */
{
    size_t n = strlen(r->name);
    return n > 200 ? r->name + n - 200 : r->name;
}

/* Always false. What could hurt a terminal is shown as "?". */
static inline bool text_bad(text_reader *r, const char *token, const char *what,
                            const char *allowed)
{
    char shown[40] = "'";
    size_t n = 0;
    for (; n < 24 && token + n < r->end && (unsigned char)token[n] > ' '; n++)
        shown[n + 1] = (char)((unsigned char)token[n] < 127 ? token[n] : '?');
    strcpy(shown + n + 1, n < 24 ? "'" : "...'");
    if (n == 0)
        snprintf(shown, sizeof shown, token == r->end ? "the end of the file"
                 : text_ends_line(*token) ? "the end of the line"
                 : *token == ' ' || *token == '\t' ? "a blank" : "byte %d", *token);
    r->bad = true;
    return failed(r->f, 2, "%s:%zu: %s: %s %s, allowed: %s", text_name(r), r->line, r->keyword,
                  what, shown, allowed);
}

/* `array` with room for `more` items of `size` bytes behind `count`. It grows by half: little is
 * wasted, and copying costs O(1) an item all the same. NULL: no memory; the old array stays. */
static inline void *text_grow(text_reader *r, void *array, size_t *room, size_t count, size_t more,
                              size_t size)
{
    if (more <= *room - count) return array;
    size_t wanted = count + more + count / 2 + 64;
    void *grown = wanted < SIZE_MAX / size ? realloc(array, wanted * size) : NULL;
    if (grown) *room = wanted;
    else {
        failed(r->f, 1, "%s:%zu: no memory for %zu items", text_name(r), r->line, wanted);
        r->bad = true;
    }
    return grown;
}

/* ---- lines and tokens ---- */

static inline void text_next_line(text_reader *r)
{
    text_ready(r);
    if (r->p[0] == '\r' && r->p[1] == '\n') r->p++;
    r->p += r->p < r->end;
    r->line++;
}

/* Goes to the next token of this line; false at its end or at a comment. */
static inline bool text_more(text_reader *r)
{
    for (;;) {
        text_ready(r);
        char *start = r->p, *p = start;
        while (*p == ' ' || *p == '\t' || *p == '\v' || *p == '\f') p++;
        r->p = p;
        if (r->end - p < text_token && p > start && !r->last) continue;  /* is it all there? */
        if (*p != '\\' || !text_ends_line(p[1]))
            return !text_ends_line(*p) && *p != '#' && p != r->end;
        r->p++;
        text_next_line(r);
    }
}

/* Goes to the end of the line. A comment ends there even behind a \, as in "# C:\models\". */
static inline void text_skip(text_reader *r)
{
    char last = *r->p == '#' ? '#' : 0;
    bool comment = last == '#';
    for (;;) {
        text_ready(r);
        char *p = r->p;
        while (*p && !text_ends_line(*p)) last = *p++;
        r->p = p;
        if (p == r->end && !r->last) continue;
        if (comment || last != '\\' || !text_ends_line(*p)) return;
        text_next_line(r);
        last = 0;
    }
}

static inline bool text_is(const text_reader *r, const char *keyword)
{
    const char *p = r->p;
    while (*keyword && *p == *keyword) p++, keyword++;
    return !*keyword && text_ends_token(*p);
}

/* The name stays where it is until the next call of anything here. */
static inline bool text_rest(text_reader *r, const char **name, size_t *size)
{
    if (!text_more(r)) return text_bad(r, r->p, "no name before", "a name");
    char *p = r->p, *stop = p;
    for (; *p && !text_ends_line(*p); p++)
        if (*p != ' ' && *p != '\t') stop = p + 1;
    if (p - r->p >= text_token) return text_bad(r, r->p, "name too long:", text_longest);
    *name = r->p;
    *size = (size_t)(stop - r->p);
    r->p = p;
    return true;
}

/* Without a buffer of its own: the stream says nothing where there is no memory for that. */
static inline FILE *text_in_memory(const char *text)
{
    size_t n = strlen(text);
    FILE *in = fmemopen((void *)(n ? text : "\n"), n ? n : 1, "rb");  /* it is only read */
    if (in) setvbuf(in, NULL, _IONBF, 0);
    return in;
}

static inline bool text_begin(text_reader *r, FILE *in, const char *name, failure *f)
{
    *r = (text_reader){.in = in, .name = name, .keyword = "line", .f = f, .line = 1};
    r->buffer = r->p = r->end = malloc(text_chunk + 1);
    if (!r->buffer) return failed(f, 1, "%s: no memory", text_name(r));
    r->left = file_most(in);
    text_refill(r);
    if (strncmp(r->p, "\xef\xbb\xbf", 3) == 0) r->p += 3;  /* UTF-8 with a byte order mark */
    return true;
}

/* Ends the statement before, if there is one, and goes to the next. */
static inline bool text_statement(text_reader *r)
{
    r->keyword = "line";
    while (!r->bad && !text_finished(r)) {
        if (text_more(r)) return *r->p ? true : text_bad(r, r->p, "no text:", "text");
        if (*r->p == '#') text_skip(r);
        if (*r->p == 0 && r->p < r->end) return text_bad(r, r->p, "no text:", "text");
        if (!text_finished(r)) text_next_line(r);
    }
    return false;
}

/* A read error, or no end, counts before anything that it may have caused. */
static inline bool text_end(text_reader *r)
{
    if (ferror(r->in)) {
        failed(r->f, 1, "%s: cannot read: %s", text_name(r), strerror(errno));
        r->bad = true;
    }
    if (r->left == 0) r->bad = !failed(r->f, 2, file_endless, text_name(r));
    free(r->buffer);
    r->buffer = NULL;
    return !r->bad;
}

/* ---- numbers ---- */

static inline bool text_number(text_reader *r, real *out)
{
    double x;
    const char *stop = decimal_read(r->p, &x);
    if (!stop || !text_ends_token(*stop))
        return text_bad(r, r->p, "not a number:", "finite decimals");
    if (stop - r->p >= text_token) return text_bad(r, r->p, "number too long:", text_longest);
    *out = (real)x;
    if (!isfinite(*out))
        return text_bad(r, r->p, "too large:", real_is_float ? "up to 3.4e38" : "up to 1.79e308");
    r->p += stop - r->p;
    return true;
}

#endif
