/* Tests of chapters/07_mesh: text.h, obj.h, mesh.h.
 *
 * Random files come with what they hold, noted while they were written.
 */
#include "check.h"
#include "../common/random.h"
#include "../chapters/07_mesh/files/obj.h"
#include "../chapters/07_mesh/files/obj_write.h"
#include "../chapters/07_mesh/scenes/teapot.h"
#include "child.h"
#include <sys/resource.h>
#include <sys/wait.h>

static random_stream rng;
static size_t below(size_t n) { return (size_t)(random_next_bits(&rng) % n); }

/* ---- helpers: a text as a file ---- */

static bool read_bytes(const char *text, size_t size, size_t most, mesh *m, failure *f)
{
    FILE *in = fmemopen((void *)(size ? text : "\n"), size ? size : 1, "rb");
    if (!in) abort();
    if (f) *f = (failure){0, ""};
    bool ok = obj_read_stream(in, "t.obj", most, m, f);
    fclose(in);
    return ok;
}

static bool read_text(const char *text, mesh *m, failure *f)
{
    return read_bytes(text, strlen(text), UINT32_MAX, m, f);
}

typedef struct { char *p; size_t n, room; } string;

static void append(string *s, const char *format, ...)
{
    va_list a;
    if (s->room < s->n + 8192) s->p = realloc(s->p, s->room = 2 * s->room + 16384);
    if (!s->p) abort();
    va_start(a, format);
    s->n += (size_t)vsnprintf(s->p + s->n, 8192, format, a);
    va_end(a);
}

/* m has what o has: an array of which no corner names anything is not there. */
static bool same_items(const vec3 *m, size_t n, const uint32_t *index, const vec3 *o, size_t count,
                       const uint32_t *due, size_t corners)
{
    bool any = false;
    for (size_t i = 0; due && i < corners; i++) any = any || due[i] != mesh_none;
    return any == (index != NULL) && n == (any ? count : 0)
        && (!any || (memcmp(m, o, n * sizeof *m) == 0 && memcmp(index, due, 4 * corners) == 0));
}

static bool same_mesh(const mesh *m, const mesh *o)
{
    size_t k = 3 * o->triangles;
    return m->triangles == o->triangles
        && same_items(m->v, m->vertices, m->index, o->v, o->vertices, o->index, k)
        && same_items(m->n, m->normals, m->normal_index, o->n, o->normals, o->normal_index, k)
        && same_items(m->t, m->textures, m->texture_index, o->t, o->textures, o->texture_index, k);
}

/* ---- random valid files that use every feature ---- */

/* As strtod reads what was written. */
static real random_number(string *s)
{
    size_t start = s->n;
    double x = random_double_of(random_next_bits(&rng)) * 2 - 1, big = x * 1e12;
    switch (below(9)) {
    case 0: append(s, "%d", (int)below(2000) - 1000); break;
    case 1: append(s, "%.17g", x); break;
    case 2: append(s, "%+.6f", x * 100); break;
    case 3: append(s, "%.3e", big); break;
    case 4: append(s, "%.25f", x); break;      /* more digits than the fast path takes */
    case 5: append(s, ".%zu", below(1000)); break;
    case 6: append(s, "%zu.", below(1000)); break;
    case 7: append(s, "%.16E", x * 1e-30); break;
    default: append(s, "%.6f", x);
    }
    return (real)strtod(s->p + start, NULL);
}

/* Of one of n items so far: from the first or back from the last. */
static uint32_t random_index(string *s, const char *before, size_t n)
{
    size_t i = 1 + below(n);
    bool back = below(2);
    append(s, back ? "%s-%zu" : "%s%zu", before, i);
    return (uint32_t)(back ? n - i : i - 1);
}

static void random_blank(string *s, const char *end_of_line)
{
    switch (below(16)) {
    case 0: append(s, "\t"); break;
    case 1: append(s, "   \t "); break;
    case 2: append(s, " \\%s ", end_of_line); break;
    default: append(s, " ");
    }
}

static void random_face(string *s, const char *end, mesh *m)
{
    uint32_t corner[3][3], *const array[3] = {m->index, m->texture_index, m->normal_index};
    append(s, "f");
    for (size_t k = 0, n = below(20) ? 3 + below(3) : 3 + below(60); k < n; k++) {
        size_t form = below(4);
        random_blank(s, end);
        uint32_t c[3] = {random_index(s, "", m->vertices), mesh_none, mesh_none};
        if (form == 1 || form == 3) c[1] = random_index(s, "/", m->textures);
        if (form == 2) append(s, "/");
        if (form >= 2) c[2] = random_index(s, "/", m->normals);
        for (int j = 0; j < 3; j++) {  /* a fan: first, last, this one */
            if (k == 0) corner[j][0] = c[j];
            corner[j][2] = c[j];
            if (k >= 2) memcpy(array[j] + 3 * m->triangles, corner[j], 12);
            corner[j][1] = c[j];
        }
        m->triangles += k >= 2;
    }
}

/* m [may be NULL]: what the file holds. */
static string random_file(size_t lines, mesh *m)
{
    static const char *const ends[] = {"\n", "\r\n", "\r"};
    static const char *const skipped[] = {
        "g a b", "o Ünïcödé 名", "s off", "s 1", "l 1 2 3", "p 1", "usemtl red metal",
        "mtllib a.mtl b.mtl", "vp 0.5 0.5", "curv 0 1 \\\n 1 2 3", "", "   ", "# f 0 0 0 \\"};
    static const char *const keyword[] = {"v", "vn", "vt"};
    string s = {NULL, 0, 0};
    const char *end = ends[below(3)];
    size_t faces = 3 * 64 * (lines + 1);
    mesh due = {.v = allocate(lines, sizeof(vec3)), .n = allocate(lines, sizeof(vec3)),
                .t = allocate(lines, sizeof(vec3)), .index = allocate(faces, 4),
                .texture_index = allocate(faces, 4), .normal_index = allocate(faces, 4)};
    vec3 *const item[3] = {due.v, due.n, due.t};
    size_t *const count[3] = {&due.vertices, &due.normals, &due.textures};
    if (below(3) == 0) append(&s, "\xef\xbb\xbf");
    for (size_t i = 0; i < lines; i++) {
        size_t what = i < 6 ? i % 3 : below(8);
        if (below(10) == 0) append(&s, "%s", end = below(4) ? end : ends[below(3)]);
        if (below(10) == 0) append(&s, "  ");
        if (what < 3) {
            size_t n = what == 0 ? 3 + below(5) : what == 1 ? 3 : 1 + below(3);
            vec3 p = {0, 0, 0};
            append(&s, "%s", keyword[what]);
            for (size_t k = 0; k < n; k++) {
                random_blank(&s, end);
                real x = random_number(&s);
                if (k < 3) p = vwith(p, (int)k, x);
            }
            item[what][(*count[what])++] = p;
        } else if (what < 7) random_face(&s, end, &due);
        else append(&s, "%s", skipped[below(sizeof skipped / sizeof *skipped)]);
        if (below(12) == 0) append(&s, " # remark");
        if (below(12) == 0) append(&s, "  \t");
        if (i + 1 < lines) append(&s, "%s", end);
    }
    append(&s, "%sf 1 2 -1", end);  /* at least one face, and no end of the last line */
    const uint32_t last[3] = {0, 1, (uint32_t)due.vertices - 1};
    const uint32_t none[3] = {mesh_none, mesh_none, mesh_none};
    memcpy(due.index + 3 * due.triangles, last, 12);
    memcpy(due.texture_index + 3 * due.triangles, none, 12);
    memcpy(due.normal_index + 3 * due.triangles++, none, 12);
    if (m) *m = due;
    else mesh_free(&due);
    return s;
}

static void test_random_files(void)
{
    size_t wrong = 0, files = check_count(2000), large = 0;
    for (size_t i = 0; i < files; i++) {
        mesh m, o;
        string s = random_file(i % 50 ? 6 + below(300) : 6000, &o);  /* 6000: several buffers */
        failure f;
        bool ok = read_bytes(s.p, s.n, UINT32_MAX, &m, &f);
        large += s.n > text_chunk;
        if (!ok && wrong++ == 0) printf("%s\n", f.text);
        if (ok && !same_mesh(&m, &o)) wrong++;
        mesh_free(&m);
        mesh_free(&o);
        free(s.p);
    }
    check_equal(wrong, 0, "of %zu random files, read otherwise than they were written", files);
    check_at_least(large, 1, "files that are longer than the buffer");
}

/* ---- numbers ---- */

static bool number_of(const char *text, real *x)
{
    char line[6000];
    mesh m;
    failure f;
    snprintf(line, sizeof line, "v %s 0 0\nf 1 1 1\n", text);
    bool ok = read_text(line, &m, &f);
    if (ok) *x = m.v[0].x;
    mesh_free(&m);
    return ok;
}

static void test_numbers(void)
{
    static const struct { const char *text; double x; } exact[] = {
        {"0", 0}, {"-0", -0.0}, {"+1", 1}, {".5", .5}, {"5.", 5}, {"1e3", 1000}, {"1E+3", 1000},
        {"25e-2", .25}, {"0.1", .1}, {"9007199254740993", 9007199254740992.}, /* tie: to even */
        {"9007199254740993.0000000001", 9007199254740994.}, {"1e22", 1e22}, {"1e23", 1e23},
        {"123456789012345678e-18", .123456789012345678}, {"0e99999999999", 0}, {"1e-99999", 0},
        {"0.000000000000000000000000000001", 1e-30}, {"00000000000000000000000000001", 1}};
    static const struct { const char *text; double x; } wide_only[] = {
        {"1.7976931348623157e308", DBL_MAX}, {"2.2250738585072014e-308", DBL_MIN},
        {"4.9406564584124654e-324", 4.9406564584124654e-324}, {"8.5e300", 8.5e300}};
    static const char *const wrong[] = {
        "nan", "NaN", "-nan(ind)", "inf", "-inf", "Infinity", "1.#INF", "1.#QNAN",
        "1e400", "-1e309", "1.7976931348623159e308", "0x10", "1,5", "1e", "1e+", ".", "-", "+-1",
        "1.2.3", "1d5", "1f", "--1", "e5", "1e5.0", "\x01", "1\xff", "\"1\""};
    real x = 7;
    for (size_t i = 0; i < sizeof exact / sizeof *exact; i++) {
        bool ok = number_of(exact[i].text, &x);
        check(ok && x == (real)exact[i].x && !signbit(x) == !signbit(exact[i].x),
              "%s is read exactly, measured %.17g", exact[i].text, (double)x);
    }
    for (size_t i = 0; i < sizeof wide_only / sizeof *wide_only; i++) {
        bool ok = number_of(wide_only[i].text, &x);
        bool fits = isfinite((real)wide_only[i].x);
        check(ok == fits && (!fits || x == (real)wide_only[i].x), "%s", wide_only[i].text);
    }
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        check(!number_of(wrong[i], &x), "'%s' is refused as a number", wrong[i]);
    check(number_of("3.4028234e38", &x) && x > (real)3.4e38, "the largest float");
    check(number_of("3.5e38", &x) == !real_is_float, "3.5e38 overflows in float only");

    static char many[4200];
    memset(many, '7', sizeof many);
    many[1] = '.';
    many[4000] = 0;
    check(number_of(many, &x) && x == (real)strtod(many, NULL), "a number of 4000 digits");
    many[4000] = '7';
    many[4199] = 0;
    check(!number_of(many, &x), "a number of 4199 characters is refused");
}

/* w / 10^k bit for bit as strtod: where both are doubles (w < 2^53, k <= 22), and beyond. */
static void test_nearest(void)
{
    size_t n = check_count(200000), wrong = 0;
    double x;
    for (size_t i = 0; i < n; i++) {
        char digits[64], text[80];
        uint64_t w = (1ull << 53) - 8 + below(17);
        if (below(2)) w = random_next_bits(&rng) >> below(64);
        int k = (int)below(26);
        int all = snprintf(digits, sizeof digits, "%0*llu", k + 1, (unsigned long long)w);
        snprintf(text, sizeof text, "%s%.*s.%s", below(2) ? "-" : "", all - k, digits,
                 digits + all - k);
        double due = strtod(text, NULL);
        const char *stop = decimal_read(text, &x);
        wrong += !stop || *stop || memcmp(&x, &due, sizeof x) != 0;
    }
    check_equal(wrong, 0, "of %zu numbers, not the nearest double", n);
    static const struct { const char *text, *rest; double x; } part[] = {
        {"0x1", "x1", 0}, {"1e", "e", 1}, {"-1e+ 2", "e+ 2", -1}, {"1.5.5", ".5", 1.5}};
    for (size_t i = 0; i < sizeof part / sizeof *part; i++) {
        const char *stop = decimal_read(part[i].text, &x);
        check(stop && strcmp(stop, part[i].rest) == 0 && x == part[i].x, "of %s", part[i].text);
    }
    check(!decimal_read("-.e5", &x) && !decimal_read(" 1", &x) && !decimal_read("inf", &x), "none");
}

/* ---- what is read, by hand ---- */

static bool same_names(const mesh *m, const char *const *name)
{
    for (size_t i = 0; i < m->triangles; i++)
        if (strcmp(mesh_material(m, i), name[i]) != 0) return false;
    return true;
}

static void test_features(void)
{
    mesh m;
    failure f;
    const uint32_t none = mesh_none;
    check(read_text("\xef\xbb\xbf# a square and its fan\r\n"
        "mtllib my first.mtl\r\n"
        "v 0 0 0 1 .5 .5 .5\rv 1 0 0 1.0\n\n  v\t1 1 0 0.1 0.2 0.3  \n"
        "v 0 1 \\\n 0 # the corner\n"
        "vn 0 0 2\nvt 0\nvt 0 0\nvt 0 0 0\nf 1 2 3\n"
        "usemtl unused\nusemtl red hot \t\n"
        "f 1/1/1 2/3/-1 3//1 -1\n"
        "usemtl blue\ng x\nuse x\nl 1 2\nf 3 02 001\n"
        "#\\\nf -4 6 5\nv 5 5 5\nv 6 6 6", &m, &f), "all features: %s", f.text);
    const uint32_t index[] = {0, 1, 2, 0, 1, 2, 0, 2, 3, 2, 1, 0, 0, 5, 4},
                   normal[] = {none, none, none, 0, 0, 0, 0, 0, none, none, none, none, none, none,
                               none};
    check(m.vertices == 6 && m.triangles == 5 && m.normals == 1, "counts of all features");
    check(m.index && memcmp(m.index, index, sizeof index) == 0, "fan in the order of the file");
    check(m.normal_index && memcmp(m.normal_index, normal, sizeof normal) == 0, "normal indices");
    check(m.v && m.v[2].y == 1 && m.v[3].y == 1 && m.v[5].z == 6, "points, a joined line too");
    check_text(m.libraries ? m.libraries : "", "my first.mtl\n", "mtllib");
    check(m.runs == 2, "a run without triangles gives way");
    check(same_names(&m, (const char *const[]){"", "red hot", "red hot", "blue", "blue"}), "names");
    mesh_free(&m);
    mesh_free(&m);
    check(m.v == NULL && m.vertices == 0, "freed twice");

    /* Some programs write all slashes, indices or not, and usemtl without a name. */
    check(read_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\n"
                    "usemtl red\nf 1/ 2// 3/1/\nusemtl\nf 3//1 1/1/1 2/\nusemtl  # x\n"
                    "f 1/\\\n 2 3/", &m, &f), "what is left out: %s", f.text);
    const uint32_t left[] = {0, 1, 2, 2, 0, 1, 0, 1, 2},
                   normals[] = {none, none, none, 0, 0, none, none, none, none};
    check(m.triangles == 3 && memcmp(m.index, left, sizeof left) == 0, "slashes alone: indices");
    check(m.normal_index && memcmp(m.normal_index, normals, sizeof normals) == 0,
          "slashes alone: normals");
    check(same_names(&m, (const char *const[]){"red", "", ""}), "usemtl alone");
    mesh_free(&m);

    check(read_text("v 0 0 0\nvn 0 0 1\nf 1 1 1", &m, &f) && m.n == NULL && m.normals == 0,
          "normals that no face asks for are dropped");
    mesh_free(&m);
    check(read_bytes("v 0 0 0\nv 0 0 0\nf 1 1 2 1", 25, 2, &m, &f) && m.triangles == 2,
          "2 of each fit");
    mesh_free(&m);
}

/* ---- errors ---- */

static void test_errors(void)
{
#define V3 "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
    static const struct { const char *text, *message; } bad[] = {
        {"v 0 0 nan\nf 1 1 1", "t.obj:1: v: not a number: 'nan', allowed: finite decimals"},
        {V3 "v 1 inf 0\nf 1 2 3", "t.obj:4: v: not a number: 'inf'"},
        {V3 "vn 1 1e999 0\n", "t.obj:4: vn: too large: '1e999'"},
        {V3 "vt nan\n", "t.obj:4: vt: not a number"},
        {V3 "v 0 \\ 0\n", "t.obj:4: v: not a number: '\\'"},
        {V3 "\n# x\nv 1 2\nf 1 2 3\n", "t.obj:6: v: too few numbers before the end of the line"},
        {V3 "v 1 2", "t.obj:4: v: too few numbers before the end of the file, allowed: 3 to 7"},
        {V3 "v", "t.obj:4: v: too few numbers"},
        {V3 "v 1 2 3 4 5 6 7 8\n", "t.obj:4: v: too many numbers: '8'"},
        {V3 "vn 1 2 3 4\n", "t.obj:4: vn: too many numbers"},
        {V3 "f 0 1 2\n", "t.obj:4: f: vertex index out of range: '0', allowed: 1 to 3 or -3 to -1"},
        {V3 "f 1 2 -0\n", "t.obj:4: f: vertex index out of range: '-0'"},
        {V3 "f 1 2 -4\n", "t.obj:4: f: vertex index out of range: '-4'"},
        {"f -1 -2 -3\n" V3, "t.obj:1: f: vertex index out of range: '-1', allowed: none"},
        {V3 "f 1 2 3\nf 1 2 4\nf 1 2 3\n",
         "t.obj:5: f: vertex index out of range: 4, allowed: up to 3"},
        {V3 "f 1 2 3\nf 1 2 4\nf 1 4 3\n", "t.obj:5: f: vertex"},
        {V3 "f 1 2 18446744073709551617\n",
         "t.obj:4: f: vertex index out of range: '18446744073709551617'"},  /* 2^64 + 1 */
        {V3 "f 1 2 4294967296\n", "t.obj:4: f: vertex index out of range"},
        {V3 "f 1 2 -4294967295\n", "t.obj:4: f: vertex index out of range"},
        {V3 "vt 0 0\nf 1/1 2/2 3/1\n",
         "t.obj:5: f: texture index out of range: 2, allowed: up to 1"},
        {V3 "f 1//1 2//1 3//1\n", "t.obj:4: f: normal index out of range: 1, allowed: up to 0"},
        {V3 "f 1/0 2 3\n", "t.obj:4: f: texture index"},
        {V3 "f 1//0 2 3\n", "t.obj:4: f: normal index"},
        {V3 "f 1 2\n",
         "t.obj:4: f: too few corners before the end of the line, allowed: 3 or more"},
        {V3 "f", "t.obj:4: f: too few corners before the end of the file"},
        {V3 "f 1 2 x\n", "t.obj:4: f: not an index: 'x'"},
        {V3 "f 1 2 3.0\n", "t.obj:4: f: not a corner"},
        {V3 "f 1/x 2 3\n", "t.obj:4: f: not an index: 'x'"},
        {V3 "f 1/// 2 3\n", "t.obj:4: f: not an index"},
        {V3 "vt 0\nf 1/1// 2 3\n", "t.obj:5: f: not an index"},
        {V3 "f 1/1/1/1 2 3\n", "t.obj:4: f: "},
        {V3 "f / 2 3\n", "t.obj:4: f: not an index"},
        {V3 "f 1 2 --3\n", "t.obj:4: f: not an index"},
        {V3 "f 1 2 \\ \n 3\n", "t.obj:4: f: not an index"},
        {V3 "f 1 2 \\\n x\n", "t.obj:5: f: not an index: 'x'"},
        {"mtllib \n", "t.obj:1: mtllib: no name"},
        {"", "t.obj:"}, {V3, "t.obj:4: line: no face before the end of the file"},
        {V3 "1 2 3\n", "t.obj:4: line: begins with '1'"},
        {"\x7f" "ELF\n", "t.obj:1: line: begins with '?ELF'"},
        {"\xff\xfe" "v", "t.obj:1: line: begins with '??v'"},
        {"<html>\n", "t.obj:1: line: begins with '<html>'"},
        {V3 "f 1 2 3\r\rf 1 2 3\r\nf 1 2 x", "t.obj:7: f: not an index"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        mesh m;
        failure f;
        bool ok = read_text(bad[i].text, &m, &f);
        check(!ok, "refused: %s", bad[i].message);
        check(ok || f.exit_code == 2, "broken content ends with 2: %s", bad[i].message);
        check(ok || strncmp(f.text, bad[i].message, strlen(bad[i].message)) == 0,
              "'%s' begins with '%s'", f.text, bad[i].message);
        check(m.v == NULL && m.index == NULL && m.triangles == 0, "a failure leaves nothing");
        mesh_free(&m);
    }
    mesh m;
    failure f;
    static const char zero[] = V3 "f 1 2\0 3\n", comment[] = V3 "# a\0b\nf 1 2 3",
                      end[] = V3 "f 1 2 3\n\0";
    check(!read_bytes(zero, sizeof zero - 1, 9, &m, &f), "byte 0 in a face");
    check(!read_bytes(comment, sizeof comment - 1, 9, &m, &f), "byte 0 in a comment");
    check(!read_bytes(end, sizeof end - 1, 9, &m, &f), "byte 0 behind the text");
    check_text(f.text, "t.obj:5: line: no text: byte 0, allowed: text", "message");
    check(!read_bytes(V3 "f 1 2 3\n", 32, 2, &m, &f) && strstr(f.text, ":3: v: too many items"),
          "2 points at most: %s", f.text);
    check(!read_bytes("v 0 0 0\nf 1 1 1 1", 17, 1, &m, &f) && strstr(f.text, ":2: f: too many"),
          "1 triangle at most: %s", f.text);
    check(!obj_read("/nonexistent/x.obj", &m, &f) && f.exit_code == 1, "no such file: 1");
    check(!obj_read("/", &m, &f) && f.exit_code == 1, "a directory: 1");
    check(!obj_read("/nonexistent/x.obj", &m, NULL), "without a failure to fill in");
    check(!read_text("nonsense", &m, NULL), "broken without a failure to fill in");
}

/* A stream that cannot be read, and more items than an address space holds. */
static void test_read_error(void)
{
    mesh m;
    failure f;
    size_t room = 7;
    FILE *closed = fopen("/dev/null", "wb");
    if (!closed) abort();
    check(!obj_read_stream(closed, "t.obj", SIZE_MAX, &m, &f) && f.exit_code == 1, "exit 1");
    check(strncmp(f.text, "t.obj: cannot read: ", 20) == 0, "what went wrong: %s", f.text);
    fclose(closed);
    text_reader r = {.name = "t.obj", .keyword = "v", .f = &f, .line = 3};
    check(!text_grow(&r, NULL, &room, 7, SIZE_MAX / 4, 8) && r.bad && f.exit_code == 1, "2^62");
    check(strncmp(f.text, "t.obj:3: no memory for ", 23) == 0 && room == 7, "%s", f.text);
}

/* ---- lines longer than the buffer ---- */

static void test_long_lines(void)
{
    mesh m;
    failure f;
    string s = {NULL, 0, 0};
    size_t corners = 100000;
    append(&s, "#");
    for (size_t i = 0; i < 20000; i++) append(&s, "a comment of 20 char");
    append(&s, "\n" V3 "f");
    for (size_t i = 0; i < corners; i++) append(&s, " %zu/%s", 1 + i % 3, "/1");
    append(&s, "\nvn 0 0 1\nv ");
    for (size_t i = 0; i < 40000; i++) append(&s, "     ");
    append(&s, "1.25");
    for (size_t i = 0; i < 20000; i++) append(&s, " \\\r\n ");
    append(&s, "2 3\n");
    bool ok = read_bytes(s.p, s.n, UINT32_MAX, &m, &f);
    check(ok && m.triangles == corners - 2 && m.vertices == 4, "counts: %s", f.text);
    check(ok && m.v[3].x == (real)1.25 && m.v[3].z == 3,
          "a polygon of 100000 corners, 200000 blanks, 20000 joined lines: %s", f.text);
    bool fan = ok;
    for (size_t i = 0; fan && i < m.triangles; i++)
        fan = m.index[3 * i] == 0 && m.index[3 * i + 1] == (i + 1) % 3
            && m.index[3 * i + 2] == (i + 2) % 3;
    check(fan, "its fan");
    mesh_free(&m);
    append(&s, "f 1 2 x");
    check(!read_bytes(s.p, s.n, UINT32_MAX, &m, &f) && strstr(f.text, "t.obj:20008: "),
          "lines counted: %s", f.text);
    free(s.p);

    string t = {NULL, 0, 0};
    append(&t, V3 "usemtl ");
    for (size_t i = 0; i < 4992; i++) append(&t, "n");
    append(&t, "\nf 1 2 3");
    check(!read_bytes(t.p, t.n, UINT32_MAX, &m, &f) && strstr(f.text, "too long"),
          "a name of 4992 bytes");
    free(t.p);
}

/* ---- damage: whatever comes, an answer or a message ---- */

static bool sound(const mesh *m)
{
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        if (m->index[i] >= m->vertices) return false;
        uint32_t n = m->normal_index ? m->normal_index[i] : mesh_none;
        uint32_t t = m->texture_index ? m->texture_index[i] : mesh_none;
        if (n != mesh_none && n >= m->normals) return false;
        if (t != mesh_none && t >= m->textures) return false;
    }
    for (size_t i = 0; i < m->vertices; i++) if (!vfinite(m->v[i])) return false;
    return m->triangles > 0;
}

static void test_damage(void)
{
    size_t n = check_count(100000), wrong = 0, read = 0, refused = 0;
    string s = random_file(60, NULL);
    for (size_t i = 0; i < n; i++) {
        if (i % 200 == 0) free(s.p), s = random_file(6 + below(60), NULL);
        size_t size = s.n, times = 1 + below(3);
        char *d = allocate(2 * size + 1, 1);
        memcpy(d, s.p, size);
        for (; times; times--) {
            size_t at = below(size), length = 1 + below(size - at < 40 ? size - at : 40);
            static const char odd[] = "\\/#-+.e\n\r \t0vfn\x00\x1a\xff";
            switch (below(5)) {
            case 0: size = at + 1; break;  /* cut off */
            case 1: d[at] = (char)(d[at] ^ (1 << below(8))); break;  /* a bit */
            case 2: d[at] = odd[below(sizeof odd - 1)]; break;
            case 3: memmove(d + at, d + at + length, size - at - length); size -= length; break;
            default: if (size + length <= 2 * s.n) {  /* twice */
                         memmove(d + at + length, d + at, size - at);
                         size += length;
                     }
            }
            size = size ? size : 1;
        }
        mesh m;
        failure f;
        size_t lines = 1;
        for (size_t k = 0; k < size; k++) lines += d[k] == '\n' || d[k] == '\r';
        if (read_bytes(d, size, UINT32_MAX, &m, &f)) read++, wrong += !sound(&m);
        else {
            unsigned long line = strncmp(f.text, "t.obj:", 6) ? 0 : strtoul(f.text + 6, NULL, 10);
            refused++;
            wrong += f.exit_code != 2 || line < 1 || line > lines || !strstr(f.text, "allowed: ");
        }
        mesh_free(&m);
        free(d);
    }
    free(s.p);
    check_equal(wrong, 0, "of %zu damaged files: bad arrays, or a message without its line", n);
    check_at_least(read, n / 20, "some damage does not show");
    check_at_least(refused, n / 5, "most does");
}

/* ---- memory ---- */

static long resident(void)  /* the most memory that was ever resident, in KB */
{
    struct rusage u;
    getrusage(RUSAGE_SELF, &u);
#ifdef __APPLE__
    return u.ru_maxrss / 1024;
#else
    return u.ru_maxrss;
#endif
}

/* With CHECK_SOAK: what a child of its own that reads half a million triangles needs at most. */
static void test_memory(void)
{
    if (check_count(8) != 8) return;
    char path[] = "/tmp/07_obj_XXXXXX";
    int file = mkstemp(path), status = -1;
    mesh m = teapot_mesh(90);
    failure f;
    if (file < 0 || !obj_write(path, &m, &f)) abort();
    close(file), mesh_free(&m);
    pid_t child = fork();
    if (child == 0) {
        long before = resident();
        if (!obj_read(path, &m, &f)) _exit(99);
        double arrays = (double)((m.vertices + m.normals) * sizeof *m.v + 24 * m.triangles) / 1024;
        _exit((int)(10 * (double)(resident() - before - 512) / arrays));
    }
    waitpid(child, &status, 0);
    unlink(path);
    check(WIFEXITED(status), "a child that reads");
    check_at_most(WEXITSTATUS(status) / 10.0, 2.5, "peak memory, times the arrays");
}

/* ---- texture coordinates, writing, libraries ---- */

static void test_textures(void)
{
    mesh m;
    failure f;
    vec3 at = {7, 7, 7};
    const char *text = V3 "vt 0 0\nvt 1\nvt 0 1 0.5\nvt 9 9\nf 1 2 3\nf 1/1 2/2 3/3\nf 1/3 2/1 3\n"
        "f 3/-4 2/-2/ 1/2\n";
    check(read_text(text, &m, &f), "texture coordinates: %s", f.text);
    static const uint32_t none = mesh_none;
    const uint32_t index[] = {none, none, none, 0, 1, 2, 2, 0, none, 0, 2, 1};
    check(m.textures == 4 && m.t && m.t[1].x == 1 && m.t[1].y == 0 && m.t[2].z == (real)0.5,
          "one to three numbers, the others 0");
    check(m.texture_index && memcmp(m.texture_index, index, sizeof index) == 0, "whose they are");
    check(mesh_texture(&m, 1, (real)0.25, (real)0.5, &at) && at.x == (real)0.25
          && at.y == (real)0.5 && at.z == (real)0.25, "at barycentrics u, v");
    at.x = 7;
    check(!mesh_texture(&m, 0, 0, 0, &at) && !mesh_texture(&m, 2, 0, 0, &at) && at.x == 7,
          "a corner without: none, and the answer untouched");
    mesh_free(&m);
    check(read_text(V3 "vt 0 0\nf 1 2 3", &m, &f) && !m.t && !m.textures && !m.texture_index
          && !mesh_texture(&m, 0, 0, 0, &at), "no face asks for them: none are kept");
    mesh_free(&m);
}

/* All numbers rounded to float, and no -0. */
static void as_float(mesh *m)
{
    vec3 *const array[3] = {m->v, m->n, m->t};
    const size_t count[3] = {m->vertices, m->normals, m->textures};
    for (int k = 0; k < 3; k++)
        for (size_t i = 0; i < count[k]; i++) {
            vec3 p = array[k][i];
            array[k][i] = vec((float)p.x + 0, (float)p.y + 0, (float)p.z + 0);
        }
}

/* What was written and read is the mesh, its numbers rounded to float. */
static void test_writing(void)
{
    char path[] = "/tmp/07_obj_XXXXXX";
    int file = mkstemp(path);
    size_t wrong = 0, n = check_count(300);
    failure f;
    if (file < 0) abort();
    close(file);
    for (size_t i = 0; i < n; i++) {
        string s = random_file(6 + below(200), NULL);
        mesh m, o = {0};
        if (!read_bytes(s.p, s.n, UINT32_MAX, &m, &f)) abort();
        file_forget(path);
        bool ok = obj_write(path, &m, &f) && obj_read(path, &o, &f);
        as_float(&m), as_float(&o);
        wrong += !ok || !same_mesh(&o, &m);
        for (size_t k = 0; ok && k < m.triangles; k++)
            wrong += strcmp(mesh_material(&m, k), mesh_material(&o, k)) != 0;
        mesh_free(&m), mesh_free(&o);
        free(s.p);
    }
    check_equal(wrong, 0, "of %zu random meshes, written and read otherwise", n);
    unlink(path);
    mesh teapot = teapot_mesh(2);
    check(!obj_write("/nonexistent/x.obj", &teapot, &f) && f.exit_code == 1, "no such folder: 1");
    mesh_free(&teapot);
}

/* scenes/teapot.obj and .mtl are what `07_mesh --teapot 4 --save teapot.obj` writes; in float,
 * points and normals are a rounding off. */
static void test_shipped(void)
{
    const char *const shipped = "chapters/07_mesh/scenes/teapot";
    char path[] = "/tmp/07_obj_XXXXXX", name[64];
    mesh m = teapot_mesh(4);
    failure f = {0, ""};
    if (!mkdtemp(path)) abort();
    for (int k = real_is_float; k < 2; k++) {
        size_t n[2] = {0, 0};
        char due[64];
        const char *ending = k ? ".mtl" : ".obj";
        snprintf(name, sizeof name, "%s/teapot%s", path, ending);
        snprintf(due, sizeof due, "%s%s", shipped, ending);
        bool ok = (k ? mtl_write : obj_write)(name, &m, &f);
        char *made = ok ? file_read(name, &n[0], &f) : NULL, *has = file_read(due, &n[1], &f);
        check(made && has && n[0] == n[1] && !memcmp(made, has, n[0]),
              "%s: as the program writes it; %s", due, f.text);
        free(made), free(has), unlink(name);
    }
    rmdir(path), mesh_free(&m);
}

static void say_missing(void *text)
{
    mesh m;
    if (!read_text(text, &m, NULL)) exit(9);
    exit(obj_libraries_missing(&m, "chapters/07_mesh/scenes/x.obj"));
}

/* mtllib: one name, or several; with blanks, or the path of another machine. */
static void test_libraries(void)
{
    static const struct { const char *line; int missing; } list[] = {
        {"", 0}, {"mtllib teapot.mtl\n", 0}, {"mtllib C:\\a b\\teapot.mtl\n", 0},
        {"mtllib /no/such/teapot.mtl\n", 0}, {"mtllib teapot.mtl teapot.obj\n", 0},
        {"mtllib gone.mtl\n", 1}, {"mtllib teapot.mtl gone.mtl\nmtllib lost.mtl\n", 2},
        {"mtllib gone.mtl\nmtllib teapot.mtl\n", 1}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        char text[200];
        snprintf(text, sizeof text, V3 "%sf 1 2 3\n", list[i].line);
        child_result r = child_run(say_missing, text);
        check_equal(r.status, list[i].missing, "files missing: %s", list[i].line);
        check((strstr(r.err, "gone.mtl: no such file") != NULL) == (strstr(text, "gone") != NULL)
              && !strstr(r.err, "teapot.mtl: no"), "said of them: %s", r.err);
    }
    static const char library[] = "chapters/07_mesh/scenes/teapot.mtl";
    file_writer out;
    failure f;
    mesh m;
    if (!read_text(V3 "mtllib teapot.mtl\nf 1 2 3\n", &m, NULL)) abort();
    check_equal(obj_libraries_missing(&m, "chapters/07_mesh/scenes/x.obj"), 0, "it is there");
    check(!file_begin(&out, library, &f) && f.exit_code == 2 && strstr(f.text, "not replaced"),
          "no output replaces it: %s", f.text);
    file_forget(library), mesh_free(&m);
}

/* ---- mesh.h ---- */

/* A cube of quads, the fan of each beginning at the corner that its line begins with. */
static const char cube[] =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

static void test_normals(void)
{
    mesh m;
    failure f;
    vec3 lo, hi;
    if (!read_text(cube, &m, &f)) abort();
    check(mesh_bounds(&m, &lo, &hi) && lo.x == -1 && lo.z == -1 && hi.y == 1 && hi.z == 1, "a box");
    double worst = 0;
    mesh_smooth_normals(&m);
    for (size_t i = 0; i < 8; i++)  /* a cube's corner looks outwards, however it is sliced */
        worst = check_worse(worst, (double)vlength(vsub(m.n[i], vunit(m.v[i]))));
    check_at_most(worst, 8 * (double)real_epsilon,
                  "by angle: up to 6 terms, each off by an epsilon or so");
    vec3 n = mesh_normal(&m, 0, (real)0.25, (real)0.25);
    check_close(vlength(n), 1, 4 * real_epsilon, "interpolated normals are unit");
    mesh_free(&m);
    check(!mesh_bounds(&m, &lo, &hi) && lo.x > hi.x, "no triangle: no box");

    /* A corner that is no number is left out, and only it. */
    if (!read_text("v 0 0 0\nv 1e6 0 0\nv 0 1e6 0\nv 1 0 0\nv 2 0 0\nv 1 1 0\n"
                   "f 1 2 3\nf 1 4 4\nf 5 4 6\n", &m, &f)) abort();
    m.v[3] = (vec3){(real)NAN, (real)NAN, (real)NAN};
    check(mesh_bounds(&m, &lo, &hi) && lo.x == 0 && hi.x == (real)1e6 && hi.y == (real)1e6
          && lo.z == 0, "a NaN forgets nothing that came before: to %g", (double)hi.x);
    mesh_free(&m);

    /* Degenerate: a point, a line, a sliver's neighbour; a stray vertex far away. */
    const char *text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 99 99 99\nv 2 0 0\nv 3 0 0\n"
        "f 1 2 3\nf 1 1 1\nf 2 5 6\nf 1 2 1\nf 6 6 5\n";
    if (!read_text(text, &m, &f)) abort();
    mesh_smooth_normals(&m);
    check(mesh_bounds(&m, &lo, &hi) && hi.x == 3 && hi.y == 1, "stray points are outside");
    for (size_t i = 0; i < 3; i++) check_equal(m.n[i].z, 1, "triangles of no area add nothing");
    for (size_t i = 3; i < 6; i++) check(vzero(m.n[i]), "a vertex without a normal gets zero");
    check_equal(mesh_normal(&m, 0, 0, 0).z, 1, "its triangle's own normal");
    check(vzero(mesh_normal(&m, 2, (real)0.5, 0)), "no area, no normal: zero, not NaN");
    mesh_free(&m);

    const char *own = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -5\nvn 3 0 0\nvn 0 0 0\nvn 0 0 5\n"
        "f 1//1 2//1 3//2\nf 1//1 2//3 3//1\nf 1//1 2 3//1\nf 1//1 2//4 3//1\n";
    if (!read_text(own, &m, &f)) abort();
    check_equal(mesh_normal(&m, 0, 0, 0).z, -1, "the file's normal, made unit");
    check_close(mesh_normal(&m, 0, 0, (real)0.5).x, sqrt(0.5), 4 * real_epsilon, "half way");
    check_equal(mesh_normal(&m, 1, 0, 0).z, 1, "a zero normal: the triangle's own");
    check_equal(mesh_normal(&m, 2, 0, 0).z, 1, "a missing one likewise");
    check_equal(mesh_normal(&m, 3, (real)0.5, 0).z, 1, "two that cancel likewise");
    mesh_free(&m);
}

/* What is no file on a disk has its most: here nearly all of it counts as read before. */
static void test_endless(void)
{
    for (int disk = 0; disk < 2; disk++) {
        failure f = {0, ""};
        text_reader r;
        FILE *in = disk ? tmpfile() : popen("yes 2>/dev/null | head -c 400000", "r");
        for (int i = 0; disk && in && i < 200000; i++) fputs("y\n", in);
        if (in && disk) rewind(in);
        check(in && text_begin(&r, in, "name", &f), "begun");
        check(disk ? r.left > file_pipe_most : r.left <= file_pipe_most, "what may come");
        if (!disk) r.left = 100000;
        while (text_statement(&r)) text_skip(&r);
        bool ok = text_end(&r);
        check_equal(ok, disk, "read to its end: %s", f.text);
        if (!disk) check(f.exit_code == 2 && strstr(f.text, "no end: 256 MB"), "why");
        check_at_most((double)r.line, disk ? 200001 : 150000, "lines");
        if (disk) fclose(in);
        else pclose(in);
    }
}

int main(void)
{
    test_endless();
    rng = random_start(7, 0, 0);
    test_numbers();
    test_nearest();
    test_features();
    test_errors();
    test_read_error();
    test_long_lines();
    test_random_files();
    test_damage();
    test_memory();
    test_textures();
    test_writing();
    test_shipped();
    test_libraries();
    test_normals();
    return check_report("07_obj");
}
