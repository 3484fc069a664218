/* tree_figure.h: the drawing of this chapter: one sample of one pixel of the Cornell box, seen from
 * the side, three bounces, with N = 1, 2 and 4 directions at each hit: the rays that branching.h
 * really traces.
 *
 *   draw_tree(&o, x, y);      25_bounces_tree.svg, for the pixel (x, y) of 480 x 480; with --tree
 *                             (o->own) into build/quick/, and the rays of each bounce as text
 */
#ifndef BOUNCES_TREE_FIGURE_H
#define BOUNCES_TREE_FIGURE_H

#include "../../../common/lab/figure.h"
#include "../../24_direct_light/scenes/lit_cornell.h"
#include "../branching.h"

enum { tree_side = 480, tree_depth = 3 };
static const char *const tree_colour[tree_depth + 1] = {FIGURE_BLACK, FIGURE_BLUE, FIGURE_GREEN,
                                                        FIGURE_PURPLE};

/* ---------------------------------------------------------------------------------------------- */

/* The walls, the lamp, and the two blocks behind the rays; the eye looks in from the left. */
static inline void tree_room(figure *g)
{
    static const double block[2][3] = {{65, 272, 165}, {247, 456, 330}};  /* z, z, height */
    for (int k = 0; k < 2; k++) {
        const double *b = block[k];
        double corner[8] = {b[0], 0, b[1], 0, b[1], b[2], b[0], b[2]};
        figure_polygon(g, 4, corner, FIGURE_GREY, 0.12, NULL);
    }
    figure_line(g, 0, 0, 559, 0, FIGURE_GREY, 3, FIGURE_WHOLE);
    figure_line(g, 559, 0, 559, 549, FIGURE_GREY, 3, FIGURE_WHOLE);
    figure_line(g, 0, 549, 559, 549, FIGURE_GREY, 3, FIGURE_WHOLE);
    figure_line(g, 227, 545, 332, 545, FIGURE_ORANGE, 6, FIGURE_WHOLE);
}

typedef struct { figure *g; int N, lit; } tree_seen;

/* From where the ray begins to what it meets; what leaves the room is cut short, and dashed. */
static inline void tree_ray(void *user, ray r, int k, const lit_hit *x, vec3 brought)
{
    tree_seen *seen = user;
    figure *g = seen->g;
    int N = seen->N;
    double z0 = (double)r.o.z, y0 = (double)r.o.y;
    double z1 = (double)(x->m ? x->s.p.z : r.o.z + 150 * r.d.z);
    double y1 = (double)(x->m ? x->s.p.y : r.o.y + 150 * r.d.y);
    double width = N == 1 ? 2.2 : k < 2 ? 2 : N == 2 || k == 2 ? 1.3 : 0.7;
    if (k == 0) {                              /* of the eye ray, the end */
        double part = (z1 + 150) / (z1 - z0);
        z0 = z1 + (z0 - z1) * part, y0 = y1 + (y0 - y1) * part;
    }
    figure_line(g, z0, y0, z1, y1, tree_colour[k], width, x->m ? FIGURE_WHOLE : FIGURE_DASHED);
    if (!x->m) return;
    figure_dot(g, z1, y1, k < 3 ? 3 : 2, tree_colour[k]);
    if (!vzero(brought)) figure_dot(g, z1, y1, 6, FIGURE_RED), seen->lit++;
    if (N == 1) {
        bool right = z1 > 550;  /* beyond the rear wall */
        figure_print(g, z1, y1, right ? 8 : -9, -6, right ? FIGURE_LEFT : FIGURE_RIGHT,
                     tree_colour[k], "*x*~%d~", k);
    }
}

/* One panel; says how many rays there are of each bounce. */
static inline void tree_panel(figure *g, const options *o, const naive_path *p, int N,
                              uint64_t pixel)
{
    ray eye = camera_ray(cornell_camera(1), (real)(pixel % tree_side) + (real)0.5,
                         (real)(pixel / tree_side) + (real)0.5, tree_side, tree_side);
    naive_counts c = {{0}, 0, 0};
    tree_seen seen = {g, N, 0};
    branching w = {p, N, o->seed, pixel, 0, &c, tree_ray, &seen};
    char rays[96], met[96];
    tree_room(g);
    (void)branching_trace(&w, eye);
    snprintf(rays, sizeof rays, "= %d: %zu + %zu + %zu + %zu rays", N, c.rays[0], c.rays[1],
             c.rays[2], c.rays[3]);
    snprintf(met, sizeof met, "%d met the lamp, %zu left the room", seen.lit, c.escaped);
    figure_print(g, 220, 0, 0, 32, FIGURE_MIDDLE, FIGURE_BLACK, "_N_ %s", rays);
    figure_text(g, 220, 0, 0, 52, FIGURE_MIDDLE, FIGURE_GREY, met);
    if (o->own) printf("N %s; %s\n", rays, met);
}

cold_inline void draw_tree(const options *o, int x, int y)
{
    lit_scene s;
    lit_cornell(&s);
    naive_path p = {&s, DIRECTIONS_BRDF, tree_depth, false};
    options where = *o;
    if (o->own) where.own = false, where.quick = true;
    figure g = figure_begin(&where, "25_bounces_tree.svg", 1040, 330);
    for (int k = 0; k < 3; k++) {
        figure_origin(&g, 80 + 345 * k, 265, 0.44);
        tree_panel(&g, o, &p, 1 << k, (uint64_t)y * tree_side + (uint64_t)x);
    }
    figure_end(&g);
    lit_free(&s);
}

#endif
