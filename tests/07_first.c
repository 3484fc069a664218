/* 07's first.h: closest hits, parity and OBJ files as the full headers have them; what the program
 * says of broken files. (Where parity fails: 07_mesh.c.) */
#include "check.h"
#include "../chapters/07_mesh/files/obj.h"
#include "../chapters/07_mesh/lab/trials.h"

#include "program.h"

static const double eps = (double)real_epsilon;

/* ---- hits ---- */

/* Random rays; t by Möller-Trumbore is off by some epsilon over the cosine, of numbers near 1. A
 * ray is judged where it passes 1e-3 of a triangle's weights away from any border. */
static void test_closest(mesh m)
{
    first_mesh soup = first_mesh_of(&m);
    size_t wrong = 0, judged = 0, hits = 0, n = check_count(20000);
    double off = 0, normal = 0;
    first_tests = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(1, i, 0);
        vec3 o = random_in_cube(&s, 2);
        ray r = ray_from(o, vsub(random_in_cube(&s, 1), o));
        if (i % 4 == 0) r.tmax = random_next(&s), r.tmin = r.tmax / 2;
        hit a = {7, 7, 7, 7}, b = {7, 7, 7, 7};
        bool is = first_mesh_hit(&soup, r, &a), due = mesh_hit(&m, r, &b);
        vec3 across = due ? triangle_normal(mesh_triangle(&m, b.shape)) : (vec3){0, 0, 0};
        real border = due ? real_min(real_min(b.u, b.v), 1 - b.u - b.v) : 1;
        if (border < (real)1e-3 || (due && fabs(vdot(across, vunit(r.d))) < (real)0.02)) continue;
        judged++, hits += is;
        wrong += is != due || a.shape != b.shape;
        if (!due) continue;
        off = check_worse(off, (double)fabs(a.t - b.t));
        vec3 towards = vdot(across, r.d) < 0 ? across : vneg(across);
        vec3 apart = vsub(first_mesh_normal(&soup, a.shape, r.d), towards);
        normal = check_worse(normal, (double)vlength(apart));
    }
    check_at_least((double)judged, 0.8 * (double)n, "most rays are judged");
    check_at_least((double)hits, 0.1 * (double)n, "the test sees hits");
    check_equal(wrong, 0, "hit or miss, and which triangle, against mesh_hit, of %zu", judged);
    check_at_most(off, 400 * eps, "t");
    check_at_most(normal, 1000 * eps, "the normal, on the side of the ray");
    check_equal((double)first_tests, (double)n * soup.n, "each ray asks every triangle");
    first_mesh_free(&soup), mesh_free(&m);
    first_mesh_free(&soup);
    check(!soup.tri && soup.n == 0, "freed, and freed again");
}

/* A hit is stored, with its number, and ends the ray; a miss leaves all as it was. */
static void test_one(void)
{
    triangle two[2] = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 0, 2}, {4, 0, 2}, {0, 4, 2}}};
    first_mesh m = {two, 2};
    hit h = {7, 7, 7, 7};
    ray r = ray_from((vec3){1, 1, 5}, (vec3){0, 0, -1});
    check(first_mesh_test(&m, 1, &r, &h) && h.t == 3 && h.shape == 1 && r.tmax == 3, "the near");
    check(!first_mesh_test(&m, 0, &r, &h) && h.t == 3 && r.tmax == 3, "the far is hidden");
    r = ray_from((vec3){1, 1, -5}, (vec3){0, 0, 1});
    check(first_mesh_hit(&m, r, &h) && h.t == 5 && h.shape == 0, "from below the other is nearer");
    m.n = 1;
    check(first_mesh_hit(&m, r, &h) && !first_mesh_inside(&m, (vec3){1, 1, 1}, (vec3){0, 0, 1}),
          "one triangle");
    check(first_mesh_inside(&m, (vec3){1, 1, 1}, (vec3){0, 0, -1}), "seen through it, it is odd");
    m.n = 0, h.t = 7;
    check(!first_mesh_hit(&m, r, &h) && h.t == 7, "no triangle, no hit");
    check(!first_mesh_inside(&m, (vec3){0, 0, 0}, (vec3){1, 0, 0}), "and no inside");
}

/* 2,000 triangles at the same place: one t, no matter which; without area, with NaN: none. Nor has
 * a ray any without a direction. */
static void test_degenerate(void)
{
    enum { n = 2000 };
    static triangle tri[n];
    real nan = (real)NAN;
    const triangle kind[] = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}},
                             {{1, 1, 0}, {1, 1, 0}, {1, 1, 0}},
                             {{0, 0, 0}, {4, 0, 0}, {0, nan, 0}}};
    const vec3 d[] = {{0, 0, -1}, {0, 0, 0}, {nan, 0, -1}, {real_infinity, 0, 0}};
    for (int k = 0; k < 16; k++) {
        for (int i = 0; i < n; i++) tri[i] = kind[k / 4];
        first_mesh m = {tri, n};
        hit h = {7, 7, 7, 7};
        ray r = ray_from((vec3){1, 1, 5}, d[k % 4]);
        check(first_mesh_hit(&m, r, &h) == (k == 0) && h.t == (k ? 7 : 5), "2000, case %d", k);
        check(!first_mesh_inside(&m, r.o, r.d), "an even number of them, case %d", k);
    }
}

/* Each edge of the tube runs once in each direction, and it surrounds its own middle line once. */
static void test_knot(void)
{
    first_mesh m = first_knot(36, 6);
    size_t open = 0;
    double sum = 0;
    check_equal(m.n, 2 * 36 * 6, "triangles of the tube");
    for (int i = 0; i < 3 * m.n; i++) {
        const vec3 *a = &m.tri[i / 3].a + i % 3, *b = &m.tri[i / 3].a + (i + 1) % 3;
        int back = 0;
        for (int j = 0; j < 3 * m.n; j++) {
            const vec3 *c = &m.tri[j / 3].a + j % 3, *d = &m.tri[j / 3].a + (j + 1) % 3;
            back += vzero(vsub(*a, *d)) && vzero(vsub(*b, *c));
        }
        open += back != 1;
    }
    check_equal(open, 0, "edges without a partner");
    vec3 p = first_knot_point((real)0.3);
    for (int i = 0; i < m.n; i++)
        sum += solid_angle(vsub(m.tri[i].a, p), vsub(m.tri[i].b, p), vsub(m.tri[i].c, p));
    check_close(sum / (4 * (double)pi), 1, 100 * eps, "wound once, outward");
    first_mesh_free(&m);
}

/* ---- files ---- */

static const char drawn[] = "@t.obj @t.png";  /* what write_file writes, by the program */

static const char *write_file(const char *text, size_t size)
{
    put_bytes("t.obj", text, size);
    return in_directory("t.obj");
}

/* How far first.h's triangles are from those of the full reader, relatively; infinite, if they are
 * more or fewer. In float those of the full reader are rounded once, strtod's twice. */
static double off_full(const char *path)
{
    mesh m;
    failure f;
    if (!obj_read(path, &m, &f)) fail(f);
    first_mesh soup = first_obj_read(path);
    double off = (size_t)soup.n == m.triangles ? 0 : HUGE_VAL;
    for (int i = 0; i < 3 * soup.n && off < HUGE_VAL; i++) {
        vec3 p = (&soup.tri[i / 3].a)[i % 3], q = m.v[m.index[i]];
        off = check_worse(off, (double)(vlength(vsub(p, q)) / (vlength(q) + real_smallest)));
    }
    mesh_free(&m), first_mesh_free(&soup);
    return off;
}

static const double off_allowed = real_is_float ? 2 * (double)FLT_EPSILON : 0;

static void test_valid_files(void)
{
    static const char *const text[] = {
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",                                /* no final newline */
        "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",                                  /* CRLF */
        "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3",
        "# a comment\n\nv 0 0 0 # here, too\nv 1 0 0\nv 0 1 0\n  \t\nf 1 2 3 # and here\n#",
        "v 1e-3 -2.5E2 +.5\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 7 7 7\nf -1 -2 -3\n",
        "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\nf 5 4 3 2\n",     /* polygons */
        /* NOLINTNEXTLINE(bugprone-suspicious-missing-comma): one file in two lines */
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1//1 2//1 3//1\n"
        "f 1/1 2/1 3/1\nf -3/-1/-1 -2/-1/-1 -1/-1/-1\n",
        "mtllib a.mtl\no x\ng y z\ns 1\n\tv 0 0 0\n  v 1 0 0\nv\t0 1\t0\nusemtl red\n"
        " f  1\t2  3 \n",
        "v 0 0 0 1\nv 1 0 0 .5 .5 .5\nv 0 1 0\nf 1 2 3\n"};           /* a weight, a colour */
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        check_at_most(off_full(write_file(text[i], strlen(text[i]))), off_allowed, "file %zu", i);
}

/* Both readers refuse these; the program ends with 2 and the line. */
static void test_broken_files(void)
{
    const struct { const char *text; int line; const char *what; } broken[] = {
        {"v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n", 2, "not a point"},
        {"v 0 0 0\nv 1 x 0\n", 2, "not a point"},
        {"v 0 0 0\nv\n", 2, "not a point"},
        {"v 0 0 nan\n", 1, "not a point"},
        {"\n\nv inf 0 0\n", 3, "not a point"},
        {"v 1e400 0 0\r\n", 1, "not a point"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", 4, "three corners"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf\n", 4, "three corners"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 # 3\n", 4, "three corners"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", 4, "no such point"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\n# f\nf 1 2 4", 5, "no such point"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", 4, "no such point"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999999999\n", 4, "no such point"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -99999999999999999999\n", 4, "no such point"},
        {"f -1 -1 -1\n", 1, "no such point"}};
    for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
        char line[32];
        const char *path = write_file(broken[i].text, strlen(broken[i].text));
        mesh m;
        failure f;
        check(!obj_read(path, &m, &f) && f.exit_code == 2, "file %zu: the full reader refuses", i);
        snprintf(line, sizeof line, "line %d: ", broken[i].line);
        check_equal(run("07_mesh_first", drawn), 2, "file %zu: exit code", i);
        check(printed("err", line) && printed("err", broken[i].what) && printed("err", "t.obj"),
              "file %zu: the message names the file, the line %d and what", i, broken[i].line);
        check(access(in_directory("t.png"), F_OK) != 0, "file %zu: no picture", i);
    }
    check_equal(run("07_mesh_first", "@none.obj @t.png"), 1, "no such file");
}

/* What the format allows and first.h does not read: it says so, or reads less, as its text says. */
static void test_limits(void)
{
    static const char late[] = "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", none[] = "# nothing\n";
    const char *path = write_file(late, strlen(late));
    mesh m;
    failure f;
    check(obj_read(path, &m, &f), "the full reader knows points that come later");
    mesh_free(&m);
    check_equal(run("07_mesh_first", drawn), 2, "first.h does not");
    first_mesh nothing = first_obj_read(write_file(none, strlen(none)));
    check(nothing.n == 0, "a file without faces has none");
    first_mesh_free(&nothing);
    nothing = first_obj_read(write_file("", 0));
    check(nothing.n == 0, "nor has an empty one");
    first_mesh_free(&nothing);
}

/* The program draws a file, and the knot if there is none. */
static void test_program(void)
{
    static const char text[] = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";
    (void)write_file(text, strlen(text));
    check_equal(run("07_mesh_first", drawn), 0, "a square");
    check(printed("out", "2 triangles, ") && printed("out", "t.png"), "it says what it drew");
    check(access(in_directory("t.png"), F_OK) == 0, "and there it is");
    (void)write_file("v 0 0 0\n\0v 1 0 0\n", 18);
    check(run("07_mesh_first", drawn) == 2 && printed("err", "line 2: not a text"), "a 0");
    check_equal(run("07_mesh_first", "@t.obj @t.png more"), 2, "one word too many");
    (void)write_file("", 0);
    check_equal(run("07_mesh_first", drawn), 0, "an empty file: an empty picture");
}

int main(void)
{
    if (!mkdtemp(directory)) abort();
    test_closest(torus_mesh(24));
    test_closest(octahedron_mesh(6));
    test_one();
    test_degenerate();
    test_knot();
    test_valid_files();
    test_broken_files();
    test_limits();
    test_program();
    const char *const files[] = {"t.obj", "t.png", "out", "err"};
    for (int i = 0; i < 4; i++) (void)remove(in_directory(files[i]));
    check(rmdir(directory) == 0, "no file is left");
    return check_report("07_first");
}
