/* Tests of chapters/27_effects: MTL, NFF, OBJ with materials, scene files.
 *
 * Oracle: numbers that a double holds exactly, written by hand.
 */
#include "27_files.h"
#include "../chapters/27_effects/appearance.h"
#include "../common/random.h"
#include <dirent.h>
#include <time.h>

static random_stream rng;
static size_t below(size_t n) { return (size_t)(random_next_bits(&rng) % n); }
static bool same(vec3 a, vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
static bool grey(vec3 a, real x) { return same(a, (vec3){x, x, x}); }

#define TRIANGLE "v 0 0 0\nv 1 0 0\nv 0 1 0\n"

/* The material of that name that a triangle is made of, from a.mtl. */
static studio_material material_in(const char *text, const char *name)
{
    studio s;
    failure f;
    char obj[300];
    snprintf(obj, sizeof obj, "mtllib a.mtl\n" TRIANGLE "usemtl %s\nf 1 2 3\n", name);
    put("a.mtl", text), put("a.obj", obj);
    if (!read_scene("a.obj", &s, &f)) {
        check(false, "%s", f.text);
        return (studio_material){.used = false};
    }
    studio_material m = s.material[studio_material_of(&s, 0, 0)];
    check_text(studio_material_name(&s, studio_material_of(&s, 0, 0)), name, "its name");
    studio_free(&s);
    return m;
}

/* ---- MTL ---- */

/* What a file says, 07_mtl reads; here, what becomes of it. */
static void test_mtl(void)
{
    studio_material m = material_in(
        "newmtl other\nKd 0 0 0\nnewmtl a b\nKd .5 .25 1\nNs 96\nTr 0.75\npriority 3\n"
        "Ks spectral x.rfl\nmap_Kd x.png\n", "a b");
    check(same(m.mtl.kd, (vec3){0.5, 0.25, 1}) && m.mtl.ns == 96 && m.mtl.d == (real)0.25
          && m.mtl.priority == 3 && m.mtl.illum == -1 && grey(m.mtl.ks, 0), "numbers");
    check(m.at.line == 3 && m.said[MTL_KD].line == 4 && m.said[MTL_D].line == 6
          && m.said[MTL_PRIORITY].line == 7 && m.said[MTL_KD].file == m.at.file, "lines");
    check(!m.said[MTL_KS].file && !m.said[MTL_ILLUM].file, "what nobody said");
    check(m.library && !m.classic, "of a library");
    m = material_in("newmtl a\nKd 0\nnewmtl a\nKd 0.5\n", "a");
    check(grey(m.mtl.kd, 0.5), "the later of two counts");
}

static void test_mtl_broken(void)
{
    static const struct { const char *text, *where, *allowed; } list[] = {
        {"Kd 1 1 1\n", "a.mtl:1: line: before the first material: 'Kd'", "newmtl NAME"},
        {"newmtl a\nKd 1 2 3 4\n", "a.mtl:2: Kd: too much: '4'", "the end of the line"},
        {"newmtl a\nroughness .2\n", "a.mtl:2: roughness: 'a' is no glass", "illum 7, Tf"},
        {"newmtl b\n\nroughness .2\nNs 9\nillum 3\nnewmtl a\n", "a.mtl:3: roughness: 'b'",
         "say Ns"},
        {"newmtl a\nillum 7\nroughness .2\nTf 0\nNi 2\n", "a.mtl:3: roughness: 'a'", "above 0"},
        {"newmtl a\nillum 7\nroughness .2\nTf 1\n", "a.mtl:3: roughness: 'a'", "Ni not 1"}};
    put("a.obj", "mtllib a.mtl\n" TRIANGLE "usemtl a\nf 1 2 3\n");
    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        refused("a.mtl", list[i].text, "a.obj", 2, list[i].where, list[i].allowed);
}

/* A hundred thousand materials, each used once: by searching a list this takes minutes. */
static void test_many_materials(void)
{
    size_t n = check_count(100000), m = 0, o = 0;
    char *mtl = allocate(n + 1, 40), *obj = allocate(n + 8, 40);
    studio s;
    failure f;
    o += (size_t)sprintf(obj, "mtllib a.mtl\nmtllib a.mtl a.mtl\n" TRIANGLE);
    for (size_t i = 0; i < n; i++) {
        m += (size_t)sprintf(mtl + m, "newmtl m%zu\nNs %zu\n", i, i);
        o += (size_t)sprintf(obj + o, "usemtl m%zu\nf 1 2 3\n", n - 1 - i);
    }
    put("a.mtl", mtl), put("a.obj", obj);
    clock_t start = clock();
    bool ok = read_scene("a.obj", &s, &f);
    double t = (double)(clock() - start) / CLOCKS_PER_SEC;
    check(ok, "%s", f.text);
    check(ok && s.material[studio_material_of(&s, 0, 0)].mtl.ns == (real)(n - 1)
          && s.material[studio_material_of(&s, 0, (uint32_t)n - 1)].mtl.ns == 0, "each its own");
    check(ok && s.libraries == 1, "a library that is named thrice is read once");
    check_at_most(t, 3, "many materials take time that grows with their number alone: some 0.05 s");
    if (ok) studio_free(&s);
    free(mtl), free(obj);
}

/* Notes are kept up to twenty, whole; a fuzzer once found them copied beyond their end. */
static void test_notes(void)
{
    char mtl[3000] = "newmtl a\n";
    studio s;
    failure f;
    for (int i = 0; i < 100; i++) strcat(mtl, i % 3 ? "Ni 0\n" : "Kd spectral x.rfl\n");
    put("a.mtl", mtl), put("a.obj", "mtllib a.mtl\n" TRIANGLE "usemtl a\nf 1 2 3\n");
    bool ok = read_scene("a.obj", &s, &f);
    check(ok && s.note_count == 100 && s.note_size == strlen(s.notes), "%s", f.text);
    size_t lines = 0;
    for (const char *p = s.notes; ok && *p; p++) lines += *p == '\n';
    check_equal(lines, (size_t)studio_most_notes, "lines of notes");
    check(ok && strstr(s.notes, "a.mtl:2: Kd: only r g b is read\n")
          && strstr(s.notes, "a.mtl:21: Ni 0 is taken as 1\n"), "%s", s.notes);
    if (ok) studio_free(&s);
}

/* ---- OBJ as programs write it ---- */

#define BLENDER "# Blender v2.79 (sub 0) OBJ File: 'x.blend'\n# www.blender.org\n"                \
    "mtllib blend.mtl\no Cube_Cube.001\nv 1.000000 1.000000 -1.000000\nv 1.0 -1.0 -1.0\n"          \
    "v -1.0 -1.0 -1.0\nv -1.0 1.0 -1.0\nvt 0.625 0.5\nvn 0.0 0.0 -1.0\nusemtl Material\n"          \
    "s off\ng Cube_Cube.001_Material\nf 1/1/1 2/1/1 3/1/1 4/1/1\nusemtl None\ns 1\n"             \
    "f 1//1 2//1 3//1\nl 1 2\n"
#define MESHLAB "####\n#\n# OBJ File Generated by Meshlab\n#\n####\n# Object ml.obj\n#\n"          \
    "# Vertices: 3\n# Faces: 1\n#\n####\nmtllib ./ml.obj.mtl\n\nvn 0.000000 0.000000 1.570796\n"  \
    "v 0.000000 0.000000 0.000000 0.5 0.5 0.5\nvn 0 0 1.570796\nv 1 0 0 0.5 0.5 0.5\n"            \
    "vn 0 0 1.570796\nv 0 1 0 0.5 0.5 0.5\n# 3 vertices, 0 vertices normals\n\n"                \
    "usemtl material_0\nf 1//1 2//2 3//3\n# 1 faces, 0 coords texture\n\n# End of File\n"
#define FACE "f 1 2 3\n"

/* Which Kd each triangle gets; -1: what the place is made of. What is noted. */
static void test_exports(void)
{
    static const struct { const char *obj; double kd[3]; int notes; const char *says; } list[] = {
        {BLENDER, {0.64, 0.64, -1}, 1, "textures are not read"}, {MESHLAB, {0.501961}, 0, ""},
        /* usemtl before mtllib, and without a name */
        {"usemtl a\nmtllib left.mtl\n" TRIANGLE "f 1/ 2/ 3/\nusemtl\nf 1// 2// 3//\n",
         {0.5, -1}, 0, ""},
        /* libraries that are not there: the last part of a path is looked for beside the file */
        {"mtllib C:\\Users\\me\\left.mtl\nmtllib /no/such/other.mtl\n" TRIANGLE "usemtl a\n" FACE
         "usemtl b\n" FACE, {0.5, -1}, 2, "no file '/no/such/other.mtl'"},
        {"mtllib left.mtl\nmtllib no.mtl\n" TRIANGLE "usemtl b\n" FACE, {-1}, 2, "material 'b'"},
        /* no library: a warning, once */
        {TRIANGLE "usemtl a\n" FACE "usemtl (null)\n" FACE "usemtl a\n" FACE, {-1, -1, -1}, 1,
         "material 'a' is nowhere"},
        /* blanks in a name; the first library counts */
        {"mtllib my pot.mtl\nmtllib no.mtl two.mtl\n" TRIANGLE FACE "usemtl a\n" FACE "usemtl c\n"
         FACE, {-1, 0.25, 0.5}, 1, "no.mtl"}};
    put("blend.mtl", "# Blender MTL File: 'x.blend'\n# Material Count: 1\n\nnewmtl Material\n"
        "Ns 96.078431\nKa 1.000000 1.000000 1.000000\nKd 0.640000 0.640000 0.640000\n"
        "Ks 0.500000 0.500000 0.500000\nKe 0.000000 0.000000 0.000000\nNi 1.000000\nd 1.000000\n"
        "illum 2\nmap_Kd C:\\\\textures\\\\wood.png\n");
    put("ml.obj.mtl", "#\n# Wavefront material file\n# Converted by Meshlab Group\n#\n\n"
        "newmtl material_0\nKa 0.200000 0.200000 0.200000\nKd 0.501961 0.501961 0.501961\n"
        "Ks 1.000000 1.000000 1.000000\nTr 0.000000\nillum 2\nNs 0.000000\n\n");
    put("left.mtl", "newmtl a\nKd 0.5\n"), put("my pot.mtl", "newmtl a\nKd 0.25\n");
    put("two.mtl", "newmtl a\nKd 0.75\nnewmtl c\nKd 0.5\n");
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        studio s;
        failure f;
        put("e.obj", list[i].obj);
        bool ok = read_scene("e.obj", &s, &f);
        check(ok, "%zu: %s", i, f.text);
        if (!ok) continue;
        check((int)s.note_count == list[i].notes && strstr(s.notes ? s.notes : "", list[i].says),
              "%zu: %zu notes: %s", i, s.note_count, s.notes ? s.notes : "");
        uint32_t triangles = 0;
        for (uint32_t k = 0; k < 3 && list[i].kd[k] != 0; k++, triangles++) {
            uint32_t m = studio_material_of(&s, 0, k);
            bool default_one = list[i].kd[k] < 0;
            check(default_one ? m == 0 : grey(s.material[m].mtl.kd, (real)list[i].kd[k])
                                             && s.material[m].mtl.d == 1, "%zu, triangle %u", i,
                  (unsigned)k);
        }
        check(s.mesh[0].triangles == triangles && (i > 1 || s.mesh[0].n), "%zu: triangles", i);
        studio_free(&s);
    }
}

/* ---- NFF ---- */

/* The text with that in place of each blank. */
static void put_with(const char *name, const char *text, const char *blank)
{
    char out[2000];
    size_t n = 0;
    for (; *text && n + 8 < sizeof out; text++)
        n += (size_t)snprintf(out + n, sizeof out - n, *text == ' ' ? "%s" : "%.1s",
                              *text == ' ' ? blank : text);
    put(name, out);
}

static bool made_of(const studio_material *m, vec3 kd, vec3 ks, real ns, real t, real ni)
{
    const mtl_material *is = &m->mtl;
    return same(is->kd, kd) && same(is->ks, ks) && is->ns == ns && grey(is->tf, t) && is->ni == ni
        && m->classic && m->said[MTL_KD].file == m->at.file && m->said[MTL_ILLUM].file;
}

/* Every statement, whatever stands between words; shapes and triangles in their order, each of its
 * material. */
static void test_nff(void)
{
    static const char text[] =
        "#_a_comment,p_3_s_1\nb .5 .25 .125 v from 3 0 1 at 3 4 1 up 0 0 1 angle 45 hither 0.5 "
        "resolution 512 512 l 0 0 1\n#s_1_1_1_1\nl 3 4 3 f 1 .5 0 .5 .25 9 0 0 s 1 2 3 0.75 "
        "p 3 0 0 0 1 0 0 0 1 0 f 0 1 .5 .25 .5 3 .75 1.5 c 0 0 0 1 0 0 2 0.5 "
        "p 4 0 0 0 2 0 0 2 2 0 0 2 0 p 3 0 0 1 1 0 1 0 1 1 p 3 0 0 2 1 0 2 0 1.375 2 ";
    const vec3 colour[2] = {{1, 0.5, 0}, {0, 1, 0.5}}, foot = {0, 0, 0}, top = {0, 0, 2};
    for (int k = 0; k < 3; k++) {
        studio s;
        failure f;
        put_with("w.nff", text, (const char *[]){" ", "\n", "\t \r\n  "}[k]);
        bool ok = read_scene("w.nff", &s, &f);
        check(ok, "%s", f.text);
        if (!ok) continue;
        check(s.shapes == 3 && s.meshes == 1 && s.mesh[0].triangles == 3 && !s.mesh[0].n, "counts");
        const shape *x = s.shape;
        check(x[0].kind == SHAPE_SPHERE && x[0].sphere.r == (real)0.75
              && same(x[0].sphere.c, (vec3){1, 2, 3}), "sphere");
        check(x[1].kind == SHAPE_CONE && same(x[1].cone.a, foot) && same(x[1].cone.b, top)
              && x[1].cone.ra == 1 && x[1].cone.rb == (real)0.5, "cone");
        check(x[2].polygon.n == 4 && same(x[2].polygon.v[3], (vec3){0, 2, 0}), "polygon");
        for (size_t i = 0; i < 3; i++) {
            vec3 c = mesh_triangle(&s.mesh[0], i).c;
            check(same(c, (vec3){0, i == 2 ? (real)1.375 : 1, (real)i}), "triangle %zu", i);
        }
        const uint32_t of[6] = {s.shape_material[0], studio_material_of(&s, 0, 0),
                                s.shape_material[1], s.shape_material[2],
                                studio_material_of(&s, 0, 1), studio_material_of(&s, 0, 2)};
        for (int i = 0; i < 6; i++) {
            bool second = i > 1;
            vec3 kd = vscale(colour[second], second ? (real)0.25 : (real)0.5);
            vec3 ks = vscale(colour[second], second ? (real)0.5 : (real)0.25);
            check(made_of(&s.material[of[i]], kd, ks, second ? 3 : 9, second ? (real)0.75 : 0,
                          second ? (real)1.5 : 1), "made of, %d", i);
        }
        check(same(s.view.from, (vec3){3, 0, 1}) && same(s.view.at, (vec3){3, 4, 1})
              && same(s.view.up, (vec3){0, 0, 1}) && s.view.angle == 45
              && s.view.hither == (real)0.5, "view");
        check(same(s.sky.background, vec(0.5, 0.25, 0.125)) && s.sky.kind == SKY_NONE, "behind");
        check(s.lights == 2 && same(s.light[1].light.at, (vec3){3, 4, 3}), "lights");
        for (int l = 0; l < 2; l++) {  /* (27.4): E / pi at `at` is 1 / (2 sqrt 2), as in 1987 */
            real D2 = l ? 4 : 25;
            vec3 c = s.light[l].light.colour;
            check(grey(c, c.x), "white");
            check_close(c.x / (pi * D2), sqrt(0.125), 8 * (double)real_epsilon,
                        "a light's strength where the camera looks");
        }
        studio_free(&s);
    }
}

static void test_nff_rest(void)
{
    studio s;
    failure f;
    put("r.nff", "s 0 0 0 -2 # inside\nl 1 2 3 0 0.25 1 l 4 5 6 f 1 1 1 .5 .5 3 0 0\ns 1 1 1 1\n"
        "f 1 1 1 .5 .5 3 0 0 c 0 0 0 -1 0 0 1 0.5\npp 3 0 0 0 0 0 1 1 0 0 0 1 1 0 1 0 1 0 1\n"
        "p 3 5 0 0 6 0 0 5 1 0\n"
        "pp 4 0 0 0 0 0 2 2 0 0 0 0 2 0.5 0.5 0 0 0 2 0 2 0 0 0 2");
    bool ok = read_scene("r.nff", &s, &f);
    check(ok, "%s", f.text);
    if (!ok) return;
    check(s.shapes == 3 && s.shape[0].sphere.r == -2 && s.shape[2].cone.ra == -1, "negative radii");
    check(s.shape_material[0] == 0 && s.shape_material[1] == 1, "before the first f: the default");
    check(s.lights == 2 && !s.view.given, "lights, no view");
    vec3 c = s.light[0].light.colour;
    check(c.x == 0 && c.y > 0 && c.z == 4 * c.y, "a light without red is a colour, too: %g %g %g",
          (double)c.x, (double)c.y, (double)c.z);
    const mesh *m = &s.mesh[0];
    check(m->triangles == 4 && m->n, "two triangles and a concave patch of two: %zu", m->triangles);
    check(same(mesh_normal(m, 1, 0.25, 0.25), (vec3){0, 0, 1}),
          "a triangle without normals keeps its own");
    vec3 n = mesh_normal(m, 0, 1, 0);
    check_close(n.y, sqrt(0.5), 4 * (double)real_epsilon, "the normal of a corner");
    check_close(vlength(n), 1, 4 * (double)real_epsilon, "made unit");
    studio_free(&s);
}

static void test_nff_broken(void)
{
    static const struct { const char *text, *where, *allowed; } list[] = {
        {"s 0 0 0\n", "b.nff:2: s: no number before the end of the file", "a number"},
        {"s 0 0 0 x", "b.nff:1: s: not a number: 'x'", "finite"},
        {"\n\ns 0 nan 0 1", "b.nff:3: s: not a number: 'nan'", "finite"},
        {"q 1 2 3", "b.nff:1: line: begins with 'q'", "v, b, l, f, s, c, p, pp"},
        {"p 2 0 0 0 1 1 1", "b.nff:1: p: out of range: '2'", "3 to"},
        {"p 3.5 0 0 0", "b.nff:1: p: not a whole number", "3 or more"},
        {"p 1000000000 0 0 0 1 1 1 2 0 0", "b.nff:1: p: ", "a number"},
        {"p -4 0 0 0", "b.nff:1: p: out of range: '-4'", "3 to 1e+09"},
        {"v from 0 0 0 at 1 1 1 up 0 0 1\ns 0 0 0 1", "b.nff:2: v: from, at, up or angle is",
         "all four"},
        {"v from 0 0 0 angle 180", "b.nff:1: angle: out of range: '180'", "179.999"},
        {"f 1 1 1 .5 .5 3 2 1", "b.nff:1: f: out of range: '2'", "0 to 1"},
        {"f 1 1 1 .5 .5 -3 0 1", "b.nff:1: f: out of range: '-3'", "0 to 1e+09"},
        {"l 1 2 3 4", "b.nff:1: l: ", "a number"},
        {"b 1 1 -1", "b.nff:1: b: out of range: '-1'", "0"},
        {"s 1 2 3 1e999", "b.nff:1: s: out of range: '1e999'", "to"}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        refused("b.nff", list[i].text, "b.nff", 2, list[i].where, list[i].allowed);
    refused("b.nff", real_is_float ? "s 0 0 0 1\nl 1e38 0 0" : "s 0 0 0 1\nl 1e300 0 0", "b.nff", 2,
            "b.nff:2: l: too far away", "nearer");
    char big[300 * 40] = "pp 300\n";  /* a star of 300 corners: corner 0 does not see them all */
    for (int i = 0; i < 300; i++) {
        double r = i % 2 ? 1 : 3, a = 2 * 3.14159265358979 * i / 300;
        sprintf(big + strlen(big), "%.6f %.6f 0 0 0 1\n", r * cos(a), r * sin(a));
    }
    refused("b.nff", big, "b.nff", 2, "b.nff:301: pp: a concave patch", "up to 256 corners");
}

/* ---- patches ---- */

/* A ring of corners at rising angles: seen as a whole from the middle, but not from corner 0. */
static size_t random_star(vec3 *v, vec3 x, vec3 y, vec3 at)
{
    size_t n = 3 + below(30);
    for (size_t i = 0; i < n; i++) {
        real a = 2 * pi * (real)i / (real)n, r = (real)0.25 + random_next(&rng) * (n > 3);
        v[i] = vadd(at, vadd(vscale(x, r * cos(a)), vscale(y, r * sin(a))));
    }
    return n;
}

/* The triangles cover the polygon: random points are in one of them where 07 finds them inside. */
static void test_patches(void)
{
    for (size_t round = check_count(400); round-- > 0;) {
        vec3 v[40], n = vunit((vec3){random_next(&rng) - (real)0.5, random_next(&rng) - (real)0.5,
                                     random_next(&rng) - (real)0.5}), x, y;
        uint32_t index[3 * 40];
        vbasis(n, &x, &y);
        size_t corners = random_star(v, x, y, (vec3){3, 1, -2});
        size_t triangles = patch_triangles(v, corners, index);
        check(triangles == corners - 2, "n - 2 triangles");
        polygon p = polygon_of(v, corners);
        vec3 whole = {0, 0, 0}, sum = whole;
        for (size_t i = 2; i < corners; i++)
            whole = vadd(whole, vcross(vsub(v[i - 1], v[0]), vsub(v[i], v[0])));
        bool left = true;
        for (size_t k = 0; k < triangles; k++) {
            triangle t = {v[index[3 * k]], v[index[3 * k + 1]], v[index[3 * k + 2]]};
            vec3 area = vcross(vsub(t.b, t.a), vsub(t.c, t.a));
            left = left && vdot(area, n) > -64 * real_epsilon;
            sum = vadd(sum, area);
        }
        check(left, "no triangle is turned round");
        check_at_most((double)vlength(vsub(sum, whole)), 40 * 20 * (double)real_epsilon,
                      "their areas add up to the polygon's: 40 sums up to 14, each part off by 13");
        size_t wrong = 0;
        for (int q = 0; q < 50; q++) {
            vec3 at = vmadd((vec3){3, 1, -2}, y, random_next(&rng) * 3 - (real)1.5);
            at = vmadd(at, x, random_next(&rng) * 3 - (real)1.5);
            ray r = ray_from(vadd(at, n), vneg(n));
            hit h;
            bool in = polygon_hit(p, r, &h), found = false;
            for (size_t k = 0; k < triangles; k++)
                found = found || triangle_hit((triangle){v[index[3 * k]], v[index[3 * k + 1]],
                                                         v[index[3 * k + 2]]}, r, &h);
            wrong += in != found;
        }
        check_at_most(wrong, real_is_float ? 1 : 0, "points inside, as the polygon has them");
    }
}

/* ---- scene files ---- */

static void test_scene(void)
{
    studio s;
    failure f;
    put("i.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    put("i.obj", "mtllib i.mtl\n" TRIANGLE "f 1 2 3\nusemtl red\nf 1 2 3\n");
    put("i.nff", "b 1 1 1 s 1 0 0 2 p 4 0 0 0 1 0 0 1 1 0 0 1 0 p 3 0 0 0 1 0 0 0 1 0");
    put("inner.scene", "use gold\nsphere 9 9 9 1\n");
    put("a b.obj", TRIANGLE "f 3 2 1\n");
    put("s.scene", "# all statements\nup z\nbackground 0.5\ncamera from 0 -8 2 at 0 0 1 angle 30"
        " hither 0.25\nlens radius 0.125 focus 7\nlight at 1 2 3 colour 4\n"
        "sun to 0 0 2 colour 1 2 3\n"
        "environment 0.25 1 # gradient\nmaterial gold # a name\n  Kd 0.75 0.5 0\n  illum 3\n"
        "\tKs .25\n"
        "sphere 1 2 3 -0.5\ncone 0 0 0 1  0 0 2 0\npolygon 0 0 0 1 0 0 1 1 0 \\\n 0 1 0\n"
        "obj i.obj smooth scale 2 turn 0 0 1 90 move 1 0 0\nmtl i.mtl\n"
        "use blue \t# of the library\nmesh pot i.obj\n"
        "instance pot\ninstance pot scale 1 1 -1\nobj \"a b.obj\"\nnff i.nff\n"
        "include inner.scene\n");
    bool ok = read_scene("s.scene", &s, &f);
    check(ok, "%s", f.text);
    if (!ok) return;
    check(s.up == 2 && grey(s.sky.background, 1) && s.view.hither == (real)0.25, "up, background");
    check(same(s.view.from, (vec3){0, -8, 2}) && same(s.view.up, (vec3){0, 0, 1})
          && s.view.angle == 30 && s.view.said.line == 4, "camera");
    check(s.lens.radius == (real)0.125 && s.lens.focus == 7 && s.lens.said.line == 5, "lens");
    check(s.lights == 2 && s.light[0].light.kind == LIGHT_POINT && grey(s.light[0].light.colour, 4)
          && same(s.light[1].light.at, (vec3){0, 0, 1}) && s.light[1].at.line == 7, "light, sun");
    check(s.sky.kind == SKY_GRADIENT && same(sky_radiance(&s.sky, (vec3){0, 0, -3}), s.sky.low)
          && grey(sky_radiance(&s.sky, (vec3){1, 0, 0}), 0.625), "environment");
    uint32_t gold = s.shape_material[0];
    check_text(studio_material_name(&s, gold), "gold", "the material of a sphere");
    check(s.material[gold].mtl.illum == 3 && s.material[gold].said[MTL_ILLUM].line == 11,
          "described");
    check(s.shapes == 6, "sphere, cone, polygon, two of NFF, one included: %zu", s.shapes);
    check(s.shape[2].polygon.n == 4 && same(s.shape[2].polygon.v[3], (vec3){0, 1, 0}), "polygon");
    check(same(s.shape[3].sphere.c, (vec3){1, 0, 0}) && s.shape[3].sphere.r == 2, "NFF");
    check(same(s.shape[4].polygon.v[1], (vec3){1, 0, 0}), "NFF, a polygon");
    check(s.shape_material[5] == gold, "what is included stands there");
    check(s.places == 5 && s.meshes == 4, "places %zu, meshes %zu: a file is read once for smooth, "
          "once not", s.places, s.meshes);
    vec3 p = affine_point(s.placed[0].to_world, (vec3){1, 0, 0});
    check_at_most((double)vlength(vsub(p, (vec3){1, 2, 0})), 8 * (double)real_epsilon,
                  "scaled, turned, moved, in this order");
    check(studio_material_of(&s, 0, 0) == gold, "without usemtl: what was current");
    check_text(studio_material_name(&s, studio_material_of(&s, 1, 0)), "blue", "by use");
    check_text(studio_material_name(&s, studio_material_of(&s, 1, 1)), "red", "by usemtl");
    check(studio_stands(&s, 1) && !studio_stands(&s, 2), "stands, is moved");
    studio_free(&s);
}

/* All that lie in scenes/: read without a note; of box.scene what its book has. */
static void test_shipped(void)
{
    const char *where = "chapters/27_effects/scenes/";
    DIR *folder = opendir(where);
    size_t read = 0;
    for (struct dirent *x; folder && (x = readdir(folder));) {
        char path[400];
        studio s;
        failure f;
        if (!strstr(x->d_name, ".scene")) continue;
        if (!strcmp(x->d_name, "showpiece.scene")) continue;  /* its teapot: make showpiece */
        snprintf(path, sizeof path, "%s%s", where, x->d_name);
        bool ok = studio_read(path, NULL, &s, &f);
        check(ok, "%s", f.text);
        if (!ok) continue;
        check_equal(s.note_count, 0, "%s: notes", path);
        if (!strcmp(x->d_name, "box.scene"))
            check(s.shapes == 12 && s.emitters == 1, "five walls, a lamp, five faces, a ball");
        studio_free(&s), read++;
    }
    if (folder) closedir(folder);
    check_at_least(read, 12, "scenes");
}

/* What the command line says comes last and replaces. */
static void test_words(void)
{
    studio s;
    failure f;
    studio_words w = {.camera = "from 1 0 0 at 0 0 0",
                      .light = "at 0 0 1 colour 1; at 0 0 2 colour 2",
                      .environment = "0.5", .up = "x", .lens = "radius 2"};
    const char *text = "light at 5 5 5 colour 5\nsun to 1 0 0 colour 1\nenvironment 1 2\n"
        "lens radius 1\ncamera from 0 0 9 at 0 0 0\nsphere 0 0 0 1\n";
    bool ok = studio_read_text(text, "t", &w, &s, &f);
    check(ok, "%s", f.text);
    if (!ok) return;
    check(s.lights == 2 && s.light[1].light.at.z == 2, "lights of the files are replaced");
    check_text(studio_said(&s, s.light[1].at).text, "--light:2", "says from where");
    check(s.view.from.x == 1 && s.sky.kind == SKY_CONSTANT && s.lens.radius == 2, "the rest");
    studio_free(&s);
    ok = studio_read_text(text, "t", NULL, &s, &f);
    check(ok && s.lights == 2 && s.light[1].light.kind == LIGHT_DIRECTIONAL, "without: as it was");
    if (ok) studio_free(&s);
    w.light = "at 1 2";
    ok = studio_read_text(text, "t", &w, &s, &f);
    check(!ok && strstr(f.text, "--light:1: light: no number before"), "%s", f.text);
    if (ok) studio_free(&s);
}

static void test_scene_broken(void)
{
    static const struct { const char *text, *where, *allowed; } list[] = {
        {"sphre 0 0 0 1\n", "x.scene:1: line: begins with 'sphre'", "sphere"},
        {"sphere 0 0 0\n", "x.scene:1: sphere: no number before", "a number"},
        {"sphere 0 0 0 1 2\n", "x.scene:1: sphere: too much: '2'", "the end of the line"},
        {"\ncamera from 0 0 0\n", "x.scene:2: camera: something is missing", "from X Y Z at X Y Z"},
        {"camera from 0 0 0 at 1 1\n", "x.scene:1: camera: no number before", "a number"},
        {"camera from 0 0 0 at 1 1 1 angle 180\n", "out of range: '180'", "0.001 to 179"},
        {"camera form 0 0 0\n", "what is 'form'", "from, at, up, angle, hither"},
        {"lens focus 3\n", "x.scene:1: lens: something is missing", "radius X"},
        {"light at 1 1 1\n", "x.scene:1: light: something is missing", "colour C"},
        {"light at 1 1 1 colour -1\n", "out of range: '-1'", "0 to 1e+30"},
        {"sun to 0 0 0 colour 1\n", "sun: no direction before", "not all 0"},
        {"up w\n", "x.scene:1: up: no axis: 'w'", "x, y, z"},
        {"Kd 1 1 1\n", "x.scene:1: line: describes nothing: 'Kd'", "material NAME"},
        {"material a\nKd 2 x\n", "x.scene:2: Kd: too much: 'x'", "the end"},
        {"use gilt\n", "x.scene:1: use: no material 'gilt'", "names that material"},
        {"sphere 0 0 0 1 gold2\n", "x.scene:1: sphere: no material 'gold2'", "white, chrome"},
        {"box 0 0 0 1 1\n", "x.scene:1: box: no number before", "a number"},
        {"indirect maybe\n", "x.scene:1: indirect: neither on nor off: 'maybe'", "on, off"},
        {"mesh a i.obj\nmesh a i.obj\n", "x.scene:2: mesh: 'a' is a mesh", "each name"},
        {"instance pot\n", "x.scene:1: instance: no mesh 'pot'", "names that mesh"},
        {"environment\n", "x.scene:1: environment: something is missing", "a picture"},
        {"environment 1 2 3 4\n", "environment: numbers end", "1, 2, 3 or 6"},
        {"environment 1 2 3 4 5 6 7\n", "environment: too much: '7'", "the end of the line"},
        {"environment i.mtl\n", "i.mtl: no whole P3, P6 or PF picture", ""},
        {"environment nan.pfm\n", "nan.pfm: pixel 1 0: no light", "0 to 1e+30"},
        {"polygon 0 0 0 1 1 1\n", "x.scene:1: polygon: too few corners", "3 or more"},
        {"obj i.obj move x\n", "x.scene:1: obj: not a number: 'x'", "finite"},
        {"obj i.obj turn 0 0 0 5\n", "obj: no axis before", "turn X Y Z DEGREES"},
        {"obj i.obj scale 0\n", "obj: scaled to nothing", "none 0"},
        {"obj i.obj scale 1e30 scale 1e30 scale 1e30 scale 1e30 scale 1e30 scale 1e30 scale 1e30 "
         "scale 1e30 scale 1e30 scale 1e30 scale 1e30\n", "beyond what numbers hold", ""},
        {"solid\n", "x.scene:1: solid: something is missing before", "a name"},
        {"solid gilt sphere 0 0 0 1\n", "x.scene:1: solid: no material 'gilt'", "white, chrome"},
        {"solid red difference(sphere 0 0 0 1)\n", "x.scene:1: solid: character 26: ')'",
         "a comma"},
        {"solid red ball 0 0 0 1\n", "x.scene:1: solid: character 1: 'ball'", "sphere, box"},
        {"\nsolid glass sphere 0 0 0 1\n", "x.scene:2: solid: 'glass' lets light through",
         "do not"},
        {"solid lamp sphere 0 0 0 1\n", "x.scene:1: solid: 'lamp' emits light", "do not"},
        {"obj \"i.obj\n", "obj: not the name of a file", "FILE"},
        {"obj \"\"\n", "obj: not the name of a file", "FILE"},
        {"nff i.nff scale 1 2 1\n", "x.scene:1: nff: too much: 'scale'", "the end of the line"},
        {"cone 0 0 0 1  0 1 0 0  lamp\n", "x.scene:1: cone: 'lamp' emits light", "do not"},
        {"nff x.scene\n", "x.scene:1: line: begins with 'nff'", "v, b, l"},
        {"include x.scene\n", "x.scene:1: include: ", "nested too deep"}};
    put_bytes("nan.pfm", "PF 2 1 -1\n\0\0\0\0\0\0\0\0\0\0\0\0\0\0\xc0\x7f\0\0\0\0\0\0\0\0", 34);
    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        refused("x.scene", list[i].text, "x.scene", 2, list[i].where, list[i].allowed);
    char many[65 * 50 + 1] = "";
    for (int i = 0; i < 65; i++) strcat(many, "solid red half 0 1 0 1\nsolid red sphere 0 0 0 1\n");
    refused("x.scene", many, "x.scene", 2, "x.scene:129: solid: one too many without end", "64");
    refused("x.scene", "include no.scene\n", "x.scene", 1, "no.scene: cannot read: No such",
            "/x.scene:1: ");
    refused("x.scene", "\n\nobj no.obj\n", "x.scene", 1, "no.obj: cannot read: No such",
            "/x.scene:3: ");
    refused("x.scene", "include .\n", "x.scene", 1, "cannot read: Is a directory", "");
    refused("x.scene", "include /dev/zero\n", "x.scene", 1, "/dev/zero: cannot read: a device", "");
    refused("x.scene", "environment /dev/zero\n", "x.scene", 1, "/dev/zero: cannot read: not", "");
    refused("x.scene", "environment no.pfm\n", "x.scene", 1, "no.pfm: cannot read", "");
    refused("x.scene", "obj empty.obj\n", "x.scene", 1, "empty.obj", "");
    put("empty.obj", "");
    refused("x.scene", "obj empty.obj\n", "x.scene", 2, "empty.obj:1: line: no face", "1 or more");
    char star[8000];
    int n = sprintf(star, "material m\nKe 1\npolygon");
    for (int k = 0; k < 258; k++)
        n += sprintf(star + n, " %.4f %.4f 0", (1 + k % 2) * cos((double)pi * k / 129),
                     (1 + k % 2) * sin((double)pi * k / 129));
    refused("x.scene", star, "x.scene", 2, "x.scene:2: Ke: of a concave polygon of 258", "to 256");
}

/* A picture that is black, or scaled to black, is no light. */
static void test_black_sky(void)
{
    static const char *const text[] = {"environment one.pfm\n", "environment one.pfm scale 0\n",
                                       "environment black.pfm\n"};
    put_bytes("one.pfm", "PF 1 1 -1\n\0\0\x80\x3f\0\0\0\0\0\0\0\0", 22);
    put_bytes("black.pfm", "PF 1 1 -1\n\0\0\0\0\0\0\0\0\0\0\0\0", 22);
    for (int k = 0; k < 3; k++) {
        studio s;
        failure f;
        put("x.scene", text[k]);
        check(read_scene("x.scene", &s, &f), "%s", f.text);
        vec3 L = sky_radiance(&s.sky, (vec3){0, 0, 1});
        check(sky_lights(&s.sky) == (k == 0) && L.x == (k == 0), "%s: %g", text[k], (double)L.x);
        studio_free(&s);
    }
}

/* A box is closed and its faces look outwards: volume by the divergence theorem, also mirrored and
 * turned: 1/3 sum of area (n.p). Listed materials have an appearance each, and all are in use. */
static void test_box(void)
{
    static const char *const placed[] = {"", "turn 1 2 3 40 move 5 0 0", "scale -1 1 1 gold"};
    for (int k = 0; k < 3; k++) {
        studio s;
        failure f;
        char text[100];
        double volume = 0;
        snprintf(text, sizeof text, "box 3 1 2  0 0 0 %s\n", placed[k]);
        put("x.scene", text);
        if (!read_scene("x.scene", &s, &f)) {
            check(false, "%s", f.text);
            continue;
        }
        for (size_t i = 0; i < s.shapes; i++) {
            polygon g = s.shape[i].polygon;
            vec3 n = vcross(vsub(g.v[1], g.v[0]), vsub(g.v[3], g.v[0]));
            volume += (double)vdot(n, g.v[0]) / 3;
        }
        check_equal(s.shapes, 6, "faces");
        /* six times an area of up to 6 by a place of up to 8, over 3, each off by some 4 epsilon */
        check_close(volume, 6, 400 * (double)real_epsilon, "its volume, %s", placed[k]);
        if (k == 2) check_text(studio_material_name(&s, s.shape_material[0]), "gold", "made of");
        studio_free(&s);
    }
    for (size_t i = 0; i < sizeof material_list / sizeof *material_list; i++) {
        studio s;
        failure f;
        char text[100];
        snprintf(text, sizeof text, "sphere 0 0 0 1 %s\n", material_list[i].name);
        put("x.scene", text);
        bool ok = read_scene("x.scene", &s, &f);
        check(ok, "%s", f.text);
        if (!ok) continue;
        appearance a = appearance_of(&s.material[s.shape_material[0]]);
        check(s.material[s.shape_material[0]].used && a.excess <= 1 + (real)1e-6, "%s", text);
        check((a.calls == 0) == (strstr(text, "black") || strstr(text, "lamp")
                               || strstr(text, "panel")), "%s", text);
        studio_free(&s);
    }
}

static void test_includes(void)
{
    studio s;
    failure f;
    char name[32], text[64];
    put("a.scene", "include b.scene\n"), put("b.scene", "\ninclude ././a.scene\n");
    check(!read_scene("a.scene", &s, &f) && f.exit_code == 2
          && strstr(f.text, "include: nested too deep"), "%s", f.text);
    for (int i = 0; i < 17; i++) {
        snprintf(name, sizeof name, "d%d.scene", i);
        snprintf(text, sizeof text, "include d%d.scene\n", i + 1);
        put(name, i == 16 ? "sphere 0 0 0 1\n" : text);
    }
    check(!read_scene("d0.scene", &s, &f) && strstr(f.text, "nested too deep"), "%s", f.text);
    bool ok = read_scene("d1.scene", &s, &f);
    check(ok && s.shapes == 1, "16 deep: %s", f.text);
    if (ok) studio_free(&s);
    for (int i = 0; i < 12; i++) {  /* each twice: 2^12 of the last */
        snprintf(name, sizeof name, "e%d.scene", i);
        snprintf(text, sizeof text, "include e%d.scene\ninclude e%d.scene\n", i + 1, i + 1);
        put(name, i == 11 ? "sphere 0 0 0 1\n" : text);
    }
    check(!read_scene("e0.scene", &s, &f) && f.exit_code == 2
          && strstr(f.text, "too many files, allowed: 256"), "%s", f.text);
    put("glow.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\nf 1 2 3\nf 1 2 3\n");
    size_t n = studio_most_emitters / 4 + 1, room = n * 12 + 100, at;
    char *many = allocate(room, 1);
    at = (size_t)sprintf(many, "material lamp\nKe 1\nmesh g glow.obj\n");
    for (size_t i = 0; i < n; i++) at += (size_t)sprintf(many + at, "instance g\n");
    refused("x.scene", many, "x.scene", 2, "too many faces emit light", "at most 1048576");
    free(many);
}

int main(void)
{
    rng = random_start(27, 0, 0);
    if (!mkdtemp(directory)) abort();
    int failed = check_all("27_readers", test_mtl, test_mtl_broken, test_many_materials,
                           test_notes, test_exports, test_nff, test_nff_rest,
                           test_nff_broken, test_patches, test_scene, test_shipped, test_words,
                           test_scene_broken, test_black_sky, test_box, test_includes);
    remove_directory();
    return failed;
}
