/* 18_leave: rays that leave surfaces: no self-hits, no missed occluders; bounds against exact
 * distances; the other ways fail where they are said to. */
#include "check.h"
#include "../chapters/18_shade/lab/measure.h"
#include "../chapters/18_shade/trace.h"

static const int last = leavings - 1;  /* the default stands last */

/* NUMERICS: n.w > 1e-3, T up to 1e6; gaps of 1e-6 max(1, T / 1e4), in float 32 ulps of |p|. */
static void test_default(void)
{
    static const char *const names[] = {"sphere", "triangle", "needle", "cone", "polygon"};
    for (int kind = 0; kind < departure_kinds; kind++) {
        size_t self = 0, leak = 0, n = check_count(kind < 2 ? 20000 : 8000), all = 0;
        for (int e = -3; e <= 6; e++)
            for (int moved = 0; moved < 2; moved++) {
                /* in float a shape of 1 is not a shape any more at 1e6, but for the first three:
                 * a cone's wall is thinner there than the reals are apart */
                if (real_is_float && moved && e > 3 && kind >= DEPART_CONE) continue;
                real x = pow((real)10, (real)e);
                for (size_t i = 0; i < n; i++) {
                    departure d;
                    departure_make(&d, (departure_kind)kind, moved ? 1 : x, moved ? x : 0, 5, i);
                    self += departure_self(&d, ways[last]);
                    leak += departure_leak(&d, ways[last], departure_gap(&d));
                    all++;
                }
            }
        /* A cone's tip has no normal: in float some hits lie within an offset of it, about one in
         * 22000. Four more are allowed, as few of them scatter. Without the noise of the test there
         * would be ten times as many. */
        bool tip = real_is_float && kind == DEPART_CONE;
        size_t tips = tip ? all / 5000 : 0;
        check_at_most(self, tips / 4 + (tip ? 4 : 0), "%s: rays that meet the surface they leave",
                      names[kind]);
        check_at_most(leak, tips, "%s: occluders missed", names[kind]);
    }
}

static leaving_score play(int way, departure_kind kind, real size, real T, size_t n)
{
    return leaving_play(ways[way], kind, size, T, 6, n);
}

static void test_others_fail(void)
{
    size_t n = check_count(20000);
    n = n < 4000 ? 4000 : n;  /* the rarest failure here is one in a hundred */
    check_at_least(play(0, DEPART_TRIANGLE, 1e-3, 0, n).leak, 90, "eps 1e-4, too");
    check_at_least(play(1, DEPART_SPHERE, 1, 100, n).self, 5, "eps in t: grazing rays");
    check_at_least(play(2, DEPART_TRIANGLE, 1000, 0, n).self, 0.2, "eps |p|: large ones");
    check_equal(play(2, DEPART_SPHERE, 1, 0, n).self, 0, "eps |p|: but not spheres");
    if (real_is_float) check_at_least(play(3, DEPART_SPHERE, 1, 0, n).leak, 30, "256 ulps");
    size_t bounds = 0, ulps = 0;
    for (size_t i = 0; i < 200000; i++) {
        departure d;
        departure_make(&d, DEPART_NEEDLE, 1, 0, 7, i);
        bounds += departure_self(&d, ways[4]);
        departure_make(&d, DEPART_TRIANGLE, 1e6, 0, 7, i / 2);
        if (i % 2) ulps += departure_self(&d, ways[3]);
    }
    if (!real_is_float) check_at_least(bounds, 1, "bounds of p alone: needles");
    check_at_least(ulps, 1, "ulps: large triangles");
    leaving_score first = play(0, DEPART_SPHERE, 1, real_is_float ? 1e4 : 1e6, n);
    check_at_least(first.self, 10, "the notes' eps and tests, far out: a tenth is black");
    check_at_least(first.leak, 10, "and light comes through what is close above it");
}

/* Distance of a point from the surface, with its sign along n: exactly, but for 1e-30. */
static double distance(const shape *s, vec3 n, vec3 p)
{
    if (s->kind == SHAPE_SPHERE) {
        wide3 f = wide3_sub(wide3_of(p), wide3_of(s->sphere.c));
        double d = wide_value(wide_sub(wide3_length(f), wide_of((double)s->sphere.r)));
        return vdot(n, vsub(p, s->sphere.c)) < 0 ? -d : d;
    }
    wide3 a = wide3_of(s->triangle.a), e = wide3_sub(wide3_of(s->triangle.b), a);
    wide3 x = wide3_cross(e, wide3_sub(wide3_of(s->triangle.c), a));
    wide d = wide_div(wide3_dot(x, wide3_sub(wide3_of(p), a)), wide3_length(x));
    wide side = wide3_dot(x, wide3_of(n));
    return wide_sign(side) < 0 ? -wide_value(d) : wide_value(d);
}

/* (18.5): |p - surface| <= error; O on the side of w, and not farther off than twice of it all. */
static void test_bounds(void)
{
    size_t n = check_count(30000), beyond = 0, behind = 0, far = 0, naive = 0;
    for (int kind = 0; kind <= DEPART_TRIANGLE; kind++)
        for (int e = 0; e <= 6; e += 2)
            for (size_t i = 0; i < n; i++) {
                departure d;
                departure_make(&d, (departure_kind)kind, 1, e ? pow((real)10, (real)e) : 0, 9, i);
                surface s = departure_surface(&d, false), old = departure_surface(&d, true);
                beyond += !(fabs(distance(&d.s, s.n, s.p)) <= (double)s.error);
                naive += !(fabs(distance(&d.s, s.n, old.p)) <= (double)s.error);
                ray out = leave(s, d.w), in = leave(s, vneg(d.w));
                behind += !(distance(&d.s, s.n, out.o) > 0) || !(distance(&d.s, s.n, in.o) < 0);
                double most = 2 * (double)(s.error + s.noise);
                far += !(distance(&d.s, s.n, out.o) <= most);
                far += out.tmin != 0 || out.tmax != real_infinity;
            }
    check_equal(beyond, 0, "p farther from the surface than its bound says");
    check_equal(behind, 0, "an origin on the wrong side");
    check_equal(far, 0, "an origin too far away, or another interval than [0, inf]");
    check_at_least(naive, n / 100, "o + t d is farther off than that, now and then");
}

/* Exact inputs. */
static void test_named(void)
{
    shape ball = shape_of_sphere((sphere){{0, 0, 0}, 1});
    hit h;
    ray r = ray_from((vec3){0, 0, 4}, (vec3){0, 0, -2});
    check(shape_hit(ball, r, &h), "straight down");
    surface s = surface_of_shape(&ball, r, h);
    check(s.p.x == 0 && s.p.y == 0 && s.p.z == 1 && s.n.z == 1 && s.ns.z == 1, "the north pole");
    check_close(s.error, 6 * real_epsilon, 1e-3 * (double)real_epsilon, "4 eps R + 2 eps |p|");
    check_equal(s.noise, 0, "spheres are tested exactly");
    ray in = leave(s, (vec3){0, 0, -1});
    check(shape_hit(ball, in, &h), "into it: the other side is met");
    check_close(h.t, 2, 16 * (double)real_epsilon, "the south pole");
    check(!shape_hit(ball, leave(s, (vec3){1, 0, 0}), &h), "along the tangent: nothing");
    s.ns = (vec3){1, 0, 0};
    check(leave(s, vec(-1, 0, 0.1)).o.z > 1, "the geometric normal tells the side");
    surface turned = surface_facing(s, (vec3){0, 0, 1});
    check(turned.n.z == -1 && turned.ns.x == -1, "seen from within, both normals turn");
    ball.sphere.r = -1;  /* a sphere turned inside out: n points inwards (03) */
    s = surface_of_shape(&ball, r, h);
    check(s.n.z == -1 && s.p.z == 1 && s.error > 0, "radius -1");
    ray to = leave_to(s, (vec3){0, 0, 3});
    check(to.tmin == 0 && to.tmax == 1 && ray_at(to, 1).z == 3, "[0, 1] ends at the light");
}

/* Without a root up to some 1e7 R, with one beyond, from where o + t d misses the ball by more. */
static void test_far_balls(void)
{
    double longer = 0, off = 0;
    int lost = 0, turned = 0;
    for (int k = 1; ldexp((double)real_epsilon, k) < 0.01; k++)
        for (int i = 0; i < 16; i++) {
            vec3 d = vunit(vec(cos(i + k), sin(i + k), sin(3 * i)));
            shape ball = shape_of_sphere((sphere){vec(0.5, -0.25, i), i % 2 ? -1 : 1});
            ray r = ray_from(vmadd(ball.sphere.c, d, -(real)ldexp(1, k)), d);
            hit h;
            if (!shape_hit(ball, r, &h)) lost++;
            surface s = surface_of_shape(&ball, r, h);
            longer = fmax(longer, fabs((double)vlength(s.n) - 1));
            ball.sphere.r = 1;
            off = fmax(off, fabs(distance(&ball, s.n, s.p)) / (double)s.error);
            turned += (vdot(s.n, d) < 0) == i % 2;
        }
    check_equal(lost, 0, "aimed at the middle");
    check_at_most(longer, 2.5 * (double)real_epsilon, "a normal is unit");
    check_at_most(off, 1, "p is on the ball, but for its error");
    check_equal(turned, 0, "R < 0: inwards");
}

/* The table of surface.h. Of the cone's 4 eps H, 3 million random ones have met 0.83, of the
 * polygon's 4 eps L 0.75; with the noise 1.7 of 12 and 6.5 of 8, and needles 16 of 38. Roundings do
 * not all conspire; the sums are what is promised. */
static void test_owed(void)
{
    const double eps = (double)real_epsilon;
    vec3 corner[4] = {{-3, -4, 0}, {3, -4, 0}, {3, 4, 0}, {-3, 4, 0}}, x = {1, 2, 0};
    cone c = {{0, 0, 0}, 1, {0, 0, 2}, 1};
    surface s = surface_on_cone(c, 0, (vec3){1, 0, 1});
    surface g = surface_on_polygon(polygon_of(corner, 4), 0, x);
    check_close(s.error / real_epsilon, 4 * 4 + 2, 1e-3, "a cone: 4 eps H + 2 eps |p|, H = 4");
    check_close(s.noise / real_epsilon, 8 * 4, 1e-3, "a cone: 8 eps H");
    check_close(g.error / real_epsilon, 4 * 5 + 2 * 2, 1e-3, "a polygon: 4 eps L + 2 |p|, L = 5");
    check_close(g.noise / real_epsilon, 4 * 5, 1e-3, "a polygon: 4 eps L");
    triangle thin = {{0, 0, 0}, {1, 0, 0}, {1, (real)0.001, 0}};
    s = surface_on_triangle(thin, 0, (real)0.2, (real)0.2);
    check_close(s.noise / real_epsilon, 4 + 64 / 2, 1e-3, "needles: (4 + k/2) eps L, k up to 64");
    /* (18.9): p is off by 2 eps (L + |p|), the wall behind is seen (4 + k/2) eps L off; k, L = 1 */
    for (real a = 0; a < 10000; a = 10 * a + 1) {
        double owed = eps * (2 * (1 + (double)a) + 4.5);
        double margin = (double)surface_margin((vec3){a, 0, 0}, 1, 1);
        check_at_least(margin, owed, "margin, |a| = %g", (double)a);
        real tiny = (real)0x1p-10;
        check_equal((double)surface_margin((vec3){a * tiny, 0, 0}, tiny, 1), margin,
                    "a weight: the same for all of it in another size");
    }
    /* between: the test's 3 eps D for a corner, as much for t d, at both ends */
    surface to = {{1000, 0, 0}, {-1, 0, 0}, {-1, 0, 0}, 0, 0, 1}, at = {.n = {1, 0, 0}};
    ray r = leave_between(at, to);
    check_at_least(r.o.x, 6 * 1000 * real_epsilon, "the near end of a line of sight of 1000");
    check_at_least(1000 - ray_at(r, 1).x, 6 * 1000 * real_epsilon, "and its far end");
}

/* A floor of two triangles. Skipping the shape that a ray leaves is not enough: near the diagonal
 * it meets the neighbour, which lies in the same plane. */
typedef struct { uint32_t own; } skip_payload;

static any_hit_answer skip_own(const tracer *t, ray r, trace_hit x, void *payload)
{
    (void)t, (void)r;
    return x.h.shape == ((skip_payload *)payload)->own ? ANY_HIT_IGNORE : ANY_HIT_ACCEPT;
}

static void test_skip(void)
{
    static const ray_program programs[ray_kinds] = {
        [RAY_CAMERA] = {1, false, NULL, NULL, NULL},
        [RAY_SHADOW] = {1, true, NULL, NULL, NULL},
        [RAY_REFLECTION] = {1, true, skip_own, NULL, NULL}};
    size_t n = check_count(40000), plain = 0, skipping = 0, leaving_both = 0, asked = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(11, i, 0);
        vec3 x, y, z = random_unit(&s), c = vscale(random_unit(&s), 300);
        vbasis(z, &x, &y);
        vec3 a = vadd(c, x), b = vadd(c, y), d = vsub(c, x), e = vsub(c, y);
        shape two[2] = {shape_of_triangle((triangle){a, b, d}),
                        shape_of_triangle((triangle){a, d, e})};
        scene floor = {two, 2};
        vec3 from = vadd(c, vscale(z, 2)), w = departure_towards(z, 0.0015, &s);
        real on = random_next(&s) * 2 - 1;
        real across = (random_next(&s) - (real)0.5) * 10000 * real_epsilon;
        ray r = ray_between(from, vmadd(vmadd(c, x, on), y, across));
        r.tmax = real_infinity;
        hit h;
        if (!scene_hit(&floor, r, &h)) continue;
        world_part part;
        world_part_of_scene(&floor, 1, &part);
        trace_world all = {&part, 1};
        tracer t = {.w = &all, .program = programs};
        skip_payload own = {h.shape};
        ray naive = {ray_at(r, h.t), 0, w, real_infinity};
        plain += trace(&t, RAY_SHADOW, naive, NULL);
        skipping += trace(&t, RAY_REFLECTION, naive, &own);
        surface at = surface_facing(surface_of_shape(&two[h.shape], r, h), r.d);
        leaving_both += trace(&t, RAY_SHADOW, leave(at, w), NULL);
        asked++;
        world_part_free(&part);
    }
    check_at_least(asked, n / 2, "rays hit the floor");
    check_at_least(plain, n / 20, "no offset: acne");
    check_at_least(plain, skipping + n / 50, "skipping the own triangle helps");
    check_at_least(skipping, n / 500, "but not against its neighbour");
    check_equal(leaving_both, 0, "leave needs no skipping");
}

/* Both ends on surfaces: points in two faces of a room see each other, wherever the room is. */
static void test_between(void)
{
    size_t blocked = 0, unlike = 0, n = check_count(30000), naive = 0;
    for (int e = 0; e <= 6; e += 2)
        for (size_t i = 0; i < n; i++) {
            random_stream s = random_start(12, i, (uint64_t)e);
            real T = e ? pow((real)10, (real)e) : 0;
            vec3 c = vscale(random_unit(&s), T), x, y, z = random_unit(&s);
            vbasis(z, &x, &y);
            shape two[2];
            surface at[2];
            for (int k = 0; k < 2; k++) {  /* floor and ceiling, or two balls, 4 apart */
                vec3 m = vmadd(c, z, k ? 2 : -2);
                two[k] = i % 2 ? shape_of_sphere((sphere){m, 1})
                               : shape_of_triangle((triangle){vmadd(m, x, 3), vmadd(m, y, 3),
                                                              vmadd(vmadd(m, x, -3), y, -3)});
                real u = i % 2 ? 0 : random_next(&s) / 2, v = random_next(&s);
                vec3 aim = i % 2 ? vmadd(m, departure_towards(z, v, &s), k ? -1 : 1)
                                 : vmadd(vmadd(m, x, v), y, u);
                ray r = ray_between(c, aim);
                hit h;
                r.tmax = real_infinity;
                if (!shape_hit(two[k], r, &h)) h.t = real_infinity;
                at[k] = surface_facing(surface_of_shape(&two[k], r, h), r.d);
            }
            if (!vfinite(at[0].p) || !vfinite(at[1].p)) continue;
            vec3 ab = vunit(vsub(at[1].p, at[0].p));
            if (!(vdot(at[0].n, ab) > (real)0.01 && vdot(at[1].n, ab) < (real)-0.01)) continue;
            scene room = {two, 2};
            bool there = scene_occluded(&room, leave_between(at[0], at[1]));
            blocked += there;
            unlike += there != scene_occluded(&room, leave_between(at[1], at[0]));
            naive += scene_occluded(&room, ray_between(at[0].p, at[1].p));
        }
    check_equal(blocked, 0, "an end of a line of sight is met");
    check_equal(unlike, 0, "a sees b, but b does not see a");
    check_at_least(naive, n / 10, "[0, 1] between the points themselves meets its ends");
}

/* Closed rooms of twelve triangles, turned and moved; from the middle at points within 16 eps of an
 * edge, or of a corner, and on from there. `bare`: the same without (18.9). */
static const uint32_t room_index[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                        2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};

static vec3 room_point(const vec3 axis[3], vec3 centre, const real x[3])
{
    return vmadd(vmadd(vmadd(centre, axis[0], x[0]), axis[1], x[1]), axis[2], x[2]);
}

static void test_rooms(void)
{
    size_t n = check_count(60000), lost = 0, bare = 0, eye = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(18, i, 0);
        vec3 axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, v[8], centre = {0, 0, 0};
        if (i % 4 > 1) axis[2] = random_unit(&g), vbasis(axis[2], &axis[0], &axis[1]);
        if (i % 4 == 3) centre = vscale(random_unit(&g), 10);
        for (int k = 0; k < 8; k++) {
            real x[3] = {(real)(2 * (k & 1) - 1), (real)((k & 2) - 1), (real)((k & 4) / 2 - 1)};
            v[k] = room_point(axis, centre, x);
        }
        mesh m = {.v = v, .vertices = 8, .index = (uint32_t *)room_index, .triangles = 12};
        real x[3] = {i & 8 ? -1 : 1, i & 16 ? -1 : 1, 2 * random_next(&g) - 1};
        for (int k = 0; k < (i & 32 ? 3 : 2); k++) {  /* three: a corner */
            if (k == 2) x[2] = x[2] < 0 ? -1 : 1;
            x[k] *= 1 - 16 * real_epsilon * random_next(&g);
        }
        vec3 from = vmadd(centre, random_unit(&g), 0.5);
        ray r = ray_from(from, vsub(room_point(axis, centre, x), from));
        hit h = hit_none, other = hit_none;
        if (!mesh_hit(&m, r, &h)) { eye++; continue; }
        surface s = surface_facing(surface_of_mesh(&m, h), r.d);
        real cosine = (real)0.001 + (i % 3 ? (real)0.999 * random_next(&g) : 0);
        vec3 w = departure_towards(s.n, cosine, &g);
        lost += !mesh_hit(&m, leave(s, w), &other);
        triangle t = mesh_triangle(&m, h.shape);
        s.p = vadd(t.a, vmadd(vscale(vsub(t.b, t.a), h.u), vsub(t.c, t.a), h.v));
        bare += !mesh_hit(&m, leave(s, w), &other);
    }
    check_equal(eye, 0, "closed: whoever looks from the middle sees a wall");
    check_equal(lost, 0, "rays that get out of a closed room");
    check_at_least((double)bare, (double)n / 2000, "with p on the edge itself some do");
}

int main(void)
{
    return check_all("18_leave", test_default, test_others_fail, test_bounds, test_named,
                     test_far_balls, test_owed, test_skip, test_between, test_rooms);
}
