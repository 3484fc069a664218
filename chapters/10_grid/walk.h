/* walk.h: which cells does a ray pass, in order? (三维 DDA, the line rasteriser of the notes in 3D)
 *
 *      +-----+-----+-----+      The ray meets the walls of each axis at equal intervals of t:
 *      |     |     |  ---*->        t_k(j) = first_k + j step_k,  j = 0, 1, 2 ..           (10.4)
 *      +-----+--.--*-----+          first = ((lo - o) + w size) / d,  step = size / |d|
 *      |  .--*     |     |      The next wall is the one of the smallest t. Step over it: j + 1 on
 *    o-*-----+-----+-----+      that axis.
 *
 *   grid_line a = line_of(r)                   once a ray
 *   line_begin(&a, r.tmin, from)               the later of the two, in the t of the walk
 *   line_end(&a, r.tmax, to)                   the earlier
 *   grid_walk w = walk_from(&l, &a, t)         the cell at t; the cell's number is w.cell
 *   real t = walk_next_t(&w)                   where the ray leaves it; infinity: no wall ahead
 *   walk_step(&w, t)                           into the next one, if t is not infinite
 *
 * Outer cells reach to infinity: the walk never leaves the lattice. t counts in lengths of a.d, in
 * which very long and very short directions are scaled: multiply a t of the ray by a.scale.
 *
 * Adding step over and over adds up as many roundings: the error of t grows with the square of the
 * number of steps; in float, after 1e5 of them, walks are dozens of cells off. (10.4) counts in
 * whole numbers instead, which are exact, and rounds t afresh: two operations more, and no drift.
 *
 * What is promised: at every t from the start on, the cell whose turn it is has the ray's exact
 * point at t within 16 epsilon D on every axis, D = the largest |side of the lattice - o|. Because
 * (lo - o), w size, their sum, 1/d and the products are each off by half an epsilon of themselves,
 * and none of them, times |d|, is more than 2 D. A d_k below epsilon/4 of the longest counts as 0:
 * it moves the ray by less than epsilon D.
 *
 * Sources: J. Cleary, G. Wyvill, "Analysis of an algorithm for fast ray tracing using uniform
 * space subdivision", The Visual Computer 4, 1988; J. Amanatides, A. Woo, "A Fast Voxel Traversal
 * Algorithm for Ray Tracing", Eurographics 1987 (both add, as lab/naive.h; here it is counted).
 */
#ifndef GRID_WALK_H
#define GRID_WALK_H

#include "../09_aabb/items.h"
#include <stddef.h>

typedef struct {
    vec3 lo, size, per;  /* corner; sides of a cell, and 1 over them */
    int n[3];            /* cells on each axis, 1 to 2^20 */
} lattice;

typedef struct { vec3 o, d, inverse; real scale; } grid_line;  /* inverse 0: parallel */

typedef struct {
    vec3 t;              /* of the next wall on each axis; infinity: none ahead */
    vec3 first, step;    /* (10.4) */
    vec3 j, last;        /* walls passed; walls in all */
    ptrdiff_t cell, stride[3];
} grid_walk;

/* ---------------------------------------------------------------------------------------------- */

static inline lattice lattice_of(aabb box, const int n[3])
{
    vec3 e = vsub(box.hi, box.lo), count = {(real)n[0], (real)n[1], (real)n[2]};
    vec3 size = {e.x / count.x, e.y / count.y, e.z / count.z};
    return (lattice){box.lo, size, {1 / size.x, 1 / size.y, 1 / size.z}, {n[0], n[1], n[2]}};
}

static inline size_t lattice_cells(const lattice *l)
{
    return (size_t)l->n[0] * (size_t)l->n[1] * (size_t)l->n[2];
}

/* Of the cell that holds x on axis k; the outer ones hold what is outside. */
fast_inline int lattice_index(real x, real lo, real per, int n)
{
    return (int)real_clamp((x - lo) * per, 0, (real)(n - 1));
}

/* Cells i to j, both included, on every axis; `more` around. Rounding keeps the order of walls, so
 * a block holds the box of each of its cells. */
static inline aabb lattice_box(const lattice *l, const int i[3], const int j[3], real more)
{
    vec3 a = {(real)i[0], (real)i[1], (real)i[2]};
    vec3 b = {(real)(j[0] + 1), (real)(j[1] + 1), (real)(j[2] + 1)};
    a = vadd(l->lo, vmul(a, l->size)), b = vadd(l->lo, vmul(b, l->size));
    return first_aabb_pad((aabb){a, b}, more);
}

fast_inline grid_line line_of(ray r)
{
    real longest = vlargest(r.d), scale = direction_scale(longest);
    if (scale != 1) r.d = vscale(r.d, 1 / scale), longest /= scale;  /* 1/d, or t, could overflow */
    real least = longest * (real_epsilon / 4);
    vec3 inverse = {fabs(r.d.x) > least ? 1 / r.d.x : 0, fabs(r.d.y) > least ? 1 / r.d.y : 0,
                    fabs(r.d.z) > least ? 1 / r.d.z : 0};
    return (grid_line){r.o, r.d, inverse, scale};
}

/* The interval [r.tmin, tmax], cut to [from, to], in the t of the walk. A t below real_smallest has
 * lost digits, so as much is added at both ends. A NaN interval holds no hit: any ends will do. */
fast_inline real line_begin(const grid_line *a, real tmin, real from)
{
    return real_max((tmin - real_smallest) * a->scale, from);
}

fast_inline real line_end(const grid_line *a, real tmax, real to)
{
    return real_min((tmax + real_smallest) * a->scale, to);
}

/* One axis. A walk that begins one cell too early or late, by rounding, is within the promise. */
fast_inline int walk_axis(real lo, real size, real per, int n, real o, real d, real inverse, real t,
                          real *first, real *step, real *last, real *next)
{
    int i = (int)real_clamp(((o - lo) + t * d) * per, 0, (real)(n - 1)), up = inverse > 0;
    *last = inverse == 0 ? 0 : (real)(up ? n - 1 - i : i);
    *first = ((lo - o) + (real)(i + up) * size) * inverse;
    *step = size * fabs(inverse);
    *next = *last > 0 ? *first : real_infinity;
    return i;
}

fast_inline grid_walk walk_from(const lattice *l, const grid_line *a, real t)
{
    grid_walk w = {.j = {0, 0, 0}};
    int x = walk_axis(l->lo.x, l->size.x, l->per.x, l->n[0], a->o.x, a->d.x, a->inverse.x, t,
                      &w.first.x, &w.step.x, &w.last.x, &w.t.x);
    int y = walk_axis(l->lo.y, l->size.y, l->per.y, l->n[1], a->o.y, a->d.y, a->inverse.y, t,
                      &w.first.y, &w.step.y, &w.last.y, &w.t.y);
    int z = walk_axis(l->lo.z, l->size.z, l->per.z, l->n[2], a->o.z, a->d.z, a->inverse.z, t,
                      &w.first.z, &w.step.z, &w.last.z, &w.t.z);
    ptrdiff_t row = l->n[0], layer = row * l->n[1];
    w.cell = x + row * y + layer * z;
    w.stride[0] = a->inverse.x < 0 ? -1 : 1;
    w.stride[1] = a->inverse.y < 0 ? -row : row;
    w.stride[2] = a->inverse.z < 0 ? -layer : layer;
    return w;
}

fast_inline real walk_next_t(const grid_walk *w)
{
    return real_min(real_min(w->t.x, w->t.y), w->t.z);
}

/* The axis that is stepped along; t counted afresh, (10.4). */
fast_inline void walk_step_axis(grid_walk *w, ptrdiff_t stride, real *t, real *j, real last,
                                real first, real step)
{
    w->cell += stride;
    *j += 1;
    *t = *j < last ? first + *j * step : real_infinity;
}

/* t = walk_next_t(w). Where it is infinite no wall is ahead, and w is of no use any more: its cell
 * is past the lattice. Where two walls are met at once, the cell
 * between is passed in no time. Branches, because the processor guesses well: a ray mostly has one
 * axis that is fast. */
fast_inline void walk_step(grid_walk *w, real t)
{
    if (w->t.x == t)
        walk_step_axis(w, w->stride[0], &w->t.x, &w->j.x, w->last.x, w->first.x, w->step.x);
    else if (w->t.y == t)
        walk_step_axis(w, w->stride[1], &w->t.y, &w->j.y, w->last.y, w->first.y, w->step.y);
    else walk_step_axis(w, w->stride[2], &w->t.z, &w->j.z, w->last.z, w->first.z, w->step.z);
}

#endif
