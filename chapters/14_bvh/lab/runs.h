/* runs.h: what main.c calls: pictures of a mesh, and rays from a file.
 *
 *   draw_mesh(o, &m, how, z_up, path)       the mesh under the headlight; path: its file, or NULL
 *   draw_visits(o, &m)                      what each pixel took, by four of the rules
 *   search_file(o, &f, &m, how, "sah")      the rays of f.rays, one thread, the median of seven
 *                                           passes; the columns are those of all programs that read
 *                                           such files
 */
#ifndef BVH_RUNS_H
#define BVH_RUNS_H

#include "../../07_mesh/files/ray_file.h"
#include "../../09_aabb/trials/pictures.h"
#include "../../../common/lab/label.h"
#include "../../../common/lab/report.h"
#include "measure.h"

typedef struct { const char *scene, *rays, *hits; bool any; } bvh_ray_file;

/* ---------------------------------------------------------------------------------------------- */

static inline void draw_mesh(const options *o, const mesh *m, bvh_options how, bool z_up,
                             const char *path)
{
    vec3 lo, hi;
    char name[512];
    bvh b;
    failure f;
    items x = items_of_mesh(m);
    int samples = o->quick ? 1 : 3;
    double start = clock_seconds();
    if (!bvh_build(&x, how, &b, &f)) fail(f);
    double built = clock_seconds();
    mesh_bounds(m, &lo, &hi);
    image im = image_new(o->width, o->height);
    camera c = camera_of(lo, hi, z_up, (real)o->width / (real)o->height);
    trial_picture p = {&bvh_trial, &b, m, c, o->width, o->height, 0};
    bool whole = pixels_draw(&im, samples, o->threads, "picture", trial_mesh_colour, &p);
    printf("# %zu triangles: built in %.3f s, %d x %d pixels of %d rays in %.3f s\n", m->triangles,
           built - start, o->width, o->height, samples * samples, clock_seconds() - built);
    output_picture(o, &im, picture_name("14_bvh.png", path, name), true, whole);
    bvh_free(&b);
    image_free(&im);
}

static inline void draw_visits(const options *o, const trial_scene *s)
{
    enum { most = 160, bar = 44 };
    static const char *const rule[4] = {"cycle", "longest", "median", "sah"};
    bvh_options how[4];
    const void *list[4];
    for (int k = 0; k < 4; k++) how[k] = bvh_defaults, how[k].rule = rule[k], list[k] = &how[k];
    image im = image_new(o->width, o->height);
    trial_picture p = {.verbs = &bvh_trial, .most = most};
    bool whole = trial_draw_work(s, p, true, 2, list, 4, o->threads, &im);
    label_titles(&im, 2, 2, 0, rule), label_below(&im, bar);
    label_bar(&im, im.width / 4, im.height - bar + 6, im.width / 2, 9, work_colour, 0, most,
              "pairs of boxes and triangles a ray");
    output_picture(o, &im, "14_bvh_visits.png", false, whole);
    image_free(&im);
}

static inline void search_file(const options *o, const bvh_ray_file *file, const mesh *m,
                               bvh_options how, const char *strategy)
{
    failure f;
    size_t n, hits = 0;
    search_work w = {0, 0, 0, 0};
    double seconds[7];
    ray *r = rays_read(file->rays, &n, &f);
    if (!r) fail(f);
    hit *h = allocate(n, sizeof *h), again;
    bvh b;
    items x = items_of_mesh(m);
    double start = clock_seconds();
    if (!bvh_build(&x, how, &b, &f)) fail(f);
    double built = clock_seconds() - start;
    for (int pass = -1; pass < 7; pass++) {
        start = clock_seconds();
        for (size_t i = 0; i < n; i++) {
            h[i] = hit_none;
            if (!file->any) bvh_hit(&b, r[i], &h[i]);
            else if (bvh_occluded(&b, r[i])) h[i].shape = 0;
        }
        if (pass >= 0) seconds[pass] = clock_seconds() - start;
    }
    for (size_t i = 0; i < n; i++)
        hits += file->any ? bvh_occluded_counted(&b, r[i], &w)
                          : bvh_hit_counted(&b, r[i], &again, &w);
    table t = table_new("Rays from a file, one thread",
                        "scene|structure|kind|rays|hits|build_s|bytes|nodes_per_ray|"
                        "tests_per_ray|ns_per_ray");
    table_text(&t, "%s", file->scene), table_text(&t, "bvh %s", strategy);
    table_text(&t, file->any ? "any" : "closest"), table_count(&t, n), table_count(&t, hits);
    table_text(&t, "%.6f", built), table_count(&t, bvh_tree_of(&b)->bytes);
    table_number(&t, trial_per((double)w.nodes, n));
    table_number(&t, trial_per((double)w.tests, n));
    table_number(&t, clock_median(seconds, 7) * 1e9 / (double)n);
    output_table(o, &t);
    if (file->hits && !hits_write(file->hits, h, n, file->any, &f)) fail(f);
    bvh_free(&b);
    free(r), free(h);
}

#endif
