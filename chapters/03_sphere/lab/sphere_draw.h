/* sphere_draw.h: the pictures of this chapter.
 *
 *   sphere_draw(&o)           a sphere through a long lens from 1e7, 2e7, 5e7 and 1e8 radii, in
 *                             float from 500, 1000, 2000 and 5000: above by first.h, below by
 *                             sphere_hit; |n.d|, red where a ray through the disc misses, blue
 *                             where a ray beside it hits
 *   sphere_draw_geometry(&o)  t_ca, t_hc, q and R: (3.4) to (3.6), where sphere_roots finds them
 */
#ifndef SPHERE_DRAW_H
#define SPHERE_DRAW_H

#include "../../../common/headlight.h"
#include "../../../common/lab/figure.h"
#include "../../../common/lab/panels.h"
#include "mine.h"
#include "sphere_variants.h"

/* ---------------------------------------------------------------------------------------------- */

enum { sphere_columns = 4, sphere_rows = 2 + sphere_mine };

static const vec3 sphere_red = {0.8, 0.1, 0.05};
static const vec3 sphere_blue = {0.05, 0.25, 0.8};

/* From o = far u to the point x, y of the plane through the centre. */
static inline ray sphere_eye_ray(real far, real x, real y)
{
    vec3 u = vunit((vec3){1, 2, 3}), right, up;
    vbasis(u, &right, &up);
    vec3 o = vscale(u, far);
    return ray_from(o, vsub(vadd(vscale(right, x), vscale(up, y)), o));
}

/* Of a panel; all compute in the precision of this build. The window is 2.3 R high, or wide. */
typedef struct { sphere_hit_function *X_hit; real far, width, height; } sphere_panel;

static vec3 sphere_panel_colour(const void *context, real x, real y)
{
    const sphere_panel *p = context;
    real scale = (real)2.3 / real_min(p->width, p->height);
    ray r = sphere_eye_ray(p->far, (x - p->width / 2) * scale, (p->height / 2 - y) * scale);
    sphere ball = {{0, 0, 0}, 1};
    hit found;
    bool is = p->X_hit(ball, r, &found), due = sphere_clearance(ball, r) <= 0;
    if (is != due) return due ? sphere_red : sphere_blue;
    if (!is) return vec(1, 1, 1);
    /* The textbook divides by R and trusts that the point is on the surface. */
    vec3 n = ray_at(r, found.t);
    if (p->X_hit == sphere_hit) n = sphere_normal(ball, sphere_point(ball, n));
    return vscale(headlight(n, r.d), (real)0.8);
}

static inline void sphere_draw(const options *o)
{
    static const struct { real far; const char *name; } eye[2][sphere_columns] = {
        {{1e7, "1e7"}, {2e7, "2e7"}, {5e7, "5e7"}, {1e8, "1e8"}},
        {{500, "500"}, {1000, "1000"}, {2000, "2000"}, {5000, "5000"}}};
    const struct { int x; vec3 colour; const char *text; } key[3] = {
        {30, sphere_red, "misses, but should hit"}, {290, sphere_blue, "hits, but should miss"},
        {540, {0, 0, 0}, "hits, but b^2 - 4ac came out as 0"}};
    const char *const of[] = {real_is_float ? "first.h, float, " : "first.h, double, ",
                              "sphere_hit, ", "mine, "};
    sphere_hit_function *const test[] = {first_sphere_hit, sphere_hit, mine_sphere_hit};
    bool words = o->width >= 880 && o->height >= 400, whole;
    panels_shape g = {o->width, o->height, sphere_columns, sphere_rows, words ? 6 : 0, 1, !words};
    sphere_panel s[sphere_columns * sphere_rows];
    panel p[sphere_columns * sphere_rows];
    char name[sphere_columns * sphere_rows][64];
    for (int k = 0; k < sphere_columns * sphere_rows; k++) {
        int column = k % sphere_columns, row = k / sphere_columns;
        s[k] = (sphere_panel){test[row], eye[real_is_float][column].far, (real)panels_wide(g),
                              (real)panels_high(g)};
        snprintf(name[k], sizeof name[k], "%sfrom %s R", column ? "" : of[row],
                 eye[real_is_float][column].name);
        p[k] = (panel){name[k], &s[k]};
    }
    image im = panels_new(o, g, sphere_panel_colour, p, &whole);
    if (words) label_below(&im, 34);
    for (int k = 0; k < 3 && words; k++) {
        label_fill(&im, key[k].x, im.height - 26, 18, 18, key[k].colour);
        label_text(&im, key[k].x + 26, im.height - 12, 11, 0, vec(0, 0, 0), key[k].text);
    }
    output_picture(o, &im, "03_sphere.png", true, whole);
    image_free(&im);
}

/* A length between two arrow heads, and its name. */
static inline void sphere_measured(figure *g, double x0, double x1, double y, double down,
                                   const char *colour, const char *name)
{
    double middle = (x0 + x1) / 2;
    figure_arrow(g, middle, y, x0, y, colour, 1), figure_arrow(g, middle, y, x1, y, colour, 1);
    figure_text(g, middle, y, 0, down, FIGURE_MIDDLE, colour, name);
}

cold_inline void sphere_draw_geometry(const options *o)
{
    const sphere ball = {{0, 0, 0}, 1};
    const ray r = ray_from(vec(-2.9, 0.55, 0), vec(0.8, 0, 0));
    real t0 = 0, t1 = 0, tca = -vdot(r.d, r.o) / vdot(r.d, r.d);  /* (3.4); c is the origin */
    figure g = figure_begin(o, "03_sphere_geometry.svg", 820, 390);
    if (!sphere_roots(ball, r, &t0, &t1)) abort();
    double y = (double)r.o.y, ox = (double)r.o.x, in = (double)ray_at(r, t0).x;
    double foot = (double)ray_at(r, tca).x, out = (double)ray_at(r, t1).x;
    const double half[] = {0, 0, foot, y, in, y};
    figure_origin(&g, 500, 225, 150);
    figure_polygon(&g, 3, half, FIGURE_SKY, 0.3, NULL);
    for (int k = 0; k < 3; k++) figure_arc(&g, 0, 0, 150, 120 * k, 120 * k + 120, FIGURE_BLACK, 2);
    figure_line(&g, ox, y, 2.05, y, FIGURE_BLUE, 1.5, FIGURE_WHOLE);
    figure_arrow(&g, ox, y, ox + (double)r.d.x, y, FIGURE_BLUE, 2.5);
    figure_line(&g, 0, 0, in, y, FIGURE_BLACK, 1.5, FIGURE_WHOLE);
    figure_line(&g, 0, 0, foot, y, FIGURE_RED, 1.5, FIGURE_WHOLE);
    figure_line(&g, foot - 0.08, y, foot - 0.08, y - 0.08, FIGURE_BLACK, 1, FIGURE_WHOLE);
    figure_line(&g, foot - 0.08, y - 0.08, foot, y - 0.08, FIGURE_BLACK, 1, FIGURE_WHOLE);
    for (int k = 0; k < 2; k++)
        figure_line(&g, k ? foot : ox, y, k ? foot : ox, 1.2, FIGURE_GREEN, 1, FIGURE_DASHED);
    sphere_measured(&g, ox, foot, 1.17, -8, FIGURE_GREEN, "_t_~ca~");
    sphere_measured(&g, in, foot, y + 0.09, -8, FIGURE_PURPLE, "_t_~hc~");
    sphere_measured(&g, foot, out, y + 0.09, -8, FIGURE_PURPLE, "_t_~hc~");
    figure_dot(&g, ox, y, 4, FIGURE_BLACK), figure_dot(&g, 0, 0, 4, FIGURE_BLACK);
    figure_dot(&g, in, y, 4, FIGURE_BLUE), figure_dot(&g, out, y, 4, FIGURE_BLUE);
    figure_text(&g, ox, y, -4, 22, FIGURE_MIDDLE, FIGURE_BLACK, "*o*");
    figure_text(&g, ox + (double)r.d.x / 2, y, 0, 22, FIGURE_MIDDLE, FIGURE_BLUE, "*d*");
    figure_text(&g, 0, 0, 12, 12, FIGURE_LEFT, FIGURE_BLACK, "*c*");
    figure_text(&g, in / 2, y / 2, -10, 12, FIGURE_RIGHT, FIGURE_BLACK, "_R_");
    figure_text(&g, foot, y / 2, 8, 12, FIGURE_LEFT, FIGURE_RED, "_q_");
    figure_text(&g, in, y, -12, -9, FIGURE_RIGHT, FIGURE_BLUE, "_t_~0~: in");
    figure_text(&g, out, y, 12, -9, FIGURE_LEFT, FIGURE_BLUE, "_t_~1~: out");
    figure_end(&g);
}

#endif
