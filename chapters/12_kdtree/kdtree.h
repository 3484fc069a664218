#ifndef KDTREE_H
#define KDTREE_H
#include "build.h"
#define kdtree_defaults ((kdtree_options){KD_SAH, 4, 0, 1, 1.5, 0.2, true, KD_THICK, (size_t)4 << 30})

typedef struct { uint32_t node; float enter, exit; } kd_waiting;

__attribute__((always_inline))
static inline bool kd_ask(const kdtree *t, kd_node n, query *q, bool mesh, bool any)
{
    uint32_t count = n.rest >> 2;
    bool found = false;
    hit h;
    if (!mesh) {
        const uint32_t *i = t->index + n.first, *end = i + count;
        for (; i < end; i++) {
            if (!shape_hit_sheared(&t->x.s->shapes[*i], &q->shear, q->r, &h)) continue;
            if (any) return true;
            h.shape = *i;
            found |= query_improves(q, h);
        }
        return found;
    }
    const kd_triangle *tri = t->triangle + n.first, *end = tri + count;
    for (; tri < end; tri++) {
        const vec3 *a = t->v + tri->corner[0], *b = t->v + tri->corner[1], *c = t->v + tri->corner[2];
        if (!triangle_hit_corners(a, b, c, &q->shear, q->r, &h)) continue;
        if (any) return true;
        h.shape = tri->index;
        found |= query_improves(q, h);
    }
    return found;
}

#ifndef BRANCHY
#define BRANCHY 1
#endif

__attribute__((always_inline))
static inline bool kd_search(const kdtree *t, ray r, bool mesh, bool any, hit *out, search_work *w)
{
    kd_waiting stack[kdtree_most_depth];
    int top = 0;
    if (t->items == 0 || !ray_is_usable(r)) return false;
    query q = query_of(r);
    kd_ray k = kd_ray_of(r, &t->frame, &t->box);
    float enter = k.enter, exit = k.exit, limit = kd_ray_limit(&k, r.tmax);
    if (enter > exit) return false;
    const kd_node *node = t->node;
    kd_node n = node[0];
    for (;;) {
        while (!kd_is_leaf(n)) {
            const kd_axis *a = &k.axis[n.rest & 3];
            float t0 = (n.plane - a->o_near) * a->inverse, t1 = (n.plane - a->o_far) * a->inverse;
            uint32_t near = (n.rest >> 2) ^ a->second, far = near ^ 1;
            if (w) w->nodes++;
#if BRANCHY == 1
            if (exit < t0) n = node[near];
            else if (enter > t1) n = node[far];
            else {
                stack[top++] = (kd_waiting){far, kd_max(t0, enter), exit};
                exit = kd_min(t1, exit);
                n = node[near];
            }
#elif BRANCHY == 2
            bool before = exit < t0, after = enter > t1;
            stack[top].node = far, stack[top].enter = kd_max(t0, enter), stack[top].exit = exit;
            if (before | after) n = node[after ? far : near];
            else {
                top++;
                exit = kd_min(t1, exit);
                n = node[near];
            }
#elif BRANCHY == 4
            uint64_t na, nb, nn; memcpy(&na, &node[near], 8); memcpy(&nb, &node[far], 8);
            bool before = exit < t0, after = enter > t1, both = !(before | after);
            stack[top].node = far, stack[top].enter = kd_max(t0, enter), stack[top].exit = exit;
            top += both;
            nn = after ? nb : na;
            __asm__("" : "+r"(nn));
            memcpy(&n, &nn, 8);
            float e = kd_min(t1, exit);
            exit = after ? exit : e;
#elif BRANCHY == 5
            if (!(exit < t0 || enter > t1)) {
                stack[top++] = (kd_waiting){far, kd_max(t0, enter), exit};
                exit = kd_min(t1, exit);
                n = node[near];
            } else if (exit < t0) n = node[near];
            else n = node[far];
#elif BRANCHY == 7
            if (!(exit < t0 || enter > t1)) {
                kd_node na = node[near], nb = node[far];
                if (nb.rest == 3) { exit = kd_min(t1, exit); n = na; }
                else if (na.rest == 3) { enter = kd_max(t0, enter); n = nb; }
                else {
                stack[top++] = (kd_waiting){far, kd_max(t0, enter), exit};
                exit = kd_min(t1, exit);
                n = na; }
            } else if (exit < t0) n = node[near];
            else n = node[far];
#elif BRANCHY == 8
            if (!(exit < t0 || enter > t1)) {
                kd_node na = node[near], nb = node[far];
                stack[top] = (kd_waiting){far, kd_max(t0, enter), exit};
                bool na_e = na.rest == 3;
                top += nb.rest != 3 & !na_e;
                if (na_e) { enter = kd_max(t0, enter); n = nb; }
                else {
                exit = kd_min(t1, exit);
                n = na; }
            } else if (exit < t0) n = node[near];
            else n = node[far];
#elif BRANCHY == 6
            uint64_t na, nb, nn; memcpy(&na, &node[near], 8); memcpy(&nb, &node[far], 8);
            bool before = exit < t0, after = enter > t1;
            nn = after ? nb : na;
            __asm__("" : "+r"(nn));
            if (!(before | after)) {
                stack[top++] = (kd_waiting){far, kd_max(t0, enter), exit};
                exit = kd_min(t1, exit);
            }
            memcpy(&n, &nn, 8);
#else
            bool before = exit < t0, after = enter > t1, both = !(before | after);
            stack[top].node = far, stack[top].enter = kd_max(t0, enter), stack[top].exit = exit;
            top += both;
            n = node[after ? far : near];
            float e = kd_min(t1, exit);
            exit = after ? exit : e;
#endif
        }
        if (w) w->leaves++, w->empty += n.rest == 3, w->tests += n.rest >> 2;
        if (n.rest != 3 && kd_ask(t, n, &q, mesh, any)) {
            if (any) return true;
            limit = kd_ray_limit(&k, q.r.tmax);
        }
        do {
            if (top == 0) return query_answer(&q, out);
            top--;
        } while (stack[top].enter > limit);
        n = node[stack[top].node];
        enter = stack[top].enter, exit = kd_min(stack[top].exit, limit);
    }
}

static inline bool kdtree_hit(const kdtree *t, ray r, hit *out)
{
    return t->x.m ? kd_search(t, r, true, false, out, NULL) : kd_search(t, r, false, false, out, NULL);
}
static inline bool kdtree_hit_counted(const kdtree *t, ray r, hit *out, search_work *w)
{
    return t->x.m ? kd_search(t, r, true, false, out, w) : kd_search(t, r, false, false, out, w);
}
static inline bool kdtree_occluded(const kdtree *t, ray r)
{
    return t->x.m ? kd_search(t, r, true, true, NULL, NULL) : kd_search(t, r, false, true, NULL, NULL);
}
static inline structure_stats kdtree_stats(const kdtree *t)
{
    structure_stats s = {.references = t->references, .items = t->items, .depth = t->depth,
                         .bytes = t->bytes, .peak = t->peak};
    for (size_t i = 0; i < t->nodes; i++) {
        if (i == 1) continue;
        if (!kd_is_leaf(t->node[i])) s.inner++;
        else s.leaves++, s.empty += t->node[i].rest == 3;
    }
    return s;
}
#endif
