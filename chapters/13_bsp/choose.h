/* choose.h: which plane cuts a cell. Everything else about a BSP tree follows from this.
 *
 *   BSP_RANDOM   the plane of an item drawn at random (auto-partition, 自动剖分)
 *   BSP_FEWEST   of some drawn at random, the one whose plane cuts the fewest others; at equal
 *                numbers, the one that halves them best
 *   BSP_AXIS     planes across the axes, by cost: a k-d tree
 *   BSP_OWN      planes of triangles and planes through their edges, by cost
 *   BSP_COST     all of these, by cost
 *
 * Cost, where testing an item costs 1 and the step at a plane k (dearer if it is slanted):
 *
 *   cut:   C = k + A_back / A n_back + A_front / A n_front       areas as in (13.2)      (13.4)
 *   leaf:  C = n
 *
 * The plane with the smallest C is taken, if that is less than n. The cell pays for what it leaves
 * empty: a slanted plane can lie right on a slanted wall, and one across an axis cannot. Planes
 * across the axes are tried where fragments begin and end (of up to 512 of them), by the area of
 * the box around the cell; the best of each axis then meets the slanted ones on equal terms.
 *
 * Sources: Fuchs, Kedem, Naylor 1980 (see side.h): auto-partition, fewest cuts; M. Paterson,
 * F. Yao, "Efficient Binary Space Partitions for Hidden-Surface Removal and Solid Modeling",
 * Discrete & Computational Geometry 5, 1990: random order; J. MacDonald, K. Booth, "Heuristics for
 * Ray Tracing Using Space Subdivision", The Visual Computer 6, 1990: the cost; Ize, Wald, Parker
 * 2008 (see cell.h): slanted planes by cost, planes through edges; R. Kammaje, B. Mora, "A Study of
 * Restricted BSP Trees for Ray Tracing", IEEE Symposium on Interactive Ray Tracing 2007.
 */
#ifndef BSP_CHOOSE_H
#define BSP_CHOOSE_H

#include "fragment.h"
#include "../../common/random.h"

typedef enum { BSP_RANDOM, BSP_FEWEST, BSP_AXIS, BSP_OWN, BSP_COST, bsp_rules } bsp_rule;

typedef struct {
    bsp_rule rule;
    bsp_sides sides;
    int candidates, leaf, depth;
    double axis_cost, slanted_cost;
    uint64_t seed;
    size_t most_bytes;
} bsp_options;

typedef struct { size_t begin, end; } fragment_range_of;  /* in the workshop */

/* What a plane would do. */
typedef struct {
    split_plane p;
    size_t chosen;         /* the fragment whose own plane it is; SIZE_MAX: of none */
    size_t back, front, on, cut;  /* fragments; `cut` are in back and in front, too */
    bool on_front;         /* those on the plane go to the front, else to the back */
    double cost;
} plane_choice;

typedef struct {
    workshop w;
    cell_store cells;
    bsp_options how;
    random_stream g;
} chooser;

/* ---------------------------------------------------------------------------------------------- */

enum { sweep_most = 512 };

static inline bool rule_by_cost(bsp_rule r) { return r >= BSP_AXIS; }

static inline void count_sides(const chooser *b, fragment_range_of all, plane_choice *c)
{
    c->back = c->front = c->on = c->cut = 0;
    for (size_t i = all.begin; i < all.end; i++) {
        plane_side s = fragment_side(&b->w, &c->p, &b->w.f[i]);
        c->back += s & 1, c->front += s >> 1, c->on += s == SIDE_ON, c->cut += s == SIDE_BOTH;
    }
}

/* (13.4). A part as large as the whole: the plane runs along the cell's side, and cuts nothing. */
static inline void cost_of(const chooser *b, fragment_range_of all, convex c, plane_choice *x)
{
    real back, front, area = cell_area(&b->cells, c);
    count_sides(b, all, x);
    cell_areas(&b->cells, c, &x->p, &back, &front);
    x->cost = HUGE_VAL;
    if (!(area > 0) || back > area * (real)0.9999 || front > area * (real)0.9999) return;
    x->on_front = front < back;
    double pb = (double)(back / area), pf = (double)(front / area), on = (double)x->on;
    x->cost = (x->p.axis < 3 ? b->how.axis_cost : b->how.slanted_cost) + pb * (double)x->back
              + pf * (double)x->front + on * (x->on_front ? pf : pb);
}

/* ---- planes across the axes ---- */

static inline void sort_reals(real *x, size_t n)  /* Shell's, gaps by M. Ciura, 2001 */
{
    static const size_t gaps[] = {701, 301, 132, 57, 23, 10, 4, 1};
    for (size_t k = 0; k < sizeof gaps / sizeof *gaps; k++)
        for (size_t i = gaps[k], h = gaps[k]; i < n; i++) {
            real v = x[i];
            size_t j = i;
            for (; j >= h && x[j - h] > v; j -= h) x[j] = x[j - h];
            x[j] = v;
        }
}

/* Where fragments begin and end on each axis, sorted; of sweep_most of them, if there are more. */
typedef struct { real lo[3][sweep_most], hi[3][sweep_most]; size_t n; } axis_sweep;

static inline void sweep_of(const chooser *b, fragment_range_of all, axis_sweep *s)
{
    size_t n = all.end - all.begin;
    s->n = n < sweep_most ? n : sweep_most;
    for (size_t i = 0; i < s->n; i++) {
        const fragment *f = &b->w.f[all.begin + i * n / s->n];
        const vec3 *q = b->w.corner + f->corner;
        vec3 lo = q[0], hi = q[0];
        for (size_t j = 1; j < (f->corners ? f->corners : 2); j++)
            lo = vmin(q[j], lo), hi = vmax(q[j], hi);
        for (int k = 0; k < 3; k++) s->lo[k][i] = vaxis(lo, k), s->hi[k][i] = vaxis(hi, k);
    }
    for (int k = 0; k < 3; k++) sort_reals(s->lo[k], s->n), sort_reals(s->hi[k], s->n);
}

/* The best place on one axis by the area of the box lo, hi; false: none lies inside. */
static inline bool sweep_axis(const axis_sweep *s, int k, vec3 lo, vec3 hi, real *at)
{
    real a = vaxis(lo, k), b = vaxis(hi, k), best = real_infinity;
    real x = vaxis(hi, (k + 1) % 3) - vaxis(lo, (k + 1) % 3);
    real y = vaxis(hi, (k + 2) % 3) - vaxis(lo, (k + 2) % 3);
    size_t i = 0, j = 0;
    while (i < s->n || j < s->n) {  /* merges the two lists; before `v`: i began, j ended */
        real v = j < s->n && (i == s->n || s->hi[k][j] <= s->lo[k][i]) ? s->hi[k][j] : s->lo[k][i];
        size_t began = i;
        while (j < s->n && s->hi[k][j] <= v) j++;
        if (v > a && v < b) {
            real cost = (x * y + (x + y) * (v - a)) * (real)began
                        + (x * y + (x + y) * (b - v)) * (real)(s->n - j);
            if (cost < best) best = cost, *at = v;
        }
        while (i < s->n && s->lo[k][i] <= v) i++;
    }
    return best < real_infinity;
}

static inline void take_cheaper(plane_choice *best, const plane_choice *x)
{
    if (x->cost < best->cost) *best = *x;
}

static inline void choose_across_axes(const chooser *b, fragment_range_of all, convex c,
                                      plane_choice *best)
{
    axis_sweep s;
    vec3 lo, hi;
    real at = 0;
    sweep_of(b, all, &s);
    cell_box_of(&b->cells, c, &lo, &hi);
    for (int k = 0; k < 3; k++) {
        if (!sweep_axis(&s, k, lo, hi, &at)) continue;
        plane_choice x = {.p = plane_of_axis(k, at), .chosen = SIZE_MAX};
        cost_of(b, all, c, &x);
        take_cheaper(best, &x);
    }
}

/* ---- planes of items ---- */

/* All planes of few fragments, else some drawn at random: every other one a triangle's own. */
static inline void choose_slanted(chooser *b, fragment_range_of all, convex c, plane_choice *best)
{
    size_t n = all.end - all.begin, tries = (size_t)b->how.candidates;
    bool every = 4 * n <= tries;
    if (every) tries = 4 * n;
    for (size_t k = 0; k < tries; k++) {
        size_t bits = (size_t)random_next_bits(&b->g);
        size_t i = all.begin + (every ? k / 4 : (bits >> 2) % n);
        int edge = every ? (int)(k % 4) : bits & 1 ? 3 : (int)((bits >> 1) % 3);
        plane_choice x = {.chosen = edge == 3 ? i : SIZE_MAX};
        if (edge == 3 && b->w.f[i].used) continue;
        if (!fragment_plane(&b->w, &b->w.f[i], edge, &x.p)) continue;
        cost_of(b, all, c, &x);
        take_cheaper(best, &x);
    }
}

/* The first fragment from a random one on whose own plane was not yet taken; SIZE_MAX: none. */
static inline size_t draw_unused(chooser *b, fragment_range_of all)
{
    size_t n = all.end - all.begin, start = (size_t)(random_next_bits(&b->g) % n);
    for (size_t k = 0; k < n; k++) {
        size_t i = all.begin + (start + k) % n;
        if (!b->w.f[i].used) return i;
    }
    return SIZE_MAX;
}

/* When all own planes are used up, what is left lies in the sides of the cell; planes through
 * edges can still part it, if both parts are smaller than the whole. */
static inline void choose_edge(chooser *b, fragment_range_of all, plane_choice *best)
{
    size_t n = all.end - all.begin;
    for (int k = 0; k < b->how.candidates; k++) {
        size_t bits = (size_t)random_next_bits(&b->g);
        plane_choice x = {.chosen = SIZE_MAX};
        if (!fragment_plane(&b->w, &b->w.f[all.begin + (bits >> 2) % n], (int)(bits & 3) % 3, &x.p))
            continue;
        count_sides(b, all, &x);
        x.cost = (double)(x.back > x.front ? x.back : x.front) + (double)x.on;
        if (x.cost < (double)n) take_cheaper(best, &x);
    }
}

static inline void choose_auto(chooser *b, fragment_range_of all, plane_choice *best)
{
    int tries = b->how.rule == BSP_RANDOM ? 1 : b->how.candidates;
    for (int k = 0; k < tries; k++) {
        plane_choice x = {.chosen = draw_unused(b, all)};
        if (x.chosen == SIZE_MAX) break;
        b->w.f[x.chosen].used |= !fragment_plane(&b->w, &b->w.f[x.chosen], 3, &x.p);
        if (b->w.f[x.chosen].used) continue;
        count_sides(b, all, &x);
        double uneven = fabs((double)x.back - (double)x.front);
        x.cost = (double)x.cut + uneven / (double)(2 * (all.end - all.begin));
        take_cheaper(best, &x);
    }
    if (best->cost == HUGE_VAL) choose_edge(b, all, best);
    best->on_front = best->front < best->back;
}

/* The plane for a cell; false: it becomes a leaf. */
static inline bool choose_plane(chooser *b, fragment_range_of all, convex c, plane_choice *best)
{
    size_t n = all.end - all.begin;
    *best = (plane_choice){.cost = HUGE_VAL};
    if (n == 0) return false;
    if (!rule_by_cost(b->how.rule)) {
        if (n <= (size_t)b->how.leaf) return false;
        choose_auto(b, all, best);
        return best->cost < HUGE_VAL;
    }
    if (b->how.rule != BSP_OWN) choose_across_axes(b, all, c, best);
    if (b->how.rule != BSP_AXIS) choose_slanted(b, all, c, best);
    return best->cost < (double)n;
}

#endif
