/* pictures.h: the drawing of this page: the root's eight boxes, one ray, and the rows of lanes; and
 * the main picture.
 *
 *   draw_lanes(o)     a real tree of triangles on a plane, seen from above; the numbers are those
 *                     that bvh8_boxes computes
 *   draw_steps(o, &s)   the nodes and leaves on the way of each pixel's ray, in the tree of 14 and
 *                     eight wide
 */
#ifndef WIDE_PICTURES_H
#define WIDE_PICTURES_H

#include "../../../common/lab/figure.h"
#include "../../07_mesh/scenes/soup.h"
#include "../../09_aabb/trials/pictures.h"
#include "measure.h"

/* ---------------------------------------------------------------------------------------------- */

/* Small triangles along three arcs: what a plane shows without covering itself. */
static inline mesh lanes_mesh(void)
{
    enum { n = 120 };
    mesh m = mesh_room(n);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(4, i, 0);
        real a = (real)i / n * 6, x = cos(a) * (1 + a / 6), y = sin(2 * a) * (1 + a / 9) / 2;
        vec3 c = {x, y, 0};
        for (size_t k = 0; k < 3; k++) {
            vec3 e = random_in_cube(&g, (real)0.07);
            m.v[3 * i + k] = (vec3){c.x + e.x, c.y + e.y, e.z};
        }
    }
    return m;
}

static inline void lanes_box(figure *g, const bvh8 *w, const bvh8_node *n, int k, bool met)
{
    vec3 lo = frame_back(&w->frame, vec(n->side[0][k], n->side[1][k], 0));
    vec3 hi = frame_back(&w->frame, vec(n->side[3][k], n->side[4][k], 0));
    double xy[8] = {(double)lo.x, (double)lo.y, (double)hi.x, (double)lo.y,
                    (double)hi.x, (double)hi.y, (double)lo.x, (double)hi.y};
    figure_polygon(g, 4, xy, met ? FIGURE_ORANGE : NULL, 0.18, met ? FIGURE_RED : FIGURE_GREY);
    figure_dot(g, xy[6], xy[7], 8, "#ffffff");  /* no edge goes through the number */
    figure_print(g, xy[6], xy[7], 0, 5, FIGURE_MIDDLE, met ? FIGURE_RED : FIGURE_GREY, "%d", k);
}

static inline void lanes_cells(figure *g, int row, const char *name, const eight *values,
                               eight_set met, const char *colour)
{
    double y = 24 * row;
    char text[16];
    figure_text(g, 0, -y, -10, 16, FIGURE_RIGHT, FIGURE_BLACK, name);
    for (int k = 0; k < 8; k++) {
        double x = 62 * k, xy[8] = {x, -y, x + 60, -y, x + 60, -y - 22, x, -y - 22};
        bool in = met >> 8 * k & 1;
        figure_polygon(g, 4, xy, in ? FIGURE_ORANGE : colour, in ? 0.3 : 0.08, FIGURE_GREY);
        if (values) snprintf(text, sizeof text, "%.2f", (double)(*values)[k]);
        else snprintf(text, sizeof text, "%d", row ? in : k);
        figure_text(g, x, -y, 30, 16, FIGURE_MIDDLE, FIGURE_BLACK, text);
    }
}

cold_inline void draw_lanes(const options *o)
{
    static const char *const side[6] = {"low _x_", "low _y_", "low _z_", "high _x_", "high _y_",
                                        "high _z_"};
    figure g = figure_begin(o, "15_wide_bvh_lanes.svg", 640, 610);
    mesh m = lanes_mesh();
    items x = items_of_mesh(&m);
    bvh8 w;
    failure f;
    bvh8_options how = bvh8_defaults;
    how.width = 8, how.leaf = 4;  /* a deeper tree: smaller boxes */
    if (!bvh8_build(&x, how, &w, &f)) fail(f);
    ray r = {{(real)-1.9, (real)-0.62, 0}, 0, {1, (real)0.4, 0}, 9};
    bvh8_ray q = {.doubts = 0};
    bvh8_ray_of(&w, &r, &bvh8_skip_none, &q);
    q.limit = INFINITY;
    const bvh8_node *n = &w.node[0];
    eight enter, exit;
    for (int k = 0; k < 8; k++) {
        float end = q.limit;
        for (int a = 0; a < 3; a++) {
            float far = (&n->side[0][k])[q.far[a] / (int)sizeof far];
            end = float_min(far * q.inverse[a] + q.far_o[a], end);
        }
        exit[k] = end;
    }
    eight_set met = bvh8_boxes_0(n, &q, &enter);
    for (int k = 0; k < 8; k++)
        enter[k] /= (float)q.scale, exit[k] /= (float)q.scale;
    figure_origin(&g, 330, 165, 130);
    for (size_t i = 0; i < m.triangles; i++) {
        double xy[6];
        for (size_t k = 0; k < 3; k++)
            xy[2 * k] = (double)m.v[3 * i + k].x, xy[2 * k + 1] = (double)m.v[3 * i + k].y;
        figure_polygon(&g, 3, xy, FIGURE_SKY, 0.6, FIGURE_BLUE);
    }
    for (int k = 0; k < 8; k++) lanes_box(&g, &w, n, k, met >> 8 * k & 1);
    figure_arrow(&g, -1.9, -0.62, 2.2, 1.02, FIGURE_BLACK, 2);
    figure_text(&g, -1.9, -0.62, 0, 18, FIGURE_LEFT, FIGURE_BLACK, "*o* + _t_ *d*");
    figure_origin(&g, 110, 345, 1);
    lanes_cells(&g, 0, "lane", NULL, 0, "#ffffff");
    for (int s = 0; s < 6; s++) {
        eight row = *(const eight *)n->side[s];
        for (int k = 0; k < 8; k++) row[k] /= (float)w.frame.scale;
        lanes_cells(&g, 1 + s, side[s], &row, 0, s < 3 ? FIGURE_BLUE : FIGURE_GREEN);
    }
    lanes_cells(&g, 8, "_t_~enter~", &enter, met, "#ffffff");
    lanes_cells(&g, 9, "_t_~exit~", &exit, met, "#ffffff");
    lanes_cells(&g, 10, "met", NULL, met, "#ffffff");
    figure_end(&g);
    bvh8_free(&w);
    mesh_free(&m);
}

/* ---- the main picture ---- */

static inline vec3 steps_colour(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    search_work w = trial_eye_work(p, x, y);
    return work_colour((real)(w.nodes + w.leaves) / p->most);
}

cold_inline void draw_steps(const options *o, const trial_scene *s)
{
    enum { most = 50 };
    static const char *const title[2] = {"two wide (14)", "eight wide"};
    const bvh_options two = bvh_defaults;
    const bvh8_options all = bvh8_defaults;
    int height = o->height * 5 / 8;
    image im = image_new(o->width, height > 0 ? height : 1);
    vec3 lo, hi;
    mesh_bounds(&s->m, &lo, &hi);
    camera c = camera_of(lo, hi, true, (real)im.width / 2 / (real)im.height);
    const trial_panel panel[2] = {{s, &two_wide_trial, &two, c, most, 1, steps_colour},
                                  {s, &bvh8_trial, &all, c, most, 1, steps_colour}};
    bool whole = trial_draw_panels(&im, 2, 1, 0, panel, false, o->threads);
    trial_label_work(&im, 2, 1, title, most, "nodes and leaves a ray");
    output_picture(o, &im, "15_wide_bvh.png", true, whole);
    image_free(&im);
}

#endif
