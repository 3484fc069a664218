/* spd_tree.h: a tree: each branch, a cone with a ball at its end, bears two smaller ones, 2^(scale
 * + 1) - 1 branches in all; and a field.
 *
 *     \ /            a child's frame: turned about x by 40 or 25 degrees, about z by 90 or 230,
 *      o   /         scaled by .65 or .70, moved by 1 along z; then the parent's frame     (17.6)
 *      |\ /
 *      | o           radius at the base .15, at the end .67 of that, which is the child's base
 *      |/
 */
#ifndef MESH_SPD_TREE_H
#define MESH_SPD_TREE_H

#include "world.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct { vec3 x, y, z, o; } tree_frame;  /* its axes, as long as it is large; its origin */

static inline vec3 tree_out(const tree_frame *f, vec3 v)
{
    return vadd(vadd(vscale(f->x, v.x), vscale(f->y, v.y)), vscale(f->z, v.z));
}

static inline tree_frame tree_child(const tree_frame *f, int k)
{
    static const struct { double lean, around, size; } child[2] = {{40, 90, 0.65}, {25, 230, 0.70}};
    real lean = (real)child[k].lean * (pi / 180), around = (real)child[k].around * (pi / 180);
    vec3 axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < 3; i++) {
        vec3 v = turned(turned(axis[i], (vec3){1, 0, 0}, lean), (vec3){0, 0, 1}, around);
        axis[i] = tree_out(f, vscale(v, (real)child[k].size));
    }
    return (tree_frame){axis[0], axis[1], axis[2], vadd(f->o, f->z)};
}

static inline void tree_add(world *w, tree_frame f, real base, int depth)
{
    vec3 end = vadd(f.o, f.z);
    real top = base * (real)0.67;
    world_add(w, shape_of_cone((cone){f.o, base, end, top}));
    world_add(w, shape_of_sphere((sphere){end, top}));
    for (int k = 0; depth > 0 && k < 2; k++) tree_add(w, tree_child(&f, k), top, depth - 1);
}

cold_inline bool spd_tree(int scale, world *w, failure *f)
{
    static const double lamp[7][3] = {{-5, 5, 50},  {30, -30, 30}, {-40, -30, 20}, {10, 30, 40},
                                       {-30, 40, 10}, {50, 25, 20},  {-10, -60, 30}};
    tree_frame root = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
    world_room(w, 1 + 2 * (((size_t)2 << scale) - 1), 4, 2);
    world_paint(w, (finish){{0.2, 0.7, 0.2}, 1, 0, 0, 0, 0});
    world_add_square(w, (vec3){0, 0, 0}, 50);
    world_paint(w, (finish){{0.55, 0.4, 0.2}, 1, 0, 0, 0, 0});
    tree_add(w, root, 0.15, scale);
    for (int k = 0; k < 7; k++)
        world_light(w, vec(lamp[k][0], lamp[k][1], lamp[k][2]));
    return world_look(w, vec(4.5, 0.4, 2), vec(0, 0, 1.5), (vec3){0, 0, 1},
                      45, f);
}

#endif
