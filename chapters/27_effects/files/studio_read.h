/* studio_read.h: a whole scene from its file: scene file, OBJ or NFF, by the ending of its name.
 *
 *   if (!studio_read("room.scene", &words, &s, &f)) fail(f);   then s is zeroed
 *   if (!studio_read_text(text, "demo", &words, &s, &f)) ..    a scene file that is in memory
 *
 * `words` [may be NULL] is what the command line says, in the language of scene files: words.light
 * = "at 0 3 0 colour 9; at 1 3 0 colour 5". It is read last and replaces what the files said: one
 * light or sun there, and those of the files are out; messages name it "--light".
 *
 *   include FILE     in a scene file: as if its lines stood here
 *
 * Files nested more than 16 deep, as when a file includes itself on whatever way round, or more
 * than 256 in all: exit code 2.
 */
#ifndef EFFECTS_STUDIO_READ_H
#define EFFECTS_STUDIO_READ_H

#include "finish.h"
#include "scene_file.h"

typedef struct {
    const char *camera, *lens, *light, *sun, *environment, *background, *up, *indirect;
} studio_words;

static inline bool studio_read(const char *path, const studio_words *words, studio *out,
                               failure *f);
static inline bool studio_read_text(const char *text, const char *name, const studio_words *words,
                                    studio *out, failure *f);

/* ---------------------------------------------------------------------------------------------- */

enum { scene_deepest = 16 };

static inline bool scene_read_file(statement *q, FILE *in, const char *path);

/* include FILE, at the keyword. */
static inline bool scene_include(statement *q)
{
    char path[word_longest_path];
    text_reader *t = q->t;
    t->p += strlen(t->keyword = "include");
    if (!scene_path(q, path) || !mtl_line_ends(t)) return false;
    if (q->depth == scene_deepest)  /* also files that include themselves end here */
        return failed(q->f, 2, "%s:%u: include: nested too deep, allowed: %d files", text_name(t),
                      (unsigned)t->line, scene_deepest);
    FILE *in = studio_open(q->s, path, q->f);
    return in && scene_read_file(q, in, path);
}

/* A file that cannot be read: what named it, and in which line, is worth knowing, too. */
static inline void scene_named_at(const text_reader *t, cite at, failure *f)
{
    failure why = *f;
    const char *name = text_name(t);
    if (why.exit_code == 1 && strlen(name) + strlen(why.text) + 16 < sizeof f->text)
        failed(f, 1, "%s:%u: %s", name, (unsigned)at.line, why.text);
}

/* The stream and all that it includes; closes it. */
static inline bool scene_read_file(statement *q, FILE *in, const char *path)
{
    const statement outer = *q;
    uint32_t file = name_add(&q->s->files, path);
    text_reader t;
    bool ok = text_begin(&t, in, path, q->f), begun = ok;
    q->t = &t, q->base = path, q->depth++;
    while (ok && text_statement(&t)) {
        cite at = q->at = (cite){file, (uint32_t)t.line};
        ok = text_is(&t, "include") ? scene_include(q) : scene_statement(q);
        if (!ok) scene_named_at(&t, at, q->f);
    }
    ok = (!begun || text_end(&t)) && ok;
    q->t = outer.t, q->base = outer.base, q->depth--;
    fclose(in);
    return ok;
}

static inline bool scene_read_stream(studio *s, FILE *in, const char *path, failure *f)
{
    statement q = {.s = s, .f = f, .described = name_none};
    bool ok = scene_read_file(&q, in, path);
    studio_palette_free(&q.meshes);
    return ok;
}

static inline bool scene_read_text(studio *s, const char *text, const char *name, failure *f)
{
    FILE *in = text_in_memory(text);
    if (!in) return failed(f, 1, "%.100s: no memory", name);
    return scene_read_stream(s, in, name, f);
}

/* What one option says: its parts between ; are statements that begin with its name. */
static inline bool scene_option(studio *s, const char *keyword, const char *value, failure *f)
{
    if (!value) return true;
    size_t room = strlen(value) * (strlen(keyword) + 2) + 64, n = 0;
    char *text = allocate(room, 1), name[32];
    snprintf(name, sizeof name, "--%s", keyword);
    n += (size_t)snprintf(text, room, "%s ", keyword);
    for (const char *p = value; *p; p++)
        if (*p == ';') n += (size_t)snprintf(text + n, room - n, "\n%s ", keyword);
        else text[n++] = *p;
    bool ok = scene_read_text(s, text, name, f);
    free(text);
    return ok;
}

static inline bool scene_options(studio *s, const studio_words *w, failure *f)
{
    if (w->light || w->sun) s->lights = 0;
    return scene_option(s, "up", w->up, f) && scene_option(s, "camera", w->camera, f)
        && scene_option(s, "lens", w->lens, f) && scene_option(s, "light", w->light, f)
        && scene_option(s, "sun", w->sun, f) && scene_option(s, "background", w->background, f)
        && scene_option(s, "environment", w->environment, f)
        && scene_option(s, "indirect", w->indirect, f);
}

static inline bool scene_ends(const char *path, const char *ending)
{
    size_t n = strlen(path), m = strlen(ending), k = 0;
    while (n > m && k < m && tolower((unsigned char)path[n - m + k]) == ending[k]) k++;
    return n > m && k == m;
}

static inline void studio_begin(studio *s)
{
    *s = (studio){.up = 1};
    name_add(&s->files, "");
    studio_add_material(s, "(default)", (cite){0, 0});
    sky_aim(&s->sky, 1, 0);
}

/* Names come from files: what could hurt a terminal is shown as "?". */
static inline bool studio_end(studio *s, const studio_words *words, bool ok, failure *f)
{
    ok = ok && (!words || scene_options(s, words, f)) && studio_finish(s, f);
    if (ok) return true;
    for (char *p = f ? f->text : NULL; p && *p; p++)
        if ((unsigned char)*p < ' ' || *p == 127) *p = '?';
    studio_free(s);
    return false;
}

static inline bool studio_read(const char *path, const studio_words *words, studio *s, failure *f)
{
    uint32_t m;
    bool ok = true;
    studio_begin(s);
    if (scene_ends(path, ".obj")) {
        if ((ok = obj_mesh(s, path, false, &m, f)))
            studio_place(s, m, affine_scaling((vec3){1, 1, 1}), 0, (cite){s->paint[m].file, 0});
    } else if (scene_ends(path, ".nff")) {
        s->up = 2;
        ok = nff_studio(s, path, 0, f);
    } else {
        FILE *in = word_open(path, true, f);  /* a pipe, too */
        ok = in && scene_read_stream(s, in, path, f);
    }
    return studio_end(s, words, ok, f);
}

static inline bool studio_read_text(const char *text, const char *name, const studio_words *words,
                                    studio *s, failure *f)
{
    studio_begin(s);
    return studio_end(s, words, scene_read_text(s, text, name, f), f);
}

#endif
