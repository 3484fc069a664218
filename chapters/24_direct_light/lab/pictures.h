/* pictures.h: direct light, a picture at a time, and several side by side.
 *
 *   direct_view v = {way, LIGHTS_ALL, SEQUENCE_SOBOL, n, side, seed, &g};
 *   bool whole = direct_render(&v, &im, threads);    n samples a pixel, each with a camera ray;
 *                                    side > 0: light 0 as side x side point lights
 *
 *   draw_box(o)                      the main picture
 *   draw_exhibit(o, &exhibit_points)   a lamp as 1, 4, 16 point lights; 16 points drawn
 *   draw_exhibit(o, &exhibit_plates)   BRDF, lights, both: the same number of rays
 *   draw_exhibit(o, &exhibit_strip)    a light that touches the floor, by area and by angle
 */
#ifndef DIRECT_PICTURES_H
#define DIRECT_PICTURES_H

#include "../../../common/lab/panels.h"
#include "../../../common/lab/report.h"
#include "../../../common/parallel.h"
#include "../direct.h"
#include "scenes.h"

typedef struct {
    direct_way way;
    lit_lights_rule kind;
    sequence_kind sequence;
    uint32_t n, side;
    uint64_t seed;
    const direct_stage *g;
} direct_view;

/* ---------------------------------------------------------------------------------------------- */

/* What side x side point lights bring, the middles of a grid of cells, the same for all points of
 * the scene: samples by area (24.4) whose two numbers are set. *seen: how many of them. */
static inline vec3 point_lights(const direct *d, const lit_hit *h, vec3 wo, uint32_t side,
                                uint32_t *seen)
{
    vec3 sum = {0, 0, 0};
    shading_frame f = shading_frame_of(h->s.ns);
    direct_point x = {h, f, to_local(f, wo)};
    *seen = 0;
    for (uint32_t i = 0; i < side * side; i++) {
        point2 u = {((real)(i % side) + (real)0.5) / (real)side,
                    ((real)(i / side) + (real)0.5) / (real)side};
        vec3 L = direct_from(d, &x, 0, 1, u);
        *seen += !vzero(L);
        sum = vadd(sum, L);
    }
    return vscale(sum, 1 / (real)(side * side));
}

typedef struct { const direct_view *v; const lit_lights *l; image *im; } direct_sheet;

static inline void direct_pixel(int x, int y, void *context)
{
    const direct_sheet *k = context;
    const direct_view *v = k->v;
    vec3 sum = {0, 0, 0};
    direct_work work = {0, 0, 0};
    direct d = {&v->g->s, v->way, k->l, &work, false};
    uint64_t pixel = (uint64_t)y * (uint64_t)k->im->width + (uint64_t)x;
    sampler_keys keys;
    sampler_keys_of(v->sequence, v->seed, pixel, &keys);
    for (uint32_t i = 0; i < v->n; i++) {
        if (parallel_is_stopped()) return;
        sampler s = sampler_of_keys(&keys, i, v->n);
        point2 p = sampler_pair(&s);
        ray r = camera_ray(v->g->c, (real)x + p.u, (real)y + p.v, k->im->width, k->im->height);
        lit_hit h;
        uint32_t seen;
        if (!lit_trace(&v->g->s, r, &h)) continue;
        vec3 wo = vneg(vunit(r.d));
        vec3 L = v->side ? point_lights(&d, &h, wo, v->side, &seen) : direct_light(&d, &h, wo, &s);
        sum = vadd(sum, vadd(L, lit_emitted(&h)));
    }
    image_set(k->im, x, y, vscale(sum, v->g->exposure / (real)v->n));
}

static inline bool direct_render(const direct_view *v, image *im, int threads)
{
    lit_lights l;
    lit_lights_of(&v->g->s, NULL, v->kind, &l);
    direct_sheet k = {v, &l, im};
    bool whole = parallel_pixels(im->width, im->height, threads, "direct light", direct_pixel, &k);
    lit_lights_free(&l);
    return whole;
}

/* The main picture: the box, by solid angle. */
cold_inline void draw_box(const options *o)
{
    direct_stage g;
    stage_open(STAGE_BOX, &g);
    image im = image_new(o->width, o->height);
    g.c = stage_camera_of(STAGE_BOX, (real)o->width / (real)o->height);
    direct_view v = {DIRECT_ANGLE, LIGHTS_ALL, SEQUENCE_SOBOL, (uint32_t)o->samples, 0, o->seed,
                     &g};
    bool whole = direct_render(&v, &im, o->threads);
    output_picture(o, &im, "24_direct_light.png", true, whole);
    image_free(&im), lit_free(&g.s);
}

/* One stage in several ways, side by side, each panel with its title. */
typedef struct {
    direct_stage_name stage;
    const char *file;
    int n, width;  /* of a panel */
    direct_view view[4];
    const char *title[4];
} direct_exhibit;

static const direct_exhibit exhibit_points = {
    STAGE_BOX, "24_direct_light_points.png", 4, 240,
    {{DIRECT_AREA, LIGHTS_ALL, SEQUENCE_SOBOL, 4, 1, 0, NULL},
     {DIRECT_AREA, LIGHTS_ALL, SEQUENCE_SOBOL, 4, 2, 0, NULL},
     {DIRECT_AREA, LIGHTS_ALL, SEQUENCE_SOBOL, 4, 4, 0, NULL},
     {DIRECT_AREA, LIGHTS_ALL, SEQUENCE_RANDOM, 16, 0, 0, NULL}},
    {"1 point light", "4 point lights", "16 point lights", "16 points drawn"}};

/* One ray for a sample by directions or by one light, two for both: half the samples. */
static const direct_exhibit exhibit_plates = {
    STAGE_PLATES, "24_direct_light_plates.png", 3, 400,
    {{DIRECT_BRDF, LIGHTS_UNIFORM, SEQUENCE_SOBOL, 16, 0, 0, NULL},
     {DIRECT_ANGLE, LIGHTS_UNIFORM, SEQUENCE_SOBOL, 16, 0, 0, NULL},
     {DIRECT_POWER, LIGHTS_UNIFORM, SEQUENCE_SOBOL, 8, 0, 0, NULL}},
    {"directions of the BRDF, 16", "points of a light, 16", "both, power heuristic, 8"}};

static const direct_exhibit exhibit_strip = {
    STAGE_STRIP, "24_direct_light_strip.png", 2, 480,
    {{DIRECT_AREA, LIGHTS_ALL, SEQUENCE_RANDOM, 16, 0, 0, NULL},
     {DIRECT_ANGLE, LIGHTS_ALL, SEQUENCE_RANDOM, 10, 0, 0, NULL}},
    {"by area, 16 samples", "by solid angle, 10 samples"}};

cold_inline void draw_exhibit(const options *o, const direct_exhibit *x)
{
    direct_stage g;
    stage_open(x->stage, &g);
    int across = o->quick ? x->width / 10 : x->width, gap = o->quick ? 1 : 4;
    image sheet = {0}, im = image_new(across, (int)((real)across / g.aspect));
    bool whole = true;
    for (int k = 0; k < x->n && whole; k++) {
        direct_view v = x->view[k];
        v.g = &g, v.seed = o->seed;
        whole = direct_render(&v, &im, o->threads);
        label_panel(&sheet, x->n, 1, gap, k, &im);
    }
    panels_save(o, &sheet, x->n, 1, gap, x->title, x->file, whole);
    image_free(&im), lit_free(&g.s);
}

#endif
