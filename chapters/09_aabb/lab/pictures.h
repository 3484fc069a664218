/* pictures.h: the rendered pictures of this chapter.
 *
 *   draw_room(&o)         boxes, and walls and boards of no thickness: first beside aabb_hit,
 *                         and a reader's own test (mine.h)
 *   draw_aligned(&o)      rays along an axis at whole numbers, as from an orthographic camera: what
 *                         each method loses in the planes of the boxes
 */
#ifndef AABB_PICTURES_H
#define AABB_PICTURES_H

#include "../../../common/headlight.h"
#include "../../../common/lab/label.h"
#include "../../../common/lab/pixels.h"
#include "../../../common/output.h"
#include "../../02_camera/camera.h"
#include "exact.h"
#include "slabs.h"

/* ---- the room ---- */

enum { room_gap = 6, room_boxes = 17, room_parts = 2 + aabb_mine };
typedef struct { aabb b; vec3 colour; } aabb_painted;
typedef struct {
    aabb_test *test;
    image im;
    camera view;
    aabb_painted box[room_boxes];
} aabb_room;

static inline void room_furnish(aabb_painted *p)
{
    static const signed char box[][6] = {  /* in quarters */
        {0, 0, 0, 24, 24, 0}, {0, 0, 0, 0, 24, 16}, {0, 0, 0, 24, 0, 16},     /* floor, walls */
        {0, 3, 5, 3, 11, 5}, {0, 3, 8, 3, 11, 8}, {0, 3, 11, 3, 11, 11},      /* boards */
        {1, 14, 0, 6, 20, 3}, {1, 14, 3, 3, 20, 6},                           /* a seat */
        {8, 8, 4, 15, 14, 4}, {8, 8, 0, 9, 9, 4}, {14, 8, 0, 15, 9, 4},       /* a flat table, */
        {8, 13, 0, 9, 14, 4}, {14, 13, 0, 15, 14, 4}, {10, 10, 4, 12, 12, 6}, /* a box on it */
        {17, 1, 0, 17, 7, 7}, {19, 0, 5, 23, 0, 10}, {16, 16, 0, 20, 20, 4}}; /* a screen, ... */
    for (int i = 0; i < room_boxes; i++) {
        real q[6];
        for (int k = 0; k < 6; k++) q[k] = (real)box[i][k] / 4;
        double warm = i % 3 == 0 ? 0.85 : 0.45, cold = i % 3 == 2 ? 0.85 : 0.5;
        p[i].b = (aabb){{q[0], q[1], q[2]}, {q[3], q[4], q[5]}};
        p[i].colour = i < 3 ? vec(0.75, 0.72, 0.66) : vec(warm, 0.55, cold);
    }
    p[15].b.lo.y = p[15].b.hi.y = 0.125;  /* a picture, a little before its wall */
}

/* The axis of the face that p lies on. */
static inline int face_axis(aabb b, vec3 p)
{
    vec3 lo = vsub(p, b.lo), hi = vsub(p, b.hi);
    real x = real_min(fabs(lo.x), fabs(hi.x)), y = real_min(fabs(lo.y), fabs(hi.y));
    real z = real_min(fabs(lo.z), fabs(hi.z));
    return x <= y && x <= z ? 0 : y <= z ? 1 : 2;
}

static vec3 room_colour(const void *context, real x, real y)
{
    static const vec3 axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const aabb_room *s = context;
    ray r = camera_ray(s->view, x, y, s->im.width, s->im.height);
    vec3 c = vec(0.03, 0.04, 0.07);
    for (int i = 0; i < room_boxes; i++) {
        real t;
        if (!s->test(s->box[i].b, r, &t) || t > r.tmax) continue;
        r.tmax = t;
        vec3 n = axis[face_axis(s->box[i].b, ray_at(r, t))];
        c = vmul(s->box[i].colour, headlight(n, r.d));
    }
    return c;
}

static inline void draw_room(const options *o)
{
    static const struct { const char *name; aabb_test *test; } part[] = {
        {"first_aabb_hit", first_aabb_hit}, {"aabb_hit", aabb_hit}, {"mine", mine_aabb_hit}};
    int gaps = (room_parts - 1) * room_gap;
    int width = o->width > 2 * gaps ? (o->width - gaps) / room_parts : o->width;
    aabb_room s = {.im = image_new(width, o->height)};
    image im = label_sheet(o->width, o->height);
    vec3 e = {13, 15, 8}, target = vec(2.4, 2.4, 0.9), up = {0, 0, 1};
    bool whole = true;
    room_furnish(s.box);
    s.view = camera_at(e, target, up, 27, (real)width / (real)o->height);
    for (int k = 0; k < room_parts && whole; k++) {
        s.test = part[k].test;
        whole = pixels_draw(&s.im, 2, o->threads, "room", room_colour, &s);
        image_place(&im, k * (width + room_gap), 0, &s.im);
        if (o->width >= 400 && o->height >= 100)
            label_tag(&im, k * (width + room_gap) + 10, 10, 12, part[k].name);
    }
    output_picture(o, &im, "09_aabb.png", true, whole);
    image_free(&im), image_free(&s.im);
}

/* ---- rays along an axis ---- */

enum { cell_count = 64, cell_size = 4, cell_panel = cell_count * cell_size + 10 };
enum { cell_columns = 3 + aabb_mine };
static const int cell_method[] = {aabb_of_first, aabb_of_closed, aabb_of_default, aabb_of_mine};
/* Hit, miss, a hit that is lost, a false alarm: linear light of blue, grey, red, yellow. */
static const vec3 cell_colour[4] = {{0, 0.168, 0.445}, {0.8, 0.8, 0.8}, {0.665, 0.112, 0},
                                    {0.871, 0.776, 0.054}};

/* Cell (i, j) of a panel: does the ray meet any of four boxes? The exact answer is *truth. Along
 * -z, d.x = +0.0 on the left and -0.0 on the right, d.y = +0.0 above and -0.0 below: four times a
 * block, a plate of no thickness, a sheet seen edge-on and a rod seen end-on. */
static inline bool cell_ask(aabb_test *test, int i, int j, bool *truth)
{
    static const int b[4][6] = {{4, 4, 0, 14, 14, 5}, {18, 4, 3, 28, 14, 3},
                                {4, 20, 0, 28, 20, 5}, {16, 26, 0, 16, 26, 5}};
    int half = cell_count / 2, x = i / half * half, y = j / half * half;
    ray r = ray_from(vec(i, j, 9), vec(i < half ? 0.0 : -0.0, j < half ? 0.0 : -0.0, -1));
    bool answer = *truth = false;
    for (int k = 0; k < 4; k++) {
        aabb box = {vec(x + b[k][0], y + b[k][1], b[k][2]), vec(x + b[k][3], y + b[k][4], b[k][5])};
        real t;
        *truth |= exact_aabb(box, r).hit;
        answer |= test(box, r, &t);
    }
    return answer;
}

static inline void draw_aligned(const options *o)
{
    static const char *const key[] = {"hit", "miss", "a hit that is lost", "a false alarm"};
    const vec3 black = {0, 0, 0};
    const char *title[cell_columns];
    image im = image_new(cell_columns * cell_panel - 10, cell_panel - 10);
    for (int k = 0; k < cell_columns; k++) {
        title[k] = aabb_method[cell_method[k]].name;
        for (int c = 0; c < cell_count * cell_count; c++) {
            int i = c % cell_count, j = c / cell_count;
            bool truth, answer = cell_ask(aabb_method[cell_method[k]].hit, i, j, &truth);
            label_fill(&im, k * cell_panel + i * cell_size, j * cell_size, cell_size, cell_size,
                       cell_colour[truth == answer ? !truth : truth ? 2 : 3]);
        }
    }
    label_titles(&im, cell_columns, 1, 10, title), label_below(&im, 84);
    double middle = im.width / 2.0;
    int y = im.height - 84;
    label_text(&im, middle, y + 22, 10, 0.5, black,
               "left half d.x = +0.0, right -0.0; upper half d.y = +0.0, lower -0.0");
    label_text(&im, middle, y + 44, 10, 0.5, black,
               "each quarter: a block, a flat plate; a sheet seen edge-on; a rod seen end-on");
    for (int k = 0, x = 20; k < 4; k++, x += 195) {
        label_fill(&im, x, y + 60, 16, 16, cell_colour[k]);
        label_text(&im, x + 24, y + 73, 11, 0, black, key[k]);
    }
    output_picture(o, &im, "09_aabb_aligned.png", false, true);
    image_free(&im);
}

#endif
