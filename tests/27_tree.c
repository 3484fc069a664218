/* Tests of chapters/27_effects: what a ray hits first, and the surface there; directions towards
 * lamps and sky.
 *
 * Oracle: each shape and each instance asked in turn (07, 16), the closed form of a sphere, and of
 * solids cut from solids whether a point is in them. What draws directions and what says how likely
 * they were must agree. Of searches that leave faces out: the same ones that leave out nothing.
 */
#include "../chapters/27_effects/files/studio_read.h"
#include "../chapters/27_effects/radiance.h"
#include "../chapters/18_shade/leave.h"
#include "../chapters/04_triangle/scenes/icosphere.h"
#include "../common/random.h"
#include "check.h"

static random_stream rng;
static real uniform(void) { return 2 * random_next(&rng) - 1; }
static vec3 in_cube(real r) { return random_in_cube(&rng, r); }

/* A ball of triangles, outward, corners shared. */
static mesh ball_mesh(int levels)
{
    icosphere b = icosphere_new(levels, (vec3){0, 0, 0}, 1);
    free(b.edge), free(b.fan);
    return (mesh){.v = b.v, .vertices = b.vertices, .index = *b.index, .triangles = b.triangles};
}

static affine random_place(void)
{
    affine a = affine_scaling(vec((real)0.3 + random_next(&rng), 0.5, -0.7));
    a = affine_then(a, affine_rotation(vunit(in_cube(1)), 6 * uniform()));
    return affine_then(a, affine_translation(in_cube(4)));
}

/* Of every eleven solids one has no end. */
static void random_solids(studio *s)
{
    for (int i = 0; i < 77; i++) {
        vec3 p = in_cube(4), n = vunit(in_cube(1));
        double x[3] = {(double)p.x, (double)p.y, (double)p.z};
        double a[3] = {(double)n.x, (double)n.y, (double)n.z};
        char text[200];
        failure f;
        studio_solid one = {.material = (uint32_t)i % 2};
        if (i % 11 == 5) snprintf(text, sizeof text, "intersection(half %g %g %g 3, half %g %g %g "
                                  "-2.9)", a[0], a[1], a[2], -a[0], -a[1], -a[2]);
        else snprintf(text, sizeof text, "difference(box %g %g %g %g %g %g, sphere %g %g %g 0.3)",
                      x[0], x[1], x[2], x[0] + 0.5, x[1] + 0.5, x[2] + 0.5, x[0], x[1], x[2]);
        if (!solid_read(&one, text, &f)) fail(f);
        studio_grow(s, solid, s->solids);
        s->solid[s->solids++] = one;
    }
}

/* Shapes, meshes that stand, one of them twice, others that are moved, and solids. */
static void random_studio(studio *s, int kinds)
{
    const affine one = affine_scaling((vec3){1, 1, 1});
    failure f;
    studio_begin(s);
    uint32_t red = studio_add_material(s, "red", (cite){0, 0});
    for (int i = 0; kinds & 1 && i < 20; i++) {
        vec3 v[4] = {in_cube(4), in_cube(4), in_cube(4), {0, 0, 0}};
        v[3] = vadd(v[0], vsub(v[2], v[1]));
        if (i % 3 == 0) studio_add_polygon(s, v, 4, red);
        else if (i % 3 == 1) studio_add_shape(s, shape_of_sphere((sphere){v[0], uniform()}), 0);
        else studio_add_shape(s, shape_of_cone((cone){v[0], uniform(), v[1], uniform()}), red);
    }
    uint32_t a = studio_add_mesh(s, ball_mesh(1), allocate(1, 4), 0, false);
    uint32_t b = studio_add_mesh(s, ball_mesh(2), allocate(1, 4), 0, true);
    mesh_smooth_normals(&s->mesh[b]);
    for (int i = 0; i < 8; i++) {
        if (kinds & 4)
            studio_place(s, i % 2 ? a : b, random_place(), i % 3 ? red : 0, (cite){0, 0});
        if (kinds & 2 && i % 3 == 1) studio_place(s, a, one, red, (cite){0, 0});
        if (kinds & 2 && i == 5) studio_place(s, b, one, 0, (cite){0, 0});
    }
    if (kinds & 8) random_solids(s);
    if (!studio_finish(s, &f)) abort();
}

static bool occluded(const studio_tree *t, ray r)
{
    return studio_tree_occluded_but(t, &r, world_but_none);
}

static void brute_solids(const studio *s, size_t from, size_t to, ray *r, bool *found,
                         studio_hit *out)
{
    hit h;
    for (size_t k = from; k < to; k++)
        if (csg_hit(&s->solid[k].c, *r, &h) && !(*found && h.t >= r->tmax))
            *out = (studio_hit){h, no_shape - 1 - (uint32_t)k}, *found = true, r->tmax = h.t;
}

/* Everything in turn. Equal t: shapes, then solids that have an end, then the first standing place
 * of each mesh, then other places, then solids without end. */
static bool brute_hit(const studio *s, ray r, studio_hit *out)
{
    scene all = studio_shapes(s);
    bool found = false, seen[2] = {false, false}, *stands = allocate(s->places, sizeof *stands);
    hit h;
    if (scene_hit(&all, r, &h)) *out = (studio_hit){h, no_shape}, found = true, r.tmax = h.t;
    brute_solids(s, 0, s->boxed, &r, &found, out);
    for (uint32_t i = 0; i < s->places; i++) {
        uint32_t m = s->placed[i].mesh;
        stands[i] = studio_stands(s, i) && !seen[m];
        if (stands[i]) seen[m] = true;
    }
    for (int pass = 0; pass < 2; pass++)
        for (uint32_t i = 0; i < s->places; i++) {
            affine back;
            ray inside = r;
            if (stands[i] != (pass == 0)) continue;
            if (pass && (!instance_inverse(s->placed[i].to_world, &back)
                         || !instance_ray(&back, r, &inside))) continue;
            if (!mesh_hit(&s->mesh[s->placed[i].mesh], inside, &h) || (found && h.t >= r.tmax))
                continue;
            *out = (studio_hit){h, i}, found = true, r.tmax = h.t;
        }
    brute_solids(s, s->boxed, s->solids, &r, &found, out);
    free(stands);
    return found;
}

static void test_hits(void)
{
    for (int kinds = 0; kinds < 16; kinds++) {
        studio s;
        studio_tree t;
        failure f;
        random_studio(&s, kinds);
        check_equal(s.boxed, kinds & 8 ? 70 : 0, "solids that have an end");
        check(studio_tree_build(&s, &t, &f), "%s", f.text);
        size_t wrong = 0, hits = 0, material_wrong = 0, seen = 0, off = 0, away = 0;
        for (size_t i = check_count(4000); i-- > 0;) {
            vec3 o = in_cube(6), d = vsub(in_cube(3), o);
            ray r = ray_from(o, vscale(d, (real)0.25 + random_next(&rng)));
            studio_hit x = {hit_none, 0}, y = x;
            bool met = studio_tree_hit(&t, r, &x), should = brute_hit(&s, r, &y);
            wrong += met != should || x.h.t != y.h.t || x.h.shape != y.h.shape
                || x.place != y.place;
            if (i % 2) r.tmax = 2 * random_next(&rng);
            seen += occluded(&t, r) != brute_hit(&s, r, &y);
            if (!met) continue;
            hits++;
            uint32_t m = studio_hit_material(&t, x);
            material_wrong += m != (x.place == no_shape ? s.shape_material[x.h.shape]
                                    : x.place >= no_shape - s.solids
                                    ? s.solid[no_shape - 1 - x.place].material
                                    : s.placing[x.place].material);
            surface a = studio_surface(&t, r, x);
            vec3 p = ray_at(r, x.h.t);
            /* o + t d is off by the rounding of sum and t; both places are some 10 from 0. */
            off += !(vlength(vsub(a.p, p)) <= 4096 * real_epsilon);
            away += !(fabs(vlength(a.n) - 1) <= 8 * real_epsilon && a.error >= 0 && a.noise >= 0);
            if (x.place == no_shape || studio_hit_solid(&t, x)) continue;
            if (!studio_moved(&t, x.place)) continue;
            real pad = placing_pad(&t.pad[x.place], a.p);  /* (16.3), beside what 18 asks */
            away += !(a.error > pad && a.noise > pad);
        }
        check_equal(wrong, 0, "kinds %d: hits as everything in turn has them", kinds);
        check_equal(seen, 0, "kinds %d: occluded, likewise", kinds);
        check_equal(material_wrong, 0, "kinds %d: the material of the place or shape", kinds);
        check_equal(off, 0, "kinds %d: the surface is where the ray hit", kinds);
        check_equal(away, 0, "kinds %d: unit normals, bounds", kinds);
        check(kinds == 0 ? hits == 0 : hits > 0, "kinds %d: %zu hits", kinds,
              hits);
        int parts = (kinds & 1) + (kinds & 2) + (kinds & 8 ? 1 : 0);
        check((t.all->n > 0) == (kinds & 1) && t.world.parts == (size_t)parts
              && (t.moved.n > 0) == ((kinds & 6) != 0),
              "only trees that hold something: %zu parts", t.world.parts);
        studio_tree_free(&t);
        studio_free(&s);
    }
}

/* A square, a mesh that stands and one that is moved, all in the same place: the first counts. */
static void test_equal(void)
{
    const vec3 corner[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const uint32_t expected[3] = {no_shape, 1, 0};
    for (int first = 0; first < 3; first++) {
        studio s;
        studio_tree t;
        failure f;
        mesh m = {.v = allocate(3, sizeof *m.v), .vertices = 3,
                  .index = allocate(3, sizeof *m.index), .triangles = 1};
        memcpy(m.v, corner, 3 * sizeof *m.v);
        m.index[1] = 1, m.index[2] = 2;
        studio_begin(&s);
        uint32_t k = studio_add_mesh(&s, m, allocate(1, 4), 0, false);
        affine one = affine_scaling((vec3){1, 1, 1}), moved = one;
        moved.o.z = -(real)0.0;  /* nowhere else, and yet not as it was */
        if (first < 1) studio_add_polygon(&s, corner, 4, 0);
        studio_place(&s, k, moved, 0, (cite){0, 0});
        if (first < 2) studio_place(&s, k, one, 0, (cite){0, 0});
        if (!studio_finish(&s, &f) || !studio_tree_build(&s, &t, &f)) abort();
        ray r = ray_from(vec(0.75, 0.25, 4), (vec3){0, 0, -1});
        studio_hit x = {hit_none, 7};
        check(studio_tree_hit(&t, r, &x) && x.h.t == 4, "it is hit");
        check(x.place == expected[first],
              "of what lies in one place the first kind counts: place %x", (unsigned)x.place);
        studio_tree_free(&t);
        studio_free(&s);
    }
}

/* From a convex body no ray that leads outwards comes back: instances, scaled, turned, far away;
 * power < 0: far away in the mesh's own space, and back near the origin in the world. */
static void test_leaving(void)
{
    for (int power = -4; power <= 4; power += 2) {
        studio s;
        studio_tree t;
        failure f;
        size_t met = 0, back = 0, rays = check_count(20000);
        real far = power < 0 ? 0 : pow((real)10, (real)power);
        real own = power < 0 ? pow((real)10, (real)(real_is_float ? -power / 2 : -power)) : 0;
        mesh ball = ball_mesh(2);
        vec3 offset = {own, -own / 3, own / 7};
        for (size_t i = 0; i < ball.vertices; i++) ball.v[i] = vadd(ball.v[i], offset);
        studio_begin(&s);
        uint32_t m = studio_add_mesh(&s, ball, allocate(1, 4), 0, false);
        affine a = affine_scaling(vec(2, 0.5, -1));
        a = affine_then(a, affine_rotation(vunit((vec3){1, 2, 3}), 1));
        vec3 at = {far, far / 3, -far / 7};
        a.o = vsub(at, affine_vector(a, offset));
        studio_place(&s, m, a, 0, (cite){0, 0});
        if (!studio_finish(&s, &f) || !studio_tree_build(&s, &t, &f)) abort();
        for (size_t i = 0; i < rays; i++) {
            vec3 o = vadd(at, vscale(vunit(in_cube(1)), 5));
            studio_hit x = {hit_none, 0};
            ray r = ray_from(o, vsub(vadd(at, in_cube(0.3)), o));
            if (!studio_tree_hit(&t, r, &x)) continue;
            surface q = surface_facing(studio_surface(&t, r, x), r.d);
            vec3 w = vunit(in_cube(1));
            if (vdot(w, q.n) < 0) w = vneg(w);
            if (vdot(w, q.n) < (real)1e-3) continue;
            met++;
            back += occluded(&t, leave(q, w));
        }
        check_equal(back, 0, "at 1e%d: rays that leave an instance do not meet it again", power);
        check_at_least(met, rays / 2, "at 1e%d: rays", power);
        studio_tree_free(&t);
        studio_free(&s);
    }
}

/* ---- solids cut from solids ---- */

typedef bool solid_membership(vec3 p);

static bool in_ball(vec3 p, vec3 c, real r) { return vdot(vsub(p, c), vsub(p, c)) <= r * r; }
static bool in_cube_of(vec3 p, real a)
{
    return fabs(p.x) <= a && fabs(p.y) <= a && fabs(p.z) <= a;
}
static bool bitten(vec3 p)
{
    return in_cube_of(p, 1) && !in_ball(p, (vec3){0, 0, 1}, (real)0.75)
        && !(p.y * p.y + p.z * p.z <= (real)0.0625);
}
static bool cut_die(vec3 p) { return in_cube_of(p, 1) && in_ball(p, (vec3){0, 0, 0}, (real)1.25); }
static bool roof(vec3 p)
{
    return in_ball(p, (vec3){0, 0, 0}, 1) && 3 * p.x + 4 * p.y <= 2
        && !(fabs(p.x) + fabs(p.y) + fabs(p.z - (real)0.5) <= (real)0.5);
}

static const struct { const char *text; solid_membership *in; } solid_list[] = {
    {"difference(box -1 -1 -1 1 1 1, sphere 0 0 1 0.75, cylinder 0 0 0 1 0 0 0.25)", bitten},
    {"intersection(box -1 -1 -1 1 1 1, sphere 0 0 0 1.25)", cut_die},
    {"difference(intersection(sphere 0 0 0 1, half 3 4 0 2), gem 0 0 0.5 0.5)", roof}};

/* Is any of the way [0, t] of r in the solid (or, not `inside`, out of it)? By looking. */
static bool solid_on_way(solid_membership *in, ray r, real t, bool inside)
{
    const real near = (real)1e-3;
    for (int k = 0; k < 40; k++) {
        real at = near + (t - 2 * near) * random_next(&rng);
        if (t > 2 * near && in(ray_at(r, at)) == inside) return true;
    }
    return false;
}

/* Up to the hit nobody is at home; there one enters, and n points back out. Then a ray from there,
 * either way: into the solid all is solid as far as it goes, out of it nothing is. The only oracle
 * is membership. */
static void test_solids(void)
{
    for (size_t k = 0; k < sizeof solid_list / sizeof *solid_list; k++) {
        studio s;
        studio_tree t;
        failure f;
        size_t hits = 0, missed = 0, turned = 0, again = 0, differ = 0, away = 0;
        solid_membership *in = solid_list[k].in;
        studio_begin(&s);
        studio_solid x = {.material = 0};
        if (!solid_read(&x, solid_list[k].text, &f)) abort();
        studio_grow(&s, solid, s.solids);
        s.solid[s.solids++] = x;
        if (!studio_finish(&s, &f) || !studio_tree_build(&s, &t, &f)) abort();
        for (size_t i = check_count(4000); i-- > 0;) {
            vec3 o = vscale(vunit(in_cube(1)), 3);
            ray r = ray_from(o, vunit(vsub(in_cube(1), o)));
            studio_hit h = {hit_none, 0};
            bool met = studio_tree_hit(&t, r, &h);
            missed += solid_on_way(in, r, met ? h.h.t : 6, true);
            r.tmax = 6 * random_next(&rng);
            differ += occluded(&t, r) != (met && h.h.t <= r.tmax);
            if (!met) continue;
            hits++;
            surface a = studio_surface(&t, r, h);
            const real near = (real)1e-3;
            away += !(vlength(vsub(a.p, ray_at(r, h.h.t))) <= 256 * real_epsilon);
            turned += vdot(a.n, r.d) > 0 || in(vmadd(a.p, a.n, near))
                || !in(vmadd(a.p, a.n, -near));
            vec3 w = vunit(in_cube(1));
            r = leave(a, w);
            met = studio_tree_hit(&t, r, &h);
            if (fabs(vdot(w, a.n)) < (real)0.05) continue;  /* too near to see by points */
            again += solid_on_way(in, r, met ? h.h.t : 3, vdot(w, a.n) > 0)
                || (met && vdot(w, a.n) * vdot(studio_surface(&t, r, h).n, w) > 0);
        }
        check_at_least(hits, check_count(4000) / 3, "solid %zu: hits", k);
        check_equal(missed, 0, "solid %zu: rays through what they should hit", k);
        check_equal(differ, 0, "solid %zu: occluded as the hit says", k);
        check_equal(away, 0, "solid %zu: surfaces where the ray hit", k);
        check_at_most(turned, hits / 100, "solid %zu: normals that do not point out; near edges "
                      "one step along n may end elsewhere", k);
        check_equal(again, 0, "solid %zu: rays from the surface that meet it again, or leak", k);
        studio_tree_free(&t);
        studio_free(&s);
    }
}

/* ---- lamps and sky ---- */

/* (27.6) for the lamp that was drawn, whichever it was, against the pdf it was drawn with. */
static void test_pdf(const studio_tree *t, const lamp_list *l)
{
    double worst = 0;
    size_t spheres = 0, n = check_count(20000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(5, i, 0);
        real x = random_next(&s), y = random_next(&s), z = random_next(&s), u = random_next(&s);
        vec3 p = {6 * x - 3, 4 * y, 6 * z - 3};
        lit_draw w;
        if (!lamps_sample(l, p, (vec3){0, 1, 0}, (point2){u, random_next(&s)}, &w)) continue;
        const shape *ball = t->s->shape;  /* the first; all that shine are told apart by Ke */
        bool is_ball = w.Le.y > 0;
        vec3 to = vsub(w.s.p, p);
        real pdf = lamps_pdf(l, w.Le, is_ball ? ball : NULL, p, w.wi, vlength(to),
                             -vdot(w.s.n, w.wi));
        spheres += is_ball, worst = check_worse(worst, fabs((double)(pdf / w.pdf) - 1));
    }
    check_at_least(spheres, n / 20, "times the ball was drawn");
    check_at_least(n - spheres, n / 20, "times others were");
    check_at_most(worst, 16 * (double)real_epsilon, "pdf of what was drawn: a dozen roundings");
}

static void test_lamps(void)
{
    failure f;
    studio s;
    studio_tree t;
    lamp_list l;
    if (!studio_read_text("material ball\nKe 1 2 0\nsphere 0 6 0 0.5\nmaterial others\nKe 3 0 1\n"
                          "polygon -1 5 1  1 5 1  1 5 -1  -1 5 -1\n"
                          "polygon -2 5 0  -1.5 5.5 0  -2 6 0\n", "lamps", NULL, &s, &f)) fail(f);
    if (!studio_tree_build(&s, &t, &f)) fail(f);
    lamps_build(&t, &l);
    lamps_add(&l, (emitter){.area = 0}, studio_no_face);
    lamps_add(&l, (emitter){.area = real_infinity}, studio_no_face);
    check_equal((double)l.n, 3, "lamps, all of some area");
    test_pdf(&t, &l);
    lamps_free(&l), studio_tree_free(&t), studio_free(&s);
}

/* What (16.3) says of a lamp that was moved, by the sum of placing.h, each term told by hand:
 * M = 2, A = 1/2, m = (4, -8, 1), V = 3, k = K = 1, nothing left of E and f; its corners are 10
 * from 0. The ray that meets it pays a pad; its corners, M v + m, are four roundings of 2 V + 8
 * off. */
static void test_moved_lamp(void)
{
    failure f;
    studio s;
    studio_tree t;
    lamp_list l;
    mesh m = {.v = allocate(3, sizeof *m.v), .vertices = 3, .index = allocate(3, sizeof *m.index),
              .triangles = 1};
    m.v[0] = (vec3){0, 0, 0}, m.v[1] = (vec3){3, 0, 0}, m.v[2] = (vec3){0, 1, 0};
    for (uint32_t i = 0; i < 3; i++) m.index[i] = i;
    studio_begin(&s);
    uint32_t lamp = studio_add_material(&s, "lamp", (cite){0, 0});
    s.material[lamp].mtl.ke = (vec3){1, 1, 1};
    affine place = affine_scaling((vec3){2, 2, 2});
    place = affine_then(place, affine_translation((vec3){4, -8, 1}));
    studio_place(&s, studio_add_mesh(&s, m, allocate(1, 4), 0, false), place, lamp, (cite){0, 0});
    if (!studio_finish(&s, &f) || !studio_tree_build(&s, &t, &f)) fail(f);
    lamps_build(&t, &l);
    check_equal((double)l.n, 1, "one lamp that was moved");
    const triangle at = {{4, -8, 1}, {10, -8, 1}, {4, -6, 1}};
    const real eps = real_epsilon, third = (real)4 / 3, world = 2 * 3 + 8;
    real pad = third * eps * (260 * 10 + 260 * (2 * 4 + world) + 2 * world);
    real more = l.face[0].noise - emitter_of_triangle(at, (vec3){1, 1, 1}).noise;
    check(more >= pad + 2 * eps * world, "a moved lamp is off by %g more, owed are %g",
          (double)more, (double)(pad + 2 * eps * world));
    check_at_most((double)(more / pad), 2.01, "and by two pads, not more");
    lamps_free(&l), studio_tree_free(&t), studio_free(&s);
}

/* A direction drawn by the picture has the light and the pdf that a ray there finds. */
static void test_sky(void)
{
    effects_sky s = {.kind = SKY_IMAGE, .scale = 2, .up = {0, 1, 0}, .front = {0.6, 0, -0.8},
                     .right = {0.8, 0, 0.6}};
    failure f;
    image im = image_new(8, 4);
    size_t seen = 0, other = 0, likely = 0;
    for (int i = 0; i < 32; i++)
        image_set(&im, i % 8, i / 8, vec((1 + i), (40 - i), 1));
    check(environment_of_image(&im, &s.picture, &f), "%s", f.text);
    for (int i = 0; i < 4000; i++) {
        random_stream r = random_start(6, (uint64_t)i, 0);
        lit_draw x;
        real u = random_next(&r);
        if (!sky_draw(&s, (vec3){0, i % 2 ? 1 : -1, 0}, (point2){u, random_next(&r)}, &x))
            continue;
        vec3 L = sky_radiance(&s, x.wi);
        seen++, other += vlength(vsub(L, x.Le)) > 8 * real_epsilon * vlength(L);
        likely += !(fabs(sky_pdf(&s, x.wi, 1) - x.pdf) <= 64 * real_epsilon * x.pdf);
    }
    check_at_least(seen, 1500, "directions in the half that n looks into");
    check_at_most((double)other, real_is_float ? 2 : 0, "with another light: at edges of pixels");
    check_at_most((double)likely, real_is_float ? 2 : 0, "with another pdf");
    sky_free(&s), image_free(&im);
}

/* What solid_surface says of a wall of radius 2 and of a plane 3 from 0; what counts as a
 * rectangle, as inside a lamp, as more than it gets: whole numbers, of which the sums are told. */
static void test_owed(void)
{
    const real eps = real_epsilon;
    const struct { const char *text; ray r; real size, p, noise; } list[] = {
        {"cylinder 0 0 0 0 0 1 2", {{5, 0, 0}, 0, {-1, 0, 0}, real_infinity}, 2 + 2, 2, 16},
        {"half 0 0 1 3", {{0, 4, 9}, 0, {0, 0, -1}, real_infinity}, 5 + 3, 4, 8}};
    for (int i = 0; i < 2; i++) {
        studio_solid x;
        failure f;
        hit h = hit_none;
        check(solid_read(&x, list[i].text, &f) && csg_hit(&x.c, list[i].r, &h), "%s", list[i].text);
        surface s = solid_surface(&x, list[i].r, h);
        real error = 4 * list[i].size + 2 * list[i].p, noise = list[i].noise * list[i].size;
        check_close(s.error / eps, error, (real)0.01, "%s: error", list[i].text);
        check_close(s.noise / eps, noise, (real)0.01, "%s: noise", list[i].text);
        solid_free(&x);
    }
    vec3 v[4] = {{0, 0, 0}, {4, 0, 0}, {4 + 64 * eps, 4, 0}, {0, 4, 0}};  /* of 128 eps allowed */
    polygon g = polygon_of(v, 4);
    check(finish_is_parallelogram(&g), "a rectangle but for roundings: one lamp");
    vec3 p = {1 - 18 * eps, 0, 0};  /* 16 eps r + 4 eps |p| = 20 eps */
    check(!lamps_within((sphere){{0, 0, 0}, 1}, p, (vec3){1, 0, 0}), "on it: the normal says");
    appearance a = {.m = {.kd = {0.5, 0.5, 0.5}, .mirror = {(real)0.5 + 8 * eps, 0.5, 0.5}}};
    appearance_limit(&a);
    check_equal(a.m.kd.y, (real)0.5, "1 + 8 eps: no more than it gets");
}

/* ---- what a ray is known not to meet ---- */

/* Everything twice, also turned round: a ball of triangles that shines and stands in its own
 * light, smoothed; squares, flat and bent, a flat star, some of which shine; balls and cones. */
static void double_studio(studio *s)
{
    failure f;
    mesh m = ball_mesh(2);
    studio_begin(s);
    uint32_t look[2] = {studio_add_material(s, "dull", (cite){0, 0}),
                        studio_add_material(s, "lamp", (cite){0, 0})};
    s->material[look[1]].mtl.ke = (vec3){1, 2, 3};
    m.index = realloc(m.index, 6 * m.triangles * sizeof *m.index);
    if (!m.index) abort();
    for (size_t i = 0; i < 3 * m.triangles; i++)
        m.index[3 * m.triangles + i] = m.index[i / 3 % 2 ? i / 3 * 3 + 2 - i % 3 : i];
    m.triangles *= 2;
    for (size_t i = 0; i < m.vertices; i++) m.v[i] = vscale(m.v[i], 1 + uniform() / 4);
    uint32_t ball = studio_add_mesh(s, m, allocate(1, 4), 0, true);
    mesh_smooth_normals(&s->mesh[ball]);
    studio_place(s, ball, affine_scaling((vec3){1, 1, 1}), look[1], (cite){0, 0});
    for (int i = 0; i < 12; i++) {
        vec3 v[8] = {in_cube(2), in_cube(2), in_cube(2), {0, 0, 0}};
        v[3] = vadd(v[0], vsub(v[2], v[1]));
        if (i % 6 == 3) v[3] = vmadd(v[3], in_cube(1), (real)0.1);  /* bent */
        int corners = 4;
        for (int k = 0; i % 6 == 5 && k < 8; k++, corners = 8) {
            real a = (real)k * pi / 4, r = k % 2 ? (real)0.4 : 1;
            v[k] = (vec3){2 * r * cos(a), 2 * r * sin(a), -1};
        }
        for (int k = 0; k < 2; k++) studio_add_polygon(s, v, (size_t)corners, look[i % 2]);
        sphere round = {v[0], uniform() / 2};
        if (i % 2) studio_add_shape(s, shape_of_sphere(round), look[i % 4 / 2]);
        else studio_add_shape(s, shape_of_cone((cone){v[0], round.r, v[1], uniform() / 2}), 0);
    }
    if (!studio_finish(s, &f)) abort();
}

/* Away from the face, into it, or along it, as nearly as can be. */
static vec3 any_way(const surface *s, vec3 d)
{
    real x = random_next(&rng);
    vec3 w = in_cube(1), flat = vmadd(w, s->n, -vdot(w, s->n));
    if (x < (real)0.2) return reflect(d, s->ns);
    if (x < (real)0.5) return vmadd(flat, s->n, uniform() * pow((real)10, -16 * random_next(&rng)));
    return x < (real)0.6 ? flat : w;
}

typedef struct { size_t met, wrong, from, to, kept; } left_out;

static void leave_out(const effects_stage *e, ray r, left_out *n)
{
    studio_hit x = {hit_none, 0}, all = x;
    effects_counts c = {.lost = 0};
    branch b = {.r = r, .weight = {1, 1, 1}}, child;
    if (!studio_tree_hit(&e->t, r, &x)) return;
    gather_hit h = {.e = e, .b = &b, .c = &c, .flat = studio_flat_face(&e->t, x)};
    h.s = surface_facing(studio_surface(&e->t, r, x), r.d);
    vec3 d = any_way(&h.s, r.d), side = random_next(&rng) < (real)0.5 ? h.s.n : vneg(h.s.n);
    effects_child(&h, EFFECT_MIRROR, RAY_MIRRORED, side, d, b.weight, &child);
    world_but but = studio_but(child.left, studio_no_face);
    bool met = studio_tree_hit(&e->t, child.r, &all), same;
    studio_hit y = all;
    same = met == studio_tree_hit_but(&e->t, &child.r, but, &y) && y.place == all.place
        && y.h.shape == all.h.shape && y.h.t == all.h.t && y.h.u == all.h.u && y.h.v == all.h.v;
    n->met++, n->wrong += !same, n->from += but.from != no_shape;
    n->kept += met && but.from == no_shape && all.place == x.place
        && all.h.shape == x.h.shape;  /* it does meet it again: nobody left it out */
    lit_draw lamp;
    point2 u = {random_next(&rng), random_next(&rng)};
    if (!lamps_sample(&e->lamp, h.s.p, h.s.n, u, &lamp)) return;
    ray shadow = lit_draw_ray(&h.s, &lamp);
    but = gather_but(&h, RAY_TO_LAMP, &lamp, shadow);
    n->wrong += occluded(&e->t, shadow)
        != studio_tree_occluded_but(&e->t, &shadow, but);
    n->to += but.first != no_shape;
}

static void test_left_out(void)
{
    left_out n = {0};
    size_t rays = check_count(400000);
    for (int scene_number = 0; scene_number < 8; scene_number++) {
        studio s;
        effects_stage e;
        failure f;
        double_studio(&s);
        if (!effects_stage_build(&s, &e, &f)) fail(f);
        for (size_t i = 0; i < rays / 8; i++) {
            vec3 o = in_cube(3), to = in_cube(2);
            const vec3 *v = s.corner + (size_t)(random_next(&rng) * (real)(s.corners - 1));
            if (i % 4 == 0) to = v[0];
            if (i % 4 == 1) to = vmadd(v[0], vsub(v[1], v[0]), random_next(&rng));
            leave_out(&e, ray_from(o, vsub(to, o)), &n);
        }
        effects_stage_free(&e), studio_free(&s);
    }
    check_equal((double)n.wrong, 0, "of %zu hits: rays that miss something if faces are left out",
                n.met);
    check_at_least(n.met, rays / 3, "hits");
    check_at_least(n.from, n.met / 4, "rays for which the face they left was left out");
    check_at_least(n.to, n.met / 10, "rays for which their lamp was");
    check_at_least(n.kept, n.met / 50, "rays that do meet it again");
}

int main(void)
{
    rng = random_start(27, 2, 0);
    return check_all("27_tree", test_hits, test_equal, test_leaving, test_left_out, test_solids,
                     test_owed, test_lamps, test_moved_lamp, test_sky);
}
