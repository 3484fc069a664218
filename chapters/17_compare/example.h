/* example.h: a structure of one's own, whole: boxes in boxes. n items are halved along the longest
 * side of their box until one is left. The halves of node k are nodes k + 1 and k + 2 (n / 2). */
#ifndef COMPARE_EXAMPLE_H
#define COMPARE_EXAMPLE_H
#include "../09_aabb/items.h"

typedef struct { size_t most_bytes; } example_options;
typedef struct { aabb box; uint32_t index; } example_item;
typedef struct { items x; size_t n; example_item *item; aabb *box; structure_stats stats; } example;
typedef struct { const example *e; query q; aabb_inverse i; vec3 delta; bool any; } example_query;
static int example_axis;  /* that qsort compares along */
static int example_order(const void *a, const void *b)
{
    const example_item *p = a, *q = b;
    real x = vaxis(vsub(aabb_centre(p->box), aabb_centre(q->box)), example_axis);
    return (x > 0) - (x < 0);
}
static inline void example_node(example *e, size_t k, size_t first, size_t n)
{
    e->box[k] = aabb_empty();
    for (size_t i = first; i < first + n; i++) e->box[k] = aabb_union(e->box[k], e->item[i].box);
    if (n < 2) return;
    example_axis = vlongest(vsub(e->box[k].hi, e->box[k].lo));
    qsort(e->item + first, n, sizeof *e->item, example_order);
    example_node(e, k + 1, first, n / 2);
    example_node(e, k + 2 * (n / 2), first + n / 2, n - n / 2);
}
static inline bool example_build(const items *x, example_options how, example *e, failure *f)
{
    size_t bytes = x->n * (sizeof *e->item + 2 * sizeof *e->box);
    *e = (example){.x = *x};
    if (bytes > how.most_bytes) return failed(f, 1, "%zu items do not fit", x->n);
    if (!items_all_bounds(x, &(aabb){{0, 0, 0}, {0, 0, 0}}, f)) return false;
    e->item = allocate(x->n, sizeof *e->item), e->box = allocate(2 * x->n + 1, sizeof *e->box);
    for (size_t i = 0; i < x->n; i++)
        if (items_bounds(x, i, &e->item[e->n].box)) e->item[e->n++].index = (uint32_t)i;
    e->stats = (structure_stats){e->n - (e->n > 0), e->n, 0, e->n, e->n, 0, bytes, bytes};
    example_node(e, 0, 0, e->n);
    return true;
}
static inline void example_free(example *e) { free(e->item), free(e->box), *e = (example){0}; }
static inline bool example_walk(example_query *s, size_t k, size_t at, size_t n, search_work *w)
{
    const aabb *b = &s->e->box[k], big = {vsub(b->lo, s->delta), vadd(b->hi, s->delta)};
    if (!aabb_hit_inverse(&big, &s->i, s->q.r, &(real){0})) return false;  /* big: by (10.1) */
    if (w) w->nodes += n > 1, w->tests += n == 1;
    if (n == 1) return query_ask(&s->q, &s->e->x, s->e->item[at].index, s->any);
    bool found = example_walk(s, k + 1, at, n / 2, w);
    return (found && s->any) || example_walk(s, k + 2 * (n / 2), at + n / 2, n - n / 2, w) || found;
}
static inline bool example_search(const example *e, ray r, bool any, hit *out, search_work *w)
{
    if (e->n == 0 || !ray_is_usable(r)) return false;
    real d = query_delta(r, e->box[0]) + real_epsilon * vlength(r.o);  /* lo - d is rounded */
    example_query s = {e, query_of(r), aabb_inverse_of(r), {d, d, d}, any};
    return example_walk(&s, 0, 0, e->n, w) && (any || query_answer(&s.q, out));
}
static inline structure_stats example_stats(const example *e) { return e->stats; }
STRUCTURE_VERBS(example)
#endif
