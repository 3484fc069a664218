/* file.h: files that are written whole or not at all, and errors that say what went wrong.
 *
 * Whoever calls decides what an error means, so functions that read and write return false and fill
 * in a failure; only main() and options.h end the program.
 *
 *   failure f;
 *   file_writer w;
 *   if (!file_begin(&w, "out.ppm", &f)) fail(f);
 *   fprintf(w.stream, ...);
 *   if (!file_commit(&w, &f)) fail(f);                disk full, device gone: nothing was replaced
 *
 * Exit codes of all programs: 0 done, 1 could not (unreadable file, full disk), 2 misuse or broken
 * input, 130 stopped by Ctrl-C.
 */
#ifndef FILE_H
#define FILE_H

#include "posix.h"
#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct { int exit_code; char text[480]; } failure;
typedef struct { FILE *stream; char *path, *temporary; } file_writer;

/* ---------------------------------------------------------------------------------------------- */

static const char *program_name = "program";  /* set by options.h */

/* Fills in *f [may be NULL] and returns false: a reader ends with `return failed(f, 2, ...)`. */
__attribute__((format(printf, 3, 4)))
static inline bool failed(failure *f, int exit_code, const char *format, ...)
{
    if (!f) return false;
    va_list arguments;
    va_start(arguments, format);
    f->exit_code = exit_code;
    vsnprintf(f->text, sizeof f->text, format, arguments);
    va_end(arguments);
    return false;
}

/* Prints "program: text" on stderr and ends the program with f.exit_code. */
static inline _Noreturn void fail(failure f)
{
    fflush(stdout);
    fprintf(stderr, "%s: %s\n", program_name, f.text);
    exit(f.exit_code);
}

/* malloc(count * size), or the end of the program. */
static inline void *allocate(size_t count, size_t size)
{
    void *p = size && count > SIZE_MAX / size ? NULL : calloc(count ? count : 1, size ? size : 1);
    failure f;
    if (!p) failed(&f, 1, "no memory for %zu times %zu bytes", count, size), fail(f);
    return p;
}

/* An array of n items with room for one more, the rest zero: p, or a copy of twice the size. */
static inline void *grown(void *p, size_t n, size_t *room, size_t size)
{
    if (n < *room) return p;
    void *more = allocate(*room = 2 * *room + 64, size);
    if (n) memcpy(more, p, n * size);
    free(p);
    return more;
}

/* Closes and removes what file_begin began. */
static inline void file_abandon(file_writer *w)
{
    if (w->stream) fclose(w->stream);
    if (w->temporary) unlink(w->temporary);
    free(w->path);
    free(w->temporary);
    *w = (file_writer){NULL, NULL, NULL};
}

/* Opens a temporary file beside `path`. What is there and is no regular file (/dev/stdout, a pipe)
 * is written to directly. False: w holds nothing that needs closing. */
static inline bool file_begin(file_writer *w, const char *path, failure *f)
{
    struct stat there;
    bool exists = stat(path, &there) == 0, regular = exists && S_ISREG(there.st_mode);
    *w = (file_writer){NULL, regular ? realpath(path, NULL) : strdup(path), NULL};  /* links stay */
    if (exists && (!regular || strncmp(path, "/dev/", 5) == 0)) {
        fflush(stdout);  /* /dev/stdout may be where both go */
        w->stream = fopen(path, regular ? "ab" : "wb");
    } else if (w->path) {
        size_t room = strlen(w->path) + 32;
        char *temporary = allocate(room, 1);
        snprintf(temporary, room, "%s.%ld.part", w->path, (long)getpid());
        if ((w->stream = fopen(temporary, "wbx")) != NULL) w->temporary = temporary;
        else free(temporary);
    }
    if (w->stream && w->path) return true;
    failed(f, 1, "%s: cannot write: %s", path, strerror(errno));
    file_abandon(w);
    return false;
}

/* Closes and renames the temporary file to `path`. False: the old file is still there. */
static inline bool file_commit(file_writer *w, failure *f)
{
    bool written = !ferror(w->stream) && fflush(w->stream) == 0;
    written = fclose(w->stream) == 0 && written;
    if (written && w->temporary) written = rename(w->temporary, w->path) == 0;
    if (!written) failed(f, 1, "%s: cannot write: %s", w->path, strerror(errno));
    else free(w->temporary), w->temporary = NULL;
    w->stream = NULL;
    file_abandon(w);
    return written;
}

/* The whole file, with a 0 behind its last byte; NULL if it can't be read. The caller frees. */
static inline char *file_read(const char *path, size_t *size, failure *f)
{
    FILE *in = fopen(path, "rb");
    size_t room = 1 << 16, n = 0, got = 1;
    char *text = in ? malloc(room) : NULL;
    while (text && got > 0) {  /* a pipe does not tell its size, so the array grows by doubling */
        if (n + 1 == room) {
            char *more = realloc(text, room *= 2);
            if (!more) free(text);
            if ((text = more) == NULL) break;
        }
        n += got = fread(text + n, 1, room - 1 - n, in);
    }
    bool ok = text && !ferror(in);
    if (!ok) failed(f, 1, "%s: cannot read: %s", path, strerror(errno)), free(text);
    if (in) fclose(in);
    if (!ok) return NULL;
    text[n] = 0;
    *size = n;
    return text;
}

#endif
