/* pictures.h: the gallery; its shadows far from the origin; the edge of light on a mesh.
 *
 *   draw_gallery(&o, spend_all)        the main picture, and what rays it took
 *   draw_acne(&o)                      two views at T = 1e4: naive, mended
 *   draw_tilt(&o)                      the same light on a patch that is tilted (drawing)
 *   draw_terminator(&o)                a ball of few triangles, smoothed: lit as it is, and lifted
 */
#ifndef SHADE_LAB_PICTURES_H
#define SHADE_LAB_PICTURES_H

#include "../../../common/lab/figure.h"
#include "../../../common/lab/panels.h"
#include "../../07_mesh/scenes/specimens.h"
#include "terminator.h"
#include "gallery.h"
#include "leave_variants.h"

typedef struct { mesh m; world_part part; trace_world w; light sun; } edge_ball;

/* ---------------------------------------------------------------------------------------------- */

cold_inline void draw_gallery(const options *o, bool spend_all)
{
    gallery *g = gallery_new(o->quick ? 6 : 24, 0);
    image im = image_new(o->width, o->height);
    shading how = gallery_shading(g);
    trace_counts rays = {0};
    traced_view v = gallery_view(g, &how, o->width, o->height, false);
    v.counts = &rays, how.spend_all = spend_all;
    double start = clock_seconds();
    bool whole = pixels_draw(&im, pixels_side(o->samples), o->threads, "drawing", traced_colour,
                             &v);
    printf("# %zu camera rays, %zu hits; %zu shadow rays, %zu of them stopped; %.2f s\n",
           rays.rays[RAY_CAMERA], rays.hits[RAY_CAMERA], rays.rays[RAY_SHADOW],
           rays.hits[RAY_SHADOW], clock_seconds() - start);
    output_picture(o, &im, "18_shade.png", true, whole);
    image_free(&im), gallery_free(g);
}

/* The hit point as a program in float keeps it: t and p rounded, and no bound. */
static inline surface surface_f32(const tracer *t, ray r, trace_hit x)
{
    surface s = surface_of_trace(t, r, x);
    s.error = s.noise = 0;
    for (int k = 0; k < 3; k++)
        s.p = vwith(s.p, k, (real)((float)vaxis(r.o, k) + (float)x.h.t * (float)vaxis(r.d, k)));
    return s;
}

static inline ray leave_fixed_3e2(surface s, vec3 w)
{
    return (ray){s.p, (real)0.03 / vlength(w), w, real_infinity};
}

/* Above: all of it; below: where the card meets the floor. Left: float and a fixed eps; right:
 * bounds. */
cold_inline void draw_acne(const options *o)
{
    static const char *const name[] = {"float, tmin = 1e-4: acne", "leave", "tmin = 0.03: leaks",
                                       "leave"};
    enum { gap = 6 };
    int w = o->quick ? 96 : 400, h = w * 9 / 16;
    gallery *g = gallery_new(o->quick ? 6 : 24, 10000);
    shading how[4];
    traced_view v[4];
    panel p[4];
    for (int k = 0; k < 4; k++) {
        how[k] = gallery_shading(g);
        if (k % 2 == 0) how[k].surface_of = surface_f32;
        if (k % 2 == 0) how[k].leave = k ? leave_fixed_3e2 : leave_first;
        v[k] = gallery_view(g, &how[k], w, h, k >= 2);
        p[k] = (panel){name[k], &v[k]};
    }
    panels_draw(o, "18_shade_acne.png", false,
                (panels_shape){2 * w + gap, 2 * h + gap, 2, 2, gap, o->quick ? 1 : 2, false},
                traced_colour, p);
    gallery_free(g);
}

/* ---- the edge of light ---- */

/* An octahedron of 8 n^2 triangles, its corners moved out to radius 1: those are its normals. */
static inline void edge_ball_build(edge_ball *b, int n)
{
    *b = (edge_ball){.m = octahedron_mesh(n),
                     .sun = {LIGHT_DIRECTIONAL, vunit(vec(1, 0.25, 0.2)), {1, 1, 1}}};
    b->m.n = allocate(b->m.normals = b->m.vertices, sizeof *b->m.n);
    for (size_t i = 0; i < b->m.vertices; i++) b->m.v[i] = b->m.n[i] = vunit(b->m.v[i]);
    world_part_of_mesh(&b->m, MASK_ALL, &b->part);
    b->w = (trace_world){&b->part, 1};
}

static inline void edge_ball_free(edge_ball *b)
{
    world_part_free(&b->part);
    mesh_free(&b->m);
}

/* White and matte, so that L = E. */
static inline material edge_material(const void *context, trace_hit x, const surface *s)
{
    (void)context, (void)x, (void)s;
    return (material){.kd = {pi, pi, pi}};
}

/* Irradiance where the eye, far along z, sees the ball at (x, y); -1: it does not. */
static inline real edge_light(const edge_ball *b, real x, real y, bool lift, vec3 *p)
{
    shading how = {.lights = &b->sun, .n = 1, .material_of = edge_material, .background.x = -1,
                   .surface_of = lift ? terminator_surface : NULL};
    tracer t = {.w = &b->w, .program = shade_programs, .user = &how};
    ray r = ray_from((vec3){x, y, 4}, (vec3){0, 0, -1});
    shade_seen seen = {.t = 0};
    trace(&t, RAY_CAMERA, r, &seen);
    *p = ray_at(r, seen.t);
    return seen.colour.x;
}

typedef struct { const edge_ball *b; int size; bool lift; } edge_view;

static inline vec3 edge_colour(const void *context, real x, real y)
{
    const edge_view *v = context;
    real s = (real)2.1 / (real)v->size;
    vec3 p;
    real E = edge_light(v->b, x * s - (real)1.05, (real)1.05 - y * s, v->lift, &p);
    real grey = E < 0 ? (real)0.7 : (real)0.02 + (real)0.75 * E;
    return (vec3){grey, grey, grey};
}

cold_inline void draw_terminator(const options *o)
{
    enum { gap = 6 };
    int size = o->quick ? 60 : 360;
    edge_ball b;
    edge_view v[] = {{&b, size, false}, {&b, size, true}};
    panel p[] = {{"flat triangles shadow one another", &v[0]}, {"lifted", &v[1]}};
    edge_ball_build(&b, 4);
    panels_draw(o, "18_shade_terminator.png", false,
                (panels_shape){2 * size + gap, size, 2, 1, gap, 2, false}, edge_colour, p);
    edge_ball_free(&b);
}

/* ---- one beam, three patches ---- */

/* A beam of width 1 from above, about x = middle, and a patch that leans by so many degrees. */
static inline void figure_beam(figure *g, double middle, double degrees)
{
    enum { rays = 7 };
    const double a = degrees * 3.14159265358979 / 180, slope = tan(a), half = 0.5 / cos(a);
    light sun = {LIGHT_DIRECTIONAL, {0, 1, 0}, {1, 1, 1}};
    vec3 n = vec(-sin(a), cos(a), 0);
    light_sample at;
    light_reaches(&sun, (vec3){0, 0, 0}, n, n, &at);
    double left = middle - 0.5, right = middle + 0.5, tip = middle + 1.15 * (double)n.x;
    double beam[8] = {left, 2, right, 2, right, slope / 2, left, -slope / 2};
    figure_polygon(g, 4, beam, FIGURE_ORANGE, 0.2, NULL);
    for (int k = 0; k < rays; k++) {
        double x = left + (k + 0.5) / rays;
        figure_arrow(g, x, 2, x, (x - middle) * slope + 0.03, FIGURE_ORANGE, 1.2);
    }
    figure_line(g, left, -half * sin(a), right, half * sin(a), FIGURE_BLACK, 5, FIGURE_WHOLE);
    figure_line(g, middle, 0, middle, 1.35, FIGURE_BLACK, 1, FIGURE_DASHED);
    figure_arrow(g, middle, 0, tip, 1.15 * (double)n.y, FIGURE_BLUE, 2);
    figure_text(g, tip, 1.15 * (double)n.y, -8, -2, FIGURE_RIGHT, FIGURE_BLUE, "*n*");
    figure_text(g, middle, 2, 0, -6, FIGURE_MIDDLE, FIGURE_BLACK, "*l*");
    if (degrees > 0) figure_arc(g, middle, 0, 52, 90, 90 + degrees, FIGURE_BLACK, 1);
    if (degrees > 0) figure_text(g, middle - 0.09, 0.62, 0, 0, FIGURE_RIGHT, FIGURE_BLACK, "_θ_");
    figure_print(g, middle, -1.0, 0, 0, FIGURE_MIDDLE, FIGURE_BLACK, "area %.2f", 2 * half);
    figure_print(g, middle, -1.0, 0, 22, FIGURE_MIDDLE, FIGURE_BLACK, "_E_ = %.2f _E_~0~",
                 (double)at.E.x);
}

cold_inline void draw_tilt(const options *o)
{
    figure g = figure_begin(o, "18_shade_tilt.svg", 760, 430);
    figure_origin(&g, 130, 275, 115);
    figure_beam(&g, 0, 0), figure_beam(&g, 2, 35), figure_beam(&g, 4.1, 60);
    figure_text(&g, -0.95, 2, 0, -6, FIGURE_LEFT, FIGURE_ORANGE, "one beam");
    figure_end(&g);
}

#endif
