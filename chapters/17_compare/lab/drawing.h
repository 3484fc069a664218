/* drawing.h: why the proof asks a ray three times: the boxes of example.h along a real ray.
 *
 *   closed_draw(&o)      17_compare_closed.svg: a row for each box on the way from the root to the
 *                        leaf that is hit, from where the ray enters it to where it leaves; below,
 *                        the three intervals (proof.h)
 */
#ifndef COMPARE_LAB_DRAWING_H
#define COMPARE_LAB_DRAWING_H

#include "../../../common/lab/figure.h"
#include "compare.h"
#include "../../07_mesh/scenes/named.h"

/* ---------------------------------------------------------------------------------------------- */

/* Where a ray enters and leaves a box. */
static inline void box_interval(aabb b, ray r, real *enter, real *leave)
{
    ray back = {ray_at(r, 20), 0, vneg(r.d), 20};
    *enter = *leave = 0;
    if (aabb_hit(b, r, enter) && aabb_hit(b, back, leave)) *leave = 20 - *leave;
}

static inline void closed_bar(figure *g, double from, double to, double y, const char *colour)
{
    double xy[8] = {from, y - 7, to, y - 7, to, y + 7, from, y + 7};
    figure_polygon(g, 4, xy, colour, 0.35, colour);
}

/* Sixteen triangles across the ray, all but the last beside it. */
static inline mesh closed_mesh(void)
{
    mesh m = mesh_room(16);
    for (int i = 0; i < 16; i++) {
        real z = 1 + (real)i / 5, x = i == 12 ? (real)0.2 : (real)0.8 - (real)(i % 4);
        m.v[3 * i] = (vec3){x, 0, z};
        m.v[3 * i + 1] = (vec3){x + (real)0.6, 0, z};
        m.v[3 * i + 2] = (vec3){x, (real)0.6, z};
    }
    return m;
}

/* The nodes from the root to the leaf of item `wanted`; how many. 0: it is in none. */
static inline int example_path(const example *e, uint32_t wanted, size_t path[64])
{
    size_t k = 0, first = 0, n = e->n, at = 0;
    int depth = 0;
    while (at < e->n && e->item[at].index != wanted) at++;
    while (at < e->n) {
        path[depth++] = k;
        if (n == 1) break;
        if (at < first + n / 2) k++, n /= 2;
        else k += 2 * (n / 2), first += n / 2, n -= n / 2;
    }
    return depth;
}

cold_inline void closed_draw(const options *o)
{
    static const char *const asked[aimed_ways] = {"as it came", "ends at its hit",
                                                    "begins there, too"};
    mesh m = closed_mesh();
    items x = items_of_mesh(&m);
    example e;
    failure f;
    hit h = hit_none;
    ray r = {vec(0.35, 0.1, 0), 0, vec(0, 0.01, 1), real_infinity};
    size_t path[64];
    if (!example_build(&x, (example_options){SIZE_MAX}, &e, &f)) fail(f);
    if (!example_hit(&e, r, &h)) abort();
    int n = example_path(&e, h.shape, path);
    double unit = 120, t = unit * (double)h.t, end = 560, y = -26.0 * n - 26;
    figure g = figure_begin(o, "17_compare_closed.svg", 800, 120 + 26 * (n + aimed_ways));
    figure_origin(&g, 190, 60, 1);
    figure_text(&g, 0, 0, -175, -32, FIGURE_LEFT, FIGURE_BLACK,
                "From where to where the ray is in the boxes on its way to the hit");
    for (int k = 0; k < n; k++) {
        real enter, leave;
        char name[32];
        box_interval(e.box[path[k]], r, &enter, &leave);
        snprintf(name, sizeof name, k ? k + 1 < n ? "node %zu" : "node %zu, a leaf" : "root",
                 path[k]);
        figure_text(&g, 0, -26.0 * k, -14, 5, FIGURE_RIGHT, FIGURE_BLUE, name);
        closed_bar(&g, unit * (double)enter, unit * (double)leave + 2, -26.0 * k, FIGURE_BLUE);
    }
    figure_line(&g, t, 18, t, y - 26 * 3 + 8, FIGURE_RED, 1.5, FIGURE_DASHED);
    figure_text(&g, t, y - 26 * 3, 0, 14, FIGURE_MIDDLE, FIGURE_RED, "_t_ of the hit");
    for (int k = 0; k < aimed_ways; k++, y -= 26) {
        figure_text(&g, 0, y, -14, 5, FIGURE_RIGHT, FIGURE_BLACK, asked[k]);
        if (k == 0) figure_arrow(&g, 0, y, end, y, FIGURE_BLACK, 2);
        else if (k == 1) figure_line(&g, 0, y, t, y, FIGURE_BLACK, 2, FIGURE_WHOLE);
        if (k < 2) figure_dot(&g, 0, y, 4, FIGURE_BLACK);
        if (k > 0) figure_dot(&g, t, y, 4, FIGURE_BLACK);
    }
    figure_end(&g);
    example_free(&e), mesh_free(&m);
}

#endif
