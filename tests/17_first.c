/* 17's first.h: six structures, and brute force: the same hits on easy rays, those of 07's
 * mesh_hit; and nothing to hold. (What is hard, each chapter's own tests ask: first_structure.h.)
 */
#include "check.h"
#include "../common/random.h"
#include "../chapters/07_mesh/closest.h"
#include "../chapters/07_mesh/scenes/as_first.h"
#include "../chapters/07_mesh/scenes/teapot.h"
#include "../chapters/17_compare/first.h"

/* Hits of every structure against first_mesh_hit's, and, if m is given, its against mesh_hit's. */
static void compare(const first_mesh *f, const mesh *m, vec3 middle, real size, const char *what)
{
    static first_contest c;
    size_t n = check_count(8000), hits = 0, wrong[first_structures] = {0}, robust = 0;
    first_contest_build(f, &c);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(1, i, 0);
        vec3 from = vadd(middle, vscale(vunit(random_in_cube(&g, 1)), 3 * size));
        ray r = ray_between(from, vadd(middle, random_in_cube(&g, size)));
        if (i % 2) r.tmax = real_infinity;
        hit due = hit_none, robust_hit = hit_none;
        first_mesh_hit(f, r, &due);
        hits += due.shape != no_shape;
        if (m) mesh_hit(m, r, &robust_hit), robust += first_is_wrong(due, robust_hit);
        for (int s = 0; s < first_structures; s++) {
            hit h = hit_none;
            bool met = first_contest_hit(&c, s, r, &h);
            wrong[s] += met != (due.shape != no_shape) || (met && h.t != due.t);
        }
    }
    for (int s = 0; s < first_structures; s++)
        check_at_most(wrong[s], real_is_float ? n / 5000 : 0, "%s: %s, of %zu hits", what,
                      first_structure_name[s], hits);
    if (m) check_at_least(hits, n / 4, "%s: rays that hit", what);
    if (m) check_at_most(robust, n / 2000, "%s: as mesh_hit has it, but at seams", what);
    first_contest_free(&c);
}

static void test_easy(void)
{
    mesh pot = teapot_mesh(4);
    first_mesh f = first_mesh_of(&pot), knot = first_knot(60, 8);
    vec3 lo, hi;
    mesh_bounds(&pot, &lo, &hi);
    compare(&f, &pot, vscale(vadd(lo, hi), (real)0.5), vlength(vsub(hi, lo)) / 4, "teapot");
    compare(&knot, NULL, (vec3){0, 0, 0}, 3, "knot");
    mesh_free(&pot), first_mesh_free(&f), first_mesh_free(&knot);
}

static void test_nothing(void)
{
    static first_contest c;
    const first_mesh none = {NULL, 0};
    hit h;
    first_contest_build(&none, &c);
    for (int s = 0; s < first_structures; s++)
        check(!first_contest_hit(&c, s, ray_from((vec3){0, 0, 1}, (vec3){0, 0, -1}), &h),
              "%s: of nothing no hit", first_structure_name[s]);
    first_contest_free(&c);
}

int main(void)
{
    test_easy();
    test_nothing();
    return check_report("17_first");
}
