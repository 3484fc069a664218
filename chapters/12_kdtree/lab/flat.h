/* flat.h: the k-d tree in the plane, as a picture: cells, a ray, and the cells that it visits.
 *
 *   draw_flat(o)     left: cut in the middle; right: by the surface area heuristic
 *
 * Walls seen from above (black) in a tree of the same builder: they are upright polygons, and all
 * rays run level. Grey lines are planes, the first ones thick. The ray comes from below; cells
 * are coloured in the order in which it visits them, from yellow to violet, until the one whose
 * begin lies behind the hit (black dot).
 *
 * For cuts in the middle the walls are low, so that no plane lies across z. For the heuristic they
 * are high: then only the walls of a cell count, and area stands for its outline in the plane.
 */
#ifndef KDTREE_FLAT_H
#define KDTREE_FLAT_H

#include "../../../common/output.h"
#include "../../../common/parallel.h"
#include "../kdtree.h"

enum { flat_panel = 440, flat_gap = 12, flat_walls = 34, flat_most_cells = 64 };

typedef struct {
    kdtree t;
    vec3 corner[flat_walls][4];
    shape wall[flat_walls];
    scene world;
    ray r;
    hit h;
    uint32_t cell[flat_most_cells];  /* leaves, in the order of visits */
    int cells;
} kdtree_flat;

typedef struct { const kdtree_flat *panel[2]; image *im; } kdtree_flat_picture;

/* ---------------------------------------------------------------------------------------------- */

/* Ends of wall i in [0,10]^2: a round house, a small one full of pillars, two long walls. */
static inline void flat_ends(int i, real end[4])
{
    real x = 7.1, y = 6.9, radius = 1.7;
    if (i >= 16) x = (real)(i % 4) * (real)0.42 + (real)1.2, y = (real)(i / 4) * (real)0.42;
    if (i < 16)
        for (int k = 0; k < 2; k++) {
            real a = 2 * pi * (real)(i + k) / 16;
            end[2 * k] = x + radius * cos(a), end[2 * k + 1] = y + radius * sin(a);
        }
    else if (i < 32) {
        real a = (real)i;
        end[0] = x, end[1] = y - (real)0.6;
        end[2] = x + (real)0.22 * cos(a), end[3] = y - (real)0.6 + (real)0.22 * sin(a);
    } else {
        end[0] = i == 32 ? (real)0.4 : (real)4.2, end[1] = i == 32 ? (real)9.3 : (real)0.7;
        end[2] = i == 32 ? (real)4.9 : (real)9.5, end[3] = i == 32 ? (real)7.6 : (real)1.3;
    }
}

static inline void flat_walls_of(kdtree_flat *f, real height)
{
    for (int i = 0; i < flat_walls; i++) {
        real e[4];
        vec3 *c = f->corner[i];
        flat_ends(i, e);
        c[0] = (vec3){e[0], e[1], 0}, c[1] = (vec3){e[2], e[3], 0};
        c[2] = (vec3){e[2], e[3], height}, c[3] = (vec3){e[0], e[1], height};
        f->wall[i] = shape_of_polygon(polygon_of(c, 4));
    }
    f->world = (scene){f->wall, flat_walls};
}

/* The leaves whose cells the part [enter, exit] of the ray passes, in order, up to the hit. */
static inline void flat_visit(kdtree_flat *f, uint32_t at, real enter, real exit)
{
    kd_node n = f->t.node[at];
    if (enter > exit || enter > f->h.t) return;
    if (kd_is_leaf(n)) {
        if (f->cells < flat_most_cells) f->cell[f->cells++] = at;
        return;
    }
    int k = kd_axis(n);
    real t = ((real)n.plane - vaxis(f->r.o, k)) / vaxis(f->r.d, k);
    uint32_t below = kd_lower(n), near = vaxis(f->r.d, k) > 0 ? below : below + 1;
    flat_visit(f, near, enter, real_min(t, exit));
    flat_visit(f, near ^ 1, real_max(t, enter), exit);
}

static inline void flat_init(kdtree_flat *f, kdtree_strategy strategy, real height)
{
    kdtree_options how = kdtree_defaults;
    failure why;
    *f = (kdtree_flat){.h = hit_none};
    how.strategy = strategy, how.leaf = 2, how.item_cost = 2;
    flat_walls_of(f, height);
    items x = items_of_scene(&f->world);
    if (!kdtree_build(&x, how, &f->t, &why)) fail(why);
    f->r = ray_from(vec(0.45, 0.2, height / 2), vec(1, 0.775, 0));
    f->r.d = vunit(f->r.d);
    kdtree_hit(&f->t, f->r, &f->h);
    flat_visit(f, 0, 0, 20);
}

/* ---------------------------------------------------------------------------------------------- */

/* Is (x, y) nearer to the segment than `far`? Most are beside its box. */
static inline bool flat_near(real x, real y, const real e[4], real far)
{
    if (x < real_min(e[0], e[2]) - far || x > real_max(e[0], e[2]) + far) return false;
    if (y < real_min(e[1], e[3]) - far || y > real_max(e[1], e[3]) + far) return false;
    real dx = e[2] - e[0], dy = e[3] - e[1], px = x - e[0], py = y - e[1];
    real s = real_clamp((px * dx + py * dy) / (dx * dx + dy * dy), 0, 1);
    return sqrt((px - s * dx) * (px - s * dx) + (py - s * dy) * (py - s * dy)) < far;
}

static inline vec3 flat_rank(int i, int n)
{
    real s = n > 1 ? (real)i / (real)(n - 1) : 0;
    vec3 first = {1, 0.85, 0.25}, last = {0.45, 0.3, 0.8};
    return vmadd(vscale(first, 1 - s), last, s);
}

static inline vec3 flat_colour(const kdtree_flat *f, real x, real y)
{
    vec3 c = {1, 1, 1}, grey = {0.25, 0.3, 0.35}, black = {0, 0, 0};
    uint32_t at = 0;
    const kd_box *b = &f->t.box;
    if (x < (real)b->lo[0] || x > (real)b->hi[0] || y < (real)b->lo[1] || y > (real)b->hi[1])
        return c;
    bool line = false;
    for (int depth = 0; !kd_is_leaf(f->t.node[at]); depth++) {
        kd_node n = f->t.node[at];
        real off = (kd_axis(n) ? y : x) - (real)n.plane;
        line = line || fabs(off) < (real)0.05 / (1 + (real)depth / 2);
        at = kd_lower(n) + (off > 0);
    }
    for (int i = 0; i < f->cells; i++)
        if (f->cell[i] == at) c = flat_rank(i, f->cells);
    if (line) c = vadd(vscale(c, 0.4), vscale(grey, 0.6));
    vec3 end = ray_at(f->r, f->h.shape == no_shape ? 10 : f->h.t);
    real way[4] = {f->r.o.x, f->r.o.y, end.x, end.y};
    if (flat_near(x, y, way, (real)0.035)) c = vec(0.8, 0, 0);
    for (int i = 0; i < flat_walls; i++) {
        vec3 one = f->corner[i][0], two = f->corner[i][1];
        real e[4] = {one.x, one.y, two.x, two.y};
        if (flat_near(x, y, e, (real)0.045)) c = black;
    }
    real dot = (x - end.x) * (x - end.x) + (y - end.y) * (y - end.y);
    return f->h.shape != no_shape && dot < (real)0.015 ? black : c;
}

static inline void flat_pixel(int x, int y, void *context)
{
    const kdtree_flat_picture *p = context;
    int panel = x / (flat_panel + flat_gap), left = x - panel * (flat_panel + flat_gap);
    vec3 sum = {0, 0, 0};
    for (int i = 0; i < 16; i++) {
        real u = ((real)left + (real)(1 + 2 * (i % 4)) / 8) / (real)flat_panel;
        real v = ((real)y + (real)(1 + 2 * (i / 4)) / 8) / (real)flat_panel;
        vec3 c = {1, 1, 1};
        if (u < 1) c = flat_colour(p->panel[panel], 10 * u, 10 * (1 - v));
        sum = vmadd(sum, c, (real)1 / 16);
    }
    image_set(p->im, x, y, sum);
}

static inline void draw_flat(const options *o)
{
    static kdtree_flat middle, sah;
    image im = image_new(2 * flat_panel + flat_gap, flat_panel);
    flat_init(&middle, KD_MIDDLE, 1e-3), flat_init(&sah, KD_SAH, 1000);
    kdtree_flat_picture p = {{&middle, &sah}, &im};
    bool whole = parallel_pixels(im.width, im.height, o->threads, "flat", flat_pixel, &p);
    printf("# in the plane: the ray passes %d cells cut in the middle, %d by SAH\n", middle.cells,
           sah.cells);
    output_picture(o, &im, "12_kdtree_flat.png", false, whole);
    kdtree_free(&middle.t), kdtree_free(&sah.t);
    image_free(&im);
}

#endif
