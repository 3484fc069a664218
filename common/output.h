/* output.h: where pictures, plots and tables go.
 *
 *   name            without options    --quick         --out FILE
 *   main picture    images/            build/quick/    FILE
 *   other pictures  images/            build/quick/    (not drawn)
 *   plots           images/            build/quick/    (not drawn)
 *   *_time.svg      build/             build/quick/    (not drawn)      they differ from run to run
 *   table           stdout, and the file of --csv
 *
 * What can't be written ends the program with exit 1; what was finished before stays.
 */
#ifndef OUTPUT_H
#define OUTPUT_H

#include "image_file.h"
#include "options.h"
#include "plot.h"
#include "table.h"
#include <sys/utsname.h>

#ifndef BUILD_FLAGS
#define BUILD_FLAGS "not known"  /* the Makefile passes CFLAGS */
#endif

/* ---------------------------------------------------------------------------------------------- */

/* False if `name` is not wanted: --out asks for the main picture alone. Makes the directory. */
static inline bool output_path(const options *o, const char *name, bool is_main, char path[512])
{
    bool timed = ends_with(name, "_time.svg");
    const char *directory = o->quick ? "build/quick" : timed ? "build" : "images";
    if (o->out) snprintf(path, 512, "%s", o->out);
    if (o->out) return is_main;
    if (o->quick) mkdir("build", 0777);
    mkdir(directory, 0777);
    snprintf(path, 512, "%s/%s", directory, name);
    return true;
}

/* The upper half of a cell is a character's colour, the lower half its background. */
static inline void output_preview(const image *im)
{
    int w = im->width, h = im->height, columns = w < 100 ? w : 100;
    int rows = (columns * h / w + 1) / 2;
    for (int i = 0; i < 2 * rows * columns; i++) {
        int half = i % 2, c = i / 2 % columns, r = 2 * (i / 2 / columns) + half;
        int x0 = c * w / columns, x1 = (c + 1) * w / columns, y0 = r * h / (2 * rows);
        int y1 = (r + 1) * h / (2 * rows) > y0 ? (r + 1) * h / (2 * rows) : y0 + 1;
        double sum[3] = {0, 0, 0}, n = (x1 - x0) * (y1 - y0);
        for (int y = y0; y < y1; y++)
            for (int x = x0; x < x1; x++)
                for (int k = 0; k < 3; k++) sum[k] += (double)image_pixel(im, x, y)[k] / n;
        printf("\033[%d;2;%d;%d;%dm", half ? 48 : 38, srgb_byte(sum[0]), srgb_byte(sum[1]),
               srgb_byte(sum[2]));
        if (half) printf(c + 1 == columns ? "\u2580\033[0m\n" : "\u2580");
    }
}

/* Saves (and, with --preview, shows) a picture. `whole` is what parallel_pixels returned: if Ctrl-C
 * stopped it, what there is gets saved, and the program ends with exit 130. */
static inline void output_picture(const options *o, const image *im, const char *name, bool is_main,
                                  bool whole)
{
    char path[512];
    failure f;
    if (output_path(o, name, is_main, path) && !image_write(path, im, &f)) fail(f);
    if (o->preview && is_main) output_preview(im);
    if (!whole) failed(&f, 130, "stopped; %s holds what there was", path), fail(f);
}

static inline void output_plot(const options *o, plot *p, const char *name)
{
    char path[512];
    failure f;
    file_writer w;
    if (output_path(o, name, false, path)) {
        if (!file_begin(&w, path, &f)) fail(f);
        plot_write(p, w.stream);
        if (!file_commit(&w, &f)) fail(f);
    }
    plot_free(p);
}

static inline void output_extra_table(const options *o, table *t)
{
    struct utsname u;
    (void)o;
    printf("# %s\n", t->title);
    if (uname(&u) == 0) printf("# %s %s; ", u.sysname, u.machine);
#ifdef __clang__
    printf("clang %s; ", __clang_version__);
#else
    printf("gcc %s; ", __VERSION__);
#endif
    printf("flags %s; real = %s\n", BUILD_FLAGS, real_is_float ? "float" : "double");
    table_print(t, stdout);
    printf("\n");
    table_free(t);
}

static inline void output_table(const options *o, table *t)
{
    failure f;
    file_writer w;
    if (o->csv) {
        if (!file_begin(&w, o->csv, &f)) fail(f);
        table_csv(t, w.stream);
        if (!file_commit(&w, &f)) fail(f);
    }
    output_extra_table(o, t);
}

#endif
