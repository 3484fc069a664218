/* 02_camera: the ray through each point of a picture, by four kinds of camera; several a pixel.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 02_camera chapters/02_camera/main.c -lm -lpthread
 *
 * Draws one room through four cameras, three vanishing points, the slip in RTR's equation, a camera
 * far from the origin, what lies behind a parallel view, and a zone plate with one ray a pixel and
 * with many. Prints and plots error against time (measure_rays.h, measure_pixels.h). */
#include "../../common/lab/report.h"
#include "lab/measure_pixels.h"
#include "rtr_camera.h"

#define r_(x) ((real)(x))
static const vec3 eye = {9, r_(7.5), 7}, target = {r_(1.7), r_(1.9), r_(1.6)}, up = {0, 0, 1};
static failure why;
static void ask(bool ok) { if (!ok) fail(why); }

/* Above: parallel; below: perspective. Left: into the corner; right: level with the wall y = 0. */
static void draw_four_cameras(const options *o, view v, int w, int h)
{
    view four[4] = {v, v, v, v};
    camera_frame corner, level, near_level;
    real s = r_(3.6), a = r_(w) / r_(h), k = sqrt(r_(0.5)) / 2;  /* depth halved, at 45 degrees */
    ask(frame_look_at(eye, target, up, &corner, &why));
    ask(frame_look_at((vec3){2, 5, 2}, (vec3){2, 0, 2}, up, &level, &why));
    ask(frame_look_at((vec3){6, 11, r_(6.2)}, (vec3){6, 0, r_(6.2)}, up, &near_level, &why));
    vec3 cabinet = vadd(vneg(level.w), vadd(vscale(level.u, k), vscale(level.v, -k)));
    camera_window square = {-a * s, a * s, -s, s};
    camera_window beside = {a * r_(-4), a * r_(2.3), r_(-2.2), r_(4.1)};
    camera_window above = {r_(3.95) - a * r_(2.85), r_(3.95) + a * r_(2.85), r_(-6.6), r_(-0.9)};
    ask(camera_orthographic(corner, square, &four[0].c, &why));
    ask(camera_oblique(level, beside, cabinet, &four[1].c, &why));
    ask(camera_perspective(corner, 38, a, &four[2].c, &why));
    ask(camera_off_axis(near_level, above, 7, &four[3].c, &why));
    draw_panels(o, four, 4, 2, w, h, "02_camera.png", true);
}

/* A block, and its edges carried on to where they meet. */
static void draw_vanishing_points(const options *o, view v, int w, int h)
{
    room block = {.n = 0};
    camera_frame f;
    real s = r_(0.7), vx[3] = {0, 0, 0}, vy[3] = {0, 0, 0};
    vec3 ink[] = {{r_(0.7), r_(0.05), 0}, {0, r_(0.3), r_(0.15)}, {0, r_(0.12), r_(0.65)}};
    room_block(&block, (vec3){-s, -s, -s}, (vec3){s, s, s}, (vec3){1, r_(0.85), r_(0.5)}, s);
    ask(frame_look_at((vec3){r_(2.15), r_(1.35), r_(1.6)}, (vec3){0, 0, 0}, up, &f, &why));
    ask(camera_off_axis(f, (camera_window){r_(-2.05), r_(1.05), r_(-1.75), r_(0.85)}, 1, &v.c,
                        &why));
    v.scene = &block;
    image im = image_new(w, h);
    bool whole = draw(&v, &im, o->threads);
    for (int k = 0; k < 3; k++) {
        ask(camera_vanishing_point(v.c, (vec3){k == 0, k == 1, k == 2}, w, h, &vx[k], &vy[k]));
        for (int i = 0; i < 4; i++) {  /* the four edges along axis k, from their near ends */
            real a = i & 1 ? s : -s, b = i & 2 ? s : -s, x = 0, y = 0;
            vec3 end = k == 0 ? (vec3){s, a, b} : k == 1 ? (vec3){a, s, b} : (vec3){a, b, s};
            ask(camera_project(v.c, end, w, h, &x, &y));
            draw_stroke(&im, x, y, vx[k], vy[k], r_(1.2), ink[k]);
        }
    }
    draw_stroke(&im, vx[0], vy[0], vx[1], vy[1], 2, (vec3){0, 0, 0});  /* the horizon */
    for (int k = 0; k < 3; k++) draw_stroke(&im, vx[k], vy[k], vx[k], vy[k], 13, ink[k]);
    output_picture(o, &im, "02_camera_vanishing.png", false, whole);
    image_free(&im);
}

static ray aim_rtr(const view *v, real x, real y)  /* rtr_camera_ray at any point of the picture */
{
    const rtr_camera *k = v->own;
    return ray_from(k->c, rtr_s(*k, x, y, v->out->width, v->out->height, -1));
}
static ray aim_rtr_printed(const view *v, real x, real y)
{
    const rtr_camera *k = v->own;
    return ray_from(k->c, rtr_s(*k, x, y, v->out->width, v->out->height, 1));
}
static ray aim_far(const view *v, real x, real y)  /* as if 200 km from the origin, in float */
{
    ray r = camera_ray(v->c, x, y, v->out->width, v->out->height);
    return ray_from(r.o, camera_direction_naive_f32((vec3){120000, 96000, 128000}, r.d));
}
static ray aim_whole_line(const view *v, real x, real y)
{
    ray r = camera_ray(v->c, x, y, v->out->width, v->out->height);
    r.tmin = -real_infinity;
    return r;
}

static void draw_pairs(const options *o, view v, int side)
{
    static const double rings = 0.0131;  /* finer than the pixels beyond a radius of 120 of them */
    camera_frame f;
    rtr_camera k;
    view p[3] = {v, v, v};
    ask(rtr_look_at(eye, target, up, 38, &k, &why));
    p[0].aim = aim_rtr_printed, p[1].aim = aim_rtr, p[0].own = p[1].own = &k;
    draw_panels(o, p, 2, 2, 2 * side + 6, side, "02_camera_rtr.png", false);

    ask(frame_look_at(eye, target, up, &f, &why));
    ask(camera_perspective(f, 38, 1, &p[0].c, &why));
    p[0].aim = aim_far, p[1].aim = NULL, p[1].c = p[0].c;
    draw_panels(o, p, 2, 2, 2 * side + 6, side, "02_camera_far.png", false);

    f.e = (vec3){r_(2.15), r_(2.2), r_(1.7)};  /* in the middle of the room */
    real s = r_(3.8);
    ask(camera_orthographic(f, (camera_window){-s, s, -s, s}, &p[0].c, &why));
    p[0].aim = NULL, p[1].aim = aim_whole_line, p[1].c = p[0].c;
    draw_panels(o, p, 2, 2, 2 * side + 6, side, "02_camera_behind.png", false);

    int zone = side * 4 / 5;
    v.c = pixel_grid(zone);
    v.see = see_zone_plate, v.own = &rings, v.how = SAMPLES_REGULAR, v.f = filter_box;
    p[0] = p[1] = p[2] = v;
    p[0].n = 1, p[1].n = p[2].n = 8, p[2].f = filter_gaussian;
    draw_panels(o, p, 3, 3, 3 * zone + 12, zone, "02_camera_zone_plate.png", false);
}

static void measure(const options *o)
{
    int rounds = o->quick ? 1 : 5, log = PLOT_LOG_X | PLOT_LOG_Y;
    table t = table_new("02_camera: what accuracy costs",
                        "question|variant|setting|error|time [ns]");
    plot far = plot_new("A ray far from the origin", "|e| [m]", "largest error [pixels]", log);
    plot board = plot_new("Checkerboard", "rays a pixel", "rms error [white = 1]", log);
    plot zone = plot_new("Zone plate", "rays a pixel", "rms error [white = 1]", log);
    plot time = plot_new("Checkerboard", "time a pixel [ns]", "rms error [white = 1]", log);
    measure_rays(&t, &far, rounds);
    measure_frames(&t, rounds);
    measure_tangents(&t, rounds);
    measure_wall(&t, rounds);
    measure_filters(&t, &board, &zone, &time, o->quick ? 4 : 32, o->quick ? 1 : 3);
    plot_slope(&board, -0.5, "slope -1/2");
    plot_slope(&board, -0.75, "slope -3/4");
    plot_slope(&zone, -0.5, "slope -1/2");
    plot_slope(&zone, -1, "slope -1");
    output_plot(o, &far, "02_camera_far.svg");
    output_plot(o, &board, "02_camera_checkerboard.svg");
    output_plot(o, &zone, "02_camera_zone_plate.svg");
    output_plot(o, &time, "02_camera_time.svg");
    output_table(o, &t);
}

int main(int argc, char **argv)
{
    options o = {.width = 806, .height = 806, .samples = 16, .seed = 1};
    o = options_read(argc, argv, "02_camera", "camera rays of four kinds, several a pixel", o,
                     NULL);
    room scene = room_corner();
    view v = {.scene = &scene, .f = filter_tent, .how = SAMPLES_JITTERED, .seed = o.seed};
    if (o.quick && o.samples == 16) o.samples = 1;  /* what was asked for stays */
    v.n = (int)sqrt((double)o.samples);  /* the largest square that is not more */
    draw_four_cameras(&o, v, o.width, o.height);
    if (!o.out) {
        draw_vanishing_points(&o, v, o.quick ? 202 : 806, o.quick ? 169 : 676);
        draw_pairs(&o, v, o.quick ? 100 : 400);
    }
    measure(&o);
    return output_done(&o);
}
