/* Checks of assignment 14 that the student has: brute force says what is due. */
#ifndef PUBLIC_14_H
#define PUBLIC_14_H
#include "exam.h"

/* n triangles of about 1 in a cube of 6, and a ray through it: most rays hit one, many two. */
static question ask_soup(random_stream *g, int i)
{
    question q;
    memset(&q, 0, sizeof q);
    q.n = i % 7 == 0 ? 1 + i % 5 : 12 + (int)(random_next_bits(g) % 37);
    for (int k = 0; k < q.n; k++) {
        vec3 p = exam_vector(g, 3);
        q.tri[k] = (triangle){vadd(p, exam_vector(g, 1.5)), vadd(p, exam_vector(g, 1.5)),
                              vadd(p, exam_vector(g, 1.5))};
    }
    vec3 from = exam_vector(g, 8);
    q.r = ray_from(from, vsub(exam_vector(g, 2), from));
    q.skip = (int)(random_next_bits(g) % (uint64_t)q.n);
    q.count = q.n;
    return q;
}

/* The two closest hits by asking all triangles; of equal t the lower number comes first. */
static int due_two(const question *q, hit best[2])
{
    int n = 0;
    for (int k = 0; k < q->n; k++) {
        hit h;
        if (!first_triangle_hit(q->tri[k], q->r, &h)) continue;
        h.shape = (uint32_t)k;
        if (n == 0 || h.t < best[0].t) best[1] = best[0], best[0] = h;
        else if (n == 1 || h.t < best[1].t) best[1] = h;
        n++;
    }
    return n < 2 ? n : 2;
}

static bool same_hit(hit a, hit b)
{
    return a.shape == b.shape && a.t == b.t && a.u == b.u && a.v == b.v;
}

static bool mark_closest(const answer *a, bool due, hit h, const char *who, char why[exam_why])
{
    if (due && !a->is)
        return exam_say(why, "%s says triangle %u at t = %.9g, yours none", who, h.shape, h.t);
    if (!due && a->is) return exam_say(why, "%s says none, yours triangle %u at t = %.9g", who,
                                       a->h[0].shape, a->h[0].t);
    return !due || same_hit(a->h[0], h)
        || exam_say(why, "%s says triangle %u at t = %.9g, yours %u at %.9g", who, h.shape, h.t,
                    a->h[0].shape, a->h[0].t);
}

static bool mark_visit(const question *q, const answer *a, char why[exam_why])
{
    hit best[2] = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    int n = due_two(q, best);
    return mark_closest(a, n > 0, best[0], "brute force", why);
}

/* S(L) n(L) + S(R) n(R), the left `left` of order[0 .. n) on one side. */
static real cut_cost(const question *q, const int *order, int n, int left)
{
    aabb side[2] = {aabb_empty(), aabb_empty()};
    for (int i = 0; i < n; i++)
        side[i >= left] = aabb_union(side[i >= left], first_triangle_box(q->tri[order[i]]));
    return aabb_area(side[0]) * (real)left + aabb_area(side[1]) * (real)(n - left);
}

static real centre_of(const question *q, int i, int axis)
{
    return vaxis(q->tri[i].a, axis) + vaxis(q->tri[i].b, axis) + vaxis(q->tri[i].c, axis);
}

/* The cheapest of 15 planes on each axis, each counted anew. Infinite: all centres in one place. */
static real due_cut(const question *q, const int *order, int n)
{
    real best = real_infinity;
    for (int axis = 0; axis < 3; axis++) {
        real lo = real_infinity, hi = -real_infinity;
        for (int i = 0; i < n; i++) {
            lo = real_min(lo, centre_of(q, order[i], axis));
            hi = real_max(hi, centre_of(q, order[i], axis));
        }
        for (int k = 1; k < 16; k++) {
            int sorted[question_most], left = 0, right = n;
            for (int i = 0; i < n; i++)
                if (centre_of(q, order[i], axis) < lo + (hi - lo) * (real)k / 16)
                    sorted[left++] = order[i];
                else sorted[--right] = order[i];
            if (left > 0 && left < n) best = real_min(best, cut_cost(q, sorted, n, left));
        }
    }
    return best;
}

static int ascending(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/* The tree's order before, as it is built; after: the same numbers, cheap, and cut by a plane. */
static bool mark_sah(const question *q, const answer *a, char why[exam_why])
{
    first_mesh m;
    first_bvh b = question_tree(q, &m);
    int before[question_most], after[question_most], n = q->count;
    memcpy(before, b.order + q->first, (size_t)n * sizeof(int));
    memcpy(after, a->order + q->first, (size_t)n * sizeof(int));
    first_bvh_free(&b), first_mesh_free(&m);
    real best = due_cut(q, before, n);
    qsort(before, (size_t)n, sizeof(int), ascending);
    qsort(after, (size_t)n, sizeof(int), ascending);
    if (memcmp(before, after, (size_t)n * sizeof(int)) != 0)
        return exam_say(why, "order[%d .. %d) has to hold the same triangles as before", q->first,
                        q->first + n);
    if (!(best < real_infinity))
        return a->n == 0 || exam_say(why, "all centres are in one place: 0 is due, yours %d", a->n);
    if (a->n < 1 || a->n >= n) return exam_say(why, "of %d triangles %d go left: no cut", n, a->n);
    if (a->axis < 0 || a->axis > 2) return exam_say(why, "axis %d", a->axis);
    const int *order = a->order + q->first;
    real cost = cut_cost(q, order, n, a->n), low = -real_infinity, high = real_infinity;
    for (int i = 0; i < n; i++)
        if (i < a->n) low = real_max(low, centre_of(q, order[i], a->axis));
        else high = real_min(high, centre_of(q, order[i], a->axis));
    if (!(low < high))
        return exam_say(why,
                        "left reaches to %g along axis %d, right from %g: that is cut "
                        "by no plane",
                        low, a->axis, high);
    return cost <= best * (real)(1 + 1e-12)
           || exam_say(why, "the cheapest cut costs %.9g, yours %.9g (%d of %d left)", best, cost,
                       a->n, n);
}

static bool mark_any(const question *q, const answer *a, char why[exam_why])
{
    hit h;
    int due = -1;
    for (int k = 0; k < q->n; k++)
        if (k != q->skip && first_triangle_hit(q->tri[k], q->r, &h)) due = k;
    if (due < 0 || a->n < 0)
        return (due < 0 && a->n == -1)
            || exam_say(why, "skip %d: brute force says %d, yours %d", q->skip, due, a->n);
    return (a->n < q->n && a->n != q->skip && first_triangle_hit(q->tri[a->n], q->r, &h))
        || exam_say(why, "skip %d: triangle %d is not hit, or is the one to skip", q->skip, a->n);
}

static bool mark_hits(const answer *a, int n, const hit best[2], const char *who,
                      char why[exam_why])
{
    if (a->n != n) return exam_say(why, "%s says %d hits, yours %d", who, n, a->n);
    for (int k = 0; k < 2; k++) {
        hit due = k < n ? best[k] : (hit){-77, -77, -77, 77};
        if (!same_hit(a->h[k], due))
            return exam_say(why,
                            "%s says %d hits, hit %d is triangle %u at t = %.9g, yours %u at %.9g",
                            who, n, k, due.shape, due.t, a->h[k].shape, a->h[k].t);
    }
    return true;
}

static bool mark_two(const question *q, const answer *a, char why[exam_why])
{
    hit best[2] = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    int n = due_two(q, best);
    return mark_hits(a, n, best, "brute force", why);
}

static question ask_boxes(random_stream *g, int i)
{
    question q;
    memset(&q, 0, sizeof q);
    q.n = 2 + (int)(random_next_bits(g) % 40);
    for (int k = 0; k < q.n; k++) {
        vec3 p = exam_vector(g, 4), s = vadd(exam_vector(g, 0.5), vec(0.5, 0.5, 0.5));
        q.box[k] = (aabb){p, vadd(p, s)};
    }
    q.costs = (sah_costs){exam_between(g, 0.5, 4), exam_between(g, 0.5, 2), 1 + i % 4};
    return q;
}

static real group_cost(sah_costs c, int n) { return c.group * ceil((real)n / (real)c.lanes); }

/* The cost of a cut, straight from its definition. */
static real sweep_cost(const question *q, const int *order, int left)
{
    aabb side[2] = {aabb_empty(), aabb_empty()};
    for (int i = 0; i < q->n; i++) side[i >= left] = aabb_union(side[i >= left], q->box[order[i]]);
    real S = aabb_area(aabb_union(side[0], side[1]));
    return q->costs.box + (aabb_area(side[0]) * group_cost(q->costs, left)
                           + aabb_area(side[1]) * group_cost(q->costs, q->n - left)) / S;
}

static real box_centre(const question *q, int i, int axis)
{
    return vaxis(q->box[i].lo, axis) + vaxis(q->box[i].hi, axis);
}

/* Box i comes before box j along the axis. */
static bool box_before(const question *q, int i, int j, int axis)
{
    real a = box_centre(q, i, axis), b = box_centre(q, j, axis);
    return a < b || (a == b && i < j);
}

/* Each box has as many boxes before it as its place says. */
static void sorted_boxes(const question *q, int axis, int *order)
{
    for (int i = 0; i < q->n; i++) {
        int place = 0;
        for (int j = 0; j < q->n; j++) place += box_before(q, j, i, axis);
        order[place] = i;
    }
}

static bool mark_sweep(const question *q, const answer *a, char why[exam_why])
{
    int order[question_most];
    real leaf = group_cost(q->costs, q->n), best = real_infinity;
    for (int axis = 0; axis < 3; axis++) {
        sorted_boxes(q, axis, order);
        for (int k = 1; k < q->n; k++) best = real_min(best, sweep_cost(q, order, k));
    }
    bool tie = fabs(best - leaf) <= 1e-12 * leaf;
    if (a->n == 0)
        return !(best < leaf) || tie
               || exam_say(why, "a cut costs %.9g, the leaf of %d boxes %.9g: yours is a leaf",
                           best, q->n, leaf);
    if (!(best < leaf) && !tie)
        return exam_say(why, "the leaf costs %.9g, the cheapest cut %.9g: 0 is due, yours %d", leaf,
                        best, a->n);
    if (a->n < 0 || a->n >= q->n || a->axis < 0 || a->axis > 2)
        return exam_say(why, "%d of %d boxes go left, axis %d: no cut", a->n, q->n, a->axis);
    sorted_boxes(q, a->axis, order);
    if (memcmp(order, a->order, (size_t)q->n * sizeof(int)) != 0)
        return exam_say(why, "order[] is not sorted by centre (then by number) along axis %d",
                        a->axis);
    real cost = sweep_cost(q, order, a->n);
    return cost <= best * (real)(1 + 1e-12)
           || exam_say(why, "the cheapest cut costs %.9g, yours %.9g (axis %d, %d of %d left)",
                       best, cost, a->axis, a->n, q->n);
}

static const exam_check public_checks[] = {
    {1, "closest hit", 7, false, 800, ask_soup, mark_visit},
    {2, "cheapest plane", 8, false, 300, ask_soup, mark_sah},
    {3, "any hit", 6, false, 800, ask_soup, mark_any},
    {4, "two closest hits", 8, false, 800, ask_soup, mark_two},
    {5, "cheapest cut", 8, false, 300, ask_boxes, mark_sweep},
};
#endif
