/* bench.h: the scenes and rays that this chapter measures with.
 *
 *   bench_make(BENCH_STADIUM, quick, seed, &b);    b.x: its items; b.rays
 *   bench_free(&b);
 *   mesh m = bench_boards(n, seed)                     large triangles, through each other
 *
 *   teapot       36672 triangles (quick: 4032); lines from everywhere through its box
 *   triangles    20000, in any place and at any angle; likewise
 *   spheres      20000 of 0.3 of their mean distance; likewise
 *   stadium      a teapot of 16256 triangles in one of 4032 that is 100 times as large, seen from
 *                a place near the small one
 */
#ifndef BENCH_H
#define BENCH_H

#include "../../09_aabb/items.h"
#include "../../07_mesh/scenes/stadium.h"
#include "../../09_aabb/trials/survey.h"

typedef enum { BENCH_TEAPOT, BENCH_TRIANGLES, BENCH_SPHERES, BENCH_STADIUM, benches } bench_kind;
static const char *const bench_name[benches] = {"teapot", "triangles", "spheres", "stadium"};

typedef struct { mesh m; shape *shapes; scene s; items x; ray_set rays; } bench;

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 bench_vector(random_stream *g, real size)
{
    real x = 2 * random_next(g) - 1, y = 2 * random_next(g) - 1, z = 2 * random_next(g) - 1;
    return vscale((vec3){x, y, z}, size);
}

/* Edges about half as long as the triangles are apart. */
static inline mesh bench_soup(size_t n, uint64_t seed)
{
    mesh m = {.vertices = 3 * n, .triangles = n};
    real size = (real)cbrt(1 / (double)n) / 2;
    m.v = allocate(3 * n, sizeof *m.v), m.index = allocate(3 * n, sizeof *m.index);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 0);
        vec3 c = bench_vector(&g, 0.5);
        for (size_t k = 0; k < 3; k++) {
            m.v[3 * i + k] = vadd(c, bench_vector(&g, size));
            m.index[3 * i + k] = (uint32_t)(3 * i + k);
        }
    }
    return m;
}

/* Across the cube of side 2: each passes through many cells, and through many others. */
static inline mesh bench_boards(size_t n, uint64_t seed)
{
    mesh m = bench_soup(n, seed);
    for (size_t i = 0; i < 3 * n; i++) {
        random_stream g = random_start(seed, i, 4);
        m.v[i] = bench_vector(&g, 1);
    }
    return m;
}

static inline shape *bench_spheres(size_t n, uint64_t seed)
{
    shape *s = allocate(n, sizeof *s);
    real r = (real)(0.3 * cbrt(1 / (double)n));
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 1);
        s[i] = shape_of_sphere((sphere){bench_vector(&g, 0.5), r});
    }
    return s;
}

/* A view from so near to the small teapot that it fills the picture. */
static inline camera bench_stadium_view(real aspect)
{
    vec3 lo, hi;
    mesh pot = teapot_mesh(4);
    mesh_bounds(&pot, &lo, &hi);
    mesh_free(&pot);
    return camera_of(lo, hi, true, aspect);
}

/* b->x points into *b: it must stay where it is. */
static inline void bench_make(bench_kind kind, bool quick, uint64_t seed, bench *b)
{
    size_t n = quick ? 2000 : 20000, rays = quick ? 300 : 1500;
    failure f;
    aabb box;
    *b = (bench){.shapes = NULL};
    if (kind == BENCH_TEAPOT) b->m = teapot_mesh(quick ? 8 : 24);
    if (kind == BENCH_TRIANGLES) b->m = bench_soup(n, seed);
    if (kind == BENCH_STADIUM) b->m = stadium_mesh(quick ? 6 : 16);
    if (kind == BENCH_SPHERES) b->shapes = bench_spheres(n, seed);
    b->s = (scene){b->shapes, n};
    b->x = b->shapes ? items_of_scene(&b->s) : items_of_mesh(&b->m);
    if (!items_all_bounds(&b->x, &box, &f)) fail(f);
    if (kind == BENCH_STADIUM)
        b->rays = rays_primary(bench_stadium_view(1), quick ? 8 : 14, quick ? 8 : 14);
    else b->rays = rays_uniform(box, rays, seed);
}

static inline void bench_free(bench *b)
{
    mesh_free(&b->m), free(b->shapes), rays_free(&b->rays);
    *b = (bench){.shapes = NULL};
}

#endif
