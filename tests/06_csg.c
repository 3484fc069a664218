/* 06_csg: spans of trees against the Boolean of their parts, faces that coincide, meshes through
 * their edges and corners, bounds that change nothing, depth, strange input, hostile texts. */
#include "../chapters/06_csg/csg.h"
#include "../chapters/06_csg/lab/csg_measure.h"
#include "check.h"

static const double eps = (double)real_epsilon;

static csg built(csg_model m, bool no_bounds)
{
    csg c = {0};
    failure why = {0, ""};
    check(csg_build(m, (csg_options){no_bounds}, &c, &why), "csg_build: %s", why.text);
    return c;
}

/* The first two of the solids joined; CSG_SOLID: the first alone. Others only name planes. */
static csg joined(const csg_solid *s, size_t solids, csg_operation what, bool no_bounds)
{
    const csg_step step[3] = {{CSG_SOLID, 0}, {CSG_SOLID, 1}, {what, 0}};
    return built((csg_model){s, solids, step, what == CSG_SOLID ? 1 : 3}, no_bounds);
}

/* csg_spans into a list that stays until the next call. */
static size_t line_spans(const csg *c, ray r, csg_crossing **list)
{
    static csg_crossing *held;
    static size_t room;
    if (2 * c->room > room) free(held), held = allocate(room = 2 * c->room, sizeof *held);
    return csg_spans(c, r, *list = held);
}

static size_t random_below(random_stream *s, size_t n) { return random_next_bits(s) % n; }

/* ---- random solids and trees ---- */

/* Some solid within some 2 of the origin; gems: of them also octahedra. */
static csg_solid random_solid(random_stream *s, bool gems)
{
    int kind = (int)(random_next(s) * (gems ? 6 : 5));
    vec3 c = random_in_cube(s, 1), d = random_direction_of(s), n[3] = {d};
    real r = (real)0.3 + (real)0.7 * random_next(s), lo[3], hi[3];
    if (random_below(s, 4) == 0) d = vwith(vec(0, 0, 0), (int)random_below(s, 3), 1);
    if (kind == 0) return csg_half(vscale(d, 3 * r), vdot(c, d));
    if (kind == 1) return csg_box(vsub(c, vec(r, r / 2, r)), vadd(c, vec(r, r, r / 2)));
    if (kind == 2) return csg_cylinder(c, vscale(d, 2 * r), r / 2);
    if (kind == 3) {
        vbasis(d, &n[1], &n[2]);
        for (int k = 0; k < 3; k++) lo[k] = vdot(c, n[k]) - r, hi[k] = vdot(c, n[k]) + r / 2;
        return csg_box_turned(n, lo, hi);
    }
    return kind == 5 ? csg_gem(c, r) : csg_sphere(c, r);
}

/* n random solids, joined by random operations, in a random tree; for csg_expression_free. */
static csg_expression random_tree(random_stream *s, size_t n, bool gems)
{
    csg_expression e = {.solid = allocate(n, sizeof *e.solid)};
    size_t waiting = 0;
    e.step = allocate(2 * n, sizeof *e.step);
    while (e.solids < n || waiting > 1) {
        if (waiting > 1 && (e.solids == n || random_next(s) < (real)0.5)) {
            e.step[e.steps++].what = (csg_operation)(1 + (int)(3 * random_next(s)));
            waiting--;
            continue;
        }
        e.step[e.steps++] = (csg_step){CSG_SOLID, (uint32_t)e.solids};
        e.solid[e.solids++] = random_solid(s, gems);
        waiting++;
    }
    return e;
}

/* A ray that crosses the neighbourhood of the origin; every fourth along an axis. */
static ray random_line(random_stream *s)
{
    vec3 d = random_direction_of(s), to = random_in_cube(s, 1);
    if (random_below(s, 4) == 0) {
        int k = (int)random_below(s, 3);
        d = vwith(vec(0, 0, 0), k, random_below(s, 2) ? 1 : -1);
    }
    real fast = (real)0.25 + random_next(s);
    return ray_from(vmadd(to, d, -4 * random_next(s)), vscale(d, fast));
}

/* ---- lists ---- */

/* Some of the numbers 0 .. 8, an even number of them, rising. */
static size_t random_list(random_stream *s, csg_crossing *x, uint32_t surface)
{
    size_t n = 0;
    for (int t = 0; t < 9; t++)
        if (random_below(s, 2)) x[n++] = (csg_crossing){(real)t, 2 * surface};
    return n & ~(size_t)1;
}

static bool list_holds(const csg_crossing *x, size_t n, real t)
{
    bool in = false;
    for (size_t i = 0; i < n; i++) if (x[i].t < t) in = !in;
    return in;
}

/* Between two whole numbers nothing happens: there the Boolean of both must be the answer. */
static void test_merge(void)
{
    size_t wrong = 0, order = 0, surface = 0, turned = 0, n = check_count(200000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(1, i, 0);
        csg_crossing a[9], b[9], out[18];
        size_t na = random_list(&s, a, 3), nb = random_list(&s, b, 5);
        for (int what = CSG_UNION; what <= CSG_DIFFERENCE; what++) {
            size_t k = spans_merge((csg_operation)what, a, na, b, nb, out);
            for (real t = (real)-0.5; t < 9; t += 1) {
                bool in_a = list_holds(a, na, t), in_b = list_holds(b, nb, t);
                bool due = what == CSG_UNION ? in_a || in_b : what == CSG_INTERSECTION
                    ? in_a && in_b : in_a && !in_b;
                wrong += list_holds(out, k, t) != due;
            }
            order += k % 2;
            for (size_t j = 0; j < k; j++) {
                bool of_a = false, of_b = false;
                for (size_t q = 0; q < na; q++) of_a |= a[q].t == out[j].t;
                for (size_t q = 0; q < nb; q++) of_b |= b[q].t == out[j].t;
                order += j > 0 && !(out[j - 1].t < out[j].t);
                surface += out[j].surface / 2 != (of_a ? 3u : 5u) || (!of_a && !of_b);
                turned += out[j].surface % 2 != (!of_a && what == CSG_DIFFERENCE);
            }
        }
    }
    check_equal(wrong, 0, "between crossings: the Boolean of both, of %zu pairs", n);
    check_equal(order, 0, "an even number of crossings, strictly rising: no span of length 0");
    check_equal(surface, 0, "of two surfaces at one t the lower number");
    check_equal(turned, 0, "surfaces from the right of a difference, and only they, are turned");
}

/* ---- trees against their parts ---- */

typedef struct { size_t wrong, judged, spans, order; } tally;

/* The middles of all spans, of the gaps between, and far out on either side. */
static void judge_line(csg_model m, const csg *c, ray r, tally *y)
{
    csg_crossing *x = NULL;
    size_t n = line_spans(c, r, &x);
    double scale = (double)vlength(r.d);
    y->spans += n / 2, y->order += n % 2;
    for (size_t i = 0; i <= n; i++) {
        double t0 = i > 0 ? fmax((double)x[i - 1].t, -1e3) : -1e3;
        double t1 = i < n ? fmin((double)x[i].t, 1e3) : 1e3, least;
        y->order += i > 0 && i < n && !(x[i - 1].t < x[i].t);
        if ((t1 - t0) * scale < 1e5 * eps) continue;
        bool in = oracle_contains(m, oracle_on(r, (t0 + t1) / 2), &least);
        if (least < 1e3 * eps) continue;  /* a span that runs along a surface */
        y->judged++, y->wrong += in != (i % 2 == 1);
    }
}

static void test_random_trees(void)
{
    tally y = {0};
    size_t n = check_count(1600), lines = 60;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(2, i, 0);
        csg_expression e = random_tree(&s, 1 + random_below(&s, 12), true);
        csg_model m = csg_expression_model(&e);
        csg c = built(m, i % 2);
        for (size_t k = 0; k < lines; k++) judge_line(m, &c, random_line(&s), &y);
        csg_free(&c), csg_expression_free(&e);
    }
    check_equal(y.wrong, 0, "middles of spans and gaps, of %zu, against the parts", y.judged);
    check_equal(y.order, 0, "lists rise, and are even");
    check_at_least((double)y.spans, 0.3 * (double)(n * lines), "the test sees spans");
}

/* A step along the normal leads out of the whole, a step against it, into it. Gems have a test of
 * their own: the oracle cannot tell how near their next edge is. */
static void test_normals(void)
{
    size_t wrong = 0, unit = 0, turned = 0, judged = 0, n = check_count(2000);
    double step = real_is_float ? 1e-4 : 1e-7;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(4, i, 0);
        csg_expression e = random_tree(&s, 1 + random_below(&s, 8), false);
        csg_model m = csg_expression_model(&e);
        csg c = built(m, false);
        for (int k = 0; k < 30; k++) {
            ray r = random_line(&s);
            hit h;
            if (!csg_hit(&c, r, &h)) continue;
            if (vlength(ray_at(r, h.t)) > 10) continue;  /* far: the step is lost in rounding */
            vec3 normal = csg_normal(&c, r, h);
            wide3 p = oracle_on(r, (double)h.t), w = wide3_of(normal);
            double out, in;
            unit += fabs((double)vlength(normal) - 1) > 8 * eps;
            bool is_out = !oracle_contains(m, wide3_madd(p, w, wide_of(step)), &out);
            bool is_in = oracle_contains(m, wide3_madd(p, w, wide_of(-step)), &in);
            if (fmin(out, in) < step / 4) continue;  /* near an edge, where a step meets another */
            judged++, turned += h.shape % 2, wrong += !is_out || !is_in;
        }
        csg_free(&c), csg_expression_free(&e);
    }
    check_equal(wrong, 0, "normals lead out of the whole, of %zu", judged);
    check_equal(unit, 0, "they have length 1");
    check_at_least((double)turned, 0.05 * (double)judged, "turned ones are among them");
    check_at_least((double)judged, (double)n, "the test sees normals");
}

/* ---- the same set, said in two ways ---- */

/* Whether two expressions with A, B, .. for solids 0, 1, .. and + * - in postfix give the same list
 * to the last bit; surfaces also, if `with`. */
static size_t differ(const csg_solid *solid, ray r, const char *one, const char *other, bool with)
{
    csg_crossing x[2][64];
    size_t n[2];
    for (int k = 0; k < 2; k++) {
        csg_step step[32];
        size_t steps = 0;
        for (const char *p = k ? other : one; *p; p++)
            step[steps++] = *p >= 'A' ? (csg_step){CSG_SOLID, (uint32_t)(*p - 'A')}
                : (csg_step){*p == '+' ? CSG_UNION : *p == '*' ? CSG_INTERSECTION
                             : CSG_DIFFERENCE, 0};
        size_t solids = 0;
        for (size_t i = 0; i < steps; i++)
            if (step[i].what == CSG_SOLID && step[i].solid >= solids) solids = step[i].solid + 1;
        csg c = built((csg_model){solid, solids, step, steps}, false);
        csg_crossing *list = NULL;
        n[k] = line_spans(&c, r, &list);
        for (size_t i = 0; i < n[k]; i++) x[k][i] = list[i];
        csg_free(&c);
    }
    if (n[0] != n[1]) return 1;
    for (size_t i = 0; i < n[0]; i++)
        if (x[0][i].t != x[1][i].t || (with && x[0][i].surface != x[1][i].surface)) return 1;
    return 0;
}

static void test_algebra(void)
{
    static const struct { const char *one, *other; bool with; } law[] = {
        {"AA+", "A", true}, {"AA*", "A", true}, {"AA-", "", true},
        {"AB+", "BA+", true}, {"AB*", "BA*", true},
        {"AB+C+", "ABC++", true}, {"AB*C*", "ABC**", true},
        {"AB-C-", "ABC+-", true}, {"AAB--", "AB*", true}, {"ABA--", "ABA--A*", true},
        {"AB+C*", "AC*BC*+", true}, {"AB*C+", "AC+BC+*", false},
        {"AB+A*", "A", true}, {"AB*A+", "A", true}, {"AB-B*", "", true},
        /* where surfaces coincide, here the starts of half spaces at -inf, names may differ */
        {"AB-B+", "AB+", false}, {"AB-AB*+", "A", false}, {"ABC--", "AB-AC*+", false}};
    size_t n = check_count(8000);
    for (size_t k = 0; k < sizeof law / sizeof *law; k++) {
        size_t wrong = 0;
        for (size_t i = 0; i < n / 20; i++) {
            random_stream s = random_start(5, i, k);
            csg_solid solid[3];
            for (int j = 0; j < 3; j++) solid[j] = random_solid(&s, false);
            for (int j = 0; j < 10; j++)
                wrong += differ(solid, random_line(&s), law[k].one, law[k].other, law[k].with);
        }
        check_equal(wrong, 0, "%s = %s, to the last bit", law[k].one, law[k].other);
    }
}

/* ---- faces that coincide ---- */

static void random_axes(random_stream *s, bool straight, vec3 n[3])
{
    n[0] = random_direction_of(s);
    vbasis(n[0], &n[1], &n[2]);
    for (int k = 0; straight && k < 3; k++) n[k] = vwith(vec(0, 0, 0), k, 1);
}

/* A and B: cubes with a common face, C: both, D: a part that shares a plane with C, E: a half space
 * with the plane between, its n four times as long, F: its complement. Whatever way the axes
 * stand. */
static void test_coincident_faces(void)
{
    static const struct { const char *one, *other, *why; bool with; } law[] = {
        {"AB+", "C", "union of two touching cubes: one cube, no seam", false},
        {"AB*", "", "their intersection: empty", true},
        {"AB-", "A", "their difference: the first, with its face", true},
        {"CB-", "A", "the whole less one half: the other half", false},
        {"CD-", "B", "less a part that shares a face: no skin is left", false},
        {"CE*", "A", "a half space and a box, one plane, one t (6.4)", false},
        {"CF*", "B", "the same from the other side", false},
        {"EF*", "", "a half space and its complement", true}};
    enum { laws = sizeof law / sizeof *law };
    size_t wrong[laws] = {0}, seen = 0, n = check_count(40000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(6, i, 0);
        vec3 axis[3];
        random_axes(&s, i % 3 == 0, axis);
        double a = -0.7, b = (double)random_next(&s) - 0.3, e = 0.8;
        const csg_solid solid[6] = {
            csg_scene_block(axis, a, a, a, b, e, e), csg_scene_block(axis, b, a, a, e, e, e),
            csg_scene_block(axis, a, a, a, e, e, e), csg_scene_block(axis, a, -1, -1, b, 1, 1),
            csg_half(vscale(axis[0], 4), 4 * (real)b), csg_half(vneg(axis[0]), (real)-b)};
        ray r = random_line(&s);
        csg_crossing x[2];
        seen += csg_solid_crossings(&solid[2], r, 0, x) / 2;
        for (int k = 0; k < laws; k++)
            wrong[k] += differ(solid, r, law[k].one, law[k].other, law[k].with);
    }
    check_at_least((double)seen, 0.3 * (double)n, "rays meet the cubes");
    for (int k = 0; k < laws; k++) check_equal(wrong[k], 0, "%s", law[k].why);
}

/* A closed box as a mesh, from -1 to 1 along axes of any length, its diagonals this way or that. */
static csg_solid mesh_box(const vec3 n[3], vec3 at, int twist)
{
    csg_solid s = csg_scene_cube(n, at);
    triangle *t = (triangle *)(uintptr_t)s.mesh.tri;
    for (int f = 0; twist && f < 12; f += 2) {
        triangle x = t[f], y = t[f + 1];  /* a b c, a c d */
        t[f] = (triangle){x.a, x.b, y.c}, t[f + 1] = (triangle){x.b, x.c, y.c};
    }
    return s;
}

/* Whether a line meets the same faces of a box that is larger and of one that is smaller, both by
 * more than rounding. */
static bool clear_of_edges(const csg_solid *box, ray r)
{
    csg_crossing x[2][2];
    size_t n[2];
    for (int i = 0; i < 2; i++) {
        csg_solid s = *box;
        for (int k = 0; k < 3; k++) {
            real room = 64 * real_epsilon * (fabs(s.box.lo[k]) + fabs(s.box.hi[k]));
            s.box.lo[k] += i ? room : -room, s.box.hi[k] -= i ? room : -room;
        }
        n[i] = csg_solid_crossings(&s, r, 0, x[i]);
    }
    return n[0] == n[1] && (n[0] == 0 || (x[0][0].surface == x[1][0].surface
                                          && x[0][1].surface == x[1][1].surface));
}

/* A mesh with the faces of a box, against others that are flush with it: to the last bit what the
 * box itself gives. Straight and turned, here and far away. */
static void test_mesh_faces(void)
{
    static const struct { const char *one, *other; } law[] = {
        {"AB-", ""}, {"BA-", ""}, {"AB*", "B"}, {"AB+", "B"}, {"AC-", "BC-"}, {"CA-", "CB-"},
        {"AC+", "BC+"}, {"AC*", "BC*"}};
    size_t wrong[8] = {0}, apart = 0, seen = 0, edges = 0, n = check_count(20000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(12, i, 0);
        vec3 axis[3];
        real lo[3], hi[3], cut[2][3];
        random_axes(&s, i % 3 == 0, axis);
        vec3 at = vscale(random_in_cube(&s, 1), i % 2 ? 2 : real_is_float ? 100 : (real)1e7);
        if (i % 3 == 0) at = (vec3){floor(at.x), floor(at.y), floor(at.z)};
        for (int k = 0; k < 3; k++) {  /* the third box: flush at one end, anything at the other */
            real middle = vdot(axis[k], at);
            bool up = random_below(&s, 2);
            lo[k] = middle - 1, hi[k] = middle + 1;
            cut[0][k] = up ? lo[k] + random_next(&s) : lo[k];
            cut[1][k] = up ? hi[k] : hi[k] - random_next(&s) / 2;
        }
        csg_solid abc[3] = {mesh_box(axis, at, i % 5 == 0), csg_box_turned(axis, lo, hi),
                            csg_box_turned(axis, cut[0], cut[1])};
        ray r = random_line(&s);
        r.o = vadd(r.o, at);
        csg_crossing x[14], y[2];
        size_t k = csg_solid_crossings(&abc[0], r, 0, x);
        if (csg_solid_crossings(&abc[1], r, 0, y) == 2)
            seen++, apart += k != 2 || x[0].t != y[0].t || x[1].t != y[1].t;
        bool clear = clear_of_edges(&abc[1], r);
        edges += !clear;
        for (int j = 0; j < 8 && clear; j++)
            wrong[j] += differ(abc, r, law[j].one, law[j].other, false);
        free((void *)(uintptr_t)abc[0].mesh.tri);
    }
    check_at_least((double)seen, 0.3 * (double)n, "rays meet the box");
    check_at_most((double)edges, 0.01 * (double)n, "few rays pass its edges within rounding");
    check_at_least((double)apart, 0.3 * (double)seen, "a mesh by itself finds another t");
    for (int j = 0; j < 8; j++)
        check_equal(wrong[j], 0, "a mesh A of the box B: %s = %s", law[j].one, law[j].other);
}

/* Half as wide across n[1] and n[2] as the cube of side 2, and flush with its face n[0]: the
 * difference is nothing, and of two meshes in a turned plane it speckles. Straight planes have a
 * rule, and so has a turned one that a half space names, for which no step asks. */
static void test_named_plane(void)
{
    size_t wrong[3] = {0}, n = check_count(8000);
    for (size_t i = 0; i < 3 * n; i++) {  /* turned; turned and named; straight */
        random_stream s = random_start(14, i / 3, 0);
        vec3 axis[3];
        random_axes(&s, i % 3 == 2, axis);
        const vec3 half[3] = {vscale(axis[0], (real)0.25), vscale(axis[1], (real)0.5),
                              vscale(axis[2], (real)0.5)};
        csg_solid solid[3] = {csg_scene_cube(half, vscale(axis[0], (real)0.75)),
                              csg_scene_cube(axis, vec(0, 0, 0)), csg_half(axis[0], 1)};
        vec3 to = vmadd(axis[0], axis[2], random_next(&s) - (real)0.5), from;
        to = vmadd(to, axis[1], random_next(&s) - (real)0.5);
        from = vscale(random_direction_of(&s), 4);
        csg c = joined(solid, 2 + (i % 3 == 1), CSG_DIFFERENCE, false);
        csg_crossing *list = NULL;
        wrong[i % 3] += line_spans(&c, ray_from(from, vsub(to, from)), &list) > 0;
        csg_free(&c);
        for (int k = 0; k < 2; k++) free((void *)(uintptr_t)solid[k].mesh.tri);
    }
    check_at_least((double)wrong[0], 0.05 * (double)n, "meshes in a turned plane: speckle");
    check_equal(wrong[1], 0, "with a half space of that plane among the solids: none");
    check_equal(wrong[2], 0, "nor in a plane across an axis");
}

/* A turned gem, cut in two along its square: both parts have the same two triangles there, seen
 * from either side, and nothing else in common. */
static void test_shared_triangles(void)
{
    size_t shared = 0, met = 0, n = check_count(20000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(13, i, 0);
        vec3 axis[3], at = random_in_cube(&s, 1), q[6];  /* corners: -+ x, -+ y, -+ z */
        triangle part[2][6];
        random_axes(&s, false, axis);
        for (int k = 0; k < 6; k++) q[k] = vmadd(at, axis[k / 2], k % 2 ? 1 : -1);
        for (int up = 0; up < 2; up++)
            for (int k = 0; k < 4; k++) {  /* round the square: 1 3 0 2 */
                static const int round[5] = {1, 3, 0, 2, 1};
                vec3 a = q[round[k]], b = q[round[k + 1]];
                part[up][k] = up ? (triangle){a, b, q[5]} : (triangle){b, a, q[4]};
            }
        part[0][4] = (triangle){q[1], q[3], q[0]}, part[0][5] = (triangle){q[1], q[0], q[2]};
        part[1][4] = (triangle){q[0], q[3], q[1]}, part[1][5] = (triangle){q[0], q[1], q[2]};
        const csg_solid two[2] = {csg_mesh(part[0], 6), csg_mesh(part[1], 6)};
        csg c = joined(two, 2, CSG_INTERSECTION, false);
        csg_crossing *list = NULL, x[2][8];
        ray r = random_line(&s);
        shared += line_spans(&c, r, &list) > 0;
        met += csg_solid_crossings(&two[0], r, 0, x[0]) && csg_solid_crossings(&two[1], r, 0, x[1]);
        csg_free(&c);
    }
    check_equal(shared, 0, "two parts that share triangles have nothing in common, of %zu", met);
    check_at_least((double)met, 0.05 * (double)n, "rays pass from one into the other");
}

/* ---- meshes ---- */

/* Lines aimed at corners and edges of a gem: the middle of each span is inside, of each gap
 * outside, and no list is without end. Counting the hits of 04 goes wrong there. */
static void test_mesh_edges(void)
{
    size_t wrong = 0, ends = 0, parity = 0, spans = 0, n = check_count(100000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(8, i, 0);
        csg_solid gem = csg_gem(i % 2 ? vec(0, 0, 0) : random_in_cube(&s, 1), 1);
        const triangle *t = gem.mesh.tri;
        triangle face = t[random_below(&s, 8)];
        vec3 to = face.a;
        if (i % 3 == 1) to = vscale(vadd(face.a, face.b), (real)0.5);
        if (i % 3 == 2) to = vmadd(face.a, vsub(face.b, face.a), random_next(&s));
        vec3 from = vmadd(to, random_direction_of(&s), 4);
        if (i % 5 == 0) from = vadd(to, vwith(vec(0, 0, 0), (int)random_below(&s, 3), 4));
        ray r = ray_from(from, vsub(to, from));
        csg_crossing x[10];
        size_t k = csg_solid_crossings(&gem, r, 0, x), hits = 0;
        hit h;
        for (int j = 0; j < 8; j++) hits += triangle_hit(t[j], r, &h);
        ray back = ray_from(from, vneg(r.d));
        for (int j = 0; j < 8; j++) hits += triangle_hit(t[j], back, &h);
        parity += hits % 2;
        ends += k % 2 || (k && !(fabs(x[k - 1].t) <= real_largest));
        spans += k / 2;
        for (size_t j = 0; j + 1 < k; j++) {
            /* A line that grazes an edge at an angle of 1e-4 is in the rounding of the corners for
             * 1e4 times their epsilons. */
            if ((double)(x[j + 1].t - x[j].t) < 1e5 * eps) continue;
            wide3 p = oracle_on(r, (double)(x[j].t + x[j + 1].t) / 2);
            double margin = oracle_margin(&gem, p);
            wrong += margin != 0 && (margin < 0) != (j % 2 == 0);
        }
        free((void *)(uintptr_t)t);
    }
    check_equal(wrong, 0, "middles of spans are inside");
    check_equal(ends, 0, "every span has an end");
    check_at_least((double)spans, 0.3 * (double)n, "the test sees spans");
    check_at_least((double)parity, 0.05 * (double)n, "an odd number of hits: parity fails");
}

static size_t crossings_of(const triangle *t, size_t n, ray r, csg_crossing *x)
{
    return csg_closed_crossings((csg_closed){t, n, NULL}, r, 0, x);
}

static void test_mesh_kinds(void)
{
    csg_solid gem = csg_gem(vec(0, 0, 0), 1);
    triangle t[16], over[8];
    csg_crossing x[20];
    ray r = ray_from(vec(0.1, 0.2, 4), vec(0, 0, -2));
    for (int i = 0; i < 8; i++) {
        const triangle g = gem.mesh.tri[i];
        t[i] = g, over[i] = (triangle){g.a, g.c, g.b};
        t[8 + i] = (triangle){vscale(g.a, 2), vscale(g.b, 2), vscale(g.c, 2)};
    }
    check_equal(csg_closed_crossings(gem.mesh, r, 0, x), 2, "one span");
    check_close(x[0].t, (4 - 0.7) / 2, 4 * eps, "|x| + |y| + |z| = 1: the way in");
    check_close(x[1].t, (4 + 0.7) / 2, 4 * eps, "the way out");
    for (size_t i = 0; i < 2; i++)
        check(vdot(csg_solid_normal(&gem, x[i].surface / 2, vec(0, 0, 0)), ray_at(r, x[i].t)) > 0,
              "the normal of a face leads away from the middle");
    check_equal(crossings_of(over, 8, r, x), 0, "inside out: empty");
    check_equal(crossings_of(t, 16, r, x), 2, "shell in shell: one span");
    check_close(x[0].t, (4 - 1.7) / 2, 4 * eps, "that of the outer one");
    check_equal(crossings_of(t, 7, ray_from(vec(1, 1, 3), vec(-1, -1, -3)), x), 2,
                "in through the opposite of a missing triangle");
    check(x[1].t == real_infinity, "and never out");
    check(crossings_of(t, 0, r, x) == 0, "no triangles: nothing");
    for (int i = 0; i < 8; i++) t[8 + i] = (triangle){t[i].a, t[i].b, t[i].a};
    check_equal(crossings_of(t, 16, r, x), 2, "no area counts nothing");
    free((void *)(uintptr_t)gem.mesh.tri);
}

/* ---- bounds ---- */

/* Rays at limbs, corners, faces of the bounds, with intervals that end there: the same hit. */
static void test_bounds(void)
{
    size_t wrong = 0, hits = 0, fewer = 0, more = 0, n = check_count(2000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(9, i, 0);
        csg_expression e = random_tree(&s, 1 + random_below(&s, 10), true);
        csg with = built(csg_expression_model(&e), false);
        csg without = built(csg_expression_model(&e), true);
        for (int k = 0; k < 40; k++) {
            ray r = random_line(&s);
            csg_bound b = with.node[random_below(&s, with.nodes)].bound;
            vec3 at = b.lo;
            for (int j = 0; j < 3; j++)
                if (random_below(&s, 2)) at = vwith(at, j, vaxis(b.hi, j));
            if (k % 2 && vfinite(at)) r.d = vsub(at, r.o);
            hit h = hit_none, g = hit_none;
            if (k % 4 == 3 && csg_hit(&without, r, &h))
                r.tmin = k % 8 == 3 ? h.t : 0, r.tmax = k % 16 < 8 ? h.t : 2 * h.t;
            h = hit_none;
            csg_asked.solids = 0;
            bool is = csg_hit(&with, r, &h);
            size_t asked = csg_asked.solids;
            csg_asked.solids = 0;
            bool due = csg_hit(&without, r, &g);
            fewer += asked < csg_asked.solids, more += asked > csg_asked.solids;
            wrong += is != due || h.t != g.t || h.shape != g.shape;
            hits += is;
        }
        csg_free(&with), csg_free(&without), csg_expression_free(&e);
    }
    check_equal(wrong, 0, "bounds change no hit");
    check_equal(more, 0, "nor do they ask more solids");
    check_at_least((double)fewer, 0.1 * 40 * (double)n, "they spare some");
    check_at_least((double)hits, 0.1 * 40 * (double)n, "the test sees hits");
}

/* Balls in a row, joined in pairs of pairs: a ray across asks the one that it comes near, and some
 * boxes for each of the tree's ten levels. In float, at 1000, boxes are wider by their rounding. */
static void test_bounds_spare(void)
{
    enum { balls = 1024 };
    csg_expression e = {.solids = balls};
    hit h;
    e.solid = allocate(balls, sizeof *e.solid), e.step = allocate(2 * balls, sizeof *e.step);
    for (size_t i = 0; i < balls; i++) {
        e.solid[i] = csg_sphere(vec((double)i, 0, 0), 0.6);
        e.step[e.steps++] = (csg_step){CSG_SOLID, (uint32_t)i};
        for (size_t j = i + 1; j % 2 == 0; j /= 2) e.step[e.steps++].what = CSG_UNION;
    }
    csg c = built(csg_expression_model(&e), false);
    size_t n = check_count(8000), met = 0;
    csg_asked.solids = csg_asked.bounds = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(24, i, 0);
        vec3 at = {balls * random_next(&s), 0, 0}, jitter = random_in_cube(&s, 1);
        met += csg_hit(&c, ray_from(vadd(at, vec(0, 0, 4)), vadd(jitter, vec(0, 0, -4))), &h);
    }
    check_at_most((double)csg_asked.solids, (real_is_float ? 2 : 1.1) * (double)n,
                  "balls of 1024 that a ray asks");
    check_at_most((double)csg_asked.bounds, (real_is_float ? 24 : 16) * (double)n,
                  "and boxes");
    check_at_least((double)met, 0.4 * (double)n, "the test sees hits");
    csg_free(&c), csg_expression_free(&e);
}

/* From afar, along an axis or anyhow, past a corner of a box by some roundings of the way: what the
 * box reports there, by rounding, its bounds must not take away. Turned boxes, and askew ones. */
static void test_bounds_from_afar(void)
{
    size_t lost = 0, met = 0, open = 0, n = check_count(2000000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(21, i, 0);
        vec3 axis[3], middle = random_direction_of(&s), d = random_direction_of(&s);
        random_axes(&s, false, axis);
        for (int k = 0; i % 2 && k < 3; k++) {
            real off = pow((real)10, -random_next(&s));
            axis[k] = vmadd(middle, random_direction_of(&s), off);
        }
        vec3 at = {0, 0, 0}, c[3];
        for (int k = 0; k < 3; k++) c[k] = vcross(axis[(k + 1) % 3], axis[(k + 2) % 3]);
        real lo[3], hi[3], det = vdot(axis[0], c[0]), far = pow((real)10, 3 * random_next(&s));
        for (int k = 0; k < 3; k++) {
            lo[k] = 2 * random_next(&s) - 1, hi[k] = lo[k] + pow((real)10, -3 * random_next(&s));
            at = vmadd(at, c[k], (random_below(&s, 2) ? lo[k] : hi[k]) / det);
        }
        if (i % 4 < 2) {
            d = vscale(d, pow(real_epsilon, random_next(&s)));
            d = vadd(vwith(vec(0, 0, 0), (int)random_below(&s, 3), 1), d);
        }
        at = vmadd(at, random_in_cube(&s, 1), 2 * real_epsilon * far);
        csg_solid box = csg_box_turned(axis, lo, hi);
        csg_bound b = csg_bound_of(&box);
        ray r = ray_from(vmadd(at, d, -far), d);
        csg_crossing x[2];
        open += !vfinite(b.lo);
        if (csg_solid_crossings(&box, r, 0, x) < 2) continue;
        r.tmin = r.tmax = x[random_below(&s, 2)].t;
        csg_line line = csg_line_of(r);
        met++, lost += !csg_bound_meets(&b, &line);
    }
    check_equal(lost, 0, "bounds lose none of %zu hits at corners, from afar", met);
    check_at_least((double)met, 0.2 * (double)n, "the test sees hits");
    check(open > n / 20 && open < n / 2, "askew boxes have no bounds: %zu of %zu", open, n);
}

/* Corners of a mesh as far off the plane that counts for them as it lets them (6.7), and a ray as
 * flat as it may be: t is that of the plane, 64 times as far along, beyond the mesh's edge. Every
 * other ray is four times as flat, and must not get that far. */
static void test_bounds_of_planes(void)
{
    size_t lost = 0, met = 0, n = check_count(8000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(22, i, 0);
        vec3 up = vunit(vmadd(vec(0, 0, 1), vec(1, 0, 0), (real)1e-3 * (1 + random_next(&s))));
        const vec3 axis[3] = {{up.z, 0, -up.x}, {0, 1, 0}, up};
        const real lo[3] = {-1, -1, -1}, hi[3] = {1, 1, 1};
        csg_solid solid[2] = {mesh_box(axis, vec(0, 0, 0), 0), csg_box_turned(axis, lo, hi)};
        vec3 *v = (vec3 *)(uintptr_t)solid[0].mesh.tri;
        for (int k = 0; k < 36; k++)
            if (vdot(v[k], axis[2]) > 0) v[k] = vmadd(v[k], axis[2], -20 * real_epsilon);
        csg c = joined(solid, 2, CSG_SOLID, false);
        vec3 at = vmadd(vadd(axis[2], axis[0]), axis[1], random_next(&s) - (real)0.5);
        at = vmadd(at, axis[0], -1024 * real_epsilon * random_next(&s));
        vec3 d = vmadd(axis[0], axis[2], (real)(1.001 / (i % 2 ? 64 : 256)));
        ray r = ray_from(vmadd(vmadd(at, axis[2], -20 * real_epsilon), d, (real)-0.01), d);
        csg_crossing x[14];
        if (csg_solid_crossings(&c.solid[0], r, 0, x) == 2) {
            r.tmin = r.tmax = x[1].t;
            csg_line line = csg_line_of(r);
            met++, lost += !csg_bound_meets(&c.node[0].bound, &line);
        }
        csg_free(&c), free(v);
    }
    check_equal(lost, 0, "bounds lose none of %zu hits beside a mesh's edge", met);
    check_at_least((double)met, 0.2 * (double)n, "the test sees hits");
}

/* How far corners of a cube lie off the planes of the box with its faces, in the unit of (6.7). */
static double off_planes(const csg_solid *cube, const csg_solid *box)
{
    double most = 0;
    for (size_t f = 0; f < 6; f++) {
        csg_plane g = coplanar_face(box, f);
        for (size_t i = 0; i < 12; i++) {
            const triangle t = cube->mesh.tri[i];
            real a = fabs(vdot(g.n, t.a) - g.h), b = fabs(vdot(g.n, t.b) - g.h);
            real c = fabs(vdot(g.n, t.c) - g.h), off = real_max(a, real_max(b, c));
            real far = real_max(real_max(vlength(t.a), vlength(t.b)), vlength(t.c));
            if (off < (real)0.5)
                most = fmax(most, (double)(off / (vlength(g.n) * far + fabs(g.h))));
        }
    }
    return most / eps;
}

/* To the cube whose corners lie farthest off the planes that they were made from, by climbing: 2.9
 * of the 8 epsilon. Each face must find its plane. */
static void test_planes_climbed_to(void)
{
    double most = 0;
    size_t lost = 0;
    for (uint64_t i = 0; i < 8; i++) {
        random_stream s = random_start(80, i, 0);
        vec3 v = random_in_cube(&s, 1), at = random_in_cube(&s, 1);
        at = vscale(at, pow((real)10, random_between(&s, -2, 2)));
        double best = -1;
        for (int k = 0; k < 4000; k++) {
            vec3 w = v, to = at, n[3];
            real *part[6] = {&w.x, &w.y, &w.z, &to.x, &to.y, &to.z}, lo[3], hi[3];
            for (int m = k ? (int)random_between(&s, 1, 4) : 0; m > 0; m--)
                *part[random_below(&s, 6)] *=
                    1 + random_between(&s, -1, 1)
                            * pow((real)10, random_between(&s, real_is_float ? -7 : -16, -1));
            n[0] = vunit(w);
            vbasis(n[0], &n[1], &n[2]);
            for (int q = 0; q < 3; q++) lo[q] = vdot(n[q], to) - 1, hi[q] = vdot(n[q], to) + 1;
            csg_solid cube = csg_scene_cube(n, to), box = csg_box_turned(n, lo, hi);
            double off = off_planes(&cube, &box);
            if (off >= best) {
                best = off, v = w, at = to;
                for (size_t q = 0; q < 12; q++)
                    lost += vzero(coplanar_plane(&box, 1, cube.mesh.tri[q]).n);
            }
            free((void *)(uintptr_t)cube.mesh.tri);
        }
        most = fmax(most, best);
    }
    check_equal(lost, 0, "faces of a cube that miss their box's plane");
    check_at_least(most, 2.2, "the climb gets more than 2 epsilon off them");
}

/* Flat lines on to a face across an axis: the place that the plane gives is off it by the rounding
 * of o + t d, most of all near 0, and the mesh must take it for one of its own. */
static void test_flat_on_faces(void)
{
    static const csg_step step[1] = {{CSG_SOLID, 0}};
    const vec3 axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    size_t met = 0, apart = 0, n = check_count(8000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(23, i, 0);
        vec3 at = random_in_cube(&s, 2), c = {0, 0, 0};
        at.z = random_between(&s, -1, 1) / 1024 - 1;
        csg_solid solid[2] = {csg_scene_cube(axis, at), {.kind = CSG_BOX}};
        const triangle *t = solid[0].mesh.tri;
        real lo[3], hi[3];
        for (int k = 0; k < 3; k++) lo[k] = real_infinity, hi[k] = -real_infinity;
        for (int q = 0; q < 12; q++)
            for (int k = 0; k < 3; k++)
                lo[k] = real_min(lo[k], vaxis(t[q].a, k)),
                hi[k] = real_max(hi[k], vaxis(t[q].a, k));
        solid[1] = csg_box_turned(axis, lo, hi);
        csg m = built((csg_model){solid, 2, step, 1}, false);
        for (int k = 0; k < 3; k++)
            c = vwith(c, k, lo[k] + (hi[k] - lo[k]) * random_between(&s, (real)0.3, (real)0.7));
        c.z = hi[2];
        vec3 d = {random_between(&s, -1, 1), random_between(&s, -1, 1), 0};
        d.z = -vlength(d) / random_between(&s, 70, 400);
        ray r = ray_from(vmadd(c, d, -random_between(&s, 1, 9)), d);
        csg_crossing x[14], y[2];
        if (csg_solid_crossings(&m.solid[0], r, 0, x) == 2
            && csg_solid_crossings(&m.solid[1], r, 0, y) == 2)
            met++, apart += x[0].t != y[0].t;
        csg_free(&m), free((void *)(uintptr_t)t);
    }
    check_equal(apart, 0, "a flat line finds another t on a mesh than on the box, of %zu", met);
    check_at_least((double)met, 0.5 * (double)n, "the test sees hits");
}

/* ---- eyes inside, intervals ---- */

static void test_interval(void)
{
    const csg_solid s[2] = {csg_sphere(vec(0, 0, 0), 2), csg_sphere(vec(0, 0, 0), 1)};
    csg c = joined(s, 2, CSG_DIFFERENCE, false);  /* a hollow ball */
    const real inf = real_infinity;
    const struct { real tmin, tmax, t; uint32_t shape; } at[] = {  /* t 7: no hit */
        {0, inf, 1, 0}, {1, 1, 1, 0}, {(real)1.5, inf, 2, 3}, {2, 2, 2, 3}, {3, 9, 4, 3},
        {(real)4.5, inf, 5, 0}, {-inf, inf, 1, 0}, {0, (real)0.5, 7, 7},
        {(real)1.25, (real)1.75, 7, 7}, {6, inf, 7, 7}, {3, 1, 7, 7}, {(real)NAN, 9, 7, 7},
        {0, (real)NAN, 7, 7}, {-inf, 0, 7, 7}};
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        hit h = {7, 7, 7, 7};
        ray r = {{0, 0, 3}, at[i].tmin, {0, 0, -1}, at[i].tmax};
        bool is = csg_hit(&c, r, &h);
        check(is == (at[i].t != 7) && h.t == at[i].t && h.shape == at[i].shape, "interval %zu", i);
        check(csg_occluded(&c, r) == is, "occluded %zu", i);
    }
    hit h;
    ray hollow = ray_from(vec(0, 0, 0), vec(0, 3, 0));
    ray wall = ray_from(vec(0, 0, 1.5), vec(0, 0, 1));
    check(csg_hit(&c, hollow, &h), "from the hollow: the inner wall");
    check_close(h.t, 1 / 3.0, eps, "a third of d");
    vec3 n = csg_normal(&c, hollow, h);
    check(n.y == -1 && h.shape == 3 && csg_solid_of(&c, h) == 1, "its normal points to the eye");
    check(csg_hit(&c, wall, &h) && h.t == (real)0.5, "from within the wall: the way out");
    n = csg_normal(&c, wall, h);
    check(n.z == 1 && csg_solid_of(&c, h) == 0, "its normal points away from the eye");
    csg_free(&c);
}

/* ---- the ways that csg.h does not take ---- */

/* Each has its hard case, and csg_hit none of them. */
static void test_ways(void)
{
    size_t n = check_sample(2000, 200);  /* some are rare */
    /* far away in float the planes are off by so much that the order is always one */
    const struct { csg_way way; double least; const char *why; } in[csg_sights] = {
        [CSG_OUTSIDE] = {{csg_hit_front, 0, true}, 0, "t > 0, seen from outside"},
        [CSG_EYE_INSIDE] = {{csg_hit_front, 0, true}, 50, "t > 0, seen from inside"},
        [CSG_COINCIDENT] = {{csg_hit_tolerant, -1, true}, 5, "no rule for equal t: speckle"},
        [CSG_FAR_AWAY] = {{csg_hit_tolerant, 1e-9, true}, real_is_float ? 0 : 2,
                          "a tolerance of 1e-9, far away: speckle"},
        [CSG_MESH_FACES] = {{csg_hit_tolerant, -1, true}, 5, "meshes that know no planes: speckle"},
        [CSG_FOILS] = {{csg_hit_tolerant, 0.003, true}, 50, "two foils of three are gone"}};
    for (int k = 0; k < csg_sights; k++) {
        csg_sight s = csg_sight_of((csg_sight_kind)k, 1);
        const csg_way way[3] = {{csg_hit, 0, false}, {csg_hit, 0, true}, in[k].way};
        double wrong[3];
        csg_wrong(&s, way, 3, n, wrong);
        check_equal(wrong[0], 0, "csg_hit, sight %d", k);
        check_equal(wrong[1], 0, "no bounds, sight %d", k);
        check_at_least(wrong[2], in[k].least, "%s", in[k].why);
        if (k == CSG_OUTSIDE) check_equal(wrong[2], 0, "%s", in[k].why);
        csg_scene_free(&s.scene);
    }
}

/* ---- strange input ---- */

static void test_strange_solids(void)
{
    const real nan = (real)NAN, inf = real_infinity;
    triangle bad[4] = {{{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}};
    const csg_solid strange[] = {
        csg_sphere(vec(nan, 0, 0), 1), csg_sphere(vec(0, 0, 0), 0), csg_sphere(vec(0, 0, 0), inf),
        csg_half(vec(0, 0, 0), 1), csg_half(vec(0, 1, 0), nan), csg_half(vec(0, inf, 0), 1),
        csg_half(vec(0, 1, 0), inf), csg_box(vec(1, 0, 0), vec(1, 1, 1)),
        csg_box(vec(1, 1, 1), vec(0, 0, 0)), csg_box(vec(0, 0, 0), vec(1, nan, 1)),
        csg_box(vec(-inf, 0, 0), vec(1, 1, 1)), csg_cylinder(vec(0, 0, 0), vec(0, 0, 0), 1),
        csg_cylinder(vec(0, 0, 0), vec(0, 0, 1), 0), csg_cylinder(vec(0, inf, 0), vec(0, 0, 1), 1),
        csg_mesh(bad, 1), csg_mesh(NULL, 0)};
    const ray r = {{(real)0.1, (real)0.2, 3}, -inf, {0, 0, -1}, inf};
    csg_crossing *x = NULL;
    for (size_t i = 0; i < sizeof strange / sizeof *strange; i++)
        for (int no_bounds = 0; no_bounds < 2; no_bounds++) {
            const csg_solid s[2] = {csg_sphere(vec(0, 0, 0), 1), strange[i]};
            csg c = joined(&strange[i], 1, CSG_SOLID, no_bounds);
            check_equal(line_spans(&c, r, &x), 0, "solid %zu is empty", i);
            csg_free(&c);
            for (int what = CSG_UNION; what <= CSG_DIFFERENCE; what++) {
                c = joined(s, 2, (csg_operation)what, no_bounds);
                check_equal(line_spans(&c, r, &x), what == CSG_INTERSECTION ? 0 : 2,
                            "a ball and the empty solid %zu, operation %d", i, what);
                csg_free(&c);
            }
        }
}

static void test_strange_rays(void)
{
    const real strange[] = {(real)NAN, real_infinity, -real_infinity};
    csg_expression e;
    failure f;
    const char *text = "union(half 0 0 1 9, box -1 -1 -1 1 1 1, cylinder 0 0 0 0 0 1 1, "
                       "gem 0 0 0 2)";
    if (!csg_read(text, &e, &f)) abort();
    for (int no_bounds = 0; no_bounds < 2; no_bounds++) {
        csg c = built(csg_expression_model(&e), no_bounds), none = {0};
        hit h = {7, 7, 7, 7};
        csg_crossing *x = NULL;
        for (int k = 0; k < 6; k++)
            for (int i = 0; i < 3; i++) {
                real v[6] = {0, 0, 3, 0, 0, -1};
                v[k] = strange[i];
                ray r = ray_from(vec(v[0], v[1], v[2]), vec(v[3], v[4], v[5]));
                check(!csg_hit(&c, r, &h) && line_spans(&c, r, &x) == 0 && h.t == 7, "o, d %d", k);
            }
        ray still = ray_from(vec(0, 0, 0), vec(0, 0, 0));
        check(!csg_hit(&c, still, &h) && line_spans(&c, still, &x) == 0 && h.t == 7, "d = 0");
        check(csg_build((csg_model){NULL, 0, NULL, 0}, (csg_options){no_bounds}, &none, NULL)
              && !csg_hit(&none, ray_from(vec(0, 0, 0), vec(0, 0, 1)), &h), "no steps: empty");
        csg_free(&none), csg_free(&c);
    }
    csg_expression_free(&e);
    const csg_solid half[2] = {csg_half(vec(0, 0, 1), 0), csg_half(vec(0, 0, -1), 0)};
    csg c = joined(half, 2, CSG_UNION, false);
    csg_crossing *x = NULL;
    hit h;
    check_equal(line_spans(&c, ray_from(vec(0, 0, 3), vec(1, 0, -1)), &x), 2, "all of space");
    check(x[0].t == -real_infinity && x[1].t == real_infinity, "without ends");
    check(!csg_hit(&c, ray_from(vec(0, 0, 3), vec(1, 0, -1)), &h), "that nothing hits");
    csg_free(&c);
    csg_solid rod = csg_cylinder(vec(1, 2, 3), vec(0, 0, 5), 1);
    csg_solid cube = csg_box(vec(-1, -1, -1), vec(1, 1, 1));
    csg_crossing y[2];
    for (int side = -1; side <= 1; side += 2)
        check(csg_solid_crossings(&cube, ray_from(vec(-3, side, 0), vec(1, 0, 0)), 0, y) == 2,
              "in a face of a box, y = %d: it belongs to it", side);
    check(csg_solid_crossings(&rod, ray_from(vec(1.5, 2, 0), vec(0, 0, 2)), 0, y) == 2
          && y[0].t == -real_infinity, "along a cylinder, within it");
    check(csg_solid_crossings(&rod, ray_from(vec(2.5, 2, 0), vec(0, 0, 2)), 0, y) == 0,
          "along a cylinder, beside it");
    check(csg_solid_crossings(&rod, ray_from(vec(2, 0, 0), vec(0, 1, 0)), 0, y) == 0, "tangent");
}

static void test_refused_steps(void)
{
    const csg_solid s[1] = {csg_sphere(vec(0, 0, 0), 1)};
    const struct { csg_step step[3]; size_t n; const char *says; } bad[] = {
        {{{CSG_SOLID, 1}}, 1, "step 0: no solid 1"},
        {{{CSG_SOLID, 0}, {CSG_SOLID, 0}}, 2, "2 operands, and nothing joins them"},
        {{{CSG_SOLID, 0}, {CSG_UNION, 0}}, 2, "step 1: an operation lacks operands"},
        {{{CSG_DIFFERENCE, 0}}, 1, "step 0: an operation lacks operands"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        csg c = {.depth = 77};
        failure why = {0, ""};
        check(!csg_build((csg_model){s, 1, bad[i].step, bad[i].n}, (csg_options){0}, &c, &why)
              && c.depth == 77, "refused %zu", i);
        check_text(why.text, bad[i].says, "why %zu", i);
    }
    failure why = {0, ""};  /* refused by their number alone */
    check(!csg_build((csg_model){s, 1, NULL, UINT32_MAX}, (csg_options){0}, &(csg){0}, &why)
          && strstr(why.text, "too many"), "2^32 - 1 steps");
}

/* ---- depth, and memory ---- */

/* A block less n slots, as one chain to the left and one to the right: the same spans as counted by
 * hand, at any depth. */
static void test_depth(void)
{
    size_t n = check_count(200000);
    csg_solid *s = allocate(n + 1, sizeof *s);
    csg_step *left = allocate(2 * n + 1, sizeof *left), *right = allocate(2 * n + 1, sizeof *right);
    size_t l = 0, r = 0, slots = n < 100 ? n : 100;
    s[0] = csg_box(vec(0, -1, -1), vec(2 * (double)slots + 1, 1, 1));
    left[l++] = right[r++] = (csg_step){CSG_SOLID, 0};
    for (size_t i = 1; i <= n; i++) {  /* after `slots` of them the same again */
        double x = 2 * (double)(i % slots) + 1;
        s[i] = csg_box(vec(x, -2, -2), vec(x + 1, 2, 2));
        left[l++] = right[r++] = (csg_step){CSG_SOLID, (uint32_t)i};
        left[l++] = (csg_step){CSG_DIFFERENCE, 0};
    }
    for (size_t i = 1; i < n; i++) right[r++] = (csg_step){CSG_UNION, 0};
    right[r++] = (csg_step){CSG_DIFFERENCE, 0};
    for (int k = 0; k < 2; k++) {
        csg c = built((csg_model){s, n + 1, k ? right : left, k ? r : l}, true);
        csg_crossing *x = NULL;
        check_equal(c.depth, n, "a chain is as deep as it has cuts");
        const ray line = ray_from(vec(-1, 0, 0), vec(1, 0, 0));
        hit h;
        size_t spans = line_spans(&c, line, &x) / 2;
        check_equal(spans, slots + 1, "spans between %zu slots", slots);
        check(csg_hit(&c, line, &h) && h.t == x[0].t, "the first of them is the hit");
        csg_free(&c);
    }
    free(s), free(left), free(right);
}

/* ---- texts ---- */

static void test_expressions(void)
{
    static const char *const good[] = {
        "sphere 0 0 0 1", " difference( box -1 -1 -1 1 1 1,sphere 0 0 1 0.8 , gem 0 0 0 .5)\n",
        "union(half 0 1 0 -1,intersection(cylinder 0 0 0 0 0 1 .5, sphere 1e-3 +1 -2 3))"};
    static const struct { const char *text, *says; } bad[] = {
        {"", "character 1: the end, allowed: sphere, box,"},
        {"cube 1 2 3", "character 1: 'cube', allowed: sphere, box,"},
        {"sphere 0 0 0", "character 13: the end, allowed: a decimal number"},
        {"sphere 0 0 0 1x", "character 14: '1x', allowed: a decimal number"},
        {"sphere 0 0 nan 1", "character 12: 'nan', allowed: a decimal number"},
        {"sphere 0 0 0 1e31", "character 14: '1e31', allowed: numbers from -1e30 to 1e30"},
        {"sphere 0 0 0 1 1", "character 16: '1', allowed: nothing more"},
        {"union(sphere 0 0 0 1)", "character 21: ')', allowed: a comma, as an operation"},
        {"union(sphere 0 0 0 1, sphere 0 0 0 2", "character 37: the end, allowed: a comma or )"},
        {"union sphere 0 0 0 1", "character 1: 'union', allowed: sphere, box,"},
        {"union()", "character 7: ')', allowed: sphere, box,"},
        {"sphere 0 0 0 1)", "character 15: ')', allowed: nothing more"},
        {"\x1b[31mboo", "character 1: byte 27, allowed: sphere"},
        {"a\xff\xfe" "bcdefghijklmnopqrstuvwxyz", "character 1: 'a??bcdefghijklmnopqr.."}};
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        csg_expression e;
        failure f = {0, ""};
        bool ok = csg_read(good[i], &e, &f);
        check(ok, "good %zu: %s", i, f.text);
        if (!ok) continue;
        csg c = built(csg_expression_model(&e), false);
        csg_free(&c), csg_expression_free(&e);
    }
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        csg_expression e;
        failure f = {0, ""};
        check(!csg_read(bad[i].text, &e, &f), "bad %zu", i);
        check(f.exit_code == 2 && strncmp(f.text, bad[i].says, strlen(bad[i].says)) == 0,
              "bad %zu says: %s", i, f.text);
    }
}

static void test_expression_means(void)
{
    csg_expression e;
    failure f;
    if (!csg_read("difference(sphere 0 0 0 3, sphere 0 0 0 2, half 0 0 1 0)", &e, &f)) abort();
    csg c = built(csg_expression_model(&e), false);
    csg_crossing *x = NULL;
    size_t n = line_spans(&c, ray_from(vec(0, 0, -5), vec(0, 0, 1)), &x);
    check(n == 2 && x[0].t == 7 && x[1].t == 8, "(a - b) - c: the upper wall of a hollow ball");
    csg_free(&c), csg_expression_free(&e);
    size_t deep = check_count(400000);
    char *text = allocate(deep, 64), *p = text;
    for (size_t i = 0; i < deep; i++) p += sprintf(p, "union(");
    p += sprintf(p, "sphere 0 0 0 1");
    for (size_t i = 0; i < deep; i++) p += sprintf(p, ",sphere 0 0 0 1)");
    check(csg_read(text, &e, &f), "nested %zu deep: %s", deep, f.text);
    check_equal(e.solids, deep + 1, "all of them are read");
    csg_expression_free(&e), free(text);
}

/* Words, numbers and bytes at random: an answer always, and a good one can be built and asked. */
static void test_hostile_texts(void)
{
    static const char *const word[] = {"union(", "intersection(", "difference(", "sphere", "box",
        "half", "cylinder", "gem", ",", ")", "(", "0", "1", "-1", ".5", "1e30", "1e-30", "1e999",
        "nan", "-", "sphere 0 0 0 1", "gem 0 0 0 1", "box 0 0 0 1 1 1", ", ", ")", ","};
    size_t read = 0, refused = 0, silent = 0, n = check_count(200000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(13, i, 0);
        char text[400] = "";
        size_t words = 1 + random_below(&s, 14);
        for (size_t k = 0; k < words; k++) {
            bool bytes = random_below(&s, 20) == 0;
            char odd[2] = {(char)random_below(&s, 256), 0};
            strcat(text, bytes ? odd : word[random_below(&s, sizeof word / sizeof *word)]);
            if (random_below(&s, 2)) strcat(text, " ");
        }
        csg_expression e;
        failure f = {0, ""};
        if (!csg_read(text, &e, &f)) {
            refused++, silent += f.exit_code != 2 || strncmp(f.text, "character ", 10) != 0;
            continue;
        }
        csg c = built(csg_expression_model(&e), false);
        csg_crossing *x = NULL;
        (void)line_spans(&c, random_line(&s), &x);
        csg_free(&c), csg_expression_free(&e), read++;
    }
    check_equal(silent, 0, "each refusal says where");
    check_at_least(read, 1, "some are good");
    check_at_least(refused, n / 2, "most are not");
}

int main(void)
{
    return check_all("06_csg", test_merge, test_random_trees, test_normals, test_algebra,
                     test_coincident_faces, test_mesh_faces,
                     test_named_plane, test_shared_triangles, test_mesh_edges, test_mesh_kinds,
                     test_bounds, test_bounds_spare, test_bounds_from_afar, test_bounds_of_planes,
                     test_planes_climbed_to, test_flat_on_faces, test_interval, test_ways,
                     test_strange_solids, test_strange_rays, test_refused_steps, test_depth,
                     test_expressions, test_expression_means, test_hostile_texts);
}
