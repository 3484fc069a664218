/* special.h: effects_radiance compiled for the sets of effects that matter.
 *
 *   effects_function *f = effects_made_for(mask)     the one with this very set, else the general
 *   vec3 L = f(e, r, in, dice, counts)
 *
 * Each line below is a copy of the function in which the compiler knows the mask: no test of it is
 * left at run time, no code, no registers for what the scene does not call for.
 */
#ifndef EFFECTS_SPECIAL_H
#define EFFECTS_SPECIAL_H

#include "radiance.h"

typedef vec3 effects_function(const effects_stage *e, ray r, media_set in, const dice *d,
                              effects_counts *c);

/* ---------------------------------------------------------------------------------------------- */

#define EFFECTS_COMPILED(name, mask)                                                             \
    static vec3 name(const effects_stage *e, ray r, media_set in, const dice *d,                 \
                     effects_counts *c)                                                          \
    {                                                                                            \
        return effects_radiance(e, r, in, mask, d, c);                                           \
    }

enum {
    EFFECTS_PLAIN = EFFECT_HARD_SHADOWS,
    EFFECTS_MIRRORS = EFFECT_HARD_SHADOWS | EFFECT_MIRROR,
    EFFECTS_GLASS = EFFECT_HARD_SHADOWS | EFFECT_MIRROR | EFFECT_REFRACTION,
    EFFECTS_COLOURED_GLASS = EFFECT_HARD_SHADOWS | EFFECTS_WHITTED,
    EFFECTS_SOFT = EFFECT_SOFT_SHADOWS,
    EFFECTS_MATTE_ROOM = EFFECT_SOFT_SHADOWS | EFFECT_INDIRECT,
    EFFECTS_CLEAR_ROOM = EFFECT_SOFT_SHADOWS | EFFECT_INDIRECT | EFFECTS_WHITTED,
    EFFECTS_ROOM = EFFECT_SOFT_SHADOWS | EFFECT_INDIRECT | EFFECTS_WHITTED | EFFECT_GLOSSY,
    EFFECTS_OUTDOORS = EFFECT_ENVIRONMENT | EFFECT_INDIRECT
};

EFFECTS_COMPILED(effects_cast, EFFECTS_NONE)
EFFECTS_COMPILED(effects_plain, EFFECTS_PLAIN)
EFFECTS_COMPILED(effects_mirrors, EFFECTS_MIRRORS)
EFFECTS_COMPILED(effects_glass, EFFECTS_GLASS)
EFFECTS_COMPILED(effects_coloured_glass, EFFECTS_COLOURED_GLASS)
EFFECTS_COMPILED(effects_soft, EFFECTS_SOFT)
EFFECTS_COMPILED(effects_matte_room, EFFECTS_MATTE_ROOM)
EFFECTS_COMPILED(effects_clear_room, EFFECTS_CLEAR_ROOM)
EFFECTS_COMPILED(effects_room, EFFECTS_ROOM)
EFFECTS_COMPILED(effects_outdoors, EFFECTS_OUTDOORS)
EFFECTS_COMPILED(effects_general, e->mask)

/* Of depth of field radiance knows nothing: the ray comes from somewhere on the lens. */
static inline effects_function *effects_made_for(unsigned mask)
{
    switch (mask & ~(unsigned)EFFECT_DEPTH_OF_FIELD) {
    case EFFECTS_NONE: return effects_cast;
    case EFFECTS_PLAIN: return effects_plain;
    case EFFECTS_MIRRORS: return effects_mirrors;
    case EFFECTS_GLASS: return effects_glass;
    case EFFECTS_COLOURED_GLASS: return effects_coloured_glass;
    case EFFECTS_SOFT: return effects_soft;
    case EFFECTS_MATTE_ROOM: return effects_matte_room;
    case EFFECTS_CLEAR_ROOM: return effects_clear_room;
    case EFFECTS_ROOM: return effects_room;
    case EFFECTS_OUTDOORS: return effects_outdoors;
    default: return effects_general;
    }
}

#endif
