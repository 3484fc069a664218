/* options.h: the command line, the same in every program.
 *
 *   int samples_per_edge = 8;
 *   option own[] = {{"edge", OPTION_INT, &samples_per_edge, 1, 64, "samples along an edge"}, {0}};
 *   options o = options_read(argc, argv, "02_camera", "Camera rays.",
 *                            (options){.width = 640, .height = 480}, own);
 *
 * `--name value` and `--name=value` are the same, but a value that begins with -- needs the second
 * form; of a repeated option the last one counts. A word without dashes is the file of the first
 * OPTION_INPUT of the list: `14_bvh knot.obj` is `14_bvh --mesh knot.obj`. An output that is an
 * input, or another output, is refused before anything is drawn. Numbers are decimal (1e3, +5.0).
 * Misuse ends the program with exit 2 and a message that names the option, the value and what is
 * allowed.
 */
#ifndef OPTIONS_H
#define OPTIONS_H
#include "image.h"
#include <limits.h>

typedef struct {
    const char *out;           /* main picture to this file, and no other is drawn */
    const char *csv;           /* the table goes to this file, too */
    int width, height;         /* of the main picture, pixels */
    int samples;               /* a pixel; 0 in the defaults: the program takes no --samples */
    int quick_width, quick_height, quick_samples;  /* the defaults with --quick, if not 0 */
    int threads;               /* 0: all cores */
    uint64_t seed;
    bool preview, quick, full;
    bool own;                  /* set by the program: drawn is not the book's scene: see output.h */
    bool changed;              /* not the book's size, samples or seed, or an option of `own` */
} options;

typedef enum {
    OPTION_FLAG, OPTION_INT, OPTION_REAL, OPTION_TEXT, OPTION_SIZE,
    OPTION_INPUT, OPTION_OUTPUT   /* files to read and to write */
} option_kind;
typedef struct {
    const char *name;
    option_kind kind;
    void *value;               /* bool, int, double, const char *, int[2] */
    double lowest, highest;    /* allowed, both included; of a size: each side; of an input: both
                                  the most files there may be, in an array; 0: one */
    const char *what;          /* for --help */
} option;

/* ---------------------------------------------------------------------------------------------- */
/* What kind of value an option wants: in --help, and in words. */
static const struct { const char *value, *allowed; } option_kinds[] = {
    {"", ""}, {" N", "whole numbers"}, {" X", "numbers"}, {" TEXT", "texts that are not empty"},
    {" WxH", "sizes WxH, each side"}, {" FILE", "names of files"}, {" FILE", "names of files"}};

/* Prints "  --name N          what [1 to 64], default 8". */
static inline void option_help(const option *o)
{
    const void *v = o->value;
    int n = printf("  --%s%s", o->name, option_kinds[o->kind].value);
    printf("%*s%s", n < 20 ? 20 - n : 1, "", o->what);
    if (o->lowest < o->highest) printf(" [%.16g to %.16g]", o->lowest, o->highest);
    double usual = o->kind == OPTION_INT ? *(const int *)v
                   : o->kind == OPTION_REAL ? *(const double *)v : -HUGE_VAL;
    if (usual >= o->lowest) printf(", default %.16g", usual);  /* below: none */
    if (o->kind == OPTION_SIZE && *(const int *)v)
        printf(", default %dx%d", *(const int *)v, ((const int *)v)[1]);
    printf("\n");
}

/* A decimal number and where it ends; not a number: NaN. */
static inline double option_number(const char *text, const char **end)
{
    size_t n = strspn(text, "+-.0123456789eE");  /* strtod itself takes spaces, 0x10, inf, nan */
    char *after;
    double x = strtod(text, &after);
    *end = after;
    return after > text && after <= text + n ? x : (double)NAN;
}

/* Where the name of a file goes: of several the first place that is free, or the last. */
static inline const char **option_place(const option *o)
{
    const char **at = o->value;
    for (int k = 1; o->kind == OPTION_INPUT && k < o->highest && *at; k++) at++;
    return at;
}

/* Stores the value of one option, a file to read once; false: it can't be read, or out of range. */
static inline bool option_store(const option *o, const char *text)
{
    if (o->kind == OPTION_INPUT && *option_place(o))
        die(2, o->highest > 1 ? "%.200s and %.200s: at most %g files"
            : "%.200s and %.200s: one file at a time", *option_place(o), text, o->highest);
    if (o->kind == OPTION_TEXT || o->kind >= OPTION_INPUT)
        return *option_place(o) = text, *text != 0;
    const char *end;
    double x[2] = {option_number(text, &end), 0};
    int n = o->kind == OPTION_SIZE ? 2 : 1;
    if (n == 2 && *end == 'x') x[1] = option_number(end + 1, &end);
    for (int k = 0; k < n; k++)  /* the comparisons are false for a NaN */
        if (!(x[k] >= o->lowest && x[k] <= o->highest)
            || (o->kind != OPTION_REAL && x[k] != floor(x[k]))) return false;
    if (*end != 0) return false;
    if (o->kind == OPTION_REAL) *(double *)o->value = x[0];
    else for (int k = 0; k < n; k++) ((int *)o->value)[k] = (int)x[k];
    return true;
}

/* The option that a word such as --size or --size=4x3 names, or NULL. */
static inline const option *option_find(const option *lists[2], const char *word)
{
    size_t n = strcspn(word, "=");
    if (strncmp(word, "--", 2) != 0) return NULL;
    for (int l = 0; l < 2; l++)
        for (const option *o = lists[l]; o && o->name; o++)
            if (n == strlen(o->name) + 2 && strncmp(word + 2, o->name, n - 2) == 0) return o;
    return NULL;
}

/* The option whose file a word without dashes is, or NULL. */
static inline const option *option_input(const option *own)
{
    while (own && own->kind != OPTION_INPUT) own = own->name ? own + 1 : NULL;
    return own;
}

/* Reads the word argv[i] and its value; returns the index of the last argument used. */
cold_inline int option_read(const option *lists[2], int argc, char **argv, int i)
{
    const char *word = argv[i], *value = strchr(word, '=');
    const option *o = option_find(lists, word);
    char range[64] = "";
    if (!o && word[0] == '-') die(2, "unknown option %.200s (see --help)", word);
    if (!o) o = option_input(lists[0]);
    if (!o) die(2, "%.200s: this program reads no file (see --help)", word);
    if (o->kind == OPTION_INPUT && word[0] != '-' && access(word, F_OK) != 0)
        die(2, "%.300s: no such file, and options begin with -- (see --help)", word);
    if (word[0] != '-') return option_store(o, word), i;
    if (o->kind == OPTION_FLAG) {
        if (value) die(2, "--%s takes no value: %.200s", o->name, word);
        return *(bool *)o->value = true, i;
    }
    if (value) value++;
    else if (i + 1 < argc && strncmp(argv[i + 1], "--", 2) != 0) value = argv[++i];
    if (value && option_store(o, value)) return i;
    if (o->lowest < o->highest)
        snprintf(range, sizeof range, " from %.16g to %.16g", o->lowest, o->highest);
    die(2, "--%s %.200s: allowed are %s%s", o->name, !value ? "needs a value" : *value
        ? value : "''", option_kinds[o->kind].allowed, range);
}

/* What is behind the last / of a name; *folder [PATH_MAX] is what is before it, "." if nothing. */
static inline const char *option_base(const char *path, char *folder)
{
    const char *slash = strrchr(path, '/');
    int n = !slash ? 0 : slash > path ? (int)(slash - path) : 1;
    snprintf(folder, PATH_MAX, "%.*s", slash ? n : 1, slash ? path : ".");
    return slash ? slash + 1 : path;
}

/* Whether two names lead to one file; if it is not there yet, they are one name in one folder. */
static inline bool option_same_file(const char *a, const char *b)
{
    struct stat s, t;
    char folder_a[PATH_MAX], folder_b[PATH_MAX];
    if (stat(a, &s) != 0 && stat(b, &t) != 0) {
        bool same = strcmp(option_base(a, folder_a), option_base(b, folder_b)) == 0;
        if (!same || stat(folder_a, &s) != 0 || stat(folder_b, &t) != 0) return false;
    } else if (stat(a, &s) != 0 || stat(b, &t) != 0 || !S_ISREG(s.st_mode)) return false;
    return s.st_dev == t.st_dev && s.st_ino == t.st_ino;
}

/* Each output is tried at once, so that no work is lost in the end, and is no other file's name. */
static inline void options_check_files(const option *lists[2])
{
    const option *all[64];
    const char *path[64];
    int n = 0;
    failure f;
    for (int l = 0; l < 2; l++)
        for (const option *o = lists[l]; o && o->name && n < 64; o++)
            for (int k = 0; o->kind >= OPTION_INPUT && (k == 0 || k < o->highest) && n < 64; k++) {
                const char *name = ((const char **)o->value)[k];
                if (name) all[n] = o, path[n++] = name;
            }
    for (int i = 0; i < n; i++) {
        if (all[i]->kind != OPTION_OUTPUT) continue;
        for (int k = 0; k < n; k++)
            if (k != i && option_same_file(path[i], path[k])
                && strncmp(path[i], "/dev/", 5) != 0)
                die(2, "--%s %.200s: is the file of --%s", all[i]->name, path[i], all[k]->name);
        if (!file_try(path[i], &f)) fail(f);
    }
}

/* At the end of the program: what a full disk did not take was not said. */
static inline void options_check_stdout(void)
{
    if (fflush(stdout) != 0 || ferror(stdout))
        fprintf(stderr, "%s: standard output: cannot write\n", program_name), _exit(1);
}

/* Reads the command line. `own` ends with {0} and may be NULL; what is not given stays as it is. */
cold_inline options options_read(int argc, char **argv, const char *name, const char *about,
                                   options defaults, const option *own)
{
    options o = defaults;
    bool help = false, quick = false;
    int size[2] = {o.width, o.height}, seed = (int)o.seed;
    const option common[] = {
        {"out", OPTION_OUTPUT, &o.out, 0, 0, "main picture to this .png, .ppm, .p3.ppm or .pfm"},
        {"size", OPTION_SIZE, size, 1, 16384, "of the main picture, pixels"},
        {"threads", OPTION_INT, &o.threads, 1, 256, "at work at once, default all cores"},
        {"seed", OPTION_INT, &seed, 0, INT_MAX, "of the random numbers"},
        {"csv", OPTION_OUTPUT, &o.csv, 0, 0, "table to this file"},
        {"preview", OPTION_FLAG, &o.preview, 0, 0, "show the main picture in the terminal"},
        {"quick", OPTION_FLAG, &o.quick, 0, 0, "under a second; pictures to build/quick/"},
        {"full", OPTION_FLAG, &o.full, 0, 0, "everything: all tables and plots of the page"},
        {"help", OPTION_FLAG, &help, 0, 0, "this text"},
        {o.samples ? "samples" : NULL, OPTION_INT, &o.samples, 1, 1 << 20, "rays a pixel"}, {0}};
    const option *lists[2] = {own, common};
    failure f;
    program_name = name, atexit(options_check_stdout);
    file_watch_signals();
    signal(SIGXFSZ, SIG_IGN);  /* a file over the limit of ulimit -f: an error to report */
    for (int i = 1; i < argc; i++) {
        help = help || strcmp(argv[i], "--help") == 0;
        quick = quick || strcmp(argv[i], "--quick") == 0;
    }
    if (help) {  /* first of all, while the values are the defaults */
        printf("%s: %s\n\nusage: %s %s[options]\n", name, about, name,
               !option_input(own) ? "" : option_input(own)->highest > 1 ? "[FILE ..] " : "[FILE] ");
        for (int l = 0; l < 2; l++)
            for (const option *k = lists[l]; k && k->name; k++) option_help(k);
        exit(0);
    }
    if (quick && o.quick_width) size[0] = o.quick_width, size[1] = o.quick_height;
    if (quick && o.quick_samples) o.samples = o.quick_samples;  /* --samples overrides it below */
    for (int i = 1; i < argc; i++) {
        if (option_find((const option *[2]){own, NULL}, argv[i])) o.changed = true;
        i = option_read(lists, argc, argv, i);
    }
    if (o.out && !image_can_write(o.out, &f)) fail(f);
    options_check_files(lists);
    if (o.quick && o.full) die(2, "--quick and --full: one of them");
    o.width = size[0], o.height = size[1], o.seed = (uint64_t)seed;
    if (o.width != defaults.width || o.height != defaults.height || o.seed != defaults.seed
        || o.samples != defaults.samples) o.changed = true;
    return o;
}
#endif
