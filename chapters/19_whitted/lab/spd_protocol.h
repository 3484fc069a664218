/* spd_protocol.h: the scenes of 17 traced as the results published for them were: rays counted.
 *
 *   spd_protocol(&o, name, scale)               all scenes with published results, or that one
 *   spd_count_scene(&w, edge, threads, &c)      (edge + 1)^2 eye rays; false: stopped by Ctrl-C
 *
 * The protocol: 512^2 pixels, 513^2 rays through their corners (17.7); depth at most 5, the eye ray
 * being 1; a shadow ray to each light in front of the surface, none to one behind it; a reflection
 * ray where Ks > 0, a refraction ray where T > 0, no Fresnel, no colours. In total reflection what
 * would be refracted goes with the reflection ray.
 *
 * Glass lies behind the faces whose normal the ray meets: from there the index is 1 / ior, and no
 * more is remembered (media.h would ask for bodies; these scenes have none). Shadow rays end at the
 * first hit, of glass, too. Sources: spd.h.
 */
#ifndef WHITTED_LAB_SPD_PROTOCOL_H
#define WHITTED_LAB_SPD_PROTOCOL_H

#include "../../../common/output.h"
#include "../../07_mesh/scenes/spd.h"
#include "../reflect.h"
#include "../refract.h"
#include "../whitted_scene.h"

enum { spd_depth = 5 };

typedef struct { const world *w; trace_world world; int edge; trace_counts *row; } spd_work;

/* ---------------------------------------------------------------------------------------------- */

static const ray_program spd_programs[ray_kinds] = {
    [RAY_CAMERA] = {.mask = MASK_SEEN}, [RAY_SHADOW] = {.mask = MASK_SHADOW, .first = true},
    [RAY_REFLECTION] = {.mask = MASK_SEEN}, [RAY_REFRACTION] = {.mask = MASK_SEEN}};

/* Is d refracted, along *w? *mirrors: is it reflected, too, or instead? */
static inline bool spd_bends(const finish *f, const surface *s, vec3 d, bool entering, vec3 *w,
                             bool *mirrors)
{
    snell x;
    real ior = f->ior > 0 ? f->ior : 1;
    bool clear = f->transmit > 0;
    bool bends = clear && snell_of(d, s->n, entering ? 1 : ior, entering ? ior : 1, &x);
    if (bends) *w = snell_refract(&x, d, s->n);
    *mirrors = f->ks > 0 || (clear && !bends);
    return bends;
}

static inline void spd_trace(tracer *t, const world *w, ray_kind kind, ray r, int depth)
{
    trace_hit x;
    bool mirrors;
    if (depth > spd_depth || !trace_find(t, kind, world_but_none, &r, NULL, &x)) return;
    surface s = surface_of_trace(t, r, x);
    finish f = world_finish(w, x.h.shape);
    bool entering = vdot(s.n, r.d) < 0;
    s = surface_facing(s, r.d);
    for (int i = 0; i < w->lights; i++)
        if (vdot(s.n, vsub(w->light[i], s.p)) > 0)
            trace(t, RAY_SHADOW, leave_to(s, w->light[i]), NULL);
    ray through = {leave_point(s, vneg(s.n), 0), 0, r.d, real_infinity};
    ray back = {leave_point(s, s.n, 0), 0, reflect(r.d, s.n), real_infinity};
    if (spd_bends(&f, &s, r.d, entering, &through.d, &mirrors))
        spd_trace(t, w, RAY_REFRACTION, through, depth + 1);
    if (mirrors) spd_trace(t, w, RAY_REFLECTION, back, depth + 1);
}

static inline void spd_row(size_t j, void *context)
{
    spd_work *k = context;
    tracer t = {.w = &k->world, .program = spd_programs};
    for (int i = 0; i <= k->edge; i++) {
        real x = (real)(2 * i) / (real)k->edge - 1, y = 1 - (real)(2 * j) / (real)k->edge;
        spd_trace(&t, k->w, RAY_CAMERA, ray_unit(world_ray(k->w, x, y)), 1);
    }
    k->row[j] = t.counts;
}

static inline bool spd_count_scene(const world *w, int edge, int threads, trace_counts *out)
{
    scene s = world_scene(w);
    world_part part;
    spd_work k = {.w = w, .edge = edge};
    if (w->n) world_part_of_scene(&s, MASK_ALL, &part);
    else world_part_of_mesh(&w->mesh, MASK_ALL, &part);
    k.world = (trace_world){&part, 1}, k.row = allocate((size_t)edge + 1, sizeof *k.row);
    bool whole = parallel_for((size_t)edge + 1, threads, w->name, spd_row, &k);
    *out = (trace_counts){0};
    for (int j = 0; j <= edge; j++) trace_counts_add(out, &k.row[j]);
    free(k.row);
    world_part_free(&part);
    return whole;
}

static inline void spd_print(const char *name, int scale, const trace_counts *n)
{
    const size_t *rays = n->rays, *hits = n->hits;
    printf("primary %s %d: rays %zu, hits %zu\n", name, scale, rays[RAY_CAMERA], hits[RAY_CAMERA]);
    printf("shadow %s %d: rays %zu, hits %zu\n", name, scale, rays[RAY_SHADOW], hits[RAY_SHADOW]);
    printf("secondary %s %d: reflected %zu, refracted %zu, rays %zu, hits %zu\n", name, scale,
           rays[RAY_REFLECTION], rays[RAY_REFRACTION], rays[RAY_REFLECTION] + rays[RAY_REFRACTION],
           hits[RAY_REFLECTION] + hits[RAY_REFRACTION]);
}

/* name NULL: all of them with published results; scale < 0: the usual. */
static inline void spd_protocol(const options *o, const char *name, int scale)
{
    if (name && !generator_find(spd_list, spd_scenes, name))
        die(2, "--scene: allowed are balls, gears, mount, rings, teapot, tetra, tree");
    for (int k = 0; k < spd_scenes; k++) {
        const generator *g = &spd_list[k];
        int edge = o->quick ? 32 : spd_edge, size = scale >= 0 ? scale : g->scale;
        world w;
        failure f;
        trace_counts c;
        if (name ? strcmp(name, g->name) != 0 : !g->hits) continue;
        if (!spd_world(g->name, size, &w, &f) || !spd_print_digits(&w, &f)) fail(f);
        double start = clock_seconds();
        bool whole = spd_count_scene(&w, edge, o->threads, &c);
        spd_print(w.name, size, &c);
        printf("# %.2f s\n", clock_seconds() - start);
        if (g->hits && size == g->scale && edge == spd_edge)
            printf("# published primary hits for %s %d: %zu\n", g->name, size, g->hits);
        fflush(stdout);
        world_free(&w);
        if (!whole) die(parallel_stopped(), "stopped");
    }
}

#endif
