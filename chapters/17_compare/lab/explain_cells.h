/* explain_cells.h: the same for the structures that cut space: grids, octree, k-d tree, BSP tree.
 *
 *   explain_wrong(c, s, &x, &w, "brute force", out)      all there is to say of a wrong answer
 *
 * explain_grid, explain_nested, explain_octree, explain_kdtree, explain_bsp
 * go to the cell that holds the point of the hit and see whether the shape is listed there. If not,
 * building left it out. If so, the search did not ask that cell, or lost the answer: brute force
 * tests the shape in the same way.
 */
#ifndef COMPARE_EXPLAIN_CELLS_H
#define COMPARE_EXPLAIN_CELLS_H

#include "explain.h"

enum { cell_most_depth = 79 };  /* no tree here is deeper; one that is broken may be */

/* Nodes from the root to the leaf that holds a point; a grid has one, its cell, a nested one the
 * outer and the inner cell. */
typedef struct {
    uint32_t path[cell_most_depth + 1];
    int depth;
    size_t listed;      /* shapes in the leaf */
    bool lists;         /* the one that is looked for among them */
    size_t everywhere;  /* leaves that list it */
} cell_place;

/* ---------------------------------------------------------------------------------------------- */

static inline size_t times_listed(const uint32_t *item, size_t n, uint32_t wanted)
{
    size_t found = 0;
    for (size_t k = 0; k < n; k++) found += item[k] == wanted;
    return found;
}

static inline uint32_t cell_of(const lattice *l, vec3 p)
{
    size_t cell = 0;
    for (int k = 2; k >= 0; k--) {
        int i = lattice_index(vaxis(p, k), vaxis(l->lo, k), vaxis(l->per, k), l->n[k]);
        cell = cell * (size_t)l->n[k] + (size_t)i;
    }
    return (uint32_t)cell;
}

static inline void cell_look(cell_place *c, const cell_lists *m, uint32_t cell, uint32_t wanted)
{
    c->path[c->depth] = cell;
    c->listed = m->first[cell + 1] - m->first[cell];
    c->lists = times_listed(m->item + m->first[cell], c->listed, wanted) > 0;
}

static inline cell_place grid_place(const grid *g, vec3 p, uint32_t wanted)
{
    cell_place c = {.everywhere = times_listed(g->lists.item, g->lists.references, wanted)};
    cell_look(&c, &g->lists, cell_of(&g->cells, p), wanted);
    return c;
}

static inline cell_place nested_place(const nested *x, vec3 p, uint32_t wanted)
{
    const cell_lists *m = &x->g.lists;
    cell_place c = {{cell_of(&x->g.cells, p)}, .everywhere = times_listed(m->item, m->references,
                                                                          wanted)};
    uint32_t part = x->part_of[c.path[0]];
    if (part == 0) return c;  /* empty */
    lattice inner = nested_lattice(&x->part[part]);
    c.depth = 1;
    cell_look(&c, m, x->part[part].base + cell_of(&inner, p), wanted);
    return c;
}

static inline cell_place octree_place(const octree *t, vec3 p, uint32_t wanted)
{
    cell_place c = {.everywhere = times_listed(t->reference, t->references, wanted)};
    octree_node n = t->node[0];
    octree_cell cell = {0, 0, 0, 0};
    while (!(n.kind & octree_is_leaf) && c.depth < cell_most_depth) {
        vec3 wall = octree_cell_box(t, octree_child_cell(cell, 0)).hi;
        unsigned k = (p.x > wall.x ? 1u : 0) | (p.y > wall.y ? 2u : 0) | (p.z > wall.z ? 4u : 0);
        cell = octree_child_cell(cell, k);
        c.path[++c.depth] = n.first + k;
        if (!(n.kind >> k & 1)) return c;  /* empty */
        n = t->node[n.first + k];
    }
    c.listed = n.kind & ~octree_is_leaf;
    c.lists = times_listed(t->reference + n.first, c.listed, wanted) > 0;
    return c;
}

static inline cell_place kdtree_place(const kdtree *t, vec3 p, uint32_t wanted)
{
    cell_place c = {.depth = 0};
    uint32_t at = 0;
    vec3 q = kd_place(&t->frame, p);
    while (!kd_is_leaf(t->node[at]) && c.depth < cell_most_depth) {
        kd_node n = t->node[at];
        at = kd_lower(n) + (vaxis(q, kd_axis(n)) > (real)n.plane);
        c.path[++c.depth] = at;
    }
    size_t first = t->node[at].first, n = kd_count(t->node[at]);
    for (size_t k = 0; k < t->references; k++) {
        bool it = (t->triangle ? t->triangle[k].index : t->index[k]) == wanted;
        c.everywhere += it;
        c.lists |= it && k >= first && k < first + n;
    }
    c.listed = n;
    return c;
}

static inline cell_place bsp_place(const bsp *b, vec3 p, uint32_t wanted)
{
    cell_place c = {.everywhere = times_listed(b->reference, b->references, wanted)};
    const bsp_node *n = b->node;
    vec3 q = vsub(p, b->middle);
    while (!(n->kind & bsp_leaf_bit) && c.depth < cell_most_depth) {
        real x = n->kind < 3 ? vaxis(q, (int)n->kind)
                             : vdot(b->normal[n->kind & ~bsp_slanted_bit], q);
        uint32_t at = n->first + (x > n->at);
        c.path[++c.depth] = at;
        n = &b->node[at];
    }
    c.listed = n->kind & ~bsp_leaf_bit;
    c.lists = times_listed(b->reference + n->first, c.listed, wanted) > 0;
    return c;
}

static inline void explain_place(const cell_place *c, const wrong_answer *w, const char *leaf,
                                 FILE *out)
{
    fprintf(out, "  the point of the hit is in %s %u", leaf, c->path[c->depth]);
    if (c->depth > 0) fprintf(out, " at depth %d; nodes on the way:", c->depth);
    for (int k = 0; c->depth > 0 && k <= c->depth; k++) fprintf(out, " %u", c->path[k]);
    fprintf(out, "\n  %s %u lists %zu shapes, %sshape %u, which is listed %zu times in all\n", leaf,
            c->path[c->depth], c->listed, c->lists ? "among them " : "but not ", w->due.shape,
            c->everywhere);
    if (c->lists) fprintf(out, "  so the search skips %s %u, or loses its answer\n", leaf,
                          c->path[c->depth]);
    else fprintf(out, "  so building left it out there (or the point is in a wall, and the cell "
                      "behind lists it)\n");
}

#define EXPLAIN_PLACE(X, leaf)                                                     \
    static inline void explain_##X(const void *s, const wrong_answer *w, FILE *out)   \
    {                                                                              \
        cell_place c = X##_place(s, ray_at(w->r, w->due.t), w->due.shape);         \
        explain_place(&c, w, leaf, out);                                           \
    }
EXPLAIN_PLACE(grid, "cell")
EXPLAIN_PLACE(nested, "cell")
EXPLAIN_PLACE(octree, "leaf")
EXPLAIN_PLACE(kdtree, "leaf")
EXPLAIN_PLACE(bsp, "leaf")

/* A structure of one's own may have one here, and need not. */
static const struct { const char *type; explainer *explain; } explainers[] = {
    {"grid", explain_grid}, {"nested", explain_nested}, {"octree", explain_octree},
    {"kdtree", explain_kdtree}, {"bsp", explain_bsp}, {"bvh", explain_bvh},
    {"bvh8", explain_bvh8}};

static inline void print_hit(FILE *out, const char *who, hit h)
{
    if (h.shape == no_shape) fprintf(out, "  %s: no hit\n", who);
    else fprintf(out, "  %s: t = %.17g, u = %.17g, v = %.17g, shape %u\n", who, (double)h.t,
                 (double)h.u, (double)h.v, h.shape);
}

static inline void explain_wrong(const contender *c, const void *s, const items *x,
                                 const wrong_answer *w, const char *oracle, FILE *out)
{
    const ray *r = &w->r;
    size_t n = sizeof explainers / sizeof *explainers, k = 0;
    fprintf(out, "%s: wrong ray: o = (%.17g, %.17g, %.17g), d = (%.17g, %.17g, %.17g), "
                 "interval [%.17g, %.17g]\n", c->name, (double)r->o.x, (double)r->o.y,
            (double)r->o.z, (double)r->d.x, (double)r->d.y, (double)r->d.z, (double)r->tmin,
            (double)r->tmax);
    print_hit(out, oracle, w->due);
    if (w->any) fprintf(out, "  %s: occluded: %s\n", c->name,
                        w->got.shape == no_shape ? "no" : "yes");
    else print_hit(out, c->name, w->got);
    explain_window(c, s, w, out);
    explain_shape(x, w, out);
    while (k < n && strcmp(explainers[k].type, c->type) != 0) k++;
    if (k < n && w->due.shape != no_shape) explainers[k].explain(s, w, out);
}

#endif
