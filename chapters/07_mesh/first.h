/* first.h: a mesh of triangles, from a file or made here; its closest hit by asking every triangle.
 * Wrong: a ray through an edge or a corner counts no triangle or several, so that parity (7.2)
 * misclassifies points. inside.h mends it. At most 2^31 - 1 triangles; O(n) a ray: 09 to 14. */
#ifndef FIRST_MESH_H
#define FIRST_MESH_H
#include "../04_triangle/first.h"
#include "../../common/image.h"

typedef struct { triangle *tri; int n; } first_mesh;

static long first_tests;  /* tests of a ray against a triangle, since the program began */

/* Does the ray hit triangle i? Then *best is that hit, and the ray ends there: what lies beyond
 * cannot be the closest. All searches of 07 to 17 go through here. */
static inline bool first_mesh_test(const first_mesh *m, int i, ray *r, hit *best)
{
    hit h;
    first_tests++;
    if (!first_triangle_hit(m->tri[i], *r, &h)) return false;
    *best = h;
    best->shape = (uint32_t)i;
    r->tmax = h.t;
    return true;
}

/* t = the smallest t_i in [tmin, tmax]                                                    (7.1) */
static inline bool first_mesh_hit(const first_mesh *m, ray r, hit *out)
{
    bool found = false;
    for (int i = 0; i < m->n; i++)
        if (first_mesh_test(m, i, &r, out)) found = true;
    return found;
}

/* Parity (奇偶性): from inside a closed mesh any way out crosses it an odd number of times. (7.2) */
static inline bool first_mesh_inside(const first_mesh *m, vec3 p, vec3 d)
{
    int hits = 0;
    hit h;
    for (int i = 0; i < m->n; i++) {
        first_tests++;
        if (first_triangle_hit(m->tri[i], ray_from(p, d), &h)) hits++;
    }
    return hits % 2 == 1;
}

/* Unit normal of triangle i, on the side that the ray comes from. */
static inline vec3 first_mesh_normal(const first_mesh *m, uint32_t i, vec3 d)
{
    vec3 n = first_triangle_normal(m->tri[i]);
    return vdot(n, d) < 0 ? n : vneg(n);
}

/* ------------------------------------------------------------------------------------------------
 * OBJ files: lines `v x y z`, a point, and `f i j k ...`, a polygon of points that came before it:
 * i counts from 1, or, if negative, back from the last; of `i/j/k` it is i. All else is skipped. */

static inline void first_obj_error(const char *path, int line, const char *what)
{
    failure f;
    failed(&f, 2, "%.300s: line %d: %s", path, line, what), fail(f);
}

/* The whole file as triangles, a polygon as a fan round its first corner; a broken one ends the
 * program, with its line. (file_read, grown, fail: common/file.h, which image.h brings along.) */
static inline first_mesh first_obj_read(const char *path)
{
    failure why;
    size_t bytes, points = 0, point_room = 0, room = 0;
    char *text = file_read(path, &bytes, &why), *next = text, *end;
    if (!text) fail(why);
    vec3 *point = NULL;
    first_mesh m = {NULL, 0};
    for (int line = 1; next; line++) {
        char *s = next + strspn(next, " \t");
        next = strchr(s, '\n');
        if (next) *next++ = 0;
        else if (s + strlen(s) < text + bytes) first_obj_error(path, line, "not a text");
        if (s[0] == 'v' && strchr(" \t\r", s[1])) {  /* or the line ends: strchr finds a 0 */
            double x[3];
            s++;
            for (int k = 0; k < 3; k++, s = end) {
                x[k] = strtod(s, &end);
                if (end == s || !(fabs(x[k]) < 1e15)) first_obj_error(path, line, "not a point");
            }
            point = grown(point, points, &point_room, sizeof *point);
            point[points++] = vec(x[0], x[1], x[2]);
        } else if (s[0] == 'f' && strchr(" \t\r", s[1])) {
            triangle t = {vec(0, 0, 0), vec(0, 0, 0), vec(0, 0, 0)};
            int corners = 0;
            for (s++; ; s = end + strcspn(end, " \t\r")) {
                long i = strtol(s, &end, 10);
                if (end == s) break;
                if (i < 0) i += (long)points + 1;
                if (i < 1 || i > (long)points) first_obj_error(path, line, "no such point");
                t.b = t.c, t.c = point[i - 1];
                if (corners++ == 0) t.a = t.c;
                if (corners < 3) continue;
                m.tri = grown(m.tri, (size_t)m.n, &room, sizeof *m.tri);
                m.tri[m.n++] = t;
            }
            if (corners < 3) first_obj_error(path, line, "a face has three corners or more");
        }
    }
    return free(text), free(point), m;
}

/* A closed tube along the knot (2 + cos 3a) (cos 2a, sin 2a), sin 3a: 2 steps x sides triangles. */
static inline vec3 first_knot_point(real a)
{
    return vec((2 + cos(3 * a)) * cos(2 * a), (2 + cos(3 * a)) * sin(2 * a), sin(3 * a));
}

static inline vec3 first_tube_point(int i, int steps, int j, int sides)
{
    real a = 2 * pi * i / steps, b = 2 * pi * j / sides;
    vec3 p = first_knot_point(a), along = vunit(vsub(first_knot_point(a + 0.01), p));
    vec3 x = vunit(vcross(along, p)), y = vcross(along, x);
    return vadd(p, vadd(vscale(x, 0.5 * cos(b)), vscale(y, 0.5 * sin(b))));
}

static inline first_mesh first_knot(int steps, int sides)
{
    first_mesh m = {allocate(2 * (size_t)steps * (size_t)sides, sizeof *m.tri), 0};
    for (int i = 0; i < steps; i++)
        for (int j = 0; j < sides; j++) {
            int i2 = (i + 1) % steps, j2 = (j + 1) % sides;
            vec3 a = first_tube_point(i, steps, j, sides);
            vec3 b = first_tube_point(i2, steps, j, sides);
            vec3 c = first_tube_point(i2, steps, j2, sides);
            vec3 d = first_tube_point(i, steps, j2, sides);
            m.tri[m.n++] = (triangle){a, c, b};
            m.tri[m.n++] = (triangle){a, d, c};
        }
    return m;
}

/* A colour of the rainbow, x in [0,1): to tell the cells of a structure apart. */
static inline vec3 first_tint(real x)
{
    return vec(0.5 + 0.45 * cos(2 * pi * x), 0.5 + 0.45 * cos(2 * pi * (x - 1 / 3.0)),
               0.5 + 0.45 * cos(2 * pi * (x - 2 / 3.0)));
}

static inline void first_mesh_free(first_mesh *m)
{
    free(m->tri);
    *m = (first_mesh){NULL, 0};
}
#endif
