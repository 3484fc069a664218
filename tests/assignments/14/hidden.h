/* Checks of assignment 14 that the student does not have: hard cases. Included after public.h. */
#ifndef HIDDEN_14_H
#define HIDDEN_14_H

/* Trees whose boxes were moved: triangles are found only by the way that a search should take. They
 * are larger, so that there is much to find. */
static question ask_moved_by(random_stream *g, int i, double size)
{
    question q = ask_soup(g, 7 * i + 1 + i % 6);
    q.n = question_most;
    for (int k = 0; k < q.n; k++) {
        vec3 p = exam_vector(g, 2);
        q.tri[k] = (triangle){vadd(p, exam_vector(g, size)), vadd(p, exam_vector(g, size)),
                              vadd(p, exam_vector(g, size))};
    }
    q.moved = random_next_bits(g) | 1;
    q.skip = (int)(random_next_bits(g) % (uint64_t)q.n);
    if (i % 4 == 3) q.r.tmax = exam_between(g, 0.5, 1);
    return q;
}

static question ask_moved(random_stream *g, int i) { return ask_moved_by(g, i, 3); }
static question ask_moved_large(random_stream *g, int i) { return ask_moved_by(g, i, 5); }

/* The search with a stack of nodes that are still to be looked at: keeps the `most` closest hits (1
 * or 2). most = 0: stops at the first, left child first, without triangle `skip`. */
static int due_search(const question *q, int most, int skip, hit best[2])
{
    first_mesh m;
    first_bvh b = question_tree(q, &m);
    int stack[2 * question_most + 2] = {0}, top = 1, n = 0;
    while (top > 0) {
        const first_bvh_node *node = &b.node[stack[--top]];
        real t_enter, far = most > 0 && n == most ? best[n - 1].t : q->r.tmax;
        if (!first_aabb_hit(node->box, q->r, &t_enter) || t_enter > far) continue;
        if (node->left != 0) {
            bool right_first = most > 0 && vaxis(q->r.d, node->axis) < 0;
            stack[top++] = right_first ? node->left : node->right;
            stack[top++] = right_first ? node->right : node->left;
            continue;
        }
        for (int k = node->first; k < node->first + node->n; k++) {
            hit h;
            if (b.order[k] == skip || !first_triangle_hit(m.tri[b.order[k]], q->r, &h)) continue;
            h.shape = (uint32_t)b.order[k];
            if (most == 0) { best[0] = h, n = 1, top = 0; break; }
            if (n == 0 || h.t < best[0].t) best[1] = best[0], best[0] = h, n += n < most;
            else if (most == 2 && (n == 1 || h.t < best[1].t)) best[1] = h, n = 2;
        }
    }
    first_bvh_free(&b), first_mesh_free(&m);
    return n;
}

static bool mark_visit_moved(const question *q, const answer *a, char why[exam_why])
{
    hit best[2] = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    int n = due_search(q, 1, -1, best);
    return mark_closest(a, n > 0, best[0],
                        "boxes do not hold their triangles; a search that leaves out "
                        "what it should, nearer child first,",
                        why);
}

static bool mark_any_moved(const question *q, const answer *a, char why[exam_why])
{
    hit best[2] = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    int n = due_search(q, 0, q->skip, best), due = n > 0 ? (int)best[0].shape : -1;
    return a->n == due
           || exam_say(
               why,
               "boxes do not hold their triangles: a search that asks what it should, in the "
               "right order, says %d, yours %d",
               due, a->n);
}

static bool mark_two_moved(const question *q, const answer *a, char why[exam_why])
{
    hit best[2] = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    int n = due_search(q, 2, -1, best);
    return mark_hits(a, n, best,
                     "boxes do not hold their triangles; a search that leaves out what it "
                     "should, nearer child first,",
                     why);
}

/* A part of the triangles; all in one place; all in a plane; two. */
static question ask_parts(random_stream *g, int i)
{
    question q = ask_soup(g, 7 * i + 1 + i % 6);
    q.first = q.n / 3, q.count = q.n / 2;
    if (i % 4 == 1) q.count = 2;
    for (int k = 0; k < q.n && i % 4 >= 2; k++) {
        triangle *t = &q.tri[k];
        if (i % 4 == 2) *t = (triangle){{1, 2, 3}, {4, 2, 3}, {1, 5, 3}};
        else t->a.z = t->b.z = t->c.z = 1;
    }
    return q;
}

/* The same triangle twice, with another number: both count. And intervals that leave out hits. */
static question ask_doubles(random_stream *g, int i)
{
    question q = ask_soup(g, 7 * i + 1 + i % 6);
    for (int k = 0; k + 1 < q.n; k += 2) {
        int other = (int)(random_next_bits(g) % (uint64_t)q.n);
        if (i % 2) q.tri[other] = q.tri[k];
    }
    hit best[2] = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    int n = due_two(&q, best);
    if (n == 2 && i % 3 == 1) q.r.tmin = (best[0].t + best[1].t) / 2;
    if (n == 2 && i % 3 == 2) q.r.tmax = (best[0].t + best[1].t) / 2;
    return q;
}

/* Whole numbers, many of them the same place; flat boxes; one box; all of them flat in one plane or
 * on a line, where S(N) may be 0. */
static question ask_boxes_odd(random_stream *g, int i)
{
    question q = ask_boxes(g, i);
    if (i % 6 == 0) q.n = 1;
    for (int k = 0; k < q.n; k++) {
        int x = (int)(random_next_bits(g) % 4), y = (int)(random_next_bits(g) % 4);
        int size = (int)(random_next_bits(g) % 3);
        q.box[k] = (aabb){{(real)x, (real)y, 2}, {(real)(x + size), (real)(y + size), 3}};
        if (i % 6 == 1) q.box[k].hi.z = 2;
        if (i % 6 == 2) q.box[k] = (aabb){{(real)x, 0, 0}, {(real)(x + size), 0, 0}};
        if (i % 6 == 3) q.box[k] = (aabb){{1, 1, 1}, {2, 2, 2}};
    }
    q.costs.lanes = 1 + i % 9;
    return q;
}

static bool mark_sweep_odd(const question *q, const answer *a, char why[exam_why])
{
    aabb all = aabb_empty();
    for (int i = 0; i < q->n; i++) all = aabb_union(all, q->box[i]);
    if (aabb_area(all) > 0) return mark_sweep(q, a, why);
    return (a->n == 0 && a->axis == -77 && a->order[0] == -77)
           || exam_say(why,
                       "the box of all has no surface: 0 is due, nothing else written; yours %d",
                       a->n);
}

static const exam_check hidden_checks[] = {
    {1, "leaves out what it should", 8, true, 600, ask_moved, mark_visit_moved},
    {2, "parts, one place, one plane", 7, true, 300, ask_parts, mark_sah},
    {3, "stops, skips, in order", 9, true, 600, ask_moved, mark_any_moved},
    {4, "equal t, intervals", 6, true, 600, ask_doubles, mark_two},
    {4, "leaves out what it should", 6, true, 1200, ask_moved_large, mark_two_moved},
    {5, "flat, same place, one box, lanes", 12, true, 360, ask_boxes_odd, mark_sweep_odd},
};
#endif
