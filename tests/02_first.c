/* 02's first.h: the rays of camera_ray, to the last bit; and an `up` along the view. Nearly along
 * it: test_frames_near_parallel in 02_camera.c. */
#include "02_oracle.h"
#include "../chapters/02_camera/filter.h"
#include "check.h"

static const double eps = (double)real_epsilon;

static double apart(vec3 a, vec3 b) { return (double)vlength(vsub(a, b)); }
static bool same(vec3 a, vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
static bool same_ray(ray a, ray b)
{
    return same(a.o, b.o) && same(a.d, b.d) && a.tmin == b.tmin && a.tmax == b.tmax;
}

/* Views whose `up` is at least 0.3 radians away from the view, fields of view up to a right angle:
 * the frame within some epsilon of frame_look_at, the window of camera_perspective. */
static void test_views(void)
{
    double frame = 0, window = 0;
    size_t n = check_count(20000), seen = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(1, i, 0);
        vec3 e = random_in_cube(&s, 1), target = random_in_cube(&s, 1), up = random_in_cube(&s, 1);
        real phi = 1 + 89 * random_next(&s);
        int nx = 1 + (int)(1000 * random_next(&s)), ny = 1 + (int)(1000 * random_next(&s));
        camera_frame f;
        camera full;
        failure why;
        real sine = vlength(vcross(vunit(up), vunit(vsub(e, target))));
        if (!(sine > (real)0.3) || !frame_look_at(e, target, up, &f, &why)) continue;
        if (!camera_perspective(f, phi, (real)nx / (real)ny, &full, &why)) fail(why);
        first_camera c = first_camera_at(e, target, up, phi, nx, ny);
        seen++;
        frame = check_worse(frame, apart(c.u, f.u) + apart(c.v, f.v) + apart(c.w, f.w));
        double off = fabs((double)(c.right / full.right - 1)) + fabs((double)(c.top / full.top - 1))
            + fabs((double)(c.left / full.left - 1)) + fabs((double)(c.bottom / full.bottom - 1));
        window = check_worse(window, off);
    }
    check_at_least((double)seen, 0.8 * (double)n, "the test sees views");
    check_at_most(frame, 40 * eps, "u, v, w, within 4 epsilon over the sine of the angle");
    check_at_most(window, 16 * eps, "l, r, b, t, of %zu", n);
}

/* Of one frame and one window the rays are those of camera_ray, bit by bit. */
static void test_rays(void)
{
    size_t perspective = 0, parallel = 0, positions = 0, n = check_count(20000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(2, i, 0);
        real angle = 1 + 178 * random_next(&s);
        vec3 to = random_in_cube(&s, 1), from = vscale(random_in_cube(&s, 1), 100);
        first_camera c = first_camera_at(from, to, (vec3){0, 1, 0}, angle, 640, 480);
        if (i % 2) c.left *= 2, c.bottom = -c.top / 3, c.d = 1 + random_next(&s);  /* off-axis */
        real x = 640 * random_next(&s), y = 480 * random_next(&s);
        camera_frame f = {c.e, c.u, c.v, c.w};
        camera_window w = {c.left, c.right, c.bottom, c.top};
        camera eye = {.d = 1}, plan;
        failure why;
        if (!camera_off_axis(f, w, c.d, &eye, &why)) fail(why);
        if (!camera_orthographic(f, w, &plan, &why)) fail(why);
        perspective += !same_ray(first_camera_ray(c, x, y), camera_ray(eye, x, y, 640, 480));
        parallel += !same_ray(first_orthographic_ray(c, x, y), camera_ray(plan, x, y, 640, 480));
        for (int k = 0; k < 9; k++) {
            real px = 0, py = 0, half = (real)0.5;
            samples_place(SAMPLES_REGULAR, k, 3, half, &s, &px, &py);
            ray a = first_pixel_ray(c, 17, 4, k, 3);
            ray b = camera_ray(eye, 17 + half + px, 4 + half + py, 640, 480);
            positions += !(apart(a.d, b.d) <= 64 * eps * (double)vlength(b.d)) || !same(a.o, b.o);
        }
    }
    check_equal(perspective, 0, "first_camera_ray against camera_ray, of %zu", n);
    check_equal(parallel, 0, "first_orthographic_ray against camera_ray, of %zu", n);
    check_equal(positions, 0, "first_pixel_ray: the middles of 3 x 3 cells, of %zu", 9 * n);
}

/* "Wrong where up is along the view: u becomes (0,0,0)": and then all rays of a picture lie in the
 * plane of w and v, and v is 0, too: they are one ray. frame_look_at refuses it. */
static void test_up_along_the_view(void)
{
    vec3 e = {0, 0, 0}, target = {0, 0, -4}, up = {0, 0, 1};
    camera_frame f;
    failure why;
    first_camera c = first_camera_at(e, target, up, 90, 64, 64);
    check(vzero(c.u) && vzero(c.v), "up along the view: neither right nor up");
    check(same(first_camera_ray(c, 0, 0).d, first_camera_ray(c, 64, 64).d), "all rays are one");
    check(!frame_look_at(e, target, up, &f, &why), "frame_look_at refuses it");
    c = first_camera_at(e, e, up, 90, 64, 64);
    check(vzero(first_camera_ray(c, 32, 32).d), "at itself: no direction");
    c = first_camera_at(e, (vec3){(real)NAN, 0, 1}, up, 90, 64, 64);
    check(vzero(c.u), "a NaN: no right");
}

int main(void)
{
    return check_all("02_first", test_views, test_rays, test_up_along_the_view);
}
