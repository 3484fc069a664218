/* mtl.h: what stands in Wavefront MTL files (材质库).
 *
 *   newmtl NAME; Kd Ks Ke Tf r [g b]; Ns x; Ni x; d x, d -halo x, Tr x: d = 1 - x; illum n;
 *   our own: absorb r [g b], absorbed inside, per unit of length; priority n, of what overlaps;
 *   roughness x, of glass
 *
 * Source: Wavefront, "Material library file (.mtl)", Advanced Visualizer manual, 1995.
 */
#ifndef MESH_MTL_H
#define MESH_MTL_H

#include "words.h"

typedef enum {
    KEY_KD, KEY_KS, KEY_KE, KEY_TF, KEY_ABSORB, KEY_NS, KEY_NI, KEY_D, KEY_ILLUM, KEY_ROUGHNESS,
    KEY_PRIORITY, material_keys
} material_key;

/* ---------------------------------------------------------------------------------------------- */

enum { mtl_ka = material_keys, mtl_tr, mtl_keys };  /* keywords that set no number of their own */
static const char *const mtl_key_names[mtl_keys] = {
    "Kd", "Ks", "Ke", "Tf", "absorb", "Ns", "Ni", "d", "illum", "roughness", "priority",
    "Ka", "Tr"};

static inline bool mtl_skip(text_reader *t)
{
    text_skip(t);
    return true;
}

static inline int mtl_find(const text_reader *t)
{
    int k = 0;
    while (k < mtl_keys && !text_is(t, mtl_key_names[k])) k++;
    return k;
}

/* Spectral curves and CIE colours are of no use here: *read: false. */
static inline bool mtl_colour(text_reader *t, vec3 *out, bool *read)
{
    *read = !(word_take(t, "spectral") || word_take(t, "xyz"));
    return *read ? word_colour(t, out) : mtl_skip(t);
}

static inline bool mtl_whole(text_reader *t, int *out, int most, const char *allowed)
{
    real n = 0;
    if (!word_number(t, &n, 0, most)) return false;
    *out = (int)n;
    return (real)*out == n || text_bad(t, t->p, "not a whole number before", allowed);
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

#endif
