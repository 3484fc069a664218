/* painter.h: the painter's algorithm (画家算法): back to front, each over what is behind it, from any
 * eye: what BSP trees were made for.
 *
 *        plane of P            An eye in front of the plane of P sees what lies behind it first
 *   back    |    front         covered: draw the back, then P, then the front. And so on, in both
 *           P     .eye         halves. What the plane cuts is cut into two pieces (碎片).    (13.5)
 *
 *   painter p;
 *   bool painter_build(&m, painter_defaults, &p, &f)   false: too many pieces, no candidates
 *   size_t n = painter_order(&p, eye, order)           all pieces, farthest first; order[p.pieces]
 *   painter_free(&p)                                   a zeroed one may be freed
 *
 *   p.piece[k]      a fragment (fragment.h) of triangle `item`, its corners in p.w
 *   how.rule        PAINTER_FIRST: planes in the order of the mesh; RANDOM; FEWEST: of `candidates`
 *   how.candidates  drawn, the one that cuts the fewest [>= 1]
 *   how.most        pieces; more, and painter_build fails (exit code 2)
 *
 * The tree is built once and serves every eye: O(pieces) an order, no sorting, no depths. Sorting
 * by distance cannot do it: three triangles, each over the next, have no order at all until one is
 * cut; and a long one beside a short one has its middle in the wrong place.
 *
 * A piece within 64 eps size of a plane is in it and drawn with it: corners may be 6 eps off their
 * own plane (side.h), and each cut on the way adds 2.6. Triangles that lie closer than that over
 * each other have no order. Those without area or with a NaN are no pieces at all. The mesh may be
 * up to real_largest / 2 wide.
 *
 * How many pieces? Paterson & Yao: n triangles can force n^2 (two crossing rows of walls do); n
 * walls that do not cross, in random order, make on average at most n + 2 n ln n           (13.6)
 * since wall j is cut by the plane of i only if i comes before all walls between them.
 *
 * Sources: H. Fuchs, Z. Kedem, B. Naylor, SIGGRAPH 1980; R. Schumacker et al., "Study for Applying
 * Computer-Generated Images to Visual Simulation", AFHRL-TR-69-14, 1969 (the idea); M. Paterson,
 * F. Yao 1990 (see choose.h).
 */
#ifndef BSP_PAINTER_H
#define BSP_PAINTER_H

#include "../../common/random.h"
#include "fragment.h"

typedef enum { PAINTER_FIRST, PAINTER_RANDOM, PAINTER_FEWEST, painter_rules } painter_rule;
typedef struct { painter_rule rule; int candidates; uint64_t seed; size_t most; } painter_options;
#define painter_defaults ((painter_options){PAINTER_FEWEST, 16, 1, 10000000})

typedef struct { split_plane p; uint32_t back, front, piece, pieces; } painter_node;
typedef struct {
    workshop w;            /* corners and planes are in its coordinates */
    fragment *piece;       /* those in one plane in a row */
    painter_node *node;    /* back, front: UINT32_MAX for none; the root is node 0 */
    size_t pieces, nodes, piece_room, node_room;
} painter;

/* ---------------------------------------------------------------------------------------------- */

/* What is still to be put into nodes below one side of a node: the last n fragments of the
 * workshop; before them lie those of the next list on the stack. */
typedef struct { size_t n; uint32_t parent; bool front; } painter_list;

typedef struct {
    painter *p;
    painter_options how;
    painter_list *stack;
    size_t lists, room;
    random_stream g;
} painter_builder;

static inline void painter_free(painter *p)
{
    free(p->w.corner), free(p->w.f), free(p->piece), free(p->node);
    *p = (painter){0};
}

/* Of n fragments from f on: the number of the one whose plane is taken. */
static inline size_t painter_choose(painter_builder *b, const fragment *f, size_t n,
                                    split_plane *out)
{
    const workshop *w = &b->p->w;
    size_t fewest = SIZE_MAX, which = 0;
    int tries = b->how.rule == PAINTER_FEWEST ? b->how.candidates : 1;
    for (int k = 0; k < tries && fewest > 0; k++) {
        size_t i = b->how.rule == PAINTER_FIRST ? 0 : (size_t)(random_next_bits(&b->g) % n);
        split_plane p;
        size_t cuts = 0;
        fragment_plane(w, &f[i], 3, &p);
        for (size_t j = 0; tries > 1 && j < n; j++)
            cuts += fragment_side(w, &p, &f[j]) == SIDE_BOTH;
        if (cuts < fewest) fewest = cuts, *out = p, which = i;
    }
    return which;
}

/* What of the list lies on one side of node `at` becomes a list on top. */
static inline void painter_part(painter_builder *b, size_t begin, size_t n, size_t which,
                                uint32_t at, plane_side wanted)
{
    workshop *w = &b->p->w;
    const split_plane p = b->p->node[at].p;
    size_t before = w->fragments;
    for (size_t i = begin; i < begin + n; i++) {
        fragment f = w->f[i];
        plane_side s = i == which ? SIDE_ON : fragment_side(w, &p, &f);
        if (s == wanted) workshop_push(w, f);
        if (s == SIDE_BOTH) fragment_half(w, &p, wanted == SIDE_FRONT ? -1 : 1, f);
    }
    b->stack = grown(b->stack, b->lists, &b->room, sizeof *b->stack);
    b->stack[b->lists++] = (painter_list){w->fragments - before, at, wanted == SIDE_FRONT};
}

/* A node of the list on top: what lies in its plane is drawn with it; both sides wait, the smaller
 * one on top, so that no more than log2 n lists wait below it. */
static inline void painter_make(painter_builder *b, painter_list l)
{
    painter *t = b->p;
    workshop *w = &t->w;
    split_plane p = {0};
    size_t begin = w->fragments - l.n, back = 0, front = 0;
    size_t which = begin + painter_choose(b, w->f + begin, l.n, &p);
    uint32_t at = (uint32_t)t->nodes;
    t->node = grown(t->node, t->nodes++, &t->node_room, sizeof *t->node);
    t->node[at] = (painter_node){p, UINT32_MAX, UINT32_MAX, (uint32_t)t->pieces, 0};
    if (at) *(l.front ? &t->node[l.parent].front : &t->node[l.parent].back) = at;
    for (size_t i = begin; i < begin + l.n; i++) {
        plane_side s = i == which ? SIDE_ON : fragment_side(w, &p, &w->f[i]);
        back += s & 1, front += s >> 1;
        if (s != SIDE_ON) continue;
        t->piece = grown(t->piece, t->pieces, &t->piece_room, sizeof *t->piece);
        t->piece[t->pieces++] = w->f[i];
    }
    t->node[at].pieces = (uint32_t)t->pieces - t->node[at].piece;
    painter_part(b, begin, l.n, which, at, front > back ? SIDE_FRONT : SIDE_BACK);
    painter_part(b, begin, l.n, which, at, front > back ? SIDE_BACK : SIDE_FRONT);
    w->fragments -= l.n;
    memmove(w->f + begin, w->f + begin + l.n, (w->fragments - begin) * sizeof *w->f);
}

/* All triangles that have an area; cut at the planes themselves. */
static inline void painter_begin(painter *out, const items *x)
{
    workshop *w = &out->w;
    vec3 lo, hi;
    split_plane p;
    fragment f;
    *w = (workshop){.x = x, .sides = BSP_SIDES_STRICT};
    if (!mesh_bounds(x->m, &lo, &hi)) return;
    real size = vlargest(vsub(hi, lo));
    w->middle = vmadd(vscale(lo, 0.5), hi, 0.5), w->scale = power_above(size);
    w->e = 64 * real_epsilon * (size / w->scale);
    for (size_t i = 0; i < x->n; i++)
        if (fragment_of(w, (uint32_t)i, &f) && fragment_plane(w, &f, 3, &p)) workshop_push(w, f);
}

static inline bool painter_build(const mesh *m, painter_options how, painter *out, failure *f)
{
    const items x = items_of_mesh(m);
    painter_builder b = {.p = out, .how = how, .g = random_start(how.seed, 0, 0)};
    *out = (painter){0};
    if (how.candidates < 1)
        return failed(f, 2, "painter: %d candidates; 1 or more are needed", how.candidates);
    painter_begin(out, &x);
    bool full = out->w.fragments > how.most;
    if (out->w.fragments && !full) painter_make(&b, (painter_list){out->w.fragments, 0, false});
    while (b.lists > 0 && !full) {
        painter_list l = b.stack[--b.lists];
        if (l.n) painter_make(&b, l);
        full = out->w.fragments + out->pieces > how.most;
    }
    free(b.stack);
    out->w.x = NULL;
    if (!full) return true;
    painter_free(out);
    return failed(f, 2, "%zu triangles: cut into more than %zu pieces", m->triangles, how.most);
}

/* Back, own plane, front, as the eye sees them. A stack of its own, as the tree may be as deep as
 * there are triangles. An eye in the plane sees its pieces edge-on: any order will do. */
static inline size_t painter_order(const painter *p, vec3 eye, uint32_t *order)
{
    uint32_t *stack = allocate(p->nodes + 1, sizeof *stack), at = p->nodes ? 0 : UINT32_MAX;
    size_t top = 0, n = 0;
    vec3 e = workshop_place(&p->w, eye);
    for (;;) {
        while (at != UINT32_MAX) {  /* down the far side */
            stack[top++] = at;
            bool front = side_of(&p->node[at].p, e) > 0;
            at = front ? p->node[at].back : p->node[at].front;
        }
        if (top == 0) break;
        const painter_node *x = &p->node[stack[--top]];
        for (uint32_t k = 0; k < x->pieces; k++) order[n++] = x->piece + k;
        at = side_of(&x->p, e) > 0 ? x->front : x->back;
    }
    free(stack);
    return n;
}

#endif
