/* pictures.h: a mesh as a structure sees it, and what each pixel's ray took (热力图).
 *
 *   trial_picture p = {&kdtree_trial, &t, &m, camera, im.width, im.height, 120};
 *   bool whole = pixels_draw(&im, 3, threads, "picture", trial_mesh_colour, &p);   headlight
 *   bool whole = pixels_draw(&im, 1, threads, "work", trial_work_colour, &p);      black nothing,
 *                                                   white p.most nodes and tests together
 *   bool whole = trial_draw_work(&s, p, z_up, 2, how, n, threads, &all); n panels of the mesh of s,
 *                                     two in a row, each with its structure, built as how[k] says
 */
#ifndef TRIALS_PICTURES_H
#define TRIALS_PICTURES_H

#include "../../../common/headlight.h"
#include "../../../common/lab/heat.h"
#include "../../../common/lab/pixels.h"
#include "bench.h"

typedef struct {
    const trial_verbs *verbs;
    const void *built;
    const mesh *m;
    camera camera;
    int width, height;  /* of the panel */
    real most;
} trial_picture;

/* ---------------------------------------------------------------------------------------------- */

static inline ray trial_eye_ray(const trial_picture *p, real x, real y)
{
    return camera_ray(p->camera, x, y, p->width, p->height);
}

static inline vec3 trial_mesh_colour(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    ray r = trial_eye_ray(p, x, y);
    hit h;
    if (!p->verbs->hit(p->built, r, &h)) return vec(0.93, 0.93, 0.93);
    return headlight(mesh_normal(p->m, h.shape, h.u, h.v), r.d);
}

static inline vec3 trial_work_colour(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    search_work w = {0, 0, 0, 0};
    hit h;
    p->verbs->hit_counted(p->built, trial_eye_ray(p, x, y), &h, &w);
    return work_colour((real)(w.nodes + w.tests) / p->most);
}

typedef struct { trial_row *row; const trial_scene *s; } trial_builds;

static inline void trial_build_one(size_t i, void *builds)
{
    trial_builds *b = builds;
    trial_build(&b->row[i], b->s);
}

/* verbs, most: of p; the mesh of s; camera: z up or y; n [1, 16]. */
static inline bool trial_draw_work(const trial_scene *s, trial_picture p, bool z_up, int across,
                                   const void *const *how, int n, int threads, image *all)
{
    bool whole = true;
    vec3 lo, hi;
    int down = (n + across - 1) / across;
    mesh_bounds(&s->m, &lo, &hi);
    trial_row row[16];
    trial_builds builds = {row, s};
    for (int k = 0; k < n; k++) row[k] = (trial_row){.verbs = p.verbs, .how = how[k]};
    parallel_whole((size_t)n, threads, "building", trial_build_one, &builds);
    for (int k = 0; k < n; k++) {
        if (!row[k].built) return false;
        image im = image_new(all->width > across ? all->width / across : 1,
                             all->height > down ? all->height / down : 1);
        p.built = row[k].built, p.m = &s->m, p.width = im.width, p.height = im.height;
        p.camera = camera_of(lo, hi, z_up, (real)im.width / (real)im.height);
        whole = pixels_draw(&im, 1, threads, "work", trial_work_colour, &p) && whole;
        image_place(all, k % across * im.width, k / across * im.height, &im);
        trial_unbuild(&row[k]), image_free(&im);
    }
    return whole;
}

#endif
