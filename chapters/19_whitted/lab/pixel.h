/* pixel.h: one pixel's ray, and all that comes of it, in words, lines with the number of their
 * equation, and drawn as a tree.
 *
 *   whitted_explain(&o, "345,140")  of the two spheres: that pixel's middle, columns and rows from
 *                                   0; the drawing goes to build/19_whitted_pixel.svg
 *   whitted_explain(&o, NULL)       nothing said; this page's drawing, 19_whitted_tree.svg
 *
 * The walk here is whitted_trace (whitted.h), so that it can speak; that both bring the same light
 * by as many rays is tested each time. What each ray adds is what it finds times its weight: the
 * sum of all lines "it adds" is the pixel.
 */
#ifndef WHITTED_LAB_PIXEL_H
#define WHITTED_LAB_PIXEL_H

#include "../../../common/lab/explain.h"
#include "ray_tree.h"
#include "two_spheres.h"

static const char *const pixel_shape[two_shapes] = {"the floor", "the glass ball",
                                                    "the bubble", "the mirror ball"};

/* ---------------------------------------------------------------------------------------------- */

static inline void pixel_adds(int deep, const char *equation, vec3 weight, vec3 left, vec3 L)
{
    if (!vzero(L)) explain_vector(deep, equation, "it adds", vmul(weight, vmul(left, L)));
}

cold_inline void pixel_hit(const ray_tree *x, const whitted_branch *b, const whitted_place *p,
                             int deep)
{
    explain_line(deep, "(1.2)", "it hits %s at t = %.6g, p = (%.6g, %.6g, %.6g)",
                 pixel_shape[p->s.shape], (double)x->node[b->number].t, (double)p->s.p.x,
                 (double)p->s.p.y, (double)p->s.p.z);
    explain_line(deep, "(18.5), (18.10)",
                 "p is off by at most %.2g; the next rays begin %.2g off it", (double)p->s.error,
                 (double)(p->s.error + p->s.noise + p->more));
    if (p->left.x < 1) explain_vector(deep, "(19.9)", "of its light the glass leaves", p->left);
}

/* The lamps: `lit` of a shadow ray is in the tree. Returns what shade() must have found. */
static inline vec3 pixel_lamps(const whitted *w, const ray_tree *x, const whitted_branch *b,
                               const whitted_place *p, int deep)
{
    const material *m = &p->m->base;
    vec3 colour = vmadd(m->ke, vmul(w->ambient, m->kd), 1);
    light_sample to;
    int shadow = b->number;
    for (int i = 0; i < w->n; i++) {
        const char *law = w->lights[i].kind == LIGHT_POINT ? "(18.1)" : "(18.2)";
        if (!material_reflects(m)) {
            explain_line(deep, "(18.8)", "light is not scattered here: no shadow ray");
            continue;
        }
        if (!light_reaches(&w->lights[i], p->s.p, p->s.n, p->s.ns, &to)) {
            explain_line(deep, law, "the lamp is behind the surface: no shadow ray");
            continue;
        }
        do shadow++;
        while (shadow < x->n - 1 && x->node[shadow].kind != RAY_SHADOW);
        explain_vector(deep, law, "towards the lamp: E =", to.E);
        explain_line(deep, "(1.5)", "shadow ray: %.4g of it arrives", (double)x->node[shadow].lit);
        colour = vmadd(colour, blinn_phong(m, p->s.ns, to.l, vneg(b->r.d), to.E),
                       x->node[shadow].lit);
    }
    return vscale(colour, 1 / whitted_square(w, &b->in));
}

/* What the surface does with the ray: shares of (19.10). Returns how many rays it would send on. */
static inline int pixel_shares(const whitted *w, const whitted_branch *b, const whitted_place *p,
                               int deep)
{
    snell s;
    if (!p->m->body) {
        if (!vzero(p->m->mirror)) explain_vector(deep, "(19.10)", "a mirror, M =", p->m->mirror);
        return !vzero(p->m->mirror);
    }
    real n1 = w->media[p->inside].ior, n2 = w->media[p->beyond].ior;
    if (!snell_of(b->r.d, p->s.ns, n1, n2, &s)) {
        explain_line(deep, "(19.3)", "from n1 = %g to n2 = %g: cos i = %.6g, cos^2 t < 0: all is "
                     "reflected", s.n1, s.n2, s.ci);
        return 1;
    }
    real R = fresnel(&s);
    explain_line(deep, "(19.3)", "from n1 = %g to n2 = %g: cos i = %.6g, cos t = %.6g", s.n1, s.n2,
                 s.ci, s.ct);
    explain_line(deep, "(19.5)", "R = %.6g is reflected, 1 - R = %.6g goes through", (double)R,
                 (double)(1 - R));
    return 2;
}

/* whitted_trace, in words. */
static inline vec3 pixel_branch(tracer *t, const ray_tree *x, whitted_branch *b)
{
    const whitted *w = t->user;
    whitted_branch child[2];
    whitted_place p;
    int deep = 2 * b->depth;
    const char *law = b->kind == RAY_CAMERA ? "(2.5)" : b->kind == RAY_REFLECTION ? "(19.1)"
                      : "(19.4)";
    explain_line(deep - 2, law, "%s ray, depth %d, along (%.6g, %.6g, %.6g)",
                 ray_kind_names[b->kind], b->depth, (double)b->r.d.x, (double)b->r.d.y,
                 (double)b->r.d.z);
    explain_vector(deep, "(19.10)", "weight", b->weight);
    if (!whitted_find(t, b, &p)) {
        vec3 sky = whitted_sky(w, b);
        explain_vector(deep, "", "it ends in the sky, where L =", sky);
        pixel_adds(deep, "(19.10)", b->weight, p.left, sky);
        return vmul(p.left, sky);
    }
    pixel_hit(x, b, &p, deep);
    vec3 L = whitted_shade(t, b, &p), told = pixel_lamps(w, x, b, &p, deep);
    if (!vzero(vsub(L, told)))
        die(1, "--pixel: what was told of the lamps is not what shade did");
    pixel_adds(deep, "(18.8)", b->weight, p.left, L);
    int wanted = pixel_shares(w, b, &p, deep), n = whitted_children(w, b, &p, child);
    if (n < wanted && b->depth < w->depth)
        explain_line(deep, "", "cut, as it would weigh less than %.2g: %s", (double)w->least,
                     n ? "one of both" : "what goes on");
    else if (n < wanted) explain_line(deep, "", "the last depth: nothing goes on");
    for (int k = 0; k < n; k++)
        L = vadd(L, vmul(child[k].share, pixel_branch(t, x, &child[k])));
    return vmul(p.left, L);
}

cold_inline void whitted_explain(const options *o, const char *text)
{
    int xy[2] = {345, 140}, w = text ? o->width : 640, h = text ? o->height : 480;
    char room[512];
    if (text) explain_pixel(text, w, h, xy);
    whitted_stage *s = two_spheres_new();
    ray_tree *x = allocate(1, sizeof *x);
    tracer t = stage_tracer(s), again = t;
    ray r = camera_ray(two_spheres_camera((real)w / (real)h), (real)xy[0] + (real)0.5,
                       (real)xy[1] + (real)0.5, w, h);
    s->w.log = ray_tree_begin(x);
    vec3 due = whitted_ray(&again, r, (media_set){0});
    if (text) {
        printf("# The rays of pixel %d, %d of %d x %d: two spheres\n", xy[0], xy[1], w, h);
        explain_vector(0, "(2.5)", "o =", r.o);
        whitted_branch eye = whitted_eye(r, (media_set){0});
        ray_tree_begin(x);
        vec3 L = pixel_branch(&t, x, &eye);
        if (!vzero(vsub(L, due)) || x->full || memcmp(&t.counts, &again.counts, sizeof t.counts))
            die(1, "--pixel: this walk is not that of whitted.h");
        explain_vector(0, "(19.10)", "the pixel, all that is added: L =", L);
        printf("%d rays; --samples 1 draws that, or 4 where it is more\n", x->n);
    }
    ray_tree_draw(x, text ? output_path(o, "19_whitted_pixel.svg", true, room)
                          : output_path(o, "19_whitted_tree.svg", false, room));
    free(x), stage_end(s), free(s);
}

#endif
