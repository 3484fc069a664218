/* Tests of the program 27_effects: pictures that are stopped and gone on with, or end by error or
 * time. The state itself and the error are tested in 26_state.c. */
static char directory[] = "/tmp/27_long_run_XXXXXX";
#include "27_files.h"
#include "../chapters/26_path_tracer/long_run.h"

static const char room[] =
    "camera from 0 1.6 5 at 0 0.8 0 angle 40\n"
    "obj floor.obj\n"
    "sphere -0.8 0.8 0  0.8  bottle\n"
    "sphere 0.8 0.6 0.4  0.6  brushed\n"
    "polygon -1 3 1  1 3 1  1 3 -1  -1 3 -1  lamp\n"
    "environment sky.pfm\n"
    "lens radius 0.05\n";

/* @ of the arguments is the directory. */
static int go(const char *arguments)
{
    char text[1300];
    size_t n = 0;
    for (const char *p = arguments; *p && n + 40 < sizeof text; p++)
        if (*p == '@') n += (size_t)snprintf(text + n, sizeof text - n, "%s/", directory);
        else text[n++] = *p;
    text[n] = 0;
    return run("27_effects", text);
}

#define small "@room.scene --size 22x17 "

static void make_files(void)
{
    image sky = image_new(4, 2);
    failure f;
    for (size_t i = 0; i < 24; i++) sky.rgb[i] = (float)i / 24;
    put("room.scene", room);
    put("floor.obj", "v -9 0 9\nv 9 0 9\nv 9 0 -9\nv -9 0 -9\nf 1 2 3 4\n");
    check(image_write(in_directory("sky.pfm"), &sky, &f), "%s", f.text);
    image_free(&sky);
}

static void test_resumed(void)
{
    check_equal(go(small "--samples 12 --out @whole.pfm"), 0, "in one pass, nothing kept");
    check_equal(go(small "--samples 12 --save @whole.state --out @passes.pfm"), 0, "in passes");
    check(equal_files("whole.pfm", "passes.pfm"), "one pass or several: the same bytes");
    check_equal(go(small "--samples 5 --save @part.state --out @part.pfm --threads 1"), 0, "5");
    check(!equal_files("whole.pfm", "part.pfm"), "five samples are not twelve");
    check_equal(go(small "--samples 12 --resume @part.state --save @more.state --out @more.pfm"), 0,
                "gone on with");
    check(equal_files("whole.pfm", "more.pfm") && equal_files("whole.state", "more.state"),
          "stopped after 5 and resumed: the same bytes, picture and state");
    check_equal(go(small "--samples 12 --resume @part.state --save @part.state --out @more.pfm"), 0,
                "in the same file");
    check(equal_files("whole.state", "part.state"), "the same bytes again");
    check_equal(go(small "--samples 12 --region 9x7+3+5 --save @r.state --out @r.pfm"), 0, "part");
    image all = {0, 0, NULL}, part = {0, 0, NULL};
    failure f;
    bool ok = image_read(in_directory("whole.pfm"), &all, &f)
           && image_read(in_directory("r.pfm"), &part, &f);
    check(ok && part.width == 9 && part.height == 7, "the region's picture");
    for (int y = 0; ok && y < 7; y++)
        check(memcmp(part.rgb + 27 * y, all.rgb + 3 * (22 * (y + 5) + 3), 27 * sizeof(float)) == 0,
              "row %d of the region, by passes", y);
    image_free(&all), image_free(&part);
}

/* SIGTERM after the first pass that was kept: what it left goes on as if nothing had been. */
static void test_stopped(void)
{
    const char *build = getenv("BUILD");
    char command[900], text[300];
    film m;
    failure f;
    snprintf(command, sizeof command, "%s/27_effects %s/room.scene --size 22x17 --samples 1000000 "
             "--save %s/stop.state --out %s/stop.pfm >%s/out 2>%s/err & p=$!; while [ ! -e "
             "%s/stop.state ]; do sleep 0.01; done; kill -TERM $p; wait $p",
             build ? build : "build", directory, directory, directory, directory, directory,
             directory);
    int status = system(command);
    check(WIFEXITED(status) && WEXITSTATUS(status) == 143, "SIGTERM: exit 143, not %d",
          WEXITSTATUS(status));
    check(printed("err", "stop.pfm holds what there was"), "and says what there is");
    char settings[state_settings] = "";
    check(state_read(in_directory("stop.state"), &m, settings, &f), "a whole state: %s", f.text);
    int more = 2 * (int)film_samples(&m) + 3;
    film_free(&m);
    snprintf(text, sizeof text, small "--samples %d --resume @stop.state --out @stop.pfm", more);
    check_equal(go(text), 0, "gone on with");
    snprintf(text, sizeof text, small "--samples %d --out @whole.pfm", more);
    check_equal(go(text), 0, "the same without an end");
    check(equal_files("stop.pfm", "whole.pfm"), "the same bytes");
}

static void refuses(int status, const char *arguments, const char *says)
{
    check_equal(go(arguments), status, "%s", arguments);
    check(printed("err", says), "%s: says '%s'", arguments, says);
}

static void test_refused(void)
{
    refuses(1, small "--resume /dev/zero", "/dev/zero: cannot read: a device");
    refuses(2, small "--resume @floor.obj", "not a state");
    refuses(2, small "--save @room.scene", "is the file of --scene");
    refuses(2, small "--save @floor.obj --samples 1", "this run has read it");
    refuses(2, small "--save @sky.pfm --samples 1", "this run has read it");
    refuses(2, small "--out @sky.pfm --samples 100000000", "allowed are");
    refuses(2, small "--out @sky.pfm --samples 100000", "this run has read it");  /* at once */
    refuses(1, small "--save @no/such/dir --samples 1", "cannot write");
    check_equal(go(small "--samples 2 --save @s.state --out @o.pfm"), 0, "a state");
#define resumed small "--samples 4 --resume @s.state --out @o.pfm "
    refuses(2, resumed "--seed 3", "'seed 0', not 'seed 3'");
    refuses(2, resumed "--size 23x17", "of 22x17");
    refuses(2, resumed "--effects called,-mirror", "of another picture: it has 'effects");
    refuses(2, resumed "--sun 'to 1 1 1 colour 2'", "of another picture: it has 'scene");
    refuses(2, resumed "--light 'at 1 1 1 colour 2'", "of another picture: it has 'scene");
    refuses(2, resumed "--region 9x7+0+0 ", "has 22x17 pixels, not 9x7");
    check_equal(go(resumed), 0, "as it was");
    put("floor.obj", "v -9 0 9\nv 9 0 9\nv 9 0 -9\nv -9 0 -8\nf 1 2 3 4\n");
    refuses(2, resumed, "of another picture: it has 'scene");
    char command[700];
    snprintf(command, sizeof command, "mkfifo %s/p.scene; cat %s/room.scene >%s/p.scene &",
             directory, directory, directory);
    check_equal(system(command), 0, "a pipe");
    refuses(2, "@p.scene --save @p.state --size 8x8", "--save and the like want a file");
}

/* Error and time end it, too; more samples of a picture of Whitted's effects smooth its edges. */
static void test_goals(void)
{
    check_equal(go(small "--error 0.4 --out @o.pfm"), 0, "to an error");
    check(printed("out", "error rmse 0."), "which it says");
    check_equal(go(small "--time 0.05 --out @o.pfm"), 0, "for a time");
    put("sharp.scene", "sphere 0 0 0 1 chrome\nlight at 3 4 5 colour 90\n");
    check_equal(go("@sharp.scene --size 22x17 --samples 1 --save @1.state --out @o.pfm"), 0, "one");
    check_equal(go("@sharp.scene --size 22x17 --samples 3 --resume @1.state --out @a.pfm"), 0, "3");
    check_equal(go("@sharp.scene --size 22x17 --samples 3 --out @b.pfm"), 0, "at once");
    check(equal_files("a.pfm", "b.pfm"), "no sample in the middle of the pixel, if it goes on");
}

int main(void)
{
    if (!mkdtemp(directory)) abort();
    make_files();
    test_resumed(), test_stopped(), test_goals(), test_refused();
    remove_all();
    return check_report("27_long_run");
}
