/* painting.h: three triangles, each over the next, painted over each other (画家算法).
 *
 *   draw_cyclic(o)     images/13_bsp_painter.svg: sorted by distance; in the order of the tree
 *
 * An SVG is itself a painter: what stands later in the file covers what stands before. Numbers say
 * which was drawn first.
 */
#ifndef BSP_PAINTING_H
#define BSP_PAINTING_H

#include "../../../common/lab/figure.h"
#include "../../02_camera/camera.h"
#include "naive.h"
#include "puzzles.h"

enum { painting_most = 16, painting_corners = 8 };

/* ---------------------------------------------------------------------------------------------- */

typedef struct { uint32_t n; double at[painting_corners][2]; } painting_piece;

static inline bool painting_covers(const painting_piece *p, double x, double y)
{
    bool left = false, right = false;
    for (uint32_t i = 0; i < p->n; i++) {
        const double *a = p->at[i], *b = p->at[(i + 1) % p->n];
        double e = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
        left |= e > 0, right |= e < 0;
    }
    return !(left && right);
}

/* The number of piece k of n: between its middle and a corner, where no later piece covers it. */
static inline void painting_number(figure *g, const painting_piece *p, size_t n, size_t k)
{
    const painting_piece *q = &p[k];
    double mx = 0, my = 0;
    for (uint32_t i = 0; i < q->n; i++) mx += q->at[i][0] / q->n, my += q->at[i][1] / q->n;
    for (uint32_t i = 0; i < 3 * q->n; i++) {
        const double *corner = q->at[i % q->n], part = 0.6 * (i / q->n) / 2;
        double x = mx + part * (corner[0] - mx), y = my + part * (corner[1] - my);
        bool hidden = false;
        for (size_t j = k + 1; j < n; j++) hidden |= painting_covers(&p[j], x, y);
        if (hidden) continue;
        figure_dot(g, x, y, 10, "#ffffff");
        figure_print(g, x, y, 0, 5, FIGURE_MIDDLE, FIGURE_BLACK, "*%zu*", k + 1);
        return;
    }
}

/* The pieces in this order; all of them lie before the eye. */
static inline void painting_draw(figure *g, const painter *p, const uint32_t *order, size_t n,
                                 camera c)
{
    static const char *const colour[3] = {FIGURE_RED, FIGURE_SKY, FIGURE_ORANGE};
    painting_piece piece[painting_most];
    if (n > painting_most) n = painting_most;
    for (size_t k = 0; k < n; k++) {
        const fragment *q = &p->piece[order[k]];
        piece[k].n = q->corners < painting_corners ? q->corners : painting_corners;
        for (uint32_t i = 0; i < piece[k].n; i++) {
            real x = 0, y = 0;
            vec3 at = vmadd(p->w.middle, p->w.corner[q->corner + i], p->w.scale);
            camera_project(c, at, 400, 400, &x, &y);
            piece[k].at[i][0] = (double)x, piece[k].at[i][1] = (double)-y;
        }
        figure_polygon(g, (int)piece[k].n, piece[k].at[0], colour[q->item % 3], 1, FIGURE_BLACK);
    }
    for (size_t k = 0; k < n; k++) painting_number(g, piece, n, k);
}

cold_inline void draw_cyclic(const options *o)
{
    static const char *const title[2] = {"sorted by distance: wrong", "in the order of the tree"};
    figure g = figure_begin(o, "13_bsp_painter.svg", 840, 350);
    mesh m = cyclic_mesh();
    failure f;
    painter cut, uncut;
    vec3 eye = {0.7, -1.3, 3};
    camera c = camera_at(eye, (vec3){0, 0, 0}, (vec3){0, 1, 0}, 52, 1);
    painter_uncut(&m, &uncut);
    if (!painter_build(&m, painter_defaults, &cut, &f)) fail(f);
    for (int k = 0; k < 2; k++) {
        const painter *p = k ? &cut : &uncut;
        uint32_t *order = allocate(p->pieces, sizeof *order);
        size_t n = k ? painter_order(p, eye, order) : painter_order_naive(p, eye, order);
        figure_origin(&g, 10 + 410 * k, 0, 1);
        painting_draw(&g, p, order, n, c);
        figure_text(&g, 200, 0, 0, 30, FIGURE_MIDDLE, FIGURE_BLACK, title[k]);
        free(order);
    }
    figure_end(&g);
    painter_free(&cut), painter_free(&uncut);
    mesh_free(&m);
}

#endif
