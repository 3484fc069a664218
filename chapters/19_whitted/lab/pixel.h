/* pixel.h: one pixel's ray, and all that comes of it: a line or two for each ray, with the numbers
 * of their equations, and drawn as a tree.
 *
 *   whitted_explain(&o, "345,140")  of the two spheres: that pixel's middle, columns and rows from
 *                                   0; the drawing goes to build/19_whitted_pixel.svg
 *   whitted_explain(&o, NULL)       nothing said; this page's drawing, 19_whitted_tree.svg
 */
#ifndef WHITTED_LAB_PIXEL_H
#define WHITTED_LAB_PIXEL_H

#include "../../../common/lab/explain.h"
#include "ray_tree.h"
#include "two_spheres.h"

/* ---------------------------------------------------------------------------------------------- */

/* What comes of a ray stands below it, further to the right. */
static inline void pixel_say(const ray_tree *x)
{
    static const char *const law[ray_kinds] = {
        [RAY_CAMERA] = "(2.5)", [RAY_REFLECTION] = "(19.1)", [RAY_REFRACTION] = "(19.4)"};
    for (const ray_tree_node *n = x->node; n < x->node + x->n; n++) {
        int deep = 2 * (ray_tree_level(n) - 1);
        if (n->kind == RAY_SHADOW) {
            explain_line(deep, "(1.5)", "shadow ray: %.4g of the light arrives", (double)n->lit);
            continue;
        }
        explain_line(deep, law[n->kind], "%s ray, depth %d, along (%.6g, %.6g, %.6g)",
                     ray_kind_names[n->kind], n->depth, (double)n->r.d.x, (double)n->r.d.y,
                     (double)n->r.d.z);
        explain_line(deep + 2, "(19.10)", "in the pixel it weighs %.6g", 
                     (double)vlargest(n->weight));
        if (n->t < real_infinity)
            explain_vector(deep + 2, "(1.2)", "it hits at p =", ray_at(n->r, n->t));
        else explain_line(deep + 2, "", "it ends in the sky");
    }
}

cold_inline void whitted_explain(const options *o, const char *text)
{
    int xy[2] = {345, 140}, w = text ? o->width : 640, h = text ? o->height : 480;
    char room[512];
    if (text) explain_pixel(text, w, h, xy);
    whitted_stage *s = two_spheres_new();
    ray_tree *x = allocate(1, sizeof *x);
    tracer t = stage_tracer(s);
    ray r = camera_ray(two_spheres_camera((real)w / (real)h), (real)xy[0] + (real)0.5,
                       (real)xy[1] + (real)0.5, w, h);
    s->w.log = ray_tree_begin(x);
    vec3 L = whitted_ray(&t, r, (media_set){0});
    if (text) {
        printf("# The rays of pixel %d, %d of %d x %d: two spheres\n", xy[0], xy[1], w, h);
        explain_vector(0, "(2.5)", "o =", r.o);
        pixel_say(x);
        explain_vector(0, "(19.10)", "together they bring L =", L);
        printf("%d rays; --samples 1 draws that, or 4 where it is more\n", x->n);
    }
    ray_tree_draw(x, text ? output_path(o, "19_whitted_pixel.svg", true, room)
                          : output_path(o, "19_whitted_tree.svg", false, room));
    free(x), stage_end(s), free(s);
}

#endif
