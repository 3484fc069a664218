/* painting.h: painting the pieces of a mesh over each other.
 *
 *   painting_draw(&p, order, n, camera, by_piece, &im)   in that order; by_piece: each piece has a
 *                                                        tint of its own
 *   draw_cyclic(&im)     three panels: sorted by distance; BSP; the same, by pieces
 */
#ifndef BSP_PAINTING_H
#define BSP_PAINTING_H

#include "../../../common/image.h"
#include "../../../common/parallel.h"
#include "../../02_camera/camera.h"
#include "../painter.h"
#include "puzzles.h"

enum { painting_corners = 64 };  /* a piece with more is not drawn */

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 paint_colour(uint32_t k)
{
    static const double c[6][3] = {{0.85, 0.25, 0.08}, {0.02, 0.3, 0.72}, {0.95, 0.75, 0.1},
                                   {0.1, 0.55, 0.3},   {0.5, 0.15, 0.5},  {0.3, 0.65, 0.8}};
    return (vec3){(real)c[k % 6][0], (real)c[k % 6][1], (real)c[k % 6][2]};
}

/* A convex polygon, its corners in pixels, in either sense of rotation. */
static inline void paint_polygon(const real *x, const real *y, size_t n, vec3 colour, image *im)
{
    real x0 = (real)im->width, x1 = 0, y0 = (real)im->height, y1 = 0;
    for (size_t i = 0; i < n; i++) {
        x0 = real_min(x[i], x0), x1 = real_max(x[i], x1);
        y0 = real_min(y[i], y0), y1 = real_max(y[i], y1);
    }
    x0 = real_max(x0, 0), y0 = real_max(y0, 0);
    x1 = real_min(x1, (real)(im->width - 1)), y1 = real_min(y1, (real)(im->height - 1));
    for (int j = (int)y0; (real)j <= y1; j++)
        for (int i = (int)x0; (real)i <= x1; i++) {
            real px = (real)i + (real)0.5, py = (real)j + (real)0.5, least = 0, most = 0;
            for (size_t k = 0; k < n; k++) {
                size_t l = (k + 1) % n;
                real e = (x[l] - x[k]) * (py - y[k]) - (y[l] - y[k]) * (px - x[k]);
                least = real_min(e, least), most = real_max(e, most);
            }
            if (least >= 0 || most <= 0) image_set(im, i, j, colour);
        }
}

/* All of it must lie before the eye. */
static inline void painting_draw(const painter *p, const uint32_t *order, size_t n, camera c,
                                 bool by_piece, image *im)
{
    real x[painting_corners], y[painting_corners];
    for (size_t k = 0; k < n; k++) {
        const painter_piece *q = &p->piece[order[k]];
        if (q->corners > painting_corners) continue;
        for (uint32_t i = 0; i < q->corners; i++)
            camera_project(c, vadd(p->corner[q->first + i], p->middle), im->width, im->height,
                           &x[i], &y[i]);
        paint_polygon(x, y, q->corners, paint_colour(by_piece ? order[k] : q->owner), im);
    }
}

/* The mean of 3 x 3 pixels. */
static inline image image_third(const image *big)
{
    image im = image_new(big->width / 3, big->height / 3);
    for (int y = 0; y < im.height; y++)
        for (int x = 0; x < im.width; x++) {
            vec3 sum = {0, 0, 0};
            for (int k = 0; k < 9; k++)
                sum = vadd(sum, image_get(big, 3 * x + k % 3, 3 * y + k / 3));
            image_set(&im, x, y, vscale(sum, (real)1 / 9));
        }
    return im;
}

static inline void image_fill(image *im, vec3 c)
{
    for (int y = 0; y < im->height; y++)
        for (int x = 0; x < im->width; x++) image_set(im, x, y, c);
}

static inline void draw_cyclic(image *all)
{
    mesh m = cyclic_mesh();
    failure f;
    painter cut, uncut;
    painter_uncut(&m, &uncut);
    if (!painter_build(&m, painter_defaults, &cut, &f)) fail(f);
    camera_frame frame;
    camera c;
    vec3 eye = {0.7, -1.3, 3};
    int side = (all->width - 8) / 3;
    image_fill(all, (vec3){1, 1, 1});
    if (!frame_look_at(eye, (vec3){0, 0, 0}, (vec3){0, 1, 0}, &frame, &f)
        || !camera_perspective(frame, 52, 1, &c, &f)) fail(f);
    for (int k = 0; k < 3; k++) {
        const painter *p = k ? &cut : &uncut;
        uint32_t *order = allocate(p->pieces, sizeof *order);
        size_t n = k ? painter_order(p, eye, order) : painter_order_naive(p, eye, order);
        image big = image_new(3 * side, 3 * all->height);
        image_fill(&big, vec(0.93, 0.93, 0.93));
        painting_draw(p, order, n, c, k == 2, &big);
        image im = image_third(&big);
        image_place(all, k * (side + 4), 0, &im);
        image_free(&im), image_free(&big);
        free(order);
    }
    painter_free(&cut), painter_free(&uncut);
    mesh_free(&m);
}

#endif
