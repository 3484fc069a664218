/* traced_view.h: a picture by a tracer, and what rays it took: for 18 and 19.
 *
 *   trace_counts n = {0};
 *   traced_view v = {.t = tracer, .along = f, .c = camera, .width = 800, .height = 450,
 *                    .counts = &n};
 *   pixels_draw(&im, 2, threads, "drawing", traced_colour, &v);    n: rays by kind
 *   panel p = {"a title", &v};        for panels.h, with traced_colour
 *
 *   along       the light along one ray, read where it lies: a copy of the whole, right after it
 *               was written, would wait; the tracer is a copy of t
 *   counts      NULL: nobody counts
 */
#ifndef SHADE_TRACED_VIEW_H
#define SHADE_TRACED_VIEW_H

#include "../../../common/lab/pixels.h"
#include "../../02_camera/camera.h"
#include "../trace.h"

typedef struct {
    tracer t;
    vec3 (*along)(tracer *t, const ray *r);
    camera c;
    int width, height;
    trace_counts *counts;
} traced_view;

/* ---------------------------------------------------------------------------------------------- */

static vec3 traced_colour(const void *view, real x, real y)
{
    static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    const traced_view *v = view;
    tracer t = v->t;
    ray r = camera_ray(v->c, x, y, v->width, v->height);
    vec3 c = v->along(&t, &r);
    if (v->counts) {
        pthread_mutex_lock(&lock);
        trace_counts_add(v->counts, &t.counts);
        pthread_mutex_unlock(&lock);
    }
    return vmin(c, (vec3){4, 4, 4});  /* a highlight must not outshout its pixel */
}

#endif
