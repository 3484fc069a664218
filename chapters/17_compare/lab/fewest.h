/* fewest.h: of which shapes alone is a structure still wrong? For explain.h: a mistake is easier to
 * find in a structure of two shapes than of a hundred thousand, whoever wrote it.
 *
 *   uint32_t shape[x.n];
 *   size_t n = fewest_of(c, how, &x, r, k, shape)   as few as were found, by rising number; 0: a
 *                                                   structure built anew of all is right
 *
 * Builds it of fewer shapes, asks the ray, and asks brute force. Shape k alone comes first
 * (no_shape: not known). Then a half of all is left out, then quarters, and so on, wherever that
 * leaves the answer wrong, but never shape k; that need not find the very fewest, as patience ends.
 */
#ifndef COMPARE_LAB_FEWEST_H
#define COMPARE_LAB_FEWEST_H

#include "proof.h"

enum { fewest_patience = 30 };  /* builds of the size of all; most are smaller */

/* ---------------------------------------------------------------------------------------------- */

/* Built of these n shapes. */
static inline bool fewest_wrong(const contender *c, const contender_settings *how, const items *x,
                                ray r, const uint32_t *which, size_t n)
{
    failure f;
    wrong_answer w;
    hit due = hit_none;
    mesh m = {.triangles = n};
    scene all = {.n = n};
    shape *one = allocate(n, sizeof *one);
    uint32_t *index = allocate(3 * n, sizeof *index);
    if (x->m) m = *x->m, m.triangles = n, m.index = index;
    else all = *x->s, all.n = n, all.shapes = one;
    for (size_t i = 0; i < n; i++)
        if (x->m) memcpy(index + 3 * i, x->m->index + 3 * (size_t)which[i], 3 * sizeof *index);
        else one[i] = x->s->shapes[which[i]];
    items some = x->m ? items_of_mesh(&m) : items_of_scene(&all);
    items_hit(&some, r, &due);
    void *s = contender_build(c, how, &some, SIZE_MAX, &f);
    bool wrong = s && !prove_ray(c, s, r, due, &w);
    contender_free(c, s);
    free(one), free(index);
    return wrong;
}

static inline size_t fewest_of(const contender *c, const contender_settings *how, const items *x,
                               ray r, uint32_t alone, uint32_t *which)
{
    size_t n = x->n, built = 0, most = fewest_patience * n;
    *which = alone;
    if (alone != no_shape && fewest_wrong(c, how, x, r, which, 1)) return 1;
    uint32_t *fewer = allocate(n, sizeof *fewer);
    for (size_t i = 0; i < n; i++) which[i] = (uint32_t)i;
    if (!fewest_wrong(c, how, x, r, which, n)) n = 0;
    for (size_t part = n / 2; part > 0; part /= 2)
        for (size_t at = 0; at < n && part < n && built < most; built += n) {
            size_t cut = part < n - at ? part : n - at, left = n - cut;
            bool holds = false;
            for (size_t i = at; i < at + cut; i++) holds |= which[i] == alone;
            memcpy(fewer, which, at * sizeof *which);
            memcpy(fewer + at, which + at + cut, (left - at) * sizeof *which);
            if (holds || !fewest_wrong(c, how, x, r, fewer, left)) at += part;
            else memcpy(which, fewer, left * sizeof *which), n = left;
        }
    free(fewer);
    return n;
}

#endif
