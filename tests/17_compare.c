/* The bench itself: all structures give the same hits on all scenes; a structure that is broken on
 * purpose is found out and explained; costs add up; and the program, seen from outside. */
#include "../chapters/17_compare/lab/run.h"
#include "../chapters/06_csg/lab/csg_oracle.h"
#include "child.h"
#include "program.h"
#include "structure.h"

static const contender_settings as_it_is = {.n = 0};

static world tiny(const char *name)
{
    world w;
    failure f;
    for (int k = 0; k < scenes; k++)
        if (strcmp(scene_list[k].name, name) == 0
            && !scene_world(scene_find(name), scene_list[k].quick, &w, &f)) fail(f);
    return w;
}

/* All but the first versions, which may be wrong: below. */
static line_up everybody(void)
{
    line_up all = {.n = 0};
    for (int k = 0; k < contenders; k++)
        if (!contender_is_first(contender_list[k])) choose(&all, contender_list[k]);
    return all;
}

/* Built, with n rays of a kind. */
static void begin(comparison *s, const world *w, const line_up *chosen, size_t n)
{
    compare_begin(s, w, chosen, (size_t)1 << 30, 1);
    compare_rays(s, n, 7);
}

/* Counted searches find the same, and count. */
static void test_counted(const comparison *s, const compare_entry *e)
{
    size_t wrong = 0, hits = 0, n = s->rays[KIND_DIFFUSE].n;
    search_work sum = {0, 0, 0, 0}, any = {0, 0, 0, 0};
    for (size_t k = 0; k < n; k++) {
        ray r = s->rays[KIND_DIFFUSE].r[k];
        hit a = hit_none, b = hit_none;
        bool found = e->c->hit(e->s, r, &a);
        wrong += e->c->counted(e->s, r, false, &b, &sum) != found || !hits_same(a, b);
        wrong += e->c->counted(e->s, r, true, &b, &any) != found;
        hits += found;
    }
    check_equal(wrong, 0, "%s: counting changes nothing", e->c->name);
    check_at_least(sum.tests, hits, "%s: a hit was tested", e->c->name);
    check_at_most(any.tests, sum.tests, "%s: any hit takes no more tests", e->c->name);
    check(e->c == &brute_contender ? sum.tests == s->x.n * n : sum.tests < s->x.n * n,
          "%s: %zu tests", e->c->name, sum.tests);
}

static void test_equality(void)
{
    line_up all = everybody();
    for (int k = 0; k < scenes; k++) {
        comparison s;
        world w = tiny(scene_list[k].name);
        char *text;
        size_t length;
        FILE *out = open_memstream(&text, &length);
        begin(&s, &w, &all, 144);
        check(s.share == 1, "%s has all rays: %g steps each", w.name, s.work);
        check(compare_prove(&s, SIZE_MAX, check_count(1000), 7, out),
              "%s: all structures agree", w.name);
        fclose(out);
        check(length == 0, "%s: nothing to explain, but: %s", w.name, text);
        check_at_least(s.by_brute, check_count(1000) * 3 / 4, "%s: so many by brute force", w.name);
        check_at_least(s.proved, s.by_brute, "%s: and more by each other", w.name);
        for (int i = 0; i < s.entries; i++) {
            const compare_entry *e = &s.entry[i];
            check(e->s != NULL, "%s fits: %s", e->c->name, e->s ? "" : e->why.text);
            if (!e->s) continue;
            check_at_least(e->stats.references, e->stats.items, "%s %s: every shape is somewhere",
                           w.name, e->c->name);
            check_equal(e->stats.items, s.x.n, "%s %s: holds them all", w.name, e->c->name);
            check(e->stats.leaves >= 1 && e->stats.peak >= e->stats.bytes, "%s: its numbers",
                  e->c->name);
            if (strcmp(w.name, "teapot") == 0) test_counted(&s, e);
        }
        free(text);
        compare_end(&s);
        world_free(&w);
    }
}

/* Solids (06) against who asks no spans: along each ray up to its hit no point is in any of them,
 * and behind the hit, in that one. */
static void test_solids(void)
{
    static const csg_operation operation[] = {CSG_UNION, CSG_INTERSECTION, CSG_DIFFERENCE};
    size_t wrong = 0, missed = 0, judged = 0, turned = 0, kinds[3] = {0}, hits = 0;
    double step = real_is_float ? 1e-4 : 1e-6, margin;
    world w = tiny("solids");
    const carved_all *all = w.others;
    scene s = world_scene(&w);
    check_equal(all->n + 1, w.n, "each solid is a shape, and the square is one");
    for (size_t i = 0; i < all->n; i++)
        for (size_t k = 0; k < all->of[i].c.nodes; k++)
            for (int j = 0; j < 3; j++) kinds[j] += all->of[i].step[k].what == operation[j];
    for (int j = 0; j < 3; j++) check_at_least(kinds[j], 1, "operation %d is used", j);
    ray_set set = rays_everywhere(&w, check_count(2000), 5);
    for (size_t i = 0; i < set.n; i++) {
        random_stream g = random_start(6, i, 0);
        const shape_other *at = &all->of[random_below(&g, all->n)].other;
        vec3 middle = vscale(vadd(at->lo, at->hi), (real)0.5);
        ray r = ray_from(set.r[i].o, vsub(vadd(middle, random_in_cube(&g, (real)0.3)), set.r[i].o));
        hit h = hit_none, next;
        bool met = scene_hit(&s, r, &h);
        double far = met ? (double)h.t : 2, length = (double)vlength(r.d);
        for (size_t k = 0; k < all->n; k++) {  /* solids touch nobody: a ray may begin in one */
            const carved *x = &all->of[k];
            csg_model m = {x->solid, x->c.solids, x->step, x->c.nodes};
            bool begins = oracle_contains(m, wide3_of(r.o), &margin);
            for (int j = 1; j < 16; j++) {
                bool in = oracle_contains(m, oracle_on(r, far * j / 16), &margin);
                missed += margin > step && in != begins;
            }
            if (!met || h.shape != k + 1) continue;
            double before, after;
            bool from = oracle_contains(m, oracle_on(r, far - step / length), &before);
            bool to = oracle_contains(m, oracle_on(r, far + step / length), &after);
            ray on = r;
            on.tmin = h.t + (real)(step / 100 / length);
            bool sliver = carved_hit(&x->c, on, &next)
                && (double)(next.t - h.t) * length < 2 * step;
            if (sliver || before < step / 8 || after < step / 8) continue;  /* grazing */
            judged++, turned += (uint32_t)h.u % 2, wrong += from == to;
        }
        hits += met;
    }
    check_equal(missed, 0, "nothing lies before a hit");
    check_equal(wrong, 0, "each hit leads into its solid, or out of it, of %zu", judged);
    check_at_least(judged, hits / 4, "hits are judged");
    check_at_least(turned, judged / 50, "where something was cut away, too");
    rays_free(&set), world_free(&w);
}

/* How many fit into so many bytes; *most: what they held at any time, building included. */
static size_t fit_within(const world *w, const line_up *all, size_t limit, size_t *most)
{
    comparison s;
    size_t held = 0, fit = 0;
    *most = 0;
    compare_begin(&s, w, all, limit, 1);
    for (const compare_entry *e = s.entry; e < s.entry + s.entries; e++) {
        if (held + e->stats.peak > *most) *most = held + e->stats.peak;
        held += e->stats.bytes, fit += e->s != NULL;
        if (!e->s) check(strlen(e->why.text) > 5, "%s says why", e->c->name);
    }
    check_at_most(*most, limit, "%zu structures within the limit", fit);
    compare_end(&s);
    return fit;
}

static void test_memory(void)
{
    line_up all = everybody();
    world w = tiny("soup");
    size_t bytes, most, fit[4];
    check_equal(fit_within(&w, &all, (size_t)1 << 30, &bytes), (size_t)all.n, "all fit");
    for (size_t part = 1; part < 4; part++)
        fit[part] = fit_within(&w, &all, bytes * part / 3, &most);
    check(fit[1] > 1 && fit[1] < fit[3], "%zu, %zu, %zu fit", fit[1], fit[2], fit[3]);
    world_free(&w);
}

/* In 1000 bytes; what does not fit is not timed, and does not hinder it. Its shadow rays count. */
static void test_brute_alone(void)
{
    line_up all = everybody();
    world w = tiny("soup");
    comparison s;
    compare_entry *e = &s.entry[0];
    size_t hits = 0;
    search_work any = {0, 0, 0, 0};
    compare_begin(&s, &w, &all, 1000, 1);
    for (int k = 0; k < s.entries; k++)
        check((s.entry[k].s != NULL) == (s.entry[k].c == &brute_contender), "brute force alone");
    compare_rays(&s, 64, 1);
    check(compare_prove(&s, SIZE_MAX, 40, 1, stdout), "and agrees with itself");
    cost_measure(&s, 1);
    check(e->seconds[KIND_PRIMARY] > 0 && s.entry[1].seconds[KIND_PRIMARY] == 0, "is timed alone");
    const ray_set *shadow = &s.rays[KIND_SHADOW];
    ray_set warm = rays_some(shadow, shadow->n / 4 + 1);
    for (size_t i = 0; i < shadow->n; i++) hits += e->c->occluded(e->s, shadow->r[i]);
    check(hits > 0 && entry_work(e, &warm, true, &any) > 0, "some shadow rays are stopped");
    check_equal(e->hits[KIND_SHADOW], hits, "as many as were measured");
    check_equal(e->work[KIND_SHADOW].tests, any.tests, "with so many tests");
    check_equal(e->counted[KIND_SHADOW], warm.n, "of so many rays");
    rays_free(&warm), compare_end(&s), world_free(&w);
}

/* Triangles that lie in one place: who meets one is asked about all. So there are few rays, the
 * same for all; and as many as ever of a pile that is small. */
static void test_pile(void)
{
    line_up trees = chosen_of("bvh,wide,kdtree");
    for (size_t n = 1000; n <= 15000; n *= 15) {
        comparison s;
        world w;
        failure f;
        mesh m = mesh_room(n);
        for (size_t i = 0; i < n; i++)
            set_triangle(&m, i, vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0));
        if (!mesh_world(&w, "pile", m, false, &f)) fail(f);
        begin(&s, &w, &trees, 500);
        check(compare_prove(&s, 500, 400, 7, stdout), "a pile of %zu: all agree", n);
        size_t rays = s.rays[KIND_PRIMARY].n;
        if (n == 1000) check(rays == 500 && s.by_brute > 400, "a small pile has all its rays");
        else check(rays >= 64 && rays < 100 && s.by_brute >= 64 && s.proved < 400,
                   "a pile of %zu: %zu rays, %zu proved, of them %zu by brute force", n, rays,
                   s.proved, s.by_brute);
        compare_end(&s), world_free(&w);
    }
}

/* Of few, one whose grid has one cell, and so asks all: their rays stay as many. */
static void test_one_slow(void)
{
    const char *const names[2] = {"grid:density=1e-6", "grid:density=1e-6,bvh,wide,kdtree"};
    world w;
    failure f;
    if (!scene_world(scene_find("stadium"), 16, &w, &f)) fail(f);
    for (int k = 0; k < 2; k++) {
        comparison s;
        line_up some = chosen_of(names[k]);
        begin(&s, &w, &some, 500);
        check((s.share < 1) == (k == 0), "%s: %g steps and tests, share %g", names[k], s.work,
              s.share);
        compare_end(&s);
    }
    world_free(&w);
}

/* First versions. ----------------------------------------------------------------------------- */

/* For the tables: each alone, built by the name it has there; none holds what is no triangle. */
static void test_first_contenders(void)
{
    mesh pot = teapot_mesh(2);
    shape ball = shape_of_sphere((sphere){{0, 0, 0}, 1});
    scene s = {&ball, 1};
    items x = items_of_mesh(&pot), round = items_of_scene(&s);
    failure f;
    for (int k = 0; k < contenders; k++) {
        const contender *c = contender_list[k];
        if (!contender_is_first(c)) continue;
        void *built = contender_build(c, &as_it_is, &x, (size_t)1 << 30, &f);
        hit h, due;
        ray r = ray_from((vec3){(real)0.1, -9, 1}, (vec3){0, 1, 0});
        check(built && c->hit(built, r, &h) && mesh_hit(&pot, r, &due)
              && !first_is_wrong(h, due) && c->occluded(built, r), "%s", c->name);
        contender_free(c, built);
        check(!contender_build(c, &as_it_is, &round, (size_t)1 << 30, &f), "%s: a ball", c->name);
        check(!contender_build(c, &as_it_is, &x, 1000, &f), "%s: no room", c->name);
    }
    mesh_free(&pot);
}

/* Where they are wrong they are counted; the proof of the others goes on, and holds. */
static void test_wrong_is_counted(void)
{
    comparison s;
    world w = tiny("soup");
    line_up all = choose_usual();
    begin(&s, &w, &all, 576);
    check(compare_prove(&s, SIZE_MAX, 400, 7, stdout), "the full versions are right");
    for (int k = 0; k < s.entries; k++) {
        const compare_entry *e = &s.entry[k];
        if (!contender_is_first(e->c)) check_equal(e->held[0] + e->held[1], 0, "%s", e->c->name);
        else check(e->wrong[0] > 10 && e->wrong[0] < e->held[0] / 2 && e->wrong[1] <= 1,
                   "%s: wrong at borders: %zu, else %zu", e->c->name, e->wrong[0], e->wrong[1]);
    }
    compare_end(&s), world_free(&w);
}

/* Kinds of rays. ------------------------------------------------------------------------------- */

static void test_kinds(void)
{
    double bound = real_is_float ? 1e-5 : 1e-14;
    world w = tiny("balls");
    scene all = world_scene(&w);
    ray_set eye = rays_view(&w, 24);
    hit *h = allocate(eye.n, sizeof *h);
    for (size_t i = 0; i < eye.n; i++) {
        h[i] = hit_none;
        scene_hit(&all, eye.r[i], &h[i]);
    }
    ray_set mirror = rays_on(&w, KIND_MIRROR, &eye, h, 3);
    ray_set diffuse = rays_on(&w, KIND_DIFFUSE, &eye, h, 3);
    ray_set shadow = rays_on(&w, KIND_SHADOW, &eye, h, 3);
    size_t k = 0, below = 0;
    double angle = 0;
    for (size_t i = 0; i < eye.n; i++) {
        if (h[i].shape == no_shape) continue;
        vec3 n = world_normal(&w, h[i], ray_at(eye.r[i], h[i].t));
        vec3 d = vunit(eye.r[i].d), m = vunit(mirror.r[k].d);
        angle = check_worse(angle, fabs(fabs((double)vdot(d, n)) - fabs((double)vdot(m, n))));
        angle = check_worse(angle, fabs((double)vdot(vcross(d, n), m)));
        below += vdot(m, n) * vdot(d, n) > 0 || vdot(diffuse.r[k].d, n) * vdot(d, n) > 0;
        vec3 from = vsub(mirror.r[k].o, ray_at(eye.r[i], h[i].t));
        below += vdot(from, n) * vdot(d, n) >= 0;
        k++;
    }
    check_equal(mirror.n, k, "a mirror ray for each hit");
    check_equal(diffuse.n, k, "a diffuse ray for each hit");
    check_equal(below, 0, "on the side that the eye sees");
    check_at_most(angle, bound, "mirrored: equal angles, one plane");
    size_t lights = 0;
    for (size_t i = 0; i < shadow.n; i++) {
        double least = 1;
        for (int l = 0; l < w.lights; l++) {
            double d = (double)vlength(vsub(ray_at(shadow.r[i], shadow.r[i].tmax), w.light[l]));
            least = d < least ? d : least;
        }
        lights += least < bound;
    }
    check_equal(lights, shadow.n, "shadow rays end at a light");
    check(shadow.n > k / 2 && shadow.n <= k * 3, "up to three lights: %zu", shadow.n);
    ray_set some = rays_some(&eye, 10);
    check_equal(some.n, 10, "ten of %zu", eye.n);
    for (size_t i = 0; i < some.n; i++)
        check(vzero(vsub(some.r[i].d, eye.r[i * eye.n / 10].d)), "ray %zu of ten, evenly", i);
    rays_free(&some);
    rays_free(&eye), rays_free(&mirror), rays_free(&diffuse), rays_free(&shadow);
    free(h);
    world_free(&w);
}

/* Aimed points lie on the outline: at right angles to the normal, or at a pole or rim. */
static void test_aim(void)
{
    double bound = real_is_float ? 1e-6 : 1e-14;
    sphere s = {{1, 2, 3}, 0.5};
    vec3 o = {4, -3, 2}, corner[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    double off = 0;
    size_t poles = 0, corners = 0, edges = 0;
    for (size_t i = 0; i < 1000; i++) {
        random_stream g = random_start(1, i, 0);
        vec3 p = aim_at_sphere(s, o, &g), n = vsub(p, s.c), d = vsub(p, o);
        off = check_worse(off, fabs((double)vlength(n) - 0.5));
        bool pole = fabs(fabs((double)vaxis(n, vlongest(n))) - 0.5) < bound;
        poles += pole;
        if (!pole) off = check_worse(off, fabs((double)(vdot(n, d) / vlength(d))));
        vec3 c = aim_at_corners(corner, 3, &g);
        bool at_corner = vzero(c) || c.x == 1 || c.y == 1;
        corners += at_corner;
        edges += !at_corner && (c.x == 0 || c.y == 0 || fabs((double)(c.x + c.y) - 1) < bound);
    }
    check_at_most(off, bound, "aimed at the outline of a sphere");
    check(poles > 400 && poles < 600, "half of them at its poles: %zu of 1000", poles);
    check_equal(corners + edges, 1000, "at corners and edges of a triangle");
    check(corners > 400 && corners < 600, "half of them at corners: %zu", corners);
}

/* Broken on purpose. --------------------------------------------------------------------------- */

/* Wrong only where a direction is so long that searches scale t. */
static bool unscaled_hit(const void *s, ray r, hit *out)
{
    return direction_scale(fabs(vaxis(r.d, vlongest(r.d)))) <= 1 && bvh_hit(s, r, out);
}

/* Found out in every scene. */
static void test_unscaled(void)
{
    contender broken = bvh_contender;
    line_up one = {.n = 0};
    broken.hit = unscaled_hit;
    choose(&one, &broken);
    for (int k = 0; k < scenes; k++) {
        comparison s;
        world w = tiny(scene_list[k].name);
        FILE *out = tmpfile();
        if (!out) abort();
        begin(&s, &w, &one, 64);
        check(!compare_prove(&s, SIZE_MAX, 400, 7, out), "%s: t unscaled is found out", w.name);
        fclose(out), compare_end(&s), world_free(&w);
    }
}

/* A structure alone is proved by brute force alone, and nothing proves nothing. */
static void test_alone(void)
{
    world w = tiny("tetra");
    comparison s;
    for (int k = 0; k < 3; k++) {
        line_up some = {.n = 0};
        if (k > 0) choose(&some, &bvh_contender);
        if (k > 1) choose(&some, &grid_contender);
        begin(&s, &w, &some, 64);
        check(compare_prove(&s, SIZE_MAX, 40, 7, stdout), "all right");
        check((s.by_brute > 0) == (k > 0) && (s.proved > s.by_brute) == (k == 2),
              "%d structures: %zu proved, %zu by brute force", k, s.proved, s.by_brute);
        compare_end(&s);
    }
    world_free(&w);
}

/* Costs. --------------------------------------------------------------------------------------- */

/* Seconds to build, and of the one ray that was asked. */
static comparison timed(const line_up *all, const double *build, const double *seconds)
{
    comparison s = {.entries = all->n, .rays = {{NULL, 1}}};
    for (int k = 0; k < all->n; k++)
        s.entry[k] = (compare_entry){.choice = &all->of[k], .c = all->of[k].c, .fits = true,
                                     .build = build[k], .rays = {1}, .seconds = {seconds[k]}};
    return s;
}

static void test_costs(void)
{
    comparison s = {.entries = 2};
    for (int k = 0; k < compare_kinds; k++) s.rays[k].n = k < 2 ? 100 : 0;
    compare_entry *a = &s.entry[0], *b = &s.entry[1];
    *a = (compare_entry){.c = &brute_contender, .rays = {10, 20}, .seconds = {1e-5, 6e-5}};
    *b = (compare_entry){.c = &bvh_contender, .rays = {100, 100}, .build = 0.5,
                 .seconds = {1e-5, 3e-5}};
    check_close(cost_ns(a, KIND_SHADOW), 3000, 1e-11, "6e-5 s for 20 rays");
    check_close(cost_mean(&s, a), 2e-6, 1e-20, "1000 and 3000 ns, as many of each");
    check_close(cost_mean(&s, b), 2e-7, 1e-21, "100 and 300");
    check_close(b->build / (cost_mean(&s, a) - cost_mean(&s, b)), 277778, 1, "pays after");
    check_equal(cost_ns(a, KIND_MIRROR), 0, "no rays, no time");
}

static void say_fewer(void *s) { cost_say_fewer(s, &(html_report){.path = NULL}); }

/* Who was asked fewer rays of a kind is named, with how many. */
static void test_fewer(void)
{
    line_up two = chosen_of("brute,bvh");
    comparison s = {.entries = 2, .rays = {{NULL, 100}, {NULL, 30}}};
    for (int k = 0; k < 2; k++)
        s.entry[k] = (compare_entry){.choice = &two.of[k], .fits = true,
                                     .rays = {k ? 100 : 20, 30}};
    child_result said = child_run(say_fewer, &s);
    check_text(said.out, "# fewer rays of a kind: brute 20\n", "one");
    s.entry[0].rays[0] = 100;
    check_text(child_run(say_fewer, &s).out, "", "nobody");
}

/* The corners of the lower envelope rise, though lines that are nearly as good are passed over. */
static void test_cheapest(void)
{
    static const double build[4] = {0, 10, 9.8, 50}, seconds[4] = {100, 50, 47, 20};
    line_up four = chosen_of("bvh,bvh,bvh,bvh");
    comparison s = timed(&four, build, seconds);
    double from = 0;
    const compare_entry *e = cost_next(&s, &s.entry[0], &from);
    check(e == &s.entry[1], "the next is the earlier in the list");
    check_close(from, 0.2, 1e-12, "10 s of building, 50 s a ray gained");
    check(cost_next(&s, e, &from) == &s.entry[2], "the one that was passed over");
    check_close(from, 0.2, 1e-12, "from the same place on");
    check(cost_next(&s, &s.entry[2], &from) == &s.entry[3], "and the fastest");
    check_close(from, 40.2 / 27, 1e-12, "where the lines cross");
    check(!cost_next(&s, &s.entry[3], &from), "none is faster");
}

static void test_winners(void)
{
    static const double seconds[3] = {3e-6, 1e-6, 2e-6}, build[3] = {0, 5, 0.5};
    line_up three = chosen_of("brute,grid,nested");
    comparison s = timed(&three, build, seconds);
    check(strcmp(summary_fastest(&s, 1, 0), "grid") == 0, "1 us a ray, of those chosen");
    check(strcmp(summary_fastest(&s, 1e6, 1), "nested") == 0, "2.5 s against 6 and 3");
    s.entry[2].seconds[0] = 0.98e-6;
    check(strcmp(summary_fastest(&s, 1, 0), "grid") == 0, "two percent are noise");
    s.entry[1].fits = false;
    check(strcmp(summary_fastest(&s, 1, 0), "nested") == 0, "what does not fit does not win");
}

static void test_growth(void)
{
    double x[growth_sizes], y[growth_sizes], steps[growth_sizes];
    comparison *of = allocate(5, sizeof *of);
    measured_scenes m = {.of = of, .n = 5};
    for (int i = 0; i < 5; i++) {
        of[i] = (comparison){.entries = 2, .x = {.n = (size_t)1 << 2 * i}, .rays = {{NULL, 1}}};
        of[i].entry[0] = (compare_entry){.fits = true, .rays = {1}, .counted = {1},
            .seconds = {exp2(i)}, .work = {{.nodes = 4 * (size_t)i, .tests = 2 * (size_t)i}}};
        of[i].entry[1] = (compare_entry){.fits = i < 3, .rays = {1}, .seconds = {1}};
    }
    check_equal((size_t)growth_points(&m, 0, x, y, steps), 5, "five sizes");
    check_close(bench_slope(x, y, 5), 0.5, 1e-15, "time ~ n^0.5");
    check_close(bench_slope(x, steps, 5), 3, 1e-15, "three more steps a doubling");
    check_equal((size_t)growth_points(&m, 1, x, y, steps), 3, "left out of the others");
    measured_free(&m);
}

/* Who is out of the next size: slow to build, slow to search, or not built; brute force may be
 * slow, and who is the quickest to build stays. */
static void test_growth_leaves(void)
{
    static const double build[6] = {0, 5, 6, 5, 5, 0}, seconds[6] = {500, 1, 1, 101, 99, 0};
    static const bool out[6] = {false, false, true, true, false, true};
    line_up now = chosen_of("brute,bvh,grid,octree,kdtree,bsp");
    comparison s = timed(&now, build, seconds);
    s.entry[5].fits = false;
    growth_leave(&s, &now);
    for (int k = 0; k < now.n; k++)
        check(now.of[k].out == out[k], "%s: in or out", now.of[k].label);
}

/* From outside. -------------------------------------------------------------------------------- */

/* What the program is asked, @ being the directory; how it ends; and in pairs a file, and a text
 * that is in it then, or behind a ! that is not. */
typedef struct { int status; const char *arguments, *said[10]; } dialogue;

static void test_dialogue(const dialogue *list, size_t n)
{
    for (const dialogue *d = list; d < list + n; d++) {
        check_equal(run("17_compare", d->arguments), d->status, "17_compare %s", d->arguments);
        for (int k = 0; k < 10 && d->said[k]; k += 2) {
            bool not = d->said[k + 1][0] == '!';
            check(printed(d->said[k], d->said[k + 1] + not) != not, "%s: in %s: %s", d->arguments,
                  d->said[k], d->said[k + 1]);
        }
    }
}

static void test_misuse(void)
{
    static const struct { const char *arguments, *says; } wrong[] = {
        {"--only quadtree", "brute"}, {"--only ,", "names no structure"},
        {"--scene bunny", "needles"}, {"--scale 3", "--scene"}, {"--scene balls --scale 7", "to 6"},
        {"--scene balls --scale -1", "--scale -1"}, {"--scene balls --scale 2.5", "2.5"},
        {"--scene balls --mesh x.obj", "one of them"}, {"--protocol nff", "spd"},
        {"--protocol spd --scene soup", "tetra"}, {"--protocol spd --verify", "alone"},
        {"--hits x", "--rays"}, {"--any-hit", "--rays"}, {"--memory 0", "from 1"},
        {"--rays r --verify", "one of them"}, {"--verify --csv x", "tables"},
        {"--protocol spd --csv x", "tables"}, {"--scene balls --out x.png", "picture"},
        {"--scene balls --preview", "picture"}, {"--orders --preview", "picture"},
        {"--out x.png --csv y", "one of them"}, {"--only bvh:leaf=0", "from 1 to 255"},
        {"--only bvh:leaf=2.5", "whole"}, {"--only bvh:leaf", "options of bvh"},
        {"--only example:leaf=1", "none"}, {"--only bvh:rule=best", "morton"},
        {"--only kdtree:rule=best", "allowed are middle median sah"},
        {"--only kdtree:rule=3", "middle"}, {"--only bsp:rule=sah", "random fewest axis own cost"},
        {"--only wide:width=9", "from 2 to 8"}, {"--regimes --scene soup", "of its own"},
        {"--orders --only bvh", "of its own"}, {"--orders --regimes", "of its own"},
        {"--sweep bvh", "bvh:leaf=1..32"}, {"--sweep bvh:leaf=9..8", "FROM..TO"},
        {"--sweep bvh:leaf=1..4 --verify", "--sweep"}, {"--up z", "--mesh"},
        {"--costs x", "--rays"}, {"--score x", "--torture"},
        {"--torture d --verify", "of its own"}, {"--report r.html --verify", "--report"},
        {"/nowhere/x.nff", "x.nff"}, {"@v.nff", "no view"}, {"@v.nff --at 0,0,0", "no view"},
        {"@v.nff --from 0,-5,1", "no view"},
        {"@v.nff --from 1,1,1 --at 1,1,1", "equals the viewpoint"},
        {"@b.obj --at 0,nan,1", "allowed are X,Y,Z"}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        test_dialogue(&(dialogue){2, wrong[i].arguments, {"err", wrong[i].says}}, 1);
    test_dialogue(&(dialogue){1, "--rays /nowhere/x.rays", {"err", "x.rays"}}, 1);
    test_dialogue(&(dialogue){1, "--mesh /nowhere/x.obj", {"err", "x.obj"}}, 1);
}

static void write_rays(const char *path, const world *w, size_t n)
{
    ray_set s = rays_aimed(w, n, 9);
    failure f;
    if (!rays_write(path, s.r, n, &f)) fail(f);
    rays_free(&s);
}

/* The hits in the file are those of brute force here; both kinds. */
static void test_files(void)
{
    enum { n = 700 };
    world w = tiny("gears");
    scene all = world_scene(&w);
    failure f;
    size_t rays, size, hits = 0, hits_before = 0;
    write_rays(in_directory("g.rays"), &w, n);
    ray *r = rays_read(in_directory("g.rays"), &rays, &f);
    for (int any = 0; any < 2; any++) {
        char arguments[100];
        size_t wrong = 0;
        snprintf(arguments, sizeof arguments, "--scene gears --scale 1 --rays @g.rays --hits "
                 "@g.hits --csv @g.csv %s", any ? "--any-hit" : "");
        check_equal(run("17_compare", arguments), 0, "17_compare %s", arguments);
        unsigned char *got = (unsigned char *)file_read(in_directory("g.hits"), &size, &f);
        check(got && size == 8 * n, "a record for each ray");
        for (size_t i = 0; got && size == 8 * n && i < n; i++) {
            hit h = hit_none;
            bool found = scene_hit(&all, r[i], &h);
            real t = little_endian_real(got + 8 * i);
            uint32_t index = little_endian(got + 8 * i + 4);
            hits += found;
            wrong += any ? t != (found ? 0 : real_infinity) || index != (found ? 0 : no_shape)
                         : t != (real)(float)h.t || index != h.shape;
        }
        check_equal(wrong, 0, "hits in the file are those of brute force");
        free(got);
        char *csv = file_read(in_directory("g.csv"), &size, &f);
        const char *expected = "scene,structure,kind,rays,hits,build_s,bytes,peak_bytes,";
        check(csv && strncmp(csv, expected, strlen(expected)) == 0, "the columns of the CSV");
        char row[64];
        snprintf(row, sizeof row, "gears,bvh,%s,700,%zu,", any ? "any" : "closest",
                 hits - hits_before);
        check(csv && strstr(csv, row), "its row: %s", row);
        hits_before = hits;
        free(csv);
    }
    check(hits > n / 2, "enough of them hit: %zu of 2 times %d", hits, n);
    static const dialogue broken[] = {
        {1, "--scene gears --scale 1 --rays @g.rays --only bvh --hits /dev/full", {0}},
        {1, "--scene gears --scale 1 --rays @g.rays --only bvh --hits /nowhere/x.hits", {0}},
        {2, "--rays @g.rays", {"err", "30 bytes"}}};
    test_dialogue(broken, 2);
    if (truncate(in_directory("g.rays"), 30) != 0) abort();
    test_dialogue(broken + 2, 1);
    free(r);
    world_free(&w);
}

/* Scenes of the book and of one's own, OBJ and NFF; a report; what each ray cost. */
static void test_program(void)
{
    static const dialogue list[] = {
        {0, "--quick --scene tetra --csv @t.csv",
         {"out", "tetra: 64 shapes", "t.csv", "tetra,brute,primary,",
          "t.csv", "tetra,bvh,mirror,144,", "t.csv", ",-,-,-,-,-,-,-,-,"}},
        {0, "--verify --scene tree --scale 3 --only bvh,grid",
         {"out", "tree bvh: 4096 primary", "out", "as brute force",
          "out", "tree grid: 4096 primary", "out", "!octree"}},
        {0, "--protocol spd --scene tetra --only bvh",
         {"out", "primary tetra 6 bvh: ", "out", "hits 49950\n"}},
        {0, "--scene soup --scale 4 --memory 1 --quick --report @m.html",
         {"out", "# kdtree does not fit: ", "out", "\nbrute ", "m.html", ">kdtree does not fit: ",
          "m.html", ">cheapest in all: "}},
        {0, "@a.nff @b.obj --up z --quick --only grid,bvh,example --report @r.html",
         {"out", "a.nff: 4 shapes", "out", "b.obj: 1 shapes", "out", "structure  a.nff  b.obj",
          "r.html", "Who wins", "r.html", "data:image/png;base64,iVBOR"}},
        {0, "--quick --scene tetra --only grid,bvh --report @v.html",
         {"v.html", "</p>\n<h2>Verdict</h2>\n<p>The least time a ray: tetra ",
          "v.html", "<p class=\"note\">A dash: not built there."}},
        {0, "@v.nff --from 0,-5,1 --at 0,0,0 --quick --only bvh",
         {"out", "v.nff: 1 shapes", "out", "\nbvh "}},
        {0, "@b.obj --quick --only first-mesh,bvh --report @r.html",
         {"r.html", "first-mesh: wrong at", "r.html", "</html>"}},
        {0, "--scene stadium --scale 4 --rays @s.rays --costs @s.csv --only bvh,grid",
         {"s.csv", "ray,t,shape,bvh nodes,bvh tests,grid nodes,grid tests\n0,",
          "s.csv", "\n99,"}},
        {0, "--quick --sweep bvh:cost=0.1..1.6", {"out", "bvh:cost=0.8"}},
        {0, "--quick --sweep bvh:leaf=1..4", {"out", "bvh:leaf=3", "out", "yes"}},
        {0, "--quick --regimes --only bvh,wide",
         {"out", "Order and cores", "out", "60 frames, 100 rays each: 0 wrong"}},
        {0, "--quick --orders", {"out", "Two orders, one picture"}}};
    world teapot = tiny("stadium");
    write_rays(in_directory("s.rays"), &teapot, 100);
    world_free(&teapot);
    test_dialogue(list, sizeof list / sizeof *list);
}

/* A structure of one's own must stand all that the others stand, which 10 to 15 ask of theirs. */
static const contender *own;

static void *own_new(const items *x, failure *f)
{
    return contender_build(own, &as_it_is, x, (size_t)1 << 30, f);
}

static void own_destroy(void *s) { contender_free(own, s); }

static void test_own(void)
{
    static const char chapters[] = " brute grid nested octree kdtree bsp bvh bvh-morton "
                                   "bvh-spatial wide ";
    int asked = 0;
    for (int k = 0; k < contenders; k++) {
        char name[64];
        own = contender_list[k];
        snprintf(name, sizeof name, " %.60s ", own->name);
        if (contender_is_first(own) || strstr(chapters, name)) continue;
        structure s = {own->name, own_new, own->hit, own->occluded, own_destroy, NULL};
        structure_tests(&s, check_count(600));
        asked++;
    }
    check(asked >= 1, "the example is one");
}

static void test_example(void)
{
    for (size_t n = 0; n < 2; n++) {  /* of nothing, or of one triangle: no inner node */
        mesh m = mesh_room(n);
        if (n) set_triangle(&m, 0, vec(-1, -1, 0), vec(1, -1, 0), vec(0, 1, 0));
        items x = items_of_mesh(&m);
        example e;
        search_work work = {0, 0, 0, 0};
        hit h;
        check(example_build(&x, (example_options){1 << 20}, &e, NULL), "built of %zu", n);
        check(example_stats(&e).inner == 0 && example_stats(&e).leaves == n, "leaves of %zu", n);
        check(example_hit_counted(&e, ray_from(vec(0, 0, 1), vec(0, 0, -1)), &h, &work) == n
              && work.nodes == 0 && work.tests == n, "asked of %zu", n);
        example_free(&e), mesh_free(&m);
    }
}

/* Options from outside reach the structure. */
static void test_knobs(void)
{
    world w = tiny("stadium");
    comparison s;
    line_up all = chosen_of("bvh:leaf=1,bvh:leaf=8:cost=2,bvh:rule=median,octree:depth=2,kdtree,"
                            "wide:width=2,wide,wide:leaf=1,kdtree:rule=middle,kdtree:rule=median,"
                            "kdtree:rule=sah");
    line_up swept = swept_of("bvh:leaf=1..32"), few = swept_of("kdtree:bonus=0..0.8");
    compare_begin(&s, &w, &all, (size_t)1 << 30, 1);
    check_equal(s.entries, 11, "structures, some of them the same");
    check_at_least(s.entry[5].stats.inner, s.entry[5].stats.leaves / 2, "wide, of width 2: binary");
    check_at_least(s.entry[7].stats.leaves, s.x.n, "wide: a block a triangle");
    check_at_most((double)s.entry[6].stats.leaves, 0.4 * (double)s.x.n, "wide: blocks of eight");
    check_equal(s.entry[0].stats.leaves, s.x.n, "a leaf a triangle");
    check_at_most((double)s.entry[1].stats.leaves, 0.7 * (double)s.x.n, "leaves of up to eight");
    check(s.entry[2].stats.leaves != s.entry[1].stats.leaves, "another rule, another tree");
    check_at_most(s.entry[3].stats.depth, 2, "an octree of depth 2");
    size_t middle = s.entry[8].stats.leaves, median = s.entry[9].stats.leaves;
    size_t sah = s.entry[10].stats.leaves;
    check(middle != median && median != sah && middle != sah,
          "three rules, three trees: leaves %zu, %zu, %zu", middle, median, sah);
    check_equal(s.entry[4].stats.leaves, sah, "the usual one is that by the heuristic");
    check(strcmp(all.of[1].label, "bvh:leaf=8:cost=2") == 0, "its name: %s", all.of[1].label);
    check_equal(swept.n, choose_usual().n + 6, "1, 2, 4 .. 32");
    check_equal(few.n, choose_usual().n + 9, "eight steps");
    compare_end(&s);
    world_free(&w);
}

/* A rule by its name, or by its number, which becomes the name. */
static void test_rule_names(void)
{
    static const struct { const char *label; int value; } named[] = {
        {"kdtree:rule=middle", KD_MIDDLE}, {"kdtree:rule=median", KD_MEDIAN},
        {"kdtree:rule=sah", KD_SAH}, {"bsp:rule=random", BSP_RANDOM},
        {"bsp:rule=fewest", BSP_FEWEST}, {"bsp:rule=axis", BSP_AXIS}, {"bsp:rule=own", BSP_OWN},
        {"bsp:rule=cost", BSP_COST}, {"bvh:rule=cycle", 0}, {"bvh:rule=spatial", 7}};
    for (size_t i = 0; i < sizeof named / sizeof *named; i++) {
        char number[32];
        const char *label = named[i].label, *end = strchr(label, '=');
        snprintf(number, sizeof number, "%.*s=%d", (int)(end - label), label, named[i].value);
        line_up by_name = chosen_of(label), by_number = chosen_of(number);
        const contender_setting *set = &by_name.of[0].how.set[0];
        check_equal(set->value, named[i].value, "%s", label);
        check_text(by_number.of[0].label, label, "%s", number);
        if (set->type == KNOB_NAME) check_text(set->name, end + 1, "%s", number);
    }
}

/* One that another beats at both is not on the front. */
static void test_front(void)
{
    const double build[3] = {1, 2, 3}, seconds[3] = {3, 4, 1};
    line_up three = chosen_of("bvh,bvh,bvh");
    comparison s = timed(&three, build, seconds);
    check(sweep_on_front(&s, &s.entry[0]) && sweep_on_front(&s, &s.entry[2]),
          "each is best at one");
    check(!sweep_on_front(&s, &s.entry[1]), "slower than the first at both");
}

static void put_scenes(void)
{
    put("a.nff", "b 0 0 0\nv from 0 -9 2 at 0 0 0\n up 0 0 1 angle 40 hither 1\n"
        " resolution 9 9\nl 5 -9 9\nf 1 0 0 1 0 0 0 0\n"
        "s 0 0 0 1  # a ball\nc 0 0 1 1  0 0 3 0.5\n"
        "p 4  -4 -4 -2  4 -4 -2  4 4 -2  -4 4 -2\n"
        "pp 3 0 0 5 0 0 1 1 0 5 0 0 1 0 1 5 0 0 1\n");
    put("v.nff", "s 0 0 0 1\n");
    put("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
}

/* Files of --torture, given back as another renderer's: all that are right, then some shifted, one
 * that holds rays, and one of another seed. */
static void test_torture(void)
{
    static const dialogue list[] = {
        {0, "--quick --only bvh,first-mesh --torture @t --csv @t.csv",
         {"out", "Wrong answers of 60 a class", "t.csv", "class,aims at,"}},
        {1, "--quick --torture @t --score x", {"err", "inside.x.hits"}},
        {0, "--quick --torture @t --score x", {0}},
        {1, "--quick --torture @t --score x", {"err", "answers are wrong"}},
        {2, "--quick --torture @t --score y", {"err", "240 hits: 60 are expected"}},
        {2, "--quick --torture @t --score x --seed 5", {"err", "not the rays of this seed"}},
        {2, "--quick --torture @t --csv @t/inside.rays", {"err", "is a file of --torture"}},
        {2, "--quick --torture @t --score x --csv @t/start.obj", {"err", "a file of --torture"}},
        {0, "--only bvh,first-mesh --torture @u", {0}},
        {0, "@u/edges.obj --rays @u/edges.rays --only bvh,first-mesh",
         {"out", "# first-mesh: wrong at "}}};
    test_dialogue(list, 2);
    check_equal(shell("cd @t && cp inside.rays kept && for f in *.hits; do "
                      "cp $f ${f%.hits}.x.hits; done; cp inside.rays inside.y.hits"), 0, "files");
    test_dialogue(list + 2, 1);
    check_equal(shell("cd @t && { tail -c +9 edges.hits; head -c 8 edges.hits; } >edges.x.hits"),
                0, "files");  /* of the next ray */
    test_dialogue(list + 3, 7);
    check(equal_files("t/inside.rays", "t/kept") && printed("t/start.obj", "\nf "), "nothing lost");
}

/* A picture drawn and one by rays: that by rays is brute force's, and the drawn one differs at
 * edges alone, by less than a hundredth of the pixels. */
static void test_orders(void)
{
    enum { nx = 40, ny = 30 };
    race t;
    race_begin(3, &t);
    t.s = raster_new(nx, ny);
    hit *due = allocate(nx * ny, sizeof *due);
    size_t wrong = 0, other = 0, covered = 0;
    for (int k = 0; k < nx * ny; k++) {
        real x = (real)(k % nx) + (real)0.5, y = (real)(k / nx) + (real)0.5;
        due[k] = hit_none;
        items_hit(&t.x, camera_ray(t.c, x, y, nx, ny), &due[k]);
        covered += due[k].shape != no_shape;
    }
    for (int twice = 0; twice < 2; twice++) {
        race_traced(&t);
        for (int k = 0; k < nx * ny; k++) wrong += !hits_same(t.s.h[k], due[k]);
        race_drawn(&t);
        for (int k = 0; k < nx * ny; k++) other += t.s.h[k].shape != due[k].shape;
    }
    check_equal(wrong, 0, "pixels by rays unlike brute force's");
    check_at_least(covered, nx * ny / 4, "the teapot fills the picture");
    /* None is with one compiler; at an edge, rounding may have it either way. */
    check_at_most((double)other, 2 * nx * ny / 100, "pixels drawn otherwise, in two pictures");
    check(t.s.asked > t.s.covered && t.s.asked < 3 * nx * ny, "asked in one picture: %zu",
          t.s.asked);
    raster_free(&t.s), race_end(&t), free(due);
}

int main(void)
{
    if (!mkdtemp(directory)) abort();
    if (run("17_compare", "--help") == 0) {
        put_scenes();
        test_misuse();
        test_files();
        test_program();
        test_torture();
    } else printf("17_compare: the program is not built (make), so it is not tested\n");
    remove_directory();
    return check_all("17_compare", test_equality, test_solids, test_memory, test_brute_alone,
                     test_pile, test_one_slow, test_first_contenders, test_wrong_is_counted,
                     test_alone, test_winners, test_kinds, test_aim, test_unscaled, test_costs,
                     test_fewer, test_cheapest, test_growth, test_growth_leaves, test_orders,
                     test_own, test_example, test_knobs, test_rule_names, test_front);
}
