/* ray_f32.h: both forms of a point on a ray in float, whatever real is. Exhibits: what 24 bits do
 * far from the origin. At 1e8 neighbouring floats are 8 apart, and a ray becomes a staircase. */
#ifndef RAY_LAB_F32_H
#define RAY_LAB_F32_H

#include "../ray.h"

typedef struct { float x, y, z; } vec3_f32;

/* ---------------------------------------------------------------------------------------------- */

/* o + t d, (1.2), each operation rounded to float. */
static inline float at_f32(float o, float d, float t) { return o + t * d; }

static inline vec3_f32 ray_at_f32(vec3_f32 o, vec3_f32 d, float t)
{
    return (vec3_f32){at_f32(o.x, d.x, t), at_f32(o.y, d.y, t), at_f32(o.z, d.z, t)};
}

/* (1 - t) a + t b, (1.1), each operation rounded to float. */
static inline float between_f32(float a, float b, float t) { return (1 - t) * a + t * b; }

static inline vec3_f32 ray_at_between_f32(vec3_f32 a, vec3_f32 b, float t)
{
    return (vec3_f32){between_f32(a.x, b.x, t), between_f32(a.y, b.y, t), between_f32(a.z, b.z, t)};
}

#endif
