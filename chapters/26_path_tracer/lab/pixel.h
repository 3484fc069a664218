/* pixel.h: the first path of one pixel, hit by hit: its light samples and their weights, where the
 * BRDF sends it, the dice, and what all of it brings. In words, lines with the number of their
 * equation, and as a drawing.
 *
 *   path_explain(&o, "cornell", "160,200")      the scene (cornell, spheres, metal), the pixel;
 *                                               the drawing goes to build/26_path_tracer_pixel.svg
 *
 * Each step calls path.h's own functions as path_step does, and tells what they do. That the light
 * which this brings is the very L of path_radiance is tested each time.
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

/* False: the path ends here. */
static inline bool pixel_dice(const path_tracer *t, path_walk *w, path_random *s, path_counts *c)
{
    real q = roulette_survival(vscale(w->beta, 1 / w->squeezed));
    explain_vector(2, t->glass ? "(26.2), (26.10)" : "(26.2)", "on, with beta =", w->beta);
    bool on = path_dice(t, w, s, c);
    if (q >= 1) explain_line(2, "(26.4)", "it carries half of the light or more: no dice");
    else if (on) explain_line(2, "(26.3)", "dice: goes on with q = %.4f, beta / q", (double)q);
    else explain_line(2, "(26.3)", "dice: ends here, q = %.4f", (double)q);
    return on;
}

/* On from the hit x, by its BRDF; false: the path ends there. */
static inline bool pixel_reflect(const path_tracer *t, path_walk *w, const lit_hit *x,
                                 path_random *s, path_counts *c, vertex_seen *v)
{
    vec3 L = w->L;
    if (brdf_is_black(&x->m->f)) return false;
    bool ask = t->how.light_sampling && !brdf_is_delta(&x->m->f);
    if (ask) vertices_light(t, w, x, *s, v);
    bool on = path_reflect(t, w, x, s, c);
    v->gain = vsub(w->L, L);
    if (ask) pixel_light(v, v->gain);
    if (!on) explain_line(2, "", "the BRDF reflects nothing: the path ends");
    else if (!(w->pdf < real_infinity)) explain_line(2, "(19.1)", "a mirror: one direction");
    else explain_line(2, "(26.1)", "the BRDF draws the next direction, p = %.4g", (double)w->pdf);
    return on;
}

/* One hit in words, and on from there; false: the path ends. */
cold_inline bool pixel_vertex(const path_tracer *t, path_walk *w, path_random *s, path_counts *c,
                              pixel_path *path)
{
    lit_hit x = {.m = NULL};
    char name[16];
    if (!lit_trace_from(t->scene, w->r, w->left, &x)) {
        vec3 sky = vmul(w->beta, path_escaped(t, w));
        w->L = vadd(w->L, sky);
        explain_vector(0, "(26.5)", "out of the scene, where beta L is", sky);
        return false;
    }
    vertex_seen none, *v = path->n < vertices_most ? &path->v[path->n++] : &none;
    *v = (vertex_seen){.p = x.s.p, .beta = w->beta};
    snprintf(name, sizeof name, "x%d =", w->bounces);
    explain_vector(0, "(1.2)", name, x.s.p);
    explain_vector(2, "(26.2)", "beta =", w->beta);
    if (t->glass && w->medium)
        w->beta = vmul(w->beta, absorbed(w->medium->sigma, x.t * vlength(w->r.d)));
    if (x.shines) {
        vec3 found = vmul(w->beta, path_found(t, w, &x));
        w->L = vadd(w->L, found);
        explain_vector(2, "(26.5)", "it is a lamp; its light adds", found);
    }
    if (t->glass && x.m->ior > 0) {
        const lit_material *before = w->medium;
        if (!path_through_glass(t, w, &x, s, c)) return false;
        explain_line(2, "(26.9)", w->medium == before ? "glass: reflected" : w->medium
                     ? "glass: the path goes in" : "glass: the path goes out");
    } else if (!pixel_reflect(t, w, &x, s, c, v)) return false;
    if (vzero(w->beta) || !pixel_dice(t, w, s, c)) return false;
    w->bounces++;
    return true;
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
    path_walk walk = path_begin(eye);
    path_counts told = {0};
    while (pixel_vertex(&x.t, &walk, &s, &told, &path)) {}
    vec3 L = walk.L, due = path_radiance(&x.t, eye, &again, &counts);
    if (!vzero(vsub(L, due))) die(1, "--pixel: this walk is not that of path.h");
    explain_vector(0, "(26.5)", "this path brings L =", L);
    printf("%zu rays; the pixel is the mean of many such paths\n", path_rays(&counts));
    path_draw(o, &x.c, strcmp(name, "cornell") == 0, &path);
    shot_free(&x);
}

#endif
