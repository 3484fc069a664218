/* povray.h: the forty balls in the language of POV-Ray 3.7, and the time that they take here:
 * lab/povray.sh runs both in turn.
 *
 *   povray_race(path)     writes the scene; draws 480 x 360, one ray a pixel, by one thread, and
 *                         prints the seconds of the processor
 *
 * The same rays, but for a few: depth 8, cut at 1/256, exact Fresnel, glass without shadow.
 */
#ifndef WHITTED_LAB_POVRAY_H
#define WHITTED_LAB_POVRAY_H

#include "../../../common/file.h"
#include "../scenes/forty.h"
#include "pictures.h"
#include <time.h>

/* ---------------------------------------------------------------------------------------------- */

/* Of the ground; then by turns mirror, glass, paint. */
static const char *const povray_look[] = {
    "pigment{checker rgb .3 rgb .8} finish{diffuse 1 ambient .1}}\n",
    "pigment{rgb 0} finish{diffuse 0 ambient 0 reflection{.9}}}\n",
    ("pigment{rgbt 1} finish{diffuse 0 ambient 0 reflection{0,1 fresnel on} conserve_energy} "
     "interior{ior 1.5} no_shadow}\n")};

/* The field of view is ours from top to bottom, theirs from left to right. */
static inline void povray_write(const whitted_stage *w, FILE *f)
{
    const double unit = 3.14159265358979 / 180, half = atan(tan(15.5 * unit) * 4 / 3);
    fprintf(f, "#version 3.7; "
               "global_settings{assumed_gamma 1 max_trace_level 8 adc_bailout 1/256}\n"
               "background{rgb<.35,.55,.85>}\n"
               "camera{location<0,-11,4.5> up z right -4/3*x sky z angle %.9g look_at<0,.4,.9>}\n",
            2 * half / unit);
    for (int k = 0; k < 3; k++) {
        vec3 at = w->light[k].at;
        fprintf(f, "light_source{<%.9g,%.9g,%.9g>*1e6 rgb %.9g/pi parallel point_at 0}\n",
                (double)at.x, (double)at.y, (double)at.z, (double)w->light[k].colour.x);
    }
    for (int k = 0; k < forty_balls; k++) {
        sphere s = w->shape[k].sphere;
        vec3 kd = w->look[k].base.kd;
        fprintf(f, "sphere{<%.9g,%.9g,%.9g>,%.9g ", (double)s.c.x, (double)s.c.y, (double)s.c.z,
                (double)s.r);
        if (k % 3 || k == 0) fputs(povray_look[k % 3], f);
        else fprintf(f, "pigment{rgb<%.9g,%.9g,%.9g>} finish{diffuse 1 ambient .1}}\n",
                     (double)kd.x, (double)kd.y, (double)kd.z);
    }
}

cold_inline void povray_race(const char *path)
{
    whitted_stage *w = forty_new();
    file_writer out;
    failure f;
    if (!file_begin(&out, path, &f)) fail(f);
    povray_write(w, out.stream);
    if (!file_commit(&out, &f)) fail(f);
    image im = image_new(480, 360);
    trace_counts n = {0};
    traced_view v = whitted_view(w, forty_camera((real)4 / 3), im.width, im.height);
    clock_t start = clock();
    pixels_draw(&im, 1, 1, "drawing", traced_colour, &v);
    double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    v.counts = &n;  /* once more: a pixel's counts are added behind a lock, for many threads */
    pixels_draw(&im, 1, 1, "counting", traced_colour, &v);
    printf("forty balls: %zu shadow rays, %.4f CPU-seconds\n", n.rays[RAY_SHADOW], seconds);
    image_free(&im), stage_end(w), free(w);
}

#endif
