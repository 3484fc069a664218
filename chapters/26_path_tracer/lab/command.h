/* command.h: one picture as the command line asks for it: scene, goal, where its state goes.
 *
 *   command c = {.scene = NULL};
 *   option own[] = {...};  argc = command_merge(argc, argv, &c);  options o = options_read(...)
 *   if (command_given(&c, &o)) command_run(&c, &o);
 */
#ifndef PATH_COMMAND_H
#define PATH_COMMAND_H

#include "../../../common/lab/report.h"
#include "../long_run.h"
#include "../render.h"
#include "showcase.h"

enum { command_most_parts = 4096 };
static const char command_name[] = "26_path_tracer_render.png";
typedef struct {
    const char *scene, *obj, *sky, *range, *merge, *strategy;
    double clamp;
    long_run run;
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
    return c->scene || c->obj || c->sky || c->range || c->merge || long_run_given(&c->run)
        || c->strategy || c->clamp > 0 || o->samples > 0;
}

static inline path_options command_options(const command *c)
{
    path_options p = path_defaults;
    const char *s = c->strategy ? c->strategy : "mis";
    p.mis = strcmp(s, "mis") == 0, p.light_sampling = strcmp(s, "directions") != 0;
    if (!p.mis && p.light_sampling && strcmp(s, "lights") != 0)
        die(2, "--strategy %.200s: allowed are mis, lights, directions", s);
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
static inline void command_settings(command *c, const options *o)
{
    char *to = c->run.settings;
    const char *name = c->obj ? "obj" : c->scene ? c->scene : "cornell";
    int n = snprintf(to, state_settings, "scene %.100s\n", name);
    if (c->obj) n += snprintf(to + n, state_settings - (size_t)n, "file %016llx\n",
                              (unsigned long long)command_file_hash(c->obj));
    if (c->sky) n += snprintf(to + n, state_settings - (size_t)n, "environment %016llx\n",
                              (unsigned long long)command_file_hash(c->sky));
    snprintf(to + n, state_settings - (size_t)n,
             "strategy %.20s\nclamp %.17g\nreal %s\nseed %llu\n",
             c->strategy ? c->strategy : "mis", c->clamp,
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
    table_number(&t, j->pass.seconds);
    table_number(&t, j->pass.seconds > 0 ? (double)rays / j->pass.seconds * 1e-6 : 0);
    output_table(o, &t);
}

/* No scene is built: the states say it all. */
static inline void command_run_merge(command *c, const options *o)
{
    film all, part;
    failure f;
    char *settings = c->run.settings;
    *settings = 0;
    if (!state_read(c->part[0], &all, settings, &f)) fail(f);
    for (int i = 1; i < c->parts; i++) {
        if (!state_read(c->part[i], &part, settings, &f)) fail(f);
        if (!film_join(&all, &part, &f)) {
            failure with = f;
            die(2, "%.200s: %.200s", c->part[i], with.text);
        }
        film_free(&part);
    }
    render_job none = {.threads = 0};
    command_report(o, &all, &none, "merged");
    long_run_end(&c->run, o, &all, command_name, true);
    film_free(&all);
}

static inline film_range command_range(const command *c)
{
    int a, b, used = 0;
    /* NOLINTNEXTLINE(cert-err34-c): nine digits fit, a tenth is left over */
    bool ok = sscanf(c->range, "%9d:%9d%n", &a, &b, &used) == 2 && !c->range[used];
    if (!ok || a < 0 || a >= b)
        die(2, "--range %.100s: allowed are A:B, whole numbers 0 <= A < B < 10^9", c->range);
    return (film_range){(uint32_t)a, (uint32_t)b};
}

static inline void command_check(const command *c, const options *o)
{
    bool goal = o->samples > 0 || c->run.error > 0 || c->run.seconds > 0;
    if (c->scene && c->obj) die(2, "--scene and --mesh: one of them");
    if (c->range && (goal || c->run.resume))
        die(2, "--range does those samples alone: no --samples, --error, --time, --resume");
    if (c->merge && (c->range || goal || c->run.resume || c->scene || c->obj || c->sky
                     || c->strategy || c->clamp > 0))
        die(2, "--merge puts states together: it takes --save and --out only");
}

static inline void command_run(command *c, const options *o)
{
    if (c->merge) { command_check(c, o), command_run_merge(c, o); return; }
    long_run *l = &c->run;
    showcase shown;
    path_tracer t;
    command_check(c, o);
    film_range range = c->range ? command_range(c) : (film_range){0, 0};
    path_options how = command_options(c);
    command_settings(c, o);
    film f = long_run_begin(l, o, o->width, o->height);
    command_scene(c, (real)o->width / (real)o->height, &shown);
    path_tracer_of(&shown.s, showcase_sky(&shown), how, &t);
    render_job j = {.tracer = &t, .eye = shown.eye, .seed = o->seed, .threads = o->threads};
    uint32_t samples = o->samples > 0 ? (uint32_t)o->samples
                     : l->error > 0 || l->seconds > 0 ? 0 : o->quick ? 4 : 16;
    bool whole = c->range ? render_range(&j, &f, range.begin, range.end)
                          : render_until(&j, &f, long_run_goal(l, samples));
    if (whole) command_report(o, &f, &j, c->obj ? c->obj : c->scene ? c->scene : "cornell");
    long_run_end(l, o, &f, command_name, whole);
    film_free(&f), path_tracer_free(&t), showcase_free(&shown);
}

#endif
