/* Tests of the program 27_effects, from outside: what it prints, refuses, draws, and needs. */
static char directory[] = "/tmp/27_effects_XXXXXX";
#include "27_files.h"
#include "../chapters/27_effects/lab/demo.h"
#include "../chapters/27_effects/lab/six.h"
#include <sys/resource.h>

static void ends(int status, const char *arguments, const char *stream, const char *text)
{
    int got = run("27_effects", arguments);
    check(got == status, "%s: ended with %d, not %d", arguments, got, status);
    check(printed(stream, text), "%s: '%s' is not on %s", arguments, text, stream);
}

static void test_explain(void)
{
    char args[900];
    put("room.scene", "material floor\nKd .5\nillum 1\npolygon -5 0 5 5 0 5 5 0 -5 -5 0 -5\n"
        "material ball\nKd .1\nKs .8\nillum 3\nsphere 0 1 0 1\nlight at 3 5 3 colour 50\n"
        "indirect off\n");
    char room[256], out[256];
    snprintf(room, sizeof room, "%s", in_directory("room.scene"));
    snprintf(out, sizeof out, "%s", in_directory("o.pfm"));
    snprintf(args, sizeof args, "--explain --size 24x16 --scene %s --out %s", room, out);
    ends(0, args, "out", "plan       Whitted ray tracing");
    check(printed("out", "  called for    mirror          material 'ball' ("), "what calls for it");
    check(printed("out", "room.scene:8)"), "and its line");
    check(printed("out", "  cannot occur  soft shadows    nothing in use emits light (Ke)"),
          "why not");
    check(printed("out", "found: none was given"), "a camera is found");
    snprintf(args, sizeof args, "%s --explain --size 24x16 --out %s --lens 'radius .1 focus 2' "
             "--environment '0.5 1' --camera 'from 0 1 6 at 0 1 0'", room, out);
    ends(0, args, "out", "plan       path tracing");
    check(printed("out", "called for    depth of field  lens (--lens:1), radius 0.1"), "the lens");
    check(printed("out", "called for    environment     environment (--environment:1) on"),
          "environment");
    check(printed("out", "(--camera:1)"), "the camera of the option");
}

static void test_misuse(void)
{
    char args[900];
    put("broken.scene", "sphere 0 0 0 1\n\nsphere 0 0 x 1\n");
    put("broken.obj", "v 0 0 0\nf 1 2 3\n");
    put("broken.nff", "s 0 0 0 1\nz");
    put("x.jpg", "");
    static const char *const names[] = {"broken.scene:3: sphere: not a number: 'x'",
                                        "broken.obj:2: f: vertex index out of range: 3",
                                        "broken.nff:2: line: begins with 'z'"};
    for (int k = 0; k < 3; k++) {
        snprintf(args, sizeof args, "%s --quick", in_directory(
            (const char *[]){"broken.scene", "broken.obj", "broken.nff"}[k]));
        ends(2, args, "err", names[k]);
    }
    snprintf(args, sizeof args, "--scene %s --quick", in_directory("no.obj"));
    ends(1, args, "err", "no.obj: cannot read: No such file");
    ends(2, "--quick --camera 'from 0 0 0'", "err", "--camera:1: camera: something is missing");
    ends(2, "--quick --light 'at 0 0 0 colour 1; at 1'", "err", "--light:2: light: no number");
    ends(1, "--quick --environment no.pfm", "err", "no.pfm: cannot read: No such file");
    ends(2, "--quick --up w", "err", "--up:1: up: no axis: 'w'");
    ends(1, "--quick --environment no.obj", "err", "no.obj: cannot read: No such file");
    ends(2, "--quick --out no.obj", "err", "no.obj");
    ends(2, "--quick no.scene --explain", "err", "no.scene: no such file");
    snprintf(args, sizeof args, "%s --quick %s", in_directory("broken.scene"),
             in_directory("broken.obj"));
    ends(2, args, "err", "broken.obj: one file at a time");
}

/* What is drawn all the same, but not as it was meant: one line each. */
static void test_warnings(void)
{
    char args[900];
    static const struct { const char *name, *text, *said; int status; } file[] = {
        {"grey.obj", "mtllib /c/none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n",
         "grey.obj: no file '/c/none.mtl': what it describes stays grey", 0},
        {"shells.scene", "material a\nillum 6\nNi 1.1\nsphere 0 0 0 1\nsphere 0 0 0 .9\n"
         "sphere 0 0 0 .8\nsphere 0 0 0 .7\nsphere 0 0 0 .6\nsphere 0 0 0 .5\nsphere 0 0 0 .4\n"
         "sphere 0 0 0 .3\n", "more than 7 bodies lie around one another", 0},
        {"empty.scene", "# nothing yet\n", "empty.scene: no shape and no mesh", 0},
        {"far.scene", "sphere 1e308 1e308 1e308 1e307\nsphere -1e308 -1e308 -1e308 1e307\n",
         "far.scene:", 2}};
    for (int k = 0; k < 4; k++) {
        put(file[k].name, file[k].text);
        snprintf(args, sizeof args, "%s --quick --out %s", in_directory(file[k].name),
                 in_directory("o.pfm"));
        ends(file[k].status, args, "err", file[k].said);
        check(printed("err", "warning: ") == !file[k].status, "%s: a warning", file[k].name);
    }
}

/* The commands of the page, as they stand there, in a directory that has build/ and chapters/. */
static void test_page(void)
{
    char command[1200], here[512], *build = getenv("BUILD");
    size_t n;
    failure f;
    int found = 0;
    char *page = file_read("chapters/27_effects/README.md", &n, &f);
    if (!page || !getcwd(here, sizeof here)) abort();
    if (!build) build = "build";
    snprintf(command, sizeof command, "cd %s && mkdir build && ln -s %s/chapters chapters && "
             "cp %s/%s/27_effects build", directory, here, *build == '/' ? "" : here, build);
    if (system(command) != 0) abort();
    for (char *line = page, *end; (end = strchr(line, '\n')); line = end + 1) {
        *end = 0;
        if (strncmp(line, "    build/27_effects ", 21) != 0) continue;
        char *said = strstr(line + 4, "  ");
        if (said) *said = 0;
        snprintf(command, sizeof command, "cd %s && %s >out 2>err", directory, line + 4);
        check(system(command) == 0, "%s", line);
        check(printed("out", "\n-> ") && !printed("err", "warning"), "%s: its picture", line);
        found++;
    }
    check_equal(found, 4, "commands of the page");
    free(page);
}

/* What the program draws without a file is the file that ships with it. */
static void test_demo(void)
{
    size_t n;
    failure f;
    char *text = file_read("chapters/27_effects/scenes/demo.scene", &n, &f);
    check(text && strcmp(text, demo_scene) == 0, "demo.scene and demo.h");
    free(text);
    for (int k = 0; k < six_count; k++) {
        char path[100], own[six_room];
        snprintf(path, sizeof path, "chapters/27_effects/scenes/%s.scene", six_scene[k].name);
        six_text(k, own);
        text = file_read(path, &n, &f);
        check(text && strcmp(text, own) == 0, "%s and six.h", path);
        free(text);
    }
}

/* Two million triangles are to be read, built and drawn within 1 GiB: two hundred thousand within a
 * tenth of it, less what any program needs. The sanitizers need more. */
static void test_memory(void)
{
    char args[900];
    struct rusage u;
    size_t n = check_count(100000) < 100000 ? 40 : 316;
    FILE *out = fopen(in_directory("big.obj"), "wb");
    if (!out) abort();
    for (size_t j = 0; j <= n; j++)
        for (size_t i = 0; i <= n; i++)
            fprintf(out, "v %zu %.6f %zu\n", i, sin((double)(i * j) / 99), j);
    for (size_t j = 0; j < n; j++)
        for (size_t i = 0; i < n; i++) {
            size_t a = j * (n + 1) + i + 1;
            fprintf(out, "f %zu %zu %zu %zu\n", a, a + n + 1, a + n + 2, a + 1);
        }
    if (fclose(out) != 0) abort();
    snprintf(args, sizeof args, "%s --explain --size 64x64 --out %s", in_directory("big.obj"),
             in_directory("o.pfm"));
    ends(0, args, "out", n == 316 ? "199712 triangles" : "3200 triangles");
    getrusage(RUSAGE_CHILDREN, &u);
    if (n == 316) check_at_most((double)u.ru_maxrss / 1024, 107, "MiB");
    image im = {0, 0, NULL};
    failure f;
    size_t lit = 0;
    check(image_read(in_directory("o.pfm"), &im, &f), "%s", f.text);
    for (size_t i = 0; im.rgb && i < 64 * 64; i++) lit += im.rgb[3 * i] > 0;
    check_at_least(lit, 64 * 64 / 8, "pixels that show it: all of it is framed, large");
    image_free(&im);
}

/* --region draws the same pixels as the whole picture has there, and prices them. */
static void test_region(void)
{
    char args[900];
    image all = {0, 0, NULL}, part = {0, 0, NULL};
    failure f;
    snprintf(args, sizeof args, "--size 40x30 --samples 2 --out %s", in_directory("all.pfm"));
    ends(0, args, "out", "# 2 samples a pixel");
    snprintf(args, sizeof args, "--size 40x30 --samples 2 --region 9x7+20+11 --out %s",
             in_directory("part.pfm"));
    ends(0, args, "out", "# 2 samples a pixel");
    check(image_read(in_directory("all.pfm"), &all, &f), "%s", f.text);
    check(image_read(in_directory("part.pfm"), &part, &f), "%s", f.text);
    check(part.width == 9 && part.height == 7, "%d x %d pixels", part.width, part.height);
    for (int y = 0; part.rgb && all.rgb && y < part.height; y++)
        check(memcmp(part.rgb + 27 * y, all.rgb + 3 * (40 * (y + 11) + 20),
                     27 * sizeof *part.rgb) == 0, "row %d of the region", y);
    image_free(&all), image_free(&part);
    snprintf(args, sizeof args, "--size 40x30 --samples 2 --quick --price --region 9x7+20+11 "
             "--out %s", in_directory("part.pfm"));
    ends(0, args, "out", "\nthe plan ");
    check(printed("out", "\nmirror "), "the demo has a mirror: it has its price");
    strcat(args, " --effects called,-mirror");
    ends(0, args, "out", "\nindirect light ");
    check(!printed("out", "\nmirror "), "what --effects leaves out has none");
    static const char *const wrong[] = {"9x7", "9x7+32+0", "9x7+0+24", "0x7+0+0", "9x7+-1+0",
                                        "9x7+0+0+", "99999999999x7+0+0"};
    for (int k = 0; k < 7; k++) {
        snprintf(args, sizeof args, "--size 40x30 --region %s", wrong[k]);
        ends(2, args, "err", "WxH+X+Y, within the 40x30 pixels of --size");
    }
}

int main(void)
{
    if (!mkdtemp(directory)) abort();
    test_explain();
    test_misuse();
    test_warnings();
    test_demo(), test_page();
    test_region();
    test_memory();
    remove_all();
    return check_report("27_effects");
}
