/* command.h: one picture as the command line asks for it: scene, goal, where its state goes.
 *
 *   command c = {.samples = -1};
 *   option own[] = {...};  argc = command_merge(argc, argv, &c);  options o = options_read(...)
 *   if (command_given(&c, &o)) command_run(&c, &o);
 */
#ifndef PATH_COMMAND_H
#define PATH_COMMAND_H

#include "../../../common/lab/report.h"
#include "../render.h"
#include "showcase.h"
#include "../state.h"

enum { command_most_parts = 4096 };
typedef struct {
    const char *scene, *obj, *sky, *range, *save, *resume, *merge, *strategy;
    double error, seconds, clamp;
    int bounces;
    const char *part[command_most_parts];
    int parts;
} command;

/* ---------------------------------------------------------------------------------------------- */

static inline void command_part(command *c, const char *path)
{
    if (c->parts == command_most_parts)
        die(2, "--merge takes at most %d files", command_most_parts);
    c->part[c->parts++] = path;
}

/* --merge A B C: takes the words up to the next option out of argv; they go to c->part. */
static inline int command_merge(int argc, char **argv, command *c)
{
    int kept = 1;
    for (int i = 1; i < argc; i++) {
        argv[kept++] = argv[i];
        bool joined = strncmp(argv[i], "--merge=", 8) == 0;
        bool merge = joined || strcmp(argv[i], "--merge") == 0;
        if (joined) command_part(c, argv[i] + 8);
        else if (merge && i + 1 < argc && strncmp(argv[i + 1], "--", 2) != 0)
            command_part(c, argv[kept++] = argv[++i]);
        while (merge && i + 1 < argc && strncmp(argv[i + 1], "--", 2) != 0)
            command_part(c, argv[++i]);
    }
    return kept;
}

static inline bool command_given(const command *c, const options *o)
{
    return c->scene || c->obj || c->sky || c->range || c->save || c->resume || c->merge
        || c->strategy || c->error > 0 || c->seconds > 0 || c->clamp > 0 || c->bounces >= 0
        || o->samples > 0;
}

static inline path_options command_options(const command *c)
{
    path_options p = path_defaults;
    const char *s = c->strategy ? c->strategy : "mis";
    p.mis = strcmp(s, "mis") == 0, p.light_sampling = strcmp(s, "directions") != 0;
    if (!p.mis && p.light_sampling && strcmp(s, "lights") != 0)
        die(2, "--strategy %.200s: allowed are mis, lights, directions", s);
    if (c->bounces >= 0) p.bounces = c->bounces;
    p.clamp = (real)c->clamp;
    return p;
}

static inline uint64_t command_file_hash(const char *path)
{
    size_t n;
    failure f;
    char *text = file_read(path, &n, &f);
    if (!text) fail(f);
    uint64_t h = state_hash(state_hash_start, text, n);
    free(text);
    return h;
}

/* All that a sample depends on, but for its number and the size. */
static inline void command_settings(const command *c, const options *o, char to[state_settings])
{
    const char *name = c->obj ? "obj" : c->scene ? c->scene : "cornell";
    int n = snprintf(to, state_settings, "scene %.100s\n", name);
    if (c->obj) n += snprintf(to + n, state_settings - (size_t)n, "file %016llx\n",
                              (unsigned long long)command_file_hash(c->obj));
    if (c->sky) n += snprintf(to + n, state_settings - (size_t)n, "environment %016llx\n",
                              (unsigned long long)command_file_hash(c->sky));
    snprintf(to + n, state_settings - (size_t)n,
             "strategy %.20s\nbounces %d\nclamp %.17g\nreal %s\nseed %llu\n",
             c->strategy ? c->strategy : "mis", c->bounces, c->clamp,
             real_is_float ? "float" : "double", (unsigned long long)o->seed);
}

static inline void command_scene(const command *c, real aspect, showcase *out)
{
    failure f;
    bool ok = c->obj ? showcase_of_obj(c->obj, aspect, out, &f)
                     : showcase_of(c->scene ? c->scene : "cornell", aspect, out, &f);
    if (!ok) fail(f);
    if (!c->sky) return;
    if (out->has_sky) environment_free(&out->sky);
    if (!environment_read(c->sky, &out->sky, &f)) fail(f);
    out->has_sky = true;
}

static inline void command_report(const options *o, const film *f, const render_job *j,
                                  const char *name)
{
    table t = table_new("The picture: samples a pixel, and the error that they leave (26.7)",
                        "scene|samples|error RMSE [W/m^2/sr]|rays|rays a path|time [s]|rays [M/s]");
    size_t rays = path_rays(&j->counts);
    table_text(&t, "%s", name), table_count(&t, (size_t)film_samples(f));
    if (film_samples(f) > 1) table_number(&t, film_error(f));
    else table_text(&t, "-");
    table_count(&t, rays);
    table_number(&t, j->counts.paths ? (double)rays / (double)j->counts.paths : 0);
    table_number(&t, j->seconds);
    table_number(&t, j->seconds > 0 ? (double)rays / j->seconds * 1e-6 : 0);
    output_table(o, &t);
}

static inline void command_save(const command *c, const film *f, const char *settings)
{
    failure why;
    if (!c->save) return;
    file_forget(c->save);  /* --resume a --save a: goes on in the same file */
    if (!state_write(c->save, f, settings, &why)) fail(why);
}

/* In a terminal command_shown has shown it already, if all of it was done. */
static inline void command_picture(const options *o, const film *f, bool whole, bool shown)
{
    options with = *o;
    with.preview = o->preview && !(shown && whole);
    image im = film_picture(f);
    output_picture(&with, &im, "26_path_tracer_render.png", true, whole);
    image_free(&im);
}

/* No scene is built: the states say it all. */
static inline void command_run_merge(const command *c, const options *o)
{
    film all, part;
    failure f;
    char settings[state_settings] = "";
    if (!state_read(c->part[0], &all, settings, &f)) fail(f);
    for (int i = 1; i < c->parts; i++) {
        if (!state_read(c->part[i], &part, settings, &f)) fail(f);
        if (!film_join(&all, &part, &f)) {
            failure with = f;
            die(2, "%.200s: %.200s", c->part[i], with.text);
        }
        film_free(&part);
    }
    command_save(c, &all, settings);
    render_job none = {.seconds = 0};
    command_report(o, &all, &none, "merged");
    command_picture(o, &all, true, false);
    film_free(&all);
}

typedef struct {
    const command *c;
    const options *o;
    const char *settings;
    int lines;  /* of the picture that is in the terminal */
} command_user;

/* After a pass: the state, and the picture in the terminal, over the one before. */
static inline void command_shown(const film *f, void *user)
{
    command_user *u = user;
    command_save(u->c, f, u->settings);
    if (!u->o->preview || !isatty(STDOUT_FILENO)) return;
    image im = film_picture(f);
    int w = im.width, h = im.height, across = w < 80 ? w : 80, down = h * across / w;
    down = (down > 50 ? 50 : down < 2 ? 2 : down / 2 * 2) / 2;
    if (u->lines) printf("\033[%dA", u->lines);
    output_preview(&im);
    printf("%llu samples a pixel\033[K\n", (unsigned long long)film_samples(f));
    fflush(stdout);
    u->lines = down + 1;
    image_free(&im);
}

static inline film_range command_range(const command *c)
{
    int a, b, used = 0;
    bool ok = sscanf(c->range, "%9d:%9d%n", &a, &b, &used) == 2 && !c->range[used];
    if (!ok || a < 0 || a >= b)
        die(2, "--range %.100s: allowed are A:B, whole numbers 0 <= A < B < 10^9", c->range);
    return (film_range){(uint32_t)a, (uint32_t)b};
}

static inline void command_check(const command *c, const options *o)
{
    bool goal = o->samples > 0 || c->error > 0 || c->seconds > 0;
    if (c->scene && c->obj) die(2, "--scene and --mesh: one of them");
    if (c->range && (goal || c->resume))
        die(2, "--range does those samples alone: no --samples, --error, --time, --resume");
    if (c->merge && (c->range || goal || c->resume || c->scene || c->obj || c->sky || c->strategy
                     || c->clamp > 0 || c->bounces >= 0))
        die(2, "--merge puts states together: it takes --save and --out only");
}

static inline film command_film(const command *c, const options *o, char *settings)
{
    film m;
    failure f;
    if (!c->resume) return film_new(o->width, o->height);
    if (!state_read(c->resume, &m, settings, &f)) fail(f);
    bool from_zero = m.ranges == 1 && m.range[0].begin == 0;
    if (m.width != o->width || m.height != o->height)
        die(2, "%.200s: of another picture: it has %dx%d pixels, not %dx%d", c->resume, m.width,
            m.height, o->width, o->height);
    if (!from_zero)
        die(2, "%.200s: holds parts, not samples 0 to n: merge them first", c->resume);
    return m;
}

static inline void command_run(const command *c, const options *o)
{
    if (c->merge) { command_check(c, o), command_run_merge(c, o); return; }
    char settings[state_settings];
    showcase shown;
    path_tracer t;
    command_check(c, o);
    film_range range = c->range ? command_range(c) : (film_range){0, 0};
    path_options how = command_options(c);
    command_settings(c, o, settings);
    film f = command_film(c, o, settings);
    command_scene(c, (real)o->width / (real)o->height, &shown);
    path_tracer_of(&shown.s, showcase_sky(&shown), how, &t);
    render_job j = {.tracer = &t, .eye = shown.eye, .seed = o->seed, .threads = o->threads};
    command_user user = {c, o, settings, 0};
    uint32_t samples = o->samples > 0 ? (uint32_t)o->samples
                     : c->error > 0 || c->seconds > 0 ? 0 : o->quick ? 4 : 64;
    render_goal goal = {samples, c->error, c->seconds, command_shown, &user};
    bool whole = c->range ? render_range(&j, &f, range.begin, range.end)
                          : render_until(&j, &f, goal);
    if (whole) command_save(c, &f, settings);
    if (whole) command_report(o, &f, &j, c->obj ? c->obj : c->scene ? c->scene : "cornell");
    command_picture(o, &f, whole, user.lines > 0);
    film_free(&f), path_tracer_free(&t), showcase_free(&shown);
}

#endif
