/* solids.h: solids cut from solids (06), each a shape of its own, on a field of k x k.
 *
 *        die          bowl         nut        lens       gem        bell
 *       .----.       \    /      .-----.      .-.       /\ _       o===o
 *       | () |        '--'       |_(_)_|      '-'       \/(_)
 *
 *   bool make_solids(k, &w, &f)          a generator: k k solids of these kinds, each turned at
 *                                        random, and a square under them
 *
 *   shape_of_other(&x.other)             of one solid: what 07 asks of a shape is asked of csg.h
 *       h.u of its hits                  the surface, as h.shape in 06: twice a number, plus 1
 *                                        where something was cut away
 *
 * A search that enters the box of a solid asks its tree for the first crossing in [tmin, tmax].
 */
#ifndef MESH_SOLIDS_H
#define MESH_SOLIDS_H

#include "../../06_csg/csg.h"
#include "../../../common/random.h"
#include "world.h"

typedef struct {
    csg_solid solid[5];
    csg_step step[9];
    triangle gem[8];
    csg c;
    shape_other other;
} carved;
typedef struct { carved *of; size_t n; } carved_all;
typedef struct { vec3 at, axis[3]; real size; } carved_frame;  /* at + size (x axis[0] + ..) */

enum { carved_kinds = 6 };

/* ---------------------------------------------------------------------------------------------- */

static inline bool carved_hit(const void *self, ray r, hit *out)
{
    hit h;
    if (!csg_hit(self, r, &h)) return false;
    *out = (hit){h.t, (real)h.shape, 0, 0};
    return true;
}

static inline vec3 carved_normal(const void *self, hit h, vec3 p)
{
    return csg_normal(self, ray_from(p, (vec3){0, 0, 0}), (hit){0, 0, 0, (uint32_t)h.u});
}

/* postfix: "AB-" is solid 0 less solid 1. */
static inline void carve(carved *x, const char *postfix)
{
    size_t steps = 0, solids = 0;
    failure f;
    for (const char *p = postfix; *p; p++) {
        bool leaf = *p >= 'A';
        solids += leaf;
        x->step[steps++] = (csg_step){leaf ? CSG_SOLID : *p == '+' ? CSG_UNION
                                      : *p == '*' ? CSG_INTERSECTION : CSG_DIFFERENCE,
                                      leaf ? (uint32_t)(*p - 'A') : 0};
    }
    if (!csg_build((csg_model){x->solid, solids, x->step, steps}, (csg_options){0}, &x->c, &f))
        fail(f);
    csg_bound b = x->c.node[0].bound;
    x->other = (shape_other){carved_hit, carved_normal, &x->c, b.lo, b.hi};
}

static inline vec3 carved_place(const carved_frame *f, double x, double y, double z)
{
    vec3 p = vadd(vscale(f->axis[0], (real)x), vscale(f->axis[1], (real)y));
    return vmadd(f->at, vmadd(p, f->axis[2], (real)z), f->size);
}

static inline csg_solid carved_ball(const carved_frame *f, double x, double y, double z, double r)
{
    return csg_sphere(carved_place(f, x, y, z), (real)r * f->size);
}

static inline csg_solid carved_box(const carved_frame *f, double x, double y, double z)  /* +- */
{
    const double half[3] = {x, y, z};
    real lo[3], hi[3];
    for (int k = 0; k < 3; k++) {
        real middle = vdot(f->axis[k], f->at), reach = (real)half[k] * f->size;
        lo[k] = middle - reach, hi[k] = middle + reach;
    }
    return csg_box_turned(f->axis, lo, hi);
}

static inline csg_solid carved_rod(const carved_frame *f, int axis, double r)
{
    return csg_cylinder(f->at, f->axis[axis], (real)r * f->size);
}

static inline csg_solid carved_gem(carved *x, const carved_frame *f)
{
    for (int i = 0; i < 8; i++) {
        double sx = i & 1 ? -1 : 1, sy = i & 2 ? -1 : 1, sz = i & 4 ? -1 : 1;
        vec3 a = carved_place(f, sx, 0, 0), b = carved_place(f, 0, sy, 0);
        vec3 c = carved_place(f, 0, 0, sz);
        x->gem[i] = sx * sy * sz > 0 ? (triangle){a, b, c} : (triangle){a, c, b};
    }
    return csg_mesh(x->gem, 8);
}

static inline void carve_kind(carved *x, int kind, const carved_frame *f)
{
    csg_solid *s = x->solid;
    switch (kind) {
    case 0:  /* a die: a cube and a ball, three holes */
        s[0] = carved_box(f, 0.72, 0.72, 0.72), s[1] = carved_ball(f, 0, 0, 0, 0.98);
        for (int k = 0; k < 3; k++) s[2 + k] = carved_rod(f, k, 0.42);
        carve(x, "AB*C-D-E-");
        return;
    case 1:  /* a bowl */
        s[0] = carved_ball(f, 0, 0, 0, 1), s[1] = carved_ball(f, 0, 0, 0, 0.86);
        s[2] = csg_half(f->axis[2], vdot(f->axis[2], f->at) + (real)0.15 * f->size);
        carve(x, "AB-C*");
        return;
    case 2:  /* a nut */
        s[0] = carved_box(f, 0.7, 0.7, 0.3), s[1] = carved_ball(f, 0, 0, 0, 0.9);
        s[2] = carved_rod(f, 2, 0.4);
        carve(x, "AB*C-");
        return;
    case 3:  /* a lens */
        s[0] = carved_ball(f, 0, 0, 0.9, 1.3), s[1] = carved_ball(f, 0, 0, -0.9, 1.3);
        carve(x, "AB*");
        return;
    case 4:  /* a gem, bitten */
        s[0] = carved_gem(x, f), s[1] = carved_ball(f, 0.5, 0.4, 0.4, 0.5);
        carve(x, "AB-");
        return;
    default:  /* a dumbbell */
        s[0] = carved_ball(f, 0, 0, 0.65, 0.35), s[1] = carved_ball(f, 0, 0, -0.65, 0.35);
        s[2] = carved_rod(f, 2, 0.15), s[3] = carved_box(f, 0.2, 0.2, 0.6);
        carve(x, "AB+CD*+");
    }
}

static inline void carved_free(void *all)
{
    carved_all *a = all;
    for (size_t i = 0; i < a->n; i++) csg_free(&a->of[i].c);
    free(a->of), free(a);
}

/* Kind by kind, as each has its colour. */
cold_inline bool make_solids(int k, world *w, failure *f)
{
    static const vec3 paint[carved_kinds] = {{0.85, 0.2, 0.12}, {0.2, 0.45, 0.85}, {0.8, 0.75, 0.6},
                                             {0.3, 0.7, 0.4}, {0.9, 0.6, 0.15}, {0.6, 0.35, 0.7}};
    size_t cells = (size_t)k * (size_t)k;
    carved_all *all = allocate(1, sizeof *all);
    *all = (carved_all){allocate(cells, sizeof *all->of), 0};
    w->others = all, w->free_others = carved_free;
    world_room(w, cells + 1, 4, carved_kinds + 1);
    world_paint(w, (finish){{1, 0.9, 0.75}, 1, 0, 0, 0, 0});
    world_add_square(w, vec(0, 0, -0.5), (real)0.55 * (real)k);
    for (int kind = 0; kind < carved_kinds; kind++) {
        world_paint(w, (finish){paint[kind], 0.7, 0.3, 10, 0, 0});
        for (size_t i = 0; i < cells; i++) {
            random_stream g = random_start(1703, i, 0);
            carved_frame x = {.size = (real)0.46};
            vec3 d = vunit(random_in_cube(&g, 1));
            real jump = random_next(&g);
            if ((int)(random_next_bits(&g) % carved_kinds) != kind) continue;
            vbasis(d, &x.axis[0], &x.axis[1]), x.axis[2] = d;
            x.at = (vec3){(real)(i % (size_t)k) + (real)0.5 - (real)k / 2,
                          (real)(i / (size_t)k) + (real)0.5 - (real)k / 2, jump / 4};
            carved *one = &all->of[all->n++];
            carve_kind(one, kind, &x);
            world_add(w, shape_of_other(&one->other));
        }
    }
    world_light(w, (vec3){(real)k, -(real)k / 2, (real)k});
    world_light(w, (vec3){-(real)k / 2, -(real)k, (real)k});
    return world_look(w, vec(0.35 * k, -0.75 * k, 0.55 * k), vec(0, -0.04 * k, 0),
                      (vec3){0, 0, 1}, 45, f);
}

#endif
