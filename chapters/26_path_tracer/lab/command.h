/* command.h: one picture as the command line asks for it: scene, goal, where its state goes.
 *
 *   command c = {.scene = NULL};
 *   option own[] = {...};  argc = command_merge(argc, argv, &c);  options o = options_read(...)
 *   if (command_given(&c, &o)) command_run(&c, &o);
 */
#ifndef PATH_COMMAND_H
#define PATH_COMMAND_H

#include "../../../common/lab/report.h"
#include "../../09_aabb/trials/view_work.h"
#include "../../24_direct_light/files/environment_read.h"
#include "../files/long_run.h"
#include "showcase.h"

enum { command_most_parts = 4096, command_most_tests = 1000000000 };  /* of a sample */
static const char command_name[] = "26_path_tracer_render.png";
typedef struct {
    const char *scene, *obj, *up, *sky, *range, *merge;
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
    int kept = 1, words = 0;  /* --merge and what is behind it, so far */
    for (int i = 1; i < argc; i++) {
        bool joined = strncmp(argv[i], "--merge=", 8) == 0;
        if (joined) command_part(c, argv[i] + 8);
        if (strncmp(argv[i], "--", 2) == 0)
            words = joined ? 2 : strcmp(argv[i], "--merge") == 0;
        else if (words > 0) {
            command_part(c, argv[i]);
            if (words++ > 1) continue;
        }
        argv[kept++] = argv[i];
    }
    return kept;
}

static inline bool command_given(const command *c, const options *o)
{
    return c->scene || c->obj || c->up || c->sky || c->range || c->merge || long_run_given(&c->run)
        || c->clamp > 0 || o->samples > 0;
}

/* What a state says of a file. */
static inline unsigned long long command_file(const command *c, const char *path)
{
    bool wanted = path && (c->run.save || c->run.resume);
    return wanted ? long_run_hash(state_hash_start, path) : 0;
}

static inline bool command_z_up(const command *c) { return c->up && strcmp(c->up, "z") == 0; }

static inline const char *command_of(const command *c)
{
    return c->obj ? command_z_up(c) ? "obj, z up" : "obj" : c->scene ? c->scene : "cornell";
}

/* All that a sample depends on, but for its number and the size. file: of the model, all of it. */
static inline void command_settings(command *c, const options *o, unsigned long long file)
{
    snprintf(c->run.settings, state_settings, "scene %.100s\nfile %016llx\nenvironment %016llx\n"
             "clamp %.17g\nreal %s\nseed %llu\n", command_of(c), file,
             command_file(c, c->sky), c->clamp, real_is_float ? "float" : "double",
             (unsigned long long)o->seed);
}

cold_inline void command_scene(const command *c, real aspect, showcase *out)
{
    failure f;
    if (!(c->obj ? showcase_of_obj(c->obj, command_z_up(c), aspect, out, &f)
                 : showcase_of(command_of(c), aspect, out, &f))) fail(f);
    if (c->sky && out->has_sky) environment_free(&out->sky);
    if (c->sky && !environment_read(c->sky, &out->sky, &f)) fail(f);
    out->has_sky = out->has_sky || c->sky;
}

static inline void command_report(const options *o, const film *f, const render_job *j,
                                  const char *name)
{
    table t = table_new("The picture: samples a pixel, and the error that they leave (20.22)",
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
    if (c->up && !c->obj) die(2, "--up is of a mesh: FILE.obj is missing");
    if (c->up && !command_z_up(c) && strcmp(c->up, "y") != 0)
        die(2, "bad value --up %.100s: allowed are y, z", c->up);
    if (c->range && (goal || c->run.resume))
        die(2, "--range does those samples alone: no --samples, --error, --time, --resume");
    if (c->merge && (c->range || goal || c->run.resume || c->scene || c->obj || c->up || c->sky
                     || c->clamp > 0))
        die(2, "--merge puts states together: it takes --save and --out only");
}

static inline bool command_ask(const void *parts, ray r, hit *out, search_work *w)
{
    return bvh8_hit_counted(&((const lit_parts *)parts)->part[0].tree, r, out, w);
}

/* Of a mesh with so many samples, which nobody asked for: fewer where each ray is dear. Where one
 * is too many, the program ends, and says how to ask for it all the same. */
static inline uint32_t command_affords(const command *c, const options *o, const shot *s,
                                       uint32_t samples)
{
    if (!c->obj || c->range) return samples;
    double tests = view_tests(command_ask, s->c.s.parts, s->c.eye, o->width, o->height);
    uint32_t some = (uint32_t)(samples * view_share(tests));
    if (some < 1 && tests * o->width * o->height > command_most_tests)
        die(2, "%.200s: a ray takes %.3g tests, a sample of %d x %d pixels %.2g of them and more: "
            "--samples 1 draws it all the same", c->obj, tests, o->width, o->height,
            tests * o->width * o->height);
    if (some < 1) some = 1;
    if (some < samples)
        printf("# a ray takes %.3g tests: %u samples a pixel instead of %u; --samples asks for "
               "more\n", tests, some, samples);
    return some;
}

cold_inline void command_run(command *c, const options *o)
{
    command_check(c, o);
    if (c->merge) { command_run_merge(c, o); return; }
    long_run *l = &c->run;
    shot s;
    path_options how = path_defaults;
    how.clamp = (real)c->clamp;
    film_range range = c->range ? command_range(c) : (film_range){0, 0};
    unsigned long long file = command_file(c, c->obj);  /* before it is read: perhaps a pipe */
    command_scene(c, (real)o->width / (real)o->height, &s.c);
    command_settings(c, o, file ? file ^ s.c.libraries : 0);
    film f = long_run_begin(l, o, o->width, o->height);
    shot_begin(&s, o, how, f);
    uint32_t samples = o->samples > 0 ? (uint32_t)o->samples
                     : l->error > 0 || l->seconds > 0 ? 0
                     : command_affords(c, o, &s, o->quick ? 4 : 16);
    film_passes *pass = render_passes(&s.j);
    bool whole = c->range ? passes_range(pass, &s.film, range.begin, range.end)
                          : passes_until(pass, &s.film, long_run_goal(l, samples));
    if (whole) command_report(o, &s.film, &s.j, c->obj ? c->obj : command_of(c));
    long_run_end(l, o, &s.film, command_name, whole);
    shot_free(&s);
}

#endif
