/* pictures.h: the pictures of this chapter.
 *
 *   draw_spheres(o)   one light around, seven roughnesses from 0 to 1 (columns), the same number of
 *                     samples; rows: uniform, cosine, BRDF sampling, and that with 64 Sobol' points
 *   plot_lobes(o)     f cos as a curve, in the plane of n and wo, at 45 degrees: as far from the
 *                     origin as light goes that way
 */
#ifndef BRDF_LAB_PICTURES_H
#define BRDF_LAB_PICTURES_H

#include "../../../common/lab/panels.h"
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
typedef struct { const options *o; int row, across, down; uint32_t samples; } ball_row;

/* Each pixel by itself: the camera looks along y at spheres of radius 1. */
static inline vec3 ball_place(const void *context, real x, real y)
{
    static const vec3 ground = {0.9, 0.9, 0.9}, f0 = {0.95, 0.85, 0.7}, wo = {0, -1, 0};
    const ball_row *b = context;
    int column = b->across ? (int)x / b->across : ball_columns;
    if (column >= ball_columns) return ground;
    brdf metal = brdf_ggx(f0, (real)column / (ball_columns - 1));
    bool spread = b->row == 3;
    reflection r = {spread ? DIRECTIONS_BRDF : (direction_choice)b->row, false, 0};
    uint64_t pixel = (uint64_t)(b->row * b->down + (int)y) * (uint64_t)b->o->width + (uint64_t)x;
    vec3 sum = {0, 0, 0};
    for (uint32_t k = 0; k < b->samples; k++) {
        sampler s = sampler_start(spread ? SEQUENCE_SOBOL : SEQUENCE_RANDOM, b->o->seed, pixel, k,
                                  b->samples);
        point2 p = sampler_pair(&s);
        real px = (2 * (floor(x) - (real)(column * b->across) + p.u) / (real)b->across - 1)
                * (real)1.06;
        real pz = (1 - 2 * (floor(y) + p.v) / (real)b->down) * (real)1.06, rr = px * px + pz * pz;
        if (rr >= 1) { sum = vadd(sum, ground); continue; }
        shading_frame f = shading_frame_of((vec3){px, -sqrt(1 - rr), pz});
        sum = vadd(sum, reflection_term(&r, &metal, f, to_local(f, wo), sky_and_ground,
                                        sampler_pair(&s)));
    }
    return vscale(sum, 1 / (real)b->samples);
}

cold_inline void draw_spheres(const options *o)
{
    bool words = o->width >= 600 && o->height >= 300;
    int n = o->samples, spread = o->quick ? 4 : 64;
    panels_shape g = {o->width, o->height, 1, ball_rows, 0, 1, !words};
    char title[ball_rows][64];
    ball_row row[ball_rows];
    panel p[ball_rows];
    snprintf(title[0], sizeof title[0], "%d directions a pixel, uniform; roughness 0 to 1", n);
    snprintf(title[1], sizeof title[1], "%d by the cosine", n);
    snprintf(title[2], sizeof title[2], "%d as the surface reflects", n);
    snprintf(title[3], sizeof title[3], "the same, %d well spread", spread);
    for (int k = 0; k < ball_rows; k++) {
        row[k] = (ball_row){o, k, o->width / ball_columns, panels_high(g),
                            (uint32_t)(k == 3 ? spread : n)};
        p[k] = (panel){title[k], &row[k]};
    }
    panels_draw(o, "23_brdf.png", true, g, ball_place, p);
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
