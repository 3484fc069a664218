/* tree.h: a tree of unions, intersections and differences, as an array.
 *
 *   A B - C +     given as a list of steps, operands first (后缀表达式):                  +
 *                 solid A, solid B, difference, solid C, union                          /   \
 *   csg_step s[] = {{CSG_SOLID, 0}, {CSG_SOLID, 1}, {CSG_DIFFERENCE, 0}, ...};         -     C
 *                                                                                    /   \
 *   + - A B C     held with each node before its left operand, and that              A     B
 *                 before its right one; `end` is the node behind both
 *
 *   csg c;
 *   if (!csg_build((csg_model){solids, n, s, steps}, (csg_options){0}, &c, &why)) fail(why);
 *   csg_free(&c)         of the model only the triangles of meshes must stay so long
 *
 * Trees of any depth: nothing here calls itself. Each node has a bound (bound.h) of all that is in
 * it. Cost: O(steps + triangles times planes).
 *
 *   input                                       answer
 *   no steps                                    the empty set
 *   steps that are no tree; no such solid       false, and *why says which step; *out is untouched
 *   a solid without points: see solid.h         a leaf that is never asked
 */
#ifndef CSG_TREE_H
#define CSG_TREE_H

#include "../../common/file.h"
#include "bound.h"
#include "coplanar.h"

typedef struct { csg_operation what; uint32_t solid; } csg_step;
typedef struct { const csg_solid *solid; size_t solids; const csg_step *step; size_t steps; }
    csg_model;
typedef struct { bool no_bounds; } csg_options;
typedef struct {
    csg_bound bound;
    csg_operation what;
    uint32_t solid, end;   /* of a leaf; the node behind it and its operands */
    bool empty;            /* a leaf that holds nothing */
} csg_node;
typedef struct {
    csg_solid *solid;      /* [solids] of the model; of meshes, with the planes of their faces */
    size_t solids;
    uint32_t *first;       /* solid i has the surfaces first[i] .. first[i + 1] - 1 */
    csg_node *node;
    size_t nodes, depth, room;  /* room: the most crossings of all leaves together */
    bool no_bounds;
} csg;
/* ---------------------------------------------------------------------------------------------- */

static inline void csg_free(csg *c)
{
    for (size_t i = 0; c->solid && i < c->solids; i++)
        if (c->solid[i].kind == CSG_MESH) free((void *)(uintptr_t)c->solid[i].mesh.plane);
    free(c->solid), free(c->first), free(c->node);
    *c = (csg){0};
}

/* The steps as a tree: size[i] counts the steps of the subtree that ends with step i; false if they
 * are no tree. */
static inline bool csg_sizes(csg_model m, uint32_t *size, failure *why)
{
    size_t waiting = 0;
    uint32_t *operand = allocate(m.steps, sizeof *operand);  /* sizes of what waits to be joined */
    bool ok = true;
    for (size_t i = 0; i < m.steps && ok; i++) {
        bool leaf = m.step[i].what == CSG_SOLID;
        if (leaf && m.step[i].solid >= m.solids)
            ok = failed(why, 2, "step %zu: no solid %u", i, m.step[i].solid);
        else if (!leaf && waiting < 2)
            ok = failed(why, 2, "step %zu: an operation lacks operands", i);
        else if (leaf) operand[waiting++] = size[i] = 1;
        else {
            uint32_t right = operand[--waiting], left = operand[--waiting];
            operand[waiting++] = size[i] = left + right + 1;
        }
    }
    if (ok && m.steps > 0 && waiting != 1)
        ok = failed(why, 2, "%zu operands, and nothing joins them", waiting);
    free(operand);
    return ok;
}

/* Operands first becomes node first. From the last step back: a parent's place tells those of its
 * operands. Then bounds, from the leaves up. */
static inline void csg_place(csg_model m, const uint32_t *size, csg *c)
{
    uint32_t *at = allocate(m.steps, sizeof *at), *level = allocate(m.steps, sizeof *level);
    for (size_t i = m.steps; i-- > 0;) {
        csg_node *x = &c->node[at[i]];
        *x = (csg_node){.what = m.step[i].what, .solid = m.step[i].solid, .end = at[i] + size[i]};
        if (level[i] > c->depth) c->depth = level[i];
        if (x->what == CSG_SOLID) continue;
        size_t right = i - 1, left = right - size[right];
        at[left] = at[i] + 1, at[right] = at[left] + size[left];
        level[left] = level[right] = level[i] + 1;
    }
    for (size_t i = c->nodes; i-- > 0;) {
        csg_node *x = &c->node[i];
        if (x->what == CSG_SOLID) {
            x->bound = csg_bound_of(&m.solid[x->solid]);
            x->empty = !csg_solid_is_some(&m.solid[x->solid]);
            c->room += m.solid[x->solid].kind == CSG_MESH ? m.solid[x->solid].mesh.n + 2 : 2;
        } else x->bound = csg_bound_joined(x->what, x[1].bound, c->node[x[1].end].bound);
    }
    free(at), free(level);
}

static inline bool csg_build(csg_model m, csg_options o, csg *out, failure *why)
{
    csg c = {.solids = m.solids, .nodes = m.steps, .no_bounds = o.no_bounds};
    size_t surfaces = 0;
    for (size_t i = 0; i < m.solids; i++) surfaces += csg_solid_surfaces(&m.solid[i]);
    if (m.steps >= UINT32_MAX || m.solids >= UINT32_MAX || surfaces >= UINT32_MAX / 2)
        return failed(why, 2, "%zu steps, %zu surfaces: too many", m.steps, surfaces);
    uint32_t *size = allocate(m.steps, sizeof *size);
    bool ok = csg_sizes(m, size, why);
    if (ok) {
        c.node = allocate(m.steps, sizeof *c.node);
        c.first = allocate(m.solids + 1, sizeof *c.first);
        for (size_t i = 0; i < m.solids; i++)
            c.first[i + 1] = c.first[i] + (uint32_t)csg_solid_surfaces(&m.solid[i]);
        csg_place(m, size, &c);
        c.solid = coplanar_solids(m.solid, m.solids);
        *out = c;
    }
    free(size);
    return ok;
}

#endif
