/* effect.h: the effects that a scene may call for, each one bit of a mask.
 *
 *   bit                      name in --effects   what it takes
 *   EFFECT_HARD_SHADOWS      hard                light of points and suns: a shadow ray to each
 *   EFFECT_SOFT_SHADOWS      soft                light of faces that emit: rays to points of them
 *   EFFECT_MIRROR            mirror              a ray along the mirror direction
 *   EFFECT_GLOSSY            glossy              rays about the mirror direction; of rough glass
 *                                                about Snell's, too: without it, it is smooth
 *   EFFECT_REFRACTION        refraction          a ray through the surface, bent or straight
 *   EFFECT_ABSORPTION        absorption          no ray: exp(-absorb length) inside
 *   EFFECT_INDIRECT          indirect            rays from matte surfaces to other surfaces
 *   EFFECT_ENVIRONMENT       environment         shadow rays to the sky
 *   EFFECT_DEPTH_OF_FIELD    depth               rays through all of the lens
 *
 *   const char *name = integrator_of(mask)       the least that can do all of them
 */
#ifndef EFFECT_H
#define EFFECT_H

/* Whose ray it is: bit k of a mask is effect k. */
enum {
    RAY_TO_LIGHT, RAY_TO_LAMP, RAY_MIRRORED, RAY_GLOSSY, RAY_REFRACTED, RAY_ABSORBED, RAY_SCATTERED,
    RAY_TO_SKY, RAY_OF_LENS,
    effect_kinds
};

enum {
    EFFECT_HARD_SHADOWS = 1 << RAY_TO_LIGHT, EFFECT_SOFT_SHADOWS = 1 << RAY_TO_LAMP,
    EFFECT_MIRROR = 1 << RAY_MIRRORED, EFFECT_GLOSSY = 1 << RAY_GLOSSY,
    EFFECT_REFRACTION = 1 << RAY_REFRACTED, EFFECT_ABSORPTION = 1 << RAY_ABSORBED,
    EFFECT_INDIRECT = 1 << RAY_SCATTERED, EFFECT_ENVIRONMENT = 1 << RAY_TO_SKY,
    EFFECT_DEPTH_OF_FIELD = 1 << RAY_OF_LENS,
    EFFECTS_NONE = 0, EFFECTS_ALL = (1 << effect_kinds) - 1,
    EFFECTS_LIT = EFFECT_HARD_SHADOWS | EFFECT_SOFT_SHADOWS | EFFECT_ENVIRONMENT,
    EFFECTS_WHITTED = EFFECT_MIRROR | EFFECT_REFRACTION | EFFECT_ABSORPTION,
    EFFECTS_OF_CHANCE = EFFECT_SOFT_SHADOWS | EFFECT_GLOSSY | EFFECT_INDIRECT | EFFECT_ENVIRONMENT
        | EFFECT_DEPTH_OF_FIELD            /* integrals: they take random numbers */
};

static const struct { const char *option, *name; } effect_names[effect_kinds] = {
    {"hard", "hard shadows"}, {"soft", "soft shadows"}, {"mirror", "mirror"}, {"glossy", "glossy"},
    {"refraction", "refraction"}, {"absorption", "absorption"}, {"indirect", "indirect light"},
    {"environment", "environment"}, {"depth", "depth of field"}};

/* ---------------------------------------------------------------------------------------------- */

static inline const char *integrator_of(unsigned mask)
{
    return mask & EFFECTS_OF_CHANCE ? "path tracing"
        : mask & EFFECTS_WHITTED ? "Whitted ray tracing" : "ray casting";
}

#endif
