/* sphere_draw.h: the two pictures of this chapter.
 *
 *   sphere_draw(&o)      a sphere through a long lens from 500, 1000, 2000 and 5000 radii: above by
 *                        first.h in float, below by sphere_hit; |n.d|, red where a ray through
 *                        the disc misses, blue where a ray beside it hits
 *   sphere_draw_map(&o)  across: the distance, 1 to 1e6 radii; up: how far the ray passes from the
 *                        centre, 0 to 1.2 radii; red and blue as above, grey where the answer is
 *                        right: the darker, the farther the hit is off the surface (light 1e-9 R,
 *                        black R); left first.h in float, then first.h, then sphere_hit
 */
#ifndef SPHERE_DRAW_H
#define SPHERE_DRAW_H

#include "../../../common/output.h"
#include "../../../common/parallel.h"
#include "../../../common/headlight.h"
#include "sphere_oracle.h"
#include "sphere_variants.h"

static inline void sphere_draw(const options *o);
static inline void sphere_draw_map(const options *o);

/* ---------------------------------------------------------------------------------------------- */

typedef struct { image *im; int columns, rows; sphere_hit_function *const *X_hit; } sphere_panels;

static const vec3 sphere_red = {0.8, 0.1, 0.05};
static const vec3 sphere_blue = {0.05, 0.25, 0.8};

/* From o = far u to the point x, y of the plane through the centre. */
static inline ray sphere_view(real far, real x, real y)
{
    vec3 u = vunit((vec3){1, 2, 3}), right, up;
    vbasis(u, &right, &up);
    vec3 o = vscale(u, far);
    return ray_from(o, vsub(vadd(vscale(right, x), vscale(up, y)), o));
}

static inline void sphere_draw_pixel(int x, int y, void *context)
{
    const sphere_panels *p = context;
    static const real distance[4] = {500, 1000, 2000, 5000};
    int w = p->im->width / p->columns, h = p->im->height / p->rows;
    if (w == 0) w = 1;  /* a picture smaller than its panels shows only some */
    if (h == 0) h = 1;
    int column = x / w < p->columns ? x / w : p->columns - 1;
    int row = y / h < p->rows ? y / h : p->rows - 1;
    real half = 0.5, scale = (real)2.3 / (real)(w < h ? w : h);
    real across = (real)(x - column * w) + half - (real)w / 2;
    real up = (real)h / 2 - (real)(y - row * h) - half;
    ray r = sphere_view(distance[column], across * scale, up * scale);
    sphere ball = {{0, 0, 0}, 1};
    hit found;
    bool is = p->X_hit[row](ball, r, &found), due = sphere_clearance(ball, r) <= 0;
    vec3 c = {0.02, 0.02, 0.03};
    if (is != due) c = due ? sphere_red : sphere_blue;
    else if (is) {
        /* The textbook divides by R and trusts that the point is on the surface. */
        vec3 at = ray_at(r, found.t), n = row ? sphere_normal(ball, sphere_point(ball, at)) : at;
        c = headlight(n, r.d);
    }
    image_set(p->im, x, y, c);
}

static inline void sphere_draw(const options *o)
{
    static sphere_hit_function *const X_hit[2] = {sphere_hit_first_f32, sphere_hit};
    image im = image_new(o->width, o->height);
    sphere_panels p = {&im, 4, 2, X_hit};
    bool whole = parallel_pixels(im.width, im.height, o->threads, "sphere", sphere_draw_pixel, &p);
    output_picture(o, &im, "03_sphere.png", true, whole);
    image_free(&im);
}

static inline void sphere_map_pixel(int x, int y, void *context)
{
    const sphere_panels *p = context;
    int width = p->im->width / p->columns;
    int column = x / width < p->columns ? x / width : p->columns - 1;
    if (column && x % width < 4) { image_set(p->im, x, y, (vec3){1, 1, 1}); return; }
    real half = 0.5;
    real far = pow((real)10, 6 * ((real)(x - column * width) + half) / (real)width);
    real pass = (real)1.2 * ((real)(p->im->height - y) - half) / (real)p->im->height;
    ray r = sphere_view(far, pass, pass / 3);
    sphere ball = {{0, 0, 0}, vlength((vec3){1, (real)1 / 3, 0})};
    hit h;
    r.tmin = -real_infinity;
    bool is = p->X_hit[column](ball, r, &h), due = sphere_clearance(ball, r) <= 0;
    vec3 c = {0.93, 0.93, 0.93};
    if (is != due) c = due ? sphere_red : sphere_blue;
    else if (is) {
        double digits = -log10(sphere_residual(ball, r, h.t) + 1e-30);
        real grey = (real)0.85 * real_clamp((real)(digits / 9), 0, 1);
        c = (vec3){grey, grey, grey};
    }
    image_set(p->im, x, y, c);
}

static inline void sphere_draw_map(const options *o)
{
    static sphere_hit_function *const X_hit[3] = {sphere_hit_first_f32, first_sphere_hit,
                                                  sphere_hit};
    if (o->out) return;
    image im = image_new(960, 200);
    sphere_panels p = {&im, 3, 1, X_hit};
    bool whole = parallel_pixels(im.width, im.height, o->threads, "map", sphere_map_pixel, &p);
    output_picture(o, &im, "03_sphere_map.png", false, whole);
    image_free(&im);
}

#endif
