/* torture.h: meshes and rays whose answers are known exactly, by classes of what goes wrong.
 *
 *   torture t = torture_make(k, n, seed)    class k < torture_classes, n rays
 *   t.m, t.r[n], t.due[n]                   its mesh, its rays, and what each of them meets
 *   torture_fault x = torture_judge(&t, i, h, &t_error)   a hit, or hit_none, for ray i
 *   torture_free(&t)
 *
 * Corners, origins and directions are whole numbers below 2^23, and every end of an interval is a
 * float: files in text and in float32 keep them. A determinant of three differences is then a whole
 * number below 2^75; t is a fraction of two of them, and fractions are compared as Euclid does,
 * quotient by quotient. So nothing here is rounded, and no tolerance decides which triangle is met;
 * in double, the same determinants lose up to twenty bits. A triangle seen edge-on is not hit:
 * whoever meets its edge meets the neighbour's, too. Several triangles may be met at the very same
 * t: any of them is right.
 *
 * Each ray goes through a surface, not past its rim: whoever moves it by a rounding, as a search in
 * floating point does, still meets one of the same triangles. (At a rim or a silhouette a rounding
 * decides between hit and miss, and none of the two is a fault.)
 */
#ifndef TRIALS_TORTURE_H
#define TRIALS_TORTURE_H

#include "../../07_mesh/scenes/soup.h"
#include "../../01_ray/hit.h"

/* A machine without 128 bits takes smaller numbers, which a double holds, too. */
#ifdef __SIZEOF_INT128__
__extension__ typedef __int128 torture_int;
enum { torture_bits = 22 };
#else
typedef int64_t torture_int;
enum { torture_bits = 17 };
#endif

typedef struct { torture_int num, den; } torture_t;       /* t = num / den, den > 0; 0: no hit */
typedef struct { torture_t t; uint32_t shape; } torture_hit;  /* the lowest of those it may be */
typedef struct { mesh m; ray *r; torture_hit *due; size_t n; } torture;
typedef enum { TORTURE_RIGHT, TORTURE_LOST, TORTURE_INVENTED, TORTURE_ASTRAY } torture_fault;

enum { torture_classes = 12, torture_cells = 16 };

typedef enum { AIM_INSIDE, AIM_EDGE, AIM_CORNER, AIM_AXIS, AIM_RIM } torture_aim;
typedef enum { ON_TERRAIN, ON_FLAT, ON_NEEDLES, ON_COPIES, ON_TWICE } torture_ground;
typedef enum { FROM_ABOVE, FROM_FAR, FROM_THERE } torture_origin;

typedef struct {
    const char *name, *what;
    torture_ground ground;
    torture_aim aim;
    torture_origin from;
    bool ends;            /* the interval ends just behind the hit, or just before it */
} torture_class;

static const torture_class torture_list[torture_classes] = {
    {"inside", "well inside a triangle: nothing is hard here",
     ON_TERRAIN, AIM_INSIDE, FROM_ABOVE, false},
    {"edges", "at an edge that two triangles share", ON_TERRAIN, AIM_EDGE, FROM_ABOVE, false},
    {"corners", "at a corner that six share", ON_TERRAIN, AIM_CORNER, FROM_ABOVE, false},
    {"axes", "along an axis, at edges: 0 and -0 in d", ON_TERRAIN, AIM_AXIS, FROM_ABOVE, false},
    {"plane", "in the plane of all triangles: nothing is met", ON_FLAT, AIM_RIM, FROM_ABOVE, false},
    {"flat", "at edges of a mesh in one plane: a box of no thickness",
     ON_FLAT, AIM_EDGE, FROM_ABOVE, false},
    {"far", "at edges, from 4000 cells away", ON_TERRAIN, AIM_EDGE, FROM_FAR, false},
    {"needles", "at edges of triangles 16000 times as long as wide",
     ON_NEEDLES, AIM_EDGE, FROM_ABOVE, false},
    {"copies", "inside triangles that lie there three times",
     ON_COPIES, AIM_INSIDE, FROM_ABOVE, false},
    {"ties", "at edges of two sheets that touch there", ON_TWICE, AIM_EDGE, FROM_ABOVE, false},
    {"ends", "intervals that begin or end 1/4000 from the hit",
     ON_TERRAIN, AIM_EDGE, FROM_ABOVE, true},
    {"start", "origins on an edge, tmin > 0: not that edge again",
     ON_TERRAIN, AIM_EDGE, FROM_THERE, false},
};

/* ---------------------------------------------------------------------------------------------- */

static inline int torture_below(random_stream *g, int n)
{
    return (int)(random_next_bits(g) % (uint64_t)n);
}

/* A grid of points, moved a little, with heights, each cell cut in two; `twice`: by the other
 * diagonal, too. All are multiples of 4, so that a quarter of an edge is whole. */
static inline mesh torture_terrain(random_stream *g, bool flat, int step, int copies, bool twice)
{
    enum { n = torture_cells, row = n + 1 };
    static const int by[2][6] = {{0, 1, row, row, 1, row + 1}, {0, 1, row + 1, 0, row + 1, row}};
    mesh m = {.vertices = row * row};
    m.v = allocate(m.vertices, sizeof *m.v);
    m.index = allocate(6 * n * n * (size_t)copies * (twice ? 2 : 1), sizeof *m.index);
    for (int i = 0; i < row * row; i++)
        m.v[i] = vec(step * (i % row - n / 2) + 4 * torture_below(g, step / 12),
                     step * (i / row - n / 2) + 4 * torture_below(g, step / 12),
                     flat ? 0 : 4 * torture_below(g, step / 2));
    uint32_t *corner = m.index;
    for (int copy = 0; copy < copies; copy++)
        for (int way = 0; way <= twice; way++)
            for (int i = 0; i < n * n; i++)
                for (int k = 0; k < 6; k++)
                    *corner++ = (uint32_t)(i / n * row + i % n + by[way][k]);
    m.triangles = (size_t)(corner - m.index) / 3;
    return m;
}

/* A fan: each triangle 2^22 long and 256 wide. */
static inline mesh torture_needles(random_stream *g)
{
    enum { n = 200 };
    mesh m = {.vertices = n + 2, .triangles = n};
    m.v = allocate(m.vertices, sizeof *m.v);
    m.index = allocate(3 * n, sizeof *m.index);
    m.v[0] = vec(0, 0, 0);
    for (int i = 0; i <= n; i++)
        m.v[i + 1] = vec(1 << torture_bits, 256 * (i - n / 2), 4 * torture_below(g, 64));
    for (uint32_t i = 0; i < n; i++)
        m.index[3 * i] = 0, m.index[3 * i + 1] = i + 1, m.index[3 * i + 2] = i + 2;
    return m;
}

static inline mesh torture_mesh(torture_ground k, int step, random_stream *g)
{
    return k == ON_NEEDLES ? torture_needles(g)
        : torture_terrain(g, k == ON_FLAT, step, k == ON_COPIES ? 3 : 1, k == ON_TWICE);
}

static inline int torture_divisor(vec3 d)
{
    long v[3] = {labs((long)d.x), labs((long)d.y), labs((long)d.z)}, a = v[0];
    for (int k = 1; k < 3; k++)
        for (long b = v[k]; b != 0;) {
            long rest = a % b;
            a = b, b = rest;
        }
    return a > 0 ? (int)a : 1;
}

/* Where two sheets end together, their shares are those of one that goes on. */
static inline bool torture_at_rim(triangle s, int step)
{
    for (int k = 0; k < 6; k++) {
        int cell = (int)floor((double)vaxis((&s.a)[k / 2], k % 2) / step) + torture_cells / 2;
        if (cell == 0 || cell == torture_cells) return true;
    }
    return false;
}

/* d has no common divisor, so that t is whole where the ray meets the point it is aimed at. */
static inline ray torture_ray(const mesh *m, const torture_class *c, int step, random_stream *g)
{
    triangle tri;
    do tri = mesh_triangle(m, (size_t)torture_below(g, (int)m->triangles));
    while (c->ground == ON_TWICE && torture_at_rim(tri, step));
    vec3 ab = vsub(tri.b, tri.a), ac = vsub(tri.c, tri.a), p = tri.a, o, d;
    int far = (1 << torture_bits) - 1, spread = 1 << (torture_bits - 1);
    int k = 1 + torture_below(g, 3);
    if (c->aim == AIM_INSIDE)
        p = vmadd(vmadd(p, ab, (real)0.25), ac, (real)0.25 * (real)(1 + k % 2));
    if (c->aim == AIM_EDGE || c->aim == AIM_AXIS)
        p = vmadd(p, torture_below(g, 2) ? ab : ac, (real)0.25 * (real)k);
    o = vadd(p, vec(torture_below(g, spread) - spread / 2, torture_below(g, spread) - spread / 2,
                    spread / 8 + torture_below(g, spread / 2)));
    if (c->from == FROM_FAR)
        o = vec(torture_below(g, 2) ? far : -far, torture_below(g, 9) - 4,
                far / 8 * (1 + torture_below(g, 7)));
    if (c->aim == AIM_AXIS) o = vec(p.x, p.y, torture_below(g, 2) ? far : -far);
    if (c->aim == AIM_RIM) o.z = 0;
    d = vsub(p, o);
    if (c->from == FROM_THERE) d = vsub(o, p), o = p;
    d = vscale(d, 1 / (real)torture_divisor(d));
    d = vec(rint(d.x), rint(d.y), rint(d.z));
    if (torture_below(g, 2) && d.x == 0) d.x = -d.x;  /* 0 and -0 */
    ray r = ray_from(o, d);
    if (c->from == FROM_THERE) r.tmin = (real)0x1p-10;
    return r;
}

/* a.(b x c) of whole numbers. */
static inline torture_int torture_volume(vec3 a, vec3 b, vec3 c)
{
    torture_int x[3][3];
    const vec3 *of[3] = {&a, &b, &c};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) x[i][k] = (int64_t)vaxis(*of[i], k);
    return x[0][0] * (x[1][1] * x[2][2] - x[1][2] * x[2][1])
           + x[0][1] * (x[1][2] * x[2][0] - x[1][0] * x[2][2])
           + x[0][2] * (x[1][0] * x[2][1] - x[1][1] * x[2][0]);
}

static inline torture_int torture_floor(torture_t t)
{
    return t.num / t.den - (t.num % t.den < 0);
}

/* a < b, by their continued fractions: equal whole parts leave two remainders below 1, and of those
 * the one with the larger reciprocal is the lesser. */
static inline bool torture_less(torture_t a, torture_t b)
{
    for (;;) {
        torture_int whole_a = torture_floor(a), whole_b = torture_floor(b);
        torture_int rest_a = a.num - whole_a * a.den, rest_b = b.num - whole_b * b.den;
        if (whole_a != whole_b) return whole_a < whole_b;
        if (rest_a == 0 || rest_b == 0) return rest_a == 0 && rest_b != 0;
        torture_t next = {b.den, rest_b};
        b = (torture_t){a.den, rest_a}, a = next;
    }
}

/* A float of a size between 2^-16 and 2^30, or 0. */
static inline torture_t torture_fraction(real x)
{
    double num = (double)x;
    torture_int den = 1;
    while (num != floor(num)) num *= 2, den *= 2;
    return (torture_t){(torture_int)num, den};
}

/* The volumes of d with the three edges have one sign; t is that of o, in units of their sum (4.8).
 * *share: in sixths, how much of a neighbourhood is this triangle's where it is met: all, at an
 * edge half, at a corner one of six; below 0 if it is met from behind. */
static inline torture_t torture_meet(const mesh *m, size_t i, ray r, int *share)
{
    const torture_t none = {0, 0};
    triangle s = mesh_triangle(m, i);
    vec3 a = vsub(s.a, r.o), b = vsub(s.b, r.o), c = vsub(s.c, r.o);
    torture_int u = torture_volume(r.d, c, b), v = torture_volume(r.d, a, c), w;
    *share = 0;
    if ((u < 0 && v > 0) || (u > 0 && v < 0)) return none;
    w = torture_volume(r.d, b, a);
    torture_int den = u + v + w, num = torture_volume(a, c, b), sign = den < 0 ? -1 : 1;
    torture_t t = {sign * num, sign * den};
    int zeros = (u == 0) + (v == 0) + (w == 0);
    *share = (int)sign * (zeros == 0 ? 6 : zeros == 1 ? 3 : 1);
    if (den == 0 || sign * u < 0 || sign * v < 0 || sign * w < 0) return none;
    if (torture_less(t, torture_fraction(r.tmin))) return none;
    if (isfinite(r.tmax) && torture_less(torture_fraction(r.tmax), t)) return none;
    return t;
}

/* *through: do the triangles that are met at this t leave no gap around the ray? */
static inline torture_hit torture_due(const mesh *m, ray r, bool *through)
{
    torture_hit best = {{0, 0}, no_shape};
    int share, sum = 0, size = 0;
    for (size_t i = 0; i < m->triangles; i++) {
        torture_t t = torture_meet(m, i, r, &share);
        if (t.den == 0 || (best.shape != no_shape && torture_less(best.t, t))) continue;
        if (best.shape == no_shape || torture_less(t, best.t))
            best = (torture_hit){t, (uint32_t)i}, sum = size = 0;
        sum += share, size += abs(share);
    }
    *through = size % 6 == 0 && abs(sum) == size;
    return best;
}

/* Floats, as in the files; 1/4096 is more than a float search is off. */
static inline void torture_cut(ray *r, torture_t t, random_stream *g)
{
    float at = (float)((double)t.num / (double)t.den);
    float behind = at * (1 + 0x1p-12F), before = at * (1 - 0x1p-12F);
    switch (torture_below(g, 4)) {
    case 0: r->tmin = (real)before, r->tmax = (real)behind; break;
    case 1: r->tmax = (real)behind; break;
    case 2: r->tmax = (real)before; break;
    default: r->tmin = (real)behind; break;
    }
}

static inline torture torture_make(int k, size_t n, uint64_t seed)
{
    const torture_class *c = &torture_list[k];
    int step = 1 << (torture_bits - (c->from == FROM_FAR ? 12 : 5));  /* between points */
    random_stream g = random_start(seed, (uint64_t)k, 0);
    torture t = {torture_mesh(c->ground, step, &g), NULL, NULL, n};
    t.r = allocate(n, sizeof *t.r);
    t.due = allocate(n, sizeof *t.due);
    for (size_t i = 0; i < n;) {
        bool through;
        t.r[i] = torture_ray(&t.m, c, step, &g);
        t.due[i] = torture_due(&t.m, t.r[i], &through);
        if (c->ends && t.due[i].shape != no_shape) {
            torture_cut(&t.r[i], t.due[i].t, &g);
            t.due[i] = torture_due(&t.m, t.r[i], &through);
        }
        i += through;  /* else another one in its place */
    }
    return t;
}

static inline void torture_free(torture *t)
{
    mesh_free(&t->m), free(t->r), free(t->due);
    *t = (torture){.n = 0};
}

/* The t of the farthest coordinate: an origin is no better known than a part of that. */
static inline double torture_reach(ray r)
{
    double o = (double)(1 << (torture_bits - 2)), d = 1;
    for (int k = 0; k < 3; k++) {
        o = fmax(o, fabs((double)vaxis(r.o, k)));
        d = fmax(d, fabs((double)vaxis(r.d, k)));
    }
    return o / d;
}

/* *error: how far off t is, in roundings of float (2^-24). */
enum { torture_most_off = 4096 };  /* some search all in float reaches hundreds: see torture_cut */
static inline torture_fault torture_judge(const torture *t, size_t i, hit h, double *error)
{
    torture_hit due = t->due[i];
    int share;
    *error = 0;
    if (h.shape == no_shape) return due.shape == no_shape ? TORTURE_RIGHT : TORTURE_LOST;
    if (due.shape == no_shape) return TORTURE_INVENTED;
    if (h.shape >= t->m.triangles) return TORTURE_ASTRAY;
    torture_t met = torture_meet(&t->m, h.shape, t->r[i], &share);
    if (met.den == 0 || torture_less(due.t, met) || torture_less(met, due.t))
        return TORTURE_ASTRAY;  /* nearer than the nearest would be a fault of this judge */
    double exact = (double)due.t.num / (double)due.t.den;
    *error = fabs((double)h.t - exact) / (0x1p-24 * fmax(fabs(exact), torture_reach(t->r[i])));
    return *error <= torture_most_off ? TORTURE_RIGHT : TORTURE_ASTRAY;  /* a NaN is astray */
}

#endif
