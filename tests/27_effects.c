/* Tests of the program 27_effects, from outside: what it prints, refuses, draws, and needs;
 * pictures that are stopped and gone on with. (The state itself and the error: 26_state.c.) */
#include "27_files.h"
#include "../chapters/26_path_tracer/files/long_run.h"
#include "../chapters/27_effects/lab/six.h"
#include <sys/resource.h>

static void ends(int status, const char *arguments, const char *stream, const char *said)
{
    int got = run("27_effects", arguments);
    check(got == status, "%s: ended with %d, not %d", arguments, got, status);
    check(printed(stream, said), "%s: '%s' is not on %s", arguments, said, stream);
}

static void draws(const char *arguments) { ends(0, arguments, "out", "\n-> "); }

#define room "@room.scene --size 22x17 "

static void make_files(void)
{
    image sky = image_new(4, 2);
    failure f;
    for (size_t i = 0; i < 24; i++) sky.rgb[i] = (float)i / 24;
    check(image_write(in_directory("sky.pfm"), &sky, &f), "%s", f.text);
    image_free(&sky);
    put("room.scene", "camera from 0 1.6 5 at 0 0.8 0 angle 40\nobj floor.obj\n"
        "sphere -0.8 0.8 0  0.8  bottle\nsphere 0.8 0.6 0.4  0.6  brushed\n"
        "polygon -1 3 1  1 3 1  1 3 -1  -1 3 -1  lamp\nenvironment sky.pfm\nlens radius 0.05\n");
    put("floor.obj", "v -9 0 9\nv 9 0 9\nv 9 0 -9\nv -9 0 -9\nf 1 2 3 4\n");
    put("sharp.scene", "indirect off\nsphere 0 0 0 1 red\nlight at 3 4 5 colour 90\n");
    put("plain.scene", "material floor\nKd .5\nillum 1\npolygon -5 0 5 5 0 5 5 0 -5 -5 0 -5\n"
        "material ball\nKd .1\nKs .8\nillum 3\nsphere 0 1 0 1\nlight at 3 5 3 colour 50\n"
        "indirect off\n");
    put("broken.scene", "sphere 0 0 0 1\n\nsphere 0 0 x 1\n");
    put("broken.obj", "v 0 0 0\nf 1 2 3\n");
    put("broken.nff", "s 0 0 0 1\nz");
    put("grey.obj", "mtllib /c/none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
#define SEVEN_SHELLS "material a\nillum 6\nNi 1.1\nsphere 0 0 0 1\nsphere 0 0 0 .9\n" \
    "sphere 0 0 0 .8\nsphere 0 0 0 .7\nsphere 0 0 0 .6\nsphere 0 0 0 .5\nsphere 0 0 0 .4\n"
    put("seven.scene", SEVEN_SHELLS);
    put("shells.scene", SEVEN_SHELLS "sphere 0 0 0 .3\n");
    put("empty.scene", "# nothing yet\n");
    put("far.scene", "sphere 1e308 1e308 1e308 1e307\nsphere -1e308 -1e308 -1e308 1e307\n");
}

static void test_explain(void)
{
    ends(0, "--explain --size 24x16 --scene @plain.scene --out @o.pfm", "out",
         "plan       Whitted ray tracing");
    check(printed("out", "  called for    mirror          material 'ball' ("), "what calls for it");
    check(printed("out", "plain.scene:8)"), "and its line");
    check(printed("out", "  called for    hard shadows    light (") && printed("out",
          "plain.scene:10) on material 'floor' ("), "the light, and what it falls on");
    check(printed("out", "  declined      indirect light  `indirect off` ("), "declined, by whom");
    check(printed("out", "  cannot occur  soft shadows    nothing in use emits light (Ke)"),
          "why not");
    check(printed("out", "found: none was given"), "a camera is found");
    ends(0, "@plain.scene --explain --size 24x16 --out @o.pfm --lens 'radius .1 focus 2' "
         "--environment '0.5 1' --camera 'from 0 1 6 at 0 1 0'", "out", "plan       path tracing");
    check(printed("out", "called for    depth of field  lens (--lens:1), radius 0.1"), "the lens");
    check(printed("out", "called for    environment     environment (--environment:1) on"),
          "environment");
    check(printed("out", "(--camera:1)"), "the camera of the option");
}

/* What is refused, what is drawn all the same, but not as it was meant, and states that are of
 * another picture than that of s.state. */
static void test_said(void)
{
#define resumed room "--samples 4 --resume @s.state --out @o.pfm "
    static const struct { int status; const char *arguments, *says; } list[] = {
        {2, "--quick @broken.scene", "broken.scene:3: sphere: not a number: 'x'"},
        {2, "--quick @broken.obj", "broken.obj:2: f: vertex index out of range: 3"},
        {2, "--quick @broken.nff", "broken.nff:2: line: begins with 'z'"},
        {1, "--quick --scene @no.obj", "no.obj: cannot read: No such file"},
        {2, "--quick --camera 'from 0 0 0'", "--camera:1: camera: something is missing"},
        {2, "--quick --light 'at 0 0 0 colour 1; at 1'", "--light:2: light: no number"},
        {1, "--quick --environment no.pfm", "no.pfm: cannot read: No such file"},
        {2, "--quick --up w", "--up:1: up: no axis: 'w'"},
        {2, "--quick --out no.obj", "no.obj"},
        {2, "--quick no.scene --explain", "no.scene: no such file"},
        {2, "@broken.scene --quick @broken.obj", "broken.obj: one file at a time"},
        {0, "@grey.obj --quick --out @o.pfm",
         "grey.obj: no file '/c/none.mtl': what it describes stays grey"},
        {2, "@shells.scene --quick --out @shells.pfm", "more than 7 bodies of glass lie around"},
        {2, "@shells.scene --quick --out @shells.pfm --camera 'from 0 0 0 at 0 0 1'",
         "more than 7 bodies of glass lie around"},
        {0, "@empty.scene --quick --out @o.pfm", "empty.scene: no shape and no mesh"},
        {2, "@far.scene --quick --out @o.pfm", "far.scene:"},
        {1, room "--resume /dev/zero", "/dev/zero: cannot read: a device"},
        {2, room "--resume @floor.obj", "not a state"},
        {2, room "--save @room.scene", "is the file of --mesh"},
        {2, room "--save @floor.obj --samples 1", "this run has read it"},
        {2, room "--save @sky.pfm --samples 1", "this run has read it"},
        {2, room "--out @sky.pfm --samples 100000", "this run has read it"},  /* at once */
        {1, room "--save @no/such/dir --samples 1", "cannot write"},
        {2, resumed "--seed 3", "'seed 0', not 'seed 3'"},
        {2, resumed "--size 23x17", "has 22x17 pixels, not 23x17"},
        {2, resumed "--effects called,-mirror", "of another picture: it has 'effects"},
        {2, resumed "--sun 'to 1 1 1 colour 2'", "of another picture: it has 'scene"},
        {2, resumed "--light 'at 1 1 1 colour 2'", "of another picture: it has 'scene"}};
    draws(room "--samples 2 --save @s.state --out @o.pfm");
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        ends(list[k].status, list[k].arguments, "err", list[k].says);
    check(access(in_directory("shells.pfm"), F_OK) != 0, "no picture of what is refused");
    draws("@seven.scene --quick --out @seven.pfm");
    draws(resumed);
    put("floor.obj", "v -9 0 9\nv 9 0 9\nv 9 0 -9\nv -9 0 -8\nf 1 2 3 4\n");
    ends(2, resumed, "err", "of another picture: it has 'scene");
    check_equal(shell("mkfifo @p.scene; cat @room.scene >@p.scene &"), 0, "a pipe");
    ends(2, "@p.scene --save @p.state --size 8x8", "err", "--save and the like want a file");
}

/* What the program draws without a file is the file that ships with it. */
static void test_shipped(void)
{
    for (int k = 0; k < six_count; k++) {
        char path[100], own[six_room];
        size_t n;
        failure f;
        six_text(k, own);
        snprintf(path, sizeof path, six_scenes "%s.scene", six_list[k].name);
        char *text = file_read(path, &n, &f);
        check(text && strcmp(text, own) == 0, "%s and what the program has", path);
        free(text);
    }
}

/* Two million triangles are to be read, built and drawn within 1 GiB: two hundred thousand within a
 * tenth of it, less what any program needs. The sanitizers need more. */
static void test_memory(void)
{
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
    ends(0, "@big.obj --explain --size 64x64 --out @o.pfm", "out",
         n == 316 ? "199712 triangles" : "3200 triangles");
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

static void test_priced(void)
{
#define priced "--size 80x60 --samples 2 --quick --price --out @o.pfm"
    ends(0, priced, "out", "\nthe plan ");
    check(printed("out", "\nmirror "), "the last of the six has a mirror: it has its price");
    ends(0, priced " --effects called,-mirror", "out", "\nindirect light ");
    check(!printed("out", "\nmirror "), "what --effects leaves out has none");
    ends(0, priced " @plain.scene --camera 'from 0 1 6 at 0 9 99'", "out", "\nhard shadows ");
    check(!printed("out", "nan"), "what is seen is black: of nothing there is no share");
    ends(0, "--size 40x30 --samples 2 --effects all --out @o.pfm", "out",
         "the same picture byte for byte");
}

static void test_resumed(void)
{
    draws(room "--samples 12 --out @whole.pfm");
    draws(room "--samples 12 --save @whole.state --out @passes.pfm");
    check(equal_files("whole.pfm", "passes.pfm"), "one pass or several: the same bytes");
    draws(room "--samples 5 --save @part.state --out @part.pfm --threads 1");
    check(!equal_files("whole.pfm", "part.pfm"), "five samples are not twelve");
    draws(room "--samples 12 --resume @part.state --save @part.state --out @more.pfm");
    check(equal_files("whole.pfm", "more.pfm") && equal_files("whole.state", "part.state"),
          "stopped after 5 and resumed: the same bytes, picture and state");
    draws(room "--effects all --samples 2 --save @all.state --out @o.pfm");
    ends(0, room "--effects all --samples 2 --resume @all.state --out @o.pfm", "out", "the same ");
    check(!printed("out", "saved"), "nothing was drawn now: of no time there is no share");
    ends(0, room "--error 0.4 --out @o.pfm", "out", "error rmse 0.");
    draws(room "--time 0.05 --out @o.pfm");
    draws("@sharp.scene --size 22x17 --samples 1 --save @1.state --out @o.pfm");
    draws("@sharp.scene --size 22x17 --samples 3 --resume @1.state --out @a.pfm");
    draws("@sharp.scene --size 22x17 --samples 3 --out @b.pfm");
    check(equal_files("a.pfm", "b.pfm"), "no sample in the middle of the pixel, if it goes on");
}

/* SIGTERM after the first pass that was kept (after 100 s, if none is): what it left goes on as if
 * nothing had been. */
static void test_stopped(void)
{
    const char *build = getenv("BUILD");
    char text[400], settings[state_settings] = "";
    film m;
    failure f;
    snprintf(text, sizeof text, "%s/27_effects " room "--samples 1000000 --save @stop.state "
             "--out @stop.pfm >@out 2>@err & p=$! n=0; while [ ! -e @stop.state ] && "
             "[ $((n += 1)) -lt 10000 ]; do sleep 0.01; done; kill -TERM $p; wait $p",
             build ? build : "build");
    check_equal(shell(text), 143, "SIGTERM: its exit code");
    check(printed("err", "stop.pfm holds what there was"), "and says what there is");
    check(state_read(in_directory("stop.state"), &m, settings, &f), "a whole state: %s", f.text);
    int more = 2 * (int)film_samples(&m) + 3;
    film_free(&m);
    snprintf(text, sizeof text, room "--samples %d --resume @stop.state --out @stop.pfm", more);
    draws(text);
    snprintf(text, sizeof text, room "--samples %d --out @whole.pfm", more);
    draws(text);
    check(equal_files("stop.pfm", "whole.pfm"), "gone on with, or without an end: the same bytes");
}

int main(void)
{
    if (!mkdtemp(directory)) abort();
    if (run("27_effects", "--help") == 0) {  /* what is not there would be waited for */
        make_files();
        test_explain(), test_shipped(), test_priced(), test_resumed(), test_stopped();
        test_said();
        test_memory();
    } else check(false, "27_effects: the program is not built (make)");
    remove_directory();
    return check_report("27_effects");
}
