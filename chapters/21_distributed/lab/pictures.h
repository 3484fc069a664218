/* pictures.h: what Whitted cannot do.
 *
 *   draw_showroom(&o, effects, all, "21_distributed.png")        the main picture; all: send rays
 *                                                                that cannot contribute, too
 *   draw_showroom(&o, 0, false, "21_distributed_whitted.png")    the same, without any extent
 *   draw_teapot(&o)                        as a mirror, and by two lobes
 *   draw_cornell(&o)                       the Cornell box: hard, soft, ambient, ambient occlusion
 *   draw_motion(&o)                        five balls on a table, two of them moving
 */
#ifndef DISTRIBUTED_LAB_PICTURES_H
#define DISTRIBUTED_LAB_PICTURES_H

#include "../../../common/lab/panels.h"
#include "box.h"
#include "pool.h"
#include "showroom.h"

/* ---------------------------------------------------------------------------------------------- */

cold_inline bool draw_sampled(const options *o, distributed_view *v, int samples, image *im)
{
    v->samples = (uint32_t)samples, v->seed = o->seed;
    return distributed_draw(v, im, o->threads);
}

/* The first is the main picture, which may have other effects. */
cold_inline void draw_showroom(const options *o, int effects, bool all, const char *name)
{
    bool main_one = strcmp(name, "21_distributed.png") == 0;
    showroom *g = showroom_new(o->quick ? 5 : 16);
    showroom_look k;
    showroom_set(&k, g, effects);
    k.how.spend_all = all;
    distributed_view v = showroom_view(&k, SHOWROOM_ALL, (real)o->width / (real)o->height);
    image im = image_new(o->width, o->height);
    double start = clock_seconds();
    bool whole = draw_sampled(o, &v, main_one ? o->samples : o->quick ? 1 : 4, &im);
    const size_t *n = v.spent.rays.rays;
    if (main_one)
        printf("# %zu camera, %zu shadow, %zu reflection, %zu sky rays; %.2f s\n", n[RAY_CAMERA],
               n[RAY_SHADOW], n[RAY_REFLECTION], n[RAY_SIGHT], clock_seconds() - start);
    output_picture(o, &im, name, main_one, whole);
    image_free(&im), showroom_free(g);
}

cold_inline void draw_motion(const options *o)
{
    pool *g = pool_new(1);
    image im = image_new(640, 360);
    distributed_view v = pool_view(g, (real)im.width / (real)im.height);
    bool whole = draw_sampled(o, &v, 64, &im);
    output_picture(o, &im, "21_distributed_motion.png", false, whole);
    image_free(&im), pool_free(g);
}

/* ---- the notes' two failures ---- */

enum { pictures_gap = 4 };

cold_inline void draw_teapot(const options *o)
{
    static const int shine[3] = {0, 600, 40};  /* 0: a perfect mirror */
    static const char *const title[3] = {"a perfect mirror", "a lobe, s = 600", "a lobe, s = 40"};
    showroom *g = showroom_new(o->quick ? 5 : 16);
    image sheet = {0}, one = image_new(328, 184);
    bool whole = true;
    for (int i = 0; i < 3 && whole; i++) {
        showroom_look k;
        showroom_set(&k, g, LOOK_SOFT | (i ? LOOK_GLOSSY : 0));
        k.pot_shine = (real)shine[i];
        distributed_view v = showroom_view(&k, SHOWROOM_GLOSSY, (real)one.width / (real)one.height);
        whole = draw_sampled(o, &v, 8 << i, &one);
        label_panel(&sheet, 3, 1, pictures_gap, i, &one);
    }
    panels_save(o, &sheet, 3, 1, pictures_gap, title, "21_distributed_teapot.png", whole);
    image_free(&one), showroom_free(g);
}

/* Exposed twice as long as the showroom. */
cold_inline void draw_cornell(const options *o)
{
    static const char *const title[4] = {"1: point light", "2: area light", "3: ambient term",
                                         "4: ambient occlusion"};
    image sheet = {0}, one = image_new(180, 180);
    bool whole = true;
    for (int i = 0; i < 4 && whole; i++) {
        vec3 ambient = vec(0.26, 0.2, 0.11);
        distributed_box *b = box_new(i > 0, i > 1 ? ambient : (vec3){0, 0, 0}, i > 2 ? 250 : 0);
        distributed_view v = box_view(b, 1);
        whole = draw_sampled(o, &v, 32, &one);
        for (int k = 0; k < 3 * 180 * 180; k++) one.rgb[k] *= 2;
        label_panel(&sheet, 4, 1, pictures_gap, i, &one);
        box_free(b);
    }
    panels_save(o, &sheet, 4, 1, pictures_gap, title, "21_distributed_cornell.png", whole);
    image_free(&one);
}

#endif
