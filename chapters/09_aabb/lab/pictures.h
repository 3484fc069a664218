/* pictures.h: the rendered pictures of this chapter.
 *
 *   draw_room(&o)         boxes, and walls and boards of no thickness: first beside aabb_hit
 *   draw_aligned(&o)      rays along an axis at whole numbers, as from an orthographic camera: what
 *                         each method loses in the planes of the boxes
 *   draw_silhouette(&o)   around a corner, one cell a neighbouring real of the origin
 */
#ifndef AABB_PICTURES_H
#define AABB_PICTURES_H

#include "../../../common/headlight.h"
#include "../../../common/lab/label.h"
#include "../../../common/parallel.h"
#include "../../02_camera/camera.h"
#include "mantissa.h"
#include "slabs.h"

/* ---- the room ---- */

enum { room_gap = 6, room_boxes = 17 };
typedef struct { aabb b; vec3 colour; } aabb_painted;
typedef struct { image *im; int panel; camera view; aabb_painted box[room_boxes]; } aabb_room;

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

static inline vec3 room_colour(const aabb_room *s, aabb_test *test, ray r)
{
    static const vec3 axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    vec3 c = vec(0.03, 0.04, 0.07);
    for (int i = 0; i < room_boxes; i++) {
        real t;
        if (!test(s->box[i].b, r, &t) || t > r.tmax) continue;
        r.tmax = t;
        vec3 n = axis[face_axis(s->box[i].b, ray_at(r, t))];
        c = vmul(s->box[i].colour, headlight(n, r.d));
    }
    return c;
}

static inline void room_pixel(int x, int y, void *context)
{
    const aabb_room *s = context;
    bool right = x >= s->panel + room_gap;
    vec3 sum = {0, 0, 0};
    real px = (real)(right ? x - s->panel - room_gap : x);
    if (!right && x >= s->panel) { image_set(s->im, x, y, (vec3){1, 1, 1}); return; }
    for (int i = 0; i < 4; i++) {
        real u = px + (real)(1 + 2 * (i % 2)) / 4, v = (real)y + (real)(1 + 2 * (i / 2)) / 4;
        ray r = camera_ray(s->view, u, v, s->panel, s->im->height);
        sum = vmadd(sum, room_colour(s, right ? aabb_hit : first_aabb_hit, r), 0.25);
    }
    image_set(s->im, x, y, sum);
}

static inline void draw_room(const options *o)
{
    aabb_room s;
    camera_frame f;
    failure why;
    image im = image_new(o->width, o->height);
    vec3 e = {13, 15, 8}, target = vec(2.4, 2.4, 0.9), up = {0, 0, 1};
    s.im = &im, s.panel = o->width > 2 * room_gap ? (o->width - room_gap) / 2 : o->width;
    room_furnish(s.box);
    if (!frame_look_at(e, target, up, &f, &why)
        || !camera_perspective(f, 27, (real)s.panel / (real)im.height, &s.view, &why))
        fail(why);
    bool whole = parallel_pixels(im.width, im.height, o->threads, "room", room_pixel, &s);
    if (o->width >= 400 && o->height >= 100) {
        label_tag(&im, 10, 10, 12, "first_aabb_hit");
        label_tag(&im, s.panel + room_gap + 10, 10, 12, "aabb_hit");
    }
    output_picture(o, &im, "09_aabb.png", true, whole);
    image_free(&im);
}

/* ---- cells: one panel a method ---- */

enum { cell_count = 64, cell_size = 4, cell_panel = cell_count * cell_size + 10, cell_columns = 3 };
/* The methods of a picture of one row of panels, and of one of two rows. */
static const int cell_method[2][2 * cell_columns] = {
    {aabb_of_first, aabb_of_closed, aabb_of_default},
    {aabb_of_first, aabb_of_closed, aabb_of_fmin, aabb_of_pbrt, aabb_of_inclusive,
     aabb_of_default}};
/* Hit, miss, a hit that is lost, a false alarm: linear light of blue, grey, red, yellow. */
static const vec3 cell_colour[4] = {{0, 0.168, 0.445}, {0.8, 0.8, 0.8}, {0.665, 0.112, 0},
                                    {0.871, 0.776, 0.054}};

/* What cell (i, j) asks: is any of the boxes hit? Returns their number; *truth is the answer. */
typedef int aabb_question(int i, int j, aabb *box, ray *r, bool *truth);
typedef struct { image *im; aabb_question *ask; const int *method; } aabb_cells;

/* Cell x, y of all panels side by side. */
static inline void cell_ask(int x, int y, void *context)
{
    const aabb_cells *p = context;
    int panel = x / cell_count + cell_columns * (y / cell_count);
    aabb box[8];
    ray r;
    real t;
    bool truth, answer = false;
    int n = p->ask(x % cell_count, y % cell_count, box, &r, &truth);
    for (int k = 0; k < n; k++) answer |= aabb_method[p->method[panel]].hit(box[k], r, &t);
    image_set(p->im, x, y, cell_colour[truth == answer ? !truth : truth ? 2 : 3]);
}

/* `rows` of panels, and below them up to two lines of text. */
static inline void draw_cells(const options *o, const char *name, int rows, const char *axes,
                              const char *more, aabb_question *ask)
{
    const int *method = cell_method[rows - 1], text = more ? 84 : 62;  /* [pixels] */
    static const char *const key[] = {"hit", "miss", "a hit that is lost", "a false alarm"};
    const char *title[2 * cell_columns];
    for (int k = 0; k < cell_columns * rows; k++) title[k] = aabb_method[method[k]].name;
    image cells = image_new(cell_columns * cell_count, rows * cell_count);
    aabb_cells p = {&cells, ask, method};
    bool whole = parallel_pixels(cells.width, cells.height, o->threads, name, cell_ask, &p);
    image im = image_new(cell_columns * cell_panel - 10, rows * cell_panel - 10);
    for (int y = 0; y < cells.height; y++)
        for (int x = 0; x < cells.width; x++)
            label_fill(&im, x / cell_count * cell_panel + x % cell_count * cell_size,
                       y / cell_count * cell_panel + y % cell_count * cell_size, cell_size,
                       cell_size, image_get(&cells, x, y));
    image panels = label_panels(&im, cell_columns, rows, 10, title);
    image sheet = image_new(panels.width, panels.height + text);
    label_fill(&sheet, 0, 0, sheet.width, sheet.height, vec(1, 1, 1));
    image_place(&sheet, 0, 0, &panels);
    int y = panels.height, x = 20;
    label_text(&sheet, sheet.width / 2.0, y + 22, 10, 0.5, vec(0, 0, 0), axes);
    if (more) label_text(&sheet, sheet.width / 2.0, y + 44, 10, 0.5, vec(0, 0, 0), more);
    y += text;
    for (int k = 0; k < 4; k++, x += 195) {
        label_fill(&sheet, x, y - 24, 16, 16, cell_colour[k]);
        label_text(&sheet, x + 24, y - 11, 11, 0, vec(0, 0, 0), key[k]);
    }
    output_picture(o, &sheet, name, false, whole);
    image_free(&cells), image_free(&im), image_free(&panels), image_free(&sheet);
}

/* Along -z, d.x = +0.0 on the left and -0.0 on the right, d.y = +0.0 above and -0.0 below: four
 * times a block, a plate of no thickness, a sheet seen edge-on and a rod seen end-on. */
static inline int ask_aligned(int i, int j, aabb *box, ray *r, bool *truth)
{
    static const int b[4][6] = {{4, 4, 0, 14, 14, 5}, {18, 4, 3, 28, 14, 3},
                                {4, 20, 0, 28, 20, 5}, {16, 26, 0, 16, 26, 5}};
    int half = cell_count / 2, x = i / half * half, y = j / half * half;
    r->o = vec(i, j, 9), r->tmin = 0, r->tmax = real_infinity;
    r->d = vec(i < half ? 0.0 : -0.0, j < half ? 0.0 : -0.0, -1);
    *truth = false;
    for (int k = 0; k < 4; k++) {
        box[k].lo = vec((x + b[k][0]), (y + b[k][1]), b[k][2]);
        box[k].hi = vec((x + b[k][3]), (y + b[k][4]), b[k][5]);
        *truth |= exact_aabb(box[k], *r).hit;
    }
    return 4;
}

/* Parallel rays past the corner (lo.x, hi.y, hi.z), their origins 1/4 epsilon apart: next to each
 * other, as reals between 1/4 and 1/2 are. They enter by lo.x and hi.z, and leave by hi.y. */
static inline int ask_silhouette(int i, int j, aabb *box, ray *r, bool *truth)
{
    vec3 corner = vec(0.78213, 0.71971, 0.13457), d = vec(1.17312, 0.91973, -0.83719);
    real step = real_epsilon / 4, t = (real)0.38711;
    *box = (aabb){{corner.x, -1, -1}, {2, corner.y, corner.z}};
    *r = ray_from(vmadd(corner, d, -t), d);
    r->o.x += (real)(i - cell_count / 2) * step;
    r->o.y -= (real)(j - cell_count / 2) * step;
    *truth = wide_aabb(*box, *r).hit;
    return 1;
}

static inline void draw_aligned(const options *o)
{
    draw_cells(o, "09_aabb_aligned.png", 1,
               "left half d.x = +0.0, right -0.0; upper half d.y = +0.0, lower -0.0",
               "each quarter: a block, a flat plate; a sheet seen edge-on; a rod seen end-on",
               ask_aligned);
}

static inline void draw_silhouette(const options *o)
{
    draw_cells(o, "09_aabb_silhouette.png", 2,
               "right and down: the next real number of o.x and of o.y", NULL, ask_silhouette);
}

#endif
