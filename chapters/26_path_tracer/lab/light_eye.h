/* light_eye.h: the box of spheres from the eye and from the lamp, as many paths of each.
 *
 *   draw_light(o)    two panels: path.h, light_tracer.h; and a table of what each took
 *
 * The paths from the lamp are shared out to a fixed number of jobs, each with a picture of its own,
 * which are added up in order: the same bytes for any number of threads.
 */
#ifndef PATH_LIGHT_EYE_H
#define PATH_LIGHT_EYE_H

#include "../light_tracer.h"
#include "pictures.h"

enum { light_jobs = 16 };
typedef struct {
    light_tracer t;
    uint64_t seed;
    size_t paths;                  /* of each job */
    double *sum[light_jobs];
    light_counts work[light_jobs];
} light_share;

/* ---------------------------------------------------------------------------------------------- */

static inline void light_job(size_t job, void *context)
{
    light_share *l = context;
    for (size_t k = 0; k < l->paths; k++) {
        random_stream s = random_start(l->seed, job, k);
        light_path(&l->t, &s, l->sum[job], &l->work[job]);
    }
}

/* `paths` from the lamp, a multiple of light_jobs. */
static inline image light_picture(const options *o, const showcase *c, int side, size_t paths,
                                  light_counts *work, bool *whole)
{
    light_share *l = allocate(1, sizeof *l);
    size_t n = 3 * (size_t)side * (size_t)side;
    l->seed = o->seed, l->paths = paths / light_jobs;
    light_tracer_of(&c->s, c->eye, side, side, &l->t);
    for (int k = 0; k < light_jobs; k++) l->sum[k] = allocate(n, sizeof(double));
    *whole = parallel_for(light_jobs, o->threads, "paths from the lamp", light_job, l);
    image im = image_new(side, side);
    for (size_t i = 0; i < n; i++) {
        double sum = 0;
        for (int k = 0; k < light_jobs; k++) sum += l->sum[k][i];
        im.rgb[i] = (float)(sum / (double)paths);
    }
    for (int k = 0; k < light_jobs; k++) {
        work->paths += l->work[k].paths, work->rays += l->work[k].rays;
        work->shadow += l->work[k].shadow;
        free(l->sum[k]);
    }
    light_tracer_free(&l->t), free(l);
    return im;
}

static inline void draw_light(const options *o)
{
    static const char *const title[2] = {"paths from the eye", "as many paths from the lamp"};
    int side = o->quick ? 48 : 360;
    uint32_t samples = o->quick ? 4 : 32;
    showcase c;
    failure f;
    path_tracer t;
    light_counts work = {0};
    bool whole, lit;
    if (!showcase_of("spheres", 1, &c, &f)) fail(f);
    path_tracer_of(&c.s, NULL, path_defaults, &t);
    render_job j = {.tracer = &t, .eye = c.eye, .seed = o->seed, .threads = o->threads};
    film m = film_new(side, side);
    whole = render_range(&j, &m, 0, samples);
    size_t paths = (size_t)side * (size_t)side * samples / light_jobs * light_jobs;
    double start = clock_seconds();
    image im[2] = {film_picture(&m), light_picture(o, &c, side, paths, &work, &lit)};
    double seconds[2] = {j.pass.seconds, clock_seconds() - start};
    double rays[2] = {(double)path_rays(&j.counts), (double)(work.rays + work.shadow)};
    table counted = table_new("Light against eye: the box of spheres by as many paths of each",
                             "paths|number|rays a path|time [s]");
    image all = image_new(2 * side, side);
    for (int k = 0; k < 2; k++) {
        table_text(&counted, k ? "from the lamp" : "from the eye"), table_count(&counted, paths);
        table_number(&counted, rays[k] / (double)paths), table_number(&counted, seconds[k]);
        pictures_expose(&im[k], 2);
        image_place(&all, k * side, 0, &im[k]);
        image_free(&im[k]);
    }
    output_extra_table(o, &counted);
    label_titles(&all, 2, 1, 0, title);
    output_picture(o, &all, "26_path_tracer_light.png", false, whole && lit);
    image_free(&all);
    film_free(&m), path_tracer_free(&t), showcase_free(&c);
}

#endif
