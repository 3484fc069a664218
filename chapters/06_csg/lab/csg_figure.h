/* csg_figure.h: the explaining drawing: a tree, and beside each of its nodes the spans that one ray
 * has there, by csg_spans.
 *
 *   csg_draw_tree(&o)      the eye is at t = 0, in a hole: spans begin behind it
 */
#ifndef CSG_FIGURE_H
#define CSG_FIGURE_H

#include "../../../common/lab/figure.h"
#include "csg_scenes.h"

/* ---------------------------------------------------------------------------------------------- */

enum { csg_rows = 7, csg_row_height = 52, csg_bars_left = 390 };
static const double csg_reach = 2.1;  /* of the drawing, in t, to either side */

/* Of each step, leaves before what joins them: how many steps its subtree has; its row from the
 * top, its level, and the row of its parent. */
static const struct { uint32_t size; int row, level, parent; } csg_spot[csg_rows] = {
    {1, 2, 2, 1}, {1, 3, 2, 1}, {3, 1, 1, 0}, {1, 5, 2, 4}, {1, 6, 2, 4}, {3, 4, 1, 0},
    {7, 0, 0, 0}};

static inline void csg_figure_bars(figure *g, csg_model m, uint32_t i, ray r)
{
    static const char *const fill[] = {FIGURE_RED, FIGURE_BLUE, FIGURE_GREEN, FIGURE_ORANGE};
    csg c;
    failure f;
    csg_crossing x[64];
    uint32_t size = csg_spot[i].size;
    csg_model part = {m.solid, m.solids, m.step + i + 1 - size, size};
    if (!csg_build(part, (csg_options){0}, &c, &f)) fail(f);
    size_t n = csg_spans(&c, r, x);
    bool leaf = m.step[i].what == CSG_SOLID;
    for (size_t k = 0; k + 1 < n; k += 2) {
        double t0 = fmax((double)x[k].t, -csg_reach), t1 = fmin((double)x[k + 1].t, csg_reach);
        const double bar[] = {t0, -0.1, t1, -0.1, t1, 0.1, t0, 0.1};
        figure_polygon(g, 4, bar, leaf ? fill[m.step[i].solid] : FIGURE_GREY, leaf ? 0.45 : 0.3,
                       NULL);
    }
    for (size_t k = 0; k < n; k++) {  /* each end in the colour of the surface that makes it */
        const char *own = fill[csg_solid_of(&c, (hit){.shape = x[k].surface})];
        double t = (double)x[k].t;
        figure_line(g, t, -0.13, t, 0.13, own, 4, FIGURE_WHOLE);
    }
    hit h;
    if (i == csg_rows - 1 && csg_hit(&c, r, &h))
        figure_text(g, (double)h.t, 0, 0, -20, FIGURE_MIDDLE, FIGURE_BLACK, "the hit");
    csg_free(&c);
}

static inline void csg_figure_node(figure *g, csg_model m, uint32_t i, double x, double y)
{
    static const char *const solid[] = {"ball _A_", "cube _B_", "cylinder _C_", "cylinder _D_"};
    static const char *const mark[] = {"", "∪", "∩", "−"};
    static const char *const what[] = {"", "_C_ ∪ _D_", "_A_ ∩ _B_", "(_A_ ∩ _B_) − (_C_ ∪ _D_)"};
    csg_operation w = m.step[i].what;
    figure_origin(g, x, y, 1);
    if (csg_spot[i].level > 0) {  /* down from the parent, and across */
        double up = (csg_spot[i].row - csg_spot[i].parent) * csg_row_height;
        figure_line(g, -44, up - 13, -44, 0, FIGURE_BLACK, 1.2, FIGURE_WHOLE);
        figure_line(g, -44, 0, w == CSG_SOLID ? -6 : -13, 0, FIGURE_BLACK, 1.2, FIGURE_WHOLE);
    }
    if (w == CSG_SOLID) {
        figure_text(g, 0, 0, 0, 5, FIGURE_LEFT, FIGURE_BLACK, solid[m.step[i].solid]);
        return;
    }
    for (int k = 0; k < 3; k++) figure_arc(g, 0, 0, 13, 120 * k, 120 * k + 120, FIGURE_BLACK, 1.2);
    figure_text(g, 0, 0, 0, 5, FIGURE_MIDDLE, FIGURE_BLACK, mark[w]);
    figure_text(g, 0, 0, 22, 5, FIGURE_LEFT, FIGURE_BLACK, what[w]);
}

cold_inline void csg_draw_tree(const options *o)
{
    const ray r = ray_from(vec(-0.25, -0.3, 0.1), vec(0.8, 0.66, 0.5));
    csg_scene s = csg_scene_of("difference(intersection(sphere 0 0 0 1.32, box -1 -1 -1 1 1 1), "
                               "union(cylinder 0 0 0 0 1 0 0.62, cylinder 0 0 0 0 0 1 0.5))");
    csg_model m = csg_expression_model(&s.e);
    double width = 910, top = 58, bars = width - csg_bars_left - 30;
    int height = (int)top + csg_rows * csg_row_height + 10;
    figure g = figure_begin(o, "06_csg_tree.svg", (int)width, height);
    double unit = bars / (2 * csg_reach), zero = csg_bars_left + bars / 2;
    figure_origin(&g, zero, top - 30, unit);
    double low = -(height - top + 10) / unit;
    figure_line(&g, 0, 0, 0, low, FIGURE_BLACK, 1.2, FIGURE_DASHED);
    figure_text(&g, 0, 0, 0, -8, FIGURE_MIDDLE, FIGURE_BLACK, "the eye, _t_ = 0");
    figure_text(&g, -csg_reach, 0, 0, -8, FIGURE_LEFT, FIGURE_GREY, "behind the eye");
    figure_arrow(&g, csg_reach - 0.6, -0.04, csg_reach, -0.04, FIGURE_BLACK, 1.5);
    figure_text(&g, csg_reach, 0, 0, -8, FIGURE_RIGHT, FIGURE_BLACK, "_t_");
    for (uint32_t i = 0; i < csg_rows; i++) {
        double y = top + csg_spot[i].row * csg_row_height + 20;
        csg_figure_node(&g, m, i, 36 + 44 * csg_spot[i].level, y);
        figure_origin(&g, zero, y, unit);
        figure_line(&g, -csg_reach, 0, csg_reach, 0, FIGURE_GREY, 1, FIGURE_WHOLE);
        csg_figure_bars(&g, m, i, r);
    }
    figure_end(&g);
    csg_scene_free(&s);
}

#endif
