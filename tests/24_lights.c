/* Tests of 24_direct_light: lit_scene.h against brute force and 18, emitter.h against closed forms
 * and by chi-square, mis.h. Fixed seeds; each random test alarms falsely once in 1e8 seeds. */
#include "../common/lab/t_test.h"
#include "../chapters/07_mesh/scenes/teapot.h"
#include "../chapters/24_direct_light/scenes/lit_cornell.h"
#include "../chapters/24_direct_light/scenes/sky.h"
#include "../chapters/24_direct_light/mis.h"
#include "check.h"

#define alarm 1e-8
#define eps ((double)real_epsilon)

static vec3 random_point(uint64_t i, uint64_t which, double size)
{
    double c[3];
    for (uint64_t k = 0; k < 3; k++) c[k] = size * (2 * (double)random_real(3, i, which, k) - 1);
    return vec(c[0], c[1], c[2]);
}

static bool same(vec3 a, vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/* ---- lit_scene: the very hit, and 18's surface bit by bit ---- */

static void test_trace(const lit_scene *s, double size, const char *name)
{
    scene shapes = {s->shape, s->shapes};
    size_t wrong = 0, hits = 0, n = check_count(20000);
    for (size_t i = 0; i < n; i++) {
        vec3 o = random_point(i, 0, size), to = random_point(i, 1, size);
        ray r = ray_from(o, vsub(to, o));
        hit a = hit_none, b = hit_none;
        lit_hit h;
        bool ma = mesh_hit(&s->m, r, &a), mb = scene_hit(&shapes, r, &b);
        bool of_mesh = ma && (!mb || a.t <= b.t), met = lit_trace(s, r, &h);
        wrong += met != (ma || mb) || lit_occluded_from(s, r, no_shape, lit_dark) != met;
        if (!met || !(ma || mb)) continue;
        hits++;
        surface x = of_mesh ? surface_of_mesh(&s->m, a)
                            : surface_of_shape(&s->shape[b.shape], r, b);
        bool front = vdot(x.n, r.d) < 0;
        x = surface_facing(x, r.d);
        size_t place = of_mesh ? a.shape : s->m.triangles + b.shape;
        uint16_t of = of_mesh ? s->of_triangle[a.shape] : s->of_shape[b.shape];
        wrong += h.t != (of_mesh ? a.t : b.t) || h.front != front || h.s.shape != place;
        wrong += !same(h.s.p, x.p) || !same(h.s.n, x.n) || !same(h.s.ns, x.ns);
        wrong += h.s.error != x.error || h.s.noise != x.noise;
        wrong += h.m != &s->material[of] || h.emitter != s->emitter_of[place];
        vec3 none = {0, 0, 0}, le = front && h.emitter != lit_dark ? h.m->ke : none;
        wrong += !same(lit_emitted(&h), le);
    }
    check_equal(wrong, 0, "%s: hit, surface, material, emission as by brute force", name);
    check_at_least(hits, n / 8, "%s: rays that meet something", name);
}

/* Of everything: a smooth mesh, a faceted one, lamps of each kind, a cone. */
static lit_scene a_scene(void)
{
    lit_scene s;
    lit_begin(&s);
    uint16_t grey = lit_add_material(&s, (material){.kd = vec(.5, .5, .5)});
    uint16_t lamp = lit_add_material(&s, (material){.ke = vec(3, 2, 1)});
    for (int k = 0; k < 30; k++) {
        vec3 a = random_point((uint64_t)k, 7, 3), b = random_point((uint64_t)k, 8, 1);
        triangle t = {a, vadd(a, b), vadd(a, vec(1, .2, .1))};
        sphere ball = {b, (real)(k % 2 ? .2 : -.2)};
        lit_add_triangle(&s, t, k % 3 ? grey : lamp);
        lit_add_shape(&s, shape_of_sphere(ball), k % 5 ? grey : lamp);
    }
    mesh ball = teapot_mesh(2);
    mesh_smooth_normals(&ball);
    lit_add_mesh(&s, &ball, grey);
    mesh_free(&ball);
    mesh bare = cornell_mesh();
    for (size_t i = 0; i < bare.vertices; i++) bare.v[i] = vscale(bare.v[i], (real)(1.0 / 512));
    lit_add_mesh(&s, &bare, lamp);
    mesh_free(&bare);
    lit_add_rectangle(&s, (rectangle){vec(-2, -2, -1), vec(1, 0, 0), vec(0, 2, 0)}, lamp);
    lit_add_shape(&s, shape_of_cone((cone){vec(0, 0, 2), .5, vec(0, 1, 2), 0}), lamp);
    lit_end(&s);
    return s;
}

/* Normals of a mesh are numbered anew, behind those before; a corner without one has none. */
static void test_corners_without_a_normal(void)
{
    vec3 corner[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, normal[2] = {{0, 0, 1}, {0, 1, 1}};
    uint32_t index[3] = {0, 1, 2}, of[3] = {1, mesh_none, 0};
    mesh one = {.v = corner, .vertices = 3, .index = index, .triangles = 1, .n = normal,
                .normals = 2, .normal_index = of};
    lit_scene s;
    lit_begin(&s);
    uint16_t grey = lit_add_material(&s, (material){.kd = vec(.5, .5, .5)});
    for (uint32_t k = 0; k < 2; k++) {
        lit_add_mesh(&s, &one, grey);
        const uint32_t *now = s.m.normal_index + 3 * k;
        check(now[0] == 2 * k + 1 && now[1] == mesh_none && now[2] == 2 * k, "mesh %u", k);
    }
    lit_end(&s), lit_free(&s);
}

/* The sun of the sky is where it was put, and nowhere else. */
static void test_sun(void)
{
    real theta = pi * (real)8.5 / 32, phi = pi / 64;
    vec3 to_sun = {sin(theta) * cos(phi), cos(theta), sin(theta) * sin(phi)};
    environment e;
    size_t bright = 0;
    environment_sky(64, 32, to_sun, &e);
    for (size_t i = 0; i < 64 * 32; i++) bright += e.im.rgb[3 * i] > 100;
    check_equal(bright, 1, "a disk smaller than a pixel");
    check(environment_radiance(&e, to_sun).x > 1000, "the sun");
    environment_free(&e);
}

static void test_scenes(void)
{
    lit_scene box, all = a_scene(), none;
    lit_cornell(&box);
    test_trace(&box, 700, "Cornell box");
    test_trace(&all, 3, "all kinds");
    check_equal(box.m.triangles, 38, "triangles of the box");
    check_equal(box.emitters, 1, "one light, of two triangles");
    check_equal(box.emitter_of[16], 0, "its one half");
    check_equal(box.emitter_of[17], 0, "its other half");
    check_equal(box.emitter[0].area, 105 * 130, "its area: exact products");
    check_close(box.emitter[0].n.y, -1, 2 * eps, "it shines down");
    mesh room = cornell_mesh();
    for (size_t i = 0; i < 38; i++) {
        triangle a = mesh_triangle(&room, i), b = mesh_triangle(&box.m, i);
        check(same(a.a, b.a) && same(a.b, b.b) && same(a.c, b.c), "triangle %zu as measured", i);
    }
    mesh_free(&room);
    /* 10 lamps of 30, 38 triangles of the box, a rectangle, 6 of 30 spheres; the cone is none */
    check_equal(all.emitters, 10 + 38 + 1 + 6, "emitters of all kinds");
    lit_begin(&none);
    lit_end(&none);
    test_trace(&box, 1, "inside a wall of nothing");
    lit_hit h;
    const ray along_x = ray_from(vec(0, 0, 0), vec(1, 0, 0));
    check(!lit_trace(&none, along_x, &h), "an empty scene is never hit");
    check(!lit_occluded_from(&none, along_x, no_shape, lit_dark), "nor does it occlude");
    lit_free(&none), lit_free(&none), lit_free(&box), lit_free(&all);
}

/* At the same t, to the last bit: the triangle. And the normals of the second of two smooth meshes
 * are its own. */
static void test_joined(void)
{
    lit_scene s;
    lit_hit h;
    lit_begin(&s);
    uint16_t grey = lit_add_material(&s, (material){.kd = vec(.5, .5, .5)});
    uint16_t lamp = lit_add_material(&s, (material){.ke = vec(1, 1, 1)});
    lit_add_shape(&s, shape_of_sphere((sphere){vec(0, 0, 0), 1}), lamp);
    lit_add_triangle(&s, (triangle){vec(1, -1, -1), vec(1, 1, -1), vec(1, 0, 1)}, grey);
    mesh pot[2] = {teapot_mesh(1), teapot_mesh(2)};
    for (int k = 0; k < 2; k++) {
        mesh_smooth_normals(&pot[k]);
        for (size_t i = 0; i < pot[k].vertices; i++) pot[k].v[i].z += (real)(4 + 4 * k);
        lit_add_mesh(&s, &pot[k], grey);
    }
    lit_end(&s);
    check(lit_trace(&s, ray_from(vec(3, 0, 0), vec(-1, 0, 0)), &h) && h.t == 2 && h.s.shape == 0,
          "a triangle and a sphere at t = 2: the triangle");
    size_t wrong = 0, first = 1;
    for (int k = 0; k < 2; k++) {
        for (size_t i = 0; i < pot[k].triangles; i++) {
            vec3 n = mesh_normal(&pot[k], i, .3, .4);
            wrong += !same(n, mesh_normal(&s.m, first + i, .3, .4));
        }
        first += pot[k].triangles;
        mesh_free(&pot[k]);
    }
    check_equal(wrong, 0, "normals of joined meshes");
    check_equal(s.m.triangles, first, "triangles of joined meshes");
    check(same(mesh_normal(&s.m, 0, 0, 0), vec(1, 0, 0)), "the flat one keeps its own");
    lit_free(&s);
}

/* ---- emitters ---- */

enum { specimens = 10 };  /* the last two shine on both sides */
static emitter specimen(int i)
{
    const vec3 Le = {1, 1, 1};
    const rectangle wall = {{-1, -1, 2}, {0, 2, 0}, {2, 0, 0}};
    const triangle sail = {{-1, -1, 1}, {0, 2, 1}, vec(1, -1, 1.5)};
    const emitter list[specimens] = {
        emitter_of_rectangle(wall, Le),
        emitter_of_rectangle((rectangle){vec(5, 5, .01), vec(0, .01, 0), vec(.02, 0, 0)}, Le),
        emitter_of_triangle(sail, Le),
        emitter_of_triangle((triangle){{1, 0, 0}, {1, -5, 3}, {1, 5, 3}}, Le),
        emitter_of_sphere((sphere){{0, 0, 3}, 1}, Le),
        emitter_of_sphere((sphere){vec(0, 0, 1.001), 1}, Le),
        emitter_of_sphere((sphere){vec(.2, .3, .1), -1}, Le),
        emitter_of_sphere((sphere){{3, 2, 100}, (real).01}, Le),
        emitter_of_rectangle((rectangle){wall.o, wall.t, wall.s}, Le),
        emitter_of_triangle((triangle){sail.a, sail.c, sail.b}, Le)};
    emitter e = list[i];
    if (i >= 8) e.both = true;
    return e;
}

static double emitter_omega(const emitter *e, vec3 p)
{
    if (e->kind == EMITTER_TRIANGLE) return fabs((double)triangle_solid_angle(e->triangle, p));
    if (e->kind == EMITTER_RECTANGLE) return fabs((double)rectangle_solid_angle(e->rectangle, p));
    return e->sphere.r < 0 ? 4 * (double)pi : (double)sphere_solid_angle(e->sphere, p);
}

/* A point of the light must lie on it within its own bound, wi must lead there, the pdf must be the
 * one told without sampling. The mean of 1 / pdf is omega, of w.a / pdf the light's mean in that
 * direction, by area as by angle: two measures, one truth. */
static void test_emitter(int i)
{
    emitter e = specimen(i);
    vec3 p = vec(0, 0, 0), axis = vunit(vec(.3, .5, .8));
    double omega = emitter_omega(&e, p), off = 0, astray = 0, pdfs = 0;
    estimate all = {0}, by_area = {0}, by_angle = {0};
    size_t n = check_count(20000), behind = 0;
    for (size_t k = 0; k < n; k++) {
        point2 u = {random_real(1, k, 0, 0), random_real(1, k, 0, 1)};
        for (int angle = 0; angle < 2; angle++) {
            emitter_point x = {.pdf = 1};
            bool some = angle ? emitter_by_angle(&e, p, u, &x) : emitter_by_area(&e, p, u, &x);
            double part = some ? (double)(vdot(x.wi, axis) / x.pdf) : 0;
            if (angle) by_angle = estimate_add(by_angle, part);
            else by_area = estimate_add(by_area, part);
            if (!angle) all = estimate_add(all, some ? 1 / (double)x.pdf : 0);
            if (!some) continue;
            real h = e.kind == EMITTER_SPHERE ? vlength(vsub(x.s.p, e.sphere.c)) - fabs(e.sphere.r)
                                              : emitter_height(&e, x.s.p);
            off = check_worse(off, (double)(fabs(h) / x.s.error));
            behind += !(vdot(x.s.n, x.wi) < 0);
            vec3 to = vunit(vsub(x.s.p, p));
            astray = check_worse(astray, (double)vlength(vsub(to, x.wi)));
            real q = angle ? emitter_pdf_angle(&e, p) : emitter_pdf_area(&e, p, x.s.p);
            /* x is rounded: a sphere's normal turns by that over R, wi by that over d */
            double size = (double)(vlength(x.s.p) + e.reach), d = (double)vlength(x.s.p);
            double R = e.kind == EMITTER_SPHERE ? (double)fabs(e.sphere.r) : 1;
            double slack = angle ? 1 : (1 + size / R + size / d) / -(double)vdot(x.s.n, x.wi);
            pdfs = check_worse(pdfs, fabs((double)(q / x.pdf - 1)) / slack);
        }
    }
    check_equal(behind, 0, "light %d: points on the side that p does not see", i);
    check_at_most(off, 1, "light %d: points off it, in their own bounds", i);
    /* (24.6) near the limb an error of eps D grows as 1 / cos: some 500 eps in so many points; of
     * the limb itself, which they do not meet, it would be the root. Else nothing to speak of. */
    double round = e.kind == EMITTER_SPHERE ? 1e4 * eps : 4 * eps;
    check_at_most(astray, round, "light %d: wi leads to the point", i);
    check_at_most(pdfs, eps, "light %d: pdf of a point, with and without", i);
    if (i == 5) return;  /* near: by area its mean is not normal in any number of samples */
    check_at_least(t_test(all, omega, 64 * eps * omega), alarm, "light %d: mean of 1/pdf", i);
    estimate both = {by_area.n, by_area.mean - by_angle.mean,
                     by_area.squares + by_angle.squares};
    check_at_least(t_test(both, 0, 64 * eps), alarm, "light %d: by area as by angle", i);
}

/* Height of x over the plane of three corners, by 30 digits. */
static double exact_height(vec3 a, vec3 b, vec3 c, vec3 x)
{
    wide3 o = wide3_of(a), e = wide3_sub(wide3_of(b), o), f = wide3_sub(wide3_of(c), o);
    wide3 n = wide3_cross(e, f);
    wide h = wide_div(wide3_dot(n, wide3_sub(wide3_of(x), o)), wide3_length(n));
    return fabs(wide_value(h));
}

/* (18.5): x is off the triangles that rays meet by no more than it says. Those of a rectangle have
 * the rounded corners of lit_add_rectangle. */
static void test_bounds(void)
{
    double off[2] = {0, 0}, low = 2;
    size_t n = check_count(20000);
    for (size_t i = 0; i < n; i++) {
        double far = i % 2 ? 30 : 0;
        vec3 o = random_point(i, 20, far), s = random_point(i, 21, 1);
        vec3 t = vscale(vunit(vcross(s, random_point(i, 22, 1))), random_real(3, i, 23, 0));
        point2 u = {random_real(3, i, 24, 0), random_real(3, i, 24, 1)};
        if (i % 2 == 0) o = vneg(vmadd(vscale(s, u.u), t, u.v));  /* x near 0 */
        vec3 b = vadd(o, s), c = vadd(b, t), d = vadd(o, t);
        emitter of[2] = {emitter_of_rectangle((rectangle){o, s, t}, vec(1, 1, 1)),
                         emitter_of_triangle((triangle){o, b, c}, vec(1, 1, 1))};
        for (int k = 0; k < 2; k++) {
            emitter_point x;
            if (!emitter_by_area(&of[k], vadd(o, of[k].n), u, &x)) continue;
            bool second = k == 0 && u.v > u.u;
            double h = exact_height(o, second ? c : b, second ? d : c, x.s.p);
            /* the normals of needles lean: that is what the noise is for */
            off[k] = check_worse(off[k], h / (double)(x.s.error + x.s.noise));
            double edge = (double)vlength(s), reach = (double)surface_reach(x.s.p);
            double least = (double)x.s.error / (eps * (2 * edge + 2 * reach));
            low = least < low ? least : low;
        }
    }
    emitter ball = emitter_of_sphere((sphere){{0, 0, 0}, 3}, vec(1, 1, 1));
    check_equal(ball.reach, 4 * 3, "(18.5), 4 eps R");
    emitter wall = emitter_of_rectangle((rectangle){{8, 0, 0}, {0, 3, 0}, {0, 0, 4}}, vec(1, 1, 1));
    check_equal(wall.reach, 2 * 5 + 2 * 8, "2 eps of the diagonal, and 2 of a corner, as rounded");
    /* of its two triangles one is longer */
    wall = emitter_of_rectangle((rectangle){{0, 0, 0}, {4, 0, 0}, {-3, 1, 0}}, vec(1, 1, 1));
    check_equal(wall.reach, 2 * 4 + 2 * 4, "twice the longest side and the farthest corner");
    real near = 1 + 10 * real_epsilon;  /* 8 eps r + 4 eps |p| = 12 eps */
    check(emitter_sphere_around((sphere){{0, 0, 0}, -1}, (vec3){near, 0, 0}), "p may be off");
    check_at_most(off[0], 1, "points of rectangles, beside those that rays meet");
    check_at_most(off[1], 1, "points of triangles");
    check_at_least(low, 1 - 4 * eps, "no bound below (18.5)");
}

/* What cannot be seen is not sampled, and no pdf says otherwise. */
static void test_unseen(void)
{
    emitter r = specimen(0), s = specimen(4), in = specimen(6), two = specimen(8);
    triangle line = {vec(0, 0, 1), vec(1, 0, 1), vec(2, 0, 1)};
    emitter flat = emitter_of_triangle(line, vec(1, 1, 1));
    emitter dot = emitter_of_sphere((sphere){vec(0, 0, 1), 0}, vec(1, 1, 1));
    const struct { const emitter *e; vec3 p; const char *what; } dark[] = {
        {&r, vec(0, 0, 3), "behind a rectangle"}, {&r, vec(7, 1, 2), "in its plane"},
        {&r, vec(.5, .5, 2), "in the rectangle"},
        {&two, vec(7, 1, 2), "in the plane of two sides"}, {&s, vec(0, .5, 3), "inside a sphere"},
        {&in, vec(5, 0, 0), "outside of one that shines inwards"},
        {&flat, vec(0, 0, 0), "no area"}, {&dot, vec(0, 0, 0), "radius 0"}};
    for (size_t i = 0; i < sizeof dark / sizeof *dark; i++) {
        size_t seen = 0;
        for (uint64_t k = 0; k < 1000; k++) {
            point2 u = {random_real(2, k, 0, 0), random_real(2, k, 0, 1)};
            emitter_point x;
            seen += emitter_by_area(dark[i].e, dark[i].p, u, &x);
            seen += emitter_by_angle(dark[i].e, dark[i].p, u, &x);
        }
        check_equal(seen, 0, "%s: nothing to sample", dark[i].what);
        check_equal(emitter_pdf_angle(dark[i].e, dark[i].p), 0, "%s: pdf", dark[i].what);
    }
    check_equal(emitter_pdf_area(&r, vec(0, 0, 3), vec(0, 0, 2)), 0, "area pdf from behind");
    check_equal((double)emitter_power(&two), 2 * (double)emitter_power(&r), "power of two sides");
    real most = real_largest / 16;  /* its square is no real */
    const rectangle odd[] = {{vec(0, 0, 0), {most, 0, 0}, {0, most, 0}},
                             {vec(0, 0, 0), {(real)NAN, 0, 0}, vec(0, 1, 0)},
                             {vec(0, 0, 0), vec(1, 0, 0), vec(2, 0, 0)}};
    for (int i = 0; i < 3; i++) {
        lit_scene one;
        lit_begin(&one);
        lit_add_rectangle(&one, odd[i],
                          lit_add_material(&one, (material){.ke = vec(1, 1, 1)}));
        check_equal(one.emitters, 0, "rectangle %d without an area that is a number: dark", i);
        lit_free(&one);
    }
    /* on the inner side of a shining sphere, rounded to either side of it: all directions */
    for (uint64_t k = 0; k < 1000; k++) {
        vec3 d = sample_sphere(random_real(2, k, 1, 0), random_real(2, k, 1, 1));
        vec3 p = surface_on_sphere(in.sphere, 0, vadd(in.sphere.c, d)).p;
        emitter_point x;
        point2 u = {random_real(2, k, 1, 2), random_real(2, k, 1, 3)};
        check(emitter_by_angle(&in, p, u, &x) && x.pdf == 1 / (4 * pi),
              "on a sphere that shines inwards");
    }
}

/* ---- what a ray need not ask ---- */

/* A walk through the box: what a ray leaves, and the lamp it is sent to, are left out, and the
 * answers stay those of brute force. */
static void test_leaving(void)
{
    lit_scene s;
    size_t different = 0, shadows = 0;
    lit_cornell(&s);
    items all = items_of_mesh(&s.m);
    for (uint64_t i = 0; i < check_count(4000); i++) {
        ray r = ray_from(vec(278, 273, 10), random_point(i, 40, 1));
        lit_hit h, x;
        for (uint64_t k = 0; k < 5 && lit_trace(&s, r, &h); k++) {
            emitter_point e;
            hit brute = hit_none;
            point2 u = {random_real(3, i, 41, 2 * k), random_real(3, i, 41, 2 * k + 1)};
            if (emitter_by_area(&s.emitter[0], h.s.p, u, &e) && vdot(h.s.n, e.wi) > 0) {
                ray b = leave_between(h.s, e.s);
                bool dark = items_occluded(&all, b);
                shadows += dark;
                different += dark != lit_occluded_from(&s, b, no_shape, lit_dark)
                    || dark != lit_occluded_from(&s, b, h.s.shape, 0);
            }
            r = leave(h.s, directed(h.s.n, sample_cosine(u.u, u.v)));
            bool met = items_hit(&all, r, &brute), again = lit_trace_from(&s, r, h.s.shape, &x);
            different += met != again || (met && (x.t != brute.t || x.s.shape != brute.shape));
        }
    }
    check_equal(different, 0, "with what they leave left out: the answers of brute force");
    check_at_least(shadows, check_count(4000) / 16, "rays in shadow: something to compare");
    lit_free(&s);
}

/* Sixteen triangles round one vertex: a ray through it has all lanes for candidates. */
static void test_fan(void)
{
    enum { n = 16 };
    lit_scene s;
    lit_hit h;
    lit_begin(&s);
    uint16_t grey = lit_add_material(&s, (material){.kd = (vec3){1, 1, 1}});
    for (int i = 0; i < n; i++) {
        real a = 2 * pi * (real)i / n, b = 2 * pi * (real)(i + 1) / n;
        triangle t = {{0, 0, 0}, {cos(a), sin(a), 0}, {cos(b), sin(b), 0}};
        lit_add_triangle(&s, t, grey);
    }
    lit_end(&s);
    ray r = {{0, 0, 5}, 0, {0, 0, -1}, real_infinity};
    check(lit_trace(&s, r, &h) && h.t == 5 && h.s.shape == 0, "the first of all that share it");
    check(lit_trace_from(&s, r, 0, &h) && h.s.shape == 1, "left out: the next one");
    bvh8_skip most = {no_shape, 1, n - 1}, all = {0, 1, n - 1};
    check(bvh8_ask(&s.world.part->tree, r, most, NULL, NULL), "all but one left out");
    check(!bvh8_ask(&s.world.part->tree, r, all, NULL, NULL), "all left out: the ray is free");
    lit_free(&s);
}

/* Triangles 0 and 1 are the lamp, 2 and 3 the floor; of as many balls each has the number of one of
 * these. What a ray does not meet of the triangles it meets of the balls. */
static void test_same_numbers(void)
{
    lit_scene s;
    lit_hit h;
    lit_begin(&s);
    uint16_t grey = lit_add_material(&s, (material){.kd = (vec3){1, 1, 1}});
    uint16_t lamp = lit_add_material(&s, (material){.ke = {1, 1, 1}});
    lit_add_rectangle(&s, (rectangle){{-9, -9, 4}, {0, 18, 0}, {18, 0, 0}}, lamp);
    lit_add_rectangle(&s, (rectangle){{-9, -9, -1}, {18, 0, 0}, {0, 18, 0}}, grey);
    for (int i = 0; i < 4; i++)
        lit_add_shape(&s, (shape){.kind = SHAPE_SPHERE,
                                  .sphere = {{(real)(2 * i - 3), 0, 2}, (real)0.5}}, grey);
    lit_end(&s);
    for (uint32_t i = 0; i < 4; i++) {
        ray up = {{(real)(2 * (int)i - 3), (real)0.1, 0}, 0, {0, 0, 4}, 1};
        check(lit_occluded_from(&s, up, i, 0), "ball %u hides the lamp", i);
        check(lit_trace_from(&s, up, i, &h) && h.s.shape == 4 + i, "ball %u is met", i);
        up.o.y = 2;
        check(!lit_occluded_from(&s, up, i, 0), "beside ball %u all is free", i);
    }
    lit_free(&s);
}

/* ---- mis ---- */

static void test_weights(void)
{
    const real list[] = {real_smallest, 1, 3, real_largest, real_infinity};
    double worst = 0;
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 5; j++) {
            real a = list[i], b = list[j];
            double sum = (double)(mis_balance(a, b) + mis_balance(b, a)) - 1;
            double power = (double)(mis_power(a, b) + mis_power(b, a)) - 1;
            worst = check_worse(worst, check_worse(fabs(sum), fabs(power)));
        }
    check_at_most(worst, 2 * eps, "weights add up to 1, for every pair of pdfs");
    check_equal(mis_balance(3, 1), (real)0.75, "3 : 1");
    check_close(mis_power(3, 1), 0.9, 2 * eps, "9 : 1");
    check_equal(mis_power(2, 0), 1, "nobody else");
    check_equal(mis_power(0, 0), 0, "nobody at all");
    check_equal(mis_power(real_infinity, 5), 1, "a mirror's own direction");
    check_equal(mis_power(5, real_infinity), 0, "not drawn by the mirror");
    check_equal(mis_balance((real)NAN, 1), 0, "a NaN counts nothing");
    real huge = real_is_float ? (real)1e20 : (real)1e160;
    check(isnan(mis_power_naive(huge, huge)), "naive: overflow of squares");
    check_close(mis_power(huge, huge), 0.5, eps, "and here");
}

/* Rectangles of any size, small ones and such as overflow: the same bits as from chapter 22, which
 * prepares for all of them. */
static void test_short_cut(void)
{
    size_t wrong = 0, n = check_count(16000);
    const int most = real_is_float ? 60 : 500;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(31, i, 0);
        real root = sqrt((real)0x1p20 * real_epsilon), far = ldexp((real)1, (int)(i % 2 ? 0
            : random_between(&s, (real)-most, (real)most)));
        real size = far * (i % 4 < 2 ? root * pow((real)4, random_between(&s, -2, 1))
                                     : random_between(&s, (real)0.25, 4));
        rectangle r = {{far * random_between(&s, -1, 1), far * random_between(&s, -1, 1), far},
                       {0, size, 0}, {size, 0, 0}};
        vec3 p = {0, 0, 0}, x = p;
        point2 u = {random_next(&s), random_next(&s)};
        real omega = 0;
        bool is = emitter_rectangle_sample(r, p, u, &x, &omega);
        spherical_rectangle k = spherical_rectangle_of(r, p);
        vec3 due = rectangle_at(r, spherical_rectangle_sample(&k, u.u, u.v));
        wrong += !is || x.x != due.x || x.y != due.y || x.z != due.z || omega != k.omega;
    }
    check_equal(wrong, 0, "the short cut finds another point, of %zu", n);
}

int main(void)
{
    for (int i = 0; i < specimens; i++) test_emitter(i);
    return check_all("24_lights", test_corners_without_a_normal, test_sun, test_scenes,
                     test_joined, test_bounds, test_unseen, test_leaving, test_fan,
                     test_same_numbers, test_weights, test_short_cut);
}
