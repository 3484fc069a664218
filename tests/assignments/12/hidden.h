/* Checks of assignment 12 that the student does not have: hard cases. Included after public.h. */
#ifndef HIDDEN_12_H
#define HIDDEN_12_H

/* Planes moved: what is found depends on the leaves that are visited. */
static question ask_moved(random_stream *g, int i)
{
    question q = ask_soup(g, 7 * i + 1);
    q.n = question_most;
    for (int k = 0; k < q.n; k++) {
        vec3 p = exam_vector(g, 3);
        double size = k % 4 == 0 ? 4 : 0.6;
        q.tri[k] = (triangle){vadd(p, exam_vector(g, size)), vadd(p, exam_vector(g, size)),
                              vadd(p, exam_vector(g, size))};
    }
    q.moved = random_next_bits(g) | 1;
    if (i % 4 == 3) q.r.tmax = exam_between(g, 0.5, 1);
    if (i % 4 == 2) q.r.tmin = exam_between(g, 0.5, 1);
    return q;
}

/* The search with a stack of nodes still to be visited: each from where on, and until when. */
static bool mark_visit_moved(const question *q, const answer *a, char why[exam_why])
{
    typedef struct { const first_kd_node *node; real from, to, plane; } waiting;
    waiting stack[64];
    first_mesh m;
    first_kdtree t;
    ray r = q->r;
    hit h = {0, 0, 0, 0};
    bool found = false;
    real from, to;
    int top = 0;
    question_tree(q, &m, &t);
    if (pass(r, t.box, &from, &to)) stack[top++] = (waiting){&t.root, from, to, from};
    while (top > 0) {
        waiting w = stack[--top];
        if (w.plane > r.tmax) continue;
        for (int k = 0; !w.node->child && k < w.node->n; k++)
            found |= first_mesh_test(&m, w.node->item[k], &r, &h);
        if (!w.node->child) continue;
        real o = vaxis(r.o, w.node->axis), d = vaxis(r.d, w.node->axis);
        real cross = (w.node->plane - o) / d;
        const first_kd_node *lower = &w.node->child[0], *upper = &w.node->child[1];
        if (d == 0) {
            stack[top++] = (waiting){o > w.node->plane ? upper : lower, w.from, w.to, w.from};
            continue;
        }
        if (cross <= w.to)
            stack[top++] = (waiting){d > 0 ? upper : lower, real_max(cross, w.from), w.to, cross};
        if (w.from <= cross)
            stack[top++] = (waiting){d > 0 ? lower : upper, w.from, real_min(cross, w.to),
                                     -real_infinity};
    }
    first_kdtree_free(&t), first_mesh_free(&m);
    return mark_closest(a, found, h,
                        "planes were moved; a search that visits what it should, and in its order,",
                        why);
}

/* Planes at whole numbers, and rays through their edges and corners, along axes, in planes. */
static question ask_lattice(random_stream *g, int i)
{
    question q = ask_moved(g, 4 * i);
    q.whole = true;
    vec3 to = {0, 0, 0}, d = {0, 0, 0};
    do {
        to = vec((double)(random_next_bits(g) % 5) - 2, (double)(random_next_bits(g) % 5) - 2,
                 (double)(random_next_bits(g) % 5) - 2);
        d = vec((double)(random_next_bits(g) % 3) - 1, (double)(random_next_bits(g) % 3) - 1,
                (double)(random_next_bits(g) % 3) - 1);
    } while (vzero(d));
    if (i % 5 == 4) d = vscale(d, -1);                                /* zeros are -0 */
    q.r = ray_from(vsub(to, vscale(d, 8)), d);
    if (i % 3 == 1) q.r = ray_from(to, d);
    if (i % 3 == 2) q.r.tmax = 8;
    if (i % 4 == 3) q.most = 1 + i % 5;
    return q;
}

/* Whole numbers, many of them the same place; flat boxes, on sides of the cell, too; one box; a
 * cell of no surface; what is cheaper as a leaf. */
static question ask_flat(random_stream *g, int i)
{
    question q = ask_boxes(g, i);
    if (i % 6 == 0) q.n = 1;
    q.cell = (aabb){{0, 0, 0}, {6, 6, i % 6 == 4 ? 0 : 6}};
    if (i % 12 == 4) q.cell.hi.y = 0;
    for (int k = 0; k < q.n; k++) {
        int x = (int)(random_next_bits(g) % 5), y = (int)(random_next_bits(g) % 5);
        int size = (int)(random_next_bits(g) % 3);
        q.box[k] = (aabb){{(real)x, (real)y, 1}, {(real)x, (real)(y + size), 6}};
        if (size > 1) q.box[k].hi.x = (real)(x + 1);
        if (i % 6 == 1) q.box[k] = (aabb){{(real)(2 * (x % 4)), 0, 0},
                                          {(real)(2 * (x % 4)), 6, 6}};
        if (i % 6 == 3) q.box[k] = (aabb){{1, 1, 1}, {2, 2, 2}};
        q.box[k].lo = vmin(q.box[k].lo, q.cell.hi), q.box[k].hi = vmin(q.box[k].hi, q.cell.hi);
    }
    return q;
}

static const exam_check hidden_checks[] = {
    {1, "visits what it should", 8, true, 600, ask_moved, mark_visit_moved},
    {2, "edges, corners, planes, along axes", 13, true, 900, ask_lattice, mark_leaves},
    {3, "planes moved: once each", 7, true, 600, ask_moved, mark_count},
    {3, "edges, corners, planes, along axes", 7, true, 600, ask_lattice, mark_count},
    {4, "flat boxes, the cell's sides, one box", 17, true, 480, ask_flat, mark_cut},
};
#endif
