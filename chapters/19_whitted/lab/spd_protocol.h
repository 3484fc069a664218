/* spd_protocol.h: the scenes of 17 traced as the results published for them were: rays counted.
 *
 *   trace_counts c;
 *   spd_count_scene(&w, edge, threads, &c)      (edge + 1)^2 eye rays, through corners of pixels
 *   spd_print(&w, scale, &c, seconds)           lines beginning primary, shadow, secondary
 *   spd_protocol(&o, name, scale)               all scenes with published results, or that one
 *
 * The protocol: 512^2 pixels, 513^2 rays through their corners (17.7); depth at most 5, the eye ray
 * being 1; a shadow ray to each light that is in front of the surface, and none to one behind it; a
 * reflection ray where Ks > 0, a refraction ray where T > 0, no Fresnel, and no colours.
 * Total reflection: what would be refracted is reflected, and goes with the reflection ray.
 *
 * Glass lies behind the faces whose normal the ray meets: from there the index is 1 / ior, and no
 * more is remembered (media.h would ask for bodies; these scenes have none). Shadow rays end at the
 * first hit, of glass, too.
 *
 * Sources: E. Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987, and
 * the documentation of its programs.
 */
#ifndef WHITTED_LAB_SPD_PROTOCOL_H
#define WHITTED_LAB_SPD_PROTOCOL_H

#include "../../../common/output.h"
#include "../../07_mesh/scenes/spd.h"
#include "../reflect.h"
#include "../refract.h"
#include "../whitted_scene.h"

enum { spd_depth = 5 };

typedef struct {
    const world *w;
    trace_world world;
    int edge;
    trace_counts *row;      /* [edge + 1] */
} spd_work;

typedef struct { ray r; int depth; ray_kind kind; } spd_branch;

/* ---------------------------------------------------------------------------------------------- */

static const ray_program spd_programs[ray_kinds] = {
    [RAY_CAMERA] = {.mask = MASK_SEEN}, [RAY_SHADOW] = {.mask = MASK_SHADOW, .first = true},
    [RAY_REFLECTION] = {.mask = MASK_SEEN}, [RAY_REFRACTION] = {.mask = MASK_SEEN}};

/* The branches of a hit; at the last depth none. */
static inline int spd_children(const spd_branch *b, const finish *f, const surface *s,
                               bool entering, spd_branch out[2])
{
    int n = 0;
    snell x;
    real ior = f->ior > 0 ? f->ior : 1;
    if (b->depth >= spd_depth) return 0;
    real n1 = entering ? 1 : ior, n2 = entering ? ior : 1;
    bool bends = f->transmit > 0 && snell_of(b->r.d, s->n, n1, n2, &x);
    if (bends) {
        vec3 w = snell_refract(&x, b->r.d, s->n);
        out[n++] = (spd_branch){{leave_point(*s, vneg(s->n), 0), 0, w, real_infinity},
                                b->depth + 1, RAY_REFRACTION};
    }
    if (f->ks > 0 || (f->transmit > 0 && !bends))
        out[n++] = (spd_branch){{leave_point(*s, s->n, 0), 0, reflect(b->r.d, s->n), real_infinity},
                                b->depth + 1, RAY_REFLECTION};
    return n;
}

/* A light behind the surface: no ray. */
static inline void spd_eye_ray(tracer *t, const world *w, ray r)
{
    spd_branch stack[spd_depth + 2];
    int top = 0;
    stack[top++] = (spd_branch){ray_unit(r), 1, RAY_CAMERA};
    while (top > 0) {
        spd_branch b = stack[--top];
        trace_hit x;
        if (!trace_find(t, b.kind, &b.r, NULL, &x)) continue;
        surface s = surface_of_trace(t, b.r, x);
        finish f = world_finish(w, x.h.shape);
        bool entering = vdot(s.n, b.r.d) < 0;
        s = surface_facing(s, b.r.d);
        for (int i = 0; i < w->lights; i++)
            if (vdot(s.n, vsub(w->light[i], s.p)) > 0)
                trace(t, RAY_SHADOW, leave_to(s, w->light[i]), NULL);
        top += spd_children(&b, &f, &s, entering, stack + top);
    }
}

static inline void spd_row(size_t j, void *context)
{
    spd_work *k = context;
    tracer t = {.w = &k->world, .program = spd_programs};
    for (int i = 0; i <= k->edge; i++) {
        real x = (real)(2 * i) / (real)k->edge - 1, y = 1 - (real)(2 * j) / (real)k->edge;
        spd_eye_ray(&t, k->w, world_ray(k->w, x, y));
    }
    k->row[j] = t.counts;
}

/* False: stopped by Ctrl-C. */
static inline bool spd_count_scene(const world *w, int edge, int threads, trace_counts *out)
{
    scene s = world_scene(w);
    world_part part;
    spd_work k = {.w = w, .edge = edge};
    if (w->n) world_part_of_scene(&s, MASK_ALL, &part);
    else world_part_of_mesh(&w->mesh, MASK_ALL, &part);
    k.world = (trace_world){&part, 1};
    k.row = allocate((size_t)edge + 1, sizeof *k.row);
    bool whole = parallel_for((size_t)edge + 1, threads, w->name, spd_row, &k);
    *out = (trace_counts){0};
    for (int j = 0; j <= edge; j++) trace_counts_add(out, &k.row[j]);
    free(k.row);
    world_part_free(&part);
    return whole;
}

static inline void spd_print(const world *w, int scale, const trace_counts *n, double seconds)
{
    static const char *const what[] = {"primary", "shadow"};
    for (int k = 0; k < 2; k++)  /* RAY_CAMERA, RAY_SHADOW */
        printf("%s %s %d: rays %zu, hits %zu\n", what[k], w->name, scale, n->rays[k], n->hits[k]);
    printf("secondary %s %d: reflected %zu, refracted %zu, rays %zu, hits %zu\n", w->name, scale,
           n->rays[RAY_REFLECTION], n->rays[RAY_REFRACTION],
           n->rays[RAY_REFLECTION] + n->rays[RAY_REFRACTION],
           n->hits[RAY_REFLECTION] + n->hits[RAY_REFRACTION]);
    printf("# %.2f s\n", seconds);
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
        spd_print(&w, size, &c, clock_seconds() - start);
        if (g->hits && size == g->scale && edge == spd_edge)
            printf("# published primary hits for %s %d: %zu\n", g->name, size, g->hits);
        fflush(stdout);
        world_free(&w);
        if (!whole) die(parallel_stopped(), "stopped");
    }
}

#endif
