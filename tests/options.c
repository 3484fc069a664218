/* Tests of common/options.h: each call runs in a child process, which ends as the program would. */
#include "check.h"
#include "child.h"
#include "../common/options.h"

enum { most = 8 };
typedef struct { const char *argument[most]; } line;
static bool said_changed;  /* print that, too */

/* Reads a command line as a program would, and prints what came out of it. */
static void program(void *context)
{
    line *l = context;
    char *argv[most + 1] = {(char[]){"program"}};
    int argc = 1, edge = 8;
    double eps = 0.5, time = 0;
    bool naive = false;
    const char *mesh = NULL;
    const option own[] = {{"edge", OPTION_INT, &edge, -5, 64, "samples along an edge"},
                          {"eps", OPTION_REAL, &eps, 0, 1e6, "a tolerance"},
                          {"time", OPTION_REAL, &time, 1e-3, 9, "seconds"},
                          {"naive", OPTION_FLAG, &naive, 0, 0, "the textbook form"},
                          {"mesh", OPTION_TEXT, &mesh, 0, 0, "a file"}, {0}};
    for (int i = 0; i < most && l->argument[i]; i++)
        argv[argc++] = (char *)(size_t)l->argument[i];
    options o = options_read(argc, argv, "test_program", "About it.",
                             (options){.width = 640, .height = 480, .samples = 4, .seed = 7,
                                       .quick_width = 32, .quick_height = 24, .quick_samples = 1},
                             own);
    printf("%dx%d %d %d %llu%s%s|%d %g%s %s %s %s", o.width, o.height, o.samples, o.threads,
           (unsigned long long)o.seed, o.preview ? " preview" : "", o.quick ? " quick" : "",
           edge, eps, naive ? " naive" : "", mesh ? mesh : "-", o.out ? o.out : "-",
           o.csv ? o.csv : "-");
    if (said_changed) printf(o.changed ? " changed" : " as the book");
}

static child_result run(line l) { return child_run(program, &l); }
#define LINE(...) ((line){{__VA_ARGS__}})

static void accepts(line l, const char *expected)
{
    child_result r = run(l);
    check(r.status == 0 && r.err[0] == 0, "%s is accepted: %s", l.argument[0], r.err);
    check_text(r.out, expected, "%s", l.argument[0]);
}

/* Exit 2, nothing on stdout, and stderr names the program and has each part. */
static void refuses(line l, const char *part, const char *allowed)
{
    child_result r = run(l);
    check(r.status == 2 && r.out[0] == 0, "%s %s is misuse: exit %d", l.argument[0], l.argument[1],
          r.status);
    bool named = strncmp(r.err, "test_program: ", 14) == 0;
    check(named && strstr(r.err, part) && strstr(r.err, allowed),
          "the message has \"%s\" and \"%s\": %s", part, allowed, r.err);
    check(strchr(r.err, '\n') == r.err + strlen(r.err) - 1, "one line: %s", r.err);
}

static void test_accepted(void)
{
    accepts(LINE(NULL), "640x480 4 0 7|8 0.5 - - -");
    accepts(LINE("--size", "4x3", "--samples=9", "--threads", "2", "--seed", "12", "--quick"),
            "4x3 9 2 12 quick|8 0.5 - - -");
    accepts(LINE("--edge", "-5", "--eps", "1e-3", "--naive", "--mesh", "a b"),
            "640x480 4 0 7|-5 0.001 naive a b - -");
    accepts(LINE("--edge", "1e1", "--eps", "+.5", "--preview"),
            "640x480 4 0 7 preview|10 0.5 - - -");
    accepts(LINE("--edge=5.0", "--edge", "+6"), "640x480 4 0 7|6 0.5 - - -");
    accepts(LINE("--mesh=--x", "--mesh=a=b"), "640x480 4 0 7|8 0.5 a=b - -");
    accepts(LINE("--size=16384x1", "--seed=2147483647"), "16384x1 4 0 2147483647|8 0.5 - - -");
    accepts(LINE("--seed", "0", "--eps", "0"), "640x480 4 0 0|8 0 - - -");
    accepts(LINE("--eps", "0.1e-300"), "640x480 4 0 7|8 1e-301 - - -");
    /* --quick has other defaults; what is asked for stays, before it and behind it, and where it is
     * what the program would have taken without it */
    accepts(LINE("--quick"), "32x24 1 0 7 quick|8 0.5 - - -");
    accepts(LINE("--samples", "4", "--quick", "--size", "640x480"),
            "640x480 4 0 7 quick|8 0.5 - - -");
}

/* Whether images/ would get its own pictures back: output.h. */
static void test_changed(void)
{
    said_changed = true;
    accepts(LINE("--threads", "3", "--csv", "/dev/null", "--preview", "--size", "640x480",
                 "--full"), "640x480 4 3 7 preview|8 0.5 - - /dev/null as the book");
    accepts(LINE("--seed", "7", "--samples=4"), "640x480 4 0 7|8 0.5 - - - as the book");
    accepts(LINE("--size", "640x481"), "640x481 4 0 7|8 0.5 - - - changed");
    accepts(LINE("--seed", "8"), "640x480 4 0 8|8 0.5 - - - changed");
    accepts(LINE("--samples", "5"), "640x480 5 0 7|8 0.5 - - - changed");
    accepts(LINE("--edge=9"), "640x480 4 0 7|9 0.5 - - - changed");
    accepts(LINE("--naive"), "640x480 4 0 7|8 0.5 naive - - - changed");
    said_changed = false;
}

static void test_numbers(void)
{
    static const char *const whole[] = {
        "", " ", " 5", "5 ", "five", "5k", "5,0", "5.5", "0x10", "0X1p3", "nan", "inf", "-inf",
        "infinity", "NAN(1)", "1e999", "1e-999", "99999999999999999999", "65", "-6", "+", "-", ".",
        "e", "1e", "--5", "5-", "5e5", "5\n", "\t5", "\xd9\xa5"};
    for (size_t i = 0; i < sizeof whole / sizeof *whole; i++) {
        char word[64];
        if (strcmp(whole[i], "1e-999") == 0) continue;  /* underflows to 0, which is allowed */
        snprintf(word, sizeof word, "--edge=%s", whole[i]);
        check(run(LINE(word)).status == 2, "not a whole number from -5 to 64: '%s'", whole[i]);
        snprintf(word, sizeof word, "--samples=%s", whole[i]);
        if (strcmp(whole[i], "65") != 0 && strcmp(whole[i], "5e5") != 0)
            check(run(LINE(word)).status == 2, "not a number of samples: '%s'", whole[i]);
        snprintf(word, sizeof word, "--eps=%s", whole[i]);
        if (!strpbrk(whole[i], "56") || strstr(whole[i], " ") || strstr(whole[i], "k"))
            check(run(LINE(word)).status == 2, "not a number from 0 to 1e6: '%s'", whole[i]);
    }
    static const char *const sizes[] = {
        "", "4", "x", "4x", "x4", "4x4x4", "4X4", "4 x4", "4x 4", "4x4 ", "0x4", "4x0", "-4x4",
        "4x-4", "4.5x4", "4x4.5", "16385x4", "4x16385", "1e9x1e9", "nanx4", "4xinf", "0x10x4",
        "4x0x4", "4xx4", "4*4", "99999999999x1"};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        check(run(LINE("--size", sizes[i])).status == 2, "not a size: '%s'", sizes[i]);
    }
    static const char *const seeds[] = {"-1", "1.5", "18446744073709551616", "1e40", "abc", "0x1"};
    for (size_t i = 0; i < sizeof seeds / sizeof *seeds; i++)
        check(run(LINE("--seed", seeds[i])).status == 2, "not a seed: '%s'", seeds[i]);
}

static void test_messages(void)
{
    refuses(LINE("--samples", "0"), "--samples 0", "whole numbers from 1 to 1048576");
    refuses(LINE("--edge", "65"), "--edge 65", "whole numbers from -5 to 64");
    refuses(LINE("--eps", "-1e-9"), "--eps -1e-9", "numbers from 0 to 1000000");
    refuses(LINE("--size", "0x4"), "--size 0x4", "WxH, each side from 1 to 16384");
    refuses(LINE("--threads", "257"), "--threads 257", "from 1 to 256");
    refuses(LINE("--mesh", ""), "--mesh ''", "not empty");
    refuses(LINE("--edge", ""), "--edge ''", "whole numbers");
    refuses(LINE("--edge"), "--edge needs a value", "whole numbers");
    refuses(LINE("--mesh", "--quick"), "--mesh needs a value", "texts");
    refuses(LINE("--quick=1"), "--quick takes no value", "--quick=1");
    refuses(LINE("--bogus"), "unknown option --bogus", "--help");
    refuses(LINE("file.obj"), "file.obj: this program reads no file", "--help");
    refuses(LINE("--"), "unknown option --", "--help");
    refuses(LINE("-"), "unknown option -", "--help");
    refuses(LINE("--=5"), "unknown option --=5", "--help");
    refuses(LINE("-edge", "5"), "unknown option -edge", "--help");
    refuses(LINE("--edg", "5"), "unknown option --edg", "--help");
    refuses(LINE("--edges", "5"), "unknown option --edges", "--help");
    refuses(LINE(""), "this program reads no file", "--help");
    refuses(LINE("--out", "x.jpg"), "x.jpg", ".png, .ppm, .p3.ppm or .pfm");
    char longest[3000];
    memset(longest, 'y', sizeof longest), longest[sizeof longest - 1] = 0;
    refuses(LINE("--edge", longest), "--edge yyy", "whole numbers from -5 to 64");
    refuses(LINE(longest), "yyy: this program reads no file", "--help");
}

static void test_files(void)
{
    child_result r = run(LINE("--out", "/no/such/x.png"));
    check(r.status == 1 && strstr(r.err, "/no/such/x.png: cannot write: No such"), "%s", r.err);
    r = run(LINE("--csv", "/no/such/x"));
    check(r.status == 1 && strstr(r.err, "/no/such/x: cannot write"), "tried at once: %s", r.err);
    r = run(LINE("--csv", "/tmp"));
    check(r.status == 1 && strstr(r.err, "directory"), "a directory: %s", r.err);
    accepts(LINE("--out", "/tmp/options_test.png", "--csv", "/dev/null"),
            "640x480 4 0 7|8 0.5 - /tmp/options_test.png /dev/null");
    check(access("/tmp/options_test.png", F_OK) != 0, "a try leaves nothing behind");
}

static void to_full(void *context)
{
    if (!freopen("/dev/full", "wb", stdout)) return;
    program(context);
}

/* Prints the model and the table of a program that reads two files and writes one more. */
static void reader(void *context)
{
    line *l = context;
    char *argv[most + 1] = {(char[]){"program"}};
    int argc = 1;
    const char *model = NULL, *rays = NULL, *hits = NULL;
    const option own[] = {{"mesh", OPTION_INPUT, &model, 0, 0, "a model"},
                          {"rays", OPTION_INPUT, &rays, 0, 0, "rays"},
                          {"hits", OPTION_OUTPUT, &hits, 0, 0, "hits"}, {0}};
    for (int i = 0; i < most && l->argument[i]; i++)
        argv[argc++] = (char *)(size_t)l->argument[i];
    options o = options_read(argc, argv, "test_program", "About it.", (options){.width = 4}, own);
    printf("%s %s %s %s%s", model ? model : "-", rays ? rays : "-", hits ? hits : "-",
           o.csv ? o.csv : "-", o.full ? " full" : "");
}

static void touch(const char *path)
{
    FILE *f = fopen(path, "w");
    if (!f || fclose(f) != 0) abort();
}

/* A file without dashes is the first input. No output is an input, nor another output: by name, by
 * folder and name where it is not there yet, by device and inode where it is. */
static void test_inputs_and_outputs(void)
{
    static const struct { line given; const char *out, *err; } list[] = {
        {{{"model.obj"}}, "model.obj - - -", ""},
        {{{"--full", "model.obj", "--rays", "rays"}}, "model.obj rays - - full", ""},
        {{{"--hits", "h", "model.obj"}}, "model.obj - h -", ""},
        {{{"--hits", "/dev/null", "--csv", "/dev/null"}}, "- - /dev/null /dev/null", ""},
        {{{"none.obj"}}, "", "none.obj: no such file"},
        {{{"model.obj", "rays"}}, "", "model.obj and rays: one file at a time"},
        {{{"model.obj", "--mesh=rays"}}, "", "model.obj and rays: one file at a time"},
        {{{"--mesh", "rays", "--mesh", "model.obj"}}, "", "rays and model.obj: one file at a time"},
        {{{"--quick", "--full"}}, "", "--quick and --full"},
        {{{"model.obj", "--csv", "model.obj"}}, "", "--csv model.obj: is the file of --mesh"},
        {{{"model.obj", "--csv", "./model.obj"}}, "", "is the file of --mesh"},
        {{{"model.obj", "--csv", "link"}}, "", "--csv link: is the file of --mesh"},
        {{{"--rays", "rays", "--hits", "rays"}}, "", "--hits rays: is the file of --rays"},
        {{{"--hits", "new", "--csv", "./new"}}, "", "--hits new: is the file of --csv"},
        {{{"--hits", "/tmp/new.ppm", "--out", "/tmp/../tmp/new.ppm"}}, "", "is the file of --out"},
    };
    char folder[] = "/tmp/options_XXXXXX", before[4096];
    if (!getcwd(before, sizeof before) || !mkdtemp(folder) || chdir(folder) != 0) abort();
    touch("model.obj"), touch("rays");
    if (symlink("model.obj", "link") != 0) abort();
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        line l = list[i].given;
        child_result r = child_run(reader, &l);
        check_text(r.out, list[i].out, "of line %zu", i);
        check(*list[i].err ? r.status == 2 && strstr(r.err, list[i].err) : r.status == 0,
              "line %zu: %d, %s", i, r.status, r.err);
    }
    unlink("model.obj"), unlink("rays"), unlink("link");
    if (chdir(before) != 0 || rmdir(folder) != 0) check(false, "a file is left in %s", folder);
}

static void test_help(void)
{
    child_result r = run(LINE("--size", "5x5", "--help", "--bogus"));
    check(r.status == 0 && r.err[0] == 0, "help wins, exit 0");
    check(strncmp(r.out, "test_program: About it.\n\nusage: test_program [options]\n", 54) == 0,
          "begins with what it is: %.60s", r.out);
    static const char *const lines[] = {
        "  --edge N          samples along an edge [-5 to 64], default 8\n",
        "  --eps X           a tolerance [0 to 1000000], default 0.5\n",
        "  --time X          seconds [0.001 to 9]\n",  /* 0 is not allowed: no default */
        "  --naive           the textbook form\n", "  --mesh TEXT       a file\n",
        "  --size WxH        of the main picture, pixels [1 to 16384], default 640x480\n",
        "  --seed N          of the random numbers [0 to 2147483647], default 7\n",
        "  --samples N       rays a pixel [1 to 1048576], default 4\n", "  --out ", "  --csv ",
        "  --preview ", "  --quick ", "  --help ", "  --threads N "};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        check(strstr(r.out, lines[i]) != NULL, "help has '%s'", lines[i]);
    r = child_run(reader, &LINE("--help"));
    check(strstr(r.out, "\n\nusage: test_program [FILE] [options]\n") != NULL,
          "a program with an input takes it without dashes: %.80s", r.out);
    if (access("/dev/full", W_OK) != 0) return;  /* Linux alone has it */
    r = child_run(to_full, &LINE(NULL));
    check(r.status == 1 && strstr(r.err, "standard output: cannot write"), "full disk: %s", r.err);
}

int main(void)
{
    test_accepted();
    test_changed();
    test_numbers();
    test_messages();
    test_files();
    test_inputs_and_outputs();
    test_help();
    return check_report("options");
}
