/* file.h: files that are written whole or not at all, and errors that say what went wrong.
 *
 * Functions that read and write return false and fill in a failure, since whoever calls decides
 * what an error means. Only main(), options.h and output.h end the program.
 *
 *   failure f;
 *   file_writer w;
 *   if (!file_begin(&w, "out.ppm", &f)) fail(f);
 *   fprintf(w.stream, ...);                           errors stay in the stream
 *   if (!file_commit(&w, &f)) fail(f);                disk full, device gone: nothing was replaced
 *
 *   FILE *in = file_open("in.obj", &f);               NULL: no such file, a directory, a device
 *   die(2, "--leaf %d: ...", leaf);                   says so, and ends the program
 *
 * What this run has read no output replaces: file_begin refuses it, by device and inode. A state
 * that goes on in the same file says file_forget(path) first. Nor is anything written through a
 * link to what is not there: two outputs that are one file could not be told.
 *
 * Exit codes: 0 done, 1 could not (no such file, full disk, no memory), 2 misuse or broken input,
 * 130 Ctrl-C, 143 SIGTERM.
 */
#ifndef FILE_H
#define FILE_H
#include "posix.h"
#include <ctype.h>
#include <errno.h>
#include <signal.h>
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
enum { file_most_begun = 8 };
static char *volatile file_begun[file_most_begun];  /* temporary files: no end leaves one behind */

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

static inline void file_drop_begun(void)
{
    for (int i = 0; i < file_most_begun; i++)
        if (file_begun[i]) unlink(file_begun[i]);
}

/* The signal ends the program as it would anyway. */
static inline void file_on_signal(int number)
{
    file_drop_begun(), signal(number, SIG_DFL), raise(number);
}

/* Ctrl-C, kill, a closed terminal, a reader that has left (| head), no time left (ulimit -t);
 * unless who started the program has them ignored (nohup). Called by options.h. */
static inline void file_watch_signals(void)
{
    const int ends[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++)
        if (signal(ends[i], file_on_signal) == SIG_IGN) signal(ends[i], SIG_IGN);
}

/* Prints "program: text" on stderr and ends the program with f.exit_code, never with 0. */
static inline _Noreturn void fail(failure f)
{
    fflush(stdout), file_drop_begun();
    fprintf(stderr, "%s: %s\n", program_name, f.text);
    exit(f.exit_code ? f.exit_code : 1);
}

/* Both at once, where there is nobody to decide what the error means. */
#define die(exit_code, ...) \
    do { failure die_; failed(&die_, exit_code, __VA_ARGS__), fail(die_); } while (0)

static char file_last[256];  /* the last file that was opened to be read */

/* count * size bytes, all zero, for free(); or the end of the program, which says what they were
 * for: a file, or the function that calls. Never NULL. */
static inline void *allocate_for(const char *what, size_t count, size_t size)
{
    void *p = calloc(count ? count : 1, size ? size : 1);  /* calloc sees an overflow itself */
    if (!p) die(1, "%.300s: no memory for %zu times %zu bytes", what, count, size);
    return p;
}
#define allocate(count, size) allocate_for(__func__, count, size)

/* An array of n items with room for `more`, the rest zero: p, or a copy of twice the size. */
static inline void *grown_for(const char *what, void *p, size_t n, size_t more, size_t *room,
                              size_t size)
{
    if (n + more <= *room) return p;
    void *copy = allocate_for(what, *room = 2 * *room + more + 63, size);
    if (p) memcpy(copy, p, n * size);
    free(p);
    return copy;
}
#define grown_by(p, n, more, room, size) grown_for(__func__, p, n, more, room, size)
#define grown(p, n, room, size) grown_for(__func__, p, n, 1, room, size)

/* The files that this run has read. */
enum { file_most_read = 256 };
static struct { dev_t device; ino_t inode; } file_read_list[file_most_read];
static int files_read;

/* The number of an open or a named file in the list; -1: not in it. */
static inline int file_read_number(const struct stat *s)
{
    for (int i = 0; i < files_read; i++)
        if (file_read_list[i].device == s->st_dev && file_read_list[i].inode == s->st_ino) return i;
    return -1;
}

static inline void file_forget(const char *path)
{
    struct stat s;
    int i = stat(path, &s) == 0 ? file_read_number(&s) : -1;
    if (i >= 0) file_read_list[i] = file_read_list[--files_read];
}

/* A regular file that this run depends on: no output replaces it. */
static inline void file_keep(const struct stat *s)
{
    if (!S_ISREG(s->st_mode) || file_read_number(s) >= 0 || files_read == file_most_read) return;
    file_read_list[files_read].device = s->st_dev;
    file_read_list[files_read++].inode = s->st_ino;
}

/* Opens a file to read. NULL: none, a directory, or a device, which may never end. */
static inline FILE *file_open(const char *path, failure *f)
{
    struct stat s;
    FILE *in = NULL;
    bool there = stat(path, &s) == 0;
    snprintf(file_last, sizeof file_last, "%s", path);
    if (there && S_ISDIR(s.st_mode)) errno = EISDIR;
    else if (there && !S_ISREG(s.st_mode) && !S_ISFIFO(s.st_mode)
             && strcmp(path, "/dev/null") != 0)
        return failed(f, 1, "%.300s: cannot read: a device, not a file", path), NULL;
    else in = fopen(path, "rb");
    if (in && there) file_keep(&s);
    if (!in) failed(f, 1, "%.300s: cannot read: %s", path, strerror(errno));
    return in;
}

/* In the list of temporary files, `now` in the place of `was`. */
static inline void file_note(const char *was, char *now)
{
    int i = 0;
    while (i < file_most_begun && file_begun[i] != was) i++;
    if (i < file_most_begun) file_begun[i] = now;
}

/* Closes and removes what file_begin began. */
static inline void file_abandon(file_writer *w)
{
    if (w->stream) fclose(w->stream);
    if (w->temporary) unlink(w->temporary), file_note(w->temporary, NULL);
    free(w->path), free(w->temporary);
    *w = (file_writer){NULL, NULL, NULL};
}

/* Opens a temporary file beside `path`. A link stays, the file it leads to is replaced, and keeps
 * its permissions. Devices, pipes and what the shell calls /dev/stdout are written to directly. One
 * writer a path at a time in a process. False: w holds nothing that needs closing. */
static inline bool file_begin(file_writer *w, const char *path, failure *f)
{
    struct stat old;
    bool shell = strncmp(path, "/dev/std", 8) == 0 || strncmp(path, "/dev/fd/", 8) == 0;
    bool exists = stat(path, &old) == 0, direct = exists && (shell || !S_ISREG(old.st_mode));
    *w = (file_writer){NULL, NULL, NULL};
    if (exists && file_read_number(&old) >= 0)
        return failed(f, 2, "%.300s: not replaced: this run has read it", path);
    if (!exists && lstat(path, &old) == 0)  /* another output may have the name it leads to */
        return failed(f, 1, "%.300s: cannot write: a link to what is not there", path);
    w->path = exists && !direct ? realpath(path, NULL) : strdup(path);
    bool may = !exists || access(path, W_OK) == 0;  /* rename would not ask */
    if (may && direct) {
        bool out = strcmp(path, "/dev/stdout") == 0;  /* shares its place in the file with stdout */
        fflush(stdout);
        w->stream = out ? fdopen(dup(STDOUT_FILENO), "ab") : fopen(path, "ab");
    } else if (may && w->path) {
        size_t room = strlen(w->path) + 32;
        w->temporary = allocate(room, 1);
        snprintf(w->temporary, room, "%s.%ld.part", w->path, (long)getpid());
        unlink(w->temporary);  /* left by a dead process of our number */
        file_note(NULL, w->temporary);
        w->stream = fopen(w->temporary, "wbx");
        if (exists && w->stream) (void)fchmod(fileno(w->stream), old.st_mode & 0777);
    }
    if (w->stream) return errno = 0, true;  /* a write that fails will set it: see file_commit */
    failed(f, 1, "%.300s: cannot write: %s", path, strerror(errno));
    return file_abandon(w), false;
}

/* Closes and renames the temporary file to `path`. False: the old file is still there. */
static inline bool file_commit(file_writer *w, failure *f)
{
    bool written = fflush(w->stream) == 0 && !ferror(w->stream);
    if (fclose(w->stream) != 0) written = false;
    w->stream = NULL;
    if (written && w->temporary) written = rename(w->temporary, w->path) == 0;
    if (!written) failed(f, 1, "%.300s: cannot write: %s", w->path, strerror(errno ? errno : EIO));
    else file_note(w->temporary, NULL), free(w->temporary), w->temporary = NULL;
    return file_abandon(w), written;
}

/* Whether file_begin will succeed. A pipe is not tried: to its reader that would be the end. */
static inline bool file_try(const char *path, failure *f)
{
    struct stat old;
    file_writer w = {NULL, NULL, NULL};
    bool ok = (stat(path, &old) == 0 && S_ISFIFO(old.st_mode)) || file_begin(&w, path, f);
    if (ok) file_abandon(&w);
    return ok;
}

#define file_endless "%.300s: no end: 256 MB from a pipe, allowed: a file on a disk"
static size_t file_pipe_most = (size_t)1 << 28;  /* bytes that are read of what may never end */

static inline size_t file_most(FILE *in)
{
    struct stat s;
    return fstat(fileno(in), &s) == 0 && !S_ISREG(s.st_mode) ? file_pipe_most : SIZE_MAX;
}

/* The whole file, with a 0 behind its last byte; NULL if it can't be read. The caller frees. */
static inline char *file_read(const char *path, size_t *size, failure *f)
{
    FILE *in = file_open(path, f);
    size_t room = 0, n = 0, got = 1, most = in ? file_most(in) : 0;
    char *text = NULL;
    while (in && got > 0 && n <= most) {  /* a pipe does not tell its size */
        text = grown_for(path, text, n, 2, &room, 1);
        n += got = fread(text + n, 1, room - 1 - n, in);
    }
    bool ok = in && n <= most && !ferror(in);
    if (in && n > most) failed(f, 2, file_endless, path);
    else if (in && !ok) failed(f, 1, "%.300s: cannot read: %s", path, strerror(errno));
    if (in) fclose(in);
    if (!ok) free(text), text = NULL;
    return *size = n, text;
}
#endif
