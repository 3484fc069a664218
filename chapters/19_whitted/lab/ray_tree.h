/* ray_tree.h: the tree of rays (光线树) of one eye ray: noted while it is traced, drawn, and said in
 * a line or two for each ray, with the numbers of their equations.
 *
 *   ray_tree *x = allocate(1, sizeof *x);
 *   w.log = ray_tree_begin(x)               from now on w's rays are noted, up to 4096 of them
 *   whitted_ray(&tracer, r, in)
 *   ray_tree_draw(x, path)                  an SVG, NULL: none; depth downwards; width and number
 *                                           of a line: the largest component of its weight
 *
 *   whitted_explain(&o, "345,140")          of the two spheres: that pixel's middle, columns and
 *                                           rows from 0; drawn to build/19_whitted_pixel.svg
 *   whitted_explain(&o, NULL)               nothing said; this page's drawing, 19_whitted_tree.svg
 */
#ifndef WHITTED_LAB_RAY_TREE_H
#define WHITTED_LAB_RAY_TREE_H

#include "../../../common/lab/explain.h"
#include "../../../common/lab/figure.h"
#include "two_spheres.h"

enum { ray_tree_most = 4096 };

typedef struct {
    ray_kind kind;
    int from, depth;       /* the ray before it, -1: the eye; a shadow ray is one deeper */
    ray r;
    real t, lit;           /* infinity: in the sky; of a shadow ray: share that arrives */
    vec3 weight;
} ray_tree_node;

typedef struct {
    whitted_log log;       /* first: what is told of each ray */
    ray_tree_node node[ray_tree_most];
    int n;
} ray_tree;

/* ---------------------------------------------------------------------------------------------- */

static inline int ray_tree_add(whitted_log *log, ray_kind kind, int from, int depth, ray r, real t,
                               vec3 weight, real lit)
{
    ray_tree *x = (ray_tree *)log;
    if (x->n == ray_tree_most) return ray_tree_most - 1;
    x->node[x->n] = (ray_tree_node){kind, from, depth + (kind == RAY_SHADOW), r, t, lit, weight};
    return x->n++;
}

static inline whitted_log *ray_tree_begin(ray_tree *x)
{
    x->log.add = ray_tree_add, x->n = 0;
    return &x->log;
}

/* Leaves stand side by side, a parent over the middle of its children. Returns the next place. */
static inline double ray_tree_place(const ray_tree *x, int k, double next, double *at)
{
    double first = -1, last = 0;
    for (int i = k + 1; i < x->n; i++) {
        if (x->node[i].from != k) continue;
        next = ray_tree_place(x, i, next, at);
        first = first < 0 ? at[i] : first, last = at[i];
    }
    if (first >= 0) at[k] = (first + last) / 2;
    else at[k] = next, next += 1;
    return next;
}

static const char *const ray_tree_colour[ray_kinds] = {
    FIGURE_BLACK, FIGURE_ORANGE, FIGURE_BLUE, FIGURE_GREEN, FIGURE_BLACK};

/* Ray k, from (x0, y - 70) to its end at (x1, y). */
static inline void ray_tree_draw_ray(figure *g, const ray_tree_node *n, double x0, double x1,
                                     double y)
{
    bool shadow = n->kind == RAY_SHADOW;
    double weight = (double)vlargest(n->weight);
    figure_line(g, x0, y + 70, x1, y, ray_tree_colour[n->kind],
                shadow ? 1 : 1 + 9 * sqrt(weight),
                shadow ? FIGURE_DASHED : FIGURE_WHOLE);
    figure_dot(g, x1, y, 6.5, FIGURE_BLACK);
    figure_dot(g, x1, y, 5.5, shadow ? n->lit > 0 ? "#ffe27a" : "#444444"
                              : n->t < real_infinity ? "#ffffff" : "#9ad0ff");
    if (shadow || n->from < 0) return;
    figure_print(g, x1, y, x1 < x0 ? -8 : 8, -2, x1 < x0 ? FIGURE_RIGHT : FIGURE_LEFT,
                 ray_tree_colour[n->kind], weight < 0.1 ? "%.1g" : "%.2g", weight);
}

static inline void ray_tree_draw(const ray_tree *x, const char *path)
{
    static const struct { const char *what, *colour; } key[] = {
        {"eye ray", FIGURE_BLACK}, {"reflection", FIGURE_BLUE}, {"refraction", FIGURE_GREEN},
        {"shadow ray (yellow: lit)", FIGURE_ORANGE}, {"blue end: sky", "#3a86c8"}};
    double *at = allocate((size_t)x->n, sizeof *at), width = ray_tree_place(x, 0, 0, at);
    double step = width < 2 ? 300 : 860 / width;
    int deep = 0, depth = 0;  /* with shadow rays, and without */
    for (int i = 0; i < x->n; i++) {
        int d = x->node[i].depth;
        if (d > deep) deep = d;
        if (d > depth && x->node[i].kind != RAY_SHADOW) depth = d;
    }
    figure g = figure_at(path, 960, 70 * deep + 110);
    figure_origin(&g, 0, 0, 1);
    figure_text(&g, 480, -24, 0, 0, FIGURE_MIDDLE, FIGURE_BLACK,
                "Rays for one pixel: the wider a line, the more it is worth there");
    for (int i = x->n; i-- > 0; ) {
        const ray_tree_node *n = &x->node[i];
        double x1 = 70 + step * at[i], x0 = n->from < 0 ? x1 : 70 + step * at[n->from];
        ray_tree_draw_ray(&g, n, x0, x1, -50 - 70 * n->depth);
    }
    figure_text(&g, 8, -85, 0, 0, FIGURE_LEFT, FIGURE_GREY, "depth");
    for (int d = 1; d <= depth; d++)
        figure_print(&g, 8, -55 - 70 * d, 0, 0, FIGURE_LEFT, FIGURE_GREY, "%d", d);
    for (int k = 0; k < 5; k++)
        figure_text(&g, 60 + 170 * k + 30 * (k == 4), -70 * deep - 96, 0, 0, FIGURE_LEFT,
                    key[k].colour, key[k].what);
    figure_end(&g);
    free(at);
}

/* What comes of a ray stands below it, further to the right. */
static inline void pixel_say(const ray_tree *x)
{
    static const char *const law[ray_kinds] = {
        [RAY_CAMERA] = "(2.5)", [RAY_REFLECTION] = "(19.1)", [RAY_REFRACTION] = "(19.4)"};
    for (const ray_tree_node *n = x->node; n < x->node + x->n; n++) {
        int deep = 2 * (n->depth - 1);
        if (n->kind == RAY_SHADOW) {
            explain_line(deep, "(1.5)", "shadow ray: %.4g of the light arrives", (double)n->lit);
            continue;
        }
        explain_line(deep, law[n->kind], "%s ray, depth %d, along (%.6g, %.6g, %.6g)",
                     ray_kind_names[n->kind], n->depth, (double)n->r.d.x, (double)n->r.d.y,
                     (double)n->r.d.z);
        explain_line(deep + 2, "(19.10)", "in the pixel it weighs %.6g", 
                     (double)vlargest(n->weight));
        if (n->t < real_infinity)
            explain_vector(deep + 2, "(1.2)", "it hits at p =", ray_at(n->r, n->t));
        else explain_line(deep + 2, "", "it ends in the sky");
    }
}

cold_inline void whitted_explain(const options *o, const char *text)
{
    int xy[2] = {345, 140}, w = text ? o->width : 640, h = text ? o->height : 480;
    char room[512];
    if (text) explain_pixel(text, w, h, xy);
    whitted_stage *s = two_spheres_new();
    ray_tree *x = allocate(1, sizeof *x);
    tracer t = stage_tracer(s);
    ray r = camera_ray(two_spheres_camera((real)w / (real)h), (real)xy[0] + (real)0.5,
                       (real)xy[1] + (real)0.5, w, h);
    s->w.log = ray_tree_begin(x);
    vec3 L = whitted_ray(&t, r, (media_set){0});
    if (text) {
        printf("# The rays of pixel %d, %d of %d x %d: two spheres\n", xy[0], xy[1], w, h);
        explain_vector(0, "(2.5)", "o =", r.o);
        pixel_say(x);
        explain_vector(0, "(19.10)", "together they bring L =", L);
        printf("%d rays; --samples 1 draws that, or 4 where it is more\n", x->n);
    }
    ray_tree_draw(x, text ? output_path(o, "19_whitted_pixel.svg", true, room)
                          : output_path(o, "19_whitted_tree.svg", false, room));
    free(x), stage_end(s), free(s);
}

#endif
