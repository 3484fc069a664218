/* icosphere.h: a sphere of triangles, closed, with corners that neighbours share to the last bit.
 *
 * Each step cuts every triangle of an icosahedron (二十面体) into four and moves the new corners, the
 * middles of the edges, out to the unit sphere: 20 * 4^levels triangles.
 *
 *   icosphere m = icosphere_new(4, centre, 1);   levels [0..7], centre, radius; the caller frees
 *   icosphere_triangle(&m, i)                    the i-th triangle
 *   icosphere_free(&m);
 *
 * For aiming at it: an edge belongs to exactly two triangles, a vertex to 5 or 6.
 *   m.edge[e]          corners p < q, its triangles
 *   m.fan[v]           the triangles round vertex v
 */
#ifndef TRIANGLE_ICOSPHERE_H
#define TRIANGLE_ICOSPHERE_H

#include "../../../common/file.h"
#include "../triangle.h"

typedef struct { uint32_t p, q, triangle[2]; } icosphere_edge;
typedef struct { uint32_t count, triangle[6]; } icosphere_fan;

typedef struct {
    vec3 *v;
    uint32_t (*index)[3];  /* corners of each triangle, counter-clockwise seen from outside */
    icosphere_edge *edge;
    icosphere_fan *fan;    /* one for each vertex */
    uint32_t vertices, triangles, edges;
    vec3 centre;
    real radius;
} icosphere;

/* Centre and radius are applied last: the corners are rounded where they lie, once. */
static inline icosphere icosphere_new(int levels, vec3 centre, real radius);
static inline void icosphere_free(icosphere *m);

/* ---------------------------------------------------------------------------------------------- */

static inline triangle icosphere_triangle(const icosphere *m, uint32_t i)
{
    return (triangle){m->v[m->index[i][0]], m->v[m->index[i][1]], m->v[m->index[i][2]]};
}

/* The edge p q: found in the fan of its lower corner, or new. */
static inline uint32_t icosphere_edge_of(icosphere *m, uint32_t p, uint32_t q,
                                         uint32_t (*of_vertex)[6])
{
    uint32_t low = p < q ? p : q, high = p < q ? q : p, k = 0;
    while (of_vertex[low][k] != no_shape) {
        if (m->edge[of_vertex[low][k]].q == high) return of_vertex[low][k];
        k++;
    }
    of_vertex[low][k] = m->edges;
    m->edge[m->edges] = (icosphere_edge){low, high, {no_shape, no_shape}};
    return m->edges++;
}

/* Fills in edge and fan from index. sides[i] are the edges of triangle i. */
static inline void icosphere_connect(icosphere *m, uint32_t (*sides)[3])
{
    uint32_t (*of_vertex)[6] = allocate(m->vertices, sizeof *of_vertex);
    for (uint32_t i = 0; i < m->vertices; i++)
        for (int k = 0; k < 6; k++) of_vertex[i][k] = no_shape;
    for (uint32_t i = 0; i < m->triangles; i++)
        for (int k = 0; k < 3; k++) {
            uint32_t p = m->index[i][k], q = m->index[i][(k + 1) % 3];
            uint32_t e = icosphere_edge_of(m, p, q, of_vertex);
            m->edge[e].triangle[m->edge[e].triangle[0] != no_shape] = i;
            m->fan[p].triangle[m->fan[p].count++] = i;
            sides[i][k] = e;
        }
    free(of_vertex);
}

static inline icosphere icosphere_room(uint32_t triangles)
{
    icosphere m = {NULL, NULL, NULL, NULL, triangles / 2 + 2, triangles, 0,
                   {0, 0, 0}, 1};  /* vertices from V - E + F = 2 and 2 E = 3 F */
    m.v = allocate(m.vertices, sizeof *m.v);
    m.index = allocate(m.triangles, sizeof *m.index);
    m.edge = allocate((size_t)m.triangles / 2 * 3, sizeof *m.edge);
    m.fan = allocate(m.vertices, sizeof *m.fan);
    return m;
}

static inline icosphere icosphere_seed(void)
{
    static const uint32_t index[20][3] = {
        {0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
        {11, 10, 2}, {10, 7, 6}, {7, 1, 8}, {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8},
        {3, 8, 9}, {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}};
    real g = (1 + sqrt((real)5)) / 2;  /* golden ratio */
    vec3 v[12] = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0}, {0, -1, g}, {0, 1, g},
                  {0, -1, -g}, {0, 1, -g}, {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    icosphere m = icosphere_room(20);
    for (int i = 0; i < 12; i++) m.v[i] = vunit(v[i]);
    memcpy(m.index, index, sizeof index);
    return m;
}

/* Each triangle a b c with edge middles x (a b), y (b c), z (c a): a x z, b y x, c z y, x y z. */
static inline icosphere icosphere_split(icosphere *m)
{
    uint32_t (*sides)[3] = allocate(m->triangles, sizeof *sides);
    icosphere_connect(m, sides);
    icosphere n = icosphere_room(4 * m->triangles);
    memcpy(n.v, m->v, m->vertices * sizeof *m->v);
    for (uint32_t e = 0; e < m->edges; e++)
        n.v[m->vertices + e] = vunit(vadd(m->v[m->edge[e].p], m->v[m->edge[e].q]));
    for (uint32_t i = 0; i < m->triangles; i++) {
        const uint32_t *a = m->index[i];
        uint32_t x = m->vertices + sides[i][0], y = m->vertices + sides[i][1],
                 z = m->vertices + sides[i][2];
        uint32_t four[4][3] = {{a[0], x, z}, {a[1], y, x}, {a[2], z, y}, {x, y, z}};
        memcpy(n.index[4 * (size_t)i], four, sizeof four);
    }
    free(sides);
    icosphere_free(m);
    return n;
}

static inline icosphere icosphere_new(int levels, vec3 centre, real radius)
{
    icosphere m = icosphere_seed();
    for (int k = 0; k < levels; k++) m = icosphere_split(&m);
    uint32_t (*sides)[3] = allocate(m.triangles, sizeof *sides);
    icosphere_connect(&m, sides);
    free(sides);
    for (uint32_t i = 0; i < m.vertices; i++) m.v[i] = vmadd(centre, m.v[i], radius);
    m.centre = centre, m.radius = radius;
    return m;
}

static inline void icosphere_free(icosphere *m)
{
    free(m->v);
    free(m->index);
    free(m->edge);
    free(m->fan);
    *m = (icosphere){NULL, NULL, NULL, NULL, 0, 0, 0, {0, 0, 0}, 0};
}

#endif
