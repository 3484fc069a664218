/* program.h: a built program seen from outside, and a directory for its files.
 *
 *   mkdtemp(directory)                               main makes it
 *   const char *path = in_directory("g.rays")        good until the fourth call after it
 *   put("a.obj", text), put_bytes("a.rays", bytes, n)               writes a file there
 *   int status = run("17_compare", "--csv @t.csv")   of $BUILD, or of build/; @ is the directory;
 *                                                    -1: it was killed; its output goes to the
 *                                                    files `out` and `err`
 *   int status = shell("cat @a.obj >@b.obj")         likewise
 *   if (printed("err", "--leaf 0")) ...              is that text in one of them?
 *   if (equal_files("a.pfm", "b.pfm")) ...           the same bytes, both there?
 *   remove_directory()                               with all that is in it, at the end
 */
#ifndef PROGRAM_H
#define PROGRAM_H

#include "../common/file.h"
#include <sys/wait.h>

static char directory[] = "/tmp/test_XXXXXX";

/* ---------------------------------------------------------------------------------------------- */

static inline const char *in_directory(const char *name)
{
    static char path[4][256];
    static int next;
    char *p = path[next++ % 4];
    snprintf(p, 256, "%s/%s", directory, name);
    return p;
}

static inline void put_bytes(const char *name, const void *bytes, size_t n)
{
    FILE *out = fopen(in_directory(name), "wb");
    if (!out || fwrite(bytes, 1, n, out) != n || fclose(out) != 0) abort();
}

static inline void put(const char *name, const char *text) { put_bytes(name, text, strlen(text)); }

static inline int shell(const char *command)
{
    char text[2000];
    size_t n = 0;
    for (const char *p = command; *p && n + sizeof directory + 2 < sizeof text; p++)
        if (*p == '@') n += (size_t)snprintf(text + n, sizeof text - n, "%s/", directory);
        else text[n++] = *p;
    text[n] = 0;
    int status = system(text);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static inline int run(const char *program, const char *arguments)
{
    const char *build = getenv("BUILD");
    char command[1400];
    snprintf(command, sizeof command, "%s/%s %s >@out 2>@err", build ? build : "build", program,
             arguments);
    return shell(command);
}

static inline void remove_directory(void)
{
    if (shell("rm -r @") != 0) abort();
}

static inline bool printed(const char *stream, const char *text)
{
    size_t n;
    failure f;
    char *s = file_read(in_directory(stream), &n, &f);
    bool found = s && strstr(s, text);
    free(s);
    return found;
}

static inline bool equal_files(const char *a, const char *b)
{
    size_t n, m;
    failure f;
    char *x = file_read(in_directory(a), &n, &f), *y = file_read(in_directory(b), &m, &f);
    bool equal = x && y && n == m && memcmp(x, y, n) == 0;
    free(x), free(y);
    return equal;
}

#endif
