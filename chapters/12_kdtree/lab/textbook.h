/* textbook.h: the search as textbooks print it, and four ways in which it loses hits.
 *
 *   kdtree_hit_textbook(&t, r, &h)        compares t of the plane as it comes out; closed intervals
 *   kdtree_hit_naive_final(&t, r, &h)     the first hit found in any leaf is taken for the closest
 *   kdtree_hit_naive_strict(&t, r, &h)    one child only where the plane is passed at t = enter or
 *                                         t = exit
 *
 *   kdtree_hit_no_delta(&t, r, &h)        kdtree_hit itself with delta = 0: one t a plane, as it is
 *                                         rounded; what robustness costs
 *
 * and, with any of them, a tree built with KD_ONE: what lies in a plane is kept in one child only.
 *
 *   ray kd_dyadic_ray(&g)                 a ray for which no t of a dyadic plane is rounded
 *
 * Where they fail, on squares in dyadic planes, with such rays:
 *   final    a large polygon is in many cells: the ray meets it behind the cell at hand, and what
 *            hides it in the next cell is never asked
 *   strict   a ray through an edge where cells meet passes two planes at one t; one of the children
 *            is dropped by either plane, and with it the polygon that only it holds
 *   one      a ray that starts in the plane, or meets it at the end of its part: the child that has
 *            the polygon is the one that is not visited
 *   and with rays that are not dyadic, rounding does the same to the textbook itself.
 *
 * For rays with tmin >= 0, as textbooks have them. The whole ray is taken down the tree, not its
 * part in the box: what a box test loses is shown in 09.
 *
 * Source: V. Havran, "Heuristic Ray Shooting Algorithms", 2000, ch. 5 and app. C (TA-B).
 */
#ifndef KDTREE_TEXTBOOK_H
#define KDTREE_TEXTBOOK_H

#include "../../../common/random.h"
#include "../kdtree.h"

typedef enum { KD_CLOSED, KD_STRICT, KD_FINAL } kd_manner;
typedef struct { uint32_t node; real enter, exit; } kd_part;

/* ---------------------------------------------------------------------------------------------- */

/* One step down; what must be visited later goes to *later. True if there is such. */
static inline bool kd_textbook_step(kd_node n, vec3 o, vec3 d, kd_manner manner, kd_part *p,
                                    kd_part *later)
{
    int k = kd_axis(n);
    real at = (real)n.plane, ok = vaxis(o, k), dk = vaxis(d, k), t = (at - ok) / dk;
    uint32_t below = ok < at || (ok == at && dk > 0) ? 0 : 1;
    uint32_t near = kd_lower(n) + below, far = near ^ 1;
    bool strict = manner == KD_STRICT;
    p->node = near;
    if (t > p->exit || t < 0 || (strict && t >= p->exit)) return false;
    if (t < p->enter || (strict && t <= p->enter)) return p->node = far, false;
    *later = (kd_part){far, t > p->enter ? t : p->enter, p->exit};
    p->exit = t < p->exit ? t : p->exit;
    return true;
}

static inline bool kd_textbook(const kdtree *t, ray r, kd_manner manner, hit *out)
{
    kd_part stack[kdtree_most_depth], p = {0, r.tmin, r.tmax};
    int top = 0;
    if (t->stats.items == 0 || !ray_is_usable(r)) return false;
    query q = query_of(r);
    vec3 o = frame_into(&t->frame, r.o), d = vscale(r.d, t->frame.scale);
    for (;;) {
        kd_node n = t->node[p.node];
        while (!kd_is_leaf(n)) {
            top += kd_textbook_step(n, o, d, manner, &p, &stack[top]);
            n = t->node[p.node];
        }
        bool found = kd_ask(t, n, &q, t->x.m, false);
        if (found && manner == KD_FINAL) return query_answer(&q, out);
        do {
            if (top == 0) return query_answer(&q, out);
            p = stack[--top];
        } while (p.enter > q.r.tmax);
    }
}

/* A ray on which nothing is rounded, for a scene of dyadic coordinates within [-1,1]^3: it begins
 * at a multiple of 1/8 within [-2,2]^3, and its direction has components 0, +-1, +-2 and +-4. */
static inline ray kd_dyadic_ray(random_stream *g)
{
    ray r = ray_from((vec3){0, 0, 0}, (vec3){0, 0, 0});
    while (vzero(r.d))
        for (int k = 0; k < 3; k++) {
            uint64_t bits = random_next_bits(g);
            real size = (real)(1 << (bits >> 8 & 3)) / 2;
            ((real *)&r.o)[k] = (real)(int)(bits >> 16 & 31) / 8 - 2;
            ((real *)&r.d)[k] = size < 1 ? 0 : bits & 1 ? size : -size;
        }
    return r;
}

static inline bool kdtree_hit_textbook(const kdtree *t, ray r, hit *out)
{
    return kd_textbook(t, r, KD_CLOSED, out);
}

static inline bool kdtree_hit_naive_final(const kdtree *t, ray r, hit *out)
{
    return kd_textbook(t, r, KD_FINAL, out);
}

static inline bool kdtree_hit_naive_strict(const kdtree *t, ray r, hit *out)
{
    return kd_textbook(t, r, KD_STRICT, out);
}

static inline bool kdtree_hit_no_delta(const kdtree *t, ray r, hit *out)
{
    return t->x.m ? kd_search(t, r, 0, true, false, out, NULL)
                  : kd_search(t, r, 0, false, false, out, NULL);
}

#endif
