/* options.h: the command line, the same in every program.
 *
 *   int samples_per_edge = 8;
 *   option own[] = {{"edge", OPTION_INT, &samples_per_edge, 1, 64, "samples along an edge"}, {0}};
 *   options o = options_read(argc, argv, "02_camera", "Camera rays.",
 *                            (options){.width = 640, .height = 480}, own);
 *
 * Misuse (unknown option, missing or unreadable value, value out of range) ends the program with
 * exit 2 and a message that names the option, the value and what is allowed; --help with exit 0.
 * `--name value` and `--name=value` are the same; of a repeated option the last one counts.
 */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "image_file.h"
#include <math.h>
#include <stdint.h>

typedef struct {
    const char *out;           /* main picture to this file, and no other is drawn */
    const char *csv;           /* the table goes to this file, too */
    int width, height;         /* of the main picture, pixels */
    int samples;               /* a pixel; 0 in the defaults: the program takes no --samples */
    int threads;               /* 0: all cores */
    uint64_t seed;
    bool preview, quick;
} options;

typedef enum {
    OPTION_FLAG, OPTION_INT, OPTION_REAL, OPTION_TEXT, OPTION_SIZE, OPTION_SEED
} option_kind;

typedef struct {
    const char *name;
    option_kind kind;
    void *value;               /* bool, int, double, const char *, int[2], uint64_t */
    double lowest, highest;    /* allowed, both included; of a size: each side */
    const char *what;          /* for --help */
} option;

/* ---------------------------------------------------------------------------------------------- */

static inline const char *option_argument(option_kind kind)
{
    static const char *const names[] = {"", " N", " X", " TEXT", " WxH", " N"};
    return names[kind];
}

static inline void options_help(const char *name, const char *about, const option *lists[2])
{
    printf("%s: %s\n\nusage: %s [options]\n", name, about, name);
    for (int l = 0; l < 2; l++)
        for (const option *o = lists[l]; o && o->name; o++) {
            int n = printf("  --%s%s", o->name, option_argument(o->kind));
            printf("%*s%s", n < 20 ? 20 - n : 1, "", o->what);
            if (o->lowest < o->highest) printf(" [%.9g to %.9g]", o->lowest, o->highest);
            printf("\n");
        }
    exit(0);
}

/* Stores the value of one option; false if it can't be read or is out of range. */
static inline bool option_store(const option *o, const char *text)
{
    char *end = NULL;
    if (o->kind == OPTION_TEXT) { *(const char **)o->value = text; return *text != 0; }
    if (text[0] == 0 || isspace((unsigned char)text[0])) return false;
    if (o->kind == OPTION_SEED) {
        errno = 0;
        *(uint64_t *)o->value = strtoull(text, &end, 10);
        return errno == 0 && *end == 0 && text[0] != '-';
    }
    double x = strtod(text, &end), y = 0;
    bool ok = x >= o->lowest && x <= o->highest && (o->kind == OPTION_REAL || x == floor(x));
    if (o->kind == OPTION_SIZE) {
        if (*end != 'x') return false;
        y = strtod(end + 1, &end);
        ok = ok && y >= o->lowest && y <= o->highest && y == floor(y);
    }
    if (!ok || *end != 0) return false;
    if (o->kind == OPTION_REAL) *(double *)o->value = x;
    else ((int *)o->value)[0] = (int)x;
    if (o->kind == OPTION_SIZE) ((int *)o->value)[1] = (int)y;
    return true;
}

/* The option that a word such as --size or --size=4x3 names, or NULL. */
static inline const option *option_find(const option *lists[2], const char *word)
{
    size_t n = strcspn(word, "=");
    for (int l = 0; l < 2; l++)
        for (const option *o = lists[l]; o && o->name; o++)
            if (strncmp(word, "--", 2) == 0 && n == strlen(o->name) + 2
                && strncmp(word + 2, o->name, n - 2) == 0) return o;
    return NULL;
}

/* Reads the word argv[i] and its value; returns the index of the last argument used. */
static inline int option_read(const option *lists[2], int argc, char **argv, int i)
{
    const char *word = argv[i], *value = strchr(word, '=');
    const option *o = option_find(lists, word);
    failure f;
    if (!o) failed(&f, 2, "unknown option %s (see --help)", word), fail(f);
    if (o->kind == OPTION_FLAG) {
        if (value) failed(&f, 2, "--%s takes no value: %s", o->name, word), fail(f);
        *(bool *)o->value = true;
        return i;
    }
    if (value) value++;
    else if (i + 1 < argc) value = argv[++i];
    else failed(&f, 2, "--%s needs a value (see --help)", o->name), fail(f);
    if (option_store(o, value)) return i;
    static const char *const kinds[] = {
        "", "whole numbers", "numbers", "texts that are not empty", "sizes WxH, each side",
        "whole numbers from 0 to 2^64 - 1"};
    failed(&f, 2, "--%s %s: allowed are %s", o->name, *value ? value : "''", kinds[o->kind]);
    size_t n = strlen(f.text);
    if (o->lowest < o->highest)
        snprintf(f.text + n, sizeof f.text - n, " from %.9g to %.9g", o->lowest, o->highest);
    fail(f);
}

static inline void option_try_file(const char *path)
{
    failure f;
    file_writer w;
    if (path && !file_begin(&w, path, &f)) fail(f);
    if (path) file_abandon(&w);
}

/* Reads the command line. `own` ends with {0} and may be NULL; values not given stay as they are.
 * Files of --out and --csv are tried at once, so that no work is lost in the end. */
static inline options options_read(int argc, char **argv, const char *name, const char *about,
                                   options defaults, const option *own)
{
    options o = defaults;
    bool help = false;
    int size[2] = {o.width, o.height};
    const option common[] = {
        {"out", OPTION_TEXT, &o.out, 0, 0, "main picture to this .png, .ppm, .p3.ppm or .pfm"},
        {"size", OPTION_SIZE, size, 1, 16384, "of the main picture, pixels"},
        {"threads", OPTION_INT, &o.threads, 1, 256, "default: all cores"},
        {"seed", OPTION_SEED, &o.seed, 0, 0, "of the random numbers"},
        {"csv", OPTION_TEXT, &o.csv, 0, 0, "table to this file"},
        {"preview", OPTION_FLAG, &o.preview, 0, 0, "show the main picture in the terminal"},
        {"quick", OPTION_FLAG, &o.quick, 0, 0, "under a second; pictures to build/quick/"},
        {"help", OPTION_FLAG, &help, 0, 0, "this text"},
        {o.samples ? "samples" : NULL, OPTION_INT, &o.samples, 1, 1 << 20, "rays a pixel"}, {0}};
    const option *lists[2] = {own, common};
    failure f;
    program_name = name;
    for (int i = 1; i < argc; i++) i = option_read(lists, argc, argv, i);
    if (help) options_help(name, about, lists);
    if (o.out && !image_can_write(o.out, &f)) fail(f);
    option_try_file(o.out), option_try_file(o.csv);
    o.width = size[0], o.height = size[1];
    return o;
}

#endif
