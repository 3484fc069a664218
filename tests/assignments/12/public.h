/* Checks of assignment 12 that the student has: brute force says what is due. */
#ifndef PUBLIC_12_H
#define PUBLIC_12_H
#include "exam.h"

/* n triangles in a cube of 6, one in eight large, and a ray through it. */
static question ask_soup(random_stream *g, int i)
{
    question q;
    memset(&q, 0, sizeof q);
    q.n = i % 7 == 0 ? 1 + i % 5 : 40 + (int)(random_next_bits(g) % 121);
    for (int k = 0; k < q.n; k++) {
        vec3 p = exam_vector(g, 3);
        double size = k % 8 == 0 ? 3 : 0.6;
        q.tri[k] = (triangle){vadd(p, exam_vector(g, size)), vadd(p, exam_vector(g, size)),
                              vadd(p, exam_vector(g, size))};
    }
    vec3 from = exam_vector(g, 8);
    q.r = ray_from(from, vsub(exam_vector(g, 2), from));
    q.most = question_leaves;
    return q;
}

/* ---- 1: the closest hit ---- */

static bool mark_closest(const answer *a, bool due, hit h, const char *who, char why[exam_why])
{
    if (due && !a->is)
        return exam_say(why, "%s says triangle %u at t = %.9g, yours none", who, h.shape, h.t);
    if (!due && a->is) return exam_say(why, "%s says none, yours triangle %u at t = %.9g", who,
                                       a->h.shape, a->h.t);
    return !due || (a->h.shape == h.shape && a->h.t == h.t && a->h.u == h.u && a->h.v == h.v)
        || exam_say(why, "%s says triangle %u at t = %.9g, yours %u at %.9g", who, h.shape, h.t,
                    a->h.shape, a->h.t);
}

static bool mark_visit(const question *q, const answer *a, char why[exam_why])
{
    first_mesh m = {(triangle *)(uintptr_t)q->tri, q->n};
    hit h = {0, 0, 0, 0};
    bool due = first_mesh_hit(&m, q->r, &h);
    return mark_closest(a, due, h, "brute force", why);
}

/* ---- 2, 3: each leaf of the tree by itself, its cell a box ---- */

typedef struct { const first_kd_node *node; real enter, exit; } passed;

/* Where the ray is in the cell; along an axis with d = 0 that is for o to say. */
static bool pass(ray r, aabb cell, real *enter, real *exit)
{
    *enter = r.tmin, *exit = r.tmax;
    for (int k = 0; k < 3; k++) {
        real o = vaxis(r.o, k), d = vaxis(r.d, k), lo = vaxis(cell.lo, k), hi = vaxis(cell.hi, k);
        if (d == 0 && !(o > lo && o <= hi)) return false;
        if (d == 0) continue;
        *enter = real_max(*enter, ((d > 0 ? lo : hi) - o) / d);
        *exit = real_min(*exit, ((d > 0 ? hi : lo) - o) / d);
    }
    return *enter <= *exit;
}

static int passed_below(const first_kd_node *node, aabb cell, ray r, passed *list, int n)
{
    if (node->child) {
        aabb below = cell, above = cell;
        real least = vaxis(cell.lo, node->axis), most = vaxis(cell.hi, node->axis);
        below.hi = first_kd_moved(cell.hi, node->axis, real_min(most, node->plane));
        above.lo = first_kd_moved(cell.lo, node->axis, real_max(least, node->plane));
        n = passed_below(&node->child[0], below, r, list, n);
        return passed_below(&node->child[1], above, r, list, n);
    }
    list[n].node = node;
    return pass(r, cell, &list[n].enter, &list[n].exit) ? n + 1 : n;
}

static int by_exit(const void *a, const void *b)
{
    real x = ((const passed *)a)->exit, y = ((const passed *)b)->exit;
    return (x > y) - (x < y);
}

static bool mark_leaves(const question *q, const answer *a, char why[exam_why])
{
    first_mesh m;
    first_kdtree t;
    question_tree(q, &m, &t);
    passed *list = allocate((size_t)t.leaves + 1, sizeof *list);
    int all = passed_below(&t.root, t.box, q->r, list, 0), n = 0;
    for (int i = 0; i < all; i++)
        if (list[i].enter < list[i].exit) list[n++] = list[i];
    qsort(list, (size_t)n, sizeof *list, by_exit);
    if (n > q->most) n = q->most;
    bool right = a->n == n
        || exam_say(why, "the cells, taken one by one: the ray passes %d leaves, yours %d", n,
                    a->n);
    for (int i = 0; i < question_leaves && right; i++) {
        int leaf = i < n ? list[i].node->number : -77;
        real exit = i < n ? list[i].exit : -77;
        right = (a->leaf[i] == leaf && a->exit[i] == exit)
            || exam_say(why, "leaf[%d] is %d, left at %.9g (-77: not written); yours %d, %.9g", i,
                        leaf, exit, a->leaf[i], a->exit[i]);
    }
    free(list), first_kdtree_free(&t), first_mesh_free(&m);
    return right;
}

/* All that is in a cell that the ray passes, once. */
static bool mark_count(const question *q, const answer *a, char why[exam_why])
{
    first_mesh m;
    first_kdtree t;
    question_tree(q, &m, &t);
    passed *list = allocate((size_t)t.leaves + 1, sizeof *list);
    bool in[question_most] = {false};
    int leaves = passed_below(&t.root, t.box, q->r, list, 0), n = 0;
    real last = -77;
    for (int i = 0; i < leaves; i++)
        for (int k = 0; k < list[i].node->n; k++) in[list[i].node->item[k]] = true;
    for (int k = 0; k < q->n; k++) {
        hit h;
        if (!in[k] || !first_triangle_hit(q->tri[k], q->r, &h)) continue;
        last = n == 0 ? h.t : real_max(last, h.t), n++;
    }
    free(list), first_kdtree_free(&t), first_mesh_free(&m);
    return (a->n == n && a->t == last)
        || exam_say(why, "%d triangles are hit, the last at t = %.9g; yours %d, %.9g (-77: not "
                    "written)", n, last, a->n, a->t);
}

/* ---- 4: the cheapest plane ---- */

static question ask_boxes(random_stream *g, int i)
{
    question q;
    memset(&q, 0, sizeof q);
    q.n = 1 + (int)(random_next_bits(g) % 40);
    q.cell = (aabb){{-4, -4, -4}, {5, 5, 5}};
    for (int k = 0; k < q.n; k++) {
        vec3 p = exam_vector(g, 4), s = vadd(exam_vector(g, 0.5), vec(0.5, 0.5, 0.5));
        q.box[k] = (aabb){p, vadd(p, s)};
    }
    q.costs = (kd_costs){exam_between(g, 0.5, 4), exam_between(g, 0.5, 2), (real)(i % 3) / 4};
    return q;
}

/* C, straight from its definition; infinite: this is no candidate. */
static real plane_cost(const question *q, int axis, real p, bool left)
{
    int below = 0, above = 0;
    bool candidate = false;
    aabb L = {q->cell.lo, first_kd_moved(q->cell.hi, axis, p)};
    aabb R = {first_kd_moved(q->cell.lo, axis, p), q->cell.hi};
    for (int j = 0; j < q->n; j++) {
        real lo = vaxis(q->box[j].lo, axis), hi = vaxis(q->box[j].hi, axis);
        bool flat = lo == p && hi == p;
        candidate = candidate || lo == p || hi == p;
        below += lo < p || (flat && left), above += hi > p || (flat && !left);
    }
    if (!candidate || p <= vaxis(q->cell.lo, axis) || p >= vaxis(q->cell.hi, axis))
        return real_infinity;
    real C = q->costs.step + q->costs.test * (aabb_area(L) * (real)below
                                              + aabb_area(R) * (real)above) / aabb_area(q->cell);
    return below && above ? C : C * (1 - q->costs.bonus);
}

static bool mark_cut(const question *q, const answer *a, char why[exam_why])
{
    real leaf = q->costs.test * (real)q->n, best = real_infinity;
    for (int j = 0; j < 12 * q->n && aabb_area(q->cell) > 0; j++) {
        int axis = j % 3;
        real p = vaxis(j / 6 % 2 ? q->box[j / 12].hi : q->box[j / 12].lo, axis);
        best = real_min(best, plane_cost(q, axis, p, j / 3 % 2));
    }
    bool tie = fabs(best - leaf) <= 1e-12 * leaf;
    if (!a->is)
        return (!(best < leaf) || tie)
                   ? (a->axis == -77 && a->plane == -77)
                         || exam_say(why, "false is due; axis and plane have to stay as they were")
                   : exam_say(why, "a cut costs %.9g, the leaf of %d boxes %.9g: yours is a leaf",
                              best, q->n, leaf);
    if (!(best < leaf) && !tie)
        return exam_say(why, "the leaf costs %.9g, the cheapest cut %.9g: false is due", leaf,
                        best);
    if (a->axis < 0 || a->axis > 2) return exam_say(why, "axis %d", a->axis);
    real cost = plane_cost(q, a->axis, a->plane, a->left);
    if (!(cost < real_infinity))
        return exam_say(why, "plane %.9g across axis %d is no candidate", a->plane, a->axis);
    return cost <= best * (real)(1 + 1e-12)
           || exam_say(why, "the cheapest cut costs %.9g, yours %.9g (axis %d, plane %.9g)", best,
                       cost, a->axis, a->plane);
}

static const exam_check public_checks[] = {
    {1, "closest hit", 7, false, 600, ask_soup, mark_visit},
    {2, "leaves on the way", 9, false, 600, ask_soup, mark_leaves},
    {3, "hits counted", 8, false, 600, ask_soup, mark_count},
    {4, "cheapest plane", 9, false, 300, ask_boxes, mark_cut},
};
#endif
