/* special.h: effects_radiance compiled for the sets of effects that matter.
 *
 *   effects_function *f = effects_made_for(mask)     the one with this very set, else the general
 *   vec3 L = f(e, r, in, dice, counts)
 *
 * Each line of EFFECTS_SETS is a copy of the function in which the compiler knows the mask: no test
 * of it is left at run time, no code, no registers for what the scene does not call for.
 */
#ifndef EFFECTS_SPECIAL_H
#define EFFECTS_SPECIAL_H

#include "radiance.h"

typedef vec3 effects_function(const effects_stage *e, ray r, media_set in, const dice *d,
                              effects_counts *c);

/* name, effects */
#define EFFECTS_SETS(X)                                                                          \
    X(cast, EFFECTS_NONE)                                                                        \
    X(plain, EFFECT_HARD_SHADOWS)                                                                \
    X(mirrors, EFFECT_HARD_SHADOWS | EFFECT_MIRROR)                                              \
    X(glass, EFFECT_HARD_SHADOWS | EFFECT_MIRROR | EFFECT_REFRACTION)                            \
    X(coloured_glass, EFFECT_HARD_SHADOWS | EFFECTS_WHITTED)                                     \
    X(soft, EFFECT_SOFT_SHADOWS)                                                                 \
    X(matte_room, EFFECT_SOFT_SHADOWS | EFFECT_INDIRECT)                                         \
    X(glass_room, EFFECT_SOFT_SHADOWS | EFFECT_INDIRECT | EFFECT_MIRROR | EFFECT_REFRACTION)     \
    X(clear_room, EFFECT_SOFT_SHADOWS | EFFECT_INDIRECT | EFFECTS_WHITTED)                       \
    X(room, EFFECT_SOFT_SHADOWS | EFFECT_INDIRECT | EFFECTS_WHITTED | EFFECT_GLOSSY)             \
    X(outdoors, EFFECT_ENVIRONMENT | EFFECT_INDIRECT)

/* ---------------------------------------------------------------------------------------------- */

#define EFFECTS_COMPILED(name, mask)                                                             \
    static vec3 effects_##name(const effects_stage *e, ray r, media_set in, const dice *d,       \
                               effects_counts *c)                                                \
    {                                                                                            \
        return effects_radiance(e, r, in, mask, d, c);                                           \
    }
EFFECTS_SETS(EFFECTS_COMPILED)
EFFECTS_COMPILED(general, e->mask)  /* all other sets, asked at run time */

/* Of depth of field radiance knows nothing: the ray comes from somewhere on the lens. */
static inline effects_function *effects_made_for(unsigned mask)
{
    switch (mask & ~(unsigned)EFFECT_DEPTH_OF_FIELD) {
#define EFFECTS_CASE(name, set) case set: return effects_##name;
    EFFECTS_SETS(EFFECTS_CASE)
    default: return effects_general;
    }
}

#endif
