/* rays.h: rays from a file (07_mesh/files/ray_file.h), so that the search can be compared from
 * outside.
 *
 *   search_file(o, &x, name, rays, hits, any)     one thread, the median of seven passes
 */
#ifndef WIDE_RAYS_H
#define WIDE_RAYS_H

#include "../../../common/lab/report.h"
#include "../../07_mesh/files/ray_file.h"
#include "../../09_aabb/trials/pictures.h"
#include "measure.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void search_file(const options *o, const items *x, const char *name,
                               const char *rays, const char *hits_path, bool any)
{
    failure f;
    size_t n, hits = 0;
    double seconds[7], start = clock_seconds();
    bvh8 w;
    ray *r = rays_read(rays, &n, &f);
    if (!r) fail(f);
    if (!bvh8_build(x, bvh8_defaults, &w, &f)) fail(f);
    double built = clock_seconds() - start;
    hit *h = allocate(n, sizeof *h);
    for (int pass = -1; pass < 7; pass++) {
        start = clock_seconds(), hits = 0;
        for (size_t i = 0; i < n; i++) {
            h[i] = hit_none;
            if (!any) hits += bvh8_hit(&w, r[i], &h[i]);
            else if (bvh8_occluded(&w, r[i])) h[i].shape = 0, hits++;
        }
        if (pass >= 0) seconds[pass] = clock_seconds() - start;
    }
    table t = table_new("Rays from a file, one thread",
                        "scene|structure|kind|rays|hits|build_s|bytes|ns_per_ray");
    table_text(&t, "%s", name), table_text(&t, "bvh8"), table_text(&t, any ? "any" : "closest");
    table_count(&t, n), table_count(&t, hits), table_text(&t, "%.6f", built);
    table_count(&t, w.room.bytes), table_number(&t, clock_median(seconds, 7) * 1e9 / (double)n);
    output_table(o, &t);
    if (hits_path && !hits_write(hits_path, h, n, any, &f)) fail(f);
    bvh8_free(&w);
    free(r), free(h);
}

#endif
