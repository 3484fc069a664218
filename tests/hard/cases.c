/* cases.c: the catalogue of hard cases: `make hard-cases` builds and runs it, in double and float.
 *
 * One table over the chapters. A row: what is tried and how often; who knows the truth; how many
 * answers the first version (first.h, or the textbook's way) gets wrong, and how many the default.
 * Where the last column says 0, none may be wrong: otherwise the program ends with 1. Inputs and
 * oracles are those of the chapters' own laboratories; each row is explained in tests/README.md. */
#include "../../chapters/03_sphere/lab/sphere_survey.h"
#include "../../chapters/04_triangle/first.h"
#include "../../chapters/04_triangle/lab/needles.h"
#include "../../chapters/05_implicit/lab/implicit_trials.h"
#include "../../chapters/06_csg/lab/csg_survey.h"
#include "../../chapters/07_mesh/lab/trials.h"
#include "../../chapters/08_object_order/lab/orders_draw.h"
#include "../../chapters/09_aabb/lab/mantissa.h"
#include "../../chapters/09_aabb/lab/slabs.h"
#include "../../chapters/17_compare/contenders.h"
#include "../../chapters/09_aabb/trials/torture.h"
#include "../../chapters/18_shade/lab/departures.h"
#include "../../common/lab/table.h"

typedef struct { size_t tried, first, now; } hard_count;
typedef struct {
    const char *chapter, *name, *how, *oracle;
    hard_count (*count)(int k, real x);
    int k;
    real x;
    enum { IN_DOUBLE, PROMISED } zero;   /* that the default has none wrong */
} hard_case;

static bool is_promised(const hard_case *c)
{
    return c->zero >= (real_is_float ? PROMISED : IN_DOUBLE);
}

static const uint64_t seed = 18;

/* k: a sphere_how; x: distance in radii. */
static hard_count spheres(int k, real x)
{
    hard_count c = {20000, 0, 0};
    for (size_t i = 0; i < c.tried; i++) {
        sphere_shot s = sphere_shot_at(seed, (sphere_how)k, x, i);
        bool due = sphere_clearance(s.ball, s.r) <= 0;
        hit h;
        s.r.tmin = -real_infinity;
        c.first += first_sphere_hit(s.ball, s.r, &h) != due;
        c.now += sphere_hit(s.ball, s.r, &h) != due;
    }
    return c;
}

/* k: 0 at edges, 1 at corners; x: where the mesh is. */
static hard_count seams(int k, real x)
{
    icosphere m = icosphere_new(3, vec(x, -x, x / 3), 1);
    hard_count c = {200000, slips(&m, first_triangle_hit, k, 200000, seed).slips,
                    slips(&m, triangle_hit, k, 200000, seed).slips};
    icosphere_free(&m);
    return c;
}

/* x: width. */
static hard_count slivers(int k, real x)
{
    (void)k;
    triangle_needle_count now = needles(triangle_hit, (double)x, 20000, seed);
    return (hard_count){now.due, needles(first_triangle_hit, (double)x, 20000, seed).missed,
                        now.missed};
}

/* k: surface; x: 1 grazing. Missed first roots, and hits where nothing is. */
static hard_count surfaces(int k, real x)
{
    enum { n = 2000 };
    static const implicit_how how[2] = {{IMPLICIT_FIRST, 128, 0}, {IMPLICIT_INTERVAL, 0, 0}};
    implicit_subject u = implicit_subject_of((implicit_name)k);
    double wrong[2];
    size_t unsure = 0;
    for (int i = 0; i < 2; i++) {
        implicit_aim aim = x > 0 ? IMPLICIT_GRAZING : IMPLICIT_ANYWHERE;
        implicit_survey s = implicit_survey_of(&u, how[i], seed, aim, n, 1);
        wrong[i] = floor((s.missed + s.made_up) * n / 100 + 0.5), unsure = s.unsure;
    }
    return (hard_count){n - unsure, (size_t)wrong[0], (size_t)wrong[1]};
}

/* k: a csg_sight_kind. Where faces coincide, the textbook computes planes from corners; where walls
 * are thin, it has a tolerance. */
static hard_count solids(int k, real x)
{
    enum { n = 4000 };
    csg_sight s = csg_sight_of((csg_sight_kind)k, seed);
    csg_hit_function *textbook = k == CSG_FOILS ? csg_hit_tolerant
                                 : k >= CSG_COINCIDENT ? csg_hit_points : csg_hit_front;
    double first = csg_wrong(&s, textbook, n), now = csg_wrong(&s, csg_hit, n);
    (void)x;
    csg_sight_free(&s);
    first = floor(first * n / 100 + 0.5), now = floor(now * n / 100 + 0.5);  /* were percent */
    return (hard_count){n, (size_t)first, (size_t)now};
}

/* Gears of polygons, or k: with sides of triangles; x: how far away. */
static hard_count gears(int k, real x)
{
    enum { wheels = 4, rays = 500 };
    hard_count c = {wheels * rays, 0, 0};
    gear_box *b = allocate(1, sizeof *b);
    for (uint64_t i = 0; i < wheels; i++) {
        random_stream s = random_start(seed, i, 0), t, u;
        gear_box_fill(b, &s, x, k);
        t = u = s;
        c.first += gear_box_slips(b, &t, rays, true), c.now += gear_box_slips(b, &u, rays, false);
    }
    free(b);
    return c;
}

/* Pixels of a picture by object order that no ray near their middle explains. x: width. */
static hard_count drawn(int k, real x)
{
    int nx = (int)x, ny = nx * 3 / 4;
    mesh m = orders_scene(k, false);
    camera c = orders_camera((real)4 / 3);
    raster due = raster_new(nx, ny), now = raster_new(nx, ny), first = orders_first(&m, c, nx, ny);
    (void)orders_rays(&due, &m, c, 0);
    raster_mesh(&now, &m, c, raster_default);
    hard_count n = {(size_t)(nx * ny), orders_compare(&first, &due, &m, c, 8).unexplained,
                    orders_compare(&now, &due, &m, c, 8).unexplained};
    raster_free(&due), raster_free(&now), raster_free(&first), mesh_free(&m);
    return n;
}

/* k: an aabb_trial_kind, or all digits. Boxes that are hit, and lost. */
static hard_count boxes(int k, real x)
{
    hard_count c = {0, 0, 0};
    (void)x;
    for (size_t i = 0; i < 50000; i++) {
        bool full = k == trial_kinds;
        aabb_trial t = full ? aabb_full_trial_of(TRIAL_CORNER, seed, i)
                            : aabb_trial_of((aabb_trial_kind)k, seed, i);
        real enter;
        if (!(full ? wide_aabb(t.b, t.r).hit : exact_aabb(t.b, t.r).hit)) continue;
        c.tried++;
        c.first += !first_aabb_hit(t.b, t.r, &enter), c.now += !aabb_hit(t.b, t.r, &enter);
    }
    return c;
}

/* Wrong answers of a contender to one class, by exact arithmetic. */
static size_t tortured(const contender *c, const torture *t)
{
    failure f;
    contender_settings usual = {.n = 0};
    items x = items_of_mesh(&t->m);
    size_t wrong = 0;
    void *s = contender_build(c, &usual, &x, SIZE_MAX, &f);
    if (!s) fail(f);
    for (size_t i = 0; i < t->n; i++) {
        hit h = hit_none;
        double error;
        c->hit(s, t->r[i], &h);
        wrong += torture_judge(t, i, h, &error) != TORTURE_RIGHT;
    }
    contender_free(c, s);
    return wrong;
}

/* One class, in the BVH. */
static hard_count torture_of_class(int k, real x)
{
    torture t = torture_make(k, 2000, seed);
    hard_count c = {t.n, tortured(&first_bvh_contender, &t), tortured(&bvh_contender, &t)};
    (void)x;
    torture_free(&t);
    return c;
}

/* All classes, in structure k. */
static hard_count torture_of_structure(int k, real x)
{
    static const contender *const by[][2] = {
        {&first_grid_contender, &grid_contender}, {&first_octree_contender, &octree_contender},
        {&first_kdtree_contender, &kdtree_contender}, {&first_bsp_contender, &bsp_contender},
        {&first_bvh_contender, &wide_contender}};
    hard_count c = {0, 0, 0};
    (void)x;
    for (int i = 0; i < torture_classes; i++) {
        torture t = torture_make(i, 500, seed);
        c.tried += t.n, c.first += tortured(by[k][0], &t), c.now += tortured(by[k][1], &t);
        torture_free(&t);
    }
    return c;
}

enum { way_first = 1, way_now = leavings - 1 };

/* k: a departure_kind; x: how far from the origin. Hits of one's own surface. */
static hard_count acne(int k, real x)
{
    hard_count c = {2000, 0, 0};
    for (size_t i = 0; i < c.tried; i++) {
        departure d;
        departure_make(&d, (departure_kind)k, 1, x, seed, i);
        c.first += departure_self(&d, ways[way_first]), c.now += departure_self(&d, ways[way_now]);
    }
    return c;
}

/* The same rays: plates just above the surface that are missed. */
static hard_count leaks(int k, real x)
{
    hard_count c = {2000, 0, 0};
    for (size_t i = 0; i < c.tried; i++) {
        departure d;
        departure_make(&d, (departure_kind)k, 1, x, seed, i);
        real gap = departure_gap(&d);
        c.first += departure_leak(&d, ways[way_first], gap);
        c.now += departure_leak(&d, ways[way_now], gap);
    }
    return c;
}

#define WIDE "30 digits"
#define WHOLE "whole numbers"
static const hard_case list[] = {
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
    {"06", "foils", "thin walls that must stay", "Boolean", solids, CSG_FOILS, 0, PROMISED},
    {"07", "gear", "polygons of 144 corners, seams", "closed", gears, 0, 0, PROMISED},
    {"07", "gear, far", "1000 radii off", "closed", gears, 0, 1000, PROMISED},
    {"07", "gear, triangles", "polygons beside triangles", "closed", gears, 1, 0, PROMISED},
    {"08", "drawn, twins", "triangles in one place", "rays", drawn, 1, 96, IN_DOUBLE},
    {"08", "drawn, 994", "994 triangles", "rays", drawn, 4, 96, PROMISED},
    {"09", "in a plane", "o on a face, along it", WHOLE, boxes, TRIAL_PARALLEL, 0, PROMISED},
    {"09", "flat box", "a side of length 0", WHOLE, boxes, TRIAL_FLAT, 0, PROMISED},
    {"09", "edge", "one point of an edge", WHOLE, boxes, TRIAL_EDGE, 0, PROMISED},
    {"09", "corner", "three planes at one t", WHOLE, boxes, TRIAL_CORNER, 0, PROMISED},
    {"09", "contact", "interval ends where it enters", WHOLE, boxes, TRIAL_CONTACT, 0, PROMISED},
    {"09", "any", "any box, any ray", WHOLE, boxes, TRIAL_ANY, 0, PROMISED},
    {"09", "all digits", "corners, all digits in use", WIDE, boxes, trial_kinds, 0, PROMISED},
    {"10", "grid", "all classes of 17", WHOLE, torture_of_structure, 0, 0, PROMISED},
    {"11", "octree", "all classes of 17", WHOLE, torture_of_structure, 1, 0, PROMISED},
    {"12", "k-d tree", "all classes of 17", WHOLE, torture_of_structure, 2, 0, PROMISED},
    {"13", "BSP tree", "all classes of 17", WHOLE, torture_of_structure, 3, 0, PROMISED},
    {"15", "wide tree", "all classes of 17", WHOLE, torture_of_structure, 4, 0, PROMISED},
    {"18", "acne, sphere", "leaving a shape of size 1", "convex", acne, DEPART_SPHERE, 0, PROMISED},
    {"18", "acne, triangle", "the same", "convex", acne, DEPART_TRIANGLE, 0, PROMISED},
    {"18", "acne, needle", "the same", "convex", acne, DEPART_NEEDLE, 0, PROMISED},
    {"18", "acne, cone", "the same", "convex", acne, DEPART_CONE, 0, PROMISED},
    {"18", "acne, polygon", "the same", "convex", acne, DEPART_POLYGON, 0, PROMISED},
    {"18", "acne, sphere far", "1e6 away", "convex", acne, DEPART_SPHERE, (real)1e6, PROMISED},
    {"18", "acne, triangle far", "1e6 away", "convex", acne, DEPART_TRIANGLE, (real)1e6, PROMISED},
    {"18", "acne, polygon far", "1e6 away", "convex", acne, DEPART_POLYGON, (real)1e6, PROMISED},
    {"18", "leak, sphere", "a plate 1e-6 above", "plate", leaks, DEPART_SPHERE, 0, PROMISED},
    {"18", "leak, triangle", "the same", "plate", leaks, DEPART_TRIANGLE, 0, PROMISED},
    {"18", "leak, triangle far", "1e6 away", "plate", leaks, DEPART_TRIANGLE, (real)1e6, PROMISED},
};

static size_t add(table *t, const hard_case *c)
{
    hard_count n = c->count(c->k, c->x);
    table_text(t, "%s", c->chapter), table_text(t, "%s", c->name), table_text(t, "%s", c->how);
    table_text(t, "%s", c->oracle), table_count(t, n.tried), table_count(t, n.first);
    table_count(t, n.now), table_text(t, is_promised(c) ? "0" : "-");
    return is_promised(c) ? n.now : 0;
}

int main(void)
{
    size_t broken = 0;
    table t = table_new("Hard cases", "chapter|case|how|oracle|tried|first: wrong|default: wrong|"
                                      "promised");
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) broken += add(&t, &list[i]);
    for (int k = 0; k < torture_classes; k++)
        broken += add(&t, &(hard_case){"17", torture_list[k].name, torture_list[k].what, WHOLE,
                                       torture_of_class, k, 0, PROMISED});
    printf("# %s, real = %s\n", t.title, real_is_float ? "float" : "double");
    table_print(&t, stdout);
    table_free(&t);
    printf("# %zu cases, %zu wrong where 0 is promised\n",
           sizeof list / sizeof *list + torture_classes, broken);
    return broken > 0;
}
