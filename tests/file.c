/* Tests of common/file.h: written whole or not at all. */
#include "check.h"
#include "child.h"
#include "../common/file.h"
#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <time.h>

static char dir[] = "/tmp/file_test_XXXXXX";

/* Path of a name in the directory of this test; the last four stay valid. */
static const char *in_dir(const char *name)
{
    static char path[4][2048];
    static int k;
    k = (k + 1) % 4;
    snprintf(path[k], sizeof path[k], "%s/%s", dir, name);
    return path[k];
}

static bool put(const char *path, const char *text, failure *f)
{
    file_writer w;
    if (!file_begin(&w, path, f)) return false;
    fprintf(w.stream, "%s", text);
    return file_commit(&w, f);
}

static bool holds(const char *path, const char *text)
{
    size_t n;
    failure f;
    char *got = file_read(path, &n, &f);
    file_forget(path);  /* tests look at what they have written, and write it again */
    bool same = got && n == strlen(text) && memcmp(got, text, n + 1) == 0;
    free(got);
    return same;
}

/* Names in the directory that contain `part`. */
static int names_with(const char *part)
{
    int n = 0;
    DIR *d = opendir(dir);
    for (struct dirent *e; d && (e = readdir(d));) n += strstr(e->d_name, part) != NULL;
    if (d) closedir(d);
    return n;
}

static void test_plain(void)
{
    failure f = {0, ""};
    file_writer w;
    check(put(in_dir("a"), "one", &f) && holds(in_dir("a"), "one"), "a new file");
    check(file_begin(&w, in_dir("a"), &f), "begin");
    fprintf(w.stream, "two");
    fflush(w.stream);
    check(holds(in_dir("a"), "one") && names_with(".part") == 1, "the old file while writing");
    check(file_commit(&w, &f) && holds(in_dir("a"), "two"), "replaced by commit");
    check(file_begin(&w, in_dir("a"), &f), "begin");
    fprintf(w.stream, "three");
    file_abandon(&w);
    check(holds(in_dir("a"), "two") && names_with(".part") == 0, "abandoned: nothing changed");
    check(put(in_dir("strange \n\"'%s\xff name"), "x", &f), "odd characters in a name");
    check(holds(in_dir("strange \n\"'%s\xff name"), "x"), "and they can be read");
    check(put(in_dir("empty"), "", &f) && holds(in_dir("empty"), ""), "an empty file");
}

static void test_refusals(void)
{
    failure f = {0, ""};
    char name[1500];
    memset(name, 'n', sizeof name), name[sizeof name - 1] = 0;
    check(!put(in_dir("no/such"), "x", &f) && f.exit_code == 1, "missing directory");
    check(strstr(f.text, "no/such: cannot write: No such file"), "says what and why: %s", f.text);
    check(!put(dir, "x", &f) && strstr(f.text, "Is a directory"), "a directory: %s", f.text);
    check(!put(in_dir(name), "x", &f) && strstr(f.text, "too long"), "too long a name: %s", f.text);
    check(!put("", "x", &f) && f.exit_code == 1, "the empty path: %s", f.text);
    size_t n;
    check(!file_read(in_dir("missing"), &n, &f) && f.exit_code == 1
          && strstr(f.text, "missing: cannot read: No such"), "reading what is not: %s", f.text);
    check(!file_read(dir, &n, &f) && strstr(f.text, "directory"), "a directory: %s", f.text);
    check(!failed(NULL, 1, "x"), "nobody wants to know");
    check(names_with(".part") == 0, "no temporary file is left");
}

static void as_nobody(void *context)
{
    failure f;
    if (getuid() == 0 && setuid(65534) != 0) exit(9);
    if (!put(context, "changed", &f)) fail(f);
}

static void test_permissions(void)
{
    failure f;
    struct stat s;
    check(put(in_dir("mode"), "x", &f) && chmod(in_dir("mode"), 0640) == 0
          && put(in_dir("mode"), "y", &f) && stat(in_dir("mode"), &s) == 0
          && (s.st_mode & 0777) == 0640, "permissions stay");
    check(put(in_dir("locked"), "old", &f) && chmod(in_dir("locked"), 0444) == 0, "made");
    chmod(dir, 0777);
    child_result r = child_run(as_nobody, (void *)(size_t)in_dir("locked"));
    check(r.status == 1 && strstr(r.err, "Permission denied") && holds(in_dir("locked"), "old"),
          "a protected file in an open directory stays: %s", r.err);
    chmod(dir, 0555);
    r = child_run(as_nobody, (void *)(size_t)in_dir("fresh"));
    check(r.status == 1 && strstr(r.err, "Permission denied"), "read-only directory: %s", r.err);
    chmod(dir, 0755);
}

static void test_links(void)
{
    failure f;
    struct stat s;
    check(put(in_dir("target"), "old", &f) && symlink("target", in_dir("link")) == 0, "made");
    check(put(in_dir("link"), "new", &f) && holds(in_dir("target"), "new"), "through the link");
    check(lstat(in_dir("link"), &s) == 0 && S_ISLNK(s.st_mode), "the link stays a link");
    check(symlink("later", in_dir("early")) == 0, "made");
    check(!put(in_dir("early"), "x", &f) && f.exit_code == 1 && strstr(f.text, "not there")
          && access(in_dir("later"), F_OK) != 0, "a link to nothing is refused: %s", f.text);
    check(lstat(in_dir("early"), &s) == 0 && S_ISLNK(s.st_mode), "that stays a link, too");
    check(put("/dev/null", "x", &f) && stat("/dev/null", &s) == 0 && S_ISCHR(s.st_mode),
          "a device stays a device");
    if (access("/dev/full", W_OK) != 0) return;  /* Linux alone has it */
    check(symlink("/dev/full", in_dir("full.ppm")) == 0, "made");
    check(!put(in_dir("full.ppm"), "x", &f) && f.exit_code == 1
          && strstr(f.text, "No space left"), "a full disk is reported: %s", f.text);
    check(lstat(in_dir("full.ppm"), &s) == 0 && S_ISLNK(s.st_mode), "that link stays, too");
}

static void write_much(void *context)
{
    failure f;
    file_writer w;
    if (!file_begin(&w, context, &f)) fail(f);
    for (int i = 0; i < 100000; i++) fprintf(w.stream, "new ");
    fflush(w.stream);
    kill(getpid(), SIGKILL);
}

static void test_kill(void)
{
    failure f;
    check(put(in_dir("k"), "old", &f), "made");
    child_result r = child_run(write_much, (void *)(size_t)in_dir("k"));
    check(r.status == 128 + SIGKILL && holds(in_dir("k"), "old"), "kill -9 leaves the old file");
    char left[64];
    snprintf(left, sizeof left, "k.%ld.part", (long)getpid());
    FILE *stale = fopen(in_dir(left), "wb");
    check(stale != NULL, "made"), fclose(stale);
    check(put(in_dir("k"), "newer", &f) && holds(in_dir("k"), "newer"),
          "what a dead process of our number left is no obstacle");
}

static void test_pipe(void)
{
    failure f;
    char got[16] = "";
    check(mkfifo(in_dir("pipe"), 0600) == 0, "made");
    pid_t reader = fork();
    if (reader == 0) {
        FILE *in = fopen(in_dir("pipe"), "rb");
        size_t n = fread(got, 1, 15, in);
        _exit(n == 5 && memcmp(got, "hello", 5) == 0 ? 0 : 1);
    }
    alarm(300);  /* a writer that opened the pipe twice would wait for ever */
    check(file_try(in_dir("pipe"), &f), "a pipe is not opened for a try");
    int status = 0;
    nanosleep(&(struct timespec){0, 100000000}, NULL);  /* time for the reader to be deceived */
    check(put(in_dir("pipe"), "hello", &f), "into a pipe");
    waitpid(reader, &status, 0);
    alarm(0);
    check(child_status(status) == 0, "the reader got all of it");
}

static void write_to_stdout(void *context)
{
    failure f;
    (void)context;
    printf("before\n");
    if (!put("/dev/stdout", "middle\n", &f)) fail(f);
    printf("after\n");
}

static void test_stdout(void)
{
    child_result r = child_run(write_to_stdout, NULL);
    check_text(r.out, "before\nmiddle\nafter\n", "/dev/stdout that is a file, in order");
}

/* Two processes write the same file over and over; it is always whole. */
static void test_two_writers(void)
{
    failure f;
    char text[2][5001];
    for (int k = 0; k < 2; k++) memset(text[k], 'a' + k, 5000), text[k][5000] = 0;
    pid_t other = fork();
    for (int i = 0; i < 200; i++)
        if (!put(in_dir("both"), text[other == 0], &f)) { if (other == 0) _exit(1); break; }
    if (other == 0) _exit(0);
    int status, torn = 0;
    for (int i = 0; i < 100; i++)
        torn += !holds(in_dir("both"), text[0]) && !holds(in_dir("both"), text[1]);
    waitpid(other, &status, 0);
    check(child_status(status) == 0, "the other writer had no error");
    check_equal(torn, 0, "files that were neither the one nor the other");
}

static void test_read_large(void)
{
    failure f;
    file_writer w;
    size_t n = 0, wrong = 0, many = 300000;
    check(file_begin(&w, in_dir("large"), &f), "begin");
    for (size_t i = 0; i < many; i++) fputc((int)(i * i % 251), w.stream);
    check(file_commit(&w, &f), "commit");
    char *got = file_read(in_dir("large"), &n, &f);
    for (size_t i = 0; got && i < n; i++) wrong += (unsigned char)got[i] != i * i % 251;
    check(got && n == many && wrong == 0 && got[n] == 0, "a file larger than the first array");
    free(got);
}

/* Read by AddressSanitizer, which would end the program itself: a name of its own.
 * NOLINTNEXTLINE(bugprone-reserved-identifier, cert-dcl37-c, cert-dcl51-cpp) */
const char *__asan_default_options(void);
const char *__asan_default_options(void) { return "allocator_may_return_null=1"; }

static void too_much(void *context)
{
    char *volatile p = allocate(SIZE_MAX / 2, 4);  /* volatile: clang leaves out what nobody sees */
    (void)context;
    free(p);
}

/* An array of so many bytes for a file; without one, for the function that asks. */
static void too_much_for(void *file)
{
    size_t room = SIZE_MAX / 8;
    char *volatile p = file ? grown_for(file, NULL, room, 1, &room, 1 << 20)
                            : grown(NULL, room, &room, 1 << 20);
    free(p);
}

static void read_too_much(void *path)
{
    size_t n;
    struct rlimit memory = {(rlim_t)1 << 26, (rlim_t)1 << 26};
    if (setrlimit(RLIMIT_AS, &memory) != 0) exit(77);
    free(file_read(path, &n, NULL));
}

/* The tests are built as one program, too, in which a function's name is longer. */
#define no_memory_in(function) ": " #function ": no memory for"

/* The message names what did not fit, not a file that was read before. */
static void test_memory_for_what(void)
{
    char path[2048];
    snprintf(path, sizeof path, "%s", in_dir("sparse"));
    check(put(path, "", NULL) && truncate(path, (off_t)1 << 27) == 0, "128 MB of nothing");
    child_result r = child_run(too_much_for, NULL);
    check(r.status == 1 && strstr(r.err, no_memory_in(too_much_for)), "a function: %s", r.err);
    r = child_run(too_much_for, path);
    check(r.status == 1 && strstr(r.err, "sparse: no memory for"), "a file: %s", r.err);
    if (getenv("CHECK_DIVISOR")) return;  /* a sanitizer needs more */
    r = child_run(read_too_much, path);
    check(r.status == 1 && strstr(r.err, "sparse: no memory for"), "file_read: %s", r.err);
}

static void test_memory(void)
{
    child_result r = child_run(too_much, NULL);
    check(r.status == 1 && strstr(r.err, no_memory_in(too_much)),
          "an overflow is no memory: %s", r.err);
    size_t room = 0, sum = 0;
    int *p = NULL;
    for (size_t n = 0; n < 1000; n++) p = grown(p, n, &room, sizeof *p), p[n] = (int)n;
    for (size_t n = 0; n < 1000; n++) sum += (size_t)p[n];
    check(sum == 499500 && room >= 1000 && room < 2100, "an array that grows keeps its items");
    check(p[1000] == 0, "its rest is zero");
    free(p);
    char *none = allocate(0, 8);
    check(none != NULL, "no items are an array, too"), free(none);
}

/* An end from outside, while a file is written. */
static void end_by(void *number)
{
    file_writer w;
    file_watch_signals();
    if (!file_begin(&w, in_dir("ended"), NULL)) abort();
    raise((int)(size_t)number);
    file_abandon(&w);
}

static void test_signals(void)
{
    const int ends[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU};
    struct rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        void (*before)(int) = signal(ends[i], SIG_DFL);
        check_equal(child_run(end_by, (void *)(size_t)ends[i]).status, 128 + ends[i], "it ends");
        check_equal(names_with("ended"), 0, "signal %d leaves nothing half done", ends[i]);
        signal(ends[i], SIG_IGN);
        check_equal(child_run(end_by, (void *)(size_t)ends[i]).status, 0, "ignored, it stays so");
        signal(ends[i], before);
    }
}

/* Of a pipe, which may never end, a reader of whole files takes so much and no more. */
static void test_endless(void)
{
    failure f;
    size_t n, most = file_pipe_most;
    check_equal(most, 1 << 28, "256 MB");
    file_pipe_most = 3000000;
    for (size_t bytes = file_pipe_most; bytes <= file_pipe_most + 1; bytes++) {
        char *text = NULL;
        if (mkfifo(in_dir("endless"), 0600) != 0) abort();
        pid_t writer = fork();
        if (writer == 0) {
            FILE *out = fopen(in_dir("endless"), "wb");
            for (size_t i = 0; i < bytes; i++) putc('x', out);
            _exit(fclose(out) != 0);
        }
        text = file_read(in_dir("endless"), &n, &f);
        check((text != NULL) == (bytes == file_pipe_most), "%zu bytes of a pipe", bytes);
        if (text) check_equal(n, bytes, "all of it");
        else check(f.exit_code == 2 && strstr(f.text, "endless: no end: 256 MB"), "%s", f.text);
        free(text), unlink(in_dir("endless"));
        waitpid(writer, NULL, 0);
    }
    char *text = calloc(file_pipe_most + 3, 1);
    check(text && put(in_dir("long"), memset(text, 'x', file_pipe_most + 2), &f), "written");
    free(text), text = file_read(in_dir("long"), &n, &f);
    check(text && n == file_pipe_most + 2, "a file on a disk may be longer");
    free(text), file_pipe_most = most;
}

/* What was read is not replaced, by whatever name, until it is forgotten. Devices have no end. */
static void test_read_files_stay(void)
{
    failure f;
    files_read = 0;  /* inodes of files that earlier tests have read and removed are used again */
    const char *model = in_dir("model"), *link = in_dir("alias");
    check(put(model, "v 0 0 0", &f) && put(model, "v 1 1 1", &f), "it was only written: %s",
          f.text);
    if (symlink("model", link) != 0) abort();
    FILE *in = file_open(link, &f);
    check(in && fclose(in) == 0, "it is read");
    f.exit_code = 0;
    check(!put(model, "table", &f) && f.exit_code == 2 && strstr(f.text, "has read it"),
          "not replaced: %s", f.text);
    check(!put(link, "table", &f), "nor by its other name");
    check(holds(link, "v 1 1 1"), "it is as it was, and now forgotten");
    check(put(model, "state", &f) && holds(model, "state"), "forgotten, it may be replaced");
    check(!file_open("/dev/zero", &f) && f.exit_code == 1 && strstr(f.text, "a device"),
          "a device: %s", f.text);
    check(!file_open(dir, &f) && strstr(f.text, "Is a directory"), "a directory: %s", f.text);
    check(!file_open(in_dir("none"), &f) && strstr(f.text, "No such file"), "none: %s", f.text);
}

int main(void)
{
    if (!mkdtemp(dir)) return 1;
    test_plain();
    test_refusals();
    test_permissions();
    test_links();
    test_kill();
    test_pipe();
    test_stdout();
    test_two_writers();
    test_read_large();
    test_memory();
    test_memory_for_what();
    test_read_files_stay();
    test_endless();
    test_signals();
    char command[64];
    snprintf(command, sizeof command, "rm -rf %s", dir);
    if (system(command) != 0) return 1;
    return check_report("file");
}
