/* 07_mesh: shapes, meshes from files, the closest hit by brute force, and what is inside.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 07_mesh chapters/07_mesh/main.c -lm -lpthread
 *
 * Without options: the teapot, one shape of each kind, slices through meshes, three tables.
 * With --mesh FILE.obj: that mesh in a picture, and what brute force costs on it. */
#include "../../common/lab/report.h"
#include "lab/measure.h"
#include "files/obj.h"
#include "lab/pictures.h"

/* A picture takes rays x triangles tests. Where no size is asked for, it gets the size that so
 * many tests can fill within ten seconds on two cores. That depends on the mesh alone, not on the
 * machine: the same command draws the same picture everywhere. */
static void choose_size(options *o, int *samples, const mesh *m, double tests)
{
    if (o->width == 0) {
        double rays = tests / (double)m->triangles;
        if (*samples == 0) *samples = rays > 4 * 320 * 240 ? 4 : 1;
        double width = sqrt(rays / *samples * 4 / 3);
        o->width = width > 640 ? 640 : width < 16 ? 16 : (int)width / 4 * 4;
        o->height = o->width * 3 / 4;
    }
    if (*samples == 0) *samples = 1;
    tests = (double)o->width * o->height * *samples * (double)m->triangles;
    printf("# picture %d x %d, %d rays a pixel, each against %zu triangles: %.3g tests\n",
           o->width, o->height, *samples, m->triangles, tests);
}

static void chapter_pictures(const options *o)
{
    image shapes = image_new(o->quick ? 160 : 640, o->quick ? 90 : 360);
    bool whole = draw_shapes(o->quick ? 1 : 9, o->threads, &shapes);
    output_picture(o, &shapes, "07_mesh_shapes.png", false, whole);
    image_free(&shapes);
    int side = o->quick ? 32 : 160;
    image slice = image_new(3 * side, 2 * side);
    whole = draw_slices(side, o->threads, &slice);
    output_picture(o, &slice, "07_mesh_inside.png", false, whole);
    image_free(&slice);
}

static void chapter_tables(const options *o)
{
    size_t rays = o->quick ? 500 : 20000;
    plot wrong =
        plot_new("Grazing rays told wrong", "distance", "wrong [%]", PLOT_LOG_X | PLOT_LOG_Y);
    plot residual = plot_new("Hit point off the cone", "distance", "distance from the side",
                             PLOT_LOG_X | PLOT_LOG_Y);
    plot inside = plot_new("Point in mesh, rays through vertices", "time [ns a triangle]",
                           "wrong [%]", PLOT_LOG_X);
    table shapes = measure_shapes(o->seed, rays, &wrong, &residual);
    table t = measure_inside(o->seed, rays / 10, &inside);
    output_table(o, &shapes);
    output_extra_table(o, &t);
    output_plot(o, &wrong, "07_mesh_wrong.svg");
    output_plot(o, &residual, "07_mesh_error.svg");
    output_plot(o, &inside, "07_mesh_inside_time.svg");
}

int main(int argc, char **argv)
{
    const char *path = NULL, *up = NULL;
    bool smooth = false, flat = false;
    int fineness = 6, samples = 0;
    option own[] = {
        {"mesh", OPTION_INPUT, &path, 0, 0, "an OBJ file: draw it, and measure on it"},
        {"up", OPTION_TEXT, &up, 0, 0,
         "axis that points upwards: x, y or z; default y, of the teapot z"},
        {"smooth", OPTION_FLAG, &smooth, 0, 0, "normals from the triangles around each vertex"},
        {"flat", OPTION_FLAG, &flat, 0, 0,
         "one normal a triangle, even where the file gives others"},
        {"teapot", OPTION_INT, &fineness, 1, 500, "cells along each side of its patches"},
        {"samples", OPTION_INT, &samples, 1, 4096, "rays a pixel, rounded down to a square"},
        {0}};
    options o =
        options_read(argc, argv, "07_mesh", "Shapes, meshes, brute force, and what is inside.",
                     (options){.seed = 1}, own);
    failure f;
    char name[512];
    if (up && (strlen(up) != 1 || !strchr("xyz", *up)))
        die(2, "bad value --up %s: allowed are x, y, z", up);
    mesh m = {0};
    if (!path) m = teapot_mesh(fineness);
    else if (!obj_read(path, &m, &f)) fail(f);
    if (path) printf("# %s: %zu points, %zu triangles\n", path, m.vertices, m.triangles);
    if (smooth) mesh_smooth_normals(&m);
    if (flat) free(m.n), m.n = NULL;
    o.own = path != NULL;

    choose_size(&o, &samples, &m, o.quick ? 2e7 : 2e9);
    image im = image_new(o.width, o.height);
    camera c = camera_fit(&m, up ? *up - 'x' : path ? 1 : 2, o.width, o.height);
    double start = clock_seconds();
    bool whole = draw_mesh(&m, c, samples, o.threads, &im);
    printf("# drawn in %.2f s\n", clock_seconds() - start);
    output_picture(&o, &im, picture_name("07_mesh.png", path, name), true, whole);
    image_free(&im);

    if (!o.out && !path) chapter_pictures(&o);
    if (!path) chapter_tables(&o);
    double exponent;
    plot time = plot_new("Closest hit by brute force", "triangles", "time a ray [us]",
                         PLOT_LOG_X | PLOT_LOG_Y);
    mesh fine = path ? m : teapot_mesh(o.quick ? 8 : 32);
    size_t tests = o.quick ? 200000 : 5000000;
    table cost = measure_cost(&fine, o.seed, tests, &time, &exponent);
    (path ? output_table : output_extra_table)(&o, &cost);
    printf("# time ~ n^%.3f\n", exponent);
    output_plot(&o, &time, "07_mesh_time.svg");
    if (!path) mesh_free(&fine);
    mesh_free(&m);
    return output_done(&o);
}
