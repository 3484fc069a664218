/* effects_read.h: what --effects says, as a mask of effect.h.
 *
 *   unsigned mask = called;
 *   if (!effects_read("called,-soft", &mask, &f)) fail(f);   names, all, none, called; -NAME takes
 *                                                            away; from left to right
 */
#ifndef EFFECTS_READ_H
#define EFFECTS_READ_H

#include "../../../common/file.h"
#include "../effect.h"

/* ---------------------------------------------------------------------------------------------- */

/* The mask that a word of n bytes names; false: none. */
static inline bool effect_word(const char *word, size_t n, unsigned called, unsigned *mask)
{
    const struct { const char *name; unsigned mask; } sets[] = {
        {"all", EFFECTS_ALL}, {"none", EFFECTS_NONE}, {"called", called}};
    for (int k = 0; k < 3; k++)
        if (strlen(sets[k].name) == n && strncmp(sets[k].name, word, n) == 0)
            return *mask = sets[k].mask, true;
    for (int k = 0; k < effect_kinds; k++)
        if (strlen(effect_names[k].option) == n && strncmp(effect_names[k].option, word, n) == 0)
            return *mask = 1u << k, true;
    return false;
}

/* *mask is what `called` means, and then the answer. */
static inline bool effects_read(const char *list, unsigned *mask, failure *f)
{
    unsigned sum = 0, one = 0;
    for (const char *p = list;; p++) {
        bool away = *p == '-';
        p += away;
        size_t n = strcspn(p, ",");
        if (!effect_word(p, n, *mask, &one))
            return failed(f, 2, "--effects %.100s: what is '%.*s', allowed: all, none, called, "
                          "hard, soft, mirror, glossy, refraction, absorption, indirect, "
                          "environment, depth; with - before it: without", list,
                          (int)(n < 40 ? n : 40), p);
        sum = away ? sum & ~one : sum | one;
        p += n;
        if (!*p) break;
    }
    return *mask = sum, true;
}

#endif
