/* pictures.h: the two spheres; the tank, naively and well; depths.
 *
 *   draw_two_spheres(&o, all) the main picture, and what rays it took
 *   draw_tank(&o)             left: faces that touch taken one by one; right: as one
 *   draw_depths(&o)           forty balls: depth 1, 2, 3, 8
 */
#ifndef WHITTED_LAB_PICTURES_H
#define WHITTED_LAB_PICTURES_H

#include "../../../common/lab/panels.h"
#include "../../18_shade/trials/traced_view.h"
#include "../scenes/forty.h"
#include "tank.h"
#include "two_spheres.h"

/* ---------------------------------------------------------------------------------------------- */

static vec3 whitted_from_air(tracer *t, ray r) { return whitted_ray(t, r, (media_set){0}); }

static inline traced_view whitted_view(const whitted_stage *s, camera c, int w, int h)
{
    return (traced_view){.t = stage_tracer(s), .ray = whitted_from_air, .c = c, .width = w,
                         .height = h};
}

cold_inline void draw_two_spheres(const options *o, bool spend_all)
{
    whitted_stage *s = two_spheres_new();
    image im = image_new(o->width, o->height);
    trace_counts n = {0};
    traced_view v = whitted_view(s, two_spheres_camera((real)o->width / (real)o->height), o->width,
                                 o->height);
    v.counts = &n, s->w.spend_all = spend_all;
    double start = clock_seconds();
    bool whole = pixels_draw(&im, traced_side(o->samples), o->threads, "drawing", traced_colour,
                             &v);
    printf("# two spheres:");
    for (int k = 0; k < RAY_SIGHT; k++)
        printf(" %zu %s rays%s", n.rays[k], ray_kind_names[k], k + 1 < RAY_SIGHT ? "," : ";");
    printf(" %.2f s\n", clock_seconds() - start);
    output_picture(o, &im, "19_whitted.png", true, whole);
    image_free(&im), stage_end(s), free(s);
}

/* A panel of width w for each `how`, two in a row. Frees s. */
static inline void draw_variants(const options *o, const char *name, whitted_stage *s, camera c,
                                 int w, const whitted *how, const char *const *title, int n)
{
    enum { gap = 6 };
    int h = w * 3 / 4;
    traced_view v[4];
    panel p[4];
    for (int i = 0; i < n; i++) {
        v[i] = whitted_view(s, c, w, h), v[i].t.user = &how[i];
        p[i] = (panel){title[i], &v[i]};
    }
    panels_draw(o, name, false, (panels_shape){2 * w + gap, n / 2 * (h + gap) - gap, 2, n / 2, gap,
                                               o->quick ? 1 : 2, false}, traced_colour, p);
    stage_end(s), free(s);
}

cold_inline void draw_tank(const options *o)
{
    static const char *const title[] = {"each face by itself", "faces at one place as one"};
    whitted_stage *k = tank_new();
    whitted how[2] = {k->w, k->w};
    how[0].apart = true;
    draw_variants(o, "19_whitted_tank.png", k, tank_camera((real)4 / 3), o->quick ? 96 : 320, how,
                  title, 2);
}

cold_inline void draw_depths(const options *o)
{
    static const char *const title[] = {"depth 1", "depth 2: mirrors", "depth 3: glass", "depth 8"};
    whitted_stage *f = forty_new();
    whitted how[4] = {f->w, f->w, f->w, f->w};
    for (int i = 0; i < 3; i++) how[i].depth = i + 1;
    draw_variants(o, "19_whitted_depth.png", f, forty_camera((real)4 / 3), o->quick ? 64 : 360, how,
                  title, 4);
}

#endif
