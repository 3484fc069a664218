/* scene_file.h: the statements of a scene file that name files, and the table of all statements.
 *
 *   scene_statement(&q)       q.t stands at the keyword; false: q.f says what is wrong
 *
 * Broken: "FILE:LINE: camera: what is 'x', allowed: from, at ..", exit code 2; a file that cannot
 * be read: 1. What is not of its own material gets the one that was current where the statement
 * stands. Names of files are relative to the file that names them.
 */
#ifndef EFFECTS_SCENE_FILE_H
#define EFFECTS_SCENE_FILE_H

#include "nff_studio.h"
#include "obj_place.h"
#include "statements.h"

/* ---------------------------------------------------------------------------------------------- */

/* The name of a file: a token, or "some words". As seen from here, into path. */
static inline bool scene_path(statement *q, char path[word_longest_path])
{
    char name[word_longest_path];
    size_t n = 0;
    if (!text_more(q->t)) return say_missing(q, "the name of a file");
    const char *p = q->t->p;
    bool quoted = *p == '"';
    p += quoted;
    while (n + 1 < sizeof name && *p && !text_ends_line(*p)
           && (quoted ? *p != '"' : *p != ' ' && *p != '\t')) name[n++] = *p++;
    name[n] = 0;
    if (n == 0 || n + 1 == sizeof name || (quoted && *p++ != '"'))
        return text_bad(q->t, q->t->p, "not the name of a file:", "FILE or \"FILE\"");
    q->t->p += p - q->t->p;
    if (word_path(q->base, name, path)) return true;
    return text_bad(q->t, q->t->p, "a path too long before", text_longest);
}

/* One step of a placing, at its word; *known: false, and nothing was read, if it is none. */
static inline bool scene_step(text_reader *t, affine *next, bool *known)
{
    vec3 v;
    real degrees;
    *known = true;
    if (word_take(t, "move")) {
        if (!word_point(t, &v)) return false;
        *next = affine_translation(v);
    } else if (word_take(t, "turn")) {
        if (!word_point(t, &v) || !word_number(t, &degrees, -1e6, 1e6)) return false;
        v = vunit(v);
        if (vzero(v)) return text_bad(t, t->p, "no axis before", "turn X Y Z DEGREES");
        *next = affine_rotation(v, degrees * (pi / 180));
    } else if (word_take(t, "scale")) {
        if (!word_number(t, &v.x, -1e30, 1e30)) return false;
        v.y = v.z = v.x;
        if (word_is_number(t) && (!word_number(t, &v.y, -1e30, 1e30)
                                  || !word_number(t, &v.z, -1e30, 1e30))) return false;
        if (v.x == 0 || v.y == 0 || v.z == 0)
            return text_bad(t, t->p, "scaled to nothing before", "scale X Y Z, none 0");
        *next = affine_scaling(v);
    } else *known = false;
    return true;
}

/* Steps as long as there are any. */
cold_inline bool scene_steps(statement *q, affine *out)
{
    bool known = true;
    *out = affine_scaling((vec3){1, 1, 1});
    while (text_more(q->t)) {
        affine next = *out;
        if (!scene_step(q->t, &next, &known)) return false;
        if (!known) return true;
        *out = affine_then(*out, next);
        if (!vfinite(out->x) || !vfinite(out->y) || !vfinite(out->z) || !vfinite(out->o))
            return text_bad(q->t, q->t->p, "beyond what numbers hold, before", "smaller places");
    }
    return true;
}

/* Nothing but steps up to the end of the line. */
static inline bool scene_placing(statement *q, affine *out)
{
    if (!scene_steps(q, out)) return false;
    return !text_more(q->t) || text_bad(q->t, q->t->p, "what is", "move, turn, scale");
}

/* box P P: six polygons, seen from outside counter-clockwise, placed. */
static inline bool scene_box(statement *q)
{
    static const uint8_t face[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3},
                                       {0, 2, 3, 1}, {4, 5, 7, 6}};  /* bit 0: far x, 1: y, 2: z */
    vec3 a, b;
    affine place;
    uint32_t m;
    if (!word_point(q->t, &a) || !word_point(q->t, &b) || !scene_steps(q, &place)
        || !say_made_of(q, &m)) return false;
    vec3 lo = vmin(a, b), hi = vmax(a, b);
    bool mirrored_box = vdot(vcross(place.x, place.y), place.z) < 0;
    for (int f = 0; f < 6; f++) {
        vec3 corner[4];
        for (int i = 0; i < 4; i++) {
            int k = face[f][mirrored_box ? 3 - i : i];
            corner[i] = affine_point(place, (vec3){k & 1 ? hi.x : lo.x, k & 2 ? hi.y : lo.y,
                                                   k & 4 ? hi.z : lo.z});
        }
        studio_add_polygon(q->s, corner, 4, m);
    }
    return true;
}

static inline bool scene_obj(statement *q)
{
    char path[word_longest_path];
    affine a;
    uint32_t m;
    if (!scene_path(q, path)) return false;
    bool smooth = word_take(q->t, "smooth");
    if (!scene_placing(q, &a) || !obj_mesh(q->s, path, smooth, &m, q->f)) return false;
    studio_place(q->s, m, a, q->material, q->at);
    return true;
}

static inline bool scene_nff(statement *q)
{
    char path[word_longest_path];
    return scene_path(q, path) && mtl_line_ends(q->t)
        && nff_studio(q->s, path, q->material, q->f);
}

static inline bool scene_mtl(statement *q)
{
    char path[word_longest_path];
    uint32_t library;
    return scene_path(q, path) && mtl_line_ends(q->t) && mtl_studio(q->s, path, &library, q->f);
}

/* One word, 0 behind it. */
static inline bool scene_word(statement *q, char word[64])
{
    size_t n = 0;
    if (!text_more(q->t)) return say_missing(q, "a name");
    while (n < 63 && !text_ends_token(q->t->p[n])) word[n] = q->t->p[n], n++;
    word[n] = 0;
    if (n == 0 || n == 63) return text_bad(q->t, q->t->p, "not a name:", "up to 62 characters");
    return q->t->p += n, true;
}

static inline bool scene_mesh(statement *q)
{
    char name[64], path[word_longest_path];
    uint32_t m;
    if (!scene_word(q, name) || !scene_path(q, path)) return false;
    if (studio_palette_find(&q->meshes, name) != name_none)
        return failed(q->f, 2, "%s:%u: mesh: '%s' is a mesh already, allowed: each name once",
                      text_name(q->t), (unsigned)q->at.line, name);
    bool smooth = word_take(q->t, "smooth");
    if (!mtl_line_ends(q->t) || !obj_mesh(q->s, path, smooth, &m, q->f)) return false;
    studio_palette_add(&q->meshes, name, m);
    return true;
}

static inline bool solid_read(studio_solid *x, const char *text, failure *f)
{
    if (!csg_read(text, &x->e, f)) return false;
    if (csg_build(csg_expression_model(&x->e), (csg_options){0}, &x->c, f)) return true;
    csg_expression_free(&x->e);
    return false;
}

/* solid NAME difference(..): the rest of the line goes to the reader of 06. */
cold_inline bool scene_solid(statement *q)
{
    char name[64], text[text_token];
    studio_solid x = {.at = q->at};
    failure why;
    if (!scene_word(q, name) || !say_named(q, name, &x.material) || !say_name(q, text))
        return false;
    if (!solid_read(&x, text, &why))
        return failed(q->f, 2, "%s:%u: solid: %s", text_name(q->t), (unsigned)q->at.line, why.text);
    studio_grow(q->s, solid, q->s->solids);
    q->s->solid[q->s->solids++] = x;
    return true;
}

static inline bool scene_instance(statement *q)
{
    char name[64];
    affine a;
    if (!scene_word(q, name)) return false;
    uint32_t m = studio_palette_find(&q->meshes, name);
    if (m == name_none)
        return failed(q->f, 2, "%s:%u: instance: no mesh '%s', allowed: names that mesh gave "
                      "before", text_name(q->t), (unsigned)q->at.line, name);
    if (!scene_placing(q, &a)) return false;
    studio_place(q->s, m, a, q->material, q->at);
    return true;
}

/* The first pixel that is no radiance (NaN, negative, too large to be summed); false: none. */
static inline bool scene_bad_pixel(const image *im, int *x, int *y)
{
    size_t n = 3 * (size_t)im->width * (size_t)im->height;
    for (size_t i = 0; i < n; i++)
        if (!(im->rgb[i] >= 0 && im->rgb[i] <= 1e30f)) {
            *x = (int)(i / 3 % (size_t)im->width), *y = (int)(i / 3 / (size_t)im->width);
            return true;
        }
    return false;
}

static inline bool scene_picture(statement *q, effects_sky *out)
{
    char path[word_longest_path];
    real turn = 0;
    struct stat what;
    image im = {0, 0, NULL};
    int x, y;
    if (!scene_path(q, path)) return false;
    out->scale = 1;
    say_word w[] = {{.word = "scale", .number = &out->scale, .highest = 1e30},
                    {.word = "turn", .number = &turn, .lowest = -1e6, .highest = 1e6}};
    if (!say_words(q, w, 2, "scale, turn")) return false;
    if (q->s->files_read++ >= studio_most_files)
        return failed(q->f, 2, "%.300s: too many files, allowed: %d", path, studio_most_files);
    if (stat(path, &what) == 0 && !S_ISREG(what.st_mode) && !S_ISDIR(what.st_mode))
        return failed(q->f, 1, "%.300s: cannot read: not a file on a disk", path);
    if (!image_read(path, &im, q->f)) return false;
    name_add(&q->s->files, path);
    bool bad = scene_bad_pixel(&im, &x, &y);
    if (bad) failed(q->f, 2, "%.300s: pixel %d %d: no light, allowed: 0 to 1e+30", path, x, y);
    bool shines = !bad && out->scale > 0 && environment_of_image(&im, &out->picture, NULL);
    out->kind = shines ? SKY_IMAGE : SKY_CONSTANT;  /* black everywhere */
    image_free(&im);
    if (bad) return false;
    sky_aim(out, q->s->up, turn);
    return true;
}

static inline bool scene_environment(statement *q)
{
    effects_sky now = {.background = q->s->sky.background};
    real c[6];
    int n = 0;
    if (!text_more(q->t)) return say_missing(q, "a colour, two, or a picture");
    if (!word_is_number(q->t) && *q->t->p != '-') {
        if (!scene_picture(q, &now)) return false;
    } else {
        while (n < 6 && text_more(q->t))
            if (!word_number(q->t, &c[n++], 0, 1e30)) return false;
        if (n == 4 || n == 5)
            return text_bad(q->t, q->t->p, "numbers end before", "1, 2, 3 or 6 of them");
        now.kind = n == 1 || n == 3 ? SKY_CONSTANT : SKY_GRADIENT;
        now.low = n < 3 ? (vec3){c[0], c[0], c[0]} : (vec3){c[0], c[1], c[2]};
        now.high = n == 2 ? (vec3){c[1], c[1], c[1]} : n == 6 ? (vec3){c[3], c[4], c[5]} : now.low;
        sky_aim(&now, q->s->up, 0);
    }
    environment_free(&q->s->sky.picture);
    q->s->sky = now, q->s->sky_said = q->at;
    return true;
}

static inline bool say_light(statement *q) { return say_lamp(q, LIGHT_POINT); }
static inline bool say_sun(statement *q) { return say_lamp(q, LIGHT_DIRECTIONAL); }

static const struct { const char *word; bool (*say)(statement *q); } scene_statements[] = {
    {"camera", say_camera}, {"lens", say_lens}, {"light", say_light}, {"sun", say_sun},
    {"background", say_background}, {"environment", scene_environment}, {"up", say_up},
    {"indirect", say_indirect},
    {"material", say_material}, {"use", say_use}, {"sphere", say_sphere}, {"cone", say_cone},
    {"polygon", say_polygon}, {"box", scene_box}, {"solid", scene_solid}, {"obj", scene_obj},
    {"nff", scene_nff}, {"mtl", scene_mtl},
    {"mesh", scene_mesh}, {"instance", scene_instance}};

/* One statement, except include. */
static inline bool scene_statement(statement *q)
{
    size_t k = 0, n = sizeof scene_statements / sizeof *scene_statements;
    while (k < n && !text_is(q->t, scene_statements[k].word)) k++;
    if (k < n) {
        q->t->p += strlen(q->t->keyword = scene_statements[k].word);
        return scene_statements[k].say(q) && mtl_line_ends(q->t);
    }
    if (mtl_find(q->t) == mtl_key_words)
        return text_bad(q->t, q->t->p, "begins with", "camera, lens, light, sun, background, "
                        "environment, up, indirect, material, use, sphere, cone, polygon, "
                        "box, solid, obj, nff, mtl, mesh, instance, include, or Kd .. priority");
    if (q->described == name_none)
        return text_bad(q->t, q->t->p, "describes nothing:", "these below a line material NAME");
    return mtl_studio_key(q->s, q->t, q->described, q->at) && mtl_line_ends(q->t);
}

#endif
