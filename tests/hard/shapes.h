/* shapes.h: hard cases of 01 to 08: rays, cameras, and what a ray meets alone. */
#ifndef HARD_SHAPES_H
#define HARD_SHAPES_H

#include "hard.h"
#include "../../chapters/01_ray/lab/points.h"
#include "../02_oracle.h"
#include "../../chapters/03_sphere/lab/sphere_measure.h"
#include "../../chapters/04_triangle/first.h"
#include "../../chapters/04_triangle/lab/triangle_trials.h"
#include "../../chapters/05_implicit/lab/implicit_trials.h"
#include "../../chapters/06_csg/lab/csg_measure.h"
#include "../07_trials.h"
#include "../../chapters/08_object_order/lab/orders_draw.h"

/* ---------------------------------------------------------------------------------------------- */

/* k: 0 by two points (1.1) beside ray_at, t = x; 1: the way from c, where the origin is x away:
 * ray_at and then - c, beside a ray that begins at o - c. Wrong: off by more than four roundings
 * of the way that is asked for. */
static inline hard_count points(int k, real x)
{
    hard_count n = {5000, 0, 0};
    for (size_t i = 0; i < n.tried; i++) {
        ray_line l = ray_line_at(hard_seed, i, k ? 1 : 100);
        if (!k) {
            double most = 4 * hard_eps * (100 + (double)x);
            n.first += ray_error(RAY_BETWEEN, &l, x) > most;
            n.now += ray_error(RAY_FIRST, &l, x) > most;
            continue;
        }
        random_stream s = random_start(hard_seed, i, 1);
        vec3 c = vscale(hard_unit(&s), x), o = vadd(c, l.o), from = vsub(o, c);
        real t = random_next(&s);
        wide3 due = wide3_madd(wide3_sub(wide3_of(o), wide3_of(c)), wide3_of(l.d),
                               wide_of((double)t));
        vec3 is[2] = {vsub(ray_at(ray_from(o, l.d), t), c), ray_at(ray_from(from, l.d), t)};
        double off[2];
        for (int j = 0; j < 2; j++)
            off[j] = wide_value(wide3_length(wide3_sub(wide3_of(is[j]), due)));
        n.first += off[0] > 8 * hard_eps, n.now += off[1] > 8 * hard_eps;
    }
    return n;
}

/* Rays of a camera x away from the origin of the world (in double as many roundings away): s - e,
 * with s = e + d, beside (2.5). Wrong: by more than 1/100 of a pixel of 640. */
static inline hard_count windows(int k, real x)
{
    hard_count n = {5000, 0, 0};
    (void)k;
    for (size_t i = 0; i < n.tried; i++) {
        random_stream s = random_start(hard_seed, i, 0);
        vec3 e = vscale(hard_unit(&s), x * (real)((double)FLT_EPSILON / hard_eps));
        camera_frame f;
        failure why;
        vec3 up = hard_unit(&s), to = hard_unit(&s);
        if (!frame_look_at((vec3){0, 0, 0}, to, up, &f, &why)) fail(why);
        camera c = {CAMERA_PERSPECTIVE, e, f.u, f.v, f.w, -1, 1, (real)-0.75, (real)0.75, 1,
                    {0, 0, 0}};
        real px = 640 * random_next(&s), py = 480 * random_next(&s);
        vec3 d = camera_ray(c, px, py, 640, 480).d;
        n.first += camera_error(c, vsub(vadd(e, d), e), px, py, 640, 480) > 0.01;
        n.now += camera_error(c, d, px, py, 640, 480) > 0.01;
    }
    return n;
}

/* x: the angle between up and the view. Wrong: right is off by more than 6 epsilon; or, x = 0, up
 * along the view, where no frame is right, there is one. */
static inline hard_count ups(int k, real x)
{
    hard_count n = {2000, 0, 0};
    (void)k;
    for (size_t i = 0; i < n.tried; i++) {
        random_stream s = random_start(hard_seed, i, 0);
        real far = 1 + 99 * random_next(&s);
        vec3 view = vscale(hard_unit(&s), far), e = {0, 0, 0}, a, b;
        vbasis(vunit(view), &a, &b);
        vec3 up = x > 0 ? vmadd(vunit(view), a, x) : vscale(view, random_next(&s) - (real)0.5);
        camera_frame f, g = frame_first(e, view, up);
        failure why;
        bool built = frame_look_at(e, view, up, &f, &why);
        n.first += x > 0 ? !(frame_error(g, view, up) <= 6 * hard_eps) : true;
        n.now += x > 0 ? !built || !(frame_error(f, view, up) <= 6 * hard_eps) : built;
    }
    return n;
}

/* k: a sphere_how; x: distance in radii. */
static inline hard_count spheres(int k, real x)
{
    hard_count c = {20000, 0, 0};
    for (size_t i = 0; i < c.tried; i++) {
        sphere_shot s = sphere_shot_at(hard_seed, (sphere_how)k, x, i);
        bool due = sphere_clearance(s.ball, s.r) <= 0;
        hit h;
        s.r.tmin = -real_infinity;
        c.first += first_sphere_hit(s.ball, s.r, &h) != due;
        c.now += sphere_hit(s.ball, s.r, &h) != due;
    }
    return c;
}

/* k: 0 at edges, 1 at corners; x: where the mesh is. */
static inline hard_count seams(int k, real x)
{
    icosphere m = icosphere_new(3, vec(x, -x, x / 3), 1);
    hard_count c = {200000, slips(&m, first_triangle_hit, k, 200000, hard_seed).slips,
                    slips(&m, triangle_hit, k, 200000, hard_seed).slips};
    icosphere_free(&m);
    return c;
}

/* x: width. */
static inline hard_count slivers(int k, real x)
{
    (void)k;
    triangle_needle_count now = triangle_needles(triangle_hit, (double)x, 20000, hard_seed);
    triangle_needle_count first = triangle_needles(first_triangle_hit, (double)x, 20000, hard_seed);
    return (hard_count){now.due, first.missed, now.missed};
}

/* k: surface; x: 1 grazing. Missed first roots, and hits where nothing is. */
static inline hard_count surfaces(int k, real x)
{
    enum { n = 2000 };
    static const implicit_how how[2] = {{IMPLICIT_FIRST, 128, 0}, {IMPLICIT_INTERVAL, 0, 0}};
    implicit_subject u = implicit_subject_of((implicit_name)k);
    double wrong[2];
    size_t unsure = 0;
    for (int i = 0; i < 2; i++) {
        implicit_aim aim = x > 0 ? IMPLICIT_GRAZING : IMPLICIT_ANYWHERE;
        implicit_survey s = implicit_survey_of(&u, how[i], hard_seed, aim, n, 1);
        wrong[i] = floor((s.missed + s.made_up) * n / 100 + 0.5), unsure = s.unsure;
    }
    return (hard_count){n - unsure, (size_t)wrong[0], (size_t)wrong[1]};
}

/* k: a csg_sight_kind. Where faces coincide, the textbook computes planes from corners; where walls
 * are thin, it has a tolerance. */
static inline hard_count solids(int k, real x)
{
    enum { n = 4000 };
    csg_sight s = csg_sight_of((csg_sight_kind)k, hard_seed);
    const csg_way way[2] = {{k >= CSG_COINCIDENT ? csg_hit_tolerant : csg_hit_front,
                             k == CSG_FOILS ? 0.003 : -1, true}, {csg_hit, 0, false}};
    double wrong[2];
    csg_wrong(&s, way, 2, n, wrong);
    (void)x;
    csg_scene_free(&s.scene);
    for (int i = 0; i < 2; i++) wrong[i] = floor(wrong[i] * n / 100 + 0.5);  /* were percent */
    return (hard_count){n, (size_t)wrong[0], (size_t)wrong[1]};
}

/* Gears of polygons, or k: with sides of triangles; x: how far away. */
static inline hard_count gears(int k, real x)
{
    enum { wheels = 4, rays = 500 };
    hard_count c = {wheels * rays, 0, 0};
    gear_box *b = allocate(1, sizeof *b);
    for (uint64_t i = 0; i < wheels; i++) {
        random_stream s = random_start(hard_seed, i, 0), t, u;
        gear_box_fill(b, &s, x, k);
        t = u = s;
        c.first += gear_box_slips(b, &t, rays, true), c.now += gear_box_slips(b, &u, rays, false);
    }
    free(b);
    return c;
}

/* k: a cone_aim; x: distance. A cone, by the quadratic as it stands, and by cone_hit. */
static inline hard_count cones(int k, real x)
{
    hard_count n = {0, 0, 0};
    for (int kind = 0; kind < cone_kind_count; kind++) {
        real thin = 1 / real_max(fabs(cone_kinds[kind].ra), fabs(cone_kinds[kind].rb));
        random_stream s = random_start(hard_seed, (uint64_t)kind, (uint64_t)k);
        cone_score c = cone_play(&s, kind, (cone_aim)k, x, 1000, 64 * (double)thin);
        n.tried += c.decided, n.first += c.wrong[0], n.now += c.wrong[1];
    }
    return n;
}

/* k: an inside_aim. Points in a ring, by hits and by crossings. */
static inline hard_count insides(int k, real x)
{
    mesh m = torus_mesh(24);
    random_stream s = random_start(hard_seed, (uint64_t)k, 0);
    inside_score c = inside_play(&m, &s, (inside_aim)k, 1000);
    (void)x;
    mesh_free(&m);
    return (hard_count){1000, c.wrong[0], c.wrong[2]};
}

/* Pixels of a picture by object order that no ray near their middle explains. x: width. */
static inline hard_count drawn(int k, real x)
{
    int nx = (int)x, ny = nx * 3 / 4;
    mesh m = orders_scene(k);
    camera c = orders_camera((real)4 / 3);
    raster due = raster_new(nx, ny), now = raster_new(nx, ny), first = orders_first(&m, c, nx, ny);
    (void)orders_rays(&due, &m, c, 0);
    raster_mesh(&now, &m, c, raster_default);
    hard_count n = {(size_t)(nx * ny), orders_compare(&first, &due, &m, c, 8).unexplained,
                    orders_compare(&now, &due, &m, c, 8).unexplained};
    raster_free(&due), raster_free(&now), raster_free(&first), mesh_free(&m);
    return n;
}

/* ---- triangles of 08 one by one, before a window of 32 x 32 units at distance 1 ---- */

enum { tiles_side = 32 };

static inline void tile_by_first(triangle t, hit *out)
{
    first_camera c = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0, tiles_side, 0, tiles_side, 1,
                      tiles_side, tiles_side};
    first_raster s = first_raster_new(tiles_side, tiles_side);
    first_raster_mesh(&s, &(first_mesh){&t, 1}, c);
    memcpy(out, s.h, tiles_side * tiles_side * sizeof *out);
    first_raster_free(&s);
}

static inline void tile_by_raster(triangle t, hit *out)
{
    uint32_t index[3] = {0, 1, 2};
    mesh m = {.v = &t.a, .vertices = 3, .index = index, .triangles = 1};
    camera c = {CAMERA_PERSPECTIVE, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0, tiles_side, 0,
                tiles_side, 1, {0, 0, 0}};
    raster s = raster_new(tiles_side, tiles_side);
    raster_mesh(&s, &m, c, raster_default);
    memcpy(out, s.h, tiles_side * tiles_side * sizeof *out);
    raster_free(&s);
}

/* The window cut into tiles of two triangles, with corners moved by up to a quarter of a tile; x:
 * a tile's side [pixels]. k: 1: corners on middles and borders of pixels. Wrong: a pixel that is
 * not drawn just once. */
static inline hard_count tilings(int k, real x)
{
    enum { pixels = tiles_side * tiles_side };
    hard_count n = {pixels, 0, 0};
    int across = (int)(tiles_side / x), drawn[2][pixels] = {{0}, {0}};
    hit h[2][pixels];
    vec3 *v = allocate((size_t)((across + 1) * (across + 1)), sizeof *v);
    for (int i = 0; i < (across + 1) * (across + 1); i++) {
        random_stream s = random_start(hard_seed, (uint64_t)i, (uint64_t)k);
        int c = i % (across + 1), r = i / (across + 1);
        real dx = random_next(&s) - (real)0.5, dy = random_next(&s) - (real)0.5;
        v[i] = (vec3){x * ((real)c + (c % across ? dx / 2 : 0)),
                      x * ((real)r + (r % across ? dy / 2 : 0)), -1};
        if (k) v[i] = vscale((vec3){round(2 * v[i].x), round(2 * v[i].y), -2}, (real)0.5);
    }
    for (int i = 0; i < 2 * across * across; i++) {
        const vec3 *q = v + i / 2 / across * (across + 1) + i / 2 % across;
        triangle t = i % 2 ? (triangle){q[1], q[across + 2], q[across + 1]}
                           : (triangle){q[0], q[1], q[across + 1]};
        tile_by_first(t, h[0]), tile_by_raster(t, h[1]);
        for (int j = 0; j < 2 * pixels; j++)
            drawn[j / pixels][j % pixels] += h[j / pixels][j % pixels].shape != no_shape;
    }
    for (int j = 0; j < pixels; j++) n.first += drawn[0][j] != 1, n.now += drawn[1][j] != 1;
    free(v);
    return n;
}

/* Does r pass so near to an edge of t that 1/256 of a pixel decides? The volumes of (4.12). */
static inline bool tile_near_edge(triangle t, ray r)
{
    real e[3] = {vdot(r.d, vcross(t.a, t.b)), vdot(r.d, vcross(t.b, t.c)),
                 vdot(r.d, vcross(t.c, t.a))};
    real least = (real)0.05 * (fabs(e[0]) + fabs(e[1]) + fabs(e[2]));
    return fabs(e[0]) < least || fabs(e[1]) < least || fabs(e[2]) < least;
}

/* k: 0: triangles at a slant; 1: with a corner behind the eye. Wrong: a pixel that is not hit as
 * its ray is, or 2 % nearer or farther. */
static inline hard_count slants(int k, real x)
{
    hard_count n = {0, 0, 0};
    (void)x;
    for (size_t i = 0; i < 100; i++) {
        random_stream s = random_start(hard_seed, i, (uint64_t)k);
        vec3 v[3];
        for (int j = 0; j < 3; j++) {
            real z = 1 + 8 * random_next(&s), u = 1 + 30 * random_next(&s);
            v[j] = (vec3){z * u, z * (1 + 30 * random_next(&s)), k && j == 0 ? z : -z};
        }
        triangle t = {v[0], v[1], v[2]};
        hit h[2][tiles_side * tiles_side];
        tile_by_first(t, h[0]), tile_by_raster(t, h[1]);
        for (int p = 0; p < tiles_side * tiles_side; p++) {
            ray r = ray_from((vec3){0, 0, 0}, (vec3){(real)(p % tiles_side) + (real)0.5,
                             (real)(tiles_side - 1 - p / tiles_side) + (real)0.5, -1});
            hit due = hit_none;
            bool wrong[2];
            if (tile_near_edge(t, r)) continue;
            bool is = triangle_hit(t, r, &due);
            for (int j = 0; j < 2; j++) {
                bool got = h[j][p].shape != no_shape;
                wrong[j] = got != is || (is && fabs(h[j][p].t / due.t - 1) > (real)0.02);
            }
            n.tried++, n.first += wrong[0], n.now += wrong[1];
        }
    }
    return n;
}

static const hard_case hard_shapes[] = {
    {"01", "two points, t = 100", "(1 - t) a + t b", WIDE, points, 0, 100, PROMISED},
    {"01", "two points, t = 1e4", "the same", WIDE, points, 0, 10000, PROMISED},
    {"01", "far from the origin", "o + t d seen from near o, 1e6 off", WIDE, points, 1,
     1000000, PROMISED},
    {"02", "window, 1e3 off", "s - e, e 1e3 away (float)", WIDE, windows, 0, 1000, PROMISED},
    {"02", "window, 1e5 off", "the same, 1e5 away", WIDE, windows, 0, 100000, PROMISED},
    {"02", "up, 0.1", "0.1 radians from the view", WIDE, ups, 0, (real)0.1, PROMISED},
    {"02", "up, 1e-4", "the same, 1e-4", WIDE, ups, 0, (real)1e-4, PROMISED},
    {"02", "up = view", "no frame is right", "refused", ups, 0, 0, PROMISED},
    {"03", "limb, 1 R", "tangent but for the last bit", WIDE, spheres, SPHERE_LIMB, 1, PROMISED},
    {"03", "limb, 100 R", "the same", WIDE, spheres, SPHERE_LIMB, 100, PROMISED},
    {"03", "limb, 1e4 R", "the same", WIDE, spheres, SPHERE_LIMB, (real)1e4, PROMISED},
    {"03", "limb, 1e6 R", "the same", WIDE, spheres, SPHERE_LIMB, (real)1e6, PROMISED},
    {"03", "grazing, 100 R", "0.1 % of the limb", WIDE, spheres, SPHERE_GRAZING, 100, PROMISED},
    {"03", "grazing, 1e6 R", "the same", WIDE, spheres, SPHERE_GRAZING, (real)1e6, PROMISED},
    {"04", "edges", "closed mesh, from inside", "closed", seams, 0, 0, PROMISED},
    {"04", "corners", "the same", "closed", seams, 1, 0, PROMISED},
    {"04", "edges, far", "1000 radii off", "closed", seams, 0, 1000, PROMISED},
    {"04", "corners, far", "1000 radii off", "closed", seams, 1, 1000, PROMISED},
    {"04", "needles, 1e-2", "length 1, width 1e-2", WIDE, slivers, 0, (real)1e-2, PROMISED},
    {"04", "needles, 1e-4", "width 1e-4", WIDE, slivers, 0, (real)1e-4, PROMISED},
    {"04", "needles, 1e-6", "width 1e-6", WIDE, slivers, 0, (real)1e-6, IN_DOUBLE},
    {"05", "sphere, grazing", "1e-1 to 1e-10 off", "Sturm", surfaces, IMPLICIT_SPHERE, 1, PROMISED},
    {"05", "torus", "anywhere", "Sturm", surfaces, IMPLICIT_TORUS, 0, PROMISED},
    {"05", "torus, grazing", "1e-1 to 1e-10 off", "Sturm", surfaces, IMPLICIT_TORUS, 1, PROMISED},
    {"05", "Barth", "anywhere: 65 double points", "Sturm", surfaces, IMPLICIT_BARTH, 0, PROMISED},
    {"05", "Barth, grazing", "1e-1 to 1e-10 off", "Sturm", surfaces, IMPLICIT_BARTH, 1, PROMISED},
    {"06", "from outside", "nothing hard", "Boolean", solids, CSG_OUTSIDE, 0, PROMISED},
    {"06", "eye inside", "from within a solid", "Boolean", solids, CSG_EYE_INSIDE, 0, PROMISED},
    {"06", "coincident", "faces in one plane", "Boolean", solids, CSG_COINCIDENT, 0, PROMISED},
    {"06", "coincident, far", "far from the origin", "Boolean", solids, CSG_FAR_AWAY, 0, PROMISED},
    {"06", "faces of a mesh", "planes of boxes", "Boolean", solids, CSG_MESH_FACES, 0, PROMISED},
    {"06", "foils", "thin walls that must stay", "Boolean", solids, CSG_FOILS, 0, PROMISED},
    {"07", "gear", "polygons of 144 corners, seams", "closed", gears, 0, 0, PROMISED},
    {"07", "gear, far", "1000 radii off", "closed", gears, 0, 1000, PROMISED},
    {"07", "gear, triangles", "polygons beside triangles", "closed", gears, 1, 0, PROMISED},
    {"07", "cone, grazing", "0.1 % of the side, from 1e4", WIDE, cones, AIM_GRAZING, 10000,
     PROMISED},
    {"07", "cone, along it", "a ray nearly along the side", WIDE, cones, AIM_ALONG_SIDE, 100,
     PROMISED},
    {"07", "inside, edges", "a ring; the ray leaves by an edge", "ring", insides, AT_EDGE, 0,
     PROMISED},
    {"07", "inside, vertices", "and by a vertex", "ring", insides, AT_VERTEX, 0, PROMISED},
    {"08", "seams", "edges through middles of pixels", "closed", tilings, 1, 4, PROMISED},
    {"08", "specks", "tiles of 1/2 pixel", "closed", tilings, 0, (real)0.5, PROMISED},
    {"08", "slanted", "depth at a slant", "rays", slants, 0, 0, PROMISED},
    {"08", "behind the eye", "one corner is there", "rays", slants, 1, 0, PROMISED},
    {"08", "drawn, twins", "triangles in one place", "rays", drawn, 1, 96, IN_DOUBLE},
    {"08", "drawn, 994", "994 triangles", "rays", drawn, 4, 96, PROMISED},
};

#endif
