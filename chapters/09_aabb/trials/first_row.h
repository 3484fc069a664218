/* first_row.h: the row `first` of the tables: what the notes' structure takes for the same rays.
 *
 *   first_search s = {built, hit};
 *   first_cells(&t, s, &primary, &diffuse, &hard, brute, rounds)   four cells: tests a ray, wrong
 *                       hits of the rays `hard`, time of a primary and of a diffuse ray [ns]
 *   first_seconds(s, &rays, rounds), first_tests_a_ray(s, &rays), first_wrong(s, &rays, brute)
 *
 * brute: the hits of brute force with triangle_hit, so that the slips of the notes' own triangle
 * test count, too: see as_first.h.
 */
#ifndef FIRST_ROW_H
#define FIRST_ROW_H

#include "../../../common/lab/table.h"
#include "../../07_mesh/scenes/as_first.h"
#include "survey.h"

typedef struct { const void *built; bool (*hit)(const void *built, ray r, hit *out); } first_search;

/* ---------------------------------------------------------------------------------------------- */

typedef struct { first_search s; const ray_set *rays; } first_pass;

static inline double first_pass_run(void *context)
{
    const first_pass *p = context;
    size_t hits = 0;
    hit h;
    for (size_t i = 0; i < p->rays->n; i++) hits += p->s.hit(p->s.built, p->rays->r[i], &h);
    return (double)hits;
}

/* Median of a pass, of so many. */
static inline double first_seconds(first_search s, const ray_set *rays, int rounds)
{
    first_pass p = {s, rays};
    clock_variant v = {"first", first_pass_run, &p, 0};
    clock_compare(&v, 1, rounds);
    return v.seconds;
}

static inline double first_tests_a_ray(first_search s, const ray_set *rays)
{
    first_pass p = {s, rays};
    long before = first_tests;
    clock_kept = first_pass_run(&p);
    return rays->n ? (double)(first_tests - before) / (double)rays->n : 0;
}

/* Where a list of hits has t = 0 there is none. */
static inline size_t first_wrong(first_search s, const ray_set *rays, const hit *brute)
{
    size_t wrong = 0;
    for (size_t i = 0; i < rays->n; i++) {
        hit h = hit_none;
        s.hit(s.built, rays->r[i], &h);
        wrong += first_is_wrong(h, brute[i].t == 0 ? hit_none : brute[i]);
    }
    return wrong;
}

/* Returns the seconds of all primary and diffuse rays. */
static inline double first_cells(table *out, first_search s, const ray_set *primary,
                                 const ray_set *diffuse, const ray_set *hard, const hit *brute,
                                 int rounds)
{
    double p = (double)primary->n, d = (double)diffuse->n;
    table_number(out, (p * first_tests_a_ray(s, primary) + d * first_tests_a_ray(s, diffuse))
                          / (p + d));
    table_count(out, first_wrong(s, hard, brute));
    double primary_seconds = first_seconds(s, primary, rounds);
    double diffuse_seconds = first_seconds(s, diffuse, rounds);
    table_number(out, primary_seconds * 1e9 / p), table_number(out, diffuse_seconds * 1e9 / d);
    return primary_seconds + diffuse_seconds;
}

#endif
