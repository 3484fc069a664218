/* flat_figure.h: the BSP tree of segments in the plane, and the two orders it gives.
 *
 *   bool draw_flat(threads, &im)   left: the cells that a ray (red) passes, numbered front to back;
 *                                  right: the pieces of the segments, numbered back to front as the
 *                                  painter draws them for an eye (red)
 *
 * The segments are the feet of upright walls (puzzles.h), the tree is that of painter.h, seen from
 * above. Thin lines are where its planes cut the cells.
 */
#ifndef BSP_FLAT_FIGURE_H
#define BSP_FLAT_FIGURE_H

#include "../../../common/image.h"
#include "../../../common/parallel.h"
#include "../painter.h"
#include "puzzles.h"

enum { flat_most = 64 };

typedef struct { real x, y; int number; } bsp_label;
typedef struct {
    const painter *p;
    image *im;
    bool painting;             /* the right panel */
    vec3 from, to;             /* the ray; the eye is `from` */
    uint32_t rank[4096];       /* of a cell: when the ray passes it; of a piece: when drawn */
    bsp_label label[flat_most];
    int labels;
    struct { vec3 a, b; uint32_t piece; } foot[flat_most];
    int feet;
} bsp_flat;

/* ---------------------------------------------------------------------------------------------- */

/* Number of the cell: 2 node + side of the last plane. */
static inline uint32_t flat_cell(const painter *p, vec3 q)
{
    q = vsub(q, p->middle);
    for (uint32_t at = 0;;) {
        const painter_node *n = &p->node[at];
        bool front = side_of(&n->p, q) > 0;
        uint32_t next = front ? n->front : n->back;
        if (next == UINT32_MAX) return 2 * at + front;
        at = next;
    }
}

/* The foot of piece k: its two corners in z = 0; false: it has none. */
static inline bool flat_foot(const painter *p, uint32_t k, vec3 *a, vec3 *b)
{
    const painter_piece *x = &p->piece[k];
    int found = 0;
    for (uint32_t i = 0; i < x->corners; i++) {
        vec3 q = vadd(p->corner[x->first + i], p->middle);
        if (fabs(q.z) < (real)1e-5) *(found++ ? b : a) = q;
    }
    return found == 2;
}

static inline real segment_distance(vec3 a, vec3 b, real x, real y)
{
    vec3 e = vsub(b, a), p = {x - a.x, y - a.y, 0};
    real w = real_clamp(vdot(p, e) / vdot(e, e), 0, 1);
    p = vsub(p, vscale(e, w));
    return sqrt(vdot(p, p));
}

/* 3 x 5 dots each, row by row. */
static inline bool digit_dot(int digit, int x, int y)
{
    static const char *const dots[10] = {
        "111101101101111", "010110010010111", "111001111100111", "111001111001111",
        "101101111001001", "111100111001111", "111100111101111", "111001001001001",
        "111101111101111", "111101111001111"};
    return x >= 0 && x < 3 && y >= 0 && y < 5 && dots[digit][3 * y + x] == '1';
}

/* Dots of 0.085 of the plane's units. */
static inline bool label_covers(const bsp_label *l, real x, real y)
{
    real dot = 0.085, w = l->number < 10 ? 3 : 7;
    real u = (x - l->x) / dot + w / 2, v = (l->y - y) / dot + (real)2.5;
    if (u < 0 || v < 0 || v >= 5) return false;
    int i = (int)u, tens = l->number / 10;
    if (!tens) return digit_dot(l->number, i, (int)v);
    return i < 3 ? digit_dot(tens, i, (int)v) : digit_dot(l->number % 10, i - 4, (int)v);
}

static inline vec3 flat_mix(vec3 a, vec3 b, real t) { return vmadd(vscale(a, 1 - t), b, t); }

static inline vec3 flat_colour(const bsp_flat *f, real x, real y)
{
    const vec3 black = {0, 0, 0}, red = {0.75, 0.05, 0.02};
    const vec3 blue = {0.05, 0.3, 0.7}, pale = {0.9, 0.9, 0.88};
    vec3 at = {x, y, 0}, c = pale;
    uint32_t cell = flat_cell(f->p, at), last = (uint32_t)f->labels;
    if (!f->painting && f->rank[cell])
        c = flat_mix(vscale(blue, 1.1), (vec3){1, 1, 1},
                     (real)0.25 + (real)0.6 * (real)f->rank[cell] / (real)last);
    for (int k = 0; k < 4; k++) {
        vec3 near = {x + (k == 0 ? (real)0.022 : k == 1 ? -(real)0.022 : 0),
                     y + (k == 2 ? (real)0.022 : k == 3 ? -(real)0.022 : 0), 0};
        if (flat_cell(f->p, near) != cell) c = vec(0.45, 0.45, 0.45);
    }
    for (int k = 0; k < f->feet; k++) {
        vec3 a = f->foot[k].a, b = f->foot[k].b;
        if (segment_distance(a, b, x, y) > (real)0.07) continue;
        c = black;
        if (f->painting)
            c = flat_mix(vec(0, 0.03, 0.25), vec(0.9, 0.3, 0),
                         (real)f->rank[f->foot[k].piece] / (real)last);
        real ends = real_min(hypot(x - a.x, y - a.y), hypot(x - b.x, y - b.y));
        if (ends < (real)0.06) c = black;
    }
    if (!f->painting && segment_distance(f->from, f->to, x, y) < (real)0.03) c = red;
    if (hypot(x - f->from.x, y - f->from.y) < (real)0.16) c = red;
    for (int k = 0; k < f->labels; k++)
        if (label_covers(&f->label[k], x, y)) c = black;
    return c;
}

static inline void flat_pixel(int x, int y, void *context)
{
    const bsp_flat *f = context;
    vec3 sum = {0, 0, 0};
    for (int k = 0; k < 9; k++) {
        real u = ((real)x + ((real)(k % 3) + (real)0.5) / 3) / (real)f->im->width;
        real v = ((real)y + ((real)(k / 3) + (real)0.5) / 3) / (real)f->im->height;
        sum = vmadd(sum, flat_colour(f, 10 * u, 10 * (1 - v)), (real)1 / 9);
    }
    image_set(f->im, x, y, sum);
}

/* Walks along the ray in small steps; a label in the middle of each cell's part. */
static inline void flat_along_ray(bsp_flat *f)
{
    enum { steps = 4000 };
    uint32_t before = UINT32_MAX;
    int began = 0;
    vec3 d = vsub(f->to, f->from), across = vunit((vec3){-d.y, d.x, 0});
    for (int i = 0; i <= steps; i++) {
        uint32_t now = flat_cell(f->p, vmadd(f->from, d, (real)i / steps));
        if ((now != before || i == steps) && f->labels < flat_most) {
            if (i > 0) {
                vec3 q = vmadd(vmadd(f->from, d, (real)(began + i) / (2 * steps)), across,
                               0.36);
                f->label[f->labels] = (bsp_label){q.x, q.y, f->labels + 1};
                f->rank[before] = (uint32_t)++f->labels;
            }
            began = i, before = now;
        }
    }
}

static inline void flat_for_eye(bsp_flat *f)
{
    uint32_t *order = allocate(f->p->pieces, sizeof *order);
    size_t n = painter_order(f->p, f->from, order);
    for (size_t i = 0; i < n && f->labels < flat_most; i++) {
        vec3 a, b;
        if (!flat_foot(f->p, order[i], &a, &b)) continue;
        vec3 e = vunit(vsub(b, a)), q = vscale(vadd(a, b), 0.5);
        q = vadd(q, vscale((vec3){-e.y, e.x, 0}, e.x < 0 ? -(real)0.36 : (real)0.36));
        f->label[f->labels] = (bsp_label){q.x, q.y, f->labels + 1};
        f->rank[order[i]] = (uint32_t)++f->labels;
    }
    free(order);
}

static inline bool draw_flat(int threads, image *all)
{
    mesh m = segments_mesh(10, 7);
    painter p;
    failure f;
    bool whole = true;
    painter_options how = painter_defaults;
    how.candidates = 2;
    if (!painter_build(&m, how, &p, &f)) fail(f);
    for (int k = 0; k < 2; k++) {
        image im = image_new((all->width - 8) / 2, all->height);
        bsp_flat *g = allocate(1, sizeof *g);
        *g = (bsp_flat){.p = &p, .im = &im, .painting = k == 1};
        g->from = k ? vec(8.6, 0.6, 0) : vec(0.4, 4.6, 0);
        g->to = vec(9.9, 6.2, 0);
        for (uint32_t i = 0; i < p.pieces && g->feet < flat_most; i++)
            if (flat_foot(&p, i, &g->foot[g->feet].a, &g->foot[g->feet].b))
                g->foot[g->feet++].piece = i;
        if (k) flat_for_eye(g);
        else flat_along_ray(g);
        whole = parallel_pixels(im.width, im.height, threads, "plane", flat_pixel, g) && whole;
        image_place(all, k * (im.width + 8), 0, &im);
        image_free(&im);
        free(g);
    }
    painter_free(&p);
    mesh_free(&m);
    return whole;
}

#endif
