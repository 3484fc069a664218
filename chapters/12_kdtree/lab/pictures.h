/* pictures.h: a mesh under the headlight, and what each pixel's ray took to find it.
 *
 *   draw_one(o, &m, how, z_up, &all)         the mesh, and what its pixels take, side by side
 *   draw_strategies(o, &s, z_up, &all)       four panels: middle, median, SAH at equal leaves;
 *                                            SAH by cost; of the book: with titles
 */
#ifndef KDTREE_PICTURES_H
#define KDTREE_PICTURES_H

#include "../../../common/output.h"
#include "../../../common/lab/label.h"
#include "../../09_aabb/trials/pictures.h"
#include "measure.h"

/* ---------------------------------------------------------------------------------------------- */

static inline bool draw_one(const options *o, const mesh *m, kdtree_options how, bool z_up,
                            image *all)
{
    items x = items_of_mesh(m);
    vec3 lo, hi;
    kdtree t;
    failure f;
    double start = clock_seconds();
    if (!kdtree_build(&x, how, &t, &f)) fail(f);
    double built = clock_seconds() - start;
    structure_stats s = kdtree_stats(&t);
    image im = image_new(o->width > 1 ? o->width / 2 : 1, o->height);
    mesh_bounds(m, &lo, &hi);
    camera c = camera_of(lo, hi, z_up, (real)im.width / (real)im.height);
    trial_picture p = {&kdtree_trial, &t, m, c, im.width, im.height, 120};
    printf("# %zu triangles: built in %.3f s; %zu inner nodes, %zu leaves, %zu of them empty, "
           "%zu references, depth %d, %zu bytes\n", m->triangles, built, s.inner, s.leaves,
           s.empty, s.references, s.depth, s.bytes);
    bool whole = pixels_draw(&im, 3, o->threads, "picture", trial_mesh_colour, &p);
    image_place(all, 0, 0, &im);
    whole = pixels_draw(&im, 1, o->threads, "work", trial_work_colour, &p) && whole;
    image_place(all, im.width, 0, &im);
    image_free(&im);
    kdtree_free(&t);
    return whole;
}

/* A title above each panel, and the colours below all. */
static inline bool draw_strategies(const options *o, const trial_scene *s, bool z_up, image *all)
{
    static const char *const title[4] = {"middle, leaves of 16", "median, leaves of 16",
                                         "SAH, leaves of 16", "SAH, as fine as the cost says"};
    enum { bar = 46 };
    const void *how[4];
    trial_picture p = {.verbs = &kdtree_trial, .most = 120};
    for (int k = 0; k < 4; k++) how[k] = &kdtree_candidate_list[k + 1].how;
    bool whole = trial_draw_work(s, p, z_up, 2, how, 4, o->threads, all);
    if (o->own || o->out || all->width < 400) return whole;
    image sheet = label_panels(all, 2, 2, 0, title);
    image_free(all);
    *all = image_new(sheet.width, sheet.height + bar);
    label_fill(all, 0, 0, all->width, all->height, vec(1, 1, 1));
    image_place(all, 0, 0, &sheet);
    label_bar(all, sheet.width / 4, sheet.height + 8, sheet.width / 2, 9, work_colour, 0,
              (double)p.most, "steps and tests a ray");
    image_free(&sheet);
    return whole;
}

#endif
