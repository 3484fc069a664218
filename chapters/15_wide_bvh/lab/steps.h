/* steps.h: draw_steps(o, &s): the nodes and leaves on the way of each pixel's ray, in the tree of
 * 14 and eight wide: the main picture. */
#ifndef WIDE_STEPS_H
#define WIDE_STEPS_H

#include "../../09_aabb/trials/pictures.h"
#include "measure.h"

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 steps_colour(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    search_work w = trial_eye_work(p, x, y);
    return work_colour((real)(w.nodes + w.leaves) / p->most);
}

cold_inline void draw_steps(const options *o, const trial_scene *s)
{
    enum { most = 50 };
    static const char *const title[2] = {"two wide (14)", "eight wide"};
    const bvh_options two = bvh_defaults;
    const bvh8_options all = bvh8_defaults;
    int height = o->height * 5 / 8;
    image im = image_new(o->width, height > 0 ? height : 1);
    vec3 lo, hi;
    mesh_bounds(&s->m, &lo, &hi);
    camera c = camera_of(lo, hi, true, (real)im.width / 2 / (real)im.height);
    const trial_panel panel[2] = {{s, &two_wide_trial, &two, c, most, 1, steps_colour},
                                  {s, &bvh8_trial, &all, c, most, 1, steps_colour}};
    bool whole = trial_draw_panels(&im, 2, 1, 0, panel, false, o->threads);
    trial_label_work(&im, 2, 1, title, most, "nodes and leaves a ray");
    output_picture(o, &im, "15_wide_bvh.png", true, whole);
    image_free(&im);
}

#endif
