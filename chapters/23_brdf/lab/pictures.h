/* pictures.h: the pictures of this chapter.
 *
 *   draw_spheres(o)   one light around, seven roughnesses from 0 to 1 (columns), the same number of
 *                     samples; rows: uniform, cosine, BRDF sampling, and BRDF sampling converged
 *   draw_lobes(o)     f cos as a surface: as far from the origin as light goes that way. The stick
 *                     points to where the light comes from; columns: five BRDFs, rows: 30, 60, 80
 *                     degrees
 *   plot_lobes(o)     the same in the plane of n and wo, 45 degrees
 */
#ifndef BRDF_LAB_PICTURES_H
#define BRDF_LAB_PICTURES_H

#include "../../../common/lab/pixels.h"
#include "../../../common/lab/report.h"
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

enum { sphere_columns = 7, sphere_rows = 4 };
typedef struct {
    image *im;
    const options *o;
    uint32_t samples, converged;
    bool ask_all;  /* the light from directions that bring nothing, too: the same picture */
} brdf_spheres;

static inline void sphere_pixel(int x, int y, void *context)
{
    const brdf_spheres *sheet = context;
    int across = sheet->im->width / sphere_columns, down = sheet->im->height / sphere_rows;
    int column = across ? x / across : sphere_columns, row = down ? y / down : sphere_rows;
    vec3 sum = {0.9, 0.9, 0.9}, f0 = {0.95, 0.85, 0.7};
    if (column < sphere_columns && row < sphere_rows) {
        brdf b = brdf_ggx(f0, (real)column / (sphere_columns - 1));
        uint32_t n = row == 3 ? sheet->converged : sheet->samples;
        sequence_kind kind = row == 3 ? SEQUENCE_SOBOL : SEQUENCE_RANDOM;
        reflection r = {row == 3 ? DIRECTIONS_BRDF : (direction_choice)row, sheet->ask_all, 0};
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

static inline void draw_spheres(const options *o)
{
    image im = image_new(o->width, o->height);
    brdf_spheres sheet = {&im, o, (uint32_t)o->samples, o->quick ? 4 : 256, false};
    bool whole = parallel_pixels(o->width, o->height, o->threads, "spheres", sphere_pixel, &sheet);
    output_picture(o, &im, "23_brdf.png", true, whole);
    image_free(&im);
}

/* ---- lobes ---- */

enum { lobe_columns = 5, lobe_rows = 3 };
static const char *const lobe_name[lobe_columns] = {"Lambert", "Blinn-Phong 30", "GGX 1", "GGX .6",
                                                     "GGX .4"};

static inline brdf lobe_brdf(int column)
{
    vec3 white = {1, 1, 1}, half = {0.5, 0.5, 0.5};
    if (column == 0) return brdf_lambert(white);
    if (column == 1) return brdf_blinn_phong(half, half, 30);
    return brdf_ggx(white, column == 2 ? 1 : column == 3 ? (real)0.6 : (real)0.4);
}

static inline vec3 lobe_view(int degrees)
{
    real a = (real)degrees * pi / 180;
    return (vec3){-sin(a), 0, cos(a)};
}

typedef struct { brdf b; vec3 wo; real scale; } brdf_lobe;

/* Negative inside: how far p lies beyond the surface. */
static inline real lobe_beyond(const brdf_lobe *l, vec3 p)
{
    real r = vlength(p);
    if (p.z <= 0) return r;
    vec3 w = vscale(p, 1 / (r > 0 ? r : 1));
    return r - l->scale * brdf_value_local(&l->b, w, l->wo).x * real_max(w.z, 0);
}

/* The largest f cos in the plane of incidence, so that every lobe reaches as far as 1. */
static inline real lobe_scale(const brdf_lobe *l)
{
    real most = 0;
    for (int i = 1; i < 900; i++) {
        real a = ((real)i / 900 - (real)0.5) * pi;
        vec3 w = {sin(a), 0, cos(a)};
        most = real_max(most, brdf_value_local(&l->b, w, l->wo).x * w.z);
    }
    return 1 / most;
}

static inline bool lobe_hit(const brdf_lobe *l, vec3 o, vec3 d, real t0, real t1, real *t)
{
    enum { steps = 60 };
    real before = t0;
    for (int i = 1; i <= steps; i++) {
        real now = t0 + (t1 - t0) * (real)i / steps;
        if (lobe_beyond(l, vmadd(o, d, now)) < 0) {
            for (int k = 0; k < 20; k++) {
                real mid = (before + now) / 2;
                if (lobe_beyond(l, vmadd(o, d, mid)) < 0) now = mid;
                else before = mid;
            }
            *t = now;
            return true;
        }
        before = now;
    }
    return false;
}

static inline vec3 lobe_normal(const brdf_lobe *l, vec3 p)
{
    real h = 1e-3, g = lobe_beyond(l, p);
    return vunit((vec3){lobe_beyond(l, (vec3){p.x + h, p.y, p.z}) - g,
                        lobe_beyond(l, (vec3){p.x, p.y + h, p.z}) - g,
                        lobe_beyond(l, (vec3){p.x, p.y, p.z + h}) - g});
}

/* The distance between the ray and the stick from 0 to 1.1 wo; *t along the ray. */
static inline real stick_distance(vec3 o, vec3 d, vec3 wo, real *t)
{
    real dw = vdot(d, wo), q = 1 - dw * dw;
    real s = q > 0 ? (vdot(o, wo) - dw * vdot(o, d)) / q : 0;
    s = real_clamp(s, 0, 1.1);
    *t = s * dw - vdot(o, d);
    return vlength(vsub(vmadd(o, d, *t), vscale(wo, s)));
}

static inline vec3 lobe_ray(const brdf_lobe *l, vec3 o, vec3 d)
{
    vec3 c = {1, 1, 1};
    real nearest = real_infinity, t, disk = -o.z / d.z, od = vdot(o, d);
    vec3 p = vmadd(o, d, disk);
    if (disk > 0 && vdot(p, p) < (real)1.21) {
        bool ring = fabs(vlength(p) - 1) < (real)0.012;
        nearest = disk, c = vscale(c, ring ? (real)0.45 : (real)0.78);
    }
    if (stick_distance(o, d, l->wo, &t) < (real)0.022 && t < nearest)
        nearest = t, c = vec(0.67, 0.11, 0);
    real inside = od * od - vdot(o, o) + (real)1.02;
    if (inside <= 0) return c;
    real t0 = -od - sqrt(inside), t1 = real_min(-od + sqrt(inside), nearest);
    if (t1 > t0 && lobe_hit(l, o, d, t0, t1, &t)) {
        vec3 n = lobe_normal(l, vmadd(o, d, t));
        vec3 lamp = vunit(vec(-0.2, -0.7, 0.7));
        real shade = (real)0.25 + (real)0.75 * real_max(vdot(n, lamp), 0);
        c = vscale(vec(0.05, 0.35, 0.75), shade);
    }
    return c;
}

typedef struct { int side; brdf_lobe lobes[lobe_rows][lobe_columns]; } brdf_lobes;

static inline vec3 lobe_colour(const void *context, real x, real y)
{
    const brdf_lobes *sheet = context;
    int side = sheet->side, column = (int)x / side, row = (int)y / side;
    vec3 d = vunit(vec(0, 1, -0.42)), right = {1, 0, 0}, up = vcross(right, d);
    real px = (x - (real)(column * side)) / (real)side, py = (y - (real)(row * side)) / (real)side;
    vec3 o = vscale(right, (2 * px - 1) * (real)1.2);
    o = vmadd(o, up, (1 - 2 * py) * (real)1.2 + (real)0.35);
    return lobe_ray(&sheet->lobes[row][column], vmadd(o, d, -4), d);
}

static inline void draw_lobes(const options *o)
{
    if (o->out) return;
    const int side = 180;
    image im = image_new(lobe_columns * side, lobe_rows * side);
    brdf_lobes sheet = {.side = side};
    for (int row = 0; row < lobe_rows; row++)
        for (int column = 0; column < lobe_columns; column++) {
            brdf_lobe *l = &sheet.lobes[row][column];
            *l = (brdf_lobe){lobe_brdf(column), lobe_view(row == 0 ? 30 : row == 1 ? 60 : 80), 0};
            l->scale = lobe_scale(l);
        }
    bool whole = pixels_draw(&im, 2, o->threads, "lobes", lobe_colour, &sheet);
    output_picture(o, &im, "23_brdf_lobes.png", false, whole);
    image_free(&im);
}

static inline void plot_lobes(const options *o)
{
    plot p = plot_new("f cos over its largest; light at 45 degrees from the left",
                      "along the surface", "along n", 0);
    for (int k = 0; k < lobe_columns; k++) {
        brdf_lobe l = {lobe_brdf(k), lobe_view(45), 0};
        char name[48];
        l.scale = lobe_scale(&l);
        snprintf(name, sizeof name, "%s, up to %.2f / sr", lobe_name[k], 1 / (double)l.scale);
        int s = plot_series(&p, name);
        for (int i = 0; i <= 72; i++) {
            real a = ((real)i / 72 - (real)0.5) * pi;
            vec3 w = {sin(a), 0, cos(a)};
            double f = (double)(l.scale * brdf_value_local(&l.b, w, l.wo).x * w.z);
            plot_add(&p, s, f * (double)w.x, f * (double)w.z);
        }
    }
    output_plot(o, &p, "23_brdf_polar.svg");
}

#endif
