/* mtl.h: reads materials from Wavefront MTL files (材质库), statement by statement.
 *
 *   newmtl NAME; Kd Ks Ke Tf r [g b]; Ns x; Ni x; d x, d -halo x, Tr x: d = 1 - x; illum n;
 *   our own: absorb r [g b], absorbed inside, per unit of length; priority n, of what overlaps;
 *   roughness x, of glass
 *
 * Ka is checked and dropped, Ni 0 is taken as 1, all else is skipped; the first texture gives a
 * note. This is the format alone: what the numbers mean for light, 27 says (appearance.h).
 *
 *   mtl_reader r;
 *   if (!mtl_begin(&r, stream, "a.mtl", &f)) return false;
 *   while (mtl_next(&r)) use(&r);      r.said: the statement; r.name, r.material: the material so
 *                                      far, which ends where the next one begins, or the file
 *   return mtl_end(&r);                false and *f if anything went wrong
 *
 *   mtl_key(&t, &m, &said)             a line Kd .. priority for m: scene files have them, too (27)
 *
 * Broken: "FILE:LINE: Kd: not a number: 'x', allowed: finite decimals", exit code 2. Memory: that
 * of text.h, whatever the size of the file.
 *
 * Source: Wavefront, "Material library file (.mtl)", Advanced Visualizer manual, 1995.
 */
#ifndef MESH_MTL_H
#define MESH_MTL_H

#include "words.h"

typedef enum {
    MTL_KD, MTL_KS, MTL_KE, MTL_TF, MTL_ABSORB, MTL_NS, MTL_NI, MTL_D, MTL_ILLUM, MTL_ROUGHNESS,
    MTL_PRIORITY, mtl_keys,                    /* these say something that is kept */
    MTL_KA = mtl_keys, MTL_TR, mtl_key_words,  /* what else is read: nothing is kept; d */
    MTL_NEWMTL, MTL_NOTHING
} mtl_keyword;

typedef struct {
    vec3 kd, ks, ke, tf;       /* matte, specular, emitted [W/m^2/sr], transmitted: >= 0 */
    vec3 absorb;               /* per unit of length inside, >= 0 (Beer) */
    real ns, ni, d;            /* exponent [0, 1e9], refractive index [.001, 10], 1 opaque .. 0 */
    int illum;                 /* 0 to 10; -1: not said */
    real roughness;            /* of glass [0, 1]; 0: smooth */
    int priority;              /* 0 to 1000: which of overlapping bodies fills a place */
} mtl_material;

typedef struct {
    mtl_keyword key;           /* MTL_NEWMTL; below mtl_keys: what it said; else MTL_NOTHING */
    size_t line;               /* where it begins */
    char note[300];            /* "FILE:LINE: .." of what was read, but not as it stands; or "" */
} mtl_said;

typedef struct {
    text_reader t;
    mtl_said said;
    mtl_material material;
    char name[text_token];
    bool begun, textures;      /* there was a newmtl, a texture */
} mtl_reader;

/* Of which nothing is said: matte, opaque. */
static const mtl_material mtl_default = {
    .kd = {0.8, 0.8, 0.8}, .tf = {1, 1, 1}, .ns = 1000, .ni = 1, .d = 1, .illum = -1};

/* ---------------------------------------------------------------------------------------------- */

static const char *const mtl_key_names[mtl_key_words] = {
    "Kd", "Ks", "Ke", "Tf", "absorb", "Ns", "Ni", "d", "illum", "roughness", "priority",
    "Ka", "Tr"};

/* Which of them the token at p is; mtl_key_words: none. */
static inline int mtl_find(const text_reader *t)
{
    int k = 0;
    while (k < mtl_key_words && !text_is(t, mtl_key_names[k])) k++;
    return k;
}

/* Spectral curves and CIE colours are of no use here: a note. */
static inline bool mtl_colour(text_reader *t, vec3 *out, mtl_said *said)
{
    if (!word_take(t, "spectral") && !word_take(t, "xyz")) return word_colour(t, out);
    snprintf(said->note, sizeof said->note, "%s:%zu: %s: only r g b is read", text_name(t),
             said->line, t->keyword);
    text_skip(t);
    return true;
}

static inline bool mtl_whole(text_reader *t, int *out, int most, const char *allowed)
{
    real n = 0;
    if (!word_number(t, &n, 0, most)) return false;
    *out = (int)n;
    return (real)*out == n || text_bad(t, t->p, "not a whole number before", allowed);
}

static inline bool mtl_number(text_reader *t, mtl_material *m, int key, mtl_said *said)
{
    real n = 0;
    switch (key) {
    case MTL_NS: return word_number(t, &m->ns, 0, 1e9);
    case MTL_ROUGHNESS: return word_number(t, &m->roughness, 0, 1);
    case MTL_D: return word_take(t, "-halo"), word_number(t, &m->d, 0, 1);
    case MTL_TR:
        if (!word_number(t, &n, 0, 1)) return false;
        return m->d = 1 - n, true;
    case MTL_ILLUM: return mtl_whole(t, &m->illum, 10, "0 to 10");
    case MTL_PRIORITY: return mtl_whole(t, &m->priority, 1000, "0 to 1000");
    default:
        if (!word_number(t, &n, 0, 10)) return false;
        if (n > 0 && n < (real)0.000999)
            return text_bad(t, t->p, "too small before", "0.001 to 10");
        if (n == 0)
            snprintf(said->note, sizeof said->note, "%s:%zu: Ni 0 is taken as 1", text_name(t),
                     t->line);
        return m->ni = n > 0 ? n : 1, true;
    }
}

/* At a keyword that mtl_find knows. What may follow on the line is for the caller. */
static inline bool mtl_key(text_reader *t, mtl_material *m, mtl_said *said)
{
    vec3 dropped, *colour[] = {&m->kd, &m->ks, &m->ke, &m->tf, &m->absorb};
    int k = mtl_find(t);
    bool coloured = k < MTL_NS || k == MTL_KA;
    *said = (mtl_said){.key = MTL_NOTHING, .line = t->line};
    t->p += strlen(t->keyword = mtl_key_names[k]);
    if (!(coloured ? mtl_colour(t, k < MTL_NS ? colour[k] : &dropped, said)
                   : mtl_number(t, m, k, said))) return false;
    if (k != MTL_KA && !(coloured && *said->note))
        said->key = k == MTL_TR ? MTL_D : (mtl_keyword)k;
    return true;
}

/* Nothing else may stand on the line. */
static inline bool mtl_line_ends(text_reader *t)
{
    return !text_more(t) || text_bad(t, t->p, "too much:", "the end of the line");
}

static inline bool mtl_name(text_reader *t, char name[text_token])
{
    const char *start = NULL;
    size_t n = 0;
    if (!text_rest(t, &start, &n)) return false;
    memcpy(name, start, n), name[n] = 0;
    return true;
}

/* The keywords of textures begin so. */
static inline bool mtl_texture(const text_reader *t)
{
    return strncmp(t->p, "map_", 4) == 0 || text_is(t, "bump") || text_is(t, "refl")
        || text_is(t, "disp") || text_is(t, "decal") || text_is(t, "norm");
}

static inline bool mtl_statement(mtl_reader *r)
{
    text_reader *t = &r->t;
    r->said = (mtl_said){.key = MTL_NOTHING, .line = t->line};
    if (text_is(t, "newmtl")) {
        t->p += strlen(t->keyword = "newmtl");
        r->said.key = MTL_NEWMTL, r->material = mtl_default, r->begun = true;
        return mtl_name(t, r->name);
    }
    if (mtl_find(t) < mtl_key_words)
        return r->begun ? mtl_key(t, &r->material, &r->said) && mtl_line_ends(t)
            : text_bad(t, t->p, "before the first material:", "newmtl NAME");
    if (r->begun && !r->textures && mtl_texture(t)) {
        snprintf(r->said.note, sizeof r->said.note, "%s:%zu: textures are not read", text_name(t),
                 t->line);
        r->textures = true;
    }
    text_skip(t);
    return true;
}

/* ---- the file ---- */

static inline bool mtl_begin(mtl_reader *r, FILE *in, const char *path, failure *f)
{
    *r = (mtl_reader){.material = mtl_default};
    return text_begin(&r->t, in, path, f);
}

static inline bool mtl_next(mtl_reader *r) { return text_statement(&r->t) && mtl_statement(r); }

static inline bool mtl_end(mtl_reader *r) { return text_end(&r->t); }

#endif
