/* ray_tree.h: the tree of rays (光线树) of one eye ray: noted, printed, drawn.
 *
 *   ray_tree t;
 *   ray_tree_trace(&t, &w, &tracer, r, in)  follows r; false if there were more than 4096 rays;
 *                                           w is the tracer's
 *   ray_tree_print(&t, stdout)              one line a ray, indented by depth
 *   ray_tree_svg(&t, file)                  depth downwards; width of a line: weight
 *
 *   camera 1 ---.                           from  number of the ray before it, -1: the eye
 *     reflection 2                          t     where it ended; infinity: in the sky
 *     refraction 2                          lit   of a shadow ray: part of the light that arrives
 */
#ifndef WHITTED_LAB_RAY_TREE_H
#define WHITTED_LAB_RAY_TREE_H

#include "../whitted.h"

enum { ray_tree_most = 4096 };

typedef struct {
    ray_kind kind;
    int from, depth;
    real t, weight, lit;   /* weight: largest component */
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
    (void)r;
    if (x->n == ray_tree_most) {
        x->full = true;
        return ray_tree_most - 1;
    }
    real most = real_max(real_max(weight.x, weight.y), weight.z);
    x->node[x->n] = (ray_tree_node){kind, from, depth, t, most, lit};
    return x->n++;
}

static inline bool ray_tree_trace(ray_tree *x, whitted *w, tracer *t, ray r, media_set in)
{
    x->log.add = ray_tree_add, x->n = 0, x->full = false;
    w->log = &x->log;
    whitted_ray(t, r, in);
    w->log = NULL;
    return !x->full;
}

/* What comes of ray k; the branches in the order in which they were traced. */
static inline void ray_tree_print_below(const ray_tree *x, int k, FILE *f)
{
    const ray_tree_node *n = &x->node[k];
    int lights = 0, lit = 0;
    for (int i = k + 1; i < x->n; i++)
        if (x->node[i].from == k && x->node[i].kind == RAY_SHADOW)
            lights++, lit += x->node[i].lit > 0;
    fprintf(f, "%*s%d %s: weight %.3g, ", 2 * n->depth - 2, "", n->depth, ray_kind_names[n->kind],
            (double)n->weight);
    if (n->t < real_infinity) fprintf(f, "%.3g far", (double)n->t);
    else fprintf(f, "sky");
    if (lights) fprintf(f, "; %d shadow ray%s, %d lit", lights, lights > 1 ? "s" : "", lit);
    fprintf(f, "\n");
    for (int i = k + 1; i < x->n; i++)
        if (x->node[i].from == k && x->node[i].kind != RAY_SHADOW) ray_tree_print_below(x, i, f);
}

static inline void ray_tree_print(const ray_tree *x, FILE *f)
{
    if (x->n) ray_tree_print_below(x, 0, f);
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

static inline void ray_tree_svg(const ray_tree *x, FILE *f)
{
    static const char *const colour[ray_kinds] = {"#000000", "#e69f00", "#0072b2", "#009e73",
                                                  "#000000"};
    double *at = allocate((size_t)x->n, sizeof *at), width = ray_tree_place(x, 0, 0, at);
    int deep = 0, depth = 0;  /* shadow rays have none: they may lie one lower */
    for (int i = 0; i < x->n; i++) {
        if (ray_tree_level(&x->node[i]) > deep) deep = ray_tree_level(&x->node[i]);
        if (x->node[i].depth > depth) depth = x->node[i].depth;
    }
    double step = width < 2 ? 300 : 860 / width;
    fprintf(f, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 960 %d\" "
               "font-family=\"sans-serif\" font-size=\"14\">\n"
               "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n"
               "<text x=\"480\" y=\"24\" text-anchor=\"middle\">Rays for one pixel: wider lines "
               "contribute more</text>\n", 70 * deep + 110);
    for (int i = x->n; i-- > 0; ) {
        const ray_tree_node *n = &x->node[i];
        double x1 = 70 + step * at[i], y1 = 50 + 70 * ray_tree_level(n);
        double x0 = n->from < 0 ? x1 : 70 + step * at[n->from];
        bool shadow = n->kind == RAY_SHADOW;
        fprintf(f, "<line x1=\"%.1f\" y1=\"%.0f\" x2=\"%.1f\" y2=\"%.0f\" stroke=\"%s\" "
                   "stroke-width=\"%.2f\"%s/>\n", x0, y1 - 70, x1, y1, colour[n->kind],
                shadow ? 1 : 1 + 9 * sqrt((double)n->weight),
                shadow ? " stroke-dasharray=\"3 3\"" : "");
        const char *fill = shadow ? n->lit > 0 ? "#ffe27a" : "#444444"
                           : n->t < real_infinity ? "#ffffff" : "#9ad0ff";
        fprintf(f, "<circle cx=\"%.1f\" cy=\"%.0f\" r=\"6\" fill=\"%s\" stroke=\"black\"/>\n", x1,
                y1, fill);
    }
    fprintf(f, "<text x=\"8\" y=\"85\" fill=\"#666\">depth</text>\n");
    for (int d = 1; d <= depth; d++)
        fprintf(f, "<text x=\"8\" y=\"%d\" fill=\"#666\">%d</text>\n", 55 + 70 * d, d);
    static const struct { const char *what; int kind; } key[] = {
        {"eye ray", RAY_CAMERA}, {"reflection", RAY_REFLECTION}, {"refraction", RAY_REFRACTION},
        {"shadow ray (yellow: lit)", RAY_SHADOW}, {"blue end: sky", -1}};
    for (int k = 0; k < 5; k++)
        fprintf(f, "<text x=\"%d\" y=\"%d\" fill=\"%s\">%s</text>\n", 60 + 180 * k, 70 * deep + 96,
                key[k].kind < 0 ? "#3a86c8" : colour[key[k].kind], key[k].what);
    fprintf(f, "</svg>\n");
    free(at);
}

#endif
