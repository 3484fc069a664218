/* specimens.h: made-up shapes to measure and to draw.
 *
 *   size_t n = gear(v, teeth, r, notch)   corners of a gear wheel (齿轮) in the plane z = 0, 4 a
 *                                         tooth; radius r outside, notch * r between the teeth
 *   mesh m = torus_mesh(n)                closed ring (圆环) about the z axis, 2 n^2 triangles,
 *                                         n [3..4000]; radii 3/4 and 1/4 [scene units]
 *   mesh m = octahedron_mesh(n)           closed, |x| + |y| + |z| = 1, 8 n^2 triangles,
 *                                         n [1..2000]; corners are multiples of 1/n, exact if n is
 *                                         a power of two
 *   mesh m = floors_mesh(n)               squares in the planes x, y, z = -1 + 2 i / n, open
 *
 * Triangles are counter-clockwise seen from outside. mesh_free releases a mesh. Source of the
 * gear: E. Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987.
 */
#ifndef MESH_SPECIMENS_H
#define MESH_SPECIMENS_H

#include "soup.h"

/* ---------------------------------------------------------------------------------------------- */

/* Four corners a tooth: two at radius r, -+0.19 of a tooth's angle; two at notch * r, 0.3 and
 * 0.7. */
static inline size_t gear(vec3 *v, int teeth, real r, real notch)
{
    const real part[4] = {-0.19, 0.19, 0.3, 0.7};
    for (int i = 0; i < 4 * teeth; i++) {
        real a = 2 * pi * ((real)(i / 4) + part[i % 4]) / (real)teeth;
        real q = i % 4 < 2 ? r : notch * r;
        v[i] = (vec3){q * cos(a), q * sin(a), 0};
    }
    return 4 * (size_t)teeth;
}

static inline mesh specimen_new(size_t vertices, size_t triangles)
{
    mesh m = {0};
    m.v = allocate(vertices, sizeof *m.v);
    m.index = allocate(3 * triangles, sizeof *m.index);
    m.vertices = vertices;
    return m;
}

static inline void specimen_add(mesh *m, size_t a, size_t b, size_t c)
{
    uint32_t *k = m->index + 3 * m->triangles++;
    k[0] = (uint32_t)a, k[1] = (uint32_t)b, k[2] = (uint32_t)c;
}

static inline mesh torus_mesh(int n)
{
    size_t k = (size_t)n;
    mesh m = specimen_new(k * k, 2 * k * k);
    for (size_t i = 0; i < k; i++)
        for (size_t j = 0; j < k; j++) {
            real a = 2 * pi * (real)i / (real)n, b = 2 * pi * (real)j / (real)n;
            real r = (3 + cos(b)) / 4;
            real z = 2 * j % k == 0 ? 0 : sin(b) / 4;  /* sin of the rounded pi is not 0 */
            m.v[i * k + j] = (vec3){r * cos(a), r * sin(a), z};
            size_t i1 = (i + 1) % k, j1 = (j + 1) % k;
            specimen_add(&m, i * k + j, i1 * k + j, i1 * k + j1);
            specimen_add(&m, i * k + j, i1 * k + j1, i * k + j1);
        }
    return m;
}

/* The square [-n, n]^2 folded over the octahedron: the rim, |x| + |y| > n, comes to the lower
 * half, and so two points of the rim that are mirrored about the middle of their side are one
 * vertex. Rather than merge them, both halves are numbered ring by ring: ring j has 4 j points,
 * the equator serves both. */
static inline size_t octahedron_vertex(int n, int half, int ring, int k)
{
    size_t below = 2 * (size_t)ring * ((size_t)ring - 1) + 1,
           all = 2 * (size_t)n * ((size_t)n + 1) + 1;
    if (ring > 0) k %= 4 * ring;
    if (ring == 0) return half ? all : 0;
    return half && ring < n ? all + below + (size_t)k : below + (size_t)k;
}

static inline mesh octahedron_mesh(int n)
{
    size_t half_size = 2 * (size_t)n * ((size_t)n + 1) + 1, kn = (size_t)n;
    mesh m = specimen_new(2 * half_size - 4 * kn, 8 * kn * kn);
    for (int half = 0; half < 2; half++)
        for (int ring = 0; ring <= n; ring++)
            for (int k = 0; k < (ring ? 4 * ring : 1); k++) {
                int side = ring ? k / ring : 0, s = ring ? k % ring : 0;
                real x = (real)(ring - s) / (real)n,
                     y = (real)s / (real)n; /* turned by quarters */
                real z = (real)(n - ring) / (real)n;
                vec3 p = side == 0 ? (vec3){x, y, z} : side == 1 ? (vec3){-y, x, z}
                       : side == 2 ? (vec3){-x, -y, z} : (vec3){y, -x, z};
                if (half) p.z = -p.z;
                m.v[octahedron_vertex(n, half, ring, k)] = p;
                if (ring == 0) continue;
                size_t out = octahedron_vertex(n, half, ring, k);
                size_t next = octahedron_vertex(n, half, ring, k + 1);
                size_t in = octahedron_vertex(n, half, ring - 1, side * (ring - 1) + s);
                int inner = side * (ring - 1) + s - 1 + 4 * (ring - 1);
                size_t before = octahedron_vertex(n, half, ring - 1, inner);
                specimen_add(&m, half ? next : out, half ? out : next, in);
                if (s > 0) specimen_add(&m, half ? in : before, out, half ? before : in);
            }
    return m;
}

/* 3 (n + 1) planes of n x n squares each, cut in two: 6 n^2 (n + 1) triangles. */
static inline mesh floors_mesh(int n)
{
    mesh m = mesh_room((size_t)(6 * n * n * (n + 1)));
    size_t i = 0;
    for (int k = 0; k < 3; k++)
        for (int layer = 0; layer <= n; layer++)
            for (int cell = 0; cell < n * n; cell++) {
                static const int corner[6] = {0, 1, 2, 0, 2, 3};
                vec3 q[4];
                for (int c = 0; c < 4; c++) {
                    int a = cell % n + (c == 1 || c == 2), b = cell / n + c / 2;
                    real *p = (real *)&q[c];
                    p[k] = -1 + 2 * (real)layer / (real)n;
                    p[(k + 1) % 3] = -1 + 2 * (real)a / (real)n;
                    p[(k + 2) % 3] = -1 + 2 * (real)b / (real)n;
                }
                for (int c = 0; c < 6; c++) m.v[i++] = q[corner[c]];
            }
    return m;
}

#endif
