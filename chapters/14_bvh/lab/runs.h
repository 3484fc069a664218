/* runs.h: draw_rules(o, &s): what each pixel took, by four of the rules. */
#ifndef BVH_RUNS_H
#define BVH_RUNS_H

#include "../../09_aabb/trials/pictures.h"
#include "../../../common/lab/label.h"
#include "../../../common/lab/report.h"
#include "measure.h"

/* ---------------------------------------------------------------------------------------------- */

cold_inline void draw_rules(const options *o, const trial_scene *s)
{
    enum { most = 160 };
    static const char *const rule[4] = {"cycle", "longest", "median", "sah"};
    bvh_options how[4];
    const void *list[4];
    for (int k = 0; k < 4; k++) how[k] = bvh_defaults, how[k].rule = rule[k], list[k] = &how[k];
    image im = image_new(o->width, o->height);
    trial_picture p = {.verbs = &bvh_trial, .most = most};
    bool whole = trial_draw_work(s, p, true, 2, list, 4, o->threads, &im);
    trial_label_work(&im, 2, 2, rule, most, "pairs of boxes and triangles a ray");
    output_picture(o, &im, "14_bvh_visits.png", false, whole);
    image_free(&im);
}

#endif
