/* normals.h: normals (法线) under a transform.
 *
 *       n                       Points go by M, and so do tangents. A normal is no tangent but what
 *       |  M: half as high        is at right angles to them: n . d = 0. It must stay so:
 *      / \      ->        _ n
 *     /   \             _/|\_       n' . M d = 0 for all d with n . d = 0
 *    /     \          _/     \_     n' = M^-T n = A^T n                                 (16.4)
 *
 *   vec3 normal_to_world(&to_object, n)     (16.4): the inverse transposed (逆转置), unit
 *   vec3 normal_naive(&to_world, n)         M n, made unit: right only for rotations, mirrors, and
 *                                           scalings alike along all axes; scaled by s along one it
 *                                           is off by atan((s - 1/s) / 2) at most          (16.5)
 *
 * The columns of A are at hand, so A^T n is three dot products, and nothing need be inverted again.
 *
 * Mirrored (镜像) transforms, det M < 0: A^T n points to the side in the world that n points to in
 * object space; what pointed out of a closed mesh points out of its mirror image. The cross product
 * of the transformed edges does not: (M e) x (M f) = det M  M^-T (e x f), and so it turns inwards.
 * In other words: which side is outside is decided in object space, where the corners are counter-
 * clockwise, and no transform changes it. DirectX Raytracing has the same rule.
 *
 * Source: K. Turkowski, "Properties of surface-normal transformations", Graphics Gems, 1990.
 */
#ifndef INSTANCES_NORMALS_H
#define INSTANCES_NORMALS_H

#include "../01_ray/affine.h"

/* ---------------------------------------------------------------------------------------------- */

/* (0,0,0) stays what it is: there is no normal. */
static inline vec3 normal_to_world(const affine *to_object, vec3 n)
{
    return vunit((vec3){vdot(to_object->x, n), vdot(to_object->y, n), vdot(to_object->z, n)});
}

/* M = diag(1, 1, 1/4), n = (1, 0, 1)/sqrt 2: the slope of 45 degrees becomes one of 14, so its
 * normal leans by 14 degrees; M n leans by 76. */
static inline vec3 normal_naive(const affine *to_world, vec3 n)
{
    return vunit(affine_vector(*to_world, n));
}

#endif
