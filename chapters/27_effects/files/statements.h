/* statements.h: the statements of a scene file, except those that name other files: scene_file.h.
 * What each says, and in which words, is in GRAMMAR.md.
 *
 *   statement q = {.s = &s, .t = &reader, ..};     the reader stands behind the keyword
 *   if (!say_camera(&q)) ..                        false: q.f says what is wrong, and in which line
 */
#ifndef EFFECTS_STATEMENTS_H
#define EFFECTS_STATEMENTS_H

#include "material_list.h"
#include "mtl_studio.h"

typedef struct {
    studio *s;
    text_reader *t;
    cite at;                /* of the statement at hand */
    const char *base;       /* file names are seen from where this file is */
    uint32_t material;      /* of what follows */
    uint32_t described;     /* by lines Kd, Ks ..; name_none: they have no place here */
    studio_palette meshes;  /* names that `mesh` gave, and what they mean */
    int depth;              /* of files that include each other */
    failure *f;
} statement;

/* A word and what follows it: a point, a colour, or a number of that range. */
typedef struct {
    const char *word;
    vec3 *point, *colour;
    real *number;
    double lowest, highest;
    bool said;
} say_word;

/* ---------------------------------------------------------------------------------------------- */

static inline bool say_missing(statement *q, const char *what)
{
    return text_bad(q->t, q->t->p, "something is missing before", what);
}

/* The rest of the line without its comment: # behind a blank. A name may hold blanks. */
static inline bool say_name(statement *q, char name[text_token])
{
    if (!mtl_name(q->t, name)) return false;
    for (char *p = name; *p; p++)
        if ((*p == ' ' || *p == '\t') && p[strspn(p, " \t")] == '#') {
            *p = 0;
            break;
        }
    return true;
}

/* Such words in any order, up to the end of the line. */
static inline bool say_words(statement *q, say_word *w, size_t n, const char *allowed)
{
    text_reader *t = q->t;
    while (text_more(t)) {
        size_t k = 0;
        while (k < n && !word_take(t, w[k].word)) k++;
        if (k == n) return text_bad(t, t->p, "what is", allowed);
        w[k].said = w[k].point ? word_point(t, w[k].point)
                  : w[k].colour ? word_colour(t, w[k].colour)
                                : word_number(t, w[k].number, w[k].lowest, w[k].highest);
        if (!w[k].said) return false;
    }
    return true;
}

static inline bool say_camera(statement *q)
{
    studio_view v = {.given = true, .angle = 40, .said = q->at};
    v.up = (vec3){q->s->up == 0, q->s->up == 1, q->s->up == 2};
    say_word w[] = {{.word = "from", .point = &v.from}, {.word = "at", .point = &v.at},
                    {.word = "up", .point = &v.up},
                    {.word = "angle", .number = &v.angle, .lowest = 1e-3, .highest = 179},
                    {.word = "hither", .number = &v.hither, .highest = 1e30}};
    if (!say_words(q, w, 5, "from, at, up, angle, hither")) return false;
    if (!w[0].said || !w[1].said) return say_missing(q, "from X Y Z at X Y Z");
    q->s->view = v;
    return true;
}

static inline bool say_lens(statement *q)
{
    studio_lens lens = {.said = q->at};
    say_word w[] = {{.word = "radius", .number = &lens.radius, .highest = 1e30},
                    {.word = "focus", .number = &lens.focus, .lowest = 1e-30, .highest = 1e30}};
    if (!say_words(q, w, 2, "radius, focus")) return false;
    if (!w[0].said) return say_missing(q, "radius X");
    q->s->lens = lens;
    return true;
}

/* light at P colour C, sun to P colour C. */
static inline bool say_lamp(statement *q, shade_light_kind kind)
{
    bool point = kind == LIGHT_POINT;
    light l = {kind, {0, 0, 0}, {0, 0, 0}};
    say_word w[] = {{.word = point ? "at" : "to", .point = &l.at},
                    {.word = "colour", .colour = &l.colour},
                    {.word = "color", .colour = &l.colour}};
    if (!say_words(q, w, 3, point ? "at, colour" : "to, colour")) return false;
    if (!w[0].said || !(w[1].said || w[2].said))
        return say_missing(q, point ? "at X Y Z colour C" : "to X Y Z colour C");
    if (!point) l.at = vunit(l.at);
    if (!point && vzero(l.at))
        return text_bad(q->t, q->t->p, "no direction before", "to X Y Z, not all 0");
    studio_add_light(q->s, l, false, q->at);
    return true;
}

static inline bool say_background(statement *q)
{
    return word_colour(q->t, &q->s->sky.background);
}

static inline bool say_up(statement *q)
{
    for (int k = 0; k < 3; k++)
        if (word_take(q->t, (const char *[]){"x", "y", "z"}[k])) return q->s->up = k, true;
    return text_bad(q->t, q->t->p, "no axis:", "x, y, z");
}

static inline bool say_indirect(statement *q)
{
    bool on = word_take(q->t, "on");
    if (!on && !word_take(q->t, "off"))
        return text_bad(q->t, q->t->p, "neither on nor off:", "on, off");
    q->s->indirect = on ? INDIRECT_ON : INDIRECT_OFF, q->s->indirect_said = q->at;
    return true;
}

/* A material of the list, described anew where it is first named. */
static inline bool say_listed(statement *q, const char *name, const char *keys, uint32_t *out)
{
    text_reader t;
    FILE *in = text_in_memory(keys);
    if (!in) return failed(q->f, 1, "%.100s: no memory", name);
    *out = studio_add_material(q->s, name, q->at);
    bool ok = text_begin(&t, in, name, q->f);
    if (ok) {
        while (ok && text_statement(&t)) ok = mtl_studio_key(q->s, &t, *out, q->at);
        ok = text_end(&t) && ok;
    }
    fclose(in);
    studio_palette_add(&q->s->own, name, *out);
    return ok;
}

/* What a name means: of this file, of a library, of the list. */
static inline bool say_named(statement *q, const char *name, uint32_t *out)
{
    uint32_t k = studio_palette_find(&q->s->own, name);
    for (size_t i = 0; k == name_none && i < q->s->libraries; i++)
        k = studio_palette_find(&q->s->library[i].palette, name);
    const char *keys = k == name_none ? material_listed(name) : NULL;
    if (keys && !say_listed(q, name, keys, &k)) return false;
    if (k == name_none)
        return failed(q->f, 2, "%s:%u: %s: no material '%.100s', allowed: names that material or "
                      "mtl gave before, or of the list: white, chrome, glass ..",
                      text_name(q->t), (unsigned)q->at.line, q->t->keyword, name);
    return *out = k, true;
}

static inline bool say_use(statement *q)
{
    char name[text_token];
    if (!say_name(q, name) || !say_named(q, name, &q->material)) return false;
    return q->described = name_none, true;
}

/* The end of a shape's line: what it is made of, if that is said there. */
static inline bool say_made_of(statement *q, uint32_t *out)
{
    char name[text_token];
    *out = q->material;
    if (!text_more(q->t) || word_is_number(q->t)) return true;  /* too much: for others to say */
    return say_name(q, name) && say_named(q, name, out);
}

static inline bool say_material(statement *q)
{
    char name[text_token];
    if (!say_name(q, name)) return false;
    q->material = q->described = studio_add_material(q->s, name, q->at);
    studio_palette_add(&q->s->own, name, q->material);
    return true;
}

static inline bool say_sphere(statement *q)
{
    sphere b;
    uint32_t m;
    if (!word_point(q->t, &b.c) || !word_number(q->t, &b.r, -word_largest, word_largest)
        || !say_made_of(q, &m)) return false;
    studio_add_shape(q->s, shape_of_sphere(b), m);
    return true;
}

static inline bool say_cone(statement *q)
{
    const double most = word_largest;
    cone c;
    uint32_t m;
    if (!word_point(q->t, &c.a) || !word_number(q->t, &c.ra, -most, most)
        || !word_point(q->t, &c.b) || !word_number(q->t, &c.rb, -most, most)
        || !say_made_of(q, &m)) return false;
    studio_add_shape(q->s, shape_of_cone(c), m);
    return true;
}

static inline bool say_polygon(statement *q)
{
    vec3 *v = NULL;
    size_t n = 0, room = 0;
    uint32_t m;
    bool ok = true;
    while (ok && (word_is_number(q->t) || (text_more(q->t) && (*q->t->p == '-' || !n)))) {
        v = grown(v, n, &room, sizeof *v);
        ok = word_point(q->t, &v[n++]);
    }
    if (ok && n < 3) ok = text_bad(q->t, q->t->p, "too few corners before", "3 or more");
    if (ok) ok = say_made_of(q, &m);
    if (ok) studio_add_polygon(q->s, v, n, m);
    free(v);
    return ok;
}

#endif
