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
#include "../instances.h"

enum { two_corners = 11, two_instances = 4 };

/* ---------------------------------------------------------------------------------------------- */

static const real two_outline[two_corners][2] = {
    {-0.8, -1}, {0.8, -1}, {0.8, 0.1}, {1.1, 0.1}, {0, 1.1}, {-0.3, 0.83}, {-0.3, 1.15},
    {-0.6, 1.15}, {-0.6, 0.555}, {-1.1, 0.1}, {-0.8, 0.1}};

static inline mesh two_wall(void)
{
    mesh m = {.vertices = 2 * two_corners, .triangles = 2 * two_corners};
    m.v = allocate(m.vertices, sizeof *m.v);
    m.index = allocate(3 * m.triangles, sizeof *m.index);
    uint32_t *k = m.index;
    for (uint32_t i = 0; i < two_corners; i++) {
        uint32_t a = 2 * i, b = 2 * ((i + 1) % two_corners);
        for (uint32_t up = 0; up < 2; up++)
            m.v[a + up] = (vec3){two_outline[i][0], two_outline[i][1], up ? (real)0.1 : (real)-0.1};
        *k++ = a, *k++ = b, *k++ = b + 1, *k++ = a, *k++ = b + 1, *k++ = a + 1;
    }
    return m;
}

static inline void two_box(figure *g, const bvh_box *b, const char *colour, double fill)
{
    double x0 = (double)b->side[0], y0 = (double)b->side[1], x1 = (double)b->side[3];
    double y1 = (double)b->side[4], xy[8] = {x0, y0, x1, y0, x1, y1, x0, y1};
    figure_polygon(g, 4, xy, colour, fill, colour);
}

static inline void two_shape(figure *g, affine m, const char *colour, double fill)
{
    double xy[2 * two_corners];
    for (int i = 0; i < two_corners; i++) {
        vec3 p = affine_point(m, (vec3){two_outline[i][0], two_outline[i][1], 0});
        xy[2 * i] = (double)p.x, xy[2 * i + 1] = (double)p.y;
    }
    figure_polygon(g, two_corners, xy, colour, fill, FIGURE_BLACK);
}

/* Up to t = last, with a dot at each whole t from `from` on, numbered. */
static inline void two_ray(figure *g, ray r, int from, double last, double right, double down)
{
    vec3 end = ray_at(r, (real)last), start = ray_at(r, (real)from - (from > 0 ? (real)0.4 : 0));
    figure_arrow(g, (double)start.x, (double)start.y, (double)end.x, (double)end.y, FIGURE_ORANGE,
                 2);
    for (int t = from; t < last; t++) {
        vec3 p = ray_at(r, (real)t);
        figure_dot(g, (double)p.x, (double)p.y, 3.5, FIGURE_BLACK);
        figure_print(g, (double)p.x, (double)p.y, right, down, FIGURE_MIDDLE, FIGURE_BLACK, "%d",
                     t);
    }
}

static inline affine two_place(double x, double y, double sx, double sy, double degrees)
{
    affine a = affine_scaling(vec(sx, sy, 1));
    a = affine_then(a, affine_rotation((vec3){0, 0, 1}, (real)degrees * pi / 180));
    return affine_then(a, affine_translation(vec(x, y, 0)));
}

static inline void draw_two_levels(const options *o)
{
    const instance list[two_instances] = {{two_place(1.5, 3.7, 0.5, 0.6, 14), 0},
                                          {two_place(3.4, 1.15, 0.8, 0.6, -25), 0},
                                          {two_place(5.55, 3.3, 0.75, 0.75, 30), 0},
                                          {two_place(7.4, 1.6, -0.9, 1.1, 8), 0}};
    mesh m = two_wall();
    crowd c = {&m, 1, list, two_instances};
    instances x;
    instance_hit h = {hit_none, 0};
    failure f;
    if (!instances_build(&c, instances_defaults, &x, &f)) fail(f);
    ray r = ray_from(vec(0.1, 1.3, 0), vec(1.02, 0.39, 0)), in;
    instances_hit(&x, r, &h);
    figure g = figure_begin(o, "16_instances_levels.svg", 900, 370);
    figure_origin(&g, 14, 318, 62);
    for (size_t k = 2; k < x.tree.nodes; k++)  /* node 1 is not used */
        two_box(&g, &x.tree.node[k].box, FIGURE_BLUE, x.tree.node[k].count ? 0.1 : 0);
    two_box(&g, &x.tree.node[0].box, FIGURE_BLUE, 0);
    for (uint32_t i = 0; i < two_instances; i++)
        two_shape(&g, list[i].to_world, FIGURE_GREEN, i == h.instance ? 0.8 : 0.25);
    two_ray(&g, r, 0, 8.4, -3, -9);
    figure_text(&g, (double)r.o.x, (double)r.o.y, -2, 20, FIGURE_LEFT, FIGURE_BLACK, "*o*");
    vec3 at = ray_at(r, h.h.t);
    figure_dot(&g, (double)at.x, (double)at.y, 5, FIGURE_RED);
    figure_text(&g, 0, 0, 0, 30, FIGURE_LEFT, FIGURE_BLUE,
                "the world: TLAS, boxes round instances");
    const placed *p = &x.place[x.where[h.instance]];
    if (!instance_ray(&p->to_object, r, &in)) die(1, "the drawing's ray is too short");
    figure_origin(&g, 778, 160, 62);
    const bvh_tree *lower = &x.lower[0].tree;
    for (size_t k = 0; k < lower->nodes; k++)
        if (k != 1) two_box(&g, &lower->node[k].box, FIGURE_PURPLE, k ? 0 : 0.08);
    affine none = affine_translation((vec3){0, 0, 0});
    two_shape(&g, none, FIGURE_GREEN, 0.8);
    two_ray(&g, in, (int)h.h.t, (double)h.h.t + 1.3, -3, -9);
    at = ray_at(in, h.h.t);
    figure_dot(&g, (double)at.x, (double)at.y, 5, FIGURE_RED);
    figure_origin(&g, 612, 318, 1);
    figure_text(&g, 0, 0, 0, 8, FIGURE_LEFT, FIGURE_PURPLE, "the object: BLAS, one a mesh");
    figure_text(&g, 0, 0, 0, 30, FIGURE_LEFT, FIGURE_BLACK,
                "*o*' = _A_(*o* − *m*), *d*' = _A_ *d*, the same _t_");
    figure_end(&g);
    instances_free(&x), mesh_free(&m);
}

#endif
