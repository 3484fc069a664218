/* orders.h: the two orders of rendering once more (08): each triangle on its pixels, or each
 * pixel's ray in a tree? Primary visibility, one thread.
 *
 *   orders_run(&c)                        a table
 *
 * Both end with a `hit` for each pixel (08 says where these differ). Making the rays counts, and so
 * does projecting the corners and clearing the picture. The tree is built before: what that takes
 * stands in the table, and a thing that moves pays it in each picture.
 */
#ifndef COMPARE_LAB_ORDERS_H
#define COMPARE_LAB_ORDERS_H

#include "../../08_object_order/raster.h"
#include "../../07_mesh/scenes/named.h"
#include "costs.h"

/* A teapot, a camera, its wide tree; s: the picture that both draw; what was in it is gone. */
typedef struct { world w; items x; camera c; void *tree; double build; raster s; } race;

/* ---------------------------------------------------------------------------------------------- */

/* cells: of each patch, along an edge */
static inline void race_begin(int cells, race *t)
{
    failure f;
    if (!mesh_world(&t->w, "teapot", teapot_mesh(cells), true, &f)
        || !camera_perspective(t->w.frame, 33, (real)4 / 3, &t->c, &f)) fail(f);
    t->x = items_of_mesh(&t->w.mesh);
    double start = work_seconds();
    t->tree = contender_build(&wide_contender, &(contender_settings){.n = 0}, &t->x, SIZE_MAX, &f);
    if (!t->tree) fail(f);
    t->build = work_seconds() - start;
}

static inline void race_end(race *t)
{
    contender_free(&wide_contender, t->tree);
    world_free(&t->w);
}

static inline double race_drawn(void *context)
{
    race *t = context;
    raster *s = &t->s;
    for (int k = 0; k < s->nx * s->ny; k++) s->h[k] = hit_none, s->depth[k] = -1;
    s->asked = s->covered = 0;
    raster_mesh(s, &t->w.mesh, t->c, raster_default);
    return (double)s->h[0].t;
}

/* A row at a time: the search is a loop of its own. */
static inline double race_traced(void *context)
{
    race *t = context;
    size_t nx = (size_t)t->s.nx;
    ray *row = allocate(nx, sizeof *row);
    for (int y = 0; y < t->s.ny; y++) {
        for (int x = 0; x < t->s.nx; x++)
            row[x] = camera_ray(t->c, (real)x + (real)0.5, (real)y + (real)0.5, t->s.nx, t->s.ny);
        wide_contender.search(t->tree, row, nx, false, t->s.h + (size_t)y * nx);
    }
    free(row);
    return (double)t->s.h[0].t;
}

/* One mesh in one size. */
static inline void race_row(race *t, int nx, int rounds, table *to)
{
    bench_candidate c[2] = {{.run = race_drawn, .context = t}, {.run = race_traced, .context = t}};
    int ny = nx * 3 / 4;
    t->s = raster_new(nx, ny);
    bench_time_by(work_seconds, c, 2, rounds);
    table_count(to, t->w.mesh.triangles), table_text(to, "%d x %d", nx, ny);
    table_number(to, (double)t->s.asked / (nx * ny));
    for (int k = 0; k < 2; k++) table_number(to, 1e3 * c[k].seconds);
    table_number(to, c[1].seconds / c[0].seconds), table_number(to, 1e3 * t->build);
    raster_free(&t->s);
}

static inline void orders_run(const compare_settings *c)
{
    bool quick = c->o->quick;
    static const int cells[] = {2, 8, 32, 64, 125}, width[] = {80, 320, 1280};
    table t = table_new("Two orders, one picture", "triangles|pixels|asked a pixel|raster [ms]|"
                        "wide [ms]|ratio wide / raster|build wide [ms]");
    for (int m = 0; m < (quick ? 2 : 5); m++) {
        race track;
        race_begin(cells[m], &track);
        compare_progress("two orders", "timing", "");
        for (int i = 0; i < (quick ? 2 : 3); i++) race_row(&track, width[i], quick ? 1 : 5, &t);
        race_end(&track);
    }
    compare_progress("two orders", NULL, NULL);
    html_element(c->to, "h2", "Two orders");
    html_table(c->to, &t);
}

#endif
