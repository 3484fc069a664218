/* Object order: every pixel of a mesh exactly once, the same triangle as its ray, near planes and
 * mirrors, depths, shadows; and what first.h gets wrong of it. */
#include "check.h"
#include "../common/random.h"
#include "../chapters/07_mesh/scenes/specimens.h"
#include "../chapters/08_object_order/lab/orders_measure.h"
#include "../chapters/08_object_order/mirror_camera.h"

static camera front(int nx, int ny)  /* window: a unit a pixel at distance 1 */
{
    return (camera){CAMERA_PERSPECTIVE, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0, (real)nx, 0,
                    (real)ny, 1, {0, 0, 0}};
}

/* ---------------------------------------------------------------------------------------------- */

enum { side = 24, cells = 6 };

/* A sheet over the whole picture and beyond, its corners on middles and borders of pixels half of
 * the time; how often each pixel is covered, if every triangle has its own picture. */
static void cover(random_stream *g, int bits, size_t *twice, size_t *never)
{
    vec3 v[(cells + 1) * (cells + 1)];
    uint32_t index[6 * cells * cells];
    int at[side * side] = {0};
    camera c = front(side, side);
    raster_how how = raster_default;
    how.bits = bits;
    for (int k = 0; k < (cells + 1) * (cells + 1); k++) {
        real x = (real)(k % (cells + 1) * side) / cells, y = (real)(k / (cells + 1) * side) / cells;
        bool round = random_next(g) < (real)0.5;
        x += random_between(g, (real)-0.7, (real)0.7);  /* no cell of 4 pixels folds: */
        y += random_between(g, (real)-0.7, (real)0.7);  /* 2 * 0.7 < 4 - 2 * (0.7 + 1/2) */
        if (round) x = floor(2 * x) / 2, y = floor(2 * y) / 2;
        int i = k % (cells + 1), j = k / (cells + 1);
        x = i == 0 ? -1 : i == cells ? side + 1 : x, y = j == 0 ? -1 : j == cells ? side + 1 : y;
        real z = random_between(g, (real)0.5, 3);
        v[k] = (vec3){x * z, y * z, -z};
    }
    for (int k = 0; k < cells * cells; k++) {
        uint32_t a = (uint32_t)(k % cells + k / cells * (cells + 1)), b = a + 1,
                 d = a + cells + 1, e = d + 1;
        const uint32_t two[2][6] = {{a, b, e, a, e, d}, {a, b, d, e, b, d}};
        memcpy(index + 6 * k, two[random_next(g) < (real)0.5], sizeof two[0]);
    }
    for (int n = 0; n < 2 * cells * cells; n++) {
        mesh one = {.v = v, .vertices = 1, .index = index + 3 * n, .triangles = 1};
        raster s = raster_new(side, side);
        raster_mesh(&s, &one, c, how);
        for (int k = 0; k < side * side; k++) at[k] += s.h[k].shape == 0;
        raster_free(&s);
    }
    for (int k = 0; k < side * side; k++) *twice += at[k] > 1, *never += at[k] == 0;
}

/* first.h draws some twice: test_shared. */
static void test_cover(void)
{
    random_stream g = random_start(1, 0, 0);
    size_t twice = 0, never = 0, n = check_count(200);
    for (size_t i = 0; i < n; i++) cover(&g, i % 2 ? 8 : 16, &twice, &never);
    check_equal(twice, 0, "pixels that two triangles cover, of %zu sheets", n);
    check_equal(never, 0, "pixels that none covers, of %zu sheets", n);
}

/* ---------------------------------------------------------------------------------------------- */

/* Triangles anywhere round the eye, also behind it; half of them share corners. */
static mesh soup_around(random_stream *g, size_t n)
{
    mesh m = specimen_new(3 * n, n);
    for (size_t i = 0; i < 3 * n; i++) {
        bool far = random_next(g) < (real)0.3;
        real r = far ? 40 : 5, x = random_between(g, -r, r), y = random_between(g, -r, r);
        m.v[i] = (vec3){x, y, random_between(g, -r, r / 2)};
    }
    for (size_t i = 0; i < n; i++)
        specimen_add(&m, 3 * i, 3 * i + 1, i % 2 && i > 1 ? 3 * i - 3 : 3 * i + 2);
    return m;
}

/* Each pixel as its ray has it, or explained by the step; the order of drawing changes nothing. */
static void test_rays(void)
{
    random_stream g = random_start(2, 0, 0);
    enum { nx = 40, ny = 30 };
    size_t n = check_count(60), other = 0, unexplained = 0, judged = 0, moved = 0, behind = 0;
    camera c = orders_look((vec3){0, 0, 0}, (vec3){0, (real)0.1, -1}, 70, (real)nx / ny);
    double depth = 0;
    for (size_t i = 0; i < n; i++) {
        mesh m = soup_around(&g, 8);
        raster s = raster_new(nx, ny), due = raster_new(nx, ny), back = raster_new(nx, ny);
        raster_how how = raster_default;
        how.bits = 12;
        raster_mesh(&s, &m, c, how);
        raster_job j = raster_begin(&back, c, how);
        for (size_t k = m.triangles; k-- > 0;)
            raster_triangle(&j, mesh_triangle(&m, k), (uint32_t)k);
        (void)orders_rays(&due, &m, c, 1);
        orders_difference d = orders_compare(&s, &due, &m, c, how.bits);
        for (int k = 0; k < nx * ny; k++) {
            moved += s.h[k].shape != back.h[k].shape;
            if (due.h[k].shape == no_shape) continue;
            triangle t = mesh_triangle(&m, due.h[k].shape);
            behind += t.a.z > 0 || t.b.z > 0 || t.c.z > 0;
        }
        other += d.other, unexplained += d.unexplained, judged += d.judged;
        depth = check_worse(depth, d.depth);
        raster_free(&s), raster_free(&due), raster_free(&back), mesh_free(&m);
    }
    check_equal(unexplained, 0, "pixels unlike their ray, of %zu", judged);
    /* an edge passes within 2^-12 of one middle in 2^11, and a pixel has some ten edges round it */
    check_at_most((double)other, (double)judged / 200, "pixels that an edge explains");
    check_equal(moved, 0, "pixels that depend on the order of drawing");
    check_at_least((double)behind, (double)judged / 20, "triangles that reach behind are seen");
    /* corners move by 2^-13 pixels; slopes of depth of some hundred a pixel near grazing planes */
    check_at_most(depth, 0.01, "t, of planes at any angle");
}

/* Does r pass within 1 % of a weight from an edge of t? The volumes of (4.12). */
static bool near_edge(triangle t, ray r)
{
    real e[3] = {vdot(r.d, vcross(t.a, t.b)), vdot(r.d, vcross(t.b, t.c)),
                 vdot(r.d, vcross(t.c, t.a))};
    real least = (real)0.01 * fabs(e[0] + e[1] + e[2]);
    return fabs(e[0]) < least || fabs(e[1]) < least || fabs(e[2]) < least;
}

/* The near plane and the plane of one's own: what of a triangle lies before them is not drawn. The
 * ray asks each triangle, and drops hits at the wrong side; pixels where one is within 1 % of a
 * plane, or of an edge, are not judged. The eye is at the origin. */
static void test_planes(void)
{
    random_stream g = random_start(8, 0, 0);
    enum { nx = 40, ny = 30 };
    size_t n = check_count(60), wrong = 0, judged = 0, dropped[2] = {0, 0};
    double weights = 0;
    camera c = orders_look((vec3){0, 0, 0}, (vec3){0, (real)0.01, -1}, 70, (real)nx / ny);
    for (size_t i = 0; i < n; i++) {
        mesh m = soup_around(&g, 8);
        raster s = raster_new(nx, ny);
        vec3 side_of = vunit(random_in_cube(&g, 1));
        raster_how how = {16, 1, {{0, 0, -3}, side_of}};
        raster_mesh(&s, &m, c, how);
        for (int k = 0; k < nx * ny; k++) {
            ray r = camera_ray(c, (real)(k % nx) + (real)0.5, (real)(k / nx) + (real)0.5, nx, ny);
            hit best = hit_none, h, is = s.h[k];
            bool clear = true;
            for (size_t j = 0; j < m.triangles; j++) {
                triangle t = mesh_triangle(&m, j);
                clear = clear && !near_edge(t, r);
                if (!triangle_hit(t, r, &h)) continue;
                real above = vdot(vsub(ray_at(r, h.t), how.also.p), side_of);
                clear = clear && fabs(h.t - 1) > (real)0.01 && fabs(above) > (real)0.01;
                dropped[0] += h.t < 1, dropped[1] += above < 0;
                h.shape = (uint32_t)j;
                if (h.t > 1 && above > 0 && hit_before(h, best)) best = h;
            }
            if (!clear) continue;
            judged++, wrong += is.shape != best.shape;
            if (is.shape == best.shape && best.shape != no_shape)
                weights = check_worse(weights, fabs((double)(is.u - best.u))
                                                   + fabs((double)(is.v - best.v)));
        }
        raster_free(&s), mesh_free(&m);
    }
    check_equal(wrong, 0, "clipped pixels unlike their ray, of %zu", judged);
    check_at_least((double)judged, (double)(n * nx * ny) / 8, "most pixels are clear");
    check_at_least((double)(dropped[0] < dropped[1] ? dropped[0] : dropped[1]),
                   (double)(n * nx * ny) / 100, "both planes clip");
    /* corners move by 2^-17 pixels, and a hundredth of a weight is left at each edge */
    check_at_most(weights, 0.001, "u, v of clipped triangles");
}

/* ---------------------------------------------------------------------------------------------- */

static void test_clip(void)
{
    random_stream g = random_start(3, 0, 0);
    size_t n = check_count(20000), behind = 0, differ = 0, cut = 0;
    double off = 0;
    for (size_t i = 0; i < n; i++) {
        vec3 v[4];
        for (int k = 0; k < 4; k++)
            v[k] = random_in_cube(&g, 2);
        plane s = {v[3], vunit((vec3){random_between(&g, -1, 1), random_between(&g, -1, 1), 1})};
        raster_corner p[raster_most_corners] = {{v[0], 0, 0}, {v[1], 1, 0}, {v[2], 0, 1}};
        raster_corner q[raster_most_corners] = {{v[1], 1, 0}, {v[0], 0, 0}, {v[3], 0, 1}};
        int np = raster_clip(p, 3, s), nq = raster_clip(q, 3, s);
        for (int k = 0; k < np; k++) {
            behind += vdot(vsub(p[k].p, s.p), s.n) < -32 * real_epsilon;
            vec3 mix = barycentric_mix(v[0], v[1], v[2], p[k].u, p[k].v);
            off = check_worse(off, (double)vlength(vsub(mix, p[k].p)));
        }
        real h = vdot(vsub(v[0], s.p), s.n), k0 = vdot(vsub(v[1], s.p), s.n);
        if (h * k0 >= 0) continue;
        size_t same = 0;  /* the new corner of edge 0 1, seen by the neighbour */
        for (int a = 0; a < np; a++)
            for (int b = 0; b < nq; b++)
                same += vzero(vsub(p[a].p, q[b].p)) && p[a].u > 0 && p[a].u < 1 && p[a].v == 0;
        cut++, differ += same != 1;
    }
    check_equal(behind, 0, "corners behind the plane, of %zu triangles", n);
    check_equal(differ, 0, "neighbours that cut their edge elsewhere, of %zu", cut);
    check_at_most(off, 32 * (double)real_epsilon, "u, v of new corners");
    check_at_least((double)cut, 0.1 * (double)n, "edges are cut");
}

/* Corners before, in and behind the plane z = 0, all 27: one in the plane is no cut as well. */
static void test_clip_in_plane(void)
{
    size_t twice = 0;
    for (int i = 0; i < 27; i++) {
        raster_corner p[raster_most_corners] = {{{0, 0, (real)(i % 3 - 1)}, 0, 0},
            {{1, 0, (real)(i / 3 % 3 - 1)}, 1, 0}, {{0, 1, (real)(i / 9 - 1)}, 0, 1}};
        int n = raster_clip(p, 3, (plane){{0, 0, 0}, {0, 0, 1}});
        for (int a = 0; a < n; a++)
            for (int b = 0; b < a; b++) twice += vzero(vsub(p[a].p, p[b].p));
    }
    check_equal(twice, 0, "corners that are there twice");
}

/* Two walls across the view, at z and z + gap, the far one drawn first: in how many of 64 pixels is
 * the near one seen? */
static int seen_before(real z, real gap)
{
    const camera c = {CAMERA_PERSPECTIVE, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, -1, 1, -1, 1,
                      1, {0, 0, 0}};
    vec3 v[6];
    uint32_t index[6] = {0, 1, 2, 3, 4, 5};
    for (int k = 0; k < 6; k++) {
        real s = k < 3 ? z + gap : z;
        v[k] = vscale((vec3[3]){{-4, -2, -1}, {4, -2, -1}, {0, 4, -1}}[k % 3], s);
    }
    const mesh m = {.v = v, .vertices = 6, .index = index, .triangles = 2};
    raster s = raster_new(8, 8);
    int near_ones = 0;
    raster_mesh(&s, &m, c, (raster_how){8, (real)0.01, {{0, 0, 0}, {0, 0, 0}}});
    for (int k = 0; k < 64; k++) near_ones += s.h[k].shape == 1;
    raster_free(&s);
    return near_ones;
}

/* The least gap that the raster tells at z, as a share of z, by halving. */
static double gap_told(double z)
{
    double lost = 0, told = 0.01;
    for (int k = 0; k < 40; k++) {
        double middle = (lost + told) / 2;
        *(seen_before((real)z, (real)(z * middle)) == 64 ? &told : &lost) = middle;
    }
    return told;
}

/* Floats hold near / z, near = 0.01, to an epsilon of themselves; as was usual, 1 - near / z: (8.5)
 * with dx from one float to the next. */
static void test_depths(void)
{
    for (double far = 0.1; far < 2e4; far *= 10)
        check_at_most(gap_told(far), 1.2e-7 + 16 * (double)real_epsilon,
                      "walls at %g: told from an epsilon of float on", far);
    check_equal(seen_before(2, 0), 0, "of two in one place the first one stays");
    float usual = (float)(1 - 0.01 / 1e3);
    check_close(1e3 / 0.01 * (double)(nextafterf(usual, 2) - usual), 0.006, 1e-4,
                "at 1e5 near: a gap of 0.6 %% of z");
}

/* ---------------------------------------------------------------------------------------------- */

/* A square of side 1 at height 1 under a lamp at height 3 darkens a square of side 3/2 below. */
static void test_shadow(void)
{
    vec3 v[8] = {{-0.5, -0.5, 1}, {0.5, -0.5, 1}, {0.5, 0.5, 1}, {-0.5, 0.5, 1},
                 {-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}};
    uint32_t index[12] = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    mesh m = {.v = v, .vertices = 8, .index = index, .triangles = 4};
    real half = tan(pi / 6);  /* looks down, 60 degrees wide */
    camera lamp = {CAMERA_PERSPECTIVE, {0, 0, 3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, -half, half,
                   -half, half, 1, {0, 0, 0}};
    shadow_map s = shadow_map_new(&m, lamp, 256, raster_default);
    random_stream g = random_start(5, 0, 0);
    size_t n = check_count(20000), wrong = 0, dark = 0;
    /* a texel is 3 tan(30 degrees) 2 / 256 = 0.0135 wide on the floor */
    for (size_t i = 0; i < n; i++) {
        real x = random_between(&g, -2, 2), y = random_between(&g, -2, 2);
        real r = real_max(fabs(x), fabs(y));
        if (fabs(r - (real)0.75) < (real)0.0136) continue;
        bool is = shadow_map_dark(&s, (vec3){x, y, 0}, (real)0.01);
        wrong += is != (r < (real)0.75), dark += is;
    }
    check_equal(wrong, 0, "points in the wrong light, of %zu", n);
    check_at_least((double)dark, 0.1 * (double)n, "the test sees shadow");
    check(!shadow_map_dark(&s, (vec3){0, 0, 4}, 0) && !shadow_map_dark(&s, (vec3){9, 0, 0}, 0),
          "behind the lamp and beside its picture: lit");
    shadow_map_free(&s);
}

/* What the image of the camera sees of x, the camera sees of the image of x. */
static void test_mirror(void)
{
    random_stream g = random_start(6, 0, 0);
    size_t n = check_count(10000), seen = 0, lost = 0;
    double off = 0, turned = 0;
    for (size_t i = 0; i < n; i++) {
        vec3 p[4];
        for (int k = 0; k < 4; k++)
            p[k] = random_in_cube(&g, 3);
        plane s = {p[0], vadd(p[1], (vec3){4, 0, 0})};
        camera c = orders_look(p[2], vadd(p[2], (vec3){1, random_between(&g, -1, 1), 0}), 60, 1);
        camera c2 = mirror_camera(c, s);
        real x = 0, y = 0, x2 = 0, y2 = 0;
        bool a = camera_project(c, mirror_point(p[3], s), 1, 1, &x, &y);
        bool b = camera_project(c2, p[3], 1, 1, &x2, &y2);
        turned = check_worse(turned, fabs((double)vdot(vcross(c2.u, c2.v), c2.w) + 1));
        real depth = vdot(vsub(mirror_point(p[3], s), c.e), vneg(c.w));
        if (fabs(depth) < (real)0.1) continue;
        lost += a != b;
        if (a) off = check_worse(off, hypot((double)(x - x2), (double)(y - y2))), seen++;
    }
    check_equal(lost, 0, "in front for one camera only");
    check_at_most(off, 4e4 * (double)real_epsilon, "places, at depths from 0.1 to 20");
    check_at_most(turned, 100 * (double)real_epsilon, "the frame is mirrored: u x v . w + 1");
    check_at_least((double)seen, 0.2 * (double)n, "the test sees points");
}

/* ---------------------------------------------------------------------------------------------- */

/* What is not finite or has no area is not drawn, at any size no harm is done. */
static void test_strange(void)
{
    random_stream g = random_start(7, 0, 0);
    const real strange[] = {(real)NAN, real_infinity, -real_infinity, real_largest, -real_largest,
                            real_smallest, 0, (real)1e30, (real)-1e30, (real)1e9};
    size_t n = check_count(20000), bad = 0, drawn = 0;
    camera c = orders_look((vec3){0, 0, 0}, (vec3){(real)0.2, (real)0.1, -1}, 60, 1);
    raster s = raster_new(8, 8);
    for (size_t i = 0; i < n; i++) {
        vec3 v[3];
        uint32_t index[3] = {0, 1, 2};
        bool finite = true;
        for (int k = 0; k < 3; k++)
            v[k] = vadd(random_in_cube(&g, 2), vec(0, 0, -1));
        for (int k = 0; k < 2; k++) {
            real x = strange[random_next_bits(&g) % 10];
            int axis = (int)(random_next_bits(&g) % 3);
            v[random_next_bits(&g) % 3] = vwith(v[0], axis, x);
        }
        for (int k = 0; k < 3; k++) finite = finite && vfinite(v[k]);
        mesh m = {.v = v, .vertices = 3, .index = index, .triangles = 1};
        for (int k = 0; k < 64; k++) s.h[k] = hit_none, s.depth[k] = -1;
        raster_mesh(&s, &m, c, raster_default);
        for (int k = 0; k < 64; k++) {
            if (s.h[k].shape == no_shape) continue;
            drawn++, bad += !finite || !(s.h[k].t > 0) || !isfinite(s.h[k].u + s.h[k].v);
        }
    }
    check_equal(bad, 0, "hits that are not finite, of %zu", drawn);
    check_at_least((double)drawn, (double)n, "the test sees pixels");
    vec3 line[3] = {{-1, -1, -2}, {0, 0, -2}, {1, 1, -2}};
    uint32_t index[3] = {0, 1, 2};
    mesh m = {.v = line, .vertices = 3, .index = index, .triangles = 1};
    s.covered = 0;
    raster_mesh(&s, &m, c, raster_default);
    m.triangles = 0;
    raster_mesh(&s, &m, c, raster_default);
    check_equal(s.covered, 0, "no area, no triangles: nothing is covered");
    raster_free(&s), raster_free(&s);
}

/* A corner is projected up to raster_reach steps off the picture's upper left, on each side, and
 * not beyond, nor from behind the eye. At depth 1 a pixel is one unit of 256 steps. */
static void test_reach(void)
{
    raster s = raster_new(side, side);
    raster_job j = raster_begin(&s, front(side, side), raster_default);
    raster_point q;
    for (int k = 0; k < 4; k++) {
        real most = (real)(raster_reach / 256) * (real)(k % 2 ? 1 : -1);
        for (int beyond = 0; beyond < 2; beyond++) {
            real x = most * (real)(1 + beyond), y = side - x;
            raster_corner c = {{k < 2 ? x : 5, k < 2 ? 5 : y, -1}, 0, 0};
            check(raster_project(&j, c, &q) == !beyond, "%g, %g", (double)c.p.x, (double)c.p.y);
        }
        check_equal(k < 2 ? q.x : q.y, k % 2 ? raster_reach : -raster_reach, "steps");
    }
    check(!raster_project(&j, (raster_corner){{5, 5, 1}, 0, 0}, &q), "behind the eye");
    raster_free(&s);
}

/* The rectangle of a triangle: middles of pixels from 2 to 10, and 4 to 21 down from the top. */
static void test_asked(void)
{
    vec3 v[3] = {{2, 3, -1}, {10, 5, -1}, {4, side - 4, -1}};
    uint32_t index[3] = {0, 1, 2};
    mesh m = {.v = v, .vertices = 3, .index = index, .triangles = 1};
    raster s = raster_new(side, side);
    for (int k = 1; k <= 2; k++) {
        raster_mesh(&s, &m, front(side, side), raster_default);
        check_equal(s.asked, (size_t)k * (10 - 2) * (side - 3 - 4), "pixels asked, of %d", k);
    }
    raster_free(&s);
}

/* ---- first.h: right where a triangle is parallel to the picture and away from its edges; wrong in
 * depth and weights of a slanted one, at shared edges, behind the eye ---- */

enum { few = 16 };
static const double eps = (double)real_epsilon;

static first_camera first_front(void)
{
    return (first_camera){{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0, few, 0, few, 1, few, few};
}

static first_raster first_alone(triangle t)
{
    first_camera c = first_front();
    first_raster s = first_raster_new(few, few);
    first_raster_triangle(&s, first_project(c, t.a), first_project(c, t.b),
                          first_project(c, t.c), 0);
    return s;
}

/* Two triangles at depths of their own: each pixel as the rays of 04's first.h have it, but where
 * one passes within 1 % of an edge. */
static void test_parallel(void)
{
    random_stream g = random_start(1, 0, 0);
    size_t n = check_count(2000), wrong = 0, judged = 0, hits = 0;
    double off = 0;
    for (size_t i = 0; i < n; i++) {
        triangle tri[2];
        for (int k = 0; k < 2; k++) {
            real z = random_between(&g, 1, 9);
            vec3 *corner[3] = {&tri[k].a, &tri[k].b, &tri[k].c};
            for (int j = 0; j < 3; j++)
                *corner[j] = (vec3){z * few * random_next(&g), z * few * random_next(&g), -z};
        }
        first_mesh m = {tri, 2};
        first_raster s = first_raster_new(few, few);
        first_camera c = first_front();
        first_raster_mesh(&s, &m, c);
        for (int k = 0; k < few * few; k++) {
            ray r = first_camera_ray(c, (real)(k % few) + (real)0.5, (real)(k / few) + (real)0.5);
            hit due = {real_infinity, 0, 0, UINT32_MAX}, is = s.h[k];
            if (near_edge(tri[0], r) || near_edge(tri[1], r)) continue;
            (void)first_mesh_hit(&m, r, &due);
            judged++, hits += due.shape != UINT32_MAX, wrong += is.shape != due.shape;
            if (is.shape != due.shape || due.shape == UINT32_MAX) continue;
            double weights = fabs((double)(is.u - due.u)) + fabs((double)(is.v - due.v));
            off = check_worse(off, fabs((double)(is.t / due.t) - 1) + weights);
        }
        first_raster_free(&s);
    }
    check_equal(wrong, 0, "pixels unlike their ray, of %zu", judged);
    check_at_least((double)hits, 0.1 * (double)judged, "the test sees triangles");
    check_at_most(off, 2000 * eps, "t, u, v of triangles parallel to the picture");
}

/* From depth 1 to 9: in the middle of the picture of edge a b lies the point that is a tenth of the
 * way, for the near half fills nine tenths of the length. By (8.4): u = (1/9) / (1 + 1/9) = 1/10,
 * z = 1.8; first.h says 1/2 and 5. */
static void test_slanted(void)
{
    triangle t = {{2, 8.5, -1}, {9 * 15, 9 * 8.5, -9}, {2, 0.5, -1}};
    first_raster s = first_alone(t);
    hit h = s.h[7 * few + 8];  /* middle (8.5, 7.5): y upwards from 0 to 16: the line y = 8.5 */
    uint32_t index[3] = {0, 1, 2};
    mesh m = {.v = &t.a, .vertices = 3, .index = index, .triangles = 1};
    camera c = front(few, few);
    hit due = hit_none;
    for (uint32_t k = 3; k-- > 0;) {  /* each corner first: every weight gets its tie back */
        raster full = raster_new(few, few);
        for (uint32_t i = 0; i < 3; i++) index[i] = (k + i) % 3;
        raster_mesh(&full, &m, c, raster_default);
        due = full.h[7 * few + 8];
        real weight[3] = {1 - due.u - due.v, due.u, due.v};
        check_close((double)weight[(4 - k) % 3], 0.1, 32 * eps, "the weight of b, %u first", k);
        raster_free(&full);
    }
    camera twice = {c.kind, c.e, c.u, c.v, c.w, 0, 2 * few, 0, 2 * few, 2, c.direction};
    raster same = raster_new(few, few);  /* the picture twice as far away and as large: t halves */
    raster_mesh(&same, &m, twice, raster_default);
    check_close((double)same.h[7 * few + 8].t, 0.9, 32 * eps, "raster.h: in lengths of d");
    raster_free(&same);
    check_close((double)h.u, 0.5, 32 * eps, "first.h: half the way in the picture");
    check_close((double)h.t, 5, 200 * eps, "first.h: half the depth");
    check_close((double)due.u, 0.1, 4 * eps, "raster.h: a tenth of the way in space");
    check_close((double)due.t, 1.8, 64 * eps, "raster.h: the depth");
    first_raster_free(&s);
}

/* Two triangles with the edge along middles of pixels: first.h draws these twice. */
static void test_shared(void)
{
    long before = first_covered;
    first_raster a = first_alone((triangle){{0, 0, -1}, {few, 0, -1}, {0, few, -1}});
    first_raster b = first_alone((triangle){{few, 0, -1}, {few, few, -1}, {0, few, -1}});
    check_equal(first_covered - before, few * few + few, "16 pixels of 256 are drawn twice");
    first_raster_free(&a), first_raster_free(&b);
}

static void test_behind(void)
{
    triangle t = {{0, 0, -1}, {16, 0, -1}, {8, 16, 1}};
    long before = first_covered;
    first_raster s = first_alone(t);
    check_equal(first_covered, before, "a corner behind the eye: left out");
    first_raster_free(&s);
    triangle one = {{0, 0, -1}, {16, 0, -1}, {0, 16, -1}}, same[2] = {one, one};
    first_mesh twice = {same, 2};
    s = first_raster_new(few, few);
    first_raster_mesh(&s, &twice, first_front());
    check_equal(s.h[15 * few].shape, 0, "of two at the same depth the first one stays");
    first_raster_free(&s), before = first_covered;
    triangle bad = {{0, 0, -1}, {(real)NAN, 0, -1}, {8, 16, -1}};
    s = first_alone(bad);
    check_equal(first_covered, before, "NaN: nothing covered");
    first_raster_free(&s), first_raster_free(&s);
}

int main(void)
{
    return check_all("08_object_order", test_cover, test_rays, test_planes, test_clip,
                     test_clip_in_plane, test_depths, test_shadow, test_mirror, test_strange,
                     test_reach, test_asked, test_parallel, test_slanted, test_shared,
                     test_behind);
}
