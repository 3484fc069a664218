/* output.h: where pictures, plots (lab/report.h) and tables (likewise) go.
 *
 *   name            without options    --quick         --out FILE
 *   main picture    images/            build/quick/    FILE
 *   other pictures  images/            build/quick/    (not drawn)
 *   plots           images/            build/quick/    (not drawn)
 *   *_time.svg      build/             build/quick/    (not drawn)      they differ from run to run
 *   table           stdout, and the file of --csv
 *
 * images/ is for the pictures of the book: with another size, number of samples or seed, or an
 * option of the program's own (o.changed), and if Ctrl-C stopped them, they go to build/. With
 * o.own, which a program sets where its reader draws a model or a scene of their own, so does the
 * main picture, and no other is drawn.
 *
 *   return output_done(&o);    the last line of main: says what was drawn, and where its page is
 *
 * What can't be written ends the program with exit 1; what was finished before stays.
 */
#ifndef OUTPUT_H
#define OUTPUT_H
#include "image.h"
#include "options.h"
#include "parallel.h"

/* ---------------------------------------------------------------------------------------------- */
/* Where `name` goes, its directory made; NULL if it is not wanted. */
static inline const char *output_path(const options *o, const char *name, bool is_main,
                                      char path[512])
{
    bool build = o->quick || o->own || o->changed || ends_with(name, "_time.svg");
    if (o->out) return is_main ? o->out : NULL;
    if (o->own && !is_main) return NULL;
    mkdir(build ? "build" : "images", 0777);  /* if that fails, writing the file says why */
    if (o->quick) mkdir("build/quick", 0777);
    snprintf(path, 512, "%s/%s", o->quick ? "build/quick" : build ? "build" : "images", name);
    return path;
}

/* The pictures that this run has drawn, for its last line. */
static char output_drawn[2048];

static inline void output_note(const char *path)
{
    size_t n = strlen(output_drawn);
    snprintf(output_drawn + n, sizeof output_drawn - n, " %s", path);
}

/* "14_bvh.png", "dir/bunny.obj" -> "14_bvh_bunny.png"; without a model the name as it is. */
static inline const char *picture_name(const char *name, const char *model, char room[512])
{
    if (!model) return name;
    const char *slash = strrchr(model, '/'), *base = slash ? slash + 1 : model;
    const char *dot = strrchr(base, '.'), *ending = strrchr(name, '.');
    int length = dot && dot > base ? (int)(dot - base) : (int)strlen(base);
    snprintf(room, 512, "%.*s_%.*s%s", (int)(ending - name), name, length, base, ending);
    return room;
}

cold_inline int output_done(const options *o)
{
    if (*output_drawn) printf("-> %s\n", output_drawn + 1);
    if (!o->out && !o->own) printf("   the page: chapters/%s/README.md\n", program_name);
    return 0;
}

/* Shows a picture with at most 80 x 25 characters of a terminal, each an upper half block: its
 * colour is a pixel of the upper half, its background one of the lower half. */
static inline void output_preview(const image *im)
{
    int w = im->width, h = im->height, across = w < 80 ? w : 80, down = h * across / w;
    if (down > 50) down = 50, across = 50 * w / h + (50 * w < h);
    down = down < 2 ? 2 : down / 2 * 2;  /* half characters */
    for (int i = 0; i < across * down; i++) {
        int c = i / 2 % across, r = i / 2 / across * 2 + i % 2;
        const float *p = image_pixel(im, c * w / across, r * h / down);
        printf("\033[%d;2;%d;%d;%dm", i % 2 ? 48 : 38, srgb_byte((double)p[0]),
               srgb_byte((double)p[1]), srgb_byte((double)p[2]));
        if (i % 2) printf("\xe2\x96\x80%s", c + 1 == across ? "\033[0m\n" : "");
    }
}

/* Saves (and, with --preview, shows) a picture. `whole` is what parallel_pixels returned: if Ctrl-C
 * stopped it, what there is gets saved, and the program ends with exit 130 (SIGTERM: 143). */
static inline void output_picture(const options *o, const image *im, const char *name, bool is_main,
                                  bool whole)
{
    char room[512];
    failure f;
    sigset_t interrupt, before;
    options to = *o;
    to.changed |= !whole;
    const char *path = output_path(&to, name, is_main, room);
    sigemptyset(&interrupt), sigaddset(&interrupt, SIGINT), sigaddset(&interrupt, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &interrupt, &before);  /* Ctrl-C waits until the file is whole */
    if (path && !image_write(path, im, &f)) fail(f);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    if (path) output_note(path);
    if (o->preview && is_main) output_preview(im);
    if (!whole) die(parallel_stopped(), "stopped; %s holds what there was", path ? path : "-");
}

#endif
