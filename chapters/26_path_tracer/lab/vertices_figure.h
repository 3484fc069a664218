/* vertices_figure.h: the drawing of this chapter: a path with its light samples and weights, in
 * the box of the pictures beside it: four hits, the metal first, and ended by the dice. The metal
 * is rougher here, so that both weights can be seen.
 *
 *   draw_vertices(&o);      26_path_tracer_vertices.svg
 *
 * path_step walks. Before each step the random numbers are copied, and path.h's own calls repeat
 * the light sample that the step is about to draw.
 */
#ifndef PATH_VERTICES_FIGURE_H
#define PATH_VERTICES_FIGURE_H

#include "../../../common/lab/figure.h"
#include "showcase.h"

enum { vertices_most = 64 };
typedef struct {
    vec3 p, lamp, beta, gain;
    real weight;               /* w_L */
    bool drawn, blocked;       /* a point of the lamp; is it in shadow? */
} vertex_seen;

/* ---------------------------------------------------------------------------------------------- */

cold_inline void vertices_light(const path_tracer *t, const path_walk *w, const lit_hit *x,
                                  path_random next, vertex_seen *v)
{
    lit_draw l;
    shading_frame f = shading_frame_of(x->s.ns);
    if (!lit_lights_sample(&t->light, POINTS_CHEAP, x->s.p, path_pair(&next), &l)) return;
    vec3 wi = to_local(f, l.wi);
    v->lamp = l.s.p, v->drawn = vdot(x->s.n, l.wi) > 0;
    v->blocked = lit_occluded_from(t->scene, lit_draw_ray(&x->s, &l), x->s.shape, l.emitter);
    v->weight = mis_power(l.pdf, brdf_pdf_local(&x->m->f, wi, to_local(f, vneg(vunit(w->r.d)))));
}

/* The number of hits. */
cold_inline int vertices_of(const path_tracer *t, ray eye, path_random s,
                              vertex_seen v[vertices_most])
{
    path_walk w = path_begin(eye);
    path_counts c = {0};
    int n = 0;
    for (bool on = true; on && n < vertices_most; n++) {
        lit_hit x = {.m = NULL};
        vec3 before = w.L;
        if (!lit_trace_from(t->scene, w.r, w.left, &x)) break;
        v[n] = (vertex_seen){.p = x.s.p, .beta = w.beta};
        vertices_light(t, &w, &x, s, &v[n]);
        on = path_step(t, &w, &s, &c);
        v[n].gain = vsub(w.L, before);
    }
    return n;
}

static inline figure_point vertices_place(camera c, vec3 p)
{
    real x = 0, y = 0;
    camera_project(c, p, 1, 1, &x, &y);
    return (figure_point){(double)x, 1 - (double)y};
}

/* From outside, through the red wall. */
static inline camera vertices_view(void)
{
    return showcase_eye(vec(1050, 430, -1150), vec(300, 255, 170), 31, 1);
}

/* Where the drawing of the eye's ray begins. */
static inline vec3 vertices_from(vec3 eye, const vertex_seen *v)
{
    return vadd(v[0].p, vscale(vsub(eye, v[0].p), (real)0.42));
}

/* The wall that the drawing looks through is tinted glass. */
static inline void vertices_wall(figure *g, camera c, const mesh *m, size_t quad)
{
    static const vec3 pale[cornell_parts] = {{246, 244, 240}, {244, 208, 200}, {212, 234, 208},
                                             {230, 159, 0}};
    triangle a = mesh_triangle(m, 2 * quad), b = mesh_triangle(m, 2 * quad + 1);
    const vec3 corner[4] = {a.a, a.b, a.c, b.c};
    vec3 n = vunit(vcross(vsub(a.b, a.a), vsub(a.c, a.a)));
    cornell_part part = cornell_of(2 * quad);
    bool faces = vdot(n, vsub(c.e, a.a)) > 0, lamp = part == CORNELL_LIGHT;
    vec3 fill = vscale(pale[part], lamp ? 1 : 1 - (real)0.04 * fabs(n.y));
    double xy[8];
    char colour[16];
    snprintf(colour, sizeof colour, "#%02x%02x%02x", (unsigned)fill.x, (unsigned)fill.y,
             (unsigned)fill.z);
    for (int i = 0; i < 4; i++) {
        figure_point p = vertices_place(c, corner[i]);
        xy[2 * i] = p.x, xy[2 * i + 1] = p.y;
    }
    bool edges = part != CORNELL_WHITE || fabs(n.y) < (real)0.5;
    figure_polygon(g, 4, xy, colour, faces ? 1 : 0.35, edges ? "#bbbbbb" : colour);
}

static inline void vertices_room(figure *g, camera c, const lit_scene *s)
{
    enum { red = 7, walls = cornell_room / 2 };
    static const char *const colour[2] = {"#d8d2c4", "#c8c8c8"};
    mesh m = cornell_mesh();
    for (size_t k = 0; k < walls; k++)
        if (k != red) vertices_wall(g, c, &m, k);
    for (size_t k = s->shapes; k-- > 0;) {
        if (s->shape[k].kind != SHAPE_SPHERE) continue;
        sphere ball = s->shape[k].sphere;
        figure_point p = vertices_place(c, ball.c);
        figure_point q = vertices_place(c, vmadd(ball.c, c.u, ball.r));
        figure_dot(g, p.x, p.y, g->unit * hypot(q.x - p.x, q.y - p.y), colour[k % 2]);
    }
    vertices_wall(g, c, &m, red);
    mesh_free(&m);
}

/* The n hits of a path, with their light samples. */
static inline void vertices_path(figure *g, camera c, vec3 eye, const vertex_seen *v, int n)
{
    figure_point p[vertices_most], y[vertices_most], from;
    for (int k = 0; k < n; k++) {
        p[k] = vertices_place(c, v[k].p), y[k] = vertices_place(c, v[k].lamp);
        if (v[k].drawn) figure_line(g, p[k].x, p[k].y, y[k].x, y[k].y,
                                    v[k].blocked ? FIGURE_GREY : FIGURE_ORANGE, 2, FIGURE_DASHED);
    }
    for (int k = 0; k < n; k++) {
        from = k ? p[k - 1] : vertices_place(c, vertices_from(eye, v));
        figure_arrow(g, from.x, from.y, p[k].x, p[k].y, FIGURE_BLUE, 2);
    }
    for (int k = 0; k < n; k++) {
        if (v[k].drawn) figure_dot(g, y[k].x, y[k].y, 3.5, v[k].blocked ? FIGURE_GREY : FIGURE_RED);
        figure_dot(g, p[k].x, p[k].y, 5, FIGURE_BLUE);
        figure_print(g, p[k].x, p[k].y, 9, 16, FIGURE_LEFT, FIGURE_BLACK, "*x*~%d~", k);
    }
}

/* Of three channels the green one: what each vertex adds to the pixel. */
static inline void vertices_rows(figure *g, const vertex_seen *v, int n)
{
    const double column[5] = {0, 50, 130, 210, 300}, row = 34, below = -row * n;
    static const char *const title[5] = {"hit", "_β_~k~", "_w_~L~", "_w_~B~", "adds to _L_"};
    double sum = 0;
    for (int k = 0; k < 5; k++)
        figure_text(g, column[k], 0, 0, 0, FIGURE_LEFT, FIGURE_BLACK, title[k]);
    figure_line(g, 0, -12, 420, -12, FIGURE_GREY, 1, FIGURE_WHOLE);
    for (int k = 0; k < n; k++) {
        double y = -row * (k + 1), gain = (double)v[k].gain.y, w = (double)v[k].weight;
        figure_print(g, column[0], y, 0, 0, FIGURE_LEFT, FIGURE_BLUE, "*x*~%d~", k);
        figure_print(g, column[1], y, 0, 0, FIGURE_LEFT, FIGURE_BLACK, "%.3f", (double)v[k].beta.y);
        figure_print(g, column[2], y, 0, 0, FIGURE_LEFT, FIGURE_BLACK, "%.4f", w);
        figure_print(g, column[3], y, 0, 0, FIGURE_LEFT, FIGURE_BLACK, "%.4f", 1 - w);
        figure_print(g, column[4], y, 0, 0, FIGURE_LEFT, gain > 0 ? FIGURE_RED : FIGURE_GREY,
                     v[k].blocked ? "0: shadow" : v[k].drawn ? "%.4f" : "0: behind", gain);
        sum += gain;
    }
    figure_line(g, 0, below - 12, 420, below - 12, FIGURE_GREY, 1, FIGURE_WHOLE);
    figure_print(g, 0, below - row, 0, 0, FIGURE_LEFT, FIGURE_BLACK,
                 "the dice end it at *x*~%d~; this path brings", n - 1);
    figure_print(g, column[4], below - row, 0, 0, FIGURE_LEFT, FIGURE_RED, "%.4f", sum);
}

/* Of the pixels that the metal shows the lamp in, one whose path has four hits that are far enough
 * apart, and on the metal two weights that count: found by trying. */
cold_inline void draw_vertices(const options *o)
{
    enum { side = 100, x = 39, y = 62, tried = 114 };
    shot s;
    vertex_seen v[vertices_most];
    shot_of(&s, o, "metal", path_defaults, side, side);
    s.c.s.material[cornell_parts].f = brdf_ggx(vec(0.95, 0.93, 0.88), (real)0.3);
    path_random r = path_start(&s.t.how, 1, tried, 0, 1);
    point2 u = path_pair(&r);
    int n = vertices_of(&s.t, camera_ray(s.c.eye, x + u.u, y + u.v, side, side), r, v);
    camera c = vertices_view();
    figure_point e = vertices_place(c, vertices_from(s.c.eye.e, v));
    figure_point lamp = vertices_place(c, v[0].lamp);
    figure_point metal = vertices_place(c, (vec3){390, 30, 350});
    figure g = figure_begin(o, "26_path_tracer_vertices.svg", 940, 480);
    figure_origin(&g, 0, 480, 480);
    vertices_room(&g, c, &s.c.s);
    vertices_path(&g, c, s.c.eye.e, v, n);
    figure_text(&g, lamp.x, lamp.y, 0, -14, FIGURE_MIDDLE, FIGURE_BLACK, "lamp");
    figure_text(&g, metal.x, metal.y, 0, 0, FIGURE_MIDDLE, FIGURE_BLACK, "metal");
    figure_text(&g, e.x, e.y, -4, 18, FIGURE_MIDDLE, FIGURE_BLACK, "from the eye");
    figure_origin(&g, 500, 130, 1);
    vertices_rows(&g, v, n);
    figure_end(&g);
    shot_free(&s);
}

#endif
