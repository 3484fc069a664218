/* boxes_figure.h: boxes in boxes, the tree that they are, and what one ray sees of both.
 *
 *   draw_nested(&o)     left: ten balls, cut in their middle by the plane of the paper, and the
 *                       boxes of their tree; right: the tree. It is built by bvh_build and
 *                       searched by tree_search, whose leaves say in which order they were asked.
 */
#ifndef BVH_BOXES_FIGURE_H
#define BVH_BOXES_FIGURE_H

#include "../../../common/lab/figure.h"
#include "../bvh.h"

enum { boxes_balls = 10, boxes_most = 32 };
static const double boxes_ball[boxes_balls][3] = {  /* x, y, radius */
    {1.1, 1.2, 0.55}, {2.4, 0.9, 0.4}, {1.7, 2.7, 0.45}, {1.0, 5.9, 0.5}, {2.5, 5.2, 0.45},
    {5.6, 2.4, 0.55}, {6.9, 1.0, 0.45}, {8.3, 3.0, 0.5}, {7.1, 5.5, 0.6}, {8.6, 4.6, 0.4}};
static const char *const boxes_colour[4] = {FIGURE_BLACK, FIGURE_BLUE, FIGURE_GREEN, FIGURE_PURPLE};

typedef enum { BOXES_UNSEEN, BOXES_MISSED, BOXES_DROPPED, BOXES_ENTERED } boxes_state;

typedef struct {
    const bvh *b;
    uint32_t asked[boxes_most];     /* of each leaf, as the search comes to it: its first item */
    int n;
    boxes_state state[boxes_most];  /* [node] */
    int turn[boxes_most];           /* [node] a leaf's place in that order, from 1; 0: not asked */
    double column[boxes_most];      /* [node] */
    int depth[boxes_most], deepest;
    char name[boxes_most];
    int names, leaves;              /* so far */
} boxes_figure;

/* ---------------------------------------------------------------------------------------------- */

static inline bool boxes_leaf(const void *context, uint32_t first, uint32_t count, query *q,
                              bool any)
{
    boxes_figure *x = *(boxes_figure *const *)context;
    x->asked[x->n++] = first;
    return bvh_shapes_leaf(x->b, first, count, q, any);
}

/* A box is missed; or met, but beyond the hit at limit: dropped, if nothing in it was asked. */
static inline void boxes_judge(boxes_figure *x, uint32_t at, const box_ray *q, float limit,
                               bool seen, int depth)
{
    const bvh_node *n = &x->b->shapes.node[at];
    float exit, enter = box_enter(n, q, INFINITY, &exit);
    x->depth[at] = depth, x->name[at] = (char)('A' + x->names++);
    if (depth > x->deepest) x->deepest = depth;
    x->state[at] = !seen ? BOXES_UNSEEN : enter > exit ? BOXES_MISSED
                 : enter > limit ? BOXES_DROPPED : BOXES_ENTERED;
    for (int i = 0; n->count && i < x->n; i++)
        if (x->asked[i] == n->first) x->turn[at] = i + 1, x->state[at] = BOXES_ENTERED;
    if (n->count) {
        x->column[at] = x->leaves++;
        return;
    }
    seen = x->state[at] == BOXES_ENTERED;
    boxes_judge(x, n->first, q, limit, seen, depth + 1);
    boxes_judge(x, n->first + 1, q, limit, seen, depth + 1);
    x->column[at] = (x->column[n->first] + x->column[n->first + 1]) / 2;
}

/* The boxes, a little apart so that common sides are two lines. */
static inline void boxes_boxes(figure *g, const boxes_figure *x)
{
    for (uint32_t i = 0; i < x->b->shapes.nodes; i++) {
        const bvh_node *n = &x->b->shapes.node[i];
        int depth = x->depth[i];
        double out = 5.0 * (x->deepest - depth) / g->unit, lo[2], hi[2];
        if (i == 1) continue;
        for (int k = 0; k < 2; k++)
            lo[k] = (double)n->low[k] - out, hi[k] = (double)box_high(n, k) + out;
        double xy[8] = {lo[0], lo[1], hi[0], lo[1], hi[0], hi[1], lo[0], hi[1]};
        char text[4] = {x->name[i], 0};
        figure_polygon(g, 4, xy, FIGURE_GREY, 0, boxes_colour[depth]);
        if (depth == 1) figure_text(g, hi[0], lo[1], 0, 24, FIGURE_RIGHT, boxes_colour[1], text);
        else figure_text(g, depth ? hi[0] : lo[0], hi[1], depth ? -5 : 0, depth ? 16 : -6,
                         depth ? FIGURE_RIGHT : FIGURE_LEFT, boxes_colour[depth], text);
    }
}

static inline void boxes_node(figure *g, const boxes_figure *x, uint32_t i, double px, double py)
{
    static const char *const says[4] = {"never tested", "tested: missed", "met, dropped",
                                        "entered"};
    const bvh_node *n = &x->b->shapes.node[i];
    double xy[8] = {px - 18, py - 16, px + 18, py - 16, px + 18, py + 16, px - 18, py + 16};
    char text[64] = {x->name[i], 0};
    figure_polygon(g, 4, xy, "white", 1, boxes_colour[x->depth[i]]);
    figure_polygon(g, 4, xy, x->state[i] == BOXES_ENTERED ? FIGURE_SKY : FIGURE_ORANGE,
                   x->state[i] < BOXES_DROPPED ? 0 : 0.4, boxes_colour[x->depth[i]]);
    figure_text(g, px, py, 0, 5, FIGURE_MIDDLE, boxes_colour[x->depth[i]], text);
    if (!n->count) {
        figure_text(g, px, py, 25, 5, FIGURE_LEFT, FIGURE_BLACK, says[x->state[i]]);
        return;
    }
    for (uint32_t k = 0, at = 0; k < n->count; k++)
        at += (uint32_t)snprintf(text + at, sizeof text - at, "%s%u", k ? ", " : "",
                                 x->b->index[n->first + k] + 1);
    figure_text(g, px, py, 0, 36, FIGURE_MIDDLE, FIGURE_GREY, text);
    figure_print(g, px, py, 0, 56, FIGURE_MIDDLE, FIGURE_BLACK, "%s",
                 x->turn[i] > 1 ? "asked second" : x->turn[i] ? "asked first" : says[x->state[i]]);
}

static inline void boxes_tree(figure *g, const boxes_figure *x)
{
    for (int pass = 0; pass < 2; pass++)  /* lines below, nodes above */
        for (uint32_t i = 0; i < x->b->shapes.nodes; i++) {
            const bvh_node *n = &x->b->shapes.node[i];
            double px = x->column[i] * 122, py = -120.0 * x->depth[i];
            if (pass && i != 1) boxes_node(g, x, i, px, py);
            for (uint32_t c = n->first; !pass && i != 1 && !n->count && c < n->first + 2; c++) {
                bool in = x->state[c] == BOXES_ENTERED;
                figure_line(g, px, py, x->column[c] * 122, -120.0 * x->depth[c],
                            in ? FIGURE_RED : FIGURE_GREY, in ? 2.5 : 1,
                            in ? FIGURE_WHOLE : FIGURE_DASHED);
            }
        }
}

cold_inline void draw_nested(const options *o)
{
    figure g = figure_begin(o, "14_bvh_nested.svg", 990, 390);
    shape ball[boxes_balls];
    scene s = {ball, boxes_balls};
    bvh b;
    failure f;
    boxes_figure x = {.b = &b}, *context = &x;
    ray r = ray_from(vec(-0.4, 1.602, 0), vec(1, 0.12, 0));
    hit h = hit_none;
    for (int i = 0; i < boxes_balls; i++)
        ball[i] = shape_of_sphere((sphere){vec(boxes_ball[i][0], boxes_ball[i][1], 0),
                                           (real)boxes_ball[i][2]});
    items all = items_of_scene(&s);
    if (!bvh_build(&all, (bvh_options){"median", 3, 1, SIZE_MAX}, &b, &f)) fail(f);
    tree_search(&b.shapes, r, box_ray_of, boxes_leaf, &context, false, &h, NULL);
    box_ray q = box_ray_of(r, b.shapes.node, NULL);
    boxes_judge(&x, 0, &q, box_ray_limit(&q, h.t), true, 0);
    figure_origin(&g, 40, 356, 46);
    boxes_boxes(&g, &x);
    for (int i = 0; i < boxes_balls; i++) {
        const double *c = boxes_ball[i];
        double ring[64];
        for (int k = 0; k < 32; k++) {
            ring[2 * k] = c[0] + c[2] * cos(k * (double)pi / 16);
            ring[2 * k + 1] = c[1] + c[2] * sin(k * (double)pi / 16);
        }
        figure_polygon(&g, 32, ring, FIGURE_GREY, h.shape == (uint32_t)i ? 0.6 : 0.25, FIGURE_GREY);
        figure_print(&g, c[0], c[1], 0, 5, FIGURE_MIDDLE, FIGURE_BLACK, "%d", i + 1);
    }
    vec3 p = ray_at(r, h.t), end = ray_at(r, (real)10.2);
    double ox = (double)r.o.x, oy = (double)r.o.y, px = (double)p.x, py = (double)p.y;
    figure_line(&g, ox, oy, px, py, FIGURE_RED, 2.5, FIGURE_WHOLE);
    figure_arrow(&g, px, py, (double)end.x, (double)end.y, FIGURE_RED, 1);
    figure_dot(&g, px, py, 5, FIGURE_RED);
    figure_dot(&g, ox, oy, 4, FIGURE_RED);
    figure_text(&g, ox, oy, -6, 22, FIGURE_LEFT, FIGURE_RED, "*o*");
    figure_text(&g, px, py, -8, -10, FIGURE_RIGHT, FIGURE_RED, "_t_~hit~");
    figure_origin(&g, 556, 62, 1);
    boxes_tree(&g, &x);
    figure_end(&g);
    bvh_free(&b);
}

#endif
