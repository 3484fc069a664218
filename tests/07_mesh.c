/* 07_mesh: shapes behind one tag, the closest hit by brute force, and point in mesh by parity, vote
 * and winding number, aimed at vertices and edges. */
#include "check.h"
#include "child.h"
#include "../chapters/07_mesh/lab/pictures.h"
#include "07_trials.h"

static random_stream numbers;

/* corners: [4] for a polygon, which keeps pointing there */
static shape some_shape(int kind, vec3 *corners)
{
    vec3 a = random_in_cube(&numbers, 2), b = random_in_cube(&numbers, 1);
    vec3 c = random_in_cube(&numbers, 1);
    switch ((shape_kind)kind) {
    case SHAPE_SPHERE: return shape_of_sphere((sphere){a, random_between(&numbers, 0.1, 0.5)});
    case SHAPE_TRIANGLE: return shape_of_triangle((triangle){a, vadd(a, b), vadd(a, c)});
    case SHAPE_CONE:
        return shape_of_cone((cone){a, random_between(&numbers, 0, 0.5), vadd(a, b),
                                    random_between(&numbers, 0, 0.5)});
    case SHAPE_POLYGON: case SHAPE_OTHER: break;
    }
    corners[0] = a, corners[1] = vadd(a, b), corners[2] = vadd(vadd(a, b), c),
    corners[3] = vadd(a, c);
    return shape_of_polygon(polygon_of(corners, 4));
}

enum { shape_count = 60 };
static vec3 corners[shape_count][4];
static shape shapes[shape_count];

/* Asks each shape on its own, from the last to the first, with the interval as it was: a search
 * that shares neither the order nor the narrowing with scene_hit. */
static hit reference(const shape *s, size_t n, ray r)
{
    hit best = hit_none, h;
    for (size_t i = n; i-- > 0;)
        if (shape_hit(s[i], r, &h) && h.t <= best.t) {
            best = h;
            best.shape = (uint32_t)i;
        }
    return best;
}

/* True if two rays close by hit the same shape in a small triangle at right angles to n, or miss
 * it. */
static bool is_normal(shape x, ray r, real t, vec3 n)
{
    vec3 s, q, p = ray_at(r, t);
    hit a, b;
    vbasis(vunit(r.d), &s, &q);
    real step = vlength(r.d) / 1024;
    ray ra = ray_from(r.o, vmadd(r.d, s, step)), rb = ray_from(r.o, vmadd(r.d, q, step));
    ra.tmin = rb.tmin = r.tmin;
    if (!shape_hit(x, ra, &a) || !shape_hit(x, rb, &b)) return true;
    vec3 m = vunit(vcross(vsub(ray_at(ra, a.t), p), vsub(ray_at(rb, b.t), p)));
    return fabs(vdot(m, n)) > (real)0.95;
}

static void closest_of_many(void)
{
    size_t differ = 0, occlusion = 0, out_of_bounds = 0, normals = 0, bent = 0, all = 0,
           hits[4] = {0, 0, 0, 0}, n = check_sample(20000, 2500);
    numbers = random_start(31, 0, 0);
    for (int i = 0; i < shape_count; i++) shapes[i] = some_shape(i % 4, corners[i]);
    scene s = {shapes, shape_count};
    for (size_t i = 0; i < n; i++) {
        vec3 d = random_in_cube(&numbers, 1);
        ray r = ray_from(random_in_cube(&numbers, 4), d);
        r.tmin = random_between(&numbers, 0, 2);
        r.tmax = i % 3 ? real_infinity : random_between(&numbers, 0, 8);
        hit h = hit_none, best = reference(shapes, shape_count, r);
        bool is = scene_hit(&s, r, &h);
        differ +=
            is != (best.shape != no_shape) || (is && !(h.t == best.t && h.shape == best.shape));
        occlusion += scene_occluded(&s, r) != is;
        if (!is) continue;
        all++;
        const shape *x = &shapes[h.shape];
        vec3 lo, hi, p = ray_at(r, h.t), up = shape_normal(*x, h, p);
        shape_bounds(*x, &lo, &hi);
        real room =
            64 * real_epsilon; /* p itself is rounded: coordinates up to 8, t |D| up to 14 */
        for (int k = 0; k < 3; k++)
            out_of_bounds +=
                !(vaxis(p, k) >= vaxis(lo, k) - room && vaxis(p, k) <= vaxis(hi, k) + room);
        normals += !(fabs(vlength(up) - 1) <= 4 * real_epsilon);
        hits[x->kind]++;
        bent += !is_normal(*x, r, h.t, up);
    }
    check_equal(differ, 0, "closest hits that differ from a search in another order");
    check_equal(occlusion, 0, "occluded means: there is a closest hit");
    check_equal(out_of_bounds, 0, "hits outside the bounds of their shape");
    check_equal(normals, 0, "normals that are not unit");
    check_at_most(bent, all / 50,
                  "normals that no small triangle of hits confirms: rims, tips only");
    /* triangles, the smallest, by 0.8 to 1.5 % of the rays, scene by scene */
    for (int k = 0; k < 4; k++) check_at_least(hits[k], n / 400, "kind %d is hit", k);
}

/* How far the ends of a cone stick out of its bounds along an axis, below and above, in epsilon of
 * the largest coordinate there; the ends to all digits: a.x + ra sqrt(wy^2 + wz^2) / |w|. */
static void sticks_out(cone c, int axis, double out[2])
{
    vec3 lo, hi;
    shape_bounds(shape_of_cone(c), &lo, &hi);
    wide3 w = wide3_sub(wide3_of(c.b), wide3_of(c.a));
    const wide along[3] = {w.x, w.y, w.z}, p = along[(axis + 1) % 3], q = along[(axis + 2) % 3];
    wide across = wide_sqrt(wide_add(wide_mul(p, p), wide_mul(q, q)));
    wide k = wide_div(across, wide3_length(w));
    double low = (double)vaxis(lo, axis), high = (double)vaxis(hi, axis);
    out[0] = out[1] = -HUGE_VAL;
    for (int end = 0; end < 2; end++) {
        wide at = wide_of((double)vaxis(end ? c.b : c.a, axis));
        wide r = wide_mul(k, wide_of(fabs((double)(end ? c.rb : c.ra))));
        out[0] = fmax(out[0], wide_value(wide_sub(wide_of(low), wide_sub(at, r))));
        out[1] = fmax(out[1], wide_value(wide_sub(wide_add(at, r), wide_of(high))));
    }
    for (int i = 0; i < 2; i++) out[i] /= (double)real_epsilon * fmax(fabs(low), fabs(high));
}

/* Nothing sticks out of the bounds, and they are tight: 8 epsilon wider than the ends. And from
 * there it is climbed, a few last digits or a tenth at a time, to the cone whose bounds are the
 * tightest. Of the 8 epsilon 2.4 are met: with a quarter, it sticks out. */
static void bounds(void)
{
    double most = -HUGE_VAL, least = HUGE_VAL, out[2];
    for (uint64_t i = 0; i < 42; i++) {
        random_stream s = random_start(40, i, 0);
        cone c = {random_in_cube(&s, 1), random_next(&s), random_in_cube(&s, 1), random_next(&s)};
        double at = -HUGE_VAL;
        for (int k = 0; k < 4000; k++) {
            cone next = c;
            real *part[8] = {&next.a.x, &next.a.y, &next.a.z, &next.ra,
                             &next.b.x, &next.b.y, &next.b.z, &next.rb};
            for (int n = k ? (int)random_between(&s, 1, 4) : 0; n > 0; n--)
                *part[(int)(8 * random_next(&s))] *=
                    1 + random_between(&s, -1, 1)
                            * pow((real)10, random_between(&s, real_is_float ? -7 : -16, -1));
            sticks_out(next, (int)(i % 3), out);
            least = fmin(least, fmin(out[0], out[1]));
            if (fmax(out[0], out[1]) >= at) at = fmax(out[0], out[1]), c = next;
        }
        most = check_worse(most, at);
    }
    check_at_most(most, 0, "the bounds of a cone, climbed to: it sticks out, in epsilon");
    check_at_least(least, -16, "bounds of a cone that are too wide, in epsilon");
    vec3 lo, hi, axis = {0, 0, 2}, o = {1, 2, 3};
    shape_bounds(shape_of_cone((cone){o, 1, vadd(o, axis), 0}), &lo, &hi);
    check_close(hi.z, 5, 64 * real_epsilon, "a disk at right angles to z is flat in z");
    shape_bounds(shape_of_sphere((sphere){o, -2}), &lo, &hi);
    check_close(lo.x, -1, 64 * real_epsilon,
                "a negative radius has the bounds of the positive one");
}

/* A shape of quarters, or of anything: cones that touch, lie along axes, are two tip to tip. */
static shape odd_shape(size_t i, vec3 far, vec3 *q)
{
    static const int comb[7][2] = {{0, 0}, {8, 0}, {8, 4}, {6, 1}, {4, 4}, {2, 1}, {0, 4}};
    real x[12];
    for (int k = 0; k < 12; k++) {
        x[k] = random_between(&numbers, -1, 1);
        if (i % 4) x[k] = round(4 * x[k]) / 4;
    }
    vec3 a = vadd(far, (vec3){2 * x[0], 2 * x[1], 2 * x[2]}), e = {x[3], x[4], x[5]},
         f = {x[6], x[7], x[8]};
    real rb = i % 5 == 0 ? x[9] : i % 5 == 1 ? 0 : i % 5 == 2 ? -x[9] : x[10];
    if (i % 3 == 0) return shape_of_sphere((sphere){a, fabs(x[9])});
    if (i % 3 == 1) return shape_of_cone((cone){a, fabs(x[9]), vadd(a, e), rb});
    for (int k = 0; k < 7; k++)
        q[k] = vadd(a, vadd(vscale(e, (real)comb[k][0] / 8), vscale(f, (real)comb[k][1] / 4)));
    return shape_of_polygon(polygon_of(q, 7));
}

/* Rays that touch a shape, or see it edge-on, but for a tilt of 1 to 1e-18. */
static ray odd_ray(shape x, const vec3 *q, size_t i)
{
    real tilt = pow((real)10, random_between(&numbers, real_is_float ? -9 : -18, 0));
    real u = random_next(&numbers);
    vec3 d = random_in_cube(&numbers, 1), n = direction(&numbers), s, t, at = {0, 0, 0};
    if (x.kind == SHAPE_SPHERE)
        vbasis(n, &s, &d), at = vmadd(x.sphere.c, n, x.sphere.r);
    if (x.kind == SHAPE_CONE) {
        at = point_of_side(x.cone, u, random_between(&numbers, -pi, pi), &s, &t);
        d = vmadd(s, vcross(s, t), i % 2 ? 0 : round(random_between(&numbers, -2, 2)));
    }
    if (x.kind == SHAPE_POLYGON) {
        vec3 e = vsub(q[1], q[0]), f = vsub(q[2], q[1]);
        d = vadd(vscale(e, d.x), vscale(f, d.y));
        at = vmadd(vmadd(q[0], e, u), f, random_next(&numbers));
    }
    d = vmadd(d, direction(&numbers), tilt);
    return ray_from(vmadd(at, d, -pow((real)10, random_between(&numbers, -3, i % 4 ? 1 : 6))), d);
}

/* What every structure of 09 to 17 trusts: a hit lies in the bounds of its shape, but for 256
 * epsilon D, D the way along an axis from o to the farthest side of the scene. A shape that reports
 * one elsewhere is asked by brute force, and not by a search that has left its cell behind. */
static void hits_are_within_bounds(void)
{
    double worst = 0;
    size_t hits = 0, n = check_sample(200000, 1000);
    numbers = random_start(34, 0, 0);
    for (size_t i = 0; i < n; i++) {
        vec3 q[7], lo, hi, far = {0, 0, 0};
        if (i % 7 == 0) far = vec(1248, 511.25, -895.75);
        shape x = odd_shape(i, far, q);
        ray r = odd_ray(x, q, i);
        if (i % 2) r.d = vec(round(4 * r.d.x) / 4, round(4 * r.d.y) / 4, round(4 * r.d.z) / 4);
        hit h;
        if (!shape_hit(x, r, &h)) continue;
        hits++;
        shape_bounds(x, &lo, &hi);
        vec3 a = vsub(r.o, lo), b = vsub(hi, r.o);
        a = vmax(vmax(a, vneg(a)), vmax(b, vneg(b)));
        wide3 p = wide3_madd(wide3_of(r.o), wide3_of(r.d), wide_of((double)h.t));
        const wide at[3] = {p.x, p.y, p.z};
        for (int k = 0; k < 3; k++) {
            double off = fmax(wide_value(wide_sub(wide_of((double)vaxis(lo, k)), at[k])),
                              wide_value(wide_sub(at[k], wide_of((double)vaxis(hi, k)))));
            worst = check_worse(worst, off / (double)(real_epsilon * vaxis(a, vlongest(a))));
        }
    }
    check_at_most(worst, 256, "hits off the bounds, in epsilon D, of %zu", hits);
    check_at_least((double)hits, (double)n / 8, "some are hit");
}

/* A plane of exact coordinates, once as each kind that can: all hits have the very same t, so the
 * lowest index wins, in any order. */
static void ties(void)
{
    static vec3 square[4] = {{-4, -4, 1}, {4, -4, 1}, {4, 4, 1}, {-4, 4, 1}};
    shape s[4] = {shape_of_polygon(polygon_of(square, 4)),
                  shape_of_triangle((triangle){square[0], square[1], square[2]}),
                  shape_of_sphere((sphere){{1, 0, 2}, 1}),
                  shape_of_cone((cone){{1, -2, 2}, 1, {1, 2, 2}, 1})};
    ray r = ray_from((vec3){1, 0, -1}, vec(0, 0, 0.5));
    for (int shift = 0; shift < 4; shift++) {
        shape order[4];
        hit h = hit_none;
        for (int i = 0; i < 4; i++) order[i] = s[(i + shift) % 4];
        scene all = {order, 4};
        check(scene_hit(&all, r, &h) && h.t == 4 && h.shape == 0, "order %d: t %g, shape %u",
              shift, (double)h.t, h.shape);
    }
    scene one = {s, 1}, empty = {NULL, 0};
    hit h = {7, 8, 9, 10};
    r.tmax = 3.5;
    check(!scene_hit(&one, r, &h) && !scene_occluded(&one, r) && h.t == 7 && h.shape == 10,
          "a miss leaves the hit alone");
    check(!scene_hit(&empty, r, &h) && !scene_occluded(&empty, r) && h.shape == 10,
          "an empty scene is never hit");
}

static void meshes(void)
{
    mesh m = octahedron_mesh(8);
    size_t differ = 0, missed = 0, off = 0;
    numbers = random_start(33, 0, 0);
    for (size_t i = 0; i < check_count(3000); i++) {
        vec3 o = random_in_cube(&numbers, i % 4 < 2 ? 2 : 1 / (real)3),
             d = i % 2 ? random_in_cube(&numbers, 1)
                       : vsub(m.v[(size_t)random_between(&numbers, 0, (real)m.vertices - 1)], o);
        ray r = ray_from(o, d);
        hit h = hit_none, best = hit_none, g;
        bool is = mesh_hit(&m, r, &h);
        for (size_t k = m.triangles; k-- > 0;)
            if (triangle_hit(mesh_triangle(&m, k), r, &g) && g.t <= best.t)
                g.shape = (uint32_t)k, best = g;
        differ +=
            is != (best.shape != no_shape) || mesh_occluded(&m, r) != is
            || (is
                && !(h.t == best.t && h.shape == best.shape && h.u == best.u && h.v == best.v));
        real far = fabs(o.x) + fabs(o.y) + fabs(o.z);
        missed += !is && far < 1;
        if (!is) continue;
        vec3 p = ray_at(r, h.t);
        off += !(fabs(fabs(p.x) + fabs(p.y) + fabs(p.z) - 1)
                 <= 64 * real_epsilon * (1 + h.t * vlength(r.d)));
    }
    check_equal(differ, 0, "mesh_hit against single triangles in another order");
    check_equal(missed, 0, "rays from inside, to vertices and anywhere, always hit");
    check_equal(off, 0, "hits off |x| + |y| + |z| = 1");
    hit h;
    check(mesh_hit(&m, ray_from((vec3){0, 0, 2}, (vec3){0, 0, -1}), &h) && h.t == 1,
          "on to the top");
    check_equal(h.shape, 0, "where four triangles meet the lowest index wins");
    mesh_free(&m);
    check(!mesh_hit(&m, ray_from((vec3){0, 0, 2}, (vec3){0, 0, -1}), &h),
          "an empty mesh is never hit");
}

/* After Ctrl-C no more rays are cast: a single one may take a tenth of a second. Here there is
 * nothing to ask. */
static void ask_nobody(void *context)
{
    mesh_view w = {.width = 1};
    (void)context;
    atomic_store(&parallel_stop, SIGINT);
    (void)mesh_view_colour(&w, 0, 0);
}

static void stops_between_rays(void)
{
    child_result r = child_run(ask_nobody, NULL);
    check_equal(r.status, 0, "a pixel after Ctrl-C asks nobody");
}

static void solid_angles(void)
{
    vec3 x = {1, 0, 0}, y = {0, 2, 0}, z = {0, 0, 3};
    double eps = (double)real_epsilon, octant = 3.14159265358979323846 / 2;
    check_close(solid_angle(x, y, z), octant, 4 * eps,
                "an octant is an eighth of 4 pi, whatever the lengths");
    check_close(solid_angle(y, x, z), -octant, 4 * eps, "the other way round: negative");
    check_equal(solid_angle(x, y, vadd(x, y)), 0, "edge-on: nothing");
    check_close(solid_angle(vec(1, 0, 1e-3), vec(-0.5, 0.75, 1e-3),
                            vec(-0.5, -0.75, 1e-3)),
                4 * octant, 0.02,
                "just below a triangle it is nearly half of the sphere, not nearly 0");
    check_equal(solid_angle((vec3){0, 0, 0}, y, z), 0, "a corner at p");
    /* A square of side 2 at distance 1 is one face of a cube: 4 pi / 6. */
    vec3 a = {-1, -1, 1}, b = {1, -1, 1}, c = {1, 1, 1}, d = {-1, 1, 1};
    check_close(solid_angle(a, b, c) + solid_angle(a, c, d), 4 * octant / 3, 8 * eps,
                "a face of a cube");
    mesh m = torus_mesh(40);
    /* 3200 triangles, each some epsilon / 2: chance adds these up like the steps of a walk */
    double off = sqrt(3200) * eps;
    check_close(winding_number(&m, vec(0.7, 0.2, 0.1)), 1, off, "in the ring: 1");
    check_close(winding_number(&m, vec(0.05, -0.03, 0.01)), 0, off, "in its hole: 0");
    check_close(winding_number(&m, vec(100, 30, -20)), 0, off, "far away: 0");
    mesh_free(&m);
}

/* k octahedra one in the other, all outwards or all inwards, and a point within: the product of
 * winding_number goes round k times. Beside that k: all solid angles, one by one. */
static void winding_turns(void)
{
    double eps = (double)real_epsilon;
    for (int k = 1; k <= 5; k += 2)
        for (int turned = 0; turned < 2; turned++) {
            mesh one = octahedron_mesh(3);
            mesh m = specimen_new((size_t)k * one.vertices, (size_t)k * one.triangles);
            for (size_t i = 0; i < m.vertices; i++)
                m.v[i] = vscale(one.v[i % one.vertices], (real)(1 + i / one.vertices));
            for (int shell = 0; shell < k; shell++)
                for (size_t i = 0; i < one.triangles; i++) {
                    const uint32_t *c = one.index + 3 * i;
                    size_t at = (size_t)shell * one.vertices;
                    specimen_add(&m, at + c[0], at + c[turned ? 2 : 1], at + c[turned ? 1 : 2]);
                }
            random_stream g = random_start(717, (uint64_t)k, 0);
            for (int n = 0; n < 40; n++) {
                vec3 p = vec(random_between(&g, -0.5, 0.5), random_between(&g, -0.25, 0.25),
                             random_between(&g, -0.2, 0.2));
                double sum = 0;
                for (size_t i = 0; i < m.triangles; i++) {
                    triangle t = mesh_triangle(&m, i);
                    sum += solid_angle(vsub(t.a, p), vsub(t.b, p), vsub(t.c, p));
                }
                double w = winding_number(&m, p), bound = (double)m.triangles * eps;
                check_close(w, turned ? -k : k, bound, "%d surfaces", k);
                check_close(w, sum / (4 * 3.14159265358979323846), bound, "and angle by angle");
            }
            mesh_free(&one), mesh_free(&m);
        }
}

/* All points of the lattice, exactly, along the axes, where 4, 6 or 8 triangles meet in each
 * vertex. Inside is |x| + |y| + |z| < 1, in whole numbers. */
static void lattice(void)
{
    enum { n = 4 };
    mesh m = octahedron_mesh(n);
    inside_score w = {0, {0}};
    first_mesh soup = first_mesh_of(&m);
    for (int z = -n; z <= n; z++)
        for (int y = -n; y <= n; y++)
            for (int x = -n - 1; x <= n + 1; x++)
                for (int axis = 0; axis < 6; axis++) {
                    int far = abs(x) + abs(y) + abs(z);
                    if (far == n) continue;  /* on the surface */
                    vec3 p = {(real)x / n, (real)y / n, (real)z / n}, d = {0, 0, 0};
                    ((real *)&d)[axis / 2] = axis % 2 ? -1 : 1;
                    w.asked++;
                    for (int k = 0; k < inside_methods; k++)
                        w.wrong[k] += inside_ask(k, &m, &soup, p, d) != (far < n);
                }
    for (int k = inside_of_hits; k < inside_methods; k++)
        check_equal(w.wrong[k], 0, "%s: wrong of %zu lattice points", inside_names[k], w.asked);
    for (int k = 0; k < inside_of_hits; k++)
        check_at_least(w.wrong[k], w.asked / 20, "%s: wrong at 1 of 20 lattice points and more",
                       inside_names[k]);
    mesh_free(&m), first_mesh_free(&soup);
}

/* The aim of the votes is one that hurts: of the rays that a vote casts, the one through a vertex
 * alone is wrong as often as rays straight at a vertex are. */
static void votes_are_aimed(void)
{
    mesh m = torus_mesh(24);
    size_t n = check_sample(2000, 250), wrong = 0, alone = 0, hurt = 0;
    for (size_t i = 0; i < n; i++) {
        vec3 p, d;
        random_stream s = random_start(22, i, 0);
        bool inside = inside_question(&m, &s, AT_VERTEX, 3, &p, &d), own = false;
        for (int k = 0; k < 3; k++) own = own || vzero(vsub(inside_direction(k, 3), d));
        bool bad = inside_parity_naive(&m, p, d) != inside;
        hurt += bad, alone += bad && own;
        wrong += inside_vote(&m, p, 3) != inside;
    }
    check_equal(wrong, 0, "vote of 3, one of its rays through a vertex, of %zu", n);
    check_at_least(alone, n / 20, "that ray alone is wrong at 5 %% and more");
    check_equal(hurt, alone, "and it is one that the vote casts");
    mesh_free(&m);
}

/* Rays aimed at vertices and at points of edges of a torus, whose coordinates are not exact: what
 * counts hits is wrong as often as that, at least. first.h's test is not watertight: it is wrong at
 * edges, too. */
static void aimed(void)
{
    mesh m = torus_mesh(24);
    const char *name[] = {"random", "edge", "vertex"};
    const double least[][inside_of_hits] = {{0, 0}, {0.3, 0.01}, {0.3, 0.3}};
    for (inside_aim at = AT_RANDOM; at <= AT_VERTEX; at++) {
        random_stream s = random_start(21, (uint64_t)at, 0);
        inside_score w = inside_play(&m, &s, at, check_sample(3000, 375));
        for (int k = 0; k < inside_methods - (at != AT_RANDOM); k++)
            if (k < inside_of_hits && at != AT_RANDOM)
                check_at_least((double)w.wrong[k], least[at][k] * (double)w.asked,
                               "%s: %s is wrong that often, of %zu", name[at], inside_names[k],
                               w.asked);
            else check_equal(w.wrong[k], 0, "%s: %s, wrong of %zu", name[at], inside_names[k],
                             w.asked);
    }
    mesh_free(&m);
}

/* One triangle less: parity follows the ray through the hole, the winding number hardly changes. */
static void open_mesh(void)
{
    mesh m = octahedron_mesh(4);
    triangle hole = mesh_triangle(&m, m.triangles - 1);
    vec3 p = {0.03125, 0.015625, 0.0078125};
    vec3 through = vsub(vscale(vadd(vadd(hole.a, hole.b), hole.c), 1 / (real)3), p);
    check(inside_parity(&m, p, through) && inside_parity_naive(&m, p, through), "closed: inside");
    vec3 outside = vmadd(vscale(vadd(vadd(hole.a, hole.b), hole.c), 1 / (real)3),
                         inside_direction(4, 5), -2);
    check(!inside_vote(&m, outside, 5), "outside the closed mesh");
    m.triangles--;
    check(inside_parity_naive(&m, outside, inside_direction(4, 5)), "in by the hole: one hit");
    check(!inside_vote(&m, outside, 5), "one of five is outvoted");
    check(!inside_parity(&m, p, through) && !inside_parity_naive(&m, p, through),
          "parity through the hole: outside");
    check(inside_parity(&m, p, vneg(through)), "and inside by the other way");
    check(inside_winding(&m, p) && inside_vote(&m, p, 5), "winding number and vote: inside");
    check_close(winding_number(&m, p), 1 - 1.0 / 128, 0.01,
                "1 of 128 triangles: some 1/128 is missing");
    for (size_t i = 0; i < m.triangles; i++) {
        uint32_t *k = m.index + 3 * i, swap = k[0];
        k[0] = k[1], k[1] = swap;
    }
    check(inside_winding(&m, p), "all triangles turned over: still inside");
    m.triangles = 0;
    check(!inside_parity(&m, p, through) && !inside_winding(&m, p),
          "no triangles: nothing is inside");
    mesh_free(&m);
}

int main(void)
{
    return check_all("07_mesh", closest_of_many, bounds, hits_are_within_bounds,
                     ties, meshes, stops_between_rays, solid_angles, winding_turns, lattice, aimed,
                     votes_are_aimed, open_mesh);
}
