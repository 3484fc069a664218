/* pixel.h: the first path of one pixel, hit by hit: its light samples and their weights, where the
 * BRDF sends it, the dice, and what all of it brings. In words, lines with the number of their
 * equation, and as a drawing.
 *
 *   path_explain(&o, "cornell", "160,200")      the scene (cornell, spheres, metal), the pixel;
 *                                               the drawing goes to build/26_path_tracer_pixel.svg
 *
 * Each hit is asked twice: first path.h's own functions work on copies of the walk and of its
 * random numbers, so that what they do can be told; then path_step goes on. That what was told is
 * the light that it brings, and all of it the very L of path_radiance, is tested each time.
 */
#ifndef PATH_PIXEL_H
#define PATH_PIXEL_H

#include "../../../common/lab/explain.h"
#include "vertices_figure.h"

typedef struct { vertex_seen v[vertices_most]; int n; } pixel_path;

/* ---------------------------------------------------------------------------------------------- */

/* The light sample that the step is about to draw; `gain`: what it added. */
static inline void pixel_light(const vertex_seen *v, vec3 gain)
{
    if (!v->drawn) {
        explain_line(2, "(24.4)", "the lamp shows its back, or lies behind: no shadow ray");
        return;
    }
    explain_vector(2, "(24.4)", "a point of the lamp:", v->lamp);
    if (v->blocked) explain_line(2, "(1.5)", "in shadow: 0");
    else {
        explain_line(2, "(24.9)", "in sight; its weight w_L = %.6f, that of the BRDF's way %.6f",
                     (double)v->weight, 1 - (double)v->weight);
        explain_vector(2, "(26.5)", "it adds", gain);
    }
}

static inline void pixel_dice(const path_tracer *t, const path_walk *before, bool on)
{
    real q = roulette_survival(vscale(before->beta, 1 / before->squeezed));
    explain_vector(2, t->glass ? "(26.2), (26.10)" : "(26.2)", "on, with beta =", before->beta);
    if (q >= 1) explain_line(2, "(26.4)", "it carries half of the light or more: no dice");
    else if (on) explain_line(2, "(26.3)", "dice: goes on with q = %.4f, beta / q", (double)q);
    else explain_line(2, "(26.3)", "dice: ends here, q = %.4f", (double)q);
}

/* One hit in words: of the walk w, a copy, and a copy s of its random numbers; w->L is then what
 * was told of light. False: there is no hit. */
cold_inline bool pixel_vertex(const path_tracer *t, path_walk *w, path_random s, int k,
                              vertex_seen *v)
{
    lit_hit x = {.m = NULL};
    path_counts c = {0};
    char name[16];
    snprintf(name, sizeof name, "x%d =", k);
    if (!lit_trace_from(t->scene, w->r, w->left, &x)) {
        vec3 sky = vmul(w->beta, path_escaped(t, w));
        w->L = vadd(w->L, sky);
        explain_vector(0, "(26.5)", "out of the scene, where beta L is", sky);
        return false;
    }
    *v = (vertex_seen){.p = x.s.p, .beta = w->beta};
    explain_vector(0, "(1.2)", name, x.s.p);
    explain_vector(2, "(26.2)", "beta =", w->beta);
    if (t->glass && w->medium)
        w->beta = vmul(w->beta, absorbed(w->medium->sigma, x.t * vlength(w->r.d)));
    if (x.front && x.emitter != lit_dark) {
        vec3 found = vmul(w->beta, path_found(t, w, &x));
        w->L = vadd(w->L, found);
        explain_vector(2, "(26.5)", "it is a lamp; its light adds", found);
    }
    if (t->glass && x.m->ior > 0) {
        const lit_material *before = w->medium;
        path_through_glass(t, w, &x, &s, &c);
        explain_line(2, "(26.9)", w->medium == before ? "glass: reflected" : w->medium
                     ? "glass: the path goes in" : "glass: the path goes out");
    } else {
        if (brdf_is_black(&x.m->f)) return true;
        vec3 L = w->L;
        bool ask = t->how.light_sampling && !brdf_is_delta(&x.m->f);
        if (ask) vertices_light(t, w, &x, s, v);
        bool on = path_reflect(t, w, &x, &s, &c);
        v->gain = vsub(w->L, L);
        if (ask) pixel_light(v, v->gain);
        if (!on) explain_line(2, "", "the BRDF reflects nothing: the path ends");
        else if (!(w->pdf < real_infinity)) explain_line(2, "(19.1)", "a mirror: one direction");
        else explain_line(2, "(26.1)", "the BRDF draws the next direction, p = %.4g",
                          (double)w->pdf);
        if (!on) return true;
    }
    if (vzero(w->beta)) return true;
    path_random die = s;
    path_walk after = *w;
    pixel_dice(t, w, path_dice(t, &after, &die, &c));
    return true;
}

static inline vec3 pixel_trace(const path_tracer *t, ray eye, path_random s, pixel_path *path)
{
    path_walk w = path_begin(eye);
    path_counts c = {0};
    bool on = true;
    for (int k = 0; on; k++) {
        vertex_seen v;
        path_walk told = w;
        if (pixel_vertex(t, &told, s, k, &v) && path->n < vertices_most) path->v[path->n++] = v;
        on = path_step(t, &w, &s, &c);
        if (!vzero(vsub(told.L, w.L)))
            die(1, "--pixel: what was told of x%d is not what path.h did", k);
    }
    return w.L;
}

static inline void path_draw(const options *o, const showcase *c, bool blocks,
                             const pixel_path *path)
{
    char room[512];
    camera view = vertices_view();
    figure g = figure_at(output_path(o, "26_path_tracer_pixel.svg", true, room), 480, 480);
    figure_origin(&g, 0, 480, 480);
    vertices_room(&g, view, &c->s);
    mesh m = cornell_mesh();
    for (size_t k = cornell_room / 2; blocks && 2 * k < m.triangles; k++)
        vertices_wall(&g, view, &m, k);
    mesh_free(&m);
    vertices_path(&g, view, c->eye.e, path->v, path->n);
    figure_end(&g);
}

cold_inline void path_explain(const options *o, const char *name, const char *text)
{
    int xy[2], w = o->width, h = o->height;
    shot x;
    path_counts counts = {0};
    pixel_path path = {.n = 0};
    if (strcmp(name, "cornell") != 0 && strcmp(name, "spheres") != 0 && strcmp(name, "metal") != 0)
        die(2, "--pixel: allowed with --scene are cornell, spheres, metal");
    explain_pixel(text, w, h, xy);
    shot_of(&x, o, name, path_defaults, w, h);
    size_t i = (size_t)xy[1] * (size_t)w + (size_t)xy[0];
    path_random s = path_start(&x.t.how, o->seed, 2 * i, 0, 1u << 31), again;
    point2 u = path_pair(&s);
    ray eye = camera_ray(x.c.eye, (real)xy[0] + u.u, (real)xy[1] + u.v, w, h);
    again = s;

    printf("# The first path of pixel %d, %d of %d x %d, %s\n", xy[0], xy[1], w, h, name);
    explain_vector(0, "(2.5)", "o =", eye.o);
    explain_vector(0, "(2.5)", "d =", eye.d);
    vec3 L = pixel_trace(&x.t, eye, s, &path), due = path_radiance(&x.t, eye, &again, &counts);
    if (!vzero(vsub(L, due))) die(1, "--pixel: this walk is not that of path.h");
    explain_vector(0, "(26.5)", "this path brings L =", L);
    printf("%zu rays; the pixel is the mean of many such paths\n", path_rays(&counts));
    path_draw(o, &x.c, strcmp(name, "cornell") == 0, &path);
    shot_free(&x);
}

#endif
