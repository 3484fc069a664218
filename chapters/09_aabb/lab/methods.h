/* methods.h: the slab tests of slabs.h and aabb.h in one list, for tables and pictures. */
#ifndef METHODS_H
#define METHODS_H

#include "slabs.h"

typedef bool box_method(aabb b, ray r, real *t_enter);

enum { method_first, method_closed_f32, method_closed, method_fmin, method_pbrt,
       method_inclusive, method_default, methods };

static const char *const method_name[methods] = {
    "first", "closed, float", "closed, <=", "fmin, fmax", "pbrt's order", "inclusive",
    "aabb_hit"};

static box_method *const method[methods] = {
    first_aabb_hit, aabb_hit_closed_f32, aabb_hit_closed, aabb_hit_fmin, aabb_hit_pbrt,
    aabb_hit_inclusive, aabb_hit};

#endif
