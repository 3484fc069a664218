/* greed_figure.h: where greed fails, drawn: four cubes in the tree of bvh_build by the rule sah, in
 * the best tree there is, and the sums of (14.6) and (14.7) for both.
 *
 *   draw_greed(&o)          14_bvh_greed.svg
 *   draw_greed_on(&g)       the same on any sheet of greed_wide x greed_high
 *   greed_best(item, cut)   the least sum of the areas of all inner boxes, over that of the root,
 *                           of all trees of the four items with one in a leaf         (14.7)
 *       uint32_t cut[]      out: of each set of two items or more, the part that its best tree
 *                           cuts off; bit i: item i
 *
 * Cubes 3 and 4 lie in one place. Both trees are given by cut[set]. The best tree of a set is a
 * best cut of it with the best trees of its two parts, whatever is around it: 2^n sets and 3^n
 * cuts do (dynamic programming over subsets, 动态规划). Leaves of one item cost the same in every
 * tree, so nodes are all that differs.
 */
#ifndef BVH_GREED_FIGURE_H
#define BVH_GREED_FIGURE_H

#include "../../07_mesh/scenes/soup.h"
#include "boxes_figure.h"

enum { greed_wide = 960, greed_high = 496, greed_four = 4, greed_sets = 1 << greed_four,
       greed_all = greed_sets - 1 };

typedef struct {
    figure *g;
    const bvh_item *item;
    const uint32_t *cut;
    double left;                 /* pixels: of the panel */
    double surface[greed_four];  /* of the inner nodes A, B, C */
    int names, leaves;           /* so far */
    double first, nodes;         /* the sums of (14.6), of the root, and (14.7) */
} greed_panel;

/* ---------------------------------------------------------------------------------------------- */

/* Each a triangle that has a unit cube as its box. */
static inline mesh greed_cubes(void)
{
    static const real at[greed_four] = {0, 6, 11, 11};
    mesh m = mesh_room(greed_four);
    for (size_t i = 0; i < greed_four; i++) {
        m.v[3 * i] = vec(at[i], 0, 0), m.v[3 * i + 1] = vec(at[i] + 1, 1, 0);
        m.v[3 * i + 2] = vec(at[i], 0, 1);
    }
    return m;
}

static inline bvh_box greed_box(const bvh_item *item, uint32_t set)
{
    bvh_box box = box_empty();
    for (int i = 0; i < greed_four; i++)
        if (set >> i & 1) box_add(&box, &item[i]);
    return box;
}

static inline double greed_best(const bvh_item *item, uint32_t *cut)
{
    double best[greed_sets] = {0}, area = 0;
    for (uint32_t set = 1; set < greed_sets; set++) {
        const bvh_box box = greed_box(item, set);
        double least = HUGE_VAL;
        area = box_area(&box);
        if (!(set & (set - 1))) continue;  /* one item: a leaf */
        for (uint32_t left = (set - 1) & set; left > (set & ~left); left = (left - 1) & set) {
            double sum = best[left] + best[set & ~left];
            if (sum < least) cut[set] = set & ~left;
            least = fmin(least, sum);
        }
        best[set] = area + least;
    }
    return best[greed_all] / area;
}

/* What bvh_build has cut off node `at`, and below it. Returns the set of its cubes. */
static inline uint32_t greed_cuts(const bvh_mesh *b, uint32_t at, uint32_t *cut)
{
    const bvh_node *n = &b->tree.node[at];
    if (n->count) return (uint32_t)1 << b->triangle[n->first].index;
    uint32_t left = greed_cuts(b, n->first, cut), set = left | greed_cuts(b, n->first + 1, cut);
    cut[set] = left;
    return set;
}

static inline int greed_count(uint32_t set) { return __builtin_popcount(set); }

static inline double greed_surface(const greed_panel *p, uint32_t set)
{
    bvh_box box = greed_box(p->item, set);
    return 2 * box_area(&box);
}

/* Its box among the cubes, a little larger than what is in it. */
static inline void greed_draw_box(greed_panel *p, uint32_t set, int depth, const char *name)
{
    bvh_box box = greed_box(p->item, set);
    double out = (16 - 5.0 * depth) / 33, x0 = (double)box.low[0] - out;
    double x1 = (double)box_high(&box, 0) + out, y0 = -out, y1 = 1 + out;
    double xy[8] = {x0, y0, x1, y0, x1, y1, x0, y1};
    figure_origin(p->g, p->left, 116, 33);
    figure_polygon(p->g, 4, xy, FIGURE_GREY, 0, boxes_colour[depth]);
    if (depth == 0) figure_text(p->g, x1, y1, 0, -6, FIGURE_RIGHT, boxes_colour[0], name);
    if (depth == 1) figure_text(p->g, x0, y0, 0, 22, FIGURE_LEFT, boxes_colour[1], name);
    if (depth == 2) figure_text(p->g, x0, 0.5, -6, 5, FIGURE_RIGHT, boxes_colour[2], name);
}

/* The node of the set in the tree, and all below it. Returns where it stands along x. */
static inline double greed_draw_node(greed_panel *p, uint32_t set, int depth)
{
    static const double column[greed_four] = {40, 148, 256, 364};
    double y = -66.0 * depth, at = 0;
    bool leaf = greed_count(set) == 1;
    char name[2] = {(char)(leaf ? '1' + __builtin_ctz(set) : 'A' + p->names), 0};
    if (leaf) at = column[p->leaves++];
    else {
        double surface = p->surface[p->names++] = greed_surface(p, set), child[2];
        greed_draw_box(p, set, depth, name);
        for (int k = 0; k < 2; k++) {
            uint32_t part = k ? set & ~p->cut[set] : p->cut[set];
            child[k] = greed_draw_node(p, part, depth + 1);
        }
        at = (child[0] + child[1]) / 2;
        figure_origin(p->g, p->left, 196, 1);
        for (int k = 0; k < 2; k++)
            figure_line(p->g, at, y - 14, child[k], y - 52, FIGURE_GREY, 1, FIGURE_WHOLE);
        figure_print(p->g, at, y, 24, 5, FIGURE_LEFT, boxes_colour[depth], "_S_(%s) = %.3g", name,
                     surface);
    }
    figure_origin(p->g, p->left, 196, 1);
    double xy[8] = {at - 17, y - 14, at + 17, y - 14, at + 17, y + 14, at - 17, y + 14};
    figure_polygon(p->g, 4, xy, leaf ? FIGURE_GREY : "white", leaf ? 0.25 : 1,
                   leaf ? FIGURE_GREY : boxes_colour[depth]);
    figure_text(p->g, at, y, 0, 5, FIGURE_MIDDLE, leaf ? FIGURE_BLACK : boxes_colour[depth], name);
    return at;
}

static inline void greed_draw_cubes(const greed_panel *p)
{
    for (int i = 0; i < 3; i++) {
        double x0 = (double)p->item[i].low[0], x1 = (double)box_high(&p->item[i], 0);
        double xy[8] = {x0, 0, x1, 0, x1, 1, x0, 1};
        figure_polygon(p->g, 4, xy, FIGURE_GREY, 0.25, FIGURE_GREY);
        figure_print(p->g, x0 + 0.5, 0.5, 0, 5, FIGURE_MIDDLE, FIGURE_BLACK, "%d%s", i + 1,
                     i < 2 ? "" : ", 4");
    }
}

/* other: what it is compared with, or NULL. */
static inline void greed_draw_panel(greed_panel *p, const greed_panel *other, const char *title)
{
    uint32_t part[2] = {p->cut[greed_all], greed_all & ~p->cut[greed_all]};
    int n[2] = {greed_count(part[0]), greed_count(part[1])};
    double side[2] = {greed_surface(p, part[0]) * n[0], greed_surface(p, part[1]) * n[1]};
    const double *S = p->surface;
    figure_origin(p->g, p->left, 116, 33);
    greed_draw_cubes(p);
    greed_draw_node(p, greed_all, 0);
    p->first = side[0] + side[1], p->nodes = (S[0] + S[1] + S[2]) / S[0];
    figure_origin(p->g, p->left, 0, 1);
    figure_text(p->g, 0, 0, 0, 24, FIGURE_LEFT, FIGURE_BLACK, title);
    figure_print(p->g, 0, 0, 0, 438, FIGURE_LEFT, FIGURE_BLACK, "first cut (14.6):  _S_(%c) · %d + "
                 "_S_(%c) · %d = %.3g + %.3g = %.3g%s", n[0] > 1 ? 'B' : '1', n[0],
                 n[0] > 1 ? 'C' : 'B', n[1], side[0], side[1], p->first,
                 other ? p->first > other->first ? ", dearer" : ", cheaper" : "");
    figure_print(p->g, 0, 0, 0, 461, FIGURE_LEFT, FIGURE_BLACK, "all nodes (14.7):  (%.3g + %.3g + "
                 "%.3g) / %.3g = %.3g%s", S[0], S[1], S[2], S[0], p->nodes,
                 other ? p->nodes > other->nodes ? ", dearer" : ", cheaper" : "");
    if (n[1] > 2)
        figure_print(p->g, 0, 0, 0, 484, FIGURE_LEFT, FIGURE_BLACK, "since of the rays in B only "
                     "%.3g / %.3g reach C (14.5)", S[2], S[1]);
}

static inline void draw_greed_on(figure *g)
{
    uint32_t cut[2][greed_sets] = {{0}};
    mesh m = greed_cubes();
    bvh_item item[greed_four];
    items all = items_of_mesh(&m);
    bvh b;
    failure f;
    if (!bvh_build(&all, bvh_leaves(1, 0.3), &b, &f)) fail(f);
    for (size_t i = 0; i < greed_four; i++) (void)triangle_item(&m, i, &item[i]);
    (void)greed_cuts(&b.mesh, 0, cut[0]);
    (void)greed_best(item, cut[1]);
    greed_panel greedy = {.g = g, .item = item, .cut = cut[0], .left = 25};
    greed_panel best = {.g = g, .item = item, .cut = cut[1], .left = 505};
    greed_draw_panel(&greedy, NULL, "Greedy: at each node the cheapest cut");
    greed_draw_panel(&best, &greedy, "The best of all 15 trees");
    bvh_free(&b), mesh_free(&m);
}

cold_inline void draw_greed(const options *o)
{
    figure g = figure_begin(o, "14_bvh_greed.svg", greed_wide, greed_high);
    draw_greed_on(&g);
    figure_end(&g);
}

#endif
