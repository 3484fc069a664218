/* 06_csg: solids from solids, by the spans of a ray: eyes inside, faces that coincide, what they cost.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 06_csg chapters/06_csg/main.c -lm -lpthread
 * The oracle, csg_oracle.h, asks of points whether the parts hold them, and combines the answers. */
#include "lab/csg_draw.h"

int main(int argc, char **argv)
{
    const char *name = NULL, *text = NULL;
    option own[] = {{"solid", OPTION_TEXT, &name, 0, 0, "one of " "classic, bite, lens, bowl, gem, die"},
                    {"expression", OPTION_TEXT, &text, 0, 0, "such as 'difference(..)': README.md"},
                    {0}};
    options defaults = {.width = 960, .height = 640, .seed = 1};
    options o = options_read(argc, argv, "06_csg", "Solids from solids: error and time.", defaults,
                             own);
    if (name && text) die(2, "--solid %.100s and --expression: one at a time", name);
    if (name && !csg_scene_text(name))
        die(2, "--solid %.100s: allowed are classic, bite, lens, bowl, gem, die", name);
    o.own = name || text;
    csg_scene s = csg_scene_of(text ? text : csg_scene_text(name ? name : "classic"));
    csg_draw(&o, &s);
    csg_scene_free(&s);
    csg_draw_inside(&o);
    csg_draw_pocket(&o);
    return output_done(&o);
}
