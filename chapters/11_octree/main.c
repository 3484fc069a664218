/* 11_octree: a cube cut into eight, and again: its cells, their order along a ray, their cost.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 11_octree chapters/11_octree/main.c -lm -lpthread
 *
 * Without options: the teapot with its cells, the work a pixel, a quadtree with a ray, what the
 * textbook's walk gets wrong, three tables, three plots. --mesh FILE.obj: that mesh, its cells. */
#include "../07_mesh/files/obj.h"
#include "lab/figure.h"
#include "lab/measure.h"
#include "lab/pictures.h"
#include "lab/scenes.h"

typedef struct { const char *mesh; int depth, leaf; bool boxes; } own_options;

static void draw(options *o, const own_options *own, const mesh *m)
{
    vec3 lo, hi;
    char name[512];
    failure f;
    octree t;
    items x = items_of_mesh(m);
    octree_options how = {own->leaf, own->depth, true, !own->boxes, octree_defaults.most_bytes};
    image cells = image_new(o->width, o->height), work = image_new(o->width, o->height);
    double start = clock_seconds();
    if (!octree_build(&x, how, &t, &f)) fail(f);
    double built = clock_seconds();
    mesh_bounds(m, &lo, &hi);
    camera v = camera_of(lo, hi, !own->mesh, (real)o->width / (real)o->height);
    octree_picture p = {&t, m, v, &cells, o->quick ? 1 : 3, 60};
    bool whole = draw_cells(p, o->threads);
    structure_stats s = octree_stats(&t);
    printf("# %zu triangles: octree of depth %d in %.3f s, %zu leaves, %.1f %% of them empty, "
           "%.2f references an item, %.1f bytes\n", m->triangles, s.depth, built - start, s.leaves,
           100 * (double)s.empty / (double)s.leaves,
           octree_per((double)s.references, s.items), octree_per((double)s.bytes, s.items));
    output_picture(o, &cells, picture_name("11_octree.png", own->mesh, name), true, whole);
    p.im = &work;
    whole = o->out || o->own || draw_work(p, o->threads);
    output_picture(o, &work, "11_octree_work.png", false, whole);
    octree_free(&t);
    image_free(&cells), image_free(&work);
}

int main(int argc, char **argv)
{
    own_options own = {.depth = octree_defaults.depth, .leaf = octree_defaults.leaf};
    const option list[] = {
        {"mesh", OPTION_INPUT, &own.mesh, 0, 0, "FILE.obj: draw this mesh, y up, and its cells"},
        {"depth", OPTION_INT, &own.depth, 0, octree_most_depth,
         "most cuts from the root to a leaf"},
        {"leaf", OPTION_INT, &own.leaf, 1, 65535, "most triangles in a leaf"},
        {"boxes", OPTION_FLAG, &own.boxes, 0, 0, "boxes of triangles against cells, not triangles"},
        {0}};
    options o = options_read(argc, argv, "11_octree", "Octrees: space cut into eight.",
                             (options){.width = 640, .height = 400, .seed = 1}, list);
    failure f;
    mesh m = {0};
    if (own.mesh && o.csv) die(2, "--csv: no table with --mesh");
    if (o.out && o.csv) die(2, "--out draws, --csv measures: one of them");
    if (own.mesh && !obj_read(own.mesh, &m, &f)) fail(f);
    if (!own.mesh) m = teapot_mesh(o.quick ? 8 : 12);
    o.own = own.mesh != NULL;
    draw(&o, &own, &m);
    mesh_free(&m);
    if (own.mesh || o.out) return output_done(&o);
    draw_quadtree(&o);
    draw_faults(&o);
    table_of_knobs(&o, teapot_mesh(o.quick ? 6 : 40));
    table_of_faults(&o);
    table_of_stadium(&o);
    plots_of_depth(&o);
    return output_done(&o);
}
