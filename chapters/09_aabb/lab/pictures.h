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
#include "../../../common/lab/panels.h"
#include "../../02_camera/camera.h"
#include "exact.h"
#include "slabs.h"

/* ---- the room ---- */

enum { room_boxes = 17, room_parts = 2 + aabb_mine };
typedef struct { aabb_test *test; camera view; int width, height; } aabb_room;

static const real room_box[room_boxes][6] = {  /* in quarters; last a screen, a picture and a box */
    {0, 0, 0, 24, 24, 0}, {0, 0, 0, 0, 24, 16}, {0, 0, 0, 24, 0, 16},     /* floor, walls */
    {0, 3, 5, 3, 11, 5}, {0, 3, 8, 3, 11, 8}, {0, 3, 11, 3, 11, 11},      /* boards */
    {1, 14, 0, 6, 20, 3}, {1, 14, 3, 3, 20, 6},                           /* a seat */
    {8, 8, 4, 15, 14, 4}, {8, 8, 0, 9, 9, 4}, {14, 8, 0, 15, 9, 4},       /* a flat table, */
    {8, 13, 0, 9, 14, 4}, {14, 13, 0, 15, 14, 4}, {10, 10, 4, 12, 12, 6}, /* a box on it, */
    {17, 1, 0, 17, 7, 7}, {19, 0.5, 5, 23, 0.5, 10}, {16, 16, 0, 20, 20, 4}};

/* ---------------------------------------------------------------------------------------------- */

/* The normal of the face that p lies on. */
static inline vec3 face_normal(aabb b, vec3 p)
{
    vec3 off = vmin(vabs(vsub(p, b.lo)), vabs(vsub(p, b.hi)));
    int k = off.x <= off.y && off.x <= off.z ? 0 : off.y <= off.z ? 1 : 2;
    return vwith(vec(0, 0, 0), k, 1);
}

static vec3 aabb_room_colour(const void *context, real x, real y)
{
    const aabb_room *s = context;
    ray r = camera_ray(s->view, x, y, s->width, s->height);
    vec3 c = vec(0.03, 0.04, 0.07);
    for (int i = 0; i < room_boxes; i++) {
        const real *q = room_box[i];
        aabb b = {{q[0] / 4, q[1] / 4, q[2] / 4}, {q[3] / 4, q[4] / 4, q[5] / 4}};
        real t;
        if (!s->test(b, r, &t) || t > r.tmax) continue;
        r.tmax = t;
        vec3 painted = vec(i % 3 == 0 ? 0.85 : 0.45, 0.55, i % 3 == 2 ? 0.85 : 0.5);
        if (i < 3) painted = vec(0.75, 0.72, 0.66);
        c = vmul(painted, headlight(face_normal(b, ray_at(r, t)), r.d));
    }
    return c;
}

cold_inline void draw_room(const options *o)
{
    panels_shape g = {o->width, o->height, room_parts, 1, o->width >= 64 ? 6 : 0, 2, true};
    const int w = panels_wide(g), h = o->height;
    const camera v = camera_at(vec(13, 15, 8), vec(2.4, 2.4, 0.9), vec(0, 0, 1), 27,
                               (real)w / (real)h);
    const aabb_room s[3] = {{first_aabb_hit, v, w, h}, {aabb_hit, v, w, h},
                            {mine_aabb_hit, v, w, h}};
    const panel p[3] = {{"first_aabb_hit", &s[0]}, {"aabb_hit", &s[1]}, {"mine", &s[2]}};
    panels_draw(o, "09_aabb.png", true, g, aabb_room_colour, p);
}

/* ---- rays along an axis ---- */

enum { cell_count = 64, cell_size = 4, cell_columns = 3 + aabb_mine };
/* Hit, miss, a hit that is lost, a false alarm: linear light of blue, grey, red, yellow. */
static const struct { vec3 colour; const char *name; } cell_key[4] = {
    {{0, 0.168, 0.445}, "hit"}, {{0.8, 0.8, 0.8}, "miss"},
    {{0.665, 0.112, 0}, "a hit that is lost"}, {{0.871, 0.776, 0.054}, "a false alarm"}};

/* Cell (i, j) of a panel: does the ray meet any of four boxes? Along -z, d.x = +0.0 on the left
 * and -0.0 on the right, d.y = +0.0 above and -0.0 below: four times a block, a plate of no
 * thickness, a sheet seen edge-on and a rod seen end-on. */
static vec3 cell_seen(const void *context, real px, real py)
{
    static const int b[4][6] = {{4, 4, 0, 14, 14, 5}, {18, 4, 3, 28, 14, 3},
                                {4, 20, 0, 28, 20, 5}, {16, 26, 0, 16, 26, 5}};
    aabb_test *const *test = context;
    int i = (int)px / cell_size, j = (int)py / cell_size, half = cell_count / 2;
    int x = i / half * half, y = j / half * half;
    ray r = ray_from(vec(i, j, 9), vec(i < half ? 0.0 : -0.0, j < half ? 0.0 : -0.0, -1));
    bool answer = false, truth = false;
    for (int k = 0; k < 4; k++) {
        aabb box = {vec(x + b[k][0], y + b[k][1], b[k][2]), vec(x + b[k][3], y + b[k][4], b[k][5])};
        real t;
        truth |= exact_aabb(box, r).hit;
        answer |= (*test)(box, r, &t);
    }
    return cell_key[truth == answer ? !truth : truth ? 2 : 3].colour;
}

cold_inline void draw_aligned(const options *o)
{
    static aabb_test *const test[] = {first_aabb_hit, aabb_hit_closed, aabb_hit, mine_aabb_hit};
    const panel p[] = {{"first", &test[0]}, {"closed, <=", &test[1]}, {"aabb_hit", &test[2]},
                       {"mine", &test[3]}};
    const int side = cell_count * cell_size, gap = 10;
    const vec3 black = {0, 0, 0};
    bool whole;
    image im = panels_new(o, (panels_shape){cell_columns * (side + gap) - gap, side, cell_columns,
                                            1, gap, 1, false}, cell_seen, p, &whole);
    label_below(&im, 84);
    double middle = im.width / 2.0;
    int y = im.height - 84;
    label_text(&im, middle, y + 22, 10, 0.5, black,
               "left half d.x = +0.0, right -0.0; upper half d.y = +0.0, lower -0.0");
    label_text(&im, middle, y + 44, 10, 0.5, black,
               "each quarter: a block, a flat plate; a sheet seen edge-on; a rod seen end-on");
    for (int k = 0, x = 20; k < 4; k++, x += 195) {
        label_fill(&im, x, y + 60, 16, 16, cell_key[k].colour);
        label_text(&im, x + 24, y + 73, 11, 0, black, cell_key[k].name);
    }
    output_picture(o, &im, "09_aabb_aligned.png", false, whole);
    image_free(&im);
}

#endif
