/* 08_object_order: for each triangle its pixels, or for each pixel its triangles.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 08_object_order chapters/08_object_order/main.c -lm -lpthread
 * The oracle: the ray through the middle of each pixel against every triangle (07). */
#include "lab/orders_draw.h"
#include "lab/orders_measure.h"
#include "../07_mesh/files/obj.h"

/* A model of one's own, by its triangles. */
static void draw_model(options *o, const char *path)
{
    failure f;
    mesh m;
    vec3 lo, hi;
    char name[512];
    if (!obj_read(path, &m, &f)) fail(f);
    if (!mesh_bounds(&m, &lo, &hi)) die(2, "%.300s: no triangle", path);
    image im = image_new(o->width, o->height);
    raster s = raster_new(o->width, o->height);
    camera c = orders_look(vadd(vscale(vadd(lo, hi), (real)0.5),
                                vscale(vec(0.45, 0.55, 1), (real)1.6 * vlength(vsub(hi, lo)))),
                           vscale(vadd(lo, hi), (real)0.5), 38, (real)o->width / (real)o->height);
    raster_mesh(&s, &m, c, raster_default);
    for (int k = 0; k < o->width * o->height; k++) {
        hit h = s.h[k];
        int x = k % o->width, y = k / o->width;
        vec3 d = camera_ray(c, (real)x + (real)0.5, (real)y + (real)0.5, o->width, o->height).d;
        image_set(&im, x, y, h.shape == no_shape ? vec(0.75, 0.82, 0.9)
                                 : headlight(mesh_normal(&m, h.shape, h.u, h.v), d));
    }
    printf("# %s: %zu triangles, %zu pixels asked, %zu covered\n", path, m.triangles, s.asked,
           s.covered);
    output_picture(o, &im, picture_name("08_object_order.png", path, name), true, true);
    image_free(&im), raster_free(&s), mesh_free(&m);
}

int main(int argc, char **argv)
{
    const char *path = NULL;
    option own[] = {{"mesh", OPTION_INPUT, &path, 0, 0, "an OBJ file: draw it"}, {0}};
    options o = options_read(argc, argv, "08_object_order", "The two orders of rendering.",
                             (options){.width = 964, .height = 488}, own);
    o.own = path;
    if (path && o.csv) die(2, "--csv: no table with --mesh");
    if (path) return draw_model(&o, path), output_done(&o);
    orders_draw(&o);
    orders_measure(&o);
    if (o.out || o.own) return output_done(&o);
    orders_draw_flat(&o);
    orders_draw_edges(&o);
    orders_draw_shadow(&o);
    orders_draw_mirror(&o);
    orders_depths(&o);
    if (o.full) orders_times(&o), orders_shadows(&o), orders_mirror_table(&o);
    return output_done(&o);
}
