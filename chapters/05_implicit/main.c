/* 05_implicit: surfaces f(p) = 0 by steps, Newton, sphere tracing, intervals: what each misses.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 05_implicit chapters/05_implicit/main.c -lm -lpthread
 *
 * Without options: Barth's sextic, three ways along one ray, a table; --full: what steps miss
 * of it, other surfaces, more tables.
 * --surface, --method, --turn ..: one picture of that. */
#include "lab/implicit_figure.h"
#include "lab/implicit_measure.h"
#include "lab/implicit_pictures.h"

typedef struct {
    const char *surface, *method;
    int steps;
    double eps, turn, rise;
} wishes;

static const char *const method_name[implicit_kinds] = {"first", "newton", "trace", "interval"};

static int named(const char *what, const char *text, const char *const *name, int n)
{
    char all[128] = "";
    for (int k = 0; k < n; k++) {
        if (strcmp(text, name[k]) == 0) return k;
        size_t used = strlen(all);
        snprintf(all + used, sizeof all - used, "%s%s", k ? ", " : "", name[k]);
    }
    die(2, "--%s %s: allowed are %s", what, text, all);
}

static implicit_view wanted(const wishes *w)
{
    int surface = named("surface", w->surface, implicit_name_of, implicit_names);
    implicit_kind kind = (implicit_kind)named("method", w->method, method_name, implicit_kinds);
    implicit_how how = {kind, w->steps ? w->steps : kind == IMPLICIT_TRACE ? 4096 : 64,
                        (real)w->eps};
    return implicit_view_of(implicit_subject_of((implicit_name)surface), how, (real)w->turn,
                            (real)w->rise);
}

int main(int argc, char **argv)
{
    const wishes book = {"barth", "interval", 0, 1e-4, 22, 20};
    wishes w = book;
    const option list[] = {
        {"surface", OPTION_TEXT, &w.surface, 0, 0,
         "sphere, torus, tube (a torus by distance), barth, gyroid, box or blend"},
        {"method", OPTION_TEXT, &w.method, 0, 0, "first, newton, trace or interval"},
        {"steps", OPTION_INT, &w.steps, 0, 1000000, "of the method; 0: 64, trace 4096 at most"},
        {"eps", OPTION_REAL, &w.eps, 1e-12, 1, "trace: so near is a hit"},
        {"turn", OPTION_REAL, &w.turn, -360, 360, "of the eye around the vertical [degrees]"},
        {"rise", OPTION_REAL, &w.rise, -89, 89, "of the eye over the horizon [degrees]"}, {0}};
    options o = {.width = 960, .height = 640, .samples = 9, .seed = 1};
    o = options_read(argc, argv, "05_implicit", "Surfaces f(p) = 0, and who misses what.", o, list);
    if (o.quick && o.samples == 9) o.samples = 1;  /* what was asked for stays */
    if (o.quick && o.width == 960 && o.height == 640) o.width = 240, o.height = 160;
    implicit_view v = wanted(&w);
    o.own = w.surface != book.surface || w.method != book.method || w.steps != book.steps
         || w.eps != book.eps || w.turn != book.turn || w.rise != book.rise;
    if (o.own && o.csv) die(2, "--csv: no table with a surface or a method of one's own");
    implicit_draw(&o, &v, "05_implicit.png");
    if (o.own) return output_done(&o);
    implicit_draw_roots(&o);
    if (o.full || o.quick) implicit_draw_missed(&o), implicit_draw_shapes(&o);
    implicit_measure(&o);
    return output_done(&o);
}
