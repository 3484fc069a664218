/* Every hit of the grids equals brute force, bit for bit; the walk through the cells equals whole
 * numbers; lists, limits and work are what the headers promise. */
#include "../chapters/09_aabb/trials/pictures.h"
#include "../chapters/10_grid/lab/drift.h"
#include "../chapters/10_grid/lab/naive.h"
#include "../chapters/10_grid/trials/nested.h"
#include "structure.h"

static grid_options how;
static nested_options nested_how;
/* Without exact marking: quick. */
static const grid_options grid_by_bounds = {27, false, true, (size_t)1 << 30};
static const nested_options nested_by_bounds = {0.1, 4, false, true, (size_t)1 << 30};
STRUCTURE_TESTED(grid, how)
STRUCTURE_TESTED(nested, nested_how)

/* ---- the walk ---- */

/* The promise of walk.h: 16 epsilon D with D = 2^20, of which a wall has epsilon 2^20 / 2. */
static void test_drift(void)
{
    size_t walks = check_count(60);
    double most = 16 * (double)real_epsilon * (1 << 20);
    drift a = drift_after(walk_step_naive, 100000, walks, 1);
    drift c = drift_after(walk_step, 100000, walks, 1);
    check_at_most(c.error, most, "walls counted: off after 1e5 steps [cells]");
    check_at_least(a.error, 100 * c.error, "adding up is worse than counting");
    if (!real_is_float) check_equal(c.missed, 0, "%zu walks of 1e5 steps miss no cell", walks);
    if (real_is_float) check_at_least(a.missed, 0.5, "t added up misses cells of 1e5");
}

/* Rays of any direction through any lattice: in each cell, at the t at which it is entered and
 * left, the exact point is in it within 16 epsilon D. */
static void test_walk_keeps_its_promise(void)
{
    size_t rays = check_count(3000), steps = 0;
    double worst = 0;
    for (size_t i = 0; i < rays; i++) {
        random_stream g = random_start(12, i, 0);
        vec3 lo = random_in_cube(&g, ldexp((real)1, (int)random_below(&g, 20) - 10));
        vec3 e = random_in_cube(&g, 1), o = random_in_cube(&g, ldexp((real)1, (int)(i % 9) - 3));
        int n[3];
        for (int k = 0; k < 3; k++) n[k] = 1 + (int)random_below(&g, i % 2 ? 7 : 100);
        aabb box = {lo, vadd(lo, vmax(e, vneg(e)))};
        lattice l = lattice_of(box, n);
        ray r = ray_from(vadd(lo, o), vsub(random_in_cube(&g, 1), o));
        if (i % 7 == 0) ((real *)&r.d)[i % 3] = 0;
        if (i % 11 == 0) ((real *)&r.d)[i % 3] *= real_epsilon;
        if (i % 13 == 0) r.d = vscale(r.d, ldexp((real)1, real_is_float ? -100 : -900));
        grid_line a = line_of(r);
        real t = -real_largest, to = real_largest;
        if (!grid_span(box, &a, &t, &to)) continue;
        double D = 0;
        for (int k = 0; k < 3; k++) {
            double u = fabs((double)(vaxis(r.o, k) - vaxis(box.lo, k)));
            double v = fabs((double)(vaxis(box.hi, k) - vaxis(r.o, k)));
            D = fmax(D, fmax(u, v));
        }
        grid_walk w = walk_from(&l, &a, t);
        for (real next = t; next <= to; t = next, steps++) {
            next = walk_next_t(&w);
            for (int k = 0; k < 3; k++) {
                int at = walk_index(&l, &w, k);
                wide size = wide_of((double)vaxis(l.size, k)), low = wide_of((double)vaxis(lo, k));
                wide wall = wide_add(low, wide_mul(size, wide_of(at)));
                wide end = wide_add(low, wide_mul(size, wide_of(at + 1)));
                for (int side = 0; side < 2; side++) {
                    real s = side ? real_min(next, to) : t;
                    wide p = wide_add(wide_of((double)vaxis(a.o, k)),
                                      wide_product((double)s, (double)vaxis(a.d, k)));
                    double before = wide_value(wide_sub(wall, p));
                    double after = wide_value(wide_sub(p, end));
                    if (s >= t) worst = check_worse(worst, check_worse(before, after) / D);
                }
            }
            if (next <= to) walk_step(&w, next);
        }
    }
    check_at_most(worst, 16 * (double)real_epsilon, "%zu cells: off at entry or exit [D]", steps);
    check_at_least(steps, rays, "the rays pass cells");
}

/* ---- what naive searches lose ---- */

/* The drawing of naive.h: b stands in front of the far part of a. */
static void test_early_is_wrong(void)
{
    mesh m = mesh_room(60);
    hit h;
    set_triangle(&m, 0, (vec3){0, -1, 0}, (vec3){8, 1, 4}, (vec3){8, -1, 4});   /* a */
    set_triangle(&m, 1, (vec3){5, -1, 1}, (vec3){5, 1, 4}, (vec3){5, -1, 4});   /* b */
    for (size_t i = 2; i < 60; i++)  /* others, so that there are cells */
        set_triangle(&m, i, vec((i % 8), 3, 0), vec((i % 8), 3, 1),
                     vec((i % 8), 4, (i % 5)));
    items x = items_of_mesh(&m);
    grid g = grid_made(&x, grid_defaults);
    ray r = ray_from(vec(-1, -0.5, 3.25), (vec3){1, 0, 0});
    check(grid_hit(&g, r, &h) && h.shape == 1, "b is in front");
    size_t lost = 0;
    for (int i = 0; i < 64; i++) {
        r.o.z = (real)i / 16;
        hit e = hit_none;
        grid_hit(&g, r, &h), grid_hit_early(&g, r, &e);
        lost += e.shape != h.shape;
    }
    check_at_least(lost, 1, "who stops at the first hit found takes a for b somewhere");
    grid_free(&g), mesh_free(&m);
}

/* ---- lists, limits, work ---- */

/* Every item is in every cell that it touches, once; and in no cell beyond the margin. */
static void check_lists(const char *what, const items *x, grid_options o)
{
    grid g = grid_made(x, o);
    size_t lost = 0, astray = 0, unordered = 0, cells = lattice_cells(&g.cells), marks = 0;
    uint32_t *at = allocate(cells, sizeof *at);
    for (size_t c = 0; c < cells; c++) {
        at[c] = g.lists.first[c], marks += cell_marked(&g.lists, c);
        for (uint32_t k = at[c]; k + 1 < g.lists.first[c + 1]; k++)
            unordered += g.lists.item[k] >= g.lists.item[k + 1];
        lost += cell_marked(&g.lists, c) != (g.lists.first[c + 1] > at[c]);
    }
    for (size_t i = 0; i < x->n; i++)
        for (size_t c = 0; c < cells; c++) {
            int n0 = g.cells.n[0], n1 = g.cells.n[1];
            int k[3] = {(int)c % n0, (int)c / n0 % n1, (int)c / n0 / n1};
            bool listed = at[c] < g.lists.first[c + 1] && g.lists.item[at[c]] == i;
            aabb tight = lattice_box(&g.cells, k, k, 0);
            aabb loose = lattice_box(&g.cells, k, k, 2 * g.margin);
            at[c] += listed;
            lost += !listed && (o.exact ? items_overlap_box(x, i, tight)
                                        : items_overlap_bounds(x, i, tight));
            astray += listed && !(o.exact ? items_overlap_box(x, i, loose)
                                          : items_overlap_bounds(x, i, loose));
        }
    check_equal(lost, 0, "%s: items missing from cells that they touch", what);
    check_equal(astray, 0, "%s: items in cells that they do not touch", what);
    check_equal(unordered, 0, "%s: lists ascend", what);
    structure_stats s = grid_stats(&g);
    check_equal(s.leaves - s.empty, marks, "%s: marked cells", what);
    check(s.references == g.lists.first[cells] && s.bytes >= 4 * (s.references + s.leaves),
          "%s: %zu references in %zu bytes", what, s.references, s.bytes);
    free(at), grid_free(&g);
}

static void test_lists(void)
{
    mesh m = teapot_mesh(check_count(8) > 1 ? 3 : 2), floors = floors_mesh(2);
    items x = items_of_mesh(&m), y = items_of_mesh(&floors);
    grid_options o = grid_defaults;
    o.density = 4;
    check_lists("teapot", &x, o), check_lists("planes", &y, o);
    o.exact = false;
    check_lists("teapot, bounds", &x, o);
    mesh_free(&m), mesh_free(&floors);
}

/* (10.3): 27 n cubes, whatever the proportions, as long as an axis is not thinner than a cell. */
static void test_resolution(void)
{
    static const double side[][3] = {{1, 1, 1}, {1, 2, 4}, {100, 1, 1}, {1, 1, 1e-3}, {1, 0, 1},
                                     {1e-9, 1e-9, 1}, {0, 0, 0}, {1e9, 1, 1e-9}};
    for (size_t i = 0; i < sizeof side / sizeof *side; i++) {
        int n[3];
        const real thin = 1e-12;  /* by the margin no box is flat */
        vec3 hi = {(real)side[i][0] + thin, (real)side[i][1] + thin, (real)side[i][2] + thin};
        grid_resolution((aabb){{0, 0, 0}, hi}, 27000, thin / 1000000, n);
        double cells = (double)n[0] * n[1] * n[2], widest = 0, least = 1e300;
        for (int k = 0; k < 3; k++) {
            double size = (double)vaxis(hi, k) / n[k];
            check(n[k] >= 1, "at least one cell on an axis");
            if (n[k] > 2) widest = fmax(widest, size), least = fmin(least, size);
        }
        check(cells > 27000 / 1.5 && cells < 27000 * 1.5, "box %zu: %g cells of 27000", i, cells);
        check_at_most(widest, 1.3 * least, "box %zu: cells are cubes", i);
    }
}

/* What stats reports is what the arrays take; what suffices as a limit: structure_limited. */
static void test_bytes(void)
{
    mesh m = teapot_mesh(4);
    items x = items_of_mesh(&m);
    grid g = grid_made(&x, grid_defaults);
    const cell_lists *l = &g.lists;  /* where each list begins and the last ends; a bit a cell */
    check_equal((double)grid_stats(&g).peak,
                4 * (double)(l->cells + 1) + 4 * (double)l->references
                    + 8 * (double)(l->cells / 64 + 1), "bytes, by the arrays' lengths");
    grid_free(&g), mesh_free(&m);
}

/* No array stands behind this number: nothing is read before it is refused. */
static void test_too_many(void)
{
    items x = {NULL, NULL, UINT32_MAX};
    aabb all;
    failure f;
    check(!items_all_bounds(&x, &all, &f) && f.exit_code == 2, "2^32 - 1 items are refused");
    check(strstr(f.text, "4294967295 items: fewer than 4294967295 fit") != NULL, "%s", f.text);
}

static void test_limits(void)
{
    mesh m = teapot_mesh(8);
    items x = items_of_mesh(&m);
    failure f;
    grid g;
    nested n;
    grid_options o = grid_defaults;
    nested_options p = nested_defaults;
    o.most_bytes = 200000;  /* fewer than 4 bytes a cell */
    check(!grid_build(&x, o, &g, &f) && f.exit_code == 1 && strstr(f.text, "cells"),
          "cells beyond most_bytes are refused");
    o.most_bytes = 4 * 27 * m.triangles + 40000;  /* cells fit, references do not */
    check(!grid_build(&x, o, &g, &f) && f.exit_code == 1 && strstr(f.text, "references"),
          "references beyond most_bytes are refused");
    o = grid_defaults;
    double bad[] = {0, -1, (double)NAN, 1e-7, 1e7, (double)INFINITY};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        o.density = bad[i];
        check(!grid_build(&x, o, &g, &f) && f.exit_code == 2, "density %g is refused", bad[i]);
        p = nested_defaults, p.inner = bad[i];
        check(!nested_build(&x, p, &n, &f) && f.exit_code == 2, "inner %g is refused", bad[i]);
    }
    p = nested_defaults, p.most_bytes = 100000;
    check(!nested_build(&x, p, &n, &f) && f.exit_code == 1, "two levels beyond most_bytes");
    nested_free(&n), nested_free(&n), grid_free(&g);
    mesh_free(&m);
}

/* From 1e-280 to 1e74 (float: 1e-25 to 1e5) a box has as many cells as at size 1, though its volume
 * is no double. */
static void test_sizes(void)
{
    int least = real_is_float ? -25 : -280, most = real_is_float ? 5 : 74;
    for (int e = least; e <= most; e += (most - least) / 6) {
        mesh m = torus_mesh(8);
        real scale = pow((real)10, (real)e);
        for (size_t i = 0; i < m.vertices; i++) m.v[i] = vscale(m.v[i], scale);
        items x = items_of_mesh(&m);
        grid g = grid_made(&x, grid_defaults);
        nested n = nested_made(&x, nested_defaults);
        check_at_least(lattice_cells(&g.cells), 20 * m.triangles, "a grid of size 1e%d", e);
        grid_free(&g), nested_free(&n), mesh_free(&m);
    }
}

/* What a ray costs is not O(n), from wherever a camera stands: D up to 1023 sizes goes straight
 * through the cells (float: 3), and 1e6 sizes away (1e3) rays still ask some layers of cells. */
static void test_far_rays_are_cheap(void)
{
    static const double away_double[] = {2, 300, 1000, 1e4, 1e6}, away_float[] = {2, 20, 100};
    const double *away = real_is_float ? away_float : away_double;
    mesh m = teapot_mesh(24);
    items x = items_of_mesh(&m);
    grid g = grid_made(&x, grid_defaults);
    nested n = nested_made(&x, nested_defaults);
    for (size_t k = 0; k < (real_is_float ? 3 : 5); k++) {
        search_work w = {0, 0, 0, 0}, v = w;
        size_t rays = 200, wrong = 0;
        for (size_t i = 0; i < rays; i++) {
            random_stream s = random_start(15, i, 0);
            vec3 o = vscale(vunit(random_in_cube(&s, 1)), (real)(6.4 * away[k]));
            ray r = ray_from(o, vsub(m.v[random_below(&s, m.vertices)], o));
            hit a = hit_none, b = hit_none, c = hit_none;
            bool ga = i % 10 == 0 && items_hit(&x, r, &a);
            bool gb = grid_hit_counted(&g, r, &b, &w), gc = nested_hit_counted(&n, r, &c, &v);
            wrong += !same(gb, b, gc, c) || (i % 10 == 0 && !same(ga, a, gb, b));
        }
        check_equal(wrong, 0, "%g sizes away: wrong", away[k]);
        check_at_most(w.tests / rays, m.triangles / 50, "%g sizes away: tests a ray", away[k]);
        check_at_most(v.tests / rays, m.triangles / 10, "%g sizes away, two levels", away[k]);
        check_at_most(w.nodes / rays, 2000, "%g sizes away: cells a ray", away[k]);
    }
    grid_free(&g), nested_free(&n), mesh_free(&m);
}

/* Planes from so far away that rounding moves their hits across the walls of cells. */
static void test_far_rays_are_right(void)
{
    size_t rays = check_count(4000), wrong = 0, wrong_two = 0, wrong_plain = 0, hits = 0;
    mesh m = floors_mesh(4);
    items x = items_of_mesh(&m);
    grid g = grid_made(&x, grid_defaults);
    nested two = nested_made(&x, nested_defaults);
    for (size_t i = 0; i < rays; i++) {
        random_stream s = random_start(18, i, 0);
        int power = (int)(i % 8) + (real_is_float ? 1 : 6);
        vec3 o = random_in_cube(&s, pow((real)10, (real)power));
        ray r = ray_from(o, vsub(m.v[random_below(&s, m.vertices)], o));
        hit a = hit_none, b = hit_none, c = hit_none, d = hit_none;
        bool ga = items_hit(&x, r, &a), gb = grid_hit(&g, r, &b), gc = nested_hit(&two, r, &c);
        bool gd = grid_search_plain(&g, r, walk_step, false, &d);
        hits += ga, wrong += !same(ga, a, gb, b), wrong_two += !same(ga, a, gc, c);
        wrong_plain += !same(ga, a, gd, d);
    }
    check_equal(wrong, 0, "planes from afar: wrong of %zu, %zu hits", rays, hits);
    check_equal(wrong_two, 0, "planes from afar, two levels");
    check_at_least(hits, rays / 2, "they are hit");
    if (rays >= 200)
        check_at_least(wrong_plain, 1, "a walk that does not care for the distance loses some");
    grid_free(&g), nested_free(&two), mesh_free(&m);
}

/* The mailbox saves tests and changes no answer; exact marking leaves fewer references. */
static void test_mailbox_and_marking(void)
{
    mesh m = needles(700, 0.05);
    items x = items_of_mesh(&m);
    grid g[3];
    search_work w[3] = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}};
    size_t wrong = 0;
    for (int k = 0; k < 3; k++) {
        grid_options o = grid_defaults;
        o.exact = k != 2, o.mailbox = k != 1;
        g[k] = grid_made(&x, o);
    }
    for (size_t i = 0; i < check_count(1000); i++) {
        ray r = structure_across(16, i, 3, 1);
        hit a = hit_none, b = hit_none, c = hit_none;
        bool ga = grid_hit_counted(&g[0], r, &a, &w[0]);
        bool gb = grid_hit_counted(&g[1], r, &b, &w[1]);
        bool gc = grid_hit_counted(&g[2], r, &c, &w[2]);
        wrong += !same(ga, a, gb, b) || !same(ga, a, gc, c);
    }
    check_equal(wrong, 0, "mailbox or not, exact or not: the same hits");
    check_at_least(2 * w[1].tests, 3 * w[0].tests, "without it needles are tested again and again");
    check_at_least(g[2].lists.references, 2 * g[0].lists.references, "bounds of slanted needles");
    for (int k = 0; k < 3; k++) grid_free(&g[k]);
    mesh_free(&m);
}

/* Panels of a picture, and no structure in them. */
static int panels_asked[3];
static bool nothing_built(const trial_scene *s, const void *none, void *out, failure *f)
{
    (void)s, (void)none, (void)out, (void)f;
    return true;
}
static void nothing_freed(void *b) { (void)b; }
static vec3 stopping_colour(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    (void)x, (void)y;
    panels_asked[(int)p->most]++;
    if (p->most == 1 && panels_asked[1] == 1) raise(SIGINT);
    return vec(1, 1, 1);
}

/* One Ctrl-C stops all panels that are to come, and after its pixel the one in hand. */
static void test_panels_stop(void)
{
    const trial_verbs verbs = {.size = 1, .build = nothing_built, .free = nothing_freed};
    const trial_scene s = {.due = NULL};
    trial_panel panel[3];
    image all = image_new(96, 32);
    for (int k = 0; k < 3; k++)
        panel[k] = (trial_panel){.s = &s, .verbs = &verbs, .most = (real)k, .samples = 1,
                                 .colour = stopping_colour};
    signal(SIGINT, SIG_DFL);  /* in the background it may be ignored, and stays so (parallel.h) */
    check(!trial_draw_panels(&all, 3, 1, 0, panel, false, 1),
          "three panels, stopped in the second");
    check(panels_asked[0] == 32 * 32 && panels_asked[1] == 1 && panels_asked[2] == 0,
          "asked: %d of the first, %d (a pixel) of the second, %d of the third", panels_asked[0],
          panels_asked[1], panels_asked[2]);
    image_free(&all);
}

/* One triangle, many times: its outer cells hold all of them, and cutting parts none of them. */
static void test_copies(void)
{
    enum { copies = 2500 };
    mesh m = structure_copies(copies, (vec3){0, 0, 0}, (vec3){1, 0, 0}, (vec3){0, 1, 0}, 1);
    hit h = hit_none;
    items all = items_of_mesh(&m);
    nested x = nested_made(&all, nested_defaults);
    double outer = 0.7 * (double)nested_stats(&x).inner * copies;  /* half, and the slant */
    check_at_most((double)nested_stats(&x).references, structure_room(copies) + outer,
                  "cells that the copies are named in");
    check(nested_hit(&x, ray_from(vec(0.2, 0.3, 1), vec(0, 0, -1)), &h) && h.shape == 0,
          "the first is hit");
    nested_free(&x), mesh_free(&m);
}

/* All in one place, and flat: what grid_fit expects of a few cells holds of those it chooses. Of
 * all cells it would expect too much, as such a triangle is in half of them: one would be left. */
static void test_pile(size_t n)
{
    mesh m = structure_copies(n, (vec3){0, 0, 0}, (vec3){1, 0, 0}, (vec3){0, 1, 0}, 1);
    grid g;
    hit h = {0};
    failure f = {0, ""};
    items x = items_of_mesh(&m);
    check(grid_build(&x, grid_defaults, &g, &f), "a pile: %s", f.text);
    double each = (double)grid_stats(&g).references / (double)n;
    check_at_least(each, 8, "cells of a triangle of a pile");
    check_at_most(each, 64, "cells of a triangle of a pile");
    check(grid_hit(&g, ray_from(vec(0.2, 0.3, 1), vec(0, 0, -1)), &h) && h.shape == 0, "is hit");
    grid_free(&g), mesh_free(&m);
}

static void test_piles(void) { test_pile(1000), test_pile(30000); }

int main(void)
{
    structure s = {"grid", STRUCTURE_OF(grid)};
    structure two = {"two-level grid", STRUCTURE_OF(nested)};
    how = grid_defaults;
    structure_tests(&s, check_count(600));
    nested_how = nested_defaults;
    structure_tests(&two, check_count(600));
    for (int k = 0; k < 4; k++) {
        how = (grid_options){k == 0 ? 1e-3 : k == 1 ? 1 : 80, k != 1, k == 3, (size_t)1 << 28};
        structure_brief(&s, check_count(240));
        structure_mesh(&s, "from 2e3 away", torus_mesh(12), check_count(240), (vec3){0, 0, 0}, 1,
                       2000);
    }
    structure_ends(grid, grid_defaults, check_count(4000));
    structure_ends(nested, nested_defaults, check_count(4000));
    structure_limited(grid, grid_by_bounds, teapot_mesh(4), 1);
    structure_limited(nested, nested_by_bounds, teapot_mesh(4), 1);
    structure_piled(grid, grid_defaults, 10000, structure_room(10000) + 0x1p24);
    return check_all("10_grid", test_drift, test_walk_keeps_its_promise, test_early_is_wrong,
                     test_lists, test_resolution, test_limits, test_bytes, test_too_many,
                     test_sizes, test_far_rays_are_cheap, test_far_rays_are_right,
                     test_mailbox_and_marking, test_copies, test_panels_stop, test_piles);
}
