/* view_work.h: what the rays of a view take, asked of a few, and how many rays that affords.
 *
 *   double tests = view_tests(ask, built, camera, w, h)   a ray, the mean of 16 x 16 of the view;
 *                                                         ask: X_hit_counted of structure.h
 *   double share = view_share(tests)                      (0, 1]: of the rays that are wanted
 *
 * No structure parts triangles that lie in one place, and each ray that comes there asks them all:
 * of 10^5 of them a picture would take hours. So it gets as many rays as a picture of view_usual
 * tests a ray takes tests, and its program says so. The book's pictures of meshes take 20 at most.
 * What there is depends on the scene alone, not on the machine.
 */
#ifndef AABB_VIEW_WORK_H
#define AABB_VIEW_WORK_H

#include "../../02_camera/camera.h"
#include "../structure.h"

typedef bool view_asker(const void *built, ray r, hit *out, search_work *w);
enum { view_side = 16, view_usual = 100 };

/* ---------------------------------------------------------------------------------------------- */

static inline double view_tests(view_asker *ask, const void *built, camera c, int width, int height)
{
    search_work w = {0, 0, 0, 0};
    hit h;
    for (int k = 0; k < view_side * view_side; k++) {
        real x = ((real)(k % view_side) + (real)0.5) / view_side * (real)width;
        real y = ((real)(k / view_side) + (real)0.5) / view_side * (real)height;
        ask(built, camera_ray(c, x, y, width, height), &h, &w);
    }
    return (double)w.tests / (view_side * view_side);
}

static inline double view_share(double tests)
{
    return tests > view_usual ? view_usual / tests : 1;
}

#endif
