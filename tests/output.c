/* Tests of common/output.h: what goes where. Each call runs in a child process. */
#include "check.h"
#include "child.h"
#include "../common/lab/report.h"

static char dir[] = "/tmp/output_test_XXXXXX";
static options given;
static bool whole = true;

static void program(void *context)
{
    image im = image_new(40, 30), small = image_new(3, 2);
    plot p = plot_new("t", "x", "y", 0), timed = plot_new("t", "x", "y", 0);
    table t = table_new("The title", "name|error"), extra = table_new("Extra", "n");
    (void)context;
    if (chdir(dir) != 0) exit(9);
    program_name = "test_program";
    image_set(&im, 0, 0, (vec3){1, 0, 0});
    table_text(&t, "one"), table_number(&t, 0.25), table_count(&extra, 5);
    output_picture(&given, &small, "other.png", false, true);
    output_picture(&given, &im, "main.png", true, whole);
    output_plot(&given, &p, "p.svg");
    output_plot(&given, &timed, "p_time.svg");
    output_extra_table(&given, &extra);
    output_table(&given, &t);
    image_free(&im), image_free(&small);
    if (fflush(stdout) != 0) exit(8);
}

static child_result run(options o, bool is_whole)
{
    given = o, whole = is_whole;
    return child_run(program, NULL);
}

static bool exists(const char *name)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s", dir, name);
    return access(path, F_OK) == 0;
}

static void clear(void)
{
    char command[128];
    snprintf(command, sizeof command, "rm -rf %s/*", dir);
    if (system(command) != 0) abort();
}

static void test_places(void)
{
    child_result r = run((options){0}, true);
    check(r.status == 0 && r.err[0] == 0, "all is well: %s", r.err);
    check(exists("images/main.png") && exists("images/other.png") && exists("images/p.svg"),
          "pictures and plots in images/");
    check(exists("build/p_time.svg") && !exists("images/p_time.svg"), "measured times in build/");
    check(strstr(r.out, "# The title\n# ") && strstr(r.out, "real = ")
          && strstr(r.out, "\nname  error\none    0.25\n"), "the table: %s", r.out);
    check(strstr(r.out, "# Extra\n"), "the extra table");
    clear();
    r = run((options){.quick = true}, true);
    check(r.status == 0 && !exists("images") && exists("build/quick/main.png")
          && exists("build/quick/p_time.svg") && exists("build/quick/p.svg"), "--quick");
    clear();
    r = run((options){.changed = true}, true);
    check(r.status == 0 && !exists("images") && exists("build/main.png") && exists("build/p.svg")
          && exists("build/other.png"), "of another size, or with other options: build/");
    clear();
    r = run((options){.out = "only.pfm", .csv = "t.csv"}, true);
    check(r.status == 0 && exists("only.pfm") && !exists("images") && !exists("build"), "--out");
    char path[256];
    size_t n;
    failure f;
    snprintf(path, sizeof path, "%s/t.csv", dir);
    char *csv = file_read(path, &n, &f);
    check_text(csv ? csv : "", "name,error\none,0.25\n", "--csv has the main table alone");
    free(csv);
    clear();
}

static void test_errors(void)
{
    child_result r;
    if (access("/dev/full", W_OK) == 0) {  /* Linux alone has it */
        r = run((options){.csv = "/dev/full"}, true);
        check(r.status == 1 && strstr(r.err, "/dev/full: cannot write: No space"), "%s", r.err);
        check(strstr(r.out, "one    0.25"), "the table was shown all the same");
        clear();
    }
    r = run((options){.csv = "no/such"}, true);
    check(r.status == 1 && strstr(r.err, "no/such: cannot write") && strstr(r.out, "one    0.25"),
          "%s", r.err);
    clear();
    char path[256];
    snprintf(path, sizeof path, "%s/images", dir);
    FILE *obstacle = fopen(path, "wb");  /* a file where the directory should be */
    if (obstacle) fclose(obstacle);
    r = run((options){0}, true);
    check(r.status == 1 && strstr(r.err, "images/other.png: cannot write"), "%s", r.err);
    clear();
    r = run((options){0}, false);
    check(r.status == 130 && exists("build/main.png") && !exists("images/main.png")
          && !exists("images/p.svg") && !exists("build/p.svg")
          && strstr(r.err, "build/main.png holds"), "stopped: saved, exit 130: %s", r.err);
    clear();
    r = run((options){.out = "x.ppm"}, false);
    check(r.status == 130 && exists("x.ppm") && strstr(r.err, "x.ppm"), "stopped: %s", r.err);
    clear();
}

static void preview(void *context)
{
    const int *size = context;
    image im = image_new(size[0], size[1]);
    for (int x = 0; x < size[0]; x++) image_set(&im, x, 0, vec(1, 0, NAN));
    output_preview(&im);
    image_free(&im);
}

static void test_preview(void)
{
    const int sizes[][2] = {{1, 1}, {2, 2}, {640, 480}, {16384, 1}, {1, 16384}, {79, 1000}, {3, 2}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        static char text[400000];
        FILE *out = tmpfile();
        int saved = dup(STDOUT_FILENO), lines = 0, marks = 0, widest = 0, now = 0;
        fflush(stdout);
        dup2(fileno(out), STDOUT_FILENO);
        preview((void *)(size_t)sizes[i]);
        fflush(stdout);
        dup2(saved, STDOUT_FILENO), close(saved);
        child_slurp(out, text, sizeof text);
        for (const char *c = text; *c; c++) {
            if (strncmp(c, "\xe2\x96\x80", 3) == 0) marks++, now++;
            if (*c == '\n') lines++, widest = now > widest ? now : widest, now = 0;
        }
        check(lines >= 1 && lines <= 25 && widest >= 1 && widest <= 80, "%d x %d: %d lines of %d",
              sizes[i][0], sizes[i][1], lines, widest);
        check_equal(marks, lines * widest, "every line has the same length");
        check(strncmp(text, "\033[38;2;255;0;0m\033[48;2;", 22) == 0, "begins with red");
    }
}

int main(void)
{
    if (!mkdtemp(dir)) return 1;
    test_places();
    test_errors();
    test_preview();
    if (rmdir(dir) != 0) return 1;
    return check_report("output");
}
