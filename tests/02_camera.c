/* Tests of 02_camera: frames, rays through pixels and back, vanishing points, RTR's frame. */
#include "check.h"
#include "../common/headlight.h"
#include "02_oracle.h"
#include "../chapters/02_camera/lab/rtr_camera.h"
#include "../common/random.h"

enum { nx = 640, ny = 480 };

#define eps ((double)real_epsilon)
static const vec3 axis_z = {0, 0, 1};
static random_stream s;

static real uniform(real a, real b) { return a + (b - a) * random_next(&s); }
static vec3 any_direction(void) { return random_unit(&s); }
static double distance(vec3 a, vec3 b) { return (double)vlength(vsub(a, b)); }
static double angle(vec3 a, vec3 b) { return distance(vunit(a), vunit(b)); }
static camera_frame any_frame(real far)
{
    camera_frame f;
    vec3 e = vscale(any_direction(), far), up, to;
    do up = any_direction(), to = vmadd(e, any_direction(), real_max(far, 1));
    while (!frame_look_at(e, to, up, &f, NULL));
    return f;
}
static camera_window any_window(void)
{
    real l = uniform(-2, 1), b = uniform(-2, 1);
    return (camera_window){l, l + uniform(0.5, 3), b, b + uniform(0.5, 3)};
}
static camera any_camera(int kind, real far)
{
    camera c;
    camera_frame f = any_frame(far);
    failure why = {0, ""};
    vec3 D = vadd(vneg(f.w), vadd(vscale(f.u, uniform(-1, 1)), vscale(f.v, uniform(-1, 1))));
    bool ok = kind == 0 ? camera_orthographic(f, any_window(), &c, &why)
            : kind == 1 ? camera_oblique(f, any_window(), D, &c, &why)
            : kind == 2 ? camera_perspective(f, uniform(10, 120), uniform(0.5, 2), &c, &why)
            : camera_off_axis(f, any_window(), uniform(0.3, 3), &c, &why);
    if (!ok) fail(why);
    return c;
}

/* A length-1, right-angled, right-handed frame. Each of w, u rounds its components and its length
 * (2 epsilon by vunit); a dot product adds 1.5 epsilon: 8 epsilon holds them all. */
static void check_frame(camera_frame f, const char *what)
{
    check_close(vlength(f.u), 1, 8 * eps, "%s: |u|", what);
    check_close(vlength(f.v), 1, 8 * eps, "%s: |v|", what);
    check_close(vlength(f.w), 1, 8 * eps, "%s: |w|", what);
    check_close(vdot(f.u, f.v), 0, 8 * eps, "%s: u.v", what);
    check_close(vdot(f.v, f.w), 0, 8 * eps, "%s: v.w", what);
    check_close(vdot(f.w, f.u), 0, 8 * eps, "%s: w.u", what);
    check_close(vdot(vcross(f.u, f.v), f.w), 1, 16 * eps, "%s: u x v = w, right-handed", what);
}

static void test_frames(void)
{
    camera_frame f;
    failure why;
    check(frame_look_at((vec3){0, -5, 0}, (vec3){0, 0, 0}, axis_z, &f, &why), "looking along +y");
    check(f.u.x == 1 && f.v.z == 1 && f.w.y == -1, "looking along +y with z up: right is +x");
    for (int k = 0; k < 1000; k++) {  /* their squares over- and underflow */
        real power = real_is_float ? 30 : 250, other = pow((real)10, uniform(-power, power));
        real size = k % 3 ? pow((real)10, uniform(-power, power)) : 1;
        vec3 target = vscale(any_direction(), size), up = vscale(any_direction(), other);
        vec3 e = vscale(any_direction(), 2 * size);
        check(frame_look_at(e, target, up, &f, &why), "any size of view is a view");
        check_frame(f, "any size");
        check_at_least(vdot(f.v, vunit(up)), 0, "v leans to the side of up");
        check_close(vdot(vunit(up), f.u), 0, 8 * eps, "u is at right angles to up");
    }
}

/* up at a small angle to the view: the input is rounded first, so it is exact for the oracle. The
 * robust u is off by the roundings of its cross product (2 epsilon), of `back` (1/2, seen under the
 * angle: none here, since e = 0) and of its length (2); the naive one by epsilon / angle. */
static void test_frames_near_parallel(void)
{
    real smallest = real_is_float ? (real)1e-5 : (real)1e-13;
    for (real small = 0.1; small > smallest; small /= 10) {
        double naive = 0, robust = 0, leans = 0;
        for (int k = 0; k < 500; k++) {
            vec3 view = vscale(any_direction(), uniform(1, 100)), s1, s2, e = {0, 0, 0};
            vbasis(vunit(view), &s1, &s2);
            vec3 up = vscale(vadd(vunit(view), vscale(s1, small)), uniform(0.1, 10));
            camera_frame f, g;
            failure why;
            if (!frame_look_at(e, view, up, &f, &why)) fail(why);
            g = frame_first(e, view, up);
            check_frame(f, "near parallel");
            robust = check_worse(robust, frame_error(f, view, up));
            naive = check_worse(naive, frame_error(g, view, up));
            leans = check_worse(leans, fabs((double)vdot(g.u, g.w)));
        }
        check_at_most(robust, 6 * eps, "frame_look_at at angle %g", (double)small);
        check_at_least(naive, 0.1 * eps / (double)small,
                       "first_camera_at must be seen to fail at %g", (double)small);
        check_at_least(leans, 0.1 * eps / (double)small, "the naive u leans towards w at angle %g",
                       (double)small);
    }
}

static void refused(bool ok, failure why, const char *needle, const char *what)
{
    check(!ok, "%s must be refused", what);
    check(!ok && why.exit_code == 2 && strstr(why.text, needle),
          "%s: message \"%s\" names \"%s\"", what, ok ? "" : why.text, needle);
}

static void test_refusals(void)
{
    camera_frame f = {{7, 7, 7}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    camera c;
    failure why = {0, ""};
    real nan_ = (real)NAN, big = real_largest, inf = real_infinity;
    vec3 o = {0, 0, 0}, p = {1, 2, 3};
    const struct { vec3 e, target, up; const char *needle; } look[] = {
        {p, p, axis_z, "equals the viewpoint"}, {o, p, o, "up (0, 0, 0):"}, {o, p, p, "parallel"},
        {o, p, vscale(p, -(real)1e10), "parallel"},
        {{0, 0, 2}, o, axis_z, "up (0, 0, 1) is parallel to the view (0, 0, -2)"},
        {{1, 2, 3}, o, {1, 2, 3}, "view (-1, -2, -3)"},
        {p, o, {nan_, 0, 1}, "up (nan"}, {{0, inf, 0}, o, axis_z, "viewpoint (0, inf"},
        {p, {0, 0, nan_}, axis_z, "target"}, {{big, 0, 0}, {-big, 0, 0}, axis_z, "overflows"},
        {o, {0, 0, -1}, {2 * real_epsilon, 0, 1}, "parallel"}};
    for (size_t i = 0; i < sizeof look / sizeof *look; i++)
        refused(frame_look_at(look[i].e, look[i].target, look[i].up, &f, &why), why,
                look[i].needle, look[i].needle);
    check(frame_look_at(o, (vec3){0, 0, -1}, (vec3){5 * real_epsilon, 0, 1}, &f, &why),
          "5 epsilon is an angle");
    check_frame(f, "5 epsilon");
    check_equal(f.v.x, 1, "5 epsilon: up leans to +x, looking down, so +x is up in the picture");
    f.e.x = 7;
    (void)frame_look_at(p, p, axis_z, &f, &why);
    check_equal(f.e.x, 7, "a refused look-at leaves *out untouched");
    check(vzero(frame_first(o, p, p).u), "first_camera_at, exactly parallel: no right");

    check(frame_look_at(p, o, axis_z, &f, &why), "a frame");
    camera_window w = {-1, 1, -1, 1};
    const real angles[] = {0, 180, -30, 360, nan_, inf}, none[] = {0, -1, nan_};
    for (size_t i = 0; i < sizeof angles / sizeof *angles; i++)
        refused(camera_perspective(f, angles[i], 1, &c, &why), why, "field of view", "an angle");
    for (int i = 0; i < 3; i++) {
        refused(camera_perspective(f, 60, none[i], &c, &why), why, "width / height", "an aspect");
        refused(camera_off_axis(f, w, none[i], &c, &why), why, "d = ", "a distance");
    }
    const struct { camera_window w; const char *needle, *what; } windows[] = {
        {{1, 1, -1, 1}, "left < right", "an empty window"},
        {{-1, 1, 1, 1}, "bottom < top", "a window without height"},
        {{-1, 1, 1, -1}, "bottom < top", "a window upside down"},
        {{-1, nan_, -1, 1}, "window", "a NaN window"},
        {{-big, big, -1, 1}, "window", "r - l overflows"}};
    for (size_t i = 0; i < sizeof windows / sizeof *windows; i++) {
        refused(camera_off_axis(f, windows[i].w, 1, &c, &why), why, windows[i].needle,
                windows[i].what);
        refused(camera_orthographic(f, windows[i].w, &c, &why), why, windows[i].needle,
                windows[i].what);
    }
    const struct { vec3 d; const char *what; } oblique[] = {
        {f.u, "along the image plane"}, {f.w, "backward"}, {o, "no direction"},
        {vmadd(f.u, f.w, -2 * real_epsilon), "2 epsilon forward"}, {{nan_, 0, 0}, "NaN"}};
    for (int i = 0; i < 5; i++)
        refused(camera_oblique(f, w, oblique[i].d, &c, &why), why, "forward", oblique[i].what);
    check(camera_perspective(f, 179.99, 1, &c, &why), "179.99 degrees is a field of view");
    check(camera_perspective(f, 1e-3, 1, &c, &why), "0.001 degrees is a field of view");
}

/* The window's corners and centre, on dyadic numbers, where nothing rounds. */
static void test_pixels_exactly(void)
{
    camera_frame f;
    camera c[4];  /* the last: a cabinet view, depth halved, at 45 degrees */
    failure why;
    const camera_window window = {-1, 3, -2, 2}, square = {-4, 4, -4, 4};
    const real k = (real)0.5 * sqrt((real)0.5);
    if (!frame_look_at((vec3){0, 0, 8}, (vec3){0, 0, 0}, (vec3){0, 1, 0}, &f, &why)
        || !camera_off_axis(f, window, 2, &c[0], &why)
        || !camera_orthographic(f, window, &c[1], &why)
        || !camera_perspective(f, 90, 2, &c[2], &why)
        || !camera_oblique(f, square, (vec3){-k, -k, -1}, &c[3], &why)) fail(why);
    const struct { int c; real x, y; vec3 o, d; const char *why; } in[] = {
        {0, 0, 0, {0, 0, 8}, {-1, 2, -2}, "(0, 0) is the corner (left, top)"},
        {0, 64, 64, {0, 0, 8}, {3, -2, -2}, "(nx, ny) is the corner (right, bottom)"},
        /* FCG: j counts upward: u = l + (r - l)(i + .5)/nx, v = b + (t - b)(j + .5)/ny */
        {0, 5.5, 64 - 7.5, {0, 0, 8}, {-1 + 4 * (real)5.5 / 64, -2 + 4 * (real)7.5 / 64, -2},
         "FCG's pixel (5, 7)"},
        {1, 16, 16, {0, 1, 8}, {0, 0, -1}, "orthographic: from the plane of e along -w"}};
    for (size_t i = 0; i < sizeof in / sizeof *in; i++) {
        ray r = camera_ray(c[in[i].c], in[i].x, in[i].y, 64, 64);
        check(vzero(vsub(r.o, in[i].o)) && vzero(vsub(r.d, in[i].d)) && r.tmin == 0
                  && r.tmax == real_infinity, "%s", in[i].why);
    }
    real x = 0, y = 0, x0 = 0, y0 = 0;
    const struct { int c; vec3 p; const char *why; } nowhere[] = {
        {1, {0, 0, 9}, "behind the plane of e"}, {2, f.e, "e itself"},
        {2, {0, 0, (real)8.5}, "behind e"}, {2, {0, 0, (real)NAN}, "NaN"}};
    for (size_t i = 0; i < sizeof nowhere / sizeof *nowhere; i++)
        check(!camera_project(c[nowhere[i].c], nowhere[i].p, 64, 64, &x, &y), "%s: not in front",
              nowhere[i].why);
    check(camera_project(c[1], (vec3){0, 1, 8}, 64, 64, &x, &y) && x == 16 && y == 16,
          "in the plane of e: t = 0 counts");
    check_close(c[2].top, 1, eps, "phi = 90: half height 1");
    check_close(c[2].right, 2, 2 * eps, "a = 2: half width 2");
    camera_project(c[3], (vec3){0, 0, 8}, 64, 64, &x0, &y0);
    camera_project(c[3], (vec3){0, 0, 7}, 64, 64, &x, &y);
    check_close((x - x0) / 8, k, 8 * eps, "cabinet: one unit of depth leads right by cos(45)/2");
    check_close((y - y0) / 8, -k, 8 * eps, "cabinet: and up by sin(45)/2");
}

/* The point at t on the ray through (x, y) must show at (x, y) again. Errors, in units of epsilon:
 *   the window: u is a sum of two numbers up to |l| + |r|, there and back     4 (|l| + |r|)
 *   the point: its rounding and that of p - e                                 2 (|e| + |p|)
 *   D, dot products and the division                                          8 |q|, q = p - e
 * The last two are seen from e under the factor d / depth (perspective), and all count in pixels
 * nx / (r - l). The depth is off as well, and that shows along the slope of the ray: the factor
 * 1 + |q| / depth in perspective views, 2 in parallel ones, whose slope is below sqrt 2 here. */
static void test_there_and_back(void)
{
    size_t n = check_count(200000);
    for (int kind = 0; kind < 4; kind++) {
        double worst = 0;
        for (size_t k = 0; k < n; k++) {
            camera c = any_camera(kind, k % 2 ? 0 : pow((real)10, uniform(-2, 6)));
            real x = uniform(0, nx), y = uniform(0, ny), x2 = -1, y2 = -1;
            ray r = camera_ray(c, x, y, nx, ny);
            real t = pow((real)10, uniform(-1, 3));
            vec3 p = ray_at(r, t);
            if (!camera_project(c, p, nx, ny, &x2, &y2)) {
                /* p may round to e or behind it only if the step is lost in the size of e */
                check_at_most(t * vlength(r.d), 8 * real_epsilon * vlength(c.e),
                              "a point in front was lost");
                continue;
            }
            vec3 q = vsub(p, c.e);
            double depth = -(double)vdot(q, c.w), size = (double)(vlength(c.e) + vlength(p));
            double scale = c.kind == CAMERA_PERSPECTIVE ? (double)c.d / depth : 1;
            double slant = c.kind == CAMERA_PERSPECTIVE ? 1 + (double)vlength(q) / depth : 2;
            double reach = scale * (2 * size + 8 * (double)vlength(q)) * slant;
            double wide_x = (double)(c.right - c.left), wide_y = (double)(c.top - c.bottom);
            double sides = (double)(fabs(c.left) + fabs(c.right));
            double edges = (double)(fabs(c.bottom) + fabs(c.top));
            double bx = eps * nx / wide_x * (4 * sides + reach);
            double by = eps * ny / wide_y * (4 * edges + reach);
            double off = check_worse(fabs((double)(x2 - x)) / bx, fabs((double)(y2 - y)) / by);
            worst = check_worse(worst, off);
        }
        check_at_most(worst, 1, "kind %d: a ray passes through its pixel (1 = the bound above)",
                      kind);
        check_at_least(worst, 0.01, "kind %d: the bound is not a hundred times too wide", kind);
    }
}

/* The ray as FCG introduces it, e + t (s - e): s lands on the lattice of the numbers near e, which
 * may be coarser than the whole window. */
static vec3 naive_direction(camera c, real x, real y)
{
    return vsub(vadd(c.e, camera_ray(c, x, y, 512, 512).d), c.e);
}

/* D against exact arithmetic, with the camera of the Cornell box (d = 0.035, window 0.025 wide).
 * The direct form: four roundings in u (of at most 1 in units of the window) and three in D,
 * wherever e is. s - e: s is rounded to epsilon/2 |e| a component. */
static void test_far_away(void)
{
    real h = 0.0125, d = 0.035;
    for (int k = 0; k <= 8; k += 2) {
        double naive = 0, direct = 0, far = pow(10.0, k);
        for (int i = 0; i < 2000; i++) {
            camera_frame f = any_frame((real)far);
            camera c;
            if (!camera_off_axis(f, (camera_window){-h, h, -h, h}, d, &c, NULL)) abort();
            real x = uniform(0, 512), y = uniform(0, 512);
            vec3 seen = camera_ray(c, x, y, 512, 512).d;
            direct = check_worse(direct, camera_error(c, seen, x, y, 512, 512));
            naive = check_worse(naive,
                                camera_error(c, naive_direction(c, x, y), x, y, 512, 512));
        }
        check_at_most(direct, 8 * eps * 512, "camera_ray at |e| = %g: off by pixels", far);
        double expected = eps * far / (double)(2 * h) * 512;  /* one ulp of e, in pixels */
        if (eps * far < 0.01) {
            check_at_least(naive, expected / 8, "s - e must be seen to fail at |e| = %g", far);
            check_at_most(naive, 2 * expected + 8 * eps * 512, "and by its own reason at |e| = %g",
                          far);
        } else check(!(naive <= 8 * eps * 512), "s - e fails outright at |e| = %g", far);
    }
}

/* The direction of camera_ray in the middle of a wide picture, where |d| = 1: off by epsilon times
 * the size of the window, tan(phi / 2), and not by epsilon |d|. */
static void test_wide_view(void)
{
    for (int k = 0; k <= 2; k++) {
        real phi = 180 - pow((real)10, (real)-k), half = half_tangent(phi);
        double worst = 0;
        camera c;
        failure why;
        for (int i = 0; i < 2000; i++) {
            if (!camera_perspective(any_frame(0), phi, 1, &c, &why)) fail(why);
            real x = 256 + uniform(-1, 1) / half, y = 256 + uniform(-1, 1) / half;
            vec3 d = camera_ray(c, x, y, 512, 512).d;
            /* x and y are off by 1/256 in units of d: |d| <= 1 + 1/256^2; as much for rounding */
            check_close(vlength(d), 1, 2.0 / (256 * 256), "the middle of the picture");
            worst = check_worse(worst, camera_error(c, d, x, y, 512, 512) * 2 * (double)half / 512);
        }
        check_at_most(worst, 4 * eps * (double)half, "angle: 4 epsilon tan(phi / 2) at the most");
        check_at_least(worst, 0.1 * eps * (double)half, "and no less than a tenth");
    }
}

/* 1 / tan(delta), delta = (180 - phi) pi / 360 <= 0.0175, tan by its series. */
static double half_tangent_exact(real phi)
{
    wide pi_wide = {3.14159265358979311600, 1.22464679914735317723e-16};
    wide missing = wide_sub(wide_of(180), wide_of((double)phi));
    wide delta = wide_ratio(wide_mul(missing, pi_wide), 1, 360);
    wide square = wide_mul(delta, delta), sum = wide_of(0);
    static const double top[] = {62, 17, 2, 1, 1}, bottom[] = {2835, 315, 15, 3, 1};
    for (int i = 0; i < 5; i++)
        sum = wide_add(wide_mul(sum, square), wide_div(wide_of(top[i]), wide_of(bottom[i])));
    return wide_value(wide_div(wide_of(1), wide_mul(sum, delta)));
}

/* As texts print it. */
static real half_tangent_naive(real phi) { return tan(phi * pi / 360); }

static void test_half_tangent(void)
{
    real angles[] = {179, 179.9, 179.99, 179.999};
    for (int i = 0; i < 4; i++) {
        double exact = half_tangent_exact(angles[i]);
        double delta = (180 - (double)angles[i]) * (double)pi / 360;
        double robust = fabs((double)half_tangent(angles[i]) / exact - 1);
        double naive = fabs((double)half_tangent_naive(angles[i]) / exact - 1);
        check_at_most(robust, 4 * eps, "half_tangent(%.9g): roundings of angle, tangent, quotient",
                      (double)angles[i]);
        check_at_least(naive, 0.02 * eps / delta, "half_tangent_naive(%.9g) must be seen to fail",
                       (double)angles[i]);
    }
    check_close(half_tangent(60), sqrt(1 / 3.0), 2 * eps, "tan 30");
    check_close(half_tangent(90), 1, 2 * eps, "tan 45");
    check_close(half_tangent(120), sqrt(3.0), 4 * eps, "tan 60");
    check_equal(half_tangent(30), half_tangent_naive(30), "the two agree where nothing is lost");
}

/* FCG and RTR, written down apart from each other, give the same ray for the same pixel. */
static void test_rtr(void)
{
    for (int k = 0; k < 2000; k++) {
        vec3 e = vscale(any_direction(), 10), target = any_direction(), up = any_direction();
        camera c = camera_at(e, target, up, uniform(10, 150), (real)nx / (real)ny);
        rtr_camera q = rtr_camera_of(c);
        real x = uniform(0, nx), y = uniform(0, ny);
        ray a = rtr_camera_ray(q, x, y, nx, ny), b = camera_ray(c, x, y, nx, ny);
        /* some 6 roundings each, of numbers up to |r| + |t| + 1, in a D that is at least 1 long */
        double bound = 8 * eps * (double)(c.right + c.top + 1);
        check_at_most(angle(a.d, b.d), bound, "FCG and RTR at (%g, %g)", (double)x, (double)y);
        check_equal(distance(a.o, b.o), 0, "both begin at the viewpoint");
        check_close(vlength(a.d), 1, 4 * eps, "RTR's direction has length 1");
        check_close(vdot(vcross(q.r, q.u), q.v), -1, 16 * eps, "r, u, v are left-handed");
        /* the slip: what is printed is the mended picture upside down */
        rtr_camera slip = rtr_as_printed(q);
        ray mirror = rtr_camera_ray(q, x, ny - y, nx, ny);
        check_at_most(angle(rtr_camera_ray(slip, x, y, nx, ny).d, mirror.d), bound,
                      "printed at y is mended at h - y");
        check(vdot(rtr_camera_ray(q, x, 0, nx, ny).d, q.u) > 0, "mended: the first row looks up");
    }
}

/* The ray through the vanishing point of D runs along D; of -D it is the same point. */
static void test_vanishing_points(void)
{
    for (int k = 0; k < 2000; k++) {
        camera c = any_camera(2 + k % 2, 3);
        vec3 D = any_direction();
        double D_w = -(double)vdot(D, c.w);
        if (fabs(D_w) < 0.1) continue;
        if (D_w < 0) D = vneg(D), D_w = -D_w;
        real vx = 0, vy = 0, bx = 0, by = 0;
        check(camera_vanishing_point(c, D, nx, ny, &vx, &vy), "a vanishing point");
        check(camera_vanishing_point(c, vneg(D), nx, ny, &bx, &by),
              "and of the line the other way");
        check(bx == vx && by == vy, "is the same point");
        ray r = camera_ray(c, vx, vy, nx, ny);
        double reach = (double)c.d / D_w / (double)(c.right - c.left);
        double reach_y = (double)c.d / D_w / (double)(c.top - c.bottom);
        double big = 8 + 8 * (double)(fabs(c.left) + fabs(c.right)) / (double)(c.right - c.left)
                   + 8 * (double)(fabs(c.bottom) + fabs(c.top)) / (double)(c.top - c.bottom);
        check_at_most(angle(r.d, D), eps * (2 * big + 4 * (reach + reach_y)),
                      "the ray through it runs along D");
    }
    real x, y;
    camera c = any_camera(0, 1);
    check(!camera_vanishing_point(c, c.w, nx, ny, &x, &y),
          "parallel views have no vanishing points");
    c = any_camera(2, 1);
    check(!camera_vanishing_point(c, (vec3){0, 0, 0}, nx, ny, &x, &y), "nor has no direction");
    camera_frame f = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    check(camera_off_axis(f, (camera_window){-1, 1, -1, 1}, 1, &c, NULL), "a camera");
    check(!camera_vanishing_point(c, (vec3){1, 1, 0}, nx, ny, &x, &y),
          "nor have lines along the image plane");
}

/* Points on a line show on a line: in every kind of view. */
static void test_lines_stay_lines(void)
{
    for (int k = 0; k < 4000; k++) {
        camera c = any_camera(k % 4, 1);
        vec3 p = vmadd(vmadd(c.e, c.w, -6), any_direction(), 2), D = any_direction();
        double x[3], y[3];
        for (int i = 0; i < 3; i++) {
            real px = 0, py = 0;
            check(camera_project(c, vmadd(p, D, (real)i), nx, ny, &px, &py), "in front");
            x[i] = (double)px, y[i] = (double)py;
        }
        double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        /* projecting is off by an epsilon of such a size; the area multiplies two of them */
        double size = 2 * nx + fabs(x[0]) + fabs(y[0]) + fabs(x[2]) + fabs(y[2]);
        check_close(area, 0, 2 * eps * size * size, "three points of a line, kind %d", k % 4);
    }
}

/* FCG notes that e and l, r are redundant. In a parallel view moving e by a u and l, r by -a gives
 * the same rays; doing only one of the two does not, and in perspective not even both. */
static void test_what_moving_changes(void)
{
    camera_frame f = {{2, 3, 5}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, moved = f;
    moved.e.x += 4;
    camera_window n = {-1, 1, -1, 1}, shifted = {-5, -3, -1, 1};
    camera c, both;
    const struct { camera_frame f; camera_window n; double apart; const char *what; } in[] = {
        {moved, shifted, 0, "both moved, same rays"}, {moved, n, 4, "only e moved: other rays"},
        {f, shifted, 4, "only l, r moved: other rays"}};
    for (int k = 0; k < 6; k++) {  /* dyadic: nothing rounds, the same rays bit for bit */
        vec3 along = vec(k < 3 ? 0 : 0.5, 0, -1);
        if (!camera_oblique(f, n, along, &c, NULL)
            || !camera_oblique(in[k % 3].f, in[k % 3].n, along, &both, NULL)) abort();
        for (int i = 0; i <= 64; i += 8)
            check_equal(distance(camera_ray(c, (real)i, 16, 64, 64).o,
                                 camera_ray(both, (real)i, 16, 64, 64).o), in[k % 3].apart,
                        "parallel, %s", in[k % 3].what);
    }
    if (!camera_off_axis(f, n, 1, &c, NULL)
        || !camera_off_axis(moved, shifted, 1, &both, NULL)) abort();
    real x1, y1, x2, y2;
    vec3 in_plane = {2, 3, 4}, beyond = {2, 3, 1};  /* at depth 1 = d, and at depth 4 */
    camera_project(c, in_plane, 64, 64, &x1, &y1);
    camera_project(both, in_plane, 64, 64, &x2, &y2);
    check_equal(x1, x2, "perspective, both moved: the image plane stays");
    camera_project(c, beyond, 64, 64, &x1, &y1);
    camera_project(both, beyond, 64, 64, &x2, &y2);
    /* closed form: u = d X / depth + a (1 - d / depth): 4 (1 - 1/4) = 3 units of 32 pixels */
    check_equal(x2 - x1, 96, "but what lies beyond moves: parallax");
    camera twice;
    if (!camera_off_axis(f, (camera_window){-2, 2, -2, 2}, 2, &twice, NULL)) abort();
    vec3 d1 = camera_ray(c, 8, 24, 64, 64).d, d2 = camera_ray(twice, 8, 24, 64, 64).d;
    check_equal(distance(vscale(d1, 2), d2), 0,
                "l, r, b, t, d all doubled: the same rays, twice as long");
}

static void test_headlight(void)
{
    vec3 n = {0, 0, 1}, o = {0, 0, 0};
    const real tiny = sqrt(real_smallest) / 8, huge_ = real_largest / 4;
    const struct { vec3 n, d; double due; const char *why; } in[] = {
        {n, {0, 0, -7}, 1, "facing the eye, whatever the length of d"},
        {vneg(n), {0, 0, -7}, 1, "the back is as bright"}, {n, {3, 0, 0}, 0, "edge-on"},
        {n, {3, 0, -4}, 0.8, "3-4-5"}, {n, o, 0, "no direction: black"},
        {o, n, 0, "no normal: black"}, {n, {0, tiny, tiny}, sqrt(0.5), "d too short to square"},
        {n, {0, huge_, huge_}, sqrt(0.5), "d too long to square"}};
    for (size_t i = 0; i < sizeof in / sizeof *in; i++)
        check_close(headlight(in[i].n, in[i].d).x, in[i].due, 4 * eps * in[i].due, "%s", in[i].why);
    check(isnan(headlight(vec(0, 0, NAN), n).x), "a NaN stays a NaN");
    for (int k = 0; k < 10000; k++) {
        vec3 d = any_direction();
        vec3 c = headlight(d, vscale(d, uniform(0.1, 9)));
        check(c.x <= 1 && c.x >= 1 - 4 * real_epsilon && c.x == c.y && c.y == c.z,
              "grey, at most 1");
    }
}

int main(void)
{
    s = random_start(2, 0, 0);
    return check_all("02_camera", test_frames, test_frames_near_parallel, test_refusals,
                     test_pixels_exactly, test_there_and_back, test_far_away, test_wide_view,
                     test_half_tangent, test_rtr, test_vanishing_points, test_lines_stay_lines,
                     test_what_moving_changes, test_headlight);
}
