/* pictures.h: the committed pictures of the chapter.
 *
 *   draw_scene(o, "rough", w, h, samples, exposure, file, is_main)      a scene of showcase.h
 *   draw_strategies(o)  directions, roulette, light samples, MIS: one by one, as many rays each
 *   draw_ladder(o)      the box by 1, 4, 16 .. 4096 samples a pixel, and how far off each is
 *   draw_light(o)       the box of spheres from the eye and from the lamp, as many paths of each
 *   bool whole = light_picture(&t, seed, paths, threads, &im, &work);   paths from the lamp, a
 *                       multiple of light_jobs, on all cores; work: {0} at first; false: Ctrl-C
 *
 * The numbers of samples are fixed, so that the bytes are. Powers of two: two halves (film.h) of
 * 2^k Sobol' points each are spread best (20). Each job from the lamp has a sum of its own, added
 * up in order: the same bytes for any number of threads.
 */
#ifndef PATH_PICTURES_H
#define PATH_PICTURES_H

#include "../../../common/lab/panels.h"
#include "../../../common/lab/report.h"
#include "../light_tracer.h"
#include "showcase.h"

enum { light_jobs = 16 };
typedef struct {
    const light_tracer *t;
    uint64_t seed;
    size_t paths;                  /* of each job */
    light_sum sum[light_jobs];
} light_share;

/* ---------------------------------------------------------------------------------------------- */

cold_inline void draw_scene(const options *o, const char *scene_name, int w, int h,
                              uint32_t samples, float exposure, const char *file, bool is_main)
{
    shot s;
    int q = o->quick && !is_main ? 6 : 1;
    shot_of(&s, o, scene_name, path_defaults, w / q, h / q);
    bool whole = passes_range(render_passes(&s.j), &s.film, 0, o->quick ? 4 : samples);
    image im = shot_picture(&s, exposure);
    output_picture(o, &im, file, is_main, whole);
    image_free(&im), shot_free(&s);
}

/* Panel k of a row, each pixel `larger` wide; it is freed. */
static inline void draw_panel(image *all, int k, int larger, image im)
{
    int w = im.width * larger, h = im.height * larger;
    for (int i = 0; i < w * h; i++)
        image_set(all, k * w + i % w, i / w, image_get(&im, i % w / larger, i / w / larger));
    image_free(&im);
}

/* One film: each rung adds samples to the one before, and says itself how far off it is (20.22). */
cold_inline void draw_ladder(const options *o)
{
    enum { rungs = 7, side = 64, larger = 2, size = side * larger };
    const char *title[rungs];
    char said[rungs][32];
    int n = o->quick ? 3 : rungs;
    shot s;
    double before = 0;
    bool whole = true;
    shot_of(&s, o, "cornell", path_defaults, side, side);
    image all = image_new(n * size, size);
    table rows = table_new("The ladder: the box by ever more samples, one film", "samples a pixel|"
                           "error RMSE, estimated|of the rung before|rays a path|time [s]");
    for (int k = 0; k < n; k++) title[k] = said[k], *said[k] = 0;
    for (int k = 0; k < n && whole; k++) {
        uint32_t samples = 1u << 2 * k;
        whole = passes_range(render_passes(&s.j), &s.film, k ? samples / 4 : 0, samples);
        double error = film_error(&s.film);
        draw_panel(&all, k, larger, shot_picture(&s, 2));
        table_count(&rows, samples);
        table_text(&rows, k ? "%.3g" : "-", error);
        table_text(&rows, k > 1 ? "1 / %.2f" : "-", before / error);
        table_number(&rows, (double)path_rays(&s.j.counts) / (double)s.j.counts.paths);
        table_number(&rows, s.j.pass.seconds);
        snprintf(said[k], sizeof said[k], k ? "%u: %.2g" : "1 sample", (unsigned)samples, error);
        before = error;
    }
    output_extra_table(o, &rows);
    panels_save(o, &all, n, 1, 0, title, "26_path_tracer_ladder.png", whole);
    shot_free(&s);
}

/* The ideas of the chapter, one by one, in the box with a ball of metal and a matte one. Each panel
 * has as many samples as make 64 rays a pixel: equal rays, not equal seconds, so that the bytes are
 * the same everywhere. */
cold_inline void draw_strategies(const options *o)
{
    enum { panels = 4, size = 10 };
    static const char *const title[panels] = {"1 directions alone", "2 and roulette",
                                              "3 and light samples", "4 and MIS"};
    int side = o->quick ? 24 : 232;
    double budget = (o->quick ? 12.0 : 64.0) * side * side;
    bool whole = true;
    image all = image_new(panels * side, side);
    for (int k = 0; k < panels && whole; k++) {
        shot s;
        char said[64];
        uint32_t n = 0;
        path_options how = path_defaults;
        how.sequence = SEQUENCE_RANDOM;
        how.roulette = k < 1 ? ROULETTE_NONE : ROULETTE_THROUGHPUT;
        how.light_sampling = k >= 2, how.mis = k >= 3;
        shot_of(&s, o, "metal", how, side, side);
        for (; whole && (double)path_rays(&s.j.counts) < budget; n++)
            whole = passes_range(render_passes(&s.j), &s.film, n, n + 1);
        snprintf(said, sizeof said, "%u samples, error %.2f", (unsigned)n, film_error(&s.film));
        image im = shot_picture(&s, 2);
        label_tag(&im, 0, side - 2 * size, size, said);
        draw_panel(&all, k, 1, im);
        shot_free(&s);
    }
    panels_save(o, &all, panels, 1, 0, title, "26_path_tracer_strategies.png", whole);
}

static inline void light_job(size_t job, void *context)
{
    light_share *l = context;
    path_pixel p;
    path_pixel_of(&path_defaults, l->seed, job, &p);
    for (uint32_t k = 0; k < l->paths; k++) {
        path_random s;
        path_sample(&p, k, 1u << 31, &s);
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

cold_inline void draw_light(const options *o)
{
    static const char *const title[2] = {"paths from the eye", "as many paths from the lamp"};
    int side = o->quick ? 48 : 360;
    uint32_t samples = o->quick ? 4 : 32;
    shot s;
    light_tracer l;
    path_counts work = {0};
    image im;
    shot_of(&s, o, "spheres", path_defaults, side, side);
    image all = image_new(2 * side, side);
    size_t paths = (size_t)side * (size_t)side * samples / light_jobs * light_jobs;
    bool whole = passes_range(render_passes(&s.j), &s.film, 0, samples);
    light_tracer_of(&s.c.s, s.c.eye, side, side, &l);
    if (whole) whole = light_picture(&l, o->seed, paths, o->threads, &im, &work);
    else im = image_new(side, side);  /* Ctrl-C stopped the first half: no second one */
    draw_panel(&all, 0, 1, shot_picture(&s, 2));
    draw_panel(&all, 1, 1, exposed(im, 2));
    panels_save(o, &all, 2, 1, 0, title, "26_path_tracer_light.png", whole);
    path_tracer_free(&l.paths), shot_free(&s);
}

#endif
