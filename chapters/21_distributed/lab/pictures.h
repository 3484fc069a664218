/* pictures.h: what Whitted cannot do.
 *
 *   draw_showroom(&o, effects, spend_all, "21_distributed.png")     the main picture
 *   draw_showroom(&o, 0, false, "21_distributed_whitted.png")       the same, without any extent
 *   draw_teapot(&o)                        as a mirror, as a highlight, glossy, glossier
 *   draw_box(&o)                           the Cornell box: hard, soft, ambient, ambient occlusion
 *   draw_motion(&o)                        five balls on a table, two of them moving
 */
#ifndef DISTRIBUTED_LAB_PICTURES_H
#define DISTRIBUTED_LAB_PICTURES_H

#include "../../../common/lab/label.h"
#include "../../../common/lab/pixels.h"
#include "../../../common/output.h"
#include "box.h"
#include "pool.h"
#include "showroom.h"

/* ---------------------------------------------------------------------------------------------- */

enum { pictures_gap = 4 };

static inline int pictures_cells(const options *o) { return o->quick ? 5 : 16; }

/* White between the panels, a title above each. */
static inline image pictures_sheet(int across, int down, int w, int h)
{
    return label_sheet(across * (w + pictures_gap) - pictures_gap,
                       down * (h + pictures_gap) - pictures_gap);
}

static inline void pictures_panel(image *sheet, int i, int j, const image *one)
{
    image_place(sheet, i * (one->width + pictures_gap), j * (one->height + pictures_gap), one);
}

static inline void pictures_output(const options *o, image *sheet, int across, int down,
                                   const char *const *title, const char *name, bool whole)
{
    label_titles(sheet, across, down, pictures_gap, title);
    output_picture(o, sheet, name, false, whole);
    image_free(sheet);
}

/* The first is the main picture, which may have other effects. */
static inline void draw_showroom(const options *o, int effects, bool spend_all, const char *name)
{
    bool main_one = strcmp(name, "21_distributed.png") == 0;
    showroom *g = showroom_new(pictures_cells(o));
    showroom_look k;
    showroom_set(&k, g, effects);
    k.how.spend_all = spend_all;
    distributed_view v = showroom_view(&k, SHOWROOM_ALL, (real)o->width / (real)o->height);
    image im = image_new(o->width, o->height);
    v.samples = main_one ? (uint32_t)o->samples : o->quick ? 1 : 4, v.seed = o->seed;
    double start = clock_seconds();
    bool whole = distributed_draw(&v, &im, o->threads);
    const size_t *n = v.spent.rays.rays;
    if (main_one)
        printf("# %zu camera, %zu shadow, %zu reflection, %zu sky rays; %.2f s\n", n[RAY_CAMERA],
               n[RAY_SHADOW], n[RAY_REFLECTION], n[RAY_SIGHT], clock_seconds() - start);
    output_picture(o, &im, name, main_one, whole);
    image_free(&im), showroom_free(g);
}

/* ---- the notes' two failures ---- */

/* Blinn-Phong (18) under the same lights, as points: a highlight is all that it reflects. */
typedef struct {
    const showroom_look *k;
    camera c;
    int width, height;
    light lights[2];
    shading how;
} distributed_highlight;

static inline vec3 highlight_colour(const void *context, real x, real y)
{
    const distributed_highlight *p = context;
    tracer t = {.w = &p->k->w, .program = shade_programs, .user = &p->how};
    return shade_ray(&t, camera_ray(p->c, x, y, p->width, p->height));
}

static inline bool draw_highlight(const showroom_look *k, camera c, image *im, int threads)
{
    distributed_highlight p = {k, c, im->width, im->height, {{LIGHT_POINT, {0, 0, 0}, {0, 0, 0}}},
                        {.lights = NULL}};
    for (int i = 0; i < 2; i++)
        p.lights[i] = (light){LIGHT_POINT, k->light[i].at, k->light[i].colour};
    p.how = (shading){.lights = p.lights, .n = 2, .material_of = showroom_material, .context = k,
                      .background = k->how.background, .ambient = k->how.ambient};
    return pixels_draw(im, 2, threads, "drawing", highlight_colour, &p);
}

static inline void draw_teapot(const options *o)
{
    static const int shine[4] = {0, 0, 600, 40};
    static const char *const title[4] = {"a perfect mirror", "a highlight of lamps only",
                                         "a lobe, s = 600", "a lobe, s = 40"};
    enum { w = 328, h = w * 9 / 16 };
    showroom *g = showroom_new(pictures_cells(o));
    image sheet = pictures_sheet(2, 2, w, h), one = image_new(w, h);
    bool whole = true;
    for (int i = 0; i < 4 && whole; i++) {
        showroom_look k;
        showroom_set(&k, g, (i == 1 ? 0 : EFFECT_SOFT) | (i == 0 ? 0 : EFFECT_GLOSSY));
        if (i > 1) k.pot_shine = (real)shine[i];
        distributed_view v = showroom_view(&k, SHOWROOM_GLOSSY, (real)w / (real)h);
        v.samples = i > 2 ? 32 : i ? 16 : 8, v.seed = o->seed;
        whole = i == 1 ? draw_highlight(&k, v.c, &one, o->threads)
                       : distributed_draw(&v, &one, o->threads);
        pictures_panel(&sheet, i % 2, i / 2, &one);
    }
    pictures_output(o, &sheet, 2, 2, title, "21_distributed_teapot.png", whole);
    image_free(&one), showroom_free(g);
}

/* Exposed twice as long as the showroom. */
static inline void draw_box(const options *o)
{
    static const real reach[4] = {0, 0, 0, 250};
    static const char *const title[4] = {"1: point light", "2: area light", "3: ambient term",
                                         "4: ambient occlusion"};
    enum { w = 180 };
    image sheet = pictures_sheet(4, 1, w, w), one = image_new(w, w);
    bool whole = true;
    for (int i = 0; i < 4 && whole; i++) {
        vec3 ambient = vec(0.26, 0.2, 0.11);
        distributed_box *b = box_new(i > 0, i > 1 ? ambient : (vec3){0, 0, 0}, reach[i]);
        distributed_view v = box_view(b, 1);
        v.samples = 32, v.seed = o->seed;
        whole = distributed_draw(&v, &one, o->threads);
        for (int k = 0; k < 3 * w * w; k++) one.rgb[k] *= 2;
        pictures_panel(&sheet, i, 0, &one);
        box_free(b);
    }
    pictures_output(o, &sheet, 4, 1, title, "21_distributed_cornell.png", whole);
    image_free(&one);
}

static inline void draw_motion(const options *o)
{
    pool *g = pool_new(1);
    image im = image_new(640, 360);
    distributed_view v = pool_view(g, (real)im.width / (real)im.height);
    v.samples = 64, v.seed = o->seed;
    bool whole = distributed_draw(&v, &im, o->threads);
    output_picture(o, &im, "21_distributed_motion.png", false, whole);
    image_free(&im), pool_free(g);
}

#endif
