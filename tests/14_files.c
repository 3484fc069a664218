/* Rays and hits in files, and the program that reads and writes them, seen from outside. */
#include "../chapters/07_mesh/closest.h"
#include "../chapters/07_mesh/files/obj.h"
#include "../chapters/07_mesh/files/ray_file.h"
#include "../common/random.h"
#include "check.h"

static char directory[] = "/tmp/14_files_XXXXXX";
#include "program.h"

static void write_bytes(const char *path, const void *bytes, size_t n)
{
    FILE *out = fopen(path, "wb");
    if (!out || fwrite(bytes, 1, n, out) != n || fclose(out) != 0) abort();
}

/* 1, 2, -3, 0.5, 0, 0, 1, infinity as the standard writes them down, byte by byte. */
static const unsigned char one_ray[32] = {
    0, 0, 0x80, 0x3f, 0, 0, 0, 0x40, 0, 0, 0x40, 0xc0, 0, 0, 0, 0x3f,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x80, 0x3f, 0, 0, 0x80, 0x7f};

static void test_rays(void)
{
    const char *path = in_directory("one.rays");
    failure f;
    size_t n = 0;
    write_bytes(path, one_ray, 32);
    ray *r = rays_read(path, &n, &f);
    check(r && n == 1, "one ray is read");
    if (r)
        check(r->o.x == 1 && r->o.y == 2 && r->o.z == -3 && r->tmin == (real)0.5 && r->d.x == 0
              && r->d.y == 0 && r->d.z == 1 && r->tmax == real_infinity, "its eight numbers");
    free(r);
    write_bytes(path, one_ray, 31);
    check(!rays_read(path, &n, &f) && f.exit_code == 2 && strstr(f.text, "31 bytes"),
          "31 bytes: misuse");
    write_bytes(path, one_ray, 0);
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

static void put_float(unsigned char *to, real x)
{
    float f = (float)x;
    uint32_t bits;
    memcpy(&bits, &f, sizeof bits);
    for (int k = 0; k < 4; k++) to[k] = (unsigned char)(bits >> 8 * k);
}

/* The program's hits on a mesh from a file equal those of brute force, here. */
static void test_program(void)
{
    enum { n = 3000 };
    mesh m;
    failure f;
    check(obj_read("chapters/07_mesh/scenes/teapot.obj", &m, &f), "the teapot: %s", f.text);
    unsigned char *bytes = allocate(n, 32);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(1, i, 0);
        real x[8] = {5, 5, 5, 0, 0, 0, 0, i % 2 ? real_infinity : 1};
        for (int k = 0; k < 3; k++) x[k] = 10 * random_next(&g) - 5;
        for (int k = 0; k < 3; k++) x[4 + k] = 4 * random_next(&g) - 2 - x[k];
        for (int k = 0; k < 8; k++) put_float(bytes + 32 * i + 4 * k, x[k]);
    }
    write_bytes(in_directory("t.rays"), bytes, 32 * n);
    free(bytes);
    size_t rays, size, hits = 0;
    ray *r = rays_read(in_directory("t.rays"), &rays, &f);
    for (int any = 0; any < 2; any++)
        for (int s = 0; s < 5; s++) {
            static const char *const name[] = {"cycle", "longest", "median", "sah", "sweep"};
            char arguments[1000];
            snprintf(arguments, sizeof arguments,
                     "chapters/07_mesh/scenes/teapot.obj --rays %s/t.rays --hits %s/t.hits "
                     "--strategy %s --leaf %d --csv %s/t.csv %s",
                     directory, directory, name[s], s + 1, directory,
                     any ? "--any-hit" : "");
            check_equal(run("14_bvh", arguments), 0, "14_bvh %s", arguments);
            unsigned char *got = (unsigned char *)file_read(in_directory("t.hits"), &size, &f);
            size_t wrong = 0;
            check(got && size == 8 * rays, "a record for each ray");
            for (size_t i = 0; got && i < rays; i++) {
                hit h = hit_none;
                bool found = mesh_hit(&m, r[i], &h);
                real t = little_endian_real(got + 8 * i);
                uint32_t index = little_endian(got + 8 * i + 4);
                hits += found;
                wrong += any ? t != (found ? 0 : real_infinity) || index != (found ? 0 : no_shape)
                             : t != (real)(float)h.t || index != h.shape;
            }
            check_equal(wrong, 0, "%s: hits in the file are those of brute force", name[s]);
            free(got);
        }
    check(hits > rays, "enough of them hit: %zu of 10 times %zu", hits, rays);
    char *csv = file_read(in_directory("t.csv"), &size, &f);
    check(csv && strncmp(csv, "scene,structure,kind,rays,hits,build_s,bytes,nodes_per_ray,"
                              "tests_per_ray,ns_per_ray\n", 84) == 0, "the columns of the CSV");
    free(csv), free(r);
    mesh_free(&m);
}

/* The program compares its walk with the search itself: another order, box or triangle: exit 1. */
static void test_pixel(void)
{
    check_equal(run("14_bvh", "--quick --pixel 320,200"), 0, "the walk is that of the search");
    check(printed("out", "\nhit: triangle ") && printed("out", ": hit at t = "), "a hit");
    check(printed("out", "(2.5)\n") && printed("out", "(14.2)\n") && printed("out", "(7.1)\n"),
          "lines with their equations");
    check_equal(run("14_bvh", "--quick --strategy median --leaf 1 --pixel 300,150"), 0, "median");
    check_equal(run("14_bvh", "--quick --pixel 0,0"), 0, "beside the teapot");
    check(printed("out", "no hit\n"), "no hit");
    check_equal(run("14_bvh", "--pixel 640,0"), 2, "beside the picture");
    check_equal(run("14_bvh", "--pixel 4294967296,0"), 2, "2^32 is not 0");
    check_equal(run("14_bvh", "--pixel 3,2,1"), 2, "three numbers");
    check(printed("err", "--pixel 3,2,1: allowed are X,Y"), "says so");
    check_equal(run("14_bvh", "--pixel 3,2 --out x.png"), 2, "no picture");
}

static void test_misuse(void)
{
    char arguments[600];
    write_bytes(in_directory("bad.obj"), "v 0 0 0\nf 1 2 3\n", 16);
    write_bytes(in_directory("short.rays"), one_ray, 30);
    check_equal(run("14_bvh", "--strategy fast"), 2, "no such strategy");
    check(printed("err", "fast") && printed("err", "sweep"),
          "the message names it and what is allowed");
    check_equal(run("14_bvh", "--leaf 0"), 2, "no triangle in a leaf");
    check_equal(run("14_bvh", "--leaf 256"), 2, "too many");
    check_equal(run("14_bvh", "--hits x"), 2, "--hits without --rays");
    check_equal(run("14_bvh", "--any-hit"), 2, "--any-hit without --rays");
    check_equal(run("14_bvh", "--rays x --out x.png"), 2, "--rays draws nothing");
    check(printed("err", "--out: no picture with --rays"), "says so");
    check_equal(run("14_bvh", "--mesh /nowhere/x.obj"), 1, "no such mesh");
    snprintf(arguments, sizeof arguments, "--mesh %s/bad.obj", directory);
    check_equal(run("14_bvh", arguments), 2, "a mesh with an error");
    check(printed("err", "2"), "and its line");
    snprintf(arguments, sizeof arguments, "--rays %s/short.rays", directory);
    check_equal(run("14_bvh", arguments), 2, "30 bytes are no ray");
    check(printed("err", "30 bytes"), "and says so");
    check_equal(run("14_bvh", "--rays /nowhere/x.rays"), 1, "no such rays");
    snprintf(arguments, sizeof arguments, "--rays %s/one.rays --hits %s/no/where", directory,
             directory);
    write_bytes(in_directory("one.rays"), one_ray, 32);
    check_equal(run("14_bvh", arguments), 1, "hits cannot be written there");
    snprintf(arguments, sizeof arguments, "--rays %s/one.rays --hits /dev/full", directory);
    check_equal(run("14_bvh", arguments), 1, "disk full");
}

int main(void)
{
    if (!mkdtemp(directory)) abort();
    test_rays();
    test_hits();
    if (run("14_bvh", "--help") == 0) {
        test_pixel();
        test_program();
        test_misuse();
    } else printf("14_files: the program is not built (make), so it is not tested\n");
    char command[64];
    snprintf(command, sizeof command, "rm -r %s", directory);
    if (system(command) != 0) abort();
    return check_report("14_files");
}
