/* pictures.h: the two spheres; the tank, naively and well.
 *
 *   draw_two_spheres(&o, all) the main picture, and what rays it took
 *   draw_tank(&o)             left: faces that touch taken one by one; right: as one
 */
#ifndef WHITTED_LAB_PICTURES_H
#define WHITTED_LAB_PICTURES_H

#include "../../../common/lab/panels.h"
#include "../../18_shade/trials/traced_view.h"
#include "tank.h"
#include "two_spheres.h"

/* ---------------------------------------------------------------------------------------------- */

static vec3 whitted_from_air(tracer *t, ray r) { return whitted_ray(t, r, (media_set){0}); }
static vec3 whitted_along(tracer *t, const ray *r) { return whitted_from_air(t, *r); }

static inline traced_view whitted_view(const whitted_stage *s, camera c, int w, int h)
{
    return (traced_view){.t = stage_tracer(s), .along = whitted_along, .c = c, .width = w,
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
    bool whole = pixels_draw(&im, pixels_side(o->samples), o->threads, "drawing", traced_colour,
                             &v);
    printf("# two spheres:");
    for (int k = 0; k < RAY_SIGHT; k++)
        printf(" %zu %s rays%s", n.rays[k], ray_kind_names[k], k + 1 < RAY_SIGHT ? "," : ";");
    printf(" %.2f s\n", clock_seconds() - start);
    output_picture(o, &im, "19_whitted.png", true, whole);
    image_free(&im), stage_end(s), free(s);
}

cold_inline void draw_tank(const options *o)
{
    enum { gap = 6 };
    int w = o->quick ? 96 : 320, h = w * 3 / 4;
    whitted_stage *k = tank_new();
    whitted naive = k->w;
    traced_view v[2] = {whitted_view(k, tank_camera((real)4 / 3), w, h)};
    const panel p[2] = {{"each face by itself", &v[0]}, {"faces at one place as one", &v[1]}};
    v[1] = v[0], v[0].t.user = &naive, naive.apart = true;
    panels_draw(o, "19_whitted_tank.png", false,
                (panels_shape){2 * w + gap, h, 2, 1, gap, o->quick ? 1 : 2, false}, traced_colour,
                p);
    stage_end(k), free(k);
}

#endif
