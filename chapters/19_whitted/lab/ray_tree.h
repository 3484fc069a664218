/* ray_tree.h: the tree of rays (光线树) of one eye ray: noted while it is traced, and drawn.
 *
 *   ray_tree *x = allocate(1, sizeof *x);
 *   w.log = ray_tree_begin(x)               from now on w's rays are noted; x->full: more than 4096
 *   whitted_ray(&tracer, r, in)
 *   ray_tree_draw(x, path)                  an SVG, NULL: none; depth downwards; width and number
 *                                           of a line: the largest component of its weight
 *
 *   camera 1 ---.                           from  number of the ray before it, -1: the eye
 *     reflection 2                          t     where it ended; infinity: in the sky
 *     refraction 2                          lit   of a shadow ray: part of the light that arrives
 */
#ifndef WHITTED_LAB_RAY_TREE_H
#define WHITTED_LAB_RAY_TREE_H

#include "../../../common/lab/figure.h"
#include "../whitted.h"

enum { ray_tree_most = 4096 };

typedef struct {
    ray_kind kind;
    int from, depth;       /* number of the ray before it, -1: the eye */
    ray r;
    real t, lit;           /* infinity: in the sky; of a shadow ray: arrives */
    vec3 weight;
} ray_tree_node;

typedef struct {
    whitted_log log;       /* first: what is told of each ray */
    ray_tree_node node[ray_tree_most];
    int n;
    bool full;
} ray_tree;

/* ---------------------------------------------------------------------------------------------- */

static inline int ray_tree_add(whitted_log *log, ray_kind kind, int from, int depth, ray r, real t,
                               vec3 weight, real lit)
{
    ray_tree *x = (ray_tree *)log;
    if (x->n == ray_tree_most) {
        x->full = true;
        return ray_tree_most - 1;
    }
    x->node[x->n] = (ray_tree_node){kind, from, depth, r, t, lit, weight};
    return x->n++;
}

static inline whitted_log *ray_tree_begin(ray_tree *x)
{
    x->log.add = ray_tree_add, x->n = 0, x->full = false;
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

static inline int ray_tree_level(const ray_tree_node *n)
{
    return n->kind == RAY_SHADOW ? n->depth + 1 : n->depth;
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
    int deep = 0, depth = 0;  /* shadow rays have none: they may lie one lower */
    for (int i = 0; i < x->n; i++) {
        if (ray_tree_level(&x->node[i]) > deep) deep = ray_tree_level(&x->node[i]);
        if (x->node[i].depth > depth) depth = x->node[i].depth;
    }
    figure g = figure_at(path, 960, 70 * deep + 110);
    figure_origin(&g, 0, 0, 1);
    figure_text(&g, 480, -24, 0, 0, FIGURE_MIDDLE, FIGURE_BLACK,
                "Rays for one pixel: the wider a line, the more it is worth there");
    for (int i = x->n; i-- > 0; ) {
        const ray_tree_node *n = &x->node[i];
        double x1 = 70 + step * at[i], x0 = n->from < 0 ? x1 : 70 + step * at[n->from];
        ray_tree_draw_ray(&g, n, x0, x1, -50 - 70 * ray_tree_level(n));
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

#endif
