/* 07_mesh: shapes, meshes from files, the closest hit by brute force, and what is inside.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 07_mesh chapters/07_mesh/main.c -lm -lpthread
 * With a FILE.obj: that mesh in a picture, and what brute force costs on it. */
#include "lab/drawing.h"
#include "lab/measure.h"
#include "lab/pictures.h"
#include "files/obj_write.h"

/* A picture takes rays x triangles tests. Where no size is asked for, it gets the size that so
 * many tests can fill: that depends on the mesh alone, not on the machine. */
static void main_picture(options *o, const mesh *m, int up, int samples, const char *path)
{
    char name[512];
    double n = (double)m->triangles, rays = (o->quick ? 5e6 : o->full || !path ? 2e9 : 4e8) / n;
    if (samples == 0) samples = o->width == 0 && rays > 4 * 320 * 240 ? 4 : 1;
    int width = (int)fmin(fmax(sqrt(rays / samples * 4 / 3), 16), 640) / 4 * 4;
    if (o->width == 0) o->width = width, o->height = width * 3 / 4;
    printf("# picture %d x %d, %d rays a pixel, each against %zu triangles: %.3g tests\n",
           o->width, o->height, samples, m->triangles, o->width * n * o->height * samples);
    image im = image_new(o->width, o->height);
    bool whole = draw_mesh(m, up, samples, o->threads, &im);
    output_picture(o, &im, picture_name("07_mesh.png", path, name), true, whole);
    image_free(&im);
}

int main(int argc, char **argv)
{
    const char *path = NULL, *up = NULL, *save = NULL;
    bool smooth = false, flat = false;
    int fineness = 6, samples = 0;
    option own[] = {
        {"mesh", OPTION_INPUT, &path, 0, 0, "an OBJ file: draw it, and measure on it"},
        {"up", OPTION_TEXT, &up, 0, 0, "axis upwards: x, y or z; default y, of the teapot z"},
        {"smooth", OPTION_FLAG, &smooth, 0, 0, "normals from the triangles around each vertex"},
        {"flat", OPTION_FLAG, &flat, 0, 0, "one normal a triangle, whatever the file gives"},
        {"teapot", OPTION_INT, &fineness, 1, 500, "cells along each side of its patches"},
        {"samples", OPTION_INT, &samples, 1, 4096, "rays a pixel, rounded down to a square"},
        {"save", OPTION_OUTPUT, &save, 0, 0, "the mesh to this .obj, its materials to a .mtl"},
        {0}};
    options o = options_read(argc, argv, "07_mesh", "Meshes, brute force, and what is inside.",
                             (options){.seed = 1}, own);
    if (up && (strlen(up) != 1 || !strchr("xyz", *up)))
        die(2, "bad value --up %s: allowed are x, y, z", up);
    if (save && !ends_with(save, ".obj")) die(2, "--save %.300s: its name ends in .obj", save);
    if (save && (o.out || o.csv)) die(2, "--save: not with --out, --csv");
    o.own = path || save || fineness != 6;
    mesh m = path ? mesh_measured(path) : teapot_mesh(o.quick && !o.own ? 1 : fineness);
    if (smooth) mesh_smooth_normals(&m);
    if (flat) free(m.n), free(m.normal_index), m.n = NULL, m.normal_index = NULL;
    if (save) return mesh_write(&m, save), mesh_free(&m), output_done(&o);
    if (o.own || o.full || o.quick || o.out || o.preview || o.width)
        main_picture(&o, &m, up ? *up - 'x' : path ? 1 : 2, samples, path);
    else printf("# the teapot, 2e9 tests, some seconds: --full draws it, or --preview\n");
    if (!o.own && !o.out) {
        draw_slices(&o, "07_mesh_inside.png");
        draw_arrays(&o, "07_mesh_arrays.svg");
    }
    if (!path) inside_report(&o);
    mesh fine = path ? m : teapot_mesh(o.quick ? 8 : 32);
    cost_report(&o, &fine, path != NULL);
    if (!path) mesh_free(&fine);
    mesh_free(&m);
    return output_done(&o);
}
