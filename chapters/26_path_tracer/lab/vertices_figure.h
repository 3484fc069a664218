/* vertices_figure.h: the drawing of this chapter: a path with its light samples and weights, in
 * the box of the pictures beside it: four hits, the metal first, and ended by the dice. The metal
 * is rougher here, so that both weights can be seen.
 *
 *   draw_vertices(&o);      26_path_tracer_vertices.svg
 *   path_seen p = vertices_of(&t, eye, s);       any path, hit by hit
 *   vertices_path(&g, view, eye, &p)             drawn in its room, vertices_room
 *
 * path_step walks. Before each step the random numbers are copied, and path.h's own calls repeat
 * the light sample that the step is about to draw.
 */
#ifndef PATH_VERTICES_FIGURE_H
#define PATH_VERTICES_FIGURE_H

#include "../../../common/lab/figure.h"
#include "showcase.h"

enum { vertices_most = 256 };
typedef struct {
    vec3 p, lamp, beta, gain;
    real weight;               /* w_L */
    bool drawn, blocked;       /* a point of the lamp; is it in shadow? */
    bool glass, mirror, dice;  /* what the step from here has met, or thrown */
} vertex_seen;
typedef struct { vertex_seen v[vertices_most]; int n; path_walk end; } path_seen;

/* ---------------------------------------------------------------------------------------------- */

cold_inline void vertices_light(const path_tracer *t, const path_walk *w, const lit_hit *x,
                                path_random next, vertex_seen *v)
{
    lit_draw l;
    shading_frame f = shading_frame_of(x->s.ns);
    if (x->m->inside.ior > 0 || brdf_is_black(x->f) || brdf_is_delta(x->f)) return;
    if (!lit_lights_sample(&t->light, POINTS_CHEAP, x->s.p, path_pair(&next), &l)) return;
    vec3 wi = to_local(f, l.wi);
    v->lamp = l.s.p, v->drawn = vdot(x->s.n, l.wi) > 0;
    v->blocked = lit_occluded_from(t->scene, lit_draw_ray(&x->s, &l), x->s.shape, l.emitter);
    v->weight = mis_power(l.pdf, brdf_pdf_local(x->f, wi, to_local(f, vneg(vunit(w->r.d)))));
}

/* The path of an eye's ray, by the numbers s. */
cold_inline path_seen vertices_of(const path_tracer *t, ray eye, path_random s)
{
    path_seen p = {.n = 0};
    path_walk *w = &p.end;
    path_begin(w, eye);
    for (bool on = true; on && p.n < vertices_most;) {
        lit_hit x = {.m = NULL};
        path_counts c = {0};
        vec3 before = w->L;
        if (!lit_trace_from(t->scene, w->r, w->left, &x)) break;
        vertex_seen *v = &p.v[p.n++];
        *v = (vertex_seen){.p = x.s.p, .beta = w->beta};
        vertices_light(t, w, &x, s, v);
        on = path_step(t, w, &s, &c);
        v->gain = vsub(w->L, before), v->glass = c.refractions > 0, v->dice = c.dice > 0;
        v->mirror = brdf_is_delta(x.f);
    }
    return p;
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
    enum { red = 7 };
    static const char *const colour[2] = {"#d8d2c4", "#c8c8c8"};
    for (size_t k = 0; 2 * k < s->m.triangles; k++)
        if (k != red) vertices_wall(g, c, &s->m, k);
    for (size_t k = s->shapes; k-- > 0;) {
        sphere ball = s->shape[k].sphere;
        figure_point p = vertices_place(c, ball.c);
        figure_point q = vertices_place(c, vmadd(ball.c, c.u, ball.r));
        figure_dot(g, p.x, p.y, g->unit * hypot(q.x - p.x, q.y - p.y), colour[k % 2]);
    }
    vertices_wall(g, c, &s->m, red);
}

/* The hits, with their light samples. */
static inline void vertices_path(figure *g, camera c, vec3 eye, const path_seen *seen)
{
    figure_point from = vertices_place(c, vertices_from(eye, seen->v));
    for (int k = 0; k < seen->n; k++) {
        const vertex_seen *v = &seen->v[k];
        figure_point p = vertices_place(c, v->p), y = vertices_place(c, v->lamp);
        if (v->drawn) figure_line(g, p.x, p.y, y.x, y.y, v->blocked ? FIGURE_GREY : FIGURE_ORANGE,
                                  2, FIGURE_DASHED);
    }
    for (int k = 0; k < seen->n; k++) {
        figure_point p = vertices_place(c, seen->v[k].p);
        figure_arrow(g, from.x, from.y, p.x, p.y, FIGURE_BLUE, 2);
        from = p;
    }
    for (int k = 0; k < seen->n; k++) {
        const vertex_seen *v = &seen->v[k];
        figure_point p = vertices_place(c, v->p), y = vertices_place(c, v->lamp);
        if (v->drawn) figure_dot(g, y.x, y.y, 3.5, v->blocked ? FIGURE_GREY : FIGURE_RED);
        figure_dot(g, p.x, p.y, 5, FIGURE_BLUE);
        figure_print(g, p.x, p.y, 9, 16, FIGURE_LEFT, FIGURE_BLACK, "*x*~%d~", k);
    }
}

/* Of three channels the green one: what each vertex adds to the pixel. */
static inline void vertices_rows(figure *g, const path_seen *seen)
{
    const double column[5] = {0, 50, 130, 210, 300}, row = 34, below = -row * seen->n;
    static const char *const title[5] = {"hit", "_β_~k~", "_w_~L~", "_w_~B~", "adds to _L_"};
    for (int k = 0; k < 5; k++)
        figure_text(g, column[k], 0, 0, 0, FIGURE_LEFT, FIGURE_BLACK, title[k]);
    figure_line(g, 0, -12, 420, -12, FIGURE_GREY, 1, FIGURE_WHOLE);
    for (int k = 0; k < seen->n; k++) {
        const vertex_seen *v = &seen->v[k];
        const double y = -row * (k + 1), gain = (double)v->gain.y, w = (double)v->weight;
        const double number[4] = {0, (double)v->beta.y, w, 1 - w};
        figure_print(g, column[0], y, 0, 0, FIGURE_LEFT, FIGURE_BLUE, "*x*~%d~", k);
        for (int i = 1; i < 4; i++)
            figure_print(g, column[i], y, 0, 0, FIGURE_LEFT, FIGURE_BLACK, "%.*f", i > 1 ? 4 : 3,
                         number[i]);
        figure_print(g, column[4], y, 0, 0, FIGURE_LEFT, gain > 0 ? FIGURE_RED : FIGURE_GREY,
                     v->blocked ? "0: shadow" : v->drawn ? "%.4f" : "0: behind", gain);
    }
    figure_line(g, 0, below - 12, 420, below - 12, FIGURE_GREY, 1, FIGURE_WHOLE);
    figure_print(g, 0, below - row, 0, 0, FIGURE_LEFT, FIGURE_BLACK,
                 "the dice end it at *x*~%d~; this path brings", seen->n - 1);
    figure_print(g, column[4], below - row, 0, 0, FIGURE_LEFT, FIGURE_RED, "%.4f",
                 (double)seen->end.L.y);
}

/* Of the pixels that the metal shows the lamp in, one whose path has four hits that are far enough
 * apart, and on the metal two weights that count: found by trying. */
cold_inline void draw_vertices(const options *o)
{
    enum { side = 100, x = 39, y = 62, tried = 114 };
    shot s;
    shot_of(&s, o, "metal", path_defaults, side, side);
    s.c.s.f[cornell_parts] = brdf_ggx(vec(0.95, 0.93, 0.88), (real)0.3);
    path_random r = path_start(&s.t.how, 1, tried, 0, 1);
    point2 u = path_pair(&r);
    path_seen p = vertices_of(&s.t, camera_ray(s.c.eye, x + u.u, y + u.v, side, side), r);
    camera c = vertices_view();
    figure_point e = vertices_place(c, vertices_from(s.c.eye.e, p.v));
    figure_point lamp = vertices_place(c, p.v[0].lamp);
    figure_point metal = vertices_place(c, (vec3){390, 30, 350});
    figure g = figure_begin(o, "26_path_tracer_vertices.svg", 940, 480);
    figure_origin(&g, 0, 480, 480);
    vertices_room(&g, c, &s.c.s);
    vertices_path(&g, c, s.c.eye.e, &p);
    figure_text(&g, lamp.x, lamp.y, 0, -14, FIGURE_MIDDLE, FIGURE_BLACK, "lamp");
    figure_text(&g, metal.x, metal.y, 0, 0, FIGURE_MIDDLE, FIGURE_BLACK, "metal");
    figure_text(&g, e.x, e.y, -4, 18, FIGURE_MIDDLE, FIGURE_BLACK, "from the eye");
    figure_origin(&g, 500, 130, 1);
    vertices_rows(&g, &p);
    figure_end(&g);
    shot_free(&s);
}

#endif
