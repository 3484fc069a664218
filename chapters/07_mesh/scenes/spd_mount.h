/* spd_mount.h: a fractal mountain (分形山) of 2 * 4^scale triangles, and four glass balls above it.
 *
 *    c --- m --- c      midpoint displacement: the middle of an edge lies at the mean of its ends,
 *    |     |     |      plus rise * g; the middle of a square at the mean of its four corners, plus
 *    m --- o --- m      sqrt 2 * rise * g. g: Gaussian, a function of the place alone, so that
 *    |     |     |      neighbours agree. rise = half the side * sqrt(k^2 - 1)          (17.3)
 *    c --- m --- c
 */
#ifndef MESH_SPD_MOUNT_H
#define MESH_SPD_MOUNT_H

#include "world.h"

typedef struct { int scale; size_t side; real *z; } mount_heights;  /* z[y * side + x] */

/* ---------------------------------------------------------------------------------------------- */

static inline uint32_t mount_shift(uint32_t x, int by)  /* left; beyond scale 7 some go right */
{
    return by >= 0 ? x << by : x >> -by;
}

/* The generator of random numbers is part of the scene: another one, another mountain. In double,
 * so that float makes the same mountain. */
static inline double mount_gauss(uint32_t x, uint32_t y, int scale)
{
    uint32_t i = 21 + ((mount_shift(x, 23 - scale) + mount_shift(y, 15 - scale)
                        + mount_shift(x, 7 - scale)) & 0xffff);
    for (;;) {
        double v[2];
        for (int k = 0; k < 2; k++) {
            i = (28411 + 8121 * i) % 134456;
            v[k] = 2.0 * i / 134456 - 1;
        }
        double s = v[0] * v[0] + v[1] * v[1];  /* polar method: a point in the unit disk */
        if (s < 1 && s > 0) return v[0] * sqrt(-2 * log(s) / s);
    }
}

static inline real *mount_at(mount_heights *h, size_t x, size_t y)
{
    return h->z + y * h->side + x;
}

static inline void mount_edge(mount_heights *h, size_t x, size_t y, size_t dx, size_t dy, real rise)
{
    real mean = (*mount_at(h, x - dx, y - dy) + *mount_at(h, x + dx, y + dy)) / 2;
    *mount_at(h, x, y) = mean + rise * (real)mount_gauss((uint32_t)x, (uint32_t)y, h->scale);
}

static inline mount_heights mount_raise(int scale)
{
    size_t n = (size_t)1 << scale;
    mount_heights h = {scale, n + 1, allocate((n + 1) * (n + 1), sizeof *h.z)};
    real k = 2 / pow((real)2, 1 / (real)1.2), root = sqrt((real)2);
    for (size_t s = n / 2; s > 0; s /= 2) {
        real rise = (real)s * 2 / (real)n * sqrt(k * k - 1);
        for (size_t y = s; y < n; y += 2 * s)
            for (size_t x = s; x < n; x += 2 * s) {
                real mean = (*mount_at(&h, x - s, y - s) + *mount_at(&h, x + s, y - s)
                             + *mount_at(&h, x + s, y + s) + *mount_at(&h, x - s, y + s)) / 4;
                real g = (real)mount_gauss((uint32_t)x, (uint32_t)y, scale);
                *mount_at(&h, x, y) = mean + root * rise * g;
            }
        for (size_t y = 0; y <= n; y += s)
            for (size_t x = 0; x <= n; x += s) {
                if (x / s % 2 == 1 && y / s % 2 == 0) mount_edge(&h, x, y, s, 0, rise);
                if (x / s % 2 == 0 && y / s % 2 == 1) mount_edge(&h, x, y, 0, s, rise);
            }
    }
    return h;
}

static inline vec3 mount_point(mount_heights *h, size_t x, size_t y)
{
    real half = (real)(h->side - 1) / 2;
    return (vec3){(real)x / half - 1, (real)y / half - 1, *mount_at(h, x, y)};
}

/* Quarters, counter-clockwise, so that triangles that are neighbours are so in the list, too. */
static inline void mount_triangles(world *w, mount_heights *h, size_t x, size_t y, size_t side)
{
    if (side > 1) {
        size_t s = side / 2;
        mount_triangles(w, h, x, y, s), mount_triangles(w, h, x + s, y, s);
        mount_triangles(w, h, x + s, y + s, s), mount_triangles(w, h, x, y + s, s);
        return;
    }
    vec3 a = mount_point(h, x, y), c = mount_point(h, x + 1, y + 1);
    world_add(w, shape_of_triangle((triangle){a, mount_point(h, x + 1, y), c}));
    world_add(w, shape_of_triangle((triangle){c, mount_point(h, x, y + 1), a}));
}

/* The corners of a regular tetrahedron about (-.8, .8, 1). */
static inline void mount_balls(world *w)
{
    real r = 0.17, distance = r * sqrt((real)1.5), h = sqrt((real)0.5);
    vec3 z = {0, 0, 1}, down = turned(z, (vec3){h, h, 0}, acos(-1 / (real)3));
    for (int k = 0; k < 4; k++) {
        vec3 d = k == 0 ? z : turned(down, z, (real)(k - 1) * (2 * pi / 3));
        vec3 c = vmadd(vec(-0.8, 0.8, 1), d, distance);
        world_add(w, shape_of_sphere((sphere){c, r}));
    }
}

cold_inline bool spd_mount(int scale, world *w, failure *f)
{
    mount_heights h = mount_raise(scale);
    size_t n = (size_t)1 << scale;
    world_room(w, 4 + 2 * n * n, 0, 2);
    world_paint(w, (finish){{1, 1, 1}, 0.1, 0.1, 101.148, 0.9, 1.5});
    mount_balls(w);
    world_paint(w, (finish){{0.5, 0.45, 0.35}, 1, 0, 0, 0, 0});
    mount_triangles(w, &h, 0, 0, n);
    free(h.z);
    world_light(w, (vec3){-100, -100, 100});
    return world_look(w, vec(-1.6, 1.6, 1.7), (vec3){0, 0, 0}, (vec3){0, 0, 1},
                      45, f);
}

#endif
