/* long_run.h: a picture that may take long: where it begins, its goal, its state after every pass.
 *
 *   long_run l = {.save = "a.state", .resume = NULL, .error = 0, .seconds = 60};
 *   snprintf(l.settings, ...);                    all that a sample depends on (state.h); of a file
 *                                                 long_run_hash(state_hash_start, path)
 *   film f = long_run_begin(&l, &o, w, h);        new, or as l.resume has it
 *   passes_goal g = long_run_goal(&l, samples);   samples: 0: no end but by error, time, Ctrl-C
 *   ... passes_until: saves after each pass, and shows the picture if o.preview ...
 *   long_run_end(&l, &o, &f, "name.png", whole)   state and picture
 *   const char *why = long_run_doubt(&f)          what sums cannot hold (tally.h), or NULL
 *
 * Same settings and the same number of samples: the same bytes, however often it was stopped.
 * What can't be read or written ends the program. --save may be the file of --resume, but no other
 * that this run has read.
 */
#ifndef PATH_LONG_RUN_H
#define PATH_LONG_RUN_H

#include "../../../common/output.h"
#include "goal.h"
#include "state.h"

typedef struct {
    const char *save, *resume;  /* files; NULL: none */
    double error, seconds;      /* goals; 0: none */
    char settings[state_settings];
    bool preview;
    int lines;                  /* of the picture that is in the terminal */
} long_run;

/* ---------------------------------------------------------------------------------------------- */

static inline bool long_run_given(const long_run *l)
{
    return l->save || l->resume || l->error > 0 || l->seconds > 0;
}

/* h, and all bytes of a file, which somebody else reads, too: a pipe would be empty by then. */
static inline uint64_t long_run_hash(uint64_t h, const char *path)
{
    size_t n;
    failure f;
    struct stat what;
    if (stat(path, &what) == 0 && S_ISFIFO(what.st_mode))
        die(2, "%.200s: --save and the like want a file, no pipe", path);
    char *text = file_read(path, &n, &f);
    if (!text) fail(f);
    h = state_hash(h, text, n), free(text);
    return h;
}

static inline void long_run_save(const long_run *l, const film *f)
{
    failure why;
    if (l->save && !state_write(l->save, f, l->settings, &why)) fail(why);
}

static inline film long_run_begin(long_run *l, const options *o, int width, int height)
{
    film m;
    failure f;
    l->preview = o->preview && isatty(STDOUT_FILENO);
    if (!l->resume) m = film_new(width, height);
    else if (!state_read(l->resume, &m, l->settings, &f)) fail(f);
    if (l->resume && l->save && option_same_file(l->resume, l->save)) file_forget(l->save);
    const char *to[] = {l->save, o->out, o->csv};  /* what has been read by now they must not be */
    for (int k = 0; k < 3; k++)
        if (to[k] && !file_try(to[k], &f)) fail(f);
    if (!l->resume) return m;
    if (m.width != width || m.height != height)
        die(2, "%.200s: of another picture: it has %dx%d pixels, not %dx%d", l->resume, m.width,
            m.height, width, height);
    if (m.ranges != 1 || m.range[0].begin != 0)
        die(2, "%.200s: holds parts, not samples 0 to n: merge them first", l->resume);
    return m;
}

/* After a pass: the state, and the picture in the terminal, over the one before. */
static inline void long_run_shown(const film *f, void *user)
{
    long_run *l = user;
    long_run_save(l, f);
    if (!l->preview) return;
    image im = film_picture(f);
    int w = im.width, h = im.height, across = w < 80 ? w : 80, down = h * across / w;
    down = (down > 50 ? 50 : down < 2 ? 2 : down / 2 * 2) / 2;
    if (l->lines) printf("\033[%dA", l->lines);
    output_preview(&im);
    printf("%llu samples a pixel\033[K\n", (unsigned long long)film_samples(f));
    fflush(stdout);
    l->lines = down + 1;
    image_free(&im);
}

static inline passes_goal long_run_goal(long_run *l, uint32_t samples)
{
    return (passes_goal){samples, l->error, l->seconds, long_run_shown, l};
}

/* A half's sum of 2^44 may hold a sample that was cut to that; what is below 2^-62 is lost. */
static inline const char *long_run_doubt(const film *f)
{
    double most = 0, n = (double)film_samples(f);
    size_t pixels = (size_t)f->width * (size_t)f->height;
    for (size_t k = 0; k < 6 * pixels; k++)
        most = fmax(most, tally_sum(&f->half[0][k / 3].of[k % 3]));
    return most >= 0x1p44 ? "samples brighter than 1.8e+13 are cut to that"
           : most < n * 0x1p-43 ? "no pixel is brighter than 2.3e-13: it is black, or loses digits"
                                : NULL;
}

/* In a terminal long_run_shown has shown the picture already, if all of it was done. */
static inline void long_run_end(long_run *l, const options *o, const film *f, const char *name,
                                bool whole)
{
    options with = *o;
    with.preview = o->preview && !(l->lines > 0 && whole);
    const char *doubt = whole ? long_run_doubt(f) : NULL;
    if (whole) long_run_save(l, f);
    if (doubt) fprintf(stderr, "%s: warning: %s\n", program_name, doubt);
    image im = film_picture(f);
    output_picture(&with, &im, name, true, whole);
    image_free(&im);
}

#endif
