/* orders.h: the two orders of rendering once more (08): each triangle on its pixels, or each
 * pixel's ray in a tree? Primary visibility, one thread.
 *
 *   orders_run(&o)                   the table, and 17_compare_orders_time.svg
 *
 *   race_begin(n, &t)                teapot of n x n cells a patch, seen by one camera; its trees
 *   race_picture(&t, how, &s)        how: RACE_RASTER, RACE_BVH, RACE_WIDE; what was in s is gone
 *   race_difference d = race_compare(&t, &a, &b)     pixels of a drawn picture against one by rays
 *   race_end(&t)
 *
 * Both end with a `hit` for each pixel. Making the rays counts, and so does projecting the corners
 * and clearing the picture. Trees are built before: what that takes stands in the table, and
 * a thing that moves pays it in each picture.
 *
 * Two pictures differ where an edge passes within 1/256 of a pixel from its middle, the step to
 * which the rasteriser rounds corners: that explains a pixel if a ray beside its middle, by up to
 * such a step, hits the triangle that was drawn. Triangles of less than a step vanish altogether.
 */
#ifndef COMPARE_LAB_ORDERS_H
#define COMPARE_LAB_ORDERS_H

#include "../../08_object_order/raster.h"
#include "costs.h"
#include "../../07_mesh/scenes/named.h"

typedef enum { RACE_RASTER, RACE_BVH, RACE_WIDE, race_ways } race_way;
static const char *const race_name[race_ways] = {"raster", "bvh", "wide"};
typedef struct {
    world w;
    items x;
    camera c;
    const contender *tree[race_ways];     /* NULL: none */
    void *built[race_ways];
    double build[race_ways];              /* seconds */
} race_track;
typedef struct { size_t other, unexplained; } race_difference;

/* ---------------------------------------------------------------------------------------------- */

static inline void race_begin(int cells, race_track *t)
{
    failure f;
    contender_settings usual = {.n = 0};
    *t = (race_track){.tree = {NULL, &bvh_contender, &wide_contender}};
    if (!mesh_world(&t->w, "teapot", teapot_mesh(cells), true, &f)) fail(f);
    if (!camera_perspective(t->w.frame, 33, (real)4 / 3, &t->c, &f)) fail(f);
    t->x = items_of_mesh(&t->w.mesh);
    for (int k = RACE_BVH; k < race_ways; k++) {
        double start = work_seconds();
        t->built[k] = contender_build(t->tree[k], &usual, &t->x, SIZE_MAX, &f);
        if (!t->built[k]) fail(f);
        t->build[k] = work_seconds() - start;
    }
}

static inline void race_end(race_track *t)
{
    for (int k = RACE_BVH; k < race_ways; k++) contender_free(t->tree[k], t->built[k]);
    world_free(&t->w);
}

static inline void race_picture(const race_track *t, race_way how, raster *s)
{
    size_t nx = (size_t)s->nx, pixels = nx * (size_t)s->ny;
    if (how == RACE_RASTER) {
        for (size_t k = 0; k < pixels; k++) s->h[k] = hit_none, s->key[k] = depth_farthest;
        s->asked = s->covered = 0;
        raster_mesh(s, &t->w.mesh, t->c, raster_default);
        return;
    }
    ray *row = allocate(nx, sizeof *row);  /* a row at a time: the search is a loop of its own */
    for (int y = 0; y < s->ny; y++) {
        for (int x = 0; x < s->nx; x++)
            row[x] = camera_ray(t->c, (real)x + (real)0.5, (real)y + (real)0.5, s->nx, s->ny);
        t->tree[how]->search(t->built[how], row, nx, false, s->h + (size_t)y * nx);
    }
    free(row);
}

/* Is what was drawn at pixel k seen within a step of its middle? Another triangle at the same t,
 * at an edge, will do. */
static inline bool race_explained(const race_track *t, const raster *drawn, int k)
{
    real step = (real)ldexp(1, -raster_default.bits);
    real x = (real)(k % drawn->nx) + (real)0.5, y = (real)(k / drawn->nx) + (real)0.5;
    for (int i = 0; i < 33 * 33; i++) {
        hit h = hit_none;
        real dx = step * (real)(i % 33 - 16) / 16, dy = step * (real)(i / 33 - 16) / 16;
        ray r = camera_ray(t->c, x + dx, y + dy, drawn->nx, drawn->ny);
        (void)bvh_contender.hit(t->built[RACE_BVH], r, &h);
        if (h.shape == drawn->h[k].shape || h.t == drawn->h[k].t) return true;
    }
    return false;
}

static inline race_difference race_compare(const race_track *t, const raster *drawn,
                                           const raster *by_rays)
{
    race_difference d = {0, 0};
    for (int k = 0; k < drawn->nx * drawn->ny; k++) {
        if (drawn->h[k].shape == by_rays->h[k].shape) continue;
        d.other++;
        d.unexplained += !race_explained(t, drawn, k);
    }
    return d;
}

typedef struct { const race_track *t; race_way how; raster s; } race_runner;

static inline double race_run(void *context)
{
    race_runner *r = context;
    race_picture(r->t, r->how, &r->s);
    return (double)r->s.h[0].t;
}

/* One mesh in one size: a row, and its points in the plot. */
static inline void race_row(const race_track *t, int nx, int rounds, const int *series, plot *p,
                            table *to)
{
    race_runner r[race_ways];
    bench_candidate c[race_ways];
    double n = nx * (nx * 3 / 4);
    for (int k = 0; k < race_ways; k++) {
        r[k] = (race_runner){t, (race_way)k, raster_new(nx, nx * 3 / 4)};
        c[k] = (bench_candidate){.run = race_run, .context = &r[k]};
    }
    bench_time_by(work_seconds, c, race_ways, rounds);
    const raster *drawn = &r[RACE_RASTER].s;
    race_difference d = race_compare(t, drawn, &r[RACE_WIDE].s);
    table_count(to, t->w.mesh.triangles), table_text(to, "%d x %d", nx, nx * 3 / 4);
    table_number(to, (double)drawn->asked / n), table_number(to, (double)drawn->covered / n);
    table_count(to, d.other), table_count(to, d.unexplained);
    for (int k = 0; k < race_ways; k++) {
        double ms = 1e3 * c[k].seconds;
        table_number(to, ms);
        if (series[k] >= 0) plot_add(p, series[k], (double)t->w.mesh.triangles, ms);
        raster_free(&r[k].s);
    }
    table_number(to, c[RACE_WIDE].seconds / c[RACE_RASTER].seconds);
    table_number(to, 1e3 * t->build[RACE_WIDE]);
}

static inline void orders_run(const options *o)
{
    static const int cells[] = {2, 8, 32, 64, 125}, width[] = {80, 320, 1280};
    int meshes = o->quick ? 2 : 5, sizes = o->quick ? 2 : 3, series[3][race_ways];
    table t = table_new("Two orders, one picture", "triangles|pixels|asked a pixel|covered a pixel|"
                        "error: another triangle [pixels]|error: unexplained|raster [ms]|"
                        "bvh [ms]|wide [ms]|ratio wide / raster|build wide [ms]");
    plot p = plot_new("One picture in two orders", "triangles", "time [ms]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int i = 0; i < sizes * race_ways; i++) {
        int k = i % race_ways, w = width[i / race_ways];
        char label[64];
        snprintf(label, sizeof label, "%s, %d x %d", race_name[k], w, w * 3 / 4);
        series[i / race_ways][k] = k == RACE_BVH ? -1 : plot_series(&p, label);
    }
    for (int m = 0; m < meshes; m++) {
        race_track track;
        race_begin(cells[m], &track);
        compare_progress("two orders", "timing", "");
        for (int i = 0; i < sizes; i++)
            race_row(&track, width[i], o->quick ? 1 : 5, series[i], &p, &t);
        race_end(&track);
    }
    compare_progress("two orders", NULL, NULL);
    output_extra_table(o, &t);
    output_plot(o, &p, "17_compare_orders_time.svg");
}

#endif
