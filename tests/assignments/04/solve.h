/* Asks the functions of assignment 04. A miss leaves h as it was: t is -77. */
#ifndef SOLVE_04_H
#define SOLVE_04_H
#include "3_sided.h"
#include "4_fisheye.h"
#include "5_quad.h"

static answer solve(int exercise, const question *q)
{
    answer a = {false, {{0, 0, 0}, 0, {0, 0, 0}, 0}, {-77, -77, -77, 77}};
    switch (exercise) {
    case 1: a.r = first_camera_ray(q->camera, q->x, q->y); break;
    case 2: a.is = first_triangle_hit(q->tri, q->r, &a.h); break;
    case 3: a.is = triangle_hit_sided(q->tri, q->r, q->side, &a.h); break;
    case 4: a.is = fisheye_ray(q->camera, q->x, q->y, &a.r); break;
    case 5: a.is = quad_hit(q->a, q->b, q->c, q->d, q->r, &a.h); break;
    }
    return a;
}
#endif
