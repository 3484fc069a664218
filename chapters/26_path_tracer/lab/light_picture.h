/* light_picture.h: the picture of many paths from the lamp, on all cores.
 *
 *   bool whole = light_picture(&t, seed, paths, threads, &im, &work);   paths: a multiple of
 *                                               light_jobs; work: {0} at first; false: Ctrl-C
 *
 * Each job has a sum of its own, and they are added up in order: the same bytes for any number of
 * threads.
 */
#ifndef PATH_LIGHT_PICTURE_H
#define PATH_LIGHT_PICTURE_H

#include "../../../common/image.h"
#include "../../../common/parallel.h"
#include "../light_tracer.h"

enum { light_jobs = 16 };
typedef struct {
    const light_tracer *t;
    uint64_t seed;
    size_t paths;                  /* of each job */
    light_sum sum[light_jobs];
} light_share;

/* ---------------------------------------------------------------------------------------------- */

static inline void light_job(size_t job, void *context)
{
    light_share *l = context;
    path_pixel p;
    path_pixel_of(&path_defaults, l->seed, job, &p);
    for (uint32_t k = 0; k < l->paths; k++) {
        path_random s = path_sample(&p, k, 1u << 31);
        light_path(l->t, &s, &l->sum[job]);
    }
}

static inline bool light_picture(const light_tracer *t, uint64_t seed, size_t paths, int threads,
                                 image *im, path_counts *work)
{
    light_share l = {.t = t, .seed = seed, .paths = paths / light_jobs};
    size_t n = 3 * (size_t)t->width * (size_t)t->height;
    *im = image_new(t->width, t->height);
    for (int k = 0; k < light_jobs; k++) l.sum[k].rgb = allocate(n, sizeof(double));
    bool whole = parallel_for(light_jobs, threads, "paths from the lamp", light_job, &l);
    for (size_t i = 0; i < n; i++) {
        double sum = 0;
        for (int k = 0; k < light_jobs; k++) sum += l.sum[k].rgb[i];
        im->rgb[i] = (float)(sum / (double)paths);
    }
    for (int k = 0; k < light_jobs; k++) path_counts_add(work, &l.sum[k].work), free(l.sum[k].rgb);
    return whole;
}

#endif
