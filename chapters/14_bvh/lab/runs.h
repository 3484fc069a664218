/* runs.h: what main.c calls: pictures of a mesh.
 *
 *   draw_mesh(o, &m, how, z_up, path)       the mesh under the headlight; path: its file, or NULL
 *   draw_visits(o, &m)                      what each pixel took, by four of the rules
 */
#ifndef BVH_RUNS_H
#define BVH_RUNS_H

#include "../../09_aabb/trials/pictures.h"
#include "../../../common/lab/label.h"
#include "../../../common/lab/report.h"
#include "measure.h"

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

#endif
