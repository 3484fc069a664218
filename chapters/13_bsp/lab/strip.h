/* strip.h: the same walls and the same ray in a quadtree, a k-d tree and a BSP tree.
 *
 *   draw_strip(o)      images/13_bsp_strip.svg
 *
 * The trees are those of 11, 12 and this chapter, their cells those that the builders made; walls,
 * ray and drawing: 09_aabb/trials/plane.h. An octree of low walls is a quadtree in its lowest
 * layer. The other two get high walls, so that no plane lies across z.
 */
#ifndef BSP_STRIP_H
#define BSP_STRIP_H

#include "../../09_aabb/trials/plane.h"
#include "../../11_octree/octree.h"
#include "../../12_kdtree/kdtree.h"
#include "../bsp.h"

enum { strip_depth = 5, strip_leaf = 4 };  /* two triangles a wall */

/* ---------------------------------------------------------------------------------------------- */

static inline void strip_square(plane_tree *p, vec3 lo, vec3 hi, bool full)
{
    const vec3 q[4] = {lo, {hi.x, lo.y, 0}, hi, {lo.x, hi.y, 0}};
    plane_add(p, q, 4, full);
}

static inline void strip_octree(plane_tree *p, const octree *t, uint32_t node, octree_cell c)
{
    octree_node n = t->node[node];
    aabb b = octree_cell_box(t, c);
    if (!n.kind || (n.kind & octree_is_leaf)) {
        strip_square(p, b.lo, b.hi, n.kind & ~octree_is_leaf);
        return;
    }
    for (unsigned k = 0; k < 4; k++) strip_octree(p, t, n.first + k, octree_child_cell(c, k));
}

static inline void strip_kdtree(plane_tree *p, const kdtree *t, uint32_t at, vec3 lo, vec3 hi)
{
    kd_node n = t->node[at];
    if (kd_is_leaf(n)) {
        strip_square(p, lo, hi, kd_count(n) > 0);
        return;
    }
    strip_kdtree(p, t, kd_lower(n), lo, vwith(hi, kd_axis(n), (real)n.plane));
    strip_kdtree(p, t, kd_lower(n) + 1, vwith(lo, kd_axis(n), (real)n.plane), hi);
}

/* q: n corners of the cell, relative to the middle of the tree. */
static inline void strip_bsp(plane_tree *p, const bsp *b, uint32_t at, const vec3 *q, size_t n)
{
    bsp_node x = b->node[at];
    vec3 part[2 * plane_corners] = {{0, 0, 0}};
    if (x.kind & bsp_leaf_bit) {
        for (size_t i = 0; i < n; i++) part[i] = vadd(q[i], b->middle);
        if (n >= 3) plane_add(p, part, (int)n, x.kind != bsp_leaf_bit);
        return;
    }
    split_plane s = plane_of_axis((int)x.kind & 3, x.at);
    if (x.kind & bsp_slanted_bit) s = (split_plane){b->normal[x.kind ^ bsp_slanted_bit], x.at, 3};
    for (uint32_t side = 0; side < 2 && n <= plane_corners; side++)
        strip_bsp(p, b, x.first + side, part, clip(&s, side ? -1 : 1, 0, q, n, part));
}

static inline void strip_panel(figure *g, plane_tree *p, const mesh *m, int panel,
                               const char *name)
{
    int asked = 0;
    plane_order(p);
    for (int i = 0; i < p->cells; i++) asked += p->cell[i].rank && p->cell[i].full;
    figure_origin(g, 10 + 320 * panel, 340, 30);
    plane_draw(g, p, m);
    figure_text(g, 5, 0, 0, -316, FIGURE_MIDDLE, FIGURE_BLACK, name);
    figure_print(g, 5, 0, 0, 22, FIGURE_MIDDLE, FIGURE_BLACK, "%d cells; %d passed, %d asked",
                 p->cells, p->passed, asked);
}

cold_inline void draw_strip(const options *o)
{
    figure g = figure_begin(o, "13_bsp_strip.svg", 960, 380);
    mesh low = plane_walls(0x1p-12), high = plane_walls(1000);
    items flat = items_of_mesh(&low), x = items_of_mesh(&high);
    octree_options oct = octree_defaults;
    kdtree_options kd = kdtree_defaults;
    bsp_options how = bsp_defaults;
    static plane_tree p[3];
    octree t;
    kdtree u;
    bsp b;
    failure f;
    oct.leaf = strip_leaf, oct.depth = strip_depth;
    kd.item_cost = 2, kd.depth = strip_depth;
    how.axis_cost = how.slanted_cost = 0.5, how.candidates = 200, how.depth = strip_depth;
    if (!octree_build(&flat, oct, &t, &f) || !kdtree_build(&x, kd, &u, &f)
        || !bsp_build(&x, how, &b, &f)) fail(f);
    for (int k = 0; k < 3; k++) p[k].r = plane_ray(k ? 1000 : 0x1p-12), p[k].h = hit_none;
    octree_hit(&t, p[0].r, &p[0].h), kdtree_hit(&u, p[1].r, &p[1].h), bsp_hit(&b, p[2].r, &p[2].h);
    strip_octree(&p[0], &t, 0, (octree_cell){0, 0, 0, 0});
    vec3 lo = b.all.lo, hi = b.all.hi;
    strip_kdtree(&p[1], &u, 0, lo, hi);
    vec3 q[4] = {lo, {hi.x, lo.y, 0}, hi, {lo.x, hi.y, 0}};
    for (int i = 0; i < 4; i++) q[i] = vmul(vsub(q[i], b.middle), (vec3){1, 1, 0});
    strip_bsp(&p[2], &b, 0, q, 4);
    strip_panel(&g, &p[0], &low, 0, "quadtree"), strip_panel(&g, &p[1], &high, 1, "k-d tree");
    strip_panel(&g, &p[2], &high, 2, "BSP tree");
    figure_end(&g);
    octree_free(&t), kdtree_free(&u), bsp_free(&b), mesh_free(&low), mesh_free(&high);
}

#endif
