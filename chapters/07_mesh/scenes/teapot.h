/* teapot.h: the Utah teapot (犹他茶壶) as Bezier patches (贝塞尔曲面片), and as a mesh.
 *
 *   z up, 3.15 high;              _o_        lid      2 rings of 4 patches
 *   x towards the spout;     ___/_____\___   body     4 rings of 4: rim, upper, lower half, bottom
 *   y = 0: plane of     ___  /            \ //
 *   symmetry           /   |              |/   handle  2 rings of 2
 *                      \___\              /    spout   2 rings of 2: 32 patches in all
 *                           \____________/
 *   mesh m = teapot_mesh(n)       n x n cells a patch [1, 8000], counter-clockwise seen from
 *                                 outside, the surface's own normals, parts named as by usemtl
 *
 *   triangles      64 n^2 - 8 n   two a cell, less one where a cell touches the axis
 *   vertices   32 n^2 + 4 n + 2   one normal each; patches of a part share those where they meet
 *   open edges     16 n           4 n each at rim and lid (a gap of 0.1 between them), 2 n at each
 *                                 end of handle and spout, tubes that end inside the body or at the
 *                                 mouth: there the surface itself ends, and nowhere else
 *   n = 1                         handle and spout are flat: their halves coincide
 *
 * A patch is a sum of its 16 control points, weighted by Bernstein polynomials:
 *
 *   P(u,v) = sum_j sum_i  B_j(v) B_i(u) p[j][i]                                             (7.11)
 *   P_u    = 3 sum_j sum_i  B_j(v) D_i(u) (p[j][i+1] - p[j][i])                             (7.12)
 *   n      = P_u x P_v, made unit                                                           (7.13)
 *   B(t) = (1-t)^3, 3 (1-t)^2 t, 3 (1-t) t^2, t^3;   D(t) = (1-t)^2, 2 (1-t) t, t^2
 *
 * No weight is negative, so nothing cancels: the error is a few epsilon of the largest coordinate,
 * as with de Casteljau's repeated averages; but the weights are made once a column, not once a
 * point. They come from the pair (1 - t, t) and are summed from both ends inwards, so a mirrored
 * patch gives the mirrored point to the last bit.
 *
 * On the axis a whole row of control points is one point, and P_u = 0. Near it P_u is P_uv times
 * the way in v, so the limit of the normal is that of P_uv x P_v: straight up or down.
 *
 * Sources: M. Newell, 1975; F. Crow, "The Origins of the Teapot", IEEE CG&A 7(1), 1987; J. Blinn,
 * "What, Teapots Again?", IEEE CG&A 7(9), 1987; G. Farin, Curves and Surfaces for CAGD, ch. 4, 14.
 */
#ifndef MESH_TEAPOT_H
#define MESH_TEAPOT_H

#include "../mesh.h"

typedef struct { vec3 p[4][4]; } bezier_patch;  /* p[j][i]: row j along v, column i along u */
typedef struct { real b[4], d[3]; } bezier_weights;  /* B and D of (7.11), (7.12) */

/* t [0,1], given as the pair s = 1 - t and t. */
static inline bezier_weights bezier_at(real s, real t);

/* The point; *n [may be NULL]: the unit normal, on the side that sees u, v counter-clockwise. */
static inline vec3 bezier_point(const bezier_patch *c, const bezier_weights *u,
                                const bezier_weights *v, vec3 *n);

typedef struct {
    const char *name;
    int copies, rings;          /* patches around, and one after the other along v */
    int first_pole, last_pole;  /* 1: the first or last row is one point on the axis */
    int base[4];                /* for each ring, its row of teapot_base */
} teapot_part;

/* Patch `ring` [0, rings) of a part, its copy [0, copies) counted along u; normals point out. */
static inline bezier_patch teapot_patch(const teapot_part *part, int ring, int copy);

static inline mesh teapot_mesh(int n);

/* ---------------------------------------------------------------------------------------------- */

/* Newell's control points, reduced by symmetry. Rim, body, lid and bottom: each patch stands for
 * four, mirrored in x and in y; handle, spout: each for two, mirrored in y. */
static const double teapot_points[127][3] = {
    {0.2, 0, 2.7}, {0.2, -0.112, 2.7}, {0.112, -0.2, 2.7}, {0, -0.2, 2.7}, {1.3375, 0, 2.53125},
    {1.3375, -0.749, 2.53125}, {0.749, -1.3375, 2.53125}, {0, -1.3375, 2.53125},
    {1.4375, 0, 2.53125}, {1.4375, -0.805, 2.53125}, {0.805, -1.4375, 2.53125},
    {0, -1.4375, 2.53125}, {1.5, 0, 2.4}, {1.5, -0.84, 2.4}, {0.84, -1.5, 2.4}, {0, -1.5, 2.4},
    {1.75, 0, 1.875}, {1.75, -0.98, 1.875}, {0.98, -1.75, 1.875}, {0, -1.75, 1.875},
    {2, 0, 1.35}, {2, -1.12, 1.35}, {1.12, -2, 1.35}, {0, -2, 1.35}, {2, 0, 0.9},
    {2, -1.12, 0.9}, {1.12, -2, 0.9}, {0, -2, 0.9}, {-2, 0, 0.9}, {2, 0, 0.45}, {2, -1.12, 0.45},
    {1.12, -2, 0.45}, {0, -2, 0.45}, {1.5, 0, 0.225}, {1.5, -0.84, 0.225}, {0.84, -1.5, 0.225},
    {0, -1.5, 0.225}, {1.5, 0, 0.15}, {1.5, -0.84, 0.15}, {0.84, -1.5, 0.15}, {0, -1.5, 0.15},
    {-1.6, 0, 2.025}, {-1.6, -0.3, 2.025}, {-1.5, -0.3, 2.25}, {-1.5, 0, 2.25}, {-2.3, 0, 2.025},
    {-2.3, -0.3, 2.025}, {-2.5, -0.3, 2.25}, {-2.5, 0, 2.25}, {-2.7, 0, 2.025},
    {-2.7, -0.3, 2.025}, {-3, -0.3, 2.25}, {-3, 0, 2.25}, {-2.7, 0, 1.8}, {-2.7, -0.3, 1.8},
    {-3, -0.3, 1.8}, {-3, 0, 1.8}, {-2.7, 0, 1.575}, {-2.7, -0.3, 1.575}, {-3, -0.3, 1.35},
    {-3, 0, 1.35}, {-2.5, 0, 1.125}, {-2.5, -0.3, 1.125}, {-2.65, -0.3, 0.9375},
    {-2.65, 0, 0.9375}, {-2, -0.3, 0.9}, {-1.9, -0.3, 0.6}, {-1.9, 0, 0.6}, {1.7, 0, 1.425},
    {1.7, -0.66, 1.425}, {1.7, -0.66, 0.6}, {1.7, 0, 0.6}, {2.6, 0, 1.425}, {2.6, -0.66, 1.425},
    {3.1, -0.66, 0.825}, {3.1, 0, 0.825}, {2.3, 0, 2.1}, {2.3, -0.25, 2.1}, {2.4, -0.25, 2.025},
    {2.4, 0, 2.025}, {2.7, 0, 2.4}, {2.7, -0.25, 2.4}, {3.3, -0.25, 2.4}, {3.3, 0, 2.4},
    {2.8, 0, 2.475}, {2.8, -0.25, 2.475}, {3.525, -0.25, 2.49375}, {3.525, 0, 2.49375},
    {2.9, 0, 2.475}, {2.9, -0.15, 2.475}, {3.45, -0.15, 2.5125}, {3.45, 0, 2.5125},
    {2.8, 0, 2.4}, {2.8, -0.15, 2.4}, {3.2, -0.15, 2.4}, {3.2, 0, 2.4}, {0, 0, 3.15},
    {0.8, 0, 3.15}, {0.8, -0.45, 3.15}, {0.45, -0.8, 3.15}, {0, -0.8, 3.15}, {0, 0, 2.85},
    {1.4, 0, 2.4}, {1.4, -0.784, 2.4}, {0.784, -1.4, 2.4}, {0, -1.4, 2.4}, {0.4, 0, 2.55},
    {0.4, -0.224, 2.55}, {0.224, -0.4, 2.55}, {0, -0.4, 2.55}, {1.3, 0, 2.55},
    {1.3, -0.728, 2.55}, {0.728, -1.3, 2.55}, {0, -1.3, 2.55}, {1.3, 0, 2.4}, {1.3, -0.728, 2.4},
    {0.728, -1.3, 2.4}, {0, -1.3, 2.4}, {0, 0, 0}, {1.425, -0.798, 0}, {1.5, 0, 0.075},
    {1.425, 0, 0}, {0.798, -1.425, 0}, {0, -1.5, 0.075}, {0, -1.425, 0}, {1.5, -0.84, 0.075},
    {0.84, -1.5, 0.075},
};

static const unsigned char teapot_base[10][16] = {
    {102, 103, 104, 105, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},  /* rim */
    {12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27},  /* body */
    {24, 25, 26, 27, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40},  /* body */
    {96, 96, 96, 96, 97, 98, 99, 100, 101, 101, 101, 101, 0, 1, 2, 3},  /* lid */
    {0, 1, 2, 3, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115, 116, 117},  /* lid */
    {118, 118, 118, 118, 121, 119, 122, 124, 120, 125, 126, 123, 37, 38, 39, 40},  /* bottom */
    {41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56},  /* handle */
    {53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 28, 65, 66, 67},  /* handle */
    {68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83},  /* spout */
    {80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95},  /* spout */
};

enum { teapot_bottom = 5 };  /* its rows run from the axis outwards: against those of the body */

static const teapot_part teapot_parts[4] = {
    {"body", 4, 4, 0, 1, {0, 1, 2, teapot_bottom}},
    {"lid", 4, 2, 1, 0, {3, 4, 0, 0}},
    {"handle", 2, 2, 0, 0, {6, 7, 0, 0}},
    {"spout", 2, 2, 0, 0, {8, 9, 0, 0}},
};

static inline bezier_weights bezier_at(real s, real t)
{
    return (bezier_weights){{s * s * s, 3 * (s * s) * t, 3 * (t * t) * s, t * t * t},
                            {s * s, 2 * s * t, t * t}};
}

static inline vec3 bezier_sum(const real b[4], vec3 p0, vec3 p1, vec3 p2, vec3 p3)
{
    return vadd(vadd(vscale(p0, b[0]), vscale(p3, b[3])), vadd(vscale(p1, b[1]), vscale(p2, b[2])));
}

/* A third of the derivative. */
static inline vec3 bezier_slope(const real d[3], vec3 p0, vec3 p1, vec3 p2, vec3 p3)
{
    vec3 first = vscale(vsub(p1, p0), d[0]), last = vscale(vsub(p3, p2), d[2]);
    return vmadd(vadd(first, last), vsub(p2, p1), d[1]);
}

static inline vec3 bezier_point(const bezier_patch *c, const bezier_weights *u,
                                const bezier_weights *v, vec3 *n)
{
    vec3 row[4], slope[4];  /* each row's curve along u, and a third of its derivative */
    for (int j = 0; j < 4; j++) {
        const vec3 *p = c->p[j];
        row[j] = bezier_sum(u->b, p[0], p[1], p[2], p[3]);
        slope[j] = bezier_slope(u->d, p[0], p[1], p[2], p[3]);
    }
    if (n) {
        vec3 pu = bezier_sum(v->b, slope[0], slope[1], slope[2], slope[3]);
        vec3 pv = bezier_slope(v->d, row[0], row[1], row[2], row[3]);
        if (vzero(pu)) {  /* exactly so on the axis: differences of equal points, and weights 0 */
            pu = bezier_slope(v->d, slope[0], slope[1], slope[2], slope[3]);  /* P_uv */
            if (v->b[0] == 0) pu = vneg(pu);  /* at v = 1 the surface lies where dv < 0 */
        }
        *n = vunit(vcross(pu, pv));
    }
    return bezier_sum(v->b, row[0], row[1], row[2], row[3]);
}

/* Going around, the copies are: as given, mirrored in x, in x and y, in y (or as given, mirrored in
 * y). A mirror turns the patch inside out; running through it backwards turns it right again, and
 * its u goes on where the one before ended. */
static inline bezier_patch teapot_patch(const teapot_part *part, int ring, int copy)
{
    bezier_patch c;
    real sx = part->copies == 4 && (copy == 1 || copy == 2) ? -1 : 1;
    real sy = 2 * copy >= part->copies ? -1 : 1;
    for (int j = 0; j < 4; j++)
        for (int i = 0; i < 4; i++) {
            int row = part->base[ring] == teapot_bottom ? 3 - j : j, column = copy % 2 ? 3 - i : i;
            const double *p = teapot_points[teapot_base[part->base[ring]][4 * row + column]];
            c.p[j][i] = vec(sx * (real)p[0], sy * (real)p[1], p[2]);
        }
    return c;
}

static inline void teapot_triangle(mesh *m, size_t a, size_t b, size_t c)
{
    uint32_t *k = m->index + 3 * m->triangles;
    if (a == b || b == c || c == a) return;  /* touches the axis twice */
    k[0] = (uint32_t)a, k[1] = (uint32_t)b, k[2] = (uint32_t)c;
    m->triangles++;
}

/* Appends a part: its points row by row along v, its triangles. w[i] are the weights at i/n. */
static inline void teapot_add(mesh *m, const teapot_part *part, size_t n, const bezier_weights *w)
{
    size_t rows = (size_t)part->rings * n, columns = (size_t)part->copies * n, start = m->vertices;
    for (size_t j = 0; j <= rows; j++) {
        size_t ring = j < rows ? j / n : (rows - 1) / n;
        bool pole = (j == 0 && part->first_pole) || (j == rows && part->last_pole);
        for (size_t copy = 0; copy < (pole ? 1 : columns / n); copy++) {
            bezier_patch c = teapot_patch(part, (int)ring, (int)copy);
            for (size_t i = 0; i < (pole ? 1 : n); i++, m->vertices++)
                m->v[m->vertices] = bezier_point(&c, w + i, w + (j - ring * n), m->n + m->vertices);
        }
    }
    /* Row j begins at start + j columns, but a pole as first row has one point only. */
    size_t shift = part->first_pole ? columns - 1 : 0;
    for (size_t j = 0; j < rows; j++)
        for (size_t i = 0; i < columns; i++) {
            size_t above = start + j * columns, below = above + columns - shift;
            size_t next = (i + 1) % columns;
            bool first = j == 0 && part->first_pole, last = j + 1 == rows && part->last_pole;
            above -= j ? shift : 0;
            size_t a = above + (first ? 0 : i), b = above + (first ? 0 : next);
            size_t c = below + (last ? 0 : i), d = below + (last ? 0 : next);
            bool mirrored = i / n % 2 == 1;  /* and so are the diagonals */
            teapot_triangle(m, a, b, mirrored ? c : d);
            teapot_triangle(m, mirrored ? b : a, d, c);
        }
}

static inline mesh teapot_mesh(int wanted)
{
    size_t n = wanted < 1 ? 1 : wanted > 8000 ? 8000 : (size_t)wanted, length = 0;
    mesh m = {.vertices = 32 * n * n + 4 * n + 2, .triangles = 64 * n * n - 8 * n, .runs = 4};
    m.v = allocate(m.vertices, sizeof *m.v);
    m.n = allocate(m.normals = m.vertices, sizeof *m.n);
    m.index = allocate(3 * m.triangles, sizeof *m.index);
    m.run = allocate(m.runs, sizeof *m.run);
    m.names = allocate(32, 1);
    bezier_weights *w = allocate(n + 1, sizeof *w);
    for (size_t i = 0; i <= n; i++) w[i] = bezier_at((real)(n - i) / (real)n, (real)i / (real)n);
    m.vertices = m.triangles = 0;
    for (int k = 0; k < 4; k++) {
        m.run[k] = (mesh_run){(uint32_t)m.triangles, length};
        length += (size_t)snprintf(m.names + length, 32 - length, "%s", teapot_parts[k].name) + 1;
        teapot_add(&m, &teapot_parts[k], n, w);
    }
    free(w);
    return m;
}

#endif
