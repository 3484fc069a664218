/* drawing.h: the slab test explained: three slabs, the part of a ray in each, and what they share.
 *
 *   draw_slabs(&o)     above: one box and one ray, with the planes of x, of y and of z; below: the
 *                      three intervals of t, for this ray and for one that misses. All t are those
 *                      of first_slab, (9.1).
 */
#ifndef AABB_DRAWING_H
#define AABB_DRAWING_H

#include "../../../common/lab/figure.h"
#include "../aabb.h"

static const aabb slabs_box = {{0, 0, 0}, {2, 1.5, 1.75}};
static const char *const slabs_colour[3] = {FIGURE_BLUE, FIGURE_RED, FIGURE_GREEN};
static const char *const slabs_name[3] = {"x", "y", "z"};

/* ---------------------------------------------------------------------------------------------- */

/* Where p is on the paper, seen from the right, above and in front, by parallel rays. */
static inline void slabs_project(vec3 p, double *x, double *y)
{
    vec3 view = vunit(vec(0.5, 0.42, 1)), right = vunit(vcross(vec(0, 1, 0), view));
    *x = (double)vdot(p, right), *y = (double)vdot(p, vcross(view, right));
}

static inline void slabs_line(figure *g, vec3 a, vec3 b, const char *colour, double width,
                              const char *dashes)
{
    double x0, y0, x1, y1;
    slabs_project(a, &x0, &y0), slabs_project(b, &x1, &y1);
    figure_line(g, x0, y0, x1, y1, colour, width, dashes);
}

/* Of the four edges along axis k, edge c: where it is at p_k = at. */
static inline vec3 slabs_corner(aabb b, int k, int c, real at)
{
    int i = (k + 1) % 3, j = (k + 2) % 3;
    return vwith(vwith(vwith(b.lo, k, at), i, vaxis(c & 1 ? b.hi : b.lo, i)), j,
                 vaxis(c & 2 ? b.hi : b.lo, j));
}

/* A piece of the plane p_k = at, with room round the box. */
static inline void slabs_plane(figure *g, int k, real at)
{
    const aabb b = first_aabb_pad(slabs_box, (real)0.55);
    double xy[8];
    for (int c = 0; c < 4; c++)
        slabs_project(slabs_corner(b, k, c ^ c >> 1, at), &xy[2 * c], &xy[2 * c + 1]);
    figure_polygon(g, 4, xy, slabs_colour[k], 0.16, slabs_colour[k]);
}

static inline void slabs_dot(figure *g, ray r, real t, const char *colour, double right,
                             double down, const char *text)
{
    double x, y;
    slabs_project(ray_at(r, t), &x, &y);
    figure_dot(g, x, y, 4, colour);
    figure_text(g, x, y, right, down, FIGURE_LEFT, colour, text);
}

static inline void slabs_panel(figure *g, int k, ray r, const real t[2])
{
    static const char *const mark[3][2] = {{"_t_~min,x~", "_t_~max,x~"},
                                           {"_t_~min,y~", "_t_~max,y~"},
                                           {"_t_~min,z~", "_t_~max,z~"}};
    const aabb b = slabs_box;
    double x, y, tip_x, tip_y;
    slabs_plane(g, k, vaxis(b.lo, k)), slabs_plane(g, k, vaxis(b.hi, k));
    for (int a = 0; a < 3; a++)
        for (int c = 0; c < 4; c++)
            slabs_line(g, slabs_corner(b, a, c, vaxis(b.lo, a)),
                       slabs_corner(b, a, c, vaxis(b.hi, a)), FIGURE_GREY, 1.2, FIGURE_WHOLE);
    slabs_project(ray_at(r, 0), &x, &y), slabs_project(ray_at(r, (real)4.4), &tip_x, &tip_y);
    figure_arrow(g, x, y, tip_x, tip_y, FIGURE_BLACK, 1.2);
    slabs_line(g, ray_at(r, t[0]), ray_at(r, t[1]), slabs_colour[k], 4, FIGURE_WHOLE);
    slabs_dot(g, r, 0, FIGURE_BLACK, -4, 22, "*o*");
    slabs_dot(g, r, t[0], slabs_colour[k], k == 2 ? -88 : -54, k == 2 ? 2 : -12, mark[k][0]);
    slabs_dot(g, r, t[1], slabs_colour[k], 2, 22, mark[k][1]);
    figure_text(g, tip_x, tip_y, -4, -10, FIGURE_RIGHT, FIGURE_BLACK, "*o* + _t_ *d*");
}

/* The intervals of the three axes, and their overlap, with t = 0 at the origin of g. */
static inline void slabs_bars(figure *g, real t[3][2], const char *title)
{
    double enter = 0, leave = 1e9;
    figure_text(g, 0, 0, 0, -128, FIGURE_LEFT, FIGURE_BLACK, title);
    for (int k = 0; k < 3; k++) {
        double y = (88 - 24 * k) / g->unit, a = (double)t[k][0], b = (double)t[k][1];
        figure_print(g, 0, y, -20, 5, FIGURE_LEFT, slabs_colour[k], "_%s_", slabs_name[k]);
        figure_line(g, a, y, b, y, slabs_colour[k], 9, FIGURE_WHOLE);
        enter = fmax(enter, a), leave = fmin(leave, b);
    }
    figure_arrow(g, 0, 0, 4.5, 0, FIGURE_BLACK, 1.2);
    figure_text(g, 4.5, 0, 5, 5, FIGURE_LEFT, FIGURE_BLACK, "_t_");
    figure_text(g, 0, 0, -4, 19, FIGURE_LEFT, FIGURE_BLACK, "0");
    figure_line(g, enter, 0, enter, 104 / g->unit, FIGURE_BLACK, 1, FIGURE_DASHED);
    figure_line(g, leave, 0, leave, 104 / g->unit, FIGURE_BLACK, 1, FIGURE_DASHED);
    bool met = enter < leave;
    if (met) figure_line(g, enter, 12 / g->unit, leave, 12 / g->unit, FIGURE_BLACK, 9, "");
    figure_text(g, enter, 0, met ? 8 : -6, 19, met ? FIGURE_RIGHT : FIGURE_LEFT, FIGURE_BLACK,
                "_t_~enter~");
    figure_text(g, leave, 0, met ? -8 : 6, 19, met ? FIGURE_LEFT : FIGURE_RIGHT, FIGURE_BLACK,
                "_t_~exit~");
}

cold_inline void draw_slabs(const options *o)
{
    static const char *const title[2] = {
        "this ray: in all three slabs from _t_~enter~ to _t_~exit~",
        "a steeper ray leaves _y_ before it enters _z_: a miss"};
    const vec3 from = vec(-1, -0.2, 2.75);
    const ray r[2] = {ray_from(from, vec(1, 0.5, -0.75)), ray_from(from, vec(1, 1.8, -0.75))};
    figure g = figure_begin(o, "09_aabb_slabs.svg", 880, 460);
    real t[2][3][2];
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            first_slab(vaxis(slabs_box.lo, k), vaxis(slabs_box.hi, k), vaxis(r[i].o, k),
                       vaxis(r[i].d, k), &t[i][k][0], &t[i][k][1]);
    for (int k = 0; k < 3; k++) {
        figure_origin(&g, 128 + 289 * k, 182, 52);
        slabs_panel(&g, k, r[0], t[0][k]);
        figure_origin(&g, 158 + 289 * k, 0, 1);
        figure_print(&g, 0, 0, 0, 22, FIGURE_MIDDLE, slabs_colour[k],
                     "the slab of _%s_, between _lo_~%s~ and _hi_~%s~", slabs_name[k],
                     slabs_name[k], slabs_name[k]);
    }
    for (int i = 0; i < 2; i++) {
        figure_origin(&g, 50 + 440 * i, 424, 78);
        slabs_bars(&g, t[i], title[i]);
    }
    figure_end(&g);
}

#endif
