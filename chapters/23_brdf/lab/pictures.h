/* pictures.h: the pictures of this chapter.
 *
 *   draw_spheres(o)   one light around, seven roughnesses from 0 to 1 (columns), the same number of
 *                     samples; rows: uniform, cosine, BRDF sampling, and that with 64 Sobol' points
 *   plot_lobes(o)     f cos as a curve, in the plane of n and wo, at 45 degrees: as far from the
 *                     origin as light goes that way
 */
#ifndef BRDF_LAB_PICTURES_H
#define BRDF_LAB_PICTURES_H

#include "../../../common/lab/label.h"
#include "../../../common/lab/report.h"
#include "../../../common/output.h"
#include "../../../common/parallel.h"
#include "../reflection.h"

/* ---- the light around: a sky, a sun with a glow, a chequered ground ---- */

static inline vec3 chequered_ground(vec3 w)
{
    real x = w.x / -w.z, y = w.y / -w.z, fog = exp(-(x * x + y * y) / 60);
    bool dark = ((int)floor(x * (real)0.8) + (int)floor(y * (real)0.8)) % 2;
    vec3 tile = dark ? vec(0.07, 0.05, 0.04)
                     : vec(0.42, 0.36, 0.28);
    vec3 far = {0.35, 0.36, 0.38};
    return vmadd(vscale(far, 1 - fog), tile, fog);
}

static inline vec3 sky_and_ground(vec3 w)
{
    static const vec3 horizon = {0.75, 0.80, 0.85};
    static const vec3 zenith = {0.10, 0.22, 0.52};
    if (w.z < 0) return chequered_ground(w);
    real sun = vdot(w, vunit(vec(-0.55, -0.55, 0.65))), t = sqrt(w.z);
    vec3 sky = vmadd(vscale(horizon, 1 - t), zenith, t);
    return vmadd(sky, vec(1, 0.9, 0.75), 10 * exp(60 * (sun - 1)));
}

/* ---- spheres ---- */

enum { ball_columns = 7, ball_rows = 4 };
typedef struct {
    image *im;
    const options *o;
    uint32_t samples, well_spread;
} brdf_spheres;

static inline void sphere_pixel(int x, int y, void *context)
{
    const brdf_spheres *sheet = context;
    int across = sheet->im->width / ball_columns, down = sheet->im->height / ball_rows;
    int column = across ? x / across : ball_columns, row = down ? y / down : ball_rows;
    vec3 sum = {0.9, 0.9, 0.9}, f0 = {0.95, 0.85, 0.7};
    if (column < ball_columns && row < ball_rows) {
        brdf b = brdf_ggx(f0, (real)column / (ball_columns - 1));
        uint32_t n = row == 3 ? sheet->well_spread : sheet->samples;
        sequence_kind kind = row == 3 ? SEQUENCE_SOBOL : SEQUENCE_RANDOM;
        reflection r = {row == 3 ? DIRECTIONS_BRDF : (direction_choice)row, false, 0};
        uint64_t pixel = (uint64_t)y * (uint64_t)sheet->im->width + (uint64_t)x;
        vec3 ground = sum, wo = {0, -1, 0};
        sum = (vec3){0, 0, 0};
        for (uint32_t k = 0; k < n; k++) {
            sampler s = sampler_start(kind, sheet->o->seed, pixel, k, n);
            point2 p = sampler_pair(&s);
            real px = (2 * ((real)(x - column * across) + p.u) / (real)across - 1) * (real)1.06;
            real pz = (1 - 2 * ((real)(y - row * down) + p.v) / (real)down) * (real)1.06;
            real rr = px * px + pz * pz;
            if (rr >= 1) { sum = vadd(sum, ground); continue; }
            shading_frame f = shading_frame_of((vec3){px, -sqrt(1 - rr), pz});
            sum = vadd(sum, reflection_term(&r, &b, f, to_local(f, wo), sky_and_ground,
                                            sampler_pair(&s)));
        }
        sum = vscale(sum, 1 / (real)n);
    }
    image_set(sheet->im, x, y, sum);
}

cold_inline void draw_spheres(const options *o)
{
    image im = image_new(o->width, o->height);
    brdf_spheres sheet = {&im, o, (uint32_t)o->samples, o->quick ? 4 : 64};
    bool whole = parallel_pixels(o->width, o->height, o->threads, "spheres", sphere_pixel, &sheet);
    char title[4][64];
    snprintf(title[0], sizeof title[0], "%d directions a pixel, uniform; roughness 0 to 1",
             o->samples);
    snprintf(title[1], sizeof title[1], "%d by the cosine", o->samples);
    snprintf(title[2], sizeof title[2], "%d as the surface reflects", o->samples);
    snprintf(title[3], sizeof title[3], "the same, %d well spread", o->quick ? 4 : 64);
    const char *const names[4] = {title[0], title[1], title[2], title[3]};
    bool labels = o->width >= 600 && o->height >= 300 && o->height % 4 == 0;
    if (labels) label_titles(&im, 1, 4, 0, names);
    output_picture(o, &im, "23_brdf.png", true, whole);
    image_free(&im);
}

/* ---- lobes ---- */

enum { lobes = 5 };
static const char *const lobe_name[lobes] = {"Lambert", "Blinn-Phong 30", "GGX 1", "GGX .6",
                                              "GGX .4"};

static inline brdf lobe_brdf(int k)
{
    vec3 white = {1, 1, 1}, half = {0.5, 0.5, 0.5};
    if (k == 0) return brdf_lambert(white);
    if (k == 1) return brdf_blinn_phong(half, half, 30);
    return brdf_ggx(white, k == 2 ? 1 : k == 3 ? (real)0.6 : (real)0.4);
}

/* From the left, part 0, to the right, 1. */
static inline vec3 lobe_direction(real part)
{
    real a = (part - (real)0.5) * pi;
    return (vec3){sin(a), 0, cos(a)};
}

static inline real lobe_value(const brdf *b, vec3 w)
{
    return brdf_value_local(b, w, vunit(vec(-1, 0, 1))).x * w.z;
}

cold_inline void plot_lobes(const options *o)
{
    plot p = plot_new("f cos over its largest; light at 45 degrees from the left",
                      "along the surface", "along n", 0);
    for (int k = 0; k < lobes; k++) {
        brdf b = lobe_brdf(k);
        real most = 0;  /* every lobe reaches as far as 1 */
        char name[48];
        for (int i = 1; i < 900; i++)
            most = real_max(most, lobe_value(&b, lobe_direction((real)i / 900)));
        snprintf(name, sizeof name, "%s, up to %.2f / sr", lobe_name[k], (double)most);
        int s = plot_series(&p, name);
        for (int i = 0; i <= 72; i++) {
            vec3 w = lobe_direction((real)i / 72);
            double f = (double)(lobe_value(&b, w) / most);
            plot_add(&p, s, f * (double)w.x, f * (double)w.z);
        }
    }
    output_plot(o, &p, "23_brdf_polar.svg");
}

#endif
