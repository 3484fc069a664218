/* pixel.h: the first path of one pixel, hit by hit: its light samples and their weights, where it
 * goes, the dice, and what all of it brings. In words, lines with the number of their equation, and
 * as a drawing.
 *
 *   path_explain(&o, "cornell", "160,200")      the scene (cornell, spheres, metal), the pixel;
 *                                               the drawing goes to build/26_path_tracer_pixel.svg
 */
#ifndef PATH_PIXEL_H
#define PATH_PIXEL_H

#include "../../../common/lab/explain.h"
#include "vertices_figure.h"

/* ---------------------------------------------------------------------------------------------- */

/* Hit k in words; on: the path goes on from there, with beta. */
static inline void pixel_vertex(int k, const vertex_seen *v, bool on, vec3 beta)
{
    char name[16];
    snprintf(name, sizeof name, "x%d =", k);
    explain_vector(0, "(1.2)", name, v->p);
    explain_vector(2, "(26.2)", "beta =", v->beta);
    if (v->drawn) {
        explain_vector(2, "(24.4)", "a point of the lamp:", v->lamp);
        explain_line(2, "(24.9)", v->blocked ? "in shadow: 0" : "in sight; its weight w_L = %.6f, "
                     "that of the BRDF's way %.6f", (double)v->weight, 1 - (double)v->weight);
    }
    if (!vzero(v->gain)) explain_vector(2, "(26.5)", "light that is found here adds", v->gain);
    if (v->glass) explain_line(2, "(26.9)", "glass: reflected, or into it, or out of it");
    else if (v->mirror) explain_line(2, "(19.1)", "a mirror: one direction");
    if (on) explain_vector(2, "(26.1)", "on in one direction, with beta =", beta);
    if (v->dice) explain_line(2, "(26.3)", on ? "by dice: divided by q" : "dice: ends here");
}

cold_inline void path_explain(const options *o, const char *name, const char *text)
{
    int xy[2], w = o->width, h = o->height;
    char room[512];
    shot x;
    if (strcmp(name, "cornell") != 0 && strcmp(name, "spheres") != 0 && strcmp(name, "metal") != 0)
        die(2, "--pixel: allowed with --scene are cornell, spheres, metal");
    explain_pixel(text, w, h, xy);
    shot_of(&x, o, name, path_defaults, w, h);
    size_t i = (size_t)xy[1] * (size_t)w + (size_t)xy[0];
    path_random s = path_start(&x.t.how, o->seed, 2 * i, 0, 1u << 31);
    point2 u = path_pair(&s);
    ray eye = camera_ray(x.c.eye, (real)xy[0] + u.u, (real)xy[1] + u.v, w, h);
    path_seen p = vertices_of(&x.t, eye, s);

    printf("# The first path of pixel %d, %d of %d x %d, %s\n", xy[0], xy[1], w, h, name);
    explain_vector(0, "(2.5)", "o =", eye.o);
    explain_vector(0, "(2.5)", "d =", eye.d);
    for (int k = 0; k < p.n; k++)
        pixel_vertex(k, &p.v[k], k < p.end.bounces, k + 1 < p.n ? p.v[k + 1].beta : p.end.beta);
    if (p.n == p.end.bounces) explain_line(0, "", "out of the scene, where it is dark");
    explain_vector(0, "(26.5)", "this path brings L =", p.end.L);
    printf("the pixel is the mean of many such paths\n");
    figure g = figure_at(output_path(o, "26_path_tracer_pixel.svg", true, room), 480, 480);
    figure_origin(&g, 0, 480, 480);
    vertices_room(&g, vertices_view(), &x.c.s);
    vertices_path(&g, vertices_view(), x.c.eye.e, &p);
    figure_end(&g);
    shot_free(&x);
}

#endif
