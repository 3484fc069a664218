/* 14_bvh: a tree of boxes over the triangles of a mesh: built in seven ways, searched, compared.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 14_bvh chapters/14_bvh/main.c -lm -lpthread
 *
 * Without options: the teapot of 102080 triangles, what each pixel took, six tables, three plots.
 * --mesh FILE.obj: that mesh instead, a picture only. --rays FILE: searches these rays and no
 * others. */
#include "../07_mesh/files/obj.h"
#include "lab/growth.h"
#include "lab/pareto.h"
#include "lab/pictures.h"
#include "../07_mesh/files/ray_file.h"

typedef struct { const char *mesh, *rays, *hits, *strategy; bool any; int leaf; } own_options;

static const char *const strategy_names[bvh_strategies] = {"cycle", "longest", "median", "sah",
                                                           "sweep", "morton",
                                                           "spatial"};

static bvh_options build_options(const own_options *own)
{
    bvh_options b = bvh_defaults;
    for (int k = 0; k <= bvh_strategies; k++) {
        if (k == bvh_strategies)
            die(2, "--strategy %s: allowed are cycle, longest, median, sah, sweep, "
                          "morton, spatial",
                   own->strategy);
        b.strategy = (bvh_strategy)k;
        if (strcmp(own->strategy, strategy_names[k]) == 0) break;
    }
    b.leaf = own->leaf;
    if (own->leaf == 1) b.item_cost = 1;
    return b;
}

static void draw(options *o, const mesh *m, bvh_options build, bool z_up, const char *mesh_path)
{
    vec3 lo, hi;
    char name[512];
    bvh b;
    double start = clock_seconds();
    bvh_build(m, build, &b);
    double built = clock_seconds();
    mesh_bounds(m, &lo, &hi);
    image im = image_new(o->width, o->height);
    view v = view_of(lo, hi, z_up, (real)o->width / (real)o->height);
    picture p = {&b, m, v, &im, o->quick ? 1 : 3, 120};
    bool whole = draw_mesh(p, o->threads);
    printf("# %zu triangles: built in %.3f s, %d x %d pixels of %d rays in %.3f s\n", m->triangles,
           built - start, o->width, o->height, p.samples * p.samples, clock_seconds() - built);
    output_picture(o, &im, picture_name("14_bvh.png", mesh_path, name), true, whole);
    bvh_free(&b);
    image_free(&im);
}

/* One thread; the median of seven passes. The columns are those of all programs that read such
 * files. */
static void search_file(const options *o, const own_options *own, const mesh *m, bvh_options build)
{
    failure f;
    size_t n, hits = 0;
    bvh_work w = {0, 0, 0, 0, 0};
    double seconds[7];
    ray *r = rays_read(own->rays, &n, &f);
    if (!r) fail(f);
    hit *h = allocate(n, sizeof *h);
    bvh b;
    double start = clock_seconds();
    bvh_build(m, build, &b);
    double built = clock_seconds() - start;
    for (int pass = -1; pass < 7; pass++) {
        start = clock_seconds();
        for (size_t i = 0; i < n; i++) {
            h[i] = hit_none;
            if (!own->any) bvh_hit(&b, r[i], &h[i]);
            else if (bvh_occluded(&b, r[i])) h[i].shape = 0;
        }
        if (pass >= 0) seconds[pass] = clock_seconds() - start;
    }
    for (size_t i = 0; i < n; i++) {
        hit again;
        hits += own->any ? bvh_occluded_counted(&b, r[i], &w)
                         : bvh_hit_counted(&b, r[i], &again, &w);
    }
    table t = table_new("Rays from a file, one thread",
                        "scene|structure|kind|rays|hits|build_s|bytes|nodes_per_ray|"
                        "tests_per_ray|ns_per_ray");
    table_text(&t, "%s", own->mesh ? own->mesh : "teapot"), table_text(&t, "bvh %s", own->strategy);
    table_text(&t, own->any ? "any" : "closest"), table_count(&t, n), table_count(&t, hits);
    table_text(&t, "%.6f", built), table_count(&t, b.tree.bytes);
    table_number(&t, per((double)w.nodes, n)), table_number(&t, per((double)w.tests, n));
    table_number(&t, clock_median(seconds, 7) * 1e9 / (double)n);
    output_table(o, &t);
    if (own->hits && !hits_write(own->hits, h, n, own->any, &f)) fail(f);
    bvh_free(&b);
    free(r), free(h);
}

int main(int argc, char **argv)
{
    own_options own = {.strategy = "sah", .leaf = bvh_defaults.leaf};
    const option list[] = {
        {"mesh", OPTION_INPUT, &own.mesh, 0, 0,
         "FILE.obj: draw this mesh, y up, or search it (--rays)"},
        {"rays", OPTION_INPUT, &own.rays, 0, 0,
         "search these rays: ox oy oz tmin dx dy dz tmax, float32"},
        {"hits", OPTION_OUTPUT, &own.hits, 0, 0, "with --rays: their t and triangle to this file"},
        {"any-hit", OPTION_FLAG, &own.any, 0, 0, "with --rays: is there any hit at all?"},
        {"strategy", OPTION_TEXT, &own.strategy, 0, 0,
         "cycle, longest, median, sah, sweep, morton or spatial"},
        {"leaf", OPTION_INT, &own.leaf, 1, 255, "most triangles in a leaf"},
        {0}};
    options o = options_read(argc, argv, "14_bvh",
                             "Bounding volume hierarchies of triangle meshes.",
                             (options){.width = 640, .height = 400, .seed = 1}, list);
    bvh_options build = build_options(&own);
    failure f;
    mesh m = {0};
    if (!own.rays && (own.hits || own.any))
        die(2, "--hits and --any-hit need --rays FILE");
    if (own.rays && o.out) die(2, "--out: no picture with --rays");
    if (!own.rays && o.csv && (own.mesh || o.out))
        die(2, "--csv: no table with --mesh, --out, but with --rays");
    if (own.mesh && !obj_read(own.mesh, &m, &f)) fail(f);
    if (!own.mesh) m = teapot_mesh(o.quick ? 8 : 40);
    o.own = own.mesh || own.rays;
    if (own.rays) search_file(&o, &own, &m, build);
    else draw(&o, &m, build, !own.mesh, own.mesh);
    if (!own.rays && !own.mesh && !o.out) {
        image visits = image_new(o.width, o.height);
        bool whole = draw_all_visits(&m, o.threads, &visits);
        output_picture(&o, &visits, "14_bvh_visits.png", false, whole);
        image_free(&visits);
        int width = o.quick ? 40 : 240;
        subject s = subject_of(m, width, width * 5 / 8, o.quick ? 50 : 1000, o.seed);
        table_of_strategies(&o, &s);
        table_of_overlap(&o, &s);
        table_of_stadium(&o);
        table_of_paying(&o, &s);
        table_of_slivers(&o);
        if (!o.quick) plot_of_pareto(&o, &s);
        growth(&o, o.full);
        subject_free(&s);
    } else mesh_free(&m);
    return output_done(&o);
}
