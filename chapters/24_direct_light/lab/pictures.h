/* pictures.h: direct light, a picture at a time, and several side by side.
 *
 *   direct_view v = {&g, way, LIGHTS_ALL, SEQUENCE_SOBOL, n, seed};
 *   bool whole = direct_render(&v, &im, threads);    n samples a pixel, each with a camera ray
 *
 *   draw_stage(o, name, way, file)   the main picture
 *   draw_plates(o)   BRDF, lights, both: the same number of rays
 *   draw_equal(o)    table and pictures: five ways in the same time
 *   draw_strip(o)    a light that touches the floor, by area and by angle
 *   draw_hall(o)     one of sixteen lights, or all
 */
#ifndef DIRECT_PICTURES_H
#define DIRECT_PICTURES_H

#include "../../../common/lab/label.h"
#include "../../../common/lab/report.h"
#include "../../../common/parallel.h"
#include "../direct.h"
#include "scenes.h"

typedef struct {
    const direct_stage *g;
    direct_way way;
    direct_lights_kind kind;
    sequence_kind sequence;
    uint32_t n;
    uint64_t seed;
} direct_view;

/* ---------------------------------------------------------------------------------------------- */

typedef struct { const direct_view *v; const direct_lights *l; image *im; } direct_sheet;

static inline void direct_pixel(int x, int y, void *context)
{
    const direct_sheet *k = context;
    const direct_view *v = k->v;
    vec3 sum = {0, 0, 0};
    direct_work work = {0, 0, 0};
    direct d = {&v->g->s, v->way, k->l, &work, false};
    uint64_t pixel = (uint64_t)y * (uint64_t)k->im->width + (uint64_t)x;
    for (uint32_t i = 0; i < v->n; i++) {
        sampler s = sampler_start(v->sequence, v->seed, pixel, i, v->n);
        point2 p = sampler_pair(&s);
        ray r = camera_ray(v->g->c, (real)x + p.u, (real)y + p.v, k->im->width, k->im->height);
        lit_hit h;
        if (!lit_trace(&v->g->s, r, &h)) continue;
        vec3 L = direct_light(&d, &h, vneg(vunit(r.d)), &s);
        sum = vadd(sum, vadd(L, lit_emitted(&h)));
    }
    image_set(k->im, x, y, vscale(sum, v->g->exposure / (real)v->n));
}

static inline bool direct_render(const direct_view *v, image *im, int threads)
{
    direct_lights l;
    direct_lights_build(&v->g->s, v->kind, &l);
    direct_sheet k = {v, &l, im};
    bool whole = parallel_pixels(im->width, im->height, threads, "direct light", direct_pixel, &k);
    direct_lights_free(&l);
    return whole;
}

/* Panels of one height, 4 pixels of white between them, each with its title. */
static inline bool draw_panels(const options *o, const direct_view *v, int n, int width,
                               const char *name, const char *const *title, double *seconds,
                               image *panels)
{
    int across = o->quick ? width / 10 : width, gap = o->quick ? 1 : 4;
    int down = (int)((real)across / v->g->aspect);
    image sheet = image_new(n * across + (n - 1) * gap, down);
    bool whole = true;
    for (int k = 0; k < n && whole; k++) {
        image im = image_new(across, down);
        double start = clock_seconds();
        whole = direct_render(&v[k], &im, o->threads);
        if (seconds) seconds[k] = clock_seconds() - start;
        image_place(&sheet, k * (across + gap), 0, &im);
        if (panels) panels[k] = im;
        else image_free(&im);
    }
    image titled = label_panels(&sheet, n, 1, gap, title);
    output_picture(o, &titled, name, false, whole);
    image_free(&sheet), image_free(&titled);
    return whole;
}

/* The main picture: one stage, one way. */
static inline void draw_stage(const options *o, direct_stage_name name, direct_way way,
                              const char *file)
{
    direct_stage g;
    stage_open(name, &g);
    image im = image_new(o->width, o->height);
    g.c = stage_camera_of(name, (real)o->width / (real)o->height);
    direct_view v = {&g, way, LIGHTS_ALL, SEQUENCE_SOBOL, (uint32_t)o->samples, o->seed};
    bool whole = direct_render(&v, &im, o->threads);
    output_picture(o, &im, file, true, whole);
    image_free(&im), stage_close(&g);
}

/* RMSE of the pixels that show no light, and are not next to one that does. */
static inline double unlit_error(const image *im, const image *reference)
{
    double square = 0;
    size_t n = 0;
    for (int y = 1; y < im->height - 1; y++)
        for (int x = 1; x < im->width - 1; x++) {
            bool lit = false;
            for (int k = 0; k < 9; k++)
                lit = lit || image_get(reference, x + k % 3 - 1, y + k / 3 - 1).x > 1;
            if (lit) continue;
            vec3 off = vsub(image_get(im, x, y), image_get(reference, x, y));
            square += (double)vdot(off, off) / 3, n++;
        }
    return n ? sqrt(square / (double)n) : 0;
}

/* How many samples take the same time, as measured: see the table that is printed. Fixed, so that
 * the picture is the same on every machine. */
static inline void draw_equal(const options *o)
{
    enum { n = 5 };
    static const direct_way way[n] = {DIRECT_UNIFORM, DIRECT_COSINE, DIRECT_AREA, DIRECT_ANGLE,
                                      DIRECT_POWER};
    static const uint32_t samples[n] = {16, 16, 16, 10, 7};
    static const char *const title[n] = {"uniform, 16", "cosine, 16", "by area, 16",
                                         "by angle, 10", "power, 7"};
    direct_stage g;
    direct_view v[n];
    double seconds[n];
    image im[n];
    stage_open(STAGE_BOX, &g);
    for (int k = 0; k < n; k++)
        v[k] = (direct_view){&g, way[k], LIGHTS_ALL, SEQUENCE_RANDOM, samples[k], o->seed};
    if (draw_panels(o, v, n, 192, "24_direct_light_equal.png", title, seconds, im)) {
        image reference = image_new(im[0].width, im[0].height);
        direct_view best = {&g, DIRECT_ANGLE, LIGHTS_ALL, SEQUENCE_SOBOL, o->quick ? 16 : 128,
                            o->seed + 1};
        direct_render(&best, &reference, o->threads);
        table t = table_new("The box in the same time (panels from left to right)",
                            "way|samples a pixel|time [s]|error RMSE");
        for (int k = 0; k < n; k++) {
            table_text(&t, "%s", direct_name[way[k]]), table_count(&t, samples[k]);
            table_number(&t, seconds[k]), table_number(&t, unlit_error(&im[k], &reference));
            image_free(&im[k]);
        }
        output_extra_table(o, &t);
        image_free(&reference);
    }
    stage_close(&g);
}

/* One stage, several ways, one kind of choice among the lights each. */
static inline void draw_ways(const options *o, direct_stage_name name, direct_view *v, int n,
                             int width, const char *file, const char *const *title)
{
    direct_stage g;
    stage_open(name, &g);
    for (int k = 0; k < n; k++) v[k].g = &g, v[k].seed = o->seed;
    draw_panels(o, v, n, width, file, title, NULL, NULL);
    stage_close(&g);
}

/* One ray for a sample by directions or by one light, two for both: half the samples. */
static inline void draw_plates(const options *o)
{
    direct_view v[] = {{.way = DIRECT_BRDF, .kind = LIGHTS_UNIFORM, SEQUENCE_SOBOL, 16, 0},
                       {.way = DIRECT_ANGLE, .kind = LIGHTS_UNIFORM, SEQUENCE_SOBOL, 16, 0},
                       {.way = DIRECT_POWER, .kind = LIGHTS_UNIFORM, SEQUENCE_SOBOL, 8, 0}};
    static const char *const title[] = {"directions of the BRDF, 16", "points of a light, 16",
                                        "both, power heuristic, 8"};
    draw_ways(o, STAGE_PLATES, v, 3, 400, "24_direct_light_plates.png", title);
}

static inline void draw_strip(const options *o)
{
    direct_view v[] = {{.way = DIRECT_AREA, .kind = LIGHTS_ALL, SEQUENCE_RANDOM, 16, 0},
                       {.way = DIRECT_ANGLE, .kind = LIGHTS_ALL, SEQUENCE_RANDOM, 10, 0}};
    static const char *const title[] = {"by area, 16 samples", "by solid angle, 10 samples"};
    draw_ways(o, STAGE_STRIP, v, 2, 480, "24_direct_light_strip.png", title);
}

static inline void draw_hall(const options *o)
{
    direct_view v[] = {{.way = DIRECT_AREA, .kind = LIGHTS_ALL, SEQUENCE_RANDOM, 1, 0},
                       {.way = DIRECT_AREA, .kind = LIGHTS_UNIFORM, SEQUENCE_RANDOM, 9, 0},
                       {.way = DIRECT_AREA, .kind = LIGHTS_FLUX, SEQUENCE_RANDOM, 9, 0}};
    static const char *const title[] = {"all lamps, 1 sample", "one lamp by 1/n, 9",
                                        "one lamp by flux, 9"};
    draw_ways(o, STAGE_HALL, v, 3, 320, "24_direct_light_hall.png", title);
}

#endif
