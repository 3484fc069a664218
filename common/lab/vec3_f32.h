/* vec3_f32.h: vectors in float, whatever real is: for exhibits of what 24 bits do.
 *
 *   vec3_f32 p = f32_of(v);   f32_sub(a, b), f32_dot(a, b), f32_cross(a, b)
 */
#ifndef VEC3_F32_H
#define VEC3_F32_H
#include "../vec3.h"

typedef struct { float x, y, z; } vec3_f32;

/* ---------------------------------------------------------------------------------------------- */
static inline vec3_f32 f32_of(vec3 a) { return (vec3_f32){(float)a.x, (float)a.y, (float)a.z}; }

static inline vec3_f32 f32_sub(vec3_f32 a, vec3_f32 b)
{
    return (vec3_f32){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline float f32_dot(vec3_f32 a, vec3_f32 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static inline vec3_f32 f32_cross(vec3_f32 a, vec3_f32 b)
{
    return (vec3_f32){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
#endif
