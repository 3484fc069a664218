/* special.h: effects_radiance compiled for the sets of effects that matter.
 *
 *   effects_function *f = effects_made_for(mask)     a copy that is made for it, else the general
 *   vec3 L = f(e, &path, counts)
 *   vec3 L = effects_alone(f, e, r, in, &dice, counts)   the same of a ray that has met nothing yet
 *
 * Each line of EFFECTS_SETS is a copy of the function in which the compiler knows the mask, but for
 * the last column, which is asked at run time: of what the scene does not call for no test is left,
 * no code, no registers.
 */
#ifndef EFFECTS_SPECIAL_H
#define EFFECTS_SPECIAL_H

#include "radiance.h"

typedef vec3 effects_function(const effects_stage *e, effects_path *p, effects_counts *c);

/* name, effects that are simulated, others that may be */
#define EFFECTS_SETS(X)                                                                          \
    X(plain, EFFECT_HARD_SHADOWS, EFFECTS_NONE)                                                  \
    X(mirrors, EFFECT_HARD_SHADOWS | EFFECT_MIRROR, EFFECTS_NONE)                                \
    X(glass, EFFECT_HARD_SHADOWS | EFFECT_MIRROR | EFFECT_REFRACTION, EFFECT_ABSORPTION)         \
    X(matte_room, EFFECT_SOFT_SHADOWS, EFFECT_INDIRECT)                                          \
    X(room, EFFECT_SOFT_SHADOWS | EFFECT_MIRROR | EFFECT_REFRACTION,                             \
      EFFECT_HARD_SHADOWS | EFFECT_ABSORPTION | EFFECT_INDIRECT)

/* ---------------------------------------------------------------------------------------------- */

#define EFFECTS_COMPILED(name, set, maybe)                                                       \
    static vec3 effects_##name(const effects_stage *e, effects_path *p, effects_counts *c)       \
    {                                                                                            \
        return effects_radiance(e, p, (set) | (e->mask & (maybe)), c);                           \
    }
EFFECTS_SETS(EFFECTS_COMPILED)
EFFECTS_COMPILED(general, EFFECTS_NONE, ~0u)  /* all other sets */

/* Of depth of field radiance knows nothing: the ray comes from somewhere on the lens. */
static inline effects_function *effects_made_for(unsigned mask)
{
    mask &= ~(unsigned)EFFECT_DEPTH_OF_FIELD;
#define EFFECTS_FITS(name, set, maybe) \
    if ((mask & ~(unsigned)(maybe)) == (unsigned)(set)) return effects_##name;
    EFFECTS_SETS(EFFECTS_FITS)
    return effects_general;
}

static inline vec3 effects_alone(effects_function *f, const effects_stage *e, ray r, media_set in,
                                 const dice *d, effects_counts *c)
{
    effects_path p = {.r = r, .in = in, .d = *d};
    effects_see(e, &p);
    return f(e, &p, c);
}

#endif
