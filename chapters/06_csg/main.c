/* 06_csg: solids from solids by the spans of a ray; eyes inside, and faces that coincide.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 06_csg chapters/06_csg/main.c -lm -lpthread
 * The oracle, csg_oracle.h, asks of points whether the parts hold them, and joins the answers. */
#include "lab/csg_draw.h"
#include "lab/csg_figure.h"
#include "lab/csg_measure.h"

int main(int argc, char **argv)
{
    const char *text = NULL;
    option own[] = {
        {"expression", OPTION_TEXT, &text, 0, 0, "draws 'difference(sphere 0 0 0 1, ..)'"}, {0}};
    options defaults = {.width = 720, .height = 480, .seed = 1};
    options o = options_read(argc, argv, "06_csg", "Solids from solids: error and time.", defaults,
                             own);
    o.own = text;
    csg_scene s = csg_scene_of(text ? text : CSG_CLASSIC);
    csg_draw(&o, &s);
    csg_scene_free(&s);
    if (!o.out && !o.own) csg_draw_pocket(&o), csg_draw_tree(&o);
    if (!o.out && !o.own && (o.full || o.quick)) csg_draw_inside(&o);
    csg_main_table(&o);
    if (o.full) csg_tolerance_plot(&o);
    return output_done(&o);
}
