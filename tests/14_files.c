/* Rays and hits in files; and 14's program, seen from outside. (17 reads and writes them.) */
#include "../chapters/07_mesh/files/ray_file.h"
#include "check.h"

#include "program.h"

/* 1, 2, -3, 0.5, 0, 0, 1, infinity as the standard writes them down, byte by byte. */
static const unsigned char one_ray[32] = {
    0, 0, 0x80, 0x3f, 0, 0, 0, 0x40, 0, 0, 0x40, 0xc0, 0, 0, 0, 0x3f,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x80, 0x3f, 0, 0, 0x80, 0x7f};

static void test_rays(void)
{
    const char *path = in_directory("one.rays");
    failure f;
    size_t n = 0;
    put_bytes("one.rays", one_ray, 32);
    ray *r = rays_read(path, &n, &f);
    check(r && n == 1, "one ray is read");
    if (r)
        check(r->o.x == 1 && r->o.y == 2 && r->o.z == -3 && r->tmin == (real)0.5 && r->d.x == 0
              && r->d.y == 0 && r->d.z == 1 && r->tmax == real_infinity, "its eight numbers");
    free(r);
    put_bytes("one.rays", one_ray, 31);
    check(!rays_read(path, &n, &f) && f.exit_code == 2 && strstr(f.text, "31 bytes"),
          "31 bytes: misuse");
    put_bytes("one.rays", one_ray, 0);
    check(!rays_read(path, &n, &f) && f.exit_code == 2, "an empty file: misuse");
    check(!rays_read(in_directory("none"), &n, &f) && f.exit_code == 1, "no file: cannot be read");
}

static void test_hits(void)
{
    hit h[3] = {{0.5, 0, 0, 0x01020304}, hit_none, {2, 0, 0, 7}};
    static const unsigned char closest[24] = {0, 0, 0, 0x3f, 4, 3, 2, 1, 0, 0, 0x80, 0x7f,
                                              255, 255, 255, 255, 0, 0, 0, 0x40, 7, 0, 0, 0};
    static const unsigned char any[24] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x80, 0x7f,
                                          255, 255, 255, 255, 0, 0, 0, 0, 0, 0, 0, 0};
    failure f;
    size_t n;
    for (int k = 0; k < 2; k++) {  /* a file that was read is no output any more: two names */
        const char *path = in_directory(k ? "any.hits" : "closest.hits");
        check(hits_write(path, h, 3, k == 1, &f), "hits are written");
        char *bytes = file_read(path, &n, &f);
        check(bytes && n == 24 && memcmp(bytes, k ? any : closest, 24) == 0, "byte by byte, %s",
              k ? "any" : "closest");
        free(bytes);
    }
    check(!hits_write(in_directory("no/where"), h, 3, false, &f) && f.exit_code == 1,
          "no directory");
}

/* ---------------------------------------------------------------------------------------------- */

/* The program compares its walk with the search itself: another order, box or triangle: exit 1. */
static void test_program(void)
{
    static const struct { const char *arguments; int code; const char *where, *says; } list[] = {
        {"--quick --pixel 320,200", 0, "out", "\nhit: triangle "},
        {"--quick --pixel 320,200", 0, "out", ": hit at t = "},
        {"--quick --pixel 320,200", 0, "out", "(2.5)\n"},
        {"--quick --pixel 320,200", 0, "out", "(14.2)\n"},
        {"--quick --pixel 320,200", 0, "out", "(7.1)\n"},
        {"--quick --pixel 300,150", 0, "out", "pairs of boxes"},
        {"--quick --pixel 0,0", 0, "out", "no hit\n"},
        {"--pixel 640,0", 2, "err", "640"},
        {"--pixel 4294967296,0", 2, "err", "4294967296"},  /* 2^32 is not 0 */
        {"--pixel 3,2,1", 2, "err", "--pixel 3,2,1: allowed are X,Y"},
        {"--pixel 3,2 --out x.png", 2, "err", "--pixel"},
        {"--mesh /nowhere/x.obj", 1, "err", "/nowhere/x.obj"},
        {"--mesh @bad.obj", 2, "err", ":2"}};  /* the line */
    put("bad.obj", "v 0 0 0\nf 1 2 3\n");
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        check_equal(run("14_bvh", list[i].arguments), list[i].code, "%s", list[i].arguments);
        check(printed(list[i].where, list[i].says), "%s: says %s", list[i].arguments, list[i].says);
    }
}

int main(void)
{
    if (!mkdtemp(directory)) abort();
    test_rays();
    test_hits();
    if (run("14_bvh", "--help") == 0) {
        test_program();
    } else printf("14_files: the program is not built (make), so it is not tested\n");
    remove_directory();
    return check_report("14_files");
}
