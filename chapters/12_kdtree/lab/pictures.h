/* pictures.h: what each pixel's ray took.
 *
 *   draw_splits(o, &s, z_up, &all)           four panels: middle, median, SAH at equal leaves;
 *                                            SAH by cost; of the book: with titles
 *   draw_final(o)                            what is lost if the first hit is taken for the closest
 */
#ifndef KDTREE_PICTURES_H
#define KDTREE_PICTURES_H

#include "../../../common/output.h"
#include "../../../common/lab/label.h"
#include "../../07_mesh/scenes/soup.h"
#include "../../09_aabb/trials/pictures.h"
#include "measure.h"

/* ---------------------------------------------------------------------------------------------- */

/* A title above each panel, and the colours below all. */
cold_inline bool draw_splits(const options *o, const trial_scene *s, bool z_up, image *all)
{
    static const char *const title[4] = {"middle, leaves of 16", "median, leaves of 16",
                                         "SAH, leaves of 16", "SAH, as fine as the cost says"};
    enum { bar = 46 };
    const void *how[4];
    trial_picture p = {.verbs = &kdtree_trial, .most = 120};
    for (int k = 0; k < 4; k++) how[k] = kdtree_row_list[k + 1].how;
    bool whole = trial_draw_work(s, p, z_up, 2, how, 4, o->threads, all);
    if (o->own || o->out || all->width < 400) return whole;
    label_titles(all, 2, 2, 0, title), label_below(all, bar);
    label_bar(all, all->width / 4, all->height - bar + 8, all->width / 2, 9, work_colour, 0,
              (double)p.most, "steps and tests a ray; white: more");
    return whole;
}

/* Each triangle in a grey or blue of its own, orange where the hit is not that of kdtree_hit; only
 * the middle of the picture. */
static inline vec3 final_colour(const void *picture, real x, real y)
{
    static const vec3 tint[6] = {{0.8, 0.8, 0.8}, {0.34, 0.71, 0.91}, {0.55, 0.6, 0.65},
                                 {0.1, 0.45, 0.7}, {0.93, 0.93, 0.93}, {0.45, 0.6, 0.85}};
    const trial_picture *p = picture;
    hit h = hit_none, due = hit_none;
    real w = (real)p->width / 5;
    ray r = trial_eye_ray(p, w + x * (real)0.6, w + y * (real)0.6);
    p->verbs->hit(p->built, r, &h), kdtree_hit(p->built, r, &due);
    if (h.shape != due.shape) return vec(0.95, 0.3, 0);
    if (h.shape == no_shape) return vec(1, 1, 1);
    vec3 grey = headlight(mesh_normal(p->m, h.shape, h.u, h.v), r.d);
    return vscale(tint[h.shape % 6], (real)0.35 + (real)0.65 * grey.x);
}

/* Large triangles through each other: the first hit of any leaf as the closest, and the closest. */
cold_inline void draw_final(const options *o)
{
    enum { gap = 8 };
    static const char *const title[2] = {"the first hit is final: orange is wrong",
                                         "kept until the next cell begins behind it"};
    int side = o->quick ? 40 : 400;
    kdtree_options how = kdtree_defaults;
    trial_scene s;
    bool whole = true;
    image all = label_sheet(2 * side + gap, side), im = image_new(side, side);
    how.leaf = 2;
    trial_scene_of(soup_mesh(60, (real)0.6, (real)0.9, 5), &s);
    for (int k = 0; k < 2 && whole; k++) {
        trial_row r = {.verbs = k ? &kdtree_trial : &kdtree_final_trial, .how = &how};
        trial_build(&r, &s);
        trial_picture p = {r.verbs, r.built, &s.m, trial_camera(&s.m, 1), side, side, 1};
        whole = pixels_draw(&im, 2, o->threads, "hits", final_colour, &p);
        image_place(&all, k * (side + gap), 0, &im);
        trial_unbuild(&r);
    }
    if (!o->quick) label_titles(&all, 2, 1, gap, title);
    output_picture(o, &all, "12_kdtree_final.png", false, whole);
    image_free(&all), image_free(&im), trial_scene_free(&s);
}

#endif
