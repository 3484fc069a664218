/* Tests of chapters/07_mesh/files/mtl.h: what MTL files say, statement by statement.
 *
 * Oracle: numbers that a double holds exactly, written by hand. Spoilt files: tests/27_corpus.c.
 */
#include "check.h"
#include "../chapters/07_mesh/files/mtl.h"

static bool same(vec3 a, vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
static bool grey(vec3 a, real x) { return same(a, (vec3){x, x, x}); }

/* What a text says in all: of each key the line that said it last, and all notes. */
typedef struct {
    mtl_material m;              /* the last one, and its name */
    char name[64], notes[2000];
    size_t materials, line[mtl_keys], nothing;
} summary;

static bool read_as(const char *path, const char *text, summary *sum, failure *f)
{
    FILE *in = text_in_memory(text);
    mtl_reader r;
    *sum = (summary){.materials = 0};
    *f = (failure){0, ""};
    if (!in || !mtl_begin(&r, in, path, f)) abort();
    while (mtl_next(&r)) {
        sum->m = r.material;
        sum->nothing += r.said.key == MTL_NOTHING;
        if (r.said.key < mtl_keys) sum->line[r.said.key] = r.said.line;
        if (r.said.key == MTL_NEWMTL) {
            sum->materials++;
            memset(sum->line, 0, sizeof sum->line);
            snprintf(sum->name, sizeof sum->name, "%.63s", r.name);
        }
        size_t n = strlen(sum->notes);
        if (*r.said.note) snprintf(sum->notes + n, sizeof sum->notes - n, "%s\n", r.said.note);
    }
    bool ok = mtl_end(&r);
    fclose(in);
    return ok;
}

static summary read_all(const char *text)
{
    summary sum;
    failure f;
    check(read_as("a.mtl", text, &sum, &f), "%s", f.text);
    return sum;
}

static void test_keys(void)
{
    summary s = read_all(
        "# all of it\n\nunknown here\nmap_Kd x.png\nnewmtl other\nKd 0 0 0\n newmtl  a b\n"
        "\tKd .5 .25 1\nKs 0.75\nKe 1 2 4\nTf 0.5 1 0\nNs 96\nNi 1.5\nd 0.25\nillum 7\n"
        "absorb 0.5 0 2\npriority 3\nroughness .25\nKa 1 1 1\nPr 0.5\nsharpness 60\n"
        "unknown things 1 2 3\n# end");
    check_text(s.name, "a b", "its name");
    check(s.materials == 2 && s.nothing == 6 && !*s.notes, "%zu materials, %zu lines that say "
          "nothing, notes '%s'", s.materials, s.nothing, s.notes);
    check(same(s.m.kd, (vec3){0.5, 0.25, 1}) && grey(s.m.ks, 0.75) && same(s.m.ke, (vec3){1, 2, 4}),
          "Kd, Ks, Ke");
    check(same(s.m.tf, (vec3){0.5, 1, 0}) && same(s.m.absorb, (vec3){0.5, 0, 2}), "Tf, absorb");
    check(s.m.ns == 96 && s.m.ni == (real)1.5 && s.m.d == (real)0.25 && s.m.illum == 7,
          "Ns Ni d illum");
    check(s.m.roughness == (real)0.25 && s.m.priority == 3, "roughness, priority");
    static const size_t line[mtl_keys] = {8, 9, 10, 11, 16, 12, 13, 14, 15, 18, 17};
    for (int k = 0; k < mtl_keys; k++) check_equal(s.line[k], line[k], "key %d: its line", k);

    s = read_all("newmtl b\nKd 0\nNs 1\nillum 2\nKe 1\nroughness 1\nnewmtl a\nKa 0.5\n");
    check(grey(s.m.kd, (real)0.8) && grey(s.m.ks, 0) && grey(s.m.ke, 0) && grey(s.m.tf, 1)
          && grey(s.m.absorb, 0), "colours that nobody said");
    check(s.m.ns == 1000 && s.m.ni == 1 && s.m.d == 1 && s.m.illum == -1 && s.m.roughness == 0
          && s.m.priority == 0, "numbers that nobody said");
    for (int k = 0; k < mtl_keys; k++) check_equal(s.line[k], 0, "key %d: not said", k);
    s = read_all("newmtl a\nNs 1e9\nNi 10\nd 0\nillum 10\nroughness 1\npriority 1000\nKe 1e30\n");
    check(s.m.ns == (real)1e9 && s.m.ni == 10 && s.m.d == 0 && s.m.illum == 10 && s.m.roughness == 1
          && s.m.priority == 1000 && grey(s.m.ke, (real)1e30), "as far as it goes");
    s = read_all("newmtl a\nNs 0\nNi 0.000999\nillum 0\n");
    check(s.m.ns == 0 && s.m.ni == (real)0.000999 && s.m.illum == 0, "and down to");
    s = read_all("");
    check(s.materials == 0 && s.nothing == 0, "an empty file");
}

static void test_forms(void)
{
    summary s = read_all("newmtl a\r\nd 0.5\r\nTr 0.25\r\n");
    check(s.m.d == (real)0.75 && s.line[MTL_D] == 3, "Tr x says d = 1 - x: %g", (double)s.m.d);
    s = read_all("newmtl a\nTr 0.25\nd -halo 0.5\n");
    check(s.m.d == (real)0.5 && s.line[MTL_D] == 3, "the later of two counts: %g", (double)s.m.d);
    s = read_all("\xef\xbb\xbfnewmtl a\nKd \\\n 0.5 \\\n0.25 0 # dark\nillum 3");
    check(same(s.m.kd, (vec3){0.5, 0.25, 0}) && s.m.illum == 3, "joined lines");
    check(s.line[MTL_KD] == 2 && s.line[MTL_ILLUM] == 5, "the line where a statement begins");
}

/* What was read, but not as it stands, is said, and where. */
static void test_notes(void)
{
    summary s = read_all("newmtl a\nKs spectral x.rfl 1\nKd .5\nTf xyz 1 1\nKa spectral y.rfl\n");
    check_text(s.notes, "a.mtl:2: Ks: only r g b is read\na.mtl:4: Tf: only r g b is read\n"
               "a.mtl:5: Ka: only r g b is read\n", "colours of other kinds");
    check(grey(s.m.ks, 0) && s.line[MTL_KS] == 0 && grey(s.m.kd, 0.5) && grey(s.m.tf, 1)
          && s.line[MTL_TF] == 0, "they say nothing");
    s = read_all("newmtl a\nNi 2\nNi 0\n");
    check_text(s.notes, "a.mtl:3: Ni 0 is taken as 1\n", "an index of 0");
    check(s.m.ni == 1 && s.line[MTL_NI] == 3, "it says 1");
    static const char *const texture[] = {"map_Kd -s 1 1 1", "map_Ks", "bump", "refl", "disp",
                                          "decal", "norm"};
    for (size_t i = 0; i < sizeof texture / sizeof *texture; i++) {
        char text[99];
        snprintf(text, sizeof text, "map_Kd no.png\nnewmtl a\nKd 0.5\n%s x.png\nnewmtl b\nbump y\n",
                 texture[i]);
        s = read_all(text);
        check_text(s.notes, "a.mtl:4: textures are not read\n", "the first texture");
        check(s.line[MTL_KD] == 0 && s.nothing == 3 && s.materials == 2, "%s", text);
    }
    char path[400];
    failure f;
    memset(path, 'x', sizeof path), strcpy(path + 390, "yz.mtl");
    bool ok = read_as(path, "newmtl a\nroughness 0\nabsorb xyz 1 2 3\n", &s, &f);
    check(ok && strstr(s.notes, "xyz.mtl:3: absorb: only r g b is read\n"), "long: '%s'", s.notes);
}

static void test_broken(void)
{
    static const struct { const char *text, *message; } list[] = {
        {"Kd 1 1 1\n", "1: line: before the first material: 'Kd', allowed: newmtl NAME"},
        {"Ka 1 1 1\n", "1: line: before the first material: 'Ka', allowed: newmtl NAME"},
        {"newmtl\n", "1: newmtl: no name before the end of the line, allowed: a name"},
        {"newmtl a\nKd\n", "2: Kd: no number before the end of the line, allowed: a number"},
        {"newmtl a\nKd 1 2\n", "2: Kd: no number before the end of the line, allowed: a number"},
        {"newmtl a\nKd 1 2 3 4\n", "2: Kd: too much: '4', allowed: the end of the line"},
        {"newmtl a\nillum 2 2\n", "2: illum: too much: '2', allowed: the end of the line"},
        {"newmtl a\n\nKd nan 0 0\n", "3: Kd: not a number: 'nan', allowed: finite decimals"},
        {"newmtl a\nKd inf\n", "2: Kd: not a number: 'inf', allowed: finite decimals"},
        {"newmtl a\nKs -0.5 0 0\n", "2: Ks: out of range: '-0.5', allowed: 0 to 1e+30"},
        {"newmtl a\nKa 0 -1 0\n", "2: Ka: out of range: '-1', allowed: 0 to 1e+30"},
        {"newmtl a\nKe 1e400\n", "2: Ke: out of range: '1e400', allowed: 0 to 1e+30"},
        {"newmtl a\nd 1.5\n", "2: d: out of range: '1.5', allowed: 0 to 1"},
        {"newmtl a\nTr -1\n", "2: Tr: out of range: '-1', allowed: 0 to 1"},
        {"newmtl a\nNs -3\n", "2: Ns: out of range: '-3', allowed: 0 to 1e+09"},
        {"newmtl a\nNi 20\n", "2: Ni: out of range: '20', allowed: 0 to 10"},
        {"newmtl a\nNi 0.0001\n", "2: Ni: too small before the end of the line, "
         "allowed: 0.001 to 10"},
        {"newmtl a\nroughness 1.1\n", "2: roughness: out of range: '1.1', allowed: 0 to 1"},
        {"newmtl a\nroughness -.1\n", "2: roughness: out of range: '-.1', allowed: 0 to 1"},
        {"newmtl a\nroughness x\n", "2: roughness: not a number: 'x', allowed: finite decimals"},
        {"newmtl a\npriority 1001\n", "2: priority: out of range: '1001', allowed: 0 to 1000"},
        {"newmtl a\npriority -1\n", "2: priority: out of range: '-1', allowed: 0 to 1000"},
        {"newmtl a\npriority .5\n", "2: priority: not a whole number before the end of the line, "
         "allowed: 0 to 1000"},
        {"newmtl a\nillum 11\n", "2: illum: out of range: '11', allowed: 0 to 10"},
        {"newmtl a\nillum 1.5\n", "2: illum: not a whole number before the end of the line, "
         "allowed: 0 to 10"},
        {"newmtl a\nKd 1 1 1x\n", "2: Kd: not a number: '1x', allowed: finite decimals"},
        {"newmtl a\nKd 0x1 1 1\n", "2: Kd: not a number: '0x1', allowed: finite decimals"}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        summary s;
        failure f;
        check(!read_as("a.mtl", list[i].text, &s, &f) && f.exit_code == 2, "%s", list[i].text);
        check(strncmp(f.text, "a.mtl:", 6) == 0, "%s", f.text);
        check_text(f.text + 6, list[i].message, "its message");
    }
    summary s;
    failure f;
    FILE *closed = fopen("/dev/null", "wb");
    mtl_reader r;
    if (!closed || !mtl_begin(&r, closed, "a.mtl", &f)) abort();
    check(!mtl_next(&r) && !mtl_end(&r) && f.exit_code == 1, "cannot be read: exit 1");
    check(strncmp(f.text, "a.mtl: cannot read: ", 20) == 0, "what went wrong: %s", f.text);
    fclose(closed);
    check(!read_as("a.mtl", "newmtl a\nKd 1\nKd x\nKs 1\n", &s, &f) && grey(s.m.kd, 1)
          && grey(s.m.ks, 0), "nothing is read behind what is broken");
}

int main(void)
{
    return check_all("07_mtl", test_keys, test_forms, test_notes, test_broken);
}
