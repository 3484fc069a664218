/* statements.h: the statements of a scene file, except those that name other files.
 *
 *   camera      from P at P [up P] [angle DEGREES] [hither X]
 *   lens        radius X [focus X]             thin lens; focus: distance, else that of `at`
 *   light       at P colour C                  point light, intensity [W/sr]
 *   sun         to P colour C                  light from there, irradiance [W/m^2]
 *   background  C                              seen where nothing is; lights nobody
 *   up          x | y | z
 *   indirect    on | off                   light that matte surfaces pass on: plan.h
 *   use         NAME                           material of what follows: material_list.h has some
 *   sphere      P radius [NAME]                made of NAME
 *   cone        P radius P radius [NAME]       open; equal radii: a cylinder
 *   polygon     P P P ... [NAME]
 *
 * P: three numbers; C: one (grey) or three, not negative. More in scene_file.h.
 */
#ifndef EFFECTS_STATEMENTS_H
#define EFFECTS_STATEMENTS_H

#include "material_list.h"
#include "mtl.h"

typedef struct {
    studio *s;
    text_reader *t;
    cite at;              /* of the statement at hand */
    const char *base;     /* file names are seen from where this file is */
    uint32_t material;    /* of what follows */
    uint32_t described;   /* by lines Kd, Ks ..; name_none: they have no place here */
    name_table shapes;    /* names that `mesh` gave, */
    uint32_t *shape;      /* [shapes.n] and the meshes they mean */
    size_t shape_room;
    failure *f;
} statement;

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

static inline bool say_camera(statement *q)
{
    text_reader *t = q->t;
    studio_view v = {.given = true, .angle = 40, .said = q->at};
    bool from = false, at = false, ok = true;
    v.up = (vec3){q->s->up == 0, q->s->up == 1, q->s->up == 2};
    while (ok && text_more(t)) {
        if (word_take(t, "from")) ok = from = word_point(t, &v.from);
        else if (word_take(t, "at")) ok = at = word_point(t, &v.at);
        else if (word_take(t, "up")) ok = word_point(t, &v.up);
        else if (word_take(t, "angle")) ok = word_number(t, &v.angle, 1e-3, 179);
        else if (word_take(t, "hither")) ok = word_number(t, &v.hither, 0, 1e30);
        else return text_bad(t, t->p, "what is", "from, at, up, angle, hither");
    }
    if (!ok) return false;
    if (!from || !at) return say_missing(q, "from X Y Z at X Y Z");
    q->s->view = v;
    return true;
}

static inline bool say_lens(statement *q)
{
    text_reader *t = q->t;
    studio_lens lens = {.said = q->at};
    bool radius = false, ok = true;
    while (ok && text_more(t)) {
        if (word_take(t, "radius")) ok = radius = word_number(t, &lens.radius, 0, 1e30);
        else if (word_take(t, "focus")) ok = word_number(t, &lens.focus, 1e-30, 1e30);
        else return text_bad(t, t->p, "what is", "radius, focus");
    }
    if (!ok) return false;
    if (!radius) return say_missing(q, "radius X");
    q->s->lens = lens;
    return true;
}

/* light at P colour C, sun to P colour C. */
static inline bool say_lamp(statement *q, shade_light_kind kind)
{
    text_reader *t = q->t;
    const char *where = kind == LIGHT_POINT ? "at" : "to";
    light l = {kind, {0, 0, 0}, {0, 0, 0}};
    bool at = false, colour = false, ok = true;
    while (ok && text_more(t)) {
        if (word_take(t, where)) ok = at = word_point(t, &l.at);
        else if (word_take(t, "colour") || word_take(t, "color"))
            ok = colour = word_colour(t, &l.colour);
        else return text_bad(t, t->p, "what is", kind == LIGHT_POINT ? "at, colour" : "to, colour");
    }
    if (!ok) return false;
    if (!at || !colour)
        return say_missing(q, kind == LIGHT_POINT ? "at X Y Z colour C" : "to X Y Z colour C");
    if (kind == LIGHT_DIRECTIONAL) {
        l.at = vunit(l.at);
        if (vzero(l.at)) return text_bad(t, t->p, "no direction before", "to X Y Z, not all 0");
    }
    studio_add_light(q->s, l, false, q->at);
    return true;
}

static inline bool say_background(statement *q)
{
    q->s->background_said = q->at;
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
static inline bool say_listed(statement *q, const char *name, uint32_t *out)
{
    const char *keys = material_listed(name);
    text_reader t;
    bool ok = true, known;
    FILE *in = keys ? fmemopen((void *)keys, strlen(keys), "rb") : NULL;  /* it is only read */
    if (!in) return false;
    *out = studio_add_material(q->s, name, q->at);
    if (text_begin(&t, in, name, q->f)) {
        while (ok && text_statement(&t)) ok = mtl_key(q->s, &t, *out, q->at, &known);
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
        k = studio_palette_find(&q->s->library[i], name);
    if (k == name_none && !say_listed(q, name, &k))
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
