/* two_levels.h: the drawing that explains: one ray through instances of one shape, and into one.
 *
 *   draw_two_levels(&o)      left: the world, boxes of the upper tree; right: the object's space
 *
 * Everything lies in the plane z = 0: the shape is a wall that stands on an outline, and boxes,
 * rays and hits are those of instances.h.
 */
#ifndef INSTANCES_LAB_TWO_LEVELS_H
#define INSTANCES_LAB_TWO_LEVELS_H

#include "../../../common/lab/figure.h"
#include "../../07_mesh/scenes/specimens.h"
#include "../instances.h"

enum { two_corners = 11, two_instances = 4 };

/* ---------------------------------------------------------------------------------------------- */

static const real two_outline[two_corners][2] = {
    {-0.8, -1}, {0.8, -1}, {0.8, 0.1}, {1.1, 0.1}, {0, 1.1}, {-0.3, 0.83}, {-0.3, 1.15},
    {-0.6, 1.15}, {-0.6, 0.555}, {-1.1, 0.1}, {-0.8, 0.1}};

static inline mesh two_wall(void)
{
    mesh m = specimen_new(2 * two_corners, 2 * two_corners);
    for (size_t i = 0; i < two_corners; i++) {
        size_t a = 2 * i, b = 2 * ((i + 1) % two_corners);
        for (size_t up = 0; up < 2; up++)
            m.v[a + up] = (vec3){two_outline[i][0], two_outline[i][1], up ? (real)0.1 : (real)-0.1};
        specimen_add(&m, a, b, b + 1), specimen_add(&m, a, b + 1, a + 1);
    }
    return m;
}

static inline void two_box(figure *g, vec3 lo, vec3 hi, const char *colour, double fill)
{
    double x0 = (double)lo.x, y0 = (double)lo.y, x1 = (double)hi.x, y1 = (double)hi.y;
    figure_polygon(g, 4, (double[]){x0, y0, x1, y0, x1, y1, x0, y1}, colour, fill, colour);
}

/* The boxes of both trees: of the world's, leaves are filled. */
static inline void two_upper(figure *g, const bvh_tree *tree)
{
    for (size_t k = 0; k < tree->nodes; k++) {
        const bvh_node *n = &tree->node[k];
        if (k == 1) continue;  /* not used */
        two_box(g, vec(n->low[0], n->low[1], 0), vec(box_high(n, 0), box_high(n, 1), 0),
                FIGURE_BLUE, n->count ? 0.1 : 0);
    }
}

static inline void two_lower(figure *g, const bvh8 *w)
{
    for (size_t k = 0; k < 8 * w->nodes; k++) {
        const float *at = &w->node[k / 8].side[0][k % 8];  /* the next side is 8 on */
        if (!(at[0] <= at[24])) continue;                  /* an empty place */
        two_box(g, frame_back(&w->frame, vec(at[0], at[8], 0)),
                frame_back(&w->frame, vec(at[24], at[32], 0)), FIGURE_PURPLE, 0);
    }
}

static inline void two_shape(figure *g, affine m, double fill)
{
    double xy[2 * two_corners];
    for (int i = 0; i < two_corners; i++) {
        vec3 p = affine_point(m, (vec3){two_outline[i][0], two_outline[i][1], 0});
        xy[2 * i] = (double)p.x, xy[2 * i + 1] = (double)p.y;
    }
    figure_polygon(g, two_corners, xy, FIGURE_GREEN, fill, FIGURE_BLACK);
}

/* Up to t = last, with a dot at each whole t from `from` on, numbered; red, where it hits. */
static inline void two_ray(figure *g, ray r, int from, double last, real hit_at)
{
    vec3 end = ray_at(r, (real)last), start = ray_at(r, (real)from - (from > 0 ? (real)0.4 : 0));
    vec3 at = ray_at(r, hit_at);
    figure_arrow(g, (double)start.x, (double)start.y, (double)end.x, (double)end.y, FIGURE_ORANGE,
                 2);
    for (int t = from; t < last; t++) {
        vec3 p = ray_at(r, (real)t);
        figure_dot(g, (double)p.x, (double)p.y, 3.5, FIGURE_BLACK);
        figure_print(g, (double)p.x, (double)p.y, -3, -9, FIGURE_MIDDLE, FIGURE_BLACK, "%d", t);
    }
    figure_dot(g, (double)at.x, (double)at.y, 5, FIGURE_RED);
}

static inline instance two_place(double x, double y, double sx, double sy, double degrees)
{
    affine a = affine_scaling(vec(sx, sy, 1));
    a = affine_then(a, affine_rotation((vec3){0, 0, 1}, (real)degrees * pi / 180));
    return (instance){affine_then(a, affine_translation(vec(x, y, 0))), 0};
}

cold_inline void draw_two_levels(const options *o)
{
    const instance list[two_instances] = {
        two_place(1.5, 3.7, 0.5, 0.6, 14), two_place(3.4, 1.15, 0.8, 0.6, -25),
        two_place(5.55, 3.3, 0.75, 0.75, 30), two_place(7.4, 1.6, -0.9, 1.1, 8)};
    mesh m = two_wall();
    instances x;
    instance_hit h = {hit_none, 0};
    failure f;
    if (!instances_build(&(crowd){&m, 1, list, two_instances}, instances_defaults, &x, &f)) fail(f);
    ray r = ray_from(vec(0.1, 1.3, 0), vec(1.02, 0.39, 0)), in;
    instances_hit(&x, r, &h);
    if (!instance_ray(&x.place[x.where[h.instance]].to_object, r, &in))
        die(1, "the drawing's ray is too short");
    figure g = figure_begin(o, "16_instances_levels.svg", 900, 370);
    figure_origin(&g, 14, 318, 62);
    two_upper(&g, &x.tree);
    for (uint32_t i = 0; i < two_instances; i++)
        two_shape(&g, list[i].to_world, i == h.instance ? 0.8 : 0.25);
    two_ray(&g, r, 0, 8.4, h.h.t);
    figure_text(&g, (double)r.o.x, (double)r.o.y, -2, 20, FIGURE_LEFT, FIGURE_BLACK, "*o*");
    figure_text(&g, 0, 0, 0, 30, FIGURE_LEFT, FIGURE_BLUE,
                "the world: TLAS, boxes round instances");
    figure_origin(&g, 778, 160, 62);
    two_box(&g, x.box[0].lo, x.box[0].hi, FIGURE_PURPLE, 0.08);
    two_lower(&g, &x.lower[0]);
    two_shape(&g, affine_translation((vec3){0, 0, 0}), 0.8);
    two_ray(&g, in, (int)h.h.t, (double)h.h.t + 1.3, h.h.t);
    figure_origin(&g, 612, 318, 1);
    figure_text(&g, 0, 0, 0, 8, FIGURE_LEFT, FIGURE_PURPLE, "the object: BLAS, one a mesh");
    figure_text(&g, 0, 0, 0, 30, FIGURE_LEFT, FIGURE_BLACK,
                "*o*' = _A_(*o* − *m*), *d*' = _A_ *d*, the same _t_");
    figure_end(&g);
    instances_free(&x), mesh_free(&m);
}

#endif
