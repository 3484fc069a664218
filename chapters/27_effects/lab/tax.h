/* tax.h: what being general costs: the general program against chapters 18, 19 and 26, each on a
 * scene of its kind, by its own code: casting rays, Whitted's tree, paths.
 *
 *   bool whole = table_of_tax(&o, &least)   prints both in turn, one thread: medians; false: Ctrl-C
 *                                           least: the smallest ratio of speeds
 *   bool kept = tax_verdict(least)          says whether that is at least tax_least
 *
 * 26 ends paths and splits at glass by other dice than 27, so that it sends another number of rays;
 * tests/27_radiance.c compares their light.
 */
#ifndef EFFECTS_TAX_H
#define EFFECTS_TAX_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"  /* before shape.h, whose name it uses for its own */
#include "../../19_whitted/scenes/forty.h"
#include "../../26_path_tracer/render.h"
#include "../files/studio_read.h"
#include "../plan.h"
#include "classic.h"
#include "draw.h"

/* ---- the scenes ---- */

enum { FORTY_PAINTED, FORTY_MIRROR, FORTY_GLASS, forty_kinds };  /* one after the other */

/* The balls of 19's forty.h, on one colour of ground; plain: all of them painted. */
static inline char *forty_text(bool plain)
{
    enum { room = 1 << 14 };
    char *text = allocate(room, 1);
    size_t n = (size_t)snprintf(text, room,
        "camera from 0 -11 4.5 at 0 0.4 0.9 up 0 0 1 angle 31\nindirect off\n"
        "background 0.35 0.55 0.85\nsun to 5 -6 9 colour 2\nsun to -6 -4 5 colour 0.7\n"
        "sun to 1 8 6 colour 0.4\n"
        "material mirror\nKd 0\nKs 0.9\nillum 3\nmaterial glass\nKd 0\nNi 1.5\nTf 1\nillum 7\n");
    for (int k = 0; k < forty_balls; k++) {
        const int *b = forty_ball[k], kind = plain ? FORTY_PAINTED : k % forty_kinds;
        if (kind != FORTY_PAINTED)
            n += (size_t)snprintf(text + n, room - n, "use %s\n",
                                  kind == FORTY_MIRROR ? "mirror" : "glass");
        else n += (size_t)snprintf(text + n, room - n,
                                   "material paint%d\nKd %g %g %g\nillum 1\n", k,
                                   0.3 + 0.15 * (k * 7 % 5), 0.3 + 0.15 * (k * 3 % 5),
                                   0.3 + 0.1 * (k * 11 % 7));
        n += (size_t)snprintf(text + n, room - n, "sphere %g %g %g %g\n", b[0] / 1e3, b[1] / 1e3,
                              b[2] / 1e3, b[3] / 1e3);
    }
    return text;
}

static const char tax_room[] =
    "camera from 0 1 3.9 at 0 1 0 angle 50\nmaterial white\nKd 0.7\nillum 1\n"
    "polygon -1 0 4  1 0 4  1 0 -1  -1 0 -1\npolygon -1 0 -1  1 0 -1  1 2 -1  -1 2 -1\n"
    "polygon 1 0 4  -1 0 4  -1 2 4  1 2 4\n"
    "material red\nKd 0.6 0.1 0.1\nillum 1\npolygon -1 0 4  -1 0 -1  -1 2 -1  -1 2 4\n"
    "material green\nKd 0.1 0.5 0.1\nillum 1\npolygon 1 0 -1  1 0 4  1 2 4  1 2 -1\n"
    "material lamp\nKe 3 2.5 2\npolygon -1 2 4  -1 2 -1  1 2 -1  1 2 4\n"
    "material mirror\nKd 0\nKs 1\nillum 3\nsphere -0.5 0.4 -0.3 0.4\n"
    "material glass\nKd 0\nNi 1.5\nTf 1\nabsorb 0.3 1 1.5\nillum 7\nsphere 0.45 0.45 0.5 0.4\n";

/* ---- how fast ---- */

typedef enum { TAX_SHADE, TAX_WHITTED, TAX_PATHS, tax_rows } tax_row;
static const struct { const char *scene, *chapter; } tax_of[tax_rows] = {
    {"forty balls: painted", "18 shade"}, {"forty balls: mirrors and glass", "19 whitted"},
    {"room: mirror, glass, paths", "26 path tracer"}};
static const double tax_least = 0.95;
typedef struct {
    tax_row row;
    classic c;
    lit_scene lit;
    drawing here;
    image im;
    size_t rays;
    bool stopped;
} tax_run;

static inline void tax_pixel(int x, int y, void *context)
{
    tax_run *k = context;
    ray r = camera_ray(k->c.e->eye, (real)x + (real)0.5, (real)y + (real)0.5, k->im.width,
                       k->im.height);
    r.tmin = k->c.e->hither;
    image_set(&k->im, x, y, k->row == TAX_WHITTED ? classic_whitted(&k->c, r)
                                                  : classic_shade(&k->c, r));
}

/* Its own way. 18 and 19 send the rays that 27 sends: nobody counts them. */
static inline double tax_own(void *context)
{
    tax_run *k = context;
    if (k->row != TAX_PATHS) {
        k->stopped |= !parallel_pixels(k->im.width, k->im.height, 1, "chapter", tax_pixel, k);
        return (double)k->im.rgb[0];
    }
    path_tracer t;
    path_tracer_of(&k->lit, NULL, path_defaults, &t);
    render_job j = {.tracer = &t, .eye = k->here.e->eye, .seed = 1, .threads = 1};
    film f = film_new(k->im.width, k->im.height);
    k->stopped |= !passes_range(render_passes(&j), &f, 0, (uint32_t)k->here.samples);
    k->rays = path_rays(&j.counts), k->here.error = film_error(&f);
    film_free(&f), path_tracer_free(&t);
    return (double)k->rays;
}

static inline double tax_here(void *context)
{
    tax_run *k = context;
    image_free(&k->im);
    k->stopped |= !draw_image(&k->here, &k->im, 1);
    k->rays = draw_rays(&k->here.counts);
    return (double)k->im.rgb[0];
}

static inline bool tax_add(const options *o, table *t, tax_row row, double *least)
{
    bool paths = row == TAX_PATHS;
    int w = o->quick ? 48 : paths ? 160 : 240, h = w * 3 / 4, samples = paths ? 16 : 1;
    effects_ready q;
    failure f;
    char *balls = forty_text(row == TAX_SHADE);
    if (!studio_read_text(paths ? tax_room : balls, "tax.scene", NULL, &q.s, &f)) fail(f);
    if (!effects_get_ready(&q, 4 / (real)3, &f)) fail(f);
    tax_run run[2];
    for (int i = 0; i < 2; i++)
        run[i] = (tax_run){.row = row, .im = image_new(w, h),
                           .here = {.e = &q.e, .samples = samples, .seed = 1, .width = w,
                                    .height = h}};
    if (paths) classic_lit(&q.s, &run[0].lit);
    else classic_build(&q.e, &run[0].c);
    bench_candidate k[2] = {{.run = tax_own, .context = &run[0]},
                            {.run = tax_here, .context = &run[1]}};
    bench_time(k, 2, o->quick ? 3 : 7);
    if (!paths) run[0].rays = run[1].rays;
    table_text(t, "%s", tax_of[row].scene), table_text(t, "%s", tax_of[row].chapter);
    for (int i = 0; i < 2; i++) table_number(t, (double)run[i].rays / ((double)w * h * samples));
    double ns[2];
    for (int i = 0; i < 2; i++)
        table_number(t, ns[i] = k[i].seconds / (double)run[i].rays * 1e9), image_free(&run[i].im);
    table_number(t, ns[0] / ns[1]);
    for (int i = 0; i < 2; i++)
        if (paths) table_number(t, run[i].here.error);
        else table_text(t, "-");
    *least = fmin(*least, ns[0] / ns[1]);
    if (paths) lit_free(&run[0].lit);
    else classic_free(&run[0].c);
    effects_ready_free(&q), free(balls);
    return !run[0].stopped && !run[1].stopped;
}

static inline bool table_of_tax(const options *o, double *least)
{
    table t = table_new("The general program against the chapters' own, in turn, one thread",
                        "scene|chapter|rays a sample: its own|here|its own [ns/ray]|here [ns/ray]|"
                        "ratio of speeds|its own error (20.22)|here");
    bool whole = true;
    *least = HUGE_VAL;
    for (int k = 0; k < tax_rows && whole; k++) whole = tax_add(o, &t, (tax_row)k, least);
    if (whole) output_extra_table(o, &t);
    else table_free(&t);
    return whole;
}

static inline bool tax_verdict(double least)
{
    bool kept = least >= tax_least;
    printf("each ratio of speeds is to be at least %g: %s, the least is %.3g\n", tax_least,
           kept ? "it is" : "it is not", least);
    return kept;
}

#endif
