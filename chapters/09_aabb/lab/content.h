/* content.h: a ray that hits the volume need not hit what is in it (误报): how often it does not.
 *
 *   aabb_content c = content_of(k);   shape k [0..4]: needle, triangle, ball, ring, teapot, and the
 *                                     volumes round it; the caller frees c.t
 *   content_hit(&c, kind, r, &t)      is the volume hit? 0: sphere, 1: box, 2: turned box
 *   content_in_vain(&c, seed, n, vain)   of n lines that hit a volume: those that hit nothing
 *                                     inside [%]; returns how many hit something and not its volume
 *   measure_volumes(&o)               all of them in a table, with the time of a test
 *
 * For a convex shape and lines from everywhere alike, P(shape hit | volume hit) = area of the shape
 * / area of the volume (9.6), if the volume is convex, too; both sides of a flat shape count.
 * Sources: A. Cauchy, "Mémoire sur la rectification des courbes et la quadrature des surfaces
 * courbes", 1832; J. Goldsmith, J. Salmon, "Automatic creation of object hierarchies for ray
 * tracing", IEEE CG&A 7(5), 1987 (what it means for boxes).
 */
#ifndef AABB_CONTENT_H
#define AABB_CONTENT_H

#include "../../04_triangle/scenes/icosphere.h"
#include "../../04_triangle/triangle.h"
#include "../../07_mesh/scenes/specimens.h"
#include "../../07_mesh/scenes/teapot.h"
#include "methods.h"

enum { content_shapes = 5, content_kinds = 3 };
typedef struct {
    triangle *t;
    size_t n;
    aabb_ball ball;
    aabb box;
    aabb_turned turned;
} aabb_content;

/* ---------------------------------------------------------------------------------------------- */

static inline triangle *content_triangles(mesh m, size_t *n)
{
    triangle *t = allocate(m.triangles, sizeof *t);
    for (size_t i = 0; i < m.triangles; i++) t[i] = mesh_triangle(&m, i);
    *n = m.triangles;
    mesh_free(&m);
    return t;
}

static inline triangle *content_shape(int k, size_t *n)
{
    static const triangle one[] = {{{0, 0, 0}, {1, 1, 1}, {0.51, 0.49, 0.5}},
                                   {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    if (k > 2) return content_triangles(k == 3 ? torus_mesh(20) : teapot_mesh(5), n);
    icosphere m = icosphere_new(3, (vec3){0, 0, 0}, 1);
    *n = k < 2 ? 1 : m.triangles;
    triangle *t = allocate(*n, sizeof *t);
    for (uint32_t i = 0; i < *n; i++) t[i] = k < 2 ? one[k] : icosphere_triangle(&m, i);
    icosphere_free(&m);
    return t;
}

static inline aabb_content content_of(int k)
{
    aabb_content c = {.box = aabb_empty()};
    c.t = content_shape(k, &c.n);
    vec3 *p = allocate(3 * c.n, sizeof *p);
    for (size_t i = 0; i < c.n; i++) {
        p[3 * i] = c.t[i].a, p[3 * i + 1] = c.t[i].b, p[3 * i + 2] = c.t[i].c;
        c.box = aabb_union(c.box, first_triangle_box(c.t[i]));
    }
    c.ball = ball_round(p, 3 * c.n), c.turned = turned_round(p, 3 * c.n);
    free(p);
    return c;
}

static inline bool content_hit(const aabb_content *c, int kind, ray r, real *t)
{
    if (kind == 0) return bounding_ball_hit(&c->ball, 1 / vdot(r.d, r.d), r, t);
    return kind == 1 ? aabb_hit(c->box, r, t) : turned_hit(&c->turned, r, t);
}

static inline bool content_any(const aabb_content *c, ray r)
{
    hit h;
    for (size_t i = 0; i < c->n; i++)
        if (triangle_hit(c->t[i], r, &h)) return true;
    return false;
}

/* A box round all three volumes: lines are drawn from those through the sphere round it. */
static inline aabb content_room(const aabb_content *c)
{
    vec3 r = {c->ball.r, c->ball.r, c->ball.r};
    aabb room = aabb_union(c->box, (aabb){vsub(c->ball.c, r), vadd(c->ball.c, r)});
    real reach = vlength(c->turned.half);
    r = (vec3){reach, reach, reach};
    return aabb_union(room, (aabb){vsub(c->turned.c, r), vadd(c->turned.c, r)});
}

static inline size_t content_in_vain(const aabb_content *c, uint64_t seed, size_t n,
                                     double vain[content_kinds])
{
    size_t hits[content_kinds] = {0}, good = 0, lost = 0;
    aabb room = content_room(c);
    for (size_t i = 0; i < n; i++) {
        ray line = line_through(room, seed, i);
        bool in[content_kinds], any = false;
        real t;
        for (int k = 0; k < content_kinds; k++) any |= in[k] = content_hit(c, k, line, &t);
        bool inside = any && content_any(c, line);
        good += inside;
        for (int k = 0; k < content_kinds; k++) hits[k] += in[k], lost += inside && !in[k];
    }
    for (int k = 0; k < content_kinds; k++) vain[k] = per_cent(hits[k] - good, hits[k]);
    return lost;
}

static inline void measure_volumes(const options *o)
{
    static double (*const pass[])(void *) = {pass_ball, pass_default, pass_turned};
    static const char *const name[content_kinds] = {
        "sphere, d.d kept", "box, 1/d kept", "turned box, divides"};
    double vain[content_shapes][content_kinds], ns[content_kinds];
    for (int s = 0; s < content_shapes; s++) {
        aabb_content c = content_of(s);
        content_in_vain(&c, o->seed, 20000, vain[s]);
        free(c.t);
    }
    time_passes(o, content_kinds, pass, ns);
    table t = table_new("Of the lines that hit a volume, how many hit nothing in it",
                        "volume|needle [%]|triangle [%]|ball [%]|ring [%]|teapot [%]|time [ns]");
    for (int k = 0; k < content_kinds; k++) {
        table_text(&t, "%s", name[k]);
        for (int s = 0; s < content_shapes; s++) table_number(&t, vain[s][k]);
        table_number(&t, ns[k]);
    }
    output_extra_table(o, &t);
}

#endif
