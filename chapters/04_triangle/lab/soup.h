/* soup.h: what a test costs. Triangles anywhere, rays anywhere: the closest hit of each ray among
 * all of them, most of which it misses; that is what a test is for.
 *
 *   SOUP_TIMED(run_x, prepare, test)      a function for bench.h: for each ray r `prepare`, then
 *                                         `test` for each triangle *k; a hit in h narrows r.tmax
 *   triangle_soup *s = soup_new(400, seed);        512 triangles, 400 rays; the caller frees
 *   bench_candidate v[] = {{"x", run_x, s, 0, 0}, ...};
 *
 * Every test is inlined (flatten): a call that copies ray and triangle takes longer than the test.
 * Whether a ray passes left or right of an edge is a coin toss here, as it is in the leaf of a
 * tree: the processor cannot predict a branch on it. The triangles fit into the cache.
 */
#ifndef TRIANGLE_SOUP_H
#define TRIANGLE_SOUP_H

#include "../../../common/lab/bench.h"
#include "needles.h"
#include "triangle_variants.h"

enum { soup_triangles = 512, soup_most_rays = 400 };
typedef struct {
    triangle tri[soup_triangles];
    triangle_planes planes[soup_triangles];
    ray r[soup_most_rays];
    int rays;
} triangle_soup;

/* ---------------------------------------------------------------------------------------------- */

#define SOUP_TIMED(name, prepare, test)                                                        \
    __attribute__((flatten))                                                                   \
    static double name(void *context)                                                          \
    {                                                                                          \
        const triangle_soup *s = context;                                                      \
        double sum = 0;                                                                        \
        for (int i = 0; i < s->rays; i++) {                                                    \
            ray r = s->r[i];                                                                   \
            hit h = hit_none;                                                                  \
            prepare;                                                                           \
            for (const triangle *k = s->tri; k < s->tri + soup_triangles; k++)                 \
                if (test) r.tmax = h.t;                                                        \
            sum += (double)h.u;                                                                \
        }                                                                                      \
        return sum;                                                                            \
    }

/* rays: at most 400. Edges about 0.5 long in a cube of side 2, rays from a cube of side 4. */
static inline triangle_soup *soup_new(int rays, uint64_t seed)
{
    triangle_soup *s = allocate(1, sizeof *s);
    random_stream g = random_start(seed, 9, 0);
    s->rays = rays;
    for (int i = 0; i < soup_triangles; i++) {
        vec3 m = random_in_cube(&g, 1), a = random_in_cube(&g, 0.5), b = random_in_cube(&g, 0.5);
        s->tri[i] = (triangle){vadd(m, a), vadd(m, b), vadd(m, random_in_cube(&g, 0.5))};
        s->planes[i] = triangle_planes_of(s->tri[i]);
    }
    for (int i = 0; i < rays; i++) {
        vec3 from = random_in_cube(&g, 2);
        s->r[i] = ray_from(from, random_in_cube(&g, 1));
    }
    return s;
}

#endif
