/* pictures.h: a mesh as a structure sees it, and what each pixel's ray took (热力图).
 *
 *   trial_picture p = {&kdtree_trial, &t, &m, camera, im.width, im.height, 120};
 *   bool whole = pixels_draw(&im, 3, threads, "picture", trial_mesh_colour, &p);   headlight
 *   bool whole = pixels_draw(&im, 1, threads, "work", trial_work_colour, &p);      black nothing,
 *                                                   white p.most nodes and tests together
 *   bool whole = trial_draw(&im, &side, threads, "picture", trial_mesh_colour, p);  of any mesh:
 *                                                   where its rays are dear of fewer, and says so
 *   trial_panel panel[] = {{&s, &kdtree_trial, &how, camera, 120, 1, trial_work_colour}, ..};
 *   bool whole = trial_draw_panels(&all, columns, rows, 6, panel, any, threads);   6 pixels apart,
 *                                     each with its structure, camera and colours
 *   bool whole = trial_draw_work(&s, p, z_up, 2, how, n, threads, &all); n panels of the mesh of s,
 *                                     two in a row, each with its structure, built as how[k] says
 *   trial_label_work(&all, columns, rows, title, most, "nodes a ray");   titles above the panels,
 *                                     and below them a bar of colours from 0 to most
 *   trial_draw_mesh(&o, &s, &v, &how, z_up, "14_bvh.png", path);   the main picture: under the
 *                                     headlight, and what it took; path: the mesh's file, or NULL
 */
#ifndef TRIALS_PICTURES_H
#define TRIALS_PICTURES_H

#include "../../../common/headlight.h"
#include "../../../common/lab/heat.h"
#include "../../../common/lab/label.h"
#include "../../../common/lab/pixels.h"
#include "../../../common/output.h"
#include "bench.h"
#include "view_work.h"

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

static inline search_work trial_eye_work(const trial_picture *p, real x, real y)
{
    search_work w = {0, 0, 0, 0};
    hit h;
    p->verbs->hit_counted(p->built, trial_eye_ray(p, x, y), &h, &w);
    return w;
}

static inline vec3 trial_work_colour(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    search_work w = trial_eye_work(p, x, y);
    return work_colour((real)(w.nodes + w.tests) / p->most);
}

/* A ray for each square of `block` pixels: a smaller picture, enlarged. */
static inline bool trial_draw_coarse(image *im, int block, int threads, const char *what,
                                     pixels_colour *colour, trial_picture p)
{
    p.width = (im->width + block - 1) / block, p.height = (im->height + block - 1) / block;
    image small = image_new(p.width, p.height);
    bool whole = pixels_draw(&small, 1, threads, what, colour, &p);
    for (int y = 0; y < im->height; y++)
        for (int x = 0; x < im->width; x++)
            image_set(im, x, y, image_get(&small, x * p.width / im->width,
                                          y * p.height / im->height));
    image_free(&small);
    return whole;
}

/* *side: rays along each side of a pixel, as wanted, and as they were. */
static inline bool trial_draw(image *im, int *side, int threads, const char *what,
                              pixels_colour *colour, trial_picture p)
{
    double tests = view_tests(p.verbs->hit_counted, p.built, p.camera, im->width, im->height);
    double some = *side * sqrt(view_share(tests));
    int wanted = *side * *side, block = (int)ceil(1 / some);
    if (some >= *side) return pixels_draw(im, *side, threads, what, colour, &p);
    *side = some > 1 ? (int)some : 1;
    printf("# %s: a ray takes %.3g tests: ", what, tests);
    if (block == 1) printf("%d a pixel instead of %d\n", *side * *side, wanted);
    else printf("one for %d x %d pixels instead of %d a pixel\n", block, block, wanted);
    return block == 1 ? pixels_draw(im, *side, threads, what, colour, &p)
                      : trial_draw_coarse(im, block, threads, what, colour, p);
}

typedef struct {
    const trial_scene *s;
    const trial_verbs *verbs;
    const void *how;
    camera camera;
    real most;
    int samples;  /* along each side of a pixel */
    pixels_colour *colour;
} trial_panel;

typedef struct { trial_row *row; const trial_panel *panel; } trial_builds;

static inline void trial_build_one(size_t i, void *builds)
{
    trial_builds *b = builds;
    trial_build(&b->row[i], b->panel[i].s);
}

/* At most 16 panels. any: of a mesh that may be anyone's: trial_draw. */
static inline bool trial_draw_panels(image *all, int columns, int rows, int gap,
                                     const trial_panel *panel, bool any, int threads)
{
    int w = (all->width + gap) / columns - gap, h = (all->height + gap) / rows - gap;
    int n = columns * rows;
    image im = image_new(w > 1 ? w : 1, h > 1 ? h : 1);
    bool whole = true;
    trial_row row[16];
    trial_builds builds = {row, panel};
    for (int k = 0; k < n; k++) row[k] = (trial_row){.verbs = panel[k].verbs, .how = panel[k].how};
    parallel_whole((size_t)n, threads, "building", trial_build_one, &builds);
    label_fill(all, 0, 0, all->width, all->height, vec(1, 1, 1));
    for (int k = 0; k < n; k++) {
        const trial_panel *p = &panel[k];
        trial_picture place = {p->verbs, row[k].built, &p->s->m, p->camera, im.width, im.height,
                               p->most};
        int side = p->samples;
        if (whole) {  /* Ctrl-C stops all of them, not the one in hand */
            whole = any ? trial_draw(&im, &side, threads, "picture", p->colour, place)
                        : pixels_draw(&im, side, threads, "picture", p->colour, &place);
            image_place(all, k % columns * (w + gap), k / columns * (h + gap), &im);
        }
        trial_unbuild(&row[k]);
    }
    image_free(&im);
    return whole;
}

static inline void trial_label_work(image *all, int columns, int rows, const char *const *title,
                                    real most, const char *what)
{
    enum { bar = 44 };
    label_titles(all, columns, rows, 0, title), label_below(all, bar);
    label_bar(all, all->width / 4, all->height - bar + 6, all->width / 2, 9, work_colour, 0, most,
              what);
}

/* verbs, most: of p; the mesh of s; camera: z up or y; n [1, 16]. */
static inline bool trial_draw_work(const trial_scene *s, trial_picture p, bool z_up, int across,
                                   const void *const *how, int n, int threads, image *all)
{
    vec3 lo, hi;
    trial_panel panel[16];
    int down = (n + across - 1) / across, w = all->width / across, h = all->height / down;
    mesh_bounds(&s->m, &lo, &hi);
    camera c = camera_of(lo, hi, z_up, (real)(w > 1 ? w : 1) / (real)(h > 1 ? h : 1));
    for (int k = 0; k < n; k++)
        panel[k] = (trial_panel){s, p.verbs, how[k], c, p.most, 1, trial_work_colour};
    return trial_draw_panels(all, across, down, 0, panel, true, threads);
}

static inline void trial_draw_mesh(const options *o, const trial_scene *s, const trial_verbs *v,
                                   const void *how, bool z_up, const char *book, const char *path)
{
    char name[512];
    vec3 lo, hi;
    int samples = o->quick ? 1 : 3;
    image im = image_new(o->width, o->height);
    trial_row r = {.verbs = v, .how = how};
    trial_time_build(&r, s, 1);
    mesh_bounds(&s->m, &lo, &hi);
    camera c = camera_of(lo, hi, z_up, (real)o->width / (real)o->height);
    trial_picture p = {v, r.built, &s->m, c, o->width, o->height, 0};
    double start = clock_seconds();
    bool whole = trial_draw(&im, &samples, o->threads, "picture", trial_mesh_colour, p);
    printf("# %zu triangles: built in %.3f s, %d x %d pixels of %d rays in %.3f s\n",
           s->m.triangles, r.build, o->width, o->height, samples * samples,
           clock_seconds() - start);
    output_picture(o, &im, picture_name(book, path, name), true, whole);
    trial_unbuild(&r), image_free(&im);
}

#endif
